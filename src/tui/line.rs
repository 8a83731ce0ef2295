//! A line that is typed.

/// Longer than any number that means something.
const LONGEST: usize = 24;

/// A short line of 7-bit text, edited at its end.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Line(String);

impl Line {
    pub(crate) fn text(&self) -> &str {
        &self.0
    }

    /// Appends a character; what is not printable or no longer fits is left out.
    pub(crate) fn push(&mut self, c: char) {
        if (c == ' ' || c.is_ascii_graphic()) && self.0.len() < LONGEST {
            self.0.push(c);
        }
    }

    pub(crate) fn erase(&mut self) {
        self.0.pop();
    }

    pub(crate) fn clear(&mut self) {
        self.0.clear();
    }

    /// The number that was typed, its unit allowed behind it, a comma taken for the point.
    pub(crate) fn number(&self, unit: &str) -> Option<f64> {
        let text = self.0.trim();
        let text = text.strip_suffix(unit).unwrap_or(text).trim_end();
        let number: f64 = text.replace(',', ".").parse().ok()?;
        number.is_finite().then_some(number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(text: &str) -> Option<f64> {
        let mut line = Line::default();
        text.chars().for_each(|c| line.push(c));
        line.number("deg")
    }

    #[test]
    fn numbers_are_read_as_people_type_them() {
        assert_eq!(number("60"), Some(60.0));
        assert_eq!(number(" -12,5 deg"), Some(-12.5));
        assert_eq!(number("1e2deg"), Some(100.0));
        for wrong in ["", "deg", "1 2", "nan", "inf", "1,2,3", "60 mm"] {
            assert_eq!(number(wrong), None, "{wrong:?}");
        }
    }

    #[test]
    fn nothing_unprintable_gets_in_and_nothing_endless() {
        let mut line = Line::default();
        "\u{1b}1\u{e4}2\n".chars().for_each(|c| line.push(c));
        assert_eq!(line.text(), "12");
        (0..1000).for_each(|_| line.push('9'));
        assert_eq!(line.text().len(), LONGEST);
    }
}
