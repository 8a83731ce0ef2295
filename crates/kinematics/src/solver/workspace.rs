//! Holds the memory in which states are solved, separate from the states themselves.

use super::bounds::Errors;
use super::coupled::Scratch;
use super::state::State;
use crate::{Double, Number};
use std::ops::Deref;

/// The memory for solving, created once for a solver: the most recent state and scratch memory.
///
/// It dereferences to its state. Use [`Workspace::state`] to clone a state that is kept, compared
/// or sent elsewhere.
#[derive(Debug)]
pub struct Workspace<T = f64> {
    pub(super) state: State<T>,
    /// The scratch memory of the coupled groups.
    pub(super) scratch: Scratch<T>,
    /// The error analysis of the state, if requested.
    pub(super) errors: Errors,
    /// The state of steps run in double-double, where doubles do not suffice.
    pub(super) close: Option<Box<State<Double>>>,
}

impl<T: Copy> Clone for Workspace<T> {
    fn clone(&self) -> Workspace<T> {
        Workspace {
            state: self.state.clone(),
            scratch: self.scratch.clone(),
            errors: self.errors.clone(),
            close: self.close.clone(),
        }
    }

    /// Copies a workspace without allocating memory for the state again.
    fn clone_from(&mut self, other: &Workspace<T>) {
        let Workspace {
            state,
            scratch,
            errors,
            close,
        } = self;
        state.clone_from(&other.state);
        scratch.clone_from(&other.scratch);
        errors.clone_from(&other.errors);
        close.clone_from(&other.close);
    }
}

impl<T> Workspace<T> {
    /// Returns the most recent state.
    #[must_use]
    pub fn state(&self) -> &State<T> {
        &self.state
    }

    /// Returns the most recent state without the scratch memory.
    #[must_use]
    pub fn into_state(self) -> State<T> {
        self.state
    }
}

impl<T: Number> Workspace<T> {
    /// Creates a workspace for a state alone.
    pub(super) fn new(state: State<T>, scratch: Scratch<T>) -> Workspace<T> {
        Workspace {
            state,
            scratch,
            errors: Errors::default(),
            close: None,
        }
    }
}

impl<T> Deref for Workspace<T> {
    type Target = State<T>;

    fn deref(&self) -> &State<T> {
        &self.state
    }
}
