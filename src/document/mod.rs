//! A document that a person wrote in TOML: typed access to its values, what is wrong with them and where, and
//! its text made harmless for a terminal.
//!
//! Scenes and the configuration are such documents: they differ in what their values mean, and in
//! nothing that is done here.

mod diagnostic;
mod harmless;
mod reader;
mod syntax;

pub(crate) use diagnostic::not_utf8;
pub use diagnostic::{Diagnostic, Diagnostics, Label};
pub use harmless::{harmless, is_harmful};
pub(crate) use reader::{Name, Reader, Span, Value, meant, quoted};
pub(crate) use syntax::parse;
