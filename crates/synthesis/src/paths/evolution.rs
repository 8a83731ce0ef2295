//! Differential evolution (Storn and Price, 1997) over the nonlinear unknowns.
//!
//! These are ratios of lengths, the crank's first angle, and, if times are free, how far and how
//! unevenly the crank turns.

use super::linear::Projection;
use super::shape::{LinkageForm, LinkageShape};
use super::wanted::{HeldPivots, PathPart, WantedPath};
use kinematics::numeric::{SeededRng, mutate};

/// Maximum number of genes: three ratios, the first angle, the whole turn, and two for its
/// unevenness.
const GENES: usize = 7;
const FIRST_ANGLE: usize = 3;
/// Number of designs in a generation, and maximum number of generations.
const DESIGNS: usize = 36;
const GENERATIONS: usize = 50;
/// Maximum number of draws for a design whose links close.
const DRAWS: usize = 30;
/// Mean square at which the evolution stops: the descent does the rest.
const MET: f64 = 1e-7;
/// Penalty for links that are too short by the coupler's length, in mean squares of the path's
/// size.
const SHORT: f64 = 1.0;
/// Sine of the transmission angle below which a design is penalised, and the factor of the penalty
/// at a dead point.
const FLAT: f64 = 0.25;
const FLAT_COUNTS: f64 = 1e-3;

/// Penalty per unit of violated preferences, in mean squares of the path's size.
const LACKING: f64 = 0.1;

/// The kind of linkage for which a start searches.
#[derive(Clone, Copy, Debug)]
pub(super) struct SearchTarget {
    pub(super) form: LinkageForm,
    pub(super) held: HeldPivots,
    /// The sign of the assembly, 1 or -1.
    pub(super) sign: f64,
    /// The sense in which the crank turns if times are free: 1 or -1.
    pub(super) sense: f64,
    /// Whether the linkage should meet the preferences.
    pub(super) is_wished: bool,
}

type Genes = [f64; GENES];

/// A linkage of a generation, without its placement.
#[derive(Clone, Copy, Debug)]
pub(super) struct Raw {
    pub(super) shape: LinkageShape,
    genes: Genes,
    turn: f64,
    worth: f64,
}

impl AsRef<[f64]> for Raw {
    fn as_ref(&self) -> &[f64] {
        &self.genes
    }
}

impl Raw {
    /// Returns the crank's angle at a point, in degrees.
    #[inline]
    pub(super) fn angle(&self, along: &PathPart, turned: Option<f64>) -> f64 {
        let start = self.genes[FIRST_ANGLE];
        match turned {
            Some(turned) => start + turned,
            None => {
                let uneven = self.genes[5] * along.uneven[0] + self.genes[6] * along.uneven[1];
                start + self.turn * (along.part + uneven)
            }
        }
    }
}

/// Returns the range of every gene. The first three belong to the crank, the far length and the
/// ground, by their logarithms.
fn ends(quarry: &SearchTarget, wanted: &WantedPath) -> [[f64; 2]; GENES] {
    let free = wanted.turns.is_none();
    let (crank, far, ground) = match quarry.form {
        LinkageForm::FourBar => ([-2.3, 1.6], [-1.6, 1.6], [-1.9, 1.6]),
        LinkageForm::SliderCrank => ([-3.0, 1.6], [-2.5, 2.5], [0.0, 0.0]),
    };
    let turn = if free && !wanted.closed {
        [25.0, 345.0]
    } else {
        [360.0, 360.0]
    };
    let uneven = if free { [-0.7, 0.7] } else { [0.0, 0.0] };
    [crank, far, ground, [-180.0, 180.0], turn, uneven, uneven]
}

/// The search of one start.
pub(super) struct Evolution<'a> {
    wanted: &'a WantedPath,
    quarry: SearchTarget,
    ends: [[f64; 2]; GENES],
    /// The bounds of every gene; the first angle has none.
    bounds: [Option<[f64; 2]>; GENES],
    chance: SeededRng,
    /// The minimum and maximum of the given turns, in degrees.
    turns: Option<[f64; 2]>,
}

impl<'a> Evolution<'a> {
    pub(super) fn new(wanted: &'a WantedPath, quarry: SearchTarget, seed: u64) -> Evolution<'a> {
        let turns = wanted.turns.as_ref().map(|turns| {
            let least = turns.iter().copied().fold(f64::INFINITY, f64::min);
            [
                least,
                turns.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            ]
        });
        let ends = ends(&quarry, wanted);
        let mut bounds = ends.map(Some);
        bounds[FIRST_ANGLE] = None;
        Evolution {
            wanted,
            quarry,
            ends,
            bounds,
            chance: SeededRng::new(seed),
            turns,
        }
    }

    /// Returns the last generation, best first.
    pub(super) fn run(mut self) -> Vec<Raw> {
        let mut all: Vec<Raw> = (0..DESIGNS).map(|_| self.draw()).collect();
        for _ in 0..GENERATIONS {
            let best = all
                .iter()
                .copied()
                .min_by(|a, b| a.worth.total_cmp(&b.worth));
            if best.is_none_or(|best| best.worth < MET) {
                break;
            }
            let best = best.as_ref().map(AsRef::as_ref);
            for i in 0..all.len() {
                let trial = self.trial(&all, i, best);
                if trial.worth <= all[i].worth {
                    all[i] = trial;
                }
            }
        }
        all.sort_by(|a, b| a.worth.total_cmp(&b.worth));
        all
    }

    /// Draws a random design, if possible one whose links close.
    fn draw(&mut self) -> Raw {
        let mut drawn = self.drawn();
        for _ in 0..DRAWS {
            if self.short(&drawn) == 0.0 {
                break;
            }
            drawn = self.drawn();
        }
        self.weigh(&mut drawn);
        drawn
    }

    fn drawn(&mut self) -> Raw {
        let chance = &mut self.chance;
        let genes = self
            .ends
            .map(|[low, high]| 0.5 * (low + high) + 0.5 * (high - low) * chance.even());
        self.raw(genes)
    }

    fn raw(&self, genes: Genes) -> Raw {
        let four_bar = self.quarry.form == LinkageForm::FourBar;
        Raw {
            shape: LinkageShape {
                form: self.quarry.form,
                sign: self.quarry.sign,
                crank: genes[0].exp(),
                far: if four_bar { genes[1].exp() } else { genes[1] },
                ground: if four_bar { genes[2].exp() } else { 0.0 },
            },
            genes,
            turn: self.quarry.sense * genes[4],
            worth: f64::INFINITY,
        }
    }

    /// Returns the first and the last crank angle, in degrees.
    fn span(&self, raw: &Raw) -> [f64; 2] {
        let start = raw.genes[FIRST_ANGLE];
        match self.turns {
            Some([least, most]) => [start + least, start + most],
            None => [start.min(start + raw.turn), start.max(start + raw.turn)],
        }
    }

    /// Returns by how much the links are too short over the task.
    fn short(&self, raw: &Raw) -> f64 {
        let [low, high] = self.span(raw);
        raw.shape.worst_between(low, high).0
    }

    /// Rates a design by its misses and by penalties for violated conditions.
    fn weigh(&self, raw: &mut Raw) {
        let [low, high] = self.span(raw);
        let (short, sine) = raw.shape.worst_between(low, high);
        let wanted = self.wanted;
        let angles = wanted
            .along
            .iter()
            .enumerate()
            .map(|(j, along)| raw.angle(along, wanted.turns.as_ref().map(|turns| turns[j])));
        let found = Projection::of(wanted, self.quarry.held, &raw.shape, angles);
        let flat = (1.0 - sine / FLAT).max(0.0);
        let lack = match self.quarry.is_wished {
            true => wanted.wishes.lack(&raw.shape, &found.place, [low, high]),
            false => 0.0,
        };
        let worth = found.square
            + LACKING * lack
            + SHORT * (short + found.short / wanted.points.len() as f64)
            + FLAT_COUNTS * found.square.sqrt() * flat * flat;
        raw.worth = if worth.is_finite() {
            worth
        } else {
            f64::INFINITY
        };
    }

    /// Creates a trial for a design of a generation.
    fn trial(&mut self, all: &[Raw], of: usize, best: Option<&[f64]>) -> Raw {
        let mut genes = all[of].genes;
        mutate(&mut genes, all, best, &self.bounds, &mut self.chance);
        let mut trial = self.raw(genes);
        self.weigh(&mut trial);
        trial
    }
}
