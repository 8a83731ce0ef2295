//! The scene as a text: edits and taking them back, its file, and what is kept of edits that are not saved.
//! What is done to files is done apart from the screen's thread, by the `clerk`.

pub(crate) mod clerk;
pub(crate) mod difference;
pub(crate) mod disk;
pub(crate) mod edited;
pub(crate) mod editor;
pub(crate) mod history;
pub(crate) mod opening;
pub(crate) mod recovery;
pub(crate) mod saving;
pub(crate) mod writing;
