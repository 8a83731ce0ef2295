//! The task file: the description of a required motion.
//!
//! ```toml
//! kind   = "poses"
//! unit   = "mm"
//! poses  = [[0, 0, 0], [120, 40, 35], [180, 130, 80]]   # x, y, angle
//! pivots = [[0, -100], [200, -100]]
//!
//! [wishes]
//! transmission = 40
//! ```
//!
//! It is parsed as a scene is: numbers may be formulas, and every fault is reported with its line.

mod examples;
mod functions;
mod kinds;
mod wishes;

pub use examples::ExampleTask;

use crate::Vec2;
use crate::document::{self, ByteSpan, Diagnostic, Diagnostics, Lenient, Misplaced, Name, Reader};
use crate::expression::Dimension;
use crate::nearest::did_you_mean;
use crate::scene::{self, MAX_FILE_SIZE, Unit};
use crate::synthesis::{Task, TaskKind};
use crate::wording::words;
use serde::Deserialize;

/// A list of numbers as written.
type NumberList = Lenient<Vec<Lenient<f64>>>;
/// A list of lists of numbers.
type RowList = Lenient<Vec<NumberList>>;

/// A task with its names.
#[derive(Clone, Debug, PartialEq)]
pub struct TaskFile {
    /// The title (`name`), or the file's stem if there is none.
    pub name: String,
    /// The origin of the task (`source`).
    pub source: Option<String>,
    /// A note on the task (`note`).
    pub note: Option<String>,
    /// The unit of every length.
    pub unit: Unit,
    /// The task itself.
    pub task: Task,
}

/// A task as written in its file.
#[derive(Debug, Deserialize)]
struct WrittenTask {
    kind: Option<Lenient<String>>,
    name: Option<Lenient<String>>,
    source: Option<Lenient<String>>,
    note: Option<Lenient<String>>,
    unit: Option<Lenient<String>>,
    linkages: Option<Lenient<Vec<Lenient<String>>>>,
    poses: Option<RowList>,
    points: Option<RowList>,
    pairs: Option<RowList>,
    pivots: Option<RowList>,
    pins: Option<RowList>,
    closed: Option<Lenient<bool>>,
    turns: Option<NumberList>,
    weights: Option<NumberList>,
    function: Option<Lenient<functions::WrittenFunction>>,
    crank: Option<Lenient<functions::WrittenSide>>,
    output: Option<Lenient<functions::WrittenSide>>,
    size: Option<Lenient<f64>>,
    wishes: Option<Lenient<wishes::WrittenWishes>>,
}

/// The kinds of tasks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum WrittenKind {
    Poses,
    Function,
    Path,
}

impl WrittenKind {
    const ALL: [WrittenKind; 3] = [WrittenKind::Poses, WrittenKind::Function, WrittenKind::Path];

    /// Returns the value of `kind`.
    fn name(self) -> &'static str {
        match self {
            WrittenKind::Poses => "poses",
            WrittenKind::Function => "function",
            WrittenKind::Path => "path",
        }
    }

    /// Returns its own keys, which not every kind has.
    fn keys(self) -> &'static [&'static str] {
        match self {
            WrittenKind::Poses => &["poses", "pivots", "pins"],
            WrittenKind::Function => &["pairs", "function", "crank", "output", "size"],
            WrittenKind::Path => &["points", "pivots", "closed", "turns", "weights"],
        }
    }
}

impl TaskFile {
    /// Returns the display title; titles of built-in tasks are translated.
    #[must_use]
    pub fn title(&self) -> String {
        words().translated_scene_text(&self.name)
    }

    /// Returns `true` if a file is a task: it has a `kind`, which no scene has.
    #[must_use]
    pub fn is_meant(bytes: &[u8]) -> bool {
        let text = std::str::from_utf8(bytes).unwrap_or_default();
        document::has_key(text.trim_start_matches('\u{feff}'), "kind")
    }

    /// Reads a task from the bytes of a file; `origin` is the name of the file in messages.
    ///
    /// # Errors
    /// Returns all faults found, with their places.
    pub fn read(bytes: &[u8], origin: &str) -> Result<TaskFile, Diagnostics> {
        if bytes.len() > MAX_FILE_SIZE {
            return Err(scene::too_large(origin));
        }
        match std::str::from_utf8(bytes) {
            Ok(text) => TaskFile::parse(text, origin),
            Err(error) => Err(document::not_utf8(bytes, error.valid_up_to(), origin)),
        }
    }

    /// Parses a task; `origin` is the name of the file in messages.
    ///
    /// # Errors
    /// Returns all faults found, with their places.
    pub fn parse(text: &str, origin: &str) -> Result<TaskFile, Diagnostics> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut reader = Reader::new(text);
        let root = document::parse(&mut reader, scene::mend);
        let file = root.and_then(|root| task_file(&mut reader, &root, origin));
        match file {
            Some(file) if reader.found.is_empty() => Ok(file),
            _ => Err(reader.into_diagnostics(origin)),
        }
    }
}

fn task_file(
    reader: &mut Reader<'_>,
    root: &Lenient<WrittenTask>,
    origin: &str,
) -> Option<TaskFile> {
    let file = root.get()?;
    if let (None, Some(links)) = (&file.kind, root.key("links").or_else(|| root.key("slides"))) {
        let fault = Diagnostic::new(words().scene_for_a_task());
        reader.report(
            fault
                .at(links.span(), "")
                .help(words().synthesize_reads_tasks()),
        );
        return None;
    }
    reader.only(words().the_task_itself(), root);
    let name = scene::line(reader, "name", file.name.as_ref());
    let source = scene::line(reader, "source", file.source.as_ref());
    let note = scene::line(reader, "note", file.note.as_ref());
    let unit = scene::unit(reader, file.unit.as_ref());
    reader.named.length = (unit.symbol(), unit.tenths_of_mm());
    let wishes = wishes::wishes(reader, file.wishes.as_ref());
    let (four_bars, slider_cranks) = linkages(reader, file.linkages.as_ref());
    let kind = kind(reader, root, file)?;
    if let Some(linkages) = &file.linkages {
        match kind {
            WrittenKind::Function if four_bars && slider_cranks => {
                let place = linkages.span.clone();
                reader.report(Diagnostic::new(words().one_output()).at(place, ""));
            }
            WrittenKind::Poses | WrittenKind::Path if slider_cranks && !four_bars => {
                kinds::slider_cranks_have_one_pivot(reader, file, &linkages.span);
            }
            WrittenKind::Poses | WrittenKind::Function | WrittenKind::Path => {}
        }
    }
    let task = Task {
        kind: match kind {
            WrittenKind::Poses => TaskKind::Poses(kinds::poses(reader, file)?),
            WrittenKind::Function => {
                TaskKind::Function(functions::function(reader, file, slider_cranks)?)
            }
            WrittenKind::Path => TaskKind::Path(kinds::path(reader, file)?),
        },
        four_bars,
        slider_cranks,
        wishes: wishes.for_motion(),
    };
    wishes.agree_with(reader, &task, file);
    Some(TaskFile {
        name: name.unwrap_or_else(|| scene::stem(origin)),
        source,
        note,
        unit,
        task,
    })
}

/// Reads the kind of the task; reports keys of other kinds.
fn kind(
    reader: &mut Reader<'_>,
    root: &Lenient<WrittenTask>,
    file: &WrittenTask,
) -> Option<WrittenKind> {
    let names = WrittenKind::ALL.map(WrittenKind::name);
    let Some(written) = &file.kind else {
        reader.report(
            Diagnostic::new(words().task_without_kind())
                .help(words().for_example("kind = \"poses\""))
                .help(words().these_are_known(&names.join("`, `"))),
        );
        return None;
    };
    let written = reader.string("`kind`", written)?;
    let kinds = WrittenKind::ALL.into_iter();
    let Some(kind) = kinds.clone().find(|kind| kind.name() == written.text) else {
        let near = did_you_mean(written.text, names);
        let help = near.unwrap_or_else(|| words().these_are_known(&names.join("`, `")));
        reader.report(
            Diagnostic::new(words().no_kind_of_task(&written.to_string()))
                .at(written.span, words().not_known_here())
                .help(help),
        );
        return None;
    };
    let own = kind.keys();
    let others = kinds.flat_map(WrittenKind::keys);
    for key in &root.keys {
        let name = key.get_ref().as_str();
        if others.clone().any(|other| *other == name) && !own.contains(&name) {
            reader.report(
                Diagnostic::new(words().key_of_another_kind(name, kind.name()))
                    .at(key.span(), words().belongs_to_another_kind())
                    .help(words().known_keys(&format!("`{}`", own.join("`, `")))),
            );
        }
    }
    Some(kind)
}

/// Reads the linkages to search, as flags for four-bars and slider-cranks; the default is four-bars
/// only.
fn linkages(
    reader: &mut Reader<'_>,
    written: Option<&Lenient<Vec<Lenient<String>>>>,
) -> (bool, bool) {
    const FORMS: [&str; 2] = ["four-bar", "slider-crank"];
    let Some(written) = written else {
        return (true, false);
    };
    let mut found = [false; 2];
    for form in list(reader, "`linkages`", "[\"four-bar\"]", written) {
        let Some(name) = reader.string("`linkages`", form) else {
            continue;
        };
        match FORMS.iter().position(|form| *form == name.text) {
            Some(form) => found[form] = true,
            None => reader.report(
                Diagnostic::new(words().no_form_of_linkage(&name.to_string()))
                    .at(name.span.clone(), words().not_known_here())
                    .help(words().these_are_known(&FORMS.join("`, `"))),
            ),
        }
    }
    if found == [false; 2] && reader.found.is_empty() {
        reader.report(
            Diagnostic::new(words().no_linkage_wanted())
                .at(written.span.clone(), "")
                .help(words().for_example("linkages = [\"four-bar\"]")),
        );
    }
    (found[0], found[1])
}

/// Returns the items of a list; reports another value, and returns an empty slice for it.
fn list<'v, T>(
    reader: &mut Reader<'_>,
    what: &str,
    example: &str,
    value: &'v Lenient<Vec<T>>,
) -> &'v [T] {
    match &value.read {
        Ok(items) => items,
        Err(found) => {
            let fault = reader.wrong_type(what, words().a_list(), found, &value.span);
            reader.report(fault.help(words().for_example(example)));
            &[]
        }
    }
}

/// Reads a number; reports a formula of another dimension than `wanted`.
fn measured(
    reader: &mut Reader<'_>,
    what: &str,
    value: &Lenient<f64>,
    wanted: Option<Dimension>,
) -> Option<f64> {
    let number = reader.number(what, value)?;
    let (Some(wanted), Err(Misplaced::Text(formula))) = (wanted, &value.read) else {
        return Some(number);
    };
    let worth = reader.worked_out(what, formula, &value.span)?;
    match worth.dimension {
        Some(found) if !found.adds_to(wanted) => {
            let length = reader.named.length.0;
            let message =
                words().value_measures_other(what, &found.symbol(length), &wanted.symbol(length));
            reader.report(Diagnostic::new(message).at(value.span.clone(), ""));
            None
        }
        _ => Some(number),
    }
}

/// Reads the numbers of a list; returns `None` if one of them is invalid.
fn numbers(
    reader: &mut Reader<'_>,
    key: &str,
    value: &NumberList,
    measure: Option<Dimension>,
) -> Option<Vec<f64>> {
    let what = format!("`{key}`");
    let items = list(reader, &what, "[0, 30, 60]", value);
    let read: Vec<Option<f64>> = items
        .iter()
        .map(|item| measured(reader, &what, item, measure))
        .collect();
    read.into_iter().collect()
}

/// Reads rows of `N` numbers with their places, each number with its own dimension. Returns `None`
/// if one of them is invalid.
fn rows<const N: usize>(
    reader: &mut Reader<'_>,
    key: &str,
    (form, example): (&str, &str),
    measures: [Option<Dimension>; N],
    value: &RowList,
) -> Option<Vec<([f64; N], ByteSpan)>> {
    let items = list(reader, &format!("`{key}`"), &format!("[{example}]"), value);
    let before = reader.found.len();
    let mut rows = Vec::new();
    for (number, item) in (1..).zip(items) {
        let what = words().item_of(number, key);
        let parts = list(reader, &what, example, item);
        if item.get().is_some() && parts.len() != N {
            reader.report(
                Diagnostic::new(words().must_be_row(&what, form, parts.len()))
                    .at(item.span.clone(), words().expected(form))
                    .help(words().for_example(example)),
            );
            continue;
        }
        let read: Vec<f64> = parts
            .iter()
            .zip(measures)
            .filter_map(|(part, measure)| measured(reader, &what, part, measure))
            .collect();
        if let Ok(row) = <[f64; N]>::try_from(read) {
            rows.push((row, item.span.clone()));
        }
    }
    (reader.found.len() == before).then_some(rows)
}

/// Reads points with their places; returns an empty list if the key is missing.
fn points(
    reader: &mut Reader<'_>,
    key: &str,
    value: Option<&RowList>,
) -> Option<Vec<(Vec2, ByteSpan)>> {
    let Some(value) = value else {
        return Some(Vec::new());
    };
    let form = ("[x, y]", "[20, 35]");
    let rows = rows(reader, key, form, [Some(Dimension::LENGTH); 2], value)?;
    let point = |([x, y], place): ([f64; 2], ByteSpan)| (Vec2::new(x, y), place);
    Some(rows.into_iter().map(point).collect())
}

/// Reports a missing key, and returns `None`.
fn lacks<T>(reader: &mut Reader<'_>, kind: &str, key: &str, example: &str) -> Option<T> {
    reader
        .report(Diagnostic::new(words().task_lacks(kind, key)).help(words().for_example(example)));
    None
}

/// Reports two equal places.
fn same_twice(
    reader: &mut Reader<'_>,
    first: (usize, &ByteSpan),
    again: (usize, &ByteSpan),
    help: &str,
) {
    reader.report(
        Diagnostic::new(words().told_twice(first.0 + 1, again.0 + 1))
            .at(again.1.clone(), words().the_same_again())
            .and(first.1.clone(), words().first_told_here())
            .help(help),
    );
}

/// Formats a name for a message.
fn named(text: &str, span: &ByteSpan) -> String {
    Name {
        text,
        span: span.clone(),
    }
    .to_string()
}

#[cfg(test)]
mod tests;
