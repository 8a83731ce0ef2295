//! What of a program a demand needs: the steps are walked backwards from what is read.

use super::Demand;
use super::coupled::Coupled;
use super::plan::Program;
use super::step::{Dyad, Line, Step};
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
pub(super) enum Part {
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
}

/// Takes the steps that the demand does not need out of a program, and marks what they placed.
pub(super) fn prune(program: &mut Program, demand: &Demand, left_out: &mut Marks) {
    let mut needed = Marks::none(program, left_out.slides.len());
    let points = demand.points.iter().map(|&p| Part::Point(p));
    let links = demand.links.iter().map(|&l| Part::Link(l));
    let slides = demand.slides.iter().map(|&s| Part::Slide(s));
    let asked = points.chain(links).chain(slides);
    asked.for_each(|part| *needed.of(part) = true);
    let mut kept = Vec::new();
    for &step in program.steps.iter().rev() {
        let mut parts = Vec::new();
        outputs(&step, &program.coupled, &mut |part| parts.push(part));
        if demand.forces || parts.iter().any(|&part| *needed.of(part)) {
            let mut need = |part| *needed.of(part) = true;
            inputs(&step, &program.coupled, &mut need);
            kept.push(step);
        } else {
            parts.iter().for_each(|&part| *left_out.of(part) = true);
        }
    }
    kept.reverse();
    program.steps = kept;
}

/// Says of everything that a step places that it does.
pub(super) fn outputs(step: &Step, coupled: &[Coupled], places: &mut impl FnMut(Part)) {
    let (point, link) = (Part::Point, Part::Link);
    match step {
        Step::Crank { link: l } | Step::Lock { link: l, .. } => places(link(*l)),
        Step::Ride { point: p, .. }
        | Step::Push { point: p, .. }
        | Step::Spin { point: p, .. }
        | Step::Lines { point: p, .. } => places(point(*p)),
        Step::Aim { arm, .. } => places(link(arm.link)),
        Step::Circles(_)
        | Step::CircleLine(_)
        | Step::CircleRail(_)
        | Step::Swing(_)
        | Step::Cylinder(_) => {
            let (placed, turned) = step.dyad().map(Dyad::outputs).unwrap_or_default();
            placed.into_iter().for_each(|p| places(point(p)));
            let turned = turned.into_iter().flatten();
            turned.for_each(|l| places(link(l)));
        }
        Step::Coupled { index } => {
            let group = &coupled[*index];
            group.joints().for_each(|p| places(point(p)));
            let turning = group.turning().iter();
            turning.for_each(|&l| places(link(l)));
        }
        Step::Travel { slide, .. } => places(Part::Slide(*slide)),
    }
}

/// Says of everything that a step reads that it does.
pub(super) fn inputs(step: &Step, coupled: &[Coupled], reads: &mut impl FnMut(Part)) {
    let (point, body) = (Part::Point, Part::Link);
    let line = |line: &Line| [point(line.through), body(line.link)];
    match step {
        Step::Crank { .. } => {}
        Step::Spin { pivot, .. } => reads(point(*pivot)),
        Step::CircleRail(c) => reads(point(c.arm.pivot)),
        Step::Ride { base, link, .. } | Step::Push { base, link, .. } => {
            reads(point(*base));
            reads(body(*link));
        }
        Step::Aim { arm, end } => {
            reads(point(arm.pivot));
            reads(point(*end));
        }
        Step::Lock { to, .. } => reads(body(*to)),
        Step::Circles(c) => {
            reads(point(c.near.pivot));
            reads(point(c.far.pivot));
        }
        Step::CircleLine(c) => {
            reads(point(c.arm.pivot));
            line(&c.line).into_iter().for_each(&mut *reads);
        }
        Step::Swing(s) => {
            reads(point(s.pivot));
            reads(point(s.pin));
        }
        Step::Cylinder(c) => {
            reads(point(c.pivot));
            reads(point(c.far.pivot));
        }
        Step::Lines { first, second, .. } => {
            line(first).into_iter().for_each(&mut *reads);
            line(second).into_iter().for_each(&mut *reads);
        }
        Step::Coupled { index } => {
            let (points, links) = coupled[*index].inputs();
            points.into_iter().for_each(|p| reads(point(p)));
            links.into_iter().for_each(|l| reads(body(l)));
        }
        Step::Travel {
            point: p,
            line: guide,
            ..
        } => {
            reads(point(*p));
            line(guide).into_iter().for_each(&mut *reads);
        }
    }
}
