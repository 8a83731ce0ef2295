//! `krank grade`: grades the answers of one student or of a class.

use crate::cli::failure::{Failure, note};
use crate::cli::formats::{CsvArgs, OutputFormat};
use crate::cli::output::{OutputArgs, write_text, write_to};
use crate::cli::place::{PlaceArgs, out_of_reach, place};
use crate::cli::screen::TextScreen;
use crate::cli::source::{
    AssemblyArgs, SolvableScene, check_output_differs, check_output_differs_from_input, find, load,
};
use crate::files::read_without_waiting;
use crate::page::TextStyle;
use crate::report::{
    AnswerFile, GradedAnswers, NoAnswers, QuestionState, class_csv, class_page, named_again,
};
use crate::scene::MAX_FILE_SIZE;
use crate::solver::Condition;
use crate::wording::words;
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf, is_separator};

#[derive(Debug, Args)]
pub(in crate::cli) struct GradeArgs {
    #[arg(help = words().sheet_to_grade())]
    sheet: PathBuf,
    #[arg(help = words().files_of_answers())]
    #[arg(required = true)]
    answers: Vec<PathBuf>,
    #[command(flatten)]
    place: PlaceArgs,
    #[command(flatten)]
    assembly: AssemblyArgs,
    #[arg(help = words().how_to_write_grades())]
    #[arg(long, value_enum, default_value_t = GradeFormat::Text)]
    format: GradeFormat,
    #[command(flatten)]
    csv: CsvArgs,
    #[command(flatten)]
    output: OutputArgs,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum GradeFormat {
    #[value(help = words().format_text())]
    Text,
    #[value(help = words().format_csv())]
    Csv,
}

/// Grades every file. A file that cannot be graded is reported, and the others are still graded.
pub(in crate::cli) fn grade(args: &GradeArgs, screen: TextScreen) -> Result<(), Failure> {
    let dialect = args.csv.dialect(match args.format {
        GradeFormat::Text => OutputFormat::Text,
        GradeFormat::Csv => OutputFormat::Csv,
    })?;
    let mut grader = Grader {
        args,
        screen,
        sheets: Vec::new(),
        named: Vec::new(),
    };
    let path = args.output.output.as_deref();
    for file in &args.answers {
        check_output_differs_from_input(file, path)?;
    }
    if !args.sheet.is_dir() {
        check_output_differs(&find(&args.sheet)?, path)?;
        grader.sheet(&args.sheet)?;
    }
    let mut class = Vec::new();
    let mut missing = 0;
    for file in &args.answers {
        match grader.graded(file) {
            Ok(graded) => class.push(graded),
            Err(failure) if args.answers.len() == 1 => return Err(failure),
            Err(failure) => {
                failure.print_error(screen);
                missing += 1;
            }
        }
    }
    for sheet in &grader.named {
        check_output_differs_from_input(sheet, path)?;
    }
    for (student, files) in named_again(&class) {
        note(&words().student_again(student, &files.join(", ")), screen);
    }
    let style = TextStyle::plain(screen.ascii);
    match (args.format, &class[..]) {
        (GradeFormat::Csv, class) => write_to(path, |out| class_csv(class, dialect, out))?,
        (GradeFormat::Text, [one]) => write_text(path, &one.page().to_text(style))?,
        (GradeFormat::Text, class) => write_text(path, &class_page(class).to_text(style))?,
    }
    match missing {
        0 => Ok(()),
        some => Err(Failure::Usage(
            words().some_not_graded(some, args.answers.len()),
        )),
    }
}

/// Grades files, with a cache of their sheets.
struct Grader<'a> {
    args: &'a GradeArgs,
    screen: TextScreen,
    sheets: Vec<OpenSheet>,
    /// The sheets in a folder that the files name, valid or not.
    named: Vec<PathBuf>,
}

/// An opened sheet.
struct OpenSheet {
    path: PathBuf,
    scene: SolvableScene,
    state: QuestionState,
}

impl Grader<'_> {
    /// Returns the sheet of a path, opened only once.
    fn sheet(&mut self, path: &Path) -> Result<&OpenSheet, Failure> {
        let place_of = |sheets: &[OpenSheet]| sheets.iter().position(|s| s.path == path);
        let known = match place_of(&self.sheets) {
            Some(known) => known,
            None => {
                let scene = load(&find(path)?, &self.args.assembly.wishes)?;
                let SolvableScene { scene: of, solver } = &scene;
                let at = place(&self.args.place, of, solver, self.screen);
                let requested = QuestionState::new(solver, at);
                let requested = requested.map_err(|condition| match condition {
                    Condition::NoAssembly => out_of_reach(of, solver, at),
                    _ => Failure::Cannot(words().no_figures_at(&at.to_string())),
                })?;
                self.sheets.push(OpenSheet {
                    path: path.to_owned(),
                    scene,
                    state: requested,
                });
                self.sheets.len() - 1
            }
        };
        Ok(&self.sheets[known])
    }

    /// Grades one file by the given sheet, or by the sheet in the given folder that the file names.
    fn graded(&mut self, path: &Path) -> Result<GradedAnswers, Failure> {
        let shown = path.display().to_string();
        let file = answers(path, &shown)?;
        let is_folder = self.args.sheet.is_dir();
        let sheet = match is_folder {
            true => {
                let sheet = named_sheet(&self.args.sheet, path, &file)?;
                self.named.push(sheet.clone());
                sheet
            }
            false => self.args.sheet.clone(),
        };
        let name = sheet.file_name().unwrap_or(sheet.as_os_str());
        let name = name.to_string_lossy().into_owned();
        if let Some(named) = file
            .sheet
            .as_ref()
            .filter(|own| !is_folder && **own != name)
        {
            note(
                &words().answers_another_sheet(&shown, named, &name),
                self.screen,
            );
        }
        let OpenSheet {
            scene,
            state: requested,
            ..
        } = self.sheet(&sheet)?;
        let opened = requested.opened(&scene.scene, &scene.solver);
        let file = file.of_scene(&scene.scene);
        let key = requested.key(&scene.scene, &scene.solver, &file.names());
        let graded = GradedAnswers::new(&key, &file, path, (&name, opened));
        match graded.remarks.unknown_names.len() < file.answers.len() {
            true => Ok(graded),
            false => Err(Failure::Usage(words().names_no_figure(&shown, &name))),
        }
    }
}

/// Reads a file of answers.
fn answers(path: &Path, shown: &str) -> Result<AnswerFile, Failure> {
    let bytes = read_without_waiting(path, MAX_FILE_SIZE)
        .map_err(|e| Failure::Usage(words().cannot_read(&format!("`{shown}`"), &e)))?;
    if bytes.len() > MAX_FILE_SIZE {
        return Err(Failure::Usage(words().too_many_answers(shown)));
    }
    AnswerFile::read(&bytes).map_err(|why| {
        Failure::Usage(match why {
            NoAnswers::NoFigure => words().holds_no_answers(shown),
            NoAnswers::TooLong => words().too_many_answers(shown),
        })
    })
}

/// Returns the scene in a folder that a file of answers names, or whose name equals the file's. A
/// name that leads outside the folder is an error.
fn named_sheet(folder: &Path, path: &Path, file: &AnswerFile) -> Result<PathBuf, Failure> {
    let own = || {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        format!("{stem}.toml")
    };
    let name = file.sheet.clone().unwrap_or_else(own);
    let sheet = folder.join(&name);
    let is_inside = name.ends_with(".toml") && !name.contains(is_separator);
    match is_inside && sheet.is_file() {
        true => Ok(sheet),
        false => Err(Failure::Usage(
            words().names_no_sheet(&path.display().to_string(), &name),
        )),
    }
}
