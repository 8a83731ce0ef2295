//! Dispatches keys, the mouse and pasted text according to the mode.

pub(super) mod command_list;
pub(super) mod dragging;
pub(super) mod help_pages;
pub(super) mod key_dispatch;
pub(super) mod mode;
pub(super) mod pointing;
pub(super) mod tour;
