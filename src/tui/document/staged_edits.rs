//! Staged edits, applied together because the states between them may not close.

/// The staged texts of some values, by the values' names.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct StagedEdits {
    list: Vec<(String, String)>,
}

impl StagedEdits {
    pub(crate) fn len(&self) -> usize {
        self.list.len()
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Returns the edits as pairs of name and text, the latest last.
    pub(crate) fn list(&self) -> &[(String, String)] {
        &self.list
    }

    /// Returns the staged text of a value.
    pub(crate) fn text(&self, name: &str) -> Option<&str> {
        let found = self.list.iter().find(|(of, _)| of == name);
        found.map(|(_, text)| text.as_str())
    }

    /// Stages another text for a value, or removes the staged one if `text` equals `present`.
    pub(crate) fn stage(&mut self, name: &str, text: String, present: &str) {
        self.list.retain(|(of, _)| of != name);
        if text != present {
            self.list.push((name.to_owned(), text));
        }
    }
}

/// Staged edits dropped before being applied.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct DroppedEdits {
    pub(crate) edits: StagedEdits,
    /// The scene's text at that time. Later edits must be undone before these are restored.
    pub(crate) text: String,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn staging_keeps_last_edit_and_drops_unchanged_values() {
        let mut gathered = StagedEdits::default();
        gathered.stage("a", "1".into(), "0");
        gathered.stage("b", "2".into(), "0");
        gathered.stage("a", "3".into(), "0");
        assert_eq!(gathered.text("a"), Some("3"));
        assert_eq!(gathered.len(), 2);
        gathered.stage("a", "0".into(), "0");
        assert_eq!(gathered.text("a"), None);
        assert!(!gathered.is_empty());
    }
}
