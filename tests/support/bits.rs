//! Converts states to bits, to compare them exactly.

use krank::Mechanism;
use krank::solver::State;

/// Returns every value of a state as bits, in the order of the mechanism, with lengths divided by
/// `length`. Missing values are `None`.
pub(crate) fn bits(mechanism: &Mechanism, state: &State, length: f64) -> Vec<Option<u64>> {
    let mut figures = Vec::new();
    for id in mechanism.point_ids() {
        let vectors = [
            state.position(id),
            state.velocity(id),
            state.acceleration(id),
        ];
        let vectors = vectors.into_iter();
        figures.extend(vectors.flat_map(|v| [v.map(|v| v.x / length), v.map(|v| v.y / length)]));
    }
    for id in mechanism.link_ids() {
        let direction = state.direction(id);
        figures.extend([direction.map(|d| d.x), direction.map(|d| d.y)]);
        figures.extend([state.omega(id), state.alpha(id)]);
    }
    figures.iter().map(|v| v.map(f64::to_bits)).collect()
}
