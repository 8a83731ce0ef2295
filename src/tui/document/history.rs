//! Undo and redo of text edits.

use std::ops::Range;

/// Maximum number of steps kept. Each holds only its changed part.
const MAX_STEPS: usize = 1000;

/// The kind of a step. Consecutive nudges of the same value merge into one step.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Deed {
    /// A nudge of the value with this name by a key.
    Nudge(String),
    /// Any other edit, with its display name.
    Other(String),
}

impl Deed {
    /// Returns the display name.
    pub(crate) fn name(&self) -> &str {
        match self {
            Deed::Nudge(name) | Deed::Other(name) => name,
        }
    }
}

/// A replaced part of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
struct TextChange {
    at: usize,
    old: String,
    new: String,
    kind: Deed,
}

impl TextChange {
    fn between(before: &str, after: &str, action: Deed) -> TextChange {
        let at = common_prefix(before, after);
        let end = common_suffix(&before[at..], &after[at..]);
        let part = |text: &str| text[at..text.len() - end].to_owned();
        TextChange {
            at,
            old: part(before),
            new: part(after),
            kind: action,
        }
    }

    /// Returns the text before the change.
    fn back(&self, text: &str) -> String {
        replaced(text, self.at..self.at + self.new.len(), &self.old)
    }

    /// Returns the text after the change.
    fn forth(&self, text: &str) -> String {
        replaced(text, self.at..self.at + self.old.len(), &self.new)
    }
}

fn replaced(text: &str, span: Range<usize>, by: &str) -> String {
    let mut made = String::with_capacity(text.len() - span.len() + by.len());
    made.push_str(&text[..span.start]);
    made.push_str(by);
    made.push_str(&text[span.end..]);
    made
}

/// Returns the length of the common prefix in bytes, at a character boundary.
fn common_prefix(one: &str, other: &str) -> usize {
    let pairs = one.char_indices().zip(other.chars());
    let mut different = pairs.skip_while(|((_, a), b)| a == b);
    different
        .next()
        .map_or(one.len().min(other.len()), |((at, _), _)| at)
}

/// Returns the length of the common suffix in bytes.
fn common_suffix(one: &str, other: &str) -> usize {
    let pairs = one.chars().rev().zip(other.chars().rev());
    pairs
        .take_while(|(a, b)| a == b)
        .map(|(a, _)| a.len_utf8())
        .sum()
}

/// The steps that led to a text, and the undone steps.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct History {
    past: Vec<TextChange>,
    future: Vec<TextChange>,
}

impl History {
    /// Returns `true` if no steps are recorded.
    pub(crate) fn is_empty(&self) -> bool {
        self.past.is_empty() && self.future.is_empty()
    }

    /// Records the change of a text and clears the undone steps. Returns `true` if it merged with
    /// the last step.
    pub(crate) fn record(&mut self, before: &str, after: &str, action: Deed) -> bool {
        self.future.clear();
        let joined = match (self.past.last(), &action) {
            (Some(last), Deed::Nudge(_)) if last.kind == action => Some(last.back(before)),
            _ => None,
        };
        let before = match &joined {
            Some(earlier) => {
                self.past.pop();
                earlier
            }
            None => before,
        };
        if before != after {
            self.past.push(TextChange::between(before, after, action));
        }
        let surplus = self.past.len().saturating_sub(MAX_STEPS);
        self.past.drain(..surplus);
        joined.is_some()
    }

    /// Prevents later nudges from merging with the last step.
    pub(crate) fn part(&mut self) {
        if let Some(last) = self.past.last_mut() {
            last.kind = Deed::Other(last.kind.name().to_owned());
        }
    }

    /// Returns the text before the last step, and the step's name.
    pub(crate) fn before(&self, text: &str) -> Option<(String, &str)> {
        let last = self.past.last()?;
        Some((last.back(text), last.kind.name()))
    }

    /// Returns the text after the last undone step, and the step's name.
    pub(crate) fn after(&self, text: &str) -> Option<(String, &str)> {
        let next = self.future.last()?;
        Some((next.forth(text), next.kind.name()))
    }

    /// Marks the last step as undone.
    pub(crate) fn mark_undone(&mut self) {
        self.part();
        self.future.extend(self.past.pop());
    }

    /// Marks the last undone step as redone.
    pub(crate) fn mark_redone(&mut self) {
        self.past.extend(self.future.pop());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn other(name: &str) -> Deed {
        Deed::Other(name.into())
    }

    #[test]
    fn consecutive_nudges_of_a_value_merge_into_one_step() {
        let mut history = History::default();
        let nudge = || Deed::Nudge("r2".into());
        history.record("a 1 b", "a 2 b", nudge());
        history.record("a 2 b", "a 13 b", nudge());
        assert_eq!(history.before("a 13 b"), Some(("a 1 b".into(), "r2")));
        history.part();
        history.record("a 13 b", "a 14 b", nudge());
        assert_eq!(history.before("a 14 b"), Some(("a 13 b".into(), "r2")));
        history.record("a 14 b", "a 14 c", Deed::Nudge("r3".into()));
        assert_eq!(history.before("a 14 c"), Some(("a 14 b".into(), "r3")));
        // A nudge that restores the previous text removes its step.
        history.record("a 14 c", "a 14 b", Deed::Nudge("r3".into()));
        assert_eq!(history.before("a 14 b"), Some(("a 13 b".into(), "r2")));
    }

    #[test]
    fn new_step_clears_redo() {
        let mut history = History::default();
        history.record("one", "two", other("first"));
        history.mark_undone();
        assert_eq!(history.after("one"), Some(("two".into(), "first")));
        history.record("one", "three", other("second"));
        assert_eq!(history.after("three"), None);
    }

    #[test]
    fn history_length_is_limited() {
        let mut history = History::default();
        let text = |n: usize| format!("value = {n}");
        for n in 0..3 * MAX_STEPS {
            history.record(&text(n), &text(n + 1), other("n"));
        }
        assert_eq!(history.past.len(), MAX_STEPS);
        let mut now = text(3 * MAX_STEPS);
        while let Some((before, _)) = history.before(&now) {
            now = before;
            history.mark_undone();
        }
        assert_eq!(now, text(2 * MAX_STEPS));
    }

    proptest! {
        /// Undoing every step restores the first text, and redoing every step the last one, byte
        /// for byte.
        #[test]
        fn undo_and_redo_restore_every_text(texts in proptest::collection::vec("[ab\u{e4}\u{20ac}]{0,8}", 1..12), nudges in 0_u32..) {
            let mut history = History::default();
            for (i, pair) in texts.windows(2).enumerate() {
                let action = if nudges >> (i % 32) & 1 == 1 { Deed::Nudge("n".into()) } else { other("o") };
                history.record(&pair[0], &pair[1], action);
            }
            let last = texts.last().unwrap();
            let mut now = last.clone();
            while let Some((before, _)) = history.before(&now) {
                now = before;
                history.mark_undone();
            }
            prop_assert_eq!(&now, &texts[0]);
            while let Some((after, _)) = history.after(&now) {
                now = after;
                history.mark_redone();
            }
            prop_assert_eq!(&now, last);
        }
    }
}
