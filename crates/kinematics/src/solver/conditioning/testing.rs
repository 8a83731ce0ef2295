//! Checks the worst condition of coupled groups.

use crate::solver::Solver;

/// Checks that no whole degree has a worse condition than the reported one.
///
/// # Panics
/// If one has.
pub fn check_conditioning(solver: &Solver) {
    let [worst] = solver.conditioning()[..] else {
        panic!("it has one coupled group");
    };
    assert!(0.0 < worst.least && worst.least < 1.0, "{worst:?}");
    let mut workspace = solver.state();
    let group = &solver.engine.program.coupled[0];
    for at in 0..360 {
        let here = solver
            .condition_of(group, f64::from(at), &mut workspace)
            .expect("the motion has no dead point");
        assert!(here >= worst.least - 1e-12, "{at} {here} {worst:?}");
    }
}
