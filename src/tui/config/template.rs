//! Writes a configuration file to start with: all defaults, commented out.

use super::{
    Named, colours, decimals, glyphs, keys, languages, layouts, pictures, separators, themes,
};
use crate::tui::commands::key::Key;
use crate::tui::views::help::keys::groups;
use crate::wording::words;

/// Column of the comments.
const COMMENT: usize = 36;

/// Returns a configuration with every key and its default, commented out.
///
/// Lines with settings begin with `#` and no blank; without the `#` they set the defaults.
#[must_use]
pub fn template() -> String {
    let mut text = words().template_head().to_owned();
    let mut set = |key: &str, value: &str, what: &str| text.push_str(&line(key, value, what));
    // There are so many names that quotation marks would make the line too long.
    let glyphs = values(&glyphs()).replace('"', "");
    set("glyphs", "\"auto\"", &glyphs);
    set("colour", "\"auto\"", &values(&colours()));
    set(
        "theme",
        "\"auto\"",
        &words().for_a_ground(&values(&themes())),
    );
    set(
        "picture",
        "\"auto\"",
        &words().pictures_are_sent_by(&values(&pictures())),
    );
    set(
        "layout",
        "\"auto\"",
        &words().panes_stand_as(&values(&layouts())),
    );
    set(
        "language",
        "\"auto\"",
        &words().languages_are(&values(&languages())),
    );
    set(
        "decimal",
        "\"point\"",
        &words().decimals_of_csv(&values(&decimals())),
    );
    set(
        "separator",
        "\"auto\"",
        &words().separators_of_csv(&values(&separators())),
    );
    set("tour", "true", words().tour_on_first_start());
    set("mouse", "false", words().mouse_from_the_start());
    text.push_str(words().template_keys());
    for (title, entries) in groups(None) {
        text.push_str(&format!("\n# {title}\n"));
        for entry in entries.into_iter().filter(|entry| keys::is_free(entry)) {
            text.push_str(&line(
                entry.name,
                &keys_text(entry.keys),
                (entry.help)(words()),
            ));
        }
    }
    text
}

fn line(key: &str, value: &str, what: &str) -> String {
    let setting = format!("#{key} = {value}");
    format!("{setting:COMMENT$} # {what}\n")
}

fn values<T>(named: &[Named<T>]) -> String {
    let names: Vec<String> = named
        .iter()
        .map(|(name, _)| format!("\"{name}\""))
        .collect();
    names.join(", ")
}

fn keys_text(keys: &[Key]) -> String {
    let keys: Vec<String> = keys.iter().map(|key| quoted(&key.to_string())).collect();
    match &keys[..] {
        [one] => one.clone(),
        several => format!("[{}]", several.join(", ")),
    }
}

/// Quotes a text as a TOML string.
fn quoted(text: &str) -> String {
    let escaped = text.replace('\\', "\\\\").replace('"', "\\\"");
    format!("\"{escaped}\"")
}
