//! Shows a long text in a pager.

use crate::cli::failure::Failure;
use crate::cli::output::write_text;
use crate::cli::screen::TextScreen;

/// Shows a text in the user's pager. Without a terminal or a pager, writes it to standard output.
pub(in crate::cli) fn show(text: &str, screen: TextScreen) -> Result<(), Failure> {
    if screen.redraws {
        // If the pager fails, the text is still written.
        let _ = become_pager(text);
    }
    write_text(None, text)
}

/// The standard path of the shell on POSIX systems.
#[cfg(unix)]
const SHELL: &str = "/bin/sh";
/// Tries each pager until one exists, or else writes the text in the shell. Ctrl-C is left to the
/// pager: the shells must not end before it and leave it with a terminal that another program reads.
#[cfg(unix)]
const SCRIPT: &str = r#"
trap : INT
for pager in "$@"; do
    "$0" -c "trap : INT
$pager"
    case $? in 126 | 127) ;; *) exit 0 ;; esac
done
while IFS= read -r line; do printf '%s\n' "$line"; done
"#;
/// The pager if the user has chosen none.
#[cfg(unix)]
const DEFAULT_PAGER: &str = "if command -v less >/dev/null; then less; else more; fi";

/// Replaces the process by a shell that shows the text in a pager. Returns if the user wants no
/// pager or if there is no shell.
#[cfg(unix)]
fn become_pager(text: &str) -> std::io::Result<()> {
    use std::os::unix::process::CommandExt;
    let chosen = std::env::var_os("PAGER");
    if chosen.as_ref().is_some_and(|pager| is_blank(pager)) {
        return Ok(());
    }
    let mut shell = std::process::Command::new(SHELL);
    shell
        .args(["-c", SCRIPT, SHELL])
        .args(chosen)
        .arg(DEFAULT_PAGER);
    shell.env("LESS", options_of_less(std::env::var_os("LESS")));
    Err(shell.stdin(unnamed(&std::env::temp_dir(), text)?).exec())
}

#[cfg(not(unix))]
fn become_pager(_: &str) -> std::io::Result<()> {
    Ok(())
}

/// Returns `true` for an empty `PAGER`, which means no pager.
#[cfg(unix)]
fn is_blank(pager: &std::ffi::OsStr) -> bool {
    pager.to_string_lossy().trim().is_empty()
}

/// Returns the options for `less`: `-R` shows bold text, in addition to the user's options. Without
/// the user's options, text that fits the screen is not paged and stays there.
#[cfg(unix)]
fn options_of_less(chosen: Option<std::ffi::OsString>) -> std::ffi::OsString {
    let Some(chosen) = chosen else {
        return "FRX".into();
    };
    let mut options = std::ffi::OsString::from("-R ");
    options.push(chosen);
    options
}

/// Maximum number of file names to try: a process with the same number may have left one.
#[cfg(unix)]
const NAMES: u32 = 100;

/// Returns the text in an unlinked temporary file, positioned at its start. A pipe would have a
/// limited capacity without a reader.
#[cfg(unix)]
fn unnamed(folder: &std::path::Path, text: &str) -> std::io::Result<std::fs::File> {
    use std::io::{Error, ErrorKind, Seek, Write};
    let mut options = std::fs::OpenOptions::new();
    options.read(true).write(true).create_new(true);
    let opened = (0..NAMES).find_map(|number| {
        let path = folder.join(format!("krank-help-{}-{number}", std::process::id()));
        match options.open(&path) {
            Err(taken) if taken.kind() == ErrorKind::AlreadyExists => None,
            opened => Some(opened.map(|file| (file, path))),
        }
    });
    let (mut file, path) = opened.unwrap_or_else(|| Err(Error::from(ErrorKind::AlreadyExists)))?;
    std::fs::remove_file(&path)?;
    file.write_all(text.as_bytes())?;
    file.rewind()?;
    Ok(file)
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn an_empty_pager_is_none() {
        assert!(is_blank(" ".as_ref()) && is_blank("".as_ref()));
        assert!(!is_blank("most".as_ref()));
    }

    #[test]
    fn less_shows_bold_and_what_else_was_chosen() {
        assert_eq!(options_of_less(None), "FRX");
        assert_eq!(options_of_less(Some("-i".into())), "-R -i");
        assert_eq!(
            options_of_less(Some("-Pq to leave".into())),
            "-R -Pq to leave"
        );
    }

    /// A file that somebody has left used to end paging for good.
    #[test]
    fn a_text_is_read_back_whole_whatever_names_are_taken() {
        use std::io::Read;
        let id = std::process::id();
        let folder = std::env::temp_dir().join(format!("krank-pager-{id}"));
        std::fs::create_dir_all(&folder).unwrap();
        for number in 0..2 {
            std::fs::write(folder.join(format!("krank-help-{id}-{number}")), "left").unwrap();
        }
        let text = "a line\n".repeat(100_000);
        let mut back = String::new();
        let mut file = unnamed(&folder, &text).unwrap();
        file.read_to_string(&mut back).unwrap();
        assert_eq!(back, text);
        assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 2);
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
