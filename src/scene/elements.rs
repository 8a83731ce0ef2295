//! Reads links, slides and vectors.

use super::draft::{Draft, Ends, Link, MOST_LINKS, Place, Slide, Slider, Through, Vector, places};
use super::reader::{Name, ORDINARY, Reader, SMALLEST_LENGTH, Span, Value, meant, quoted};
use crate::document::Diagnostic;
use toml::Spanned;
use toml::de::{DeString, DeTable};

const LINK: &str = r#"r2 = { from = "A", to = "B", length = 100 }"#;
const POINTS: &str = "r2 = { points = { A = [0, 0] } }";
const SLIDE: &str = r#"r4 = { point = "C", on = "ground", through = "A", angle = 0 }"#;
const VECTOR: &str = r#"r1 = ["D", "A"]"#;

const LINK_KEYS: [&str; 7] = ["from", "to", "length", "points", "com", "mass", "inertia"];
const PIN_KEYS: [&str; 4] = ["point", "on", "through", "angle"];
const SLIDING_KEYS: [&str; 5] = ["link", "on", "through", "angle", "turn"];

/// The key of an element: its name.
pub(super) fn name<'v>(key: &'v Spanned<DeString<'v>>) -> Name<'v> {
    Name {
        text: key.get_ref().as_ref(),
        span: key.span(),
    }
}

/// The fault of a scene without links and slides; what else it lacks follows from that.
pub(super) fn nothing_moves() -> Diagnostic {
    Diagnostic::new("the scene has no links: nothing moves")
        .help(format!("add, for example:\n[links]\n{LINK}"))
}

/// The section `[links]`.
pub(super) fn links<'v>(reader: &mut Reader<'_>, draft: &mut Draft<'v>, value: &'v Value<'v>) {
    let Some(table) = reader.table("[links]", LINK, value) else {
        return;
    };
    if table.len() > MOST_LINKS {
        let count = table.len();
        reader.report(
            Diagnostic::new(format!(
                "the scene has {count} links; at most {MOST_LINKS} are allowed"
            ))
            .at(value.span(), "too many links"),
        );
        draft.unreadable = true;
        return;
    }
    for (key, value) in table {
        let link = link(reader, &mut draft.lost_points, name(key), value);
        draft.links.push(link);
    }
}

fn link<'v>(
    reader: &mut Reader<'_>,
    lost_points: &mut bool,
    name: Name<'v>,
    value: &'v Value<'v>,
) -> Link<'v> {
    let before = reader.found.len();
    let mut link = Link {
        name,
        ends: None,
        points: Vec::new(),
        com: None,
        mass: 0.0,
        inertia: 0.0,
        mass_key: None,
        broken: false,
    };
    let of = format!("link {}", link.name);
    if let Some(table) = reader.table(&of, LINK, value) {
        reader.only(&of, table, &LINK_KEYS);
        *lost_points |= !link_ends(reader, &of, table, &mut link);
        *lost_points |= !link_points(reader, &of, table, &mut link);
        link_mass(reader, &of, table, &mut link);
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
    Diagnostic::new(format!("{of} has no points"))
        .at(name.span.clone(), "a link needs two ends, or `points`")
        .help(format!("for example: {LINK}"))
        .help(format!("or, for a link with a single joint: {POINTS}"))
}

/// `from`, `to` and `length` belong together. An end without the others still names its point.
/// Returns whether no end was lost.
fn link_ends<'v>(
    reader: &mut Reader<'_>,
    of: &str,
    table: &'v DeTable<'v>,
    link: &mut Link<'v>,
) -> bool {
    let mut end = |key: &str| {
        let value = table.get(key)?;
        reader.string(&format!("`{key}` of {of}"), value)
    };
    let (from, to) = (end("from"), end("to"));
    let length = table.get("length").map(|value| length(reader, of, value));
    let (has_from, has_to) = (table.contains_key("from"), table.contains_key("to"));
    let missing = match (has_from, has_to, length.is_some()) {
        (false, false, false) | (true, true, true) => None,
        (true, true, false) => Some("`from` and `to` but no `length`"),
        (true, false, _) => Some("`from` but no `to`"),
        (false, true, _) => Some("`to` but no `from`"),
        (false, false, true) => Some("a `length` but no `from` and `to`"),
    };
    if let Some(missing) = missing {
        // A misspelt key was reported already; what it leaves missing is no second fault.
        let misspelt = ["from", "to", "length"]
            .into_iter()
            .any(|key| !table.contains_key(key) && meant(table, &LINK_KEYS, key));
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
            let read = None;
            link.points.extend(named.map(|name| Place { name, read }));
            missing.is_none() && !has_from && !has_to
        }
    }
}

/// The further points. Returns whether none was lost.
fn link_points<'v>(
    reader: &mut Reader<'_>,
    of: &str,
    table: &'v DeTable<'v>,
    link: &mut Link<'v>,
) -> bool {
    let Some(value) = table.get("points") else {
        return !meant(table, &LINK_KEYS, "points");
    };
    let what = format!("{of}: point");
    let listed = places(reader, &format!("`points` of {of}"), &what, value);
    link.points.extend(listed);
    value.get_ref().is_table()
}

fn link_mass<'v>(reader: &mut Reader<'_>, of: &str, table: &'v DeTable<'v>, link: &mut Link<'v>) {
    if let Some((key, value)) = table.get_key_value("com") {
        let at = reader.pair(&format!("`com` of {of}"), value);
        link.com = Some((key.span(), at.unwrap_or_default()));
    }
    link.mass = reader.not_negative(of, table, "mass", "");
    link.inertia = reader.not_negative(of, table, "inertia", "");
    let key = |name| table.get_key_value(name).map(|(key, _)| (name, key.span()));
    link.mass_key = key("mass").or_else(|| key("inertia"));
}

fn incomplete(of: &str, missing: &str, span: Span) -> Diagnostic {
    Diagnostic::new(format!("{of} has {missing}"))
        .at(span, "`from`, `to` and `length` belong together")
        .help(format!("for example: {LINK}"))
        .help(format!(
            "a link without two natural ends is given by `points` alone: {POINTS}"
        ))
}

fn length<'v>(reader: &mut Reader<'_>, of: &str, value: &Value<'v>) -> Option<f64> {
    let length = reader.number(&format!("`length` of {of}"), value)?;
    let literal = reader.literal(&value.span());
    let fault = |rule: &str, label: &str| {
        Diagnostic::new(format!("`length` of {of} must be {rule}, not {literal}"))
            .at(value.span(), label)
    };
    if length >= SMALLEST_LENGTH {
        return Some(length);
    }
    reader.report(if length > 0.0 {
        fault("at least 1e-300", "too small to compute with").help(ORDINARY)
    } else if length == 0.0 {
        fault("positive", "a link without length has no direction")
            .help("two joints at one place need no link between them: give them one name")
    } else {
        fault("positive", "not positive")
            .help("a length is a distance; the direction of a link is from `from` to `to`")
    });
    None
}

/// The section `[slides]`.
pub(super) fn slides<'v>(reader: &mut Reader<'_>, draft: &mut Draft<'v>, value: &'v Value<'v>) {
    let Some(table) = reader.table("[slides]", SLIDE, value) else {
        return;
    };
    for (key, value) in table {
        let slide = slide(reader, name(key), value);
        draft.lost_points |= slide.slider.is_none();
        draft.slides.push(slide);
    }
}

fn slide<'v>(reader: &mut Reader<'_>, name: Name<'v>, value: &'v Value<'v>) -> Slide<'v> {
    let of = format!("slide {name}");
    let mut slide = Slide {
        name,
        slider: None,
        on: None,
        through: None,
        angle: 0.0,
    };
    let Some(table) = reader.table(&of, SLIDE, value) else {
        return slide;
    };
    slide.slider = slider(reader, &of, &slide.name, table);
    slide.angle = optional(reader, &of, table, "angle");
    if let Some(on) = required(reader, &of, &slide.name, table, "on", r#"on = "ground""#) {
        slide.on = reader.string(&format!("`on` of {of}"), on);
    }
    let example = "through = [0, 0]";
    if let Some(value) = required(reader, &of, &slide.name, table, "through", example) {
        slide.through = through(reader, &of, value);
    }
    slide
}

/// A point of the guide, by name or by coordinates.
fn through<'v>(reader: &mut Reader<'_>, of: &str, value: &'v Value<'v>) -> Option<Through<'v>> {
    if let Some(text) = value.get_ref().as_str() {
        let span = value.span();
        return Some(Through::Point(Name { text, span }));
    }
    let at = reader.pair(&format!("`through` of {of}"), value);
    at.map(Through::At)
}

/// What slides: a pin or a link.
fn slider<'v>(
    reader: &mut Reader<'_>,
    of: &str,
    name: &Name<'v>,
    table: &'v DeTable<'v>,
) -> Option<Slider<'v>> {
    let fault = |message: String, label: &str| {
        Diagnostic::new(message)
            .at(name.span.clone(), label)
            .help(r#"a pin in a slot has `point = "C"`, a link that slides without turning `link = "r6"`"#)
    };
    match (table.get("point"), table.get("link")) {
        (Some(point), None) => {
            if let Some((key, _)) = table.get_key_value("turn") {
                reader.report(
                    Diagnostic::new(format!("{of}: a pin in a slot has no `turn`"))
                        .at(key.span(), "only for a slide of a link")
                        .help("a pin may turn in its slot; to keep a link from turning, slide the link: link = \"...\""),
                );
            } else {
                reader.only(of, table, &PIN_KEYS);
            }
            let pin = reader.string(&format!("`point` of {of}"), point)?;
            Some(Slider::Pin(pin))
        }
        (None, Some(link)) => {
            reader.only(of, table, &SLIDING_KEYS);
            let turn = optional(reader, of, table, "turn");
            let link = reader.string(&format!("`link` of {of}"), link)?;
            Some(Slider::Link { link, turn })
        }
        (Some(_), Some(_)) => {
            reader.report(fault(
                format!("{of} has both `point` and `link`"),
                "one of them slides",
            ));
            None
        }
        (None, None) => {
            reader.only(
                of,
                table,
                &["point", "link", "on", "through", "angle", "turn"],
            );
            reader.report(fault(
                format!("{of} has neither `point` nor `link`"),
                "nothing slides here",
            ));
            None
        }
    }
}

fn required<'v>(
    reader: &mut Reader<'_>,
    of: &str,
    name: &Name<'v>,
    table: &'v DeTable<'v>,
    key: &str,
    example: &str,
) -> Option<&'v Value<'v>> {
    let value = table.get(key);
    // A misspelt key was reported already; what it leaves missing is no second fault.
    if value.is_none() && !meant(table, &SLIDING_KEYS, key) {
        reader.report(
            Diagnostic::new(format!("{of} has no `{key}`"))
                .at(name.span.clone(), format!("`{key}` is missing"))
                .help(format!("for example: {example}")),
        );
    }
    value
}

/// An angle in degrees, 0 if left out.
fn optional<'v>(reader: &mut Reader<'_>, of: &str, table: &'v DeTable<'v>, key: &str) -> f64 {
    let value = table.get(key);
    let angle = value.and_then(|v| reader.number(&format!("`{key}` of {of} (deg)"), v));
    angle.unwrap_or(0.0)
}

/// The section `[vectors]`.
pub(super) fn vectors<'v>(reader: &mut Reader<'_>, value: &'v Value<'v>) -> Vec<Vector<'v>> {
    let Some(table) = reader.table("[vectors]", VECTOR, value) else {
        return Vec::new();
    };
    let read = |(key, value)| vector(reader, name(key), value);
    table.iter().filter_map(read).collect()
}

fn vector<'v>(reader: &mut Reader<'_>, name: Name<'v>, value: &'v Value<'v>) -> Option<Vector<'v>> {
    let what = format!("vector {}", quoted(name.text));
    let ends = reader.two(&what, "[tail, head] of points", r#"["D", "A"]"#, value)?;
    let tail = reader.string(&format!("the tail of {what}"), &ends[0]);
    let head = reader.string(&format!("the head of {what}"), &ends[1]);
    Some(Vector {
        tail: tail?,
        head: head?,
        name,
    })
}
