//! Draws vectors to scale: the polygon of each loop, and velocities and accelerations from one
//! pole.

use super::ReportedState;
use crate::Vec2;
use crate::angle;
use crate::drawing::{ArrowKind, VectorDiagram};
use crate::page::{Content, Illustration, Page, Table};
use crate::report::text::number::{direction, significant};
use crate::report::working::{LoopVector, LoopVectors, PointMotion};
use crate::solver::Order;
use crate::wording::words;
use std::sync::Arc;

/// Maximum number of points for which component vectors are drawn; more would hide each other.
const MAX_COMPONENT_POINTS: usize = 8;
/// Vectors below this fraction of the longest one are rounding errors, or too short to be visible.
const MIN_VISIBLE_VECTOR: f64 = 1e-3;

impl ReportedState<'_> {
    /// Adds the closed polygon of the vectors of each loop.
    pub(super) fn polygons(&self, page: &mut Page) {
        for (number, of) in self.loops.iter().enumerate() {
            if let Some(diagram) = of.polygon(Order::Position, self.scene.unit.symbol()) {
                let sum = match self.loops.len() {
                    1 => words().polygon_drawn(&of.sum),
                    _ => words().polygon_of_loop(number + 1, &of.sum),
                };
                let against = explain_reversed(of);
                let caption = format!("{sum}{}{against}", words().dashes_and_arcs());
                // Text drawings have neither dashes nor arcs.
                show(page, &diagram, (caption, Some(sum + "." + &against)));
            }
        }
    }

    /// Adds a table of velocities and accelerations of points, and diagrams to scale.
    pub(super) fn diagrams(&self, page: &mut Page) {
        let motions = self
            .working
            .point_motions(self.scene, self.solver, self.state);
        if motions.is_empty() {
            return;
        }
        page.heading(words().points_to_scale());
        self.table_of_points(&motions, page);
        for (order, unit, captions) in [
            (
                Order::Velocity,
                format!("{}/s", self.scene.unit.symbol()),
                [
                    words().velocities_of_joints(),
                    words().velocities_of_centres(),
                ],
            ),
            (
                Order::Acceleration,
                format!("{}/s^2", self.scene.unit.symbol()),
                [
                    words().accelerations_of_joints(),
                    words().accelerations_of_centres(),
                ],
            ),
        ] {
            for (is_centre, caption) in [false, true].into_iter().zip(captions) {
                let of: Vec<&PointMotion> = motions
                    .iter()
                    .filter(|m| m.is_centre == is_centre)
                    .collect();
                let diagram = from_pole(&of, order, &unit);
                if !diagram.is_empty() {
                    show(page, &diagram, (caption.to_owned(), None));
                }
            }
        }
    }

    fn table_of_points(&self, motions: &[PointMotion], page: &mut Page) {
        let unit = self.scene.unit.symbol();
        let at = words().direction_in_degrees();
        let mut table = Table::new(
            words().point(),
            [&format!("v [{unit}/s]"), at, &format!("a [{unit}/s^2]"), at],
        );
        let largest = |of: fn(&PointMotion) -> Vec2| {
            let all = motions.iter().map(|motion| of(motion).norm());
            all.fold(0.0, f64::max)
        };
        let largest = [largest(|m| m.velocity), largest(|m| m.acceleration)];
        for motion in motions {
            let vectors = [motion.velocity, motion.acceleration];
            let cells = vectors.into_iter().zip(largest).flat_map(|(v, largest)| {
                match v.norm() > 64.0 * f64::EPSILON * largest {
                    true => [
                        significant(v.norm(), self.digits),
                        direction(angle::degrees(v), self.digits),
                    ],
                    false => ["0".to_owned(), "-".to_owned()],
                }
            });
            let [symbol, _] = &motion.symbols;
            // The symbol of the velocity without its letter is the name of the point.
            let name = symbol.trim_start_matches('v').trim_start_matches('_');
            table.row(name, cells);
        }
        page.table(table);
    }
}

/// Explains arrows opposite to their angle arc: their vectors have a negative length.
fn explain_reversed(of: &LoopVectors) -> String {
    let is_negative = |side: &&LoopVector| {
        let along = |vector: Vec2| vector.dot(angle::unit(side.theta.0));
        side.vector.is_some_and(|vector| along(vector) < 0.0)
    };
    let negative = of.vectors.iter().filter(is_negative);
    let text = negative.map(|side| words().points_against(&side.name, &side.theta.1));
    text.map(|text| format!(" {text}")).collect()
}

/// Adds a diagram with its caption, and another caption for the text drawing.
fn show(
    page: &mut Page,
    diagram: &VectorDiagram,
    (caption, in_characters): (String, Option<String>),
) {
    page.add(Content::Picture(Illustration {
        artwork: Arc::new(diagram.artwork(&caption)),
        caption,
        character_caption: in_characters,
        characters: diagram.characters(),
    }));
}

/// Draws velocities or accelerations from one pole, with the components of which they are sums.
fn from_pole(motions: &[&PointMotion], order: Order, unit: &str) -> VectorDiagram {
    let is_velocity = order == Order::Velocity;
    let complete = |motion: &PointMotion| match is_velocity {
        true => motion.velocity,
        false => motion.acceleration,
    };
    let longest = motions
        .iter()
        .map(|m| complete(m).norm())
        .fold(0.0, f64::max);
    let is_seen = |v: Vec2| v.norm() > MIN_VISIBLE_VECTOR * longest;
    let mut diagram = VectorDiagram {
        unit: unit.to_owned(),
        ..VectorDiagram::default()
    };
    let seen = || motions.iter().filter(|motion| is_seen(complete(motion)));
    for motion in seen() {
        let symbol = &motion.symbols[usize::from(!is_velocity)];
        diagram.add(Vec2::ZERO, complete(motion), symbol, ArrowKind::Sought);
    }
    if motions.len() > MAX_COMPONENT_POINTS {
        return diagram;
    }
    for motion in seen() {
        let symbol = &motion.symbols[usize::from(!is_velocity)];
        for part in &motion.parts {
            let name = format!("{symbol}{}", part.about);
            let base = part.base[usize::from(!is_velocity)];
            let parts = match is_velocity {
                true => vec![(part.velocity, name)],
                false => vec![
                    (part.normal, format!("{name} n")),
                    (part.tangential, format!("{name} t")),
                ],
            };
            let parts: Vec<_> = parts.into_iter().filter(|(v, _)| is_seen(*v)).collect();
            // A single component from the pole equals the whole vector.
            if parts.len() == 1 && !is_seen(base) {
                continue;
            }
            let is_drawn = |arrow: &crate::drawing::DiagramArrow| arrow.to == base;
            if is_seen(base) && !diagram.arrows.iter().any(is_drawn) {
                let base_name = format!("{}{}", &symbol[..1], &part.about[1..]);
                diagram.add(Vec2::ZERO, base, base_name, ArrowKind::Given);
            }
            let mut from = base;
            for (v, name) in parts {
                diagram.add(from, from + v, name, ArrowKind::Part);
                from += v;
            }
        }
    }
    diagram
}
