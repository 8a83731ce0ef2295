//! The motor over a cycle, to be read.

use super::motor::{MotorReport, NOTHING, RamReport, end_word};
use super::number::{concise, significant};
use crate::page::{Content, Facts, Page, Rest, Role, Row, Setting, Table, TextStyle};
use crate::study::motor::{
    Asked, Cycle, Duty, Effect, NoDuty, Passing, Peak, Rule, SMALL_FLUCTUATION,
};

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
        page.title(&self.scene);
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
            NoDuty::NothingActs => {
                "nothing acts: the scene has no load and no mass, so the driver does no work".into()
            }
            NoDuty::Withheld(hidden) => {
                format!("no figures: {}", hidden.text(&self.driver_unit))
            }
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
        let rule = rule_text(cycle, self.effort_word());
        page.add(facts([("integrals", rule)]));
    }

    /// What is asked of a motor, in a sentence.
    fn asked_text(&self, duty: &Duty) -> String {
        let cycle = &duty.cycle;
        let unit = self.effort_unit();
        let course = self.course_text(duty);
        let asked = match (cycle.all.worst(), cycle.all.rms) {
            (Some(worst), Some(_)) if is_constant(&cycle.all) => {
                format!(
                    "asks {} {unit} throughout",
                    significant(worst.value, DIGITS)
                )
            }
            (Some(worst), Some(rms)) => format!(
                "asks {} {unit} at {}, the worst instant; {} {unit} RMS",
                significant(worst.value, DIGITS),
                self.place(&worst),
                significant(rms, DIGITS)
            ),
            _ => format!(
                "asks for more than any motor has: there is no largest {} and no RMS",
                self.effort_word()
            ),
        };
        format!("{course}, {} {asked}", self.driver)
    }

    /// The cycle in words.
    fn course_text(&self, duty: &Duty) -> String {
        let course = &duty.cycle.course;
        let way = match (course.goes_round, duty.turns()) {
            (true, 1.0) => "over a turn".to_owned(),
            (true, turns) => format!("over {turns} turns"),
            (false, _) => format!(
                "from {} to {} {} and back",
                concise(course.low, 9),
                concise(course.high, 9),
                self.driver_unit
            ),
        };
        format!("{way} at {}", self.speed_text(self.speed.abs()))
    }

    /// What the driver does.
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
            format!("{} {}", places.join(" and "), self.driver_unit)
        };
        let (mut texts, cycle) = (Vec::new(), &duty.cycle);
        let all = &duty.cycle.all;
        if let (Some(work), Some(put_in)) = (all.work(), all.put_in)
            && work < -NOTHING * put_in
        {
            texts.push(format!(
                "the mechanism drives {}: it gives {} J a cycle",
                self.driver,
                significant(-work, DIGITS)
            ));
        }
        if !duty.dead_points.is_empty() {
            let what = if duty.runs_dead {
                "accelerations grow beyond all bounds, and a driver that keeps its speed never gets \
                 there: means and energies are of loads and gravity only"
            } else {
                "what the driver must do can grow beyond all bounds: its work and its mean exist, a \
                 peak and an RMS do not"
            };
            texts.push(format!(
                "dead points at {}: towards them {what}; a part of the motion has all figures",
                listed(&duty.dead_points)
            ));
        }
        if !duty.change_points.is_empty() {
            texts.push(format!(
                "change points at {}: the torque passes smoothly, forces in the joints may not",
                listed(&duty.change_points)
            ));
        }
        if !duty.cycle.has_converged() {
            let error = significant(duty.cycle.error, 2);
            texts.push(format!(
                "the integrals have not converged: they may be off by {error} of the largest {}",
                self.effort_word()
            ));
        }
        if !duty.unrepeated.is_empty() {
            let numbers: Vec<String> = duty.unrepeated.iter().map(usize::to_string).collect();
            let (loads, does) = match numbers.len() {
                1 => ("load", "does"),
                _ => ("loads", "do"),
            };
            let course = &cycle.course;
            texts.push(format!(
                "`over` of {loads} {} {does} not repeat: this is the cycle from {} to {} {}",
                numbers.join(" and "),
                concise(course.low, 9),
                concise(course.high, 9),
                self.driver_unit
            ));
        }
        if duty.is_cut_short {
            texts.push(
                "the loads repeat only after more than 64 turns: this is one period of the motion"
                    .into(),
            );
        }
        if !duty.is_steady {
            texts.push("the driver does not keep its speed: what its acceleration takes is part of inertia".into());
        }
        if self.speed == 0.0 {
            texts.push("the driver stands still: no power, and no time passes".into());
        }
        texts
    }

    /// Torque, power and energy, in all and by what acts.
    fn effects(&self, duty: &Duty) -> Table {
        let cycle = &duty.cycle;
        let [load, gravity, inertia] = &cycle.parts;
        let parts = [("loads", load), ("gravity", gravity), ("inertia", inertia)];
        let parts = parts.into_iter();
        let acting = parts.filter(|(_, effect)| !effect.is_nothing_beside(&cycle.parts));
        let all = std::iter::once(("all", &cycle.all));
        let (names, columns): (Vec<&str>, Vec<&Effect>) = all.chain(acting).unzip();
        let what = self.effort_word();
        let mut table = columns_of(format!("{what} [{}]", self.effort_unit()), names);
        let larger = |a: Option<Peak>, b: Option<Peak>| Some(a?.value.abs().max(b?.value.abs()));
        let torque = |e: &Effect| larger(e.largest, e.least);
        let power = |e: &Effect| larger(e.largest_power, e.least_power);
        let energy = |e: &Effect| Some(e.put_in? + e.given_back?);
        let peak = |peak: Option<Peak>, size| figure(cleaned(peak.map(|p| p.value), size));
        let place = |e: &Effect, peak: Option<Peak>| match peak {
            Some(_) if is_constant(e) => String::new(),
            peak => peak.map_or_else(none, |p| self.short_place(&p)),
        };
        let mean_power = |e: &Effect| {
            let work = cleaned(e.work(), energy(e))?;
            Some(work / duty.seconds()?)
        };
        let at = format!("    at [{}]", self.driver_unit);
        let cells = |cell: &dyn Fn(&Effect) -> String| -> Vec<String> {
            columns.iter().map(|effect| cell(effect)).collect()
        };
        table.row("  largest", cells(&|e| peak(e.largest, torque(e))));
        table.row(at.as_str(), cells(&|e| place(e, e.largest)));
        table.row("  least", cells(&|e| peak(e.least, torque(e))));
        table.row(at.as_str(), cells(&|e| place(e, e.least)));
        table.row("  mean", cells(&|e| figure(cleaned(e.mean, e.rms))));
        table.row("  RMS", cells(&|e| figure(e.rms)));
        table.rows.push(Row::Part("power [W]".into()));
        table.row("  largest", cells(&|e| peak(e.largest_power, power(e))));
        table.row("  least", cells(&|e| peak(e.least_power, power(e))));
        table.row("  mean", cells(&|e| figure(mean_power(e))));
        table.rows.push(Row::Part("energy [J]".into()));
        table.row("  put in", cells(&|e| figure(cleaned(e.put_in, energy(e)))));
        table.row(
            "  given back",
            cells(&|e| figure(cleaned(e.given_back, energy(e)))),
        );
        table.row("  work", cells(&|e| figure(cleaned(e.work(), energy(e)))));
        table
    }

    fn add_fit(&self, page: &mut Page) {
        let motor = &self.wishes.motor;
        let is_known = motor.rated.or(motor.peak).or(motor.speed).is_some();
        let is_enough = self.fit.is_enough();
        let verdict_text = match is_enough {
            Some(true) => "enough".to_owned(),
            Some(false) => "not enough".to_owned(),
            None if self.fit.is_unbounded && is_known => {
                format!("not judged: no largest {} exists", self.effort_word())
            }
            None => return,
        };
        let unit = self.effort_unit();
        let (scale, speeds) = if self.turns {
            (RPM, "rpm")
        } else {
            (1.0, "m/s")
        };
        let torque = |asked: &Asked| verdict(asked, 1.0, unit);
        let speed = |asked: &Asked| verdict(asked, scale, speeds);
        let flywheel = self.with_flywheel();
        let flywheel =
            flywheel.map(|asked| format!("about the mean: {}", verdict(&asked, 1.0, unit)));
        let gear = self.fit.geared.filter(|_| is_enough == Some(false));
        let gear = gear.map(|gear| {
            let does = if gear.is_enough {
                "would be enough"
            } else {
                "would not do either"
            };
            let ratio = concise(gear.ratio, 4);
            format!("{ratio} to 1 brings it down to the driver's speed: it {does}")
        });
        let told = [
            ("  rated for RMS", self.fit.rated.as_ref().map(torque)),
            ("  peak", self.fit.peak.as_ref().map(torque)),
            ("  speed", self.fit.speed.as_ref().map(speed)),
            ("  with flywheel", flywheel),
            ("  with a gear", gear),
        ];
        page.heading(format!("motor: {verdict_text}"));
        let told = told.into_iter();
        page.add(facts(told.filter_map(|(label, text)| Some((label, text?)))));
    }

    fn add_evenness(&self, duty: &Duty, page: &mut Page) {
        let Some(fluctuation) = duty.cycle.fluctuation else {
            return;
        };
        let degrees = |at: f64| format!("{at:.DECIMALS$} {}", self.driver_unit);
        let energy = format!(
            "{} J up and down: slowest at {}, fastest at {}",
            significant(fluctuation.energy, DIGITS),
            degrees(fluctuation.slowest),
            degrees(fluctuation.fastest)
        );
        let evenness = self.evenness().unwrap_or_default();
        let flywheel = evenness.with.map(|(inertia, fluctuation)| {
            format!(
                "of {} kg m^2 leaves a fluctuation of {}{}",
                concise(inertia, DIGITS),
                significant(fluctuation, 4),
                rough(fluctuation)
            )
        });
        let wished = evenness.wished.map(|(fluctuation, inertia)| {
            format!(
                "of {} takes a flywheel of {} kg m^2{}",
                concise(fluctuation, DIGITS),
                significant(inertia, DIGITS),
                rough(fluctuation)
            )
        });
        let told = [
            ("  energy", Some(energy)),
            ("  flywheel", flywheel),
            ("  fluctuation", wished),
        ];
        page.heading("evenness");
        let told = told.into_iter();
        page.add(facts(told.filter_map(|(label, text)| Some((label, text?)))));
    }

    fn add_shaking(&self, cycle: &Cycle, page: &mut Page) {
        let shaking = &cycle.shaking;
        let none = "no figure: forces in the joints do not exist everywhere".to_owned();
        let size = |v: f64| significant(v, DIGITS);
        // What is as large in the mean as at its largest is so throughout.
        let is_same = |peak: &Peak, rms: f64| (peak.value.abs() - rms).abs() <= NOTHING * rms;
        let at = |peak: &Peak, rms: f64| match is_same(peak, rms) {
            true => " throughout".to_owned(),
            false => format!(" at {}", self.place(peak)),
        };
        let behind = |peak: &Peak, rms: f64, unit: &str| match is_same(peak, rms) {
            true => String::new(),
            false => format!("; {} {unit} RMS", size(rms)),
        };
        let force = shaking.force.zip(shaking.force_rms).zip(shaking.vector);
        let force = force.map_or(none.clone(), |((peak, rms), v)| {
            format!(
                "{} N{} ({}, {}){}",
                size(peak.value),
                at(&peak, rms),
                significant(v.x, 4),
                significant(v.y, 4),
                behind(&peak, rms, "N")
            )
        });
        let moment = shaking.moment.zip(shaking.moment_rms);
        let moment = moment.map_or(none, |(peak, rms)| {
            format!(
                "{} N m{} about the origin{}",
                size(peak.value),
                at(&peak, rms),
                behind(&peak, rms, "N m")
            )
        });
        page.heading("on the frame, loads included");
        page.add(facts([("  force", force), ("  moment", moment)]));
    }

    fn add_ram(&self, report: &RamReport, page: &mut Page) {
        let ram = &report.ram;
        let (unit, way) = (self.unit, &self.driver_unit);
        let mut list: Vec<(&str, String)> = Vec::new();
        let convention = if ram.end.is_known {
            ""
        } else {
            ", by convention"
        };
        let end = format!("at its {} position{convention}", end_word(ram.end.end));
        list.push(("  works", end));
        list.push(("  stroke", format!("{} {unit}", concise(ram.stroke, 9))));
        for (label, centre) in [("  bottom", &ram.bottom), ("  top", &ram.top)] {
            let position = concise(centre.position, 9);
            let text = format!(
                "{:.ALL_DECIMALS$} {way}, position {position} {unit}",
                centre.at
            );
            list.push((label, text));
        }
        for centre in &ram.others {
            let position = concise(centre.position, 9);
            let text = format!(
                "{:.ALL_DECIMALS$} {way}, position {position} {unit}",
                centre.at
            );
            list.push(("  turns too", text));
        }
        let [closing, opening] = ram.ways;
        let seconds = |share: f64| {
            let seconds = ram.seconds.map(|s| s * share / (closing + opening));
            seconds.map_or_else(String::new, |s| format!(", {} s", significant(s, DIGITS)))
        };
        let times = |gone: f64| format!("{} {way}{}", significant(gone, DIGITS), seconds(gone));
        list.push(("  closes in", times(closing)));
        list.push(("  opens in", times(opening)));
        let ratio = significant(ram.time_ratio(), DIGITS);
        list.push(("  time ratio", format!("{ratio}, closing to opening")));
        if let Some(strokes) = ram.strokes_per_minute() {
            let text = format!("{} a minute", significant(strokes, DIGITS));
            list.push(("  strokes", text));
        }
        page.heading(format!("ram {}", report.name));
        page.add(facts(list));
        self.add_height(report, page);
        if let Some((tolerance, dwell)) = &report.dwell {
            let within = format!("within {} {unit}", concise(*tolerance, DIGITS));
            let text = dwell.map_or_else(none, |d| {
                let seconds = d
                    .seconds
                    .map_or_else(String::new, |s| format!(", {} s", significant(s, DIGITS)));
                let [from, to] = [d.from, d.to].map(|at| format!("{at:.DECIMALS$}"));
                format!(
                    "{} {way}{seconds}: from {from} to {to}; {within} of the bottom",
                    significant(d.way, DIGITS)
                )
            });
            page.add_below(facts([("  dwells", text)]));
        }
    }

    fn add_height(&self, report: &RamReport, page: &mut Page) {
        let Some((height, passings)) = &report.height else {
            return;
        };
        let unit = self.unit;
        let label = format!("  at {} {unit}", concise(*height, DIGITS));
        let Some(both) = passings else {
            let stroke = significant(report.ram.stroke, DIGITS);
            let text = format!("the ram is never there: its stroke is {stroke} {unit}");
            page.add_below(facts([(label.as_str(), text)]));
            return;
        };
        let sized = |v: f64| figure(Some(v).filter(|v| v.is_finite()));
        let mut table = columns_of(label, ["closing", "opening"]);
        let mut row = |label: String, cell: &dyn Fn(&Passing) -> String| {
            table.row(label, both.iter().map(cell));
        };
        row(format!("    driver [{}]", self.driver_unit), &|p| {
            format!("{:.DECIMALS$}", p.at)
        });
        row(format!("    place [{unit}]"), &|p| sized(p.position));
        row(format!("    v [{unit}/s]"), &|p| sized(p.velocity));
        row(format!("    a [{unit}/s^2]"), &|p| sized(p.acceleration));
        let by = self.effort_unit();
        match report.torque {
            Some(torque) => row("    force [N]".into(), &|p| sized(torque * p.leverage)),
            None => row(format!("    N per {by}"), &|p| sized(p.leverage)),
        }
        page.add_below(Content::Table(table));
        if let Some(torque) = report.torque {
            let torque = concise(torque, DIGITS);
            page.text_below(format!(
                "    force: what {torque} {by} of the driver hold, without friction"
            ));
        }
        if both.iter().any(|passing| !passing.leverage.is_finite()) {
            page.text_below("    a dead centre: the force has no bound");
        }
    }

    fn place(&self, peak: &Peak) -> String {
        let back = if peak.back { " on the way back" } else { "" };
        let at = if self.turns {
            format!("{:.DECIMALS$}", peak.at)
        } else {
            significant(peak.at, DIGITS)
        };
        format!("{at} {}{back}", self.driver_unit)
    }

    fn short_place(&self, peak: &Peak) -> String {
        match (self.turns, peak.back) {
            (true, false) => format!("{:.DECIMALS$}", peak.at),
            (false, false) => significant(peak.at, DIGITS),
            // Shorter, so that the word has room.
            (true, true) => format!("{:.1} back", peak.at),
            (false, true) => format!("{} back", significant(peak.at, 4)),
        }
    }
}

/// Labels, and what is told of each.
fn facts<'l>(told: impl IntoIterator<Item = (&'l str, String)>) -> Content {
    let mut facts = Facts {
        names: LABEL + 1,
        ..Facts::default()
    };
    for (label, text) in told {
        facts.tell(label, [text]);
    }
    Content::Facts(facts)
}

/// A table whose first columns say most: a narrow screen shows no more than it can.
fn columns_of<'h>(title: String, heads: impl IntoIterator<Item = &'h str>) -> Table {
    Table::new(title, heads).set(Setting {
        names: LABEL,
        least: vec![FIGURE],
        rest: Rest::LeftOut,
        called: Role::Label,
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
fn verdict(asked: &Asked, scale: f64, unit: &str) -> String {
    let [wants, has, left] =
        [asked.asked, asked.has, asked.lacks().abs()].map(|v| trimmed(v * scale));
    let share = asked.has / asked.asked;
    match (asked.is_enough(), share.is_finite()) {
        (true, true) => {
            let times = significant(share, 3);
            format!("{has} {unit} for {wants}: {left} {unit} left ({times} times what is asked)")
        }
        (true, false) => format!("{has} {unit} for {wants}: {left} {unit} left"),
        (false, _) => {
            let share = concise(100.0 * share, 2);
            format!("{has} {unit} for {wants}: has {share} % of it")
        }
    }
}

/// Whether it is the same all the way, but for rounding.
fn is_constant(effect: &Effect) -> bool {
    let both = effect.largest.zip(effect.least);
    both.is_some_and(|(most, least)| {
        let size = most.value.abs().max(least.value.abs());
        most.value - least.value <= NOTHING * size
    })
}

/// What is to be said of a large fluctuation.
fn rough(fluctuation: f64) -> &'static str {
    if fluctuation > SMALL_FLUCTUATION {
        ", a rough figure: energy and speed go in proportion for small ones only"
    } else {
        ""
    }
}

fn rule_text(cycle: &Cycle, what: &str) -> String {
    let error = significant(cycle.error, 2);
    match cycle.rule {
        Rule::Periodic(places) => {
            format!("trapezoids at {places} places, good to {error} of the largest {what}")
        }
        Rule::Pieces(pieces) => {
            format!("polynomials on {pieces} pieces, good to {error} of the largest {what}")
        }
    }
}
