//! Previews of scenes, files and folders before they are opened.

use crate::drawing::Extents;
use crate::report::fixed;
use crate::report::wanted;
use crate::scene::{Diagnostics, MAX_FILE_SIZE, Scene, presets};
use crate::solver::{Order, Range, Solver, State};
use crate::tui::document::opening::{self, OpenFileError, OpenedFile};
use crate::tui::player::driver_range::DriverRange;
use crate::tui::views::scene_picker::folder::{Folder, name_of};
use crate::tui::views::scene_picker::list::PickerTarget;
use crate::tui::{OpenedScene, Origin};
use crate::wording::words;
use std::fs;
use std::path::Path;

/// Maximum size of a previewed file. A larger one could take longer than the time between two keys,
/// so it is opened only on request.
const MAX_SIZE: u64 = 32 << 10;
/// Number of cached previews, so that moving back and forth costs nothing.
const MAX_CACHED_PREVIEWS: usize = 24;

/// The preview of an entry.
#[derive(Debug)]
pub(crate) enum Preview {
    /// A scene that opens without faults.
    Scene(Box<Sample>),
    /// A file that cannot be opened.
    Fault(Unopenable),
    /// The names of a folder's entries.
    Folder(Vec<String>),
    /// The reason why there is no preview yet.
    Unseen(String),
}

/// A scene solved at its start position.
#[derive(Debug)]
pub(crate) struct Sample {
    pub(crate) scene: Scene,
    pub(crate) reach: Extents,
    pub(crate) state: State,
    /// The parts, such as `4 links, 1 slide, unit mm`.
    pub(crate) parts: String,
    /// The driver's range, such as `r2 turns fully`.
    pub(crate) range: String,
}

/// The reason why a file cannot be opened.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Unopenable {
    /// The first fault.
    pub(crate) what: String,
    /// Line and column of the fault, counted from 1.
    pub(crate) at: Option<(usize, usize)>,
    /// The fix, if one is known.
    pub(crate) fix: Option<String>,
    /// Number of further faults.
    pub(crate) more: usize,
}

/// The cached previews, the most recent ones last.
#[derive(Debug, Default)]
pub(crate) struct Previews {
    cache: Vec<(PickerTarget, Preview)>,
}

impl Previews {
    /// Reserves the preview of an entry; returns `true` if it must be made, `false` if it exists or
    /// is being made.
    pub(crate) fn expect(&mut self, place: &PickerTarget) -> bool {
        let is_new = self.of(place).is_none();
        if is_new {
            if self.cache.len() == MAX_CACHED_PREVIEWS {
                self.cache.remove(0);
            }
            self.cache
                .push((place.clone(), Preview::Unseen(words().being_read().into())));
        }
        is_new
    }

    /// Stores a finished preview, unless its entry has been dropped from the cache.
    pub(crate) fn put(&mut self, place: &PickerTarget, preview: Preview) {
        let expected = self.cache.iter_mut().find(|(known, _)| known == place);
        if let Some((_, made)) = expected {
            *made = preview;
        }
    }

    /// Returns the preview of an entry, if it was reserved or made.
    pub(crate) fn of(&self, place: &PickerTarget) -> Option<&Preview> {
        let made = self.cache.iter().find(|(known, _)| known == place);
        made.map(|(_, preview)| preview)
    }

    /// Drops all previews, because files may change while the picker is closed.
    pub(crate) fn forget(&mut self) {
        self.cache.clear();
    }
}

impl Preview {
    /// Makes the preview of an entry, which may take long. `original` is the text of the open
    /// scene's original version.
    pub(crate) fn of(place: &PickerTarget, original: &str) -> Preview {
        match place {
            PickerTarget::Folder(path) => of_folder(path),
            PickerTarget::File(path) => of_file(path),
            PickerTarget::Original => of_text(original, ""),
            PickerTarget::Candidates => Preview::Unseen(words().found_before().into()),
            PickerTarget::Preset(name) => {
                let text = presets::find(name).map_or("", |preset| preset.text);
                of_text(text, name)
            }
        }
    }
}

fn of_text(text: &str, name: &str) -> Preview {
    match opening::text(text, Origin::Preset(name.to_owned())) {
        Ok(opened) => Preview::Scene(Box::new(Sample::of(opened))),
        Err(diagnostics) => Preview::Fault(Unopenable::first_of(&diagnostics)),
    }
}

fn of_file(path: &Path) -> Preview {
    let size = fs::metadata(path).map_or(0, |file| if file.is_file() { file.len() } else { 0 });
    // Opening a file too large for any scene fails below, without reading it to its end.
    if (MAX_SIZE + 1..=MAX_FILE_SIZE as u64).contains(&size) {
        let size = size.div_ceil(1 << 10);
        return Preview::Unseen(words().too_large_for_preview(size));
    }
    match opening::file(path) {
        Ok(OpenedFile::Scene(opened)) => Preview::Scene(Box::new(Sample::of(*opened))),
        Ok(OpenedFile::Task(order)) => {
            Preview::Unseen(words().task_in_preview(&wanted(&order.file.task)))
        }
        Err(OpenFileError::Wrong(diagnostics)) => {
            Preview::Fault(Unopenable::first_of(&diagnostics))
        }
        Err(unread @ OpenFileError::Unread(_)) => Preview::Fault(Unopenable {
            what: unread.first_words(),
            at: None,
            fix: None,
            more: 0,
        }),
    }
}

fn of_folder(path: &Path) -> Preview {
    match Folder::read(path) {
        Ok(found) => {
            let folders = found.folders.iter().map(|p| format!("{}/", name_of(p)));
            let scenes = found.scenes.iter().map(|p| name_of(p));
            Preview::Folder(folders.chain(scenes).collect())
        }
        Err(why) => Preview::Unseen(words().cannot_be_read(&why)),
    }
}

impl Sample {
    fn of(opened: OpenedScene) -> Sample {
        let OpenedScene { scene, solver, .. } = opened;
        let mut state = solver.state();
        let start = scene.mechanism.driver().start;
        let _ = solver.solve(start, Order::Position, &mut state);
        Sample {
            reach: Extents::of(&scene, &solver),
            parts: parts(&scene),
            range: range(&scene, &solver),
            state: state.into_state(),
            scene,
        }
    }
}

impl Unopenable {
    fn first_of(diagnostics: &Diagnostics) -> Unopenable {
        let first = diagnostics.items.first();
        Unopenable {
            what: diagnostics.first_words().to_owned(),
            at: first.and_then(|item| diagnostics.position(item)),
            fix: first.and_then(|item| item.suggestions.first().cloned()),
            more: diagnostics.items.len().saturating_sub(1),
        }
    }
}

fn parts(scene: &Scene) -> String {
    let mechanism = &scene.mechanism;
    let (links, slides) = (mechanism.links().len(), mechanism.slides().len());
    let links = (links > 0).then(|| words().count_of_links(links));
    let slides = (slides > 0).then(|| words().count_of_slides(slides));
    let mut parts: Vec<String> = links.into_iter().chain(slides).collect();
    parts.push(words().unit(scene.unit.symbol()));
    parts.join(", ")
}

fn range(scene: &Scene, solver: &Solver) -> String {
    let driver = scene.mechanism.driver().input;
    let (name, unit) = (scene.input_name(driver), scene.input_unit(driver));
    match solver.motion().range {
        Range::Full { period } if period > crate::angle::TURN => {
            words().turns_fully_and_repeats(name, &period)
        }
        Range::Full { .. } => words().turns_fully(name),
        Range::Limited { low, high } => {
            let decimals = DriverRange::new(scene, solver).decimals();
            let [low, high] = [low, high].map(|end| fixed(end, decimals));
            words().moves_between(name, &low, &high, unit)
        }
    }
}
