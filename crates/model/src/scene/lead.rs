//! Scenes of several inputs, in which another input than the driver moves.

use super::Scene;
use crate::nearest::did_you_mean;
use crate::wording::words;
use crate::{Input, PointId, Vec2};

impl Scene {
    /// Returns the scene with another input as its driver, which opens in the assembly nearest to
    /// these positions. See [`Mechanism::led_by`](crate::Mechanism::led_by).
    ///
    /// The text stays unchanged: parsing it again returns the scene with its own driver.
    pub(crate) fn led_from(
        &self,
        start: Vec<(PointId, Vec2)>,
        input: Input,
        at: f64,
    ) -> Option<Scene> {
        let mechanism = self.mechanism.led_by(input, at, start)?;
        let limits = self.limits.iter().zip(self.mechanism.limits());
        let limits = limits.filter(|(_, limit)| limit.of.is_of_element());
        Some(Scene {
            limits: limits.map(|(place, _)| place.clone()).collect(),
            mechanism,
            motion: None,
            lead: None,
            motor: None,
            ..self.clone()
        })
    }

    /// Returns the input with the name of its link or slide.
    ///
    /// # Errors
    /// Returns a message for any other name, with a suggestion.
    pub fn input_named(&self, name: &str) -> Result<Input, String> {
        let names: Vec<&str> = self
            .mechanism
            .inputs()
            .map(|i| self.input_name(i))
            .collect();
        let mut inputs = self.mechanism.inputs();
        inputs
            .find(|&input| self.input_name(input) == name)
            .ok_or_else(|| {
                let meant = did_you_mean(name, names.iter().copied());
                words().no_input_named(name, &names.join(", "), meant.as_deref())
            })
    }

    /// Returns the name of the link or slide that an input drives.
    #[must_use]
    pub fn input_name(&self, input: Input) -> &str {
        match input {
            Input::Turn(link) => self.link_name(link),
            Input::Push(slide) => self.slide_name(slide),
        }
    }

    /// Returns the unit of an input's coordinate: `deg`, or the unit of length.
    #[must_use]
    pub fn input_unit(&self, input: Input) -> &'static str {
        match input {
            Input::Turn(_) => "deg",
            Input::Push(_) => self.unit.symbol(),
        }
    }

    /// Returns the unit of the rates of an input, without the time: `rad`, or the unit of length.
    #[must_use]
    pub fn input_rate_unit(&self, input: Input) -> &'static str {
        match input {
            Input::Turn(_) => "rad",
            Input::Push(_) => self.unit.symbol(),
        }
    }
}
