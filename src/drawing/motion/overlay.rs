//! Computes the parts of a drawing that depend on the whole motion: traces, other positions, and
//! arrows to one scale. The motion is solved once; every frame then draws from the result.

use super::extents::Extents;
use super::force_arrows::ForceArrows;
use super::ghosts::add_moved;
use super::motion_samples::{Course, TRAIL, course, ends, paced_course};
use super::scale::{self, ArrowScale, MovingArrow};
use crate::drawing::bounds::Bounds;
use crate::drawing::figure::{Figure, Role, Shape};
use crate::drawing::legend::LegendEntry;
use crate::drawing::view::WorldView;
use crate::scene::Scene;
use crate::solver::{Condition, Known, Order, Solver, State, Workspace};
use crate::{PointId, Vec2};
use std::sync::Arc;

/// The parts of an overlay to compute; none by default.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct OverlayRequest {
    /// The points with traces.
    pub traces: Vec<PointId>,
    /// The points with velocity arrows.
    pub velocities: Vec<PointId>,
    /// The points with acceleration arrows.
    pub accelerations: Vec<PointId>,
    /// `true` to show loads and the forces at joints and guides.
    pub forces: bool,
    /// Number of positions of the linkage to show, spread over the motion.
    pub ghosts: u16,
    /// `true` if the driver follows the scene's motion over time, if it has one.
    pub is_timed: bool,
}

impl OverlayRequest {
    /// Returns `true` if no part is requested.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        let none = OverlayRequest {
            is_timed: self.is_timed,
            ..OverlayRequest::default()
        };
        *self == none
    }
}

/// The traces, positions and arrow scales of a motion.
#[derive(Clone, Debug, Default)]
pub struct Overlay {
    traces: Vec<Arc<[Vec2]>>,
    /// The points of the traces, and the motion along which these are sampled.
    traced: Vec<PointId>,
    course: Option<Course>,
    ghosts: Vec<State>,
    velocities: Arrows,
    accelerations: Arrows,
    forces: ForceArrows,
    /// The extents of the arrows' tips, with the driver's coordinate.
    tips: Vec<(f64, Bounds)>,
    /// The scene's unit of length.
    unit: &'static str,
    /// Number of points of the mechanism, to detect another scene.
    count: usize,
}

/// Arrows of one kind.
#[derive(Clone, Debug, Default)]
struct Arrows {
    points: Vec<PointId>,
    /// The scale of the scene's unit of length per second or per second squared.
    scale: ArrowScale,
}

impl Overlay {
    /// Computes the requested overlay: solves the motion once, to the required order.
    #[must_use]
    pub fn of(
        scene: &Scene,
        solver: &Solver,
        extents: &Extents,
        wanted: &OverlayRequest,
    ) -> Overlay {
        let mut overlay = Overlay {
            unit: scene.unit.symbol(),
            count: scene.mechanism.points().len(),
            ..Overlay::default()
        };
        if !(wanted.traces.is_empty()
            && wanted.velocities.is_empty()
            && wanted.accelerations.is_empty())
        {
            overlay.follow(scene, solver, extents, wanted);
        }
        if wanted.forces {
            let course = paced_course(scene, solver, wanted.is_timed);
            overlay.forces = ForceArrows::of((scene, solver), course, extents, &mut overlay.tips);
        }
        overlay.ghosts = ghosts(scene, solver, wanted.ghosts);
        overlay
    }

    /// Computes the requested overlay of a motion that is not the driver's, from its states: solved
    /// to accelerations, and to forces if these are requested. `path` replaces the trace of its
    /// point, and is added if that point has none.
    #[must_use]
    pub fn along<'s>(
        (scene, solver): (&Scene, &Solver),
        states: impl IntoIterator<Item = &'s State>,
        (leading, path): (PointId, &Arc<[Vec2]>),
        extents: &Extents,
        wanted: &OverlayRequest,
    ) -> Overlay {
        let states: Vec<&State> = states.into_iter().collect();
        let trace = |&point: &PointId| match point == leading {
            true => Arc::clone(path),
            false => states.iter().map(|s| s.known().position(point)).collect(),
        };
        let mut traces: Vec<Arc<[Vec2]>> = wanted.traces.iter().map(trace).collect();
        if !traces.is_empty() && !wanted.traces.contains(&leading) {
            traces.push(Arc::clone(path));
        }
        let moving = states.iter().filter(|state| has_rates(state.condition()));
        let rates = |points: &[PointId], rate: fn(Known<'_>, PointId) -> Vec2| {
            let of = |state: &&State| {
                let (at, known) = (state.at(), state.known());
                let arrows = points.iter();
                let arrows = arrows.map(|&p| (at, known.position(p), rate(known, p)));
                arrows.collect::<Vec<MovingArrow>>()
            };
            moving.clone().flat_map(of).collect::<Vec<MovingArrow>>()
        };
        let mut tips = Vec::new();
        let longest = scale::longest(extents);
        let mut arrows = |points: &[PointId], rates: &[MovingArrow]| Arrows {
            points: points.to_vec(),
            scale: ArrowScale::of_motion(rates, longest, &mut tips),
        };
        let velocities = rates(&wanted.velocities, |state, p| state.velocity(p));
        let velocities = arrows(&wanted.velocities, &velocities);
        let accelerations = rates(&wanted.accelerations, |state, p| state.acceleration(p));
        let accelerations = arrows(&wanted.accelerations, &accelerations);
        let forces = match wanted.forces {
            true => {
                let states = moving.clone().copied();
                ForceArrows::of_states((scene, solver), states, extents, &mut tips)
            }
            false => ForceArrows::default(),
        };
        let count = usize::from(wanted.ghosts);
        let ghosts = (0..count).filter_map(|k| states.get(k * states.len() / count));
        Overlay {
            traces,
            ghosts: ghosts.map(|state| (*state).clone()).collect(),
            velocities,
            accelerations,
            forces,
            tips,
            unit: scene.unit.symbol(),
            count: scene.mechanism.points().len(),
            ..Overlay::default()
        }
    }

    /// Returns the traces as chains of straight lines, in world units.
    pub(in crate::drawing) fn traces(&self) -> &[Arc<[Vec2]>] {
        &self.traces
    }

    fn follow(
        &mut self,
        scene: &Scene,
        solver: &Solver,
        extents: &Extents,
        wanted: &OverlayRequest,
    ) {
        let mut traces = vec![Vec::new(); wanted.traces.len()];
        let mut rates = [Vec::new(), Vec::new()];
        let mut state = solver.state();
        if !wanted.traces.is_empty() {
            self.traced.clone_from(&wanted.traces);
            self.course = Some(Course::of(scene, solver));
        }
        for driver_state in course(scene, solver).filter(|_| !wanted.traces.is_empty()) {
            let _ = driver_state.solve(solver, Order::Position, &mut state);
            for (trace, &point) in traces.iter_mut().zip(&wanted.traces) {
                trace.push(state.known().position(point));
            }
        }
        let order = match (
            wanted.velocities.is_empty(),
            wanted.accelerations.is_empty(),
        ) {
            (true, true) => Order::Position,
            (false, true) => Order::Velocity,
            (_, false) => Order::Acceleration,
        };
        let driver_states =
            (order > Order::Position).then(|| paced_course(scene, solver, wanted.is_timed));
        for driver_state in driver_states.into_iter().flatten() {
            let (at, condition) = (
                driver_state.at,
                driver_state.solve(solver, order, &mut state),
            );
            if has_rates(condition) {
                let state = state.known();
                let from = |p: &PointId| state.position(*p);
                let velocities = wanted.velocities.iter();
                rates[0].extend(velocities.map(|p| (at, from(p), state.velocity(*p))));
                let accelerations = wanted.accelerations.iter();
                rates[1].extend(accelerations.map(|p| (at, from(p), state.acceleration(*p))));
            }
        }
        self.traces = traces.into_iter().map(Arc::from).collect();
        let longest = scale::longest(extents);
        let [velocities, accelerations] = rates;
        let mut arrows = |points: &[PointId], rates: &[MovingArrow]| Arrows {
            points: points.to_vec(),
            scale: ArrowScale::of_motion(rates, longest, &mut self.tips),
        };
        self.velocities = arrows(&wanted.velocities, &velocities);
        self.accelerations = arrows(&wanted.accelerations, &accelerations);
    }

    /// Returns the extents enlarged by the tips of all arrows; `None` if there are no arrows.
    #[must_use]
    pub fn extents(&self, extents: &Extents) -> Option<Extents> {
        (!self.tips.is_empty()).then(|| extents.with_arrows(&self.tips))
    }

    /// Adds the overlay to the figure of the linkage in a state. Arrows keep their size on a
    /// drawing enlarged by `zoom`. The overlay of a scene with another number of points is
    /// left out.
    pub fn add_to(
        &self,
        figure: &mut Figure,
        scene: &Scene,
        solver: &Solver,
        state: &State,
        zoom: f64,
    ) {
        if self.count != scene.mechanism.points().len() {
            return;
        }
        for ghost in &self.ghosts {
            add_moved(figure, scene, state, ghost, Role::Echo);
        }
        for course in &self.traces {
            let (course, role) = (Arc::clone(course), Role::Trace);
            figure.add(Shape::Trace { course, role });
        }
        if !has_rates(state.condition()) {
            return;
        }
        self.forces.add_to(figure, scene, solver, state, zoom);
        let state = state.known();
        let accelerations = |p| state.acceleration(p);
        self.accelerations
            .add_to(figure, Role::Acceleration, state, zoom, accelerations);
        let velocities = |p| state.velocity(p);
        self.velocities
            .add_to(figure, Role::Velocity, state, zoom, velocities);
    }

    /// Adds the part of each trace that its point has just left behind: a quarter of a turn, or of
    /// the motion between two limits. `backwards` is `true` if the driver's coordinate falls.
    pub fn add_trails(&self, figure: &mut Figure, state: &State, backwards: bool) {
        let Some(course) = &self.course else {
            return;
        };
        let Some(here) = course.sample(state.at()) else {
            return;
        };
        for (&point, trace) in self.traced.iter().zip(&self.traces) {
            let samples = course.behind(here, TRAIL, backwards);
            let mut trail: Vec<Vec2> = samples.filter_map(|k| trace.get(k).copied()).collect();
            trail.extend(state.position(point));
            let (course, role) = (trail.into(), Role::Trail);
            figure.add(Shape::Trace { course, role });
        }
    }

    /// Returns the legend entries of the arrows on a drawing with this window.
    #[must_use]
    pub fn legend(&self, view: &WorldView, zoom: f64) -> Vec<LegendEntry> {
        let kinds = [
            (Role::Velocity, "v", "/s", &self.velocities),
            (Role::Acceleration, "a", "/s^2", &self.accelerations),
        ];
        let shown = kinds.into_iter().filter(|(.., a)| !a.points.is_empty());
        let keys = shown.map(|(role, letter, per, arrows)| {
            let unit = format!("{}{per}", self.unit);
            LegendEntry::arrow(
                role,
                letter,
                &unit,
                view.cells_along(arrows.scale.per(zoom)),
            )
        });
        keys.chain(self.forces.legend(view, zoom)).collect()
    }
}

impl Arrows {
    fn add_to(
        &self,
        figure: &mut Figure,
        role: Role,
        state: Known<'_>,
        zoom: f64,
        rate: impl Fn(PointId) -> Vec2,
    ) {
        for &point in &self.points {
            let from = state.position(point);
            let (to, cut) = self.scale.tip(from, rate(point), zoom);
            figure.add(Shape::Arrow {
                from,
                to,
                role,
                cut,
            });
        }
    }
}

pub(in crate::drawing) fn has_rates(condition: Condition) -> bool {
    match condition {
        Condition::Ok | Condition::ChangePoint => true,
        Condition::DeadPoint | Condition::NoAssembly => false,
    }
}

/// Returns states spread evenly over the motion, from the scene's start or from limit to limit.
fn ghosts(scene: &Scene, solver: &Solver, count: u16) -> Vec<State> {
    let (low, high, _, closed) = ends(scene, solver);
    let steps = if closed { count } else { count.max(2) - 1 };
    let mut state = solver.state();
    let at = |k: u16| (low + (high - low) * f64::from(k) / f64::from(steps)).min(high);
    let states = (0..count).filter_map(|k| {
        let condition = solver.solve(at(k), Order::Position, &mut state);
        (condition != Condition::NoAssembly).then(|| state.clone())
    });
    states.map(Workspace::into_state).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::tests::stage::DrawingStage;
    use crate::drawing::{
        Glyphs, Layers, linkage, moving_points, render, usual_arrows, usual_traces,
    };
    use crate::quantity::DriverState;
    use crate::solver::Range;

    /// Requests all parts of an overlay.
    fn everything(stage: &DrawingStage) -> OverlayRequest {
        let points = usual_arrows(&stage.scene.mechanism);
        OverlayRequest {
            traces: usual_traces(&stage.scene),
            velocities: points.clone(),
            accelerations: points,
            forces: true,
            ghosts: 6,
            is_timed: false,
        }
    }

    fn traces(figure: &Figure) -> Vec<Arc<[Vec2]>> {
        let trace = |shape: &Shape| match shape {
            Shape::Trace { course, .. } => Some(Arc::clone(course)),
            _ => None,
        };
        figure.shapes().iter().filter_map(trace).collect()
    }

    /// Half of the coupler curve is straight, from 90 to 270 degrees: it deviates by 0.39 mm over
    /// 160 mm.
    #[test]
    fn trace_of_hoecken_linkage_has_straight_part() {
        let stage = DrawingStage::preset("hoecken");
        let traces_of = usual_traces(&stage.scene);
        assert_eq!(stage.names(&traces_of), ["P"]);
        let overlay = stage.overlay(&OverlayRequest {
            traces: traces_of,
            ..OverlayRequest::default()
        });
        let mut figure = Figure::new();
        let state = stage.solver.state();
        overlay.add_to(&mut figure, &stage.scene, &stage.solver, &state, 1.0);
        let course = traces(&figure).remove(0);
        assert_eq!(course.first(), course.last(), "the curve closes");
        // The scene opens at 120 degrees, and samples are half a degree apart.
        let at = |degrees: usize| course[(degrees + 360 - 120) % 360 * 2];
        let straight: Vec<Vec2> = (90..=270).map(at).collect();
        let (low, high) = straight
            .iter()
            .fold((f64::MAX, f64::MIN), |(low, high), p| {
                (low.min(p.y), high.max(p.y))
            });
        let length = (straight[180] - straight[0]).norm();
        assert!(length > 150.0, "{length}");
        assert!(high - low < 0.0025 * length, "{low} to {high}");
        // At 180 degrees the triangle B, C, D has sides of 100, 100 and 120 mm, and P lies above D.
        assert!((at(180) - Vec2::new(80.0, 160.0)).norm() < 1e-9);
        // The other half of the curve is an arc.
        let arc = course.iter().map(|p| p.y).fold(f64::MIN, f64::max);
        assert!(arc - high > 20.0, "{arc}");
    }

    #[test]
    fn traces_pass_through_their_points() {
        for stage in DrawingStage::presets() {
            let points = usual_traces(&stage.scene);
            assert!(!points.is_empty(), "{}", stage.name);
            let overlay = stage.overlay(&OverlayRequest {
                traces: points.clone(),
                ..OverlayRequest::default()
            });
            let start = stage.scene.mechanism.driver().start;
            let mut state = stage.solver.state();
            let _ = stage.solver.solve(start, Order::Position, &mut state);
            let mut figure = Figure::new();
            overlay.add_to(&mut figure, &stage.scene, &stage.solver, &state, 1.0);
            let size = stage.reach.bounds().size().norm();
            for (course, &point) in traces(&figure).iter().zip(&points) {
                let at = state.position(point).unwrap();
                let distances = course.iter().map(|p| (*p - at).norm());
                let nearest = distances.fold(f64::INFINITY, f64::min);
                assert!(nearest < 0.01 * size, "{}: {nearest}", stage.name);
                let joined = course.windows(2).map(|w| (w[1] - w[0]).norm());
                assert!(joined.fold(0.0, f64::max) < 0.1 * size, "{}", stage.name);
            }
        }
    }

    #[test]
    fn usual_traces_prefer_points_off_pinned_links() {
        let names = |preset: &str| {
            let stage = DrawingStage::preset(preset);
            let points = usual_traces(&stage.scene);
            stage.names(&points).join(" ")
        };
        assert_eq!(names("four-bar"), "B C");
        assert_eq!(names("slider-crank"), "B C");
        // The scene names its foot.
        assert_eq!(names("jansen-leg"), "T");
    }

    /// At the crank's pin v = r omega gives the arrow's value of 1500 mm/s and its direction.
    #[test]
    fn arrow_scale_is_constant_over_motion() {
        let stage = DrawingStage::preset("four-bar");
        let b = moving_points(&stage.scene.mechanism).next().unwrap();
        let overlay = stage.overlay(&OverlayRequest {
            velocities: vec![b],
            ..OverlayRequest::default()
        });
        let mut state = stage.solver.state();
        for at in [0.0, 60.0, 200.0] {
            let _ = stage.solver.solve(at, Order::Velocity, &mut state);
            let mut figure = Figure::new();
            overlay.add_to(&mut figure, &stage.scene, &stage.solver, &state, 1.0);
            let [Shape::Arrow { from, to, cut, .. }] = figure.shapes() else {
                panic!("{figure:?}");
            };
            let arrow = *to - *from;
            let longest = scale::longest(&stage.reach);
            assert!((arrow.norm() / longest - 1.0).abs() < 1e-9 && !cut);
            let crank = crate::angle::unit(at);
            assert!(arrow.dot(crank).abs() < 1e-9 * longest && crank.cross(arrow) > 0.0);
        }
        // At a zoom of 2, the arrow keeps its length on the screen.
        let mut near = Figure::new();
        overlay.add_to(&mut near, &stage.scene, &stage.solver, &state, 2.0);
        let Shape::Arrow { from, to, .. } = near.shapes()[0] else {
            panic!("{near:?}");
        };
        let longest = scale::longest(&stage.reach);
        assert!(((to - from).norm() * 2.0 / longest - 1.0).abs() < 1e-9);
        let view = WorldView::fit(&stage.reach, 80, 24, 2.0);
        let [LegendEntry::Arrow { text, cells, .. }] = &overlay.legend(&view, 1.0)[..] else {
            panic!("one arrow");
        };
        let value: f64 = text.split(' ').nth(1).unwrap().parse().unwrap();
        assert!(
            (cells / view.cells_along(longest) - value / 1500.0).abs() < 1e-9,
            "{text}"
        );
    }

    const SWINGING: &str = r#"
        unit = "mm"
        ground = { A = [0, 0], D = [100, 0] }
        driver = { link = "r2", angle = 60, speed = "1 rad/s" }
        [links]
        r2 = { from = "A", to = "B", length = 60 }
        r3 = { from = "B", to = "C", length = 50 }
        r4 = { from = "C", to = "D", length = 60 }
        [start]
        C = [75, 55]"#;

    /// Rates are unbounded near the dead point: arrows are cut and marked as such, and absent at
    /// the point itself.
    #[test]
    fn arrows_are_cut_near_dead_point_and_absent_at_it() {
        let stage = DrawingStage::of("a scene", SWINGING);
        let overlay = stage.overlay(&everything(&stage));
        let Range::Limited { high, .. } = stage.solver.motion().range else {
            panic!("it swings");
        };
        let longest = scale::longest(&stage.reach);
        let arrows = |at: f64| {
            let mut state = stage.solver.state();
            let _ = stage.solver.solve(at, Order::Acceleration, &mut state);
            let mut figure = Figure::new();
            overlay.add_to(&mut figure, &stage.scene, &stage.solver, &state, 1.0);
            let arrow = |shape: &Shape| match *shape {
                Shape::Arrow { from, to, cut, .. } => Some(((to - from).norm(), cut)),
                _ => None,
            };
            figure.shapes().iter().filter_map(arrow).collect::<Vec<_>>()
        };
        let near = arrows(high - 1e-6);
        assert!(near.iter().any(|(_, cut)| *cut), "{near:?}");
        assert!(
            near.iter()
                .all(|(length, _)| *length <= longest * 1.000_001)
        );
        assert!(arrows(60.0).iter().all(|(_, cut)| !cut));
        assert!(arrows(high).is_empty());
    }

    /// All arrow tips of every preset are inside the view, throughout the motion.
    #[test]
    fn arrow_tips_stay_inside_view() {
        for stage in DrawingStage::presets() {
            let overlay = stage.overlay(&everything(&stage));
            let extents = overlay.extents(&stage.reach).expect("something moves");
            let complete = WorldView::fit(&extents, 80, 24, 2.0);
            let mut state = stage.solver.state();
            for DriverState { at, .. } in course(&stage.scene, &stage.solver).step_by(31) {
                let _ = stage.solver.solve(at, Order::Acceleration, &mut state);
                let along = WorldView::along(&extents, at, 80, 24, 2.0);
                let pose = WorldView::pose(&extents, at, 80, 24, 2.0);
                let mut figure = linkage(&stage.scene, &stage.reach, &state, Layers::default());
                overlay.add_to(&mut figure, &stage.scene, &stage.solver, &state, 1.0);
                for shape in figure.shapes() {
                    if let Shape::Arrow { to, .. } = *shape {
                        for view in [complete, along, pose] {
                            let tip = view.cell(to);
                            let inside =
                                (0.0..80.0).contains(&tip.x) && (0.0..24.0).contains(&tip.y);
                            assert!(inside, "{} at {at}: {tip:?}", stage.name);
                        }
                    }
                }
                for glyphs in [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille] {
                    let text = render(&figure, &along, glyphs).text();
                    assert!(glyphs != Glyphs::Ascii || text.is_ascii());
                }
            }
        }
    }

    #[test]
    fn legend_says_that_driver_is_at_rest() {
        let stage = DrawingStage::of("a scene", &SWINGING.replace("1 rad/s", "0 rad/s"));
        let overlay = stage.overlay(&everything(&stage));
        let view = WorldView::fit(&stage.reach, 80, 24, 2.0);
        let legend = overlay.legend(&view, 1.0);
        assert!(matches!(&legend[0], LegendEntry::Note(text) if text.contains("stands still")));
    }

    #[test]
    fn overlay_of_another_scene_is_ignored() {
        let (press, leg) = (
            DrawingStage::preset("press"),
            DrawingStage::preset("jansen-leg"),
        );
        let overlay = leg.overlay(&everything(&leg));
        let mut figure = Figure::new();
        overlay.add_to(
            &mut figure,
            &press.scene,
            &press.solver,
            &press.solver.state(),
            1.0,
        );
        assert!(figure.shapes().is_empty());
    }

    #[test]
    fn ghosts_are_spread_over_the_motion() {
        let count = |preset: &str, ghosts| {
            let stage = DrawingStage::preset(preset);
            let wanted = OverlayRequest {
                ghosts,
                ..OverlayRequest::default()
            };
            stage
                .overlay(&wanted)
                .ghosts
                .iter()
                .map(State::at)
                .collect::<Vec<_>>()
        };
        assert_eq!(count("four-bar", 4), [60.0, 150.0, 240.0, 330.0]);
        assert!(count("four-bar", 0).is_empty());
        let swings = count("double-rocker", 3);
        assert_eq!(swings.len(), 3);
        assert!((swings[0] + swings[2] - 2.0 * swings[1]).abs() < 1e-9);
    }
}
