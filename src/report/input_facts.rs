//! The inputs that follow the driver, among the facts of a scene.

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
    /// Whether a link turns or a slide is pushed.
    pub kind: DriverKind,
    /// The link or the slide.
    pub name: String,
    /// The link that its motor sits on, where that is not the ground.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub from: Option<String>,
    /// How it follows.
    #[serde(flatten)]
    pub law: InputLawFacts,
}

/// How an input follows the driver; coordinates are in deg or the scene's unit.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum InputLawFacts {
    /// In proportion.
    Ratio {
        /// What its coordinate grows by for 1 of the driver's.
        #[serde(serialize_with = "super::check::unsigned_zero")]
        ratio: f64,
        /// Its coordinate where the driver's is 0.
        #[serde(serialize_with = "super::check::unsigned_zero")]
        phase: f64,
    },
    /// By a table.
    Table {
        /// The knots: the driver's coordinate, and its own.
        over: Vec<[f64; 2]>,
        /// After how many degrees of the driver it repeats, if it does.
        repeats: Option<f64>,
        /// So many knots are further beyond an end of the motion than the next one.
        unreached: usize,
    },
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

    /// The unit of its coordinate, where lengths are in `length`.
    fn unit(self, length: &str) -> &str {
        match self {
            DriverKind::Link => "deg",
            DriverKind::Slide => length,
        }
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
    /// Those of a scene, in the order of the file; `range` is that of the driver.
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

    /// How it follows a driver.
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

    /// The same with all that is needed to work with it.
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

/// How many knots of an open table the motion does not come near to: on either side the first beyond it still has a
/// part in what lies before.
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
