//! The configuration: what a person wants otherwise than it is built in. It is read where a workbench opens, and
//! never written.

mod keys;
mod template;

pub use template::template;

use crate::capability::{Colours, PictureChoice};
use crate::document::{self, ByteSpan, Diagnostic, Diagnostics, Lenient, Reader};
use crate::drawing::{Blocks, Glyphs};
use crate::files::places;
use crate::nearest::did_you_mean;
use crate::report::{CellSeparator, CsvDialect, DecimalMark};
use crate::tui::appearance::palette::Theme;
use crate::tui::commands::keymap::Keymap;
use crate::tui::views::layout::LayoutName;
use crate::wording::{Language, words};
use serde::Deserialize;
use std::path::PathBuf;

/// What a person wants otherwise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Config {
    /// The characters to draw with; `None` as the terminal allows.
    pub glyphs: Option<Glyphs>,
    /// The colours to draw with; `None` as the terminal allows.
    pub colours: Option<Colours>,
    /// Which colours stand for the names of the palette.
    pub theme: Theme,
    /// How still pictures are sent.
    pub picture: PictureChoice,
    /// Whether the tour is shown on the first start.
    pub tour: bool,
    /// Whether the mouse is ours from the start.
    pub mouse: bool,
    /// The language that is spoken; `None` that of the locale. The program speaks it, not who reads this.
    pub language: Option<Language>,
    /// How CSV files are written.
    pub csv: CsvDialect,
    /// What was found that is not known here; the rest of the configuration holds.
    pub warnings: Option<Diagnostics>,
    pub(crate) layout: LayoutName,
    pub(crate) keymap: Keymap,
}

impl Default for Config {
    /// What is built in.
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

/// A configuration as its file writes it.
#[derive(Debug, Deserialize)]
struct ConfigFile {
    glyphs: Option<Lenient<String>>,
    colour: Option<Lenient<String>>,
    theme: Option<Lenient<String>>,
    picture: Option<Lenient<String>>,
    layout: Option<Lenient<String>>,
    language: Option<Lenient<String>>,
    decimal: Option<Lenient<String>>,
    separator: Option<Lenient<String>>,
    tour: Option<Lenient<bool>>,
    mouse: Option<Lenient<bool>>,
    keys: Option<keys::KeysSection>,
}

/// A value as it is written, and what it means.
type Named<T> = (&'static str, T);

const GLYPHS: [Named<Option<Glyphs>>; 7] = [
    ("auto", None),
    ("ascii", Some(Glyphs::Ascii)),
    ("line", Some(Glyphs::Line)),
    ("braille", Some(Glyphs::Braille)),
    ("quadrants", Some(Glyphs::Blocks(Blocks::Quadrants))),
    ("sextants", Some(Glyphs::Blocks(Blocks::Sextants))),
    ("octants", Some(Glyphs::Blocks(Blocks::Octants))),
];

const COLOURS: [Named<Option<Colours>>; 5] = [
    ("auto", None),
    ("none", Some(Colours::None)),
    ("16", Some(Colours::Sixteen)),
    ("256", Some(Colours::Indexed)),
    ("true", Some(Colours::True)),
];

const THEMES: [Named<Theme>; 4] = [
    ("auto", Theme::Auto),
    ("light", Theme::Light),
    ("dark", Theme::Dark),
    ("plain", Theme::Plain),
];

/// Languages by their names.
fn languages() -> [Named<Option<Language>>; 3] {
    let [english, turkish] = Language::ALL.map(|language| (language.name(), Some(language)));
    [("auto", None), turkish, english]
}

/// Decimal marks by their names.
fn decimals() -> [Named<DecimalMark>; 2] {
    DecimalMark::ALL.map(|mark| (mark.name(), mark))
}

/// What may stand between cells, by its names; `auto` is what is usual beside the decimal mark.
fn separators() -> [Named<Option<CellSeparator>>; 4] {
    let [comma, semicolon, tab] = CellSeparator::ALL.map(|it| (it.name(), Some(it)));
    [("auto", None), comma, semicolon, tab]
}

/// Ways to send pictures by their names.
fn pictures() -> [Named<PictureChoice>; 5] {
    PictureChoice::ALL.map(|choice| (choice.name(), choice))
}

/// Layouts by their names.
fn layouts() -> [Named<LayoutName>; 6] {
    LayoutName::ALL.map(|layout| (layout.name(), layout))
}

impl Config {
    /// Where the configuration is, if anywhere: `env` tells XDG_CONFIG_HOME and HOME.
    #[must_use]
    pub fn path(env: impl Fn(&str) -> Option<PathBuf>) -> Option<PathBuf> {
        let folder = places::folder_of("XDG_CONFIG_HOME", ".config", env)?;
        Some(folder.join("config.toml"))
    }

    /// Reads a configuration from the bytes of a file; `origin` is its name in messages.
    ///
    /// # Errors
    /// Everything found wrong, with its places; keys and actions that are not known here alone are warnings.
    pub fn read(bytes: &[u8], origin: &str) -> Result<Config, Diagnostics> {
        match std::str::from_utf8(bytes) {
            Ok(text) => Config::parse(text, origin),
            Err(error) => Err(document::not_utf8(bytes, error.valid_up_to(), origin)),
        }
    }

    /// Reads a configuration from a text; `origin` is the name of the file in messages.
    ///
    /// # Errors
    /// Everything found wrong, with its places; keys and actions that are not known here alone are warnings.
    pub fn parse(text: &str, origin: &str) -> Result<Config, Diagnostics> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut reader = Reader::new(text);
        let mut config = Config::default();
        if let Some(root) = document::parse::<ConfigFile>(&mut reader, mend) {
            let before = reader.found.len();
            reader.only(words().the_configuration(), &root);
            let unknown = reader.found.iter_mut().skip(before);
            unknown.for_each(|found| found.is_warning = true);
            if let Some(file) = root.get() {
                config.take(&mut reader, file);
            }
        }
        if reader.has_errors() {
            return Err(reader.into_diagnostics(origin));
        }
        config.warnings = (!reader.found.is_empty()).then(|| reader.into_diagnostics(origin));
        Ok(config)
    }

    /// The language that a text asks for, whatever else is wrong with it.
    #[must_use]
    pub(crate) fn language_in(text: &str) -> Option<Language> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let root = document::parse::<ConfigFile>(&mut Reader::new(text), mend)?;
        let written = root.get()?.language.as_ref()?;
        Language::named(written.read.as_ref().ok()?)
    }

    /// Takes over what the file gives; what is wrong with it stays as it is built in.
    fn take(&mut self, reader: &mut Reader<'_>, file: &ConfigFile) {
        let glyphs = choice(reader, "glyphs", &GLYPHS, file.glyphs.as_ref());
        self.glyphs = glyphs.unwrap_or_default();
        let colours = choice(reader, "colour", &COLOURS, file.colour.as_ref());
        self.colours = colours.unwrap_or_default();
        let theme = choice(reader, "theme", &THEMES, file.theme.as_ref());
        self.theme = theme.unwrap_or_default();
        let picture = choice(reader, "picture", &pictures(), file.picture.as_ref());
        self.picture = picture.unwrap_or_default();
        let layout = choice(reader, "layout", &layouts(), file.layout.as_ref());
        self.layout = layout.unwrap_or_default();
        let language = choice(reader, "language", &languages(), file.language.as_ref());
        self.language = language.unwrap_or_default();
        self.csv = dialect(reader, file).unwrap_or_default();
        let tour = file.tour.as_ref();
        let tour = tour.and_then(|value| reader.boolean("`tour`", value));
        self.tour = tour.unwrap_or(self.tour);
        let mouse = file.mouse.as_ref();
        let mouse = mouse.and_then(|value| reader.boolean("`mouse`", value));
        self.mouse = mouse.unwrap_or(self.mouse);
        if let Some(section) = &file.keys {
            keys::read(reader, section, &mut self.keymap);
        }
    }
}

/// How CSV files are written; a comma cannot be both.
fn dialect(reader: &mut Reader<'_>, file: &ConfigFile) -> Option<CsvDialect> {
    let decimal = choice(reader, "decimal", &decimals(), file.decimal.as_ref());
    let separator = choice(reader, "separator", &separators(), file.separator.as_ref());
    let found = CsvDialect::of(decimal.unwrap_or_default(), separator.flatten());
    if let (None, Some(place)) = (found, &file.separator) {
        reader.report(
            Diagnostic::new(words().separator_is_decimal())
                .at(place.span.clone(), words().here())
                .help(words().take_a_semicolon()),
        );
    }
    found
}

/// One of several texts, if it is given.
fn choice<T: Copy>(
    reader: &mut Reader<'_>,
    key: &str,
    known: &[Named<T>],
    value: Option<&Lenient<String>>,
) -> Option<T> {
    let given = reader.string(&format!("`{key}`"), value?)?;
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

/// What was mostly meant where the configuration is not valid TOML.
fn mend(_text: &str, message: &str, _place: &ByteSpan) -> Option<String> {
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
