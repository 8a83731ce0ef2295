//! Numbers as written and as typed: measures, units, formulas and parameters.

pub(super) mod dependents;
pub(super) mod figures;
pub(super) mod formula_values;
pub(super) mod measure;
pub(super) mod numeral;
pub(super) mod parameters;
pub(super) mod rate;
pub(super) mod reader;
pub(super) mod typed_number;
pub(super) mod unit;
