//! Recognises dyads: joints anchored about known points, joints on known lines, and the pairs of
//! these that determine a joint or a direction in closed form.
//!
//! Inside a block, take a link with a known point but an unknown direction. Each of its joints lies
//! on a circle about that point: it is *anchored* there. A joint anchored by two classes of links
//! is an RRR dyad. An anchored joint on a known line is an RRP dyad. A guide whose body turns about
//! a known point and that passes through another known point is an RPR dyad. Two known lines are a
//! PRP or RPP dyad.

use super::{Chain, Scope};
use crate::solver::elements::{
    Arm, CircleLine, CircleRail, Circles, Cylinder, GuideLine, Lines, Step, Swing,
};
use crate::solver::plan::network::ClassId;
use crate::solver::plan::{GroupKind, GuideConstraint, Leg};
use crate::{Body, Constant, Input, LinkId, PointId, SlideId, Vec2};

/// A joint at a fixed position of a class whose direction is not known yet.
#[derive(Clone, Copy, Debug)]
struct Anchor {
    point: PointId,
    class: ClassId,
    pivot: PointId,
    /// The vector from the pivot to the point, in the frame of the class.
    arm: Vec2<Constant>,
    /// A link of the class that ends at the point.
    link: LinkId,
    /// The joint with the preceding link, which is anchored itself, if the arm spans several links.
    by: Option<PointId>,
}

impl Chain<'_> {
    // ---- anchors

    /// Returns every anchored joint of the scope, following links of the same class.
    fn anchors(&self, scope: &Scope) -> Vec<Anchor> {
        let mut anchors: Vec<Anchor> = Vec::new();
        for &link in scope.links.iter().filter(|&&l| !self.knows(l)) {
            if let Some((pivot, at)) = self.footing(link) {
                self.anchor_joints(link, pivot, at, Vec2::default(), None, &mut anchors);
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
                ..
            } = anchors[next];
            let others = scope
                .links
                .iter()
                .filter(|&&l| l != link && self.network.class(l) == class);
            for &other in others {
                if let Some(at) = self.network.local(other, point) {
                    self.anchor_joints(other, pivot, at, arm, Some(point), &mut anchors);
                }
            }
            next += 1;
        }
        anchors
    }

    /// Anchors the joints of `link`. One of its positions, `at`, lies at the end of `arm` from the
    /// pivot.
    fn anchor_joints(
        &self,
        link: LinkId,
        pivot: PointId,
        at: Vec2<Constant>,
        arm: Vec2<Constant>,
        by: Option<PointId>,
        anchors: &mut Vec<Anchor>,
    ) {
        let class = self.network.class(link);
        let turn = self.network.turn[link.index()];
        for (point, position) in self.network.places(link) {
            let seen = |a: &Anchor| a.point == point && a.class == class;
            let is_sought = self.network.is_joint(point) && !self.point_known[point.index()];
            if !is_sought || anchors.iter().any(seen) {
                continue;
            }
            let arm = arm + (position - at).turned(turn);
            anchors.push(Anchor {
                point,
                class,
                pivot,
                arm,
                link,
                by,
            });
        }
    }

    fn arm(&self, anchor: &Anchor) -> Arm {
        let turn = self.network.turn[anchor.link.index()];
        Arm::new(anchor.pivot, anchor.link, anchor.arm.turned(turn.conj()))
    }

    /// Records the links of the next step's arm, if it spans several.
    fn note_legs(&mut self, anchor: &Anchor, anchors: &[Anchor]) {
        let at = self.program.steps.len();
        let mut here = *anchor;
        while let Some(by) = here.by {
            let Some(&before) = anchors
                .iter()
                .find(|a| a.point == by && a.class == anchor.class)
            else {
                return;
            };
            for (of, from) in [(here, by)]
                .into_iter()
                .chain(before.by.is_none().then_some((before, before.pivot)))
            {
                let leg = Leg {
                    arm: anchor.link,
                    link: of.link,
                    from,
                    to: of.point,
                };
                self.program.legs.push((at, leg));
            }
            here = before;
        }
    }

    /// Records the guide constraint of the next step's joint.
    fn note_hold(&mut self, hold: GuideConstraint) {
        self.program.holds.push((self.program.steps.len(), hold));
    }

    // ---- dyads

    /// Recognises RRR: a joint anchored by two classes. Returns `true` if there was one.
    pub(super) fn circles(&mut self, scope: &Scope) -> bool {
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
        self.note_legs(&a, &anchors);
        self.note_legs(&b, &anchors);
        self.push(Circles::new(a.point, arms, group));
        self.learn_point(a.point);
        self.learn_class(a.link);
        self.learn_class(b.link);
        true
    }

    /// Recognises RRP: an anchored joint on a known line. Returns `true` if there was one.
    pub(super) fn circle_line(&mut self, scope: &Scope) -> bool {
        let anchors = self.anchors(scope);
        for &anchor in &anchors {
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
            self.note_hold(hold);
            self.note_legs(&anchor, &anchors);
            self.push(match rail {
                Some(rail) => Step::from(CircleRail::new(point, arm, rail, group)),
                None => Step::from(CircleLine::new(point, arm, line, group)),
            });
            self.learn_point(point);
            self.learn_class(anchor.link);
            return true;
        }
        false
    }

    /// Returns the slides of the scope that are not driven.
    fn slots(&self, scope: &Scope) -> Vec<SlideId> {
        let slides = scope.slides.iter().copied();
        let mechanism = self.network.mechanism;
        slides.filter(|&s| !mechanism.is_pushed(s)).collect()
    }

    /// Recognises RPR: a guide that turns about a known point and passes through another. Returns
    /// `true` if there was one.
    pub(super) fn swing(&mut self, scope: &Scope) -> bool {
        let anchors = self.anchors(scope);
        for &slide in self.slots(scope).iter() {
            let given = self.network.mechanism.slide(slide);
            let Body::Link(link) = given.on else { continue };
            let Some((pivot, at)) = self.footing(link).filter(|_| !self.knows(link)) else {
                continue;
            };
            let class = self.network.class(link);
            let point = given.slider.point();
            // The sliding point is known, or anchored in the guide's own class.
            let (pin, arm, carrier) = if self.point_known[point.index()] {
                (point, Vec2::default(), None)
            } else if let Some(anchor) = anchors
                .iter()
                .find(|a| a.point == point && a.class == class && a.pivot != pivot)
            {
                let turn = self.network.turn[link.index()];
                let arm = anchor.arm.turned(turn.conj());
                (anchor.pivot, arm, Some(*anchor))
            } else {
                continue;
            };
            let along = self.network.frame.unit(given.angle);
            let offset = along.perp().dot(self.network.through(slide) - at - arm);
            let group = self.open_group(GroupKind::Rpr, Some(pin));
            self.note_hold(GuideConstraint {
                slide,
                carrier: carrier.map(|anchor| anchor.link),
                is_yoke: false,
            });
            if let Some(anchor) = carrier {
                self.note_legs(&anchor, &anchors);
            }
            self.push(Swing {
                pivot,
                pin,
                link,
                along,
                offset,
                group,
            });
            self.learn_class(link);
            return true;
        }
        false
    }

    /// Recognises RRR with a driven slide as one arm: a cylinder between moving links. Returns
    /// `true` if there was one.
    pub(super) fn cylinder(&mut self, scope: &Scope) -> bool {
        let mechanism = self.network.mechanism;
        let mut pushed = scope.slides.iter().filter(|&&s| mechanism.is_pushed(s));
        pushed.any(|&slide| self.cylinder_of(slide, scope))
    }

    fn cylinder_of(&mut self, slide: SlideId, scope: &Scope) -> bool {
        let given = self.network.mechanism.slide(slide);
        let Body::Link(link) = given.on else {
            return false;
        };
        let point = given.slider.point();
        let Some((pivot, at)) = self.footing(link).filter(|_| !self.knows(link)) else {
            return false;
        };
        let anchors = self.anchors(scope);
        let class = self.network.class(link);
        let Some(&anchor) = anchors
            .iter()
            .find(|a| a.point == point && a.class != class)
        else {
            return false;
        };
        let far = self.arm(&anchor);
        let group = self.open_group(GroupKind::Rrr, Some(point));
        self.note_legs(&anchor, &anchors);
        let through = self.network.through(slide) - at;
        let along = self.network.frame.unit(given.angle);
        self.push(Cylinder {
            point,
            pivot,
            link,
            through,
            along,
            far,
            group,
            slide,
            following: self.network.following(Input::Push(slide)).cloned(),
        });
        self.learn_point(point);
        self.learn_class(link);
        self.learn_class(anchor.link);
        true
    }

    /// Recognises PRP and RPP: a joint on two known lines, whose links all have a direction.
    /// Returns `true` if there was one.
    pub(super) fn lines(&mut self, scope: &Scope) -> bool {
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
            // The auxiliary points belong to the group as well.
            self.program.group_starts[group] = helpers;
            self.note_hold(*one);
            self.note_hold(*two);
            self.push(Lines {
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

    /// Returns the slides that constrain a point to a known line, directly or through a link with a
    /// direction.
    fn holds(&self, point: PointId, scope: &Scope) -> Vec<GuideConstraint> {
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
                .find(|&l| self.network.local(l, slider).is_some());
            let is_yoke = directed.contains(&on) && self.point_known[slider.index()];
            if is_yoke {
                holds.push(GuideConstraint {
                    slide,
                    carrier: Some(on),
                    is_yoke,
                });
            } else if is_placed && slider == point {
                holds.push(GuideConstraint {
                    slide,
                    carrier: None,
                    is_yoke,
                });
            } else if is_placed && carrier.is_some() {
                holds.push(GuideConstraint {
                    slide,
                    carrier,
                    is_yoke,
                });
            }
        }
        holds
    }

    /// Returns the line on which a constrained point lies: the guide, or a parallel displaced by
    /// the carrier.
    fn line_through(&mut self, point: PointId, hold: GuideConstraint) -> Option<GuideLine> {
        let Some(carrier) = hold.carrier else {
            return self.line(hold.slide);
        };
        let given = self.network.mechanism.slide(hold.slide);
        let slider = given.slider.point();
        let here = self.network.local(carrier, point)?;
        if hold.is_yoke {
            let local = here - self.network.through(hold.slide);
            let through = self.ride(slider, carrier, local);
            return Some(GuideLine {
                through,
                link: carrier,
                along: self.network.frame.unit(given.angle),
            });
        }
        let guide = self.line(hold.slide)?;
        let local = self.network.between(carrier, slider, point)?;
        let through = self.ride(guide.through, carrier, local);
        Some(GuideLine { through, ..guide })
    }
}
