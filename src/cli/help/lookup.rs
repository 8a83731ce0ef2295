//! Finds the words of `krank help WORD` in the questions, topics, keys, columns and commands.

use crate::manual::{self, FoundTopic, SearchWords};
use crate::wording::{Language, words};
use clap::{Arg, Command};
use std::iter::once;

#[cfg(feature = "tui")]
use crate::tui::key_rows_about;

/// The topic with questions and answers.
const QUESTIONS: &str = "how";
/// Maximum number of lines listed for a topic.
const MAX_LINES: usize = 3;
/// Indentation of the lines of a topic, in columns.
const INDENT: usize = 4;

/// Returns a Markdown page that lists the occurrences of the words in the current language, or else in the other one.
/// `near` is a similar name. Returns `None` if the words occur in neither language.
pub(in crate::cli) fn page(
    typed: &str,
    near: Option<&str>,
    width: usize,
    krank: fn() -> Command,
) -> Option<String> {
    // Replaces control characters such as U+0085.
    let typed = typed.split_whitespace().collect::<Vec<_>>().join(" ");
    let current = Language::current_language();
    let page = [current, current.next()].into_iter().find_map(|language| {
        language.speak();
        page_in_language(&typed, near, width, krank)
    });
    current.speak();
    page
}

fn page_in_language(
    typed: &str,
    near: Option<&str>,
    width: usize,
    krank: fn() -> Command,
) -> Option<String> {
    let query = SearchWords::new(typed);
    let (heading, questions) = questions(&query);
    let sections = [
        (heading.as_str(), questions),
        (words().topics_heading(), topics(&query, width)),
        (words().keys_heading(), rows(key_rows_about(&query))),
        (words().columns_heading(), columns(&query)),
        (words().commands_heading(), rows(commands(&query, &krank()))),
    ];
    let sections = sections.into_iter().filter(|(_, text)| !text.is_empty());
    let sections = sections.map(|(heading, text)| format!("\n# {heading}\n\n{text}"));
    let sections: String = sections.collect();
    let title = match near {
        Some(near) => words().word_occurs_but_near(typed, near),
        None => words().word_occurs(typed),
    };
    (!sections.is_empty()).then(|| title + "\n" + &sections)
}

/// Returns a table with these rows; empty if there are none.
fn rows(rows: String) -> String {
    match rows.is_empty() {
        true => rows,
        false => table(&rows),
    }
}

/// Returns the title of the topic with questions, and its questions that have the words, each with its answer.
fn questions(query: &SearchWords) -> (String, String) {
    let topic = manual::find(QUESTIONS).map(|topic| topic.text(String::new));
    let topic = topic.unwrap_or_default();
    let heading = topic.lines().next().unwrap_or_default();
    let rows = topic.lines().filter(|line| line.contains("? | "));
    let mut rows: Vec<&str> = rows.filter(|row| query.are_in(&[row])).collect();
    // Questions that have the words themselves precede those with the words in the answer.
    rows.sort_by_key(|row| !query.are_in(&[row.split("? | ").next().unwrap_or(row)]));
    let rows: String = rows.into_iter().map(with_command).collect();
    let table = match rows.is_empty() {
        true => rows,
        false => format!("| | | |\n|---|---|---|\n{rows}"),
    };
    (heading.trim_start_matches("# ").to_owned(), table)
}

/// Returns a row of the questions with the command that shows its topic in place of the topic's name.
fn with_command(row: &str) -> String {
    match row.rsplit_once("| `") {
        Some((row, topic)) => format!("{row}| `{}\n", ["krank", "help", topic].join(" ")),
        None => format!("{row}\n"),
    }
}

/// Returns the topics that have the words, each with some of the lines that have them.
fn topics(query: &SearchWords, width: usize) -> String {
    let topics = query.in_topics(width.saturating_sub(INDENT)).into_iter();
    let topics = topics.filter(|found| found.topic.name != QUESTIONS);
    let topics = topics.map(|FoundTopic { topic, lines }| {
        let mut text = format!("{}: {}\n\n```text\n", topic.name, topic.description());
        for line in lines.iter().take(MAX_LINES) {
            text += &format!("{line}\n");
        }
        if let Some(more @ 1..) = lines.len().checked_sub(MAX_LINES) {
            text += &format!("{}\n", words().and_more(more));
        }
        text + "```\n"
    });
    topics.collect::<Vec<_>>().join("\n")
}

/// Returns the column names that have the words, from the topic about columns, as a sorted list.
fn columns(query: &SearchWords) -> String {
    let topic = manual::find("columns").map(|topic| topic.text(String::new));
    let topic = topic.unwrap_or_default();
    let code = topic.split('`').skip(1).step_by(2);
    let is_column = |code: &&str| code.contains('.') && !code.contains(char::is_whitespace);
    let named = code.filter(is_column).filter(|name| query.are_in(&[name]));
    let mut names: Vec<&str> = named.collect();
    names.sort_unstable();
    names.dedup();
    let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    match names.is_empty() {
        true => String::new(),
        false => names.join(", ") + "\n",
    }
}

/// Returns a row for each command that has the words in its name, its purpose or an option, with these options.
fn commands(query: &SearchWords, krank: &Command) -> String {
    let commands = once(krank).chain(krank.get_subcommands());
    let rows = commands.filter_map(|command| {
        let options = command.get_arguments().filter(|arg| is_about(arg, query));
        let options = options.filter_map(|arg| Some(format!(" `--{}`", arg.get_long()?)));
        let (name, options, about) = (
            command.get_name(),
            options.collect::<String>(),
            about(command),
        );
        let is_found = !options.is_empty() || query.are_in(&[name, &about]);
        is_found.then(|| format!("| {name}{options} | {about} |\n"))
    });
    rows.collect()
}

/// Returns `true` if the name, the help or a value of an option has the words.
fn is_about(arg: &Arg, query: &SearchWords) -> bool {
    let name = format!("--{}", arg.get_long().unwrap_or_default());
    let help = arg.get_help().map(ToString::to_string).unwrap_or_default();
    let values = arg.get_possible_values();
    let values = values.iter().map(|value| value.get_name());
    let texts: Vec<&str> = [name.as_str(), &help].into_iter().chain(values).collect();
    query.are_in(&texts)
}

/// Returns no rows, because there are no keys without the workbench.
#[cfg(not(feature = "tui"))]
fn key_rows_about(_: &SearchWords) -> String {
    String::new()
}

/// Returns a table in Markdown with these rows of two cells.
pub(in crate::cli) fn table(rows: &str) -> String {
    format!("| | |\n|---|---|\n{rows}")
}

pub(in crate::cli) fn about(command: &Command) -> String {
    command
        .get_about()
        .map(ToString::to_string)
        .unwrap_or_default()
}
