//! In place of the workbench, where krank is built without it.

use super::args::WorkbenchArgs;
use super::failure::Failure;

/// Says that there is none, and what to use instead.
pub(super) fn open(args: &WorkbenchArgs) -> Result<(), Failure> {
    let scene = args.scene.display();
    Err(Failure::Usage(format!(
        "this krank was built without the workbench (the feature `tui`); \
         `krank table {scene}` prints the tables"
    )))
}
