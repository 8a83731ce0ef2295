//! The numbers that everything is computed in: plane vectors, angles, and the arithmetics that the
//! solver's formulas are written over.

pub mod angle;
mod ball;
mod double;
mod number;
mod vec2;

pub use ball::Ball;
pub use double::Double;
pub(crate) use double::{two_product, two_sum};
pub use number::Number;
pub use vec2::Vec2;
