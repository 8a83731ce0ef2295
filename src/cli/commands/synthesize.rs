//! `krank synthesize`: finds linkages for a task; each is a scene verified by driving it
//! through the task.

use crate::cli::failure::{Failure, note};
use crate::cli::formats::{CsvArgs, OutputFormat};
use crate::cli::output::{write_text, write_to};
use crate::cli::progress::Progress;
use crate::cli::screen::TextScreen;
use crate::cli::source::{contents, standard_input};
use crate::files::read_without_waiting;
use crate::nearest::nearest;
use crate::parallel;
use crate::report::SynthesisReport;
use crate::scene::{MAX_FILE_SIZE, presets};
use crate::synthesis::{Synthesis, SynthesisSettings, scene_text};
use crate::task_file::{ExampleTask, TaskFile};
use crate::wording::words;
use clap::Args;
use std::io::ErrorKind;
use std::path::{Path, PathBuf, is_separator};

#[cfg(feature = "tui")]
use crate::cli::workbench;
#[cfg(feature = "tui")]
use crate::tui::TaskOrder;

#[derive(Debug, Args)]
pub(in crate::cli) struct SynthesizeArgs {
    #[arg(help = words().task_to_do())]
    task: PathBuf,
    #[arg(help = words().candidates_to_tell())]
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u16).range(1..=1000))]
    top: u16,
    #[arg(help = words().seed_of_search())]
    #[arg(long, value_name = "N", default_value_t = SynthesisSettings::DEFAULT_SEED)]
    seed: u64,
    #[arg(help = words().tolerance_of_candidates())]
    #[arg(long, value_name = "LENGTH", allow_negative_numbers = true)]
    tolerance: Option<f64>,
    #[arg(help = words().how_to_write())]
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    format: OutputFormat,
    #[command(flatten)]
    csv: CsvArgs,
    #[cfg(feature = "tui")]
    #[arg(help = words().candidates_in_workbench())]
    #[arg(long, conflicts_with_all = ["top", "format", "output"])]
    view: bool,
    #[arg(help = words().folder_of_candidates())]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// Progress at the end of the search, in thousandths.
const FULL_PROGRESS: u64 = 1000;

pub(in crate::cli) fn synthesize(args: &SynthesizeArgs, screen: TextScreen) -> Result<(), Failure> {
    let dialect = args.csv.dialect(args.format)?;
    if args
        .tolerance
        .is_some_and(|tolerance| !(tolerance >= 0.0 && tolerance.is_finite()))
    {
        return Err(Failure::Usage(words().tolerance_is_no_length().into()));
    }
    let file = read(&args.task)?;
    #[cfg(feature = "tui")]
    if args.view {
        return workbench::open_task(TaskOrder {
            name: called(&args.task),
            file,
            seed: args.seed,
            tolerance: args.tolerance,
            folder: folder_of(&args.task),
        });
    }
    let order = SynthesisSettings {
        seed: args.seed,
        threads: parallel::cores(),
    };
    let mut progress = Progress::new(FULL_PROGRESS, words().parts(), screen, false).stoppable();
    let found = Synthesis::run(&file.task, order, &mut |part| {
        progress.report_progress((part.clamp(0.0, 1.0) * FULL_PROGRESS as f64) as u64);
        !progress.is_stopped()
    });
    if progress.is_stopped() {
        note(words().search_was_stopped(), screen);
    }
    progress.end();
    let report = SynthesisReport {
        file: &file,
        found: &found,
        top: usize::from(args.top),
    };
    match args.format {
        OutputFormat::Text => write_text(None, &report.to_text(screen.ascii))?,
        OutputFormat::Json => write_text(None, &format!("{:#}\n", report.to_json()))?,
        OutputFormat::Csv => write_to(None, |out| report.write_csv(dialect, out))?,
    }
    if let Some(folder) = &args.output {
        save(folder, &report, args, screen)?;
    }
    match found.good.is_empty() {
        true => Err(Failure::Cannot(report.nothing())),
        false => Ok(()),
    }
}

/// Returns the task's display name: its example, or its file without the extension.
#[cfg(feature = "tui")]
fn called(name: &Path) -> String {
    let stem = name.file_stem().map(|stem| stem.to_string_lossy());
    match stem {
        Some(stem) if stem != "-" => stem.into_owned(),
        _ => "task".into(),
    }
}

/// Returns the folder of a task in a file; an example has none.
#[cfg(feature = "tui")]
fn folder_of(name: &Path) -> Option<PathBuf> {
    let folder = name.parent().filter(|_| name.is_file());
    folder.map(Path::to_owned)
}

/// Reads the task that the command line names: an example, a file, or standard input.
fn read(name: &Path) -> Result<TaskFile, Failure> {
    let text = name.to_str().unwrap_or("");
    let file = if text == "-" {
        TaskFile::read(&standard_input()?, "stdin")
    } else if let Some(example) = ExampleTask::find(text) {
        TaskFile::parse(example.text, example.name)
    } else {
        let is_path = text.contains(is_separator) || text.ends_with(".toml");
        let shown = name.display().to_string();
        if !is_path && !text.is_empty() && !name.exists() {
            return Err(unknown(&shown));
        }
        TaskFile::read(&contents(name)?, &shown)
    };
    file.map_err(Failure::Scene)
}

fn unknown(name: &str) -> Failure {
    let names = || ExampleTask::all().iter().map(|task| task.name);
    if presets::find(name).is_some() {
        return Failure::Usage(words().preset_is_no_task(name));
    }
    let near = nearest(name, names()).map(str::to_owned);
    let all = names().collect::<Vec<_>>().join(", ");
    Failure::Usage(words().no_task_and_no_file(name, &near.unwrap_or(all)))
}

/// Writes a scene for each listed candidate. Returns an error instead of overwriting a file with
/// another text.
fn save(
    folder: &Path,
    report: &SynthesisReport<'_>,
    args: &SynthesizeArgs,
    screen: TextScreen,
) -> Result<(), Failure> {
    let mut files: Vec<(PathBuf, String)> = Vec::new();
    for (number, candidate) in (1..).zip(report.listed_candidates()) {
        let titles = report.titles(number, candidate, args.tolerance);
        let Some(text) = scene_text(&candidate.proposal, &report.file.task, &titles) else {
            continue;
        };
        files.push((folder.join(format!("candidate-{number}.toml")), text));
    }
    if files.is_empty() {
        return Ok(());
    }
    for (path, text) in &files {
        let is_lost = match read_without_waiting(path, MAX_FILE_SIZE) {
            Ok(bytes) => bytes != text.as_bytes(),
            // If the folder is a file, creating it fails with an error below.
            Err(error) => !matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory),
        };
        if is_lost {
            return Err(Failure::Cannot(
                words().scene_would_be_lost(&path.display().to_string()),
            ));
        }
    }
    let unwritable = |e| Failure::Output(Some(folder.to_owned()), e);
    std::fs::create_dir_all(folder).map_err(unwritable)?;
    for (path, text) in &files {
        write_text(Some(path), text)?;
    }
    note(
        &words().candidates_written(files.len(), &folder.display().to_string()),
        screen,
    );
    Ok(())
}
