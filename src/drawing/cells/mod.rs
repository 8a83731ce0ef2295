//! Draws figures in character cells, with glyphs for each kind of terminal.

pub(super) mod arrow;
pub(super) mod blocks;
pub(super) mod dashes;
pub(super) mod labels;
pub(super) mod pattern;
pub(super) mod raster;
pub(super) mod render;
pub(super) mod stroke;
pub(super) mod symbol;
pub(super) mod trace;
