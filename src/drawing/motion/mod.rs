//! Parts of a drawing that depend on the whole motion: extents, traces, ghosts and arrows to one scale.

pub(super) mod extents;
pub(super) mod force_arrows;
pub(super) mod ghosts;
pub(super) mod motion_samples;
pub(super) mod overlay;
pub(super) mod poses;
pub(super) mod scale;
