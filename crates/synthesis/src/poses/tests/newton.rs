//! Finds dyads of five poses by Newton's method on the lengths of links, which shares no code with
//! the resultant.

use crate::PoseTask;
use kinematics::{Double, Vec2};
use nalgebra::{Matrix4, Vector4};

/// Maximum number of Newton steps, each at most `longest` long.
const MAX_STEPS: usize = 60;

/// Returns a pivot and a pin in the body's frame near a start, such that the squared length of the
/// link is the same at all poses. The residual is computed in double-double, so that the solution
/// of the rounded poses is correct to all digits of a double.
pub(super) fn solution(task: &PoseTask, start: [Vec2; 2], longest: f64) -> Option<[Vec2; 2]> {
    let [mut pivot, mut pin] = start.map(Vec2::exactly::<Double>);
    for _ in 0..MAX_STEPS {
        let links = task.poses.iter().map(|pose| {
            let turn = Double::unit(pose.angle);
            (pose.at.exactly() + pin.turned(turn) - pivot, turn)
        });
        let links: Vec<(Vec2<Double>, Vec2<Double>)> = links.collect();
        let (first, first_turn) = links[0];
        let slope = |link: Vec2<Double>, turn: Vec2<Double>| {
            let by_pin = link.turned(turn.conj()).nearest();
            (link.nearest(), by_pin)
        };
        let (first_slope, first_by_pin) = slope(first, first_turn);
        let mut rows = Matrix4::zeros();
        let mut rest = Vector4::zeros();
        for (k, (link, turn)) in links[1..].iter().enumerate() {
            let (along, by_pin) = slope(*link, *turn);
            let (p, w) = (first_slope - along, by_pin - first_by_pin);
            rows.set_row(k, &Vector4::new(p.x, p.y, w.x, w.y).transpose());
            rest[k] = 0.5 * (link.norm2() - first.norm2()).hi;
        }
        let scale = rows.row_iter().map(|row| row.norm()).collect::<Vec<f64>>();
        for (k, scale) in scale.into_iter().enumerate() {
            rows.row_mut(k).scale_mut(1.0 / scale);
            rest[k] /= scale;
        }
        let step = rows.full_piv_lu().solve(&rest)?;
        let size = step.norm();
        let step = if size > longest {
            step * (longest / size)
        } else {
            step
        };
        pivot = pivot - Vec2::new(step[0], step[1]).exactly();
        pin = pin - Vec2::new(step[2], step[3]).exactly();
        if size < 1e-14 * longest {
            let length = first.norm2().sqrt().hi;
            return (length > 1e-3).then_some([pivot.nearest(), pin.nearest()]);
        }
    }
    None
}
