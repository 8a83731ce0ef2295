//! Groups the actions by purpose, for the help, the manual and the configuration file.

use crate::manual::SearchWords;
use crate::tui::app::View;
use crate::tui::commands::action::{self, ActionRow, KeyContext};
use crate::tui::commands::keymap::Keymap;
use crate::tui::commands::keywords::keywords;
use crate::wording::words;

/// Returns the titles and actions of all groups: first the actions of the view `first`, then those common to all views,
/// then those of the other views.
pub(crate) fn groups(first: Option<View>) -> Vec<(&'static str, Vec<&'static ActionRow>)> {
    let of = |view: View| {
        let here = move |entry: &&ActionRow| entry.place == KeyContext::In(view);
        (view.help_title(), action::entries().filter(here).collect())
    };
    let common = action::SECTIONS.iter().map(|section| {
        let common = |entry: &&ActionRow| !matches!(entry.place, KeyContext::In(_));
        let entries: Vec<_> = section.entries.iter().filter(common).collect();
        ((section.title)(words()), entries)
    });
    let others = View::ALL.into_iter().filter(|view| Some(*view) != first);
    let all = first.into_iter().map(of).chain(common);
    all.chain(others.map(of))
        .filter(|(_, entries): &(_, Vec<_>)| !entries.is_empty())
        .collect()
}

/// Lists the built-in keys for a manual: the title of the group, the keys and the description of each action.
pub fn key_list() -> impl Iterator<Item = (&'static str, String, &'static str)> {
    groups(None).into_iter().flat_map(|(title, entries)| {
        let row =
            move |entry: &ActionRow| (title, action::listed(entry.keys), (entry.help)(words()));
        entries.into_iter().map(row)
    })
}

/// Formats the built-in keys and their descriptions as rows of a Markdown table.
pub(crate) fn key_rows() -> String {
    rows_of(&Keymap::default())
}

/// Returns the rows of the built-in keys whose name, purpose or keywords have the words.
pub(crate) fn key_rows_about(query: &SearchWords) -> String {
    rows_where(&Keymap::default(), |entry| {
        let (hint, help) = ((entry.hint)(words()), (entry.help)(words()));
        let keys = action::listed(entry.keys);
        query.are_in(&[&keys, entry.name, hint, help, keywords(entry.action)])
    })
}

/// Formats the keys of a keymap and their descriptions as rows of a Markdown table.
pub(super) fn rows_of(keymap: &Keymap) -> String {
    rows_where(keymap, |_| true)
}

/// Formats the rows of the selected actions that have a key.
fn rows_where(keymap: &Keymap, is_wanted: impl Fn(&ActionRow) -> bool) -> String {
    let mut rows = String::new();
    for (title, entries) in groups(None) {
        let wanted = entries.into_iter().filter(|entry| is_wanted(entry));
        let text = wanted.filter_map(|entry| {
            let keys = keymap.keys(entry.action).iter();
            let keys: Vec<_> = keys.map(|key| format!("`{key}`")).collect();
            // An unescaped bar would end the cell.
            let keys = keys.join(" ").replace('|', r"\|");
            (!keys.is_empty()).then(|| format!("| {keys} | {} |\n", (entry.help)(words())))
        });
        let text: String = text.collect();
        if !text.is_empty() {
            rows += &format!("| **{title}** | |\n{text}");
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tui::commands::key::Key;

    #[test]
    fn every_action_is_in_one_group() {
        for first in View::ALL.map(Some).into_iter().chain([None]) {
            let all = groups(first).into_iter().flat_map(|(_, entries)| entries);
            let all: Vec<&str> = all.map(|entry| entry.name).collect();
            assert_eq!(all.len(), action::entries().count());
            assert!(action::entries().all(|entry| all.contains(&entry.name)));
        }
    }

    #[test]
    fn key_table_follows_keymap() {
        let mut keymap = Keymap::default();
        keymap.set(action::Action::Reverse, vec![Key::Char('|')]);
        keymap.set(action::Action::Play, Vec::new());
        let rows = rows_of(&keymap);
        assert_eq!(rows.lines().count(), key_rows().lines().count() - 1);
        assert!(rows.contains("| `\\|` | "), "{rows}");
    }
}
