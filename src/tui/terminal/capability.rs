//! What the terminal can show, as the environment tells it. Nothing is asked of the terminal itself:
//! many never answer, and a slow one answers into the shell.

use crate::drawing::Glyphs;

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

/// Why a terminal cannot be used at all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Dumb;

impl Capability {
    /// Reads LC_ALL, LC_CTYPE, LANG, TERM, NO_COLOR and COLORTERM through `env`; a wish overrides
    /// what was found.
    ///
    /// # Errors
    /// TERM=dumb: no cursor can be placed there, so there is no screen to draw on.
    pub(crate) fn detect(
        env: impl Fn(&str) -> Option<String>,
        glyphs: Option<Glyphs>,
        colours: Option<Colours>,
    ) -> Result<Self, Dumb> {
        let given = |name: &str| env(name).filter(|value| !value.is_empty());
        let term = given("TERM").unwrap_or_default();
        if term == "dumb" {
            return Err(Dumb);
        }
        let old = term.is_empty() || term.starts_with("vt");
        let utf8 = ["LC_ALL", "LC_CTYPE", "LANG"]
            .into_iter()
            .find_map(given)
            .is_some_and(|locale| is_utf8(&locale));
        let found_glyphs = match (utf8, old, term.as_str()) {
            (false, _, _) | (_, true, _) => Glyphs::Ascii,
            (true, false, "linux") => Glyphs::Line,
            (true, false, _) => Glyphs::Braille,
        };
        let found_colours = match given("COLORTERM").as_deref() {
            _ if old || given("NO_COLOR").is_some() => Colours::None,
            Some("truecolor" | "24bit") => Colours::True,
            _ if term.contains("direct") => Colours::True,
            _ if term.contains("256color") => Colours::Indexed,
            _ => Colours::Sixteen,
        };
        Ok(Capability {
            glyphs: glyphs.unwrap_or(found_glyphs),
            colours: colours.unwrap_or(found_colours),
            modern: !old && term != "linux",
        })
    }
}

fn is_utf8(locale: &str) -> bool {
    let locale = locale.to_ascii_lowercase();
    locale.contains("utf-8") || locale.contains("utf8")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn detect(environment: &[(&str, &str)]) -> Result<Capability, Dumb> {
        let env = |name: &str| {
            let found = environment.iter().find(|(n, _)| *n == name);
            found.map(|(_, value)| (*value).to_owned())
        };
        Capability::detect(env, None, None)
    }

    #[test]
    fn environments_are_told_apart() {
        use Colours::{Indexed, None, Sixteen, True};
        use Glyphs::{Ascii, Braille, Line};
        let utf8 = ("LANG", "en_GB.UTF-8");
        let found = |extra: &[(&str, &str)]| {
            let found = detect(&[&[utf8], extra].concat()).unwrap();
            (found.glyphs, found.colours, found.modern)
        };
        let xterm = ("TERM", "xterm-256color");
        assert_eq!(found(&[xterm]), (Braille, Indexed, true));
        assert_eq!(found(&[("TERM", "xterm")]), (Braille, Sixteen, true));
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
        assert_eq!(
            found(&[xterm, ("LC_CTYPE", "POSIX")]),
            (Ascii, Indexed, true)
        );
        assert_eq!(
            found(&[xterm, ("LC_ALL", "C.utf8")]),
            (Braille, Indexed, true)
        );
        assert_eq!(detect(&[("TERM", "dumb")]), Err(Dumb));
    }

    #[test]
    fn a_wish_overrides() {
        let env = |name: &str| (name == "NO_COLOR").then(|| "1".to_owned());
        let found = Capability::detect(env, Some(Glyphs::Braille), Some(Colours::True)).unwrap();
        assert_eq!(
            (found.glyphs, found.colours),
            (Glyphs::Braille, Colours::True)
        );
        assert!(!found.modern, "no wish makes an unknown terminal modern");
    }
}
