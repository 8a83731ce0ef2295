//! Classifies the first loop as textbooks do: the class of a four-bar, the condition of a
//! slider-crank.

use super::number::concise;
use crate::solver::{DrivenLoop, Grashof, Inversion};
use crate::wording::{Words, english_words, words};
use serde::Serialize;

/// Significant digits of lengths: enough to distinguish a near miss from a change point.
const DIGITS: usize = 9;

/// The loop of the driven link, a dyad and the ground; lengths in the scene's unit.
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum LoopFacts {
    /// Four links with four pins.
    FourBar {
        /// The inversion, such as `crank-rocker`.
        inversion: &'static str,
        /// Grashof's condition: `s + l < p + q`.
        grashof: &'static str,
        /// Inversion and Grashof class, for text in any language.
        #[serde(skip)]
        class: (Inversion, Grashof),
        /// The length of the driven link.
        driven: f64,
        /// The length of the coupler.
        coupler: f64,
        /// The length of the follower.
        follower: f64,
        /// The distance of the ground pivots.
        frame: f64,
    },
    /// A crank, a rod and a slider on the ground.
    SliderCrank {
        /// The length of the driven link.
        crank: f64,
        /// The length of the link between crank and slider.
        rod: f64,
        /// The distance of the crank's pivot from the path of the slider's pin.
        offset: f64,
        /// rod - (crank + offset): the crank turns fully if it is positive.
        margin: f64,
    },
}

impl LoopFacts {
    /// Converts the solver's result.
    #[must_use]
    pub fn new(found: DrivenLoop) -> Self {
        match found {
            DrivenLoop::FourBar {
                driven,
                coupler,
                follower,
                frame,
                grashof,
                inversion,
            } => LoopFacts::FourBar {
                inversion: inversion_word(inversion, grashof, english_words()),
                grashof: grashof_word(grashof, english_words()),
                class: (inversion, grashof),
                driven,
                coupler,
                follower,
                frame,
            },
            DrivenLoop::SliderCrank {
                crank,
                rod,
                offset,
                margin,
            } => LoopFacts::SliderCrank {
                crank,
                rod,
                offset,
                margin,
            },
        }
    }

    /// Returns the class alone.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match *self {
            LoopFacts::FourBar {
                class: (inversion, grashof),
                ..
            } => inversion_word(inversion, grashof, words()),
            LoopFacts::SliderCrank { .. } => words().slider_crank_alone(),
        }
    }

    /// Returns two lines: the class, and the lengths that determine it.
    #[must_use]
    pub fn lines(&self, unit: &str) -> [String; 2] {
        let length = |v: f64| concise(v, DIGITS);
        match *self {
            LoopFacts::FourBar {
                class: (inversion, grashof),
                driven,
                coupler,
                follower,
                frame,
                ..
            } => {
                let lengths = [driven, coupler, follower, frame].map(length);
                let inversion = inversion_word(inversion, grashof, words());
                [
                    words().four_bar(inversion, grashof_word(grashof, words())),
                    words().driven_coupler_follower_frame(&lengths, unit),
                ]
            }
            LoopFacts::SliderCrank {
                crank,
                rod,
                offset,
                margin,
            } => [
                words().slider_crank(slider_crank_words(margin)),
                words().crank_rod_offset(&[crank, rod, offset].map(length), unit),
            ],
        }
    }
}

fn slider_crank_words(margin: f64) -> &'static str {
    if margin > 0.0 {
        words().crank_turns_fully()
    } else if margin == 0.0 {
        words().rod_is_crank_and_offset()
    } else {
        words().crank_rocks()
    }
}

fn grashof_word(grashof: Grashof, say: &dyn Words) -> &'static str {
    match grashof {
        Grashof::Turning => say.grashof(),
        Grashof::ChangePoint => say.grashof_change_point(),
        Grashof::Rocking => say.not_grashof(),
    }
}

fn inversion_word(inversion: Inversion, grashof: Grashof, say: &dyn Words) -> &'static str {
    match inversion {
        Inversion::CrankRocker => say.crank_rocker(),
        // A parallelogram is not called a drag link.
        Inversion::DoubleCrank if grashof == Grashof::ChangePoint => say.double_crank(),
        Inversion::DoubleCrank => say.drag_link(),
        Inversion::RockerCrank => say.rocker_crank(),
        Inversion::DoubleRocker => say.double_rocker(),
        Inversion::TripleRocker => say.triple_rocker(),
    }
}
