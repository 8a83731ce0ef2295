//! The list of commands: the table of actions, filtered by the typed text, best matches first,
//! followed by the matching topics of the manual.

use crate::document::with_ascii_letters;
use crate::manual::SearchWords;
use crate::scene::{presets, with_point};
use crate::task_file::ExampleTask;
use crate::tui::appearance::palette::Theme;
use crate::tui::commands::action::{self, Action, ActionRow};
use crate::tui::commands::keywords::keywords;
use crate::tui::commands::line::EditLine;
use crate::tui::commands::list::List;
use crate::wording::words;

/// An entry of the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ListEntry {
    Command(Action),
    /// The topic of the manual with this index.
    Topic(usize),
    /// Saves the scene and quits.
    SaveAndQuit,
    /// Saves the scene to the typed file.
    SaveTo,
    /// Opens the typed file, or the preset of this name.
    OpenFile,
    /// Moves the driver to the typed coordinate.
    GoTo,
    /// Moves the selected input by this number of steps.
    Steps(i16),
    /// Switches the theme.
    Theme(Theme),
    /// Opens the preset with this index.
    Preset(usize),
    /// Makes the exercise of this seed from the scene.
    Exercise(u64),
    /// Searches for the linkages of the task with this index.
    Task(usize),
}

/// The cost of a keyword match, higher than that of any match in a command's name.
const KEYWORD: usize = 1000;

/// Maximum length of a text that is searched for, in bytes. A longer one is a file name or was
/// pasted, and comparing it with all commands at each key would delay the next key.
const MAX_SEARCHED: usize = 60;

/// All commands, filtered by the typed text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct CommandList {
    /// The typed text; [`CommandList::narrow`] must be called after a change.
    pub(crate) line: EditLine,
    /// The matching entries, the best first.
    pub(crate) list: List<ListEntry>,
}

impl CommandList {
    pub(crate) fn new() -> CommandList {
        let mut palette = CommandList {
            line: EditLine::for_command(),
            list: List::new(Vec::new()),
        };
        palette.narrow();
        palette
    }

    /// Returns the typed text behind the first word.
    pub(crate) fn argument(&self) -> &str {
        words_of(self.line.text()).1
    }

    /// Lists the matching commands: exact names and keys, then words of names, then beginnings of words, then the closest, then
    /// the shortest, and in the table's order if they are equal. Presets and tasks precede commands
    /// that merely contain the letters. Commands that the text spells out, such as `w` or `135`, come
    /// first. A text longer than all names lists only these.
    pub(crate) fn narrow(&mut self) {
        if self.line.text().len() > MAX_SEARCHED {
            self.list = List::new(spelled(self.line.text()));
            return;
        }
        let typed = plain(self.line.text());
        let costs = rows().enumerate().filter_map(|(at, row)| {
            let texts = [row.name, (row.hint)(words()), (row.help)(words())];
            let costs = texts
                .iter()
                .filter_map(|text| Some((cost(&typed, text)?, text.chars().count())));
            let query = || keyword_cost(&typed, keywords(row.action));
            if row
                .keys
                .iter()
                .any(|key| key.to_string() == self.line.text().trim())
            {
                return Some((NameRank::Name, (0, 0), at));
            }
            let rank = NameRank::of(typed.trim(), row.name, &texts);
            Some((rank, costs.min().or_else(query)?, at))
        });
        let mut costs: Vec<(NameRank, (usize, usize), usize)> = costs.collect();
        if !typed.trim().is_empty() {
            costs.sort_unstable();
        }
        let loose = costs.partition_point(|(rank, ..)| *rank < NameRank::Loose);
        let commands = |costs: &[(NameRank, (usize, usize), usize)]| {
            let rows = costs.iter().filter_map(|(.., at)| rows().nth(*at));
            let commands = rows.map(|row| ListEntry::Command(row.action));
            commands.collect::<Vec<ListEntry>>()
        };
        let topics = SearchWords::new(&typed).best_topics().into_iter();
        let mut listed = spelled(self.line.text());
        let found = commands(&costs[..loose]).into_iter();
        let found = found.chain(named(typed.trim()));
        let found = found.chain(commands(&costs[loose..]));
        let found = found.chain(topics.map(ListEntry::Topic));
        let others: Vec<ListEntry> = found.filter(|other| !listed.contains(other)).collect();
        listed.extend(others);
        self.list = List::new(listed);
    }
}

/// Splits a typed command into its first word and the rest.
fn words_of(typed: &str) -> (&str, &str) {
    let typed = typed.trim();
    let (word, rest) = typed.split_once(' ').unwrap_or((typed, ""));
    (word, rest.trim())
}

/// Returns the commands that the typed text spells out, as in vi.
fn spelled(typed: &str) -> Vec<ListEntry> {
    let number = |text: &str| with_point(text).and_then(|text| text.parse::<f64>().ok());
    let is_number = |text: &str| number(text.trim()).is_some_and(f64::is_finite);
    match words_of(typed) {
        ("w", "") => vec![ListEntry::Command(Action::Save)],
        ("wq", "") => vec![ListEntry::SaveAndQuit],
        ("q", "") => vec![ListEntry::Command(Action::Quit)],
        ("e", "") => vec![ListEntry::Command(Action::Open)],
        ("W", "") => vec![ListEntry::Command(Action::SaveAs)],
        ("w", _) => vec![ListEntry::SaveTo],
        ("e", _) => vec![ListEntry::OpenFile],
        (word, seed) if is_exercise(word) && (seed.is_empty() || seed.parse::<u64>().is_ok()) => {
            vec![ListEntry::Exercise(seed.parse().unwrap_or(1))]
        }
        ("theme" | "tema", name) => {
            let name = plain(name);
            let is_begun = |theme: &Theme| {
                let names = [theme.name(), theme.shown_name()];
                names.iter().any(|own| plain(own).starts_with(&name))
            };
            let intended = Theme::ALL.into_iter().filter(is_begun);
            intended.map(ListEntry::Theme).collect()
        }
        // A number of steps with the key of a step behind it, as after a count in vi.
        (count, "") if let Some(steps) = counted(count) => vec![steps, ListEntry::GoTo],
        (count, "") if let Ok(count @ 1..) = count.parse::<i16>() => {
            vec![
                ListEntry::GoTo,
                ListEntry::Steps(count),
                ListEntry::Steps(-count),
            ]
        }
        // A coordinate, or the name of an input and its coordinate.
        (_, rest) if is_number(typed) || is_number(rest) => vec![ListEntry::GoTo],
        _ => Vec::new(),
    }
}

/// Minimum number of letters of a word that finds a whole kind of entries.
const MIN_WORD: usize = 3;

/// Returns `true` if a word begins the name of exercises.
fn is_exercise(word: &str) -> bool {
    let names = ["exercise", words().exercise_name()];
    word.len() >= MIN_WORD
        && names
            .iter()
            .any(|name| plain(name).starts_with(&plain(word)))
}

/// Returns the steps of a count that ends with the usual key of a step: `10.` or `10,`.
fn counted(typed: &str) -> Option<ListEntry> {
    let (count, sign) = match typed.strip_suffix('.') {
        Some(count) => (count, 1),
        None => (typed.strip_suffix(',')?, -1),
    };
    let count = count.parse::<i16>().ok().filter(|count| *count > 0)?;
    Some(ListEntry::Steps(sign * count))
}

/// Returns the themes, presets and tasks in whose name a word begins with the typed text. The word
/// for synthesis finds all tasks, and that for themes all themes.
fn named(typed: &str) -> impl Iterator<Item = ListEntry> {
    let begins = move |name: &str| {
        let mut starts = std::iter::once(name).chain(name.split('-'));
        !typed.is_empty() && starts.any(|start| start.starts_with(typed))
    };
    let is_synthesis = keyword_cost(typed, words().synthesis_is_sought_by()).is_some();
    let presets = presets::all().iter().enumerate();
    let presets = presets.filter(move |(_, preset)| begins(preset.name));
    let tasks = ExampleTask::all().iter().enumerate();
    let tasks = tasks.filter(move |(_, task)| is_synthesis || begins(task.name));
    let presets = presets.map(|(at, _)| ListEntry::Preset(at));
    let themes = Theme::ALL.into_iter().filter(move |theme| {
        let names = [theme.name(), theme.shown_name()];
        let is_named = names.iter().any(|name| plain(name).starts_with(typed));
        let is_word = ["theme", "tema"].iter().any(|word| word.starts_with(typed));
        !typed.is_empty() && is_named || typed.len() >= MIN_WORD && is_word
    });
    let themes = themes.map(ListEntry::Theme);
    let tasks = tasks.map(|(at, _)| ListEntry::Task(at));
    themes.chain(presets).chain(tasks)
}

/// How a command's name or description matches the typed text, the best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum NameRank {
    /// The text is the command's name or its key.
    Name,
    /// The text is a word of the name.
    WholeWord,
    /// The text begins the name or the description.
    Start,
    /// The text begins a word.
    Word,
    /// The letters only occur in this order.
    Loose,
}

impl NameRank {
    fn of(typed: &str, name: &str, texts: &[&str]) -> NameRank {
        let texts: Vec<String> = texts.iter().map(|text| plain(text)).collect();
        let begins_word = |text: &String| {
            let mut words = text.split(|c: char| !c.is_alphanumeric());
            words.any(|word| word.starts_with(typed))
        };
        if typed == name {
            NameRank::Name
        } else if name.split('-').any(|word| word == typed) {
            NameRank::WholeWord
        } else if texts.iter().any(|text| text.starts_with(typed)) {
            NameRank::Start
        } else if texts.iter().any(begins_word) {
            NameRank::Word
        } else {
            NameRank::Loose
        }
    }
}

/// Returns the cost of the typed text as a prefix of one of the keywords; `None` if none matches.
fn keyword_cost(typed: &str, query: &str) -> Option<(usize, usize)> {
    let typed = typed.trim();
    let query = plain(query);
    let mut started = query.split(' ').filter(|word| word.starts_with(typed));
    let word = started.next().filter(|_| !typed.is_empty())?;
    Some((KEYWORD, word.len()))
}

/// Returns every command except the list of commands itself.
fn rows() -> impl Iterator<Item = &'static ActionRow> {
    action::entries().filter(|row| row.action != Action::Palette)
}

/// Converts to lower-case ASCII, for keyboards without other letters.
fn plain(text: &str) -> String {
    with_ascii_letters(text).to_ascii_lowercase()
}

/// Returns the distance of a text from the typed letters, ignoring blanks. The letters must occur
/// in their order; each gap costs by its length, and less before the start of a word. `None` if a
/// letter is missing.
fn cost(typed: &str, text: &str) -> Option<usize> {
    let text: Vec<char> = plain(text).chars().collect();
    let starts = |at: usize| at == 0 || !text[at - 1].is_alphanumeric();
    // The minimum costs of the letters so far, by the position of the last one.
    let mut before: Option<Vec<Option<usize>>> = None;
    for letter in typed.chars().filter(|c| *c != ' ') {
        let step = |at: usize| {
            if text[at] != letter {
                return None;
            }
            let jump = if starts(at) { 1 } else { 3 };
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
    use crate::manual::TOPICS;
    use crate::wording::Language;

    fn found(typed: &str) -> Vec<&'static str> {
        let mut palette = CommandList::new();
        typed.chars().for_each(|c| palette.line.push(c));
        palette.narrow();
        let names = palette.list.listed().filter_map(|listed| match listed {
            ListEntry::Command(action) => Some(action::entry_of(*action).name),
            _ => None,
        });
        names.collect()
    }

    fn topics(typed: &str) -> Vec<&'static str> {
        let mut palette = CommandList::new();
        typed.chars().for_each(|c| palette.line.push(c));
        palette.narrow();
        let topics = palette.list.listed().filter_map(|listed| match listed {
            ListEntry::Topic(at) => Some(TOPICS[*at].name),
            _ => None,
        });
        topics.collect()
    }

    #[test]
    fn long_text_lists_only_what_it_spells_out() {
        let mut palette = CommandList::new();
        let name = "w /a/".to_owned() + &"long/".repeat(40);
        let entries = |text: &str, palette: &mut CommandList| {
            text.chars().for_each(|c| palette.line.push(c));
            palette.narrow();
            palette.list.listed().copied().collect::<Vec<ListEntry>>()
        };
        assert_eq!(entries(&name, &mut palette), [ListEntry::SaveTo]);
        let mut palette = CommandList::new();
        assert_eq!(entries(&"abc123 ".repeat(40), &mut palette), []);
    }

    /// Terms that occur in no name and no help text find the command, or the topic of the manual
    /// that explains it.
    #[test]
    fn technical_terms_find_commands_and_topics() {
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
            let lines = topics(typed);
            assert!(
                topic.is_empty() || lines.contains(&topic),
                "{typed}: {lines:?}"
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
    fn commands_are_found_by_name_in_every_language() {
        Language::Turkish.speak();
        for typed in ["language", "dil", "turkce"] {
            assert_eq!(found(typed)[0], "language", "{typed}");
        }
        assert_eq!(found("cozum")[0], "working");
        Language::English.speak();
        assert_eq!(found("language")[0], "language");
    }

    #[test]
    fn commands_of_vi_come_first() {
        let first = |typed: &str| {
            let mut palette = CommandList::new();
            typed.chars().for_each(|c| palette.line.push(c));
            palette.narrow();
            palette.list.chosen().copied()
        };
        for (typed, listed) in [
            ("w", ListEntry::Command(Action::Save)),
            ("wq", ListEntry::SaveAndQuit),
            ("q", ListEntry::Command(Action::Quit)),
            ("w mine.toml", ListEntry::SaveTo),
            ("e press", ListEntry::OpenFile),
            ("135", ListEntry::GoTo),
            ("-12.5", ListEntry::GoTo),
            ("10.", ListEntry::Steps(10)),
            ("3,", ListEntry::Steps(-3)),
            ("0.", ListEntry::GoTo),
            ("W", ListEntry::Command(Action::SaveAs)),
            ("exercise", ListEntry::Exercise(1)),
            ("exer 7", ListEntry::Exercise(7)),
            ("r7 45", ListEntry::GoTo),
            ("theme d", ListEntry::Theme(Theme::Dark)),
            ("theme", ListEntry::Theme(Theme::Auto)),
            ("tema l", ListEntry::Theme(Theme::Light)),
            ("g", ListEntry::Command(Action::GoTo)),
            ("go", ListEntry::Command(Action::GoTo)),
            ("u", ListEntry::Command(Action::Undo)),
        ] {
            assert_eq!(first(typed), Some(listed), "{typed}");
        }
        assert_eq!(first("theme qzx"), None);
    }

    #[test]
    fn presets_and_tasks_are_found_by_name() {
        Language::English.speak();
        let listed = |typed: &str| {
            let mut palette = CommandList::new();
            typed.chars().for_each(|c| palette.line.push(c));
            palette.narrow();
            palette.list.listed().copied().collect::<Vec<_>>()
        };
        let preset = |name: &str| presets::all().iter().position(|p| p.name == name).unwrap();
        let task = |name: &str| {
            ExampleTask::all()
                .iter()
                .position(|t| t.name == name)
                .unwrap()
        };
        let leg = ListEntry::Preset(preset("jansen-leg"));
        assert!(listed("jansen").contains(&leg) && listed("leg").contains(&leg));
        let line = ListEntry::Task(task("straight-line"));
        assert!(listed("straight").contains(&line) && listed("synthesis").contains(&line));
        assert!(
            matches!(listed("syn")[0], ListEntry::Task(_)),
            "before loose matches"
        );
        assert!(!listed("").contains(&leg) && !listed("press").contains(&line));
        Language::Turkish.speak();
        assert!(listed("sentez").contains(&line));
        for typed in ["tema koyu", "theme dark", "tema d"] {
            assert_eq!(listed(typed)[0], ListEntry::Theme(Theme::Dark), "{typed}");
        }
        assert_eq!(listed("odev 7")[0], ListEntry::Exercise(7));
        assert_eq!(listed("tema acik")[0], ListEntry::Theme(Theme::Light));
        // The name of a theme is found alone, and the beginning of the word for themes.
        for typed in ["dark", "koyu", "the", "tem"] {
            assert!(
                listed(typed).contains(&ListEntry::Theme(Theme::Dark)),
                "{typed}"
            );
        }
        Language::English.speak();
    }

    /// A name precedes every command whose description merely contains its letters.
    #[test]
    fn names_and_word_beginnings_precede_loose_matches() {
        Language::English.speak();
        for (typed, name) in [("und", "undo"), ("report", "report"), ("lang", "language")] {
            assert_eq!(found(typed)[0], name, "{typed}: {:?}", found(typed));
        }
        let found = found("st");
        let starts = |name: &&str| {
            let row = rows().find(|row| row.name == *name).unwrap();
            let texts = [row.name, (row.hint)(words()), (row.help)(words())];
            NameRank::of("st", row.name, &texts) < NameRank::Loose
        };
        let count = found.iter().filter(|name| starts(name)).count();
        assert!(count > 1 && found[..count].iter().all(starts), "{found:?}");
    }

    #[test]
    fn empty_query_lists_all_commands() {
        assert_eq!(found("").len(), action::entries().count() - 1);
        assert_eq!(found("")[0], "play");
    }

    #[test]
    fn subsequences_match_and_closest_command_is_first() {
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

    /// Each command is the first result for its name. Only a command whose help text is that very
    /// word may precede it.
    #[test]
    fn command_names_find_their_command_first() {
        for row in rows() {
            let name = found(row.name)[0];
            let first = rows().find(|other| other.name == name).unwrap();
            let text = (first.help)(words());
            assert!(
                first.name == row.name || text == row.name,
                "{}: {text}",
                row.name
            );
        }
    }
}
