//! Writing the scene to a file.

use super::disk::{BYTE_ORDER_MARK, unmarked};
use super::writing::why;
use crate::replace::replace_file;
use std::fs;
use std::io;
use std::path::Path;

/// Writes a scene's text: at once or not at all. To its `own` file with the byte order mark that this has,
/// and only if it still holds the text that is `expected`, where one is: where not, these are the `ways`
/// out. What was done, or why nothing was, in words.
pub(crate) fn save(
    text: &str,
    own: bool,
    expected: Option<&str>,
    to: &Path,
    ways: &str,
) -> Result<String, String> {
    let name = to.file_name().unwrap_or(to.as_os_str()).to_string_lossy();
    let mut bytes = Vec::new();
    if own {
        match fs::read(to) {
            Ok(now) => {
                if expected.is_some_and(|text| unmarked(&now) != text.as_bytes()) {
                    return Err(format!("not written, {name} has changed on disk: {ways}"));
                }
                if now.starts_with(BYTE_ORDER_MARK.as_bytes()) {
                    bytes.extend_from_slice(BYTE_ORDER_MARK.as_bytes());
                }
            }
            // It was taken away: there is nothing to lose.
            Err(e) if e.kind() == io::ErrorKind::NotFound => {}
            Err(e) => return Err(refused(&e, to)),
        }
    }
    bytes.extend_from_slice(text.as_bytes());
    match replace_file(to, &bytes) {
        Ok(()) => Ok(format!("written to {}", to.display())),
        Err(e) => Err(refused(&e, to)),
    }
}

/// Why nothing was written, and of what: of a folder that is not there, the folder.
fn refused(error: &io::Error, to: &Path) -> String {
    let missing = error.kind() == io::ErrorKind::NotFound;
    let named = match to.parent().filter(|_| missing) {
        Some(folder) => folder.to_string_lossy(),
        None => to.file_name().unwrap_or(to.as_os_str()).to_string_lossy(),
    };
    format!("not written, {}: {named}", why(error))
}
