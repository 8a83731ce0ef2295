//! Facts on parameters, links, joints, slides and mobility.

use super::{CheckedScene, Fact, PLACES};
use crate::report::text::number::{concise, significant};
use crate::solver::{Order, Redundancy};
use crate::wording::words;
use crate::{Body, PointId, SlideId, Slider, angle};
use serde_json::json;

/// Significant digits of a position in a sentence.
const DIGITS: usize = 6;
/// Significant digits of a misfit.
const MISFIT_DIGITS: usize = 2;
/// Maximum number of names in a list of repeated elements.
const MAX_NAMES: usize = 12;

impl CheckedScene<'_> {
    pub(super) fn parameters(&self) -> Fact {
        let items = self.scene.parameters.iter().map(|parameter| {
            let unit = parameter.dimension.map(|unit| unit.symbol(self.length));
            let mut value = json!({"name": parameter.name, "value": parameter.number});
            let mut text = format!("{} = ", parameter.name);
            if let Some(formula) = &parameter.formula {
                value["formula"] = json!(formula);
                text += &format!("{formula} = ");
            }
            text += &parameter.number.to_string();
            if let Some(unit) = unit {
                text += &format!(" {unit}");
                value["unit"] = json!(unit);
            }
            (value, [text])
        });
        Fact::each(words().fact_parameters(), "parameters", items).without_empty()
    }

    pub(super) fn parts(&self) -> Fact {
        let mechanism = &self.scene.mechanism;
        // A point shared by n bodies counts as n - 1 pin joints.
        let pins = self.all_joints().map(|(_, bodies)| bodies.len() - 1).sum();
        let [links, slides] = [mechanism.links().len(), mechanism.slides().len()];
        Fact::new(words().fact_parts()).lines([words().parts_and_ground(links, pins, slides)])
    }

    pub(super) fn links(&self) -> Fact {
        let links = self.link_names(self.scene.mechanism.link_ids());
        let fact = Fact::new(words().fact_links());
        fact.lines([links.join(", ")]).value("links", links)
    }

    /// Returns the points shared by two or more bodies, with these bodies.
    fn all_joints(&self) -> impl Iterator<Item = (PointId, Vec<Body>)> {
        let mechanism = &self.scene.mechanism;
        let bodies = |id| {
            let point = mechanism.point(id);
            let ground = point.ground.map(|_| Body::Ground);
            let links = point.links.iter().map(|&link| Body::Link(link));
            (id, ground.into_iter().chain(links).collect())
        };
        let all = mechanism.point_ids().map(bodies);
        all.filter(|(_, bodies): &(_, Vec<_>)| bodies.len() > 1)
    }

    pub(super) fn joints(&self) -> Fact {
        let items = self.all_joints().map(|(point, bodies)| {
            let point = self.point_name(point);
            let bodies: Vec<&str> = bodies.into_iter().map(|b| self.body_name(b)).collect();
            let called: Vec<String> = bodies.iter().map(|b| words().body_called(b)).collect();
            let text = format!("{point}: {}", called.join(", "));
            (json!({"point": point, "bodies": bodies}), [text])
        });
        Fact::each(words().fact_joints(), "joints", items)
    }

    pub(super) fn slides(&self) -> Fact {
        let mechanism = &self.scene.mechanism;
        let mut opening = self.solver.state();
        let _ = (self.solver).solve(mechanism.driver().start, Order::Position, &mut opening);
        let mut bounds = self.solver.enclosure();
        self.solver
            .enclose(&mut opening, Order::Position, &mut bounds);
        let negative = |id| {
            let (travel, enclosed) = opening.travel(id).zip(bounds.travel(id))?;
            // Also `false` for a bound of NaN, which determines no sign.
            let is_negative = enclosed.position.mid + enclosed.position.radius < 0.0;
            is_negative.then_some(travel.position)
        };
        let items = mechanism.slide_ids().map(|id| {
            let slide = mechanism.slide(id);
            let [name, on] = [self.scene.slide_name(id), self.body_name(slide.on)];
            let called = words().body_called(on);
            let (kind, slider, text) = match slide.slider {
                Slider::Pin(point) => {
                    let point = self.point_name(point);
                    ("pin", point, words().pin_in_slot(name, point, &called))
                }
                Slider::Link { link, .. } => {
                    let link = self.scene.link_name(link);
                    ("link", link, words().link_along(name, link, &called))
                }
            };
            let remark = negative(id).and_then(|position| self.backwards(id, position));
            let value = json!({"name": name, "kind": kind, "slider": slider, "on": on});
            (value, [text].into_iter().chain(remark))
        });
        Fact::each(words().fact_slides(), "slides", items)
    }

    /// Returns the remark on a slide with a negative position, with the guide angle that would make
    /// it positive. Lecture notes give the vector of a slide a positive length. Returns `None` for
    /// a driven slide, since its driver sets the sign.
    fn backwards(&self, id: SlideId, position: f64) -> Option<String> {
        let mechanism = &self.scene.mechanism;
        if mechanism.is_pushed(id) {
            return None;
        }
        let slide = mechanism.slide(id);
        // In the range used for directions in tables.
        let theta = angle::wrapped(slide.angle);
        let other = angle::wrapped(slide.angle + angle::TURN / 2.0);
        Some(words().slide_counts_backwards(
            self.scene.slide_name(id),
            &significant(position, DIGITS),
            self.length,
            [&concise(slide.angle, PLACES), &concise(other, PLACES)],
            (slide.on == Body::Ground).then_some(&concise(theta, PLACES)),
        ))
    }

    pub(super) fn mobility(&self) -> Fact {
        let (plan, rank) = (self.solver.plan(), self.solver.rank());
        let redundant = plan.redundant.iter().map(|&e| self.element_name(e));
        let redundant: Vec<&str> = redundant.collect();
        let constraints = rank.redundancies.iter().map(|r| r.constraints).sum();
        let text = match redundant.is_empty() {
            true => plan.mobility.to_string(),
            false => words().mobility_set_aside(&plan.mobility, constraints, &redundant.join(", ")),
        };
        let unclear = rank.is_unclear.then(|| words().mobility_not_certain());
        let lower = (rank.is_lower_at_start).then(|| words().mobility_more_at_opening());
        let notes = unclear.into_iter().chain(lower).map(str::to_owned);
        Fact::new(words().fact_mobility())
            .lines([text].into_iter().chain(notes))
            .value("mobility", plan.mobility)
            .value("redundant", redundant)
            .value("mobility_is_unclear", rank.is_unclear)
            .value("opens_at_change_point", rank.is_lower_at_start)
    }

    pub(super) fn redundancies(&self) -> Fact {
        let items = self.solver.rank().redundancies.iter().map(|found| {
            let &Redundancy {
                constraints,
                misfit,
                ..
            } = found;
            let element = self.element_name(found.element);
            let repeats = found.repeats.iter().map(|&e| self.element_name(e));
            let repeats: Vec<&str> = repeats.collect();
            let what = match repeats.get(MAX_NAMES) {
                _ if repeats.is_empty() => words().repeats_others(element),
                None => words().repeats(element, &repeats.join(", ")),
                Some(_) => {
                    let some = repeats[..MAX_NAMES].join(", ");
                    let more = repeats.len() - MAX_NAMES;
                    words().repeats(element, &words().some_and_more(&some, more))
                }
            };
            let size = format!("{} {}", concise(misfit, MISFIT_DIGITS), self.length);
            let value = json!({
                "element": element,
                "constraints": constraints,
                "repeats": repeats,
                "misfit": misfit,
            });
            (value, [words().disagree_by(&what, &size)])
        });
        Fact::each(words().fact_redundant(), "redundancies", items)
    }
}
