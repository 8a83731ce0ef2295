//! The worst case at a place: solves the mechanism at every corner of the tolerance box, or
//! encloses it.

use super::ToleranceStudy;
use super::contributions::Slopes;
use super::edge::EdgeSearch;
use super::machines::{CornerEffort, of_all_corners, of_derivatives};
use super::worst_case::{WorstCase, WorstKind};
use crate::Ball;
use crate::solver::State;

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
        let limits = &self.off.limits;
        let enclosure = self
            .machines
            .varied
            .enclose(limits, at, self.machines.order);
        let figures = nominal.iter().enumerate();
        let worst = figures.map(|(i, &value)| {
            let enclosed = enclosure
                .as_ref()
                .and_then(|all| self.enclosed(i, value?, all));
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

    /// Returns the worst case from a ball around all states; `None` if the ball is unbounded.
    pub(super) fn enclosed(
        &self,
        figure: usize,
        nominal: f64,
        all: &State<Ball>,
    ) -> Option<WorstCase> {
        let figure = &self.machines.figures[figure];
        let ball = figure.value(all).filter(|ball| ball.radius.is_finite())?;
        let middle = match figure.is_direction() {
            true => crate::angle::unwrap_near(nominal, ball.mid),
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
}
