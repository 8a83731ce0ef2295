//! An SVG document, element by element: what a drawing or a plot becomes on paper.
//!
//! Coordinates are user units, y downwards. What a shape looks like follows from its class. The
//! document lies on a paper of its own, light or dark as the reader prefers, so that it reads well on
//! any ground. Text loses its control characters and is escaped: no scene can write markup.

use crate::Vec2;
use crate::scene::sanitized;
use std::fmt::Write as _;

/// Where a text stands against its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TextAnchor {
    /// It begins there.
    Start,
    /// Its middle is there.
    Middle,
    /// It ends there.
    End,
}

/// A document of a size, filled from the bottom up.
#[derive(Debug)]
pub(super) struct Svg {
    size: Vec2,
    title: String,
    style: SvgStyle,
    body: String,
}

/// Rules of a style sheet beside those for paper, lines (`path`) and `text`.
#[derive(Clone, Copy, Debug)]
pub(super) struct SvgStyle {
    /// Everywhere.
    pub(super) light: &'static str,
    /// On top of that, where the reader prefers a dark ground.
    pub(super) dark: &'static str,
}

/// The ground that a document is drawn for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SvgGround {
    /// Light, and dark where the reader prefers that.
    Preferred,
    /// Dark for every reader, also for one who knows no preference.
    Dark,
}

impl Svg {
    pub(super) fn new(size: Vec2, title: &str, style: SvgStyle) -> Self {
        Svg {
            size,
            title: escaped(title),
            style,
            body: String::new(),
        }
    }

    /// How large it is.
    pub(super) fn size(&self) -> Vec2 {
        self.size
    }

    /// A chain of straight lines; what is not finite breaks it.
    pub(super) fn polyline(&mut self, points: impl IntoIterator<Item = Vec2>, class: &str) {
        let mut path = String::new();
        let mut pen_is_down = false;
        for p in points {
            if p.is_finite() {
                let command = if pen_is_down { 'L' } else { 'M' };
                let _ = write!(path, "{command}{} {}", number(p.x), number(p.y));
            }
            pen_is_down = p.is_finite();
        }
        self.path(&path, class);
    }

    /// A closed outline.
    pub(super) fn polygon(&mut self, points: impl IntoIterator<Item = Vec2>, class: &str) {
        let mut path = String::new();
        for p in points.into_iter().filter(|p| p.is_finite()) {
            let command = if path.is_empty() { 'M' } else { 'L' };
            let _ = write!(path, "{command}{} {}", number(p.x), number(p.y));
        }
        if !path.is_empty() {
            path.push('Z');
        }
        self.path(&path, class);
    }

    fn path(&mut self, path: &str, class: &str) {
        if !path.is_empty() {
            self.element(format_args!("<path class=\"{class}\" d=\"{path}\"/>"));
        }
    }

    pub(super) fn circle(&mut self, at: Vec2, radius: f64, class: &str) {
        if at.is_finite() {
            let [x, y, r] = [at.x, at.y, radius].map(number);
            self.element(format_args!(
                "<circle class=\"{class}\" cx=\"{x}\" cy=\"{y}\" r=\"{r}\"/>"
            ));
        }
    }

    pub(super) fn text(&mut self, at: Vec2, anchor: TextAnchor, class: &str, text: &str) {
        if at.is_finite() {
            let anchor = match anchor {
                TextAnchor::Start => "start",
                TextAnchor::Middle => "middle",
                TextAnchor::End => "end",
            };
            let ([x, y], text) = ([at.x, at.y].map(number), escaped(text));
            self.element(format_args!(
                "<text class=\"{class}\" text-anchor=\"{anchor}\" x=\"{x}\" y=\"{y}\">{text}</text>"
            ));
        }
    }

    fn element(&mut self, element: std::fmt::Arguments<'_>) {
        let _ = writeln!(self.body, "{element}");
    }

    /// The whole document.
    pub(super) fn finish(self, ground: SvgGround) -> String {
        let [w, h] = [self.size.x, self.size.y].map(number);
        let SvgStyle { light, dark } = self.style;
        let (when_dark, end) = match ground {
            SvgGround::Preferred => ("@media (prefers-color-scheme:dark){\n", "}\n"),
            SvgGround::Dark => ("", ""),
        };
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}\" height=\"{h}\" \
             viewBox=\"0 0 {w} {h}\">\n<title>{}</title>\n\
             <style>\n{LIGHT}{light}{when_dark}{DARK}{dark}{end}</style>\n\
             <rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n{}</svg>\n",
            self.title, self.body
        )
    }
}

/// The ink that stands alone where a viewer knows no preference; `currentColor` would be black there.
const LIGHT: &str = "\
.paper{fill:#fff}
path{fill:none;stroke:#222;stroke-width:2;stroke-linecap:round;stroke-linejoin:round}
text{font:13px sans-serif;fill:#222}
";
const DARK: &str = "\
.paper{fill:#181818}
path{stroke:#ddd}
text{fill:#ddd}
";

/// Hundredths of a user unit are finer than any printer.
fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0" } else { text }.to_owned()
}

fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in sanitized(text, false).chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            c => escaped.push(c),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLAIN: SvgStyle = SvgStyle {
        light: "",
        dark: "",
    };

    #[test]
    fn what_is_not_finite_breaks_a_line_and_text_is_escaped() {
        let mut svg = Svg::new(Vec2::new(100.0, 50.0), "a < b\u{1b}[2J", PLAIN);
        let gap = Vec2::new(f64::NAN, 0.0);
        let [a, b] = [Vec2::new(0.0, 1.0), Vec2::new(2.5, 3.0)];
        svg.polyline([a, b, gap, a, b], "trace");
        svg.text(a, TextAnchor::Middle, "label", "\"B'\" & C");
        let text = svg.finish(SvgGround::Preferred);
        assert!(
            text.contains("<title>a &lt; b\u{fffd}[2J</title>"),
            "{text}"
        );
        assert!(text.contains("d=\"M0 1L2.5 3M0 1L2.5 3\""), "{text}");
        assert!(text.contains("&quot;B'&quot; &amp; C</text>"));
        assert!(!text.contains("NaN"));
    }
}
