//! Assembles all constraints at once, redundant ones included, by least squares from approximate
//! positions.
//!
//! The steps of the plan cannot do this if the structural analysis set the wrong constraints aside,
//! and only an assembled mechanism shows which are the right ones. The Levenberg-Marquardt method
//! needs no regular matrix: it converges to a nearby pose despite redundant constraints and free
//! motions.

use super::rows::{RankPose, Rows};
use crate::numeric::{DampedSearch, Trial};
use crate::solver::plan::network::GROUND;
use crate::{LinkId, PointId, Vec2, angle};
use nalgebra::{Cholesky, DMatrix, DVector};

/// The damping is relative to the squares of rows of unit length. Its minimum is below the square
/// root of the rounding error: it affects no regular direction, but still damps a free one. The
/// squared residual must fall to half in 20 steps; if not, the search converges to a nonzero
/// residual.
const SEARCH: DampedSearch = DampedSearch {
    steps: 200,
    growth: 10.0,
    shrinking: 0.1,
    min_damping: 1e-13,
    max_damping: 1e9,
    min_gain: 0.034,
    level_steps: 20,
    ..DampedSearch::DEFAULT
};
/// Steps shorter than this, in units of about the longest link, are rounding errors.
const MIN_STEP: f64 = 4.0 * f64::EPSILON;
/// Maximum residual of an assembled pose, relative to its size: the rounding of its coordinates.
const ASSEMBLED: f64 = 1e-12;
/// Increment from one initial direction to the next, in degrees: multiples of the golden angle
/// never repeat.
const GOLDEN: f64 = 137.507_764_050_037_85;

/// An assembled pose, with a bound on its distance from the true one.
pub(super) struct Assembled {
    pub(super) pose: RankPose,
    pub(super) slack: f64,
}

/// Moves a pose to where all equations hold to within `misfit`; returns `None` if it does not
/// converge.
pub(super) fn assemble(
    rows: &Rows<'_>,
    at: f64,
    misfit: f64,
    mut pose: RankPose,
) -> Option<Assembled> {
    rows.drive(at, &mut pose);
    let mut system = Normal::of(rows, at, &pose);
    let mut is_converged = false;
    SEARCH.run(system.cost, |damping| {
        if is_converged {
            return Trial::Finished;
        }
        let better = system.step(rows, at, &pose, damping).map(|(next, step)| {
            pose = next;
            system = Normal::of(rows, at, &pose);
            is_converged = step <= MIN_STEP;
            system.cost
        });
        better.into()
    });
    let reach = pose.points.iter().map(|p| p.norm()).fold(1.0, f64::max);
    let allowed = misfit.max(ASSEMBLED * reach);
    let slack = system.largest.max(MIN_STEP * reach);
    (system.largest <= allowed).then_some(Assembled { pose, slack })
}

/// The normal equations at a pose.
struct Normal {
    matrix: DMatrix<f64>,
    downhill: DVector<f64>,
    /// Half the sum of the squared residuals, and the maximum residual.
    cost: f64,
    largest: f64,
}

impl Normal {
    fn of(rows: &Rows<'_>, at: f64, pose: &RankPose) -> Normal {
        let n = rows.width;
        let mut normal = Normal {
            matrix: DMatrix::zeros(n, n),
            downhill: DVector::zeros(n),
            cost: 0.0,
            largest: 0.0,
        };
        for (miss, mut terms) in rows.linear(at, pose) {
            // The driver is fixed.
            terms.retain(|term| term.0 < n);
            for &(i, a) in &terms {
                normal.downhill[i] -= a * miss;
                for &(j, b) in &terms {
                    normal.matrix[(i, j)] += a * b;
                }
            }
            normal.cost += 0.5 * miss * miss;
            normal.largest = normal.largest.max(miss.abs());
        }
        normal
    }

    /// Returns the next pose and the step length, or `None` if the step does not reduce the cost.
    fn step(
        &self,
        rows: &Rows<'_>,
        at: f64,
        pose: &RankPose,
        damping: f64,
    ) -> Option<(RankPose, f64)> {
        let mut damped = self.matrix.clone();
        for i in 0..rows.width {
            damped[(i, i)] += damping;
        }
        let step = Cholesky::new(damped)?.solve(&self.downhill);
        let mut next = pose.clone();
        rows.step(&mut next, step.as_slice());
        let misses = rows.linear(at, &next).into_iter().map(|(miss, _)| miss);
        let cost: f64 = misses.map(|miss| 0.5 * miss * miss).sum();
        (cost < self.cost).then(|| (next, step.norm()))
    }
}

/// Creates an approximate pose: given points keep their positions, the rest follows from link to
/// link. Directions that nothing determines differ in every trial.
pub(super) fn rough(rows: &Rows<'_>, at: f64, near: &[(PointId, Vec2)], trial: usize) -> RankPose {
    let network = rows.network;
    let mechanism = network.mechanism;
    let mut pose = RankPose {
        points: vec![Vec2::ZERO; mechanism.points().len()],
        classes: vec![Vec2::X; network.members.len()],
    };
    rows.drive(at, &mut pose);
    let mut placing = RoughPlacement {
        rows,
        at,
        point_known: vec![false; pose.points.len()],
        class_known: vec![false; pose.classes.len()],
        pose,
        next: angle::unit(GOLDEN * trial as f64),
    };
    for (class, _) in network.members.iter().enumerate() {
        placing.class_known[class] = network.is_given(crate::solver::plan::network::ClassId(class));
    }
    placing.class_known[GROUND.0] = true;
    let given = mechanism.point_ids().filter_map(|p| {
        let ground = mechanism.point(p).ground;
        let near = || near.iter().find(|(of, _)| *of == p).map(|(_, at)| *at);
        Some((p, ground.or_else(near)?))
    });
    for (point, position) in given {
        let position = rows.frame.inner(position).nearest();
        placing.place_point(point, position);
    }
    placing.place_all();
    placing.pose
}

/// Places links approximately, one after another.
struct RoughPlacement<'r, 'n> {
    rows: &'r Rows<'n>,
    /// The driver's coordinate.
    at: f64,
    pose: RankPose,
    point_known: Vec<bool>,
    class_known: Vec<bool>,
    /// The next direction to try.
    next: Vec2,
}

impl RoughPlacement<'_, '_> {
    fn place_point(&mut self, point: PointId, position: Vec2) {
        self.pose.points[point.index()] = position;
        self.point_known[point.index()] = true;
    }

    fn place_all(&mut self) {
        loop {
            while self.follow() {}
            if !(self.turn_one() || self.drop_one()) {
                return;
            }
        }
    }

    /// Returns the placed joints of a link, and one joint not yet placed.
    fn joints(&self, link: LinkId) -> (Vec<PointId>, Option<PointId>) {
        let joints = self.rows.network.joints(link).map(|m| m.point);
        let (known, unknown): (Vec<_>, Vec<_>) = joints.partition(|p| self.point_known[p.index()]);
        (known, unknown.first().copied())
    }

    /// Places everything that follows from the placed elements. Returns `true` if any was placed.
    fn follow(&mut self) -> bool {
        let network = self.rows.network;
        let mut any = self.turn_elbows();
        for link in network.mechanism.link_ids() {
            let class = network.class(link).0;
            let (known, _) = self.joints(link);
            if let (false, [from, to, ..]) = (self.class_known[class], &known[..]) {
                let seen = self.pose.points[to.index()] - self.pose.points[from.index()];
                let local = self.rows.local(link, *to) - self.rows.local(link, *from);
                let own = seen.turned(local.conj());
                let own = own.turned(network.turn[link.index()].nearest().conj());
                if own.norm() > 0.0 {
                    self.pose.classes[class] = own / own.norm();
                    (self.class_known[class], any) = (true, true);
                }
            }
            let Some(&base) = known.first().filter(|_| self.class_known[class]) else {
                continue;
            };
            while let (_, Some(next)) = self.joints(link) {
                let local = self.rows.local(link, next) - self.rows.local(link, base);
                let arm = local.turned(self.pose.direction(network, link));
                self.place_point(next, self.pose.points[base.index()] + arm);
                any = true;
            }
        }
        any
    }

    /// Computes the direction of one link from the other, for links between which an input turns.
    /// Returns `true` if any direction was set.
    fn turn_elbows(&mut self) -> bool {
        let network = self.rows.network;
        let mut any = false;
        for (turned, _) in network.mechanism.elbows() {
            let [link, from] = network.elbow(turned);
            let by = self.rows.elbow(turned, self.at);
            for (to, of, by) in [(link, from, by), (from, link, by.conj())] {
                let [class, known] = [to, of].map(|body| network.class(body).0);
                if self.class_known[known] && !self.class_known[class] {
                    let own = self.pose.direction(network, of).turned(by);
                    let turn = network.turn[to.index()].nearest();
                    self.pose.classes[class] = own.turned(turn.conj());
                    (self.class_known[class], any) = (true, true);
                }
            }
        }
        any
    }

    /// Chooses a direction for a link that has a placed joint, or else for any other. Returns
    /// `false` if all directions are known.
    fn turn_one(&mut self) -> bool {
        let network = self.rows.network;
        let free = |link: &LinkId| !self.class_known[network.class(*link).0];
        let mut links = network.mechanism.link_ids().filter(free).peekable();
        let any = links.peek().copied();
        let hangs = |link: &LinkId| !self.joints(*link).0.is_empty();
        let Some(link) = links.find(hangs).or(any) else {
            return false;
        };
        let class = network.class(link).0;
        self.next = self.next.turned(angle::unit(GOLDEN));
        self.pose.classes[class] = self.next;
        self.class_known[class] = true;
        true
    }

    /// Places one unknown joint near the centroid of the placed points, slightly offset. Returns
    /// `false` if all joints are placed.
    fn drop_one(&mut self) -> bool {
        let network = self.rows.network;
        let mut points = network.mechanism.point_ids();
        let open = |p: &PointId| network.is_joint(*p) && !self.point_known[p.index()];
        let Some(point) = points.find(open) else {
            return false;
        };
        let placed = self.pose.points.iter().zip(&self.point_known);
        let placed: Vec<Vec2> = placed
            .filter(|(_, known)| **known)
            .map(|(p, _)| *p)
            .collect();
        let middle = placed.iter().fold(Vec2::ZERO, |sum, &p| sum + p);
        let middle = middle / placed.len().max(1) as f64;
        self.next = self.next.turned(angle::unit(GOLDEN));
        self.place_point(point, middle + self.next * 0.5);
        true
    }
}
