//! Keeps the state of the help: the list of keys or a topic of the manual, the scroll position, and the search in them.

use super::keys::groups;
use super::{page, search};
use crate::manual::{self, SearchWords, TOPICS, Topic};
use crate::tui::app::View;
use crate::tui::commands::action::{self, Action, ActionRow, KeyContext, entry_of};
use crate::tui::commands::key::Key;
use crate::tui::commands::keymap::Keymap;
use crate::tui::commands::keywords::keywords;
use crate::tui::commands::line::EditLine;
use crate::wording::{Language, words};

/// The help overlay.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Help {
    /// The scroll position, in lines.
    pub(crate) scroll: usize,
    /// Whether the help was opened from the list of candidates, and returns to it when closed.
    pub(crate) returns_to_candidates: bool,
    /// 0 for the list of keys, or else the number of a topic in [`TOPICS`], counted from 1.
    page: usize,
    /// The search; `None` if there is none.
    search: Option<TextSearch>,
    /// The matched line of the topic: the columns of its layout, and the line's index in this layout.
    found: Option<(u16, usize)>,
    /// Whether the typed words occur in no topic.
    nowhere: bool,
    /// The laid-out lines of the topic.
    reading: Vec<manual::ManualLine>,
    /// The page, columns and language of the layout in `reading`.
    laid_out: (usize, u16, Language),
}

/// A search in the help.
#[derive(Clone, Debug, PartialEq, Eq)]
struct TextSearch {
    /// The searched words.
    line: EditLine,
    /// Whether keys edit the line.
    typing: bool,
    /// The page and scroll position when the search began, restored if it fails or ends. `None` once the user reads
    /// on from a match.
    from: Option<(usize, usize)>,
}

/// A line of the help.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum HelpLine {
    /// A blank line between two groups.
    Blank,
    /// The title of a group of keys.
    Title(&'static str),
    /// Keys, and a description of their action.
    Keys(String, &'static str),
    /// Keys that do nothing in the current view, and their action in another one.
    KeysElsewhere(String, &'static str),
}

impl Help {
    /// Creates the help over the list of candidates.
    pub(crate) fn over_candidates() -> Help {
        Help {
            returns_to_candidates: true,
            ..Help::default()
        }
    }

    /// Opens the topic with this index in [`TOPICS`], at its first passage with the searched words.
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

    /// Returns the number of the topic in the manual, counted from 1; 0 for the list of keys.
    pub(crate) fn page(&self) -> usize {
        self.page
    }

    /// Returns the open topic; `None` for the list of keys.
    pub(crate) fn topic(&self) -> Option<&'static Topic> {
        TOPICS.get(self.page.checked_sub(1)?)
    }

    /// Turns to the next topic, or back to the one before. The list of keys follows the last topic. Ends the search.
    pub(crate) fn turn(&mut self, back: bool) {
        let pages = TOPICS.len() + 1;
        let by = if back { pages - 1 } else { 1 };
        self.page = (self.page + by) % pages;
        self.show_all();
    }

    /// Returns the index of the matched line in the layout for so many columns. Returns `None` if there is no match in
    /// this layout.
    pub(crate) fn found(&self, columns: u16) -> Option<usize> {
        let (of, line) = self.found?;
        (of == columns).then_some(line)
    }

    /// Lays out the topic for a screen of so many columns, if the last layout does not fit.
    pub(crate) fn layout_topic(&mut self, columns: u16, keymap: &Keymap) {
        let wanted = (self.page, columns, Language::current_language());
        if self.laid_out != wanted {
            let lines = |topic| page::lines_of(topic, columns, keymap);
            self.reading = self.topic().map(lines).unwrap_or_default();
            self.laid_out = wanted;
        }
    }

    /// Returns the laid-out lines of the topic; empty for the list of keys.
    pub(super) fn reading(&self) -> &[manual::ManualLine] {
        &self.reading
    }

    /// Jumps to the first passage with the typed words, from the position at which the search began.
    ///
    /// If `is_next`, jumps to the passage after the current match instead, and forgets that position. If there is no
    /// such passage, returns to that position.
    pub(crate) fn seek(&mut self, is_next: bool, columns: u16, keymap: &Keymap) {
        let here = (self.page, self.scroll);
        let found = self.found(columns).filter(|_| is_next);
        let after = found.map(|line| (self.page, line + 1));
        let Some(search) = self.search.as_mut().filter(|_| self.page > 0) else {
            return;
        };
        let from = *search.from.get_or_insert(here);
        let text = search.line.text();
        let (words, is_asked) = (SearchWords::new(text), !text.trim().is_empty());
        let found = match is_asked {
            true => search::next(&words, after.unwrap_or(from), columns, keymap),
            false => None,
        };
        if is_next && found.is_some() {
            search.from = None;
        }
        (self.page, self.scroll) = found.unwrap_or(from);
        self.found = found.map(|(_, line)| (columns, line));
        self.nowhere = is_asked && found.is_none();
    }

    /// Forgets the position at which the search began, because the user reads on from the match.
    pub(crate) fn stay(&mut self) {
        if let Some(search) = &mut self.search {
            search.from = None;
        }
    }

    /// Returns `true` if the typed words occur in no topic.
    pub(crate) fn is_nowhere(&self) -> bool {
        self.nowhere
    }

    /// Ends the search. Shows all keys again, or the position in the topic at which the search began.
    pub(crate) fn end_search_view(&mut self) {
        let here = (self.page, self.scroll);
        let from = self.search.as_ref().and_then(|search| search.from);
        self.show_all();
        if self.page > 0 {
            (self.page, self.scroll) = from.unwrap_or(here);
        }
    }

    /// Starts a search, or continues to edit the words of the current one.
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

    /// Returns the edited line of the search; `None` if keys are not typed into it.
    pub(crate) fn typed(&mut self) -> Option<&mut EditLine> {
        let search = self.search.as_mut().filter(|search| search.typing)?;
        Some(&mut search.line)
    }

    /// Returns `true` if keys edit the words of a search.
    pub(crate) fn is_typing(&self) -> bool {
        self.search.as_ref().is_some_and(|search| search.typing)
    }

    /// Ends the editing of the words and keeps the results; without words, ends the search.
    pub(crate) fn accept(&mut self) {
        match &mut self.search {
            Some(search) if !search.line.text().trim().is_empty() => search.typing = false,
            _ => self.search = None,
        }
    }

    /// Ends the search and scrolls to the top. Returns `false` if there was no search.
    pub(crate) fn show_all(&mut self) -> bool {
        self.scroll = 0;
        (self.found, self.nowhere) = (None, false);
        self.search.take().is_some()
    }

    /// Returns the searched words; `None` without a search.
    pub(crate) fn words(&self) -> Option<&str> {
        self.search.as_ref().map(|search| search.line.text())
    }

    /// Returns the list of keys for a view; empty if the search matches no action with a key. `has_drawing` says
    /// whether a drawing is visible, whose keys then work too.
    pub(crate) fn lines(&self, view: View, has_drawing: bool, keymap: &Keymap) -> Vec<HelpLine> {
        let wanted = self.words().filter(|text| !text.trim().is_empty());
        let wanted = wanted.map(SearchWords::new);
        let mut lines = Vec::new();
        let groups = match self.returns_to_candidates {
            true => candidate_groups(keymap),
            false => view_groups(view, has_drawing, keymap),
        };
        for (title, rows) in groups {
            let mut rows = rows.into_iter().filter(|row| {
                let texts = [&row.keys, row.help, row.hint, title, row.query];
                let is_meant = wanted.as_ref().is_none_or(|it| it.are_in(&texts));
                is_meant && !row.keys.is_empty()
            });
            let Some(first) = rows.next() else {
                continue;
            };
            if !lines.is_empty() {
                lines.push(HelpLine::Blank);
            }
            lines.push(HelpLine::Title(title));
            let rows = std::iter::once(first).chain(rows);
            lines.extend(rows.map(|row| match row.works_here {
                true => HelpLine::Keys(row.keys, row.help),
                false => HelpLine::KeysElsewhere(row.keys, row.help),
            }));
        }
        lines
    }
}

/// The keys of an action, with its texts.
struct KeyRow {
    keys: String,
    help: &'static str,
    hint: &'static str,
    /// Further words that a search finds.
    query: &'static str,
    works_here: bool,
}

impl KeyRow {
    fn of(entry: &ActionRow, works_here: bool, keymap: &Keymap) -> KeyRow {
        KeyRow {
            keys: action::listed(keymap.keys(entry.action)),
            help: (entry.help)(words()),
            hint: (entry.hint)(words()),
            query: keywords(entry.action),
            works_here,
        }
    }

    fn new(keys: String, help: &'static str) -> KeyRow {
        KeyRow {
            keys,
            help,
            hint: "",
            query: "",
            works_here: true,
        }
    }
}

type KeyGroups = Vec<(&'static str, Vec<KeyRow>)>;

/// Returns the keys of all views, those of `view` first.
fn view_groups(view: View, has_drawing: bool, keymap: &Keymap) -> KeyGroups {
    let works = |place: KeyContext| {
        place.covers(view) || (has_drawing && place == KeyContext::In(View::Motion))
    };
    let rows = |entries: Vec<&'static ActionRow>| {
        let rows = entries.into_iter();
        let rows = rows.map(|entry| KeyRow::of(entry, works(entry.place), keymap));
        rows.collect()
    };
    let groups = groups(Some(view)).into_iter();
    groups
        .map(|(title, entries)| (title, rows(entries)))
        .collect()
}

/// Returns the keys of the list of linkages that a synthesis has found.
fn candidate_groups(keymap: &Keymap) -> KeyGroups {
    let keys = |actions: &[Action]| {
        let keys: Vec<Key> = actions
            .iter()
            .flat_map(|action| keymap.keys(*action))
            .copied()
            .collect();
        action::listed(&keys)
    };
    let own = vec![
        KeyRow::new(Key::Enter.to_string(), words().open_the_linkage()),
        KeyRow::new(
            keys(&[Action::NextView, Action::PreviousView]),
            words().pages_of_candidates(),
        ),
        KeyRow::new(keys(&[Action::StepForward]), words().next_point_of_task()),
        KeyRow::new(keys(&[Action::StepBack]), words().point_before_of_task()),
    ];
    let rows = |actions: &[Action]| {
        let rows = actions
            .iter()
            .map(|action| KeyRow::of(entry_of(*action), true, keymap));
        rows.collect::<Vec<KeyRow>>()
    };
    let title = words().in_the_candidates();
    let own = own.into_iter().chain(rows(&[Action::Play]));
    let lists = rows(&[
        Action::LineUp,
        Action::LineDown,
        Action::PageUp,
        Action::PageDown,
        Action::HalfUp,
        Action::HalfDown,
        Action::Top,
        Action::End,
    ]);
    let program = rows(&[
        Action::Help,
        Action::Back,
        Action::Redraw,
        Action::Suspend,
        Action::Leave,
    ]);
    vec![
        (title, own.collect()),
        (words().lists(), lists),
        (words().the_program(), program),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn searched(words: &str) -> Vec<HelpLine> {
        let mut help = Help::default();
        help.search();
        let line = help.typed().unwrap();
        words.chars().for_each(|c| line.push(c));
        help.lines(View::Motion, false, &Keymap::default())
    }

    #[test]
    fn keys_of_current_view_come_first() {
        let lines = Help::default().lines(View::Scene, false, &Keymap::default());
        assert_eq!(lines[0], HelpLine::Title("In the scene view"));
        let lines = Help::default().lines(View::Working, false, &Keymap::default());
        assert_eq!(lines[0], HelpLine::Title("The motion"));
    }

    #[test]
    fn search_requires_all_words_in_any_order() {
        let keys = |lines: Vec<HelpLine>| -> Vec<String> {
            let keys = lines.into_iter().filter_map(|line| match line {
                HelpLine::Keys(keys, _) | HelpLine::KeysElsewhere(keys, _) => Some(keys),
                HelpLine::Blank | HelpLine::Title(_) => None,
            });
            keys.collect()
        };
        assert_eq!(keys(searched("VELOCITY arrows")), ["v"]);
        assert_eq!(keys(searched("f2")), ["I F2"]);
        assert!(keys(searched("scene")).len() > 3, "the group counts too");
        assert_eq!(searched("coffee"), []);
    }

    #[test]
    fn keys_of_other_views_are_marked() {
        let works = |lines: Vec<HelpLine>, keys: &str| {
            let of = |own: &String| own == keys;
            let found = lines.iter().find_map(|line| match line {
                HelpLine::Keys(own, _) if of(own) => Some(true),
                HelpLine::KeysElsewhere(own, _) if of(own) => Some(false),
                _ => None,
            });
            found.unwrap()
        };
        let keymap = Keymap::default();
        let lines = |view, has_drawing| Help::default().lines(view, has_drawing, &keymap);
        for (view, has_drawing, keys, is_working) in [
            (View::Motion, true, "v", true),
            (View::Plots, false, "v", false),
            (View::Plots, true, "v", true),
            (View::Scene, true, "{", true),
            (View::Motion, true, "{", false),
            (View::Motion, true, ".", true),
        ] {
            let keys = match keys {
                "." => ". Right l",
                _ => keys,
            };
            assert_eq!(works(lines(view, has_drawing), keys), is_working, "{keys}");
        }
    }

    #[test]
    fn help_over_candidates_lists_their_keys_only() {
        let lines = Help::over_candidates().lines(View::Motion, true, &Keymap::default());
        assert_eq!(lines[0], HelpLine::Title("In the list of linkages"));
        let has = |text: &str| {
            let mut lines = lines.iter();
            lines.any(|line| matches!(line, HelpLine::Keys(_, help) if *help == text))
        };
        assert!(has("play or pause") && has("open the linkage"));
        assert!(!has("undo the last edit") && !has("zoom in"), "{lines:?}");
    }

    /// A key can change the language while a topic is open.
    #[test]
    fn language_change_lays_out_topic_again() {
        let (mut help, keymap) = (Help::default(), Keymap::default());
        help.turn(false);
        let mut first = |language: Language| {
            language.speak();
            help.layout_topic(80, &keymap);
            help.reading()[0].text.clone()
        };
        let english = first(Language::English);
        assert_ne!(first(Language::Turkish), english);
        assert_eq!(first(Language::English), english);
    }

    #[test]
    fn actions_without_keys_are_not_listed() {
        let mut keymap = Keymap::default();
        let before = Help::default().lines(View::Motion, false, &keymap).len();
        keymap.set(action::Action::Reverse, Vec::new());
        let after = Help::default().lines(View::Motion, false, &keymap).len();
        assert_eq!(after, before - 1);
    }
}
