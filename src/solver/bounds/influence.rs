//! How what is not known of one constraint moves what stands on it.
//!
//! Each constraint of a dyad is a source: its value is off by something unknown below a bound, at each
//! order; so is the place of a point that later steps stand on, where that is off by something of its own. Points and links carry by how much each source before them moves them: rows of the inverse of
//! the whole matrix, which is block triangular, found forwards. Summed in the end over sources by size,
//! they give bounds that do not widen from group to group.
//!
//! A row is kept only as long as a later step reads it.

use crate::solver::coupled::Coupled;
use crate::solver::demand::{Part, inputs, outputs};
use crate::solver::plan::Program;
use crate::solver::step::Step;
use crate::{LinkId, PointId, Vec2};

/// By how much each of the first sources moves a point, or in x a link's angle.
#[derive(Clone, Debug, Default)]
struct Row {
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
    /// The first one stays empty: what stands on no source.
    rows: Vec<Row>,
    /// Where the rows of points and links are.
    points: Vec<usize>,
    links: Vec<usize>,
    /// Whether later steps read them.
    read_points: Vec<bool>,
    read_links: Vec<bool>,
}

/// How many sources a step has at most.
fn sources(step: &Step, coupled: &[Coupled]) -> usize {
    let mut count = 0;
    outputs(step, coupled, &mut |part| {
        count += match part {
            Part::Point(_) => 2,
            Part::Link(_) => 1,
            Part::Slide(_) => 0,
        }
    });
    count
}

/// Whether a step makes rows of rows.
fn reads_rows(step: &Step) -> bool {
    matches!(
        step,
        Step::Circles(_)
            | Step::CircleRail(_)
            | Step::Ride { .. }
            | Step::Aim { .. }
            | Step::Lock { .. }
    )
}

/// Whether what a step places has rows.
fn writes_rows(step: &Step) -> bool {
    !matches!(
        step,
        Step::Crank { .. } | Step::Spin { .. } | Step::Travel { .. }
    )
}

/// A weighted sum of sizes.
#[inline(always)]
fn summed(row: &[f64], bounds: &[f64]) -> f64 {
    row.iter().zip(bounds).map(|(v, b)| v.abs() * b).sum()
}

impl Row {
    fn of(sources: usize) -> Row {
        Row {
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
    fn add(&mut self, row: &Row, [first, second]: [Vec2; 2]) {
        let from = row.x[..row.len].iter().zip(&row.y[..row.len]);
        let to = self.x.iter_mut().zip(&mut self.y);
        for ((tx, ty), (x, y)) in to.zip(from) {
            *tx += first.x * x + second.x * y;
            *ty += first.y * x + second.y * y;
        }
    }

    /// Adds g . row to x.
    #[inline(always)]
    fn add_across(&mut self, row: &Row, g: Vec2) {
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
        let mut influences = Influences {
            bounds: std::array::from_fn(|_| vec![0.0; sources]),
            known: 0,
            rows: vec![Row::default()],
            points: vec![0; program.points.len()],
            links: vec![0; program.links.len()],
            read_points: vec![false; program.points.len()],
            read_links: vec![false; program.links.len()],
        };
        influences.share_rows(program, sources);
        influences
    }

    fn at(&mut self, part: Part) -> Option<&mut usize> {
        match part {
            Part::Point(point) => Some(&mut self.points[point.index()]),
            Part::Link(link) => Some(&mut self.links[link.index()]),
            Part::Slide(_) => None,
        }
    }

    /// Gives every part a row that no other one has as long as it is read.
    fn share_rows(&mut self, program: &Program, sources: usize) {
        let mut last_points = vec![0; program.points.len()];
        let mut last_links = vec![0; program.links.len()];
        let steps = || program.steps.iter().enumerate();
        for (i, step) in steps().filter(|(_, step)| reads_rows(step)) {
            inputs(step, &program.coupled, &mut |part| match part {
                Part::Point(point) => last_points[point.index()] = i,
                Part::Link(link) => last_links[link.index()] = i,
                Part::Slide(_) => {}
            });
        }
        self.read_points = last_points.iter().map(|&last| last > 0).collect();
        self.read_links = last_links.iter().map(|&last| last > 0).collect();
        let mut free = Vec::new();
        for (i, step) in steps().filter(|(_, step)| writes_rows(step)) {
            let mut placed = Vec::new();
            outputs(step, &program.coupled, &mut |part| placed.push(part));
            for &part in &placed {
                let row = free.pop().unwrap_or_else(|| {
                    self.rows.push(Row::of(sources));
                    self.rows.len() - 1
                });
                if let Some(at) = self.at(part) {
                    *at = row;
                }
            }
            let mut done = |part: Part| {
                let (row, last) = match part {
                    Part::Point(p) => (self.points[p.index()], last_points[p.index()]),
                    Part::Link(l) => (self.links[l.index()], last_links[l.index()]),
                    Part::Slide(_) => return,
                };
                if row != 0 && last <= i && !free.contains(&row) {
                    free.push(row);
                }
            };
            placed.into_iter().for_each(&mut done);
            if reads_rows(step) {
                inputs(step, &program.coupled, &mut done);
            }
        }
    }

    /// Before a state: no source is known.
    pub(super) fn begin(&mut self) {
        self.known = 0;
    }

    /// A point whose errors, below these bounds, have nothing to do with those of others.
    pub(super) fn point_alone(&mut self, point: PointId, bounds: [Vec2; 3]) -> bool {
        let row = self.points[point.index()];
        self.rows[row].len = 0;
        self.add_own(point, bounds)
    }

    /// A point with errors of its own below these bounds; whether they are sources now.
    #[inline(always)]
    pub(super) fn add_own(&mut self, point: PointId, bounds: [Vec2; 3]) -> bool {
        let is_some = bounds.iter().any(|b| b.x + b.y > 0.0);
        // What is not bounded must not reach what does not stand on it.
        let is_finite = bounds.iter().all(|b| b.x + b.y < f64::INFINITY);
        if !(self.read_points[point.index()] && is_some && is_finite) {
            return false;
        }
        let n = self.known;
        let row = &mut self.rows[self.points[point.index()]];
        row.x[row.len..n].fill(0.0);
        row.y[row.len..n].fill(0.0);
        (row.x[n], row.y[n], row.x[n + 1], row.y[n + 1]) = (1.0, 0.0, 0.0, 1.0);
        row.len = n + 2;
        self.known = n + 2;
        for (to, bound) in self.bounds.iter_mut().zip(bounds) {
            (to[n], to[n + 1]) = (bound.x, bound.y);
        }
        true
    }

    /// A link whose errors, below these bounds, have nothing to do with those of others; whether they are
    /// a source now.
    pub(super) fn link_alone(&mut self, link: LinkId, bounds: [f64; 3]) -> bool {
        let row = self.links[link.index()];
        self.rows[row].len = 0;
        let is_finite = bounds.iter().all(|b| *b < f64::INFINITY);
        if !(self.read_links[link.index()] && is_finite) {
            return false;
        }
        let n = self.known;
        let row = &mut self.rows[self.links[link.index()]];
        row.clear(n + 1);
        row.x[n] = 1.0;
        self.known = n + 1;
        for (to, bound) in self.bounds.iter_mut().zip(bounds) {
            to[n] = bound;
        }
        true
    }

    /// Writes a row from others.
    #[inline(always)]
    fn write(&mut self, at: usize, write: impl FnOnce(&mut Row, &Influences)) {
        let mut row = std::mem::take(&mut self.rows[at]);
        row.clear(self.known);
        write(&mut row, self);
        self.rows[at] = row;
    }

    fn point(&self, point: PointId) -> &Row {
        &self.rows[self.points[point.index()]]
    }

    fn link(&self, link: LinkId) -> &Row {
        &self.rows[self.links[link.index()]]
    }

    /// A point by two constraints with these gradients, to each of which belongs a column of the inverse;
    /// they are new sources. A constraint may be one towards another point.
    #[inline(always)]
    pub(super) fn pair(
        &mut self,
        point: PointId,
        gradients: [Vec2; 2],
        columns: [Vec2; 2],
        from: [Option<PointId>; 2],
    ) {
        let first = self.known;
        self.write(self.points[point.index()], |row, all| {
            for ((g, column), from) in gradients.into_iter().zip(columns).zip(from) {
                if let Some(from) = from {
                    row.add(all.point(from), [column * g.x, column * g.y]);
                }
            }
            for (i, column) in (first..).zip(columns) {
                (row.x[i], row.y[i]) = (column.x, column.y);
            }
            row.len = first + 2;
        });
        self.known = first + 2;
    }

    /// Bounds of the two newest sources.
    #[inline(always)]
    pub(super) fn bound(&mut self, order: usize, bounds: [f64; 2]) {
        self.bounds[order][self.known - 2..self.known].copy_from_slice(&bounds);
    }

    /// The angle of a link with two points on it: `across` is the derivative by the way between them.
    #[inline(always)]
    pub(super) fn between(&mut self, link: LinkId, across: Vec2, [x, p]: [PointId; 2]) {
        self.write(self.links[link.index()], |row, all| {
            row.add_across(all.point(x), across);
            row.add_across(all.point(p), -across);
        });
    }

    /// A point that rides on a link: `arm` is its derivative by the angle.
    #[inline(always)]
    pub(super) fn ride(&mut self, point: PointId, base: PointId, link: LinkId, arm: Vec2) {
        self.write(self.points[point.index()], |row, all| {
            row.add(all.point(base), [Vec2::X, Vec2::X.perp()]);
            row.add(all.link(link), [arm, Vec2::ZERO]);
        });
    }

    /// A link that turns with another one.
    pub(super) fn lock(&mut self, link: LinkId, to: LinkId) {
        self.write(self.links[link.index()], |row, all| {
            row.add_across(all.link(to), Vec2::X);
        });
    }

    /// What all sources can do to a point.
    #[inline(always)]
    pub(super) fn of_point(&self, point: PointId, order: usize) -> Vec2 {
        let (row, bounds) = (self.point(point), &self.bounds[order]);
        Vec2::new(
            summed(&row.x[..row.len], bounds),
            summed(&row.y[..row.len], bounds),
        )
    }

    /// What all sources can do to a link's angle.
    #[inline(always)]
    pub(super) fn of_link(&self, link: LinkId, order: usize) -> f64 {
        let row = self.link(link);
        summed(&row.x[..row.len], &self.bounds[order])
    }
}
