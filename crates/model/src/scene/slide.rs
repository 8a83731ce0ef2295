//! Reads slides.

use super::deviations::{self, DraftTolerance};
use super::keys;
use super::reader::{CoordinatePair, Name, Reader};
use crate::Vec2;
use crate::document::{Diagnostic, Entries, Lenient, Misplaced, meant};
use crate::wording::words;
use serde::Deserialize;

const SLIDE: &str = r#"r4 = { point = "C", on = "ground", through = "A", angle = 0 }"#;

/// The section `[slides]` as written.
pub(super) type Slides = Lenient<Entries<Lenient<SlideTable>>>;

/// A slide as written.
#[derive(Debug, Deserialize)]
pub(super) struct SlideTable {
    point: Option<Lenient<String>>,
    link: Option<Lenient<String>>,
    on: Option<Lenient<String>>,
    /// Coordinates, or the name of a point.
    through: Option<CoordinatePair>,
    angle: Option<Lenient<f64>>,
    turn: Option<Lenient<f64>>,
    tolerance: Option<Lenient<f64>>,
}

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
pub(super) fn slides<'v>(reader: &mut Reader<'_>, value: &'v Slides) -> Vec<DraftSlide<'v>> {
    reader.table("[slides]", SLIDE, value);
    let read = |(name, value)| slide(reader, name, value);
    value.entries().map(read).collect()
}

fn slide<'v>(
    reader: &mut Reader<'_>,
    name: Name<'v>,
    value: &'v Lenient<SlideTable>,
) -> DraftSlide<'v> {
    let of = words().slide_called(&name.to_string());
    let mut slide = DraftSlide {
        name,
        slider: None,
        on: None,
        through: None,
        angle: 0.0,
        tolerance: None,
    };
    let Some(table) = reader.table(&of, SLIDE, value) else {
        return slide;
    };
    slide.slider = slider(reader, &of, &slide.name, value, table);
    slide.angle = angle(reader, &of, "angle", table.angle.as_ref());
    let tolerance = table.tolerance.as_ref();
    let what = words().key_of("tolerance", &of);
    slide.tolerance = tolerance.and_then(|value| deviations::tolerance(reader, &what, value));
    let mut required = |key: &str, given: bool, example: &str| {
        // A misspelt key was already reported; do not report the missing key as well.
        let misspelt = || meant(&value.keys, &keys::of(keys::SLIDE, "link"), key);
        if !given && !misspelt() {
            reader.report(
                Diagnostic::new(words().of_has_no(&of, key))
                    .at(slide.name.span.clone(), words().is_missing(key))
                    .help(words().for_example(example)),
            );
        }
    };
    required("on", table.on.is_some(), r#"on = "ground""#);
    required("through", table.through.is_some(), "through = [0, 0]");
    slide.on = reader.text_of("on", &of, table.on.as_ref());
    let given = table.through.as_ref();
    slide.through = given.and_then(|given| through(reader, &of, given));
    slide
}

/// Reads a point of the guide, by name or by coordinates.
fn through<'v>(
    reader: &mut Reader<'_>,
    of: &str,
    value: &'v CoordinatePair,
) -> Option<Through<'v>> {
    if let Err(Misplaced::Text(text)) = &value.read {
        let span = value.span.clone();
        return Some(Through::Point(Name { text, span }));
    }
    let at = reader.pair(&words().key_of("through", of), value);
    at.map(Through::At)
}

/// Reads the slider: a pin or a link.
fn slider<'v>(
    reader: &mut Reader<'_>,
    of: &str,
    name: &Name<'v>,
    value: &Lenient<SlideTable>,
    table: &'v SlideTable,
) -> Option<DraftSlider<'v>> {
    let fault = |message: String, label: &str| {
        Diagnostic::new(message)
            .at(name.span.clone(), label)
            .help(words().pin_or_link())
    };
    match (&table.point, &table.link) {
        (Some(point), None) => {
            if let Some(key) = value.key("turn") {
                reader.report(
                    Diagnostic::new(words().pin_has_no_turn(of))
                        .at(key.span(), words().for_slide_of_link())
                        .help(words().slide_the_link()),
                );
            } else {
                reader.only_these(of, &value.keys, &keys::of(keys::SLIDE, "point"));
            }
            let pin = reader.string(&words().key_of("point", of), point)?;
            Some(DraftSlider::Pin(pin))
        }
        (None, Some(link)) => {
            reader.only_these(of, &value.keys, &keys::of(keys::SLIDE, "link"));
            let turn = angle(reader, of, "turn", table.turn.as_ref());
            let link = reader.string(&words().key_of("link", of), link)?;
            Some(DraftSlider::Link { link, turn })
        }
        (Some(_), Some(_)) => {
            reader.report(fault(
                words().has_point_and_link(of),
                words().one_of_them_slides(),
            ));
            None
        }
        (None, None) => {
            reader.only(of, value);
            reader.report(fault(
                words().has_no_point_nor_link(of),
                words().nothing_slides_here(),
            ));
            None
        }
    }
}

/// Reads an angle in degrees; 0 if it is missing.
fn angle(reader: &mut Reader<'_>, of: &str, key: &str, value: Option<&Lenient<f64>>) -> f64 {
    let angle = value.and_then(|v| reader.number(&(words().key_of(key, of) + " (deg)"), v));
    angle.unwrap_or(0.0)
}
