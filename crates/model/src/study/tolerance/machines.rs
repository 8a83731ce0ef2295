//! Machines with deviating lengths, evaluated at a place of the driver or over the whole motion.

use super::ToleranceFigure;
use super::box_grid::BoxGrid;
use super::edge::along_ray;
use super::search::Search;
use super::tolerance_box::ToleranceBox;
use super::worst_case::{ObservedRange, WorstCase, WorstKind};
use crate::solver::LoopKind;

/// Builds machines and evaluates values of each.
pub(super) trait Machines {
    /// Evaluates every value of the machine with these deviations, `None` if missing. Returns
    /// `true` if the machine closes.
    fn make(&mut self, by: &[f64], values: &mut [Option<f64>]) -> bool;

    /// Returns the distance of each group of the last machine from the edge of assembly; not
    /// positive for the first open group. Empty if unknown.
    fn measures(&mut self) -> &[f64] {
        &[]
    }

    /// Returns the class of the last machine's first loop.
    fn kind(&self) -> Option<LoopKind>;
}

/// The limits of a worst-case search by corners.
#[derive(Clone, Copy, Debug)]
pub(super) struct CornerEffort {
    /// Maximum number of sides for a grid with midpoints.
    pub(super) middles: usize,
    /// Maximum number of machines per side for the search beyond the grid, at either end of a
    /// value.
    pub(super) tries: usize,
    /// `true` to search for edges of assembly within the tolerances.
    pub(super) edges: bool,
    /// Maximum number of machines without a value towards which it is followed, to detect unbounded
    /// growth.
    pub(super) rays: usize,
}

impl CornerEffort {
    /// Returns the maximum number of machines for a number of sides and values.
    pub(super) fn machines(self, sides: usize, count: usize) -> usize {
        BoxGrid::of(sides, self.middles).count() + 2 * count * self.tries * sides
    }
}

/// Computes the worst case of every value by all corners of the box of these lengths; the others
/// stay nominal.
pub(super) fn of_all_corners(
    machines: &mut impl Machines,
    off: &ToleranceBox,
    acting: &[usize],
    nominal: &[Option<f64>],
    effort: CornerEffort,
) -> Vec<Option<WorstCase>> {
    let grid = BoxGrid::of(acting.len(), effort.middles);
    let mut found = vec![vec![f64::NAN; grid.count()]; nominal.len()];
    let mut by = off.nothing();
    let mut values = nominal.to_vec();
    let mut fails = false;
    for place_index in grid.walk() {
        off.set_deviations(acting, &grid.levels(place_index), &mut by);
        fails |= !machines.make(&by, &mut values);
        for (found, value) in found.iter_mut().zip(&values) {
            found[place_index] = value.unwrap_or(f64::NAN);
        }
    }
    let mut search = Search::new(off, acting, &grid, effort.tries, nominal.len());
    let figures = nominal.iter().zip(&found).enumerate();
    let worst = figures.map(|(index, (&nominal, found))| {
        let nominal = nominal?;
        let goes_one_way = grid.is_monotonic(nominal, found);
        let is_open = found.iter().any(|value| value.is_nan());
        search.may_turn = is_open || !goes_one_way;
        let ends =
            [-1.0, 1.0].map(|sign| search.beyond_grid(machines, index, sign, nominal, found));
        let [low, high] = [ends[0].value, ends[1].value];
        let kind = if is_open {
            WorstKind::AtEdge
        } else if ends.iter().any(|end| end.is_inside) || !goes_one_way {
            WorstKind::Searched
        } else {
            WorstKind::Corners
        };
        let mut worst = WorstCase {
            low,
            high,
            reached: [low, high],
            kind,
            fails,
        };
        let open = (0..found.len()).filter(|&place_index| found[place_index].is_nan());
        for place_index in open.take(effort.rays) {
            off.set_deviations(acting, &grid.levels(place_index), &mut by);
            if let Some((extreme, is_unbounded)) = along_ray(machines, index, nominal, &by) {
                worst.extend(extreme, is_unbounded);
            }
        }
        Some(worst)
    });
    worst.collect()
}

/// Computes the worst case of a value by the machines in the direction of its derivatives, as far
/// as these close. Pins are on the circles of their clearances.
pub(super) fn of_derivatives(
    machines: &mut impl Machines,
    off: &ToleranceBox,
    acting: &[usize],
    index: usize,
    nominal: &[Option<f64>],
    slopes: &[f64],
) -> Option<WorstCase> {
    let travel = off.extreme_machine(&acting_slopes(off, slopes, acting), &off.nothing());
    let mut met = ObservedRange::of(nominal[index]?);
    let mut fails = false;
    let mut values = nominal.to_vec();
    let mut by = off.nothing();
    for sign in [-1.0, 1.0] {
        let mut closes = |part: f64| {
            by.iter_mut()
                .zip(&travel)
                .for_each(|(by, travel)| *by = sign * part * travel);
            let closes = machines.make(&by, &mut values);
            values[index].into_iter().for_each(|value| met.meet(value));
            closes && values[index].is_some()
        };
        if !closes(1.0) {
            fails = true;
            let (mut inside, mut outside) = (0.0, 1.0);
            for _ in 0..HALVINGS {
                let middle = f64::midpoint(inside, outside);
                *(if closes(middle) {
                    &mut inside
                } else {
                    &mut outside
                }) = middle;
            }
        }
    }
    Some(WorstCase {
        low: met.low,
        high: met.high,
        reached: [met.low, met.high],
        kind: WorstKind::Derivatives,
        fails,
    })
}

/// Returns the slopes by pins and by these lengths, with zeros for the others.
fn acting_slopes(off: &ToleranceBox, slopes: &[f64], acting: &[usize]) -> Vec<f64> {
    let mut all = off.nothing();
    let pins = off.lengths..slopes.len();
    for number in acting.iter().copied().chain(pins) {
        all[number] = slopes[number];
    }
    all
}

/// Bisections towards a machine that does not close.
const HALVINGS: u32 = 40;

/// Returns the effect of tolerances on every value; `None` for a value without a nominal value or
/// worst case.
pub(super) fn tolerance_effects<'s>(
    off: &ToleranceBox,
    nominal: &[Option<f64>],
    worst: Vec<Option<WorstCase>>,
    slopes: impl Fn(usize) -> Option<&'s [f64]>,
) -> Vec<Option<ToleranceFigure>> {
    let figures = nominal.iter().zip(worst).enumerate();
    let figure = figures.map(|(i, (&nominal, worst))| {
        let slopes = slopes(i);
        let contributions = slopes.map(|slopes| off.contributions(slopes));
        Some(ToleranceFigure {
            nominal: nominal?,
            worst: worst?,
            root_sum_square: slopes.map(|slopes| off.root_sum_square(slopes)),
            contributions: contributions.unwrap_or_default(),
        })
    });
    figure.collect()
}
