//! The open scene: results computed once when it opens, and results at the driver's coordinate.

use crate::Ball;
use crate::document::ascii_letter;
use crate::drawing::{Extents, Role, vector_roles};
use crate::quantity::DriverState;
use crate::report::{Tables, Verdict};
use crate::scene::presets::{self, Preset};
use crate::scene::{Scene, sanitized};
use crate::solver::{AssemblyChoice, Condition, GroupId, Order, Solver, State, Workspace};
use crate::tui::figures::sheet::Sheet;
use crate::tui::player::cost::Cost;
use crate::tui::player::driver_range::DriverRange;
use crate::tui::player::led_motion::LedMotion;
use crate::tui::player::scene_version::SceneRevision;
use crate::tui::player::timetable::Timetable;
use crate::tui::{OpenedScene, Origin};
use std::borrow::Cow;
use std::path::PathBuf;

/// Numbers of states for sizing the tables' columns; fewer if a state has very many rows.
const SAMPLES: u16 = 72;
const MIN_SAMPLES: u16 = 6;
const MAX_ROWS: usize = 20_000;

/// An open scene at one driver coordinate, or at a time of its leading point.
#[derive(Debug)]
pub(crate) struct OpenScene {
    edition: SceneRevision,
    opened: OpenedScene,
    driver_range: DriverRange,
    reach: Extents,
    verdict: Verdict,
    sheet: Sheet,
    /// The drawing role of the link of each row of the vectors.
    vector_roles: Vec<Option<Role>>,
    /// The driver state; and its time, if the driver has a motion over time.
    driver_state: DriverState,
    time: Option<f64>,
    timetable: Option<Timetable>,
    /// The motion of the leading point, and whether it leads at present. Without it, the driver
    /// state is the present one.
    led_motion: Option<LedMotion>,
    is_led: bool,
    state: Workspace,
    enclosure: Workspace<Ball>,
    tables: Tables,
    cost: Cost,
    /// The order to which each state is solved: with forces only while they are shown.
    order: Order,
}

impl OpenScene {
    /// Opens a scene at its initial position.
    pub(crate) fn new(opened: OpenedScene) -> Self {
        let driver_range = DriverRange::new(&opened.scene, &opened.solver);
        let mut extents = Extents::of(&opened.scene, &opened.solver);
        let led_motion = LedMotion::new(&opened.scene, &opened.solver);
        if let Some(led) = &led_motion {
            extents = extents.with(&opened.scene, led.states());
            extents = extents.with_points(led.planned().iter().copied());
        }
        let mut state = opened.solver.state();
        let timetable = Timetable::new(&opened.scene, opened.solver.motion().range);
        let places = places(&opened.scene, &driver_range, timetable.as_ref());
        let mut samples = samples(&opened, &places, &mut state);
        if let Some(led) = &led_motion {
            let step = (led.states().count() / usize::from(SAMPLES)).max(1);
            let states = led.states().step_by(step);
            samples.extend(states.map(|state| Tables::new(&opened.scene, state)));
        }
        let driver_state = places[0];
        let mut enclosure = opened.solver.enclosure();
        let mut open_scene = OpenScene {
            edition: SceneRevision::default(),
            verdict: Verdict::new(&opened.scene, &opened.solver),
            sheet: Sheet::new(&samples),
            vector_roles: vector_roles(&opened.scene),
            tables: solved(
                &opened,
                &driver_state,
                Order::Acceleration,
                &mut state,
                &mut enclosure,
            ),
            cost: Cost::default(),
            order: Order::Acceleration,
            enclosure,
            opened,
            driver_range,
            reach: extents,
            driver_state,
            time: timetable.is_some().then_some(0.0),
            timetable,
            is_led: false,
            led_motion,
            state,
        };
        open_scene.lead_to_time(f64::NEG_INFINITY);
        open_scene
    }

    /// Returns the revision, the key for cached results on this scene.
    pub(crate) fn edition(&self) -> &SceneRevision {
        &self.edition
    }

    /// Returns the scene with another assembly of a group, at the same position. The error is a
    /// message.
    pub(crate) fn switched(
        &self,
        group: GroupId,
        choice: AssemblyChoice,
    ) -> Result<OpenScene, String> {
        let OpenedScene {
            scene,
            solver,
            origin,
        } = &self.opened;
        let switched = solver.switched(self.at(), group, choice);
        let solver = switched.map_err(|fault| scene.explain(&fault).first_words().to_owned())?;
        let (scene, origin) = (scene.clone(), origin.clone());
        let mut open_scene = OpenScene::new(OpenedScene {
            scene,
            solver,
            origin,
        });
        open_scene.set_driver(self.driver_state, self.time);
        Ok(open_scene)
    }

    /// Returns the scene's text with the start positions of this assembly.
    pub(crate) fn saved_text(&self) -> Option<String> {
        let OpenedScene { scene, solver, .. } = &self.opened;
        scene.with_start_of(solver, self.at())
    }

    /// Replaces the scene by another text of the same mechanism.
    pub(crate) fn replace_text(&mut self, scene: Scene) {
        self.opened.scene = scene;
        self.timetable = Timetable::new(&self.opened.scene, self.opened.solver.motion().range);
        let time = self.led().map(LedMotion::time);
        self.led_motion = LedMotion::new(&self.opened.scene, &self.opened.solver);
        if let Some(time) = time
            && !self.lead_to_time(time)
        {
            self.take_by_hand();
        }
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
            return self.set_driver(DriverState::at(at), None);
        };
        let time = timetable.nearest(at, self.time.unwrap_or(0.0));
        self.set_driver(timetable.driver_state_at(at, time), time);
    }

    /// Moves the driver to its position at a time, if it has a motion over time.
    pub(crate) fn go_to_time(&mut self, time: f64) {
        if let Some(timetable) = &self.timetable {
            self.set_driver(timetable.driver_state(time), Some(time));
        }
    }

    /// Moves the leading point to its position at a time, or the nearest one that the inputs can
    /// follow. Returns `false` if there is no such motion.
    pub(crate) fn lead_to_time(&mut self, time: f64) -> bool {
        let Some(led) = &mut self.led_motion else {
            return false;
        };
        let time = led.within(time);
        // Where the inputs cannot follow, the last position remains.
        led.go(time, self.order);
        self.tables = Tables::new(&self.opened.scene, led.state());
        self.is_led = true;
        true
    }

    /// Returns to the driver's position: the leading point stops leading.
    pub(crate) fn take_by_hand(&mut self) {
        self.set_driver(self.driver_state, self.time);
    }

    /// Solves the present state again.
    fn solve_again(&mut self) {
        match self.led().map(LedMotion::time) {
            Some(time) => {
                self.lead_to_time(time);
            }
            None => self.set_driver(self.driver_state, self.time),
        }
    }

    /// Returns the motion of the leading point, if the inputs can follow it at all.
    pub(crate) fn led_motion(&self) -> Option<&LedMotion> {
        self.led_motion.as_ref()
    }

    /// Returns the motion of the leading point while it leads: the state is then that at its time,
    /// and the driver state that of the last position without it.
    pub(crate) fn led(&self) -> Option<&LedMotion> {
        self.led_motion.as_ref().filter(|_| self.is_led)
    }

    fn set_driver(&mut self, driver_state: DriverState, time: Option<f64>) {
        self.is_led = false;
        (self.driver_state, self.time) = (driver_state, time);
        let (state, enclosure) = (&mut self.state, &mut self.enclosure);
        self.tables = solved(&self.opened, &driver_state, self.order, state, enclosure);
    }

    /// Solves this and all further states with or without forces.
    pub(crate) fn solve_forces(&mut self, wanted: bool) {
        let order = match wanted && self.opened.solver.has_forces() {
            true => Order::Force,
            false => Order::Acceleration,
        };
        if order != self.order {
            self.order = order;
            self.solve_again();
        }
    }

    /// Measures the cost of solving the state without bounds. Uses a state of its own, because the
    /// current one may hold forces.
    pub(crate) fn measure_cost(&mut self) {
        let OpenScene {
            opened,
            driver_state,
            ..
        } = self;
        let mut state = opened.solver.state();
        self.cost.measure(|| {
            let _ = opened
                .solver
                .solve(driver_state.at, Order::Acceleration, &mut state);
        });
    }

    /// Returns the last measured cost; `None` while a point leads, whose states cost more.
    pub(crate) fn cost(&self) -> Option<String> {
        self.led().is_none().then(|| self.cost.text()).flatten()
    }

    /// Returns the largest error bound of a point's coordinates; `None` if any bound is missing.
    pub(crate) fn largest_bound(&self) -> Option<f64> {
        let places = self.tables.points.iter().filter_map(|p| p.motion[0]);
        let mut bounds = places.flat_map(|place| [place.bounds[0], place.bounds[1]]);
        bounds.try_fold(0.0, |maximum: f64, bound| Some(maximum.max(bound?)))
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

    /// Rebuilds cached text in the current language.
    pub(crate) fn rebuild_texts(&mut self) {
        self.verdict = Verdict::new(&self.opened.scene, &self.opened.solver);
    }

    /// Returns the verdict on the linkage as a whole.
    pub(crate) fn verdict(&self) -> &Verdict {
        &self.verdict
    }

    pub(crate) fn extents(&self) -> &Extents {
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
        self.driver_state.at
    }

    /// Returns the driver's coordinate with its rates.
    pub(crate) fn driver_state(&self) -> &DriverState {
        &self.driver_state
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
        let _ = self.opened.solver.solve(self.at(), self.order, &mut state);
        state.into_state()
    }

    pub(crate) fn state(&self) -> &State {
        self.led().map_or(&self.state, LedMotion::state)
    }

    /// Returns the error bounds of the state; `None` while a point leads.
    pub(crate) fn enclosure(&self) -> Option<&State<Ball>> {
        (!self.is_led).then_some(&*self.enclosure)
    }

    pub(crate) fn condition(&self) -> Condition {
        self.state().condition()
    }

    pub(crate) fn tables(&self) -> &Tables {
        &self.tables
    }

    /// Computes the tables with bounds at another driver state.
    pub(crate) fn tables_at(
        &self,
        driver_state: &DriverState,
        state: &mut Workspace,
        enclosure: &mut Workspace<Ball>,
    ) -> Tables {
        solved(
            &self.opened,
            driver_state,
            Order::Acceleration,
            state,
            enclosure,
        )
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
    opened: &OpenedScene,
    driver_state: &DriverState,
    order: Order,
    state: &mut Workspace,
    enclosure: &mut Workspace<Ball>,
) -> Tables {
    let _ = driver_state.solve(&opened.solver, order, state);
    driver_state.drive(&opened.solver, enclosure);
    opened.solver.enclose(state, order, enclosure);
    Tables::bounded(&opened.scene, state, enclosure)
}

/// Computes the tables at driver states.
fn samples(opened: &OpenedScene, places: &[DriverState], state: &mut Workspace) -> Vec<Tables> {
    places
        .iter()
        .map(|driver_state| {
            let _ = driver_state.solve(&opened.solver, Order::Acceleration, state);
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
            let moved = times.map(|time| timetable.driver_state(time));
            let off = spread.filter(|&at| timetable.nearest(at, 0.0).is_none());
            moved
                .chain(off.map(|at| timetable.driver_state_at(at, None)))
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
        open_scene.solve_forces(true);
        let torque = open_scene.state().drive();
        assert!(torque.is_some());
        open_scene.measure_cost();
        assert_eq!(open_scene.state().drive(), torque);
    }
}
