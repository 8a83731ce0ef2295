//! Draws the polygons of a loop: its vectors head to tail, and its velocities and accelerations,
//! which are the derivatives of the same sum.

use super::working::{LoopVector, LoopVectors, VectorFigure};
use crate::Vec2;
use crate::drawing::{ArrowKind, DiagramArc, VectorDiagram};
use crate::solver::Order;

/// The fraction of the longest arrow below which a component is a rounding error.
const MIN_VISIBLE_VECTOR: f64 = 1e-9;

impl LoopVectors {
    /// Draws the polygon of an order: the vectors with the angles at their tails, or the velocities
    /// or accelerations from the pole at the origin. Returns `None` if the state has no such values.
    #[must_use]
    pub fn polygon(&self, order: Order, unit: &str) -> Option<VectorDiagram> {
        let mut diagram = VectorDiagram {
            unit: unit.to_owned(),
            ..VectorDiagram::default()
        };
        match order {
            Order::Position => self.add_vectors(&mut diagram)?,
            Order::Velocity => self.add_rates(&mut diagram, "v", |vector| {
                let [along, across] = vector.motion.velocity?;
                Some(vec![(across, "t"), (along, "r")])
            })?,
            Order::Acceleration | Order::Force => self.add_rates(&mut diagram, "a", |vector| {
                let [normal, tangential, coriolis, along] = vector.motion.acceleration?;
                Some(vec![
                    (normal, "n"),
                    (tangential, "t"),
                    (coriolis, "c"),
                    (along, "r"),
                ])
            })?,
        }
        Some(diagram)
    }

    fn add_vectors(&self, diagram: &mut VectorDiagram) -> Option<()> {
        let mut at = Vec2::ZERO;
        for side in &self.vectors {
            let vector = side.vector?;
            let (tail, next) = match side.is_reversed {
                false => (at, at + vector),
                true => (at - vector, at - vector),
            };
            diagram.add_of(&side.name, tail, tail + vector, &side.name, kind(side));
            let (to, name) = side.theta.clone();
            diagram.arcs.push(DiagramArc { at: tail, to, name });
            at = next;
        }
        Some(())
    }

    /// Adds the components of each vector's rate, head to tail.
    fn add_rates(
        &self,
        diagram: &mut VectorDiagram,
        letter: &str,
        components: impl Fn(&LoopVector) -> Option<Vec<(Vec2, &'static str)>>,
    ) -> Option<()> {
        let rates = self
            .vectors
            .iter()
            .map(|side| Some((side, components(side)?)));
        let rates: Vec<_> = rates.collect::<Option<_>>()?;
        let all = rates.iter().flat_map(|(_, components)| components);
        let longest = all.map(|(v, _)| v.norm()).fold(0.0, f64::max);
        let mut at = Vec2::ZERO;
        for (side, mut components) in rates {
            let motion = &side.motion;
            let sum = components.iter().fold(Vec2::ZERO, |sum, (v, _)| sum + *v);
            // The loop may traverse the vector against the motion that is drawn.
            let (mut from, next) = match side.is_reversed == motion.is_of_tail {
                true => (at, at + sum),
                false => (at - sum, at - sum),
            };
            components.retain(|(v, _)| v.norm() > MIN_VISIBLE_VECTOR * longest);
            let is_sum = letter == "v" && components.len() == 1;
            for (v, suffix) in components {
                let symbol = super::working::of_point(letter, &motion.of);
                let symbol = format!("{symbol}{}", motion.about);
                let name = match is_sum {
                    true => symbol,
                    false => format!("{symbol} {suffix}"),
                };
                diagram.add_of(&side.name, from, from + v, &name, kind(side));
                from += v;
            }
            at = next;
        }
        Some(())
    }
}

fn kind(side: &LoopVector) -> ArrowKind {
    let is_own = |figure: &VectorFigure| figure.is_sought && figure.found_by.is_none();
    let is_sought = side.figures[0].iter().any(is_own);
    match (side.is_driven, is_sought) {
        (true, _) => ArrowKind::Driven,
        (false, true) => ArrowKind::Sought,
        (false, false) => ArrowKind::Given,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::ArtElement;
    use crate::report::Working;
    use crate::scene::{Scene, presets};
    use crate::solver::Solver;

    /// Returns the vectors of a polygon in drawing order.
    fn drawn(diagram: &VectorDiagram) -> Vec<Vec2> {
        let art = diagram.artwork("loop");
        let of = |element: &ArtElement| match element {
            ArtElement::Path { runs, class, .. }
                if ["given", "driven", "sought"].contains(&class.as_str()) =>
            {
                Some(runs[0][1] - runs[0][0])
            }
            _ => None,
        };
        art.elements().iter().filter_map(of).collect()
    }

    #[test]
    fn polygons_of_presets_close_throughout_motion() {
        let mut closed = 0;
        for preset in presets::all() {
            let scene = Scene::parse(preset.text, preset.name).unwrap();
            let solver = Solver::new(&scene.mechanism).unwrap();
            let working = Working::new(&scene, &solver);
            let mut state = solver.state();
            let (low, high) = solver.motion().range.ends();
            for k in 0..=4 {
                // Rounding may put the sum beyond the end.
                let at = (low + (high - low) * f64::from(k) / 4.0).min(high);
                let _ = solver.solve(at, Order::Acceleration, &mut state);
                for of in working.loop_vectors(&scene, &solver, &state, 6) {
                    let diagram = of.polygon(Order::Position, "mm").unwrap();
                    let drawn = drawn(&diagram);
                    // A vector of length zero is not drawn.
                    let has_length = |v: &&LoopVector| v.vector.unwrap().norm() > 1e-9;
                    let vectors: Vec<_> = of.vectors.iter().filter(has_length).collect();
                    assert_eq!(vectors.len(), drawn.len(), "{} at {at}", preset.name);
                    let terms = vectors.into_iter().zip(drawn);
                    let sum = terms.fold(Vec2::ZERO, |sum, (vector, line)| {
                        sum + if vector.is_reversed { -line } else { line }
                    });
                    assert!(
                        sum.norm() < 1.0,
                        "{} at {at}: {} {sum:?}",
                        preset.name,
                        of.sum
                    );
                    closed += 1;
                }
            }
        }
        assert!(closed > 150, "{closed}");
    }
    /// The velocity and acceleration polygons are sums over the loop's vectors. Their corners are
    /// the velocities and accelerations of the joints.
    #[test]
    fn rate_polygons_of_presets_close_throughout_motion() {
        let mut closed = 0;
        for preset in presets::all() {
            let scene = Scene::parse(preset.text, preset.name).unwrap();
            let solver = Solver::new(&scene.mechanism).unwrap();
            let working = Working::new(&scene, &solver);
            let mut state = solver.state();
            let (low, high) = solver.motion().range.ends();
            for k in 1..4 {
                let at = low + (high - low) * (f64::from(k) / 4.0 + 0.013);
                let _ = solver.solve(at, Order::Acceleration, &mut state);
                for of in working.loop_vectors(&scene, &solver, &state, 6) {
                    for order in [Order::Velocity, Order::Acceleration] {
                        let Some(diagram) = of.polygon(order, "mm") else {
                            continue;
                        };
                        let largest = (diagram.arrows.iter())
                            .map(|arrow| (arrow.to - arrow.from).norm())
                            .fold(0.0, f64::max);
                        // Each corner is the end of exactly two chains of arrows.
                        let open = open_ends(&diagram, 1e-9 * largest);
                        assert!(open.is_empty(), "{} at {at}: {open:?}", preset.name);
                        closed += usize::from(!diagram.is_empty());
                    }
                }
            }
        }
        assert!(closed > 200, "{closed}");
    }

    /// Returns the places at which an odd number of arrows begin or end.
    fn open_ends(diagram: &VectorDiagram, tolerance: f64) -> Vec<Vec2> {
        let mut ends: Vec<Vec2> = Vec::new();
        for end in diagram.arrows.iter().flat_map(|a| [a.from, a.to]) {
            let near = ends.iter().position(|at| (*at - end).norm() <= tolerance);
            match near {
                Some(at) => drop(ends.swap_remove(at)),
                None => ends.push(end),
            }
        }
        ends
    }

    /// The velocity polygon of the four-bar is the triangle of the lectures: vB and vC from the
    /// pole, and vC/B between their heads.
    #[test]
    fn four_bar_has_textbook_velocity_triangle() {
        let preset = presets::find("four-bar").unwrap();
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let working = Working::new(&scene, &solver);
        let mut state = solver.state();
        let _ = solver.solve(60.0, Order::Acceleration, &mut state);
        let loops = working.loop_vectors(&scene, &solver, &state, 6);
        let diagram = loops[0].polygon(Order::Velocity, "mm/s").unwrap();
        let named = |name: &str| {
            let arrow = diagram.arrows.iter().find(|arrow| arrow.name == name);
            arrow.unwrap_or_else(|| panic!("{name}: {:?}", diagram.arrows))
        };
        let velocity = |point: &str| {
            let mut points = scene.mechanism.point_ids();
            let point = points.find(|p| scene.point_name(*p) == Some(point));
            state.velocity(point.unwrap()).unwrap()
        };
        let [b, c, relative] = ["vB", "vC", "vC/B"].map(named);
        assert_eq!(diagram.arrows.len(), 3);
        for (arrow, point) in [(b, "B"), (c, "C")] {
            assert!(arrow.from.norm() < 1e-9, "{point}: {:?}", arrow.from);
            assert!((arrow.to - velocity(point)).norm() < 1e-9, "{point}");
        }
        assert!((relative.from - b.to).norm() < 1e-9);
        assert!((relative.to - c.to).norm() < 1e-9);
        let diagram = loops[0].polygon(Order::Acceleration, "mm/s^2").unwrap();
        let names: Vec<&str> = diagram.arrows.iter().map(|a| a.name.as_str()).collect();
        assert_eq!(names, ["aB n", "aC/B n", "aC/B t", "aC n", "aC t"]);
    }
}
