//! Tests dragging the free ends of links.

use super::*;

/// Drags the point at `from` by each of the given displacements in turn.
fn drag(workbench: &mut Workbench, from: Vec2, by: &[Vec2]) {
    let (at, _) = cell(workbench, from);
    point(workbench, MouseEventKind::Press, at);
    for &by in by {
        let (to, _) = cell(workbench, from + by);
        point(workbench, MouseEventKind::Drag, to);
    }
    point(workbench, MouseEventKind::Release, at);
}

/// Returns a point's position.
fn place_of(workbench: &mut Workbench, name: &str) -> Vec2 {
    let open_scene = workbench.app().open_scene();
    let scene = open_scene.scene();
    let mut ids = scene.mechanism.point_ids();
    let id = ids.find(|&id| scene.point_name(id) == Some(name)).unwrap();
    open_scene.state().position(id).unwrap()
}

/// The yoke's link is upright, the coupler of Hoecken's linkage is rotated, and the excavator's
/// coupler is given by its points alone. The edited values are in the link's frame, and the point
/// moves to the pointer.
#[test]
fn free_end_follows_pointer_at_any_link_angle() {
    for (preset, name, size) in [
        ("double-rocker", "P", 10.0),
        ("press-ram", "tool", 10.0),
        ("scotch-yoke", "R", 5.0),
        ("excavator-boom", "T", 0.1),
        ("jansen-leg", "T", 2.0),
    ] {
        let opened = opening::preset(presets::find(preset).unwrap()).unwrap();
        // Dragging does not depend on colours.
        let mut workbench = bench_of(
            opened,
            "M 6",
            Size::new(MAX_WIDTH, MAX_HEIGHT),
            Colours::None,
        );
        let text = workbench.app().open_scene().scene().text().to_owned();
        let from = place_of(&mut workbench, name);
        let at = workbench.app().open_scene().at();
        let by = [(1.0, 0.0), (2.0, 1.0), (4.0, -3.0)].map(|(x, y)| Vec2::new(x, y) * size);
        let (to, high) = cell(&workbench, from + by[2]);
        let guided = workbench.place(to).unwrap().position;
        drag(&mut workbench, from, &by);
        let off = (place_of(&mut workbench, name) - guided).norm();
        assert!(off < 0.5 * high, "{preset}: {off} of {high}");
        assert_eq!(workbench.app().open_scene().at(), at, "{preset}");
        // Only the line of this point changes.
        let after = workbench.app().open_scene().scene().text().to_owned();
        let changed = text.lines().zip(after.lines()).filter(|(a, b)| a != b);
        assert_eq!(changed.count(), 1, "{preset}: {after}");
        workbench.press("u");
        assert_eq!(
            workbench.app().open_scene().scene().text(),
            text,
            "{preset}"
        );
    }
}

/// P of Hoecken's linkage is on the coupler's own x axis: a drag along it changes nothing else.
#[test]
fn drag_edits_coordinates_in_link_frame() {
    let mut workbench = bench_on("hoecken", "M 6", Size::new(MAX_WIDTH, MAX_HEIGHT));
    let (from, other) = (place_of(&mut workbench, "P"), place_of(&mut workbench, "C"));
    let along = (from - other) / (from - other).norm();
    drag(&mut workbench, from, &[along * -40.0]);
    assert_eq!(workbench.app().editor().value().unwrap().name, "r3 P x");
    let editor = workbench.app().editor();
    let value = |name: &str| editor.named(name).unwrap().number;
    assert!((value("r3 P x") - 160.0).abs() < 3.0, "{}", value("r3 P x"));
    assert!(value("r3 P y").abs() < 3.0, "{}", value("r3 P y"));
    // The values are as round as those of the keys.
    assert_eq!(value("r3 P x") % 2.0, 0.0);
    assert_eq!(value("r3 length"), 100.0);
}

/// Each drag is a separate edit, even of the point with the cursor.
#[test]
fn each_drag_of_an_end_is_one_undo_step() {
    let mut workbench = bench_on("hoecken", "M 6", Size::new(MAX_WIDTH, MAX_HEIGHT));
    let text = |workbench: &mut Workbench| workbench.app().open_scene().scene().text().to_owned();
    let mut texts = vec![text(&mut workbench)];
    for _ in 0..2 {
        let from = place_of(&mut workbench, "P");
        drag(
            &mut workbench,
            from,
            &[Vec2::new(-10.0, 0.0), Vec2::new(-20.0, 9.0)],
        );
        texts.push(text(&mut workbench));
    }
    for expected in texts.iter().rev().skip(1) {
        workbench.press("u");
        assert_eq!(text(&mut workbench), *expected);
    }
}

/// The foot of Klann's leg is the far end of its link, which only the link's length can move.
#[test]
fn dragging_far_end_changes_only_link_length() {
    let mut workbench = bench_on("klann-leg", "M 6", Size::new(MAX_WIDTH, MAX_HEIGHT));
    let before = workbench.app().open_scene().scene().text().to_owned();
    let (from, hip) = (
        place_of(&mut workbench, "foot"),
        place_of(&mut workbench, "hip"),
    );
    let along = (from - hip) / (from - hip).norm();
    // The pointer is in the middle of a cell.
    let (_, high) = cell(&workbench, from);
    drag(&mut workbench, from, &[along * -30.0 + along.perp() * 12.0]);
    let length = workbench.app().editor().named("leg length").unwrap().number;
    let half = 0.5 * high.hypot(0.5 * high);
    assert!(
        (length - 143.2).abs() <= half,
        "{length}, half a cell {half}"
    );
    let knee = workbench.app().editor().named("leg knee x").unwrap().number;
    assert_eq!(knee, 86.6);
    // The end cannot pass the other end, and a message says so.
    let foot = place_of(&mut workbench, "foot");
    drag(&mut workbench, foot, &[along * -220.0]);
    let screen = workbench.text();
    assert!(screen.contains("leg length -"), "{screen}");
    workbench.press("u");
    assert_eq!(workbench.app().open_scene().scene().text(), before);
}

/// A point given by length and angle keeps this form, and follows the pointer.
#[test]
fn dragging_polar_point_changes_length_and_angle() {
    let text = presets::find("hoecken").unwrap().text;
    let seen = "P = { from = \"C\", length = 100, angle = 350 }";
    let text = text.replace("P = [200, 0]", seen);
    assert!(text.contains(seen));
    let opened = opening::text(&text, Origin::Stdin).unwrap();
    let size = Size::new(MAX_WIDTH, MAX_HEIGHT);
    let mut workbench = bench_of(opened, "M 6", size, Colours::Sixteen);
    let from = place_of(&mut workbench, "P");
    let by = [Vec2::new(-6.0, 9.0), Vec2::new(-12.0, 30.0)];
    let (to, high) = cell(&workbench, from + by[1]);
    let guided = workbench.place(to).unwrap().position;
    drag(&mut workbench, from, &by);
    let off = (place_of(&mut workbench, "P") - guided).norm();
    assert!(off < 0.5 * high + 1.0, "{off} of {high}");
    let editor = workbench.app().editor();
    let value = |name: &str| editor.named(name).unwrap().number;
    assert!((value("r3 P length") - 100.0).abs() > 3.0);
    // The angle stays near the old one, without a jump of a full turn.
    let angle = value("r3 P angle");
    assert!((300.0..410.0).contains(&angle) && angle != 350.0, "{angle}");
    workbench.press("u");
    assert_eq!(workbench.app().open_scene().scene().text(), text);
}

/// The origin of a link's frame cannot be dragged, because every point of the link would move with
/// it.
#[test]
fn dragging_link_origin_is_rejected_with_reason() {
    let text = presets::find("slotted-lever").unwrap().text;
    let text = text.replace("from = \"O\", to = \"T\"", "from = \"T\", to = \"O\"");
    let opened = opening::text(&text, Origin::Stdin).unwrap();
    let mut workbench = bench_of(opened, "M 6", Size::new(COLS, ROWS), Colours::Sixteen);
    let from = place_of(&mut workbench, "T");
    drag(&mut workbench, from, &[Vec2::new(20.0, 20.0)]);
    let screen = workbench.text();
    assert!(screen.contains("T is the origin of r4"), "{screen}");
    assert_eq!(workbench.app().open_scene().scene().text(), text);
    assert!(!workbench.app().is_changed());
}
