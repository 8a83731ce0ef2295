//! The section `[keys]` of the configuration: the user's keys for actions.

use crate::document::{ByteSpan, Diagnostic, Reader, WrittenValue, items, quoted};
use crate::nearest::did_you_mean;
use crate::tui::commands::action::{self, Action, ActionRow};
use crate::tui::commands::key::{self, Key};
use crate::tui::commands::keymap::Keymap;
use crate::wording::words;

/// Returns the fixed key of an action and a description of it. Fixed keys ensure that the user can
/// always leave.
fn fixed_key(action: Action) -> Option<(Key, String)> {
    let (leave, back) = (Key::Ctrl('c'), Key::Escape);
    match action {
        Action::Leave => Some((leave, words().always_leaves(&leave))),
        Action::Back => Some((back, words().always_goes_back(&back))),
        _ => None,
    }
}

/// Returns `true` if the user may change the action's keys.
pub(super) fn is_free(entry: &ActionRow) -> bool {
    fixed_key(entry.action).is_none()
}

/// Returns `true` for actions that must have a key.
fn is_needed(action: Action) -> bool {
    matches!(action, Action::Help | Action::Quit)
}

/// A key from the file, with its action and its place.
struct GivenKey {
    entry: &'static ActionRow,
    key: Key,
    span: ByteSpan,
}

/// Reads the section into the keymap: for each action a list of keys, or a single key.
pub(super) fn read(reader: &mut Reader<'_>, section: &WrittenValue<'_>, keymap: &mut Keymap) {
    let mut given = Vec::new();
    for (name, value) in reader.entries("[keys]", "play = [\"space\", \"F5\"]", section) {
        let text = name.text;
        let Some(entry) = action_of(reader, text, name.span.clone()) else {
            continue;
        };
        let before = reader.found.len();
        let keys = keys_of(reader, text, value);
        let is_read = reader.found.len() == before;
        if keys.is_empty() && !is_read {
            // The action keeps its current keys.
            continue;
        }
        if keys.is_empty() && is_needed(entry.action) {
            reader.report(
                Diagnostic::new(words().must_have_a_key(&quoted(text)))
                    .at(value.span(), words().no_key_here())
                    .help(words().by_default(&action::listed(entry.keys))),
            );
        }
        keymap.set(entry.action, keys.iter().map(|(key, _)| *key).collect());
        given.extend(
            keys.into_iter()
                .map(|(key, span)| GivenKey { entry, key, span }),
        );
    }
    // After errors, incomplete bindings could cause false clashes.
    if !reader.has_errors() {
        report_clashes(reader, keymap, &given);
    }
}

fn action_of(reader: &mut Reader<'_>, name: &str, span: ByteSpan) -> Option<&'static ActionRow> {
    let found = action::entries().find(|entry| entry.name == name);
    let Some(entry) = found else {
        let free = action::entries().filter(|entry| is_free(entry));
        let near = did_you_mean(name, free.map(|entry| entry.name));
        let listed = || words().config_lists_actions().to_owned();
        reader.report(
            Diagnostic::new(words().unknown_action(&quoted(name)))
                .at(span, words().unknown_action_here())
                .help(near.unwrap_or_else(listed))
                .into_warning(),
        );
        return None;
    };
    let Some((_, always)) = fixed_key(entry.action) else {
        return Some(entry);
    };
    reader.report(
        Diagnostic::new(words().keeps_its_key(&quoted(name)))
            .at(span, words().cannot_be_changed())
            .help(always),
    );
    None
}

/// Reads one key or a list of keys.
fn keys_of(reader: &mut Reader<'_>, of: &str, value: &WrittenValue<'_>) -> Vec<(Key, ByteSpan)> {
    let written = items(value).unwrap_or(std::slice::from_ref(value));
    let mut keys = Vec::new();
    for value in written {
        match value.get_ref().as_str() {
            Some(text) => keys.extend(key_of(reader, text, &value.span())),
            None => {
                let fault = reader.mistyped(&quoted(of), words().a_key_or_keys(), value);
                reader.report(fault.help(words().for_example_keys(of)));
            }
        }
    }
    keys
}

fn key_of(reader: &mut Reader<'_>, text: &str, span: &ByteSpan) -> Option<(Key, ByteSpan)> {
    let fault = |message: String, label: &str| Diagnostic::new(message).at(span.clone(), label);
    let Ok(key) = text.parse::<Key>() else {
        let names = key::names();
        let near = did_you_mean(text, names.iter().map(String::as_str));
        reader.report(
            fault(words().no_key_called(&quoted(text)), words().unknown_key())
                .maybe_help(near)
                .help(words().how_keys_are_called())
                .into_warning(),
        );
        return None;
    };
    if let Some((_, always)) = action::entries()
        .filter_map(|entry| fixed_key(entry.action))
        .find(|(own, _)| *own == key)
    {
        let fault = fault(always, words().cannot_be_given_away());
        reader.report(fault.help(words().choose_another_key()));
        return None;
    }
    if let Some(sent) = key.sent_as() {
        let fault = fault(words().sent_as(&key, &sent), words().never_seen());
        reader.report(fault.help(words().choose_another_key()));
        return None;
    }
    Some((key, span.clone()))
}

/// Reports each key with two meanings in one context.
fn report_clashes(reader: &mut Reader<'_>, keymap: &Keymap, given: &[GivenKey]) {
    for conflict in keymap.clashes() {
        let places = |entry: &ActionRow| {
            let mine = given
                .iter()
                .filter(|g| g.entry.action == entry.action && g.key == conflict.key);
            mine.map(|g| g.span.clone()).collect::<Vec<_>>()
        };
        let [first, second] =
            [conflict.first, conflict.second].map(|entry| (entry.name, places(entry)));
        let key = conflict.key;
        let fault = Diagnostic::new(if first.0 == second.0 {
            words().key_given_twice(&key, first.0)
        } else {
            words().key_given_to_both(&key, first.0, second.0)
        });
        reader.report(match (&first.1[..], &second.1[..]) {
            ([one, other, ..], _) if first.0 == second.0 => fault
                .at(other.clone(), words().once_more())
                .and(one.clone(), words().here()),
            ([one, ..], [other, ..]) => fault
                .at(other.clone(), words().here_too())
                .and(one.clone(), words().here()),
            ([one, ..], []) => by_default(fault, one, second.0),
            ([], [one, ..]) => by_default(fault, one, first.0),
            // Built-in keys do not clash.
            ([], []) => fault,
        });
    }
}

fn by_default(fault: Diagnostic, span: &ByteSpan, other: &str) -> Diagnostic {
    fault
        .at(span.clone(), words().has_it_by_default(other))
        .help(words().give_another_key(other))
}
