//! Computes tolerance bands along the motion, which plots draw next to curves.

use super::ToleranceStudy;
use super::corners::{MAX_LENGTHS, QUICK, THOROUGH};
use super::machines::CornerEffort;

/// The kind of limits of a band.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BandKind {
    /// The worst case.
    Worst,
    /// The root of the sum of squares.
    RootSumSquare,
}

impl BandKind {
    /// Returns the word that follows a value's name in a legend.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            BandKind::Worst => "worst",
            BandKind::RootSumSquare => "rss",
        }
    }
}

/// The offsets of a value below and above its nominal value, at one place.
pub type Offsets = [f64; 2];

/// Number of places computed over all samples of a plot; the offsets between them are interpolated
/// linearly.
const PLACES: usize = 72;

/// Maximum number of machines to solve for a band during editing: some hundredths of a second.
const QUICK_MACHINES: usize = 200_000;

impl ToleranceStudy {
    /// Computes a band quickly, for interactive use: the worst case if it has few machines, or else
    /// the root of the sum of squares.
    pub fn quick_band(&mut self, coordinates: &[f64]) -> (BandKind, Vec<Vec<Option<Offsets>>>) {
        let kind = self.quick_kind(coordinates.len());
        (kind, self.band_by(coordinates, kind, QUICK))
    }

    pub(super) fn quick_kind(&self, places: usize) -> BandKind {
        let lengths = self.acting().len();
        if lengths > MAX_LENGTHS || self.off.has_pins() {
            return BandKind::RootSumSquare;
        }
        let machines = QUICK.machines(lengths, self.figures().len());
        match knots(places).len().saturating_mul(machines) <= QUICK_MACHINES {
            true => BandKind::Worst,
            false => BandKind::RootSumSquare,
        }
    }

    /// Returns, value by value, the offsets at each of these consecutive places; `None` if a
    /// computed place next to it has none.
    pub fn band(&mut self, coordinates: &[f64], kind: BandKind) -> Vec<Vec<Option<Offsets>>> {
        self.band_by(coordinates, kind, THOROUGH)
    }

    fn band_by(
        &mut self,
        coordinates: &[f64],
        kind: BandKind,
        effort: CornerEffort,
    ) -> Vec<Vec<Option<Offsets>>> {
        let knots = knots(coordinates.len());
        let stride = stride(coordinates.len());
        let found: Vec<Vec<Option<Offsets>>> = knots
            .iter()
            .filter_map(|&knot| coordinates.get(knot))
            .map(|&at| self.offsets(at, kind, effort))
            .collect();
        let between = |index: usize, i: usize| {
            let (before, after) = (i / stride, (i / stride + 1).min(knots.len() - 1));
            let [a, b] = [before, after].map(|knot| found.get(knot)?.get(index).copied()?);
            let (a, b) = (a?, b?);
            let width = (knots[after] - knots[before]).max(1) as f64;
            let part = (i - knots[before]) as f64 / width;
            Some([0, 1].map(|side| a[side] + (b[side] - a[side]) * part))
        };
        let all = |index| (0..coordinates.len()).map(|i| between(index, i)).collect();
        (0..self.figures().len()).map(all).collect()
    }

    fn offsets(&mut self, at: f64, kind: BandKind, effort: CornerEffort) -> Vec<Option<Offsets>> {
        let slopes = self.slopes_at(at);
        match kind {
            BandKind::Worst => {
                let nominal = self.machines.go(at);
                let worst = self.worst(at, &nominal, slopes.as_ref(), effort);
                let pairs = nominal.iter().zip(worst);
                let offsets = pairs.map(|(nominal, worst)| {
                    let (nominal, worst) = ((*nominal)?, worst?);
                    // An unbounded worst case is drawn as far as machines reach.
                    let end = |end: f64, met: f64| if end.is_finite() { end } else { met };
                    let low = end(worst.low, worst.reached[0]);
                    let high = end(worst.high, worst.reached[1]);
                    Some([low - nominal, high - nominal])
                });
                offsets.collect()
            }
            BandKind::RootSumSquare => {
                let square = |i: usize| {
                    let size = self.off.root_sum_square(slopes.as_ref()?.of(i)?);
                    Some([-size, size])
                };
                (0..self.figures().len()).map(square).collect()
            }
        }
    }
}

/// Returns the distance of computed places, in places.
fn stride(places: usize) -> usize {
    places.saturating_sub(1).div_ceil(PLACES).max(1)
}

/// Returns the indices of the computed places, always including the last one.
fn knots(places: usize) -> Vec<usize> {
    let last = places.saturating_sub(1);
    (0..last).step_by(stride(places)).chain([last]).collect()
}
