//! What each step hands down, backwards.
//!
//! Notation as in the steps: X the joint that was placed, P and Q the pivots, e = X - P and f = X - Q,
//! t and n along and across a guide. F is the force that has come to a point, M the couple that has
//! come to a link. "On" a link means: from the pin, or the guide, on it.

use super::Forces;
use super::pass::{Held, Leg, Pass, Reach};
use super::slots::Slot;
use crate::solver::state::{PointState, State};
use crate::solver::step::Line;
use crate::{LinkId, Number, PointId, SlideId, Vec2};

impl<T: Number> Forces<T> {
    #[inline(always)]
    fn at(&self, point: PointId) -> Vec2<T> {
        self.points[point.index()]
    }

    #[inline(always)]
    fn couple(&self, link: LinkId) -> T {
        self.links[link.index()]
    }

    /// A force on a link at the end of an arm; its pivot holds against it.
    #[inline(always)]
    fn hold(&mut self, reach: &Reach, force: Vec2<T>, state: &State<T>) {
        self.points[reach.pivot.index()] += force;
        if !reach.legs.is_empty() {
            self.hold_over(reach, force, state);
            return;
        }
        self.note(reach.slots[0], force);
        self.note(reach.slots[1], -force);
    }

    /// The same where the arm goes over several links: the locks hold each against turning.
    #[cold]
    fn hold_over(&mut self, reach: &Reach, force: Vec2<T>, state: &State<T>) {
        for leg in &reach.legs {
            self.note(leg.slots[0], force);
            self.note(leg.slots[1], -force);
            let [out, near] = leg.joints.map(|joint| state.points[joint.index()].p);
            if leg.link != reach.link {
                self.couples[leg.link.index()] += (out - near).cross(force);
            }
        }
    }

    #[inline(always)]
    pub(in crate::solver) fn note(&mut self, slot: Slot, force: Vec2<T>) {
        self.joints[slot] += force;
    }

    /// A joint presses on a line with `across` along its normal, at s from the point of the line.
    #[inline(always)]
    fn press(&mut self, hold: &Held, line: Option<(&Line, T)>, n: Vec2<T>, across: T) {
        let force = n * across;
        self.note(hold.carrier[0], force);
        self.note(hold.carrier[1], -force);
        if !hold.is_yoke {
            self.note(hold.guide, -force);
        }
        // A guide that moves with the joint presses on the point that it slides over.
        self.normals[hold.slide.index()] = if hold.is_yoke { across } else { -across };
        if let Some((line, s)) = line {
            self.points[line.through.index()] += force;
            self.links[line.link.index()] += s * across;
        }
    }
}

impl Pass {
    #[inline(always)]
    pub(super) fn run<T: Number>(&self, state: &State<T>, forces: &mut Forces<T>) {
        let at = |point: &PointId| state.points[point.index()].p;
        match self {
            Pass::Carry {
                point,
                base,
                link,
                slots,
            } => {
                let force = forces.at(*point);
                let r = at(point) - at(base);
                forces.note(slots[0], force);
                forces.note(slots[1], -force);
                forces.points[base.index()] += force;
                forces.links[link.index()] += r.cross(force);
            }
            Pass::Push {
                point,
                base,
                link,
                slot,
                along,
                slide,
            } => {
                let force = forces.at(*point);
                let r = at(point) - at(base);
                let tau = Vec2::of(*along).turned(state.links[link.index()].d);
                forces.note(*slot, -force);
                forces.points[base.index()] += force;
                forces.links[link.index()] += r.cross(force);
                forces.drive += force.dot(tau);
                forces.normals[slide.index()] = -tau.cross(force);
            }
            Pass::Aim { arm, end } => {
                let e = at(end) - at(&arm.pivot);
                let force = -(e.perp() * (forces.couple(arm.link) / e.norm2()));
                forces.hold(arm, force, state);
                let back = forces.at(*end) - force;
                forces.points[end.index()] = back;
            }
            Pass::Lock { link, to } => {
                let couple = forces.couple(*link);
                forces.couples[link.index()] += couple;
                forces.links[to.index()] += couple;
            }
            Pass::Circles { point, near, far } => {
                circles(*point, near, far, state, forces);
            }
            Pass::Cylinder {
                point,
                barrel,
                along,
                far,
                slide,
            } => {
                let force = circles(*point, barrel, far, state, forces);
                let tau = Vec2::of(*along).turned(state.links[barrel.link.index()].d);
                forces.drive += force.dot(tau);
                if let Some(slide) = slide {
                    forces.normals[slide.index()] = -tau.cross(force);
                }
            }
            Pass::CircleRail {
                point,
                arm,
                along,
                hold,
            } => {
                let t = Vec2::of(*along);
                let across = across(at(point) - at(&arm.pivot), t, *point, arm.link, forces);
                let n = t.perp();
                let force = forces.at(*point) - n * across;
                forces.hold(arm, force, state);
                forces.press(hold, None, n, across);
            }
            Pass::CircleLine {
                point,
                arm,
                line,
                hold,
            } => {
                let guide = line.at(state);
                let x = at(point);
                let across = across(x - at(&arm.pivot), guide.t, *point, arm.link, forces);
                let force = forces.at(*point) - guide.n * across;
                forces.hold(arm, force, state);
                let s = guide.t.dot(x - guide.q.p);
                forces.press(hold, Some((line, s)), guide.n, across);
            }
            Pass::Swing {
                pivot,
                pin,
                link,
                along,
                slot,
                slide,
                legs,
            } => {
                let t = Vec2::of(*along).turned(state.links[link.index()].d);
                let s = t.dot(at(pin) - at(pivot));
                let across = forces.couple(*link) / s;
                let force = t.perp() * across;
                forces.points[pin.index()] += force;
                forces.points[pivot.index()] += -force;
                forces.note(*slot, force);
                swung(*slide, legs, across, force, state, forces);
            }
            Pass::Lines {
                point,
                lines,
                holds,
            } => {
                let [one, two] = [lines[0].at(state), lines[1].at(state)];
                let force = forces.at(*point);
                let x = at(point);
                // F = a n1 + b n2.
                let det = one.n.dot(two.t);
                let a = force.dot(two.t) / det;
                let b = -(force.dot(one.t) / det);
                let s = [&one, &two].map(|guide| guide.t.dot(x - guide.q.p));
                forces.press(&holds[0], Some((&lines[0], s[0])), one.n, a);
                forces.press(&holds[1], Some((&lines[1], s[1])), two.n, b);
            }
            // Coupled groups are run by the engine, which owns them.
            Pass::Coupled { .. } => {}
        }
    }
}

/// What two arms make of the force at their joint: with g on the far link, f x g = -M2 and
/// e x (F - g) = -M1. Gives F - g, the force on the near one.
#[inline(always)]
fn circles<T: Number>(
    point: PointId,
    near: &Reach,
    far: &Reach,
    state: &State<T>,
    forces: &mut Forces<T>,
) -> Vec2<T> {
    let at = |point: PointId| -> &PointState<T> { &state.points[point.index()] };
    let x = at(point).p;
    let (e, f) = (x - at(near.pivot).p, x - at(far.pivot).p);
    let force = forces.at(point);
    let one = forces.couple(near.link) + e.cross(force);
    let g = (f * one + e * forces.couple(far.link)) / e.cross(f);
    forces.hold(far, g, state);
    forces.hold(near, force - g, state);
    force - g
}

/// What a joint on a line presses on it, of an arm e whose couple the line must hold:
/// M + e x (F - N n) = 0, and e x n = e.t.
#[inline(always)]
fn across<T: Number>(
    e: Vec2<T>,
    t: Vec2<T>,
    point: PointId,
    link: LinkId,
    forces: &Forces<T>,
) -> T {
    (forces.couple(link) + e.cross(forces.at(point))) / e.dot(t)
}

/// The guide of an arm that slides through a pin presses on it by `across`. Where links lie between the
/// pin and the sliding point, each feels it at both ends.
#[inline(always)]
fn swung<T: Number>(
    slide: Option<SlideId>,
    legs: &[Leg],
    across: T,
    force: Vec2<T>,
    state: &State<T>,
    forces: &mut Forces<T>,
) {
    let Some(slide) = slide else { return };
    forces.normals[slide.index()] = across;
    for leg in legs {
        forces.note(leg.slots[0], force);
        forces.note(leg.slots[1], -force);
        let [out, near] = leg.joints.map(|joint| state.points[joint.index()].p);
        forces.couples[leg.link.index()] += (out - near).cross(force);
    }
}
