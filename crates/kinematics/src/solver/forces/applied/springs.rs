//! Evaluates springs: between two points along their line, and between two bodies about their
//! angle.

use super::LoadReceiver;
use crate::angle::TURN;
use crate::solver::forces::TorquePart;
use crate::solver::forces::profile::ReadyProfile;
use crate::solver::state::State;
use crate::{Body, Constant, LinkId, Number, PointId, Profile, Vec2};

/// A spring between two points, with a damper in parallel.
#[derive(Clone, Debug)]
pub(super) struct LineSpring {
    pub(super) from: PointId,
    pub(super) to: PointId,
    law: SpringLaw,
    damping: Constant,
}

/// The tension of a spring as a function of its length.
#[derive(Clone, Debug)]
enum SpringLaw {
    /// The law of [`Load::Spring`](crate::Load::Spring), in the solver's lengths; the stiffness in
    /// N/m.
    Straight {
        stiffness: Constant,
        length: Constant,
        preload: Constant,
    },
    /// The push force over the length in the scene's unit. `scale` is the solver's length in that
    /// unit.
    Given { force: ReadyProfile, scale: f64 },
}

/// A spring between two bodies that turns them towards an angle, with a damper in parallel.
#[derive(Clone, Debug)]
pub(super) struct TorsionSpring {
    pub(super) link: LinkId,
    /// The other link to which it is attached; `None` for the ground.
    pub(super) to: Option<LinkId>,
    /// In N m/rad.
    stiffness: Constant,
    /// The free angle, as a direction.
    free: Vec2<Constant>,
    preload: Constant,
    damping: Constant,
}

impl LineSpring {
    /// Creates a spring from its stiffness, length, preload and damping. `scale` is the solver's
    /// length in the scene's unit.
    pub(super) fn straight(
        [from, to]: [PointId; 2],
        [stiffness, length, preload, damping]: [f64; 4],
        scale: f64,
    ) -> LineSpring {
        let law = SpringLaw::Straight {
            stiffness: Constant::given(stiffness),
            length: Constant::given_in(length, scale),
            preload: Constant::given(preload),
        };
        let damping = Constant::given(damping);
        LineSpring {
            from,
            to,
            law,
            damping,
        }
    }

    /// Creates a spring from its push force over its length.
    pub(super) fn gas(
        [from, to]: [PointId; 2],
        (force, damping): (&Profile, f64),
        scale: f64,
    ) -> LineSpring {
        let force = ReadyProfile::over_length(force);
        LineSpring {
            from,
            to,
            law: SpringLaw::Given { force, scale },
            damping: Constant::given(damping),
        }
    }

    /// Returns `true` if it is a single formula over all lengths.
    pub(super) fn is_smooth(&self) -> bool {
        matches!(self.law, SpringLaw::Straight { .. })
    }

    /// Applies the forces that pull the two ends together. `unit` is the solver's length in metres.
    #[inline(always)]
    pub(super) fn pull<T: Number>(
        &self,
        state: &State<T>,
        unit: T,
        forces: &mut impl LoadReceiver<T>,
    ) {
        let (a, b) = (
            state.points[self.from.index()],
            state.points[self.to.index()],
        );
        let e = b.p - a.p;
        let pull = match self.by_distance() {
            // It pulls by k e, even if its ends coincide.
            Some(stiffness) => e * (T::of(stiffness) * unit),
            None => {
                let size = e.norm2().sqrt();
                let along = e / size;
                let rate = along.dot(b.v - a.v).times(state.rates.speed);
                along * self.law.tension(size, T::of(self.damping) * rate, unit)
            }
        };
        forces.push(TorquePart::Load, self.from, pull, state);
        forces.push(TorquePart::Load, self.to, -pull, state);
    }

    /// Returns the stiffness of a spring that depends only on the distance vector.
    fn by_distance(&self) -> Option<Constant> {
        let none = Constant::default();
        match self.law {
            SpringLaw::Straight {
                stiffness,
                length,
                preload,
            } => ([length, preload, self.damping] == [none; 3]).then_some(stiffness),
            SpringLaw::Given { .. } => None,
        }
    }
}

impl SpringLaw {
    /// Returns the tension in N at a length in the solver's unit; `damped` is the damping in N per
    /// solver's length in metres.
    #[inline(always)]
    fn tension<T: Number>(&self, size: T, damped: T, unit: T) -> T {
        match self {
            SpringLaw::Straight {
                stiffness,
                length,
                preload,
            } => {
                let stretch = size - T::of(*length);
                (T::of(*stiffness) * stretch + damped) * unit + T::of(*preload)
            }
            SpringLaw::Given { force, scale } => damped * unit - force.value(size.scaled(*scale)),
        }
    }
}

impl TorsionSpring {
    /// Creates a spring from its stiffness, free angle, preload and damping.
    pub(super) fn new(
        link: LinkId,
        to: Body,
        [stiffness, angle, preload, damping]: [f64; 4],
    ) -> TorsionSpring {
        TorsionSpring {
            link,
            to: match to {
                Body::Ground => None,
                Body::Link(link) => Some(link),
            },
            stiffness: Constant::given(stiffness),
            free: Constant::given_unit(angle),
            preload: Constant::given(preload),
            damping: Constant::given(damping),
        }
    }

    /// Applies the couples that turn the bodies towards the free angle.
    #[inline(always)]
    pub(super) fn turn_back<T: Number>(
        &self,
        state: &State<T>,
        unit: T,
        forces: &mut impl LoadReceiver<T>,
    ) {
        let link = &state.links[self.link.index()];
        let to = self.to.map(|to| &state.links[to.index()]);
        let turn = to.map_or(link.d, |to| link.d.turned(to.d.conj()));
        let turning = to
            .map_or(link.w, |to| link.w - to.w)
            .times(state.rates.speed);
        let radian = T::of(Constant::RADIAN);
        let angle = from_free(turn, Vec2::of(self.free)) * radian;
        let back =
            T::of(self.preload) - T::of(self.stiffness) * angle - T::of(self.damping) * turning;
        let couple = back / unit;
        forces.twist(TorquePart::Load, self.link, couple, state);
        match self.to {
            Some(to) => forces.twist(TorquePart::Load, to, -couple, state),
            None => forces.twist_ground(-couple),
        }
    }
}

/// Returns the rotation of a direction from the free one in degrees, between -180 and 180.
fn from_free<T: Number>(turn: Vec2<T>, free: Vec2<T>) -> T {
    let half = T::exactly(0.5 * TURN);
    // Counted from opposite the free direction, where the angle wraps around.
    let angle = T::degrees(-turn.turned(free.conj())) - half;
    if T::IS_CHEAP || half.exceeds(angle.abs()) {
        return angle;
    }
    let complete = T::exactly(TURN.copysign(angle.nearest()));
    angle.either(angle - complete)
}
