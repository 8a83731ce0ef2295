//! Writes drawings as documents: SVG, and DXF for CAD.

pub(super) mod dxf;
pub(super) mod machine_drawing;
pub(super) mod picture;
