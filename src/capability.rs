//! Detects the capabilities of a terminal from the environment alone, for the workbench and for
//! messages. The terminal itself is not queried: many never answer, and a slow one answers into the
//! shell.

#[cfg(feature = "tui")]
mod picture_protocol;

#[cfg(feature = "tui")]
pub use picture_protocol::{PictureChoice, PictureProtocol};

use crate::drawing::Glyphs;
use crate::wording::words;

/// The colours that may be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Colours {
    /// Monochrome, with bold and reverse.
    None,
    /// The 16 colours of the terminal's own palette.
    Sixteen,
    /// The fixed palette of 256 colours.
    Indexed,
    /// All colours (24 bits).
    True,
}

impl Colours {
    /// All sets of colours, the smallest one first.
    pub(crate) const ALL: [Colours; 4] = [
        Colours::None,
        Colours::Sixteen,
        Colours::Indexed,
        Colours::True,
    ];

    /// Returns the name in options and in the configuration.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Colours::None => "none",
            Colours::Sixteen => "16",
            Colours::Indexed => "256",
            Colours::True => "true",
        }
    }

    /// Returns the next larger set of colours; the largest is followed by none.
    #[must_use]
    pub(crate) fn next(self) -> Self {
        match self {
            Colours::None => Colours::Sixteen,
            Colours::Sixteen => Colours::Indexed,
            Colours::Indexed => Colours::True,
            Colours::True => Colours::None,
        }
    }
}

/// The capabilities of a terminal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Capability {
    /// The safe characters.
    pub(crate) glyphs: Glyphs,
    /// The safe colours.
    pub(crate) colours: Colours,
    /// `true` for emulators that ignore unknown private modes; only these use synchronized output
    /// and bracketed paste.
    pub(crate) modern: bool,
}

/// The kind of a terminal according to TERM.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TerminalKind {
    /// TERM is not set or names no terminal.
    Unknown,
    /// A terminal without cursor addressing.
    Dumb,
    /// A hardware terminal, or one with similar capabilities.
    Old,
    /// The Linux console: UTF-8, but fonts with few characters.
    Console,
    /// A terminal emulator in a window.
    Emulator,
}

/// The variables of the locale, in the order of precedence of POSIX.
const LOCALE: [&str; 3] = ["LC_ALL", "LC_CTYPE", "LANG"];

/// The environment's variables about the terminal, from which its capabilities are detected.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct TerminalProfile {
    term: String,
    /// The decisive variable and its value.
    locale: Option<(&'static str, String)>,
    no_color: Option<String>,
    colorterm: Option<String>,
    /// The value of TERM_PROGRAM.
    program: Option<String>,
    /// The value of COLORFGBG: numbers of the text's and the background's colour.
    colours_of_text: Option<String>,
    /// `true` inside of tmux, screen or zellij.
    multiplexed: bool,
}

/// Families of terminals other than emulators, by the first word of their names in the descriptions
/// of ncurses: `linux-16color` is a console, and `vte-256color` not a VT100.
const FAMILIES: [(&str, TerminalKind); 28] = [
    ("ansi", TerminalKind::Old),
    ("pcansi", TerminalKind::Old),
    ("adm", TerminalKind::Old),
    ("beterm", TerminalKind::Old),
    ("bsdos", TerminalKind::Old),
    ("cons", TerminalKind::Old),
    ("hp", TerminalKind::Old),
    ("hurd", TerminalKind::Old),
    ("ibm", TerminalKind::Old),
    ("mach", TerminalKind::Old),
    ("minitel", TerminalKind::Old),
    ("pcvt", TerminalKind::Old),
    ("qnx", TerminalKind::Old),
    ("scoansi", TerminalKind::Old),
    ("sun", TerminalKind::Old),
    ("tvi", TerminalKind::Old),
    ("vt", TerminalKind::Old),
    ("wsvt", TerminalKind::Old),
    ("wy", TerminalKind::Old),
    ("wyse", TerminalKind::Old),
    ("linux", TerminalKind::Console),
    ("bterm", TerminalKind::Console),
    ("jfbterm", TerminalKind::Console),
    ("kon", TerminalKind::Console),
    ("dumb", TerminalKind::Dumb),
    ("dialup", TerminalKind::Unknown),
    ("network", TerminalKind::Unknown),
    ("unknown", TerminalKind::Unknown),
];

/// Returns the kind of a terminal by its name.
fn kind_of(term: &str) -> TerminalKind {
    // Multiplexers name the outer terminal: `screen.linux`.
    let (outer, inner) = term.split_once('.').unwrap_or((term, ""));
    if ["screen", "tmux"].contains(&outer) && kind_of(inner) == TerminalKind::Console {
        return TerminalKind::Console;
    }
    // A number after the word distinguishes members of a family.
    let word = term.split(|c: char| !c.is_ascii_alphabetic()).next();
    let word = word.unwrap_or_default();
    match FAMILIES.iter().find(|(family, _)| *family == word) {
        _ if term.is_empty() => TerminalKind::Unknown,
        Some((_, kind)) => *kind,
        None => TerminalKind::Emulator,
    }
}

/// A detected capability, and its reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Detected<T> {
    /// The capability.
    pub(crate) value: T,
    /// The reason, in a few words.
    pub(crate) why: String,
}

fn found<T>(value: T, why: impl Into<String>) -> Detected<T> {
    let why = why.into();
    Detected { value, why }
}

impl TerminalProfile {
    /// Reads the environment through `env`; an empty variable counts as unset.
    pub(crate) fn of(env: impl Fn(&str) -> Option<String>) -> Self {
        let given = |name: &str| env(name).filter(|value| !value.is_empty());
        let locale = |name| given(name).map(|value| (name, value));
        TerminalProfile {
            term: given("TERM").unwrap_or_default(),
            locale: LOCALE.into_iter().find_map(locale),
            no_color: given("NO_COLOR"),
            colorterm: given("COLORTERM"),
            program: given("TERM_PROGRAM"),
            colours_of_text: given("COLORFGBG"),
            multiplexed: ["TMUX", "STY", "ZELLIJ"]
                .iter()
                .any(|name| given(name).is_some()),
        }
    }

    /// Returns the kind of terminal according to TERM.
    pub(crate) fn kind(&self) -> TerminalKind {
        kind_of(&self.term)
    }

    /// Returns `true` if the locale's encoding is UTF-8.
    pub(crate) fn is_utf8(&self) -> bool {
        let locale = self.locale.as_ref().map(|(_, value)| value);
        locale.is_some_and(|value| {
            let value = value.to_ascii_lowercase();
            value.contains("utf-8") || value.contains("utf8")
        })
    }

    /// Detects the characters to draw with.
    pub(crate) fn glyphs(&self) -> Detected<Glyphs> {
        if !self.is_utf8() {
            return found(Glyphs::Ascii, words().locale_not_utf8());
        }
        match self.kind() {
            TerminalKind::Unknown => found(Glyphs::Ascii, words().term_not_set()),
            TerminalKind::Dumb | TerminalKind::Old => {
                found(Glyphs::Ascii, words().term_has_no_others(&self.term))
            }
            TerminalKind::Console => found(Glyphs::Line, words().console_has_no_braille()),
            TerminalKind::Emulator => found(Glyphs::Braille, words().emulator_in_utf8()),
        }
    }

    /// Detects the colours to draw with.
    pub(crate) fn colours(&self) -> Detected<Colours> {
        if self.no_color.is_some() {
            return found(Colours::None, words().no_color_set());
        }
        match (self.kind(), self.colorterm.as_deref()) {
            (TerminalKind::Unknown, _) => found(Colours::None, words().term_not_set()),
            (TerminalKind::Dumb | TerminalKind::Old, _) => {
                found(Colours::None, words().term_has_none(&self.term))
            }
            (
                TerminalKind::Console | TerminalKind::Emulator,
                Some(many @ ("truecolor" | "24bit")),
            ) => found(Colours::True, format!("COLORTERM={many}")),
            (TerminalKind::Console | TerminalKind::Emulator, _) => self.colours_of_term(),
        }
    }

    fn colours_of_term(&self) -> Detected<Colours> {
        let why = format!("TERM={}", self.term);
        if ["-mono", "-m"].iter().any(|end| self.term.ends_with(end)) {
            found(Colours::None, why)
        } else if self.term.contains("direct") {
            found(Colours::True, why)
        } else if self.term.contains("256color") {
            found(Colours::Indexed, why)
        } else {
            found(Colours::Sixteen, words().promises_no_more(&why))
        }
    }

    /// Returns the capabilities, with `glyphs` and `colours` as overrides. Returns `None` if the
    /// terminal has no cursor addressing, and so no screen to draw on.
    pub(crate) fn capability(
        &self,
        glyphs: Option<Glyphs>,
        colours: Option<Colours>,
    ) -> Option<Capability> {
        let capability = Capability {
            glyphs: glyphs.unwrap_or(self.glyphs().value),
            colours: colours.unwrap_or(self.colours().value),
            modern: self.kind() == TerminalKind::Emulator,
        };
        (self.kind() != TerminalKind::Dumb).then_some(capability)
    }

    /// Returns `true` if COLORFGBG names a light background, and `None` if it names none.
    #[cfg(feature = "tui")]
    pub(crate) fn has_light_ground(&self) -> Option<bool> {
        let ground = self.colours_of_text.as_deref()?.rsplit(';').next()?;
        let ground: u8 = ground.trim().parse().ok()?;
        (ground < 16).then_some(matches!(ground, 7 | 9..=15))
    }

    /// Returns the variables and their values; `None` for unset ones.
    pub(crate) fn variables(&self) -> [(&'static str, Option<&str>); 5] {
        let (name, locale) = match &self.locale {
            Some((name, value)) => (*name, Some(value.as_str())),
            None => (words().row_locale(), None),
        };
        let term = (!self.term.is_empty()).then_some(self.term.as_str());
        [
            ("TERM", term),
            (name, locale),
            ("NO_COLOR", self.no_color.as_deref()),
            ("COLORTERM", self.colorterm.as_deref()),
            ("TERM_PROGRAM", self.program.as_deref()),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn detect(environment: &[(&str, &str)]) -> TerminalProfile {
        TerminalProfile::of(|name| {
            let found = environment.iter().find(|(n, _)| *n == name);
            found.map(|(_, value)| (*value).to_owned())
        })
    }

    #[test]
    fn environment_determines_capability() {
        use Colours::{Indexed, None, Sixteen, True};
        use Glyphs::{Ascii, Braille, Line};
        let utf8 = ("LANG", "en_GB.UTF-8");
        let found = |extra: &[(&str, &str)]| {
            let all = detect(&[&[utf8], extra].concat());
            let found = all.capability(Option::None, Option::None).unwrap();
            (found.glyphs, found.colours, found.modern)
        };
        let xterm = ("TERM", "xterm-256color");
        assert_eq!(found(&[xterm]), (Braille, Indexed, true));
        assert_eq!(found(&[("TERM", "xterm")]), (Braille, Sixteen, true));
        assert_eq!(found(&[("TERM", "xterm-direct")]), (Braille, True, true));
        assert_eq!(found(&[("TERM", "linux")]), (Line, Sixteen, false));
        assert_eq!(found(&[("TERM", "vt100")]), (Ascii, None, false));
        assert_eq!(found(&[("TERM", "vt220")]), (Ascii, None, false));
        assert_eq!(found(&[]), (Ascii, None, false));
        let truecolor = ("COLORTERM", "truecolor");
        assert_eq!(found(&[xterm, truecolor]), (Braille, True, true));
        let no_color = ("NO_COLOR", "1");
        assert_eq!(found(&[xterm, truecolor, no_color]), (Braille, None, true));
        assert_eq!(found(&[xterm, ("NO_COLOR", "")]), (Braille, Indexed, true));
        assert_eq!(found(&[xterm, ("LC_ALL", "C")]), (Ascii, Indexed, true));
        assert_eq!(found(&[xterm, ("LC_ALL", "")]), (Braille, Indexed, true));
        let posix = ("LC_CTYPE", "POSIX");
        assert_eq!(found(&[xterm, posix]), (Ascii, Indexed, true));
        let c_utf8 = ("LC_ALL", "C.utf8");
        assert_eq!(found(&[xterm, c_utf8]), (Braille, Indexed, true));
        let dumb = detect(&[("TERM", "dumb")]);
        assert_eq!(dumb.capability(Option::None, Option::None), Option::None);
    }

    /// Regression: with prefix matching, `vte` was taken for a VT100, and the Linux console got
    /// Braille.
    #[test]
    fn terminal_names_map_to_kinds() {
        for (kind, names) in [
            (
                TerminalKind::Emulator,
                "vte vte-256color xterm-256color screen screen-256color tmux-256color screen.xterm-256color \
                 rxvt-unicode-256color alacritty foot xterm-kitty xterm-ghostty wezterm konsole-256color \
                 st-256color putty mintty iterm2 nsterm contour eterm-color Eterm ms-terminal cygwin",
            ),
            (
                TerminalKind::Console,
                "linux linux-16color linux-basic linux-m linux2.6 linux3.0 screen.linux screen.linux-m \
                 tmux.linux bterm",
            ),
            (
                TerminalKind::Old,
                "vt52 vt100 vt100-am vt102 vt220 vt220-8bit vt320 vt420 vt510 ansi ansi-m ansi.sys cons25 \
                 pcansi sun sun-color wy60 wyse50 wsvt25 tvi925 hp2392 adm3a vt-utf8 scoansi hurd",
            ),
            (TerminalKind::Dumb, "dumb dumb-emacs-ansi"),
            (TerminalKind::Unknown, "unknown network dialup"),
        ] {
            for name in names.split_whitespace() {
                assert_eq!(kind_of(name), kind, "{name}");
            }
        }
        let colours = |term| detect(&[("TERM", term)]).colours().value;
        assert_eq!(colours("vte-256color"), Colours::Indexed);
        assert_eq!(colours("linux-16color"), Colours::Sixteen);
        assert_eq!(colours("linux-m"), Colours::None);
        assert_eq!(colours("xterm-mono"), Colours::None);
    }

    #[test]
    fn options_override_detected_capability() {
        let vt = detect(&[("TERM", "vt100")]);
        let requested = vt.capability(Some(Glyphs::Braille), Some(Colours::True));
        let requested = requested.unwrap();
        assert_eq!(
            (requested.glyphs, requested.colours),
            (Glyphs::Braille, Colours::True)
        );
        assert!(!requested.modern, "nobody wishes a VT100 to be another one");
    }

    #[test]
    fn reasons_name_deciding_variable() {
        let judged = detect(&[
            ("TERM", "xterm"),
            ("LC_ALL", "C"),
            ("LANG", "de_DE.UTF-8"),
            ("NO_COLOR", "1"),
        ]);
        assert_eq!(judged.glyphs().why, "the locale is not UTF-8");
        assert_eq!(judged.colours().why, "NO_COLOR is set");
        assert_eq!(judged.variables()[1], ("LC_ALL", Some("C")));
        assert_eq!(detect(&[]).variables()[0], ("TERM", None));
        assert_eq!(
            detect(&[("TERM", "vt220")]).colours().why,
            "TERM=vt220 supports none"
        );
    }

    #[cfg(feature = "tui")]
    #[test]
    fn background_is_read_from_environment() {
        let light = |value| detect(&[("COLORFGBG", value)]).has_light_ground();
        assert_eq!(light("15;0"), Some(false));
        assert_eq!(light("0;15"), Some(true));
        assert_eq!(light("0;default;7"), Some(true));
        assert_eq!(light("12;8"), Some(false));
        for unknown in ["", "15;default", "15;99", "x"] {
            assert_eq!(light(unknown), None, "{unknown}");
        }
    }

    #[test]
    fn colour_depths_cycle() {
        let all = std::iter::successors(Some(Colours::None), |c| Some(c.next()));
        let names: Vec<_> = all.take(5).map(Colours::name).collect();
        assert_eq!(names, ["none", "16", "256", "true", "none"]);
    }
}
