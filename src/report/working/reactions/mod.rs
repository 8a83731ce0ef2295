//! Writes the reactions, group by group from the last to the first: the known forces on the links
//! of a group, the equations with its reactions as unknowns, and their solution.
//!
//! Inertia is treated as a load, -m a at the centre of mass and -I α, so that every sum is 0.

pub(super) mod body;
mod reduced;
mod system;

use super::context::{Context, Draft};
use super::free_bodies::forces::point_name;
use super::free_bodies::free_body::BodyJoint::{Driver, Guide, Pin};
use super::free_bodies::free_body::{BodyForce, guided, on_link};
use crate::solver::LoadAction;
use crate::wording::words;
use crate::{Body, LinkId, PointId, SlideId, Slider, Vec2};
use body::GroupBody;

/// Writes the reactions of all groups.
pub(super) fn reactions(context: &Context<'_>, draft: &mut Draft, acted: &[LoadAction]) {
    let count = context.solver.plan().groups.len();
    let groups: Vec<String> = (0..count).rev().map(|k| context.group_text(k)).collect();
    draft.text(words().order_of_groups(&groups.join("; ")));
    for number in (0..count).rev() {
        let ranks = Ranks { context, number };
        let Some(bodies) = ranks.bodies(acted).filter(|bodies| !bodies.is_empty()) else {
            continue;
        };
        draft.section(context.group_text(number));
        if !reduced::write(context, draft, &bodies) {
            system::write(context, draft, &bodies);
        }
    }
}

/// The data known when a group is solved.
struct Ranks<'a> {
    context: &'a Context<'a>,
    number: usize,
}

impl Ranks<'_> {
    /// Returns the links of the group; `None` if a force on them is indeterminate.
    fn bodies(&self, acted: &[LoadAction]) -> Option<Vec<GroupBody>> {
        let group = self.context.solver.plan().groups.get(self.number)?;
        let links = group.links.iter();
        links.map(|&link| self.body(link, acted)).collect()
    }

    fn body(&self, link: LinkId, acted: &[LoadAction]) -> Option<GroupBody> {
        let mut body = GroupBody {
            link,
            given: Vec::new(),
            sought: Vec::new(),
        };
        for row in on_link(self.context, link, acted)? {
            self.sort(row, &mut body)?;
        }
        body.given.extend(inertia(self.context, link));
        Some(body)
    }

    /// Adds a force to the known or to the unknown ones of a link; returns `None` if it is
    /// indeterminate.
    fn sort(&self, row: BodyForce, body: &mut GroupBody) -> Option<()> {
        match row.joint {
            None => body.given.push(row),
            Some(Pin(point)) if self.is_in_later_groups(self.others(body.link, point)) => {
                body.given.push(row);
            }
            Some(Guide(slide)) if self.is_in_later_groups(self.across(body.link, slide)) => {
                body.given.push(row);
            }
            Some(Pin(point)) => match self.only_guide(body.link, point) {
                Some(slide) => self.part(row, (point, slide), body)?,
                None => body.sought.push(row),
            },
            Some(Guide(_) | Driver) => body.sought.push(row),
        }
        Some(())
    }

    /// Splits the force of a pin in a slot into the unknown force of the guide, and the known loads
    /// on the pin. Returns `None` if the force is indeterminate.
    fn part(
        &self,
        row: BodyForce,
        (point, slide): (PointId, SlideId),
        body: &mut GroupBody,
    ) -> Option<()> {
        let guide = guided(self.context, slide, 1.0)?;
        if !self.context.scene.mechanism.is_guided_alone(point) {
            let at = point_name(self.context, point);
            body.given.push(BodyForce {
                name: words().acts_at(words().column_load(), at),
                force: row.force - guide.force,
                joint: None,
                ..row
            });
        }
        body.sought.push(guide);
        Some(())
    }

    /// Returns the guide of a pin that joins a link to nothing else; `None` for any other pin.
    fn only_guide(&self, link: LinkId, point: PointId) -> Option<SlideId> {
        let mechanism = &self.context.scene.mechanism;
        let given = mechanism.point(point);
        let is_alone = given.ground.is_none() && given.links.iter().all(|&other| other == link);
        let mut guides = mechanism
            .slide_ids()
            .filter(|&slide| mechanism.slide(slide).slider == Slider::Pin(point));
        match (guides.next(), guides.next()) {
            (Some(slide), None) if is_alone => Some(slide),
            _ => None,
        }
    }

    /// Returns `true` if all of these bodies belong to later groups, whose reactions are known.
    /// Without bodies, only loads act there.
    fn is_in_later_groups(&self, others: Vec<Body>) -> bool {
        let groups = &self.context.solver.plan().groups;
        let is_later = |body: &Body| match body {
            Body::Ground => false,
            Body::Link(link) => groups
                .iter()
                .skip(self.number + 1)
                .any(|group| group.links.contains(link)),
        };
        others.iter().all(is_later)
    }

    /// Returns the other bodies at a link's pin.
    fn others(&self, link: LinkId, point: PointId) -> Vec<Body> {
        let mechanism = &self.context.scene.mechanism;
        let given = mechanism.point(point);
        let links = given.links.iter().filter(|&&other| other != link);
        let ground = given.ground.map(|_| Body::Ground);
        let slots = mechanism
            .slides()
            .iter()
            .filter(|slide| slide.slider == Slider::Pin(point))
            .map(|slide| slide.on);
        let links = links.map(|&other| Body::Link(other));
        links.chain(ground).chain(slots).collect()
    }

    /// Returns the bodies on the other side of a guide: its carrier, or its slider.
    fn across(&self, link: LinkId, slide: SlideId) -> Vec<Body> {
        let mechanism = &self.context.scene.mechanism;
        let given = mechanism.slide(slide);
        if given.on != Body::Link(link) {
            return vec![given.on];
        }
        match given.slider {
            Slider::Link { link, .. } => vec![Body::Link(link)],
            Slider::Pin(point) => {
                let mut all = self.others(link, point);
                all.retain(|body| *body != Body::Link(link));
                all
            }
        }
    }
}

/// Returns the inertia force and couple of a link; `None` if both are zero.
pub(super) fn inertia(context: &Context<'_>, id: LinkId) -> Option<BodyForce> {
    let (mechanism, state) = (&context.scene.mechanism, context.state);
    let link = mechanism.link(id);
    let force = link.com.map_or(Vec2::ZERO, |com| {
        state.acceleration(com) * (-link.mass * mechanism.metres())
    });
    let couple = -link.inertia * state.alpha(id);
    let is_any = force != Vec2::ZERO || couple != 0.0;
    let at = link.com.map(|com| state.position(com));
    is_any.then(|| BodyForce {
        couple,
        ..BodyForce::load(words().inertia(), force, at)
    })
}
