//! Tables of positions, velocities and accelerations of one state, in the layout of the lectures.

pub(in crate::report) mod answers;
pub(in crate::report) mod data;
pub(in crate::report) mod difference;
pub(in crate::report) mod entry;
pub(in crate::report) mod figure_list;
pub(in crate::report) mod page;

use crate::quantity::{Aspect, Subject, bound, value};
use crate::report::forces::Forces;
use crate::report::tables::answers::Answers;
use crate::report::tables::entry::{Entry, PlaneVector, ROUND_UP_FACTOR};
use crate::scene::{Scene, Vector, VectorKind};
use crate::solver::{Condition, Order, State};
use crate::{Ball, Body, Input, LinkId, Mechanism, PointId, Slide, SlideId, Slider, Vec2, angle};

/// The orders of the tables: position, velocity and acceleration.
pub const ORDERS: [Order; 3] = [Order::Position, Order::Velocity, Order::Acceleration];

/// A vector's column in the tables; entries are indexed by [`Order`].
#[derive(Clone, Debug)]
pub struct VectorColumn {
    /// The name given by the scene.
    pub name: String,
    /// The length (for a slide, the signed position along the guide) and its derivatives, in the
    /// scene's unit, per s and s^2; `None` for a link without two natural ends.
    pub length: Option<[Entry; 3]>,
    /// The direction in degrees from 0 to below 360, and its derivatives in rad/s and rad/s^2.
    pub direction: [Entry; 3],
}

/// A joint, a centre of mass or another named point.
#[derive(Clone, Debug)]
pub struct PointRow {
    /// The name given by the scene.
    pub name: String,
    /// `true` for a point of the ground: its position is given.
    pub fixed: bool,
    /// Position, velocity and acceleration; `None` if it does not exist.
    pub motion: [Option<PlaneVector>; 3],
}

/// The driver in the state of the tables.
#[derive(Clone, Debug)]
pub struct DriverLine {
    /// The driven link or slide.
    pub name: String,
    /// The link that carries the motor; `None` for the ground.
    pub from: Option<String>,
    /// `true` for a rotating link, `false` for a slide.
    pub is_rotary: bool,
    /// The requested coordinate (deg, or the scene's unit), and its rates per s and s^2 (rad, or
    /// the scene's unit).
    pub values: [f64; 3],
}

impl DriverLine {
    /// Returns the aspects of its values.
    pub(in crate::report) fn aspects(&self) -> [Aspect; 3] {
        if self.is_rotary {
            Aspect::TURNING
        } else {
            Aspect::STRETCHING
        }
    }
}

/// The contents of the tables of one state.
#[derive(Clone, Debug)]
pub struct Tables {
    /// The title of the scene.
    pub scene: String,
    /// The symbol of the scene's unit of length.
    pub unit: &'static str,
    /// The driver.
    pub driver: DriverLine,
    /// The condition of the state.
    pub condition: Condition,
    /// The vectors of the loop equations in the order of the file, followed by the links without
    /// two ends.
    pub vectors: Vec<VectorColumn>,
    /// The named points: joints, further points and centres of mass.
    pub points: Vec<PointRow>,
    /// The sensitivities of the values to the given lengths, if requested.
    pub answers: Option<Answers>,
    /// The forces, if requested and if there are loads.
    pub forces: Option<Forces>,
}

impl Tables {
    /// Evaluates the tables of a state solved completely up to accelerations.
    #[must_use]
    pub fn new(scene: &Scene, state: &State) -> Self {
        Tables::of(scene, state, None)
    }

    /// Evaluates the tables with error bounds; `enclosure` is the result of
    /// [`Solver::enclose`](crate::solver::Solver::enclose) for the state.
    #[must_use]
    pub fn bounded(scene: &Scene, state: &State, enclosure: &State<Ball>) -> Self {
        Tables::of(scene, state, Some(enclosure))
    }

    /// Returns the number of existing values, and the number of these without a bound.
    #[must_use]
    pub fn unproved(&self) -> (u64, u64) {
        let vectors = self.vectors.iter().flat_map(|vector| {
            let lengths = vector.length.into_iter().flatten();
            lengths.chain(vector.direction)
        });
        let planes = self.points.iter().flat_map(|point| {
            let planes = point.motion.iter().flatten();
            planes.flat_map(|plane| plane.entries(point.fixed))
        });
        let forces = self.forces.iter().flat_map(Forces::figures);
        let forces = forces.map(|(_, _, entry)| entry);
        unproved(vectors.chain(planes).chain(forces))
    }

    fn of(scene: &Scene, state: &State, enclosure: Option<&State<Ball>>) -> Self {
        let reading = ProvedState {
            mechanism: &scene.mechanism,
            state,
            enclosure,
            is_timed: scene.motion.is_some(),
        };
        let mechanism = &scene.mechanism;
        let named = scene.vectors.iter();
        let vectors = named.map(|vector| vector_column(mechanism, vector, &reading));
        let without_ends = mechanism
            .link_ids()
            .filter(|&link| mechanism.link(link).ends.is_none())
            .map(|link| VectorColumn {
                name: scene.link_name(link).to_owned(),
                length: None,
                direction: turning(mechanism, link, &reading),
            });
        Tables {
            scene: scene.name.clone(),
            unit: scene.unit.symbol(),
            driver: driver_line(scene, state),
            condition: state.condition(),
            vectors: vectors.chain(without_ends).collect(),
            points: point_rows(scene, &reading),
            answers: None,
            forces: None,
        }
    }
}

/// Returns the number of existing values, and the number of these without a bound.
pub(in crate::report) fn unproved(entries: impl Iterator<Item = Entry>) -> (u64, u64) {
    let exist = entries.filter(|entry| entry.value.is_some());
    exist.fold((0, 0), |(all, unproved), entry| {
        (all + 1, unproved + u64::from(entry.bound.is_none()))
    })
}

/// A state with its enclosure.
pub(in crate::report) struct ProvedState<'a> {
    pub(in crate::report) mechanism: &'a Mechanism,
    pub(in crate::report) state: &'a State,
    pub(in crate::report) enclosure: Option<&'a State<Ball>>,
    /// Whether the scene has a motion over time, so that the driver's rates need not be typed
    /// values.
    pub(in crate::report) is_timed: bool,
}

impl ProvedState<'_> {
    /// Returns the error bound of a distance computed from given coordinates: its difference from
    /// that of the state, plus the bound of the state.
    fn distance_bound(&self, subject: Subject, distance: f64) -> Option<f64> {
        let solved = value(subject, Aspect::Length, self.state)?;
        let bound = self.bound(subject, Aspect::Length)?;
        Some((bound + (solved - distance).abs()) * ROUND_UP_FACTOR)
    }

    pub(in crate::report) fn bound(&self, subject: Subject, aspect: Aspect) -> Option<f64> {
        bound(subject, aspect, self.state, self.enclosure?)
    }

    /// Returns a rate of the driver as a given value, with a bound if it was converted or follows a
    /// motion.
    fn driver_rate(&self, aspect: Aspect, rate: f64) -> Entry {
        let given = Entry::given(rate);
        if !self.mechanism.has_converted_rates() && !self.is_timed {
            return given;
        }
        Entry {
            bound: self.bound(Subject::Driver, aspect),
            ..given
        }
    }
}

fn driver_line(scene: &Scene, state: &State) -> DriverLine {
    let driver = scene.mechanism.driver();
    DriverLine {
        name: scene.input_name(driver.input).to_owned(),
        from: scene.seat_name(driver.input).map(str::to_owned),
        is_rotary: driver.turns(),
        values: [
            state.at(),
            state.driver_speed(),
            state.driver_acceleration(),
        ],
    }
}

fn point_rows(scene: &Scene, reading: &ProvedState<'_>) -> Vec<PointRow> {
    scene
        .listed_points()
        .map(|(point, name)| PointRow {
            name: name.to_owned(),
            fixed: scene.mechanism.point(point).ground.is_some(),
            motion: ORDERS.map(|order| plane(point, order, reading)),
        })
        .collect()
}

/// Returns the names and aspects of a point's values: both components, magnitude and direction.
pub(in crate::report) fn point_aspects(order: Order) -> [(&'static str, Aspect); 4] {
    use Aspect::{Angle, Ax, Ay, Vx, Vy, X, Y};
    let all = [
        [("x", X), ("y", Y), ("r", X), ("r.angle", Angle)],
        [("vx", Vx), ("vy", Vy), ("v", Vx), ("v.angle", Angle)],
        [("ax", Ax), ("ay", Ay), ("a", Ax), ("a.angle", Angle)],
    ];
    all[index(order)]
}

/// Returns the entries of a point's values.
pub(in crate::report) fn point_entries(point: &PointRow, order: Order) -> [Entry; 4] {
    let none = Entry {
        given: point.fixed,
        ..Entry::NONE
    };
    let plane = point.motion[index(order)];
    plane.map_or([none; 4], |plane| plane.entries(point.fixed))
}

/// Returns the number of differentiations; forces belong to accelerations.
pub(in crate::report) fn index(order: Order) -> usize {
    (order as usize).min(Order::Acceleration as usize)
}

fn plane(point: PointId, order: Order, reading: &ProvedState<'_>) -> Option<PlaneVector> {
    let [(_, x), (_, y), ..] = point_aspects(order);
    let subject = Subject::Point(point);
    let component = |aspect| value(subject, aspect, reading.state);
    let components = Vec2::new(component(x)?, component(y)?);
    let bounds = [x, y].map(|aspect| reading.bound(subject, aspect));
    Some(PlaneVector::new(components, bounds))
}

/// Returns the lengths of a rigid vector: given and constant.
const fn rigid(length: f64) -> [Entry; 3] {
    [Entry::given(length), Entry::given(0.0), Entry::given(0.0)]
}

/// The origin of a coordinate, as far as the scene gives it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum GivenCoordinate {
    /// The coordinate is computed.
    Nothing,
    /// The coordinate is constant.
    Fixed,
    /// The coordinate is the driver's, or fixed to it.
    Driven,
    /// The coordinate belongs to an input that follows the driver.
    Followed,
}

/// Evaluates three values of a subject. Rates given by the scene also exist at a dead point.
fn read(
    subject: Subject,
    aspects: [Aspect; 3],
    known: GivenCoordinate,
    reading: &ProvedState<'_>,
) -> [Entry; 3] {
    let state = reading.state;
    let entry = |aspect| Entry {
        value: value(subject, aspect, state),
        given: known != GivenCoordinate::Nothing,
        bound: reading.bound(subject, aspect),
    };
    let [position, rate, accel] = aspects;
    let (rate, accel) = match known {
        GivenCoordinate::Nothing | GivenCoordinate::Followed => (entry(rate), entry(accel)),
        GivenCoordinate::Fixed => (Entry::given(0.0), Entry::given(0.0)),
        GivenCoordinate::Driven => (
            reading.driver_rate(rate, state.driver_speed()),
            reading.driver_rate(accel, state.driver_acceleration()),
        ),
    };
    [entry(position), rate, accel]
}

fn vector_column(
    mechanism: &Mechanism,
    vector: &Vector,
    reading: &ProvedState<'_>,
) -> VectorColumn {
    let (length, direction) = match vector.kind {
        VectorKind::Link(link) => {
            let ends = mechanism.link(link).ends;
            let to = ends.and_then(|(_, to)| mechanism.link(link).local(to));
            let length = to.map(|local| rigid(local.norm()));
            (length, turning(mechanism, link, reading))
        }
        VectorKind::Slide(slide) => slide_entries(mechanism, slide, reading),
        VectorKind::Between(tail, head) => between_entries(mechanism, tail, head, reading),
    };
    VectorColumn {
        name: vector.name.clone(),
        length,
        direction,
    }
}

/// Returns the direction of a link and its rates.
fn turning(mechanism: &Mechanism, link: LinkId, reading: &ProvedState<'_>) -> [Entry; 3] {
    let known = known_direction(mechanism, Body::Link(link));
    let mut entries = read(Subject::Link(link), Aspect::TURNING, known, reading);
    if known == GivenCoordinate::Driven && entries[0].value.is_some() {
        // The requested angle itself, without computing it from components. An angle outside one
        // turn, or one that follows from a time, is no longer the typed number.
        let at = reading.state.at();
        let wrapped = angle::wrapped(at);
        let away = entries[0].value.map(|value| (value - wrapped).abs());
        let away = away.map(|away| away.min((angle::TURN - away).abs()));
        let bound = entries[0].bound.zip(away);
        entries[0].value = Some(wrapped);
        entries[0].bound = match wrapped == at && !reading.is_timed {
            true => Some(0.0),
            false => bound.map(|(bound, away)| (bound + away) * ROUND_UP_FACTOR),
        };
    }
    entries
}

/// Returns the origin of a body's direction: given for the driven link, and for a link that cannot
/// turn.
fn known_direction(mechanism: &Mechanism, body: Body) -> GivenCoordinate {
    let Body::Link(link) = body else {
        return GivenCoordinate::Fixed;
    };
    let locks = |slide: &Slide| match slide.slider {
        Slider::Link { link: sliding, .. } => sliding == link && slide.on == Body::Ground,
        Slider::Pin(_) => false,
    };
    if mechanism.is_directed(link) {
        driven(mechanism, Input::Turn(link))
    } else if mechanism.slides().iter().any(locks) {
        GivenCoordinate::Fixed
    } else {
        GivenCoordinate::Nothing
    }
}

/// Returns the origin of an input's coordinate: the driver's, or following it.
fn driven(mechanism: &Mechanism, input: Input) -> GivenCoordinate {
    match mechanism.timed_input(input) {
        None => GivenCoordinate::Driven,
        Some(_) => GivenCoordinate::Followed,
    }
}

/// Length and direction of a vector, each with its rates.
type PolarPair = (Option<[Entry; 3]>, [Entry; 3]);

fn slide_entries(mechanism: &Mechanism, slide: SlideId, reading: &ProvedState<'_>) -> PolarPair {
    let subject = Subject::Slide(slide);
    let position = if mechanism.is_pushed(slide) {
        driven(mechanism, Input::Push(slide))
    } else {
        GivenCoordinate::Nothing
    };
    let guide = known_direction(mechanism, mechanism.slide(slide).on);
    (
        Some(read(subject, Aspect::STRETCHING, position, reading)),
        read(subject, Aspect::TURNING, guide, reading),
    )
}

/// Evaluates a vector between two points. If both belong to one body, its length is constant, and
/// it turns as the body does.
fn between_entries(
    mechanism: &Mechanism,
    tail: PointId,
    head: PointId,
    reading: &ProvedState<'_>,
) -> PolarPair {
    let subject = Subject::Between(tail, head);
    match shared_body(mechanism, tail, head) {
        None => (
            Some(read(
                subject,
                Aspect::STRETCHING,
                GivenCoordinate::Nothing,
                reading,
            )),
            read(subject, Aspect::TURNING, GivenCoordinate::Nothing, reading),
        ),
        Some((body, local)) => {
            let known = known_direction(mechanism, body);
            let mut lengths = rigid(local.norm());
            lengths[0].bound = reading.distance_bound(subject, local.norm());
            (
                Some(lengths),
                read(subject, Aspect::TURNING, known, reading),
            )
        }
    }
}

/// Returns the body that carries both points, and the vector between them in its frame; `None` for
/// points of different bodies.
pub(in crate::report) fn shared_body(
    mechanism: &Mechanism,
    tail: PointId,
    head: PointId,
) -> Option<(Body, Vec2)> {
    let (from, to) = (mechanism.point(tail), mechanism.point(head));
    if let (Some(from), Some(to)) = (from.ground, to.ground) {
        return Some((Body::Ground, to - from));
    }
    from.links.iter().find_map(|&link| {
        let local = |point| mechanism.link(link).local(point);
        Some((Body::Link(link), local(head)? - local(tail)?))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;
    use crate::solver::Solver;

    /// Returns the tables of the lecture's four-bar with another speed, at a coordinate.
    fn tables(speed: &str, at: f64) -> Tables {
        let text = presets::find("four-bar").unwrap().text;
        let text = text.replacen("15 rad/s", speed, 1);
        let scene = Scene::parse(&text, "four-bar").unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let (mut state, mut enclosure) = (solver.state(), solver.enclosure());
        let _ = solver.solve(at, Order::Acceleration, &mut state);
        solver.enclose(&mut state, Order::Acceleration, &mut enclosure);
        Tables::bounded(&scene, &state, &enclosure)
    }

    /// The driver's values are given, but not always in the unit shown.
    #[test]
    fn converted_driver_values_have_bound_of_conversion() {
        let driver = |speed: &str, at: f64| {
            let tables = tables(speed, at);
            tables.vectors[0]
                .direction
                .map(|entry| entry.bound.unwrap())
        };
        assert_eq!(driver("15 rad/s", 60.0), [0.0; 3]);
        // 2 pi as a double is off by 2.4e-16, and 359.9 by 2.27373675443e-14.
        let [angle, omega, _] = driver("60 rpm", -0.1);
        assert!((2.273_736_754_43e-14..2e-13).contains(&angle), "{angle:e}");
        assert!((2.4e-16..1e-14).contains(&omega), "{omega:e}");
    }
}
