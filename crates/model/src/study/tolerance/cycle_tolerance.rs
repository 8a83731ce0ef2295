//! Tolerance analysis of cycle figures, such as a stroke or a time ratio.
//!
//! Each machine is opened and its motion followed. Derivatives are two-sided differences with a
//! hundredth of each tolerance, because the figures are accurate to their last digits.

use super::machines::{CornerEffort, Machines, of_all_corners, of_derivatives, tolerance_effects};
use super::tolerance_box::ToleranceBox;
use super::worst_case::WorstCase;
use super::{SampleOrder, Samples, ToleranceError, ToleranceFigure};
use crate::quantity::demand;
use crate::solver::{Demand, LoopKind, Solver, Varied};
use crate::study::excursion::FigureSeams;
use crate::study::{CycleFigure, CycleFigures};
use crate::{Length, Mechanism, Tolerances};

/// Maximum number of lengths with all corners opened: some thousand machines, each of which is
/// followed.
const MAX_LENGTHS: usize = 12;
const EFFORT: CornerEffort = CornerEffort {
    middles: 7,
    tries: 20,
    edges: false,
    rays: 3,
};
/// Step of differences, relative to a tolerance.
const DIFFERENCE: f64 = 0.01;

/// Cycle figures of a mechanism with deviating lengths.
#[derive(Clone, Debug)]
pub struct MotionTolerance {
    machines: MachinesInMotion,
    off: ToleranceBox,
}

/// Opens machines, and follows their motion.
#[derive(Clone, Debug)]
struct MachinesInMotion {
    figures: CycleFigures,
    seams: FigureSeams,
    solver: Solver,
    /// The lengths to change in place, if the linkage is not redundant.
    varied: Varied,
    given: Vec<Length>,
}

impl MotionTolerance {
    /// Creates an analysis of figures of a solver's mechanism.
    ///
    /// # Errors
    /// Returns an error if an analysis is impossible, see [`ToleranceError`].
    pub fn new(
        solver: &Solver,
        tolerances: &Tolerances,
        figures: Vec<CycleFigure>,
    ) -> Result<MotionTolerance, ToleranceError> {
        let off = ToleranceBox::new(tolerances).ok_or(ToleranceError::Exact)?;
        if figures.iter().any(CycleFigure::is_of_forces) {
            return Err(ToleranceError::Forces);
        }
        let varied = solver.varied(&off.given, &needed(solver.mechanism(), &figures));
        let figures = CycleFigures::new(figures, None);
        let machines = MachinesInMotion {
            seams: FigureSeams::of(&figures, solver),
            figures,
            solver: solver.clone(),
            varied: varied.ok_or(ToleranceError::Redundant)?,
            given: off.given.clone(),
        };
        Ok(MotionTolerance { machines, off })
    }

    /// Returns the analysed figures.
    #[must_use]
    pub fn figures(&self) -> &[CycleFigure] {
        self.machines.figures.figures()
    }

    /// Analyses every figure; `None` for one that does not exist.
    pub fn found(&mut self) -> Vec<Option<ToleranceFigure>> {
        let nominal = self.nominal();
        let slopes = self.slopes();
        let worst = self.worst(&nominal, &slopes);
        tolerance_effects(&self.off, &nominal, worst, |i| slopes[i].as_deref())
    }

    /// Builds random machines, and evaluates every figure of each.
    pub fn sampled(&mut self, order: SampleOrder) -> Samples {
        let count = self.nominal().len();
        let kind = self.machines.kind();
        Samples::of(&mut self.machines, &self.off, count, kind, order)
    }

    /// Returns the figures with the nominal lengths.
    fn nominal(&mut self) -> Vec<Option<f64>> {
        let mut nominal = vec![None; self.figures().len()];
        self.machines.make(&self.off.nothing(), &mut nominal);
        nominal
    }

    /// Returns the derivatives of each figure by all deviations; `None` if one does not exist.
    fn slopes(&mut self) -> Vec<Option<Vec<f64>>> {
        let mut slopes: Vec<Option<Vec<f64>>> = vec![Some(Vec::new()); self.figures().len()];
        for number in 0..self.off.limits.len() {
            let by = DIFFERENCE * self.off.limits[number];
            let sides = [by, -by].map(|by| {
                let mut all = self.off.nothing();
                all[number] = by;
                let mut values = vec![None; self.figures().len()];
                self.machines.make(&all, &mut values);
                values
            });
            for (i, slopes) in slopes.iter_mut().enumerate() {
                let value = |side: &Vec<Option<f64>>| side.get(i).copied().flatten();
                match (value(&sides[0]), value(&sides[1]), slopes.as_mut()) {
                    (Some(above), Some(below), Some(slopes)) => {
                        slopes.push((above - below) / (2.0 * by));
                    }
                    _ => *slopes = None,
                }
            }
        }
        slopes
    }

    /// Computes the worst case of every figure: by all corners if they are few, or else by the
    /// derivatives.
    fn worst(
        &mut self,
        nominal: &[Option<f64>],
        slopes: &[Option<Vec<f64>>],
    ) -> Vec<Option<WorstCase>> {
        let complete: Vec<usize> = (0..self.off.lengths).collect();
        // A full range does not depend on any length to first order, but may become limited with
        // another length.
        let acting = complete.iter().copied();
        let acting: Vec<usize> = acting
            .filter(|&i| self.machines.varied.follows(i))
            .collect();
        let (machines, off) = (&mut self.machines, &self.off);
        if acting.len() <= MAX_LENGTHS && !off.has_pins() {
            return of_all_corners(machines, off, &acting, nominal, EFFORT);
        }
        let figures = slopes.iter().enumerate();
        let worst = figures.map(|(i, slopes)| {
            of_derivatives(machines, off, &complete, i, nominal, slopes.as_deref()?)
        });
        worst.collect()
    }
}

impl MachinesInMotion {
    /// Opens a machine with these deviations; `None` if it does not assemble like the nominal one.
    fn opened(&mut self, by: &[f64]) -> Option<Solver> {
        let off = self.given.iter().copied().zip(by.iter().copied());
        let off = off.filter(|(_, by)| *by != 0.0);
        let mechanism = self.solver.mechanism().all_changed(off);
        self.varied.change(by);
        self.varied.plain(&mechanism).or_else(|| {
            let at = mechanism.driver().start;
            Some(self.solver.with_dimensions(at, &mechanism).ok()?.0)
        })
    }
}

impl Machines for MachinesInMotion {
    fn make(&mut self, by: &[f64], values: &mut [Option<f64>]) -> bool {
        values.fill(None);
        let Some(solver) = self.opened(by) else {
            return false;
        };
        let mut found = self.figures.of(&solver);
        self.seams.count(&mut found);
        let found = found.into_iter().map(Result::ok);
        values
            .iter_mut()
            .zip(found)
            .for_each(|(value, found)| *value = found);
        true
    }

    fn kind(&self) -> Option<LoopKind> {
        self.varied.kind()
    }
}

/// Returns the parts that the motion and these figures depend on: the pins and the queried parts,
/// but not centres of mass.
fn needed(mechanism: &Mechanism, figures: &[CycleFigure]) -> Demand {
    let (mut needed, _) = demand(figures.iter().filter_map(CycleFigure::column));
    needed.links = mechanism.link_ids().collect();
    needed.slides = mechanism.slide_ids().collect();
    let pins = needed.links.iter().flat_map(|&link| mechanism.pins(link));
    needed.points.extend(pins.collect::<Vec<_>>());
    needed
}
