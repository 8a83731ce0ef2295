//! Places points and links in a script: one step per closed form, in the order of the plan.

mod meetings;

use super::closure::Closure;
use super::dialect::ScriptLanguage;
use super::identifiers::{ALONG, Identifiers, TABLE, THROUGH};
use super::terms::{ScriptTerm, complex, number};
use crate::scene::Scene;
use crate::solver::Solver;
use crate::{
    Body, Input, InputLaw, InputTable, LinkId, Mechanism, Member, PointId, SlideId, Slider, Vec2,
};

/// A name and its value.
#[derive(Clone, Debug)]
pub(super) struct Assignment {
    pub(super) name: String,
    pub(super) term: ScriptTerm,
}

/// A step of the script for one state.
pub(super) enum ScriptStep {
    Assign(Assignment),
    /// The beginning of a group that places these links.
    Group(Vec<LinkId>),
    /// The solution for the unknowns of a coupled group.
    Close(Closure),
}

/// The steps of a script, and the parts placed so far.
pub(super) struct ScriptPlacement<'a> {
    pub(super) scene: &'a Scene,
    pub(super) solver: &'a Solver,
    pub(super) language: ScriptLanguage,
    pub(super) names: Identifiers,
    pub(super) constants: Vec<Assignment>,
    pub(super) steps: Vec<ScriptStep>,
    /// `true` by point if its place is known.
    known: Vec<bool>,
    /// By link: its reference point, once the link is placed.
    placed: Vec<Option<PointId>>,
    /// By link: the name of its direction, if known.
    aimed: Vec<Option<String>>,
}

impl<'a> ScriptPlacement<'a> {
    pub(super) fn of(scene: &'a Scene, solver: &'a Solver, language: ScriptLanguage) -> Self {
        let mechanism = &scene.mechanism;
        let mut placement = ScriptPlacement {
            scene,
            solver,
            language,
            names: Identifiers::of(scene),
            constants: Vec::new(),
            steps: Vec::new(),
            known: vec![false; mechanism.points().len()],
            placed: vec![None; mechanism.links().len()],
            aimed: vec![None; mechanism.links().len()],
        };
        placement.list_constants();
        placement.drive();
        for group in solver.plan().groups.iter().skip(1) {
            placement.steps.push(ScriptStep::Group(group.links.clone()));
            placement.settle();
            while !placement.is_done(&group.links, &group.points) {
                if !placement.close_form(&group.links, &group.points) {
                    placement.solve_rest_by_newton(&group.links, &group.points);
                    placement.settle();
                    break;
                }
                placement.settle();
            }
        }
        placement.settle();
        placement
    }

    pub(super) fn mechanism(&self) -> &'a Mechanism {
        &self.scene.mechanism
    }

    // Constants.

    fn constant(&mut self, name: String, value: String) {
        let term = ScriptTerm::of(value);
        self.constants.push(Assignment { name, term });
    }

    fn list_constants(&mut self) {
        let mechanism = self.mechanism();
        for point in mechanism.point_ids() {
            if let Some(at) = mechanism.point(point).ground {
                self.known[point.index()] = true;
                let name = self.names.point(point).to_owned();
                self.constant(name, complex(at.x, at.y));
            }
        }
        for link in mechanism.link_ids() {
            let given = mechanism.link(link);
            for member in given.members.iter().filter(|m| Some(m.point) != given.com) {
                self.list_member(link, *member);
            }
        }
        for slide in mechanism.slide_ids() {
            self.list_guide(slide);
        }
        for timed in mechanism.timed() {
            if let Some(table) = timed.table() {
                self.list_table(timed.input, table);
            }
        }
    }

    fn list_member(&mut self, link: LinkId, member: Member) {
        if member.local == Vec2::ZERO {
            return;
        }
        let name = self.local_name(link, member.point);
        self.constant(name, complex(member.local.x, member.local.y));
    }

    /// Returns the name of a place on a link: the link's name for its length, or a name of link and
    /// point.
    fn local_name(&self, link: LinkId, point: PointId) -> String {
        let name = self.names.link(link);
        match self.mechanism().link(link).ends {
            Some((_, to)) if to == point => name.to_owned(),
            _ => self.names.part(name, self.names.point(point)),
        }
    }

    fn list_guide(&mut self, id: SlideId) {
        let slide = self.mechanism().slide(id);
        let name = self.names.slide(id).to_owned();
        if slide.named.is_none() && slide.through != Vec2::ZERO {
            let through = complex(slide.through.x, slide.through.y);
            self.constant(self.names.part(&name, THROUGH), through);
        }
        if slide.angle != 0.0 {
            let direction = format!("turn({})", number(slide.angle));
            self.constant(self.names.part(&name, ALONG), direction);
        }
    }

    // Terms of known parts.

    pub(super) fn point(&self, point: PointId) -> ScriptTerm {
        ScriptTerm::of(self.names.point(point))
    }

    /// Returns the place of a point on its link.
    pub(super) fn local(&self, link: LinkId, point: PointId) -> ScriptTerm {
        match self.mechanism().link(link).local(point) {
            Some(local) if local != Vec2::ZERO => ScriptTerm::of(self.local_name(link, point)),
            _ => ScriptTerm::zero(),
        }
    }

    /// Returns the vector from one point of a link to another, in the link's frame.
    fn between(&self, link: LinkId, from: PointId, to: PointId) -> ScriptTerm {
        self.local(link, to).minus(self.local(link, from))
    }

    fn radius(&self, link: LinkId, from: PointId, to: PointId) -> ScriptTerm {
        let between = match self.local(link, to) == ScriptTerm::zero() {
            true => self.local(link, from),
            false => self.between(link, from, to),
        };
        ScriptTerm::of(format!("abs({between})"))
    }

    /// Returns the point that a guide passes through, in the frame of its body.
    pub(super) fn through(&self, id: SlideId) -> ScriptTerm {
        let slide = self.mechanism().slide(id);
        match (slide.named, slide.on) {
            (Some(point), Body::Ground) => self.point(point),
            (Some(point), Body::Link(link)) => self.local(link, point),
            (None, _) if slide.through == Vec2::ZERO => ScriptTerm::zero(),
            (None, _) => ScriptTerm::of(self.names.part(self.names.slide(id), THROUGH)),
        }
    }

    /// Returns the direction of a guide in the frame of its body.
    pub(super) fn along(&self, id: SlideId) -> ScriptTerm {
        match self.mechanism().slide(id).angle == 0.0 {
            true => ScriptTerm::one(),
            false => ScriptTerm::of(self.names.part(self.names.slide(id), ALONG)),
        }
    }

    /// Returns the direction of a body; `None` if it is not known yet.
    pub(super) fn direction(&self, body: Body) -> Option<ScriptTerm> {
        match body {
            Body::Ground => Some(ScriptTerm::one()),
            Body::Link(link) => self.aimed[link.index()].clone().map(ScriptTerm::of),
        }
    }

    /// Returns a place in a body's frame in the ground's frame; `None` if the body is not placed
    /// yet.
    fn on_body(&self, body: Body, place: ScriptTerm) -> Option<ScriptTerm> {
        let Body::Link(link) = body else {
            return Some(place);
        };
        let seen_from = self.placed[link.index()]?;
        let offset = place.minus(self.local(link, seen_from));
        Some(
            self.point(seen_from)
                .plus(self.direction(body)?.times(offset)),
        )
    }

    /// Returns the direction of a link; `None` if it is not known yet.
    pub(super) fn direction_of(&self, link: LinkId) -> Option<ScriptTerm> {
        self.direction(Body::Link(link))
    }

    /// Returns a guide on a placed body: its point and the body's direction; `None` if the body is
    /// not placed yet.
    pub(super) fn guide_of_body(
        &self,
        body: Body,
        id: SlideId,
    ) -> Option<(ScriptTerm, ScriptTerm)> {
        Some((self.on_body(body, self.through(id))?, self.direction(body)?))
    }

    // Steps.

    pub(super) fn assign(&mut self, name: String, term: ScriptTerm) {
        self.steps
            .push(ScriptStep::Assign(Assignment { name, term }));
    }

    pub(super) fn place_point(&mut self, point: PointId, term: ScriptTerm) {
        self.known[point.index()] = true;
        self.assign(self.names.point(point).to_owned(), term);
    }

    pub(super) fn aim(&mut self, link: LinkId, term: ScriptTerm) {
        let name = self
            .names
            .fresh(&format!("u_{}", self.scene.link_name(link)));
        self.aimed[link.index()] = Some(name.clone());
        self.assign(name, term);
    }

    /// Marks a link of known direction as placed, with this reference point.
    pub(super) fn hold(&mut self, link: LinkId, point: PointId) {
        self.placed[link.index()] = Some(point);
    }

    pub(super) fn is_known(&self, point: PointId) -> bool {
        self.known[point.index()]
    }

    /// Returns `true` if the script has this point; centres of mass and unnamed points are left
    /// out.
    pub(super) fn is_named(&self, point: PointId) -> bool {
        let mut links = self.mechanism().links().iter();
        self.scene.point_name(point).is_some() && links.all(|link| link.com != Some(point))
    }

    pub(super) fn is_placed(&self, link: LinkId) -> bool {
        self.placed[link.index()].is_some()
    }

    pub(super) fn is_aimed(&self, link: LinkId) -> bool {
        self.aimed[link.index()].is_some()
    }

    fn is_done(&self, links: &[LinkId], points: &[PointId]) -> bool {
        links.iter().all(|&link| self.is_placed(link))
            && points
                .iter()
                .all(|&p| self.is_known(p) || !self.is_named(p))
    }

    /// Returns the points of a link that the script places.
    pub(super) fn members(&self, link: LinkId) -> Vec<PointId> {
        let given = self.mechanism().link(link);
        let members = given.members.iter().map(|m| m.point);
        members.filter(|&p| Some(p) != given.com).collect()
    }

    pub(super) fn known_member(&self, link: LinkId) -> Option<PointId> {
        self.members(link).into_iter().find(|&p| self.is_known(p))
    }

    /// Returns the coordinate of an input: q for the driver, or else a function of q.
    pub(super) fn coordinate(&self, input: Input) -> ScriptTerm {
        ScriptTerm::of(match self.mechanism().timed_input(input) {
            None => "q".to_owned(),
            Some(timed) => match &timed.law {
                InputLaw::Ratio { ratio, phase } => {
                    format!("({} * q + {})", number(*ratio), number(*phase))
                }
                InputLaw::Table(table) => {
                    let parts = self.table_names(input).join(", ");
                    let period = number(table.period().unwrap_or_default());
                    format!("follow(q, {parts}, {period})")
                }
            },
        })
    }

    /// Returns the names of a table's places, values and second derivatives.
    fn table_names(&self, input: Input) -> [String; 3] {
        let name = match input {
            Input::Turn(link) => self.names.link(link),
            Input::Push(slide) => self.names.slide(slide),
        };
        TABLE.map(|part| self.names.part(name, part))
    }

    fn list_table(&mut self, input: Input, table: &InputTable) {
        let list = |numbers: Vec<f64>| {
            let numbers: Vec<String> = numbers.into_iter().map(number).collect();
            format!("[{}]", numbers.join(", "))
        };
        let [coordinates, values] =
            [0, 1].map(|i| table.knots().iter().map(|knot| knot[i]).collect());
        let lists = [coordinates, values, table.bends().to_vec()];
        for (name, numbers) in self.table_names(input).into_iter().zip(lists) {
            self.constant(name, list(numbers));
        }
    }

    fn drive(&mut self) {
        let inputs: Vec<Input> = self.mechanism().inputs().collect();
        for input in inputs {
            self.drive_by(input);
        }
        self.settle();
    }

    fn drive_by(&mut self, input: Input) {
        let q = self.coordinate(input);
        match input {
            Input::Turn(link) if self.mechanism().is_directed(link) => {
                self.steps.push(ScriptStep::Group(vec![link]));
                self.aim(link, ScriptTerm::of(format!("turn({q})")));
                if let Some(pivot) = self.known_member(link) {
                    self.hold(link, pivot);
                }
            }
            Input::Turn(_) => self.steps.push(ScriptStep::Group(Vec::new())),
            Input::Push(id) => {
                let slide = self.mechanism().slide(id);
                if slide.on == Body::Ground {
                    self.steps.push(ScriptStep::Group(Vec::new()));
                    let place = self.through(id).plus(self.along(id).times(q));
                    self.place_point(slide.slider.point(), place);
                }
            }
        }
    }

    /// Adds all steps that follow directly from known parts: directions by guides and by two
    /// points, and coupler points.
    pub(super) fn settle(&mut self) {
        loop {
            let before = self.steps.len();
            self.push_out();
            for link in self.mechanism().link_ids() {
                self.lock(link);
                self.elbow(link);
                self.determine_link(link);
            }
            if self.steps.len() == before {
                return;
            }
        }
    }

    /// Places the points that inputs push along guides of placed links.
    fn push_out(&mut self) {
        let inputs: Vec<Input> = self.mechanism().inputs().collect();
        for input in inputs {
            let Input::Push(id) = input else { continue };
            let slide = self.mechanism().slide(id);
            let point = slide.slider.point();
            if self.is_known(point) || self.direction(slide.on).is_none() {
                continue;
            }
            let way = self.along(id).times(self.coordinate(input));
            if let Some(place) = self.on_body(slide.on, self.through(id).plus(way)) {
                self.place_point(point, place);
            }
        }
    }

    /// Finds the direction of a link with a constant angle to a guide.
    fn lock(&mut self, link: LinkId) {
        if self.is_aimed(link) {
            return;
        }
        for id in self.mechanism().slide_ids() {
            let slide = self.mechanism().slide(id);
            let Slider::Link {
                link: sliding,
                turn,
                ..
            } = slide.slider
            else {
                continue;
            };
            let angle = match turn + slide.angle == 0.0 {
                true => ScriptTerm::one(),
                false => ScriptTerm::of(format!("turn({})", number(slide.angle + turn))),
            };
            if sliding == link {
                if let Some(body) = self.direction(slide.on) {
                    self.aim(link, body.times(angle));
                    return;
                }
            } else if slide.on == Body::Link(link)
                && let Some(other) = self.direction(Body::Link(sliding))
            {
                self.aim(link, other.over(angle));
                return;
            }
        }
    }

    /// Finds the direction of one of two links between which an input turns.
    fn elbow(&mut self, link: LinkId) {
        let elbows: Vec<_> = self.mechanism().elbows().collect();
        for (turned, from) in elbows {
            let other = match link {
                _ if self.is_aimed(link) => return,
                _ if link == turned => from,
                _ if link == from => turned,
                _ => continue,
            };
            let Some(other) = self.direction(Body::Link(other)) else {
                continue;
            };
            let by = self.bend(turned);
            let direction = if link == turned {
                other.times(by)
            } else {
                other.over(by)
            };
            self.aim(link, direction);
        }
    }

    /// Returns the direction of a link turned against another one, relative to that.
    pub(super) fn bend(&self, turned: LinkId) -> ScriptTerm {
        ScriptTerm::of(format!("turn({})", self.coordinate(Input::Turn(turned))))
    }

    fn determine_link(&mut self, link: LinkId) {
        if !self.is_placed(link) {
            let members = self.members(link);
            let known: Vec<PointId> = members.into_iter().filter(|&p| self.is_known(p)).collect();
            let Some(&first) = known.first() else { return };
            if !self.is_aimed(link) {
                let local = |p: PointId| self.mechanism().link(link).local(p);
                let Some(&other) = known.iter().find(|&&p| local(p) != local(first)) else {
                    return;
                };
                self.aim_by(link, first, other);
            }
            self.hold(link, first);
        }
        for point in self.members(link) {
            if !self.is_known(point)
                && let Some(place) = self.on_body(Body::Link(link), self.local(link, point))
            {
                self.place_point(point, place);
            }
        }
    }

    /// Finds the direction of a link with two known points.
    fn aim_by(&mut self, link: LinkId, from: PointId, to: PointId) {
        let seen = self.point(to).minus(self.point(from));
        self.aim(link, seen.over(self.between(link, from, to)));
    }
}
