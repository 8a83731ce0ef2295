//! The commands that are listed: all of the table of actions, narrowed by what is typed, the best first; behind them the
//! topics of the manual that tell of it.

use crate::document::with_ascii_letters;
use crate::manual::{SearchWords, TOPICS, Topic};
use crate::tui::commands::action::{self, Action, ActionRow};
use crate::tui::commands::keywords::keywords;
use crate::tui::commands::line::EditLine;
use crate::wording::words;

/// What is listed.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Listed {
    Command(&'static ActionRow),
    /// A topic of the manual, and its place there.
    Topic(usize, &'static Topic),
}

/// What a word costs that a command is looked for by: more than letters of its name.
const KEYWORD: usize = 1000;

/// All commands, narrowed by what is searched for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct CommandList {
    line: EditLine,
    /// By their places in the table, the best first.
    found: Vec<usize>,
    /// By their places in the manual.
    topics: Vec<usize>,
    cursor: usize,
}

impl CommandList {
    pub(crate) fn new() -> CommandList {
        let mut palette = CommandList {
            line: EditLine::for_words(),
            found: Vec::new(),
            topics: Vec::new(),
            cursor: 0,
        };
        palette.narrow();
        palette
    }

    pub(crate) fn typed(&self) -> &str {
        self.line.text()
    }

    /// The line that is typed into; [`CommandList::narrow`] has to follow.
    pub(crate) fn line(&mut self) -> &mut EditLine {
        &mut self.line
    }

    /// Lists what is meant by what is typed: the best first, of these the shortest, and otherwise as in the table.
    pub(crate) fn narrow(&mut self) {
        let typed = plain(self.line.text());
        let costs = rows().enumerate().filter_map(|(at, row)| {
            let texts = [row.name, (row.hint)(words()), (row.help)(words())];
            let costs = texts
                .iter()
                .filter_map(|text| Some((cost(&typed, text)?, text.chars().count())));
            let sought = || keyword_cost(&typed, keywords(row.action));
            Some((costs.min().or_else(sought)?, at))
        });
        let mut costs: Vec<((usize, usize), usize)> = costs.collect();
        if !typed.trim().is_empty() {
            costs.sort_unstable();
        }
        self.found = costs.into_iter().map(|(_, at)| at).collect();
        self.topics = SearchWords::new(&typed).best_topics();
        self.cursor = 0;
    }

    /// What is listed.
    pub(crate) fn found(&self) -> impl Iterator<Item = Listed> {
        let commands = self.found.iter().filter_map(|at| rows().nth(*at));
        let topics = self.topics.iter();
        let topics = topics.filter_map(|at| Some(Listed::Topic(*at, TOPICS.get(*at)?)));
        commands.map(Listed::Command).chain(topics)
    }

    pub(crate) fn count(&self) -> usize {
        self.found.len() + self.topics.len()
    }

    pub(crate) fn cursor(&self) -> usize {
        self.cursor
    }

    /// What is under the cursor.
    pub(crate) fn chosen(&self) -> Option<Listed> {
        self.found().nth(self.cursor)
    }

    /// Moves the cursor, within the list.
    pub(crate) fn move_by(&mut self, rows: isize) {
        let most = self.count().saturating_sub(1);
        self.cursor = self.cursor.saturating_add_signed(rows).min(most);
    }
}

/// How far the words that a command is looked for by are from what is typed: one of them begins so. `None` where none does.
fn keyword_cost(typed: &str, sought: &str) -> Option<(usize, usize)> {
    let typed = typed.trim();
    let sought = plain(sought);
    let mut begun = sought.split(' ').filter(|word| word.starts_with(typed));
    let word = begun.next().filter(|_| !typed.is_empty())?;
    Some((KEYWORD, word.len()))
}

/// Every command but the list of commands itself.
fn rows() -> impl Iterator<Item = &'static ActionRow> {
    action::entries().filter(|row| row.action != Action::Palette)
}

/// In small letters of ASCII, for keyboards that have no others.
fn plain(text: &str) -> String {
    with_ascii_letters(text).to_ascii_lowercase()
}

/// How far a text is from what is typed, blanks left out: the letters must stand in it in their order, and each gap
/// between them costs, least where a word begins behind it. `None` where they do not.
fn cost(typed: &str, text: &str) -> Option<usize> {
    let text: Vec<char> = plain(text).chars().collect();
    let begins = |at: usize| at == 0 || !text[at - 1].is_alphanumeric();
    // What the letters so far cost, by where the last of them stands.
    let mut before: Option<Vec<Option<usize>>> = None;
    for letter in typed.chars().filter(|c| *c != ' ') {
        let step = |at: usize| {
            if text[at] != letter {
                return None;
            }
            let jump = if begins(at) { 1 } else { 3 };
            let Some(before) = &before else {
                return Some(if at == 0 { 0 } else { jump + 1 });
            };
            let from = (0..at).filter_map(|last| {
                let gap = if last + 1 == at { 0 } else { jump + at - last };
                Some(before[last]? + gap)
            });
            from.min()
        };
        before = Some((0..text.len()).map(step).collect());
    }
    match before {
        None => Some(0),
        Some(costs) => costs.into_iter().flatten().min(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wording::Language;

    fn found(typed: &str) -> Vec<&'static str> {
        let mut palette = CommandList::new();
        typed.chars().for_each(|c| palette.line().push(c));
        palette.narrow();
        let names = palette.found().filter_map(|listed| match listed {
            Listed::Command(row) => Some(row.name),
            Listed::Topic(..) => None,
        });
        names.collect()
    }

    fn topics(typed: &str) -> Vec<&'static str> {
        let mut palette = CommandList::new();
        typed.chars().for_each(|c| palette.line().push(c));
        palette.narrow();
        let topics = palette.topics.iter();
        topics.map(|at| TOPICS[*at].name).collect()
    }

    /// Words that no name and no help has lead to what does it, or to where the manual tells of it.
    #[test]
    fn words_of_the_trade_lead_somewhere() {
        Language::English.speak();
        for (typed, command, topic) in [
            ("toler", "lengths", "tolerances"),
            ("synth", "open", "synthesis"),
            ("task", "open", "synthesis"),
            ("param", "scene", "scene"),
            ("stage", "gather", ""),
            ("limit", "scene", "limits"),
            ("stroke", "choose-plots", "designs"),
        ] {
            assert!(
                found(typed).contains(&command),
                "{typed}: {:?}",
                found(typed)
            );
            let told = topics(typed);
            assert!(
                topic.is_empty() || told.contains(&topic),
                "{typed}: {told:?}"
            );
        }
        assert_eq!(topics("toler")[0], "tolerances");
        assert_eq!(topics(""), [""; 0]);
        Language::Turkish.speak();
        for (typed, command) in [
            ("sentez", "open"),
            ("parametre", "scene"),
            ("strok", "goal"),
        ] {
            assert!(
                found(typed).contains(&command),
                "{typed}: {:?}",
                found(typed)
            );
        }
        assert_eq!(topics("tolerans")[0], "tolerances");
        Language::English.speak();
    }

    #[test]
    fn a_command_is_found_by_its_name_in_every_language() {
        Language::Turkish.speak();
        for typed in ["language", "dil", "turkce"] {
            assert_eq!(found(typed)[0], "language", "{typed}");
        }
        assert_eq!(found("cozum")[0], "working");
        Language::English.speak();
        assert_eq!(found("language")[0], "language");
    }

    #[test]
    fn everything_is_listed_before_anything_is_typed() {
        assert_eq!(found("").len(), action::entries().count() - 1);
        assert_eq!(found("")[0], "play");
    }

    #[test]
    fn letters_in_their_order_are_enough_and_the_nearest_comes_first() {
        for (typed, name) in [
            ("zoom in", "zoom-in"),
            ("zi", "zoom-in"),
            ("forces", "forces"),
            ("PLAY", "play"),
            ("svg", "svg"),
            ("extrema", "extrema"),
            ("initial position", "opening"),
        ] {
            assert_eq!(found(typed).first(), Some(&name), "{typed}");
        }
        assert!(found("qzx").is_empty() && topics("qzx").is_empty());
    }

    /// Each command is found by its own name, and none stands before it but what is told by that very word.
    #[test]
    fn every_command_is_first_by_its_name() {
        for row in rows() {
            let name = found(row.name)[0];
            let first = rows().find(|other| other.name == name).unwrap();
            let told = (first.help)(words());
            assert!(
                first.name == row.name || told == row.name,
                "{}: {told}",
                row.name
            );
        }
    }
}
