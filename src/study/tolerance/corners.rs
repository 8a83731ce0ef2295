//! The worst case: the mechanism solved at every corner of the box of lengths, or enclosed.

use super::ToleranceStudy;
use super::box_grid::BoxGrid;
use super::contributions::Slopes;
use crate::Ball;
use crate::solver::State;

/// So many lengths have all their corners solved, 65,536; of more the worst is enclosed.
const MOST_LENGTHS: usize = 16;

/// The least and the greatest that a figure can be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorstCase {
    /// The least.
    pub low: f64,
    /// The greatest.
    pub high: f64,
    /// What machines were found to reach: the same, or where it is enclosed, further inside.
    pub reached: [f64; 2],
    /// How they were found.
    pub kind: WorstKind,
    /// Whether there are lengths within their tolerances with which it does not close here; the figures are of those
    /// with which it does.
    pub fails: bool,
}

/// How a worst case was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WorstKind {
    /// By every corner of the box of lengths.
    Corners,
    /// All lengths together, in balls: no figure is outside, and the worst may be further inside.
    Enclosed,
    /// At the corners that the derivatives point to; nothing proves that there is no worse.
    Estimated,
}

/// What has been met.
#[derive(Clone, Copy, Debug)]
pub(super) struct MetRange {
    pub(super) low: f64,
    pub(super) high: f64,
}

impl MetRange {
    pub(super) fn meet(&mut self, value: f64) {
        self.low = self.low.min(value);
        self.high = self.high.max(value);
    }
}

impl WorstCase {
    /// The same where machines were met that go further: then it is not the worst case that it was taken for.
    #[must_use]
    pub(crate) fn widened(self, [low, high]: [f64; 2]) -> WorstCase {
        if self.low <= low && high <= self.high {
            return self;
        }
        let (low, high) = (self.low.min(low), self.high.max(high));
        WorstCase {
            low,
            high,
            reached: [low, high],
            kind: WorstKind::Estimated,
            ..self
        }
    }
}

impl ToleranceStudy {
    /// The worst case of every figure that has a value.
    pub(super) fn corners(
        &mut self,
        at: f64,
        nominal: &[Option<f64>],
        slopes: &Option<Slopes>,
    ) -> Vec<Option<WorstCase>> {
        let acting: Vec<usize> = (0..self.off.lengths)
            .filter(|&i| self.varied.follows(i))
            .collect();
        let has_pins = self.off.has_pins();
        if acting.len() <= MOST_LENGTHS && !has_pins {
            return self.all_corners(at, nominal, &acting);
        }
        let enclosure = self.varied.enclose(&self.off.limits, at, self.order);
        let figures = nominal.iter().enumerate();
        let worst = figures.map(|(i, &nominal)| {
            let nominal = nominal?;
            let enclosed = enclosure
                .as_ref()
                .and_then(|all| self.enclosed(i, nominal, all));
            let slopes = slopes.as_ref().and_then(|slopes| slopes.of(i));
            let pointed = slopes.and_then(|slopes| self.pointed(i, at, nominal, slopes, &acting));
            match (enclosed, pointed) {
                (Some(enclosed), Some(pointed)) => Some(WorstCase {
                    reached: pointed.reached,
                    ..enclosed
                }),
                (enclosed, pointed) => enclosed.or(pointed),
            }
        });
        worst.collect()
    }

    fn all_corners(
        &mut self,
        at: f64,
        nominal: &[Option<f64>],
        acting: &[usize],
    ) -> Vec<Option<WorstCase>> {
        let grid = BoxGrid::of(acting.len());
        let mut found = vec![Vec::with_capacity(grid.count()); nominal.len()];
        let mut by = self.off.nothing();
        let mut values = nominal.to_vec();
        let mut fails = false;
        for place in 0..grid.count() {
            grid.fill(place, acting, &self.off.limits, &mut by);
            self.varied.change(&by);
            if self.is_solved(at) {
                self.read(&mut values, Some(nominal));
            } else {
                fails = true;
                values.fill(None);
            }
            for (found, value) in found.iter_mut().zip(&values) {
                found.push(value.unwrap_or(f64::NAN));
            }
        }
        let figures = nominal.iter().zip(&found);
        let worst = figures.map(|(&nominal, found)| Some(grid.worst(nominal?, found, fails)));
        worst.collect()
    }

    /// What a ball around all states leaves; `None` where that is everything.
    pub(super) fn enclosed(
        &self,
        figure: usize,
        nominal: f64,
        all: &State<Ball>,
    ) -> Option<WorstCase> {
        let figure = &self.figures[figure];
        let ball = figure.value(all).filter(|ball| ball.radius.is_finite())?;
        let middle = match figure.is_direction() {
            true => crate::angle::beside(nominal, ball.mid),
            false => ball.mid,
        };
        Some(WorstCase {
            low: middle - ball.radius,
            high: middle + ball.radius,
            reached: [nominal; 2],
            kind: WorstKind::Enclosed,
            fails: false,
        })
    }

    /// The mechanism solved at the corners that the derivatives point to: pins on the circles that they can be on.
    pub(super) fn pointed(
        &mut self,
        figure: usize,
        at: f64,
        nominal: f64,
        slopes: &[f64],
        acting: &[usize],
    ) -> Option<WorstCase> {
        let way = self.off.way(slopes, acting);
        let mut met = MetRange {
            low: nominal,
            high: nominal,
        };
        let mut fails = false;
        let mut beside = vec![None; self.figures.len()];
        beside[figure] = Some(nominal);
        let mut values = beside.clone();
        for sign in [-1.0, 1.0] {
            let by: Vec<f64> = way.iter().map(|by| sign * by).collect();
            self.varied.change(&by);
            if self.is_solved(at) {
                self.read(&mut values, Some(&beside));
                values[figure].into_iter().for_each(|value| met.meet(value));
            } else {
                fails = true;
            }
        }
        Some(WorstCase {
            low: met.low,
            high: met.high,
            reached: [met.low, met.high],
            kind: WorstKind::Estimated,
            fails,
        })
    }
}
