//! The open scene solved where its driver stands, and how that moves.

pub(crate) mod assembly_list;
pub(crate) mod comparison;
pub(crate) mod cost;
pub(crate) mod driver_range;
pub(crate) mod edition;
pub(crate) mod next_singularity;
pub(crate) mod open_scene;
pub(crate) mod playback;
pub(crate) mod steps;
