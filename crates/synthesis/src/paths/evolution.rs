//! Differential evolution (Storn and Price, 1997) over the nonlinear unknowns.
//!
//! These are ratios of lengths, the crank's first angle, and, if times are free, how far and how
//! unevenly the crank turns.

use super::linear::Projection;
use super::shape::{LinkageForm, LinkageShape};
use super::task::{GivenPivots, PathPart, TargetPath};
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
const PREFERENCE_PENALTY: f64 = 0.1;

/// The kind of linkage for which a start searches.
#[derive(Clone, Copy, Debug)]
pub(super) struct SearchTarget {
    pub(super) form: LinkageForm,
    pub(super) held: GivenPivots,
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
    score: f64,
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
fn ends(target: &SearchTarget, goal: &TargetPath) -> [[f64; 2]; GENES] {
    let free = goal.turns.is_none();
    let (crank, far, ground) = match target.form {
        LinkageForm::FourBar => ([-2.3, 1.6], [-1.6, 1.6], [-1.9, 1.6]),
        LinkageForm::SliderCrank => ([-3.0, 1.6], [-2.5, 2.5], [0.0, 0.0]),
    };
    let turn = if free && !goal.closed {
        [25.0, 345.0]
    } else {
        [360.0, 360.0]
    };
    let uneven = if free { [-0.7, 0.7] } else { [0.0, 0.0] };
    [crank, far, ground, [-180.0, 180.0], turn, uneven, uneven]
}

/// The search of one start.
pub(super) struct Evolution<'a> {
    wanted: &'a TargetPath,
    target: SearchTarget,
    ends: [[f64; 2]; GENES],
    /// The bounds of every gene; the first angle has none.
    bounds: [Option<[f64; 2]>; GENES],
    rng: SeededRng,
    /// The minimum and maximum of the given turns, in degrees.
    turns: Option<[f64; 2]>,
}

impl<'a> Evolution<'a> {
    pub(super) fn new(goal: &'a TargetPath, target: SearchTarget, seed: u64) -> Evolution<'a> {
        let turns = goal.turns.as_ref().map(|turns| {
            let minimum = turns.iter().copied().fold(f64::INFINITY, f64::min);
            [
                minimum,
                turns.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            ]
        });
        let ends = ends(&target, goal);
        let mut bounds = ends.map(Some);
        bounds[FIRST_ANGLE] = None;
        Evolution {
            wanted: goal,
            target,
            ends,
            bounds,
            rng: SeededRng::new(seed),
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
                .min_by(|a, b| a.score.total_cmp(&b.score));
            if best.is_none_or(|best| best.score < MET) {
                break;
            }
            let best = best.as_ref().map(AsRef::as_ref);
            for i in 0..all.len() {
                let trial = self.trial(&all, i, best);
                if trial.score <= all[i].score {
                    all[i] = trial;
                }
            }
        }
        all.sort_by(|a, b| a.score.total_cmp(&b.score));
        all
    }

    /// Draws a random design, if possible one whose links close.
    fn draw(&mut self) -> Raw {
        let mut drawn = self.drawn();
        for _ in 0..DRAWS {
            if self.shortfall(&drawn) == 0.0 {
                break;
            }
            drawn = self.drawn();
        }
        self.measure_cost(&mut drawn);
        drawn
    }

    fn drawn(&mut self) -> Raw {
        let rng = &mut self.rng;
        let genes = self
            .ends
            .map(|[low, high]| 0.5 * (low + high) + 0.5 * (high - low) * rng.even());
        self.raw(genes)
    }

    fn raw(&self, genes: Genes) -> Raw {
        let four_bar = self.target.form == LinkageForm::FourBar;
        Raw {
            shape: LinkageShape {
                form: self.target.form,
                sign: self.target.sign,
                crank: genes[0].exp(),
                far: if four_bar { genes[1].exp() } else { genes[1] },
                ground: if four_bar { genes[2].exp() } else { 0.0 },
            },
            genes,
            turn: self.target.sense * genes[4],
            score: f64::INFINITY,
        }
    }

    /// Returns the first and the last crank angle, in degrees.
    fn span(&self, raw: &Raw) -> [f64; 2] {
        let start = raw.genes[FIRST_ANGLE];
        match self.turns {
            Some([minimum, maximum]) => [start + minimum, start + maximum],
            None => [start.min(start + raw.turn), start.max(start + raw.turn)],
        }
    }

    /// Returns by how much the links are too short over the task.
    fn shortfall(&self, raw: &Raw) -> f64 {
        let [low, high] = self.span(raw);
        raw.shape.worst_between(low, high).0
    }

    /// Rates a design by its misses and by penalties for violated conditions.
    fn measure_cost(&self, raw: &mut Raw) {
        let [low, high] = self.span(raw);
        let (short, sine) = raw.shape.worst_between(low, high);
        let target = self.wanted;
        let angles = target
            .along
            .iter()
            .enumerate()
            .map(|(j, along)| raw.angle(along, target.turns.as_ref().map(|turns| turns[j])));
        let found = Projection::of(target, self.target.held, &raw.shape, angles);
        let flat = (1.0 - sine / FLAT).max(0.0);
        let lack = match self.target.is_wished {
            true => target
                .preferences
                .violation(&raw.shape, &found.place, [low, high]),
            false => 0.0,
        };
        let score = found.square
            + PREFERENCE_PENALTY * lack
            + SHORT * (short + found.short / target.points.len() as f64)
            + FLAT_COUNTS * found.square.sqrt() * flat * flat;
        raw.score = if score.is_finite() {
            score
        } else {
            f64::INFINITY
        };
    }

    /// Creates a trial for a design of a generation.
    fn trial(&mut self, all: &[Raw], of: usize, best: Option<&[f64]>) -> Raw {
        let mut genes = all[of].genes;
        mutate(&mut genes, all, best, &self.bounds, &mut self.rng);
        let mut trial = self.raw(genes);
        self.measure_cost(&mut trial);
        trial
    }
}
