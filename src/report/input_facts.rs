//! Facts on the inputs that follow the driver.

use super::check::DriverKind;
use super::number::concise;
use crate::scene::{Scene, from_seat};
use crate::solver::Range;
use crate::wording::words;
use crate::{Input, InputLaw, InputTable};
use serde::Serialize;

/// An input that follows the driver.
#[derive(Clone, Debug, Serialize)]
pub struct InputFacts {
    /// The kind of driven element.
    pub kind: DriverKind,
    /// The link or slide.
    pub name: String,
    /// The link that carries its motor, unless the ground does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub from: Option<String>,
    /// The law by which it follows.
    #[serde(flatten)]
    pub law: InputLawFacts,
}

/// The law by which an input follows the driver; coordinates are in deg or the scene's unit.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum InputLawFacts {
    /// A linear law.
    Ratio {
        /// The change of its coordinate per unit of the driver's.
        #[serde(serialize_with = "super::check::unsigned_zero")]
        ratio: f64,
        /// Its coordinate at driver coordinate 0.
        #[serde(serialize_with = "super::check::unsigned_zero")]
        phase: f64,
    },
    /// A table.
    Table {
        /// The knots: the driver's coordinate, and its own.
        over: Vec<[f64; 2]>,
        /// The period in degrees of the driver, if it repeats.
        repeats: Option<f64>,
        /// The number of knots beyond the ends of the motion, except the nearest one on each side.
        unreached: usize,
    },
}

impl DriverKind {
    /// Returns the kind and the name of the element driven by an input.
    pub(super) fn of(scene: &Scene, input: Input) -> (DriverKind, String) {
        let (kind, name) = match input {
            Input::Turn(link) => (DriverKind::Link, scene.link_name(link)),
            Input::Push(slide) => (DriverKind::Slide, scene.slide_name(slide)),
        };
        (kind, name.to_owned())
    }

    /// Returns the unit of its coordinate; `length` is the unit of length.
    fn unit(self, length: &str) -> &str {
        match self {
            DriverKind::Link => "deg",
            DriverKind::Slide => length,
        }
    }

    /// Returns the name with a word for the kind.
    pub(super) fn named(self, name: &str) -> String {
        match self {
            DriverKind::Link => words().driven_link(name),
            DriverKind::Slide => words().driven_slide(name),
        }
    }
}

impl InputFacts {
    /// Returns the facts of a scene's inputs, in the order of the file; `range` is that of the
    /// driver.
    pub(super) fn of(scene: &Scene, range: Range) -> Vec<InputFacts> {
        let facts = scene.mechanism.timed().iter().map(|timed| {
            let (kind, name) = DriverKind::of(scene, timed.input);
            let law = match &timed.law {
                &InputLaw::Ratio { ratio, phase } => InputLawFacts::Ratio { ratio, phase },
                InputLaw::Table(table) => InputLawFacts::Table {
                    over: table.knots().to_vec(),
                    repeats: table.period(),
                    unreached: unreached(table, range),
                },
            };
            InputFacts {
                kind,
                name,
                from: scene.seat_name(timed.input).map(str::to_owned),
                law,
            }
        });
        facts.collect()
    }

    /// Describes how it follows a driver.
    pub(super) fn text(&self, driver: DriverKind, length: &str) -> String {
        let driven = self.kind.named(&self.name);
        let drivers = driver.unit(length);
        let (over, repeats, unreached) = match &self.law {
            InputLawFacts::Ratio { ratio, phase } => {
                return self.proportion([*ratio, *phase], drivers, length);
            }
            InputLawFacts::Table {
                over,
                repeats,
                unreached,
            } => (over, repeats, *unreached),
        };
        let place = |knot: Option<&[f64; 2]>| concise(knot.map_or(0.0, |k| k[0]), usize::MAX);
        let ends = [place(over.first()), place(over.last())];
        let ends = ends.each_ref().map(String::as_str);
        let mut text = words().input_follows_table(&driven, over.len(), ends, drivers);
        if let Some(period) = repeats {
            text += &words().table_repeats(&concise(*period, usize::MAX));
        }
        if unreached > 0 {
            text += &words().knots_beyond_motion(unreached);
        }
        text
    }

    /// Describes how it follows a driver, with all data needed for calculations.
    pub(super) fn given(&self, driver: DriverKind, length: &str) -> String {
        let InputLawFacts::Table { over, repeats, .. } = &self.law else {
            return self.text(driver, length);
        };
        let knots = over.iter().map(|knot| {
            let [at, value] = knot.map(|number| concise(number, usize::MAX));
            format!("[{at}, {value}]")
        });
        let knots: Vec<String> = knots.collect();
        let units = [driver.unit(length), self.kind.unit(length)];
        let driven = self.kind.named(&self.name);
        words().input_given_by_table(&driven, &knots.join(", "), units, repeats.is_some())
    }

    fn proportion(&self, numbers: [f64; 2], drivers: &str, length: &str) -> String {
        let [ratio, phase] = numbers.map(|v| concise(v, usize::MAX));
        let own = self.kind.unit(length);
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

/// Returns the number of knots of an open table beyond the ends of the motion. The first one beyond
/// each end is not counted, because it still determines the curve inside.
fn unreached(table: &InputTable, range: Range) -> usize {
    let Range::Limited { low, high } = range else {
        return 0;
    };
    if table.period().is_some() {
        return 0;
    }
    let places = || table.knots().iter().map(|knot| knot[0]);
    let below = places().filter(|&at| at <= low).count();
    let above = places().filter(|&at| at >= high).count();
    below.saturating_sub(1) + above.saturating_sub(1)
}
