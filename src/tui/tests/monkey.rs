//! Tests the workbench with a random user, called the monkey. No action may cause a panic, an
//! invalid state, or output that the terminal cannot show.
//!
//! `cargo test` runs 6,000 actions, and `KRANK_MONKEY=1000000 cargo test --release monkey` a
//! million. A failure prints the seed of its episode; `KRANK_MONKEY_SEED` starts with that seed.
//! Because the monkey saves files, it runs in its own process, in an empty folder.

use crate::capability::{Capability, Colours};
use crate::drawing::Glyphs;
use crate::scene::{is_harmful, presets};
use crate::tests::{Fuzz, TestRng, shape};
use crate::tui::app::{App, Effect, Mode, View};
use crate::tui::commands::key::Key;
use crate::tui::commands::keymap::Keymap;
use crate::tui::commands::mouse::{Mouse, MouseEventKind};
use crate::tui::document::opening;
use crate::tui::terminal::{Keyboard, TerminalInput};
use crate::tui::views::scene_picker::list::PickerTarget;
use crate::tui::views::tour::screens::SCREENS;
use crate::tui::{Origin, Theme, Workbench, views};
use ratatui::layout::{Position, Size};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::panic::{self, AssertUnwindSafe};
use std::path::{Component, Path};
use std::process::Command;
use std::time::{Duration, Instant};

/// Maximum number of actions per workbench.
const MAX_ACTIONS: usize = 400;
/// Number of actions by default.
const ORDINARY: usize = 6000;
/// The environment variable that marks the monkey's process.
const CHILD_VARIABLE: &str = "KRANK_MONKEY_CAGE";

#[test]
fn monkey_actions_keep_workbench_valid() {
    caged("run_monkey_child");
}

/// Runs another test of this module in a separate process and folder.
#[allow(clippy::print_stdout, reason = "the figures are to be read")]
fn caged(name: &str) {
    let (_, module) = module_path!().split_once("::").unwrap();
    let test = format!("{module}::{name}");
    let cage = std::env::temp_dir().join(format!("krank-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&cage).unwrap();
    let done = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", &test, "--ignored", "--nocapture"])
        .current_dir(&cage)
        .env(CHILD_VARIABLE, "1")
        .env("HOME", &cage)
        .env("XDG_STATE_HOME", &cage)
        .env("XDG_CONFIG_HOME", &cage)
        .output()
        .unwrap();
    std::fs::remove_dir_all(&cage).unwrap();
    let text = String::from_utf8_lossy(&done.stdout);
    let why = String::from_utf8_lossy(&done.stderr);
    assert!(
        done.status.success() && text.contains("1 passed"),
        "{text}\n{why}"
    );
    for line in text.lines().filter(|line| line.contains(" s")) {
        println!("{line}");
    }
}

/// Does nothing if started directly, because it writes files to the current folder.
#[test]
#[ignore = "started by the test above, in a folder of its own"]
#[allow(clippy::print_stdout, reason = "the figures are to be read")]
fn run_monkey_child() {
    if std::env::var_os(CHILD_VARIABLE).is_none() {
        return;
    }
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse().ok());
    let wanted: usize = number("KRANK_MONKEY").unwrap_or(ORDINARY);
    let first = number("KRANK_MONKEY_SEED").unwrap_or(1);
    let started = Instant::now();
    let mut actions = 0;
    for seed in (first as u64).. {
        if actions >= wanted {
            break;
        }
        actions += episode(seed);
    }
    let seconds = started.elapsed().as_secs_f64();
    println!("{actions} actions of a monkey in {seconds:.1} s");
}

/// Runs one workbench from start to end, and returns the number of actions.
fn episode(seed: u64) -> usize {
    let mut done = Vec::new();
    let outcome = panic::catch_unwind(AssertUnwindSafe(|| {
        live(&mut TestRng::new(seed), &mut done)
    }));
    if let Err(why) = outcome {
        let last = &done[done.len().saturating_sub(30)..];
        eprintln!(
            "KRANK_MONKEY_SEED={seed}: after {} actions, the last of them {last:?}",
            done.len()
        );
        panic::resume_unwind(why);
    }
    done.len()
}

/// An action of the monkey.
#[derive(Debug)]
enum MonkeyAction {
    Press(Key),
    /// Bytes from the terminal line: keys, parts of keys, and random bytes.
    Bytes(Vec<u8>),
    Paste(String),
    Resize(u16, u16),
    Pass(Duration),
    Mouse(Mouse),
}

fn live(rng: &mut TestRng, done: &mut Vec<MonkeyAction>) {
    let preset = rng.one_of(presets::all());
    let glyphs = *rng.one_of(&Glyphs::ALL);
    let colours = *rng.one_of(&[
        Colours::None,
        Colours::Sixteen,
        Colours::Indexed,
        Colours::True,
    ]);
    let theme = *rng.one_of(&[Theme::Auto, Theme::Light, Theme::Dark]);
    let capability = Capability {
        glyphs,
        colours,
        modern: rng.below(2) == 0,
    };
    let (cols, rows) = size(rng);
    let opened = opening::preset(preset).unwrap();
    let workbench = Workbench::on(opened, None, capability, Size::new(cols, rows));
    let mut workbench = workbench.themed(theme).timed_by(random_time);
    let mut keyboard = Keyboard::default();
    if rng.below(2) == 0 {
        workbench.press("M");
    }
    for _ in 0..MAX_ACTIONS {
        let action = random_action(rng, workbench.app());
        done.push(action);
        let action = done.last().unwrap();
        match action {
            MonkeyAction::Press(key) => {
                if workbench.key(*key) == Effect::Quit {
                    return;
                }
            }
            MonkeyAction::Bytes(bytes) => {
                if !send(bytes, &mut keyboard, &mut workbench) {
                    return;
                }
            }
            MonkeyAction::Paste(text) => workbench.app().paste(text),
            MonkeyAction::Resize(cols, rows) => workbench.resize(*cols, *rows),
            MonkeyAction::Pass(time) => workbench.pass(*time),
            MonkeyAction::Mouse(mouse) => {
                if workbench.point(*mouse) == Effect::Quit {
                    return;
                }
            }
        }
        check(workbench.app());
        if rng.below(3) == 0 {
            let frame = workbench.paint().to_vec();
            let app = workbench.app();
            check_bytes(&frame, app.glyphs(), app.colours());
            check(app);
        }
    }
}

/// Sends bytes as a terminal does; a NUL byte stands for a pause. Returns `false` once the
/// workbench has quit.
fn send(bytes: &[u8], keyboard: &mut Keyboard, workbench: &mut Workbench) -> bool {
    let mut inputs = Vec::new();
    for byte in bytes {
        match byte {
            0 => {
                keyboard.give_up(&mut inputs);
                workbench.pass(Duration::from_millis(50));
            }
            _ => keyboard.feed(&[*byte], Instant::now(), &mut inputs),
        }
        for input in inputs.drain(..) {
            match input {
                TerminalInput::Key(key) if stays(workbench.app(), &MonkeyAction::Press(key)) => {
                    if workbench.key(key) == Effect::Quit {
                        return false;
                    }
                }
                TerminalInput::Paste(text) => {
                    workbench.app().paste(&text.replace(['/', '~', '.'], ""))
                }
                TerminalInput::Mouse(mouse) => {
                    if workbench.point(mouse) == Effect::Quit {
                        return false;
                    }
                }
                TerminalInput::Key(_) | TerminalInput::Answer | TerminalInput::Colour(_) => {}
            }
            check(workbench.app());
        }
    }
    true
}

fn random_time() -> Duration {
    thread_local!(static NOW: std::cell::Cell<Duration> = const { std::cell::Cell::new(Duration::ZERO) });
    NOW.set(NOW.get() + Duration::from_millis(5));
    NOW.get()
}

fn size(rng: &mut TestRng) -> (u16, u16) {
    match rng.below(10) {
        0 => *rng.one_of(&[(0, 0), (1, 1), (39, 12), (40, 11), (0, 50), (500, 1)]),
        1 | 2 => (40, 12),
        3..=6 => (80, 24),
        _ => (rng.small(160), rng.small(60)),
    }
}

fn random_action(rng: &mut TestRng, app: &App) -> MonkeyAction {
    let action = match rng.below(100) {
        0..55 => MonkeyAction::Press(random_bound_key(rng)),
        55..70 => MonkeyAction::Press(*rng.one_of(&LEADING)),
        70..78 => MonkeyAction::Press(Key::Char(char::from(b' ' + rng.small(95) as u8))),
        78..84 => MonkeyAction::Mouse(random_mouse(rng, app)),
        84..86 => MonkeyAction::Press(*rng.one_of(&ODD)),
        86 => MonkeyAction::Bytes(noise(rng)),
        87 => MonkeyAction::Paste((0..rng.below(40)).map(|_| *rng.one_of(&PASTED)).collect()),
        88..91 => {
            let (cols, rows) = size(rng);
            MonkeyAction::Resize(cols, rows)
        }
        91..99 => MonkeyAction::Pass(Duration::from_millis(rng.below(200) as u64)),
        _ => MonkeyAction::Pass(Duration::from_secs(rng.below(100_000) as u64)),
    };
    if stays(app, &action) {
        action
    } else {
        MonkeyAction::Press(Key::Escape)
    }
}

/// Returns a random mouse event, sometimes beyond the edge of the screen.
fn random_mouse(rng: &mut TestRng, app: &App) -> Mouse {
    let actions = [
        MouseEventKind::Press,
        MouseEventKind::Drag,
        MouseEventKind::Drag,
        MouseEventKind::Release,
        MouseEventKind::WheelUp,
        MouseEventKind::WheelDown,
    ];
    let within = |rng: &mut TestRng, maximum: u16| rng.below(usize::from(maximum) + 2) as u16;
    let size = app.size();
    Mouse {
        kind: *rng.one_of(&actions),
        at: Position::new(within(rng, size.width), within(rng, size.height)),
    }
}

/// Returns random bytes as from a bad line, without keys that quit, because quitting ends the
/// episode.
fn noise(rng: &mut TestRng) -> Vec<u8> {
    let mut bytes = Vec::new();
    for _ in 0..rng.below(12) {
        match rng.below(3) {
            0 => bytes.push(rng.below(256) as u8),
            _ => bytes.extend_from_slice(rng.one_of(&SEQUENCES).as_bytes()),
        }
    }
    bytes.retain(|byte| !matches!(byte, b'q' | 3));
    bytes
}

/// Keys that confirm, cancel or move, in every mode.
const LEADING: [Key; 10] = [
    Key::Enter,
    Key::Enter,
    Key::Escape,
    Key::Escape,
    Key::Backspace,
    Key::Tab,
    Key::Up,
    Key::Down,
    Key::Left,
    Key::Right,
];

/// Keys that no keyboard sends, but a bad line might.
const ODD: [Key; 9] = [
    Key::Char('\u{e9}'),
    Key::Char('\u{4e2d}'),
    Key::Char('\u{202e}'),
    Key::Char('\u{0}'),
    Key::Char('\u{1b}'),
    Key::BackTab,
    Key::End,
    Key::Function(12),
    Key::Ctrl('u'),
];

const PASTED: [char; 12] = [
    '0', '1', '9', '.', '-', 'e', ' ', 'q', '\n', '\u{1b}', '\u{202e}', '\u{4e2d}',
];

fn random_bound_key(rng: &mut TestRng) -> Key {
    let keymap = Keymap::default();
    let rows: Vec<&[Key]> = keymap.rows().map(|(_, keys)| keys).collect();
    let keys = *rng.one_of(&rows);
    let key = *rng.one_of(keys);
    // Quitting ends the episode, so it is rare.
    if matches!(key, Key::Char('q') | Key::Ctrl('c')) && rng.below(20) > 0 {
        return Key::Char(' ');
    }
    key
}

/// Returns `true` if the action reads and writes only within the monkey's folder.
fn stays(app: &App, action: &MonkeyAction) -> bool {
    match (app.mode(), action) {
        (Mode::FileName(_), MonkeyAction::Press(Key::Char(c))) => !matches!(c, '/' | '~' | '.'),
        (Mode::FileName(prompt), MonkeyAction::Press(Key::Enter)) => {
            is_in_child_folder(Path::new(prompt.name.text().trim()))
        }
        (Mode::Confirm(question), MonkeyAction::Press(Key::Enter)) => {
            is_in_child_folder(&question.to)
        }
        (Mode::AssemblyChoice(_), MonkeyAction::Press(Key::Left)) => false,
        (Mode::AssemblyChoice(picker), MonkeyAction::Press(Key::Enter | Key::Right)) => {
            match picker.chosen().map(|item| &item.place) {
                Some(PickerTarget::Folder(path) | PickerTarget::File(path)) => {
                    is_in_child_folder(path)
                }
                Some(
                    PickerTarget::Original | PickerTarget::Candidates | PickerTarget::Preset(_),
                )
                | None => true,
            }
        }
        _ => match app.open_scene().origin() {
            Origin::File(path) => is_in_child_folder(path),
            Origin::Preset(_) | Origin::New(_) | Origin::Stdin => true,
        },
    }
}

fn is_in_child_folder(path: &Path) -> bool {
    let inside = |part| matches!(part, Component::Normal(_) | Component::CurDir);
    let cage = std::env::current_dir().unwrap();
    let within = path.strip_prefix(&cage).unwrap_or(path);
    within.components().all(inside)
}

/// Checks the invariants of the workbench.
fn check(app: &App) {
    let open_scene = app.open_scene();
    let at = open_scene.at();
    assert!(at.is_finite(), "the driver is at {at}");
    assert!(
        open_scene.driver_range().clamp(at) == at,
        "{at} is out of reach"
    );
    match app.mode() {
        Mode::Tour(page) => assert!(page.screen < SCREENS),
        Mode::Assemblies(assemblies) => {
            let (cursor, (rows, _)) = (assemblies.list.cursor(), assemblies.list.count());
            assert!(cursor < rows, "assembly {cursor} of {rows}");
        }
        Mode::Help(help) => {
            let maximum = views::max_scroll(app);
            assert!(help.scroll <= maximum, "line {} of {maximum}", help.scroll);
        }
        Mode::AssemblyChoice(picker) => {
            let (matching, all) = picker.list.count();
            assert!(matching <= all);
            assert!(
                matching == 0 || picker.chosen().is_some(),
                "no entry under the cursor"
            );
        }
        // Typed text has no invariants beyond those of its type.
        _ => {}
    }
    let scrolls = matches!(
        app.view(),
        View::Accuracy
            | View::Lengths
            | View::Motion
            | View::Working
            | View::Motor
            | View::Polygons
    );
    if app.mode().is_normal() && scrolls {
        let maximum = views::max_scroll(app);
        assert!(
            app.views.scroll[app.view() as usize] <= maximum,
            "scrolled by {} of {maximum}",
            app.views.scroll[app.view() as usize]
        );
    }
    if app.view() == View::Scene {
        let values = app.editor().values().len();
        assert!(
            values == 0 || app.editor().value().is_some(),
            "no value under the cursor"
        );
    }
}

/// Checks that the terminal can show every byte of a frame.
fn check_bytes(frame: &[u8], glyphs: Glyphs, colours: Colours) {
    let text = std::str::from_utf8(frame).expect("frames are whole characters");
    let mut rest = text;
    while let Some(at) = rest.find('\u{1b}') {
        check_text(&rest[..at], glyphs, text);
        let sequence = rest[at + 1..]
            .strip_prefix('[')
            .expect("a control sequence");
        let end = sequence
            .find(|c: char| c.is_ascii_alphabetic())
            .expect("an end of it");
        if sequence[end..].starts_with('m') && colours == Colours::None {
            let coloured = |code: &str| {
                code.len() == 2 && code.starts_with(['3', '4', '9']) || code.starts_with("10")
            };
            assert!(
                !sequence[..end].split(';').any(coloured),
                "a colour in {sequence:?}"
            );
        }
        rest = &sequence[end + 1..];
    }
    check_text(rest, glyphs, text);
}

fn check_text(text: &str, glyphs: Glyphs, frame: &str) {
    let allowed = |c: char| match glyphs {
        _ if matches!(c, '\r' | '\n' | '\u{8}') => true,
        _ if is_harmful(c) => false,
        Glyphs::Ascii => c.is_ascii(),
        Glyphs::Line | Glyphs::Braille | Glyphs::Blocks(_) => true,
    };
    assert!(text.chars().all(allowed), "{text:?} in {frame:?}");
}

/// Feeds arbitrary bytes to the parser of terminal input and to the workbench behind it.
#[test]
fn fuzz_keys_in_separate_process() {
    caged("run_fuzz_child");
}

#[test]
#[ignore = "started by the test above, in a folder of its own"]
fn run_fuzz_child() {
    if std::env::var_os(CHILD_VARIABLE).is_none() {
        return;
    }
    let fuzz = Fuzz {
        name: "keys",
        seeds: &[],
        words: &SEQUENCES,
        runs: 40,
    };
    fuzz.run(|bytes| {
        let [first, second, rest @ ..] = bytes else {
            return 0;
        };
        typed(*first, *second, rest)
    });
}

/// Complete and partial sequences that terminals send.
const SEQUENCES: [&str; 40] = [
    "\u{1b}",
    "\u{1b}[",
    "\u{1b}O",
    "\u{1b}[A",
    "\u{1b}[B",
    "\u{1b}[C",
    "\u{1b}[D",
    "\u{1b}[H",
    "\u{1b}[F",
    "\u{1b}[5~",
    "\u{1b}[6~",
    "\u{1b}OP",
    "\u{1b}OQ",
    "\u{1b}[Z",
    "\u{1b}[0n",
    "\u{1b}[1;5C",
    "\u{1b}[200~",
    "\u{1b}[201~",
    "\u{1b}]52;c;",
    "\u{1b}P",
    "\u{7}",
    "\u{1b}\\",
    "\u{1b}[27u",
    "\u{1b}[99;5u",
    "\u{1b}[<0;1;1M",
    "\u{1b}[1;1R",
    "\r",
    "\t",
    "\u{7f}",
    "\u{0}",
    "g90\r",
    "2",
    "3",
    "6",
    "o",
    "/C\r",
    "?",
    "I",
    "a",
    " ",
];

/// Sends the bytes to a new workbench, and returns a hash of the outcome.
fn typed(first: u8, second: u8, bytes: &[u8]) -> u64 {
    let all = presets::all();
    let opened = opening::preset(&all[usize::from(first) % all.len()]).unwrap();
    let sizes = [(80, 24), (40, 12), (120, 40), (0, 0), (39, 12), (200, 60)];
    let (cols, rows) = sizes[usize::from(second) % sizes.len()];
    let workbench = Workbench::new(opened, Glyphs::Ascii, Colours::None, cols, rows);
    let mut workbench = workbench.timed_by(random_time);
    let mut keyboard = Keyboard::default();
    let mut outcome = DefaultHasher::new();
    if !send(bytes, &mut keyboard, &mut workbench) {
        return 1;
    }
    let frame = workbench.paint().to_vec();
    let app = workbench.app();
    check_bytes(&frame, app.glyphs(), app.colours());
    (app.view() as usize, std::mem::discriminant(app.mode())).hash(&mut outcome);
    app.message().map(shape).hash(&mut outcome);
    (
        app.open_scene().origin() == &Origin::Stdin,
        keyboard.deadline().is_some(),
    )
        .hash(&mut outcome);
    outcome.finish()
}
