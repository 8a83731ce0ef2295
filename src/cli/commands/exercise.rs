//! `krank exercise`: writes a sheet, a file for the answers and a solution for each seed.

use crate::cli::choice::one_of;
use crate::cli::commands::report::formats;
use crate::cli::failure::Failure;
use crate::cli::formats::{CsvArgs, OutputFormat};
use crate::cli::output::write_text;
use crate::cli::progress::Progress;
use crate::cli::screen::TextScreen;
use crate::cli::source::{SceneArgs, SolvableScene};
use crate::files::read_without_waiting;
use crate::report::{CsvDialect, MadeExercise, Report, ReportFormat, blank_answers, is_blank};
use crate::scene::{MAX_FILE_SIZE, Scene};
use crate::study::ExerciseMaker;
use crate::wording::words;
use clap::Args;
use std::io::ErrorKind;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

#[derive(Debug, Args)]
pub(in crate::cli) struct ExerciseArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[arg(help = words().seed_of_exercise())]
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    #[arg(help = words().count_of_exercises())]
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=1000))]
    count: u16,
    #[arg(help = words().format_of_sheet())]
    #[arg(long, value_parser = one_of(formats()))]
    format: Option<ReportFormat>,
    #[command(flatten)]
    csv: CsvArgs,
    #[arg(help = words().folder_of_exercises())]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// File stem of exercises for a scene on standard input.
const UNNAMED: &str = "exercise";

/// Writes exercises into a folder, or one sheet to standard output.
pub(in crate::cli) fn exercise(args: &ExerciseArgs, screen: TextScreen) -> Result<(), Failure> {
    let dialect = args.csv.dialect(OutputFormat::Csv)?;
    let seeds = seeds(args)?;
    let SolvableScene { scene, solver } = args.scene.open()?;
    let maker = ExerciseMaker::new(&scene, &solver);
    let stem = stem(&args.scene.scene);
    let typed = shell_arguments(&args.scene);
    let made = |seed: u64| GeneratedExercise::new(&maker, &scene, [&stem, &typed], seed);
    let Some(folder) = &args.output else {
        let made = made(args.seed)?;
        let format = args.format.unwrap_or(ReportFormat::Text);
        let sheet = made.sheet().written(format, screen.ascii);
        return write_text(None, &sheet);
    };
    let format = args.format.unwrap_or_default();
    let style = (format, dialect, screen);
    for seed in seeds.clone() {
        let names = endings(format).map(|ending| format!("{stem}-{seed}{ending}"));
        // A check of the contents is needed only if a file exists.
        if names.iter().any(|name| folder.join(name).exists()) {
            made(seed)?.check_nothing_overwritten(folder, style)?;
        }
    }
    let unwritable = |e| Failure::Output(Some(folder.clone()), e);
    let mut progress = Progress::new(args.count.into(), words().parts(), screen, false);
    for (done, seed) in (1..).zip(seeds) {
        let exercise = made(seed)?;
        // A scene without exercises leaves no folder behind.
        std::fs::create_dir_all(folder).map_err(unwritable)?;
        exercise.write(folder, style)?;
        progress.report_progress(done);
    }
    progress.end();
    Ok(())
}

/// Returns the requested seeds.
fn seeds(args: &ExerciseArgs) -> Result<RangeInclusive<u64>, Failure> {
    if args.count > 1 && args.output.is_none() {
        return Err(Failure::Usage(words().folder_for_many().into()));
    }
    let last = args.seed.checked_add(u64::from(args.count) - 1);
    let last = last.ok_or_else(|| Failure::Usage(words().seeds_run_out().into()))?;
    Ok(args.seed..=last)
}

/// Returns the file stem of a scene's exercises: the preset's name, or the file's without folder
/// and extension.
fn stem(scene: &Path) -> String {
    let stem = scene.file_stem().filter(|stem| *stem != "-");
    stem.map_or_else(|| UNNAMED.into(), |stem| stem.to_string_lossy().into())
}

/// Formats the scene and its assembly as shell arguments.
fn shell_arguments(args: &SceneArgs) -> String {
    let scene = for_shell(&args.scene.to_string_lossy());
    let requests: Vec<String> = args
        .assembly
        .wishes
        .iter()
        .map(ToString::to_string)
        .collect();
    match requests.is_empty() {
        true => scene,
        false => format!("{scene} --assembly {}", for_shell(&requests.join(","))),
    }
}

/// Quotes a word for a shell if it contains anything but letters, digits and characters of paths.
fn for_shell(word: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "-_./,=+:@%".contains(c);
    match !word.is_empty() && word.chars().all(is_plain) {
        true => word.to_owned(),
        false => format!("'{}'", word.replace('\'', r"'\''")),
    }
}

/// How the files of an exercise are written.
type FileStyle = (ReportFormat, CsvDialect, TextScreen);

/// An exercise and the name of its files.
struct GeneratedExercise {
    name: String,
    made: MadeExercise,
}

impl GeneratedExercise {
    /// Creates the exercise of a seed. `stem` starts the names of its files; `typed` is the scene
    /// on the command line that recreates it.
    fn new(
        maker: &ExerciseMaker<'_>,
        scene: &Scene,
        [stem, typed]: [&str; 2],
        seed: u64,
    ) -> Result<GeneratedExercise, Failure> {
        let made = MadeExercise::new(maker, scene, typed, seed).map_err(Failure::Cannot)?;
        Ok(GeneratedExercise {
            name: format!("{stem}-{seed}"),
            made,
        })
    }

    fn sheet(&self) -> Report {
        self.made.sheet(&self.name)
    }

    /// Returns the four files as pairs of name ending and contents. Only the file of answers is to
    /// be filled in.
    fn files(
        &self,
        (format, dialect, screen): FileStyle,
    ) -> Result<[(String, String); 4], Failure> {
        let mut blank = Vec::new();
        let written = blank_answers(self.made.key(), &self.scene_file(), dialect, &mut blank);
        written.map_err(|e| Failure::Output(None, e))?;
        let [scene, answers, sheet, solution] = endings(format);
        Ok([
            (scene, self.made.scene().text().to_owned()),
            (answers, String::from_utf8_lossy(&blank).into_owned()),
            (sheet, self.sheet().written(format, screen.ascii)),
            (solution, self.made.solution().written(format, screen.ascii)),
        ])
    }

    fn scene_file(&self) -> String {
        format!("{}.toml", self.name)
    }

    /// Returns an error if a file with other contents would be overwritten. An existing file of
    /// answers may be replaced only if it has no answers.
    fn check_nothing_overwritten(&self, folder: &Path, style: FileStyle) -> Result<(), Failure> {
        for (ending, text) in self.files(style)? {
            let path = folder.join(format!("{}{ending}", self.name));
            let is_lost = match read_without_waiting(&path, MAX_REPORT_SIZE) {
                Ok(bytes) if ending == ANSWERS => {
                    !is_blank(&bytes, self.made.key(), &self.scene_file())
                }
                Ok(bytes) => bytes != text.as_bytes(),
                Err(error) => error.kind() != ErrorKind::NotFound,
            };
            if is_lost {
                let shown = path.display().to_string();
                return Err(Failure::Cannot(words().would_be_lost(&shown)));
            }
        }
        Ok(())
    }

    /// Writes its four files.
    fn write(&self, folder: &Path, style: FileStyle) -> Result<(), Failure> {
        for (ending, text) in self.files(style)? {
            let path = folder.join(format!("{}{ending}", self.name));
            write_text(Some(&path), &text)?;
        }
        Ok(())
    }
}

/// Ending of the file of answers.
const ANSWERS: &str = ".csv";
/// Maximum size of a report written by krank, in bytes.
const MAX_REPORT_SIZE: usize = 16 * MAX_FILE_SIZE;

/// Returns the endings of the four files: scene, answers, sheet and solution.
fn endings(format: ReportFormat) -> [String; 4] {
    let ending = format.ending();
    [
        ".toml".into(),
        ANSWERS.into(),
        format!(".{ending}"),
        format!("-solution.{ending}"),
    ]
}
