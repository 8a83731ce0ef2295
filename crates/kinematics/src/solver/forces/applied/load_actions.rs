//! Reads the action of each load at a state.

use super::{PreparedLoads, ScaledLoad, closing};
use crate::solver::forces::ForceState;
use crate::solver::state::State;
use crate::solver::{Order, Solver};
use crate::{LinkId, PointId, Vec2};

/// The action of one load at a state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LoadAction {
    /// The forces with the points at which they act, in N in the ground's frame.
    pub forces: Vec<(PointId, Vec2)>,
    /// The couples on links, in N m.
    pub couples: Vec<(LinkId, f64)>,
    /// The link on which it acts itself, not on the pin at that point: the sliding link of a press.
    pub on: Option<LinkId>,
    /// The position of a press in its stroke.
    pub stroke: Option<PressStroke>,
}

/// The position of a press in its stroke.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PressStroke {
    /// The distance from the end of the stroke, in the scene's unit: 0 at the end.
    pub distance: f64,
    /// The position of the end along the guide, in the scene's unit.
    pub bottom: f64,
    /// `true` if the slide moves towards the end.
    pub closes: bool,
}

impl Solver {
    /// Returns the actions of the mechanism's loads, in their order, at a state solved at least to
    /// its velocities. Empty without velocities.
    #[must_use]
    pub fn acted(&self, state: &State) -> Vec<LoadAction> {
        let exists = state.has(Order::Velocity);
        let Some(balance) = self.balance.as_ref().filter(|_| exists) else {
            return Vec::new();
        };
        let mut buffers = *balance.force_state(&self.engine);
        let loads = balance.acting.loads.iter();
        loads
            .map(|load| balance.acting.one(load, state, &mut buffers))
            .collect()
    }
}

impl PreparedLoads {
    fn one(&self, load: &ScaledLoad, state: &State, buffers: &mut ForceState<f64>) -> LoadAction {
        buffers.clear();
        self.load(load, state, buffers);
        let at = |point: PointId| (point, buffers.points[point.index()]);
        let couple = |link: LinkId| (link, buffers.links[link.index()] * self.unit.hi);
        let (forces, couples) = match load {
            ScaledLoad::Force { point, .. } | ScaledLoad::Press { point, .. } => {
                (vec![at(*point)], Vec::new())
            }
            ScaledLoad::Spring(spring) => (vec![at(spring.from), at(spring.to)], Vec::new()),
            ScaledLoad::Torque { link, .. } => (Vec::new(), vec![couple(*link)]),
            ScaledLoad::Torsion(spring) => {
                let links = [Some(spring.link), spring.to].into_iter().flatten();
                (Vec::new(), links.map(couple).collect())
            }
        };
        let on = match load {
            ScaledLoad::Press { on, .. } => on.map(|(link, _)| link),
            ScaledLoad::Force { .. }
            | ScaledLoad::Spring(_)
            | ScaledLoad::Torque { .. }
            | ScaledLoad::Torsion(_) => None,
        };
        let stroke = match load {
            ScaledLoad::Press {
                slide, end, stroke, ..
            } => {
                let (distance, towards) =
                    closing((*slide, &state.sliding(*slide)), *end, stroke, state);
                Some(PressStroke {
                    distance,
                    bottom: stroke.bottom.hi,
                    closes: towards > 0.0,
                })
            }
            ScaledLoad::Force { .. }
            | ScaledLoad::Spring(_)
            | ScaledLoad::Torque { .. }
            | ScaledLoad::Torsion(_) => None,
        };
        LoadAction {
            forces,
            couples,
            on,
            stroke,
        }
    }
}
