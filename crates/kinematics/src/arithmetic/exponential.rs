//! Exponentials and logarithms to twice the digits.

use super::Double;

/// ln 2 and 1 / ln 10, to twice the digits.
const LN_2: Double = Double {
    hi: std::f64::consts::LN_2,
    lo: 2.319_046_813_846_299_6e-17,
};
/// ln 10.
const LN_10: Double = Double {
    hi: std::f64::consts::LN_10,
    lo: -2.170_756_223_382_249_4e-16,
};
/// What is left of the exponent is halved so often, and the result squared as often.
const HALVINGS: u8 = 6;
/// Terms of the series: the rest is less than 0.0055^14 / 14!, 3e-43.
const TERMS: u8 = 14;

impl Double {
    /// e to this power, to about 2^-96 of it; infinite or nothing where a double is.
    #[must_use]
    pub fn exp(self) -> Double {
        let twos = (self.hi / LN_2.hi).round();
        if !(twos.abs() <= 1000.0) {
            return Double::exactly(self.hi.exp());
        }
        let rest = self - LN_2 * Double::exactly(twos);
        let small = rest.scaled(0.5_f64.powi(i32::from(HALVINGS)));
        // 1 + x (1 + x / 2 (1 + x / 3 ...)), from the inside.
        let series = (1..=TERMS).rev().fold(Double::ONE, |inner, k| {
            Double::ONE + small * inner / Double::exactly(f64::from(k))
        });
        let power = (0..HALVINGS).fold(series, |power, _| power * power);
        #[expect(clippy::cast_possible_truncation, reason = "at most 1000")]
        power.scaled(2.0_f64.powi(twos as i32))
    }

    /// The natural logarithm, to about 2^-96; not a number of what is negative.
    #[must_use]
    pub fn ln(self) -> Double {
        let near = self.hi.ln();
        if !near.is_finite() {
            return Double::exactly(near);
        }
        // One step of Newton's: ln(1 + e) = e - e^2 / 2, with e of the size of a rounding.
        let over = self * Double::exactly(-near).exp() - Double::ONE;
        Double::exactly(near) + over - (over * over).scaled(0.5)
    }

    /// The logarithm to the base 10.
    #[must_use]
    pub fn log10(self) -> Double {
        self.ln() / LN_10
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against 32 digits by other programs.
    #[test]
    fn powers_and_logarithms_have_twice_the_digits() {
        for (found, hi, lo) in [
            (
                Double::ONE.exp(),
                std::f64::consts::E,
                1.445_646_891_729_250_2e-16,
            ),
            (Double::exactly(2.0).ln(), LN_2.hi, LN_2.lo),
            (Double::exactly(10.0).ln(), LN_10.hi, LN_10.lo),
            // log10 of 2 is 0.30102999566398119521373889472449.
            (
                Double::exactly(2.0).log10(),
                std::f64::consts::LOG10_2,
                -2.803_728_127_785_17e-18,
            ),
        ] {
            let miss = found - Double { hi, lo };
            assert!(miss.hi.abs() < 1e-29, "{found:?} {miss:?}");
        }
    }

    #[test]
    fn each_undoes_the_other() {
        for k in -60..=60 {
            let x = Double::exactly(f64::from(k) * 0.77);
            let again = x.exp().ln() - x;
            assert!(again.hi.abs() < 1e-27, "{k}: {again:?}");
        }
        assert!(Double::exactly(-1.0).ln().hi.is_nan());
        assert_eq!(Double::exactly(-1e4).exp(), Double::ZERO);
    }
}
