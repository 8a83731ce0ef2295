//! Builds a coupled group: chooses its unknowns, finds a spot for every joint, and lists the
//! equations between the spots.

use super::{ArmSeat, Base, Bearing, GroupEquation, Remainder, Spot, Turning};
use crate::solver::plan::network::ClassId;
use crate::{Body, Constant, Input, LinkId, PointId, SlideId, Vec2};

/// A coupled group under construction.
pub(super) struct GroupMaker<'a> {
    part: &'a Remainder<'a>,
    pub(super) spots: Vec<(PointId, Spot)>,
    pub(super) turning: Vec<LinkId>,
    pub(super) turns: Vec<Vec2<Constant>>,
    classes: Vec<ClassId>,
    pub(super) free: usize,
    pub(super) equations: Vec<GroupEquation>,
}

impl<'a> GroupMaker<'a> {
    pub(super) fn new(part: &'a Remainder<'a>) -> Self {
        let mut builder = GroupMaker {
            part,
            spots: Vec::new(),
            turning: Vec::new(),
            turns: Vec::new(),
            classes: Vec::new(),
            free: 0,
            equations: Vec::new(),
        };
        for &class in part.classes {
            let link = part.network.members[class.0]
                .iter()
                .copied()
                .find(|&l| builder.is_frame(l));
            if let Some(link) = link {
                builder.turning.push(link);
                builder.turns.push(part.network.turn[link.index()]);
                builder.classes.push(class);
            }
        }
        builder
    }

    /// Returns `true` if a link of the group is more than a distance between two of its points.
    fn is_frame(&self, link: LinkId) -> bool {
        !self.part.network.is_bar(link)
    }

    fn local(&self, link: LinkId, point: PointId) -> Vec2<Constant> {
        let place = self.part.network.local(link, point);
        place.unwrap_or_default()
    }

    fn spot(&self, point: PointId) -> Option<Spot> {
        if self.part.point_known[point.index()] {
            return Some(Spot {
                base: Base::Known(point),
                arm: None,
                along: Vec2::default(),
                following: None,
                seat: None,
            });
        }
        self.spots
            .iter()
            .find(|(p, _)| *p == point)
            .map(|(_, spot)| spot.clone())
    }

    fn free_spot(&mut self) -> Spot {
        self.free += 1;
        Spot {
            base: Base::Free(self.free - 1),
            arm: None,
            along: Vec2::default(),
            following: None,
            seat: None,
        }
    }

    /// Returns the known link or the class with which a link turns, and the factor that rotates the
    /// link's local vectors into its frame. Returns `None` if the link's class is neither known nor
    /// an unknown of the group.
    fn turning(&self, link: LinkId) -> Option<(Turning, Vec2<Constant>)> {
        let network = self.part.network;
        let class = network.class(link);
        if self.part.class_known[class.0] {
            return Some((Turning::Known(link), Vec2::X.exactly()));
        }
        let i = self.classes.iter().position(|&c| c == class)?;
        Some((Turning::Unknown(i), network.turn[link.index()]))
    }

    /// Returns the spot at the position `local` on a link, relative to its joint `foot`. `end` is
    /// the joint at that position, if any. Returns `None` if `foot` has no spot without an arm, or
    /// if the link's direction is not part of the group.
    fn on_link(
        &self,
        link: LinkId,
        foot: PointId,
        local: Vec2<Constant>,
        end: Option<PointId>,
    ) -> Option<Spot> {
        let (turning, turn) = self.turning(link)?;
        let Spot {
            base, arm: None, ..
        } = self.spot(foot)?
        else {
            return None;
        };
        let arm = (local - self.local(link, foot)).turned(turn);
        Some(Spot {
            base,
            arm: Some((turning, arm)),
            along: Vec2::default(),
            following: None,
            seat: Some(ArmSeat { link, foot, end }),
        })
    }

    fn frames(&self) -> Vec<LinkId> {
        let links = self.part.links.iter().copied();
        links
            .filter(|&l| self.is_frame(l) && self.turning(l).is_some() && self.is_reached(l))
            .collect()
    }

    /// Returns `true` if a link has a known joint or one of the group's own. A link merely locked
    /// to one of the group's links is placed later; it would add unknowns without equations.
    fn is_reached(&self, link: LinkId) -> bool {
        !self.joints(link).is_empty()
    }

    /// Returns the known joints of a link and those of the group. All others belong to later groups
    /// only: they move with the placed link, and pass their forces to it themselves.
    fn joints(&self, link: LinkId) -> Vec<PointId> {
        let is_here =
            |p: &PointId| self.part.point_known[p.index()] || self.part.points.contains(p);
        let joints = self.part.network.joints(link).map(|m| m.point);
        joints.filter(is_here).collect()
    }

    /// Gives every joint of the group a spot: on a frame if possible, or else a free one.
    pub(super) fn place_joints(&mut self) {
        for link in self.frames() {
            let joints = self.joints(link);
            let foot = self.foot(link, &joints);
            for &point in &joints {
                let local = self.local(link, point);
                let Some(here) = self.on_link(link, foot, local, Some(point)) else {
                    continue;
                };
                match self.spot(point) {
                    _ if point == foot => {}
                    None => self.spots.push((point, here)),
                    Some(there) => self.equations.push(GroupEquation::Meeting {
                        a: here,
                        b: there,
                        pushed: None,
                    }),
                }
            }
        }
        for &point in self.part.points {
            if self.spot(point).is_none() {
                let spot = self.free_spot();
                self.spots.push((point, spot));
            }
        }
    }

    /// Returns the joint of a frame from which the other joints are measured: a known one if
    /// possible, or else a free one. Creates a free spot if neither exists.
    fn foot(&mut self, link: LinkId, joints: &[PointId]) -> PointId {
        let plain = |spot: Spot| spot.arm.is_none();
        let known = joints
            .iter()
            .copied()
            .find(|p| self.part.point_known[p.index()]);
        let placed = || {
            joints
                .iter()
                .copied()
                .find(|&p| self.spot(p).is_some_and(plain))
        };
        if let Some(foot) = known.or_else(placed) {
            return foot;
        }
        let unplaced = joints.iter().copied().find(|&p| self.spot(p).is_none());
        let foot = unplaced
            .or(joints.first().copied())
            .unwrap_or(PointId::new(0));
        debug_assert!(
            self.part
                .network
                .link(link)
                .is_some_and(|l| l.local(foot).is_some())
        );
        let spot = self.free_spot();
        // A joint on another frame's arm becomes free, with an equation that ties it to that arm.
        if let Some((_, there)) = self.spots.iter_mut().find(|(p, _)| *p == foot) {
            let arm = std::mem::replace(there, spot.clone());
            self.equations.push(GroupEquation::Meeting {
                a: spot,
                b: arm,
                pushed: None,
            });
        } else {
            self.spots.push((foot, spot));
        }
        foot
    }

    pub(super) fn list_equations(&mut self) {
        for &link in self.part.links {
            if !self.is_frame(link) && !self.part.class_known[self.part.network.class(link).0] {
                self.add_distance(link);
            }
        }
        for &slide in self.part.slides {
            self.add_slide(slide);
        }
        for &link in self.part.elbows {
            self.add_elbow(link);
        }
    }

    fn add_elbow(&mut self, turned: LinkId) {
        let network = self.part.network;
        let bearings = network.elbow(turned).map(|link| {
            let (turning, turn) = self.turning(link)?;
            Some(Bearing {
                link,
                turning,
                turn,
            })
        });
        if let [Some(link), Some(from)] = bearings {
            self.equations.push(GroupEquation::Elbow {
                link,
                from,
                following: network.following(Input::Turn(turned)).cloned(),
            });
        }
    }

    fn add_distance(&mut self, link: LinkId) {
        let ends: Vec<PointId> = self.part.network.joints(link).map(|m| m.point).collect();
        if let [from, to] = ends[..] {
            let span = self.local(link, from) - self.local(link, to);
            if let (Some(a), Some(b)) = (self.spot(from), self.spot(to)) {
                self.equations.push(GroupEquation::Distance {
                    a,
                    b,
                    span,
                    length: span.norm(),
                    bar: (link, [from, to]),
                });
            }
        }
    }

    fn add_slide(&mut self, slide: SlideId) {
        let network = self.part.network;
        let given = network.mechanism.slide(slide);
        let through = network.through(slide);
        let guide = match given.on {
            Body::Ground => self.on_ground(slide),
            Body::Link(on) => {
                let mut joints = network.joints(on).map(|m| m.point);
                joints.find_map(|foot| self.on_link(on, foot, through, None))
            }
        };
        let (Some(x), Some(q)) = (self.spot(given.slider.point()), guide) else {
            return;
        };
        let Some((turning, turn)) = self.turning(network.body(given.on)) else {
            return;
        };
        let along = network.frame.unit(given.angle).turned(turn);
        if network.mechanism.is_pushed(slide) {
            self.equations.push(GroupEquation::Meeting {
                a: x,
                b: Spot {
                    along,
                    following: network.following(Input::Push(slide)).cloned(),
                    ..q
                },
                pushed: Some(slide),
            });
        } else {
            self.equations.push(GroupEquation::Slot {
                x,
                q,
                along,
                turning,
                slide,
            });
        }
    }

    /// Returns the spot at the point of a guide on the ground.
    fn on_ground(&self, slide: SlideId) -> Option<Spot> {
        let base = Base::Known(self.part.guide_points[slide.index()]?);
        let ground = Turning::Known(self.part.network.ground());
        Some(Spot {
            base,
            arm: Some((ground, Vec2::default())),
            along: Vec2::default(),
            following: None,
            seat: None,
        })
    }
}
