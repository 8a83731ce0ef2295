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
    for (cols, rows) in [(80, 24), (50, 18), (40, 12)] {
        let view = View::fit(&four_bar_reach(), cols, rows, 2.0);
        for angle in [60.0, 200.0, 300.0] {
            for glyphs in [Glyphs::Ascii, Glyphs::Braille] {
                println!("== {cols}x{rows} {angle}");
                print!("{}", render(&four_bar_figure(angle), &view, glyphs).text());
            }
        }
    }
}

#[test]
fn look_slider() {
    for angle in [0.0, 30.0, 63.0, 80.0, 90.0, 120.0, 150.0] {
        let along = crate::angle::unit(angle);
        let p = |s: f64| along * s;
        let mut figure = Figure::new();
        figure.add(Shape::Line {
            from: p(5.0),
            to: p(35.0),
            role: Role::Guide,
        });
        let (from, to) = if angle > 90.0 {
            (p(35.0), p(5.0))
        } else {
            (p(5.0), p(35.0))
        };
        figure.add(Shape::Hatching { from, to });
        figure.add(Shape::Block {
            at: p(22.0),
            along,
            pin: true,
        });
        let b = crate::angle::unit(angle + 40.0) * 10.0;
        figure.add(Shape::Line {
            from: v(0.0, 0.0),
            to: b,
            role: Role::Driver,
        });
        figure.add(Shape::Line {
            from: b,
            to: p(22.0),
            role: Role::Link,
        });
        figure.add(Shape::Mark {
            at: b,
            role: Role::Joint,
        });
        figure.add(Shape::Mark {
            at: v(0.0, 0.0),
            role: Role::GroundPin,
        });
        figure.add(Shape::Support { at: v(0.0, 0.0) });
        let reach = Reach::by_hand(&[b, p(35.0)], &[v(0.0, 0.0)]);
        let view = View::fit(&reach, 70, 22, 2.0);
        for glyphs in [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille] {
            println!("== {angle}");
            print!("{}", render(&figure, &view, glyphs).text());
        }
    }
}
