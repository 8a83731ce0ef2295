//! Identifies the value named in a row of answers: by its column, or by the symbol of the lecture
//! notes.

use crate::quantity::Catalogue;

/// Symbols of angles with their order of derivative, longer ones first.
const TURNING: [(&str, usize); 9] = [
    ("theta", 0),
    ("teta", 0),
    ("omega", 1),
    ("alpha", 2),
    ("alfa", 2),
    ("θ", 0),
    ("ω", 1),
    ("α", 2),
    ("w", 1),
];
const ANGLES: [&str; 3] = ["angle", "omega", "alpha"];
const LENGTHS: [&str; 3] = ["length", "rate", "accel"];
/// Suffix of a direction's column.
const DIRECTION: &str = ".angle";
/// Dots above a letter: one for the first derivative, two for the second.
const DOT: char = '\u{307}';
const TWO_DOTS: char = '\u{308}';

/// Returns the column named by a row: `r4.angle` for `θ4`, `theta_4` and `R4.angle`. Returns `None`
/// if the scene has no such column.
pub(super) fn column_named(row: &str, catalogue: &Catalogue) -> Option<String> {
    let is_known = |name: &String| catalogue.find(name).is_some();
    candidate_columns(row).into_iter().find(is_known)
}

/// Returns the columns that a row may name, independent of the scene.
fn candidate_columns(row: &str) -> Vec<String> {
    let (name, _) = parted(row);
    let mut columns = vec![row.to_owned(), name.to_owned(), name.to_lowercase()];
    columns.extend(capitalised(name));
    columns.extend(columns_of_symbol(&plain(name)));
    columns
}

/// Splits a row's name from the unit in brackets after it: `θ4 [deg]`, `θ4 (rad) =`.
pub(super) fn parted(row: &str) -> (&str, &str) {
    let row = row.trim_end_matches([' ', '=', '?', ':']);
    for (open, close) in [('[', ']'), ('(', ')')] {
        if let Some((name, unit)) = row.strip_suffix(close).and_then(|row| row.split_once(open)) {
            return (name.trim(), unit.trim());
        }
    }
    (row, "")
}

/// Returns the name with its first letter in upper case; spreadsheets may change that letter.
fn capitalised(name: &str) -> Option<String> {
    let first = name.chars().next()?;
    let rest = &name[first.len_utf8()..];
    Some(first.to_uppercase().collect::<String>() + rest)
}

/// Returns a symbol without blanks and TeX marks, with plain subscripts, and with one variant of
/// each Greek letter.
fn plain(name: &str) -> String {
    let mut plain = String::new();
    for c in name.chars() {
        match c {
            '\\' | '{' | '}' | '$' | '|' => {}
            c if c.is_whitespace() => {}
            'ϑ' | 'Θ' => plain.push('θ'),
            'Ω' | '\u{2126}' => plain.push('ω'),
            '²' => plain.push('2'),
            'ṙ' => plain.extend(['r', DOT]),
            '₀'..='₉' => plain.extend(char::from_digit(c as u32 - '₀' as u32, 10)),
            c => plain.push(c),
        }
    }
    plain
}

/// Returns the columns that a symbol may denote.
fn columns_of_symbol(symbol: &str) -> Vec<String> {
    let (inner, order) = derivative(symbol);
    let mut columns = Vec::new();
    let lower = inner.to_lowercase();
    for (letter, own) in TURNING {
        let index = lower
            .strip_prefix(letter)
            .and_then(|_| inner.get(letter.len()..));
        let aspect = ANGLES.get(own + order);
        if let (Some(index), Some(aspect)) = (index.map(index_of), aspect) {
            let of_point = point_columns(index)
                .into_iter()
                .filter(|_| own + order == 0);
            columns.extend(of_point.map(|column| column + DIRECTION));
            columns.extend(bodies(index).map(|body| format!("{body}.{aspect}")));
        }
    }
    if order == 0 {
        columns.extend(point_columns(&inner));
    }
    if let Some(aspect) = LENGTHS.get(order) {
        columns.push(format!("{inner}.{aspect}"));
    }
    columns
}

/// Returns a symbol without its dots or `d/dt`, and its order of derivative.
fn derivative(symbol: &str) -> (String, usize) {
    let twice = |text: &str| {
        let inner = text.strip_prefix("d2")?;
        let inner = inner.strip_suffix("/dt2").or(inner.strip_suffix("/dt^2"))?;
        Some((inner.to_owned(), 2))
    };
    let once = |text: &str| {
        let inner = text.strip_prefix('d')?.strip_suffix("/dt")?;
        Some((inner.to_owned(), 1))
    };
    let (inner, order) = twice(symbol)
        .or_else(|| once(symbol))
        .unwrap_or_else(|| (symbol.to_owned(), 0));
    let dots = inner.matches(DOT).count() + 2 * inner.matches(TWO_DOTS).count();
    (inner.replace([DOT, TWO_DOTS], ""), order + dots)
}

/// Returns the index after a symbol's letter.
fn index_of(rest: &str) -> &str {
    rest.strip_prefix('_').unwrap_or(rest)
}

/// Returns the vectors that an index may denote: `r3` for `3`, `ram` for its name.
fn bodies(index: &str) -> impl Iterator<Item = String> {
    let numbered = index.starts_with(|c: char| c.is_ascii_digit());
    let numbered = numbered.then(|| format!("r{index}"));
    let named = (!index.is_empty()).then(|| index.to_owned());
    numbered.into_iter().chain(named)
}

/// Returns the columns denoted by a point's symbol: `aB`, `v_B`, `aG3`, `aB.angle`.
fn point_columns(symbol: &str) -> Vec<String> {
    let (symbol, end) = match symbol.strip_suffix(DIRECTION) {
        Some(symbol) => (symbol, DIRECTION),
        None => (symbol, ""),
    };
    let Some(letter) = symbol.chars().next().filter(|c| "vaVA".contains(*c)) else {
        return Vec::new();
    };
    let aspect = letter.to_ascii_lowercase();
    let point = index_of(&symbol[1..]);
    let centre = point.strip_prefix('G').map(index_of);
    let centre = centre.filter(|number| number.starts_with(|c: char| c.is_ascii_digit()));
    let centre = centre.map(|number| format!("r{number}.com"));
    let points = [Some(point.to_owned()), centre].into_iter().flatten();
    let columns = points.filter(|point| !point.is_empty());
    columns
        .map(|point| format!("{point}.{aspect}{end}"))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Scene, presets};

    fn catalogue(name: &str) -> Catalogue {
        let preset = presets::find(name).unwrap();
        Catalogue::new(&Scene::parse(preset.text, preset.name).unwrap())
    }

    #[test]
    fn symbols_from_notes_map_to_columns() {
        let catalogue = catalogue("four-bar");
        for (row, column) in [
            ("r4.angle", "r4.angle"),
            ("R4.angle", "r4.angle"),
            ("R4.ANGLE", "r4.angle"),
            ("b.a", "B.a"),
            ("θ4", "r4.angle"),
            ("θ_4", "r4.angle"),
            ("θ₄", "r4.angle"),
            ("Θ4", "r4.angle"),
            ("ϑ4", "r4.angle"),
            ("theta4", "r4.angle"),
            ("Theta_4", "r4.angle"),
            ("theta 4", "r4.angle"),
            ("teta4", "r4.angle"),
            ("\\theta_{4}", "r4.angle"),
            ("θ4 [deg]", "r4.angle"),
            ("θ4 =", "r4.angle"),
            ("ω3", "r3.omega"),
            ("omega3", "r3.omega"),
            ("w3", "r3.omega"),
            ("θ\u{307}3", "r3.omega"),
            ("dθ3/dt", "r3.omega"),
            ("α3", "r3.alpha"),
            ("alpha3", "r3.alpha"),
            ("alfa3", "r3.alpha"),
            ("ω\u{307}3", "r3.alpha"),
            ("θ\u{308}3", "r3.alpha"),
            ("d²θ3/dt²", "r3.alpha"),
            ("dω3/dt", "r3.alpha"),
            ("aB", "B.a"),
            ("a_B", "B.a"),
            ("|aB|", "B.a"),
            ("vC", "C.v"),
            ("aG3", "r3.com.a"),
            ("vG4", "r4.com.v"),
            ("a_r3.com", "r3.com.a"),
            ("aG3.angle", "r3.com.a.angle"),
            ("θ_aB", "B.a.angle"),
        ] {
            let found = column_named(row, &catalogue);
            assert_eq!(found.as_deref(), Some(column), "{row}");
        }
        for row in [
            "", "foo", "θ9", "θ", "ω", "x.y", "aZ", "d", "r4", "=", "[deg]", "θ4θ",
        ] {
            assert_eq!(column_named(row, &catalogue), None, "{row}");
        }
    }

    #[test]
    fn length_symbols_map_to_columns() {
        let catalogue = catalogue("slider-crank");
        for (row, column) in [
            ("r4", "r4.length"),
            ("r₄", "r4.length"),
            ("ṙ4", "r4.rate"),
            ("r\u{307}4", "r4.rate"),
            ("dr4/dt", "r4.rate"),
            ("r\u{308}4", "r4.accel"),
            ("d2r4/dt2", "r4.accel"),
            ("d²r4/dt²", "r4.accel"),
        ] {
            let found = column_named(row, &catalogue);
            assert_eq!(found.as_deref(), Some(column), "{row}");
        }
    }
}
