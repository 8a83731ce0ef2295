//! Combines two dyads into a linkage, and selects the most promising distinct linkages.

use super::dyad::FullDyad;
use super::dyad_equations::Guidance;
use crate::{PinConstraint, Proposal};
use kinematics::{Vec2, angle};

/// Pins or pivots closer than this fraction of the size do not form a link.
const NOTHING: f64 = 1e-7;
/// Ratio of the longest to the shortest length above which the quality decreases in proportion.
const RATIO: f64 = 6.0;
/// Quality factor of a linkage whose crank would have to turn back.
const UNORDERED: f64 = 0.5;
/// Linkages are alike if all their points differ by less than this fraction of the shortest link.
const SIMILARITY_LIMIT: f64 = 0.5;
/// Maximum number of linkages per kind that certainly change their assembly between poses, if
/// linkages are selected from a continuous family.
const DEFECTIVE: usize = 8;

/// Combines two dyads into linkages of the wanted kinds.
pub(super) struct DyadPairing<'a> {
    pub guidance: &'a Guidance,
    pub four_bars: bool,
    pub slider_cranks: bool,
}

impl DyadPairing<'_> {
    /// Combines two dyads into a linkage; a four-bar is driven at the better of its two pivots.
    /// Returns `None` for an unwanted kind, or if pins or pivots coincide.
    pub(super) fn linkage(&self, a: &FullDyad, b: &FullDyad) -> Option<Proposal> {
        let (crank, pivot, other) = match (a.by, b.by) {
            (PinConstraint::Rocker(pivot), PinConstraint::Rocker(_)) if self.four_bars => {
                (a, pivot, b)
            }
            (PinConstraint::Rocker(pivot), PinConstraint::Slide(_)) if self.slider_cranks => {
                (a, pivot, b)
            }
            (PinConstraint::Slide(_), PinConstraint::Rocker(pivot)) if self.slider_cranks => {
                (b, pivot, a)
            }
            (PinConstraint::Rocker(_) | PinConstraint::Slide(_), _) => return None,
        };
        let pins = crank.places.iter().zip(&other.places);
        let proposal = Proposal {
            pivot,
            partner: other.by,
            places: pins.map(|(b, c)| [*b, *c]).collect(),
            tracer: Some(self.guidance.origin()),
        };
        let minimum = NOTHING * self.guidance.size;
        let is_one = (crank.pin - other.pin).norm() < minimum
            || matches!(other.by, PinConstraint::Rocker(d) if (d - pivot).norm() < minimum);
        if is_one {
            return None;
        }
        match proposal.swapped() {
            Some(swapped) if quality(&swapped) > quality(&proposal) => Some(swapped),
            Some(_) | None => Some(proposal),
        }
    }

    /// Returns the linkages of all pairs of dyads, best first. With `most`, returns at most so
    /// many, all different.
    pub(super) fn best_pairs(&self, dyads: &[FullDyad], maximum: Option<usize>) -> Vec<Proposal> {
        let pairs = dyads.iter().enumerate();
        let pairs = pairs.flat_map(|(k, a)| dyads[..k].iter().map(move |b| (a, b)));
        self.best(pairs.filter_map(|(a, b)| self.linkage(a, b)), maximum)
    }

    /// Returns the linkages of a given dyad with all others, best first. With `most`, returns at
    /// most so many, all different.
    pub(super) fn with(
        &self,
        given: &FullDyad,
        dyads: &[FullDyad],
        maximum: Option<usize>,
    ) -> Vec<Proposal> {
        let others = dyads
            .iter()
            .filter(|dyad| !self.guidance.is_same(given, dyad));
        self.best(
            others.filter_map(|other| self.linkage(given, other)),
            maximum,
        )
    }

    fn best(
        &self,
        linkages: impl Iterator<Item = Proposal>,
        maximum: Option<usize>,
    ) -> Vec<Proposal> {
        let mut ranked: Vec<(f64, Proposal)> = linkages.map(|p| (quality(&p), p)).collect();
        ranked.sort_by(|a, b| b.0.total_cmp(&a.0));
        let Some(maximum) = maximum else {
            return ranked.into_iter().map(|(_, linkage)| linkage).collect();
        };
        // Both kinds get an equal share.
        let (mut four_bars, mut slider_cranks) =
            (SelectedOfKind::default(), SelectedOfKind::default());
        let share = match self.four_bars && self.slider_cranks {
            true => maximum / 2,
            false => maximum,
        };
        for (quality, linkage) in ranked {
            let kind = match linkage.partner {
                PinConstraint::Rocker(_) => &mut four_bars,
                PinConstraint::Slide(_) => &mut slider_cranks,
            };
            let is_defective = quality <= 0.0;
            let is_full =
                kind.found.len() >= share || (is_defective && kind.defective >= DEFECTIVE);
            if !is_full && !kind.found.iter().any(|other| are_alike(other, &linkage)) {
                kind.defective += usize::from(is_defective);
                kind.found.push(linkage);
            }
        }
        four_bars.found.append(&mut slider_cranks.found);
        four_bars.found
    }
}

/// The selected linkages of one kind.
#[derive(Default)]
struct SelectedOfKind {
    found: Vec<Proposal>,
    defective: usize,
}

fn are_alike(a: &Proposal, b: &Proposal) -> bool {
    let distance = SIMILARITY_LIMIT * a.shortest().min(b.shortest());
    let near = |p: Vec2, q: Vec2| (p - q).norm() < distance;
    let [Some(pins), Some(others)] = [a, b].map(|linkage| linkage.places.first()) else {
        return true;
    };
    let is_held_alike = match (a.partner, b.partner) {
        (PinConstraint::Rocker(d), PinConstraint::Rocker(e)) => near(d, e),
        (PinConstraint::Slide(_), PinConstraint::Slide(_)) => true,
        (PinConstraint::Rocker(_), PinConstraint::Slide(_))
        | (PinConstraint::Slide(_), PinConstraint::Rocker(_)) => false,
    };
    is_held_alike && near(a.pivot, b.pivot) && near(pins[0], others[0]) && near(pins[1], others[1])
}

/// Returns the quality of a linkage: its minimum sine of the transmission angle over the poses.
///
/// The quality is lower for disproportionate lengths, and for a crank that has to turn back. It is
/// 0 if the assembly changes, since a mechanism cannot change it.
pub(super) fn quality(linkage: &Proposal) -> f64 {
    let sines = linkage
        .places
        .iter()
        .map(|pins| transmission(*pins, linkage.partner));
    let (mut minimum, mut maximum) = (f64::INFINITY, f64::NEG_INFINITY);
    for sine in sines {
        minimum = minimum.min(sine);
        maximum = maximum.max(sine);
    }
    // One of them has the opposite sign, or both are zero.
    if !(minimum * maximum > 0.0) {
        return 0.0;
    }
    let transmission = minimum.abs().min(maximum.abs());
    let order = if is_ordered(linkage) { 1.0 } else { UNORDERED };
    transmission * order / (linkage.ratio() / RATIO).max(1.0)
}

/// Returns the sine of the angle from coupler to rocker, or the cosine of the angle from slide to
/// coupler, signed like the assembly.
fn transmission([b, c]: [Vec2; 2], constraint: PinConstraint) -> f64 {
    let coupler = b - c;
    match constraint {
        PinConstraint::Rocker(d) => coupler.cross(d - c) / (coupler.norm() * (d - c).norm()),
        PinConstraint::Slide(along) => coupler.dot(angle::unit(along)) / coupler.norm(),
    }
}

/// Returns `true` if the crank reaches the poses in their order, turning one way and at most once.
fn is_ordered(linkage: &Proposal) -> bool {
    let turns = linkage.places.windows(2).map(|pair| {
        let [from, to] = [pair[0][0], pair[1][0]].map(|pin| pin - linkage.pivot);
        from.cross(to).atan2(from.dot(to)).to_degrees()
    });
    let turns: Vec<f64> = turns.collect();
    let complete = |wrapped: fn(f64) -> f64| turns.iter().map(|turn| wrapped(*turn)).sum::<f64>();
    let forwards = complete(|turn| turn.rem_euclid(360.0));
    let backwards = complete(|turn| (-turn).rem_euclid(360.0));
    forwards.min(backwards) < 360.0
}
