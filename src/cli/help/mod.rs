//! `krank help`: shows the manual's topics and the help of commands.

pub(super) mod completions;
mod lookup;
pub(super) mod man;
pub(super) mod misuse;
mod pager;
pub(super) mod version;

use crate::cli::failure::Failure;
use crate::cli::output::write_text;
use crate::cli::screen::{TextScreen, size};
use crate::manual::{self, LineKind, TOPICS, Topic};
use crate::nearest::nearest;
use crate::wording::words;
use clap::{Args, Command, ValueEnum, ValueHint};
use lookup::{about, table};
use std::path::{Path, PathBuf};

#[cfg(feature = "tui")]
use crate::tui::key_rows;

#[derive(Debug, Args)]
pub(in crate::cli) struct HelpArgs {
    #[arg(help = words().topic_or_command())]
    topic: Option<String>,
    #[arg(help = words().write_at_once())]
    #[arg(long)]
    no_pager: bool,
    #[arg(help = words().how_to_write())]
    #[arg(long, value_enum, default_value_t = HelpFormat::Text)]
    format: HelpFormat,
    #[arg(help = words().folder_of_manual())]
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum HelpFormat {
    #[value(help = words().format_for_person())]
    Text,
    #[value(help = words().format_web())]
    Html,
}

/// Width in columns if the terminal reports none.
const DEFAULT_WIDTH: usize = 80;

/// Shows a topic or a command's help, lists both, or writes the manual as a web site.
pub(in crate::cli) fn help(args: &HelpArgs, krank: fn() -> Command) -> Result<(), Failure> {
    match (args.format, &args.output, &args.topic) {
        (HelpFormat::Text, None, _) => show(args, krank),
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

fn show(args: &HelpArgs, krank: fn() -> Command) -> Result<(), Failure> {
    let screen = TextScreen::of_results();
    let text = match args.topic.as_deref() {
        None => wrap_help(&contents(&krank()), screen),
        Some(word) => match manual::find(word) {
            Some(topic) => wrap_help(&topic.text(key_rows), screen),
            None => of_word(word, krank, screen)?,
        },
    };
    let text = screen.shown(&text);
    match args.no_pager {
        true => write_text(None, &text),
        false => pager::show(&text, screen),
    }
}

/// Wraps a text to the terminal's width, with bold headings if it has colours.
fn wrap_help(text: &str, screen: TextScreen) -> String {
    let lines = manual::lines(text, width()).into_iter();
    let shown = lines.map(|line| match line.kind {
        LineKind::Title if screen.colour => format!("\x1b[1m{}\x1b[0m\n", line.text),
        LineKind::Title | LineKind::Words | LineKind::Code => line.text + "\n",
    });
    shown.collect()
}

fn width() -> usize {
    size().map_or(DEFAULT_WIDTH, |(columns, _)| columns.into())
}

/// Returns the list of topics and commands.
fn contents(krank: &Command) -> String {
    let rows = |rows: Vec<(&str, String)>| -> String {
        let rows = rows.into_iter();
        let rows = rows.map(|(name, about)| format!("| {name} | {about} |\n"));
        table(&rows.collect::<String>())
    };
    let topics = TOPICS.iter().map(|topic| (topic.name, topic.description()));
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

/// Returns a command's help as its `--help` shows it, or the places where another word occurs.
fn of_word(word: &str, krank: fn() -> Command, screen: TextScreen) -> Result<String, Failure> {
    let mut built = krank();
    built.build();
    if let Some(command) = built.find_subcommand_mut(word) {
        return Ok(words().of_parser(&command.render_long_help().to_string()));
    }
    let topics: Vec<&str> = TOPICS.iter().map(|topic: &Topic| topic.name).collect();
    let commands = built.get_subcommands().map(Command::get_name);
    let others: Vec<&str> = manual::names_of_language().collect();
    let near = nearest(word, topics.iter().copied().chain(commands).chain(others));
    match lookup::page(word, near, width(), krank) {
        Some(page) => Ok(wrap_help(&page, screen)),
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
