//! Reads the preferences of a task, and checks that they are compatible.

use super::{Reader, keys, points};
use crate::Vec2;
use crate::document::{ByteSpan, Diagnostic, WrittenValue};
use crate::scene::KeyTable;
use crate::synthesis::{FunctionTask, GivenNumber, Output, Preferences, Sense, Task, TaskKind};
use crate::wording::words;

const WISHES: &str = "{ transmission = 40 }";
const SENSES: [(&str, Sense); 2] = [
    ("counter-clockwise", Sense::CounterClockwise),
    ("clockwise", Sense::Clockwise),
];

/// The preferences, with the order only if it was given.
pub(super) struct ParsedPreferences {
    wishes: Preferences,
    ordered: Option<bool>,
    /// The places of the direction and of the box.
    direction: Option<ByteSpan>,
    inside: Option<ByteSpan>,
}

pub(super) fn read_preferences(reader: &mut Reader<'_>, file: &KeyTable<'_>) -> ParsedPreferences {
    let mut read = ParsedPreferences {
        wishes: Preferences::default(),
        ordered: None,
        direction: None,
        inside: None,
    };
    let names = ["[wishes]"; 2];
    let value = file.get("wishes");
    let table = value.and_then(|value| reader.open(names, keys::WISHES, WISHES, value));
    let Some(mut table) = table else { return read };
    table.is_root = true;
    let table = &table;
    reader.only_known(table);
    let place = |key: &str| table.get(key).map(WrittenValue::span);
    let mut flag = |key: &str| reader.boolean(&format!("`{key}`"), table.get(key)?);
    read.wishes.full_turn = flag("full-turn").unwrap_or(false);
    read.ordered = flag("order");
    read.wishes.transmission = reader.quantity(table, "transmission");
    read.wishes.ratio = reader.quantity(table, "ratio");
    read.wishes.inside = inside(reader, table);
    read.inside = place("inside");
    read.wishes.sense = direction(reader, table);
    read.direction = place("direction");
    if read.ordered == Some(false) && read.wishes.sense.is_some() {
        let fault = Diagnostic::new(words().direction_wants_order());
        reader.report(fault.at(place("order").unwrap_or_default(), ""));
    }
    read
}

fn inside(reader: &mut Reader<'_>, table: &KeyTable<'_>) -> Option<[Vec2; 2]> {
    let value = table.get("inside")?;
    let corners = points(reader, table, "inside")?;
    let corners: Vec<Vec2> = corners.iter().map(|(at, _)| *at).collect();
    match corners[..] {
        [one, other] if one.x != other.x && one.y != other.y => Some([one, other]),
        _ => {
            reader.report(
                Diagnostic::new(words().inside_is_a_box())
                    .at(value.span(), "")
                    .help(words().for_example("inside = [[-100, -100], [400, 200]]")),
            );
            None
        }
    }
}

fn direction(reader: &mut Reader<'_>, table: &KeyTable<'_>) -> Option<Sense> {
    let name = reader.text_of(table, "direction")?;
    let found = SENSES.iter().find(|(sense, _)| *sense == name.text);
    if found.is_none() {
        let known = SENSES.map(|(sense, _)| sense).join("`, `");
        reader.report(
            Diagnostic::new(words().no_turning_direction(&name.to_string()))
                .at(name.span.clone(), words().not_known_here())
                .help(words().these_are_known(&known)),
        );
    }
    found.map(|(_, sense)| *sense)
}

impl ParsedPreferences {
    /// Returns the preferences for the synthesis; points are visited in order unless the file says
    /// the opposite.
    pub(super) fn for_motion(&self) -> Preferences {
        Preferences {
            ordered: self.ordered.unwrap_or(true),
            ..self.wishes
        }
    }

    /// Reports incompatible preferences.
    pub(super) fn agree_with(&self, reader: &mut Reader<'_>, task: &Task, file: &KeyTable<'_>) {
        let place = |key: &str| file.get(key).map(WrittenValue::span);
        if let Some(corners) = self.wishes.inside {
            let given = points(reader, file, "pivots").unwrap_or_default();
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
                let place = place("turns");
                let rule = words().turns_against_direction();
                self.agrees_with_turning(reader, last.copied(), place, rule);
            }
            TaskKind::Function(function) => {
                let turns = match function.crank_scale {
                    GivenNumber::Value(scale) => Some(scale),
                    GivenNumber::Free => None,
                };
                let place = place("crank");
                let rule = words().crank_against_direction();
                self.agrees_with_turning(reader, turns, place, rule);
                self.check_pivot_box(reader, function);
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
    fn check_pivot_box(&self, reader: &mut Reader<'_>, function: &FunctionTask) {
        let (Some(corners), Some(span)) = (self.wishes.inside, self.inside.clone()) else {
            return;
        };
        let far = match function.output {
            Output::Angle => Some(Vec2::new(function.size, 0.0)),
            Output::Slide => None,
        };
        let mut pivots = std::iter::once(Vec2::ZERO).chain(far);
        if let Some(at) = pivots.find(|at| !crate::synthesis::is_inside(corners, *at)) {
            let text = format!("[{}, {}]", at.x, at.y);
            reader.report(
                Diagnostic::new(words().pivot_of_function_outside(&text))
                    .at(span, "")
                    .help(words().widen_for_function()),
            );
        }
    }
}
