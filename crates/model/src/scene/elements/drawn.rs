//! Links as drawn: `r3 = { points = ["B", "C", "P"] }` has the shape that the coordinates in
//! `[ground]` and `[start]` give it.
//!
//! The first two points are the ends of the link. Its length and the coordinates of its further
//! points are computed from the typed decimals in double-double, and rounded once.

use crate::arithmetic::Decimal;
use crate::document::{Diagnostic, WrittenValue, items};
use crate::scene::elements::link::{DraftLink, Ends};
use crate::scene::elements::points::PlacedPoint;
use crate::scene::numbers::reader::{MIN_LENGTH, Name, Reader};
use crate::scene::table::KeyTable;
use crate::wording::words;
use crate::{Double, Number, Vec2};
use std::collections::HashMap;

const DRAWN: &str = r#"r3 = { points = ["B", "C", "P"] }"#;
const FURTHER: &str = "points = { P = [150, 80] }";

/// A computed coordinate below this fraction of the coordinates in the drawing is a rounding error.
const ROUNDING: f64 = 1e-29;

/// Maximum exponent of a scale, so that its inverse is finite.
const MAX_EXPONENT: f64 = 1000.0;

/// The coordinates of the named points where the scene opens; `None` for unreadable ones.
pub(crate) type DrawnPlaces<'t> = HashMap<&'t str, Option<Vec2>>;

/// Returns the coordinates in `[ground]` and `[start]`.
pub(crate) fn drawn_places<'t>(
    ground: &[PlacedPoint<'t>],
    start: &[PlacedPoint<'t>],
) -> DrawnPlaces<'t> {
    let all = start.iter().chain(ground);
    all.map(|place| (place.name.text, place.read)).collect()
}

/// Reads a list of the link's points, and computes their coordinates in the link's frame. Returns
/// `true` if no point was lost.
pub(crate) fn link_points<'v>(
    reader: &mut Reader<'_>,
    table: &KeyTable<'v>,
    list: &'v WrittenValue<'v>,
    places: &DrawnPlaces<'_>,
    link: &mut DraftLink<'v>,
) -> bool {
    for key in ["from", "to", "length"] {
        if let Some(key) = table.key(key) {
            reader.report(
                Diagnostic::new(words().drawn_link_has_key(&table.of, key.text))
                    .at(key.span, words().ends_are_first_two())
                    .help(words().further_points_are_a_table(FURTHER)),
            );
        }
    }
    let what = table.what(reader, "points");
    let written = items(list).unwrap_or_default();
    let names: Vec<Name<'_>> = written
        .iter()
        .filter_map(|name| reader.string(&what, name))
        .collect();
    let is_complete = names.len() == written.len() && names.len() >= 2;
    if written.len() < 2 {
        reader.report(
            Diagnostic::new(words().drawn_link_needs_two(&table.of))
                .at(list.span(), words().ends_are_first_two())
                .help(words().for_example(DRAWN)),
        );
    }
    let places: Vec<Option<Vec2>> = names
        .iter()
        .map(|name| place(reader, &table.of, name, places))
        .collect();
    let mut shape = None;
    if let (true, [Some(from), Some(to), ..]) = (is_complete, &*places) {
        shape = DrawnFrame::new(*from, *to);
        if shape.is_none() && names[0].text != names[1].text {
            reader.report(coincident(&table.of, &names[0], &names[1]));
        }
    }
    let local = |reader: &mut Reader<'_>, place: Option<Vec2>| {
        let local = shape.as_ref()?.local(place?);
        Some(local.map(|v| reader.rounded(v)))
    };
    let mut points = names.into_iter().zip(places);
    if let (Some((from, _)), Some((to, _))) = (points.next(), points.next()) {
        let length = shape
            .as_ref()
            .map_or(1.0, |shape| reader.rounded(shape.length));
        link.direction = shape.as_ref().map(|shape| shape.direction());
        link.ends = Some(Ends { from, to, length });
    }
    let further = points.map(|(name, place)| PlacedPoint::new(name, local(reader, place)));
    link.points.extend(further);
    is_complete
}

/// Returns the coordinates of a point; reports a point without any.
fn place(
    reader: &mut Reader<'_>,
    of: &str,
    name: &Name<'_>,
    places: &DrawnPlaces<'_>,
) -> Option<Vec2> {
    let place = places.get(name.text);
    if place.is_none() {
        reader.report(
            Diagnostic::new(words().drawn_point_has_no_place(of, &name.to_string()))
                .at(name.span.clone(), words().neither_ground_nor_start())
                .help(words().add_drawn_place(name.text)),
        );
    }
    place.copied().flatten()
}

fn coincident(of: &str, from: &Name<'_>, to: &Name<'_>) -> Diagnostic {
    Diagnostic::new(words().drawn_at_one_place(of, &from.to_string(), &to.to_string()))
        .at(to.span.clone(), words().no_direction())
        .help(words().begin_with_two_places())
}

/// The frame of a link in the drawing: its origin and its x axis.
struct DrawnFrame {
    origin: Vec2<Double>,
    axis: Vec2<Double>,
    length: Double,
}

impl DrawnFrame {
    /// Returns the frame of a link between two points; `None` if they coincide.
    fn new(from: Vec2, to: Vec2) -> Option<DrawnFrame> {
        let origin = typed(from);
        let along = typed(to) - origin;
        let length = norm(along);
        // Negated so that NaN is rejected too.
        if !(length.hi >= MIN_LENGTH) {
            return None;
        }
        Some(DrawnFrame {
            origin,
            axis: along.map(|v| v / length),
            length,
        })
    }

    /// Returns a point's coordinates in the frame.
    fn local(&self, place: Vec2) -> Vec2<Double> {
        let place = typed(place);
        let arm = place - self.origin;
        let size = |v: Vec2<Double>| v.x.abs().hi.max(v.y.abs().hi);
        // The coordinates are rounded, not their differences.
        let reach = [place, self.origin, arm].map(size);
        let reach = reach.into_iter().fold(self.length.hi, f64::max);
        let local = Vec2::new(self.axis.dot(arm), self.axis.cross(arm));
        local.map(|v| match v.abs().hi <= ROUNDING * reach {
            true => Double::ZERO,
            false => v,
        })
    }

    /// Returns the direction of the x axis in degrees, from 0 to below 360.
    fn direction(&self) -> f64 {
        Number::degrees(self.axis).nearest()
    }
}

/// Returns the typed decimals of a position.
pub(crate) fn typed(position: Vec2) -> Vec2<Double> {
    position.map(|v| Decimal::of(v).value)
}

/// Returns the length of a vector, also if its square overflows or underflows.
pub(crate) fn norm(vector: Vec2<Double>) -> Double {
    let size = vector.x.abs().hi.max(vector.y.abs().hi);
    if size == 0.0 {
        return Double::ZERO;
    }
    let exponent = size.log2().floor().clamp(-MAX_EXPONENT, MAX_EXPONENT);
    vector
        .scaled((-exponent).exp2())
        .norm()
        .scaled(exponent.exp2())
}

#[cfg(test)]
mod tests {
    use crate::scene::Scene;
    use crate::{LinkId, Vec2};

    const DRAWN: &str = "[ground]\nA = [0, 0]\nD = [4, 0]\n[driver]\nlink = \"r2\"\n[links]\n\
        r2 = { points = [\"A\", \"B\"] }\nr3 = { points = [\"B\", \"C\", \"P\"] }\n\
        r4 = { points = [\"C\", \"D\"] }\n[start]\nB = [0.6, 0.8]\nC = [3.6, 4.8]\nP = [2.5, 1.4]\n";

    fn scene(text: &str) -> Scene {
        Scene::parse(text, "test").unwrap()
    }

    /// Returns the coordinates of a point in the frame of a link.
    fn local(scene: &Scene, link: usize, point: &str) -> Vec2 {
        let mut points = scene.mechanism.point_ids();
        let point = points
            .find(|&id| scene.point_name(id) == Some(point))
            .unwrap();
        let link = scene.mechanism.link(LinkId::new(link));
        link.local(point).unwrap()
    }

    /// B to C is (3, 4): 5 long, in the direction (0.6, 0.8). B to P is (1.9, 0.6): 1.62 along it
    /// and 0.6 * 0.6 - 0.8 * 1.9 = -1.16 to the left.
    #[test]
    fn drawn_links_have_the_shape_of_their_coordinates() {
        let scene = scene(DRAWN);
        assert_eq!(local(&scene, 0, "B"), Vec2::new(1.0, 0.0));
        assert_eq!(local(&scene, 1, "C"), Vec2::new(5.0, 0.0));
        assert_eq!(local(&scene, 1, "P"), Vec2::new(1.62, -1.16));
        // hypot(0.4, 4.8).
        assert_eq!(local(&scene, 2, "D"), Vec2::new(23.2_f64.sqrt(), 0.0));
    }

    /// atan2(0.8, 0.6) is 53.13 deg; the range moves it by a turn.
    #[test]
    fn drawn_driver_opens_in_its_direction() {
        let expected = 53.130_102_354_155_98;
        let start = |text: &str| scene(text).mechanism.driver().start;
        assert_eq!(start(DRAWN), expected);
        let ranged = DRAWN.replace("\"r2\"\n[", "\"r2\"\nrange = [-400, -200]\n[");
        assert!((start(&ranged) - (expected - 360.0)).abs() < 1e-13);
    }

    /// Points on one line have no coordinate across it, although 0.1 and 0.3 are no doubles.
    #[test]
    fn points_on_a_line_stay_on_it() {
        let text = DRAWN
            .replace("B = [0.6, 0.8]", "B = [0.1, 0.3]")
            .replace("C = [3.6, 4.8]", "C = [0.7, 2.1]")
            .replace("P = [2.5, 1.4]", "P = [0.2, 0.6]");
        assert_eq!(local(&scene(&text), 1, "P").y, 0.0);
    }

    /// The decimals of coordinates far from the origin are rounded more coarsely than the link.
    #[test]
    fn points_on_a_line_far_away_stay_on_it() {
        let text = DRAWN
            .replace("B = [0.6, 0.8]", "B = [1000000.1, 1000000.3]")
            .replace("C = [3.6, 4.8]", "C = [1000000.7, 1000002.1]")
            .replace("P = [2.5, 1.4]", "P = [1000000.2, 1000000.6]");
        let found = local(&scene(&text), 1, "P");
        assert_eq!(found.y, 0.0);
        assert!((found.x - 0.1 * 10.0_f64.sqrt()).abs() < 1e-16, "{found:?}");
    }

    /// Squares of these lengths overflow or underflow.
    #[test]
    fn drawn_links_may_be_very_long_or_short() {
        for exponent in ["e200", "e-200"] {
            let text = DRAWN
                .replace("[4, 0]", &format!("[4{exponent}, 0]"))
                .replace("[0.6, 0.8]", &format!("[0.6{exponent}, 0.8{exponent}]"))
                .replace("[3.6, 4.8]", &format!("[3.6{exponent}, 4.8{exponent}]"))
                .replace("[2.5, 1.4]", &format!("[2.5{exponent}, 1.4{exponent}]"));
            let length: f64 = format!("5{exponent}").parse().unwrap();
            let found = local(&scene(&text), 1, "C").x;
            assert!(
                (found - length).abs() <= 4.0 * f64::EPSILON * length,
                "{found:e}"
            );
        }
    }
}
