//! Tests mouse input on a whole screen.

mod ends;

use crate::Vec2;
use crate::capability::{Capability, Colours};
use crate::drawing::Glyphs;
use crate::scene::presets;
use crate::tui::app::{Effect, Mode, View};
use crate::tui::commands::mouse::{Mouse, MouseEventKind};
use crate::tui::config::Config;
use crate::tui::document::opening;
use crate::tui::views::DrawnPlace;
use crate::tui::workbench::Workbench;
use crate::tui::{OpenedScene, Origin};
use crate::wording::Language;
use ratatui::layout::{Position, Size};

const COLS: u16 = 80;
const ROWS: u16 = 24;
/// The largest screen in these tests.
const MAX_WIDTH: u16 = 120;
const MAX_HEIGHT: u16 = 40;

/// Opens a preset on a screen of 80 by 24 cells, presses keys, and paints it.
fn bench(preset: &str, keys: &str) -> Workbench {
    bench_on(preset, keys, Size::new(COLS, ROWS))
}

fn bench_on(preset: &str, keys: &str, size: Size) -> Workbench {
    let opened = opening::preset(presets::find(preset).unwrap()).unwrap();
    bench_of(opened, keys, size, Colours::Sixteen)
}

fn bench_of(opened: OpenedScene, keys: &str, size: Size, colours: Colours) -> Workbench {
    let capability = Capability {
        glyphs: Glyphs::Braille,
        colours,
        modern: true,
    };
    let mut workbench = Workbench::on(opened, None, capability, size);
    assert!(workbench.press(keys));
    workbench.paint();
    workbench
}

fn point(workbench: &mut Workbench, action: MouseEventKind, at: Position) {
    assert_eq!(workbench.point(Mouse { kind: action, at }), Effect::Show);
    workbench.paint();
}

/// Returns the cell of the drawing nearest to a position in the scene, and the cell's height there.
fn cell(workbench: &Workbench, position: Vec2) -> (Position, f64) {
    let columns = (0..MAX_WIDTH).flat_map(|x| (0..MAX_HEIGHT).map(move |y| Position::new(x, y)));
    let seen = columns.filter_map(|at| Some((at, workbench.place(at)?)));
    let away = |seen: &DrawnPlace| (seen.position - position).norm();
    let near = seen.min_by(|a, b| away(&a.1).total_cmp(&away(&b.1)));
    let (at, seen) = near.unwrap();
    (at, 2.0 * seen.column)
}

/// Returns the first row of the screen that contains a text.
fn row(workbench: &mut Workbench, text: &str) -> u16 {
    let screen = workbench.text();
    let row = screen.lines().position(|line| line.contains(text));
    u16::try_from(row.unwrap_or_else(|| panic!("no {text:?} in\n{screen}"))).unwrap()
}

#[test]
fn mouse_is_ignored_until_enabled() {
    let mut workbench = bench("four-bar", "");
    let before = workbench.text();
    for action in [
        MouseEventKind::Press,
        MouseEventKind::Drag,
        MouseEventKind::WheelUp,
    ] {
        for (x, y) in [(12, 0), (20, 12), (60, 5)] {
            point(&mut workbench, action, Position::new(x, y));
        }
    }
    assert_eq!(workbench.text(), before);
    assert!(!workbench.app().has_mouse());
    workbench.press("M");
    assert!(workbench.app().has_mouse());
    workbench.press("M");
    assert!(!workbench.app().has_mouse());
}

#[test]
fn clicks_select_tab_row_and_value() {
    let mut workbench = bench("four-bar", "M");
    let x = workbench.text().find("2 Tables").unwrap();
    point(
        &mut workbench,
        MouseEventKind::Press,
        Position::new(u16::try_from(x).unwrap(), 0),
    );
    assert_eq!(workbench.app().view(), View::Tables);
    let y = row(&mut workbench, "r4  ");
    point(&mut workbench, MouseEventKind::Press, Position::new(8, y));
    assert_eq!(workbench.app().views.cursor.row, 2);
    // The wheel continues from that row.
    point(&mut workbench, MouseEventKind::WheelUp, Position::new(8, y));
    assert_eq!(workbench.app().views.cursor.row, 0);
    workbench.press("6");
    let y = row(&mut workbench, "r3 length");
    point(&mut workbench, MouseEventKind::Press, Position::new(8, y));
    assert_eq!(workbench.app().editor().value().unwrap().name, "r3 length");
    // A second click edits it.
    let last = |workbench: &mut Workbench| workbench.text().lines().last().unwrap().to_owned();
    assert!(!last(&mut workbench).contains("r3 length"));
    point(&mut workbench, MouseEventKind::Press, Position::new(8, y));
    assert!(last(&mut workbench).contains("r3 length"));
}

/// A click on a hint is its key: in the first line, in the status line and in a prompt.
#[test]
fn clicks_on_hints_press_their_keys() {
    let mut workbench = bench_on("four-bar", "M Esc", Size::new(120, 40));
    let at = |workbench: &mut Workbench, text: &str| {
        let y = row(workbench, text);
        let screen = workbench.text();
        let line = screen.lines().nth(y.into()).unwrap();
        let bytes = line.find(text).unwrap();
        Position::new(u16::try_from(line[..bytes].chars().count()).unwrap(), y)
    };
    let click = |workbench: &mut Workbench, text: &str| {
        let at = at(workbench, text);
        point(workbench, MouseEventKind::Press, at);
    };
    click(&mut workbench, "space play");
    assert!(workbench.app().playback().is_playing());
    click(&mut workbench, "pause");
    assert!(!workbench.app().playback().is_playing());
    click(&mut workbench, ": commands");
    assert!(matches!(workbench.app().mode(), Mode::Palette(_)));
    workbench.press("Esc g");
    workbench.paint();
    click(&mut workbench, "Esc");
    assert!(workbench.app().mode().is_normal());
    click(&mut workbench, "? help");
    assert!(matches!(workbench.app().mode(), Mode::Help(_)));
}

#[test]
fn dragging_moves_driver_until_release() {
    let mut workbench = bench("four-bar", "M");
    let of = |degrees: f64| crate::angle::unit(degrees) * 100.0;
    let (from, _) = cell(&workbench, of(60.0));
    point(&mut workbench, MouseEventKind::Press, from);
    assert_eq!(workbench.app().open_scene().at(), 60.0);
    // Nearly a full turn, in steps as large as between two mouse reports. Dragging backwards turns
    // backwards.
    for degrees in [90.0, 140.0, 200.0, 270.0, 350.0, 380.0, 340.0] {
        let (to, size) = cell(&workbench, of(degrees));
        point(&mut workbench, MouseEventKind::Drag, to);
        let at = workbench.app().open_scene().at();
        let within = (2.0 * size / 100.0).to_degrees();
        assert!(
            (at - degrees).abs() < within,
            "{at} for {degrees}, {within}"
        );
    }
    let at = workbench.app().open_scene().at();
    point(&mut workbench, MouseEventKind::Release, from);
    point(&mut workbench, MouseEventKind::Drag, from);
    assert_eq!(workbench.app().open_scene().at(), at);
    // A slide moves along its guide.
    let mut boom = self::bench("excavator-boom", "M");
    let before = boom.app().open_scene().at();
    let slide = boom
        .app()
        .open_scene()
        .scene()
        .mechanism
        .slide_ids()
        .next()
        .unwrap();
    let guide = boom.app().open_scene().state().travel(slide).unwrap().guide;
    let middle = Position::new(20, 10);
    let DrawnPlace {
        position, column, ..
    } = boom.place(middle).unwrap();
    point(&mut boom, MouseEventKind::Press, middle);
    let (to, _) = cell(&boom, position + guide * (3.0 * column));
    let moved = boom.place(to).unwrap().position - position;
    point(&mut boom, MouseEventKind::Drag, to);
    let went = boom.app().open_scene().at() - before;
    assert!((went - guide.dot(moved)).abs() < 1e-3, "{went} {moved:?}");
}

#[test]
fn wheel_zooms_in_at_pointer() {
    let mut workbench = bench("four-bar", "M");
    let (at, size) = cell(&workbench, Vec2::new(300.0, 200.0));
    let before = workbench.place(at).unwrap();
    point(&mut workbench, MouseEventKind::WheelUp, at);
    let after = workbench.place(at).unwrap();
    assert!(after.column < 0.8 * before.column, "{after:?}");
    assert!(
        (after.position - before.position).norm() < 3.0 * size,
        "{before:?} {after:?}"
    );
}

#[test]
fn dragging_ground_pin_is_one_undo_step() {
    let mut workbench = bench("four-bar", "M 6");
    let text = workbench.app().open_scene().scene().text().to_owned();
    let (from, _) = cell(&workbench, Vec2::new(400.0, 0.0));
    point(&mut workbench, MouseEventKind::Press, from);
    for x in [390.0, 380.0, 370.0] {
        let (to, _) = cell(&workbench, Vec2::new(x, 0.0));
        point(&mut workbench, MouseEventKind::Drag, to);
    }
    point(&mut workbench, MouseEventKind::Release, from);
    let scene = workbench.app().open_scene().scene().text().to_owned();
    assert!(scene != text && !scene.contains("D = [400, 0]"), "{scene}");
    workbench.press("u");
    assert_eq!(workbench.app().open_scene().scene().text(), text);
}

/// Each place of the mouse stores a multiple of the step, without binary rounding.
#[test]
fn dragged_pin_has_decimals_of_its_step() {
    let text = presets::find("four-bar").unwrap().text;
    let text = text.replace("D = [400, 0]", "D = [400.3, -0.7]");
    let opened = opening::text(&text, Origin::New("pin".into())).unwrap();
    let mut workbench = bench_of(opened, "M 6", Size::new(120, 40), Colours::Sixteen);
    let (from, _) = cell(&workbench, Vec2::new(400.3, -0.7));
    point(&mut workbench, MouseEventKind::Press, from);
    workbench.press("{ { { { {");
    point(&mut workbench, MouseEventKind::Press, from);
    let step = workbench.app().editor().notch().size();
    assert!((0.01..0.1).contains(&step), "{step}");
    for right in 1..=12 {
        let to = Position::new(from.x + right % 4, from.y - right);
        point(&mut workbench, MouseEventKind::Drag, to);
        for name in ["D x", "D y"] {
            let text = workbench.app().editor().named(name).unwrap().text();
            let decimals = text
                .split_once('.')
                .map_or(0, |(_, decimals)| decimals.len());
            assert!(decimals <= 2, "{name} = {text}");
        }
    }
    assert_ne!(workbench.app().open_scene().scene().text(), text);
}

/// The viewport stays fixed under the pointer, although each step extends the scene.
#[test]
fn dragged_pin_stays_under_pointer() {
    let mut workbench = bench("four-bar", "M 6");
    let (from, near) = cell(&workbench, Vec2::new(400.0, 0.0));
    point(&mut workbench, MouseEventKind::Press, from);
    for right in 1..=3 {
        let to = Position::new(from.x + right, from.y);
        let wanted = workbench.place(to).unwrap().position;
        point(&mut workbench, MouseEventKind::Drag, to);
        let mechanism = &workbench.app().open_scene().scene().mechanism;
        let mut pins = mechanism.points().iter().filter_map(|point| point.ground);
        assert!(pins.any(|pin| (pin - wanted).norm() < near), "{right}");
        let seen = workbench.place(to).unwrap().position;
        assert!((seen - wanted).norm() < 1e-9, "{right}");
    }
}

/// An overlay opened during a drag ends the drag.
#[test]
fn release_during_help_ends_drag() {
    let mut workbench = bench("four-bar", "M");
    let (from, _) = cell(&workbench, Vec2::new(50.0, 86.0));
    point(&mut workbench, MouseEventKind::Press, from);
    workbench.press("?");
    point(&mut workbench, MouseEventKind::Release, from);
    workbench.press("Esc");
    workbench.paint();
    let at = workbench.app().open_scene().at();
    let (to, _) = cell(&workbench, Vec2::new(-50.0, 86.0));
    point(&mut workbench, MouseEventKind::Drag, to);
    assert_eq!(workbench.app().open_scene().at(), at);
}

#[test]
fn dragging_in_plot_moves_driver() {
    let mut workbench = bench("four-bar", "M 3");
    let y = row(&mut workbench, "360");
    for x in [20, 60, 40] {
        let action = if x == 20 {
            MouseEventKind::Press
        } else {
            MouseEventKind::Drag
        };
        point(&mut workbench, action, Position::new(x, y - 3));
        let at = workbench.app().open_scene().at();
        // The x axis goes from 0 to 360 over all columns but the first.
        let share = f64::from(x - 5) / f64::from(COLS - 8) * 360.0;
        assert!((at - share).abs() < 12.0, "{at} {share}");
    }
}

/// The viewport follows B, so every cell shows another position after each step. The driver must
/// stay stable while the pointer rests.
#[test]
fn crank_drag_is_stable_in_following_viewport() {
    for keys in ["M s", "M F", "M"] {
        let mut workbench = bench("four-bar", keys);
        let (from, _) = cell(&workbench, Vec2::new(50.0, 86.6));
        point(&mut workbench, MouseEventKind::Press, from);
        let to = Position::new(from.x.saturating_sub(4), from.y);
        point(&mut workbench, MouseEventKind::Drag, to);
        let moved = workbench.app().open_scene().at();
        assert!((60.0..110.0).contains(&moved), "{keys}: {moved}");
        let mut last = moved;
        for _ in 0..20 {
            point(&mut workbench, MouseEventKind::Drag, to);
            let at = workbench.app().open_scene().at();
            assert!((at - last).abs() < 10.0, "{keys}: {last} {at}");
            last = at;
        }
        assert!((last - moved).abs() < 20.0, "{keys}: {moved} {last}");
    }
}

/// In the scene view, ground pins can be dragged in the drawing next to it.
#[test]
fn ground_pins_can_be_dragged_next_to_scene_pane() {
    let mut workbench = bench_on("four-bar", "M 6", Size::new(120, 40));
    let (from, _) = cell(&workbench, Vec2::new(400.0, 0.0));
    point(&mut workbench, MouseEventKind::Press, from);
    let (to, _) = cell(&workbench, Vec2::new(380.0, 30.0));
    point(&mut workbench, MouseEventKind::Drag, to);
    let scene = workbench.app().open_scene().scene().text().to_owned();
    assert!(!scene.contains("D = [400, 0]"), "{scene}");
    assert_eq!(workbench.app().view(), View::Scene);
    assert_eq!(workbench.app().open_scene().at(), 60.0);
    // Both coordinates change in one edit.
    workbench.press("u");
    assert!(
        workbench
            .app()
            .open_scene()
            .scene()
            .text()
            .contains("D = [400, 0]")
    );
    // In any other view, the same drag turns the crank.
    let mut workbench = bench_on("four-bar", "M Esc", Size::new(120, 40));
    let (from, _) = cell(&workbench, Vec2::new(400.0, 0.0));
    point(&mut workbench, MouseEventKind::Press, from);
    let (to, _) = cell(&workbench, Vec2::new(300.0, 150.0));
    point(&mut workbench, MouseEventKind::Drag, to);
    assert_ne!(workbench.app().open_scene().at(), 60.0);
    assert!(!workbench.app().is_changed());
}

/// A pin of a copy has no coordinates in the file; the message names the original.
#[test]
fn dragging_a_copied_pin_is_refused() {
    Language::English.speak();
    let preset = presets::find("four-bar").unwrap();
    let copy = "[copies]\nb = { of = [\"r3\", \"r4\"], move = [0, -60] }\n";
    // The copy shares the moving B: its assembly does not follow from the original's.
    let original = preset
        .text
        .replace("[start]\n", "[start]\nC_b = [310, 170]\n");
    let text = format!("{original}\n{copy}");
    let opened = opening::text(&text, Origin::New("copied".into())).unwrap();
    let mut workbench = bench_of(opened, "M 6", Size::new(120, 40), Colours::Sixteen);
    let (from, _) = cell(&workbench, Vec2::new(400.0, -60.0));
    point(&mut workbench, MouseEventKind::Press, from);
    let message = workbench.app().message();
    assert_eq!(message, Some("D_b is a copy; change D instead"));
    let (to, _) = cell(&workbench, Vec2::new(380.0, -30.0));
    workbench.point(Mouse {
        kind: MouseEventKind::Drag,
        at: to,
    });
    assert_eq!(workbench.app().open_scene().scene().text(), text);
    // The values of the copy itself can be edited.
    let values = workbench.app().open_scene().scene().values();
    let own = values.iter().filter(|value| value.name.starts_with("b "));
    let own: Vec<&str> = own.map(|value| value.name.as_str()).collect();
    assert_eq!(own, ["b move x", "b move y"]);
}

/// Until the release, the verdict compares with the start of the drag.
#[test]
fn verdict_during_drag_compares_with_its_start() {
    let mut workbench = bench("four-bar", "M 6");
    let (from, _) = cell(&workbench, Vec2::new(400.0, 0.0));
    point(&mut workbench, MouseEventKind::Press, from);
    for x in [410.0, 430.0, 456.0, 462.0, 460.0] {
        let (to, _) = cell(&workbench, Vec2::new(x, 0.0));
        point(&mut workbench, MouseEventKind::Drag, to);
    }
    let screen = workbench.text();
    assert!(screen.contains("crank-rocker -> "), "{screen}");
}

#[test]
fn dragging_stops_playback() {
    let mut workbench = bench("four-bar", "M 3 space");
    let y = row(&mut workbench, "360");
    point(
        &mut workbench,
        MouseEventKind::Press,
        Position::new(40, y - 3),
    );
    assert!(!workbench.app().playback().is_playing());
}

#[test]
fn wheel_scrolls_lists_if_arrows_are_rebound() {
    let text = "[keys]\nup = \"k\"\nscroll = \"j\"\nfaster = \"Up\"\nslower = \"Down\"\n";
    let config = Config::parse(text, "config.toml").unwrap();
    let mut workbench = bench("four-bar", "").configured(&config);
    workbench.press("M 2");
    workbench.paint();
    let y = row(&mut workbench, "r4  ");
    point(
        &mut workbench,
        MouseEventKind::WheelDown,
        Position::new(8, y),
    );
    assert_ne!(workbench.app().views.cursor.row, 0);
}

/// A drag ends when another scene is opened. The drawing needs a wide screen next to the names of
/// these values.
#[test]
fn opening_another_scene_ends_pin_drag() {
    let mut workbench = bench_on("jansen-leg", "M 6", Size::new(MAX_WIDTH, MAX_HEIGHT));
    let ground = workbench.app().open_scene().scene();
    let ids = ground.mechanism.point_ids();
    let pins: Vec<Vec2> = ids
        .filter_map(|id| ground.mechanism.point(id).ground)
        .collect();
    let (from, _) = cell(&workbench, pins[1]);
    point(&mut workbench, MouseEventKind::Press, from);
    workbench.press("n");
    workbench.paint();
    point(&mut workbench, MouseEventKind::Drag, Position::new(30, 10));
    assert!(!workbench.app().is_changed());
}

/// Zooming keeps the position under the pointer, also in a following viewport and after panning.
/// The zoomed viewport then stays fixed while the crank turns.
#[test]
fn zoomed_view_keeps_place_under_pointer() {
    for (preset, size) in [
        ("drag-link", Size::new(120, 24)),
        ("hoecken", Size::new(80, 24)),
        ("four-bar", Size::new(80, 24)),
    ] {
        let mut workbench = bench_on(preset, "M", size);
        let (at, _) = cell(&workbench, Vec2::ZERO);
        let before = workbench.place(at).unwrap();
        for _ in 0..4 {
            point(&mut workbench, MouseEventKind::WheelUp, at);
            let after = workbench.place(at).unwrap();
            let off = (after.position - before.position).norm() / after.column;
            assert!(off < 4.0, "{preset}: {off} columns");
        }
        let before = workbench.place(at).unwrap();
        for _ in 0..10 {
            workbench.press(".");
            workbench.paint();
            assert_eq!(workbench.place(at).unwrap(), before, "{preset}");
        }
        // After fitting, the viewport follows again.
        workbench.press("f");
        assert!(workbench.app().views.viewport.lens.fits(), "{preset}");
    }
}
