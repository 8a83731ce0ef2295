#![doc = include_str!("../../guide/elements.md")]
//!
//! # In the source
//!
//! Each element has a file; the table [`elements!`] lists them all. A new element needs its file,
//! an entry there, and its recognition in a block of unknowns ([`super::chain`]). A dyad with two
//! assemblies is also a variant of [`Dyad`] and has a class in [`super::plan`]. Its recognition
//! names the slide and the links through which it holds its joint.

mod arm;
mod circle_line;
mod circle_rail;
mod circles;
mod crank;
mod cylinder;
mod driven_link;
mod driven_slide;
mod dyad;
mod dyad_extension;
mod elbow;
mod line;
mod lines;
mod link_direction;
mod lock;
mod riding_point;
mod singular_series;
mod slide_readout;
mod swinging_arm;

pub(super) use arm::Arm;
pub(super) use circle_line::CircleLine;
pub(super) use circle_rail::CircleRail;
pub(super) use circles::Circles;
pub(super) use crank::{Crank, Spin};
pub(super) use cylinder::Cylinder;
pub(super) use driven_link::Timed;
pub(super) use driven_slide::Push;
pub(super) use dyad::Dyad;
pub(super) use dyad_extension::{FRAMES, RelativeMotion, Stretching, settled, sum};
pub(super) use elbow::Elbow;
pub(super) use line::GuideLine;
pub(super) use lines::Lines;
pub(super) use link_direction::Aim;
pub(super) use lock::Lock;
pub(super) use riding_point::Ride;
pub(super) use singular_series::{Height, Pair, SingularShift, ZERO, root};
pub(super) use slide_readout::SlideReadout;
pub(super) use swinging_arm::Swing;

use super::coupled::Coupled;
use super::forces::{ForceState, Site};
use super::further_inputs::Following;
use super::plan::pruning::PlacedPart;
use super::state::State;
use super::transmission::{InnerJoint, Ray};
use crate::{Constant, Number, Vec2};
use dyad::{TwoAssemblies, triangle_reserve};

/// The number of derivatives that a solve computes, as constants of the compiled code.
pub(super) const POSITION: u8 = 0;
pub(super) const VELOCITY: u8 = 1;
pub(super) const ACCELERATION: u8 = 2;

/// Tolerance for a group at its limit: 4 u of the lengths, the rounding of a computed distance. A
/// smaller value would reject exactly typed limits; a larger one would clamp states that are really
/// open.
pub(super) const REACH_SLACK: f64 = 4.0 * 0.5 * f64::EPSILON;

/// The outcome of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum StepOutcome {
    /// Solved.
    Done,
    /// So close to the limit that rounding matters: [`Dyad::stretch`] decides.
    Unclear,
    /// Stretched to the limit: positions exist, derivatives do not.
    Stretched,
    /// Cannot be assembled.
    Open,
}

/// The common interface of the elements.
pub(super) trait Element {
    /// Whether most mechanisms contain it; then its code is inlined.
    const IS_FREQUENT: bool = false;

    /// Whether its residuals determine its error bounds (see `bounds`); if not, it is also run in
    /// double-double.
    const HAS_RESIDUALS: bool = false;

    /// The element's backward pass.
    type Back: BackwardPass;

    /// Calls `places` for everything that the element places.
    fn outputs(&self, places: &mut impl FnMut(PlacedPart));

    /// Calls `reads` for everything that the element reads.
    fn inputs(&self, reads: &mut impl FnMut(PlacedPart));

    /// Computes the element's outputs at the driver's coordinate `q`. If that is an angle,
    /// `direction` is its unit vector.
    fn run<T: Number, const ORDER: u8>(
        &self,
        q: T,
        direction: Vec2<T>,
        state: &mut State<T>,
    ) -> StepOutcome;

    /// Passes every local position of the element to `place`, always in the same order, and updates
    /// itself with the changed values.
    fn vary(&mut self, _place: &mut impl FnMut(&mut Vec2<Constant>)) {}

    /// Passes the law of the element's input to `change`, if it has one.
    fn change_laws(&mut self, _change: &mut impl FnMut(&mut Following)) {}

    /// Returns the element's backward pass at its site; `None` if it has none.
    fn back(&self, site: &Site<'_>) -> Option<Self::Back>;

    /// Returns the dyad with two assemblies, if the element is one.
    fn dyad(&self) -> Option<Dyad<'_>> {
        None
    }

    /// Returns the two lines at its inner joint that enclose its transmission angle.
    fn rays(&self, _state: &State) -> Option<[Ray; 2]> {
        None
    }

    /// Returns the inner joint, if the element has one.
    fn inner_joint(&self) -> Option<InnerJoint> {
        None
    }
}

/// The backward pass of an element.
pub(super) trait BackwardPass {
    /// Transfers the forces on the element's outputs to its inputs, and records the joint forces.
    fn run<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>);
}

/// The backward pass of elements without one.
#[derive(Clone, Debug)]
pub(super) enum NoBackwardPass {}

impl BackwardPass for NoBackwardPass {
    fn run<T: Number>(&self, _state: &State<T>, _forces: &mut ForceState<T>) {
        match *self {}
    }
}

// Twice the size would double the alignment, and a step could cross the end of a page again.
const _: () = assert!(size_of::<Step>() == 512);

macro_rules! elements {
    ($($name:ident),+ $(,)?) => {
        /// One element of a plan. The alignment keeps it from crossing the end of a memory page:
        /// some processors take as long to read there as to solve a whole state.
        #[derive(Clone, Debug)]
        #[repr(align(512))]
        pub(super) enum Step {
            $($name($name),)+
            /// A coupled group, by its index.
            Coupled { index: usize },
        }

        /// The backward pass of one element.
        #[derive(Clone, Debug)]
        pub(super) enum Pass {
            $($name(<$name as Element>::Back),)+
            /// A coupled group, by its index.
            Coupled { index: usize },
        }

        $(impl From<$name> for Step {
            fn from(element: $name) -> Step {
                Step::$name(element)
            }
        })+

        impl Step {
            /// Runs the element: see [`Element::run`].
            #[inline(always)]
            pub(super) fn run<T: Number, const ORDER: u8>(
                &self,
                q: T,
                direction: Vec2<T>,
                state: &mut State<T>,
            ) -> StepOutcome {
                match self {
                    $(Step::$name(element) => element.run::<T, ORDER>(q, direction, state),)+
                    // The solver owns and runs the coupled groups.
                    Step::Coupled { .. } => StepOutcome::Done,
                }
            }

            /// Runs the element if most mechanisms contain it; returns `None` for other elements.
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

            /// Returns [`Element::HAS_RESIDUALS`] of the element.
            pub(super) fn has_residuals(&self) -> bool {
                match self {
                    $(Step::$name(_) => $name::HAS_RESIDUALS,)+
                    Step::Coupled { .. } => false,
                }
            }

            /// Returns the dyad with two assemblies, if the element is one.
            pub(super) fn dyad(&self) -> Option<Dyad<'_>> {
                match self {
                    $(Step::$name(element) => element.dyad(),)+
                    Step::Coupled { .. } => None,
                }
            }

            /// Returns the lines that enclose the transmission angle.
            pub(super) fn rays(&self, state: &State) -> Option<[Ray; 2]> {
                match self {
                    $(Step::$name(element) => element.rays(state),)+
                    Step::Coupled { .. } => None,
                }
            }

            /// Returns the joint with a transmission angle, if the element has one.
            pub(super) fn inner_joint(&self) -> Option<InnerJoint> {
                match self {
                    $(Step::$name(element) => element.inner_joint(),)+
                    Step::Coupled { .. } => None,
                }
            }

            /// Calls `places` for everything that the element places.
            pub(super) fn outputs(&self, coupled: &[Coupled], places: &mut impl FnMut(PlacedPart)) {
                match self {
                    $(Step::$name(element) => element.outputs(places),)+
                    Step::Coupled { index } => coupled[*index].outputs(places),
                }
            }

            /// Calls `reads` for everything that the element reads.
            pub(super) fn inputs(&self, coupled: &[Coupled], reads: &mut impl FnMut(PlacedPart)) {
                match self {
                    $(Step::$name(element) => element.inputs(reads),)+
                    Step::Coupled { index } => coupled[*index].reads(reads),
                }
            }

            /// Varies the element's local positions: see [`Element::vary`].
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

            /// Passes the law of the element's input to `change`: see [`Element::change_laws`].
            pub(super) fn change_laws(
                &mut self,
                coupled: &mut [Coupled],
                change: &mut impl FnMut(&mut Following),
            ) {
                match self {
                    $(Step::$name(element) => element.change_laws(change),)+
                    Step::Coupled { index } => coupled[*index].change_laws(change),
                }
            }

            /// Returns the element's backward pass at its site.
            pub(super) fn back(&self, site: &Site<'_>) -> Option<Pass> {
                match self {
                    $(Step::$name(element) => element.back(site).map(Pass::$name),)+
                    Step::Coupled { index } => Some(Pass::Coupled { index: *index }),
                }
            }
        }

        impl Pass {
            /// Runs the backward pass: see [`BackwardPass::run`].
            #[inline(always)]
            pub(super) fn run<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>) {
                match self {
                    $(Pass::$name(back) => back.run(state, forces),)+
                    // The engine owns and runs the coupled groups.
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
    /// Runs the element as [`Step::run`] does. There is one copy of its code for each arithmetic,
    /// which is fast enough for all but doubles.
    #[inline(never)]
    pub(super) fn run_to<T: Number>(
        &self,
        order: u8,
        (q, direction): (T, Vec2<T>),
        state: &mut State<T>,
    ) -> StepOutcome {
        match order {
            POSITION => self.run::<T, POSITION>(q, direction, state),
            VELOCITY => self.run::<T, VELOCITY>(q, direction, state),
            _ => self.run::<T, ACCELERATION>(q, direction, state),
        }
    }

    /// Returns the index of the coupled group, if the step is one.
    pub(super) fn coupled(&self) -> Option<usize> {
        match self {
            Step::Coupled { index } => Some(*index),
            _ => None,
        }
    }

    /// Returns the group whose sign selects the assembly of this step, if it has two assemblies.
    pub(super) fn choice(&self) -> Option<usize> {
        self.dyad().map(Dyad::group)
    }
}
