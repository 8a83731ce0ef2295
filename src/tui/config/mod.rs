//! The user's configuration. It is read when a workbench opens, and never written.

mod keys;
mod template;

pub use template::template;

use crate::capability::{Colours, PictureChoice};
use crate::document::{self, ByteSpan, Diagnostic, Diagnostics, DocumentKind, Entries, Reader};
use crate::drawing::Glyphs;
use crate::files::directories;
use crate::nearest::did_you_mean;
use crate::report::{CellSeparator, CsvDialect, DecimalMark};
use crate::tui::appearance::palette::Theme;
use crate::tui::commands::keymap::Keymap;
use crate::tui::views::layout::LayoutName;
use crate::wording::{Language, words};
use std::path::PathBuf;

/// The user's configuration.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Config {
    /// The characters to draw with; `None` means the best ones for the terminal.
    pub glyphs: Option<Glyphs>,
    /// The number of colours; `None` means as many as the terminal supports.
    pub colours: Option<Colours>,
    /// The set of colours for the names of the palette.
    pub theme: Theme,
    /// The protocol for still images.
    pub picture: PictureChoice,
    /// Whether the tour is shown on the first start.
    pub tour: bool,
    /// Whether the mouse is captured from the start.
    pub mouse: bool,
    /// The language; `None` means the locale's. Reading the configuration does not switch the
    /// language; the program does.
    pub language: Option<Language>,
    /// The format of CSV files.
    pub csv: CsvDialect,
    /// Warnings about unknown keys and actions; the rest of the configuration is valid.
    pub warnings: Option<Diagnostics>,
    pub(crate) layout: LayoutName,
    pub(crate) keymap: Keymap,
}

impl Default for Config {
    /// Returns the built-in configuration.
    fn default() -> Self {
        Config {
            glyphs: None,
            colours: None,
            theme: Theme::default(),
            picture: PictureChoice::default(),
            tour: true,
            mouse: false,
            language: None,
            csv: CsvDialect::default(),
            warnings: None,
            layout: LayoutName::default(),
            keymap: Keymap::default(),
        }
    }
}

/// The keys of the configuration.
const KEYS: [&str; 11] = [
    "glyphs",
    "colour",
    "theme",
    "picture",
    "layout",
    "language",
    "decimal",
    "separator",
    "tour",
    "mouse",
    "keys",
];

/// A value as written in the file, and its meaning.
type Named<T> = (&'static str, T);

/// Returns values with their names.
fn named<T: Copy>(
    values: impl IntoIterator<Item = T>,
    name: fn(T) -> &'static str,
) -> Vec<Named<T>> {
    let values = values.into_iter();
    values.map(|value| (name(value), value)).collect()
}

/// Returns values with their names after `auto`, which lets krank choose.
fn or_auto<T: Copy>(
    values: impl IntoIterator<Item = T>,
    name: fn(T) -> &'static str,
) -> Vec<Named<Option<T>>> {
    let values = values.into_iter();
    let values = values.map(|value| (name(value), Some(value)));
    [("auto", None)].into_iter().chain(values).collect()
}

fn glyphs() -> Vec<Named<Option<Glyphs>>> {
    or_auto(Glyphs::ALL, Glyphs::name)
}

fn colours() -> Vec<Named<Option<Colours>>> {
    or_auto(Colours::ALL, Colours::name)
}

fn themes() -> Vec<Named<Theme>> {
    named(Theme::ALL, Theme::name)
}

fn languages() -> Vec<Named<Option<Language>>> {
    or_auto(Language::ALL.into_iter().rev(), Language::name)
}

fn decimals() -> Vec<Named<DecimalMark>> {
    named(DecimalMark::ALL, DecimalMark::name)
}

/// Returns the cell separators; `auto` is the usual one for the decimal mark.
fn separators() -> Vec<Named<Option<CellSeparator>>> {
    or_auto(CellSeparator::ALL, CellSeparator::name)
}

fn pictures() -> Vec<Named<PictureChoice>> {
    named(PictureChoice::ALL, PictureChoice::name)
}

fn layouts() -> Vec<Named<LayoutName>> {
    named(LayoutName::ALL, LayoutName::name)
}

impl Config {
    /// Returns the path of the configuration, if there is one. `env` returns the values of the
    /// environment variables XDG_CONFIG_HOME and HOME.
    #[must_use]
    pub fn path(env: impl Fn(&str) -> Option<PathBuf>) -> Option<PathBuf> {
        let folder = directories::folder_of("XDG_CONFIG_HOME", ".config", env)?;
        Some(folder.join("config.toml"))
    }

    /// Reads a configuration from the bytes of a file; `origin` is its name in messages.
    ///
    /// # Errors
    /// Returns all faults with their places. Unknown keys and actions alone are only warnings.
    pub fn read(bytes: &[u8], origin: &str) -> Result<Config, Diagnostics> {
        Config::parse(document::utf8_text(bytes, origin)?, origin)
    }

    /// Parses a configuration; `origin` is the file's name in messages.
    ///
    /// # Errors
    /// Returns all faults with their places. Unknown keys and actions alone are only warnings.
    pub fn parse(text: &str, origin: &str) -> Result<Config, Diagnostics> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut reader = Reader::new(text, DocumentKind::Configuration);
        let mut config = Config::default();
        if let Some(file) = document::parse(&mut reader, fix) {
            let before = reader.found.len();
            let names = document::entries(&file).map(|(name, _)| name);
            reader.only_these(words().the_configuration(), names, &KEYS);
            let unknown = reader.found.iter_mut().skip(before);
            unknown.for_each(|found| found.is_warning = true);
            config.take(&mut reader, &file);
        }
        if reader.has_errors() {
            return Err(reader.into_diagnostics(origin));
        }
        config.warnings = (!reader.found.is_empty()).then(|| reader.into_diagnostics(origin));
        Ok(config)
    }

    /// Returns the language set in a configuration, even if the rest of it is invalid.
    #[must_use]
    pub(crate) fn language_in(text: &str) -> Option<Language> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let file = document::parse(&mut Reader::new(text, DocumentKind::Configuration), fix)?;
        Language::named(file.get("language")?.get_ref().as_str()?)
    }

    /// Applies the values in the file; invalid ones keep their defaults.
    fn take(&mut self, reader: &mut Reader<'_>, file: &Entries<'_>) {
        let glyphs = choice(reader, "glyphs", &glyphs(), file);
        self.glyphs = glyphs.unwrap_or_default();
        let colours = choice(reader, "colour", &colours(), file);
        self.colours = colours.unwrap_or_default();
        let theme = choice(reader, "theme", &themes(), file);
        self.theme = theme.unwrap_or_default();
        let picture = choice(reader, "picture", &pictures(), file);
        self.picture = picture.unwrap_or_default();
        let layout = choice(reader, "layout", &layouts(), file);
        self.layout = layout.unwrap_or_default();
        let language = choice(reader, "language", &languages(), file);
        self.language = language.unwrap_or_default();
        self.csv = dialect(reader, file).unwrap_or_default();
        let tour = file.get("tour");
        let tour = tour.and_then(|value| reader.boolean("`tour`", value));
        self.tour = tour.unwrap_or(self.tour);
        let mouse = file.get("mouse");
        let mouse = mouse.and_then(|value| reader.boolean("`mouse`", value));
        self.mouse = mouse.unwrap_or(self.mouse);
        if let Some(section) = file.get("keys") {
            keys::read(reader, section, &mut self.keymap);
        }
    }
}

/// Returns the format of CSV files. A comma cannot be both decimal mark and separator.
fn dialect(reader: &mut Reader<'_>, file: &Entries<'_>) -> Option<CsvDialect> {
    let decimal = choice(reader, "decimal", &decimals(), file);
    let separator = choice(reader, "separator", &separators(), file);
    let found = CsvDialect::of(decimal.unwrap_or_default(), separator.flatten());
    if let (None, Some(place)) = (found, file.get("separator")) {
        reader.report(
            Diagnostic::new(words().separator_is_decimal())
                .at(place.span(), words().here())
                .help(words().take_a_semicolon()),
        );
    }
    found
}

/// Returns the meaning of one of several known texts, if it is given and valid.
fn choice<T: Copy>(
    reader: &mut Reader<'_>,
    key: &str,
    known: &[Named<T>],
    file: &Entries<'_>,
) -> Option<T> {
    let given = reader.string(&format!("`{key}`"), file.get(key)?)?;
    let found = known.iter().find(|(name, _)| *name == given.text);
    if found.is_none() {
        let names = || known.iter().map(|(name, _)| *name);
        let all: Vec<&str> = names().collect();
        reader.report(
            Diagnostic::new(words().value_cannot_be(key, &given))
                .at(given.span.clone(), words().unknown_value())
                .maybe_help(did_you_mean(given.text, names()))
                .help(words().known_values(&format!("\"{}\"", all.join("\", \"")))),
        );
    }
    found.map(|(_, meaning)| *meaning)
}

/// Returns a hint on the usual cause of invalid TOML.
fn fix(_text: &str, message: &str, _place: &ByteSpan) -> Option<String> {
    let help = if message.starts_with("string values must be quoted") {
        words().quote_texts_and_keys()
    } else if message.starts_with("key with no value") {
        words().write_name_and_value()
    } else {
        return None;
    };
    Some(help.to_owned())
}

#[cfg(test)]
mod tests;
