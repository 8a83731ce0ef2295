//! Computes the coordinates of further inputs from the driver's coordinate.

mod table;

use super::frame::Frame;
use crate::mechanism::fraction;
use crate::{Constant, Double, Input, InputLaw, InputTable, Mechanism, Number};
use std::sync::Arc;
use table::{ReadyTable, TableUnits};

/// The law by which an input's coordinate follows the driver's.
#[derive(Clone, Debug)]
pub(super) struct Following {
    law: FollowingLaw,
    /// The index of the input: the driver's is 0.
    pub number: usize,
}

#[derive(Clone, Debug)]
enum FollowingLaw {
    Proportion(Proportion),
    Table(Arc<TableMotion>),
    /// It moves by itself, with this motion at the present moment; its derivatives are by time.
    Free(InputMotion<Constant>),
}

/// p = count q / of + phase, with q the driver's coordinate in the unit of the steps, degrees or
/// scaled lengths, and p the input's own.
#[derive(Clone, Copy, Debug)]
struct Proportion {
    count: Constant,
    of: f64,
    phase: Constant,
    /// dp/dq in the units of the derivatives: both in radians or scaled lengths.
    rate: Constant,
}

/// A table, and the factors that convert its derivatives to radians or scaled lengths.
#[derive(Debug)]
struct TableMotion {
    table: ReadyTable,
    first: Constant,
    second: Constant,
}

/// The coordinate of an input, in degrees or scaled lengths, and its derivatives by the driver's
/// coordinate, in radians or scaled lengths.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct InputMotion<T> {
    pub p: T,
    pub w: T,
    pub a: T,
}

impl Following {
    /// Creates the laws of a mechanism, in the order of its further inputs.
    pub(super) fn all(mechanism: &Mechanism, frame: &Frame) -> Vec<Following> {
        let driver = mechanism.driver().input;
        let laws = mechanism.timed().iter().map(|timed| match timed.law {
            InputLaw::Ratio { ratio, phase } => FollowingLaw::Proportion(Proportion::new(
                [ratio, phase],
                [driver, timed.input],
                frame,
            )),
            InputLaw::Table(ref table) => {
                let motion = TableMotion::new(table, [driver, timed.input], frame);
                FollowingLaw::Table(Arc::new(motion))
            }
        });
        let numbered = laws.zip(1..);
        numbered
            .map(|(law, number)| Following { law, number })
            .collect()
    }

    /// Creates the law of an input that moves by itself. It is at rest at 0.
    pub(super) fn free(number: usize) -> Following {
        let law = FollowingLaw::Free(InputMotion::default());
        Following { law, number }
    }

    /// Sets the motion of an input that moves by itself.
    pub(super) fn set(&mut self, motion: InputMotion<Constant>) {
        self.law = FollowingLaw::Free(motion);
    }

    #[inline(always)]
    pub(super) fn at<T: Number>(&self, q: T) -> InputMotion<T> {
        match &self.law {
            FollowingLaw::Proportion(line) => line.at(q),
            FollowingLaw::Table(motion) => motion.at(q),
            FollowingLaw::Free(InputMotion { p, w, a }) => InputMotion {
                p: T::of(*p),
                w: T::of(*w),
                a: T::of(*a),
            },
        }
    }

    /// Returns the ratio of the input's rate to that of the driver, in radians or scaled lengths, if it
    /// is constant.
    pub(super) fn ratio(&self) -> Option<f64> {
        match &self.law {
            FollowingLaw::Proportion(line) => Some(line.rate.hi),
            FollowingLaw::Table(_) | FollowingLaw::Free(_) => None,
        }
    }

    pub(super) fn is_table(&self) -> bool {
        matches!(self.law, FollowingLaw::Table(_))
    }

    /// Returns the start and the end of an open table, in degrees or scaled lengths.
    pub(super) fn open_ends(&self) -> Option<[f64; 2]> {
        match &self.law {
            FollowingLaw::Proportion(_) | FollowingLaw::Free(_) => None,
            FollowingLaw::Table(motion) => motion.table.open_ends(),
        }
    }

    /// Returns the distance around a coordinate within which the law is a single function, in
    /// degrees or scaled lengths. If the coordinate `is_end`, a knot there does not count.
    pub(super) fn smooth(&self, q: f64, is_end: bool) -> f64 {
        match &self.law {
            FollowingLaw::Proportion(_) | FollowingLaw::Free(_) => f64::INFINITY,
            FollowingLaw::Table(motion) => motion.table.smooth(q, is_end),
        }
    }
}

impl Proportion {
    fn new([ratio, phase]: [f64; 2], [from, to]: [Input; 2], frame: &Frame) -> Proportion {
        // A ratio of whole numbers is the typed value.
        let (count, of) = match fraction(ratio) {
            Some((count, of)) => (Constant::exactly(count), of),
            None => (frame.number(ratio), 1.0),
        };
        let count = count
            .scaled(frame.unit_of(from))
            .scaled(1.0 / frame.unit_of(to));
        let ratio = if of == 1.0 {
            count
        } else {
            count / Constant::exactly(of)
        };
        Proportion {
            count,
            of,
            phase: frame.number(phase).scaled(1.0 / frame.unit_of(to)),
            rate: ratio * unit(from, to),
        }
    }

    #[inline(always)]
    fn at<T: Number>(&self, q: T) -> InputMotion<T> {
        InputMotion {
            p: T::of(self.count) * q / T::exactly(self.of) + T::of(self.phase),
            w: T::of(self.rate),
            a: T::default(),
        }
    }
}

impl TableMotion {
    fn new(table: &InputTable, [from, to]: [Input; 2], frame: &Frame) -> TableMotion {
        let units = TableUnits {
            driver: frame.unit_of(from),
            own: frame.unit_of(to),
        };
        let first = unit(from, to);
        let once_more = match from {
            Input::Turn(_) => Constant::known(Double::DEGREES),
            Input::Push(_) => Constant::exactly(1.0),
        };
        TableMotion {
            table: ReadyTable::new(table, frame, units),
            first,
            second: first * once_more,
        }
    }

    #[inline(never)]
    fn at<T: Number>(&self, q: T) -> InputMotion<T> {
        let InputMotion { p, w, a } = self.table.at(q);
        InputMotion {
            p,
            w: w * T::of(self.first),
            a: a * T::of(self.second),
        }
    }
}

/// Returns the factor from the ratio of two coordinates to that of their derivatives.
fn unit(from: Input, to: Input) -> Constant {
    match (from, to) {
        (Input::Turn(_), Input::Push(_)) => Constant::known(Double::DEGREES),
        (Input::Push(_), Input::Turn(_)) => Constant::known(Double::RADIAN),
        (Input::Turn(_), Input::Turn(_)) | (Input::Push(_), Input::Push(_)) => {
            Constant::exactly(1.0)
        }
    }
}

impl<T: Number> InputMotion<T> {
    /// Returns the motion of the driver's own coordinate.
    #[inline(always)]
    fn driver(q: T) -> InputMotion<T> {
        InputMotion {
            p: q,
            w: T::exactly(1.0),
            a: T::default(),
        }
    }

    /// Returns the motion of an input that follows, or of the driver itself.
    #[inline(always)]
    pub(super) fn of(following: Option<&Following>, q: T) -> InputMotion<T> {
        following.map_or_else(|| InputMotion::driver(q), |following| following.at(q))
    }
}
