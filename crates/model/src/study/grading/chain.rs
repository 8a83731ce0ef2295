//! The loop equations as a chain: computes values from values found before.
//!
//! Given values are used at face value, even if rounded or wrong. The others are solved from the
//! equations of their group as by hand; overdetermined equations are solved by least squares.

use crate::Vec2;
use crate::quantity::{Aspect, Quantity, Subject};
use crate::solver::Order;
use crate::study::{LoopSum, UnknownKind, UnknownVector, VectorPart};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;

/// The values and rates of the unknowns: angles in rad, lengths in the scene's unit, per s and s^2.
pub type ChainValues = Vec<[f64; 3]>;

/// The dependencies between the values of one state.
#[derive(Clone, Debug)]
pub struct SolutionChain {
    /// The kind of each variable; the first is the driver's coordinate.
    pub kinds: Vec<UnknownKind>,
    /// The exact values of the variables.
    pub exact: ChainValues,
    /// The groups, in the order of solution.
    pub groups: Vec<ChainGroup>,
    /// The angles of the links.
    pub links: Vec<VectorPart>,
    /// The slides: the position along the guide, and the guide's angle.
    pub slides: Vec<[VectorPart; 2]>,
    /// The path to every point from the frame's origin.
    pub points: Vec<Option<LoopSum>>,
}

/// A group: its loops, and its unknowns.
#[derive(Clone, Debug)]
pub struct ChainGroup {
    /// The sums that must be zero.
    pub loops: Vec<LoopSum>,
    /// The indices of the unknowns.
    pub sought: Vec<usize>,
}

/// A variable or one of its rates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChainSlot {
    /// 0 for the value, 1 and 2 for its rates.
    pub order: usize,
    /// The index of the variable.
    pub variable: usize,
}

/// Maximum number of Newton steps; from the exact values a few suffice.
const STEPS: usize = 30;
/// The step below which the iteration ends, in rad or relative to the longest vector.
const STEP_TOLERANCE: f64 = 1e-13;
/// The relative size below which a singular value counts as zero.
const SINGULAR: f64 = 1e-12;

impl SolutionChain {
    /// Returns the slots of all unknowns, in the order of solution.
    #[must_use]
    pub fn slots(&self) -> Vec<ChainSlot> {
        let unknowns = || self.groups.iter().flat_map(|group| &group.sought);
        let of = |order| unknowns().map(move |&variable| ChainSlot { order, variable });
        (0..3).flat_map(of).collect()
    }

    /// Returns the slot that a value determines, and the offset of its angle from the variable, in
    /// rad; `None` if it determines none.
    #[must_use]
    pub fn slot_of(&self, quantity: &Quantity) -> Option<(ChainSlot, f64)> {
        let (subject, aspect) = (quantity.subject()?, quantity.aspect()?);
        let (part, orders) = match subject {
            Subject::Link(link) => (*self.links.get(link.index())?, Aspect::TURNING),
            Subject::Slide(slide) => (self.slides.get(slide.index())?[0], Aspect::STRETCHING),
            _ => return None,
        };
        let order = orders.iter().position(|own| *own == aspect)?;
        match part {
            VectorPart::Sought(variable, more) if variable > 0 => {
                let more = if order == 0 { more } else { 0.0 };
                Some((ChainSlot { order, variable }, more))
            }
            VectorPart::Sought(..) | VectorPart::Known(_) => None,
        }
    }

    /// Returns the exact value of a slot.
    #[must_use]
    pub fn exact_at(&self, slot: ChainSlot) -> Option<f64> {
        self.exact.get(slot.variable)?.get(slot.order).copied()
    }

    /// Computes all variables from given ones: `given` returns the value of a given slot. Returns
    /// `None` if the equations cannot be solved.
    #[must_use]
    pub fn follow(&self, given: &dyn Fn(ChainSlot) -> Option<f64>) -> Option<ChainValues> {
        let all: Vec<usize> = (0..self.kinds.len()).collect();
        self.follow_for(&all, given)
    }

    /// Computes the `wanted` variables and those they depend on; the others keep their exact
    /// values.
    pub(super) fn follow_for(
        &self,
        wanted: &[usize],
        given: &dyn Fn(ChainSlot) -> Option<f64>,
    ) -> Option<ChainValues> {
        let mut values = self.exact.clone();
        let is_wanted = |group: &&ChainGroup| group.sought.iter().any(|own| wanted.contains(own));
        let groups: Vec<&ChainGroup> = self.groups.iter().filter(is_wanted).collect();
        for order in 0..3 {
            for group in &groups {
                let mut open = Vec::new();
                for &variable in &group.sought {
                    match given(ChainSlot { order, variable }) {
                        Some(value) => values.get_mut(variable)?[order] = value,
                        None => open.push(variable),
                    }
                }
                if !self.is_exact(group, order, &values) {
                    self.solve(group, order, &open, &mut values)?;
                }
            }
        }
        Some(values)
    }

    /// Returns `true` if all variables in a group's loops are exact, so that solving is
    /// unnecessary.
    fn is_exact(&self, group: &ChainGroup, order: usize, values: &[[f64; 3]]) -> bool {
        group.loops.iter().flat_map(variables).all(|variable| {
            let up_to =
                |values: &[[f64; 3]]| values.get(variable).map(|own| own[..=order].to_vec());
            up_to(values) == up_to(&self.exact)
        })
    }

    /// Returns the indices of the variables that a quantity depends on.
    #[must_use]
    pub fn variables_of(&self, quantity: &Quantity) -> Vec<usize> {
        let parts = std::cell::RefCell::new(Vec::new());
        // The values are irrelevant: only the parts of the quantity are collected.
        let _ = quantity.made_of(|subject, aspect| {
            parts.borrow_mut().extend(self.parts_of(subject, aspect));
            Some(1.0)
        });
        let mut found = parts.into_inner();
        for group in self.groups.iter().rev() {
            if group.sought.iter().any(|own| found.contains(own)) {
                found.extend(&group.sought);
                found.extend(group.loops.iter().flat_map(variables));
            }
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Returns the variables that determine a part of a quantity.
    fn parts_of(&self, subject: Subject, aspect: Aspect) -> Vec<usize> {
        let unknowns = |part: Option<VectorPart>| match part {
            Some(VectorPart::Sought(variable, _)) => vec![variable],
            _ => Vec::new(),
        };
        let travel = |point: crate::PointId| match self.points.get(point.index()) {
            Some(Some(travel)) => variables(travel),
            _ => Vec::new(),
        };
        match subject {
            Subject::Driver => vec![0],
            Subject::Link(link) => unknowns(self.links.get(link.index()).copied()),
            Subject::Slide(slide) => {
                let part = usize::from(Aspect::TURNING.contains(&aspect));
                unknowns(self.slides.get(slide.index()).map(|parts| parts[part]))
            }
            Subject::Point(point) => travel(point),
            Subject::Between(tail, head) => [travel(tail), travel(head)].concat(),
            _ => Vec::new(),
        }
    }

    /// Returns the exact rates for given positions.
    #[must_use]
    pub fn rates_at(&self, positions: &[f64]) -> Option<ChainValues> {
        self.follow(&|slot| match slot.order {
            0 => positions.get(slot.variable).copied(),
            _ => None,
        })
    }

    /// Computes a quantity from these values; `None` if it is not a motion quantity.
    #[must_use]
    pub fn figure(&self, quantity: &Quantity, values: &[[f64; 3]]) -> Option<f64> {
        quantity.made_of(|subject, aspect| self.value(subject, aspect, values))
    }

    fn solve(
        &self,
        group: &ChainGroup,
        order: usize,
        open: &[usize],
        values: &mut [[f64; 3]],
    ) -> Option<()> {
        if open.is_empty() || group.loops.is_empty() {
            return Some(());
        }
        if order > 0 {
            // Rates are linear: the open ones balance the given ones.
            for &variable in open {
                values.get_mut(variable)?[order] = 0.0;
            }
            let rates = step(group, order, open, values)?;
            for (&variable, rate) in open.iter().zip(&rates) {
                values.get_mut(variable)?[order] = *rate;
            }
            return Some(());
        }
        for _ in 0..STEPS {
            let step = step(group, order, open, values)?;
            let longest = longest(group, values);
            let mut largest = 0.0_f64;
            for (&variable, change) in open.iter().zip(&step) {
                values.get_mut(variable)?[0] += change;
                let scale = match self.kinds.get(variable)? {
                    UnknownKind::Angle => 1.0,
                    UnknownKind::Length => longest,
                };
                largest = largest.max(change.abs() / scale);
            }
            if largest <= STEP_TOLERANCE {
                break;
            }
        }
        Some(())
    }

    pub(super) fn value(
        &self,
        subject: Subject,
        aspect: Aspect,
        values: &[[f64; 3]],
    ) -> Option<f64> {
        let order = match aspect.order() {
            Order::Position => 0,
            Order::Velocity => 1,
            Order::Acceleration => 2,
            Order::Force => return None,
        };
        let turned = |part: VectorPart, by: f64| {
            let value = part_of(part, order, values)?;
            Some(if order == 0 {
                degrees(value + by)
            } else {
                value
            })
        };
        let is_turning = Aspect::TURNING.contains(&aspect);
        match subject {
            Subject::Driver => match self.kinds.first()? {
                UnknownKind::Angle if order == 0 => Some(values.first()?[0].to_degrees()),
                UnknownKind::Angle | UnknownKind::Length => Some(values.first()?[order]),
            },
            Subject::Link(link) => turned(*self.links.get(link.index())?, 0.0),
            Subject::Slide(slide) => {
                let [travel, guide] = *self.slides.get(slide.index())?;
                // The vector runs from the sliding point back to `through`.
                if is_turning {
                    turned(guide, PI)
                } else {
                    part_of(travel, order, values)
                }
            }
            Subject::Point(point) => {
                let way = self.points.get(point.index())?.as_ref()?;
                let motion = motion(way, values)?;
                let vector = motion.get(order)?;
                match aspect {
                    Aspect::X | Aspect::Vx | Aspect::Ax => Some(vector.x),
                    _ => Some(vector.y),
                }
            }
            Subject::Between(tail, head) => {
                let way = |point: crate::PointId| self.points.get(point.index())?.as_ref();
                let (tail, head) = (motion(way(tail)?, values)?, motion(way(head)?, values)?);
                between(std::array::from_fn(|i| head[i] - tail[i]), aspect)
            }
            _ => None,
        }
    }
}

/// Returns the indices of the variables in a sum.
fn variables(of: &LoopSum) -> Vec<usize> {
    let parts = of
        .sought
        .iter()
        .flat_map(|vector| [vector.length, vector.angle]);
    let own = parts.filter_map(|part| match part {
        VectorPart::Sought(variable, _) => Some(variable),
        VectorPart::Known(_) => None,
    });
    own.collect()
}

/// Returns the step that solves for a group's open variables to first order.
fn step(group: &ChainGroup, order: usize, open: &[usize], values: &[[f64; 3]]) -> Option<Vec<f64>> {
    let rows = 2 * group.loops.len();
    let mut matrix = DMatrix::zeros(rows, open.len());
    let mut left = DVector::zeros(rows);
    for (number, of) in group.loops.iter().enumerate() {
        let sum = motion(of, values)?[order];
        (left[2 * number], left[2 * number + 1]) = (-sum.x, -sum.y);
        for vector in &of.sought {
            let (r, u) = heading(vector, values)?;
            for (part, by) in [(vector.length, u), (vector.angle, u.perp() * r)] {
                let VectorPart::Sought(variable, _) = part else {
                    continue;
                };
                if let Some(column) = open.iter().position(|&own| own == variable) {
                    matrix[(2 * number, column)] += by.x * vector.sign;
                    matrix[(2 * number + 1, column)] += by.y * vector.sign;
                }
            }
        }
    }
    let all_finite = |list: &[f64]| list.iter().all(|v| v.is_finite());
    if !all_finite(matrix.as_slice()) || !all_finite(left.as_slice()) {
        return None;
    }
    let parts = matrix.try_svd(true, true, f64::EPSILON, 1000)?;
    let minimum = SINGULAR * parts.singular_values.max();
    let solved = parts.solve(&left, minimum).ok()?;
    let solved: Vec<f64> = solved.iter().copied().collect();
    all_finite(&solved).then_some(solved)
}

fn longest(group: &ChainGroup, values: &[[f64; 3]]) -> f64 {
    let vectors = group.loops.iter().flat_map(|of| &of.sought);
    let lengths = vectors.filter_map(|v| Some(heading(v, values)?.0.abs()));
    lengths.fold(f64::MIN_POSITIVE, f64::max)
}

/// Returns a length or an angle, or one of its rates.
fn part_of(part: VectorPart, order: usize, values: &[[f64; 3]]) -> Option<f64> {
    match part {
        VectorPart::Known(value) if order == 0 => Some(value),
        VectorPart::Known(_) => Some(0.0),
        VectorPart::Sought(variable, more) => {
            let value = *values.get(variable)?.get(order)?;
            Some(if order == 0 { value + more } else { value })
        }
    }
}

/// Returns the length and the direction of a vector.
fn heading(vector: &UnknownVector, values: &[[f64; 3]]) -> Option<(f64, Vec2)> {
    let (sin, cos) = part_of(vector.angle, 0, values)?.sin_cos();
    Some((part_of(vector.length, 0, values)?, Vec2::new(cos, sin)))
}

/// Returns the sum of some vectors, its rate, and the rate of that.
fn motion(of: &LoopSum, values: &[[f64; 3]]) -> Option<[Vec2; 3]> {
    let mut sum = [of.known, Vec2::ZERO, Vec2::ZERO];
    for vector in &of.sought {
        let (r, u) = heading(vector, values)?;
        let [rate, accel] = [1, 2].map(|order| part_of(vector.length, order, values));
        let [omega, alpha] = [1, 2].map(|order| part_of(vector.angle, order, values));
        let (rate, accel, omega, alpha) = (rate?, accel?, omega?, alpha?);
        let n = u.perp();
        let parts = [
            u * r,
            u * rate + n * (r * omega),
            u * (accel - r * omega * omega) + n * (r * alpha + 2.0 * rate * omega),
        ];
        for (sum, part) in sum.iter_mut().zip(parts) {
            *sum += part * vector.sign;
        }
    }
    Some(sum)
}

/// Returns a quantity of the vector between two points; `None` for an aspect of something else.
fn between([r, v, a]: [Vec2; 3], aspect: Aspect) -> Option<f64> {
    let length = r.norm();
    let u = r / length;
    let (rate, omega) = (u.dot(v), u.cross(v) / length);
    Some(match aspect {
        Aspect::Length => length,
        Aspect::Rate => rate,
        Aspect::Accel => u.dot(a) + length * omega * omega,
        Aspect::Angle => crate::angle::degrees(r),
        Aspect::Omega => omega,
        Aspect::Alpha => (u.cross(a) - 2.0 * rate * omega) / length,
        _ => return None,
    })
}

/// Converts radians to degrees in [0, 360).
fn degrees(radians: f64) -> f64 {
    crate::angle::wrapped(radians.to_degrees())
}
