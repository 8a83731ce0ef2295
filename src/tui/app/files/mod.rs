//! Opens, compares, saves and exports files, and recovers unsaved edits.

pub(super) mod comparing;
pub(super) mod export;
pub(super) mod file_watch;
pub(super) mod quitting;
pub(super) mod recovery;
pub(super) mod save_prompts;
pub(super) mod saving;
pub(super) mod scene_change;
pub(super) mod scene_picker;
