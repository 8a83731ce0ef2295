//! Two dyads make a linkage; of many, those that promise most and are different.

use super::dyad::PinHeld;
use super::guidance::Guidance;
use crate::{Partner, Proposal};
use kinematics::{Vec2, angle};

/// Pins, or pivots, nearer than this part of the size make no link.
const NOTHING: f64 = 1e-7;
/// The ratio of the longest to the shortest length from which on a linkage is as bad as the ratio is large.
const RATIO: f64 = 6.0;
/// What a linkage is worth whose crank would have to turn back on the way.
const UNORDERED: f64 = 0.5;
/// Linkages of which no point is further from that of another than this part of the shortest link are alike.
const ALIKE: f64 = 0.5;
/// Of linkages that are sure to change their assembly between poses, and chosen from any number, so many of each kind are shown.
const DEFECTIVE: usize = 8;

/// A linkage of two dyads, as far as it is one that is wanted.
pub(super) struct DyadPairing<'a> {
    pub guidance: &'a Guidance,
    pub four_bars: bool,
    pub slider_cranks: bool,
}

impl DyadPairing<'_> {
    /// Two dyads as a linkage; of a four-bar the better one of its two pivots drives.
    pub(super) fn linkage(&self, a: &PinHeld, b: &PinHeld) -> Option<Proposal> {
        let (crank, pivot, other) = match (a.by, b.by) {
            (Partner::Rocker(pivot), Partner::Rocker(_)) if self.four_bars => (a, pivot, b),
            (Partner::Rocker(pivot), Partner::Slide(_)) if self.slider_cranks => (a, pivot, b),
            (Partner::Slide(_), Partner::Rocker(pivot)) if self.slider_cranks => (b, pivot, a),
            (Partner::Rocker(_) | Partner::Slide(_), _) => return None,
        };
        let pins = crank.places.iter().zip(&other.places);
        let proposal = Proposal {
            pivot,
            partner: other.by,
            places: pins.map(|(b, c)| [*b, *c]).collect(),
            tracer: Some(self.guidance.origin()),
        };
        let least = NOTHING * self.guidance.size;
        let is_one = (crank.pin - other.pin).norm() < least
            || matches!(other.by, Partner::Rocker(d) if (d - pivot).norm() < least);
        if is_one {
            return None;
        }
        match proposal.swapped() {
            Some(swapped) if quality(&swapped) > quality(&proposal) => Some(swapped),
            Some(_) | None => Some(proposal),
        }
    }

    /// The linkages of all pairs of dyads: where a number is given, at most so many, each different from those before
    /// it.
    pub(super) fn among(&self, dyads: &[PinHeld], most: Option<usize>) -> Vec<Proposal> {
        let pairs = dyads.iter().enumerate();
        let pairs = pairs.flat_map(|(k, a)| dyads[..k].iter().map(move |b| (a, b)));
        self.best(pairs.filter_map(|(a, b)| self.linkage(a, b)), most)
    }

    /// The same of all pairs with one dyad that is given.
    pub(super) fn with(
        &self,
        given: &PinHeld,
        dyads: &[PinHeld],
        most: Option<usize>,
    ) -> Vec<Proposal> {
        let others = dyads
            .iter()
            .filter(|dyad| !self.guidance.is_same(given, dyad));
        self.best(others.filter_map(|other| self.linkage(given, other)), most)
    }

    fn best(&self, linkages: impl Iterator<Item = Proposal>, most: Option<usize>) -> Vec<Proposal> {
        let mut ranked: Vec<(f64, Proposal)> = linkages.map(|p| (quality(&p), p)).collect();
        ranked.sort_by(|a, b| b.0.total_cmp(&a.0));
        let Some(most) = most else {
            return ranked.into_iter().map(|(_, linkage)| linkage).collect();
        };
        // Both kinds have their share.
        let (mut four_bars, mut slider_cranks) = (ChosenOfKind::default(), ChosenOfKind::default());
        let share = match self.four_bars && self.slider_cranks {
            true => most / 2,
            false => most,
        };
        for (quality, linkage) in ranked {
            let kind = match linkage.partner {
                Partner::Rocker(_) => &mut four_bars,
                Partner::Slide(_) => &mut slider_cranks,
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

/// Those of one kind that were chosen.
#[derive(Default)]
struct ChosenOfKind {
    found: Vec<Proposal>,
    defective: usize,
}

fn are_alike(a: &Proposal, b: &Proposal) -> bool {
    let apart = ALIKE * a.shortest().min(b.shortest());
    let near = |p: Vec2, q: Vec2| (p - q).norm() < apart;
    let [Some(pins), Some(others)] = [a, b].map(|linkage| linkage.places.first()) else {
        return true;
    };
    let is_held_alike = match (a.partner, b.partner) {
        (Partner::Rocker(d), Partner::Rocker(e)) => near(d, e),
        (Partner::Slide(_), Partner::Slide(_)) => true,
        (Partner::Rocker(_), Partner::Slide(_)) | (Partner::Slide(_), Partner::Rocker(_)) => false,
    };
    is_held_alike && near(a.pivot, b.pivot) && near(pins[0], others[0]) && near(pins[1], others[1])
}

/// The least sine of the transmission angle over the poses; less for lengths out of proportion, and for a crank that does
/// not turn one way; none where the assembly changes, since a mechanism does not.
pub(super) fn quality(linkage: &Proposal) -> f64 {
    let sines = linkage
        .places
        .iter()
        .map(|pins| transmission(*pins, linkage.partner));
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for sine in sines {
        least = least.min(sine);
        most = most.max(sine);
    }
    // One of them has the wrong sign, or both are nought.
    if !(least * most > 0.0) {
        return 0.0;
    }
    let transmission = least.abs().min(most.abs());
    let order = if is_ordered(linkage) { 1.0 } else { UNORDERED };
    transmission * order / (linkage.ratio() / RATIO).max(1.0)
}

/// The sine of the angle from coupler to rocker, or the cosine of that from slide to coupler: its sign is that of the
/// assembly.
fn transmission([b, c]: [Vec2; 2], partner: Partner) -> f64 {
    let coupler = b - c;
    match partner {
        Partner::Rocker(d) => coupler.cross(d - c) / (coupler.norm() * (d - c).norm()),
        Partner::Slide(along) => coupler.dot(angle::unit(along)) / coupler.norm(),
    }
}

/// Whether the crank comes to the poses in their order, turning one way and once at most.
fn is_ordered(linkage: &Proposal) -> bool {
    let turns = linkage.places.windows(2).map(|pair| {
        let [from, to] = [pair[0][0], pair[1][0]].map(|pin| pin - linkage.pivot);
        from.cross(to).atan2(from.dot(to)).to_degrees()
    });
    let turns: Vec<f64> = turns.collect();
    let whole = |wrapped: fn(f64) -> f64| turns.iter().map(|turn| wrapped(*turn)).sum::<f64>();
    let forwards = whole(|turn| turn.rem_euclid(360.0));
    let backwards = whole(|turn| (-turn).rem_euclid(360.0));
    forwards.min(backwards) < 360.0
}
