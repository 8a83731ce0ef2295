//! `krank help`: shows the manual's topics and the help of commands.

use super::args::{Cli, HelpArgs, HelpFormat};
use super::failure::Failure;
use super::lookup;
use super::output::write_text;
use super::pager;
use super::screen::{TextScreen, size};
use crate::manual::{self, LineKind, TOPICS, Topic};
use crate::nearest::nearest;
#[cfg(feature = "tui")]
use crate::tui::key_rows;
use crate::wording::words;
use clap::{Command, CommandFactory};
use std::path::Path;

/// Width in columns if the terminal reports none.
const USUAL_WIDTH: usize = 80;

/// Shows a topic or a command's help, lists both, or writes the manual as a web site.
pub(super) fn help(args: &HelpArgs) -> Result<(), Failure> {
    match (args.format, &args.output, &args.topic) {
        (HelpFormat::Text, None, _) => show(args),
        (HelpFormat::Text, Some(_), _) => Err(Failure::Usage(words().folder_needs_html().into())),
        (HelpFormat::Html, _, Some(word)) => Err(Failure::Usage(words().html_has_all_topics(word))),
        (HelpFormat::Html, None, None) => Err(Failure::Usage(words().html_needs_folder().into())),
        (HelpFormat::Html, Some(folder), None) => write_site(folder),
    }
}

/// Writes the files of the web site and creates their folder if necessary.
fn write_site(folder: &Path) -> Result<(), Failure> {
    let unwritable = |e| Failure::Output(Some(folder.to_owned()), e);
    std::fs::create_dir_all(folder).map_err(unwritable)?;
    for (name, text) in manual::site(key_rows) {
        write_text(Some(&folder.join(name)), &text)?;
    }
    Ok(())
}

fn show(args: &HelpArgs) -> Result<(), Failure> {
    let screen = TextScreen::of_results();
    let text = match args.topic.as_deref() {
        None => laid_out(&contents(), screen),
        Some(word) => match manual::find(word) {
            Some(topic) => laid_out(&topic.text(key_rows), screen),
            None => of_word(word, screen)?,
        },
    };
    let text = screen.shown(&text);
    match args.no_pager {
        true => write_text(None, &text),
        false => pager::show(&text, screen),
    }
}

/// Wraps a text to the terminal's width, with bold headings if it has colours.
fn laid_out(text: &str, screen: TextScreen) -> String {
    let lines = manual::lines(text, width()).into_iter();
    let shown = lines.map(|line| match line.kind {
        LineKind::Title if screen.colour => format!("\x1b[1m{}\x1b[0m\n", line.text),
        LineKind::Title | LineKind::Words | LineKind::Code => line.text + "\n",
    });
    shown.collect()
}

fn width() -> usize {
    size().map_or(USUAL_WIDTH, |(columns, _)| columns.into())
}

/// Returns the list of topics and commands.
fn contents() -> String {
    let rows = |rows: Vec<(&str, String)>| -> String {
        let rows = rows.into_iter();
        let rows = rows.map(|(name, about)| format!("| {name} | {about} |\n"));
        table(&rows.collect::<String>())
    };
    let topics = TOPICS.iter().map(|topic| (topic.name, topic.told()));
    let krank = Cli::command();
    let commands = krank.get_subcommands().filter(|c| !c.is_hide_set());
    let commands = commands.map(|c| (c.get_name(), about(c)));
    format!(
        "# {}\n\n{}\n# {}\n\n{}\n{}\n",
        words().topics_heading(),
        rows(topics.collect()),
        words().commands_heading(),
        rows(commands.collect()),
        words().help_of_workbench(),
    )
}

/// Returns a table in Markdown with these rows of two cells.
pub(super) fn table(rows: &str) -> String {
    format!("| | |\n|---|---|\n{rows}")
}

pub(super) fn about(command: &Command) -> String {
    command
        .get_about()
        .map(ToString::to_string)
        .unwrap_or_default()
}

/// Returns a command's help as its `--help` shows it, or the places where another word occurs.
fn of_word(word: &str, screen: TextScreen) -> Result<String, Failure> {
    let mut krank = Cli::command();
    krank.build();
    if let Some(command) = krank.find_subcommand_mut(word) {
        return Ok(words().of_parser(&command.render_long_help().to_string()));
    }
    let topics: Vec<&str> = TOPICS.iter().map(|topic: &Topic| topic.name).collect();
    let commands = krank.get_subcommands().map(Command::get_name);
    let others: Vec<&str> = manual::names_of_language().collect();
    let near = nearest(word, topics.iter().copied().chain(commands).chain(others));
    match lookup::page(word, near, width()) {
        Some(page) => Ok(laid_out(&page, screen)),
        None => Err(unknown(word, near, &topics.join(", "))),
    }
}

fn unknown(word: &str, near: Option<&str>, topics: &str) -> Failure {
    Failure::Usage(match near {
        Some(near) => words().no_topic_but_near(word, near, topics),
        None => words().no_topic_and_no_command(word, topics),
    })
}

/// Returns no rows: without the workbench there are no keys.
#[cfg(not(feature = "tui"))]
fn key_rows() -> String {
    String::new()
}
