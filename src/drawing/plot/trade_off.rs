//! Builds the chart of a study of methods: time against error, one letter per method.

use crate::drawing::plot::{Chart, Datum, DecadeAxis};
use crate::study::Findings;
use crate::wording::words;

const NANOSECONDS: f64 = 1e9;

/// Returns the chart of a study's findings.
#[must_use]
pub fn trade_off(findings: &Findings) -> Chart {
    let datum = |finding: &crate::study::Finding| {
        let figures = finding.figures()?;
        Some(Datum {
            x: figures.time?.median * NANOSECONDS,
            y: figures.errors?.position,
            letter: finding.key,
            best: finding.best,
        })
    };
    let time = DecadeAxis {
        title: words().time().into(),
        label: time,
    };
    Chart::of_errors(time, findings.methods.iter().filter_map(datum))
}

/// Formats ten to this power of nanoseconds in the largest unit of which it is a whole number.
fn time(power: i32) -> String {
    let (unit, power) = match power {
        ..0 => return format!("1e{power} ns"),
        0..3 => ("ns", power),
        3..6 => ("us", power - 3),
        6..9 => ("ms", power - 6),
        _ => ("s", power - 9),
    };
    format!("1{} {unit}", "0".repeat(power.unsigned_abs() as usize))
}

#[cfg(test)]
mod tests {
    use super::time;

    #[test]
    fn powers_of_ten_are_formatted_in_round_units() {
        let lines: Vec<_> = (0..5).chain([9, 10]).map(time).collect();
        assert_eq!(
            lines,
            ["1 ns", "10 ns", "100 ns", "1 us", "10 us", "1 s", "10 s"]
        );
    }
}
