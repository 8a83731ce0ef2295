//! The actions of the workbench, their keys, and input lines.

pub(crate) mod action;
pub(crate) mod key;
pub(crate) mod keymap;
pub(crate) mod keywords;
pub(crate) mod line;
pub(crate) mod list;
pub(crate) mod mouse;
pub(crate) mod view;
