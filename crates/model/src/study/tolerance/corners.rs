//! The worst case at a place: solves the mechanism at every corner of the tolerance box, or
//! encloses it.

use super::ToleranceStudy;
use super::contributions::Slopes;
use super::edge::EdgeSearch;
use super::machines::{CornerEffort, of_all_corners, of_derivatives};
use super::worst_case::{WorstCase, WorstKind};
use crate::Ball;

/// Maximum number of lengths with all corners solved, 65,536; with more, the worst case is
/// enclosed.
pub(super) const MAX_LENGTHS: usize = 16;

/// Up to 3^9 places of the grid, and searches from them.
pub(super) const THOROUGH: CornerEffort = CornerEffort {
    middles: 9,
    tries: 100,
    edges: true,
    rays: 0,
};
/// The limits for interactive use.
pub(super) const QUICK: CornerEffort = CornerEffort {
    middles: 9,
    tries: 8,
    edges: false,
    rays: 0,
};

impl ToleranceStudy {
    /// Returns the lengths that the values depend on.
    pub(super) fn acting(&self) -> Vec<usize> {
        let follows = |i: &usize| self.machines.varied.follows(*i);
        (0..self.off.lengths).filter(follows).collect()
    }

    /// Computes the worst case of every value that exists at a place. The machines must be at that
    /// place.
    pub(super) fn worst(
        &mut self,
        at: f64,
        nominal: &[Option<f64>],
        slopes: Option<&Slopes>,
        effort: CornerEffort,
    ) -> Vec<Option<WorstCase>> {
        let mut worst = self.worst_inside(at, nominal, slopes, effort);
        if effort.edges {
            let all = 0..self.off.limits.len();
            let acting = all.filter(|&i| self.machines.varied.follows(i)).collect();
            let count = nominal.len();
            EdgeSearch::new(&mut self.machines, &self.off, acting, count)
                .widen(nominal, &mut worst);
        }
        worst
    }

    /// Computes the worst case without a search for edges of assembly.
    fn worst_inside(
        &mut self,
        at: f64,
        nominal: &[Option<f64>],
        slopes: Option<&Slopes>,
        effort: CornerEffort,
    ) -> Vec<Option<WorstCase>> {
        let acting = self.acting();
        if acting.len() <= MAX_LENGTHS && !self.off.has_pins() {
            return of_all_corners(&mut self.machines, &self.off, &acting, nominal, effort);
        }
        let enclosed = self.enclosed(at, nominal);
        let figures = enclosed.into_iter().enumerate();
        let worst = figures.map(|(i, enclosed)| {
            let slopes = slopes.and_then(|slopes| slopes.of(i));
            let pointed = slopes.and_then(|slopes| {
                of_derivatives(&mut self.machines, &self.off, &acting, i, nominal, slopes)
            });
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

    /// Encloses every value at a place; `None` for a value without a finite enclosure.
    ///
    /// Two enclosures contain all values, and so does what they have in common: the ball arithmetic
    /// itself, and the nominal value plus all derivatives times the limits (mean value theorem). The
    /// latter has no overestimate of first order.
    pub(super) fn enclosed(&self, at: f64, nominal: &[Option<f64>]) -> Vec<Option<WorstCase>> {
        let varied = &self.machines.varied;
        let enclose = |limits: &[f64]| varied.enclose(limits, at, self.machines.order);
        let Some(all) = enclose(&self.off.limits) else {
            return vec![None; nominal.len()];
        };
        let exact = enclose(&self.off.nothing());
        let changes = self.largest_changes(at);
        let figures = self.machines.figures.iter().zip(nominal).enumerate();
        let enclosed = figures.map(|(i, (figure, &nominal))| {
            let nominal = nominal?;
            let range = |ball: Ball| {
                let middle = match figure.is_direction() {
                    true => crate::angle::unwrap_near(nominal, ball.mid),
                    false => ball.mid,
                };
                let radius = ball.bound(ball.mid)?;
                Some([middle - radius, middle + radius])
            };
            let [mut low, mut high] = range(figure.value(&all)?)?;
            let centre = exact.as_ref().and_then(|exact| figure.value(exact));
            let closer = centre.and_then(|centre| range(centre.widened(changes[i])));
            if let Some([least, greatest]) = closer {
                low = low.max(least);
                high = high.min(greatest);
            }
            Some(WorstCase {
                low,
                high,
                reached: [nominal; 2],
                kind: WorstKind::Enclosed,
                fails: false,
            })
        });
        enclosed.collect()
    }

    /// Returns a bound on the change of each value within the box, from the enclosed derivatives.
    /// It is infinite for a value without them, and for a formula with a kink.
    fn largest_changes(&self, at: f64) -> Vec<f64> {
        let figures = &self.machines.figures;
        let order = self.machines.order;
        let limits = &self.off.limits;
        let largest_slopes = |i: usize| -> Vec<f64> {
            let varied = &self.machines.varied;
            if !varied.follows(i) {
                return vec![0.0; figures.len()];
            }
            let state = varied.enclose_slopes(i, limits, at, order);
            let slopes = figures.iter().map(|figure| {
                let state = state.as_ref().filter(|_| !figure.has_sides())?;
                Some(figure.value(state)?.slope.largest())
            });
            slopes.map(|slope| slope.unwrap_or(f64::INFINITY)).collect()
        };
        let mut changes = vec![0.0; figures.len()];
        let mut add = |slopes: Vec<f64>, limit: f64| {
            for (change, slope) in changes.iter_mut().zip(slopes) {
                *change += slope * limit;
            }
        };
        let (lengths, pins) = limits.split_at(self.off.lengths);
        for (length, &limit) in lengths.iter().enumerate() {
            add(largest_slopes(length), limit);
        }
        for (number, limit) in pins.iter().enumerate().step_by(2) {
            let pin = lengths.len() + number;
            let [x, y] = [pin, pin + 1].map(largest_slopes);
            let both = x.into_iter().zip(y).map(|(x, y)| x.hypot(y));
            add(both.collect(), *limit);
        }
        changes
    }
}
