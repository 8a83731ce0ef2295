//! From a figure to cells.

use super::figure::{Figure, Role, Shape};
use super::labels::Labels;
use super::raster::Raster;
use super::stroke;
use super::symbol::Symbols;
use super::view::View;
use crate::Vec2;

/// What a drawing is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Glyphs {
    /// Line art of 7-bit characters.
    #[default]
    Ascii,
    /// Box-drawing characters, as console fonts have them.
    Line,
    /// Dots, 2 x 4 to a cell, with characters for the joints.
    Braille,
}

/// Layers from the lowest to the highest.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Layer {
    Ground,
    Guides,
    Links,
    Blocks,
    Marks,
    Labels,
}

const LAYERS: [Layer; 5] = [
    Layer::Ground,
    Layer::Guides,
    Layer::Links,
    Layer::Blocks,
    Layer::Marks,
];

fn layer(shape: &Shape) -> Layer {
    match shape {
        Shape::Support { .. } | Shape::Hatching { .. } => Layer::Ground,
        Shape::Line { role, .. } | Shape::Outline { role, .. } => match role {
            Role::Guide => Layer::Guides,
            _ => Layer::Links,
        },
        Shape::Barrel { .. } => Layer::Links,
        Shape::Block { .. } => Layer::Blocks,
        Shape::Mark { .. } => Layer::Marks,
        Shape::Label { .. } => Layer::Labels,
    }
}

/// Draws a figure into a raster of the view's size. The raster's memory is reused.
///
/// `labels` remembers where each label stood, so that it does not change sides from frame to frame
/// without need; a fresh one is right for a single picture.
pub fn render_into(
    figure: &Figure,
    view: &View,
    glyphs: Glyphs,
    labels: &mut Labels,
    raster: &mut Raster,
) {
    raster.reset(view.cols(), view.rows());
    let mut symbols = Symbols {
        view,
        glyphs,
        raster,
    };
    for current in LAYERS {
        for shape in figure.shapes().iter().filter(|s| layer(s) == current) {
            draw(&mut symbols, shape);
        }
    }
    labels.place(figure, view, raster);
}

/// Draws a single picture.
#[must_use]
pub fn render(figure: &Figure, view: &View, glyphs: Glyphs) -> Raster {
    let mut raster = Raster::new();
    render_into(figure, view, glyphs, &mut Labels::default(), &mut raster);
    raster
}

fn draw(symbols: &mut Symbols<'_>, shape: &Shape) {
    match *shape {
        Shape::Line { from, to, role } => {
            let (a, b) = (symbols.view.cell(from), symbols.view.cell(to));
            stroke::line(symbols.raster, symbols.glyphs, a, b, role);
        }
        Shape::Outline { ref corners, role } => {
            let corners: Vec<Vec2> = corners.iter().map(|&c| symbols.view.cell(c)).collect();
            symbols.outline(&corners, role);
        }
        Shape::Barrel { from, to, role } => symbols.barrel(from, to, role),
        Shape::Mark { at, role } => symbols.mark(at, role),
        Shape::Support { at } => symbols.support(at),
        Shape::Hatching { from, to } => symbols.hatching(from, to),
        Shape::Block { at, pin, .. } => symbols.block(at, pin),
        // Names come last, when all that they must avoid is in place.
        Shape::Label { .. } => {}
    }
}
