/// The range that the driver can cover from the scene's assembly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Range {
    /// Full turns; the motion repeats after `period` degrees (360 or a multiple).
    Full {
        /// In degrees.
        period: f64,
    },
    /// Between two limits, in degrees or in the scene's length unit.
    Limited {
        /// The lower limit.
        low: f64,
        /// The upper limit.
        high: f64,
    },
    /// A slide that can be pushed without end.
    Endless,
}

/// The whole motion of a mechanism, found once.
#[derive(Clone, Debug)]
pub struct Motion {
    /// The driver's range.
    pub range: Range,
}
