//! Designs: a scene with other numbers, opened in the scene's assembly.
//!
//! A [`DesignSpace`] has some variable values of a scene. [`DesignSpace::open`] writes other
//! numbers into the text, parses it as any scene, and opens it. A design therefore equals the scene
//! of a user who types these numbers, including all values derived by formulas. There is one
//! exception: if the text would open in another assembly than the original scene, the assembly is
//! kept. If that is impossible, the design is an error; the assembly never changes silently.
//!
//! ```text
//! plan                plans of designs: a grid or a Latin hypercube, each design with a number
//! evaluation          figures of one design after another
//! lengths             the mechanism of a design, without parsing its text
//! run                 a row for each design of a plan, on all cores, in order
//! goal                goals for cycle figures
//! solve               numbers that meet goals, searched from many starts
//! levenberg           from one start: the Levenberg-Marquardt method
//! optimise            the best numbers under constraints: differential evolution
//! projection          evaluates designs, and projects them onto equality constraints
//! polish              from the best design of the evolution to a local optimum
//! pieces              the same for figures that are maxima or minima of smooth functions
//! quadratic_program   the step to the minimum of a quadratic model with inequalities
//! exact_slopes        derivatives of cycle figures without differences
//! active_constraints  the active constraints and bounds of an optimum
//! kink                optimality where the figure has no derivative
//! ```

mod active_constraints;
#[cfg(test)]
mod best_tests;
mod evaluation;
mod exact_slopes;
mod goal;
#[cfg(test)]
mod goal_tests;
mod kink;
mod lengths;
mod levenberg;
mod optimise;
mod pieces;
mod plan;
mod polish;
mod projection;
mod quadratic_program;
mod run;
mod solve;
#[cfg(test)]
mod tests;

pub use evaluation::DesignFigures;
pub use goal::{Goal, GoalSense, MistypedGoal};
pub use optimise::{BestDesign, OptimiseOrder, OptimiseState};
pub use plan::{DesignPlan, MistypedAxis, PlanAxis};
pub use run::{DesignRow, DesignRun, DesignState};
pub use solve::{FoundDesign, GoalSearch, SearchOutcome};

use crate::Mechanism;
use crate::scene::{Diagnostics, Scene, Value};
use crate::solver::{Condition, EndStop, Fault, Motion, Order, Range, Solver};
use crate::wording::words;

/// Some values of a scene that vary.
#[derive(Clone, Debug)]
pub struct DesignSpace {
    scene: Scene,
    solver: Solver,
    values: Vec<Value>,
}

/// A scene with other numbers.
#[derive(Clone, Debug)]
pub struct Design {
    /// The scene, as it would be saved.
    pub scene: Scene,
    /// The solver, in the assembly of the original scene.
    pub solver: Solver,
    /// `true` if the text alone would open in another assembly.
    pub is_held: bool,
}

/// The reason why a design cannot be opened.
#[derive(Clone, Debug)]
pub enum NoDesign {
    /// The numbers do not give a valid scene.
    Unread(Box<Diagnostics>),
    /// The numbers give a scene with other elements, such as more copies.
    OtherElements,
    /// The design does not assemble as the original scene does; the scene explains the fault in
    /// words.
    Unsolved(Box<Scene>, Box<Fault>),
}

impl DesignSpace {
    /// Creates a space from a scene and its solver; `values` are among [`Scene::values`].
    #[must_use]
    pub fn new(scene: &Scene, solver: &Solver, values: Vec<Value>) -> DesignSpace {
        DesignSpace {
            scene: scene.clone(),
            solver: solver.clone(),
            values,
        }
    }

    /// Creates a space of the values named by axes.
    ///
    /// # Errors
    /// Returns a message if there is no such value, or if two axes name one value.
    pub fn of_axes(
        scene: &Scene,
        solver: &Solver,
        axes: &[PlanAxis],
    ) -> Result<DesignSpace, String> {
        let mut values: Vec<Value> = Vec::new();
        for axis in axes {
            let value = scene.value_named(&axis.name)?;
            if values.iter().any(|other| other.name == value.name) {
                return Err(words().value_twice(&axis.name));
            }
            values.push(value);
        }
        Ok(DesignSpace::new(scene, solver, values))
    }

    /// Returns the given scene.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Returns the given scene's solver.
    #[must_use]
    pub fn solver(&self) -> &Solver {
        &self.solver
    }

    /// Returns the values that vary.
    #[must_use]
    pub fn values(&self) -> &[Value] {
        &self.values
    }

    /// Returns the values' given numbers.
    #[must_use]
    pub fn given(&self) -> Vec<f64> {
        self.values.iter().map(|value| value.number).collect()
    }

    /// Returns the numbers of the variable values in another scene. All its other values must be the
    /// same, except its start positions, which a design may need for its assembly.
    ///
    /// # Errors
    /// Returns the name of the first value that is missing or differs.
    pub fn numbers_in(&self, other: &Scene) -> Result<Vec<f64>, String> {
        let all = other.values();
        let named = |name: &str| all.iter().find(|value| value.name == name);
        let is_varied = |own: &Value| self.values.iter().any(|value| value.name == own.name);
        let is_same = |own: &Value| {
            named(&own.name).is_some_and(|found| {
                let is_equal = own.formula.is_some() || own.number == found.number;
                is_equal && own.formula == found.formula && own.unit == found.unit
            })
        };
        let others = self.scene.values();
        let is_start = |own: &Value| own.name.contains(" start ");
        let mut others = others
            .iter()
            .filter(|own| !is_varied(own) && !is_start(own));
        if let Some(other) = others.find(|own| !is_same(own)) {
            return Err(other.dotted());
        }
        let numbers = self.values.iter().map(|own| match named(&own.name) {
            Some(found) if found.unit == own.unit => Ok(found.number),
            _ => Err(own.dotted()),
        });
        numbers.collect()
    }

    /// Returns the scene's text with other numbers.
    #[must_use]
    pub fn text(&self, numbers: &[f64]) -> String {
        let pairs = self.values.iter().zip(numbers);
        let texts: Vec<(Value, String)> = pairs
            .map(|(value, number)| (value.clone(), value.with_number(*number)))
            .collect();
        self.scene.with_values(&texts)
    }

    /// Opens the design with these numbers.
    ///
    /// # Errors
    /// Returns an error if the numbers do not give a valid scene, or if the new scene has other
    /// elements or does not assemble as the given one does.
    pub fn open(&self, numbers: &[f64]) -> Result<Design, NoDesign> {
        let scene = self.parse(numbers)?;
        match self.solver_for(&scene.mechanism) {
            Ok((solver, is_held)) => Ok(Design {
                scene,
                solver,
                is_held,
            }),
            Err(fault) => Err(NoDesign::Unsolved(Box::new(scene), Box::new(fault))),
        }
    }

    /// Parses the scene of the design with these numbers. Its elements are those of the given scene,
    /// whose ids and quantities therefore apply to it.
    fn parse(&self, numbers: &[f64]) -> Result<Scene, NoDesign> {
        let scene = Scene::parse(&self.text(numbers), self.scene.origin());
        let scene = scene.map_err(|faults| NoDesign::Unread(Box::new(faults)))?;
        match scene.has_elements_of(&self.scene) {
            true => Ok(scene),
            false => Err(NoDesign::OtherElements),
        }
    }

    /// Returns the solver of a design's mechanism in the assembly of the given scene, and whether
    /// the mechanism alone would open in another one.
    fn solver_for(&self, mechanism: &Mechanism) -> Result<(Solver, bool), Fault> {
        self.solver
            .with_dimensions(self.comparison_coordinate(mechanism), mechanism)
    }

    /// Returns the driver coordinate at which the assembly is compared: the design's start if the
    /// given scene reaches it, or else the given scene's start.
    fn comparison_coordinate(&self, mechanism: &Mechanism) -> f64 {
        let [there, here] = [mechanism, &self.scene.mechanism].map(|of| of.driver().start);
        let mut state = self.solver.state();
        let gets_there = there == here
            || self.solver.solve(there, Order::Position, &mut state) != Condition::NoAssembly;
        if gets_there { there } else { here }
    }
}

impl Design {
    /// Returns `true` if the motion is of the same kind as that of another solver. Both must have
    /// the same period, or both must have limits. Both must also stop at the same ends of the same
    /// limits.
    #[must_use]
    pub fn moves_like(&self, other: &Solver) -> bool {
        let stops = |motion: &Motion| {
            let stop = |stop: &EndStop| (stop.limit, stop.end);
            motion.stops.iter().map(stop).collect::<Vec<_>>()
        };
        let (own, other) = (self.solver.motion(), other.motion());
        let ends_alike = match (own.range, other.range) {
            (Range::Full { period: own }, Range::Full { period: other }) => own == other,
            (Range::Limited { .. }, Range::Limited { .. }) => true,
            (Range::Full { .. }, Range::Limited { .. })
            | (Range::Limited { .. }, Range::Full { .. }) => false,
        };
        ends_alike && stops(own) == stops(other)
    }
}

impl NoDesign {
    /// Returns the reason in one line.
    #[must_use]
    pub fn reason(&self) -> String {
        match self {
            NoDesign::Unread(faults) => faults.first_words().to_owned(),
            NoDesign::OtherElements => words().design_has_other_elements().to_owned(),
            NoDesign::Unsolved(scene, fault) => scene.explain(fault).first_words().to_owned(),
        }
    }
}
