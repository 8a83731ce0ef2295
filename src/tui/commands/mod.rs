//! What can be asked of the workbench, by which key, and lines that are typed.

pub(crate) mod action;
pub(crate) mod key;
pub(crate) mod keymap;
pub(crate) mod keywords;
pub(crate) mod line;
pub(crate) mod mouse;
pub(crate) mod view;
