//! Rewrites the text of a scene: with other start positions, or with another title. Every other
//! character stays unchanged, including comments, order and blanks.

use super::Scene;
use crate::{PointId, Vec2};
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// The precision of written numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// Six digits: a start is rough.
    Rough,
    /// Enough digits to read back the same double.
    Exact,
}

/// Coordinates below this fraction of the largest one are rounding errors.
const NOISE: f64 = 1e-9;
/// Significant digits of a rough number.
const DIGITS: usize = 6;

impl Scene {
    /// Returns the scene's text with these start positions, in the scene's unit and frame.
    /// `opening` also replaces the coordinate at which the driver opens.
    ///
    /// Points already in `[start]` are replaced in place, others are appended. Entries of `[start]`
    /// without a counterpart in `start` stay unchanged, and points without a name are omitted.
    /// Returns `None` if the text has no place for the changes, which no parsed scene is known to
    /// cause.
    #[must_use]
    pub fn rewritten(
        &self,
        start: &[(PointId, Vec2)],
        opening: Option<f64>,
        precision: Precision,
    ) -> Option<String> {
        let root = DeTable::parse(self.text()).ok()?;
        let root = root.get_ref();
        let largest = start
            .iter()
            .fold(0.0, |m: f64, (_, p)| m.max(p.x.abs()).max(p.y.abs()));
        let number = |v: f64| match precision {
            Precision::Rough if v.abs() <= NOISE * largest => "0".to_owned(),
            Precision::Rough => figure(v),
            Precision::Exact => format!("{:?}", v + 0.0),
        };
        let named = start.iter().filter_map(|&(point, at)| {
            let value = format!("[{}, {}]", number(at.x), number(at.y));
            Some((self.point_name(point)?, value))
        });
        let mut edits = Edits::default();
        if let Some(at) = opening {
            let key = super::coordinate_key(&self.mechanism);
            let driver = root.get("driver")?.get_ref().as_table()?;
            // A link as drawn needs no angle: it opens in the direction of its points.
            if let Some(opening) = driver.get(key) {
                edits.replace(opening.span(), format!("{at:?}"));
            }
        }
        self.add_start_changes(root, &named.collect::<Vec<_>>(), &mut edits);
        Some(edits.rewritten_in(self.text()))
    }

    /// Adds the changes of `[start]` to `edits`.
    fn add_start_changes(&self, root: &DeTable<'_>, named: &[(&str, String)], edits: &mut Edits) {
        let text = self.text();
        let section = root.get("start");
        let table = section.and_then(|s| s.get_ref().as_table());
        let given = |name: &str| table.and_then(|t| t.get(name));
        for (name, value) in named {
            if let Some(place) = given(name) {
                edits.replace(place.span(), value.clone());
            }
        }
        let missing: Vec<_> = named.iter().filter(|(n, _)| given(n).is_none()).collect();
        if missing.is_empty() {
            return;
        }
        let newline = if text.contains("\r\n") { "\r\n" } else { "\n" };
        let lines = |before: &str, between: &str| -> String {
            let entries = missing.iter().map(|(n, v)| format!("{} = {v}", key(n)));
            entries.fold(String::new(), |all, e| all + between + before + &e)
        };
        let last = table.and_then(|t| t.iter().max_by_key(|(_, value)| value.span().end));
        match (section, last) {
            (None, _) => {
                let gap = if text.is_empty() || text.ends_with('\n') {
                    ""
                } else {
                    newline
                };
                let section = format!("{gap}{newline}[start]{}", lines("", newline));
                edits.insert(text.len(), section + newline);
            }
            (Some(section), None) => match section.get_ref() {
                // `start = {}`, and `[start]` with nothing below it.
                DeValue::Table(_) if text[section.span()].starts_with('{') => {
                    let entries = lines("", ", ");
                    let entries = entries.trim_start_matches(", ");
                    edits.replace(section.span(), format!("{{ {entries} }}"));
                }
                _ => edits.insert(line_end(text, section.span().end), lines("", newline)),
            },
            (Some(_), Some((last_key, last_value))) => {
                let start = text[..last_key.span().start]
                    .rfind('\n')
                    .map_or(0, |newline| newline + 1);
                // Blanks, or the `start.` of a dotted key.
                let before = &text[start..last_key.span().start];
                if is_beginning(before) {
                    let end = line_end(text, last_value.span().end);
                    edits.insert(end, lines(before, newline));
                } else {
                    // Inside braces.
                    edits.insert(last_value.span().end, lines("", ", "));
                }
            }
        }
    }
}

/// Returns `true` if `before` is the part of a line in front of a key of `[start]`.
fn is_beginning(before: &str) -> bool {
    let compact: String = before.split_whitespace().collect();
    compact.is_empty() || compact == "start."
}

/// Returns the end of the line, without its line break.
fn line_end(text: &str, from: usize) -> usize {
    let line = text[from..].lines().next().unwrap_or_default();
    from + line.len()
}

/// Replacements in a text by place, applied all at once.
#[derive(Default)]
pub(crate) struct Edits {
    list: Vec<(Range<usize>, String)>,
}

impl Edits {
    pub(crate) fn replace(&mut self, span: Range<usize>, by: String) {
        self.list.push((span, by));
    }

    fn insert(&mut self, at: usize, new: String) {
        self.list.push((at..at, new));
    }

    pub(crate) fn rewritten_in(mut self, text: &str) -> String {
        self.list.sort_by_key(|(span, _)| (span.start, span.end));
        let mut made = String::with_capacity(text.len() + 64 * self.list.len());
        let mut from = 0;
        for (span, new) in &self.list {
            made.push_str(&text[from..span.start]);
            made.push_str(new);
            from = span.end;
        }
        made.push_str(&text[from..]);
        made
    }
}

/// Formats a name as a TOML key. Quotes it if it is not a bare key, or if a dot would split it
/// (`r3.com`).
pub fn key(name: &str) -> String {
    if name.contains(['\'', '.']) {
        format!("\"{name}\"")
    } else {
        name.to_owned()
    }
}

/// Formats a number with a few significant digits, in a form that TOML can read.
pub fn figure(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        return "0".to_owned();
    }
    if !(1e-4..1e9).contains(&size) {
        let text = format!("{value:.*e}", DIGITS - 1);
        let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{exponent}", trimmed(mantissa));
    }
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between 0 and 10"
    )]
    let decimals = (DIGITS as f64 - 1.0 - size.log10().floor()).max(0.0) as usize;
    trimmed(&format!("{value:.decimals$}")).to_owned()
}

/// Removes trailing zeros of a decimal fraction.
fn trimmed(decimal: &str) -> &str {
    if decimal.contains('.') {
        decimal.trim_end_matches('0').trim_end_matches('.')
    } else {
        decimal
    }
}

impl Scene {
    /// Returns the text with new values of `name`, `source` and `note`; a missing key is added at
    /// the front. Lines that consist of a comment are removed, because they refer to numbers that
    /// will change.
    ///
    /// The rest of the file stays unchanged. [`Scene::parse`] decides whether the result is a
    /// scene.
    #[must_use]
    pub fn with_header(&self, name: &str, source: &str, note: &str) -> String {
        let texts = [("name", name), ("source", source), ("note", note)];
        let mut edits = Edits::default();
        let mut front = String::new();
        // Parsing succeeded before, when the scene was read.
        let root = DeTable::parse(self.text()).ok();
        for (key, text) in texts {
            let value = root.as_ref().and_then(|root| root.get_ref().get(key));
            match value {
                Some(value) => edits.replace(value.span(), toml_string(text)),
                None => front += &format!("{key} = {}\n", toml_string(text)),
            }
        }
        let shown_text = front + &edits.rewritten_in(self.text());
        let lines = shown_text.split_inclusive('\n');
        lines
            .filter(|line| !line.trim_start().starts_with('#'))
            .collect()
    }
}

/// Formats a text as a basic string of TOML.
pub fn toml_string(text: &str) -> String {
    let mut string = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => string.extend(['\\', c]),
            c if c.is_control() => string += &format!("\\u{:04x}", u32::from(c)),
            c => string.push(c),
        }
    }
    string + "\""
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    const BODY: &str = "[ground]\nA = [0, 0]\nD = [400, 0]\n[driver]\nlink = \"r2\"\nangle = 60 # deg\n\
        [links]\nr2 = { from = \"A\", to = \"B\", length = 100 }\n\
        r3 = { from = \"B\", to = \"C\", length = 300 }\nr4 = { from = \"C\", to = \"D\", length = 250 }\n";

    /// Returns the text with other start positions of B and C.
    fn rewritten(text: &str) -> String {
        let scene = Scene::parse(text, "test").unwrap();
        let point = |name: &str| {
            let mut ids = scene.mechanism.point_ids();
            ids.find(|&p| scene.point_name(p) == Some(name)).unwrap()
        };
        let start = [
            (point("C"), Vec2::new(58.25, -123.456789)),
            (point("B"), Vec2::new(50.0, 1e-13)),
        ];
        let new = scene.rewritten(&start, None, Precision::Rough).unwrap();
        let again = Scene::parse(&new, "test").unwrap();
        let place = |name: &str| {
            let mut start = again.mechanism.start().iter();
            start
                .find(|(p, _)| again.point_name(*p) == Some(name))
                .unwrap()
                .1
        };
        assert_eq!(place("C"), Vec2::new(58.25, -123.457));
        assert_eq!(place("B"), Vec2::new(50.0, 0.0));
        new
    }

    #[test]
    fn rewritten_start_keeps_comments_and_order() {
        let text = format!(
            "# mine\n[start]   # where it is\n  C = [310, 230] # up\n\n# the rest\n{BODY}[vectors]\nr1 = [\"D\", \"A\"]\n"
        );
        let expected = text.replace(
            "[310, 230] # up\n",
            "[58.25, -123.457] # up\n  B = [50, 0]\n",
        );
        assert_eq!(rewritten(&text), expected);
    }

    #[test]
    fn rewritten_adds_missing_start_section() {
        let lines = "\n[start]\nC = [58.25, -123.457]\nB = [50, 0]\n";
        assert_eq!(rewritten(BODY), format!("{BODY}{lines}"));
        assert_eq!(rewritten(BODY.trim_end()), format!("{BODY}{lines}"));
        let empty = format!("[start] # none\n{BODY}");
        let filled = empty.replace("# none\n", "# none\nC = [58.25, -123.457]\nB = [50, 0]\n");
        assert_eq!(rewritten(&empty), filled);
    }

    #[test]
    fn rewritten_start_keeps_its_notation() {
        for (given, expected) in [
            (
                "start = { C = [1, 2] }\n",
                "start = { C = [58.25, -123.457], B = [50, 0] }\n",
            ),
            (
                "start = {}\n",
                "start = { C = [58.25, -123.457], B = [50, 0] }\n",
            ),
            (
                "start.C = [1, 2] # so\n",
                "start.C = [58.25, -123.457] # so\nstart.B = [50, 0]\n",
            ),
        ] {
            assert_eq!(
                rewritten(&format!("{given}{BODY}")),
                format!("{expected}{BODY}")
            );
        }
        let text = format!("{BODY}[start]\nC = [1, 2]\n").replace('\n', "\r\n");
        let end = "C = [58.25, -123.457]\r\nB = [50, 0]\r\n";
        assert!(rewritten(&text).ends_with(end));
    }

    #[test]
    fn rewritten_keeps_figures_section() {
        let figures = "[figures]\nswing = 'r4.angle - r3.angle' # deg\nfast = \"swing.rate\"\n";
        let new = rewritten(&format!("{figures}{BODY}"));
        assert!(new.starts_with(figures), "{new}");
        let scene = Scene::parse(&new, "test").unwrap();
        let read = scene.figures.iter().map(|f| [&*f.name, &*f.text]);
        let read: Vec<_> = read.collect();
        assert_eq!(
            read,
            [["swing", "r4.angle - r3.angle"], ["fast", "swing.rate"]]
        );
    }

    #[test]
    fn rewritten_sets_driver_coordinate() {
        let scene = Scene::parse(BODY, "test").unwrap();
        let moved = scene.rewritten(&[], Some(0.1 + 0.2), Precision::Rough);
        let expected = BODY.replace("angle = 60 #", "angle = 0.30000000000000004 #");
        assert_eq!(moved, Some(expected));
    }

    #[test]
    fn figure_rounds_to_six_digits_in_toml_syntax() {
        for (value, text) in [
            (0.0, "0"),
            (311.416_953, "311.417"),
            (-1e-7, "-1e-7"),
            (1.5e300, "1.5e300"),
            (100.0, "100"),
        ] {
            assert_eq!(figure(value), text);
        }
    }

    #[test]
    fn retold_replaces_titles_and_keeps_numbers() {
        for preset in presets::all() {
            let scene = Scene::parse(preset.text, preset.name).unwrap();
            let text = scene.with_header("a \"b\" \\", "here", "so");
            let again = Scene::parse(&text, preset.name).unwrap();
            assert_eq!(again.name, "a \"b\" \\");
            assert_eq!(again.source.as_deref(), Some("here"));
            assert_eq!(again.note.as_deref(), Some("so"));
            let numbers = |scene: &Scene| -> Vec<String> {
                let values = scene.values().into_iter();
                values.map(|v| v.name.clone() + " " + &v.text()).collect()
            };
            assert_eq!(numbers(&again), numbers(&scene), "{}", preset.name);
            assert!(!text.lines().any(|line| line.starts_with('#')), "{text}");
        }
    }

    #[test]
    fn toml_string_escapes_quotes_and_control_characters() {
        assert_eq!(toml_string("a\n\"\u{7}\\"), r#""a\u000a\"\u0007\\""#);
    }

    #[test]
    fn retold_prepends_missing_titles() {
        let body = "# mine\n[ground]\nA = [0, 0]\n[driver]\nlink = \"r\"\nangle = 1\n\
            [links]\nr = { from = \"A\", to = \"B\", length = 1 } # mm\n";
        let scene = Scene::parse(body, "test").unwrap();
        let text = scene.with_header("n", "s", "t");
        let front = "name = \"n\"\nsource = \"s\"\nnote = \"t\"\n";
        assert_eq!(text, front.to_owned() + body.trim_start_matches("# mine\n"));
    }
}
