//! Reports a coupled group at a state: unknowns, equations, residuals and Jacobian of a Newton
//! step.

use super::{Base, Coupled, GroupEquation, Scratch, Spot};
use crate::solver::state::State;
use crate::solver::{Condition, GroupId, Solver};
use crate::{LinkId, PointId, Vec2};

/// An unknown of a coupled group.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NewtonUnknown {
    /// The x coordinate of a joint, in the scene's unit and frame.
    X(PointId),
    /// The y coordinate of a joint, in the scene's unit and frame.
    Y(PointId),
    /// The angle of a link, in rad.
    Angle(LinkId),
}

/// An equation of a coupled group. Joints are given by their points, if they have one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NewtonRow {
    /// The distance of two joints equals a length: half the difference of the squares, in length^2.
    Distance([Option<PointId>; 2], f64),
    /// Two chains of links meet at a joint: the difference in x, in the length unit.
    MeetingX(Option<PointId>),
    /// Two chains of links meet at a joint: the difference in y, in the length unit.
    MeetingY(Option<PointId>),
    /// A joint lies on a guide: its distance from the guide, in the length unit.
    Guide(Option<PointId>),
    /// The angle of a link from another one equals the coordinate of an input: twice the tangent of
    /// half the difference, in rad.
    Elbow([LinkId; 2]),
}

/// The linear system J dz = -f of one more Newton step of a coupled group at a state.
#[derive(Clone, Debug)]
pub struct Newton {
    /// The group.
    pub group: GroupId,
    /// The unknowns, in the order of the columns of `jacobian`.
    pub unknowns: Vec<NewtonUnknown>,
    /// The values of the unknowns: coordinates in the scene's unit and frame, angles in rad from 0
    /// to below 2 pi.
    pub values: Vec<f64>,
    /// The equations, in the order of the rows.
    pub rows: Vec<NewtonRow>,
    /// The residuals of the equations, in the units of [`NewtonRow`].
    pub residuals: Vec<f64>,
    /// The derivatives of the equations by the unknowns, row by row, in the scene's unit and rad.
    pub jacobian: Vec<f64>,
}

impl Solver {
    /// Returns the coupled groups at a state solved by this solver; empty without an assembly.
    #[must_use]
    pub fn newton(&self, state: &State) -> Vec<Newton> {
        if state.condition() == Condition::NoAssembly {
            return Vec::new();
        }
        let (q, _) = self.engine.coordinate(state.at);
        let mut scratch = self.engine.scratch();
        let groups = self.engine.program.coupled.iter();
        groups
            .map(|group| group.last_step(q, state, &mut scratch))
            .collect()
    }
}

impl Coupled {
    fn last_step(&self, q: f64, state: &State, scratch: &mut Scratch) -> Newton {
        let mut buffers = self.open(scratch);
        self.read(state, buffers.z);
        self.residuals(q, state, &mut buffers);
        self.jacobian(q, state, &mut buffers);
        let unit = state.frame.scale;
        let n = self.unknowns();
        let rows = self.rows(unit);
        // A distance equation is in squared lengths. An angle's column has one more factor of
        // length than a joint's.
        let size = |row: &NewtonRow| match row {
            NewtonRow::Distance(..) => unit * unit,
            NewtonRow::MeetingX(_) | NewtonRow::MeetingY(_) | NewtonRow::Guide(_) => unit,
            NewtonRow::Elbow(_) => 1.0,
        };
        let column = |j: usize| if j < 2 * self.free { unit } else { 1.0 };
        let residuals = rows
            .iter()
            .enumerate()
            .map(|(i, row)| buffers.right[i] * size(row));
        let derivatives = rows.iter().enumerate().flat_map(|(i, row)| {
            let matrix = &buffers.matrix;
            (0..n).map(move |j| matrix[i * n + j] * size(row) / column(j))
        });
        let (unknowns, values) = self.named_unknowns(state, buffers.z);
        Newton {
            group: GroupId::new(self.group),
            unknowns,
            values,
            residuals: residuals.collect(),
            jacobian: derivatives.collect(),
            rows,
        }
    }

    fn named_unknowns(&self, state: &State, z: &[f64]) -> (Vec<NewtonUnknown>, Vec<f64>) {
        let mut unknowns = Vec::new();
        let mut values = Vec::new();
        for i in 0..self.free {
            let joint = self.spots.iter().find(|(_, spot)| spot.is_free(i));
            let Some(&(point, _)) = joint else { continue };
            let position = state.frame.place(Vec2::new(z[2 * i], z[2 * i + 1]));
            unknowns.extend([NewtonUnknown::X(point), NewtonUnknown::Y(point)]);
            values.extend([position.x, position.y]);
        }
        for (i, &link) in self.turning.iter().enumerate() {
            let at = 2 * (self.free + i);
            let direction = Vec2::new(z[at], z[at + 1]).turned(self.turns[i].nearest());
            unknowns.push(NewtonUnknown::Angle(link));
            values.push(crate::angle::radians(crate::angle::degrees(direction)));
        }
        (unknowns, values)
    }

    fn rows(&self, unit: f64) -> Vec<NewtonRow> {
        let mut rows = Vec::new();
        for equation in &self.equations {
            match equation {
                GroupEquation::Distance { a, b, length, .. } => {
                    let ends = [a, b].map(|spot| self.point_at(spot));
                    rows.push(NewtonRow::Distance(ends, length.hi * unit));
                }
                GroupEquation::Meeting { a, b, .. } => {
                    let point = self.point_at(a).or_else(|| self.point_at(b));
                    rows.extend([NewtonRow::MeetingX(point), NewtonRow::MeetingY(point)]);
                }
                GroupEquation::Slot { x, .. } => rows.push(NewtonRow::Guide(self.point_at(x))),
                GroupEquation::Elbow { link, from, .. } => {
                    rows.push(NewtonRow::Elbow([link.link, from.link]));
                }
            }
        }
        rows
    }

    /// Returns the point at a spot, if any.
    fn point_at(&self, spot: &Spot) -> Option<PointId> {
        match (spot.base, spot.arm) {
            (Base::Known(point), None) => Some(point),
            (Base::Known(_) | Base::Free(_), _) => {
                let place = |s: &Spot| (s.base, s.arm, s.along);
                let same = |other: &Spot| place(other) == place(spot);
                self.spots
                    .iter()
                    .find(|(_, other)| same(other))
                    .map(|&(point, _)| point)
            }
        }
    }
}

impl Spot {
    /// Returns `true` if the spot is the free joint with this number itself.
    fn is_free(&self, number: usize) -> bool {
        self.arm.is_none() && matches!(self.base, Base::Free(i) if i == number)
    }
}
