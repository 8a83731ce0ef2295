//! Copies and mirror images of a group of links, slides and points.
//!
//! ```toml
//! [copies]
//! left = { of = ["b", "c"], mirror = "y", phase = 180 }
//! ```
//!
//! A copy is made of the elements as read, before their names are resolved. All later stages see
//! ordinary elements, whose place in the text is the name of the copy.

mod expansion;
mod placement;

pub(super) use expansion::{expand, name_slots};

use crate::document::{Diagnostic, WrittenValue, entries, items};
use crate::nearest::did_you_mean;
use crate::scene::elements::points::PlacedPoint;
use crate::scene::keys;
use crate::scene::names::invalid_part;
use crate::scene::numbers::reader::{ByteSpan, Name, Reader};
use crate::scene::table::KeyTable;
use crate::wording::words;
use crate::{Double, Vec2};
use placement::{Placement, times};

const COPY: &str = r#"left = { of = ["b", "c"], mirror = "y" }"#;
const JOIN: &str = r#"{ O = "L", F = "R" }"#;

/// Maximum number of copies of one group.
const MAX_COUNT: usize = 1000;

/// A group with its copies.
#[derive(Debug)]
pub(super) struct DraftCopy<'t> {
    /// The key, from which the names of the copies follow.
    name: Name<'t>,
    /// The links, slides and points of the group.
    of: Vec<Name<'t>>,
    count: usize,
    /// The placement of the first copy relative to the original, and of each further copy relative
    /// to the one before.
    step: Placement,
    /// The angle in degrees between the points of successive copies on links outside the group.
    phase: f64,
    phase_key: Option<ByteSpan>,
    /// The points that are replaced by others in the copy.
    join: Vec<(Name<'t>, Name<'t>)>,
}

impl DraftCopy<'_> {
    /// Returns the place of the phase, or of the copy if it has none.
    fn phase_place(&self) -> ByteSpan {
        let place = self.phase_key.as_ref();
        place.unwrap_or(&self.name.span).clone()
    }
}

/// Reads the section; `ground` has the points about which a copy can be turned.
pub(super) fn read<'v>(
    reader: &mut Reader<'_>,
    ground: &[PlacedPoint<'_>],
    value: &'v WrittenValue<'v>,
) -> Vec<DraftCopy<'v>> {
    let copies = reader.entries("[copies]", COPY, value);
    copies
        .filter_map(|(name, value)| copy(reader, ground, name, value))
        .collect()
}

fn copy<'v>(
    reader: &mut Reader<'_>,
    ground: &[PlacedPoint<'_>],
    name: Name<'v>,
    value: &'v WrittenValue<'v>,
) -> Option<DraftCopy<'v>> {
    let before = reader.found.len();
    let of = words().copy_called(&name.to_string());
    let table = &reader.open([&of, &of], keys::COPY, COPY, value)?;
    // Otherwise each name of the copy would be reported.
    if let Some(fault) = invalid_part(&name) {
        reader.report(fault);
    }
    reader.only_known(table);
    if !table.has("of") && !table.is_probable_misspelling("of") {
        reader.report(
            Diagnostic::new(words().of_has_no(&of, "of"))
                .at(name.span.clone(), words().is_missing("of"))
                .help(words().add_for_example(COPY)),
        );
    }
    let group = group(reader, table);
    let count = count(reader, table);
    let mirror = mirror(reader, table);
    let turn = reader.number_of(table, "turn").unwrap_or(0.0);
    let centre = centre(reader, ground, table);
    let shift = reader.pair_of(table, "move").unwrap_or_default();
    let phase = reader.number_of(table, "phase").unwrap_or(0.0);
    let join = join(reader, table);
    if let (Some(about), false, false) =
        (table.key("about"), table.has("turn"), table.has("mirror"))
    {
        reader.report(
            Diagnostic::new(words().about_nothing(&of))
                .at(about.span, words().neither_turns_nor_mirrors())
                .help(words().for_example("turn = 90")),
        );
    }
    let turn = times(turn, 1) + mirror.unwrap_or(Double::ZERO);
    let step = Placement::new(mirror.is_some(), turn, centre, shift);
    let is_placed = !join.is_empty() || reader.found.len() != before;
    match step.first_in_place(phase, count).filter(|_| !is_placed) {
        None => {}
        Some(1) => reader.report(
            Diagnostic::new(words().copy_in_place(&of))
                .at(name.span.clone(), words().is_where_original_is())
                .help(words().place_the_copy()),
        ),
        Some(number) => reader.report(
            Diagnostic::new(words().later_copy_in_place(&of, number))
                .at(name.span.clone(), words().is_where_original_is())
                .help(words().fewer_copies(number - 1)),
        ),
    }
    (reader.found.len() == before).then(|| DraftCopy {
        name,
        of: group,
        count,
        step,
        phase,
        phase_key: table.key("phase").map(|key| key.span),
        join,
    })
}

/// Reads the names of the group.
fn group<'v>(reader: &mut Reader<'_>, table: &KeyTable<'v>) -> Vec<Name<'v>> {
    let Some(value) = table.get("of") else {
        return Vec::new();
    };
    let what = table.what(reader, "of");
    let Some(list) = items(value) else {
        let fault = reader.mistyped(&what, words().a_list_of_elements(), value);
        reader.report(fault.help(words().add_for_example(COPY)));
        return Vec::new();
    };
    if list.is_empty() {
        reader.report(
            Diagnostic::new(words().copy_of_nothing(&table.of))
                .at(value.span(), words().expected(words().a_list_of_elements()))
                .help(words().add_for_example(COPY)),
        );
    }
    let names = list.iter().filter_map(|name| reader.string(&what, name));
    names.collect()
}

fn count(reader: &mut Reader<'_>, table: &KeyTable<'_>) -> usize {
    let number = reader.number_or(table, "count", 1.0).unwrap_or(1.0);
    #[expect(clippy::cast_precision_loss, reason = "a thousand")]
    let is_whole = number.fract() == 0.0 && number <= MAX_COUNT as f64;
    if let (false, Some(value)) = (is_whole, table.get("count")) {
        let what = table.what(reader, "count");
        let rule = words().whole_number_up_to(MAX_COUNT);
        let literal = reader.literal(&value.span());
        reader.report(
            Diagnostic::new(words().must_be(&what, &rule, &literal))
                .at(value.span(), words().expected(&rule)),
        );
        return 1;
    }
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a whole number from 1 to a thousand"
    )]
    let count = number as usize;
    count
}

/// Reads the axis of a mirror image. Returns the rotation in degrees that follows the mirror image
/// at the x axis.
fn mirror(reader: &mut Reader<'_>, table: &KeyTable<'_>) -> Option<Double> {
    let axis = reader.text_of(table, "mirror")?;
    match axis.text {
        "x" => return Some(Double::ZERO),
        "y" => return Some(Double::exactly(180.0)),
        _ => {}
    }
    let what = table.what(reader, "mirror");
    let rule = words().x_or_y();
    reader.report(
        Diagnostic::new(words().must_be(&what, rule, &axis.to_string()))
            .at(axis.span, words().expected(rule))
            .help(words().mirrors_at_axis())
            .help(words().turn_the_mirror_image()),
    );
    None
}

/// Reads the centre of the rotation: a ground point by its name, or coordinates.
fn centre(reader: &mut Reader<'_>, ground: &[PlacedPoint<'_>], table: &KeyTable<'_>) -> Vec2 {
    let Some(text) = table
        .get("about")
        .and_then(|value| value.get_ref().as_str())
    else {
        return reader.pair_of(table, "about").unwrap_or_default();
    };
    if let Some(point) = ground.iter().find(|point| point.name.text == text) {
        return point.at();
    }
    if let Some(name) = reader.text_of(table, "about") {
        let what = table.what(reader, "about");
        let rule = words().a_ground_point_or_pair();
        let known = ground.iter().map(|point| point.name.text);
        reader.report(
            Diagnostic::new(words().must_be(&what, rule, &name.to_string()))
                .at(name.span, words().expected(rule))
                .maybe_help(did_you_mean(name.text, known)),
        );
    }
    Vec2::ZERO
}

/// Reads the points that are replaced by others.
fn join<'v>(reader: &mut Reader<'_>, table: &KeyTable<'v>) -> Vec<(Name<'v>, Name<'v>)> {
    let Some(value) = table.get("join") else {
        return Vec::new();
    };
    let what = table.what(reader, "join");
    let Some(points) = reader.section(&what, JOIN, value) else {
        return Vec::new();
    };
    let pairs = entries(points).filter_map(|(from, to)| Some((from, reader.string(&what, to)?)));
    pairs.collect()
}
