//! Machines at one place of the driver.

use super::machines::Machines;
use crate::quantity::Quantity;
use crate::solver::{Condition, LoopKind, Order, Varied};

/// Solves machines at a place of the driver, and evaluates values there.
#[derive(Clone, Debug)]
pub(super) struct MachinesAtPlace {
    pub(super) figures: Vec<Quantity>,
    pub(super) order: Order,
    pub(super) varied: Varied,
    at: f64,
    /// The values with the nominal lengths; directions are given as close as possible to these.
    nominal: Vec<Option<f64>>,
}

impl MachinesAtPlace {
    pub(super) fn new(quantities: Vec<Quantity>, order: Order, varied: Varied) -> MachinesAtPlace {
        MachinesAtPlace {
            nominal: vec![None; quantities.len()],
            figures: quantities,
            order,
            varied,
            at: 0.0,
        }
    }

    /// Moves to a place; returns the values with the nominal lengths.
    pub(super) fn go(&mut self, at: f64) -> Vec<Option<f64>> {
        self.at = at;
        self.nominal.fill(None);
        let mut values = self.nominal.clone();
        self.make(&vec![0.0; self.varied.lengths()], &mut values);
        self.nominal.clone_from(&values);
        values
    }
}

impl Machines for MachinesAtPlace {
    fn make(&mut self, by: &[f64], values: &mut [Option<f64>]) -> bool {
        self.varied.change(by);
        let closes = match self.varied.solve(self.at, self.order) {
            Condition::Ok | Condition::ChangePoint => true,
            Condition::DeadPoint => self.order == Order::Position,
            Condition::NoAssembly => false,
        };
        if !closes {
            values.fill(None);
            return false;
        }
        let quantities = self.figures.iter().zip(&self.nominal);
        for ((quantity, near), value) in quantities.zip(values) {
            let found = quantity.value(self.varied.state().state());
            *value = match near.filter(|_| quantity.is_direction()) {
                Some(near) => found.map(|found| crate::angle::unwrap_near(near, found)),
                None => found,
            };
        }
        true
    }

    fn measures(&mut self) -> &[f64] {
        self.varied.measures(self.at)
    }

    fn kind(&self) -> Option<LoopKind> {
        self.varied.kind()
    }
}
