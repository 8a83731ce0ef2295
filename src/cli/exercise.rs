//! `krank exercise`: a sheet, a file to answer in and a solution, each from a seed.

use super::args::{ExerciseArgs, OutputFormat};
use super::failure::Failure;
use super::output::write_text;
use super::progress::Progress;
use super::screen::TextScreen;
use super::source::SolvableScene;
use crate::files::read_any;
use crate::report::{AnswerFile, CsvDialect, Report, ReportFormat, answer_key, blank_answers};
use crate::scene::{LARGEST_FILE, Scene};
use crate::solver::{Order, Solver, State, Workspace};
use crate::study::{AnswerKey, Exercise, ExerciseMaker, ExerciseTitles};
use crate::wording::words;
use crate::{Ball, report};
use std::ops::RangeInclusive;
use std::path::Path;

/// Significant digits of the solution.
const DIGITS: usize = 6;
/// What an exercise of standard input is called.
const UNNAMED: &str = "exercise";

/// Writes exercises into a folder, or one sheet to standard output.
pub(super) fn exercise(args: &ExerciseArgs, screen: TextScreen) -> Result<(), Failure> {
    let dialect = args.csv.dialect(OutputFormat::Csv)?;
    let seeds = seeds(args)?;
    let SolvableScene { scene, solver } = args.scene.open()?;
    let maker = ExerciseMaker::new(&scene, &solver);
    let stem = stem(&args.scene.scene);
    let made = |seed: u64| MadeExercise::new(&maker, &scene, &stem, seed);
    let Some(folder) = &args.output else {
        let made = made(args.seed)?;
        let format = args.format.unwrap_or(ReportFormat::Text);
        let sheet = made.sheet().written(format, screen.ascii);
        return write_text(None, &sheet);
    };
    for seed in seeds.clone() {
        nothing_lost(&folder.join(format!("{stem}-{seed}.csv")))?;
    }
    let unwritable = |e| Failure::Output(Some(folder.clone()), e);
    std::fs::create_dir_all(folder).map_err(unwritable)?;
    let format = args.format.unwrap_or_default();
    let mut progress = Progress::new(args.count.into(), words().parts(), screen, false);
    for (done, seed) in (1..).zip(seeds) {
        made(seed)?.write(folder, format, dialect, screen)?;
        progress.tell(done);
    }
    progress.end();
    Ok(())
}

/// The seeds that are asked for.
fn seeds(args: &ExerciseArgs) -> Result<RangeInclusive<u64>, Failure> {
    if args.count > 1 && args.output.is_none() {
        return Err(Failure::Usage(words().folder_for_many().into()));
    }
    let last = args.seed.checked_add(u64::from(args.count) - 1);
    let last = last.ok_or_else(|| Failure::Usage(words().seeds_run_out().into()))?;
    Ok(args.seed..=last)
}

/// What the exercises of a scene are called: the preset, or the file without folder and ending.
fn stem(scene: &Path) -> String {
    let stem = scene.file_stem().filter(|stem| *stem != "-");
    stem.map_or_else(|| UNNAMED.into(), |stem| stem.to_string_lossy().into())
}

/// Refuses to write over a file in which somebody has answered.
fn nothing_lost(path: &Path) -> Result<(), Failure> {
    let Ok(bytes) = read_any(path, LARGEST_FILE) else {
        // What cannot be read is told when it cannot be written.
        return Ok(());
    };
    let file = AnswerFile::read(&bytes).unwrap_or_default();
    let is_answered = file.answers.iter().any(|row| !row.answer.is_empty());
    match is_answered || file.student.is_some() {
        true => Err(Failure::Cannot(
            words().answers_are_there(&path.display().to_string()),
        )),
        false => Ok(()),
    }
}

/// A scene at one place, ready to be asked about.
pub(super) struct AskedState {
    state: Workspace,
    enclosure: Workspace<Ball>,
}

impl AskedState {
    /// Solves a scene at a coordinate; where it has no rates there, nothing can be asked for.
    pub(super) fn new(scene: &Scene, solver: &Solver, at: f64) -> Result<AskedState, Failure> {
        let mut state = solver.state();
        let mut enclosure = solver.enclosure();
        let condition = solver.solve(at, Order::Force, &mut state);
        if condition == crate::solver::Condition::NoAssembly {
            return Err(super::commands::out_of_reach(scene, solver, at));
        }
        if !state.has(Order::Acceleration) {
            return Err(Failure::Cannot(words().no_figures_at(&at.to_string())));
        }
        solver.enclose(&mut state, Order::Force, &mut enclosure);
        Ok(AskedState { state, enclosure })
    }

    pub(super) fn state(&self) -> &State {
        self.state.state()
    }

    /// What is asked for, and these figures beside.
    pub(super) fn key(&self, scene: &Scene, solver: &Solver, more: &[String]) -> AnswerKey {
        answer_key(scene, solver, self.state(), self.enclosure.state(), more)
    }
}

/// An exercise and what is asked in it.
struct MadeExercise {
    name: String,
    exercise: Exercise,
    asked: AskedState,
    key: AnswerKey,
}

impl MadeExercise {
    fn new(
        maker: &ExerciseMaker<'_>,
        scene: &Scene,
        stem: &str,
        seed: u64,
    ) -> Result<MadeExercise, Failure> {
        let titles = ExerciseTitles {
            name: words().exercise_called(&scene.name, seed),
            source: words().exercise_made_by(stem, seed),
            note: words().made_by_chance().into(),
        };
        let exercise = maker.exercise(seed, &titles);
        let exercise = exercise.ok_or_else(|| Failure::Cannot(words().no_exercise(seed)))?;
        let at = exercise.scene.mechanism.driver().start;
        let asked = AskedState::new(&exercise.scene, &exercise.solver, at)?;
        Ok(MadeExercise {
            name: format!("{stem}-{seed}"),
            key: asked.key(&exercise.scene, &exercise.solver, &[]),
            exercise,
            asked,
        })
    }

    fn sheet(&self) -> Report {
        let Exercise { scene, solver } = &self.exercise;
        let answers = format!("{}.csv", self.name);
        Report::sheet(scene, solver, self.asked.state(), &self.key, &answers)
    }

    fn solution(&self) -> Report {
        let Exercise { scene, solver } = &self.exercise;
        report::Report::new(scene, solver, self.asked.state(), DIGITS)
    }

    /// Its four files.
    fn write(
        &self,
        folder: &Path,
        format: ReportFormat,
        dialect: CsvDialect,
        screen: TextScreen,
    ) -> Result<(), Failure> {
        let name = &self.name;
        let scene_file = format!("{name}.toml");
        let mut blank = Vec::new();
        let written = blank_answers(&self.key, &scene_file, dialect, &mut blank);
        written.map_err(|e| Failure::Output(None, e))?;
        let ending = format.ending();
        for (file, text) in [
            (scene_file, self.exercise.scene.text().to_owned()),
            (
                format!("{name}.{ending}"),
                self.sheet().written(format, screen.ascii),
            ),
            (
                format!("{name}.csv"),
                String::from_utf8_lossy(&blank).into_owned(),
            ),
            (
                format!("{name}-solution.{ending}"),
                self.solution().written(format, screen.ascii),
            ),
        ] {
            write_text(Some(&folder.join(file)), &text)?;
        }
        Ok(())
    }
}
