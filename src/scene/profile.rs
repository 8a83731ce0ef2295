//! Reads values over a coordinate, as lists of knots `[coordinate, value]`.

use super::reader::{ByteSpan, CoordinatePair, Reader};
use crate::Profile;
use crate::document::{Diagnostic, Lenient};

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
    let what = "`over` of the load";
    let knots = knots(reader, what, "[coordinate, factor]", OVER, value)?;
    if knots.len() < 2 {
        reader.report(
            Diagnostic::new(format!("{what} has one knot: the factor never changes"))
                .at(value.span.clone(), "at least two knots are needed")
                .help("put a constant factor into the force or the torque itself"),
        );
        return None;
    }
    ordered(reader, what, &knots, true)?;
    profile(knots)
}

/// The force of a press over the distance before the end of its stroke, in the order in which the
/// file has it: towards the end, or away from it.
pub(super) fn press(reader: &mut Reader<'_>, value: &Knots) -> Option<Profile> {
    let what = "`press` of the load";
    let mut knots = knots(reader, what, "[distance, force]", PRESS, value)?;
    for knot in &knots {
        let (fault, place, help) = if knot.at < 0.0 {
            let help = "distances are counted from the end of the stroke: 0 is the end itself";
            ("a distance", &knot.at_place, help)
        } else if knot.value < 0.0 {
            let help = "the force of a press is against its motion; what helps it is a `force`";
            ("a force", &knot.value_place, help)
        } else {
            continue;
        };
        let literal = reader.literal(place);
        reader.report(
            Diagnostic::new(format!(
                "{what}: {fault} must not be negative, but is {literal}"
            ))
            .at(place.clone(), "negative")
            .help(help),
        );
        return None;
    }
    let grows = matches!(&knots[..], [first, second, ..] if first.at < second.at);
    ordered(reader, what, &knots, grows)?;
    if !grows {
        knots.reverse();
    }
    profile(knots)
}

/// A list of at least one knot.
fn knots(
    reader: &mut Reader<'_>,
    what: &str,
    form: &str,
    example: &str,
    value: &Knots,
) -> Option<Vec<Knot>> {
    let wanted = format!("a list of knots {form}");
    let fault = match &value.read {
        Ok(items) if items.is_empty() => {
            let message = format!("{what} must be {wanted}, but is empty");
            Diagnostic::new(message).at(value.span.clone(), "no knots")
        }
        Ok(items) => return each(reader, what, form, example, items),
        Err(found) => reader.wrong_type(what, &wanted, found, &value.span),
    };
    reader.report(fault.help(format!("for example: {example}")));
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
        let what = format!("knot {} in {what}", i + 1);
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
    let (verb, steep) = if grows {
        ("grow", "further on")
    } else {
        ("fall", "nearer")
    };
    reader.report(
        Diagnostic::new(format!(
            "{what}: the coordinates must {verb} from knot to knot, but {second} follows {first}"
        ))
        .at(after.at_place.clone(), format!("does not {verb}"))
        .and(before.at_place.clone(), "the knot before")
        .help(format!(
            "put the knots in order; for a jump let the second knot lie a little {steep}"
        )),
    );
    None
}

/// The profile of knots in order, made to grow; they are finite, as every number of a scene is.
fn profile(knots: Vec<Knot>) -> Option<Profile> {
    Profile::new(knots.iter().map(|knot| [knot.at, knot.value]).collect())
}
