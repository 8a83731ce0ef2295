//! Writes a picture in TikZ: the elements of the SVG, with their appearance on paper from the style
//! sheet.

use super::artwork::{ArtElement, Artwork, TextAnchor};
use super::latex::escaped;
use super::style::SvgStyle;
use super::svg::number;
use crate::Vec2;
use std::fmt::Write as _;

/// Millimetres per user unit, and maximum width of a picture in millimetres.
const MILLIMETRES: f64 = 160.0 / 800.0;
const MAX_WIDTH: f64 = 160.0;
/// The font size in user units, and the size of a typographic point in millimetres.
const LETTERS: f64 = 13.0;
const POINT: f64 = 0.352_78;
/// Maximum coordinate that TeX can handle; the picture is clipped anyway.
const MAX_DISTANCE: f64 = 4000.0;

impl Artwork {
    /// Returns the picture as a `tikzpicture`.
    pub(super) fn tikz(&self) -> String {
        let unit = MILLIMETRES.min(MAX_WIDTH / self.size.x.max(1.0));
        let [w, h] = [self.size.x, self.size.y].map(number);
        let points = number((LETTERS * unit / POINT).max(4.0));
        let mut text = format!(
            "\\begin{{tikzpicture}}[x={unit:.4}mm,y=-{unit:.4}mm,line cap=round,line join=round,\
             every node/.style={{inner sep=0pt,font=\\sffamily\\fontsize{{{points}}}{{{points}}}\\selectfont}}]\n\
             \\clip (0,0) rectangle ({w},{h});\n"
        );
        for element in &self.elements {
            self.element(element, unit, &mut text);
        }
        text + "\\end{tikzpicture}\n"
    }

    fn element(&self, element: &ArtElement, unit: f64, out: &mut String) {
        match element {
            ArtElement::Path {
                runs,
                is_closed,
                class,
            } => {
                let style = self.style.svg_style("path", class);
                let Some(options) = options(&style, unit) else {
                    return;
                };
                for run in runs {
                    let places: Vec<String> = run.iter().map(|&p| place(p)).collect();
                    let end = if *is_closed { " -- cycle" } else { "" };
                    // A single point is drawn as a dot: a line to itself with round ends.
                    let dot = if places.len() == 1 { " -- cycle" } else { end };
                    let _ = writeln!(out, "\\path[{options}] {}{dot};", places.join("--"));
                }
            }
            ArtElement::Circle { at, radius, class } => {
                if let Some(options) = options(&self.style.svg_style("circle", class), unit) {
                    let radius = number(radius * unit);
                    let at = place(*at);
                    let _ = writeln!(out, "\\path[{options}] {at} circle[radius={radius}mm];");
                }
            }
            ArtElement::Text {
                at,
                anchor,
                class,
                text,
            } => {
                let style = self.style.svg_style("text", class);
                // Outlines around letters only separate them from their background.
                let Some(ink) = style.fill else { return };
                let anchor = match anchor {
                    TextAnchor::Start => "base west",
                    TextAnchor::Middle => "base",
                    TextAnchor::End => "base east",
                };
                let (at, text) = (place(*at), escaped(text));
                let _ = writeln!(
                    out,
                    "\\node[anchor={anchor},text={}] at {at} {{{text}}};",
                    mixed(&ink)
                );
            }
        }
    }
}

/// Returns the options that draw a path; `None` if it is invisible.
fn options(style: &SvgStyle, unit: f64) -> Option<String> {
    let mut options = Vec::new();
    if let Some(ink) = &style.stroke {
        options.push(format!("draw={}", mixed(ink)));
        options.push(format!("line width={}mm", number(style.width * unit)));
        if style.stroke_opacity < 1.0 {
            options.push(format!("draw opacity={}", number(style.stroke_opacity)));
        }
        if !style.dashes.is_empty() {
            let dash = |(k, length): (usize, &f64)| {
                let on = ["on", "off"][k % 2];
                format!("{on} {}mm", number(length * unit))
            };
            let dashes: Vec<String> = style.dashes.iter().enumerate().map(dash).collect();
            options.push(format!("dash pattern={}", dashes.join(" ")));
        }
    }
    if let Some(ink) = &style.fill {
        options.push(format!("fill={}", mixed(ink)));
        if style.fill_opacity < 1.0 {
            options.push(format!("fill opacity={}", number(style.fill_opacity)));
        }
    }
    (!options.is_empty()).then(|| options.join(","))
}

/// Returns a colour of six hexadecimal digits in the syntax of xcolor.
fn mixed(digits: &str) -> String {
    let part = |k: usize| {
        let digits = digits.get(2 * k..2 * k + 2).unwrap_or("00");
        u8::from_str_radix(digits, 16).unwrap_or(0)
    };
    format!(
        "{{rgb,255:red,{};green,{};blue,{}}}",
        part(0),
        part(1),
        part(2)
    )
}

fn place(at: Vec2) -> String {
    let [x, y] = [at.x, at.y].map(|v| number(v.clamp(-MAX_DISTANCE, MAX_DISTANCE)));
    format!("({x},{y})")
}
