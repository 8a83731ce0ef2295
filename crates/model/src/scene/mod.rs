//! The scene file: a mechanism with names, a unit and a place for every element in the text.
//!
//! A scene is a [TOML](https://toml.io) file of at most 1 MiB and 10,000 links, written by hand
//! from a sketch and a textbook:
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
//! [`reference()`] lists every key with its description and default; `krank help scene` shows them.
//!
#![doc = include_str!("rules.md")]
//!
//! # Faults
//!
//! [`Scene::parse`] reports all faults that it finds as [`Diagnostics`], each with line, column,
//! cause and fix. Faults of the mechanism as a whole are found by the solver, and
//! [`Scene::explain`] reports them in the same form.

mod accuracy;
mod copies;
mod defect;
mod elements;
mod inputs;
mod keys;
mod lead;
mod loading;
mod names;
mod numbers;
#[cfg(test)]
#[path = "../../../../src/scene/presets.rs"]
pub mod presets;
mod raw_elements;
mod resolve;
mod rewrite;
mod same_elements;
mod syntax;
mod table;
mod values;

pub use crate::document::{Diagnostic, Diagnostics, Label, is_harmful, sanitized};
#[doc(hidden)]
pub use inputs::input::coordinate_key;
pub use inputs::leading_point::LeadingPoint;
pub use inputs::motor::Motor;
pub use keys::reference;
#[doc(hidden)]
pub use keys::{KeyKind, NumberMeasure, SceneKey};
#[doc(hidden)]
pub use names::{is_figure_name, reserved_for_figures};
pub(crate) use numbers::dependents::DependentValues;
pub use numbers::figures::NamedFormula;
pub use numbers::measure::Measure;
#[doc(hidden)]
pub use numbers::numeral::{are_thousands, entries_with_numbers, with_point};
pub use numbers::parameters::Parameter;
#[doc(hidden)]
pub use numbers::rate::Degree;
pub use numbers::typed_number::ValueError;
pub use numbers::unit::Unit;
#[doc(hidden)]
pub use raw_elements::{line, unit};
pub use rewrite::Precision;
#[doc(hidden)]
pub use rewrite::{figure, key, toml_string};
#[doc(hidden)]
pub use syntax::fix;
#[doc(hidden)]
pub use table::{KeyTable, NumberRule};
pub use values::{Value, ValueOwner};

use crate::document::{self, DocumentKind, NamedNumbers, Reader};
use crate::wording::words;
use crate::{
    Body, ElementId, Input, LimitId, LinkId, Mechanism, MotionLaw, PointId, SlideId, Tolerances,
};
use std::collections::HashMap;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

/// The rules of the scene file as Markdown, for manuals.
pub const RULES: &str = include_str!("rules.md");

/// Maximum size of a scene file in bytes: 1 MiB.
pub const MAX_FILE_SIZE: usize = 1 << 20;

/// A scene: a mechanism with names, a unit and a place in the text for every element.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The title (`name`), or the file's stem if there is none.
    pub name: String,
    /// The origin of the mechanism (`source`).
    pub source: Option<String>,
    /// A note on the scene's purpose (`note`).
    pub note: Option<String>,
    /// The unit of every length.
    pub unit: Unit,
    /// The mechanism.
    pub mechanism: Mechanism,
    /// The vectors of the tables in the order of the file: links with two ends, slides, `[vectors]`.
    pub vectors: Vec<Vector>,
    /// The points with traces from the start (`traces` of `[view]`), in the order of the file.
    pub traces: Vec<PointId>,
    /// The values computed from others (`[figures]`), in the order of the file.
    pub figures: Vec<NamedFormula>,
    /// The motion of the driver over time (`motion` of `[driver]`).
    pub motion: Option<MotionLaw>,
    /// The point that leads, with its motion over time (`[lead]`). Inputs follow it.
    pub lead: Option<LeadingPoint>,
    /// The motor intended as drive (`[motor]`).
    pub motor: Option<Motor>,
    /// The named numbers (`[parameters]`), in the order of the file.
    pub parameters: Vec<Parameter>,
    named: Arc<NamedNumbers>,
    #[doc(hidden)]
    pub point_names: Vec<Option<String>>,
    #[doc(hidden)]
    pub link_names: Vec<String>,
    #[doc(hidden)]
    pub slide_names: Vec<String>,
    /// The names of the limits, with the places of their ends in the text.
    limits: elements::limits::LimitPlaces,
    /// The originals' names by those of copied elements (`[copies]`).
    originals: HashMap<String, String>,
    tolerances: Tolerances,
    places: TextPlaces,
    origin: String,
    text: Arc<str>,
}

/// The places of the elements in the text, as ranges of bytes.
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
    /// The name given by the scene.
    pub name: String,
    /// The kind of vector, with its elements.
    pub kind: VectorKind,
}

/// The kinds of vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VectorKind {
    /// A link, from one end to the other.
    Link(LinkId),
    /// A slide, from the sliding point back to `through`: its length is the signed position.
    Slide(SlideId),
    /// A vector from one point to another.
    Between(PointId, PointId),
}

impl Scene {
    /// Reads a scene from the bytes of a file; `origin` is the name of the file in messages.
    ///
    /// # Errors
    /// Returns all faults found, with their places.
    pub fn read(bytes: &[u8], origin: &str) -> Result<Scene, Diagnostics> {
        if bytes.len() > MAX_FILE_SIZE {
            return Err(too_large(origin));
        }
        Scene::parse(document::utf8_text(bytes, origin)?, origin)
    }

    /// Parses a scene; `origin` is the name of the file in messages.
    ///
    /// # Errors
    /// Returns all faults found, with their places.
    pub fn parse(text: &str, origin: &str) -> Result<Scene, Diagnostics> {
        if text.len() > MAX_FILE_SIZE {
            return Err(too_large(origin));
        }
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut reader = Reader::new(text, DocumentKind::Scene);
        let root = document::parse(&mut reader, syntax::fix);
        let scene = root.as_ref().and_then(|root| {
            let draft = raw_elements::read(&mut reader, root);
            let names = copies::name_slots(&draft);
            // A variable of its own, because the copies' names live shorter than the text.
            let mut draft = draft;
            let originals = copies::expand(&mut reader, &mut draft, &names);
            elements::frame::as_vectors(&mut draft);
            let resolved = resolve::resolve(&mut reader, &draft)?;
            let figures = draft.figures.into_iter();
            Some(Scene {
                name: draft.name.unwrap_or_else(|| stem(origin)),
                source: draft.source,
                note: draft.note,
                unit: draft.unit,
                mechanism: resolved.mechanism,
                vectors: resolved.vectors,
                traces: resolved.traces,
                figures: figures.filter_map(|figure| figure.formula).collect(),
                motion: draft.driver.and_then(|driver| driver.motion),
                lead: resolved.lead,
                motor: draft.motor,
                parameters: numbers::parameters::with_values(&reader.named, draft.parameters),
                named: Arc::new(std::mem::take(&mut reader.named)),
                point_names: resolved.point_names,
                link_names: resolved.link_names,
                slide_names: resolved.slide_names,
                limits: resolved.limits,
                originals,
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
        let scene = scene.filter(|scene| numbers::formula_values::measures_fit(&mut reader, scene));
        scene.ok_or_else(|| reader.into_diagnostics(origin))
    }

    /// Returns the name of the file that the scene comes from.
    #[must_use]
    pub fn origin(&self) -> &str {
        &self.origin
    }

    /// Parses another text with the same file name; returns `None` if it is not a scene.
    #[must_use]
    pub fn reparse(&self, text: &str) -> Option<Scene> {
        Scene::parse(text, &self.origin).ok()
    }

    /// Returns the text of the file without a byte order mark; offsets of [`Scene::place`] refer to
    /// it.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Returns the place of an element in the text: the bytes of its name where it is defined.
    #[must_use]
    pub fn place(&self, element: ElementId) -> Range<usize> {
        match element {
            ElementId::Point(point) => self.places.points[point.index()].clone(),
            ElementId::Link(link) => self.places.links[link.index()].clone(),
            ElementId::Slide(slide) => self.places.slides[slide.index()].clone(),
            ElementId::Driver => self.places.driver.clone(),
        }
    }

    /// Combines diagnostics of this scene with the text that they point into.
    pub(crate) fn diagnostics(&self, items: Vec<Diagnostic>) -> Diagnostics {
        Diagnostics {
            origin: self.origin.clone(),
            text: Arc::clone(&self.text),
            items,
        }
    }

    /// Returns the name of a point; `None` for hidden points of the model. `r3.com` is the name of
    /// a centre of mass.
    #[must_use]
    pub fn point_name(&self, point: PointId) -> Option<&str> {
        self.point_names[point.index()].as_deref()
    }

    /// Returns `true` for a point of `[marks]`, which is only shown.
    #[must_use]
    pub fn is_mark(&self, point: PointId) -> bool {
        self.mechanism.point(point).is_mark
    }

    /// Returns the points listed in tables: named points except marks, in the order of the file.
    pub fn listed_points(&self) -> impl Iterator<Item = (PointId, &str)> {
        let named = |point| Some((point, self.point_name(point)?));
        let all = self.mechanism.point_ids().filter_map(named);
        all.filter(|(point, _)| !self.is_mark(*point))
    }

    /// Returns the name of a link.
    #[must_use]
    pub fn link_name(&self, link: LinkId) -> &str {
        &self.link_names[link.index()]
    }

    /// Returns the name of a limit: that of the limited element, the name given by the scene, or
    /// `driver` for the driver's range.
    #[must_use]
    pub fn limit_name(&self, limit: LimitId) -> &str {
        &self.limits[limit.index()].0
    }

    /// Returns the place of a limit's ends in the text.
    #[must_use]
    pub fn limit_place(&self, limit: LimitId) -> Range<usize> {
        self.limits[limit.index()].1.clone()
    }

    /// Returns the name of the element of the file that an element of `[copies]` is a copy of; `None`
    /// for other elements.
    #[must_use]
    pub fn original_of(&self, name: &str) -> Option<&str> {
        let mut original = self.originals.get(name)?;
        // A copy of a copy.
        while let Some(before) = self.originals.get(original) {
            original = before;
        }
        Some(original)
    }

    /// Returns `true` if the scene has copies.
    pub(crate) fn has_copies(&self) -> bool {
        !self.originals.is_empty()
    }

    /// Returns the display title; titles of presets are translated.
    #[must_use]
    pub fn title(&self) -> String {
        words().translated_scene_text(&self.name)
    }

    /// Returns the tolerances of lengths and the clearances of pins.
    #[must_use]
    pub fn tolerances(&self) -> &Tolerances {
        &self.tolerances
    }

    /// Returns the name of the link that carries the motor of an input, if a link carries it.
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

    /// Returns the display name of the driven element, including the link that carries its motor.
    #[must_use]
    pub fn driven_name(&self, input: Input) -> String {
        from_seat(self.input_name(input), self.seat_name(input))
    }

    /// Returns the name of a slide.
    #[must_use]
    pub fn slide_name(&self, slide: SlideId) -> &str {
        &self.slide_names[slide.index()]
    }
}

/// Returns the name of a driven link or slide, with the link that carries its motor, if any.
#[doc(hidden)]
pub fn from_seat(name: &str, seat: Option<&str>) -> String {
    match seat {
        Some(from) => words().turned_from(name, from),
        None => name.to_owned(),
    }
}

/// Returns the diagnostic of a file that is too large. Its true size is unknown, because reading
/// stops one byte after the limit.
#[doc(hidden)]
pub fn too_large(origin: &str) -> Diagnostics {
    let fault = Diagnostic::new(words().scene_too_large(MAX_FILE_SIZE));
    Diagnostics {
        origin: origin.to_owned(),
        text: "".into(),
        items: vec![fault],
    }
}

/// Returns the name of a file without folder and extension.
#[doc(hidden)]
pub fn stem(origin: &str) -> String {
    let stem = Path::new(origin).file_stem();
    let stem = stem.map(|s| s.to_string_lossy().into_owned());
    sanitized(&stem.unwrap_or_else(|| origin.to_owned()), false)
}

#[cfg(test)]
mod tests;
