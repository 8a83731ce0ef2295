//! Lists values requested by name at one coordinate of the driver: name, value, unit and error
//! bound.

use crate::Ball;
use crate::page::{Page, Setting, Table, TextStyle};
use crate::quantity::Quantity;
use crate::report::tables::data::{ValueSheet, insert};
use crate::report::tables::entry::Entry;
use crate::report::tables::page::{TableStyle, TablesWriter, shown, shown_bound};
use crate::report::tables::{Tables, unproved};
use crate::report::text::csv_dialect::CsvDialect;
use crate::solver::State;
use crate::wording::words;
use serde_json::{Map, Value};
use std::io::{self, Write};

/// A requested value.
#[derive(Clone, Debug)]
pub struct ListedFigure {
    /// The quantity.
    pub quantity: Quantity,
    /// The value with its error bound.
    pub entry: Entry,
}

/// The requested values of one state, in the requested order.
#[derive(Clone, Debug)]
pub struct FigureList<'a> {
    /// The tables of the state, for the heading and the sensitivities, if requested.
    tables: &'a Tables,
    /// The values, one per line.
    pub figures: Vec<ListedFigure>,
}

/// Characters besides the digits of a value: sign, point, and an exponent.
const EXTRA_CHARACTERS: usize = 6;

impl<'a> FigureList<'a> {
    /// Evaluates the values of a state, with error bounds if there is an enclosure; `tables` are
    /// those of the same state.
    #[must_use]
    pub fn new(
        tables: &'a Tables,
        quantities: &[Quantity],
        state: &State,
        enclosure: Option<&State<Ball>>,
    ) -> Self {
        let listed = quantities.iter().map(|quantity| {
            let value = quantity.value(state);
            ListedFigure {
                quantity: quantity.clone(),
                entry: Entry {
                    value,
                    given: false,
                    bound: value.and_then(|_| quantity.bound(state, enclosure?)),
                },
            }
        });
        FigureList {
            tables,
            figures: listed.collect(),
        }
    }

    /// Returns the quantities.
    pub fn quantities(&self) -> impl Iterator<Item = &Quantity> {
        self.figures.iter().map(|figure| &figure.quantity)
    }

    /// Returns the number of existing values, and the number of these without a bound.
    #[must_use]
    pub fn unproved(&self) -> (u64, u64) {
        unproved(self.figures.iter().map(|figure| figure.entry))
    }

    /// Formats the values as text, one per line.
    #[must_use]
    pub fn to_text(&self, style: TableStyle) -> String {
        let mut page = Page::default();
        TablesWriter::new(self.tables, style).add_heading(&mut page);
        page.table(self.table(style));
        if style.bounds {
            page.text(words().bounds_are());
        }
        if let Some(answers) = &self.tables.answers {
            page.add(answers.clone().content(style.units));
        }
        page.to_text(TextStyle::plain(style.ascii))
    }

    fn table(&self, style: TableStyle) -> Table {
        let bound = style.bounds.then_some("+-");
        let headers = std::iter::once(words().value()).chain(bound);
        let mut table = Table::new(words().noun_figure(), headers).set(Setting {
            least: vec![style.digits + EXTRA_CHARACTERS],
            ..Setting::default()
        });
        for figure in &self.figures {
            let value = shown(figure.entry, figure.quantity.is_direction(), style.digits);
            let bound = style.bounds.then(|| shown_bound(figure.entry));
            let name = match style.units {
                true => figure.quantity.header(),
                false => figure.quantity.name.clone(),
            };
            table.row(name, std::iter::once(value).chain(bound));
        }
        table
    }

    /// Writes one line per value: `name,value,unit`, followed by the error `bound` and by the
    /// `sensitivity`, the length with the largest derivative (`most`) and that derivative (`by`),
    /// if requested. The last line is the state.
    ///
    /// # Errors
    /// Returns the errors of the writer.
    pub fn write_csv(
        &self,
        style: TableStyle,
        dialect: CsvDialect,
        to: impl Write,
    ) -> io::Result<()> {
        let answers = self.tables.answers.as_ref();
        let mut lines = ValueSheet::new(style, dialect, answers, false, to)?;
        for ListedFigure { quantity, entry } in &self.figures {
            lines.value(&quantity.name, &quantity.unit, *entry)?;
        }
        lines.finish(self.tables.condition)
    }

    /// Returns one object: the scene, the units, the driver's coordinate, the state, and the values
    /// by name as in a row of a sweep; a missing value is `null`.
    #[must_use]
    pub fn to_json(&self, style: TableStyle) -> Value {
        let units = self.quantities();
        let units = units.map(|q| (q.name.clone(), q.unit.clone().into()));
        let units = style.units.then(|| Value::Object(units.collect()));
        let mut object = self.tables.head_json(units);
        let mut figures = Map::new();
        for ListedFigure { quantity, entry } in &self.figures {
            insert(&mut figures, &quantity.name, entry, style.bounds);
        }
        object.insert("figures".into(), figures.into());
        if let Some(answers) = &self.tables.answers {
            object.insert("sensitivity".into(), answers.to_json(style.units));
        }
        Value::Object(object)
    }
}
