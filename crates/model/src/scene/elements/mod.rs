//! The elements of a mechanism: links, places on them, slides, vectors and limits.

pub(super) mod drawn;
pub(super) mod frame;
pub(super) mod limits;
pub(super) mod link;
pub(super) mod link_points;
pub(super) mod points;
pub(super) mod redundant;
pub(super) mod slide;
pub(super) mod view;
