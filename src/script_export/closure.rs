//! Closes coupled groups in a script: several links with common unknowns and residuals.

use super::placement::{ScriptPlacement, ScriptStep};
use super::terms::{ScriptTerm, number};
use crate::solver::Order;
use crate::{Body, Input, LinkId, PointId, SlideId, Slider};

/// A coupled group, closed by Newton's method.
pub(super) struct Closure {
    /// The name of the list of unknowns.
    pub(super) name: String,
    /// The unknowns at the scene's start.
    pub(super) seeds: Vec<f64>,
    /// The residuals.
    pub(super) misfits: Vec<ScriptResidual>,
}

/// A residual of a closure.
pub(super) enum ScriptResidual {
    /// A complex term, whose both parts must be zero.
    Both(ScriptTerm),
    /// A real term, which must be zero.
    One(ScriptTerm),
}

/// The pose of a link, in terms of the unknowns.
#[derive(Clone)]
struct LinkPose {
    /// A reference point of the link and its place, from which the other points are computed.
    seen_from: Option<(PointId, ScriptTerm)>,
    direction: ScriptTerm,
}

/// The unknowns of a group.
struct Unknowns {
    link_poses: Vec<(LinkId, LinkPose)>,
    /// Pins that are not on any link of the group.
    pins: Vec<(PointId, ScriptTerm)>,
    seeds: Vec<f64>,
}

impl ScriptPlacement<'_> {
    /// Closes the rest of a group by Newton's method.
    pub(super) fn solve_rest_by_newton(&mut self, links: &[LinkId], points: &[PointId]) {
        let unknowns = self.unknowns(links, points, "z");
        if unknowns.seeds.is_empty() {
            return;
        }
        let misfits = self.misfits(&unknowns);
        let name = self.names.fresh("z_closed");
        let found = self.unknowns(links, points, &name);
        self.steps.push(ScriptStep::Close(Closure {
            name,
            seeds: found.seeds,
            misfits,
        }));
        for (point, place) in found.pins {
            self.place_point(point, place);
        }
        for (link, link_pose) in found.link_poses {
            if !self.is_aimed(link) {
                self.aim(link, link_pose.direction);
            }
            if let Some((point, place)) = link_pose.seen_from {
                if !self.is_known(point) {
                    self.place_point(point, place);
                }
                self.hold(link, point);
            }
        }
    }

    /// Returns the unknowns of the unplaced links, as elements of the list `list`.
    fn unknowns(&self, links: &[LinkId], points: &[PointId], list: &str) -> Unknowns {
        let mut workspace = self.solver.state();
        let start = self.mechanism().driver().start;
        let _ = self.solver.solve(start, Order::Position, &mut workspace);
        let state = workspace.state().known();
        let mut seeds: Vec<f64> = Vec::new();
        let mut next = |seed: f64| {
            seeds.push(if seed.is_finite() { seed } else { 0.0 });
            self.language.element(list, seeds.len() - 1)
        };
        let mut link_poses = Vec::new();
        for &link in links.iter().filter(|&&link| !self.is_placed(link)) {
            let known = self.known_member(link);
            let seen_from = known.or_else(|| self.members(link).first().copied());
            let seen_from = seen_from.map(|point| {
                let place = match known {
                    Some(_) => self.point(point),
                    None => {
                        let at = state.position(point);
                        ScriptTerm::of(format!("complex({}, {})", next(at.x), next(at.y)))
                    }
                };
                (point, place)
            });
            let direction = match self.direction_of(link) {
                Some(direction) => direction,
                None => ScriptTerm::of(format!("turn({})", next(state.angle(link)))),
            };
            link_poses.push((
                link,
                LinkPose {
                    seen_from,
                    direction,
                },
            ));
        }
        let carried = |p: PointId| links.iter().any(|&link| self.members(link).contains(&p));
        let alone = points
            .iter()
            .copied()
            .filter(|&p| !self.is_known(p) && !carried(p) && self.is_named(p));
        let pins = alone
            .map(|point| {
                let at = state.position(point);
                let place = format!("complex({}, {})", next(at.x), next(at.y));
                (point, ScriptTerm::of(place))
            })
            .collect();
        Unknowns {
            link_poses,
            pins,
            seeds,
        }
    }

    fn misfits(&self, unknowns: &Unknowns) -> Vec<ScriptResidual> {
        let mut misfits = Vec::new();
        let mut placed: Vec<(PointId, ScriptTerm)> = unknowns.pins.clone();
        for (link, link_pose) in &unknowns.link_poses {
            let Some((seen_from, _)) = link_pose.seen_from else {
                continue;
            };
            for point in self.members(*link) {
                let place = self.place_on_link(*link, link_pose, self.local(*link, point));
                let other = placed.iter().find(|(p, _)| *p == point);
                match other {
                    _ if self.is_known(point) && point != seen_from => {
                        misfits.push(ScriptResidual::Both(place.minus(self.point(point))));
                    }
                    Some((_, other)) => {
                        misfits.push(ScriptResidual::Both(place.minus(other.clone())))
                    }
                    None => placed.push((point, place)),
                }
            }
        }
        for id in self.mechanism().slide_ids() {
            self.misfits_of_slide(id, unknowns, &placed, &mut misfits);
        }
        for (turned, from) in self.mechanism().elbows() {
            let link_pose = |link: LinkId| unknowns.link_poses.iter().find(|(l, _)| *l == link);
            let link_poses = [turned, from].map(|link| (link_pose(link), link));
            if link_poses.iter().all(|(sought, _)| sought.is_none()) {
                continue;
            }
            let [link, from] = link_poses.map(|(sought, link)| match sought {
                Some((_, link_pose)) => Some(link_pose.direction.clone()),
                None => self.direction(Body::Link(link)),
            });
            // If both directions are known, or one follows the other, this equation is trivial.
            if let (Some(link), Some(from)) = (link, from) {
                let wanted = from.times(self.bend(turned));
                let off = format!("across({link}, {wanted})");
                misfits.push(ScriptResidual::One(ScriptTerm::of(off)));
            }
        }
        misfits
    }

    /// Returns a place on a link, in terms of the unknowns.
    fn place_on_link(&self, link: LinkId, link_pose: &LinkPose, place: ScriptTerm) -> ScriptTerm {
        match &link_pose.seen_from {
            None => place,
            Some((point, at)) => {
                let offset = place.minus(self.local(link, *point));
                at.clone().plus(link_pose.direction.clone().times(offset))
            }
        }
    }

    fn misfits_of_slide(
        &self,
        id: SlideId,
        unknowns: &Unknowns,
        placed: &[(PointId, ScriptTerm)],
        misfits: &mut Vec<ScriptResidual>,
    ) {
        let slide = self.mechanism().slide(id);
        let point = slide.slider.point();
        let link_pose = |link: LinkId| unknowns.link_poses.iter().find(|(l, _)| *l == link);
        let sought = placed.iter().find(|(p, _)| *p == point);
        let on = match slide.on {
            Body::Link(link) => link_pose(link),
            Body::Ground => None,
        };
        let sliding = match slide.slider {
            Slider::Link { link, .. } => link_pose(link),
            Slider::Pin(_) => None,
        };
        if sought.is_none() && on.is_none() && sliding.is_none() {
            return;
        }
        let place = match sought {
            Some((_, place)) => place.clone(),
            None if self.is_known(point) => self.point(point),
            None => return,
        };
        let guide = match on {
            Some((link, link_pose)) => Some((
                self.place_on_link(*link, link_pose, self.through(id)),
                link_pose.direction.clone(),
            )),
            None => self.guide_of_body(slide.on, id),
        };
        let Some((through, body)) = guide else { return };
        let along = body.clone().times(self.along(id));
        let away = place.minus(through);
        misfits.push(ScriptResidual::One(ScriptTerm::of(format!(
            "across({away}, {along})"
        ))));
        if self.mechanism().is_pushed(id) {
            let ahead = ScriptTerm::of(format!("ahead({away}, {along})"));
            let q = self.coordinate(Input::Push(id));
            misfits.push(ScriptResidual::One(ahead.minus(q)));
        }
        if let (Slider::Link { turn, .. }, Some((link, link_pose))) = (slide.slider, sliding)
            && !self.is_aimed(*link)
        {
            let wanted = body.times(ScriptTerm::of(format!(
                "turn({})",
                number(slide.angle + turn)
            )));
            let lock = format!("across({}, {wanted})", link_pose.direction);
            misfits.push(ScriptResidual::One(ScriptTerm::of(lock)));
        }
    }
}
