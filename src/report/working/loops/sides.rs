//! The sides of the vector polygons: the scene's vectors, and unnamed ones between two joints of
//! one body that a loop needs.

use crate::page::Symbol;
use crate::quantity::{Aspect, Subject, value};
use crate::report::tables::{index, shared_body};
use crate::report::working::symbols;
use crate::scene::{Scene, Vector, VectorKind};
use crate::solver::{Known, Order};
use crate::{Body, Input, LinkId, Mechanism, PointId, SlideId, Slider, Vec2, angle};

/// The kind of side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum SideShape {
    /// A link, from end to end.
    Link(LinkId),
    /// A slide, from the sliding point back to `through`.
    Slide(SlideId),
    /// A vector between two points of one body, with its components in the body's frame.
    Rigid(Body, Vec2),
    /// A vector between two points of different bodies.
    Free(PointId, PointId),
}

/// The dependence of a side's direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Turns {
    /// Constant.
    Never,
    /// The direction of a link plus a constant angle in degrees.
    With(LinkId, f64),
    /// Dependent on two bodies.
    Freely,
}

/// A vector of the loop equations.
#[derive(Clone, Debug)]
pub(crate) struct Side {
    pub name: String,
    pub tail: String,
    pub head: String,
    pub shape: SideShape,
    pub turns: Turns,
    /// Whether the scene names it.
    pub named: bool,
}

/// The length and direction of a side in a state, with their rates; these are 0 if they do not
/// exist.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct SideReading {
    pub r: f64,
    pub rate: f64,
    pub accel: f64,
    /// The direction in degrees, from 0 to below 360.
    pub theta: f64,
    pub omega: f64,
    pub alpha: f64,
    /// The direction as a unit vector.
    pub u: Vec2,
}

impl SideReading {
    /// Returns the vector of the side, head minus tail.
    pub(crate) fn vector(&self) -> Vec2 {
        self.u * self.r
    }

    /// Returns the length, or its rate of an order.
    pub(crate) fn length(&self, order: Order) -> f64 {
        [self.r, self.rate, self.accel][index(order)]
    }

    /// Returns the direction in degrees, or its rate of an order.
    pub(crate) fn angle(&self, order: Order) -> f64 {
        [self.theta, self.omega, self.alpha][index(order)]
    }
}

/// For every link, the link or ground to which slides lock its direction, and the angle between
/// both.
#[derive(Clone, Debug)]
pub(crate) struct Locks {
    root: Vec<Body>,
    offset: Vec<f64>,
}

impl Locks {
    pub(crate) fn of(mechanism: &Mechanism) -> Locks {
        let links = mechanism.links().len();
        let mut locks = Locks {
            root: mechanism.link_ids().map(Body::Link).collect(),
            offset: vec![0.0; links],
        };
        let mut seen = vec![false; links];
        let driven = mechanism.inputs().filter_map(|input| match input {
            Input::Turn(link) => Some(Body::Link(link)),
            Input::Push(_) => None,
        });
        let roots = [Body::Ground].into_iter().chain(driven);
        for root in roots.chain(mechanism.link_ids().map(Body::Link)) {
            if let Body::Link(link) = root
                && std::mem::replace(&mut seen[link.index()], true)
            {
                continue;
            }
            locks.walk(mechanism, root, &mut seen);
        }
        locks
    }

    /// Propagates the locks from a body.
    fn walk(&mut self, mechanism: &Mechanism, root: Body, seen: &mut [bool]) {
        let mut waiting = vec![root];
        while let Some(body) = waiting.pop() {
            let here = match body {
                Body::Ground => 0.0,
                Body::Link(link) => self.offset[link.index()],
            };
            for slide in mechanism.slides() {
                let Slider::Link { link, turn, .. } = slide.slider else {
                    continue;
                };
                let by = slide.angle + turn;
                let other = match (slide.on, Body::Link(link)) {
                    (on, _) if on == body => Some((link, here + by)),
                    (Body::Link(on), sliding) if sliding == body => Some((on, here - by)),
                    _ => None,
                };
                if let Some((other, offset)) = other
                    && !std::mem::replace(&mut seen[other.index()], true)
                {
                    self.root[other.index()] = root;
                    self.offset[other.index()] = offset;
                    waiting.push(Body::Link(other));
                }
            }
        }
    }

    /// Returns the dependence of a direction at `angle` to a body.
    pub(crate) fn turns(&self, body: Body, angle: f64) -> Turns {
        let Body::Link(link) = body else {
            return Turns::Never;
        };
        match self.root[link.index()] {
            Body::Ground => Turns::Never,
            Body::Link(root) => {
                Turns::With(root, angle::wrapped(self.offset[link.index()] + angle))
            }
        }
    }
}

impl Side {
    /// Creates the side of a vector of the scene.
    pub(crate) fn of(
        scene: &Scene,
        vector: &Vector,
        locks: &Locks,
        tail: String,
        head: String,
    ) -> Side {
        let mechanism = &scene.mechanism;
        let (shape, turns) = match vector.kind {
            VectorKind::Link(link) => (SideShape::Link(link), locks.turns(Body::Link(link), 0.0)),
            VectorKind::Slide(slide) => {
                let given = mechanism.slide(slide);
                let turns = locks.turns(given.on, given.angle + angle::TURN / 2.0);
                (SideShape::Slide(slide), turns)
            }
            VectorKind::Between(tail, head) => match shared_body(mechanism, tail, head) {
                Some((body, local)) => (
                    SideShape::Rigid(body, local),
                    locks.turns(body, angle::degrees(local)),
                ),
                None => (SideShape::Free(tail, head), Turns::Freely),
            },
        };
        Side {
            name: vector.name.clone(),
            tail,
            head,
            shape,
            turns,
            named: true,
        }
    }

    /// Returns the link with which it rotates, after which its angular velocity is named; `None` if
    /// it does not rotate, or with two bodies.
    pub(crate) fn turns_with(&self) -> Option<LinkId> {
        match self.turns {
            Turns::With(link, _) => Some(link),
            Turns::Never | Turns::Freely => None,
        }
    }

    /// Returns `true` if its length changes.
    pub(crate) fn stretches(&self) -> bool {
        matches!(self.shape, SideShape::Slide(_) | SideShape::Free(..))
    }

    /// Returns the symbol of its angle.
    pub(crate) fn theta(&self) -> Symbol {
        symbols::theta(&self.name)
    }

    /// Returns the name used for its angular velocity: that of the link with which it rotates.
    pub(crate) fn turner<'a>(&'a self, scene: &'a Scene) -> &'a str {
        self.turns_with()
            .map_or(self.name.as_str(), |link| scene.link_name(link))
    }

    /// Evaluates the side in a state that has an assembly; rates are 0 if they do not exist.
    pub(crate) fn read(&self, mechanism: &Mechanism, state: Known<'_>) -> SideReading {
        let figure = |subject, aspect| value(subject, aspect, &state).unwrap_or(0.0);
        let turning = |subject, reading: SideReading| SideReading {
            omega: figure(subject, Aspect::Omega),
            alpha: figure(subject, Aspect::Alpha),
            ..reading
        };
        match self.shape {
            SideShape::Link(link) => {
                let reading = SideReading {
                    r: length(mechanism, link),
                    theta: state.angle(link),
                    u: state.direction(link),
                    ..SideReading::default()
                };
                turning(Subject::Link(link), reading)
            }
            SideShape::Rigid(body, local) => {
                let r = local.norm();
                let at_rest = |u: Vec2| SideReading {
                    r,
                    theta: angle::degrees(u),
                    u,
                    ..SideReading::default()
                };
                // Two points of a body may coincide.
                let along = if r > 0.0 { local / r } else { Vec2::X };
                match body {
                    Body::Ground => at_rest(along),
                    Body::Link(link) => {
                        let u = along.turned(state.direction(link));
                        turning(Subject::Link(link), at_rest(u))
                    }
                }
            }
            SideShape::Slide(slide) => {
                let u = -state.travel(slide).guide;
                self.stretching(Subject::Slide(slide), u, &figure)
            }
            SideShape::Free(tail, head) => {
                let between = state.position(head) - state.position(tail);
                let u = if between == Vec2::ZERO {
                    Vec2::X
                } else {
                    between / between.norm()
                };
                self.stretching(Subject::Between(tail, head), u, &figure)
            }
        }
    }

    fn stretching(
        &self,
        subject: Subject,
        u: Vec2,
        figure: &dyn Fn(Subject, Aspect) -> f64,
    ) -> SideReading {
        SideReading {
            r: figure(subject, Aspect::Length),
            rate: figure(subject, Aspect::Rate),
            accel: figure(subject, Aspect::Accel),
            theta: angle::degrees(u),
            omega: figure(subject, Aspect::Omega),
            alpha: figure(subject, Aspect::Alpha),
            u,
        }
    }
}

/// Returns the distance of a link's ends.
pub(crate) fn length(mechanism: &Mechanism, link: LinkId) -> f64 {
    let link = mechanism.link(link);
    let to = link.ends.and_then(|(_, to)| link.local(to));
    to.map_or(0.0, Vec2::norm)
}
