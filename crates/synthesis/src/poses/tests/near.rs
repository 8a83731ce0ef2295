//! Five poses that nearly repeat, and the statement that there are no other dyads.

use super::newton;
use super::planted::{KnownDyads, KnownLengths, turned, worst_miss};
use crate::poses::dyad_equations::Guidance;
use crate::poses::{PoseReach, five, propose};
use crate::{PinConstraint, Pose, PoseTask};
use kinematics::numeric::SeededRng;
use kinematics::{Vec2, angle};

/// A scale of linkages at which a crank of 0.4 to 2 is 40 mm to 200 mm.
const MILLIMETRES: f64 = 100.0;

/// Draws a four-bar of some hundred millimetres whose crank turns by `span` degrees from the first
/// of five poses to the last, with the dyads of the rounded poses. Returns `None` if Newton's
/// method, limited to the digits of a double, does not converge to them.
fn nearly_repeated(rng: &mut SeededRng, span: f64) -> Option<KnownDyads> {
    let mut shape = KnownLengths::four_bar(rng);
    let from = rng.within(0.0, 360.0);
    let PinConstraint::Rocker(pivot) = shape.partner else {
        panic!("a four-bar has two pivots");
    };
    shape.partner = PinConstraint::Rocker(pivot * MILLIMETRES);
    shape.pivot = shape.pivot * MILLIMETRES;
    shape.body.0 = shape.body.0 * MILLIMETRES;
    for length in [&mut shape.crank, &mut shape.coupler, &mut shape.rest] {
        *length *= MILLIMETRES;
    }
    let poses = (0..5).map(|k| shape.pose(from + span * f64::from(k) / 4.0));
    let mut planted = shape.planted(poses.collect::<Option<Vec<Pose>>>()?);
    for (by, pin) in &mut planted.dyads {
        let PinConstraint::Rocker(pivot) = *by else {
            panic!("a four-bar has two pivots");
        };
        let [polished, exact] = newton::solution(&planted.task, [pivot, *pin], MILLIMETRES)?;
        if (polished - pivot).norm() > 0.3 * MILLIMETRES {
            return None;
        }
        (*by, *pin) = (PinConstraint::Rocker(polished), exact);
    }
    Some(planted)
}

/// Even if all poses are within 0.003 rad and 0.3 mm of each other, both known dyads are found and
/// paired, whether or not the result is complete.
#[test]
fn nearly_repeated_poses_have_planted_dyads() {
    for (span, minimum, most_open) in [(10.0, 25, 0), (1.0, 25, 1), (0.3, 25, 9), (0.1, 18, 19)] {
        let mut rng = SeededRng::new(40);
        let (mut checked, mut open) = (0, 0);
        for n in 0..60 {
            let Some(planted) = nearly_repeated(&mut rng, span) else {
                continue;
            };
            checked += 1;
            let all = five::dyads(&Guidance::new(&planted.task).unwrap()).unwrap();
            let off = planted.off(0, &all.found).max(planted.off(1, &all.found));
            assert!(off < 1e-9 * MILLIMETRES, "{span} {n}: {off:e}");
            let proposals = propose(&planted.task, true, false, None, PoseReach::Usual);
            assert!(
                planted.is_among(&proposals.found, 1e-9 * MILLIMETRES),
                "{span} {n}"
            );
            assert_eq!(proposals.is_complete, all.are_all);
            let miss = worst_miss(&planted.task, &proposals.found);
            assert!(miss < 1e-9 * MILLIMETRES, "{span} {n}: {miss:e}");
            open += usize::from(!all.are_all);
        }
        assert!(
            checked >= minimum && open <= most_open,
            "{span}: {checked} {open}"
        );
    }
}

/// Trammels anywhere, with five poses all around or close together, have infinitely many dyads. The
/// remnants of these after rounding are not reported as complete.
#[test]
fn family_of_dyads_is_never_reported_complete() {
    let mut rng = SeededRng::new(50);
    for span in [360.0, 40.0, 10.0, 1.0, 0.1] {
        for n in 0..12 {
            let frame = turned(rng.within(0.0, 10.0), rng.within(0.0, 360.0));
            let body = turned(rng.within(0.0, 3.0), rng.within(0.0, 360.0));
            let (tilt, start) = (rng.within(0.0, 360.0), rng.within(0.0, 360.0));
            let poses = (0..5).map(|_| {
                let turn = start + rng.within(0.0, span);
                let across = Vec2::new(2.0 * angle::unit(turn).x, 0.0);
                let at = across + body.turned(angle::unit(180.0 - turn));
                Pose {
                    at: frame + at.turned(angle::unit(tilt)),
                    angle: 180.0 - turn + tilt,
                }
            });
            let task = PoseTask {
                poses: poses.collect(),
                ..PoseTask::default()
            };
            assert!(
                !propose(&task, true, true, None, PoseReach::Usual).is_complete,
                "{span} {n}"
            );
        }
    }
}
