//! Formats the motor over a cycle as a page.

mod facts;
mod ram_motion;

use crate::page::{Page, Row, Table, TextStyle};
use crate::report::cycle::page::indented;
use crate::report::forces::effort_word;
use crate::report::motor::{MotorReport, NOTHING};
use crate::report::text::number::{concise, significant};
use crate::study::motor::{Cycle, DriveEffort, Duty, DutyError, MotorDemand, Peak};
use crate::wording::words;
use facts::{
    cleaned, columns_of, facts, figure, indented_facts, is_constant, known, none, rough, rule_text,
    trimmed, verdict,
};

/// Significant digits of a value, and decimals of its place in degrees.
const DIGITS: usize = 6;
const DECIMALS: usize = 3;
/// Decimals of a dead centre: the precision of a double at some hundred degrees.
const ALL_DECIMALS: usize = 12;
/// Revolutions per minute of 1 rad/s.
const RPM: f64 = 30.0 / std::f64::consts::PI;

impl MotorReport {
    /// Formats the result as text. `ascii` restricts the title to ASCII; the rest always is.
    #[must_use]
    pub fn to_text(&self, ascii: bool) -> String {
        self.page().to_text(TextStyle::plain(ascii))
    }

    /// Returns the whole result as a page.
    #[must_use]
    pub fn page(&self) -> Page {
        let mut page = Page::aligned();
        page.title(&words().translated_scene_text(&self.scene));
        match &self.duty {
            Ok(duty) => self.add_duty(duty, &mut page),
            Err(why) => page.text_below(self.nothing(why)),
        }
        if let Ok(ram) = &self.ram {
            self.add_ram(ram, &mut page);
        }
        page
    }

    /// Returns the reason why there are no values.
    pub(crate) fn nothing(&self, why: &DutyError) -> String {
        match why {
            DutyError::NothingActs => words().nothing_acts().into(),
            DutyError::WithheldReason(hidden) => {
                words().no_figures(&hidden.text(&self.driver_unit))
            }
        }
    }

    fn add_duty(&self, duty: &Duty, page: &mut Page) {
        let cycle = &duty.cycle;
        page.text_below(self.demand_sentence(duty));
        for text in self.singular_texts(duty) {
            page.text_below(text);
        }
        page.table(self.effects(duty));
        self.add_fit(page);
        self.add_evenness(duty, page);
        self.add_shaking(cycle, page);
        let rule = rule_text(cycle, self.effort());
        page.add(facts([(words().label_integrals().into(), rule)]));
    }

    /// Describes the demand on the motor in a sentence.
    fn demand_sentence(&self, duty: &Duty) -> String {
        let cycle = &duty.cycle;
        let unit = self.effort_unit();
        let sized = |value| format!("{} {unit}", significant(value, DIGITS));
        let course = self.course_text(duty);
        let requested = match (cycle.all.worst(), cycle.all.rms) {
            (Some(worst), Some(_)) if is_constant(&cycle.all) => {
                words().asks_throughout(&sized(worst.value))
            }
            (Some(worst), Some(rms)) => {
                words().asks_at_worst(&sized(worst.value), &self.place(&worst), &sized(rms))
            }
            _ => words().asks_too_much(self.effort()),
        };
        words().driver_asks(&course, &self.driver, &requested)
    }

    /// Describes the cycle.
    fn course_text(&self, duty: &Duty) -> String {
        let course = &duty.cycle.course;
        let speed = self.speed_text(self.speed.abs());
        match (course.is_periodic, duty.turns()) {
            (true, 1.0) => words().over_a_turn(&speed),
            (true, turns) => words().over_turns(turns, &speed),
            (false, _) => {
                let [low, high] = [course.low, course.high].map(|end| concise(end, 9));
                words().there_and_back(&low, &high, &self.driver_unit, &speed)
            }
        }
    }

    /// Returns the word for the driver's effort in the current language.
    fn effort(&self) -> &'static str {
        effort_word(self.effort)
    }

    /// Formats a speed of the driver in the scene's unit; a speed of rotation also in rpm.
    fn speed_text(&self, speed: f64) -> String {
        if self.is_rotary {
            let rpm = trimmed(speed * RPM);
            format!("{} rad/s ({rpm} rpm)", concise(speed, DIGITS))
        } else {
            format!("{} {}/s", concise(speed, DIGITS), self.unit)
        }
    }

    fn singular_texts(&self, duty: &Duty) -> Vec<String> {
        let listed = |places: &[f64]| {
            let places: Vec<String> = places.iter().map(|&at| concise(at, 9)).collect();
            words().places_of(&places, &self.driver_unit)
        };
        let (mut texts, cycle) = (Vec::new(), &duty.cycle);
        let all = &duty.cycle.all;
        if let (Some(work), Some(put_in)) = (all.work(), all.supplied)
            && work < -NOTHING * put_in
        {
            let work = significant(-work, DIGITS);
            texts.push(words().mechanism_drives(&self.driver, &work));
        }
        if !duty.dead_points.is_empty() {
            let places = listed(&duty.dead_points);
            texts.push(match duty.reaches_dead_point {
                true => words().dead_points_run_into(&places),
                false => words().dead_points_passed(&places),
            });
        }
        if !duty.change_points.is_empty() {
            texts.push(words().change_points_passed(&listed(&duty.change_points)));
        }
        if !duty.cycle.has_converged() {
            let error = significant(duty.cycle.error, 2);
            texts.push(words().not_converged(&error, self.effort()));
        }
        if !duty.unrepeated.is_empty() {
            let numbers: Vec<String> = duty.unrepeated.iter().map(usize::to_string).collect();
            let course = &cycle.course;
            let [low, high] = [course.low, course.high].map(|end| concise(end, 9));
            texts.push(words().does_not_repeat(&numbers, &low, &high, &self.driver_unit));
        }
        if duty.is_cut_short {
            texts.push(words().repeats_late().into());
        }
        if !duty.is_steady {
            texts.push(words().speed_not_kept().into());
        }
        if self.speed == 0.0 {
            texts.push(words().no_power().into());
        }
        texts
    }

    /// Returns the table of torque, power and energy, in total and by cause.
    fn effects(&self, duty: &Duty) -> Table {
        let cycle = &duty.cycle;
        let [load, gravity, inertia] = &cycle.parts;
        let parts = [
            (words().loads(), load),
            (words().gravity(), gravity),
            (words().inertia(), inertia),
        ];
        let parts = parts.into_iter();
        let acting = parts.filter(|(_, effect)| !effect.is_rounding_of(&cycle.parts));
        let all = std::iter::once((words().label_all(), &cycle.all));
        let (names, columns): (Vec<&str>, Vec<&DriveEffort>) = all.chain(acting).unzip();
        let what = self.effort();
        let mut table = columns_of(format!("{what} [{}]", self.effort_unit()), names);
        let larger = |a: Option<Peak>, b: Option<Peak>| Some(a?.value.abs().max(b?.value.abs()));
        let torque = |e: &DriveEffort| larger(e.largest, e.least);
        let power = |e: &DriveEffort| larger(e.largest_power, e.least_power);
        let energy = |e: &DriveEffort| Some(e.supplied? + e.returned?);
        let peak = |peak: Option<Peak>, size| figure(cleaned(peak.map(|p| p.value), size));
        let place = |e: &DriveEffort, peak: Option<Peak>| match peak {
            Some(_) if is_constant(e) => String::new(),
            peak => peak.map_or_else(none, |p| self.short_place(&p)),
        };
        let mean_power = |e: &DriveEffort| {
            let work = cleaned(e.work(), energy(e))?;
            Some(work / duty.seconds()?)
        };
        let at = format!("    {} [{}]", words().at(), self.driver_unit);
        let largest = indented(words().label_largest());
        let minimum = indented(words().label_least());
        let mean = indented(words().label_mean());
        let cells = |cell: &dyn Fn(&DriveEffort) -> String| -> Vec<String> {
            columns.iter().map(|effect| cell(effect)).collect()
        };
        table.row(largest.as_str(), cells(&|e| peak(e.largest, torque(e))));
        table.row(at.as_str(), cells(&|e| place(e, e.largest)));
        table.row(minimum.as_str(), cells(&|e| peak(e.least, torque(e))));
        table.row(at.as_str(), cells(&|e| place(e, e.least)));
        table.row(mean.as_str(), cells(&|e| figure(cleaned(e.mean, e.rms))));
        table.row(indented(words().label_rms()), cells(&|e| figure(e.rms)));
        table
            .rows
            .push(Row::Part(format!("{} [W]", words().power())));
        table.row(largest, cells(&|e| peak(e.largest_power, power(e))));
        table.row(minimum, cells(&|e| peak(e.least_power, power(e))));
        table.row(mean, cells(&|e| figure(mean_power(e))));
        table
            .rows
            .push(Row::Part(format!("{} [J]", words().label_energy())));
        table.row(
            indented(words().label_put_in()),
            cells(&|e| figure(cleaned(e.supplied, energy(e)))),
        );
        table.row(
            indented(words().label_given_back()),
            cells(&|e| figure(cleaned(e.returned, energy(e)))),
        );
        table.row(
            indented(words().label_work()),
            cells(&|e| figure(cleaned(e.work(), energy(e)))),
        );
        table
    }

    fn add_fit(&self, page: &mut Page) {
        let motor = &self.wishes.motor;
        let is_known = motor.rated.or(motor.peak).or(motor.speed).is_some();
        let is_enough = self.is_enough();
        let verdict_text = match is_enough {
            Some(true) if self.is_even_enough() == Some(false) => {
                words().enough_but_the_flywheel().to_owned()
            }
            Some(true) if self.fit.is_enough() == Some(false) => {
                words().enough_with_flywheel().to_owned()
            }
            Some(true) => words().enough().to_owned(),
            Some(false) => words().not_enough().to_owned(),
            None if self.fit.is_unbounded && is_known => words().not_judged(self.effort()),
            None => return,
        };
        let unit = self.effort_unit();
        let (scale, speeds) = if self.is_rotary {
            (RPM, "rpm")
        } else {
            (1.0, "m/s")
        };
        let torque = |requested: &MotorDemand| verdict(requested, 1.0, unit);
        let speed = |requested: &MotorDemand| verdict(requested, scale, speeds);
        let flywheel = self.with_flywheel();
        let flywheel =
            flywheel.map(|requested| words().about_the_mean(&verdict(&requested, 1.0, unit)));
        let gear = self.fit.geared.filter(|_| is_enough == Some(false));
        let gear = gear.map(|gear| {
            let ratio = concise(gear.ratio, 4);
            match gear.is_enough {
                true => words().gear_enough(&ratio),
                false => words().gear_not_enough(&ratio),
            }
        });
        let text = [
            (words().rated_for_rms(), self.fit.rated.as_ref().map(torque)),
            (words().peak(), self.fit.peak.as_ref().map(torque)),
            (words().speed(), self.fit.speed.as_ref().map(speed)),
            (words().with_flywheel(), flywheel),
            (words().with_a_gear(), gear),
        ];
        page.heading(words().motor_is(&verdict_text));
        page.add(known(text));
    }

    fn add_evenness(&self, duty: &Duty, page: &mut Page) {
        let Some(fluctuation) = duty.cycle.fluctuation else {
            return;
        };
        let degrees = |at: f64| format!("{at:.DECIMALS$} {}", self.driver_unit);
        let energy = words().energy_up_and_down(
            &significant(fluctuation.energy, DIGITS),
            &degrees(fluctuation.slowest),
            &degrees(fluctuation.fastest),
        );
        let evenness = self.evenness().unwrap_or_default();
        let flywheel = evenness.with.map(|(inertia, fluctuation)| {
            let (inertia, left) = (concise(inertia, DIGITS), significant(fluctuation, 4));
            rough(words().flywheel_leaves(&inertia, &left), fluctuation)
        });
        let requested = evenness.requested.map(|(fluctuation, inertia)| {
            let (requested, inertia) = (concise(fluctuation, DIGITS), significant(inertia, DIGITS));
            rough(words().takes_a_flywheel(&requested, &inertia), fluctuation)
        });
        let text = [
            (words().label_energy(), Some(energy)),
            (words().flywheel(), flywheel),
            (words().fluctuation(), requested),
        ];
        page.heading(words().evenness());
        page.add(known(text));
    }

    fn add_shaking(&self, cycle: &Cycle, page: &mut Page) {
        let shaking = &cycle.shaking;
        let none = words().no_joint_forces().to_owned();
        let size = |v: f64| significant(v, DIGITS);
        // A peak equal to the root mean square means that the value is constant.
        let is_same = |peak: &Peak, rms: f64| (peak.value.abs() - rms).abs() <= NOTHING * rms;
        let force = shaking.force.zip(shaking.force_rms).zip(shaking.vector);
        let force = force.map_or(none.clone(), |((peak, rms), v)| {
            let [x, y] = [v.x, v.y].map(|part| significant(part, 4));
            let (force, place) = (size(peak.value), self.place(&peak));
            match is_same(&peak, rms) {
                true => words().force_throughout(&force, &x, &y),
                false => words().force_at(&force, &place, &x, &y, &size(rms)),
            }
        });
        let moment = shaking.moment.zip(shaking.moment_rms);
        let moment = moment.map_or(none, |(peak, rms)| {
            let (moment, place) = (size(peak.value), self.place(&peak));
            match is_same(&peak, rms) {
                true => words().moment_throughout(&moment),
                false => words().moment_at(&moment, &place, &size(rms)),
            }
        });
        page.heading(words().on_frame_with_loads());
        let text = [(words().force(), force), (words().moment(), moment)];
        page.add(indented_facts(text));
    }

    fn place(&self, peak: &Peak) -> String {
        let at = if self.is_rotary {
            format!("{:.DECIMALS$}", peak.at)
        } else {
            significant(peak.at, DIGITS)
        };
        let place = format!("{at} {}", self.driver_unit);
        match peak.back {
            true => words().on_the_way_back(&place),
            false => place,
        }
    }

    fn short_place(&self, peak: &Peak) -> String {
        match (self.is_rotary, peak.back) {
            (true, false) => format!("{:.DECIMALS$}", peak.at),
            (false, false) => significant(peak.at, DIGITS),
            // Fewer decimals leave space for the word.
            (true, true) => words().back_at(&format!("{:.1}", peak.at)),
            (false, true) => words().back_at(&significant(peak.at, 4)),
        }
    }
}
