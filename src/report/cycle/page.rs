//! Formats the behaviour of values over the motion as a page.

use crate::page::{Content, Facts, Page, TextStyle};
use crate::quantity::{Quantity, rate_unit};
use crate::report::cycle::{CycleReport, FollowedColumn, WorstPlace};
use crate::report::tables::entry::{display_bound, display_value};
use crate::report::text::number::{concise, known_digits, perpendicular_up, significant};
use crate::report::text::places::place_text;
use crate::scene::Scene;
use crate::solver::{Range, Solver};
use crate::study::{DwellStretch, Excursion, ExtremumPlace, FigurePlace, NoFigure, TimeRatio};
use crate::wording::{Language, words};

/// Widths of the labels on a page and in the narrow form.
const LABEL: usize = 14;
const NARROW: usize = 12;
/// Significant digits of an exactly solved value, and of a rate.
const ALL: usize = 9;
const DIGITS: usize = 6;
/// Significant digits of a dwell.
const SOME: usize = 5;
/// Significant digits of a bound.
const BOUND_DIGITS: usize = 2;
/// Places closer to 0 than this fraction of the motion are shown as 0.
const PLACE_TOLERANCE: f64 = 1e-12;
/// Maximum number of turning places in a line.
const MAX_TURNS: usize = 4;
/// Significant digits of a tolerance.
const TOLERANCE_DIGITS: usize = 3;

impl CycleReport {
    /// Formats the report as text; `ascii` restricts the title to ASCII.
    #[must_use]
    pub fn to_text(&self, ascii: bool) -> String {
        self.page().to_text(TextStyle::plain(ascii))
    }

    /// Returns the whole report as a page.
    #[must_use]
    pub fn page(&self) -> Page {
        let mut page = Page::aligned();
        page.title(&words().translated_scene_text(&self.scene));
        let speed = self.rate_text(self.speed);
        page.text_below(match self.range {
            Range::Full { .. } => words().cycle_goes_round(&speed, &self.range_text),
            Range::Limited { .. } => words().cycle_of_range(&speed, &self.range_text),
        });
        if self.is_timed {
            page.text_below(words().cycle_leaves_motion_out().to_owned());
        }
        if self.figures.is_empty() {
            page.text_below(words().nothing_to_follow().to_owned());
        }
        for column in &self.figures {
            let unit = &column.quantity.unit;
            let unit = if unit.is_empty() { "-" } else { unit };
            page.heading(format!("{} [{unit}]", column.quantity.name));
            page.add(self.column_content(column));
        }
        self.add_motion_values(&mut page);
        page
    }

    fn rate_text(&self, speed: f64) -> String {
        let unit = rate_unit(&self.driver.unit);
        format!("{} {unit}", concise(speed.abs(), DIGITS))
    }

    fn add_motion_values(&self, page: &mut Page) {
        if self.transmission.is_empty() && self.condition.is_empty() {
            return;
        }
        let mut facts = labelled();
        let at = |worst: &WorstPlace| place_text(worst.at, &self.driver.unit);
        let angles = self.transmission.iter().map(|worst| {
            let [minimum, off] = [worst.least, 90.0 - worst.least].map(|v| format!("{v:.2}"));
            words().off_the_best(&worst.group, &off, &minimum, &at(worst))
        });
        facts.add(&indented(words().label_transmission()), angles);
        let conditions = self.condition.iter();
        let conditions = conditions.map(|worst| worst.condition_text(&self.driver.unit));
        facts.add(&indented(words().label_condition()), conditions);
        page.heading(words().mechanism_as_a_whole().to_owned());
        page.add(Content::Facts(facts));
    }

    fn column_content(&self, column: &FollowedColumn) -> Content {
        let mut facts = labelled();
        let is_angle = column.quantity.unit == "deg";
        let label = match is_angle {
            true => words().label_swing(),
            false => words().label_stroke(),
        };
        match &column.excursion {
            Err(why) => facts.add(&indented(label), [self.none(*why)]),
            Ok(excursion) if excursion.is_level() || column.is_rounding(excursion) => {
                let value = self.value_text(column, excursion.greatest);
                let text = words().stays_at(&value);
                facts.add(&indented(label), [text]);
            }
            Ok(excursion) => self.add_column((column, excursion), label, &mut facts),
        }
        Content::Facts(facts)
    }

    fn add_column(
        &self,
        (column, excursion): (&FollowedColumn, &Excursion),
        label: &str,
        facts: &mut Facts,
    ) {
        let unit = &column.quantity.unit;
        let stroke = self.stroke_text(column, excursion);
        facts.add(&indented(label), [stroke]);
        let turns = excursion
            .turnings
            .iter()
            .map(|turn| self.turn_text(turn, column));
        facts.add(&indented(words().label_turns()), turns);
        let ratio = match excursion.ratio {
            Ok(ratio) => Some(self.ratio_text(ratio)),
            Err(NoFigure::TurnsRound | NoFigure::Stands) => None,
            Err(why) => Some(self.none(why)),
        };
        facts.add(&indented(words().label_ratio()), ratio);
        if let Some((tolerance, dwells)) = &excursion.dwells {
            let tolerance = format!("{} {unit}", concise(*tolerance, TOLERANCE_DIGITS));
            let text = dwells
                .iter()
                .map(|d| self.dwell_text(d, &tolerance, column));
            let mut text: Vec<String> = text.collect();
            if text.is_empty() {
                text.push(words().never_dwells().to_owned());
            }
            facts.add(&indented(words().label_dwells()), text);
        }
        let rate = rate_unit(unit);
        let fastest = self.rate_place(excursion.fastest, &rate);
        facts.add(&indented(words().label_fastest()), [fastest]);
        let hardest = self.rate_place(excursion.hardest, &rate_unit(&rate));
        facts.add(&indented(words().label_hardest()), [hardest]);
    }

    /// Formats the stroke of a value, or its number of full turns.
    fn stroke_text(&self, column: &FollowedColumn, excursion: &Excursion) -> String {
        let unit = &column.quantity.unit;
        match excursion.stroke() {
            Ok(stroke) => {
                let ends = [excursion.least.at, excursion.greatest.at];
                let limits: f64 = ends.map(|at| self.limit_bound(column, at)).iter().sum();
                let value = concise(stroke, known_digits(stroke, limits, ALL));
                self.bounded(format!("{value} {unit}"), column.stroke_bound(excursion))
            }
            Err(_) if excursion.revolutions.abs() == 1.0 => words().turns_round_once().to_owned(),
            Err(_) => {
                words().turns_round_times(&concise(excursion.revolutions.abs(), TOLERANCE_DIGITS))
            }
        }
    }

    /// Returns a line for every value: stroke or swing, turning places, and time ratio.
    pub(in crate::report) fn lines(&self) -> impl Iterator<Item = String> {
        self.figures.iter().map(|column| {
            let name = &column.quantity.name;
            match &column.excursion {
                Err(why) => format!("{name}: {}", self.none(*why)),
                Ok(excursion) => format!("{name}: {}", self.line(column, excursion)),
            }
        })
    }

    fn line(&self, column: &FollowedColumn, excursion: &Excursion) -> String {
        let unit = &column.quantity.unit;
        if excursion.is_level() {
            let value = self.value_text(column, excursion.greatest);
            return words().stays_at(&value);
        }
        let stroke = self.stroke_text(column, excursion);
        let mut lines = vec![match (excursion.stroke(), unit.as_str()) {
            (Err(_), _) => stroke,
            (Ok(_), "deg") => format!("{} {stroke}", words().label_swing()),
            (Ok(_), _) => format!("{} {stroke}", words().label_stroke()),
        }];
        // If there are many turning places, only the extrema are listed.
        let turnings = excursion.turnings.iter();
        let extremes = [excursion.least.at, excursion.greatest.at];
        let is_shown = |turn: &&ExtremumPlace| {
            excursion.turnings.len() <= MAX_TURNS || extremes.contains(&turn.place.at)
        };
        let turnings = turnings.filter(is_shown);
        lines.extend(turnings.map(|turn| self.turn_text(turn, column)));
        if let Ok(ratio) = excursion.ratio {
            let ratio = self.ratio_text(ratio);
            lines.push(format!("{} {ratio}", words().label_ratio()));
        }
        lines.join("; ")
    }

    fn brief(&self, column: &FollowedColumn) -> Vec<String> {
        let unit = &column.quantity.unit;
        let excursion = match &column.excursion {
            Ok(excursion) => excursion,
            Err(why) => return vec![self.none(*why)],
        };
        let label = match unit.as_str() {
            "deg" => words().label_swing(),
            _ => words().label_stroke(),
        };
        let sized = |value: f64, unit: &str| format!("{} {unit}", concise(value, DIGITS));
        let stroke = excursion.stroke().map(|stroke| sized(stroke, unit));
        let ratio = excursion.ratio.map(|ratio| concise(ratio.value, DIGITS));
        let dwells = excursion.dwells.iter().flat_map(|(_, dwells)| dwells);
        let dwell = dwells.map(|dwell| dwell.travel).max_by(f64::total_cmp);
        let dwell = dwell.map(|path| format!("{} {}", concise(path, SOME), self.driver.unit));
        let fastest = excursion
            .fastest
            .map(|place| sized(place.value, &rate_unit(unit)));
        let stroke = (label, stroke.map_err(Some));
        let turns = (
            words().label_turns(),
            Ok(excursion.turnings.len().to_string()),
        );
        let text = [
            turns,
            (words().label_ratio(), ratio.map_err(Some)),
            (words().label_dwells(), dwell.ok_or(None)),
            (words().label_fastest(), fastest.map_err(Some)),
        ];
        // A constant value has no further properties.
        let text = text.into_iter().filter(|_| !excursion.is_level());
        let lines = [stroke].into_iter().chain(text);
        let lines = lines.filter_map(|(label, value)| match value {
            Ok(value) => Some(format!("{label:NARROW$}{value}")),
            Err(Some(why)) => Some(format!("{label:NARROW$}{}", self.none(why))),
            Err(None) => None,
        });
        lines.collect()
    }

    /// Formats a value at a place: with no more digits than known at a limit, and as 0 if it is
    /// within its bound.
    fn value_text(&self, column: &FollowedColumn, place: FigurePlace) -> String {
        let bound = column.bound_at(place.at);
        let value = display_value(place.value, bound);
        let digits = known_digits(value, self.limit_bound(column, place.at), ALL);
        let text = format!("{} {}", concise(value, digits), column.quantity.unit);
        self.bounded(text, display_bound(place.value, bound))
    }

    /// Appends the bound to a value if bounds were requested.
    fn bounded(&self, value: String, bound: Option<f64>) -> String {
        match (self.shows_bounds, bound) {
            (false, _) => value,
            (true, Some(bound)) => format!("{value} +- {}", perpendicular_up(bound, BOUND_DIGITS)),
            (true, None) => format!("{value} +- ?"),
        }
    }

    /// Returns the error bound of a value at a limit of the motion: 0 elsewhere, infinite if
    /// nothing was proved.
    fn limit_bound(&self, column: &FollowedColumn, at: f64) -> f64 {
        match self.range {
            Range::Limited { low, high } if at == low || at == high => {
                column.bound_at(at).unwrap_or(f64::INFINITY)
            }
            Range::Limited { .. } | Range::Full { .. } => 0.0,
        }
    }

    fn turn_text(&self, turn: &ExtremumPlace, column: &FollowedColumn) -> String {
        let value = self.value_text(column, turn.place);
        let at = place_text(turn.place.at, &self.driver.unit);
        let until = turn.until.map(|at| place_text(at, &self.driver.unit));
        let text = match (turn.is_peak, until) {
            (true, None) => words().peak_at(&value, &at),
            (false, None) => words().dip_at(&value, &at),
            (true, Some(until)) => words().peak_between(&value, &at, &until),
            (false, Some(until)) => words().dip_between(&value, &at, &until),
        };
        match turn.is_limit {
            true => words().limit_of_driver(&text),
            false => text,
        }
    }

    fn ratio_text(&self, ratio: TimeRatio) -> String {
        let unit = if ratio.are_times {
            "s"
        } else {
            &self.driver.unit
        };
        let paths = ratio
            .travels
            .map(|path| format!("{} {unit}", significant(path, DIGITS)));
        let value = concise(ratio.value, ALL);
        words().slow_by_quick(&value, &paths[0], &paths[1], ratio.rises_slowly)
    }

    fn dwell_text(&self, dwell: &DwellStretch, tolerance: &str, column: &FollowedColumn) -> String {
        let unit = &self.driver.unit;
        let path = format!("{} {unit}", significant(dwell.travel, SOME));
        let path = match dwell.seconds {
            Some(seconds) => words().in_seconds(&path, &significant(seconds, SOME)),
            None => path,
        };
        let (low, high) = self.range.ends();
        let place = |at: f64| match at.abs() <= PLACE_TOLERANCE * (high - low) {
            true => significant(0.0, SOME),
            false => significant(at, SOME),
        };
        let [from, to] = [dwell.from, dwell.to].map(place);
        let about = dwell.about.place;
        let of = concise(display_value(about.value, column.bound_at(about.at)), SOME);
        let path = match dwell.counts_twice {
            true => words().way_there_and_back(&path),
            false => path,
        };
        words().stays_within(&path, &from, &to, tolerance, &of)
    }

    fn rate_place(&self, place: Result<FigurePlace, NoFigure>, unit: &str) -> String {
        match place {
            Ok(place) => {
                let value = format!("{} {unit}", significant(place.value, DIGITS));
                words().value_at(&value, &place_text(place.at, &self.driver.unit))
            }
            Err(why) => self.none(why),
        }
    }

    fn none(&self, why: NoFigure) -> String {
        words().not_there(&self.reason(why, Language::current_language()))
    }
}

/// Describes one value over the motion: its main properties in a few short lines, and the whole
/// page.
#[cfg_attr(
    not(feature = "tui"),
    allow(dead_code, reason = "said in the workbench")
)]
pub(crate) fn brief_cycle(
    scene: &Scene,
    solver: &Solver,
    quantity: &Quantity,
) -> (Vec<String>, Page) {
    let report = CycleReport::of_columns(scene, solver, std::slice::from_ref(quantity), None);
    let figures = report.figures.iter();
    let lines = figures.flat_map(|column| report.brief(column)).collect();
    (lines, report.page())
}

/// Indents a label below a heading.
pub(in crate::report) fn indented(label: &str) -> String {
    format!("  {label}")
}

fn labelled() -> Facts {
    Facts {
        names: LABEL + 1,
        ..Facts::default()
    }
}
