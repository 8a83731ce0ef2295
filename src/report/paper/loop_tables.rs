//! Tables with a column per vector, as the lecture has them: empty, and then filled.

use super::ReportedState;
use crate::page::{Cell, Page, Row, Table};
use crate::report::working::{LoopVectors, VectorFigure};
use crate::solver::Order;
use crate::wording::words;

impl ReportedState<'_> {
    /// The tables of an order before anything is found.
    pub(super) fn asked(&self, order: Order, page: &mut Page) {
        page.text(words().tables_asked());
        self.asked_tables(order, page);
    }

    /// The same without a word before them.
    pub(in crate::report) fn asked_tables(&self, order: Order, page: &mut Page) {
        self.tables(order, VectorFigure::asked, page);
    }

    /// The tables of an order with all that was found.
    pub(super) fn told(&self, order: Order, page: &mut Page) {
        let exists = match order {
            Order::Position => self.has_positions(),
            _ => self.has_rates(),
        };
        if exists && !self.loops.is_empty() {
            page.text(words().tables_told());
            self.tables(order, VectorFigure::told, page);
        }
    }

    fn tables(&self, order: Order, write: fn(&VectorFigure) -> String, page: &mut Page) {
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
        write: fn(&VectorFigure) -> String,
    ) -> Table {
        let heads = of.vectors.iter().map(|vector| vector.name.as_str());
        let mut table = Table::new(title, heads);
        let unit = self.scene.unit.symbol();
        let (number, names) = match order {
            Order::Position => (0, [format!("r [{unit}]"), "θ [deg]".into()]),
            Order::Velocity => (1, [format!("dr/dt [{unit}/s]"), "ω [rad/s]".into()]),
            Order::Acceleration | Order::Force => {
                (2, [format!("d2r/dt2 [{unit}/s^2]"), "α [rad/s^2]".into()])
            }
        };
        for (row, name) in names.into_iter().enumerate() {
            let figures = of.vectors.iter().map(|vector| &vector.figures[number][row]);
            table.rows.push(Row::Figures {
                mark: String::new(),
                name,
                more: None,
                cells: figures.map(|f| Some(Cell::sure(write(f)))).collect(),
            });
        }
        table
    }
}
