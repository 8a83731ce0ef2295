//! The position, velocity and acceleration tables of one state, laid out as in the lectures.

use super::answers::Answers;
use crate::quantity::{Aspect, Subject, value};
use crate::scene::{Scene, Vector, VectorKind};
use crate::solver::{Condition, Order, State};
use crate::{Body, Input, LinkId, Mechanism, PointId, Slide, SlideId, Slider, Vec2, angle};

/// Position, velocity and acceleration: the tables in their order.
pub const ORDERS: [Order; 3] = [Order::Position, Order::Velocity, Order::Acceleration];

/// One entry of a vector's column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// Its value; `None` where none exists.
    pub value: Option<f64>,
    /// Whether the scene gives it; otherwise it was found.
    pub given: bool,
}

/// A vector's column in the tables: entries by [`Order`].
#[derive(Clone, Debug)]
pub struct VectorColumn {
    /// As the scene names it.
    pub name: String,
    /// Its length (of a slide: the signed position along the guide) and that one's rates, in the
    /// scene's unit, per s and s^2; `None` for a link that has no two natural ends.
    pub length: Option<[Entry; 3]>,
    /// Its direction in degrees from 0 to below 360, and that one's rates in rad/s and rad/s^2.
    pub direction: [Entry; 3],
}

/// A plane vector in the ground frame, by components and by magnitude and direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Both components, in the scene's unit (per s, per s^2).
    pub components: Vec2,
    /// Its length.
    pub magnitude: f64,
    /// Its direction in degrees from 0 to below 360; the null vector has none.
    pub direction: Option<f64>,
}

/// A joint, a centre of mass or another named point.
#[derive(Clone, Debug)]
pub struct PointRow {
    /// As the scene names it.
    pub name: String,
    /// Whether it is a point of the ground: then the scene gives where it is.
    pub fixed: bool,
    /// Position, velocity and acceleration; `None` where none exists.
    pub motion: [Option<Plane>; 3],
}

/// The driver in the state that the tables show.
#[derive(Clone, Debug)]
pub struct DriverLine {
    /// The driven link or slide.
    pub name: String,
    /// Whether it is a turned link; otherwise it is a pushed slide.
    pub turns: bool,
    /// Its coordinate as asked (deg, or the scene's unit), and its rates per s and s^2 (rad, or the
    /// scene's unit).
    pub values: [f64; 3],
}

impl DriverLine {
    /// What its values are.
    pub(super) fn aspects(&self) -> [Aspect; 3] {
        if self.turns {
            Aspect::TURNING
        } else {
            Aspect::STRETCHING
        }
    }
}

/// Everything that the tables of one state say.
#[derive(Clone, Debug)]
pub struct Tables {
    /// The scene's title.
    pub scene: String,
    /// The symbol of its length unit.
    pub unit: &'static str,
    /// The driver.
    pub driver: DriverLine,
    /// What the state is.
    pub condition: Condition,
    /// The vectors of the loop equations, in the order of the file; then the links that are given
    /// by their points alone.
    pub vectors: Vec<VectorColumn>,
    /// The named points: joints, further points and centres of mass.
    pub points: Vec<PointRow>,
    /// What the given lengths do to the figures, where that was asked for.
    pub answers: Option<Answers>,
}

impl Tables {
    /// Reads the tables from a state that was solved to accelerations, with nothing left out.
    #[must_use]
    pub fn new(scene: &Scene, state: &State) -> Self {
        let mechanism = &scene.mechanism;
        let named = scene.vectors.iter();
        let vectors = named.map(|vector| vector_column(mechanism, vector, state));
        let without_ends = mechanism
            .link_ids()
            .filter(|&link| mechanism.link(link).ends.is_none())
            .map(|link| VectorColumn {
                name: scene.link_name(link).to_owned(),
                length: None,
                direction: turning(mechanism, link, state),
            });
        Tables {
            scene: scene.name.clone(),
            unit: scene.unit.symbol(),
            driver: driver_line(scene, state),
            condition: state.condition(),
            vectors: vectors.chain(without_ends).collect(),
            points: point_rows(scene, state),
            answers: None,
        }
    }
}

fn driver_line(scene: &Scene, state: &State) -> DriverLine {
    let (name, turns) = match scene.mechanism.driver().input {
        Input::Turn(link) => (scene.link_name(link), true),
        Input::Push(slide) => (scene.slide_name(slide), false),
    };
    DriverLine {
        name: name.to_owned(),
        turns,
        values: [
            state.at(),
            state.driver_speed(),
            state.driver_acceleration(),
        ],
    }
}

fn point_rows(scene: &Scene, state: &State) -> Vec<PointRow> {
    let named = |point| Some((point, scene.point_name(point)?));
    let points = scene.mechanism.point_ids().filter_map(named);
    points
        .map(|(point, name)| PointRow {
            name: name.to_owned(),
            fixed: scene.mechanism.point(point).ground.is_some(),
            motion: ORDERS.map(|order| plane(point, order, state)),
        })
        .collect()
}

fn plane(point: PointId, order: Order, state: &State) -> Option<Plane> {
    let (x, y) = match order {
        Order::Position => (Aspect::X, Aspect::Y),
        Order::Velocity => (Aspect::Vx, Aspect::Vy),
        Order::Acceleration => (Aspect::Ax, Aspect::Ay),
    };
    let component = |aspect| value(Subject::Point(point), aspect, state);
    let components = Vec2::new(component(x)?, component(y)?);
    Some(Plane {
        components,
        magnitude: components.norm(),
        direction: (components != Vec2::ZERO).then(|| angle::degrees(components)),
    })
}

const fn given(value: f64) -> Entry {
    let value = Some(value);
    Entry { value, given: true }
}

/// The lengths of a rigid vector: one that is given and never changes.
const fn rigid(length: f64) -> [Entry; 3] {
    [given(length), given(0.0), given(0.0)]
}

/// What a scene says by itself about a coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Known {
    /// Nothing: the coordinate is found.
    Nothing,
    /// It never changes.
    Fixed,
    /// It is the driver's, or goes with it.
    Driven,
}

/// Three figures of a subject. Rates that the scene gives exist at a dead point too.
fn read(subject: Subject, aspects: [Aspect; 3], known: Known, state: &State) -> [Entry; 3] {
    let entry = |aspect| Entry {
        value: value(subject, aspect, state),
        given: known != Known::Nothing,
    };
    let [position, rate, accel] = aspects;
    let (rate, accel) = match known {
        Known::Nothing => (entry(rate), entry(accel)),
        Known::Fixed => (given(0.0), given(0.0)),
        Known::Driven => (
            given(state.driver_speed()),
            given(state.driver_acceleration()),
        ),
    };
    [entry(position), rate, accel]
}

fn vector_column(mechanism: &Mechanism, vector: &Vector, state: &State) -> VectorColumn {
    let (length, direction) = match vector.kind {
        VectorKind::Link(link) => {
            let ends = mechanism.link(link).ends;
            let to = ends.and_then(|(_, to)| mechanism.link(link).local(to));
            let length = to.map(|local| rigid(local.norm()));
            (length, turning(mechanism, link, state))
        }
        VectorKind::Slide(slide) => slide_entries(mechanism, slide, state),
        VectorKind::Between(tail, head) => between_entries(mechanism, tail, head, state),
    };
    VectorColumn {
        name: vector.name.clone(),
        length,
        direction,
    }
}

/// The direction of a link and its rates.
fn turning(mechanism: &Mechanism, link: LinkId, state: &State) -> [Entry; 3] {
    let known = known_direction(mechanism, Body::Link(link));
    let mut entries = read(Subject::Link(link), Aspect::TURNING, known, state);
    if known == Known::Driven && entries[0].value.is_some() {
        // As it was asked, without the detour over the direction's components.
        entries[0].value = Some(angle::wrapped(state.at()));
    }
    entries
}

/// The scene gives the direction of the driven link, and of a link that cannot turn.
fn known_direction(mechanism: &Mechanism, body: Body) -> Known {
    let Body::Link(link) = body else {
        return Known::Fixed;
    };
    let locks = |slide: &Slide| match slide.slider {
        Slider::Link { link: sliding, .. } => sliding == link && slide.on == Body::Ground,
        Slider::Pin(_) => false,
    };
    if mechanism.driver().input == Input::Turn(link) {
        Known::Driven
    } else if mechanism.slides().iter().any(locks) {
        Known::Fixed
    } else {
        Known::Nothing
    }
}

/// Length and direction of a vector, each with its rates.
type Pair = (Option<[Entry; 3]>, [Entry; 3]);

fn slide_entries(mechanism: &Mechanism, slide: SlideId, state: &State) -> Pair {
    let subject = Subject::Slide(slide);
    let position = if mechanism.driver().input == Input::Push(slide) {
        Known::Driven
    } else {
        Known::Nothing
    };
    let guide = known_direction(mechanism, mechanism.slide(slide).on);
    (
        Some(read(subject, Aspect::STRETCHING, position, state)),
        read(subject, Aspect::TURNING, guide, state),
    )
}

/// A vector between two points of one body keeps its length, and turns as the body does.
fn between_entries(mechanism: &Mechanism, tail: PointId, head: PointId, state: &State) -> Pair {
    let subject = Subject::Between(tail, head);
    match shared_body(mechanism, tail, head) {
        None => (
            Some(read(subject, Aspect::STRETCHING, Known::Nothing, state)),
            read(subject, Aspect::TURNING, Known::Nothing, state),
        ),
        Some((body, local)) => {
            let known = known_direction(mechanism, body);
            (
                Some(rigid(local.norm())),
                read(subject, Aspect::TURNING, known, state),
            )
        }
    }
}

/// The body that carries both points, and the vector between them in its frame.
fn shared_body(mechanism: &Mechanism, tail: PointId, head: PointId) -> Option<(Body, Vec2)> {
    let (from, to) = (mechanism.point(tail), mechanism.point(head));
    if let (Some(from), Some(to)) = (from.ground, to.ground) {
        return Some((Body::Ground, to - from));
    }
    from.links.iter().find_map(|&link| {
        let local = |point| mechanism.link(link).local(point);
        Some((Body::Link(link), local(head)? - local(tail)?))
    })
}
