//! Linkages in characters: primitives in world units, a window on them, and cells.
//!
//! The way is short: [`linkage`] turns a scene in a state into a [`Figure`] (lines, marks, labels in
//! the scene's length unit, y upwards), a [`View`] says which cell a world point falls into, and
//! [`render_into`] draws the figure into the cells of a [`Raster`] with one set of [`Glyphs`].
//! Nothing here knows a terminal: a raster is printed as text, or copied cell by cell by whoever has one.

mod figure;
mod labels;
mod linkage;
mod outline;
mod raster;
mod reach;
mod render;
mod stroke;
mod symbol;
#[cfg(test)]
mod tests;
mod view;

pub use figure::{Figure, Role, Shape};
pub use labels::Labels;
pub use linkage::{Layers, linkage};
pub use raster::{Cell, Raster};
pub use reach::Reach;
pub use render::{Glyphs, render, render_into};
pub use view::{Bounds, View};
