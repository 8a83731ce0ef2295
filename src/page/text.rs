//! Writes a page as plain text.

use super::layout::Medium;
use super::{Content, Page, TextRole, TextStyle};

impl Page {
    /// Returns the text, with a newline after every line. If the page has parts, its title and its
    /// parts are underlined.
    #[must_use]
    pub fn to_text(&self, style: TextStyle) -> String {
        let has_parts = |page: &Page| {
            let mut contents = page.blocks.iter().map(|block| &block.content);
            contents.any(|content| matches!(content, Content::Heading(1, _)))
        };
        let is_ruled = has_parts(self);
        let mut text = String::new();
        for line in self.layout(style, Medium::Paper) {
            let written = line.text();
            text.push_str(&written);
            text.push('\n');
            if is_ruled && matches!(line.role(), TextRole::Title | TextRole::Part) {
                text.push_str(&"-".repeat(written.chars().count()));
                text.push('\n');
            }
        }
        text
    }
}
