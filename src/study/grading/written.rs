//! Figures as students write them: with a comma or a point, and with as many digits as they like.

/// Longer texts are no figures.
const LONGEST: usize = 64;

/// A figure that somebody wrote, and how exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WrittenFigure {
    /// Its value.
    pub value: f64,
    /// Its significant digits; a 0 has none.
    pub digits: i32,
    /// One unit of its last digit.
    last: f64,
}

impl WrittenFigure {
    /// Reads a figure: `29.38`, `29,38`, `1.234,5`, `-4.6e5`, blanks among the digits, a `°` or the figure's own unit
    /// behind it. Where a point and a comma stand in it, the last is the decimal mark. `None` for anything else.
    #[must_use]
    pub fn read(text: &str, unit: &str) -> Option<WrittenFigure> {
        let text = text.trim();
        if text.len() > LONGEST {
            return None;
        }
        let text = text.replace('\u{2212}', "-");
        let number = text.strip_suffix(unit).unwrap_or(&text);
        let number = number.trim().trim_end_matches('°');
        let compact: String = number
            .chars()
            .filter(|c| !c.is_whitespace() && *c != '\'')
            .collect();
        let (mantissa, exponent) = match compact.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
            None => (compact.as_str(), 0),
        };
        let mantissa = with_point(mantissa)?;
        let is_number = mantissa
            .trim_start_matches(['-', '+'])
            .starts_with(|c: char| c.is_ascii_digit() || c == '.');
        let value: f64 = format!("{mantissa}e{exponent}").parse().ok()?;
        if !is_number || !value.is_finite() {
            return None;
        }
        let decimals = mantissa
            .split_once('.')
            .map_or("", |(_, decimals)| decimals);
        let places = i32::try_from(decimals.len()).ok()?;
        let bare: String = mantissa.chars().filter(char::is_ascii_digit).collect();
        let digits = bare.trim_start_matches('0').len();
        Some(WrittenFigure {
            value,
            digits: i32::try_from(digits).ok()?,
            last: ten_to(exponent.checked_sub(places)?),
        })
    }

    /// One unit of the last of so many digits: of the figure's own, but no fewer and no more than these.
    #[must_use]
    pub fn unit_of(&self, fewest: i32, most: i32) -> f64 {
        self.last * ten_to(self.digits - self.digits.clamp(fewest, most))
    }
}

/// The same with a point for a decimal mark, and none among the thousands.
fn with_point(text: &str) -> Option<String> {
    let marks = |mark: char| text.matches(mark).count();
    let mark = match (marks('.'), marks(',')) {
        (0, 0) => return Some(text.to_owned()),
        (1, 0) => '.',
        (0, 1) => ',',
        (points, commas) => {
            let last = if text.rfind('.') > text.rfind(',') {
                ('.', points)
            } else {
                (',', commas)
            };
            match last {
                (mark, 1) => mark,
                // Thousands alone.
                (_, 2..) if points == 0 || commas == 0 => ' ',
                _ => return None,
            }
        }
    };
    let written = text.chars().filter_map(|c| match c {
        c if c == mark => Some('.'),
        '.' | ',' => None,
        c => Some(c),
    });
    Some(written.collect())
}

fn ten_to(power: i32) -> f64 {
    10_f64.powi(power.clamp(-400, 400))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn read(text: &str) -> (f64, i32, f64) {
        let figure = WrittenFigure::read(text, "mm").unwrap_or_else(|| panic!("{text}"));
        (figure.value, figure.digits, figure.unit_of(0, 99))
    }

    #[test]
    fn commas_and_points_are_read_as_they_are_meant() {
        for (text, expected) in [
            ("29.38", (29.38, 4, 0.01)),
            ("29,38", (29.38, 4, 0.01)),
            (" -14,47 mm", (-14.47, 4, 0.01)),
            ("345.5°", (345.5, 4, 0.1)),
            ("8259", (8259.0, 4, 1.0)),
            ("8.259,5", (8259.5, 5, 0.1)),
            ("-459.977,6", (-459_977.6, 7, 0.1)),
            ("1.234.567", (1_234_567.0, 7, 1.0)),
            ("22 500", (22500.0, 5, 1.0)),
            ("2.40e4", (24000.0, 3, 100.0)),
            ("\u{2212}0,0250", (-0.025, 3, 0.0001)),
            ("0", (0.0, 0, 1.0)),
        ] {
            let (value, digits, last) = read(text);
            assert_eq!((value, digits), (expected.0, expected.1), "{text}");
            assert!((last / expected.2 - 1.0).abs() < 1e-12, "{text}: {last}");
        }
        for wrong in [
            "",
            "-",
            "x",
            "1.2.3,4,5",
            "nan",
            "inf",
            "1e",
            "e5",
            "29 deg",
            "1e999",
            ".",
        ] {
            assert_eq!(WrittenFigure::read(wrong, "mm"), None, "{wrong}");
        }
    }

    #[test]
    fn too_few_digits_count_as_three() {
        let rough = WrittenFigure::read("28", "cm").unwrap();
        assert!((rough.unit_of(3, 6) - 0.1).abs() < 1e-12);
        let fine = WrittenFigure::read("28.02517077", "cm").unwrap();
        assert!((fine.unit_of(3, 6) - 1e-4).abs() < 1e-12);
    }

    proptest! {
        #[test]
        fn nothing_that_is_written_ends_in_a_panic(text in ".{0,80}") {
            let _ = WrittenFigure::read(&text, "rad/s^2");
        }
    }
}
