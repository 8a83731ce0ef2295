//! Reports on the effect of tolerances.

pub(in crate::report) mod answers;
pub(in crate::report) mod report;
pub(in crate::report) mod rows;
