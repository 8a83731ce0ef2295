//! A drawing as an SVG document.

use super::{DrawFormat, DrawnScene};
use crate::cli::failure::Failure;
use crate::drawing::{self, Labels};
use crate::pixels::PaintError;
use crate::wording::Words;

pub(super) static FORMAT: DrawFormat = DrawFormat {
    name: "svg",
    about: <dyn Words>::format_svg,
    write: |drawn| Ok(document(drawn).into_bytes()),
};

pub(super) fn document(drawn: &DrawnScene<'_>) -> String {
    let view = drawn.view(drawn.document_size());
    let legend = drawn.overlay.legend(&view, 1.0);
    let (figure, title) = (drawn.figure(drawn.state), drawn.title());
    let labels = &mut Labels::default();
    drawing::svg_on(drawn.ground(), &figure, &view, &title, &legend, labels)
}

/// Why a document did not become pixels.
pub(super) fn unpainted(error: PaintError) -> Failure {
    match error {
        #[cfg(feature = "pictures")]
        PaintError::Failed(why) => Failure::Cannot(why),
        refused => Failure::Usage(refused.to_string()),
    }
}
