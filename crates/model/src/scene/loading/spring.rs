//! Reads springs: between points, gas springs by their force over the length, and torsion springs
//! between links.

use crate::document::{Diagnostic, WrittenValue};
use crate::scene::elements::link::DraftLink;
use crate::scene::keys;
use crate::scene::loading::loads::{ListExample, list, load_example};
use crate::scene::loading::profile;
use crate::scene::numbers::reader::{Name, Reader};
use crate::scene::resolve::Resolver;
use crate::scene::table::KeyTable;
use crate::wording::words;
use crate::{Body, Load, Profile};

const SPRING: ListExample = ["[[springs]]", r#"from = "A", to = "E""#, "stiffness = 1200"];

#[derive(Debug)]
pub(crate) struct DraftSpring<'t> {
    /// The point where it begins, or the link on which a torsion spring acts.
    pub(crate) from: Name<'t>,
    /// The other end. For a torsion spring it is the link to which it is fixed, or `None` for the
    /// ground.
    pub(crate) to: Option<Name<'t>>,
    pub(crate) law: DraftLaw,
    pub(crate) damping: f64,
}

/// The force or torque law of a spring.
#[derive(Debug)]
pub(crate) enum DraftLaw {
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
pub(crate) fn springs<'v>(
    reader: &mut Reader<'_>,
    value: &'v WrittenValue<'v>,
) -> Vec<DraftSpring<'v>> {
    let items = list(reader, "springs", SPRING, value);
    items.iter().filter_map(|v| spring(reader, v)).collect()
}

fn spring<'v>(reader: &mut Reader<'_>, value: &'v WrittenValue<'v>) -> Option<DraftSpring<'v>> {
    let names = [words().a_spring(), words().the_spring()];
    let mut table = reader.open(names, keys::SPRING, &load_example(SPRING), value)?;
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
        if is_needed && !table.has(key) && !table.is_probable_misspelling(key) {
            reader.report(
                Diagnostic::new(words().spring_lacks_end(key))
                    .at(table.span.clone(), words().springs_have_two_ends())
                    .help(words().for_example(&load_example(SPRING))),
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
    let is_given = |key: &&str| table.has(key) || table.is_probable_misspelling(key);
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

impl<'t> Resolver<'_, '_, 't> {
    /// Adds all springs to the builder.
    pub(crate) fn springs(&mut self) {
        let draft = self.draft;
        for spring in &draft.springs {
            let load = match &spring.to {
                Some(to) if !matches!(spring.law, DraftLaw::Torsion { .. }) => {
                    self.between_points(spring, to)
                }
                to => self.between_links(spring, to.as_ref()),
            };
            if let Some(load) = load {
                self.builder.load(load);
            }
        }
    }

    /// Returns a spring along the line between two points. Reports faults, and returns `None` for
    /// them.
    fn between_points(&mut self, spring: &DraftSpring<'t>, to: &Name<'t>) -> Option<Load> {
        let of = words().the_spring();
        let start = self.point(&words().key_of("from", of), &spring.from);
        let end = self.point(&words().key_of("to", of), to);
        let (from_point, to_point) = (start?, end?);
        if let Some(fault) = self.idle(&spring.from, to) {
            self.reader.report(fault);
            return None;
        }
        let (from, to, damping) = (from_point, to_point, spring.damping);
        match spring.law {
            DraftLaw::Line {
                stiffness,
                length,
                preload,
            } => Some(Load::Spring {
                from,
                to,
                stiffness,
                length,
                preload,
                damping,
            }),
            DraftLaw::Gas(ref force) => Some(Load::GasSpring {
                from,
                to,
                force: force.clone(),
                damping,
            }),
            DraftLaw::Torsion { .. } => None,
        }
    }

    /// Returns a torsion spring. Reports faults, and returns `None` for them.
    fn between_links(&mut self, spring: &DraftSpring<'t>, to: Option<&Name<'t>>) -> Option<Load> {
        let DraftLaw::Torsion {
            stiffness,
            angle,
            preload,
        } = spring.law
        else {
            return None;
        };
        let of = words().the_spring();
        let link = self.link(&words().key_of("link", of), &spring.from)?;
        let fixed = match to {
            Some(name) => self.body(&words().key_of("to", of), name)?,
            None => Body::Ground,
        };
        if let Some(to) = to.filter(|to| to.text == spring.from.text) {
            let fault = to_itself(&spring.from, to, words().name_two_links());
            self.reader.report(fault);
            return None;
        }
        Some(Load::TorsionSpring {
            link,
            to: fixed,
            stiffness,
            angle,
            preload,
            damping: spring.damping,
        })
    }

    /// Returns the diagnostic of a spring whose length never changes; `None` for other springs.
    fn idle(&self, from: &Name<'t>, to: &Name<'t>) -> Option<Diagnostic> {
        if from.text == to.text {
            return Some(to_itself(from, to, words().name_two_points()));
        }
        let grounded = |name: &Name<'_>| self.ground.contains_key(name.text);
        let carried = |link: &&DraftLink<'_>| [from, to].iter().all(|name| carries(link, name));
        let body = if grounded(from) && grounded(to) {
            words().the_ground_as_body().to_owned()
        } else {
            let link = self.draft.links.iter().find(carried)?;
            words().link_called(&link.name.to_string())
        };
        Some(
            Diagnostic::new(words().spring_on_one_body(&body))
                .at(to.span.clone(), words().length_never_changes())
                .and(from.span.clone(), words().begins_here())
                .help(words().springs_join_bodies()),
        )
    }
}

/// Returns the diagnostic of a spring with two equal ends.
fn to_itself(from: &Name<'_>, to: &Name<'_>, help: &'static str) -> Diagnostic {
    Diagnostic::new(words().spring_to_itself(&from.to_string()))
        .at(to.span.clone(), words().end_is_beginning())
        .and(from.span.clone(), words().begins_here())
        .help(help)
}

/// Returns `true` if a point or a centre of mass belongs to the link.
fn carries(link: &DraftLink<'_>, name: &Name<'_>) -> bool {
    let centre = name.text.strip_suffix(".com");
    centre == Some(link.name.text) || link.point_names().any(|point| point.text == name.text)
}
