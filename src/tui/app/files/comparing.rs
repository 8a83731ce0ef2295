//! Compares the open scene with another one.

use super::super::OpenedScene;
use crate::report::Tables;
use crate::tui::app::{App, BackTarget};
use crate::tui::figures::sheet::Sheet;
use crate::tui::player::compared_scene::ComparedScene;
use crate::tui::views::scene_picker::list::{PickerTarget, Purpose};
use crate::wording::words;

/// The scene compared with the open one.
#[derive(Debug, Default)]
pub(in crate::tui::app) struct Comparison {
    compared: Option<ComparedScene>,
    /// The scene of the last comparison.
    last: Option<PickerTarget>,
}

impl Comparison {
    pub(in crate::tui::app) fn compared(&self) -> Option<&ComparedScene> {
        self.compared.as_ref()
    }
}

impl App {
    /// Lets the user pick a scene to compare with, or ends a running comparison.
    pub(in crate::tui::app) fn compare(&mut self) {
        if self.end_comparison() {
            self.sample();
            self.set_message(words().no_longer_compared());
            return;
        }
        let edited = self.is_edited().then_some(PickerTarget::Original);
        let at = edited.or_else(|| self.comparison.last.clone());
        self.list(Purpose::Compare, at);
    }

    /// Starts a comparison of the open scene with another one. Returns a message if the two cannot
    /// be compared.
    pub(in crate::tui::app) fn compare_with(
        &mut self,
        place: PickerTarget,
        name: String,
        opened: OpenedScene,
    ) -> Result<(), String> {
        // The scenes are compared at one coordinate of their drivers.
        self.take_by_hand();
        self.comparison = Comparison {
            compared: Some(ComparedScene::new(name, opened, &self.player.open_scene)?),
            last: Some(place),
        };
        self.scroll_by(0);
        self.sample();
        if self.back_target() == BackTarget::Comparison {
            self.set_message(words().esc_ends_comparison());
        }
        Ok(())
    }

    /// Moves the compared scene to the open scene's coordinate. After an edit, it is first matched
    /// to the open scene again.
    pub(in crate::tui::app) fn follow(&mut self) {
        let Some(mut compared) = self.comparison.compared.take() else {
            return;
        };
        if compared.fits(&self.player.open_scene) {
            compared.follow(&self.player.open_scene);
            self.comparison.compared = Some(compared);
            return;
        }
        match compared.again(&self.player.open_scene) {
            Ok(compared) => self.comparison.compared = Some(compared),
            Err(why) => self.set_message(why),
        }
        self.scroll_by(0);
    }

    /// Ends the comparison. Returns `true` if there was one.
    pub(in crate::tui::app) fn end_comparison(&mut self) -> bool {
        let compared = self.comparison.compared.take().is_some();
        self.scroll_by(0);
        compared
    }

    /// Returns the scene compared with the open one; `None` while a point leads, which has no
    /// common coordinate with the other scene.
    pub(crate) fn compared(&self) -> Option<&ComparedScene> {
        let is_led = self.player.open_scene.led().is_some();
        self.comparison.compared().filter(|_| !is_led)
    }

    /// Returns the columns of the tables: values, or differences during a comparison.
    pub(crate) fn sheet(&self) -> &Sheet {
        self.compared()
            .map_or(self.player.open_scene.sheet(), ComparedScene::sheet)
    }

    /// Returns the shown tables: values, or differences during a comparison.
    pub(crate) fn tables(&self) -> &Tables {
        self.compared()
            .map_or(self.player.open_scene.tables(), ComparedScene::tables)
    }

    /// Returns the title above tables of differences, in a shorter form if `width` columns require
    /// it.
    pub(crate) fn difference_title(&self, width: usize) -> Option<String> {
        let compared = self.compared()?;
        let name = compared.name();
        if !compared.is_assembled() {
            return Some(words().has_no_assembly_here(name));
        }
        let speeds = compared.speeds(&self.player.open_scene);
        let driven_at = speeds.as_ref().map(|speeds| words().driven_at(speeds));
        let there = compared.pairing().only_there();
        let there = (!there.is_empty()).then(|| words().only_there(&there.join(" ")));
        let (long, short) = (words().difference_from(name), words().this_less(name));
        let joined = |parts: [Option<&String>; 3]| {
            let parts: Vec<&str> = parts.into_iter().flatten().map(String::as_str).collect();
            parts.join("; ")
        };
        // All rates depend on the speeds, so that these are never cut off.
        let forms = [
            joined([Some(&long), driven_at.as_ref(), there.as_ref()]),
            joined([Some(&short), driven_at.as_ref(), there.as_ref()]),
            joined([speeds.as_ref(), Some(&short), there.as_ref()]),
        ];
        let [.., shortest] = &forms;
        let fits = |form: &&String| form.chars().count() <= width;
        Some(forms.iter().find(fits).unwrap_or(shortest).clone())
    }
}
