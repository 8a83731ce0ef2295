//! Builds the constraint graph of a mechanism: the unknowns, and the equations between them.
//!
//! The unknowns are the two coordinates of every moving joint, and one direction for every class of
//! links locked on slides, which keep their angles to each other. A link with k joints gives 2 (k -
//! 1) equations, a slot one. Points that are not joints have no equations: they ride on a link.

use crate::solver::frame::Frame;
use crate::solver::further_inputs::Following;
use crate::{
    Body, Constant, ElementId, Input, Length, Link, LinkId, Mechanism, PointId, SlideId, Slider,
    Vec2,
};

/// A class of links with constant angles between them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(in crate::solver) struct ClassId(pub(in crate::solver) usize);

/// The class of the ground.
pub(in crate::solver) const GROUND: ClassId = ClassId(0);

/// A scalar equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(in crate::solver) enum ScalarEquation {
    /// The distance of a link's joint from the link's centre joint.
    Along { link: LinkId, end: PointId },
    /// The direction from the link's centre joint to one of its other joints.
    Across { link: LinkId, end: PointId },
    /// The condition that a point lies on its guide.
    Slot(SlideId),
    /// A driven slide's position along its guide.
    Push(SlideId),
    /// The angle between a link driven by an input and another moving link.
    Elbow(LinkId),
}

impl ScalarEquation {
    /// Returns the element to which the equation belongs.
    pub(in crate::solver) fn element(self) -> ElementId {
        match self {
            ScalarEquation::Along { link, .. } | ScalarEquation::Across { link, .. } => {
                ElementId::Link(link)
            }
            ScalarEquation::Elbow(link) => ElementId::Link(link),
            ScalarEquation::Slot(slide) | ScalarEquation::Push(slide) => ElementId::Slide(slide),
        }
    }
}

/// A scalar unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::solver) enum ScalarUnknown {
    /// A coordinate of a joint.
    Point(PointId),
    /// The direction of a class of links.
    Class(ClassId),
}

/// Two locks that fix one link at two different angles.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct LockConflict {
    pub slide: SlideId,
    /// The sine of the angle between the two.
    pub misfit: f64,
}

/// The constraint graph.
#[derive(Clone, Debug)]
pub(in crate::solver) struct Network<'m> {
    pub mechanism: &'m Mechanism,
    /// The frame in which the mechanism's numbers are read.
    pub frame: Frame,
    /// How each further input follows the driver, in input order.
    input_laws: Vec<Following>,
    /// How the driver moves, if every input moves by itself.
    driver_law: Option<Following>,
    /// For derivatives by a length: the mechanism with each coordinate replaced by its derivative.
    slopes: Option<Mechanism>,
    /// The class of every link, followed by that of the ground.
    pub class_of: Vec<ClassId>,
    /// The unit vector of a link's direction relative to its class.
    pub turn: Vec<Vec2<Constant>>,
    pub members: Vec<Vec<LinkId>>,
    /// The joint from which a link's other joints are measured.
    centre: Vec<Option<PointId>>,
    joint: Vec<bool>,
    pub rows: Vec<ScalarEquation>,
    /// Redundant locks that agree with the others within the tolerance.
    pub repeated_locks: Vec<SlideId>,
    /// The largest sine by which these locks disagree.
    pub lock_disagreement: f64,
    pub conflict: Option<LockConflict>,
    /// The maximum sine by which two locks of one link may disagree.
    slack: f64,
    /// Whether lengths change later, so that coincident points may separate.
    pub is_varied: bool,
}

impl<'m> Network<'m> {
    pub(in crate::solver) fn new(mechanism: &'m Mechanism, frame: Frame) -> Self {
        let bodies = mechanism.links().len() + 1;
        let mut network = Network {
            mechanism,
            frame,
            input_laws: Following::all(mechanism, &frame),
            driver_law: None,
            slopes: None,
            class_of: vec![GROUND; bodies],
            turn: vec![Vec2::X.exactly(); bodies],
            members: Vec::new(),
            centre: Vec::new(),
            joint: Vec::new(),
            rows: Vec::new(),
            repeated_locks: Vec::new(),
            lock_disagreement: 0.0,
            conflict: None,
            slack: slack(mechanism, &frame),
            is_varied: false,
        };
        network.find_classes();
        network.find_joints();
        network.list_rows();
        network
    }

    /// Returns the network with derivatives by one length: each position carries its slope.
    pub(in crate::solver) fn by_length(self, length: Length) -> Self {
        Network {
            slopes: Some(self.mechanism.slopes(length)),
            ..self
        }
    }

    /// Returns the network for variable lengths: see [`crate::solver::Varied`].
    pub(in crate::solver) fn varied(self) -> Self {
        Network {
            is_varied: true,
            ..self
        }
    }

    /// Returns the network in which every input moves by itself: see [`crate::solver::FreeInputs`].
    pub(in crate::solver) fn free(self) -> Self {
        let further = 1..=self.input_laws.len();
        Network {
            input_laws: further.map(Following::free).collect(),
            driver_law: Some(Following::free(0)),
            ..self
        }
    }

    /// Returns `true` if the driver's coordinate is the link's direction, and the parameter of the
    /// motion.
    pub(in crate::solver) fn is_crank(&self, link: LinkId) -> bool {
        self.mechanism.is_crank(link) && self.driver_law.is_none()
    }

    /// Returns the position of a point on a link, in the solver's unit; `None` if the link does not
    /// have it.
    pub(in crate::solver) fn local(&self, link: LinkId, point: PointId) -> Option<Vec2<Constant>> {
        let position = self.frame.member(self.link(link)?.member(point)?);
        Some(self.sloped(position, |m| m.links().get(link.index())?.local(point)))
    }

    /// Returns all points of a link with their positions on it, without a search for each.
    pub(in crate::solver) fn places(
        &self,
        link: LinkId,
    ) -> impl Iterator<Item = (PointId, Vec2<Constant>)> + '_ {
        let members = self.link(link).map_or(&[][..], |l| &l.members);
        members.iter().enumerate().map(move |(i, member)| {
            let slope = |m: &Mechanism| Some(m.links().get(link.index())?.members.get(i)?.local);
            let position = self.frame.member(member);
            (member.point, self.sloped(position, slope))
        })
    }

    /// Returns the vector between two points of a link, in the link's frame.
    pub(in crate::solver) fn between(
        &self,
        link: LinkId,
        from: PointId,
        to: PointId,
    ) -> Option<Vec2<Constant>> {
        Some(self.local(link, to)? - self.local(link, from)?)
    }

    /// Returns the position of a ground point in the solver's frame; `None` for a moving point.
    pub(in crate::solver) fn fixed(&self, point: PointId) -> Option<Vec2<Constant>> {
        let fixed = |mechanism: &Mechanism| mechanism.point(point).ground;
        let position = self.frame.inner(fixed(self.mechanism)?);
        Some(self.sloped(position, fixed))
    }

    /// Returns the point through which a guide runs, in the frame of the guide's body.
    pub(in crate::solver) fn through(&self, slide: SlideId) -> Vec2<Constant> {
        let given = self.mechanism.slide(slide);
        let position = match (given.on, self.mechanism.polar_through(given)) {
            (Body::Ground, _) => self.frame.inner(given.through),
            // It is as accurate as the point after which it is named.
            (Body::Link(_), Some(member)) => self.frame.member(member),
            (Body::Link(_), None) => self.frame.local(given.through),
        };
        self.sloped(position, |m| Some(m.slide(slide).through))
    }

    /// Adds the derivative by the selected length, if any, to a position: per unit of the scene's
    /// length.
    fn sloped(
        &self,
        position: Vec2<Constant>,
        of: impl Fn(&Mechanism) -> Option<Vec2>,
    ) -> Vec2<Constant> {
        let Some(slope) = self.slopes.as_ref().and_then(of) else {
            return position;
        };
        let by = slope / self.frame.scale;
        Vec2::new(position.x.with_slope(by.x), position.y.with_slope(by.y))
    }

    /// Returns the ground as a body: its index follows that of the last link.
    pub(in crate::solver) fn ground(&self) -> LinkId {
        LinkId::new(self.mechanism.links().len())
    }

    /// Returns the body of a guide.
    pub(in crate::solver) fn body(&self, body: Body) -> LinkId {
        match body {
            Body::Ground => self.ground(),
            Body::Link(link) => link,
        }
    }

    pub(in crate::solver) fn link(&self, link: LinkId) -> Option<&'m Link> {
        self.mechanism.links().get(link.index())
    }

    /// Returns the joint from which a body's other joints are measured; `None` for the ground.
    pub(in crate::solver) fn centre(&self, body: LinkId) -> Option<PointId> {
        self.centre.get(body.index()).copied().flatten()
    }

    pub(in crate::solver) fn class(&self, link: LinkId) -> ClassId {
        self.class_of[link.index()]
    }

    pub(in crate::solver) fn is_joint(&self, point: PointId) -> bool {
        self.joint[point.index()]
    }

    pub(in crate::solver) fn is_ground(&self, point: PointId) -> bool {
        self.mechanism.point(point).ground.is_some()
    }

    /// Returns the joints of a link, with their local coordinates.
    pub(in crate::solver) fn joints(
        &self,
        link: LinkId,
    ) -> impl Iterator<Item = crate::Member> + '_ {
        let members = self.link(link).map_or(&[][..], |l| &l.members);
        members.iter().copied().filter(|m| self.is_joint(m.point))
    }

    /// Returns the direction of `link` relative to `other`, of the same class.
    pub(in crate::solver) fn turn_between(&self, link: LinkId, other: LinkId) -> Vec2<Constant> {
        self.turn[link.index()].turned(self.turn[other.index()].conj())
    }

    /// Walks the locks from body to body, and sets each body's class and its angle in the class.
    fn find_classes(&mut self) {
        let locks = self.locks();
        let mut seen = vec![false; self.class_of.len()];
        let mut walked = vec![false; self.mechanism.slides().len()];
        let order = std::iter::once(self.ground()).chain(self.mechanism.link_ids());
        for first in order {
            if seen[first.index()] {
                continue;
            }
            let class = ClassId(self.members.len());
            self.members.push(Vec::new());
            seen[first.index()] = true;
            let mut waiting = vec![first];
            while let Some(body) = waiting.pop() {
                self.class_of[body.index()] = class;
                self.members[class.0].push(body);
                for &(other, turn, slide) in &locks[body.index()] {
                    if std::mem::replace(&mut walked[slide.index()], true) {
                        continue;
                    }
                    let expected = turn.turned(self.turn[body.index()]);
                    if seen[other.index()] {
                        let misfit = expected.cross(self.turn[other.index()]);
                        self.note_repeated_lock(slide, misfit.hi);
                    } else {
                        seen[other.index()] = true;
                        self.turn[other.index()] = expected;
                        waiting.push(other);
                    }
                }
            }
        }
    }

    /// Returns for each body the bodies locked to it, with their relative direction and the slide.
    fn locks(&self) -> Vec<Vec<(LinkId, Vec2<Constant>, SlideId)>> {
        let mut locks = vec![Vec::new(); self.class_of.len()];
        for slide in self.mechanism.slide_ids() {
            let given = self.mechanism.slide(slide);
            if let Slider::Link { link, turn, .. } = given.slider {
                let on = self.body(given.on);
                let seen = self.frame.unit(given.angle).turned(self.frame.unit(turn));
                locks[on.index()].push((link, seen, slide));
                locks[link.index()].push((on, seen.conj(), slide));
            }
        }
        locks
    }

    /// Records a lock between two bodies whose angle is already determined.
    fn note_repeated_lock(&mut self, slide: SlideId, misfit: f64) {
        if misfit.abs() > self.slack {
            self.conflict = Some(LockConflict { slide, misfit });
        } else {
            self.lock_disagreement = self.lock_disagreement.max(misfit.abs());
            self.repeated_locks.push(slide);
        }
    }

    fn find_joints(&mut self) {
        let mechanism = self.mechanism;
        let mut meetings: Vec<usize> = mechanism
            .points()
            .iter()
            .map(|p| p.links.len() + usize::from(p.ground.is_some()))
            .collect();
        for slide in mechanism.slides() {
            meetings[slide.slider.point().index()] += 1;
        }
        self.joint = meetings.iter().map(|&m| m >= 2).collect();
        for link in mechanism.links() {
            // A link without any joint still needs a position.
            let hangs = link.members.iter().any(|m| self.joint[m.point.index()]);
            if let (false, Some(first)) = (hangs, link.members.first()) {
                self.joint[first.point.index()] = true;
            }
        }
        self.centre = mechanism
            .link_ids()
            .map(|link| {
                let mut joints = self.joints(link).map(|m| m.point);
                let first = joints.next();
                first
                    .filter(|&p| self.is_ground(p))
                    .or_else(|| joints.find(|&p| self.is_ground(p)))
                    .or(first)
            })
            .collect();
    }

    fn list_rows(&mut self) {
        let mut rows = Vec::new();
        // Among redundant equations the last ones are set aside.
        let mut links: Vec<LinkId> = self.mechanism.link_ids().collect();
        links.sort_by_key(|&link| self.mechanism.link_rank(link));
        for link in links {
            for member in self
                .joints(link)
                .filter(|m| Some(m.point) != self.centre[link.index()])
            {
                let end = member.point;
                rows.push(ScalarEquation::Along { link, end });
                rows.push(ScalarEquation::Across { link, end });
            }
        }
        for slide in self.mechanism.slide_ids() {
            rows.push(ScalarEquation::Slot(slide));
            if self.mechanism.is_pushed(slide) {
                rows.push(ScalarEquation::Push(slide));
            }
        }
        let elbows = self.mechanism.elbows();
        rows.extend(elbows.map(|(link, _)| ScalarEquation::Elbow(link)));
        self.rows = rows;
    }

    /// Returns the two bodies between which an input sets the angle: the link it turns, and the one
    /// that carries its motor.
    pub(in crate::solver) fn elbow(&self, link: LinkId) -> [LinkId; 2] {
        [link, self.body(self.mechanism.turned_from(link))]
    }

    /// Returns `true` if the direction of a class is known: that of the ground or of a driven link.
    pub(in crate::solver) fn is_given(&self, class: ClassId) -> bool {
        class == GROUND
            || self
                .mechanism
                .inputs()
                .any(|input| self.gives(input, class))
    }

    /// Returns `true` if an input sets the direction of a class.
    fn gives(&self, input: Input, class: ClassId) -> bool {
        match input {
            Input::Turn(link) => {
                self.class(link) == class && self.mechanism.turned_from(link) == Body::Ground
            }
            Input::Push(_) => false,
        }
    }

    /// Returns a link turned by an input relative to a body with which its angle is locked.
    pub(in crate::solver) fn locked_elbow(&self) -> Option<[LinkId; 2]> {
        let elbows = self.mechanism.elbows().map(|(link, _)| self.elbow(link));
        let mut elbows = elbows.into_iter();
        elbows.find(|&[link, from]| self.class(link) == self.class(from))
    }

    /// Returns a link whose direction is set by an input though another input sets it, or it cannot
    /// turn.
    pub(in crate::solver) fn given_twice(&self) -> Option<LinkId> {
        let mut given = vec![GROUND];
        self.mechanism
            .inputs()
            .skip(1)
            .find_map(|input| match input {
                Input::Turn(link) if self.mechanism.is_directed(link) => {
                    let class = self.class(link);
                    let driver = self.mechanism.driver().input;
                    let is_taken = given.contains(&class) || self.gives(driver, class);
                    given.push(class);
                    is_taken.then_some(link)
                }
                Input::Turn(_) | Input::Push(_) => None,
            })
    }

    /// Returns a link that has two ground points at one of its places, and the distance of the
    /// points on the ground, in the scene's unit. It has no direction that fits both.
    pub(in crate::solver) fn coincident_pins(&self) -> Option<(LinkId, f64)> {
        let mechanism = self.mechanism;
        mechanism.link_ids().find_map(|link| {
            let members = mechanism.link(link).members.iter();
            let mut pins =
                members.filter_map(|m| Some((m.local, mechanism.point(m.point).ground?)));
            let (local, ground) = pins.next()?;
            let same_place = pins.filter(|&(other, _)| other == local);
            let mut distances = same_place.map(|(_, at)| (at - ground).norm());
            let apart = distances.find(|&distance| distance > mechanism.misfit())?;
            Some((link, apart))
        })
    }

    /// Returns how an input follows the driver; `None` for the driver itself, unless every input
    /// moves by itself.
    pub(in crate::solver) fn following(&self, input: Input) -> Option<&Following> {
        if input == self.mechanism.driver().input {
            return self.driver_law.as_ref();
        }
        let mut timed = self.mechanism.timed().iter();
        self.input_laws
            .get(timed.position(|timed| timed.input == input)?)
    }

    /// Returns the links that further inputs turn relative to the ground, with the way they follow
    /// the driver.
    pub(in crate::solver) fn timed_links(&self) -> impl Iterator<Item = (LinkId, &Following)> + '_ {
        let timed = self.mechanism.timed().iter().zip(&self.input_laws);
        timed.filter_map(|(timed, following)| match timed.input {
            Input::Turn(link) if self.mechanism.is_directed(link) => Some((link, following)),
            Input::Turn(_) | Input::Push(_) => None,
        })
    }

    /// Returns the unknowns of an equation. Each point represents its two coordinates.
    pub(in crate::solver) fn unknowns(&self, row: ScalarEquation) -> Vec<ScalarUnknown> {
        let (body, point) = match row {
            ScalarEquation::Along { link, end } | ScalarEquation::Across { link, end } => {
                (link, end)
            }
            ScalarEquation::Slot(slide) | ScalarEquation::Push(slide) => {
                let slide = self.mechanism.slide(slide);
                (self.body(slide.on), slide.slider.point())
            }
            ScalarEquation::Elbow(link) => {
                let classes = self.elbow(link).map(|body| self.class(body));
                let wanted_unknowns = classes.into_iter().filter(|&class| !self.is_given(class));
                return wanted_unknowns.map(ScalarUnknown::Class).collect();
            }
        };
        let points = [Some(point), self.centre(body)].into_iter().flatten();
        let mut unknowns: Vec<ScalarUnknown> = points
            .filter(|&p| !self.is_ground(p))
            .map(ScalarUnknown::Point)
            .collect();
        let class = self.class(body);
        if !self.is_given(class) {
            unknowns.push(ScalarUnknown::Class(class));
        }
        unknowns
    }

    /// Returns how readily an equation is set aside if there are too many. First comes the length
    /// of a bar inside another body, since it must repeat that body's lengths. The length of any
    /// other bar is second, and a slot is third, since the rest of the element can still be placed
    /// without it.
    pub(in crate::solver) fn readiness(&self, row: ScalarEquation) -> u8 {
        match row {
            ScalarEquation::Along { link, .. } if self.is_strut(link) => 4,
            ScalarEquation::Along { link, .. } if self.is_bar(link) => 3,
            ScalarEquation::Slot(_) => 2,
            ScalarEquation::Along { .. } => 1,
            ScalarEquation::Across { .. } | ScalarEquation::Push(_) | ScalarEquation::Elbow(_) => 0,
        }
    }

    /// Returns `true` if both joints of a bar belong to one other body.
    fn is_strut(&self, link: LinkId) -> bool {
        let ends: Vec<PointId> = self.joints(link).map(|m| m.point).collect();
        let [a, b] = ends[..] else { return false };
        let points = [a, b].map(|p| self.mechanism.point(p));
        let share = |l: &LinkId| *l != link && points[1].links.contains(l);
        let is_inner =
            points.iter().all(|p| p.ground.is_some()) || points[0].links.iter().any(share);
        is_inner && self.is_bar(link)
    }

    /// Returns `true` if a link is only a distance between two joints.
    pub(in crate::solver) fn is_bar(&self, link: LinkId) -> bool {
        let carries_guide = self
            .mechanism
            .slides()
            .iter()
            .any(|s| s.on == Body::Link(link));
        let is_elbow = self
            .mechanism
            .elbows()
            .any(|(turned, from)| turned == link || from == link);
        self.joints(link).count() == 2
            && !carries_guide
            && !is_elbow
            && self.members[self.class(link).0].len() == 1
            && !self.is_given(self.class(link))
    }
}

/// Returns the maximum sine by which two locks of one link may disagree. It is the rounding error
/// of a few products of unit vectors, or the scene's accepted misfit at the end of the longest
/// length if larger.
fn slack(mechanism: &Mechanism, frame: &Frame) -> f64 {
    const ROUNDING: f64 = 16.0 * f64::EPSILON;
    let accepted = frame.length(mechanism.misfit()) / frame.longest;
    if accepted > ROUNDING {
        accepted
    } else {
        ROUNDING
    }
}
