//! How a rigid link of several points looks.

use super::figure::{Figure, Role, Shape};
use crate::Vec2;

/// A point of a link.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    /// Where it is.
    pub(super) at: Vec2,
    /// Whether it sits in a sliding block.
    pub(super) block: bool,
}

/// Flatter than this, in radians, a corner is none to the eye.
const FLAT: f64 = 2e-4;

/// Draws a link: a line between two points, else the convex hull of its points, with a strut to each
/// point inside. A link that slides on a point inside (a yoke) is drawn as arms from its block.
pub(super) fn draw(figure: &mut Figure, points: &[Corner], role: Role) {
    let corners = hull(points.iter().map(|c| c.at).collect());
    match corners[..] {
        [] | [_] => {}
        [from, to] => figure.add(Shape::Line { from, to, role }),
        _ => {
            let is_inside = |c: &&Corner| !corners.contains(&c.at);
            if let Some(block) = points.iter().filter(is_inside).find(|c| c.block) {
                for point in points {
                    let (from, to) = (block.at, point.at);
                    figure.add(Shape::Line { from, to, role });
                }
                return;
            }
            for inside in points.iter().filter(is_inside) {
                let (from, to) = (inside.at, nearest(&corners, inside.at));
                figure.add(Shape::Line { from, to, role });
            }
            figure.add(Shape::Outline { corners, role });
        }
    }
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

/// The corners of the convex hull (Andrew 1979), counter-clockwise, without points on its edges; two
/// for points on a line.
fn hull(mut points: Vec<Vec2>) -> Vec<Vec2> {
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
        draw(&mut figure, &corners, Role::Link);
        figure.shapes().to_vec()
    }

    #[test]
    fn the_hull_leaves_out_what_lies_inside_or_on_an_edge() {
        let square = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)];
        let more = [(1.0, 1.0), (1.0, 0.0), (2.0, 2.0), (f64::NAN, 1.0)];
        let all: Vec<_> = more.into_iter().chain(square).collect();
        assert_eq!(hull(points(&all)), points(&square));
    }

    #[test]
    fn points_on_a_line_make_one_line() {
        let line = shapes(&[(1.0, 1.0), (3.0, 3.0), (0.1 + 0.2, 0.3), (2.0, 2.0)], 9);
        let (from, to) = (Vec2::new(0.1 + 0.2, 0.3), Vec2::new(3.0, 3.0));
        let role = Role::Link;
        assert_eq!(line, [Shape::Line { from, to, role }]);
    }

    #[test]
    fn three_pins_make_a_triangle_and_a_fourth_inside_a_strut() {
        let triangle = shapes(&[(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)], 9);
        assert!(matches!(&triangle[..], [Shape::Outline { corners, .. }] if corners.len() == 3));
        let plate = shapes(&[(0.0, 0.0), (4.0, 0.0), (0.0, 4.0), (1.0, 0.5)], 9);
        let (from, to, role) = (Vec2::new(1.0, 0.5), Vec2::ZERO, Role::Link);
        assert_eq!(plate[0], Shape::Line { from, to, role });
        assert_eq!(plate.len(), 2);
    }

    #[test]
    fn a_yoke_has_arms() {
        let yoke = shapes(&[(0.0, 0.0), (0.0, 60.0), (0.0, -60.0), (120.0, 0.0)], 0);
        assert!(
            yoke.iter()
                .all(|s| matches!(s, Shape::Line { from, .. } if *from == Vec2::ZERO))
        );
    }

    #[test]
    fn a_link_of_one_point_has_no_line() {
        assert_eq!(shapes(&[(1.0, 1.0)], 9), []);
        assert_eq!(shapes(&[(1.0, 1.0), (1.0, 1.0)], 9), []);
    }
}
