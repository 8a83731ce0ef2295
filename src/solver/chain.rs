//! From blocks of unknowns to elementary steps: dyads are recognised, what is left is coupled.
//!
//! Inside a block a joint of a link that has a known point but an unknown direction lies on a
//! circle about that point: it is *anchored* there. A joint anchored by two classes of links is an
//! RRR dyad; one that also lies on a known line, RRP; a guide whose body turns about a known point
//! and passes through one, RPR; two known lines, PRP or RPP.

use super::coupled::{self, Coupled};
use super::fault::Fault;
use super::frame::Frame;
use super::network::{ClassId, GROUND, Network, Row, Unknown};
use super::order::{self, Block, Ordering};
use super::plan::{Gauge, Group, GroupKind, Plan, Program, Watch};
use super::state::{LinkState, PointState};
use super::step::{Arm, CircleLine, CircleRail, Circles, Cylinder, Line, Step, Swing};
use crate::{Body, Element, Input, LinkId, PointId, SlideId, Vec2};

/// A joint at a fixed place of a class whose direction is not known yet.
#[derive(Clone, Copy, Debug)]
struct Anchor {
    point: PointId,
    class: ClassId,
    pivot: PointId,
    /// From the pivot to the point, in the frame of the class.
    arm: Vec2,
    /// A link of the class that ends at the point.
    link: LinkId,
}

/// A slide that holds a joint on a known line.
#[derive(Clone, Copy, Debug)]
struct Hold {
    slide: SlideId,
    /// The link between the joint and the slide, if the joint is not the sliding point itself.
    carrier: Option<LinkId>,
    /// Whether it is the guide that moves with the joint, over a point that is known.
    is_yoke: bool,
}

/// The links and slides that a block's equations are about.
#[derive(Default)]
struct Scope {
    points: Vec<PointId>,
    classes: Vec<ClassId>,
    links: Vec<LinkId>,
    slides: Vec<SlideId>,
}

/// Builds the program block by block.
pub(super) struct Chain<'n> {
    network: &'n Network<'n>,
    frame: Frame,
    point_known: Vec<bool>,
    class_known: Vec<bool>,
    /// Whether a link stands in its group already.
    listed: Vec<bool>,
    program: Program,
    groups: Vec<Group>,
    /// Points of guides in the ground.
    constants: Vec<PointId>,
    /// The point of a guide that goes with its body, once it was needed.
    guide_points: Vec<Option<PointId>>,
}

/// Turns the ordered blocks into a plan and a program.
///
/// # Errors
/// [`Fault::Singular`] where a block's equations cannot settle its unknowns.
pub(super) fn build(
    network: &Network<'_>,
    frame: Frame,
    ordering: &Ordering,
) -> Result<(Plan, Program), Fault> {
    let mut chain = Chain::new(network, frame);
    chain.drive();
    for block in &ordering.blocks {
        chain.settle_block(block)?;
    }
    chain.watch(&ordering.set_aside);
    chain.travels();
    chain.program.group_starts.push(chain.program.steps.len());
    let mut redundant = order::elements(&ordering.set_aside);
    redundant.extend(network.repeated_locks.iter().map(|&s| Element::Slide(s)));
    let plan = Plan {
        groups: chain.groups,
        mobility: 1,
        redundant,
    };
    Ok((plan, chain.program))
}

impl<'n> Chain<'n> {
    fn new(network: &'n Network<'n>, frame: Frame) -> Self {
        let mechanism = network.mechanism;
        let place = |p: &crate::Point| PointState {
            p: p.ground.map_or(Vec2::ZERO, |g| frame.inner(g)),
            ..PointState::default()
        };
        let points: Vec<PointState> = mechanism.points().iter().map(place).collect();
        let mut links = vec![LinkState::FIXED; network.class_of.len()];
        for &link in &network.members[GROUND.0] {
            links[link.index()].d = network.turn[link.index()];
        }
        let mut class_known = vec![false; network.members.len()];
        class_known[GROUND.0] = true;
        Chain {
            network,
            frame,
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
            },
            groups: Vec::new(),
            constants: Vec::new(),
            guide_points: vec![None; mechanism.slides().len()],
        }
    }

    // ---- small facts

    fn knows(&self, link: LinkId) -> bool {
        self.class_known[self.network.class(link).0]
    }

    fn local(&self, link: LinkId, point: PointId) -> Option<Vec2> {
        let local = self.network.link(link)?.local(point)?;
        Some(self.frame.local(local))
    }

    /// A known point of a link, with its place in the link.
    fn footing(&self, link: LinkId) -> Option<(PointId, Vec2)> {
        let members = &self.network.link(link)?.members;
        let known = members.iter().find(|m| self.point_known[m.point.index()])?;
        Some((known.point, self.frame.local(known.local)))
    }

    /// A point that is not the scene's: constant, or given its place by a step.
    fn new_point(&mut self, p: Vec2) -> PointId {
        self.program.points.push(PointState {
            p,
            ..PointState::default()
        });
        self.point_known.push(true);
        PointId::new(self.program.points.len() - 1)
    }

    fn push(&mut self, step: Step) {
        self.program.steps.push(step);
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
        match self.network.mechanism.driver().input {
            Input::Turn(link) => {
                self.push(Step::Crank { link });
                self.learn_class(link);
                self.settle_links(&self.network.members[self.network.class(link).0].clone());
            }
            Input::Push(_) => {}
        }
        let ground = self.network.members[GROUND.0].clone();
        self.settle_links(&ground);
    }

    // ---- what follows at once from what is known

    /// A link's direction is known now: so are those of its whole class.
    fn learn_class(&mut self, link: LinkId) {
        let class = self.network.class(link);
        self.class_known[class.0] = true;
        for &other in &self.network.members[class.0] {
            if other != link {
                let turn = self.network.turn_between(other, link);
                self.push(Step::Lock {
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

    /// All points of the links that have a direction and a known point.
    fn settle_links(&mut self, links: &[LinkId]) -> bool {
        let mut any = false;
        for &link in links.iter().filter(|&&l| self.knows(l)).collect::<Vec<_>>() {
            let (Some((base, at)), Some(body)) = (self.footing(link), self.network.link(link))
            else {
                continue;
            };
            let is_new = !std::mem::replace(&mut self.listed[link.index()], true);
            if let (true, Some(group)) = (is_new, self.groups.last_mut()) {
                group.links.push(link);
            }
            for member in &body.members {
                if !self.point_known[member.point.index()] {
                    let local = self.frame.local(member.local) - at;
                    self.push(self.ride_on(link, base, member.point, local));
                    self.learn_point(member.point);
                    any = true;
                }
            }
        }
        any
    }

    /// How a point of a link follows from another one; on the driven link, from its pivot.
    fn ride_on(&self, link: LinkId, base: PointId, point: PointId, local: Vec2) -> Step {
        let is_driven = self.network.mechanism.driver().input == Input::Turn(link);
        let on_ground = self
            .network
            .mechanism
            .points()
            .get(base.index())
            .is_some_and(|p| p.ground.is_some());
        if is_driven && on_ground {
            Step::Spin {
                point,
                pivot: base,
                local,
            }
        } else {
            Step::Ride {
                point,
                base,
                link,
                local,
            }
        }
    }

    /// The directions of links with two known points.
    fn aim_links(&mut self, links: &[LinkId]) -> bool {
        for &link in links
            .iter()
            .filter(|&&l| !self.knows(l))
            .collect::<Vec<_>>()
        {
            let known: Vec<_> = self
                .network
                .joints(link)
                .filter(|m| self.point_known[m.point.index()])
                .take(2)
                .collect();
            if let [from, to] = known[..] {
                let arm = Arm::new(
                    from.point,
                    link,
                    self.frame.local(to.local) - self.frame.local(from.local),
                );
                self.push(Step::Aim { arm, end: to.point });
                self.learn_class(link);
                return true;
            }
        }
        false
    }

    /// A driven slide whose guide is known places its point.
    fn push_slide(&mut self, slides: &[SlideId]) -> bool {
        let Input::Push(slide) = self.network.mechanism.driver().input else {
            return false;
        };
        let given = self.network.mechanism.slide(slide);
        let point = given.slider.point();
        if !slides.contains(&slide) || self.point_known[point.index()] {
            return false;
        }
        let Some(line) = self.line(slide) else {
            return false;
        };
        let (base, link, along) = (line.through, line.link, line.along);
        self.push(Step::Push {
            point,
            base,
            link,
            local: Vec2::ZERO,
            along,
        });
        self.learn_point(point);
        true
    }

    // ---- guides

    /// The guide of a slide, if its body is placed.
    fn line(&mut self, slide: SlideId) -> Option<Line> {
        let given = self.network.mechanism.slide(slide);
        let link = self.network.body(given.on);
        let along = given.direction;
        if let Some(through) = self.guide_points[slide.index()] {
            return Some(Line {
                through,
                link,
                along,
            });
        }
        let through = match given.on {
            Body::Ground => {
                let constant = self.new_point(self.frame.inner(given.through));
                self.constants.push(constant);
                constant
            }
            Body::Link(on) => {
                let (base, at) = self.knows(on).then(|| self.footing(on)).flatten()?;
                let local = self.frame.local(given.through) - at;
                if local == Vec2::ZERO {
                    base
                } else {
                    self.ride(base, on, local)
                }
            }
        };
        self.guide_points[slide.index()] = Some(through);
        Some(Line {
            through,
            link,
            along,
        })
    }

    /// The place and the direction of a line that never moves: of the ground itself, through a point
    /// that no step places.
    fn rail(&self, line: &Line) -> Option<[Vec2; 2]> {
        let is_constant = self.constants.contains(&line.through);
        (line.link == self.network.ground() && is_constant)
            .then(|| [self.program.points[line.through.index()].p, line.along])
    }

    /// A helping point that rides at `local` from `base` on a link.
    fn ride(&mut self, base: PointId, link: LinkId, local: Vec2) -> PointId {
        let point = self.new_point(Vec2::ZERO);
        self.push(Step::Ride {
            point,
            base,
            link,
            local,
        });
        point
    }

    // ---- blocks

    fn settle_block(&mut self, block: &Block) -> Result<(), Fault> {
        let scope = self.scope(block);
        while self.settle_links(&scope.links) || self.push_slide(&scope.slides) {}
        loop {
            let moved = self.aim_links(&scope.links)
                || self.circles(&scope)
                || self.circle_line(&scope)
                || self.swing(&scope)
                || self.cylinder(&scope)
                || self.lines(&scope);
            if !moved {
                break;
            }
            while self.settle_links(&scope.links) || self.push_slide(&scope.slides) {}
        }
        if self.is_settled(&scope) {
            Ok(())
        } else {
            self.couple(block, &scope)
        }
    }

    fn is_settled(&self, scope: &Scope) -> bool {
        scope.points.iter().all(|p| self.point_known[p.index()])
            && scope.classes.iter().all(|c| self.class_known[c.0])
    }

    fn scope(&self, block: &Block) -> Scope {
        let mut scope = Scope::default();
        for &unknown in &block.unknowns {
            match unknown {
                Unknown::Point(point) => scope.points.push(point),
                Unknown::Class(class) => scope.classes.push(class),
            }
        }
        for &row in &block.rows {
            match row {
                Row::Along { link, .. } | Row::Across { link, .. } => scope.links.push(link),
                Row::Slot(slide) | Row::Push(slide) => scope.slides.push(slide),
            }
        }
        // Riders: the links of a point or a class that is settled here, even if they add no equation.
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
        scope.links.sort_unstable();
        scope.links.dedup();
        scope.slides.sort_unstable();
        scope.slides.dedup();
        scope
    }

    /// Every joint of the scope that is anchored, link after link of the same class.
    fn anchors(&self, scope: &Scope) -> Vec<Anchor> {
        let mut anchors: Vec<Anchor> = Vec::new();
        for &link in scope.links.iter().filter(|&&l| !self.knows(l)) {
            if let Some((pivot, at)) = self.footing(link) {
                self.anchor_joints(link, pivot, at, Vec2::ZERO, &mut anchors);
            }
        }
        let mut next = 0;
        while next < anchors.len() {
            let Anchor {
                point,
                class,
                pivot,
                arm,
                link,
            } = anchors[next];
            let others = scope
                .links
                .iter()
                .filter(|&&l| l != link && self.network.class(l) == class);
            for &other in others {
                if let Some(at) = self.local(other, point) {
                    self.anchor_joints(other, pivot, at, arm, &mut anchors);
                }
            }
            next += 1;
        }
        anchors
    }

    /// Anchors the joints of `link`, one of whose places, `at`, is seen from the pivot along `arm`.
    fn anchor_joints(
        &self,
        link: LinkId,
        pivot: PointId,
        at: Vec2,
        arm: Vec2,
        anchors: &mut Vec<Anchor>,
    ) {
        let class = self.network.class(link);
        let turn = self.network.turn[link.index()];
        for joint in self.network.joints(link) {
            let seen = |a: &Anchor| a.point == joint.point && a.class == class;
            if self.point_known[joint.point.index()] || anchors.iter().any(seen) {
                continue;
            }
            let arm = arm + (self.frame.local(joint.local) - at).turned(turn);
            anchors.push(Anchor {
                point: joint.point,
                class,
                pivot,
                arm,
                link,
            });
        }
    }

    fn arm(&self, anchor: &Anchor) -> Arm {
        let turn = self.network.turn[anchor.link.index()];
        Arm::new(anchor.pivot, anchor.link, anchor.arm.turned(turn.conj()))
    }

    // ---- dyads

    /// RRR: a joint anchored by two classes.
    fn circles(&mut self, scope: &Scope) -> bool {
        let anchors = self.anchors(scope);
        let pair = anchors.iter().enumerate().find_map(|(i, a)| {
            let b = anchors[..i]
                .iter()
                .find(|b| b.point == a.point && b.class != a.class)?;
            Some((*b, *a))
        });
        let Some((a, b)) = pair else { return false };
        let arms = [self.arm(&a), self.arm(&b)];
        let group = self.open_group(GroupKind::Rrr, Some(a.point));
        self.push(Step::Circles(Circles::new(a.point, arms, group)));
        self.learn_point(a.point);
        self.learn_class(a.link);
        self.learn_class(b.link);
        true
    }

    /// RRP: an anchored joint on a known line.
    fn circle_line(&mut self, scope: &Scope) -> bool {
        for anchor in self.anchors(scope) {
            let point = anchor.point;
            let Some(&hold) = self.holds(point, scope).first() else {
                continue;
            };
            let helpers = self.program.steps.len();
            let Some(line) = self.line_through(point, hold) else {
                continue;
            };
            let arm = self.arm(&anchor);
            let group = self.open_group(GroupKind::Rrp, Some(point));
            self.program.group_starts[group] = helpers;
            let rail = self.rail(&line);
            self.push(match rail {
                Some(rail) => Step::CircleRail(CircleRail::new(point, arm, rail, group)),
                None => Step::CircleLine(CircleLine::new(point, arm, line, group)),
            });
            self.learn_point(point);
            self.learn_class(anchor.link);
            return true;
        }
        false
    }

    /// The slides of the scope whose point is merely on the guide.
    fn slots(&self, scope: &Scope) -> Vec<SlideId> {
        let driven = self.network.mechanism.driver().input;
        scope
            .slides
            .iter()
            .copied()
            .filter(|&s| driven != Input::Push(s))
            .collect()
    }

    /// RPR: a guide that turns about a known point and passes through one.
    fn swing(&mut self, scope: &Scope) -> bool {
        let anchors = self.anchors(scope);
        for &slide in self.slots(scope).iter() {
            let given = self.network.mechanism.slide(slide);
            let Body::Link(link) = given.on else { continue };
            let Some((pivot, at)) = self.footing(link).filter(|_| !self.knows(link)) else {
                continue;
            };
            let class = self.network.class(link);
            let point = given.slider.point();
            // Where the sliding point is: known, or anchored in the guide's own class.
            let (pin, arm) = if self.point_known[point.index()] {
                (point, Vec2::ZERO)
            } else if let Some(anchor) = anchors
                .iter()
                .find(|a| a.point == point && a.class == class && a.pivot != pivot)
            {
                let turn = self.network.turn[link.index()];
                (anchor.pivot, anchor.arm.turned(turn.conj()))
            } else {
                continue;
            };
            let along = given.direction;
            let offset = along.perp().dot(self.frame.local(given.through) - at - arm);
            let group = self.open_group(GroupKind::Rpr, Some(pin));
            self.push(Step::Swing(Swing {
                pivot,
                pin,
                link,
                along,
                offset,
                group,
            }));
            self.learn_class(link);
            return true;
        }
        false
    }

    /// RRR with a driven slide as one arm: a cylinder between moving links.
    fn cylinder(&mut self, scope: &Scope) -> bool {
        let Input::Push(slide) = self.network.mechanism.driver().input else {
            return false;
        };
        let given = self.network.mechanism.slide(slide);
        let Body::Link(link) = given.on else {
            return false;
        };
        let point = given.slider.point();
        let Some((pivot, at)) = self.footing(link).filter(|_| !self.knows(link)) else {
            return false;
        };
        if !scope.slides.contains(&slide) {
            return false;
        }
        let anchors = self.anchors(scope);
        let class = self.network.class(link);
        let Some(anchor) = anchors
            .iter()
            .find(|a| a.point == point && a.class != class)
        else {
            return false;
        };
        let far = self.arm(anchor);
        let group = self.open_group(GroupKind::Rrr, Some(point));
        let through = self.frame.local(given.through) - at;
        let along = given.direction;
        self.push(Step::Cylinder(Cylinder {
            point,
            pivot,
            link,
            through,
            along,
            far,
            group,
        }));
        self.learn_point(point);
        self.learn_class(link);
        self.learn_class(anchor.link);
        true
    }

    /// PRP and RPP: a joint whose links all have a direction, on two known lines.
    fn lines(&mut self, scope: &Scope) -> bool {
        for point in scope.points.clone() {
            let holds = self.holds(point, scope);
            let ([one, two], false) = (&holds[..], self.point_known[point.index()]) else {
                continue;
            };
            let kind = if one.is_yoke || two.is_yoke {
                GroupKind::Rpp
            } else {
                GroupKind::Prp
            };
            let helpers = self.program.steps.len();
            let lines = (
                self.line_through(point, *one),
                self.line_through(point, *two),
            );
            let (Some(first), Some(second)) = lines else {
                continue;
            };
            let group = self.open_group(kind, Some(point));
            // The helping points belong to the group, too.
            self.program.group_starts[group] = helpers;
            self.push(Step::Lines {
                point,
                first,
                second,
                group,
            });
            self.learn_point(point);
            return true;
        }
        false
    }

    /// The slides that hold a point on a known line, directly or through a link with a direction.
    fn holds(&self, point: PointId, scope: &Scope) -> Vec<Hold> {
        let links = &self.network.mechanism.point(point).links;
        let directed: Vec<LinkId> = links.iter().copied().filter(|&l| self.knows(l)).collect();
        let mut holds = Vec::new();
        for slide in self.slots(scope) {
            let given = self.network.mechanism.slide(slide);
            let on = self.network.body(given.on);
            let slider = given.slider.point();
            let is_placed =
                given.on == Body::Ground || (self.knows(on) && self.footing(on).is_some());
            let carrier = directed
                .iter()
                .copied()
                .find(|&l| self.local(l, slider).is_some());
            let is_yoke = directed.contains(&on) && self.point_known[slider.index()];
            if is_yoke {
                holds.push(Hold {
                    slide,
                    carrier: Some(on),
                    is_yoke,
                });
            } else if is_placed && slider == point {
                holds.push(Hold {
                    slide,
                    carrier: None,
                    is_yoke,
                });
            } else if is_placed && carrier.is_some() {
                holds.push(Hold {
                    slide,
                    carrier,
                    is_yoke,
                });
            }
        }
        holds
    }

    /// The line on which a held point lies: the guide, or beside it by what the carrier adds.
    fn line_through(&mut self, point: PointId, hold: Hold) -> Option<Line> {
        let Some(carrier) = hold.carrier else {
            return self.line(hold.slide);
        };
        let given = self.network.mechanism.slide(hold.slide);
        let slider = given.slider.point();
        let here = self.local(carrier, point)?;
        if hold.is_yoke {
            let local = here - self.frame.local(given.through);
            let through = self.ride(slider, carrier, local);
            return Some(Line {
                through,
                link: carrier,
                along: given.direction,
            });
        }
        let guide = self.line(hold.slide)?;
        let local = here - self.local(carrier, slider)?;
        let through = self.ride(guide.through, carrier, local);
        Some(Line { through, ..guide })
    }

    // ---- what is left

    fn couple(&mut self, block: &Block, scope: &Scope) -> Result<(), Fault> {
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
        let part = coupled::Part {
            network: self.network,
            frame: self.frame,
            point_known: &self.point_known,
            class_known: &self.class_known,
            points: &points,
            classes: &classes,
            links: &scope.links,
            slides: &scope.slides,
            guide_points: &self.guide_points,
        };
        let singular = || Fault::Singular {
            elements: order::elements(&block.rows),
        };
        let group = Coupled::new(&part).ok_or_else(singular)?;
        let kind = GroupKind::Coupled {
            unknowns: group.unknowns(),
        };
        self.open_group(kind, points.first().copied());
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
        while self.settle_links(&scope.links) || self.aim_links(&scope.links) {}
        if self.is_settled(scope) {
            Ok(())
        } else {
            Err(singular())
        }
    }

    // ---- what stands beside the groups

    /// Where constraints were set aside, all are watched, those first. Which of them the steps then
    /// leave out is theirs to choose: a link's joints may all ride on it although one of its
    /// equations was set aside, and another constraint is lost for it.
    fn watch(&mut self, set_aside: &[Row]) {
        if set_aside.is_empty() {
            return;
        }
        let network = self.network;
        let others = network.rows.iter().filter(|r| !set_aside.contains(r));
        for &row in set_aside.iter().chain(others) {
            if let Some(gauge) = self.gauge(row) {
                self.program.watches.push(Watch {
                    element: row.element(),
                    gauge,
                });
            }
        }
    }

    fn gauge(&mut self, row: Row) -> Option<Gauge> {
        match row {
            Row::Along { link, end } => {
                let (from, arm) = self.seen_from(link, end)?;
                let length = arm.norm();
                Some(Gauge::Distance {
                    from,
                    to: end,
                    length,
                })
            }
            Row::Across { link, end } => {
                let (from, arm) = self.seen_from(link, end)?;
                let along = arm / arm.norm();
                Some(Gauge::Direction {
                    from,
                    to: end,
                    link,
                    along,
                })
            }
            Row::Slot(slide) => {
                let point = self.network.mechanism.slide(slide).slider.point();
                let line = self.line(slide)?;
                Some(Gauge::OnLine { point, line })
            }
            Row::Push(slide) => {
                let point = self.network.mechanism.slide(slide).slider.point();
                let line = self.line(slide)?;
                Some(Gauge::Pushed { point, line })
            }
        }
    }

    /// Another joint of a link, and `end` as seen from there in the link's frame.
    fn seen_from(&self, link: LinkId, end: PointId) -> Option<(PointId, Vec2)> {
        let to = self.local(link, end)?;
        let other = self.network.joints(link).find(|m| m.point != end)?;
        Some((other.point, to - self.frame.local(other.local)))
    }

    fn travels(&mut self) {
        for slide in self.network.mechanism.slide_ids() {
            let point = self.network.mechanism.slide(slide).slider.point();
            if let Some(line) = self.line(slide) {
                self.push(Step::Travel { slide, point, line });
            }
        }
    }
}
