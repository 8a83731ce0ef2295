//! Formats the tables as a page.

use crate::page::{Page, Setting, Table, TextStyle};
use crate::quantity::{Aspect, state_word};
use crate::report::tables::entry::Entry;
use crate::report::tables::{ORDERS, Tables, index, point_aspects, point_entries};
use crate::report::text::number::{concise, direction, perpendicular_up, significant};
use crate::scene::from_seat;
use crate::solver::Order;
use crate::wording::words;

/// The style of tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TableStyle {
    /// Significant digits of text; CSV and JSON have all digits.
    pub digits: usize,
    /// Whether units are shown.
    pub units: bool,
    /// Whether error bounds are shown; in text they are in a line below the values.
    pub bounds: bool,
    /// Whether the scene's title is restricted to ASCII in text; the rest always is ASCII.
    pub ascii: bool,
}

impl Tables {
    /// Formats the tables as text: a column per vector, then a line per point.
    #[must_use]
    pub fn to_text(&self, style: TableStyle) -> String {
        self.page(style).to_text(TextStyle::plain(style.ascii))
    }

    /// Returns the tables as a page: a column per vector, then a line per point.
    #[must_use]
    pub fn page(&self, style: TableStyle) -> Page {
        let writer = TablesWriter::new(self, style);
        let mut page = Page::default();
        writer.add_heading(&mut page);
        for order in ORDERS {
            page.table(writer.vector_table(order));
        }
        writer.add_legend(&mut page);
        if !self.points.is_empty() {
            for order in ORDERS {
                page.table(writer.point_table(order));
            }
        }
        if let Some(forces) = &self.forces {
            writer.add_forces(forces, &mut page);
        }
        if let Some(answers) = &self.answers {
            page.add(answers.clone().without_trivial().content(style.units));
        }
        page
    }
}

/// Widths of the labels, which align the tables below each other.
pub(in crate::report) const VECTOR_LABELS: usize = "alpha [rad/s^2]".len() + 2;
pub(in crate::report) fn point_labels() -> usize {
    let titles = ORDERS.map(|order| words().of_points(title(order)).chars().count());
    titles.into_iter().max().unwrap_or(0)
}

/// Returns a layout with these minimum widths of names and columns.
pub(in crate::report) fn set(names: usize, columns: usize) -> Setting {
    Setting {
        names,
        least: vec![columns],
        ..Setting::default()
    }
}

/// The label of a line of bounds, and their significant digits.
pub(in crate::report) const BOUND: &str = "  +-";
const BOUND_DIGITS: usize = 2;

/// The names of a vector's length and direction, and of their rates.
const VECTOR_NAMES: [[&str; 2]; 3] = [["r", "theta"], ["dr/dt", "omega"], ["d2r/dt2", "alpha"]];

/// Returns the title of a table.
fn title(order: Order) -> &'static str {
    let titles = [
        words().position(),
        words().velocity(),
        words().acceleration(),
    ];
    titles[index(order)]
}

pub(in crate::report) struct TablesWriter<'a> {
    tables: &'a Tables,
    pub(in crate::report) style: TableStyle,
}

impl<'a> TablesWriter<'a> {
    pub(in crate::report) fn new(tables: &'a Tables, style: TableStyle) -> Self {
        TablesWriter { tables, style }
    }
}

impl TablesWriter<'_> {
    /// Adds the title, the driver's line and the state.
    pub(in crate::report) fn add_heading(&self, page: &mut Page) {
        let driver = &self.tables.driver;
        let aspects = driver.aspects();
        // The coordinate has all its digits; rates converted from rpm or deg/s may have meaningless
        // ones.
        let digits = [usize::MAX, self.style.digits, self.style.digits];
        let [at, speed, acceleration]: [String; 3] = std::array::from_fn(|i| {
            let value = concise(driver.values[i], digits[i]);
            format!("{value} {}", aspects[i].unit(self.tables.unit))
        });
        page.title(&words().translated_scene_text(&self.tables.scene));
        let name = from_seat(&driver.name, driver.from.as_deref());
        page.text_below(words().driver_at(&name, &at, &speed, &acceleration));
        page.text_below(
            words().state_is(&words().condition_called(state_word(self.tables.condition))),
        );
    }

    /// Returns `name [unit]`, or the name alone.
    pub(in crate::report) fn label(&self, name: &str, aspect: Aspect) -> String {
        if self.style.units {
            format!("{name} [{}]", aspect.unit(self.tables.unit))
        } else {
            name.to_owned()
        }
    }

    /// Returns the name of a column of directions.
    pub(in crate::report) fn direction(&self) -> String {
        self.label(words().direction(), Aspect::Angle)
    }

    fn vector_table(&self, order: Order) -> Table {
        let order_index = index(order);
        let vectors = &self.tables.vectors;
        // Sign, point and star besides the digits.
        let names = vectors.iter().map(|v| format!("{} ", v.name));
        let setting = set(VECTOR_LABELS, self.style.digits + 3);
        let mut table = Table::new(title(order), names).set(setting);
        let entries = vectors.iter().map(|v| {
            let length = v.length.map_or(Entry::NONE, |length| length[order_index]);
            [length, v.direction[order_index]]
        });
        let entries: Vec<[Entry; 2]> = entries.collect();
        let aspects = [Aspect::STRETCHING, Aspect::TURNING].map(|all| all[order_index]);
        for (row, aspect) in aspects.into_iter().enumerate() {
            let label = self.label(VECTOR_NAMES[order_index][row], aspect);
            table.row(label, entries.iter().map(|e| self.entry(e[row], aspect)));
            if self.style.bounds {
                table.row(BOUND, entries.iter().map(|e| shown_bound(e[row]) + " "));
            }
        }
        table
    }

    /// Formats an entry: a star marks a computed value; a blank keeps given ones aligned.
    fn entry(&self, entry: Entry, aspect: Aspect) -> String {
        let mark = if entry.given || entry.value.is_none() {
            ' '
        } else {
            '*'
        };
        format!("{}{mark}", self.figure(entry, aspect))
    }

    pub(in crate::report) fn figure(&self, entry: Entry, aspect: Aspect) -> String {
        shown(entry, aspect == Aspect::Angle, self.style.digits)
    }

    fn add_legend(&self, page: &mut Page) {
        let found = words().stars_are_found();
        let bounds = words().bounds_are();
        let is_shown = [!self.tables.vectors.is_empty(), self.style.bounds];
        let shown_text = [found, bounds].into_iter().zip(is_shown);
        let mut shown_text = shown_text.filter_map(|(text, is_shown)| is_shown.then_some(text));
        if let Some(first) = shown_text.next() {
            page.text(first);
        }
        shown_text.for_each(|text| page.text_below(text));
    }

    fn point_table(&self, order: Order) -> Table {
        let [x, y, magnitude, direction] = point_aspects(order);
        let headers = [x, y, magnitude].map(|(name, aspect)| self.label(name, aspect));
        let headers = headers.into_iter().chain([self.direction()]);
        let setting = set(point_labels(), self.style.digits + 2);
        let mut table = Table::new(words().of_points(title(order)), headers).set(setting);
        for point in &self.tables.points {
            let entries = point_entries(point, order);
            let cells = entries.into_iter().zip([x, y, magnitude, direction]);
            let cells = cells.map(|(entry, (_, aspect))| self.figure(entry, aspect));
            table.row(point.name.as_str(), cells);
            if self.style.bounds {
                table.row(BOUND, entries.map(shown_bound));
            }
        }
        table
    }
}

/// Formats a value: zero if it is small and within its error bound.
pub(in crate::report) fn shown(entry: Entry, is_direction: bool, digits: usize) -> String {
    match entry.display_value() {
        None => "-".into(),
        Some(value) if is_direction => direction(value, digits),
        Some(value) => significant(value, digits),
    }
}

/// Formats the error bound of a value; empty for a missing value.
pub(in crate::report) fn shown_bound(entry: Entry) -> String {
    match (entry.value, entry.display_bound()) {
        (None, _) => String::new(),
        (Some(_), None) => "?".into(),
        (Some(_), Some(bound)) => perpendicular_up(bound, BOUND_DIGITS),
    }
}
