//! Compares the dyads of five poses with known ones and with those of Newton's method from many
//! starts.

use super::newton;
use super::planted::{KnownDyads, KnownLengths, turned, worst_miss};
use crate::poses::dyad::FullDyad;
use crate::poses::dyad_equations::Guidance;
use crate::poses::{PoseReach, five, propose};
use crate::{PinConstraint, Pose, PoseTask, Proposals};
use kinematics::numeric::SeededRng;
use kinematics::{Vec2, angle};

/// Returns all dyads; `None` if there may be others.
fn dyads(task: &PoseTask) -> Option<Vec<FullDyad>> {
    let all = five::dyads(&Guidance::new(task).unwrap())?;
    all.are_all.then_some(all.found)
}

fn both(task: &PoseTask) -> Proposals {
    propose(task, true, true, None, PoseReach::Usual)
}

/// Both known dyads are found, and the total is two or four, since they are roots of a real
/// quartic.
#[test]
fn both_planted_dyads_are_among_at_most_four() {
    let mut rng = SeededRng::new(1);
    for n in 0..400 {
        let planted = if n % 2 == 0 {
            KnownDyads::four_bar(&mut rng, 5, 15.0)
        } else {
            KnownDyads::slider_crank(&mut rng, 5, 15.0)
        };
        let found = dyads(&planted.task).unwrap();
        assert!([2, 4].contains(&found.len()), "{n}: {}", found.len());
        for which in [0, 1] {
            let off = planted.off(which, &found);
            assert!(off < 1e-9, "{n}: {off:e}");
        }
    }
}

#[test]
fn all_dyad_pairs_are_proposed_and_pass_through_poses() {
    let mut rng = SeededRng::new(2);
    let mut maximum = 0;
    for n in 0..200 {
        let planted = if n % 2 == 0 {
            KnownDyads::four_bar(&mut rng, 5, 15.0)
        } else {
            KnownDyads::slider_crank(&mut rng, 5, 15.0)
        };
        let count = dyads(&planted.task).unwrap().len();
        let all = both(&planted.task);
        assert!(all.is_complete && all.curves.is_empty());
        assert_eq!(all.found.len(), count * (count - 1) / 2, "{n}");
        assert!(planted.is_among(&all.found, 1e-9), "{n}");
        let size = Guidance::new(&planted.task).unwrap().size;
        let miss = worst_miss(&planted.task, &all.found);
        assert!(miss < 1e-11 * size, "{n}: {miss:e}");
        maximum = maximum.max(all.found.len());
        let kinds = [(true, false), (false, true)];
        let distance = kinds.map(|(four, slider)| {
            propose(&planted.task, four, slider, None, PoseReach::Usual).found
        });
        assert_eq!(distance[0].len() + distance[1].len(), all.found.len());
        assert!(
            distance[0]
                .iter()
                .all(|l| matches!(l.partner, PinConstraint::Rocker(_)))
        );
        assert!(
            distance[1]
                .iter()
                .all(|l| matches!(l.partner, PinConstraint::Slide(_)))
        );
    }
    assert_eq!(maximum, 6);
}

/// Checks that every dyad found by Newton's method from `starts` starts is among those of the
/// resultant, and returns their number.
fn met_by_newton(task: &PoseTask, rng: &mut SeededRng, starts: usize) -> usize {
    let found = dyads(task).unwrap();
    let mut seen: Vec<[Vec2; 2]> = Vec::new();
    for _ in 0..starts {
        let mut near = || Vec2::new(rng.within(-8.0, 8.0), rng.within(-8.0, 8.0));
        let start = [near(), near()];
        let Some([pivot, pin]) = newton::solution(task, start, 2.0) else {
            continue;
        };
        // Close to infinity every pin seems to be on a circle.
        if pivot.norm() > 1e3 || pin.norm() > 1e3 {
            continue;
        }
        let dyads = [(PinConstraint::Rocker(pivot), pin); 2];
        let off = KnownDyads {
            task: PoseTask::default(),
            dyads,
        }
        .off(0, &found);
        assert!(off < 1e-8, "{pivot:?} {pin:?} is missing: {off:e}");
        let is_near = |[p, w]: &[Vec2; 2]| (*p - pivot).norm() + (*w - pin).norm() < 1e-6;
        if !seen.iter().any(is_near) {
            seen.push([pivot, pin]);
        }
    }
    assert!(seen.len() <= found.len());
    seen.len()
}

#[test]
fn all_dyads_found_by_newton_are_present() {
    let mut rng = SeededRng::new(3);
    let planted = |rng: &mut SeededRng| KnownDyads::four_bar(rng, 5, 15.0).task;
    let tasks: Vec<PoseTask> = (0..30).map(|_| planted(&mut rng)).collect();
    let met: usize = tasks
        .iter()
        .map(|task| met_by_newton(task, &mut rng, 250))
        .sum();
    assert!(met > 60, "{met}");
}

/// Mirrored poses, origins on a line and on a circle, and pairs of equal angles: pins with equal x
/// or y, and dyads at infinity.
#[test]
fn special_poses_have_all_dyads_found_by_newton() {
    let task = |poses: [(f64, f64, f64); 5]| PoseTask {
        poses: poses
            .map(|(x, y, angle)| Pose {
                at: Vec2::new(x, y),
                angle,
            })
            .to_vec(),
        ..PoseTask::default()
    };
    let on_circle = [
        (0.0, 10.0),
        (35.0, -20.0),
        (80.0, 5.0),
        (140.0, 60.0),
        (200.0, 35.0),
    ];
    let tasks = [
        task([
            (-2.0, 0.8, -35.0),
            (-0.7, 0.1, -15.0),
            (0.0, 0.0, 0.0),
            (0.7, 0.1, 15.0),
            (2.0, 0.8, 35.0),
        ]),
        task([
            (-2.0, 0.8, 35.0),
            (-1.0, 0.2, 10.0),
            (0.0, 0.1, 0.0),
            (1.0, 0.2, -10.0),
            (2.0, 0.8, -35.0),
        ]),
        task([
            (0.0, 0.0, 0.0),
            (1.0, 0.0, 20.0),
            (2.0, 0.0, 70.0),
            (3.0, 0.0, 50.0),
            (4.0, 0.0, -10.0),
        ]),
        on_a_circle(&on_circle),
        task([
            (0.0, 0.0, 10.0),
            (1.0, 0.3, 10.0),
            (2.5, 1.0, 40.0),
            (2.0, -1.0, 40.0),
            (3.0, 2.0, 75.0),
        ]),
        task([
            (0.0, 0.0, 10.0),
            (1.0, 0.3, 10.0),
            (2.5, 1.0, 10.0),
            (2.0, -1.0, 40.0),
            (3.0, 2.0, 75.0),
        ]),
    ];
    let mut rng = SeededRng::new(8);
    let met: Vec<usize> = tasks
        .iter()
        .map(|task| met_by_newton(task, &mut rng, 400))
        .collect();
    assert!(met.iter().sum::<usize>() >= 8, "{met:?}");
    // Coordinates of zero are exact, without rounding errors.
    let mirrored = dyads(&tasks[0]).unwrap();
    assert!(mirrored.iter().all(|held| held.pin.x == 0.0));
    // The origin itself is on the circle.
    let middle = KnownDyads {
        task: PoseTask::default(),
        dyads: [(PinConstraint::Rocker(Vec2::ZERO), Vec2::ZERO); 2],
    };
    assert!(middle.off(0, &dyads(&on_a_circle(&on_circle)).unwrap()) < 1e-12);
}

fn on_a_circle(places: &[(f64, f64)]) -> PoseTask {
    let pose = |(around, angle): &(f64, f64)| Pose {
        at: turned(2.0, *around),
        angle: *angle,
    };
    PoseTask {
        poses: places.iter().map(pose).collect(),
        ..PoseTask::default()
    }
}

/// Poses that nearly repeat, poses close to each other, and distant pivots: the dyads of the
/// rounded poses agree to nearly all digits. (The known ones differ by the effect of rounding the
/// poses: up to 1e-8 if two poses are a hundredth of a degree apart.)
#[test]
fn nearly_degenerate_poses_lose_no_digits() {
    let mut rng = SeededRng::new(4);
    let steps: [([f64; 5], f64); 8] = [
        ([0.0, 1e-2, 40.0, 80.0, 120.0], 1.0),
        ([0.0, 1e-4, 40.0, 80.0, 120.0], 1.0),
        ([0.0, 1e-6, 40.0, 80.0, 120.0], 1.0),
        ([0.0, 1e-3, 40.0, 40.001, 120.0], 1.0),
        ([0.0, 5.0, 10.0, 15.0, 20.0], 1.0),
        ([0.0, 1.0, 2.0, 3.0, 4.0], 1.0),
        ([0.0, 25.0, 50.0, 75.0, 100.0], 126.0),
        ([0.0, 25.0, 50.0, 75.0, 100.0], 1e4),
    ];
    for (steps, far) in steps {
        let (mut checked, mut open) = (0, 0);
        for n in 0..120 {
            let mut shape = KnownLengths::four_bar(&mut rng);
            if far > 1.0 {
                shape.rest *= far;
                let base = turned(shape.rest + rng.within(-0.3, 0.3), rng.within(0.0, 360.0));
                shape.partner = PinConstraint::Rocker(shape.pivot + base);
            }
            let from = rng.within(0.0, 360.0);
            let poses: Option<Vec<Pose>> =
                steps.iter().map(|step| shape.pose(from + step)).collect();
            let Some(poses) = poses else {
                continue;
            };
            let mut planted = shape.planted(poses);
            let all = five::dyads(&Guidance::new(&planted.task).unwrap()).unwrap();
            let found = all.found;
            open += usize::from(!all.are_all);
            let mut extent: f64 = 1.0;
            for (by, pin) in &mut planted.dyads {
                let PinConstraint::Rocker(pivot) = *by else {
                    panic!("a four-bar has two pivots");
                };
                let exact = newton::solution(&planted.task, [pivot, *pin], far);
                let [pivot, exact] = exact.unwrap_or_else(|| panic!("{steps:?} {n}"));
                extent = extent.max(pivot.norm());
                *by = PinConstraint::Rocker(pivot);
                *pin = exact;
            }
            for which in [0, 1] {
                let off = planted.off(which, &found);
                assert!(off <= 1e-13 * extent, "{steps:?} {far} {n}: {off:e}");
            }
            checked += 1;
        }
        assert!(checked > 30 && open <= 1, "{steps:?}: {checked} {open}");
    }
}

/// An error of 1e-6 in the poses changes the dyads by that error times a condition number, which is
/// below a thousand for nearly all linkages with well-separated poses.
#[test]
fn small_noise_moves_dyads_slightly() {
    let mut rng = SeededRng::new(6);
    let mut offs: Vec<f64> = Vec::new();
    for _ in 0..200 {
        let mut planted = KnownDyads::four_bar(&mut rng, 5, 30.0);
        for pose in &mut planted.task.poses {
            pose.at += Vec2::new(rng.within(-1e-6, 1e-6), rng.within(-1e-6, 1e-6));
        }
        let found = dyads(&planted.task).unwrap();
        offs.push(planted.off(0, &found).max(planted.off(1, &found)));
    }
    offs.sort_by(f64::total_cmp);
    assert!(
        offs[100] < 1e-4 && offs[180] < 1e-2,
        "{:e} {:e}",
        offs[100],
        offs[180]
    );
}

/// Scaling the poses changes only their rounding.
#[test]
fn scaling_poses_scales_dyads() {
    let mut rng = SeededRng::new(7);
    for scale in [1e-6, 1.0, 1e7] {
        for _ in 0..40 {
            let mut planted = KnownDyads::four_bar(&mut rng, 5, 20.0);
            let before = dyads(&planted.task).unwrap();
            for pose in &mut planted.task.poses {
                pose.at = pose.at * scale;
            }
            let found = dyads(&planted.task).unwrap();
            assert_eq!(found.len(), before.len());
            for (by, pin) in &mut planted.dyads {
                *pin = *pin * scale;
                if let PinConstraint::Rocker(pivot) = by {
                    *pivot = *pivot * scale;
                }
            }
            for which in [0, 1] {
                assert!(planted.off(which, &found) < 1e-9 * scale);
            }
        }
    }
}

/// A parallelogram's coupler only translates: every pin has a pivot, so that a finite number of
/// dyads is never complete.
#[test]
fn parallelogram_has_infinitely_many_dyads() {
    let poses = [0.0, 30.0, 75.0, 140.0, 200.0].map(|crank| Pose {
        at: Vec2::new(1.0, 2.0) + turned(1.5, crank),
        angle: 20.0,
    });
    let task = PoseTask {
        poses: poses.to_vec(),
        ..PoseTask::default()
    };
    assert_eq!(dyads(&task), None);
    let all = both(&task);
    assert!(!all.is_complete && !all.found.is_empty() && all.found.len() <= 100);
    assert!(worst_miss(&task, &all.found) < 1e-12);
    for linkage in &all.found {
        let (crank, _, rocker) = linkage.lengths().unwrap();
        assert!((crank - 1.5).abs() < 1e-9 && (rocker.unwrap() - 1.5).abs() < 1e-9);
    }
}

/// Translations off a circle have no link; translations along a line have only slides.
#[test]
fn translations_off_circle_have_no_linkage() {
    let at = |places: [(f64, f64); 5]| PoseTask {
        poses: places
            .map(|(x, y)| Pose {
                at: Vec2::new(x, y),
                angle: -3.0,
            })
            .to_vec(),
        ..PoseTask::default()
    };
    let scattered = at([(0.0, 0.0), (1.0, 0.2), (2.0, 1.0), (2.5, -1.0), (0.4, 3.0)]);
    assert!(both(&scattered).found.is_empty());
    let line = at([(0.0, 0.0), (1.0, 0.5), (2.0, 1.0), (5.0, 2.5), (-3.0, -1.5)]);
    assert!(both(&line).found.is_empty());
}

/// A body that rotates about a fixed point gets no linkage with a link of zero length.
#[test]
fn rotation_about_point_gives_no_zero_length_crank() {
    let pole = Vec2::new(3.0, -1.0);
    let poses = [0.0, 20.0, 50.0, 110.0, 170.0].map(|turn| Pose {
        at: pole + turned(2.0, turn + 10.0),
        angle: turn,
    });
    let task = PoseTask {
        poses: poses.to_vec(),
        ..PoseTask::default()
    };
    let all = both(&task);
    assert!(
        all.found.iter().all(|l| l.lengths().unwrap().0 > 1e-6),
        "{:?}",
        all.found
    );
    assert!(!all.is_complete);
}

/// Four poses of a square rotate about its middle, so that some equations are dependent. With a
/// fifth pose there is a line of pins, all with the middle as their pivot, so that no two of them
/// form a linkage.
#[test]
fn dependent_poses_have_curve_of_dyads() {
    let places = [
        (0.0, 0.0, 0.0),
        (1.0, 0.0, 90.0),
        (1.0, 1.0, 180.0),
        (0.0, 1.0, 270.0),
        (2.0, 2.0, 45.0),
    ];
    let pose = |(x, y, angle)| Pose {
        at: Vec2::new(x, y),
        angle,
    };
    let task = PoseTask {
        poses: places.map(pose).to_vec(),
        ..PoseTask::default()
    };
    let all = both(&task);
    assert!(!all.is_complete && all.found.is_empty());
    let curve: Vec<_> = all.curves.iter().flatten().collect();
    assert!(curve.len() > 50);
    let middle = Vec2::new(0.5, 0.5);
    for dyad in curve {
        assert!(matches!(dyad.held, PinConstraint::Rocker(at) if (at - middle).norm() < 1e-12));
    }
}

/// Cardan's motion: two pins on perpendicular lines. Every pin of a circle moves along a line, and
/// the circle's centre moves on a circle.
#[test]
fn elliptic_trammel_has_family_of_slides() {
    let poses = [10.0, 40.0, 75.0, 160.0, 250.0].map(|turn| {
        let along = angle::unit(turn);
        Pose {
            at: Vec2::new(2.0 * along.x, 0.0),
            angle: 180.0 - turn,
        }
    });
    let task = PoseTask {
        poses: poses.to_vec(),
        ..PoseTask::default()
    };
    let all = both(&task);
    assert!(!all.is_complete && !all.found.is_empty());
    assert!(worst_miss(&task, &all.found) < 1e-11);
    for linkage in &all.found {
        assert!(linkage.pivot.norm() < 1e-9, "{linkage:?}");
        assert!((linkage.lengths().unwrap().0 - 1.0).abs() < 1e-9);
        assert!(matches!(linkage.partner, PinConstraint::Slide(_)));
    }
}

/// A given pivot or pin is kept exactly, and the result contains only linkages with it; a pivot
/// that fits no dyad gives an empty result.
#[test]
fn given_pivots_and_pins_are_kept() {
    let mut rng = SeededRng::new(9);
    for _ in 0..40 {
        let planted = KnownDyads::four_bar(&mut rng, 5, 20.0);
        let [(PinConstraint::Rocker(a), b), (PinConstraint::Rocker(d), c)] = planted.dyads else {
            panic!("a four-bar has two pivots");
        };
        let count = dyads(&planted.task).unwrap().len();
        let with = |pivots: &[Vec2], pins: &[Vec2]| {
            let task = PoseTask {
                poses: planted.task.poses.clone(),
                pivots: pivots.to_vec(),
                pins: pins.to_vec(),
            };
            both(&task)
        };
        let one = with(&[a], &[]);
        assert_eq!(one.found.len(), count - 1);
        assert!(
            one.found
                .iter()
                .all(|l| l.pivot == a || l.partner == PinConstraint::Rocker(a))
        );
        for found in [
            with(&[a, d], &[]),
            with(&[a], &[c]),
            with(&[], &[b, c]),
            with(&[a, d], &[b, c]),
        ] {
            assert!(found.is_complete && found.found.len() == 1);
            assert!(planted.is_among(&found.found, 1e-9));
        }
        let none = with(&[a + Vec2::new(0.1, 0.0)], &[]);
        assert!(none.is_complete && none.found.is_empty());
    }
}

#[test]
fn degenerate_poses_give_finite_linkages() {
    let pose = |x: f64, y: f64, angle: f64| Pose {
        at: Vec2::new(x, y),
        angle,
    };
    let sets = [
        vec![],
        vec![pose(1.0, 2.0, 3.0)],
        vec![pose(1.0, 2.0, 3.0); 5],
        vec![
            pose(f64::NAN, 0.0, 0.0),
            pose(1.0, 0.0, 0.0),
            pose(2.0, 0.0, 0.0),
        ],
        vec![
            pose(1e300, 0.0, 0.0),
            pose(-1e300, 1e300, 1.0),
            pose(2.0, 0.0, 1e300),
        ],
        vec![
            pose(1e-320, 0.0, 0.0),
            pose(0.0, 1e-320, 1.0),
            pose(0.0, 0.0, 2.0),
        ],
        (0..5).map(|k| pose(0.0, 0.0, f64::from(k))).collect(),
        (0..12)
            .map(|k| pose(f64::from(k), f64::from(k * k), f64::from(k)))
            .collect(),
    ];
    for poses in sets {
        let task = PoseTask {
            poses,
            ..PoseTask::default()
        };
        for linkage in both(&task).found {
            assert!(linkage.places.iter().flatten().all(|at| at.is_finite()));
        }
    }
}
