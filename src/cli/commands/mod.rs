//! The commands: each file has the arguments of a command and runs it.

pub(super) mod accuracy;
pub(super) mod check;
pub(super) mod cycle;
pub(super) mod draw;
pub(super) mod exercise;
pub(super) mod explain;
pub(super) mod export;
pub(super) mod grade;
pub(super) mod motor;
pub(super) mod plot;
pub(super) mod report;
pub(super) mod solve;
pub(super) mod study;
pub(super) mod sweep;
pub(super) mod synthesize;
pub(super) mod table;
pub(super) mod tolerance;
