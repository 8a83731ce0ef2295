//! The room in which states are found, apart from the states.

use super::bounds::Errors;
use super::coupled::Scratch;
use super::state::State;
use crate::{Double, Number};
use std::ops::Deref;

/// Room to solve in, made once for a solver: the state that was found last, and what finding it
/// takes besides.
///
/// It reads like its state. A state that is to be kept, compared or sent elsewhere is taken from it, as
/// a value of its own: [`Workspace::state`].
#[derive(Clone, Debug)]
pub struct Workspace<T = f64> {
    pub(super) state: State<T>,
    /// Of the coupled groups.
    pub(super) scratch: Scratch<T>,
    /// What is known of the errors of the state, where these are looked for.
    pub(super) errors: Errors,
    /// For steps that are run in twice the digits, where doubles do not tell.
    pub(super) close: Option<Box<State<Double>>>,
}

impl<T> Workspace<T> {
    /// The state that was found last.
    #[must_use]
    pub fn state(&self) -> &State<T> {
        &self.state
    }

    /// The state that was found last, without the room.
    #[must_use]
    pub fn into_state(self) -> State<T> {
        self.state
    }
}

impl<T: Number> Workspace<T> {
    /// Room for a state alone.
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
