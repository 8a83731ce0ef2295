//! A turn in pixels.

use super::svg::unpainted;
use super::turn::{self, RATE};
use super::{DrawFormat, DrawnScene, FormatOption};
use crate::cli::failure::Failure;
use crate::drawing::{self, Labels, WorldView};
use crate::pixels::{Canvas, PaintError, Pixels, animation};
use crate::wording::Words;

pub(super) static FORMAT: DrawFormat = DrawFormat {
    name: "gif",
    about: <dyn Words>::format_gif,
    takes: &[
        FormatOption::Width,
        FormatOption::Dark,
        FormatOption::Seconds,
    ],
    is_picture: true,
    is_binary: true,
    write,
};

/// Enough for a page, and a file that a mail takes.
const WIDTH: u16 = 800;
/// Colours are taken from so many pictures of the turn: each hue is seen in one of them.
const TYPICAL: usize = 4;

fn write(drawn: &DrawnScene<'_>) -> Result<Vec<u8>, Failure> {
    let turn = turn::places(drawn);
    // The last picture is the first one of the next round.
    let places = &turn[..turn.len() - 1];
    let typical = places
        .iter()
        .copied()
        .step_by(places.len().div_ceil(TYPICAL));
    let painted = || -> Result<Vec<u8>, PaintError> {
        let canvas = Canvas::new()?;
        let settled = drawn.settled_labels(places, &window(drawn));
        let typical = pictures(drawn, &canvas, &settled, typical);
        let all = pictures(drawn, &canvas, &settled, places.iter().copied());
        animation(typical, all, RATE)
    };
    painted().map_err(unpainted)
}

/// The window stands still while the linkage moves.
fn window(drawn: &DrawnScene<'_>) -> WorldView {
    drawn.document_view(|size| drawn.whole_view(size))
}

/// The linkage at each of these places of its driver.
fn pictures(
    drawn: &DrawnScene<'_>,
    canvas: &Canvas,
    settled: &Labels,
    places: impl ExactSizeIterator<Item = f64>,
) -> impl ExactSizeIterator<Item = Result<Pixels, PaintError>> {
    let view = window(drawn);
    let legend = drawn.overlay.legend(&view, 1.0);
    let width = u32::from(drawn.args.width.unwrap_or(WIDTH));
    let mut labels = settled.clone();
    let mut state = drawn.solver.state();
    places.map(move |at| {
        let figure = drawn.figure_at(at, &mut state);
        let ground = drawn.ground();
        let svg = drawing::svg_on(ground, &figure, &view, "", &legend, &mut labels);
        canvas.paint(&svg, width)
    })
}
