//! Computes the sensitivity of quantities to the given lengths: the derivative of each by every
//! length, at one coordinate of the driver and in the same assembly.
//!
//! The derivatives show the effect of a length that is accurate to, say, 0.1 mm. This is usually
//! far larger than any rounding error, and the two are never mixed. The derivatives are those of
//! the solver's own formulas, see [`ByLength`](crate::solver::ByLength), not finite differences.

use super::Quantity;
use crate::scene::Scene;
use crate::solver::{ByLength, Condition, Demand, Order, Solver, State, Workspace};
use crate::{Ball, CoordinateAxis, Dual, Length};
use std::collections::HashMap;

/// Rounding error of a zero derivative, relative to the largest term of its sum.
const ROUNDING: f64 = 128.0 * f64::EPSILON;
/// Maximum size (points and links, times lengths) up to which the differentiated mechanisms are
/// kept from one coordinate to the next. Larger ones are created again each time.
const MAX_KEPT: usize = 1 << 16;

/// Computes the derivatives of quantities by the given lengths, at successive coordinates.
#[derive(Clone, Debug)]
pub struct Sensitivity {
    solver: Solver,
    figures: Vec<Quantity>,
    /// For each quantity, the index of the first one with its unit.
    alike: Vec<usize>,
    lengths: Vec<Length>,
    names: Vec<String>,
    demand: Demand,
    order: Order,
    base: Workspace,
    /// The enclosure for finding kinks, which may lie anywhere within the bounds of a formula's
    /// arguments. `None` if no formula has one.
    enclosure: Option<Workspace<Ball>>,
    /// The prepared solver of every length, once used and if there is space for all.
    ready: Vec<Option<Ready>>,
}

/// In a box, because it is taken out and put back for each state.
type Ready = Box<(ByLength, Workspace<Dual>)>;

/// Maximum number of derivatives, of all quantities by all lengths, that is useful to a reader.
pub const MAX_DERIVATIVES: usize = 1 << 22;

/// The derivatives of all quantities at one coordinate.
#[derive(Clone, Debug, PartialEq)]
pub struct Derivatives {
    lengths: usize,
    /// The derivatives by all lengths, quantity by quantity.
    numbers: Vec<f64>,
    /// Whether each quantity has derivatives. A statically indeterminate reaction has none.
    exists: Vec<bool>,
    /// Whether each quantity has a value.
    valued: Vec<bool>,
}

impl Derivatives {
    /// Returns the derivatives of a quantity by every length, in its unit per unit of length.
    /// Returns `None` if they do not exist, as for a statically indeterminate reaction.
    #[must_use]
    pub fn of(&self, index: usize) -> Option<&[f64]> {
        let exists = *self.exists.get(index)?;
        exists.then(|| &self.numbers[index * self.lengths..(index + 1) * self.lengths])
    }

    /// Returns `true` if a quantity has a value but no derivatives: its formula has a kink here.
    #[must_use]
    pub fn has_kink(&self, index: usize) -> bool {
        let [exists, valued] =
            [&self.exists, &self.valued].map(|all| all.get(index).copied().unwrap_or_default());
        valued && !exists
    }

    /// Returns the worst-case deviation of a quantity if every length is off by one unit: the sum
    /// of the derivatives' magnitudes.
    #[must_use]
    pub fn worst(&self, index: usize) -> Option<f64> {
        let all = self.of(index)?.iter();
        Some(all.map(|d| d.abs()).sum())
    }

    /// Returns the index of the length with the largest effect on a quantity, and the derivative by
    /// it; `None` if no length has an effect.
    #[must_use]
    pub fn largest_effect(&self, index: usize) -> Option<(usize, f64)> {
        let all = self.of(index)?.iter().copied().enumerate();
        let matters = all.filter(|(_, d)| *d != 0.0);
        // The first of several equal ones wins.
        matters.reduce(|maximum, other| {
            if other.1.abs() > maximum.1.abs() {
                other
            } else {
                maximum
            }
        })
    }
}

impl Sensitivity {
    /// Prepares the derivatives of quantities by all lengths of the scene. `solver` must be a
    /// complete solver for the scene's mechanism.
    #[must_use]
    pub fn new(scene: &Scene, solver: &Solver, quantities: &[Quantity]) -> Self {
        Sensitivity::by(scene, solver, quantities, scene.mechanism.lengths())
    }

    /// Prepares the derivatives of quantities by the given lengths.
    pub(crate) fn by(
        scene: &Scene,
        solver: &Solver,
        quantities: &[Quantity],
        lengths: Vec<Length>,
    ) -> Self {
        let names = lengths.iter().map(|&l| length_name(scene, l)).collect();
        let (demand, order) = super::demand(quantities);
        Sensitivity {
            solver: solver.clone(),
            figures: quantities.to_vec(),
            alike: of_one_unit(quantities),
            ready: vec![None; lengths.len()],
            lengths,
            names,
            demand,
            order,
            base: solver.state(),
            enclosure: quantities
                .iter()
                .any(Quantity::has_sides)
                .then(|| solver.enclosure()),
        }
    }

    /// Returns the quantities.
    #[must_use]
    pub fn figures(&self) -> &[Quantity] {
        &self.figures
    }

    /// Returns the names of the given lengths: `r3.length`, `r3.P.x`, `A.y`, `r4.through.x`.
    #[must_use]
    pub fn lengths(&self) -> &[String] {
        &self.names
    }

    /// Computes the derivatives at a coordinate of the driver. Returns `None` if they do not exist
    /// or would not be accurate to four digits. This is so outside the motion, at or too close to a
    /// dead point or change point, and where a changed length would lock a redundant linkage.
    pub fn at(&mut self, at: f64) -> Option<Derivatives> {
        if self.solver.solve(at, self.order, &mut self.base) != Condition::Ok {
            return None;
        }
        let count = self.lengths.len();
        let kinks = self.kinks();
        let mut bends = vec![0.0_f64; self.figures.len()];
        let mut numbers = vec![0.0; self.figures.len() * count];
        let mut exists = vec![true; self.figures.len()];
        for number in 0..count {
            let mut ready = match self.ready[number].take() {
                Some(ready) => ready,
                None => self.made(number)?,
            };
            let (by_length, workspace) = &mut *ready;
            let solved = by_length.solve(&self.base, self.order, workspace);
            for (i, quantity) in self.figures.iter().enumerate().filter(|_| solved) {
                let slope = slope(quantity, workspace);
                exists[i] &= slope.is_some();
                numbers[i * count + number] = slope.unwrap_or_default();
                if let Some(slope) = slope {
                    bends[i] = bends[i].max(bend(quantity, slope, &kinks[i], workspace));
                }
            }
            self.keep(number, ready);
            if !solved {
                return None;
            }
        }
        let nothing = self.round(&mut numbers);
        for ((exists, bend), nothing) in exists.iter_mut().zip(bends).zip(nothing) {
            *exists &= bend <= nothing;
        }
        let state = self.base.state();
        let valued = self.figures.iter().map(|f| f.value(state).is_some());
        Some(Derivatives {
            lengths: count,
            numbers,
            exists,
            valued: valued.collect(),
        })
    }

    fn made(&self, number: usize) -> Option<Ready> {
        let made = self.solver.by_length(self.lengths[number], &self.demand)?;
        let workspace = made.state();
        Some(Box::new((made, workspace)))
    }

    fn keep(&mut self, number: usize, ready: Ready) {
        let mechanism = self.solver.mechanism();
        let size = mechanism.points().len() + mechanism.links().len();
        if size * self.lengths.len() <= MAX_KEPT {
            self.ready[number] = Some(ready);
        }
    }

    /// Returns, for each quantity, the steps of its formula that may be at a kink.
    fn kinks(&mut self) -> Vec<Vec<usize>> {
        let Some(enclosure) = &mut self.enclosure else {
            return vec![Vec::new(); self.figures.len()];
        };
        self.solver.enclose(&mut self.base, self.order, enclosure);
        let quantities = self.figures.iter();
        quantities
            .map(|quantity| quantity.kinks(enclosure))
            .collect()
    }

    /// Sets derivatives that are only rounding errors to zero. Returns the threshold for each
    /// quantity.
    fn round(&self, numbers: &mut [f64]) -> Vec<f64> {
        let count = self.lengths.len().max(1);
        let mut sizes = vec![0.0_f64; self.figures.len()];
        for (i, all) in numbers.chunks(count).enumerate().take(self.figures.len()) {
            let value = self.figures[i]
                .value(self.base.state())
                .map_or(0.0, f64::abs);
            let size = &mut sizes[self.alike[i]];
            *size = size.max(value / self.solver.scale());
            *size = all.iter().fold(*size, |size, d| size.max(d.abs()));
        }
        for (&alike, all) in self.alike.iter().zip(numbers.chunks_mut(count)) {
            let nothing = ROUNDING * sizes[alike];
            let small = all.iter_mut().filter(|d| d.abs() <= nothing);
            small.for_each(|d| *d = 0.0);
        }
        let alike = self.alike.iter();
        alike.map(|&alike| ROUNDING * sizes[alike]).collect()
    }
}

/// Returns, for each quantity, the index of the first one with its unit; their derivatives are
/// compared with the largest of them. A formula's value can have any size and is compared only with
/// itself.
fn of_one_unit(quantities: &[Quantity]) -> Vec<usize> {
    let mut first: HashMap<&str, usize> = HashMap::new();
    let numbers = quantities.iter().enumerate();
    let alike = numbers.map(|(i, quantity)| match quantity.aspect() {
        Some(_) => *first.entry(&quantity.unit).or_insert(i),
        None => i,
    });
    alike.collect()
}

/// Returns the derivative of a quantity.
fn slope(quantity: &Quantity, state: &State<Dual>) -> Option<f64> {
    quantity.value(state).map(|dual| dual.slope)
}

/// Returns the maximum deviation of the derivatives on both sides of kinks from their mean. Each
/// step is switched to its other side separately, and then all of them at once.
fn bend(quantity: &Quantity, slope: f64, kinks: &[usize], state: &State<Dual>) -> f64 {
    let distance = |kinks: &[usize]| match quantity.slope_beyond(kinks, state) {
        Some(beyond) if beyond.is_finite() => (beyond - slope).abs() / 2.0,
        _ => f64::INFINITY,
    };
    let each = kinks.chunks(1).chain((kinks.len() > 1).then_some(kinks));
    each.map(distance).fold(0.0, f64::max)
}

/// Returns the name of a length in the scene: `r3.length`, `A.x`.
pub fn length_name(scene: &Scene, length: Length) -> String {
    let axis = |axis: CoordinateAxis| match axis {
        CoordinateAxis::X => "x",
        CoordinateAxis::Y => "y",
    };
    let point = |point| scene.point_name(point).unwrap_or("?");
    let seen = |link, of| match scene.mechanism.link(link).com == Some(of) {
        true => format!("{}.com", scene.link_name(link)),
        false => format!("{}.{}", scene.link_name(link), point(of)),
    };
    match length {
        Length::Link(link) => format!("{}.length", scene.link_name(link)),
        Length::Local(link, of, along) => format!("{}.{}", seen(link, of), axis(along)),
        Length::Arm(link, of) => format!("{}.length", seen(link, of)),
        Length::Across(link, of) => format!("{}.across", seen(link, of)),
        Length::Ground(of, along) => format!("{}.{}", point(of), axis(along)),
        Length::Through(slide, along) => {
            format!("{}.through.{}", scene.slide_name(slide), axis(along))
        }
    }
}
