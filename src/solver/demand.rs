//! What of a program a demand needs: the steps are walked backwards from what is read.

use super::Demand;
use super::coupled::Coupled;
use super::plan::Program;
use super::step::{Line, Step};
use crate::{LinkId, PointId, SlideId};

/// Some of the points, links and slides of a program.
#[derive(Clone, Debug)]
pub(super) struct Marks {
    pub points: Vec<bool>,
    pub links: Vec<bool>,
    pub slides: Vec<bool>,
}

/// What a step places.
#[derive(Clone, Copy, Debug)]
enum Part {
    Point(PointId),
    Link(LinkId),
    Slide(SlideId),
}

impl Marks {
    pub(super) fn none(program: &Program, slides: usize) -> Marks {
        Marks {
            points: vec![false; program.points.len()],
            links: vec![false; program.links.len()],
            slides: vec![false; slides],
        }
    }

    fn of(&mut self, part: Part) -> &mut bool {
        match part {
            Part::Point(point) => &mut self.points[point.index()],
            Part::Link(link) => &mut self.links[link.index()],
            Part::Slide(slide) => &mut self.slides[slide.index()],
        }
    }

    fn point(&mut self, point: PointId) {
        *self.of(Part::Point(point)) = true;
    }

    fn link(&mut self, link: LinkId) {
        *self.of(Part::Link(link)) = true;
    }

    fn line(&mut self, line: &Line) {
        self.point(line.through);
        self.link(line.link);
    }
}

/// Takes the steps that the demand does not need out of a program, and marks what they placed.
pub(super) fn prune(program: &mut Program, demand: &Demand, left_out: &mut Marks) {
    let mut needed = Marks::none(program, left_out.slides.len());
    demand.points.iter().for_each(|&p| needed.point(p));
    demand.links.iter().for_each(|&l| needed.link(l));
    let slides = demand.slides.iter().map(|&s| Part::Slide(s));
    slides.for_each(|slide| *needed.of(slide) = true);
    let mut kept = Vec::new();
    for &step in program.steps.iter().rev() {
        let parts = parts(&step, &program.coupled);
        if demand.forces || parts.iter().any(|&part| *needed.of(part)) {
            mark_inputs(&step, &program.coupled, &mut needed);
            kept.push(step);
        } else {
            parts.iter().for_each(|&part| *left_out.of(part) = true);
        }
    }
    kept.reverse();
    program.steps = kept;
}

/// What a step places.
fn parts(step: &Step, coupled: &[Coupled]) -> Vec<Part> {
    let (point, link) = (Part::Point, Part::Link);
    match step {
        Step::Crank { link: l } | Step::Lock { link: l, .. } => vec![link(*l)],
        Step::Ride { point: p, .. }
        | Step::Push { point: p, .. }
        | Step::Spin { point: p, .. }
        | Step::Lines { point: p, .. } => vec![point(*p)],
        Step::Aim { arm, .. } => vec![link(arm.link)],
        Step::Circles(c) => vec![point(c.point), link(c.near.link), link(c.far.link)],
        Step::CircleLine(c) => vec![point(c.point), link(c.arm.link)],
        Step::CircleRail(c) => vec![point(c.point), link(c.arm.link)],
        Step::Swing(s) => vec![link(s.link)],
        Step::Cylinder(c) => vec![point(c.point), link(c.link), link(c.far.link)],
        Step::Coupled { index } => {
            let group = &coupled[*index];
            let turning = group.turning().iter().copied();
            group.joints().map(point).chain(turning.map(link)).collect()
        }
        Step::Travel { slide, .. } => vec![Part::Slide(*slide)],
    }
}

fn mark_inputs(step: &Step, coupled: &[Coupled], needed: &mut Marks) {
    match step {
        Step::Crank { .. } => {}
        Step::Spin { pivot, .. } => needed.point(*pivot),
        Step::CircleRail(c) => needed.point(c.arm.pivot),
        Step::Ride { base, link, .. } | Step::Push { base, link, .. } => {
            needed.point(*base);
            needed.link(*link);
        }
        Step::Aim { arm, end } => {
            needed.point(arm.pivot);
            needed.point(*end);
        }
        Step::Lock { to, .. } => needed.link(*to),
        Step::Circles(c) => {
            needed.point(c.near.pivot);
            needed.point(c.far.pivot);
        }
        Step::CircleLine(c) => {
            needed.point(c.arm.pivot);
            needed.line(&c.line);
        }
        Step::Swing(s) => {
            needed.point(s.pivot);
            needed.point(s.pin);
        }
        Step::Cylinder(c) => {
            needed.point(c.pivot);
            needed.point(c.far.pivot);
        }
        Step::Lines { first, second, .. } => {
            needed.line(first);
            needed.line(second);
        }
        Step::Coupled { index } => {
            let (points, links) = coupled[*index].inputs();
            points.into_iter().for_each(|p| needed.point(p));
            links.into_iter().for_each(|l| needed.link(l));
        }
        Step::Travel { point, line, .. } => {
            needed.point(*point);
            needed.line(line);
        }
    }
}
