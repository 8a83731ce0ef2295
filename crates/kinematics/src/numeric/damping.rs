//! The damping of the method of Levenberg and Marquardt: how it changes, and when a search ends.
//!
//! Callers know their unknowns and solve for the damped step. This loop only decides which damping
//! is tried next.

/// The rules of a damped search.
#[derive(Clone, Copy, Debug)]
pub struct DampedSearch {
    /// Maximum number of improving steps.
    pub steps: usize,
    /// Maximum number of tries, improving or not.
    pub tries: usize,
    /// The initial damping.
    pub damping: f64,
    /// The factor of the damping after a failed try.
    pub growth: f64,
    /// The factor of the growth after each failed try in a row.
    pub growth_of_growth: f64,
    /// The factor of the damping after an improving step.
    pub shrinking: f64,
    /// The smallest damping of any step.
    pub min_damping: f64,
    /// The search ends above this damping.
    pub max_damping: f64,
    /// The measure at which a place is exact.
    pub exact: f64,
    /// A step that reduces the measure by less than this part makes no progress.
    pub min_gain: f64,
    /// The number of steps in a row without progress after which the search has converged.
    pub level_steps: usize,
}

/// The result of one try.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Trial {
    /// The caller keeps the new place.
    Kept {
        /// The measure at the new place.
        measure: f64,
        /// The factor of the damping, if it is not that of the rules.
        shrinking: Option<f64>,
    },
    /// The step does not improve the measure.
    Rejected,
    /// The search ends: no further step has any effect.
    Finished,
}

/// An improving step has its measure; `None` rejects the step.
impl From<Option<f64>> for Trial {
    fn from(better: Option<f64>) -> Trial {
        better.map_or(Trial::Rejected, |measure| Trial::Kept {
            measure,
            shrinking: None,
        })
    }
}

impl DampedSearch {
    /// Rules with no limit on the number of steps.
    pub const DEFAULT: DampedSearch = DampedSearch {
        steps: usize::MAX,
        tries: usize::MAX,
        damping: 1e-3,
        growth: 6.0,
        growth_of_growth: 1.0,
        shrinking: 0.2,
        min_damping: 1e-30,
        max_damping: 1e14,
        exact: 0.0,
        min_gain: 1e-10,
        level_steps: 4,
    };

    /// Searches from a place with the given measure, such as the sum of squares, and returns the
    /// measure of the last place.
    ///
    /// `try_step` tries the step of a damping. If this improves the measure, it keeps the new place
    /// and returns its measure.
    pub fn run<T: Into<Trial>>(&self, start: f64, mut try_step: impl FnMut(f64) -> T) -> f64 {
        let mut measure = start;
        let (mut damping, mut growth) = (self.damping, self.growth);
        let (mut steps, mut level) = (0, 0);
        for _ in 0..self.tries {
            let is_finished = steps >= self.steps || level >= self.level_steps;
            // Negated so that NaN also ends the search.
            if is_finished || !(measure > self.exact) || damping > self.max_damping {
                break;
            }
            match try_step(damping).into() {
                Trial::Kept {
                    measure: better,
                    shrinking,
                } => {
                    let is_level = better > measure * (1.0 - self.min_gain);
                    level = if is_level { level + 1 } else { 0 };
                    steps += 1;
                    measure = better;
                    let shrinking = shrinking.unwrap_or(self.shrinking);
                    damping = (damping * shrinking).max(self.min_damping);
                    growth = self.growth;
                }
                Trial::Rejected => {
                    damping *= growth;
                    growth *= self.growth_of_growth;
                }
                Trial::Finished => break,
            }
        }
        measure
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RULES: DampedSearch = DampedSearch {
        steps: 50,
        tries: 200,
        growth: 8.0,
        exact: 1e-30,
        level_steps: 3,
        ..DampedSearch::DEFAULT
    };

    /// Fits the exponent of e^(k x) to points of e^(2 x).
    fn fit(rules: DampedSearch, start: f64) -> (f64, f64) {
        let points = [0.0, 0.25, 0.5, 0.75, 1.0];
        let deviations = |k: f64| points.map(|x| f64::exp(2.0 * x) - f64::exp(k * x));
        let square = |k: f64| deviations(k).iter().map(|d| d * d).sum::<f64>();
        let mut k = start;
        let measure = rules.run(square(k), |damping| {
            let slopes = points.map(|x| x * f64::exp(k * x));
            let products = slopes.iter().zip(deviations(k));
            let pull: f64 = products.map(|(s, d)| s * d).sum();
            let own: f64 = slopes.iter().map(|s| s * s).sum();
            let trial = k + pull / (own * (1.0 + damping));
            (square(trial) < square(k)).then(|| {
                k = trial;
                square(k)
            })
        });
        (k, measure)
    }

    #[test]
    fn search_finds_minimum_from_far_start() {
        let (k, measure) = fit(RULES, -3.0);
        assert!((k - 2.0).abs() < 1e-14 && measure <= 1e-30, "{k} {measure}");
    }

    #[test]
    fn number_of_steps_and_tries_is_limited() {
        for (rules, expected) in [
            (DampedSearch { steps: 3, ..RULES }, 3),
            (DampedSearch { tries: 4, ..RULES }, 4),
        ] {
            let mut count = 0;
            rules.run(1.0, |_| {
                count += 1;
                Some(0.5_f64.powi(count))
            });
            assert_eq!(count, expected);
        }
    }

    #[test]
    fn damping_grows_until_no_step_is_possible() {
        let mut tried = Vec::new();
        let rules = DampedSearch {
            growth_of_growth: 2.0,
            max_damping: 10.0,
            ..RULES
        };
        rules.run(1.0, |damping| {
            tried.push(damping);
            Trial::Rejected
        });
        assert_eq!(tried, [1e-3, 8e-3, 8e-3 * 16.0, 8e-3 * 16.0 * 32.0]);
    }

    #[test]
    fn steps_without_progress_end_the_search() {
        let mut count = 0;
        let measure = RULES.run(1.0, |_| {
            count += 1;
            Some(1.0 - 1e-12 * f64::from(count))
        });
        assert_eq!((count, measure), (3, 1.0 - 3e-12));
    }

    #[test]
    fn default_rules_end_after_four_level_steps() {
        let mut tried = Vec::new();
        DampedSearch::DEFAULT.run(1.0, |damping| {
            tried.push(damping);
            Some(1.0)
        });
        let shrunk = |k| (0..k).fold(1e-3, |damping, _| damping * 0.2);
        assert_eq!(tried, [0, 1, 2, 3].map(shrunk));
    }

    #[test]
    fn level_steps_count_in_a_row() {
        let rules = DampedSearch {
            min_gain: 0.5,
            level_steps: 2,
            ..RULES
        };
        // A step that gains exactly the minimum is progress.
        let measures = [0.9, 0.45, 0.4, 0.2, 0.19, 0.18, 0.0];
        let mut next = measures.into_iter();
        assert_eq!(rules.run(1.0, |_| next.next()), 0.18);
    }

    #[test]
    fn limits_of_damping_and_measure_are_inclusive() {
        let mut tried = Vec::new();
        let rules = DampedSearch {
            damping: 1.0,
            growth: 10.0,
            max_damping: 100.0,
            ..RULES
        };
        rules.run(1.0, |damping| {
            tried.push(damping);
            Trial::Rejected
        });
        assert_eq!(tried, [1.0, 10.0, 100.0]);
        let exact = DampedSearch {
            exact: 0.5,
            ..RULES
        };
        assert_eq!(exact.run(0.5, |_| Some(0.1)), 0.5);
    }

    #[test]
    fn damping_shrinks_to_its_minimum() {
        let rules = DampedSearch {
            damping: 1.0,
            shrinking: 0.1,
            min_damping: 0.05,
            steps: 4,
            ..RULES
        };
        let (mut tried, mut measure) = (Vec::new(), 1.0);
        rules.run(measure, |damping| {
            tried.push(damping);
            measure *= 0.5;
            // The second step has a factor of its own.
            let shrinking = (tried.len() == 2).then_some(0.7);
            Trial::Kept { measure, shrinking }
        });
        assert_eq!(tried, [1.0, 0.1, 0.1 * 0.7, 0.05]);
    }

    #[test]
    fn finished_search_keeps_its_measure() {
        let mut results = [Trial::from(Some(0.5)), Trial::Finished].into_iter();
        let measure = RULES.run(1.0, |_| results.next().unwrap_or(Trial::from(Some(0.1))));
        assert_eq!(measure, 0.5);
    }
}
