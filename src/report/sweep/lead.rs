//! Inputs that follow a point: the inverse of a position.
//!
//! Newton's method on the coordinates of the inputs. Each step poses the linkage in the assembly of
//! the last one, and takes the derivatives from the motion of one input at a time. A long way is
//! divided, so that no input jumps to another solution.

use crate::solver::{Condition, Order, Solver, State};
use crate::{CoordinateAxis, Input, Mechanism, PointId, Vec2};
use nalgebra::{DMatrix, DVector};

/// Maximum number of Newton steps. At the edge of a workspace each step only halves the error.
const MAX_STEPS: usize = 60;
/// Maximum number of pieces of the way between two rows.
const MAX_PIECES: usize = 4000;
/// Maximum distance of two successive positions, relative to the size of the linkage.
const STRIDE: f64 = 0.05;
/// Shortest piece of the way between two rows, as a fraction of it.
const SHORTEST: f64 = 1e-4;
/// Maximum change of an input between two successive positions: an angle in degrees, or a length
/// relative to the size of the linkage.
const MAX_TURN: f64 = 30.0;
const MAX_PUSH: f64 = 0.5;
/// Maximum distance from the requested position, relative to the size of the linkage.
const MISS: f64 = 1e-12;
/// Largest motion of the point in its worst direction at a singular position: for a turn of one
/// radian, or a push by the size of the linkage, relative to that size. It falls with the square root
/// of the distance from the edge of the workspace.
const SINGULAR: f64 = 1e-3;

/// Coordinates of points that lead, and the inputs that follow them.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PointLead {
    /// The leading coordinates.
    pub(super) coordinates: Vec<(PointId, CoordinateAxis)>,
    /// The inputs that follow, by their index; as many as coordinates.
    pub(super) inputs: Vec<usize>,
}

/// A position of the linkage with its inputs.
#[derive(Clone, Debug)]
pub(super) struct LedPose {
    /// The coordinates of all inputs, the driver's first.
    pub(super) inputs: Vec<f64>,
    pub(super) solver: Solver,
    /// Whether the point cannot move in every direction.
    pub(super) is_singular: bool,
}

impl PointLead {
    /// Returns the leading coordinates in a state.
    fn values(&self, state: &State) -> Option<DVector<f64>> {
        let of = |&(point, axis): &(PointId, CoordinateAxis)| {
            let at = state.position(point)?;
            Some(along(at, axis))
        };
        let values: Option<Vec<f64>> = self.coordinates.iter().map(of).collect();
        values.map(DVector::from_vec)
    }

    /// Moves from a position to the one where the coordinates are `targets`, and the inputs that do
    /// not follow are at `inputs`. Returns `None` if it cannot be reached.
    pub(super) fn moved(
        &self,
        mechanism: &Mechanism,
        from: &LedPose,
        inputs: &[f64],
        targets: &[f64],
    ) -> Option<LedPose> {
        let targets = DVector::from_column_slice(targets);
        let state = solved(&from.solver, from.inputs.first().copied()?, Order::Position)?;
        let (start, size) = (self.values(&state)?, size_of(mechanism, &state));
        let away = (&targets - &start).amax();
        let mut piece = (STRIDE * size / away).min(1.0);
        let (mut done, mut pose) = (0.0, from.clone());
        for _ in 0..MAX_PIECES {
            let next = f64::min(done + piece, 1.0);
            let target = &start + (&targets - &start) * next;
            let held = from.inputs.iter().zip(inputs);
            let held: Vec<f64> = held.map(|(from, to)| from + (to - from) * next).collect();
            match self.solved(mechanism, &pose, &held, &target, size) {
                Some(found) if next >= 1.0 => return Some(found),
                Some(found) => {
                    (done, pose) = (next, found);
                    piece *= 2.0;
                    piece = piece.min(STRIDE * size / away);
                }
                None if piece < SHORTEST => return None,
                None => piece /= 4.0,
            }
        }
        None
    }

    /// Solves a position near `from`; `held` has the coordinates of the inputs that do not follow.
    fn solved(
        &self,
        mechanism: &Mechanism,
        from: &LedPose,
        held: &[f64],
        target: &DVector<f64>,
        size: f64,
    ) -> Option<LedPose> {
        let mut inputs = held.to_vec();
        for &index in &self.inputs {
            *inputs.get_mut(index)? = *from.inputs.get(index)?;
        }
        let (mut solver, mut at) = (from.solver.clone(), *from.inputs.first()?);
        let mut best = f64::INFINITY;
        for _ in 0..MAX_STEPS {
            let posed = mechanism.posed(&inputs);
            solver = solver.with_dimensions_in_assembly(at, &posed).ok()?;
            at = *inputs.first()?;
            let state = solved(&solver, at, Order::Position)?;
            let missed = target - self.values(&state)?;
            let miss = missed.amax();
            let slopes = self.slopes(&posed, at, &state)?;
            let parts = slopes.clone().svd(true, true);
            // The rounding errors of the positions end the improvement.
            if miss <= MISS * size && (miss == 0.0 || miss >= 0.5 * best) {
                return Some(LedPose {
                    is_singular: self.is_singular(mechanism, slopes, size),
                    inputs,
                    solver,
                });
            }
            best = best.min(miss);
            let largest = parts.singular_values.max();
            let change = parts.solve(&missed, f64::EPSILON * largest).ok()?;
            for (&index, change) in self.inputs.iter().zip(change.iter()) {
                *inputs.get_mut(index)? += change;
            }
            let is_far = self.inputs.iter().any(|&index| {
                let most = match mechanism.inputs().nth(index) {
                    Some(Input::Push(_)) => MAX_PUSH * size,
                    Some(Input::Turn(_)) | None => MAX_TURN,
                };
                let pair = inputs.get(index).zip(from.inputs.get(index));
                // Negated so that NaN is rejected too.
                !pair.is_some_and(|(to, from)| (to - from).abs() <= most)
            });
            if is_far {
                return None;
            }
        }
        None
    }

    /// Returns `true` if the inputs cannot move the point in every direction.
    fn is_singular(&self, mechanism: &Mechanism, mut slopes: DMatrix<f64>, size: f64) -> bool {
        for (mut column, &index) in slopes.column_iter_mut().zip(&self.inputs) {
            column *= match mechanism.inputs().nth(index) {
                Some(Input::Push(_)) => size,
                Some(Input::Turn(_)) | None => 1.0_f64.to_degrees(),
            };
        }
        slopes.singular_values().min() <= SINGULAR * size
    }

    /// Returns the derivatives of the leading coordinates by the inputs that follow, each in its own
    /// unit.
    fn slopes(&self, posed: &Mechanism, at: f64, state: &State) -> Option<DMatrix<f64>> {
        let points = posed.point_ids();
        let moving = points.filter(|&point| posed.point(point).ground.is_none());
        let start = moving.filter_map(|point| Some((point, state.position(point)?)));
        let start: Vec<(PointId, Vec2)> = start.collect();
        let count = self.inputs.len();
        let mut slopes = DMatrix::zeros(count, count);
        for (column, &index) in self.inputs.iter().enumerate() {
            let input = posed.inputs().nth(index)?;
            let led = posed.led_by(input, at, start.clone())?;
            let solver = Solver::new(&led).ok()?;
            let state = solved(&solver, led.driver().start, Order::Velocity)?;
            // It moves at 1 rad/s or 1 unit/s.
            let per_second = match input {
                Input::Turn(_) => 1.0_f64.to_degrees(),
                Input::Push(_) => 1.0,
            };
            for (row, &(point, axis)) in self.coordinates.iter().enumerate() {
                slopes[(row, column)] = along(state.velocity(point)?, axis) / per_second;
            }
        }
        Some(slopes)
    }
}

fn along(vector: Vec2, axis: CoordinateAxis) -> f64 {
    match axis {
        CoordinateAxis::X => vector.x,
        CoordinateAxis::Y => vector.y,
    }
}

/// Solves a state; returns `None` if it does not exist, or for rates if they do not.
fn solved(solver: &Solver, at: f64, order: Order) -> Option<State> {
    let mut state = solver.state();
    match (solver.solve(at, order, &mut state), order) {
        (Condition::NoAssembly, _) => None,
        (Condition::Ok, _) | (_, Order::Position) => Some(state.into_state()),
        (Condition::DeadPoint | Condition::ChangePoint, _) => None,
    }
}

/// Returns the largest distance of two points of links along an axis.
fn size_of(mechanism: &Mechanism, state: &State) -> f64 {
    let members = mechanism.links().iter().flat_map(|link| &link.members);
    let positions = members.filter_map(|member| state.position(member.point));
    let mut ends: Option<(Vec2, Vec2)> = None;
    for at in positions {
        let (low, high) = ends.unwrap_or((at, at));
        let low = Vec2::new(low.x.min(at.x), low.y.min(at.y));
        ends = Some((low, Vec2::new(high.x.max(at.x), high.y.max(at.y))));
    }
    ends.map_or(0.0, |(low, high)| (high.x - low.x).max(high.y - low.y))
}
