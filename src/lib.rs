//! krank: planar linkages with one input.
#![cfg_attr(test, allow(clippy::unwrap_used))]

pub mod angle;
pub mod cli;
pub mod drawing;
mod explain;
mod mechanism;
pub mod quantity;
pub mod report;
pub mod scene;
pub mod solver;
mod vec2;

pub use mechanism::{
    Body, Builder, Defect, Driver, Element, Input, Link, LinkId, Load, Mechanism, Member, Point,
    PointId, Slide, SlideId, Slider,
};
pub use vec2::Vec2;
