//! Functions of one variable: where they are nought, and where they turn.
//!
//! Dead centres, extrema, peaks and limits are all found here. A function is asked for at a place and
//! answers `None` where it does not exist; what it stands for, nobody here knows.
//!
//! ```text
//! root       the root between two places where the signs differ, and all roots along many places
//! turns      at which of many samples a function turns, by more than noise
//! polynomial all real roots of a polynomial
//! lowest     the minimum around a place, by values alone
//! chance     numbers drawn by chance, the same for the same seed
//! chebyshev  a smooth function as a sum of polynomials, whose turns, roots and integral follow from it
//! ```
//!
//! Where a function is smooth and its slope is known, an extremum is a root of the slope, and as good as
//! any root; from values alone its place is known to half of the digits, since a function is level there.

mod chance;
pub mod chebyshev;
mod lowest;
mod polynomial;
mod root;
mod turns;

pub use chance::SeededChance;
pub use lowest::{Unsettled, lowest};
pub use polynomial::polynomial_roots;
pub use root::{NoRoot, few_decimals, root, roots};
pub use turns::turns;
