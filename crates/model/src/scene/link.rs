//! Reads links.

use super::deviations::{self, DraftTolerance};
use super::points::PlacedPoint;
use super::reader::{ByteSpan, MIN_LENGTH, Name, Reader, quoted};
use super::sighted::{self, LinkPlace, LinkPlaces};
use crate::Vec2;
use crate::document::{Diagnostic, Entries, Lenient};
use crate::wording::words;
use serde::Deserialize;

/// Maximum number of links of a scene.
const MAX_LINKS: usize = 10_000;

const LINK: &str = r#"r2 = { from = "A", to = "B", length = 100 }"#;
const POINTS: &str = "r2 = { points = { A = [0, 0] } }";

/// The section `[links]` as written.
pub(super) type Links = Lenient<Entries<Lenient<LinkTable>>>;

/// A link as written.
#[derive(Debug, Deserialize)]
pub(super) struct LinkTable {
    from: Option<Lenient<String>>,
    to: Option<Lenient<String>>,
    length: Option<Lenient<f64>>,
    points: Option<LinkPlaces>,
    com: Option<LinkPlace>,
    mass: Option<Lenient<f64>>,
    inertia: Option<Lenient<f64>>,
    tolerance: Option<Lenient<f64>>,
}

#[derive(Debug)]
pub(super) struct DraftLink<'t> {
    pub(super) name: Name<'t>,
    pub(super) ends: Option<Ends<'t>>,
    pub(super) points: Vec<PlacedPoint<'t>>,
    /// The centre of mass; its name is the key.
    pub(super) com: Option<PlacedPoint<'t>>,
    pub(super) mass: f64,
    pub(super) inertia: f64,
    /// The place of the key `mass`, or of `inertia` if there is no mass.
    pub(super) mass_key: Option<(&'static str, ByteSpan)>,
    /// The tolerance of its length and of the coordinates of its points.
    pub(super) tolerance: Option<DraftTolerance>,
    /// Whether a diagnostic was reported for the link.
    pub(super) broken: bool,
}

impl<'t> DraftLink<'t> {
    /// Returns the names of its points, the ends first.
    pub(super) fn point_names(&self) -> impl Iterator<Item = &Name<'t>> {
        let ends = self.ends.iter().flat_map(|ends| [&ends.from, &ends.to]);
        ends.chain(self.points.iter().map(|p| &p.name))
    }

    /// Returns the coordinates of one of the link's points in the link's frame; `None` if it is not
    /// on the link.
    pub(super) fn local(&self, point: &str) -> Option<Vec2> {
        let ends = self.ends.as_ref().and_then(|ends| {
            if ends.from.text == point {
                Some(Vec2::ZERO)
            } else {
                (ends.to.text == point).then(|| Vec2::new(ends.length, 0.0))
            }
        });
        let listed = || self.points.iter().find(|p| p.name.text == point);
        ends.or_else(|| listed().map(PlacedPoint::at))
    }
}

#[derive(Debug)]
pub(super) struct Ends<'t> {
    pub(super) from: Name<'t>,
    pub(super) to: Name<'t>,
    pub(super) length: f64,
}

/// Returns the diagnostic of a scene without links and slides; other missing parts follow from
/// that.
pub(super) fn nothing_moves() -> Diagnostic {
    Diagnostic::new(words().no_links()).help(words().add_for_example(&format!("[links]\n{LINK}")))
}

/// The links of a scene, and the parts lost by faults in them.
#[derive(Debug, Default)]
pub(super) struct Read<'t> {
    pub(super) links: Vec<DraftLink<'t>>,
    /// Whether the number of links exceeds the maximum.
    pub(super) too_many: bool,
    /// Whether a link names an unreadable point.
    pub(super) lost_points: bool,
}

/// Reads the section.
pub(super) fn links<'v>(reader: &mut Reader<'_>, value: &'v Links) -> Read<'v> {
    let mut read = Read::default();
    reader.table("[links]", LINK, value);
    let count = value.keys.len();
    if value.get().is_some() && count > MAX_LINKS {
        reader.report(
            Diagnostic::new(words().links_above_most(count, MAX_LINKS))
                .at(value.span.clone(), words().are_too_many_links()),
        );
        read.too_many = true;
        return read;
    }
    for (name, value) in value.entries() {
        let link = link(reader, &mut read.lost_points, name, value);
        read.links.push(link);
    }
    read
}

fn link<'v>(
    reader: &mut Reader<'_>,
    lost_points: &mut bool,
    name: Name<'v>,
    value: &'v Lenient<LinkTable>,
) -> DraftLink<'v> {
    let before = reader.found.len();
    let mut link = DraftLink {
        name,
        ends: None,
        points: Vec::new(),
        com: None,
        mass: 0.0,
        inertia: 0.0,
        mass_key: None,
        tolerance: None,
        broken: false,
    };
    let of = words().link_called(&link.name.to_string());
    if let Some(table) = reader.table(&of, LINK, value) {
        reader.only(&of, value);
        *lost_points |= !link_ends(reader, &of, value, table, &mut link);
        *lost_points |= !link_points(reader, &of, value, table, &mut link);
        link_mass(reader, &of, value, table, &mut link);
        let tolerance = table.tolerance.as_ref();
        let what = words().key_of("tolerance", &of);
        link.tolerance = tolerance.and_then(|value| deviations::tolerance(reader, &what, value));
        if reader.found.len() == before && link.ends.is_none() && link.points.is_empty() {
            reader.report(no_points(&of, &link.name));
        }
    } else {
        *lost_points = true;
    }
    link.broken = reader.found.len() > before;
    link
}

fn no_points(of: &str, name: &Name<'_>) -> Diagnostic {
    Diagnostic::new(words().link_has_no_points(of))
        .at(name.span.clone(), words().needs_ends_or_points())
        .help(words().for_example(LINK))
        .help(words().or_single_joint(POINTS))
}

/// Reads `from`, `to` and `length`, which belong together. An end without the others still names
/// its point. Returns `true` if no end was lost.
fn link_ends<'v>(
    reader: &mut Reader<'_>,
    of: &str,
    value: &Lenient<LinkTable>,
    table: &'v LinkTable,
    link: &mut DraftLink<'v>,
) -> bool {
    let from = reader.text_of("from", of, table.from.as_ref());
    let to = reader.text_of("to", of, table.to.as_ref());
    let given = table.length.as_ref();
    let length = given.map(|given| length(reader, of, given, &LengthHints::of_link()));
    let (has_from, has_to) = (table.from.is_some(), table.to.is_some());
    let missing = match (has_from, has_to, length.is_some()) {
        (false, false, false) | (true, true, true) => None,
        (true, true, false) => Some(words().ends_without_length()),
        (true, false, _) => Some(words().only_from()),
        (false, true, _) => Some(words().only_to()),
        (false, false, true) => Some(words().length_without_ends()),
    };
    if let Some(missing) = missing {
        // A misspelt key was already reported; do not report the missing key as well.
        let misspelt = ["from", "to", "length"]
            .into_iter()
            .any(|key| value.key(key).is_none() && value.meant(key));
        if !misspelt {
            reader.report(incomplete(of, missing, link.name.span.clone()));
        }
    }
    match (from, to) {
        (Some(from), Some(to)) => {
            let length = length.flatten().unwrap_or(1.0);
            link.ends = Some(Ends { from, to, length });
            true
        }
        (one, other) => {
            let named = one.into_iter().chain(other);
            link.points.extend(named.map(|name| PlacedPoint {
                name,
                read: None,
                sighted: None,
            }));
            missing.is_none() && !has_from && !has_to
        }
    }
}

/// Reads the further points. Returns `true` if none was lost.
fn link_points<'v>(
    reader: &mut Reader<'_>,
    of: &str,
    value: &Lenient<LinkTable>,
    table: &'v LinkTable,
    link: &mut DraftLink<'v>,
) -> bool {
    let Some(points) = &table.points else {
        return !value.meant("points");
    };
    reader.table(&words().key_of("points", of), "{ A = [0, 0] }", points);
    for (name, value) in points.entries() {
        let what = format!("{} {}", words().point_in(of), quoted(name.text));
        let place = sighted::place(reader, &what, &name, value);
        link.points.push(PlacedPoint::read_as(name, place));
    }
    sighted::lay(reader, of, link);
    points.get().is_some()
}

fn link_mass<'v>(
    reader: &mut Reader<'_>,
    of: &str,
    value: &'v Lenient<LinkTable>,
    table: &'v LinkTable,
    link: &mut DraftLink<'v>,
) {
    let key = |name| Some((name, value.key(name)?.span()));
    if let (Some(com), Some(key)) = (&table.com, value.key("com")) {
        let name = Name::of_key(key);
        let place = sighted::place(reader, &words().key_of("com", of), &name, com);
        let mut com = PlacedPoint::read_as(name, place);
        if let Some(sighted) = &com.sighted {
            com.read = sighted::lay_centre(reader, of, sighted, link);
        }
        link.com = Some(com);
    }
    link.mass = reader.not_negative(of, "mass", "", table.mass.as_ref());
    link.inertia = reader.not_negative(of, "inertia", "", table.inertia.as_ref());
    link.mass_key = key("mass").or_else(|| key("inertia"));
}

fn incomplete(of: &str, missing: &str, span: ByteSpan) -> Diagnostic {
    Diagnostic::new(words().of_has(of, missing))
        .at(span, words().ends_and_length())
        .help(words().for_example(LINK))
        .help(words().points_alone(POINTS))
}

/// The hints in diagnostics of an invalid length.
pub(super) struct LengthHints {
    /// The consequence of a zero length, and its fix.
    nought: [&'static str; 2],
    /// The fix for a negative length.
    negative: &'static str,
}

impl LengthHints {
    fn of_link() -> LengthHints {
        LengthHints {
            nought: [words().no_direction(), words().give_joints_one_name()],
            negative: words().length_is_distance(),
        }
    }

    /// Returns the hints for a point given by length and angle.
    pub(super) fn of_point() -> LengthHints {
        LengthHints {
            nought: [words().no_place_of_its_own(), words().leave_point_out()],
            negative: words().turn_angle_by_half(),
        }
    }
}

/// Reads a distance: positive, and not too small to compute with.
pub(super) fn length(
    reader: &mut Reader<'_>,
    of: &str,
    value: &Lenient<f64>,
    hints: &LengthHints,
) -> Option<f64> {
    let length = reader.number(&words().key_of("length", of), value)?;
    let literal = reader.literal(&value.span);
    let fault = |rule: &str, label: &str| {
        Diagnostic::new(words().must_be(&words().key_of("length", of), rule, &literal))
            .at(value.span.clone(), label)
    };
    if length >= MIN_LENGTH {
        return Some(length);
    }
    reader.report(if length > 0.0 {
        fault(words().at_least_smallest(), words().too_small_to_compute())
            .help(words().choose_a_unit())
    } else if length == 0.0 {
        let [label, help] = hints.nought;
        fault(words().positive(), label).help(help)
    } else {
        fault(words().positive(), words().is_not_positive()).help(hints.negative)
    });
    None
}
