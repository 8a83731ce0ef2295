//! Determines the values requested in an exercise: the unknowns of the tables, and the motion of
//! the points.

use crate::Ball;
use crate::quantity::{Catalogue, Quantity};
use crate::report::tables::{ORDERS, Tables, shared_body};
use crate::report::working::Working;
use crate::scene::{Scene, VectorKind};
use crate::solver::{Order, Solver, State};
use crate::study::{AnswerKey, LinkPoints, RequiredValue, SolutionChain};

/// Values below this fraction of the largest value of their kind are 0.
const NOUGHT: f64 = 1e-9;
/// Number of digits passed to the loops; their values are not used here.
const DIGITS: usize = 6;

/// Returns the answer key of a state solved with forces and enclosed, including the values named in
/// `more`.
#[must_use]
pub fn answer_key(
    scene: &Scene,
    solver: &Solver,
    state: &State,
    enclosure: &State<Ball>,
    more: &[String],
) -> AnswerKey {
    let catalogue = Catalogue::new(scene);
    let tables = Tables::bounded(scene, state, enclosure);
    let of_name = |name: &String| catalogue.find(name);
    let mut quantities: Vec<Quantity> = Vec::new();
    let scales = FigureScales::new(&catalogue, state, scene.unit.symbol());
    let working = Working::new(scene, solver);
    let loops = working.loop_vectors(scene, solver, state, DIGITS);
    let is_on_sheet = |name: &String| {
        let vectors = loops.iter().flat_map(|of| &of.vectors);
        let mut figures = vectors.flat_map(|vector| vector.figures.iter().flatten());
        loops.is_empty() || figures.any(|figure| figure.is_sought && figure.column == *name)
    };
    let names = vector_names(scene, &tables);
    let on_sheet = names.iter().filter(|name| is_on_sheet(name));
    quantities.extend(on_sheet.filter_map(of_name));
    // A point at rest has no vector to draw.
    let of_points = point_names(&tables);
    let of_points = of_points.iter().filter_map(of_name);
    quantities.extend(of_points.filter(|quantity| !scales.is_zero_value(quantity, enclosure)));
    let requested = quantities.len();
    for quantity in more.iter().filter_map(of_name) {
        if !quantities.contains(&quantity) {
            quantities.push(quantity);
        }
    }
    let mut asked_for = Vec::new();
    let mut besides = Vec::new();
    for (number, quantity) in quantities.into_iter().enumerate() {
        let Some(value) = quantity.value(state) else {
            continue;
        };
        // Values that are 0 up to rounding errors become 0.
        let is_nought = !quantity.is_direction() && scales.is_zero_value(&quantity, enclosure);
        let exact = if is_nought { 0.0 } else { value };
        let figure = RequiredValue {
            exact,
            bound: quantity.bound(state, enclosure),
            scale: scales.of(&quantity),
            quantity,
        };
        match number < requested {
            true => asked_for.push(figure),
            false => besides.push(figure),
        }
    }
    let requested = asked_for.len();
    asked_for.extend(besides);
    let chain = working.chain(scene, solver, state);
    let others = chain.as_ref().map(|chain| {
        let states = other_states(solver, state.at());
        let values = states.iter().filter_map(|other| {
            let positions = working.positions(scene, solver, other)?;
            SolutionChain::rates_at(chain, &positions)
        });
        values.collect()
    });
    AnswerKey {
        figures: asked_for,
        required: requested,
        others: others.unwrap_or_default(),
        chain,
        bodies: link_points(scene),
    }
}

/// Returns the points of every link with their local coordinates.
fn link_points(scene: &Scene) -> Vec<LinkPoints> {
    let links = scene.mechanism.links().iter();
    let points = links.map(|link| {
        let members = link.members.iter();
        members.map(|member| (member.point, member.local)).collect()
    });
    points.collect()
}

/// Returns the names of the unknowns of the vectors, by order of derivative.
fn vector_names(scene: &Scene, tables: &Tables) -> Vec<String> {
    let mut names = Vec::new();
    for order in [0, 1, 2] {
        for (number, column) in tables.vectors.iter().enumerate() {
            let vector = scene.vectors.get(number);
            let [length, angle] = own_parts(scene, vector.map(|vector| vector.kind));
            let of_length = length.then_some(column.length).flatten();
            let lengths = of_length.map(|entries| (entries[order], STRETCHING[order]));
            // A vector fixed to a link has its own angle, but the rates of the link.
            let is_asked = angle || order == 0;
            let angles = is_asked.then_some((column.direction[order], TURNING[order]));
            for (entry, aspect) in lengths.into_iter().chain(angles) {
                if !entry.given && entry.value.is_some() {
                    names.push(format!("{}.{aspect}", column.name));
                }
            }
        }
    }
    names
}

/// Returns the names of the unknowns of the points, by order of derivative.
fn point_names(tables: &Tables) -> Vec<String> {
    let mut names = Vec::new();
    for (order, aspect) in [(1, "v"), (2, "a")] {
        for point in tables.points.iter().filter(|point| !point.fixed) {
            let moves = point.motion[order].is_some_and(|motion| motion.direction.is_some());
            if moves {
                names.push(format!("{}.{aspect}", point.name));
                names.push(format!("{}.{aspect}.angle", point.name));
            }
        }
    }
    names
}

const STRETCHING: [&str; ORDERS.len()] = ["length", "rate", "accel"];
const TURNING: [&str; ORDERS.len()] = ["angle", "omega", "alpha"];

/// Returns whether the rates of a vector's length and of its angle are its own.
fn own_parts(scene: &Scene, kind: Option<VectorKind>) -> [bool; 2] {
    match kind {
        None | Some(VectorKind::Link(_)) => [false, true],
        Some(VectorKind::Slide(_)) => [true, false],
        Some(VectorKind::Between(..)) if is_rigid(scene, kind) => [false, false],
        Some(VectorKind::Between(..)) => [true, true],
    }
}

fn is_rigid(scene: &Scene, kind: Option<VectorKind>) -> bool {
    match kind {
        Some(VectorKind::Between(tail, head)) => {
            shared_body(&scene.mechanism, tail, head).is_some()
        }
        _ => false,
    }
}

/// The magnitude of values of each unit in a state.
struct FigureScales<'a> {
    catalogue: &'a Catalogue,
    state: &'a State,
    /// The maximum absolute value of each unit.
    largest: Vec<(String, f64)>,
}

impl FigureScales<'_> {
    fn new<'a>(catalogue: &'a Catalogue, state: &'a State, length: &str) -> FigureScales<'a> {
        let mut largest: Vec<(String, f64)> = Vec::new();
        for quantity in catalogue.all() {
            let size = quantity.value(state).map_or(0.0, f64::abs);
            match largest.iter_mut().find(|(unit, _)| *unit == quantity.unit) {
                Some((_, known)) => *known = known.max(size),
                None => largest.push((quantity.unit.clone(), size)),
            }
        }
        let mut scales = FigureScales {
            catalogue,
            state,
            largest,
        };
        scales.raise(length);
        scales
    }

    /// Raises the maxima of rates to the sizes implied by speeds, angles and lengths. If all values
    /// of a kind are 0, the maximum would be a rounding error.
    fn raise(&mut self, length: &str) {
        let of = |unit: &str| self.of_unit(unit);
        let size = of(length);
        let by_velocity = match size > 0.0 {
            true => of(&format!("{length}/s")) / size,
            false => 0.0,
        };
        // Per second, and squared per second squared.
        let pace = of("rad/s").max(by_velocity);
        let floors = [
            ("rad/s".to_owned(), pace),
            ("rad/s^2".to_owned(), pace * pace),
            (format!("{length}/s"), pace * size),
            (format!("{length}/s^2"), pace * pace * size),
        ];
        for (unit, floor) in floors {
            let known = self.largest.iter_mut().find(|(own, _)| *own == unit);
            if let Some((_, known)) = known {
                *known = known.max(floor);
            }
        }
    }

    fn of_unit(&self, unit: &str) -> f64 {
        let known = self.largest.iter().find(|(own, _)| own == unit);
        known.map_or(0.0, |(_, size)| *size)
    }

    /// Returns the maximum absolute value with the same unit.
    fn of(&self, quantity: &Quantity) -> f64 {
        let own = quantity.value(self.state).map_or(0.0, f64::abs);
        own.max(self.of_unit(&quantity.unit))
    }

    /// Returns `true` if a value is 0: negligible compared with others of its kind, or within its
    /// error bound.
    fn is_zero_value(&self, quantity: &Quantity, enclosure: &State<Ball>) -> bool {
        // A direction is negligible if its magnitude is.
        let size_of = quantity.name.strip_suffix(".angle");
        let size = size_of.and_then(|name| self.catalogue.find(name));
        let of = match (&size, quantity.is_direction()) {
            (Some(size), _) => size,
            (None, true) => return false,
            (None, false) => quantity,
        };
        let value = of.value(self.state).unwrap_or(0.0);
        let bound = of.bound(self.state, enclosure).unwrap_or(0.0);
        value.abs() <= (NOUGHT * self.of(of)).max(bound)
    }
}

/// Returns the positions of the other assemblies that close, with one group changed at a time.
fn other_states(solver: &Solver, at: f64) -> Vec<State> {
    let groups = solver.plan().numbered().filter(|(_, g)| g.has_choices());
    let choices = groups.flat_map(|(id, _)| solver.choices(at, id));
    let others = choices.filter(|choice| !choice.is_current && choice.closes);
    let states = others.map(|choice| choice.state);
    states.filter(|state| state.has(Order::Position)).collect()
}
