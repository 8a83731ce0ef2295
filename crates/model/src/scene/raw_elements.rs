//! Reads the elements of a scene file one by one, before their names are resolved.

use super::Unit;
use super::accuracy::deviations::{self, DraftTolerances};
use super::copies::{self, DraftCopy};
use super::elements::drawn;
use super::elements::limits::{self, DraftLimit};
use super::elements::link::{self, DraftLink};
use super::elements::points::{self, DraftVector, PlacedPoint, places};
use super::elements::redundant::{self, Redundant};
use super::elements::slide::{self, DraftSlide};
use super::elements::view::{self, DraftView};
use super::inputs::input::{self, DraftDriver};
use super::inputs::leading_point::{self, DraftLead};
use super::inputs::motor::{self, Motor};
use super::inputs::timed_inputs::{self, DraftTimed};
use super::keys;
use super::loading::loads::{self, DraftLoad};
use super::loading::spring::{self, DraftSpring};
use super::numbers::figures::{self, DraftFigure};
use super::numbers::parameters::{self, DraftParameter};
use super::numbers::reader::{ByteSpan, Reader};
use super::table::KeyTable;
use crate::Vec2;
use crate::document::{Diagnostic, WrittenValue};
use crate::nearest::did_you_mean;
use crate::wording::words;
use std::collections::HashSet;
use toml::de::DeTable;

/// The contents of a scene. Values that could not be read have a placeholder and a diagnostic, so
/// that the remaining elements can still be checked.
#[derive(Debug, Default)]
pub(crate) struct SceneDraft<'t> {
    pub(crate) name: Option<String>,
    pub(crate) source: Option<String>,
    pub(crate) note: Option<String>,
    pub(crate) unit: Unit,
    pub(crate) parameters: Vec<DraftParameter<'t>>,
    /// The points of the ground, including the marks.
    pub(crate) ground: Vec<PlacedPoint<'t>>,
    /// The names of the marks, which no element has to refer to.
    pub(crate) marks: HashSet<&'t str>,
    pub(crate) links: Vec<DraftLink<'t>>,
    pub(crate) links_key: Option<ByteSpan>,
    pub(crate) slides: Vec<DraftSlide<'t>>,
    pub(crate) driver: Option<DraftDriver<'t>>,
    /// The place of the key `driver`, even if its value could not be read.
    pub(crate) driver_key: Option<ByteSpan>,
    /// The inputs that follow the driver.
    pub(crate) timed: Vec<DraftTimed<'t>>,
    /// The point that inputs follow.
    pub(crate) lead: Option<DraftLead<'t>>,
    pub(crate) start: Vec<PlacedPoint<'t>>,
    pub(crate) copies: Vec<DraftCopy<'t>>,
    pub(crate) vectors: Vec<DraftVector<'t>>,
    pub(crate) limits: Vec<DraftLimit<'t>>,
    pub(crate) loads: Vec<DraftLoad<'t>>,
    pub(crate) springs: Vec<DraftSpring<'t>>,
    pub(crate) motor: Option<Motor>,
    pub(crate) gravity: Vec2,
    pub(crate) figures: Vec<DraftFigure<'t>>,
    pub(crate) redundant: Redundant,
    pub(crate) view: DraftView<'t>,
    pub(crate) tolerances: DraftTolerances<'t>,
    /// Whether a section could not be read at all, so that all its names are missing.
    pub(crate) unreadable: bool,
    /// Whether a link or a slide names an unreadable point.
    pub(crate) lost_points: bool,
    /// Whether a vector, a load, a spring or a trace that may have named a point could not be read.
    pub(crate) lost_references: bool,
}

/// Reads the whole document.
pub(crate) fn read<'v>(reader: &mut Reader<'_>, root: &'v DeTable<'v>) -> SceneDraft<'v> {
    let mut draft = SceneDraft::default();
    // A file with links is a scene, even if it has a `kind`.
    if let (Some((kind, _)), None) = (root.get_key_value("kind"), root.get("links")) {
        let fault = Diagnostic::new(words().task_for_a_scene());
        reader.report(
            fault
                .at(kind.span(), "")
                .help(words().synthesize_does_tasks()),
        );
        draft.unreadable = true;
        return draft;
    }
    let file = &KeyTable::root(words().the_scene_itself(), keys::SCENE, root);
    reader.only_known(file);
    draft.unreadable = keys::SCENE
        .iter()
        .any(|key| file.is_probable_misspelling(key.name));
    draft.name = line(reader, "name", file.get("name"));
    draft.source = line(reader, "source", file.get("source"));
    draft.note = line(reader, "note", file.get("note"));
    draft.unit = unit(reader, file.get("unit"));
    reader.named.length = (draft.unit.symbol(), draft.unit.tenths_of_mm());
    // First, because every number may use parameters.
    if let Some(value) = file.get("parameters") {
        draft.parameters = parameters::read(reader, value);
    }
    draft.moving(reader, file);
    draft.references(reader, file);
    draft.deviations(reader, file);
    if let Some(value) = file.get("gravity") {
        let gravity = reader.pair_of(file, "gravity");
        draft.unreadable |= gravity.is_none() && !value.get_ref().is_table();
        draft.gravity = gravity.unwrap_or_default();
    }
    if let Some(value) = draft.section(file, "redundant") {
        draft.redundant = redundant::read(reader, value);
    }
    if let Some(value) = file.get("figures") {
        draft.figures = figures::figures(reader, value);
    }
    if let Some(value) = file.get("motor") {
        let driven = draft.driver.as_ref().map(|driver| &driver.input);
        draft.motor = motor::read(reader, draft.unit, driven, value);
    }
    if !draft.unreadable && draft.links.is_empty() && draft.slides.is_empty() {
        reader.report(link::nothing_moves());
        draft.unreadable = true;
    }
    draft
}

impl<'v> SceneDraft<'v> {
    /// Returns the value of a section. One that is not a table loses all its names.
    fn section(&mut self, file: &KeyTable<'v>, key: &str) -> Option<&'v WrittenValue<'v>> {
        let value = file.get(key)?;
        self.unreadable |= !value.get_ref().is_table();
        Some(value)
    }

    /// Reads the ground, the links, the slides, the inputs, the start and the copies.
    fn moving(&mut self, reader: &mut Reader<'_>, file: &KeyTable<'v>) {
        let place = |name| file.key(name).map(|key| key.span);
        if let Some(value) = self.section(file, "ground") {
            self.ground = places(reader, "[ground]", words().ground_point(), value);
        }
        if let Some(value) = self.section(file, "marks") {
            let marks = places(reader, "[marks]", words().mark(), value);
            for mark in &marks {
                let fixed = |place: &&PlacedPoint<'_>| place.name.text == mark.name.text;
                if let Some(before) = self.ground.iter().find(fixed) {
                    let fault = Diagnostic::new(words().given_twice(&mark.name.to_string()));
                    let before = before.name.span.clone();
                    reader.report(
                        fault
                            .at(mark.name.span.clone(), "")
                            .and(before, words().fixed_here()),
                    );
                }
            }
            self.marks = marks.iter().map(|mark| mark.name.text).collect();
            self.ground.extend(marks);
        }
        if let Some(value) = self.section(file, "start") {
            self.start = places(reader, "[start]", words().start_of(), value);
        }
        if let Some(value) = self.section(file, "links") {
            let read = link::links(
                reader,
                &drawn::drawn_places(&self.ground, &self.start),
                value,
            );
            self.unreadable |= read.too_many;
            self.lost_points |= read.lost_points;
            self.links = read.links;
            self.links_key = place("links");
        }
        if let Some(value) = self.section(file, "slides") {
            self.slides = slide::slides(reader, value);
            self.lost_points |= self.slides.iter().any(|slide| slide.slider.is_none());
        }
        if let (Some(value), Some(key)) = (self.section(file, "driver"), place("driver")) {
            self.driver = input::driver(reader, self.unit, &self.links, &key, value);
            self.driver_key = Some(key);
        }
        if let Some(value) = self.section(file, "inputs") {
            self.timed = timed_inputs::read(reader, value);
        }
        if let Some(value) = self.section(file, "copies") {
            let before = reader.found.len();
            self.copies = copies::read(reader, &self.ground, value);
            // Other sections may name elements of the copies.
            self.unreadable |= reader.found.len() > before;
        }
    }

    /// Reads tolerances and clearances.
    fn deviations(&mut self, reader: &mut Reader<'_>, file: &KeyTable<'v>) {
        let all = &mut self.tolerances;
        all.general = deviations::tolerance_of(reader, file);
        if let Some(value) = file.get("clearance") {
            all.clearance = deviations::clearance(reader, "`clearance`", value);
        }
        if let Some(value) = file.get("tolerances") {
            all.points = deviations::points(reader, value);
        }
        if let Some(value) = file.get("clearances") {
            all.pins = deviations::pins(reader, value);
        }
    }

    /// Reads the elements that name points without defining them.
    fn references(&mut self, reader: &mut Reader<'_>, file: &KeyTable<'v>) {
        let before = reader.found.len();
        if let Some(value) = file.get("vectors") {
            self.vectors = points::vectors(reader, value);
        }
        if let Some(value) = file.get("limits") {
            self.limits = limits::limits(reader, value);
        }
        if let Some(value) = file.get("loads") {
            self.loads = loads::loads(reader, value);
        }
        if let Some(value) = file.get("springs") {
            self.springs = spring::springs(reader, value);
        }
        if let Some(value) = file.get("lead") {
            self.lead = leading_point::read(reader, value);
        }
        if let Some(value) = file.get("view") {
            self.view = view::read(reader, value);
        }
        self.lost_references = reader.found.len() > before;
    }
}

/// Reads a text as one line: runs of white space become one space.
pub fn line(
    reader: &mut Reader<'_>,
    key: &str,
    value: Option<&WrittenValue<'_>>,
) -> Option<String> {
    let text = reader.string(&format!("`{key}`"), value?)?.text;
    let parts: Vec<&str> = text.split_whitespace().collect();
    let shown = super::sanitized(&parts.join(" "), false);
    (!shown.is_empty()).then_some(shown)
}

/// Reads the unit of lengths; an unknown one is reported and replaced.
pub fn unit(reader: &mut Reader<'_>, value: Option<&WrittenValue<'_>>) -> Unit {
    let name = value.and_then(|value| reader.string("`unit`", value));
    let Some(name) = name else {
        return Unit::default();
    };
    let found = Unit::ALL.into_iter().find(|u| u.symbol() == name.text);
    if found.is_none() {
        let symbols = Unit::ALL.map(Unit::symbol);
        reader.report(
            Diagnostic::new(words().no_unit_of_length(&name.to_string()))
                .at(name.span.clone(), words().unknown_unit())
                .maybe_help(did_you_mean(name.text, symbols))
                .help(words().known_units(&format!("`{}`", symbols.join("`, `")))),
        );
    }
    found.unwrap_or_default()
}
