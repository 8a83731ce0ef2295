//! Writes a page as LaTeX that a plain TeX Live can process: the class `article`, amsmath, and TikZ
//! for pictures.

use super::math::{Formula, MathPiece};
use super::prose::{ProsePiece, label};
use super::{Cell, Content, Equation, Facts, Illustration, Page, Row, Table};
use std::fmt::Write as _;

const HEAD: &str = include_str!("latex/preamble.tex");

/// Characters per line of paper; wider tables are scaled down.
const LINE: usize = 76;

impl Page {
    /// Returns the page as a LaTeX document.
    #[must_use]
    pub fn to_latex(&self) -> String {
        let mut text = HEAD.to_owned();
        for block in &self.blocks {
            text.push_str(&block.content.harmless().latex(&self.symbols));
        }
        text + "\\end{document}\n"
    }
}

impl Content {
    fn latex(&self, symbols: &[String]) -> String {
        match self {
            Content::Title(text) => format!("{{\\LARGE\\bfseries {}\\par}}\n", escaped(text)),
            // Headings include their numbers.
            Content::Heading(1, text) => format!("\n\\section*{{{}}}\n", escaped(text)),
            Content::Heading(_, text) => format!("\n\\subsection*{{{}}}\n", escaped(text)),
            Content::Text(text) => format!("\n{}\n", prose(text.trim(), symbols)),
            Content::Facts(list) => facts(list, symbols),
            Content::Equations(equations) => equations.iter().map(equation).collect(),
            Content::Table(table) => columns(table, symbols),
            Content::Characters(lines) => in_characters(lines),
            Content::Picture(picture) => figure(picture, symbols),
        }
    }
}

/// Formats a drawing in characters; blanks keep their width.
fn in_characters(lines: &[String]) -> String {
    let lines = lines.iter().map(|line| escaped(line).replace(' ', "~"));
    let lines: Vec<String> = lines.collect();
    format!(
        "\n{{\\ttfamily\\small\\noindent {}\\par}}\n",
        lines.join("\\\\\n")
    )
}

/// Formats a picture at its position in the text, its caption below.
fn figure(picture: &Illustration, symbols: &[String]) -> String {
    format!(
        "\n\\begin{{center}}\n{}\n\\smallskip\n\n{{\\small {}\\par}}\n\\end{{center}}\n",
        picture.artwork.tikz(),
        prose(&picture.caption, symbols)
    )
}

fn equation(equation: &Equation) -> String {
    let sides: Vec<String> = equation.sides.iter().map(formula).collect();
    format!("\\eqline{{{}}}\n", sides.join(" = "))
}

fn facts(facts: &Facts, symbols: &[String]) -> String {
    if facts.list.is_empty() {
        return String::new();
    }
    let mut list = String::from("\n\\begin{description}\n\\setlength{\\itemsep}{0pt}\n");
    for (name, text) in &facts.list {
        let text: Vec<String> = text.iter().map(|text| prose(text, symbols)).collect();
        let name = escaped(name.trim());
        let _ = writeln!(list, "\\item[{{{name}}}] {}", text.join(" \\\\ "));
    }
    list + "\\end{description}\n"
}

fn columns(table: &Table, symbols: &[String]) -> String {
    let count = table.heads.len();
    let mut widths = vec![0; count + 1];
    let mut rows = Vec::new();
    let headers = table.heads.iter().map(|head| head.one_line());
    rows.push(
        std::iter::once(table.title.clone())
            .chain(headers)
            .map(Cell::proved)
            .collect(),
    );
    for row in &table.rows {
        let (mark, name) = row.label(true);
        let empty = || Cell::proved("");
        let mut all = vec![Cell::proved(format!("{mark} {}", name.trim()).trim())];
        match row {
            Row::Part(_) => {}
            Row::Told { words, .. } => all.push(Cell::proved(words)),
            Row::Figures { cells, .. } => {
                all.extend(cells.iter().map(|cell| cell.clone().unwrap_or_else(empty)));
            }
        }
        all.resize(count + 1, empty());
        rows.push(all);
    }
    for row in &rows {
        let row: &Vec<Cell> = row;
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = (*width).max(cell.text.trim().chars().count() + 2);
        }
    }
    let is_wide = widths.iter().sum::<usize>() > LINE;
    let line = |row: &Vec<Cell>| {
        let cells: Vec<String> = row.iter().map(|one| cell(one, symbols)).collect();
        cells.join(" & ")
    };
    let Some((head, body)) = rows.split_first() else {
        return String::new();
    };
    // A tabular does not break across pages.
    let parts = body.chunks(ROWS).map(|rows| {
        let mut lines = format!("{} \\\\ \\hline\n", line(head));
        for row in rows {
            let _ = writeln!(lines, "{} \\\\", line(row));
        }
        let set = format!(
            "\\begin{{tabular}}{{l{}}}\n{lines}\\hline\n\\end{{tabular}}",
            "r".repeat(count)
        );
        match is_wide {
            true => format!("\n\\medskip\\resizebox{{\\textwidth}}{{!}}{{{set}}}\\medskip\n"),
            false => format!("\n\\medskip{set}\\medskip\n"),
        }
    });
    parts.collect()
}

/// Maximum number of rows of a table on one page.
const ROWS: usize = 40;

/// Formats a cell; an equation is highlighted.
fn cell(cell: &Cell, symbols: &[String]) -> String {
    let text = cell.text.trim();
    if let Some(equation) = &cell.formula {
        return format!("\\boldmath\\({}\\)", formula(equation));
    }
    // Rates are typeset as in formulas.
    if let Some(label) = label(text, symbols) {
        return format!("\\({}\\)", formula(&label));
    }
    match text.strip_prefix('-') {
        Some(size) if size.starts_with(|c: char| c.is_ascii_digit()) => {
            format!("\\(-\\){}", escaped(size))
        }
        _ => escaped(text),
    }
}

/// Formats a formula in math mode.
fn formula(of: &Formula) -> String {
    let pieces = &of.0;
    let one = |(k, piece): (usize, &MathPiece)| match piece {
        MathPiece::Symbol(symbol) => {
            let letter = match greek(&symbol.letter) {
                Some(name) => format!("{name} "),
                None if symbol.letter.len() == 1 => in_math(&symbol.letter),
                None => format!("\\text{{{}}}", escaped(&symbol.letter)),
            };
            let letter = match symbol.order {
                0 => letter,
                1 => dotted("dot", &letter),
                _ => dotted("ddot", &letter),
            };
            match symbol.index.replace('_', " ").as_str() {
                "" => letter,
                index => format!("{letter}_{{\\text{{{}}}}}", escaped(index)),
            }
        }
        // A root covers the whole content of its brackets.
        MathPiece::Function("sqrt", of) => format!("\\sqrt{{{}}}", formula(of)),
        MathPiece::Function(name @ ("sin" | "cos" | "tan"), of) => {
            format!("\\{name} ({})", formula(of))
        }
        MathPiece::Function(name, of) => format!("\\operatorname{{{name}}}({})", formula(of)),
        MathPiece::Word(text) => format!("\\text{{{}}}", escaped(text)),
        MathPiece::Number(number) => match number.split_once('e') {
            None => escaped(number),
            Some((digits, power)) => {
                format!("{}\\cdot10^{{{}}}", escaped(digits), escaped(power))
            }
        },
        MathPiece::Power(exponent) => {
            // TeX stops at an exponent of an exponent.
            let base = match pieces.get(k.wrapping_sub(1)) {
                Some(MathPiece::Power(_)) => "{}",
                _ => "",
            };
            format!("{base}^{{{}}}", in_math(exponent))
        }
        MathPiece::Sign('·') => "\\cdot ".into(),
        MathPiece::Sign('±') => "\\pm ".into(),
        MathPiece::Sign(',') => ",\\penalty900 ".into(),
        MathPiece::Sign('/') => "/\\penalty900 ".into(),
        MathPiece::Sign(sign) if "+-=()[]|<>".contains(*sign) => sign.to_string(),
        MathPiece::Sign(sign) => format!("\\text{{{}}}", escaped(&sign.to_string())),
        MathPiece::Blank => blank(pieces.get(k.wrapping_sub(1)), pieces.get(k + 1)).into(),
    };
    pieces.iter().enumerate().map(one).collect()
}

/// Formats letters and digits in math mode, and other characters as text.
fn in_math(text: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || c == '-';
    match text.chars().all(is_plain) {
        true => text.to_owned(),
        false => format!("\\text{{{}}}", escaped(text)),
    }
}

/// Puts dots over a letter; in a name of several letters, over the first.
fn dotted(dots: &str, letter: &str) -> String {
    let word = letter.strip_prefix("\\text{");
    let first = word.and_then(|word| word.chars().next());
    match (word, first) {
        (Some(word), Some(first)) if first.is_alphabetic() => {
            let rest = &word[first.len_utf8()..];
            format!("\\{dots}{{\\text{{{first}}}}}\\text{{{rest}")
        }
        _ => format!("\\{dots}{{{letter}}}"),
    }
}

/// Formats a paragraph: text in backticks as typewriter text, rates and powers as in formulas.
fn prose(text: &str, symbols: &[String]) -> String {
    let mut out = String::new();
    for piece in super::prose::pieces(text, symbols) {
        let _ = match piece {
            ProsePiece::Typed(typed) => write!(out, "\\texttt{{{}}}", escaped(typed)),
            ProsePiece::Formula(word) => write!(out, "\\({}\\)", formula(&word)),
            ProsePiece::Words(words) => write!(out, "{}", escaped(words)),
        };
    }
    out
}

/// Returns the space between two pieces: wide next to words, narrow between factors, none next to
/// signs, which bring their own.
fn blank(before: Option<&MathPiece>, after: Option<&MathPiece>) -> &'static str {
    let is_sign = |piece: Option<&MathPiece>| {
        matches!(
            piece,
            None | Some(MathPiece::Sign('+' | '-' | '±' | '=' | '·'))
        )
    };
    let is_word = |piece: Option<&MathPiece>| match piece {
        Some(MathPiece::Symbol(symbol)) => symbol.is_word(),
        piece => matches!(piece, Some(MathPiece::Word(_))),
    };
    if is_word(before) || is_word(after) {
        "\\ \\penalty900 "
    } else if is_sign(before) || is_sign(after) {
        " "
    } else {
        // A product longer than a line is broken between its factors.
        "\\,\\penalty900 "
    }
}

/// Returns the command of a Greek letter.
fn greek(letter: &str) -> Option<&'static str> {
    Some(match letter {
        "θ" => "\\theta",
        "ω" => "\\omega",
        "α" => "\\alpha",
        "β" => "\\beta",
        "γ" => "\\gamma",
        "μ" => "\\mu",
        "ν" => "\\nu",
        "Δ" => "\\Delta",
        _ => return None,
    })
}

/// Letters beyond ASCII that every TeX can typeset.
const LETTERS: &str = "ÀÁÂÃÄÅÇÈÉÊËÌÍÎÏÑÒÓÔÕÖØÙÚÛÜÝàáâãäåçèéêëìíîïñòóôõöøùúûüýÿßæÆœŒ\
                       ĞğİıŞşĂăĆćČčĎďĚěŁłŃńŇňŐőŘřŚśŠšŤťŮůŰűŹźŻżŽž";

/// Escapes a text for TeX; characters that TeX cannot typeset become `?`.
pub(super) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\\' => out.push_str("\\textbackslash{}"),
            '{' | '}' | '$' | '&' | '#' | '%' | '_' => {
                out.push('\\');
                out.push(c);
            }
            '^' => out.push_str("\\textasciicircum{}"),
            '~' => out.push_str("\\textasciitilde{}"),
            '<' => out.push_str("\\ensuremath{<}"),
            '>' => out.push_str("\\ensuremath{>}"),
            '|' => out.push_str("\\ensuremath{|}"),
            '[' | ']' => {
                out.push('{');
                out.push(c);
                out.push('}');
            }
            '"' => out.push_str("{\\textquotedblright}"),
            '·' => out.push_str("\\ensuremath{\\cdot}"),
            '²' => out.push_str("\\ensuremath{^2}"),
            '→' => out.push_str("\\ensuremath{\\rightarrow}"),
            '\u{2212}' => out.push_str("\\ensuremath{-}"),
            // Two hyphens would become a dash.
            '-' if out.ends_with('-') => out.push_str("{}-"),
            c if c.is_ascii_graphic() || c == ' ' || LETTERS.contains(c) => out.push(c),
            c => match greek(c.encode_utf8(&mut [0; 4])) {
                Some(name) => out.push_str(&format!("\\ensuremath{{{name}}}")),
                None => out.push('?'),
            },
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::Symbol;

    #[test]
    fn formulas_become_latex_math() {
        let root = Formula::function("sqrt", [Formula::from("m").power("2")]);
        assert_eq!(
            formula(&Formula::example()),
            "-r_{\\text{2}}\\,\\penalty900 \\omega _{\\text{2}}^{2}\\,\\penalty900 \\cos (\\theta _{\\text{2}})"
        );
        assert_eq!(
            formula(&root.blank().then(Formula::words("mm"))),
            "\\sqrt{m^{2}}\\ \\penalty900 \\text{mm}"
        );
        let rate = |name, order| formula(&Symbol::named(name).derivative(order).into());
        assert_eq!(rate("r4", 2), "\\ddot{r}_{\\text{4}}");
        assert_eq!(rate("rod", 1), "\\dot{\\text{r}}\\text{od}");
        assert_eq!(
            prose("Type `a_b`, which removes dr6/dt.", &[]),
            "Type \\texttt{a\\_b}, which removes \\(\\dot{r}_{\\text{6}}\\)."
        );
        let small = Formula::number("5.7e-14");
        assert_eq!(formula(&small), "5.7\\cdot10^{-14}");
    }

    /// TeX stops at an unescaped special character and at two exponents.
    #[test]
    fn any_text_of_a_scene_is_valid_in_math() {
        for (text, expected) in [
            ("a^2+b^2", "\\(a^{2}+b^{2}\\)"),
            ("f(x^2)", "\\(f(x^{2})\\)"),
            ("10^9'dan", "\\(10^{9}\\text{'dan}\\)"),
            ("%^2", "\\(\\text{\\%}^{2}\\)"),
            (
                "r2·ω2^2",
                "\\(r_{\\text{2}}\\cdot \\omega _{\\text{2}}^{2}\\)",
            ),
            ("dr4/dt'yi", "\\(\\dot{r}_{\\text{4}}\\text{'yi}\\)"),
        ] {
            assert_eq!(prose(text, &[]), expected, "{text}");
        }
        let label = |text| cell(&Cell::proved(text), &[]);
        assert_eq!(
            label("θ3 & θ4"),
            "\\(\\theta _{\\text{3}}\\,\\penalty900 \\text{\\&}\\,\\penalty900 \\theta _{\\text{4}}\\)"
        );
        assert_eq!(label("θ3 + 30"), "\\(\\theta _{\\text{3}} + 30\\)");
        assert_eq!(formula(&"_".into()), "\\text{\\_}");
        assert_eq!(formula(&"Δ_r3".into()), "\\Delta _{\\text{r3}}");
        assert_eq!(
            formula(&Formula::words("m^2^%")),
            "\\text{m}^{2}{}^{\\text{\\%}}"
        );
        assert_eq!(escaped("d²"), "d\\ensuremath{^2}");
    }

    #[test]
    fn text_is_escaped() {
        assert_eq!(
            escaped("\\input{x} 5% a_b #1 ü 字"),
            "\\textbackslash{}input\\{x\\} 5\\% a\\_b \\#1 ü ?"
        );
    }
}
