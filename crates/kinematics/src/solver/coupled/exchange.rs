//! Writes a coupled group's unknowns into states and reads them back.

use super::{Base, Coupled, GroupEquation, GroupScratch, Spot, SpotMotion, Turning};
use crate::solver::state::{LinkState, PointState, State};
use crate::{Number, PointId, Vec2};

impl Coupled {
    /// Writes the points and links placed by the group into the state.
    pub(in crate::solver) fn write<T: Number>(
        &self,
        q: T,
        state: &mut State<T>,
        buffers: &GroupScratch<'_, T>,
    ) {
        for (i, (&link, &turn)) in self.turning.iter().zip(&self.turns).enumerate() {
            let at = 2 * (self.free + i);
            let d = Vec2::new(buffers.z[at], buffers.z[at + 1]);
            let (w, a) = (
                buffers.first[2 * self.free + i],
                buffers.second[2 * self.free + i],
            );
            state.links[link.index()] = LinkState {
                d: d.turned(Vec2::of(turn)),
                w,
                a,
            };
        }
        for (point, spot) in &self.spots {
            let SpotMotion { p, v, a } = self.moving(spot, q, state, buffers);
            state.points[point.index()] = PointState { p, v, a };
        }
    }

    /// Returns the joints whose rough positions decide to which solution Newton's method converges.
    /// Equations that are linear in a joint place it from anywhere; its start only changes the lengths of
    /// the first steps.
    pub(in crate::solver) fn guessed_joints(&self) -> impl Iterator<Item = PointId> {
        let is_nonlinear = |i: usize| {
            let has = |spot: &Spot| matches!(spot.base, Base::Free(other) if other == i);
            self.equations.iter().any(|equation| match equation {
                GroupEquation::Distance { a, b, .. } => has(a) || has(b),
                GroupEquation::Slot {
                    x,
                    q,
                    turning: Turning::Unknown(_),
                    ..
                } => has(x) || has(q),
                GroupEquation::Slot { .. }
                | GroupEquation::Meeting { .. }
                | GroupEquation::Elbow { .. } => false,
            })
        };
        self.spots.iter().filter_map(move |(point, spot)| {
            let Base::Free(i) = spot.base else {
                return None;
            };
            (spot.arm.is_none() && is_nonlinear(i)).then_some(*point)
        })
    }

    /// Sets z to a rough guess, from the positions of the free joints and the directions of the
    /// classes.
    pub(in crate::solver) fn set_guess(
        &self,
        z: &mut [f64],
        joints: impl Fn(PointId) -> Vec2,
        directions: &[Vec2],
    ) {
        for (point, spot) in &self.spots {
            if let Spot {
                base: Base::Free(i),
                arm: None,
                ..
            } = *spot
            {
                let at = joints(*point);
                (z[2 * i], z[2 * i + 1]) = (at.x, at.y);
            }
        }
        for (i, d) in directions.iter().enumerate() {
            let at = 2 * (self.free + i);
            (z[at], z[at + 1]) = (d.x, d.y);
        }
    }

    /// Reads z from the group's points and links in the state: the inverse of `write`.
    pub(in crate::solver) fn read<T: Number>(&self, state: &State<T>, z: &mut [T]) {
        self.read_as(state, z, |number| number);
    }

    /// Reads z from the state, and converts every number by `exactly`, such as to more digits.
    pub(super) fn read_as<S: Number, T>(
        &self,
        state: &State<S>,
        z: &mut [T],
        exactly: impl Fn(S) -> T,
    ) {
        for (point, spot) in &self.spots {
            if let (Base::Free(i), None) = (spot.base, spot.arm) {
                let Vec2 { x, y } = state.points[point.index()].p;
                (z[2 * i], z[2 * i + 1]) = (exactly(x), exactly(y));
            }
        }
        for (i, (link, turn)) in self.turning.iter().zip(&self.turns).enumerate() {
            let at = 2 * (self.free + i);
            let d = state.links[link.index()].d;
            let Vec2 { x, y } = d.turned(Vec2::of(turn.conj()));
            (z[at], z[at + 1]) = (exactly(x), exactly(y));
        }
    }

    /// Reads z' and z'' from the group's points and links in the state, as far as these are solved.
    pub(in crate::solver) fn read_rates<T: Number>(
        &self,
        state: &State,
        first: &mut [T],
        second: &mut [T],
    ) {
        let mut put = |i: usize, v: f64, a: f64| {
            (first[i], second[i]) = (T::exactly(v), T::exactly(a));
        };
        for (point, spot) in &self.spots {
            if let (Base::Free(i), None) = (spot.base, spot.arm) {
                let PointState { v, a, .. } = state.points[point.index()];
                put(2 * i, v.x, a.x);
                put(2 * i + 1, v.y, a.y);
            }
        }
        for (i, link) in self.turning.iter().enumerate() {
            let link = &state.links[link.index()];
            put(2 * self.free + i, link.w, link.a);
        }
    }
}
