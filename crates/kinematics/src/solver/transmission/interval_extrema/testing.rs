//! Compares two methods of finding extreme transmission angles.

use super::*;

/// Compares the extreme transmission angles from shared Chebyshev sums with those from separate
/// states, and returns the number of comparisons.
///
/// # Panics
/// If an angle differs by more than rounding errors, or a position by more than its conditioning
/// allows.
pub fn compare_extremes(solver: &Solver) -> u32 {
    let (mut compared, basis) = (0, Basis::new());
    let mut workspace = solver.state();
    let mut seen = solver.observe_joints(&mut workspace);
    for joint in 0..seen.len() {
        for bracket in std::mem::take(&mut seen[joint].brackets) {
            let sought = [BracketedJoint { joint, bracket }];
            let sums = solver.sums(&basis, &sought, &seen, &mut workspace).pop();
            let Some(sums) = sums.flatten() else { continue };
            let text = solver
                .extreme(&bracket, |at| Some(sums.lines_at(at)))
                .expect("the bracket has one");
            let exact = |at: f64| {
                let condition = solver.solve(at, Order::Velocity, &mut workspace);
                seen[joint].joint.lines_at(condition, &workspace)
            };
            let found = solver
                .extreme(&bracket, exact)
                .expect("the bracket has one");
            let off = (text.sine * found.cosine - text.cosine * found.sine).abs();
            assert!(off < 1e-13, "{off:e}");
            let off = (text.at - found.at).abs();
            assert!(off < 1e-8, "{off:e} at {}", found.at);
            compared += 1;
        }
    }
    compared
}
