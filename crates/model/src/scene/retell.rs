//! Rewrites the text of a scene with another title, without comments that refer to its old numbers.

use super::Scene;
use super::rewrite::Edits;
use toml::de::DeTable;

impl Scene {
    /// Returns the text with new values of `name`, `source` and `note`; a missing key is added at
    /// the front. Lines that consist of a comment are removed, because they refer to numbers that
    /// will change.
    ///
    /// The rest of the file stays unchanged. [`Scene::parse`] decides whether the result is a
    /// scene.
    #[must_use]
    pub fn retold(&self, name: &str, source: &str, note: &str) -> String {
        let texts = [("name", name), ("source", source), ("note", note)];
        let mut edits = Edits::default();
        let mut front = String::new();
        // Parsing succeeded before, when the scene was read.
        let root = DeTable::parse(self.text()).ok();
        for (key, text) in texts {
            let value = root.as_ref().and_then(|root| root.get_ref().get(key));
            match value {
                Some(value) => edits.replace(value.span(), toml_string(text)),
                None => front += &format!("{key} = {}\n", toml_string(text)),
            }
        }
        let told = front + &edits.made_in(self.text());
        let lines = told.split_inclusive('\n');
        lines
            .filter(|line| !line.trim_start().starts_with('#'))
            .collect()
    }
}

/// Formats a text as a basic string of TOML.
pub fn toml_string(text: &str) -> String {
    let mut string = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => string.extend(['\\', c]),
            c if c.is_control() => string += &format!("\\u{:04x}", u32::from(c)),
            c => string.push(c),
        }
    }
    string + "\""
}

#[cfg(test)]
mod tests {
    use super::super::presets;
    use super::*;

    #[test]
    fn retold_replaces_titles_and_keeps_numbers() {
        for preset in presets::all() {
            let scene = Scene::parse(preset.text, preset.name).unwrap();
            let text = scene.retold("a \"b\" \\", "here", "so");
            let again = Scene::parse(&text, preset.name).unwrap();
            assert_eq!(again.name, "a \"b\" \\");
            assert_eq!(again.source.as_deref(), Some("here"));
            assert_eq!(again.note.as_deref(), Some("so"));
            let numbers = |scene: &Scene| -> Vec<String> {
                let values = scene.values().into_iter();
                values.map(|v| v.name.clone() + " " + &v.text()).collect()
            };
            assert_eq!(numbers(&again), numbers(&scene), "{}", preset.name);
            assert!(!text.lines().any(|line| line.starts_with('#')), "{text}");
        }
    }

    #[test]
    fn toml_string_escapes_quotes_and_control_characters() {
        assert_eq!(toml_string("a\n\"\u{7}\\"), r#""a\u000a\"\u0007\\""#);
    }

    #[test]
    fn retold_prepends_missing_titles() {
        let body = "# mine\n[ground]\nA = [0, 0]\n[driver]\nlink = \"r\"\nangle = 1\n\
            [links]\nr = { from = \"A\", to = \"B\", length = 1 } # mm\n";
        let scene = Scene::parse(body, "test").unwrap();
        let text = scene.retold("n", "s", "t");
        let front = "name = \"n\"\nsource = \"s\"\nnote = \"t\"\n";
        assert_eq!(text, front.to_owned() + body.trim_start_matches("# mine\n"));
    }
}
