//! Reads springs: between points, gas springs by their force over the length, and torsion springs
//! between links.

use super::keys;
use super::loads::{ListExample, list, said};
use super::profile::{self, Knots};
use super::reader::{Name, Reader};
use crate::Profile;
use crate::document::{Diagnostic, Lenient, WrittenKey};
use crate::wording::words;
use serde::Deserialize;

const SPRING: ListExample = ["[[springs]]", r#"from = "A", to = "E""#, "stiffness = 1200"];

/// The list `[[springs]]` as written.
pub(super) type Springs = Lenient<Vec<Lenient<SpringTable>>>;

/// A spring as written.
#[derive(Debug, Deserialize)]
pub(super) struct SpringTable {
    from: Option<Lenient<String>>,
    to: Option<Lenient<String>>,
    stiffness: Option<Lenient<f64>>,
    length: Option<Lenient<f64>>,
    force: Option<Knots>,
    link: Option<Lenient<String>>,
    angle: Option<Lenient<f64>>,
    preload: Option<Lenient<f64>>,
    damping: Option<Lenient<f64>>,
}

#[derive(Debug)]
pub(super) struct DraftSpring<'t> {
    /// The point where it begins, or the link on which a torsion spring acts.
    pub(super) from: Name<'t>,
    /// The other end. For a torsion spring it is the link to which it is fixed, or `None` for the
    /// ground.
    pub(super) to: Option<Name<'t>>,
    pub(super) law: DraftLaw,
    pub(super) damping: f64,
}

/// The force or torque law of a spring.
#[derive(Debug)]
pub(super) enum DraftLaw {
    Line {
        stiffness: f64,
        length: f64,
        preload: f64,
    },
    Gas(Profile),
    Torsion {
        stiffness: f64,
        angle: f64,
        preload: f64,
    },
}

/// The kinds of springs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum SpringKind {
    Line,
    Gas,
    Torsion,
}

impl SpringKind {
    /// Returns the kind by its keys: a torsion spring has `link`, a gas spring `force`.
    fn of(value: &Lenient<SpringTable>) -> SpringKind {
        if value.key("link").is_some() {
            SpringKind::Torsion
        } else if value.key("force").is_some() {
            SpringKind::Gas
        } else {
            SpringKind::Line
        }
    }

    /// Returns the name under which the table of keys lists its own keys.
    fn key(self) -> &'static str {
        match self {
            SpringKind::Line => "spring",
            SpringKind::Gas => "gas",
            SpringKind::Torsion => "torsion",
        }
    }

    fn name(self) -> &'static str {
        match self {
            SpringKind::Line => words().a_plain_spring(),
            SpringKind::Gas => words().a_gas_spring(),
            SpringKind::Torsion => words().a_torsion_spring(),
        }
    }

    fn rule(self) -> &'static str {
        match self {
            SpringKind::Line => words().rule_of_springs(),
            SpringKind::Gas => words().rule_of_gas_springs(),
            SpringKind::Torsion => words().rule_of_torsion_springs(),
        }
    }

    fn units(self) -> [&'static str; 3] {
        match self {
            SpringKind::Line | SpringKind::Gas => [" (N/m)", " (N)", " (N s/m)"],
            SpringKind::Torsion => [" (N m/rad)", " (N m)", " (N m s/rad)"],
        }
    }
}

/// Reads the springs. Reports and omits those that could not be read.
pub(super) fn springs<'v>(reader: &mut Reader<'_>, value: &'v Springs) -> Vec<DraftSpring<'v>> {
    let items = list(reader, "springs", SPRING, value);
    items.iter().filter_map(|v| spring(reader, v)).collect()
}

fn spring<'v>(reader: &mut Reader<'_>, value: &'v Lenient<SpringTable>) -> Option<DraftSpring<'v>> {
    let of = words().the_spring();
    let table = reader.table(words().a_spring(), &said(SPRING), value)?;
    reader.only(of, value);
    let kind = SpringKind::of(value);
    foreign(reader, &value.keys, kind);
    let (from, to) = ends(reader, value, table, kind);
    let law = law(reader, table, kind);
    let damping = reader.not_negative(of, "damping", kind.units()[2], table.damping.as_ref());
    sized(reader, value, kind);
    let is_whole = kind == SpringKind::Torsion && value.key("to").is_none();
    Some(DraftSpring {
        from: from?,
        to: if is_whole { None } else { Some(to?) },
        law: law?,
        damping,
    })
}

/// Reads the two ends and reports missing ones. A torsion spring may be fixed to the ground.
fn ends<'v>(
    reader: &mut Reader<'_>,
    value: &Lenient<SpringTable>,
    table: &'v SpringTable,
    kind: SpringKind,
) -> (Option<Name<'v>>, Option<Name<'v>>) {
    let mut end = |key: &str, given: &'v Option<Lenient<String>>, is_needed: bool| {
        if is_needed && given.is_none() && !value.meant(key) {
            reader.report(
                Diagnostic::new(words().spring_lacks_end(key))
                    .at(value.span.clone(), words().springs_have_two_ends())
                    .help(words().for_example(&said(SPRING))),
            );
        }
        reader.text_of(key, words().the_spring(), given.as_ref())
    };
    match kind {
        SpringKind::Line | SpringKind::Gas => {
            (end("from", &table.from, true), end("to", &table.to, true))
        }
        SpringKind::Torsion => (end("link", &table.link, true), end("to", &table.to, false)),
    }
}

fn law(reader: &mut Reader<'_>, table: &SpringTable, kind: SpringKind) -> Option<DraftLaw> {
    let of = words().the_spring();
    let [stiff, loaded, _] = kind.units();
    let stiffness = reader.not_negative(of, "stiffness", stiff, table.stiffness.as_ref());
    let mut number = |key: &str, unit: &str, given: &Option<Lenient<f64>>| match given {
        Some(value) => reader.number(&(words().key_of(key, of) + unit), value),
        None => Some(0.0),
    };
    let preload = number("preload", loaded, &table.preload);
    let angle = number("angle", " (deg)", &table.angle);
    Some(match kind {
        SpringKind::Line => DraftLaw::Line {
            stiffness,
            length: reader.not_negative(of, "length", "", table.length.as_ref()),
            preload: preload?,
        },
        SpringKind::Gas => DraftLaw::Gas(profile::gas(reader, table.force.as_ref()?)?),
        SpringKind::Torsion => DraftLaw::Torsion {
            stiffness,
            angle: angle?,
            preload: preload?,
        },
    })
}

/// Reports a spring without stiffness, damping or preload.
fn sized(reader: &mut Reader<'_>, value: &Lenient<SpringTable>, kind: SpringKind) {
    let is_given = |key: &&str| value.key(key).is_some() || value.meant(key);
    if kind != SpringKind::Gas && !["stiffness", "damping", "preload"].iter().any(is_given) {
        let help = match kind {
            SpringKind::Torsion => words().give_torsion_spring_a_size(),
            SpringKind::Line | SpringKind::Gas => words().give_spring_a_size(),
        };
        reader.report(
            Diagnostic::new(words().spring_has_no_size())
                .at(value.span.clone(), words().does_nothing())
                .help(help),
        );
    }
}

/// Reports keys that belong to another kind of spring.
fn foreign(reader: &mut Reader<'_>, given: &[WrittenKey], kind: SpringKind) {
    let fitting = keys::of(keys::SPRING, kind.key());
    for key in given {
        let text = key.get_ref().as_str();
        if fitting.contains(&text) || keys::find(keys::SPRING, text).is_none() {
            continue;
        }
        reader.report(
            Diagnostic::new(words().spring_kind_has_no_key(kind.name(), text))
                .at(key.span(), words().not_for_kind(kind.name()))
                .help(kind.rule()),
        );
    }
}
