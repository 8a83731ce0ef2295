//! Finds roots and extrema of functions of one variable.
//!
//! Dead centres, extrema, peaks and limits are all found here. A function is evaluated at a point
//! and returns `None` if it does not exist there. This module does not know its meaning.
//!
//! ```text
//! root             the root between two places where the signs differ, and all roots along many places
//! sampled_extrema  samples at which a function has an extremum, by more than noise
//! polynomial       all real roots of a polynomial
//! lowest           the minimum around a place, from values alone
//! random           random numbers, the same for the same seed
//! evolution        trial designs of a search without derivatives
//! damping          the damping of a least-squares search with derivatives
//! chebyshev        a smooth function as a sum of polynomials, with its extrema, roots and integral
//! ```
//!
//! If a function is smooth and its slope is known, an extremum is a root of the slope, and as
//! accurate as any root. From values alone, its position is known to half of the digits only,
//! because a function is flat there.

pub mod chebyshev;
mod damping;
mod evolution;
mod lowest;
mod polynomial;
mod random;
mod root;
mod sampled_extrema;

pub use damping::{DampedSearch, Trial};
pub use evolution::mutate;
pub use lowest::{MinimumError, lowest};
pub use polynomial::polynomial_roots;
pub use random::SeededRng;
pub use root::{RootError, few_decimals, root, roots};
pub use sampled_extrema::turns;
