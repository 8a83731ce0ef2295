//! The motor over a cycle in lines: for a page, and for a view of any width.

use super::motor::{MotorReport, NOTHING, RamReport, end_word};
use super::number::{concise, significant};
use super::text::{WIDTH, wrapped};
use crate::scene::sanitized;
use crate::study::motor::{Asked, Cycle, Duty, Effect, NoDuty, Peak, Rule, SMALL_FLUCTUATION};

/// Digits of a figure, and decimals of where it is in degrees.
const DIGITS: usize = 6;
const DECIMALS: usize = 3;
/// Decimals of a dead centre: as many as a double has at some hundred degrees.
const ALL_DECIMALS: usize = 12;
/// Columns of a label where there is room and where there is little, and of a figure.
const LABEL: usize = 18;
const SHORT_LABEL: usize = 15;
const ROOMY: usize = 60;
const FIGURE: usize = 12;
/// Turns a minute in 1 rad/s.
const RPM: f64 = 30.0 / std::f64::consts::PI;

/// A line of what was found.
#[derive(Clone, Debug, PartialEq)]
pub enum MotorLine {
    /// The head of a part, and of its columns.
    Head(String, Vec<String>),
    /// A label and its figures, the most important first: a narrow screen shows no more than it can.
    Figures(String, Vec<String>),
    /// A label and what is told of it.
    Fact(String, String),
    /// Something to read.
    Text(String),
    /// Between two parts.
    Blank,
}

impl MotorReport {
    /// As text for a person; the title in ASCII alone if asked, everything else always is.
    #[must_use]
    pub fn to_text(&self, ascii: bool) -> String {
        let mut text = sanitized(&self.scene, ascii) + "\n";
        for line in self.lines() {
            for line in line.at_width(WIDTH) {
                text.push_str(line.trim_end());
                text.push('\n');
            }
        }
        text
    }

    /// The lines of all parts.
    #[must_use]
    pub fn lines(&self) -> Vec<MotorLine> {
        let mut lines = Vec::new();
        match &self.duty {
            Ok(duty) => self.duty_lines(duty, &mut lines),
            Err(why) => lines.push(MotorLine::Text(self.nothing(why))),
        }
        if let Ok(ram) = &self.ram {
            self.ram_lines(ram, &mut lines);
        }
        lines
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

    fn duty_lines(&self, duty: &Duty, lines: &mut Vec<MotorLine>) {
        let cycle = &duty.cycle;
        lines.push(MotorLine::Text(self.asked_text(duty)));
        lines.extend(self.singular_texts(duty).into_iter().map(MotorLine::Text));
        lines.push(MotorLine::Blank);
        self.effect_lines(duty, lines);
        lines.push(MotorLine::Blank);
        self.fit_lines(lines);
        self.evenness_lines(duty, lines);
        self.frame_lines(cycle, lines);
        lines.push(MotorLine::Fact(
            "integrals".into(),
            rule_text(cycle, self.effort_word()),
        ));
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

    fn effect_lines(&self, duty: &Duty, lines: &mut Vec<MotorLine>) {
        let cycle = &duty.cycle;
        let [load, gravity, inertia] = &cycle.parts;
        let parts = [("loads", load), ("gravity", gravity), ("inertia", inertia)];
        let acting: Vec<_> = parts
            .into_iter()
            .filter(|(_, e)| !e.is_nothing_beside(&cycle.parts))
            .collect();
        let columns: Vec<&Effect> = [&cycle.all]
            .into_iter()
            .chain(acting.iter().map(|(_, e)| *e))
            .collect();
        let names: Vec<String> = ["all"]
            .into_iter()
            .chain(acting.iter().map(|(n, _)| *n))
            .map(str::to_owned)
            .collect();
        let what = self.effort_word();
        let row = |label: &str, cell: &dyn Fn(&Effect) -> String| {
            MotorLine::Figures(label.to_owned(), columns.iter().map(|e| cell(e)).collect())
        };
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
        lines.push(MotorLine::Head(
            format!("{what} [{}]", self.effort_unit()),
            names,
        ));
        lines.push(row("  largest", &|e| peak(e.largest, torque(e))));
        lines.push(row(&format!("    at [{}]", self.driver_unit), &|e| {
            place(e, e.largest)
        }));
        lines.push(row("  least", &|e| peak(e.least, torque(e))));
        lines.push(row(&format!("    at [{}]", self.driver_unit), &|e| {
            place(e, e.least)
        }));
        lines.push(row("  mean", &|e| figure(cleaned(e.mean, e.rms))));
        lines.push(row("  RMS", &|e| figure(e.rms)));
        lines.push(MotorLine::Head("power [W]".into(), Vec::new()));
        lines.push(row("  largest", &|e| peak(e.largest_power, power(e))));
        lines.push(row("  least", &|e| peak(e.least_power, power(e))));
        lines.push(row("  mean", &|e| figure(mean_power(e))));
        lines.push(MotorLine::Head("energy [J]".into(), Vec::new()));
        lines.push(row("  put in", &|e| figure(cleaned(e.put_in, energy(e)))));
        lines.push(row("  given back", &|e| {
            figure(cleaned(e.given_back, energy(e)))
        }));
        lines.push(row("  work", &|e| figure(cleaned(e.work(), energy(e)))));
    }

    fn fit_lines(&self, lines: &mut Vec<MotorLine>) {
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
        lines.push(MotorLine::Head(
            format!("motor: {verdict_text}"),
            Vec::new(),
        ));
        let facts = [
            ("  rated for RMS", self.fit.rated.as_ref().map(torque)),
            ("  peak", self.fit.peak.as_ref().map(torque)),
            ("  speed", self.fit.speed.as_ref().map(speed)),
        ];
        let known = facts
            .into_iter()
            .filter_map(|(label, text)| Some((label, text?)));
        lines.extend(known.map(|(label, text)| MotorLine::Fact(label.into(), text)));
        if let Some(asked) = &self.with_flywheel() {
            let text = format!("about the mean: {}", verdict(asked, 1.0, unit));
            lines.push(MotorLine::Fact("  with flywheel".into(), text));
        }
        if let (Some(gear), Some(false)) = (self.fit.geared, is_enough) {
            let does = if gear.is_enough {
                "would be enough"
            } else {
                "would not do either"
            };
            let ratio = concise(gear.ratio, 4);
            let text = format!("{ratio} to 1 brings it down to the driver's speed: it {does}");
            lines.push(MotorLine::Fact("  with a gear".into(), text));
        }
        lines.push(MotorLine::Blank);
    }

    fn evenness_lines(&self, duty: &Duty, lines: &mut Vec<MotorLine>) {
        let Some(fluctuation) = duty.cycle.fluctuation else {
            return;
        };
        let degrees = |at: f64| format!("{at:.DECIMALS$} {}", self.driver_unit);
        lines.push(MotorLine::Head("evenness".into(), Vec::new()));
        let text = format!(
            "{} J up and down: slowest at {}, fastest at {}",
            significant(fluctuation.energy, DIGITS),
            degrees(fluctuation.slowest),
            degrees(fluctuation.fastest)
        );
        lines.push(MotorLine::Fact("  energy".into(), text));
        let evenness = self.evenness().unwrap_or_default();
        if let Some((inertia, fluctuation)) = evenness.with {
            let text = format!(
                "of {} kg m^2 leaves a fluctuation of {}{}",
                concise(inertia, DIGITS),
                significant(fluctuation, 4),
                rough(fluctuation)
            );
            lines.push(MotorLine::Fact("  flywheel".into(), text));
        }
        if let Some((fluctuation, inertia)) = evenness.wished {
            let text = format!(
                "of {} takes a flywheel of {} kg m^2{}",
                concise(fluctuation, DIGITS),
                significant(inertia, DIGITS),
                rough(fluctuation)
            );
            lines.push(MotorLine::Fact("  fluctuation".into(), text));
        }
        lines.push(MotorLine::Blank);
    }

    fn frame_lines(&self, cycle: &Cycle, lines: &mut Vec<MotorLine>) {
        let shaking = &cycle.shaking;
        lines.push(MotorLine::Head(
            "on the frame, loads included".into(),
            Vec::new(),
        ));
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
        lines.push(MotorLine::Fact("  force".into(), force));
        lines.push(MotorLine::Fact("  moment".into(), moment));
        lines.push(MotorLine::Blank);
    }

    fn ram_lines(&self, report: &RamReport, lines: &mut Vec<MotorLine>) {
        let ram = &report.ram;
        let (unit, way) = (self.unit, &self.driver_unit);
        let fact = |label: &str, text: String| MotorLine::Fact(format!("  {label}"), text);
        lines.push(MotorLine::Blank);
        lines.push(MotorLine::Head(format!("ram {}", report.name), Vec::new()));
        let convention = if ram.end.is_known {
            ""
        } else {
            ", by convention"
        };
        let end = format!("at its {} position{convention}", end_word(ram.end.end));
        lines.push(fact("works", end));
        lines.push(fact("stroke", format!("{} {unit}", concise(ram.stroke, 9))));
        for (label, centre) in [("bottom", &ram.bottom), ("top", &ram.top)] {
            let position = concise(centre.position, 9);
            let text = format!(
                "{:.ALL_DECIMALS$} {way}, position {position} {unit}",
                centre.at
            );
            lines.push(fact(label, text));
        }
        for centre in &ram.others {
            let position = concise(centre.position, 9);
            let text = format!(
                "{:.ALL_DECIMALS$} {way}, position {position} {unit}",
                centre.at
            );
            lines.push(fact("turns too", text));
        }
        let [closing, opening] = ram.ways;
        let seconds = |share: f64| {
            let seconds = ram.seconds.map(|s| s * share / (closing + opening));
            seconds.map_or_else(String::new, |s| format!(", {} s", significant(s, DIGITS)))
        };
        let times = |gone: f64| format!("{} {way}{}", significant(gone, DIGITS), seconds(gone));
        lines.push(fact("closes in", times(closing)));
        lines.push(fact("opens in", times(opening)));
        let ratio = significant(ram.time_ratio(), DIGITS);
        lines.push(fact("time ratio", format!("{ratio}, closing to opening")));
        if let Some(strokes) = ram.strokes_per_minute() {
            lines.push(fact(
                "strokes",
                format!("{} a minute", significant(strokes, DIGITS)),
            ));
        }
        self.height_lines(report, lines);
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
            lines.push(fact("dwells", text));
        }
    }

    fn height_lines(&self, report: &RamReport, lines: &mut Vec<MotorLine>) {
        let Some((height, passings)) = &report.height else {
            return;
        };
        let unit = self.unit;
        let label = format!("  at {} {unit}", concise(*height, DIGITS));
        let Some(both) = passings else {
            let stroke = significant(report.ram.stroke, DIGITS);
            let text = format!("the ram is never there: its stroke is {stroke} {unit}");
            lines.push(MotorLine::Fact(label, text));
            return;
        };
        let row = |label: String, cell: &dyn Fn(usize) -> String| {
            MotorLine::Figures(label, vec![cell(0), cell(1)])
        };
        let sized = |v: f64| figure(Some(v).filter(|v| v.is_finite()));
        let names = ["closing", "opening"].map(str::to_owned).to_vec();
        lines.push(MotorLine::Head(label, names));
        lines.push(row(format!("    driver [{}]", self.driver_unit), &|i| {
            format!("{:.DECIMALS$}", both[i].at)
        }));
        lines.push(row(format!("    place [{unit}]"), &|i| {
            sized(both[i].position)
        }));
        lines.push(row(format!("    v [{unit}/s]"), &|i| {
            sized(both[i].velocity)
        }));
        lines.push(row(format!("    a [{unit}/s^2]"), &|i| {
            sized(both[i].acceleration)
        }));
        let by = self.effort_unit();
        match report.torque {
            Some(torque) => {
                lines.push(row("    force [N]".into(), &|i| {
                    sized(torque * both[i].leverage)
                }));
                let of = format!(
                    "force: what {} {by} of the driver hold",
                    concise(torque, DIGITS)
                );
                lines.push(MotorLine::Text(format!("    {of}, without friction")));
            }
            None => lines.push(row(format!("    N per {by}"), &|i| sized(both[i].leverage))),
        }
        if both.iter().any(|passing| !passing.leverage.is_finite()) {
            lines.push(MotorLine::Text(
                "    a dead centre: the force has no bound".into(),
            ));
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

impl MotorLine {
    /// The line at a width: figures that have no room are left out, words go on below.
    #[must_use]
    pub fn at_width(&self, width: usize) -> Vec<String> {
        match self {
            MotorLine::Blank => vec![String::new()],
            MotorLine::Text(text) => {
                let indent = text.len() - text.trim_start().len();
                let lines = wrapped(text, width.saturating_sub(indent).max(1)).into_iter();
                lines.map(|line| format!("{:indent$}{line}", "")).collect()
            }
            MotorLine::Head(label, cells) | MotorLine::Figures(label, cells) => {
                let first = label_width(width);
                let room = width.saturating_sub(first) / FIGURE;
                let mut line = format!("{label:first$}");
                for cell in cells.iter().take(room.max(1)) {
                    line.push_str(&format!("{cell:>FIGURE$}"));
                }
                vec![line]
            }
            MotorLine::Fact(label, text) => {
                let first = label_width(width);
                let room = width.saturating_sub(first + 1).max(1);
                let lines = wrapped(text, room).into_iter().enumerate();
                let label = |i| if i == 0 { label.as_str() } else { "" };
                lines
                    .map(|(i, line)| format!("{:first$} {line}", label(i)))
                    .collect()
            }
        }
    }

    /// Where in a line of this width, as [`MotorLine::at_width`] gives it, the label ends.
    #[must_use]
    pub fn label_end(text: &str, width: usize) -> usize {
        let end = label_width(width).min(text.len());
        if text.is_char_boundary(end) { end } else { 0 }
    }
}

/// Columns of a label on a page of this width.
fn label_width(width: usize) -> usize {
    if width < ROOMY { SHORT_LABEL } else { LABEL }
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
