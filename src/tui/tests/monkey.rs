//! Tests the workbench with a random user, called the monkey. No action may cause a panic, an
//! invalid state, or output that the terminal cannot show.
//!
//! `cargo test` runs 6,000 actions, and `KRANK_MONKEY=1000000 cargo test --release monkey` a
//! million. A failure prints the seed of its episode; `KRANK_MONKEY_SEED` starts with that seed.
//! Because the monkey saves files, it runs in its own process, in an empty folder.

use crate::capability::{Capability, Colours};
use crate::drawing::Glyphs;
use crate::scene::{is_harmful, presets};
use crate::tests::{Chance, Fuzz, shape};
use crate::tui::app::{App, Effect, Mode, View};
use crate::tui::commands::key::Key;
use crate::tui::commands::keymap::Keymap;
use crate::tui::commands::mouse::{Mouse, MouseEventKind};
use crate::tui::document::opening;
use crate::tui::terminal::{Keyboard, TerminalInput};
use crate::tui::views::picker::list::PickerTarget;
use crate::tui::views::tour::screens::SCREENS;
use crate::tui::{Origin, Theme, Workbench, views};
use ratatui::layout::{Position, Size};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::panic::{self, AssertUnwindSafe};
use std::path::{Component, Path};
use std::process::Command;
use std::time::{Duration, Instant};

/// Maximum number of actions per workbench.
const EPISODE: usize = 400;
/// Number of actions by default.
const ORDINARY: usize = 6000;
/// The environment variable that marks the monkey's process.
const CAGE: &str = "KRANK_MONKEY_CAGE";

#[test]
fn monkey_actions_keep_workbench_valid() {
    caged("tui::tests::monkey::in_its_cage");
}

/// Runs another test in a separate process and folder.
#[allow(clippy::print_stdout, reason = "the figures are to be read")]
fn caged(test: &str) {
    let name = test.replace("::", "-");
    let cage = std::env::temp_dir().join(format!("krank-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&cage).unwrap();
    let done = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", test, "--ignored", "--nocapture"])
        .current_dir(&cage)
        .env(CAGE, "1")
        .env("HOME", &cage)
        .env("XDG_STATE_HOME", &cage)
        .env("XDG_CONFIG_HOME", &cage)
        .output()
        .unwrap();
    std::fs::remove_dir_all(&cage).unwrap();
    let told = String::from_utf8_lossy(&done.stdout);
    let why = String::from_utf8_lossy(&done.stderr);
    assert!(
        done.status.success() && told.contains("1 passed"),
        "{told}\n{why}"
    );
    for line in told.lines().filter(|line| line.contains(" s")) {
        println!("{line}");
    }
}

/// Does nothing if started directly, because it writes files to the current folder.
#[test]
#[ignore = "started by the test above, in a folder of its own"]
#[allow(clippy::print_stdout, reason = "the figures are to be read")]
fn in_its_cage() {
    if std::env::var_os(CAGE).is_none() {
        return;
    }
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse().ok());
    let wanted: usize = number("KRANK_MONKEY").unwrap_or(ORDINARY);
    let first = number("KRANK_MONKEY_SEED").unwrap_or(1);
    let begun = Instant::now();
    let mut actions = 0;
    for seed in (first as u64).. {
        if actions >= wanted {
            break;
        }
        actions += episode(seed);
    }
    let seconds = begun.elapsed().as_secs_f64();
    println!("{actions} actions of a monkey in {seconds:.1} s");
}

/// Runs one workbench from start to end, and returns the number of actions.
fn episode(seed: u64) -> usize {
    let mut done = Vec::new();
    let outcome = panic::catch_unwind(AssertUnwindSafe(|| live(&mut Chance::new(seed), &mut done)));
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
enum MonkeyDeed {
    Press(Key),
    /// Bytes from the terminal line: keys, parts of keys, and random bytes.
    Bytes(Vec<u8>),
    Paste(String),
    Resize(u16, u16),
    Pass(Duration),
    Mouse(Mouse),
}

fn live(chance: &mut Chance, done: &mut Vec<MonkeyDeed>) {
    let preset = chance.one_of(presets::all());
    let glyphs = *chance.one_of(&Glyphs::ALL);
    let colours = *chance.one_of(&[
        Colours::None,
        Colours::Sixteen,
        Colours::Indexed,
        Colours::True,
    ]);
    let theme = *chance.one_of(&[Theme::Auto, Theme::Light, Theme::Dark]);
    let capability = Capability {
        glyphs,
        colours,
        modern: chance.below(2) == 0,
    };
    let (cols, rows) = size(chance);
    let opened = opening::preset(preset).unwrap();
    let workbench = Workbench::on(opened, None, capability, Size::new(cols, rows));
    let mut workbench = workbench.themed(theme).timed_by(made_up);
    let mut keyboard = Keyboard::default();
    if chance.below(2) == 0 {
        workbench.press("M");
    }
    for _ in 0..EPISODE {
        let deed = deed(chance, workbench.app());
        done.push(deed);
        let deed = done.last().unwrap();
        match deed {
            MonkeyDeed::Press(key) => {
                if workbench.key(*key) == Effect::Quit {
                    return;
                }
            }
            MonkeyDeed::Bytes(bytes) => {
                if !send(bytes, &mut keyboard, &mut workbench) {
                    return;
                }
            }
            MonkeyDeed::Paste(text) => workbench.app().paste(text),
            MonkeyDeed::Resize(cols, rows) => workbench.resize(*cols, *rows),
            MonkeyDeed::Pass(time) => workbench.pass(*time),
            MonkeyDeed::Mouse(mouse) => {
                if workbench.point(*mouse) == Effect::Quit {
                    return;
                }
            }
        }
        check(workbench.app());
        if chance.below(3) == 0 {
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
                TerminalInput::Key(key) if stays(workbench.app(), &MonkeyDeed::Press(key)) => {
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
                TerminalInput::Key(_) | TerminalInput::Answer | TerminalInput::Ground(_) => {}
            }
            check(workbench.app());
        }
    }
    true
}

fn made_up() -> Duration {
    thread_local!(static NOW: std::cell::Cell<Duration> = const { std::cell::Cell::new(Duration::ZERO) });
    NOW.set(NOW.get() + Duration::from_millis(5));
    NOW.get()
}

fn size(chance: &mut Chance) -> (u16, u16) {
    match chance.below(10) {
        0 => *chance.one_of(&[(0, 0), (1, 1), (39, 12), (40, 11), (0, 50), (500, 1)]),
        1 | 2 => (40, 12),
        3..=6 => (80, 24),
        _ => (chance.small(160), chance.small(60)),
    }
}

fn deed(chance: &mut Chance, app: &App) -> MonkeyDeed {
    let deed = match chance.below(100) {
        0..55 => MonkeyDeed::Press(by_the_table(chance)),
        55..70 => MonkeyDeed::Press(*chance.one_of(&LEADING)),
        70..78 => MonkeyDeed::Press(Key::Char(char::from(b' ' + chance.small(95) as u8))),
        78..84 => MonkeyDeed::Mouse(by_hand(chance, app)),
        84..86 => MonkeyDeed::Press(*chance.one_of(&ODD)),
        86 => MonkeyDeed::Bytes(noise(chance)),
        87 => MonkeyDeed::Paste(
            (0..chance.below(40))
                .map(|_| *chance.one_of(&PASTED))
                .collect(),
        ),
        88..91 => {
            let (cols, rows) = size(chance);
            MonkeyDeed::Resize(cols, rows)
        }
        91..99 => MonkeyDeed::Pass(Duration::from_millis(chance.below(200) as u64)),
        _ => MonkeyDeed::Pass(Duration::from_secs(chance.below(100_000) as u64)),
    };
    if stays(app, &deed) {
        deed
    } else {
        MonkeyDeed::Press(Key::Escape)
    }
}

/// Returns a random mouse event, sometimes beyond the edge of the screen.
fn by_hand(chance: &mut Chance, app: &App) -> Mouse {
    let deeds = [
        MouseEventKind::Press,
        MouseEventKind::Drag,
        MouseEventKind::Drag,
        MouseEventKind::Release,
        MouseEventKind::WheelUp,
        MouseEventKind::WheelDown,
    ];
    let within = |chance: &mut Chance, most: u16| chance.below(usize::from(most) + 2) as u16;
    let size = app.size();
    Mouse {
        deed: *chance.one_of(&deeds),
        at: Position::new(within(chance, size.width), within(chance, size.height)),
    }
}

/// Returns random bytes as from a bad line, without keys that quit, because quitting ends the
/// episode.
fn noise(chance: &mut Chance) -> Vec<u8> {
    let mut bytes = Vec::new();
    for _ in 0..chance.below(12) {
        match chance.below(3) {
            0 => bytes.push(chance.below(256) as u8),
            _ => bytes.extend_from_slice(chance.one_of(&SEQUENCES).as_bytes()),
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

fn by_the_table(chance: &mut Chance) -> Key {
    let keymap = Keymap::default();
    let rows: Vec<&[Key]> = keymap.rows().map(|(_, keys)| keys).collect();
    let keys = *chance.one_of(&rows);
    let key = *chance.one_of(keys);
    // Quitting ends the episode, so it is rare.
    if matches!(key, Key::Char('q') | Key::Ctrl('c')) && chance.below(20) > 0 {
        return Key::Char(' ');
    }
    key
}

/// Returns `true` if the action reads and writes only within the monkey's folder.
fn stays(app: &App, deed: &MonkeyDeed) -> bool {
    match (app.mode(), deed) {
        (Mode::FileName(_), MonkeyDeed::Press(Key::Char(c))) => !matches!(c, '/' | '~' | '.'),
        (Mode::FileName(prompt), MonkeyDeed::Press(Key::Enter)) => {
            is_in_cage(Path::new(prompt.name.text().trim()))
        }
        (Mode::Confirm(question), MonkeyDeed::Press(Key::Enter)) => is_in_cage(&question.to),
        (Mode::Pick(_), MonkeyDeed::Press(Key::Left)) => false,
        (Mode::Pick(picker), MonkeyDeed::Press(Key::Enter | Key::Right)) => {
            match picker.chosen().map(|item| &item.place) {
                Some(PickerTarget::Folder(path) | PickerTarget::File(path)) => is_in_cage(path),
                Some(
                    PickerTarget::Original | PickerTarget::Candidates | PickerTarget::Preset(_),
                )
                | None => true,
            }
        }
        _ => match app.open_scene().origin() {
            Origin::File(path) => is_in_cage(path),
            Origin::Preset(_) | Origin::New(_) | Origin::Stdin => true,
        },
    }
}

fn is_in_cage(path: &Path) -> bool {
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
        Mode::Tour(number) => assert!(*number < SCREENS),
        Mode::Assemblies(assemblies) => {
            let (cursor, (rows, _)) = (assemblies.list.cursor(), assemblies.list.count());
            assert!(cursor < rows, "assembly {cursor} of {rows}");
        }
        Mode::Help(help) => {
            let most = views::most_scroll(app);
            assert!(help.scroll <= most, "line {} of {most}", help.scroll);
        }
        Mode::Pick(picker) => {
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
        View::Accuracy | View::Lengths | View::Motion | View::Working | View::Motor
    );
    if app.mode().is_normal() && scrolls {
        let most = views::most_scroll(app);
        assert!(
            app.views.scroll[app.view() as usize] <= most,
            "scrolled by {} of {most}",
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
    caged("tui::tests::monkey::fuzz_the_keys");
}

#[test]
#[ignore = "started by the test above, in a folder of its own"]
fn fuzz_the_keys() {
    if std::env::var_os(CAGE).is_none() {
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
    let mut workbench = workbench.timed_by(made_up);
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
