//! Draws arrows in character cells, as on paper. A velocity has one head, an acceleration two heads
//! and a dashed shaft, and a force a closed head. The kinds therefore differ without colour. An
//! arrow that is too long for its place has a shaft broken in the middle.

use super::dashes;
use super::raster::Raster;
use super::render::Glyphs;
use super::stroke;
use super::symbol::cell_of;
use crate::Vec2;
use crate::drawing::figure::Role;

/// Minimum arrow length, in cell widths. A shorter arrow would be a head without a shaft.
const MIN_LEN: f64 = 1.0;
/// The gap in a broken shaft: start and end as fractions of the length.
const BREAK: (f64, f64) = (0.4, 0.65);

/// Returns the start and end of each piece of the shaft, as fractions of its length.
pub(in crate::drawing) fn pieces(cut: bool) -> &'static [(f64, f64)] {
    if cut {
        &[(0.0, BREAK.0), (BREAK.1, 1.0)]
    } else {
        &[(0.0, 1.0)]
    }
}

/// Draws an arrow between two points in cell coordinates. Cells are `aspect` times as high as wide.
pub(in crate::drawing) fn draw(
    raster: &mut Raster,
    glyphs: Glyphs,
    aspect: f64,
    [from, to]: [Vec2; 2],
    role: Role,
    cut: bool,
) {
    let step = to - from;
    let length = Vec2::new(step.x, step.y * aspect);
    if !(length.norm() >= MIN_LEN && length.is_finite()) {
        return;
    }
    let inside = share_inside(raster, from, step);
    let (step, cut) = (step * inside, cut || inside < 1.0);
    let to = from + step;
    for &(start, end) in pieces(cut) {
        stroke::line(raster, glyphs, from + step * start, from + step * end, role);
    }
    let glyph = head(glyphs, length);
    let (col, row) = cell_of(to);
    raster.set_cell(col, row, glyph, role);
    let before = match role {
        Role::Acceleration => Some(glyph),
        Role::Force => Some(closing(glyphs, length)),
        _ => None,
    };
    if let Some(glyph) = before {
        // The cell before the tip, along the longer axis.
        let cells = step.x.abs().max(step.y.abs()).max(1.0);
        let (before, above) = cell_of(to - step * (1.0 / cells));
        if (before, above) != cell_of(from) {
            raster.set_cell(before, above, glyph, role);
        }
    }
}

/// Returns the fraction of a step that stays inside the raster, so that the arrow's head stays
/// visible. A step that begins outside counts in full, because its visible part has no apparent
/// beginning.
fn share_inside(raster: &Raster, from: Vec2, step: Vec2) -> f64 {
    let size = Vec2::new(f64::from(raster.cols()), f64::from(raster.rows()));
    let begins_inside = (0.0..size.x).contains(&from.x) && (0.0..size.y).contains(&from.y);
    if !begins_inside {
        return 1.0;
    }
    let share = |from: f64, step: f64, size: f64| {
        // Up to the middle of the outermost cell.
        let space = if step > 0.0 {
            size - 0.5 - from
        } else {
            0.5 - from
        };
        if (0.0..size).contains(&(from + step)) {
            1.0
        } else {
            (space / step).clamp(0.0, 1.0)
        }
    };
    share(from.x, step.x, size.x).min(share(from.y, step.y, size.y))
}

/// The heads to the right, to the left, down and up. Console fonts have the triangles too.
const HEADS: [char; 4] = ['>', '<', 'v', '^'];
const TRIANGLES: [char; 4] = ['\u{25ba}', '\u{25c4}', '\u{25bc}', '\u{25b2}'];

/// Returns the head glyph for a direction on the screen, y downwards.
pub(super) fn head(glyphs: Glyphs, direction: Vec2) -> char {
    let is_level = direction.x.abs() >= direction.y.abs();
    let index = match is_level {
        true => usize::from(direction.x <= 0.0),
        false => 2 + usize::from(direction.y <= 0.0),
    };
    heads(glyphs)[index]
}

fn heads(glyphs: Glyphs) -> [char; 4] {
    match glyphs {
        Glyphs::Ascii => HEADS,
        Glyphs::Line | Glyphs::Braille | Glyphs::Blocks(_) => TRIANGLES,
    }
}

/// Returns the line that closes the head of a force, across its direction.
fn closing(glyphs: Glyphs, direction: Vec2) -> char {
    let is_level = direction.x.abs() >= direction.y.abs();
    match (glyphs, is_level) {
        (Glyphs::Ascii, true) => '|',
        (Glyphs::Ascii, false) => '-',
        (_, true) => '\u{2502}',
        (_, false) => '\u{2500}',
    }
}

const RIGHT: Vec2 = Vec2 { x: 1.0, y: 0.0 };

/// Returns a horizontal arrow to the right for a legend, `cells` cells long.
pub(in crate::drawing) fn level(glyphs: Glyphs, role: Role, cells: i32) -> String {
    let shaft = match glyphs {
        Glyphs::Ascii => '-',
        Glyphs::Line => '\u{2500}',
        Glyphs::Braille => '\u{2824}',
        Glyphs::Blocks(_) => '\u{2500}',
    };
    let heads = if role == Role::Acceleration { 2 } else { 1 };
    let dashes = dashes::of_cells(role);
    let of_cell = |cell| match cell {
        _ if cell > cells - heads => head(glyphs, RIGHT),
        _ if role == Role::Force && cell == cells - 1 => closing(glyphs, RIGHT),
        _ if dashes.is_some_and(|dashes| dashes.is_gap(cell - 1)) => ' ',
        _ => shaft,
    };
    (1..=cells).map(of_cell).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::{Extents, Figure, Shape, WorldView, render};

    /// Renders arrows in twelve directions, which start on a ring around the middle.
    fn rosette(glyphs: Glyphs, role: Role, cut: bool) -> String {
        let corners = [Vec2::new(-14.0, -14.0), Vec2::new(14.0, 14.0)];
        let view = WorldView::fit(&Extents::of_places(&corners, &[]), 44, 22, 2.0);
        let mut figure = Figure::new();
        for k in 0..12 {
            let direction = crate::angle::unit(f64::from(k) * 30.0);
            let (from, to) = (direction * 5.0, direction * 13.5);
            figure.add(Shape::Arrow {
                from,
                to,
                role,
                cut,
            });
        }
        render(&figure, &view, glyphs).text()
    }

    #[test]
    fn velocities_and_accelerations_differ_without_colour() {
        for (name, glyphs) in [
            ("ascii", Glyphs::Ascii),
            ("line", Glyphs::Line),
            ("braille", Glyphs::Braille),
        ] {
            let velocity = rosette(glyphs, Role::Velocity, false);
            insta::assert_snapshot!(format!("velocities-{name}"), velocity);
            let acceleration = rosette(glyphs, Role::Acceleration, false);
            insta::assert_snapshot!(format!("accelerations-{name}"), acceleration);
            assert_ne!(velocity, acceleration);
        }
        let cut = rosette(Glyphs::Ascii, Role::Velocity, true);
        insta::assert_snapshot!("velocities-cut", cut);
    }

    #[test]
    fn head_glyph_follows_arrow_direction() {
        let v = Vec2::new;
        for (direction, glyph) in [
            (v(1.0, 0.9), '>'),
            (v(-1.0, 0.9), '<'),
            (v(0.9, 1.0), 'v'),
            (v(0.9, -1.0), '^'),
        ] {
            assert_eq!(head(Glyphs::Ascii, direction), glyph);
        }
    }

    #[test]
    fn legend_arrow_has_requested_length() {
        for glyphs in [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille] {
            for role in [Role::Velocity, Role::Acceleration] {
                for cells in 0..12_usize {
                    let text = level(glyphs, role, i32::try_from(cells).unwrap());
                    assert_eq!(text.chars().count(), cells);
                    let tip = head(glyphs, RIGHT);
                    assert!(cells == 0 || text.ends_with(tip), "{text}");
                }
            }
        }
        assert_eq!(level(Glyphs::Ascii, Role::Velocity, 5), "---->");
        assert_eq!(level(Glyphs::Ascii, Role::Acceleration, 7), "-- -->>");
    }

    /// A tip outside the view would hide the head. The arrow therefore ends at the edge, with a
    /// broken shaft.
    #[test]
    fn clipped_arrow_ends_with_head_at_edge() {
        let mut raster = Raster::new();
        raster.reset(20, 9);
        let from = Vec2::new(4.5, 4.5);
        for (step, expected) in [
            (Vec2::new(40.0, 0.0), "    -------   ----->"),
            (Vec2::new(15.0, 0.0), "    --------------->"),
        ] {
            raster.reset(20, 9);
            let ends = [from, from + step];
            draw(&mut raster, Glyphs::Ascii, 2.0, ends, Role::Velocity, false);
            assert_eq!(raster.text().trim_matches('\n'), expected);
        }
        for to in [
            Vec2::new(4.5, 300.0),
            Vec2::new(-1e200, 1.0),
            Vec2::new(25.0, -4.0),
        ] {
            raster.reset(20, 9);
            draw(
                &mut raster,
                Glyphs::Ascii,
                2.0,
                [from, to],
                Role::Velocity,
                false,
            );
            let heads = raster.text().matches(['v', '<', '>', '^']).count();
            assert_eq!(heads, 1, "{to:?}\n{}", raster.text());
        }
    }

    #[test]
    fn short_or_invalid_arrows_are_not_drawn() {
        let mut raster = Raster::new();
        raster.reset(9, 9);
        let at = Vec2::new(4.5, 4.5);
        for step in [Vec2::ZERO, Vec2::new(0.9, 0.0), Vec2::new(f64::NAN, 3.0)] {
            let ends = [at, at + step];
            draw(&mut raster, Glyphs::Ascii, 2.0, ends, Role::Velocity, false);
        }
        assert_eq!(raster.text().trim(), "");
    }
}
