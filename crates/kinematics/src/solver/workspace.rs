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
#[derive(Clone, Debug)]
pub struct Workspace<T = f64> {
    pub(super) state: State<T>,
    /// The scratch memory of the coupled groups.
    pub(super) scratch: Scratch<T>,
    /// The error analysis of the state, if requested.
    pub(super) errors: Errors,
    /// The state of steps run in double-double, where doubles do not suffice.
    pub(super) close: Option<Box<State<Double>>>,
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
