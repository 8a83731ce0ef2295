//! What the help shows: the keys, and of these what a person searches for; or a topic of the manual, and where in
//! it one reads.

use super::keys::groups;
use super::{finding, page};
use crate::manual::{self, SearchWords, TOPICS, Topic};
use crate::tui::app::View;
use crate::tui::commands::action;
use crate::tui::commands::keymap::Keymap;
use crate::tui::commands::keywords::keywords;
use crate::tui::commands::line::EditLine;
use crate::wording::{Language, words};

/// The help overlay.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Help {
    /// Lines that it is scrolled by.
    pub(crate) scroll: usize,
    /// Whether it lies over the list of candidates, and leads back there.
    pub(crate) over_candidates: bool,
    /// 0 for the keys; else a topic, by its place in the manual from 1 on.
    page: usize,
    search: Option<TextSearch>,
    /// The line of the topic that was found, on a screen of so many columns.
    found: Option<(u16, usize)>,
    /// Whether no topic has the words that are typed.
    nowhere: bool,
    /// The topic in lines, and of which page, how many columns and which language they are.
    reading: Vec<manual::ManualLine>,
    laid_out: (usize, u16, Language),
}

/// What is searched for.
#[derive(Clone, Debug, PartialEq, Eq)]
struct TextSearch {
    line: EditLine,
    /// Whether keys are typed into the line.
    typing: bool,
    /// The page and line where one read when the search began, to go back to; `None` once one has read on from what
    /// was found.
    from: Option<(usize, usize)>,
}

/// A line of the help.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum HelpLine {
    /// Between two groups.
    Blank,
    /// What the keys below are for.
    Title(&'static str),
    /// Keys, and what they do.
    Keys(String, &'static str),
}

impl Help {
    /// Over the list of candidates.
    pub(crate) fn over_candidates() -> Help {
        Help {
            over_candidates: true,
            ..Help::default()
        }
    }

    /// A topic, by its place in the manual, where it tells of words that were sought.
    pub(crate) fn telling(topic: usize, words: &str, columns: u16, keymap: &Keymap) -> Help {
        let mut help = Help {
            page: topic + 1,
            ..Help::default()
        };
        help.search();
        if let Some(line) = help.typed() {
            words.chars().for_each(|c| line.push(c));
        }
        help.seek(false, columns, keymap);
        help.accept();
        help
    }

    /// The place of the topic in the manual from 1 on; 0 for the keys.
    pub(crate) fn page(&self) -> usize {
        self.page
    }

    /// The topic that is shown in the place of the keys.
    pub(crate) fn topic(&self) -> Option<&'static Topic> {
        TOPICS.get(self.page.checked_sub(1)?)
    }

    /// Turns to the topic that follows, or to the one before: from the last to the keys.
    pub(crate) fn turn(&mut self, back: bool) {
        let pages = TOPICS.len() + 1;
        let by = if back { pages - 1 } else { 1 };
        self.page = (self.page + by) % pages;
        self.show_all();
    }

    /// The line of the topic that was found, on a screen of so many columns.
    pub(crate) fn found(&self, columns: u16) -> Option<usize> {
        let (of, line) = self.found?;
        (of == columns).then_some(line)
    }

    /// Lays out the topic on a screen of so many columns, unless that is done.
    pub(crate) fn lay_out(&mut self, columns: u16, keymap: &Keymap) {
        let wanted = (self.page, columns, Language::spoken());
        if self.laid_out != wanted {
            let lines = |topic| page::lines_of(topic, columns, keymap);
            self.reading = self.topic().map(lines).unwrap_or_default();
            self.laid_out = wanted;
        }
    }

    /// The topic as it was laid out.
    pub(super) fn reading(&self) -> &[manual::ManualLine] {
        &self.reading
    }

    /// Goes to the words that are typed: to the first place from where one read, or to the next one and stays there;
    /// back to where one read if there is none.
    pub(crate) fn seek(&mut self, is_next: bool, columns: u16, keymap: &Keymap) {
        let here = (self.page, self.scroll);
        let found = self.found(columns).filter(|_| is_next);
        let behind = found.map(|line| (self.page, line + 1));
        let Some(search) = self.search.as_mut().filter(|_| self.page > 0) else {
            return;
        };
        let from = *search.from.get_or_insert(here);
        let text = search.line.text();
        let (words, is_asked) = (SearchWords::new(text), !text.trim().is_empty());
        let found = match is_asked {
            true => finding::next(&words, behind.unwrap_or(from), columns, keymap),
            false => None,
        };
        if is_next && found.is_some() {
            search.from = None;
        }
        (self.page, self.scroll) = found.unwrap_or(from);
        self.found = found.map(|(_, line)| (columns, line));
        self.nowhere = is_asked && found.is_none();
    }

    /// What is found is read on: the way back is forgotten.
    pub(crate) fn stay(&mut self) {
        if let Some(search) = &mut self.search {
            search.from = None;
        }
    }

    /// Whether no topic has the words that are typed.
    pub(crate) fn is_nowhere(&self) -> bool {
        self.nowhere
    }

    /// Ends the search: all keys are shown again, and of a topic what one read before.
    pub(crate) fn leave_search(&mut self) {
        let here = (self.page, self.scroll);
        let from = self.search.as_ref().and_then(|search| search.from);
        self.show_all();
        if self.page > 0 {
            (self.page, self.scroll) = from.unwrap_or(here);
        }
    }

    /// Begins to search, or goes on with it.
    pub(crate) fn search(&mut self) {
        let line = match self.search.take() {
            Some(search) => search.line,
            None => EditLine::for_words(),
        };
        self.search = Some(TextSearch {
            line,
            typing: true,
            from: Some((self.page, self.scroll)),
        });
    }

    /// The line that is typed into.
    pub(crate) fn typed(&mut self) -> Option<&mut EditLine> {
        let search = self.search.as_mut().filter(|search| search.typing)?;
        Some(&mut search.line)
    }

    /// Whether keys are typed.
    pub(crate) fn is_typing(&self) -> bool {
        self.search.as_ref().is_some_and(|search| search.typing)
    }

    /// Ends the typing: what was found stays.
    pub(crate) fn accept(&mut self) {
        match &mut self.search {
            Some(search) if !search.line.text().trim().is_empty() => search.typing = false,
            _ => self.search = None,
        }
    }

    /// Shows all keys again. False if it did before.
    pub(crate) fn show_all(&mut self) -> bool {
        self.scroll = 0;
        (self.found, self.nowhere) = (None, false);
        self.search.take().is_some()
    }

    /// What is searched for.
    pub(crate) fn words(&self) -> Option<&str> {
        self.search.as_ref().map(|search| search.line.text())
    }

    /// The lines in a view: none where no key does what is searched for.
    pub(crate) fn lines(&self, view: View, keymap: &Keymap) -> Vec<HelpLine> {
        let wanted = self.words().filter(|text| !text.trim().is_empty());
        let wanted = wanted.map(SearchWords::new);
        let mut lines = Vec::new();
        for (title, entries) in groups(Some(view)) {
            let rows = entries.into_iter().filter_map(|entry| {
                let keys = keymap.keys(entry.action);
                let row = (action::listed(keys), (entry.help)(words()));
                let sought = keywords(entry.action);
                let texts = [&row.0, row.1, (entry.hint)(words()), title, sought];
                let is_meant = wanted.as_ref().is_none_or(|it| it.are_in(&texts));
                (is_meant && !keys.is_empty()).then_some(row)
            });
            let mut rows = rows.peekable();
            if rows.peek().is_none() {
                continue;
            }
            if !lines.is_empty() {
                lines.push(HelpLine::Blank);
            }
            lines.push(HelpLine::Title(title));
            lines.extend(rows.map(|(keys, help)| HelpLine::Keys(keys, help)));
        }
        lines
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn searched(words: &str) -> Vec<HelpLine> {
        let mut help = Help::default();
        help.search();
        let line = help.typed().unwrap();
        words.chars().for_each(|c| line.push(c));
        help.lines(View::Motion, &Keymap::default())
    }

    #[test]
    fn keys_of_current_view_come_first() {
        let lines = Help::default().lines(View::Scene, &Keymap::default());
        assert_eq!(lines[0], HelpLine::Title("In the scene view"));
        let lines = Help::default().lines(View::Working, &Keymap::default());
        assert_eq!(lines[0], HelpLine::Title("The motion"));
    }

    #[test]
    fn search_requires_all_words_in_any_order() {
        let keys = |lines: Vec<HelpLine>| -> Vec<String> {
            let keys = lines.into_iter().filter_map(|line| match line {
                HelpLine::Keys(keys, _) => Some(keys),
                HelpLine::Blank | HelpLine::Title(_) => None,
            });
            keys.collect()
        };
        assert_eq!(keys(searched("VELOCITY arrows")), ["v"]);
        assert_eq!(keys(searched("f2")), ["I F2"]);
        assert!(keys(searched("scene")).len() > 3, "the group counts too");
        assert_eq!(searched("coffee"), []);
    }

    /// A key can change the language while a topic is open.
    #[test]
    fn language_change_lays_out_topic_again() {
        let (mut help, keymap) = (Help::default(), Keymap::default());
        help.turn(false);
        let mut first = |language: Language| {
            language.speak();
            help.lay_out(80, &keymap);
            help.reading()[0].text.clone()
        };
        let english = first(Language::English);
        assert_ne!(first(Language::Turkish), english);
        assert_eq!(first(Language::English), english);
    }

    #[test]
    fn actions_without_keys_are_not_listed() {
        let mut keymap = Keymap::default();
        let before = Help::default().lines(View::Motion, &keymap).len();
        keymap.set(action::Action::Reverse, Vec::new());
        let after = Help::default().lines(View::Motion, &keymap).len();
        assert_eq!(after, before - 1);
    }
}
