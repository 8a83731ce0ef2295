//! `krank study`: computes values of many designs of a scene, as rows or as a chart.

mod chart;
mod rows;

use crate::cli::choice::{OrAuto, one_of};
use crate::cli::failure::{Failure, note};
use crate::cli::formats::{CsvArgs, OutputFormat, positive};
use crate::cli::output::{self, OutputArgs, write_to, writes_to_terminal};
use crate::cli::picture::{Size, glyph_choices};
use crate::cli::progress::Progress;
use crate::cli::screen::TextScreen;
use crate::cli::source::{SceneArgs, SolvableScene};
use crate::drawing::Glyphs;
use crate::files::{AppendFile, Output, ResumableFile, WriteError};
use crate::parallel;
use crate::quantity::Catalogue;
use crate::report::{DesignSummary, DesignTable, MAX_ROWS};
use crate::scene::entries_with_numbers;
use crate::study::{
    CycleFigure, DesignFigures, DesignPlan, DesignRow, DesignRun, DesignSpace, PlanAxis,
};
use crate::wording::words;
use clap::{Args, ValueEnum};
use std::io::Write;
use std::ops::Range;
use std::path::Path;
use std::str::FromStr;

/// How designs are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum StudyFormat {
    #[value(help = words().format_text())]
    Text,
    #[value(help = words().format_csv())]
    Csv,
    #[value(help = words().format_json())]
    Json,
    #[value(help = words().format_chart())]
    Chart,
    #[value(help = words().format_svg())]
    Svg,
}

/// A part of a study, such as `1/4`; parts are counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::cli) struct StudyPart {
    number: u64,
    of: u64,
}

impl StudyPart {
    /// Returns the range of the part's designs. Each of the `count` designs belongs to exactly one part.
    fn of(self, count: u64) -> Range<u64> {
        let end = |part: u64| {
            let end = u128::from(count) * u128::from(part) / u128::from(self.of);
            u64::try_from(end).unwrap_or(count)
        };
        end(self.number - 1)..end(self.number)
    }
}

impl FromStr for StudyPart {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.trim().parse::<u64>().ok().filter(|&n| n > 0);
        let part = text.split_once('/').and_then(|(part, of)| {
            let (number, of) = (number(part)?, number(of)?);
            (number <= of).then_some(StudyPart { number, of })
        });
        part.ok_or_else(|| words().no_part(text))
    }
}

/// Maximum number of threads, more than any machine has.
const MAX_THREADS: i64 = 1024;

#[derive(Debug, Args)]
pub(in crate::cli) struct StudyArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[arg(help = words().values_of_study())]
    #[arg(long, value_name = "AXES", required = true)]
    vary: Vec<String>,
    #[arg(help = words().columns_of_study())]
    #[arg(long, value_name = "FIGURES", required = true)]
    columns: Vec<String>,
    #[arg(help = words().designs_of_hypercube())]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=10_000_000))]
    latin: Option<u32>,
    #[arg(help = words().seed_of_hypercube())]
    #[arg(long, value_name = "N", default_value_t = 1, requires = "latin")]
    seed: u64,
    #[arg(help = words().dwell_of_cycle())]
    #[arg(long, value_name = "SIZE", value_parser = positive, allow_negative_numbers = true)]
    dwell: Option<f64>,
    #[arg(help = words().part_of_study())]
    #[arg(long, value_name = "K/N")]
    part: Option<StudyPart>,
    #[arg(help = words().resume_study())]
    #[arg(long, requires = "output")]
    resume: bool,
    #[arg(help = words().threads_of_study())]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=MAX_THREADS))]
    threads: Option<u16>,
    #[arg(help = words().how_to_write_study())]
    #[arg(long, value_enum, default_value_t = StudyFormat::Csv)]
    format: StudyFormat,
    #[arg(help = words().digits_of_tables())]
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u8).range(1..=17))]
    digits: u8,
    #[command(flatten)]
    csv: CsvArgs,
    #[arg(help = words().leave_units_out())]
    #[arg(long)]
    no_units: bool,
    #[arg(help = words().size_of_chart())]
    #[arg(long, value_name = "COLSxROWS")]
    size: Option<Size>,
    #[arg(help = words().characters_to_draw_with())]
    #[arg(long, value_parser = one_of(glyph_choices()), default_value = "auto")]
    glyphs: OrAuto<Glyphs>,
    #[command(flatten)]
    output: OutputArgs,
}

impl StudyArgs {
    /// Returns `true` if the output is a picture.
    fn is_drawn(&self) -> bool {
        matches!(self.format, StudyFormat::Chart | StudyFormat::Svg)
    }
}

/// A parsed study: its plan and its quantities.
pub(super) struct ReadyStudy {
    pub(super) figures: DesignFigures,
    pub(super) plan: DesignPlan,
    /// The unit of the driver's coordinate.
    driver: String,
    threads: usize,
}

/// The output of rows, with a summary.
struct StudyRows<'a> {
    table: &'a DesignTable,
    summary: DesignSummary,
    /// The reason why the first invalid design has no values.
    reason: String,
    progress: Progress,
}

pub(in crate::cli) fn study(args: &StudyArgs, screen: TextScreen) -> Result<(), Failure> {
    let format = match args.format {
        StudyFormat::Csv => OutputFormat::Csv,
        StudyFormat::Json => OutputFormat::Json,
        StudyFormat::Text | StudyFormat::Chart | StudyFormat::Svg => OutputFormat::Text,
    };
    let digits = usize::from(args.digits);
    let format = args.csv.rows(format, digits)?;
    let SolvableScene { scene, solver } = args.scene.open_for(&args.output)?;
    let axes = axes(args)?;
    let space = DesignSpace::of_axes(&scene, &solver, &axes)
        .map_err(|why| Failure::Usage(words().of_option("--vary", &why)))?;
    let ready = ready(args, &axes, space)?;
    let table = DesignTable::new(&ready.figures, &ready.driver, format, !args.no_units);
    let designs = match args.part {
        Some(part) => part.of(ready.plan.count()),
        None => 0..ready.plan.count(),
    };
    if args.is_drawn() {
        return chart::draw(args, &ready, &table, screen);
    }
    let path = output::file(args.output.output.as_deref());
    let rows = match path.filter(|path| grows(args, path)) {
        Some(path) => grow(args, &ready, &table, designs, path, screen)?,
        None if args.resume => return Err(Failure::Usage(words().resume_needs_file().into())),
        None => write(args, &ready, &table, designs, screen)?,
    };
    if args.format == StudyFormat::Text {
        let lines = rows.summary.lines(&table, digits);
        lines.iter().for_each(|line| note(line, screen));
    }
    let is_whole = args.part.is_none() && !args.resume;
    report_invalid_designs(&rows.summary, &rows.reason, is_whole, screen)
}

/// Parses the values of `--vary`, each text a list.
pub(super) fn named_axes(vary: &[String]) -> Result<Vec<PlanAxis>, Failure> {
    let lists: Result<Vec<_>, _> = vary.iter().map(|list| PlanAxis::listed(list)).collect();
    let wrong = |why| Failure::Usage(words().of_option("--vary", &why));
    Ok(lists.map_err(wrong)?.concat())
}

/// Parses the varied values, each with a range.
fn axes(args: &StudyArgs) -> Result<Vec<PlanAxis>, Failure> {
    let wrong = |why: String| Failure::Usage(words().of_option("--vary", &why));
    let axes = named_axes(&args.vary)?;
    let axes = axes.into_iter().map(|axis| match axis.ends {
        None => Err(wrong(words().axis_without_ends(&axis.name))),
        Some(_) if args.latin.is_some() && axis.count.is_some() => {
            Err(wrong(words().hypercube_has_places(&axis.name)))
        }
        Some(_) => Ok(axis),
    });
    axes.collect()
}

fn ready(args: &StudyArgs, axes: &[PlanAxis], space: DesignSpace) -> Result<ReadyStudy, Failure> {
    let catalogue = Catalogue::new(space.scene());
    let mut figures: Vec<CycleFigure> = Vec::new();
    let names = args.columns.iter();
    for name in names.flat_map(|list| entries_with_numbers(list)) {
        let figure = CycleFigure::parse(&name, &catalogue)
            .map_err(|e| Failure::Usage(words().of_option("--columns", &e)))?;
        if !figures.contains(&figure) {
            figures.push(figure);
        }
    }
    let given = space.given();
    let plan = match args.latin {
        Some(count) => DesignPlan::latin(axes, &given, count, args.seed),
        None => DesignPlan::grid(axes, &given),
    };
    if plan.count() > MAX_ROWS {
        return Err(Failure::Usage(words().too_many_designs("10^9")));
    }
    Ok(ReadyStudy {
        figures: DesignFigures::new(&space, figures, args.dwell),
        plan,
        driver: catalogue.driver().unit.clone(),
        threads: match args.threads {
            Some(threads) => usize::from(threads),
            None => parallel::cores(),
        },
    })
}

impl ReadyStudy {
    pub(super) fn run(&self, designs: Range<u64>) -> DesignRun<'_> {
        DesignRun {
            figures: &self.figures,
            plan: &self.plan,
            designs,
            threads: self.threads,
        }
    }
}

impl<'a> StudyRows<'a> {
    fn new(table: &'a DesignTable, count: u64, path: Option<&Path>, screen: TextScreen) -> Self {
        let nearby = writes_to_terminal(path);
        StudyRows {
            table,
            summary: DesignSummary::new(table.columns().1.len()),
            reason: String::new(),
            progress: Progress::new(count, words().designs(), screen, nearby),
        }
    }

    /// Adds a row to the summary.
    fn note(&mut self, row: &DesignRow) {
        self.summary.note(row);
        if self.summary.valued == 0 && self.reason.is_empty() {
            self.reason = self.table.reason(row);
        }
    }

    /// Formats rows and adds them to the summary.
    fn lines(&mut self, rows: &[DesignRow]) -> String {
        let mut text = String::new();
        for row in rows {
            text += &self.table.line(row, self.summary.rows == 0);
            self.note(row);
        }
        self.progress.report_progress(self.summary.rows);
        text
    }
}

/// Returns `true` if rows are appended to a file one by one: as CSV, to a regular file.
fn grows(args: &StudyArgs, path: &Path) -> bool {
    args.format == StudyFormat::Csv && !Output::is_stream(path)
}

/// Appends rows to a file, which keeps them even if the command is interrupted.
fn grow<'a>(
    args: &StudyArgs,
    ready: &ReadyStudy,
    table: &'a DesignTable,
    designs: Range<u64>,
    path: &Path,
    screen: TextScreen,
) -> Result<StudyRows<'a>, Failure> {
    let failed = |why: WriteError| Failure::Output(Some(path.to_owned()), why.into());
    let head = table.head();
    let (mut file, done) = match args.resume {
        true => resumed(ready, table, designs.clone(), path, screen)?,
        false => (
            AppendFile::create(path, &head, output::records()).map_err(failed)?,
            0,
        ),
    };
    if !file.is_locked() {
        note(
            &words().disk_without_locks(&path.display().to_string()),
            screen,
        );
    }
    let rest = designs.start + done..designs.end;
    let mut rows = StudyRows::new(table, rest.end - rest.start, Some(path), screen);
    let outcome = ready
        .run(rest)
        .each(&mut |some| file.write(&rows.lines(&some)));
    let outcome = outcome.and_then(|()| file.finish());
    rows.progress.clear();
    outcome.map_err(failed)?;
    Ok(rows)
}

/// Opens a file to resume and returns it with its number of rows. Returns an error if the checked
/// rows differ from this study's.
fn resumed(
    ready: &ReadyStudy,
    table: &DesignTable,
    designs: Range<u64>,
    path: &Path,
    screen: TextScreen,
) -> Result<(AppendFile, u64), Failure> {
    let failed = |why: WriteError| Failure::Output(Some(path.to_owned()), why.into());
    let shown = path.display().to_string();
    let other = |line: u64| Failure::Usage(words().file_of_other_study(&shown, line));
    let grown = ResumableFile::open(path, &table.head()).map_err(failed)?;
    let grown = grown.ok_or_else(|| other(1))?;
    let all = designs.end - designs.start;
    if grown.lines > all {
        return Err(other(all + 2));
    }
    let mut figures = ready.figures.clone();
    for (number, line) in &grown.samples {
        let numbers = ready.plan.numbers(designs.start + number);
        let row = DesignRow::of(numbers, &mut figures);
        if table.line(&row, false) != *line {
            return Err(other(number + 2));
        }
    }
    rows::verify(ready, table, designs.start, path, grown.lines)?;
    let done = grown.lines;
    note(&words().file_goes_on(&shown, done, all), screen);
    Ok((grown.resume().map_err(failed)?, done))
}

/// Writes rows to standard output, or to a file replaced only after all rows are complete.
fn write<'a>(
    args: &StudyArgs,
    ready: &ReadyStudy,
    table: &'a DesignTable,
    designs: Range<u64>,
    screen: TextScreen,
) -> Result<StudyRows<'a>, Failure> {
    let path = args.output.output.as_deref();
    let mut rows = StudyRows::new(table, designs.end - designs.start, path, screen);
    let outcome = write_to(path, |out: &mut dyn Write| {
        out.write_all(table.head().as_bytes())?;
        let run = ready.run(designs);
        run.each(&mut |some| out.write_all(rows.lines(&some).as_bytes()))?;
        out.write_all(table.foot().as_bytes())
    });
    rows.progress.clear();
    outcome?;
    Ok(rows)
}

/// Reports invalid designs. A complete study without any values is an error.
pub(super) fn report_invalid_designs(
    summary: &DesignSummary,
    reason: &str,
    is_whole: bool,
    screen: TextScreen,
) -> Result<(), Failure> {
    if summary.valued == 0 && is_whole {
        return Err(Failure::Cannot(words().no_design_has_figures(reason)));
    }
    let DesignSummary {
        open, unreadable, ..
    } = *summary;
    if open + unreadable > 0 {
        note(
            &words().designs_left_out(open, unreadable, summary.rows),
            screen,
        );
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_have_every_design_once() {
        for (count, of) in [(1_000_000, 64_u64), (5, 7), (63, 3), (0, 2)] {
            let mut next = 0;
            for k in 1..=of {
                let part: StudyPart = format!("{k}/{of}").parse().unwrap();
                let designs = part.of(count);
                assert_eq!(designs.start, next);
                next = designs.end;
            }
            assert_eq!(next, count);
        }
        for text in ["0/3", "4/3", "1", "1/0", "a/b", "-1/3"] {
            assert!(text.parse::<StudyPart>().is_err(), "{text}");
        }
    }
}
