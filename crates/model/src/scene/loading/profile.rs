//! Reads functions of a coordinate, given as lists of knots `[coordinate, value]`.

use crate::Profile;
use crate::document::{Diagnostic, WrittenValue, items};
use crate::scene::numbers::reader::{ByteSpan, Reader};
use crate::scene::table::KeyTable;
use crate::wording::words;

const OVER: &str = "over = [[0, 0.2], [15, 1], [180, 0]]";
const GAS: &str = "force = [[200, 900], [300, 700]]";
const PRESS: &str = "press = [[12, 0], [4, 200e3], [0, 350e3]]";

/// A knot with the places of its two numbers.
struct Knot {
    at: f64,
    value: f64,
    at_place: ByteSpan,
    value_place: ByteSpan,
}

/// Reads the factor of a load over the driver's coordinate; without a list it is 1 everywhere.
pub(crate) fn over(reader: &mut Reader<'_>, table: &KeyTable<'_>) -> Option<Profile> {
    let Some(value) = table.get("over") else {
        return Some(Profile::default());
    };
    let what = &table.what(reader, "over");
    let knots = knots(reader, what, words().coordinate_and_factor(), OVER, value)?;
    if knots.len() < 2 {
        reader.report(
            Diagnostic::new(words().factor_never_changes(what))
                .at(value.span(), words().two_knots_are_needed())
                .help(words().put_factor_into_size()),
        );
        return None;
    }
    ordered(reader, what, &knots, true)?;
    profile(knots)
}

/// Reads the force of a press over the distance from the end of its stroke, in ascending or
/// descending order of distance.
pub(crate) fn press(reader: &mut Reader<'_>, table: &KeyTable<'_>) -> Option<Profile> {
    let what = &table.what(reader, "press");
    let form = words().distance_and_force();
    let knots = knots(reader, what, form, PRESS, table.get("press")?)?;
    let pulling = |knot| before_end(reader, what, knot).or_else(|| helping(reader, what, knot));
    if let Some(fault) = knots.iter().find_map(pulling) {
        reader.report(fault);
        return None;
    }
    either_way(reader, what, knots)
}

/// Reads the force of a gas spring over its length, in ascending or descending order of length.
pub(crate) fn gas(reader: &mut Reader<'_>, table: &KeyTable<'_>) -> Option<Profile> {
    let what = &table.what(reader, "force");
    let knots = knots(
        reader,
        what,
        words().length_and_force(),
        GAS,
        table.get("force")?,
    )?;
    if let Some(fault) = knots.iter().find_map(|knot| shorter(reader, what, knot)) {
        reader.report(fault);
        return None;
    }
    either_way(reader, what, knots)
}

/// Reads knots of time and coordinate, with strictly increasing times.
pub(crate) fn over_time(
    reader: &mut Reader<'_>,
    what: &str,
    example: &str,
    value: &WrittenValue<'_>,
) -> Option<Vec<[f64; 2]>> {
    let words = words();
    let sentences = CurveSentences {
        form: words.time_and_coordinate(),
        not_increasing: &|what, first, second| words.times_must_grow(what, first, second),
    };
    curve(reader, what, example, value, &sentences)
}

/// Reads knots of the driver's coordinate and that of an input, with strictly increasing driver
/// coordinates.
pub(crate) fn over_driver(
    reader: &mut Reader<'_>,
    what: &str,
    example: &str,
    value: &WrittenValue<'_>,
) -> Option<Vec<[f64; 2]>> {
    let words = words();
    let sentences = CurveSentences {
        form: words.driver_and_input(),
        not_increasing: &|what, first, second| words.places_must_grow(what, first, second),
    };
    curve(reader, what, example, value, &sentences)
}

/// The texts of messages on a curve.
struct CurveSentences<'w> {
    /// The form of a knot.
    form: &'w str,
    /// Returns the message that two knots do not increase, from the curve's name and their
    /// literals.
    not_increasing: &'w dyn Fn(&str, &str, &str) -> String,
}

/// Reads at least two knots with strictly increasing coordinates.
fn curve(
    reader: &mut Reader<'_>,
    what: &str,
    example: &str,
    value: &WrittenValue<'_>,
    sentences: &CurveSentences<'_>,
) -> Option<Vec<[f64; 2]>> {
    let knots = knots(reader, what, sentences.form, example, value)?;
    let grows = |pair: &[Knot]| pair[0].at < pair[1].at;
    if let Some(pair) = knots.windows(2).find(|pair| !grows(pair)) {
        let [first, second] = [&pair[0], &pair[1]].map(|knot| reader.literal(&knot.at_place));
        reader.report(
            Diagnostic::new((sentences.not_increasing)(what, &first, &second))
                .at(pair[1].at_place.clone(), words().does_not_grow())
                .and(pair[0].at_place.clone(), words().the_knot_before()),
        );
        return None;
    }
    if knots.len() < 2 {
        reader.report(
            Diagnostic::new(words().table_of_one_knot(what))
                .at(value.span(), words().two_knots_are_needed())
                .help(words().for_example(example)),
        );
        return None;
    }
    Some(knots.iter().map(|knot| [knot.at, knot.value]).collect())
}

/// Checks and sorts knots in ascending or descending order; the first two distinct ones decide
/// which. Returns `None` for a reported fault.
fn either_way(reader: &mut Reader<'_>, what: &str, mut knots: Vec<Knot>) -> Option<Profile> {
    let differs = knots.windows(2).find(|pair| pair[0].at != pair[1].at);
    let grows = differs.is_some_and(|pair| pair[0].at < pair[1].at);
    ordered(reader, what, &knots, grows)?;
    if !grows {
        knots.reverse();
    }
    profile(knots)
}

/// Returns the diagnostic of a knot beyond the end of the stroke; `None` for other knots.
fn before_end(reader: &Reader<'_>, what: &str, knot: &Knot) -> Option<Diagnostic> {
    let message = |literal: &str| words().negative_distance(what, literal);
    negative(
        reader,
        (knot.at, &knot.at_place),
        message,
        words().distances_from_end(),
    )
}

/// Returns the diagnostic of a knot whose force does not oppose the motion; `None` for other knots.
fn helping(reader: &Reader<'_>, what: &str, knot: &Knot) -> Option<Diagnostic> {
    let message = |literal: &str| words().negative_press(what, literal);
    let help = words().press_is_against_motion();
    negative(reader, (knot.value, &knot.value_place), message, help)
}

/// Returns the diagnostic of a knot with a negative length; `None` for other knots.
fn shorter(reader: &Reader<'_>, what: &str, knot: &Knot) -> Option<Diagnostic> {
    let message = |literal: &str| words().negative_length(what, literal);
    negative(
        reader,
        (knot.at, &knot.at_place),
        message,
        words().lengths_of_gas_spring(),
    )
}

/// Returns the diagnostic of a negative number; `None` for other numbers.
fn negative(
    reader: &Reader<'_>,
    (value, span): (f64, &ByteSpan),
    message: impl Fn(&str) -> String,
    help: &'static str,
) -> Option<Diagnostic> {
    let fault = || Diagnostic::new(message(&reader.literal(span)));
    (value < 0.0).then(|| fault().at(span.clone(), words().is_negative()).help(help))
}

/// Reads a list of at least one knot.
fn knots(
    reader: &mut Reader<'_>,
    what: &str,
    form: &str,
    example: &str,
    value: &WrittenValue<'_>,
) -> Option<Vec<Knot>> {
    let wanted = words().a_list_of_knots(form);
    let fault = match items(value) {
        Some([]) => Diagnostic::new(words().must_be_but_is_empty(what, &wanted))
            .at(value.span(), words().no_knots()),
        Some(items) => return each(reader, what, form, example, items),
        None => reader.mistyped(what, &wanted, value),
    };
    reader.report(fault.help(words().for_example(example)));
    None
}

fn each(
    reader: &mut Reader<'_>,
    what: &str,
    form: &str,
    example: &str,
    items: &[WrittenValue<'_>],
) -> Option<Vec<Knot>> {
    let mut knots = Vec::with_capacity(items.len());
    for (i, item) in items.iter().enumerate() {
        let what = words().knot_in(i + 1, what);
        let [at, value] = reader.two(&what, form, example, item)?;
        knots.push(Knot {
            at: reader.number(&what, at)?,
            value: reader.number(&what, value)?,
            at_place: at.span(),
            value_place: value.span(),
        });
    }
    Some(knots)
}

/// Checks the order of knots. Reports the first that reverses it, or else the third at one
/// coordinate, since two there are a jump. Returns `None` for a reported fault.
fn ordered(reader: &mut Reader<'_>, what: &str, knots: &[Knot], grows: bool) -> Option<()> {
    let turns_back = |pair: &[Knot]| {
        let (before, after) = (pair[0].at, pair[1].at);
        if grows {
            before > after
        } else {
            before < after
        }
    };
    let turned = (1..knots.len()).find(|&k| turns_back(&knots[k - 1..=k]));
    let third = (2..knots.len()).find(|&k| knots[k - 2].at == knots[k].at);
    let Some(k) = turned.or(third) else {
        return Some(());
    };
    let (before, after) = (&knots[k - 1], &knots[k]);
    let [first, second] = [before, after].map(|knot| reader.literal(&knot.at_place));
    let (message, label, help) = match (turned, grows) {
        (None, _) => (
            words().three_knots_at_one_place(what, &second),
            words().a_third_knot_there(),
            words().a_jump_has_two_knots(),
        ),
        (Some(_), true) => (
            words().knots_must_grow(what, &first, &second),
            words().does_not_grow(),
            words().order_growing_knots(),
        ),
        (Some(_), false) => (
            words().knots_must_fall(what, &first, &second),
            words().does_not_fall(),
            words().order_falling_knots(),
        ),
    };
    reader.report(
        Diagnostic::new(message)
            .at(after.at_place.clone(), label)
            .and(before.at_place.clone(), words().the_knot_before())
            .help(help),
    );
    None
}

/// Creates a profile from sorted knots. They are finite, as all numbers of a scene are.
fn profile(knots: Vec<Knot>) -> Option<Profile> {
    Profile::new(knots.iter().map(|knot| [knot.at, knot.value]).collect())
}
