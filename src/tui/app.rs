//! The state of the workbench and how actions change it. Views read it and change nothing.

mod choosing;
mod comparing;
mod editing;
mod filing;
mod helping;
mod lens;
mod picking;
mod plotting;
mod searching;
mod taking;
mod touring;
mod writing;

use super::action::Action;
use super::chosen::Chosen;
use super::config::Config;
use super::course::{OutOfRange, rounded};
use super::cursor::Cursor;
use super::disk::Disk;
use super::editor::Editor;
use super::figures::coordinate;
use super::help::Help;
use super::key::Key;
use super::keymap::Keymap;
use super::lens::Lens;
use super::line::Line;
use super::opening;
use super::palette::{Palette, Theme};
use super::picker::Picker;
use super::playback::Playback;
use super::plot_list::PlotList;
use super::plots::Plots;
use super::preview::Previews;
use super::recovery::Recovery;
use super::search::Search;
use super::stage::Stage;
use super::steps::Steps;
use super::survey::{Clock, Phase, Survey};
use super::tour;
use super::views;
use super::writing::{Prompt, Question};
use super::{Opened, cost};
use crate::capability::{Capability, Colours};
use crate::drawing::Glyphs;
use crate::solver::Condition;
use comparing::Comparison;
pub(crate) use editing::{Entry, Wanted};
use filing::Pending;
pub(crate) use filing::Unsaved;
use ratatui::layout::Size;
use std::path::PathBuf;
use std::sync::{Arc, LazyLock};
use std::time::{Duration, Instant};

/// What keys go to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Mode {
    /// The view.
    Normal,
    /// The help overlay.
    Help(Help),
    /// This screen of the tour.
    Tour(usize),
    /// The line in which a coordinate is typed.
    GoTo(Line),
    /// The list of assemblies, with the cursor on this one.
    Assemblies(usize),
    /// The list in which is chosen what is plotted.
    PlotList(PlotList),
    /// The line in which the name of a file is typed.
    FileName(Prompt),
    /// The question whether to write to a file.
    Confirm(Question),
    /// The list of presets and files.
    Pick(Box<Picker>),
    /// The line in which a name is typed that is sought in the tables.
    Search(Search),
    /// The question how much of the tables is copied.
    Copy,
    /// The line in the scene view in which a value or a name is typed.
    Value(Entry),
    /// A question about unsaved edits.
    Unsaved(Unsaved),
}

impl Mode {
    /// The line that is typed in, if there is one.
    fn line(&mut self) -> Option<&mut Line> {
        match self {
            Mode::GoTo(line) => Some(line),
            Mode::FileName(prompt) => Some(&mut prompt.name),
            Mode::Help(help) => help.typed(),
            Mode::PlotList(list) => list.typed(),
            Mode::Search(search) => Some(&mut search.name),
            Mode::Value(entry) => Some(&mut entry.line),
            Mode::Normal
            | Mode::Tour(_)
            | Mode::Assemblies(_)
            | Mode::Confirm(_)
            | Mode::Unsaved(_)
            | Mode::Pick(_)
            | Mode::Copy => None,
        }
    }
}

/// What is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    /// The drawing, with live tables.
    Motion,
    /// All tables.
    Tables,
    /// Quantities over the motion.
    Plots,
    /// Speed against error.
    Accuracy,
    /// Forces.
    Forces,
    /// What the scene gives.
    Scene,
    /// What the given lengths do to the figures.
    Lengths,
}

impl View {
    /// In the order of their keys.
    pub(crate) const ALL: [View; 7] = [
        View::Motion,
        View::Tables,
        View::Plots,
        View::Accuracy,
        View::Forces,
        View::Scene,
        View::Lengths,
    ];
}

/// What the terminal has to do after an action.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Effect {
    /// Show what has changed.
    Show,
    /// Take these bytes, which are no part of a frame; then show what has changed.
    Send(Vec<u8>),
    /// Keep the screen as it is, for [`App::ask_for_picture`].
    Picture,
    /// Draw everything again.
    Redraw,
    /// Stop the program until the shell continues it.
    Suspend,
    /// Leave.
    Quit,
}

/// Time between two frames while playing.
const FRAME: Duration = Duration::from_millis(33);
/// Decimals to which a step is exact.
const STEP_DECIMALS: usize = 9;

/// The workbench without its terminal.
#[derive(Debug)]
pub(crate) struct App {
    stage: Stage,
    steps: Steps,
    playback: Playback,
    view: View,
    mode: Mode,
    /// The study of the open scene.
    survey: Survey,
    /// Lines that each view is scrolled by.
    scroll: [usize; View::ALL.len()],
    /// Where the cursor of the tables is.
    cursor: Cursor,
    /// The name that was sought last.
    sought: String,
    /// What the motion view shows of the tables.
    chosen: Chosen,
    /// What is plotted.
    plots: Plots,
    keymap: Keymap,
    /// What the motion view shows beside the linkage, and how large.
    lens: Lens,
    /// What was seen of the scenes in the list of presets and files.
    previews: Previews,
    /// What the open scene is held against.
    comparison: Comparison,
    /// The text of the scene as it was opened.
    original: Arc<str>,
    /// What is edited in the open scene.
    editor: Editor,
    /// Its file, if it has one.
    disk: Option<Disk>,
    /// Where unsaved edits are kept, if they are: the folder, and the place of this scene.
    folder: Option<PathBuf>,
    recovery: Option<Recovery>,
    /// What is to be done once nothing is unsaved.
    pending: Option<Pending>,
    capability: Capability,
    theme: Theme,
    size: Size,
    /// The height of a cell for its width.
    aspect: f64,
    /// Said in the last line until the next key.
    message: Option<String>,
    /// When the last state was weighed, and where that was; `None` before the first one.
    weighed: Option<(Duration, usize, f64)>,
    /// The time that was told last.
    now: Duration,
    /// When the last frame was due.
    frame: Duration,
    /// How many scenes have been opened.
    opened: usize,
}

impl App {
    /// A workbench with an open scene, paused where it says, or at `at`.
    pub(crate) fn new(opened: Opened, at: Option<f64>, capability: Capability, size: Size) -> Self {
        let original = opened.scene.text().into();
        let stage = Stage::new(opened);
        let mut app = App {
            steps: steps_of(&stage),
            editor: Editor::new(stage.scene()),
            disk: None,
            folder: None,
            recovery: None,
            pending: None,
            stage,
            playback: Playback::new(),
            view: View::Motion,
            mode: Mode::Normal,
            survey: Survey::new(wall_clock),
            scroll: [0; View::ALL.len()],
            cursor: Cursor::default(),
            sought: String::new(),
            chosen: Chosen::default(),
            plots: Plots::default(),
            keymap: Keymap::default(),
            lens: Lens::default(),
            previews: Previews::default(),
            comparison: Comparison::default(),
            original,
            capability,
            theme: Theme::default(),
            size,
            aspect: USUAL_ASPECT,
            message: None,
            weighed: None,
            now: Duration::ZERO,
            frame: Duration::ZERO,
            opened: 1,
        };
        if let Some(at) = at {
            app.jump(at, Duration::ZERO);
        }
        app.meet();
        app
    }

    /// Takes what a person has configured.
    pub(crate) fn configure(&mut self, config: &Config) {
        self.keymap = config.keymap.clone();
    }

    pub(crate) fn stage(&self) -> &Stage {
        &self.stage
    }

    pub(crate) fn steps(&self) -> &Steps {
        &self.steps
    }

    pub(crate) fn playback(&self) -> &Playback {
        &self.playback
    }

    pub(crate) fn survey(&self) -> &Survey {
        &self.survey
    }

    /// Takes the time of studies from another clock.
    pub(crate) fn set_clock(&mut self, clock: Clock) {
        self.survey = Survey::new(clock);
    }

    /// Whether there is work to do between two frames, whoever waits: only in its view.
    pub(crate) fn is_working(&self) -> bool {
        self.view == View::Accuracy && self.survey.phase() == Phase::Running
    }

    /// What is marked in the tables to be shown in the motion view.
    pub(crate) fn chosen(&self) -> &Chosen {
        &self.chosen
    }

    /// Which key asks for what.
    pub(crate) fn keymap(&self) -> &Keymap {
        &self.keymap
    }

    /// What the motion view shows beside the linkage, and how large.
    pub(crate) fn lens(&self) -> &Lens {
        &self.lens
    }

    /// The cursor of the tables.
    pub(crate) fn cursor(&self) -> Cursor {
        self.cursor
    }

    /// What is edited in the open scene.
    pub(crate) fn editor(&self) -> &Editor {
        &self.editor
    }

    /// Whether the scene that is shown is not the one in its file.
    pub(crate) fn is_changed(&self) -> bool {
        self.editor.is_changed(self.stage.scene())
    }

    pub(crate) fn view(&self) -> View {
        self.view
    }

    pub(crate) fn mode(&self) -> &Mode {
        &self.mode
    }

    /// How many scenes have been opened: another number, another scene.
    pub(crate) fn opened(&self) -> usize {
        self.opened
    }

    /// Lines that the view is scrolled by.
    pub(crate) fn scroll(&self) -> usize {
        self.scroll[self.view as usize]
    }

    pub(crate) fn glyphs(&self) -> Glyphs {
        self.capability.glyphs
    }

    pub(crate) fn size(&self) -> Size {
        self.size
    }

    pub(crate) fn aspect(&self) -> f64 {
        self.aspect
    }

    pub(crate) fn colours(&self) -> Colours {
        self.capability.colours
    }

    /// How colours are sent.
    pub(crate) fn palette(&self) -> Palette {
        Palette {
            colours: self.capability.colours,
            theme: self.theme,
        }
    }

    /// Names of colours stand for those of this theme.
    pub(crate) fn set_theme(&mut self, theme: Theme) {
        self.theme = theme;
    }

    pub(crate) fn message(&self) -> Option<&str> {
        self.message.as_deref()
    }

    /// A key was pressed.
    pub(crate) fn key(&mut self, key: Key, now: Duration) -> Effect {
        let effect = self.type_key(key, now).unwrap_or_else(|| {
            let action = self.keymap.action(key, self.view);
            action.map_or(Effect::Show, |action| self.update(action, now))
        });
        let effect = self.settle(effect);
        self.look_at_file(now, false);
        self.focus();
        // Another view, scene or list may have fewer lines than what was scrolled before.
        self.scroll_by(0);
        effect
    }

    /// Text was pasted: it is typed where there is a line to type in, and nothing elsewhere.
    pub(crate) fn paste(&mut self, text: &str) {
        if let Mode::Pick(picker) = &mut self.mode {
            text.chars().for_each(|c| picker.push(c));
        } else if let Some(line) = self.mode.line() {
            text.chars().for_each(|c| line.push(c));
            self.find();
        }
        if let Mode::PlotList(list) = &mut self.mode {
            list.narrow();
        }
    }

    /// The screen has another size.
    pub(crate) fn resize(&mut self, size: Size, aspect: Option<f64>) {
        self.size = size;
        self.aspect = aspect.unwrap_or(USUAL_ASPECT);
        self.place_cursor(|cursor, _| cursor);
        self.scroll_by(0);
    }

    /// Time has passed: if a frame is due, what is played moves to where it is now. A study goes on.
    pub(crate) fn tick(&mut self, now: Duration) {
        if self.is_working() {
            self.survey.work();
        }
        self.now = now;
        if self.next_frame().is_none_or(|next| now < next) {
            return;
        }
        if let Some(at) = self.playback.position(now, self.stage.course()) {
            self.frame = now;
            let at = self.stage.course().on_grid(at);
            self.stage.go(at);
        }
        self.look_at_file(now, false);
    }

    /// Measures what a state costs, where that is worth it: of another scene at once, of another state
    /// after a while.
    pub(crate) fn weigh(&mut self) {
        let (opened, at) = (self.opened, self.stage.at());
        let is_due = self.weighed.is_none_or(|(then, scene, place)| {
            scene != opened || (place != at && self.now >= then + cost::PAUSE)
        });
        if is_due {
            self.stage.weigh();
            self.weighed = Some((self.now, opened, at));
        }
    }

    /// When to call [`App::tick`]; never while paused.
    pub(crate) fn next_frame(&self) -> Option<Duration> {
        // While another scene is looked for, this one waits.
        let plays = self.playback.is_playing() && !matches!(self.mode, Mode::Pick(_));
        plays.then(|| self.frame + FRAME)
    }

    /// The program was stopped meanwhile: playing goes on from where it was.
    pub(crate) fn wake(&mut self, now: Duration) {
        self.playback.rebase(now, self.stage.at());
    }

    /// Does what was asked.
    pub(crate) fn update(&mut self, action: Action, now: Duration) -> Effect {
        self.message = None;
        match action {
            Action::Quit => return self.quit(),
            Action::Leave => return Effect::Quit,
            Action::Suspend => return Effect::Suspend,
            Action::Redraw => return Effect::Redraw,
            Action::Back => self.back(),
            Action::Help => self.toggle_help(),
            Action::LineUp => self.scroll_by(-1),
            Action::LineDown => self.scroll_by(1),
            Action::PageUp => self.scroll_by(-self.page()),
            Action::PageDown => self.scroll_by(self.page()),
            Action::Save if matches!(self.mode, Mode::Normal | Mode::Assemblies(_)) => {
                self.save_own()
            }
            Action::Search if let Mode::Help(help) = &mut self.mode => help.search(),
            Action::Assemblies if matches!(self.mode, Mode::Assemblies(_)) => {
                self.mode = Mode::Normal;
            }
            _ if !self.takes(action) => {}
            Action::Save => {}
            Action::Assemblies => self.list_assemblies(),
            Action::Play | Action::Slower | Action::Faster | Action::Reverse => {
                self.play(action, now);
            }
            Action::StepBack => self.step(-self.steps.size(), now),
            Action::StepForward => self.step(self.steps.size(), now),
            Action::SmallerStep => self.steps.smaller(),
            Action::LargerStep => self.steps.larger(),
            Action::GoTo => self.mode = Mode::GoTo(Line::for_number()),
            Action::Opening => {
                let course = self.stage.course();
                self.arrive(course.clamp(course.opening()), now);
            }
            Action::NextPreset => self.open(1),
            Action::PreviousPreset => self.open(-1),
            Action::Compare => self.compare(),
            Action::Open => self.pick(),
            Action::Search => self.search(),
            Action::Copy | Action::Csv | Action::Picture | Action::Svg => {
                return self.take_out(action);
            }
            Action::SaveAs => self.ask_where(),
            Action::Reload => self.reload(now),
            Action::Undo | Action::Redo => {
                self.edit_history(action, now);
            }
            Action::Motion(action) => self.move_lens(action),
            Action::Tables(action) => self.browse(action),
            Action::Plots(action) => self.plot(action),
            Action::Scene(action) => self.edit(action, now),
            Action::Tour => self.tour(),
            Action::Glyphs => self.next_glyphs(),
            Action::Colours => self.next_colours(),
            Action::NextView => self.next_view(),
            Action::MotionView => self.look(View::Motion),
            Action::TablesView => self.look(View::Tables),
            Action::PlotsView => self.look(View::Plots),
            Action::ForcesView => self.look(View::Forces),
            Action::SceneView => self.look(View::Scene),
            Action::LengthsView => self.look(View::Lengths),
            Action::AccuracyView => {
                self.look(View::Accuracy);
                self.study();
            }
        }
        Effect::Show
    }

    /// Whether the mode lets an action through that is none of its own.
    fn takes(&self, action: Action) -> bool {
        match self.mode {
            Mode::Tour(_) => tour::allows(action),
            _ => self.mode == Mode::Normal,
        }
    }

    /// Keys of the line in which a coordinate is typed; `None` for those that mean the same everywhere.
    fn type_key(&mut self, key: Key, now: Duration) -> Option<Effect> {
        match self.mode {
            Mode::Help(_) => return self.search_help(key),
            Mode::Tour(_) => return self.turn_page(key),
            _ => {}
        }
        if let Mode::Pick(_) = self.mode {
            return self.pick_key(key, now);
        }
        if matches!(self.mode, Mode::PlotList(_)) {
            return self.list_key(key);
        }
        if let (Mode::Assemblies(cursor), Key::Enter) = (&self.mode, key) {
            self.take_assembly(*cursor, now);
            return Some(Effect::Show);
        }
        if let Mode::Confirm(question) = &self.mode {
            if key == Key::Enter {
                let question = question.clone();
                self.write(question);
                return Some(Effect::Show);
            }
            return None;
        }
        if self.search_key(key) {
            return Some(Effect::Show);
        }
        if self.mode == Mode::Copy {
            return self.copy_key(key);
        }
        if matches!(self.mode, Mode::Value(_)) {
            return self.type_entry(key, now);
        }
        if matches!(self.mode, Mode::Unsaved(_)) {
            return self.answer(key, now);
        }
        let line = self.mode.line()?;
        match key {
            Key::Ctrl('u') => line.clear(),
            Key::Ctrl(_) => return None,
            Key::Escape => self.mode = Mode::Normal,
            Key::Backspace => line.erase(),
            Key::Char(c) => line.push(c),
            Key::Enter => {
                let line = line.clone();
                match &self.mode {
                    Mode::FileName(prompt) => self.accept_file(prompt.clone()),
                    _ => self.accept(&line, now),
                }
                return Some(Effect::Show);
            }
            _ => {}
        }
        self.message = None;
        Some(Effect::Show)
    }

    fn accept(&mut self, line: &Line, now: Duration) {
        match line.number(self.stage.unit()) {
            Some(at) => {
                if self.jump(at, now) {
                    self.mode = Mode::Normal;
                }
            }
            None if line.text().trim().is_empty() => self.mode = Mode::Normal,
            None => {
                let unit = self.stage.unit();
                self.message = Some(format!("not a number of {unit}: {}", line.text()));
            }
        }
    }

    /// Goes to a coordinate, if it can be reached; says so if not.
    fn jump(&mut self, at: f64, now: Duration) -> bool {
        let course = self.stage.course();
        match course.reach(at) {
            Ok(at) => {
                self.arrive(at, now);
                true
            }
            Err(OutOfRange { low, high }) => {
                // Rounded inwards: what is said can be reached.
                let scale = 10.0_f64.powi(i32::try_from(course.decimals()).unwrap_or(0));
                let low = coordinate((low * scale).ceil() / scale, course.decimals());
                let high = coordinate((high * scale).floor() / scale, course.decimals());
                let unit = self.stage.unit();
                self.message = Some(format!("out of reach: {low} to {high} {unit}"));
                false
            }
        }
    }

    fn step(&mut self, by: f64, now: Duration) {
        let wanted = rounded(self.stage.at() + by, STEP_DECIMALS);
        let reached = self.stage.course().clamp(wanted);
        if reached != wanted {
            self.message = Some("the motion ends here".into());
        }
        self.arrive(reached, now);
    }

    fn arrive(&mut self, at: f64, now: Duration) {
        self.stage.go(at);
        self.playback.rebase(now, at);
    }

    fn play(&mut self, action: Action, now: Duration) {
        // Pausing leaves the driver where the last frame showed it.
        let at = self.stage.at();
        match action {
            Action::Slower => self.playback.slower(now, at),
            Action::Faster => self.playback.faster(now, at),
            Action::Reverse => self.playback.reverse(now, at),
            _ if self.playback.is_playing() => self.playback.pause(),
            _ => {
                self.playback.play(now, at);
                self.frame = now;
            }
        }
    }

    fn open(&mut self, distance: isize) {
        let Some(preset) = self.stage.preset_at(distance) else {
            self.message = Some("there are no presets".into());
            return;
        };
        match opening::preset(preset) {
            Ok(opened) => self.show(opened),
            Err(message) => self.message = Some(message),
        }
    }

    /// Another scene, paused where it opens: nothing is left of the one before.
    fn show_now(&mut self, opened: Opened) {
        self.original = opened.scene.text().into();
        self.end_comparison();
        self.stage = Stage::new(opened);
        self.opened += 1;
        self.steps = steps_of(&self.stage);
        self.editor = Editor::new(self.stage.scene());
        self.playback = Playback::new();
        self.survey.forget();
        self.plots = Plots::default();
        self.look(self.view);
        self.scroll = [0; View::ALL.len()];
        self.chosen = Chosen::default();
        self.lens.fit();
        self.cursor = Cursor::default();
        self.meet();
    }

    /// The same scene in another form: the driver stands where it stood, as far as it can be
    /// there, and what is looked at and chosen stays.
    pub(crate) fn exchange(&mut self, opened: Opened, now: Duration) {
        let at = self.stage.at();
        self.chosen = self.chosen.moved(self.stage.scene(), &opened.scene);
        self.stage = Stage::new(opened);
        self.opened += 1;
        self.survey.forget();
        self.look(self.view);
        self.arrive(self.stage.course().clamp(at), now);
        self.place_cursor(|cursor, _| cursor);
        self.scroll_by(0);
    }

    fn next_colours(&mut self) {
        let colours = self.capability.colours.next();
        self.capability.colours = colours;
        self.message = Some(match colours {
            Colours::None => "no colours".into(),
            Colours::Sixteen => "the 16 colours of the terminal's palette".into(),
            Colours::Indexed => "colours of the 256".into(),
            Colours::True => "colours of 24 bits".into(),
        });
    }

    fn next_glyphs(&mut self) {
        let (glyphs, name) = match self.capability.glyphs {
            Glyphs::Ascii => (Glyphs::Line, "lines"),
            Glyphs::Line => (Glyphs::Braille, "Braille"),
            Glyphs::Braille => (Glyphs::Ascii, "ASCII"),
        };
        self.capability.glyphs = glyphs;
        self.message = Some(format!("drawn with {name}"));
        self.place_cursor(|cursor, _| cursor);
        self.scroll_by(0);
    }

    fn next_view(&mut self) {
        let views = View::ALL.iter().cycle();
        let next = views.skip_while(|view| **view != self.view).nth(1);
        self.look(*next.unwrap_or(&View::Motion));
    }

    /// Looks at a view. What the lengths do is found only while it is looked at; a study begins when it
    /// is looked at for the first time.
    pub(crate) fn look(&mut self, view: View) {
        self.view = view;
        self.stage.answer(view == View::Lengths);
        self.relist();
        if view == View::Accuracy && self.survey.phase() == Phase::Idle {
            self.study();
        }
        self.sample();
    }

    /// Begins a study, goes on with it or repeats it.
    fn study(&mut self) {
        self.survey.go_on(self.stage.scene(), self.stage.solver());
    }

    /// One level back: out of a mode, or a study is stopped.
    fn back(&mut self) {
        if let Mode::Help(help) = &mut self.mode
            && help.show_all()
        {
            return;
        }
        if self.mode != Mode::Normal {
            self.mode = Mode::Normal;
        } else if self.is_working() {
            self.survey.stop();
        }
    }

    fn page(&self) -> isize {
        isize::try_from(views::page(self)).unwrap_or(isize::MAX)
    }

    /// Scrolls what is on top, within its limits.
    fn scroll_by(&mut self, lines: isize) {
        let most = match self.mode {
            Mode::Assemblies(_) => self.stage.panel().map_or(0, |p| p.rows().len() - 1),
            _ => views::most_scroll(self),
        };
        let scroll = match &mut self.mode {
            Mode::Help(help) => &mut help.scroll,
            Mode::Assemblies(scroll) => scroll,
            _ if self.view == View::Tables => {
                return self.place_cursor(|cursor, table| cursor.moved(table, lines));
            }
            _ if self.view == View::Scene => {
                self.editor.move_by(lines);
                return;
            }
            _ => &mut self.scroll[self.view as usize],
        };
        *scroll = scroll.saturating_add_signed(lines).min(most);
    }

    /// Why figures are missing, if they are.
    pub(crate) fn condition(&self) -> Condition {
        self.stage.condition()
    }
}

/// The clock by which studies are timed.
fn wall_clock() -> Duration {
    static BEGUN: LazyLock<Instant> = LazyLock::new(Instant::now);
    BEGUN.elapsed()
}

/// The height of a cell for its width in most fonts.
const USUAL_ASPECT: f64 = 2.0;

fn steps_of(stage: &Stage) -> Steps {
    if stage.course().turns() {
        Steps::of_angle()
    } else {
        Steps::of_length(stage.course().span())
    }
}
