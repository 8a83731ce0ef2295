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
mod keys;
mod kinds;
mod preferences;

pub use examples::ExampleTask;

use crate::Vec2;
use crate::document::{self, ByteSpan, Diagnostic, Diagnostics, DocumentKind, Entries, Reader};
use crate::nearest::did_you_mean;
use crate::scene::{self, KeyTable, MAX_FILE_SIZE, Measure, Unit};
use crate::synthesis::{Task, TaskKind};
use crate::wording::words;

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
}

impl TaskFile {
    /// Returns the display title; titles of built-in tasks are translated.
    #[must_use]
    pub fn title(&self) -> String {
        words().translated_scene_text(&self.name)
    }

    /// Returns `true` if a file is a task: it has a `kind`, which no scene has.
    #[must_use]
    pub fn is_task(bytes: &[u8]) -> bool {
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
        TaskFile::parse(document::utf8_text(bytes, origin)?, origin)
    }

    /// Parses a task; `origin` is the name of the file in messages.
    ///
    /// # Errors
    /// Returns all faults found, with their places.
    pub fn parse(text: &str, origin: &str) -> Result<TaskFile, Diagnostics> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut reader = Reader::new(text, DocumentKind::Task);
        let root = document::parse(&mut reader, scene::fix);
        let file = root.and_then(|root| task_file(&mut reader, &root, origin));
        match file {
            Some(file) if reader.found.is_empty() => Ok(file),
            _ => Err(reader.into_diagnostics(origin)),
        }
    }
}

fn task_file(reader: &mut Reader<'_>, root: &Entries<'_>, origin: &str) -> Option<TaskFile> {
    let file = &KeyTable::root(words().the_task_itself(), keys::TASK, root);
    if let (false, Some(links)) = (file.has("kind"), scene_part(root)) {
        let fault = Diagnostic::new(words().scene_for_a_task());
        reader.report(fault.at(links, "").help(words().synthesize_reads_tasks()));
        return None;
    }
    reader.only_known(file);
    let name = scene::line(reader, "name", file.get("name"));
    let source = scene::line(reader, "source", file.get("source"));
    let note = scene::line(reader, "note", file.get("note"));
    let unit = scene::unit(reader, file.get("unit"));
    reader.named.length = (unit.symbol(), unit.tenths_of_mm());
    let preferences = preferences::read_preferences(reader, file);
    let (four_bars, slider_cranks) = linkages(reader, file);
    let kind = kind(reader, file)?;
    if let Some(linkages) = file.get("linkages") {
        match kind {
            WrittenKind::Function if four_bars && slider_cranks => {
                reader.report(Diagnostic::new(words().one_output()).at(linkages.span(), ""));
            }
            WrittenKind::Poses | WrittenKind::Path if slider_cranks && !four_bars => {
                kinds::slider_cranks_have_one_pivot(reader, file, &linkages.span());
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
        preferences: preferences.for_motion(),
    };
    preferences.agree_with(reader, &task, file);
    Some(TaskFile {
        name: name.unwrap_or_else(|| scene::stem(origin)),
        source,
        note,
        unit,
        task,
    })
}

/// Returns the place of a key that only scenes have.
fn scene_part(root: &Entries<'_>) -> Option<ByteSpan> {
    let mut parts = ["links", "slides"].into_iter();
    parts.find_map(|key| Some(root.get_key_value(key)?.0.span()))
}

/// Reads the kind of the task; reports keys of other kinds.
fn kind(reader: &mut Reader<'_>, file: &KeyTable<'_>) -> Option<WrittenKind> {
    let names = WrittenKind::ALL.map(WrittenKind::name);
    if !file.has("kind") {
        reader.report(
            Diagnostic::new(words().task_without_kind())
                .help(words().for_example("kind = \"poses\""))
                .help(words().these_are_known(&names.join("`, `"))),
        );
        return None;
    }
    let written = reader.text_of(file, "kind")?;
    let mut kinds = WrittenKind::ALL.into_iter();
    let Some(kind) = kinds.find(|kind| kind.name() == written.text) else {
        let near = did_you_mean(written.text, names);
        let help = near.unwrap_or_else(|| words().these_are_known(&names.join("`, `")));
        reader.report(
            Diagnostic::new(words().no_kind_of_task(&written.to_string()))
                .at(written.span, words().not_known_here())
                .help(help),
        );
        return None;
    };
    for key in file.strays(kind.name()) {
        let own = keys::of_kind(kind.name()).join("`, `");
        reader.report(
            Diagnostic::new(words().key_of_another_kind(key.text, kind.name()))
                .at(key.span, words().belongs_to_another_kind())
                .help(words().known_keys(&format!("`{own}`"))),
        );
    }
    Some(kind)
}

/// Reads the linkages to search, as flags for four-bars and slider-cranks; the default is four-bars
/// only.
fn linkages(reader: &mut Reader<'_>, file: &KeyTable<'_>) -> (bool, bool) {
    const FORMS: [&str; 2] = ["four-bar", "slider-crank"];
    let Some(written) = file.get("linkages") else {
        return (true, false);
    };
    let mut found = [false; 2];
    for form in reader
        .list("`linkages`", words().a_list(), "[\"four-bar\"]", written)
        .unwrap_or_default()
    {
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
                .at(written.span(), "")
                .help(words().for_example("linkages = [\"four-bar\"]")),
        );
    }
    (found[0], found[1])
}

/// Reads the numbers of a list; returns `None` if one of them is invalid.
fn numbers(reader: &mut Reader<'_>, file: &KeyTable<'_>, key: &str) -> Option<Vec<f64>> {
    let what = format!("`{key}`");
    let measure = file.measure(key);
    let items = reader
        .list(&what, words().a_list(), "[0, 30, 60]", file.get(key)?)
        .unwrap_or_default();
    let read: Vec<Option<f64>> = items
        .iter()
        .map(|item| reader.in_units(&what, measure, item))
        .collect();
    read.into_iter().collect()
}

/// Reads rows of `N` numbers with their places, each number with its own measure. Returns `None`
/// if one of them is invalid.
fn rows<const N: usize>(
    reader: &mut Reader<'_>,
    file: &KeyTable<'_>,
    key: &str,
    (form, example): (&str, &str),
    measures: [Option<Measure>; N],
) -> Option<Vec<([f64; N], ByteSpan)>> {
    let (what, all) = (format!("`{key}`"), format!("[{example}]"));
    let items = reader
        .list(&what, words().a_list(), &all, file.get(key)?)
        .unwrap_or_default();
    let before = reader.found.len();
    let mut rows = Vec::new();
    for (number, item) in (1..).zip(items) {
        let what = words().item_of(number, key);
        let parts = reader.list(&what, words().a_list(), example, item);
        if let Some(parts) = parts
            && parts.len() != N
        {
            reader.report(
                Diagnostic::new(words().must_be_row(&what, form, parts.len()))
                    .at(item.span(), words().expected(form))
                    .help(words().for_example(example)),
            );
            continue;
        }
        let read: Vec<f64> = parts
            .into_iter()
            .flatten()
            .zip(measures)
            .filter_map(|(part, measure)| reader.in_units(&what, measure, part))
            .collect();
        if let Ok(row) = <[f64; N]>::try_from(read) {
            rows.push((row, item.span()));
        }
    }
    (reader.found.len() == before).then_some(rows)
}

/// Reads points with their places; returns an empty list if the key is missing.
fn points(
    reader: &mut Reader<'_>,
    file: &KeyTable<'_>,
    key: &str,
) -> Option<Vec<(Vec2, ByteSpan)>> {
    if !file.has(key) {
        return Some(Vec::new());
    }
    let form = ("[x, y]", "[20, 35]");
    let rows = rows(reader, file, key, form, [Some(Measure::Coordinate); 2])?;
    let point = |([x, y], span): ([f64; 2], ByteSpan)| (Vec2::new(x, y), span);
    Some(rows.into_iter().map(point).collect())
}

/// Reports a missing key, and returns `None`.
fn report_missing_key<T>(
    reader: &mut Reader<'_>,
    kind: &str,
    key: &str,
    example: &str,
) -> Option<T> {
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

#[cfg(test)]
mod tests;
