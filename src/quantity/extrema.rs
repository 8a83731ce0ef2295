//! Where a sampled figure turns, and where exactly.

/// A place at which a figure is largest or smallest among its neighbours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremum {
    /// A maximum, or else a minimum.
    pub is_peak: bool,
    /// The driver's coordinate there, in degrees or in the scene's length unit.
    pub at: f64,
    /// What stands along x there.
    pub along: f64,
    /// The figure there.
    pub value: f64,
    /// Whether it is the largest of the maxima, or the smallest of the minima.
    pub is_extreme: bool,
}

/// A sample at which a figure turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Turn {
    pub(super) sample: usize,
    pub(super) is_peak: bool,
    /// At an end of the samples: nothing is known of what lies beyond.
    pub(super) is_end: bool,
}

/// Where `values` turn by more than `least`: peaks and dips in turn. Where they go round, the first
/// follows the last, which repeats it.
pub(super) fn turns(values: &[f64], least: f64, goes_round: bool) -> Vec<Turn> {
    let last = values.len().saturating_sub(1);
    if last < 2 {
        return Vec::new();
    }
    if !goes_round {
        let (mut turns, pending) = walk(values.iter().copied().enumerate(), least);
        for turn in &mut turns {
            turn.is_end = turn.sample == 0;
        }
        turns.extend(pending.filter(|turn| turn.sample == last).map(|turn| Turn {
            is_end: true,
            ..turn
        }));
        return turns;
    }
    // From the highest place round to it again: it is met first, and last without being told again.
    let highest = (0..last)
        .max_by(|&i, &j| values[i].total_cmp(&values[j]))
        .unwrap_or(0);
    let round = (highest..last).chain(0..=highest);
    walk(round.map(|i| (i, values[i])), least).0
}

/// Keeps the highest and the lowest value since the last turn; a value that is `least` away from one
/// makes it a turn. Gives also the turn that is not yet sure.
fn walk(values: impl Iterator<Item = (usize, f64)>, least: f64) -> (Vec<Turn>, Option<Turn>) {
    let mut turns: Vec<Turn> = Vec::new();
    let (mut high, mut low) = ((0, f64::NEG_INFINITY), (0, f64::INFINITY));
    let turn = |sample, is_peak| Turn {
        sample,
        is_peak,
        is_end: false,
    };
    for (i, value) in values {
        if value > high.1 {
            high = (i, value);
        }
        if value < low.1 {
            low = (i, value);
        }
        let seeks_peak = turns.last().is_none_or(|turn| !turn.is_peak);
        let seeks_dip = turns.last().is_none_or(|turn| turn.is_peak);
        if seeks_peak && high.1 - value > least {
            turns.push(turn(high.0, true));
            low = (i, value);
        } else if seeks_dip && value - low.1 > least {
            turns.push(turn(low.0, false));
            high = (i, value);
        }
    }
    let pending = turns.last().map(|last| {
        if last.is_peak {
            turn(low.0, false)
        } else {
            turn(high.0, true)
        }
    });
    (turns, pending)
}

/// So many values are looked at, at the most; a dozen is usual.
const MOST_STEPS: usize = 60;
/// The share of the larger part at which a golden section cuts.
const GOLDEN: f64 = 0.381_966_011_250_105_1;

/// The place between `low` and `high` at which `f` is smallest, and its value there; `first` is a place
/// between with its value, below those of both ends.
///
/// Brent's method without derivatives (Brent 1973, Algorithms for Minimization, chapter 5): parabolas
/// through the best three places, and golden sections where those do not get on. A value is found to
/// its rounding; the place only to about the square root of that, since a smooth figure is level there.
pub(super) fn lowest(
    mut f: impl FnMut(f64) -> Option<f64>,
    [mut low, mut high]: [f64; 2],
    first: (f64, f64),
) -> (f64, f64) {
    let (mut best, mut second, mut third) = (first, first, first);
    let (mut step, mut before) = (0.0_f64, 0.0_f64);
    let finest = f64::EPSILON.sqrt() * (high - low).abs().max(f64::MIN_POSITIVE);
    for _ in 0..MOST_STEPS {
        let middle = 0.5 * (low + high);
        let least = finest.max(4.0 * f64::EPSILON * best.0.abs());
        if (best.0 - middle).abs() <= 2.0 * least - 0.5 * (high - low) {
            break;
        }
        let parabola = vertex(best, second, third).filter(|vertex| {
            let way = vertex - best.0;
            way.abs() < 0.5 * before.abs() && *vertex > low && *vertex < high
        });
        before = step;
        step = match parabola {
            Some(vertex) if vertex - low < 2.0 * least || high - vertex < 2.0 * least => {
                least.copysign(middle - best.0)
            }
            Some(vertex) => vertex - best.0,
            None => {
                before = if best.0 < middle {
                    high - best.0
                } else {
                    low - best.0
                };
                GOLDEN * before
            }
        };
        let place = best.0
            + if step.abs() < least {
                least.copysign(step)
            } else {
                step
            };
        let Some(value) = f(place) else {
            break;
        };
        let tried = (place, value);
        if value <= best.1 {
            *(if place < best.0 { &mut high } else { &mut low }) = best.0;
            (third, second, best) = (second, best, tried);
        } else {
            *(if place < best.0 { &mut low } else { &mut high }) = place;
            if value <= second.1 || second.0 == best.0 {
                (third, second) = (second, tried);
            } else if value <= third.1 || third.0 == best.0 || third.0 == second.0 {
                third = tried;
            }
        }
    }
    best
}

/// Where the parabola through three places is level.
fn vertex(a: (f64, f64), b: (f64, f64), c: (f64, f64)) -> Option<f64> {
    let r = (a.0 - b.0) * (a.1 - c.1);
    let q = (a.0 - c.0) * (a.1 - b.1);
    let p = (a.0 - c.0) * q - (a.0 - b.0) * r;
    let vertex = a.0 - p / (2.0 * (q - r));
    vertex.is_finite().then_some(vertex)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(values: &[f64], goes_round: bool) -> Vec<(usize, bool, bool)> {
        let turns = turns(values, 0.1, goes_round);
        turns
            .iter()
            .map(|t| (t.sample, t.is_peak, t.is_end))
            .collect()
    }

    #[test]
    fn turns_are_told_from_ends_and_from_noise() {
        let values = [0.0, 1.0, 0.95, 1.01, 0.0, 0.5];
        assert_eq!(
            found(&values, false),
            [
                (0, false, true),
                (3, true, false),
                (4, false, false),
                (5, true, true)
            ]
        );
        assert_eq!(found(&[1.0, 1.05, 1.0, 1.02], false), []);
        assert_eq!(found(&[2.0, 1.0], false), []);
    }

    #[test]
    fn where_values_go_round_the_ends_are_no_ends() {
        let round = |k: i32| (f64::from(k) * std::f64::consts::TAU / 12.0).cos();
        let values: Vec<f64> = (0..=12).map(round).collect();
        assert_eq!(found(&values, true), [(0, true, false), (6, false, false)]);
        let shifted: Vec<f64> = (3..=15).map(round).collect();
        assert_eq!(found(&shifted, true), [(9, true, false), (3, false, false)]);
    }

    #[test]
    fn extrema_of_known_functions_are_found_to_what_is_promised() {
        // The cosine at pi, and a quartic, which is level for longer.
        let around = |f: fn(f64) -> f64, low: f64, at: f64, high: f64| {
            let mut count = 0;
            let counted = |x| {
                count += 1;
                Some(f(x))
            };
            (lowest(counted, [low, high], (at, f(at))), count)
        };
        let ((place, value), count) = around(f64::cos, 3.0, 3.1, 3.3);
        assert!((place - std::f64::consts::PI).abs() < 3e-8, "{place}");
        assert!(
            (value + 1.0).abs() < 1e-15 && count <= 15,
            "{value} {count}"
        );
        let ((place, value), _) = around(|x| (x - 0.3_f64).powi(4), -1.0, 0.2, 1.0);
        assert!(
            (place - 0.3).abs() < 1e-3 && value < 1e-12,
            "{place} {value}"
        );
        // A corner, and a function that does not exist everywhere.
        let ((place, _), _) = around(|x| (x - 0.7_f64).abs(), 0.0, 0.5, 1.0);
        assert!((place - 0.7).abs() < 1e-7, "{place}");
        assert_eq!(lowest(|_| None, [0.0, 1.0], (0.4, 2.0)), (0.4, 2.0));
    }
}
