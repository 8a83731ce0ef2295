//! What the figure under the cursor does over the whole motion: found once for a figure and an edit.

use crate::quantity::Catalogue;
use crate::report::brief_cycle;
use crate::tui::player::edition::Edition;
use crate::tui::player::open_scene::OpenScene;

/// Stroke, turns, time ratio, dwell and rate of one figure, in a line each.
#[derive(Debug, Default)]
pub(crate) struct ExcursionNote {
    of: Option<(Edition, String)>,
    lines: Vec<String>,
}

impl ExcursionNote {
    /// Follows a figure of the open scene, if that was not done yet.
    pub(crate) fn follow(&mut self, open_scene: &OpenScene, name: Option<&str>) {
        let of = name.map(|name| (open_scene.edition().clone(), name.to_owned()));
        if self.of == of {
            return;
        }
        let scene = open_scene.scene();
        let quantity = name.and_then(|name| Catalogue::new(scene).find(name));
        self.lines = quantity.map_or_else(Vec::new, |quantity| {
            brief_cycle(scene, open_scene.solver(), &quantity)
        });
        self.of = of;
    }

    pub(crate) fn lines(&self) -> &[String] {
        &self.lines
    }
}
