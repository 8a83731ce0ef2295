//! Reads what acts on the mechanism: the driver and the loads.

use super::Unit;
use super::diagnostic::Diagnostic;
use super::draft::{Driver, Input, Load};
use super::rate::{self, Degree, Kind, Misfit};
use super::reader::{Name, Reader, Span, Value, did_you_mean, meant};
use toml::de::DeTable;

const TURNED: &str = r#"link = "r2", angle = 60, speed = "15 rad/s""#;
const PUSHED: &str = r#"slide = "r4", position = 120, speed = "50 mm/s""#;
const LOAD: &str =
    r#"[[loads]] with point = "C" and force = [0, -500], or link = "r4" and torque = 12"#;

const TURNED_KEYS: [&str; 4] = ["link", "angle", "speed", "acceleration"];
const PUSHED_KEYS: [&str; 4] = ["slide", "position", "speed", "acceleration"];

/// The rate where the file gives none: per unit of the coordinate, so that velocities are the
/// kinematic coefficients.
const UNIT_SPEED: f64 = 1.0;

/// The section `[driver]`.
pub(super) fn driver<'v>(
    reader: &mut Reader<'_>,
    unit: Unit,
    key: Span,
    value: &'v Value<'v>,
) -> Option<Driver<'v>> {
    let table = reader.table("[driver]", &format!("{{ {TURNED} }}"), value)?;
    let (input, coordinate, keys, kind) = match (table.get("link"), table.get("slide")) {
        (Some(link), None) => {
            let name = reader.string("`link` of the driver", link);
            (name.map(Input::Link), "angle", TURNED_KEYS, Kind::Turn)
        }
        (None, Some(slide)) => {
            let name = reader.string("`slide` of the driver", slide);
            let kind = Kind::Push(unit);
            (name.map(Input::Slide), "position", PUSHED_KEYS, kind)
        }
        (given, _) => {
            let (message, label) = if given.is_some() {
                (
                    "the driver has both `link` and `slide`",
                    "one of them is driven",
                )
            } else {
                (
                    "the driver has neither `link` nor `slide`",
                    "nothing is driven",
                )
            };
            reader.report(
                Diagnostic::new(message)
                    .at(key, label)
                    .help(format!("a driven link: {TURNED}"))
                    .help(format!("a driven slide: {PUSHED}")),
            );
            return None;
        }
    };
    let start = match other_coordinate(table, coordinate) {
        Some(fault) => {
            reader.report(fault);
            None
        }
        None => {
            reader.only("the driver", table, &keys);
            start(reader, table, coordinate, &keys, key)
        }
    };
    let speed = rate(reader, table, "speed", kind, Degree::Speed);
    let acceleration = rate(reader, table, "acceleration", kind, Degree::Acceleration);
    Some(Driver {
        input: input?,
        start: start.unwrap_or(0.0),
        speed: speed.unwrap_or(UNIT_SPEED),
        acceleration: acceleration.unwrap_or(0.0),
    })
}

/// The coordinate of the other kind of driver, in place of its own.
fn other_coordinate(table: &DeTable<'_>, coordinate: &str) -> Option<Diagnostic> {
    let (driven, other) = match coordinate {
        "angle" => ("link", "position"),
        _ => ("slide", "angle"),
    };
    let (key, _) = table.get_key_value(other)?;
    (!table.contains_key(coordinate)).then(|| {
        Diagnostic::new(format!(
            "the driver: a driven {driven} has no `{other}` but `{coordinate}`"
        ))
        .at(key.span(), format!("`{coordinate}` is meant"))
        .help(format!("for example: {coordinate} = 60"))
    })
}

/// The coordinate at which the scene opens.
fn start<'v>(
    reader: &mut Reader<'_>,
    table: &'v DeTable<'v>,
    coordinate: &str,
    known: &[&str],
    key: Span,
) -> Option<f64> {
    if let Some(value) = table.get(coordinate) {
        return reader.number(&format!("`{coordinate}` of the driver"), value);
    }
    // A misspelt key was reported already; what it leaves missing is no second fault.
    if meant(table, known, coordinate) {
        return None;
    }
    reader.report(
        Diagnostic::new(format!("the driver has no `{coordinate}`"))
            .at(
                key,
                format!("`{coordinate}` is missing: where the scene opens"),
            )
            .help(format!("for example: {coordinate} = 60")),
    );
    None
}

/// A speed or an acceleration, `None` if it is left out or wrong.
fn rate<'v>(
    reader: &mut Reader<'_>,
    table: &'v DeTable<'v>,
    key: &str,
    kind: Kind,
    degree: Degree,
) -> Option<f64> {
    let value = table.get(key)?;
    let units = rate::units(kind, degree);
    let list = format!("possible units: `{}`", units.join("`, `"));
    let Some(text) = value.get_ref().as_str() else {
        let literal = reader.literal(&value.span());
        let bare = literal.trim_matches('`');
        let fault = Diagnostic::new(format!("`{key}` of the driver has no unit: {literal}"))
            .at(value.span(), "expected a number and a unit, in quotes");
        let is_number = value.get_ref().is_integer() || value.get_ref().is_float();
        reader.report(
            fault
                .help(if is_number {
                    format!("for example: {key} = \"{bare} {}\"", units[0])
                } else {
                    format!("for example: {key} = \"15 {}\"", units[0])
                })
                .help(list),
        );
        return None;
    };
    let misfit = match rate::parse(text, kind, degree) {
        Ok(rate) => return Some(rate),
        Err(misfit) => misfit,
    };
    let name = Name {
        text,
        span: value.span(),
    };
    let (rule, help) = match misfit {
        Misfit::NoNumber => ("does not begin with a number", None),
        Misfit::NoUnit => (
            "has no unit",
            Some(format!(
                "for example: {key} = \"{} {}\"",
                text.trim(),
                units[0]
            )),
        ),
        Misfit::Unit(unit) => (
            "has a unit that does not fit",
            did_you_mean(unit, units.iter().copied()),
        ),
        Misfit::NotFinite => ("is too large", None),
    };
    reader.report(
        Diagnostic::new(format!("`{key}` of the driver {rule}: {name}"))
            .at(name.span.clone(), "expected a number and a unit")
            .maybe_help(help)
            .help(list),
    );
    None
}

/// The list `[[loads]]`.
pub(super) fn loads<'v>(reader: &mut Reader<'_>, value: &'v Value<'v>) -> Vec<Load<'v>> {
    let Some(items) = value.get_ref().as_array() else {
        reader.report(
            Diagnostic::new("`loads` must be a list of tables")
                .at(value.span(), "expected a list")
                .help(format!("for example: {LOAD}")),
        );
        return Vec::new();
    };
    let read = |value| load(reader, value);
    items.iter().filter_map(read).collect()
}

fn load<'v>(reader: &mut Reader<'_>, value: &'v Value<'v>) -> Option<Load<'v>> {
    let table = reader.table("a load", LOAD, value)?;
    let has = |key| table.get(key);
    match (has("point"), has("force"), has("link"), has("torque")) {
        (Some(point), Some(force), None, None) => {
            reader.only("the load", table, &["point", "force"]);
            let point = reader.string("`point` of the load", point);
            let force = reader.pair("`force` of the load (N)", force);
            Some(Load::Force {
                point: point?,
                force: force?,
            })
        }
        (None, None, Some(link), Some(torque)) => {
            reader.only("the load", table, &["link", "torque"]);
            let link = reader.string("`link` of the load", link);
            let torque = reader.number("`torque` of the load (N m)", torque);
            Some(Load::Torque {
                link: link?,
                torque: torque?,
            })
        }
        _ => {
            reader.only("the load", table, &["point", "force", "link", "torque"]);
            reader.report(
                Diagnostic::new("a load is a force at a point or a torque on a link")
                    .at(value.span(), "neither of them")
                    .help(format!("for example: {LOAD}")),
            );
            None
        }
    }
}
