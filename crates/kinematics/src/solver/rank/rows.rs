//! Writes the constraints as dense rows over the coordinates of joints and the directions of links.
//! The module documentation of `rank` has the derivations.

use crate::solver::frame::Frame;
use crate::solver::further_inputs::InputMotion;
use crate::solver::plan::network::{ClassId, GROUND, Network, ScalarEquation, ScalarUnknown};
use crate::{Body, Input, LinkId, PointId, SlideId, Vec2, angle};
use nalgebra::DMatrix;

/// The positions of all joints and the directions of all classes of links, in the solver's frame.
#[derive(Clone, Debug)]
pub(super) struct RankPose {
    pub(super) points: Vec<Vec2>,
    /// The direction of each class, as a unit vector.
    pub(super) classes: Vec<Vec2>,
}

impl RankPose {
    /// Returns the direction of a body.
    pub(super) fn direction(&self, network: &Network<'_>, body: LinkId) -> Vec2 {
        let turn = network.turn[body.index()].nearest();
        turn.turned(self.classes[network.class(body).0])
    }
}

/// The residual of one equation and its derivatives.
struct EquationRow {
    miss: f64,
    /// The derivative by the point. That by the centre of the body is its negative.
    normal: Vec2,
    point: Option<PointId>,
    centre: Option<PointId>,
    class: ClassId,
    /// The derivative by the direction of the class. That by the direction of the seat, if there is
    /// one, is its negative.
    turn: f64,
    seat: Option<ClassId>,
    /// The derivative by the driver's coordinate, for a driven slide or links turned against each
    /// other.
    push: f64,
}

/// Equations with the unknowns by which they are differentiated.
pub(super) struct Rows<'n> {
    pub(super) network: &'n Network<'n>,
    pub(super) frame: Frame,
    pub(super) rows: Vec<ScalarEquation>,
    /// The first of a point's two columns.
    point_column: Vec<Option<usize>>,
    class_column: Vec<Option<usize>>,
    /// The number of columns. The driver's coordinate is one further column at the end.
    pub(super) width: usize,
    /// The length by which directions are scaled: columns of angles are angles times this.
    lever: f64,
}

impl<'n> Rows<'n> {
    pub(super) fn new(
        network: &'n Network<'n>,
        frame: Frame,
        rows: Vec<ScalarEquation>,
        unknowns: impl IntoIterator<Item = ScalarUnknown>,
    ) -> Rows<'n> {
        let mut found = Rows {
            network,
            frame,
            rows,
            point_column: vec![None; network.mechanism.points().len()],
            class_column: vec![None; network.members.len()],
            width: 0,
            lever: if frame.longest > 0.0 {
                frame.longest
            } else {
                1.0
            },
        };
        for unknown in unknowns {
            let (column, columns) = match unknown {
                ScalarUnknown::Point(point) => (&mut found.point_column[point.index()], 2),
                ScalarUnknown::Class(class) => (&mut found.class_column[class.0], 1),
            };
            if column.is_none() {
                *column = Some(found.width);
                found.width += columns;
            }
        }
        found
    }

    /// Returns the driver's coordinate in radians or scaled lengths, and its direction if it is an
    /// angle.
    pub(super) fn driver(&self, at: f64) -> (f64, Vec2) {
        match self.network.mechanism.driver().input {
            Input::Turn(_) => (angle::radians(at), angle::unit(at)),
            Input::Push(_) => (self.frame.length(at), Vec2::X),
        }
    }

    /// Returns the driver's coordinate as inputs follow it: in degrees or scaled lengths.
    fn given(&self, at: f64) -> f64 {
        match self.network.mechanism.driver().input {
            Input::Turn(_) => at,
            Input::Push(_) => self.frame.length(at),
        }
    }

    /// Turns the driven links to their directions at the driver's coordinate.
    pub(super) fn drive(&self, at: f64, pose: &mut RankPose) {
        let mechanism = self.network.mechanism;
        if let Input::Turn(link) = mechanism.driver().input
            && mechanism.is_directed(link)
        {
            self.turn(link, self.driver(at).1, pose);
        }
        for (link, following) in self.network.timed_links() {
            self.turn(link, angle::unit(following.at(self.given(at)).p), pose);
        }
    }

    fn turn(&self, link: LinkId, direction: Vec2, pose: &mut RankPose) {
        let class = self.network.class(link);
        if class != GROUND {
            let turn = self.network.turn[link.index()].nearest();
            pose.classes[class.0] = direction.turned(turn.conj());
        }
    }

    /// Returns the coordinate of an input, in degrees or scaled lengths, and its derivative by the
    /// driver's.
    fn input(&self, input: Input, at: f64) -> (f64, f64) {
        let following = self.network.following(input);
        let q = self.given(at);
        let motion = InputMotion::of(following, q);
        (motion.p, motion.w)
    }

    /// Returns the direction of a turned link relative to the link that carries its motor.
    pub(super) fn elbow(&self, turned: LinkId, at: f64) -> Vec2 {
        angle::unit(self.input(Input::Turn(turned), at).0)
    }

    /// Returns the derivative of a driven class's direction by the driver's coordinate.
    fn rate(&self, class: ClassId, at: f64) -> f64 {
        let mut timed = self.network.timed_links();
        let of_class = timed.find(|(link, _)| self.network.class(*link) == class);
        of_class.map_or(1.0, |(_, following)| following.at(self.given(at)).w)
    }

    /// Returns the residual of every equation and its derivatives by column.
    pub(super) fn linear(&self, at: f64, pose: &RankPose) -> Vec<(f64, Vec<(usize, f64)>)> {
        let equations = self.rows.iter().map(|&row| self.equation(row, at, pose));
        equations.map(|e| (e.miss, self.terms(&e, at))).collect()
    }

    /// Returns the derivatives, each row scaled to unit length; the last column is the driver's.
    /// Columns of directions are scaled by the arms of their links: a short link determines its
    /// direction as well as a long one.
    pub(super) fn matrix(&self, at: f64, pose: &RankPose) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(self.rows.len(), self.width + 1);
        for (i, (_, terms)) in self.linear(at, pose).into_iter().enumerate() {
            for (column, value) in terms {
                matrix[(i, column)] += value;
            }
            let norm = matrix.row(i).norm();
            if norm > 0.0 {
                matrix.row_mut(i).unscale_mut(norm);
            }
        }
        for (column, arm) in self.arms() {
            matrix.column_mut(column).scale_mut(self.lever / arm);
        }
        matrix
    }

    /// Returns the columns of directions that depend only on arms of links, each with the longest
    /// arm.
    fn arms(&self) -> Vec<(usize, f64)> {
        let mut arms = vec![0.0_f64; self.class_column.len()];
        for row in &self.rows {
            let (class, arm) = match *row {
                ScalarEquation::Along { link, end } | ScalarEquation::Across { link, end } => {
                    let centre = self.network.centre(link);
                    let from = centre.map_or(Vec2::ZERO, |centre| self.local(link, centre));
                    let arm = self.local(link, end) - from;
                    (self.network.class(link), arm.norm())
                }
                // A guide's arm is not bounded.
                ScalarEquation::Slot(slide) | ScalarEquation::Push(slide) => {
                    let body = self.network.body(self.network.mechanism.slide(slide).on);
                    (self.network.class(body), f64::INFINITY)
                }
                ScalarEquation::Elbow(turned) => {
                    for body in self.network.elbow(turned) {
                        arms[self.network.class(body).0] = f64::INFINITY;
                    }
                    continue;
                }
            };
            arms[class.0] = arms[class.0].max(arm);
        }
        let driven = arms.iter().enumerate();
        let driven = driven
            .filter(|&(class, _)| {
                let is_given = self.network.is_given(ClassId(class));
                is_given && self.class_column[class].is_none() && ClassId(class) != GROUND
            })
            .map(|(_, arm)| *arm)
            .fold(0.0, f64::max);
        let own = self.class_column.iter().zip(&arms);
        let own = own.filter_map(|(column, arm)| Some(((*column)?, *arm)));
        own.chain([(self.width, driven)])
            .filter(|(_, arm)| arm.is_finite() && *arm > 0.0)
            .collect()
    }

    /// Moves a pose by a step of all columns but the driver's.
    pub(super) fn step(&self, pose: &mut RankPose, by: &[f64]) {
        for (position, column) in pose.points.iter_mut().zip(&self.point_column) {
            if let Some(column) = *column {
                *position += Vec2::new(by[column], by[column + 1]);
            }
        }
        for (direction, column) in pose.classes.iter_mut().zip(&self.class_column) {
            if let Some(column) = *column {
                let (sin, cos) = (by[column] / self.lever).sin_cos();
                let turned = direction.turned(Vec2::new(cos, sin));
                *direction = turned / turned.norm();
            }
        }
    }

    /// Returns a link's share in a motion: the maximum of `share` over the columns of its joints
    /// and its direction.
    pub(super) fn share(&self, link: LinkId, share: impl Fn(usize) -> f64) -> f64 {
        let joints = self.network.joints(link);
        let points = joints.filter_map(|m| self.point_column[m.point.index()]);
        let columns = points.flat_map(|column| [column, column + 1]);
        let class = self.class_column[self.network.class(link).0];
        columns.chain(class).map(share).fold(0.0, f64::max)
    }

    fn terms(&self, e: &EquationRow, at: f64) -> Vec<(usize, f64)> {
        let mut terms = Vec::with_capacity(6);
        let mut point = |point: PointId, by: Vec2| {
            if let Some(column) = self.point_column[point.index()] {
                terms.extend([(column, by.x), (column + 1, by.y)]);
            }
        };
        if let Some(end) = e.point {
            point(end, e.normal);
        }
        if let Some(centre) = e.centre {
            point(centre, -e.normal);
        }
        let turn = e.turn / self.lever;
        for (class, turn) in [(Some(e.class), turn), (e.seat, -turn)] {
            let Some(class) = class else { continue };
            if let Some(column) = self.class_column[class.0] {
                terms.push((column, turn));
            } else if class != GROUND && self.network.is_given(class) {
                terms.push((self.width, turn * self.rate(class, at)));
            }
        }
        if e.push != 0.0 {
            terms.push((self.width, e.push));
        }
        terms
    }

    fn equation(&self, row: ScalarEquation, at: f64, pose: &RankPose) -> EquationRow {
        match row {
            ScalarEquation::Along { link, end } | ScalarEquation::Across { link, end } => {
                let (along, seen) = self.arm(link, end, pose);
                let length = along.norm();
                let is_arm = length > 0.0;
                let u = if is_arm { along / length } else { Vec2::X };
                let turning = if is_arm { 1.0 } else { 0.0 };
                let of = |miss, normal, turn: f64| EquationRow {
                    miss,
                    normal,
                    point: Some(end),
                    centre: self.network.centre(link),
                    class: self.network.class(link),
                    turn: turn * turning,
                    seat: None,
                    push: 0.0,
                };
                match row {
                    ScalarEquation::Along { .. } => of(u.dot(seen) - length, u, u.perp().dot(seen)),
                    _ => of(u.perp().dot(seen), u.perp(), -u.dot(seen)),
                }
            }
            ScalarEquation::Slot(slide) | ScalarEquation::Push(slide) => {
                let guide = self.guide(slide, pose);
                let (t, n) = (guide.along, guide.along.perp());
                let of = |miss, normal, turn, push| EquationRow {
                    miss,
                    normal,
                    point: Some(guide.point),
                    centre: guide.centre,
                    class: guide.class,
                    turn,
                    seat: None,
                    push,
                };
                match row {
                    ScalarEquation::Slot(_) => of(n.dot(guide.seen), n, -t.dot(guide.arm), 0.0),
                    _ => {
                        let (p, rate) = self.input(Input::Push(slide), at);
                        of(t.dot(guide.seen) - p, t, n.dot(guide.arm), -rate)
                    }
                }
            }
            ScalarEquation::Elbow(turned) => {
                let bodies = self.network.elbow(turned);
                let [link, from] = bodies.map(|body| pose.direction(self.network, body));
                let rate = self.input(Input::Turn(turned), at).1;
                let wanted = from.turned(self.elbow(turned, at));
                let off = wanted.cross(link).atan2(wanted.dot(link));
                let [class, seat] = bodies.map(|body| self.network.class(body));
                EquationRow {
                    miss: off * self.lever,
                    normal: Vec2::ZERO,
                    point: None,
                    centre: None,
                    class,
                    turn: self.lever,
                    seat: Some(seat),
                    push: -rate,
                }
            }
        }
    }

    /// Returns the vector from a link's centre to another joint: as a rigid arm in the link's
    /// direction, and between the joints' positions.
    fn arm(&self, link: LinkId, end: PointId, pose: &RankPose) -> (Vec2, Vec2) {
        let at = |point: PointId| pose.points[point.index()];
        let Some(centre) = self.network.centre(link) else {
            return (Vec2::ZERO, Vec2::ZERO);
        };
        let local = self.local(link, end) - self.local(link, centre);
        let along = local.turned(pose.direction(self.network, link));
        (along, at(end) - at(centre))
    }

    fn guide(&self, slide: SlideId, pose: &RankPose) -> PosedGuide {
        let given = self.network.mechanism.slide(slide);
        let body = self.network.body(given.on);
        let point = given.slider.point();
        let at = pose.points[point.index()];
        let direction = pose.direction(self.network, body);
        let along = angle::unit(given.angle).turned(direction);
        let centre = self.network.centre(body);
        let (through, arm) = match (given.on, centre) {
            (Body::Link(link), Some(centre)) => {
                let base = pose.points[centre.index()];
                let through = self.frame.local(given.through).nearest();
                let through = through - self.local(link, centre);
                (base + through.turned(direction), at - base)
            }
            (Body::Ground | Body::Link(_), _) => {
                (self.frame.inner(given.through).nearest(), Vec2::ZERO)
            }
        };
        PosedGuide {
            point,
            centre,
            class: self.network.class(body),
            along,
            seen: at - through,
            arm,
        }
    }

    /// Returns the position of a link's point that is not a joint.
    pub(super) fn rider(&self, link: LinkId, point: PointId, pose: &RankPose) -> Vec2 {
        let Some(centre) = self.network.centre(link) else {
            return Vec2::ZERO;
        };
        let local = self.local(link, point) - self.local(link, centre);
        let arm = local.turned(pose.direction(self.network, link));
        pose.points[centre.index()] + arm
    }

    /// Returns the position of a joint in its link, in the solver's unit.
    pub(super) fn local(&self, link: LinkId, point: PointId) -> Vec2 {
        let body = self.network.link(link);
        let local = body.and_then(|l| l.local(point)).unwrap_or_default();
        self.frame.local(local).nearest()
    }
}

/// A guide and the point that slides along it, at a pose.
struct PosedGuide {
    point: PointId,
    centre: Option<PointId>,
    class: ClassId,
    /// The guide's direction.
    along: Vec2,
    /// The sliding point relative to the guide's point, and relative to the body's centre.
    seen: Vec2,
    arm: Vec2,
}
