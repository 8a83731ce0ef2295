//! Tests forces in machines of every topology, against the power of all loads and against the
//! equations of motion of every link.
//!
//! `cargo test --test equilibrium` generates 200 machines; `KRANK_MACHINES=20000 cargo test
//! --release --test equilibrium` any number. A failure prints the seed of its machine, and
//! `KRANK_MACHINES_SEED` starts with that seed.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod bounds;
mod grow;
mod newton_euler;
mod random;
#[path = "../support/typed.rs"]
mod typed;

use grow::{Machine, machine};
use krank::scene::Scene;
use krank::solver::{Condition, GroupKind, Order, Solver, State};
use krank::{Input, Slide, Slider, Vec2};
use newton_euler::{Compared, Open};
use random::TestRng;
use std::collections::BTreeMap;

/// Number of machines in an ordinary run.
const ORDINARY: u64 = 200;
/// Maximum number of groups of a machine.
const MAX_GROUPS: usize = 4;
/// Maximum difference of two results, relative to the largest term.
const MAX_DIFFERENCE: f64 = 1e-9;
/// Maximum condition number of equations that are compared so precisely.
const MAX_CONDITION_NUMBER: f64 = 1e6;

/// Statistics of all machines.
#[derive(Debug, Default)]
struct RunStatistics {
    machines: u64,
    states: u64,
    /// States too close to a singular position to be compared.
    near_singular: u64,
    /// Machines with indeterminate reactions.
    redundant: u64,
    /// Compared reactions of minimum norm.
    least: u64,
    /// Number of groups by kind.
    kinds: BTreeMap<String, u64>,
    /// The largest difference, relative to the largest term.
    worst: f64,
}

fn number(name: &str) -> Option<u64> {
    std::env::var(name).ok()?.parse().ok()
}

#[test]
#[allow(clippy::print_stdout, reason = "the figures are to be read")]
fn forces_satisfy_newton_euler_in_every_topology() {
    let wanted = number("KRANK_MACHINES").unwrap_or(ORDINARY);
    let first = number("KRANK_MACHINES_SEED").unwrap_or(1);
    let mut seen = RunStatistics::default();
    for seed in first.. {
        if seen.machines >= wanted {
            break;
        }
        let Some(machine) = machine(&mut TestRng::new(seed), MAX_GROUPS, |v| v) else {
            continue;
        };
        if let Err(why) = hold(&machine, &mut seen) {
            panic!("KRANK_MACHINES_SEED={seed}: {why}\n{:?}", machine.groups);
        }
    }
    println!("{seen:#?}");
    let coupled = (3..=7).map(|n| format!("{:?}", GroupKind::Coupled { unknowns: n }));
    let dyads = ["Rrr", "Rrp", "Rpr", "Prp", "Rpp"].map(str::to_owned);
    for kind in coupled.chain(dyads) {
        let is_met = wanted < ORDINARY || seen.kinds.contains_key(&kind);
        assert!(is_met, "no {kind}: {seen:?}");
    }
    assert!(seen.states > wanted, "{seen:?}");
    assert!(
        wanted < ORDINARY || (seen.redundant > 0 && seen.least > 0),
        "{seen:?}"
    );
}

/// Checks a machine at a few positions of its motion.
fn hold(machine: &Machine, seen: &mut RunStatistics) -> Result<(), String> {
    let mechanism = &machine.mechanism;
    // A machine generated in a singular pose, or with parallel guides, is skipped.
    let Ok(solver) = Solver::new(mechanism) else {
        return Ok(());
    };
    let mut state = solver.state();
    let start = mechanism.driver().start;
    let step = match mechanism.driver().input {
        Input::Turn(_) => 1.0,
        Input::Push(_) => 0.01,
    };
    // A group that does not move has the same distance from a change point everywhere.
    for miss in &solver.motion().near_misses {
        let group = &solver.plan().groups[miss.group.index()];
        let _ = solver.solve(miss.at, Order::Velocity, &mut state);
        let mut rates = group.links.iter().map(|&link| state.omega(link));
        let mut speeds = group.points.iter().map(|&p| state.velocity(p));
        if rates.all(|rate| rate == Some(0.0)) && speeds.all(|v| v == Some(Vec2::default())) {
            return Err(format!("a near miss of links at rest: {miss:?}"));
        }
    }
    let mut any = false;
    for at in [0.0, 0.31, -0.7].map(|part| start + part * step) {
        if solver.solve(at, Order::Force, &mut state) == Condition::Ok {
            any |= compare_at(machine, &solver, &state, seen)
                .map_err(|why| format!("at {at}: {why}"))?;
        }
    }
    if any {
        seen.machines += 1;
        seen.redundant += u64::from(!solver.indeterminate().is_empty());
        for group in &solver.plan().groups {
            *seen.kinds.entry(format!("{:?}", group.kind)).or_default() += 1;
        }
    }
    Ok(())
}

/// Checks one state. Returns `false` if it is too close to a singular position to be compared.
fn compare_at(
    machine: &Machine,
    solver: &Solver,
    state: &State,
    seen: &mut RunStatistics,
) -> Result<bool, String> {
    let mechanism = &machine.mechanism;
    let Some(compared) = newton_euler::compared(mechanism, state) else {
        seen.near_singular += 1;
        return Ok(false);
    };
    if compared.condition > MAX_CONDITION_NUMBER {
        seen.near_singular += 1;
        return Ok(false);
    }
    if let Some(why) = state.withheld() {
        return Err(format!("{why:?} of {:?}", state.residual()));
    }
    let maximum = MAX_DIFFERENCE * compared.largest;
    for pair in &compared.pairs {
        let name = &pair.name;
        match (pair.found, pair.wanted) {
            (Some(found), Some(wanted)) if (found - wanted).abs() <= maximum => {
                seen.worst = seen.worst.max((found - wanted).abs() / compared.largest);
            }
            (None, None) => {}
            (found, wanted) => {
                let indeterminate = solver.indeterminate();
                return Err(format!(
                    "{name}: {found:?} and not {wanted:?}, of {} {indeterminate:?}",
                    compared.largest
                ));
            }
        }
    }
    seen.least += compare_least_norm(solver, state, &compared)?;
    let (wanted, largest) = newton_euler::power(mechanism, state);
    let found = state.power().unwrap();
    if !((found - wanted).abs() <= MAX_DIFFERENCE * largest.max(found.abs())) {
        return Err(format!("power: {found} and not {wanted}, of {largest}"));
    }
    seen.states += 1;
    Ok(true)
}

/// Compares the reactions of minimum norm with the pseudo-inverse of all equations, and returns
/// their number. Machines whose guides hold links are skipped, because couples of guides are
/// weighted differently there.
fn compare_least_norm(solver: &Solver, state: &State, compared: &Compared) -> Result<u64, String> {
    let mechanism = solver.mechanism();
    let holds_link = |slide: &Slide| matches!(slide.slider, Slider::Link { .. });
    if compared.open.is_empty() || mechanism.slides().iter().any(holds_link) {
        return Ok(0);
    }
    let minimum = solver
        .least_norm(state.at())
        .ok_or("no reactions of least norm")?;
    for &(open, wanted) in &compared.open {
        let found = match open {
            Open::JointX(link, point) => minimum.joint_force(link, point).map(|f| f.x),
            Open::JointY(link, point) => minimum.joint_force(link, point).map(|f| f.y),
            Open::Normal(slide) => minimum.normal(slide),
            Open::Moment(slide) => minimum.moment(slide),
        };
        // One component of an indeterminate force may be determinate.
        if !found.is_some_and(|found| (found - wanted).abs() <= MAX_DIFFERENCE * compared.largest) {
            return Err(format!(
                "{open:?} of least norm: {found:?} and not {wanted}"
            ));
        }
    }
    Ok(compared.open.len() as u64)
}

/// Regression test: a later group on a point of a coupled link that is not one of the group's
/// joints loaded that link twice, and the torque was 2.12541 N m.
#[test]
fn dyad_on_a_plain_point_of_a_coupled_link_loads_it_once() {
    let text = include_str!("../../presets/stephenson-six-bar.toml")
        .replace("E = [90, 100] }", "E = [90, 100], X = [50, 80] }")
        .replace("[driver]", "H = [-100, 300]\n[driver]")
        .replace(
            "[start]",
            r#"r7 = { from = "X", to = "T", length = 200 }
r8 = { from = "H", to = "T", length = 150 }
[[loads]]
point = "T"
force = [0, -100]
[start]
T = [0, 412]"#,
        );
    let torque = held(&text).abs();
    assert!((torque - 1.06270).abs() < 5e-6, "{torque} N m");
}

/// Regression test: a lift's cylinder between plain points of two arms bore twice its load.
#[test]
fn cylinder_between_two_arms_of_a_lift_bears_its_load_once() {
    held(
        r#"
unit = "m"
[ground]
O = [0, 0]
[driver]
slide = "cylinder"
position = 1.3537
speed = "50 mm/s"
[links]
a1 = { from = "O", to = "R1", length = 2, points = { M1 = [1, 0], U = [0.5, 0] } }
b1 = { from = "R0", to = "L1", length = 2, points = { M1 = [1, 0] } }
a2 = { from = "L1", to = "R2", length = 2, points = { M2 = [1, 0] } }
b2 = { from = "R1", to = "L2", length = 2, points = { M2 = [1, 0], V = [0.5, 0] } }
barrel = { points = { U = [0, 0] } }
[slides]
floor = { point = "R0", on = "ground", through = "O", angle = 0 }
cylinder = { point = "V", on = "barrel", through = "U", angle = 0 }
[start]
M1 = [0.85, 0.53]
M2 = [0.85, 1.58]
R0 = [1.7, 0]
[[loads]]
point = "L2"
force = [0, -1000]
[[loads]]
point = "R2"
force = [0, -1000]
"#,
    );
}

/// Returns the driver's effort where a scene opens, after comparing the state with all equations.
fn held(text: &str) -> f64 {
    let scene = Scene::parse(text, "test").unwrap_or_else(|e| panic!("{e}"));
    let solver = Solver::new(&scene.mechanism).unwrap();
    let mut state = solver.state();
    let at = scene.mechanism.driver().start;
    assert_eq!(solver.solve(at, Order::Force, &mut state), Condition::Ok);
    let machine = Machine {
        mechanism: scene.mechanism,
        groups: Vec::new(),
    };
    let held = compare_at(&machine, &solver, &state, &mut RunStatistics::default());
    assert_eq!(held, Ok(true));
    state.drive().unwrap()
}
