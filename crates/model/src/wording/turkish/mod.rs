//! Turkish messages, with the terms of a course on machine dynamics.
//!
//! A link is an `uzuv`, a joint a `mafsal`, the frame the `şase`, an assembly a `montaj biçimi`. A
//! loop and a cycle are both a `döngü`, a dyad is an `ikili grup`, a coupled group a `bağlaşık
//! grup`. Typed text (options, keys, names of columns and actions) is not translated. Inserted
//! names get no suffix. Sentences use the polite imperative (`yazın`); labels of one to three words
//! use the plain form (`kaydet`).

mod actions;
mod check;
mod commands;
mod configuration;
mod cycles;
mod designs;
mod driver_motion;
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
mod help;
mod hints;
mod imports;
mod loads;
mod manual;
mod methods;
mod motion;
mod motors;
mod options;
mod parser;
mod parts;
mod plots;
mod presets;
mod reactions;
mod reading;
mod recovery;
mod reporting;
mod scene_keys;
mod scene_picker;
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
