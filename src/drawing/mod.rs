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

mod arrow;
mod blocks;
mod bounds;
mod convergence;
mod dashes;
mod diagram;
mod dxf;
mod effort_plot;
mod extents;
mod figure;
mod force_arrows;
mod free_body;
mod ghosts;
mod highlight;
mod hue;
mod labels;
mod legend;
mod linkage;
mod machine_drawing;
mod motion_samples;
mod outline;
mod overlay;
mod pattern;
mod picture;
pub mod plot;
mod points;
mod poses;
mod raster;
mod render;
mod roles;
mod scale;
mod stroke;
mod symbol;
#[cfg(test)]
mod tests;
mod trace;
mod trade_off;
mod view;

pub use crate::page::SvgGround;
pub use blocks::Blocks;
pub use bounds::Bounds;
pub use convergence::convergence;
pub(crate) use diagram::lines_drawn;
pub use diagram::{ArrowKind, DiagramArc, DiagramArrow, VectorDiagram};
pub use effort_plot::effort;
pub use extents::Extents;
pub use figure::{Figure, LINK_HUES, Role, Shape};
pub use free_body::{FreeForce, free_body};
pub use ghosts::{add_before, add_ghost, add_other};
pub(crate) use hue::{Hue, is_bold};
pub use labels::Labels;
pub use legend::{LegendEntry, LegendPiece, legend_lines};
pub use linkage::{Layers, linkage};
pub use machine_drawing::machine_drawing;
pub use overlay::{Overlay, OverlayRequest};
pub use picture::{COLUMN, artwork, svg, svg_on};
pub use plot::{Chart, Datum, DecadeAxis};
pub use points::{moving_points, usual_arrows, usual_traces};
pub use raster::{CharCell, Raster};
pub use render::{Glyphs, render, render_into};
pub use roles::{link_roles, vector_roles};
pub use trade_off::trade_off;
pub use view::WorldView;
