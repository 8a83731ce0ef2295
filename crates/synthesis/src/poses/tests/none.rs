//! Tests of the reasons for empty results.

use super::planted::{KnownDyads, turned};
use crate::poses::{PoseReach, propose};
use crate::{OpenReason, Pose, PoseTask, Proposals};
use kinematics::Vec2;
use kinematics::numeric::SeededRng;

fn proposed(poses: Vec<Pose>) -> Proposals {
    let task = PoseTask {
        poses,
        ..PoseTask::default()
    };
    propose(&task, true, true, None, PoseReach::Wide)
}

#[test]
fn rotation_about_point_reports_the_point() {
    for count in [3, 4, 5] {
        for pole in [Vec2::new(3.0, -1.0), Vec2::ZERO, Vec2::new(1e4, 7.0)] {
            for arm in [0.0, 2.0] {
                let turns = [0.0, 20.0, 50.0, 110.0, 170.0].into_iter().take(count);
                let poses = turns.map(|turn| Pose {
                    at: pole + turned(arm, turn + 10.0),
                    angle: turn,
                });
                let all = proposed(poses.collect());
                let Some(OpenReason::Turn(at)) = all.reason else {
                    panic!(
                        "{count} {pole:?} {arm}: {:?} {}",
                        all.reason,
                        all.found.len()
                    );
                };
                assert!(all.found.is_empty() && (at - pole).norm() < 1e-9 * (1.0 + pole.norm()));
            }
        }
    }
}

#[test]
fn out_of_range_coordinates_are_reported() {
    let mut rng = SeededRng::new(60);
    for count in [3, 4, 5] {
        for power in [-200, -100, -60, 0, 60, 100, 200, 300] {
            let mut planted = KnownDyads::four_bar(&mut rng, count, 20.0);
            for pose in &mut planted.task.poses {
                pose.at = pose.at * 10_f64.powi(power);
            }
            let all = proposed(planted.task.poses);
            match power.abs() < 70 {
                true => assert!(!all.found.is_empty(), "{count} {power}"),
                false => assert_eq!(all.reason, Some(OpenReason::Range), "{count} {power}"),
            }
        }
    }
}

#[test]
fn empty_result_has_reason() {
    let shifts = [(0.0, 0.0), (1.0, 0.2), (2.0, 1.0), (2.5, -1.0), (0.4, 3.0)];
    let shift = |(x, y)| Pose {
        at: Vec2::new(x, y),
        angle: -3.0,
    };
    for count in [4, 5] {
        let all = proposed(shifts.map(shift)[..count].to_vec());
        assert_eq!(all.reason, Some(OpenReason::Shift), "{count}");
    }
    let mut rng = SeededRng::new(61);
    let planted = KnownDyads::four_bar(&mut rng, 5, 20.0);
    let given = PoseTask {
        pivots: vec![Vec2::new(0.123, 0.456)],
        ..planted.task.clone()
    };
    let all = propose(&given, true, true, None, PoseReach::Usual);
    assert_eq!(
        (all.found.len(), all.reason),
        (0, Some(OpenReason::GivenNumber))
    );
    // A four-bar with only two dyads is not a slider-crank.
    let mut paired = 0;
    for _ in 0..20 {
        let planted = KnownDyads::four_bar(&mut rng, 5, 20.0);
        let all = propose(&planted.task, false, true, None, PoseReach::Usual);
        assert!(all.found.is_empty() && all.is_complete);
        assert_eq!(all.reason, Some(OpenReason::NoPair));
        let all = propose(&planted.task, true, true, None, PoseReach::Usual);
        paired += usize::from(all.reason.is_none() && !all.found.is_empty());
    }
    assert_eq!(paired, 20);
}
