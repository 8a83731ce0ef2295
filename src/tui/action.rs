//! Everything that can be asked of the workbench, in one table: the keys, the help overlay, the hints of
//! the last line and the list of keys in the manual all come from it.

use super::key::Key;

/// What a key asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Action {
    /// Play, or pause.
    Play,
    /// One step back.
    StepBack,
    /// One step on.
    StepForward,
    /// A smaller step.
    SmallerStep,
    /// A larger step.
    LargerStep,
    /// Play more slowly.
    Slower,
    /// Play faster.
    Faster,
    /// Play the other way.
    Reverse,
    /// Type an angle to go to.
    GoTo,
    /// Back to where the scene opens.
    Opening,
    /// List the assemblies.
    Assemblies,
    /// Save the start positions.
    Save,
    /// The next preset.
    NextPreset,
    /// The preset before.
    PreviousPreset,
    /// The next set of glyphs.
    Glyphs,
    /// The next view.
    NextView,
    /// The motion view.
    MotionView,
    /// The tables view.
    TablesView,
    /// The view of speed against error.
    AccuracyView,
    /// The view of what the given lengths do.
    LengthsView,
    /// A line up.
    LineUp,
    /// A line down.
    LineDown,
    /// A screen up.
    PageUp,
    /// A screen down.
    PageDown,
    /// Show or hide the keys.
    Help,
    /// One level back.
    Back,
    /// Draw everything again.
    Redraw,
    /// Stop, and give the shell its terminal.
    Suspend,
    /// Leave.
    Quit,
    /// Leave, from anywhere.
    Leave,
}

/// A row of the table.
#[derive(Debug)]
pub(crate) struct Entry {
    pub(crate) action: Action,
    /// One or two words, for the hints of the last line.
    pub(crate) name: &'static str,
    /// One line.
    pub(crate) help: &'static str,
    pub(crate) keys: &'static [Key],
}

const fn entry(
    action: Action,
    name: &'static str,
    help: &'static str,
    keys: &'static [Key],
) -> Entry {
    Entry {
        action,
        name,
        help,
        keys,
    }
}

/// All actions with their keys, in the order in which the help shows them.
// One row, one line.
#[rustfmt::skip]
pub(crate) static ACTIONS: [Entry; 30] = {
    use Action as A;
    use Key::{Char, Ctrl, Function};
    [
        entry(A::Play, "play", "play or pause", &[Char(' ')]),
        entry(A::StepBack, "back", "one step back", &[Char(','), Key::Left, Char('h')]),
        entry(A::StepForward, "step", "one step on", &[Char('.'), Key::Right, Char('l')]),
        entry(A::SmallerStep, "smaller", "a smaller step", &[Char('[')]),
        entry(A::LargerStep, "larger", "a larger step", &[Char(']')]),
        entry(A::Slower, "slower", "play more slowly", &[Char('-')]),
        entry(A::Faster, "faster", "play faster", &[Char('+'), Char('=')]),
        entry(A::Reverse, "reverse", "play the other way", &[Char('r')]),
        entry(A::GoTo, "go to", "type where to go", &[Char('g')]),
        entry(A::Opening, "opening", "where the scene opens", &[Key::Home]),
        entry(A::Assemblies, "assemblies", "other assemblies", &[Char('a')]),
        entry(A::Save, "save", "save this assembly", &[Char('w')]),
        entry(A::NextPreset, "next", "the next preset", &[Char('n')]),
        entry(A::PreviousPreset, "previous", "the preset before", &[Char('p')]),
        entry(A::Glyphs, "glyphs", "ASCII, lines, Braille", &[Char('t')]),
        entry(A::NextView, "view", "the next view", &[Key::Tab]),
        entry(A::MotionView, "motion", "motion and live tables", &[Char('1')]),
        entry(A::TablesView, "tables", "all tables", &[Char('2')]),
        entry(A::AccuracyView, "accuracy", "speed against error", &[Char('5')]),
        entry(A::LengthsView, "lengths", "what each length does", &[Char('e')]),
        entry(A::LineUp, "up", "scroll up", &[Key::Up, Char('k')]),
        entry(A::LineDown, "scroll", "scroll down", &[Key::Down, Char('j')]),
        entry(A::PageUp, "page up", "scroll a screen up", &[Key::PageUp]),
        entry(A::PageDown, "page down", "scroll a screen down", &[Key::PageDown]),
        entry(A::Help, "help", "show or hide this help", &[Char('?'), Function(1)]),
        entry(A::Back, "back", "one level back", &[Key::Escape]),
        entry(A::Redraw, "redraw", "draw everything again", &[Ctrl('l')]),
        entry(A::Suspend, "suspend", "stop; fg goes on", &[Ctrl('z')]),
        entry(A::Quit, "quit", "leave", &[Char('q')]),
        entry(A::Leave, "leave", "leave from anywhere", &[Ctrl('c')]),
    ]
};

/// The action of a key.
pub(crate) fn of_key(key: Key) -> Option<Action> {
    let entry = ACTIONS.iter().find(|entry| entry.keys.contains(&key));
    entry.map(|entry| entry.action)
}

/// The row of an action.
pub(crate) fn entry_of(action: Action) -> &'static Entry {
    ACTIONS
        .iter()
        .find(|entry| entry.action == action)
        .unwrap_or(&ACTIONS[0])
}

impl Entry {
    /// The keys as people read them: `, Left h`.
    pub(crate) fn keys(&self) -> String {
        let keys: Vec<String> = self.keys.iter().map(Key::to_string).collect();
        keys.join(" ")
    }
}

/// The keys and what they do, one line each, for a manual.
pub fn key_list() -> impl Iterator<Item = (String, &'static str)> {
    ACTIONS.iter().map(|entry| (entry.keys(), entry.help))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn no_key_stands_twice_and_no_action_is_missing() {
        let keys: Vec<Key> = ACTIONS.iter().flat_map(|e| e.keys).copied().collect();
        let different: HashSet<Key> = keys.iter().copied().collect();
        assert_eq!(keys.len(), different.len());
        for entry in &ACTIONS {
            assert_eq!(entry_of(entry.action).name, entry.name);
            assert_eq!(of_key(entry.keys[0]), Some(entry.action));
        }
    }

    #[test]
    fn a_help_line_fits_the_smallest_screen() {
        for entry in &ACTIONS {
            assert!(entry.keys().len() <= 12, "{}", entry.keys());
            assert!(
                entry.help.is_ascii() && entry.help.len() <= 23,
                "{}",
                entry.help
            );
        }
    }
}
