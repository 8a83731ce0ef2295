//! Reports the effect of tolerances on values, at one coordinate of the driver or over the whole
//! motion, as text and for other programs.

use crate::page::{Content, Facts, Page, Setting, Table, TextStyle, with_unit};
use crate::quantity::{Catalogue, Quantity, length_name, state_word};
use crate::report::tables::data::number;
use crate::report::text::csv_dialect::{CsvDialect, CsvSheet, cell};
use crate::report::text::number::{concise, significant};
use crate::report::text::rows::RowCell;
use crate::scene::Scene;
use crate::solver::Condition;
use crate::study::{
    Contribution, Distribution, MotionTolerance, Percentiles, SampleOrder, Samples,
    ToleranceFigure, ToleranceOf, ToleranceStudy, WorstCase, WorstKind,
};
use crate::wording::{english_words, words};
use serde_json::{Map, Value, json};
use std::io::{self, Write};

/// Significant digits of a value, and of deviations.
const DIGITS: usize = 6;
const FEW_DIGITS: usize = 4;
/// Indent of the lines that belong to a value.
const INDENT: usize = 2;

/// The effect of tolerances on values, at one coordinate of the driver or over the whole motion.
#[derive(Clone, Debug)]
pub struct ToleranceReport {
    scene: String,
    /// The place; `None` for values of the whole motion.
    place: Option<PlaceReport>,
    /// The results for each value.
    pub figures: Vec<ToleranceRow>,
    samples: Option<SampleSummary>,
}

/// A coordinate of the driver, with the condition of the mechanism there.
#[derive(Clone, Debug)]
struct PlaceReport {
    driver: Quantity,
    at: f64,
    condition: Condition,
}

/// The effect of tolerances on a value.
#[derive(Clone, Debug)]
pub struct ToleranceRow {
    /// The name of the value.
    pub name: String,
    /// The unit of the value; empty if it has none.
    pub unit: String,
    /// The result; `None` if the value does not exist here.
    pub found: Option<ToleranceFigure>,
    /// The contributions, with the names of the contributors.
    pub contributions: Vec<(String, Contribution)>,
    /// The distribution among the samples.
    pub percentiles: Option<Percentiles>,
}

/// The results of all samples.
#[derive(Clone, Copy, Debug)]
struct SampleSummary {
    order: SampleOrder,
    open: f64,
    changed: Option<f64>,
}

impl ToleranceReport {
    /// Creates the report of a study of this scene at a coordinate, where the mechanism has this
    /// condition.
    #[must_use]
    pub fn at(
        scene: &Scene,
        study: &mut ToleranceStudy,
        at: f64,
        condition: Condition,
        samples: Option<SampleOrder>,
    ) -> Self {
        let found = study.at(at);
        let sampled = samples.map(|order| (order, study.sampled(at, order)));
        let names = study
            .figures()
            .iter()
            .map(|q| (q.name.clone(), q.unit.clone()));
        let place = PlaceReport {
            driver: Catalogue::new(scene).driver().clone(),
            at,
            condition,
        };
        ToleranceReport::of(scene, Some(place), names.zip(found), sampled)
    }

    /// Creates the report on values of the whole motion.
    #[must_use]
    pub fn for_motion(scene: &Scene, study: &mut MotionTolerance, samples: SampleOrder) -> Self {
        let found = study.found();
        let sampled = (samples, study.sampled(samples));
        let figures = study.figures().iter();
        let names = figures.map(|figure| (figure.name().to_owned(), figure.unit().to_owned()));
        ToleranceReport::of(scene, None, names.zip(found), Some(sampled))
    }

    fn of(
        scene: &Scene,
        place: Option<PlaceReport>,
        found: impl Iterator<Item = ((String, String), Option<ToleranceFigure>)>,
        sampled: Option<(SampleOrder, Samples)>,
    ) -> Self {
        let text = found.enumerate().map(|(i, ((name, unit), mut found))| {
            let of = |sampled: &(_, Samples)| sampled.1.figures.get(i).copied().flatten();
            let percentiles = sampled.as_ref().and_then(of);
            if let (Some(found), Some(percentiles), Some((order, _))) =
                (&mut found, &percentiles, &sampled)
            {
                found.with_samples(*order, percentiles);
            }
            let from = found.iter().flat_map(|found| &found.contributions);
            ToleranceRow {
                name,
                unit,
                contributions: from.map(|c| (contributor(scene, c.of), *c)).collect(),
                percentiles,
                found,
            }
        });
        ToleranceReport {
            scene: scene.name.clone(),
            place,
            figures: text.collect(),
            samples: sampled.map(|(order, samples)| SampleSummary {
                order,
                open: samples.open,
                changed: samples.changed,
            }),
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
        let mut page = Page::aligned();
        page.title(&words().translated_scene_text(&self.scene));
        page.text_below(match &self.place {
            Some(PlaceReport { driver, at, .. }) => {
                format!("{} {} {}", driver.name, concise(*at, 9), driver.unit)
            }
            None => words().over_the_whole_motion().to_owned(),
        });
        for text in &self.figures {
            self.add_figure(text, &mut page);
        }
        if let Some(samples) = &self.samples {
            page.add(Content::Facts(samples.facts()));
        }
        page
    }

    fn add_figure(&self, text: &ToleranceRow, page: &mut Page) {
        let mut facts = Facts::default();
        let header = with_unit(&text.name, &text.unit);
        let Some(found) = &text.found else {
            facts.add(&header, ["-".to_owned()]);
            page.add(Content::Facts(facts));
            return;
        };
        facts.add(&header, [significant(found.nominal, DIGITS)]);
        let mut tell = |label: &str, lines: Vec<String>| {
            facts.add(&format!("{:INDENT$}{label}", ""), lines);
        };
        tell(words().label_worst_case(), worst_text(found));
        let square = found.root_sum_square;
        let square = square.map(|square| format!("+-{}", significant(square, FEW_DIGITS)));
        let square = square.unwrap_or_else(|| words().no_first_order().into());
        tell(words().label_root_sum_square(), vec![square]);
        if let Some(percentiles) = &text.percentiles {
            tell(words().label_most_samples(), spread_text(percentiles));
        }
        page.add(Content::Facts(facts));
        if !text.contributions.is_empty() {
            page.add_below(Content::Table(text.table()));
        }
    }

    /// Writes a line for each number: `name,value,unit`. The names are those of the columns over
    /// the motion.
    ///
    /// # Errors
    /// Returns the errors of the writer.
    pub fn write_csv(&self, dialect: CsvDialect, to: impl Write) -> io::Result<()> {
        let mut csv = CsvSheet::new(dialect, to);
        csv.record(["name", "value", "unit"])?;
        if let Some(PlaceReport { driver, at, .. }) = &self.place {
            csv.record([&*driver.name, &cell(Some(*at)), &*driver.unit])?;
        }
        for text in &self.figures {
            for (name, value, unit) in text.lines() {
                csv.record([&*name, &*value, unit])?;
            }
        }
        if let Some(samples) = &self.samples {
            csv.record(["samples.open", &cell(Some(samples.open)), ""])?;
            csv.record(["samples.class-changed", &cell(samples.changed), ""])?;
        }
        if let Some(place) = &self.place {
            csv.record(["state", state_word(place.condition), ""])?;
        }
        csv.finish()
    }

    /// Returns the whole report as one object.
    #[must_use]
    pub fn to_json(&self) -> Value {
        let units = self.figures.iter();
        let units = units.map(|text| (text.name.clone(), text.unit.clone().into()));
        let figures = self.figures.iter();
        let figures = figures.map(|text| (text.name.clone(), text.to_json()));
        let samples = self.samples.as_ref().map(|samples| {
            json!({
                "count": samples.order.count,
                "seed": samples.order.seed,
                "distribution": distribution_word(samples.order.distribution),
                "open": number(Some(samples.open)),
                "class_changed": number(samples.changed),
            })
        });
        json!({
            "scene": self.scene,
            "units": Value::Object(units.collect()),
            "driver": self.place.as_ref().map(|place| {
                json!({ "name": place.driver.name, "at": number(Some(place.at)) })
            }),
            "state": self.place.as_ref().map(|place| state_word(place.condition)),
            "figures": Value::Object(figures.collect()),
            "samples": samples,
        })
    }
}

impl SampleSummary {
    fn facts(&self) -> Facts {
        let mut facts = Facts::default();
        let SampleOrder {
            count,
            seed,
            distribution,
        } = self.order;
        let spread = match distribution {
            Distribution::Normal => words().spread_normally(),
            Distribution::Even => words().spread_evenly(),
        };
        let open = match self.open {
            0.0 => words().samples_all_close().to_owned(),
            part => words().part_of_samples_open(&percent(part)),
        };
        let changed = self.changed.map(|changed| match changed {
            0.0 => words().samples_keep_class().to_owned(),
            part => words().part_of_samples_changed(&percent(part)),
        });
        let lines = [words().how_samples_are_made(count, spread, seed), open];
        facts.add(words().label_samples(), lines.into_iter().chain(changed));
        facts
    }
}

impl ToleranceRow {
    /// Returns the table of contributions.
    fn table(&self) -> Table {
        let headers = [
            words().head_tolerance(),
            words().head_per_unit(),
            words().head_off_by(),
            words().head_share(),
        ];
        let mut table = Table::new(words().label_contributions(), headers).set(Setting {
            indent: INDENT,
            least: vec![FEW_DIGITS + INDENT],
            ..Setting::default()
        });
        for (name, from) in &self.contributions {
            let share = percent(from.share);
            let cells = [
                concise(from.tolerance, FEW_DIGITS),
                significant(from.slope, FEW_DIGITS),
                significant(from.size, FEW_DIGITS),
                share,
            ];
            table.row(name.clone(), cells);
        }
        table
    }

    /// Returns all results with their names and units, as cells of CSV.
    fn lines(&self) -> Vec<(String, String, &str)> {
        let results = results(self.found.as_ref()).into_iter();
        let results = results.map(|(part, cell)| (part.to_owned(), cell));
        let samples = self.percentiles.iter().flat_map(percentiles);
        let samples = samples.map(|(part, value)| (part.to_owned(), RowCell::Number(Some(value))));
        let lines = results.chain(samples).map(|(part, result)| match result {
            RowCell::Number(value) => (part, cell(value), &*self.unit),
            RowCell::Word(word) => (part, word.into_owned(), ""),
        });
        let from = self.contributions.iter().flat_map(|(from, contribution)| {
            [
                (
                    format!("by.{from}"),
                    cell(Some(contribution.size)),
                    &*self.unit,
                ),
                (format!("share.{from}"), cell(Some(contribution.share)), ""),
            ]
        });
        let lines = lines.chain(from);
        lines
            .map(|(part, value, unit)| (format!("{}.{part}", self.name), value, unit))
            .collect()
    }

    fn to_json(&self) -> Value {
        let mut object = Map::new();
        let found = self.found.as_ref();
        object.insert("nominal".into(), number(found.map(|found| found.nominal)));
        let worst = found.map(|found| {
            json!({
                "low": end_json(found.worst.low),
                "high": end_json(found.worst.high),
                "reached": found.worst.reached.map(|end| number(Some(end))),
                "by": worst_word(found.worst.kind),
                "closes": closes_word(&found.worst),
            })
        });
        object.insert("worst".into(), worst.unwrap_or_default());
        let square = found.and_then(|found| found.root_sum_square);
        object.insert("rss".into(), number(square));
        let samples = self.percentiles.as_ref().map(|all| {
            let values = percentiles(all).into_iter();
            let values = values.map(|(name, value)| (name.to_owned(), number(Some(value))));
            Value::Object(values.collect())
        });
        object.insert("samples".into(), samples.unwrap_or_default());
        let from = self.contributions.iter().map(|(name, from)| {
            json!({
                "of": name,
                "tolerance": number(Some(from.tolerance)),
                "slope": number(Some(from.slope)),
                "size": number(Some(from.size)),
                "share": number(Some(from.share)),
            })
        });
        object.insert("contributions".into(), from.collect());
        Value::Object(object)
    }
}

/// Returns the effect of tolerances on a value, as named in columns.
pub(in crate::report) fn results(
    found: Option<&ToleranceFigure>,
) -> [(&'static str, RowCell<'static>); 8] {
    use RowCell::Number;
    let worst = found.map(|found| found.worst);
    let reached = worst.map(|worst| worst.reached);
    [
        ("nominal", Number(found.map(|found| found.nominal))),
        ("worst.low", Number(worst.and_then(|w| bounded(w.low)))),
        ("worst.high", Number(worst.and_then(|w| bounded(w.high)))),
        ("reached.low", Number(reached.map(|ends| ends[0]))),
        ("reached.high", Number(reached.map(|ends| ends[1]))),
        (
            "worst.by",
            RowCell::word(worst.map_or("", |w| worst_word(w.kind))),
        ),
        (
            "closes",
            RowCell::word(worst.as_ref().map_or("", closes_word)),
        ),
        ("rss", Number(found.and_then(|found| found.root_sum_square))),
    ]
}

/// Returns the distribution of a value among the samples, as named in CSV and JSON.
fn percentiles(all: &Percentiles) -> [(&'static str, f64); 5] {
    [
        ("p0.135", all.low),
        ("p50", all.median),
        ("p99.865", all.high),
        ("mean", all.mean),
        ("deviation", all.deviation),
    ]
}

/// Returns the name of a contributor: `r3.length`, or `r3.B.clearance` for a pin.
pub(in crate::report) fn contributor(scene: &Scene, of: ToleranceOf) -> String {
    match of {
        ToleranceOf::Length(length) => length_name(scene, length),
        ToleranceOf::Pin(link, point) => {
            let point = scene.point_name(point).unwrap_or("?");
            format!("{}.{point}.clearance", scene.link_name(link))
        }
    }
}

fn worst_text(found: &ToleranceFigure) -> Vec<String> {
    let WorstCase {
        low,
        high,
        reached,
        kind,
        fails,
    } = found.worst;
    let off = |end: f64| {
        let off = end - found.nominal;
        let sign = if off < 0.0 { "-" } else { "+" };
        format!("{sign}{}", significant(off.abs(), FEW_DIGITS))
    };
    let how = match kind {
        WorstKind::Corners => words().worst_by_corners(),
        WorstKind::Enclosed => words().worst_enclosed(),
        WorstKind::Searched => words().worst_searched(),
        WorstKind::AtEdge => words().worst_at_edge(),
        WorstKind::Unbounded => words().worst_beside_unbounded(),
        WorstKind::Derivatives => words().worst_by_derivatives(),
        WorstKind::Sampled => words().worst_sampled(),
    };
    let fails = fails.then(|| words().worst_does_not_close().to_owned());
    let end = |end: f64| (significant(end, DIGITS), off(end));
    let unbounded = || words().worst_unbounded().to_owned();
    let mut lines = match (low.is_finite(), high.is_finite()) {
        (true, true) => {
            let [(from, below), (to, above)] = [low, high].map(end);
            vec![words().range_and_off(&from, &to, &below, &above)]
        }
        (false, false) => {
            return [words().no_worst_case(&unbounded())]
                .into_iter()
                .chain(fails)
                .collect();
        }
        (true, false) => {
            let (from, below) = end(low);
            vec![
                words().worst_at_least(&from, &below),
                words().worst_above(&unbounded()),
            ]
        }
        (false, true) => {
            let (to, above) = end(high);
            vec![
                words().worst_at_most(&to, &above),
                words().worst_below(&unbounded()),
            ]
        }
    };
    let reached = (kind == WorstKind::Enclosed).then(|| {
        let [low, high] = reached;
        let [from, to] = reached.map(|end| significant(end, DIGITS));
        words().worst_reached(&from, &to, &off(low), &off(high))
    });
    lines.push(how.to_owned());
    lines.extend(reached.into_iter().chain(fails));
    lines
}

fn spread_text(all: &Percentiles) -> Vec<String> {
    let [low, high, mean] = [all.low, all.high, all.mean].map(|v| significant(v, DIGITS));
    let deviation = significant(all.deviation, FEW_DIGITS);
    vec![
        words().spread_of_samples(&low, &high),
        words().mean_and_deviation(&mean, &deviation),
    ]
}

/// Returns a limit of a worst case, if it is finite.
fn bounded(end: f64) -> Option<f64> {
    Some(end).filter(|end| end.is_finite())
}

/// Returns a limit of a worst case as JSON, or the reason why there is none.
fn end_json(end: f64) -> Value {
    match bounded(end) {
        Some(end) => number(Some(end)),
        None => json!({ "none": english_words().worst_unbounded() }),
    }
}

/// Formats a fraction in percent.
fn percent(part: f64) -> String {
    format!("{} %", concise(part * 100.0, 3))
}

/// Returns the word for the method of a worst case in files for other programs.
fn worst_word(kind: WorstKind) -> &'static str {
    match kind {
        WorstKind::Corners => "corners",
        WorstKind::Enclosed => "enclosed",
        WorstKind::Searched => "searched",
        WorstKind::AtEdge => "edge",
        WorstKind::Unbounded => "unbounded",
        WorstKind::Derivatives => "derivatives",
        WorstKind::Sampled => "samples",
    }
}

/// Returns the word, in files for other programs, for whether all mechanisms within the tolerances
/// close.
fn closes_word(worst: &WorstCase) -> &'static str {
    match worst.fails {
        true => "not-always",
        false if worst.kind.is_estimate() => "unproved",
        false => "yes",
    }
}

fn distribution_word(distribution: Distribution) -> &'static str {
    match distribution {
        Distribution::Normal => "normal",
        Distribution::Even => "even",
    }
}
