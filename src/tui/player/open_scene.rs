//! The open scene: what is found once when it opens, and what follows from the driver's coordinate.

use crate::Ball;
use crate::document::ascii_letter;
use crate::drawing::{Reach, Role, vector_roles};
use crate::quantity::{Catalogue, DriverStand, Quantity, Sensitivity};
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
use crate::tui::player::edition::Edition;
use crate::tui::player::explained::Explained;
use crate::tui::player::timetable::Timetable;
use crate::tui::player::watched_method::WatchedMethod;
use crate::tui::{Opened, Origin};
use std::borrow::Cow;
use std::path::PathBuf;

/// States that the tables' columns are fitted to; fewer where a state has very many figures.
const SAMPLES: u16 = 72;
const FEWEST_SAMPLES: u16 = 6;
const MOST_ROWS: usize = 20_000;

/// An open scene at one coordinate of its driver.
#[derive(Debug)]
pub(crate) struct OpenScene {
    edition: Edition,
    opened: Opened,
    driver_range: DriverRange,
    reach: Reach,
    verdict: Verdict,
    sheet: Sheet,
    /// What the links of the vectors are drawn as.
    vector_roles: Vec<Option<Role>>,
    /// Where the driver is, and when, of one that moves by a law of time.
    stand: DriverStand,
    time: Option<f64>,
    timetable: Option<Timetable>,
    state: Workspace,
    enclosure: Workspace<Ball>,
    tables: Tables,
    cost: Cost,
    /// What the given lengths do, while that is looked at.
    answers: Option<LengthsQuestion>,
    /// The forces, while they are looked at and anything acts.
    force_figures: Option<ForceFigures>,
    /// The assemblies of the groups, while they are looked at.
    assembly_list: Option<AssemblyList>,
    /// The working of the state, while that is looked at.
    explained: Option<Explained>,
    /// A method at work on the state, while that is watched.
    watched: Option<WatchedMethod>,
}

/// What is asked about the given lengths, and what came of it.
#[derive(Debug)]
struct LengthsQuestion {
    sensitivity: Sensitivity,
    answers: Answers,
    /// What tolerances do, where the scene has any.
    tolerances: Option<(ToleranceStudy, ToleranceAnswers)>,
    /// All that tolerances do to one figure, where the driver was when that was asked.
    told: Option<ToleranceReport>,
}

/// So many machines are made by chance for what is told of one figure.
const MACHINES: u32 = 10_000;

/// Of more lengths than this a frame would be late.
const MOST_LENGTHS: usize = 200;

impl OpenScene {
    /// Opens a scene where it says.
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
            edition: Edition::default(),
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

    /// Another one, another form of the scene: what is found of it once is kept by this.
    pub(crate) fn edition(&self) -> &Edition {
        &self.edition
    }

    /// The same scene in another assembly of a group, at the same coordinate; in words why it cannot be.
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

    /// Looks for the assemblies of all groups here.
    pub(crate) fn look_around(&mut self) -> Option<&AssemblyList> {
        let Opened { scene, solver, .. } = &self.opened;
        self.assembly_list = AssemblyList::new(scene, solver, self.at(), &self.reach);
        self.assembly_list.as_ref()
    }

    /// What [`OpenScene::look_around`] has found.
    pub(crate) fn assembly_list(&self) -> Option<&AssemblyList> {
        self.assembly_list.as_ref()
    }

    /// The text of the scene with the start positions of this assembly.
    pub(crate) fn saved_text(&self) -> Option<String> {
        let Opened { scene, solver, .. } = &self.opened;
        scene.with_start_of(solver, self.at())
    }

    /// The scene is told by another text now, of the same mechanism.
    pub(crate) fn retell(&mut self, scene: Scene) {
        self.opened.scene = scene;
        self.timetable = Timetable::new(&self.opened.scene, self.opened.solver.motion().range);
        self.driver_range = DriverRange::new(&self.opened.scene, &self.opened.solver);
    }

    /// The scene is another text now, of the same mechanism, and has a file of its own.
    pub(crate) fn rename(&mut self, scene: Scene, file: PathBuf) {
        self.opened.scene = scene;
        self.opened.origin = Origin::File(file);
        self.driver_range = DriverRange::new(&self.opened.scene, &self.opened.solver);
    }

    /// Moves the driver to a coordinate, wherever that is: where it moves by a law of time, to where it is there
    /// next.
    pub(crate) fn go(&mut self, at: f64) {
        let Some(timetable) = &self.timetable else {
            return self.stand_at(DriverStand::at(at), None);
        };
        let time = timetable.nearest(at, self.time.unwrap_or(0.0));
        self.stand_at(timetable.stand_at(at, time), time);
    }

    /// Moves the driver to where its motion is at a time, if it has one.
    pub(crate) fn go_to_time(&mut self, time: f64) {
        if let Some(timetable) = &self.timetable {
            self.stand_at(timetable.stand(time), Some(time));
        }
    }

    fn stand_at(&mut self, stand: DriverStand, time: Option<f64>) {
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

    /// Need the forces, here and from now on, or ceases to.
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

    /// The forces, if they are looked at and anything acts.
    pub(crate) fn force_figures(&self) -> Option<&ForceFigures> {
        self.force_figures.as_ref()
    }

    /// Shows the working, here and from now on, or ceases to.
    pub(crate) fn explain(&mut self, wanted: bool) {
        if wanted && self.explained.is_some() {
            return;
        }
        self.explained = wanted
            .then(|| Explained::new(&self.opened, &self.stand))
            .flatten();
    }

    /// The working of the state, if that was asked and the scene is not too large.
    pub(crate) fn explained(&self) -> Option<&Explained> {
        self.explained.as_ref()
    }

    /// Watches a method from a guess, here and from now on, or none.
    pub(crate) fn watch(&mut self, method: Option<PositionMethod>, guess: &str) {
        if self.watched.as_ref().map(WatchedMethod::method) != method {
            let new = |method| WatchedMethod::new((method, guess), &self.opened, self.at());
            self.watched = method.and_then(new);
        }
    }

    /// The method that is watched begins at another guess.
    ///
    /// # Errors
    /// In words, where that is no guess for this scene; then nothing has changed.
    pub(crate) fn guess(&mut self, guess: &str) -> Result<(), String> {
        let watched = self.watched.as_mut();
        watched.map_or(Ok(()), |watched| watched.begin_at(guess, &self.opened))
    }

    /// The method at work, if one is watched and the scene is not too large.
    pub(crate) fn watched(&self) -> Option<&WatchedMethod> {
        self.watched.as_ref()
    }

    /// Measures what the state costs, without its bounds. What is shown of the state stays: it may have forces.
    pub(crate) fn weigh(&mut self) {
        let OpenScene { opened, stand, .. } = self;
        let mut state = opened.solver.state();
        self.cost.measure(|| {
            let _ = opened
                .solver
                .solve(stand.at, Order::Acceleration, &mut state);
        });
    }

    /// What the last state cost, if that was measured.
    pub(crate) fn cost(&self) -> Option<String> {
        self.cost.text()
    }

    /// The largest bound of a coordinate of a point; `None` where one of them has none.
    pub(crate) fn largest_bound(&self) -> Option<f64> {
        let places = self.tables.points.iter().filter_map(|p| p.motion[0]);
        let mut bounds = places.flat_map(|place| [place.bounds[0], place.bounds[1]]);
        bounds.try_fold(0.0, |most: f64, bound| Some(most.max(bound?)))
    }

    /// Need what the given lengths do, here and from now on, or ceases to.
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

    /// Whether what the lengths do takes too long to be found here.
    pub(crate) fn has_too_many_lengths(&self) -> bool {
        self.opened.scene.mechanism.lengths().len() > MOST_LENGTHS
    }

    /// What the given lengths do, if that was asked and there are not too many.
    pub(crate) fn answers(&self) -> Option<&Answers> {
        self.answers.as_ref().map(|asked| &asked.answers)
    }

    /// What tolerances do, if that was asked and there are any.
    pub(crate) fn tolerance_answers(&self) -> Option<&ToleranceAnswers> {
        let (_, found) = self.answers.as_ref()?.tolerances.as_ref()?;
        Some(found)
    }

    /// Finds all that tolerances do to a figure here, while it is asked what lengths do.
    ///
    /// # Errors
    /// In words: why nothing can be told of it.
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

    /// All that tolerances do to the figure that was asked about.
    pub(crate) fn told_tolerance(&self) -> Option<&ToleranceReport> {
        self.answers.as_ref()?.told.as_ref()
    }

    /// Drops that; false where there is none.
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

    /// Says again what was said once, in another language; the working when it is looked at.
    pub(crate) fn say_again(&mut self) {
        self.verdict = Verdict::new(&self.opened.scene, &self.opened.solver);
        self.explained = None;
    }

    /// What there is to say of the linkage as a whole.
    pub(crate) fn verdict(&self) -> &Verdict {
        &self.verdict
    }

    pub(crate) fn reach(&self) -> &Reach {
        &self.reach
    }

    pub(crate) fn sheet(&self) -> &Sheet {
        &self.sheet
    }

    /// What the link is drawn as that a row of the vectors belongs to.
    pub(crate) fn vector_role(&self, row: usize) -> Option<Role> {
        self.vector_roles.get(row).copied().flatten()
    }

    /// The driver's coordinate, in degrees or in the scene's length unit.
    pub(crate) fn at(&self) -> f64 {
        self.stand.at
    }

    /// The same, and how it passes there.
    pub(crate) fn stand(&self) -> &DriverStand {
        &self.stand
    }

    /// When the driver is there, in s from the opening; `None` off its motion, and of one that runs by its speed.
    pub(crate) fn time(&self) -> Option<f64> {
        self.time
    }

    /// The motion over time, of a scene that has one.
    pub(crate) fn timetable(&self) -> Option<&Timetable> {
        self.timetable.as_ref()
    }

    /// The state here with all rates as they are at the scene's own speed, whatever its motion.
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

    /// The tables at another place, with their bounds.
    pub(crate) fn tables_at(
        &self,
        stand: &DriverStand,
        state: &mut Workspace,
        enclosure: &mut Workspace<Ball>,
    ) -> Tables {
        solved(&self.opened, stand, Order::Acceleration, state, enclosure)
    }

    /// Places spread over the whole motion, the opening first.
    pub(crate) fn places(&self) -> Vec<DriverStand> {
        places(
            &self.opened.scene,
            &self.driver_range,
            self.timetable.as_ref(),
        )
    }

    /// The unit of the driver's coordinate.
    pub(crate) fn unit(&self) -> &'static str {
        if self.driver_range.turns() {
            "deg"
        } else {
            self.opened.scene.unit.symbol()
        }
    }

    /// The preset so many places further on in the list; from a file, the first or the last.
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

/// The tables at a place, with their bounds, of a state that is solved as far as that.
pub(crate) fn solved(
    opened: &Opened,
    stand: &DriverStand,
    order: Order,
    state: &mut Workspace,
    enclosure: &mut Workspace<Ball>,
) -> Tables {
    let _ = stand.solve(&opened.solver, order, state);
    stand.drive(&opened.solver, enclosure);
    opened.solver.enclose(state, order, enclosure);
    Tables::bounded(&opened.scene, state, enclosure)
}

/// The tables at these places.
fn samples(opened: &Opened, places: &[DriverStand], state: &mut Workspace) -> Vec<Tables> {
    places
        .iter()
        .map(|stand| {
            let _ = stand.solve(&opened.solver, Order::Acceleration, state);
            Tables::new(&opened.scene, state)
        })
        .collect()
}

/// Places spread over the whole motion, the opening first.
fn places(
    scene: &Scene,
    driver_range: &DriverRange,
    timetable: Option<&Timetable>,
) -> Vec<DriverStand> {
    let (low, high) = driver_range.shuttle().unwrap_or((
        driver_range.opening(),
        driver_range.opening() + driver_range.span(),
    ));
    let mechanism = &scene.mechanism;
    let rows = mechanism.points().len() + mechanism.links().len();
    let count = u16::try_from(MOST_ROWS / rows.max(1)).unwrap_or(SAMPLES);
    let count = count.clamp(FEWEST_SAMPLES, SAMPLES);
    let share = |k: u16| f64::from(k) / f64::from(count);
    let spread = (0..=count).map(|k| low + (high - low) * share(k));
    let spread = std::iter::once(driver_range.opening()).chain(spread);
    match timetable {
        None => spread.map(DriverStand::at).collect(),
        // Where it does not go by its motion it passes as the scene says without one.
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

/// Text of a scene that may be shown: one column to a character, and only such characters as the
/// terminal has.
pub(crate) fn shown(text: &str, glyphs: crate::drawing::Glyphs) -> Cow<'_, str> {
    use crate::drawing::Glyphs;
    // Nearly all of a frame, which every terminal has.
    if text.bytes().all(|byte| matches!(byte, b' '..=b'~')) {
        return Cow::Borrowed(text);
    }
    let ascii = glyphs == Glyphs::Ascii;
    let text = sanitized(text, ascii);
    let fits = |c: char| match glyphs {
        Glyphs::Ascii => c.is_ascii(),
        // Console fonts have Latin-1.
        Glyphs::Line => u32::from(c) < 0x100,
        // What was harmful is `?` here as elsewhere.
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

    /// It is measured about once a second, and what is drawn is drawn from the state.
    #[test]
    fn a_measurement_of_the_cost_leaves_the_state_its_forces() {
        let preset = crate::scene::presets::find("four-bar-load").unwrap();
        let mut open_scene = OpenScene::new(opening::preset(preset).unwrap());
        open_scene.balance_forces(true);
        let torque = open_scene.state().drive();
        assert!(torque.is_some());
        open_scene.weigh();
        assert_eq!(open_scene.state().drive(), torque);
    }
}
