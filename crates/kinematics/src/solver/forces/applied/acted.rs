//! What each load does at a state, one by one, to be read.

use super::{Act, Acting, closing};
use crate::solver::forces::ForceState;
use crate::solver::state::State;
use crate::solver::{Order, Solver};
use crate::{LinkId, PointId, Vec2};

/// What one load does at a state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Acted {
    /// Its forces with the points where they act, in N in the ground's frame.
    pub forces: Vec<(PointId, Vec2)>,
    /// Its couples on links, in N m.
    pub couples: Vec<(LinkId, f64)>,
    /// The link on which it acts itself, and not on the pin at that point: of a press, what slides.
    pub on: Option<LinkId>,
    /// Of a press, where it is in its stroke.
    pub stroke: Option<PressStroke>,
}

/// Where a press is in its stroke.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PressStroke {
    /// How far from the end, in the scene's unit: 0 there.
    pub distance: f64,
    /// Where it ends, in the scene's unit along the guide.
    pub bottom: f64,
    /// Whether it moves towards the end.
    pub closes: bool,
}

impl Solver {
    /// What the loads of the mechanism do at a state that is solved to its velocities, in their order;
    /// nothing where there are no velocities.
    #[must_use]
    pub fn acted(&self, state: &State) -> Vec<Acted> {
        let exists = state.has(Order::Velocity);
        let Some(balance) = self.balance.as_ref().filter(|_| exists) else {
            return Vec::new();
        };
        let mut room = *balance.room(&self.engine);
        let loads = balance.acting.loads.iter();
        loads
            .map(|load| balance.acting.one(load, state, &mut room))
            .collect()
    }
}

impl Acting {
    fn one(&self, load: &Act, state: &State, room: &mut ForceState<f64>) -> Acted {
        room.clear();
        self.load(load, state, room);
        let at = |point: PointId| (point, room.points[point.index()]);
        let couple = |link: LinkId| (link, room.links[link.index()] * self.unit.hi);
        let (forces, couples) = match load {
            Act::Force { point, .. } | Act::Press { point, .. } => (vec![at(*point)], Vec::new()),
            Act::Spring(spring) => (vec![at(spring.from), at(spring.to)], Vec::new()),
            Act::Torque { link, .. } => (Vec::new(), vec![couple(*link)]),
            Act::Torsion(spring) => {
                let links = [Some(spring.link), spring.to].into_iter().flatten();
                (Vec::new(), links.map(couple).collect())
            }
        };
        let on = match load {
            Act::Press { on, .. } => on.map(|(link, _)| link),
            Act::Force { .. } | Act::Spring(_) | Act::Torque { .. } | Act::Torsion(_) => None,
        };
        let stroke = match load {
            Act::Press {
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
            Act::Force { .. } | Act::Spring(_) | Act::Torque { .. } | Act::Torsion(_) => None,
        };
        Acted {
            forces,
            couples,
            on,
            stroke,
        }
    }
}
