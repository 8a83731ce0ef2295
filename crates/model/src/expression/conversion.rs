//! Converts a number with a unit to another unit of the same dimension.

use super::{LengthScale, MeasuredNumber, evaluate, glued, parse};

/// Converts a number with a unit, such as `5 in` or `12cm`, to another `unit`. Returns `None` if
/// the text is no such number or the dimensions differ.
pub(crate) fn converted(text: &str, unit: &str, length: LengthScale) -> Option<f64> {
    let spaced = glued(text).map(|(number, unit)| format!("{number} {unit}"));
    let typed = measured(spaced.as_deref().unwrap_or(text), length)?;
    let one = measured(&format!("1 {unit}"), length)?;
    let is_alike = typed.dimension?.adds_to(one.dimension?);
    is_alike.then(|| typed.value.over(&one.value).nearest())
}

fn measured(text: &str, length: LengthScale) -> Option<MeasuredNumber> {
    let tree = parse(text).ok().filter(|tree| tree.is_number())?;
    evaluate(text, &tree, length, &|_| Err(None)).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn converted_requires_units_of_one_measure() {
        let mm = LengthScale {
            symbol: "mm",
            tenths_of_mm: 10.0,
        };
        for (text, unit, expected) in [
            ("5 in", "mm", Some(127.0)),
            ("12cm", "mm", Some(120.0)),
            ("-1.1 in", "mm", Some(-27.94)),
            ("5 in/s", "mm/s", Some(127.0)),
            ("1 m/s^2", "mm/s^2", Some(1000.0)),
            ("90 deg", "deg", Some(90.0)),
            ("1.2 rad", "deg", Some(68.754_935_415_698_78)),
            ("180 deg/s", "rad/s", Some(std::f64::consts::PI)),
            ("5 kg", "mm", None),
            ("5 mm", "", None),
            ("5 deg", "", None),
            ("5", "mm", None),
            ("5 mm + 1 mm", "mm", None),
            ("a", "mm", None),
        ] {
            assert_eq!(converted(text, unit, mm), expected, "{text} in {unit}");
        }
    }
}
