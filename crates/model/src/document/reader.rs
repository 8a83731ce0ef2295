//! Reads values of a document, and reports everything that does not fit.

use super::diagnostic::{Diagnostic, Diagnostics};
use super::node::{WrittenValue, entries, items, kind_of};
use super::sanitize::escaped;
use crate::expression::MeasuredNumber;
use crate::nearest::{did_you_mean, nearest};
use crate::wording::words;
use std::collections::HashMap;
use std::fmt;
use std::ops::Range;
use toml::de::DeTable;

pub type ByteSpan = Range<usize>;

/// Maximum number of characters quoted from a file.
const QUOTED: usize = 48;
/// Maximum number of faults shown, because people fix a few at a time.
const SHOWN: usize = 20;
/// Number of faults after which suggestions are no longer computed.
const FULL: usize = 50;

/// A text of the file with its place: mostly a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name<'t> {
    pub text: &'t str,
    pub span: ByteSpan,
}

impl fmt::Display for Name<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&quoted(self.text))
    }
}

/// Quotes a text of the file in backticks, with escapes, and truncates it if it is long.
pub fn quoted(text: &str) -> String {
    match text.char_indices().nth(QUOTED) {
        Some((end, _)) => format!("`{}...`", escaped(&text[..end], false)),
        None => format!("`{}`", escaped(text, false)),
    }
}

/// The kind of a document. Help that names tables of scenes is given for scenes only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DocumentKind {
    Scene,
    Task,
    Configuration,
}

/// The named numbers available to formulas of a document; a configuration has none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NamedNumbers {
    /// The value of each name; `None` if its fault was reported.
    pub worth: HashMap<String, Option<MeasuredNumber>>,
    /// The unit of length: its symbol, and its size in tenths of a millimetre.
    pub length: (&'static str, f64),
}

/// Collects diagnostics while values are read.
pub struct Reader<'t> {
    text: &'t str,
    pub(super) kind: DocumentKind,
    pub found: Vec<Diagnostic>,
    pub named: NamedNumbers,
    /// The values of formulas, by their start offset.
    pub(crate) worked: HashMap<usize, f64>,
    /// Whether a number was rounded to a double that reads as a decimal of up to 14 digits.
    pub(crate) has_rounded: bool,
}

impl<'t> Reader<'t> {
    pub fn new(text: &'t str, kind: DocumentKind) -> Self {
        Reader {
            text,
            kind,
            found: Vec::new(),
            named: NamedNumbers::default(),
            worked: HashMap::new(),
            has_rounded: false,
        }
    }

    /// Returns the text being read.
    pub(crate) fn text(&self) -> &'t str {
        self.text
    }

    /// Returns all diagnostics, in the order of the text.
    pub fn into_diagnostics(self, origin: &str) -> Diagnostics {
        let mut items = self.found;
        items.sort_by_key(|item| item.primary.as_ref().map(|label| label.span.start));
        if items.len() > SHOWN {
            let rest = items.len() - SHOWN;
            items.truncate(SHOWN);
            items.push(Diagnostic::new(words().more_faults(rest)));
        }
        Diagnostics {
            origin: origin.to_owned(),
            text: self.text.into(),
            items,
        }
    }

    /// Returns `true` if so many faults were reported that further help is not worth its time.
    pub(crate) fn is_full(&self) -> bool {
        self.found.len() >= FULL
    }

    pub fn report(&mut self, diagnostic: Diagnostic) {
        self.found.push(diagnostic);
    }

    /// Returns `true` if an error was reported that makes the document unusable.
    pub fn has_errors(&self) -> bool {
        self.found.iter().any(|found| !found.is_warning)
    }

    /// Adds a suggested fix to the last diagnostic.
    pub(crate) fn help(&mut self, help: &str) {
        if let Some(last) = self.found.last_mut() {
            last.suggestions.push(help.to_owned());
        }
    }

    /// Returns a value as written in the file; for a formula also the result.
    pub fn literal(&self, span: &ByteSpan) -> String {
        let written = quoted(self.text.get(span.clone()).unwrap_or(""));
        match self.worked.get(&span.start) {
            Some(number) => format!("{written} = {number}"),
            None => written,
        }
    }

    /// Returns the diagnostic of a value of the wrong type.
    pub fn mistyped(&self, what: &str, wanted: &str, value: &WrittenValue<'_>) -> Diagnostic {
        Diagnostic::new(words().must_be(what, wanted, kind_of(value)))
            .at(value.span(), words().expected(wanted))
    }

    /// Reads a text.
    pub fn string<'v>(&mut self, what: &str, value: &'v WrittenValue<'v>) -> Option<Name<'v>> {
        let span = value.span();
        if let Some(text) = value.get_ref().as_str() {
            return Some(Name { text, span });
        }
        let fault = self.mistyped(what, words().a_quoted_text(), value);
        let literal = self.text.get(span).unwrap_or("");
        let word = |c: char| c.is_ascii_alphanumeric() || c == '.';
        let short = literal.len() <= QUOTED && literal.chars().all(word);
        self.report(if short {
            fault.help(words().write_in_quotes(literal))
        } else {
            fault
        });
        None
    }

    /// Reads a boolean; used by the configuration and by tasks.
    pub fn boolean(&mut self, what: &str, value: &WrittenValue<'_>) -> Option<bool> {
        let read = value.get_ref().as_bool();
        if read.is_none() {
            let fault = self.mistyped(what, words().a_truth(), value);
            let help = value.get_ref().as_str().and_then(bare_boolean);
            self.report(fault.maybe_help(help));
        }
        read
    }

    /// Reads a list of what is `wanted`; `example` shows the syntax.
    pub fn list<'v>(
        &mut self,
        what: &str,
        wanted: &str,
        example: &str,
        value: &'v WrittenValue<'v>,
    ) -> Option<&'v [WrittenValue<'v>]> {
        let items = items(value);
        if items.is_none() {
            let fault = self.mistyped(what, wanted, value);
            self.report(fault.help(words().for_example(example)));
        }
        items
    }

    /// Reads a table; `example` shows the syntax.
    pub fn section<'v>(
        &mut self,
        what: &str,
        example: &str,
        value: &'v WrittenValue<'v>,
    ) -> Option<&'v DeTable<'v>> {
        let table = value.get_ref().as_table();
        if table.is_none() {
            let fault = self.mistyped(what, words().a_table(), value);
            self.report(fault.help(words().for_example(example)));
        }
        table
    }

    /// Reads a table whose keys are names, and returns its entries in the order of the file.
    pub fn entries<'v>(
        &mut self,
        what: &str,
        example: &str,
        value: &'v WrittenValue<'v>,
    ) -> impl Iterator<Item = (Name<'v>, &'v WrittenValue<'v>)> + use<'v> {
        let table = self.section(what, example, value);
        table.into_iter().flat_map(entries)
    }

    /// Reports every key not listed in `known`.
    pub fn only_these<'n>(
        &mut self,
        of: &str,
        keys: impl IntoIterator<Item = Name<'n>>,
        known: &[&str],
    ) {
        for Name { text, span } in keys {
            if known.contains(&text) {
                continue;
            }
            let fault = Diagnostic::new(words().unknown_key_in(of, &quoted(text)))
                .at(span, words().unknown_key_here());
            let near = (!self.is_full()).then(|| did_you_mean(text, known.iter().copied()));
            if self.kind == DocumentKind::Scene {
                if let Some(what) = not_modelled(text) {
                    self.report(fault.help(what));
                    continue;
                }
                if let Some(what) = word_of_others(text) {
                    self.report(fault.help(what).maybe_help(near.flatten()));
                    continue;
                }
            }
            let listed = || words().known_keys(&format!("`{}`", known.join("`, `")));
            self.report(fault.help(near.flatten().unwrap_or_else(listed)));
        }
    }
}

/// Returns the explanation for a key of a feature that krank does not model; `None` for other keys.
fn not_modelled(key: &str) -> Option<&'static str> {
    match key.to_ascii_lowercase().as_str() {
        "gear" | "gears" | "geartrain" | "rack" | "racks" | "teeth" => Some(words().no_gears_yet()),
        "cam" | "cams" | "follower" | "followers" => Some(words().no_cams_yet()),
        "belt" | "belts" | "pulley" | "pulleys" | "chain" | "chains" => {
            Some(words().no_belts_yet())
        }
        "friction" | "mu" => Some(words().no_friction_yet()),
        "torque" | "force" => Some(words().motion_is_given()),
        "contact" | "contacts" => Some(words().no_contacts_yet()),
        _ => None,
    }
}

/// Explains a key that is the word of another linkage program; `None` for other keys.
fn word_of_others(key: &str) -> Option<&'static str> {
    match key.to_ascii_lowercase().as_str() {
        "joint" | "joints" | "connector" | "connectors" | "hinge" | "hinges" | "node" | "nodes"
        | "pin" | "pins" | "pivot" | "pivots" | "revolute" => Some(words().joints_are_points()),
        "piston" | "pistons" | "prismatic" | "rail" | "rails" | "slider" | "sliders" | "slot"
        | "slots" => Some(words().sliders_are_slides()),
        "actuator" | "actuators" | "crank" | "cranks" | "motors" | "servo" | "servos" => {
            Some(words().motors_are_drivers())
        }
        "anchor" | "anchors" | "base" | "fixed" | "frame" => Some(words().anchors_are_ground()),
        "bar" | "bars" | "bodies" | "body" | "member" | "members" => Some(words().bars_are_links()),
        _ => None,
    }
}

/// Returns `true` if an unknown key of the table is probably a misspelling of this one.
pub fn is_probable_misspelling<'n>(
    keys: impl Iterator<Item = &'n str>,
    known: &[&str],
    key: &str,
) -> bool {
    // Bounded, because the comparison is expensive.
    keys.take(FULL)
        .any(|text| !known.contains(&text) && nearest(text, known.iter().copied()) == Some(key))
}

/// Returns the hint for a boolean written as text; `None` for other texts.
fn bare_boolean(text: &str) -> Option<String> {
    let intended = match text {
        "true" | "yes" | "on" => true,
        "false" | "no" | "off" => false,
        _ => return None,
    };
    Some(words().write_without_quotes(&intended.to_string()))
}
