//! Reports on many designs of a scene, and on searches for the best one.

pub(in crate::report) mod goals;
pub(in crate::report) mod summary;
pub(in crate::report) mod table;
