//! Lays out the legend of a drawing: the scales of its arrows and other notes, in a line or two.
//!
//! ```text
//! v 500 mm/s = ------>   a 5000 mm/s^2 = -- ->>   trace P
//! ```

use super::cells::arrow;
use super::cells::render::Glyphs;
use super::figure::Role;
use crate::wording::words;

/// An entry of a legend.
#[derive(Clone, Debug, PartialEq)]
pub enum LegendEntry {
    /// An arrow and the value of its length.
    Arrow {
        /// [`Role::Velocity`], [`Role::Acceleration`] or [`Role::Force`].
        role: Role,
        /// The value: `v 500 mm/s`.
        text: String,
        /// The arrow's length in cell widths.
        cells: f64,
    },
    /// A note in words.
    Note(String),
}

/// A piece of a legend's line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LegendPiece {
    /// The text.
    pub text: String,
    /// The role, which determines the colour.
    pub role: Role,
}

/// Minimum length of a legend's arrow, in cell widths. The next round value is at most 2.5 times as
/// long.
const MIN_LEN: f64 = 4.0;
/// The separator between two entries.
const GAP: &str = "   ";

impl LegendEntry {
    /// Creates the arrow of a round value, with `cells_each` cell widths per unit.
    pub(crate) fn arrow(role: Role, letter: &str, unit: &str, cells_each: f64) -> LegendEntry {
        let value = round_up(MIN_LEN / cells_each);
        match value {
            Some(value) => LegendEntry::Arrow {
                role,
                text: format!("{letter} {} {unit}", plain(value)),
                cells: value * cells_each,
            },
            None => LegendEntry::Note(words().arrows_without_scale(letter)),
        }
    }

    fn pieces(&self, glyphs: Glyphs) -> Vec<LegendPiece> {
        let piece = |text: String, role| LegendPiece { text, role };
        match self {
            LegendEntry::Arrow { role, text, cells } => {
                #[expect(clippy::cast_possible_truncation, reason = "some cells")]
                let cells = cells.round() as i32;
                let sample = arrow::level(glyphs, *role, cells);
                vec![
                    piece(format!("{text} = "), Role::Label),
                    piece(sample, *role),
                ]
            }
            LegendEntry::Note(text) => vec![piece(text.clone(), Role::Label)],
        }
    }
}

/// Lays out the legend in at most `most` lines of `width` characters; entries without space are
/// left out.
#[must_use]
pub fn legend_lines(
    keys: &[LegendEntry],
    glyphs: Glyphs,
    width: usize,
    maximum: usize,
) -> Vec<Vec<LegendPiece>> {
    let mut lines: Vec<Vec<LegendPiece>> = Vec::new();
    let length =
        |pieces: &[LegendPiece]| -> usize { pieces.iter().map(|p| p.text.chars().count()).sum() };
    for key in keys {
        let pieces = key.pieces(glyphs);
        let wanted = length(&pieces);
        if wanted > width {
            continue;
        }
        let space = |line: &&mut Vec<LegendPiece>| length(line) + GAP.len() + wanted <= width;
        if let Some(line) = lines.last_mut().filter(space) {
            let (text, role) = (GAP.to_owned(), Role::Empty);
            line.push(LegendPiece { text, role });
            line.extend(pieces);
        } else if lines.len() < maximum {
            lines.push(pieces);
        }
    }
    lines
}

/// Returns the smallest of 1, 2 and 5 times a power of ten that is at least `value`; `None` if the
/// result is not finite and positive.
fn round_up(value: f64) -> Option<f64> {
    let power = 10.0_f64.powf(value.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|step| step * power);
    let minimum = steps.into_iter().find(|&step| step >= value);
    minimum.filter(|v| v.is_finite() && *v > 0.0)
}

/// Formats a round value without trailing zeros.
fn plain(value: f64) -> String {
    if (1e-3..1e6).contains(&value) {
        let text = format!("{value:.4}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{value:.0e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn text(lines: &[Vec<LegendPiece>]) -> Vec<String> {
        let line = |pieces: &Vec<LegendPiece>| pieces.iter().map(|p| p.text.as_str()).collect();
        lines.iter().map(line).collect()
    }

    fn entries() -> Vec<LegendEntry> {
        vec![
            LegendEntry::arrow(Role::Velocity, "v", "mm/s", 0.012),
            LegendEntry::arrow(Role::Acceleration, "a", "mm/s^2", 5e-4),
            LegendEntry::Note("trace P".into()),
        ]
    }

    #[test]
    fn legend_gives_scale_of_arrows() {
        let shown =
            |glyphs, width, maximum| text(&legend_lines(&entries(), glyphs, width, maximum));
        let velocity = "v 500 mm/s = ----->";
        let acceleration = "a 10000 mm/s^2 = -- >>";
        assert_eq!(
            shown(Glyphs::Ascii, 80, 1),
            [format!("{velocity}   {acceleration}   trace P")]
        );
        assert_eq!(
            shown(Glyphs::Ascii, 40, 2),
            [velocity.to_owned(), format!("{acceleration}   trace P")]
        );
        // An entry that does not fit gives way to one that does.
        assert_eq!(
            shown(Glyphs::Ascii, 30, 1),
            [format!("{velocity}   trace P")]
        );
        assert_eq!(shown(Glyphs::Ascii, 6, 1), [""; 0]);
        let line = shown(Glyphs::Line, 80, 1).concat();
        assert!(
            line.contains("= \u{2500}\u{2500}\u{2500}\u{2500}\u{2500}\u{25ba}"),
            "{line}"
        );
        let dots = shown(Glyphs::Braille, 80, 1).concat();
        assert!(
            dots.contains("= \u{2824}\u{2824}\u{2824}\u{2824}\u{2824}\u{25ba}"),
            "{dots}"
        );
    }

    #[test]
    fn legend_has_no_scale_without_motion() {
        let entry = LegendEntry::arrow(Role::Velocity, "v", "m/s", 0.0);
        let LegendEntry::Note(text) = entry else {
            panic!("{entry:?}");
        };
        assert!(text.contains("stands still"), "{text}");
    }

    proptest! {
        #[test]
        fn values_are_round_and_arrow_lengths_limited(power in -300.0..300.0) {
            let each = 10.0_f64.powf(power);
            let LegendEntry::Arrow { text, cells, .. } = LegendEntry::arrow(Role::Velocity, "v", "m/s", each) else {
                return Err(TestCaseError::fail("an arrow"));
            };
            prop_assert!((MIN_LEN * 0.999..MIN_LEN * 2.501).contains(&cells), "{cells}");
            let value: f64 = text.split(' ').nth(1).unwrap().parse().unwrap();
            prop_assert!((value * each / cells - 1.0).abs() < 1e-6, "{text}");
            let first = text.chars().find(|c| ('1'..='9').contains(c)).unwrap();
            prop_assert!("125".contains(first), "{text}");
        }
    }
}
