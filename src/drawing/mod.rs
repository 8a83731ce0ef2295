//! Draws linkages in characters, and as SVG and DXF documents.
//!
//! [`linkage`] turns a scene in a state into a [`Figure`]: lines, marks and labels in the scene's
//! length unit, y upwards. A [`WorldView`] maps world points to cells, and [`render_into`] draws
//! the figure into the cells of a [`Raster`] with one set of [`Glyphs`]. An [`Overlay`] adds the
//! parts that depend on the whole motion: traces, other positions, and arrows to one scale. [`svg`]
//! draws the same figure in the same window as a document. This module does not depend on a
//! terminal: a raster is printed as text, or copied cell by cell.
//!
//! ```
//! use krank::drawing::{Glyphs, Layers, Extents, WorldView, linkage, render};
//! use krank::scene::{Scene, presets};
//! use krank::solver::{Order, Solver};
//!
//! let preset = presets::find("four-bar").expect("it is built in");
//! let scene = Scene::parse(preset.text, preset.name)?;
//! let solver = Solver::new(&scene.mechanism)?;
//! // Once for a scene, and once for a size: the window holds the whole motion, so it never jumps.
//! let reach = Extents::of(&scene, &solver);
//! let view = WorldView::fit(&reach, 80, 24, 2.0);
//!
//! let mut state = solver.state();
//! let _ = solver.solve(60.0, Order::Position, &mut state);
//! let figure = linkage(&scene, &reach, &state, Layers::default());
//! let picture = render(&figure, &view, Glyphs::Ascii).text();
//! assert!(picture.contains("/_\\"), "A and D stand on the ground");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bounds;
mod cells;
mod diagram;
mod figure;
mod free_body;
mod highlight;
mod hue;
mod legend;
mod linkage;
mod motion;
mod outline;
mod paper;
pub mod plot;
mod points;
mod roles;
#[cfg(test)]
mod tests;
mod view;

pub use crate::page::SvgGround;
pub use bounds::Bounds;
pub use cells::blocks::Blocks;
pub use cells::labels::Labels;
pub use cells::raster::{CharCell, Raster};
pub use cells::render::{Glyphs, render, render_into};
pub(crate) use diagram::lines_drawn;
pub use diagram::{ArrowKind, DiagramArc, DiagramArrow, VectorDiagram};
pub use figure::{Figure, LINK_HUES, Role, Shape};
pub use free_body::{FreeForce, free_body};
pub(crate) use hue::{Hue, is_bold};
pub use legend::{LegendEntry, LegendPiece, legend_lines};
pub use linkage::{Layers, linkage};
pub use motion::extents::Extents;
pub use motion::ghosts::{add_before, add_ghost, add_other};
pub use motion::overlay::{Overlay, OverlayRequest};
pub use paper::machine_drawing::machine_drawing;
pub use paper::picture::{COLUMN, artwork, svg, svg_on};
pub use plot::convergence::convergence;
pub use plot::effort_plot::effort;
pub use plot::trade_off::trade_off;
pub use plot::{Chart, Datum, DecadeAxis};
pub use points::{moving_points, usual_arrows, usual_traces};
pub use roles::{link_roles, vector_roles};
pub use view::WorldView;
