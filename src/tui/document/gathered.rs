//! Edits that wait to be made together: what lies between them may be no linkage at all.

/// What is to stand for some values, each by its name.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct GatheredEdits {
    list: Vec<(String, String)>,
}

impl GatheredEdits {
    pub(crate) fn len(&self) -> usize {
        self.list.len()
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The edits in the order in which they were made.
    pub(crate) fn list(&self) -> &[(String, String)] {
        &self.list
    }

    /// What waits for a value.
    pub(crate) fn text(&self, name: &str) -> Option<&str> {
        let found = self.list.iter().find(|(of, _)| of == name);
        found.map(|(_, text)| text.as_str())
    }

    /// Another text waits for a value, and none where it is the `present` one.
    pub(crate) fn put(&mut self, name: &str, text: String, present: &str) {
        self.list.retain(|(of, _)| of != name);
        if text != present {
            self.list.push((name.to_owned(), text));
        }
    }
}

/// Edits that were dropped before they were made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct DroppedEdits {
    pub(crate) edits: GatheredEdits,
    /// That of the scene then: what is edited since is taken back before they are.
    pub(crate) text: String,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_edit_of_a_value_waits_and_what_changes_nothing_does_not() {
        let mut gathered = GatheredEdits::default();
        gathered.put("a", "1".into(), "0");
        gathered.put("b", "2".into(), "0");
        gathered.put("a", "3".into(), "0");
        assert_eq!(gathered.text("a"), Some("3"));
        assert_eq!(gathered.len(), 2);
        gathered.put("a", "0".into(), "0");
        assert_eq!(gathered.text("a"), None);
        assert!(!gathered.is_empty());
    }
}
