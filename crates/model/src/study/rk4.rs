//! The classical Runge-Kutta method of fourth order.

/// Integrates unknowns known by their changes alone; the caller keeps the state.
///
/// An angle therefore need not be a number: the caller may keep a unit vector and rotate it.
#[derive(Clone, Debug, Default)]
pub(super) struct Rk4 {
    rates: [Vec<f64>; 4],
    change: Vec<f64>,
}

/// The fractions of a step at which the rates are evaluated.
const PARTS: [f64; 4] = [0.0, 0.5, 0.5, 1.0];

impl Rk4 {
    /// Creates the working memory for a number of unknowns.
    pub(super) fn new(unknowns: usize) -> Rk4 {
        Rk4 {
            rates: std::array::from_fn(|_| vec![0.0; unknowns]),
            change: vec![0.0; unknowns],
        }
    }

    /// Returns the change of the unknowns over a step of size `h`. `rates` evaluates the rates at a
    /// fraction of the step and a change since its beginning. It fills its last argument, or
    /// returns `None` if rates do not exist; the step then returns `None` too.
    pub(super) fn step(
        &mut self,
        h: f64,
        mut rates: impl FnMut(f64, &[f64], &mut [f64]) -> Option<()>,
    ) -> Option<&[f64]> {
        self.change.fill(0.0);
        for (k, part) in PARTS.into_iter().enumerate() {
            let (before, rest) = self.rates.split_at_mut(k);
            if let Some(last) = before.last() {
                for (change, rate) in self.change.iter_mut().zip(last) {
                    *change = part * h * rate;
                }
            }
            rates(part, &self.change, &mut rest[0])?;
        }
        let [one, two, three, four] = &self.rates;
        for (i, change) in self.change.iter_mut().enumerate() {
            *change = h / 6.0 * ((one[i] + four[i]) + 2.0 * (two[i] + three[i]));
        }
        Some(&self.change)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the error for y' = y from y = 1 over a unit of time.
    fn error_of_growth(steps: u32) -> f64 {
        let (mut y, h) = (1.0, 1.0 / f64::from(steps));
        let mut rk4 = Rk4::new(1);
        for _ in 0..steps {
            let step = rk4.step(h, |_, change, rates| {
                rates[0] = y + change[0];
                Some(())
            });
            y += step.unwrap()[0];
        }
        (y - 1.0_f64.exp()).abs()
    }

    #[test]
    fn doubling_steps_divides_error_by_16() {
        let ratio = error_of_growth(32) / error_of_growth(64);
        assert!((15.0..17.0).contains(&ratio), "{ratio}");
    }

    /// y' = 4 t^3: exact except for rounding, because the method is Simpson's rule there.
    #[test]
    fn step_is_exact_for_cubic_rates() {
        let mut rk4 = Rk4::new(1);
        let change = rk4.step(2.0, |part, _, rates| {
            rates[0] = 4.0 * (2.0 * part).powi(3);
            Some(())
        });
        assert!((change.unwrap()[0] - 16.0).abs() < 1e-14);
    }

    #[test]
    fn step_is_none_without_rates() {
        let mut rk4 = Rk4::new(1);
        let step = rk4.step(1.0, |part, _, _| (part < 0.5).then_some(()));
        assert!(step.is_none());
    }
}
