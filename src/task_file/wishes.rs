//! Reads the preferences of a task, and checks that they are compatible.

use super::{Reader, RowList, WrittenTask, measured, named, points};
use crate::Vec2;
use crate::document::{ByteSpan, Diagnostic, Lenient};
use crate::expression::Dimension;
use crate::synthesis::{FunctionTask, Given, Output, Preferences, Sense, Task, TaskKind};
use crate::wording::words;
use serde::Deserialize;

/// The preferences as written.
#[derive(Debug, Deserialize)]
pub(super) struct WrittenWishes {
    #[serde(rename = "full-turn")]
    full_turn: Option<Lenient<bool>>,
    transmission: Option<Lenient<f64>>,
    inside: Option<RowList>,
    ratio: Option<Lenient<f64>>,
    order: Option<Lenient<bool>>,
    direction: Option<Lenient<String>>,
}

const WISHES: &str = "{ transmission = 40 }";
const SENSES: [(&str, Sense); 2] = [
    ("counter-clockwise", Sense::CounterClockwise),
    ("clockwise", Sense::Clockwise),
];

/// The preferences, with the order only if it was given.
pub(super) struct ReadWishes {
    wishes: Preferences,
    ordered: Option<bool>,
    /// The places of the direction and of the box.
    direction: Option<ByteSpan>,
    inside: Option<ByteSpan>,
}

pub(super) fn wishes(
    reader: &mut Reader<'_>,
    value: Option<&Lenient<WrittenWishes>>,
) -> ReadWishes {
    let mut read = ReadWishes {
        wishes: Preferences::default(),
        ordered: None,
        direction: None,
        inside: None,
    };
    let Some(value) = value else { return read };
    let Some(table) = reader.table("[wishes]", WISHES, value) else {
        return read;
    };
    reader.only("[wishes]", value);
    let full = table.full_turn.as_ref();
    read.wishes.full_turn = full
        .and_then(|value| reader.boolean("`full-turn`", value))
        .unwrap_or(false);
    let order = table.order.as_ref();
    read.ordered = order.and_then(|value| reader.boolean("`order`", value));
    let transmission = table.transmission.as_ref();
    read.wishes.transmission = transmission.and_then(|value| {
        let is_angle = |angle: f64| (0.0..90.0).contains(&angle);
        within(
            reader,
            "transmission",
            (value, Dimension::DEGREES),
            is_angle,
            words().angle_below_90(),
        )
    });
    let ratio = table.ratio.as_ref();
    read.wishes.ratio = ratio.and_then(|value| {
        within(
            reader,
            "ratio",
            (value, Dimension::NUMBER),
            |ratio| ratio >= 1.0,
            words().at_least_1(),
        )
    });
    read.wishes.inside = table
        .inside
        .as_ref()
        .and_then(|value| inside(reader, value));
    read.inside = table.inside.as_ref().map(|value| value.span.clone());
    read.wishes.sense = table
        .direction
        .as_ref()
        .and_then(|value| direction(reader, value));
    read.direction = table.direction.as_ref().map(|value| value.span.clone());
    if read.ordered == Some(false) && read.wishes.sense.is_some() {
        let place = table.order.as_ref().map(|value| value.span.clone());
        let fault = Diagnostic::new(words().direction_wants_order());
        reader.report(fault.at(place.unwrap_or_default(), ""));
    }
    read
}

fn within(
    reader: &mut Reader<'_>,
    key: &str,
    (value, measure): (&Lenient<f64>, Dimension),
    fits: impl Fn(f64) -> bool,
    rule: &str,
) -> Option<f64> {
    let what = format!("`{key}`");
    let number = measured(reader, &what, value, Some(measure))?;
    if fits(number) {
        return Some(number);
    }
    let literal = reader.literal(&value.span);
    reader.report(
        Diagnostic::new(words().must_be(&what, rule, &literal))
            .at(value.span.clone(), words().expected(rule)),
    );
    None
}

fn inside(reader: &mut Reader<'_>, value: &RowList) -> Option<[Vec2; 2]> {
    let corners = points(reader, "inside", Some(value))?;
    let corners: Vec<Vec2> = corners.iter().map(|(at, _)| *at).collect();
    match corners[..] {
        [one, other] if one.x != other.x && one.y != other.y => Some([one, other]),
        _ => {
            reader.report(
                Diagnostic::new(words().inside_is_a_box())
                    .at(value.span.clone(), "")
                    .help(words().for_example("inside = [[-100, -100], [400, 200]]")),
            );
            None
        }
    }
}

fn direction(reader: &mut Reader<'_>, value: &Lenient<String>) -> Option<Sense> {
    let name = reader.string("`direction`", value)?;
    let found = SENSES.iter().find(|(sense, _)| *sense == name.text);
    if found.is_none() {
        let known = SENSES.map(|(sense, _)| sense).join("`, `");
        reader.report(
            Diagnostic::new(words().no_turning_direction(&named(name.text, &name.span)))
                .at(name.span.clone(), words().not_known_here())
                .help(words().these_are_known(&known)),
        );
    }
    found.map(|(_, sense)| *sense)
}

impl ReadWishes {
    /// Returns the preferences for the synthesis; points are visited in order unless the file says
    /// the opposite.
    pub(super) fn for_motion(&self) -> Preferences {
        Preferences {
            ordered: self.ordered.unwrap_or(true),
            ..self.wishes
        }
    }

    /// Reports incompatible preferences.
    pub(super) fn agree_with(&self, reader: &mut Reader<'_>, task: &Task, file: &WrittenTask) {
        if let (Some(corners), Some(written)) = (self.wishes.inside, &file.pivots) {
            let given = points(reader, "pivots", Some(written)).unwrap_or_default();
            for (at, place) in given {
                if !crate::synthesis::is_inside(corners, at) {
                    reader.report(
                        Diagnostic::new(words().given_pivot_outside())
                            .at(place, words().outside_the_box())
                            .help(words().widen_the_box()),
                    );
                }
            }
        }
        match &task.kind {
            TaskKind::Poses(_) => {}
            TaskKind::Path(path) => {
                let last = path.turns.as_ref().and_then(|turns| turns.last());
                let place = file.turns.as_ref().map(|turns| turns.span.clone());
                let rule = words().turns_against_direction();
                self.agrees_with_turning(reader, last.copied(), place, rule);
            }
            TaskKind::Function(function) => {
                let turns = match function.crank_scale {
                    Given::Value(scale) => Some(scale),
                    Given::Free => None,
                };
                let place = file.crank.as_ref().map(|crank| crank.span.clone());
                let rule = words().crank_against_direction();
                self.agrees_with_turning(reader, turns, place, rule);
                self.holds_pivots(reader, function);
            }
        }
    }

    /// Reports a direction that contradicts the given turns of the crank. Without a place for
    /// these, the fault is reported at the direction.
    fn agrees_with_turning(
        &self,
        reader: &mut Reader<'_>,
        turns: Option<f64>,
        place: Option<ByteSpan>,
        rule: &str,
    ) {
        let (Some(turns), Some(sense)) = (turns, self.wishes.sense) else {
            return;
        };
        let given = match turns > 0.0 {
            true => Sense::CounterClockwise,
            false => Sense::Clockwise,
        };
        if given == sense {
            return;
        }
        let fault = Diagnostic::new(rule);
        reader.report(match (place, self.direction.clone()) {
            (Some(place), Some(direction)) => fault.at(place, "").and(direction, ""),
            (place, direction) => fault.at(place.or(direction).unwrap_or_default(), ""),
        });
    }

    /// Reports a box that does not contain the pivots of a function.
    fn holds_pivots(&self, reader: &mut Reader<'_>, function: &FunctionTask) {
        let (Some(corners), Some(place)) = (self.wishes.inside, self.inside.clone()) else {
            return;
        };
        let far = match function.output {
            Output::Angle => Some(Vec2::new(function.size, 0.0)),
            Output::Slide => None,
        };
        let mut pivots = std::iter::once(Vec2::ZERO).chain(far);
        if let Some(at) = pivots.find(|at| !crate::synthesis::is_inside(corners, *at)) {
            let told = format!("[{}, {}]", at.x, at.y);
            reader.report(
                Diagnostic::new(words().pivot_of_function_outside(&told))
                    .at(place, "")
                    .help(words().widen_for_function()),
            );
        }
    }
}
