//! The numbers that everything is computed in: plane vectors, angles, and the arithmetics that the
//! solver's formulas are written over.
//!
//! A formula over [`Number`] gives with doubles the figures; with [`Lanes`] several at once, to the same
//! bits; with [`Ball`]s what they enclose; with [`Double`]s twice the digits; with [`Dual`]s their
//! derivatives by a length; with series their way through a change point. A [`Constant`] is a given number with what its rounding has cost.

pub mod angle;
mod ball;
mod constant;
mod decimal;
mod double;
mod dual;
mod halves;
mod lanes;
mod machine;
mod number;
pub(crate) mod plane;
mod series;
mod sharp;
mod vec2;

pub use ball::Ball;
pub(crate) use ball::{INFLATION, half_ulp};
pub use constant::Constant;
pub(crate) use constant::{TWICE, typed_radius};
pub use decimal::Decimal;
pub use double::Double;
pub use dual::Dual;
pub(crate) use halves::{Halves, Product};
pub use lanes::{LANES, Lanes};
pub use machine::vectorized;
pub(crate) use machine::{Fusing, fused, plainly};
pub use number::Number;
pub(crate) use series::{Series, TERMS};
pub use sharp::Sharp;
pub use vec2::Vec2;

/// The unit roundoff of a double, 2^-53: half an ulp of 1.
pub const U: f64 = 0.5 * f64::EPSILON;
