//! Results at the driver's position, kept only while a view shows them.

use crate::quantity::DriverState;
use crate::tui::player::led_motion::LedMotion;
use crate::tui::player::open_scene::OpenScene;
use crate::tui::player::scene_version::SceneRevision;

/// The driver's state, and the time of a point that leads.
type Position = (DriverState, Option<f64>);

/// A result at the driver's position.
#[derive(Debug)]
pub(crate) struct LiveResult<R> {
    /// The result, with the scene and the position to which it belongs.
    kept: Option<(SceneRevision, Position, R)>,
}

impl<R> Default for LiveResult<R> {
    fn default() -> Self {
        LiveResult { kept: None }
    }
}

impl<R> LiveResult<R> {
    /// Moves the result to the driver's position in the open scene. Creates it if there is none for
    /// this scene, and drops it if it is not `wanted`.
    pub(crate) fn refresh(
        &mut self,
        wanted: bool,
        open_scene: &OpenScene,
        create: impl FnOnce(&OpenScene) -> Option<R>,
        move_on: fn(&mut R, &OpenScene),
    ) {
        let scene = open_scene.edition();
        let time = open_scene.led().map(LedMotion::time);
        let position = (*open_scene.driver_state(), time);
        match &mut self.kept {
            Some((of, at, result)) if wanted && of == scene => {
                if *at != position {
                    move_on(result, open_scene);
                    *at = position;
                }
            }
            kept => {
                let created = wanted.then(|| create(open_scene)).flatten();
                *kept = created.map(|result| (scene.clone(), position, result));
            }
        }
    }

    /// Drops the result, for example because its language has changed.
    pub(crate) fn forget(&mut self) {
        self.kept = None;
    }

    pub(crate) fn get(&self) -> Option<&R> {
        self.kept.as_ref().map(|(.., result)| result)
    }

    pub(crate) fn get_mut(&mut self) -> Option<&mut R> {
        self.kept.as_mut().map(|(.., result)| result)
    }
}
