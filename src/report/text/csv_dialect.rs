//! Dialects of comma separated values: decimal mark and separator.

use crate::report::text::number::{MAX_FIXED, shortest, shortest_with_plus};
use std::borrow::Cow;
use std::io::{self, Write};

/// The decimal mark.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DecimalMark {
    /// `15.5`, as programs read it.
    #[default]
    Point,
    /// `15,5`, as spreadsheets read it in Turkish and most European languages.
    Comma,
}

impl DecimalMark {
    /// All decimal marks.
    pub const ALL: [DecimalMark; 2] = [DecimalMark::Point, DecimalMark::Comma];

    /// Returns the name used in options and in the configuration.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            DecimalMark::Point => "point",
            DecimalMark::Comma => "comma",
        }
    }
}

/// The separator of cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CellSeparator {
    /// `,`
    Comma,
    /// `;`
    Semicolon,
    /// A tab.
    Tab,
}

impl CellSeparator {
    /// All separators.
    pub const ALL: [CellSeparator; 3] = [
        CellSeparator::Comma,
        CellSeparator::Semicolon,
        CellSeparator::Tab,
    ];

    /// Returns the name used in options and in the configuration.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            CellSeparator::Comma => "comma",
            CellSeparator::Semicolon => "semicolon",
            CellSeparator::Tab => "tab",
        }
    }
}

/// A dialect of comma separated values. Names of columns are the same in all dialects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CsvDialect {
    decimal: DecimalMark,
    separator: CellSeparator,
}

impl Default for CsvDialect {
    /// Returns the dialect with decimal points and commas as separators.
    fn default() -> Self {
        CsvDialect {
            decimal: DecimalMark::Point,
            separator: CellSeparator::Comma,
        }
    }
}

/// Maximum length of a number in bytes: sign, 17 digits, point, and an exponent such as `e-308`.
const MAX_NUMBER: usize = 24;

impl CsvDialect {
    /// Creates a dialect with this decimal mark, and this separator or the usual one for the mark.
    /// Returns `None` if a comma would have both roles.
    #[must_use]
    pub fn of(decimal: DecimalMark, separator: Option<CellSeparator>) -> Option<CsvDialect> {
        let usual = match decimal {
            DecimalMark::Point => CellSeparator::Comma,
            DecimalMark::Comma => CellSeparator::Semicolon,
        };
        let separator = separator.unwrap_or(usual);
        let both = decimal == DecimalMark::Comma && separator == CellSeparator::Comma;
        (!both).then_some(CsvDialect { decimal, separator })
    }

    /// Returns the separator of cells.
    pub(in crate::report) fn separator(self) -> char {
        match self.separator {
            CellSeparator::Comma => ',',
            CellSeparator::Semicolon => ';',
            CellSeparator::Tab => '\t',
        }
    }

    /// Appends the shortest form of a value to a line; it needs no quotes.
    pub(in crate::report) fn push(self, value: f64, line: &mut String) {
        let before = line.len();
        shortest(value, line);
        if self.decimal == DecimalMark::Comma
            && let Some(point) = line[before..].find('.')
        {
            let point = before + point;
            line.replace_range(point..=point, ",");
        }
    }

    /// Writes cells of numbers to the start of a buffer, each with a separator behind it, and returns their
    /// length. Missing numbers are empty.
    ///
    /// A sweep spends most of its time here: `String` would test its capacity several times per cell.
    pub(in crate::report) fn fill(self, numbers: &[Option<f64>], buffer: &mut Vec<u8>) -> usize {
        buffer.resize(numbers.len() * (MAX_NUMBER + 1), 0);
        let separator = self.separator() as u8;
        let has_comma = self.decimal == DecimalMark::Comma;
        let mut text = zmij::Buffer::new();
        let mut end = 0;
        for number in numbers {
            if let Some(value) = *number {
                let begin = end;
                let text = shortest_with_plus(value, &mut text);
                end += text.len();
                buffer[begin..end].copy_from_slice(text.as_bytes());
                if value.abs() >= MAX_FIXED
                    && let Some(plus) = buffer[begin..end].iter().position(|&byte| byte == b'+')
                {
                    buffer.copy_within(begin + plus + 1..end, begin + plus);
                    end -= 1;
                }
                if has_comma
                    && let Some(point) = buffer[begin..end].iter_mut().find(|byte| **byte == b'.')
                {
                    *point = b',';
                }
            }
            buffer[end] = separator;
            end += 1;
        }
        end
    }

    /// Appends a word to a line, with quotes if needed.
    pub(in crate::report) fn push_word(self, word: &str, line: &mut String) {
        match word.contains([self.separator(), '"', '\n', '\r']) {
            true => *line += &format!("\"{}\"", word.replace('"', "\"\"")),
            false => line.push_str(word),
        }
    }

    /// Formats a row of cells.
    pub(in crate::report) fn record(
        self,
        cells: impl IntoIterator<Item = impl AsRef<str>>,
    ) -> String {
        let mut line = String::new();
        for (number, cell) in cells.into_iter().enumerate() {
            if number > 0 {
                line.push(self.separator());
            }
            self.push_word(&self.cell(cell.as_ref()), &mut line);
        }
        line + "\n"
    }

    /// Returns a cell with the dialect's decimal mark in a number; other text stays unchanged.
    fn cell(self, text: &str) -> Cow<'_, str> {
        let is_marked = self.decimal == DecimalMark::Comma && text.contains('.');
        match is_marked && text.parse::<f64>().is_ok() {
            true => text.replace('.', ",").into(),
            false => text.into(),
        }
    }
}

/// Returns the shortest form of a value; empty for a missing one.
pub(in crate::report) fn cell(value: Option<f64>) -> String {
    let mut text = String::new();
    if let Some(value) = value.filter(|value| value.is_finite()) {
        shortest(value, &mut text);
    }
    text
}

/// Writes rows of cells.
pub(in crate::report) struct CsvSheet<W: Write> {
    to: W,
    dialect: CsvDialect,
}

impl<W: Write> CsvSheet<W> {
    pub(in crate::report) fn new(dialect: CsvDialect, to: W) -> Self {
        CsvSheet { to, dialect }
    }

    /// Writes a row, with quotes where needed.
    pub(in crate::report) fn record(
        &mut self,
        cells: impl IntoIterator<Item = impl AsRef<str>>,
    ) -> io::Result<()> {
        self.to.write_all(self.dialect.record(cells).as_bytes())
    }

    /// Flushes the output.
    pub(in crate::report) fn finish(mut self) -> io::Result<()> {
        self.to.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comma_cannot_be_decimal_mark_and_separator() {
        use CellSeparator::{Comma, Semicolon, Tab};
        let of = |decimal, separator| Some(CsvDialect::of(decimal, separator)?.separator());
        assert_eq!(of(DecimalMark::Point, None), Some(','));
        assert_eq!(of(DecimalMark::Comma, None), Some(';'));
        assert_eq!(of(DecimalMark::Comma, Some(Tab)), Some('\t'));
        assert_eq!(of(DecimalMark::Point, Some(Semicolon)), Some(';'));
        assert_eq!(of(DecimalMark::Comma, Some(Comma)), None);
        assert_eq!(
            CsvDialect::of(DecimalMark::Point, None),
            Some(CsvDialect::default())
        );
    }

    #[test]
    fn decimal_mark_applies_only_to_numbers() {
        let dialect = CsvDialect::of(DecimalMark::Comma, None).unwrap();
        let mut bytes = Vec::new();
        let mut sheet = CsvSheet::new(dialect, &mut bytes);
        sheet
            .record(["C.x [mm]", "a;b", "-1.5e-7", "12", "", "1.5 mm"])
            .unwrap();
        sheet.finish().unwrap();
        let text = String::from_utf8(bytes).unwrap();
        assert_eq!(text, "C.x [mm];\"a;b\";-1,5e-7;12;;1.5 mm\n");
        let mut line = "0.5;".to_owned();
        dialect.push(-0.25, &mut line);
        assert_eq!(line, "0.5;-0,25");
    }

    #[test]
    fn numbers_fill_a_buffer_as_single_cells_do() {
        let values = [
            0.0,
            -0.0,
            1.5,
            -250.0,
            1e16,
            -1.234_567_890_123_456_7e300,
            5e-324,
            -2.5e-7,
        ];
        let comma = CsvDialect::of(DecimalMark::Comma, None).unwrap();
        for dialect in [CsvDialect::default(), comma] {
            let numbers: Vec<Option<f64>> = values.into_iter().map(Some).chain([None]).collect();
            let mut buffer = Vec::new();
            let end = dialect.fill(&numbers, &mut buffer);
            let mut expected = String::new();
            for number in numbers {
                if let Some(value) = number {
                    dialect.push(value, &mut expected);
                }
                expected.push(dialect.separator());
            }
            assert_eq!(std::str::from_utf8(&buffer[..end]), Ok(&*expected));
        }
        let mut line = String::new();
        comma.push(-1.25e300, &mut line);
        assert_eq!(line, "-1,25e300");
    }
}
