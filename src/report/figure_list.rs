//! Lists values requested by name at one coordinate of the driver: name, value, unit and error
//! bound.

use super::answers::Answers;
use super::csv_dialect::{CsvDialect, CsvSheet, cell};
use super::entry::{seen, seen_bound};
use super::number::{direction, significant, upwards};
use super::tables::Tables;
use super::tables_data::number;
use super::tables_page::{TableStyle, TablesWriter};
use crate::Ball;
use crate::page::{Page, Setting, Table, TextStyle};
use crate::quantity::{Quantity, state_word};
use crate::solver::{State, Workspace};
use crate::wording::words;
use serde_json::{Map, Value};
use std::io::{self, Write};

/// A requested value.
#[derive(Clone, Debug)]
pub struct ListedFigure {
    /// The quantity.
    pub quantity: Quantity,
    /// Its value; `None` if it does not exist.
    pub value: Option<f64>,
    /// Its error bound, in its own unit; `None` if nothing was proved.
    pub bound: Option<f64>,
}

/// The requested values of one state, in the requested order.
#[derive(Clone, Debug)]
pub struct FigureList<'a> {
    /// The tables of the state, for the heading and the sensitivities, if requested.
    tables: &'a Tables,
    /// The values, one per line.
    pub figures: Vec<ListedFigure>,
}

/// Significant digits of a bound.
const BOUND_DIGITS: usize = 2;
/// Characters besides the digits of a value: sign, point, and an exponent.
const BESIDE_DIGITS: usize = 6;

impl<'a> FigureList<'a> {
    /// Evaluates the values of a state and its enclosure; `tables` are those of the same state.
    #[must_use]
    pub fn new(
        tables: &'a Tables,
        figures: &[Quantity],
        state: &State,
        enclosure: &Workspace<Ball>,
    ) -> Self {
        let listed = figures.iter().map(|quantity| {
            let value = quantity.value(state);
            let bound = value.and_then(|_| quantity.bound(state, enclosure));
            ListedFigure {
                quantity: quantity.clone(),
                value,
                bound,
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
        let valued = self.figures.iter().filter(|figure| figure.value.is_some());
        valued.fold((0, 0), |(all, open), figure| {
            (all + 1, open + u64::from(figure.bound.is_none()))
        })
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
        let heads = std::iter::once(words().value()).chain(bound);
        let mut table = Table::new(words().noun_figure(), heads).set(Setting {
            least: vec![style.digits + BESIDE_DIGITS],
            ..Setting::default()
        });
        for figure in &self.figures {
            let value = figure.shown(style.digits);
            let bound = style.bounds.then(|| figure.shown_bound());
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
        let mut csv = CsvSheet::new(dialect, to);
        let answers = self.tables.answers.as_ref();
        let mut line = |[name, value, unit]: [&str; 3], bound: &str, answer: [&str; 3]| {
            let unit = style.units.then_some(unit);
            let bound = style.bounds.then_some(bound);
            let answer = answers.map(|_| answer).into_iter().flatten();
            let cells = [name, value].into_iter().chain(unit).chain(bound);
            csv.record(cells.chain(answer))
        };
        line(
            ["name", "value", "unit"],
            "bound",
            ["sensitivity", "most", "by"],
        )?;
        for figure in &self.figures {
            let quantity = &figure.quantity;
            let [worst, most, by] = answer_cells(answers, &quantity.name);
            let cells = [&*quantity.name, &cell(figure.value), &*quantity.unit];
            line(cells, &cell(figure.bound), [&worst, &most, &by])?;
        }
        line(
            ["state", state_word(self.tables.condition), ""],
            "",
            [""; 3],
        )?;
        csv.finish()
    }

    /// Returns one object: the scene, the units, the driver's coordinate, the state, and the values
    /// by name as in a row of a sweep; a missing value is `null`.
    #[must_use]
    pub fn to_json(&self, style: TableStyle) -> Value {
        let mut object = Map::new();
        object.insert("scene".into(), self.tables.scene.as_str().into());
        if style.units {
            let units = self
                .quantities()
                .map(|q| (q.name.clone(), q.unit.clone().into()));
            object.insert("units".into(), Value::Object(units.collect()));
        }
        object.insert("driver".into(), self.tables.driver_json());
        let state = state_word(self.tables.condition);
        object.insert("state".into(), state.into());
        let mut figures = Map::new();
        for figure in &self.figures {
            let name = &figure.quantity.name;
            figures.insert(name.clone(), number(figure.value));
            if style.bounds {
                figures.insert(format!("{name}.bound"), number(figure.bound));
            }
        }
        object.insert("figures".into(), figures.into());
        if let Some(answers) = &self.tables.answers {
            object.insert("sensitivity".into(), answers.to_json(style.units));
        }
        Value::Object(object)
    }
}

impl ListedFigure {
    /// Formats the value for display: zero if it is small and within its error bound.
    fn shown(&self, digits: usize) -> String {
        let Some(value) = self.value else {
            return "-".into();
        };
        let value = seen(value, self.bound);
        match self.quantity.is_direction() {
            true => direction(value, digits),
            false => significant(value, digits),
        }
    }

    fn shown_bound(&self) -> String {
        match (
            self.value,
            self.value.and_then(|v| seen_bound(v, self.bound)),
        ) {
            (None, _) => String::new(),
            (Some(_), None) => "?".into(),
            (Some(_), Some(bound)) => upwards(bound, BOUND_DIGITS),
        }
    }
}

/// Formats the sensitivity of a value as cells.
fn answer_cells(answers: Option<&Answers>, name: &str) -> [String; 3] {
    let answer = answers.and_then(|answers| answers.of(name));
    let most = answer.and_then(|answer| answer.most.as_ref());
    let length = most.map_or_else(String::new, |(length, _)| length.clone());
    let worst = cell(answer.map(|answer| answer.worst));
    [worst, length, cell(most.map(|(_, by)| *by))]
}
