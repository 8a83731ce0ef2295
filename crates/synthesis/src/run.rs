//! Runs a synthesis: proposes linkages for a task and evaluates them.

use super::candidate::Candidate;
use super::functions::FunctionSearch;
use super::poses::PoseReach;
use super::{
    OpenReason, PathSearch, PathTask, PoseTask, PosedDyad, Proposal, Proposals, Task, TaskKind,
    poses,
};
use kinematics::parallel;
use std::cmp::Ordering;

/// Settings of a synthesis run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SynthesisSettings {
    /// The seed of the random numbers, for searches from many starts.
    pub seed: u64,
    /// The number of threads.
    pub threads: usize,
}

impl SynthesisSettings {
    /// The default seed.
    pub const DEFAULT_SEED: u64 = 1;
}

/// The result of a synthesis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Synthesis {
    /// The candidates that do the task, best first; those that meet every preference come before
    /// the others.
    pub good: Vec<Candidate>,
    /// The candidates that do not, each with its defects.
    pub defective: Vec<Candidate>,
    /// `true` if there are no other linkages.
    pub is_complete: bool,
    /// The reason why there are no linkages, or why there may be others.
    pub reason: Option<OpenReason>,
    /// For four poses, the pieces of the curves on which every pivot and its pin lie.
    pub curves: Vec<Vec<PosedDyad>>,
}

impl Synthesis {
    /// Proposes linkages, drives them through the task and evaluates them.
    ///
    /// `watch` receives the completed part, and stops a search by returning `false`; the linkages
    /// found until then are evaluated.
    #[must_use]
    pub fn run(
        task: &Task,
        order: SynthesisSettings,
        watch: &mut dyn FnMut(f64) -> bool,
    ) -> Synthesis {
        let proposals = match &task.kind {
            TaskKind::Poses(poses) => {
                let found = Synthesis::through(task, poses, order.threads);
                watch(1.0);
                return found;
            }
            TaskKind::Function(function) => {
                let threads = order.threads;
                let search = FunctionSearch {
                    task: function,
                    threads,
                };
                search.run(watch)
            }
            TaskKind::Path(path) => {
                let search = PathSearch {
                    task: path,
                    four_bars: task.four_bars,
                    slider_cranks: task.slider_cranks,
                    preferences: task.preferences,
                    seed: order.seed,
                    threads: order.threads,
                    starts: PathSearch::STARTS,
                };
                with_cognates(path, search.run(watch))
            }
        };
        let found = Synthesis::of(task, proposals, order.threads);
        watch(1.0);
        found
    }

    /// Solves a task of poses. If the linkages are a selection and none within the usual reach does
    /// the task, a wider reach is tried.
    fn through(task: &Task, poses: &PoseTask, threads: usize) -> Synthesis {
        let propose = |reach| {
            let inside = task.preferences.inside;
            poses::propose(poses, task.four_bars, task.slider_cranks, inside, reach)
        };
        let found = Synthesis::of(task, propose(PoseReach::Usual), threads);
        if !found.good.is_empty() || found.is_complete {
            return found;
        }
        let wider = Synthesis::of(task, propose(PoseReach::Wide), threads);
        match wider.good.is_empty() && !found.defective.is_empty() {
            true => found,
            false => wider,
        }
    }

    /// Evaluates all proposals and sorts the distinct candidates, best first.
    #[must_use]
    pub fn of(task: &Task, proposals: Proposals, threads: usize) -> Synthesis {
        let judged = evaluate_all(task, &proposals.found, threads);
        let mut kept: Vec<Candidate> = Vec::new();
        let mut order: Vec<Candidate> = judged;
        order.sort_by(|one, other| better(task, one, other));
        for candidate in order {
            if !kept.iter().any(|before| before.is_same(&candidate)) {
                kept.push(candidate);
            }
        }
        let (good, defective) = kept.into_iter().partition(Candidate::meets_task);
        Synthesis {
            good,
            defective,
            is_complete: proposals.is_complete,
            reason: proposals.reason,
            curves: proposals.curves,
        }
    }

    /// Inserts a candidate in order and returns its index; defective candidates are counted after
    /// the others. Returns the index of the same candidate if it is already present.
    pub fn add(&mut self, task: &Task, candidate: Candidate) -> usize {
        let all = self.good.iter().chain(&self.defective);
        if let Some(index) = all.into_iter().position(|known| known.is_same(&candidate)) {
            return index;
        }
        let (kind, before) = match candidate.meets_task() {
            true => (&mut self.good, 0),
            false => {
                let good = self.good.len();
                (&mut self.defective, good)
            }
        };
        let is_better = |known: &Candidate| better(task, known, &candidate).is_le();
        let index = kind.partition_point(is_better);
        kind.insert(index, candidate);
        before + index
    }
}

/// Adds, after each linkage, its cognates, which guide the same point along the same curve.
///
/// If the crank's turns are given, only the cognate that keeps them is added. With given
/// pivots, cognates are left out, since they have other pivots.
fn with_cognates(path: &PathTask, proposals: Proposals) -> Proposals {
    let mut found = Vec::new();
    for one in &proposals.found {
        let cognates = one.cognates();
        let first = match (path.pivots.is_empty(), &path.turns) {
            (false, _) => cognates.len(),
            (true, Some(_)) => cognates.len().saturating_sub(1),
            (true, None) => 0,
        };
        found.push(one.clone());
        found.extend_from_slice(&cognates[first..]);
    }
    Proposals { found, ..proposals }
}

/// Evaluates all proposals on several cores, in their order.
fn evaluate_all(task: &Task, proposals: &[Proposal], threads: usize) -> Vec<Candidate> {
    let judge = |(): &mut (), i: usize| Candidate::evaluate(task, &proposals[i]);
    parallel::each(proposals.len(), threads, || (), judge, &mut |_| true)
}

/// Compares candidates: fewer defects first, then fewer unmet preferences, then the smaller miss
/// above rounding, then the larger transmission angle. The miss is the root mean square if the points
/// of a path have weights.
fn better(task: &Task, one: &Candidate, other: &Candidate) -> Ordering {
    let count = |c: &Candidate| (c.defects.len(), c.missed.len());
    let floor = 1e-9 * task.size();
    let is_weighted = matches!(&task.kind, TaskKind::Path(path) if !path.weights.is_empty());
    let miss = |c: &Candidate| match is_weighted {
        true => c.figures.rms.max(floor),
        false => c.figures.miss.max(floor),
    };
    count(one)
        .cmp(&count(other))
        .then(miss(one).total_cmp(&miss(other)))
        .then(
            other
                .figures
                .transmission
                .total_cmp(&one.figures.transmission),
        )
}
