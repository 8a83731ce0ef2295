//! Reads springs: between points, gas springs by their force over the length, and torsion springs
//! between links.

use super::keys;
use super::loads::{ListExample, list, said};
use super::profile;
use super::reader::{Name, Reader};
use super::table::KeyTable;
use crate::Profile;
use crate::document::{Diagnostic, Written};
use crate::wording::words;

const SPRING: ListExample = ["[[springs]]", r#"from = "A", to = "E""#, "stiffness = 1200"];

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
    fn of(table: &KeyTable<'_>) -> SpringKind {
        if table.has("link") {
            SpringKind::Torsion
        } else if table.has("force") {
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
            SpringKind::Torsion => keys::TORSION,
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
}

/// Reads the springs. Reports and omits those that could not be read.
pub(super) fn springs<'v>(reader: &mut Reader<'_>, value: &'v Written<'v>) -> Vec<DraftSpring<'v>> {
    let items = list(reader, "springs", SPRING, value);
    items.iter().filter_map(|v| spring(reader, v)).collect()
}

fn spring<'v>(reader: &mut Reader<'_>, value: &'v Written<'v>) -> Option<DraftSpring<'v>> {
    let names = [words().a_spring(), words().the_spring()];
    let mut table = reader.open(names, keys::SPRING, &said(SPRING), value)?;
    reader.only_known(&table);
    let kind = SpringKind::of(&table);
    foreign(reader, &table, kind);
    let (from, to) = ends(reader, &table, kind);
    let is_sized = sized(&table, kind);
    let is_whole = kind == SpringKind::Torsion && !table.has("to");
    table.kind = kind.key();
    let law = law(reader, &table, kind);
    let damping = reader.number_of(&table, "damping").unwrap_or(0.0);
    if !is_sized {
        let help = match kind {
            SpringKind::Torsion => words().give_torsion_spring_a_size(),
            SpringKind::Line | SpringKind::Gas => words().give_spring_a_size(),
        };
        reader.report(
            Diagnostic::new(words().spring_has_no_size())
                .at(table.span, words().does_nothing())
                .help(help),
        );
    }
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
    table: &KeyTable<'v>,
    kind: SpringKind,
) -> (Option<Name<'v>>, Option<Name<'v>>) {
    let mut end = |key: &str, is_needed: bool| {
        if is_needed && !table.has(key) && !table.meant(key) {
            reader.report(
                Diagnostic::new(words().spring_lacks_end(key))
                    .at(table.span.clone(), words().springs_have_two_ends())
                    .help(words().for_example(&said(SPRING))),
            );
        }
        reader.text_of(table, key)
    };
    match kind {
        SpringKind::Line | SpringKind::Gas => (end("from", true), end("to", true)),
        SpringKind::Torsion => (end("link", true), end("to", false)),
    }
}

fn law(reader: &mut Reader<'_>, table: &KeyTable<'_>, kind: SpringKind) -> Option<DraftLaw> {
    let stiffness = reader.number_of(table, "stiffness").unwrap_or(0.0);
    let preload = reader.number_or(table, "preload", 0.0);
    let angle = reader.number_or(table, "angle", 0.0);
    Some(match kind {
        SpringKind::Line => DraftLaw::Line {
            stiffness,
            length: reader.number_of(table, "length").unwrap_or(0.0),
            preload: preload?,
        },
        SpringKind::Gas => DraftLaw::Gas(profile::gas(reader, table)?),
        SpringKind::Torsion => DraftLaw::Torsion {
            stiffness,
            angle: angle?,
            preload: preload?,
        },
    })
}

/// Returns `true` if a spring has a stiffness, a damping or a preload, as far as its kind needs one.
fn sized(table: &KeyTable<'_>, kind: SpringKind) -> bool {
    let is_given = |key: &&str| table.has(key) || table.meant(key);
    kind == SpringKind::Gas || ["stiffness", "damping", "preload"].iter().any(is_given)
}

/// Reports keys that belong to another kind of spring.
fn foreign(reader: &mut Reader<'_>, table: &KeyTable<'_>, kind: SpringKind) {
    for key in table.strays(kind.key()) {
        reader.report(
            Diagnostic::new(words().spring_kind_has_no_key(kind.name(), key.text))
                .at(key.span, words().not_for_kind(kind.name()))
                .help(kind.rule()),
        );
    }
}
