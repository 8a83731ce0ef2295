//! Five poses with a continuous family of dyads although four equations are independent: those of a
//! trammel, whose slides may have any pins of a circle.
//!
//! All dyads of the family solve any three of the four equations and are on the curve of these
//! three. A part of the family along this curve also solves the fourth equation. Isolated dyads are
//! where the fourth equation changes its sign along the curve.

use super::dyad::FullDyad;
use super::dyad_equations::Guidance;
use super::form::{self, Form};
use super::space;
use super::trace::CurveSpot;
use super::{five, four};

/// Absolute value of the fourth equation, with coordinates of size one, below which it holds up to
/// rounding and its sign means nothing.
const EQUATION_TOLERANCE: f64 = 1e-10;

/// Returns the dyads in the order of their curve, each isolated one as its own piece. The result is
/// empty unless there are four equations.
pub(super) fn pieces(guidance: &Guidance) -> Vec<Vec<FullDyad>> {
    let Ok(forms) = <&[Form; 4]>::try_from(guidance.forms.as_slice()) else {
        return Vec::new();
    };
    let turned = |k: usize| [0, 1, 2, 3].map(|step| forms[(k + step) % 4]);
    let all = [0, 1, 2, 3].map(|k| without_first(guidance, &turned(k)));
    all.into_iter()
        .find(|pieces| !pieces.is_empty())
        .unwrap_or_default()
}

fn without_first(guidance: &Guidance, forms: &[Form; 4]) -> Vec<Vec<FullDyad>> {
    let [left_out, others @ ..] = forms;
    let rest = |spot: &CurveSpot| space::dot(form::of_pivot(left_out, spot.pivot), spot.pin).hi;
    let mut pieces: Vec<Vec<FullDyad>> = Vec::new();
    let mut single: Vec<FullDyad> = Vec::new();
    for piece in four::traced(others, guidance.offsets()) {
        let dyad = |spot: &CurveSpot| guidance.dyad(spot.pin, spot.pivot);
        pieces.push(piece.spots.iter().filter_map(dyad).collect());
        for pair in piece.spots.windows(2) {
            let [before, after] = [rest(&pair[0]), rest(&pair[1])];
            let is_meant = before.abs().max(after.abs()) > EQUATION_TOLERANCE;
            if is_meant && before * after * turn(&pair[0], &pair[1]) <= 0.0 {
                let met = five::refined(forms, pair[1].pin);
                let met = met.and_then(|(pin, pivot)| guidance.dyad(pin, pivot));
                let is_new = |new: &FullDyad| !single.iter().any(|old| guidance.is_same(new, old));
                single.extend(met.filter(is_new));
            }
        }
    }
    pieces.retain(|piece| !piece.is_empty());
    pieces.extend(single.into_iter().map(|dyad| vec![dyad]));
    pieces
}

/// Returns a negative number if the coordinates of one of two neighbours have the opposite sign.
fn turn(a: &CurveSpot, b: &CurveSpot) -> f64 {
    (space::dot(a.pin, b.pin) * space::dot(a.pivot, b.pivot)).hi
}
