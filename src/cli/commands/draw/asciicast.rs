//! Writes one turn in characters and colours as an asciicast of version 2, for asciinema. The
//! output is 7-bit and has no time stamp, so that equal scenes give equal bytes.

use super::animation_steps::{self, RATE};
use super::{DrawFormat, DrawnScene, MAX_LEGEND};
use crate::cli::failure::Failure;
use crate::cli::picture::{DEFAULT_SIZE, Size, lettered};
use crate::drawing::{self, CharCell, Glyphs, Hue, LegendPiece, Raster, Role, WorldView, is_bold};
use crate::scene::sanitized;
use crate::wording::Words;
use std::fmt::Write as _;

pub(super) static FORMAT: DrawFormat = DrawFormat {
    name: "cast",
    about: <dyn Words>::format_cast,
    takes: &["--glyphs", "--seconds"],
    is_picture: true,
    is_binary: false,
    write,
};

fn write(drawn: &DrawnScene<'_>) -> Result<Vec<u8>, Failure> {
    let size @ Size { cols, rows } = drawn.args.size.unwrap_or(DEFAULT_SIZE);
    let title = json(&sanitized(&drawn.title(), false));
    let mut cast =
        format!("{{\"version\": 2, \"width\": {cols}, \"height\": {rows}, \"title\": {title}}}\n");
    // The player's terminal has its own fonts, so the environment of this one is irrelevant.
    let glyphs = drawn.args.glyphs.unwrap_or(Glyphs::Braille);
    let legend_of = |view: &WorldView| {
        let entries = drawn.overlay.legend(view, 1.0);
        drawing::legend_lines(&entries, glyphs, usize::from(cols), MAX_LEGEND)
    };
    let lines = u16::try_from(legend_of(&drawn.motion_view(size)).len()).unwrap_or(0);
    let view = drawn.motion_view(Size {
        cols,
        rows: rows.saturating_sub(lines).max(1),
    });
    let coordinates = animation_steps::places(drawn);
    let (mut labels, mut state) = (drawn.planned_labels(&view, glyphs), drawn.solver.state());
    let mut before = Raster::new();
    for (k, &at) in coordinates.iter().enumerate() {
        labels.go(drawn.links.share(at));
        let figure = drawn.figure_at(at, &mut state);
        let mut raster = Raster::new();
        drawing::render_into(&figure, &view, glyphs, &mut labels, &mut raster);
        let seconds = k as f64 / f64::from(RATE);
        let mut text = changed(&before, &raster);
        if k == 0 {
            text.push_str(&legend(&legend_of(&view), view.rows(), glyphs));
        }
        if k + 1 == coordinates.len() {
            // The shell continues below the drawing, with its cursor.
            let _ = write!(text, "\x1b[{rows};1H\x1b[?25h");
        }
        let _ = writeln!(cast, "[{seconds:.3}, \"o\", {}]", json(&text));
        before = raster;
    }
    Ok(cast.into_bytes())
}

/// Returns the sequences that change one frame into the next, row by row. Without a previous frame,
/// returns the whole frame.
fn changed(before: &Raster, now: &Raster) -> String {
    let mut text = String::new();
    if before.rows() == 0 {
        // The cursor would be visible at the end of the last row.
        text.push_str("\x1b[?25l\x1b[2J");
    }
    let lines = now.lines().enumerate();
    for (row, line) in lines.filter(|(row, line)| before.lines().nth(*row) != Some(*line)) {
        let _ = write!(text, "\x1b[{};1H", row + 1);
        let end = line.iter().rposition(|cell| *cell != CharCell::EMPTY);
        let mut in_force = PLAIN.to_owned();
        for cell in &line[..end.map_or(0, |end| end + 1)] {
            let wanted = colours(cell.role);
            if wanted != in_force && cell.glyph != ' ' {
                let _ = write!(text, "\x1b[{wanted}m");
                in_force = wanted;
            }
            text.push(cell.glyph);
        }
        if in_force != PLAIN {
            let _ = write!(text, "\x1b[{PLAIN}m");
        }
        // After the last column, some terminals would erase the character in it.
        if end.is_none_or(|end| end + 1 < line.len()) {
            text.push_str("\x1b[K");
        }
    }
    text
}

/// Returns the legend's lines below a drawing of `rows` rows.
fn legend(lines: &[Vec<LegendPiece>], rows: u16, glyphs: Glyphs) -> String {
    let mut text = String::new();
    for (line, row) in lines.iter().zip(rows + 1..) {
        let _ = write!(text, "\x1b[{row};1H");
        for piece in line {
            let words = lettered(piece.text.clone(), glyphs);
            let _ = write!(text, "\x1b[{}m{words}", colours(piece.role));
        }
        let _ = write!(text, "\x1b[{PLAIN}m");
    }
    text
}

const PLAIN: &str = "0";

/// Returns the colour sequence of a role. The background of the player is unknown, so the hues are
/// legible on black and white.
fn colours(role: Role) -> String {
    let bold = if is_bold(role) { ";1" } else { "" };
    match Hue::of(role) {
        Some(hue) => format!("{PLAIN}{bold};38;5;{}", hue.on_any_ground()),
        None => format!("{PLAIN}{bold}"),
    }
}

/// Encodes a text as a 7-bit JSON string.
fn json(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => quoted.push_str("\\\""),
            '\\' => quoted.push_str("\\\\"),
            ' '..='~' => quoted.push(c),
            _ => {
                for unit in c.encode_utf16(&mut [0; 2]) {
                    let _ = write!(quoted, "\\u{unit:04x}");
                }
            }
        }
    }
    quoted.push('"');
    quoted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_quoted_in_seven_bits() {
        assert_eq!(json("a\"b\\\u{1b}[K"), r#""a\"b\\\u001b[K""#);
        assert_eq!(
            json("\u{2801}\u{1fb00}\u{7f}"),
            r#""\u2801\ud83e\udf00\u007f""#
        );
    }
}
