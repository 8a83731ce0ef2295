//! How far figures may be off along the motion: what plots draw beside a curve.

use super::ToleranceStudy;

/// Which limits are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BandKind {
    /// The worst case.
    Worst,
    /// The root of the sum of squares.
    RootSumSquare,
}

impl BandKind {
    /// Behind the name of a figure in a legend.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            BandKind::Worst => "worst",
            BandKind::RootSumSquare => "rss",
        }
    }
}

/// By how much a figure may be below and above what it is as given, at one place.
pub type Offsets = [f64; 2];

/// So many places are worked out over all samples of a plot; between them the offsets go straight.
const PLACES: usize = 72;

/// So many lengths have all corners of a band solved before a person notices: 37,000 states.
const QUICK_LENGTHS: usize = 9;

impl ToleranceStudy {
    /// The band that is worked out while somebody waits: the worst case where all corners are few.
    #[must_use]
    pub fn quick_band(&self) -> BandKind {
        let has_pins = self.off.has_pins();
        let acting = (0..self.off.lengths).filter(|&i| self.varied.follows(i));
        match acting.count() <= QUICK_LENGTHS && !has_pins {
            true => BandKind::Worst,
            false => BandKind::RootSumSquare,
        }
    }

    /// Figure by figure the offsets at every one of these places, which follow one another; `None` where there are
    /// none at the worked-out places beside it.
    pub fn band(&mut self, places: &[f64], kind: BandKind) -> Vec<Vec<Option<Offsets>>> {
        let last = places.len().saturating_sub(1);
        let stride = last.div_ceil(PLACES).max(1);
        let knots: Vec<usize> = (0..last).step_by(stride).chain([last]).collect();
        let found: Vec<Vec<Option<Offsets>>> = knots
            .iter()
            .filter_map(|&knot| places.get(knot))
            .map(|&at| self.offsets(at, kind))
            .collect();
        let between = |figure: usize, i: usize| {
            let (before, behind) = (i / stride, (i / stride + 1).min(knots.len() - 1));
            let [a, b] = [before, behind].map(|knot| found.get(knot)?.get(figure).copied()?);
            let (a, b) = (a?, b?);
            let width = (knots[behind] - knots[before]).max(1) as f64;
            let part = (i - knots[before]) as f64 / width;
            Some([0, 1].map(|side| a[side] + (b[side] - a[side]) * part))
        };
        let all = |figure| (0..places.len()).map(|i| between(figure, i)).collect();
        (0..self.figures.len()).map(all).collect()
    }

    fn offsets(&mut self, at: f64, kind: BandKind) -> Vec<Option<Offsets>> {
        let nominal = self.nominal(at);
        let slopes = self.slopes_at(at);
        match kind {
            BandKind::Worst => {
                let worst = self.corners(at, &nominal, &slopes);
                let pairs = nominal.iter().zip(worst);
                let offsets = pairs.map(|(nominal, worst)| {
                    let (nominal, worst) = ((*nominal)?, worst?);
                    Some([worst.low - nominal, worst.high - nominal])
                });
                offsets.collect()
            }
            BandKind::RootSumSquare => {
                let square = |i: usize| {
                    let size = self.off.root_sum_square(slopes.as_ref()?.of(i)?);
                    Some([-size, size])
                };
                (0..nominal.len()).map(square).collect()
            }
        }
    }
}
