//! Reads named places, and the vectors between them.

use crate::Vec2;
use crate::document::WrittenValue;
use crate::scene::elements::link_points::{ReadPlace, Sighted};
use crate::scene::numbers::reader::{Name, Reader, quoted};
use crate::wording::words;

const VECTOR: &str = r#"r1 = ["D", "A"]"#;

/// A point with coordinates in the frame of its section or link.
#[derive(Debug)]
pub(crate) struct PlacedPoint<'t> {
    pub(crate) name: Name<'t>,
    /// `None` if the coordinates could not be read.
    pub(crate) read: Option<Vec2>,
    /// The length and angle that define the coordinates, for points of a link given in this form.
    pub(crate) sighted: Option<Sighted<'t>>,
}

impl<'t> PlacedPoint<'t> {
    /// Creates a point of a link from its place as read. A point given by length and angle has no
    /// coordinates yet.
    pub(crate) fn read_as(name: Name<'t>, place: Option<ReadPlace<'t>>) -> Self {
        let (read, sighted) = match place {
            None => (None, None),
            Some(ReadPlace::At(at)) => (Some(at), None),
            Some(ReadPlace::Sighted(sighted)) => (None, Some(sighted)),
        };
        PlacedPoint {
            name,
            read,
            sighted,
        }
    }

    /// Returns the coordinates, or a placeholder.
    pub(crate) fn at(&self) -> Vec2 {
        self.read.unwrap_or_default()
    }
}

/// Reads a table of points with coordinates.
pub(crate) fn places<'v>(
    reader: &mut Reader<'_>,
    section: &str,
    what: &str,
    value: &'v WrittenValue<'v>,
) -> Vec<PlacedPoint<'v>> {
    let entries = reader.entries(section, "{ A = [0, 0] }", value);
    let place = |(name, value): (Name<'v>, &WrittenValue<'_>)| {
        let read = reader.pair(&format!("{what} {}", quoted(name.text)), value);
        PlacedPoint {
            name,
            read,
            sighted: None,
        }
    };
    entries.map(place).collect()
}

#[derive(Debug)]
pub(crate) struct DraftVector<'t> {
    pub(crate) name: Name<'t>,
    pub(crate) tail: Name<'t>,
    pub(crate) head: Name<'t>,
}

/// Reads the section. Reports and omits vectors that could not be read.
pub(crate) fn vectors<'v>(
    reader: &mut Reader<'_>,
    value: &'v WrittenValue<'v>,
) -> Vec<DraftVector<'v>> {
    let entries = reader.entries("[vectors]", VECTOR, value);
    entries
        .filter_map(|(name, value)| vector(reader, name, value))
        .collect()
}

fn vector<'v>(
    reader: &mut Reader<'_>,
    name: Name<'v>,
    value: &'v WrittenValue<'v>,
) -> Option<DraftVector<'v>> {
    let what = words().vector_called(&quoted(name.text));
    let [tail, head] = reader.two(&what, words().a_pair_of_points(), r#"["D", "A"]"#, value)?;
    let tail = reader.string(&words().tail_of(&what), tail);
    let head = reader.string(&words().head_of(&what), head);
    Some(DraftVector {
        tail: tail?,
        head: head?,
        name,
    })
}
