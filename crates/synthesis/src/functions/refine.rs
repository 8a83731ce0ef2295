//! Minimises the squares of the output's error by the method of Levenberg and Marquardt with exact
//! derivatives.
//!
//! The residual is the error of the output: the linkage's angle or travel less the wanted one. It
//! is not the residual of Freudenstein's equation, which weights a pair by the transmission angle
//! there. If the output's scale is free, the miss is measured in units of y, since a scale of 0
//! would meet every pair.

use super::linkage::FunctionLinkage;
use super::task::{FunctionLaw, TargetFunction, wrapped};
use crate::Output;
use kinematics::numeric::DampedSearch;
use nalgebra::{SMatrix, SVector};

/// Three lengths and four numbers of the law.
const NUMBERS: usize = 7;

type DesignNumbers = SVector<f64, NUMBERS>;

/// A linkage, its law, and the side of its crank's pin on which its output lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FunctionDesign {
    pub(super) linkage: FunctionLinkage,
    pub(super) law: FunctionLaw,
    pub(super) side: f64,
}

/// The sum of squares at a point, and its derivatives J as a triangle: J = Q R, `goal` = Q'r. The
/// numbers of a smooth function are nearly dependent, and J'J would square the condition number.
#[derive(Clone)]
struct MissSlopes {
    sum: f64,
    triangle: SMatrix<f64, NUMBERS, NUMBERS>,
    goal: DesignNumbers,
}

impl FunctionDesign {
    fn numbers(&self) -> DesignNumbers {
        let ([a, b], [c, d]) = (self.law.crank, self.law.output);
        let lengths = &self.linkage;
        DesignNumbers::from([lengths.crank, lengths.coupler, lengths.third, a, b, c, d])
    }

    fn with(&self, numbers: &DesignNumbers) -> FunctionDesign {
        let n = numbers;
        FunctionDesign {
            linkage: FunctionLinkage {
                crank: n[0],
                coupler: n[1].abs(),
                third: n[2],
                ..self.linkage
            },
            law: FunctionLaw {
                crank: [n[3], n[4]],
                output: [n[5], n[6]],
            },
            side: self.side,
        }
    }

    /// Returns the output's miss at a pair, in the unit of the residuals; `None` if the linkage
    /// does not close there.
    pub(super) fn miss(&self, target: &TargetFunction, [x, y]: [f64; 2]) -> Option<f64> {
        let [datum, scale] = self.law.output;
        let angle = self.law.crank[0] + self.law.crank[1] * x;
        let made = self.linkage.output(angle, self.side)?;
        let miss = output_difference(target.output, made - datum - scale * y);
        Some(miss / unit(target, scale))
    }

    /// Returns the root mean square of the misses; `None` if the linkage does not close at every
    /// pair.
    pub(super) fn rms(&self, target: &TargetFunction) -> Option<f64> {
        let mut sum = 0.0;
        for pair in &target.pairs {
            sum += self.miss(target, *pair)?.powi(2);
        }
        let rms = (sum / target.pairs.len() as f64).sqrt();
        rms.is_finite().then_some(rms)
    }

    /// Returns the design on the side with the smaller sum of squares, and this sum. Pairs at which
    /// the linkage does not close count too.
    pub(super) fn on_the_better_side(self, target: &TargetFunction) -> (FunctionDesign, f64) {
        let sum = |side: f64| {
            let there = FunctionDesign { side, ..self };
            (there, there.slopes(target).sum)
        };
        let (one, other) = (sum(1.0), sum(-1.0));
        if other.1 < one.1 { other } else { one }
    }

    /// Returns the minimum reached by descent, or the design after `steps` steps. Returns `None` if
    /// the result is not a sound linkage, or does not close at every pair.
    pub(super) fn refined(self, target: &TargetFunction, steps: usize) -> Option<FunctionDesign> {
        let (mut here, mut slopes) = (self, self.slopes(target));
        let rules = DampedSearch {
            steps,
            shrinking: 0.15,
            ..DampedSearch::DEFAULT
        };
        rules.run(slopes.sum, |damping| {
            let next = here.with(&(here.numbers() - slopes.step(damping)));
            let there = next.slopes(target);
            (there.sum < slopes.sum).then(|| {
                (here, slopes) = (next, there);
                slopes.sum
            })
        });
        (here.linkage.is_valid() && here.rms(target).is_some()).then_some(here)
    }

    /// Returns `true` if all numbers agree up to a relative tolerance.
    pub(super) fn is_near(&self, other: &FunctionDesign, part: f64) -> bool {
        let (a, b) = (self.numbers(), other.numbers());
        let mut pairs = a.iter().zip(b.iter());
        self.side == other.side && pairs.all(|(a, b)| (a - b).abs() <= part * (1.0 + a.abs()))
    }

    fn slopes(&self, target: &TargetFunction) -> MissSlopes {
        let [datum, scale] = self.law.output;
        let unit = unit(target, scale);
        let free = free(target);
        let row =
            |n: [f64; NUMBERS]| DesignNumbers::from_fn(|i, _| if free[i] { n[i] } else { 0.0 });
        let mut slopes = MissSlopes {
            sum: 0.0,
            triangle: SMatrix::zeros(),
            goal: DesignNumbers::zeros(),
        };
        for &[x, y] in &target.pairs {
            let angle = self.law.crank[0] + self.law.crank[1] * x;
            let reach = self.linkage.reach(angle, self.side);
            let miss = output_difference(target.output, reach.output - datum - scale * y) / unit;
            let by = |d: [f64; 4]| [d[0], d[1], d[2], d[3], d[3] * x];
            let [a, b, c, d, e] = by(reach.by).map(|d| d / unit);
            let by_scale = -y / unit - miss / scale;
            slopes.add(miss, row([a, b, c, d, e, -1.0 / unit, by_scale]));
            if reach.short > 0.0 {
                let [a, b, c, d, e] = by(reach.shortfall);
                slopes.add(reach.short, row([a, b, c, d, e, 0.0, 0.0]));
            }
        }
        if !slopes.sum.is_finite() {
            slopes.sum = f64::INFINITY;
        }
        slopes
    }
}

impl MissSlopes {
    /// Adds a row of J, with its residual, to the triangle by Givens rotations.
    fn add(&mut self, miss: f64, by: DesignNumbers) {
        self.sum += miss * miss;
        self.turn_in(miss, by);
    }

    fn turn_in(&mut self, mut miss: f64, mut by: DesignNumbers) {
        for i in 0..NUMBERS {
            if by[i] == 0.0 {
                continue;
            }
            let size = self.triangle[(i, i)].hypot(by[i]);
            let (cos, sin) = (self.triangle[(i, i)] / size, by[i] / size);
            for j in i..NUMBERS {
                let (above, below) = (self.triangle[(i, j)], by[j]);
                self.triangle[(i, j)] = cos * above + sin * below;
                by[j] = cos * below - sin * above;
            }
            let above = self.goal[i];
            self.goal[i] = cos * above + sin * miss;
            miss = cos * miss - sin * above;
        }
    }

    /// Returns the decrement of the numbers, each damped by the size of its own derivatives.
    fn step(&self, damping: f64) -> DesignNumbers {
        let mut damped = self.clone();
        for i in 0..NUMBERS {
            let mut row = DesignNumbers::zeros();
            row[i] = damping.sqrt() * self.triangle.column(i).norm();
            damped.turn_in(0.0, row);
        }
        let mut way = DesignNumbers::zeros();
        for i in (0..NUMBERS).rev() {
            let rest: f64 = (i + 1..NUMBERS)
                .map(|j| damped.triangle[(i, j)] * way[j])
                .sum();
            let pivot = damped.triangle[(i, i)];
            if pivot != 0.0 {
                way[i] = (damped.goal[i] - rest) / pivot;
            }
        }
        way
    }
}

/// Returns the unit of the misses: the span of y if the output's scale is free, or else 1.
fn unit(target: &TargetFunction, scale: f64) -> f64 {
    if target.given[3].is_none() {
        scale * target.span(1)
    } else {
        1.0
    }
}

fn output_difference(output: Output, difference: f64) -> f64 {
    match output {
        Output::Angle => wrapped(difference),
        Output::Slide => difference,
    }
}

fn free(target: &TargetFunction) -> [bool; NUMBERS] {
    let law = target.given.map(|given| given.is_none());
    let is_angle = target.output == Output::Angle;
    [is_angle, true, true, law[0], law[1], law[2], law[3]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use kinematics::numeric::SeededRng;

    /// R'Q'r = J'r is half the slope of the sum of squares.
    #[test]
    fn slopes_match_difference_quotients() {
        let mut rng = SeededRng::new(11);
        for round in 0..200 {
            let output = if round % 2 == 0 {
                Output::Angle
            } else {
                Output::Slide
            };
            let mut number = || 1.0 + 0.4 * rng.even();
            let target = TargetFunction {
                output,
                pairs: (0..5).map(|_| [number(), number()]).collect(),
                given: [None, None, None, (round % 4 < 2).then_some(1.2)],
            };
            let mut numbers = DesignNumbers::from_fn(|_, _| number());
            numbers[1] += 1.0;
            numbers[6] = target.given[3].unwrap_or(numbers[6]);
            let linkage = FunctionLinkage {
                output,
                crank: 1.0,
                coupler: 1.0,
                third: 1.0,
            };
            let law = FunctionLaw {
                crank: [0.0; 2],
                output: [0.0; 2],
            };
            let any = FunctionDesign {
                linkage,
                law,
                side: 1.0,
            };
            let here = any.with(&numbers).slopes(&target);
            let free = free(&target);
            for i in (0..NUMBERS).filter(|&i| free[i]) {
                let mut by = DesignNumbers::zeros();
                by[i] = 1e-6;
                let [above, below] =
                    [numbers + by, numbers - by].map(|n| any.with(&n).slopes(&target).sum);
                let slope = (above - below) / 4e-6;
                let pull = here.triangle.column(i).dot(&here.goal);
                let size = 1.0 + here.sum + here.triangle.column(i).norm_squared();
                assert!(
                    (slope - pull).abs() < 1e-4 * size,
                    "{round} {i} {slope} {pull}"
                );
            }
        }
    }
}
