//! What a terminal can show, judged from the environment alone: in one place, for the workbench and
//! for messages. Nothing is asked of the terminal itself: many never answer, and a slow one answers
//! into the shell.

#[cfg(feature = "tui")]
mod still;

#[cfg(feature = "tui")]
pub use still::{PictureChoice, PictureProtocol};

use crate::drawing::Glyphs;
use crate::wording::words;

/// How many colours may be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Colours {
    /// None; bold and reverse remain.
    None,
    /// The 16 names of the terminal's own palette.
    Sixteen,
    /// The fixed palette of 256.
    Indexed,
    /// Any colour.
    True,
}

impl Colours {
    /// As the options and the configuration name it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Colours::None => "none",
            Colours::Sixteen => "16",
            Colours::Indexed => "256",
            Colours::True => "true",
        }
    }

    /// The next more, and after all of them none.
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

/// What the terminal can show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Capability {
    /// The characters that are safe.
    pub(crate) glyphs: Glyphs,
    /// The colours that are safe.
    pub(crate) colours: Colours,
    /// Whether it is an emulator that ignores a private mode it does not know: synchronised frames
    /// and bracketed paste are switched on only there.
    pub(crate) modern: bool,
}

/// What TERM says of the terminal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TerminalKind {
    /// It says nothing.
    Unknown,
    /// It cannot place its cursor.
    Dumb,
    /// A real terminal of old, or something that is as modest.
    Old,
    /// The console of Linux: UTF-8, but fonts with few characters.
    Console,
    /// An emulator with a window of its own.
    Emulator,
}

/// The variables that name the locale, in the order in which POSIX has them override each other.
const LOCALE: [&str; 3] = ["LC_ALL", "LC_CTYPE", "LANG"];

/// The environment, as far as it tells about the terminal, and what follows from it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Judgement {
    term: String,
    /// The variable that decides, and what it says.
    locale: Option<(&'static str, String)>,
    no_color: Option<String>,
    colorterm: Option<String>,
    /// What TERM_PROGRAM says.
    program: Option<String>,
    /// Whether tmux, screen or zellij stands between.
    multiplexed: bool,
}

/// Families of terminals that are no emulators with a window of their own, by the word that their names begin
/// with (the descriptions of ncurses): `linux-16color` is a console, and `vte-256color` no VT100.
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

/// What kind of terminal has this name.
fn kind_of(term: &str) -> TerminalKind {
    // Multiplexers tell in what they run: `screen.linux`.
    let (outer, inner) = term.split_once('.').unwrap_or((term, ""));
    if ["screen", "tmux"].contains(&outer) && kind_of(inner) == TerminalKind::Console {
        return TerminalKind::Console;
    }
    // A number behind the word tells one of the family from others.
    let word = term.split(|c: char| !c.is_ascii_alphabetic()).next();
    let word = word.unwrap_or_default();
    match FAMILIES.iter().find(|(family, _)| *family == word) {
        _ if term.is_empty() => TerminalKind::Unknown,
        Some((_, kind)) => *kind,
        None => TerminalKind::Emulator,
    }
}

/// What was found, and from what it follows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Detected<T> {
    /// What was found.
    pub(crate) value: T,
    /// Why, in a few words.
    pub(crate) why: String,
}

fn found<T>(value: T, why: impl Into<String>) -> Detected<T> {
    let why = why.into();
    Detected { value, why }
}

impl Judgement {
    /// Reads the environment through `env`; a variable that is empty is not set.
    pub(crate) fn of(env: impl Fn(&str) -> Option<String>) -> Self {
        let given = |name: &str| env(name).filter(|value| !value.is_empty());
        let locale = |name| given(name).map(|value| (name, value));
        Judgement {
            term: given("TERM").unwrap_or_default(),
            locale: LOCALE.into_iter().find_map(locale),
            no_color: given("NO_COLOR"),
            colorterm: given("COLORTERM"),
            program: given("TERM_PROGRAM"),
            multiplexed: ["TMUX", "STY", "ZELLIJ"]
                .iter()
                .any(|name| given(name).is_some()),
        }
    }

    /// What TERM says.
    pub(crate) fn kind(&self) -> TerminalKind {
        kind_of(&self.term)
    }

    /// Whether the locale's characters are UTF-8.
    pub(crate) fn is_utf8(&self) -> bool {
        let locale = self.locale.as_ref().map(|(_, value)| value);
        locale.is_some_and(|value| {
            let value = value.to_ascii_lowercase();
            value.contains("utf-8") || value.contains("utf8")
        })
    }

    /// The characters to draw with.
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

    /// The colours to draw with.
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

    /// What the workbench may use, where nobody wishes otherwise; `None` where no cursor can be
    /// placed, and so there is no screen to draw on.
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

    /// What was read: each variable and what it says, or that it is not set.
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

    fn judge(environment: &[(&str, &str)]) -> Judgement {
        Judgement::of(|name| {
            let found = environment.iter().find(|(n, _)| *n == name);
            found.map(|(_, value)| (*value).to_owned())
        })
    }

    #[test]
    fn environments_are_told_apart() {
        use Colours::{Indexed, None, Sixteen, True};
        use Glyphs::{Ascii, Braille, Line};
        let utf8 = ("LANG", "en_GB.UTF-8");
        let found = |extra: &[(&str, &str)]| {
            let all = judge(&[&[utf8], extra].concat());
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
        let dumb = judge(&[("TERM", "dumb")]);
        assert_eq!(dumb.capability(Option::None, Option::None), Option::None);
    }

    /// By the first letters alone, the first one was a VT100, and the console had Braille.
    #[test]
    fn terminals_are_what_their_names_say() {
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
        let colours = |term| judge(&[("TERM", term)]).colours().value;
        assert_eq!(colours("vte-256color"), Colours::Indexed);
        assert_eq!(colours("linux-16color"), Colours::Sixteen);
        assert_eq!(colours("linux-m"), Colours::None);
        assert_eq!(colours("xterm-mono"), Colours::None);
    }

    #[test]
    fn wishes_override_what_was_found() {
        let vt = judge(&[("TERM", "vt100")]);
        let wished = vt.capability(Some(Glyphs::Braille), Some(Colours::True));
        let wished = wished.unwrap();
        assert_eq!(
            (wished.glyphs, wished.colours),
            (Glyphs::Braille, Colours::True)
        );
        assert!(!wished.modern, "nobody wishes a VT100 to be another one");
    }

    #[test]
    fn reasons_name_what_decided() {
        let judged = judge(&[
            ("TERM", "xterm"),
            ("LC_ALL", "C"),
            ("LANG", "de_DE.UTF-8"),
            ("NO_COLOR", "1"),
        ]);
        assert_eq!(judged.glyphs().why, "the locale is not UTF-8");
        assert_eq!(judged.colours().why, "NO_COLOR is set");
        assert_eq!(judged.variables()[1], ("LC_ALL", Some("C")));
        assert_eq!(judge(&[]).variables()[0], ("TERM", None));
        assert_eq!(
            judge(&[("TERM", "vt220")]).colours().why,
            "TERM=vt220 supports none"
        );
    }

    #[test]
    fn more_colours_come_round() {
        let all = std::iter::successors(Some(Colours::None), |c| Some(c.next()));
        let names: Vec<_> = all.take(5).map(Colours::name).collect();
        assert_eq!(names, ["none", "16", "256", "true", "none"]);
    }
}
