//! Formats the motion of a press's ram over the cycle.

use super::facts::{columns_of, figure, indented_facts, none, timed};
use super::{ALL_DECIMALS, DECIMALS, DIGITS};
use crate::page::{Content, Page};
use crate::report::cycle::page::indented;
use crate::report::motor::{MotorReport, RamReport, end_word};
use crate::report::text::number::{concise, significant};
use crate::study::motor::SlidePassing;
use crate::wording::words;

impl MotorReport {
    pub(super) fn add_ram(&self, report: &RamReport, page: &mut Page) {
        let ram = &report.ram;
        let (unit, path) = (self.unit, &self.driver_unit);
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
            list.push((label, words().centre_at(&at, path, &position, unit)));
        }
        let [closing, opening] = ram.travels;
        let times = |gone: f64| {
            let seconds = ram.seconds.map(|s| s * gone / (closing + opening));
            timed(format!("{} {path}", significant(gone, DIGITS)), seconds)
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
                let gone = timed(
                    format!("{} {path}", significant(d.travel, DIGITS)),
                    d.seconds,
                );
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
        let paths = [words().closing(), words().opening_way()];
        let mut table = columns_of(indented(&label), paths);
        let mut row = |label: String, cell: &dyn Fn(&SlidePassing) -> String| {
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
}
