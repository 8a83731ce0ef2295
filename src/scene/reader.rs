//! Typed access to the parsed TOML; everything that does not fit becomes a diagnostic.

use super::diagnostic::{Diagnostic, Diagnostics};
use super::harmless::escaped;
use super::rate;
use crate::Vec2;
use crate::nearest::{did_you_mean, nearest};
use std::fmt;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};

pub(super) type Value<'t> = Spanned<DeValue<'t>>;
pub(super) type Span = Range<usize>;

/// No coordinate or length may be larger: squares of scaled values must stay finite, and nothing
/// that a person builds comes near.
pub(super) const LARGEST: f64 = 1e300;
/// No length may be smaller, for the same reason.
pub(super) const SMALLEST_LENGTH: f64 = 1e-300;
/// The mend for a number out of all proportion.
pub(super) const ORDINARY: &str = "choose a `unit` in which the dimensions are ordinary numbers";
/// Characters of a foreign text that a message quotes.
const QUOTED: usize = 48;
/// Faults that are shown at most: a person mends a few at a time.
const SHOWN: usize = 20;
/// Faults after which no more effort is spent on one.
const FULL: usize = 50;

/// A text of the file with its place: mostly a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Name<'t> {
    pub(super) text: &'t str,
    pub(super) span: Span,
}

impl fmt::Display for Name<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&quoted(self.text))
    }
}

/// A foreign text in backticks: harmless, and cut where it is long.
pub(super) fn quoted(text: &str) -> String {
    match text.char_indices().nth(QUOTED) {
        Some((end, _)) => format!("`{}...`", escaped(&text[..end], false)),
        None => format!("`{}`", escaped(text, false)),
    }
}

/// Collects diagnostics while values are read.
pub(super) struct Reader<'t> {
    text: &'t str,
    pub(super) found: Vec<Diagnostic>,
}

impl<'t> Reader<'t> {
    pub(super) fn new(text: &'t str) -> Self {
        Reader {
            text,
            found: Vec::new(),
        }
    }

    /// The text that is read.
    pub(super) fn text(&self) -> &'t str {
        self.text
    }

    /// All that was reported, in the order of the text.
    pub(super) fn into_diagnostics(self, origin: &str) -> Diagnostics {
        let mut items = self.found;
        items.sort_by_key(|item| item.primary.as_ref().map(|label| label.span.start));
        if items.len() > SHOWN {
            let rest = items.len() - SHOWN;
            items.truncate(SHOWN);
            items.push(Diagnostic::new(format!("{rest} more faults are not shown")));
        }
        Diagnostics {
            origin: origin.to_owned(),
            text: self.text.into(),
            items,
        }
    }

    /// Whether so much was reported that help and further reading are not worth their time.
    pub(super) fn is_full(&self) -> bool {
        self.found.len() >= FULL
    }

    pub(super) fn report(&mut self, diagnostic: Diagnostic) {
        self.found.push(diagnostic);
    }

    /// Adds a mend to the last report.
    pub(super) fn help(&mut self, help: &str) {
        if let Some(last) = self.found.last_mut() {
            last.helps.push(help.to_owned());
        }
    }

    /// A value as the file writes it.
    pub(super) fn literal(&self, span: &Span) -> String {
        quoted(self.text.get(span.clone()).unwrap_or(""))
    }

    fn wrong_type(&mut self, what: &str, wanted: &str, value: &Value<'_>) -> Diagnostic {
        let kind = kind(value.get_ref());
        Diagnostic::new(format!("{what} must be {wanted}, not {kind}"))
            .at(value.span(), format!("expected {wanted}"))
    }

    /// A finite number that is not too large.
    pub(super) fn number(&mut self, what: &str, value: &Value<'_>) -> Option<f64> {
        let Some(number) = number_of(value.get_ref()) else {
            let fault = self.wrong_type(what, "a number", value);
            let help = value.get_ref().as_str().and_then(bare_number);
            self.report(fault.maybe_help(help));
            return None;
        };
        let literal = self.literal(&value.span());
        // Written so that NaN is refused too.
        if number.abs() <= LARGEST {
            return Some(number);
        }
        let (rule, label, help) = if number.is_nan() {
            (
                "a finite number",
                "not a number",
                "write a decimal number, such as 12.5",
            )
        } else if number.is_infinite() {
            (
                "a finite number",
                "not finite in double precision",
                "write a decimal number, such as 12.5",
            )
        } else {
            ("at most 1e300 in size", "too large", ORDINARY)
        };
        self.report(
            Diagnostic::new(format!("{what} must be {rule}, not {literal}"))
                .at(value.span(), label)
                .help(help),
        );
        None
    }

    /// A pair `[x, y]`.
    pub(super) fn pair(&mut self, what: &str, value: &Value<'_>) -> Option<Vec2> {
        let items = self.two(what, "[x, y]", "[12.5, 0]", value)?;
        let x = self.number(&format!("x of {what}"), &items[0]);
        let y = self.number(&format!("y of {what}"), &items[1]);
        Some(Vec2::new(x?, y?))
    }

    /// A list of exactly two values.
    pub(super) fn two<'v>(
        &mut self,
        what: &str,
        form: &str,
        example: &str,
        value: &'v Value<'v>,
    ) -> Option<&'v DeArray<'v>> {
        let Some(items) = value.get_ref().as_array() else {
            let fault = self.wrong_type(what, &format!("a pair {form}"), value);
            self.report(fault.help(format!("for example: {example}")));
            return None;
        };
        if items.len() != 2 {
            let count = items.len();
            self.report(
                Diagnostic::new(format!("{what} must be a pair {form}, not {count} values"))
                    .at(value.span(), format!("expected 2 values, found {count}"))
                    .help(format!("for example: {example}")),
            );
            return None;
        }
        Some(items)
    }

    /// A text.
    pub(super) fn string<'v>(&mut self, what: &str, value: &'v Value<'v>) -> Option<Name<'v>> {
        if let Some(text) = value.get_ref().as_str() {
            let span = value.span();
            return Some(Name { text, span });
        }
        let fault = self.wrong_type(what, "a text in quotes", value);
        let literal = self.text.get(value.span()).unwrap_or("");
        let word = |c: char| c.is_ascii_alphanumeric() || c == '.';
        let short = literal.len() <= QUOTED && literal.chars().all(word);
        self.report(if short {
            fault.help(format!("write it in quotes: \"{literal}\""))
        } else {
            fault
        });
        None
    }

    /// A table; `example` shows how one is written.
    pub(super) fn table<'v>(
        &mut self,
        what: &str,
        example: &str,
        value: &'v Value<'v>,
    ) -> Option<&'v DeTable<'v>> {
        if let Some(table) = value.get_ref().as_table() {
            return Some(table);
        }
        let fault = self.wrong_type(what, "a table", value);
        self.report(fault.help(format!("for example: {example}")));
        None
    }

    /// Reports every key of a table that is not among `known`.
    pub(super) fn only(&mut self, of: &str, table: &DeTable<'_>, known: &[&str]) {
        for (key, _) in table {
            let text = key.get_ref().as_ref();
            if known.contains(&text) {
                continue;
            }
            let fault = Diagnostic::new(format!("{of}: unknown key {}", quoted(text)))
                .at(key.span(), "unknown key");
            let near = (!self.is_full()).then(|| did_you_mean(text, known.iter().copied()));
            let listed = || format!("known keys: `{}`", known.join("`, `"));
            self.report(fault.help(near.flatten().unwrap_or_else(listed)));
        }
    }
}

/// The mend for a number that was written as a text.
fn bare_number(text: &str) -> Option<String> {
    let text = text.trim();
    let (number, rest) = text.split_at(rate::number_length(text));
    let help = match (number.is_empty(), rest.is_empty()) {
        (true, _) => return None,
        (false, true) => format!("write it without quotes: {number}"),
        (false, false) => format!(
            "write the number alone: {number}; lengths are in the scene's `unit`, angles in degrees"
        ),
    };
    Some(help)
}

/// Whether an unknown key of the table was probably meant to be this one.
pub(super) fn meant(table: &DeTable<'_>, known: &[&str], key: &str) -> bool {
    // Who misspelt more keys than these has other worries.
    table.keys().take(FULL).any(|k| {
        let text = k.get_ref().as_ref();
        !known.contains(&text) && nearest(text, known.iter().copied()) == Some(key)
    })
}

/// What kind of value this is, in a person's words.
fn kind(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a text",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}

/// The nearest double; infinite for a literal that overflows.
pub(super) fn number_of(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Float(float) => float.as_str().parse().ok(),
        DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
        #[expect(clippy::cast_precision_loss, reason = "the nearest double is meant")]
        DeValue::Integer(integer) => {
            let whole = u128::from_str_radix(integer.as_str(), integer.radix());
            Some(whole.map_or(f64::INFINITY, |n| n as f64))
        }
        DeValue::String(_)
        | DeValue::Boolean(_)
        | DeValue::Datetime(_)
        | DeValue::Array(_)
        | DeValue::Table(_) => None,
    }
}
