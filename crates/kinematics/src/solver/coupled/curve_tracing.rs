//! From some solutions of a group to the others: one equation is let go of, and the curve on which
//! all others hold is followed around; wherever the equation holds again there is a solution.
//!
//! It is the old way with a triad - take out one leg, turn what is left, a four-bar, through its
//! motion, and see where the leg fits - for any group, without a closed form, and in turn for every
//! equation: what one curve does not join another may.

use super::{Coupled, Scratch};
use crate::Vec2;
use crate::numeric::root;
use crate::solver::lu;
use crate::solver::state::State;

/// Steps along a curve, in scaled lengths and radians: at the most, and below which a curve is given up:
/// there it branches.
const MAX_LEN: f64 = 0.04;
const MIN_LEN: f64 = 1e-5;
/// The correction behind a step may be this part of it: more could be another curve.
const STRAIN: f64 = 0.1;
/// So much a curve may turn in one step, as a cosine.
const BEND: f64 = 0.98;
/// Corrections from a predicted place back to the curve, and when they are small enough.
const CORRECTIONS: usize = 6;
const ON_CURVE: f64 = 1e-10;
/// Where the equation misses by less than this and begins to miss by more again, two solutions may lie
/// within one step, or have just vanished.
const NEAR_MISS: f64 = 0.05;
/// A slide may run away: no joint is followed further than this, in scaled lengths.
const FAR: f64 = 64.0;
/// Matrices that are factored in all, for a group of one unknown; one of n unknowns counts n^3 times.
const WORK: usize = 20_000_000;
/// More solutions are not looked for.
const MAX_COUNT: usize = 256;

/// A place on a curve: z, the curve's direction there, and by how much the equation misses.
#[derive(Clone)]
struct CurvePlace {
    z: Vec<f64>,
    along: Vec<f64>,
    miss: f64,
}

/// Someone who follows curves of a group.
pub(in crate::solver) struct Tracer<'a> {
    group: &'a Coupled,
    q: f64,
    state: &'a mut State,
    scratch: &'a mut Scratch,
    work: usize,
    roots: Vec<Vec<f64>>,
    /// The solutions and equations whose curve has been followed.
    followed: Vec<(usize, usize)>,
}

impl Coupled {
    /// The solutions that can be reached from these, and these themselves.
    pub(in crate::solver) fn relatives(
        &self,
        q: f64,
        roots: Vec<Vec<f64>>,
        state: &mut State,
        scratch: &mut Scratch,
    ) -> Vec<Vec<f64>> {
        let mut tracer = Tracer {
            group: self,
            q,
            state,
            scratch,
            work: WORK,
            roots,
            followed: Vec::new(),
        };
        let mut next = 0;
        while next < tracer.roots.len().min(MAX_COUNT) {
            for row in 0..self.unknowns() {
                tracer.follow(next, row);
            }
            next += 1;
        }
        tracer.roots
    }
}

impl Tracer<'_> {
    /// Follows the curve of an equation through a solution, once around, or to both its ends.
    fn follow(&mut self, root: usize, row: usize) {
        if self.followed.contains(&(root, row)) {
            return;
        }
        for sense in [1.0, -1.0] {
            if self.goes_around(root, row, sense) {
                return;
            }
        }
    }

    /// Follows it one way; whether it came around.
    fn goes_around(&mut self, root: usize, row: usize, sense: f64) -> bool {
        let Some(mut here) = self.begin(root, row, sense) else {
            return false;
        };
        let mut step = 0.25 * MAX_LEN;
        // A solution is a place where nothing misses: the sign is that of the way on.
        here.miss = 0.0;
        let mut before = f64::INFINITY;
        let mut is_first = true;
        while step >= MIN_LEN && self.work > 0 {
            let Some(there) = self.advance(row, &here, step) else {
                step *= 0.5;
                continue;
            };
            // Solutions in a row: the group moves although its inputs stand still.
            let is_free = !is_first && here.miss.abs().max(there.miss.abs()) <= ON_CURVE;
            if is_free || there.z.iter().any(|v| v.abs() > FAR) {
                return false;
            }
            let met = if is_first {
                None
            } else if here.miss * there.miss <= 0.0 {
                self.between(row, &here, &there, step)
            } else if here.miss.abs() < before.min(there.miss.abs()).min(NEAR_MISS) {
                self.settled(&here.z, true)
            } else {
                None
            };
            if let Some(z) = met {
                let number = self.known(z);
                if number == root {
                    return true;
                }
                self.followed.push((number, row));
            }
            (before, is_first) = (here.miss.abs(), false);
            here = there;
            step = (1.5 * step).min(MAX_LEN);
        }
        false
    }

    /// The number of a solution, a new one's too.
    fn known(&mut self, z: Vec<f64>) -> usize {
        let mut known = self.roots.iter();
        let known = known.position(|other| {
            let two = [&other[..], &z];
            self.group.is_one(self.q, two, self.state, self.scratch)
        });
        known.unwrap_or_else(|| {
            self.roots.push(z);
            self.roots.len() - 1
        })
    }

    /// A solution as a place on the curve of an equation.
    fn begin(&mut self, root: usize, row: usize, sense: f64) -> Option<CurvePlace> {
        let z = self.roots[root].clone();
        // Any direction in which the equation changes: its own rates.
        let mut room = self.group.open(self.scratch);
        room.z.copy_from_slice(&z);
        self.group.jacobian(self.q, self.state, &mut room);
        let n = self.group.unknowns();
        let mut along = room.matrix[row * n..(row + 1) * n].to_vec();
        along.iter_mut().for_each(|v| *v *= sense);
        self.direction(row, z, &along)
    }

    /// One step along the curve, if it is as straight as that.
    fn advance(&mut self, row: usize, from: &CurvePlace, step: f64) -> Option<CurvePlace> {
        let (z, strain) = self.land(row, from, step)?;
        if strain > STRAIN * step {
            return None;
        }
        let place = self.direction(row, z, &from.along)?;
        let cosine = lu::dot(&place.along, &from.along);
        (cosine >= BEND).then_some(place)
    }

    /// The place of the curve beside a step along its direction; and how far beside.
    fn land(&mut self, row: usize, from: &CurvePlace, step: f64) -> Option<(Vec<f64>, f64)> {
        let n = self.group.unknowns();
        let mut room = self.group.open(self.scratch);
        room.z.copy_from_slice(&from.z);
        let change: Vec<f64> = from.along.iter().map(|v| v * step).collect();
        self.group.shift(room.z, &change);
        let mut strain = None;
        for _ in 0..CORRECTIONS {
            self.work = self.work.saturating_sub(n.pow(3));
            self.group.residuals(self.q, self.state, &mut room);
            self.group.jacobian(self.q, self.state, &mut room);
            room.matrix[row * n..(row + 1) * n].copy_from_slice(&from.along);
            room.right[row] = 0.0;
            lu::factor(room.matrix, room.pivots, n)?;
            lu::solve(room.matrix, room.pivots, room.right, n);
            let size = lu::largest(room.right);
            let strain = *strain.get_or_insert(size);
            room.right.iter_mut().for_each(|v| *v = -*v);
            self.group.shift(room.z, room.right);
            if size <= ON_CURVE {
                return Some((room.z.to_vec(), strain));
            }
        }
        None
    }

    /// A place of the curve with its direction, onwards as seen along another.
    fn direction(&mut self, row: usize, z: Vec<f64>, along: &[f64]) -> Option<CurvePlace> {
        let n = self.group.unknowns();
        self.work = self.work.saturating_sub(n.pow(3));
        let mut room = self.group.open(self.scratch);
        room.z.copy_from_slice(&z);
        self.group.residuals(self.q, self.state, &mut room);
        let miss = room.right[row];
        self.group.jacobian(self.q, self.state, &mut room);
        room.matrix[row * n..(row + 1) * n].copy_from_slice(along);
        room.right.fill(0.0);
        room.right[row] = 1.0;
        lu::factor(room.matrix, room.pivots, n)?;
        lu::solve(room.matrix, room.pivots, room.right, n);
        let norm = lu::dot(room.right, room.right).sqrt();
        let along = room.right.iter().map(|v| v / norm).collect();
        norm.is_finite().then_some(CurvePlace { z, along, miss })
    }

    /// The solution between two places of a curve on whose way the equation changes its sign.
    fn between(
        &mut self,
        row: usize,
        from: &CurvePlace,
        to: &CurvePlace,
        step: f64,
    ) -> Option<Vec<f64>> {
        let at = root((0.0, from.miss), (step, to.miss), ON_CURVE, |step| {
            let (z, _) = self.land(row, from, step)?;
            Some(self.direction(row, z, &from.along)?.miss)
        });
        let at = at.ok()?;
        let (z, _) = self.land(row, from, at)?;
        self.settled(&z, false)
    }

    /// The solution at a place, by Newton; or the one downhill of it.
    fn settled(&mut self, z: &[f64], downhill: bool) -> Option<Vec<f64>> {
        self.group.open(self.scratch).z.copy_from_slice(z);
        let settled = if downhill {
            self.group.approach(self.q, self.state, self.scratch)
        } else {
            self.group.correct(self.q, self.state, self.scratch).settled
        };
        let z = self.group.open(self.scratch).z.to_vec();
        settled.then_some(z)
    }
}

/// Two solutions that are further apart than this, in units of about the longest link and in radians, are not one.
pub(in crate::solver) const SAME: f64 = 1e-6;
/// Two solutions that are closer than this, the square root of a rounding, cannot be told apart.
const MIN_DISTANCE: f64 = 1e-8;
/// Halfway between two solutions that are not one the equations miss by more than this: the rounding of their terms.
const HALFWAY: f64 = 4.0 * f64::EPSILON;

/// The largest difference of two solutions.
pub(in crate::solver) fn distance(a: &[f64], b: &[f64]) -> f64 {
    let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    differences.fold(0.0, f64::max)
}

impl Coupled {
    /// Whether two solutions are the same one but for rounding. Uses the room in the scratch.
    pub(in crate::solver) fn is_one(
        &self,
        q: f64,
        [a, b]: [&[f64]; 2],
        state: &State,
        scratch: &mut Scratch,
    ) -> bool {
        let apart = distance(a, b);
        if !(apart < SAME) || apart < MIN_DISTANCE {
            return apart < MIN_DISTANCE;
        }
        let room = self.open(scratch);
        for (z, (a, b)) in room.z.iter_mut().zip(a.iter().zip(b)) {
            *z = 0.5 * (a + b);
        }
        for d in room.z[2 * self.free..].chunks_exact_mut(2) {
            let unit = Vec2::new(d[0], d[1]);
            let unit = unit / unit.norm();
            (d[0], d[1]) = (unit.x, unit.y);
        }
        self.gap(q, state, scratch) <= HALFWAY
    }
}
