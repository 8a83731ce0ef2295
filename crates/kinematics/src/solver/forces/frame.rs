//! Computes the force of the whole mechanism on the frame, from the forces at its joints and
//! guides.

use super::ForceState;
use super::storage::{Slot, Slots};
use crate::solver::state::State;
use crate::{Body, Input, Mechanism, Number, PointId, SlideId, Slider, Vec2};

/// The connections of the mechanism to the ground.
#[derive(Clone, Debug)]
pub(super) struct GroundConnections {
    /// The members of links that are ground points.
    pins: Vec<(Slot, PointId)>,
    /// All points of the ground.
    points: Vec<PointId>,
    /// The slides with a guide on the ground, their sliding point, and the number of the input that
    /// drives them, if any.
    guides: Vec<(SlideId, PointId, Option<usize>)>,
    /// The slides whose pin is a ground point. The frame bears the guide's force on it.
    held: Vec<(SlideId, PointId, Option<usize>)>,
    /// The slides of links, with the slot of the origin's force, which excludes the guide's own.
    origins: Vec<(SlideId, Slot, Option<usize>)>,
    /// Whether each input turns a link relative to the ground.
    turned: Vec<bool>,
}

impl GroundConnections {
    pub(super) fn new(mechanism: &Mechanism, slots: &Slots) -> GroundConnections {
        let is_ground = |p: PointId| mechanism.point(p).ground.is_some();
        let pins = slots.members.iter().enumerate();
        let pins = pins.filter(|(_, p)| is_ground(**p)).map(|(s, &p)| (s, p));
        let driven = |slide| mechanism.inputs().position(|i| i == Input::Push(slide));
        let slides = || mechanism.slide_ids().map(|id| (id, mechanism.slide(id)));
        let guides = slides().filter(|(_, slide)| slide.on == Body::Ground);
        let held = slides().filter_map(|(id, slide)| match slide.slider {
            Slider::Pin(pin) if is_ground(pin) => Some((id, pin, driven(id))),
            Slider::Pin(_) | Slider::Link { .. } => None,
        });
        let origins = slides().filter_map(|(id, slide)| match slide.slider {
            Slider::Pin(_) => None,
            Slider::Link { link, origin, .. } => Some((id, slots.of(link, origin), driven(id))),
        });
        GroundConnections {
            pins: pins.collect(),
            points: mechanism.point_ids().filter(|&p| is_ground(p)).collect(),
            guides: guides
                .map(|(id, slide)| (id, slide.slider.point(), driven(id)))
                .collect(),
            held: held.collect(),
            origins: origins.collect(),
            turned: mechanism
                .inputs()
                .map(|i| matches!(i, Input::Turn(link) if mechanism.is_directed(link)))
                .collect(),
        }
    }

    /// Adds loads on ground points directly to the frame.
    pub(super) fn note_ground<T: Number>(&self, forces: &mut ForceState<T>, state: &State<T>) {
        for &point in &self.points {
            let force = forces.points[point.index()];
            forces.frame += force;
            forces.frame_moment += state.points[point.index()].p.cross(force);
        }
    }

    /// Subtracts the guide's force at the origin of each sliding link. The remainder is the pin's
    /// force.
    pub(super) fn free_origins<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>) {
        for &(slide, slot, driven) in &self.origins {
            let force = guided(slide, driven, state, forces);
            forces.joints[slot] = forces.joints[slot] - force;
        }
    }

    /// Adds all forces on the frame, once every joint and guide has its force.
    pub(super) fn add_frame_forces<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>) {
        for &(slot, point) in &self.pins {
            add_ground_reaction(point, forces.joints[slot], state, forces);
        }
        for &(slide, point, driven) in &self.guides {
            add_ground_reaction(point, guided(slide, driven, state, forces), state, forces);
            forces.frame_moment = forces.frame_moment - forces.moments[slide.index()];
        }
        for &(slide, point, driven) in &self.held {
            add_ground_reaction(point, -guided(slide, driven, state, forces), state, forces);
        }
        for (input, _) in self.turned.iter().enumerate().filter(|(_, turns)| **turns) {
            // A motor that turns a link is mounted on the frame.
            let effort = forces.efforts[input];
            forces.frame_moment += effort;
        }
    }
}

/// Returns the force of a guide on its slider, including the driver's force if it is driven.
fn guided<T: Number>(
    slide: SlideId,
    driven: Option<usize>,
    state: &State<T>,
    forces: &ForceState<T>,
) -> Vec2<T> {
    let t = state.travels[slide.index()].guide.d;
    let across = t.perp() * forces.normals[slide.index()];
    match driven {
        Some(input) => across - t * forces.efforts[input],
        None => across,
    }
}

/// Adds the reaction on the frame of a force on the mechanism at a ground point.
fn add_ground_reaction<T: Number>(
    point: PointId,
    force: Vec2<T>,
    state: &State<T>,
    forces: &mut ForceState<T>,
) {
    forces.frame = forces.frame - force;
    let moment = state.points[point.index()].p.cross(force);
    forces.frame_moment = forces.frame_moment - moment;
}
