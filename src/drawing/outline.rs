//! Outlines of rigid links with several points.

use super::figure::{Figure, Role, Shape};
use crate::Vec2;

/// A point of a link.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    /// The position.
    pub(super) at: Vec2,
    /// `true` if the point is in a sliding block.
    pub(super) block: bool,
}

/// The angle in radians below which a corner is invisible.
const FLAT: f64 = 2e-4;

/// Draws a link with its plate, if it has one. Collinear points give a line; other points give
/// their convex hull, with a strut to each point inside. A link with a sliding block inside the
/// hull (a yoke) is drawn as arms from the block.
pub(super) fn draw(figure: &mut Figure, points: &[Corner], role: Role, plate: Option<Role>) {
    let corners = hull(points.iter().map(|c| c.at).collect());
    let struts = struts(&corners, points);
    let has_arms = corners.len() > 2 && block_inside(&corners, points).is_some();
    for (from, to) in struts {
        figure.add(Shape::Line { from, to, role });
    }
    if corners.len() > 2 && !has_arms {
        if let Some(role) = plate {
            let corners = corners.clone();
            figure.add(Shape::Plate { corners, role });
        }
        figure.add(Shape::Outline { corners, role });
    }
}

/// Returns all lines of a link.
fn lines(points: &[Corner]) -> Vec<(Vec2, Vec2)> {
    let corners = hull(points.iter().map(|c| c.at).collect());
    let mut lines = struts(&corners, points);
    if corners.len() > 2 && block_inside(&corners, points).is_none() {
        lines.extend(
            corners
                .iter()
                .copied()
                .zip(corners.iter().copied().cycle().skip(1)),
        );
    }
    lines
}

/// Returns the parts of the line from `from` to `to` that no line of the link covers.
pub(super) fn beyond(points: &[Corner], from: Vec2, to: Vec2) -> Vec<(Vec2, Vec2)> {
    let along = to - from;
    let length = along.norm();
    let nearby = |p: Vec2| (p - from).cross(along).abs() > FLAT * length * length;
    let share = |p: Vec2| (p - from).dot(along) / along.norm2();
    let mut covered: Vec<(f64, f64)> = lines(points)
        .into_iter()
        .filter(|&(a, b)| !(nearby(a) || nearby(b)))
        .map(|(a, b)| (share(a).min(share(b)), share(a).max(share(b))))
        .collect();
    covered.sort_by(|a, b| a.0.total_cmp(&b.0));
    if covered
        .iter()
        .all(|&(start, end)| end < FLAT || start > 1.0 - FLAT)
    {
        return vec![(from, to)];
    }
    covered.push((1.0, 1.0));
    let mut plain = Vec::new();
    let mut reached = 0.0_f64;
    for (start, end) in covered {
        let start = start.min(1.0);
        if start > reached + FLAT {
            plain.push((from + along * reached, from + along * start));
        }
        reached = reached.max(end);
    }
    plain
}

/// Returns the lines of a link in addition to its hull's outline; for collinear points, all lines.
fn struts(corners: &[Vec2], points: &[Corner]) -> Vec<(Vec2, Vec2)> {
    match *corners {
        [] | [_] => Vec::new(),
        [from, to] => chain(points, from, to - from),
        _ => match block_inside(corners, points) {
            Some(block) => arms(block, points),
            None => inside(corners, points)
                .map(|c| (c.at, nearest(corners, c.at)))
                .collect(),
        },
    }
}

/// Returns the segments from point to point along a line. They still meet the glyphs of joints that
/// lie slightly off the line.
fn chain(points: &[Corner], from: Vec2, along: Vec2) -> Vec<(Vec2, Vec2)> {
    let mut row: Vec<Vec2> = points
        .iter()
        .map(|c| c.at)
        .filter(|p| p.is_finite())
        .collect();
    let place = |p: &Vec2| (*p - from).dot(along);
    row.sort_by(|a, b| place(a).total_cmp(&place(b)));
    row.dedup();
    row.windows(2).map(|w| (w[0], w[1])).collect()
}

/// Returns the segments from a block to all points, except those that another segment passes.
fn arms(block: Vec2, points: &[Corner]) -> Vec<(Vec2, Vec2)> {
    let tips = points.iter().map(|c| c.at - block);
    let passed = |tip: Vec2| {
        let beyond = |other: Vec2| {
            other.norm() > tip.norm()
                && other.dot(tip) > 0.0
                && other.cross(tip).abs() <= FLAT * other.norm() * tip.norm()
        };
        points.iter().any(|c| beyond(c.at - block))
    };
    let ends = tips.filter(|&tip| tip != Vec2::ZERO && !passed(tip));
    ends.map(|tip| (block, block + tip)).collect()
}

fn inside<'a>(corners: &'a [Vec2], points: &'a [Corner]) -> impl Iterator<Item = &'a Corner> {
    points.iter().filter(|c| !corners.contains(&c.at))
}

fn block_inside(corners: &[Vec2], points: &[Corner]) -> Option<Vec2> {
    inside(corners, points).find(|c| c.block).map(|c| c.at)
}

fn nearest(corners: &[Vec2], to: Vec2) -> Vec2 {
    let closer = |a: Vec2, b: &Vec2| {
        if (*b - to).norm() < (a - to).norm() {
            *b
        } else {
            a
        }
    };
    corners.iter().fold(corners[0], closer)
}

/// Returns the corners of the convex hull (Andrew 1979), counter-clockwise, without points on its
/// edges; two corners for collinear points.
pub(super) fn hull(mut points: Vec<Vec2>) -> Vec<Vec2> {
    points.retain(|p| p.is_finite());
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let mut lower = half_hull(points.iter().copied());
    let upper = half_hull(points.iter().rev().copied());
    lower.pop();
    lower.extend(&upper[..upper.len() - 1]);
    lower
}

fn half_hull(points: impl Iterator<Item = Vec2>) -> Vec<Vec2> {
    let mut chain: Vec<Vec2> = Vec::new();
    for point in points {
        while let [.., a, b] = chain[..] {
            let (first, second) = (b - a, point - b);
            if first.cross(second) > FLAT * first.norm() * second.norm() {
                break;
            }
            chain.pop();
        }
        chain.push(point);
    }
    chain
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(places: &[(f64, f64)]) -> Vec<Vec2> {
        places.iter().map(|&(x, y)| Vec2::new(x, y)).collect()
    }

    fn shapes(places: &[(f64, f64)], block: usize) -> Vec<Shape> {
        let mut figure = Figure::new();
        let corners: Vec<Corner> = points(places)
            .into_iter()
            .enumerate()
            .map(|(i, at)| Corner {
                at,
                block: i == block,
            })
            .collect();
        draw(&mut figure, &corners, Role::Link(0), Some(Role::Plate(0)));
        figure.shapes().to_vec()
    }

    #[test]
    fn hull_omits_points_inside_or_on_edges() {
        let square = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)];
        let more = [(1.0, 1.0), (1.0, 0.0), (2.0, 2.0), (f64::NAN, 1.0)];
        let all: Vec<_> = more.into_iter().chain(square).collect();
        assert_eq!(hull(points(&all)), points(&square));
    }

    #[test]
    fn collinear_points_are_joined_in_order() {
        let line = shapes(&[(1.0, 1.0), (3.0, 3.0), (0.1 + 0.2, 0.3), (2.0, 2.0)], 9);
        let stops = points(&[(0.1 + 0.2, 0.3), (1.0, 1.0), (2.0, 2.0), (3.0, 3.0)]);
        let role = Role::Link(0);
        let joined = stops.windows(2).map(|w| (w[0], w[1]));
        let expected: Vec<_> = joined
            .map(|(from, to)| Shape::Line { from, to, role })
            .collect();
        assert_eq!(line, expected);
    }

    #[test]
    fn three_pins_make_a_plate_and_inner_pin_a_strut() {
        let triangle = shapes(&[(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)], 9);
        let [
            Shape::Plate { corners: plate, .. },
            Shape::Outline { corners, .. },
        ] = &triangle[..]
        else {
            panic!("{triangle:?}");
        };
        assert!(corners.len() == 3 && corners == plate);
        let plate = shapes(&[(0.0, 0.0), (4.0, 0.0), (0.0, 4.0), (1.0, 0.5)], 9);
        let (from, to, role) = (Vec2::new(1.0, 0.5), Vec2::ZERO, Role::Link(0));
        assert_eq!(plate[0], Shape::Line { from, to, role });
        assert_eq!(plate.len(), 3);
    }

    #[test]
    fn yoke_arms_start_at_its_block() {
        let yoke = shapes(&[(0.0, 0.0), (0.0, 60.0), (0.0, -60.0), (120.0, 0.0)], 0);
        assert!(
            yoke.iter()
                .all(|s| matches!(s, Shape::Line { from, .. } if *from == Vec2::ZERO))
        );
    }

    #[test]
    fn guide_is_drawn_only_beyond_its_link() {
        let v = Vec2::new;
        let lever = [v(0.0, 0.0), v(8.0, 8.0)].map(|at| Corner { at, block: false });
        let beyond = |from, to| beyond(&lever, from, to);
        assert_eq!(beyond(v(2.0, 2.0), v(7.0, 7.0)), []);
        assert_eq!(
            beyond(v(4.0, 4.0), v(12.0, 12.0)),
            [(v(8.0, 8.0), v(12.0, 12.0))]
        );
        assert_eq!(
            beyond(v(-1.0, -1.0), v(9.0, 9.0)),
            [(v(-1.0, -1.0), v(0.0, 0.0)), (v(8.0, 8.0), v(9.0, 9.0))]
        );
        for (from, to) in [(v(9.0, 9.0), v(12.0, 12.0)), (v(0.0, 1.0), v(8.0, 9.0))] {
            assert_eq!(beyond(from, to), [(from, to)]);
        }
    }

    #[test]
    fn link_with_one_point_has_no_line() {
        assert_eq!(shapes(&[(1.0, 1.0)], 9), []);
        assert_eq!(shapes(&[(1.0, 1.0), (1.0, 1.0)], 9), []);
    }
}
