//! Formats the values and facts of the motor.

use super::DIGITS;
use crate::page::{Content, Facts, Rest, Setting, Table, TextRole};
use crate::report::cycle::page::indented;
use crate::report::motor::NOTHING;
use crate::report::text::number::{self, concise, significant};
use crate::study::motor::{
    Cycle, DriveEffort, MAX_FLUCTUATION, MotorDemand, Rule, SMALL_FLUCTUATION,
};
use crate::wording::words;

/// Widths of a label, and of the value after it.
pub(super) const LABEL: usize = 18;
const FIGURE: usize = 10;

/// Returns labelled texts, indented below a heading.
pub(super) fn indented_facts<'l>(
    shown_text: impl IntoIterator<Item = (&'l str, String)>,
) -> Content {
    let shown_text = shown_text.into_iter();
    facts(shown_text.map(|(label, text)| (indented(label), text)))
}

/// Returns labelled texts, indented below a heading; skips missing ones.
pub(super) fn known<'l>(
    shown_text: impl IntoIterator<Item = (&'l str, Option<String>)>,
) -> Content {
    let shown_text = shown_text.into_iter();
    indented_facts(shown_text.filter_map(|(label, text)| Some((label, text?))))
}

/// Formats a travel of the driver, with its duration if known.
pub(super) fn timed(path: String, seconds: Option<f64>) -> String {
    match seconds {
        Some(seconds) => words().in_seconds(&path, &significant(seconds, DIGITS)),
        None => path,
    }
}

/// Returns labelled texts.
pub(super) fn facts(shown_text: impl IntoIterator<Item = (String, String)>) -> Content {
    let mut facts = Facts {
        names: LABEL + 1,
        ..Facts::default()
    };
    for (label, text) in shown_text {
        facts.add(&label, [text]);
    }
    Content::Facts(facts)
}

/// Creates a table whose first columns are the most important: a narrow screen omits the last ones.
pub(super) fn columns_of<'h>(title: String, headers: impl IntoIterator<Item = &'h str>) -> Table {
    Table::new(title, headers).set(Setting {
        names: LABEL,
        least: vec![FIGURE],
        rest: Rest::LeftOut,
        called: TextRole::Label,
        ..Setting::default()
    })
}

/// Returns the mark of a missing value.
pub(super) fn none() -> String {
    "-".into()
}

pub(super) fn figure(value: Option<f64>) -> String {
    value.map_or_else(none, |v| significant(v, DIGITS))
}

/// Formats a value with all digits, without trailing zeros: a speed converted to radians reads as
/// given.
pub(super) fn trimmed(value: f64) -> String {
    number::trimmed(value, DIGITS)
}

/// Returns 0 for rounding errors of values of this magnitude.
pub(super) fn cleaned(value: Option<f64>, size: Option<f64>) -> Option<f64> {
    let size = size.unwrap_or(0.0);
    value.map(|v| if v.abs() <= NOTHING * size { 0.0 } else { v })
}

/// Compares a motor's rating with the demand, and shows the excess or the covered fraction. `scale`
/// converts the values to `unit`.
pub(super) fn verdict(requested: &MotorDemand, scale: f64, unit: &str) -> String {
    let [wants, has, left] = [
        requested.required,
        requested.capacity,
        requested.deficit().abs(),
    ]
    .map(|v| trimmed(v * scale));
    let [has, left] = [has, left].map(|size| format!("{size} {unit}"));
    let share = requested.capacity / requested.required;
    match (requested.is_enough(), share.is_finite()) {
        (true, true) => words().has_left_by_times(&has, &wants, &left, &significant(share, 3)),
        (true, false) => words().has_left(&has, &wants, &left),
        (false, _) => words().has_a_share(&has, &wants, &percent(share)),
    }
}

/// Rounded down, so that less than the whole is never shown as 100 %.
fn percent(share: f64) -> String {
    match share {
        0.1.. => concise((1000.0 * share).floor() / 10.0, 3),
        _ => concise(100.0 * share, 2),
    }
}

/// Returns `true` if the effort is constant up to rounding errors.
pub(super) fn is_constant(effect: &DriveEffort) -> bool {
    let both = effect.largest.zip(effect.least);
    both.is_some_and(|(maximum, minimum)| {
        let size = maximum.value.abs().max(minimum.value.abs());
        maximum.value - minimum.value <= NOTHING * size
    })
}

/// Qualifies the text on a fluctuation: a large one is only approximate, and one beyond the limit
/// is impossible.
pub(super) fn rough(text: String, fluctuation: f64) -> String {
    match fluctuation {
        share if share > MAX_FLUCTUATION => words().impossible(&text),
        share if share > SMALL_FLUCTUATION => words().roughly(&text),
        _ => text,
    }
}

pub(super) fn rule_text(cycle: &Cycle, what: &str) -> String {
    let error = significant(cycle.error, 2);
    match cycle.rule {
        Rule::Periodic(places) => words().trapezoids(&places, &error, what),
        Rule::Pieces(pieces) => words().polynomials(&pieces, &error, what),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn share_below_one_is_shown_below_100_percent() {
        for (share, text) in [
            (0.998, "99.8"),
            (0.9999, "99.9"),
            (0.5, "50"),
            (0.1234, "12.3"),
            (0.0567, "5.7"),
            (0.0, "0"),
        ] {
            assert_eq!(percent(share), text);
        }
    }
}
