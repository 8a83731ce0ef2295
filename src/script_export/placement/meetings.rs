//! Places joints and arms in closed form: at intersections of circles and lines, and in the
//! direction of an arm that slides through a pin.

use super::super::sides::SideHistory;
use super::super::terms::{ScriptTerm, number};
use super::ScriptPlacement;
use crate::solver::Known;
use crate::{Body, Input, LinkId, PointId, Slide, SlideId, Slider};

/// A circle that contains a joint.
struct JointCircle {
    centre: PointId,
    radius: ScriptTerm,
}

/// A known line that contains a joint, with the slide that keeps the joint on it.
struct JointLine {
    through: ScriptTerm,
    direction: ScriptTerm,
    slide: SlideId,
}

impl ScriptPlacement<'_> {
    /// Places one joint or one arm in closed form; returns `false` if there is none.
    pub(super) fn close_form(&mut self, links: &[LinkId], points: &[PointId]) -> bool {
        let unknown: Vec<PointId> = points
            .iter()
            .copied()
            .filter(|&p| !self.is_known(p))
            .collect();
        unknown.iter().any(|&point| self.close_joint(point))
            || links.iter().any(|&arm| self.close_arm(arm))
    }

    fn close_joint(&mut self, joint: PointId) -> bool {
        let circles = self.circles_of(joint);
        let lines = self.lines_of(joint);
        match (&circles[..], &lines[..]) {
            ([first, second, ..], _) => self.meet_circles(joint, first, second),
            ([circle], [line, ..]) => self.meet_circle_and_line(joint, circle, line),
            ([], [first, second, ..]) => self.meet_lines(joint, first, second),
            _ => return false,
        }
        true
    }

    /// Returns the circles that contain a joint: about a known point of a link that carries it, or
    /// of the arm whose driven guide it slides along.
    fn circles_of(&self, joint: PointId) -> Vec<JointCircle> {
        let mechanism = self.mechanism();
        let carriers = mechanism.point(joint).links.iter();
        let free = carriers.filter(|&&link| !self.is_aimed(link));
        let by_link = free.filter_map(|&link| {
            let centre = self.known_member(link)?;
            let radius = self.radius(link, centre, joint);
            Some(JointCircle { centre, radius })
        });
        let mut circles: Vec<JointCircle> = by_link.collect();
        circles.extend(self.driven_circle(joint));
        circles
    }

    fn driven_circle(&self, joint: PointId) -> Option<JointCircle> {
        let mut slides = self.mechanism().slide_ids();
        let is_pushed = |&id: &SlideId| {
            let slide = self.mechanism().slide(id);
            slide.slider == Slider::Pin(joint) && self.mechanism().is_pushed(id)
        };
        let id = slides.find(is_pushed)?;
        let slide = self.mechanism().slide(id);
        let (Slider::Pin(pin), Body::Link(arm)) = (slide.slider, slide.on) else {
            return None;
        };
        if pin != joint || self.is_aimed(arm) {
            return None;
        }
        let centre = self.known_member(arm)?;
        let reach = self.driven_arm(id).minus(self.local(arm, centre));
        let radius = ScriptTerm::of(format!("abs({reach})"));
        Some(JointCircle { centre, radius })
    }

    /// Returns the place of the driven pin in the frame of its arm.
    fn driven_arm(&self, id: SlideId) -> ScriptTerm {
        let q = self.coordinate(Input::Push(id));
        self.through(id).plus(self.along(id).times(q))
    }

    /// Returns the known lines that contain a joint.
    fn lines_of(&self, joint: PointId) -> Vec<JointLine> {
        let ids = self.mechanism().slide_ids();
        ids.filter_map(|id| self.line_of(joint, id)).collect()
    }

    fn line_of(&self, joint: PointId, id: SlideId) -> Option<JointLine> {
        let slide = self.mechanism().slide(id);
        let point = slide.slider.point();
        let direction = self.direction(slide.on)?.times(self.along(id));
        let line = |through| JointLine {
            through,
            direction: direction.clone(),
            slide: id,
        };
        if point == joint {
            return self.on_body(slide.on, self.through(id)).map(line);
        }
        if let Slider::Link { link, .. } = slide.slider
            && self.mechanism().link(link).local(joint).is_some()
            && self.is_aimed(link)
        {
            let offset = self
                .direction(Body::Link(link))?
                .times(self.between(link, point, joint));
            let through = self.on_body(slide.on, self.through(id))?;
            return Some(line(through.plus(offset)));
        }
        // The guide moves with the joint, over a known point.
        let Body::Link(yoke) = slide.on else {
            return None;
        };
        if self.mechanism().link(yoke).local(joint).is_none() || !self.is_known(point) {
            return None;
        }
        let offset = self.through(id).minus(self.local(yoke, joint));
        let offset = self.direction(slide.on)?.times(offset);
        Some(line(self.point(point).minus(offset)))
    }

    fn meet_circles(&mut self, joint: PointId, first: &JointCircle, second: &JointCircle) {
        let (p, q) = (first.centre, second.centre);
        let side = self.side(move |state: Known<'_>| {
            let from = state.position(p);
            (state.position(q) - from).cross(state.position(joint) - from)
        });
        let call = format!(
            "circles({}, {}, {}, {}, {side})",
            self.point(p),
            first.radius,
            self.point(q),
            second.radius
        );
        self.place_point(joint, ScriptTerm::of(call));
    }

    fn meet_circle_and_line(&mut self, joint: PointId, circle: &JointCircle, line: &JointLine) {
        let (centre, slide) = (circle.centre, line.slide);
        let side = self.side(move |state: Known<'_>| {
            let along = state.travel(slide).guide;
            (state.position(joint) - state.position(centre)).dot(along)
        });
        let call = format!(
            "circle_line({}, {}, {}, {}, {side})",
            self.point(centre),
            circle.radius,
            line.through,
            line.direction
        );
        self.place_point(joint, ScriptTerm::of(call));
    }

    fn meet_lines(&mut self, joint: PointId, first: &JointLine, second: &JointLine) {
        let call = format!(
            "lines({}, {}, {}, {})",
            first.through, first.direction, second.through, second.direction
        );
        self.place_point(joint, ScriptTerm::of(call));
    }

    /// Places an arm about a known point that slides over a known pin, or whose driven pin is
    /// placed.
    fn close_arm(&mut self, arm: LinkId) -> bool {
        let Some(pivot) = self.known_member(arm).filter(|_| !self.is_aimed(arm)) else {
            return false;
        };
        let over_pin = |slide: &Slide| {
            let pin = slide.slider.point();
            slide.on == Body::Link(arm) && slide.slider == Slider::Pin(pin) && self.is_known(pin)
        };
        let mut slides = self.mechanism().slide_ids();
        let Some(id) = slides.find(|&id| over_pin(self.mechanism().slide(id))) else {
            return false;
        };
        let pin = self.mechanism().slide(id).slider.point();
        let seen = self.point(pin).minus(self.point(pivot));
        let term = match self.mechanism().is_pushed(id) {
            true => seen.over(self.driven_arm(id).minus(self.local(arm, pivot))),
            false => self.swung(arm, pivot, id, seen),
        };
        self.aim(arm, term);
        self.hold(arm, pivot);
        true
    }

    fn swung(&self, arm: LinkId, pivot: PointId, id: SlideId, seen: ScriptTerm) -> ScriptTerm {
        let pin = self.mechanism().slide(id).slider.point();
        let side = self.side(move |state: Known<'_>| {
            let seen = state.position(pin) - state.position(pivot);
            seen.dot(state.travel(id).guide)
        });
        let offset = self.through(id).minus(self.local(arm, pivot));
        let offset = offset.over(self.along(id));
        ScriptTerm::of(format!("swing({seen}, {offset}, {side})")).over(self.along(id))
    }

    /// Returns the side of a group as an expression of the script.
    fn side(&self, figure: impl Fn(Known<'_>) -> f64) -> String {
        let course = SideHistory::of(self.solver, figure);
        let signs = course.signs();
        if let [sign] = signs[..] {
            return sign.to_string();
        }
        let changes: Vec<String> = course.changes.iter().map(|&at| number(at)).collect();
        let signs: Vec<String> = signs.iter().map(ToString::to_string).collect();
        let period = course.period.unwrap_or(0.0);
        format!(
            "side(q, {}, [{}], [{}])",
            number(period),
            changes.join(", "),
            signs.join(", ")
        )
    }
}
