//! Pictures of presets. They are meant to be looked at: a change that makes one of them worse to
//! read is a fault, whatever else it does.

use krank::drawing::{Glyphs, Labels, Layers, Raster, Reach, View, linkage, render, render_into};
use krank::scene::Scene;
use krank::solver::{Order, Solver};

/// A preset at a coordinate of its driver.
fn picture(
    preset: &str,
    at: f64,
    (cols, rows): (u16, u16),
    glyphs: Glyphs,
    layers: Layers,
) -> String {
    let path = format!("{}/presets/{preset}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("the preset is there");
    let scene = Scene::parse(&text, preset).expect("the scene reads");
    let solver = Solver::new(&scene.mechanism).expect("the scene moves");
    let mut state = solver.state();
    let _ = solver.solve(at, Order::Position, &mut state);
    let reach = Reach::of(&scene, &solver);
    let view = View::fit(&reach, cols, rows, 2.0);
    let figure = linkage(&scene, &reach, &state, layers);
    // A frame, so that blank rows and columns are seen in the file.
    let raster = render(&figure, &view, glyphs);
    let edge = format!("+{}+\n", "-".repeat(usize::from(cols)));
    let line = |line: &str| format!("|{line:<width$}|\n", width = usize::from(cols));
    let lines: String = raster.text().lines().map(line).collect();
    format!("{edge}{lines}{edge}")
}

macro_rules! pictures {
    ($($test:ident: $preset:literal at $at:literal in $size:expr, $glyphs:ident;)*) => {
        $(#[test]
        fn $test() {
            let layers = Layers::default();
            insta::assert_snapshot!(picture($preset, $at, $size, Glyphs::$glyphs, layers));
        })*
    };
}

pictures! {
    four_bar: "four-bar" at 60.0 in (80, 24), Ascii;
    four_bar_lines: "four-bar" at 60.0 in (50, 18), Line;
    four_bar_dots: "four-bar" at 60.0 in (50, 18), Braille;
    four_bar_small: "four-bar" at 60.0 in (40, 12), Ascii;
    slider_crank: "slider-crank" at 30.0 in (80, 24), Ascii;
    slider_crank_dots: "slider-crank" at 30.0 in (60, 16), Braille;
    press: "press" at 60.0 in (80, 24), Ascii;
    press_ram: "press-ram" at 60.0 in (80, 24), Ascii;
    scotch_yoke: "scotch-yoke" at 60.0 in (60, 20), Ascii;
    slotted_lever: "slotted-lever" at 60.0 in (50, 18), Ascii;
    whitworth: "whitworth" at 60.0 in (80, 24), Line;
    jansen: "jansen-leg" at 60.0 in (60, 24), Ascii;
    jansen_dots: "jansen-leg" at 60.0 in (50, 18), Braille;
    jansen_small: "jansen-leg" at 60.0 in (40, 12), Ascii;
    excavator: "excavator-boom" at 2.0 in (80, 24), Ascii;
    excavator_dots: "excavator-boom" at 2.0 in (80, 24), Braille;
    scissor: "scissor-lift" at 1.7 in (100, 40), Ascii;
}

#[test]
fn centres_of_mass_and_names_of_links() {
    let layers = Layers {
        links: true,
        centres: true,
        ..Layers::default()
    };
    let text = picture("four-bar", 60.0, (80, 24), Glyphs::Ascii, layers);
    insta::assert_snapshot!(text);
}

#[test]
fn a_raster_can_be_used_again_for_another_size() {
    let text = include_str!("../../presets/four-bar.toml");
    let scene = Scene::parse(text, "four-bar").expect("the scene reads");
    let solver = Solver::new(&scene.mechanism).expect("the scene moves");
    let mut state = solver.state();
    let _ = solver.solve(60.0, Order::Position, &mut state);
    let reach = Reach::of(&scene, &solver);
    let figure = linkage(&scene, &reach, &state, Layers::default());
    let mut raster = Raster::new();
    for (cols, rows) in [(80, 24), (0, 0), (200, 60), (40, 12)] {
        let view = View::fit(&reach, cols, rows, 2.0);
        let labels = &mut Labels::default();
        render_into(&figure, &view, Glyphs::Ascii, labels, &mut raster);
        assert_eq!(raster, render(&figure, &view, Glyphs::Ascii));
    }
}
