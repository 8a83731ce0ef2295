//! Free ends of links, led by the hand.

use super::*;

/// Drags a point by the hand from where it stands.
fn drag(bench: &mut Workbench, from: Vec2, by: &[Vec2]) {
    let (at, _) = cell(bench, from);
    point(bench, MouseDeed::Press, at);
    for &by in by {
        let (to, _) = cell(bench, from + by);
        point(bench, MouseDeed::Drag, to);
    }
    point(bench, MouseDeed::Release, at);
}

/// Where a point stands.
fn place_of(bench: &mut Workbench, name: &str) -> Vec2 {
    let open_scene = bench.app().open_scene();
    let scene = open_scene.scene();
    let mut ids = scene.mechanism.point_ids();
    let id = ids.find(|&id| scene.point_name(id) == Some(name)).unwrap();
    open_scene.state().position(id).unwrap()
}

/// The yoke stands upright with its link, the coupler of Hoecken's linkage stands turned, and that of the excavator is
/// given by its points alone: what is typed is in the link's frame, and the point goes to where the hand is.
#[test]
fn a_free_end_goes_where_it_is_led_whichever_way_its_link_is_turned() {
    for (preset, name, size) in [
        ("double-rocker", "P", 10.0),
        ("press-ram", "tool", 10.0),
        ("scotch-yoke", "R", 5.0),
        ("excavator-boom", "T", 0.1),
        ("jansen-leg", "T", 2.0),
    ] {
        let opened = opening::preset(presets::find(preset).unwrap()).unwrap();
        // Without colours as with them.
        let mut bench = bench_of(opened, "M 6", Size::new(WIDEST, HIGHEST), Colours::None);
        let text = bench.app().open_scene().scene().text().to_owned();
        let from = place_of(&mut bench, name);
        let at = bench.app().open_scene().at();
        let by = [(1.0, 0.0), (2.0, 1.0), (4.0, -3.0)].map(|(x, y)| Vec2::new(x, y) * size);
        let (to, high) = cell(&bench, from + by[2]);
        let led = bench.place(to).unwrap().place;
        drag(&mut bench, from, &by);
        let off = (place_of(&mut bench, name) - led).norm();
        assert!(off < 0.5 * high, "{preset}: {off} of {high}");
        assert_eq!(bench.app().open_scene().at(), at, "{preset}");
        // Only numbers of this point are others.
        let after = bench.app().open_scene().scene().text().to_owned();
        let changed = text.lines().zip(after.lines()).filter(|(a, b)| a != b);
        assert_eq!(changed.count(), 1, "{preset}: {after}");
        bench.press("u");
        assert_eq!(bench.app().open_scene().scene().text(), text, "{preset}");
    }
}

/// P of Hoecken's linkage is where the coupler's own x axis goes on: along it nothing else is changed.
#[test]
fn what_is_typed_is_counted_along_the_links_own_axes() {
    let mut bench = bench_on("hoecken", "M 6", Size::new(WIDEST, HIGHEST));
    let (from, other) = (place_of(&mut bench, "P"), place_of(&mut bench, "C"));
    let along = (from - other) / (from - other).norm();
    drag(&mut bench, from, &[along * -40.0]);
    assert_eq!(bench.app().editor().value().unwrap().name, "r3 P x");
    let editor = bench.app().editor();
    let value = |name: &str| editor.named(name).unwrap().number;
    assert!((value("r3 P x") - 160.0).abs() < 3.0, "{}", value("r3 P x"));
    assert!(value("r3 P y").abs() < 3.0, "{}", value("r3 P y"));
    // Numbers as round as the keys make them.
    assert_eq!(value("r3 P x") % 2.0, 0.0);
    assert_eq!(value("r3 length"), 100.0);
}

/// Each drag is an edit of its own, also of the point on which the cursor stood before.
#[test]
fn the_same_end_is_led_twice_and_taken_back_twice() {
    let mut bench = bench_on("hoecken", "M 6", Size::new(WIDEST, HIGHEST));
    let text = |bench: &mut Workbench| bench.app().open_scene().scene().text().to_owned();
    let mut texts = vec![text(&mut bench)];
    for _ in 0..2 {
        let from = place_of(&mut bench, "P");
        drag(
            &mut bench,
            from,
            &[Vec2::new(-10.0, 0.0), Vec2::new(-20.0, 9.0)],
        );
        texts.push(text(&mut bench));
    }
    for expected in texts.iter().rev().skip(1) {
        bench.press("u");
        assert_eq!(text(&mut bench), *expected);
    }
}

/// The foot of Klann's leg is where its link ends: only how long that is can be typed.
#[test]
fn the_end_that_a_link_runs_to_goes_by_its_length() {
    let mut bench = bench_on("klann-leg", "M 6", Size::new(WIDEST, HIGHEST));
    let before = bench.app().open_scene().scene().text().to_owned();
    let (from, hip) = (place_of(&mut bench, "foot"), place_of(&mut bench, "hip"));
    let along = (from - hip) / (from - hip).norm();
    drag(&mut bench, from, &[along * -30.0 + along.perp() * 12.0]);
    let length = bench.app().editor().named("leg length").unwrap().number;
    assert!((length - 143.2).abs() < 3.0, "{length}");
    let knee = bench.app().editor().named("leg knee x").unwrap().number;
    assert_eq!(knee, 86.6);
    // Through the other end it cannot go, and says so.
    let foot = place_of(&mut bench, "foot");
    drag(&mut bench, foot, &[along * -220.0]);
    let screen = bench.text();
    assert!(screen.contains("leg length -"), "{screen}");
    bench.press("u");
    assert_eq!(bench.app().open_scene().scene().text(), before);
}

/// What was typed by length and angle goes by these, and stays where the hand is.
#[test]
fn an_end_by_length_and_angle_goes_by_these() {
    let text = presets::find("hoecken").unwrap().text;
    let seen = "P = { from = \"C\", length = 100, angle = 350 }";
    let text = text.replace("P = [200, 0]", seen);
    assert!(text.contains(seen));
    let opened = opening::text(&text, Origin::Stdin).unwrap();
    let size = Size::new(WIDEST, HIGHEST);
    let mut bench = bench_of(opened, "M 6", size, Colours::Sixteen);
    let from = place_of(&mut bench, "P");
    let by = [Vec2::new(-6.0, 9.0), Vec2::new(-12.0, 30.0)];
    let (to, high) = cell(&bench, from + by[1]);
    let led = bench.place(to).unwrap().place;
    drag(&mut bench, from, &by);
    let off = (place_of(&mut bench, "P") - led).norm();
    assert!(off < 0.5 * high + 1.0, "{off} of {high}");
    let editor = bench.app().editor();
    let value = |name: &str| editor.named(name).unwrap().number;
    assert!((value("r3 P length") - 100.0).abs() > 3.0);
    // The angle is near what it was, and no turn less.
    let angle = value("r3 P angle");
    assert!((300.0..410.0).contains(&angle) && angle != 350.0, "{angle}");
    bench.press("u");
    assert_eq!(bench.app().open_scene().scene().text(), text);
}

/// Where a link begins is where its frame is, and everything on it would go along.
#[test]
fn the_end_that_a_link_begins_at_says_why_it_stays() {
    let text = presets::find("slotted-lever").unwrap().text;
    let text = text.replace("from = \"O\", to = \"T\"", "from = \"T\", to = \"O\"");
    let opened = opening::text(&text, Origin::Stdin).unwrap();
    let mut bench = bench_of(opened, "M 6", Size::new(COLS, ROWS), Colours::Sixteen);
    let from = place_of(&mut bench, "T");
    drag(&mut bench, from, &[Vec2::new(20.0, 20.0)]);
    let screen = bench.text();
    assert!(screen.contains("T is the origin of r4"), "{screen}");
    assert_eq!(bench.app().open_scene().scene().text(), text);
    assert!(!bench.app().is_changed());
}
