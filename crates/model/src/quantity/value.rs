//! Reads the value of a quantity from a state, and its bound.

use super::{Aspect, Share, Subject};
use crate::solver::{Condition, Order, Residual, State};
use crate::{Ball, Input, LinkId, Number, PointId, SlideId, Vec2, angle};

/// Returns the value of a quantity in this state, or `None` if it does not exist. At a dead point
/// there are no rates, without an assembly there is only the driver, and a subject has only its own
/// aspects (a point does not rotate, a link keeps its length).
#[must_use]
pub fn value<T: Number>(subject: Subject, aspect: Aspect, state: &State<T>) -> Option<T> {
    found(subject, aspect, state).filter(|v| v.is_finite())
}

/// Returns the value of a quantity in this state, which may be infinite or NaN.
pub(super) fn found<T: Number>(subject: Subject, aspect: Aspect, state: &State<T>) -> Option<T> {
    match subject {
        Subject::Driver => Some(driver_value(aspect, state)),
        Subject::Point(point) => point_value(point, aspect, state),
        Subject::Link(link) => link_value(link, aspect, state),
        Subject::Slide(slide) => slide_value(slide, aspect, state),
        Subject::Between(tail, head) => between_value(tail, head, aspect, state),
        Subject::Drive(share) => drive_value(share, aspect, state),
        Subject::Joint(link, point) => plane(state.joint_force(link, point)?, aspect),
        Subject::Frame if aspect == Aspect::Moment => state.frame_moment(),
        Subject::Frame => plane(state.frame_force()?, aspect),
        Subject::FrameResidual => {
            let Residual { force, moment, .. } = state.residual()?;
            if aspect == Aspect::Moment {
                Some(moment)
            } else {
                plane(force, aspect)
            }
        }
    }
}

/// Returns a bound on the error of a quantity in this state, if one can be proved. `enclosure` is
/// the result of [`Solver::enclose`](crate::solver::Solver::enclose) for the state.
#[must_use]
pub fn bound(
    subject: Subject,
    aspect: Aspect,
    state: &State,
    enclosure: &State<Ball>,
) -> Option<f64> {
    let value = value(subject, aspect, state)?;
    let ball = self::value(subject, aspect, enclosure)?;
    distance_bound(value, ball, aspect == Aspect::Angle)
}

/// Returns a bound on the distance of a value from the true one, enclosed in a ball.
pub(super) fn distance_bound(value: f64, ball: Ball, is_direction: bool) -> Option<f64> {
    // Directions just below and just above a full turn are close. The larger one is at least half a
    // turn, so that subtracting a turn is exact.
    let beyond = value - ball.mid;
    if !is_direction || beyond.abs() <= angle::TURN / 2.0 {
        ball.bound(value)
    } else if beyond > 0.0 {
        ball.bound(value - angle::TURN)
    } else {
        Ball::new(ball.mid - angle::TURN, ball.radius).bound(value)
    }
}

/// Returns the word for a condition in the `state` column.
#[must_use]
pub fn state_word(condition: Condition) -> &'static str {
    match condition {
        Condition::Ok => "ok",
        Condition::DeadPoint => "dead-point",
        Condition::ChangePoint => "change-point",
        Condition::NoAssembly => "no-assembly",
    }
}

fn driver_value<T: Number>(aspect: Aspect, state: &State<T>) -> T {
    match aspect.order() {
        Order::Position => state.at(),
        Order::Velocity => state.driver_speed(),
        Order::Acceleration | Order::Force => state.driver_acceleration(),
    }
}

fn point_value<T: Number>(point: PointId, aspect: Aspect, state: &State<T>) -> Option<T> {
    match aspect {
        Aspect::X => Some(state.position(point)?.x),
        Aspect::Y => Some(state.position(point)?.y),
        Aspect::Vx => Some(state.velocity(point)?.x),
        Aspect::Vy => Some(state.velocity(point)?.y),
        Aspect::Ax => Some(state.acceleration(point)?.x),
        Aspect::Ay => Some(state.acceleration(point)?.y),
        _ => None,
    }
}

fn link_value<T: Number>(link: LinkId, aspect: Aspect, state: &State<T>) -> Option<T> {
    match aspect {
        Aspect::Angle => state.angle(link),
        Aspect::Omega => state.omega(link),
        Aspect::Alpha => state.alpha(link),
        Aspect::Torque => state.effort(Input::Turn(link)),
        _ => None,
    }
}

fn slide_value<T: Number>(slide: SlideId, aspect: Aspect, state: &State<T>) -> Option<T> {
    let travel = state.travel(slide)?;
    match aspect {
        Aspect::Length => Some(travel.position),
        Aspect::Rate => travel.rate,
        Aspect::Accel => travel.accel,
        // The vector runs from the sliding point back to `through`, against the guide.
        Aspect::Angle => Some(T::degrees(-travel.guide)),
        Aspect::Omega => travel.omega,
        Aspect::Alpha => travel.alpha,
        Aspect::Normal => state.normal(slide),
        Aspect::Moment => state.moment(slide),
        Aspect::Force => state.effort(Input::Push(slide)),
        _ => None,
    }
}

/// Returns a component of a force.
fn plane<T: Number>(force: Vec2<T>, aspect: Aspect) -> Option<T> {
    match aspect {
        Aspect::Fx => Some(force.x),
        Aspect::Fy => Some(force.y),
        _ => None,
    }
}

/// Returns the driver's effort: a torque if it turns, a force if it pushes.
fn drive_value<T: Number>(share: Share, aspect: Aspect, state: &State<T>) -> Option<T> {
    let is_its_own = match aspect {
        Aspect::Torque => state.turns(),
        Aspect::Force => !state.turns(),
        Aspect::Power => return state.power().filter(|_| share == Share::Total),
        _ => false,
    };
    if !is_its_own {
        return None;
    }
    let part = |number: usize| state.drive_parts().map(|parts| parts[number]);
    match share {
        Share::Total => state.drive(),
        Share::Load => part(0),
        Share::Gravity => part(1),
        Share::Inertia => part(2),
        // The check is that of the power of all inputs, if each moves by itself.
        Share::Residual if state.has_free_inputs() => None,
        Share::Residual => state.residual().map(|residual| residual.drive),
    }
}

/// Returns an aspect of r = head - tail: r' = r.v / |r|, omega = (r x v) / r.r, and likewise the
/// second derivatives.
fn between_value<T: Number>(
    tail: PointId,
    head: PointId,
    aspect: Aspect,
    state: &State<T>,
) -> Option<T> {
    let r = state.position(head)? - state.position(tail)?;
    let length = r.norm();
    // Velocity and acceleration of the head relative to the tail, along r and across it.
    let split = |vector: Vec2<T>| ((r / length).dot(vector), (r / length).cross(vector));
    let first = || Some(split(state.velocity(head)? - state.velocity(tail)?));
    let second = || Some(split(state.acceleration(head)? - state.acceleration(tail)?));
    match aspect {
        Aspect::Length => Some(length),
        Aspect::Rate => Some(first()?.0),
        Aspect::Accel => {
            let omega = first()?.1 / length;
            Some(second()?.0 + length * omega * omega)
        }
        Aspect::Angle => Some(T::degrees(r)),
        Aspect::Omega => Some(first()?.1 / length),
        Aspect::Alpha => {
            let (rate, across) = first()?;
            let omega = across / length;
            Some((second()?.1 - (rate * omega).scaled(2.0)) / length)
        }
        _ => None,
    }
}
