//! The section `[keys]`: which keys a person wants for which action.

use crate::document::{Diagnostic, Entries, Found, Lenient, Reader, Span, quoted};
use crate::nearest::did_you_mean;
use crate::tui::commands::action::{self, Action, Entry};
use crate::tui::commands::key::{self, Key};
use crate::tui::commands::keymap::Keymap;

/// The section as it is written: for each action a list of keys, or one key in its place.
pub(super) type Section = Lenient<Entries<Lenient<Vec<Lenient<String>>>>>;

/// What an action is called in the configuration: its name in one word.
pub(super) fn name_of(entry: &Entry) -> String {
    entry.name.replace(' ', "-")
}

/// The key that an action keeps, and what it always does: nobody should be locked in.
fn kept(action: Action) -> Option<(Key, &'static str)> {
    match action {
        Action::Leave => Some((Key::Ctrl('c'), "always leaves")),
        Action::Back => Some((Key::Escape, "always goes back")),
        _ => None,
    }
}

/// Whether a person may choose its keys.
pub(super) fn is_free(entry: &Entry) -> bool {
    kept(entry.action).is_none()
}

/// Actions that one cannot do without.
fn is_needed(action: Action) -> bool {
    matches!(action, Action::Help | Action::Quit)
}

/// A key that was given to an action, and where.
struct Given {
    entry: &'static Entry,
    key: Key,
    place: Span,
}

/// Reads the section into the keymap.
pub(super) fn read(reader: &mut Reader<'_>, section: &Section, keymap: &mut Keymap) {
    reader.table("[keys]", "play = [\"space\", \"F5\"]", section);
    let before = reader.found.len();
    let mut given = Vec::new();
    for (name, value) in section.entries() {
        let text = name.text;
        let Some(entry) = action_of(reader, text, name.span.clone()) else {
            continue;
        };
        let keys = keys_of(reader, text, value);
        if keys.is_empty() && is_needed(entry.action) && reader.found.len() == before {
            reader.report(
                Diagnostic::new(format!("{} must have a key", quoted(text)))
                    .at(value.span.clone(), "no key")
                    .help(format!("by default it has {}", action::listed(entry.keys))),
            );
        }
        keymap.set(entry.action, keys.iter().map(|(key, _)| *key).collect());
        given.extend(
            keys.into_iter()
                .map(|(key, place)| Given { entry, key, place }),
        );
    }
    // What could not be read would lead to clashes that nobody meant.
    if reader.found.len() == before {
        tell_clashes(reader, keymap, &given);
    }
}

fn action_of(reader: &mut Reader<'_>, name: &str, place: Span) -> Option<&'static Entry> {
    let found = action::entries().find(|entry| name_of(entry) == name);
    let Some(entry) = found else {
        let names: Vec<String> = action::entries()
            .filter(|e| is_free(e))
            .map(name_of)
            .collect();
        let near = did_you_mean(name, names.iter().map(String::as_str));
        let listed = || "`krank config` lists all actions".to_owned();
        reader.report(
            Diagnostic::new(format!("[keys]: unknown action {}", quoted(name)))
                .at(place, "unknown action")
                .help(near.unwrap_or_else(listed)),
        );
        return None;
    };
    let Some((key, does)) = kept(entry.action) else {
        return Some(entry);
    };
    reader.report(
        Diagnostic::new(format!("[keys]: {} keeps its key", quoted(name)))
            .at(place, "cannot be changed")
            .help(format!("{key} {does}")),
    );
    None
}

/// One key or a list of keys.
fn keys_of(
    reader: &mut Reader<'_>,
    of: &str,
    value: &Lenient<Vec<Lenient<String>>>,
) -> Vec<(Key, Span)> {
    match &value.read {
        Ok(list) => {
            let keys = list.iter().filter_map(|value| match &value.read {
                Ok(text) => key_of(reader, text, &value.span),
                Err(found) => no_key(reader, of, found, &value.span),
            });
            keys.collect()
        }
        Err(Found::Text(text)) => key_of(reader, text, &value.span).into_iter().collect(),
        Err(found) => no_key(reader, of, found, &value.span).into_iter().collect(),
    }
}

/// Reports what stands where a key should.
fn no_key(reader: &mut Reader<'_>, of: &str, found: &Found, place: &Span) -> Option<(Key, Span)> {
    let fault = reader.wrong_type(&quoted(of), "a key or a list of keys", found, place);
    reader.report(fault.help(format!("for example: {of} = [\"space\", \"F5\"]")));
    None
}

fn key_of(reader: &mut Reader<'_>, text: &str, place: &Span) -> Option<(Key, Span)> {
    let fault = |message: String, label: &str| Diagnostic::new(message).at(place.clone(), label);
    let Ok(key) = text.parse::<Key>() else {
        let names = key::names();
        let near = did_you_mean(text, names.iter().map(String::as_str));
        reader.report(
            fault(format!("no key is called {}", quoted(text)), "unknown key")
                .maybe_help(near)
                .help(
                    "a key is a printable ASCII character, or is called as the help shows it:\n\
                     space, Enter, Tab, Shift-Tab, Backspace, Left, Right, Up, Down, Home, End,\n\
                     PgUp, PgDn, F1 to F24, Ctrl-A to Ctrl-Z",
                ),
        );
        return None;
    };
    if let Some((_, does)) = action::entries()
        .filter_map(|entry| kept(entry.action))
        .find(|(own, _)| *own == key)
    {
        let message = format!("{key} {does}");
        reader.report(fault(message, "cannot be given away").help("choose another key"));
        return None;
    }
    if let Some(sent) = key.sent_as() {
        let message = format!("terminals send {key} as {sent}");
        reader.report(fault(message, "never seen").help("choose another key"));
        return None;
    }
    Some((key, place.clone()))
}

/// Tells each key that has two meanings in one place.
fn tell_clashes(reader: &mut Reader<'_>, keymap: &Keymap, given: &[Given]) {
    for clash in keymap.clashes() {
        let places = |entry: &Entry| {
            let mine = given
                .iter()
                .filter(|g| g.entry.action == entry.action && g.key == clash.key);
            mine.map(|g| g.place.clone()).collect::<Vec<_>>()
        };
        let [first, second] =
            [clash.first, clash.second].map(|entry| (name_of(entry), places(entry)));
        let key = clash.key;
        let fault = Diagnostic::new(if first.0 == second.0 {
            format!("the key {key} is given to `{}` twice", first.0)
        } else {
            format!(
                "the key {key} is given to `{}` and to `{}`",
                first.0, second.0
            )
        });
        reader.report(match (&first.1[..], &second.1[..]) {
            ([one, other, ..], _) if first.0 == second.0 => fault
                .at(other.clone(), "once more")
                .and(one.clone(), "here"),
            ([one, ..], [other, ..]) => {
                fault.at(other.clone(), "here too").and(one.clone(), "here")
            }
            ([one, ..], []) => by_default(fault, one, &second.0),
            ([], [one, ..]) => by_default(fault, one, &first.0),
            // The keys that are built in do not clash.
            ([], []) => fault,
        });
    }
}

fn by_default(fault: Diagnostic, place: &Span, other: &str) -> Diagnostic {
    fault
        .at(place.clone(), format!("`{other}` has it by default"))
        .help(format!("give `{other}` another key, or none: {other} = []"))
}
