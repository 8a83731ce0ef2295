//! Solves a group's equations by textbook methods, for comparison: Newton's method with a
//! tolerance, one correction from a more precise residual, and bisection.

use super::{Base, Coupled, GroupEquation, GroupScratch, Scratch, Spot, Turning};
use crate::solver::lu;
use crate::solver::state::State;
use crate::{Double, Number, Vec2};

/// Maximum number of Newton steps: quadratic convergence takes four or five.
const MAX_STEPS: u32 = 50;
/// Maximum number of bisections of half a turn. After these, no double lies between the ends.
const MAX_HALVINGS: u32 = 60;

/// The single unknown angle of a group, with the condition that closes the group.
#[derive(Clone, Debug)]
pub(in crate::solver) struct ClosingCondition(ClosingKind);

#[derive(Clone, Debug)]
#[expect(
    clippy::large_enum_variant,
    reason = "a group has one, and a copy of it is made once"
)]
enum ClosingKind {
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
    pub(in crate::solver) fn set_unknowns(
        &self,
        base: &[f64],
        change: &[f64],
        scratch: &mut Scratch,
    ) {
        let buffers = self.open(scratch);
        buffers.z.copy_from_slice(base);
        self.shift(buffers.z, change);
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
        let mut buffers = self.open(scratch);
        for steps in 1..=MAX_STEPS {
            self.residuals(q, state, &mut buffers);
            if self.step(q, state, &mut buffers)? <= tolerance {
                return Some(steps);
            }
        }
        None
    }

    /// Takes one Newton step from the residuals in `buffers`, and returns its largest component.
    /// Returns `None` if the matrix is singular.
    fn step<T: Number>(
        &self,
        q: T,
        state: &State<T>,
        buffers: &mut GroupScratch<'_, T>,
    ) -> Option<f64> {
        let n = self.unknowns();
        self.jacobian(q, state, buffers);
        lu::factor(buffers.matrix, buffers.pivots, n)?;
        lu::solve(buffers.matrix, buffers.pivots, buffers.right, n);
        for v in buffers.right.iter_mut() {
            *v = -*v;
        }
        self.shift(buffers.z, buffers.right);
        let size = lu::largest(buffers.right);
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
        let mut buffers = self.open(scratch);
        let mut fine = self.open(exact_scratch);
        for (fine, z) in fine.z.iter_mut().zip(buffers.z.iter()) {
            *fine = Double::exactly(*z);
        }
        self.residuals(Double::exactly(q), exact, &mut fine);
        for (right, fine) in buffers.right.iter_mut().zip(fine.right.iter()) {
            *right = fine.nearest();
        }
        self.step(q, state, &mut buffers).is_some()
    }

    /// Returns the sign of the determinant at the z in the scratch, or 0 if the matrix is singular.
    pub(in crate::solver) fn side_at(&self, q: f64, state: &State, scratch: &mut Scratch) -> f64 {
        let mut buffers = self.open(scratch);
        self.jacobian(q, state, &mut buffers);
        lu::factor(buffers.matrix, buffers.pivots, self.unknowns()).unwrap_or(0.0)
    }

    // ---- one unknown angle

    /// Returns the closing condition of a group with one unknown angle, or `None` for other groups.
    pub(in crate::solver) fn closing(&self) -> Option<ClosingCondition> {
        match (self.free, self.turning.len(), &self.equations[..]) {
            (0, 1, [GroupEquation::Distance { .. } | GroupEquation::Slot { .. }]) => {
                Some(ClosingCondition(ClosingKind::Turn))
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
        ClosingCondition(way): &ClosingCondition,
        side: f64,
        q: f64,
        state: &State,
        scratch: &mut Scratch,
    ) -> Option<u32> {
        let mut buffers = self.open(scratch);
        let mut value = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            self.condition(way, Vec2::new(cos, sin), q, state, &mut buffers)
        };
        let quarter = std::f64::consts::FRAC_PI_2;
        let [east, north, west] = [0.0, quarter, 2.0 * quarter].map(&mut value);
        let middle = 0.5 * (east + west);
        let highest = (north - middle).atan2(east - middle);
        // From the maximum down, clockwise if the condition increases with the angle at the
        // solution.
        let sense = match way {
            ClosingKind::Circle { row: 0, .. } => side,
            ClosingKind::Turn | ClosingKind::Circle { .. } => -side,
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
        way: &ClosingKind,
        direction: Vec2,
        q: f64,
        state: &State,
        buffers: &mut GroupScratch<'_>,
    ) -> f64 {
        let (at, row) = match way {
            ClosingKind::Turn => (direction, 0),
            ClosingKind::Circle {
                centre,
                length,
                row,
            } => {
                let centre = self.moving(centre, q, state, buffers).p;
                (centre + direction * *length, *row)
            }
        };
        (buffers.z[0], buffers.z[1]) = (at.x, at.y);
        self.residuals(q, state, buffers);
        buffers.right[row]
    }
}

/// Returns the circle on which an equation keeps a free joint, if any. `row` is the row of the
/// other equation.
fn circle(equation: &GroupEquation, row: usize) -> Option<ClosingCondition> {
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
    Some(ClosingCondition(ClosingKind::Circle {
        centre,
        length,
        row,
    }))
}
