//! Classifies the first loop as textbooks do: the class of a four-bar, the condition of a
//! slider-crank.

use super::{CheckedScene, Fact, PLACES};
use crate::report::text::number::concise;
use crate::solver::{DrivenLoop, Grashof, Inversion};
use crate::wording::{Words, english_words, words};
use serde_json::json;

impl CheckedScene<'_> {
    /// Returns the class of the loop of the driven link, a dyad and the ground, and the lengths
    /// that determine it.
    pub(super) fn first_loop(&self) -> Fact {
        let fact = Fact::new(words().fact_loop());
        // Enough digits to distinguish a near miss from a change point.
        let length = |v: f64| concise(v, PLACES);
        let (lines, value) = match self.solver.first_loop() {
            None => return fact.value("loop", ()),
            Some(DrivenLoop::FourBar {
                driven,
                coupler,
                follower,
                frame,
                grashof,
                inversion,
            }) => {
                let lengths = [driven, coupler, follower, frame].map(length);
                let names = |wording| {
                    let inversion = inversion_word(inversion, grashof, wording);
                    (inversion, grashof_word(grashof, wording))
                };
                let (class, condition) = names(words());
                let lines = [
                    words().four_bar(class, condition),
                    words().driven_coupler_follower_frame(&lengths, self.length),
                ];
                let (class, condition) = names(english_words());
                let value = json!({
                    "kind": "four-bar",
                    "inversion": class,
                    "grashof": condition,
                    "driven": driven,
                    "coupler": coupler,
                    "follower": follower,
                    "frame": frame,
                });
                (lines, value)
            }
            Some(DrivenLoop::SliderCrank {
                crank,
                rod,
                offset,
                margin,
            }) => {
                let lines = [
                    words().slider_crank(slider_crank_words(margin)),
                    words().crank_rod_offset(&[crank, rod, offset].map(length), self.length),
                ];
                let value = json!({
                    "kind": "slider-crank",
                    "crank": crank,
                    "rod": rod,
                    "offset": offset,
                    "margin": margin,
                });
                (lines, value)
            }
        };
        fact.lines(lines).value("loop", value)
    }
}

/// Returns the class of a loop.
pub(in crate::report) fn loop_name(found: &DrivenLoop) -> &'static str {
    match *found {
        DrivenLoop::FourBar {
            inversion, grashof, ..
        } => inversion_word(inversion, grashof, words()),
        DrivenLoop::SliderCrank { .. } => words().slider_crank_alone(),
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

fn grashof_word(grashof: Grashof, wording: &dyn Words) -> &'static str {
    match grashof {
        Grashof::Turning => wording.grashof(),
        Grashof::ChangePoint => wording.grashof_change_point(),
        Grashof::Rocking => wording.not_grashof(),
    }
}

fn inversion_word(inversion: Inversion, grashof: Grashof, wording: &dyn Words) -> &'static str {
    match inversion {
        Inversion::CrankRocker => wording.crank_rocker(),
        // A parallelogram is not called a drag link.
        Inversion::DoubleCrank if grashof == Grashof::ChangePoint => wording.double_crank(),
        Inversion::DoubleCrank => wording.drag_link(),
        Inversion::RockerCrank => wording.rocker_crank(),
        Inversion::DoubleRocker => wording.double_rocker(),
        Inversion::TripleRocker => wording.triple_rocker(),
    }
}
