//! Planted linkages are among what is found.

use super::{FunctionRun, chebyshev_pairs, propose};
use crate::numeric::SeededChance;
use crate::synthesis::{FunctionTask, Given, Output, Partner, Proposal, Proposals};

/// A linkage that is planted, with its crank's angles in degrees and its output at every one: angles, or travels.
struct Planted {
    output: Output,
    lengths: [f64; 3],
    pairs: Vec<[f64; 2]>,
}

/// Datums and scales: the pairs are `(angle - datum) / scale`.
#[derive(Clone, Copy)]
struct Law([f64; 4]);

const PLAIN: Law = Law([0.0, 1.0, 0.0, 1.0]);
const LAW: Law = Law([20.0, 40.0, -35.0, 25.0]);

impl Planted {
    /// At so many angles over a swing, where it closes; by the circles' own formula, which the room does not use.
    fn draw(chance: &mut SeededChance, output: Output, count: usize) -> Planted {
        loop {
            let mut length = |low: f64, high: f64| low + (high - low) * 0.5 * (1.0 + chance.even());
            let (a, b) = (length(0.3, 1.6), length(0.5, 2.0));
            let c = match output {
                Output::Angle => length(0.4, 1.8),
                Output::Slide => length(-0.8, 0.8),
            };
            let a = if output == Output::Slide { 1.0 } else { a };
            let (start, swing) = (length(-180.0, 180.0), length(60.0, 220.0));
            let side = if length(-1.0, 1.0) < 0.0 { -1.0 } else { 1.0 };
            let angles = (0..count).map(|k| start + swing * k as f64 / (count - 1) as f64);
            let pairs: Option<Vec<[f64; 2]>> = angles
                .map(|angle| Some([angle, output_of(output, [a, b, c], angle, side)?]))
                .collect();
            let Some(mut pairs) = pairs else { continue };
            if output == Output::Angle {
                for k in 1..count {
                    let turns = ((pairs[k - 1][1] - pairs[k][1]) / 360.0).round();
                    pairs[k][1] += 360.0 * turns;
                }
            }
            return Planted { output, lengths: [a, b, c], pairs };
        }
    }

    fn task(&self, law: Law, free: [bool; 4]) -> FunctionTask {
        let Law([a, b, c, d]) = law;
        let given = |i: usize| if free[i] { Given::Free } else { Given::Value(law.0[i]) };
        let pair = |[x, y]: &[f64; 2]| [(x - a) / b, (y - c) / d];
        FunctionTask {
            pairs: self.pairs.iter().map(pair).collect(),
            output: self.output,
            crank_datum: given(0),
            crank_scale: given(1),
            output_datum: given(2),
            output_scale: given(3),
            size: 1.0,
        }
    }

    /// How far the nearest proposal's lengths are from the planted ones.
    fn nearest(&self, proposals: &Proposals) -> f64 {
        let apart = |proposal: &Proposal| {
            let (a, b, c) = proposal.lengths().unwrap();
            let third = c.unwrap_or_else(|| proposal.places[0][1].y.abs());
            let [p, q, r] = self.lengths;
            [(a, p), (b, q), (third, r.abs())]
                .iter()
                .fold(0.0_f64, |most, (x, y)| most.max((x - y).abs()))
        };
        proposals.found.iter().map(apart).fold(f64::INFINITY, f64::min)
    }
}

fn output_of(output: Output, [a, b, c]: [f64; 3], angle: f64, side: f64) -> Option<f64> {
    let (sin, cos) = angle.to_radians().sin_cos();
    let (x, y) = (a * cos, a * sin);
    match output {
        Output::Angle => {
            let (dx, dy) = (x - 1.0, y);
            let d = dx.hypot(dy);
            // Along D-B, then across.
            let along = (d * d + c * c - b * b) / (2.0 * d);
            let h2 = c * c - along * along;
            (h2 > 0.01).then(|| {
                let h = side * h2.sqrt();
                let (px, py) = ((along * dx - h * dy) / d, (along * dy + h * dx) / d);
                py.atan2(px).to_degrees()
            })
        }
        Output::Slide => {
            let h2 = b * b - (c - y) * (c - y);
            (h2 > 0.01).then(|| x + side * h2.sqrt())
        }
    }
}

/// Plants so many, and says how many are recovered to 1e-9 and how many to 1e-6.
fn recovered(output: Output, count: usize, free: [bool; 4], rounds: u32) -> [u32; 3] {
    let mut chance = SeededChance::new(u64::from(rounds) + count as u64);
    let mut found = [0; 3];
    for _ in 0..rounds {
        let planted = Planted::draw(&mut chance, output, count);
        let law = if free == [false; 4] { PLAIN } else { LAW };
        let law = match output {
            Output::Angle => law,
            Output::Slide => Law([law.0[0], law.0[1], 0.3, 0.7]),
        };
        let proposals = propose(&planted.task(law, free));
        let apart = planted.nearest(&proposals);
        if apart > 1e-9 { println!("  missed {:?} {:?} best {apart}, {} found", planted.lengths, planted.pairs, proposals.found.len()); }
        found[0] += u32::from(apart < 1e-9);
        found[1] += u32::from(apart < 1e-6);
        found[2] += u32::from(proposals.is_complete);
    }
    found
}

#[test]
fn measure() {
    let t = true;
    let f = false;
    for (output, count, free) in [
        (Output::Angle, 3, [f, f, f, f]),
        (Output::Angle, 4, [t, f, f, f]),
        (Output::Angle, 4, [f, f, t, f]),
        (Output::Angle, 5, [t, f, t, f]),
        (Output::Slide, 3, [f, f, t, f]),
        (Output::Slide, 3, [f, f, f, t]),
        (Output::Slide, 4, [f, f, t, t]),
        (Output::Slide, 3, [t, f, f, f]),
        (Output::Slide, 4, [t, f, t, f]),
        (Output::Slide, 5, [t, f, t, t]),
    ] {
        let begin = std::time::Instant::now();
        let found = recovered(output, count, free, 200);
        println!("{output:?} {count} {free:?} {found:?} of 200 {:?}", begin.elapsed());
    }
    for (output, count, free) in [
        (Output::Angle, 5, [f, f, f, f]),
        (Output::Angle, 9, [t, f, t, f]),
        (Output::Angle, 6, [t, t, t, f]),
        (Output::Angle, 6, [t, f, t, t]),
        (Output::Angle, 7, [t, t, t, t]),
        (Output::Angle, 12, [t, t, t, t]),
        (Output::Slide, 6, [t, t, t, t]),
        (Output::Slide, 9, [t, t, t, t]),

    ] {
        let begin = std::time::Instant::now();
        let found = recovered(output, count, free, 20);
        println!("{output:?} {count} {free:?} {found:?} of 20 {:?}", begin.elapsed());
    }
}
