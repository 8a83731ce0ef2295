//! Places the panes by the space that their contents need. The result is kept until something that
//! it depends on changes.

use super::{Composition, PaneNeeds, PlacedView};
use crate::drawing::Glyphs;
use crate::tui::app::{App, View};
use crate::tui::figures::sheet::SheetPart;
use crate::tui::player::scene_version::SceneRevision;
use crate::tui::views::{pane_area, tables};
use crate::wording::Language;
use ratatui::layout::{Rect, Size};
use std::cell::RefCell;

/// The placed panes, with everything that they depend on.
#[derive(Debug, Default)]
pub(crate) struct Placement {
    kept: RefCell<Option<(PlacementKey, Vec<PlacedView>)>>,
}

#[derive(Debug, PartialEq)]
struct PlacementKey {
    composition: Composition,
    view: View,
    size: Size,
    body: Rect,
    aspect: f64,
    glyphs: Glyphs,
    language: Language,
    scene: SceneRevision,
    is_compared: bool,
    is_led: bool,
    /// The number of vectors, of points, of values of the scene and of panels of the plot.
    rows: [usize; 4],
}

impl PlacementKey {
    fn of(app: &App) -> PlacementKey {
        let sheet = app.sheet();
        PlacementKey {
            composition: *app.composition(),
            view: app.view(),
            size: app.size(),
            body: pane_area(app),
            aspect: app.aspect(),
            glyphs: app.glyphs(),
            language: Language::current_language(),
            scene: app.open_scene().edition().clone(),
            is_compared: app.compared().is_some(),
            is_led: app.open_scene().led().is_some(),
            rows: [
                sheet.row_count(SheetPart::Vectors),
                sheet.row_count(SheetPart::Points),
                app.editor().values().len(),
                app.views.plots.plot().map_or(0, |plot| plot.panels.len()),
            ],
        }
    }
}

impl Placement {
    /// Returns the shown views and their areas.
    pub(in crate::tui::views) fn of(&self, app: &App) -> Vec<PlacedView> {
        let key = PlacementKey::of(app);
        if let Some((of, placed)) = &*self.kept.borrow()
            && *of == key
        {
            return placed.clone();
        }
        let (view, size) = (app.view(), app.size());
        let placed = (app.composition()).placed(view, size, key.body, &Contents(app));
        self.kept.replace(Some((key, placed.clone())));
        placed
    }
}

/// The contents of the panes.
struct Contents<'a>(&'a App);

impl PaneNeeds for Contents<'_> {
    fn rows(&self, view: View, width: u16) -> Option<u16> {
        let Contents(app) = self;
        let lines = match view {
            View::Tables => tables::min_lines(app, width),
            // A message takes the place of the plot.
            View::Plots if app.open_scene().led().is_some() => 2,
            View::Scene | View::Forces => {
                // The lines that are no values are those that a pane does not count as visible.
                let height = u16::MAX / 2;
                let (values, visible) = view
                    .pane_in(self.0)
                    .extent(app, Rect::new(0, 0, width, height));
                values + usize::from(height).saturating_sub(visible)
            }
            View::Plots => {
                let plot = app.views.plots.plot().ok()?;
                let fits = |rows: &u16| plot.panels_in(*rows) >= plot.panels.len();
                return (1..app.size().height).find(fits);
            }
            _ => return None,
        };
        u16::try_from(lines).ok()
    }
}
