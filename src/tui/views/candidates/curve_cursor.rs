//! The cursor on the curves of four poses. It moves along pivots with their pins; two of these
//! dyads make a linkage.

use super::list::{CandidateList, CandidatesPage};
use crate::Vec2;
use crate::report::CandidateRow;
use crate::synthesis::{Candidate, PosedDyad, TaskKind};

/// Number of long steps that cover a curve.
const LONG: usize = 20;

/// The position of the cursor on the curves, and the picked dyad.
#[derive(Debug, Default)]
pub(crate) struct CurveWalk {
    /// Index of the curve; `place` is the index of the dyad on it.
    curve: usize,
    place: usize,
    /// The picked dyad.
    picked: Option<PosedDyad>,
    /// The linkage of the picked dyad and the one under the cursor.
    linkage: Option<(Candidate, CandidateRow)>,
}

impl CurveWalk {
    /// Returns the picked dyad.
    pub(crate) fn picked(&self) -> Option<&PosedDyad> {
        self.picked.as_ref()
    }

    /// Returns the linkage of the two dyads; `None` if they make none.
    pub(super) fn linkage(&self) -> Option<(&Candidate, &CandidateRow)> {
        let (candidate, row) = self.linkage.as_ref()?;
        Some((candidate, row))
    }
}

/// The size of a step on the curves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum WalkStep {
    /// To the next dyad; from the end of a curve to the next curve.
    Next,
    /// Over a twentieth of the curve.
    Long,
    /// To the next curve, at its point nearest to the poses.
    Curve,
}

impl CandidateList {
    /// Returns the dyads of four poses, curve by curve.
    fn dyads(&self) -> &[Vec<PosedDyad>] {
        let found = self.found().map(|found| &found.synthesis);
        found.map_or(&[], |found| &found.curves)
    }

    /// Returns `true` if there is a curve to walk on.
    pub(crate) fn has_curves(&self) -> bool {
        self.dyads().iter().any(|curve| !curve.is_empty())
    }

    /// Cycles the pages: the list, the candidate alone if the screen does not show both, the
    /// curves.
    pub(crate) fn turn_page(&mut self, sees_both: bool) {
        let curves = match self.has_curves() {
            true => CandidatesPage::Curves(Box::new(self.walk_from_start())),
            false => CandidatesPage::List,
        };
        self.page = match self.page {
            CandidatesPage::List if !sees_both && !self.rows().is_empty() => CandidatesPage::Alone,
            CandidatesPage::List | CandidatesPage::Alone => curves,
            CandidatesPage::Curves(_) => CandidatesPage::List,
        };
        self.change_drawing();
    }

    /// Goes one level back: clears the picked dyad, or returns to the list. Returns `false` if the
    /// list was already shown.
    pub(crate) fn step_out(&mut self) -> bool {
        match &mut self.page {
            CandidatesPage::List => return false,
            CandidatesPage::Curves(walk) if walk.picked.is_some() => {
                (walk.picked, walk.linkage) = (None, None);
            }
            CandidatesPage::Alone | CandidatesPage::Curves(_) => self.page = CandidatesPage::List,
        }
        self.change_drawing();
        true
    }

    /// Returns a cursor on the first curve that is not empty.
    fn walk_from_start(&self) -> CurveWalk {
        let curve = self.dyads().iter().position(|curve| !curve.is_empty());
        let curve = curve.unwrap_or(0);
        CurveWalk {
            curve,
            place: self.near_poses(curve),
            ..CurveWalk::default()
        }
    }

    /// Returns the index of the curve's dyad nearest to the poses. Curves begin and end far away,
    /// so their ends are poor starting points.
    fn near_poses(&self, curve: usize) -> usize {
        let (middle, _) = self.middle_and_size();
        let far = |dyad: &PosedDyad| {
            let pivot = dyad.held.pivot().unwrap_or(dyad.pin);
            (dyad.pin - middle).norm().max((pivot - middle).norm())
        };
        let places = self.dyads().get(curve).into_iter().flatten().enumerate();
        let nearest = places.min_by(|(_, a), (_, b)| far(a).total_cmp(&far(b)));
        nearest.map_or(0, |(index, _)| index)
    }

    /// Returns the centroid of the poses and their characteristic size.
    pub(super) fn middle_and_size(&self) -> (Vec2, f64) {
        let origins = self.posed_origins();
        let count = origins.len().max(1) as f64;
        let middle = origins.iter().fold(Vec2::ZERO, |sum, at| sum + *at / count);
        let far = origins.iter().map(|at| (*at - middle).norm());
        (middle, 2.0 * far.fold(0.0, f64::max))
    }

    /// Returns the dyad under the cursor; `None` on other pages.
    pub(crate) fn walked(&self) -> Option<&PosedDyad> {
        let CandidatesPage::Curves(walk) = &self.page else {
            return None;
        };
        self.dyads().get(walk.curve)?.get(walk.place)
    }

    /// Returns the number of the dyad and the count of dyads on its curve, then the number of the
    /// curve and the count of curves. Numbers count from 1.
    pub(crate) fn walked_place(&self) -> Option<[(usize, usize); 2]> {
        let CandidatesPage::Curves(walk) = &self.page else {
            return None;
        };
        let curve = self.dyads().get(walk.curve)?;
        Some([
            (walk.place + 1, curve.len()),
            (walk.curve + 1, self.dyads().len()),
        ])
    }

    /// Moves the cursor along the curves, cyclically.
    pub(crate) fn walk(&mut self, step: WalkStep, forward: bool) {
        let CandidatesPage::Curves(walk) = &self.page else {
            return;
        };
        let counts: Vec<usize> = self.dyads().iter().map(Vec::len).collect();
        let (curve, index) = match step {
            WalkStep::Curve => {
                let curve = next_curve(&counts, walk.curve, forward);
                (curve, self.near_poses(curve))
            }
            WalkStep::Next => stepped(&counts, (walk.curve, walk.place), 1, forward),
            WalkStep::Long => {
                let own = counts.get(walk.curve).map_or(1, |own| own.div_ceil(LONG));
                stepped(&counts, (walk.curve, walk.place), own, forward)
            }
        };
        if let CandidatesPage::Curves(walk) = &mut self.page {
            (walk.curve, walk.place) = (curve, index);
        }
        self.update_linkage();
    }

    /// Picks the dyad under the cursor. If one was picked already, adds the linkage of the two to
    /// the list, in its place by rank. Then shows the list with the cursor on it. Returns `false`
    /// if the two make no linkage.
    pub(crate) fn pick(&mut self) -> bool {
        let dyad = self.walked().copied();
        let CandidatesPage::Curves(walk) = &mut self.page else {
            return false;
        };
        if walk.picked.is_none() {
            walk.picked = dyad;
            self.change_drawing();
            return true;
        }
        let Some((candidate, _)) = walk.linkage.take() else {
            return false;
        };
        self.page = CandidatesPage::List;
        if let Some(found) = &mut self.job.result {
            self.cursor = found.synthesis.add(&self.order.file.task, candidate);
            found.rebuild_texts(&self.order);
        }
        self.change_drawing();
        true
    }

    /// Computes the linkage of the picked dyad and the one under the cursor.
    fn update_linkage(&mut self) {
        let walked = self.walked().copied();
        let linkage = walked.and_then(|walked| self.evaluate_dyad(&walked));
        if let CandidatesPage::Curves(walk) = &mut self.page {
            walk.linkage = linkage;
        }
        self.change_drawing();
    }

    fn evaluate_dyad(&self, walked: &PosedDyad) -> Option<(Candidate, CandidateRow)> {
        let task = &self.order.file.task;
        let (CandidatesPage::Curves(walk), TaskKind::Poses(poses)) = (&self.page, &task.kind)
        else {
            return None;
        };
        let proposal = poses.linkage([walk.picked.as_ref()?, walked])?;
        let candidate = Candidate::evaluate(task, &proposal);
        let row = self.found()?.report(&self.order).row(&candidate);
        Some((candidate, row))
    }

    /// Returns a description of a dyad.
    pub(super) fn describe_dyad(&self, dyad: &PosedDyad) -> Option<String> {
        let found = self.found()?;
        Some(found.report(&self.order).dyad(dyad))
    }

    /// Returns the origins of the poses.
    pub(super) fn posed_origins(&self) -> Vec<Vec2> {
        match &self.order.file.task.kind {
            TaskKind::Poses(task) => task.poses.iter().map(|pose| pose.at).collect(),
            TaskKind::Function(_) | TaskKind::Path(_) => Vec::new(),
        }
    }
}

/// Returns the place after `by` steps over curves with these numbers of places, continuing from the
/// end of one curve to the next, cyclically.
fn stepped(
    counts: &[usize],
    (curve, index): (usize, usize),
    by: usize,
    forward: bool,
) -> (usize, usize) {
    let integer: usize = counts.iter().sum();
    if integer == 0 {
        return (curve, index);
    }
    let from = counts[..curve.min(counts.len())].iter().sum::<usize>() + index;
    let mut left = match forward {
        true => (from + by) % integer,
        false => (from + integer - by % integer) % integer,
    };
    for (curve, &count) in counts.iter().enumerate() {
        if left < count {
            return (curve, left);
        }
        left -= count;
    }
    (curve, index)
}

/// Returns the next or the previous curve that is not empty.
fn next_curve(counts: &[usize], curve: usize, forward: bool) -> usize {
    let number = counts.len();
    let around = (1..=number).map(|step| match forward {
        true => (curve + step) % number,
        false => (curve + number - step) % number,
    });
    let mut others = around.into_iter().filter(|&other| counts[other] > 0);
    others.next().unwrap_or(curve)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// No step leaves the curves, and empty curves are skipped.
    #[test]
    fn steps_wrap_around_all_curves() {
        let counts = [3, 0, 40];
        let go = |from, by, forward| stepped(&counts, from, by, forward);
        assert_eq!(go((0, 2), 1, true), (2, 0));
        assert_eq!(go((2, 0), 1, false), (0, 2));
        assert_eq!(go((2, 39), 1, true), (0, 0));
        assert_eq!(go((0, 0), 1, false), (2, 39));
        assert_eq!(go((2, 4), 2, true), (2, 6));
        assert_eq!(stepped(&[], (0, 0), 1, true), (0, 0));
        assert_eq!([true, false].map(|on| next_curve(&counts, 0, on)), [2, 2]);
        assert_eq!([true, false].map(|on| next_curve(&counts, 2, on)), [0, 0]);
        assert_eq!(next_curve(&[], 0, true), 0);
    }
}
