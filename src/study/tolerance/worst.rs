//! The worst case of a figure, and how it was found.

/// The least and the greatest that a figure can be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorstCase {
    /// The least; minus infinity where it grows beyond all bounds.
    pub low: f64,
    /// The greatest; infinity where it grows beyond all bounds.
    pub high: f64,
    /// What machines were found to reach: the same, or where it is enclosed or unbounded, further inside.
    pub reached: [f64; 2],
    /// How they were found.
    pub kind: WorstKind,
    /// Whether there are lengths within their tolerances with which it does not close here; the figures are of those
    /// with which it does.
    pub fails: bool,
}

/// How a worst case was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum WorstKind {
    /// By every corner of the box of lengths; nothing that was looked at inside goes further.
    Corners,
    /// All lengths together, in balls: no figure is outside, and the worst may be further inside.
    Enclosed,
    /// By a search: the figure goes both ways along a length, so that it may be worst inside of the box. Nothing proves
    /// that there is no worse.
    Searched,
    /// By a search up to where the figure ceases to exist: not every corner has it. Nothing proves that there is no
    /// worse.
    AtEdge,
    /// It grows beyond all bounds towards an edge of assembly: in one direction or in both. What is told of the other
    /// direction is an estimate.
    Unbounded,
    /// By the machines that the derivatives point to; nothing proves that there is no worse.
    Derivatives,
    /// By a machine made by chance, that goes further than all that was looked at before.
    Sampled,
}

impl WorstKind {
    /// Whether there may be worse, so that it is an estimate.
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
    /// Takes in what was found at edges of assembly.
    pub(super) fn extend(&mut self, furthest: [f64; 2], is_unbounded: [bool; 2]) {
        let goes_further = furthest[0] < self.low || furthest[1] > self.high;
        self.low = self.low.min(furthest[0]);
        self.high = self.high.max(furthest[1]);
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

    /// The same where machines were met that go further: then it is not the worst case that it was taken for.
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

/// What has been met.
#[derive(Clone, Copy, Debug)]
pub(super) struct MetRange {
    pub(super) low: f64,
    pub(super) high: f64,
}

impl MetRange {
    pub(super) fn of(value: f64) -> MetRange {
        MetRange {
            low: value,
            high: value,
        }
    }

    pub(super) fn meet(&mut self, value: f64) {
        self.low = self.low.min(value);
        self.high = self.high.max(value);
    }
}
