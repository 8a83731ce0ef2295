//! Forces: what the driver must do, and what the joints carry.
//!
//! The steps of the plan, run backwards, are the transpose of the velocities' solution. What acts is put
//! upon the points and links as forces and couples; then every step, the last one first, hands what has
//! come to the things that it placed on to those that it placed them by. A link of two joints cannot
//! keep what it is given, a dyad decides between its two pivots by the determinant that its velocities
//! come from, a coupled group by its own matrix, transposed. What reaches the driven coordinate is what
//! the driver holds against. On the way it is noted what passes every joint and every guide.
//!
//! Two checks share nothing with this but the state: the virtual work of all that acts against that
//! of the driver, and the equilibrium of the whole with the forces on the frame.
//!
//! Friction is not modelled. A force at a joint acts on its pin.

mod acting;
mod backwards;
mod locked;
mod open;
mod pass;
mod profile;
mod stroke;

use super::engine::Engine;
use super::network::Network;
use super::state::{Condition, State};
use super::Solver;
use crate::{Body, Constant, Input, LinkId, Mechanism, Number, PointId, SlideId, StrokeEnd, Vec2};
pub use acting::Acted;
use acting::Acting;
use locked::Locked;
pub use open::Indeterminate;
use open::Open;
use pass::Pass;
use std::sync::Arc;

/// Where the force on a link at one of its points is noted: a place for every member of every link, and
/// one more for what nobody asks about.
#[derive(Clone, Debug)]
pub(super) struct Slots {
    starts: Vec<usize>,
    members: Vec<PointId>,
}

type Slot = usize;

impl Slots {
    fn new(mechanism: &Mechanism) -> Slots {
        let mut slots = Slots {
            starts: Vec::new(),
            members: Vec::new(),
        };
        for link in mechanism.links() {
            slots.starts.push(slots.members.len());
            slots.members.extend(link.members.iter().map(|m| m.point));
        }
        slots.starts.push(slots.members.len());
        slots
    }

    /// The place that nobody reads.
    fn nowhere(&self) -> Slot {
        self.members.len()
    }

    fn find(&self, link: LinkId, point: PointId) -> Option<Slot> {
        let range = *self.starts.get(link.index())?..*self.starts.get(link.index() + 1)?;
        let members = &self.members[range.clone()];
        let place = members.iter().position(|&p| p == point)?;
        Some(range.start + place)
    }

    pub(super) fn of(&self, link: LinkId, point: PointId) -> Slot {
        self.find(link, point).unwrap_or(self.nowhere())
    }
}

/// How the torque is split.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Load,
    Gravity,
    Inertia,
}

/// How much of the forces exists at a state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Extent {
    /// Nothing: they were not asked for, or there are none.
    #[default]
    Nothing,
    /// What the driver must do, from the virtual work: at a change point the reactions need not exist.
    Drive,
    All,
}

/// The forces of a state, and the room to find them.
#[derive(Clone, Debug)]
pub(super) struct Forces<T> {
    slots: Arc<Slots>,
    open: Arc<Open>,
    extent: Extent,
    /// What has come to each point and link so far: dual to their velocities.
    pub(super) points: Vec<Vec2<T>>,
    pub(super) links: Vec<T>,
    /// The couple of every link that is locked to others: what passes through its locks.
    pub(super) couples: Vec<T>,
    /// On a link at one of its points, by slot.
    joints: Vec<Vec2<T>>,
    /// Of a guide on what slides, across the guide; and the couple.
    pub(super) normals: Vec<T>,
    moments: Vec<T>,
    /// What has come to the driver's coordinate.
    pub(super) drive: T,
    /// The virtual work of each part of what acts, for a unit rate of the driver's coordinate.
    work: [T; 3],
    /// The sum of all that acts, and its moment about the solver's origin.
    sum: Vec2<T>,
    sum_moment: T,
    /// What the frame feels, and its moment about the solver's origin.
    frame: Vec2<T>,
    frame_moment: T,
    scale: Scale<T>,
}

/// From the solver's lengths to N m.
#[derive(Clone, Copy, Debug)]
struct Scale<T> {
    /// N m in a newton times the solver's length.
    couple: T,
    /// The same for what belongs to the driver's coordinate: 1 where that is a length.
    drive: T,
    /// The solver's origin in metres.
    origin: Vec2<T>,
}

/// How far the two checks miss; zero but for rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residual<T = f64> {
    /// Between the driver's torque (N m), or force (N), and what the virtual work of all that acts asks
    /// for.
    pub drive: T,
    /// Between the force on the frame and the sum of all that acts, in N.
    pub force: Vec2<T>,
    /// The same of the moments about the scene's origin, in N m.
    pub moment: T,
}

impl<T: Number> Forces<T> {
    /// A force at a point.
    #[inline(always)]
    fn push(&mut self, part: Part, point: PointId, force: Vec2<T>, state: &State<T>) {
        let at = &state.points[point.index()];
        self.points[point.index()] += force;
        self.sum += force;
        self.sum_moment += at.p.cross(force);
        self.work[part as usize] += force.dot(at.v);
    }

    /// A couple on a link.
    #[inline(always)]
    fn twist(&mut self, part: Part, link: LinkId, couple: T, state: &State<T>) {
        self.links[link.index()] += couple;
        self.sum_moment += couple;
        self.work[part as usize] += couple * state.links[link.index()].w;
    }

    fn clear(&mut self) {
        self.points.fill(Vec2::default());
        self.links.fill(T::default());
        self.couples.fill(T::default());
        self.joints.fill(Vec2::default());
        self.normals.fill(T::default());
        self.moments.fill(T::default());
        (self.drive, self.work) = (T::default(), [T::default(); 3]);
        (self.sum, self.sum_moment) = (Vec2::default(), T::default());
        (self.frame, self.frame_moment) = (Vec2::default(), T::default());
    }

    fn all(&self) -> Option<&Forces<T>> {
        (self.extent == Extent::All).then_some(self)
    }

    /// What the driver does against the virtual work of a part.
    fn against(&self, part: Part) -> T {
        -(self.work[part as usize] * self.scale.drive)
    }
}

/// How the forces of one mechanism are found.
#[derive(Clone, Debug)]
pub(super) struct Balance {
    acting: Acting,
    passes: Vec<Pass>,
    slots: Arc<Slots>,
    locked: Locked,
    /// Reactions that a redundant linkage leaves open.
    open: Arc<Open>,
    indeterminate: Vec<Indeterminate>,
    frame: Framed,
    driven: Option<LinkId>,
}

/// What stands on the ground.
#[derive(Clone, Debug)]
struct Framed {
    /// The members of links that are ground points.
    pins: Vec<(Slot, PointId)>,
    /// All points of the ground.
    points: Vec<PointId>,
    /// The slides whose guide is on the ground, with the point that slides; and whether it is driven.
    guides: Vec<(SlideId, PointId, bool)>,
    /// The slides of links, with the place of the origin's force; the guide's own is none of it.
    origins: Vec<(SlideId, Slot, bool)>,
}

impl Framed {
    fn new(mechanism: &Mechanism, slots: &Slots) -> Framed {
        let is_ground = |p: PointId| mechanism.point(p).ground.is_some();
        let pins = slots.members.iter().enumerate();
        let pins = pins.filter(|(_, p)| is_ground(**p)).map(|(s, &p)| (s, p));
        let is_driven = |slide| mechanism.driver().input == Input::Push(slide);
        let slides = || mechanism.slide_ids().map(|id| (id, mechanism.slide(id)));
        let guides = slides().filter(|(_, slide)| slide.on == Body::Ground);
        let origins = slides().filter_map(|(id, slide)| match slide.slider {
            crate::Slider::Pin(_) => None,
            crate::Slider::Link { link, origin, .. } => {
                Some((id, slots.of(link, origin), is_driven(id)))
            }
        });
        Framed {
            pins: pins.collect(),
            points: mechanism.point_ids().filter(|&p| is_ground(p)).collect(),
            guides: guides
                .map(|(id, slide)| (id, slide.slider.point(), is_driven(id)))
                .collect(),
            origins: origins.collect(),
        }
    }
}

impl Balance {
    /// Of a solver that is complete but for its forces; `None` where nothing acts.
    pub(super) fn new(network: &Network<'_>, solver: &Solver) -> Option<Arc<Balance>> {
        let bottom = |slide, end| stroke::end(solver, slide, end);
        let mut balance = Balance::with(network, &solver.engine, bottom)?;
        balance.leave_open(network, solver);
        Some(Arc::new(balance))
    }

    /// Of a mechanism with other lengths: the strokes of its presses end where they did.
    pub(super) fn beside(&self, network: &Network<'_>, engine: &Engine) -> Option<Arc<Balance>> {
        let bottom = |slide, end| self.acting.bottom(slide, end);
        let balance = Balance::with(network, engine, bottom)?;
        Some(Arc::new(Balance {
            open: Arc::clone(&self.open),
            indeterminate: self.indeterminate.clone(),
            ..balance
        }))
    }

    fn with(
        network: &Network<'_>,
        engine: &Engine,
        bottom: impl Fn(SlideId, StrokeEnd) -> Constant,
    ) -> Option<Balance> {
        let mechanism = network.mechanism;
        if !mechanism.has_forces() {
            return None;
        }
        let slots = Arc::new(Slots::new(mechanism));
        Some(Balance {
            acting: Acting::new(mechanism, engine.frame, bottom),
            passes: pass::passes(network, &engine.program, &slots),
            locked: Locked::new(network, &engine.program),
            open: Arc::new(Open::none(mechanism, &slots)),
            indeterminate: Vec::new(),
            frame: Framed::new(mechanism, &slots),
            driven: engine.driven(),
            slots,
        })
    }

    /// Finds what a redundant linkage leaves open, at several places of its motion.
    fn leave_open(&mut self, network: &Network<'_>, solver: &Solver) {
        let mut state = solver.state();
        state.forces = Some(Box::new(self.forces(&solver.engine, solver.slides)));
        let open = Open::find(self, network, solver, &mut state);
        self.indeterminate = open.list(network.mechanism, &self.slots);
        self.open = Arc::new(open);
    }

    /// The reactions that the equilibrium leaves open.
    pub(super) fn indeterminate(&self) -> &[Indeterminate] {
        &self.indeterminate
    }

    /// Room for the forces of a state.
    pub(super) fn forces<T: Number>(&self, engine: &Engine, slides: usize) -> Forces<T> {
        let unit = T::of(self.acting.unit);
        let origin = engine.frame.origin().map(Constant::given);
        let metres = unit.scaled(1.0 / engine.frame.scale);
        Forces {
            slots: Arc::clone(&self.slots),
            open: Arc::clone(&self.open),
            extent: Extent::Nothing,
            points: vec![Vec2::default(); engine.program.points.len()],
            links: vec![T::default(); engine.program.links.len()],
            couples: vec![T::default(); engine.program.links.len()],
            joints: vec![Vec2::default(); self.slots.nowhere() + 1],
            normals: vec![T::default(); slides],
            moments: vec![T::default(); slides],
            drive: T::default(),
            work: [T::default(); 3],
            sum: Vec2::default(),
            sum_moment: T::default(),
            frame: Vec2::default(),
            frame_moment: T::default(),
            scale: Scale {
                couple: unit,
                drive: if engine.turns { unit } else { T::exactly(1.0) },
                origin: Vec2::of(origin) * metres,
            },
        }
    }

    /// Whether what acts is one formula over the whole motion, without pieces.
    pub(super) fn is_smooth(&self) -> bool {
        self.acting.is_smooth()
    }

    /// Finds the forces of a state that has been solved to its accelerations.
    #[inline(always)]
    pub(super) fn balance<T: Number>(&self, engine: &Engine, state: &mut State<T>) {
        let Some(mut forces) = state.forces.take() else {
            return;
        };
        forces.extent = match state.condition {
            Condition::Ok => Extent::All,
            Condition::ChangePoint => Extent::Drive,
            Condition::DeadPoint | Condition::NoAssembly => Extent::Nothing,
        };
        if forces.extent != Extent::Nothing {
            forces.clear();
            self.acting.act(state, &mut forces);
        }
        if forces.extent == Extent::All {
            self.note_ground(&mut forces, state);
            if self.run_back(engine, state, &mut forces) {
                self.finish(state, &mut forces);
            } else {
                forces.extent = Extent::Drive;
            }
        }
        state.forces = Some(forces);
    }

    /// What acts on the ground itself goes into the frame at once.
    fn note_ground<T: Number>(&self, forces: &mut Forces<T>, state: &State<T>) {
        for &point in &self.frame.points {
            let force = forces.points[point.index()];
            forces.frame += force;
            forces.frame_moment += state.points[point.index()].p.cross(force);
        }
    }

    /// Every step backwards; whether all could be.
    #[inline(always)]
    fn run_back<T: Number>(
        &self,
        engine: &Engine,
        state: &mut State<T>,
        forces: &mut Forces<T>,
    ) -> bool {
        let (q, _) = engine.coordinate(state.at);
        self.passes.iter().rev().all(|pass| match pass {
            Pass::Coupled { index } => {
                let group = &engine.program.coupled[*index];
                group.run_back(q, &self.slots, state, forces)
            }
            pass => {
                pass.run(state, forces);
                true
            }
        })
    }

    /// What follows from the forces at the joints: couples of the locks, and the frame.
    fn finish<T: Number>(&self, state: &State<T>, forces: &mut Forces<T>) {
        if let Some(link) = self.driven {
            forces.drive = forces.links[link.index()];
        }
        self.finish_links(state, forces);
        let drive = -forces.drive;
        let feel = |point: PointId, force: Vec2<T>, forces: &mut Forces<T>| {
            forces.frame = forces.frame - force;
            let moment = state.points[point.index()].p.cross(force);
            forces.frame_moment = forces.frame_moment - moment;
        };
        for &(slot, point) in &self.frame.pins {
            feel(point, forces.joints[slot], forces);
        }
        for &(slide, point, is_driven) in &self.frame.guides {
            feel(point, guided(slide, is_driven, state, forces), forces);
            forces.frame_moment = forces.frame_moment - forces.moments[slide.index()];
        }
        if self.driven.is_some() {
            // The motor stands on the frame.
            forces.frame_moment = forces.frame_moment - drive;
        }
    }

    /// The couples of the locks, and what pins alone do to the origins of sliding links.
    fn finish_links<T: Number>(&self, state: &State<T>, forces: &mut Forces<T>) {
        self.locked.finish(forces);
        for &(slide, slot, is_driven) in &self.frame.origins {
            let force = guided(slide, is_driven, state, forces);
            forces.joints[slot] = forces.joints[slot] - force;
        }
    }
}

/// The force of a guide on what slides along it, that of the driver included.
fn guided<T: Number>(
    slide: SlideId,
    is_driven: bool,
    state: &State<T>,
    forces: &Forces<T>,
) -> Vec2<T> {
    let t = state.travels[slide.index()].guide.d;
    let across = t.perp() * forces.normals[slide.index()];
    if is_driven {
        across + t * -forces.drive
    } else {
        across
    }
}

impl<T: Number> State<T> {
    /// The state has been solved without its forces.
    #[inline]
    pub(super) fn forget_forces(&mut self) {
        if let Some(forces) = &mut self.forces {
            forces.extent = Extent::Nothing;
        }
    }

    fn balanced(&self) -> Option<&Forces<T>> {
        self.forces.as_deref()?.all()
    }

    /// What the driver must do: its torque in N m, or the force of a driven slide in N. `None` where it
    /// does not exist, or nothing acts, or it was not asked for ([`Order::Force`](super::Order::Force)).
    #[must_use]
    pub fn drive(&self) -> Option<T> {
        let forces = self.forces.as_deref()?;
        match forces.extent {
            Extent::Nothing => None,
            Extent::Drive => self.drive_parts().map(|[a, b, c]| a + b + c),
            Extent::All => Some(-(forces.drive * forces.scale.drive)),
        }
    }

    /// What it does against loads (springs among them), against gravity and against inertia.
    #[must_use]
    pub fn drive_parts(&self) -> Option<[T; 3]> {
        let forces = self.forces.as_deref()?;
        let parts = [Part::Load, Part::Gravity, Part::Inertia];
        (forces.extent != Extent::Nothing).then(|| parts.map(|part| forces.against(part)))
    }

    /// The power of the driver in W: positive where it gives energy to the linkage.
    #[must_use]
    pub fn power(&self) -> Option<T> {
        let forces = self.forces.as_deref()?;
        let metres = forces.scale.couple.scaled(1.0 / self.frame.scale);
        let speed = self.driver_speed();
        let speed = if self.driven.is_some() {
            speed
        } else {
            speed * metres
        };
        Some(self.drive()? * speed)
    }

    /// The force on a link at one of its joints, in N, in the ground's frame: that of the pin, or, at
    /// the origin of a link that slides, what does not come from the guide.
    #[must_use]
    pub fn joint_force(&self, link: LinkId, point: PointId) -> Option<Vec2<T>> {
        let forces = self.balanced()?;
        let slot = forces.slots.find(link, point)?;
        (!forces.open.joints[slot]).then(|| forces.joints[slot])
    }

    /// The force of a guide on what slides along it, in N, positive along the guide's direction turned
    /// by +90 degrees.
    #[must_use]
    pub fn normal(&self, slide: SlideId) -> Option<T> {
        let forces = self.balanced()?;
        let is_open = forces.open.normals[slide.index()];
        (!is_open).then(|| forces.normals[slide.index()])
    }

    /// The moment of a guide on a link that slides without turning, in N m, counter-clockwise, about the
    /// link's origin.
    #[must_use]
    pub fn moment(&self, slide: SlideId) -> Option<T> {
        let forces = self.balanced()?;
        let is_open = forces.open.moments[slide.index()];
        (!is_open).then(|| forces.moments[slide.index()] * forces.scale.couple)
    }

    /// The shaking force: of the whole on the frame, in N.
    #[must_use]
    pub fn frame_force(&self) -> Option<Vec2<T>> {
        Some(self.balanced()?.frame)
    }

    /// The shaking moment: of the whole on the frame, motor included, in N m about the scene's origin.
    #[must_use]
    pub fn frame_moment(&self) -> Option<T> {
        let forces = self.balanced()?;
        let Scale { couple, origin, .. } = forces.scale;
        Some(forces.frame_moment * couple + origin.cross(forces.frame))
    }

    /// How far the two checks miss.
    #[must_use]
    pub fn residual(&self) -> Option<Residual<T>> {
        let forces = self.balanced()?;
        let Scale {
            couple,
            drive,
            origin,
        } = forces.scale;
        let [load, gravity, inertia] = forces.work;
        let force = forces.frame - forces.sum;
        let moment = forces.frame_moment - forces.sum_moment;
        Some(Residual {
            drive: -((forces.drive - (load + gravity + inertia)) * drive),
            force,
            moment: moment * couple + origin.cross(force),
        })
    }
}

#[cfg(test)]
mod tests;
