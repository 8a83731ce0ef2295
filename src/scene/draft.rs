//! What the file says, element by element, before names are joined.

use super::Unit;
use super::motor::{self, Motor};
use super::reader::{Name, Reader, Span, Value, meant, quoted};
use super::redundant::{self, Redundant};
use super::{elements, input, loads};
use crate::document::Diagnostic;
use crate::nearest::did_you_mean;
use crate::{Profile, StrokeEnd, Vec2};
use toml::de::DeTable;

/// The most links that a scene may have.
pub(super) const MOST_LINKS: usize = 10_000;

pub(super) const SECTIONS: [&str; 15] = [
    "name",
    "source",
    "note",
    "unit",
    "ground",
    "driver",
    "links",
    "slides",
    "start",
    "vectors",
    "loads",
    "springs",
    "gravity",
    "motor",
    "redundant",
];

/// A scene as written. Values that could not be read have a placeholder, so that what they do not
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

impl Draft<'_> {
    /// Takes note of what is missing where something about a section was reported.
    fn lost(&mut self, section: &str, value: &Value<'_>, reported: bool) {
        match section {
            "vectors" | "loads" | "springs" => self.lost_references |= reported,
            // A section that is no table has lost all its names.
            _ => self.unreadable |= reported && value.get_ref().as_table().is_none(),
        }
    }
}

/// A point with coordinates, in whatever frame.
#[derive(Debug)]
pub(super) struct Place<'t> {
    pub(super) name: Name<'t>,
    /// `None` if the coordinates could not be read.
    pub(super) read: Option<Vec2>,
}

impl Place<'_> {
    /// The coordinates, or a placeholder.
    pub(super) fn at(&self) -> Vec2 {
        self.read.unwrap_or_default()
    }
}

#[derive(Debug)]
pub(super) struct Link<'t> {
    pub(super) name: Name<'t>,
    pub(super) ends: Option<Ends<'t>>,
    pub(super) points: Vec<Place<'t>>,
    /// The centre of mass, with the place of the key.
    pub(super) com: Option<(Span, Vec2)>,
    pub(super) mass: f64,
    pub(super) inertia: f64,
    /// The key `mass`, or `inertia` where there is no mass.
    pub(super) mass_key: Option<(&'static str, Span)>,
    /// Whether something about it was reported.
    pub(super) broken: bool,
}

impl<'t> Link<'t> {
    /// Its named points, the ends first.
    pub(super) fn point_names(&self) -> impl Iterator<Item = &Name<'t>> {
        let ends = self.ends.iter().flat_map(|ends| [&ends.from, &ends.to]);
        ends.chain(self.points.iter().map(|p| &p.name))
    }

    /// The coordinates of one of the link's points in its own frame.
    pub(super) fn local(&self, point: &str) -> Option<Vec2> {
        let ends = self.ends.as_ref().and_then(|ends| {
            if ends.from.text == point {
                Some(Vec2::ZERO)
            } else {
                (ends.to.text == point).then(|| Vec2::new(ends.length, 0.0))
            }
        });
        let listed = || self.points.iter().find(|p| p.name.text == point);
        ends.or_else(|| listed().map(Place::at))
    }
}

#[derive(Debug)]
pub(super) struct Ends<'t> {
    pub(super) from: Name<'t>,
    pub(super) to: Name<'t>,
    pub(super) length: f64,
}

#[derive(Debug)]
pub(super) struct Slide<'t> {
    pub(super) name: Name<'t>,
    /// `None` for this and the following: a fault was reported.
    pub(super) slider: Option<Slider<'t>>,
    pub(super) on: Option<Name<'t>>,
    pub(super) through: Option<Through<'t>>,
    pub(super) angle: f64,
}

#[derive(Debug)]
pub(super) enum Slider<'t> {
    Pin(Name<'t>),
    Link { link: Name<'t>, turn: f64 },
}

#[derive(Debug)]
pub(super) enum Through<'t> {
    Point(Name<'t>),
    At(Vec2),
}

#[derive(Debug)]
pub(super) struct Driver<'t> {
    /// The key `link` or `slide`.
    pub(super) input: Input<'t>,
    pub(super) start: f64,
    pub(super) speed: f64,
    pub(super) acceleration: f64,
}

#[derive(Debug)]
pub(super) enum Input<'t> {
    Link(Name<'t>),
    Slide(Name<'t>),
}

#[derive(Debug)]
pub(super) struct Vector<'t> {
    pub(super) name: Name<'t>,
    pub(super) tail: Name<'t>,
    pub(super) head: Name<'t>,
}

#[derive(Debug)]
pub(super) enum Load<'t> {
    Force {
        point: Name<'t>,
        force: Vec2,
        /// The link with which it turns; the ground's frame without one.
        frame: Option<Name<'t>>,
        over: Profile,
    },
    Torque {
        link: Name<'t>,
        torque: f64,
        over: Profile,
    },
    Press {
        slide: Name<'t>,
        curve: Profile,
        /// `None` where the file leaves it to the guide.
        end: Option<StrokeEnd>,
    },
}

#[derive(Debug)]
pub(super) struct Spring<'t> {
    pub(super) from: Name<'t>,
    pub(super) to: Name<'t>,
    pub(super) stiffness: f64,
    pub(super) length: f64,
    pub(super) damping: f64,
}

/// Reads the whole document.
pub(super) fn read<'v>(reader: &mut Reader<'_>, root: &'v DeTable<'v>) -> Draft<'v> {
    reader.only("the scene", root, &SECTIONS);
    let mut draft = Draft {
        unreadable: SECTIONS.into_iter().any(|key| meant(root, &SECTIONS, key)),
        name: line(reader, root, "name"),
        source: line(reader, root, "source"),
        note: line(reader, root, "note"),
        unit: unit(reader, root),
        ..Draft::default()
    };
    for (key, value) in root {
        let before = reader.found.len();
        match key.get_ref().as_ref() {
            "ground" => draft.ground = places(reader, "[ground]", "ground point", value),
            "links" => {
                elements::links(reader, &mut draft, value);
                draft.links_key = Some(key.span());
            }
            "slides" => elements::slides(reader, &mut draft, value),
            "start" => draft.start = places(reader, "[start]", "start of", value),
            "vectors" => draft.vectors = elements::vectors(reader, value),
            "loads" => draft.loads = loads::loads(reader, value),
            "springs" => draft.springs = loads::springs(reader, value),
            "gravity" => {
                let gravity = reader.pair("`gravity` (m/s^2)", value);
                draft.gravity = gravity.unwrap_or_default();
            }
            "redundant" => draft.redundant = redundant::read(reader, draft.unit, value),
            "driver" => {
                draft.driver = input::driver(reader, draft.unit, key.span(), value);
                draft.driver_key = Some(key.span());
            }
            // Texts and the unit were read above, the motor is read below; unknown keys are reported.
            _ => {}
        }
        draft.lost(key.get_ref().as_ref(), value, reader.found.len() > before);
    }
    if let Some(value) = root.get("motor") {
        let driven = draft.driver.as_ref().map(|driver| &driver.input);
        draft.motor = motor::read(reader, draft.unit, driven, value);
    }
    if !draft.unreadable && draft.links.is_empty() && draft.slides.is_empty() {
        reader.report(elements::nothing_moves());
        draft.unreadable = true;
    }
    draft
}

/// A text of one line: white space runs become one space.
fn line<'v>(reader: &mut Reader<'_>, root: &'v DeTable<'v>, key: &str) -> Option<String> {
    let text = reader.string(&format!("`{key}`"), root.get(key)?)?.text;
    let words: Vec<&str> = text.split_whitespace().collect();
    let shown = super::sanitized(&words.join(" "), false);
    (!shown.is_empty()).then_some(shown)
}

fn unit<'v>(reader: &mut Reader<'_>, root: &'v DeTable<'v>) -> Unit {
    let Some(value) = root.get("unit") else {
        return Unit::default();
    };
    let Some(name) = reader.string("`unit`", value) else {
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

/// A table of points with coordinates.
pub(super) fn places<'v>(
    reader: &mut Reader<'_>,
    section: &str,
    what: &str,
    value: &'v Value<'v>,
) -> Vec<Place<'v>> {
    let Some(table) = reader.table(section, "{ A = [0, 0] }", value) else {
        return Vec::new();
    };
    let place = |(key, value): (&'v toml::Spanned<toml::de::DeString<'v>>, &'v Value<'v>)| {
        let name = Name {
            text: key.get_ref().as_ref(),
            span: key.span(),
        };
        let read = reader.pair(&format!("{what} {}", quoted(name.text)), value);
        Place { name, read }
    };
    table.iter().map(place).collect()
}
