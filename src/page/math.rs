//! Splits formulas into pieces, for writers that typeset them.

/// A piece of a formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum MathPiece {
    /// A symbol: its letter, its index and its order of differentiation by time, shown as dots.
    Symbol(String, String, usize),
    /// `cos`.
    Function(String),
    /// A unit of one letter, which is no symbol: the `s` of `mm/s`, following [`UNIT`].
    Unit(String),
    /// A number, and the power of ten that follows it.
    Number(String, Option<String>),
    /// An exponent: `2`.
    Power(String),
    /// A sign or a bracket.
    Sign(char),
    /// One or more blanks.
    Blank,
}

/// The marker before a unit: `2 {UNIT}N m`. It distinguishes the unit of seconds from a length
/// named `s`. Plain texts are shown without it.
pub(crate) const UNIT: char = '\u{e000}';

/// Units that can follow another unit and a blank, as in `N m`.
const FACTORS: [&str; 7] = ["m", "mm", "cm", "in", "s", "rad", "kg"];

const FUNCTIONS: [&str; 8] = ["sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sqrt"];
/// Names of components, which have an index although no digit occurs.
const COMPONENTS: [&str; 18] = [
    "mx", "my", "ax", "ay", "ex", "ey", "fx", "fy", "tx", "ty", "sx", "sy", "nx", "ny", "Kx", "Ky",
    "Fx", "Fy",
];

/// Splits a formula into pieces.
pub(super) fn pieces(formula: &str) -> Vec<MathPiece> {
    let chars: Vec<char> = formula.chars().collect();
    let mut pieces = Vec::new();
    let mut i = 0;
    let mut in_unit = false;
    while let Some(&c) = chars.get(i) {
        if c == UNIT {
            in_unit = true;
            i += 1;
            continue;
        }
        in_unit &= continues_unit(&chars[i..]);
        let run = |is: fn(char) -> bool| -> String {
            chars[i..].iter().copied().take_while(|&c| is(c)).collect()
        };
        let length = |text: &str| text.chars().count();
        if c == ' ' {
            i += length(&run(|c| c == ' '));
            pieces.push(MathPiece::Blank);
        } else if c.is_ascii_digit() {
            let digits = run(|c| c.is_ascii_digit() || c == '.');
            i += length(&digits);
            let power = exponent(&chars[i..]);
            i += power.as_ref().map_or(0, |power| length(power) + 1);
            pieces.push(MathPiece::Number(digits, power));
        } else if c == '^' && chars.get(i + 1).is_some_and(char::is_ascii_digit) {
            let raised: String = chars[i + 1..]
                .iter()
                .take_while(|c| c.is_ascii_digit())
                .collect();
            i += 1 + length(&raised);
            pieces.push(MathPiece::Power(raised));
        } else if c.is_alphabetic() {
            let name = name(&chars[i..]);
            let (name, order) = match derivative(&name, &chars[i + length(&name)..]) {
                Some((inner, order)) => (inner.to_owned(), order),
                None => (name, 0),
            };
            i += length(&name) + [0, 4, 6][order];
            let is_called = chars.get(i) == Some(&'(');
            pieces.push(match in_unit && name.chars().count() == 1 {
                true => MathPiece::Unit(name),
                false if is_called && FUNCTIONS.contains(&name.as_str()) => {
                    MathPiece::Function(name)
                }
                false => named(&name, order),
            });
        } else if c == '+' && chars.get(i + 1) == Some(&'-') {
            i += 2;
            pieces.push(MathPiece::Sign('±'));
        } else {
            i += 1;
            pieces.push(MathPiece::Sign(c));
        }
    }
    pieces
}

/// Returns the name at the beginning. A `-` within it belongs to the name, because a minus sign is
/// surrounded by blanks.
fn name(chars: &[char]) -> String {
    let is_letter = |c: &char| c.is_alphanumeric() || matches!(c, '_' | '.' | '\'');
    let joins = |k: usize| chars[k] == '-' && chars.get(k + 1).is_some_and(|c| c.is_alphanumeric());
    let length = (0..chars.len()).take_while(|&k| is_letter(&chars[k]) || joins(k));
    chars[..length.count()].iter().collect()
}

/// Returns `true` if the text following a part of a unit is another part of it.
fn continues_unit(rest: &[char]) -> bool {
    match rest.first() {
        Some('/' | '^') => true,
        Some(' ') => FACTORS.contains(&name(&rest[1..]).as_str()),
        Some(c) => c.is_alphabetic(),
        None => false,
    }
}

/// Returns the exponent of `e-14` following a number.
fn exponent(rest: &[char]) -> Option<String> {
    let after = rest.strip_prefix(&['e'])?;
    let sign = usize::from(matches!(after.first(), Some('-' | '+')));
    let digits = after[sign..].iter().take_while(|c| c.is_ascii_digit());
    let digits = digits.count();
    (digits > 0).then(|| after[..sign + digits].iter().collect())
}

/// Returns the name and the order of a derivative: of `dr4` before `/dt`, or of `d2r4` before
/// `/dt2`.
fn derivative<'n>(name: &'n str, rest: &[char]) -> Option<(&'n str, usize)> {
    let follows = |word: &str| {
        let word: Vec<char> = word.chars().collect();
        let ends = |c: Option<&char>| !c.is_some_and(|c| c.is_alphanumeric());
        rest.starts_with(&word) && ends(rest.get(word.len()))
    };
    if let Some(inner) = name.strip_prefix("d2").filter(|_| follows("/dt2")) {
        return Some((inner, 2)).filter(|(inner, _)| !inner.is_empty());
    }
    let inner = name.strip_prefix('d').filter(|_| follows("/dt"))?;
    Some((inner, 1)).filter(|(inner, _)| !inner.is_empty())
}

/// Splits a name into a symbol and its index: `r3`, `θ3`, `α_ram`, `aB`, `a_r3.com_t`.
fn named(name: &str, order: usize) -> MathPiece {
    let split = |at: usize| (name[..at].to_owned(), name[at..].to_owned());
    let first = name.chars().next().map_or(0, char::len_utf8);
    let rest = &name[first..];
    let is_number = |text: &str| {
        let digits = text.trim_end_matches('\'');
        !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit())
    };
    let of_point = name.starts_with(['v', 'a', 'x', 'y'])
        && rest.starts_with(|c: char| c.is_ascii_uppercase());
    let (letter, index) = match name.split_once('_') {
        Some((letter, index)) if !letter.is_empty() => (letter.into(), index.replace('_', " ")),
        _ if name.starts_with(is_greek)
            || is_number(rest)
            || of_point
            || COMPONENTS.contains(&name) =>
        {
            split(first)
        }
        _ => (name.to_owned(), String::new()),
    };
    MathPiece::Symbol(letter, index, order)
}

/// Returns `true` for a Greek letter. Symbols begin with one if not with a Latin letter; words of a
/// language have other letters.
fn is_greek(c: char) -> bool {
    ('\u{370}'..='\u{3ff}').contains(&c)
}

/// Returns the index of the bracket that closes the one at this position.
pub(super) fn closing(pieces: &[MathPiece], open: usize) -> Option<usize> {
    let mut depth = 0_usize;
    for (k, piece) in pieces.iter().enumerate().skip(open) {
        match piece {
            MathPiece::Sign('(') => depth += 1,
            MathPiece::Sign(')') => depth = depth.checked_sub(1)?,
            _ => {}
        }
        if depth == 0 {
            return Some(k);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use MathPiece::{Blank, Function, Number, Power, Sign};

    fn symbol(letter: &str, index: &str, order: usize) -> MathPiece {
        MathPiece::Symbol(letter.into(), index.into(), order)
    }

    /// Names in a scene may contain a `-` or be those of functions.
    #[test]
    fn names_with_hyphens_or_of_functions_stay_whole() {
        let symbols = |formula: &str| -> Vec<String> {
            let of = |piece: MathPiece| match piece {
                MathPiece::Symbol(letter, index, _) => Some(format!("{letter}|{index}")),
                MathPiece::Function(name) => Some(format!("{name}()")),
                _ => None,
            };
            pieces(formula).into_iter().filter_map(of).collect()
        };
        assert_eq!(symbols("sin(θ_a-b - θ3)"), ["sin()", "θ|a-b", "θ|3"]);
        assert_eq!(
            symbols("r1 + sin + r4 = -r2"),
            ["r|1", "sin|", "r|4", "r|2"]
        );
    }

    #[test]
    fn names_split_into_symbol_and_index() {
        for (name, letter, index) in [
            ("r3", "r", "3"),
            ("θ3", "θ", "3"),
            ("α_ram", "α", "ram"),
            ("aB", "a", "B"),
            ("aBt", "a", "Bt"),
            ("xB", "x", "B"),
            ("a_r3.com_t", "a", "r3.com t"),
            ("mx", "m", "x"),
            ("Kx", "K", "x"),
            ("açısı", "açısı", ""),
            ("deg", "deg", ""),
            ("ram", "ram", ""),
            ("at", "at", ""),
        ] {
            assert_eq!(pieces(name), [symbol(letter, index, 0)], "{name}");
        }
    }

    #[test]
    fn formulas_split_into_pieces() {
        let taken = pieces("-ω3^2·sqrt(2) 5.7e-14");
        let two = || Number("2".into(), None);
        let expected = [
            Sign('-'),
            symbol("ω", "3", 0),
            Power("2".into()),
            Sign('·'),
            Function("sqrt".into()),
            Sign('('),
            two(),
            Sign(')'),
            Blank,
            Number("5.7".into(), Some("-14".into())),
        ];
        assert_eq!(taken, expected);
        assert_eq!(closing(&taken, 5), Some(7));
        assert_eq!(pieces("dr4/dt"), [symbol("r", "4", 1)]);
        assert_eq!(
            pieces("d2r4/dt2 r4"),
            [symbol("r", "4", 2), Blank, symbol("r", "4", 0)]
        );
        let unit = |name: &str| MathPiece::Unit(name.into());
        assert_eq!(pieces("p +- q")[2], Sign('±'));
        let marked = |text: &str| pieces(&text.replace('@', &UNIT.to_string()));
        assert_eq!(marked("2 @mm/s")[4], unit("s"));
        assert_eq!(marked("2 @N m")[2..], [unit("N"), Blank, unit("m")]);
        assert_eq!(marked("2 @m/s^2 s")[2], unit("m"));
        assert_eq!(marked("2 @m/s^2 + s")[9], symbol("s", "", 0));
        // Unmarked letters are symbols.
        for (text, at, letter) in [("2 m r3", 2, "m"), ("r2/s", 2, "s"), ("2 N", 2, "N")] {
            assert_eq!(pieces(text)[at], symbol(letter, "", 0), "{text}");
        }
        assert_eq!(pieces("dist")[0], symbol("dist", "", 0));
    }
}
