//! Reads slides.

use super::deviations::{self, DraftTolerance};
use super::keys;
use super::reader::{Name, Reader};
use super::table::KeyTable;
use crate::Vec2;
use crate::document::{Diagnostic, Written};
use crate::wording::words;

const SLIDE: &str = r#"r4 = { point = "C", on = "ground", through = "A", angle = 0 }"#;

#[derive(Debug)]
pub(super) struct DraftSlide<'t> {
    pub(super) name: Name<'t>,
    /// `None` here and in the following fields means that a fault was reported.
    pub(super) slider: Option<DraftSlider<'t>>,
    pub(super) on: Option<Name<'t>>,
    pub(super) through: Option<Through<'t>>,
    pub(super) angle: f64,
    /// The tolerance of the coordinates of `through`.
    pub(super) tolerance: Option<DraftTolerance>,
}

#[derive(Debug)]
pub(super) enum DraftSlider<'t> {
    Pin(Name<'t>),
    Link { link: Name<'t>, turn: f64 },
}

#[derive(Debug)]
pub(super) enum Through<'t> {
    Point(Name<'t>),
    At(Vec2),
}

/// Reads the section.
pub(super) fn slides<'v>(reader: &mut Reader<'_>, value: &'v Written<'v>) -> Vec<DraftSlide<'v>> {
    let slides = reader.entries("[slides]", SLIDE, value);
    slides
        .map(|(name, value)| slide(reader, name, value))
        .collect()
}

fn slide<'v>(reader: &mut Reader<'_>, name: Name<'v>, value: &'v Written<'v>) -> DraftSlide<'v> {
    let of = words().slide_called(&name.to_string());
    let mut slide = DraftSlide {
        name,
        slider: None,
        on: None,
        through: None,
        angle: 0.0,
        tolerance: None,
    };
    let Some(mut table) = reader.open([&of, &of], keys::SLIDE, SLIDE, value) else {
        return slide;
    };
    slide.slider = slider(reader, &slide.name, &mut table);
    slide.angle = reader.number_of(&table, "angle").unwrap_or(0.0);
    slide.tolerance = deviations::tolerance_of(reader, &table);
    table.kind = "link";
    let place = &slide.name.span;
    reader.require(&table, "on", place, r#"on = "ground""#);
    reader.require(&table, "through", place, "through = [0, 0]");
    slide.on = reader.text_of(&table, "on");
    slide.through = through(reader, &table);
    slide
}

/// Reads a point of the guide, by name or by coordinates.
fn through<'v>(reader: &mut Reader<'_>, table: &KeyTable<'v>) -> Option<Through<'v>> {
    let value = table.get("through")?;
    if let Some(text) = value.get_ref().as_str() {
        let span = value.span();
        return Some(Through::Point(Name { text, span }));
    }
    reader.pair_of(table, "through").map(Through::At)
}

/// Reads the slider: a pin or a link.
fn slider<'v>(
    reader: &mut Reader<'_>,
    name: &Name<'v>,
    table: &mut KeyTable<'v>,
) -> Option<DraftSlider<'v>> {
    let fault = |message: String, label: &str| {
        Diagnostic::new(message)
            .at(name.span.clone(), label)
            .help(words().pin_or_link())
    };
    match (table.has("point"), table.has("link")) {
        (true, false) => {
            table.kind = "point";
            if let Some(key) = table.key("turn") {
                reader.report(
                    Diagnostic::new(words().pin_has_no_turn(&table.of))
                        .at(key.span, words().for_slide_of_link())
                        .help(words().slide_the_link()),
                );
            } else {
                reader.only_known(table);
            }
            reader.text_of(table, "point").map(DraftSlider::Pin)
        }
        (false, true) => {
            table.kind = "link";
            reader.only_known(table);
            let turn = reader.number_of(table, "turn").unwrap_or(0.0);
            let link = reader.text_of(table, "link")?;
            Some(DraftSlider::Link { link, turn })
        }
        (true, true) => {
            let label = words().one_of_them_slides();
            reader.report(fault(words().has_point_and_link(&table.of), label));
            None
        }
        (false, false) => {
            reader.only_known(table);
            let label = words().nothing_slides_here();
            reader.report(fault(words().has_no_point_nor_link(&table.of), label));
            None
        }
    }
}
