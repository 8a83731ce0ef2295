//! Detects the picture protocol of a terminal from the environment.

use super::{Detected, TerminalKind, TerminalProfile, found};
use crate::wording::words;

/// A terminal protocol for pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureProtocol {
    /// The kitty graphics protocol.
    Kitty,
    /// The inline images protocol of iTerm2.
    Iterm,
    /// Sixels, as in the VT340.
    Sixel,
}

/// The selection of a picture protocol.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PictureChoice {
    /// The protocol detected from the environment.
    #[default]
    Auto,
    /// The given protocol.
    By(PictureProtocol),
    /// Pictures are disabled.
    Never,
}

impl PictureChoice {
    /// All selections.
    pub const ALL: [PictureChoice; 5] = [
        PictureChoice::Auto,
        PictureChoice::By(PictureProtocol::Kitty),
        PictureChoice::By(PictureProtocol::Iterm),
        PictureChoice::By(PictureProtocol::Sixel),
        PictureChoice::Never,
    ];

    /// Returns the name in options and in the configuration.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            PictureChoice::Auto => "auto",
            PictureChoice::By(PictureProtocol::Kitty) => "kitty",
            PictureChoice::By(PictureProtocol::Iterm) => "iterm",
            PictureChoice::By(PictureProtocol::Sixel) => "sixel",
            PictureChoice::Never => "none",
        }
    }
}

/// Prefixes of TERM and TERM_PROGRAM that identify emulators with pictures.
const TERMS: [(&str, PictureProtocol); 6] = [
    ("xterm-kitty", PictureProtocol::Kitty),
    ("xterm-ghostty", PictureProtocol::Kitty),
    ("foot", PictureProtocol::Sixel),
    ("mlterm", PictureProtocol::Sixel),
    ("contour", PictureProtocol::Sixel),
    ("wezterm", PictureProtocol::Iterm),
];
const PROGRAMS: [(&str, PictureProtocol); 5] = [
    ("iTerm", PictureProtocol::Iterm),
    ("WezTerm", PictureProtocol::Iterm),
    ("ghostty", PictureProtocol::Kitty),
    ("kitty", PictureProtocol::Kitty),
    ("mintty", PictureProtocol::Sixel),
];

impl TerminalProfile {
    /// Returns the picture protocol: the selected one, or the one detected with certainty.
    pub(crate) fn pictures(&self, requested: PictureChoice) -> Detected<Option<PictureProtocol>> {
        match cfg!(feature = "pictures") {
            true => self.image_protocol(requested),
            false => found(None, words().no_pictures()),
        }
    }

    fn image_protocol(&self, requested: PictureChoice) -> Detected<Option<PictureProtocol>> {
        match requested {
            PictureChoice::By(protocol) => found(Some(protocol), words().pictures_asked_for()),
            PictureChoice::Never => found(None, words().pictures_unwanted()),
            PictureChoice::Auto => self.pictures_of_terminal(),
        }
    }

    fn pictures_of_terminal(&self) -> Detected<Option<PictureProtocol>> {
        let term = &self.term;
        if self.kind() != TerminalKind::Emulator {
            return found(None, words().no_pictures_there(term));
        }
        // A multiplexer may pass on variables of another session's terminal.
        let multiplexed = ["screen", "tmux"].iter().any(|m| term.starts_with(m));
        if self.multiplexed || multiplexed {
            return found(None, words().pictures_behind_multiplexer());
        }
        if let Some((_, protocol)) = TERMS.iter().find(|(start, _)| term.starts_with(start)) {
            return found(Some(*protocol), format!("TERM={term}"));
        }
        let program = self.program.as_deref().unwrap_or_default();
        if let Some((_, protocol)) = PROGRAMS
            .iter()
            .find(|(start, _)| program.starts_with(start))
        {
            return found(Some(*protocol), format!("TERM_PROGRAM={program}"));
        }
        found(None, words().pictures_unknown(term))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn detect_protocol(
        environment: &[(&str, &str)],
        requested: PictureChoice,
    ) -> Option<PictureProtocol> {
        let judgement = TerminalProfile::of(|name| {
            let found = environment.iter().find(|(n, _)| *n == name);
            found.map(|(_, value)| (*value).to_owned())
        });
        judgement.image_protocol(requested).value
    }

    /// A terminal without the protocol shows an image as pages of letters.
    #[test]
    fn images_need_certain_environment_or_request() {
        use PictureProtocol::{Iterm, Kitty, Sixel};
        let xterm = ("TERM", "xterm-256color");
        for (environment, protocol) in [
            (&[("TERM", "xterm-kitty")][..], Some(Kitty)),
            // An xterm started from kitty inherits its variables.
            (&[xterm, ("KITTY_WINDOW_ID", "1")], None),
            (&[("TERM", "xterm-kitty"), ("ZELLIJ", "0")], None),
            (&[xterm, ("TERM_PROGRAM", "iTerm.app")], Some(Iterm)),
            (&[("TERM", "foot-extra")], Some(Sixel)),
            (&[xterm], None),
            (&[("TERM", "linux"), ("KITTY_WINDOW_ID", "1")], None),
            (&[("TERM", "tmux-256color"), ("KITTY_WINDOW_ID", "1")], None),
            (&[("TERM", "xterm-kitty"), ("TMUX", "/tmp/tmux")], None),
            (&[], None),
        ] {
            let of = |requested| detect_protocol(environment, requested);
            assert_eq!(of(PictureChoice::Auto), protocol, "{environment:?}");
            assert_eq!(of(PictureChoice::By(Sixel)), Some(Sixel));
            assert_eq!(of(PictureChoice::Never), None);
        }
    }
}
