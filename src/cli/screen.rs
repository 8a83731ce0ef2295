//! What a terminal can show: the one behind standard error, or behind standard output.

use crate::capability::{Colours, Judgement, TerminalKind};
use crate::document::with_ascii_letters;
use std::io::{IsTerminal, stderr, stdout};

/// What messages and texts to be read may use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TextScreen {
    /// 7-bit characters only.
    pub(super) ascii: bool,
    /// Colours.
    pub(super) colour: bool,
    /// A line can be cleared and written again.
    pub(super) redraws: bool,
}

impl TextScreen {
    /// Our own text as it is shown there.
    pub(super) fn shown(self, text: &str) -> String {
        match self.ascii {
            true => with_ascii_letters(text),
            false => text.to_owned(),
        }
    }

    /// As the environment says.
    pub(super) fn detect() -> Self {
        TextScreen::judge(&judgement(), stderr().is_terminal())
    }

    /// The same of the terminal behind standard output, for what is read there.
    pub(super) fn of_results() -> Self {
        TextScreen::judge(&judgement(), stdout().is_terminal())
    }

    fn judge(judgement: &Judgement, terminal: bool) -> Self {
        let kind = judgement.kind();
        TextScreen {
            // The Linux console speaks UTF-8, but its fonts lack most of it.
            ascii: !judgement.glyphs().value.is_dotted(),
            colour: terminal && judgement.colours().value != Colours::None,
            redraws: terminal && !matches!(kind, TerminalKind::Unknown | TerminalKind::Dumb),
        }
    }
}

/// What the environment says of the terminal.
pub(super) fn judgement() -> Judgement {
    let text = |value: std::ffi::OsString| value.to_string_lossy().into_owned();
    Judgement::of(|name| std::env::var_os(name).map(text))
}

/// The columns and rows of the terminal behind standard output, if there is one that tells them.
#[cfg(feature = "tui")]
pub(super) fn size() -> Option<(u16, u16)> {
    let told = rustix::termios::tcgetwinsize(std::io::stdout()).ok()?;
    (told.ws_col > 0 && told.ws_row > 0).then_some((told.ws_col, told.ws_row))
}

/// Without the workbench krank does not know how to ask.
#[cfg(not(feature = "tui"))]
pub(super) fn size() -> Option<(u16, u16)> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn screen(variables: &[(&str, &str)], terminal: bool) -> TextScreen {
        let find = |name: &str| variables.iter().find(|(n, _)| *n == name);
        let judgement = Judgement::of(|name| find(name).map(|(_, v)| (*v).to_owned()));
        TextScreen::judge(&judgement, terminal)
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
