//! Checks of bounds against the solver in double-double.

use super::*;
use crate::Double;

/// Compares bounds computed with and without the machine's vector instructions, and returns how
/// many states were compared.
///
/// # Panics
/// If any bits differ.
pub fn compare_bounds_without_vectors(solver: &Solver) -> u32 {
    // Written out, a number is itself alone: -0 is not 0.
    let bits = |workspace: &Workspace<Ball>| {
        let Errors { points, links, .. } = &workspace.errors;
        format!("{:?} {points:?} {links:?}", workspace.state)
    };
    let mut compared = 0;
    let (mut workspace, mut balls) = (solver.state(), solver.enclosure());
    let mut plain = solver.enclosure();
    // Long chains have only one code path.
    if balls.errors.influences.is_long() {
        return 0;
    }
    let orders = [Order::Position, Order::Velocity, Order::Acceleration];
    for (k, order) in (0..48).flat_map(|k| orders.map(|order| (k, order))) {
        let at = solver.mechanism().driver().start + 7.3 * f64::from(k);
        if solver.solve(at, order, &mut workspace) != Condition::Ok {
            continue;
        }
        let engine = &solver.engine;
        let _ = engine.enclose_to(Vicinity::Clear, order, &workspace.state, &mut balls);
        plain.state.condition = workspace.state.condition;
        plainly(&mut Enclosing {
            engine,
            how: (Vicinity::Clear, order),
            state: &workspace.state,
            workspace: &mut plain,
        });
        assert_eq!(bits(&balls), bits(&plain), "at {at}");
        compared += 1;
    }
    compared
}

/// Moves a solved state away from the truth, and checks that its bounds contain the truth and are
/// not wide. Bounds come from the residuals of any state, not only of a solved one.
///
/// # Panics
/// If a bound is too small or too wide.
pub fn check_bounds_of_a_disturbed_state(solver: &Solver) {
    const OFF: f64 = 1e-8;
    let (mut state, mut balls) = (solver.state(), solver.enclosure());
    let mut truth = solver.twice();
    let at = solver.mechanism().driver().start;
    let _ = solver.solve(at, Order::Position, &mut state);
    assert!(solver.solve_twice(&state, Order::Position, &mut truth));
    let off = |k: usize| OFF * (1.0 + k as f64).sin();
    let program = &solver.engine.program;
    let mut spoil = |part| match part {
        PlacedPart::Point(point) => {
            let k = point.index();
            state.state.points[k].p += Vec2::new(off(2 * k), off(2 * k + 1));
        }
        PlacedPart::Link(link) => {
            let turn = crate::angle::unit(off(3 * link.index()).to_degrees());
            let link = &mut state.state.links[link.index()];
            link.d = link.d.turned(turn);
        }
        PlacedPart::Slide(_) => {}
    };
    for step in &program.steps {
        step.outputs(&program.coupled, &mut spoil);
    }
    for group in &solver.engine.program.coupled {
        // Its joints; its directions must stay unit vectors.
        for k in 0..group.width() - 2 * group.turning().len() {
            state.scratch.numbers[group.offset + k] += off(k);
        }
    }
    solver.enclose(&mut state, Order::Position, &mut balls);
    let check = |ball: Ball, truth: Double, of: &str| {
        let miss = (truth - Double::exactly(ball.mid)).abs().hi;
        assert!(miss <= ball.radius, "{of}: {miss:e} {ball:?}");
        // Of second order in the disturbance, except for a chain of many dyads, each of which
        // widens its input.
        let is_long = solver.plan.groups.len() > 8;
        assert!(is_long || ball.radius < 0.1 * OFF, "{of}: {ball:?}");
    };
    for point in solver.mechanism().point_ids() {
        let (ball, truth) = (&balls.points[point.index()], &truth.points[point.index()]);
        check(ball.p.x, truth.p.x, "x");
        check(ball.p.y, truth.p.y, "y");
    }
    for link in solver.mechanism().link_ids() {
        let (ball, truth) = (&balls.links[link.index()], &truth.links[link.index()]);
        check(ball.d.x, truth.d.x, "cos");
        check(ball.d.y, truth.d.y, "sin");
    }
}
