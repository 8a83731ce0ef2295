//! Runs a checked formula as steps over a stack, in any arithmetic and without allocating.

use super::jet::{Jet, pi};
use crate::{Constant, Number};

/// A step. It takes its arguments from the stack and pushes its result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Op {
    Number(f64),
    Pi,
    /// An input value, by its index.
    Leaf(u16),
    Add,
    Subtract,
    Multiply,
    Divide,
    Negate,
    Power(i8),
    Sqrt,
    Abs,
    Min,
    Max,
    Hypot,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    /// The arguments are y, then x.
    Atan2,
    /// Multiplication by a quotient of whole numbers.
    Scale(f64, f64),
    Radians,
    Degrees,
    /// An angle reduced to above -180 up to 180 degrees.
    ShortWay,
    /// An angle reduced to a direction in [0, 360) degrees.
    Wrap,
    /// A direction used as a number: undefined where it may be on either side of 360 degrees.
    Uncut,
    Rate,
}

impl Op {
    /// Returns the number of arguments.
    pub(super) fn takes(self) -> usize {
        match self {
            Op::Number(_) | Op::Pi | Op::Leaf(_) => 0,
            Op::Add
            | Op::Subtract
            | Op::Multiply
            | Op::Divide
            | Op::Min
            | Op::Max
            | Op::Hypot
            | Op::Atan2 => 2,
            _ => 1,
        }
    }
}

/// The steps of a formula.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Code {
    ops: Box<[Op]>,
    /// The number of times that the rate of each step is taken.
    rates: Box<[u8]>,
}

/// Maximum number of values on the stack.
const STACK: usize = 40;
/// Maximum number of steps, including those of all formulas that one uses.
const MAX_COUNT: usize = 4096;
/// The order of the highest rate that a state has.
const MAX_RATE: u8 = 2;

/// The limit that a formula exceeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Excess {
    Steps,
    Rates,
}

impl Code {
    /// Creates code from steps that leave one value.
    pub(crate) fn new(ops: Vec<Op>) -> Result<Code, Excess> {
        if ops.len() > MAX_COUNT {
            return Err(Excess::Steps);
        }
        let mut rates = vec![0_u8; ops.len()];
        // The index where the steps of each value on the stack begin.
        let mut starts: Vec<usize> = Vec::new();
        for (i, op) in ops.iter().enumerate() {
            let taken = starts.len().saturating_sub(op.takes());
            let start = starts.get(taken).copied().unwrap_or(i);
            if *op == Op::Rate {
                rates[start..i].iter_mut().for_each(|r| *r += 1);
                if rates[start..i].iter().any(|r| *r > MAX_RATE) {
                    return Err(Excess::Rates);
                }
            }
            starts.truncate(taken);
            starts.push(start);
            if starts.len() > STACK {
                return Err(Excess::Steps);
            }
        }
        Ok(Code {
            ops: ops.into(),
            rates: rates.into(),
        })
    }

    pub(crate) fn ops(&self) -> &[Op] {
        &self.ops
    }

    /// Returns the input values, each with its highest required rate.
    pub(crate) fn inputs_with_rates(&self) -> impl Iterator<Item = (u16, u8)> {
        let steps = self.ops.iter().zip(&self.rates);
        steps.filter_map(|(op, rates)| match op {
            Op::Leaf(leaf) => Some((*leaf, *rates)),
            _ => None,
        })
    }

    /// Evaluates the formula; `None` if an input is missing. `leaf` returns the inputs and their
    /// rates, by order.
    pub(crate) fn run<T: Number>(&self, leaf: impl Fn(u16, u8) -> Option<T>) -> Option<T> {
        self.run_turning(leaf, |_, _, _, _| {})
    }

    /// Evaluates the formula and lets `turn` change each result. `turn` receives the index of the
    /// step, the step, its first two arguments and its result, all with their rates.
    pub(super) fn run_turning<T: Number>(
        &self,
        leaf: impl Fn(u16, u8) -> Option<T>,
        turn: impl FnMut(usize, Op, [&[T]; 2], &mut [T]),
    ) -> Option<T> {
        match self.rates.iter().max() {
            None | Some(0) => self.run_to::<T, 1>(leaf, turn),
            Some(1) => self.run_to::<T, 2>(leaf, turn),
            Some(_) => self.run_to::<T, 3>(leaf, turn),
        }
    }

    /// Runs the steps over values with N coefficients.
    fn run_to<T: Number, const N: usize>(
        &self,
        leaf: impl Fn(u16, u8) -> Option<T>,
        mut turn: impl FnMut(usize, Op, [&[T]; 2], &mut [T]),
    ) -> Option<T> {
        let mut stack = [Jet::<T, N>::default(); STACK];
        let mut top = 0;
        for (number, (&op, &rates)) in self.ops.iter().zip(&self.rates).enumerate() {
            top -= op.takes();
            let [a, b] = [stack[top], stack[(top + 1).min(STACK - 1)]];
            let mut made = match op {
                Op::Leaf(of) => {
                    let mut known = [T::default(); N];
                    for (degree, rate) in (0..=rates).zip(&mut known) {
                        *rate = leaf(of, degree)?;
                    }
                    Jet::of_rates(known)
                }
                op => or_nan_on_underflow(op, step(op, a, b), a),
            };
            let taken = [a.coefficients(), b.coefficients()];
            turn(number, op, taken, made.coefficients_mut());
            stack[top] = made;
            top += 1;
        }
        Some(stack[0].value())
    }
}

/// Returns the result of a step, or NaN if it underflows, because no bound covers that.
fn or_nan_on_underflow<T: Number, const N: usize>(
    op: Op,
    made: Jet<T, N>,
    of: Jet<T, N>,
) -> Jet<T, N> {
    let is_lost = match op {
        Op::Number(_) => made.is_lost(made),
        Op::Scale(..) | Op::Radians | Op::Degrees => made.is_lost(of),
        // A sine may be 0 if its angle is not small, so the angle is checked instead. A direction
        // is also measured from a full turn.
        Op::Sin | Op::Tan | Op::Asin => of.is_lost(of),
        Op::Atan2 => made.is_lost(of),
        Op::Pi
        | Op::Leaf(_)
        | Op::Add
        | Op::Subtract
        | Op::Multiply
        | Op::Divide
        | Op::Negate
        | Op::Power(_)
        | Op::Sqrt
        | Op::Abs
        | Op::Min
        | Op::Max
        | Op::Hypot
        | Op::Cos
        | Op::Acos
        | Op::ShortWay
        | Op::Wrap
        | Op::Uncut
        | Op::Rate => false,
    };
    match is_lost {
        true => Jet::nothing(),
        false => made,
    }
}

fn step<T: Number, const N: usize>(op: Op, a: Jet<T, N>, b: Jet<T, N>) -> Jet<T, N> {
    match op {
        Op::Number(value) => Jet::constant(T::of(Constant::given(value))),
        Op::Pi => Jet::constant(T::of(pi())),
        Op::Leaf(_) => Jet::nothing(),
        Op::Add => a.plus(b),
        Op::Subtract => a.minus(b),
        Op::Multiply => a.product(b),
        Op::Divide => a.quotient(b),
        Op::Negate => a.negative(),
        Op::Power(exponent) => a.power(exponent),
        Op::Sqrt => a.root(),
        Op::Abs => a.size(),
        Op::Min => a.lesser(b),
        Op::Max => a.negative().lesser(b.negative()).negative(),
        Op::Hypot => Jet::norm(a, b),
        Op::Sin => a.unit()[1],
        Op::Cos => a.unit()[0],
        Op::Tan => {
            let [cos, sin] = a.unit();
            sin.quotient(cos)
        }
        Op::Asin => arc_sine(a),
        Op::Acos => Jet::direction(a, other_leg(a)),
        Op::Atan2 => Jet::direction(b, a),
        Op::Scale(by, over) => a.scaled(by, over),
        Op::Radians => a.radians(),
        Op::Degrees => a.degrees(),
        Op::ShortWay => short_way(a),
        Op::Wrap => a.moved(T::wrapped(a.value())),
        Op::Uncut => uncut(a),
        Op::Rate => a.rate(),
    }
}

/// Returns the sine for a cosine, or the cosine for a sine, of an angle in the upper half plane.
fn other_leg<T: Number, const N: usize>(leg: Jet<T, N>) -> Jet<T, N> {
    let one = Jet::constant(T::exactly(1.0));
    one.minus(leg).product(one.plus(leg)).root()
}

/// Returns the arcsine. In the lower half plane, the direction is measured downwards from 0. The
/// angle of a sine near 0 is as far from 360 as from 0 degrees.
fn arc_sine<T: Number, const N: usize>(sine: Jet<T, N>) -> Jet<T, N> {
    let cosine = other_leg(sine);
    if T::default().exceeds(sine.value()) {
        Jet::direction(cosine, sine.negative()).negative()
    } else if sine.value().exceeds(T::exactly(BELOW_ZERO)) {
        Jet::direction(cosine, sine)
    } else {
        Jet::nothing()
    }
}

/// Half a turn and a full turn, in degrees. Half a turn counts as positive.
const HALF: f64 = 180.0;
const TURN: f64 = 360.0;
const OVER_HALF: f64 = 180.000_000_000_000_03;
const BELOW_ZERO: f64 = -f64::MIN_POSITIVE;

fn short_way<T: Number, const N: usize>(way: Jet<T, N>) -> Jet<T, N> {
    let turns = ((way.value().nearest() - HALF) / TURN).ceil();
    let short = way.value() - T::exactly(turns * TURN);
    // The cut may lie between the value and the true one, or between lanes.
    let is_short = short.exceeds(T::exactly(-HALF)) && T::exactly(OVER_HALF).exceeds(short);
    match is_short {
        true => way.moved(short),
        false => Jet::nothing(),
    }
}

fn uncut<T: Number, const N: usize>(direction: Jet<T, N>) -> Jet<T, N> {
    let value = direction.value();
    let is_within = value.exceeds(T::exactly(BELOW_ZERO)) && T::exactly(TURN).exceeds(value);
    match is_within {
        true => direction,
        false => Jet::nothing(),
    }
}
