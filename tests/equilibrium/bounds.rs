//! Tests error bounds in machines of every topology, against the same states in double-double
//! arithmetic.

use crate::grow::{Machine, machine};
use crate::random::TestRng;
use crate::typed::short;
use krank::quantity::{self, Aspect, Share, Subject};
use krank::solver::{Condition, GroupKind, Order, Solver, Workspace};
use krank::{Ball, Double, Input, Mechanism, Slider};

/// Driver positions relative to the start, in units of its step.
const PLACES: [f64; 5] = [0.0, 0.31, -0.7, 1.7, -2.3];
/// An error below this part of the largest value of its kind is small by chance, so that the ratio
/// of a bound to it says nothing.
const LUCK: f64 = f64::EPSILON / 2.0;
/// Maximum median ratio of force bounds to errors: for machines made of dyads only, and for others.
const NEAR: [f64; 2] = [15.0, 40.0];

/// Statistics of the checks.
#[derive(Debug, Default)]
struct Held {
    machines: u64,
    figures: u64,
    /// Values without a bound.
    unproved: u64,
    /// Ratios of bounds to errors, of motion and of forces: for machines made of dyads only, and
    /// for others.
    over: [[Vec<f64>; 2]; 2],
}

/// A value of a state.
struct Figure {
    subject: Subject,
    aspect: Aspect,
    value: f64,
    error: f64,
    bound: Option<f64>,
}

impl Figure {
    fn is_force(&self) -> bool {
        !matches!(self.subject, Subject::Point(_) | Subject::Link(_))
    }
}

/// Returns all values of motion and of forces.
fn all_figures(mechanism: &Mechanism) -> Vec<(Subject, Aspect)> {
    use Aspect::{Alpha, Angle, Ax, Ay, Fx, Fy, Moment, Normal, Omega, Vx, Vy, X, Y};
    let mut figures = Vec::new();
    let mut add = |subject: Subject, aspects: &[Aspect]| {
        figures.extend(aspects.iter().map(|&aspect| (subject, aspect)));
    };
    for point in mechanism.point_ids() {
        add(Subject::Point(point), &[X, Y, Vx, Vy, Ax, Ay]);
    }
    for link in mechanism.link_ids() {
        add(Subject::Link(link), &[Angle, Omega, Alpha]);
        for point in mechanism.pins(link) {
            add(Subject::Joint(link, point), &[Fx, Fy]);
        }
    }
    for slide in mechanism.slide_ids() {
        add(Subject::Slide(slide), &[Normal]);
        if matches!(mechanism.slide(slide).slider, Slider::Link { .. }) {
            add(Subject::Slide(slide), &[Moment]);
        }
    }
    let effort = match mechanism.driver().input {
        Input::Turn(_) => Aspect::Torque,
        _ => Aspect::Force,
    };
    add(Subject::Drive(Share::Total), &[effort, Aspect::Power]);
    figures
}

/// Compares a value with its double-double counterpart; `None` if either does not exist.
fn figure(
    (subject, aspect): (Subject, Aspect),
    (state, balls, twice): (&Workspace, &Workspace<Ball>, &Workspace<Double>),
) -> Option<Figure> {
    let value = quantity::value(subject, aspect, state)?;
    let truth = quantity::value(subject, aspect, twice)?;
    let off = (truth - Double::exactly(value)).abs();
    let is_turn = aspect == Aspect::Angle && off.hi > 180.0;
    let turn = Double::exactly(if is_turn { 360.0 } else { 0.0 });
    Some(Figure {
        subject,
        aspect,
        value,
        error: (off - turn).hi.abs(),
        bound: quantity::bound(subject, aspect, state, balls),
    })
}

/// Checks a machine at some positions of its motion.
fn hold(machine: &Machine, held: &mut Held) -> Result<(), String> {
    let mechanism = &machine.mechanism;
    let Ok(solver) = Solver::new(mechanism) else {
        return Ok(());
    };
    let (mut state, mut balls, mut twice) = (solver.state(), solver.enclosure(), solver.twice());
    let step = match mechanism.driver().input {
        Input::Turn(_) => 1.0,
        _ => 0.01,
    };
    let all = all_figures(mechanism);
    let is_coupled = |kind| matches!(kind, GroupKind::Coupled { .. });
    let kind = usize::from(solver.plan().groups.iter().any(|g| is_coupled(g.kind)));
    let mut any = false;
    for part in PLACES {
        let at = mechanism.driver().start + part * step;
        if solver.solve(at, Order::Force, &mut state) != Condition::Ok
            || !solver.solve_twice(&state, Order::Force, &mut twice)
        {
            continue;
        }
        solver.enclose(&mut state, Order::Force, &mut balls);
        any = true;
        let read = |&of: &_| figure(of, (&state, &balls, &twice));
        let figures: Vec<Figure> = all.iter().filter_map(read).collect();
        compare_figures(&figures, kind, held).map_err(|why| format!("at {at:?}: {why}"))?;
    }
    held.machines += u64::from(any);
    Ok(())
}

fn compare_figures(figures: &[Figure], kind: usize, held: &mut Held) -> Result<(), String> {
    for figure in figures {
        let Figure {
            subject,
            aspect,
            value,
            error,
            bound,
        } = *figure;
        let Some(bound) = bound else {
            held.unproved += 1;
            continue;
        };
        if !(error <= bound) {
            return Err(format!(
                "{subject:?} {aspect:?} {value:?} is off by {error:e}, bound {bound:e}"
            ));
        }
        held.figures += 1;
        let alike = figures.iter().filter(|other| other.aspect == aspect);
        let largest = alike.fold(0.0_f64, |maximum, other| maximum.max(other.value.abs()));
        if error > LUCK * largest {
            held.over[kind][usize::from(figure.is_force())].push(bound / error);
        }
    }
    Ok(())
}

/// Returns the median of the ratios of bounds to errors, and the 99th percentile.
fn median(over: &mut [f64]) -> [f64; 2] {
    over.sort_by(f64::total_cmp);
    [over[over.len() / 2], over[over.len() * 99 / 100]]
}

/// No bound is below its error, and the median ratio is small. The ratios are printed if
/// `KRANK_MACHINES` is set.
#[test]
#[allow(clippy::print_stdout, reason = "the figures are to be read")]
fn bounds_hold_in_every_topology() {
    let requested = crate::number("KRANK_MACHINES");
    let wanted = requested.unwrap_or(crate::ORDINARY);
    let first = crate::number("KRANK_MACHINES_SEED").unwrap_or(1);
    let mut held = Held::default();
    for seed in first.. {
        if held.machines >= wanted {
            break;
        }
        let Some(machine) = machine(&mut TestRng::new(seed), crate::MAX_GROUPS, short) else {
            continue;
        };
        if let Err(why) = hold(&machine, &mut held) {
            panic!("KRANK_MACHINES_SEED={seed}: {why}\n{:?}", machine.groups);
        }
    }
    assert!(
        held.unproved < held.figures / 20,
        "{} of {} unproved",
        held.unproved,
        held.figures
    );
    let [dyads, coupled] = held
        .over
        .each_mut()
        .map(|o| o.each_mut().map(|o| median(o)));
    if requested.is_some() {
        println!(
            "{} machines, {} figures, {} unproved; bound by error, median and 99 %, of motion and of \
             forces: {dyads:.1?} where all groups are dyads, {coupled:.1?} elsewhere",
            held.machines, held.figures, held.unproved
        );
    }
    for (kind, near) in [dyads, coupled].into_iter().zip(NEAR) {
        assert!(wanted < crate::ORDINARY || kind[1][0] <= near, "{kind:?}");
    }
}
