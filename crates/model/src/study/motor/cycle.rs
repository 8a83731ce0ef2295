//! The results of a cycle.

use super::course::Course;
use super::periodic::{Means, Periodic, periodic};
use super::pieces::{Pieces, Sampler, SmoothPiece};
use super::{CHANNELS, DriverUnits, Effort, MOMENT, TORQUES};
use crate::Vec2;
use crate::numeric::chebyshev::{Basis, crossings};

/// A maximum or minimum, and its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// The value.
    pub value: f64,
    /// The driver's coordinate, in degrees or in the scene's length unit.
    pub at: f64,
    /// `true` on the way back of a driver that moves to and fro.
    pub back: bool,
}

/// The driving torque over the cycle, or one part of it. A value that does not exist is `None`: the
/// torque may grow without bound towards a dead point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DriveEffort {
    /// The maximum torque, in N m, or force, in N.
    pub largest: Option<Peak>,
    /// The minimum torque or force; if negative, the maximum in the opposite direction.
    pub least: Option<Peak>,
    /// The maximum power in W.
    pub largest_power: Option<Peak>,
    /// The minimum power in W; if negative, it flows back to the driver.
    pub least_power: Option<Peak>,
    /// The mean torque over the cycle.
    pub mean: Option<f64>,
    /// The root mean square of the torque.
    pub rms: Option<f64>,
    /// The driver's work while its power is positive, in J per cycle.
    pub put_in: Option<f64>,
    /// The returned work while its power is negative, in J per cycle, as a positive number.
    pub given_back: Option<f64>,
}

impl DriveEffort {
    /// Returns the torque with the largest absolute value: the worst instant.
    #[must_use]
    pub fn worst(&self) -> Option<Peak> {
        let (largest, least) = (self.largest?, self.least?);
        Some(if largest.value >= -least.value {
            largest
        } else {
            least
        })
    }

    /// Returns the net work of a cycle in J: the input minus the returned work.
    #[must_use]
    pub fn work(&self) -> Option<f64> {
        Some(self.put_in? - self.given_back?)
    }

    /// Returns `true` if this part consists of the rounding errors of the others.
    #[must_use]
    pub fn is_nothing_beside(&self, others: &[DriveEffort]) -> bool {
        let energy = |e: &DriveEffort| Some(e.put_in? + e.given_back?);
        let all = others.iter().filter_map(energy).fold(0.0, f64::max);
        energy(self).is_some_and(|own| own <= ROUNDING * all)
    }
}

/// The fluctuation of the driver's work about that of its mean torque over the cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fluctuation {
    /// The difference between the largest excess and the largest deficit, in J.
    pub energy: f64,
    /// The coordinate at which a driver of constant torque would be slowest: the mechanism has
    /// absorbed the most energy.
    pub slowest: f64,
    /// The coordinate at which it would be fastest.
    pub fastest: f64,
}

/// The shaking force and moment on the ground.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CycleShaking {
    /// The largest force in N.
    pub force: Option<Peak>,
    /// The largest force as a vector in N.
    pub vector: Option<Vec2>,
    /// The root mean square of the force in N.
    pub force_rms: Option<f64>,
    /// The moment about the scene's origin with the largest absolute value, in N m.
    pub moment: Option<Peak>,
    /// The root mean square of the moment in N m.
    pub moment_rms: Option<f64>,
}

/// The quadrature rule of the means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// The trapezoidal rule with this number of places on a smooth periodic cycle.
    Periodic(usize),
    /// Sums of polynomials on this number of pieces.
    Pieces(usize),
}

/// The analysis of the driver over one cycle.
#[derive(Clone, Debug)]
pub struct Cycle {
    /// The driver's travel.
    pub course: Course,
    /// The absolute value of the driver's speed, in rad/s or m/s.
    pub speed: f64,
    /// The total driving torque.
    pub all: DriveEffort,
    /// Its parts due to loads, gravity and inertia.
    pub parts: [DriveEffort; 3],
    /// `None` if the driver does not turn fully, or if the torque is unknown.
    pub fluctuation: Option<Fluctuation>,
    /// The forces on the ground.
    pub shaking: CycleShaking,
    /// The quadrature rule of the means.
    pub rule: Rule,
    /// The error estimate of the means, relative to the largest torque: the difference of the last
    /// two rules, or the contribution of the last terms of all sums.
    pub error: f64,
    /// The number of solved states.
    pub states: usize,
    pieces: Pieces,
    /// The work in J of a torque of 1 over a travel of 1.
    joule: f64,
}

/// The distance of peaks from which on they are different places, relative to the travel.
const APART: f64 = 1e-4;
/// The rounding error of a cancellation, relative to the terms.
const ROUNDING: f64 = 1e-12;
/// The difference of the torques at the ends of two pieces below which they are continuous,
/// relative to the largest torque.
const JUMP: f64 = 1e-6;
/// A distance inside a piece, relative to its length.
const INSIDE: f64 = 1e-9;
/// The error above which means are not trusted.
const CONVERGED: f64 = 1e-10;

impl Cycle {
    /// Analyses a cycle. `effort` solves at a coordinate; its second argument is `true` on the way
    /// back. `marks` are the travels at which a load has a kink or jumps; 0 if the end does not
    /// continue at the beginning.
    pub fn new(
        course: Course,
        marks: &[f64],
        measure: DriverUnits,
        effort: &mut dyn FnMut(f64, bool) -> Option<Effort>,
    ) -> Cycle {
        let mut sampler = Sampler {
            course,
            basis: Basis::new(),
            measure,
            effort,
        };
        let pieces = Pieces::cut(&mut sampler, &sorted(marks, &course));
        let smooth = course.goes_round && marks.is_empty() && !pieces.has_gap;
        let means = smooth
            .then(|| periodic(&mut sampler, |i| pieces.size(i), CONVERGED))
            .flatten();
        let error = pieces.error.iter().fold(0.0, |most: f64, e| most.max(*e));
        let mut cycle = Cycle {
            course,
            speed: measure.speed.abs(),
            all: DriveEffort::default(),
            parts: [DriveEffort::default(); 3],
            fluctuation: None,
            shaking: CycleShaking::default(),
            rule: means.map_or(Rule::Pieces(pieces.list.len()), |m| {
                Rule::Periodic(m.places)
            }),
            error: means.map_or(error, |means| means.error),
            states: pieces.states + means.map_or(0, |means| 2 * means.places),
            pieces,
            joule: measure.joule,
        };
        if !cycle.pieces.has_gap {
            cycle.read(means);
        }
        cycle
    }

    /// Returns `true` if the means are accurate to 10 digits.
    #[must_use]
    pub fn has_converged(&self) -> bool {
        !self.pieces.has_gap && self.error <= CONVERGED
    }

    /// Returns the torque, its parts, and the force and moment on the ground after this travel,
    /// from the sums; `None` if they do not exist.
    #[must_use]
    pub fn at(&self, way: f64) -> Option<Effort> {
        let mut channels = self.pieces.at(way)?;
        let weight = self.course.place(way).weight;
        channels[..TORQUES].iter_mut().for_each(|c| *c /= weight);
        let [torque, load, gravity, inertia, x, y, moment] = channels;
        let effort = Effort {
            torque,
            parts: [load, gravity, inertia],
            force: Vec2::new(x, y),
            moment,
        };
        channels.iter().all(|c| c.is_finite()).then_some(effort)
    }

    /// Returns the work in J of a torque of 1 over one unit of the travel.
    pub(super) fn joule(&self) -> f64 {
        self.joule
    }

    /// Returns the driver's work in J from the beginning to this travel; `None` if the torque is
    /// not known everywhere.
    #[must_use]
    pub fn work(&self, way: f64) -> Option<f64> {
        if self.pieces.has_gap {
            return None;
        }
        if way <= 0.0 {
            return Some(0.0);
        }
        let mut work = 0.0;
        for piece in &self.pieces.list {
            let integral = piece.sums[0].integral();
            if way <= piece.to {
                return Some((work + integral.at(piece.t(way)) * piece.half()) * self.joule);
            }
            work += integral.at(1.0) * piece.half();
        }
        Some(work * self.joule)
    }

    /// Returns 1 if the driver's coordinate increases with the travel, or -1: the sign of the
    /// speed, for the power of a torque.
    #[must_use]
    pub fn sense(&self, way: f64) -> f64 {
        self.course.place(way).weight.signum()
    }

    /// Returns the torque over the driver's coordinate in at least `points` points: pairs of
    /// coordinate and torque, split at jumps.
    #[must_use]
    pub fn curve(&self, points: u32) -> Vec<Vec<[f64; 2]>> {
        let mut parts: Vec<Vec<[f64; 2]>> = Vec::new();
        let once = 0.5 * self.course.length();
        let mut end = None;
        for piece in &self.pieces.list {
            let share = (piece.to - piece.from) / self.course.length();
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a part of a number of points"
            )]
            let steps = (share * f64::from(points)).ceil().max(1.0) as u32;
            let point = |k: u32| {
                let t = 2.0 * f64::from(k) / f64::from(steps) - 1.0;
                // At the reversal, the weight of the piece's own side.
                let way = piece.way(t);
                let weight = self
                    .course
                    .place(way.clamp(piece.way(-1.0 + INSIDE), piece.way(1.0 - INSIDE)))
                    .weight;
                [self.course.place(way).at, piece.sums[0].at(t) / weight]
            };
            let first = point(0);
            let turns = !self.course.goes_round && piece.from == once;
            let jumps =
                end.is_none_or(|end: f64| (end - first[1]).abs() > JUMP * self.pieces.scale[0]);
            if jumps || turns {
                parts.push(Vec::new());
            }
            if let Some(part) = parts.last_mut() {
                part.extend(
                    (0..=steps)
                        .map(point)
                        .filter(|[_, torque]| torque.is_finite()),
                );
            }
            end = Some(point(steps)[1]);
        }
        parts.retain(|part| !part.is_empty());
        parts
    }

    /// Returns the driver's coordinate after this travel.
    #[must_use]
    pub fn coordinate(&self, way: f64) -> f64 {
        self.course.place(way).at
    }

    fn read(&mut self, means: Option<Periodic>) {
        let means = means.map_or_else(|| self.means(), |periodic| periodic.means);
        let effect = |channel| self.effect(channel, &means);
        let [all, load, gravity, inertia]: [DriveEffort; TORQUES] = std::array::from_fn(effect);
        self.all = all;
        self.parts = [load, gravity, inertia];
        if self.course.goes_round {
            self.fluctuation = self.fluctuate(means.mean[0]);
        }
        if !self.course.ends_dead {
            self.shaking = self.shake(&means);
        }
    }

    /// Computes the means from the sums.
    fn means(&self) -> Means {
        let mut means = Means::default();
        let length = self.course.length();
        for piece in &self.pieces.list {
            let share = piece.half() / length;
            for (i, sum) in piece.sums.iter().enumerate() {
                means.mean[i] += share * sum.integral().at(1.0);
                means.square[i] += share * sum.product(sum);
            }
        }
        means
    }

    fn effect(&self, channel: usize, means: &Means) -> DriveEffort {
        let (mut put_in, mut given_back, mut signed) = (0.0, 0.0, 0.0);
        let mut largest: [Option<Peak>; 4] = [None; 4];
        for piece in &self.pieces.list {
            let sum = &piece.sums[channel];
            let turns = sum.turns();
            let zeros = sum.zeros(&turns);
            let integral = sum.integral();
            let mut before = 0.0;
            for &t in zeros.iter().chain(&[1.0]) {
                let here = integral.at(t);
                let gain = (here - before) * piece.half();
                put_in += gain.max(0.0);
                given_back -= gain.min(0.0);
                before = here;
            }
            let sense = self.course.place(piece.way(0.0)).weight.signum();
            signed += sense * before * piece.half();
            for &t in turns.iter().chain(&[-1.0, 1.0]) {
                let value = sum.at(t);
                let [high, low, high_power, low_power] = &mut largest;
                self.raise(high, sense * value, piece, t);
                self.raise(low, -sense * value, piece, t);
                self.raise(high_power, value, piece, t);
                self.raise(low_power, -value, piece, t);
            }
        }
        let regular = !self.course.ends_dead;
        let [high, low, high_power, low_power] = largest.map(|peak| peak.filter(|_| regular));
        let times = |peak: Option<Peak>, factor: f64| {
            peak.map(|peak| Peak {
                value: peak.value * factor,
                ..peak
            })
        };
        let mean = if self.course.goes_round {
            means.mean[channel] * if self.course.falls { -1.0 } else { 1.0 }
        } else {
            signed / self.course.length()
        };
        DriveEffort {
            largest: high,
            least: times(low, -1.0),
            largest_power: times(high_power, self.speed),
            least_power: times(low_power, -self.speed),
            mean: Some(mean),
            rms: regular.then(|| means.root(channel)),
            put_in: Some(put_in * self.joule),
            given_back: Some(given_back * self.joule),
        }
    }

    /// Replaces a peak if the value is larger.
    fn raise(&self, peak: &mut Option<Peak>, value: f64, piece: &SmoothPiece, t: f64) {
        let place = self.course.place(piece.way(t));
        // Of equal values at several places, or in both directions, the first one is kept.
        let apart = APART * self.course.length();
        let margin = |peak: Peak| {
            let is_elsewhere = (place.at - peak.at).abs() > apart;
            if (place.back && !peak.back) || is_elsewhere {
                ROUNDING * peak.value.abs()
            } else {
                0.0
            }
        };
        if peak.is_none_or(|peak| value > peak.value + margin(peak)) {
            *peak = Some(Peak {
                value,
                at: place.at,
                back: place.back,
            });
        }
    }

    /// Computes the extrema of the work of the torque minus its mean, which are at the places where
    /// both are equal.
    fn fluctuate(&self, mean: f64) -> Option<Fluctuation> {
        let (mut least, mut most) = ((0.0, 0.0), (0.0, 0.0));
        let mut before = 0.0;
        for piece in &self.pieces.list {
            let excess = piece.sums[0].less(mean);
            let zeros = excess.zeros(&excess.turns());
            let integral = excess.integral();
            for &t in zeros.iter().chain(&[1.0]) {
                let work = before + integral.at(t) * piece.half();
                if work < least.0 {
                    least = (work, piece.way(t));
                }
                if work > most.0 {
                    most = (work, piece.way(t));
                }
            }
            before += integral.at(1.0) * piece.half();
        }
        Some(Fluctuation {
            energy: (most.0 - least.0) * self.joule,
            slowest: self.coordinate(most.1),
            fastest: self.coordinate(least.1),
        })
    }

    fn shake(&self, means: &Means) -> CycleShaking {
        let (mut force, mut vector, mut moment): (Option<Peak>, _, Option<Peak>) =
            (None, None, None);
        for piece in &self.pieces.list {
            let [x, y] = [&piece.sums[TORQUES], &piece.sums[TORQUES + 1]];
            let (dx, dy) = (x.slope(), y.slope());
            // The extrema of the squared force.
            let turns = crossings(|t| x.at(t) * dx.at(t) + y.at(t) * dy.at(t));
            for &t in turns.iter().chain(&[-1.0, 1.0]) {
                let here = Vec2::new(x.at(t), y.at(t));
                let before = force;
                self.raise(&mut force, here.norm(), piece, t);
                if force != before {
                    vector = Some(here);
                }
            }
            let sum = &piece.sums[MOMENT];
            for &t in sum.turns().iter().chain(&[-1.0, 1.0]) {
                let value = sum.at(t);
                let mut larger = moment.map(|peak| Peak {
                    value: peak.value.abs(),
                    ..peak
                });
                let before = larger;
                self.raise(&mut larger, value.abs(), piece, t);
                if larger != before {
                    moment = larger.map(|peak| Peak { value, ..peak });
                }
            }
        }
        let is_nothing = self.pieces.is_nothing(MOMENT);
        let moment = moment.map(|peak| Peak {
            value: if is_nothing { 0.0 } else { peak.value },
            ..peak
        });
        CycleShaking {
            force,
            vector,
            force_rms: Some(means.force()),
            moment,
            moment_rms: Some(if is_nothing { 0.0 } else { means.root(MOMENT) }),
        }
    }
}

/// Returns the marks in order, without the ends of the travel and without those that differ only by
/// rounding errors.
fn sorted(marks: &[f64], course: &Course) -> Vec<f64> {
    let length = course.length();
    let mut marks = marks.to_vec();
    if !course.goes_round {
        marks.push(0.5 * length);
    }
    marks.sort_by(f64::total_cmp);
    let apart = SAME * length;
    marks.dedup_by(|later, earlier| *later - *earlier <= apart);
    marks.retain(|way| (apart..=length - apart).contains(way));
    marks
}

/// The distance below which marks are equal, relative to the travel.
const SAME: f64 = 1e-14;

/// Checks that the moment is the last channel.
const _: () = assert!(MOMENT + 1 == CHANNELS);

#[cfg(test)]
#[path = "cycle_tests.rs"]
mod tests;
