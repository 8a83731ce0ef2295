//! Reads function tasks, given by pairs or by a formula over a range.

use super::{Reader, keys, report_missing_key, rows};
use crate::document::{Diagnostic, WrittenValue};
use crate::expression::{MeasuredNumber, Wide};
use crate::scene::{KeyTable, NumberRule};
use crate::synthesis::{FunctionTask, GivenNumber, Output, functions::chebyshev_pairs};
use crate::wording::words;

const PAIRS: &str = "pairs = [[0, 0], [30, 42], [60, 71]]";
const FUNCTION: &str = r#"{ y = "log10(x)", from = 1, to = 2, points = 3 }"#;
const SIDE: &str = "{ swing = 60, start = 45 }";
/// Number of intervals in which a formula is sampled between its pairs.
const INTERVALS_PER_PAIR: u32 = 180;
/// Maximum number of pairs.
const MAX_COUNT: usize = 1000;

/// The pairs of a function, and a denser sample between them.
#[derive(Default)]
struct FunctionSamples {
    pairs: Vec<[f64; 2]>,
    between: Vec<[f64; 2]>,
}

impl FunctionSamples {
    /// Returns the value of y if it is constant.
    fn constant_value(&self) -> Option<f64> {
        let mut all = self.between.iter().chain(&self.pairs).map(|[_, y]| *y);
        let first = all.next()?;
        all.all(|y| y == first).then_some(first)
    }
}

pub(super) fn function(
    reader: &mut Reader<'_>,
    file: &KeyTable<'_>,
    slides: bool,
) -> Option<FunctionTask> {
    let (course, text_span) = match (file.get("pairs"), file.get("function")) {
        (Some(written), None) => (pairs(reader, file, written)?, written.span()),
        (None, Some(written)) => (formula(reader, written)?, written.span()),
        (None, None) => return report_missing_key(reader, "function", "pairs", PAIRS),
        (Some(_), Some(written)) => {
            reader.report(Diagnostic::new(words().pairs_and_function()).at(written.span(), ""));
            return None;
        }
    };
    if let Some(y) = course.constant_value() {
        reader.report(
            Diagnostic::new(words().output_stands_still(&y.to_string()))
                .at(text_span, "")
                .help(words().let_y_change()),
        );
        return None;
    }
    let all = || course.between.iter().chain(&course.pairs);
    // The first sample of a formula is the start of its range; pairs begin with the smallest x.
    let [x, y] = *all().next()?;
    let courses = [(0, x), (1, y)].map(|(part, first)| ValueSeries {
        first,
        span: span(all(), part),
    });
    let crank = side(reader, file, "crank", &courses[0], true)?;
    let output = side(reader, file, "output", &courses[1], !slides)?;
    let size = match file.get("size") {
        None => 100.0,
        Some(value) => {
            let (what, measure) = (file.what(reader, "size"), file.measure("size"));
            let size = reader.in_units(&what, measure, value)?;
            reader.permits(&what, "size", NumberRule::PositiveNumber, size, value);
            size
        }
    };
    let output_kind = if slides { Output::Slide } else { Output::Angle };
    Some(FunctionTask {
        pairs: course.pairs,
        between: course.between,
        output: output_kind,
        crank_datum: crank.0,
        crank_scale: crank.1,
        output_datum: output.0,
        output_scale: output.1,
        size,
    })
}

fn pairs(
    reader: &mut Reader<'_>,
    file: &KeyTable<'_>,
    written: &WrittenValue<'_>,
) -> Option<FunctionSamples> {
    let rows = rows(reader, file, "pairs", ("[x, y]", "[30, 42]"), [None; 2])?;
    if !(3..=MAX_COUNT).contains(&rows.len()) {
        reader.report(
            Diagnostic::new(words().count_of_pairs(rows.len(), MAX_COUNT))
                .at(written.span(), "")
                .help(words().for_example(PAIRS)),
        );
        return None;
    }
    for (k, two) in rows.windows(2).enumerate() {
        if !(two[1].0[0] > two[0].0[0]) {
            reader.report(
                Diagnostic::new(words().pairs_not_in_order(k + 2))
                    .at(two[1].1.clone(), words().not_further_on())
                    .help(words().pairs_by_growing_x()),
            );
            return None;
        }
    }
    Some(FunctionSamples {
        pairs: rows.into_iter().map(|(row, _)| row).collect(),
        between: Vec::new(),
    })
}

fn formula(reader: &mut Reader<'_>, value: &WrittenValue<'_>) -> Option<FunctionSamples> {
    let names = ["`function`"; 2];
    let table = &reader.open(names, keys::FUNCTION, FUNCTION, value)?;
    reader.only_known(table);
    let example = format!("function = {FUNCTION}");
    let mut number = |key: &str| match table.has(key) {
        true => reader.number_of(table, key),
        false => report_missing_key(reader, "function", key, &example),
    };
    let (from, to) = (number("from"), number("to"));
    let count = reader.number_or(table, "points", 3.0);
    if !table.has("y") {
        return report_missing_key(reader, "function", "y", &example);
    }
    let y = reader.text_of(table, "y")?;
    let (from, to, count) = (from?, to?, count?);
    let points = usize::try_from(count as i64).unwrap_or(0);
    let is_range = to > from && (to - from).is_finite();
    let is_count = (3..=MAX_COUNT).contains(&points) && points as f64 == count;
    if !(is_range && is_count) {
        reader.report(Diagnostic::new(words().range_of_function(MAX_COUNT)).at(value.span(), ""));
        return None;
    }
    let mut at = |x: f64| {
        let result = MeasuredNumber::plain(Wide::exactly(x));
        reader.named.worth.insert("x".to_owned(), Some(result));
        let y = reader.worked_out(&words().key_of("y", "`function`"), y.text, &y.span)?;
        Some([x, y.nearest()])
    };
    let places = chebyshev_pairs(Some, [from, to], points)?;
    let pairs: Option<Vec<[f64; 2]>> = places.into_iter().map(|[x, _]| at(x)).collect();
    let dense = (0..=INTERVALS_PER_PAIR)
        .map(|k| from + (to - from) * f64::from(k) / f64::from(INTERVALS_PER_PAIR));
    let pairs = pairs?;
    let between: Option<Vec<[f64; 2]>> = dense.map(&mut at).collect();
    reader.named.worth.remove("x");
    Some(FunctionSamples {
        pairs,
        between: between?,
    })
}

/// The values of x, or of y, of a function.
struct ValueSeries {
    /// The value at the minimum x.
    first: f64,
    /// The difference between the maximum and the minimum.
    span: f64,
}

/// Returns the difference between the maximum and minimum of x or of y.
fn span<'p>(points: impl Iterator<Item = &'p [f64; 2]>, part: usize) -> f64 {
    let ends = (f64::INFINITY, f64::NEG_INFINITY);
    let (low, high) = points.fold(ends, |(low, high), point| {
        (low.min(point[part]), high.max(point[part]))
    });
    high - low
}

/// Reads datum and scale of one side. The scale defaults to 1; without a start the datum is free.
fn side(
    reader: &mut Reader<'_>,
    file: &KeyTable<'_>,
    key: &str,
    course: &ValueSeries,
    is_rotary: bool,
) -> Option<(GivenNumber, GivenNumber)> {
    let Some(value) = file.get(key) else {
        return Some((GivenNumber::Free, GivenNumber::Value(1.0)));
    };
    let of = format!("`{key}`");
    let mut table = reader.open([&of, &of], keys::SIDE, SIDE, value)?;
    table.is_rotary = is_rotary;
    reader.only_known(&table);
    let scale = match (table.has("swing"), table.get("scale")) {
        (true, Some(scale)) => {
            reader.report(Diagnostic::new(words().swing_and_scale()).at(scale.span(), ""));
            return None;
        }
        (true, None) => GivenNumber::Value(reader.quantity(&table, "swing")? / course.span),
        (false, Some(scale)) if scale.get_ref().as_str() == Some("free") => GivenNumber::Free,
        (false, Some(_)) => GivenNumber::Value(reader.quantity(&table, "scale")?),
        (false, None) => GivenNumber::Value(1.0),
    };
    let start = match table.has("start") {
        true => Some(reader.quantity(&table, "start")?),
        false => None,
    };
    let rule = match (start, scale) {
        (Some(_), GivenNumber::Free) => words().start_wants_scale(),
        (_, GivenNumber::Value(scale)) if scale == 0.0 || !scale.is_finite() => {
            words().scale_is_nought()
        }
        (None, scale) => return Some((GivenNumber::Free, scale)),
        (Some(start), GivenNumber::Value(scale)) => {
            return Some((
                GivenNumber::Value(start - scale * course.first),
                GivenNumber::Value(scale),
            ));
        }
    };
    reader.report(Diagnostic::new(rule).at(value.span(), ""));
    None
}
