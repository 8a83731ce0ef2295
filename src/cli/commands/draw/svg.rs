//! Writes a drawing as an SVG document.

use super::{DrawFormat, DrawnScene};
use crate::cli::failure::Failure;
use crate::cli::picture::Size;
use crate::drawing::{self, Labels, WorldView};
use crate::pixels::PaintError;
use crate::scene::Unit;
use crate::wording::Words;

#[cfg(feature = "pictures")]
use crate::wording::words;

/// Width of a column on paper, in millimetres: eight units at 96 per inch.
const COLUMN_ON_PAPER: f64 = 8.0 * 25.4 / 96.0;
/// Minimum and maximum number of columns of a drawing to scale.
const MIN_COLUMNS: f64 = 40.0;
const MAX_COLUMNS: f64 = 1000.0;

pub(super) static FORMAT: DrawFormat = DrawFormat {
    name: "svg",
    about: <dyn Words>::format_svg,
    takes: &["--dark", "--scale"],
    is_picture: true,
    is_binary: false,
    write: |drawn| Ok(document(drawn).into_bytes()),
};

pub(super) fn document(drawn: &DrawnScene<'_>) -> String {
    let usual = drawn.document_view(|size| drawn.view(size));
    let (view, millimetres) = match drawn.args.scale {
        None => (usual, None),
        Some(scale) => to_scale(drawn, usual, scale.factor()),
    };
    let legend = drawn.overlay.legend(&view, 1.0);
    let (figure, title) = (drawn.figure(drawn.state), drawn.title());
    let labels = &mut Labels::default();
    let art = drawing::artwork(&figure, &view, &title, &legend, labels);
    art.svg_on_paper(drawn.ground(), millimetres)
}

/// Returns a view in which letters and pins are about as large on paper as on a screen, unless a
/// size was requested; and the length of a user unit on paper, in millimetres.
fn to_scale(drawn: &DrawnScene<'_>, usual: WorldView, scale: f64) -> (WorldView, Option<f64>) {
    let paper = drawn.scene.unit.in_units_of(Unit::Millimetre) * scale;
    let per_column = |view: &WorldView| paper / view.cells_along(1.0);
    let view = match drawn.args.size {
        Some(_) => usual,
        None => {
            let requested = f64::from(usual.cols()) * per_column(&usual) / COLUMN_ON_PAPER;
            let cols = requested.clamp(MIN_COLUMNS, MAX_COLUMNS) as u16;
            WorldView::lowest_window(cols, |rows| drawn.view(Size { cols, rows }))
        }
    };
    (view, Some(per_column(&view) / drawing::COLUMN))
}

/// Converts an error of painting.
pub(super) fn unpainted(error: PaintError) -> Failure {
    match error {
        #[cfg(feature = "pictures")]
        PaintError::Failed(why) => Failure::Cannot(why),
        #[cfg(feature = "pictures")]
        PaintError::TooLarge(..) | PaintError::TooMany(_) => {
            Failure::Usage(words().smaller_has_room(&error.to_string()))
        }
        #[cfg(not(feature = "pictures"))]
        PaintError::NotBuilt => Failure::Usage(error.to_string()),
    }
}
