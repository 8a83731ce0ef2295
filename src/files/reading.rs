//! Reading what somebody has named on the command line.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// What a name leads to holds, up to one byte more than `most`: pipes and devices too, which a person has
/// named on the command line and can leave by Ctrl-C.
///
/// # Errors
/// What the system says.
pub(crate) fn read_any(path: &Path, most: usize) -> io::Result<Vec<u8>> {
    limited(File::open(path)?, most)
}

/// Everything up to one byte more than `most`, so that endless input ends.
///
/// # Errors
/// What the system says.
pub(crate) fn limited(from: impl Read, most: usize) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let most = u64::try_from(most).unwrap_or(u64::MAX);
    from.take(most.saturating_add(1)).read_to_end(&mut bytes)?;
    Ok(bytes)
}
