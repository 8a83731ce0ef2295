//! Access to the values of a document, whatever their type.

use super::reader::Name;
use crate::wording::words;
use toml::Spanned;
use toml::de::{DeInteger, DeTable, DeValue};

/// A value of a document with its place.
pub type WrittenValue<'t> = Spanned<DeValue<'t>>;

/// The keys and values of a table.
pub type Entries<'t> = DeTable<'t>;

/// Returns the kind of a value as a phrase for messages.
pub(super) fn kind_of(value: &WrittenValue<'_>) -> &'static str {
    match value.get_ref() {
        DeValue::String(_) => words().a_text(),
        DeValue::Integer(_) | DeValue::Float(_) => words().a_number(),
        DeValue::Boolean(_) => words().a_truth(),
        DeValue::Datetime(_) => words().a_date(),
        DeValue::Array(_) => words().a_list(),
        DeValue::Table(_) => words().a_table(),
    }
}

/// Returns name and value of each entry of a table, in the order of the file.
pub fn entries<'v>(
    table: &'v DeTable<'v>,
) -> impl Iterator<Item = (Name<'v>, &'v WrittenValue<'v>)> {
    table.iter().map(|(key, value)| {
        let (text, span) = (key.get_ref().as_ref(), key.span());
        (Name { text, span }, value)
    })
}

/// Returns the items of a list; `None` for another value.
pub fn items<'v>(value: &'v WrittenValue<'v>) -> Option<&'v [WrittenValue<'v>]> {
    value.get_ref().as_array().map(AsRef::as_ref)
}

/// Returns the double nearest to the digits in the text, infinite on overflow; `None` for a value
/// that is not a number. TOML's own integers have no negative zero and are limited to 128 bits.
pub(crate) fn number_of(text: &str, value: &WrittenValue<'_>) -> Option<f64> {
    let in_base = match value.get_ref() {
        DeValue::Integer(integer) => nearest(integer),
        DeValue::Float(_) => f64::INFINITY,
        _ => return None,
    };
    let digits = text.get(value.span()).unwrap_or("").replace('_', "");
    // Numbers that begin with 0x, 0o or 0b do not parse as f64.
    Some(digits.parse().unwrap_or(in_base))
}

#[expect(clippy::cast_precision_loss, reason = "the nearest double is meant")]
fn nearest(integer: &DeInteger<'_>) -> f64 {
    let complete = u128::from_str_radix(integer.as_str(), integer.radix());
    complete.map_or(f64::INFINITY, |complete| complete as f64)
}
