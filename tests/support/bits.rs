//! A state as bits: what must be the same is the same to the last one.

use krank::Mechanism;
use krank::solver::State;

/// Every figure of a state, in the order of the mechanism, as bits.
pub(crate) fn bits(mechanism: &Mechanism, state: &State, length: f64) -> Vec<u64> {
    let mut figures = Vec::new();
    for id in mechanism.point_ids() {
        let vectors = [
            state.position(id),
            state.velocity(id),
            state.acceleration(id),
        ];
        figures.extend(vectors.iter().flat_map(|v| [v.x / length, v.y / length]));
    }
    for id in mechanism.link_ids() {
        let direction = state.direction(id);
        figures.extend([direction.x, direction.y, state.omega(id), state.alpha(id)]);
    }
    figures.iter().map(|v| v.to_bits()).collect()
}
