//! Round trips: the motion of a known linkage becomes a task, and [`Synthesis::run`] finds the
//! linkage again. Also compares values with the solver's own.

use super::planted::KnownLinkage;
use crate::machine::Machine;
use crate::poses::{PoseReach, propose};
use crate::*;
use kinematics::Vec2;
use kinematics::angle::{degrees, unit};
use kinematics::numeric::SeededRng;
use kinematics::solver::{Condition, Order};

const ORDER: SynthesisSettings = SynthesisSettings {
    seed: 1,
    threads: 2,
};

fn task(kind: TaskKind) -> Task {
    Task {
        kind,
        four_bars: true,
        slider_cranks: false,
        preferences: Preferences {
            ordered: true,
            ..Preferences::default()
        },
    }
}

/// Returns the poses of the coupler, with the tracer as its origin.
fn poses(proposal: &Proposal) -> Vec<Pose> {
    let places = proposal.places.iter().enumerate();
    let pose = |(point, [b, c]): (usize, &[Vec2; 2])| Pose {
        at: super::planted::tracer(proposal, point),
        angle: degrees(*c - *b),
    };
    places.map(pose).collect()
}

/// Returns the candidate nearest to a known linkage, and the largest difference of its pivots and
/// first pins, relative to the size.
fn nearest<'c>(
    found: impl IntoIterator<Item = &'c Candidate>,
    planted: &Proposal,
    size: f64,
) -> Option<(f64, &'c Candidate)> {
    let off = |one: &Proposal| match (one.partner, planted.partner) {
        (PinConstraint::Rocker(a), PinConstraint::Rocker(b)) => {
            let [p, q] = [one.places[0], planted.places[0]];
            let parts = [a - b, one.pivot - planted.pivot, p[0] - q[0], p[1] - q[1]];
            parts.map(Vec2::norm).into_iter().fold(0.0, f64::max) / size
        }
        _ => f64::INFINITY,
    };
    let off = |candidate: &'c Candidate| {
        let swapped = candidate.proposal.swapped();
        let other = swapped.map_or(f64::INFINITY, |swapped| off(&swapped));
        (off(&candidate.proposal).min(other), candidate)
    };
    let all = found.into_iter().map(off);
    all.min_by(|one, other| one.0.total_cmp(&other.0))
}

/// Checks that a synthesis finds the known linkage with the same evaluation as the linkage itself.
fn assert_found_again(task: &Task, planted: &Proposal, size: f64, within: f64) {
    let found = Synthesis::run(task, ORDER, &mut |_| true);
    let all = found.good.iter().chain(&found.defective);
    let (off, candidate) = nearest(all, planted, size).expect("something is found");
    assert!(off < within, "{off}: {planted:?}");
    let own = Candidate::evaluate(task, planted);
    assert_eq!(
        candidate.meets_task(),
        own.meets_task(),
        "{candidate:?} {own:?}"
    );
    assert_eq!(candidate.defects, own.defects);
    let distance = (candidate.figures.transmission - own.figures.transmission).abs();
    assert!(distance < 1e3 * within, "{distance}");
    assert!(found.good.iter().all(|c| c.defects.is_empty()));
    assert!(found.defective.iter().all(|c| !c.defects.is_empty()));
    for (k, one) in found.good.iter().enumerate() {
        assert!(!found.good[..k].iter().any(|other| other.is_same(one)));
    }
}

/// Calls `each` with random four-bars that reach these turns, with and without defects.
fn each_planted(count: usize, turns: &[f64], each: &mut dyn FnMut(&KnownLinkage, &Proposal)) {
    let mut rng = SeededRng::new(17);
    let mut seen = [0, 0];
    while seen[0] + seen[1] < count {
        let planted = KnownLinkage::random(&mut rng, false);
        let Some(mut proposal) = planted.proposal(turns) else {
            continue;
        };
        // Half of them in an order in which the crank turns back.
        if seen[1] < count / 2 {
            proposal = planted
                .proposal(&turns_back(turns))
                .expect("the same turns");
            seen[1] += 1;
        } else {
            seen[0] += 1;
        }
        each(&planted, &proposal);
    }
    assert!(seen[0] > 0 && seen[1] > 0);
}

/// Moves the last turn to the second position.
fn turns_back(turns: &[f64]) -> Vec<f64> {
    let mut turns = turns.to_vec();
    let last = turns.pop().expect("there are turns");
    turns.insert(1, last);
    turns
}

#[test]
fn three_poses_with_pivots_recover_linkage() {
    each_planted(24, &[0.0, 25.0, 60.0], &mut |planted, proposal| {
        let PinConstraint::Rocker(d) = planted.far else {
            unreachable!("a four-bar")
        };
        let task = task(TaskKind::Poses(PoseTask {
            poses: poses(proposal),
            pivots: vec![planted.pivot, d],
            ..PoseTask::default()
        }));
        assert_found_again(&task, proposal, planted.size(), 1e-6);
    });
}

#[test]
fn five_poses_recover_linkage() {
    let turns = [0.0, 30.0, 65.0, 95.0, 130.0];
    each_planted(12, &turns, &mut |planted, proposal| {
        let task = task(TaskKind::Poses(PoseTask {
            poses: poses(proposal),
            ..PoseTask::default()
        }));
        assert_found_again(&task, proposal, planted.size(), 1e-5);
    });
}

/// Within one degree of the crank: as accurate as the rounding of the poses allows, which matters
/// more the closer they are.
#[test]
fn five_nearly_repeated_poses_recover_linkage() {
    let turns = [0.0, 0.25, 0.5, 0.75, 1.0];
    each_planted(12, &turns, &mut |planted, proposal| {
        let task = task(TaskKind::Poses(PoseTask {
            poses: poses(proposal),
            ..PoseTask::default()
        }));
        assert_found_again(&task, proposal, planted.size(), 1e-3);
    });
}

/// Returns the function of a known four-bar with its pivots along +x.
fn function(planted: &KnownLinkage, turns: &[f64]) -> Option<(FunctionTask, Proposal)> {
    let planted = KnownLinkage {
        pivot: Vec2::ZERO,
        far: PinConstraint::Rocker(Vec2::new(2.0, 0.0)),
        ..planted.clone()
    };
    let mut proposal = planted.proposal(turns)?;
    proposal.tracer = None;
    let output = |[_, c]: &[Vec2; 2]| degrees(*c - Vec2::new(2.0, 0.0));
    let first = output(&proposal.places[0]);
    let pairs = turns.iter().zip(&proposal.places);
    let task = FunctionTask {
        pairs: pairs
            .map(|(turn, position)| {
                [
                    *turn,
                    kinematics::angle::unwrap_near(first, output(position)) - first,
                ]
            })
            .collect(),
        between: Vec::new(),
        output: Output::Angle,
        crank_datum: GivenNumber::Value(planted.start),
        crank_scale: GivenNumber::Value(1.0),
        output_datum: GivenNumber::Value(first),
        output_scale: GivenNumber::Value(1.0),
        size: 2.0,
    };
    Some((task, proposal))
}

#[test]
fn function_pairs_recover_linkage() {
    let mut rng = SeededRng::new(23);
    let mut seen = 0;
    while seen < 24 {
        let planted = KnownLinkage::random(&mut rng, false);
        let Some((function, proposal)) = function(&planted, &[0.0, 35.0, 80.0]) else {
            continue;
        };
        seen += 1;
        assert_found_again(
            &task(TaskKind::Function(function)),
            &proposal,
            planted.size().max(2.0),
            1e-6,
        );
    }
}

/// From pair to pair the crank turns by more than half a turn, and more than one turn in all: it
/// turns as the scale says, not the shorter way.
#[test]
fn crank_turns_by_its_scale_beyond_half_turn() {
    let planted = KnownLinkage {
        pivot: Vec2::ZERO,
        far: PinConstraint::Rocker(Vec2::new(2.0, 0.0)),
        crank: 0.5,
        coupler: 1.9,
        rocker: 1.2,
        arm: Vec2::ZERO,
        start: 40.0,
        sign: 1.0,
        across: 0.1,
    };
    let turns = [0.0, 200.0, 470.0];
    let (function, proposal) = function(&planted, &turns).expect("the crank turns fully");
    let task = task(TaskKind::Function(function));
    let judged = Candidate::evaluate(&task, &proposal);
    assert_eq!(judged.defects, []);
    for (at, turn) in judged.at.iter().zip(turns) {
        assert!((at - 40.0 - turn).abs() < 1e-9, "{:?}", judged.at);
    }
    assert!(judged.figures.miss < 1e-9, "{:?}", judged.figures);
    let minimum = [1.5, 2.5].map(|across: f64| angle_of(1.9, 1.2, across));
    let minimum = minimum[0].min(minimum[1]);
    assert!((judged.figures.transmission - minimum).abs() < 1e-9);
}

/// Returns the angle between two sides of a triangle, from the third; between two lines, so at most
/// 90 deg.
fn angle_of(a: f64, b: f64, across: f64) -> f64 {
    let cosine = (a * a + b * b - across * across) / (2.0 * a * b);
    cosine.abs().min(1.0).acos().to_degrees()
}

#[test]
fn same_seed_gives_same_synthesis_for_any_thread_count() {
    let points = [[0.0, 0.0], [10.0, 4.0], [20.0, 5.0], [30.0, 3.0]];
    let path = task(TaskKind::Path(PathTask {
        points: points.map(|[x, y]| Vec2::new(x, y)).to_vec(),
        weights: vec![1.0; 4],
        ..PathTask::default()
    }));
    let pose = |x: f64, y: f64, angle: f64| Pose {
        at: Vec2::new(x, y),
        angle,
    };
    let poses = task(TaskKind::Poses(PoseTask {
        poses: vec![
            pose(0.0, 0.0, 0.0),
            pose(120.0, 40.0, 35.0),
            pose(180.0, 130.0, 80.0),
        ],
        ..PoseTask::default()
    }));
    for task in [path, poses] {
        let on = |threads: usize| {
            let order = SynthesisSettings { seed: 5, threads };
            Synthesis::run(&task, order, &mut |_| true)
        };
        let one = on(1);
        assert!(!one.good.is_empty());
        assert!(one == on(2) && one == on(4));
    }
}

/// Returns the minimum angle between coupler and rocker, or between coupler and the guide's normal,
/// in degrees, sampled by the solver.
fn sampled_transmission(task: &Task, candidate: &Candidate) -> f64 {
    let machine = Machine::open(task, &candidate.proposal).expect("sound");
    let Machine {
        solver, c, coupler, ..
    } = machine;
    let mut state = solver.state();
    let ends = candidate.at.iter().copied();
    let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| {
        (low.min(at), high.max(at))
    });
    let high = match &task.kind {
        TaskKind::Path(path) if path.closed => low + 360.0,
        _ => high,
    };
    let mut minimum = f64::INFINITY;
    for k in 0..=4000 {
        let at = low + (high - low) * f64::from(k) / 4000.0;
        if solver.solve(at, Order::Position, &mut state) == Condition::NoAssembly {
            return f64::NAN;
        }
        let rod = state.direction(coupler).unwrap();
        let across = match candidate.proposal.partner {
            PinConstraint::Rocker(d) => d - state.position(c).unwrap(),
            PinConstraint::Slide(along) => unit(along).perp(),
        };
        let sine = rod.cross(across).abs() / across.norm();
        minimum = minimum.min(sine.min(1.0).asin().to_degrees());
    }
    minimum
}

#[test]
fn minimum_transmission_angle_matches_sampling() {
    let mut rng = SeededRng::new(29);
    let mut seen = [0; 3];
    while seen.iter().any(|seen| *seen < 12) {
        let slides = seen[0] > seen[1];
        let planted = KnownLinkage::random(&mut rng, slides);
        let turns: Vec<f64> = (0..5).map(|k| f64::from(k) * 50.0).collect();
        let turns = if seen[0] % 2 == 0 {
            turns
        } else {
            turns.iter().map(|turn| -0.3 * turn).collect()
        };
        let Some(proposal) = planted.proposal(&turns) else {
            continue;
        };
        let points = (0..turns.len()).map(|point| super::planted::tracer(&proposal, point));
        let mut task = task(TaskKind::Path(PathTask {
            points: points.collect(),
            closed: turns[4] > 0.0,
            weights: vec![1.0; turns.len()],
            ..PathTask::default()
        }));
        task.slider_cranks = true;
        let judged = Candidate::evaluate(&task, &proposal);
        if !judged.meets_task() {
            // A swinging crank cannot complete a closed path.
            continue;
        }
        seen[usize::from(slides)] += 1;
        seen[2] += usize::from(judged.figures.full_turn);
        let sampled = sampled_transmission(&task, &judged);
        let value = judged.figures.transmission;
        assert!(
            value <= sampled + 1e-9 && sampled < value + 0.01,
            "{value} {sampled}"
        );
    }
}

#[test]
fn misses_are_weighted() {
    let planted = KnownLinkage {
        pivot: Vec2::ZERO,
        far: PinConstraint::Rocker(Vec2::new(2.0, 0.0)),
        crank: 0.5,
        coupler: 1.9,
        rocker: 1.2,
        arm: Vec2::new(0.5, 0.4),
        start: 40.0,
        sign: 1.0,
        across: 0.1,
    };
    let proposal = planted.proposal(&[0.0, 50.0, 90.0]).expect("it turns");
    let mut points: Vec<Vec2> = (0..3)
        .map(|point| super::planted::tracer(&proposal, point))
        .collect();
    points[1] += Vec2::new(0.3, 0.4);
    points[2] += Vec2::new(0.0, 1.0);
    let task = task(TaskKind::Path(PathTask {
        points,
        weights: vec![1.0, 4.0, 3.0],
        ..PathTask::default()
    }));
    let figures = Candidate::evaluate(&task, &proposal).figures;
    assert!((figures.miss - 1.0).abs() < 1e-9);
    // (4 * 0.5^2 + 3 * 1^2) / 8.
    assert!((figures.rms - 0.5_f64.sqrt()).abs() < 1e-9, "{figures:?}");
    assert!((figures.ratio - 2.0 / 0.5).abs() < 1e-12);
}

#[test]
fn swinging_crank_fails_closed_path() {
    // The coupler is too short for the crank to turn.
    let planted = KnownLinkage {
        pivot: Vec2::ZERO,
        far: PinConstraint::Rocker(Vec2::new(2.0, 0.0)),
        crank: 1.5,
        coupler: 0.7,
        rocker: 1.2,
        arm: Vec2::new(0.5, 0.4),
        start: 30.0,
        sign: 1.0,
        across: 0.1,
    };
    let turns = [0.0, 5.0, 10.0];
    let proposal = planted.proposal(&turns).expect("it comes there");
    let points = (0..3).map(|point| super::planted::tracer(&proposal, point));
    let path = PathTask {
        points: points.collect(),
        weights: vec![1.0; 3],
        ..PathTask::default()
    };
    let open = task(TaskKind::Path(path.clone()));
    assert_eq!(Candidate::evaluate(&open, &proposal).defects, []);
    let closed = task(TaskKind::Path(PathTask {
        closed: true,
        ..path
    }));
    let judged = Candidate::evaluate(&closed, &proposal);
    assert!(!judged.figures.full_turn);
    assert_eq!(judged.defects, [TaskDefect::Order { from: 2, to: 0 }]);
}

/// For four poses near each other, pivots and pins are further away than the distance between the
/// poses. If no linkage within the usual reach does the task, a wider reach is searched.
#[test]
fn four_nearby_poses_have_working_linkages() {
    let mut rng = SeededRng::new(23);
    let (mut done, mut narrow) = (0, 0);
    let mut seen = 0;
    while seen < 12 {
        let planted = KnownLinkage::random(&mut rng, false);
        let Some(proposal) = planted.proposal(&[0.0, 2.0, 4.0, 6.0]) else {
            continue;
        };
        let through = PoseTask {
            poses: poses(&proposal),
            ..PoseTask::default()
        };
        let usual = propose(&through, true, false, None, PoseReach::Usual);
        let task = task(TaskKind::Poses(through));
        if !Candidate::evaluate(&task, &proposal).meets_task() {
            continue;
        }
        seen += 1;
        narrow += usize::from(!Synthesis::of(&task, usual, 2).good.is_empty());
        let found = Synthesis::run(&task, ORDER, &mut |_| true);
        done += usize::from(!found.good.is_empty());
    }
    assert!(done >= 10 && narrow < done - 3, "{done} {narrow}");
}
