//! Pictures of figures made by hand.

use super::*;
use crate::Vec2;

fn v(x: f64, y: f64) -> Vec2 {
    Vec2::new(x, y)
}

/// The four-bar A(0, 0), D(400, 0), AB = 100, BC = 300, CD = 250 at a crank angle in degrees.
fn four_bar(angle: f64) -> [Vec2; 4] {
    let (a, d) = (v(0.0, 0.0), v(400.0, 0.0));
    let b = crate::angle::unit(angle) * 100.0;
    let r = d - b;
    let m = r.norm();
    let p = (m * m + 300.0 * 300.0 - 250.0 * 250.0) / (2.0 * m);
    let h = (300.0 * 300.0 - p * p).sqrt();
    let u = r / m;
    [a, b, b + u * p + u.perp() * h, d]
}

fn four_bar_figure(angle: f64) -> Figure {
    let [a, b, c, d] = four_bar(angle);
    let mut figure = Figure::new();
    for (from, to, role) in [(a, b, Role::Driver), (b, c, Role::Link), (c, d, Role::Link)] {
        figure.add(Shape::Line { from, to, role });
    }
    for at in [b, c] {
        let role = Role::Joint;
        figure.add(Shape::Mark { at, role });
    }
    for at in [a, d] {
        let role = Role::GroundPin;
        figure.add(Shape::Mark { at, role });
        figure.add(Shape::Support { at });
    }
    for (at, text) in [(a, "A"), (b, "B"), (c, "C"), (d, "D")] {
        let (text, role) = (text.to_owned(), Role::Label);
        figure.add(Shape::Label { at, text, role });
    }
    figure
}

fn four_bar_reach() -> Reach {
    let all: Vec<Vec2> = (0..360).flat_map(|k| four_bar(f64::from(k))).collect();
    Reach::by_hand(&all, &[v(0.0, 0.0), v(400.0, 0.0)])
}

#[test]
fn look() {
    let all = |name: &str| std::env::var("LOOK").map_or(true, |l| l.split(',').any(|x| x == name));
    let angles: Vec<f64> = std::env::var("AT")
        .unwrap_or("0,120".into())
        .split(',')
        .map(|x| x.parse().unwrap())
        .collect();
    let sizes = std::env::var("SIZE").unwrap_or("80x24".into());
    let pens = std::env::var("PEN").unwrap_or("a".into());
    struct P {
        name: String,
        text: String,
    }
    let mut presets: Vec<P> = std::fs::read_dir("presets")
        .unwrap()
        .map(|e| {
            let p = e.unwrap().path();
            P {
                name: p.file_stem().unwrap().to_str().unwrap().into(),
                text: std::fs::read_to_string(p).unwrap(),
            }
        })
        .collect();
    presets.sort_by(|a, b| a.name.cmp(&b.name));
    for preset in presets {
        if !all(&preset.name) {
            continue;
        }
        let scene = match crate::scene::Scene::parse(&preset.text, &preset.name) {
            Ok(s) => s,
            Err(e) => {
                println!("== {} fails {e:?}", preset.name);
                continue;
            }
        };
        let solver = match crate::solver::Solver::new(&scene.mechanism) {
            Ok(s) => s,
            Err(e) => {
                println!("== {} fails {e:?}", preset.name);
                continue;
            }
        };
        let reach = Reach::of(&scene, &solver);
        let mut state = solver.state();
        for size in sizes.split(',') {
            let (cols, rows) = size.split_once('x').unwrap();
            let view = View::fit(&reach, cols.parse().unwrap(), rows.parse().unwrap(), 2.0);
            for angle in &angles {
                let at = match solver.motion().range {
                    crate::solver::Range::Full { .. } => scene.mechanism.driver().start + angle,
                    crate::solver::Range::Limited { low, high } => {
                        low + (high - low) * (angle / 360.0)
                    }
                };
                solver.solve(at, crate::solver::Order::Position, &mut state);
                let layers = Layers {
                    links: std::env::var("LINKS").is_ok(),
                    centres: std::env::var("COM").is_ok(),
                    ..Layers::default()
                };
                let figure = linkage(&scene, &reach, &state, layers);
                for pen in pens.chars() {
                    let glyphs = match pen {
                        'a' => Glyphs::Ascii,
                        'l' => Glyphs::Line,
                        _ => Glyphs::Braille,
                    };
                    println!("== {} {size} at {at}", preset.name);
                    print!("{}", render(&figure, &view, glyphs).text());
                }
            }
        }
    }
}
