//! Compares the solver with closed forms, values to 25 digits and double-double arithmetic:
//! positions, rates, assemblies, forces, bounds, and their dependence on lengths.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "../exact/mod.rs"]
mod exact;
#[path = "../support/typed.rs"]
mod typed;

mod assemblies;
mod bounds;
mod coupled_assemblies;
mod derived;
mod elbows;
mod forces;
mod input_tables;
mod inputs;
mod polar;
mod reference;
mod sensitivity;
mod states;
mod stops;
mod thin;
mod typed_lengths;
