//! Analyses the driver over one period of its motion over time.
//!
//! The period is cut at the seams of the motion, and where it passes a coordinate at which a load
//! has a kink or jumps. The pieces are then bisected until sums of Chebyshev polynomials in time
//! represent the solution; all results are computed from the sums.

use crate::DriverMoment;
use crate::numeric::chebyshev::{Basis, ChebyshevSum, TERMS};
use crate::quantity::{Clock, Hidden, MotionOutOfRange};
use crate::scene::Motor;
use crate::solver::{Order, Solver, Workspace};

use super::source::Step;
use super::{MotorDemand, MotorFit, marks};

/// A value, its time, and the driver's coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimedPeak {
    /// The value.
    pub value: f64,
    /// The time in s since the scene's start.
    pub time: f64,
    /// The coordinate in degrees or in the scene's length unit.
    pub at: f64,
}

/// The analysis of the driver over one period of its motion.
#[derive(Clone, Debug, PartialEq)]
pub struct TimedDuty {
    /// The period in s.
    pub period: f64,
    /// The maximum and minimum torque, in N m or N, positive along the driver's coordinate.
    pub torque: [TimedPeak; 2],
    /// The maximum and minimum power, in W.
    pub power: [TimedPeak; 2],
    /// The maximum and minimum speed, in rad/s or the scene's unit per s.
    pub speed: [TimedPeak; 2],
    /// The mean of the torque over time.
    pub mean: f64,
    /// The root mean square of the torque.
    pub rms: f64,
    /// The parts of the torque due to loads, gravity and inertia.
    pub parts: [TimedPart; 3],
    /// The driver's work while its power is positive, and the returned work while it is negative,
    /// in J.
    pub energy: [f64; 2],
    /// The error estimate of the means, relative to the maximum.
    pub error: f64,
    pieces: Vec<TimedPiece>,
}

/// A part of the driving torque.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimedPart {
    /// The maximum and minimum torque, in N m or N.
    pub torque: [TimedPeak; 2],
    /// The mean over time.
    pub mean: f64,
    /// The root mean square.
    pub rms: f64,
}

/// The state of the driver at a moment of the period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimedInstant {
    /// The time in s since the scene's start.
    pub time: f64,
    /// The driver's coordinate and its rates.
    pub moment: DriverMoment,
    /// The driving torque and its parts.
    pub step: Step,
    /// The work since the beginning, in J.
    pub work: f64,
}

/// The reason why a period has no results.
#[derive(Clone, Debug, PartialEq)]
pub enum NoTimedDuty {
    /// The scene has no loads, springs or masses.
    NothingActs,
    /// Forces are not shown at this place.
    WithheldReason(Hidden),
    /// The motion leaves the range of a stop or of the mechanism.
    Leaves(MotionOutOfRange),
    /// The torque does not exist: there is no assembly, or a dead point.
    NoTorque(DriverMoment),
}

const TORQUE: usize = 0;
const POWER: usize = 1;
const SPEED: usize = 2;
/// The channels of loads, gravity and inertia.
const PARTS_OF_TORQUE: [usize; 3] = [3, 4, 5];
const CHANNELS: usize = 6;
/// Initial number of pieces per step of the motion.
const PARTS: u32 = 4;
const MAX_HALVINGS: u32 = 26;
const MAX_PIECES: usize = 4000;
/// The size of the last coefficients, relative to the largest, below which a sum represents its
/// function.
const MAX_LAST_TERM: f64 = 1e-12;
/// The distance below which cuts are equal, relative to the period.
const TIME_TOLERANCE: f64 = 1e-13;
/// The difference below which values are equal, relative to the maximum.
const EQUALITY_TOLERANCE: f64 = 1e-12;
/// The error above which means are not trusted.
const MAX_MEAN_ERROR: f64 = 1e-9;

/// A part of the period on which all channels are smooth.
#[derive(Clone, Debug, PartialEq)]
struct TimedPiece {
    from: f64,
    to: f64,
    sums: [ChebyshevSum; CHANNELS],
}

impl TimedPiece {
    fn time(&self, t: f64) -> f64 {
        self.from + 0.5 * (self.to - self.from) * (1.0 + t)
    }
}

/// Solves at moments of the motion.
struct MomentSource<'a> {
    clock: &'a Clock,
    solver: &'a Solver,
    state: Workspace,
    basis: Basis,
}

impl MomentSource<'_> {
    fn channels(&mut self, time: f64) -> Result<[f64; CHANNELS], NoTimedDuty> {
        let moment = self.clock.moment(time, self.solver.motion().range);
        self.solver.drive(&mut self.state, &moment);
        let _ = self.solver.solve(moment.at, Order::Force, &mut self.state);
        if let Some(hidden) = Hidden::of_forces(&self.state) {
            return Err(NoTimedDuty::WithheldReason(hidden));
        }
        let state = &self.state;
        let parts = state.drive_parts().unwrap_or_default();
        let found = state.drive().zip(state.power());
        let channels = found.map(|(torque, power)| {
            let [load, gravity, inertia] = parts;
            [torque, power, state.driver_speed(), load, gravity, inertia]
        });
        let exists = |channels: &[f64; CHANNELS]| channels.iter().all(|c| c.is_finite());
        channels.filter(exists).ok_or(NoTimedDuty::NoTorque(moment))
    }

    fn piece(&mut self, from: f64, to: f64) -> Result<TimedPiece, NoTimedDuty> {
        let mut values = [[0.0; TERMS]; CHANNELS];
        for j in 0..TERMS {
            let time = from + 0.5 * (to - from) * (1.0 + self.basis.places[j]);
            for (values, value) in values.iter_mut().zip(self.channels(time)?) {
                values[j] = value;
            }
        }
        let sums = values.map(|values| self.basis.through(&values));
        Ok(TimedPiece { from, to, sums })
    }

    /// Returns the times between which all channels are smooth, in order, up to the end of the
    /// period.
    fn cuts(&self) -> Vec<f64> {
        let Some(law) = self.clock.law() else {
            return Vec::new();
        };
        let [low, high] = law.reach();
        let marks = marks::bends(self.solver.mechanism(), self.solver).into_iter();
        let places = marks.flat_map(|mark| mark.between(low, high));
        let passed = places.flat_map(|at| law.meets(at));
        let mut cuts: Vec<f64> = law.seams().chain(passed).collect();
        cuts.sort_by(f64::total_cmp);
        let period = law.period();
        let distance = TIME_TOLERANCE * period;
        cuts.dedup_by(|later, earlier| *later - *earlier <= distance);
        cuts.retain(|time| (distance..period - distance).contains(time));
        cuts.push(period);
        cuts
    }

    /// Returns the period in smooth pieces, and its error estimate.
    fn pieces(&mut self) -> Result<(Vec<TimedPiece>, f64), NoTimedDuty> {
        let mut waiting = Vec::new();
        let mut from = 0.0;
        for to in self.cuts() {
            let end = |k: u32| from + (to - from) * f64::from(k) / f64::from(PARTS);
            waiting.extend((0..PARTS).map(|k| (end(k), end(k + 1), 0)));
            from = to;
        }
        let period = from;
        waiting.reverse();
        let (mut pieces, mut sizes, mut error) = (Vec::new(), [0.0_f64; CHANNELS], 0.0);
        while let Some((from, to, halvings)) = waiting.pop() {
            let piece = self.piece(from, to)?;
            for (size, sum) in sizes.iter_mut().zip(&piece.sums) {
                *size = size.max(sum.size());
            }
            // If parts cancel, rounding errors remain: all torques have the same scale.
            let torques = PARTS_OF_TORQUE.iter().map(|&part| sizes[part]);
            let torques = torques.fold(sizes[TORQUE], f64::max);
            let mut worst = 0.0_f64;
            for (channel, sum) in piece.sums.iter().enumerate() {
                let size = match channel {
                    POWER | SPEED => sizes[channel],
                    _ => torques,
                };
                if size > 0.0 {
                    worst = worst.max(sum.tail() / size);
                }
            }
            let middle = 0.5 * (from + to);
            let is_spent = halvings >= MAX_HALVINGS || pieces.len() + waiting.len() > MAX_PIECES;
            if worst <= MAX_LAST_TERM || is_spent || !(from < middle && middle < to) {
                error += worst * (to - from) / period;
                pieces.push(piece);
            } else {
                waiting.push((middle, to, halvings + 1));
                waiting.push((from, middle, halvings + 1));
            }
        }
        Ok((pieces, error))
    }
}

impl TimedDuty {
    /// Analyses the period of a motion over time.
    ///
    /// # Errors
    /// Returns an error if the scene has no loads, springs or masses, or if forces are not shown.
    /// Also returns one if the motion leaves the mechanism's range, or if the torque does not
    /// exist.
    pub fn new(clock: &Clock, solver: &Solver) -> Result<TimedDuty, NoTimedDuty> {
        if !solver.has_forces() {
            return Err(NoTimedDuty::NothingActs);
        }
        let leaves = clock
            .law()
            .and_then(|law| MotionOutOfRange::of(law, solver));
        if let Some(leaves) = leaves {
            return Err(NoTimedDuty::Leaves(leaves));
        }
        let mut source = MomentSource {
            clock,
            solver,
            state: solver.state(),
            basis: Basis::new(),
        };
        let (pieces, error) = source.pieces()?;
        let period = pieces.last().map_or(0.0, |piece| piece.to);
        let peaks = |channel| peaks(&pieces, channel, clock, solver);
        let means_of = |channel| {
            let [mean, square] = means(&pieces, channel, period);
            [mean, square.max(0.0).sqrt()]
        };
        let [mean, rms] = means_of(TORQUE);
        let parts = PARTS_OF_TORQUE.map(|channel| {
            let [mean, rms] = means_of(channel);
            let torque = peaks(channel);
            TimedPart { torque, mean, rms }
        });
        Ok(TimedDuty {
            period,
            torque: peaks(TORQUE),
            power: peaks(POWER),
            speed: peaks(SPEED),
            mean,
            rms,
            parts,
            energy: energy(&pieces),
            error,
            pieces,
        })
    }

    /// Returns the period in equal steps, including both ends. The arguments must be those of
    /// [`TimedDuty::new`].
    pub fn instants(
        &self,
        clock: &Clock,
        solver: &Solver,
        count: u32,
    ) -> impl Iterator<Item = TimedInstant> {
        let mut state = solver.state();
        (0..=count).map(move |k| {
            let time = self.period * (f64::from(k) / f64::from(count));
            let moment = clock.moment(time, solver.motion().range);
            solver.drive(&mut state, &moment);
            let condition = solver.solve(moment.at, Order::Force, &mut state);
            TimedInstant {
                time,
                moment,
                step: Step::of(&state, condition),
                work: self.work(time),
            }
        })
    }

    /// Returns the driver's work in J from the beginning of the period.
    #[must_use]
    pub fn work(&self, time: f64) -> f64 {
        let started = self.pieces.iter().take_while(|piece| piece.from < time);
        started
            .map(|piece| {
                let half = 0.5 * (piece.to - piece.from);
                let t = ((time - piece.from) / half - 1.0).min(1.0);
                piece.sums[POWER].integral().at(t) * half
            })
            .sum()
    }

    /// Returns `true` if the means can be trusted.
    #[must_use]
    pub fn has_converged(&self) -> bool {
        self.error <= MAX_MEAN_ERROR
    }

    /// Returns the mean power over a period, in W.
    #[must_use]
    pub fn mean_power(&self) -> f64 {
        (self.energy[0] - self.energy[1]) / self.period
    }

    /// Compares a motor on the driver's shaft with the period; the motor's speed has the unit of
    /// the driver's.
    #[must_use]
    pub fn fit(&self, motor: &Motor) -> MotorFit {
        let largest = |peaks: [TimedPeak; 2]| peaks[0].value.abs().max(peaks[1].value.abs());
        let both = |required: f64, capacity| MotorDemand::of(Some(required), capacity);
        MotorFit {
            rated: both(self.rms, motor.rated),
            peak: both(largest(self.torque), motor.peak),
            speed: both(largest(self.speed), motor.speed),
            geared: None,
            is_unbounded: false,
        }
    }
}

/// Returns the maximum and minimum of a channel.
fn peaks(pieces: &[TimedPiece], channel: usize, clock: &Clock, solver: &Solver) -> [TimedPeak; 2] {
    let sizes = pieces.iter().map(|piece| piece.sums[channel].size());
    let size = sizes.fold(0.0, f64::max);
    let none = [f64::NEG_INFINITY, f64::INFINITY];
    let mut peaks = none.map(|value| (value, 0.0));
    for piece in pieces {
        let sum = &piece.sums[channel];
        // Values that differ by rounding errors equal the first one, and rounding errors of zero
        // are zero.
        let beyond = EQUALITY_TOLERANCE * size;
        for &t in [-1.0].iter().chain(&sum.turns()).chain(&[1.0]) {
            let value = sum.at(t);
            let value = if value.abs() <= beyond { 0.0 } else { value };
            if value > peaks[0].0 + beyond {
                peaks[0] = (value, piece.time(t));
            }
            if value < peaks[1].0 - beyond {
                peaks[1] = (value, piece.time(t));
            }
        }
    }
    // Zero has no sign.
    peaks.map(|(value, time)| TimedPeak {
        value: value + 0.0,
        time,
        at: clock.moment(time, solver.motion().range).at,
    })
}

/// Returns the means of a channel and of its square.
fn means(pieces: &[TimedPiece], channel: usize, period: f64) -> [f64; 2] {
    let mut means = [0.0; 2];
    for piece in pieces {
        let (sum, share) = (&piece.sums[channel], 0.5 * (piece.to - piece.from) / period);
        means[0] += share * sum.integral().at(1.0);
        means[1] += share * sum.product(sum);
    }
    means.map(|mean| mean + 0.0)
}

/// Returns the integral of the power where it is positive, and minus the integral where it is
/// negative.
fn energy(pieces: &[TimedPiece]) -> [f64; 2] {
    let mut energy = [0.0; 2];
    for piece in pieces {
        let sum = &piece.sums[POWER];
        let (zeros, integral) = (sum.zeros(&sum.turns()), sum.integral());
        let mut before = 0.0;
        for &t in zeros.iter().chain(&[1.0]) {
            let here = integral.at(t);
            let gain = (here - before) * 0.5 * (piece.to - piece.from);
            energy[usize::from(gain < 0.0)] += gain.abs();
            before = here;
        }
    }
    energy
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;
    use std::f64::consts::PI;

    fn duty(driver: &str, rest: &str) -> TimedDuty {
        let text = format!("unit = \"m\"\n[ground]\nA = [0, 0]\n[driver]\n{driver}\n{rest}");
        let scene = Scene::parse(&text, "timed").unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        TimedDuty::new(&Clock::of(&scene).unwrap(), &solver).unwrap()
    }

    fn near(found: f64, exact: f64) {
        let maximum = 1e-9 * exact.abs().max(1.0);
        assert!((found - exact).abs() < maximum, "{found} for {exact}");
    }

    /// A wheel of inertia J is indexed by h = 90 deg in T = 0.5 s by a cycloid, and back
    /// harmonically in T' = 0.25 s. The torque is J times the acceleration, with peaks of
    /// 2 pi h / T^2 J and pi^2 h / (2 T'^2) J. The mean square of a sine or cosine is half the square
    /// of its peak. The peak speed is 2 h / T; the work up to it is J w^2 / 2, which is given back.
    #[test]
    fn indexed_wheel_matches_closed_formulas() {
        let found = duty(
            "link = \"r2\"\nangle = 0\nmotion = [{ law = \"cycloidal\", to = 90, time = 0.5 }, \
             { dwell = 0.25 }, { law = \"harmonic\", to = 0, time = 0.25 }]",
            "[links]\nr2 = { from = \"A\", to = \"B\", length = 1, com = [0, 0], mass = 1, inertia = 3 }",
        );
        let (h, inertia) = (0.5 * PI, 3.0);
        let forth = inertia * 2.0 * PI * h / 0.25;
        let back = inertia * PI * PI * h / (2.0 * 0.0625);
        near(found.period, 1.0);
        near(found.torque[0].value, back);
        near(found.torque[1].value, -back);
        near(found.torque[0].time, 1.0);
        near(found.torque[1].time, 0.75);
        near(found.mean, 0.0);
        near(
            found.rms,
            (0.5 * (0.5 * forth * forth + 0.25 * back * back)).sqrt(),
        );
        let (fast, fast_back) = (2.0 * h / 0.5, PI * h / (2.0 * 0.25));
        near(found.speed[0].value, fast);
        near(found.speed[1].value, -fast_back);
        near(found.speed[0].time, 0.25);
        near(found.speed[0].at, 45.0);
        let work = 0.5 * inertia * (fast * fast + fast_back * fast_back);
        near(found.energy[0], work);
        near(found.energy[1], work);
        near(found.mean_power(), 0.0);
        assert!(found.has_converged(), "{}", found.error);
    }

    /// A load of 100 N m between two coordinates and none elsewhere: the integrals neither
    /// overshoot at the jumps nor smear them. At a constant speed of 360 deg in 2 s, a quarter of
    /// the period is under load. The load repeats with every turn, as two turns in one motion show.
    /// A dwell at a jump has the load that begins there.
    #[test]
    fn load_jump_splits_the_integration() {
        let load = "[links]\nr2 = { from = \"A\", to = \"B\", length = 1 }\n[[loads]]\nlink = \"r2\"\n\
             torque = -100\nover = [[0, 0], [100, 0], [100, 1], [190, 1], [190, 0], [360, 0]]";
        for (motion, under, work) in [
            (
                "{ law = \"constant\", to = 360, time = 2 }",
                0.25,
                50.0 * PI,
            ),
            (
                "{ law = \"constant\", to = 720, time = 2 }",
                0.25,
                100.0 * PI,
            ),
            (
                "{ law = \"constant\", to = 100, time = 1 }, { dwell = 1 }, \
                 { law = \"constant\", to = 360, time = 2.6 }",
                (1.0 + 0.9) / 4.6,
                50.0 * PI,
            ),
        ] {
            let found = duty(
                &format!("link = \"r2\"\nangle = 0\nmotion = [{motion}]"),
                load,
            );
            near(found.torque[0].value, 100.0);
            near(found.torque[0].at, 100.0);
            assert_eq!((found.torque[1].value, found.torque[1].time), (0.0, 0.0));
            near(found.mean, 100.0 * under);
            near(found.rms, 100.0 * under.sqrt());
            near(found.energy[0], work);
            near(found.energy[1], 0.0);
            assert!(found.has_converged(), "{motion}: {}", found.error);
        }
        let swung = "{ law = \"cycloidal\", to = 150, time = 1 }, { law = \"harmonic\", to = 0, time = 0.5 }";
        let found = duty(
            &format!("link = \"r2\"\nangle = 0\nmotion = [{swung}]"),
            load,
        );
        near(found.torque[0].value, 100.0);
        near(found.torque[1].value, 0.0);
        // 50 deg against the load, and 50 deg with it.
        near(found.energy[0], 100.0 * 50.0_f64.to_radians());
        near(found.energy[1], 100.0 * 50.0_f64.to_radians());
        assert!(found.has_converged(), "{}", found.error);
    }

    /// A wheel of inertia J is moved by h in T, by a trapezoid with ramps r T. The torque is
    /// J h / (r (1 - r) T^2) on the ramps and zero between them.
    #[test]
    fn trapezoid_motion_is_split_at_its_ramps() {
        let found = duty(
            "link = \"r2\"\nangle = 0\nmotion = [{ law = \"trapezoid\", ramp = 0.2, to = 360, time = 1.5 }]",
            "[links]\nr2 = { from = \"A\", to = \"B\", length = 1, com = [0, 0], mass = 1, inertia = 3 }",
        );
        let maximum = 3.0 * 2.0 * PI / (0.16 * 2.25);
        near(found.torque[0].value, maximum);
        near(found.torque[1].value, -maximum);
        near(found.rms, maximum * 0.4_f64.sqrt());
        near(found.mean, 0.0);
        assert!(found.has_converged(), "{}", found.error);
    }

    /// A torque of 6 N m against a link that turns by 360 deg in 2 s: always 6 N m, and 6 pi W.
    #[test]
    fn constant_load_power_is_torque_times_speed() {
        let found = duty(
            "link = \"r2\"\nangle = 0\nmotion = [{ law = \"constant\", to = 360, time = 2 }]",
            "[links]\nr2 = { from = \"A\", to = \"B\", length = 1 }\n[[loads]]\nlink = \"r2\"\ntorque = -6",
        );
        near(found.rms, 6.0);
        near(found.mean, 6.0);
        near(found.power[1].value, 6.0 * PI);
        near(found.mean_power(), 6.0 * PI);
        near(found.energy[0], 12.0 * PI);
        let [load, gravity, inertia] = found.parts;
        near(load.rms, 6.0);
        assert_eq!([gravity.rms, inertia.rms], [0.0; 2]);
        near(found.work(0.5), 3.0 * PI);
        near(found.work(2.0), 12.0 * PI);
        let fit = found.fit(&Motor {
            rated: Some(5.0),
            speed: Some(4.0),
            ..Motor::default()
        });
        assert_eq!(fit.rated.map(|r| r.is_enough()), Some(false));
        assert_eq!(fit.speed.map(|s| s.is_enough()), Some(true));
    }
}
