//! krank: planar linkages with one input.
pub mod angle;
pub mod drawing;
mod mechanism;
pub mod quantity;
pub mod report;
pub mod scene;
pub mod solver;
#[cfg(feature = "tui")]
pub mod tui;
mod vec2;

pub use mechanism::{
    Body, Builder, Defect, Driver, Element, Input, Link, LinkId, Load, Mechanism, Member, Point,
    PointId, Slide, SlideId, Slider,
};
pub use vec2::Vec2;
