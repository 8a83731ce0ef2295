//! The figure of a scene in a state.

use super::figure::{Figure, Role, Shape};
use super::reach::Reach;
use crate::scene::Scene;
use crate::solver::{Condition, State};
use crate::{Body, Input, LinkId, Mechanism, PointId, SlideId, Slider, Vec2};

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
    let mut sketch = Sketch {
        scene,
        mechanism: &scene.mechanism,
        reach,
        state,
        layers,
        figure: Figure::new(),
    };
    sketch.ground();
    if assembled {
        sketch.links();
        sketch.slides();
        sketch.marks();
    }
    sketch.ground_pins();
    sketch.names(assembled);
    sketch.figure
}

struct Sketch<'a> {
    scene: &'a Scene,
    mechanism: &'a Mechanism,
    reach: &'a Reach,
    state: &'a State,
    layers: Layers,
    figure: Figure,
}

impl Sketch<'_> {
    fn ground(&mut self) {
        for (id, slide) in self.mechanism.slide_ids().zip(self.mechanism.slides()) {
            let (Body::Ground, Some((low, high))) = (slide.on, self.reach.travel(id)) else {
                continue;
            };
            let overhang = 0.04 * self.reach.bounds().size().norm();
            let from = slide.through + slide.direction * (low - overhang);
            let to = slide.through + slide.direction * (high + overhang);
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
        for point in self.mechanism.points() {
            let Some(at) = point.ground else { continue };
            if point.links.is_empty() {
                let role = Role::Ground;
                self.figure.add(Shape::Mark { at, role });
                continue;
            }
            let role = Role::GroundPin;
            self.figure.add(Shape::Mark { at, role });
            if self.layers.ground {
                self.figure.add(Shape::Support { at });
            }
        }
    }

    fn links(&mut self) {
        for id in self.mechanism.link_ids() {
            let role = match self.mechanism.driver().input {
                Input::Turn(driven) if driven == id => Role::Driver,
                Input::Turn(_) | Input::Push(_) => Role::Link,
            };
            let corners = self.corners(id);
            outline(&mut self.figure, corners, role);
        }
    }

    /// The places of a link's points, the centre of mass left out.
    fn corners(&self, link: LinkId) -> Vec<Vec2> {
        let link = self.mechanism.link(link);
        let solid = link.members.iter().filter(|m| link.com != Some(m.point));
        solid.map(|m| self.state.position(m.point)).collect()
    }

    fn slides(&mut self) {
        for (id, slide) in self.mechanism.slide_ids().zip(self.mechanism.slides()) {
            let at = self.state.position(slide.slider.point());
            let along = self.state.travel(id).guide;
            if let Body::Link(on) = slide.on {
                if self.mechanism.driver().input == Input::Push(id) {
                    self.cylinder(id, on, at, along);
                } else {
                    self.slot(id, on, at, along);
                    let pin = matches!(slide.slider, Slider::Pin(_));
                    self.figure.add(Shape::Block { at, along, pin });
                }
            } else {
                let pin = match slide.slider {
                    Slider::Pin(_) => true,
                    Slider::Link { origin, .. } => self.is_joint(origin),
                };
                self.figure.add(Shape::Block { at, along, pin });
            }
        }
    }

    /// The guide of a moving link over the whole travel, and what joins it to the link's points.
    fn slot(&mut self, id: SlideId, on: LinkId, at: Vec2, along: Vec2) {
        let Some((low, high)) = self.reach.travel(id) else {
            return;
        };
        let now = self.state.travel(id).position;
        let from = at + along * (low - now);
        let to = at + along * (high - now);
        let role = Role::Link;
        self.figure.add(Shape::Line { from, to, role });
        self.join(on, from, to);
    }

    /// A barrel as long as the shortest stroke leaves room for, and the rod from it to the point.
    fn cylinder(&mut self, id: SlideId, on: LinkId, at: Vec2, along: Vec2) {
        let now = self.state.travel(id).position;
        let shortest = self.reach.travel(id).map_or(now, |(low, _)| low);
        if shortest <= 0.0 {
            self.slot(id, on, at, along);
            return;
        }
        let foot = at - along * now;
        let rim = foot + along * (0.85 * shortest);
        let (from, to, role) = (foot, rim, Role::Driver);
        self.figure.add(Shape::Line {
            from: rim,
            to: at,
            role: Role::Link,
        });
        self.figure.add(Shape::Barrel { from, to, role });
        self.join(on, from, to);
    }

    /// Joins a guide to the nearest point of the link that carries it.
    fn join(&mut self, on: LinkId, from: Vec2, to: Vec2) {
        let along = to - from;
        let foot = |p: Vec2| {
            let share = (p - from).dot(along) / along.norm2();
            from + along
                * if share.is_finite() {
                    share.clamp(0.0, 1.0)
                } else {
                    0.0
                }
        };
        let corners = self.corners(on);
        let feet = corners.iter().map(|&p| (p, foot(p)));
        let nearest = feet.min_by(|a, b| (a.1 - a.0).norm().total_cmp(&(b.1 - b.0).norm()));
        if let Some((from, to)) = nearest {
            let role = Role::Link;
            self.figure.add(Shape::Line { from, to, role });
        }
    }

    fn is_joint(&self, point: PointId) -> bool {
        let point = self.mechanism.point(point);
        point.links.len() + usize::from(point.ground.is_some()) > 1
    }

    fn marks(&mut self) {
        if self.layers.centres {
            for com in self.mechanism.links().iter().filter_map(|l| l.com) {
                let (at, role) = (self.state.position(com), Role::CentreOfMass);
                self.figure.add(Shape::Mark { at, role });
            }
        }
        for id in self.mechanism.point_ids() {
            let point = self.mechanism.point(id);
            let is_com = self.mechanism.links().iter().any(|l| l.com == Some(id));
            let slides = self.mechanism.slides();
            let in_block = slides.iter().any(|s| s.slider.point() == id);
            if point.ground.is_some() || is_com || in_block {
                continue;
            }
            let role = if self.is_joint(id) {
                Role::Joint
            } else {
                Role::Rider
            };
            let at = self.state.position(id);
            self.figure.add(Shape::Mark { at, role });
        }
    }

    fn names(&mut self, assembled: bool) {
        if self.layers.points {
            for id in self.mechanism.point_ids() {
                let ground = self.mechanism.point(id).ground;
                let is_com = self.mechanism.links().iter().any(|l| l.com == Some(id));
                let at = match (ground, assembled) {
                    (Some(at), _) => at,
                    (None, true) => self.state.position(id),
                    (None, false) => continue,
                };
                if let (Some(name), false) = (self.scene.point_name(id), is_com) {
                    self.label(at, name);
                }
            }
        }
        if self.layers.links && assembled {
            for id in self.mechanism.link_ids() {
                let corners = self.corners(id);
                let sum = corners.iter().fold(Vec2::ZERO, |sum, &c| sum + c);
                let name = self.scene.link_name(id);
                self.label(sum / corners.len() as f64, name);
            }
        }
    }

    fn label(&mut self, at: Vec2, name: &str) {
        let (text, role) = (name.to_owned(), Role::Label);
        self.figure.add(Shape::Label { at, text, role });
    }
}

/// A line between two points, the hull of more; points inside are joined to the nearest corner.
fn outline(figure: &mut Figure, points: Vec<Vec2>, role: Role) {
    let corners = hull(points.clone());
    match corners[..] {
        [] | [_] => {}
        [from, to] => figure.add(Shape::Line { from, to, role }),
        _ => {
            for &from in points.iter().filter(|p| !corners.contains(p)) {
                let distance = |a: &Vec2| (*a - from).norm();
                let nearest = corners
                    .iter()
                    .min_by(|a, b| distance(a).total_cmp(&distance(b)));
                if let Some(&to) = nearest {
                    figure.add(Shape::Line { from, to, role });
                }
            }
            figure.add(Shape::Outline { corners, role });
        }
    }
}

/// The corners of the convex hull (Andrew 1979), counter-clockwise, without points on its edges; two
/// for points on a line.
fn hull(mut points: Vec<Vec2>) -> Vec<Vec2> {
    points.retain(|p| p.is_finite());
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let mut lower = half_hull(points.iter().copied());
    let upper = half_hull(points.iter().rev().copied());
    lower.pop();
    lower.extend(&upper[..upper.len() - 1]);
    lower
}

fn half_hull(points: impl Iterator<Item = Vec2>) -> Vec<Vec2> {
    let mut chain: Vec<Vec2> = Vec::new();
    for point in points {
        while let [.., a, b] = chain[..] {
            let (first, second) = (b - a, point - b);
            // Flatter than a hundredth of a degree is no corner to the eye.
            if first.cross(second) > 2e-4 * first.norm() * second.norm() {
                break;
            }
            chain.pop();
        }
        chain.push(point);
    }
    chain
}
