//! Figures in their places: how many digits, in which column, where the cursor is, as text for others.

pub(crate) mod copying;
pub(crate) mod cursor;
pub(crate) mod force_figures;
pub(crate) mod format;
pub(crate) mod rows;
pub(crate) mod search;
pub(crate) mod sheet;
