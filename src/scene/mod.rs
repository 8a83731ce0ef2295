//! The scene file: a mechanism with names, a unit and a place for every element in the text.

mod unit;

pub use unit::Unit;

use crate::{LinkId, Mechanism, PointId, SlideId};

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
