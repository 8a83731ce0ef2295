//! Removes the steps of a program that a demand does not need, walking backwards from the values
//! read.

use crate::solver::Demand;
use crate::solver::plan::Program;
use crate::{LinkId, PointId, SlideId};

/// A subset of the points, links and slides of a program.
#[derive(Clone, Debug)]
pub(in crate::solver) struct Marks {
    pub points: Vec<bool>,
    pub links: Vec<bool>,
    pub slides: Vec<bool>,
}

/// An element placed by a step.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) enum PlacedPart {
    Point(PointId),
    Link(LinkId),
    Slide(SlideId),
}

impl Marks {
    pub(in crate::solver) fn none(program: &Program, slides: usize) -> Marks {
        Marks {
            points: vec![false; program.points.len()],
            links: vec![false; program.links.len()],
            slides: vec![false; slides],
        }
    }

    fn of(&mut self, part: PlacedPart) -> &mut bool {
        match part {
            PlacedPart::Point(point) => &mut self.points[point.index()],
            PlacedPart::Link(link) => &mut self.links[link.index()],
            PlacedPart::Slide(slide) => &mut self.slides[slide.index()],
        }
    }
}

/// Removes the steps that `demand` does not need, and marks in `left_out` the elements that they
/// place.
pub(in crate::solver) fn prune(program: &mut Program, demand: &Demand, left_out: &mut Marks) {
    let mut needed = Marks::none(program, left_out.slides.len());
    let points = demand.points.iter().map(|&p| PlacedPart::Point(p));
    let links = demand.links.iter().map(|&l| PlacedPart::Link(l));
    let slides = demand.slides.iter().map(|&s| PlacedPart::Slide(s));
    let requested = points.chain(links).chain(slides);
    requested.for_each(|part| *needed.of(part) = true);
    let mut kept = Vec::new();
    for step in program.steps.drain(..).rev() {
        let mut parts = Vec::new();
        step.outputs(&program.coupled, &mut |part| parts.push(part));
        if demand.forces || parts.iter().any(|&part| *needed.of(part)) {
            let mut need = |part| *needed.of(part) = true;
            step.inputs(&program.coupled, &mut need);
            kept.push(step);
        } else {
            parts.iter().for_each(|&part| *left_out.of(part) = true);
        }
    }
    kept.reverse();
    program.steps = kept;
}
