//! Lists the given lengths of a mechanism and derives mechanisms with one length changed.
//!
//! Drawn or manufactured lengths are never exact, so sensitivities are computed one length at a
//! time. Angles of guides and the driver's coordinate do not count as lengths.

use super::{Body, ElementId, LinkId, Mechanism, Parts, PointId, PolarPosition, SlideId, Slider};
use crate::Vec2;
use std::collections::HashSet;
use std::sync::Arc;

/// The axis of a coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CoordinateAxis {
    /// The x axis.
    X,
    /// The y axis.
    Y,
}

impl CoordinateAxis {
    /// Both axes, in order.
    pub const BOTH: [CoordinateAxis; 2] = [CoordinateAxis::X, CoordinateAxis::Y];

    fn along(self, by: f64) -> Vec2 {
        match self {
            CoordinateAxis::X => Vec2::new(by, 0.0),
            CoordinateAxis::Y => Vec2::new(0.0, by),
        }
    }
}

/// A given length, in the scene's unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Length {
    /// The length of a link between its two natural ends.
    Link(LinkId),
    /// A coordinate of a further point of a link, in the link's frame.
    Local(LinkId, PointId, CoordinateAxis),
    /// The distance of a polar point of a link from its reference point.
    Arm(LinkId, PointId),
    /// The displacement of a polar point across its arm, due to its angle.
    Across(LinkId, PointId),
    /// A coordinate of a ground point.
    Ground(PointId, CoordinateAxis),
    /// A coordinate of the point through which a guide runs, in the frame of the guide's body.
    /// Applies only if it is given by coordinates, not by a point's name.
    Through(SlideId, CoordinateAxis),
}

impl Length {
    /// Returns the element that the length belongs to.
    #[must_use]
    pub fn element(self) -> ElementId {
        match self {
            Length::Link(link)
            | Length::Local(link, ..)
            | Length::Arm(link, _)
            | Length::Across(link, _) => ElementId::Link(link),
            Length::Ground(point, _) => ElementId::Point(point),
            Length::Through(slide, _) => ElementId::Slide(slide),
        }
    }
}

impl Mechanism {
    /// Returns all given lengths: the ground's, the links' and the slides', each in the order of
    /// the file.
    ///
    /// The coordinates of a link's own origin are excluded: the position of `from`, or of the point
    /// sliding along a guide, defines the link's frame.
    #[must_use]
    pub fn lengths(&self) -> Vec<Length> {
        let fixed = self.point_ids().filter(|&p| {
            let point = self.point(p);
            point.ground.is_some() && !point.is_mark
        });
        let both = |length: fn(PointId, CoordinateAxis) -> Length| {
            move |point| CoordinateAxis::BOTH.map(|axis| length(point, axis))
        };
        let mut lengths: Vec<Length> = fixed.flat_map(both(Length::Ground)).collect();
        for link in self.link_ids() {
            self.lengths_of(link, &mut lengths);
        }
        for slide in self.slide_ids() {
            if self.slide(slide).named.is_none() {
                lengths.extend(CoordinateAxis::BOTH.map(|axis| Length::Through(slide, axis)));
            }
        }
        lengths
    }

    /// Returns the maximum distance of a link's point from the link's origin, in the scene's unit;
    /// 1 if there is none.
    pub fn reach(&self) -> f64 {
        let members = self.links().iter().flat_map(|link| &link.members);
        let longest = members
            .map(|member| member.local.norm())
            .fold(0.0, f64::max);
        if longest > 0.0 { longest } else { 1.0 }
    }

    /// Returns the value of a length as given: for a coordinate its value, for [`Length::Across`]
    /// the length of the arm.
    #[must_use]
    pub fn given(&self, length: Length) -> f64 {
        let along = |position: Vec2, axis| match axis {
            CoordinateAxis::X => position.x,
            CoordinateAxis::Y => position.y,
        };
        let member = |link, point| self.link(link).member(point);
        let given = match length {
            Length::Link(link) => {
                let ends = self.link(link).ends;
                ends.and_then(|(_, to)| Some(member(link, to)?.local.norm()))
            }
            Length::Local(link, point, axis) => member(link, point).map(|m| along(m.local, axis)),
            Length::Arm(link, point) | Length::Across(link, point) => {
                member(link, point).and_then(|m| Some(m.polar?.length))
            }
            Length::Ground(point, axis) => self.point(point).ground.map(|at| along(at, axis)),
            Length::Through(slide, axis) => Some(along(self.slide(slide).through, axis)),
        };
        given.unwrap_or_default()
    }

    fn lengths_of(&self, id: LinkId, lengths: &mut Vec<Length>) {
        let link = self.link(id);
        let ends = link.ends.map(|(from, to)| [from, to]);
        if ends.is_some() {
            lengths.push(Length::Link(id));
        }
        let is_origin = |point: PointId| {
            self.slides().iter().any(|slide| match slide.slider {
                Slider::Link { origin, link, .. } => link == id && origin == point,
                Slider::Pin(_) => false,
            })
        };
        for member in &link.members {
            let is_end = ends.is_some_and(|ends| ends.contains(&member.point));
            if !is_end && !is_origin(member.point) {
                let point = member.point;
                let both = match member.polar {
                    None => CoordinateAxis::BOTH.map(|axis| Length::Local(id, point, axis)),
                    Some(_) => [Length::Arm(id, point), Length::Across(id, point)],
                };
                lengths.extend(both);
            }
        }
    }

    /// Returns by how much each length is longer in `other`, a mechanism with the same elements.
    /// Returns `None` if angles of guides or points, or the laws of further inputs, differ too.
    pub fn longer(&self, other: &Mechanism, lengths: &[Length]) -> Option<Vec<f64>> {
        let angles = |mechanism: &Mechanism| -> Vec<f64> {
            let guides = mechanism
                .slides()
                .iter()
                .flat_map(|slide| match slide.slider {
                    Slider::Link { turn, .. } => [slide.angle, turn],
                    Slider::Pin(_) => [slide.angle, 0.0],
                });
            let members = mechanism.links().iter().flat_map(|link| &link.members);
            let points = members.filter_map(|member| Some(member.polar?.angle));
            guides.chain(points).collect()
        };
        let same = angles(self) == angles(other) && self.timed() == other.timed();
        let by = lengths
            .iter()
            .map(|&length| other.measured(length) - self.measured(length));
        same.then(|| by.collect())
    }

    /// Returns the value of a given length; always 0 for [`Length::Across`], which is measured from
    /// the current position.
    fn measured(&self, length: Length) -> f64 {
        let on = |v: Vec2, axis: CoordinateAxis| match axis {
            CoordinateAxis::X => v.x,
            CoordinateAxis::Y => v.y,
        };
        let local = |link, point| self.link(link).local(point).unwrap_or_default();
        match length {
            Length::Link(link) => match self.link(link).ends {
                Some((_, to)) => local(link, to).x,
                None => 0.0,
            },
            Length::Local(link, point, axis) => on(local(link, point), axis),
            Length::Arm(link, point) => {
                let polar = self
                    .link(link)
                    .member(point)
                    .and_then(|member| member.polar);
                polar.map_or(0.0, |polar| polar.length)
            }
            Length::Across(..) => 0.0,
            Length::Ground(point, axis) => on(self.point(point).ground.unwrap_or_default(), axis),
            Length::Through(slide, axis) => on(self.slide(slide).through, axis),
        }
    }

    /// Returns a copy of the mechanism with another speed and acceleration of its driver.
    pub(crate) fn at_speed(&self, speed: f64, acceleration: f64) -> Mechanism {
        let mut changed = self.clone();
        let parts = Arc::make_mut(&mut changed.parts);
        (parts.driver.speed, parts.driver.acceleration) = (speed, acceleration);
        parts.typed_rates = None;
        changed
    }

    /// Returns a copy of the mechanism with one length changed by `by`. Guides named after a moved
    /// point and points measured from it move with it.
    #[must_use]
    pub fn changed(&self, length: Length, by: f64) -> Mechanism {
        self.all_changed([(length, by)])
    }

    /// Returns a copy of the mechanism with several lengths changed, as by [`Mechanism::changed`]
    /// one after another.
    #[must_use]
    pub fn all_changed(&self, changes: impl IntoIterator<Item = (Length, f64)>) -> Mechanism {
        let mut changed = Parts::clone(&self.parts);
        for (length, by) in changes {
            changed.change(length, by);
        }
        Mechanism {
            parts: Arc::new(changed),
        }
    }
}

impl Mechanism {
    /// Returns the derivatives of all given coordinates by one length, stored in place of the
    /// coordinates of a copy of the mechanism.
    pub(crate) fn slopes(&self, length: Length) -> Mechanism {
        let mut flat = Parts::clone(&self.parts);
        let grounds = flat.points.iter_mut().filter_map(|p| p.ground.as_mut());
        grounds.for_each(|position| *position = Vec2::ZERO);
        let members = flat.links.iter_mut().flat_map(|l| &mut l.members);
        members.for_each(|member| member.local = Vec2::ZERO);
        let guides = flat.slides.iter_mut();
        guides.for_each(|slide| slide.through = Vec2::ZERO);
        if let Some((link, point, way)) = self.parts.displacement_of(length) {
            flat.move_with_dependents(link, point, way);
            return Mechanism {
                parts: Arc::new(flat),
            };
        }
        let flat = Mechanism {
            parts: Arc::new(flat),
        };
        flat.changed(length, 1.0)
    }
}

impl Parts {
    fn change(&mut self, length: Length, by: f64) {
        match length {
            Length::Arm(link, point) => self.turn_arm(link, point, |polar| polar.length += by),
            Length::Across(link, point) => self.turn_arm(link, point, |polar| {
                polar.angle += (by / polar.length).to_degrees();
            }),
            Length::Ground(point, axis) => {
                if let Some(position) = &mut self.points[point.index()].ground {
                    *position += axis.along(by);
                }
                self.move_guides(Body::Ground, point, axis.along(by));
            }
            Length::Through(slide, axis) => {
                self.slides[slide.index()].through += axis.along(by);
            }
            Length::Link(..) | Length::Local(..) => {
                if let Some((link, point, way)) = self.displacement_of(length) {
                    self.move_member(link, point, way * by);
                    self.recompute_polar_points(link);
                }
            }
        }
    }

    /// Returns the point that a length on a link moves, and its displacement per unit of length.
    fn displacement_of(&self, length: Length) -> Option<(LinkId, PointId, Vec2)> {
        match length {
            Length::Link(link) => Some((link, self.links[link.index()].ends?.1, Vec2::X)),
            Length::Local(link, point, axis) => Some((link, point, axis.along(1.0))),
            Length::Arm(link, point) => Some((link, point, self.direction(link, point)?)),
            Length::Across(link, point) => Some((link, point, self.direction(link, point)?.perp())),
            Length::Ground(..) | Length::Through(..) => None,
        }
    }

    /// Returns the direction of a polar point from its reference point, as a unit vector in the
    /// link's frame.
    fn direction(&self, link: LinkId, point: PointId) -> Option<Vec2> {
        let polar = self.links[link.index()].member(point)?.polar?;
        Some(crate::angle::unit(polar.angle))
    }

    fn move_member(&mut self, link: LinkId, point: PointId, by: Vec2) {
        let mut members = self.links[link.index()].members.iter_mut();
        if let Some(member) = members.find(|m| m.point == point) {
            member.local += by;
        }
        self.move_guides(Body::Link(link), point, by);
    }

    /// Moves a point of a link and all points measured from it, by the same amount.
    fn move_with_dependents(&mut self, link: LinkId, point: PointId, by: Vec2) {
        let mut moved = HashSet::from([point]);
        // Reference points precede the points measured from them.
        for member in &self.links[link.index()].members {
            let from = member.polar.and_then(|polar| polar.from);
            if from.is_some_and(|from| moved.contains(&from)) {
                moved.insert(member.point);
            }
        }
        for point in moved {
            self.move_member(link, point, by);
        }
    }

    /// Changes the polar place of a point and updates the link.
    fn turn_arm(&mut self, link: LinkId, point: PointId, change: impl FnOnce(&mut PolarPosition)) {
        let mut members = self.links[link.index()].members.iter_mut();
        let member = members.find(|member| member.point == point);
        if let Some(polar) = member.and_then(|member| member.polar.as_mut()) {
            change(polar);
        }
        self.recompute_polar_points(link);
    }

    /// Recomputes the coordinates of a link's polar points and moves guides named after them.
    fn recompute_polar_points(&mut self, link: LinkId) {
        for (point, by) in self.links[link.index()].compute_polar_points(self.decimals) {
            self.move_guides(Body::Link(link), point, by);
        }
    }

    /// Moves the guides of a body that are named after one of its points.
    fn move_guides(&mut self, on: Body, point: PointId, by: Vec2) {
        for slide in &mut self.slides {
            if slide.on == on && slide.named == Some(point) {
                slide.through += by;
            }
        }
    }
}
