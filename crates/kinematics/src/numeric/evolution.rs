//! Creates trial designs for differential evolution (Storn and Price, 1997).
//!
//! A generation is a set of number vectors. Each is replaced by its trial if that is at least as
//! good. Callers evaluate and replace, because they know which of two designs is better.

use super::SeededRng;

/// The mean weight of the difference of two designs, and its largest deviation. A weight that
/// varies keeps small generations from stagnating.
const WEIGHT: f64 = 0.65;
const WEIGHT_SPREAD: f64 = 0.25;
/// The probability of each number to come from the mutant.
const CROSSING: f64 = 0.9;

/// Crosses a mutant of three random designs with a design, whose numbers are replaced. The mutant
/// is `a + w (b - c)`; half of the mutants are pulled towards the best design by a random part.
/// Returns the index of `a`.
///
/// A number beyond a bound is set halfway between its old value and the bound. A number without
/// bounds, such as an angle, may take any value. The generation must not be empty, and all vectors
/// must have the same length.
pub fn mutate<G: AsRef<[f64]>>(
    own: &mut [f64],
    generation: &[G],
    best: Option<&[f64]>,
    bounds: &[Option<[f64; 2]>],
    rng: &mut SeededRng,
) -> usize {
    let last = u32::try_from(generation.len().saturating_sub(1)).unwrap_or(u32::MAX);
    let origins: [usize; 3] = std::array::from_fn(|_| rng.between(0, last) as usize);
    let [a, b, c] = origins.map(|i| generation[i].as_ref());
    let weight = WEIGHT + WEIGHT_SPREAD * rng.even();
    let pull = rng.even().max(0.0);
    for (i, (own, bounds)) in own.iter_mut().zip(bounds).enumerate() {
        if rng.even() > 2.0 * CROSSING - 1.0 {
            continue;
        }
        let towards = best.map_or(0.0, |best| pull * (best[i] - a[i]));
        let number = a[i] + towards + weight * (b[i] - c[i]);
        *own = match bounds {
            Some([low, _]) if number < *low => 0.5 * (*own + low),
            Some([_, high]) if number > *high => 0.5 * (*own + high),
            _ => number,
        };
    }
    origins[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A generation on a line stays on the line, and within its bounds.
    #[test]
    fn trials_stay_in_span_and_within_bounds() {
        let mut rng = SeededRng::new(5);
        let generation: Vec<[f64; 2]> = (0..20).map(|k| [f64::from(k), 7.0]).collect();
        let bounds = [Some([0.0, 19.0]), None];
        let mut bases = Vec::new();
        for k in 0..1000 {
            let mut own = generation[k % 20];
            bases.push(mutate(
                &mut own,
                &generation,
                Some(&[3.0, 7.0]),
                &bounds,
                &mut rng,
            ));
            assert!((0.0..=19.0).contains(&own[0]) && own[1] == 7.0, "{own:?}");
        }
        assert!(
            (0..20).all(|k| bases.contains(&k)),
            "each is a base at times"
        );
    }

    /// Minimizes Rosenbrock's function by replacing each design with a better trial.
    #[test]
    fn evolution_follows_curved_valley() {
        let value = |x: &[f64; 2]| (1.0 - x[0]).powi(2) + 100.0 * (x[1] - x[0] * x[0]).powi(2);
        let mut rng = SeededRng::new(2);
        let mut draw = || [rng.within(-2.0, 2.0), rng.within(-1.0, 3.0)];
        let mut all: Vec<[f64; 2]> = (0..24).map(|_| draw()).collect();
        let best = |all: &[[f64; 2]]| {
            let better = |a: &usize, b: &usize| value(&all[*a]).total_cmp(&value(&all[*b]));
            (0..all.len()).min_by(better)
        };
        for _ in 0..120 {
            let first = best(&all).map(|first| all[first]);
            let first = first.as_ref().map(|first| &first[..]);
            let bounds = [Some([-2.0, 2.0]), Some([-1.0, 3.0])];
            for i in 0..all.len() {
                let mut own = all[i];
                mutate(&mut own, &all, first, &bounds, &mut rng);
                if value(&own) <= value(&all[i]) {
                    all[i] = own;
                }
            }
        }
        let found = all[best(&all).unwrap()];
        assert!(value(&found) < 1e-12, "{found:?}");
    }

    #[test]
    fn tenth_of_the_numbers_stays() {
        let mut rng = SeededRng::new(3);
        let mut own = [-1.0; 1000];
        mutate(&mut own, &[[2.0; 1000]], None, &[None; 1000], &mut rng);
        let kept = own.iter().filter(|&&number| number == -1.0).count();
        assert!((70..130).contains(&kept), "{kept}");
        assert!(own.iter().all(|&number| number == -1.0 || number == 2.0));
    }

    #[test]
    fn half_of_the_trials_are_pulled_towards_the_best_design() {
        let mut rng = SeededRng::new(8);
        let mut pulled = 0;
        for _ in 0..1000 {
            let mut own = [-1.0; 20];
            mutate(
                &mut own,
                &[[0.0; 20]],
                Some(&[5.0; 20]),
                &[None; 20],
                &mut rng,
            );
            let moved = own.into_iter().find(|&own| own != -1.0).unwrap();
            assert!((0.0..=5.0).contains(&moved), "{moved}");
            pulled += usize::from(moved > 0.0);
        }
        assert!((450..550).contains(&pulled), "{pulled}");
    }

    #[test]
    fn number_beyond_a_bound_is_halfway_to_it() {
        let mut rng = SeededRng::new(4);
        let mut trial = |number: f64| {
            let mut own = [4.0; 50];
            mutate(
                &mut own,
                &[[number; 50]],
                None,
                &[Some([1.0, 9.0]); 50],
                &mut rng,
            );
            own.into_iter().find(|&own| own != 4.0)
        };
        assert_eq!(trial(-2.0), Some(2.5));
        assert_eq!(trial(12.0), Some(6.5));
        // A number at a bound stays there.
        assert_eq!((trial(1.0), trial(9.0)), (Some(1.0), Some(9.0)));
    }

    #[test]
    fn trial_starts_from_returned_design_and_moves_by_weighted_difference() {
        let mut rng = SeededRng::new(6);
        let generation = [[0.0], [1.0]];
        let mut weights = Vec::new();
        for _ in 0..2000 {
            let mut own = [-9.0];
            let from = mutate(&mut own, &generation, None, &[None], &mut rng);
            let moved = (own[0] - generation[from][0]).abs();
            if own[0] != -9.0 && moved != 0.0 {
                weights.push(moved);
            }
        }
        let (low, high) = (
            weights.iter().copied().fold(9.0, f64::min),
            weights.iter().copied().fold(0.0, f64::max),
        );
        assert!(
            (0.4..0.405).contains(&low) && (0.895..=0.9).contains(&high),
            "{low} {high}"
        );
    }
}
