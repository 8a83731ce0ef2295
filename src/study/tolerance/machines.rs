//! Machines that are made with lengths off, and read: at a place of the driver, or over the whole motion.

use super::ToleranceFigure;
use super::box_grid::BoxGrid;
use super::edge::along_ray;
use super::search::Search;
use super::tolerance_box::ToleranceBox;
use super::worst::{MetRange, WorstCase, WorstKind};
use crate::solver::LoopKind;

/// Makes machines, and reads the figures of each.
pub(super) trait Machines {
    /// Reads every figure of the machine in which everything is off by so much, `None` where it has none; whether the
    /// machine closes.
    fn make(&mut self, by: &[f64], values: &mut [Option<f64>]) -> bool;

    /// Of the machine that was made last, how far each group is from the edge of assembly: not positive where it is the
    /// first that is open. None where that is not known.
    fn measures(&mut self) -> &[f64] {
        &[]
    }

    /// The class of the first loop of the machine that was made last.
    fn kind(&self) -> Option<LoopKind>;
}

/// How much is done to find a worst case by corners.
#[derive(Clone, Copy, Debug)]
pub(super) struct CornerEffort {
    /// So many sides of the box at the most have their middles looked at as well.
    pub(super) middles: usize,
    /// So many machines are made for each side, where a figure may be worse than on the grid, at either of its ends.
    pub(super) tries: usize,
    /// Whether edges of assembly within the tolerances are looked for.
    pub(super) edges: bool,
    /// Towards so many machines that lack a figure it is followed, to see whether it grows beyond all bounds.
    pub(super) rays: usize,
}

impl CornerEffort {
    /// How many machines are made at the most, of so many sides and figures.
    pub(super) fn machines(self, sides: usize, figures: usize) -> usize {
        BoxGrid::of(sides, self.middles).count() + 2 * figures * self.tries * sides
    }
}

/// The worst case of every figure by every corner of the box of these lengths; the others are as given.
pub(super) fn of_all_corners(
    machines: &mut impl Machines,
    off: &ToleranceBox,
    acting: &[usize],
    nominal: &[Option<f64>],
    effort: CornerEffort,
) -> Vec<Option<WorstCase>> {
    let grid = BoxGrid::of(acting.len(), effort.middles);
    let mut found = vec![Vec::with_capacity(grid.count()); nominal.len()];
    let mut by = off.nothing();
    let mut values = nominal.to_vec();
    let mut fails = false;
    for place in 0..grid.count() {
        off.put(acting, &grid.levels(place), &mut by);
        fails |= !machines.make(&by, &mut values);
        for (found, value) in found.iter_mut().zip(&values) {
            found.push(value.unwrap_or(f64::NAN));
        }
    }
    let mut search = Search::new(off, acting, &grid, effort.tries, nominal.len());
    let figures = nominal.iter().zip(&found).enumerate();
    let worst = figures.map(|(figure, (&nominal, found))| {
        let nominal = nominal?;
        let goes_one_way = grid.goes_one_way(nominal, found);
        let is_open = found.iter().any(|value| value.is_nan());
        search.may_turn = is_open || !goes_one_way;
        let ends =
            [-1.0, 1.0].map(|sign| search.beyond_grid(machines, figure, sign, nominal, found));
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
        let open = (0..found.len()).filter(|&place| found[place].is_nan());
        for place in open.take(effort.rays) {
            off.put(acting, &grid.levels(place), &mut by);
            if let Some((furthest, is_unbounded)) = along_ray(machines, figure, nominal, &by) {
                worst.extend(furthest, is_unbounded);
            }
        }
        Some(worst)
    });
    worst.collect()
}

/// The worst case of a figure by the machines that its derivatives point to, as far out as these close: pins on the
/// circles that they can be on.
pub(super) fn of_derivatives(
    machines: &mut impl Machines,
    off: &ToleranceBox,
    acting: &[usize],
    figure: usize,
    nominal: &[Option<f64>],
    slopes: &[f64],
) -> Option<WorstCase> {
    let way = off.furthest(&acting_slopes(off, slopes, acting), &off.nothing());
    let mut met = MetRange::of(nominal[figure]?);
    let mut fails = false;
    let mut values = nominal.to_vec();
    let mut by = off.nothing();
    for sign in [-1.0, 1.0] {
        let mut closes = |part: f64| {
            by.iter_mut()
                .zip(&way)
                .for_each(|(by, way)| *by = sign * part * way);
            let closes = machines.make(&by, &mut values);
            values[figure].into_iter().for_each(|value| met.meet(value));
            closes && values[figure].is_some()
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

/// Slopes by pins and by these lengths alone.
fn acting_slopes(off: &ToleranceBox, slopes: &[f64], acting: &[usize]) -> Vec<f64> {
    let mut all = off.nothing();
    let pins = off.lengths..slopes.len();
    for number in acting.iter().copied().chain(pins) {
        all[number] = slopes[number];
    }
    all
}

/// So often the way to a machine that does not close is halved.
const HALVINGS: u32 = 40;

/// What tolerances do to every figure: `None` for one that has no value as given, or no worst case.
pub(super) fn told<'s>(
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
