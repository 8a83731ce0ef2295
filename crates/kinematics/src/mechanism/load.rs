//! Defines loads, springs and presses: everything that acts on a mechanism besides gravity and
//! inertia.

use super::{Body, LinkId, PointId, SlideId};
use crate::Vec2;
use crate::angle::TURN;

/// A piecewise linear function of a coordinate, constant beyond its ends. Two knots at one
/// coordinate are a jump; exactly there, the value is that of the second knot.
///
/// Without knots it is 1 everywhere: a neutral factor.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Profile {
    knots: Vec<[f64; 2]>,
}

impl Profile {
    /// Creates a profile from knots of coordinate and value. Returns `None` if a number is not
    /// finite, or if the coordinates do not increase; a jump may repeat one once.
    #[must_use]
    pub fn new(knots: Vec<[f64; 2]>) -> Option<Profile> {
        let rises = knots.windows(2).all(|pair| pair[0][0] <= pair[1][0]);
        let grows = rises && knots.windows(3).all(|three| three[0][0] < three[2][0]);
        let finite = knots.iter().flatten().all(|v| v.is_finite());
        (grows && finite).then_some(Profile { knots })
    }

    /// Returns the knots, each a coordinate and its value.
    #[must_use]
    pub fn knots(&self) -> &[[f64; 2]] {
        &self.knots
    }

    /// Returns `true` if the profile jumps between two coordinates, ends included. With `turns`, a
    /// profile that spans whole turns repeats.
    #[must_use]
    pub fn jumps_between(&self, low: f64, high: f64, is_rotary: bool) -> bool {
        let span = match self.knots[..] {
            [first, .., last] => last[0] - first[0],
            _ => return false,
        };
        let repeats = self.repeats(is_rotary);
        let passes = |at: f64| {
            let times = if repeats {
                ((high - at) / span).floor()
            } else {
                0.0
            };
            (low..=high).contains(&(at + times * span))
        };
        let jumps = self
            .knots
            .windows(2)
            .filter(|pair| pair[0][0] == pair[1][0]);
        jumps.map(|pair| pair[0][0]).any(passes)
    }

    /// Returns `true` if the profile repeats: the driver turns and the knots span whole turns.
    fn repeats(&self, is_rotary: bool) -> bool {
        let [first, .., last] = self.knots[..] else {
            return false;
        };
        let span = last[0] - first[0];
        is_rotary && span > 0.0 && span % TURN == 0.0
    }

    /// Returns the coordinates of the knots that have no effect between `low` and `high`; empty for
    /// a repeating profile.
    #[must_use]
    pub fn unused_between(&self, low: f64, high: f64, is_rotary: bool) -> Vec<f64> {
        if self.repeats(is_rotary) {
            return Vec::new();
        }
        // The profile is constant before the first knot and beyond the last.
        let at = |k: usize| self.knots.get(k).map_or(f64::INFINITY, |knot| knot[0]);
        let before = |k: usize| k.checked_sub(1).map_or(f64::NEG_INFINITY, at);
        let meets = |from: f64, to: f64| from < high && low < to;
        let is_used = |k: &usize| meets(before(*k), at(*k)) || meets(at(*k), at(*k + 1));
        let unused = (0..self.knots.len()).filter(|k| !is_used(k));
        unused.map(at).collect()
    }

    /// Returns the value at a coordinate. With `turns`, a profile that spans whole turns repeats.
    fn value(&self, at: f64, is_rotary: bool) -> f64 {
        let [first, .., last] = self.knots[..] else {
            return self.knots.first().map_or(1.0, |knot| knot[1]);
        };
        let span = last[0] - first[0];
        let at = match self.repeats(is_rotary) {
            true => first[0] + (at - first[0]).rem_euclid(span),
            false => at,
        };
        // The second of two knots at a jump.
        let behind = self.knots.partition_point(|knot| knot[0] <= at);
        let before = behind.checked_sub(1).and_then(|k| self.knots.get(k));
        match (before, self.knots.get(behind)) {
            (Some(before), Some(behind)) => {
                let share = (at - before[0]) / (behind[0] - before[0]);
                before[1] + share * (behind[1] - before[1])
            }
            (None, _) => first[1],
            (Some(_), None) => last[1],
        }
    }

    /// Returns `true` if the profile is 1 everywhere.
    #[must_use]
    pub fn is_one(&self) -> bool {
        self.knots.is_empty()
    }
}

/// An end of a slide's travel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StrokeEnd {
    /// The minimum of the position along the guide.
    Minimum,
    /// The maximum of the position along the guide.
    Maximum,
}

/// A load on the mechanism. Friction is not modelled.
#[derive(Clone, Debug, PartialEq)]
pub enum Load {
    /// A force at a point.
    Force {
        /// The loaded point. At a pin joint, the force acts on the pin.
        point: PointId,
        /// The components in N, in the frame of `frame`.
        force: Vec2,
        /// The ground, or the link with which the force turns.
        frame: Body,
        /// The factor over the driver's coordinate (degrees, not wrapped, or the length unit). For
        /// a turned driver it repeats if the knots span whole turns.
        over: Profile,
    },
    /// A torque on a link.
    Torque {
        /// The loaded link.
        link: LinkId,
        /// The torque in N m, counter-clockwise.
        torque: f64,
        /// The factor over the driver's coordinate, as for a force.
        over: Profile,
    },
    /// The resistance before the end of a press stroke: a force on the slider along the guide,
    /// against its motion, while it moves towards that end. It is zero on the return stroke. A
    /// driver with zero speed counts as moving forwards.
    Press {
        /// The pressing slide. Its guide must be on the ground.
        slide: SlideId,
        /// The end at which the press works: bottom dead centre.
        end: StrokeEnd,
        /// The force in N over the distance from that end, in the scene's length unit; zero beyond
        /// the last knot.
        curve: Profile,
    },
    /// A spring and a damper in parallel between two points. Together they pull with k (L - L0) +
    /// F0 + c dL/dt, where k is the stiffness, L the distance and L0 the free length in m, F0 the
    /// preload and c the damping.
    Spring {
        /// One end.
        from: PointId,
        /// The other end.
        to: PointId,
        /// The stiffness, in N/m.
        stiffness: f64,
        /// The free length, at which only the preload acts, in the scene's length unit.
        length: f64,
        /// The pull at the free length, in N; negative if it pushes.
        preload: f64,
        /// The damping in N s/m, by the rate of the distance.
        damping: f64,
    },
    /// A gas spring and a damper in parallel between two points: they push with F(L) - c dL/dt.
    GasSpring {
        /// One end.
        from: PointId,
        /// The other end.
        to: PointId,
        /// The force that pushes the ends apart, in N, over their distance in the scene's length
        /// unit.
        force: Profile,
        /// The damping in N s/m, by the rate of the distance.
        damping: f64,
    },
    /// A torsion spring and a damper in parallel between two bodies. On the link acts M0 - k (a -
    /// a0) - c da/dt, where a is the angle between them in radians.
    TorsionSpring {
        /// The link on which the torque acts.
        link: LinkId,
        /// The other body: the ground or another link.
        to: Body,
        /// The stiffness in N m/rad, by the angle from the free angle, which is at most half a turn
        /// in either direction.
        stiffness: f64,
        /// The free angle, from the x axis of `to` to that of the link, in degrees.
        angle: f64,
        /// The torque on the link at the free angle, in N m, counter-clockwise.
        preload: f64,
        /// The damping, in N m s/rad.
        damping: f64,
    },
}

impl Load {
    /// Creates a force that is constant in the ground's frame.
    #[must_use]
    pub fn force(point: PointId, force: Vec2) -> Load {
        Load::Force {
            point,
            force,
            frame: Body::Ground,
            over: Profile::default(),
        }
    }

    /// Creates a constant torque.
    #[must_use]
    pub fn torque(link: LinkId, torque: f64) -> Load {
        Load::Torque {
            link,
            torque,
            over: Profile::default(),
        }
    }

    /// Returns the two ends of a spring or gas spring, which acts along the line between them.
    #[must_use]
    pub fn ends(&self) -> Option<[PointId; 2]> {
        match *self {
            Load::Spring { from, to, .. } | Load::GasSpring { from, to, .. } => Some([from, to]),
            Load::Force { .. }
            | Load::Torque { .. }
            | Load::Press { .. }
            | Load::TorsionSpring { .. } => None,
        }
    }

    /// Returns the load that remains while the driver rests at a coordinate.
    pub(super) fn held_at(self, at: f64, is_rotary: bool) -> Load {
        match self {
            Load::Force {
                point,
                force,
                frame,
                over,
            } => Load::Force {
                point,
                force: force * over.value(at, is_rotary),
                frame,
                over: Profile::default(),
            },
            Load::Torque { link, torque, over } => {
                Load::torque(link, torque * over.value(at, is_rotary))
            }
            Load::Press { .. }
            | Load::Spring { .. }
            | Load::GasSpring { .. }
            | Load::TorsionSpring { .. } => self,
        }
    }

    /// Returns the factor over the driver's coordinate, for forces and torques.
    #[must_use]
    pub fn over(&self) -> Option<&Profile> {
        match self {
            Load::Force { over, .. } | Load::Torque { over, .. } => Some(over),
            Load::Press { .. }
            | Load::Spring { .. }
            | Load::GasSpring { .. }
            | Load::TorsionSpring { .. } => None,
        }
    }

    /// Returns `true` if all numbers are finite, those that must not be negative are not, and the
    /// load acts on two different points or bodies.
    pub(super) fn is_valid(&self) -> bool {
        match self {
            Load::Force { force, .. } => force.is_finite(),
            Load::Torque { torque, .. } => torque.is_finite(),
            Load::Press { curve, .. } => curve.knots.first().is_some_and(|knot| knot[0] >= 0.0),
            Load::Spring {
                from,
                to,
                stiffness,
                length,
                preload,
                damping,
            } => from != to && preload.is_finite() && are_sizes([*stiffness, *length, *damping]),
            Load::GasSpring {
                from,
                to,
                force,
                damping,
            } => {
                let is_known = force.knots.first().is_some_and(|knot| knot[0] >= 0.0);
                from != to && is_known && are_sizes([*damping, 0.0, 0.0])
            }
            Load::TorsionSpring {
                link,
                to,
                stiffness,
                angle,
                preload,
                damping,
            } => {
                let are_finite = angle.is_finite() && preload.is_finite();
                *to != Body::Link(*link) && are_finite && are_sizes([*stiffness, *damping, 0.0])
            }
        }
    }
}

/// Returns `true` if all numbers are finite and not negative.
fn are_sizes(numbers: [f64; 3]) -> bool {
    numbers.iter().all(|v| v.is_finite() && *v >= 0.0)
}
