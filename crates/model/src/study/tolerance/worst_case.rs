//! The worst case of a value, and the method that found it.

/// The minimum and maximum of a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorstCase {
    /// The minimum; minus infinity if the value is unbounded below.
    pub low: f64,
    /// The maximum; infinity if the value is unbounded above.
    pub high: f64,
    /// The extreme values found in machines: equal to `low` and `high`, or inside of them for an
    /// enclosure or an unbounded value.
    pub reached: [f64; 2],
    /// The method that found the limits.
    pub kind: WorstKind,
    /// `true` if the machine does not close here for some lengths within the tolerances; the limits
    /// are those of the machines that close.
    pub fails: bool,
}

/// The method that found a worst case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WorstKind {
    /// All corners of the box of lengths; a check inside found no larger deviation.
    Corners,
    /// Ball arithmetic over all lengths. The limits contain all values; the worst case may be
    /// further inside.
    Enclosed,
    /// A search: the value is not monotonic along a length, so the worst case may be inside the
    /// box. Not proved.
    Searched,
    /// A search up to the edge where the value ceases to exist: some corners lack it. Not proved.
    AtEdge,
    /// The value grows without bound towards an edge of assembly, in one direction or both; the
    /// limit in the other direction is an estimate.
    Unbounded,
    /// The machines in the direction of the derivatives. Not proved.
    Derivatives,
    /// A random machine that exceeds all limits found before.
    Sampled,
}

impl WorstKind {
    /// Returns `true` if the worst case is an estimate, so that the true one may be worse.
    #[must_use]
    pub fn is_estimate(self) -> bool {
        match self {
            WorstKind::Corners | WorstKind::Enclosed => false,
            WorstKind::Searched
            | WorstKind::AtEdge
            | WorstKind::Unbounded
            | WorstKind::Derivatives
            | WorstKind::Sampled => true,
        }
    }
}

impl WorstCase {
    /// Extends the limits by values found at edges of assembly.
    pub(super) fn extend(&mut self, extreme: [f64; 2], is_unbounded: [bool; 2]) {
        let goes_further = extreme[0] < self.low || extreme[1] > self.high;
        self.low = self.low.min(extreme[0]);
        self.high = self.high.max(extreme[1]);
        self.reached = [self.low, self.high];
        match is_unbounded {
            [false, false] if goes_further && !self.kind.is_estimate() => {
                self.kind = WorstKind::AtEdge;
            }
            [false, false] => {}
            [below, above] => {
                self.kind = WorstKind::Unbounded;
                if below {
                    self.low = f64::NEG_INFINITY;
                }
                if above {
                    self.high = f64::INFINITY;
                }
            }
        }
    }

    /// Returns the worst case widened by sampled machines that exceed it.
    #[must_use]
    pub(super) fn widened(self, [low, high]: [f64; 2]) -> WorstCase {
        if self.low <= low && high <= self.high {
            return self;
        }
        let reached = [self.reached[0].min(low), self.reached[1].max(high)];
        let kind = match self.kind == WorstKind::Unbounded {
            true => self.kind,
            false => WorstKind::Sampled,
        };
        WorstCase {
            low: self.low.min(low),
            high: self.high.max(high),
            reached,
            kind,
            ..self
        }
    }
}

/// The range of the values found.
#[derive(Clone, Copy, Debug)]
pub(super) struct ObservedRange {
    pub(super) low: f64,
    pub(super) high: f64,
}

impl ObservedRange {
    pub(super) fn of(value: f64) -> ObservedRange {
        ObservedRange {
            low: value,
            high: value,
        }
    }

    pub(super) fn meet(&mut self, value: f64) {
        self.low = self.low.min(value);
        self.high = self.high.max(value);
    }
}
