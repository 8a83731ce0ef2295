//! What of a program a demand needs: the steps are walked backwards from what is read.

use super::Demand;
use super::coupled::Coupled;
use super::plan::Program;
use super::step::{Line, Step};
use crate::{LinkId, PointId};

/// What has been found to be needed.
struct Needed {
    points: Vec<bool>,
    links: Vec<bool>,
    slides: Vec<bool>,
}

impl Needed {
    fn point(&mut self, point: PointId) {
        self.points[point.index()] = true;
    }

    fn link(&mut self, link: LinkId) {
        self.links[link.index()] = true;
    }

    fn line(&mut self, line: &Line) {
        self.point(line.through);
        self.link(line.link);
    }
}

/// For every step whether the demand needs it.
pub(super) fn needed_steps(program: &Program, demand: &Demand) -> Vec<bool> {
    if demand.forces {
        return vec![true; program.steps.len()];
    }
    let slides = demand
        .slides
        .iter()
        .map(|s| s.index() + 1)
        .max()
        .unwrap_or(0);
    let mut needed = Needed {
        points: vec![false; program.points.len()],
        links: vec![false; program.links.len()],
        slides: vec![false; slides],
    };
    demand.points.iter().for_each(|&p| needed.point(p));
    demand.links.iter().for_each(|&l| needed.link(l));
    demand
        .slides
        .iter()
        .for_each(|s| needed.slides[s.index()] = true);
    let mut keep = vec![false; program.steps.len()];
    for (i, step) in program.steps.iter().enumerate().rev() {
        keep[i] = is_needed(step, &program.coupled, &needed);
        if keep[i] {
            mark_inputs(step, &program.coupled, &mut needed);
        }
    }
    keep
}

fn is_needed(step: &Step, coupled: &[Coupled], needed: &Needed) -> bool {
    let point = |p: &PointId| needed.points[p.index()];
    let link = |l: &LinkId| needed.links[l.index()];
    match step {
        Step::Crank { link: l } | Step::Lock { link: l, .. } => link(l),
        Step::Ride { point: p, .. }
        | Step::Push { point: p, .. }
        | Step::Lines { point: p, .. } => point(p),
        Step::Aim { arm, .. } => link(&arm.link),
        Step::Circles(c) => point(&c.point) || link(&c.near.link) || link(&c.far.link),
        Step::CircleLine(c) => point(&c.point) || link(&c.arm.link),
        Step::CircleRail(c) => point(&c.point) || link(&c.arm.link),
        Step::Spin { point: p, .. } => point(p),
        Step::Swing(s) => link(&s.link),
        Step::Cylinder(c) => point(&c.point) || link(&c.link) || link(&c.far.link),
        Step::Coupled { index } => {
            let group = &coupled[*index];
            group.joints().any(|p| point(&p)) || group.turning().iter().any(link)
        }
        Step::Travel { slide, .. } => needed.slides.get(slide.index()).copied().unwrap_or(false),
    }
}

fn mark_inputs(step: &Step, coupled: &[Coupled], needed: &mut Needed) {
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
