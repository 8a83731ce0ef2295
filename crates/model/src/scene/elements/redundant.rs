//! Reads the accepted misfit of redundant constraints.

use crate::Vec2;
use crate::document::{Diagnostic, WrittenValue};
use crate::scene::elements::points::PlacedPoint;
use crate::scene::keys;
use crate::scene::numbers::reader::{ByteSpan, Reader};
use crate::scene::raw_elements::SceneDraft;
use crate::wording::words;

const EXAMPLE: &str = "{ misfit = 1e-4 }";
/// Maximum accepted misfit relative to the longest length. A larger one cannot be a rounding error.
const MAX_PART: f64 = 0.01;

/// The accepted misfit in the scene's unit, with its place in the text.
#[derive(Debug, Default)]
pub(crate) struct Redundant {
    pub(crate) misfit: f64,
    span: ByteSpan,
}

/// Reads the section.
pub(crate) fn read(reader: &mut Reader<'_>, value: &WrittenValue<'_>) -> Redundant {
    let names = ["[redundant]"; 2];
    let Some(table) = reader.open(names, keys::REDUNDANT, EXAMPLE, value) else {
        return Redundant::default();
    };
    reader.only_known(&table);
    Redundant {
        misfit: reader.number_of(&table, "misfit").unwrap_or(0.0),
        span: table
            .get("misfit")
            .map(WrittenValue::span)
            .unwrap_or_default(),
    }
}

/// Reports a misfit out of proportion, which would accept constraints that contradict each other.
pub(crate) fn check(reader: &mut Reader<'_>, draft: &SceneDraft<'_>) {
    let Redundant { misfit, span } = &draft.redundant;
    let maximum = MAX_PART * longest(draft);
    if *misfit > maximum {
        let literal = reader.literal(span);
        let unit = draft.unit.symbol();
        reader.report(
            Diagnostic::new(words().misfit_too_large(unit, maximum, &literal))
                .at(span.clone(), words().is_too_large())
                .help(words().misfit_is_for_digits()),
        );
    }
}

/// Returns the maximum of the lengths and the distances of points from their frame's origin; for
/// the ground, from its first point.
fn longest(draft: &SceneDraft<'_>) -> f64 {
    let ground = draft.ground.iter().map(PlacedPoint::at);
    let first = draft.ground.first().map_or(Vec2::ZERO, PlacedPoint::at);
    let ground = ground.map(|position| (position - first).norm());
    let ends = draft.links.iter().filter_map(|l| l.ends.as_ref());
    let points = draft.links.iter().flat_map(|l| &l.points);
    let points = points.map(|p| p.at().norm());
    let lengths = ends.map(|e| e.length).chain(points).chain(ground);
    lengths.fold(0.0, f64::max)
}
