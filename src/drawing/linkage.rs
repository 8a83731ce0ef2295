//! The figure of a scene in a state.

use super::figure::{Figure, LINK_HUES, Role, Shape};
use super::outline::{self, Corner};
use super::reach::Reach;
use crate::scene::{Scene, VectorKind};
use crate::solver::{Condition, Known, State};
use crate::{Body, Input, LinkId, Load, Mechanism, Member, Point, SlideId, Slider, Vec2};

/// What of a linkage is shown beside its links and joints.
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
}

impl Default for Layers {
    fn default() -> Self {
        Layers {
            ground: true,
            points: true,
            links: false,
            centres: false,
        }
    }
}

/// Builds the figure of a scene in a state; of the ground alone where there is no assembly.
#[must_use]
pub fn linkage(scene: &Scene, reach: &Reach, state: &State, layers: Layers) -> Figure {
    let assembled = state.condition() != Condition::NoAssembly;
    let mut sketch = LinkageSketch {
        roles: roles(&scene.mechanism),
        links: link_roles(&scene.mechanism),
        scene,
        mechanism: &scene.mechanism,
        reach,
        state: state.known(),
        layers,
        figure: Figure::new(),
    };
    sketch.ground();
    if assembled {
        sketch.springs();
        sketch.links();
        sketch.slides();
        sketch.marks();
    }
    sketch.ground_pins();
    sketch.names(assembled);
    sketch.figure
}

/// Adds the links that are elsewhere in another state of the same scene, to be drawn below everything.
pub fn add_ghost(figure: &mut Figure, scene: &Scene, now: &State, other: &State) {
    add_moved(figure, scene, now, other, Role::Ghost);
}

/// Adds the links that are elsewhere in another state, as this role.
pub(super) fn add_moved(
    figure: &mut Figure,
    scene: &Scene,
    now: &State,
    other: &State,
    role: Role,
) {
    let (now, other) = (now.known(), other.known());
    let mechanism = &scene.mechanism;
    let points = || mechanism.point_ids();
    let size = points()
        .map(|p| now.position(p).norm())
        .fold(f64::MIN_POSITIVE, f64::max);
    let moved = |m: &Member| (now.position(m.point) - other.position(m.point)).norm() > SEEN * size;
    let roles = roles(mechanism);
    for link in mechanism.links() {
        let solid = || link.members.iter().filter(|m| link.com != Some(m.point));
        if !solid().any(moved) {
            continue;
        }
        let corner = |m: &Member| Corner {
            at: other.position(m.point),
            block: roles[m.point.index()] == Role::Slider,
        };
        outline::draw(figure, &solid().map(corner).collect::<Vec<_>>(), role);
    }
}

/// Adds the links of another scene, to be drawn below everything. `scale` is how many units of the
/// figure one of the other's is; where it has no assembly, nothing is added.
pub fn add_other(figure: &mut Figure, scene: &Scene, state: &State, scale: f64) {
    if state.condition() == Condition::NoAssembly {
        return;
    }
    let state = state.known();
    let mechanism = &scene.mechanism;
    let roles = roles(mechanism);
    for link in mechanism.links() {
        let solid = link.members.iter().filter(|m| link.com != Some(m.point));
        let corner = |m: &Member| Corner {
            at: state.position(m.point) * scale,
            block: roles[m.point.index()] == Role::Slider,
        };
        outline::draw(figure, &solid.map(corner).collect::<Vec<_>>(), Role::Ghost);
    }
}

/// What differs by less than this part of the largest coordinate is in the same place to any eye.
const SEEN: f64 = 1e-6;

/// What each point is drawn as.
fn roles(mechanism: &Mechanism) -> Vec<Role> {
    let role = |point: &Point| match (point.ground, point.links.len()) {
        (Some(_), 0) => Role::Ground,
        (Some(_), _) => Role::GroundPin,
        (None, 0 | 1) => Role::Rider,
        (None, _) => Role::Joint,
    };
    let mut roles: Vec<Role> = mechanism.points().iter().map(role).collect();
    for com in mechanism.links().iter().filter_map(|link| link.com) {
        roles[com.index()] = Role::CentreOfMass;
    }
    for slide in mechanism.slides() {
        let slot = &mut roles[slide.slider.point().index()];
        // A ground point in a slot of a link is a pin like any other, and wants its support.
        *slot = match *slot {
            Role::Ground | Role::GroundPin => Role::GroundPin,
            _ => Role::Slider,
        };
    }
    roles
}

/// What each link is drawn as: the driven one, and each of the others in a hue that no link before it
/// has that it is joined to, as far as there are so many. The order of the links alone decides, so that
/// a link keeps its hue whatever its lengths become.
#[must_use]
pub fn link_roles(mechanism: &Mechanism) -> Vec<Role> {
    let mut roles: Vec<Role> = Vec::with_capacity(mechanism.links().len());
    let mut next = 0;
    for (id, link) in mechanism.link_ids().zip(mechanism.links()) {
        if mechanism.driver().input == Input::Turn(id) {
            roles.push(Role::Driver);
            continue;
        }
        let joined = link
            .members
            .iter()
            .flat_map(|m| &mechanism.point(m.point).links);
        let met: Vec<Role> = joined
            .filter_map(|other| roles.get(other.index()).copied())
            .collect();
        let hues = (0..LINK_HUES).map(|k| (next + k) % LINK_HUES);
        let hue = hues.clone().find(|&hue| !met.contains(&Role::Link(hue)));
        let hue = hue.unwrap_or(next);
        roles.push(Role::Link(hue));
        next = (hue + 1) % LINK_HUES;
    }
    roles
}

/// What the link is drawn as that a vector of the tables belongs to, in their order: the link itself, or one
/// that has both ends of the vector. None for vectors from link to link.
#[must_use]
pub fn vector_roles(scene: &Scene) -> Vec<Option<Role>> {
    let mechanism = &scene.mechanism;
    let links = link_roles(mechanism);
    let role = |kind: VectorKind| match kind {
        VectorKind::Link(link) => Some(links[link.index()]),
        VectorKind::Slide(slide) => match mechanism.slide(slide).on {
            Body::Link(link) => Some(links[link.index()]),
            Body::Ground => None,
        },
        VectorKind::Between(from, to) => {
            let mut of_both = mechanism.point(from).links.iter();
            let link = of_both.find(|link| mechanism.point(to).links.contains(link));
            link.map(|link| links[link.index()])
        }
    };
    scene.vectors.iter().map(|v| role(v.kind)).collect()
}

struct LinkageSketch<'a> {
    /// By point.
    roles: Vec<Role>,
    /// By link.
    links: Vec<Role>,
    scene: &'a Scene,
    mechanism: &'a Mechanism,
    reach: &'a Reach,
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
            let role = Role::Guide;
            self.figure.add(Shape::Line { from, to, role });
            if self.layers.ground {
                self.figure.add(self.hatching(from, to));
            }
        }
    }

    /// Hatching below a guide, or on the side of an upright one that lies away from the linkage.
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
        for (point, &role) in self.mechanism.points().iter().zip(&self.roles) {
            let Some(at) = point.ground else { continue };
            self.figure.add(Shape::Mark { at, role });
            if self.layers.ground && role == Role::GroundPin {
                self.figure.add(Shape::Support { at });
            }
        }
    }

    fn links(&mut self) {
        for id in self.mechanism.link_ids() {
            let body = self.body(id);
            outline::draw(&mut self.figure, &body, self.links[id.index()]);
        }
    }

    fn springs(&mut self) {
        for load in self.mechanism.loads() {
            if let Load::Spring { from, to, .. } = *load {
                let [from, to] = [from, to].map(|point| self.state.position(point));
                self.figure.add(Shape::Spring { from, to });
            }
        }
    }

    /// The places of a link's points, the centre of mass left out.
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
                let driven = self.mechanism.driver().input == Input::Push(id);
                if let Some(mouth) = self.mouth(id, on).filter(|_| driven) {
                    self.cylinder(id, on, mouth);
                    continue;
                }
                self.slot(id, on);
            }
            let pin = match slide.slider {
                Slider::Pin(_) => true,
                Slider::Link { origin, .. } => self.mechanism.point(origin).links.len() > 1,
            };
            let along = self.state.travel(id).guide;
            self.figure.add(Shape::Block { at, along, pin });
        }
    }

    /// A place on the guide of a slide now, by the position counted from `through`.
    fn on_guide(&self, id: SlideId, position: f64) -> Vec2 {
        let travel = self.state.travel(id);
        let slider = self.mechanism.slide(id).slider.point();
        self.state.position(slider) + travel.guide * (position - travel.position)
    }

    /// The guide of a moving link over the whole travel, and what joins it to the link's points.
    fn slot(&mut self, id: SlideId, on: LinkId) {
        if let Some((low, high)) = self.reach.travel(id) {
            let (from, to) = (self.on_guide(id, low), self.on_guide(id, high));
            let role = self.links[on.index()];
            let bare = outline::beyond(&self.body(on), from, to);
            let stands_apart = bare == [(from, to)];
            for (from, to) in bare {
                self.figure.add(Shape::Line { from, to, role });
            }
            if stands_apart {
                self.join(on, from, to);
            }
        }
    }

    /// Where the barrel of a cylinder ends, counted along its guide: at the link's point farthest out
    /// that the rod never passes, or a little before the shortest stroke. None if there is no room.
    fn mouth(&self, id: SlideId, on: LinkId) -> Option<f64> {
        let (shortest, _) = self.reach.travel(id)?;
        let slide = self.mechanism.slide(id);
        let members = self.mechanism.link(on).members.iter();
        let along = members.filter_map(|m| {
            let offset = m.local - slide.through;
            let position = offset.dot(slide.direction());
            let beside = offset.cross(slide.direction()).abs();
            (position > 0.0 && position <= shortest && beside < 1e-3 * position).then_some(position)
        });
        let mouth = along.fold(0.0, f64::max);
        let mouth = if mouth > 0.0 { mouth } else { 0.85 * shortest };
        (mouth > 0.0).then_some(mouth)
    }

    /// The barrel up to its mouth, and the rod from there to the point that it pushes.
    fn cylinder(&mut self, id: SlideId, on: LinkId, mouth: f64) {
        let (foot, rim) = (self.on_guide(id, 0.0), self.on_guide(id, mouth));
        let eye = self.state.position(self.mechanism.slide(id).slider.point());
        let (from, to, role) = (rim, eye, Role::Driver);
        self.figure.add(Shape::Line { from, to, role });
        let (from, to, role) = (foot, rim, Role::Driver);
        self.figure.add(Shape::Barrel { from, to, role });
        let (at, role) = (eye, Role::Joint);
        self.figure.add(Shape::Mark { at, role });
        self.join(on, foot, rim);
    }

    /// Joins a guide to the nearest point of the link that carries it.
    fn join(&mut self, on: LinkId, from: Vec2, to: Vec2) {
        let along = to - from;
        let foot = |p: Vec2| {
            // Of a guide of no length either end is the nearest point.
            let share = (p - from).dot(along) / along.norm2().max(f64::MIN_POSITIVE);
            from + along * share.clamp(0.0, 1.0)
        };
        let feet = self.body(on).into_iter().map(|c| (c.at, foot(c.at)));
        let nearest = feet.min_by(|a, b| (a.1 - a.0).norm().total_cmp(&(b.1 - b.0).norm()));
        if let Some((from, to)) = nearest
            && (to - from).norm() > 1e-6 * along.norm()
        {
            let role = self.links[on.index()];
            self.figure.add(Shape::Line { from, to, role });
        }
    }

    /// Centres of mass first: a joint at the same place is drawn over them.
    fn marks(&mut self) {
        for shown in [Role::CentreOfMass, Role::Rider, Role::Joint] {
            if shown == Role::CentreOfMass && !self.layers.centres {
                continue;
            }
            for (id, &role) in self.mechanism.point_ids().zip(&self.roles) {
                if role == shown {
                    let at = self.state.position(id);
                    self.figure.add(Shape::Mark { at, role });
                }
            }
        }
    }

    fn names(&mut self, assembled: bool) {
        if self.layers.points {
            for (id, &role) in self.mechanism.point_ids().zip(&self.roles) {
                let at = match (self.mechanism.point(id).ground, assembled) {
                    (Some(at), _) => at,
                    (None, true) => self.state.position(id),
                    (None, false) => continue,
                };
                if role != Role::CentreOfMass
                    && let Some(name) = self.scene.point_name(id)
                {
                    add_name(&mut self.figure, at, name, Role::Label);
                }
            }
        }
        if self.layers.links && assembled {
            for id in self.mechanism.link_ids() {
                let body = self.body(id);
                let sum = body.iter().fold(Vec2::ZERO, |sum, c| sum + c.at);
                let middle = sum / body.len() as f64;
                let role = self.links[id.index()];
                add_name(&mut self.figure, middle, self.scene.link_name(id), role);
            }
        }
    }
}

fn add_name(figure: &mut Figure, at: Vec2, name: &str, role: Role) {
    let text = name.to_owned();
    figure.add(Shape::Label { at, text, role });
}
