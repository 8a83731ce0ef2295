//! How the coordinate of a further input follows the driver's.

use super::frame::Frame;
use crate::{Constant, Double, Input, Mechanism, Number};

/// p = count q / of + phase: q the driver's coordinate as the steps have it, in degrees or scaled lengths, and p
/// the input's own.
#[derive(Clone, Copy, Debug)]
pub(super) struct Following {
    count: Constant,
    of: f64,
    phase: Constant,
    /// Its place among the inputs: the driver's is 0.
    pub number: usize,
    /// dp/dq as derivatives count them: in radians or scaled lengths, both.
    rate: Constant,
}

/// The coordinate of an input, in degrees or scaled lengths, and its derivatives by the driver's, in
/// radians or scaled lengths.
#[derive(Clone, Copy, Debug)]
pub(super) struct InputMotion<T> {
    pub p: T,
    pub w: T,
    pub a: T,
}

impl Following {
    pub(super) fn new(mechanism: &Mechanism, frame: &Frame, number: usize) -> Option<Following> {
        let timed = mechanism.timed().get(number.checked_sub(1)?)?;
        let (count, of) = timed.fraction().unwrap_or((timed.ratio, 1.0));
        // A fraction of whole numbers is what was meant.
        let count = match timed.fraction() {
            Some(_) => Constant::exactly(count),
            None => frame.number(count),
        };
        let phase = frame.number(timed.phase);
        let (from, to) = (mechanism.driver().input, timed.input);
        let scale = |input: Input| match input {
            Input::Turn(_) => 1.0,
            Input::Push(_) => frame.scale,
        };
        let count = count.scaled(scale(from)).scaled(1.0 / scale(to));
        let ratio = if of == 1.0 {
            count
        } else {
            count / Constant::exactly(of)
        };
        Some(Following {
            count,
            of,
            phase: phase.scaled(1.0 / scale(to)),
            number,
            rate: ratio * unit(from, to),
        })
    }

    /// The derivative of the coordinate by the driver's: the same everywhere.
    #[inline(always)]
    pub(super) fn rate<T: Number>(&self) -> T {
        T::of(self.rate)
    }

    #[inline(always)]
    pub(super) fn at<T: Number>(&self, q: T) -> InputMotion<T> {
        InputMotion {
            p: T::of(self.count) * q / T::exactly(self.of) + T::of(self.phase),
            w: self.rate(),
            a: T::default(),
        }
    }
}

/// What turns the ratio of two coordinates into that of their derivatives.
fn unit(from: Input, to: Input) -> Constant {
    match (from, to) {
        (Input::Turn(_), Input::Push(_)) => Constant::known(Double::DEGREES),
        (Input::Push(_), Input::Turn(_)) => Constant::known(Double::RADIAN),
        _ => Constant::exactly(1.0),
    }
}

impl<T: Number> InputMotion<T> {
    /// The driver's own coordinate.
    #[inline(always)]
    fn driver(q: T) -> InputMotion<T> {
        InputMotion {
            p: q,
            w: T::exactly(1.0),
            a: T::default(),
        }
    }

    /// Of an input that follows, or of the driver itself.
    #[inline(always)]
    pub(super) fn of(following: Option<&Following>, q: T) -> InputMotion<T> {
        following.map_or_else(|| InputMotion::driver(q), |following| following.at(q))
    }
}
