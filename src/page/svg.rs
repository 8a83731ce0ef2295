//! Writes a picture as SVG: as a separate document or as a part of a page.
//!
//! The document has its own paper, light or dark as the reader prefers, so that it is legible on
//! any ground. Text is escaped, without control characters: no scene can inject markup.

use super::artwork::{ArtElement, Artwork, TextAnchor};
use super::style::{DARK, LIGHT, StyleSheet, rules};
use crate::Vec2;
use crate::document::sanitized;
use std::borrow::Cow;
use std::fmt::Write as _;

/// The ground of a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SvgGround {
    /// Light, or dark if the reader prefers that.
    Preferred,
    /// Dark for every reader, including viewers without a preference.
    Dark,
}

impl Artwork {
    /// Returns the picture as a document.
    pub(crate) fn svg(&self, ground: SvgGround) -> String {
        self.svg_on_paper(ground, None)
    }

    /// Returns the picture as a document with a size on paper, if `millimetres` gives the size of a
    /// user unit.
    pub(crate) fn svg_on_paper(&self, ground: SvgGround, millimetres: Option<f64>) -> String {
        let [w, h] = [self.size.x, self.size.y].map(number);
        let [paper_w, paper_h] = [self.size.x, self.size.y].map(|side| match millimetres {
            None => number(side),
            Some(millimetres) => format!("{}mm", side * millimetres),
        });
        let StyleSheet { light, dark } = self.style;
        let (when_dark, end) = match ground {
            SvgGround::Preferred => ("@media (prefers-color-scheme:dark){\n", "}\n"),
            SvgGround::Dark => ("", ""),
        };
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{paper_w}\" height=\"{paper_h}\" \
             viewBox=\"0 0 {w} {h}\">\n<title>{}</title>\n\
             <style>\n{LIGHT}{light}{when_dark}{DARK}{dark}{end}</style>\n\
             <rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n{}</svg>\n",
            marked_up(&self.title),
            self.body()
        )
    }

    /// Returns the picture as an element of a page, which has the rules of its style sheet under
    /// this class.
    pub(super) fn svg_inside(&self, class: &str) -> String {
        let [w, h] = [self.size.x, self.size.y].map(number);
        let title = marked_up(&self.title);
        format!(
            "<svg class=\"{class}\" role=\"img\" width=\"{w}\" viewBox=\"0 0 {w} {h}\">\n\
             <title>{title}</title>\n{}</svg>\n",
            self.body()
        )
    }

    fn body(&self) -> String {
        let mut body = String::new();
        for element in &self.elements {
            let _ = match element {
                ArtElement::Path {
                    runs,
                    is_closed,
                    class,
                } => {
                    let _ = write!(body, "<path class=\"{class}\" d=\"");
                    push_path(runs, *is_closed, &mut body);
                    writeln!(body, "\"/>")
                }
                ArtElement::Circle { at, radius, class } => {
                    let [x, y, r] = [at.x, at.y, *radius].map(number);
                    writeln!(
                        body,
                        "<circle class=\"{class}\" cx=\"{x}\" cy=\"{y}\" r=\"{r}\"/>"
                    )
                }
                ArtElement::Text {
                    at,
                    anchor,
                    class,
                    text,
                } => {
                    let anchor = match anchor {
                        TextAnchor::Start => "start",
                        TextAnchor::Middle => "middle",
                        TextAnchor::End => "end",
                    };
                    let ([x, y], text) = ([at.x, at.y].map(number), marked_up(text));
                    writeln!(
                        body,
                        "<text class=\"{class}\" text-anchor=\"{anchor}\" x=\"{x}\" y=\"{y}\">{text}</text>"
                    )
                }
            };
        }
        body
    }
}

impl StyleSheet {
    /// Returns the rules for pictures of a class inside a page, light or dark.
    pub(super) fn scoped(&self, class: &str, is_dark: bool) -> String {
        let (usual, own) = match is_dark {
            false => (LIGHT, self.light),
            true => (DARK, self.dark),
        };
        let mut scoped = String::new();
        for (selectors, declarations) in rules(usual).chain(rules(own)) {
            let selectors = selectors.split(',');
            let selectors: Vec<String> = selectors
                .map(|selector| format!(".{class} {}", selector.trim()))
                .collect();
            let _ = writeln!(scoped, "{}{{{declarations}}}", selectors.join(","));
        }
        scoped
    }
}

fn push_path(runs: &[Vec<Vec2>], is_closed: bool, out: &mut String) {
    for run in runs {
        for (k, p) in run.iter().enumerate() {
            out.push(if k == 0 { 'M' } else { 'L' });
            push_number(p.x, out);
            out.push(' ');
            push_number(p.y, out);
        }
        if is_closed {
            out.push('Z');
        }
    }
}

/// Formats a coordinate with two decimals: a hundredth of a user unit is finer than any printer.
pub(super) fn number(value: f64) -> String {
    let mut text = String::new();
    push_number(value, &mut text);
    text
}

/// The largest number of hundredths that is rounded in floating point, and the minimum distance
/// from a tie: both leave far more digits than the product has errors.
const MAX_HUNDREDTHS: f64 = 1e9;
const MIN_TIE_DISTANCE: f64 = 1e-6;

/// Appends a coordinate as [`number`] formats it. A report has millions of them, so usual ones are
/// formatted as integers.
fn push_number(value: f64, out: &mut String) {
    let hundredths = (value * 100.0).abs();
    let is_tie = (hundredths.fract() - 0.5).abs() < MIN_TIE_DISTANCE;
    if !(hundredths < MAX_HUNDREDTHS) || is_tie {
        let text = format!("{value:.2}");
        let text = text.trim_end_matches('0').trim_end_matches('.');
        out.push_str(if text == "-0" { "0" } else { text });
        return;
    }
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between 0 and the maximum"
    )]
    let hundredths = hundredths.round() as u32;
    if value < 0.0 && hundredths > 0 {
        out.push('-');
    }
    let mut unit = 100;
    while hundredths / unit >= 10 {
        unit *= 10;
    }
    let mut rest = hundredths;
    // Zeros at the end of the decimals are left out.
    while unit >= 100 || rest > 0 {
        if unit == 10 {
            out.push('.');
        }
        out.extend(char::from_digit(rest / unit, 10));
        rest %= unit;
        unit /= 10;
    }
}

/// Escapes a text for SVG and HTML.
pub(crate) fn marked_up(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    push_marked_up(text, &mut escaped);
    escaped
}

/// Appends a text, escaped for SVG and HTML.
pub(super) fn push_marked_up(text: &str, out: &mut String) {
    let is_plain = |byte: u8| byte.is_ascii_graphic() || byte == b' ';
    let text = match text.bytes().all(is_plain) {
        true => Cow::Borrowed(text),
        false => Cow::Owned(sanitized(text, false)),
    };
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c => out.push(c),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const PLAIN: StyleSheet = StyleSheet {
        light: "",
        dark: "",
    };

    #[test]
    fn non_finite_points_break_lines_and_text_is_escaped() {
        let mut art = Artwork::new(Vec2::new(100.0, 50.0), "a < b\u{1b}[2J", PLAIN);
        let gap = Vec2::new(f64::NAN, 0.0);
        let [a, b] = [Vec2::new(0.0, 1.0), Vec2::new(2.5, 3.0)];
        art.polyline([a, b, gap, a, b], "trace");
        art.text(a, TextAnchor::Middle, "label", "\"B'\" & C");
        let text = art.svg(SvgGround::Preferred);
        assert!(
            text.contains("<title>a &lt; b\u{fffd}[2J</title>"),
            "{text}"
        );
        assert!(text.contains("d=\"M0 1L2.5 3M0 1L2.5 3\""), "{text}");
        assert!(text.contains("&quot;B'&quot; &amp; C</text>"));
        assert!(!text.contains("NaN"));
    }

    #[test]
    fn coordinates_are_rounded_to_the_nearest_hundredth() {
        for (value, expected) in [
            (0.0, "0"),
            (-0.0, "0"),
            (-0.004, "0"),
            (0.005, "0.01"),
            (0.015, "0.01"),
            (1.005, "1"),
            (0.125, "0.12"),
            (0.375, "0.38"),
            (-12.3456, "-12.35"),
            (12.999, "13"),
            (-0.5, "-0.5"),
            (640.05, "640.05"),
            (1e300, &format!("{:.0}", 1e300)),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(number(value), expected, "{value}");
        }
    }

    proptest! {
        /// The standard library rounds the exact decimal value.
        #[test]
        fn coordinates_equal_those_of_the_standard_library(
            value in -2e7..2e7_f64,
            thousandths in -2_000_000..2_000_000_i32,
        ) {
            for value in [value, value / 1e5, f64::from(thousandths) / 1000.0] {
                let text = format!("{value:.2}");
                let text = text.trim_end_matches('0').trim_end_matches('.');
                prop_assert_eq!(number(value), if text == "-0" { "0" } else { text });
            }
        }
    }

    #[test]
    fn rules_inside_a_page_are_scoped_to_pictures() {
        let sheet = StyleSheet {
            light: ".a,path.b{fill:none}\n",
            dark: ".a{fill:#fff}\n",
        };
        let light = sheet.scoped("art", false);
        assert!(
            light.contains("\n.art .a,.art path.b{fill:none}\n"),
            "{light}"
        );
        assert!(light.contains(".art text{font:13px"), "{light}");
        assert!(sheet.scoped("art", true).ends_with(".art .a{fill:#fff}\n"));
    }
}
