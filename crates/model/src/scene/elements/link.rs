//! Reads links.

use crate::Vec2;
use crate::document::{self, Diagnostic, WrittenValue, items};
use crate::scene::accuracy::deviations::{self, DraftTolerance};
use crate::scene::elements::drawn::{self, DrawnPlaces};
use crate::scene::elements::link_points;
use crate::scene::elements::points::PlacedPoint;
use crate::scene::keys;
use crate::scene::numbers::reader::{ByteSpan, Name, Reader, quoted};
use crate::scene::table::KeyTable;
use crate::wording::words;

/// Maximum number of links of a scene.
pub(crate) const MAX_LINKS: usize = 10_000;

const LINK: &str = r#"r2 = { from = "A", to = "B", length = 100 }"#;
const POINTS: &str = "r2 = { points = { A = [0, 0] } }";

#[derive(Clone, Debug)]
pub(crate) struct DraftLink<'t> {
    pub(crate) name: Name<'t>,
    pub(crate) ends: Option<Ends<'t>>,
    /// The direction of a link as drawn, in degrees.
    pub(crate) direction: Option<f64>,
    pub(crate) points: Vec<PlacedPoint<'t>>,
    /// The centre of mass; its name is the key.
    pub(crate) com: Option<PlacedPoint<'t>>,
    pub(crate) mass: f64,
    pub(crate) inertia: f64,
    /// The key `mass`, or `inertia` if there is no mass.
    pub(crate) mass_key: Option<Name<'t>>,
    /// The tolerance of its length and of the coordinates of its points.
    pub(crate) tolerance: Option<DraftTolerance>,
    /// Whether a diagnostic was reported for the link.
    pub(crate) broken: bool,
    /// Whether it names an unreadable point.
    pub(crate) has_lost_points: bool,
}

impl<'t> DraftLink<'t> {
    /// Returns the names of its points, the ends first.
    pub(crate) fn point_names(&self) -> impl Iterator<Item = &Name<'t>> {
        let ends = self.ends.iter().flat_map(|ends| [&ends.from, &ends.to]);
        ends.chain(self.points.iter().map(|p| &p.name))
    }

    /// Returns the coordinates of one of the link's points in the link's frame; `None` if it is not
    /// on the link.
    pub(crate) fn local(&self, point: &str) -> Option<Vec2> {
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

#[derive(Clone, Debug)]
pub(crate) struct Ends<'t> {
    pub(crate) from: Name<'t>,
    pub(crate) to: Name<'t>,
    pub(crate) length: f64,
}

/// Returns the diagnostic of a scene without links and slides; other missing parts follow from
/// that.
pub(crate) fn nothing_moves() -> Diagnostic {
    Diagnostic::new(words().no_links()).help(words().add_for_example(&format!("[links]\n{LINK}")))
}

/// The links of a scene, and the parts lost by faults in them.
#[derive(Debug, Default)]
pub(crate) struct Read<'t> {
    pub(crate) links: Vec<DraftLink<'t>>,
    /// Whether the number of links exceeds the maximum.
    pub(crate) too_many: bool,
    /// Whether a link names an unreadable point.
    pub(crate) lost_points: bool,
}

/// Reads the section; `places` has the coordinates of links as drawn.
pub(crate) fn links<'v>(
    reader: &mut Reader<'_>,
    places: &DrawnPlaces<'_>,
    value: &'v WrittenValue<'v>,
) -> Read<'v> {
    let mut read = Read::default();
    let Some(entries) = reader.section("[links]", LINK, value) else {
        return read;
    };
    let count = entries.len();
    if count > MAX_LINKS {
        reader.report(
            Diagnostic::new(words().links_above_most(count, MAX_LINKS))
                .at(value.span(), words().are_too_many_links()),
        );
        read.too_many = true;
        return read;
    }
    for (name, value) in document::entries(entries) {
        let link = link(reader, places, name, value);
        read.lost_points |= link.has_lost_points;
        read.links.push(link);
    }
    read
}

fn link<'v>(
    reader: &mut Reader<'_>,
    places: &DrawnPlaces<'_>,
    name: Name<'v>,
    value: &'v WrittenValue<'v>,
) -> DraftLink<'v> {
    let before = reader.found.len();
    let mut link = DraftLink {
        name,
        ends: None,
        direction: None,
        points: Vec::new(),
        com: None,
        mass: 0.0,
        inertia: 0.0,
        mass_key: None,
        tolerance: None,
        broken: false,
        has_lost_points: false,
    };
    let of = words().link_called(&link.name.to_string());
    if let Some(table) = reader.open([&of, &of], keys::LINK, LINK, value) {
        reader.only_known(&table);
        let list = table.get("points").filter(|points| items(points).is_some());
        let is_complete = match list {
            Some(list) => drawn::link_points(reader, &table, list, places, &mut link),
            None => {
                let has_ends = link_ends(reader, &table, &mut link);
                link_points(reader, &table, &mut link) && has_ends
            }
        };
        link.has_lost_points = !is_complete;
        link_mass(reader, &table, &mut link);
        link.tolerance = deviations::tolerance_of(reader, &table);
        if reader.found.len() == before && link.ends.is_none() && link.points.is_empty() {
            reader.report(no_points(&of, &link.name));
        }
    } else {
        link.has_lost_points = true;
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
fn link_ends<'v>(reader: &mut Reader<'_>, table: &KeyTable<'v>, link: &mut DraftLink<'v>) -> bool {
    let from = reader.text_of(table, "from");
    let to = reader.text_of(table, "to");
    let length = reader.number_of(table, "length");
    let ends = ["from", "to", "length"];
    let given = ends.map(|key| table.has(key));
    let missing = match given {
        [false, false, false] | [true, true, true] => None,
        [true, true, false] => Some(words().ends_without_length()),
        [true, false, _] => Some(words().only_from()),
        [false, true, _] => Some(words().only_to()),
        [false, false, true] => Some(words().length_without_ends()),
    };
    if let Some(missing) = missing {
        // A misspelt key was already reported; do not report the missing key as well.
        let misspelt = |key: &&str| !table.has(key) && table.is_probable_misspelling(key);
        if !ends.iter().any(misspelt) {
            reader.report(incomplete(&table.of, missing, link.name.span.clone()));
        }
    }
    match (from, to) {
        (Some(from), Some(to)) => {
            let length = length.unwrap_or(1.0);
            link.ends = Some(Ends { from, to, length });
            true
        }
        (one, other) => {
            let named = one.into_iter().chain(other);
            link.points
                .extend(named.map(|name| PlacedPoint::new(name, None)));
            missing.is_none() && !table.has("from") && !table.has("to")
        }
    }
}

/// Reads the further points. Returns `true` if none was lost.
fn link_points<'v>(
    reader: &mut Reader<'_>,
    table: &KeyTable<'v>,
    link: &mut DraftLink<'v>,
) -> bool {
    let Some(points) = table.get("points") else {
        return !table.is_probable_misspelling("points");
    };
    let (of, what) = (&table.of, table.what(reader, "points"));
    for (name, value) in reader.entries(&what, "{ A = [0, 0] }", points) {
        let what = format!("{} {}", words().point_in(of), quoted(name.text));
        let place = link_points::place(reader, &what, &name, value);
        link.points.push(PlacedPoint::read_as(name, place));
    }
    link_points::compute_places(reader, of, link);
    points.get_ref().is_table()
}

fn link_mass<'v>(reader: &mut Reader<'_>, table: &KeyTable<'v>, link: &mut DraftLink<'v>) {
    if let (Some(com), Some(name)) = (table.get("com"), table.key("com")) {
        let what = table.what(reader, "com");
        let place = link_points::place(reader, &what, &name, com);
        let mut com = PlacedPoint::read_as(name, place);
        link_points::place_centre(reader, &table.of, &mut com, link);
        link.com = Some(com);
    }
    link.mass = reader.number_of(table, "mass").unwrap_or(0.0);
    link.inertia = reader.number_of(table, "inertia").unwrap_or(0.0);
    link.mass_key = table.key("mass").or_else(|| table.key("inertia"));
}

fn incomplete(of: &str, missing: &str, span: ByteSpan) -> Diagnostic {
    Diagnostic::new(words().of_has(of, missing))
        .at(span, words().ends_and_length())
        .help(words().for_example(LINK))
        .help(words().points_alone(POINTS))
}
