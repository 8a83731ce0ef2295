//! Documents written in TOML: typed access to values, diagnostics with places, and text made safe
//! for a terminal.
//!
//! Scenes and the configuration are such documents. They differ only in the meaning of their
//! values.

mod balance;
mod diagnostic;
mod node;
mod reader;
mod sanitize;
mod syntax;

pub use diagnostic::{Diagnostic, Diagnostics, Label, not_utf8, utf8_text};
pub(crate) use node::number_of;
pub use node::{Entries, WrittenValue, entries, items};
pub use reader::{
    ByteSpan, DocumentKind, Name, NamedNumbers, Reader, is_probable_misspelling, quoted,
};
pub use sanitize::ascii_letter;
pub use sanitize::with_ascii_letters;
pub use sanitize::{is_harmful, sanitized};
pub use syntax::{first_with_point, foreign, has_decimal_comma, has_key, parse};
