//! Summarizes the selected quantity over the whole motion, once per quantity and scene revision.

use crate::page::Page;
use crate::quantity::Catalogue;
use crate::report::brief_cycle;
use crate::tui::player::open_scene::OpenScene;
use crate::tui::player::scene_version::SceneRevision;

/// Stroke, turns, time ratio, dwell and rate of a quantity, one line each, and the full summary as
/// a page.
#[derive(Debug, Default)]
pub(crate) struct ExcursionNote {
    of: Option<(SceneRevision, String)>,
    lines: Vec<String>,
    page: Page,
}

impl ExcursionNote {
    /// Summarizes a quantity of the open scene, unless it is cached.
    pub(crate) fn follow(&mut self, open_scene: &OpenScene, name: Option<&str>) {
        let of = name.map(|name| (open_scene.edition().clone(), name.to_owned()));
        if self.of == of {
            return;
        }
        let scene = open_scene.scene();
        let quantity = name.and_then(|name| Catalogue::new(scene).find(name));
        let found = quantity.map(|quantity| brief_cycle(scene, open_scene.solver(), &quantity));
        (self.lines, self.page) = found.unwrap_or_default();
        self.of = of;
    }

    pub(crate) fn lines(&self) -> &[String] {
        &self.lines
    }

    pub(crate) fn page(&self) -> &Page {
        &self.page
    }
}
