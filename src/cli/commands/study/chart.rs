//! Draws the chart of a study: curves over one value, maps over two.

use super::{ReadyStudy, StudyArgs, StudyFormat, StudyRows, report_invalid_designs};
use crate::cli::commands::plot::{plotted, svg_size};
use crate::cli::failure::{Failure, note};
use crate::cli::output::write_text;
use crate::cli::picture::{self, Size};
use crate::cli::screen::TextScreen;
use crate::drawing::plot::{GridMap, Plot};
use crate::report::{DesignTable, RowColumn};
use crate::wording::words;

/// Maximum number of designs in a chart; more would not be visible.
const MAX_DRAWN: u64 = 1_000_000;

/// A drawn value: its name and unit, and its grid points.
type DrawnAxis<'a> = ([&'a str; 2], Vec<f64>);

pub(super) fn draw(
    args: &StudyArgs,
    ready: &ReadyStudy,
    table: &DesignTable,
    screen: TextScreen,
) -> Result<(), Failure> {
    let (numbers, columns) = table.columns();
    let axes = drawn_axes(args, ready, numbers)?;
    let path = args.output.output.as_deref();
    let count = ready.plan.count();
    let mut all = StudyRows::new(table, count, path, screen);
    let mut found: Vec<Vec<Option<f64>>> = vec![Vec::new(); columns.len()];
    let gathered: Result<(), Failure> = ready.run(0..count).each(&mut |rows| {
        for row in &rows {
            all.note(row);
            for (index, values) in found.iter_mut().enumerate() {
                values.push(row.figure(index));
            }
        }
        all.progress.report_progress(all.summary.rows);
        Ok(())
    });
    all.progress.clear();
    gathered?;
    report_invalid_designs(&all.summary, &all.reason, true, screen)?;
    let titles = columns.iter().map(|c| [c.name.as_str(), c.unit.as_str()]);
    let figures: Vec<([&str; 2], Vec<Option<f64>>)> = titles.zip(found).collect();
    let text = match &axes[..] {
        [(title, coordinates)] => {
            over_one(args, &Plot::over(*title, coordinates, &figures), ready)?
        }
        [along, up] => {
            let map = |(title, heights): &([&str; 2], Vec<Option<f64>>)| {
                GridMap::new(*title, along.clone(), up.clone(), heights)
            };
            over_two(args, &figures.iter().map(map).collect::<Vec<_>>(), ready)
        }
        _ => return Err(needs_grid()),
    };
    let lines = all.summary.lines(table, usize::from(args.digits));
    lines.iter().for_each(|line| note(line, screen));
    write_text(path, &text)
}

fn needs_grid() -> Failure {
    Failure::Usage(words().chart_needs_grid("10^6"))
}

/// Returns the values with more than one grid point.
fn drawn_axes<'a>(
    args: &StudyArgs,
    ready: &ReadyStudy,
    numbers: &'a [RowColumn],
) -> Result<Vec<DrawnAxis<'a>>, Failure> {
    let plan = &ready.plan;
    let is_grid = args.latin.is_none() && args.part.is_none() && !args.resume;
    if !is_grid || plan.count() > MAX_DRAWN {
        return Err(needs_grid());
    }
    let counts: Vec<u64> = plan.places().map(u64::from).collect();
    let places = |axis: usize| {
        let stride: u64 = counts[axis + 1..].iter().product();
        let at = (0..counts[axis]).map(|k| plan.numbers(k * stride)[axis]);
        at.collect()
    };
    let several = (0..counts.len()).filter(|&axis| counts[axis] > 1);
    let axes = several.map(|axis| {
        let column = &numbers[axis];
        ([column.name.as_str(), column.unit.as_str()], places(axis))
    });
    let axes: Vec<DrawnAxis<'_>> = axes.collect();
    match axes.len() {
        1 | 2 => Ok(axes),
        _ => Err(needs_grid()),
    }
}

fn title(ready: &ReadyStudy) -> &str {
    &ready.figures.space().scene().name
}

fn over_one(args: &StudyArgs, plot: &Plot, ready: &ReadyStudy) -> Result<String, Failure> {
    if args.format == StudyFormat::Svg {
        return Ok(plot.svg(title(ready), svg_size(args.size), false, None));
    }
    plotted(plot, (args.size, &args.output), args.glyphs, false).map(|(text, _)| text)
}

fn over_two(args: &StudyArgs, maps: &[GridMap], ready: &ReadyStudy) -> String {
    if args.format == StudyFormat::Svg {
        let plot = GridMap::contours(maps);
        let svg = |plot: Plot| plot.svg(title(ready), svg_size(args.size), false, None);
        return plot.map(svg).unwrap_or_default();
    }
    let Size { cols, rows } = picture::size(args.size, args.output.output.as_deref());
    let text: Vec<String> = maps.iter().map(|map| map.text(cols, rows)).collect();
    picture::lettered(text.join("\n"), picture::glyphs(args.glyphs))
}
