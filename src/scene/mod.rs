//! The scene file: a mechanism with names, a unit and a place for every element in the text.

mod defect;
mod diagnostic;
mod draft;
mod elements;
mod guide;
mod harmless;
mod input;
mod names;
pub mod presets;
mod rate;
mod reader;
mod resolve;
mod syntax;
mod unit;

pub use diagnostic::{Diagnostic, Diagnostics, Label};
pub use harmless::{escaped, harmless, is_harmful};
pub use unit::Unit;

use crate::{Element, LinkId, Mechanism, PointId, SlideId};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

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
    pub(crate) point_names: Vec<Option<String>>,
    pub(crate) link_names: Vec<String>,
    pub(crate) slide_names: Vec<String>,
    places: Places,
    origin: String,
    text: Arc<str>,
}

/// Where the elements stand in the text, as ranges of bytes.
#[derive(Clone, Debug, Default)]
struct Places {
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
            return Err(too_large(bytes.len(), origin));
        }
        match std::str::from_utf8(bytes) {
            Ok(text) => Scene::parse(text, origin),
            Err(error) => Err(not_utf8(bytes, error.valid_up_to(), origin)),
        }
    }

    /// Reads a scene from a text; `origin` is the name of the file in messages.
    ///
    /// # Errors
    /// Everything found wrong, with its places.
    pub fn parse(text: &str, origin: &str) -> Result<Scene, Diagnostics> {
        if text.len() > LARGEST_FILE {
            return Err(too_large(text.len(), origin));
        }
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut reader = reader::Reader::new(text);
        let scene = syntax::document(&mut reader).and_then(|root| {
            let draft = draft::read(&mut reader, &root);
            let resolved = resolve::resolve(&mut reader, &draft)?;
            Some(Scene {
                name: draft.name.unwrap_or_else(|| stem(origin)),
                source: draft.source,
                note: draft.note,
                unit: draft.unit,
                mechanism: resolved.mechanism,
                vectors: resolved.vectors,
                point_names: resolved.point_names,
                link_names: resolved.link_names,
                slide_names: resolved.slide_names,
                places: resolved.places,
                origin: origin.to_owned(),
                text: text.into(),
            })
        });
        scene.ok_or_else(|| reader.into_diagnostics(origin))
    }

    /// The name of the file that the scene comes from.
    #[must_use]
    pub fn origin(&self) -> &str {
        &self.origin
    }

    /// The text of the file.
    #[must_use]
    pub fn text(&self) -> &Arc<str> {
        &self.text
    }

    /// Where an element stands in the text: the bytes of its name where it is defined.
    #[must_use]
    pub fn place(&self, element: Element) -> Range<usize> {
        match element {
            Element::Point(point) => self.places.points[point.index()].clone(),
            Element::Link(link) => self.places.links[link.index()].clone(),
            Element::Slide(slide) => self.places.slides[slide.index()].clone(),
            Element::Driver => self.places.driver.clone(),
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

    /// A link's name.
    #[must_use]
    pub fn link_name(&self, link: LinkId) -> &str {
        &self.link_names[link.index()]
    }

    /// A slide's name.
    #[must_use]
    pub fn slide_name(&self, slide: SlideId) -> &str {
        &self.slide_names[slide.index()]
    }
}

fn too_large(bytes: usize, origin: &str) -> Diagnostics {
    let fault = Diagnostic::new(format!(
        "the file has {bytes} bytes; a scene may have at most {LARGEST_FILE} (1 MiB)"
    ));
    Diagnostics {
        origin: origin.to_owned(),
        text: "".into(),
        items: vec![fault],
    }
}

/// The fault of a file that is no text. What comes before the first bad byte keeps its place in the
/// text that is shown; bad bytes become replacement characters.
fn not_utf8(bytes: &[u8], at: usize, origin: &str) -> Diagnostics {
    let shown = String::from_utf8_lossy(bytes);
    let end = at + char::REPLACEMENT_CHARACTER.len_utf8();
    let bad = bytes.get(at).copied().unwrap_or_default();
    let fault = Diagnostic::new(format!(
        "the file is not UTF-8: byte 0x{bad:02x} at offset {at}"
    ))
    .at(at..end, "not a character in UTF-8")
    .help("save the file as UTF-8");
    Diagnostics {
        origin: origin.to_owned(),
        text: shown.into(),
        items: vec![fault],
    }
}

/// The name of a file without folder and ending.
fn stem(origin: &str) -> String {
    let stem = Path::new(origin).file_stem();
    let stem = stem.map(|s| s.to_string_lossy().into_owned());
    harmless(&stem.unwrap_or_else(|| origin.to_owned()), false)
}

#[cfg(test)]
mod refusals;
#[cfg(test)]
mod tests;
