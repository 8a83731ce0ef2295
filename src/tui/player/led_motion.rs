//! The motion of a scene whose inputs follow a leading point.

use crate::Vec2;
use crate::scene::{LeadingPoint, Scene};
use crate::solver::{LeadSingularity, LedPose, LedPosition, Order, PointLeader, Solver, State};
use crate::tui::figures::format::{MAX_COORDINATE_DECIMALS, rounded};
use crate::tui::player::playback::Track;
use std::sync::Arc;

/// Number of pieces in which the path is followed to find how far the inputs can follow.
const PIECES: u16 = 180;
/// Number of positions between which the motion is solved, and of those of a large linkage.
const PLACES: u16 = 180;
const MIN_PLACES: u16 = 6;
/// Maximum number of rows of all kept states.
const MAX_ROWS: usize = 20_000;
/// Number of points of the planned path.
const PLANNED: u16 = 720;
/// Minimum number of time steps of the motion, as a power of ten.
const STEPS: f64 = 3.0;

/// The motion of a leading point, and the inputs at one of its times.
///
/// A time is solved from the nearest kept position before it. Its state is thus the same for each
/// way to that time, and a frame of a long path solves only a small part of it.
#[derive(Debug)]
pub(crate) struct LedMotion {
    lead: LeadingPoint,
    /// The first time, and the last one that the inputs can follow, in s.
    span: [f64; 2],
    is_complete: bool,
    singular: Vec<(f64, LeadSingularity)>,
    /// The inputs at times over the motion, the first one at its begin.
    kept: Vec<(f64, PointLeader)>,
    planned: Arc<[Vec2]>,
    /// The number of decimals to which times are rounded during playback, so that the displayed
    /// time is the solved one.
    decimals: usize,
    /// The present time with its inputs.
    time: f64,
    leader: PointLeader,
    pose: LedPose,
}

impl LedMotion {
    /// Follows the path of a scene's leading point. `None` without one, and if the inputs cannot
    /// reach its first position.
    pub(crate) fn new(scene: &Scene, solver: &Solver) -> Option<LedMotion> {
        let lead = scene.lead.clone()?;
        let opening = PointLeader::new(solver, lead.lead())?;
        let [first, last] = lead.path.span();
        let (reach, positions) = opening.clone().positions(&lead.path, last, PIECES);
        let digits = (last - first).log10().floor();
        let decimals = (0..MAX_COORDINATE_DECIMALS).find(|&d| d as f64 + digits >= STEPS);
        let decimals = decimals.unwrap_or(MAX_COORDINATE_DECIMALS);
        let end = match reach.is_complete {
            true => last,
            // Rounded down, so that the inputs can reach the displayed end.
            false => {
                let end = rounded(reach.until, decimals);
                let step = 10.0_f64.powi(-i32::try_from(decimals).unwrap_or(0));
                let end = if end > reach.until { end - step } else { end };
                rounded(end, decimals).max(first)
            }
        };
        let rows = scene.mechanism.points().len() + scene.mechanism.links().len();
        let count = u16::try_from(MAX_ROWS / rows.max(1)).unwrap_or(PLACES);
        let count = count.clamp(MIN_PLACES, PLACES);
        let order = highest_order(solver);
        let positions = match reach.is_complete && count == PIECES {
            true => positions,
            false => opening.positions(&lead.path, end, count).1,
        };
        let mut kept = Vec::with_capacity(positions.len());
        let mut opened = None;
        for position in positions {
            let LedPosition {
                time,
                mut leader,
                pose,
            } = position;
            let pose = leader.solve_rates(pose, &lead.path, time, order);
            opened.get_or_insert_with(|| (leader.clone(), pose));
            kept.push((time, leader));
        }
        let (leader, pose) = opened?;
        let planned = (0..=PLANNED).map(|k| {
            let [at, ..] =
                (lead.path).at(first + (last - first) * f64::from(k) / f64::from(PLANNED));
            at
        });
        Some(LedMotion {
            span: [first, kept.last()?.0],
            is_complete: reach.is_complete && kept.len() == usize::from(count) + 1,
            singular: reach.singular,
            planned: planned.collect(),
            kept,
            decimals,
            time: first,
            leader,
            pose,
            lead,
        })
    }

    /// Moves the point to its position at a time. Returns `false` and keeps the last time if the
    /// inputs cannot follow.
    pub(crate) fn go(&mut self, time: f64, order: Order) -> bool {
        let before = self.kept.partition_point(|(at, _)| *at <= time).max(1);
        // At the edge of the workspace, a position can be reached from one side only.
        for (_, from) in self.kept.iter().take(before).rev().take(2) {
            let mut leader = from.clone();
            if let Some(pose) = leader.follow(&self.lead.path, time, order) {
                (self.time, self.leader, self.pose) = (time, leader, pose);
                return true;
            }
        }
        false
    }

    /// Returns the state at the present time.
    pub(crate) fn state(&self) -> &State {
        self.leader.state()
    }

    /// Returns the states over the whole motion, solved with all rates and forces.
    pub(crate) fn states(&self) -> impl Iterator<Item = &State> {
        self.kept.iter().map(|(_, leader)| leader.state())
    }

    /// Returns the present time in s.
    pub(crate) fn time(&self) -> f64 {
        self.time
    }

    /// Returns the first time, and the last one that the inputs can follow, in s.
    pub(crate) fn span(&self) -> [f64; 2] {
        self.span
    }

    /// Returns how much of the motion lies before a time, from 0 to 1.
    pub(crate) fn share(&self, time: f64) -> f64 {
        let [first, end] = self.span;
        match end > first {
            true => ((time - first) / (end - first)).clamp(0.0, 1.0),
            false => 0.0,
        }
    }

    /// Returns `true` if the inputs can follow the whole path.
    pub(crate) fn is_complete(&self) -> bool {
        self.is_complete
    }

    /// Returns `true` if the motion ends where it begins.
    pub(crate) fn is_closed(&self) -> bool {
        self.is_complete && self.lead.path.is_closed()
    }

    /// Returns the singular positions with their times.
    pub(crate) fn singular(&self) -> &[(f64, LeadSingularity)] {
        &self.singular
    }

    /// Returns the singularity at the present time, if its position is singular.
    pub(crate) fn singularity(&self) -> Option<&LeadSingularity> {
        self.pose.singularity.as_ref()
    }

    /// Returns the coordinates of all inputs, the driver's first.
    pub(crate) fn inputs(&self) -> impl Iterator<Item = f64> {
        self.pose.inputs.iter().map(|input| input.at)
    }

    /// Returns the leading point with its path.
    pub(crate) fn lead(&self) -> &LeadingPoint {
        &self.lead
    }

    /// Returns points of the whole planned path, also of the part that the inputs cannot follow.
    pub(crate) fn planned(&self) -> &Arc<[Vec2]> {
        &self.planned
    }

    /// Returns the playback track: a closed motion repeats, any other one reverses at its ends.
    pub(crate) fn track(&self) -> Track {
        let [first, end] = self.span;
        Track {
            span: end - first,
            oscillation: (!self.is_closed()).then_some((first, end)),
            speed: 1.0,
        }
    }

    /// Returns the time of the motion for any time: of a closed motion that within its period,
    /// otherwise the nearest.
    pub(crate) fn within(&self, time: f64) -> f64 {
        let [first, end] = self.span;
        match self.is_closed() {
            true if time.is_finite() && !(first..=end).contains(&time) => {
                first + (time - first).rem_euclid(end - first)
            }
            true | false => time.max(first).min(end),
        }
    }

    /// Rounds a time as in playback.
    pub(crate) fn on_grid(&self, time: f64) -> f64 {
        self.within(rounded(self.within(time), self.decimals))
    }

    /// Formats a time.
    pub(crate) fn text(&self, time: f64) -> String {
        format!("{time:.*}", self.decimals)
    }
}

/// Returns the order to which states over the whole motion are solved.
fn highest_order(solver: &Solver) -> Order {
    match solver.has_forces() {
        true => Order::Force,
        false => Order::Acceleration,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    /// Opens the five-bar with a path for its point P.
    fn opened(path: &str) -> (Scene, Solver) {
        let text = presets::find("five-bar").unwrap().text;
        let scene = Scene::parse(&format!("{text}\n[lead]\nP = {path}\n"), "led").unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        (scene, solver)
    }

    fn led(path: &str) -> LedMotion {
        let (scene, solver) = opened(path);
        LedMotion::new(&scene, &solver).unwrap()
    }

    /// A state is solved from the kept position before it, whichever time was shown before.
    #[test]
    fn state_depends_on_time_alone() {
        let mut led = led("{ centre = [10, 180], radius = 25, speed = \"90 deg/s\" }");
        let mut inputs = |times: &[f64]| {
            for &time in times {
                assert!(led.go(time, Order::Acceleration), "{time}");
            }
            led.inputs().map(f64::to_bits).collect::<Vec<u64>>()
        };
        let found = inputs(&[1.234]);
        assert_eq!(inputs(&[3.9, 1.234]), found);
        assert_eq!(inputs(&[0.0, 1.2339, 1.2341, 1.234]), found);
    }

    /// A closed motion repeats, any other one stays within its ends.
    #[test]
    fn times_are_reduced_to_the_motion() {
        let circle = led("{ centre = [10, 180], radius = 25, speed = \"90 deg/s\" }");
        assert!(circle.is_closed());
        assert_eq!(circle.span(), [0.0, 4.0]);
        let within = [-1.0, 0.0, 4.0, 5.0, f64::NEG_INFINITY].map(|time| circle.within(time));
        assert_eq!(within, [3.0, 0.0, 4.0, 1.0, 0.0]);
        let line = led("{ over = [[1, 0, 173], [3, 0, 200]] }");
        let within = [-1.0, 1.0, 3.0, 5.0, f64::NEG_INFINITY].map(|time| line.within(time));
        assert_eq!(within, [1.0, 1.0, 3.0, 3.0, 1.0]);
        assert_eq!(line.track().oscillation, Some((1.0, 3.0)));
    }

    /// P is led up the y axis by 87 (3 s^2 - 2 s^3). The arms are straight at sqrt(240^2 - 60^2),
    /// with s = 0.6245...; the displayed end lies before that.
    #[test]
    fn motion_ends_where_the_inputs_cannot_follow() {
        let mut led = led("{ over = [[0, 0, 173], [1, 0, 260]] }");
        assert!(!led.is_complete() && !led.is_closed());
        let [_, end] = led.span();
        let height = |s: f64| 173.0 + 87.0 * s * s * (3.0 - 2.0 * s);
        let edge = 240.0_f64.powi(2) - 60.0_f64.powi(2);
        assert!(height(end) < edge.sqrt() && edge.sqrt() < height(end + 1e-3));
        assert!(led.go(end, Order::Acceleration));
        assert!(!led.go(end + 0.01, Order::Acceleration));
        assert_eq!(led.time(), end);
        let (scene, solver) = opened("{ over = [[0, 0, 300], [1, 0, 310]] }");
        assert!(LedMotion::new(&scene, &solver).is_none());
    }
}
