//! Determines the capabilities of the terminal behind standard error or standard output.

use crate::capability::{Colours, TerminalKind, TerminalProfile};
use crate::document::with_ascii_letters;
use std::io::{IsTerminal, stderr, stdout};

/// The capabilities for messages and text output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TextScreen {
    /// Only 7-bit characters are available.
    pub(super) ascii: bool,
    /// Colours are available.
    pub(super) colour: bool,
    /// A line can be cleared and rewritten.
    pub(super) redraws: bool,
}

impl TextScreen {
    /// Converts krank's own text to the available letters.
    pub(super) fn shown(self, text: &str) -> String {
        match self.ascii {
            true => with_ascii_letters(text),
            false => text.to_owned(),
        }
    }

    /// Detects the terminal behind standard error from the environment.
    pub(super) fn detect() -> Self {
        TextScreen::from_profile(&judgement(), stderr().is_terminal())
    }

    /// Detects the terminal behind standard output, for text to be read there.
    pub(super) fn of_results() -> Self {
        TextScreen::from_profile(&judgement(), stdout().is_terminal())
    }

    fn from_profile(judgement: &TerminalProfile, terminal: bool) -> Self {
        let kind = judgement.kind();
        TextScreen {
            // The Linux console decodes UTF-8, but its fonts lack most characters.
            ascii: !judgement.glyphs().value.is_dotted(),
            colour: terminal && judgement.colours().value != Colours::None,
            redraws: terminal && !matches!(kind, TerminalKind::Unknown | TerminalKind::Dumb),
        }
    }
}

/// Returns the terminal profile from the environment.
pub(super) fn judgement() -> TerminalProfile {
    let text = |value: std::ffi::OsString| value.to_string_lossy().into_owned();
    TerminalProfile::of(|name| std::env::var_os(name).map(text))
}

/// Returns the columns and rows of the terminal behind standard output, if known.
#[cfg(feature = "tui")]
pub(super) fn size() -> Option<(u16, u16)> {
    let text = rustix::termios::tcgetwinsize(std::io::stdout()).ok()?;
    (text.ws_col > 0 && text.ws_row > 0).then_some((text.ws_col, text.ws_row))
}

/// Returns `None`: without the workbench, krank cannot query the size.
#[cfg(not(feature = "tui"))]
pub(super) fn size() -> Option<(u16, u16)> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn screen(variables: &[(&str, &str)], terminal: bool) -> TextScreen {
        let find = |name: &str| variables.iter().find(|(n, _)| *n == name);
        let judgement = TerminalProfile::of(|name| find(name).map(|(_, v)| (*v).to_owned()));
        TextScreen::from_profile(&judgement, terminal)
    }

    #[test]
    fn an_emulator_in_a_utf_8_locale_has_everything() {
        let variables = [("LANG", "de_DE.UTF-8"), ("TERM", "xterm-256color")];
        let all = TextScreen {
            ascii: false,
            colour: true,
            redraws: true,
        };
        assert_eq!(screen(&variables, true), all);
        let piped = screen(&variables, false);
        assert!(!piped.colour && !piped.redraws);
    }

    #[test]
    fn consoles_and_the_c_locale_get_ascii() {
        for term in ["linux", "dumb", "", "vt220"] {
            let variables = [("LC_ALL", "C.utf8"), ("TERM", term)];
            assert!(screen(&variables, true).ascii, "{term}");
        }
        let c = [("LC_ALL", "C"), ("LANG", "en_US.UTF-8"), ("TERM", "xterm")];
        assert!(screen(&c, true).ascii);
        let empty = [("LC_ALL", ""), ("LANG", "en_US.UTF-8"), ("TERM", "xterm")];
        assert!(!screen(&empty, true).ascii);
        assert!(screen(&[], true).ascii);
    }

    #[test]
    fn a_terminal_without_a_cursor_that_goes_back_keeps_every_line() {
        let redraws = |term| screen(&[("TERM", term)], true).redraws;
        assert!(redraws("linux") && redraws("vt100"));
        assert!(!redraws("dumb") && !redraws(""));
        assert!(!screen(&[], true).redraws);
    }

    #[test]
    fn no_color_and_plain_terminals_get_no_colour() {
        assert!(!screen(&[("TERM", "xterm"), ("NO_COLOR", "1")], true).colour);
        assert!(screen(&[("TERM", "xterm"), ("NO_COLOR", "")], true).colour);
        assert!(!screen(&[("TERM", "dumb")], true).colour);
        assert!(screen(&[("TERM", "linux")], true).colour);
    }
}
