//! Writes one turn as an animated GIF.

use super::animation_steps::{self, RATE};
use super::svg::unpainted;
use super::{DrawFormat, DrawnScene};
use crate::cli::failure::Failure;
use crate::drawing::{self, Glyphs, Labels, WorldView};
use crate::pixels::{Canvas, PaintError, Pixels, animation};
use crate::wording::Words;

pub(super) static FORMAT: DrawFormat = DrawFormat {
    name: "gif",
    about: <dyn Words>::format_gif,
    takes: &["--width", "--dark", "--seconds"],
    is_picture: true,
    is_binary: true,
    write,
};

/// Default width in pixels: enough for a page, and small enough for an e-mail.
const WIDTH: u16 = 800;
/// Number of frames from which the colours are taken; each hue appears in one of them.
const TYPICAL: usize = 4;

fn write(drawn: &DrawnScene<'_>) -> Result<Vec<u8>, Failure> {
    let turn = animation_steps::places(drawn);
    // The last position is the first of the next turn.
    let coordinates = &turn[..turn.len() - 1];
    let typical = coordinates
        .iter()
        .copied()
        .step_by(coordinates.len().div_ceil(TYPICAL));
    let painted = || -> Result<Vec<u8>, PaintError> {
        let canvas = Canvas::new()?;
        let planned = drawn.planned_labels(&window(drawn), Glyphs::Braille);
        let typical = pictures(drawn, &canvas, &planned, typical);
        let all = pictures(drawn, &canvas, &planned, coordinates.iter().copied());
        animation(typical, all, RATE)
    };
    painted().map_err(unpainted)
}

/// Returns the view, which stays fixed while the linkage moves.
fn window(drawn: &DrawnScene<'_>) -> WorldView {
    drawn.document_view(|size| drawn.motion_view(size))
}

/// Paints the linkage at each of these driver coordinates.
fn pictures(
    drawn: &DrawnScene<'_>,
    canvas: &Canvas,
    planned: &Labels,
    places: impl ExactSizeIterator<Item = f64>,
) -> impl ExactSizeIterator<Item = Result<Pixels, PaintError>> {
    let view = window(drawn);
    let legend = drawn.overlay.legend(&view, 1.0);
    let width = u32::from(drawn.args.width.unwrap_or(WIDTH));
    let mut labels = planned.clone();
    let mut state = drawn.solver.state();
    places.map(move |at| {
        labels.go(drawn.links.share(at));
        let figure = drawn.figure_at(at, &mut state);
        let ground = drawn.ground();
        let svg = drawing::svg_on(ground, &figure, &view, "", &legend, &mut labels);
        canvas.paint(&svg, width)
    })
}
