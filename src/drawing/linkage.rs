//! Builds the figure of a scene in a state.

mod stops;

use super::figure::{Figure, Role, Shape};
use super::highlight;
use super::motion::extents::Extents;
use super::outline::{self, Corner};
use super::roles::{link_roles, roles};
use crate::quantity::Subject;
use crate::scene::{Scene, Vector, VectorKind};
use crate::solver::{Condition, Known, State};
use crate::{Body, Input, LinkId, Mechanism, Member, PointId, SlideId, Slider, Vec2};

/// Parts of a linkage to show in addition to its links and joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layers {
    /// Supports and hatching.
    pub ground: bool,
    /// The names of points.
    pub points: bool,
    /// The names of links.
    pub links: bool,
    /// Centres of mass.
    pub centres: bool,
    /// The highlighted part, which is always named.
    pub highlighted: Option<Subject>,
}

impl Default for Layers {
    fn default() -> Self {
        Layers {
            ground: true,
            points: true,
            links: false,
            centres: false,
            highlighted: None,
        }
    }
}

/// Builds the figure of a scene in a state; only the ground if there is no assembly.
#[must_use]
pub fn linkage(scene: &Scene, extents: &Extents, state: &State, layers: Layers) -> Figure {
    let assembled = state.condition() != Condition::NoAssembly;
    let highlighted = layers
        .highlighted
        .and_then(|highlighted| highlight::shown_as(highlighted, &scene.mechanism));
    let mut sketch = LinkageSketch {
        roles: roles(&scene.mechanism),
        links: link_roles(&scene.mechanism),
        highlighted,
        scene,
        mechanism: &scene.mechanism,
        reach: extents,
        state: state.known(),
        layers,
        figure: Figure::new(),
    };
    sketch.ground();
    if assembled {
        sketch.springs();
        sketch.links();
        // Drawn before the joints: a joint, or the pin of a block, covers a centre of mass or a
        // coupler point at its place.
        sketch.marks(&[Role::CentreOfMass, Role::Rider]);
        sketch.slides();
        sketch.stops();
        sketch.draw_highlighted_line();
        sketch.marks(&[Role::Joint]);
    }
    sketch.ground_pins();
    if assembled {
        // Drawn last: the driver is on top even in the smallest window.
        sketch.driver_pins();
    }
    sketch.names(assembled);
    sketch.figure
}

struct LinkageSketch<'a> {
    /// Roles by point.
    roles: Vec<Role>,
    /// Roles by link, without highlighting.
    links: Vec<Role>,
    /// The highlighted point, link or slide, or the line between two points.
    highlighted: Option<Subject>,
    scene: &'a Scene,
    mechanism: &'a Mechanism,
    reach: &'a Extents,
    state: Known<'a>,
    layers: Layers,
    figure: Figure,
}

impl LinkageSketch<'_> {
    fn ground(&mut self) {
        for (id, slide) in self.mechanism.slide_ids().zip(self.mechanism.slides()) {
            let (Body::Ground, Some((low, high))) = (slide.on, self.reach.travel(id)) else {
                continue;
            };
            let overhang = 0.04 * self.reach.bounds().size().norm();
            let from = slide.through + slide.direction() * (low - overhang);
            let to = slide.through + slide.direction() * (high + overhang);
            let role = self.highlight_or(Role::Guide, Subject::Slide(id));
            self.figure.add(Shape::Guide { from, to, role });
            if self.layers.ground {
                self.figure.add(self.hatching(from, to));
            }
        }
    }

    /// Returns the hatching below a guide, or on the outer side of a steep one.
    fn hatching(&self, from: Vec2, to: Vec2) -> Shape {
        let along = to - from;
        let inwards = self.reach.bounds().centre() - from;
        let right_way = if along.x.abs() > along.y.abs() * 0.5 {
            along.x > 0.0
        } else {
            along.cross(inwards) > 0.0
        };
        let (from, to) = if right_way { (from, to) } else { (to, from) };
        Shape::Hatching { from, to }
    }

    fn ground_pins(&mut self) {
        for id in self.mechanism.point_ids() {
            let role = self.roles[id.index()];
            let Some(at) = self.mechanism.point(id).ground else {
                continue;
            };
            self.mark(id, at, role);
            if self.layers.ground && role == Role::GroundPin {
                self.figure.add(Shape::Support { at });
            }
        }
    }

    fn links(&mut self) {
        for id in self.mechanism.link_ids() {
            let body = self.body(id);
            let plate = self.links[id.index()].of_plate();
            let role = self.link_role(id);
            outline::draw(&mut self.figure, &body, role, plate);
        }
    }

    fn link_role(&self, id: LinkId) -> Role {
        self.highlight_or(self.links[id.index()], Subject::Link(id))
    }

    fn springs(&mut self) {
        for load in self.mechanism.loads() {
            if let Some([from, to]) = load.ends() {
                let [from, to] = [from, to].map(|point| self.state.position(point));
                self.figure.add(Shape::Spring { from, to });
            }
        }
    }

    /// Returns the corners of a link: its points without the centre of mass.
    fn body(&self, link: LinkId) -> Vec<Corner> {
        let link = self.mechanism.link(link);
        let solid = link.members.iter().filter(|m| link.com != Some(m.point));
        let corner = |m: &Member| Corner {
            at: self.state.position(m.point),
            block: self.roles[m.point.index()] == Role::Slider,
        };
        solid.map(corner).collect()
    }

    fn slides(&mut self) {
        for (id, slide) in self.mechanism.slide_ids().zip(self.mechanism.slides()) {
            let at = self.state.position(slide.slider.point());
            if let Body::Link(on) = slide.on {
                let driven = self.mechanism.is_pushed(id);
                if let Some(mouth) = self.mouth(id, on).filter(|_| driven) {
                    self.cylinder(id, on, mouth);
                    continue;
                }
                self.slot(id, on);
            }
            let has_pin = match slide.slider {
                Slider::Pin(_) => true,
                Slider::Link { origin, .. } => self.mechanism.point(origin).links.len() > 1,
            };
            let along = self.state.travel(id).guide;
            self.figure.add(Shape::Block { at, along });
            let role = self.highlight_or(Role::Slider, Subject::Slide(id));
            let point = slide.slider.point();
            let is_lit = role == Role::Lit || self.highlighted == Some(Subject::Point(point));
            if (has_pin || is_lit) && !self.is_driven(point) {
                self.mark(point, at, role);
            }
        }
    }

    /// Returns `true` if an input acts at a point: at a pin that it turns, or at the point that it
    /// pushes.
    fn is_driven(&self, point: PointId) -> bool {
        self.input_at(point).is_some()
    }

    fn input_at(&self, point: PointId) -> Option<Input> {
        self.mechanism.inputs().find(|input| match *input {
            Input::Turn(link) if !self.mechanism.is_directed(link) => {
                self.mechanism.hub(link) == Some(point)
            }
            Input::Turn(link) => {
                let role = self.roles[point.index()];
                let is_pin = matches!(role, Role::Joint | Role::Slider);
                is_pin && self.mechanism.point(point).links.contains(&link)
            }
            Input::Push(slide) => self.mechanism.slide(slide).slider.point() == point,
        })
    }

    fn driver_pins(&mut self) {
        for id in self.mechanism.point_ids() {
            if let Some(input) = self.input_at(id) {
                let role = match input {
                    Input::Turn(_) => Role::DriverPin,
                    Input::Push(slide) => self.highlight_or(Role::DriverPin, Subject::Slide(slide)),
                };
                self.mark(id, self.state.position(id), role);
            }
        }
    }

    /// Returns the current point on a slide's guide at a position counted from `through`.
    fn on_guide(&self, id: SlideId, position: f64) -> Vec2 {
        let travel = self.state.travel(id);
        let slider = self.mechanism.slide(id).slider.point();
        self.state.position(slider) + travel.guide * (position - travel.position)
    }

    /// Draws the guide on a moving link over the whole travel, and the line that joins it to the
    /// link's points.
    fn slot(&mut self, id: SlideId, on: LinkId) {
        if let Some((low, high)) = self.reach.travel(id) {
            let (from, to) = (self.on_guide(id, low), self.on_guide(id, high));
            let role = self.link_role(on);
            let plain = outline::beyond(&self.body(on), from, to);
            let stands_apart = plain == [(from, to)];
            for (from, to) in plain {
                self.figure.add(Shape::Line { from, to, role });
            }
            if stands_apart {
                self.join(on, from, to);
            }
        }
    }

    /// Returns the position of a cylinder's mouth along its guide: the link's outermost point that
    /// the rod never passes, or 0.85 of the shortest stroke. Returns `None` if there is no space.
    fn mouth(&self, id: SlideId, on: LinkId) -> Option<f64> {
        let (shortest, _) = self.reach.travel(id)?;
        let slide = self.mechanism.slide(id);
        let members = self.mechanism.link(on).members.iter();
        let along = members.filter_map(|m| {
            let offset = m.local - slide.through;
            let position = offset.dot(slide.direction());
            let nearby = offset.cross(slide.direction()).abs();
            (position > 0.0 && position <= shortest && nearby < 1e-3 * position).then_some(position)
        });
        let mouth = along.fold(0.0, f64::max);
        let mouth = if mouth > 0.0 { mouth } else { 0.85 * shortest };
        (mouth > 0.0).then_some(mouth)
    }

    /// Draws the barrel up to its mouth, and the rod from there to the pushed point.
    fn cylinder(&mut self, id: SlideId, on: LinkId, mouth: f64) {
        let (foot, rim) = (self.on_guide(id, 0.0), self.on_guide(id, mouth));
        let eye = self.state.position(self.mechanism.slide(id).slider.point());
        let role = self.highlight_or(Role::Driver, Subject::Slide(id));
        let (from, to) = (rim, eye);
        self.figure.add(Shape::Rod { from, to, role });
        let role = match role {
            Role::Lit => role,
            _ => self.highlight_or(role, Subject::Link(on)),
        };
        let (from, to) = (foot, rim);
        self.figure.add(Shape::Barrel { from, to, role });
        self.join(on, foot, rim);
    }

    /// Joins a guide to the nearest point of the link that carries it.
    fn join(&mut self, on: LinkId, from: Vec2, to: Vec2) {
        let along = to - from;
        let foot = |p: Vec2| {
            // On a guide of zero length either end is the nearest point.
            let share = (p - from).dot(along) / along.norm2().max(f64::MIN_POSITIVE);
            from + along * share.clamp(0.0, 1.0)
        };
        let feet = self.body(on).into_iter().map(|c| (c.at, foot(c.at)));
        let nearest = feet.min_by(|a, b| (a.1 - a.0).norm().total_cmp(&(b.1 - b.0).norm()));
        if let Some((from, to)) = nearest
            && (to - from).norm() > 1e-6 * along.norm()
        {
            let role = self.link_role(on);
            self.figure.add(Shape::Line { from, to, role });
        }
    }

    fn marks(&mut self, roles: &[Role]) {
        for &shown in roles {
            for id in self.mechanism.point_ids() {
                let role = self.roles[id.index()];
                let is_lit = self.highlighted == Some(Subject::Point(id));
                let is_shown = self.layers.centres || role != Role::CentreOfMass || is_lit;
                if role == shown && is_shown && !self.is_driven(id) {
                    self.mark(id, self.state.position(id), role);
                }
            }
        }
    }

    fn mark(&mut self, point: PointId, at: Vec2, role: Role) {
        let role = self.highlight_or(role, Subject::Point(point));
        self.figure.add(Shape::Mark { at, role });
    }

    /// Returns the highlight role if `part` is highlighted, or else `role`.
    fn highlight_or(&self, role: Role, part: Subject) -> Role {
        match self.highlighted {
            Some(highlighted) if highlighted == part => Role::Lit,
            _ => role,
        }
    }

    /// Draws a highlighted line that is not part of the drawing: a vector between two points, or
    /// the vector of a slide on a moving link.
    fn draw_highlighted_line(&mut self) {
        let ends = match self.highlighted {
            Some(Subject::Between(from, to)) => {
                Some([from, to].map(|point| self.state.position(point)))
            }
            Some(Subject::Slide(id)) if self.mechanism.slide(id).on != Body::Ground => {
                let slider = self.mechanism.slide(id).slider.point();
                Some([self.on_guide(id, 0.0), self.state.position(slider)])
            }
            _ => None,
        };
        if let Some([from, to]) = ends {
            let role = Role::Lit;
            self.figure.add(Shape::Line { from, to, role });
        }
    }

    fn names(&mut self, assembled: bool) {
        for id in self.mechanism.point_ids() {
            let role = self.roles[id.index()];
            let at = match (self.mechanism.point(id).ground, assembled) {
                (Some(at), _) => at,
                (None, true) => self.state.position(id),
                (None, false) => continue,
            };
            let is_wanted = self.layers.points && role != Role::CentreOfMass;
            if let Some(name) = self.scene.point_name(id) {
                self.name(Subject::Point(id), is_wanted, at, name, Role::Label);
            }
        }
        if assembled {
            for id in self.mechanism.link_ids() {
                let body = self.body(id);
                let sum = body.iter().fold(Vec2::ZERO, |sum, c| sum + c.at);
                let middle = sum / body.len() as f64;
                let (name, role) = (self.scene.link_name(id), self.links[id.index()].of_name());
                self.name(Subject::Link(id), self.layers.links, middle, name, role);
            }
            self.name_of_lit_line();
        }
    }

    /// Adds the name of a part if it is wanted or highlighted; a highlighted name is in brackets.
    fn name(&mut self, part: Subject, is_wanted: bool, at: Vec2, name: &str, role: Role) {
        let (text, role) = match self.highlighted {
            Some(highlighted) if highlighted == part => (highlight::bracketed(name), Role::Lit),
            _ if is_wanted => (name.to_owned(), role),
            _ => return,
        };
        self.figure.add(Shape::Label { at, text, role });
    }

    fn name_of_lit_line(&mut self) {
        let scene = self.scene;
        let (at, name) = match self.highlighted {
            Some(Subject::Slide(id)) => {
                let slider = self.mechanism.slide(id).slider.point();
                (self.state.position(slider), scene.slide_name(id))
            }
            Some(Subject::Between(from, to)) => {
                let is_it = |v: &&Vector| v.kind == VectorKind::Between(from, to);
                let [from, to] = [from, to].map(|point| self.state.position(point));
                let vector = scene.vectors.iter().find(is_it);
                ((from + to) / 2.0, vector.map_or("", |v| v.name.as_str()))
            }
            _ => return,
        };
        if let (Some(highlighted), false) = (self.highlighted, name.is_empty()) {
            self.name(highlighted, true, at, name, Role::Label);
        }
    }
}
