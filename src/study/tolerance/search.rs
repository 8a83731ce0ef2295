//! From the worst of the places of a grid on: whether a figure goes further inside of the box, or towards where it
//! ceases to exist.
//!
//! Steps along each side in turn, taken wherever they lead further, and made shorter where none does. From a corner at
//! which a figure is worst none of them leads anywhere, and a few lengths of step are enough to see it.

use super::box_grid::{BoxGrid, rounding};
use super::machines::Machines;
use super::tolerance_box::ToleranceBox;

/// Where no step leads further, each is made so much shorter.
const SHORTER: f64 = 0.25;
/// Steps are parts of a tolerance. Down to this one they are tried at a corner,
const SHORTEST_TRY: f64 = 1.0 / 64.0;
/// and down to this one where one has led further or may: at an edge of assembly figures go with the root of the way.
const SHORTEST: f64 = 1e-12;

/// The worst that was found of a figure at one end of what it can be.
#[derive(Clone, Copy, Debug)]
pub(super) struct FurthestFound {
    pub(super) value: f64,
    /// Whether it is no place of the grid.
    pub(super) is_inside: bool,
}

/// Looks further than the places of a grid.
pub(super) struct Search<'b> {
    off: &'b ToleranceBox,
    acting: &'b [usize],
    grid: &'b BoxGrid,
    /// So many machines are made for one end of a figure, and then it is enough.
    most: usize,
    /// Whether the figure goes both ways along a side or is not everywhere, so that the smallest steps are worth trying.
    pub(super) may_turn: bool,
    by: Vec<f64>,
    values: Vec<Option<f64>>,
}

impl<'b> Search<'b> {
    /// Among so many figures, with so many machines for each side.
    pub(super) fn new(
        off: &'b ToleranceBox,
        acting: &'b [usize],
        grid: &'b BoxGrid,
        tries: usize,
        figures: usize,
    ) -> Search<'b> {
        Search {
            off,
            acting,
            grid,
            most: tries * acting.len(),
            may_turn: true,
            by: off.nothing(),
            values: vec![None; figures],
        }
    }

    /// The least of a figure, or with the sign of 1 the greatest: from the worst that was `found` on the grid.
    pub(super) fn beyond_grid(
        &mut self,
        machines: &mut impl Machines,
        figure: usize,
        sign: f64,
        nominal: f64,
        found: &[f64],
    ) -> FurthestFound {
        let rounding = rounding(nominal, found);
        let mut value = nominal;
        let mut levels = vec![0.0; self.acting.len()];
        for (place, &at_place) in found.iter().enumerate() {
            // Written so that NaN is not further.
            if sign * (at_place - value) > 0.0 {
                value = at_place;
                levels = self.grid.levels(place);
            }
        }
        let mut step = self.grid.half_way();
        let mut is_inside = false;
        let mut left = self.most;
        let may_turn = self.may_turn;
        let shortest = |is_inside| match is_inside || may_turn {
            true => SHORTEST,
            false => SHORTEST_TRY,
        };
        while step > shortest(is_inside) && left > 0 {
            let mut leads = false;
            for side in 0..levels.len() {
                for way in [-step, step] {
                    let before = levels[side];
                    levels[side] = (before + way).clamp(-1.0, 1.0);
                    if levels[side] == before {
                        continue;
                    }
                    left = left.saturating_sub(1);
                    match self.read(machines, figure, &levels) {
                        Some(there) if sign * (there - value) > rounding => {
                            value = there;
                            leads = true;
                        }
                        Some(_) | None => levels[side] = before,
                    }
                }
            }
            is_inside |= leads;
            if !leads {
                step *= SHORTER;
            }
        }
        FurthestFound { value, is_inside }
    }

    fn read(&mut self, machines: &mut impl Machines, figure: usize, levels: &[f64]) -> Option<f64> {
        self.off.put(self.acting, levels, &mut self.by);
        machines.make(&self.by, &mut self.values);
        self.values[figure]
    }
}
