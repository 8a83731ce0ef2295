#![doc = include_str!("../../guide/forces.md")]

mod applied;
mod checks;
mod frame;
mod least_norm;
mod lock_couples;
mod open;
mod profile;
mod reactions;
mod read;
mod site;
mod storage;
mod stroke;
#[cfg(any(test, feature = "testing"))]
pub(super) mod testing;

pub use applied::{LoadAction, PressStroke};
pub use checks::{ForceCheck, WithheldReason};
pub use least_norm::LeastNorm;
pub use open::Indeterminate;
pub use read::Residual;
pub(super) use site::{ArmSite, LegSite, LineReaction, Site};
pub(super) use storage::{Slot, Slots};

use super::coupled::Scratch;
use super::elements::Pass;
use super::engine::Engine;
use super::further_inputs::Following;
use super::plan::network::Network;
use super::state::{Condition, State};
use super::{Order, Solver, Workspace};
use crate::arithmetic::Sharp;
use crate::{Ball, Input, LinkId, Number, PointId, SlideId, Slider, StrokeEnd, Vec2};
use applied::{LoadReceiver, PreparedLoads};
use frame::GroundConnections;
use lock_couples::Locked;
use open::Open;
use std::sync::Arc;
use stroke::Stroke;

/// A part of the driver's torque.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum TorquePart {
    Load,
    Gravity,
    Inertia,
}

/// The extent to which the forces of a state are known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Extent {
    /// No forces: not requested, or there are none.
    #[default]
    Nothing,
    /// Only the driver's torque or force, from the virtual work. At a change point the reactions
    /// need not exist.
    Drive,
    /// All were computed but cannot be right. Only the residuals that show this can be read.
    WithheldReason(WithheldReason),
    All,
}

/// Returns the sliding point, and the link if it slides without turning.
fn slider(slider: Slider) -> (PointId, Option<LinkId>) {
    match slider {
        Slider::Pin(point) => (point, None),
        Slider::Link { link, origin, .. } => (origin, Some(link)),
    }
}

/// The forces of a state, and the memory to compute them.
#[derive(Clone, Debug)]
pub(super) struct ForceState<T> {
    slots: Arc<Slots>,
    open: Arc<Open>,
    extent: Extent,
    /// The force accumulated on each point, dual to its velocity. `links` has the couples on links.
    pub(super) points: Vec<Vec2<T>>,
    pub(super) links: Vec<T>,
    /// The couple of every link locked to others, transmitted by its locks.
    pub(super) couples: Vec<T>,
    /// The force on a link at one of its points, by slot.
    joints: Vec<Vec2<T>>,
    /// The force of a guide on its slider, perpendicular to the guide. `moments` has the couples.
    pub(super) normals: Vec<T>,
    moments: Vec<T>,
    /// The force accumulated on the driver's coordinate through all inputs.
    pub(super) drive: T,
    inputs: Arc<[Input]>,
    /// The force accumulated on the own coordinate of each input.
    pub(super) efforts: Vec<T>,
    /// The virtual work of each part of the loads, for a unit rate of the driver's coordinate.
    work: [T; 3],
    /// The sum of all loads, and its moment about the solver's origin.
    sum: Vec2<T>,
    sum_moment: T,
    /// The force on the frame, and its moment about the solver's origin.
    frame: Vec2<T>,
    frame_moment: T,
    scale: TorqueScale<T>,
}

/// The conversion from the solver's lengths to N m.
#[derive(Clone, Copy, Debug)]
struct TorqueScale<T> {
    /// N m per newton times the solver's length.
    couple: T,
    /// The factor for the driver's coordinate: 1 if that is a length.
    drive: T,
    /// The solver's origin in metres.
    origin: Vec2<T>,
}

impl<T: Number> LoadReceiver<T> for ForceState<T> {
    #[inline(always)]
    fn push(&mut self, part: TorquePart, point: PointId, force: Vec2<T>, state: &State<T>) {
        let at = &state.points[point.index()];
        self.points[point.index()] += force;
        self.sum += force;
        self.sum_moment += at.p.cross(force);
        self.work[part as usize] += force.dot(at.v);
    }

    #[inline(always)]
    fn twist(&mut self, part: TorquePart, link: LinkId, couple: T, state: &State<T>) {
        self.links[link.index()] += couple;
        self.sum_moment += couple;
        self.work[part as usize] += couple * state.links[link.index()].w;
    }

    #[inline(always)]
    fn twist_ground(&mut self, couple: T) {
        self.sum_moment += couple;
        self.frame_moment += couple;
    }

    #[inline(always)]
    fn add_off_pin_force(&mut self, slot: Slot, force: Vec2<T>) {
        self.note(slot, force);
    }
}

impl<T: Number> ForceState<T> {
    fn clear(&mut self) {
        self.points.fill(Vec2::default());
        self.links.fill(T::default());
        self.couples.fill(T::default());
        self.joints.fill(Vec2::default());
        self.normals.fill(T::default());
        self.moments.fill(T::default());
        self.efforts.fill(T::default());
        (self.drive, self.work) = (T::default(), [T::default(); 3]);
        (self.sum, self.sum_moment) = (Vec2::default(), T::default());
        (self.frame, self.frame_moment) = (Vec2::default(), T::default());
    }

    /// Adds the effort of an input, and its contribution to the driver that it follows.
    #[inline(always)]
    pub(super) fn drive_by(&mut self, following: Option<&Following>, effort: T, state: &State<T>) {
        match following {
            None => {
                self.efforts[0] += effort;
                self.drive += effort;
            }
            Some(following) => {
                self.efforts[following.number] += effort;
                self.drive += effort * following.at(state.coordinate()).w;
            }
        }
    }

    fn all(&self) -> Option<&ForceState<T>> {
        (self.extent == Extent::All).then_some(self)
    }

    /// Returns the effort that the loads require on the driver's coordinate: their virtual work. The
    /// reactions give the same effort, but cancel in it beside change points.
    fn virtual_work(&self) -> T {
        let [load, gravity, inertia] = self.work;
        load + gravity + inertia
    }

    /// Returns the driver's torque or force against the virtual work of a part.
    fn virtual_work_force(&self, part: TorquePart) -> T {
        // Subtracted, so that zero has no negative sign.
        T::default() - self.work[part as usize] * self.scale.drive
    }
}

impl ForceState<Ball> {
    /// Copies all readable values from forces in double-double.
    fn round(&mut self, of: &ForceState<Sharp>) {
        let vector = |v: Vec2<Sharp>| v.map(Ball::from);
        let numbers = |to: &mut [Ball], from: &[Sharp]| {
            for (to, &from) in to.iter_mut().zip(from) {
                *to = Ball::from(from);
            }
        };
        for (to, &from) in self.joints.iter_mut().zip(&of.joints) {
            *to = vector(from);
        }
        numbers(&mut self.normals, &of.normals);
        numbers(&mut self.moments, &of.moments);
        numbers(&mut self.efforts, &of.efforts);
        self.extent = of.extent;
        self.drive = of.drive.into();
        self.work = of.work.map(Ball::from);
        (self.sum, self.sum_moment) = (vector(of.sum), of.sum_moment.into());
        (self.frame, self.frame_moment) = (vector(of.frame), of.frame_moment.into());
    }
}

/// The force analysis of one mechanism.
#[derive(Clone, Debug)]
pub(super) struct Balance {
    acting: PreparedLoads,
    passes: Vec<Pass>,
    slots: Arc<Slots>,
    /// The sliders, by slide: the point, and the link if it slides without turning.
    sliders: Vec<(PointId, Option<LinkId>)>,
    locked: Locked,
    /// The reactions that a redundant linkage leaves undetermined.
    open: Arc<Open>,
    indeterminate: Vec<Indeterminate>,
    frame: GroundConnections,
    inputs: Arc<[Input]>,
}

impl Balance {
    /// Creates the force analysis of a solver complete except for its forces; `None` without loads.
    pub(super) fn new(network: &Network<'_>, solver: &Solver) -> Option<Arc<Balance>> {
        let stroke = |slide, end| stroke::end(solver, slide, end);
        let mut balance = Balance::with(network, &solver.engine, stroke)?;
        balance.find_undetermined(network, solver);
        Some(Arc::new(balance))
    }

    /// Creates the force analysis of the same mechanism with slopes in its constants. `follow`
    /// returns the derivative of a slide's position by the length at a coordinate. The stroke of a
    /// press ends where its slide reverses. That end has the slide's derivative at a fixed
    /// coordinate, since the slide is at rest there.
    pub(super) fn by_length(
        &self,
        network: &Network<'_>,
        engine: &Engine,
        follow: impl Fn(SlideId, f64) -> f64,
    ) -> Option<Arc<Balance>> {
        let stroke = |slide, end| {
            let Stroke { bottom, at } = self.acting.stroke(slide, end);
            let bottom = bottom.with_slope(follow(slide, at));
            Stroke { bottom, at }
        };
        let balance = Balance::with(network, engine, stroke)?;
        Some(Arc::new(Balance {
            open: Arc::clone(&self.open),
            indeterminate: self.indeterminate.clone(),
            ..balance
        }))
    }

    /// Creates the force analysis of the same mechanism in which every input moves by itself.
    pub(super) fn free(&self, network: &Network<'_>, engine: &Engine) -> Option<Balance> {
        let stroke = |slide, end| self.acting.stroke(slide, end);
        let balance = Balance::with(network, engine, stroke)?;
        Some(Balance {
            open: Arc::clone(&self.open),
            indeterminate: self.indeterminate.clone(),
            ..balance
        })
    }

    /// Computes and checks the forces if every input moves by itself, at these speeds in the
    /// solver's units. The forces then contain the power of all inputs.
    pub(super) fn follow_free(
        &self,
        engine: &Engine,
        order: Order,
        speeds: impl Iterator<Item = f64>,
        workspace: &mut Workspace,
    ) {
        Balance::find(Some(self), engine, order, workspace);
        let state = &mut workspace.state;
        if let Some(mut forces) = state.forces.take() {
            let efforts = forces.efforts.iter().zip(speeds);
            forces.drive = efforts.map(|(effort, speed)| effort * speed).sum();
            self.check(state, &mut forces);
            state.forces = Some(forces);
        }
    }

    fn with(
        network: &Network<'_>,
        engine: &Engine,
        stroke: impl Fn(SlideId, StrokeEnd) -> Stroke,
    ) -> Option<Balance> {
        let mechanism = network.mechanism;
        if !mechanism.has_forces() {
            return None;
        }
        let slots = Arc::new(Slots::new(mechanism));
        let passes = site::passes(network, &engine.program, &slots);
        #[cfg(any(test, feature = "testing"))]
        let passes = testing::falsify_if_requested(passes);
        Some(Balance {
            acting: PreparedLoads::new(mechanism, engine.frame, &slots, stroke),
            passes,
            locked: Locked::new(network, &engine.program),
            open: Arc::new(Open::none(mechanism, &slots)),
            indeterminate: Vec::new(),
            frame: GroundConnections::new(mechanism, &slots),
            inputs: mechanism.inputs().collect(),
            sliders: mechanism
                .slides()
                .iter()
                .map(|s| slider(s.slider))
                .collect(),
            slots,
        })
    }

    /// Finds the undetermined reactions of a redundant linkage, at several places of its motion.
    fn find_undetermined(&mut self, network: &Network<'_>, solver: &Solver) {
        let mut state = solver.state();
        state.state.forces = Some(self.force_state(&solver.engine));
        let open = Open::find(self, network, solver, &mut state);
        self.indeterminate = open.list(network.mechanism, &self.slots);
        self.open = Arc::new(open);
    }

    /// Returns the reactions that the equilibrium leaves undetermined.
    pub(super) fn indeterminate(&self) -> &[Indeterminate] {
        &self.indeterminate
    }

    /// Creates the forces of a state.
    pub(super) fn force_state<T: Number>(&self, engine: &Engine) -> Box<ForceState<T>> {
        let slides = self.open.normals.len();
        let unit = T::of(self.acting.unit);
        let origin = engine.frame.origin();
        let metres = unit.scaled(1.0 / engine.frame.scale);
        Box::new(ForceState {
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
            inputs: Arc::clone(&self.inputs),
            efforts: vec![T::default(); self.inputs.len()],
            work: [T::default(); 3],
            sum: Vec2::default(),
            sum_moment: T::default(),
            frame: Vec2::default(),
            frame_moment: T::default(),
            scale: TorqueScale {
                couple: unit,
                drive: if engine.is_rotary {
                    unit
                } else {
                    T::exactly(1.0)
                },
                origin: Vec2::of(origin) * metres,
            },
        })
    }

    /// Returns `true` if all loads are a single formula over the whole motion, without pieces.
    pub(super) fn is_smooth(&self) -> bool {
        self.acting.is_smooth()
    }

    /// Computes and checks the forces after a solve if there are loads and forces were requested,
    /// or else clears them.
    #[inline(always)]
    pub(super) fn follow<T: Number>(
        balance: Option<&Balance>,
        engine: &Engine,
        order: Order,
        workspace: &mut Workspace<T>,
    ) {
        Balance::find(balance, engine, order, workspace);
        let state = &mut workspace.state;
        if let Some(balance) = balance
            && let Some(mut forces) = state.forces.take()
        {
            balance.check(state, &mut forces);
            state.forces = Some(forces);
        }
    }

    /// Encloses the forces of a state. The bounds of the residuals then decide whether it keeps its
    /// own.
    ///
    /// The forces are computed again in double-double from the enclosed motion. The remaining error
    /// is that of the motion and of the scene's numbers.
    pub(super) fn enclose(
        balance: Option<&Balance>,
        engine: &Engine,
        order: Order,
        state: &mut State,
        enclosure: &mut Workspace<Ball>,
    ) {
        let Workspace {
            state: balls,
            errors,
            ..
        } = enclosure;
        let is_asked = balance.is_some() && order == Order::Force;
        let Some(sharp) = errors.sharp.as_mut().filter(|_| is_asked) else {
            balls.forget_forces();
            return;
        };
        sharp.state.start(Sharp::from(balls.at), order);
        sharp.state.condition = balls.condition;
        Balance::find(balance, engine, order, sharp);
        if let (Some(forces), Some(found)) = (&mut balls.forces, &sharp.state.forces) {
            forces.round(found);
        }
        state.check_by_bounds(balls);
    }

    /// Computes the forces without checking them.
    #[inline(always)]
    fn find<T: Number>(
        balance: Option<&Balance>,
        engine: &Engine,
        order: Order,
        workspace: &mut Workspace<T>,
    ) {
        match balance {
            Some(balance) if order == Order::Force => balance.balance(engine, workspace),
            Some(_) | None => workspace.state.forget_forces(),
        }
    }

    /// Computes the forces of a state solved to its accelerations.
    #[inline(always)]
    fn balance<T: Number>(&self, engine: &Engine, workspace: &mut Workspace<T>) {
        let Workspace { state, scratch, .. } = workspace;
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
            self.acting.apply_loads(state, &mut *forces);
        }
        if forces.extent == Extent::All {
            self.frame.note_ground(&mut forces, state);
            if self.run_back(engine, state, scratch, &mut forces) {
                if let Some(link) = engine.driven() {
                    let couple = forces.links[link.index()];
                    forces.drive_by(None, couple, state);
                }
                self.locked.finish(&mut forces);
                self.frame.free_origins(state, &mut forces);
                self.frame.add_frame_forces(state, &mut forces);
            } else {
                forces.extent = Extent::Drive;
            }
        }
        state.forces = Some(forces);
    }

    /// Runs every step backwards. Returns `true` if all succeed.
    #[inline(always)]
    fn run_back<T: Number>(
        &self,
        engine: &Engine,
        state: &State<T>,
        scratch: &mut Scratch<T>,
        forces: &mut ForceState<T>,
    ) -> bool {
        let (q, _) = engine.coordinate(state.at);
        self.passes.iter().rev().all(|pass| match pass {
            Pass::Coupled { index } => {
                let group = &engine.program.coupled[*index];
                group.run_back(q, &self.slots, state, scratch, forces)
            }
            pass => {
                pass.run(state, forces);
                true
            }
        })
    }
}
