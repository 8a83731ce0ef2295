//! The constraint graph of a mechanism: which unknowns there are, and which equation ties which.
//!
//! The unknowns are the two coordinates of every moving joint and one direction for every class of
//! links that keep their angles to each other (links locked on slides). A link of k joints gives
//! 2 (k - 1) equations, a slot one. Points that are no joints take no part: they ride.

use super::following::Following;
use super::frame::Frame;
use crate::{
    Body, Constant, ElementId, Input, Length, Link, LinkId, Mechanism, PointId, SlideId, Slider,
    Vec2,
};

/// A class of links that keep their angles to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct ClassId(pub(super) usize);

/// The class of the ground.
pub(super) const GROUND: ClassId = ClassId(0);

/// One scalar equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum ScalarEquation {
    /// The distance of a link's joint from the link's centre joint.
    Along { link: LinkId, end: PointId },
    /// The direction in which it is seen from there.
    Across { link: LinkId, end: PointId },
    /// A point on its guide.
    Slot(SlideId),
    /// A driven slide's position along its guide.
    Push(SlideId),
    /// The angle of a link that an input turns against another one.
    Elbow(LinkId),
}

impl ScalarEquation {
    /// The element that the equation belongs to.
    pub(super) fn element(self) -> ElementId {
        match self {
            ScalarEquation::Along { link, .. } | ScalarEquation::Across { link, .. } => {
                ElementId::Link(link)
            }
            ScalarEquation::Elbow(link) => ElementId::Link(link),
            ScalarEquation::Slot(slide) | ScalarEquation::Push(slide) => ElementId::Slide(slide),
        }
    }
}

/// One scalar unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ScalarUnknown {
    /// A coordinate of a joint.
    Point(PointId),
    /// The direction of a class of links.
    Class(ClassId),
}

/// Two locks that hold one link at two different angles.
#[derive(Clone, Copy, Debug)]
pub(super) struct LockClash {
    pub slide: SlideId,
    /// The sine of the angle between them.
    pub misfit: f64,
}

/// The constraint graph.
#[derive(Clone, Debug)]
pub(super) struct Network<'m> {
    pub mechanism: &'m Mechanism,
    /// In which its numbers are read.
    pub frame: Frame,
    /// How the further inputs follow the driver, in their order.
    followings: Vec<Following>,
    /// What the length that is asked about does to every coordinate, in the place of the coordinates.
    slopes: Option<Mechanism>,
    /// For every link, and for the ground behind them.
    pub class_of: Vec<ClassId>,
    /// The direction of a link as seen from that of its class.
    pub turn: Vec<Vec2<Constant>>,
    pub members: Vec<Vec<LinkId>>,
    /// The joint from which a link's other joints are seen.
    centre: Vec<Option<PointId>>,
    joint: Vec<bool>,
    pub rows: Vec<ScalarEquation>,
    /// Locks that repeat others, and agree with them as far as it matters.
    pub repeated_locks: Vec<SlideId>,
    /// The largest sine by which these disagree.
    pub locks_apart: f64,
    pub clash: Option<LockClash>,
    /// By what sine two locks of one link may disagree.
    slack: f64,
    /// Whether lengths are to be changed later: a point at another one does not stay there.
    pub is_varied: bool,
}

impl<'m> Network<'m> {
    pub(super) fn new(mechanism: &'m Mechanism, frame: Frame) -> Self {
        let bodies = mechanism.links().len() + 1;
        let mut network = Network {
            mechanism,
            frame,
            followings: Following::all(mechanism, &frame),
            slopes: None,
            class_of: vec![GROUND; bodies],
            turn: vec![Vec2::X.exactly(); bodies],
            members: Vec::new(),
            centre: Vec::new(),
            joint: Vec::new(),
            rows: Vec::new(),
            repeated_locks: Vec::new(),
            locks_apart: 0.0,
            clash: None,
            slack: slack(mechanism, &frame),
            is_varied: false,
        };
        network.find_classes();
        network.find_joints();
        network.list_rows();
        network
    }

    /// The same, asked about one length: every place has its derivative by it.
    pub(super) fn by_length(self, length: Length) -> Self {
        Network {
            slopes: Some(self.mechanism.slopes(length)),
            ..self
        }
    }

    /// The same, to be made into what lengths are changed of: see [`super::Varied`].
    pub(super) fn varied(self) -> Self {
        Network {
            is_varied: true,
            ..self
        }
    }

    /// The place of a point on a link, in the solver's unit.
    pub(super) fn local(&self, link: LinkId, point: PointId) -> Option<Vec2<Constant>> {
        let place = self.frame.member(self.link(link)?.member(point)?);
        Some(self.sloped(place, |m| m.links().get(link.index())?.local(point)))
    }

    /// All points of a link with their places on it: each found at once, however many there are.
    pub(super) fn places(
        &self,
        link: LinkId,
    ) -> impl Iterator<Item = (PointId, Vec2<Constant>)> + '_ {
        let members = self.link(link).map_or(&[][..], |l| &l.members);
        members.iter().enumerate().map(move |(i, member)| {
            let slope = |m: &Mechanism| Some(m.links().get(link.index())?.members.get(i)?.local);
            let place = self.frame.member(member);
            (member.point, self.sloped(place, slope))
        })
    }

    /// From one point of a link to another, in the frame of the link.
    pub(super) fn between(
        &self,
        link: LinkId,
        from: PointId,
        to: PointId,
    ) -> Option<Vec2<Constant>> {
        Some(self.local(link, to)? - self.local(link, from)?)
    }

    /// The place of a ground point in the solver's frame; `None` of one that moves.
    pub(super) fn fixed(&self, point: PointId) -> Option<Vec2<Constant>> {
        let fixed = |mechanism: &Mechanism| mechanism.point(point).ground;
        let place = self.frame.inner(fixed(self.mechanism)?);
        Some(self.sloped(place, fixed))
    }

    /// The point that a guide runs through, in the frame of what carries it.
    pub(super) fn through(&self, slide: SlideId) -> Vec2<Constant> {
        let given = self.mechanism.slide(slide);
        let place = match (given.on, self.mechanism.polar_through(given)) {
            (Body::Ground, _) => self.frame.inner(given.through),
            // As well known as the point that it was named after.
            (Body::Link(_), Some(member)) => self.frame.member(member),
            (Body::Link(_), None) => self.frame.local(given.through),
        };
        self.sloped(place, |m| Some(m.slide(slide).through))
    }

    /// A place with what the length that is asked about does to it: per unit of the scene's length.
    fn sloped(
        &self,
        place: Vec2<Constant>,
        of: impl Fn(&Mechanism) -> Option<Vec2>,
    ) -> Vec2<Constant> {
        let Some(slope) = self.slopes.as_ref().and_then(of) else {
            return place;
        };
        let by = slope / self.frame.scale;
        Vec2::new(place.x.with_slope(by.x), place.y.with_slope(by.y))
    }

    /// The ground as a body: the link behind the last one.
    pub(super) fn ground(&self) -> LinkId {
        LinkId::new(self.mechanism.links().len())
    }

    /// The body of a guide.
    pub(super) fn body(&self, body: Body) -> LinkId {
        match body {
            Body::Ground => self.ground(),
            Body::Link(link) => link,
        }
    }

    pub(super) fn link(&self, link: LinkId) -> Option<&'m Link> {
        self.mechanism.links().get(link.index())
    }

    /// The joint from which a body's other joints are seen; the ground has none.
    pub(super) fn centre(&self, body: LinkId) -> Option<PointId> {
        self.centre.get(body.index()).copied().flatten()
    }

    pub(super) fn class(&self, link: LinkId) -> ClassId {
        self.class_of[link.index()]
    }

    pub(super) fn is_joint(&self, point: PointId) -> bool {
        self.joint[point.index()]
    }

    pub(super) fn is_ground(&self, point: PointId) -> bool {
        self.mechanism.point(point).ground.is_some()
    }

    /// The joints of a link, with their local coordinates.
    pub(super) fn joints(&self, link: LinkId) -> impl Iterator<Item = crate::Member> + '_ {
        let members = self.link(link).map_or(&[][..], |l| &l.members);
        members.iter().copied().filter(|m| self.is_joint(m.point))
    }

    /// The direction of `link` as seen from `other` of the same class.
    pub(super) fn turn_between(&self, link: LinkId, other: LinkId) -> Vec2<Constant> {
        self.turn[link.index()].turned(self.turn[other.index()].conj())
    }

    /// Walks the locks from body to body and gives each its class and its angle in the class.
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

    /// For every body the bodies locked to it, the direction in which each is seen, and the slide.
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

    /// A lock between two bodies whose angle is settled already.
    fn note_repeated_lock(&mut self, slide: SlideId, misfit: f64) {
        if misfit.abs() > self.slack {
            self.clash = Some(LockClash { slide, misfit });
        } else {
            self.locks_apart = self.locks_apart.max(misfit.abs());
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
            // A link that hangs on nothing still has a place to be found.
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
        // Of equations that repeat each other the last ones are set aside.
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

    /// The directions that an input keeps apart: of the link that it turns, and of the one that its motor sits on.
    pub(super) fn elbow(&self, link: LinkId) -> [LinkId; 2] {
        [link, self.body(self.mechanism.turned_from(link))]
    }

    /// Whether a class's direction is given from the start: the ground's, and that of a driven link.
    pub(super) fn is_given(&self, class: ClassId) -> bool {
        class == GROUND
            || self
                .mechanism
                .inputs()
                .any(|input| self.gives(input, class))
    }

    /// Whether an input gives the direction of a class.
    fn gives(&self, input: Input, class: ClassId) -> bool {
        match input {
            Input::Turn(link) => {
                self.class(link) == class && self.mechanism.turned_from(link) == Body::Ground
            }
            Input::Push(_) => false,
        }
    }

    /// A link that an input turns against one to which it keeps its angle.
    pub(super) fn locked_elbow(&self) -> Option<[LinkId; 2]> {
        let elbows = self.mechanism.elbows().map(|(link, _)| self.elbow(link));
        let mut elbows = elbows.into_iter();
        elbows.find(|&[link, from]| self.class(link) == self.class(from))
    }

    /// A link whose direction is given, though another input gives it, or it cannot turn.
    pub(super) fn given_twice(&self) -> Option<LinkId> {
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

    /// How an input follows the driver; `None` of the driver itself.
    pub(super) fn following(&self, input: Input) -> Option<&Following> {
        let mut timed = self.mechanism.timed().iter();
        self.followings
            .get(timed.position(|timed| timed.input == input)?)
    }

    /// The links that further inputs turn against the ground, and how these follow the driver.
    pub(super) fn timed_links(&self) -> impl Iterator<Item = (LinkId, &Following)> + '_ {
        let timed = self.mechanism.timed().iter().zip(&self.followings);
        timed.filter_map(|(timed, following)| match timed.input {
            Input::Turn(link) if self.mechanism.is_directed(link) => Some((link, following)),
            Input::Turn(_) | Input::Push(_) => None,
        })
    }

    /// The unknowns of an equation: each point stands for its two coordinates.
    pub(super) fn unknowns(&self, row: ScalarEquation) -> Vec<ScalarUnknown> {
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
                let sought = classes.into_iter().filter(|&class| !self.is_given(class));
                return sought.map(ScalarUnknown::Class).collect();
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

    /// How readily an equation is set aside where there are too many: the length of a bar inside
    /// another body first, since it cannot but repeat that body's; then that of any bar, then a slot, since what is left of the element can then still be placed.
    pub(super) fn readiness(&self, row: ScalarEquation) -> u8 {
        match row {
            ScalarEquation::Along { link, .. } if self.is_strut(link) => 4,
            ScalarEquation::Along { link, .. } if self.is_bar(link) => 3,
            ScalarEquation::Slot(_) => 2,
            ScalarEquation::Along { .. } => 1,
            ScalarEquation::Across { .. } | ScalarEquation::Push(_) | ScalarEquation::Elbow(_) => 0,
        }
    }

    /// Whether a bar's two joints belong to one other body.
    fn is_strut(&self, link: LinkId) -> bool {
        let ends: Vec<PointId> = self.joints(link).map(|m| m.point).collect();
        let [a, b] = ends[..] else { return false };
        let points = [a, b].map(|p| self.mechanism.point(p));
        let share = |l: &LinkId| *l != link && points[1].links.contains(l);
        let is_inner =
            points.iter().all(|p| p.ground.is_some()) || points[0].links.iter().any(share);
        is_inner && self.is_bar(link)
    }

    /// Whether a link is nothing but a distance between two joints.
    pub(super) fn is_bar(&self, link: LinkId) -> bool {
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

/// By what sine two locks of one link may disagree: by the rounding of a few products of unit vectors, or
/// by what the misfit that a scene accepts is at the end of its longest length.
fn slack(mechanism: &Mechanism, frame: &Frame) -> f64 {
    const ROUNDING: f64 = 16.0 * f64::EPSILON;
    let accepted = frame.length(mechanism.misfit()) / frame.longest;
    if accepted > ROUNDING {
        accepted
    } else {
        ROUNDING
    }
}
