//! Collects the values of a scene from its text.

use super::{Value, ValueOwner};
use crate::Input;
use crate::document::{NamedNumbers, WrittenValue, entries, items, number_of};
use crate::scene::keys::{self, KeyKind, NumberMeasure, SceneKey};
use crate::scene::numbers::measure::{Measure, MeasureUnits};
use crate::scene::numbers::rate::{self, Degree, WrittenRate};
use crate::scene::{Scene, Unit};
use std::collections::HashMap;
use std::sync::Arc;
use toml::de::DeTable;

/// Returns all values of a scene, in the order of the file.
pub(crate) fn values(scene: &Scene) -> Vec<Value> {
    let Ok(root) = DeTable::parse(scene.text()) else {
        // Parsing succeeded before, when the scene was read.
        return Vec::new();
    };
    let is_rotary = matches!(scene.mechanism.driver().input, Input::Turn(_));
    let mut collector = Collector {
        text: scene.text(),
        unit: scene.unit,
        slides: &scene.slide_names,
        is_rotary,
        driver_turns: is_rotary,
        is_torsion: false,
        owner: ValueOwner::Scene,
        counts_by_name: HashMap::new(),
        found: Vec::new(),
        named: &scene.named,
    };
    collector.table(keys::SCENE, "", root.get_ref(), "");
    collector.found
}

/// Traverses the text of a valid scene; skips everything that does not fit.
struct Collector<'t> {
    text: &'t str,
    unit: Unit,
    slides: &'t [String],
    /// Whether the input of the current table drives a link rather than a slide.
    is_rotary: bool,
    /// Whether the driver itself drives a link, even in the table of another input.
    driver_turns: bool,
    /// Whether the current table is that of a torsion spring.
    is_torsion: bool,
    /// The owner of the values found next.
    owner: ValueOwner,
    /// The number of loads or springs found so far, by name.
    counts_by_name: HashMap<String, usize>,
    found: Vec<Value>,
    /// The names available to formulas.
    named: &'t Arc<NamedNumbers>,
}

impl Collector<'_> {
    /// Collects the values of a table with the name `of`.
    fn table(&mut self, keys: &'static [SceneKey], of: &str, table: &DeTable<'_>, again: &str) {
        for (key, value) in table {
            if let Some(key) = keys::find(keys, key.get_ref()) {
                self.value(key, (of, key.name), value, again);
            }
        }
    }

    /// Collects the values of a key. Their display names begin with `of` and `name`, and end with
    /// `again`.
    fn value(
        &mut self,
        key: &SceneKey,
        (of, name): (&str, &str),
        value: &WrittenValue<'_>,
        again: &str,
    ) {
        let name = join(of, name);
        match key.kind {
            KeyKind::Text
            | KeyKind::Flag
            | KeyKind::Series(_)
            | KeyKind::Rows
            | KeyKind::Vectors
            | KeyKind::Formulas => {}
            KeyKind::Number(size, _) => self.number(name + again, size, value),
            KeyKind::Parameters => each(value, |parameter, at| {
                let size = NumberMeasure::Of(Measure::Parameter);
                self.of(ValueOwner::Parameter(parameter.to_owned()), |its| {
                    its.number(parameter.to_owned(), size, at);
                });
            }),
            KeyKind::Ends(size) => self.two(&name, ["low", "high"], again, size, value),
            KeyKind::Distances(size) => self.two(&name, ["first", "second"], again, size, value),
            KeyKind::Limits(keys) => each(value, |name, value| self.limit(keys, name, value)),
            // A point given by name has no coordinates to edit.
            KeyKind::Pair(size) => self.pair(&name, again, size, value),
            KeyKind::Rate(degree) => self.rate(&name, degree, value),
            KeyKind::Place => self.place(&name, again, value),
            KeyKind::Places => each(value, |point, at| {
                let name = join(of, point);
                self.of(ValueOwner::Element(point.to_owned()), |its| {
                    its.place(&name, again, at);
                });
            }),
            KeyKind::Steps(keys) => {
                for (number, step) in list(value).enumerate() {
                    let called = format!("{of} step {}", number + 1);
                    self.inner(keys, &called, step);
                }
            }
            KeyKind::Knots(sizes, called) => self.knots(&name, again, (sizes, called), value),
            KeyKind::Numbers(size) => {
                // `[tolerances]` has a tolerance for each point.
                let called = key.name.trim_end_matches('s');
                each(value, |point, number| {
                    let name = join(point, called);
                    self.of(ValueOwner::Element(point.to_owned()), |its| {
                        its.number(name, size, number);
                    });
                });
            }
            KeyKind::Points(size) => {
                // The suffix distinguishes a start position from the coordinates of the point.
                let start = if key.name == "start" { " start" } else { "" };
                each(value, |point, at| {
                    let name = join(of, point) + start;
                    self.of(ValueOwner::Element(point.to_owned()), |its| {
                        its.pair(&name, "", size, at);
                    });
                });
            }
            KeyKind::Table(keys) => {
                let owner = match key.name {
                    "driver" => ValueOwner::Driver,
                    _ => ValueOwner::Scene,
                };
                self.of(owner, |its| its.inner(keys, key.name, value));
            }
            KeyKind::Each(keys) => each(value, |name, value| {
                let is_rotary = self.is_rotary;
                if key.name == "inputs" {
                    self.is_rotary = !self.slides.iter().any(|slide| slide == name);
                }
                self.of(ValueOwner::Element(name.to_owned()), |its| {
                    its.inner(keys, name, value);
                });
                self.is_rotary = is_rotary;
            }),
            KeyKind::List(keys) => {
                let tables = list(value).filter_map(|item| item.get_ref().as_table());
                tables.for_each(|table| self.acting(keys, table));
            }
        }
    }

    /// Collects a limit of a slide or link, named after it, or of the angle of a link.
    fn limit(&mut self, keys: &'static [SceneKey], name: &str, value: &WrittenValue<'_>) {
        let called = format!("{name} limit");
        if let Some(table) = value.get_ref().as_table() {
            let link = table.get("link").and_then(|link| link.get_ref().as_str());
            let owner = ValueOwner::Element(link.unwrap_or(name).to_owned());
            return self.of(owner, |its| its.table(keys, &called, table, ""));
        }
        let measure = match self.slides.iter().any(|slide| slide == name) {
            true => Measure::Coordinate,
            false => Measure::Angle,
        };
        self.of(ValueOwner::Element(name.to_owned()), |its| {
            its.two(
                &called,
                ["low", "high"],
                "",
                NumberMeasure::Of(measure),
                value,
            );
        });
    }

    /// Collects two numbers, each under its own word.
    fn two(
        &mut self,
        name: &str,
        words: [&str; 2],
        after: &str,
        size: NumberMeasure,
        value: &WrittenValue<'_>,
    ) {
        for (word, item) in words.into_iter().zip(list(value)) {
            self.number(format!("{name} {word}{after}"), size, item);
        }
    }

    /// Runs `find` with another owner.
    fn of(&mut self, owner: ValueOwner, find: impl FnOnce(&mut Self)) {
        let before = std::mem::replace(&mut self.owner, owner);
        find(self);
        self.owner = before;
    }

    fn inner(&mut self, keys: &'static [SceneKey], name: &str, value: &WrittenValue<'_>) {
        if let Some(table) = value.get_ref().as_table() {
            self.table(keys, name, table, "");
        }
    }

    /// Collects the values of a spring or load. They are named after the elements on which it acts.
    fn acting(&mut self, keys: &'static [SceneKey], table: &DeTable<'_>) {
        let name = |key| table.get(key)?.get_ref().as_str();
        if let (Some(from), Some(to)) = (name("from"), name("to")) {
            let of = format!("spring {from}-{to}");
            let again = self.again(&of);
            let owner = ValueOwner::Between(from.to_owned(), to.to_owned());
            return self.of(owner, |its| its.table(keys, &of, table, &again));
        }
        if let (Some(link), false) = (name("link"), table.contains_key("torque")) {
            let of = format!("spring {link}-{}", name("to").unwrap_or("ground"));
            let again = self.again(&of);
            let owner = ValueOwner::Element(link.to_owned());
            self.is_torsion = true;
            self.of(owner, |its| its.table(keys, &of, table, &again));
            self.is_torsion = false;
            return;
        }
        let on = ["point", "link", "slide"].into_iter().find_map(name);
        let mut sizes = ["force", "torque", "press"].into_iter();
        let (Some(on), Some(size)) = (on, sizes.find(|size| table.contains_key(*size))) else {
            return;
        };
        let what = join(on, size);
        let again = self.again(&what);
        self.of(ValueOwner::Element(on.to_owned()), |its| {
            for (key, value) in table {
                if let Some(key) = keys::find(keys, key.get_ref()) {
                    // The factors of a load are named after the key of its magnitude.
                    let called = if key.name == "over" { size } else { key.name };
                    its.value(key, (on, called), value, &again);
                }
            }
        });
    }

    /// Collects knots, numbered from 1: the coordinate and the value of each.
    fn knots(
        &mut self,
        what: &str,
        again: &str,
        (sizes, called): ([NumberMeasure; 2], &str),
        knots: &WrittenValue<'_>,
    ) {
        for (i, knot) in list(knots).enumerate() {
            let parts = list(knot).zip(["at", called]).zip(sizes);
            for ((item, part), size) in parts {
                let name = format!("{what} knot {} {part}{again}", i + 1);
                self.number(name, size, item);
            }
        }
    }

    /// Returns the suffix that makes the names of repeated loads unique, such as ` (2)` for the
    /// second load on one point.
    fn again(&mut self, what: &str) -> String {
        let times = self.counts_by_name.entry(what.to_owned()).or_default();
        *times += 1;
        match *times {
            1 => String::new(),
            times => format!(" ({times})"),
        }
    }

    fn pair(&mut self, name: &str, after: &str, size: NumberMeasure, value: &WrittenValue<'_>) {
        self.two(name, ["x", "y"], after, size, value);
    }

    /// Collects a place on a link: coordinates, or a length and an angle.
    fn place(&mut self, name: &str, again: &str, value: &WrittenValue<'_>) {
        match value.get_ref().as_table() {
            Some(table) => self.table(keys::PLACE, name, table, again),
            None => self.pair(name, again, NumberMeasure::Of(Measure::Coordinate), value),
        }
    }

    fn number(&mut self, name: String, size: NumberMeasure, value: &WrittenValue<'_>) {
        let span = value.span();
        let (number, formula, dimension) =
            match (number_of(self.text, value), value.get_ref().as_str()) {
                (Some(number), _) => (number, None, None),
                (None, Some(text)) => {
                    let Ok(found) = self.named.evaluate_text(text) else {
                        return;
                    };
                    let number = found.nearest();
                    (number, Some(text.to_owned()), found.dimension)
                }
                (None, None) => return,
            };
        let is_rotary = match size {
            NumberMeasure::DriverItself => self.driver_turns,
            NumberMeasure::Of(_)
            | NumberMeasure::In(_)
            | NumberMeasure::Driver
            | NumberMeasure::Effort => self.is_rotary,
        };
        let measure = size.measure(is_rotary, self.is_torsion);
        let written = || self.text[span.clone()].to_owned();
        self.found.push(Value {
            name,
            owner: self.owner.clone(),
            measure,
            number,
            literal: formula.clone().unwrap_or_else(written),
            formula,
            unit: measure.unit(self.unit),
            place: span,
            scene: self.unit,
            quotes: false,
            dimension,
            named: Arc::clone(self.named),
        });
    }

    /// Collects a quoted number with a unit. The quotes stay unchanged, unless the text contains
    /// escapes.
    fn rate(&mut self, name: &str, degree: Degree, value: &WrittenValue<'_>) {
        let measure = Measure::of_rate(degree, self.is_rotary);
        let (Some(text), MeasureUnits::Rate(kind, degree)) =
            (value.get_ref().as_str(), measure.units(self.unit))
        else {
            return;
        };
        let complete = value.span();
        let inner = complete.start + 1..complete.end.saturating_sub(1);
        let quotes = self.text.get(inner.clone()) != Some(text);
        let WrittenRate { number, unit } = WrittenRate::of(text);
        let unit = rate::known(kind, degree, unit);
        let (parsed, literal, formula, unit) = match (number.parse(), unit) {
            (Ok(parsed), Some(unit)) => (parsed, number.into_owned(), None, unit),
            _ => {
                let Some((formula, unit)) = rate::formula(text, kind, degree) else {
                    return;
                };
                let Ok(found) = self.named.evaluate_text(formula) else {
                    return;
                };
                let formula = formula.to_owned();
                (found.nearest(), formula.clone(), Some(formula), unit)
            }
        };
        self.found.push(Value {
            name: name.to_owned(),
            owner: self.owner.clone(),
            measure,
            number: parsed,
            literal,
            formula,
            unit,
            place: if quotes { complete } else { inner },
            scene: self.unit,
            quotes,
            dimension: None,
            named: Arc::clone(self.named),
        });
    }
}

/// Returns the items of a list; none for another value.
fn list<'v>(value: &'v WrittenValue<'v>) -> impl Iterator<Item = &'v WrittenValue<'v>> {
    items(value).into_iter().flatten()
}

/// Joins the names of an owner, which may be empty, and of its part.
fn join(of: &str, name: &str) -> String {
    if of.is_empty() {
        name.to_owned()
    } else {
        format!("{of} {name}")
    }
}

/// Visits the entries of a table; does nothing for another value.
fn each<'v>(value: &'v WrittenValue<'v>, mut take: impl FnMut(&str, &'v WrittenValue<'v>)) {
    let table = value.get_ref().as_table();
    for (name, value) in table.into_iter().flat_map(entries) {
        take(name.text, value);
    }
}
