//! Facts on the driver, and on the inputs that follow it.

use super::{CheckedScene, Fact};
use crate::report::text::number::concise;
use crate::scene::Scene;
use crate::solver::Range;
use crate::wording::words;
use crate::{Input, InputLaw, InputTable, TimedInput};
use serde_json::{Value, json};

/// Significant digits of the driver's rates: the default of tables.
const DIGITS: usize = 6;

impl CheckedScene<'_> {
    /// Returns the fact on the driver, with a line for each input that follows it.
    pub(super) fn driver(&self) -> Fact {
        let driver = self.scene.mechanism.driver();
        let inputs = self.scene.mechanism.timed().iter();
        let inputs = inputs.map(|timed| (self.input_json(timed), [self.input_text(timed)]));
        let inputs = Fact::each(words().fact_driver(), "inputs", inputs).without_empty();
        let mut value = input_json(self.scene, driver.input);
        for (key, rate) in [
            ("start", driver.start),
            ("speed", driver.speed),
            ("acceleration", driver.acceleration),
        ] {
            value[key] = json!(rate + 0.0);
        }
        Fact {
            lines: [self.driver_text()]
                .into_iter()
                .chain(inputs.lines)
                .collect(),
            ..inputs
        }
        .value("driver", value)
    }

    fn driver_text(&self) -> String {
        let driver = self.scene.mechanism.driver();
        let driven = self.driven();
        let start = format!("{} {}", concise(driver.start, usize::MAX), self.unit);
        if self.scene.motion.is_some() {
            return words().driver_opens_at(&driven, &start);
        }
        let unit = self.scene.input_rate_unit(driver.input);
        // Rates converted from rpm or deg/s may have meaningless digits.
        let [speed, acceleration] = [driver.speed, driver.acceleration].map(|v| concise(v, DIGITS));
        words().driver_opens(
            &driven,
            &start,
            &format!("{speed} {unit}/s"),
            &format!("{acceleration} {unit}/s^2"),
        )
    }

    /// Returns the name of the driven element, with a word for its kind.
    pub(super) fn driven(&self) -> String {
        let input = self.scene.mechanism.driver().input;
        with_kind(input, &self.scene.driven_name(input))
    }

    fn input_json(&self, timed: &TimedInput) -> Value {
        let mut value = input_json(self.scene, timed.input);
        let law = match &timed.law {
            InputLaw::Ratio { ratio, phase } => {
                json!({"ratio": ratio + 0.0, "phase": phase + 0.0})
            }
            InputLaw::Table(table) => json!({
                "over": table.knots(),
                "repeats": table.period(),
                "unreached": unreached(table, self.solver.motion().range),
            }),
        };
        if let (Some(value), Value::Object(law)) = (value.as_object_mut(), law) {
            value.extend(law);
        }
        value
    }

    /// Describes how an input follows the driver.
    fn input_text(&self, timed: &TimedInput) -> String {
        let table = match &timed.law {
            &InputLaw::Ratio { ratio, phase } => return self.ratio_text(timed.input, ratio, phase),
            InputLaw::Table(table) => table,
        };
        let (knots, unreached) = (table.knots(), unreached(table, self.solver.motion().range));
        let place = |knot: Option<&[f64; 2]>| concise(knot.map_or(0.0, |k| k[0]), usize::MAX);
        let ends = [place(knots.first()), place(knots.last())];
        let ends = ends.each_ref().map(String::as_str);
        let driven = with_kind(timed.input, self.scene.input_name(timed.input));
        let mut text = words().input_follows_table(&driven, knots.len(), ends, &self.unit);
        if let Some(period) = table.period() {
            text += &words().table_repeats(&concise(period, usize::MAX));
        }
        if unreached > 0 {
            text += &words().knots_beyond_motion(unreached);
        }
        text
    }

    fn ratio_text(&self, input: Input, ratio: f64, phase: f64) -> String {
        let is_held = ratio == 0.0;
        let [ratio, phase] = [ratio, phase].map(|v| concise(v, usize::MAX));
        let own = self.scene.input_unit(input);
        let ratio = match own == self.unit {
            true => ratio,
            false => format!("{ratio} {own}/{}", self.unit),
        };
        let driven = with_kind(input, &self.scene.driven_name(input));
        if is_held {
            return words().input_is_held(&driven, &phase, own);
        }
        words().input_follows(&driven, &ratio, &format!("{phase} {own}"))
    }

    /// Describes how an input follows the driver, with all data needed for calculations.
    fn input_given(&self, timed: &TimedInput) -> String {
        let InputLaw::Table(table) = &timed.law else {
            return self.input_text(timed);
        };
        let knots = table.knots().iter().map(|knot| {
            let [at, value] = knot.map(|number| concise(number, usize::MAX));
            format!("[{at}, {value}]")
        });
        let knots: Vec<String> = knots.collect();
        let units = [&*self.unit, self.scene.input_unit(timed.input)];
        let driven = with_kind(timed.input, self.scene.input_name(timed.input));
        words().input_given_by_table(&driven, &knots.join(", "), units, table.period().is_some())
    }
}

/// Describes how each input follows the driver, with all data needed for calculations.
pub(in crate::report) fn inputs_given(of: &CheckedScene<'_>) -> Vec<String> {
    let inputs = of.scene.mechanism.timed().iter();
    inputs.map(|timed| of.input_given(timed)).collect()
}

/// Returns the kind and the name of the driven element, and the link that carries its motor, unless
/// the ground does.
fn input_json(scene: &Scene, input: Input) -> Value {
    let kind = match input {
        Input::Turn(_) => "link",
        Input::Push(_) => "slide",
    };
    let mut value = json!({"kind": kind, "name": scene.input_name(input)});
    if let Some(from) = scene.seat_name(input) {
        value["from"] = json!(from);
    }
    value
}

/// Returns the name with a word for the kind.
fn with_kind(input: Input, name: &str) -> String {
    match input {
        Input::Turn(_) => words().driven_link(name),
        Input::Push(_) => words().driven_slide(name),
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
