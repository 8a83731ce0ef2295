//! Draws the forces on the linkage as arrows with their sizes: loads, joint and guide reactions,
//! and the driving force or moment.
//!
//! Hidden forces, and forces that equilibrium leaves undetermined, have no arrow. If a pin
//! joins two bodies and carries no load, one arrow shows the force on the link that comes first.

use super::extents::Extents;
use super::overlay::has_rates;
use super::scale::{self, ArrowScale, MovingArrow};
use crate::drawing::bounds::Bounds;
use crate::drawing::figure::{Figure, Role, Shape};
use crate::drawing::legend::LegendEntry;
use crate::drawing::view::WorldView;
use crate::quantity::DriverState;
use crate::scene::Scene;
use crate::solver::{Order, Solver, State};
use crate::{Body, Input, Mechanism, Vec2};

/// The scale of the force arrows, if forces are shown.
#[derive(Clone, Debug, Default)]
pub(in crate::drawing) struct ForceArrows {
    /// The scale of forces in newtons.
    scale: Option<ArrowScale>,
    /// The threshold below which a moment is the rounding error of a zero, in N m.
    least_moment: f64,
}

/// The fraction of the longest arrow below which an arrow gets no size.
const MIN_SIZED_ARROW: f64 = 0.05;

/// The fraction below which a moment counts as zero, relative to the largest moment, or to the largest force
/// times the size of the whole drawing.
const NO_MOMENT: f64 = 1e-9;

/// The forces and moments on the linkage in one state.
#[derive(Default)]
struct StateForces {
    /// Points of application, and forces in N.
    forces: Vec<(Vec2, Vec2)>,
    /// Points, and moments in N m, counter-clockwise.
    moments: Vec<(Vec2, f64)>,
}

impl ForceArrows {
    /// Computes one scale for the whole motion; appends the extents of the arrows' tips to `tips`.
    pub(in crate::drawing) fn of(
        (scene, solver): (&Scene, &Solver),
        course: Vec<DriverState>,
        extents: &Extents,
        tips: &mut Vec<(f64, Bounds)>,
    ) -> ForceArrows {
        let mut state = solver.state();
        let found = course.into_iter().filter_map(|driver_state| {
            match has_rates(driver_state.solve(solver, Order::Force, &mut state)) {
                true => Some((driver_state.at, found(&scene.mechanism, solver, &state))),
                false => None,
            }
        });
        ForceArrows::scaled(scene, found, extents, tips)
    }

    /// Computes one scale for states solved with forces; appends the extents of the arrows' tips to
    /// `tips`.
    pub(in crate::drawing) fn of_states<'s>(
        (scene, solver): (&Scene, &Solver),
        states: impl Iterator<Item = &'s State>,
        extents: &Extents,
        tips: &mut Vec<(f64, Bounds)>,
    ) -> ForceArrows {
        let found = states.map(|state| (state.at(), found(&scene.mechanism, solver, state)));
        ForceArrows::scaled(scene, found, extents, tips)
    }

    fn scaled(
        scene: &Scene,
        found: impl Iterator<Item = (f64, StateForces)>,
        extents: &Extents,
        tips: &mut Vec<(f64, Bounds)>,
    ) -> ForceArrows {
        let mut all: Vec<MovingArrow> = Vec::new();
        let mut most_moment: f64 = 0.0;
        for (at, StateForces { forces, moments }) in found {
            all.extend(forces.into_iter().map(|(from, force)| (at, from, force)));
            let sizes = moments.iter().map(|(_, moment)| moment.abs());
            most_moment = sizes.fold(most_moment, f64::max);
        }
        let scale = ArrowScale::of_motion(&all, scale::longest(extents), tips);
        let lever = extents.bounds().size().norm() * scene.unit.metres();
        ForceArrows {
            scale: Some(scale),
            least_moment: NO_MOMENT * most_moment.max(scale.longest_magnitude() * lever),
        }
    }

    /// Adds the arrows of a state with solved forces to a figure.
    pub(in crate::drawing) fn add_to(
        &self,
        figure: &mut Figure,
        scene: &Scene,
        solver: &Solver,
        state: &State,
        zoom: f64,
    ) {
        let Some(scale) = self.scale else { return };
        let role = Role::Force;
        let StateForces { forces, moments } = found(&scene.mechanism, solver, state);
        for (from, force) in forces {
            let (to, cut) = scale.tip(from, force, zoom);
            figure.add(Shape::Arrow {
                from,
                to,
                role,
                cut,
            });
            if force.norm() >= MIN_SIZED_ARROW * scale.longest_magnitude() {
                let text = format!("{} N", rounded(force.norm()));
                let at = to;
                figure.add(Shape::Label { at, text, role });
            }
        }
        let is_one = |(_, moment): &(Vec2, f64)| moment.abs() > self.least_moment;
        for (at, moment) in moments.into_iter().filter(is_one) {
            let is_left = moment > 0.0;
            figure.add(Shape::Moment { at, is_left });
            let text = format!("{} N m", rounded(moment.abs()));
            figure.add(Shape::Label { at, text, role });
        }
    }

    /// Returns the legend entry of the arrows for a drawing with this window.
    pub(in crate::drawing) fn legend(&self, view: &WorldView, zoom: f64) -> Option<LegendEntry> {
        let scale = self.scale.filter(|scale| scale.longest_magnitude() > 0.0)?;
        let cells = view.cells_along(scale.per(zoom));
        Some(LegendEntry::arrow(Role::Force, "F", "N", cells))
    }
}

/// Returns all known forces and moments in a state.
fn found(mechanism: &Mechanism, solver: &Solver, state: &State) -> StateForces {
    let mut found = StateForces::default();
    joints(mechanism, state, &mut found);
    guides(mechanism, state, &mut found);
    inputs(mechanism, state, &mut found);
    loads(mechanism, solver, state, &mut found);
    found.forces.retain(|(_, force)| force.is_finite());
    found
}

fn joints(mechanism: &Mechanism, state: &State, found: &mut StateForces) {
    for link in mechanism.link_ids() {
        for point in mechanism.pins(link) {
            let is_shown = match mechanism.partner(link, point) {
                Some(Body::Link(other)) => link < other,
                Some(Body::Ground) => true,
                // The arrows of guides and of the driver show this force already.
                None => !mechanism.is_guided_alone(point),
            };
            let force = state.joint_force(link, point).filter(|_| is_shown);
            found.forces.extend(state.position(point).zip(force));
        }
    }
}

fn guides(mechanism: &Mechanism, state: &State, found: &mut StateForces) {
    for (id, slide) in mechanism.slide_ids().zip(mechanism.slides()) {
        if let (Some(normal), Some(travel)) = (state.normal(id), state.travel(id)) {
            let at = state.position(slide.slider.point());
            let force = travel.guide.perp() * normal;
            found.forces.extend(at.map(|at| (at, force)));
            // A block that cannot turn on its guide passes a moment to it.
            found.moments.extend(at.zip(state.moment(id)));
        }
    }
}

/// Adds the moment of each input about its pivot, or its force along its guide.
fn inputs(mechanism: &Mechanism, state: &State, found: &mut StateForces) {
    let is_single = mechanism.timed().is_empty();
    for input in mechanism.inputs() {
        // With several inputs, the drive does the work of all of them.
        let effort = match is_single {
            true => state.drive(),
            false => state.effort(input),
        };
        let Some(effort) = effort else { continue };
        match input {
            Input::Turn(link) => {
                let at = mechanism.hub(link).and_then(|point| state.position(point));
                found.moments.extend(at.map(|at| (at, effort)));
            }
            Input::Push(slide) => {
                let at = state.position(mechanism.slide(slide).slider.point());
                let guide = state.travel(slide).map(|travel| travel.guide * effort);
                found.forces.extend(at.zip(guide));
            }
        }
    }
}

/// Adds the loads at points and on links. Springs are drawn as springs and get no arrows.
fn loads(mechanism: &Mechanism, solver: &Solver, state: &State, found: &mut StateForces) {
    for (load, acted) in mechanism.loads().iter().zip(solver.acted(state)) {
        if load.ends().is_some() {
            continue;
        }
        for (point, force) in acted.forces {
            found
                .forces
                .extend(state.position(point).map(|at| (at, force)));
        }
        for (link, couple) in acted.couples {
            let members = &mechanism.link(link).members;
            let places: Option<Vec<Vec2>> =
                members.iter().map(|m| state.position(m.point)).collect();
            let middle = places.filter(|places| !places.is_empty()).map(|places| {
                let sum = places.iter().fold(Vec2::ZERO, |sum, &at| sum + at);
                sum / places.len() as f64
            });
            found.moments.extend(middle.map(|at| (at, couple)));
        }
    }
}

/// Formats a size with about three significant digits, in exponent notation below 1e-3 and from
/// 1e7.
pub(in crate::drawing) fn rounded(size: f64) -> String {
    if !(1e-3..1e7).contains(&size) {
        return format!("{size:.2e}");
    }
    let decimals = match size {
        100.0.. => 0,
        10.0.. => 1,
        1.0.. => 2,
        _ => 4,
    };
    format!("{size:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::tests::stage::DrawingStage;
    use crate::drawing::{Glyphs, Layers, Overlay, OverlayRequest, Raster, linkage, render};
    use crate::scene::presets;
    use crate::solver::testing::falsified;

    fn forces(stage: &DrawingStage) -> Overlay {
        stage.overlay(&OverlayRequest {
            forces: true,
            ..OverlayRequest::default()
        })
    }

    /// Returns the shapes added to the figure of the linkage.
    fn added(stage: &DrawingStage, state: &State) -> Vec<Shape> {
        let mut figure = Figure::new();
        forces(stage).add_to(&mut figure, &stage.scene, &stage.solver, state, 1.0);
        figure.shapes().to_vec()
    }

    fn arrows(shapes: &[Shape]) -> Vec<(Vec2, Vec2)> {
        let arrow = |shape: &Shape| match *shape {
            Shape::Arrow { from, to, cut, .. } => (!cut).then_some((from, to)),
            _ => None,
        };
        shapes.iter().filter_map(arrow).collect()
    }

    fn size(shape: &Shape) -> Option<&str> {
        match shape {
            Shape::Label { text, .. } => Some(text),
            _ => None,
        }
    }

    fn sizes(shapes: &[Shape]) -> Vec<&str> {
        shapes.iter().filter_map(size).collect()
    }

    /// There is one arrow per pin and one for the load, each parallel to its force and with a
    /// length at the common scale.
    #[test]
    fn arrows_show_forces_at_one_scale() {
        let stage = DrawingStage::preset("four-bar-load");
        let state = stage.state(60.0);
        let shapes = added(&stage, &state);
        let arrows = arrows(&shapes);
        assert_eq!(arrows.len(), 5, "{shapes:?}");
        let mechanism = &stage.scene.mechanism;
        let mut scales = Vec::new();
        for link in mechanism.link_ids() {
            for point in mechanism.pins(link) {
                let at = state.position(point).unwrap();
                let force = state.joint_force(link, point).unwrap();
                let (from, to) = arrows
                    .iter()
                    .find(|(from, _)| (*from - at).norm() < 1e-9)
                    .unwrap();
                let arrow = *to - *from;
                assert!(arrow.cross(force).abs() < 1e-9 * arrow.norm() * force.norm());
                scales.push(arrow.norm() / force.norm());
            }
        }
        let load = arrows.last().map(|(from, to)| *to - *from).unwrap();
        assert!(load.x.abs() < 1e-9 && load.y < 0.0, "{load:?}");
        scales.push(load.norm() / 500.0);
        let spread = scales.iter().map(|s| (s / scales[0] - 1.0).abs());
        assert!(spread.fold(0.0, f64::max) < 1e-9, "{scales:?}");
        let lines = sizes(&shapes);
        assert!(
            lines.contains(&"500 N") && lines.contains(&"6.45 N m"),
            "{lines:?}"
        );
    }

    #[test]
    fn torque_arrow_turns_in_direction_of_torque() {
        let text = presets::find("four-bar").unwrap().text;
        for (torque, left) in [("5", true), ("-5", false)] {
            let load = format!("{text}\n[[loads]]\nlink = \"r4\"\ntorque = {torque}\n");
            let stage = DrawingStage::of("a load", &load);
            let shapes = added(&stage, &stage.state(60.0));
            let turns =
                |shape: &&Shape| matches!(shape, Shape::Moment { is_left, .. } if *is_left == left);
            assert!(shapes.iter().any(|shape| turns(&shape)), "{shapes:?}");
            assert!(sizes(&shapes).contains(&"5.00 N m"), "{shapes:?}");
        }
    }

    /// If only the guide acts on a pin, the arrow belongs to the guide; if the driver acts, too, to
    /// the driver.
    #[test]
    fn each_force_is_drawn_once() {
        let torque = "\n[[loads]]\nlink = \"r3\"\ntorque = 5\n";
        let slider_crank = presets::find("slider-crank").unwrap().text.to_owned() + torque;
        let loaded = DrawingStage::of("slider-crank", &slider_crank);
        for stage in DrawingStage::presets().chain([loaded]) {
            let at = stage.scene.mechanism.driver().start;
            let found = found(&stage.scene.mechanism, &stage.solver, &stage.state(at)).forces;
            for (k, (at, force)) in found.iter().enumerate() {
                let here = found[k + 1..]
                    .iter()
                    .filter(|(other, _)| (*other - *at).norm() < 1e-9);
                let same = |other: Vec2| (other - *force).norm() < 1e-6 * force.norm();
                let twice = here.clone().any(|(_, other)| same(*other));
                assert!(!twice, "{}: {at:?} {force:?}", stage.name);
            }
        }
    }

    /// A vertical load does not act along a horizontal slider, and its rounding error is not drawn
    /// as a torque. A slider that does not rotate is held by a moment.
    #[test]
    fn only_existing_moments_are_drawn() {
        let upright = "\n[[loads]]\npoint = \"C\"\nforce = [0, -100]\n";
        let text = presets::find("slider-crank").unwrap().text.to_owned() + upright;
        let stage = DrawingStage::of("an upright load", &text);
        for at in [30.0, 61.0, 200.0] {
            let shapes = added(&stage, &stage.state(at));
            let turns = |shape: &Shape| matches!(shape, Shape::Moment { .. });
            assert!(!shapes.iter().any(turns), "{shapes:?}");
        }
        let sideways = "\n[[loads]]\npoint = \"tool\"\nforce = [-50, 0]\n";
        let text = presets::find("press-ram").unwrap().text.to_owned() + sideways;
        let stage = DrawingStage::of("a sideways load", &text);
        let state = stage.state(stage.scene.mechanism.driver().start);
        let mut slides = stage.scene.mechanism.slide_ids();
        let moment = slides.find_map(|slide| state.moment(slide)).unwrap();
        let shown_text = format!("{} N m", rounded(moment.abs()));
        assert!(
            sizes(&added(&stage, &state)).contains(&shown_text.as_str()),
            "{shown_text}"
        );
    }

    /// No force is drawn if the forces do not balance. The loads of the scene are still drawn.
    #[test]
    fn unbalanced_forces_have_no_arrow() {
        let stage = falsified(true, || DrawingStage::preset("four-bar-load"));
        let state = stage.state(61.0);
        assert!(state.withheld().is_some());
        let shapes = added(&stage, &state);
        assert_eq!(sizes(&shapes), ["500 N"], "{shapes:?}");
        let nothing = DrawingStage::preset("four-bar");
        assert!(added(&nothing, &nothing.state(60.0)).is_empty());
    }

    /// Labels of magnitudes use free space only: they cover no bar, pin or name.
    #[test]
    fn force_labels_cover_no_bar_or_pin() {
        let is_size = |shape: &Shape| {
            matches!(
                shape,
                Shape::Label {
                    role: Role::Force,
                    ..
                }
            )
        };
        let mut written = 0;
        for stage in DrawingStage::presets() {
            let overlay = forces(&stage);
            let at = stage.scene.mechanism.driver().start;
            let state = stage.state(at);
            let mut figure = linkage(&stage.scene, &stage.reach, &state, Layers::default());
            let (scene, solver) = (&stage.scene, &stage.solver);
            overlay.add_to(&mut figure, scene, solver, &state, 1.0);
            let mut plain = Figure::new();
            let kept = figure.shapes().iter().filter(|shape| !is_size(shape));
            kept.for_each(|shape| plain.add(shape.clone()));
            let extents = overlay.extents(&stage.reach).unwrap_or(stage.reach);
            for (cols, rows) in [(46, 18), (80, 24), (120, 40)] {
                let view = WorldView::fit(&extents, cols, rows, 2.0);
                let [with, without] =
                    [&figure, &plain].map(|figure| render(figure, &view, Glyphs::Ascii));
                let count = |raster: &Raster, is: &dyn Fn(Role) -> bool| {
                    let cells = raster.lines().flatten();
                    cells.filter(|cell| is(cell.role)).count()
                };
                let parts = |role: Role| role.is_body() || role.is_mark() || role == Role::Label;
                let name = &stage.name;
                assert_eq!(
                    count(&with, &parts),
                    count(&without, &parts),
                    "{name} {cols}"
                );
                let forces = |role| role == Role::Force;
                written += count(&with, &forces) - count(&without, &forces);
            }
        }
        assert!(written > 300, "{written}");
    }
}
