//! Reads named places, and the vectors between them.

use crate::Vec2;
use crate::document::WrittenValue;
use crate::scene::elements::link_points::{ReadPlace, Sighted, Triangle};
use crate::scene::numbers::reader::{Name, Reader, quoted};
use crate::wording::words;

const VECTOR: &str = r#"r1 = ["D", "A"]"#;

/// A point with coordinates in the frame of its section or link.
#[derive(Clone, Debug)]
pub(crate) struct PlacedPoint<'t> {
    pub(crate) name: Name<'t>,
    /// `None` if the coordinates could not be read.
    pub(crate) read: Option<Vec2>,
    /// The length and angle that define the coordinates, for points of a link given in this form.
    pub(crate) sighted: Option<Sighted<'t>>,
    /// The distances from which the coordinates of a point of a link are to be computed.
    pub(crate) triangle: Option<Triangle<'t>>,
}

impl<'t> PlacedPoint<'t> {
    /// Creates a point with coordinates, if they could be read.
    pub(crate) fn new(name: Name<'t>, read: Option<Vec2>) -> Self {
        PlacedPoint {
            name,
            read,
            sighted: None,
            triangle: None,
        }
    }

    /// Creates a point of a link from its place as read. A point given by length and angle or by
    /// two distances has no coordinates yet.
    pub(crate) fn read_as(name: Name<'t>, place: Option<ReadPlace<'t>>) -> Self {
        let mut point = PlacedPoint::new(name, None);
        match place {
            None => {}
            Some(ReadPlace::At(at)) => point.read = Some(at),
            Some(ReadPlace::Sighted(sighted)) => point.sighted = Some(sighted),
            Some(ReadPlace::Triangle(triangle)) => point.triangle = Some(triangle),
        }
        point
    }

    /// Returns the points of the link from which it is measured.
    pub(crate) fn references(&self) -> impl Iterator<Item = &Name<'t>> {
        let polar = self.sighted.iter().flat_map(|sighted| &sighted.from);
        let corner = self.triangle.iter().flat_map(|triangle| &triangle.from);
        polar.chain(corner)
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
        PlacedPoint::new(name, read)
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
