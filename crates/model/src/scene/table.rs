//! Tables of a scene as they are read: the rows of their keys decide which keys are known, how numbers
//! are called in messages, and which numbers are permitted.

use super::Unit;
use super::keys::{self, KeyKind, NumberMeasure, SceneKey};
use super::numbers::measure::{Measure, MeasureUnits};
use super::numbers::reader::{ByteSpan, MIN_LENGTH, Name, Reader};
use crate::Vec2;
use crate::document::{Diagnostic, WrittenValue, entries, is_probable_misspelling};
use crate::wording::words;
use toml::de::DeTable;

/// A table that is being read.
pub struct KeyTable<'v> {
    /// The name of the element in messages.
    pub of: String,
    /// The place of the whole table.
    pub(crate) span: ByteSpan,
    /// The kind of element, by its characteristic key; empty until it is known.
    pub(crate) kind: &'static str,
    /// Whether its input drives a link rather than a slide.
    pub is_rotary: bool,
    /// Whether messages name its keys without an owner, as those of the scene itself.
    pub is_root: bool,
    keys: &'static [SceneKey],
    entries: &'v DeTable<'v>,
}

impl<'v> KeyTable<'v> {
    pub(crate) fn new(
        of: &str,
        keys: &'static [SceneKey],
        entries: &'v DeTable<'v>,
        span: ByteSpan,
    ) -> Self {
        KeyTable {
            of: of.to_owned(),
            span,
            kind: "",
            is_rotary: true,
            is_root: false,
            keys,
            entries,
        }
    }

    /// Creates the table of a whole document; messages name its keys without an owner.
    #[must_use]
    pub fn root(of: &str, keys: &'static [SceneKey], entries: &'v DeTable<'v>) -> Self {
        KeyTable {
            is_root: true,
            ..KeyTable::new(of, keys, entries, 0..0)
        }
    }

    /// Returns the value of a key.
    #[must_use]
    pub fn get(&self, key: &str) -> Option<&'v WrittenValue<'v>> {
        debug_assert!(keys::find(self.keys, key).is_some(), "no row for `{key}`");
        self.entries.get(key)
    }

    /// Returns `true` if the table has a key.
    #[must_use]
    pub fn has(&self, key: &str) -> bool {
        self.get(key).is_some()
    }

    /// Returns a key with its place, if the table has it.
    pub(crate) fn key(&self, key: &str) -> Option<Name<'v>> {
        let (key, _) = self.entries.get_key_value(key)?;
        Some(Name {
            text: key.get_ref(),
            span: key.span(),
        })
    }

    /// Returns the keys as written, known or not, in the order of the file.
    pub(crate) fn names(&self) -> impl Iterator<Item = Name<'v>> + use<'v> {
        entries(self.entries).map(|(name, _)| name)
    }

    /// Returns the permitted keys: those of its kind, or all of them while the kind is unknown.
    fn known(&self) -> Vec<&'static str> {
        keys::of(self.keys, self.kind)
    }

    /// Returns `true` if an unknown key is probably a misspelling of this one.
    pub(crate) fn is_probable_misspelling(&self, key: &str) -> bool {
        is_probable_misspelling(self.names().map(|name| name.text), &self.known(), key)
    }

    /// Returns the keys that only elements of another kind have.
    pub fn strays(&self, kind: &str) -> Vec<Name<'v>> {
        let own = keys::of(self.keys, kind);
        let is_stray = |name: &Name<'_>| {
            !own.contains(&name.text) && keys::find(self.keys, name.text).is_some()
        };
        self.names().filter(is_stray).collect()
    }

    /// Returns the name of a key in messages, with the unit of its number if its row says so.
    pub fn what(&self, reader: &Reader<'_>, key: &str) -> String {
        let name = match self.is_root {
            true => format!("`{key}`"),
            false => words().key_of(key, &self.of),
        };
        match self.shown_unit(reader, key) {
            Some(unit) => format!("{name} ({unit})"),
            None => name,
        }
    }

    fn shown_unit<'r>(&self, reader: &'r Reader<'_>, key: &str) -> Option<&'r str> {
        let (KeyKind::Number(size, _) | KeyKind::Pair(size)) = keys::find(self.keys, key)?.kind
        else {
            return None;
        };
        let (NumberMeasure::In(_) | NumberMeasure::Effort) = size else {
            return None;
        };
        let measure = size.measure(self.is_rotary, self.kind == keys::TORSION);
        Some(match measure.units(Unit::default()) {
            MeasureUnits::Length => reader.named.length.0,
            _ => measure.unit(Unit::default()),
        })
    }

    /// Returns the measure of the numbers of a key; `None` if they are not plain numbers.
    #[must_use]
    pub fn measure(&self, key: &str) -> Option<Measure> {
        let (KeyKind::Number(size, _) | KeyKind::Series(size)) = keys::find(self.keys, key)?.kind
        else {
            return None;
        };
        Some(size.measure(self.is_rotary, self.kind == keys::TORSION))
    }

    /// Returns the rule for the number of a key.
    fn rule(&self, key: &str) -> NumberRule {
        match keys::find(self.keys, key).map(|key| key.kind) {
            Some(KeyKind::Number(_, rule)) => rule,
            _ => NumberRule::Any,
        }
    }
}

impl Reader<'_> {
    /// Opens a table, called `what` if it is not one; `example` shows the syntax.
    pub fn open<'v>(
        &mut self,
        [what, of]: [&str; 2],
        keys: &'static [SceneKey],
        example: &str,
        value: &'v WrittenValue<'v>,
    ) -> Option<KeyTable<'v>> {
        let entries = self.section(what, example, value)?;
        Some(KeyTable::new(of, keys, entries, value.span()))
    }

    /// Reports every key that the table cannot have.
    pub fn only_known(&mut self, table: &KeyTable<'_>) {
        self.only_these(&table.of, table.names(), &table.known());
    }

    /// Reports a missing key, unless a misspelt key, already reported, explains it.
    pub(crate) fn require(
        &mut self,
        table: &KeyTable<'_>,
        key: &str,
        at: &ByteSpan,
        example: &str,
    ) {
        if !table.has(key) && !table.is_probable_misspelling(key) {
            self.report(
                Diagnostic::new(words().of_has_no(&table.of, key))
                    .at(at.clone(), words().is_missing(key))
                    .help(words().for_example(example)),
            );
        }
    }

    /// Reads an optional text.
    pub fn text_of<'v>(&mut self, table: &KeyTable<'v>, key: &str) -> Option<Name<'v>> {
        let value = table.get(key)?;
        self.string(&table.what(self, key), value)
    }

    /// Reads an optional number by the rule of its row; returns `None` if it is missing or invalid.
    pub fn number_of(&mut self, table: &KeyTable<'_>, key: &str) -> Option<f64> {
        let value = table.get(key)?;
        self.measured(&table.what(self, key), key, table.rule(key), value)
    }

    /// Reads a number with a default; returns `None` if it is invalid.
    pub fn number_or(&mut self, table: &KeyTable<'_>, key: &str, default: f64) -> Option<f64> {
        match table.has(key) {
            true => self.number_of(table, key),
            false => Some(default),
        }
    }

    /// Reads an optional pair of coordinates.
    pub(crate) fn pair_of(&mut self, table: &KeyTable<'_>, key: &str) -> Option<Vec2> {
        let value = table.get(key)?;
        self.pair(&table.what(self, key), value)
    }

    /// Reads a number that follows a rule; reports one that does not.
    pub(crate) fn measured(
        &mut self,
        what: &str,
        key: &str,
        rule: NumberRule,
        value: &WrittenValue<'_>,
    ) -> Option<f64> {
        let number = self.number(what, value)?;
        self.permits(what, key, rule, number, value)
            .then_some(number)
    }

    /// Returns `true` if a number follows a rule; reports one that does not.
    pub fn permits(
        &mut self,
        what: &str,
        key: &str,
        rule: NumberRule,
        number: f64,
        value: &WrittenValue<'_>,
    ) -> bool {
        if rule.holds(number) {
            return true;
        }
        let literal = self.literal(&value.span());
        let (message, label, help) = rule.fault(what, key, number, &literal);
        self.report(
            Diagnostic::new(message)
                .at(value.span(), label)
                .maybe_help(help),
        );
        false
    }

    /// Reads a number by its row, and reports a formula of another dimension.
    pub fn quantity(&mut self, table: &KeyTable<'_>, key: &str) -> Option<f64> {
        let (value, what) = (table.get(key)?, table.what(self, key));
        let number = self.in_units(&what, table.measure(key), value)?;
        self.permits(&what, key, table.rule(key), number, value)
            .then_some(number)
    }

    /// Reads a number, and reports a formula of another dimension than that of the measure.
    pub fn in_units(
        &mut self,
        what: &str,
        measure: Option<Measure>,
        value: &WrittenValue<'_>,
    ) -> Option<f64> {
        let number = self.number(what, value)?;
        let wanted = measure.and_then(Measure::dimension);
        let (Some(wanted), Some(formula)) = (wanted, value.get_ref().as_str()) else {
            return Some(number);
        };
        let result = self.worked_out(what, formula, &value.span())?;
        match result.dimension {
            Some(found) if !found.adds_to(wanted) => {
                let length = self.named.length.0;
                let (found, wanted) = (found.symbol(length), wanted.symbol(length));
                let message = words().value_measures_other(what, &found, &wanted);
                self.report(Diagnostic::new(message).at(value.span(), ""));
                None
            }
            _ => Some(number),
        }
    }
}

/// The permitted range of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NumberRule {
    /// Any number.
    Any,
    /// Not negative; zero is the default.
    NotNegative,
    /// Not negative; zero means exact.
    Deviation,
    /// Positive, or unknown if it is left out.
    Known,
    /// Positive; required.
    Positive,
    /// As `Positive`, in other words.
    PositiveNumber,
    /// Positive, and at most a half.
    AtMostHalf,
    /// From 0 to below 90.
    Acute,
    /// At least 1.
    AtLeastOne,
    /// The length of a link.
    Distance,
    /// The distance of a point from another one.
    Arm,
}

impl NumberRule {
    fn holds(self, number: f64) -> bool {
        match self {
            NumberRule::Any => true,
            NumberRule::NotNegative | NumberRule::Deviation => number >= 0.0,
            NumberRule::Known | NumberRule::Positive | NumberRule::PositiveNumber => number > 0.0,
            NumberRule::AtMostHalf => number > 0.0 && number <= 0.5,
            NumberRule::Acute => (0.0..90.0).contains(&number),
            NumberRule::AtLeastOne => number >= 1.0,
            // Not too small to compute with.
            NumberRule::Distance | NumberRule::Arm => number >= MIN_LENGTH,
        }
    }

    /// Returns message, label and fix for a number that does not follow the rule.
    fn fault(
        self,
        what: &str,
        key: &str,
        number: f64,
        literal: &str,
    ) -> (String, String, Option<String>) {
        let words = words();
        let must_be = |rule: &str, label: &str, help: &str| {
            let message = words.must_be(what, rule, literal);
            (message, label.to_owned(), Some(help.to_owned()))
        };
        let negative = |help: String| {
            let message = words.must_not_be_less_than_zero(what, literal);
            (message, words.is_negative().to_owned(), Some(help))
        };
        let expected = |rule: &str| {
            (
                words.must_be(what, rule, literal),
                words.expected(rule),
                None,
            )
        };
        let [label, help, of_negative] = match self {
            NumberRule::Any | NumberRule::Positive => return expected(words.positive()),
            NumberRule::PositiveNumber => return expected(words.positive_number()),
            NumberRule::AtMostHalf => return expected(words.at_most_a_half()),
            NumberRule::Acute => return expected(words.angle_below_90()),
            NumberRule::AtLeastOne => return expected(words.at_least_1()),
            NumberRule::NotNegative => return negative(words.leave_it_out(key)),
            NumberRule::Deviation => return negative(words.nought_is_exact().to_owned()),
            NumberRule::Known => {
                let help = words.leave_unknown_out(key);
                return must_be(words.positive(), words.is_not_positive(), &help);
            }
            NumberRule::Distance => [
                words.no_direction(),
                words.give_joints_one_name(),
                words.length_is_distance(),
            ],
            NumberRule::Arm => [
                words.no_place_of_its_own(),
                words.leave_point_out(),
                words.turn_angle_by_half(),
            ],
        };
        if number > 0.0 {
            let label = words.too_small_to_compute();
            must_be(words.at_least_smallest(), label, words.choose_a_unit())
        } else if number == 0.0 {
            must_be(words.positive(), label, help)
        } else {
            must_be(words.positive(), words.is_not_positive(), of_negative)
        }
    }
}
