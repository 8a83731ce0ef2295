//! What the mouse does on a whole screen.

use crate::Vec2;
use crate::capability::{Capability, Colours};
use crate::drawing::Glyphs;
use crate::scene::presets;
use crate::tui::app::View;
use crate::tui::commands::mouse::{Mouse, MouseDeed};
use crate::tui::document::opening;
use crate::tui::workbench::Workbench;
use ratatui::layout::{Position, Size};

const COLS: u16 = 80;
const ROWS: u16 = 24;

/// A preset on a usual screen, painted.
fn bench(preset: &str, keys: &str) -> Workbench {
    let opened = opening::preset(presets::find(preset).unwrap()).unwrap();
    let capability = Capability {
        glyphs: Glyphs::Braille,
        colours: Colours::Sixteen,
        modern: true,
    };
    let mut bench = Workbench::on(opened, None, capability, Size::new(COLS, ROWS));
    assert!(bench.press(keys));
    bench.paint();
    bench
}

fn point(bench: &mut Workbench, deed: MouseDeed, at: Position) {
    bench.point(Mouse { deed, at });
    bench.paint();
}

/// The cell of the drawing that shows a place of the scene, and half a cell's height there.
fn cell(bench: &Workbench, place: Vec2) -> (Position, f64) {
    let columns = (0..COLS).flat_map(|x| (0..ROWS).map(move |y| Position::new(x, y)));
    let seen = columns.filter_map(|at| Some((at, bench.place(at)?)));
    let away = |(seen, _): &(Vec2, f64)| (*seen - place).norm();
    let near = seen.min_by(|a, b| away(&a.1).total_cmp(&away(&b.1)));
    let (at, (_, column)) = near.unwrap();
    (at, 2.0 * column)
}

/// A row of the screen on which this is written.
fn row(bench: &mut Workbench, text: &str) -> u16 {
    let screen = bench.text();
    let row = screen.lines().position(|line| line.contains(text));
    u16::try_from(row.unwrap_or_else(|| panic!("no {text:?} in\n{screen}"))).unwrap()
}

#[test]
fn until_it_is_taken_the_mouse_is_the_terminals() {
    let mut bench = bench("four-bar", "");
    let before = bench.text();
    for deed in [MouseDeed::Press, MouseDeed::Drag, MouseDeed::WheelUp] {
        for (x, y) in [(12, 0), (20, 12), (60, 5)] {
            point(&mut bench, deed, Position::new(x, y));
        }
    }
    assert_eq!(bench.text(), before);
    assert!(!bench.app().has_mouse());
    bench.press("M");
    assert!(bench.app().has_mouse());
    bench.press("M");
    assert!(!bench.app().has_mouse());
}

#[test]
fn a_tab_is_clicked_and_a_row_and_a_value() {
    let mut bench = bench("four-bar", "M");
    let x = bench.text().find("2 Tables").unwrap();
    point(
        &mut bench,
        MouseDeed::Press,
        Position::new(u16::try_from(x).unwrap(), 0),
    );
    assert_eq!(bench.app().view(), View::Tables);
    let y = row(&mut bench, "r4  ");
    point(&mut bench, MouseDeed::Press, Position::new(8, y));
    assert_eq!(bench.app().cursor().row, 2);
    // The wheel goes on from there.
    point(&mut bench, MouseDeed::WheelUp, Position::new(8, y));
    assert_eq!(bench.app().cursor().row, 0);
    bench.press("6");
    let y = row(&mut bench, "r3 length");
    point(&mut bench, MouseDeed::Press, Position::new(8, y));
    assert_eq!(bench.app().editor().value().unwrap().name, "r3 length");
}

#[test]
fn the_crank_turns_with_the_mouse_and_stays_where_it_is_let_go() {
    let mut bench = bench("four-bar", "M");
    let of = |degrees: f64| crate::angle::unit(degrees) * 100.0;
    let (from, _) = cell(&bench, of(60.0));
    point(&mut bench, MouseDeed::Press, from);
    assert_eq!(bench.app().open_scene().at(), 60.0);
    // A turn and a half, as far as a hand goes between two reports; backwards is backwards.
    for degrees in [90.0, 140.0, 200.0, 270.0, 350.0, 380.0, 340.0] {
        let (to, size) = cell(&bench, of(degrees));
        point(&mut bench, MouseDeed::Drag, to);
        let at = bench.app().open_scene().at();
        let within = (2.0 * size / 100.0).to_degrees();
        assert!(
            (at - degrees).abs() < within,
            "{at} for {degrees}, {within}"
        );
    }
    let at = bench.app().open_scene().at();
    point(&mut bench, MouseDeed::Release, from);
    point(&mut bench, MouseDeed::Drag, from);
    assert_eq!(bench.app().open_scene().at(), at);
    // What is pushed goes along its guide.
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
    let (place, column) = boom.place(middle).unwrap();
    point(&mut boom, MouseDeed::Press, middle);
    let (to, _) = cell(&boom, place + guide * (3.0 * column));
    let moved = boom.place(to).unwrap().0 - place;
    point(&mut boom, MouseDeed::Drag, to);
    let went = boom.app().open_scene().at() - before;
    assert!((went - guide.dot(moved)).abs() < 1e-3, "{went} {moved:?}");
}

#[test]
fn the_wheel_makes_what_is_under_it_larger() {
    let mut bench = bench("four-bar", "M");
    let (at, size) = cell(&bench, Vec2::new(300.0, 200.0));
    let before = bench.place(at).unwrap();
    point(&mut bench, MouseDeed::WheelUp, at);
    let after = bench.place(at).unwrap();
    assert!(after.1 < 0.8 * before.1, "{after:?}");
    assert!(
        (after.0 - before.0).norm() < 3.0 * size,
        "{before:?} {after:?}"
    );
}

#[test]
fn a_pin_of_the_ground_is_drawn_elsewhere_and_one_undo_takes_it_back() {
    let mut bench = bench("four-bar", "M 6");
    let text = bench.app().open_scene().scene().text().to_owned();
    let (from, _) = cell(&bench, Vec2::new(400.0, 0.0));
    point(&mut bench, MouseDeed::Press, from);
    for x in [390.0, 380.0, 370.0] {
        let (to, _) = cell(&bench, Vec2::new(x, 0.0));
        point(&mut bench, MouseDeed::Drag, to);
    }
    point(&mut bench, MouseDeed::Release, from);
    let scene = bench.app().open_scene().scene().text().to_owned();
    assert!(scene != text && !scene.contains("D = [400, 0]"), "{scene}");
    bench.press("u");
    assert_eq!(bench.app().open_scene().scene().text(), text);
}

#[test]
fn a_plot_leads_the_driver() {
    let mut bench = bench("four-bar", "M 3");
    let y = row(&mut bench, "360");
    for x in [20, 60, 40] {
        let deed = if x == 20 {
            MouseDeed::Press
        } else {
            MouseDeed::Drag
        };
        point(&mut bench, deed, Position::new(x, y - 3));
        let at = bench.app().open_scene().at();
        // From 0 to 360 over all but the first columns.
        let share = f64::from(x - 5) / f64::from(COLS - 8) * 360.0;
        assert!((at - share).abs() < 12.0, "{at} {share}");
    }
}
