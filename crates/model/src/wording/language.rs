//! The current language: English by default.

use super::Language;

/// The environment variables for the language of messages, in POSIX order of precedence.
const LOCALE: [&str; 3] = ["LC_ALL", "LC_MESSAGES", "LANG"];

impl Language {
    /// Returns the language with this name.
    pub fn named(name: &str) -> Option<Language> {
        Language::ALL.into_iter().find(|it| it.name() == name)
    }

    /// Returns the language of the locale in the environment `env`; an empty variable counts as
    /// unset.
    pub fn of_locale(env: impl Fn(&str) -> Option<String>) -> Language {
        let set = |name| env(name).filter(|value| !value.is_empty());
        let locale = LOCALE.into_iter().find_map(set).unwrap_or_default();
        let spoken = locale.split(['_', '.', '@', '-']).next();
        Language::named(&spoken.unwrap_or_default().to_ascii_lowercase()).unwrap_or_default()
    }

    /// Returns the next language, cyclically.
    #[must_use]
    pub fn next(self) -> Language {
        Language::ALL[(self as usize + 1) % Language::ALL.len()]
    }

    /// Returns the current language.
    #[must_use]
    pub fn current_language() -> Language {
        spoken::get()
    }

    /// Makes this the current language.
    pub fn speak(self) {
        spoken::set(self);
    }

    /// Capitalizes the first letter of a text; in Turkish, `i` becomes `İ`.
    #[must_use]
    pub fn capitalised(self, text: &str) -> String {
        let mut letters = text.chars();
        let first = match (self, letters.next()) {
            (_, None) => return String::new(),
            (Language::Turkish, Some('i')) => "İ".to_owned(),
            (_, Some(first)) => first.to_uppercase().to_string(),
        };
        first + letters.as_str()
    }
}

/// The current language of the process, shared by all threads.
#[cfg(not(test))]
mod spoken {
    use super::Language;
    use std::sync::atomic::{AtomicUsize, Ordering};

    /// The index of the language in [`Language::ALL`].
    static CURRENT_LANGUAGE: AtomicUsize = AtomicUsize::new(0);

    pub(super) fn get() -> Language {
        let number = CURRENT_LANGUAGE.load(Ordering::Relaxed);
        Language::ALL.get(number).copied().unwrap_or_default()
    }

    pub(super) fn set(language: Language) {
        CURRENT_LANGUAGE.store(language as usize, Ordering::Relaxed);
    }
}

/// The current language of each test thread, because tests run in parallel.
#[cfg(test)]
mod spoken {
    use super::Language;
    use std::cell::Cell;

    thread_local!(static CURRENT_LANGUAGE: Cell<Language> = const { Cell::new(Language::English) });

    pub(super) fn get() -> Language {
        CURRENT_LANGUAGE.get()
    }

    pub(super) fn set(language: Language) {
        CURRENT_LANGUAGE.set(language);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn locale_variables_select_language_by_posix_precedence() {
        let of = |set: &[(&str, &str)]| {
            Language::of_locale(|name| {
                let found = set.iter().find(|(n, _)| *n == name);
                found.map(|(_, value)| (*value).to_owned())
            })
        };
        let turkish = ("LANG", "tr_TR.UTF-8");
        assert_eq!(of(&[]), Language::English);
        assert_eq!(of(&[turkish]), Language::Turkish);
        assert_eq!(of(&[("LANG", "tr")]), Language::Turkish);
        assert_eq!(of(&[("LC_MESSAGES", "tr_CY")]), Language::Turkish);
        assert_eq!(of(&[turkish, ("LC_ALL", "C")]), Language::English);
        assert_eq!(of(&[turkish, ("LC_ALL", "")]), Language::Turkish);
        assert_eq!(of(&[turkish, ("LC_MESSAGES", "POSIX")]), Language::English);
        let both = [("LC_ALL", "tr_TR@euro"), ("LANG", "de_DE.UTF-8")];
        assert_eq!(of(&both), Language::Turkish);
        // `LC_CTYPE` is about characters, not messages; `trv` is a language of Taiwan.
        assert_eq!(of(&[("LC_CTYPE", "tr_TR.UTF-8")]), Language::English);
        assert_eq!(of(&[("LANG", "trv_TW.UTF-8")]), Language::English);
    }

    #[test]
    fn next_visits_all_languages_in_turn() {
        assert_eq!(Language::ALL.map(|language| language as usize), [0, 1]);
        assert_eq!(Language::English.next(), Language::Turkish);
        assert_eq!(Language::Turkish.next(), Language::English);
    }

    #[test]
    fn capitalised_follows_rules_of_each_language() {
        let turkish = |text| Language::Turkish.capitalised(text);
        assert_eq!(turkish("ivme"), "İvme");
        assert_eq!(turkish("ısı") + &turkish("şase"), "IsıŞase");
        assert_eq!(Language::English.capitalised("in all"), "In all");
        assert_eq!(turkish(""), "");
    }
}
