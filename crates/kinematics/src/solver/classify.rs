//! Classifies the loop that the driver closes: the Grashof class of a four-bar, and the condition
//! for a full turn of a slider-crank's crank.

use super::elements::{Arm, Spin, Step};
use super::engine::Engine;
use crate::{Mechanism, PointId};

/// Relative tolerance of equal lengths: 4 u of the longest length. It is the usual tolerance
/// wherever given lengths distinguish a motion from its change point.
const EQUAL: f64 = 4.0 * 0.5 * f64::EPSILON;

/// Grashof's condition on a four-bar's shortest and longest link against the other two.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grashof {
    /// s + l < p + q: some link turns fully.
    Turning,
    /// s + l = p + q: a change point.
    ChangePoint,
    /// s + l > p + q: no link turns fully.
    Rocking,
}

/// The type of a four-bar, by its shortest link and the driven link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inversion {
    /// The driven link is the shortest: it turns fully, the other rocks.
    CrankRocker,
    /// The frame is the shortest: both links turn fully (drag link). So they do if both are the
    /// shortest, in a parallelogram.
    DoubleCrank,
    /// The driven link rocks; the other is the shortest and turns fully.
    RockerCrank,
    /// The coupler is the shortest: both links on the frame rock.
    DoubleRocker,
    /// No link turns fully.
    TripleRocker,
}

/// A loop of the driven link, a dyad and the ground; lengths in the scene's unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DrivenLoop {
    /// Four links and four pins.
    FourBar {
        /// The driven link.
        driven: f64,
        /// The link between the two links on the frame.
        coupler: f64,
        /// The other link on the frame.
        follower: f64,
        /// The distance between the ground pivots.
        frame: f64,
        /// Grashof's condition.
        grashof: Grashof,
        /// The inversion.
        inversion: Inversion,
    },
    /// A crank, a rod and a slider on the ground.
    SliderCrank {
        /// The driven link.
        crank: f64,
        /// The link between crank and slider.
        rod: f64,
        /// The distance of the rod's far pin's path from the crank's pivot.
        offset: f64,
        /// rod - (crank + offset): positive if the crank turns fully, zero at a change point.
        margin: f64,
    },
}

/// The class of a loop, independent of its lengths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoopKind {
    /// A four-bar's class.
    FourBar(Inversion, Grashof),
    /// A slider-crank's class.
    SliderCrank {
        /// Whether the crank turns fully.
        is_rotary: bool,
    },
}

impl DrivenLoop {
    /// Returns the class of the loop.
    #[must_use]
    pub fn kind(self) -> LoopKind {
        match self {
            DrivenLoop::FourBar {
                grashof, inversion, ..
            } => LoopKind::FourBar(inversion, grashof),
            DrivenLoop::SliderCrank { margin, .. } => LoopKind::SliderCrank {
                is_rotary: margin > 0.0,
            },
        }
    }
}

/// Returns the loop of the driven link, a dyad and the ground, if there is one.
pub(super) fn classify(engine: &Engine, mechanism: &Mechanism) -> Option<DrivenLoop> {
    let steps = &engine.program.steps;
    let scale = engine.frame.scale;
    let place = |p: PointId| engine.program.points[p.index()].nearest();
    let is_ground = |point: PointId| {
        let is_known = point.index() < mechanism.points().len();
        is_known && mechanism.point(point).ground.is_some()
    };
    // Among several loops the one of lowest rank is chosen.
    let mut found: Option<(usize, DrivenLoop)> = None;
    let spins = steps.iter().filter_map(|step| match *step {
        Step::Spin(spin) => Some(spin),
        _ => None,
    });
    for Spin {
        point,
        pivot,
        local,
    } in spins
    {
        let crank = local.nearest().norm();
        let loops = steps.iter().filter_map(|step| match step {
            Step::Circles(c) => {
                let (coupler, follower) = arms(point, [c.near, c.far])?;
                is_ground(follower.pivot).then(|| {
                    let frame = (place(follower.pivot) - place(pivot)).norm();
                    let lengths = [crank, coupler.length.hi, follower.length.hi, frame];
                    (coupler.link, four_bar(lengths.map(|l| l * scale)))
                })
            }
            Step::CircleRail(c) if c.arm.pivot == point => {
                let away = place(pivot) - c.through.nearest();
                let offset = c.along.nearest().cross(away).abs();
                let lengths = [crank, c.arm.length.hi, offset];
                Some((c.arm.link, slider_crank(lengths.map(|l| l * scale))))
            }
            _ => None,
        });
        for (coupler, of) in loops {
            let rank = mechanism.link_rank(coupler);
            if found.is_none_or(|(minimum, _)| rank < minimum) {
                found = Some((rank, of));
            }
        }
    }
    found.map(|(_, of)| of)
}

/// Returns the two arms of a dyad, the one on `pin` first.
fn arms(pin: PointId, [a, b]: [Arm; 2]) -> Option<(Arm, Arm)> {
    match (a.pivot == pin, b.pivot == pin) {
        (true, _) => Some((a, b)),
        (false, true) => Some((b, a)),
        (false, false) => None,
    }
}

fn four_bar([driven, coupler, follower, frame]: [f64; 4]) -> DrivenLoop {
    let mut sorted = [driven, coupler, follower, frame];
    sorted.sort_by(f64::total_cmp);
    let [shortest, p, q, longest] = sorted;
    // Sterbenz: the differences of near lengths are exact where it matters.
    let excess = (longest - q) - (p - shortest);
    let grashof = if excess.abs() <= EQUAL * longest {
        Grashof::ChangePoint
    } else if excess < 0.0 {
        Grashof::Turning
    } else {
        Grashof::Rocking
    };
    let inversion = if grashof == Grashof::Rocking {
        Inversion::TripleRocker
    } else if frame == shortest || (driven == shortest && follower == shortest) {
        Inversion::DoubleCrank
    } else if driven == shortest {
        Inversion::CrankRocker
    } else if follower == shortest {
        Inversion::RockerCrank
    } else {
        Inversion::DoubleRocker
    };
    DrivenLoop::FourBar {
        driven,
        coupler,
        follower,
        frame,
        grashof,
        inversion,
    }
}

fn slider_crank([crank, rod, offset]: [f64; 3]) -> DrivenLoop {
    let gap = (rod - crank) - offset;
    let margin = if gap.abs() <= EQUAL * rod.max(crank) {
        0.0
    } else {
        gap
    };
    DrivenLoop::SliderCrank {
        crank,
        rod,
        offset,
        margin,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kind(lengths: [f64; 4]) -> (Grashof, Inversion) {
        match four_bar(lengths) {
            DrivenLoop::FourBar {
                grashof, inversion, ..
            } => (grashof, inversion),
            DrivenLoop::SliderCrank { .. } => unreachable!("four lengths make a four-bar"),
        }
    }

    #[test]
    fn shortest_link_determines_inversion() {
        use Inversion::{CrankRocker, DoubleCrank, DoubleRocker, RockerCrank, TripleRocker};
        // Driven, coupler, follower, frame.
        assert_eq!(
            kind([100.0, 300.0, 250.0, 400.0]),
            (Grashof::Turning, CrankRocker)
        );
        assert_eq!(
            kind([250.0, 300.0, 100.0, 400.0]),
            (Grashof::Turning, RockerCrank)
        );
        assert_eq!(kind([2.0, 2.5, 2.2, 1.0]), (Grashof::Turning, DoubleCrank));
        assert_eq!(kind([3.0, 1.0, 2.5, 4.0]), (Grashof::Turning, DoubleRocker));
        assert_eq!(kind([2.0, 2.0, 2.0, 4.0]), (Grashof::Rocking, TripleRocker));
        // Both cranks of a parallelogram turn.
        assert_eq!(
            kind([1.0, 3.0, 1.0, 3.0]),
            (Grashof::ChangePoint, DoubleCrank)
        );
    }

    #[test]
    fn equal_sums_are_change_point_and_near_miss_is_not() {
        assert_eq!(kind([1.0, 3.0, 1.0, 3.0]).0, Grashof::ChangePoint);
        // 0.1 + 0.4 = 0.2 + 0.3 in decimals.
        assert_eq!(kind([0.1, 0.4, 0.2, 0.3]).0, Grashof::ChangePoint);
        assert_eq!(kind([1.0, 3.0, 1.0 + 1e-9, 3.0]).0, Grashof::Turning);
    }

    #[test]
    fn rod_as_long_as_crank_and_offset_has_zero_margin() {
        let margin = |lengths| match slider_crank(lengths) {
            DrivenLoop::SliderCrank { margin, .. } => margin,
            DrivenLoop::FourBar { .. } => f64::NAN,
        };
        assert_eq!(margin([10.0, 20.0, 0.0]), 10.0);
        assert_eq!(margin([0.1, 0.3, 0.2]), 0.0);
        assert!(margin([10.0, 8.0, 0.0]) < 0.0);
    }
}
