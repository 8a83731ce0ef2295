//! Reads what drawings show when the scene opens.

use crate::document::WrittenValue;
use crate::scene::keys;
use crate::scene::numbers::reader::{Name, Reader};
use crate::wording::words;

const EXAMPLE: &str = r#"{ traces = ["T"] }"#;
const TRACES: &str = r#"["T"]"#;

/// The names of the points with traces.
#[derive(Debug, Default)]
pub(crate) struct DraftView<'t> {
    pub(crate) traces: Vec<Name<'t>>,
}

/// Reads the section.
pub(crate) fn read<'v>(reader: &mut Reader<'_>, value: &'v WrittenValue<'v>) -> DraftView<'v> {
    let names = ["[view]"; 2];
    let Some(table) = reader.open(names, keys::VIEW, EXAMPLE, value) else {
        return DraftView::default();
    };
    reader.only_known(&table);
    let what = table.what(reader, "traces");
    let Some(value) = table.get("traces") else {
        return DraftView::default();
    };
    let items = reader.list(&what, words().a_list_of_points(), TRACES, value);
    let items = items.unwrap_or_default();
    let names = items.iter().filter_map(|item| reader.string(&what, item));
    DraftView {
        traces: names.collect(),
    }
}
