//! The motor over a cycle, to be read.

use super::motor::{MotorReport, NOTHING, RamReport, end_word};
use super::number::{concise, significant};
use crate::page::{Content, Facts, Page, Rest, Row, Setting, Table, TextRole, TextStyle};
use crate::study::motor::{
    Cycle, DriveEffort, Duty, MotorDemand, NoDuty, Passing, Peak, Rule, SMALL_FLUCTUATION,
};
use crate::wording::words;

/// Digits of a figure, and decimals of where it is in degrees.
const DIGITS: usize = 6;
const DECIMALS: usize = 3;
/// Decimals of a dead centre: as many as a double has at some hundred degrees.
const ALL_DECIMALS: usize = 12;
/// Columns of a label, and of a figure behind it.
const LABEL: usize = 18;
const FIGURE: usize = 10;
/// Turns a minute in 1 rad/s.
const RPM: f64 = 30.0 / std::f64::consts::PI;

impl MotorReport {
    /// As text for a person; the title in ASCII alone if asked, everything else always is.
    #[must_use]
    pub fn to_text(&self, ascii: bool) -> String {
        self.page().to_text(TextStyle::plain(ascii))
    }

    /// All that was found.
    #[must_use]
    pub fn page(&self) -> Page {
        let mut page = Page::aligned();
        page.title(&words().told_of_scene(&self.scene));
        match &self.duty {
            Ok(duty) => self.add_duty(duty, &mut page),
            Err(why) => page.text_below(self.nothing(why)),
        }
        if let Ok(ram) = &self.ram {
            self.add_ram(ram, &mut page);
        }
        page
    }

    /// Why there are no figures.
    pub(crate) fn nothing(&self, why: &NoDuty) -> String {
        match why {
            NoDuty::NothingActs => words().nothing_acts().into(),
            NoDuty::Withheld(hidden) => words().no_figures(&hidden.text(&self.driver_unit)),
        }
    }

    fn add_duty(&self, duty: &Duty, page: &mut Page) {
        let cycle = &duty.cycle;
        page.text_below(self.asked_text(duty));
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

    /// What is asked of a motor, in a sentence.
    fn asked_text(&self, duty: &Duty) -> String {
        let cycle = &duty.cycle;
        let unit = self.effort_unit();
        let sized = |value| format!("{} {unit}", significant(value, DIGITS));
        let course = self.course_text(duty);
        let asked = match (cycle.all.worst(), cycle.all.rms) {
            (Some(worst), Some(_)) if is_constant(&cycle.all) => {
                words().asks_throughout(&sized(worst.value))
            }
            (Some(worst), Some(rms)) => {
                words().asks_at_worst(&sized(worst.value), &self.place(&worst), &sized(rms))
            }
            _ => words().asks_too_much(self.effort()),
        };
        words().driver_asks(&course, &self.driver, &asked)
    }

    /// The cycle in words.
    fn course_text(&self, duty: &Duty) -> String {
        let course = &duty.cycle.course;
        let speed = self.speed_text(self.speed.abs());
        match (course.goes_round, duty.turns()) {
            (true, 1.0) => words().over_a_turn(&speed),
            (true, turns) => words().over_turns(turns, &speed),
            (false, _) => {
                let [low, high] = [course.low, course.high].map(|end| concise(end, 9));
                words().there_and_back(&low, &high, &self.driver_unit, &speed)
            }
        }
    }

    /// What the driver does, in a word.
    fn effort(&self) -> &'static str {
        match self.turns {
            true => words().torque(),
            false => words().force(),
        }
    }

    /// The same as files for other programs have it.
    pub(super) fn effort_word(&self) -> &'static str {
        if self.turns { "torque" } else { "force" }
    }

    /// A speed of the driver in the scene's unit, turns in rpm too.
    fn speed_text(&self, speed: f64) -> String {
        if self.turns {
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
        if let (Some(work), Some(put_in)) = (all.work(), all.put_in)
            && work < -NOTHING * put_in
        {
            let work = significant(-work, DIGITS);
            texts.push(words().mechanism_drives(&self.driver, &work));
        }
        if !duty.dead_points.is_empty() {
            let places = listed(&duty.dead_points);
            texts.push(match duty.runs_dead {
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

    /// Torque, power and energy, in all and by what acts.
    fn effects(&self, duty: &Duty) -> Table {
        let cycle = &duty.cycle;
        let [load, gravity, inertia] = &cycle.parts;
        let parts = [
            (words().loads(), load),
            (words().gravity(), gravity),
            (words().inertia(), inertia),
        ];
        let parts = parts.into_iter();
        let acting = parts.filter(|(_, effect)| !effect.is_nothing_beside(&cycle.parts));
        let all = std::iter::once((words().label_all(), &cycle.all));
        let (names, columns): (Vec<&str>, Vec<&DriveEffort>) = all.chain(acting).unzip();
        let what = self.effort();
        let mut table = columns_of(format!("{what} [{}]", self.effort_unit()), names);
        let larger = |a: Option<Peak>, b: Option<Peak>| Some(a?.value.abs().max(b?.value.abs()));
        let torque = |e: &DriveEffort| larger(e.largest, e.least);
        let power = |e: &DriveEffort| larger(e.largest_power, e.least_power);
        let energy = |e: &DriveEffort| Some(e.put_in? + e.given_back?);
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
        let least = indented(words().label_least());
        let mean = indented(words().label_mean());
        let cells = |cell: &dyn Fn(&DriveEffort) -> String| -> Vec<String> {
            columns.iter().map(|effect| cell(effect)).collect()
        };
        table.row(largest.as_str(), cells(&|e| peak(e.largest, torque(e))));
        table.row(at.as_str(), cells(&|e| place(e, e.largest)));
        table.row(least.as_str(), cells(&|e| peak(e.least, torque(e))));
        table.row(at.as_str(), cells(&|e| place(e, e.least)));
        table.row(mean.as_str(), cells(&|e| figure(cleaned(e.mean, e.rms))));
        table.row(indented(words().label_rms()), cells(&|e| figure(e.rms)));
        table
            .rows
            .push(Row::Part(format!("{} [W]", words().power())));
        table.row(largest, cells(&|e| peak(e.largest_power, power(e))));
        table.row(least, cells(&|e| peak(e.least_power, power(e))));
        table.row(mean, cells(&|e| figure(mean_power(e))));
        table
            .rows
            .push(Row::Part(format!("{} [J]", words().label_energy())));
        table.row(
            indented(words().label_put_in()),
            cells(&|e| figure(cleaned(e.put_in, energy(e)))),
        );
        table.row(
            indented(words().label_given_back()),
            cells(&|e| figure(cleaned(e.given_back, energy(e)))),
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
        let is_enough = self.fit.is_enough();
        let verdict_text = match is_enough {
            Some(true) => words().enough().to_owned(),
            Some(false) => words().not_enough().to_owned(),
            None if self.fit.is_unbounded && is_known => words().not_judged(self.effort()),
            None => return,
        };
        let unit = self.effort_unit();
        let (scale, speeds) = if self.turns {
            (RPM, "rpm")
        } else {
            (1.0, "m/s")
        };
        let torque = |asked: &MotorDemand| verdict(asked, 1.0, unit);
        let speed = |asked: &MotorDemand| verdict(asked, scale, speeds);
        let flywheel = self.with_flywheel();
        let flywheel = flywheel.map(|asked| words().about_the_mean(&verdict(&asked, 1.0, unit)));
        let gear = self.fit.geared.filter(|_| is_enough == Some(false));
        let gear = gear.map(|gear| {
            let ratio = concise(gear.ratio, 4);
            match gear.is_enough {
                true => words().gear_enough(&ratio),
                false => words().gear_not_enough(&ratio),
            }
        });
        let told = [
            (words().rated_for_rms(), self.fit.rated.as_ref().map(torque)),
            (words().peak(), self.fit.peak.as_ref().map(torque)),
            (words().speed(), self.fit.speed.as_ref().map(speed)),
            (words().with_flywheel(), flywheel),
            (words().with_a_gear(), gear),
        ];
        page.heading(words().motor_is(&verdict_text));
        page.add(known(told));
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
        let wished = evenness.wished.map(|(fluctuation, inertia)| {
            let (wished, inertia) = (concise(fluctuation, DIGITS), significant(inertia, DIGITS));
            rough(words().takes_a_flywheel(&wished, &inertia), fluctuation)
        });
        let told = [
            (words().label_energy(), Some(energy)),
            (words().flywheel(), flywheel),
            (words().fluctuation(), wished),
        ];
        page.heading(words().evenness());
        page.add(known(told));
    }

    fn add_shaking(&self, cycle: &Cycle, page: &mut Page) {
        let shaking = &cycle.shaking;
        let none = words().no_joint_forces().to_owned();
        let size = |v: f64| significant(v, DIGITS);
        // What is as large in the mean as at its largest is so throughout.
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
        let told = [(words().force(), force), (words().moment(), moment)];
        page.add(indented_facts(told));
    }

    fn add_ram(&self, report: &RamReport, page: &mut Page) {
        let ram = &report.ram;
        let (unit, way) = (self.unit, &self.driver_unit);
        let mut list: Vec<(&str, String)> = Vec::new();
        let end = match ram.end.is_known {
            true => words().works_at(end_word(ram.end.end)),
            false => words().works_at_by_convention(end_word(ram.end.end)),
        };
        list.push((words().ram_works(), end));
        list.push((
            words().stroke(),
            format!("{} {unit}", concise(ram.stroke, 9)),
        ));
        let others = ram
            .others
            .iter()
            .map(|centre| (words().turns_too(), centre));
        let ends = [(words().bottom(), &ram.bottom), (words().top(), &ram.top)];
        for (label, centre) in ends.into_iter().chain(others) {
            let at = format!("{:.ALL_DECIMALS$}", centre.at);
            let position = concise(centre.position, 9);
            list.push((label, words().centre_at(&at, way, &position, unit)));
        }
        let [closing, opening] = ram.ways;
        let times = |gone: f64| {
            let seconds = ram.seconds.map(|s| s * gone / (closing + opening));
            timed(format!("{} {way}", significant(gone, DIGITS)), seconds)
        };
        list.push((words().closes_in(), times(closing)));
        list.push((words().opens_in(), times(opening)));
        let ratio = significant(ram.time_ratio(), DIGITS);
        list.push((words().time_ratio(), words().closing_to_opening(&ratio)));
        if let Some(strokes) = ram.strokes_per_minute() {
            let text = words().a_minute(&significant(strokes, DIGITS));
            list.push((words().strokes(), text));
        }
        page.heading(words().ram_named(&report.name));
        page.add(indented_facts(list));
        self.add_height(report, page);
        if let Some((tolerance, dwell)) = &report.dwell {
            let tolerance = format!("{} {unit}", concise(*tolerance, DIGITS));
            let text = dwell.map_or_else(none, |d| {
                let gone = timed(format!("{} {way}", significant(d.way, DIGITS)), d.seconds);
                let [from, to] = [d.from, d.to].map(|at| format!("{at:.DECIMALS$}"));
                words().dwells_within(&gone, &from, &to, &tolerance)
            });
            page.add_below(indented_facts([(words().dwells(), text)]));
        }
    }

    fn add_height(&self, report: &RamReport, page: &mut Page) {
        let Some((height, passings)) = &report.height else {
            return;
        };
        let unit = self.unit;
        let label = words().at_height(&concise(*height, DIGITS), unit);
        let Some(both) = passings else {
            let stroke = significant(report.ram.stroke, DIGITS);
            let text = words().ram_never_there(&stroke, unit);
            page.add_below(indented_facts([(label.as_str(), text)]));
            return;
        };
        let sized = |v: f64| figure(Some(v).filter(|v| v.is_finite()));
        let ways = [words().closing(), words().opening_way()];
        let mut table = columns_of(indented(&label), ways);
        let mut row = |label: String, cell: &dyn Fn(&Passing) -> String| {
            table.row(label, both.iter().map(cell));
        };
        let driver = format!("    {} [{}]", words().driver(), self.driver_unit);
        row(driver, &|p| format!("{:.DECIMALS$}", p.at));
        let place = format!("    {} [{unit}]", words().label_place());
        row(place, &|p| sized(p.position));
        row(format!("    v [{unit}/s]"), &|p| sized(p.velocity));
        row(format!("    a [{unit}/s^2]"), &|p| sized(p.acceleration));
        let by = self.effort_unit();
        match report.torque {
            Some(torque) => {
                let force = format!("    {} [N]", words().force());
                row(force, &|p| sized(torque * p.leverage));
            }
            None => {
                let ratio = format!("    {}", words().newtons_per(by));
                row(ratio, &|p| sized(p.leverage));
            }
        }
        page.add_below(Content::Table(table));
        if let Some(torque) = report.torque {
            let effort = format!("{} {by}", concise(torque, DIGITS));
            page.text_below(format!("    {}", words().force_held_by(&effort)));
        }
        if both.iter().any(|passing| !passing.leverage.is_finite()) {
            page.text_below(format!("    {}", words().force_unbounded()));
        }
    }

    fn place(&self, peak: &Peak) -> String {
        let at = if self.turns {
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
        match (self.turns, peak.back) {
            (true, false) => format!("{:.DECIMALS$}", peak.at),
            (false, false) => significant(peak.at, DIGITS),
            // Shorter, so that the word has room.
            (true, true) => words().back_at(&format!("{:.1}", peak.at)),
            (false, true) => words().back_at(&significant(peak.at, 4)),
        }
    }
}

/// A label below a heading.
fn indented(label: &str) -> String {
    format!("  {label}")
}

/// What is told below a heading.
fn indented_facts<'l>(told: impl IntoIterator<Item = (&'l str, String)>) -> Content {
    let told = told.into_iter();
    facts(told.map(|(label, text)| (indented(label), text)))
}

/// The same of what there is.
fn known<'l>(told: impl IntoIterator<Item = (&'l str, Option<String>)>) -> Content {
    let told = told.into_iter();
    indented_facts(told.filter_map(|(label, text)| Some((label, text?))))
}

/// A way, and the time that it takes where that is known.
fn timed(way: String, seconds: Option<f64>) -> String {
    match seconds {
        Some(seconds) => words().in_seconds(&way, &significant(seconds, DIGITS)),
        None => way,
    }
}

/// Labels, and what is told of each.
fn facts(told: impl IntoIterator<Item = (String, String)>) -> Content {
    let mut facts = Facts {
        names: LABEL + 1,
        ..Facts::default()
    };
    for (label, text) in told {
        facts.tell(&label, [text]);
    }
    Content::Facts(facts)
}

/// A table whose first columns say most: a narrow screen shows no more than it can.
fn columns_of<'h>(title: String, heads: impl IntoIterator<Item = &'h str>) -> Table {
    Table::new(title, heads).set(Setting {
        names: LABEL,
        least: vec![FIGURE],
        rest: Rest::LeftOut,
        called: TextRole::Label,
        ..Setting::default()
    })
}

/// What stands for a figure that does not exist.
fn none() -> String {
    "-".into()
}

fn figure(value: Option<f64>) -> String {
    value.map_or_else(none, |v| significant(v, DIGITS))
}

/// To all digits, without zeros at the end: a speed comes back from radians as it was given.
fn trimmed(value: f64) -> String {
    let text = significant(value, DIGITS);
    if text.contains('.') && !text.contains('e') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// 0 for what rounding has left of figures of a size.
fn cleaned(value: Option<f64>, size: Option<f64>) -> Option<f64> {
    let size = size.unwrap_or(0.0);
    value.map(|v| if v.abs() <= NOTHING * size { 0.0 } else { v })
}

/// Whether a motor has what is asked, and what is left or how much of it that is; one of its own unit is so many of that
/// which is told.
fn verdict(asked: &MotorDemand, scale: f64, unit: &str) -> String {
    let [wants, has, left] =
        [asked.asked, asked.has, asked.lacks().abs()].map(|v| trimmed(v * scale));
    let [has, left] = [has, left].map(|size| format!("{size} {unit}"));
    let share = asked.has / asked.asked;
    match (asked.is_enough(), share.is_finite()) {
        (true, true) => words().has_left_by_times(&has, &wants, &left, &significant(share, 3)),
        (true, false) => words().has_left(&has, &wants, &left),
        (false, _) => words().has_a_share(&has, &wants, &percent(share)),
    }
}

/// What is less than the whole is never told as 100 %.
fn percent(share: f64) -> String {
    match share {
        0.1.. => concise((1000.0 * share).floor() / 10.0, 3),
        _ => concise(100.0 * share, 2),
    }
}

/// Whether it is the same all the way, but for rounding.
fn is_constant(effect: &DriveEffort) -> bool {
    let both = effect.largest.zip(effect.least);
    both.is_some_and(|(most, least)| {
        let size = most.value.abs().max(least.value.abs());
        most.value - least.value <= NOTHING * size
    })
}

/// What is said of a fluctuation, and that a large one is no more than a rough figure.
fn rough(says: String, fluctuation: f64) -> String {
    match fluctuation > SMALL_FLUCTUATION {
        true => words().roughly(&says),
        false => says,
    }
}

fn rule_text(cycle: &Cycle, what: &str) -> String {
    let error = significant(cycle.error, 2);
    match cycle.rule {
        Rule::Periodic(places) => words().trapezoids(&places, &error, what),
        Rule::Pieces(pieces) => words().polynomials(&pieces, &error, what),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_enough_is_less_than_the_whole() {
        for (share, told) in [
            (0.998, "99.8"),
            (0.9999, "99.9"),
            (0.5, "50"),
            (0.1234, "12.3"),
            (0.0567, "5.7"),
            (0.0, "0"),
        ] {
            assert_eq!(percent(share), told);
        }
    }
}
