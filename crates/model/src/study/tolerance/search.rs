//! Searches from the worst place of a grid for values beyond it, inside the box or towards the end
//! of a value's existence.
//!
//! Steps are tried along each side in turn, taken if they improve, and shortened if none does. From
//! a corner where a value is worst no step improves, which a few step lengths suffice to show.

use super::box_grid::{BoxGrid, rounding};
use super::machines::Machines;
use super::tolerance_box::ToleranceBox;

/// The factor that shortens the steps if none improves.
const SHORTER: f64 = 0.25;
/// The shortest step at a corner, relative to a tolerance.
const MIN_TRY: f64 = 1.0 / 64.0;
/// The shortest step after an improvement, or if one is possible: at an edge of assembly values are
/// proportional to the root of the distance.
const MIN_LEN: f64 = 1e-12;

/// The extreme value found in one direction.
#[derive(Clone, Copy, Debug)]
pub(super) struct DirectionExtreme {
    pub(super) value: f64,
    /// `true` if the search found the value between the places of the grid.
    pub(super) is_inside: bool,
}

/// A search beyond the places of a grid.
pub(super) struct Search<'b> {
    off: &'b ToleranceBox,
    acting: &'b [usize],
    grid: &'b BoxGrid,
    /// Maximum number of machines for one end of a value.
    most: usize,
    /// `true` if the value is not monotonic along a side, or does not exist everywhere, so that the
    /// smallest steps are worth trying.
    pub(super) may_turn: bool,
    by: Vec<f64>,
    values: Vec<Option<f64>>,
}

impl<'b> Search<'b> {
    /// Creates a search over these values, with `tries` machines per side.
    pub(super) fn new(
        off: &'b ToleranceBox,
        acting: &'b [usize],
        grid: &'b BoxGrid,
        tries: usize,
        count: usize,
    ) -> Search<'b> {
        Search {
            off,
            acting,
            grid,
            most: tries * acting.len(),
            may_turn: true,
            by: off.nothing(),
            values: vec![None; count],
        }
    }

    /// Finds the minimum of a value, or with the sign of 1 its maximum, from the extreme of `found`
    /// on the grid.
    pub(super) fn beyond_grid(
        &mut self,
        machines: &mut impl Machines,
        index: usize,
        sign: f64,
        nominal: f64,
        found: &[f64],
    ) -> DirectionExtreme {
        let rounding = rounding(nominal, found);
        let mut value = nominal;
        let mut levels = vec![0.0; self.acting.len()];
        for (place_index, &at_place) in found.iter().enumerate() {
            // The comparison also excludes NaN.
            if sign * (at_place - value) > 0.0 {
                value = at_place;
                levels = self.grid.levels(place_index);
            }
        }
        let mut step = self.grid.half_spacing();
        let mut is_inside = false;
        let mut left = self.most;
        let may_turn = self.may_turn;
        let shortest = |is_inside| match is_inside || may_turn {
            true => MIN_LEN,
            false => MIN_TRY,
        };
        while step > shortest(is_inside) && left > 0 {
            let mut leads = false;
            for side in 0..levels.len() {
                for travel in [-step, step] {
                    let before = levels[side];
                    levels[side] = (before + travel).clamp(-1.0, 1.0);
                    if levels[side] == before {
                        continue;
                    }
                    left = left.saturating_sub(1);
                    match self.read(machines, index, &levels) {
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
        DirectionExtreme { value, is_inside }
    }

    fn read(&mut self, machines: &mut impl Machines, index: usize, levels: &[f64]) -> Option<f64> {
        self.off.set_deviations(self.acting, levels, &mut self.by);
        machines.make(&self.by, &mut self.values);
        self.values[index]
    }
}
