//! Compares the curve of four poses with slices of it and with known dyads.

use super::planted::{KnownDyads, KnownLengths, worst_miss};
use crate::poses::dyad::FullDyad;
use crate::poses::dyad_equations::Guidance;
use crate::poses::{PoseReach, four, propose};
use crate::{PinConstraint, Pose, PoseTask, Proposal};
use kinematics::numeric::SeededRng;
use kinematics::{Vec2, angle};

fn pieces(task: &PoseTask) -> Vec<Vec<FullDyad>> {
    four::pieces(&Guidance::new(task).unwrap())
}

/// Returns a determinant that is zero if four poses put a pin on a circle or a line, from squares
/// and coordinates in doubles.
fn cubic(task: &PoseTask, pin: Vec2) -> f64 {
    let rows: Vec<[f64; 4]> = task
        .poses
        .iter()
        .map(|pose| {
            let at = pose.at + pin.turned(angle::unit(pose.angle));
            [at.norm2(), at.x, at.y, 1.0]
        })
        .collect();
    nalgebra::Matrix4::from_fn(|i, k| rows[i][k]).determinant()
}

fn distance(pieces: &[Vec<FullDyad>], pin: Vec2) -> f64 {
    let to_segment = |pair: &[FullDyad]| {
        let along = pair[1].pin - pair[0].pin;
        let part = ((pin - pair[0].pin).dot(along) / along.norm2()).clamp(0.0, 1.0);
        (pair[0].pin + along * part - pin).norm()
    };
    let all = pieces
        .iter()
        .flat_map(|piece| piece.windows(2).map(to_segment));
    all.fold(f64::INFINITY, f64::min)
}

/// Checks, along lines over the whole body, that every root of the determinant is on a traced
/// piece. Returns the number of roots.
fn sliced(task: &PoseTask, pieces: &[Vec<FullDyad>]) -> usize {
    let mut roots = 0;
    for line in -12..=12 {
        for is_level in [true, false] {
            let at = |s: f64| {
                let across = f64::from(line) * 0.5 + 0.01;
                if is_level {
                    Vec2::new(s, across)
                } else {
                    Vec2::new(across, s)
                }
            };
            let places = (-300..=300).map(|k| f64::from(k) * 0.02);
            let values: Vec<(f64, f64)> = places.map(|s| (s, cubic(task, at(s)))).collect();
            for ends in values
                .windows(2)
                .filter(|ends| ends[0].1 * ends[1].1 <= 0.0)
            {
                let middle = at(0.5 * (ends[0].0 + ends[1].0));
                let off = distance(pieces, middle);
                assert!(off < 0.02, "{middle:?} is {off} from the curve");
                roots += 1;
            }
        }
    }
    roots
}

#[test]
fn curve_includes_all_branches_and_ovals() {
    let mut rng = SeededRng::new(11);
    let (mut roots, mut ovals) = (0, 0);
    for _ in 0..24 {
        let planted = KnownDyads::four_bar(&mut rng, 4, 20.0);
        let pieces = pieces(&planted.task);
        ovals += pieces
            .iter()
            .filter(|p| p.len() > 1 && p[0].pin == p[p.len() - 1].pin)
            .count();
        roots += sliced(&planted.task, &pieces);
    }
    assert!(roots > 1200 && ovals > 4, "{roots} {ovals}");
}

/// Spots are as close to each other as they are drawn, and all of them pass through the poses.
#[test]
fn curve_is_traced_in_small_steps() {
    let mut rng = SeededRng::new(12);
    for n in 0..40 {
        let planted = if n % 2 == 0 {
            KnownDyads::four_bar(&mut rng, 4, 15.0)
        } else {
            KnownDyads::slider_crank(&mut rng, 4, 15.0)
        };
        let size = Guidance::new(&planted.task).unwrap().size;
        let pieces = pieces(&planted.task);
        let count: usize = pieces.iter().map(Vec::len).sum();
        assert!((100..6000).contains(&count), "{n}: {count}");
        for pair in pieces.iter().flat_map(|piece| piece.windows(2)) {
            let step = (pair[1].pin - pair[0].pin).norm();
            // Within view, which is a few sizes; further out, steps are longer in proportion to
            // their distance as seen from the middle.
            let out = pair[0].pin.norm().max(pair[1].pin.norm()) / size;
            assert!(
                step <= 0.1 * size * (1.0 + out * out),
                "{n}: {step} at {out}"
            );
        }
        for held in pieces.iter().flatten() {
            if let PinConstraint::Rocker(pivot) = held.by {
                let first = (held.places[0] - pivot).norm();
                let off = held
                    .places
                    .iter()
                    .map(|at| ((*at - pivot).norm() - first).abs());
                let maximum = off.fold(0.0, f64::max);
                assert!(
                    maximum <= 1e-9 * size + 1e-15 * first,
                    "{n}: {maximum:e} of {first}"
                );
            }
        }
    }
}

/// Known dyads are on the curve. A given pivot or pin of one of them yields the known dyad.
#[test]
fn planted_dyads_are_on_curve() {
    let mut rng = SeededRng::new(13);
    for n in 0..40 {
        let planted = KnownDyads::four_bar(&mut rng, 4, 20.0);
        let pieces = pieces(&planted.task);
        let guidance = Guidance::new(&planted.task).unwrap();
        for which in [0, 1] {
            let (PinConstraint::Rocker(pivot), pin) = planted.dyads[which] else {
                panic!("a four-bar has two pivots");
            };
            assert!(distance(&pieces, pin) < 0.05, "{n}");
            let by_pivot = guidance.on_pivot(pivot).unwrap_or_else(|| panic!("{n}"));
            let by_pin = guidance.on_pin(pin).unwrap_or_else(|| panic!("{n}"));
            assert!(planted.off(which, &[by_pivot]) < 1e-9, "{n}");
            assert!(planted.off(which, &[by_pin]) < 1e-9, "{n}");
            assert_eq!(guidance.on_pivot(pivot + Vec2::new(0.01, 0.02)), None);
        }
    }
}

/// The single slide of four poses is the known one. It is on the curve where the pivots pass
/// through infinity.
#[test]
fn slide_of_four_poses_is_planted_slide() {
    let mut rng = SeededRng::new(14);
    for n in 0..40 {
        let planted = KnownDyads::slider_crank(&mut rng, 4, 20.0);
        let slides = pieces(&planted.task).into_iter().flatten();
        let slides: Vec<FullDyad> = slides
            .filter(|h| matches!(h.by, PinConstraint::Slide(_)))
            .collect();
        let off = planted.off(1, &slides);
        assert!(off < 1e-9, "{n}: {off:e} of {}", slides.len());
    }
}

#[test]
fn linkages_of_four_poses_pass_through_them() {
    let mut rng = SeededRng::new(15);
    for n in 0..30 {
        let planted = KnownDyads::four_bar(&mut rng, 4, 20.0);
        let all = propose(&planted.task, true, true, None, PoseReach::Usual);
        assert!(!all.is_complete && all.found.len() <= 200, "{n}");
        assert!(all.found.len() > 30, "{n}: {}", all.found.len());
        let size = Guidance::new(&planted.task).unwrap().size;
        let miss = worst_miss(&planted.task, &all.found);
        assert!(miss < 1e-10 * size, "{n}: {miss:e}");
        let inside = [Vec2::new(-4.0, -4.0), Vec2::new(4.0, 4.0)];
        let boxed = propose(&planted.task, true, false, Some(inside), PoseReach::Usual);
        let is_inside = |at: Vec2| at.x.abs() <= 4.0 && at.y.abs() <= 4.0;
        for linkage in boxed.found {
            assert!(is_inside(linkage.pivot), "{n}");
            assert!(
                matches!(linkage.partner, PinConstraint::Rocker(d) if is_inside(d)),
                "{n}"
            );
        }
    }
}

/// Two given pivots determine the linkage, one is in all linkages, and a pivot off the curve gives
/// none.
#[test]
fn four_poses_keep_given_pivots_and_pins() {
    let mut rng = SeededRng::new(16);
    for n in 0..30 {
        let planted = KnownDyads::four_bar(&mut rng, 4, 20.0);
        let [(PinConstraint::Rocker(a), _), (PinConstraint::Rocker(d), c)] = planted.dyads else {
            panic!("a four-bar has two pivots");
        };
        let with = |pivots: &[Vec2], pins: &[Vec2]| {
            let task = PoseTask {
                poses: planted.task.poses.clone(),
                pivots: pivots.to_vec(),
                pins: pins.to_vec(),
            };
            propose(&task, true, true, None, PoseReach::Usual)
        };
        for both in [with(&[a, d], &[]), with(&[a], &[c])] {
            assert!(
                both.is_complete && planted.is_among(&both.found, 1e-9),
                "{n}"
            );
        }
        let one = with(&[a], &[]);
        assert!(!one.is_complete && one.found.len() > 3, "{n}");
        assert!(
            one.found
                .iter()
                .all(|l| l.pivot == a || l.partner == PinConstraint::Rocker(a))
        );
        let none = with(&[a + Vec2::new(0.05, 0.03)], &[]);
        assert!(none.found.is_empty() && none.is_complete);
    }
}

/// Poses that nearly repeat, and pairs of nearly equal angles: the known dyads are on the curve.
#[test]
fn curve_of_special_poses_contains_known_dyads() {
    let mut rng = SeededRng::new(17);
    for n in 0..30 {
        let shape = KnownLengths::four_bar(&mut rng);
        let from = rng.within(0.0, 360.0);
        for steps in [
            [0.0, 1e-4, 50.0, 100.0],
            [0.0, 1.0, 2.0, 3.0],
            [0.0, 0.1, 90.0, 90.1],
        ] {
            let poses: Option<Vec<Pose>> = steps.iter().map(|s| shape.pose(from + s)).collect();
            let Some(poses) = poses else {
                continue;
            };
            let planted = shape.planted(poses);
            let pieces = pieces(&planted.task);
            let size = Guidance::new(&planted.task).unwrap().size;
            for (_, pin) in planted.dyads {
                let off = distance(&pieces, pin) / (size + pin.norm());
                assert!(off < 0.06, "{n} {steps:?}: {off}");
            }
        }
    }
}

/// Two pairs of translations: the curve is a conic, and its pins have pivots everywhere.
#[test]
fn two_pairs_of_equal_angles_have_conic_curve() {
    let pose = |x: f64, y: f64, angle: f64| Pose {
        at: Vec2::new(x, y),
        angle,
    };
    for last in [pose(2.0, -1.0, 40.0), pose(0.5, 3.0, 40.0)] {
        let poses = vec![
            pose(0.0, 0.0, 10.0),
            pose(1.0, 0.3, 10.0),
            pose(2.5, 1.0, 40.0),
            last,
        ];
        let task = PoseTask {
            poses,
            ..PoseTask::default()
        };
        let pieces = pieces(&task);
        let count: usize = pieces.iter().map(Vec::len).sum();
        assert!(count > 50, "{count}");
        for held in pieces
            .iter()
            .flatten()
            .filter(|held| held.pin.norm() < 10.0)
        {
            assert!(cubic(&task, held.pin).abs() < 1e-8, "{held:?}");
        }
        let all = propose(&task, true, true, None, PoseReach::Usual);
        assert!(!all.found.is_empty() && worst_miss(&task, &all.found) < 1e-9);
    }
}

/// Mirrored poses: the cubic consists of a line and a circle, and both are traced.
#[test]
fn curve_of_mirrored_poses_is_line_and_circle() {
    let pose = |x: f64, angle: f64| Pose {
        at: Vec2::new(x, 0.2 * x * x),
        angle,
    };
    let poses = vec![
        pose(-2.0, -35.0),
        pose(-0.7, -15.0),
        pose(0.7, 15.0),
        pose(2.0, 35.0),
    ];
    let task = PoseTask {
        poses,
        ..PoseTask::default()
    };
    let pieces = pieces(&task);
    // The body's line of symmetry consists of pins, each with a pivot on the ground's line of
    // symmetry.
    for y in [-3.0, -1.0, 0.5, 2.0] {
        assert!(distance(&pieces, Vec2::new(0.0, y)) < 0.05, "{y}");
    }
    let aside = pieces
        .iter()
        .flatten()
        .filter(|held| held.pin.x.abs() > 0.1)
        .count();
    assert!(aside > 30, "{aside}");
    assert!(sliced(&task, &pieces) > 30);
}

/// The proposals contain the known slide of slider-cranks and, with a given crank pivot, the whole
/// linkage, even for poses only a few degrees apart.
#[test]
fn planted_slider_cranks_are_recovered() {
    // The closer the poses, the larger the effect of their rounding on the linkages.
    for (distance, within) in [(20.0, 1e-9), (10.0, 1e-9), (5.0, 1e-8)] {
        let mut rng = SeededRng::new(70);
        let (mut checked, mut proposed) = (0, 0);
        while checked < 60 {
            let shape = KnownLengths::slider_crank(&mut rng);
            let from = rng.within(0.0, 360.0);
            let poses = (0..4).map(|k| shape.pose(from + distance * f64::from(k)));
            let Some(poses) = poses.collect::<Option<Vec<Pose>>>() else {
                continue;
            };
            checked += 1;
            let planted = shape.planted(poses);
            let guidance = Guidance::new(&planted.task).unwrap();
            let slide: Vec<FullDyad> = four::slide(&guidance).into_iter().collect();
            let off = planted.off(1, &slide);
            assert!(off < within, "{distance} {checked}: {off:e}");
            let (PinConstraint::Rocker(pivot), _) = planted.dyads[0] else {
                panic!("a crank has a pivot");
            };
            let given = PoseTask {
                pivots: vec![pivot],
                ..planted.task.clone()
            };
            let complete = propose(&given, false, true, None, PoseReach::Wide);
            assert!(
                planted.is_among(&complete.found, within),
                "{distance} {checked}"
            );
            let all = propose(&planted.task, false, true, None, PoseReach::Wide);
            let first = planted.task.poses[0];
            let pin = first.at + planted.dyads[1].1.turned(angle::unit(first.angle));
            let slides = |linkage: &Proposal| (linkage.places[0][1] - pin).norm() < within;
            proposed += usize::from(all.found.iter().any(slides));
        }
        assert_eq!(proposed, checked, "{distance}");
    }
}
