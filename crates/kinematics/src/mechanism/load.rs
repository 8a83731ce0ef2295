//! What acts on a mechanism besides gravity and inertia: loads, springs and presses.

use super::{Body, LinkId, PointId, SlideId};
use crate::Vec2;
use crate::angle::TURN;

/// A value over a coordinate: straight lines between knots, constant beyond the ends. Two knots at one
/// coordinate are a jump; at the very coordinate the value is that of the second, as behind it.
///
/// Without knots it is 1 everywhere: a factor that changes nothing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Profile {
    knots: Vec<[f64; 2]>,
}

impl Profile {
    /// Through these knots, each a coordinate and its value; `None` unless the coordinates grow from
    /// knot to knot, but for two of a jump, and all numbers are finite.
    #[must_use]
    pub fn new(knots: Vec<[f64; 2]>) -> Option<Profile> {
        let rises = knots.windows(2).all(|pair| pair[0][0] <= pair[1][0]);
        let grows = rises && knots.windows(3).all(|three| three[0][0] < three[2][0]);
        let finite = knots.iter().flatten().all(|v| v.is_finite());
        (grows && finite).then_some(Profile { knots })
    }

    /// The knots, each a coordinate and its value.
    #[must_use]
    pub fn knots(&self) -> &[[f64; 2]] {
        &self.knots
    }

    /// Whether it jumps behind one coordinate and not behind the other; one of a turned driver that spans whole
    /// turns repeats.
    #[must_use]
    pub fn jumps_between(&self, low: f64, high: f64, turns: bool) -> bool {
        let span = match self.knots[..] {
            [first, .., last] => last[0] - first[0],
            _ => return false,
        };
        let repeats = self.repeats(turns);
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

    /// Whether it repeats: of a turned driver where it spans whole turns.
    fn repeats(&self, turns: bool) -> bool {
        let [first, .., last] = self.knots[..] else {
            return false;
        };
        let span = last[0] - first[0];
        turns && span > 0.0 && span % TURN == 0.0
    }

    /// The coordinates of the knots that no place between two others depends on; none of one that repeats.
    #[must_use]
    pub fn unused_between(&self, low: f64, high: f64, turns: bool) -> Vec<f64> {
        if self.repeats(turns) {
            return Vec::new();
        }
        // Before the first and behind the last knot it is constant.
        let at = |k: usize| self.knots.get(k).map_or(f64::INFINITY, |knot| knot[0]);
        let before = |k: usize| k.checked_sub(1).map_or(f64::NEG_INFINITY, at);
        let meets = |from: f64, to: f64| from < high && low < to;
        let is_used = |k: &usize| meets(before(*k), at(*k)) || meets(at(*k), at(*k + 1));
        let unused = (0..self.knots.len()).filter(|k| !is_used(k));
        unused.map(at).collect()
    }

    /// Whether it is 1 everywhere.
    #[must_use]
    pub fn is_one(&self) -> bool {
        self.knots.is_empty()
    }
}

/// An end of a slide's travel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StrokeEnd {
    /// Where the position along the guide is least.
    Least,
    /// Where it is greatest.
    Greatest,
}

/// Something that acts on the mechanism. Friction is not modelled.
#[derive(Clone, Debug, PartialEq)]
pub enum Load {
    /// A force at a point.
    Force {
        /// Where it acts. At a pin joint it acts on the pin.
        point: PointId,
        /// Its components in N, in the frame of `frame`.
        force: Vec2,
        /// The ground, or the link with which the force turns.
        frame: Body,
        /// The factor over the driver's coordinate (deg, not wrapped, or the length unit). Where the
        /// knots of a turned driver span whole turns, it repeats.
        over: Profile,
    },
    /// A torque on a link.
    Torque {
        /// The loaded link.
        link: LinkId,
        /// Its size in N m, counter-clockwise.
        torque: f64,
        /// The factor over the driver's coordinate, as of a force.
        over: Profile,
    },
    /// What a press does before the end of its stroke: a force on what slides, against it along the guide,
    /// while it moves towards that end. None on the way back; a driver of no speed is taken for one that
    /// goes forward.
    Press {
        /// The slide that presses, its guide on the ground.
        slide: SlideId,
        /// Which end it works at: bottom dead centre.
        end: StrokeEnd,
        /// The force in N over the distance from that end, in the scene's length unit; nothing
        /// further away than the last knot.
        curve: Profile,
    },
    /// A spring and a damper in parallel between two points: together they pull with k (L - L0) + F0 + c dL/dt, where
    /// k is the stiffness, L the distance and L0 the free length in m, F0 the preload and c the damping.
    Spring {
        /// One end.
        from: PointId,
        /// The other end.
        to: PointId,
        /// In N/m.
        stiffness: f64,
        /// The length at which only the preload acts, in the scene's length unit.
        length: f64,
        /// What it pulls with at that length, in N; negative where it pushes.
        preload: f64,
        /// In N s/m, of the rate of the distance.
        damping: f64,
    },
    /// A gas spring between two points, and a damper beside it: they push with F(L) - c dL/dt.
    GasSpring {
        /// One end.
        from: PointId,
        /// The other end.
        to: PointId,
        /// With what it pushes the ends apart, in N, over their distance in the scene's length unit.
        force: Profile,
        /// In N s/m, of the rate of the distance.
        damping: f64,
    },
    /// A torsion spring and a damper beside it, between two bodies: on the link acts M0 - k (a - a0) - c da/dt, where a
    /// is the angle between them in radians.
    TorsionSpring {
        /// The link that it turns back.
        link: LinkId,
        /// What it is fixed to: the ground or another link.
        to: Body,
        /// In N m/rad, of the angle between them from the free one: at most half a turn either way.
        stiffness: f64,
        /// The free angle, from the x axis of `to` to that of the link, in degrees.
        angle: f64,
        /// The torque upon the link at the free angle, in N m, counter-clockwise.
        preload: f64,
        /// In N m s/rad.
        damping: f64,
    },
}

impl Load {
    /// A force that is constant in the ground's frame.
    #[must_use]
    pub fn force(point: PointId, force: Vec2) -> Load {
        Load::Force {
            point,
            force,
            frame: Body::Ground,
            over: Profile::default(),
        }
    }

    /// A constant torque.
    #[must_use]
    pub fn torque(link: LinkId, torque: f64) -> Load {
        Load::Torque {
            link,
            torque,
            over: Profile::default(),
        }
    }

    /// The two points between which it acts along their line: of springs.
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

    /// The factor over the driver's coordinate: of forces and torques.
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

    /// Whether all its numbers are finite, and those that must be are not negative.
    pub(super) fn is_sound(&self) -> bool {
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

/// Whether all of them are finite and not negative.
fn are_sizes(numbers: [f64; 3]) -> bool {
    numbers.iter().all(|v| v.is_finite() && *v >= 0.0)
}
