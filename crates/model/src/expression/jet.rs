//! Represents a value with its rates, by the first coefficients of its Taylor series over time.

use crate::{Constant, Double, Number, Vec2};

/// A truncated Taylor series c\[0\] + c\[1\] t + c\[2\] t^2, with N coefficients.
///
/// An angle in degrees has its rates in radians, as everywhere in krank: c\[0\] is in degrees, the
/// others are not. So no conversion is needed between an angle and its angular velocity. Nonlinear
/// functions except sine and cosine take angles in radians.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Jet<T, const N: usize>([T; N]);

impl<T: Number, const N: usize> Default for Jet<T, N> {
    fn default() -> Self {
        Jet([T::default(); N])
    }
}

impl<T: Number, const N: usize> Jet<T, N> {
    /// Creates a constant.
    pub(crate) fn constant(value: T) -> Self {
        let mut jet = Jet::default();
        jet.0[0] = value;
        jet
    }

    /// Creates a series from the value and its first and second derivative.
    pub(crate) fn of_rates(rates: [T; N]) -> Self {
        let mut jet = Jet(rates);
        if let Some(second) = jet.0.get_mut(2) {
            *second = second.scaled(0.5);
        }
        jet
    }

    /// Creates an undefined value: NaN.
    pub(super) fn nothing() -> Self {
        Jet([T::exactly(f64::NAN); N])
    }

    pub(crate) fn value(self) -> T {
        self.0[0]
    }

    /// Returns the coefficients.
    pub(super) fn coefficients(&self) -> &[T] {
        &self.0
    }

    pub(super) fn coefficients_mut(&mut self) -> &mut [T] {
        &mut self.0
    }

    /// Keeps the value and makes the rates NaN.
    fn without_rates(self) -> Self {
        let mut jet = Jet::nothing();
        jet.0[0] = self.0[0];
        jet
    }

    /// Returns the time derivative. Its last coefficient is unknown and set to zero.
    pub(super) fn rate(self) -> Self {
        let mut jet = Jet::default();
        for n in 1..N {
            jet.0[n - 1] = times(n, self.0[n]);
        }
        jet
    }

    fn each(mut self, f: impl Fn(T) -> T) -> Self {
        self.0.iter_mut().for_each(|c| *c = f(*c));
        self
    }

    fn with(mut self, other: Self, f: impl Fn(T, T) -> T) -> Self {
        for (c, other) in self.0.iter_mut().zip(other.0) {
            *c = f(*c, other);
        }
        self
    }

    pub(super) fn plus(self, other: Self) -> Self {
        self.with(other, |a, b| a + b)
    }

    pub(super) fn minus(self, other: Self) -> Self {
        self.with(other, |a, b| a - b)
    }

    pub(super) fn negative(self) -> Self {
        self.each(|c| -c)
    }

    /// Replaces the value and keeps the rates.
    pub(super) fn moved(mut self, to: T) -> Self {
        self.0[0] = to;
        self
    }

    /// Multiplies by a quotient of two doubles.
    pub(super) fn scaled(self, by: f64, over: f64) -> Self {
        self.each(|c| c * T::exactly(by) / T::exactly(over))
    }

    /// Converts degrees to radians; the rates are in radians already.
    pub(super) fn radians(self) -> Self {
        self.moved(self.0[0] * T::of(exact(Double::RADIAN)))
    }

    pub(super) fn degrees(self) -> Self {
        self.moved(self.0[0] * T::of(exact(Double::DEGREES)))
    }

    /// Multiplies; NaN if the product of nonzero values underflows, because bounds do not cover
    /// that.
    pub(super) fn product(self, other: Self) -> Self {
        let is_something = |jet: Self| jet.0[0].abs().exceeds(T::default());
        let value = self.0[0] * other.0[0];
        if is_something(self) && is_something(other) && !value.abs().exceeds(T::exactly(MIN_VALUE))
        {
            return Jet::nothing();
        }
        let mut product = Jet::default();
        for n in 0..N {
            product.0[n] = convolved(&self.0, &other.0, n, 0..n + 1);
        }
        product
    }

    /// Solves q b = a; NaN if b may be 0 or the quotient underflows.
    pub(super) fn quotient(self, by: Self) -> Self {
        if !by.0[0].abs().exceeds(T::default()) {
            return Jet::nothing();
        }
        let is_something = self.0[0].abs().exceeds(T::default());
        if is_something && !(self.0[0] / by.0[0]).abs().exceeds(T::exactly(MIN_VALUE)) {
            return Jet::nothing();
        }
        let mut quotient = Jet::default();
        for n in 0..N {
            let known = convolved(&quotient.0, &by.0, n, 0..n);
            quotient.0[n] = if n == 0 { self.0[0] } else { self.0[n] - known } / by.0[0];
        }
        quotient
    }

    pub(super) fn power(self, exponent: i8) -> Self {
        let mut power = self;
        for _ in 1..exponent.unsigned_abs() {
            power = power.product(self);
        }
        match exponent < 0 {
            true => Jet::constant(T::exactly(1.0)).quotient(power),
            false => power,
        }
    }

    /// Solves s s = a. At 0, the rates are NaN.
    pub(super) fn root(self) -> Self {
        self.root_from(self.0[0].sqrt())
    }

    /// Returns the length of a vector; its rates are NaN if the length is 0.
    pub(super) fn norm(x: Self, y: Self) -> Self {
        let square = x.product(x).plus(y.product(y));
        square.root_from(T::norm(Vec2::new(x.0[0], y.0[0])))
    }

    /// Returns the square root, given its value.
    fn root_from(self, value: T) -> Self {
        let mut root = Jet::constant(value);
        if !value.exceeds(T::default()) {
            return root.without_rates();
        }
        for n in 1..N {
            let known = convolved(&root.0, &root.0, n, 1..n);
            root.0[n] = (self.0[n] - known) / value.scaled(2.0);
        }
        root
    }

    /// Returns the direction of a vector in degrees, in [0, 360); NaN if the vector may be 0. Its
    /// rate w satisfies w (x^2 + y^2) = x y' - y x'.
    pub(super) fn direction(x: Self, y: Self) -> Self {
        let vector = Vec2::new(x.0[0], y.0[0]);
        if !T::norm(vector).exceeds(T::default()) {
            return Jet::nothing();
        }
        let across = x.product(y.rate()).minus(y.product(x.rate()));
        let rate = match N {
            1 => Jet::default(),
            _ => across.quotient(x.product(x).plus(y.product(y))),
        };
        rate.integral(T::degrees(vector))
    }

    /// Returns the cosine and sine of an angle in degrees: e' = i a' e.
    pub(super) fn unit(self) -> [Self; 2] {
        let Vec2 { x, y } = T::unit(self.0[0]);
        let (mut cos, mut sin) = (Jet::constant(x), Jet::constant(y));
        let rate = self.rate();
        for n in 1..N {
            let n_th = T::exactly(n as f64);
            cos.0[n] = -convolved(&rate.0, &sin.0, n - 1, 0..n) / n_th;
            sin.0[n] = convolved(&rate.0, &cos.0, n - 1, 0..n) / n_th;
        }
        [cos, sin]
    }

    /// Integrates this rate from the initial value `value`.
    fn integral(self, value: T) -> Self {
        let mut jet = Jet::constant(value);
        for n in 1..N {
            jet.0[n] = self.0[n - 1] / T::exactly(n as f64);
        }
        jet
    }

    /// Returns `true` if this result of a nonzero value `of` underflows or is NaN; bounds do not
    /// cover that.
    pub(super) fn is_lost(self, of: Self) -> bool {
        let was_something = of.0[0].abs().exceeds(T::default());
        was_something && !self.0[0].abs().exceeds(T::exactly(MIN_CONVERTED))
    }

    /// Returns the absolute value. If the value may be 0, the rates are NaN.
    pub(super) fn size(self) -> Self {
        let zero = T::default();
        if self.0[0].exceeds(zero) {
            self
        } else if zero.exceeds(self.0[0]) {
            self.negative()
        } else {
            let value = self.0[0];
            let size = value.abs().at_kink((-value).abs());
            self.moved(size).without_rates()
        }
    }

    /// Returns the smaller of two; NaN if one of them is. If either may be the smaller one, the
    /// rates are NaN.
    pub(super) fn lesser(self, other: Self) -> Self {
        if other.0[0].exceeds(self.0[0]) {
            self
        } else if self.0[0].exceeds(other.0[0]) {
            other
        } else {
            // `min` of a number and NaN returns the number; the added zero makes it NaN, lane by
            // lane.
            let none = (self.0[0] + other.0[0]).scaled(0.0);
            let lesser = self.0[0].min(other.0[0]).at_kink(other.0[0]);
            self.moved(lesser + none).without_rates()
        }
    }
}

/// Minimum magnitude of products and quotients; below it, the rounding error is no longer relative
/// to the value.
const MIN_VALUE: f64 = 1e-280;

/// Minimum magnitude of converted values: below about 2.2e-308, doubles lose digits.
const MIN_CONVERTED: f64 = 1e-300;

/// Returns the sum of a\[i\] b\[n - i\] for i in `range`, which may be empty.
fn convolved<T: Number>(a: &[T], b: &[T], n: usize, range: std::ops::Range<usize>) -> T {
    let terms = range.map(|i| a[i] * b[n - i]);
    terms.reduce(|sum, term| sum + term).unwrap_or_default()
}

/// Multiplies by n; exact for n of 1 and 2.
fn times<T: Number>(n: usize, value: T) -> T {
    match n {
        1 => value,
        2 => value.scaled(2.0),
        _ => value * T::exactly(n as f64),
    }
}

/// Creates a mathematical constant in double-double.
fn exact(value: Double) -> Constant {
    Constant {
        hi: value.hi,
        lo: value.lo,
        radius: 0.0,
        slope: 0.0,
    }
}

/// Returns pi.
pub(super) fn pi() -> Constant {
    exact(Double {
        hi: std::f64::consts::PI,
        lo: 1.224_646_799_147_353_2e-16,
    })
}
