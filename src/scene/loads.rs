//! Reads what acts on the mechanism: loads and springs.

use super::draft::{Load, Spring};
use super::profile;
use super::reader::{Reader, Span, Value, meant};
use crate::StrokeEnd;
use crate::document::Diagnostic;
use crate::nearest::did_you_mean;
use toml::de::DeTable;

const LOAD: &str = r#"[[loads]] with point = "C" and force = [0, -500]"#;
const SPRING: &str = r#"[[springs]] with from = "A", to = "E" and stiffness = 1200"#;

const SPRING_KEYS: [&str; 5] = ["from", "to", "stiffness", "length", "damping"];
const LOAD_KEYS: [&str; 9] = [
    "point", "force", "frame", "link", "torque", "over", "slide", "press", "end",
];

/// The kinds of loads, each known by the key of its size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Force,
    Torque,
    Press,
}

impl Kind {
    const ALL: [Kind; 3] = [Kind::Force, Kind::Torque, Kind::Press];

    /// The key of its size, and its name.
    fn size(self) -> &'static str {
        match self {
            Kind::Force => "force",
            Kind::Torque => "torque",
            Kind::Press => "press",
        }
    }

    /// The key of what it acts on.
    fn on(self) -> &'static str {
        match self {
            Kind::Force => "point",
            Kind::Torque => "link",
            Kind::Press => "slide",
        }
    }

    fn keys(self) -> &'static [&'static str] {
        match self {
            Kind::Force => &["point", "force", "frame", "over"],
            Kind::Torque => &["link", "torque", "over"],
            Kind::Press => &["slide", "press", "end"],
        }
    }

    fn example(self) -> &'static str {
        match self {
            Kind::Force => r#"point = "C", force = [0, -500]"#,
            Kind::Torque => r#"link = "r4", torque = 12"#,
            Kind::Press => r#"slide = "r6", press = [[12, 0], [0, 350e3]]"#,
        }
    }
}

/// The list `[[loads]]`. What could not be read is left out, and reported.
pub(super) fn loads<'v>(reader: &mut Reader<'_>, value: &'v Value<'v>) -> Vec<Load<'v>> {
    let items = list(reader, "loads", LOAD, value);
    items.iter().filter_map(|v| load(reader, v)).collect()
}

/// The list `[[springs]]`, likewise.
pub(super) fn springs<'v>(reader: &mut Reader<'_>, value: &'v Value<'v>) -> Vec<Spring<'v>> {
    let items = list(reader, "springs", SPRING, value);
    items.iter().filter_map(|v| spring(reader, v)).collect()
}

fn list<'v>(
    reader: &mut Reader<'_>,
    key: &str,
    example: &str,
    value: &'v Value<'v>,
) -> &'v [Value<'v>] {
    if let Some(items) = value.get_ref().as_array() {
        return items;
    }
    reader.report(
        Diagnostic::new(format!("`{key}` must be a list of tables"))
            .at(value.span(), "expected a list")
            .help(format!("for example: {example}")),
    );
    &[]
}

fn load<'v>(reader: &mut Reader<'_>, value: &'v Value<'v>) -> Option<Load<'v>> {
    let table = reader.table("a load", LOAD, value)?;
    reader.only("the load", table, &LOAD_KEYS);
    let (kind, on, size) = kind(reader, table, &value.span())?;
    foreign(reader, table, kind);
    let on = reader.string(&format!("`{}` of the load", kind.on()), on);
    match kind {
        Kind::Force => {
            let force = reader.pair("`force` of the load (N)", size);
            let frame = table.get("frame");
            let frame = frame.map(|value| reader.string("`frame` of the load", value));
            let over = profile::over(reader, table.get("over"));
            Some(Load::Force {
                point: on?,
                force: force?,
                frame: match frame {
                    Some(read) => Some(read?),
                    None => None,
                },
                over: over?,
            })
        }
        Kind::Torque => {
            let torque = reader.number("`torque` of the load (N m)", size);
            let over = profile::over(reader, table.get("over"));
            Some(Load::Torque {
                link: on?,
                torque: torque?,
                over: over?,
            })
        }
        Kind::Press => {
            let curve = profile::press(reader, size);
            let end = table.get("end").map(|value| stroke_end(reader, value));
            Some(Load::Press {
                slide: on?,
                curve: curve?,
                end: match end {
                    Some(read) => Some(read?),
                    None => None,
                },
            })
        }
    }
}

/// What kind of load it is, with the values of what it acts on and of its size.
fn kind<'v>(
    reader: &mut Reader<'_>,
    table: &'v DeTable<'v>,
    span: &Span,
) -> Option<(Kind, &'v Value<'v>, &'v Value<'v>)> {
    let given = |kind: Kind| table.get_key_value(kind.size()).map(|size| (kind, size));
    let mut sizes = Kind::ALL.into_iter().filter_map(given);
    let fault = match (sizes.next(), sizes.next()) {
        (Some((kind, (_, size))), None) => match table.get(kind.on()) {
            Some(on) => return Some((kind, on, size)),
            None => without(table, kind, span)?,
        },
        (Some((one, (first, _))), Some((other, (second, _)))) => {
            let message = format!(
                "the load has both a `{}` and a `{}`",
                one.size(),
                other.size()
            );
            Diagnostic::new(message)
                .at(second.span(), "a second load")
                .and(first.span(), "one load")
                .help("give each a [[loads]] of its own")
        }
        (None, _) => nothing(table, span)?,
    };
    reader.report(fault);
    None
}

/// The fault of a load that acts on nothing. A misspelt key was reported already; what it leaves
/// missing is no second fault.
fn without(table: &DeTable<'_>, kind: Kind, span: &Span) -> Option<Diagnostic> {
    let (size, on) = (kind.size(), kind.on());
    if meant(table, &LOAD_KEYS, on) {
        return None;
    }
    let fault = Diagnostic::new(format!("the load has a `{size}` but no `{on}`"))
        .at(span.clone(), format!("what does the {size} act on?"))
        .help("a load is a force at a point, a torque on a link, or a press on a slide");
    Some(fault.help(format!("for example: {}", kind.example())))
}

/// The fault of a load without a size.
fn nothing(table: &DeTable<'_>, span: &Span) -> Option<Diagnostic> {
    if Kind::ALL
        .iter()
        .any(|kind| meant(table, &LOAD_KEYS, kind.size()))
    {
        return None;
    }
    Some(match table.get_key_value("over") {
        Some((key, _)) => {
            Diagnostic::new("the load has an `over` but neither a `force` nor a `torque`")
                .at(key.span(), "factors of what?")
                .help(
                    "`over` scales a force or a torque: give its size, and 1 where it acts in full",
                )
        }
        None => Diagnostic::new("the load has neither a `force`, nor a `torque`, nor a `press`")
            .at(span.clone(), "nothing acts here")
            .help("a load is a force at a point, a torque on a link, or a press on a slide")
            .help(format!("for example: {LOAD}")),
    })
}

/// Reports keys that belong to another kind of load.
fn foreign(reader: &mut Reader<'_>, table: &DeTable<'_>, kind: Kind) {
    for (key, _) in table {
        let text = key.get_ref().as_ref();
        if kind.keys().contains(&text) || !LOAD_KEYS.contains(&text) {
            continue;
        }
        let why = match text {
            "frame" => "a torque and a press have no direction that could turn with a link",
            "over" => "what a press does is given over its way: press = [[12, 0], [0, 350e3]]",
            "end" => "only a press works at an end of a stroke",
            _ => "one load acts on one thing: give each a [[loads]] of its own",
        };
        let kind = kind.size();
        reader.report(
            Diagnostic::new(format!("the load: a {kind} has no `{text}`"))
                .at(key.span(), format!("not for a {kind}"))
                .help(why),
        );
    }
}

fn stroke_end(reader: &mut Reader<'_>, value: &Value<'_>) -> Option<StrokeEnd> {
    let name = reader.string("`end` of the load", value)?;
    let end = match name.text {
        "least" => return Some(StrokeEnd::Least),
        "greatest" => return Some(StrokeEnd::Greatest),
        _ => Diagnostic::new(format!(
            "`end` of the load must be `least` or `greatest`, not {name}"
        )),
    };
    reader.report(
        end.at(name.span.clone(), "no end of a stroke")
            .maybe_help(did_you_mean(name.text, ["least", "greatest"]))
            .help("the press works where the position along the guide is least, or greatest"),
    );
    None
}

fn spring<'v>(reader: &mut Reader<'_>, value: &'v Value<'v>) -> Option<Spring<'v>> {
    let table = reader.table("a spring", SPRING, value)?;
    reader.only("the spring", table, &SPRING_KEYS);
    let mut end = |key: &str| {
        let Some(value) = table.get(key) else {
            if !meant(table, &SPRING_KEYS, key) {
                reader.report(
                    Diagnostic::new(format!("the spring has no `{key}`"))
                        .at(value.span(), "a spring acts between two points")
                        .help(format!("for example: {SPRING}")),
                );
            }
            return None;
        };
        reader.string(&format!("`{key}` of the spring"), value)
    };
    let (from, to) = (end("from"), end("to"));
    let mut number = |key, unit| reader.not_negative("the spring", table, key, unit);
    let stiffness = number("stiffness", " (N/m)");
    let length = number("length", "");
    let damping = number("damping", " (N s/m)");
    let given = |key| table.contains_key(key) || meant(table, &SPRING_KEYS, key);
    if !given("stiffness") && !given("damping") {
        reader.report(
            Diagnostic::new("the spring has neither a `stiffness` nor a `damping`")
                .at(value.span(), "it does nothing")
                .help("give it one: stiffness = 1200 is in N/m, damping = 5 in N s/m"),
        );
    }
    Some(Spring {
        from: from?,
        to: to?,
        stiffness,
        length,
        damping,
    })
}
