//! Approximates the driving torque over a cycle piece by piece.
//!
//! The cycle is cut where a load has a kink or jumps, and then bisected until a sum of Chebyshev
//! polynomials represents the solution on every piece. All other results - integrals, zeros, peaks -
//! are computed from the sums.

use super::cycle_travel::{CyclePath, PathPosition};
use super::{CHANNELS, DriverUnits, Effort};
use crate::numeric::chebyshev::{Basis, ChebyshevSum, TERMS};

/// A part of the travel on which all channels are smooth.
#[derive(Clone, Copy, Debug)]
pub(super) struct SmoothPiece {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) sums: [ChebyshevSum; CHANNELS],
}

/// All pieces of a cycle, in the order of the travel.
#[derive(Clone, Debug, Default)]
pub(super) struct Pieces {
    pub(super) list: Vec<SmoothPiece>,
    /// The size of each channel: its largest coefficient.
    pub(super) scale: [f64; CHANNELS],
    /// The error of each integral, relative to size times travel.
    pub(super) error: [f64; CHANNELS],
    /// `true` if there is a place without a solution, so that the results do not exist.
    pub(super) has_gap: bool,
    /// The number of solved states.
    pub(super) states: usize,
    measure: DriverUnits,
}

/// Number of pieces at the beginning: an eighth of a turn suffices for most linkages.
const PARTS: f64 = 8.0;
/// The size of the last coefficients, relative to the channel, below which a sum is as accurate as
/// its function.
const MAX_LAST_TERM: f64 = 1e-13;
/// A sum with last coefficients below `SUFFICIENT_COEFFICIENT` suffices if the piece is so short that the error of
/// the integral is below `SHORT`.
const SUFFICIENT_COEFFICIENT: f64 = 1e-9;
const SHORT: f64 = 1e-13;
/// Minimum scale of a channel relative to all others.
const MIN_VALUE: f64 = 1e-2;
/// The size below which a channel is a rounding error, relative to its scale: 1e-11 of all others.
const NOTHING: f64 = 1e-9;
/// The factor on both tolerances between dead points. Values lose digits towards a dead point, the
/// more the closer they are.
const DEAD: f64 = 100.0;
/// Maximum bisections towards a place without a solution.
const MAX_SEARCHES: u32 = 12;
/// Maximum bisections of a piece, and of one whose last coefficients are rounding errors; waves 16
/// times shorter would still be found.
const MAX_HALVINGS: u32 = 30;
const FLAT_HALVINGS: u32 = 4;
/// Maximum number of pieces: a bound on the work for functions that are not smooth.
const MAX_PIECES: usize = 1000;

/// Solves at places of the cycle.
pub(super) struct Sampler<'a> {
    pub(super) course: CyclePath,
    pub(super) basis: Basis,
    pub(super) measure: DriverUnits,
    pub(super) effort: &'a mut dyn FnMut(f64, bool) -> Option<Effort>,
}

impl Sampler<'_> {
    /// Returns the integrands at this travel: torques times the derivative of the coordinate, and
    /// the force on the ground. Returns `None` if one is not finite.
    pub(super) fn channels(&mut self, travel: f64) -> Option<[f64; CHANNELS]> {
        let PathPosition { at, back, weight } = self.course.place(travel);
        let mut channels = (self.effort)(at, back)?.channels();
        channels[..super::TORQUES]
            .iter_mut()
            .for_each(|c| *c *= weight);
        channels.iter().all(|c| c.is_finite()).then_some(channels)
    }

    fn piece(&mut self, from: f64, to: f64) -> Option<SmoothPiece> {
        let mut values = [[0.0; TERMS]; CHANNELS];
        for j in 0..TERMS {
            let travel = from + (to - from) * 0.5 * (1.0 + self.basis.places[j]);
            for (values, value) in values.iter_mut().zip(self.channels(travel)?) {
                values[j] = value;
            }
        }
        let sums = values.map(|values| self.basis.through(&values));
        Some(SmoothPiece { from, to, sums })
    }
}

impl Pieces {
    /// Cuts the travel at `marks`, which are sorted and inside it.
    pub(super) fn cut(sampler: &mut Sampler, marks: &[f64]) -> Pieces {
        let length = sampler.course.length();
        let mut pieces = Pieces {
            measure: sampler.measure,
            ..Pieces::default()
        };
        let mut waiting: Vec<(Option<SmoothPiece>, f64, f64, u32, u32)> = Vec::new();
        let mut from = 0.0;
        for &to in marks.iter().chain(&[length]) {
            let parts = ((to - from) / length * PARTS).ceil().max(1.0);
            let mut part = from;
            let mut k = 0.0;
            while k < parts && to > from {
                k += 1.0;
                let end = if k < parts {
                    from + (to - from) * k / parts
                } else {
                    to
                };
                let piece = pieces.solve(sampler, part, end);
                waiting.push((piece, part, end, 0, 0));
                part = end;
            }
            from = from.max(to);
        }
        // A stack with the first piece on top.
        waiting.reverse();
        while let Some((piece, from, to, halvings, flat)) = waiting.pop() {
            let middle = 0.5 * (from + to);
            let spent = halvings >= MAX_HALVINGS
                || pieces.list.len() + waiting.len() >= MAX_PIECES
                || !(from < middle && middle < to);
            let allowance = if sampler.course.ends_at_dead_point {
                DEAD
            } else {
                1.0
            };
            let is_good = |piece: SmoothPiece| pieces.is_resolved(&piece, length, flat, allowance);
            let good = piece.is_some_and(is_good);
            match piece {
                Some(piece) if good || spent => pieces.keep(piece, length),
                None if spent || halvings >= MAX_SEARCHES => {
                    pieces.has_gap = true;
                    break;
                }
                _ => {
                    let is_flat = |p: SmoothPiece| pieces.rough(&p).all(|(_, sum)| sum.is_flat());
                    let flat = if piece.is_some_and(is_flat) {
                        flat + 1
                    } else {
                        0
                    };
                    let halves = [(from, middle), (middle, to)];
                    let halves = halves
                        .map(|(a, b)| (pieces.solve(sampler, a, b), a, b, halvings + 1, flat));
                    waiting.extend(halves.into_iter().rev());
                }
            }
        }
        pieces
    }

    fn solve(&mut self, sampler: &mut Sampler, from: f64, to: f64) -> Option<SmoothPiece> {
        self.states += TERMS;
        let piece = sampler.piece(from, to)?;
        for (scale, sum) in self.scale.iter_mut().zip(&piece.sums) {
            *scale = scale.max(sum.size());
        }
        Some(piece)
    }

    /// Returns the scale of a channel's errors. If large forces cancel, rounding errors remain, so
    /// the scale is at least a fraction of all other channels, each divided by its arm.
    pub(super) fn size(&self, channel: usize) -> f64 {
        let forces = self
            .scale
            .iter()
            .enumerate()
            .map(|(i, scale)| scale / self.arm(i));
        let all = forces.fold(0.0, f64::max);
        self.scale[channel].max(MIN_VALUE * all * self.arm(channel))
    }

    /// Returns `true` if a channel consists of the rounding errors of the others.
    pub(super) fn is_nothing(&self, channel: usize) -> bool {
        self.scale[channel] <= NOTHING * self.size(channel)
    }

    /// Returns the lever arm in m that relates a channel to a force; 1 for a force.
    fn arm(&self, channel: usize) -> f64 {
        match channel {
            super::MOMENT => self.measure.reach,
            _ if channel < super::TORQUES => self.measure.arm,
            _ => 1.0,
        }
    }

    /// Returns the sums that do not yet represent their functions.
    fn rough<'a>(
        &'a self,
        piece: &'a SmoothPiece,
    ) -> impl Iterator<Item = (usize, &'a ChebyshevSum)> {
        let sums = piece.sums.iter().enumerate();
        sums.filter(|(channel, sum)| sum.tail() > MAX_LAST_TERM * self.size(*channel))
    }

    fn is_resolved(&self, piece: &SmoothPiece, length: f64, flat: u32, allowance: f64) -> bool {
        let share = (piece.to - piece.from) / length;
        self.rough(piece).all(|(channel, sum)| {
            let (tail, size) = (sum.tail(), allowance * self.size(channel));
            let is_short = tail <= SUFFICIENT_COEFFICIENT * size && tail * share <= SHORT * size;
            is_short || (flat >= FLAT_HALVINGS && sum.is_flat())
        })
    }

    fn keep(&mut self, piece: SmoothPiece, length: f64) {
        let share = (piece.to - piece.from) / length;
        for channel in 0..CHANNELS {
            let size = self.size(channel);
            if size > 0.0 {
                self.error[channel] += piece.sums[channel].tail() * share / size;
            }
        }
        self.list.push(piece);
    }

    /// Returns the channels after this travel, from the sums.
    pub(super) fn at(&self, travel: f64) -> Option<[f64; CHANNELS]> {
        let after = self.list.partition_point(|piece| piece.to < travel);
        let piece = self.list.get(after).filter(|piece| piece.from <= travel)?;
        Some(piece.sums.map(|sum| sum.at(piece.t(travel))))
    }
}

impl SmoothPiece {
    /// Returns the travel at t in [-1, 1].
    pub(super) fn way(&self, t: f64) -> f64 {
        self.from + (self.to - self.from) * 0.5 * (1.0 + t)
    }

    pub(super) fn t(&self, travel: f64) -> f64 {
        2.0 * (travel - self.from) / (self.to - self.from) - 1.0
    }

    /// Returns the factor from an integral over t to one over the travel.
    pub(super) fn half(&self) -> f64 {
        0.5 * (self.to - self.from)
    }
}
