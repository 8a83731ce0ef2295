//! A drawing as an SVG document.

use super::{DrawFormat, DrawnScene, FormatOption};
use crate::cli::failure::Failure;
use crate::drawing::{self, Labels};
use crate::pixels::PaintError;
use crate::wording::Words;
#[cfg(feature = "pictures")]
use crate::wording::words;

pub(super) static FORMAT: DrawFormat = DrawFormat {
    name: "svg",
    about: <dyn Words>::format_svg,
    takes: &[FormatOption::Dark],
    is_binary: false,
    write: |drawn| Ok(document(drawn).into_bytes()),
};

pub(super) fn document(drawn: &DrawnScene<'_>) -> String {
    let view = drawn.document_view(|size| drawn.view(size));
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
        #[cfg(feature = "pictures")]
        PaintError::TooLarge(..) | PaintError::TooMany(_) => {
            Failure::Usage(words().smaller_has_room(&error.to_string()))
        }
        #[cfg(not(feature = "pictures"))]
        PaintError::NotBuilt => Failure::Usage(error.to_string()),
    }
}
