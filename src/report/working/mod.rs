//! The working: the worked solution of one state, with all intermediate values, so that a table can
//! be checked by hand.
//!
//! It has vector polygons, the position table, loop equations in components and projected, the
//! solution of each group, velocities and accelerations from the differentiated equations, the
//! motion of points by components, and the check. Values known at a step come from the solver's
//! state. Other values are calculated by the printed formula, and recorded together with the
//! solver's value.

mod check;
mod collected_terms;
mod context;
mod coupled;
mod equations;
mod expression;
mod figures;
mod free_bodies;
mod guided;
mod introduction;
mod loops;
mod methods;
mod point_rates;
mod positions;
mod rates;
mod reactions;
mod symbols;
mod triangle;

pub use context::Agreement;
pub use loops::vectors::{LoopVector, LoopVectors, RelativeMotion, VectorFigure};
pub use methods::{Guess, GuessError, PositionMethod, WorkedMethod};
pub use point_rates::centres::InstantCentre;
pub use point_rates::point_parts::{PointMotion, PointParts};
pub use symbols::WorkingNotation;
pub(super) use symbols::of_point;

use crate::page::Page;
use crate::scene::Scene;
use crate::solver::{Order, Solver, State};
use context::{Context, Draft};
use figures::Figures;
use loops::group_unknowns::{Schedule, Stage};
use loops::polygon::Polygon;

/// The structure of a scene's working, computed once: its loops, and the unknowns of each group in
/// them.
#[derive(Clone, Debug)]
pub struct Working {
    polygon: Polygon,
    schedule: Schedule,
    stages: Vec<Stage>,
}

/// The working of one state.
#[derive(Clone, Debug)]
pub struct WorkedState {
    /// The page.
    pub page: Page,
    /// Every value calculated by a printed formula, with the value found by the solver.
    pub agreements: Vec<Agreement>,
    /// The parts in order, each with the index of its first block of the page.
    pub parts: Vec<(WorkingPart, usize)>,
}

/// A part of the working.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WorkingPart {
    /// The title, and the driver's coordinate.
    Opening,
    /// The unit vectors by which equations are multiplied.
    UnitVectors,
    /// The loops.
    Polygons,
    /// The given values and the unknowns.
    PositionTable,
    /// The loop equations.
    Equations,
    /// The solution of each group.
    Positions,
    /// The first derivatives of the equations, and their solution.
    Velocities,
    /// The second derivatives, and their solution.
    Accelerations,
    /// The motion of points by components.
    Points,
    /// The instant centres of links.
    Centres,
    /// Forces, link by link.
    Forces,
    /// The residuals of the equations.
    Check,
}

type WritePart = fn(&Context<'_>, &mut Draft);

/// The functions that write the parts, in order.
const PARTS: [(WorkingPart, WritePart); 12] = [
    (WorkingPart::Opening, introduction::heading),
    (WorkingPart::Polygons, introduction::polygons),
    (WorkingPart::PositionTable, introduction::position_table),
    (WorkingPart::UnitVectors, introduction::unit_vectors),
    (WorkingPart::Equations, positions::equations),
    (WorkingPart::Positions, positions::solutions),
    (WorkingPart::Velocities, |context, draft| {
        rates::rates(context, draft, Order::Velocity);
    }),
    (WorkingPart::Accelerations, |context, draft| {
        rates::rates(context, draft, Order::Acceleration);
    }),
    (WorkingPart::Points, point_rates::points::points),
    (WorkingPart::Centres, point_rates::kennedy::instant_centres),
    (WorkingPart::Forces, free_bodies::forces::forces),
    (WorkingPart::Check, check::check),
];

impl Working {
    /// Finds the loops of a scene.
    #[must_use]
    pub fn new(scene: &Scene, solver: &Solver) -> Working {
        let plan = solver.plan();
        let polygon = Polygon::of(scene, plan);
        let schedule = Schedule::of(scene, plan, &polygon);
        let stages = loops::group_unknowns::stages(plan, &polygon, &schedule);
        Working {
            polygon,
            schedule,
            stages,
        }
    }

    /// Writes the working of a solved state of this scene, with so many significant digits.
    #[must_use]
    pub fn of(&self, scene: &Scene, solver: &Solver, state: &State, digits: usize) -> WorkedState {
        self.written(scene, solver, state, digits, WorkingNotation::Krank)
    }

    /// Writes the working in a given notation.
    #[must_use]
    pub fn written(
        &self,
        scene: &Scene,
        solver: &Solver,
        state: &State,
        digits: usize,
        notation: WorkingNotation,
    ) -> WorkedState {
        let mut context = self.context(scene, solver, state, digits);
        context.notation = notation;
        let mut draft = Draft::default();
        let names = scene.vectors.iter().map(|vector| vector.name.clone());
        draft.page.set_symbols(names);
        let mut parts = Vec::new();
        for (part, write) in PARTS {
            let start = draft.page.blocks.len();
            write(&context, &mut draft);
            if draft.page.blocks.len() > start {
                parts.push((part, start));
            }
        }
        WorkedState {
            page: draft.page,
            agreements: draft.agreements,
            parts,
        }
    }

    /// Creates the context of a state.
    fn context<'a>(
        &'a self,
        scene: &'a Scene,
        solver: &'a Solver,
        state: &'a State,
        digits: usize,
    ) -> Context<'a> {
        let mut context = Context {
            scene,
            solver,
            state: state.known(),
            polygon: &self.polygon,
            schedule: &self.schedule,
            stages: &self.stages,
            figures: Figures {
                digits,
                unit: scene.unit.symbol(),
            },
            notation: WorkingNotation::Krank,
            readings: Vec::new(),
            longest: 0.0,
            fastest: [0.0; 2],
        };
        context.read_sides();
        context.find_fastest();
        context
    }
}
