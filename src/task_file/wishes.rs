//! What would be liked beside the motion, and whether it can be had.

use super::{Reader, RowList, named, points, rows};
use crate::Vec2;
use crate::document::{Diagnostic, Lenient};
use crate::synthesis::{Sense, Task, TaskKind, Wishes};
use crate::wording::words;
use serde::Deserialize;

/// The wishes as they are written.
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

/// Wishes, and whether the order was told.
pub(super) struct ReadWishes {
    wishes: Wishes,
    ordered: Option<bool>,
}

pub(super) fn wishes(
    reader: &mut Reader<'_>,
    value: Option<&Lenient<WrittenWishes>>,
) -> ReadWishes {
    let mut read = ReadWishes {
        wishes: Wishes::default(),
        ordered: None,
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
            value,
            is_angle,
            words().angle_below_90(),
        )
    });
    let ratio = table.ratio.as_ref();
    read.wishes.ratio = ratio.and_then(|value| {
        within(
            reader,
            "ratio",
            value,
            |ratio| ratio >= 1.0,
            words().at_least_1(),
        )
    });
    read.wishes.inside = table
        .inside
        .as_ref()
        .and_then(|value| inside(reader, value));
    read.wishes.sense = table
        .direction
        .as_ref()
        .and_then(|value| direction(reader, value));
    read
}

fn within(
    reader: &mut Reader<'_>,
    key: &str,
    value: &Lenient<f64>,
    fits: impl Fn(f64) -> bool,
    rule: &str,
) -> Option<f64> {
    let what = format!("`{key}`");
    let number = reader.number(&what, value)?;
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
    let corners = rows::<2>(reader, "inside", ("[x, y]", "[0, 0]"), value)?;
    let corners: Vec<Vec2> = corners
        .iter()
        .map(|([x, y], _)| Vec2::new(*x, *y))
        .collect();
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
                .at(name.span.clone(), words().unknown_key_here())
                .help(words().known_keys(&format!("`{known}`"))),
        );
    }
    found.map(|(_, sense)| *sense)
}

impl ReadWishes {
    /// Poses and paths are come through in their order where nothing else is said.
    pub(super) fn for_motion(&self, kind: &str) -> Wishes {
        Wishes {
            ordered: self.ordered.unwrap_or(kind != "function"),
            ..self.wishes
        }
    }

    /// Reports what cannot be had together.
    pub(super) fn agree_with(
        &self,
        reader: &mut Reader<'_>,
        task: &Task,
        pivots: Option<&RowList>,
    ) {
        if let (Some(corners), Some(written)) = (self.wishes.inside, pivots) {
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
        let TaskKind::Path(path) = &task.kind else {
            return;
        };
        let last = path.turns.as_ref().and_then(|turns| turns.last());
        if let (Some(last), Some(sense)) = (last, self.wishes.sense) {
            let turns = match *last > 0.0 {
                true => Sense::CounterClockwise,
                false => Sense::Clockwise,
            };
            if turns != sense {
                reader.report(Diagnostic::new(words().turns_against_direction()));
            }
        }
    }
}
