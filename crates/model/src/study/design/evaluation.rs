//! Computes cycle figures of many designs.

use super::{Design, DesignSpace, NoDesign};
use crate::quantity::Catalogue;
use crate::scene::{Measure, Scene, Value};
use crate::solver::{Demand, Solver, Varied};
use crate::study::excursion::FigureSeams;
use crate::study::{CycleFigure, CycleFigures, NoFigure};
use crate::{Length, Mechanism};

/// Computes cycle figures of one design after another. A design is changed in place if it differs
/// in lengths alone, and if its driver turns fully and far from any limit. Any other design is
/// opened like any scene.
#[derive(Clone, Debug)]
pub struct DesignFigures {
    space: DesignSpace,
    figures: CycleFigures,
    seams: FigureSeams,
    names: Vec<String>,
    /// `true` if a formula derives a figure from others; the formula may contain a design's
    /// numbers.
    has_formulas: bool,
    quick: Option<QuickDesigns>,
}

/// Lengths that can be changed in place.
#[derive(Clone, Debug)]
struct QuickDesigns {
    lengths: Vec<Length>,
    varied: Varied,
    /// For each variable value the index of its length. `None` if a value is not a length, or if
    /// other quantities depend on it. If present, the text need not be parsed.
    plain: Option<Vec<usize>>,
}

/// The relative change of a value that shows which quantities depend on it; absolute for values
/// below 1.
const PROBE: f64 = 1.0 / 64.0;
/// Tolerance for the change found, relative to the change made: rounding error.
const SAME: f64 = 1e-9;

impl DesignFigures {
    /// Creates an evaluator for figures of the scene of a design space; `dwell` is the tolerance of
    /// dwells.
    #[must_use]
    pub fn new(
        space: &DesignSpace,
        figures: Vec<CycleFigure>,
        dwell: Option<f64>,
    ) -> DesignFigures {
        let names = figures
            .iter()
            .map(|figure| figure.name().to_owned())
            .collect();
        let has_forces = figures.iter().any(CycleFigure::is_of_forces);
        let has_formulas = figures.iter().any(CycleFigure::is_derived);
        let figures = CycleFigures::new(figures, dwell);
        DesignFigures {
            seams: FigureSeams::of(&figures, space.solver()),
            quick: QuickDesigns::new(space).filter(|_| !has_forces),
            names,
            has_formulas,
            figures,
            space: space.clone(),
        }
    }

    /// Returns the figures, in their order.
    #[must_use]
    pub fn figures(&self) -> &[CycleFigure] {
        self.figures.figures()
    }

    /// Returns the space of the designs.
    #[must_use]
    pub fn space(&self) -> &DesignSpace {
        &self.space
    }

    /// Computes the figures of the design with these numbers; each is a value, or the reason for
    /// its absence.
    ///
    /// # Errors
    /// Returns an error if there is no such design.
    pub fn of(&mut self, numbers: &[f64]) -> Result<Vec<Result<f64, NoFigure>>, NoDesign> {
        if let Some(found) = self.quickly(numbers) {
            return Ok(found);
        }
        let design = self.space.open(numbers)?;
        Ok(self.of_design(&design))
    }

    /// Computes the figures of a design for a comparison with other designs. Directions, and places
    /// in a cyclic motion, are counted from those of the given design, so that they do not jump by
    /// a turn between designs.
    ///
    /// # Errors
    /// Returns an error if there is no such design.
    pub fn in_row(&mut self, numbers: &[f64]) -> Result<Vec<Result<f64, NoFigure>>, NoDesign> {
        let mut found = self.of(numbers)?;
        self.seams.count(&mut found);
        Ok(found)
    }

    /// Computes the figures of an opened design.
    #[must_use]
    pub fn of_design(&self, design: &Design) -> Vec<Result<f64, NoFigure>> {
        self.of_solver(&design.scene, &design.solver)
    }

    fn of_solver(&self, scene: &Scene, solver: &Solver) -> Vec<Result<f64, NoFigure>> {
        if !self.has_formulas {
            return self.figures.of(solver);
        }
        let catalogue = Catalogue::new(scene);
        let again = self
            .names
            .iter()
            .map(|name| CycleFigure::parse(name, &catalogue));
        match again.collect::<Result<Vec<_>, _>>() {
            Ok(figures) => self.figures.again(figures).of(solver),
            // Unreachable in practice: the names were parsed before, for a scene with the same
            // names.
            Err(_) => self.figures.of(solver),
        }
    }

    pub(super) fn cycle_figures(&self) -> &CycleFigures {
        &self.figures
    }

    /// Returns the solver of a design changed in place and the length of each number; `None` if the
    /// design cannot be changed in place.
    pub(super) fn in_place(&mut self, numbers: &[f64]) -> Option<(Solver, Vec<Length>)> {
        let quick = self.quick.as_mut().filter(|_| !self.has_formulas)?;
        let plain = quick.plain.as_ref()?;
        let mechanism = plainly_changed(&self.space, plain, &quick.lengths, numbers)?;
        let lengths = plain.iter().map(|&length| quick.lengths[length]).collect();
        let solver = quick.solver(self.space.solver().mechanism(), &mechanism)?;
        Some((solver, lengths))
    }

    pub(super) fn quickly(&mut self, numbers: &[f64]) -> Option<Vec<Result<f64, NoFigure>>> {
        let quick = self.quick.as_mut()?;
        if let Some(plain) = quick.plain.as_ref().filter(|_| !self.has_formulas) {
            let mechanism = plainly_changed(&self.space, plain, &quick.lengths, numbers)?;
            let solver = quick.solver(self.space.solver().mechanism(), &mechanism)?;
            return Some(self.figures.of(&solver));
        }
        let text = self.space.text(numbers);
        let scene = self.space.scene().again(&text)?;
        let solver = quick.solver(self.space.solver().mechanism(), &scene.mechanism)?;
        Some(self.of_solver(&scene, &solver))
    }
}

/// Returns the mechanism with these numbers as its lengths; `None` if a length would be rejected in
/// the text.
fn plainly_changed(
    space: &DesignSpace,
    plain: &[usize],
    lengths: &[Length],
    numbers: &[f64],
) -> Option<Mechanism> {
    let mut mechanism = space.solver().mechanism().clone();
    for ((value, &length), &number) in space.values().iter().zip(plain).zip(numbers) {
        let is_read = number > 0.0 || value.measure == Measure::Coordinate;
        if !is_read || !number.is_finite() {
            return None;
        }
        mechanism = mechanism.changed(lengths[length], number - value.number);
    }
    Some(mechanism)
}

impl QuickDesigns {
    fn new(space: &DesignSpace) -> Option<QuickDesigns> {
        let (solver, scene) = (space.solver(), space.scene());
        let mechanism = &scene.mechanism;
        let lengths = mechanism.lengths();
        let varied = solver.varied(&lengths, &Demand::of_motion(mechanism))?;
        let values = space.values().iter();
        let plain = values.map(|value| length_of(value, scene, &lengths));
        Some(QuickDesigns {
            plain: plain.collect(),
            lengths,
            varied,
        })
    }

    fn solver(&mut self, given: &Mechanism, design: &Mechanism) -> Option<Solver> {
        let by = given.longer(design, &self.lengths)?;
        self.varied.change(&by);
        self.varied.plain(design)
    }
}

/// Returns the index of the length that a value sets; `None` if it sets none or more than that.
/// Determined by changing the value.
fn length_of(value: &Value, scene: &Scene, lengths: &[Length]) -> Option<usize> {
    let is_plain =
        value.formula.is_none() && matches!(value.measure, Measure::Length | Measure::Coordinate);
    if !is_plain {
        return None;
    }
    let by = PROBE * value.number.abs().max(1.0);
    let text = scene.with_value(value, &value.with_number(value.number + by));
    let other = scene.again(&text)?;
    let changes = scene.mechanism.longer(&other.mechanism, lengths)?;
    let mut changed = changes.iter().enumerate().filter(|(_, by)| **by != 0.0);
    let (length, &found) = changed.next()?;
    let is_all = changed.next().is_none() && (found - by).abs() <= SAME * by;
    is_all.then_some(length)
}
