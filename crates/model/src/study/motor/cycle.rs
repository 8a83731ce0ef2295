//! The results of a cycle.

use super::cycle_travel::CyclePath;
use super::periodic::{Means, Periodic, periodic};
use super::torque_pieces::{Pieces, Sampler, SmoothPiece};
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
    pub supplied: Option<f64>,
    /// The returned work while its power is negative, in J per cycle, as a positive number.
    pub returned: Option<f64>,
}

impl DriveEffort {
    /// Returns the torque with the largest absolute value: the worst instant.
    #[must_use]
    pub fn worst(&self) -> Option<Peak> {
        let (largest, minimum) = (self.largest?, self.least?);
        Some(if largest.value >= -minimum.value {
            largest
        } else {
            minimum
        })
    }

    /// Returns the net work of a cycle in J: the input minus the returned work.
    #[must_use]
    pub fn work(&self) -> Option<f64> {
        Some(self.supplied? - self.returned?)
    }

    /// Returns `true` if this part consists of the rounding errors of the others.
    #[must_use]
    pub fn is_rounding_of(&self, others: &[DriveEffort]) -> bool {
        let energy = |e: &DriveEffort| Some(e.supplied? + e.returned?);
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
    pub course: CyclePath,
    /// The absolute value of the driver's speed, in rad/s or m/s.
    pub speed: f64,
    /// The total driving torque.
    pub all: DriveEffort,
    /// The parts of the torque due to loads, gravity and inertia.
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
const MIN_PEAK_DISTANCE: f64 = 1e-4;
/// The rounding error of a cancellation, relative to the terms.
const ROUNDING: f64 = 1e-12;
/// The difference of the torques at the ends of two pieces below which they are continuous,
/// relative to the largest torque.
const CONTINUITY_TOLERANCE: f64 = 1e-6;
/// A distance inside a piece, relative to its length.
const INSIDE: f64 = 1e-9;
/// The error above which means are not trusted.
const MAX_MEAN_ERROR: f64 = 1e-10;

impl Cycle {
    /// Analyses a cycle. `effort` solves at a coordinate; its second argument is `true` on the way
    /// back. `marks` are the travels at which a load has a kink or jumps; 0 if the end does not
    /// continue at the beginning.
    pub fn new(
        course: CyclePath,
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
        let smooth = course.is_periodic && marks.is_empty() && !pieces.has_gap;
        let means = smooth
            .then(|| periodic(&mut sampler, |i| pieces.size(i), MAX_MEAN_ERROR))
            .flatten();
        let error = pieces
            .error
            .iter()
            .fold(0.0, |maximum: f64, e| maximum.max(*e));
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
        !self.pieces.has_gap && self.error <= MAX_MEAN_ERROR
    }

    /// Returns the torque, its parts, and the force and moment on the ground after this travel,
    /// from the sums; `None` if they do not exist.
    #[must_use]
    pub fn at(&self, travel: f64) -> Option<Effort> {
        let mut channels = self.pieces.at(travel)?;
        let weight = self.course.place(travel).weight;
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
    pub fn work(&self, travel: f64) -> Option<f64> {
        if self.pieces.has_gap {
            return None;
        }
        if travel <= 0.0 {
            return Some(0.0);
        }
        let mut work = 0.0;
        for piece in &self.pieces.list {
            let integral = piece.sums[0].integral();
            if travel <= piece.to {
                return Some((work + integral.at(piece.t(travel)) * piece.half()) * self.joule);
            }
            work += integral.at(1.0) * piece.half();
        }
        Some(work * self.joule)
    }

    /// Returns 1 if the driver's coordinate increases with the travel, or -1: the sign of the
    /// speed, for the power of a torque.
    #[must_use]
    pub fn sense(&self, travel: f64) -> f64 {
        self.course.place(travel).weight.signum()
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
                let travel = piece.way(t);
                let weight = self
                    .course
                    .place(travel.clamp(piece.way(-1.0 + INSIDE), piece.way(1.0 - INSIDE)))
                    .weight;
                [self.course.place(travel).at, piece.sums[0].at(t) / weight]
            };
            let first = point(0);
            let is_rotary = !self.course.is_periodic && piece.from == once;
            let jumps = end.is_none_or(|end: f64| {
                (end - first[1]).abs() > CONTINUITY_TOLERANCE * self.pieces.scale[0]
            });
            if jumps || is_rotary {
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
    pub fn coordinate(&self, travel: f64) -> f64 {
        self.course.place(travel).at
    }

    fn read(&mut self, means: Option<Periodic>) {
        let means = means.map_or_else(|| self.means(), |periodic| periodic.means);
        let effect = |channel| self.effect(channel, &means);
        let [all, load, gravity, inertia]: [DriveEffort; TORQUES] = std::array::from_fn(effect);
        self.all = all;
        self.parts = [load, gravity, inertia];
        if self.course.is_periodic {
            self.fluctuation = self.fluctuate(means.mean[0]);
        }
        if !self.course.ends_at_dead_point {
            self.shaking = self.shaking_forces(&means);
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
                self.raise_peak(high, sense * value, piece, t);
                self.raise_peak(low, -sense * value, piece, t);
                self.raise_peak(high_power, value, piece, t);
                self.raise_peak(low_power, -value, piece, t);
            }
        }
        let regular = !self.course.ends_at_dead_point;
        let [high, low, high_power, low_power] = largest.map(|peak| peak.filter(|_| regular));
        let times = |peak: Option<Peak>, factor: f64| {
            peak.map(|peak| Peak {
                value: peak.value * factor,
                ..peak
            })
        };
        let mean = if self.course.is_periodic {
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
            supplied: Some(put_in * self.joule),
            returned: Some(given_back * self.joule),
        }
    }

    /// Replaces a peak if the value is larger.
    fn raise_peak(&self, peak: &mut Option<Peak>, value: f64, piece: &SmoothPiece, t: f64) {
        let place = self.course.place(piece.way(t));
        // Of equal values at several places, or in both directions, the first one is kept.
        let distance = MIN_PEAK_DISTANCE * self.course.length();
        let margin = |peak: Peak| {
            let is_elsewhere = (place.at - peak.at).abs() > distance;
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
        let (mut minimum, mut maximum) = ((0.0, 0.0), (0.0, 0.0));
        let mut before = 0.0;
        for piece in &self.pieces.list {
            let excess = piece.sums[0].less(mean);
            let zeros = excess.zeros(&excess.turns());
            let integral = excess.integral();
            for &t in zeros.iter().chain(&[1.0]) {
                let work = before + integral.at(t) * piece.half();
                if work < minimum.0 {
                    minimum = (work, piece.way(t));
                }
                if work > maximum.0 {
                    maximum = (work, piece.way(t));
                }
            }
            before += integral.at(1.0) * piece.half();
        }
        Some(Fluctuation {
            energy: (maximum.0 - minimum.0) * self.joule,
            slowest: self.coordinate(maximum.1),
            fastest: self.coordinate(minimum.1),
        })
    }

    fn shaking_forces(&self, means: &Means) -> CycleShaking {
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
                self.raise_peak(&mut force, here.norm(), piece, t);
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
                self.raise_peak(&mut larger, value.abs(), piece, t);
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
fn sorted(marks: &[f64], course: &CyclePath) -> Vec<f64> {
    let length = course.length();
    let mut marks = marks.to_vec();
    if !course.is_periodic {
        marks.push(0.5 * length);
    }
    marks.sort_by(f64::total_cmp);
    let distance = EQUALITY_TOLERANCE * length;
    marks.dedup_by(|later, earlier| *later - *earlier <= distance);
    marks.retain(|travel| (distance..=length - distance).contains(travel));
    marks
}

/// The distance below which marks are equal, relative to the travel.
const EQUALITY_TOLERANCE: f64 = 1e-14;

/// Checks that the moment is the last channel.
const _: () = assert!(MOMENT + 1 == CHANNELS);

#[cfg(test)]
#[path = "cycle_tests.rs"]
mod tests;
