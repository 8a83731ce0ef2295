//! Computes cycle figures of many designs.

use super::lengths::DesignLengths;
use super::{Design, DesignSpace, NoDesign};
use crate::quantity::Catalogue;
use crate::scene::Scene;
use crate::solver::{Demand, Fault, Solver, Varied};
use crate::study::excursion::{EvaluatedFigures, FigurePieces, FigureSeams};
use crate::study::{CycleFigure, CycleFigures, NoFigure};
use crate::{Length, Mechanism};
use std::sync::Arc;

/// Computes cycle figures of one design after another. A design whose numbers change lengths alone
/// is computed without parsing its text. Its solver is changed in place if its driver turns fully
/// and far from any limit. Any other design is opened like any scene.
#[derive(Clone, Debug)]
pub struct DesignFigures {
    space: Arc<DesignSpace>,
    figures: FigureSet,
    seams: FigureSeams,
    quick: Option<QuickDesigns>,
}

/// Cycle figures by their names.
#[derive(Clone, Debug)]
pub(super) struct FigureSet {
    pub(super) figures: CycleFigures,
    /// `true` if a formula derives a figure from others; the formula may contain a design's
    /// numbers.
    has_formulas: bool,
}

/// A design that was opened for its figures.
#[derive(Clone, Debug)]
pub(super) struct OpenedDesign {
    /// The scene; `None` if it was not parsed, because no figure needs it.
    scene: Option<Box<Scene>>,
    solver: Solver,
    /// `true` if the solver was changed in place.
    is_in_place: bool,
}

/// The reason why a design was not opened.
#[derive(Clone, Debug)]
pub(super) enum Unopened {
    Unread(NoDesign),
    /// The scene is `None` if it was not parsed.
    Unsolved(Option<Box<Scene>>, Box<Fault>),
}

/// Designs with other lengths.
#[derive(Clone, Debug)]
struct QuickDesigns {
    lengths: Vec<Length>,
    varied: Varied,
    /// The lengths of a design; `None` if they follow from its text alone.
    plain: Option<DesignLengths>,
}

impl FigureSet {
    /// Creates a set; `dwell` is the tolerance of dwells.
    fn new(figures: Vec<CycleFigure>, dwell: Option<f64>) -> FigureSet {
        FigureSet {
            has_formulas: figures.iter().any(CycleFigure::is_derived),
            figures: CycleFigures::new(figures, dwell),
        }
    }

    /// Computes the figures, and their places for a design that was changed in place.
    pub(super) fn evaluate(&self, design: &OpenedDesign) -> EvaluatedFigures {
        match &design.scene {
            None if design.is_in_place => self.figures.evaluate(&design.solver),
            scene => EvaluatedFigures {
                values: self.of_solver(scene.as_deref(), &design.solver),
                places: None,
            },
        }
    }

    /// Computes the pieces of the figures of a design that was changed in place.
    pub(super) fn pieces(&self, design: &OpenedDesign) -> Option<Vec<FigurePieces>> {
        let is_plain = design.scene.is_none() && design.is_in_place;
        is_plain
            .then(|| self.figures.pieces(&design.solver))
            .flatten()
    }

    fn of_solver(&self, scene: Option<&Scene>, solver: &Solver) -> Vec<Result<f64, NoFigure>> {
        let Some(scene) = scene.filter(|_| self.has_formulas) else {
            return self.figures.of(solver);
        };
        let catalogue = Catalogue::new(scene);
        let names = self.figures.figures().iter().map(CycleFigure::name);
        let again = names.map(|name| CycleFigure::parse(name, &catalogue));
        match again.collect::<Result<Vec<_>, _>>() {
            Ok(figures) => self.figures.with_figures(figures).of(solver),
            // Unreachable in practice: the names were parsed before, for a scene with the same
            // names.
            Err(_) => self.figures.of(solver),
        }
    }

    /// Returns a set of some of the figures, by their indices.
    pub(super) fn subset(&self, indices: &[usize]) -> FigureSet {
        let all = self.figures.figures();
        let figures: Vec<CycleFigure> = indices.iter().map(|&i| all[i].clone()).collect();
        FigureSet {
            has_formulas: figures.iter().any(CycleFigure::is_derived),
            figures: self.figures.with_figures(figures),
        }
    }
}

impl DesignFigures {
    /// Creates an evaluator for figures of the scene of a design space; `dwell` is the tolerance of
    /// dwells.
    #[must_use]
    pub fn new(
        space: &DesignSpace,
        figures: Vec<CycleFigure>,
        dwell: Option<f64>,
    ) -> DesignFigures {
        let has_forces = figures.iter().any(CycleFigure::is_of_forces);
        let figures = FigureSet::new(figures, dwell);
        let quick = (!has_forces).then(|| QuickDesigns::new(space, figures.has_formulas));
        DesignFigures {
            seams: FigureSeams::of(&figures.figures, space.solver()),
            quick: quick.flatten(),
            figures,
            space: Arc::new(space.clone()),
        }
    }

    /// Returns the figures, in their order.
    #[must_use]
    pub fn figures(&self) -> &[CycleFigure] {
        self.figures.figures.figures()
    }

    /// Returns the space of the designs.
    #[must_use]
    pub fn space(&self) -> &DesignSpace {
        &self.space
    }

    /// Returns the figures as a set.
    pub(super) fn set(&self) -> &FigureSet {
        &self.figures
    }

    /// Computes the figures of the design with these numbers; each is a value, or the reason for
    /// its absence.
    ///
    /// # Errors
    /// Returns an error if there is no such design.
    pub fn of(&mut self, numbers: &[f64]) -> Result<Vec<Result<f64, NoFigure>>, NoDesign> {
        match self.open(numbers) {
            Ok(design) => Ok(self.figures.evaluate(&design).values),
            Err(why) => Err(self.explain(numbers, why)),
        }
    }

    /// Computes the figures of a design and their places; `None` if there is no such design.
    pub(super) fn evaluate(&mut self, numbers: &[f64]) -> Option<EvaluatedFigures> {
        let design = self.open(numbers).ok()?;
        Some(self.figures.evaluate(&design))
    }

    /// Returns the reason with the scene that explains it.
    fn explain(&self, numbers: &[f64], why: Unopened) -> NoDesign {
        match why {
            Unopened::Unread(why) => why,
            Unopened::Unsolved(Some(scene), fault) => NoDesign::Unsolved(scene, fault),
            Unopened::Unsolved(None, fault) => match self.space.parse(numbers) {
                Ok(scene) => NoDesign::Unsolved(Box::new(scene), fault),
                Err(none) => none,
            },
        }
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
        self.figures.of_solver(Some(&design.scene), &design.solver)
    }

    /// Opens a design for its figures.
    pub(super) fn open(&mut self, numbers: &[f64]) -> Result<OpenedDesign, Unopened> {
        let made = self.mechanism(numbers);
        let scene = match made {
            Some(_) => None,
            None => Some(Box::new(
                self.space.parse(numbers).map_err(Unopened::Unread)?,
            )),
        };
        let parsed = || scene.as_ref().map(|scene| scene.mechanism.clone());
        // One of the two exists.
        let given = self.space.solver().mechanism();
        let mechanism = made.or_else(parsed).unwrap_or_else(|| given.clone());
        let quick = self.quick.as_mut();
        if let Some(solver) = quick.and_then(|quick| quick.solver(given, &mechanism)) {
            return Ok(OpenedDesign {
                scene,
                solver,
                is_in_place: true,
            });
        }
        match self.space.solver_for(&mechanism) {
            Ok((solver, _)) => Ok(OpenedDesign {
                scene,
                solver,
                is_in_place: false,
            }),
            Err(fault) => Err(Unopened::Unsolved(scene, Box::new(fault))),
        }
    }

    /// Returns the mechanism of a design without parsing its text, if that is possible.
    pub(super) fn mechanism(&mut self, numbers: &[f64]) -> Option<Mechanism> {
        let plain = self.quick.as_mut()?.plain.as_mut()?;
        plain.mechanism(&self.space, numbers)
    }

    /// Returns `true` if a design is changed in place: its driver turns fully, far from any limit.
    pub(super) fn is_in_place(&mut self, numbers: &[f64]) -> bool {
        let given = self.space.solver().mechanism().clone();
        let varied = self.varied_to(numbers);
        varied.is_some_and(|varied| varied.plain(&given).is_some())
    }

    /// Returns the mechanism with the lengths of a design. Returns `None` if other values than
    /// lengths follow from its numbers.
    pub(super) fn varied_to(&mut self, numbers: &[f64]) -> Option<&mut Varied> {
        let quick = self.quick.as_mut()?;
        let mut by = vec![0.0; quick.lengths.len()];
        quick.plain.as_mut()?.write_changes(numbers, &mut by)?;
        quick.varied.change(&by);
        Some(&mut quick.varied)
    }

    /// Returns the solver of a design changed in place and the length of each number. Returns
    /// `None` if the design cannot be changed in place, or if a number sets more than one length.
    pub(super) fn in_place(&mut self, numbers: &[f64]) -> Option<(Solver, Vec<Length>)> {
        let lengths = self.quick.as_ref()?.plain.as_ref()?.by_number()?;
        let mechanism = self.mechanism(numbers)?;
        let quick = self.quick.as_mut()?;
        let solver = quick.solver(self.space.solver().mechanism(), &mechanism)?;
        Some((solver, lengths))
    }
}

impl QuickDesigns {
    fn new(space: &DesignSpace, has_formulas: bool) -> Option<QuickDesigns> {
        let (solver, mechanism) = (space.solver(), &space.scene().mechanism);
        let lengths = mechanism.lengths();
        let varied = solver.varied(&lengths, &Demand::of_motion(mechanism))?;
        let plain = (!has_formulas).then(|| DesignLengths::of(space, &lengths));
        Some(QuickDesigns {
            plain: plain.flatten(),
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
