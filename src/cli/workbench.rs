//! Opening the workbench.

use super::args::WorkbenchArgs;
use super::failure::Failure;

/// Without the feature `tui` there is none: says so, and what to use instead.
#[cfg(not(feature = "tui"))]
pub(super) fn open(args: &WorkbenchArgs) -> Result<(), Failure> {
    let scene = args.scene.display();
    Err(Failure::Usage(format!(
        "this krank was built without the workbench (the feature `tui`); \
         `krank table {scene}` prints the tables"
    )))
}

#[cfg(feature = "tui")]
pub(super) fn open(args: &WorkbenchArgs) -> Result<(), Failure> {
    let _ = args;
    todo!()
}
