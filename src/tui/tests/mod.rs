//! Tests of the workbench as a whole that see inside.

mod monkey;
