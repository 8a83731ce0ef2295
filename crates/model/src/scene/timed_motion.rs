//! Reads the driver's motion over time, step by step.

use super::limits::DraftEnds;
use super::profile::{self, Knots};
use super::reader::{ByteSpan, Reader};
use crate::document::{Diagnostic, Lenient};
use crate::nearest::did_you_mean;
use crate::wording::words;
use crate::{ClampedSpline, MotionLaw, StepLaw, TimedStep};
use serde::Deserialize;

/// The list `motion` as written.
pub(super) type MotionList = Lenient<Vec<Lenient<StepTable>>>;

/// A step of a motion as written.
#[derive(Debug, Deserialize)]
pub(super) struct StepTable {
    law: Option<Lenient<String>>,
    to: Option<Lenient<f64>>,
    time: Option<Lenient<f64>>,
    ramp: Option<Lenient<f64>>,
    knots: Option<Knots>,
    dwell: Option<Lenient<f64>>,
}

const STEP: &str = r#"{ law = "cycloidal", to = 120, time = 0.5 }"#;
const LAWS: [&str; 5] = ["constant", "harmonic", "cycloidal", "trapezoid", "table"];
/// The default fraction of a trapezoid's time during which its speed increases.
const RAMP: f64 = 1.0 / 3.0;

/// The start and range of a motion.
pub(super) struct MotionFrame<'r> {
    pub(super) start: f64,
    /// Whether a link is turned: its motion may end whole turns away from the start.
    pub(super) turns: bool,
    pub(super) range: Option<&'r DraftEnds>,
}

/// Reads the list; reports faults and returns `None` for them.
pub(super) fn read(
    reader: &mut Reader<'_>,
    frame: &MotionFrame<'_>,
    value: &MotionList,
) -> Option<MotionLaw> {
    let what = words().key_of("motion", words().the_driver());
    let (wanted, example) = (words().a_list_of_steps(), format!("motion = [{STEP}, ...]"));
    let fault = match &value.read {
        Ok(items) if !items.is_empty() => return steps(reader, frame, items, &value.span),
        Ok(_) => Diagnostic::new(words().must_be_but_is_empty(&what, wanted))
            .at(value.span.clone(), words().no_steps()),
        Err(found) => reader.wrong_type(&what, wanted, found, &value.span),
    };
    reader.report(fault.help(words().for_example(&example)));
    None
}

fn steps(
    reader: &mut Reader<'_>,
    frame: &MotionFrame<'_>,
    items: &[Lenient<StepTable>],
    place: &ByteSpan,
) -> Option<MotionLaw> {
    let mut steps = Vec::with_capacity(items.len());
    let mut from = Some(frame.start);
    for (number, item) in items.iter().enumerate() {
        let step = step(reader, number + 1, from, item);
        from = step.as_ref().map(TimedStep::to);
        stays_in_range(reader, frame, number + 1, from, item);
        steps.push(step);
    }
    let steps: Option<Vec<TimedStep>> = steps.into_iter().collect();
    let (law, end) = (MotionLaw::new(frame.start, steps?, frame.turns), from?);
    if law.is_none() {
        let help = match frame.turns {
            true => words().motion_of_link_closes(),
            false => words().motion_of_slide_closes(),
        };
        reader.report(
            Diagnostic::new(words().motion_does_not_close(frame.start, end))
                .at(place.clone(), words().ends_elsewhere())
                .help(help),
        );
    }
    law
}

/// Reports a step that ends outside the driver's range.
fn stays_in_range(
    reader: &mut Reader<'_>,
    frame: &MotionFrame<'_>,
    number: usize,
    to: Option<f64>,
    item: &Lenient<StepTable>,
) {
    let (Some(range), Some(to)) = (frame.range, to) else {
        return;
    };
    if !(range.low..=range.high).contains(&to) {
        reader.report(
            Diagnostic::new(words().step_leaves_range(number, to, range.low, range.high))
                .at(item.span.clone(), words().beyond_a_stop())
                .and(range.place.clone(), words().the_stops()),
        );
    }
}

fn step(
    reader: &mut Reader<'_>,
    number: usize,
    from: Option<f64>,
    value: &Lenient<StepTable>,
) -> Option<TimedStep> {
    let of = words().step_of_motion(number);
    let table = reader.table(&of, STEP, value)?;
    reader.only(&of, value);
    let law = match (&table.law, &table.dwell) {
        (Some(law), None) => law_of(reader, &of, law)?,
        (None, Some(time)) => {
            foreign(reader, &of, value, &["dwell"]);
            let time = positive(reader, &of, "dwell", time)?;
            let (law, to) = (StepLaw::Constant, from?);
            return Some(TimedStep::Law { law, to, time });
        }
        (law, _) => {
            // A misspelt key was already reported.
            if law.is_some() || !(value.meant("law") || value.meant("dwell")) {
                reader.report(
                    Diagnostic::new(words().step_has_one_of(&of, "law", "dwell"))
                        .at(value.span.clone(), words().how_does_it_move())
                        .help(words().for_example(&format!("{STEP}, {{ dwell = 0.2 }}"))),
                );
            }
            return None;
        }
    };
    match law {
        "table" => {
            foreign(reader, &of, value, &["law", "knots"]);
            through_knots(reader, &of, from, value, table)
        }
        "trapezoid" => {
            foreign(reader, &of, value, &["law", "to", "time", "ramp"]);
            let ramp = match &table.ramp {
                Some(ramp) => part(reader, &of, ramp)?,
                None => RAMP,
            };
            by_law(reader, &of, value, table, StepLaw::Trapezoid { ramp })
        }
        plain => {
            foreign(reader, &of, value, &["law", "to", "time"]);
            let law = match plain {
                "harmonic" => StepLaw::Harmonic,
                "cycloidal" => StepLaw::Cycloidal,
                _ => StepLaw::Constant,
            };
            by_law(reader, &of, value, table, law)
        }
    }
}

/// Reads the name of a law.
fn law_of<'v>(reader: &mut Reader<'_>, of: &str, value: &'v Lenient<String>) -> Option<&'v str> {
    let name = reader.string(&words().key_of("law", of), value)?;
    if LAWS.contains(&name.text) {
        return Some(name.text);
    }
    reader.report(
        Diagnostic::new(words().no_law_of_motion(of, &name.to_string()))
            .at(name.span.clone(), words().unknown_law())
            .maybe_help(did_you_mean(name.text, LAWS))
            .help(words().known_laws(&format!("`{}`", LAWS.join("`, `")))),
    );
    None
}

fn by_law(
    reader: &mut Reader<'_>,
    of: &str,
    value: &Lenient<StepTable>,
    table: &StepTable,
    law: StepLaw,
) -> Option<TimedStep> {
    for (key, is_given) in [("to", table.to.is_some()), ("time", table.time.is_some())] {
        lacks(reader, of, value, key, is_given, STEP);
    }
    let to = table.to.as_ref();
    let to = to.and_then(|to| reader.number(&words().key_of("to", of), to));
    let time = positive(reader, of, "time", table.time.as_ref()?)?;
    Some(TimedStep::Law { law, to: to?, time })
}

const KNOTS: &str = r#"{ law = "table", knots = [[0, 0], [0.2, 40], [0.5, 120]] }"#;

fn through_knots(
    reader: &mut Reader<'_>,
    of: &str,
    from: Option<f64>,
    value: &Lenient<StepTable>,
    table: &StepTable,
) -> Option<TimedStep> {
    lacks(reader, of, value, "knots", table.knots.is_some(), KNOTS);
    let given = table.knots.as_ref()?;
    let knots = profile::over_time(reader, &words().key_of("knots", of), KNOTS, given)?;
    let begins = [0.0, from?];
    if knots.first() != Some(&begins) {
        let literal = format!("[0, {}]", begins[1]);
        reader.report(
            Diagnostic::new(words().table_begins_elsewhere(of, &literal))
                .at(given.span.clone(), words().the_first_knot_is(&literal))
                .help(words().table_goes_on()),
        );
        return None;
    }
    ClampedSpline::new(knots).map(TimedStep::Table)
}

/// Reports a missing key.
fn lacks(
    reader: &mut Reader<'_>,
    of: &str,
    value: &Lenient<StepTable>,
    key: &str,
    is_given: bool,
    example: &str,
) {
    if !is_given && !value.meant(key) {
        reader.report(
            Diagnostic::new(words().of_has_no(of, key))
                .at(value.span.clone(), words().is_missing(key))
                .help(words().for_example(example)),
        );
    }
}

/// Reports keys that belong to another kind of step.
fn foreign(reader: &mut Reader<'_>, of: &str, value: &Lenient<StepTable>, fitting: &[&str]) {
    for key in &value.keys {
        let text = key.get_ref().as_str();
        if fitting.contains(&text) || !value.known.contains(&text) {
            continue;
        }
        reader.report(
            Diagnostic::new(words().step_has_no_key(of, text))
                .at(key.span(), words().not_for_this_step())
                .help(words().keys_of_step(&format!("`{}`", fitting.join("`, `")))),
        );
    }
}

fn positive(reader: &mut Reader<'_>, of: &str, key: &str, value: &Lenient<f64>) -> Option<f64> {
    let what = words().key_of(key, of) + " (s)";
    let number = reader.number(&what, value)?;
    within(
        reader,
        &what,
        (number, value),
        number > 0.0,
        words().positive(),
    )
}

fn part(reader: &mut Reader<'_>, of: &str, value: &Lenient<f64>) -> Option<f64> {
    let what = words().key_of("ramp", of);
    let number = reader.number(&what, value)?;
    let is_part = number > 0.0 && number <= 0.5;
    within(
        reader,
        &what,
        (number, value),
        is_part,
        words().at_most_a_half(),
    )
}

/// Returns the number if it satisfies a rule, or else reports it.
fn within(
    reader: &mut Reader<'_>,
    what: &str,
    (number, value): (f64, &Lenient<f64>),
    keeps: bool,
    rule: &str,
) -> Option<f64> {
    if keeps {
        return Some(number);
    }
    let literal = reader.literal(&value.span);
    reader.report(
        Diagnostic::new(words().must_be(what, rule, &literal))
            .at(value.span.clone(), words().expected(rule)),
    );
    None
}

/// Reports a key that contradicts a motion, which already determines the speed.
pub(super) fn alone(reader: &mut Reader<'_>, key: &str, place: &ByteSpan) {
    reader.report(
        Diagnostic::new(words().motion_beside(key))
            .at(place.clone(), words().the_motion_says())
            .help(words().leave_out_beside_motion(key)),
    );
}
