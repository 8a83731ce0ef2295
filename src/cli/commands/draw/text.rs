//! Writes a drawing in characters.

use super::{DrawFormat, DrawnScene, MAX_LEGEND};
use crate::cli::failure::Failure;
use crate::cli::picture::{self, Size, lettered};
use crate::drawing::{self, WorldView};
use crate::wording::Words;

pub(super) static FORMAT: DrawFormat = DrawFormat {
    name: "text",
    about: <dyn Words>::format_characters,
    takes: &["--glyphs"],
    is_picture: true,
    is_binary: false,
    write,
};

fn write(drawn: &DrawnScene<'_>) -> Result<Vec<u8>, Failure> {
    let glyphs = picture::glyphs(drawn.args.glyphs);
    let Size { cols, rows } = picture::size(drawn.args.size, drawn.args.output.output.as_deref());
    let view = |rows| drawn.view(Size { cols, rows });
    let legend = |view: &WorldView| {
        let entries = drawn.overlay.legend(view, 1.0);
        drawing::legend_lines(&entries, glyphs, usize::from(cols), MAX_LEGEND)
    };
    // The number of lines hardly depends on the view's height.
    let lines = u16::try_from(legend(&view(rows)).len()).unwrap_or(0);
    let view = view(rows.saturating_sub(lines).max(1));
    let mut text = drawing::render(&drawn.figure(drawn.state), &view, glyphs).text();
    for line in legend(&view) {
        text.extend(line.into_iter().map(|piece| piece.text));
        text.push('\n');
    }
    Ok(lettered(text, glyphs).into_bytes())
}
