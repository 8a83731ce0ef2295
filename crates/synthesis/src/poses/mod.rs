//! Rigid-body guidance: finds four-bars and slider-cranks that guide a body through three, four or
//! five poses.
//!
//! A linkage is two dyads, each a pin of the body with its partner on the ground. All dyads are
//! found for five poses, and their whole curve for four. For three poses, there is one dyad for
//! each pivot or pin.
//!
//! ```text
//! space           homogeneous coordinates in twice the digits
//! polynomial      real roots, determinants of linear forms
//! form            bilinear equations in pin and pivot, made independent
//! dyad_equations  poses and their equations, in the unit that suits both
//! dyad            a solution as a pin and what holds it, checked at every pose
//! three           a pin for each pivot, a pivot for each pin, a slide for each direction
//! four            the curve of all dyads
//! trace           points along this curve, in pieces
//! five            all dyads, by a resultant
//! family          five poses that any number of dyads lead through
//! free            which of these, by the number of independent equations
//! choice          two dyads as a linkage; selects the most promising different ones
//! ```

mod choice;
mod dyad;
mod dyad_equations;
mod family;
mod five;
mod form;
mod four;
mod free;
mod polynomial;
mod space;
#[cfg(test)]
mod tests;
mod three;
mod trace;

use super::{OpenReason, PoseTask, PosedDyad, Proposal, Proposals};
use choice::DyadPairing;
use dyad::FullDyad;
use dyad_equations::Guidance;
use free::Free;
pub(crate) use free::PoseReach;
use kinematics::Vec2;

/// Proposes linkages through the poses of a task: four-bars, slider-cranks or both, with all given
/// pivots and pins.
///
/// `inside` are two opposite corners of a box preferred for free pivots. Dyads of a continuous
/// family are left out if their pivots are outside it, or if they are further away than `reach`.
///
/// Every pin keeps its distance, or its line, at every pose to 1e-9 of the size, which is the
/// distance between the poses. For five poses the linkages are complete, unless a continuous family
/// of dyads exists or the rounding of the poses leaves this open. For three or four poses they are
/// complete if two dyads are given; if not, they are a selection. Each linkage occurs once:
/// [`swapped`](super::Proposal::swapped) drives it at the other pivot.
pub(crate) fn propose(
    task: &PoseTask,
    four_bars: bool,
    slider_cranks: bool,
    inside: Option<[Vec2; 2]>,
    reach: PoseReach,
) -> Proposals {
    let Some(guidance) = Guidance::new(task) else {
        return Proposals {
            reason: Some(OpenReason::Range),
            ..Proposals::default()
        };
    };
    let pairing = DyadPairing {
        guidance: &guidance,
        four_bars,
        slider_cranks,
    };
    let free = Free::new(&guidance, task, inside, reach);
    let given = given(&guidance, task);
    let (found, is_complete) = match given.as_deref() {
        Some([one, other]) => (pairing.linkage(one, other).into_iter().collect(), true),
        Some(given @ ([] | [_])) => {
            let of = |dyads: &[FullDyad], maximum| match given.first() {
                Some(one) => pairing.with(one, dyads, maximum),
                None => pairing.best_pairs(dyads, maximum),
            };
            let mut found = of(&free.single, None);
            if let Some(choice) = &free.choice {
                found.extend(of(&choice.dyads, Some(choice.most)));
            }
            (found, free.choice.is_none())
        }
        Some([..]) | None => (Vec::new(), true),
    };
    let reason = match (found.is_empty(), given.is_some()) {
        (true, false) => Some(OpenReason::GivenNumber),
        (true, true) => Some(guidance.reason_for_none(task, is_complete)),
        (false, _) => free.reason.filter(|_| !is_complete),
    };
    Proposals {
        found,
        is_complete,
        reason,
        curves: free.curves,
    }
}

impl PoseTask {
    /// Combines two dyads of the task's curves into a linkage, driven at the better pivot. Returns
    /// `None` if they share a pin or a pivot, or are two slides.
    #[must_use]
    pub fn linkage(&self, dyads: [&PosedDyad; 2]) -> Option<Proposal> {
        let guidance = Guidance::new(self)?;
        let pairing = DyadPairing {
            guidance: &guidance,
            four_bars: true,
            slider_cranks: true,
        };
        let [one, other] = dyads.map(|dyad| guidance.known(dyad));
        pairing.linkage(&one?, &other?)
    }
}

/// Returns the dyads of the given pivots and pins; `None` if one of these cannot pass through the
/// poses.
fn given(guidance: &Guidance, task: &PoseTask) -> Option<Vec<FullDyad>> {
    let of_pivots = task.pivots.iter().map(|&at| guidance.on_pivot(at));
    let of_pins = task.pins.iter().map(|&at| guidance.on_pin(at));
    let mut found: Vec<FullDyad> = Vec::new();
    for dyad in of_pivots.chain(of_pins) {
        let dyad = dyad?;
        if !found.iter().any(|other| guidance.is_same(other, &dyad)) {
            found.push(dyad);
        }
    }
    Some(found)
}
