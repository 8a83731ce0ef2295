//! How figures answer to the given lengths: the derivative of each by every length, at one coordinate of
//! the driver and on the same assembly.
//!
//! This says what an input that is good to 0.1 mm does to a figure, which mostly is far more than any
//! rounding; the two are never mixed. One length at a time is changed a little, to both sides and by two
//! steps, in a mechanism that is made ready again; from the two central differences
//!
//! ```text
//! D(h) = (f(l + h) - f(l - h)) / 2h = f' + h^2 f'''/6 + ...        D = (4 D(h/2) - D(h)) / 3
//! ```
//!
//! Richardson's extrapolation D is right to the fourth order. Where the motion ends near by, as at a dead
//! point, f''' is large: then smaller steps are taken until the two differences agree.

use super::{Aspect, Quantity};
use crate::scene::Scene;
use crate::solver::{Condition, Order, Perturbed, Solver, Workspace};
use crate::{Axis, Length, Mechanism, angle};

/// The steps to try, in parts of the longest length: 2 to these powers. The first leaves about 3e-13 of
/// a figure to rounding and less to the fourth order; the last still tells four digits.
const STEPS: [i32; 7] = [-11, -15, -19, -23, -27, -31, -35];
/// The two differences agree when they differ by less than this part of the largest derivative of the
/// kind. What is left behind the extrapolation is about the square of it.
const AGREED: f64 = 1.0 / 16384.0;
/// What a difference of two figures has of their rounding, in parts of the largest figure of the kind: 32
/// units of 2^-53. Derivatives that are no larger than what this makes of them are 0.
const ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Mechanisms beside the first are kept from one coordinate to the next as long as they are no more than
/// this many points and links; others are made again each time.
const MOST_KEPT: usize = 1 << 17;
/// Where the figures of one length are read: at these multiples of the step.
const PLACES: [f64; 4] = [1.0, -1.0, 0.5, -0.5];

/// Finds the derivatives of figures by the given lengths, at one coordinate after the other.
#[derive(Clone, Debug)]
pub struct Sensitivity {
    mechanism: Mechanism,
    solver: Solver,
    figures: Vec<Quantity>,
    lengths: Vec<Length>,
    names: Vec<String>,
    order: Order,
    base: Workspace,
    /// For every step, once it was taken: for every length the mechanisms at [`PLACES`].
    kept: Vec<Vec<Option<Beside>>>,
}

/// More derivatives than this, of all figures by all lengths, are more than anybody reads.
pub const MOST_DERIVATIVES: usize = 1 << 22;

type Beside = [(Perturbed, Workspace); PLACES.len()];

/// The derivatives of all figures at one coordinate.
#[derive(Clone, Debug, PartialEq)]
pub struct Derivatives {
    lengths: usize,
    /// Figure by figure, for each all lengths.
    numbers: Vec<f64>,
}

impl Derivatives {
    /// The derivatives of a figure by every length: its unit per unit of length.
    #[must_use]
    pub fn of(&self, figure: usize) -> &[f64] {
        &self.numbers[figure * self.lengths..(figure + 1) * self.lengths]
    }

    /// By how much a figure is off at the worst, where every length is off by one unit: the sum of the
    /// derivatives' sizes.
    #[must_use]
    pub fn worst(&self, figure: usize) -> f64 {
        self.of(figure).iter().map(|d| d.abs()).sum()
    }

    /// The length that matters most to a figure, by its place in the list, and the derivative by it;
    /// `None` where no length matters.
    #[must_use]
    pub fn most(&self, figure: usize) -> Option<(usize, f64)> {
        let all = self.of(figure).iter().copied().enumerate();
        let matters = all.filter(|(_, d)| *d != 0.0);
        // The first of equals.
        matters.reduce(|most, other| {
            if other.1.abs() > most.1.abs() {
                other
            } else {
                most
            }
        })
    }
}

impl Sensitivity {
    /// Of these figures, in a solver for the scene's mechanism with nothing left out.
    #[must_use]
    pub fn new(scene: &Scene, solver: &Solver, figures: &[Quantity]) -> Self {
        let lengths = scene.mechanism.lengths();
        let names = lengths.iter().map(|&l| name(scene, l)).collect();
        Sensitivity {
            mechanism: scene.mechanism.clone(),
            solver: solver.clone(),
            figures: figures.to_vec(),
            lengths,
            names,
            order: super::demand(figures).1,
            base: solver.state(),
            kept: STEPS.map(|_| Vec::new()).into(),
        }
    }

    /// The figures that are asked about.
    #[must_use]
    pub fn figures(&self) -> &[Quantity] {
        &self.figures
    }

    /// The names of the given lengths: `r3.length`, `r3.P.x`, `A.y`, `r4.through.x`.
    #[must_use]
    pub fn lengths(&self) -> &[String] {
        &self.names
    }

    /// The derivatives at a coordinate of the driver. `None` where they do not exist, or cannot be had:
    /// outside the motion, at a dead point or a change point and too close to one, and where a length
    /// that is off would jam a redundant linkage.
    pub fn at(&mut self, at: f64) -> Option<Derivatives> {
        if self.solver.solve(at, self.order, &mut self.base) != Condition::Ok {
            return None;
        }
        (0..STEPS.len()).find_map(|step| self.by_step(step))
    }

    /// By one step; `None` where a changed mechanism does not exist, or where the differences do not agree.
    fn by_step(&mut self, step: usize) -> Option<Derivatives> {
        let h = self.solver.scale() * f64::from(STEPS[step]).exp2();
        let count = self.lengths.len();
        let mut numbers = vec![0.0; self.figures.len() * count];
        let mut kinds = [Kind::default(); Kind::COUNT];
        for length in 0..count {
            let beside = match self.take(step, length) {
                Some(beside) => beside,
                None => self.made(length, h)?,
            };
            let solved = self.solved(beside)?;
            for (i, figure) in self.figures.iter().enumerate() {
                let [over, under, half_over, half_under] = read(figure, &solved)?;
                let wide = apart(figure, over, under) / (2.0 * h);
                let narrow = apart(figure, half_over, half_under) / h;
                kinds[Kind::of(figure)].note(wide, narrow, over);
                numbers[i * count + length] = narrow + (narrow - wide) / 3.0;
            }
            self.keep(step, length, solved);
        }
        let agreed = kinds.iter().all(|kind| kind.agrees(h));
        agreed.then(|| {
            for (all, figure) in numbers.chunks_mut(count.max(1)).zip(&self.figures) {
                let least = kinds[Kind::of(figure)].noise(h);
                all.iter_mut()
                    .filter(|d| d.abs() <= least)
                    .for_each(|d| *d = 0.0);
            }
            Derivatives {
                lengths: count,
                numbers,
            }
        })
    }

    /// The mechanisms with one length changed.
    fn made(&self, length: usize, h: f64) -> Option<Beside> {
        let make = |place: f64| {
            let changed = self.mechanism.changed(self.lengths[length], place * h);
            let perturbed = self.solver.perturbed(&changed)?;
            let state = perturbed.state();
            Some((perturbed, state))
        };
        let [a, b, c, d] = PLACES.map(make);
        Some([a?, b?, c?, d?])
    }

    /// All four solved beside the base.
    fn solved(&self, mut beside: Beside) -> Option<Beside> {
        let mut all = beside.iter_mut();
        let solved = all.all(|(perturbed, state)| {
            perturbed.solve(&self.base, self.order, state) == Condition::Ok
        });
        solved.then_some(beside)
    }

    fn take(&mut self, step: usize, length: usize) -> Option<Beside> {
        self.kept[step].get_mut(length)?.take()
    }

    fn keep(&mut self, step: usize, length: usize, beside: Beside) {
        let mechanism = &self.mechanism;
        let size = mechanism.points().len() + mechanism.links().len();
        if size * self.lengths.len() > MOST_KEPT {
            return;
        }
        let kept = &mut self.kept[step];
        if kept.len() <= length {
            kept.resize_with(self.lengths.len(), || None);
        }
        kept[length] = Some(beside);
    }
}

/// A figure in four states.
fn read(figure: &Quantity, beside: &Beside) -> Option<[f64; PLACES.len()]> {
    let [a, b, c, d] = beside.each_ref().map(|(_, state)| figure.value(state));
    Some([a?, b?, c?, d?])
}

/// The difference of two values of a figure; of directions, the shorter way.
fn apart(figure: &Quantity, over: f64, under: f64) -> f64 {
    let apart = over - under;
    if figure.aspect == Aspect::Angle {
        apart - angle::TURN * (apart / angle::TURN).round()
    } else {
        apart
    }
}

/// What is known of all figures of one unit by all lengths: derivatives of one kind are measured by the
/// largest.
#[derive(Clone, Copy, Debug, Default)]
struct Kind {
    largest: f64,
    disagreement: f64,
    value: f64,
}

impl Kind {
    const COUNT: usize = 9;

    fn of(figure: &Quantity) -> usize {
        let order = match figure.aspect.order() {
            Order::Position => 0,
            Order::Velocity => 1,
            Order::Acceleration | Order::Force => 2,
        };
        match figure.aspect {
            Aspect::Angle | Aspect::Omega | Aspect::Alpha => 3 + order,
            Aspect::X | Aspect::Y | Aspect::Vx | Aspect::Vy | Aspect::Ax | Aspect::Ay => order,
            Aspect::Length | Aspect::Rate | Aspect::Accel => order,
            Aspect::Torque | Aspect::Moment => 6,
            Aspect::Force | Aspect::Fx | Aspect::Fy | Aspect::Normal => 7,
            Aspect::Power => 8,
        }
    }

    fn note(&mut self, wide: f64, narrow: f64, value: f64) {
        self.largest = self.largest.max(narrow.abs());
        self.disagreement = self.disagreement.max((narrow - wide).abs());
        self.value = self.value.max(value.abs());
    }

    /// What rounding makes of a difference.
    fn noise(&self, h: f64) -> f64 {
        ROUNDING * self.value / h
    }

    fn agrees(&self, h: f64) -> bool {
        self.disagreement <= AGREED * self.largest + self.noise(h)
    }
}

/// As the scene names it.
fn name(scene: &Scene, length: Length) -> String {
    let axis = |axis: Axis| match axis {
        Axis::X => "x",
        Axis::Y => "y",
    };
    let point = |point| scene.point_name(point).unwrap_or("?");
    match length {
        Length::Link(link) => format!("{}.length", scene.link_name(link)),
        Length::Local(link, of, along) if scene.mechanism.link(link).com == Some(of) => {
            format!("{}.com.{}", scene.link_name(link), axis(along))
        }
        Length::Local(link, of, along) => {
            let link = scene.link_name(link);
            format!("{link}.{}.{}", point(of), axis(along))
        }
        Length::Ground(of, along) => format!("{}.{}", point(of), axis(along)),
        Length::Through(slide, along) => {
            format!("{}.through.{}", scene.slide_name(slide), axis(along))
        }
    }
}
