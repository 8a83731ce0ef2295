//! Draws the stops of a linkage: ticks across a guide at the limits of its slide, and an arc
//! between the limits of an angle.

use super::LinkageSketch;
use crate::drawing::figure::{Role, Shape};
use crate::{Body, Input, Limit, LimitOf, LinkId, PointId, SlideId, Vec2, angle};

/// Half the length of a tick across a guide, and the radius of an arc, as fractions of the
/// drawing's diagonal.
const TICK: f64 = 0.02;
const RADIUS: f64 = 0.08;
/// Half the length of the ticks at the ends of an arc, as a fraction of its radius.
const END: f64 = 0.3;
/// The angle of a chord of an arc, in degrees.
const CHORD: f64 = 10.0;
/// Tolerance for a limit beyond the travel, as a fraction of the drawing's diagonal: a nearer limit
/// counts as reached.
const MET: f64 = 1e-9;

impl LinkageSketch<'_> {
    /// Draws the stops of every limit that is set. The ends of tables have no stops.
    pub(super) fn stops(&mut self) {
        let driver = self.mechanism.driver().input;
        for limit in self.mechanism.limits() {
            match (limit.of, driver) {
                (LimitOf::Table(_), _) => {}
                (LimitOf::Slide(slide), _) | (LimitOf::Driver, Input::Push(slide)) => {
                    self.stops_of_slide(slide, limit);
                }
                (LimitOf::Angle { link, from }, _) => self.stops_of_angle(link, from, limit),
                (LimitOf::Driver, Input::Turn(link)) => {
                    let from = self.mechanism.turned_from(link);
                    self.stops_of_angle(link, from, limit);
                }
            }
        }
    }

    fn size(&self) -> f64 {
        self.reach.bounds().size().norm()
    }

    fn stop_line(&mut self, from: Vec2, to: Vec2) {
        let role = Role::Guide;
        self.figure.add(Shape::Line { from, to, role });
    }

    /// Draws a tick at each limit that the slide reaches.
    fn stops_of_slide(&mut self, id: SlideId, limit: &Limit) {
        let Some((minimum, maximum)) = self.reach.travel(id) else {
            return;
        };
        let slack = MET * self.size();
        let guide = self.state.travel(id).guide;
        let across = Vec2::new(-guide.y, guide.x) * (TICK * self.size());
        for end in [limit.low, limit.high] {
            if minimum - slack <= end && end <= maximum + slack {
                let at = self.on_guide(id, end);
                self.stop_line(at - across, at + across);
            }
        }
    }

    /// Draws an arc about the joint of both bodies, between the link's directions at both limits.
    fn stops_of_angle(&mut self, link: LinkId, from: Body, limit: &Limit) {
        let Some(pivot) = self.joint_of(link, from) else {
            return;
        };
        let span = limit.high - limit.low;
        if span >= angle::TURN {
            return;
        }
        let start = match from {
            Body::Ground => 0.0,
            Body::Link(from) => self.state.angle(from),
        };
        let (pivot, radius) = (self.state.position(pivot), RADIUS * self.size());
        let towards = |end: f64| angle::unit(start + end);
        let chords = (span / CHORD).ceil().max(1.0);
        let place = |k: f64| pivot + towards(limit.low + span * (k / chords)) * radius;
        let mut k = 0.0;
        while k < chords {
            self.stop_line(place(k), place(k + 1.0));
            k += 1.0;
        }
        for end in [limit.low, limit.high] {
            let along = towards(end) * radius;
            self.stop_line(pivot + along * (1.0 - END), pivot + along * (1.0 + END));
        }
    }

    /// Returns a point that both bodies share.
    fn joint_of(&self, link: LinkId, other: Body) -> Option<PointId> {
        let members = self.mechanism.link(link).members.iter();
        let mut points = members.map(|member| member.point);
        points.find(|&id| {
            let point = self.mechanism.point(id);
            match other {
                Body::Ground => point.ground.is_some(),
                Body::Link(other) => point.links.contains(&other),
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::{Extents, Layers, linkage};
    use crate::scene::Scene;
    use crate::solver::{Order, Solver};

    /// Returns the lines with the guides' role in the figure of a slider-crank at 60 deg.
    fn lines(limits: &str) -> Vec<[Vec2; 2]> {
        let text = format!(
            "unit = \"mm\"\n[ground]\nA = [0, 0]\n[driver]\nlink = \"r2\"\nangle = 60\n[links]\nr2 = {{ from = \"A\", \
             to = \"B\", length = 100 }}\nr3 = {{ from = \"B\", to = \"C\", length = 300 }}\n[slides]\nrod = {{ point = \
             \"C\", on = \"ground\", through = \"A\", angle = 0 }}\n[start]\nC = [350, 0]\n[limits]\n{limits}"
        );
        let scene = Scene::parse(&text, "test").unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let extents = Extents::of(&scene, &solver);
        let mut state = solver.state();
        let _ = solver.solve(60.0, Order::Position, &mut state);
        let figure = linkage(&scene, &extents, &state, Layers::default());
        let shapes = figure.shapes().iter().filter_map(|shape| match shape {
            Shape::Line { from, to, role } if *role == Role::Guide => Some([*from, *to]),
            _ => None,
        });
        shapes.collect()
    }

    #[test]
    fn slide_has_tick_at_each_reached_stop() {
        let found = lines("rod = [250, 380]");
        assert_eq!(found.len(), 2, "{found:?}");
        for ([from, to], end) in found.into_iter().zip([250.0, 380.0]) {
            assert!((from.x - end).abs() < 1e-9 && (to.x - end).abs() < 1e-9);
            assert!((from.y + to.y).abs() < 1e-9 && from.y != to.y);
        }
        let found = lines("rod = [250, 900]");
        assert_eq!(found.len(), 1, "{found:?}");
        assert_eq!(lines("rod = [100, 500]").len(), 0);
    }

    /// Relative to the crank, the rod is limited to -123 to -30 deg; about B this is 60 - 123 to 60
    /// - 30 deg.
    #[test]
    fn angle_limit_has_arc_between_stops() {
        let found = lines("knee = { link = \"r3\", from = \"r2\", angle = [-123, -30] }");
        let pivot = angle::unit(60.0) * 100.0;
        let direction = |p: Vec2| angle::degrees(p - pivot);
        let near = |found: f64, exact: f64| (found - exact).abs() < 1e-9;
        let [low, high] = &found[found.len() - 2..] else {
            panic!("two ticks: {found:?}");
        };
        assert!(low.iter().all(|&p| near(direction(p), 297.0)), "{found:?}");
        assert!(high.iter().all(|&p| near(direction(p), 30.0)), "{found:?}");
        let arc = &found[..found.len() - 2];
        assert!(near(direction(arc[0][0]), 297.0) && near(direction(arc[arc.len() - 1][1]), 30.0));
        let radius = (arc[0][0] - pivot).norm();
        assert!(
            arc.iter()
                .flatten()
                .all(|&p| near((p - pivot).norm(), radius))
        );
    }
}
