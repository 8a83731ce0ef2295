//! Evaluates tables of inputs in any arithmetic, even if rounding leaves open on which side of a
//! knot the driver is.

use super::InputMotion;
use crate::mechanism::{SplineEnds, bends, cubic};
use crate::solver::frame::Frame;
use crate::{Constant, InputTable, Number};

/// A table prepared for evaluation: a cubic after every knot but the last.
#[derive(Debug)]
pub(super) struct ReadyTable {
    /// The knots, as driver coordinates in the unit of the steps.
    places: Vec<Constant>,
    cubics: Vec<TableCubic>,
    /// The values at both ends.
    ends: [Constant; 2],
    /// The period of a closed table, in degrees.
    period: Option<f64>,
}

/// c0 + c1 d + c2 d^2 + c3 d^3, with d the distance from its knot.
#[derive(Debug)]
struct TableCubic([Constant; 4]);

/// The units of the driver's coordinate and of the input's own, powers of two.
#[derive(Clone, Copy, Debug)]
pub(super) struct TableUnits {
    pub driver: f64,
    pub own: f64,
}

impl ReadyTable {
    /// Creates a table. Its coefficients are computed in double-double, from doubles or from typed
    /// decimals depending on the frame.
    pub(super) fn new(table: &InputTable, frame: &Frame, units: TableUnits) -> ReadyTable {
        let of = |value: f64, unit: f64| frame.number(value).scaled(1.0 / unit);
        let knots = table.knots().iter();
        let knots: Vec<[Constant; 2]> = knots
            .map(|&[place, value]| [of(place, units.driver), of(value, units.own)])
            .collect();
        let ends = match table.period() {
            None => SplineEnds::AtRest,
            Some(_) => SplineEnds::Closed,
        };
        let bends = bends(&knots, ends);
        let mut cubics: Vec<TableCubic> = knots
            .windows(2)
            .zip(bends.windows(2))
            .map(|(knots, bends)| TableCubic(cubic([knots[0], knots[1]], [bends[0], bends[1]])))
            .collect();
        if let (SplineEnds::AtRest, Some(first)) = (ends, cubics.first_mut()) {
            first.0[1] = Constant::default();
        }
        ReadyTable {
            ends: [knots[0][1], knots[knots.len() - 1][1]],
            places: knots.iter().map(|knot| knot[0]).collect(),
            period: table.period(),
            cubics,
        }
    }

    /// Returns the coordinate at a driver coordinate, and its derivatives by that, in the units of
    /// both. Beyond the ends of an open table it is constant. Whole turns of a closed table are
    /// ignored.
    pub(super) fn at<T: Number>(&self, q: T) -> InputMotion<T> {
        let q = self.within(q);
        if T::IS_CHEAP {
            self.piece(self.behind(q.nearest()), q)
        } else {
            self.around(q)
        }
    }

    /// Returns the equivalent place in the period of a closed table.
    fn within<T: Number>(&self, q: T) -> T {
        let Some(period) = self.period else { return q };
        let times = ((q.nearest() - self.places[0].hi) / period).floor();
        if times == 0.0 {
            q
        } else {
            q - T::exactly(times * period)
        }
    }

    /// Returns the number of knots before a place: 0 before the table, and all of them after it.
    /// The last knot belongs to the table.
    fn behind(&self, near: f64) -> usize {
        let last = self.cubics.len();
        let count = self.places.partition_point(|place| place.hi <= near);
        if count > last && near <= self.places[last].hi {
            last
        } else {
            count
        }
    }

    /// Evaluates the piece after so many knots. Beyond an open table it is the end value, beyond a
    /// closed one the periodic continuation.
    fn piece<T: Number>(&self, count: usize, q: T) -> InputMotion<T> {
        let last = self.cubics.len();
        let [first_value, last_value] = self.ends.map(T::of);
        if (1..=last).contains(&count) {
            return self.cubics[count - 1].at(q - T::of(self.places[count - 1]));
        }
        match (self.period, count) {
            (None, _) => InputMotion {
                p: if count == 0 { first_value } else { last_value },
                w: T::default(),
                a: T::default(),
            },
            (Some(period), 0) => {
                let before = self.piece(last, q + T::exactly(period));
                let p = before.p + (first_value - last_value);
                InputMotion { p, ..before }
            }
            (Some(period), _) => {
                let after = self.piece(1, q - T::exactly(period));
                let p = after.p + (last_value - first_value);
                InputMotion { p, ..after }
            }
        }
    }

    /// Returns all values possible if it is unknown on which side of a knot the place lies. The
    /// midpoint is the value at the nearest double.
    fn around<T: Number>(&self, q: T) -> InputMotion<T> {
        let near = self.behind(q.nearest());
        let mut all = self.piece(near, q);
        let mut take = |count: usize| {
            let InputMotion { p, w, a } = self.piece(count, q);
            all = InputMotion {
                p: all.p.either(p),
                w: all.w.either(w),
                a: all.a.either(a),
            };
        };
        let place = |k: usize| T::of(self.places[k]);
        let is_open_end = |k: usize| self.period.is_none() && (k == 0 || k == self.cubics.len());
        // A named coordinate at an open end is inside the table.
        let touches = |k: usize| !(is_open_end(k) && q.nearest() == self.places[k].hi);
        let mut below = near;
        while below > 0 && touches(below - 1) && !q.exceeds(place(below - 1)) {
            below -= 1;
            take(below);
        }
        let mut above = near;
        while above < self.places.len() && touches(above) && !place(above).exceeds(q) {
            above += 1;
            take(above);
        }
        all
    }

    /// Returns the places of the first and the last knot of an open table, in degrees or scaled
    /// lengths.
    pub(super) fn open_ends(&self) -> Option<[f64; 2]> {
        let ends = [self.places.first()?.hi, self.places.last()?.hi];
        self.period.is_none().then_some(ends)
    }

    /// Returns the distance of the next knot from a place, in degrees or scaled lengths. Within it
    /// the table is one cubic. If the place `is_end`, a knot at this place does not count.
    pub(super) fn smooth(&self, q: f64, is_end: bool) -> f64 {
        let q = self.within(q);
        let around = self.period.map_or([None, None], |period| {
            let [first, last] = [self.places[0].hi, self.places[self.cubics.len()].hi];
            [Some(last - period), Some(first + period)]
        });
        let knots = self.places.iter().map(|place| place.hi);
        let knots = knots.chain(around.into_iter().flatten());
        knots
            .map(|knot| (knot - q).abs())
            .filter(|&away| !is_end || away > 0.0)
            .fold(f64::INFINITY, f64::min)
    }
}

impl TableCubic {
    fn at<T: Number>(&self, d: T) -> InputMotion<T> {
        let [c0, c1, c2, c3] = self.0.map(T::of);
        let steep = c3 * d;
        InputMotion {
            p: c0 + d * (c1 + d * (c2 + steep)),
            w: c1 + d * (c2.scaled(2.0) + T::exactly(3.0) * steep),
            a: c2.scaled(2.0) + T::exactly(6.0) * steep,
        }
    }
}
