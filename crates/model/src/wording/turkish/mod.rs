//! Turkish messages, with the terms of a course on machine dynamics.
//!
//! A link is an `uzuv`, a joint a `mafsal`, the frame the `şase`, an assembly a `montaj biçimi`. A
//! loop and a cycle are both a `döngü`, a dyad is an `ikili grup`, a coupled group a `bağlaşık
//! grup`. Typed text (options, keys, names of columns and actions) is not translated. Inserted
//! names get no suffix. Sentences use the polite imperative (`yazın`); labels of one to three words
//! use the plain form (`kaydet`).

mod acting;
mod actions;
mod checking;
mod commands;
mod configuration;
mod courses;
mod cycles;
mod designs;
mod editing;
mod errors;
mod examples;
mod exercises;
mod exports;
mod faults;
mod figures;
mod files;
mod forces;
mod formulas;
mod helping;
mod hints;
mod imports;
mod manual;
mod methods;
mod motion;
mod motors;
mod offering;
mod options;
mod parser;
mod parts;
mod picking;
mod plots;
mod presets;
mod reactions;
mod reading;
mod reporting;
mod scene_keys;
mod syntax;
mod tasks;
mod terminals;
mod tolerances;
mod tour;
mod views;
mod working;

/// Turkish, the language of the lectures that krank implements.
#[derive(Debug)]
pub(super) struct Turkish;
