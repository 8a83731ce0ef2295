//! Reports the motor over the period of a motion over time, as text and as data.

use crate::page::{Content, Facts, Page, TextStyle};
use crate::quantity::{Aspect, Catalogue, Clock};
use crate::report::check::describe_out_of_range;
use crate::report::cycle::page::indented;
use crate::report::forces::{PARTS, effort_unit, effort_word};
use crate::report::motor::NOTHING;
use crate::report::motor::csv::{step_cells, step_heads};
use crate::report::text::csv_dialect::{CsvDialect, CsvSheet, cell};
use crate::report::text::number::{concise, significant};
use crate::scene::{Motor, Scene};
use crate::solver::Solver;
use crate::study::motor::{MotorDemand, MotorFit, NoTimedDuty, TimedDuty, TimedPart, TimedPeak};
use crate::wording::words;
use serde_json::{Value, json};
use std::io;

/// Number of steps written per period.
const STEPS: u32 = 360;
const LABEL: usize = 18;
const DIGITS: usize = 6;

/// The result for a scene.
#[derive(Clone, Debug)]
pub struct TimedMotorReport {
    scene: String,
    duty: TimedDuty,
    fit: MotorFit,
    effort: Aspect,
    /// The header of the driver's coordinate.
    coordinate: String,
    /// The units of the driver's coordinate, and of its rates without the time.
    units: [String; 2],
}

impl TimedMotorReport {
    /// Creates the report on a computed period, compared with a motor.
    #[must_use]
    pub fn new(scene: &Scene, duty: TimedDuty, motor: &Motor) -> TimedMotorReport {
        let input = scene.mechanism.driver().input;
        TimedMotorReport {
            scene: scene.name.clone(),
            fit: duty.fit(motor),
            effort: Aspect::effort_of(input),
            coordinate: Catalogue::new(scene).driver().header(),
            units: [
                Catalogue::new(scene).driver().unit.clone(),
                scene.input_rate_unit(input).to_owned(),
            ],
            duty,
        }
    }

    /// Returns a sentence on why there are no values for a period.
    #[must_use]
    pub fn nothing(scene: &Scene, why: &NoTimedDuty) -> String {
        let catalogue = Catalogue::new(scene);
        let unit = &catalogue.driver().unit;
        match why {
            NoTimedDuty::NothingActs => words().nothing_acts_on_it().into(),
            NoTimedDuty::WithheldReason(hidden) => hidden.text(unit),
            NoTimedDuty::Leaves(leaves) => describe_out_of_range(scene, leaves),
            NoTimedDuty::NoTorque(moment) => words().no_torque_on_the_way(moment.at, unit),
        }
    }

    /// Formats the report as text; `ascii` restricts the title to ASCII.
    #[must_use]
    pub fn to_text(&self, ascii: bool) -> String {
        self.page().to_text(TextStyle::plain(ascii))
    }

    /// Returns the whole report as a page.
    #[must_use]
    pub fn page(&self) -> Page {
        let (duty, mut page) = (&self.duty, Page::aligned());
        page.title(&words().translated_scene_text(&self.scene));
        page.text_below(words().over_a_period(&concise(duty.period, DIGITS)));
        let effort = effort_word(self.effort);
        let [unit, speed] = self.effort_and_speed();
        self.add_part(&mut page, format!("{effort} [{unit}]"), |facts| {
            self.add_peaks(facts, duty.torque);
            facts.add(&indented(words().label_mean()), [sized(duty.mean)]);
            facts.add(&indented(words().label_rms()), [sized(duty.rms)]);
            self.add_parts(facts);
        });
        self.add_part(&mut page, format!("{} [W]", words().power()), |facts| {
            self.add_peaks(facts, duty.power);
            facts.add(&indented(words().label_mean()), [sized(duty.mean_power())]);
        });
        self.add_part(
            &mut page,
            format!("{} [J]", words().label_energy()),
            |facts| {
                facts.add(&indented(words().label_put_in()), [sized(duty.energy[0])]);
                facts.add(
                    &indented(words().label_given_back()),
                    [sized(duty.energy[1])],
                );
            },
        );
        self.add_part(
            &mut page,
            format!("{} [{speed}]", words().speed()),
            |facts| {
                self.add_peaks(facts, duty.speed);
            },
        );
        self.add_fit(&mut page);
        page
    }

    /// Returns the units of the effort and of the speed.
    fn effort_and_speed(&self) -> [String; 2] {
        [
            effort_unit(self.effort).to_owned(),
            format!("{}/s", self.units[1]),
        ]
    }

    fn add_part(&self, page: &mut Page, heading: String, tell: impl FnOnce(&mut Facts)) {
        let mut facts = Facts {
            names: LABEL + 1,
            ..Facts::default()
        };
        tell(&mut facts);
        page.heading(heading);
        page.add(Content::Facts(facts));
    }

    fn add_peaks(&self, facts: &mut Facts, peaks: [TimedPeak; 2]) {
        let labels = [words().label_largest(), words().label_least()];
        for (label, peak) in labels.into_iter().zip(peaks) {
            let place = format!("{} {}", concise(peak.at, DIGITS), self.units[0]);
            let text = words().at_a_time(&sized(peak.value), &sized(peak.time), &place);
            facts.add(&indented(label), [text]);
        }
    }

    /// Adds the parts of the effort by cause, if there are several.
    fn add_parts(&self, facts: &mut Facts) {
        let parts = &self.duty.parts;
        let maximum = parts.iter().map(|part| part.rms).fold(0.0, f64::max);
        let labels = [words().loads(), words().gravity(), words().inertia()];
        let acting = labels.into_iter().zip(parts);
        let acting = acting.filter(|(_, part)| part.rms > NOTHING * maximum);
        let acting: Vec<(&str, &TimedPart)> = acting.collect();
        if let [_, _, ..] = acting[..] {
            for (label, part) in acting {
                let [maximum, minimum] = part.torque.map(|peak| sized(peak.value));
                let text = words().part_between(&minimum, &maximum, &sized(part.rms));
                facts.add(&indented(label), [text]);
            }
        }
    }

    /// Writes the period step by step as comma separated values: the driver's coordinate, speed and
    /// effort, its parts and power, the work done since the beginning, and the load on the ground.
    /// A missing value is empty.
    ///
    /// # Errors
    /// Returns the errors of the writer.
    pub fn write_csv(
        &self,
        (clock, solver): (&Clock, &Solver),
        dialect: CsvDialect,
        out: &mut dyn io::Write,
    ) -> io::Result<()> {
        let mut csv = CsvSheet::new(dialect, out);
        let [unit, speed] = self.effort_and_speed();
        let effort = format!("driver.{}", self.effort.name());
        let mut header = vec![
            "time [s]".to_owned(),
            self.coordinate.clone(),
            format!("driver.speed [{speed}]"),
        ];
        header.extend(step_heads(&effort, &unit));
        csv.record(&header)?;
        let scale = |rate: f64| match self.effort {
            Aspect::Torque => rate.to_radians(),
            _ => rate,
        };
        for instant in self.duty.instants(clock, solver, STEPS) {
            let mut row = vec![cell(Some(instant.time)), cell(Some(instant.moment.at))];
            row.push(cell(Some(scale(instant.moment.speed))));
            row.extend(step_cells(&instant.step, Some(instant.work)));
            csv.record(&row)?;
        }
        csv.finish()
    }

    /// Adds the comparison with the motor, as far as it is known.
    fn add_fit(&self, page: &mut Page) {
        let Some(is_enough) = self.fit.is_enough() else {
            return;
        };
        let verdict = match is_enough {
            true => words().enough(),
            false => words().not_enough(),
        };
        let requested = [
            (words().rated_for_rms(), self.fit.rated),
            (words().peak(), self.fit.peak),
            (words().speed(), self.fit.speed),
        ];
        self.add_part(page, words().motor_is(verdict), |facts| {
            for (label, demand) in requested {
                let text = demand.map(|demand| demand_text(&demand));
                facts.add(&indented(label), text);
            }
        });
    }

    /// Returns the report as data; the names must stay stable.
    #[must_use]
    pub fn to_json(&self) -> Value {
        let duty = &self.duty;
        let peak = |peak: TimedPeak| json!({"value": peak.value, "time": peak.time, "at": peak.at});
        let [unit, speed] = self.effort_and_speed();
        let mut all = json!({
            "unit": unit,
            "largest": peak(duty.torque[0]),
            "least": peak(duty.torque[1]),
            "mean": duty.mean,
            "rms": duty.rms,
        });
        for (name, part) in PARTS.iter().zip(&duty.parts) {
            all[*name] = json!({
                "largest": peak(part.torque[0]),
                "least": peak(part.torque[1]),
                "mean": part.mean,
                "rms": part.rms,
            });
        }
        json!({
            "scene": self.scene,
            "period": duty.period,
            (self.effort.name()): all,
            "power": {
                "largest": peak(duty.power[0]),
                "least": peak(duty.power[1]),
                "mean": duty.mean_power(),
            },
            "energy": {"put_in": duty.energy[0], "given_back": duty.energy[1]},
            "speed": {
                "unit": speed,
                "largest": peak(duty.speed[0]),
                "least": peak(duty.speed[1]),
            },
            "error": duty.error,
            "enough": self.fit.is_enough(),
        })
    }
}

fn sized(value: f64) -> String {
    significant(value, DIGITS)
}

fn demand_text(demand: &MotorDemand) -> String {
    let [has, wants] = [demand.capacity, demand.required].map(sized);
    match demand.is_enough() {
        true => words().has_left(&has, &wants, &sized(-demand.deficit())),
        false => words().has_a_share(
            &has,
            &wants,
            &concise(100.0 * demand.capacity / demand.required, 3),
        ),
    }
}
