//! How what is not known of one part moves what stands on it, where that is not little.
//!
//! Each constraint of a dyad is a source: its value is off by something unknown below a bound, at each order; so is
//! what else a step places, whatever it stands on. Points and links carry by how much each source before them moves
//! them: rows of the inverse of the whole matrix, which is block triangular, found forwards. Summed in the end over
//! sources by size, they give bounds that do not widen from group to group.
//!
//! Rests are of the second order, but for digits that nobody typed: through a few groups they can widen as they like,
//! and nobody has a row. A row is kept only as long as a later step reads it.

use super::limb::SUM;
use crate::solver::coupled::Coupled;
use crate::solver::demand::PlacedPart;
use crate::solver::elements::Step;
use crate::solver::plan::Program;
use crate::{LinkId, PointId, Vec2};
use std::f64::consts::SQRT_2;

/// By how much each of the first sources moves a point, or in x a link's angle.
#[derive(Clone, Debug, Default)]
struct InfluenceRow {
    x: Vec<f64>,
    y: Vec<f64>,
    len: usize,
}

/// The sources so far, and the rows.
#[derive(Clone, Debug, Default)]
pub(super) struct Influences {
    /// Bounds of the sources, by order.
    bounds: [Vec<f64>; 3],
    known: usize,
    is_long: bool,
    /// The first one stays empty: what stands on no source.
    rows: Vec<InfluenceRow>,
    /// Where the rows of points and links are; the first one of those that have none.
    points: Vec<usize>,
    links: Vec<usize>,
}

/// Dyads through which rests may widen: each can make them ten times as large, and a rest is a rounding of a
/// rounding.
const FEW: usize = 8;

/// How many sources a step has at most.
fn sources(step: &Step, coupled: &[Coupled]) -> usize {
    let mut count = 0;
    step.outputs(coupled, &mut |part| {
        count += match part {
            PlacedPart::Point(_) => 2,
            PlacedPart::Link(_) => 1,
            PlacedPart::Slide(_) => 0,
        }
    });
    count
}

/// Whether a step makes rows of rows.
fn reads_rows(step: &Step) -> bool {
    matches!(
        step,
        Step::Circles(_) | Step::CircleRail(_) | Step::Ride(_) | Step::Aim(_) | Step::Lock(_)
    )
}

/// Whether what a step places has rows.
fn writes_rows(step: &Step) -> bool {
    !matches!(step, Step::Crank(_) | Step::Spin(_) | Step::SlideReadout(_))
}

/// Who has a row: joints of dyads, and what these stand on. Of the rest, which nothing stands on, the
/// bounds may add up at once.
struct Needed {
    points: Vec<bool>,
    links: Vec<bool>,
}

impl Needed {
    fn of(program: &Program) -> Needed {
        let mut needed = Needed {
            points: vec![false; program.points.len()],
            links: vec![false; program.links.len()],
        };
        for step in program.steps.iter().rev() {
            let joint = match step {
                Step::Circles(c) => Some(c.point),
                Step::CircleRail(c) => Some(c.point),
                _ => None,
            };
            if let Some(joint) = joint {
                needed.points[joint.index()] = true;
            }
            let mut is_needed = false;
            step.outputs(&program.coupled, &mut |part| {
                is_needed |= needed.has(part);
            });
            if is_needed && reads_rows(step) {
                step.inputs(&program.coupled, &mut |part| match part {
                    PlacedPart::Point(point) => needed.points[point.index()] = true,
                    PlacedPart::Link(link) => needed.links[link.index()] = true,
                    PlacedPart::Slide(_) => {}
                });
            }
        }
        needed
    }

    fn has(&self, part: PlacedPart) -> bool {
        match part {
            PlacedPart::Point(point) => self.points[point.index()],
            PlacedPart::Link(link) => self.links[link.index()],
            PlacedPart::Slide(_) => false,
        }
    }
}

/// A weighted sum of sizes. What is not bounded does not reach what does not stand on it.
fn summed(row: &[f64], bounds: &[f64]) -> f64 {
    let terms = row.iter().zip(bounds);
    let term = |(v, b): (&f64, &f64)| if *v == 0.0 { 0.0 } else { v.abs() * b };
    terms.map(term).sum()
}

impl InfluenceRow {
    fn of(sources: usize) -> InfluenceRow {
        InfluenceRow {
            x: vec![0.0; sources],
            y: vec![0.0; sources],
            len: 0,
        }
    }

    fn clear(&mut self, len: usize) {
        self.x[..len].fill(0.0);
        self.y[..len].fill(0.0);
        self.len = len;
    }

    /// Adds M row, M by its columns.
    #[inline(always)]
    fn add(&mut self, row: &InfluenceRow, [first, second]: [Vec2; 2]) {
        let from = row.x[..row.len].iter().zip(&row.y[..row.len]);
        let to = self.x.iter_mut().zip(&mut self.y);
        for ((tx, ty), (x, y)) in to.zip(from) {
            *tx += first.x * x + second.x * y;
            *ty += first.y * x + second.y * y;
        }
    }

    /// Adds g . row to x.
    #[inline(always)]
    fn add_across(&mut self, row: &InfluenceRow, g: Vec2) {
        let from = row.x[..row.len].iter().zip(&row.y[..row.len]);
        for (to, (x, y)) in self.x.iter_mut().zip(from) {
            *to += g.x * x + g.y * y;
        }
    }
}

impl Influences {
    /// Room for the sources and rows of a program.
    pub(super) fn new(program: &Program) -> Influences {
        let counts = program
            .steps
            .iter()
            .map(|step| sources(step, &program.coupled));
        let sources = counts.sum();
        let dyads = program.steps.iter().filter(|step| step.dyad().is_some());
        let is_long = dyads.count() > FEW;
        let mut influences = Influences {
            is_long,
            bounds: std::array::from_fn(|_| vec![0.0; sources]),
            known: 0,
            rows: vec![InfluenceRow::default()],
            points: vec![0; program.points.len()],
            links: vec![0; program.links.len()],
        };
        if is_long {
            influences.share_rows(program, sources);
        }
        influences
    }

    fn at(&mut self, part: PlacedPart) -> Option<&mut usize> {
        match part {
            PlacedPart::Point(point) => Some(&mut self.points[point.index()]),
            PlacedPart::Link(link) => Some(&mut self.links[link.index()]),
            PlacedPart::Slide(_) => None,
        }
    }

    /// Gives every part a row that no other one has as long as it is read.
    fn share_rows(&mut self, program: &Program, sources: usize) {
        let needed = Needed::of(program);
        let mut last_points = vec![0; program.points.len()];
        let mut last_links = vec![0; program.links.len()];
        let steps = || program.steps.iter().enumerate();
        for (i, step) in steps().filter(|(_, step)| reads_rows(step)) {
            step.inputs(&program.coupled, &mut |part| match part {
                PlacedPart::Point(point) => last_points[point.index()] = i,
                PlacedPart::Link(link) => last_links[link.index()] = i,
                PlacedPart::Slide(_) => {}
            });
        }
        let mut free = Vec::new();
        for (i, step) in steps().filter(|(_, step)| writes_rows(step)) {
            let mut placed = Vec::new();
            step.outputs(&program.coupled, &mut |part| {
                if needed.has(part) {
                    placed.push(part);
                }
            });
            for &part in &placed {
                let row = free.pop().unwrap_or_else(|| {
                    self.rows.push(InfluenceRow::of(sources));
                    self.rows.len() - 1
                });
                if let Some(at) = self.at(part) {
                    *at = row;
                }
            }
            let mut done = |part: PlacedPart| {
                let (row, last) = match part {
                    PlacedPart::Point(p) => (self.points[p.index()], last_points[p.index()]),
                    PlacedPart::Link(l) => (self.links[l.index()], last_links[l.index()]),
                    PlacedPart::Slide(_) => return,
                };
                if row != 0 && last <= i && !free.contains(&row) {
                    free.push(row);
                }
            };
            placed.into_iter().for_each(&mut done);
            if reads_rows(step) {
                step.inputs(&program.coupled, &mut done);
            }
        }
    }

    /// Before a state: no source is known.
    pub(super) fn begin(&mut self) {
        self.known = 0;
    }

    /// Whether there are so many dyads that little comes to much.
    #[inline(always)]
    pub(super) fn is_long(&self) -> bool {
        self.is_long
    }

    /// The same, asked of code that is compiled once for short chains alone: `FUSED`.
    #[inline(always)]
    pub(super) fn matter<const FUSED: bool>(&self) -> bool {
        !FUSED && self.is_long
    }

    /// Whether a point has a row.
    #[inline(always)]
    pub(super) fn has_point(&self, point: PointId) -> bool {
        self.points[point.index()] != 0
    }

    /// Whether a link has one.
    #[inline(always)]
    pub(super) fn has_link(&self, link: LinkId) -> bool {
        self.links[link.index()] != 0
    }

    /// A point whose errors, below these bounds, have nothing to do with those of others.
    pub(super) fn point_alone(&mut self, point: PointId, bounds: [f64; 3]) {
        self.write_point(point, bounds, |_, _| {});
    }

    /// A link whose errors, below these bounds, have nothing to do with those of others.
    pub(super) fn link_alone(&mut self, link: LinkId, bounds: [f64; 3]) {
        self.write_link(link, bounds, |_, _| {});
    }

    /// Writes the row of a point from others, and what is new at it: two sources that move it along its axes.
    fn write_point(
        &mut self,
        point: PointId,
        bounds: [f64; 3],
        write: impl FnOnce(&mut InfluenceRow, &Influences),
    ) {
        self.write_moved(point, [Vec2::X, Vec2::X.perp()], bounds, write);
    }

    /// The same where the sources move it by these columns.
    fn write_moved(
        &mut self,
        point: PointId,
        [first, second]: [Vec2; 2],
        bounds: [f64; 3],
        write: impl FnOnce(&mut InfluenceRow, &Influences),
    ) {
        let (at, n) = (self.points[point.index()], self.known);
        let mut row = std::mem::take(&mut self.rows[at]);
        row.clear(n + 2);
        write(&mut row, self);
        (row.x[n], row.y[n]) = (first.x, first.y);
        (row.x[n + 1], row.y[n + 1]) = (second.x, second.y);
        self.rows[at] = row;
        self.known = n + 2;
        for (to, bound) in self.bounds.iter_mut().zip(bounds) {
            to[n..n + 2].fill(bound);
        }
    }

    /// The same of a link.
    fn write_link(
        &mut self,
        link: LinkId,
        bounds: [f64; 3],
        write: impl FnOnce(&mut InfluenceRow, &Influences),
    ) {
        let (at, n) = (self.links[link.index()], self.known);
        let mut row = std::mem::take(&mut self.rows[at]);
        row.clear(n + 1);
        write(&mut row, self);
        row.x[n] = 1.0;
        self.rows[at] = row;
        self.known = n + 1;
        for (to, bound) in self.bounds.iter_mut().zip(bounds) {
            to[n] = bound;
        }
    }

    fn point(&self, point: PointId) -> &InfluenceRow {
        &self.rows[self.points[point.index()]]
    }

    fn link(&self, link: LinkId) -> &InfluenceRow {
        &self.rows[self.links[link.index()]]
    }

    /// A point by two constraints with these gradients, to each of which belongs a column of the inverse. A
    /// constraint may be one towards another point. They are new sources, whose bounds are not known yet.
    #[inline(never)]
    pub(super) fn pair(
        &mut self,
        point: PointId,
        gradients: [Vec2; 2],
        columns: [Vec2; 2],
        from: [Option<PointId>; 2],
    ) {
        self.write_moved(point, columns, [0.0; 3], |row, all| {
            for ((g, column), from) in gradients.into_iter().zip(columns).zip(from) {
                if let Some(from) = from {
                    row.add(all.point(from), [column * g.x, column * g.y]);
                }
            }
        });
    }

    /// Bounds the constraints of the newest point; gives what all sources can do to it.
    #[inline(never)]
    pub(super) fn bound(&mut self, point: PointId, order: usize, bounds: [f64; 2]) -> f64 {
        self.bounds[order][self.known - 2..self.known].copy_from_slice(&bounds);
        self.of_point(point, order)
    }

    /// The angle of a link with two points on it: `across` is the derivative by the way between them.
    #[inline(never)]
    pub(super) fn between(
        &mut self,
        link: LinkId,
        new: [f64; 3],
        across: Vec2,
        [x, p]: [PointId; 2],
    ) -> [f64; 3] {
        self.write_link(link, new, |row, all| {
            row.add_across(all.point(x), across);
            row.add_across(all.point(p), -across);
        });
        self.of_link(link)
    }

    /// A point that rides on a link: `arm` is its derivative by the angle.
    #[inline(never)]
    pub(super) fn ride(
        &mut self,
        point: PointId,
        new: [f64; 3],
        base: PointId,
        (link, arm): (LinkId, Vec2),
    ) -> [f64; 3] {
        self.write_point(point, new, |row, all| {
            row.add(all.point(base), [Vec2::X, Vec2::X.perp()]);
            row.add(all.link(link), [arm, Vec2::ZERO]);
        });
        [0, 1, 2].map(|order| self.of_point(point, order))
    }

    /// A link that turns with another one.
    #[inline(never)]
    pub(super) fn lock(&mut self, link: LinkId, new: [f64; 3], to: LinkId) -> [f64; 3] {
        self.write_link(link, new, |row, all| {
            row.add_across(all.link(to), Vec2::X);
        });
        self.of_link(link)
    }

    /// What all sources can do to a point.
    fn of_point(&self, point: PointId, order: usize) -> f64 {
        let (row, bounds) = (self.point(point), &self.bounds[order]);
        let [x, y] = [&row.x, &row.y].map(|row_of| summed(&row_of[..row.len], bounds));
        // Written so that NaN is kept.
        let most = if x <= y { y } else { x };
        most * SQRT_2 * (1.0 + SUM)
    }

    /// What all sources can do to a link's angle and its rates.
    fn of_link(&self, link: LinkId) -> [f64; 3] {
        let row = self.link(link);
        [0, 1, 2].map(|order| summed(&row.x[..row.len], &self.bounds[order]) * (1.0 + SUM))
    }
}
