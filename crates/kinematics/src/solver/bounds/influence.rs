//! Propagates unknown errors to dependent parts in long chains.
//!
//! Each constraint of a dyad is a source: its value has an unknown error below a bound, at each
//! order. All other errors of a step's results are sources as well, independent of their
//! dependencies. Points and links store how much each earlier source moves them. These are rows of
//! the inverse of the whole matrix, which is block triangular, computed forwards. Summed over the
//! sources by absolute value, they give bounds that do not widen from group to group.
//!
//! Rests are of second order, apart from uncertain typed digits. Through a few groups they may
//! widen freely, so short chains have no rows. A row is kept only until the last step that reads
//! it.

use super::link_vector::SUM;
use crate::solver::coupled::Coupled;
use crate::solver::elements::Step;
use crate::solver::plan::Program;
use crate::solver::plan::pruning::PlacedPart;
use crate::{LinkId, PointId, Vec2};
use std::f64::consts::SQRT_2;
use std::ops::Range;

/// The displacement of a point by a unit of each source so far. A link's row has its rotation in
/// `x`.
#[derive(Debug, Default)]
struct InfluenceRow {
    x: Vec<f64>,
    y: Vec<f64>,
    len: usize,
}

impl Clone for InfluenceRow {
    fn clone(&self) -> InfluenceRow {
        InfluenceRow {
            x: self.x.clone(),
            y: self.y.clone(),
            len: self.len,
        }
    }

    /// Copies a row without allocating its memory again.
    fn clone_from(&mut self, other: &InfluenceRow) {
        let InfluenceRow { x, y, len } = self;
        x.clone_from(&other.x);
        y.clone_from(&other.y);
        *len = other.len;
    }
}

/// The sources so far, and the rows.
#[derive(Debug, Default)]
pub(super) struct Influences {
    /// The bounds of the sources, by order.
    bounds: [Vec<f64>; 3],
    known: usize,
    is_long: bool,
    /// The rows. The first one stays empty, for parts without a source.
    rows: Vec<InfluenceRow>,
    /// The row index of each point; `links` has those of the links. It is 0 for parts without a
    /// row.
    points: Vec<usize>,
    links: Vec<usize>,
    /// The effects on the newest point of all sources but its own two.
    inherited: Effects,
}

impl Clone for Influences {
    fn clone(&self) -> Influences {
        let mut copy = Influences::default();
        copy.clone_from(self);
        copy
    }

    /// Copies influences without allocating their memory again.
    fn clone_from(&mut self, other: &Influences) {
        let Influences {
            bounds,
            known,
            is_long,
            rows,
            points,
            links,
            inherited,
        } = self;
        bounds.clone_from(&other.bounds);
        *known = other.known;
        *is_long = other.is_long;
        rows.clone_from(&other.rows);
        points.clone_from(&other.points);
        links.clone_from(&other.links);
        *inherited = other.inherited;
    }
}

/// Maximum number of dyads through which rests may widen freely. Each dyad can enlarge them
/// tenfold, and a rest is a rounding error of a rounding error.
const MAX_DYADS: usize = 8;

/// Returns the maximum number of sources of a step.
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

/// Returns `true` if a step computes rows from rows.
fn reads_rows(step: &Step) -> bool {
    matches!(
        step,
        Step::Circles(_) | Step::CircleRail(_) | Step::Ride(_) | Step::Aim(_) | Step::Lock(_)
    )
}

/// Returns `true` if the results of a step have rows.
fn writes_rows(step: &Step) -> bool {
    !matches!(step, Step::Crank(_) | Step::Spin(_) | Step::SlideReadout(_))
}

/// The parts that need a row: joints of dyads, and the parts on which they depend. For all other
/// parts, with no dependents, the bounds may be added directly.
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

/// The effects on a part, by order: along x and y, or on a link's angle and nothing.
type Effects = [[f64; 2]; 3];

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

    /// Adds M times `row`, with M given by its columns.
    #[inline(always)]
    fn add(&mut self, row: &InfluenceRow, [first, second]: [Vec2; 2]) {
        let from = row.x[..row.len].iter().zip(&row.y[..row.len]);
        let to = self.x.iter_mut().zip(&mut self.y);
        for ((tx, ty), (x, y)) in to.zip(from) {
            *tx += first.x * x + second.x * y;
            *ty += first.y * x + second.y * y;
        }
    }

    /// Adds g . `row` to x.
    #[inline(always)]
    fn add_across(&mut self, row: &InfluenceRow, g: Vec2) {
        let from = row.x[..row.len].iter().zip(&row.y[..row.len]);
        for (to, (x, y)) in self.x.iter_mut().zip(from) {
            *to += g.x * x + g.y * y;
        }
    }
}

impl Influences {
    /// Creates the sources and rows of a program.
    pub(super) fn new(program: &Program) -> Influences {
        let counts = program
            .steps
            .iter()
            .map(|step| sources(step, &program.coupled));
        let sources = counts.sum();
        let dyads = program.steps.iter().filter(|step| step.dyad().is_some());
        let is_long = dyads.count() > MAX_DYADS;
        let mut influences = Influences {
            is_long,
            bounds: std::array::from_fn(|_| vec![0.0; sources]),
            known: 0,
            rows: vec![InfluenceRow::default()],
            points: vec![0; program.points.len()],
            links: vec![0; program.links.len()],
            inherited: Effects::default(),
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

    /// Assigns each part a row that no other part uses as long as it is read.
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

    /// Starts a state, without sources.
    pub(super) fn start(&mut self) {
        self.known = 0;
    }

    /// Returns `true` if there are so many dyads that small errors add up.
    #[inline(always)]
    pub(super) fn is_long(&self) -> bool {
        self.is_long
    }

    /// Returns `true` if the chain is long. Code compiled only for short chains (`FUSED`) gets
    /// `false`.
    #[inline(always)]
    pub(super) fn is_long_chain<const FUSED: bool>(&self) -> bool {
        !FUSED && self.is_long
    }

    /// Returns `true` if a point has a row.
    #[inline(always)]
    pub(super) fn has_point(&self, point: PointId) -> bool {
        self.points[point.index()] != 0
    }

    /// Returns `true` if a link has a row.
    #[inline(always)]
    pub(super) fn has_link(&self, link: LinkId) -> bool {
        self.links[link.index()] != 0
    }

    /// Writes the row of a point whose errors, within these bounds, are independent of all others.
    pub(super) fn point_alone(&mut self, point: PointId, bounds: [f64; 3]) {
        self.write_point(point, bounds, |_, _| {});
    }

    /// Writes the row of a link whose errors, within these bounds, are independent of all others.
    pub(super) fn link_alone(&mut self, link: LinkId, bounds: [f64; 3]) {
        self.write_link(link, bounds, |_, _| {});
    }

    /// Writes the row of a point from other rows. Its new errors are two sources that move it along
    /// the axes.
    fn write_point(
        &mut self,
        point: PointId,
        bounds: [f64; 3],
        write: impl FnOnce(&mut InfluenceRow, &Influences),
    ) {
        self.write_moved(point, [Vec2::X, Vec2::X.perp()], bounds, write);
    }

    /// Writes the row of a point whose two new sources move it by the given columns.
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

    /// Writes the row of a link from other rows. Its new error is one source.
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

    /// Adds the effects of some sources on a part. An unbounded source does not affect parts
    /// independent of it. All orders share a pass, because each sum waits for its last addition.
    #[inline(always)]
    fn add_effects(&self, row: &InfluenceRow, sources: Range<usize>, effects: &mut Effects) {
        let term = |v: f64, bound: f64| if v == 0.0 { 0.0 } else { v.abs() * bound };
        let [positions, rates, seconds] = self.bounds.each_ref().map(|b| &b[sources.clone()]);
        let row = row.x[sources.clone()].iter().zip(&row.y[sources]);
        let bounds = positions.iter().zip(rates.iter().zip(seconds));
        for ((&x, &y), (&p, (&v, &a))) in row.zip(bounds) {
            for (effect, bound) in effects.iter_mut().zip([p, v, a]) {
                effect[0] += term(x, bound);
                effect[1] += term(y, bound);
            }
        }
    }

    fn point(&self, point: PointId) -> &InfluenceRow {
        &self.rows[self.points[point.index()]]
    }

    fn link(&self, link: LinkId) -> &InfluenceRow {
        &self.rows[self.links[link.index()]]
    }

    /// Writes the row of a point determined by two constraints with these gradients. `columns` are
    /// the corresponding columns of the inverse. A constraint may refer to another point. The two
    /// are new sources, whose bounds are set later by [`Influences::bound`].
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
        let mut inherited = Effects::default();
        self.add_effects(self.point(point), 0..self.known - 2, &mut inherited);
        self.inherited = inherited;
    }

    /// Sets the bounds of the constraints of the newest point, and returns the effect of all
    /// sources on it.
    #[inline(never)]
    pub(super) fn bound(&mut self, point: PointId, order: usize, bounds: [f64; 2]) -> f64 {
        let own = self.known - 2..self.known;
        self.bounds[order][own.clone()].copy_from_slice(&bounds);
        let mut effects = self.inherited;
        self.add_effects(self.point(point), own, &mut effects);
        larger(effects[order])
    }

    /// Writes the row of a link determined by two points, and returns the effect of all sources.
    /// `across` is the derivative of its angle by the vector between the points.
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

    /// Writes the row of a point that rides on a link, and returns the effect of all sources. `arm`
    /// is its derivative by the link's angle.
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
        self.effects(self.point(point)).map(larger)
    }

    /// Writes the row of a link locked to another one, and returns the effect of all sources.
    #[inline(never)]
    pub(super) fn lock(&mut self, link: LinkId, new: [f64; 3], to: LinkId) -> [f64; 3] {
        self.write_link(link, new, |row, all| {
            row.add_across(all.link(to), Vec2::X);
        });
        self.of_link(link)
    }

    /// Returns the effects of all sources on a part.
    fn effects(&self, row: &InfluenceRow) -> Effects {
        let mut effects = Effects::default();
        self.add_effects(row, 0..row.len, &mut effects);
        effects
    }

    /// Returns the effect of all sources on a link's angle and its rates.
    fn of_link(&self, link: LinkId) -> [f64; 3] {
        let effects = self.effects(self.link(link));
        effects.map(|[angle, _]| angle * (1.0 + SUM))
    }
}

/// Returns a bound of the length of a vector with components up to these.
fn larger([x, y]: [f64; 2]) -> f64 {
    // Written so that NaN is kept.
    let maximum = if x <= y { y } else { x };
    maximum * SQRT_2 * (1.0 + SUM)
}
