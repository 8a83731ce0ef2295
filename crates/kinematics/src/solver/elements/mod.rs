#![doc = include_str!("../../guide/elements.md")]
//!
//! # In the source
//!
//! A file for each element; the table [`elements!`] lists them all. A new element is its file, a line there,
//! and its recognition in a block of unknowns ([`super::chain`]); a dyad with two assemblies is also one of
//! [`Dyad`], has a class in [`super::plan`], and says at its recognition through which slide and over which links
//! it holds its joint.

mod aim;
mod arm;
mod circle_line;
mod circle_rail;
mod circles;
mod crank;
mod cylinder;
mod dyad;
mod elbow;
mod line;
mod lines;
mod lock;
mod push;
mod ride;
mod slide_readout;
mod stretching;
mod swing;
mod through;
mod timed;

pub(super) use aim::Aim;
pub(super) use arm::Arm;
pub(super) use circle_line::CircleLine;
pub(super) use circle_rail::CircleRail;
pub(super) use circles::Circles;
pub(super) use crank::{Crank, Spin};
pub(super) use cylinder::Cylinder;
pub(super) use dyad::Dyad;
pub(super) use elbow::Elbow;
pub(super) use line::GuideLine;
pub(super) use lines::Lines;
pub(super) use lock::Lock;
pub(super) use push::Push;
pub(super) use ride::Ride;
pub(super) use slide_readout::SlideReadout;
pub(super) use stretching::{FRAMES, RelativeMotion, Stretching, settled, sum};
pub(super) use swing::Swing;
pub(super) use through::{Height, Snap, ZERO, root};
pub(super) use timed::Timed;

use super::coupled::Coupled;
use super::demand::PlacedPart;
use super::forces::{ForceState, Site};
use super::state::State;
use super::transmission::{InnerJoint, Ray};
use crate::{Constant, Number, Vec2};
use dyad::{TwoAssemblies, triangle_reserve};

/// How many derivatives a solve carries, as a constant of the compiled code.
pub(super) const POSITION: u8 = 0;
pub(super) const VELOCITY: u8 = 1;
pub(super) const ACCELERATION: u8 = 2;

/// How far beyond its reach a group still counts as just stretched: 4 u of the lengths, the
/// rounding of a computed distance. Less would refuse limits that were typed in exactly; more would
/// clamp states that really are open.
pub(super) const REACH_SLACK: f64 = 4.0 * 0.5 * f64::EPSILON;

/// What became of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum StepOutcome {
    /// Solved.
    Done,
    /// So close to its limit that rounding decides: [`Dyad::stretch`] looks closer.
    Unclear,
    /// Stretched to its limit: positions are given, derivatives do not exist.
    Stretched,
    /// Cannot close.
    Open,
}

/// What an element tells of itself.
pub(super) trait Element {
    /// Whether most mechanisms have it: then it is run in place.
    const IS_FREQUENT: bool = false;

    /// Whether its residuals tell its errors (see `bounds`); else it is run once more in twice the digits.
    const HAS_RESIDUALS: bool = false;

    /// The same backwards.
    type Back: Backwards;

    /// Says of everything that it places that it does.
    fn outputs(&self, places: &mut impl FnMut(PlacedPart));

    /// Says of everything that it reads that it does.
    fn inputs(&self, reads: &mut impl FnMut(PlacedPart));

    /// Places what it places at the driver's coordinate `q`; `direction` is its unit vector where it is an
    /// angle.
    fn run<T: Number, const ORDER: u8>(
        &self,
        q: T,
        direction: Vec2<T>,
        state: &mut State<T>,
    ) -> StepOutcome;

    /// Hands out every place that it was made of, always in the same order, and follows what becomes of it.
    fn vary(&mut self, _place: &mut impl FnMut(&mut Vec2<Constant>)) {}

    /// The way backwards at its site; `None` where nothing comes back.
    fn back(&self, site: &Site<'_>) -> Option<Self::Back>;

    /// The dyad with two assemblies, if it is one.
    fn dyad(&self) -> Option<Dyad<'_>> {
        None
    }

    /// The two lines at its inner joint, between which its transmission angle lies.
    fn rays(&self, _state: &State) -> Option<[Ray; 2]> {
        None
    }

    /// That joint, if it has one.
    fn inner_joint(&self) -> Option<InnerJoint> {
        None
    }
}

/// An element, run backwards.
pub(super) trait Backwards {
    /// Hands what has come to what it placed down to what it stands on, and notes what passes there.
    fn run<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>);
}

/// No way backwards.
#[derive(Clone, Debug)]
pub(super) enum Nothing {}

impl Backwards for Nothing {
    fn run<T: Number>(&self, _state: &State<T>, _forces: &mut ForceState<T>) {
        match *self {}
    }
}

// Twice the size would be aligned to as much, and could lie across the end of a page again.
const _: () = assert!(size_of::<Step>() == 512);

macro_rules! elements {
    ($($name:ident),+ $(,)?) => {
        /// One element of a plan. It never lies across the end of a page of memory: some processors take as long for
        /// reading there as for a whole state.
        #[derive(Clone, Debug)]
        #[repr(align(512))]
        pub(super) enum Step {
            $($name($name),)+
            /// A coupled group, by its number.
            Coupled { index: usize },
        }

        /// One element backwards.
        #[derive(Clone, Debug)]
        pub(super) enum Pass {
            $($name(<$name as Element>::Back),)+
            /// A coupled group, by its number.
            Coupled { index: usize },
        }

        $(impl From<$name> for Step {
            fn from(element: $name) -> Step {
                Step::$name(element)
            }
        })+

        impl Step {
            /// See [`Element::run`].
            #[inline(always)]
            pub(super) fn run<T: Number, const ORDER: u8>(
                &self,
                q: T,
                direction: Vec2<T>,
                state: &mut State<T>,
            ) -> StepOutcome {
                match self {
                    $(Step::$name(element) => element.run::<T, ORDER>(q, direction, state),)+
                    // Coupled groups are run by the solver, which owns them.
                    Step::Coupled { .. } => StepOutcome::Done,
                }
            }

            /// The same, of those that most mechanisms have.
            #[inline(always)]
            pub(super) fn run_frequent<T: Number, const ORDER: u8>(
                &self,
                q: T,
                direction: Vec2<T>,
                state: &mut State<T>,
            ) -> Option<StepOutcome> {
                match self {
                    $(Step::$name(element) if $name::IS_FREQUENT => {
                        Some(element.run::<T, ORDER>(q, direction, state))
                    })+
                    _ => None,
                }
            }

            /// See [`Element::HAS_RESIDUALS`].
            pub(super) fn has_residuals(&self) -> bool {
                match self {
                    $(Step::$name(_) => $name::HAS_RESIDUALS,)+
                    Step::Coupled { .. } => false,
                }
            }

            /// The dyad with two assemblies, if it is one.
            pub(super) fn dyad(&self) -> Option<Dyad<'_>> {
                match self {
                    $(Step::$name(element) => element.dyad(),)+
                    Step::Coupled { .. } => None,
                }
            }

            /// The lines between which its transmission angle lies.
            pub(super) fn rays(&self, state: &State) -> Option<[Ray; 2]> {
                match self {
                    $(Step::$name(element) => element.rays(state),)+
                    Step::Coupled { .. } => None,
                }
            }

            /// The joint with a transmission angle, if it has one.
            pub(super) fn inner_joint(&self) -> Option<InnerJoint> {
                match self {
                    $(Step::$name(element) => element.inner_joint(),)+
                    Step::Coupled { .. } => None,
                }
            }

            /// Says of everything that it places that it does.
            pub(super) fn outputs(&self, coupled: &[Coupled], places: &mut impl FnMut(PlacedPart)) {
                match self {
                    $(Step::$name(element) => element.outputs(places),)+
                    Step::Coupled { index } => coupled[*index].outputs(places),
                }
            }

            /// Says of everything that it reads that it does.
            pub(super) fn inputs(&self, coupled: &[Coupled], reads: &mut impl FnMut(PlacedPart)) {
                match self {
                    $(Step::$name(element) => element.inputs(reads),)+
                    Step::Coupled { index } => coupled[*index].reads(reads),
                }
            }

            /// See [`Element::vary`].
            pub(super) fn vary(
                &mut self,
                coupled: &mut [Coupled],
                place: &mut impl FnMut(&mut Vec2<Constant>),
            ) {
                match self {
                    $(Step::$name(element) => element.vary(place),)+
                    Step::Coupled { index } => coupled[*index].vary(place),
                }
            }

            /// The way backwards at its site.
            pub(super) fn back(&self, site: &Site<'_>) -> Option<Pass> {
                match self {
                    $(Step::$name(element) => element.back(site).map(Pass::$name),)+
                    Step::Coupled { index } => Some(Pass::Coupled { index: *index }),
                }
            }
        }

        impl Pass {
            /// See [`Backwards::run`].
            #[inline(always)]
            pub(super) fn run<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>) {
                match self {
                    $(Pass::$name(back) => back.run(state, forces),)+
                    // Coupled groups are run by the engine, which owns them.
                    Pass::Coupled { .. } => {}
                }
            }
        }
    };
}

elements! {
    Crank, Spin, Timed, Elbow, Ride, Push, Aim, Lock,
    Circles, CircleLine, CircleRail, Swing, Cylinder, Lines,
    SlideReadout,
}

impl Step {
    /// The number of the coupled group, if it is one.
    pub(super) fn coupled(&self) -> Option<usize> {
        match self {
            Step::Coupled { index } => Some(*index),
            _ => None,
        }
    }

    /// The group whose sign chooses between the two assemblies of this step, if it has two.
    pub(super) fn choice(&self) -> Option<usize> {
        self.dyad().map(Dyad::group)
    }
}
