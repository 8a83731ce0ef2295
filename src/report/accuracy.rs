//! Formats the results of a method study as text, CSV and JSON.

use crate::PointId;
use crate::page::{Content, Facts, Page, Rest, Row, Setting, Table, TextStyle};
use crate::report::text::csv_dialect::{CsvDialect, CsvSheet};
use crate::report::text::number::{concise, significant};
use crate::scene::Scene;
use crate::solver::{Method, Start, Unsuitable};
use crate::study::{Finding, Findings, MethodErrors, MethodFigures, MethodVerdict, Spread};
use crate::wording::{Words, english_words, words};
use serde_json::{Value, json};
use std::io::{self, Write};

/// Significant digits of an error.
const ERROR_DIGITS: usize = 2;
/// Significant digits of a time.
pub const TIME_DIGITS: usize = 3;
/// Width of the column with key, mark and name of a method.
const NAME: usize = 22;
/// Significant digits of the longest length.
const LENGTH_DIGITS: usize = 6;

/// Returns the name of a method, in at most 19 characters without a comma.
#[must_use]
pub fn method_name(method: Method) -> String {
    named(method, words())
}

fn named(method: Method, wording: &dyn Words) -> String {
    match method {
        Method::ClosedForm => wording.closed_form().into(),
        Method::Polished => wording.closed_and_polished().into(),
        Method::Anchored => wording.newton_from_anchors().into(),
        Method::Bounded => wording.with_bounds().into(),
        Method::Single => wording.single_precision().into(),
        Method::Newton { tolerance, start } => match start {
            Start::Warm => wording.newton_warm(tolerance),
            Start::Cold => wording.newton_cold(tolerance),
        },
        Method::Bisection => wording.bisection().into(),
        Method::Integration { steps, turns } => wording.runge_kutta(&steps, &turns),
    }
}

/// Formats an error with two digits: `2.3e-16`.
#[must_use]
pub fn error_text(error: f64) -> String {
    if error == 0.0 {
        "0".into()
    } else {
        format!("{error:.*e}", ERROR_DIGITS - 1)
    }
}

/// Formats a time with `digits` significant digits, in ns, us, ms or s: `61.2 ns`.
#[must_use]
pub fn time_text(seconds: f64, digits: usize) -> String {
    let (scale, unit) = time_unit(seconds);
    format!("{} {unit}", format_plain(seconds * scale, digits))
}

/// Formats a value with so many significant digits, never with an exponent; the integer part of a
/// time may have more digits.
fn format_plain(value: f64, digits: usize) -> String {
    let text = significant(value, digits);
    if text.contains('e') {
        format!("{value:.0}")
    } else {
        text
    }
}

/// Returns the factor from seconds and the unit in which a time has at most three integer digits.
fn time_unit(seconds: f64) -> (f64, &'static str) {
    let units = [(1e9, "ns"), (1e6, "us"), (1e3, "ms")];
    let small = |(scale, _): &(f64, &str)| seconds * scale < 999.5;
    units.into_iter().find(small).unwrap_or((1.0, "s"))
}

/// Formats the quartiles in the unit of the median: `60.8-62.0`.
fn spread_text(time: &Spread) -> String {
    let (scale, _) = time_unit(time.median);
    let [low, high] = [time.low, time.high].map(|t| format_plain(t * scale, TIME_DIGITS));
    format!("{low}-{high}")
}

/// Returns the reason why a method cannot be used for this scene.
#[must_use]
pub fn unfit_text(unfit: Unsuitable, scene: &Scene) -> String {
    unsuitable_reason(unfit, scene, words())
}

fn unsuitable_reason(unfit: Unsuitable, scene: &Scene, wording: &dyn Words) -> String {
    let group = |point: Option<PointId>| {
        let name = point.and_then(|p| scene.point_name(p));
        name.map_or_else(
            || wording.a_group().into(),
            |name| wording.the_group_at(name),
        )
    };
    match unfit {
        Unsuitable::Coupled(point) => wording.has_no_closed_form(&group(point)),
        Unsuitable::AllClosed => wording.not_needed().into(),
        Unsuitable::Conditions { point, unknowns } => {
            wording.closes_by_conditions(&group(point), unknowns)
        }
        Unsuitable::Limits => wording.cannot_turn_fully().into(),
        Unsuitable::NoRows => wording.gives_no_rows().into(),
    }
}

/// The findings of a study, with the scene studied.
#[derive(Clone, Copy, Debug)]
pub struct Accuracy<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The findings.
    pub findings: &'a Findings,
}

impl Accuracy<'_> {
    /// Formats the scene and a line per method.
    #[must_use]
    pub fn to_text(&self, ascii: bool) -> String {
        let Findings {
            longest, positions, ..
        } = self.findings;
        let longest = concise(*longest, LENGTH_DIGITS);
        let unit = self.scene.unit.symbol();
        let mut page = Page::default();
        page.title(&self.scene.title());
        page.text_below(words().positions_over_cycle(positions, &longest, unit));
        let mut table = self.table(&StudyMeasure::ALL);
        // A gap of 1 fits all columns into 80; a blank separates the keys from the names.
        table.setting.gap = 1;
        for row in &mut table.rows {
            if let Row::Figures { mark, .. } | Row::Told { mark, .. } = row {
                mark.push(' ');
            }
        }
        page.table(table);
        page.to_text(TextStyle::plain(ascii))
    }

    /// Returns a table with a row per method and a column per measure.
    #[must_use]
    pub fn table(&self, measures: &[StudyMeasure]) -> Table {
        let columns = measures.iter().map(|measure| measure.column());
        let (headers, widths): (Vec<&str>, Vec<usize>) = columns.unzip();
        let mut table = Table::new(words().method(), headers).set(Setting {
            names: NAME,
            least: widths,
            rest: Rest::LeftOut,
            ..Setting::default()
        });
        for finding in &self.findings.methods {
            let best = if finding.best { '*' } else { ' ' };
            let mark = format!("{}{best}", finding.key);
            let name = method_name(finding.method);
            table.rows.push(match &finding.verdict {
                MethodVerdict::Measured(figures) => Row::Figures {
                    mark,
                    name,
                    more: None,
                    cells: measures
                        .iter()
                        .map(|m| Some(m.text(figures).into()))
                        .collect(),
                },
                MethodVerdict::Unsuitable(unfit) => {
                    let words = unfit_text(*unfit, self.scene);
                    Row::Told { mark, name, words }
                }
                MethodVerdict::Pending => {
                    let words = words().not_measured().into();
                    Row::Told { mark, name, words }
                }
            });
        }
        table
    }

    /// Writes a row per method; a missing value is an empty cell.
    ///
    /// # Errors
    /// Returns the errors of the writer.
    pub fn write_csv(&self, dialect: CsvDialect, to: impl Write) -> io::Result<()> {
        let mut csv = CsvSheet::new(dialect, to);
        for (number, finding) in self.findings.methods.iter().enumerate() {
            let record = self.record(finding);
            if number == 0 {
                csv.record(record.each_ref().map(|(column, _)| *column))?;
            }
            csv.record(record.map(|(_, value)| match value {
                Value::Null => String::new(),
                Value::String(text) => text,
                other => other.to_string(),
            }))?;
        }
        csv.finish()
    }

    /// Returns all findings as one object.
    #[must_use]
    pub fn to_json(&self) -> Value {
        let methods = self.findings.methods.iter().map(|finding| {
            let pairs = self.record(finding).into_iter();
            Value::Object(pairs.map(|(key, value)| (key.to_owned(), value)).collect())
        });
        json!({
            "scene": self.scene.name,
            "unit": self.scene.unit.symbol(),
            "longest": self.findings.longest,
            "positions": self.findings.positions,
            "finished": self.findings.finished,
            "methods": methods.collect::<Vec<_>>(),
        })
    }

    /// Returns the columns of CSV, which are the keys of a method in JSON, with their values.
    fn record(&self, finding: &Finding) -> [(&'static str, Value); 14] {
        let figures = finding.figures();
        let time = figures.and_then(|f| f.time);
        let time = |part: fn(&Spread) -> f64| time.map(|t| part(&t) * 1e9);
        let errors = figures.and_then(|f| f.errors);
        let error = |part: fn(&MethodErrors) -> f64| errors.map(|e| part(&e));
        let iterations = figures.and_then(|f| f.iterations);
        let wording = english_words();
        let reason = match finding.verdict {
            MethodVerdict::Measured(_) => None,
            MethodVerdict::Unsuitable(unfit) => Some(unsuitable_reason(unfit, self.scene, wording)),
            MethodVerdict::Pending => Some(wording.not_measured().into()),
        };
        [
            ("key", json!(finding.key)),
            ("method", json!(named(finding.method, wording))),
            ("time [ns]", json!(time(|t| t.median))),
            ("time.low [ns]", json!(time(|t| t.low))),
            ("time.high [ns]", json!(time(|t| t.high))),
            ("position", json!(error(|e| e.position))),
            ("velocity", json!(error(|e| e.velocity))),
            ("acceleration", json!(error(|e| e.acceleration))),
            ("tried", json!(figures.map(|f| f.tried))),
            ("failures", json!(figures.map(|f| f.failures))),
            ("best", json!(finding.best)),
            ("reason", json!(reason)),
            ("iterations.median", json!(iterations.map(|i| i.median))),
            ("iterations.most", json!(iterations.map(|i| i.most))),
        ]
    }
}

/// Explains the values of a study.
#[must_use]
pub fn accuracy_notes() -> String {
    let mut facts = Facts {
        names: NOTE,
        ..Facts::default()
    };
    for (name, note) in notes() {
        facts.add(name, [note.to_owned()]);
    }
    let mut page = Page::default();
    page.add(Content::Facts(facts));
    page.to_text(TextStyle::plain(true))
}

/// Width of the column with the terms that the notes explain.
const NOTE: usize = 14;

/// Returns the terms with their explanations.
fn notes() -> [(&'static str, &'static str); 14] {
    [
        (words().time(), words().of_time_is()),
        (words().errors_of_three(), words().errors_are()),
        (words().failures(), words().failures_are()),
        ("*", words().best_are()),
        (words().iterations(), words().iterations_are()),
        (words().closed_form(), words().closed_form_is()),
        (words().anchors(), words().newton_from_anchors_is()),
        (words().with_bounds(), words().with_bounds_is()),
        (words().polished(), words().polished_is()),
        (words().single(), words().single_precision_is()),
        (words().newton_at_tolerance(), words().newton_is()),
        (words().warm_or_cold(), words().warm_or_cold_is()),
        (words().bisection(), words().bisection_is()),
        (words().runge_kutta_n_by_m(), words().runge_kutta_is()),
    ]
}

/// A quantity measured for each method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StudyMeasure {
    /// The time per position.
    Time,
    /// The quartiles of that time.
    Quartiles,
    /// The maximum error of positions.
    Position,
    /// The maximum error of velocities.
    Velocity,
    /// The maximum error of accelerations.
    Acceleration,
    /// The number of failures.
    Failures,
    /// The number of iterations or bisection steps.
    Iterations,
}

impl StudyMeasure {
    /// All measures.
    pub const ALL: [StudyMeasure; 7] = [
        StudyMeasure::Time,
        StudyMeasure::Quartiles,
        StudyMeasure::Position,
        StudyMeasure::Velocity,
        StudyMeasure::Acceleration,
        StudyMeasure::Failures,
        StudyMeasure::Iterations,
    ];

    /// Returns the name and the width of its column, fixed so that columns do not move while results
    /// arrive.
    fn column(self) -> (&'static str, usize) {
        match self {
            StudyMeasure::Time => (words().time(), 7),
            StudyMeasure::Quartiles => (words().quartiles(), 11),
            StudyMeasure::Position => (words().error_of_positions(), 7),
            StudyMeasure::Velocity => (words().error_of_velocities(), 7),
            StudyMeasure::Acceleration => (words().error_of_accelerations(), 7),
            StudyMeasure::Failures => (words().failures(), 5),
            StudyMeasure::Iterations => (words().iterations(), 7),
        }
    }

    fn text(self, figures: &MethodFigures) -> String {
        let error =
            |part: fn(&MethodErrors) -> f64| figures.errors.as_ref().map(part).map(error_text);
        let time = figures.time.as_ref();
        let text = match self {
            StudyMeasure::Time => time.map(|t| time_text(t.median, TIME_DIGITS)),
            StudyMeasure::Quartiles => time.map(spread_text),
            StudyMeasure::Position => error(|e| e.position),
            StudyMeasure::Velocity => error(|e| e.velocity),
            StudyMeasure::Acceleration => error(|e| e.acceleration),
            StudyMeasure::Failures => Some(figures.failures.to_string()),
            StudyMeasure::Iterations => {
                let counts = figures.iterations;
                counts.map(|counts| format!("{}-{}", counts.median, counts.most))
            }
        };
        text.unwrap_or_else(|| "-".into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;
    use crate::study::IterationCounts;

    fn figures(median: f64, failures: u64) -> MethodFigures {
        MethodFigures {
            time: Some(Spread {
                low: 0.9 * median,
                median,
                high: 1.1 * median,
            }),
            errors: (failures < 3600).then_some(MethodErrors {
                position: 2.34e-16,
                velocity: 5e-7,
                acceleration: 0.0,
            }),
            tried: 3600,
            failures,
            iterations: (failures > 0).then_some(IterationCounts {
                median: 52,
                most: 55,
            }),
        }
    }

    fn finding(key: char, method: Method, verdict: MethodVerdict) -> Finding {
        Finding {
            key,
            method,
            verdict,
            best: key == 'a',
        }
    }

    fn lines(methods: Vec<Finding>) -> Vec<String> {
        let preset = presets::find("stephenson-six-bar").unwrap();
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let findings = Findings {
            methods,
            longest: 400.0,
            positions: 3600,
            finished: false,
        };
        let accuracy = Accuracy {
            scene: &scene,
            findings: &findings,
        };
        let text = accuracy.to_text(true);
        text.lines().skip(4).map(str::to_owned).collect()
    }

    #[test]
    fn every_method_has_a_line_for_any_verdict() {
        let point = Scene::parse(presets::find("four-bar").unwrap().text, "four-bar").unwrap();
        let point = point.mechanism.point_ids().nth(3);
        let lines = lines(vec![
            finding(
                'a',
                Method::ClosedForm,
                MethodVerdict::Measured(figures(71e-9, 0)),
            ),
            finding(
                'b',
                Method::Bisection,
                MethodVerdict::Measured(figures(3.9994e-6, 3600)),
            ),
            finding(
                'c',
                Method::Polished,
                MethodVerdict::Unsuitable(Unsuitable::Coupled(point)),
            ),
            finding('d', Method::Single, MethodVerdict::Pending),
        ]);
        let expected = [
            "a* closed form         71.0 ns   63.9-78.1 2.3e-16  5.0e-7       0     0       -",
            "b  bisection           4.00 us   3.60-4.40       -       -       -  3600   52-55",
        ];
        assert_eq!(lines[..2], expected);
        assert!(
            lines[2].starts_with("c  closed and polished - the group at "),
            "{}",
            lines[2]
        );
        assert!(lines[2].ends_with(" has no closed form"), "{}", lines[2]);
        assert_eq!(lines[3], "d  single precision    - not measured");
    }

    #[test]
    fn method_names_fit_column_and_need_no_quotes() {
        for method in crate::study::all_methods(crate::study::DEFAULT_CYCLES) {
            let name = method_name(method);
            assert!(name.len() <= NAME - 3 && !name.contains(','), "{name}");
        }
    }

    #[test]
    fn times_use_shortest_unit() {
        let lines = [9.994e-7, 9.996e-7, 1e-9, 0.0123, 2.0].map(|t| time_text(t, TIME_DIGITS));
        assert_eq!(lines, ["999 ns", "1.00 us", "1.00 ns", "12.3 ms", "2.00 s"]);
        // An outlier keeps the unit of the median.
        let wild = Spread {
            low: 5e-8,
            median: 6e-8,
            high: 4.5e-6,
        };
        assert_eq!(spread_text(&wild), "50.0-4500");
    }
}
