//! Comma separated values as those have them who read them: with which decimal mark, and what between the cells.

use super::number::shortest;
use super::rows::plain;
use std::borrow::Cow;
use std::io::{self, Write};

/// The mark between a whole number and its decimals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DecimalMark {
    /// `15.5`, as programs read it.
    #[default]
    Point,
    /// `15,5`, as spreadsheets read it in Turkish and most languages of Europe.
    Comma,
}

impl DecimalMark {
    /// All of them.
    pub const ALL: [DecimalMark; 2] = [DecimalMark::Point, DecimalMark::Comma];

    /// As the options and the configuration name it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            DecimalMark::Point => "point",
            DecimalMark::Comma => "comma",
        }
    }
}

/// What stands between two cells.
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
    /// All of them.
    pub const ALL: [CellSeparator; 3] = [
        CellSeparator::Comma,
        CellSeparator::Semicolon,
        CellSeparator::Tab,
    ];

    /// As the options and the configuration name it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            CellSeparator::Comma => "comma",
            CellSeparator::Semicolon => "semicolon",
            CellSeparator::Tab => "tab",
        }
    }
}

/// How comma separated values are written. Names of columns are the same in all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CsvDialect {
    decimal: DecimalMark,
    separator: CellSeparator,
}

impl Default for CsvDialect {
    /// Points and commas.
    fn default() -> Self {
        CsvDialect {
            decimal: DecimalMark::Point,
            separator: CellSeparator::Comma,
        }
    }
}

impl CsvDialect {
    /// With this decimal mark, and this between the cells or what is usual beside the mark; `None` where a comma
    /// would be both.
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

    /// What stands between two cells.
    pub(super) fn separator(self) -> char {
        match self.separator {
            CellSeparator::Comma => ',',
            CellSeparator::Semicolon => ';',
            CellSeparator::Tab => '\t',
        }
    }

    /// The shortest form of a value at the end of a line; it needs no quotes.
    pub(super) fn push(self, value: f64, line: &mut String) {
        let before = line.len();
        shortest(value, line);
        if self.decimal == DecimalMark::Comma
            && let Some(point) = line[before..].find('.')
        {
            let point = before + point;
            line.replace_range(point..=point, ",");
        }
    }

    /// A cell: a number has the mark, any other text stays as it is.
    fn cell(self, text: &str) -> Cow<'_, str> {
        let is_marked = self.decimal == DecimalMark::Comma && text.contains('.');
        match is_marked && text.parse::<f64>().is_ok() {
            true => text.replace('.', ",").into(),
            false => text.into(),
        }
    }
}

/// Rows of cells on their way out.
pub(super) struct CsvSheet<W: Write> {
    csv: csv::Writer<W>,
    dialect: CsvDialect,
}

impl<W: Write> CsvSheet<W> {
    pub(super) fn new(dialect: CsvDialect, to: W) -> Self {
        let mut builder = csv::WriterBuilder::new();
        let csv = builder.delimiter(dialect.separator() as u8).from_writer(to);
        CsvSheet { csv, dialect }
    }

    /// A row, quoted where that is needed.
    pub(super) fn record(
        &mut self,
        cells: impl IntoIterator<Item = impl AsRef<str>>,
    ) -> io::Result<()> {
        for cell in cells {
            let cell = self.dialect.cell(cell.as_ref());
            self.csv.write_field(cell.as_bytes()).map_err(plain)?;
        }
        self.csv.write_record(None::<&[u8]>).map_err(plain)
    }

    /// All of it is written.
    pub(super) fn finish(mut self) -> io::Result<()> {
        self.csv.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comma_is_never_both() {
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
    fn numbers_have_the_mark_and_names_stay() {
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
}
