//! Places in a link's frame: by coordinates, or by length and angle as dimensioned on a drawing.
//!
//! ```toml
//! points = { P = [150, 80], E = { from = "D", length = 180, angle = 72 } }
//! ```

use super::link::{DraftLink, LengthHints, length};
use super::points::PlacedPoint;
use super::reader::{Name, Reader, quoted};
use crate::document::{Diagnostic, Entries, Lenient, Misplaced, meant};
use crate::wording::words;
use crate::{Constant, Vec2, mechanism};
use serde::de::{IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::collections::{HashMap, HashSet, VecDeque};
use std::fmt;

/// The keys of a place by length and angle.
pub(super) const KEYS: [&str; 3] = ["from", "length", "angle"];
const SIGHTED: &str = r#"{ from = "D", length = 180, angle = 72 }"#;

/// A place on a link as written.
pub(super) type LinkPlace = Lenient<WrittenPlace>;
/// Named points of a link as written.
pub(super) type LinkPlaces = Lenient<Entries<LinkPlace>>;

/// A place in either form.
#[derive(Debug)]
pub(super) enum WrittenPlace {
    Pair(Vec<Lenient<f64>>),
    Sighted(Box<SightedTable>),
}

/// A place by length and angle as written.
#[derive(Debug, Default)]
pub(super) struct SightedTable {
    from: Option<Lenient<String>>,
    length: Option<Lenient<f64>>,
    angle: Option<Lenient<f64>>,
}

impl<'de> Deserialize<'de> for WrittenPlace {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ListOrTable)
    }
}

/// Accepts a list or a table only.
struct ListOrTable;

impl<'de> Visitor<'de> for ListOrTable {
    type Value = WrittenPlace;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list or a table")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<WrittenPlace, A::Error> {
        let mut items = Vec::new();
        while let Some(item) = list.next_element()? {
            items.push(item);
        }
        Ok(WrittenPlace::Pair(items))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<WrittenPlace, A::Error> {
        let mut table = SightedTable::default();
        while let Some(key) = map.next_key::<String>()? {
            match key.as_str() {
                "from" => table.from = Some(map.next_value()?),
                "length" => table.length = Some(map.next_value()?),
                "angle" => table.angle = Some(map.next_value()?),
                // The key is reported as unknown, so its value does not matter.
                _ => drop(map.next_value::<Lenient<IgnoredAny>>()?),
            }
        }
        Ok(WrittenPlace::Sighted(Box::new(table)))
    }
}

/// A place by length and angle.
#[derive(Debug)]
pub(super) struct Sighted<'t> {
    /// The reference point on the link; `None` for the origin of its frame.
    pub(super) from: Option<Name<'t>>,
    pub(super) length: f64,
    /// The angle in degrees.
    pub(super) angle: f64,
}

/// A place on a link, as far as it could be read.
#[derive(Debug)]
pub(super) enum ReadPlace<'t> {
    At(Vec2),
    Sighted(Sighted<'t>),
}

/// Reads a place; a missing key is reported at `owner`.
pub(super) fn place<'v>(
    reader: &mut Reader<'_>,
    what: &str,
    owner: &Name<'_>,
    value: &'v LinkPlace,
) -> Option<ReadPlace<'v>> {
    match &value.read {
        Ok(WrittenPlace::Sighted(table)) => {
            reader.only_these(what, &value.keys, &KEYS);
            sighted(reader, what, owner, value, table).map(ReadPlace::Sighted)
        }
        Ok(WrittenPlace::Pair(items)) => {
            reader.pair_of(what, items, &value.span).map(ReadPlace::At)
        }
        Err(found) => {
            not_a_place(reader, what, found, value);
            None
        }
    }
}

fn not_a_place(reader: &mut Reader<'_>, what: &str, found: &Misplaced, value: &LinkPlace) {
    let fault = reader.wrong_type(what, &words().a_pair("[x, y]"), found, &value.span);
    reader.report(
        fault
            .help(words().for_example("[12.5, 0]"))
            .help(words().or_by_length_and_angle(SIGHTED)),
    );
}

fn sighted<'v>(
    reader: &mut Reader<'_>,
    what: &str,
    owner: &Name<'_>,
    value: &LinkPlace,
    table: &'v SightedTable,
) -> Option<Sighted<'v>> {
    for (key, is_given) in [
        ("length", table.length.is_some()),
        ("angle", table.angle.is_some()),
    ] {
        // A misspelt key was already reported; do not report the missing key as well.
        if !is_given && !meant(&value.keys, &KEYS, key) {
            reader.report(
                Diagnostic::new(words().of_has_no(what, key))
                    .at(owner.span.clone(), words().is_missing(key))
                    .help(words().for_example(SIGHTED)),
            );
        }
    }
    let from = reader.text_of("from", what, table.from.as_ref());
    let given = table.length.as_ref();
    let length = given.and_then(|given| length(reader, what, given, &LengthHints::of_point()));
    let key = words().key_of("angle", what) + " (deg)";
    let angle = table.angle.as_ref().and_then(|v| reader.number(&key, v));
    let is_lost = table.from.is_some() && from.is_none();
    let (length, angle) = (length?, angle?);
    (!is_lost).then_some(Sighted {
        from,
        length,
        angle,
    })
}

/// Computes the coordinates of a link's points given by length and angle, and sorts points after
/// their reference points.
pub(super) fn lay(reader: &mut Reader<'_>, of: &str, link: &mut DraftLink<'_>) {
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
                base.map(|base| mechanism::seen_from(base, sighted.length, sighted.angle))
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
pub(super) fn lay_centre(
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
    let place = mechanism::seen_from(base.map(Constant::given), sighted.length, sighted.angle);
    Some(place.map(|v| v.hi))
}
