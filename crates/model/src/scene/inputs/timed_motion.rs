//! Reads the driver's motion over time, step by step.

use crate::document::{Diagnostic, WrittenValue, items};
use crate::nearest::did_you_mean;
use crate::scene::elements::limits::DraftEnds;
use crate::scene::keys;
use crate::scene::loading::profile;
use crate::scene::numbers::reader::{ByteSpan, Reader};
use crate::scene::table::KeyTable;
use crate::wording::words;
use crate::{ClampedSpline, MotionLaw, SineStep, StepLaw, TimedStep};

const STEP: &str = r#"{ law = "cycloidal", to = 120, time = 0.5 }"#;
const LAWS: [&str; 6] = [
    "constant",
    "harmonic",
    "cycloidal",
    "trapezoid",
    "table",
    "sine",
];
/// The default fraction of a trapezoid's time during which its speed increases.
const RAMP: f64 = 1.0 / 3.0;

/// The start and range of a motion.
pub(crate) struct MotionFrame<'r> {
    pub(crate) start: f64,
    /// Whether a link is turned: its motion may end whole turns away from the start.
    pub(crate) is_rotary: bool,
    pub(crate) range: Option<&'r DraftEnds>,
}

/// Reads the list; reports faults and returns `None` for them.
pub(crate) fn read(
    reader: &mut Reader<'_>,
    frame: &MotionFrame<'_>,
    what: &str,
    value: &WrittenValue<'_>,
) -> Option<MotionLaw> {
    let (wanted, example) = (words().a_list_of_steps(), format!("motion = [{STEP}, ...]"));
    let fault = match items(value) {
        Some([]) => Diagnostic::new(words().must_be_but_is_empty(what, wanted))
            .at(value.span(), words().no_steps()),
        Some(items) => return steps(reader, frame, items, &value.span()),
        None => reader.mistyped(what, wanted, value),
    };
    reader.report(fault.help(words().for_example(&example)));
    None
}

fn steps(
    reader: &mut Reader<'_>,
    frame: &MotionFrame<'_>,
    items: &[WrittenValue<'_>],
    span: &ByteSpan,
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
    let (law, end) = (MotionLaw::new(frame.start, steps?, frame.is_rotary), from?);
    if law.is_none() {
        let help = match frame.is_rotary {
            true => words().motion_of_link_closes(),
            false => words().motion_of_slide_closes(),
        };
        reader.report(
            Diagnostic::new(words().motion_does_not_close(frame.start, end))
                .at(span.clone(), words().ends_elsewhere())
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
    item: &WrittenValue<'_>,
) {
    let (Some(range), Some(to)) = (frame.range, to) else {
        return;
    };
    if !(range.low..=range.high).contains(&to) {
        reader.report(
            Diagnostic::new(words().step_leaves_range(number, to, range.low, range.high))
                .at(item.span(), words().beyond_a_stop())
                .and(range.span.clone(), words().the_stops()),
        );
    }
}

fn step(
    reader: &mut Reader<'_>,
    number: usize,
    from: Option<f64>,
    value: &WrittenValue<'_>,
) -> Option<TimedStep> {
    let of = words().step_of_motion(number);
    let table = &reader.open([&of, &of], keys::STEP, STEP, value)?;
    reader.only_known(table);
    let law = match (table.has("law"), table.has("dwell")) {
        (true, false) => law_of(reader, table)?,
        (false, true) => {
            foreign(reader, table, "dwell");
            let time = reader.number_of(table, "dwell")?;
            let (law, to) = (StepLaw::Constant, from?);
            return Some(TimedStep::Law { law, to, time });
        }
        (has_law, _) => {
            // A misspelt key was already reported.
            if has_law
                || !(table.is_probable_misspelling("law") || table.is_probable_misspelling("dwell"))
            {
                reader.report(
                    Diagnostic::new(words().step_has_one_of(&of, "law", "dwell"))
                        .at(table.span.clone(), words().how_does_it_move())
                        .help(words().for_example(&format!("{STEP}, {{ dwell = 0.2 }}"))),
                );
            }
            return None;
        }
    };
    foreign(reader, table, law);
    let law = match law {
        "table" => return through_knots(reader, from, table),
        "sine" => return sine(reader, from, table),
        "trapezoid" => StepLaw::Trapezoid {
            ramp: reader.number_or(table, "ramp", RAMP)?,
        },
        "harmonic" => StepLaw::Harmonic,
        "cycloidal" => StepLaw::Cycloidal,
        _ => StepLaw::Constant,
    };
    for key in ["to", "time"] {
        reader.require(table, key, &table.span, STEP);
    }
    let to = reader.number_of(table, "to");
    let time = reader.number_of(table, "time")?;
    Some(TimedStep::Law { law, to: to?, time })
}

const SINE: &str = r#"{ law = "sine", amplitude = 20, time = 4 }"#;

/// Reads one period of a sine, which begins at any phase.
fn sine(reader: &mut Reader<'_>, from: Option<f64>, table: &KeyTable<'_>) -> Option<TimedStep> {
    for key in ["amplitude", "time"] {
        reader.require(table, key, &table.span, SINE);
    }
    let phase = reader.number_or(table, "phase", 0.0);
    let amplitude = reader.number_of(table, "amplitude");
    let time = reader.number_of(table, "time");
    Some(TimedStep::Sine(SineStep {
        from: from?,
        amplitude: amplitude?,
        phase: phase?,
        time: time?,
    }))
}

/// Reads the name of a law.
fn law_of(reader: &mut Reader<'_>, table: &KeyTable<'_>) -> Option<&'static str> {
    let name = reader.text_of(table, "law")?;
    let found = LAWS.into_iter().find(|law| *law == name.text);
    if found.is_none() {
        reader.report(
            Diagnostic::new(words().no_law_of_motion(&table.of, &name.to_string()))
                .at(name.span, words().unknown_law())
                .maybe_help(did_you_mean(name.text, LAWS))
                .help(words().known_laws(&format!("`{}`", LAWS.join("`, `")))),
        );
    }
    found
}

const KNOTS: &str = r#"{ law = "table", knots = [[0, 0], [0.2, 40], [0.5, 120]] }"#;

fn through_knots(
    reader: &mut Reader<'_>,
    from: Option<f64>,
    table: &KeyTable<'_>,
) -> Option<TimedStep> {
    reader.require(table, "knots", &table.span, KNOTS);
    let given = table.get("knots")?;
    let what = table.what(reader, "knots");
    let knots = profile::over_time(reader, &what, KNOTS, given)?;
    let starts = [0.0, from?];
    if knots.first() != Some(&starts) {
        let literal = format!("[0, {}]", starts[1]);
        reader.report(
            Diagnostic::new(words().table_begins_elsewhere(&table.of, &literal))
                .at(given.span(), words().the_first_knot_is(&literal))
                .help(words().table_goes_on()),
        );
        return None;
    }
    ClampedSpline::new(knots).map(TimedStep::Table)
}

/// Reports keys that belong to another kind of step.
fn foreign(reader: &mut Reader<'_>, table: &KeyTable<'_>, kind: &str) {
    for key in table.strays(kind) {
        let fitting = keys::of(keys::STEP, kind).join("`, `");
        reader.report(
            Diagnostic::new(words().step_has_no_key(&table.of, key.text))
                .at(key.span, words().not_for_this_step())
                .help(words().keys_of_step(&format!("`{fitting}`"))),
        );
    }
}

/// Reports a key that contradicts a motion, which already determines the speed.
pub(crate) fn report_redundant_key(reader: &mut Reader<'_>, key: &str, span: &ByteSpan) {
    reader.report(
        Diagnostic::new(words().motion_beside(key))
            .at(span.clone(), words().the_motion_says())
            .help(words().leave_out_beside_motion(key)),
    );
}
