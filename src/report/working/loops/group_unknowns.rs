//! Determines the unknowns that each group of the plan finds from its loops, and the form of the
//! problem.

use super::polygon::{Polygon, Term};
use super::sides::{Side, SideShape, Turns};
use crate::scene::Scene;
use crate::solver::{GroupKind, Plan};
use crate::{Body, Input, LinkId, Mechanism, SlideId};

/// An unknown of a loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LoopUnknown {
    /// The angle of a link, and of everything that rotates with it.
    Angle(LinkId),
    /// The position along a slide.
    Travel(SlideId),
    /// The length of a vector between two bodies, by the index of the side.
    Length(usize),
    /// The angle of a vector between two bodies, by the index of the side.
    Direction(usize),
}

/// The form of a group's problem.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum ProblemForm {
    /// No unknowns: the driver's group, or a loop that repeats others.
    Nothing,
    /// Two angles: a triangle of three known sides.
    Triangle(Vec<Term>, Vec<Term>),
    /// An angle and a position along a guide of known direction: a quadratic.
    Quadratic(Vec<Term>, Term),
    /// An angle and the position along a guide that rotates with it.
    Swing(Vec<Term>, Term),
    /// Two positions along guides of known directions.
    Guides(Term, Term),
    /// Length and direction of one vector.
    Sum(Term),
    /// Several coupled loops, or another form.
    System,
}

/// A group of the plan with its loops.
#[derive(Clone, Debug)]
pub(crate) struct Stage {
    /// The index of the group in the plan; `None` for a vector that only closes a loop.
    pub group: Option<usize>,
    /// The indices of the group's loops.
    pub loops: Vec<usize>,
    pub unknowns: Vec<LoopUnknown>,
    pub form: ProblemForm,
}

/// The groups that find the angles of links and the positions of slides.
#[derive(Clone, Debug)]
pub(crate) struct Schedule {
    /// The group that finds the angle of each link.
    links: Vec<usize>,
    /// The group that finds the position of each slide.
    slides: Vec<usize>,
    /// Every input, with the link that represents the direction of a driven link.
    inputs: Vec<(Input, Option<LinkId>)>,
}

impl Stage {
    /// Returns the inputs between links of which one has an unknown angle here: each gives a
    /// further equation.
    pub(crate) fn elbows(&self, mechanism: &Mechanism, polygon: &Polygon) -> Vec<[LinkId; 2]> {
        let root = |link: LinkId| match polygon.locks.turns(Body::Link(link), 0.0) {
            Turns::With(root, _) => root,
            Turns::Never | Turns::Freely => link,
        };
        let is_sought = |link: LinkId| self.unknowns.contains(&LoopUnknown::Angle(root(link)));
        let elbows = mechanism.elbows().map(|(link, from)| [link, from]);
        let unknowns = elbows.filter(|pair| pair.iter().any(|&link| is_sought(link)));
        unknowns.collect()
    }
}

impl Schedule {
    pub(crate) fn of(scene: &Scene, plan: &Plan, polygon: &Polygon) -> Schedule {
        let mechanism = &scene.mechanism;
        let last = plan.groups.len();
        let (mut links, mut points) = (
            vec![last; mechanism.links().len()],
            vec![0; mechanism.points().len()],
        );
        for (number, group) in plan.groups.iter().enumerate() {
            for &link in &group.links {
                // Links locked to each other are known together.
                let root = polygon.locks.turns(Body::Link(link), 0.0);
                if let Turns::With(root, _) = root {
                    links[root.index()] = links[root.index()].min(number);
                }
                links[link.index()] = links[link.index()].min(number);
            }
            for &point in &group.points {
                points[point.index()] = number;
            }
        }
        let slide = |slide: SlideId| {
            let given = mechanism.slide(slide);
            let guide = match given.on {
                Body::Ground => 0,
                Body::Link(link) => links[link.index()],
            };
            guide.max(points[given.slider.point().index()])
        };
        let root = |input| match input {
            Input::Turn(link) if mechanism.is_directed(link) => {
                match polygon.locks.turns(Body::Link(link), 0.0) {
                    Turns::With(root, _) => Some(root),
                    Turns::Never | Turns::Freely => None,
                }
            }
            Input::Turn(_) | Input::Push(_) => None,
        };
        let inputs = mechanism.inputs().map(|input| (input, root(input)));
        Schedule {
            slides: mechanism.slide_ids().map(slide).collect(),
            links,
            inputs: inputs.collect(),
        }
    }

    /// Returns `true` if a side's direction is that of an input, or locked to it.
    pub(crate) fn is_driven(&self, side: &Side) -> bool {
        side.turns_with().is_some_and(|link| self.drives(link))
    }

    /// Returns `true` if an input turns the link or anything locked to it.
    fn drives(&self, link: LinkId) -> bool {
        self.inputs.iter().any(|(_, root)| *root == Some(link))
    }

    /// Returns `true` if a side's length is that of an input.
    pub(crate) fn is_pushed(&self, side: &Side) -> bool {
        matches!(side.shape, SideShape::Slide(slide) if self.pushes(slide))
    }

    fn pushes(&self, slide: SlideId) -> bool {
        self.inputs
            .iter()
            .any(|(input, _)| *input == Input::Push(slide))
    }

    /// Returns the input that determines a side's length or direction, if any.
    pub(crate) fn input(&self, side: &Side) -> Option<Input> {
        let link = side.turns_with();
        let gives = |(input, root): &&(Input, Option<LinkId>)| {
            let is_rotary = root.is_some() && *root == link;
            is_rotary
                || matches!(side.shape, SideShape::Slide(slide) if *input == Input::Push(slide))
        };
        self.inputs.iter().find(gives).map(|(input, _)| *input)
    }

    /// Returns the group that finds a side's angle; `None` if it is given.
    pub(crate) fn angle_group(&self, side: &Side) -> Option<usize> {
        match side.turns {
            Turns::Never => None,
            Turns::With(link, _) if self.drives(link) => None,
            Turns::With(link, _) => self.links.get(link.index()).copied(),
            Turns::Freely => Some(usize::MAX),
        }
    }

    /// Returns the group that finds a side's length; `None` if it is given.
    pub(crate) fn length_group(&self, side: &Side) -> Option<usize> {
        match side.shape {
            SideShape::Link(_) | SideShape::Rigid(..) => None,
            SideShape::Slide(slide) if self.pushes(slide) => None,
            SideShape::Slide(slide) => self.slides.get(slide.index()).copied(),
            SideShape::Free(..) => Some(usize::MAX),
        }
    }
}

/// Returns the groups in order, then the vectors that only close a loop.
pub(crate) fn stages(plan: &Plan, polygon: &Polygon, schedule: &Schedule) -> Vec<Stage> {
    let of_group = |number: usize| {
        let loops = polygon.loops.iter().enumerate();
        let own = loops.filter(|(_, l)| l.group == Some(number));
        let loops: Vec<usize> = own.map(|(i, _)| i).collect();
        let unknowns = unknowns(&loops, number, polygon, schedule);
        let form = form(&plan.groups[number].kind, &loops, &unknowns, polygon);
        Stage {
            group: Some(number),
            loops,
            unknowns,
            form,
        }
    };
    let mut stages: Vec<Stage> = (0..plan.groups.len()).map(of_group).collect();
    for (number, of) in polygon.loops.iter().enumerate() {
        let (None, Some(&term)) = (of.group, of.terms.first()) else {
            continue;
        };
        stages.push(Stage {
            group: None,
            loops: vec![number],
            unknowns: vec![
                LoopUnknown::Length(term.side),
                LoopUnknown::Direction(term.side),
            ],
            form: ProblemForm::Sum(term),
        });
    }
    stages
}

/// Returns the unknowns in the loops of a group, except those found by earlier groups.
fn unknowns(
    loops: &[usize],
    group: usize,
    polygon: &Polygon,
    schedule: &Schedule,
) -> Vec<LoopUnknown> {
    let mut unknowns = Vec::new();
    let terms = loops.iter().flat_map(|&l| &polygon.loops[l].terms);
    for term in terms {
        let side = &polygon.sides[term.side];
        let is_sought = |found: Option<usize>| found.is_some_and(|found| found >= group);
        if let (true, Some(link)) = (is_sought(schedule.angle_group(side)), side.turns_with()) {
            unknowns.push(LoopUnknown::Angle(link));
        }
        if let (true, SideShape::Slide(slide)) =
            (is_sought(schedule.length_group(side)), side.shape)
        {
            unknowns.push(LoopUnknown::Travel(slide));
        }
    }
    let mut seen = Vec::new();
    unknowns.retain(|unknown| {
        let is_new = !seen.contains(unknown);
        seen.push(*unknown);
        is_new
    });
    unknowns
}

fn form(
    kind: &GroupKind,
    loops: &[usize],
    unknowns: &[LoopUnknown],
    polygon: &Polygon,
) -> ProblemForm {
    if unknowns.is_empty() {
        return ProblemForm::Nothing;
    }
    let (&[number], false) = (loops, matches!(kind, GroupKind::Coupled { .. })) else {
        return ProblemForm::System;
    };
    let terms = &polygon.loops[number].terms;
    let of_link = |link: LinkId| -> Vec<Term> {
        let turning = |term: &&Term| polygon.sides[term.side].turns_with() == Some(link);
        terms.iter().filter(turning).copied().collect()
    };
    let of_slide = |slide: SlideId| {
        let is_it = |term: &&Term| polygon.sides[term.side].shape == SideShape::Slide(slide);
        terms.iter().find(is_it).copied()
    };
    match *unknowns {
        [LoopUnknown::Angle(a), LoopUnknown::Angle(b)] => {
            ProblemForm::Triangle(of_link(a), of_link(b))
        }
        [LoopUnknown::Angle(link), LoopUnknown::Travel(slide)]
        | [LoopUnknown::Travel(slide), LoopUnknown::Angle(link)] => {
            let arm = of_link(link);
            match of_slide(slide) {
                Some(term) if arm.contains(&term) => ProblemForm::Swing(arm, term),
                Some(term) => ProblemForm::Quadratic(arm, term),
                None => ProblemForm::System,
            }
        }
        [LoopUnknown::Travel(a), LoopUnknown::Travel(b)] => match (of_slide(a), of_slide(b)) {
            (Some(a), Some(b)) => ProblemForm::Guides(a, b),
            _ => ProblemForm::System,
        },
        _ => ProblemForm::System,
    }
}
