//! A grid of places in a tolerance box: its corners, and with few sides also the midpoints between
//! them.
//!
//! The worst case lies at a corner if a value is monotonic along every side. The grid checks this
//! at its own places. A value need not be monotonic, for example next to a dead centre, or if its
//! formula has a kink.

use super::worst_case::ObservedRange;

/// Rounding error of a value, relative to its range over the box.
const ROUNDING: f64 = 1e-9;
/// Rounding error of a value, relative to its size.
const LAST_DIGITS: f64 = 1e-12;

/// A grid of places in a box.
pub(super) struct BoxGrid {
    sides: usize,
    levels: usize,
}

impl BoxGrid {
    /// Creates a grid, including the midpoints if there are at most `middles` sides.
    pub(super) fn of(sides: usize, middles: usize) -> BoxGrid {
        let levels = if sides <= middles { 3 } else { 2 };
        BoxGrid { sides, levels }
    }

    /// Returns the number of places. A grid without midpoints is followed by the centres of the
    /// box's faces.
    pub(super) fn count(&self) -> usize {
        self.corners() + if self.levels == 2 { 2 * self.sides } else { 0 }
    }

    fn corners(&self) -> usize {
        (0..self.sides).fold(1, |count, _| count * self.levels)
    }

    /// Returns all places in an order in which neighbours differ along one side: a Gray code. The
    /// centres of faces come last.
    pub(super) fn walk(&self) -> impl Iterator<Item = usize> {
        let corners = self.corners();
        let reflected = (0..corners).map(|number| {
            let (mut rest, mut stride, mut place) = (number, 1, 0);
            while rest > 0 {
                let (level, above) = (rest % self.levels, rest / self.levels);
                // Every other pass along a side runs backwards.
                let level = match above % 2 {
                    0 => level,
                    _ => self.levels - 1 - level,
                };
                place += level * stride;
                (rest, stride) = (above, stride * self.levels);
            }
            place
        });
        reflected.chain(corners..self.count())
    }

    /// Returns half the distance of neighbouring places along a side, relative to a tolerance.
    pub(super) fn half_spacing(&self) -> f64 {
        1.0 / (self.levels - 1) as f64
    }

    /// Returns the position of a place along every side, in [-1, 1].
    pub(super) fn levels(&self, index: usize) -> Vec<f64> {
        let mut levels = vec![0.0; self.sides];
        if let Some(face) = index.checked_sub(self.corners()) {
            levels[face / 2] = [-1.0, 1.0][face % 2];
            return levels;
        }
        let mut rest = index;
        for level in &mut levels {
            *level = 2.0 * (rest % self.levels) as f64 / (self.levels - 1) as f64 - 1.0;
            rest /= self.levels;
        }
        levels
    }

    /// Returns `true` if a value is monotonic along every side; `found` holds the value at every
    /// place.
    pub(super) fn is_monotonic(&self, nominal: f64, found: &[f64]) -> bool {
        let rounding = rounding(nominal, found);
        (0..self.sides).all(|side| self.is_monotonic_along(side, nominal, found, rounding))
    }

    fn is_monotonic_along(&self, side: usize, nominal: f64, found: &[f64], rounding: f64) -> bool {
        let stride = (0..side).fold(1, |stride, _| stride * self.levels);
        let corners = self.corners();
        let steps = (0..corners).filter(|index| index / stride % self.levels < self.levels - 1);
        let along = steps.map(|index| found[index + stride] - found[index]);
        let faces = found.get(corners + 2 * side..corners + 2 * side + 2);
        let through = faces.map_or([0.0; 2], |faces| [nominal - faces[0], faces[1] - nominal]);
        let (mut rises, mut falls) = (false, false);
        for step in along.chain(through) {
            rises |= step > rounding;
            falls |= step < -rounding;
        }
        !(rises && falls)
    }
}

/// Returns the rounding error of a value found at every place; NaN marks missing values.
pub(super) fn rounding(nominal: f64, found: &[f64]) -> f64 {
    let mut met = ObservedRange::of(nominal);
    let values = found.iter().filter(|value| value.is_finite());
    values.for_each(|&value| met.meet(value));
    let ObservedRange { low, high } = met;
    (ROUNDING * (high - low)).max(LAST_DIGITS * low.abs().max(high.abs()))
}

#[cfg(test)]
mod tests {
    use super::BoxGrid;

    #[test]
    fn walk_visits_each_place_once_and_moves_along_one_side_at_a_time() {
        for (sides, middles) in [(1, 9), (4, 9), (5, 0)] {
            let grid = BoxGrid::of(sides, middles);
            let walk: Vec<usize> = grid.walk().collect();
            let mut sorted = walk.clone();
            sorted.sort_unstable();
            assert!(sorted.into_iter().eq(0..grid.count()));
            for pair in walk[..grid.corners()].windows(2) {
                let [here, next] = [pair[0], pair[1]].map(|place| grid.levels(place));
                let travels = here.iter().zip(&next).map(|(a, b)| (a - b).abs());
                assert_eq!(
                    travels.sum::<f64>(),
                    2.0 * grid.half_spacing(),
                    "{here:?} {next:?}"
                );
            }
        }
    }
}
