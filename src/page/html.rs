//! Writes a page as one self-contained HTML file: tables, formulas with indices and inline SVG
//! pictures. It has no script. It is light or dark on a screen, as the reader prefers, and light on
//! A4 paper.

use super::math::{Formula, MathPiece, Symbol};
use super::prose::{ProsePiece, label};
use super::svg::{marked_up, push_marked_up};
use super::{Block, Cell, Content, Equation, Facts, Illustration, Page, Row, Table, in_chunks};
use crate::wording::words;
use std::borrow::Cow;
use std::fmt::Write as _;

const SHEET: &str = include_str!("html/page.css");
const DARK: &str = ":root{--ink:#ddd;--paper:#181818;--line:#555;--quiet:#aaa;--found:#ff9a94}\n";

impl Page {
    /// Returns the page as an HTML file.
    #[must_use]
    pub fn to_html(&self) -> String {
        let mut title = "";
        let mut sheets = Vec::new();
        for block in &self.blocks {
            match &block.content {
                Content::Title(text) => title = text,
                Content::Picture(picture) if !sheets.contains(&picture.artwork.style) => {
                    sheets.push(picture.artwork.style);
                }
                _ => {}
            }
        }
        let write = |blocks: &[Block]| -> String {
            let blocks = blocks.iter();
            blocks
                .map(|block| block.content.html(&sheets, &self.symbols))
                .collect()
        };
        let body = in_chunks(&self.blocks, write).concat();
        let mut rules = SHEET.to_owned();
        let mut when_dark = DARK.to_owned();
        for (number, sheet) in sheets.iter().enumerate() {
            rules.push_str(&sheet.scoped(&class(number), false));
            when_dark.push_str(&sheet.scoped(&class(number), true));
        }
        let head = format!(
            "<style>\n{rules}@media screen and (prefers-color-scheme:dark){{\n{when_dark}}}\n</style>\n"
        );
        html_document(title, &head, &body)
    }
}

/// Returns an HTML file in the current language. `title` is a text; `head` and `body` are HTML.
pub(crate) fn html_document(title: &str, head: &str, body: &str) -> String {
    format!(
        "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\"/>\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n\
         <title>{}</title>\n{head}</head>\n<body>\n{body}</body>\n</html>\n",
        words().language_tag(),
        marked_up(title),
    )
}

/// Returns the class of pictures with the style sheet of this index.
fn class(number: usize) -> String {
    format!("art{number}")
}

impl Content {
    fn html(&self, sheets: &[super::style::StyleSheet], symbols: &[String]) -> String {
        // The texts of formulas are made harmless as they are written.
        let content = match self {
            Content::Equations(_) => Cow::Borrowed(self),
            _ => Cow::Owned(self.harmless()),
        };
        match &*content {
            Content::Title(text) => format!("<h1>{}</h1>\n", marked_up(text)),
            Content::Heading(level, text) => {
                let level = (level + 1).min(6);
                format!("<h{level}>{}</h{level}>\n", marked_up(text))
            }
            Content::Text(text) => format!("<p>{}</p>\n", prose(text.trim(), symbols)),
            Content::Facts(list) => facts(list, symbols),
            Content::Equations(equations) => {
                let mut text = String::new();
                for equation in equations {
                    push_equation(equation, &mut text);
                }
                text
            }
            Content::Table(table) => columns(table, symbols),
            Content::Characters(lines) => format!("<pre>{}</pre>\n", marked_up(&lines.join("\n"))),
            Content::Picture(picture) => {
                let sheet = &picture.artwork.style;
                let number = sheets.iter().position(|known| known == sheet);
                figure(picture, &class(number.unwrap_or(0)), symbols)
            }
        }
    }
}

fn figure(picture: &Illustration, class: &str, symbols: &[String]) -> String {
    let drawn = picture.artwork.svg_inside(&format!("art {class}"));
    let caption = prose(&picture.caption, symbols);
    format!("<figure>\n{drawn}<figcaption>{caption}</figcaption>\n</figure>\n")
}

fn push_equation(equation: &Equation, out: &mut String) {
    out.push_str("<div class=\"eq\">");
    for (k, side) in equation.sides.iter().enumerate() {
        if k > 0 {
            out.push_str(" = ");
        }
        push_formula(side, out);
    }
    out.push_str("</div>\n");
}

fn facts(facts: &Facts, symbols: &[String]) -> String {
    let mut list = String::from("<dl>\n");
    for (name, text) in &facts.list {
        let text: Vec<String> = text.iter().map(|text| prose(text, symbols)).collect();
        let _ = writeln!(
            list,
            "<dt>{}</dt><dd>{}</dd>",
            marked_up(name.trim()),
            text.join("<br/>")
        );
    }
    list + "</dl>\n"
}

fn columns(table: &Table, symbols: &[String]) -> String {
    let headers = table
        .heads
        .iter()
        .map(|head| name_of(&head.one_line(), symbols));
    let headers: String = headers.map(|head| format!("<th>{head}</th>")).collect();
    let title = marked_up(&table.title);
    let mut text = format!(
        "<div class=\"sheet\"><table>\n<thead><tr><th>{title}</th>{headers}</tr></thead>\n<tbody>\n"
    );
    let count = table.heads.len();
    for row in &table.rows {
        let (mark, name) = row.label(true);
        let name = name_of(format!("{mark} {}", name.trim()).trim(), symbols);
        let cells = match row {
            Row::Part(_) => "<td></td>".repeat(count),
            Row::Told { words, .. } => {
                format!(
                    "<td class=\"told\" colspan=\"{count}\">{}</td>",
                    prose(words, symbols)
                )
            }
            Row::Figures { cells, .. } => {
                let cells = (0..count).map(|k| cells.get(k).and_then(Option::as_ref));
                cells.map(figures).collect()
            }
        };
        let _ = writeln!(text, "<tr><th>{name}</th>{cells}</tr>");
    }
    text + "</tbody></table></div>\n"
}

/// Formats the name of a row or column; rates are typeset as in formulas.
fn name_of(text: &str, symbols: &[String]) -> String {
    match label(text, symbols) {
        Some(label) => formula(&label),
        None => marked_up(text),
    }
}

/// Formats a paragraph: text in backticks as code, rates and powers as in formulas.
fn prose(text: &str, symbols: &[String]) -> String {
    let mut out = String::new();
    for piece in super::prose::pieces(text, symbols) {
        let _ = match piece {
            ProsePiece::Typed(typed) => write!(out, "<code>{}</code>", marked_up(typed)),
            ProsePiece::Formula(word) => write!(out, "{}", formula(&word)),
            ProsePiece::Words(words) => write!(out, "{}", marked_up(words)),
        };
    }
    out
}

/// Formats a cell; an equation is highlighted.
fn figures(cell: Option<&Cell>) -> String {
    match cell.and_then(|cell| cell.formula.as_ref()) {
        Some(equation) => format!("<td class=\"found\">{}</td>", formula(equation)),
        None => {
            let text = cell.map_or("", |cell| cell.text.trim());
            format!("<td>{}</td>", marked_up(&text.replace('-', "\u{2212}")))
        }
    }
}

/// Formats a formula with its indices and powers.
fn formula(of: &Formula) -> String {
    let mut text = String::new();
    push_formula(of, &mut text);
    text
}

/// Appends a formula with its indices and powers.
fn push_formula(of: &Formula, out: &mut String) {
    for piece in &of.0 {
        match piece {
            MathPiece::Symbol(symbol) => push_symbol(symbol, out),
            MathPiece::Function(name, of) => {
                out.push_str(name);
                out.push('(');
                push_formula(of, out);
                out.push(')');
            }
            MathPiece::Word(text) => push_marked_up(text, out),
            MathPiece::Number(number) => match number.split_once('e') {
                None => push_marked_up(number, out),
                Some((digits, power)) => {
                    push_marked_up(digits, out);
                    out.push_str("·10");
                    push_power(power, out);
                }
            },
            MathPiece::Power(exponent) => push_power(exponent, out),
            MathPiece::Sign('-') => out.push('\u{2212}'),
            MathPiece::Sign(sign) => push_marked_up(sign.encode_utf8(&mut [0; 4]), out),
            MathPiece::Blank => out.push(' '),
        }
    }
}

fn push_symbol(symbol: &Symbol, out: &mut String) {
    let dots = ["", "\u{307}", "\u{308}"][symbol.order.min(2)];
    // The first of several letters carries the dots.
    let first = symbol.letter.chars().next().map_or(0, char::len_utf8);
    let (first, rest) = symbol.letter.split_at(first);
    let [open, close] = if rest.is_empty() {
        ["<i>", "</i>"]
    } else {
        [""; 2]
    };
    out.push_str(open);
    push_marked_up(first, out);
    out.push_str(dots);
    push_marked_up(rest, out);
    out.push_str(close);
    if !symbol.index.is_empty() {
        out.push_str("<sub>");
        push_marked_up(&symbol.index.replace('_', " "), out);
        out.push_str("</sub>");
    }
}

fn push_power(exponent: &str, out: &mut String) {
    out.push_str("<sup>");
    push_marked_up(&exponent.replace('-', "\u{2212}"), out);
    out.push_str("</sup>");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_become_html_with_indices_and_powers() {
        assert_eq!(
            formula(&Formula::example()),
            "\u{2212}<i>r</i><sub>2</sub> <i>ω</i><sub>2</sub><sup>2</sup> cos(<i>θ</i><sub>2</sub>)"
        );
        let small = Formula::measured("5.7e-14", "mm");
        assert_eq!(formula(&small), "5.7·10<sup>\u{2212}14</sup> mm");
        assert_eq!(
            name_of("dr/dt [mm/s]", &[]),
            "<i>r\u{307}</i> [mm/s]",
            "as in the formulas"
        );
        let rate = |name| formula(&Symbol::named(name).derivative(1).into());
        assert_eq!(rate("r4"), "<i>r\u{307}</i><sub>4</sub>");
        assert_eq!(rate("rod"), "r\u{307}od", "over the first letter");
        assert_eq!(
            name_of("α [rad/s^2]", &[]),
            "<i>α</i> [rad/s<sup>2</sup>]",
            "as below it"
        );
        assert_eq!(
            prose("Write `a < b`, which removes dr6/dt: 2 mm/s^2.", &[]),
            "Write <code>a &lt; b</code>, which removes <i>r\u{307}</i><sub>6</sub>: \
             2 mm/s<sup>2</sup>."
        );
        for (text, expected) in [
            ("a^2+b^2", "<i>a</i><sup>2</sup>+<i>b</i><sup>2</sup>"),
            ("f(x^2)", "<i>f</i>(<i>x</i><sup>2</sup>)"),
            ("10^9'dan", "10<sup>9</sup>'dan"),
            ("1/r3^2", "1/<i>r</i><sub>3</sub><sup>2</sup>"),
            ("dr4/dt'yi", "<i>r\u{307}</i><sub>4</sub>'yi"),
        ] {
            assert_eq!(prose(text, &[]), expected, "{text}");
        }
        assert_eq!(name_of("θ3 - 30", &[]), "<i>θ</i><sub>3</sub> \u{2212} 30");
        let less = Formula::from("a").with_sign('<').then("b");
        assert_eq!(formula(&less), "<i>a</i>&lt;<i>b</i>");
    }
}
