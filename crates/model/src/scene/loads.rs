//! Reads the loads on the mechanism.

use super::keys;
use super::profile::{self, Knots};
use super::reader::{CoordinatePair, Name, Reader};
use crate::document::{Diagnostic, Lenient, WrittenKey};
use crate::nearest::did_you_mean;
use crate::wording::words;
use crate::{Profile, StrokeEnd, Vec2};
use serde::Deserialize;

const LOAD: ListExample = ["[[loads]]", r#"point = "C""#, "force = [0, -500]"];

/// The heading of a list, and two keys of a table in it.
pub(super) type ListExample = [&'static str; 3];

pub(super) fn said([list, one, other]: ListExample) -> String {
    words().example_of_list(list, one, other)
}

/// The list `[[loads]]` as written.
pub(super) type Loads = Lenient<Vec<Lenient<LoadTable>>>;

/// A load as written.
#[derive(Debug, Deserialize)]
pub(super) struct LoadTable {
    point: Option<Lenient<String>>,
    force: Option<CoordinatePair>,
    frame: Option<Lenient<String>>,
    link: Option<Lenient<String>>,
    torque: Option<Lenient<f64>>,
    over: Option<Knots>,
    slide: Option<Lenient<String>>,
    press: Option<Knots>,
    end: Option<Lenient<String>>,
}

#[derive(Debug)]
pub(super) enum DraftLoad<'t> {
    Force {
        point: Name<'t>,
        force: Vec2,
        /// The link that the force turns with; `None` for the ground's frame.
        frame: Option<Name<'t>>,
        over: Profile,
    },
    Torque {
        link: Name<'t>,
        torque: f64,
        over: Profile,
    },
    Press {
        slide: Name<'t>,
        curve: Profile,
        /// `None` if the direction of the guide decides.
        end: Option<StrokeEnd>,
    },
}

/// The kinds of loads, each identified by the key of its magnitude.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum LoadKind {
    Force,
    Torque,
    Press,
}

impl LoadKind {
    const ALL: [LoadKind; 3] = [LoadKind::Force, LoadKind::Torque, LoadKind::Press];

    /// Returns the key of its magnitude, which is also its name.
    fn size(self) -> &'static str {
        match self {
            LoadKind::Force => "force",
            LoadKind::Torque => "torque",
            LoadKind::Press => "press",
        }
    }

    /// Returns the key of the element that it acts on.
    fn on(self) -> &'static str {
        match self {
            LoadKind::Force => "point",
            LoadKind::Torque => "link",
            LoadKind::Press => "slide",
        }
    }

    fn example(self) -> &'static str {
        match self {
            LoadKind::Force => r#"point = "C", force = [0, -500]"#,
            LoadKind::Torque => r#"link = "r4", torque = 12"#,
            LoadKind::Press => r#"slide = "r6", press = [[12, 0], [0, 350e3]]"#,
        }
    }
}

/// Reads the loads. Reports and omits those that could not be read.
pub(super) fn loads<'v>(reader: &mut Reader<'_>, value: &'v Loads) -> Vec<DraftLoad<'v>> {
    let items = list(reader, "loads", LOAD, value);
    items.iter().filter_map(|v| load(reader, v)).collect()
}

/// Returns the items of a list of tables. Reports a value that is not a list, and returns an empty
/// slice for it.
pub(super) fn list<'v, T>(
    reader: &mut Reader<'_>,
    key: &str,
    example: ListExample,
    value: &'v Lenient<Vec<T>>,
) -> &'v [T] {
    if let Some(items) = value.get() {
        return items;
    }
    reader.report(
        Diagnostic::new(words().must_be_list_of_tables(key))
            .at(value.span.clone(), words().expected(words().a_list()))
            .help(words().for_example(&said(example))),
    );
    &[]
}

fn load<'v>(reader: &mut Reader<'_>, value: &'v Lenient<LoadTable>) -> Option<DraftLoad<'v>> {
    let of = words().the_load();
    let table = reader.table(words().a_load(), &said(LOAD), value)?;
    reader.only(of, value);
    let kind = kind(reader, table, value)?;
    foreign(reader, &value.keys, kind);
    let on = reader.text_of(kind.on(), of, table.on(kind));
    match kind {
        LoadKind::Force => {
            let what = words().key_of("force", of) + " (N)";
            let force = reader.pair(&what, table.force.as_ref()?);
            let frame = reader.text_of("frame", of, table.frame.as_ref());
            let over = profile::over(reader, table.over.as_ref());
            if frame.is_none() && table.frame.is_some() {
                return None;
            }
            Some(DraftLoad::Force {
                point: on?,
                force: force?,
                frame,
                over: over?,
            })
        }
        LoadKind::Torque => {
            let what = words().key_of("torque", of) + " (N m)";
            let torque = reader.number(&what, table.torque.as_ref()?);
            let over = profile::over(reader, table.over.as_ref());
            Some(DraftLoad::Torque {
                link: on?,
                torque: torque?,
                over: over?,
            })
        }
        LoadKind::Press => {
            let curve = profile::press(reader, table.press.as_ref()?);
            let end = table.end.as_ref().map(|value| stroke_end(reader, value));
            Some(DraftLoad::Press {
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

impl LoadTable {
    /// Returns the name of the element that a load of this kind acts on, if given.
    fn on(&self, kind: LoadKind) -> Option<&Lenient<String>> {
        match kind {
            LoadKind::Force => self.point.as_ref(),
            LoadKind::Torque => self.link.as_ref(),
            LoadKind::Press => self.slide.as_ref(),
        }
    }
}

/// Returns the kind of a load that has a magnitude and an element to act on; reports any other
/// load.
fn kind(
    reader: &mut Reader<'_>,
    table: &LoadTable,
    value: &Lenient<LoadTable>,
) -> Option<LoadKind> {
    let given = |kind: LoadKind| Some((kind, value.key(kind.size())?.span()));
    let mut sizes = LoadKind::ALL.into_iter().filter_map(given);
    let fault = match (sizes.next(), sizes.next()) {
        (Some((kind, _)), None) if table.on(kind).is_some() => return Some(kind),
        (Some((kind, _)), None) => without(value, kind)?,
        (Some((one, first)), Some((other, second))) => {
            Diagnostic::new(words().load_has_both(one.size(), other.size()))
                .at(second, words().a_second_load())
                .and(first, words().one_load())
                .help(words().each_a_load_of_its_own())
        }
        (None, _) => nothing(value)?,
    };
    reader.report(fault);
    None
}

/// Returns the diagnostic of a load without an element to act on; `None` if a misspelt key, already
/// reported, explains it.
fn without(load: &Lenient<LoadTable>, kind: LoadKind) -> Option<Diagnostic> {
    let (size, on) = (kind.size(), kind.on());
    if load.meant(on) {
        return None;
    }
    let fault = Diagnostic::new(words().load_has_no_target(size, on))
        .at(load.span.clone(), words().acts_on_what(size))
        .help(words().kinds_of_loads());
    Some(fault.help(words().for_example(kind.example())))
}

/// Returns the diagnostic of a load without a magnitude; `None` if a misspelt key explains it.
fn nothing(load: &Lenient<LoadTable>) -> Option<Diagnostic> {
    let meant = |kind: &LoadKind| load.meant(kind.size());
    if LoadKind::ALL.iter().any(meant) {
        return None;
    }
    Some(match load.key("over") {
        Some(key) => Diagnostic::new(words().over_without_size())
            .at(key.span(), words().factors_of_what())
            .help(words().over_scales()),
        None => Diagnostic::new(words().load_has_no_size())
            .at(load.span.clone(), words().no_load_here())
            .help(words().kinds_of_loads())
            .help(words().for_example(&said(LOAD))),
    })
}

/// Reports keys that belong to another kind of load.
fn foreign(reader: &mut Reader<'_>, given: &[WrittenKey], kind: LoadKind) {
    let fitting = keys::of(keys::LOAD, kind.size());
    for key in given {
        let text = key.get_ref().as_str();
        if fitting.contains(&text) || keys::find(keys::LOAD, text).is_none() {
            continue;
        }
        let why = match text {
            "frame" => words().no_frame_to_turn_with(),
            "over" => words().press_is_given_over_way(),
            "end" => words().only_press_has_end(),
            _ => words().one_load_acts_on_one(),
        };
        let kind = kind.size();
        reader.report(
            Diagnostic::new(words().kind_has_no_key(kind, text))
                .at(key.span(), words().not_for_kind(kind))
                .help(why),
        );
    }
}

fn stroke_end(reader: &mut Reader<'_>, value: &Lenient<String>) -> Option<StrokeEnd> {
    let name = reader.string(&words().key_of("end", words().the_load()), value)?;
    let end = match name.text {
        "least" => return Some(StrokeEnd::Least),
        "greatest" => return Some(StrokeEnd::Greatest),
        _ => Diagnostic::new(words().least_or_greatest(&name.to_string())),
    };
    reader.report(
        end.at(name.span.clone(), words().is_no_end_of_stroke())
            .maybe_help(did_you_mean(name.text, ["least", "greatest"]))
            .help(words().which_ends_there_are()),
    );
    None
}
