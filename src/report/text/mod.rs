//! Numbers, coordinates and rows as text, and tables of other programs.

pub(in crate::report) mod cells;
pub(in crate::report) mod csv_dialect;
pub(in crate::report) mod encoding;
pub(in crate::report) mod number;
pub(in crate::report) mod places;
pub(in crate::report) mod rows;
