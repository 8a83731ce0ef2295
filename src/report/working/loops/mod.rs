//! Finds the vector polygons of a scene, their sides, and the unknowns of each group in them.

pub(super) mod by_coordinates;
pub(super) mod chain;
pub(super) mod group_unknowns;
pub(super) mod loop_finder;
pub(super) mod polygon;
pub(super) mod sides;
pub(super) mod solution;
pub(super) mod vectors;
