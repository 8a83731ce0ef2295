//! Drives linkages with a known motion through tasks derived from it.

mod driven_functions;
pub(super) mod planted;
mod round_trips;

use super::*;
use kinematics::Vec2;
use kinematics::angle::{degrees, unit};
use proptest::prelude::*;

/// A four-bar given by its pivots and the lengths of crank, coupler and rocker, with P on the
/// coupler.
#[derive(Clone, Copy, Debug)]
struct KnownFourBar {
    a: Vec2,
    d: Vec2,
    crank: f64,
    coupler: f64,
    rocker: f64,
    p: Vec2,
}

impl KnownFourBar {
    /// Returns B, C, P and the coupler's angle at a crank angle, with C to the left or right of
    /// B-D.
    fn at(&self, angle: f64, is_left: bool) -> Option<([Vec2; 2], Vec2, f64)> {
        let b = self.a + unit(angle) * self.crank;
        let across = self.d - b;
        let l = across.norm();
        let x = (self.coupler * self.coupler - self.rocker * self.rocker + l * l) / (2.0 * l);
        let y = (self.coupler * self.coupler - x * x).sqrt();
        let y = if is_left { y } else { -y };
        let along = across * (1.0 / l);
        let c = b + Vec2::new(x, y).turned(along);
        let rod = (c - b) * (1.0 / self.coupler);
        y.is_finite()
            .then(|| ([b, c], b + self.p.turned(rod), degrees(c - b)))
    }

    fn proposal(&self, places: Vec<[Vec2; 2]>, tracer: Vec2) -> Proposal {
        Proposal {
            pivot: self.a,
            partner: PinConstraint::Rocker(self.d),
            places,
            tracer: Some(tracer),
        }
    }

    /// Returns the task of its poses at these angles, each in the given assembly, and the linkage
    /// itself.
    fn poses(&self, stops: &[(f64, bool)]) -> Option<(Task, Proposal)> {
        let found: Option<Vec<_>> = stops.iter().map(|(at, left)| self.at(*at, *left)).collect();
        let found = found?;
        let pose = |(_, p, angle): &([Vec2; 2], Vec2, f64)| Pose {
            at: *p,
            angle: *angle,
        };
        let task = Task {
            kind: TaskKind::Poses(PoseTask {
                poses: found.iter().map(pose).collect(),
                ..PoseTask::default()
            }),
            four_bars: true,
            slider_cranks: false,
            preferences: Preferences {
                ordered: true,
                ..Preferences::default()
            },
        };
        let places = found.iter().map(|found| found.0).collect();
        Some((task, self.proposal(places, found[0].1)))
    }
}

/// A crank-rocker: the crank turns fully.
const TURNING: KnownFourBar = KnownFourBar {
    a: Vec2::new(20.0, -10.0),
    d: Vec2::new(420.0, 30.0),
    crank: 100.0,
    coupler: 300.0,
    rocker: 250.0,
    p: Vec2::new(120.0, 80.0),
};

/// A linkage whose crank swings between two dead points.
const SWINGING: KnownFourBar = KnownFourBar {
    crank: 300.0,
    coupler: 150.0,
    ..TURNING
};

#[test]
fn working_linkage_has_no_defect() {
    let stops = [10.0, 70.0, 150.0, 290.0].map(|at| (at, true));
    let (task, proposal) = TURNING.poses(&stops).unwrap();
    let candidate = Candidate::evaluate(&task, &proposal);
    assert_eq!(candidate.defects, []);
    let at = candidate.at.iter().zip([10.0, 70.0, 150.0, 290.0]);
    assert!(
        at.clone().count() == 4
            && at
                .into_iter()
                .all(|(at, target)| (at - target).abs() < 1e-12)
    );
    let figures = candidate.figures;
    assert!(figures.full_turn);
    assert!(
        figures.miss < 1e-10 && figures.angle_miss < 1e-10,
        "{figures:?}"
    );
    // The minimum is where the crank passes the line of the pivots, within the task.
    let ground = (TURNING.d - TURNING.a).norm();
    let minimum = [ground - 100.0, ground + 100.0].map(|across| {
        let cosine: f64 = (300.0 * 300.0 + 250.0 * 250.0 - across * across) / (2.0 * 300.0 * 250.0);
        cosine.abs().acos().to_degrees()
    });
    assert!((figures.transmission - minimum[1].min(minimum[0])).abs() < 1e-9);
}

#[test]
fn circuit_change_is_reported_between_its_points() {
    let stops = [(10.0, true), (70.0, true), (150.0, false), (290.0, false)];
    let (task, proposal) = TURNING.poses(&stops).unwrap();
    let candidate = Candidate::evaluate(&task, &proposal);
    assert_eq!(candidate.defects, [TaskDefect::Circuit { from: 1, to: 2 }]);
}

#[test]
fn branch_defect_is_reported_if_neither_pivot_can_drive() {
    let low_high = |known: &KnownFourBar| {
        let places = (-1800..1800).map(|k| f64::from(k) * 0.1);
        let found: Vec<f64> = places.filter(|at| known.at(*at, true).is_some()).collect();
        (found[0], found[found.len() - 1])
    };
    let (low, high) = low_high(&SWINGING);
    assert!(high - low < 300.0, "{low} {high}");
    let at = |part: f64| low + part * (high - low);
    // Two points on either side: a dead point of this crank, and of the other, lies between them.
    let stops = [
        (at(0.2), true),
        (at(0.8), true),
        (at(0.8), false),
        (at(0.2), false),
    ];
    let (task, proposal) = SWINGING.poses(&stops).unwrap();
    let own = Candidate::evaluate(
        &Task {
            preferences: Preferences::default(),
            ..task
        },
        &proposal,
    );
    assert!(!own.meets_task());
    let named = |d: &TaskDefect| matches!(d, TaskDefect::Branch { .. });
    assert!(own.defects.iter().all(named), "{:?}", own.defects);
}

#[test]
fn turning_back_is_defect_only_if_order_is_wanted() {
    let stops = [10.0, 150.0, 70.0, 120.0].map(|at| (at, true));
    let (task, proposal) = TURNING.poses(&stops).unwrap();
    let candidate = Candidate::evaluate(&task, &proposal);
    assert_eq!(candidate.defects, [TaskDefect::Order { from: 1, to: 2 }]);
    let free = Task {
        preferences: Preferences::default(),
        ..task
    };
    assert!(Candidate::evaluate(&free, &proposal).meets_task());
}

#[test]
fn unmet_poses_are_reported_as_missed() {
    let stops = [10.0, 70.0, 150.0].map(|at| (at, true));
    let (task, proposal) = TURNING.poses(&stops).unwrap();
    let judged = |change: fn(&mut Vec<Pose>)| {
        let mut task = task.clone();
        if let TaskKind::Poses(target) = &mut task.kind {
            change(&mut target.poses);
        }
        Candidate::evaluate(&task, &proposal).defects
    };
    assert_eq!(judged(|_| ()), []);
    let turned = judged(|poses| poses[1].angle += 0.01);
    assert_eq!(turned, [TaskDefect::Missed { point: 1 }]);
    let moved = judged(|poses| poses[2].at.x += 0.01);
    assert_eq!(moved, [TaskDefect::Missed { point: 2 }]);
    let fewer = judged(|poses| poses.truncate(2));
    assert_eq!(fewer, [TaskDefect::Unopened]);
}

#[test]
fn unmet_wanted_properties_are_reported() {
    let stops = [10.0, 70.0, 150.0].map(|at| (at, true));
    let (mut task, proposal) = TURNING.poses(&stops).unwrap();
    task.preferences = Preferences {
        full_turn: true,
        transmission: Some(80.0),
        inside: Some([Vec2::new(0.0, -20.0), Vec2::new(100.0, 100.0)]),
        ratio: Some(2.0),
        ordered: true,
        sense: Some(Sense::Clockwise),
    };
    let candidate = Candidate::evaluate(&task, &proposal);
    assert!(candidate.meets_task());
    // The crank turns fully, counter-clockwise.
    let unmet = [
        UnmetPreference::Transmission,
        UnmetPreference::Inside,
        UnmetPreference::Ratio,
        UnmetPreference::Sense,
    ];
    assert_eq!(candidate.missed, unmet);
    let swinging = SWINGING.poses(&[(30.0, true), (40.0, true), (50.0, true)]);
    let (mut task, proposal) = swinging.unwrap();
    task.preferences.full_turn = true;
    let candidate = Candidate::evaluate(&task, &proposal);
    assert!(candidate.missed.contains(&UnmetPreference::FullTurn));
}

#[test]
fn non_finite_proposal_is_unopened() {
    let (task, mut proposal) = TURNING
        .poses(&[(10.0, true), (70.0, true), (90.0, true)])
        .unwrap();
    proposal.pivot = Vec2::new(f64::NAN, 0.0);
    assert_eq!(
        Candidate::evaluate(&task, &proposal).defects,
        [TaskDefect::Unopened]
    );
    proposal.places.clear();
    assert_eq!(
        Candidate::evaluate(&task, &proposal).defects,
        [TaskDefect::Unopened]
    );
}

proptest! {
    /// A defect is reported exactly where a motion in small steps has to leave the assembly.
    #[test]
    fn defects_match_stepwise_motion(
        crank in 60.0..400.0_f64,
        coupler in 100.0..400.0_f64,
        rocker in 100.0..400.0_f64,
        stops in prop::collection::vec((0.0..360.0_f64, any::<bool>()), 3..6),
    ) {
        let known = KnownFourBar { crank, coupler, rocker, ..TURNING };
        let Some((mut task, proposal)) = known.poses(&stops) else { return Ok(()) };
        task.preferences.ordered = false;
        let own = Candidate::evaluate(&task, &proposal);
        // Returns `true` if the crank, or the rocker in its place, moves from each point to the
        // next without a gap and on one side.
        let walks = |proposal: &Proposal, is_crank: bool| {
            let [a, d] = [known.a, known.d];
            let (pivot, other) = if is_crank { (a, d) } else { (d, a) };
            let lengths = if is_crank { (crank, rocker) } else { (rocker, crank) };
            let exists = |at: f64| {
                let far = (other - (pivot + unit(at) * lengths.0)).norm();
                far < coupler + lengths.1 && far > (coupler - lengths.1).abs()
            };
            let first = &proposal.places[0];
            let side = |[b, c]: &[Vec2; 2]| (*c - *b).cross(other - *c) > 0.0;
            let angle = |position: &[Vec2; 2]| degrees(position[0] - pivot);
            proposal.places.iter().all(|position| {
                let (from, to) = (angle(first), angle(position));
                let way = |span: f64| (0..=3600).all(|k| exists(from + span * f64::from(k) / 3600.0));
                let up = (to - from).rem_euclid(360.0);
                side(position) == side(first) && (way(up) || way(up - 360.0))
            })
        };
        let swapped = proposal.swapped().unwrap();
        let expected = walks(&proposal, true) || walks(&swapped, false);
        prop_assert_eq!(own.meets_task(), expected, "{:?}", own);
    }
}
