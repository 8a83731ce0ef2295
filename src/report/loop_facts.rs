//! The first loop in the words of the textbooks: a four-bar's class, a slider-crank's condition.

use super::number::concise;
use crate::solver::{Grashof, Inversion, Loop};
use serde::Serialize;

/// Significant digits of lengths: by few of them a near miss differs from a change point.
const DIGITS: usize = 9;

/// The loop of the driven link, a dyad and the ground; lengths in the scene's unit.
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum LoopFacts {
    /// Four links and four pins.
    FourBar {
        /// `crank-rocker` and so on.
        inversion: &'static str,
        /// Grashof's condition: `s + l < p + q`.
        grashof: &'static str,
        /// The driven link.
        driven: f64,
        /// The link between the two on the frame.
        coupler: f64,
        /// The other link on the frame.
        follower: f64,
        /// The distance of the ground pivots.
        frame: f64,
    },
    /// A crank, a rod and a slider on the ground.
    SliderCrank {
        /// The driven link.
        crank: f64,
        /// The link between crank and slider.
        rod: f64,
        /// How far the path of the slider's pin passes the crank's pivot.
        offset: f64,
        /// rod - (crank + offset): above 0 the crank turns fully.
        margin: f64,
    },
}

impl LoopFacts {
    /// Names what the solver found.
    #[must_use]
    pub fn new(found: Loop) -> Self {
        match found {
            Loop::FourBar {
                driven,
                coupler,
                follower,
                frame,
                grashof,
                inversion,
            } => LoopFacts::FourBar {
                inversion: inversion_word(inversion, grashof),
                grashof: grashof_word(grashof),
                driven,
                coupler,
                follower,
                frame,
            },
            Loop::SliderCrank {
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

    /// The class and the lengths that decide it, each on a line.
    #[must_use]
    pub fn lines(&self, unit: &str) -> [String; 2] {
        let length = |v: f64| concise(v, DIGITS);
        match *self {
            LoopFacts::FourBar {
                inversion,
                grashof,
                driven,
                coupler,
                follower,
                frame,
            } => [
                format!("four-bar, {inversion}: {grashof}"),
                format!(
                    "driven {}, coupler {}, follower {}, frame {} {unit}",
                    length(driven),
                    length(coupler),
                    length(follower),
                    length(frame)
                ),
            ],
            LoopFacts::SliderCrank {
                crank,
                rod,
                offset,
                margin,
            } => [
                format!("slider-crank, {}", slider_crank_words(margin)),
                format!(
                    "crank {}, rod {}, offset {} {unit}",
                    length(crank),
                    length(rod),
                    length(offset)
                ),
            ],
        }
    }
}

fn slider_crank_words(margin: f64) -> &'static str {
    if margin > 0.0 {
        "the crank turns fully: rod > crank + offset"
    } else if margin == 0.0 {
        "change point: rod = crank + offset"
    } else {
        "the crank does not turn fully: rod < crank + offset"
    }
}

fn grashof_word(grashof: Grashof) -> &'static str {
    match grashof {
        Grashof::Turning => "Grashof, s + l < p + q",
        Grashof::ChangePoint => "change point, s + l = p + q",
        Grashof::Rocking => "not Grashof, s + l > p + q",
    }
}

fn inversion_word(inversion: Inversion, grashof: Grashof) -> &'static str {
    match inversion {
        Inversion::CrankRocker => "crank-rocker",
        // Nobody calls a parallelogram a drag link.
        Inversion::DoubleCrank if grashof == Grashof::ChangePoint => "double crank",
        Inversion::DoubleCrank => "double crank (drag link)",
        Inversion::RockerCrank => "rocker-crank",
        Inversion::DoubleRocker => "double rocker",
        Inversion::TripleRocker => "triple rocker",
    }
}
