//! Converts blocks of unknowns to elementary steps. Unknowns that follow directly from known ones
//! are computed first, then dyads are recognised, and the remainder is coupled.

mod dyads;
mod guides;
mod redundant_parts;

use super::coupled::{self, Coupled};
use super::elements::{Aim, Arm, Crank, Elbow, Lock, Push, Ride, Spin, Step, Timed};
use super::fault::Fault;
use super::plan::network::{ClassId, GROUND, Network, ScalarEquation, ScalarUnknown};
use super::plan::order::{self, CoupledBlock, Ordering};
use super::plan::{Group, GroupKind, Plan, Program};
use crate::{Body, Constant, ElementId, Input, LinkId, PointId, SlideId, Vec2};

/// The links and slides of a block's equations.
#[derive(Default)]
struct Scope {
    points: Vec<PointId>,
    classes: Vec<ClassId>,
    links: Vec<LinkId>,
    slides: Vec<SlideId>,
    /// The links that inputs turn relative to others.
    elbows: Vec<LinkId>,
}

/// The treatment of a block that a dyad solves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Dyads {
    /// The block is solved in closed form.
    Closed,
    /// The block is a list of rows like any other block.
    AsRows,
}

/// Builds the program block by block.
pub(super) struct Chain<'n> {
    network: &'n Network<'n>,
    dyads: Dyads,
    point_known: Vec<bool>,
    class_known: Vec<bool>,
    /// Whether a link is listed in its group already.
    listed: Vec<bool>,
    program: Program,
    groups: Vec<Group>,
    /// Points of guides in the ground.
    constants: Vec<PointId>,
    /// The point of a guide that moves with its body, once it was needed.
    guide_points: Vec<Option<PointId>>,
}

/// Converts the ordered blocks to a plan and a program.
///
/// # Errors
/// Returns [`Fault::Singular`] if a block's equations cannot determine its unknowns.
pub(super) fn build(
    network: &Network<'_>,
    ordering: &Ordering,
    dyads: Dyads,
) -> Result<(Plan, Program), Fault> {
    let mut chain = Chain::new(network, dyads);
    chain.drive();
    for block in &ordering.blocks {
        chain.determine_block(block)?;
    }
    chain.watch(&ordering.set_aside);
    chain.travels();
    chain.program.group_starts.push(chain.program.steps.len());
    let mut redundant = order::elements(&ordering.set_aside);
    redundant.extend(network.repeated_locks.iter().map(|&s| ElementId::Slide(s)));
    let plan = Plan {
        groups: chain.groups,
        mobility: network.mechanism.inputs().count(),
        redundant,
    };
    Ok((plan, chain.program))
}

impl<'n> Chain<'n> {
    fn new(network: &'n Network<'n>, dyads: Dyads) -> Self {
        let mechanism = network.mechanism;
        let place = |point| network.fixed(point).unwrap_or_default();
        let points: Vec<Vec2<Constant>> = mechanism.point_ids().map(place).collect();
        let mut links = vec![Vec2::X.exactly(); network.class_of.len()];
        for &link in &network.members[GROUND.0] {
            links[link.index()] = network.turn[link.index()];
        }
        let mut class_known = vec![false; network.members.len()];
        class_known[GROUND.0] = true;
        Chain {
            network,
            dyads,
            point_known: mechanism
                .points()
                .iter()
                .map(|p| p.ground.is_some())
                .collect(),
            class_known,
            listed: vec![false; mechanism.links().len()],
            program: Program {
                steps: Vec::new(),
                group_starts: Vec::new(),
                coupled: Vec::new(),
                points,
                links,
                watches: Vec::new(),
                holds: Vec::new(),
                legs: Vec::new(),
            },
            groups: Vec::new(),
            constants: Vec::new(),
            guide_points: vec![None; mechanism.slides().len()],
        }
    }

    // ---- helpers

    fn knows(&self, link: LinkId) -> bool {
        self.class_known[self.network.class(link).0]
    }

    /// Returns a known point of a link, with its position in the link.
    fn footing(&self, link: LinkId) -> Option<(PointId, Vec2<Constant>)> {
        let mut places = self.network.places(link);
        places.find(|(point, _)| self.point_known[point.index()])
    }

    /// Creates a point in addition to the scene's: a constant, or one placed by a step.
    fn new_point(&mut self, p: Vec2<Constant>) -> PointId {
        self.program.points.push(p);
        self.point_known.push(true);
        PointId::new(self.program.points.len() - 1)
    }

    fn push(&mut self, step: impl Into<Step>) {
        self.program.steps.push(step.into());
    }

    fn group(&self) -> usize {
        self.groups.len().saturating_sub(1)
    }

    fn open_group(&mut self, kind: GroupKind, point: Option<PointId>) -> usize {
        self.program.group_starts.push(self.program.steps.len());
        self.groups.push(Group {
            kind,
            point,
            links: Vec::new(),
            points: Vec::new(),
        });
        self.group()
    }

    // ---- the driver

    fn drive(&mut self) {
        self.open_group(GroupKind::Driver, None);
        let driver = self.network.mechanism.driver().input;
        match driver {
            Input::Turn(link) if self.network.mechanism.is_directed(link) => {
                match self.network.following(driver).cloned() {
                    None => self.push(Crank { link }),
                    Some(following) => self.push(Timed { link, following }),
                }
                self.learn_class(link);
                self.place_link_points(&self.network.members[self.network.class(link).0].clone());
            }
            Input::Turn(_) | Input::Push(_) => {}
        }
        for (link, following) in self.network.timed_links() {
            let following = following.clone();
            self.push(Timed { link, following });
            self.learn_class(link);
            self.place_link_points(&self.network.members[self.network.class(link).0].clone());
        }
        let ground = self.network.members[GROUND.0].clone();
        self.place_link_points(&ground);
    }

    // ---- unknowns that follow directly

    /// Marks a link's direction as known, and with it those of its whole class.
    fn learn_class(&mut self, link: LinkId) {
        let class = self.network.class(link);
        self.class_known[class.0] = true;
        for &other in &self.network.members[class.0] {
            if other != link {
                let turn = self.network.turn_between(other, link);
                self.push(Lock {
                    link: other,
                    to: link,
                    turn,
                });
            }
        }
    }

    fn learn_point(&mut self, point: PointId) {
        self.point_known[point.index()] = true;
        if let Some(group) = self.groups.last_mut() {
            group.points.push(point);
        }
    }

    /// Places all points of the links that have a direction and a known point. Returns `true` if
    /// there were any.
    fn place_link_points(&mut self, links: &[LinkId]) -> bool {
        let mut any = false;
        for &link in links.iter().filter(|&&l| self.knows(l)).collect::<Vec<_>>() {
            let Some((base, at)) = self.footing(link) else {
                continue;
            };
            let is_new = !std::mem::replace(&mut self.listed[link.index()], true);
            if let (true, Some(group)) = (is_new, self.groups.last_mut()) {
                group.links.push(link);
            }
            for (point, position) in self.network.places(link) {
                if !self.point_known[point.index()] {
                    self.push(self.ride_on(link, base, point, position - at));
                    self.learn_point(point);
                    any = true;
                }
            }
        }
        any
    }

    /// Creates the step by which a point of a link follows another one; on the driven link, its
    /// pivot.
    fn ride_on(&self, link: LinkId, base: PointId, point: PointId, local: Vec2<Constant>) -> Step {
        let is_driven = self.network.is_crank(link);
        let on_ground = self
            .network
            .mechanism
            .points()
            .get(base.index())
            .is_some_and(|p| p.ground.is_some());
        if is_driven && on_ground {
            let pivot = base;
            Step::from(Spin {
                point,
                pivot,
                local,
            })
        } else {
            Step::from(Ride {
                point,
                base,
                link,
                local,
            })
        }
    }

    /// Determines the direction of a link with two known points. Returns `true` if there was one.
    fn aim_links(&mut self, links: &[LinkId]) -> bool {
        for &link in links
            .iter()
            .filter(|&&l| !self.knows(l))
            .collect::<Vec<_>>()
        {
            let known: Vec<_> = self
                .network
                .joints(link)
                .map(|m| m.point)
                .filter(|p| self.point_known[p.index()])
                .take(2)
                .collect();
            if let [from, end] = known[..]
                && let Some(local) = self.network.between(link, from, end)
            {
                let arm = Arm::new(from, link, local);
                self.push(Aim { arm, end });
                self.learn_class(link);
                return true;
            }
        }
        false
    }

    /// Determines the direction of a link turned by an input relative to a known one, or of the
    /// link that carries its motor. Returns `true` if there was one.
    fn turn_elbows(&mut self, elbows: &[LinkId]) -> bool {
        for &turned in elbows {
            let [link, from] = self.network.elbow(turned);
            let is_seat = match (self.knows(link), self.knows(from)) {
                (false, true) => false,
                (true, false) => true,
                _ => continue,
            };
            let [link, from] = if is_seat { [from, link] } else { [link, from] };
            self.push(Elbow {
                link,
                from,
                is_seat,
                following: self.network.following(Input::Turn(turned)).cloned(),
            });
            self.learn_class(link);
            return true;
        }
        false
    }

    /// Places the point of a driven slide with a known guide. Returns `true` if there was one.
    fn push_slides(&mut self, slides: &[SlideId]) -> bool {
        let mechanism = self.network.mechanism;
        let mut pushed = slides.iter().filter(|&&slide| mechanism.is_pushed(slide));
        pushed.any(|&slide| self.push_slide(slide))
    }

    fn push_slide(&mut self, slide: SlideId) -> bool {
        let given = self.network.mechanism.slide(slide);
        let point = given.slider.point();
        if self.point_known[point.index()] {
            return false;
        }
        let Some(line) = self.line(slide) else {
            return false;
        };
        let (base, link, along) = (line.through, line.link, line.along);
        self.push(Push {
            point,
            base,
            link,
            along,
            slide,
            following: self.network.following(Input::Push(slide)).cloned(),
        });
        self.learn_point(point);
        true
    }

    // ---- blocks

    fn determine_block(&mut self, block: &CoupledBlock) -> Result<(), Fault> {
        let scope = self.scope(block);
        while self.determine_known(&scope) {}
        while self.aim_links(&scope.links) || self.dyad(&scope) {
            while self.determine_known(&scope) {}
        }
        if self.is_settled(&scope) {
            Ok(())
        } else {
            self.couple(block, &scope)
        }
    }

    /// Determines unknowns that follow directly from known ones, including inputs. Returns `true`
    /// if there were any.
    fn determine_known(&mut self, scope: &Scope) -> bool {
        self.place_link_points(&scope.links)
            || self.push_slides(&scope.slides)
            || self.turn_elbows(&scope.elbows)
    }

    fn dyad(&mut self, scope: &Scope) -> bool {
        match self.dyads {
            Dyads::AsRows => false,
            Dyads::Closed => {
                self.circles(scope)
                    || self.circle_line(scope)
                    || self.swing(scope)
                    || self.cylinder(scope)
                    || self.lines(scope)
            }
        }
    }

    fn is_settled(&self, scope: &Scope) -> bool {
        scope.points.iter().all(|p| self.point_known[p.index()])
            && scope.classes.iter().all(|c| self.class_known[c.0])
    }

    fn scope(&self, block: &CoupledBlock) -> Scope {
        let mut scope = Scope::default();
        for &unknown in &block.unknowns {
            match unknown {
                ScalarUnknown::Point(point) => scope.points.push(point),
                ScalarUnknown::Class(class) => scope.classes.push(class),
            }
        }
        for &row in &block.rows {
            match row {
                ScalarEquation::Along { link, .. } | ScalarEquation::Across { link, .. } => {
                    scope.links.push(link)
                }
                ScalarEquation::Slot(slide) | ScalarEquation::Push(slide) => {
                    scope.slides.push(slide)
                }
                ScalarEquation::Elbow(link) => scope.elbows.push(link),
            }
        }
        // Riders: the links of a point or a class determined here, even if they add no equation.
        for class in &scope.classes {
            scope.links.extend(&self.network.members[class.0]);
        }
        for &point in &scope.points {
            let links = &self.network.mechanism.point(point).links;
            scope.links.extend(
                links
                    .iter()
                    .filter(|&&l| self.knows(l) || scope.classes.contains(&self.network.class(l))),
            );
        }
        let mechanism = self.network.mechanism;
        scope
            .links
            .sort_unstable_by_key(|&link| mechanism.link_rank(link));
        scope.links.dedup();
        let rank = |slide: SlideId| mechanism.point_rank(mechanism.slide(slide).slider.point());
        scope
            .slides
            .sort_unstable_by_key(|&slide| (rank(slide), slide));
        scope.slides.dedup();
        scope
    }

    // ---- the remainder

    /// Returns the links with an unknown part.
    fn unsettled_links(&self, links: &[LinkId]) -> Vec<LinkId> {
        let is_placed = |&link: &LinkId| {
            let mut joints = self.network.joints(link);
            self.knows(link) && joints.all(|m| self.point_known[m.point.index()])
        };
        links.iter().copied().filter(|l| !is_placed(l)).collect()
    }

    /// Returns the slides with an unknown part.
    fn unsettled_slides(&self, slides: &[SlideId]) -> Vec<SlideId> {
        let is_placed = |&slide: &SlideId| {
            let given = self.network.mechanism.slide(slide);
            let guide = match given.on {
                Body::Ground => true,
                Body::Link(on) => self.knows(on) && self.footing(on).is_some(),
            };
            guide && self.point_known[given.slider.point().index()]
        };
        slides.iter().copied().filter(|s| !is_placed(s)).collect()
    }

    fn couple(&mut self, block: &CoupledBlock, scope: &Scope) -> Result<(), Fault> {
        let points: Vec<PointId> = scope
            .points
            .iter()
            .copied()
            .filter(|p| !self.point_known[p.index()])
            .collect();
        let classes: Vec<ClassId> = scope
            .classes
            .iter()
            .copied()
            .filter(|c| !self.class_known[c.0])
            .collect();
        for &slide in &scope.slides {
            if self.network.mechanism.slide(slide).on == Body::Ground {
                self.line(slide);
            }
        }
        // If all blocks are one, a part of it has already been determined.
        let links = self.unsettled_links(&scope.links);
        let slides = self.unsettled_slides(&scope.slides);
        let is_open = |&link: &LinkId| {
            let [link, from] = self.network.elbow(link);
            !(self.knows(link) && self.knows(from))
        };
        let elbows: Vec<LinkId> = scope.elbows.iter().copied().filter(is_open).collect();
        let part = coupled::Remainder {
            network: self.network,
            point_known: &self.point_known,
            class_known: &self.class_known,
            points: &points,
            classes: &classes,
            links: &links,
            slides: &slides,
            elbows: &elbows,
            guide_points: &self.guide_points,
        };
        let singular = || Fault::Singular {
            elements: order::elements(&block.rows),
            is_here_only: false,
        };
        let group = Coupled::new(&part).ok_or_else(singular)?;
        let kind = GroupKind::Coupled {
            unknowns: group.unknowns(),
        };
        let mechanism = self.network.mechanism;
        let named = points
            .iter()
            .copied()
            .min_by_key(|&point| mechanism.point_rank(point));
        self.open_group(kind, named);
        self.push(Step::Coupled {
            index: self.program.coupled.len(),
        });
        for &link in group.turning() {
            self.learn_class(link);
        }
        for &point in &points {
            self.learn_point(point);
        }
        self.program.coupled.push(group);
        while self.place_link_points(&scope.links) || self.aim_links(&scope.links) {}
        if self.is_settled(scope) {
            Ok(())
        } else {
            Err(singular())
        }
    }
}
