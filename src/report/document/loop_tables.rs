//! Tables with a column per vector, as in the lecture: first empty, then completed.

use super::ReportedState;
use crate::page::{Cell, Page, Row, Table};
use crate::report::tables::index;
use crate::report::working::{LoopVectors, VectorFigure};
use crate::solver::Order;
use crate::study::AnswerKey;
use crate::wording::words;

impl ReportedState<'_> {
    /// Adds the tables of an order with unknowns marked.
    pub(super) fn tables_with_unknowns(&self, order: Order, page: &mut Page) {
        page.text(words().tables_asked());
        self.tables(order, &VectorFigure::before, page);
    }

    /// Adds the tables of an order that request the values of an answer key, without an
    /// introduction.
    pub(in crate::report) fn question_tables(
        &self,
        order: Order,
        key: &AnswerKey,
        page: &mut Page,
    ) {
        let vectors = || self.loops.iter().flat_map(|of| &of.vectors);
        let is_found_here = |column: &str| {
            let mut figures = vectors().flat_map(|vector| vector.figures.iter().flatten());
            figures.any(|own| own.column == column && own.is_sought && own.found_by.is_none())
        };
        let write = |figure: &VectorFigure| {
            let is_elsewhere = figure.found_by.is_some() && is_found_here(&figure.column);
            match (&figure.value, key.requires(&figure.column)) {
                (Some(value), false) if figure.found_by.is_none() => Cell::proved(value),
                (_, true) if !is_elsewhere && figure.is_sought => figure.unknown(),
                _ => figure.before(),
            }
        };
        self.tables(order, &write, page);
    }

    /// Adds the completed tables of an order.
    pub(super) fn completed_tables(&self, order: Order, page: &mut Page) {
        let exists = match order {
            Order::Position => self.has_positions(),
            _ => self.has_rates(),
        };
        if exists && !self.loops.is_empty() {
            page.text(words().tables_told());
            self.tables(order, &VectorFigure::after, page);
        }
    }

    fn tables(&self, order: Order, write: &dyn Fn(&VectorFigure) -> Cell, page: &mut Page) {
        for (number, of) in self.loops.iter().enumerate() {
            let title = match self.loops.len() {
                1 => String::new(),
                _ => words().loop_number(number + 1),
            };
            page.table(self.table(title, of, order, write));
        }
    }

    fn table(
        &self,
        title: String,
        of: &LoopVectors,
        order: Order,
        write: &dyn Fn(&VectorFigure) -> Cell,
    ) -> Table {
        let headers = of.vectors.iter().map(|vector| vector.name.as_str());
        let mut table = Table::new(title, headers);
        let unit = self.scene.unit.symbol();
        let number = index(order);
        let names = [
            [format!("r [{unit}]"), "θ [deg]".into()],
            [format!("dr/dt [{unit}/s]"), "ω [rad/s]".into()],
            [format!("d2r/dt2 [{unit}/s^2]"), "α [rad/s^2]".into()],
        ];
        for (row, name) in names[number].iter().enumerate() {
            let figures = of.vectors.iter().map(|vector| &vector.figures[number][row]);
            table.rows.push(Row::Figures {
                mark: String::new(),
                name: name.clone(),
                more: None,
                cells: figures.map(|f| Some(write(f))).collect(),
            });
        }
        table
    }
}
