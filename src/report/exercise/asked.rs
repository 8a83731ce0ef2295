//! What is asked of a state: all that is sought in its tables, and how its points move.

use crate::Ball;
use crate::quantity::{Catalogue, Quantity};
use crate::report::tables::{ORDERS, Tables, shared_body};
use crate::report::working::Working;
use crate::scene::{Scene, VectorKind};
use crate::solver::{Order, Solver, State};
use crate::study::{AnswerKey, AskedFigure, SolutionChain};

/// Smaller parts of the largest figure of a kind are 0: nobody is asked for them.
const NOUGHT: f64 = 1e-9;

/// What is asked of a state that was solved with forces and enclosed, and what else has a name in `more`.
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
    for quantity in names(scene, &tables).iter().filter_map(of_name) {
        if !is_nought(&quantity, &catalogue, state) {
            quantities.push(quantity);
        }
    }
    for quantity in more.iter().filter_map(of_name) {
        if !quantities.contains(&quantity) {
            quantities.push(quantity);
        }
    }
    let figures = quantities.into_iter().filter_map(|quantity| {
        Some(AskedFigure {
            exact: quantity.value(state)?,
            bound: quantity.bound(state, enclosure),
            scale: scale(&quantity, &catalogue, state),
            quantity,
        })
    });
    let figures = figures.collect();
    let working = Working::new(scene, solver);
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
        figures,
        others: others.unwrap_or_default(),
        chain,
    }
}

/// The names of all that is sought, by order; then the points.
fn names(scene: &Scene, tables: &Tables) -> Vec<String> {
    let mut names = Vec::new();
    for order in [0, 1, 2] {
        for (number, column) in tables.vectors.iter().enumerate() {
            let vector = scene.vectors.get(number);
            let [length, angle] = own_parts(scene, vector.map(|vector| vector.kind));
            let of_length = length.then_some(column.length).flatten();
            let lengths = of_length.map(|entries| (entries[order], STRETCHING[order]));
            // What turns with a link has an angle of its own, and the link's rates.
            let is_asked = angle || order == 0;
            let angles = is_asked.then_some((column.direction[order], TURNING[order]));
            for (entry, aspect) in lengths.into_iter().chain(angles) {
                if !entry.given && entry.value.is_some() {
                    names.push(format!("{}.{aspect}", column.name));
                }
            }
        }
    }
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

/// Whether a vector has a length and an angle whose rates are its own.
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

/// Whether a size is so small beside others of its kind that it is 0.
fn is_nought(quantity: &Quantity, catalogue: &Catalogue, state: &State) -> bool {
    // A direction that exists is as good as any; that of nothing is none.
    let size_of = quantity.name.strip_suffix(".angle");
    let size = size_of.and_then(|name| catalogue.find(name));
    let of = match (&size, quantity.is_direction()) {
        (Some(size), _) => size,
        (None, true) => return false,
        (None, false) => quantity,
    };
    let value = of.value(state).unwrap_or(0.0);
    value.abs() <= NOUGHT * scale(of, catalogue, state)
}

/// The largest figure with the same unit.
fn scale(quantity: &Quantity, catalogue: &Catalogue, state: &State) -> f64 {
    let same = catalogue.all().iter().filter(|q| q.unit == quantity.unit);
    let sizes = same.filter_map(|q| q.value(state)).map(f64::abs);
    let own = quantity.value(state).map_or(0.0, f64::abs);
    sizes.fold(own, f64::max)
}

/// The positions of the other assemblies that close: one group at a time has another way.
fn other_states(solver: &Solver, at: f64) -> Vec<State> {
    let groups = solver.plan().numbered().filter(|(_, g)| g.has_choices());
    let choices = groups.flat_map(|(id, _)| solver.choices(at, id));
    let others = choices.filter(|choice| !choice.is_current && choice.closes);
    let states = others.map(|choice| choice.state);
    states.filter(|state| state.has(Order::Position)).collect()
}
