//! Selects the language of the program. It must be known before the command line is parsed, because
//! the parser's help texts depend on it.

use crate::cli::choice::{OptionValue, OrAuto, or_auto};
use crate::wording::{Language, words};
use std::ffi::{OsStr, OsString};
use std::path::PathBuf;

/// Returns the values of `--language`; `auto` is the configured language, or that of the locale.
pub(super) fn languages() -> Vec<OptionValue<OrAuto<Language>>> {
    let mut names = words().names_of_languages().split(' ');
    let languages = Language::ALL.into_iter();
    let languages = languages.map(|language| {
        let own = language.name();
        (own, names.next().unwrap_or(own), language)
    });
    let mut languages: Vec<_> = languages.collect();
    languages.reverse();
    or_auto(words().language_auto(), languages)
}

/// Selects the requested language, the configured one, or that of the locale. Returns the arguments
/// with the language option moved to the command, where every command accepts it.
pub(super) fn settle(
    arguments: Vec<OsString>,
    is_command: impl Fn(&OsStr) -> bool,
) -> Vec<OsString> {
    let configured = configured(value_of(&arguments, "--config").map(PathBuf::from));
    let requested = value_of(&arguments, OPTION);
    let requested = requested.and_then(|name| Language::named(name.to_str()?));
    let env = |name: &str| Some(std::env::var_os(name)?.to_string_lossy().into_owned());
    let language = requested.or(configured);
    language.unwrap_or_else(|| Language::of_locale(env)).speak();
    with_language_moved(arguments, is_command)
}

#[cfg(feature = "tui")]
fn configured(named: Option<PathBuf>) -> Option<Language> {
    super::workbench::language(named.as_deref())
}

/// Returns `None`: only the workbench has a configuration.
#[cfg(not(feature = "tui"))]
fn configured(_: Option<PathBuf>) -> Option<Language> {
    None
}

const OPTION: &str = "--language";
/// The separator after which every argument is a name.
const NAMES: &str = "--";

/// Returns the value of an option, given as `--option value` or `--option=value`.
fn value_of(arguments: &[OsString], option: &str) -> Option<OsString> {
    let mut rest = arguments.iter().take_while(|it| *it != NAMES);
    while let Some(argument) = rest.next() {
        if argument == option {
            return rest.next().cloned();
        }
        if let Some(value) = value_within(argument, option) {
            return Some(value.into());
        }
    }
    None
}

fn value_within<'a>(argument: &'a OsStr, option: &str) -> Option<&'a str> {
    argument.to_str()?.strip_prefix(option)?.strip_prefix('=')
}

/// Moves each `--language` option with its value after all other arguments. In front of a command,
/// the option would make clap take the command for a scene. If the last argument is an option,
/// which could take `--language` for its value, the options go after the command instead. Without a
/// command, they go after a scene in first place, or else in front.
fn with_language_moved(
    arguments: Vec<OsString>,
    is_command: impl Fn(&OsStr) -> bool,
) -> Vec<OsString> {
    let end = arguments.iter().position(|it| it == NAMES);
    let mut all = arguments;
    let names = all.split_off(end.unwrap_or(all.len()));
    let (mut others, mut moved) = (Vec::new(), Vec::new());
    let mut rest = all.into_iter();
    while let Some(argument) = rest.next() {
        if argument == OPTION {
            moved.push(argument);
            moved.extend(rest.next());
        } else if value_within(&argument, OPTION).is_some() {
            moved.push(argument);
        } else {
            others.push(argument);
        }
    }
    let last = others.last().filter(|_| others.len() > 1);
    let after = match last.is_some_and(|last| is_option(last)) {
        true => place_of_command(&others, is_command),
        false => others.len(),
    };
    let rest = others.split_off(after);
    others.extend(moved);
    others.extend(rest);
    others.extend(names);
    others
}

/// Returns the index after the first command, or after a word at the start, or else in front.
fn place_of_command(arguments: &[OsString], is_command: impl Fn(&OsStr) -> bool) -> usize {
    let mut words = arguments.iter().skip(1);
    let begins_with_word = words.clone().next().is_some_and(|first| !is_option(first));
    let command = words.position(|word| is_command(word));
    1 + command.map_or(usize::from(begins_with_word), |at| at + 1)
}

fn is_option(argument: &OsStr) -> bool {
    let text = argument.to_string_lossy();
    text.starts_with('-') && text != "-"
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ordered(line: &str) -> String {
        let words = line.split(' ').map(OsString::from).collect();
        let arguments = with_language_moved(words, |word| word == "table");
        let text = |word: OsString| word.into_string().unwrap();
        let arguments: Vec<String> = arguments.into_iter().map(text).collect();
        arguments.join(" ")
    }

    #[test]
    fn the_language_may_stand_anywhere() {
        for (typed, read) in [
            (
                "krank --language tr table x --at 6",
                "krank table x --at 6 --language tr",
            ),
            (
                "krank --language tr table x --at",
                "krank table --language tr x --at",
            ),
            (
                "krank table --language=tr x -",
                "krank table x - --language=tr",
            ),
            ("krank --language=en x", "krank x --language=en"),
            (
                "krank --language en --print x",
                "krank --print x --language en",
            ),
            (
                "krank --language en x --print",
                "krank x --language en --print",
            ),
            ("krank --print --language en", "krank --language en --print"),
            ("krank x --language", "krank x --language"),
            ("krank --language", "krank --language"),
            ("krank -- --language tr", "krank -- --language tr"),
            ("krank --language tr -- x", "krank --language tr -- x"),
        ] {
            assert_eq!(ordered(typed), read, "{typed}");
        }
    }
}
