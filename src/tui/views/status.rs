//! The last line: mode, scene, driver, state, what it cost and its largest bound; then the keys that
//! matter now, as far as there is room.
//!
//! ```text
//!  motion  four-bar   60.00 deg  ok  63 ns, +-2e-13 mm  ? help  space play  q quit
//!  motion  peaucellier   79.60 deg  dead point in 3.2 deg  ? help  space play  q quit
//! ```

use super::{columns, cut, most_scroll, print};
use crate::report::upwards;
use crate::solver::Condition;
use crate::tui::Origin;
use crate::tui::action::{Action, PlotsAction, SceneAction, TablesAction, entry_of};
use crate::tui::ahead::ahead;
use crate::tui::app::{App, Entry, Mode, Unsaved, View, Wanted};
use crate::tui::figures::coordinate;
use crate::tui::key::Key;
use crate::tui::line::Line;
use crate::tui::picker::{Picker, Place, Purpose};
use crate::tui::preview::Preview;
use crate::tui::sheet::FOUND;
use crate::tui::stage::{Stage, shown};
use crate::tui::survey::Phase;
use crate::tui::theme::{self, Part};
use crate::tui::writing::{Document, Prompt, Question};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Longer names of scenes are cut; on short lines sooner, and left out where they would say nothing.
const LONGEST_SCENE: usize = 20;
const SHORTEST_SCENE: u16 = 6;

/// The name of a file that is asked about keeps so many characters.
const SHORTEST_FILE: u16 = 12;

/// More turns than this are told with an exponent.
const MANY_TURNS: f64 = 1e7;

/// Narrower lines have single blanks between their parts.
const ROOM_FOR_GAPS: u16 = 60;

pub(super) fn render(app: &App, area: Rect, buffer: &mut Buffer) {
    let mut line = Writer {
        buffer,
        x: area.x,
        area,
    };
    line.say(&format!(" {} ", mode(app)), Part::Mode);
    match app.mode() {
        Mode::GoTo(typed) => {
            prompt(app, typed, &mut line);
            return;
        }
        Mode::FileName(prompt) => {
            file_prompt(app, &prompt.name, &mut line);
            return;
        }
        Mode::Unsaved(asked) => {
            unsaved(app, asked, &mut line);
            return;
        }
        Mode::Confirm(asked) => {
            question(app, asked, &mut line);
            return;
        }
        Mode::Pick(picker) => {
            picking(app, picker, &mut line);
            return;
        }
        Mode::Search(search) => {
            search_prompt(app, &search.name, &mut line);
            return;
        }
        Mode::Value(entry) => {
            entry_prompt(app, entry, &mut line);
            return;
        }
        Mode::Copy => {
            how_much(&mut line);
            return;
        }
        Mode::Normal | Mode::Help(_) | Mode::Tour(_) | Mode::Assemblies(_) | Mode::PlotList(_) => {}
    }
    let studied = studied(app);
    let driver = studied.clone().unwrap_or_else(|| driver(app.stage()));
    let narrow = area.width < ROOM_FOR_GAPS;
    let (state, part) = match studied {
        Some(_) => ("", Part::Text),
        None => state(app.condition(), narrow),
    };
    if let Some(message) = app.message() {
        line.gap(1);
        line.say(&driver, Part::Text);
        line.gap(2);
        // Why figures are missing stays to be read, whatever else there is to say.
        if app.condition() != Condition::Ok {
            line.say(state, part);
            line.gap(2);
            if line.room() < columns(message) {
                return;
            }
        }
        line.tell(message, app);
        return;
    }
    let gap = if narrow { 1 } else { 2 };
    line.gap(1);
    // A short line keeps its room for the key that leads on.
    let (key, name) = hint_of(app, offered(app)[0]).unwrap_or_default();
    let behind = [&driver, state, &key, name]
        .map(columns)
        .iter()
        .sum::<u16>()
        + 3 * gap
        + 1;
    let room = line.room().saturating_sub(behind);
    if room >= SHORTEST_SCENE && !(narrow && listing(app)) {
        let longest = usize::from(room - gap).min(LONGEST_SCENE);
        line.say(&cut(&scene(app), longest), Part::Text);
        line.gap(gap);
    }
    line.say(&driver, Part::Text);
    line.gap(gap);
    let needed = gap + columns(&key) + 1 + columns(name);
    if studied.is_none() {
        standing(app, narrow, needed, &mut line);
    } else {
        line.gap(gap);
    }
    hints(app, &mut line);
}

/// Columns of what can lie ahead, and of the hints that are worth more than the cost of a state.
const NEAR: u16 = 24;
const HINTS: u16 = 26;

/// How the mechanism stands: its state, or what lies ahead of it, and how far that can be trusted. What
/// comes behind stays in its place while it moves on, so far as there is room.
fn standing(app: &App, narrow: bool, needed: u16, line: &mut Writer<'_>) {
    let gap = if narrow { 1 } else { 2 };
    let (begun, trust) = (line.x, trust(app));
    let (state, part) = state(app.condition(), narrow);
    let near = near(app).filter(|text| !narrow && line.room() >= columns(text) + needed);
    let reserved = if narrow || !can_come_near(app) {
        0
    } else {
        NEAR
    };
    let of_trust = trust.as_deref().map_or(0, |trust| columns(trust) + gap);
    let side_by_side = line.room() >= reserved + gap + of_trust + HINTS;
    if let Some(near) = &near {
        line.say(near, Part::Text);
        line.gap(gap);
    } else if !(narrow && listing(app) && app.condition() == Condition::Ok) {
        line.say(state, part);
        line.gap(gap);
    }
    if side_by_side && reserved > 0 {
        line.x = line.x.max(begun + reserved + gap);
    }
    let fits = |trust: &String| line.room() >= columns(trust) + needed;
    let shown = trust.filter(|trust| (near.is_none() || side_by_side) && fits(trust));
    if let Some(trust) = shown {
        line.say(&trust, Part::Quiet);
        line.gap(gap);
    }
    let from = begun + reserved + gap;
    if reserved > 0 && line.area.right().saturating_sub(from) >= needed {
        line.x = line.x.max(from);
    }
}

/// Whether there is anything in the motion that the driver can come near to.
fn can_come_near(app: &App) -> bool {
    let stage = app.stage();
    stage.course().shuttle().is_some() || !stage.solver().motion().change_points.is_empty()
}

fn listing(app: &App) -> bool {
    matches!(app.mode(), Mode::Assemblies(_))
}

/// What lies ahead of the driver, where figures exist and something is near.
fn near(app: &App) -> Option<String> {
    let stage = app.stage();
    if app.condition() != Condition::Ok {
        return None;
    }
    let backwards = app.playback().is_backwards();
    let motion = stage.solver().motion();
    let ahead = ahead(stage.course(), motion, stage.at(), backwards)?;
    Some(ahead.text(stage.course(), stage.unit()))
}

/// What the last state cost, where that was measured, and how far a place in it can be from the truth.
/// Not beside what the lengths do: that is another kind of error.
fn trust(app: &App) -> Option<String> {
    let stage = app.stage();
    let shows_figures = match (app.mode(), app.view()) {
        (Mode::Normal, View::Motion | View::Tables) => true,
        (
            Mode::Normal,
            View::Plots | View::Accuracy | View::Forces | View::Scene | View::Lengths,
        )
        | (
            Mode::Help(_)
            | Mode::Tour(_)
            | Mode::GoTo(_)
            | Mode::Assemblies(_)
            | Mode::PlotList(_)
            | Mode::FileName(_)
            | Mode::Value(_)
            | Mode::Confirm(_)
            | Mode::Unsaved(_)
            | Mode::Pick(_)
            | Mode::Search(_)
            | Mode::Copy,
            _,
        ) => false,
    };
    if !shows_figures || app.condition() != Condition::Ok {
        return None;
    }
    if app.view() == View::Tables {
        return of_cursor(app);
    }
    let bound = match stage.largest_bound() {
        Some(bound) => format!("+-{} {}", upwards(bound, 1), stage.scene().unit.symbol()),
        None => "no bound".into(),
    };
    Some(match stage.cost() {
        Some(cost) => format!("{cost}, {bound}"),
        None => bound,
    })
}

/// How far the figure under the cursor can be from the truth.
fn of_cursor(app: &App) -> Option<String> {
    let (sheet, tables, cursor) = (app.sheet(), app.tables(), app.cursor());
    let entries = sheet.entries(tables, cursor.part, cursor.row);
    let entry = entries.get(cursor.column).copied().flatten()?;
    let unit = sheet.unit(cursor.part, cursor.column)?;
    entry.value?;
    Some(match entry.bound {
        _ if entry.given => "given".into(),
        Some(bound) => format!("+-{} {unit}", upwards(bound, 1)),
        None => "no bound".into(),
    })
}

fn mode(app: &App) -> &'static str {
    match (app.mode(), app.view()) {
        (Mode::Help(_), _) => "help",
        (Mode::Tour(_), _) => "tour",
        (Mode::GoTo(_), _) => "go to",
        (Mode::Assemblies(_) | Mode::PlotList(_), _) => "choose",
        (Mode::FileName(Prompt { document, .. }), _)
        | (Mode::Confirm(Question { document, .. }), _) => match document {
            Document::Scene => "save",
            Document::Text(_) => "write",
        },
        (Mode::Pick(picker), _) => match picker.purpose() {
            Purpose::Open => "open",
            Purpose::Compare => "compare",
        },
        (Mode::Search(_), _) => "search",
        (Mode::Copy, _) => "copy",
        (Mode::Unsaved(asked), _) => match asked {
            Unsaved::Quit => "quit",
            Unsaved::Open => "open",
            Unsaved::Reload => "reload",
            Unsaved::Found(_) => "found",
        },
        (Mode::Value(entry), _) => match entry.purpose {
            Wanted::Value => "edit",
            Wanted::Find(_) => "find",
        },
        (Mode::Normal, View::Motion) => "motion",
        (Mode::Normal, View::Tables) => "tables",
        (Mode::Normal, View::Accuracy) => "accuracy",
        (Mode::Normal, View::Lengths) => "lengths",
        (Mode::Normal, View::Plots) => "plots",
        (Mode::Normal, View::Forces) => "forces",
        (Mode::Normal, View::Scene) => "scene",
    }
}

fn scene(app: &App) -> String {
    let name = match app.stage().origin() {
        Origin::Preset(name) => name.clone(),
        Origin::File(path) => {
            let name = path.file_name().unwrap_or(path.as_os_str());
            name.to_string_lossy().into_owned()
        }
        Origin::Stdin => "stdin".into(),
    };
    let mark = if app.is_changed() { "*" } else { "" };
    shown(&name, app.glyphs()) + mark
}

/// The driver's coordinate: an angle within a turn, and the turns.
fn driver(stage: &Stage) -> String {
    let (at, unit) = (stage.at(), stage.unit());
    let course = stage.course();
    if !course.turns() || course.shuttle().is_some() {
        let text = coordinate(at, course.decimals());
        return format!("{text:>7} {unit}");
    }
    let turns = (at / crate::angle::TURN).floor();
    // Subtracting whole turns from a decimal leaves digits that nobody asked for.
    let within = crate::tui::course::rounded(at - turns * crate::angle::TURN, 9);
    let text = coordinate(within, course.decimals());
    if turns == 0.0 {
        format!("{text:>6} {unit}")
    } else {
        let plural = if turns.abs() == 1.0 { "" } else { "s" };
        let turns = if turns.abs() < MANY_TURNS {
            format!("{turns:+}")
        } else {
            format!("{turns:+.3e}")
        };
        format!("{text:>6} {unit} {turns} turn{plural}")
    }
}

/// How far the study has come, in the view that shows it: there, the driver is of no interest.
fn studied(app: &App) -> Option<String> {
    let survey = app.survey();
    let percent = (survey.progress() * 100.0).floor();
    match survey.phase() {
        _ if app.view() != View::Accuracy || *app.mode() != Mode::Normal => None,
        Phase::Idle => None,
        Phase::Running => Some(format!("measuring {percent:>2} %")),
        Phase::Stopped => Some(format!("stopped at {percent} %")),
        Phase::Done => Some("all measured".into()),
    }
}

/// In one word, and with what follows from it where there is room.
fn state(condition: Condition, narrow: bool) -> (&'static str, Part) {
    match condition {
        Condition::Ok => ("ok", Part::Text),
        Condition::ChangePoint => ("change point", Part::Warning),
        Condition::DeadPoint if narrow => ("dead point", Part::Warning),
        Condition::DeadPoint => ("dead point: no rates", Part::Warning),
        Condition::NoAssembly if narrow => ("no assembly", Part::Warning),
        Condition::NoAssembly => ("no assembly here", Part::Warning),
    }
}

fn prompt(app: &App, typed: &Line, line: &mut Writer<'_>) {
    let what = if app.stage().course().turns() {
        "angle"
    } else {
        "position"
    };
    line.say(&format!(" {what} [{}]: ", app.stage().unit()), Part::Text);
    line.say(typed.text(), Part::Text);
    line.say(" ", Part::Caret);
    line.gap(3);
    if let Some(message) = app.message() {
        line.tell(message, app);
        return;
    }
    line.hint(&Key::Enter.to_string(), "go");
    line.hint(&Key::Escape.to_string(), "cancel");
}

/// Where the name of a file is typed; of a long one its end is seen.
fn file_prompt(app: &App, typed: &Line, line: &mut Writer<'_>) {
    line.say(" write to: ", Part::Text);
    let room = usize::from(line.room().saturating_sub(1));
    let skipped = typed.text().len().saturating_sub(room);
    line.say(typed.text().get(skipped..).unwrap_or_default(), Part::Text);
    line.say(" ", Part::Caret);
    if object(app, line) {
        return;
    }
    line.hint(&Key::Enter.to_string(), "write");
    line.hint(&Key::Escape.to_string(), "cancel");
}

/// What is under the cursor of a list of scenes, in a few words, and what can be done with it.
fn picking(app: &App, picker: &Picker, line: &mut Writer<'_>) {
    line.gap(1);
    let enter = match picker.chosen().map(|item| &item.place) {
        None => None,
        Some(Place::Folder(_)) => Some("look inside"),
        Some(Place::Original | Place::File(_) | Place::Preset(_)) => Some(mode(app)),
    };
    let keys = [(Key::Enter, enter), (Key::Escape, Some("back"))];
    let keys = keys.map(|(key, name)| Some((key.to_string(), name?)));
    let needed = |(key, name): &(String, &str)| columns(key) + 1 + columns(name) + 2;
    // Where there is no room for a preview, the title alone tells what it would show.
    let hints: u16 = match app.size().width < ROOM_FOR_GAPS {
        true => 0,
        false => keys.iter().flatten().map(needed).sum(),
    };
    let (words, part) = match app.preview() {
        _ if let Some(message) = app.message() => (message, Part::Warning),
        Some(Preview::Scene(sample)) => (sample.scene.name.as_str(), Part::Text),
        Some(Preview::Fault(fault)) => (fault.what.as_str(), Part::Warning),
        Some(Preview::Unseen(why)) => (why.as_str(), Part::Quiet),
        Some(Preview::Folder(names)) if names.is_empty() => ("no scene in it", Part::Quiet),
        Some(Preview::Folder(_)) => ("a folder", Part::Quiet),
        None => ("", Part::Quiet),
    };
    let longest = line.room().saturating_sub(hints + 1);
    let words = cut(&shown(words, app.glyphs()), longest.into());
    line.say(&words, part);
    line.gap(2);
    for (key, name) in keys.iter().flatten() {
        line.hint(key, name);
    }
}

/// Where a name is typed that is sought in the tables.
fn search_prompt(app: &App, typed: &Line, line: &mut Writer<'_>) {
    line.say(" name: ", Part::Text);
    line.say(typed.text(), Part::Text);
    line.say(" ", Part::Caret);
    if object(app, line) {
        return;
    }
    line.hint(&Key::Enter.to_string(), "keep");
    line.hint(&Key::Escape.to_string(), "back");
}

/// Says behind a line that is typed in what is wrong with it, if something is.
fn object(app: &App, line: &mut Writer<'_>) -> bool {
    line.gap(3);
    if let Some(message) = app.message() {
        line.tell(message, app);
    }
    app.message().is_some()
}

/// How much of the tables is copied.
fn how_much(line: &mut Writer<'_>) {
    line.gap(1);
    for (key, name) in [("v", "value"), ("r", "row"), ("t", "table")] {
        line.hint(key, name);
    }
    line.hint(&Key::Escape.to_string(), "back");
}

/// What is typed in the scene view: a value stands in its row, a name here.
fn entry_prompt(app: &App, entry: &Entry, line: &mut Writer<'_>) {
    line.gap(1);
    let done = match entry.purpose {
        Wanted::Value => {
            if let (None, Some(value)) = (app.message(), app.editor().value()) {
                let units = value.units().join(", ");
                line.say(&format!("{} in {units}", value.name), Part::Text);
                line.gap(2);
            }
            "take"
        }
        Wanted::Find(_) => {
            line.say(entry.line.text(), Part::Text);
            line.say(" ", Part::Caret);
            line.gap(2);
            "stay"
        }
    };
    if let Some(message) = app.message() {
        line.tell(message, app);
        return;
    }
    line.hint(&Key::Enter.to_string(), done);
    line.hint(&Key::Escape.to_string(), "cancel");
}

/// What is to become of unsaved edits.
fn unsaved(app: &App, asked: &Unsaved, line: &mut Writer<'_>) {
    let edits = match asked {
        Unsaved::Quit | Unsaved::Open => "unsaved edits".to_owned(),
        Unsaved::Reload => "read it over unsaved edits?".to_owned(),
        Unsaved::Found(found) if found.stale => format!("stale edits of {}", found.time),
        Unsaved::Found(found) => format!("unsaved edits of {}", found.time),
    };
    let keys = match asked {
        Unsaved::Quit => [("w", "save"), ("q", "drop, quit"), ("Esc", "stay")],
        Unsaved::Open => [("w", "save"), ("d", "drop, open"), ("Esc", "stay")],
        Unsaved::Reload => [("Enter", "read"), ("Esc", "keep"), ("", "")],
        Unsaved::Found(_) => [("Enter", "take"), ("Esc", "leave"), ("d", "delete")],
    };
    let keys = || keys.iter().filter(|(key, _)| !key.is_empty());
    let needed = |(key, name): &(&str, &str)| columns(key) + 1 + columns(name) + 2;
    // The keys are what a question is good for.
    let room = line
        .room()
        .saturating_sub(keys().map(needed).sum::<u16>() + 1);
    line.gap(1);
    let edits = if columns(&edits) > room {
        String::new()
    } else {
        edits
    };
    line.say(&shown(&edits, app.glyphs()), Part::Text);
    line.gap(if edits.is_empty() { 0 } else { 2 });
    for (key, name) in keys() {
        line.hint(key, name);
    }
}

/// Whether to write over a file.
fn question(app: &App, asked: &Question, line: &mut Writer<'_>) {
    let to = &asked.to;
    let name = to.file_name().unwrap_or(to.as_os_str()).to_string_lossy();
    let what = match (&asked.document, app.stage().origin()) {
        (Document::Scene | Document::Text(_), _) => "over",
    };
    let name = shown(&name, app.glyphs());
    // The keys are what a question is good for.
    let keys = columns("Enter write  Esc cancel");
    let room = line
        .room()
        .saturating_sub(keys + columns(what) + columns(" write  ?  "));
    let name = cut(&name, usize::from(room.max(SHORTEST_FILE)));
    line.say(&format!(" write {what} {name}?"), Part::Text);
    line.gap(2);
    line.hint(&Key::Enter.to_string(), "write");
    line.hint(&Key::Escape.to_string(), "cancel");
}

/// What to offer now, the most important first: the last ones are dropped where there is no room.
fn offered(app: &App) -> &'static [Action] {
    match (app.mode(), app.view()) {
        (Mode::Help(_), _) => &[Action::Back, Action::Search, Action::LineDown, Action::Quit],
        (Mode::Tour(_), _) => &[Action::Back, Action::StepForward, Action::StepBack],
        (Mode::Assemblies(_), _) => &[Action::Back, Action::LineDown, Action::Save, Action::Help],
        (Mode::Pick(_), _) => &[Action::Back],
        (_, View::Motion) => &[
            Action::Help,
            Action::Play,
            Action::Quit,
            Action::StepForward,
            Action::GoTo,
            Action::NextPreset,
        ],
        (_, View::Accuracy) => match app.survey().phase() {
            Phase::Running => &[
                Action::Help,
                Action::Back,
                Action::LineDown,
                Action::MotionView,
                Action::Quit,
            ],
            Phase::Idle | Phase::Stopped | Phase::Done => &[
                Action::Help,
                Action::AccuracyView,
                Action::LineDown,
                Action::MotionView,
                Action::Quit,
            ],
        },
        (_, View::Tables) => &[
            Action::Help,
            Action::Search,
            Action::Copy,
            Action::MotionView,
            Action::Tables(TablesAction::Choose),
            Action::Csv,
            Action::Quit,
        ],
        (_, View::Scene) => &[
            Action::Help,
            Action::Scene(SceneAction::Edit),
            Action::Scene(SceneAction::NudgeDown),
            Action::Scene(SceneAction::NudgeUp),
            Action::Save,
            Action::Undo,
            Action::MotionView,
            Action::Quit,
        ],
        (_, View::Plots) => &[
            Action::Help,
            Action::Plots(PlotsAction::Choose),
            Action::LineDown,
            Action::Plots(PlotsAction::Abscissa),
            Action::MotionView,
            Action::Play,
            Action::StepForward,
            Action::Quit,
        ],
        (_, View::Forces | View::Lengths) => &[
            Action::Help,
            Action::MotionView,
            Action::LineDown,
            Action::Quit,
            Action::Play,
            Action::StepForward,
        ],
    }
}

fn hints(app: &App, line: &mut Writer<'_>) {
    if matches!(app.mode(), Mode::Help(help) if help.is_typing()) {
        line.hint(&Key::Escape.to_string(), "all keys");
        line.hint(&Key::Enter.to_string(), "keep");
        return;
    }
    if let Mode::PlotList(list) = app.mode() {
        for (key, name) in list_hints(list.is_typing()) {
            line.hint(&key.to_string(), name);
        }
        return;
    }
    let listing = listing(app);
    let can_scroll = listing || most_scroll(app) > 0;
    if listing {
        line.hint(&Key::Enter.to_string(), "take");
    }
    for &action in offered(app) {
        if action == Action::LineDown && !can_scroll {
            continue;
        }
        if let Some((key, name)) = hint_of(app, action) {
            line.hint(&key, name);
        }
        if action == Action::Help && app.view() == View::Tables {
            line.hint(&FOUND.to_string(), "found");
        }
    }
}

/// The keys of the list in which is chosen what is plotted.
fn list_hints(typing: bool) -> &'static [(Key, &'static str)] {
    if typing {
        &[(Key::Enter, "keep"), (Key::Escape, "all")]
    } else {
        &[
            (Key::Enter, "plot it or not"),
            (Key::Escape, "done"),
            (Key::Char('/'), "search"),
            (Key::Char('c'), "none"),
        ]
    }
}

/// The first key of an action, if it has one, and what it does now.
fn hint_of(app: &App, action: Action) -> Option<(String, &'static str)> {
    let key = app.keymap().key(action)?;
    let name = match action {
        Action::Play if app.playback().is_playing() => "pause",
        Action::Scene(SceneAction::NudgeDown) => "less",
        Action::Scene(SceneAction::NudgeUp) => "more",
        Action::Back if matches!(app.mode(), Mode::Tour(_)) => "end",
        Action::Back if app.is_working() && *app.mode() == Mode::Normal => "stop",
        Action::LineDown if matches!(app.mode(), Mode::Assemblies(_)) => "next",
        Action::Plots(PlotsAction::Choose) => "choose",
        Action::Plots(PlotsAction::Abscissa) => "along x",
        Action::AccuracyView if app.survey().phase() == Phase::Stopped => "go on",
        Action::AccuracyView if app.survey().phase() == Phase::Done => "again",
        _ => entry_of(action).name,
    };
    Some((key.to_string(), name))
}

/// Writes along the line.
struct Writer<'a> {
    buffer: &'a mut Buffer,
    x: u16,
    area: Rect,
}

impl Writer<'_> {
    fn room(&self) -> u16 {
        self.area.right().saturating_sub(self.x)
    }

    fn say(&mut self, text: &str, part: Part) {
        let (room, style) = (self.room(), theme::part(part));
        self.x = print(self.buffer, self.x, self.area.y, room, text, style);
    }

    fn gap(&mut self, columns: u16) {
        self.x = self.x.saturating_add(columns);
    }

    /// A message, over what stands before it if there is no room behind.
    fn tell(&mut self, message: &str, app: &App) {
        let message = shown(message, app.glyphs());
        let latest = self.area.right().saturating_sub(columns(&message));
        let latest = latest.max(self.area.x);
        if latest < self.x {
            // It covers, but does not run into what it does not cover.
            self.x = latest.saturating_sub(1).max(self.area.x);
            self.say(" ", Part::Text);
            self.x = latest;
        }
        self.say(&message, Part::Warning);
    }

    /// A key and what it does; nothing where there is no room for both.
    fn hint(&mut self, key: &str, name: &str) {
        let needed = columns(key) + 1 + columns(name);
        if needed > self.room() {
            self.x = self.area.right();
            return;
        }
        self.say(key, Part::Key);
        self.gap(1);
        self.say(name, Part::Quiet);
        self.gap(2);
    }
}
