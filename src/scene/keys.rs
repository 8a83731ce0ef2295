//! The table of keys: what a scene file may say, what each key is, and what holds where it is left out.
//!
//! From it come the faults of unknown keys, the numbers that the workbench lists and changes, and the reference in
//! the manual. The types that a file is read into have a field for each row; a test holds them to it.

use super::measure::Measure;
use super::rate::Degree;

/// A key.
pub(super) struct SceneKey {
    pub(super) name: &'static str,
    pub(super) kind: KeyKind,
    /// The kinds of elements that have it, each called by a key of its own; every kind where none is named.
    of: &'static [&'static str],
    /// What it is; nothing where it is told with the next one.
    words: &'static str,
    /// What holds where it is left out; nothing where it must be given.
    default: &'static str,
}

/// What stands behind a key.
#[derive(Clone, Copy)]
pub(super) enum KeyKind {
    /// A name, a text or a choice.
    Text,
    Number(NumberMeasure),
    /// `[x, y]`.
    Pair(NumberMeasure),
    /// A number with a unit of its own.
    Rate(Degree),
    /// Named pairs.
    Points(NumberMeasure),
    /// `[x, y]` on a link, or a length and an angle; and named ones.
    Place,
    Places,
    /// Pairs of where and how much; what the latter is called.
    Knots([NumberMeasure; 2], &'static str),
    /// A table, one of each name, or a list of them.
    Table(&'static [SceneKey]),
    Each(&'static [SceneKey]),
    List(&'static [SceneKey]),
    /// Named pairs of names.
    Vectors,
    /// Named texts.
    Formulas,
}

/// What a number measures.
#[derive(Clone, Copy)]
pub(super) enum NumberMeasure {
    Of(Measure),
    /// The driver's coordinate.
    Driver,
    /// What a motor gives: a torque, or the force on a driven slide.
    Effort,
}

impl NumberMeasure {
    /// `turns` tells that a link is driven, and no slide.
    pub(super) fn measure(self, turns: bool) -> Measure {
        match (self, turns) {
            (NumberMeasure::Of(measure), _) => measure,
            (NumberMeasure::Driver, true) => Measure::Angle,
            (NumberMeasure::Driver, false) => Measure::Coordinate,
            (NumberMeasure::Effort, true) => Measure::Torque,
            (NumberMeasure::Effort, false) => Measure::Force,
        }
    }
}

/// Rows of `name: kind, of, words, default`.
macro_rules! keys {
    ($($table:ident = $($name:literal: $kind:expr, $of:expr, $words:literal, $default:literal;)*)*) => {
        $(pub(super) const $table: &[SceneKey] = &[$(SceneKey {
            name: $name,
            kind: $kind,
            of: &$of,
            words: $words,
            default: $default,
        }),*];)*
    };
}

use KeyKind::{
    Each, Formulas, Knots, List, Number, Pair, Place, Places, Points, Rate, Table, Text, Vectors,
};
use NumberMeasure::{Driver, Effort, Of};

keys! {
SCENE =
    "name": Text, [], "the title", "the file's name";
    "source": Text, [], "where the mechanism comes from", "none";
    "note": Text, [], "what there is to see", "none";
    "unit": Text, [], "of every length: `\"mm\"`, `\"cm\"`, `\"m\"` or `\"in\"`", "`\"mm\"`";
    "ground": Points(Of(Measure::Coordinate)), [], "points fixed in the frame: `A = [x, y]`", "none";
    "driver": Table(DRIVER), [], "the input: a link that is turned or a slide that is pushed", "";
    "links": Each(LINK), [], "rigid links, each a table: `r2 = { ... }`", "none";
    "slides": Each(SLIDE), [], "guides and what moves along them, each a table: `r4 = { ... }`", "none";
    "start": Points(Of(Measure::Start)), [],
        "rough positions of moving points where the scene opens: `C = [x, y]`", "none";
    "vectors": Vectors, [], "more vectors for the tables, tail and head: `r1 = [\"D\", \"A\"]`", "none";
    "loads": List(LOAD), [], "any number of loads, each a force, a torque or a press", "none";
    "springs": List(SPRING), [], "any number of springs and dampers between points", "none";
    "gravity": Pair(Of(Measure::Gravity)), [], "acceleration of free fall `[x, y]` in m/s^2", "`[0, 0]`";
    "figures": Formulas, [], "figures made of others, by formulas: `swing = \"r4.angle - r3.angle\"`", "none";
    "motor": Table(MOTOR), [], "what is to drive the scene; it changes no motion", "none";
    "redundant": Table(REDUNDANT), [], "what is asked of constraints that repeat others", "none";

DRIVER =
    "link": Text, ["link"], "the link that turns about its ground point", "";
    "slide": Text, ["slide"], "or: the slide that is pushed", "";
    "angle": Number(Of(Measure::Angle)), ["link"],
        "direction of the driven link's x axis where the scene opens, in deg", "";
    "position": Number(Of(Measure::Coordinate)), ["slide"],
        "of a driven slide where the scene opens: along the guide from `through`", "";
    "speed": Rate(Degree::Speed), [],
        "`\"15 rad/s\"`, `\"90 deg/s\"`, `\"143.2 rpm\"`; of a slide `\"50 mm/s\"` (`cm/s`, `m/s`, `in/s`)",
        "1 rad/s, or 1 unit/s";
    "acceleration": Rate(Degree::Acceleration), [],
        "`\"2 rad/s^2\"`, `\"90 deg/s^2\"`; of a slide `\"5 mm/s^2\"` (`cm/s^2`, `m/s^2`, `in/s^2`)", "0";

LINK =
    "from": Text, [], "", "";
    "to": Text, [], "", "";
    "length": Number(Of(Measure::Length)), [],
        "the two ends of a link and their distance: its vector in the loop equation", "no vector";
    "points": Places, [],
        "further points in the link's frame: `{ P = [150, 80] }`, or by length and angle `{ P = { from = \"D\", \
         length = 170, angle = 28 } }`; alone for a link without two natural ends",
        "none";
    "com": Place, [], "centre of mass in the link's frame, `[x, y]` or by length and angle", "none";
    "mass": Number(Of(Measure::Mass)), [], "in kg; needs `com`", "0";
    "inertia": Number(Of(Measure::Inertia)), [], "about the centre of mass in kg m^2; needs `com`", "0";

PLACE =
    "from": Text, [], "the point of the link from which a place is seen", "the origin of the link's frame";
    "length": Number(Of(Measure::Length)), [], "how far it is", "";
    "angle": Number(Of(Measure::Angle)), [], "in which direction, in deg from the link's x axis", "";

SLIDE =
    "point": Text, ["point"], "the pin that moves in the slot, free to turn", "";
    "link": Text, ["link"], "or: the link that slides without turning, its origin on the guide", "";
    "on": Text, [], "what carries the guide: `\"ground\"` or a link", "";
    "through": Pair(Of(Measure::Coordinate)), [],
        "a point of the guide: a point of `on` by its name, or `[x, y]` in the frame of `on`", "";
    "angle": Number(Of(Measure::Angle)), [], "of the guide against the x axis of `on`, in deg", "0";
    "turn": Number(Of(Measure::Angle)), ["link"], "of a sliding link's x axis against the guide, in deg", "0";

LOAD =
    "point": Text, ["force"], "", "";
    "force": Pair(Of(Measure::Force)), ["force"], "a force `[x, y]` in N at a point", "";
    "frame": Text, ["force"], "the link in whose frame a force is given: it turns with it", "`\"ground\"`";
    "link": Text, ["torque"], "", "";
    "torque": Number(Of(Measure::Torque)), ["torque"], "or: a torque in N m on a link, counter-clockwise", "";
    "over": Knots([Driver, Of(Measure::Factor)], "factor"), ["force", "torque"],
        "the part of a force or a torque that acts, over the driver's coordinate: knots \
         `[[0, 0.2], [15, 1], [360, 0.2]]` in deg, or in the unit of a driven slide", "1";
    "slide": Text, ["press"], "", "";
    "press": Knots([Of(Measure::Coordinate), Of(Measure::Force)], "size"), ["press"],
        "or: a force in N against a slide that closes, over the distance before the end of its stroke: knots \
         `[[12, 0], [4, 200e3], [0, 350e3]]`", "";
    "end": Text, ["press"],
        "where a press works: the `\"least\"` or the `\"greatest\"` position along the guide; must be given \
         where that is horizontal", "the lower end";

SPRING =
    "from": Text, [], "", "";
    "to": Text, [], "the two points, on different bodies", "";
    "stiffness": Number(Of(Measure::Stiffness)), [], "in N/m", "0";
    "length": Number(Of(Measure::Length)), [], "without a force, in the scene's `unit`", "0";
    "damping": Number(Of(Measure::Damping)), [], "in N s/m, of the rate of the distance", "0";

MOTOR =
    "torque": Number(Of(Measure::Torque)), ["link"], "rated torque in N m", "unknown";
    "force": Number(Of(Measure::Force)), ["slide"], "of a driven slide instead: rated force in N", "unknown";
    "peak": Number(Effort), [], "what the motor gives for a short while, in N m or N", "unknown";
    "speed": Rate(Degree::Speed), [], "its rated speed, written as the driver's", "unknown";
    "flywheel": Number(Of(Measure::Inertia)), ["link"], "moment of inertia on the driver's shaft in kg m^2", "0";
    "fluctuation": Number(Of(Measure::Factor)), ["link"],
        "wished of the driver's speed, (greatest - least) / mean", "none";
    "tolerance": Number(Of(Measure::Length)), [],
        "how far from the end of its stroke a ram still counts as at rest", "none";

REDUNDANT =
    "misfit": Number(Of(Measure::Length)), [],
        "by how much they may disagree over the motion, in the scene's `unit`: for drawings of few digits", "0";
}

/// The row of a key.
pub(super) fn find(keys: &'static [SceneKey], name: &str) -> Option<&'static SceneKey> {
    keys.iter().find(|key| key.name == name)
}

/// The names of the keys that an element of a kind has.
pub(super) fn of(keys: &'static [SceneKey], kind: &str) -> Vec<&'static str> {
    let fits = |key: &&SceneKey| key.of.is_empty() || key.of.contains(&kind);
    keys.iter().filter(fits).map(|key| key.name).collect()
}

/// Every key of a scene as a table in Markdown: what it is, and what holds where it is left out. Plain keys stand
/// first, as they do in a file.
#[must_use]
pub fn reference() -> String {
    let mut table = "| key | what it is | default |\n|---|---|---|\n".to_owned();
    let section = |key: &&SceneKey| key.heading().is_some();
    rows(&mut table, SCENE.iter().filter(|key| !section(key)));
    for key in SCENE.iter().filter(section) {
        if let Some((heading, keys)) = key.heading() {
            row(&mut table, &format!("**`{heading}`**"), key);
            rows(&mut table, keys.iter());
        }
    }
    table
}

impl SceneKey {
    /// Of a section how a file begins it, and the keys in it.
    fn heading(&self) -> Option<(String, &'static [SceneKey])> {
        let name = self.name;
        match self.kind {
            Text | Number(_) | Pair(_) | Rate(_) | Knots(..) | Place | Places => None,
            Points(_) | Vectors | Formulas => Some((format!("[{name}]"), &[])),
            Table(keys) | Each(keys) => Some((format!("[{name}]"), keys)),
            List(keys) => Some((format!("[[{name}]]"), keys)),
        }
    }
}

fn rows<'k>(table: &mut String, keys: impl Iterator<Item = &'k SceneKey>) {
    let mut names = Vec::new();
    for key in keys {
        names.push(format!("`{}`", key.name));
        if !key.words.is_empty() {
            row(table, &names.join(", "), key);
            names.clear();
        }
    }
}

fn row(table: &mut String, name: &str, key: &SceneKey) {
    let default = match key.default {
        "" => String::new(),
        default => format!("{default} "),
    };
    table.push_str(&format!("| {name} | {} | {default}|\n", key.words));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Lenient;
    use crate::scene::{draft, input, link, loads, motor, redundant, sighted, slide};
    use serde::Deserialize;
    use serde::de::DeserializeOwned;
    use toml::de::ValueDeserializer;

    /// Every row is read into a field, and every field has its row.
    #[test]
    fn the_table_and_the_types_that_are_read_have_the_same_keys() {
        fn read<T: DeserializeOwned>() -> &'static [&'static str] {
            Lenient::<T>::deserialize(ValueDeserializer::parse("{}").unwrap())
                .unwrap()
                .known
        }
        for (table, read) in [
            (SCENE, read::<draft::SceneFile>()),
            (DRIVER, read::<input::DriverTable>()),
            (LINK, read::<link::LinkTable>()),
            (SLIDE, read::<slide::SlideTable>()),
            (LOAD, read::<loads::LoadTable>()),
            (SPRING, read::<loads::SpringTable>()),
            (MOTOR, read::<motor::MotorTable>()),
            (REDUNDANT, read::<redundant::RedundantTable>()),
        ] {
            let rows: Vec<_> = table.iter().map(|key| key.name).collect();
            assert_eq!(rows, read);
        }
    }

    /// A place by length and angle is read by hand.
    #[test]
    fn places_by_length_and_angle_have_their_keys() {
        let rows = PLACE.iter().map(|key| key.name);
        assert!(rows.eq(sighted::KEYS));
    }

    /// Every key is told in the reference, none without words.
    #[test]
    fn the_reference_has_every_key() {
        let told = reference();
        let sections = SCENE.iter().filter_map(SceneKey::heading);
        for (heading, keys) in sections {
            let (_, section) = told.split_once(&format!("| **`{heading}`** | ")).unwrap();
            let section = section.split("| **").next().unwrap();
            for key in keys {
                assert!(section.contains(&format!("`{}`", key.name)), "{}", key.name);
            }
        }
        assert!(!told.contains("|  |"), "{told}");
    }
}
