//! Which language the program speaks. It must be known before anything is said: the help that is built from the
//! command line's own description is said too, so that the option is looked for before that is read.

use super::args::LanguageChoice;
use crate::wording::Language;
use clap::ValueEnum;
use std::ffi::{OsStr, OsString};
use std::path::PathBuf;

/// Speaks the language that is asked for, configured, or that of the locale. The arguments come back with the
/// option behind all others, where every command takes it.
pub(super) fn settle(arguments: Vec<OsString>) -> Vec<OsString> {
    let configured = configured(value_of(&arguments, "--config").map(PathBuf::from));
    let (arguments, asked) = with_language_last(arguments);
    let asked = asked.and_then(|name| LanguageChoice::from_str(name.to_str()?, false).ok());
    let asked = asked.and_then(LanguageChoice::asked);
    let env = |name: &str| Some(std::env::var_os(name)?.to_string_lossy().into_owned());
    let language = asked.or(configured);
    language.unwrap_or_else(|| Language::of_locale(env)).speak();
    arguments
}

#[cfg(feature = "tui")]
fn configured(named: Option<PathBuf>) -> Option<Language> {
    super::config::language(named.as_deref())
}

/// The workbench alone has a configuration.
#[cfg(not(feature = "tui"))]
fn configured(_: Option<PathBuf>) -> Option<Language> {
    None
}

const OPTION: &str = "--language";
/// Behind this everything is a name.
const NAMES: &str = "--";

/// What is given to an option that has a value, as `--option value` or `--option=value`.
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

/// The arguments with each `--language` behind the others, and what it is given: before a command the option
/// would make a scene of the command's name.
fn with_language_last(arguments: Vec<OsString>) -> (Vec<OsString>, Option<OsString>) {
    let asked = value_of(&arguments, OPTION);
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
    others.extend(moved);
    others.extend(names);
    (others, asked)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ordered(line: &str) -> (String, Option<String>) {
        let words = line.split(' ').map(OsString::from).collect();
        let (arguments, asked) = with_language_last(words);
        let text = |word: OsString| word.into_string().unwrap();
        let arguments: Vec<String> = arguments.into_iter().map(text).collect();
        (arguments.join(" "), asked.map(text))
    }

    #[test]
    fn the_language_may_stand_anywhere() {
        let told = |line: &str, asked: &str| (line.to_owned(), Some(asked.to_owned()));
        assert_eq!(
            ordered("krank --language tr table x --at 6"),
            told("krank table x --at 6 --language tr", "tr")
        );
        assert_eq!(
            ordered("krank --language=en x"),
            told("krank x --language=en", "en")
        );
        assert_eq!(
            ordered("krank x --language"),
            ("krank x --language".into(), None)
        );
        let names = "krank -- --language tr";
        assert_eq!(ordered(names), (names.into(), None));
        assert_eq!(
            ordered("krank --language tr -- x"),
            told("krank --language tr -- x", "tr")
        );
    }
}
