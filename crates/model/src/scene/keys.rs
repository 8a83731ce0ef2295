//! The table of the keys of scene files, with descriptions and defaults.
//!
//! The table yields the diagnostics of unknown keys, the numbers that the workbench lists and
//! edits, the rules and units of numbers as they are read, and the reference in the manual.

use super::numbers::measure::Measure;
use super::numbers::rate::Degree;
use super::table::NumberRule;
use crate::wording::{Wording, Words, words};

/// A key of a table in a scene or a task.
pub struct SceneKey {
    /// The name in the file.
    pub name: &'static str,
    pub(crate) kind: KeyKind,
    /// The kinds of elements that have the key, each identified by its characteristic key. Empty if
    /// all kinds have it.
    of: &'static [&'static str],
    /// The description; empty if the next key's row describes both.
    words: KeyText,
    /// The default; empty if the key is required.
    default: KeyText,
}

/// A text of the reference.
#[derive(Clone, Copy)]
enum KeyText {
    /// Text as typed in a scene, the same in every language; may be empty.
    Typed(&'static str),
    /// A sentence of the catalogue.
    Said(Wording),
}

impl KeyText {
    /// Returns the text in the current language.
    fn spoken(self) -> &'static str {
        match self {
            KeyText::Typed(text) => text,
            KeyText::Said(sentence) => sentence(words()),
        }
    }
}

/// The kind of a key's value.
#[derive(Clone, Copy)]
pub enum KeyKind {
    /// A name, a text or a choice, or a list of them.
    Text,
    /// True or false.
    Flag,
    /// A number.
    Number(NumberMeasure, NumberRule),
    /// `[low, high]`.
    Ends(NumberMeasure),
    /// `[x, y]`.
    Pair(NumberMeasure),
    /// A number with a unit of its own.
    Rate(Degree),
    /// Named numbers.
    Numbers(NumberMeasure),
    /// Named pairs.
    Points(NumberMeasure),
    /// A list of numbers.
    Series(NumberMeasure),
    /// A list of rows of numbers.
    Rows,
    /// `[x, y]` on a link, or a length and an angle.
    Place,
    /// Named places, or a list of the names of points.
    Places,
    /// Two distances.
    Distances(NumberMeasure),
    /// Pairs of an argument and a value, with the name of the value.
    Knots([NumberMeasure; 2], &'static str),
    /// A table.
    Table(&'static [SceneKey]),
    /// Named tables.
    Each(&'static [SceneKey]),
    /// A list of tables.
    List(&'static [SceneKey]),
    /// Named ranges, or tables of an angle and its range.
    Limits(&'static [SceneKey]),
    /// A list of tables inside another table.
    Steps(&'static [SceneKey]),
    /// Named pairs of names.
    Vectors,
    /// Named texts.
    Formulas,
    /// Named numbers.
    Parameters,
}

/// The quantity that a number measures.
#[derive(Clone, Copy)]
pub enum NumberMeasure {
    /// A measure.
    Of(Measure),
    /// As `Of`; messages name the unit.
    In(Measure),
    /// The coordinate of the driver, or of the input that the table belongs to.
    Driver,
    /// The coordinate of the driver, even if the table belongs to another input.
    DriverItself,
    /// The effort of a motor: a torque, or the force on a driven slide.
    Effort,
}

impl NumberMeasure {
    /// Resolves the measure. `turns` is `true` if the input whose coordinate is meant drives a
    /// link, and `false` if it drives a slide; torsion springs have torques instead of forces.
    pub(crate) fn measure(self, is_rotary: bool, is_torsion: bool) -> Measure {
        let measure = match (self, is_rotary) {
            (NumberMeasure::Of(measure) | NumberMeasure::In(measure), _) => measure,
            (NumberMeasure::Driver | NumberMeasure::DriverItself, true) => Measure::Angle,
            (NumberMeasure::Driver | NumberMeasure::DriverItself, false) => Measure::Coordinate,
            (NumberMeasure::Effort, true) => Measure::Torque,
            (NumberMeasure::Effort, false) => Measure::Force,
        };
        match is_torsion {
            true => measure.of_torsion(),
            false => measure,
        }
    }
}

/// The kind of a torsion spring.
pub(crate) const TORSION: &str = "torsion";

/// Converts a literal to typed text, and an identifier to the sentence of that name.
macro_rules! key_text {
    ($typed:literal) => {
        KeyText::Typed($typed)
    };
    ($said:ident) => {
        KeyText::Said(<dyn Words>::$said)
    };
}

/// Builds tables from rows of `name: kind, of, words, default`.
macro_rules! keys {
    ($($table:ident = $($name:literal: $kind:expr, $of:expr, $words:tt, $default:tt;)*)*) => {
        $(pub(crate) const $table: &[SceneKey] = &[$(SceneKey {
            name: $name,
            kind: $kind,
            of: &$of,
            words: key_text!($words),
            default: key_text!($default),
        }),*];)*
    };
}

use KeyKind::{
    Distances, Each, Ends, Flag, Formulas, Knots, Limits, List, Number, Numbers, Pair, Parameters,
    Place, Places, Points, Rate, Rows, Series, Steps, Table, Text, Vectors,
};
use NumberMeasure::{Driver, DriverItself, Effort, In, Of};
use NumberRule::{Any, Arm, AtLeastOne, AtMostHalf, Distance, Known, NotNegative, Positive};

keys! {
SCENE =
    "name": Text, [], the_title, name_of_the_file;
    "source": Text, [], where_it_comes_from, no_default;
    "note": Text, [], what_there_is_to_see, no_default;
    "unit": Text, [], unit_of_every_length, "`\"mm\"`";
    "parameters": Parameters, [], numbers_with_names, no_default;
    "tolerance": Number(Of(Measure::Deviation), Any), [], tolerance_of_lengths, exact_by_default;
    "clearance": Number(Of(Measure::Deviation), Any), [], clearance_of_pins, "0";
    "ground": Points(Of(Measure::Coordinate)), [], points_fixed_in_frame, no_default;
    "marks": Points(Of(Measure::Coordinate)), [], points_only_shown, no_default;
    "driver": Table(DRIVER), [], the_input, "";
    "inputs": Each(TIMED), [], inputs_that_follow, no_default;
    "lead": Each(LEAD), [], point_that_leads, no_default;
    "links": Each(LINK), [], rigid_links, no_default;
    "slides": Each(SLIDE), [], guides_and_sliders, no_default;
    "copies": Each(COPY), [], copies_of_groups, no_default;
    "start": Points(Of(Measure::Start)), [], rough_positions, no_default;
    "vectors": Vectors, [], further_vectors, no_default;
    "limits": Limits(LIMIT), [], coordinates_between_stops, no_default;
    "loads": List(LOAD), [], any_number_of_loads, no_default;
    "springs": List(SPRING), [], any_number_of_springs, no_default;
    "gravity": Pair(In(Measure::Gravity)), [], acceleration_of_fall, "`[0, 0]`";
    "figures": Formulas, [], figures_by_formulas, no_default;
    "motor": Table(MOTOR), [], what_is_to_drive, no_default;
    "tolerances": Numbers(Of(Measure::Deviation)), [], tolerances_of_points, tolerance_of_link_or_scene;
    "clearances": Numbers(Of(Measure::Deviation)), [], clearances_of_pins, "`clearance`";
    "redundant": Table(REDUNDANT), [], constraints_that_repeat, no_default;
    "view": Table(VIEW), [], what_views_show_first, no_default;

DRIVER =
    "link": Text, ["link"], the_turning_link, "";
    "slide": Text, ["slide"], the_pushed_slide, "";
    "from": Text, ["link"], seat_of_driver, "`\"ground\"`";
    "angle": Number(Of(Measure::Angle), Any), ["link"], opening_angle, direction_if_drawn;
    "position": Number(Of(Measure::Coordinate), Any), ["slide"], opening_position, "";
    "range": Ends(Driver), [], range_of_driver, no_default;
    "speed": Rate(Degree::Speed), [], speed_of_driver, unit_speed;
    "acceleration": Rate(Degree::Acceleration), [], acceleration_of_driver, "0";
    "motion": Steps(STEP), [], motion_of_driver, no_default;

STEP =
    "law": Text, ["constant", "harmonic", "cycloidal", "trapezoid", "table", "sine"], law_of_step, "";
    "to": Number(Driver, Any), ["constant", "harmonic", "cycloidal", "trapezoid"], end_of_step, "";
    "time": Number(In(Measure::Time), Positive), ["constant", "harmonic", "cycloidal", "trapezoid", "sine"], time_of_step, "";
    "amplitude": Number(Driver, Positive), ["sine"], amplitude_of_step, "";
    "phase": Number(In(Measure::Angle), Any), ["sine"], phase_of_step, "`0`";
    "ramp": Number(Of(Measure::Factor), AtMostHalf), ["trapezoid"], ramp_of_step, "`1/3`";
    "knots": Knots([Of(Measure::Time), Driver], "coordinate"), ["table"], knots_of_step, "";
    "dwell": Number(In(Measure::Time), Positive), ["dwell"], dwell_of_step, "";

TIMED =
    "at": Number(Driver, Any), [], where_an_input_is_held, no_default;
    "ratio": Number(Of(Measure::Factor), Any), [], ratio_of_input, "1";
    "phase": Number(Driver, Any), [], phase_of_input, "0";
    "over": Knots([DriverItself, Driver], "value"), [], table_of_input, no_default;
    "from": Text, [], seat_of_driver, "`\"ground\"`";

LEAD =
    "over": Rows, ["over"], rows_of_lead, "";
    "centre": Pair(Of(Measure::Coordinate)), ["centre"], centre_of_lead, "";
    "radius": Number(Of(Measure::Length), Positive), ["centre"], radius_of_lead, "";
    "angle": Number(In(Measure::Angle), Any), ["centre"], angle_of_lead, "`0`";
    "speed": Rate(Degree::Speed), ["centre"], speed_of_lead, "";
    "inputs": Text, [], inputs_of_lead, all_inputs;

LINK =
    "from": Text, [], "", "";
    "to": Text, [], "", "";
    "length": Number(Of(Measure::Length), Distance), [], ends_and_their_distance, no_vector_by_default;
    "points": Places, [], points_in_link_frame, no_default;
    "com": Place, [], centre_in_link_frame, no_default;
    "mass": Number(Of(Measure::Mass), NotNegative), [], mass_of_link, "0";
    "inertia": Number(Of(Measure::Inertia), NotNegative), [], inertia_of_link, "0";
    "tolerance": Number(Of(Measure::Deviation), Any), [], tolerance_of_link, tolerance_of_scene;

PLACE =
    "from": Text, [], point_that_sees, origin_by_default;
    "length": Number(Of(Measure::Length), Arm), ["angle"], distance_of_place, "";
    "angle": Number(In(Measure::Angle), Any), ["angle"], direction_of_place, "";
    "distances": Distances(Of(Measure::Length)), ["distances"], distances_of_place, "";
    "side": Text, ["distances"], side_of_place, "`\"left\"`";

SLIDE =
    "point": Text, ["point"], pin_in_the_slot, "";
    "link": Text, ["link"], link_without_turning, "";
    "on": Text, [], what_carries_the_guide, "";
    "through": Pair(Of(Measure::Coordinate)), [], point_of_the_guide, "";
    "angle": Number(In(Measure::Angle), Any), [], angle_of_guide, "0";
    "turn": Number(In(Measure::Angle), Any), ["link"], turn_of_slider, "0";
    "tolerance": Number(Of(Measure::Deviation), Any), [], tolerance_of_guide, tolerance_of_scene;

COPY =
    "of": Text, [], group_that_is_copied, "";
    "count": Number(Of(Measure::Factor), AtLeastOne), [], number_of_copies, "1";
    "mirror": Text, [], mirror_axis_of_copy, no_default;
    "turn": Number(In(Measure::Angle), Any), [], turn_of_copy, "0";
    "about": Pair(Of(Measure::Coordinate)), [], centre_of_copy, "`[0, 0]`";
    "move": Pair(Of(Measure::Coordinate)), [], shift_of_copy, "`[0, 0]`";
    "phase": Number(In(Measure::Angle), Any), [], phase_of_copy, "0";
    "join": Text, [], points_joined_by_copy, no_default;

LIMIT =
    "link": Text, [], "", "";
    "from": Text, [], link_and_from_where, "`\"ground\"`";
    "angle": Ends(Of(Measure::Angle)), [], ends_of_an_angle, "";

LOAD =
    "point": Text, ["force"], "", "";
    "force": Pair(In(Measure::Force)), ["force"], force_at_a_point, "";
    "frame": Text, ["force"], frame_of_a_force, "`\"ground\"`";
    "link": Text, ["torque"], "", "";
    "torque": Number(In(Measure::Torque), Any), ["torque"], torque_on_a_link, "";
    "over": Knots([Driver, Of(Measure::Factor)], "factor"), ["force", "torque"], factor_over_driver, "1";
    "slide": Text, ["press"], "", "";
    "press": Knots([Of(Measure::Coordinate), Of(Measure::Force)], "size"), ["press"], press_of_a_slide, "";
    "end": Text, ["press"], end_of_a_press, the_lower_end;

SPRING =
    "from": Text, ["spring", "gas"], "", "";
    "to": Text, [], ends_of_a_spring, "";
    "stiffness": Number(In(Measure::Stiffness), NotNegative), ["spring", "torsion"], stiffness_of_spring, "0";
    "length": Number(Of(Measure::Length), NotNegative), ["spring"], free_length, "0";
    "force": Knots([Of(Measure::Length), Of(Measure::Force)], "size"), ["gas"], force_of_gas_spring, "";
    "link": Text, ["torsion"], link_of_torsion_spring, "";
    "angle": Number(In(Measure::Angle), Any), ["torsion"], free_angle, "0";
    "preload": Number(In(Measure::Force), Any), ["spring", "torsion"], preload_of_spring, "0";
    "damping": Number(In(Measure::Damping), NotNegative), [], damping_of_spring, "0";

MOTOR =
    "torque": Number(In(Measure::Torque), Known), ["link"], rated_torque, unknown_by_default;
    "force": Number(In(Measure::Force), Known), ["slide"], rated_force, unknown_by_default;
    "peak": Number(Effort, Known), [], peak_of_motor, unknown_by_default;
    "speed": Rate(Degree::Speed), [], rated_speed, unknown_by_default;
    "flywheel": Number(In(Measure::Inertia), Known), ["link"], flywheel_of_motor, "0";
    "fluctuation": Number(Of(Measure::Factor), Known), ["link"], fluctuation_wished, no_default;
    "rest": Number(Of(Measure::Length), Known), [], rest_of_ram, no_default;
    "tolerance": Number(Of(Measure::Length), Known), [], "", "";

REDUNDANT =
    "misfit": Number(In(Measure::Length), NotNegative), [], misfit_accepted, "0";

VIEW =
    "traces": Text, [], points_traced_first, "`[]`";
}

/// Returns the row of a key.
pub(crate) fn find(keys: &'static [SceneKey], name: &str) -> Option<&'static SceneKey> {
    keys.iter().find(|key| key.name == name)
}

/// Returns the names of the keys that an element of this kind has; all keys if the kind is empty.
pub(crate) fn of(keys: &'static [SceneKey], kind: &str) -> Vec<&'static str> {
    let fits = |key: &&SceneKey| kind.is_empty() || key.of.is_empty() || key.of.contains(&kind);
    keys.iter().filter(fits).map(|key| key.name).collect()
}

/// Returns a table of all keys of a scene in Markdown, with descriptions and defaults in the
/// current language. Plain keys come first, as in a file.
#[must_use]
pub fn reference() -> String {
    let mut table = format!("| {} |\n|---|---|---|\n", words().heads_of_keys());
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
    /// Creates a row without a description; `of` lists the kinds that have the key, none for all.
    #[must_use]
    pub const fn new(name: &'static str, kind: KeyKind, of: &'static [&'static str]) -> SceneKey {
        SceneKey {
            name,
            kind,
            of,
            words: KeyText::Typed(""),
            default: KeyText::Typed(""),
        }
    }

    /// Returns `true` if this kind has the key, and not every kind.
    #[must_use]
    pub fn is_of(&self, kind: &str) -> bool {
        self.of.contains(&kind)
    }

    /// Returns a section's heading as written in a file, and its keys; `None` for a plain key.
    fn heading(&self) -> Option<(String, &'static [SceneKey])> {
        let name = self.name;
        match self.kind {
            Text | Flag | Number(..) | Series(_) | Rows | Ends(_) | Pair(_) | Rate(_)
            | Knots(..) | Place | Places | Distances(_) | Steps(_) => None,
            Numbers(_) | Points(_) | Vectors | Formulas | Parameters => {
                Some((format!("[{name}]"), &[]))
            }
            Table(keys) | Each(keys) | Limits(keys) => Some((format!("[{name}]"), keys)),
            List(keys) => Some((format!("[[{name}]]"), keys)),
        }
    }
}

fn rows<'k>(table: &mut String, keys: impl Iterator<Item = &'k SceneKey>) {
    let mut names = Vec::new();
    for key in keys {
        names.push(format!("`{}`", key.name));
        if !key.words.spoken().is_empty() {
            row(table, &names.join(", "), key);
            names.clear();
        }
    }
}

fn row(table: &mut String, name: &str, key: &SceneKey) {
    let default = match key.default.spoken() {
        "" => String::new(),
        default => format!("{default} "),
    };
    table.push_str(&format!("| {name} | {} | {default}|\n", key.words.spoken()));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;
    use crate::wording::Language;
    use std::collections::BTreeSet;

    /// Returns `true` if a value of the wrong type is reported in a scene with these sections.
    fn is_reported(sections: &[(&str, &str)]) -> bool {
        let lines = sections
            .iter()
            .map(|(name, value)| format!("{name} = {value}\n"));
        let text: String = lines.collect();
        let faults = Scene::parse(&text, "t").unwrap_err();
        let places = faults.items.iter().filter_map(|item| item.primary.as_ref());
        places
            .into_iter()
            .any(|place| &text[place.span.clone()] == "true")
    }

    /// Returns the keys by which a table is of this kind.
    fn characteristic(table: &str, kind: &str) -> Vec<(String, &'static str)> {
        let named = |key: &str| vec![(key.to_owned(), "\"r2\"")];
        match (table, kind) {
            ("copies", _) => vec![("of".into(), "[\"r3\"]"), ("turn".into(), "9")],
            ("driver", "") => vec![("link".into(), "\"r2\""), ("angle".into(), "0")],
            (_, TORSION) => named("link"),
            ("motor" | "", _) | (_, "" | "spring") => Vec::new(),
            ("motion", "dwell") => vec![("dwell".into(), "1")],
            ("motion", law) => {
                let known = [
                    "\"constant\"",
                    "\"harmonic\"",
                    "\"cycloidal\"",
                    "\"trapezoid\"",
                    "\"table\"",
                    "\"sine\"",
                ];
                let law = known
                    .into_iter()
                    .find(|known| known.trim_matches('"') == law);
                vec![("law".into(), law.unwrap())]
            }
            (_, "force") => vec![("force".into(), "[1, 1]"), ("point".into(), "\"B\"")],
            (_, "torque") => vec![("torque".into(), "1"), ("link".into(), "\"r2\"")],
            (_, "press") => vec![("press".into(), "[[1, 1]]"), ("slide".into(), "\"r4\"")],
            (_, "gas") => vec![("force".into(), "[[1, 1]]")],

            (_, key) => named(key),
        }
    }

    /// A key without code that reads it would accept any value.
    #[test]
    fn every_key_of_every_table_is_read() {
        let tables: [(&str, &[SceneKey], [&str; 2]); 14] = [
            ("", SCENE, ["", ""]),
            ("driver", DRIVER, ["{ ", " }"]),
            (
                "motion",
                STEP,
                ["{ link = \"r2\", angle = 0, motion = [{ ", " }] }"],
            ),
            ("inputs", TIMED, ["{ r3 = { ", " } }"]),
            ("links", LINK, ["{ r9 = { ", " } }"]),
            ("links", PLACE, ["{ r9 = { points = { P = { ", " } } } }"]),
            ("slides", SLIDE, ["{ r4 = { ", " } }"]),
            ("copies", COPY, ["{ z = { ", " } }"]),
            ("limits", LIMIT, ["{ elbow = { ", " } }"]),
            ("loads", LOAD, ["[{ ", " }]"]),
            ("springs", SPRING, ["[{ ", " }]"]),
            ("motor", MOTOR, ["{ ", " }"]),
            ("redundant", REDUNDANT, ["{ ", " }"]),
            ("view", VIEW, ["{ ", " }"]),
        ];
        for (table, keys, [start, end]) in tables {
            for key in keys {
                let kinds: &[&str] = if key.of.is_empty() { &[""] } else { key.of };
                for kind in kinds {
                    let mut pairs = characteristic(table, kind);
                    pairs.retain(|(name, _)| name != key.name);
                    pairs.push((key.name.to_owned(), "true"));
                    let pairs = pairs
                        .iter()
                        .map(|(name, value)| format!("{name} = {value}"));
                    let value = format!("{start}{}{end}", pairs.collect::<Vec<_>>().join(", "));
                    let section = match table {
                        "" => (key.name, "true"),
                        "motion" => ("driver", &*value),
                        table => (table, &*value),
                    };
                    let driver = match *kind {
                        "slide" => "{ slide = \"r4\", position = 1 }",
                        _ => "{ link = \"r2\", angle = 0 }",
                    };
                    let others = [
                        ("ground", "{ A = [0, 0] }"),
                        ("driver", driver),
                        (
                            "links",
                            "{ r2 = { from = \"A\", to = \"B\", length = 1 }, r3 = { from = \"B\", to = \"C\", length = 2 } }",
                        ),
                        (
                            "slides",
                            "{ r4 = { point = \"C\", on = \"ground\", through = \"A\" } }",
                        ),
                    ];
                    let mut sections = vec![section];
                    sections.extend(others.into_iter().filter(|(name, _)| *name != section.0));
                    assert!(is_reported(&sections), "{table}: {} of {kind}", key.name);
                }
            }
        }
    }

    /// The reference describes every key, and has the same rows in both languages.
    #[test]
    fn reference_lists_every_key_in_both_languages() {
        let text = Language::ALL.map(|language| {
            language.speak();
            let text = reference();
            has_every_key(&text);
            text
        });
        let typed = |text: &str| -> Vec<String> {
            let cells = text.lines().map(|row| row.split(" | ").next().unwrap());
            cells.skip(1).map(str::to_owned).collect()
        };
        let [english, turkish] = text;
        assert_eq!(typed(&english), typed(&turkish));
        for (english, turkish) in english.lines().zip(turkish.lines()) {
            let is_rule = english.starts_with("|---");
            assert!(is_rule || english != turkish, "{english}");
            // The code between backticks is equal.
            let code = |row: &str| -> BTreeSet<String> {
                let pieces = row.split('`').skip(1).step_by(2);
                pieces.map(str::to_owned).collect()
            };
            assert_eq!(code(english), code(turkish));
        }
    }

    fn has_every_key(text: &str) {
        let sections = SCENE.iter().filter_map(SceneKey::heading);
        for (heading, keys) in sections {
            let (_, section) = text.split_once(&format!("| **`{heading}`** | ")).unwrap();
            let section = section.split("| **").next().unwrap();
            for key in keys {
                assert!(section.contains(&format!("`{}`", key.name)), "{}", key.name);
            }
        }
        assert!(!text.contains("|  |"), "{text}");
    }
}
