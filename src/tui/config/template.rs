//! The configuration as a text to begin with: everything that is built in, commented out.

use super::{COLOURS, GLYPHS, Named, THEMES, keys};
use crate::tui::commands::key::Key;
use crate::tui::views::help::keys::groups;

/// Column in which comments begin.
const COMMENT: usize = 36;

/// A configuration with every key and what is built in, commented out.
///
/// Lines that set something begin with `#` and no blank: without it they are what is built in.
#[must_use]
pub fn template() -> String {
    let mut text = "\
# The configuration of krank, read from $XDG_CONFIG_HOME/krank/config.toml, or from
# ~/.config/krank/config.toml where that is not set. krank never writes it.
#
# Everything here is commented out and says what is built in: take away the # before a
# line to change it. What is wrong is told with its line when krank starts.

"
    .to_owned();
    let mut set = |key: &str, value: &str, what: &str| text.push_str(&line(key, value, what));
    set(
        "glyphs",
        "\"auto\"",
        &format!("to draw with: {}", values(&GLYPHS)),
    );
    set("colour", "\"auto\"", &values(&COLOURS));
    set(
        "theme",
        "\"auto\"",
        &format!("for a ground: {}", values(&THEMES)),
    );
    set(
        "tour",
        "true",
        "the tour is shown on the first start: true or false",
    );
    text.push_str(
        "
[keys]
# A key or a list of keys for each action, written as the help shows them: \"g\", \"space\",
# \"F5\", \"Ctrl-R\", \"PgUp\". An empty list takes the keys away. Ctrl-C always leaves, and Esc
# always goes back.
",
    );
    for (title, entries) in groups(None) {
        text.push_str(&format!("\n# {title}\n"));
        for entry in entries.into_iter().filter(|entry| keys::is_free(entry)) {
            text.push_str(&line(
                &keys::name_of(entry),
                &keys_text(entry.keys),
                entry.help,
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

/// As TOML writes a text.
fn quoted(text: &str) -> String {
    let escaped = text.replace('\\', "\\\\").replace('"', "\\\"");
    format!("\"{escaped}\"")
}
