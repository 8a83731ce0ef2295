//! Solves a group's equations by textbook methods, for comparison: Newton's method with a
//! tolerance, one correction from a more precise residual, and bisection.

use super::{Base, Coupled, GroupEquation, Room, Scratch, Spot, Turning};
use crate::solver::lu;
use crate::solver::state::State;
use crate::{Double, Number, Vec2};

/// Maximum number of Newton steps: quadratic convergence takes four or five.
const MAX_STEPS: u32 = 50;
/// Maximum number of bisections of half a turn. After these, no double lies between the ends.
const MAX_HALVINGS: u32 = 60;

/// The single unknown angle of a group, with the condition that closes the group.
#[derive(Clone, Debug)]
pub(in crate::solver) struct Closing(ClosingWay);

#[derive(Clone, Debug)]
#[expect(
    clippy::large_enum_variant,
    reason = "a group has one, and a copy of it is made once"
)]
enum ClosingWay {
    /// The unknown is an angle: a link turns until the only equation holds.
    Turn,
    /// A free joint moves on a circle about a known point until the other equation holds.
    Circle {
        /// The centre of the circle.
        centre: Spot,
        /// The radius of the circle.
        length: f64,
        /// The row of the other equation.
        row: usize,
    },
}

impl Coupled {
    /// Sets the z in the scratch to `base` changed by `change`.
    pub(in crate::solver) fn put(&self, base: &[f64], change: &[f64], scratch: &mut Scratch) {
        let room = self.open(scratch);
        room.z.copy_from_slice(base);
        self.shift(room.z, change);
    }

    /// Takes full Newton steps from the z in the scratch until one is at most the tolerance, and
    /// returns their number. Returns `None` without convergence or at a singular matrix.
    pub(in crate::solver) fn newton<T: Number>(
        &self,
        q: T,
        tolerance: f64,
        state: &State<T>,
        scratch: &mut Scratch<T>,
    ) -> Option<u32> {
        let mut room = self.open(scratch);
        for steps in 1..=MAX_STEPS {
            self.residuals(q, state, &mut room);
            if self.step(q, state, &mut room)? <= tolerance {
                return Some(steps);
            }
        }
        None
    }

    /// Takes one Newton step from the residuals in `room`, and returns its largest component.
    /// Returns `None` if the matrix is singular.
    fn step<T: Number>(&self, q: T, state: &State<T>, room: &mut Room<'_, T>) -> Option<f64> {
        let n = self.unknowns();
        self.jacobian(q, state, room);
        lu::factor(room.matrix, room.pivots, n)?;
        lu::solve(room.matrix, room.pivots, room.right, n);
        for v in room.right.iter_mut() {
            *v = -*v;
        }
        self.shift(room.z, room.right);
        let size = lu::largest(room.right);
        size.is_finite().then_some(size)
    }

    /// Corrects the z in the scratch once, from residuals in double-double. `exact` holds the
    /// inputs for these, and `exact_scratch` is a buffer; all else is in doubles. Returns `false`
    /// if the matrix is singular.
    pub(in crate::solver) fn polish(
        &self,
        q: f64,
        state: &State,
        scratch: &mut Scratch,
        exact: &State<Double>,
        exact_scratch: &mut Scratch<Double>,
    ) -> bool {
        let mut room = self.open(scratch);
        let mut fine = self.open(exact_scratch);
        for (fine, z) in fine.z.iter_mut().zip(room.z.iter()) {
            *fine = Double::exactly(*z);
        }
        self.residuals(Double::exactly(q), exact, &mut fine);
        for (right, fine) in room.right.iter_mut().zip(fine.right.iter()) {
            *right = fine.nearest();
        }
        self.step(q, state, &mut room).is_some()
    }

    /// Returns the sign of the determinant at the z in the scratch, or 0 if the matrix is singular.
    pub(in crate::solver) fn side_at(&self, q: f64, state: &State, scratch: &mut Scratch) -> f64 {
        let mut room = self.open(scratch);
        self.jacobian(q, state, &mut room);
        lu::factor(room.matrix, room.pivots, self.unknowns()).unwrap_or(0.0)
    }

    // ---- one unknown angle

    /// Returns the closing condition of a group with one unknown angle, or `None` for other groups.
    pub(in crate::solver) fn closing(&self) -> Option<Closing> {
        match (self.free, self.turning.len(), &self.equations[..]) {
            (0, 1, [GroupEquation::Distance { .. } | GroupEquation::Slot { .. }]) => {
                Some(Closing(ClosingWay::Turn))
            }
            (1, 0, [one, two]) => {
                let first = circle(one, 1).filter(|_| two.count() == 1);
                first.or_else(|| circle(two, 0).filter(|_| one.count() == 1))
            }
            _ => None,
        }
    }

    /// Bisects the half turn on which the condition changes its sign once, and sets z to the angle
    /// found. `side`, the sign of the determinant, selects the half turn. Returns the number of
    /// bisections, or `None` without a change of sign.
    ///
    /// The condition always has the form a + b cos(angle - c). Its extrema follow from three
    /// values, and exactly one solution lies on either side between them.
    pub(in crate::solver) fn bisect(
        &self,
        Closing(way): &Closing,
        side: f64,
        q: f64,
        state: &State,
        scratch: &mut Scratch,
    ) -> Option<u32> {
        let mut room = self.open(scratch);
        let mut value = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            self.condition(way, Vec2::new(cos, sin), q, state, &mut room)
        };
        let quarter = std::f64::consts::FRAC_PI_2;
        let [east, north, west] = [0.0, quarter, 2.0 * quarter].map(&mut value);
        let middle = 0.5 * (east + west);
        let highest = (north - middle).atan2(east - middle);
        // From the maximum down, clockwise if the condition increases with the angle at the
        // solution.
        let sense = match way {
            ClosingWay::Circle { row: 0, .. } => side,
            ClosingWay::Turn | ClosingWay::Circle { .. } => -side,
        };
        let (mut above, mut below) = (highest, highest + sense * 2.0 * quarter);
        if !(value(above) >= 0.0 && value(below) <= 0.0) {
            return None;
        }
        let mut halvings = 0;
        while halvings < MAX_HALVINGS {
            let middle = 0.5 * (above + below);
            if middle == above || middle == below {
                break;
            }
            halvings += 1;
            if value(middle) > 0.0 {
                above = middle;
            } else {
                below = middle;
            }
        }
        value(below);
        Some(halvings)
    }

    /// Moves the group to an angle, and returns the residual of the condition there.
    fn condition(
        &self,
        way: &ClosingWay,
        direction: Vec2,
        q: f64,
        state: &State,
        room: &mut Room<'_>,
    ) -> f64 {
        let (at, row) = match way {
            ClosingWay::Turn => (direction, 0),
            ClosingWay::Circle {
                centre,
                length,
                row,
            } => {
                let centre = self.moving(centre, q, state, room).p;
                (centre + direction * *length, *row)
            }
        };
        (room.z[0], room.z[1]) = (at.x, at.y);
        self.residuals(q, state, room);
        room.right[row]
    }
}

/// Returns the circle on which an equation keeps a free joint, if any. `row` is the row of the
/// other equation.
fn circle(equation: &GroupEquation, row: usize) -> Option<Closing> {
    let GroupEquation::Distance { a, b, length, .. } = equation else {
        return None;
    };
    let is_free = |spot: &Spot| matches!(spot.base, Base::Free(_)) && spot.arm.is_none();
    let is_known = |spot: &Spot| {
        let is_still = !matches!(spot.arm, Some((Turning::Unknown(_), _)));
        matches!(spot.base, Base::Known(_)) && is_still
    };
    let centre = match (a, b) {
        (free, centre) | (centre, free) if is_free(free) && is_known(centre) => centre.clone(),
        _ => return None,
    };
    let length = length.nearest();
    Some(Closing(ClosingWay::Circle {
        centre,
        length,
        row,
    }))
}
