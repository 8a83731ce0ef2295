//! Writes manual pages.

use crate::cli::failure::Failure;
use crate::cli::output::write_text;
use crate::cli::screen::TextScreen;
use crate::wording::words;
use clap::Command;

/// Runs `krank man`: prints the manual page of krank or of one of its commands.
pub(in crate::cli) fn man(
    krank: &mut Command,
    command: Option<&str>,
    screen: TextScreen,
) -> Result<(), Failure> {
    krank.build();
    let page = match command {
        None => krank.clone(),
        Some(name) => page_of(krank, name)?,
    };
    let mut roff = Vec::new();
    let rendered = clap_mangen::Man::new(page).render(&mut roff);
    rendered.map_err(|e| Failure::Output(None, e))?;
    write_text(None, &screen.shown(&String::from_utf8_lossy(&roff)))
}

fn page_of(krank: &Command, name: &str) -> Result<Command, Failure> {
    match krank.find_subcommand(name) {
        Some(command) => Ok(command.clone()),
        None => Err(Failure::Usage(words().krank_has_no_command(name))),
    }
}
