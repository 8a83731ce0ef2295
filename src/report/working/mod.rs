//! The working shown: how the figures of one state come about, so that a table can be checked by hand.
//!
//! Vector polygons, position table, loop equations in components and projected, the solution of each group
//! with every figure on the way, velocities and accelerations from the differentiated equations, the
//! points by their parts, and the check. What is known at a step is read from the solver's state; what is
//! worked out is worked out by the formula that is printed, and noted beside the solver's figure.

mod check;
mod coupled;
mod draft;
mod equations;
mod expression;
mod figures;
mod forces;
mod free_body;
mod guided;
mod loads;
mod loop_finder;
mod methods;
mod opening;
mod pins;
mod place;
mod points;
mod polygon;
mod rates;
mod sides;
mod solution;
mod stages;
mod symbols;
mod triangle;

pub use draft::Agreement;
pub use methods::{Guess, GuessError, PositionMethod, WorkedMethod};

use crate::page::Page;
use crate::scene::Scene;
use crate::solver::{Order, Solver, State};
use draft::{Context, Draft};
use figures::Figures;
use polygon::Polygon;
use stages::{Schedule, Stage};

/// What a scene's working is written from, found once: its loops, and what each group seeks in them.
#[derive(Clone, Debug)]
pub struct Working {
    polygon: Polygon,
    schedule: Schedule,
    stages: Vec<Stage>,
}

/// The working of one state.
#[derive(Clone, Debug)]
pub struct Worked {
    /// What is to be read.
    pub page: Page,
    /// Every figure that was worked out by a printed formula, beside the solver's.
    pub agreements: Vec<Agreement>,
}

impl Working {
    /// Finds the loops of a scene.
    #[must_use]
    pub fn new(scene: &Scene, solver: &Solver) -> Working {
        let plan = solver.plan();
        let polygon = Polygon::of(scene, plan);
        let schedule = Schedule::of(scene, plan, &polygon);
        let stages = stages::stages(plan, &polygon, &schedule);
        Working {
            polygon,
            schedule,
            stages,
        }
    }

    /// The working of a state of the same scene, solved as far as there is anything, to so many
    /// significant digits.
    #[must_use]
    pub fn of(&self, scene: &Scene, solver: &Solver, state: &State, digits: usize) -> Worked {
        let context = self.context(scene, solver, state, digits);
        let mut draft = Draft::default();
        opening::heading(&context, &mut draft);
        opening::polygons(&context, &mut draft);
        opening::position_table(&context, &mut draft);
        place::equations(&context, &mut draft);
        place::solutions(&context, &mut draft);
        rates::rates(&context, &mut draft, Order::Velocity);
        rates::rates(&context, &mut draft, Order::Acceleration);
        points::points(&context, &mut draft);
        forces::forces(&context, &mut draft);
        check::check(&context, &mut draft);
        Worked {
            page: draft.page,
            agreements: draft.agreements,
        }
    }

    /// What every part is written from.
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
            readings: Vec::new(),
            fastest: [0.0; 2],
        };
        context.read_sides();
        context.find_fastest();
        context
    }
}
