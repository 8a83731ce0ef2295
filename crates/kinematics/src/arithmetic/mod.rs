//! Provides plane vectors, angles and the arithmetics over which the solver's formulas are written.
//!
//! A formula over [`Number`] can be evaluated in several arithmetics:
//!
//! - doubles give values;
//! - [`Lanes`] give several values at once, with the same bits;
//! - [`Ball`]s give enclosures;
//! - [`Double`]s give double-double precision;
//! - [`Dual`]s give derivatives by a length;
//! - series give the path through a change point.
//!
//! A [`Constant`] is a given number with a bound on its rounding error.

pub mod angle;
mod ball;
mod constant;
mod decimal;
mod double;
mod double_double_ball;
mod dual;
mod lanes;
mod machine;
mod number;
pub(crate) mod plane;
mod series;
mod split_factors;
mod vec2;

pub use ball::Ball;
pub(crate) use ball::{INFLATION, half_ulp};
pub use constant::Constant;
pub(crate) use constant::{DOUBLE_DOUBLE_ERROR, typed_radius};
pub use decimal::Decimal;
pub use double::Double;
pub use double_double_ball::Sharp;
pub use dual::Dual;
pub use lanes::{LANES, Lanes};
pub use machine::vectorized;
pub(crate) use machine::{Fusing, fused, plainly};
pub use number::Number;
pub(crate) use series::{Series, TERMS};
pub(crate) use split_factors::{Halves, Product};
pub use vec2::Vec2;

/// The unit roundoff of a double, 2^-53: half an ulp of 1.
pub const U: f64 = 0.5 * f64::EPSILON;
