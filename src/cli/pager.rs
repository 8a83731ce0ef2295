//! A long text, a screen at a time.

use super::failure::Failure;
use super::output::write_text;
use super::screen::Screen;

/// Shows a text in the person's pager; where nobody reads, or no pager is there, it is written as it is.
pub(super) fn show(text: &str, screen: Screen) -> Result<(), Failure> {
    if screen.redraws {
        // Whatever keeps a pager from it, the text is still to be seen.
        let _ = become_pager(text);
    }
    write_text(None, text)
}

/// krank becomes the pager, so that nobody else hears Ctrl-C; comes back where none could be started.
#[cfg(unix)]
fn become_pager(text: &str) -> std::io::Result<()> {
    use std::os::unix::process::CommandExt;
    use std::process::Command;
    let input = unnamed(text)?;
    for pager in pagers(std::env::var("PAGER").ok()) {
        let mut words = pager.split_whitespace();
        let Some(program) = words.next() else {
            return Ok(());
        };
        let mut command = Command::new(program);
        if std::env::var_os("LESS").is_none() {
            // What fits the screen is not paged and stays there, and bold is bold.
            command.env("LESS", "FRX");
        }
        let _ = command.args(words).stdin(input.try_clone()?).exec();
    }
    Ok(())
}

#[cfg(not(unix))]
fn become_pager(_: &str) -> std::io::Result<()> {
    Ok(())
}

/// What is tried, one after the other: an empty `PAGER` asks for none.
#[cfg(unix)]
fn pagers(chosen: Option<String>) -> Vec<String> {
    let usual = ["less -R", "more"].map(str::to_owned);
    match chosen {
        Some(chosen) if chosen.trim().is_empty() => Vec::new(),
        chosen => chosen.into_iter().chain(usual).collect(),
    }
}

/// The text in a file without a name, read from its beginning: a pipe would hold only so much of it before
/// somebody reads.
#[cfg(unix)]
fn unnamed(text: &str) -> std::io::Result<std::fs::File> {
    use std::io::{Seek, Write};
    let path = std::env::temp_dir().join(format!("krank-help-{}", std::process::id()));
    let mut options = std::fs::OpenOptions::new();
    let mut file = options
        .read(true)
        .write(true)
        .create_new(true)
        .open(&path)?;
    std::fs::remove_file(&path)?;
    file.write_all(text.as_bytes())?;
    file.rewind()?;
    Ok(file)
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn the_chosen_pager_comes_first_and_an_empty_one_is_none() {
        assert_eq!(pagers(None), ["less -R", "more"]);
        assert_eq!(pagers(Some("most".into())), ["most", "less -R", "more"]);
        assert!(pagers(Some(" ".into())).is_empty());
    }

    #[test]
    fn a_text_is_read_back_whole() {
        use std::io::Read;
        let text = "a line\n".repeat(100_000);
        let mut back = String::new();
        unnamed(&text).unwrap().read_to_string(&mut back).unwrap();
        assert_eq!(back, text);
    }
}
