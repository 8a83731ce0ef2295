//! Formats table values: digits, columns, cursor and clipboard text.

pub(crate) mod copying;
pub(crate) mod cursor;
pub(crate) mod force_figures;
pub(crate) mod format;
pub(crate) mod rows;
pub(crate) mod search;
pub(crate) mod sheet;
