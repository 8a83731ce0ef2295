//! Places in a link's frame: by coordinates, or by length and angle as dimensioned on a drawing.
//!
//! ```toml
//! points = { P = [150, 80], E = { from = "D", length = 180, angle = 72 } }
//! ```

use crate::document::{Diagnostic, WrittenValue, items};
use crate::scene::elements::link::DraftLink;
use crate::scene::elements::points::PlacedPoint;
use crate::scene::keys;
use crate::scene::numbers::reader::{Name, Reader, quoted};
use crate::scene::table::KeyTable;
use crate::wording::words;
use crate::{Constant, Vec2, mechanism};
use std::collections::{HashMap, HashSet, VecDeque};

const SIGHTED: &str = r#"{ from = "D", length = 180, angle = 72 }"#;

/// A place by length and angle.
#[derive(Debug)]
pub(crate) struct Sighted<'t> {
    /// The reference point on the link; `None` for the origin of its frame.
    pub(crate) from: Option<Name<'t>>,
    pub(crate) length: f64,
    /// The angle in degrees.
    pub(crate) angle: f64,
}

/// A place on a link, as far as it could be read.
#[derive(Debug)]
pub(crate) enum ReadPlace<'t> {
    At(Vec2),
    Sighted(Sighted<'t>),
}

/// Reads a place; a missing key is reported at `owner`.
pub(crate) fn place<'v>(
    reader: &mut Reader<'_>,
    what: &str,
    owner: &Name<'_>,
    value: &'v WrittenValue<'v>,
) -> Option<ReadPlace<'v>> {
    if let Some(entries) = value.get_ref().as_table() {
        let table = KeyTable::new(what, keys::PLACE, entries, value.span());
        return sighted(reader, owner, &table).map(ReadPlace::Sighted);
    }
    if items(value).is_some() {
        return reader.pair(what, value).map(ReadPlace::At);
    }
    let fault = reader.mistyped(what, &words().a_pair("[x, y]"), value);
    reader.report(
        fault
            .help(words().for_example("[12.5, 0]"))
            .help(words().or_by_length_and_angle(SIGHTED)),
    );
    None
}

fn sighted<'v>(
    reader: &mut Reader<'_>,
    owner: &Name<'_>,
    table: &KeyTable<'v>,
) -> Option<Sighted<'v>> {
    reader.only_known(table);
    for key in ["length", "angle"] {
        reader.require(table, key, &owner.span, SIGHTED);
    }
    let from = reader.text_of(table, "from");
    let length = reader.number_of(table, "length");
    let angle = reader.number_of(table, "angle");
    let is_lost = table.has("from") && from.is_none();
    let (length, angle) = (length?, angle?);
    (!is_lost).then_some(Sighted {
        from,
        length,
        angle,
    })
}

/// Computes the coordinates of a link's points given by length and angle, and sorts points after
/// their reference points.
pub(crate) fn compute_polar_points(reader: &mut Reader<'_>, of: &str, link: &mut DraftLink<'_>) {
    let ends = link.ends.iter().flat_map(|ends| {
        let to = Vec2::new(ends.length, 0.0).map(Constant::given);
        [
            (ends.from.text, Vec2::ZERO.map(Constant::given)),
            (ends.to.text, to),
        ]
    });
    let mut laid: HashMap<&str, Vec2<Constant>> = ends.collect();
    let mut waiting: HashMap<&str, Vec<PlacedPoint<'_>>> = HashMap::new();
    let mut ready: Vec<PlacedPoint<'_>> = Vec::new();
    let names: HashSet<&str> = link.points.iter().map(|point| point.name.text).collect();
    let mut placed = Vec::with_capacity(link.points.len());
    let mut queue: VecDeque<_> = std::mem::take(&mut link.points).into();
    while let Some(mut point) = ready.pop().or_else(|| queue.pop_front()) {
        let place = match &point.sighted {
            None => Some(point.at().map(Constant::given)),
            Some(sighted) => {
                let base = match &sighted.from {
                    None => Some(Vec2::ZERO.map(Constant::given)),
                    Some(from) => laid.get(from.text).copied(),
                };
                base.map(|base| mechanism::polar_position(base, sighted.length, sighted.angle))
            }
        };
        let Some(place) = place else {
            let from = point.sighted.as_ref().and_then(|s| s.from.as_ref());
            let from = from.map_or("", |from| from.text);
            waiting.entry(from).or_default().push(point);
            continue;
        };
        if point.sighted.is_some() {
            point.read = Some(place.map(|v| v.hi));
        }
        laid.entry(point.name.text).or_insert(place);
        let mut seen = waiting.remove(point.name.text).unwrap_or_default();
        // `ready` is popped from its end.
        seen.reverse();
        ready.append(&mut seen);
        placed.push(point);
    }
    let mut left: Vec<PlacedPoint<'_>> = waiting.into_values().flatten().collect();
    left.sort_by_key(|point| point.name.span.start);
    for point in &mut left {
        let from = point.sighted.take().and_then(|sighted| sighted.from);
        if let Some(from) = from {
            let known = names.contains(from.text);
            reader.report(unseen(of, &point.name, &from, known));
        }
    }
    placed.append(&mut left);
    link.points = placed;
}

/// Returns the diagnostic of a point whose reference point is not on its link, or depends on the
/// point itself.
fn unseen(of: &str, name: &Name<'_>, from: &Name<'_>, known: bool) -> Diagnostic {
    let what = format!("{} {}", words().point_in(of), quoted(name.text));
    if known {
        return Diagnostic::new(words().seen_from_itself(&what))
            .at(from.span.clone(), words().seen_in_a_circle())
            .help(words().begin_with_an_end());
    }
    not_on_link(&what, of, from)
}

fn not_on_link(what: &str, of: &str, from: &Name<'_>) -> Diagnostic {
    let key = words().key_of("from", what);
    Diagnostic::new(words().must_be_point_of(&key, of, &from.to_string()))
        .at(from.span.clone(), words().no_point_of(of))
        .help(words().name_another_point_of(of))
}

/// Computes the coordinates of a centre of mass; reports a reference point that is not on the link.
pub(crate) fn compute_centre(
    reader: &mut Reader<'_>,
    of: &str,
    sighted: &Sighted<'_>,
    link: &DraftLink<'_>,
) -> Option<Vec2> {
    let base = match &sighted.from {
        None => Vec2::ZERO,
        Some(from) => match link.local(from.text) {
            Some(base) => base,
            None => {
                reader.report(not_on_link(&words().key_of("com", of), of, from));
                return None;
            }
        },
    };
    let position =
        mechanism::polar_position(base.map(Constant::given), sighted.length, sighted.angle);
    Some(position.map(|v| v.hi))
}
