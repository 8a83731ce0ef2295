//! The cursor on the curves of four poses: it goes along pivots with their pins, and two of these make a linkage.

use super::list::{CandidateList, CandidatesPage};
use crate::Vec2;
use crate::report::CandidateRow;
use crate::synthesis::{Candidate, Partner, PosedDyad, TaskKind};

/// A long step goes over this part of a curve.
const LONG: usize = 20;

/// Where on the curves the cursor is, and what was picked.
#[derive(Debug, Default)]
pub(crate) struct CurveWalk {
    /// Which curve, and which of its dyads, from 0.
    curve: usize,
    place: usize,
    /// The dyad that was picked.
    picked: Option<PosedDyad>,
    /// What it makes with the one under the cursor.
    linkage: Option<(Candidate, CandidateRow)>,
}

impl CurveWalk {
    /// The one that was picked.
    pub(crate) fn picked(&self) -> Option<&PosedDyad> {
        self.picked.as_ref()
    }

    /// What the two make; `None` where that is no linkage.
    pub(super) fn linkage(&self) -> Option<(&Candidate, &CandidateRow)> {
        let (candidate, row) = self.linkage.as_ref()?;
        Some((candidate, row))
    }
}

/// How far a step on the curves goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum WalkStep {
    /// To the next pivot and pin, from the end of a curve to the next one.
    Next,
    /// Over a part of the curve.
    Long,
    /// To the next curve, where it is nearest to the poses.
    Curve,
}

impl CandidateList {
    /// Of four poses the dyads that there are, curve by curve.
    fn dyads(&self) -> &[Vec<PosedDyad>] {
        let found = self.found.as_ref().map(|found| &found.synthesis);
        found.map_or(&[], |found| &found.curves)
    }

    /// Whether there are curves to walk on.
    pub(crate) fn has_curves(&self) -> bool {
        self.dyads().iter().any(|curve| !curve.is_empty())
    }

    /// From the list to the candidate alone, where both are not seen, on to the curves, and back.
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

    /// Back by one: from a picked dyad to none, and from there to the list; false where it is there.
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

    /// At the first curve that has a place.
    fn walk_from_start(&self) -> CurveWalk {
        let curve = self.dyads().iter().position(|curve| !curve.is_empty());
        let curve = curve.unwrap_or(0);
        CurveWalk {
            curve,
            place: self.near_poses(curve),
            ..CurveWalk::default()
        }
    }

    /// The place of a curve whose pivot and pin are nearest to the poses; curves begin and end far away.
    fn near_poses(&self, curve: usize) -> usize {
        let (middle, _) = self.middle_and_size();
        let far = |dyad: &PosedDyad| {
            let pivot = match dyad.held {
                Partner::Rocker(pivot) => pivot,
                Partner::Slide(_) => dyad.pin,
            };
            (dyad.pin - middle).norm().max((pivot - middle).norm())
        };
        let places = self.dyads().get(curve).into_iter().flatten().enumerate();
        let nearest = places.min_by(|(_, a), (_, b)| far(a).total_cmp(&far(b)));
        nearest.map_or(0, |(place, _)| place)
    }

    /// The middle of the poses, and a length by which their curves are measured.
    pub(super) fn middle_and_size(&self) -> (Vec2, f64) {
        let origins = self.posed_origins();
        let count = origins.len().max(1) as f64;
        let middle = origins.iter().fold(Vec2::ZERO, |sum, at| sum + *at / count);
        let far = origins.iter().map(|at| (*at - middle).norm());
        (middle, 2.0 * far.fold(0.0, f64::max))
    }

    /// The dyad under the cursor, while curves are walked.
    pub(crate) fn walked(&self) -> Option<&PosedDyad> {
        let CandidatesPage::Curves(walk) = &self.page else {
            return None;
        };
        self.dyads().get(walk.curve)?.get(walk.place)
    }

    /// The number of the dyad under the cursor and how many its curve has, and the same of the curve; counted from 1.
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

    /// Goes along the curves, on from the last one to the first.
    pub(crate) fn walk(&mut self, step: WalkStep, forward: bool) {
        let CandidatesPage::Curves(walk) = &self.page else {
            return;
        };
        let counts: Vec<usize> = self.dyads().iter().map(Vec::len).collect();
        let (curve, place) = match step {
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
            (walk.curve, walk.place) = (curve, place);
        }
        self.judge_walked();
    }

    /// Picks the dyad under the cursor; where one was picked, the linkage of the two is listed, wherever it belongs, and
    /// the list is looked at with the cursor on it. False where the two make none.
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
        if let Some(found) = &mut self.found {
            self.cursor = found.synthesis.add(&self.order.file.task, candidate);
            found.say(&self.order);
        }
        self.change_drawing();
        true
    }

    /// What the picked dyad and the one under the cursor make.
    fn judge_walked(&mut self) {
        let walked = self.walked().copied();
        let linkage = walked.and_then(|walked| self.judged(&walked));
        if let CandidatesPage::Curves(walk) = &mut self.page {
            walk.linkage = linkage;
        }
        self.change_drawing();
    }

    fn judged(&self, walked: &PosedDyad) -> Option<(Candidate, CandidateRow)> {
        let task = &self.order.file.task;
        let (CandidatesPage::Curves(walk), TaskKind::Poses(poses)) = (&self.page, &task.kind)
        else {
            return None;
        };
        let proposal = poses.linkage([walk.picked.as_ref()?, walked])?;
        let candidate = Candidate::judge(task, &proposal);
        let row = self.found.as_ref()?.report(&self.order).row(&candidate);
        Some((candidate, row))
    }

    /// What is said of a dyad.
    pub(super) fn told_dyad(&self, dyad: &PosedDyad) -> Option<String> {
        let found = self.found.as_ref()?;
        Some(found.report(&self.order).dyad(dyad))
    }

    /// The origins of the poses.
    pub(super) fn posed_origins(&self) -> Vec<Vec2> {
        match &self.order.file.task.kind {
            TaskKind::Poses(task) => task.poses.iter().map(|pose| pose.at).collect(),
            TaskKind::Function(_) | TaskKind::Path(_) => Vec::new(),
        }
    }
}

/// The place after so many steps on curves of so many places each, from the end of one to the next and around.
fn stepped(
    counts: &[usize],
    (curve, place): (usize, usize),
    by: usize,
    forward: bool,
) -> (usize, usize) {
    let whole: usize = counts.iter().sum();
    if whole == 0 {
        return (curve, place);
    }
    let from = counts[..curve.min(counts.len())].iter().sum::<usize>() + place;
    let mut left = match forward {
        true => (from + by) % whole,
        false => (from + whole - by % whole) % whole,
    };
    for (curve, &count) in counts.iter().enumerate() {
        if left < count {
            return (curve, left);
        }
        left -= count;
    }
    (curve, place)
}

/// The next curve that has places, or the one before.
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

    /// No step leaves the curves, and those that have no place are passed by.
    #[test]
    fn steps_go_around_all_curves() {
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
