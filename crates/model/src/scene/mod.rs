//! The scene file: a mechanism with names, a unit and a place for every element in the text.
//!
//! A scene is a [TOML](https://toml.io) file of at most 1 MiB and 10,000 links, written by a person who
//! has a sketch and a textbook:
//!
//! ```
//! let text = r#"
//! name = "Slider-crank with an offset"
//! unit = "mm"                     # of every length
//!
//! [ground]                        # points fixed in the frame
//! A = [0, 0]
//!
//! [driver]                        # the input
//! link  = "r2"
//! angle = 60                      # deg, where the scene opens
//! speed = "15 rad/s"
//!
//! [links]                         # local x axis from -> to, origin at from
//! r2 = { from = "A", to = "B", length = 100 }
//! r3 = { from = "B", to = "C", length = 300, com = [150, 0] }
//!
//! [slides]
//! r4 = { point = "C", on = "ground", through = [0, -20], angle = 0 }
//!
//! [start]                         # rough positions: they choose the assembly
//! C = [330, -20]
//! "#;
//! let scene = model::scene::Scene::parse(text, "offset.toml")?;
//! assert_eq!(scene.mechanism.links().len(), 2);
//! # Ok::<(), model::scene::Diagnostics>(())
//! ```
//!
//! # Rules
//!
//! [`reference()`] has every key, what it is and its default, as `krank help scene` tells them.
//!
#![doc = include_str!("rules.md")]
//!
//! # Faults
//!
//! [`Scene::parse`] reports everything that it finds, not only the first, each with line and column, what
//! is wrong and what would mend it: [`Diagnostics`]. What is wrong with the mechanism as a whole the
//! solver finds, and [`Scene::explain`] says it in the same way.

mod defect;
mod deviations;
mod draft;
mod figures;
mod frame;
mod general_tolerance;
mod guide;
mod input;
mod keys;
mod limits;
mod link;
mod load_names;
mod loads;
mod measure;
mod motor;
mod names;
mod numeral;
mod parameters;
mod points;
#[cfg(test)]
#[path = "../../../../src/scene/presets.rs"]
pub mod presets;
mod profile;
mod rate;
mod reader;
mod redundant;
mod resolve;
mod retell;
mod rewrite;
mod sighted;
mod slide;
mod spring;
mod spring_ends;
mod syntax;
mod timed_inputs;
mod timed_motion;
mod typed;
mod typed_tolerance;
mod unit;
mod values;
mod worked;

pub use crate::document::{Diagnostic, Diagnostics, Label, is_harmful, sanitized};
#[doc(hidden)]
pub use draft::{line, unit};
pub use figures::NamedFormula;
#[doc(hidden)]
pub use input::coordinate_key;
pub use keys::reference;
pub use measure::Measure;
pub use motor::Motor;
#[doc(hidden)]
pub use names::{is_figure_name, reserved_for_figures};
#[doc(hidden)]
pub use numeral::{are_thousands, with_point};
pub use parameters::Parameter;
#[doc(hidden)]
pub use retell::toml_string;
pub use rewrite::Precision;
#[doc(hidden)]
pub use rewrite::{figure, key};
#[doc(hidden)]
pub use syntax::mend;
pub use typed::Mistyped;
pub use unit::Unit;
pub use values::{Value, ValueOwner};

use crate::document::{self, NamedNumbers};
use crate::wording::words;
use crate::{
    Body, ElementId, Input, LimitId, LinkId, Mechanism, MotionLaw, PointId, SlideId, Tolerances,
};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

/// The rules of the scene file as Markdown, for manuals.
pub const RULES: &str = include_str!("rules.md");

/// Bytes that a scene file may have: 1 MiB.
pub const LARGEST_FILE: usize = 1 << 20;

/// A scene: a mechanism, its names and its unit.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The title (`name`), or the file's stem where there is none.
    pub name: String,
    /// Where the mechanism comes from (`source`).
    pub source: Option<String>,
    /// What there is to see (`note`).
    pub note: Option<String>,
    /// The unit of every length.
    pub unit: Unit,
    /// The mechanism.
    pub mechanism: Mechanism,
    /// The vectors of the tables in the order of the file: links with two ends, slides, `[vectors]`.
    pub vectors: Vec<Vector>,
    /// The figures that are made of others (`[figures]`), in the order of the file.
    pub figures: Vec<NamedFormula>,
    /// How the driver moves over time (`motion` of `[driver]`).
    pub motion: Option<MotionLaw>,
    /// The motor that is to drive it (`[motor]`).
    pub motor: Option<Motor>,
    /// The numbers with names (`[parameters]`), in the order of the file.
    pub parameters: Vec<Parameter>,
    named: Arc<NamedNumbers>,
    #[doc(hidden)]
    pub point_names: Vec<Option<String>>,
    #[doc(hidden)]
    pub link_names: Vec<String>,
    #[doc(hidden)]
    pub slide_names: Vec<String>,
    /// The limits by their names, with the places of their ends in the text.
    limits: limits::LimitPlaces,
    tolerances: Tolerances,
    places: TextPlaces,
    origin: String,
    text: Arc<str>,
}

/// Where the elements stand in the text, as ranges of bytes.
#[derive(Clone, Debug, Default)]
struct TextPlaces {
    points: Vec<Range<usize>>,
    links: Vec<Range<usize>>,
    slides: Vec<Range<usize>>,
    driver: Range<usize>,
}

/// A vector of the loop equations.
#[derive(Clone, Debug, PartialEq)]
pub struct Vector {
    /// As the scene names it.
    pub name: String,
    /// What it is.
    pub kind: VectorKind,
}

/// The kinds of vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VectorKind {
    /// A link, from one end to the other.
    Link(LinkId),
    /// A slide, from the sliding point back to `through`: its length is the signed position.
    Slide(SlideId),
    /// From one point to another.
    Between(PointId, PointId),
}

impl Scene {
    /// Reads a scene from the bytes of a file; `origin` is the name of the file in messages.
    ///
    /// # Errors
    /// Everything found wrong, with its places.
    pub fn read(bytes: &[u8], origin: &str) -> Result<Scene, Diagnostics> {
        if bytes.len() > LARGEST_FILE {
            return Err(too_large(origin));
        }
        match std::str::from_utf8(bytes) {
            Ok(text) => Scene::parse(text, origin),
            Err(error) => Err(document::not_utf8(bytes, error.valid_up_to(), origin)),
        }
    }

    /// Reads a scene from a text; `origin` is the name of the file in messages.
    ///
    /// # Errors
    /// Everything found wrong, with its places.
    pub fn parse(text: &str, origin: &str) -> Result<Scene, Diagnostics> {
        if text.len() > LARGEST_FILE {
            return Err(too_large(origin));
        }
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut reader = reader::Reader::new(text);
        let root = document::parse(&mut reader, syntax::mend);
        let scene = root.and_then(|root| {
            let draft = draft::read(&mut reader, &root);
            let resolved = resolve::resolve(&mut reader, &draft)?;
            let figures = draft.figures.into_iter();
            Some(Scene {
                name: draft.name.unwrap_or_else(|| stem(origin)),
                source: draft.source,
                note: draft.note,
                unit: draft.unit,
                mechanism: resolved.mechanism,
                vectors: resolved.vectors,
                figures: figures.filter_map(|figure| figure.formula).collect(),
                motion: draft.driver.and_then(|driver| driver.motion),
                motor: draft.motor,
                parameters: parameters::told(&reader.named, draft.parameters),
                named: Arc::new(std::mem::take(&mut reader.named)),
                point_names: resolved.point_names,
                link_names: resolved.link_names,
                slide_names: resolved.slide_names,
                limits: resolved.limits,
                tolerances: resolved.tolerances,
                places: resolved.places,
                origin: origin.to_owned(),
                text: text.into(),
            })
        });
        let scene = scene.map(|mut scene| {
            let tolerances = std::mem::take(&mut scene.tolerances);
            scene.tolerances = scene.in_order_of_names(tolerances);
            scene
        });
        let scene = scene.filter(|scene| worked::measures_fit(&mut reader, scene));
        scene.ok_or_else(|| reader.into_diagnostics(origin))
    }

    /// The name of the file that the scene comes from.
    #[must_use]
    pub fn origin(&self) -> &str {
        &self.origin
    }

    /// Another text read under the same name; `None` where that is no scene.
    #[must_use]
    pub fn again(&self, text: &str) -> Option<Scene> {
        Scene::parse(text, &self.origin).ok()
    }

    /// The text of the file, without a byte order mark: what [`Scene::place`] counts in.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Where an element stands in the text: the bytes of its name where it is defined.
    #[must_use]
    pub fn place(&self, element: ElementId) -> Range<usize> {
        match element {
            ElementId::Point(point) => self.places.points[point.index()].clone(),
            ElementId::Link(link) => self.places.links[link.index()].clone(),
            ElementId::Slide(slide) => self.places.slides[slide.index()].clone(),
            ElementId::Driver => self.places.driver.clone(),
        }
    }

    /// Faults of this scene, with the text that they point into.
    pub(crate) fn diagnostics(&self, items: Vec<Diagnostic>) -> Diagnostics {
        Diagnostics {
            origin: self.origin.clone(),
            text: Arc::clone(&self.text),
            items,
        }
    }

    /// A point's name; `None` for the hidden points of the model (`r3.com` is the name of a centre of mass).
    #[must_use]
    pub fn point_name(&self, point: PointId) -> Option<&str> {
        self.point_names[point.index()].as_deref()
    }

    /// Whether a point is one of `[marks]`, which is only shown.
    #[must_use]
    pub fn is_mark(&self, point: PointId) -> bool {
        self.mechanism.point(point).is_mark
    }

    /// The points that tables list: those that have a name and are no marks, in the order of the file.
    pub fn listed_points(&self) -> impl Iterator<Item = (PointId, &str)> {
        let named = |point| Some((point, self.point_name(point)?));
        let all = self.mechanism.point_ids().filter_map(named);
        all.filter(|(point, _)| !self.is_mark(*point))
    }

    /// A link's name.
    #[must_use]
    pub fn link_name(&self, link: LinkId) -> &str {
        &self.link_names[link.index()]
    }

    /// A limit's name: what it is named after, or what the scene calls it; `driver` where the driver has a range.
    #[must_use]
    pub fn limit_name(&self, limit: LimitId) -> &str {
        &self.limits[limit.index()].0
    }

    /// Where the ends of a limit stand in the text.
    #[must_use]
    pub fn limit_place(&self, limit: LimitId) -> Range<usize> {
        self.limits[limit.index()].1.clone()
    }

    /// The title as a person reads it: that of a scene that is built in, in the language that is spoken.
    #[must_use]
    pub fn title(&self) -> String {
        words().told_of_scene(&self.name)
    }

    /// How far lengths may be off, and how loose pins are.
    #[must_use]
    pub fn tolerances(&self) -> &Tolerances {
        &self.tolerances
    }

    /// The name of the link that the motor of an input sits on, if it sits on one.
    #[must_use]
    pub fn seat_name(&self, input: Input) -> Option<&str> {
        let Input::Turn(link) = input else {
            return None;
        };
        match self.mechanism.turned_from(link) {
            Body::Link(from) => Some(self.link_name(from)),
            Body::Ground => None,
        }
    }

    /// What an input drives, for people: with the link that its motor sits on.
    #[must_use]
    pub fn driven_name(&self, input: Input) -> String {
        let name = match input {
            Input::Turn(link) => self.link_name(link),
            Input::Push(slide) => self.slide_name(slide),
        };
        from_seat(name, self.seat_name(input))
    }

    /// A slide's name.
    #[must_use]
    pub fn slide_name(&self, slide: SlideId) -> &str {
        &self.slide_names[slide.index()]
    }
}

/// A driven link or slide, with the link that its motor sits on if it sits on one.
#[doc(hidden)]
pub fn from_seat(name: &str, seat: Option<&str>) -> String {
    match seat {
        Some(from) => words().turned_from(name, from),
        None => name.to_owned(),
    }
}

/// Whoever reads a file stops one byte behind the limit, so nobody knows how large it really is.
#[doc(hidden)]
pub fn too_large(origin: &str) -> Diagnostics {
    let fault = Diagnostic::new(words().scene_too_large(LARGEST_FILE));
    Diagnostics {
        origin: origin.to_owned(),
        text: "".into(),
        items: vec![fault],
    }
}

/// The name of a file without folder and ending.
#[doc(hidden)]
pub fn stem(origin: &str) -> String {
    let stem = Path::new(origin).file_stem();
    let stem = stem.map(|s| s.to_string_lossy().into_owned());
    sanitized(&stem.unwrap_or_else(|| origin.to_owned()), false)
}

#[cfg(test)]
mod refusals;
#[cfg(test)]
mod tests;
