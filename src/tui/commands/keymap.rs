//! The key bindings: the table of actions with the user's keys in place of the built-in ones.

use crate::tui::commands::action::{self, Action, ActionRow, KeyContext};
use crate::tui::commands::key::Key;
use crate::tui::commands::view::View;
use crate::wording::words;

/// The keys of every action.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Keymap {
    /// Lists of keys, by the rows of the table.
    keys: Vec<Vec<Key>>,
}

/// A key bound to two actions in contexts that share a view.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clash {
    pub(crate) key: Key,
    pub(crate) first: &'static ActionRow,
    pub(crate) second: &'static ActionRow,
}

impl Default for Keymap {
    /// Returns the built-in keys.
    fn default() -> Self {
        let keys = action::entries().map(|entry| entry.keys.to_vec());
        Keymap {
            keys: keys.collect(),
        }
    }
}

impl Keymap {
    /// Replaces the keys of an action.
    pub(crate) fn set(&mut self, action: Action, keys: Vec<Key>) {
        let at = action::entries().position(|entry| entry.action == action);
        if let Some(own) = at.and_then(|at| self.keys.get_mut(at)) {
            *own = keys;
        }
    }

    /// Returns the action bound to a key in a view. A view's own keys override those of lists,
    /// which override those of all views.
    pub(crate) fn action(&self, key: Key, view: View) -> Option<Action> {
        let places = [
            KeyContext::In(view),
            KeyContext::Lists,
            KeyContext::Everywhere,
        ];
        let covering = places.into_iter().filter(|place| place.covers(view));
        self.first(key, covering)
    }

    /// Returns the action bound to a key in a list that overlays any view.
    pub(crate) fn action_in_list(&self, key: Key) -> Option<Action> {
        self.first(key, [KeyContext::Lists, KeyContext::Everywhere].into_iter())
    }

    fn first(&self, key: Key, mut places: impl Iterator<Item = KeyContext>) -> Option<Action> {
        places.find_map(|place| {
            let mut rows = self.rows();
            let claimed = rows.find(|(row, keys)| row.place == place && keys.contains(&key));
            claimed.map(|(row, _)| row.action)
        })
    }

    /// Returns the keys of an action; empty if the user has removed them.
    pub(crate) fn keys(&self, action: Action) -> &[Key] {
        let row = self.rows().find(|(entry, _)| entry.action == action);
        row.map_or(&[], |(_, keys)| keys)
    }

    /// Returns the first key of an action, which messages show, if it has one.
    pub(crate) fn key(&self, action: Action) -> Option<Key> {
        self.keys(action).first().copied()
    }

    /// Returns the key of an action for messages, or a text that says that it has none.
    pub(crate) fn key_label(&self, action: Action) -> String {
        self.key(action)
            .map_or_else(|| words().no_key().into(), |key| key.to_string())
    }

    /// Yields every row of the table with its keys.
    pub(crate) fn rows(&self) -> impl Iterator<Item = (&'static ActionRow, &[Key])> {
        action::entries().zip(self.keys.iter().map(Vec::as_slice))
    }

    /// Returns the keys with two meanings in one context, in the order of the table.
    pub(crate) fn clashes(&self) -> impl Iterator<Item = Clash> {
        let rows: Vec<_> = self.rows().collect();
        let claims = |&(entry, keys): &(&'static ActionRow, &[Key])| {
            let keys: Vec<Key> = keys.to_vec();
            keys.into_iter().map(move |key| (key, entry))
        };
        let claims: Vec<(Key, &'static ActionRow)> = rows.iter().flat_map(claims).collect();
        let mut found = Vec::new();
        for (n, &(key, second)) in claims.iter().enumerate() {
            let earlier = claims[..n].iter().find(|(k, first)| {
                *k == key
                    && first.place.meets(second.place)
                    && !is_allowed_override(first, second, key)
            });
            if let Some(&(key, first)) = earlier {
                found.push(Clash { key, first, second });
            }
        }
        found.into_iter()
    }
}

/// Returns `true` if one of two bindings of a key overrides the other: a list's binding overrides
/// that of all views if the key has both built in. Another action bound to such a key by the user
/// thus works only in the motion view.
fn is_allowed_override(one: &ActionRow, other: &ActionRow, key: Key) -> bool {
    let is_built_in = |place| {
        let mut rows = action::entries().filter(|row| row.place == place);
        rows.any(|row| row.keys.contains(&key))
    };
    let takes = |row: &ActionRow| row.place == KeyContext::Lists;
    is_built_in(KeyContext::Lists)
        && is_built_in(KeyContext::Everywhere)
        && takes(one) != takes(other)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn default_keys_do_not_clash() {
        let keymap = Keymap::default();
        assert_eq!(keymap.clashes().count(), 0, "{:?}", keymap.clashes().next());
        for entry in action::entries() {
            let view = match entry.place {
                KeyContext::Everywhere => View::Motion,
                KeyContext::Lists => View::Forces,
                KeyContext::In(view) => view,
            };
            let intended = keymap.action(entry.keys[0], view);
            assert_eq!(intended, Some(entry.action), "{}", entry.name);
        }
    }

    #[test]
    fn rebinding_replaces_default_keys() {
        let mut keymap = Keymap::default();
        keymap.set(Action::Play, vec![Key::Function(5)]);
        let intended = |key| keymap.action(key, View::Motion);
        assert_eq!(intended(Key::Function(5)), Some(Action::Play));
        assert_eq!(intended(Key::Char(' ')), None);
        assert_eq!(keymap.key(Action::Play), Some(Key::Function(5)));
    }

    /// Regression: arrows and Home turned the crank inside lists.
    #[test]
    fn arrow_keys_do_not_move_driver_in_lists() {
        let keymap = Keymap::default();
        let crank = [Action::StepBack, Action::StepForward, Action::Opening];
        for view in View::ALL.into_iter().filter(|view| *view != View::Motion) {
            for key in [
                Key::Left,
                Key::Right,
                Key::Home,
                Key::Char('h'),
                Key::Char('l'),
            ] {
                let intended = keymap.action(key, view).unwrap();
                assert!(!crank.contains(&intended), "{key} in {view:?}");
            }
            assert_eq!(
                keymap.action(Key::Char('.'), view),
                Some(Action::StepForward)
            );
        }
        let intended = keymap.action(Key::Left, View::Motion);
        assert_eq!(intended, Some(Action::StepBack));
        // Configured keys clash in lists as in any other context.
        let mut keymap = Keymap::default();
        keymap.set(Action::Play, vec![Key::End]);
        assert_eq!(keymap.clashes().count(), 1);
        // A key freed from moving the crank can be bound to another action, and still moves in
        // lists.
        let mut keymap = Keymap::default();
        keymap.set(Action::StepForward, vec![Key::Char('.')]);
        keymap.set(Action::Play, vec![Key::Char('l')]);
        assert_eq!(keymap.clashes().count(), 0);
        assert_eq!(
            keymap.action(Key::Char('l'), View::Motion),
            Some(Action::Play)
        );
    }

    #[test]
    fn keys_clash_only_in_shared_contexts() {
        let mut keymap = Keymap::default();
        keymap.set(Action::Save, vec![Key::Char('m')]);
        let conflict = keymap.clashes().next().unwrap();
        assert_eq!(
            (conflict.key, conflict.first.name),
            (Key::Char('m'), "extrema")
        );
        assert_eq!(keymap.clashes().count(), 1);
        keymap.set(Action::Save, vec![Key::Char('w'), Key::Char('w')]);
        assert_eq!(keymap.clashes().count(), 1, "twice in one list");
    }
}
