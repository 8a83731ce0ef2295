//! Comparing with another scene.

use super::super::Opened;
use super::App;
use crate::report::Tables;
use crate::tui::figures::sheet::Sheet;
use crate::tui::player::compared_scene::ComparedScene;
use crate::tui::views::picker::list::{PickerTarget, Purpose};
use crate::wording::words;

/// What the open scene is held against.
#[derive(Debug, Default)]
pub(super) struct Comparison {
    compared: Option<ComparedScene>,
    /// What was compared with last.
    last: Option<PickerTarget>,
}

impl Comparison {
    pub(super) fn compared(&self) -> Option<&ComparedScene> {
        self.compared.as_ref()
    }
}

impl App {
    /// Asks what to compare with, or ends it.
    pub(super) fn compare(&mut self) {
        if self.end_comparison() {
            self.sample();
            self.shell.say(words().no_longer_compared());
            return;
        }
        let edited = self.is_edited().then_some(PickerTarget::Original);
        let at = edited.or_else(|| self.comparison.last.clone());
        self.list(Purpose::Compare, at);
    }

    /// Holds a scene against the open one; in words why that cannot be.
    pub(super) fn compare_with(
        &mut self,
        place: PickerTarget,
        name: String,
        opened: Opened,
    ) -> Result<(), String> {
        self.comparison = Comparison {
            compared: Some(ComparedScene::new(name, opened, &self.player.open_scene)?),
            last: Some(place),
        };
        self.scroll_by(0);
        self.sample();
        self.shell.say(words().esc_ends_comparison());
        Ok(())
    }

    /// What is compared with goes where the open scene is, or is fitted to it anew after an edit.
    pub(super) fn follow(&mut self) {
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
            Err(why) => self.shell.say(why),
        }
        self.scroll_by(0);
    }

    /// Ends the comparison, if there is one.
    pub(super) fn end_comparison(&mut self) -> bool {
        let compared = self.comparison.compared.take().is_some();
        self.scroll_by(0);
        compared
    }

    /// The scene that the open one is held against.
    pub(crate) fn compared(&self) -> Option<&ComparedScene> {
        self.comparison.compared()
    }

    /// The columns of the tables: of figures, or while another scene is compared with, of differences.
    pub(crate) fn sheet(&self) -> &Sheet {
        self.compared()
            .map_or(self.player.open_scene.sheet(), ComparedScene::sheet)
    }

    /// The tables that are shown: figures, or differences.
    pub(crate) fn tables(&self) -> &Tables {
        self.compared()
            .map_or(self.player.open_scene.tables(), ComparedScene::tables)
    }

    /// What stands above tables of differences, as much of it as fits so many columns.
    pub(crate) fn difference_title(&self, width: usize) -> Option<String> {
        let compared = self.compared()?;
        let name = compared.name();
        if !compared.is_assembled() {
            return Some(words().has_no_assembly_here(name));
        }
        let mut title = words().this_less(name);
        let long = words().difference_from(name);
        if long.chars().count() <= width {
            title = long;
        }
        let speeds = compared
            .speeds(&self.player.open_scene)
            .map(|s| words().driven_at(&s));
        let there = compared.pairing().only_there();
        let there = (!there.is_empty()).then(|| words().only_there(&there.join(" ")));
        for part in speeds.into_iter().chain(there) {
            title = format!("{title}; {part}");
        }
        Some(title)
    }
}
