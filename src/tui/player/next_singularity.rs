//! Finds the next dead point, change point or limit ahead of the driver, if it is near.

use crate::LimitId;
use crate::report::stop_name;
use crate::scene::Scene;
use crate::solver::{Motion, Range};
use crate::tui::figures::format::coordinate;
use crate::tui::player::driver_range::DriverRange;
use crate::wording::words;

/// The distance that counts as near: in degrees, or as a fraction of a slide's travel.
const NEAR_TURNING: f64 = 15.0;
const NEAR_PUSHING: f64 = 0.05;
/// Decimals of the remaining angle. A remaining travel has one less than the coordinate.
const DECIMALS: usize = 1;

/// The kind of a singularity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SingularityKind {
    Stop(LimitId),
    DeadPoint,
    ChangePoint,
    /// The end of the tracked travel of a slide.
    Limit,
}

/// The next singularity and its distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NextSingularity {
    kind: SingularityKind,
    /// The distance in degrees or the scene's length unit, greater than 0.
    distance: f64,
}

/// Returns the singularities of a motion with their coordinates. Of several at the same coordinate,
/// the first counts: a limit may also be a stop or a dead point.
pub(crate) fn singularities(
    driver_range: &DriverRange,
    motion: &Motion,
) -> Vec<(SingularityKind, f64)> {
    let limits = driver_range
        .shuttle()
        .map_or([None; 2], |(low, high)| [low, high].map(Some));
    let stops = motion.stops.iter();
    let all = (motion
        .dead_points
        .iter()
        .map(|&to| (SingularityKind::DeadPoint, to)))
    .chain(stops.map(|stop| (SingularityKind::Stop(stop.limit), stop.at)))
    .chain(
        motion
            .change_points
            .iter()
            .map(|&to| (SingularityKind::ChangePoint, to)),
    )
    .chain(
        limits
            .into_iter()
            .flatten()
            .map(|to| (SingularityKind::Limit, to)),
    );
    all.collect()
}

/// Returns the next singularity in the direction of motion from `at`; `None` if none is near.
pub(crate) fn ahead(
    driver_range: &DriverRange,
    motion: &Motion,
    at: f64,
    backwards: bool,
) -> Option<NextSingularity> {
    let near = if driver_range.turns() {
        NEAR_TURNING
    } else {
        NEAR_PUSHING * driver_range.span()
    };
    let sense = if backwards { -1.0 } else { 1.0 };
    let distance = |to: f64| match motion.range {
        Range::Full { period } => ((to - at) * sense).rem_euclid(period),
        Range::Limited { .. } => (to - at) * sense,
    };
    let all = singularities(driver_range, motion).into_iter();
    let ahead = all.map(|(kind, to)| NextSingularity {
        kind,
        distance: distance(to),
    });
    ahead
        .filter(|ahead| ahead.distance > 0.0 && ahead.distance <= near)
        .min_by(|a, b| a.distance.total_cmp(&b.distance))
}

impl SingularityKind {
    /// Returns the name of the kind, with that of a stop.
    pub(crate) fn name(self, scene: &Scene) -> String {
        match self {
            SingularityKind::Stop(limit) => words().stop_of(&stop_name(scene, limit)),
            SingularityKind::DeadPoint => words().dead_point().to_owned(),
            SingularityKind::ChangePoint => words().change_point().to_owned(),
            SingularityKind::Limit => words().limit().to_owned(),
        }
    }
}

impl NextSingularity {
    /// Formats the singularity: `dead point in 3.2 deg`.
    pub(crate) fn text(self, scene: &Scene, driver_range: &DriverRange, unit: &str) -> String {
        let kind = &self.kind.name(scene);
        let decimals = if driver_range.turns() {
            DECIMALS
        } else {
            driver_range.decimals().saturating_sub(1)
        };
        let minimum = 10.0_f64.powi(-i32::try_from(decimals).unwrap_or(0));
        if self.distance < minimum {
            return words().near_within(kind, &coordinate(minimum, decimals), unit);
        }
        let distance = format!("{:.decimals$}", self.distance);
        words().near_in(kind, &distance, unit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;
    use crate::solver::Solver;

    fn open(text: &str) -> (Scene, DriverRange, Solver) {
        let scene = Scene::parse(text, "test").unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let driver_range = DriverRange::new(&scene, &solver);
        (scene, driver_range, solver)
    }

    fn preset(name: &str) -> (Scene, DriverRange, Solver) {
        open(presets::find(name).unwrap().text)
    }

    /// A crank that cannot turn fully: dead points at about -82.8 and 82.8 deg.
    const SWINGING: &str = r#"
unit = "mm"
[ground]
A = [0, 0]
D = [100, 0]
[driver]
link = "r2"
angle = 60
[links]
r2 = { from = "A", to = "B", length = 60 }
r3 = { from = "B", to = "C", length = 50 }
r4 = { from = "C", to = "D", length = 60 }
[start]
C = [75, 55]
"#;

    #[test]
    fn dead_point_ahead_is_reported_when_near() {
        let (scene, driver_range, solver) = open(SWINGING);
        let text = |at, backwards| {
            let ahead = ahead(&driver_range, solver.motion(), at, backwards);
            ahead.map(|ahead| ahead.text(&scene, &driver_range, "deg"))
        };
        assert_eq!(text(60.0, false), None);
        assert_eq!(text(79.6, false).unwrap(), "dead point in 3.2 deg");
        assert_eq!(text(82.8, false).unwrap(), "dead point within 0.1 deg");
        assert_eq!(text(79.6, true), None, "it moves away from it");
        assert_eq!(text(-79.6, true).unwrap(), "dead point in 3.2 deg");
        let (_, high) = driver_range.shuttle().unwrap();
        assert_eq!(text(high, false), None, "that is where it is");
    }

    #[test]
    fn change_point_is_reported_on_every_turn() {
        // The motion of a kite repeats every two turns: its change points are at 0 and 360 of 720
        // degrees.
        for name in ["parallelogram", "kite"] {
            let (scene, driver_range, solver) = preset(name);
            for at in [-10.0, 350.0, 7190.0] {
                let ahead = ahead(&driver_range, solver.motion(), at, false).unwrap();
                assert_eq!(
                    ahead.text(&scene, &driver_range, "deg"),
                    "change point in 10.0 deg"
                );
            }
        }
    }

    #[test]
    fn fully_rotating_crank_has_no_singularity_ahead() {
        let (_, driver_range, solver) = preset("four-bar");
        for at in [-720.0, 0.0, 60.0, 359.0] {
            assert_eq!(ahead(&driver_range, solver.motion(), at, false), None);
        }
    }

    #[test]
    fn slide_dead_point_is_reported_in_length_unit() {
        let (scene, driver_range, solver) = preset("excavator-boom");
        let (low, high) = driver_range.shuttle().unwrap();
        let at = high - 0.02 * (high - low);
        let ahead = ahead(&driver_range, solver.motion(), at, false).unwrap();
        let text = ahead.text(&scene, &driver_range, "m");
        assert!(text.starts_with("dead point in 0.0"), "{text}");
        assert!(text.ends_with(" m"), "{text}");
    }
}
