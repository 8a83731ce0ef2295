//! Krank's interpretation of a scene, as a page and as JSON.
//!
//! Each fact is computed once, with its sentences for people and its values for programs.

mod driver;
mod first_loop;
mod forces;
mod groups;
mod lead;
mod motion;
mod parts;
mod quality;
mod range;
mod stops;

pub(super) use driver::inputs_given;
pub(super) use first_loop::loop_name;
pub use lead::{followed_until, unreached};
pub(super) use motion::{TimedMotion, describe_out_of_range};
pub use range::near_misses;
pub(super) use stops::stops_json;
pub use stops::{stop_before, stop_name};

use crate::page::{Content, Facts, Page, TextStyle};
use crate::quantity::Catalogue;
use crate::scene::Scene;
use crate::solver::{Group, Solver};
use crate::wording::words;
use crate::{Body, ElementId, LinkId, PointId};
use serde::Serialize;
use serde_json::{Map, Value};

/// Widths of the labels, and of the indent of further lines of a fact.
const LABELS: usize = 11;
const CONTINUATION_INDENT: usize = 2;
/// Significant digits of a coordinate in a sentence.
const PLACES: usize = 9;

/// The keys of JSON in their order. They must stay stable.
const KEYS: [&str; 37] = [
    "scene",
    "source",
    "note",
    "unit",
    "driver",
    "motion",
    "inputs",
    "lead",
    "parameters",
    "links",
    "joints",
    "slides",
    "mobility",
    "redundant",
    "redundancies",
    "mobility_is_unclear",
    "opens_at_change_point",
    "groups",
    "choices",
    "assemblies",
    "range",
    "range_bounds",
    "period",
    "dead_points",
    "stops",
    "unmet",
    "change_points",
    "lined_up",
    "tolerance",
    "near_misses",
    "transmission",
    "condition",
    "loop",
    "figures",
    "acting",
    "dead_knots",
    "indeterminate",
];

/// The result of `krank check`: the facts in the order of the page.
#[derive(Clone, Debug)]
pub struct Check {
    scene: String,
    facts: Vec<Fact>,
}

/// A fact: a label with sentences, and values by their keys.
#[derive(Clone, Debug)]
struct Fact {
    label: &'static str,
    lines: Vec<String>,
    values: Vec<(&'static str, Value)>,
}

impl Fact {
    fn new(label: &'static str) -> Fact {
        Fact {
            label,
            lines: Vec::new(),
            values: Vec::new(),
        }
    }

    /// Creates a fact on several items: a list of values, and the lines of each item.
    fn each<L: IntoIterator<Item = String>>(
        label: &'static str,
        key: &'static str,
        items: impl IntoIterator<Item = (Value, L)>,
    ) -> Fact {
        let (values, lines): (Vec<Value>, Vec<L>) = items.into_iter().unzip();
        let fact = Fact::new(label).value(key, values);
        fact.lines(lines.into_iter().flatten())
    }

    fn lines(mut self, lines: impl IntoIterator<Item = String>) -> Fact {
        self.lines.extend(lines);
        self
    }

    fn value(mut self, key: &'static str, value: impl Serialize) -> Fact {
        // Names and finite numbers always have a JSON form.
        let value = serde_json::to_value(value).unwrap_or(Value::Null);
        self.values.push((key, value));
        self
    }

    fn values(mut self, values: Vec<(&'static str, Value)>) -> Fact {
        self.values.extend(values);
        self
    }

    /// Removes empty lists of values, which JSON leaves out.
    fn without_empty(mut self) -> Fact {
        let is_empty = |value: &Value| value.as_array().is_some_and(Vec::is_empty);
        self.values.retain(|(_, value)| !is_empty(value));
        self
    }
}

impl Check {
    /// Collects the facts.
    #[must_use]
    pub fn new(scene: &Scene, solver: &Solver) -> Check {
        let of = CheckedScene::new(scene, solver);
        let texts = [
            (words().fact_source(), "source", &scene.source),
            (words().fact_note(), "note", &scene.note),
        ];
        let texts = texts.map(|(label, key, text)| {
            let line = text.as_deref();
            let line = line.map(|text| words().translated_scene_text(text));
            Fact::new(label).lines(line).value(key, text)
        });
        let unit = Fact::new(words().fact_unit());
        let facts = [
            unit.lines([of.length.to_owned()]).value("unit", of.length),
            of.parameters(),
            of.parts(),
            of.driver(),
            of.motion(),
            of.lead(),
            of.links(),
            of.joints(),
            of.slides(),
            of.mobility(),
            of.redundancies(),
            of.groups(),
            of.choices(),
            of.assemblies(),
            of.first_loop(),
            of.range(),
            of.stops(),
            of.change_points(),
            of.lined_up(),
            of.near_misses(),
            of.transmission(),
            of.condition(),
            of.strokes(),
            of.loads(),
            of.indeterminate(),
        ];
        Check {
            scene: scene.name.clone(),
            facts: texts.into_iter().chain(facts).collect(),
        }
    }

    /// Returns the facts as JSON.
    #[must_use]
    pub fn to_json(&self) -> Value {
        let scene = ("scene", Value::from(self.scene.as_str()));
        let values = || {
            let values = self.facts.iter().flat_map(|fact| &fact.values);
            values.chain([&scene])
        };
        let pair = |key: &&str| values().find(|(own, _)| own == key).cloned();
        let pairs = KEYS.iter().filter_map(pair);
        Value::Object(
            pairs
                .map(|(key, value)| (key.to_owned(), value))
                .collect::<Map<_, _>>(),
        )
    }

    /// Formats the facts as text. `ascii` restricts titles and notes to ASCII; the rest always is.
    #[must_use]
    pub fn to_text(&self, ascii: bool) -> String {
        self.page().to_text(TextStyle::plain(ascii))
    }

    /// Returns the facts as a page of labels and sentences.
    #[must_use]
    pub fn page(&self) -> Page {
        let mut facts = Facts {
            names: LABELS,
            hanging_indent: CONTINUATION_INDENT,
            list: Vec::new(),
        };
        for fact in &self.facts {
            facts.add(fact.label, fact.lines.iter().cloned());
        }
        let mut page = Page::default();
        page.title(&words().translated_scene_text(&self.scene));
        page.add_below(Content::Facts(facts));
        page
    }
}

/// An assembled scene with its units.
pub(super) struct CheckedScene<'a> {
    scene: &'a Scene,
    solver: &'a Solver,
    /// The symbol of the unit of length.
    length: &'static str,
    /// The unit of the driver's coordinate.
    unit: String,
}

impl<'a> CheckedScene<'a> {
    pub(super) fn new(scene: &'a Scene, solver: &'a Solver) -> Self {
        CheckedScene {
            scene,
            solver,
            length: scene.unit.symbol(),
            unit: Catalogue::new(scene).driver().unit.clone(),
        }
    }

    fn link_names(&self, links: impl IntoIterator<Item = LinkId>) -> Vec<&'a str> {
        let name = |link| self.scene.link_name(link);
        links.into_iter().map(name).collect()
    }

    fn point_name(&self, point: PointId) -> &'a str {
        self.scene.point_name(point).unwrap_or_default()
    }

    fn body_name(&self, body: Body) -> &'a str {
        match body {
            Body::Ground => "ground",
            Body::Link(link) => self.scene.link_name(link),
        }
    }

    fn element_name(&self, element: ElementId) -> &'a str {
        match element {
            ElementId::Point(point) => self.scene.point_name(point).unwrap_or("a point"),
            ElementId::Link(link) => self.scene.link_name(link),
            ElementId::Slide(slide) => self.scene.slide_name(slide),
            ElementId::Driver => "driver",
        }
    }

    fn group_name(&self, group: &Group) -> &'a str {
        group_name(self.scene, group)
    }
}

/// Returns the joint after which a group is named, or its first link.
pub(super) fn group_name<'a>(scene: &'a Scene, group: &Group) -> &'a str {
    let point = group.point.and_then(|point| scene.point_name(point));
    let link = || Some(scene.link_name(*group.links.first()?));
    point.or_else(link).unwrap_or("a group")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    /// A value whose key is not listed would be missing in JSON.
    #[test]
    fn every_value_has_its_place_in_json() {
        for preset in presets::all().iter().take(6) {
            let scene = Scene::parse(preset.text, preset.name).unwrap();
            let check = Check::new(&scene, &Solver::new(&scene.mechanism).unwrap());
            let values = check.facts.iter().flat_map(|fact| &fact.values);
            let keys: Vec<&str> = values.map(|(key, _)| *key).collect();
            assert!(keys.iter().all(|key| KEYS.contains(key)), "{keys:?}");
            let json = check.to_json();
            assert_eq!(json.as_object().unwrap().len(), keys.len() + 1);
        }
    }
}
