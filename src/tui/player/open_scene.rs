//! The open scene: results computed once when it opens, and results at the driver's coordinate.

use crate::Ball;
use crate::document::ascii_letter;
use crate::drawing::{Reach, Role, vector_roles};
use crate::quantity::{Catalogue, DriverState, Quantity, Sensitivity};
use crate::report::{
    Answers, Forces, PositionMethod, Tables, ToleranceAnswers, ToleranceReport, Verdict,
};
use crate::scene::presets::{self, Preset};
use crate::scene::{Scene, sanitized};
use crate::solver::{Condition, GroupId, Order, Pick, Solver, State, Workspace};
use crate::study::{Distribution, SampleOrder, ToleranceStudy};
use crate::tui::figures::force_figures::ForceFigures;
use crate::tui::figures::sheet::Sheet;
use crate::tui::player::assembly_list::AssemblyList;
use crate::tui::player::cost::Cost;
use crate::tui::player::driver_range::DriverRange;
use crate::tui::player::edition::SceneRevision;
use crate::tui::player::explained::Explained;
use crate::tui::player::timetable::Timetable;
use crate::tui::player::watched_method::WatchedMethod;
use crate::tui::{Opened, Origin};
use std::borrow::Cow;
use std::path::PathBuf;

/// Numbers of states for sizing the tables' columns; fewer if a state has very many rows.
const SAMPLES: u16 = 72;
const MIN_SAMPLES: u16 = 6;
const MAX_ROWS: usize = 20_000;

/// An open scene at one driver coordinate.
#[derive(Debug)]
pub(crate) struct OpenScene {
    edition: SceneRevision,
    opened: Opened,
    driver_range: DriverRange,
    reach: Reach,
    verdict: Verdict,
    sheet: Sheet,
    /// The drawing role of the link of each row of the vectors.
    vector_roles: Vec<Option<Role>>,
    /// The driver state; and its time, if the driver has a motion over time.
    stand: DriverState,
    time: Option<f64>,
    timetable: Option<Timetable>,
    state: Workspace,
    enclosure: Workspace<Ball>,
    tables: Tables,
    cost: Cost,
    /// The effect of the lengths, while its view is visible.
    answers: Option<LengthsQuestion>,
    /// The forces, while they are shown and if loads act.
    force_figures: Option<ForceFigures>,
    /// The assemblies of the groups, while they are listed.
    assembly_list: Option<AssemblyList>,
    /// The written solution of the state, while its view is visible.
    explained: Option<Explained>,
    /// The watched method at the current state.
    watched: Option<WatchedMethod>,
}

/// The sensitivity of the motion to the lengths, with its results.
#[derive(Debug)]
struct LengthsQuestion {
    sensitivity: Sensitivity,
    answers: Answers,
    /// The tolerance study and its results, if the scene has tolerances.
    tolerances: Option<(ToleranceStudy, ToleranceAnswers)>,
    /// The effect of all tolerances on one quantity, at the coordinate where it was requested.
    told: Option<ToleranceReport>,
}

/// Number of random machines for the tolerance report on one quantity.
const MACHINES: u32 = 10_000;

/// Maximum number of lengths. More would delay the frame.
const MAX_LENGTHS: usize = 200;

impl OpenScene {
    /// Opens a scene at its initial position.
    pub(crate) fn new(opened: Opened) -> Self {
        let driver_range = DriverRange::new(&opened.scene, &opened.solver);
        let reach = Reach::of(&opened.scene, &opened.solver);
        let mut state = opened.solver.state();
        let timetable = Timetable::new(&opened.scene, opened.solver.motion().range);
        let places = places(&opened.scene, &driver_range, timetable.as_ref());
        let samples = samples(&opened, &places, &mut state);
        let stand = places[0];
        let mut enclosure = opened.solver.enclosure();
        OpenScene {
            edition: SceneRevision::default(),
            verdict: Verdict::new(&opened.scene, &opened.solver),
            sheet: Sheet::new(&samples),
            vector_roles: vector_roles(&opened.scene),
            tables: solved(
                &opened,
                &stand,
                Order::Acceleration,
                &mut state,
                &mut enclosure,
            ),
            answers: None,
            force_figures: None,
            cost: Cost::default(),
            enclosure,
            opened,
            driver_range,
            reach,
            stand,
            time: timetable.is_some().then_some(0.0),
            timetable,
            state,
            assembly_list: None,
            explained: None,
            watched: None,
        }
    }

    /// Returns the revision, the key for cached results on this scene.
    pub(crate) fn edition(&self) -> &SceneRevision {
        &self.edition
    }

    /// Returns the scene with another assembly of a group, at the same position. The error is a
    /// message.
    pub(crate) fn switched(&self, group: GroupId, pick: Pick) -> Result<OpenScene, String> {
        let Opened {
            scene,
            solver,
            origin,
        } = &self.opened;
        let switched = solver.switched(self.at(), group, pick);
        let solver = switched.map_err(|fault| scene.explain(&fault).first_words().to_owned())?;
        let (scene, origin) = (scene.clone(), origin.clone());
        let mut open_scene = OpenScene::new(Opened {
            scene,
            solver,
            origin,
        });
        open_scene.stand_at(self.stand, self.time);
        Ok(open_scene)
    }

    /// Computes the assemblies of all groups at the current coordinate.
    pub(crate) fn compute_assemblies(&mut self) -> Option<&AssemblyList> {
        let Opened { scene, solver, .. } = &self.opened;
        self.assembly_list = AssemblyList::new(scene, solver, self.at(), &self.reach);
        self.assembly_list.as_ref()
    }

    /// Returns the result of [`OpenScene::compute_assemblies`].
    pub(crate) fn assembly_list(&self) -> Option<&AssemblyList> {
        self.assembly_list.as_ref()
    }

    /// Returns the scene's text with the start positions of this assembly.
    pub(crate) fn saved_text(&self) -> Option<String> {
        let Opened { scene, solver, .. } = &self.opened;
        scene.with_start_of(solver, self.at())
    }

    /// Replaces the scene by another text of the same mechanism.
    pub(crate) fn retell(&mut self, scene: Scene) {
        self.opened.scene = scene;
        self.timetable = Timetable::new(&self.opened.scene, self.opened.solver.motion().range);
        self.driver_range = DriverRange::new(&self.opened.scene, &self.opened.solver);
    }

    /// Replaces the scene by another text of the same mechanism, saved in a file of its own.
    pub(crate) fn rename(&mut self, scene: Scene, file: PathBuf) {
        self.opened.scene = scene;
        self.opened.origin = Origin::File(file);
        self.driver_range = DriverRange::new(&self.opened.scene, &self.opened.solver);
    }

    /// Moves the driver to any coordinate. A motion over time moves to the nearest time at which it
    /// has that coordinate.
    pub(crate) fn go(&mut self, at: f64) {
        let Some(timetable) = &self.timetable else {
            return self.stand_at(DriverState::at(at), None);
        };
        let time = timetable.nearest(at, self.time.unwrap_or(0.0));
        self.stand_at(timetable.stand_at(at, time), time);
    }

    /// Moves the driver to its position at a time, if it has a motion over time.
    pub(crate) fn go_to_time(&mut self, time: f64) {
        if let Some(timetable) = &self.timetable {
            self.stand_at(timetable.stand(time), Some(time));
        }
    }

    fn stand_at(&mut self, stand: DriverState, time: Option<f64>) {
        (self.stand, self.time) = (stand, time);
        let at = stand.at;
        self.assembly_list = None;
        let order = match self.force_figures {
            Some(_) => Order::Force,
            None => Order::Acceleration,
        };
        let (state, enclosure) = (&mut self.state, &mut self.enclosure);
        self.tables = solved(&self.opened, &stand, order, state, enclosure);
        if let Some(asked) = &mut self.answers {
            let unit = self.opened.scene.unit.symbol();
            asked.answers = Answers::at(&mut asked.sensitivity, unit, at).worth_reading();
            if let Some((study, found)) = &mut asked.tolerances {
                *found = ToleranceAnswers::at(&self.opened.scene, study, at);
            }
        }
        if let Some(force_figures) = &mut self.force_figures {
            let Opened { scene, solver, .. } = &self.opened;
            let forces = Forces::new(scene, solver, &self.state, Some(&self.enclosure));
            force_figures.follow(forces);
        }
        if let Some(explained) = &mut self.explained {
            explained.go(&self.opened, &stand);
        }
        if let Some(watched) = &mut self.watched {
            watched.go(&self.opened, at);
        }
    }

    /// Starts computing the forces at every position, or stops it.
    pub(crate) fn balance_forces(&mut self, wanted: bool) {
        if wanted && self.force_figures.is_some() {
            return;
        }
        self.force_figures = None;
        if !(wanted && self.opened.solver.has_forces()) {
            return;
        }
        let Opened { scene, solver, .. } = &self.opened;
        let mut state = solver.state();
        let samples = self.places().into_iter().filter_map(|stand| {
            let _ = stand.solve(solver, Order::Force, &mut state);
            Forces::new(scene, solver, &state, None)
        });
        let samples: Vec<Forces> = samples.collect();
        let (state, enclosure) = (&mut self.state, &mut self.enclosure);
        let _ = self.stand.solve(solver, Order::Force, state);
        solver.enclose(state, Order::Force, enclosure);
        let forces = Forces::new(scene, solver, state, Some(enclosure));
        self.force_figures = forces.map(|forces| ForceFigures::new(forces, &samples));
    }

    /// Returns the forces, if they are shown and loads act.
    pub(crate) fn force_figures(&self) -> Option<&ForceFigures> {
        self.force_figures.as_ref()
    }

    /// Starts writing the solution at every position, or stops it.
    pub(crate) fn explain(&mut self, wanted: bool) {
        if wanted && self.explained.is_some() {
            return;
        }
        self.explained = wanted
            .then(|| Explained::new(&self.opened, &self.stand))
            .flatten();
    }

    /// Returns the written solution, if it is shown and the scene is not too large.
    pub(crate) fn explained(&self) -> Option<&Explained> {
        self.explained.as_ref()
    }

    /// Starts watching a method from a guess, or stops if `None`.
    pub(crate) fn watch(&mut self, method: Option<PositionMethod>, guess: &str) {
        if self.watched.as_ref().map(WatchedMethod::method) != method {
            let new = |method| WatchedMethod::new((method, guess), &self.opened, self.at());
            self.watched = method.and_then(new);
        }
    }

    /// Sets the initial guess of the watched method.
    ///
    /// # Errors
    /// Returns a message if the guess is invalid for this scene; the previous one then stays.
    pub(crate) fn guess(&mut self, guess: &str) -> Result<(), String> {
        let watched = self.watched.as_mut();
        watched.map_or(Ok(()), |watched| watched.begin_at(guess, &self.opened))
    }

    /// Returns the watched method, if the scene is not too large.
    pub(crate) fn watched(&self) -> Option<&WatchedMethod> {
        self.watched.as_ref()
    }

    /// Measures the cost of solving the state without bounds. Uses a state of its own, because the
    /// current one may hold forces.
    pub(crate) fn weigh(&mut self) {
        let OpenScene { opened, stand, .. } = self;
        let mut state = opened.solver.state();
        self.cost.measure(|| {
            let _ = opened
                .solver
                .solve(stand.at, Order::Acceleration, &mut state);
        });
    }

    /// Returns the last measured cost.
    pub(crate) fn cost(&self) -> Option<String> {
        self.cost.text()
    }

    /// Returns the largest error bound of a point's coordinates; `None` if any bound is missing.
    pub(crate) fn largest_bound(&self) -> Option<f64> {
        let places = self.tables.points.iter().filter_map(|p| p.motion[0]);
        let mut bounds = places.flat_map(|place| [place.bounds[0], place.bounds[1]]);
        bounds.try_fold(0.0, |most: f64, bound| Some(most.max(bound?)))
    }

    /// Starts computing the effect of the lengths at every position, or stops it.
    pub(crate) fn answer(&mut self, wanted: bool) {
        if wanted && self.answers.is_some() {
            return;
        }
        self.answers = None;
        if wanted && !self.has_too_many_lengths() {
            let Opened { scene, solver, .. } = &self.opened;
            let figures = Catalogue::new(scene).figures();
            let mut sensitivity = Sensitivity::new(scene, solver, &figures);
            let answers = Answers::at(&mut sensitivity, scene.unit.symbol(), self.at());
            let answers = answers.worth_reading();
            let of_motion = figures.into_iter().filter(|q| q.order() != Order::Force);
            let of_motion: Vec<Quantity> = of_motion.collect();
            let study = ToleranceStudy::new(scene, solver, scene.tolerances(), &of_motion);
            let tolerances = study.ok().map(|mut study| {
                let found = ToleranceAnswers::at(scene, &mut study, self.at());
                (study, found)
            });
            self.answers = Some(LengthsQuestion {
                sensitivity,
                answers,
                tolerances,
                told: None,
            });
        }
    }

    /// Returns `true` if the scene has too many lengths to compute their effect.
    pub(crate) fn has_too_many_lengths(&self) -> bool {
        self.opened.scene.mechanism.lengths().len() > MAX_LENGTHS
    }

    /// Returns the effect of the lengths, if it is shown and the lengths are not too many.
    pub(crate) fn answers(&self) -> Option<&Answers> {
        self.answers.as_ref().map(|asked| &asked.answers)
    }

    /// Returns the effect of tolerances, if it is shown and the scene has tolerances.
    pub(crate) fn tolerance_answers(&self) -> Option<&ToleranceAnswers> {
        let (_, found) = self.answers.as_ref()?.tolerances.as_ref()?;
        Some(found)
    }

    /// Computes the effect of all tolerances on one quantity, while the lengths are shown.
    ///
    /// # Errors
    /// Returns a message if the tolerance study fails.
    pub(crate) fn tell_tolerance(&mut self, figure: Quantity) -> Result<(), String> {
        let at = self.at();
        let Opened { scene, solver, .. } = &self.opened;
        let mut study = ToleranceStudy::new(scene, solver, scene.tolerances(), &[figure])
            .map_err(|why| why.to_string())?;
        let order = SampleOrder {
            count: MACHINES,
            seed: 1,
            distribution: Distribution::default(),
        };
        let condition = self.state.condition();
        let report = ToleranceReport::at(scene, &mut study, at, condition, Some(order));
        if let Some(asked) = &mut self.answers {
            asked.told = Some(report);
        }
        Ok(())
    }

    /// Returns the tolerance report on one quantity, if requested.
    pub(crate) fn told_tolerance(&self) -> Option<&ToleranceReport> {
        self.answers.as_ref()?.told.as_ref()
    }

    /// Drops the tolerance report on one quantity. Returns `false` if there was none.
    pub(crate) fn leave_tolerance(&mut self) -> bool {
        let told = self.answers.as_mut().and_then(|asked| asked.told.take());
        told.is_some()
    }

    pub(crate) fn scene(&self) -> &Scene {
        &self.opened.scene
    }

    pub(crate) fn solver(&self) -> &Solver {
        &self.opened.solver
    }

    pub(crate) fn origin(&self) -> &Origin {
        &self.opened.origin
    }

    pub(crate) fn driver_range(&self) -> &DriverRange {
        &self.driver_range
    }

    /// Rebuilds cached text in the current language. The written solution is rebuilt when it is
    /// shown.
    pub(crate) fn say_again(&mut self) {
        self.verdict = Verdict::new(&self.opened.scene, &self.opened.solver);
        self.explained = None;
    }

    /// Returns the verdict on the linkage as a whole.
    pub(crate) fn verdict(&self) -> &Verdict {
        &self.verdict
    }

    pub(crate) fn reach(&self) -> &Reach {
        &self.reach
    }

    pub(crate) fn sheet(&self) -> &Sheet {
        &self.sheet
    }

    /// Returns the drawing role of the link of a row of the vectors.
    pub(crate) fn vector_role(&self, row: usize) -> Option<Role> {
        self.vector_roles.get(row).copied().flatten()
    }

    /// Returns the driver's coordinate, in degrees or in the scene's length unit.
    pub(crate) fn at(&self) -> f64 {
        self.stand.at
    }

    /// Returns the driver's coordinate with its rates.
    pub(crate) fn stand(&self) -> &DriverState {
        &self.stand
    }

    /// Returns the time at the driver's position, in s from the start of its motion. `None` outside
    /// the motion, and for a driver with constant speed.
    pub(crate) fn time(&self) -> Option<f64> {
        self.time
    }

    /// Returns the driver's motion over time, if the scene has one.
    pub(crate) fn timetable(&self) -> Option<&Timetable> {
        self.timetable.as_ref()
    }

    /// Returns the current state with the rates at the scene's constant driver speed, even if it
    /// has a motion over time.
    pub(crate) fn state_by_speed(&self) -> State {
        let mut state = self.opened.solver.state();
        let order = match self.force_figures {
            Some(_) => Order::Force,
            None => Order::Acceleration,
        };
        let _ = self.opened.solver.solve(self.at(), order, &mut state);
        state.into_state()
    }

    pub(crate) fn state(&self) -> &State {
        &self.state
    }

    pub(crate) fn condition(&self) -> Condition {
        self.state.condition()
    }

    pub(crate) fn tables(&self) -> &Tables {
        &self.tables
    }

    /// Computes the tables with bounds at another driver state.
    pub(crate) fn tables_at(
        &self,
        stand: &DriverState,
        state: &mut Workspace,
        enclosure: &mut Workspace<Ball>,
    ) -> Tables {
        solved(&self.opened, stand, Order::Acceleration, state, enclosure)
    }

    /// Returns driver states over the whole motion, the initial one first.
    pub(crate) fn places(&self) -> Vec<DriverState> {
        places(
            &self.opened.scene,
            &self.driver_range,
            self.timetable.as_ref(),
        )
    }

    /// Returns the unit of the driver's coordinate.
    pub(crate) fn unit(&self) -> &'static str {
        if self.driver_range.turns() {
            "deg"
        } else {
            self.opened.scene.unit.symbol()
        }
    }

    /// Returns the preset at a distance in the list. From a scene that is no preset, returns the
    /// first or the last.
    pub(crate) fn preset_at(&self, distance: isize) -> Option<&'static Preset> {
        let all = presets::all();
        let position = match &self.opened.origin {
            Origin::Preset(name) => all.iter().position(|preset| preset.name == name.as_str()),
            Origin::File(_) | Origin::New(_) | Origin::Stdin => None,
        };
        let count = isize::try_from(all.len()).ok().filter(|&n| n > 0)?;
        let target = match position {
            Some(here) => isize::try_from(here).ok()? + distance,
            None if distance > 0 => 0,
            None => -1,
        };
        all.get(usize::try_from(target.rem_euclid(count)).ok()?)
    }
}

/// Solves a state to `order` and computes its tables with bounds.
pub(crate) fn solved(
    opened: &Opened,
    stand: &DriverState,
    order: Order,
    state: &mut Workspace,
    enclosure: &mut Workspace<Ball>,
) -> Tables {
    let _ = stand.solve(&opened.solver, order, state);
    stand.drive(&opened.solver, enclosure);
    opened.solver.enclose(state, order, enclosure);
    Tables::bounded(&opened.scene, state, enclosure)
}

/// Computes the tables at driver states.
fn samples(opened: &Opened, places: &[DriverState], state: &mut Workspace) -> Vec<Tables> {
    places
        .iter()
        .map(|stand| {
            let _ = stand.solve(&opened.solver, Order::Acceleration, state);
            Tables::new(&opened.scene, state)
        })
        .collect()
}

/// Returns driver states over the whole motion, the initial one first.
fn places(
    scene: &Scene,
    driver_range: &DriverRange,
    timetable: Option<&Timetable>,
) -> Vec<DriverState> {
    let (low, high) = driver_range.shuttle().unwrap_or((
        driver_range.opening(),
        driver_range.opening() + driver_range.span(),
    ));
    let mechanism = &scene.mechanism;
    let rows = mechanism.points().len() + mechanism.links().len();
    let count = u16::try_from(MAX_ROWS / rows.max(1)).unwrap_or(SAMPLES);
    let count = count.clamp(MIN_SAMPLES, SAMPLES);
    let share = |k: u16| f64::from(k) / f64::from(count);
    let spread = (0..=count).map(|k| low + (high - low) * share(k));
    let spread = std::iter::once(driver_range.opening()).chain(spread);
    match timetable {
        None => spread.map(DriverState::at).collect(),
        // Outside its motion over time, the driver has the scene's constant speed.
        Some(timetable) => {
            let times = (0..=count).map(|k| timetable.period() * share(k));
            let moved = times.map(|time| timetable.stand(time));
            let off = spread.filter(|&at| timetable.nearest(at, 0.0).is_none());
            moved
                .chain(off.map(|at| timetable.stand_at(at, None)))
                .collect()
        }
    }
}

/// Returns text of a scene in displayable form: characters of one column that the terminal has.
pub(crate) fn shown(text: &str, glyphs: crate::drawing::Glyphs) -> Cow<'_, str> {
    use crate::drawing::Glyphs;
    // A shortcut for nearly all text of a frame: every terminal has printable ASCII.
    if text.bytes().all(|byte| matches!(byte, b' '..=b'~')) {
        return Cow::Borrowed(text);
    }
    let ascii = glyphs == Glyphs::Ascii;
    let text = sanitized(text, ascii);
    let fits = |c: char| match glyphs {
        Glyphs::Ascii => c.is_ascii(),
        // Console fonts have Latin-1.
        Glyphs::Line => u32::from(c) < 0x100,
        // A sanitized character is shown as `?`, as elsewhere.
        Glyphs::Braille | Glyphs::Blocks(_) if c == char::REPLACEMENT_CHARACTER => false,
        Glyphs::Braille | Glyphs::Blocks(_) => {
            let mut buffer = [0; 4];
            ratatui::text::Span::raw(&*c.encode_utf8(&mut buffer)).width() == 1
        }
    };
    text.chars()
        .map(|c| match (fits(c), ascii_letter(c)) {
            (true, _) => c,
            (false, spelled) => spelled.unwrap_or('?'),
        })
        .collect::<String>()
        .into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tui::document::opening;

    /// The cost is measured about once per second, and the drawing uses the state.
    #[test]
    fn measuring_cost_keeps_forces_of_state() {
        let preset = crate::scene::presets::find("four-bar-load").unwrap();
        let mut open_scene = OpenScene::new(opening::preset(preset).unwrap());
        open_scene.balance_forces(true);
        let torque = open_scene.state().drive();
        assert!(torque.is_some());
        open_scene.weigh();
        assert_eq!(open_scene.state().drive(), torque);
    }
}
