//! How far constraints that repeat others may be from fitting.

use super::draft::Draft;
use super::reader::{Reader, Value};
use super::{Unit, reader::Span};
use crate::Vec2;
use crate::document::Diagnostic;

const EXAMPLE: &str = "{ misfit = 1e-4 }";
const KEYS: [&str; 1] = ["misfit"];
/// A misfit of more than this part of the longest length is no matter of digits.
const LARGEST_PART: f64 = 0.01;

/// The misfit that is accepted, in the scene's unit, and where it stands.
#[derive(Debug, Default)]
pub(super) struct Redundant {
    pub(super) misfit: f64,
    place: Span,
}

/// The section `[redundant]`.
pub(super) fn read(reader: &mut Reader<'_>, unit: Unit, value: &Value<'_>) -> Redundant {
    let Some(table) = reader.table("[redundant]", EXAMPLE, value) else {
        return Redundant::default();
    };
    reader.only("[redundant]", table, &KEYS);
    let of_unit = format!(" ({})", unit.symbol());
    let misfit = reader.not_negative("[redundant]", table, "misfit", &of_unit);
    let place = table.get("misfit").map(|v| v.span()).unwrap_or_default();
    Redundant { misfit, place }
}

/// Reports a misfit that is out of proportion: it would make a mechanism of what is none.
pub(super) fn check(reader: &mut Reader<'_>, draft: &Draft<'_>) {
    let Redundant { misfit, place } = &draft.redundant;
    let most = LARGEST_PART * longest(draft);
    if *misfit > most {
        let literal = reader.literal(place);
        let unit = draft.unit.symbol();
        reader.report(
            Diagnostic::new(format!(
                "`misfit` of [redundant] ({unit}) must be at most a hundredth of the longest length, \
                 {most} here, not {literal}"
            ))
            .at(place.clone(), "too large")
            .help("it is for the digits that a drawing leaves out, not for parts that do not fit"),
        );
    }
}

/// The longest distance of two points of a link, or of a point of the ground from the first one.
fn longest(draft: &Draft<'_>) -> f64 {
    let ground = draft.ground.iter().map(super::draft::Place::at);
    let first = draft
        .ground
        .first()
        .map_or(Vec2::ZERO, super::draft::Place::at);
    let ground = ground.map(|place| (place - first).norm());
    let ends = draft.links.iter().filter_map(|l| l.ends.as_ref());
    let points = draft.links.iter().flat_map(|l| &l.points);
    let points = points.map(|p| p.at().norm());
    let lengths = ends.map(|e| e.length).chain(points).chain(ground);
    lengths.fold(0.0, f64::max)
}
