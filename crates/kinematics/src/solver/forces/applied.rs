//! Evaluates the loads of a mechanism at a state: loads, springs, presses, weights and inertia, as
//! forces at points and couples on links.
//!
//! Internally lengths are the solver's and forces are in newtons, so couples are in newtons times
//! the solver's length. A factor converts these to N m when they are read.

mod load_actions;
mod springs;

pub use load_actions::{LoadAction, PressStroke};

use super::TorquePart;
use super::profile::ReadyProfile;
use super::storage::{Slot, Slots};
use super::stroke::Stroke;
use crate::solver::frame::Frame;
use crate::solver::state::{Sliding, State};
use crate::{
    Body, Constant, Input, LinkId, Load, Mechanism, Number, PointId, SlideId, Slider, StrokeEnd,
    Vec2,
};
use springs::{LineSpring, TorsionSpring};

/// A receiver of loads: the forces of a state, or a sum of their sizes.
pub(super) trait LoadReceiver<T: Number> {
    /// Adds a force at a point.
    fn push(&mut self, part: TorquePart, point: PointId, force: Vec2<T>, state: &State<T>);

    /// Adds a couple on the ground. It acts on the frame and does no work.
    fn twist_ground(&mut self, couple: T);

    /// Adds a couple on a link.
    fn twist(&mut self, part: TorquePart, link: LinkId, couple: T, state: &State<T>);

    /// Records a force on a link at one of its points that does not come from the pin there.
    fn add_off_pin_force(&mut self, slot: Slot, force: Vec2<T>);
}

/// All loads, prepared for evaluation at a state.
#[derive(Clone, Debug)]
pub(super) struct PreparedLoads {
    loads: Vec<ScaledLoad>,
    masses: Vec<Mass>,
    /// In m/s^2.
    gravity: Vec2<Constant>,
    has_gravity: bool,
    /// The solver's length in metres.
    pub(super) unit: Constant,
}

/// A load in the solver's lengths.
#[derive(Clone, Debug)]
enum ScaledLoad {
    Force {
        point: PointId,
        force: Vec2<Constant>,
        frame: Option<LinkId>,
        over: ReadyProfile,
    },
    Torque {
        link: LinkId,
        torque: Constant,
        over: ReadyProfile,
    },
    Press {
        slide: SlideId,
        point: PointId,
        /// The sliding link, and the slot of its pin's force there: the press acts on the link, not
        /// on the pin.
        on: Option<(LinkId, Slot)>,
        end: StrokeEnd,
        /// The end of the stroke.
        stroke: Stroke,
        curve: ReadyProfile,
    },
    Spring(LineSpring),
    Torsion(TorsionSpring),
}

/// Returns the distance of a slide from the end of its stroke, in the scene's unit, and its speed
/// towards that end. The distance is positive before the end, the speed while it closes.
#[inline(always)]
fn closing<T: Number>(
    (slide, travel): (SlideId, &Sliding<T>),
    end: StrokeEnd,
    stroke: &Stroke,
    state: &State<T>,
) -> (T, T) {
    // A driver at rest counts as moving forwards.
    let driver_states = state.rates.speed.hi == 0.0;
    let rate = if driver_states {
        state.travels[slide.index()].v
    } else {
        travel.rate
    };
    let bottom = T::of(stroke.bottom);
    match end {
        StrokeEnd::Minimum => (travel.position - bottom, -rate),
        StrokeEnd::Maximum => (bottom - travel.position, rate),
    }
}

/// The mass and the moment of inertia of a link.
#[derive(Clone, Copy, Debug)]
struct Mass {
    link: LinkId,
    com: PointId,
    mass: Constant,
    inertia: Constant,
}

impl PreparedLoads {
    /// Creates the loads of a mechanism. `stroke` returns the end of a slide's stroke.
    pub(super) fn new(
        mechanism: &Mechanism,
        frame: Frame,
        slots: &Slots,
        stroke: impl Fn(SlideId, StrokeEnd) -> Stroke,
    ) -> PreparedLoads {
        let loads = mechanism.loads().iter();
        let loads = loads.map(|load| apply_load(mechanism, frame, load, slots, &stroke));
        let masses = mechanism.link_ids().filter_map(|id| {
            let link = mechanism.link(id);
            let has_mass = link.mass > 0.0 || link.inertia > 0.0;
            has_mass.then_some(Mass {
                link: id,
                com: link.com?,
                mass: Constant::given(link.mass),
                inertia: Constant::given(link.inertia),
            })
        });
        PreparedLoads {
            loads: loads.collect(),
            masses: masses.collect(),
            gravity: mechanism.gravity().map(Constant::given),
            has_gravity: mechanism.gravity() != Vec2::ZERO,
            unit: Constant::given(mechanism.metres()).scaled(frame.scale),
        }
    }

    /// Returns the end of a press's stroke.
    pub(super) fn stroke(&self, slide: SlideId, end: StrokeEnd) -> Stroke {
        let found = self.loads.iter().find_map(|load| match load {
            ScaledLoad::Press {
                slide: of,
                end: which,
                stroke,
                ..
            } if (*of, *which) == (slide, end) => Some(*stroke),
            _ => None,
        });
        found.unwrap_or_default()
    }

    /// Returns `true` if all loads are a single formula over the whole motion, without pieces.
    pub(super) fn is_smooth(&self) -> bool {
        self.loads.iter().all(|load| match load {
            ScaledLoad::Force { over, .. } | ScaledLoad::Torque { over, .. } => over.is_one(),
            ScaledLoad::Press { .. } => false,
            ScaledLoad::Spring(spring) => spring.is_smooth(),
            ScaledLoad::Torsion(_) => true,
        })
    }

    /// Applies all loads at this state to the points and links of `forces`.
    #[inline(always)]
    pub(super) fn apply_loads<T: Number>(
        &self,
        state: &State<T>,
        forces: &mut impl LoadReceiver<T>,
    ) {
        for load in &self.loads {
            self.load(load, state, forces);
        }
        let unit = T::of(self.unit);
        let rates = &state.rates;
        for mass in &self.masses {
            let com = &state.points[mass.com.index()];
            let m = T::of(mass.mass);
            if self.has_gravity {
                let weight = Vec2::of(self.gravity) * m;
                forces.push(TorquePart::Gravity, mass.com, weight, state);
            }
            let a = com.a.times(rates.square) + com.v.times(rates.acceleration);
            forces.push(TorquePart::Inertia, mass.com, -(a * (m * unit)), state);
            let link = &state.links[mass.link.index()];
            let alpha = link.a.times(rates.square) + link.w.times(rates.acceleration);
            let couple = -(alpha * T::of(mass.inertia)) / unit;
            forces.twist(TorquePart::Inertia, mass.link, couple, state);
        }
    }

    #[inline(always)]
    fn load<T: Number>(
        &self,
        load: &ScaledLoad,
        state: &State<T>,
        forces: &mut impl LoadReceiver<T>,
    ) {
        match load {
            ScaledLoad::Force {
                point,
                force,
                frame,
                over,
            } => {
                let force = Vec2::of(*force);
                let force = if over.is_one() {
                    force
                } else {
                    force * over.value(state.at)
                };
                let force = match frame {
                    Some(link) => force.turned(state.links[link.index()].d),
                    None => force,
                };
                forces.push(TorquePart::Load, *point, force, state);
            }
            ScaledLoad::Torque { link, torque, over } => {
                let torque = T::of(*torque) * over.value(state.at) / T::of(self.unit);
                forces.twist(TorquePart::Load, *link, torque, state);
            }
            ScaledLoad::Press {
                slide,
                point,
                on,
                end,
                stroke,
                curve,
            } => {
                let travel = state.sliding(*slide);
                let (distance, towards) = closing((*slide, &travel), *end, stroke, state);
                let size = curve.press(distance, towards);
                let guide = travel.guide;
                let against = match end {
                    StrokeEnd::Minimum => guide,
                    StrokeEnd::Maximum => -guide,
                };
                let force = against * size;
                forces.push(TorquePart::Load, *point, force, state);
                if let Some((_, slot)) = on {
                    forces.add_off_pin_force(*slot, -force);
                }
            }
            ScaledLoad::Spring(spring) => spring.pull(state, T::of(self.unit), forces),
            ScaledLoad::Torsion(spring) => spring.turn_back(state, T::of(self.unit), forces),
        }
    }
}

fn apply_load(
    mechanism: &Mechanism,
    frame: Frame,
    load: &Load,
    slots: &Slots,
    stroke: impl Fn(SlideId, StrokeEnd) -> Stroke,
) -> ScaledLoad {
    let is_rotary = matches!(mechanism.driver().input, Input::Turn(_));
    match load {
        Load::Force {
            point,
            force,
            frame,
            over,
        } => ScaledLoad::Force {
            point: *point,
            force: force.map(Constant::given),
            frame: match frame {
                Body::Ground => None,
                Body::Link(link) => Some(*link),
            },
            over: ReadyProfile::over_driver(over, is_rotary),
        },
        Load::Torque { link, torque, over } => ScaledLoad::Torque {
            link: *link,
            torque: Constant::given(*torque),
            over: ReadyProfile::over_driver(over, is_rotary),
        },
        Load::Press { slide, end, curve } => ScaledLoad::Press {
            slide: *slide,
            point: mechanism.slide(*slide).slider.point(),
            on: match mechanism.slide(*slide).slider {
                Slider::Pin(_) => None,
                Slider::Link { link, origin, .. } => Some((link, slots.of(link, origin))),
            },
            end: *end,
            stroke: stroke(*slide, *end),
            curve: ReadyProfile::over_length(curve),
        },
        Load::Spring {
            from,
            to,
            stiffness,
            length,
            preload,
            damping,
        } => {
            let numbers = [*stiffness, *length, *preload, *damping];
            ScaledLoad::Spring(LineSpring::straight([*from, *to], numbers, frame.scale))
        }
        Load::GasSpring {
            from,
            to,
            force,
            damping,
        } => ScaledLoad::Spring(LineSpring::gas(
            [*from, *to],
            (force, *damping),
            frame.scale,
        )),
        Load::TorsionSpring {
            link,
            to,
            stiffness,
            angle,
            preload,
            damping,
        } => {
            let numbers = [*stiffness, *angle, *preload, *damping];
            ScaledLoad::Torsion(TorsionSpring::new(*link, *to, numbers))
        }
    }
}
