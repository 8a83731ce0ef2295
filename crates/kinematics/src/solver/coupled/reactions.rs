//! Computes the forces in a coupled group from its transposed matrix.
//!
//! With Q the forces and couples on the unknowns, J^T lambda = Q. Each equation exerts -lambda
//! times its gradient on the parts that it connects.

use super::{Base, Bearing, Coupled, GroupEquation, GroupScratch, Scratch, Spot, Turning};
use crate::solver::forces::{ForceState, Slots};
use crate::solver::lu;
use crate::solver::state::State;
use crate::{Number, Vec2};

/// Inputs and outputs of a group's force analysis.
struct ForceExchange<'a, T> {
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
        let mut buffers = self.open(scratch);
        self.read(state, buffers.z);
        self.jacobian(q, state, &mut buffers);
        let n = self.unknowns();
        let solved = lu::factor(buffers.matrix, buffers.pivots, n).is_some();
        if solved {
            let mut exchange = ForceExchange {
                q,
                slots,
                state,
                forces,
            };
            self.sum_loads(&mut buffers, &mut exchange);
            lu::solve_transposed(buffers.matrix, buffers.pivots, buffers.right, n);
            self.press(&buffers, &mut exchange);
        }
        solved
    }

    /// Sums the loads on each unknown into the right side: a force on a free joint, a couple on a
    /// direction.
    fn sum_loads<T: Number>(
        &self,
        buffers: &mut GroupScratch<'_, T>,
        exchange: &mut ForceExchange<'_, T>,
    ) {
        buffers.right.fill(T::default());
        for (point, spot) in &self.spots {
            let force = exchange.forces.points[point.index()];
            let couple = self.carry(spot, force, buffers, exchange);
            if let Base::Free(i) = spot.base {
                buffers.right[2 * i] += force.x;
                buffers.right[2 * i + 1] += force.y;
            }
            if let Some((Turning::Unknown(i), couple)) = couple {
                buffers.right[2 * self.free + i] += couple;
            }
        }
        for (i, link) in self.turning.iter().enumerate() {
            buffers.right[2 * self.free + i] += exchange.forces.links[link.index()];
        }
    }

    /// Applies a force at a spot: adds it to a known base and to the joint forces of the spot's
    /// link. Returns the couple on the spot's arm, with the link or class that it turns; `None`
    /// without an arm.
    fn carry<T: Number>(
        &self,
        spot: &Spot,
        force: Vec2<T>,
        buffers: &GroupScratch<'_, T>,
        exchange: &mut ForceExchange<'_, T>,
    ) -> Option<(Turning, T)> {
        let forces = &mut *exchange.forces;
        if let Base::Known(point) = spot.base {
            forces.points[point.index()] += force;
        }
        if let Some(seat) = spot.seat {
            if let Some(end) = seat.end {
                forces.note(exchange.slots.of(seat.link, end), force);
            }
            forces.note(exchange.slots.of(seat.link, seat.foot), -force);
        }
        let (turning, arm) = spot.arm?;
        let link = self.turning_state(turning, exchange.state, buffers);
        let r = spot.reach(arm, exchange.q).turned(link.d);
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
    fn press<T: Number>(&self, buffers: &GroupScratch<'_, T>, exchange: &mut ForceExchange<'_, T>) {
        let mut rows = buffers.right.iter().map(|&lambda| -lambda);
        for equation in &self.equations {
            let place = |spot: &Spot, exchange: &ForceExchange<'_, T>| {
                self.moving(spot, exchange.q, exchange.state, buffers).p
            };
            let mut next = || rows.next().unwrap_or_default();
            match equation {
                GroupEquation::Distance { a, b, bar, .. } => {
                    let e = place(a, exchange) - place(b, exchange);
                    let force = e * next();
                    self.carry(a, force, buffers, exchange);
                    self.carry(b, -force, buffers, exchange);
                    let [from, to] = bar.1.map(|end| exchange.slots.of(bar.0, end));
                    exchange.forces.note(from, -force);
                    exchange.forces.note(to, force);
                }
                GroupEquation::Meeting { a, b, pushed } => {
                    let force = Vec2::new(next(), next());
                    self.carry(a, force, buffers, exchange);
                    self.carry(b, -force, buffers, exchange);
                    if let (Some(slide), Some((turning, _))) = (pushed, b.arm) {
                        let link = self.turning_state(turning, exchange.state, buffers);
                        let tau = Vec2::of(b.along).turned(link.d);
                        exchange.forces.normals[slide.index()] = tau.cross(force);
                        let along = T::default() - tau.dot(force);
                        exchange
                            .forces
                            .drive_by(b.following.as_ref(), along, exchange.state);
                    }
                }
                GroupEquation::Elbow {
                    link,
                    from,
                    following,
                } => {
                    let couple = next();
                    self.wrench(link, couple, exchange.forces);
                    self.wrench(from, -couple, exchange.forces);
                    let effort = T::default() - couple;
                    exchange
                        .forces
                        .drive_by(following.as_ref(), effort, exchange.state);
                }
                GroupEquation::Slot {
                    x,
                    q: on,
                    along,
                    turning,
                    slide,
                } => {
                    let link = self.turning_state(*turning, exchange.state, buffers);
                    let t = Vec2::of(*along).turned(link.d);
                    let gap = place(x, exchange) - place(on, exchange);
                    let across = next();
                    let force = t.perp() * across;
                    self.carry(x, force, buffers, exchange);
                    self.carry(on, -force, buffers, exchange);
                    self.twist(*turning, on, -(t.dot(gap) * across), exchange.forces);
                    exchange.forces.normals[slide.index()] = across;
                }
            }
        }
    }
}
