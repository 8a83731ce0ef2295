//! Prepares scenes for the tests of drawings.

use crate::PointId;
use crate::drawing::{Extents, Overlay, OverlayRequest};
use crate::scene::{Scene, presets};
use crate::solver::{Condition, Order, Range, Solver, State};

/// A scene with everything that drawing it requires.
pub(in crate::drawing) struct DrawingStage {
    pub(in crate::drawing) name: String,
    pub(in crate::drawing) scene: Scene,
    pub(in crate::drawing) solver: Solver,
    pub(in crate::drawing) reach: Extents,
}

impl DrawingStage {
    pub(in crate::drawing) fn of(name: &str, text: &str) -> DrawingStage {
        let scene = Scene::parse(text, name).expect("the scene reads");
        let solver = Solver::new(&scene.mechanism).expect("the scene moves");
        let extents = Extents::of(&scene, &solver);
        let name = name.to_owned();
        DrawingStage {
            name,
            scene,
            solver,
            reach: extents,
        }
    }

    pub(in crate::drawing) fn preset(name: &str) -> DrawingStage {
        let preset = presets::find(name).expect("it is built in");
        DrawingStage::of(name, preset.text)
    }

    pub(in crate::drawing) fn presets() -> impl Iterator<Item = DrawingStage> {
        let all = presets::all().iter();
        all.map(|preset| DrawingStage::of(preset.name, preset.text))
    }

    pub(in crate::drawing) fn overlay(&self, wanted: &OverlayRequest) -> Overlay {
        Overlay::of(&self.scene, &self.solver, &self.reach, wanted)
    }

    pub(in crate::drawing) fn names(&self, points: &[PointId]) -> Vec<&str> {
        let name = |p: &PointId| self.scene.point_name(*p).expect("it has a name");
        points.iter().map(name).collect()
    }

    /// Returns the state at a coordinate, with its forces.
    pub(in crate::drawing) fn state(&self, at: f64) -> State {
        let mut state = self.solver.state();
        let _ = self.solver.solve(at, Order::Force, &mut state);
        state.into_state()
    }

    /// Returns the states of the whole motion in 200 steps.
    pub(in crate::drawing) fn motion(&self) -> impl Iterator<Item = State> {
        let start = self.scene.mechanism.driver().start;
        let (low, high) = match self.solver.motion().range {
            Range::Full { period } => (start, start + period),
            Range::Limited { low, high } => (low, high),
        };
        let mut state = self.solver.state();
        (0..=200).map(move |k| {
            let at = (low + (high - low) * f64::from(k) / 200.0).min(high);
            let condition = self.solver.solve(at, Order::Position, &mut state);
            assert_ne!(condition, Condition::NoAssembly, "{} at {at}", self.name);
            state.state().clone()
        })
    }
}
