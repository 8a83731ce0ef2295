//! Reads values over a coordinate, as lists of knots `[coordinate, value]`.

use super::reader::{ByteSpan, CoordinatePair, Reader};
use crate::Profile;
use crate::document::{Diagnostic, Lenient};
use crate::wording::words;

/// A list of knots as it is written.
pub(super) type Knots = Lenient<Vec<CoordinatePair>>;

const OVER: &str = "over = [[0, 0.2], [15, 1], [180, 0]]";
const PRESS: &str = "press = [[12, 0], [4, 200e3], [0, 350e3]]";

/// A knot with the places of its two numbers.
struct Knot {
    at: f64,
    value: f64,
    at_place: ByteSpan,
    value_place: ByteSpan,
}

/// The factor of a load over the driver's coordinate; 1 everywhere where nothing is given.
pub(super) fn over(reader: &mut Reader<'_>, value: Option<&Knots>) -> Option<Profile> {
    let Some(value) = value else {
        return Some(Profile::default());
    };
    let what = &words().key_of("over", words().the_load());
    let knots = knots(reader, what, words().coordinate_and_factor(), OVER, value)?;
    if knots.len() < 2 {
        reader.report(
            Diagnostic::new(words().factor_never_changes(what))
                .at(value.span.clone(), words().two_knots_are_needed())
                .help(words().put_factor_into_size()),
        );
        return None;
    }
    ordered(reader, what, &knots, true)?;
    profile(knots)
}

/// The force of a press over the distance before the end of its stroke, in the order in which the
/// file has it: towards the end, or away from it.
pub(super) fn press(reader: &mut Reader<'_>, value: &Knots) -> Option<Profile> {
    let what = &words().key_of("press", words().the_load());
    let mut knots = knots(reader, what, words().distance_and_force(), PRESS, value)?;
    if let Some(fault) = knots.iter().find_map(|knot| pulling(reader, what, knot)) {
        reader.report(fault);
        return None;
    }
    let grows = matches!(&knots[..], [first, second, ..] if first.at < second.at);
    ordered(reader, what, &knots, grows)?;
    if !grows {
        knots.reverse();
    }
    profile(knots)
}

/// What is wrong with a knot that lies beyond the end, or whose force is not against the motion.
fn pulling(reader: &Reader<'_>, what: &str, knot: &Knot) -> Option<Diagnostic> {
    let (message, place, help) = if knot.at < 0.0 {
        let literal = reader.literal(&knot.at_place);
        let message = words().negative_distance(what, &literal);
        (message, &knot.at_place, words().distances_from_end())
    } else if knot.value < 0.0 {
        let literal = reader.literal(&knot.value_place);
        let message = words().negative_press(what, &literal);
        (
            message,
            &knot.value_place,
            words().press_is_against_motion(),
        )
    } else {
        return None;
    };
    let fault = Diagnostic::new(message).at(place.clone(), words().is_negative());
    Some(fault.help(help))
}

/// A list of at least one knot.
fn knots(
    reader: &mut Reader<'_>,
    what: &str,
    form: &str,
    example: &str,
    value: &Knots,
) -> Option<Vec<Knot>> {
    let wanted = words().a_list_of_knots(form);
    let fault = match &value.read {
        Ok(items) if items.is_empty() => {
            Diagnostic::new(words().must_be_but_is_empty(what, &wanted))
                .at(value.span.clone(), words().no_knots())
        }
        Ok(items) => return each(reader, what, form, example, items),
        Err(found) => reader.wrong_type(what, &wanted, found, &value.span),
    };
    reader.report(fault.help(words().for_example(example)));
    None
}

fn each(
    reader: &mut Reader<'_>,
    what: &str,
    form: &str,
    example: &str,
    items: &[CoordinatePair],
) -> Option<Vec<Knot>> {
    let mut knots = Vec::with_capacity(items.len());
    for (i, item) in items.iter().enumerate() {
        let what = words().knot_in(i + 1, what);
        let [at, value] = reader.two(&what, form, example, item)?;
        knots.push(Knot {
            at: reader.number(&what, at)?,
            value: reader.number(&what, value)?,
            at_place: at.span.clone(),
            value_place: value.span.clone(),
        });
    }
    Some(knots)
}

/// Reports the first knot that turns back.
fn ordered(reader: &mut Reader<'_>, what: &str, knots: &[Knot], grows: bool) -> Option<()> {
    let goes_on = |pair: &&[Knot]| {
        let (before, after) = (pair[0].at, pair[1].at);
        if grows {
            before < after
        } else {
            before > after
        }
    };
    let Some([before, after]) = knots.windows(2).find(|pair| !goes_on(pair)) else {
        return Some(());
    };
    let [first, second] = [before, after].map(|knot| reader.literal(&knot.at_place));
    let (message, label, help) = if grows {
        let message = words().knots_must_grow(what, &first, &second);
        (
            message,
            words().does_not_grow(),
            words().order_growing_knots(),
        )
    } else {
        let message = words().knots_must_fall(what, &first, &second);
        (
            message,
            words().does_not_fall(),
            words().order_falling_knots(),
        )
    };
    reader.report(
        Diagnostic::new(message)
            .at(after.at_place.clone(), label)
            .and(before.at_place.clone(), words().the_knot_before())
            .help(help),
    );
    None
}

/// The profile of knots in order, made to grow; they are finite, as every number of a scene is.
fn profile(knots: Vec<Knot>) -> Option<Profile> {
    Profile::new(knots.iter().map(|knot| [knot.at, knot.value]).collect())
}
