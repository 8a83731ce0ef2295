//! Tolerances of figures of the whole motion: a stroke, a time ratio.
//!
//! Each machine is opened as it was made, and followed. Derivatives are differences, of figures that are good to their
//! last digits: a hundredth of each tolerance to both sides.

use super::box_grid::BoxGrid;
use super::corners::{MetRange, WorstCase, WorstKind};
use super::samples::percentiles;
use super::tolerance_box::ToleranceBox;
use super::{NoTolerance, SampleOrder, Samples, ToleranceFigure};
use crate::numeric::SeededChance;
use crate::quantity::demand;
use crate::solver::{Demand, Solver, Varied};
use crate::study::excursion::FigureSeams;
use crate::study::{CycleFigure, CycleFigures};
use crate::{Mechanism, Tolerances};

/// So many lengths have all their corners opened, and the middles between them: some thousand machines.
const MOST_LENGTHS: usize = 12;
/// The part of a tolerance by which differences are taken.
const DIFFERENCE: f64 = 0.01;

/// Figures of the whole motion of a mechanism whose lengths are off.
#[derive(Clone, Debug)]
pub struct WholeTolerance {
    figures: CycleFigures,
    seams: FigureSeams,
    solver: Solver,
    /// The lengths in place, where nothing is redundant.
    varied: Varied,
    off: ToleranceBox,
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
        Ok(WholeTolerance {
            seams: FigureSeams::of(&figures, solver),
            figures,
            solver: solver.clone(),
            varied: varied.ok_or(NoTolerance::Redundant)?,
            off,
        })
    }

    /// The figures that are asked about.
    #[must_use]
    pub fn figures(&self) -> &[CycleFigure] {
        self.figures.figures()
    }

    /// What tolerances do to every figure; `None` for one that does not exist.
    pub fn found(&mut self) -> Vec<Option<ToleranceFigure>> {
        let nominal = self.made(&self.off.nothing()).unwrap_or_default();
        let slopes = self.slopes();
        let worst = self.worst(&nominal, &slopes);
        let figures = nominal.iter().zip(worst).zip(&slopes);
        let figure = figures.map(|((&nominal, worst), slopes)| {
            let slopes = slopes.as_deref();
            Some(ToleranceFigure {
                nominal: nominal?,
                worst: worst?,
                root_sum_square: slopes.map(|slopes| self.off.root_sum_square(slopes)),
                contributions: slopes
                    .map_or_else(Vec::new, |slopes| self.off.contributions(slopes)),
            })
        });
        figure.collect()
    }

    /// Makes machines by chance, and reads every figure of each.
    pub fn sampled(&mut self, order: SampleOrder) -> Samples {
        let mut chance = SeededChance::new(order.seed);
        let mut by = self.off.nothing();
        let mut read: Vec<Vec<f64>> = vec![Vec::new(); self.figures().len()];
        let kind = self.varied.kind();
        let (mut open, mut changed) = (0_u32, 0_u32);
        for _ in 0..order.count {
            self.off.draw(order.distribution, &mut chance, &mut by);
            let Some(values) = self.made(&by) else {
                open += 1;
                continue;
            };
            changed += u32::from(self.varied.kind() != kind);
            for (all, value) in read.iter_mut().zip(values) {
                all.extend(value);
            }
        }
        let part = |count: u32| f64::from(count) / f64::from(order.count.max(1));
        Samples {
            figures: read.iter_mut().map(|all| percentiles(all)).collect(),
            open: part(open),
            changed: kind.map(|_| part(changed)),
        }
    }

    /// The figures of a machine that was made so; `None` where it does not assemble as it is meant to.
    fn made(&mut self, by: &[f64]) -> Option<Vec<Option<f64>>> {
        let given = self.off.given.iter().zip(by).filter(|(_, by)| **by != 0.0);
        let mechanism = self.solver.mechanism().clone();
        let mechanism = given.fold(mechanism, |made, (&length, &by)| made.changed(length, by));
        self.varied.change(by);
        let solver = match self.varied.plain(&mechanism) {
            Some(solver) => solver,
            None => {
                let at = mechanism.driver().start;
                self.solver.kept(at, &mechanism).ok()?.0
            }
        };
        let mut found = self.figures.of(&solver);
        self.seams.count(&mut found);
        Some(found.into_iter().map(Result::ok).collect())
    }

    /// Figure by figure the derivatives by everything that is off; `None` where one does not exist.
    fn slopes(&mut self) -> Vec<Option<Vec<f64>>> {
        let mut slopes: Vec<Option<Vec<f64>>> = vec![Some(Vec::new()); self.figures().len()];
        for number in 0..self.off.limits.len() {
            let by = DIFFERENCE * self.off.limits[number];
            let sides = [by, -by].map(|by| {
                let mut all = self.off.nothing();
                all[number] = by;
                self.made(&all).unwrap_or_default()
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

    /// The worst case of every figure: every corner where they are few, else the one that the derivatives point to.
    fn worst(
        &mut self,
        nominal: &[Option<f64>],
        slopes: &[Option<Vec<f64>>],
    ) -> Vec<Option<WorstCase>> {
        let whole: Vec<usize> = (0..self.off.lengths).collect();
        // A range that is whole follows no length at the first order, and may still end with another.
        let acting = whole.iter().copied().filter(|&i| self.varied.follows(i));
        let acting: Vec<usize> = acting.collect();
        if acting.len() <= MOST_LENGTHS && !self.off.has_pins() {
            return self.all_corners(nominal, &acting);
        }
        let figures = slopes.iter().enumerate();
        let worst = figures.map(|(i, slopes)| {
            let way = self.off.way(slopes.as_ref()?, &whole);
            let back = way.iter().map(|by| -by).collect();
            self.met(nominal, &[way, back])[i]
        });
        worst.collect()
    }

    fn all_corners(&mut self, nominal: &[Option<f64>], acting: &[usize]) -> Vec<Option<WorstCase>> {
        let grid = BoxGrid::of(acting.len());
        let mut found = vec![Vec::with_capacity(grid.count()); nominal.len()];
        let mut by = self.off.nothing();
        for place in 0..grid.count() {
            grid.fill(place, acting, &self.off.limits, &mut by);
            let values = self.made(&by).unwrap_or_default();
            for (i, found) in found.iter_mut().enumerate() {
                found.push(values.get(i).copied().flatten().unwrap_or(f64::NAN));
            }
        }
        let figures = nominal.iter().zip(&found);
        let worst = figures.map(|(&nominal, found)| {
            let fails = found.iter().any(|value| value.is_nan());
            Some(grid.worst(nominal?, found, fails))
        });
        worst.collect()
    }

    /// What machines have that were made so.
    fn met(&mut self, nominal: &[Option<f64>], made: &[Vec<f64>]) -> Vec<Option<WorstCase>> {
        let mut met: Vec<Option<MetRange>> = nominal
            .iter()
            .map(|value| {
                value.map(|value| MetRange {
                    low: value,
                    high: value,
                })
            })
            .collect();
        let mut fails = vec![false; met.len()];
        for by in made {
            let values = self.made(by).unwrap_or_default();
            for (i, met) in met.iter_mut().enumerate() {
                match (met, values.get(i).copied().flatten()) {
                    (Some(met), Some(value)) => met.meet(value),
                    _ => fails[i] = true,
                }
            }
        }
        let worst = |(met, fails): (Option<MetRange>, bool)| {
            met.map(|MetRange { low, high }| WorstCase {
                low,
                high,
                reached: [low, high],
                kind: WorstKind::Estimated,
                fails,
            })
        };
        met.into_iter().zip(fails).map(worst).collect()
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
