//! Defines further inputs, which follow the driver.

use super::{
    Body, Defect, Driver, ElementId, Input, InputTable, LinkId, Mechanism, PointId, SlideId,
};
use crate::Vec2;
use crate::angle::TURN;
use std::sync::Arc;

/// An input whose coordinate follows the driver's, such as a second crank on the same shaft or a
/// cylinder switched with another one.
#[derive(Clone, Debug, PartialEq)]
pub struct TimedInput {
    /// The driven link or slide.
    pub input: Input,
    /// The law by which its coordinate follows the driver's.
    pub law: InputLaw,
}

/// The law by which an input's coordinate follows the driver's. Each coordinate is in degrees or
/// the scene's length unit.
#[derive(Clone, Debug, PartialEq)]
pub enum InputLaw {
    /// A linear function of the driver's coordinate.
    Ratio {
        /// The change of the input's coordinate per unit of the driver's.
        ratio: f64,
        /// The input's coordinate where the driver's is 0.
        phase: f64,
    },
    /// A table of both coordinates.
    Table(InputTable),
}

impl InputLaw {
    /// Returns the law of an input that rests at a coordinate.
    #[must_use]
    pub fn held(at: f64) -> InputLaw {
        InputLaw::Ratio {
            ratio: 0.0,
            phase: at,
        }
    }

    /// Returns `true` if the input rests in the whole motion.
    #[must_use]
    pub fn is_held(&self) -> bool {
        matches!(self, InputLaw::Ratio { ratio, .. } if *ratio == 0.0)
    }
}

impl TimedInput {
    /// Returns the input's coordinate at a coordinate of the driver.
    #[must_use]
    pub fn coordinate(&self, at: f64) -> f64 {
        match &self.law {
            InputLaw::Ratio { ratio, phase } => {
                let (count, of) = fraction(*ratio).unwrap_or((*ratio, 1.0));
                count * at / of + phase
            }
            InputLaw::Table(table) => table.at(at)[0],
        }
    }

    /// Returns the first and second derivative of the input's coordinate by the driver's. Each
    /// coordinate counts in radians or the scene's length unit.
    #[must_use]
    pub fn rates(&self, at: f64, driver: Input) -> [f64; 2] {
        let [first, second] = match &self.law {
            InputLaw::Ratio { ratio, .. } => [*ratio, 0.0],
            InputLaw::Table(table) => {
                let [_, first, second] = table.at(at);
                [first, second]
            }
        };
        let per_unit = match (driver, self.input) {
            (Input::Turn(_), Input::Push(_)) => 1_f64.to_degrees(),
            (Input::Push(_), Input::Turn(_)) => 1_f64.to_radians(),
            _ => 1.0,
        };
        let once_more = match driver {
            Input::Turn(_) => 1_f64.to_degrees(),
            Input::Push(_) => 1.0,
        };
        [first * per_unit, second * per_unit * once_more]
    }

    /// Returns the table, if the input follows one.
    #[must_use]
    pub fn table(&self) -> Option<&InputTable> {
        match &self.law {
            InputLaw::Ratio { .. } => None,
            InputLaw::Table(table) => Some(table),
        }
    }

    /// Returns `true` if the input repeats after this many turns of a driven link.
    pub(crate) fn repeats_after(&self, turns: usize) -> bool {
        let turns = turns as f64;
        match &self.law {
            InputLaw::Ratio { ratio, .. } => match (self.input, fraction(*ratio)) {
                (Input::Turn(_), Some((count, of))) => count * turns % of == 0.0,
                (Input::Turn(_), None) => false,
                (Input::Push(_), _) => *ratio == 0.0,
            },
            InputLaw::Table(table) => table
                .period()
                .is_some_and(|period| turns * TURN % period == 0.0),
        }
    }

    pub(super) fn check(&self, driver: Input, has_pivot: bool, found: &mut Vec<Defect>) {
        match &self.law {
            InputLaw::Ratio { ratio, phase } => {
                if !(ratio.is_finite() && phase.is_finite()) {
                    found.push(Defect::Driver);
                }
            }
            InputLaw::Table(table) => {
                let [drives, is_rotary] = [driver, self.input].map(|i| matches!(i, Input::Turn(_)));
                if table.period().is_some() && !(drives && table.is_closed(is_rotary)) {
                    let of = self.input.element();
                    found.push(Defect::OpenTable { of });
                }
            }
        }
        if let (Input::Turn(link), false) = (self.input, has_pivot) {
            found.push(Defect::NoPivot { link });
        }
    }
}

/// Returns a ratio as a fraction of whole numbers, or `None` if the denominator would exceed
/// `MAX_DENOMINATOR`: 0.3333333333333333 means a third.
pub(crate) fn fraction(ratio: f64) -> Option<(f64, f64)> {
    let denominators = (1..=MAX_DENOMINATOR).map(f64::from);
    let mut fractions = denominators.map(|of| ((ratio * of).round(), of));
    fractions.find(|(count, of)| count / of == ratio)
}

/// Maximum number of turns over which a motion is tracked. A ratio with a larger denominator does
/// not repeat within them.
const MAX_DENOMINATOR: u8 = 16;

impl Mechanism {
    /// Returns the inputs that follow the driver.
    #[must_use]
    pub fn timed(&self) -> &[TimedInput] {
        &self.parts.timed
    }

    /// Returns the coordinate of an input where the driver's is `at`; `None` if it is none.
    #[must_use]
    pub fn input_coordinate(&self, input: Input, at: f64) -> Option<f64> {
        if input == self.driver().input {
            return Some(at);
        }
        Some(self.timed_input(input)?.coordinate(at))
    }

    /// Returns a copy in which another input is the driver and moves alone, at 1 rad/s or 1 unit/s.
    /// All other inputs are held where they are while the present driver is at `at`, and so are
    /// factors of loads over the driver's coordinate. The copy opens there, in the assembly nearest
    /// to the positions `start`.
    ///
    /// The limits of the driver itself and of tables end with their motion. Returns `None` if
    /// `input` is no input of the mechanism.
    #[must_use]
    pub fn led_by(&self, input: Input, at: f64, start: Vec<(PointId, Vec2)>) -> Option<Mechanism> {
        let opening = self.input_coordinate(input, at)?;
        let is_rotary = self.driver().turns();
        let others = self.inputs().filter(|&other| other != input);
        let held = others.filter_map(|other| {
            let law = InputLaw::held(self.input_coordinate(other, at)?);
            Some(TimedInput { input: other, law })
        });
        let timed = held.collect();
        let mut led = self.clone();
        let parts = Arc::make_mut(&mut led.parts);
        parts.driver = Driver {
            input,
            start: opening,
            speed: 1.0,
            acceleration: 0.0,
        };
        parts.timed = timed;
        parts.start = start;
        parts.limits.retain(|limit| limit.of.is_of_element());
        let loads = std::mem::take(&mut parts.loads).into_iter();
        parts.loads = loads.map(|load| load.held_at(at, is_rotary)).collect();
        (parts.typed_rates, parts.converted_rates) = (None, false);
        Some(led)
    }

    /// Returns every input, the driver's first: one per degree of freedom.
    pub fn inputs(&self) -> impl Iterator<Item = Input> + '_ {
        let timed = self.timed().iter().map(|timed| timed.input);
        std::iter::once(self.driver().input).chain(timed)
    }

    /// Returns `true` if an input turns the link.
    #[must_use]
    pub fn is_turned(&self, link: LinkId) -> bool {
        self.inputs().any(|input| input == Input::Turn(link))
    }

    /// Returns the body against which an input turns a link: the ground, or the link with the
    /// motor.
    #[must_use]
    pub fn turned_from(&self, link: LinkId) -> Body {
        let mut pairs = self.parts.turned_from.iter();
        let found = pairs.find(|(turned, _)| *turned == link);
        found.map_or(Body::Ground, |&(_, from)| Body::Link(from))
    }

    /// Returns the links that inputs turn against other links, each with that other link.
    pub fn elbows(&self) -> impl Iterator<Item = (LinkId, LinkId)> + '_ {
        let links = self.inputs().filter_map(|input| match input {
            Input::Turn(link) => Some(link),
            Input::Push(_) => None,
        });
        links.filter_map(|link| match self.turned_from(link) {
            Body::Link(from) => Some((link, from)),
            Body::Ground => None,
        })
    }

    /// Returns `true` if an input sets the link's direction: it turns the link against the ground.
    #[must_use]
    pub fn is_directed(&self, link: LinkId) -> bool {
        self.is_turned(link) && self.turned_from(link) == Body::Ground
    }

    /// Returns `true` if the driver's coordinate is the link's direction.
    #[must_use]
    pub fn is_crank(&self, link: LinkId) -> bool {
        self.driver().input == Input::Turn(link) && self.is_directed(link)
    }

    /// Returns the point about which an input turns a link: its ground point, or the joint with the
    /// link that carries the motor. Returns `None` if there is none.
    #[must_use]
    pub fn hub(&self, link: LinkId) -> Option<PointId> {
        let mut points = self.link(link).members.iter().map(|member| member.point);
        let from = self.turned_from(link);
        points.find(|&point| match from {
            Body::Ground => self.point(point).ground.is_some(),
            Body::Link(from) => self.point(point).links.contains(&from),
        })
    }

    /// Returns the inputs whose torque acts on a link, with its sign: 1 on the turned link, -1 on
    /// the link that carries the motor.
    pub fn torques_on(&self, link: LinkId) -> impl Iterator<Item = (Input, f64)> + '_ {
        self.inputs().filter_map(move |input| match input {
            Input::Turn(turned) if turned == link => Some((input, 1.0)),
            Input::Turn(turned) if self.turned_from(turned) == Body::Link(link) => {
                Some((input, -1.0))
            }
            Input::Turn(_) | Input::Push(_) => None,
        })
    }

    /// Returns `true` if an input pushes the slide.
    #[must_use]
    pub fn is_pushed(&self, slide: SlideId) -> bool {
        self.inputs().any(|input| input == Input::Push(slide))
    }

    /// Returns the further input of a link or slide, if it has one.
    #[must_use]
    pub fn timed_input(&self, input: Input) -> Option<&TimedInput> {
        self.timed().iter().find(|timed| timed.input == input)
    }
}

impl Driver {
    /// Returns `true` if the driver turns a link; `false` if it pushes a slide.
    #[must_use]
    pub fn turns(&self) -> bool {
        matches!(self.input, Input::Turn(_))
    }
}

impl Input {
    /// Returns the driven link or slide.
    #[must_use]
    pub fn element(self) -> ElementId {
        match self {
            Input::Turn(link) => ElementId::Link(link),
            Input::Push(slide) => ElementId::Slide(slide),
        }
    }
}
