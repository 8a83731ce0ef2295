//! The TOML of a scene file.

use super::diagnostic::Diagnostic;
use super::reader::Reader;
use toml::de::DeTable;

/// Parses the text; `None` if it is not TOML.
pub(super) fn document<'t>(reader: &mut Reader<'t>) -> Option<DeTable<'t>> {
    let (root, errors) = DeTable::parse_recoverable(reader.text());
    for error in &errors {
        let fault = Diagnostic::new(error.message());
        let span = error.span().unwrap_or(0..0);
        reader.report(fault.at(span, ""));
    }
    errors.is_empty().then(|| root.into_inner())
}
