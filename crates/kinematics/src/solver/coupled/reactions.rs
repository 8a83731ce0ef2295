//! Computes the forces in a coupled group from its transposed matrix.
//!
//! With Q the forces and couples on the unknowns, J^T lambda = Q. Each equation exerts -lambda
//! times its gradient on the parts that it connects.

use super::{Base, Bearing, Coupled, GroupEquation, Room, Scratch, Spot, Turning};
use crate::solver::forces::{ForceState, Slots};
use crate::solver::lu;
use crate::solver::state::State;
use crate::{Number, Vec2};

/// Inputs and outputs of a group's force analysis.
struct Ledger<'a, T> {
    q: T,
    slots: &'a Slots,
    state: &'a State<T>,
    forces: &'a mut ForceState<T>,
}

impl Coupled {
    /// Passes the forces and couples on the group to the known points and links that it is built
    /// on. Returns `false` if the group's matrix is singular.
    pub(in crate::solver) fn run_back<T: Number>(
        &self,
        q: T,
        slots: &Slots,
        state: &State<T>,
        scratch: &mut Scratch<T>,
        forces: &mut ForceState<T>,
    ) -> bool {
        let mut room = self.open(scratch);
        self.read(state, room.z);
        self.jacobian(q, state, &mut room);
        let n = self.unknowns();
        let solved = lu::factor(room.matrix, room.pivots, n).is_some();
        if solved {
            let mut ledger = Ledger {
                q,
                slots,
                state,
                forces,
            };
            self.gather(&mut room, &mut ledger);
            lu::solve_transposed(room.matrix, room.pivots, room.right, n);
            self.press(&room, &mut ledger);
        }
        solved
    }

    /// Sums the loads on each unknown into the right side: a force on a free joint, a couple on a
    /// direction.
    fn gather<T: Number>(&self, room: &mut Room<'_, T>, ledger: &mut Ledger<'_, T>) {
        room.right.fill(T::default());
        for (point, spot) in &self.spots {
            let force = ledger.forces.points[point.index()];
            let couple = self.carry(spot, force, room, ledger);
            if let Base::Free(i) = spot.base {
                room.right[2 * i] += force.x;
                room.right[2 * i + 1] += force.y;
            }
            if let Some((Turning::Unknown(i), couple)) = couple {
                room.right[2 * self.free + i] += couple;
            }
        }
        for (i, link) in self.turning.iter().enumerate() {
            room.right[2 * self.free + i] += ledger.forces.links[link.index()];
        }
    }

    /// Applies a force at a spot: adds it to a known base and to the joint forces of the spot's
    /// link. Returns the couple on the spot's arm, with the link or class that it turns; `None`
    /// without an arm.
    fn carry<T: Number>(
        &self,
        spot: &Spot,
        force: Vec2<T>,
        room: &Room<'_, T>,
        ledger: &mut Ledger<'_, T>,
    ) -> Option<(Turning, T)> {
        let forces = &mut *ledger.forces;
        if let Base::Known(point) = spot.base {
            forces.points[point.index()] += force;
        }
        if let Some(seat) = spot.seat {
            if let Some(end) = seat.end {
                forces.note(ledger.slots.of(seat.link, end), force);
            }
            forces.note(ledger.slots.of(seat.link, seat.foot), -force);
        }
        let (turning, arm) = spot.arm?;
        let link = self.turning_state(turning, ledger.state, room);
        let r = spot.reach(arm, ledger.q).turned(link.d);
        let couple = r.cross(force);
        self.twist(turning, spot, couple, forces);
        Some((turning, couple))
    }

    /// Applies a couple to the link that turns a spot's arm.
    fn twist<T: Number>(
        &self,
        turning: Turning,
        spot: &Spot,
        couple: T,
        forces: &mut ForceState<T>,
    ) {
        match (turning, spot.seat) {
            (Turning::Known(link), _) => forces.links[link.index()] += couple,
            (Turning::Unknown(i), Some(seat)) if seat.link != self.turning[i] => {
                forces.couples[seat.link.index()] += couple;
            }
            (Turning::Unknown(_), _) => {}
        }
    }

    /// Applies a couple to a link itself.
    fn wrench<T: Number>(&self, bearing: &Bearing, couple: T, forces: &mut ForceState<T>) {
        match bearing.turning {
            Turning::Known(link) => forces.links[link.index()] += couple,
            Turning::Unknown(i) if bearing.link != self.turning[i] => {
                forces.couples[bearing.link.index()] += couple;
            }
            Turning::Unknown(_) => {}
        }
    }

    /// Applies the force or couple of every equation to the parts that it connects, and records the
    /// forces in joints, guides and drives.
    fn press<T: Number>(&self, room: &Room<'_, T>, ledger: &mut Ledger<'_, T>) {
        let mut rows = room.right.iter().map(|&lambda| -lambda);
        for equation in &self.equations {
            let place = |spot: &Spot, ledger: &Ledger<'_, T>| {
                self.moving(spot, ledger.q, ledger.state, room).p
            };
            let mut next = || rows.next().unwrap_or_default();
            match equation {
                GroupEquation::Distance { a, b, bar, .. } => {
                    let e = place(a, ledger) - place(b, ledger);
                    let force = e * next();
                    self.carry(a, force, room, ledger);
                    self.carry(b, -force, room, ledger);
                    let [from, to] = bar.1.map(|end| ledger.slots.of(bar.0, end));
                    ledger.forces.note(from, -force);
                    ledger.forces.note(to, force);
                }
                GroupEquation::Meeting { a, b, pushed } => {
                    let force = Vec2::new(next(), next());
                    self.carry(a, force, room, ledger);
                    self.carry(b, -force, room, ledger);
                    if let (Some(slide), Some((turning, _))) = (pushed, b.arm) {
                        let link = self.turning_state(turning, ledger.state, room);
                        let tau = Vec2::of(b.along).turned(link.d);
                        ledger.forces.normals[slide.index()] = tau.cross(force);
                        let along = T::default() - tau.dot(force);
                        ledger
                            .forces
                            .drive_by(b.following.as_ref(), along, ledger.state);
                    }
                }
                GroupEquation::Elbow {
                    link,
                    from,
                    following,
                } => {
                    let couple = next();
                    self.wrench(link, couple, ledger.forces);
                    self.wrench(from, -couple, ledger.forces);
                    let effort = T::default() - couple;
                    ledger
                        .forces
                        .drive_by(following.as_ref(), effort, ledger.state);
                }
                GroupEquation::Slot {
                    x,
                    q: on,
                    along,
                    turning,
                    slide,
                } => {
                    let link = self.turning_state(*turning, ledger.state, room);
                    let t = Vec2::of(*along).turned(link.d);
                    let gap = place(x, ledger) - place(on, ledger);
                    let across = next();
                    let force = t.perp() * across;
                    self.carry(x, force, room, ledger);
                    self.carry(on, -force, room, ledger);
                    self.twist(*turning, on, -(t.dot(gap) * across), ledger.forces);
                    ledger.forces.normals[slide.index()] = across;
                }
            }
        }
    }
}
