//! Reads the driver.

use super::Unit;
use super::draft::{Driver, Input};
use super::rate::{self, Degree, Kind, Misfit};
use super::reader::{Reader, Span, Value, meant};
use crate::document::Diagnostic;
use crate::nearest::did_you_mean;
use toml::de::DeTable;

/// The rate where the file gives none: per unit of the coordinate, so that velocities are the
/// kinematic coefficients.
const UNIT_SPEED: f64 = 1.0;

/// Whose rates they are.
const OF: &str = "the driver";

/// How a kind of driver is written.
pub(super) struct Form {
    /// The key that names what is driven.
    driven: &'static str,
    /// The key of its coordinate.
    coordinate: &'static str,
    /// The coordinate of the other kind.
    other: &'static str,
    /// What a motor drives it by, and the key for it.
    pub(super) effort: &'static str,
    example: &'static str,
}

pub(super) const TURNED: Form = Form {
    driven: "link",
    coordinate: "angle",
    other: "position",
    effort: "torque",
    example: r#"link = "r2", angle = 60, speed = "15 rad/s""#,
};

pub(super) const PUSHED: Form = Form {
    driven: "slide",
    coordinate: "position",
    other: "angle",
    effort: "force",
    example: r#"slide = "r4", position = 120, speed = "50 mm/s""#,
};

impl Form {
    fn keys(&self) -> [&'static str; 4] {
        [self.driven, self.coordinate, "speed", "acceleration"]
    }
}

/// The section `[driver]`.
pub(super) fn driver<'v>(
    reader: &mut Reader<'_>,
    unit: Unit,
    key: Span,
    value: &'v Value<'v>,
) -> Option<Driver<'v>> {
    let example = format!("{{ {} }}", TURNED.example);
    let table = reader.table("[driver]", &example, value)?;
    let (form, driven) = match (table.get(TURNED.driven), table.get(PUSHED.driven)) {
        (Some(link), None) => (TURNED, link),
        (None, Some(slide)) => (PUSHED, slide),
        (None, None) => {
            neither(reader, table, key);
            return None;
        }
        (Some(_), Some(_)) => {
            let message = "the driver has both `link` and `slide`";
            reader.report(both_forms(
                Diagnostic::new(message).at(key, "one of them is driven"),
            ));
            return None;
        }
    };
    let name = reader.string(&format!("`{}` of the driver", form.driven), driven);
    let start = start(reader, table, &form, key);
    let kind = if form.driven == TURNED.driven {
        Kind::Turn
    } else {
        Kind::Push(unit)
    };
    let speed = rate(reader, OF, table, "speed", kind, Degree::Speed);
    let acceleration = rate(
        reader,
        OF,
        table,
        "acceleration",
        kind,
        Degree::Acceleration,
    );
    let name = name?;
    Some(Driver {
        input: match kind {
            Kind::Turn => Input::Link(name),
            Kind::Push(_) => Input::Slide(name),
        },
        start: start.unwrap_or(0.0),
        speed: speed.unwrap_or(UNIT_SPEED),
        acceleration: acceleration.unwrap_or(0.0),
    })
}

/// Nothing is driven: a misspelt key, or none at all.
fn neither(reader: &mut Reader<'_>, table: &DeTable<'_>, key: Span) {
    let known = [
        "link",
        "slide",
        "angle",
        "position",
        "speed",
        "acceleration",
    ];
    reader.only("the driver", table, &known);
    if !meant(table, &known, "link") && !meant(table, &known, "slide") {
        let message = "the driver has neither `link` nor `slide`";
        reader.report(both_forms(
            Diagnostic::new(message).at(key, "nothing is driven"),
        ));
    }
}

fn both_forms(fault: Diagnostic) -> Diagnostic {
    fault
        .help(format!("a driven link: {}", TURNED.example))
        .help(format!("a driven slide: {}", PUSHED.example))
}

/// The coordinate at which the scene opens.
fn start(reader: &mut Reader<'_>, table: &DeTable<'_>, form: &Form, key: Span) -> Option<f64> {
    let Form {
        driven,
        coordinate,
        other,
        ..
    } = form;
    let given = table.get(*coordinate);
    if let (None, Some((wrong, _))) = (given, table.get_key_value(*other)) {
        reader.report(
            Diagnostic::new(format!(
                "the driver: a driven {driven} has no `{other}` but `{coordinate}`"
            ))
            .at(wrong.span(), format!("`{coordinate}` is meant"))
            .help(format!("for example: {coordinate} = 60")),
        );
        return None;
    }
    reader.only("the driver", table, &form.keys());
    // A misspelt key was reported already; what it leaves missing is no second fault.
    if given.is_none() && !meant(table, &form.keys(), coordinate) {
        let label = format!("`{coordinate}` is missing: where the scene opens");
        reader.report(
            Diagnostic::new(format!("the driver has no `{coordinate}`"))
                .at(key, label)
                .help(format!("for example: {coordinate} = 60")),
        );
    }
    reader.number(&format!("`{coordinate}` of the driver"), given?)
}

/// A speed or an acceleration, `None` if it is left out or wrong.
pub(super) fn rate(
    reader: &mut Reader<'_>,
    of: &str,
    table: &DeTable<'_>,
    key: &str,
    kind: Kind,
    degree: Degree,
) -> Option<f64> {
    let value = table.get(key)?;
    let literal = reader.literal(&value.span());
    let bare = literal.trim_matches(['`', '"', '\'', ' ']);
    let is_number = value.get_ref().is_integer() || value.get_ref().is_float();
    let misfit = match value.get_ref().as_str() {
        Some(text) => match rate::parse(text, kind, degree) {
            Ok(rate) => return Some(rate),
            Err(misfit) => misfit,
        },
        None if is_number => Misfit::NoUnit,
        None => Misfit::NoNumber,
    };
    let units = rate::units(kind, degree);
    let (rule, help) = match misfit {
        Misfit::NoNumber => (
            "must be a number and a unit in quotes, not",
            Some(format!("for example: {key} = \"15 {}\"", units[0])),
        ),
        Misfit::NoUnit => (
            "has no unit:",
            Some(format!("for example: {key} = \"{bare} {}\"", units[0])),
        ),
        Misfit::Unit(unit) => (
            "has a unit that does not fit:",
            did_you_mean(unit, units.iter().copied()),
        ),
        Misfit::NotFinite => ("is too large:", None),
    };
    reader.report(
        Diagnostic::new(format!("`{key}` of {of} {rule} `{bare}`"))
            .at(value.span(), "expected a number and a unit, in quotes")
            .maybe_help(help)
            .help(format!("possible units: `{}`", units.join("`, `"))),
    );
    None
}
