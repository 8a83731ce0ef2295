//! What the figure under the cursor does over the whole motion: found once for a figure and an edit.

use crate::page::Page;
use crate::quantity::Catalogue;
use crate::report::brief_cycle;
use crate::tui::player::edition::Edition;
use crate::tui::player::open_scene::OpenScene;

/// Stroke, turns, time ratio, dwell and rate of one figure, in a line each, and the page of all that it does.
#[derive(Debug, Default)]
pub(crate) struct ExcursionNote {
    of: Option<(Edition, String)>,
    lines: Vec<String>,
    page: Page,
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
