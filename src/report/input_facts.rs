//! The inputs that follow the driver, among the facts of a scene.

use super::check::DriverKind;
use super::number::concise;
use crate::Input;
use crate::scene::{Scene, from_seat};
use crate::wording::words;
use serde::Serialize;

/// An input that follows the driver.
#[derive(Clone, Debug, Serialize)]
pub struct InputFacts {
    /// Whether a link turns or a slide is pushed.
    pub kind: DriverKind,
    /// The link or the slide.
    pub name: String,
    /// The link that its motor sits on, where that is not the ground.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub from: Option<String>,
    /// What its coordinate grows by for 1 of the driver's.
    #[serde(serialize_with = "super::check::unsigned_zero")]
    pub ratio: f64,
    /// Its coordinate where the driver's is 0, in deg or the scene's unit.
    #[serde(serialize_with = "super::check::unsigned_zero")]
    pub phase: f64,
}

impl DriverKind {
    /// What an input drives, with its name.
    pub(super) fn of(scene: &Scene, input: Input) -> (DriverKind, String) {
        let (kind, name) = match input {
            Input::Turn(link) => (DriverKind::Link, scene.link_name(link)),
            Input::Push(slide) => (DriverKind::Slide, scene.slide_name(slide)),
        };
        (kind, name.to_owned())
    }

    /// The same in words.
    pub(super) fn named(self, name: &str) -> String {
        match self {
            DriverKind::Link => words().driven_link(name),
            DriverKind::Slide => words().driven_slide(name),
        }
    }
}

impl InputFacts {
    /// Those of a scene, in the order of the file.
    pub(super) fn of(scene: &Scene) -> Vec<InputFacts> {
        let facts = scene.mechanism.timed().iter().map(|timed| {
            let (kind, name) = DriverKind::of(scene, timed.input);
            InputFacts {
                kind,
                name,
                from: scene.seat_name(timed.input).map(str::to_owned),
                ratio: timed.ratio,
                phase: timed.phase,
            }
        });
        facts.collect()
    }

    /// How it follows a driver.
    pub(super) fn text(&self, driver: DriverKind, length: &str) -> String {
        let unit = |kind| match kind {
            DriverKind::Link => "deg",
            DriverKind::Slide => length,
        };
        let [ratio, phase] = [self.ratio, self.phase].map(|v| concise(v, usize::MAX));
        let (own, drivers) = (unit(self.kind), unit(driver));
        let ratio = if own == drivers {
            ratio
        } else {
            format!("{ratio} {own}/{drivers}")
        };
        let name = from_seat(&self.name, self.from.as_deref());
        let driven = self.kind.named(&name);
        words().input_follows(&driven, &ratio, &format!("{phase} {own}"))
    }
}
