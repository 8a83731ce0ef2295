//! The ways to write a drawing: one table, a file each.

use super::DrawnScene;
use crate::cli::failure::Failure;
use crate::wording::Wording;

/// A way to write a drawing.
#[derive(Debug)]
pub(in crate::cli) struct DrawFormat {
    /// What `--format` calls it: a promise.
    pub(in crate::cli) name: &'static str,
    pub(in crate::cli) about: Wording,
    pub(super) write: fn(&DrawnScene<'_>) -> Result<Vec<u8>, Failure>,
}

/// All of them, as the help lists them.
pub(in crate::cli) static FORMATS: [&DrawFormat; 5] = [
    &super::text::FORMAT,
    &super::svg::FORMAT,
    &super::png::FORMAT,
    &super::gif::FORMAT,
    &super::cast::FORMAT,
];
