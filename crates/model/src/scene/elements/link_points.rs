//! Places in a link's frame: by coordinates, by length and angle as dimensioned on a drawing, or by
//! two distances.
//!
//! ```toml
//! points = { P = [150, 80], E = { from = "D", length = 180, angle = 72 } }
//! points = { W = { from = ["P", "X"], distances = [40.1, 55.8], side = "left" } }
//! ```

use crate::arithmetic::Decimal;
use crate::document::{Diagnostic, WrittenValue, items};
use crate::nearest::did_you_mean;
use crate::scene::elements::drawn::{norm, typed};
use crate::scene::elements::link::DraftLink;
use crate::scene::elements::points::PlacedPoint;
use crate::scene::keys;
use crate::scene::numbers::reader::{ByteSpan, Name, Reader, quoted};
use crate::scene::rewrite::figure;
use crate::scene::table::{KeyTable, NumberRule};
use crate::wording::words;
use crate::{Constant, Double, Number, Vec2, mechanism};
use std::collections::{HashMap, HashSet, VecDeque};

const SIGHTED: &str = r#"{ from = "D", length = 180, angle = 72 }"#;
const TRIANGLE: &str = r#"{ from = ["D", "E"], distances = [120, 90] }"#;

/// Maximum relative rounding error of a sum of three lengths in double-double.
const ROUNDING: f64 = 1e-30;

/// A place by length and angle.
#[derive(Clone, Debug)]
pub(crate) struct Sighted<'t> {
    /// The reference point on the link; `None` for the origin of its frame.
    pub(crate) from: Option<Name<'t>>,
    pub(crate) length: f64,
    /// The angle in degrees.
    pub(crate) angle: f64,
}

/// A place by its distances from two points of the link.
#[derive(Clone, Debug)]
pub(crate) struct Triangle<'t> {
    /// The two points.
    pub(crate) from: [Name<'t>; 2],
    distances: [f64; 2],
    /// Whether the place is to the left of the line from the first point to the second.
    is_left: bool,
    /// The place of the distances in the text.
    span: ByteSpan,
}

impl Triangle<'_> {
    /// Returns the place for the positions of the two points. If the distances do not meet, returns
    /// the distance of the two points.
    fn place(&self, [first, second]: [Vec2<Double>; 2]) -> Result<Vec2<Double>, Double> {
        let along = second - first;
        let apart = norm(along);
        let axis = along.map(|v| v / apart);
        // Scaled, so that the products below stay finite.
        let scale = |length: Double| length / apart;
        let [one, other] = self.distances.map(|v| scale(Decimal::of(v).value));
        // Heron's formula with factors, because the square of the height cancels in a flat
        // triangle.
        let margin = (one + other).hi * ROUNDING;
        let factors = [
            one + other - Double::ONE,
            one - other + Double::ONE,
            other - one + Double::ONE,
        ];
        // Negated so that NaN is rejected too.
        if !factors.iter().all(|factor| factor.hi >= -margin) {
            return Err(apart);
        }
        let product = factors
            .into_iter()
            .filter(|factor| factor.hi > margin)
            .fold(one + other + Double::ONE, |product, factor| {
                product * factor
            });
        let is_flat = factors.iter().any(|factor| factor.hi <= margin);
        let half = Double::exactly(0.5);
        let height = if is_flat {
            Double::ZERO
        } else {
            product.sqrt() * half
        };
        let height = if self.is_left { height } else { -height };
        let foot = (Double::ONE + (one - other) * (one + other)) * half;
        let local = Vec2::new(foot, height).map(|v| v * apart);
        Ok(first + local.turned(axis))
    }
}

/// A place on a link, as far as it could be read.
#[derive(Debug)]
pub(crate) enum ReadPlace<'t> {
    At(Vec2),
    Sighted(Sighted<'t>),
    Triangle(Triangle<'t>),
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
        return place_by_lengths(reader, owner, table);
    }
    if items(value).is_some() {
        return reader.pair(what, value).map(ReadPlace::At);
    }
    let fault = reader.mistyped(what, &words().a_pair("[x, y]"), value);
    reader.report(
        fault
            .help(words().for_example("[12.5, 0]"))
            .help(words().or_by_length_and_angle(SIGHTED))
            .help(words().or_by_two_distances(TRIANGLE)),
    );
    None
}

/// Reads a place by length and angle, or by two distances.
fn place_by_lengths<'v>(
    reader: &mut Reader<'_>,
    owner: &Name<'_>,
    mut table: KeyTable<'v>,
) -> Option<ReadPlace<'v>> {
    let by_distances = table.has("distances")
        || (!table.has("angle") && table.is_probable_misspelling("distances"));
    if by_distances {
        table.kind = "distances";
        return triangle(reader, owner, &table).map(ReadPlace::Triangle);
    }
    table.kind = "angle";
    sighted(reader, owner, &table).map(ReadPlace::Sighted)
}

fn triangle<'v>(
    reader: &mut Reader<'_>,
    owner: &Name<'_>,
    table: &KeyTable<'v>,
) -> Option<Triangle<'v>> {
    reader.only_known(table);
    reader.require(table, "from", &owner.span, TRIANGLE);
    let from = table.get("from").and_then(|from| {
        let what = table.what(reader, "from");
        let [first, second] =
            reader.two(&what, words().a_pair_of_names(), r#"["D", "E"]"#, from)?;
        let [first, second] = [first, second].map(|name| reader.string(&what, name));
        Some([first?, second?])
    });
    let distances = table.get("distances").and_then(|distances| {
        let what = table.what(reader, "distances");
        let both = reader.two(&what, words().a_pair_of_distances(), "[120, 90]", distances)?;
        let [first, second] =
            both.map(|one| reader.measured(&what, "distances", NumberRule::Arm, one));
        Some(([first?, second?], distances.span()))
    });
    let is_left = side(reader, table);
    let (from, (distances, span)) = (from?, distances?);
    Some(Triangle {
        from,
        distances,
        is_left: is_left?,
        span,
    })
}

/// Reads the side of a triangle; `true` for the left one, which is the default.
fn side(reader: &mut Reader<'_>, table: &KeyTable<'_>) -> Option<bool> {
    if !table.has("side") {
        return Some(true);
    }
    let name = reader.text_of(table, "side")?;
    match name.text {
        "left" => return Some(true),
        "right" => return Some(false),
        _ => {}
    }
    let what = table.what(reader, "side");
    let rule = words().left_or_right();
    reader.report(
        Diagnostic::new(words().must_be(&what, rule, &name.to_string()))
            .at(name.span.clone(), words().expected(rule))
            .maybe_help(did_you_mean(name.text, ["left", "right"]))
            .help(words().which_side_is_left()),
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

/// Computes the coordinates of a link's points given by length and angle or by two distances, and
/// sorts points after their reference points.
pub(crate) fn compute_places(reader: &mut Reader<'_>, of: &str, link: &mut DraftLink<'_>) {
    let mut laid = LaidPoints::of(link);
    let mut waiting: HashMap<&str, Vec<PlacedPoint<'_>>> = HashMap::new();
    let mut ready: Vec<PlacedPoint<'_>> = Vec::new();
    let names: HashSet<&str> = link.points.iter().map(|point| point.name.text).collect();
    let mut placed = Vec::with_capacity(link.points.len());
    let mut queue: VecDeque<_> = std::mem::take(&mut link.points).into();
    while let Some(mut point) = ready.pop().or_else(|| queue.pop_front()) {
        let missing = laid.missing(&point).map(|from| from.text);
        if let Some(from) = missing {
            waiting.entry(from).or_default().push(point);
            continue;
        }
        let what = format!("{} {}", words().point_in(of), quoted(point.name.text));
        laid.place(reader, &what, &mut point);
        laid.add(&point);
        let mut seen = waiting.remove(point.name.text).unwrap_or_default();
        // `ready` is popped from its end.
        seen.reverse();
        ready.append(&mut seen);
        placed.push(point);
    }
    let mut left: Vec<PlacedPoint<'_>> = waiting.into_values().flatten().collect();
    left.sort_by_key(|point| point.name.span.start);
    for point in &mut left {
        if let Some(from) = laid.missing(point) {
            let known = names.contains(from.text);
            reader.report(unseen(of, &point.name, from, known));
        }
        (point.sighted, point.triangle) = (None, None);
    }
    placed.append(&mut left);
    link.points = placed;
}

/// The points of a link with known coordinates: those of the stored doubles, and those of the typed
/// decimals.
struct LaidPoints<'t> {
    given: HashMap<&'t str, Vec2<Constant>>,
    typed: HashMap<&'t str, Vec2<Double>>,
}

impl<'t> LaidPoints<'t> {
    /// Returns the ends of a link.
    fn of(link: &DraftLink<'t>) -> LaidPoints<'t> {
        let mut laid = LaidPoints {
            given: HashMap::new(),
            typed: HashMap::new(),
        };
        if let Some(ends) = &link.ends {
            laid.insert(ends.from.text, Vec2::ZERO);
            laid.insert(ends.to.text, Vec2::new(ends.length, 0.0));
        }
        laid
    }

    /// Returns the first reference point of a point whose coordinates are not known.
    fn missing<'p>(&self, point: &'p PlacedPoint<'t>) -> Option<&'p Name<'t>> {
        let mut references = point.references();
        references.find(|from| !self.given.contains_key(from.text))
    }

    /// Adds a point by its coordinates; of two points with one name, the first counts.
    fn insert(&mut self, name: &'t str, at: Vec2) {
        self.given.entry(name).or_insert(at.map(Constant::given));
        self.typed.entry(name).or_insert(typed(at));
    }

    /// Adds a point with coordinates.
    fn add(&mut self, point: &PlacedPoint<'t>) {
        let name = point.name.text;
        match &point.sighted {
            None => self.insert(name, point.at()),
            Some(sighted) => {
                let (given, typed) = self.polar(sighted);
                self.given.entry(name).or_insert(given);
                self.typed.entry(name).or_insert(typed);
            }
        }
    }

    /// Sets the coordinates of a point whose reference points are known.
    fn place(&self, reader: &mut Reader<'_>, what: &str, point: &mut PlacedPoint<'_>) {
        if let Some(sighted) = &point.sighted {
            point.read = Some(self.polar(sighted).0.map(|v| v.hi));
        }
        let Some(triangle) = point.triangle.take() else {
            return;
        };
        let bases = triangle.from.each_ref().map(|from| self.typed[from.text]);
        match triangle.place(bases) {
            Ok(place) => point.read = Some(place.map(|v| reader.rounded(v))),
            Err(apart) => reader.report(
                Diagnostic::new(words().distances_do_not_meet(what, &figure(apart.hi)))
                    .at(triangle.span, words().no_such_triangle())
                    .help(words().sides_of_a_triangle()),
            ),
        }
    }

    /// Returns the coordinates of a point by length and angle.
    fn polar(&self, sighted: &Sighted<'_>) -> (Vec2<Constant>, Vec2<Double>) {
        let (mut given, mut at) = (Vec2::ZERO.map(Constant::given), typed(Vec2::ZERO));
        if let Some(from) = &sighted.from {
            (given, at) = (self.given[from.text], self.typed[from.text]);
        }
        let [length, angle] = [sighted.length, sighted.angle].map(|v| Decimal::of(v).value);
        let arm = <Double as Number>::unit(angle).map(|v| v * length);
        let given = mechanism::polar_position(given, sighted.length, sighted.angle);
        (given, at + arm)
    }
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
pub(crate) fn place_centre(
    reader: &mut Reader<'_>,
    of: &str,
    com: &mut PlacedPoint<'_>,
    link: &DraftLink<'_>,
) {
    let mut laid = LaidPoints::of(link);
    link.points.iter().for_each(|point| laid.add(point));
    let what = words().key_of("com", of);
    if let Some(missing) = laid.missing(com) {
        return reader.report(not_on_link(&what, of, missing));
    }
    laid.place(reader, &what, com);
}

#[cfg(test)]
mod tests {
    use crate::scene::{Scene, presets};
    use crate::{LinkId, Vec2};

    /// Returns the coordinates of the points of r3, 5 long from B to C, by name.
    fn places(points: &str) -> Vec<(String, Vec2)> {
        let text = format!(
            "[ground]\nA = [0, 0]\nD = [4, 0]\n[driver]\nlink = \"r2\"\nangle = 60\n[links]\n\
             r2 = {{ from = \"A\", to = \"B\", length = 1 }}\n\
             r3 = {{ from = \"B\", to = \"C\", length = 5, points = {{ {points} }} }}\n\
             r4 = {{ from = \"C\", to = \"D\", length = 4 }}\n"
        );
        let scene = Scene::parse(&text, "test").unwrap();
        let link = scene.mechanism.link(LinkId::new(1));
        let members = link.members.iter().skip(2);
        let place = |point| scene.point_name(point).unwrap().to_owned();
        members.map(|m| (place(m.point), m.local)).collect()
    }

    /// The triangle 3-4-5 has its right angle at (1.8, 2.4); one of 2, 3 and 5 is flat.
    #[test]
    fn two_distances_are_the_sides_of_a_triangle() {
        for (point, at) in [
            ("distances = [3, 4]", Vec2::new(1.8, 2.4)),
            ("distances = [3, 4], side = \"left\"", Vec2::new(1.8, 2.4)),
            ("distances = [3, 4], side = \"right\"", Vec2::new(1.8, -2.4)),
            ("distances = [2, 3]", Vec2::new(2.0, 0.0)),
            ("distances = [7, 2]", Vec2::new(7.0, 0.0)),
            ("distances = [0.3, 4.7]", Vec2::new(0.3, 0.0)),
        ] {
            let found = places(&format!("P = {{ from = [\"B\", \"C\"], {point} }}"));
            assert_eq!(found, [("P".to_owned(), at)], "{point}");
        }
    }

    /// Jansen's triangle of 41.5, 40.1 and 55.8, by decimals of 50 digits: the foot is (41.5^2 +
    /// 40.1^2 - 55.8^2) / 83 along the base.
    #[test]
    fn corners_are_rounded_once() {
        let scene = Scene::parse(presets::find("jansen-leg").unwrap().text, "leg").unwrap();
        let corner = |link: &str, point: &str| {
            let link = scene
                .mechanism
                .link_ids()
                .find(|&id| scene.link_name(id) == link);
            let mut points = scene.mechanism.point_ids();
            let point = points.find(|&id| scene.point_name(id) == Some(point));
            scene.mechanism.link(link.unwrap()).local(point.unwrap())
        };
        let expected = Vec2::new(2.609_879_518_072_289_4, 40.014_978_806_706_2);
        assert_eq!(corner("bde", "W"), Some(expected));
        let expected = Vec2::new(-7.746_594_005_449_591, 48.383_781_180_419_67);
        assert_eq!(corner("ghi", "T"), Some(expected));
    }

    /// Q is a right angle upon the side from P to C, and named before P. The side is 4 long, in the
    /// direction (0.8, -0.6); Q lies 1.44 along it and 1.92 to its left: the sides are 2.4 and 3.2.
    #[test]
    fn triangles_stand_on_points_given_in_any_form() {
        let found = places(
            "Q = { from = [\"P\", \"C\"], distances = [2.4, 3.2] }, P = { from = [\"B\", \"C\"], distances = [3, 4] }",
        );
        let [(first, p), (second, q)] = found.try_into().unwrap();
        assert_eq!([first, second], ["P", "Q"]);
        assert_eq!(p, Vec2::new(1.8, 2.4));
        let expected = Vec2::new(1.8 + 1.44 * 0.8 + 1.92 * 0.6, 2.4 - 1.44 * 0.6 + 1.92 * 0.8);
        assert!((q - expected).norm() < 1e-15, "{q:?}");
        // E is at (0, 5): a square corner from C and E is (5, 5) on the other side of the diagonal.
        let found = places(
            "E = { length = 5, angle = 90 }, P = { from = [\"C\", \"E\"], distances = [5, 5], side = \"right\" }",
        );
        assert!(
            (found[1].1 - Vec2::new(5.0, 5.0)).norm() < 1e-14,
            "{found:?}"
        );
    }
}
