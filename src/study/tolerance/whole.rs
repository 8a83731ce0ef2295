//! Tolerances of figures of the whole motion: a stroke, a time ratio.
//!
//! Each machine is opened as it was made, and followed. Derivatives are differences, of figures that are good to their
//! last digits: a hundredth of each tolerance to both sides.

use super::machines::{CornerEffort, Machines, of_all_corners, of_derivatives, told};
use super::tolerance_box::ToleranceBox;
use super::worst::WorstCase;
use super::{NoTolerance, SampleOrder, Samples, ToleranceFigure};
use crate::quantity::demand;
use crate::solver::{Demand, LoopKind, Solver, Varied};
use crate::study::excursion::FigureSeams;
use crate::study::{CycleFigure, CycleFigures};
use crate::{Length, Mechanism, Tolerances};

/// So many lengths have all their corners opened: some thousand machines, each of which is followed.
const MOST_LENGTHS: usize = 12;
const EFFORT: CornerEffort = CornerEffort {
    middles: 7,
    tries: 20,
    edges: false,
    rays: 3,
};
/// The part of a tolerance by which differences are taken.
const DIFFERENCE: f64 = 0.01;

/// Figures of the whole motion of a mechanism whose lengths are off.
#[derive(Clone, Debug)]
pub struct WholeTolerance {
    machines: MachinesInMotion,
    off: ToleranceBox,
}

/// Opens machines, and follows figures over their motion.
#[derive(Clone, Debug)]
struct MachinesInMotion {
    figures: CycleFigures,
    seams: FigureSeams,
    solver: Solver,
    /// The lengths in place, where nothing is redundant.
    varied: Varied,
    given: Vec<Length>,
}

impl WholeTolerance {
    /// Of these figures of a solver's mechanism.
    ///
    /// # Errors
    /// Where there is nothing to say, see [`NoTolerance`].
    pub fn new(
        solver: &Solver,
        tolerances: &Tolerances,
        figures: Vec<CycleFigure>,
    ) -> Result<WholeTolerance, NoTolerance> {
        let off = ToleranceBox::new(tolerances).ok_or(NoTolerance::Exact)?;
        if figures.iter().any(CycleFigure::is_of_forces) {
            return Err(NoTolerance::Forces);
        }
        let varied = solver.varied(&off.given, &needed(solver.mechanism(), &figures));
        let figures = CycleFigures::new(figures, None);
        let machines = MachinesInMotion {
            seams: FigureSeams::of(&figures, solver),
            figures,
            solver: solver.clone(),
            varied: varied.ok_or(NoTolerance::Redundant)?,
            given: off.given.clone(),
        };
        Ok(WholeTolerance { machines, off })
    }

    /// The figures that are asked about.
    #[must_use]
    pub fn figures(&self) -> &[CycleFigure] {
        self.machines.figures.figures()
    }

    /// What tolerances do to every figure; `None` for one that does not exist.
    pub fn found(&mut self) -> Vec<Option<ToleranceFigure>> {
        let nominal = self.nominal();
        let slopes = self.slopes();
        let worst = self.worst(&nominal, &slopes);
        told(&self.off, &nominal, worst, |i| slopes[i].as_deref())
    }

    /// Makes machines by chance, and reads every figure of each.
    pub fn sampled(&mut self, order: SampleOrder) -> Samples {
        let figures = self.nominal().len();
        let kind = self.machines.kind();
        Samples::of(&mut self.machines, &self.off, figures, kind, order)
    }

    /// The figures with the lengths as they were given.
    fn nominal(&mut self) -> Vec<Option<f64>> {
        let mut nominal = vec![None; self.figures().len()];
        self.machines.make(&self.off.nothing(), &mut nominal);
        nominal
    }

    /// Figure by figure the derivatives by everything that is off; `None` where one does not exist.
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

    /// The worst case of every figure: every corner where they are few, else what the derivatives point to.
    fn worst(
        &mut self,
        nominal: &[Option<f64>],
        slopes: &[Option<Vec<f64>>],
    ) -> Vec<Option<WorstCase>> {
        let whole: Vec<usize> = (0..self.off.lengths).collect();
        // A range that is whole follows no length at the first order, and may still end with another.
        let acting = whole.iter().copied();
        let acting: Vec<usize> = acting
            .filter(|&i| self.machines.varied.follows(i))
            .collect();
        let (machines, off) = (&mut self.machines, &self.off);
        if acting.len() <= MOST_LENGTHS && !off.has_pins() {
            return of_all_corners(machines, off, &acting, nominal, EFFORT);
        }
        let figures = slopes.iter().enumerate();
        let worst = figures.map(|(i, slopes)| {
            of_derivatives(machines, off, &whole, i, nominal, slopes.as_deref()?)
        });
        worst.collect()
    }
}

impl MachinesInMotion {
    /// A machine that was made so; `None` where it does not assemble as it is meant to.
    fn opened(&mut self, by: &[f64]) -> Option<Solver> {
        let off = self.given.iter().zip(by).filter(|(_, by)| **by != 0.0);
        let mechanism = self.solver.mechanism().clone();
        let mechanism = off.fold(mechanism, |made, (&length, &by)| made.changed(length, by));
        self.varied.change(by);
        self.varied.plain(&mechanism).or_else(|| {
            let at = mechanism.driver().start;
            Some(self.solver.kept(at, &mechanism).ok()?.0)
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

/// What the motion and these figures hang on: the pins, and what is asked about; not where a centre of mass lies.
fn needed(mechanism: &Mechanism, figures: &[CycleFigure]) -> Demand {
    let (mut needed, _) = demand(figures.iter().filter_map(CycleFigure::column));
    needed.links = mechanism.link_ids().collect();
    needed.slides = mechanism.slide_ids().collect();
    let pins = needed.links.iter().flat_map(|&link| mechanism.pins(link));
    needed.points.extend(pins.collect::<Vec<_>>());
    needed
}
