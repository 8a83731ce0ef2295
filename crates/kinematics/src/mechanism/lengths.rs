//! The lengths that a mechanism is given, one by one, and the same mechanism with one of them changed.
//!
//! What a drawing, a rule or a workshop settles is never exact; how far a figure follows such a length
//! is asked one at a time. Angles of guides and the driver's coordinate are no lengths.

use super::{Body, ElementId, LinkId, Mechanism, Parts, PointId, PolarPlace, SlideId, Slider};
use crate::Vec2;
use std::collections::HashSet;
use std::sync::Arc;

/// Along which axis a coordinate counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CoordinateAxis {
    /// Along x.
    X,
    /// Along y.
    Y,
}

impl CoordinateAxis {
    /// Both, in their order.
    pub const BOTH: [CoordinateAxis; 2] = [CoordinateAxis::X, CoordinateAxis::Y];

    fn along(self, by: f64) -> Vec2 {
        match self {
            CoordinateAxis::X => Vec2::new(by, 0.0),
            CoordinateAxis::Y => Vec2::new(0.0, by),
        }
    }
}

/// One given length, in the scene's unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Length {
    /// The length of a link between its two natural ends.
    Link(LinkId),
    /// A coordinate of a further point of a link, in the link's frame.
    Local(LinkId, PointId, CoordinateAxis),
    /// How far a point of a link is from the one that it is seen from, where it was given by length and angle.
    Arm(LinkId, PointId),
    /// How far the angle of such a point takes it across that length.
    Across(LinkId, PointId),
    /// A coordinate of a ground point.
    Ground(PointId, CoordinateAxis),
    /// A coordinate of the point that a guide runs through, in the frame of what carries the guide,
    /// where it is given by coordinates and not by a point's name.
    Through(SlideId, CoordinateAxis),
}

impl Length {
    /// The element that the length belongs to.
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
    /// All given lengths: the ground's, the links' and the slides', each in the order of the file.
    ///
    /// The place of a link's own origin is none: where `from` or what slides along a guide lies is how
    /// the link's frame is defined.
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

    /// The longest length of a link, or between its points, in the scene's unit; 1 where there is none.
    pub fn reach(&self) -> f64 {
        let members = self.links().iter().flat_map(|link| &link.members);
        let longest = members
            .map(|member| member.local.norm())
            .fold(0.0, f64::max);
        if longest > 0.0 { longest } else { 1.0 }
    }

    /// How long a length is as it is given: of a coordinate its value, of what an angle takes a point across, how far
    /// that point is.
    #[must_use]
    pub fn given(&self, length: Length) -> f64 {
        let along = |place: Vec2, axis| match axis {
            CoordinateAxis::X => place.x,
            CoordinateAxis::Y => place.y,
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

    /// By how much each of all lengths is longer in another mechanism of the same parts; `None` where that moves
    /// otherwise for more: for an angle of a guide or of a point, or for how an input follows the driver.
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

    /// A given length; of [`Length::Across`] always 0, since it is counted from where the point lies.
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

    /// The same mechanism with another speed and acceleration of its driver.
    pub(crate) fn at_speed(&self, speed: f64, acceleration: f64) -> Mechanism {
        let mut changed = self.clone();
        let parts = Arc::make_mut(&mut changed.parts);
        (parts.driver.speed, parts.driver.acceleration) = (speed, acceleration);
        parts.typed_rates = None;
        changed
    }

    /// The same mechanism with one length changed by so much; a guide that is named after a point goes
    /// with it, and so do points that are seen from it.
    #[must_use]
    pub fn changed(&self, length: Length, by: f64) -> Mechanism {
        let mut changed = Parts::clone(&self.parts);
        match length {
            Length::Arm(link, point) => changed.turn_arm(link, point, |polar| polar.length += by),
            Length::Across(link, point) => changed.turn_arm(link, point, |polar| {
                polar.angle += (by / polar.length).to_degrees();
            }),
            Length::Ground(point, axis) => {
                if let Some(place) = &mut changed.points[point.index()].ground {
                    *place += axis.along(by);
                }
                changed.move_guides(Body::Ground, point, axis.along(by));
            }
            Length::Through(slide, axis) => {
                changed.slides[slide.index()].through += axis.along(by);
            }
            Length::Link(..) | Length::Local(..) => {
                if let Some((link, point, way)) = self.way_of(length) {
                    changed.move_member(link, point, way * by);
                    changed.lay(link);
                }
            }
        }
        Mechanism {
            parts: Arc::new(changed),
        }
    }

    /// Of a length on a link: which point it moves, and how far per unit of length.
    fn way_of(&self, length: Length) -> Option<(LinkId, PointId, Vec2)> {
        match length {
            Length::Link(link) => Some((link, self.link(link).ends?.1, Vec2::X)),
            Length::Local(link, point, axis) => Some((link, point, axis.along(1.0))),
            Length::Arm(link, point) => Some((link, point, self.direction(link, point)?)),
            Length::Across(link, point) => Some((link, point, self.direction(link, point)?.perp())),
            Length::Ground(..) | Length::Through(..) => None,
        }
    }

    /// In which direction a point by length and angle is seen, in the frame of its link.
    fn direction(&self, link: LinkId, point: PointId) -> Option<Vec2> {
        let polar = self.link(link).member(point)?.polar?;
        Some(crate::angle::unit(polar.angle))
    }
}

impl Mechanism {
    /// What one length does to every given coordinate: the same mechanism with the derivatives by it in the
    /// place of the coordinates.
    pub(crate) fn slopes(&self, length: Length) -> Mechanism {
        let mut flat = Parts::clone(&self.parts);
        let grounds = flat.points.iter_mut().filter_map(|p| p.ground.as_mut());
        grounds.for_each(|place| *place = Vec2::ZERO);
        let members = flat.links.iter_mut().flat_map(|l| &mut l.members);
        members.for_each(|member| member.local = Vec2::ZERO);
        let guides = flat.slides.iter_mut();
        guides.for_each(|slide| slide.through = Vec2::ZERO);
        if let Some((link, point, way)) = self.way_of(length) {
            flat.move_seen(link, point, way);
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
    fn move_member(&mut self, link: LinkId, point: PointId, by: Vec2) {
        let mut members = self.links[link.index()].members.iter_mut();
        if let Some(member) = members.find(|m| m.point == point) {
            member.local += by;
        }
        self.move_guides(Body::Link(link), point, by);
    }

    /// Moves a point of a link and all that are seen from it, by as much.
    fn move_seen(&mut self, link: LinkId, point: PointId, by: Vec2) {
        let mut moved = HashSet::from([point]);
        // What others are seen from comes before them.
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

    /// Changes by what a point is seen.
    fn turn_arm(&mut self, link: LinkId, point: PointId, change: impl FnOnce(&mut PolarPlace)) {
        let mut members = self.links[link.index()].members.iter_mut();
        let member = members.find(|member| member.point == point);
        if let Some(polar) = member.and_then(|member| member.polar.as_mut()) {
            change(polar);
        }
        self.lay(link);
    }

    /// Lays the points of a link that are given by length and angle anew, and takes guides along.
    fn lay(&mut self, link: LinkId) {
        for (point, by) in self.links[link.index()].lay(self.decimals) {
            self.move_guides(Body::Link(link), point, by);
        }
    }

    /// The guides of a body that are named after one of its points.
    fn move_guides(&mut self, on: Body, point: PointId, by: Vec2) {
        for slide in &mut self.slides {
            if slide.on == on && slide.named == Some(point) {
                slide.through += by;
            }
        }
    }
}
