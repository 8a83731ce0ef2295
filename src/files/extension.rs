//! Recognizes file name extensions of other programs' formats.

use std::path::Path;

/// Extensions of documents, spreadsheets and pictures that krank does not write as text.
const FOREIGN: [&str; 19] = [
    "doc", "docx", "gif", "jpeg", "jpg", "key", "ods", "odt", "pdf", "png", "ppt", "pptx", "ps",
    "rtf", "webp", "xls", "xlsm", "xlsx", "zip",
];

/// Returns the extension of a file in lower case, if a text under this name could not be opened by
/// the program that the extension selects.
pub(crate) fn foreign_extension(path: &Path) -> Option<String> {
    let extension = path.extension()?.to_str()?.to_ascii_lowercase();
    FOREIGN.contains(&&*extension).then_some(extension)
}
