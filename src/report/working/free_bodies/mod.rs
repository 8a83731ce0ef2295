//! Writes the forces: loads, free bodies and pins.

pub(super) mod forces;
pub(super) mod free_body;
pub(super) mod free_body_drawing;
pub(super) mod knots;
pub(super) mod loads;
pub(super) mod pins;
pub(super) mod springs;
