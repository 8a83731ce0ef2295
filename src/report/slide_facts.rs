//! Facts on the slides of a scene, with remarks on their sign.

use super::check::{ElementNames, PLACES};
use super::number::{concise, significant};
use crate::solver::{Order, Solver};
use crate::wording::words;
use crate::{Body, SlideId, Slider, angle};
use serde::Serialize;

/// Significant digits of a position in a sentence.
const DIGITS: usize = 6;

/// The kind of slider.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum SliderKind {
    /// A pin in a slot.
    Pin,
    /// A link that does not rotate relative to its guide.
    Link,
}

/// A slide.
#[derive(Clone, Debug, Serialize)]
pub struct SlideFacts {
    /// The name given by the scene.
    pub name: String,
    /// The kind of slider.
    pub kind: SliderKind,
    /// The sliding point or link.
    pub slider: String,
    /// The body that carries the guide.
    pub on: String,
    /// A remark on a slide with a negative position where the scene opens.
    #[serde(skip)]
    pub(super) backwards: Option<String>,
}

impl ElementNames<'_> {
    pub(super) fn slides(&self, solver: &Solver) -> Vec<SlideFacts> {
        let mechanism = &self.scene.mechanism;
        let mut opening = solver.state();
        let _ = solver.solve(mechanism.driver().start, Order::Position, &mut opening);
        let mut bounds = solver.enclosure();
        solver.enclose(&mut opening, Order::Position, &mut bounds);
        let position = |id| {
            let (travel, enclosed) = opening.travel(id).zip(bounds.travel(id))?;
            // Also `false` for a bound of NaN, which determines no sign.
            let is_negative = enclosed.position.mid + enclosed.position.radius < 0.0;
            is_negative.then_some(travel.position)
        };
        let facts = |id| {
            let slide = mechanism.slide(id);
            let (kind, slider) = match slide.slider {
                Slider::Pin(point) => (SliderKind::Pin, self.point(point).unwrap_or_default()),
                Slider::Link { link, .. } => {
                    (SliderKind::Link, self.scene.link_name(link).to_owned())
                }
            };
            SlideFacts {
                name: self.scene.slide_name(id).to_owned(),
                kind,
                slider,
                on: self.body(slide.on),
                backwards: position(id).and_then(|position| self.backwards(id, position)),
            }
        };
        mechanism.slide_ids().map(facts).collect()
    }

    /// Returns the remark on a slide with a negative position, with the guide angle that would make
    /// it positive. Lecture notes give the vector of a slide a positive length. Returns `None` for
    /// a driven slide, since its driver sets the sign.
    fn backwards(&self, id: SlideId, position: f64) -> Option<String> {
        let mechanism = &self.scene.mechanism;
        let is_driven = mechanism.is_pushed(id);
        if is_driven {
            return None;
        }
        let slide = mechanism.slide(id);
        // In the range used for directions in tables.
        let theta = angle::wrapped(slide.angle);
        let other = angle::wrapped(slide.angle + angle::TURN / 2.0);
        Some(words().slide_counts_backwards(
            self.scene.slide_name(id),
            &significant(position, DIGITS),
            self.scene.unit.symbol(),
            [&concise(slide.angle, PLACES), &concise(other, PLACES)],
            (slide.on == Body::Ground).then_some(&concise(theta, PLACES)),
        ))
    }
}

impl SlideFacts {
    /// Returns the text on the slide, and the remark on its sign, if any.
    pub(super) fn texts(&self) -> impl Iterator<Item = String> {
        std::iter::once(self.text()).chain(self.backwards.clone())
    }

    fn text(&self) -> String {
        let on = &words().body_called(&self.on);
        match self.kind {
            SliderKind::Pin => words().pin_in_slot(&self.name, &self.slider, on),
            SliderKind::Link => words().link_along(&self.name, &self.slider, on),
        }
    }
}
