//! Parses options whose values are names of library values.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// A value of an option: its name and its aliases, separated by `|`, its description and its
/// meaning.
pub(super) type OptionValue<T> = (&'static str, &'static str, T);

/// The value of an option; `None` for `auto`, which lets krank choose. A field of the type `Option` itself would
/// make the parser treat the option as optional.
pub(super) type OrAuto<T> = Option<T>;

/// Returns values with the names that the library has for them, and with their descriptions.
pub(super) fn option_values<T: Copy, const N: usize>(
    values: [T; N],
    name: fn(T) -> &'static str,
    about: [&'static str; N],
) -> Vec<OptionValue<T>> {
    let described = values.into_iter().zip(about);
    described
        .map(|(value, about)| (name(value), about, value))
        .collect()
}

/// Adds the value `auto` before the others.
pub(super) fn or_auto<T>(
    about: &'static str,
    values: Vec<OptionValue<T>>,
) -> Vec<OptionValue<OrAuto<T>>> {
    let values = values.into_iter();
    let values = values.map(|(name, about, value)| (name, about, Some(value)));
    [("auto", about, None)].into_iter().chain(values).collect()
}

/// Returns a parser that accepts the names of `choices`.
pub(super) fn one_of<T>(choices: impl Into<Vec<OptionValue<T>>>) -> impl TypedValueParser<Value = T>
where
    T: Copy + Send + Sync + 'static,
{
    let choices = choices.into();
    let values = choices.iter().map(|(names, about, _)| {
        let mut names = names.split('|');
        let value = PossibleValue::new(names.next().unwrap_or_default());
        value.aliases(names).help(*about)
    });
    let values = PossibleValuesParser::new(values.collect::<Vec<_>>());
    values.try_map(move |name| value_named(&choices, &name).ok_or(name))
}

/// Returns the value with this name.
fn value_named<T: Copy>(choices: &[OptionValue<T>], name: &str) -> Option<T> {
    let is_named = |(names, ..): &&OptionValue<T>| names.split('|').any(|own| own == name);
    choices.iter().find(is_named).map(|(.., value)| *value)
}
