//! Tests of three poses: a pin for each pivot, a pivot for each pin.

use super::planted::{KnownDyads, worst_miss};
use crate::poses::dyad_equations::Guidance;
use crate::poses::{PoseReach, propose, three};
use crate::{PinConstraint, Pose, PoseTask};
use kinematics::Vec2;
use kinematics::numeric::SeededRng;

#[test]
fn given_pivots_or_pins_give_planted_linkage() {
    let mut rng = SeededRng::new(21);
    for n in 0..200 {
        let planted = KnownDyads::four_bar(&mut rng, 3, 15.0);
        let [(PinConstraint::Rocker(a), b), (PinConstraint::Rocker(d), c)] = planted.dyads else {
            panic!("a four-bar has two pivots");
        };
        for (pivots, pins) in [
            (vec![a, d], vec![]),
            (vec![], vec![b, c]),
            (vec![d], vec![b]),
        ] {
            let task = PoseTask {
                poses: planted.task.poses.clone(),
                pivots,
                pins,
            };
            let found = propose(&task, true, false, None, PoseReach::Usual);
            assert!(found.is_complete && found.found.len() == 1, "{n}");
            assert!(planted.is_among(&found.found, 1e-9), "{n}");
        }
    }
}

/// A given pin with collinear positions is on a slide; a neighbouring pin is on a long link.
#[test]
fn pin_with_collinear_places_is_on_slide() {
    let mut rng = SeededRng::new(22);
    for n in 0..200 {
        let planted = KnownDyads::slider_crank(&mut rng, 3, 20.0);
        let [(_, b), (_, c)] = planted.dyads;
        let guidance = Guidance::new(&planted.task).unwrap();
        let held = guidance.on_pin(c).unwrap();
        assert!(matches!(held.by, PinConstraint::Slide(_)), "{n}");
        let near = guidance.on_pin(c + Vec2::new(1e-3, 1e-3)).unwrap();
        assert!(matches!(near.by, PinConstraint::Rocker(_)), "{n}");
        let task = PoseTask {
            pins: vec![b, c],
            ..planted.task.clone()
        };
        assert!(
            planted.is_among(
                &propose(&task, true, true, None, PoseReach::Usual).found,
                1e-9
            ),
            "{n}"
        );
    }
}

/// Pins on slides are on a circle.
#[test]
fn sliding_pins_are_on_circle() {
    let mut rng = SeededRng::new(23);
    for n in 0..50 {
        let planted = KnownDyads::slider_crank(&mut rng, 3, 20.0);
        let guidance = Guidance::new(&planted.task).unwrap();
        let all = three::dyads(&guidance, &planted.task, None, 1.0);
        let slides: Vec<Vec2> = all
            .iter()
            .filter(|h| matches!(h.by, PinConstraint::Slide(_)))
            .map(|h| h.pin)
            .collect();
        assert!(slides.len() > 20, "{n}");
        let mut pins = slides.clone();
        pins.push(planted.dyads[1].1);
        let square = |k: usize| (pins[k] - pins[0]).norm2();
        let of = |k: usize| pins[k] - pins[0];
        let det = of(8).cross(of(16));
        let middle = Vec2::new(
            square(8) * of(16).y - square(16) * of(8).y,
            square(16) * of(8).x - square(8) * of(16).x,
        ) / (2.0 * det);
        for k in 0..pins.len() {
            let off = (of(k) - middle).norm() - middle.norm();
            assert!(off.abs() < 1e-9 * (1.0 + middle.norm()), "{n} {k}: {off:e}");
        }
    }
}

#[test]
fn free_linkages_are_many_and_exact() {
    let mut rng = SeededRng::new(24);
    let mut slider_cranks = 0;
    for n in 0..30 {
        let planted = KnownDyads::four_bar(&mut rng, 3, 20.0);
        let all = propose(&planted.task, true, true, None, PoseReach::Usual);
        assert!(
            !all.is_complete && (30..=100).contains(&all.found.len()),
            "{n}: {}",
            all.found.len()
        );
        let size = Guidance::new(&planted.task).unwrap().size;
        assert!(worst_miss(&planted.task, &all.found) < 1e-10 * size, "{n}");
        slider_cranks += usize::from(
            all.found
                .iter()
                .any(|l| matches!(l.partner, PinConstraint::Slide(_))),
        );
        let boxed = [Vec2::new(-3.0, -1.0), Vec2::new(-1.0, 2.0)];
        for linkage in propose(&planted.task, true, false, Some(boxed), PoseReach::Usual).found {
            let at = linkage.pivot;
            assert!(
                (-3.0..=-1.0).contains(&at.x) && (-1.0..=2.0).contains(&at.y),
                "{n}"
            );
        }
    }
    // If the circle of sliding pins is far away, none of its pins is within reach.
    assert!(slider_cranks >= 27, "{slider_cranks}");
}

/// For translations alone, crank and rocker are equally long and turn together.
#[test]
fn three_translations_have_parallelograms() {
    let pose = |x: f64, y: f64| Pose {
        at: Vec2::new(x, y),
        angle: 33.0,
    };
    let poses = vec![pose(0.0, 0.0), pose(1.0, 1.0), pose(2.0, 1.2)];
    let task = PoseTask {
        poses,
        ..PoseTask::default()
    };
    let all = propose(&task, true, false, None, PoseReach::Usual);
    assert!(!all.found.is_empty() && worst_miss(&task, &all.found) < 1e-12);
    for linkage in all.found {
        let (crank, _, rocker) = linkage.lengths().unwrap();
        assert!((crank - rocker.unwrap()).abs() < 1e-12);
    }
}

#[test]
fn three_collinear_translations_have_no_linkage() {
    let pose = |x: f64| Pose {
        at: Vec2::new(x, 0.5 * x),
        angle: 33.0,
    };
    let poses = vec![pose(0.0), pose(1.0), pose(3.0)];
    let task = PoseTask {
        poses,
        ..PoseTask::default()
    };
    assert!(
        propose(&task, true, true, None, PoseReach::Usual)
            .found
            .is_empty()
    );
}

/// Repeated runs of a task give equal proposals.
#[test]
fn proposals_are_reproducible() {
    let planted = KnownDyads::four_bar(&mut SeededRng::new(25), 3, 20.0);
    let run = || propose(&planted.task, true, true, None, PoseReach::Usual);
    assert_eq!(run(), run());
}
