//! Where a sampled figure turns, and where exactly.

/// A place at which a figure is largest or smallest among its neighbours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremum {
    /// A maximum, or else a minimum.
    pub is_peak: bool,
    /// The driver's coordinate there, in degrees or in the scene's length unit.
    pub at: f64,
    /// What stands along x there.
    pub along: f64,
    /// The figure there.
    pub value: f64,
    /// Whether it is the largest of the maxima, or the smallest of the minima.
    pub is_extreme: bool,
}
