//! Figures of the cycle of many designs.

use super::{Design, DesignSpace, NoDesign};
use crate::quantity::Catalogue;
use crate::scene::{Measure, Scene, Value};
use crate::solver::{Demand, Solver, Varied};
use crate::study::excursion::FigureSeams;
use crate::study::{CycleFigure, CycleFigures, NoFigure};
use crate::{Length, Mechanism};

/// Finds figures of the cycle of one design after the other: in place where a design differs in lengths alone and its
/// driver turns fully, far from any limit; otherwise it is opened as any scene is.
#[derive(Clone, Debug)]
pub struct DesignFigures {
    space: DesignSpace,
    figures: CycleFigures,
    seams: FigureSeams,
    names: Vec<String>,
    /// Whether a figure is made of others by a formula, which may have the numbers of a design in it.
    has_formulas: bool,
    quick: Option<QuickDesigns>,
}

/// Lengths that are changed in place.
#[derive(Clone, Debug)]
struct QuickDesigns {
    lengths: Vec<Length>,
    varied: Varied,
    /// For each value that varies the length that it is, where every one is a length of the mechanism and nothing
    /// else follows from it: then the text need not be read.
    plain: Option<Vec<usize>>,
}

/// By which part of itself, and at least, a value is changed to see what follows from it.
const PROBE: f64 = 1.0 / 64.0;
/// What is left of the change may be off by this part of it: rounding.
const SAME: f64 = 1e-9;

impl DesignFigures {
    /// Of figures of the scene that a space is of; `dwell` is the tolerance of dwells.
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

    /// The figures, in their order.
    #[must_use]
    pub fn figures(&self) -> &[CycleFigure] {
        self.figures.figures()
    }

    /// The space whose designs they are of.
    #[must_use]
    pub fn space(&self) -> &DesignSpace {
        &self.space
    }

    /// The figures of the design with these numbers, each or why there is none.
    ///
    /// # Errors
    /// Where there is no such design.
    pub fn of(&mut self, numbers: &[f64]) -> Result<Vec<Result<f64, NoFigure>>, NoDesign> {
        if let Some(found) = self.quickly(numbers) {
            return Ok(found);
        }
        let design = self.space.open(numbers)?;
        Ok(self.of_design(&design))
    }

    /// The same beside those of other designs: directions, and places in a motion that comes round, are counted from
    /// those of the given one, so that they do not jump by a turn from design to design.
    ///
    /// # Errors
    /// Where there is no such design.
    pub fn in_row(&mut self, numbers: &[f64]) -> Result<Vec<Result<f64, NoFigure>>, NoDesign> {
        let mut found = self.of(numbers)?;
        self.seams.count(&mut found);
        Ok(found)
    }

    /// The figures of a design that has been opened.
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
            // The names were read once before, of a scene of the same names.
            Err(_) => self.figures.of(solver),
        }
    }

    pub(super) fn cycle_figures(&self) -> &CycleFigures {
        &self.figures
    }

    /// The solver of a design that is changed in place and whose numbers are lengths, and which each of them is.
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

/// The mechanism with these numbers for its lengths; `None` of a length that the text would be refused for.
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

/// Which of the lengths a value is, if it is one and no more: found by changing it.
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
