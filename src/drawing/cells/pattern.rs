//! Draws patterns of dots: marks, blocks, springs and plates in windows that are large enough.

use super::raster::{CharCell, Raster};
use super::stroke::{self, FINE};
use crate::Vec2;
use crate::drawing::figure::Role;

/// Squared radii of a mark, in dots: hollow inside the first, drawn up to the second.
const HOLLOW: f64 = 4.0;
const ROUND: f64 = 9.0;
/// Squared radius of the core of a ring, with a gap around it.
const CORE: f64 = 1.0;
/// Squared radius of a disc, smaller than a ring because a coupler point is not a joint.
const SMALL: f64 = 4.6;
/// Half the size of a mark, in dots.
const HALF_MARK: i32 = 3;

/// Half the size of a block, in dots, along and across its guide.
pub(in crate::drawing) const BLOCK: Vec2 = Vec2 { x: 6.0, y: 4.0 };
/// The same in a window where a pin is a character.
pub(in crate::drawing) const SMALL_BLOCK: Vec2 = Vec2 { x: 5.0, y: 3.0 };

/// Number of teeth of a spring.
const TEETH: u32 = 8;
/// The straight part at each end of a spring, as a fraction of its length.
const STRAIGHT: f64 = 0.15;

/// A coordinate beyond any raster.
const OFF_RASTER: f64 = 1e6;

/// Returns the corner between four dots that is nearest to a point in cell coordinates, counted in
/// dots. A point that is not a number gives a corner far outside.
pub(in crate::drawing) fn corner(at: Vec2) -> (i32, i32) {
    let index = |v: f64| {
        if v.is_nan() {
            OFF_RASTER
        } else {
            v.clamp(-OFF_RASTER, OFF_RASTER)
        }
        .round() as i32
    };
    (index(at.x * FINE.x), index(at.y * FINE.y))
}

/// Returns the dots around a point, with their squared distances from it.
fn around(at: Vec2) -> impl Iterator<Item = (i32, i32, f64)> {
    let (x, y) = corner(at);
    let dots =
        (-HALF_MARK..HALF_MARK).flat_map(|dy| (-HALF_MARK..HALF_MARK).map(move |dx| (dx, dy)));
    dots.map(move |(dx, dy)| {
        let from = Vec2::new(f64::from(dx) + 0.5, f64::from(dy) + 0.5);
        (x + dx, y + dy, from.norm2())
    })
}

/// Draws a pin: an opaque ring.
pub(in crate::drawing) fn ring(raster: &mut Raster, at: Vec2, role: Role) {
    for (x, y, far) in around(at) {
        if far < HOLLOW {
            stroke::clear(raster, x, y, role);
        } else if far < ROUND {
            stroke::dot(raster, x, y, role);
        }
    }
}

/// Draws a coupler point.
pub(in crate::drawing) fn disc(raster: &mut Raster, at: Vec2, role: Role) {
    for (x, y, _) in around(at).filter(|(_, _, far)| *far < SMALL) {
        stroke::dot(raster, x, y, role);
    }
}

/// Draws the core of a ring.
pub(in crate::drawing) fn core(raster: &mut Raster, at: Vec2, role: Role) {
    for (x, y, _) in around(at).filter(|(_, _, far)| *far < CORE) {
        stroke::dot(raster, x, y, role);
    }
}

/// Draws a block around a point. `along` is a unit vector on the screen, `half` half its size.
pub(in crate::drawing) fn block(
    raster: &mut Raster,
    at: Vec2,
    along: Vec2,
    half: Vec2,
    role: Role,
) {
    let (x, y) = corner(at);
    let reach = (half.x + half.y) as i32;
    for (dx, dy) in (-reach..reach).flat_map(|dy| (-reach..reach).map(move |dx| (dx, dy))) {
        let from = Vec2::new(f64::from(dx) + 0.5, f64::from(dy) + 0.5);
        let (on, nearby) = (from.dot(along).abs(), from.cross(along).abs());
        if on < half.x && nearby < half.y {
            if on < half.x - 1.0 && nearby < half.y - 1.0 {
                stroke::clear(raster, x + dx, y + dy, role);
            } else {
                stroke::dot(raster, x + dx, y + dy, role);
            }
        }
    }
}

/// Fills a plate with one dot in eight, at fixed places of the raster, so that little changes while
/// it moves.
pub(in crate::drawing) fn plate(raster: &mut Raster, corners: &[Vec2], role: Role) {
    let dots: Vec<Vec2> = corners
        .iter()
        .map(|c| Vec2::new(c.x * FINE.x, c.y * FINE.y))
        .collect();
    let rows = f64::from(raster.rows()) * FINE.y;
    let columns = f64::from(raster.cols()) * FINE.x;
    let heights = || dots.iter().map(|c| c.y);
    let (top, bottom) = heights().fold((rows, 0.0), |(t, b): (f64, f64), y| (t.min(y), b.max(y)));
    if !(bottom > top && dots.iter().all(|c| c.is_finite())) {
        return;
    }
    let (first, last) = (top.max(0.0).floor() as i32, bottom.min(rows).ceil() as i32);
    for y in first..last {
        let middle = f64::from(y) + 0.5;
        let Some((from, to)) = chord(&dots, middle) else {
            continue;
        };
        let (from, to) = (from.max(0.0).ceil() as i32, to.min(columns).floor() as i32);
        for x in (from..to).filter(|&x| is_of_plate(x, y)) {
            // A barrel's plate is drawn after the links: cells of bars keep their dots.
            let is_bar = |cell: CharCell| cell.role.is_body();
            if !raster
                .cell(x.div_euclid(2), y.div_euclid(4))
                .is_some_and(is_bar)
            {
                stroke::dot(raster, x, y, role);
            }
        }
    }
}

/// Returns `true` if a plate has a dot here, counted from the upper left.
pub(in crate::drawing) fn is_of_plate(x: i32, y: i32) -> bool {
    y % 2 == 0 && x % 4 == y % 4
}

/// Returns the x coordinates at which a horizontal line enters and leaves a convex outline.
fn chord(corners: &[Vec2], y: f64) -> Option<(f64, f64)> {
    let ends = corners.iter().cycle().skip(1);
    let crossed = corners.iter().zip(ends).filter_map(|(a, b)| {
        let share = (y - a.y) / (b.y - a.y);
        (0.0..=1.0)
            .contains(&share)
            .then_some(a.x + (b.x - a.x) * share)
    });
    let around = crossed.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
        (low.min(x), high.max(x))
    });
    (around.0 <= around.1).then_some(around)
}

/// Returns the corners of a spring from end to end; `reach` is the height of its teeth to either
/// side.
pub(in crate::drawing) fn zigzag(a: Vec2, b: Vec2, reach: f64) -> impl Iterator<Item = Vec2> {
    let along = b - a;
    let across = along.perp() * (reach / along.norm());
    let starts = std::iter::once(a);
    let teeth = (0..=TEETH).map(move |k| {
        let share = STRAIGHT + (1.0 - 2.0 * STRAIGHT) * f64::from(k) / f64::from(TEETH);
        let side = match k {
            0 | TEETH => 0.0,
            k if k % 2 == 0 => 1.0,
            _ => -1.0,
        };
        a + along * share + across * side
    });
    starts.chain(teeth).chain(std::iter::once(b))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(draw: impl Fn(&mut Raster)) -> String {
        let mut raster = Raster::new();
        raster.reset(12, 5);
        draw(&mut raster);
        raster.text()
    }

    fn dots(text: &str) -> u32 {
        let patterns = text
            .chars()
            .filter(|c| ('\u{2800}'..'\u{2900}').contains(c));
        patterns.map(|c| (u32::from(c) & 0xff).count_ones()).sum()
    }

    #[test]
    fn pin_is_a_ring_and_rider_a_disc() {
        let at = Vec2::new(5.0, 2.5);
        let ring_alone = drawn(|raster| ring(raster, at, Role::Joint));
        let disc_alone = drawn(|raster| disc(raster, at, Role::Rider));
        assert_eq!((dots(&ring_alone), dots(&disc_alone)), (20, 16));
        // The ring hides what is behind it.
        let barred = drawn(|raster| {
            stroke::bar(
                raster,
                Vec2::new(5.0, 0.0),
                Vec2::new(5.0, 5.0),
                2,
                Role::Link(0),
            );
            ring(raster, at, Role::Joint);
        });
        assert_eq!(dots(&barred), 20 + 2 * (20 - 6));
    }

    #[test]
    fn plate_pattern_is_sparse_and_fixed_to_screen() {
        let corners = [(0.0, 0.0), (12.0, 0.0), (12.0, 5.0), (0.0, 5.0)];
        let corners = corners.map(|(x, y)| Vec2::new(x, y));
        let text = drawn(|raster| plate(raster, &corners, Role::Plate(0)));
        assert_eq!(dots(&text), 12 * 5);
        let moved = corners.map(|c| c - Vec2::new(3.3, 0.0));
        let left = drawn(|raster| plate(raster, &moved, Role::Plate(0)));
        for (one, other) in text.lines().zip(left.lines()) {
            let same = one.chars().zip(other.chars()).take_while(|(a, b)| a == b);
            assert!(same.count() >= 8, "{text}{left}");
        }
    }

    #[test]
    fn spring_connects_its_ends_and_has_both_amplitudes() {
        let (a, b) = (Vec2::ZERO, Vec2::new(20.0, 0.0));
        let corners: Vec<Vec2> = zigzag(a, b, 1.5).collect();
        assert_eq!((corners[0], corners[corners.len() - 1]), (a, b));
        let heights = corners.iter().map(|c| c.y);
        let sides = heights.fold((0.0, 0.0), |(low, high): (f64, f64), y| {
            (low.min(y), high.max(y))
        });
        assert_eq!(sides, (-1.5, 1.5));
        assert!(zigzag(a, a, 1.0).all(|c| c == a || !c.is_finite()));
    }
}
