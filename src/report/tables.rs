//! The position, velocity and acceleration tables of one state, laid out as in the lectures.

use super::answers::Answers;
use super::entry::{Entry, PlaneVector, ROUNDED_UP};
use super::forces::Forces;
use crate::quantity::{Aspect, Subject, bound, value};
use crate::scene::{Scene, Vector, VectorKind};
use crate::solver::{Condition, Order, State};
use crate::{Ball, Body, Input, LinkId, Mechanism, PointId, Slide, SlideId, Slider, Vec2, angle};

/// Position, velocity and acceleration: the tables in their order.
pub const ORDERS: [Order; 3] = [Order::Position, Order::Velocity, Order::Acceleration];

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

/// A joint, a centre of mass or another named point.
#[derive(Clone, Debug)]
pub struct PointRow {
    /// As the scene names it.
    pub name: String,
    /// Whether it is a point of the ground: then the scene gives where it is.
    pub fixed: bool,
    /// Position, velocity and acceleration; `None` where none exists.
    pub motion: [Option<PlaneVector>; 3],
}

/// The driver in the state that the tables show.
#[derive(Clone, Debug)]
pub struct DriverLine {
    /// The driven link or slide.
    pub name: String,
    /// The link that its motor sits on, where that is not the ground.
    pub from: Option<String>,
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
    /// The forces, where anything acts and they were asked for.
    pub forces: Option<Forces>,
}

impl Tables {
    /// Reads the tables from a state that was solved to accelerations, with nothing left out.
    #[must_use]
    pub fn new(scene: &Scene, state: &State) -> Self {
        Tables::of(scene, state, None)
    }

    /// The same, with what the errors of the figures do not exceed: `enclosure` is what
    /// [`Solver::enclose`](crate::solver::Solver::enclose) made of the state.
    #[must_use]
    pub fn bounded(scene: &Scene, state: &State, enclosure: &State<Ball>) -> Self {
        Tables::of(scene, state, Some(enclosure))
    }

    /// The figures that exist, and of these how many have no bound.
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
        let all = vectors.chain(planes).chain(forces);
        let exist = all.filter(|entry| entry.value.is_some());
        exist.fold((0, 0), |(all, unproved), entry| {
            (all + 1, unproved + u64::from(entry.bound.is_none()))
        })
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

/// A state, and what is proved of its figures.
pub(super) struct ProvedState<'a> {
    pub(super) mechanism: &'a Mechanism,
    pub(super) state: &'a State,
    pub(super) enclosure: Option<&'a State<Ball>>,
    /// Whether the scene has a motion over time: then nobody need have typed what its driver does.
    pub(super) is_timed: bool,
}

impl ProvedState<'_> {
    /// How far a distance that was had from given coordinates can be from the true one: as far as from
    /// that of the state, and the state's from the truth.
    fn distance_bound(&self, subject: Subject, distance: f64) -> Option<f64> {
        let solved = value(subject, Aspect::Length, self.state)?;
        let bound = self.bound(subject, Aspect::Length)?;
        Some((bound + (solved - distance).abs()) * ROUNDED_UP)
    }

    pub(super) fn bound(&self, subject: Subject, aspect: Aspect) -> Option<f64> {
        bound(subject, aspect, self.state, self.enclosure?)
    }

    /// A rate of the driver: given, but in another unit perhaps, and converted.
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
    let (name, turns) = match scene.mechanism.driver().input {
        Input::Turn(link) => (scene.link_name(link), true),
        Input::Push(slide) => (scene.slide_name(slide), false),
    };
    DriverLine {
        name: name.to_owned(),
        from: scene
            .seat_name(scene.mechanism.driver().input)
            .map(str::to_owned),
        turns,
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

fn plane(point: PointId, order: Order, reading: &ProvedState<'_>) -> Option<PlaneVector> {
    let (x, y) = match order {
        Order::Position => (Aspect::X, Aspect::Y),
        Order::Velocity => (Aspect::Vx, Aspect::Vy),
        Order::Acceleration | Order::Force => (Aspect::Ax, Aspect::Ay),
    };
    let subject = Subject::Point(point);
    let component = |aspect| value(subject, aspect, reading.state);
    let components = Vec2::new(component(x)?, component(y)?);
    let bounds = [x, y].map(|aspect| reading.bound(subject, aspect));
    Some(PlaneVector::new(components, bounds))
}

/// The lengths of a rigid vector: one that is given and never changes.
const fn rigid(length: f64) -> [Entry; 3] {
    [Entry::given(length), Entry::given(0.0), Entry::given(0.0)]
}

/// What a scene says by itself about a coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum GivenCoordinate {
    /// Nothing: the coordinate is found.
    Nothing,
    /// It never changes.
    Fixed,
    /// It is the driver's, or goes with it.
    Driven,
    /// It is that of an input that follows the driver.
    Followed,
}

/// Three figures of a subject. Rates that the scene gives exist at a dead point too.
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

/// The direction of a link and its rates.
fn turning(mechanism: &Mechanism, link: LinkId, reading: &ProvedState<'_>) -> [Entry; 3] {
    let known = known_direction(mechanism, Body::Link(link));
    let mut entries = read(Subject::Link(link), Aspect::TURNING, known, reading);
    if known == GivenCoordinate::Driven && entries[0].value.is_some() {
        // As it was asked, without the detour over the direction's components; but a coordinate that is not
        // within one turn, or that follows from a time, is no longer the number that was typed.
        let at = reading.state.at();
        let wrapped = angle::wrapped(at);
        let away = entries[0].value.map(|value| (value - wrapped).abs());
        let away = away.map(|away| away.min((angle::TURN - away).abs()));
        let bound = entries[0].bound.zip(away);
        entries[0].value = Some(wrapped);
        entries[0].bound = match wrapped == at && !reading.is_timed {
            true => Some(0.0),
            false => bound.map(|(bound, away)| (bound + away) * ROUNDED_UP),
        };
    }
    entries
}

/// The scene gives the direction of the driven link, and of a link that cannot turn.
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

/// The coordinate of an input is the driver's, or follows it.
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

/// A vector between two points of one body keeps its length, and turns as the body does.
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

/// The body that carries both points, and the vector between them in its frame.
pub(super) fn shared_body(
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

    /// The table of the lecture's four-bar with another speed, at a coordinate.
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

    /// The driver's own figures are given, but not always in the form that is shown.
    #[test]
    fn what_is_given_in_another_form_has_the_bound_of_its_conversion() {
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
