//! A task, all that a method proposes, and what of it does the task.

use super::candidate::Candidate;
use super::functions::FunctionSearch;
use super::poses::PoseReach;
use super::{
    OpenReason, PathSearch, PathTask, PoseTask, PosedDyad, Proposal, Proposals, Task, TaskKind,
    poses,
};
use kinematics::parallel;
use std::cmp::Ordering;

/// How a synthesis is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SynthesisOrder {
    /// From which chance follows, where a search begins at many places.
    pub seed: u64,
    /// Threads.
    pub threads: usize,
}

impl SynthesisOrder {
    /// The seed where none is named.
    pub const USUAL_SEED: u64 = 1;
}

/// What came of a task.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Synthesis {
    /// Those that do it, the best first; those that keep every wish before the others.
    pub good: Vec<Candidate>,
    /// Those that do not, each with the reason.
    pub defective: Vec<Candidate>,
    /// Whether there are no others.
    pub is_complete: bool,
    /// Why there are none, or why there may be others.
    pub reason: Option<OpenReason>,
    /// Of four poses the pieces of the curves on which every pivot and its pin lie.
    pub curves: Vec<Vec<PosedDyad>>,
}

impl Synthesis {
    /// Proposes, drives and judges. `watch` is told the part that is done, and stops a search by answering false: what was
    /// found until then is judged.
    #[must_use]
    pub fn run(
        task: &Task,
        order: SynthesisOrder,
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
                    wishes: task.wishes,
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

    /// Through poses: where the linkages are a choice and none within the usual reach does it, of a wider one.
    fn through(task: &Task, poses: &PoseTask, threads: usize) -> Synthesis {
        let propose = |reach| {
            let inside = task.wishes.inside;
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

    /// Judges all that is proposed.
    #[must_use]
    pub fn of(task: &Task, proposals: Proposals, threads: usize) -> Synthesis {
        let judged = judged(task, &proposals.found, threads);
        let mut kept: Vec<Candidate> = Vec::new();
        let mut order: Vec<Candidate> = judged;
        order.sort_by(|one, other| better(task, one, other));
        for candidate in order {
            if !kept.iter().any(|before| before.is_same(&candidate)) {
                kept.push(candidate);
            }
        }
        let (good, defective) = kept.into_iter().partition(Candidate::does_it);
        Synthesis {
            good,
            defective,
            is_complete: proposals.is_complete,
            reason: proposals.reason,
            curves: proposals.curves,
        }
    }

    /// Adds a candidate where it belongs, and answers with its place, the defective ones counted behind the others; one
    /// that is there already is not added.
    pub fn add(&mut self, task: &Task, candidate: Candidate) -> usize {
        let all = self.good.iter().chain(&self.defective);
        if let Some(place) = all.into_iter().position(|known| known.is_same(&candidate)) {
            return place;
        }
        let (kind, before) = match candidate.does_it() {
            true => (&mut self.good, 0),
            false => {
                let good = self.good.len();
                (&mut self.defective, good)
            }
        };
        let is_better = |known: &Candidate| better(task, known, &candidate).is_le();
        let place = kind.partition_point(is_better);
        kind.insert(place, candidate);
        before + place
    }
}

/// The same, and behind each linkage those that lead the same point along the same curve: where the crank's turns are given
/// the one that keeps them, and none where pivots are given, for theirs are others.
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

/// All of them, in their order, on several cores.
fn judged(task: &Task, proposals: &[Proposal], threads: usize) -> Vec<Candidate> {
    let judge = |(): &mut (), i: usize| Candidate::judge(task, &proposals[i]);
    parallel::each(proposals.len(), threads, || (), judge, &mut |_| true)
}

/// Those without defects first, then those that keep more wishes; then the smaller miss, as far as it is more than rounding;
/// then the greater transmission angle.
fn better(task: &Task, one: &Candidate, other: &Candidate) -> Ordering {
    let count = |c: &Candidate| (c.defects.len(), c.missed.len());
    let floor = 1e-9 * task.size();
    let miss = |c: &Candidate| c.figures.rms.max(floor);
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
