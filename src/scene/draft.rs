//! What the file says, element by element, before names are joined.

use super::Unit;
use super::input::{self, Driver};
use super::link::{self, Link, Links};
use super::loads::{self, Load, Loads, Spring, Springs};
use super::motor::{self, Motor};
use super::points::{self, Place, Vector, Vectors, places};
use super::reader::{Pair, Points, Reader, Span};
use super::redundant::{self, Redundant};
use super::slide::{self, Slide, Slides};
use crate::Vec2;
use crate::document::{Diagnostic, Found, Lenient};
use crate::nearest::did_you_mean;
use serde::Deserialize;

/// A scene as its file writes it.
#[derive(Debug, Deserialize)]
pub(super) struct File {
    name: Option<Lenient<String>>,
    source: Option<Lenient<String>>,
    note: Option<Lenient<String>>,
    unit: Option<Lenient<String>>,
    ground: Option<Points>,
    driver: Option<Lenient<input::Table>>,
    links: Option<Links>,
    slides: Option<Slides>,
    start: Option<Points>,
    vectors: Option<Vectors>,
    loads: Option<Loads>,
    springs: Option<Springs>,
    gravity: Option<Pair>,
    motor: Option<Lenient<motor::Table>>,
    redundant: Option<Lenient<redundant::Table>>,
}

/// What a scene says. Values that could not be read have a placeholder, so that what they do not
/// touch can still be checked; a diagnostic was reported for each.
#[derive(Debug, Default)]
pub(super) struct Draft<'t> {
    pub(super) name: Option<String>,
    pub(super) source: Option<String>,
    pub(super) note: Option<String>,
    pub(super) unit: Unit,
    pub(super) ground: Vec<Place<'t>>,
    pub(super) links: Vec<Link<'t>>,
    pub(super) links_key: Option<Span>,
    pub(super) slides: Vec<Slide<'t>>,
    pub(super) driver: Option<Driver<'t>>,
    /// The key `driver`, whether or not what follows could be read.
    pub(super) driver_key: Option<Span>,
    pub(super) start: Vec<Place<'t>>,
    pub(super) vectors: Vec<Vector<'t>>,
    pub(super) loads: Vec<Load<'t>>,
    pub(super) springs: Vec<Spring<'t>>,
    pub(super) motor: Option<Motor>,
    pub(super) gravity: Vec2,
    pub(super) redundant: Redundant,
    /// Whether a section could not be read at all: its names are missing everywhere.
    pub(super) unreadable: bool,
    /// Whether a link or a slide names a point that could not be read.
    pub(super) lost_points: bool,
    /// Whether a vector, a load or a spring could not be read, which may have named a point.
    pub(super) lost_references: bool,
}

/// Reads the whole document.
pub(super) fn read<'v>(reader: &mut Reader<'_>, root: &'v Lenient<File>) -> Draft<'v> {
    let mut draft = Draft::default();
    // The root of a document is always a table.
    let Some(file) = root.get() else { return draft };
    reader.only("the scene", root);
    draft.unreadable = root.known.iter().any(|key| root.meant(key));
    draft.name = line(reader, "name", file.name.as_ref());
    draft.source = line(reader, "source", file.source.as_ref());
    draft.note = line(reader, "note", file.note.as_ref());
    draft.unit = unit(reader, file.unit.as_ref());
    draft.moving(reader, root, file);
    draft.references(reader, file);
    if let Some(value) = &file.gravity {
        let gravity = reader.pair("`gravity` (m/s^2)", value);
        draft.unreadable |= gravity.is_none() && value.read.as_ref().err() != Some(&Found::Table);
        draft.gravity = gravity.unwrap_or_default();
    }
    if let Some(value) = &file.redundant {
        draft.redundant = redundant::read(reader, draft.unit, value);
        draft.unreadable |= value.get().is_none();
    }
    if let Some(value) = &file.motor {
        let driven = draft.driver.as_ref().map(|driver| &driver.input);
        draft.motor = motor::read(reader, draft.unit, driven, value);
    }
    if !draft.unreadable && draft.links.is_empty() && draft.slides.is_empty() {
        reader.report(link::nothing_moves());
        draft.unreadable = true;
    }
    draft
}

impl<'v> Draft<'v> {
    /// What moves, and where it is. A section that is no table has lost all its names.
    fn moving(&mut self, reader: &mut Reader<'_>, root: &Lenient<File>, file: &'v File) {
        let place = |name| root.key(name).map(|key| key.span());
        if let Some(value) = &file.ground {
            self.ground = places(reader, "[ground]", "ground point", value);
            self.unreadable |= value.get().is_none();
        }
        if let Some(value) = &file.start {
            self.start = places(reader, "[start]", "start of", value);
            self.unreadable |= value.get().is_none();
        }
        if let Some(value) = &file.links {
            let read = link::links(reader, value);
            self.unreadable |= value.get().is_none() || read.too_many;
            self.lost_points |= read.lost_points;
            self.links = read.links;
            self.links_key = place("links");
        }
        if let Some(value) = &file.slides {
            self.slides = slide::slides(reader, value);
            self.unreadable |= value.get().is_none();
            self.lost_points |= self.slides.iter().any(|slide| slide.slider.is_none());
        }
        if let (Some(value), Some(key)) = (&file.driver, place("driver")) {
            self.driver = input::driver(reader, self.unit, &key, value);
            self.unreadable |= value.get().is_none();
            self.driver_key = Some(key);
        }
    }

    /// What names points without defining them.
    fn references(&mut self, reader: &mut Reader<'_>, file: &'v File) {
        let before = reader.found.len();
        if let Some(value) = &file.vectors {
            self.vectors = points::vectors(reader, value);
        }
        if let Some(value) = &file.loads {
            self.loads = loads::loads(reader, value);
        }
        if let Some(value) = &file.springs {
            self.springs = loads::springs(reader, value);
        }
        self.lost_references = reader.found.len() > before;
    }
}

/// A text of one line: white space runs become one space.
fn line(reader: &mut Reader<'_>, key: &str, value: Option<&Lenient<String>>) -> Option<String> {
    let text = reader.string(&format!("`{key}`"), value?)?.text;
    let words: Vec<&str> = text.split_whitespace().collect();
    let shown = super::sanitized(&words.join(" "), false);
    (!shown.is_empty()).then_some(shown)
}

fn unit(reader: &mut Reader<'_>, value: Option<&Lenient<String>>) -> Unit {
    let name = value.and_then(|value| reader.string("`unit`", value));
    let Some(name) = name else {
        return Unit::default();
    };
    let found = Unit::ALL.into_iter().find(|u| u.symbol() == name.text);
    if found.is_none() {
        let symbols = Unit::ALL.map(Unit::symbol);
        reader.report(
            Diagnostic::new(format!("{name} is not a unit of length"))
                .at(name.span.clone(), "unknown unit")
                .maybe_help(did_you_mean(name.text, symbols))
                .help(format!("known units: `{}`", symbols.join("`, `"))),
        );
    }
    found.unwrap_or_default()
}
