//! First-order tolerance analysis: the contributions to a value's deviation.

use super::tolerance_box::ToleranceBox;
use crate::quantity::Derivatives;
use crate::{Length, LinkId, PointId};

pub(super) type Slopes = Derivatives;

/// The source of a deviation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ToleranceOf {
    /// A length.
    Length(Length),
    /// The clearance of a link's pin in its hole.
    Pin(LinkId, PointId),
}

/// The effect of one tolerance on a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contribution {
    /// The source.
    pub of: ToleranceOf,
    /// The tolerance, in the scene's unit of length.
    pub tolerance: f64,
    /// The derivative of the value, in its unit per unit of length; for a pin in the worst
    /// direction, not negative.
    pub slope: f64,
    /// The maximum effect on the value.
    pub size: f64,
    /// The share of the sum of squares.
    pub share: f64,
}

impl ToleranceBox {
    /// Returns the tolerance of each source, in order.
    fn allowed(&self) -> impl Iterator<Item = f64> + '_ {
        let (lengths, pins) = self.limits.split_at(self.lengths);
        let pins = pins.chunks_exact(2).map(|pair| pair[0]);
        lengths.iter().copied().chain(pins)
    }

    /// Returns the slope and the maximum effect of each source on a value, in order.
    fn sizes<'s>(&'s self, slopes: &'s [f64]) -> impl Iterator<Item = (f64, f64)> + 's {
        let (lengths, pins) = slopes.split_at(self.lengths);
        let (limits, of_pins) = self.limits.split_at(self.lengths);
        let alone = lengths.iter().zip(limits);
        let alone = alone.map(|(&slope, &by)| (slope, slope.abs() * by));
        let pairs = pins.chunks_exact(2).zip(of_pins.chunks_exact(2));
        alone.chain(pairs.map(|(slopes, by)| {
            let slope = slopes[0].hypot(slopes[1]);
            (slope, slope * by[0])
        }))
    }

    pub(super) fn root_sum_square(&self, slopes: &[f64]) -> f64 {
        self.sizes(slopes)
            .map(|(_, size)| size * size)
            .sum::<f64>()
            .sqrt()
    }

    /// Returns the contributions, the largest first.
    pub(super) fn contributions(&self, slopes: &[f64]) -> Vec<Contribution> {
        let complete = self.root_sum_square(slopes);
        let of = self.of.iter().zip(self.allowed());
        let matters = of
            .zip(self.sizes(slopes))
            .filter(|(_, (_, size))| *size > 0.0);
        let mut list: Vec<_> = matters
            .map(|((&of, tolerance), (slope, size))| Contribution {
                of,
                tolerance,
                slope,
                size,
                share: (size / complete).powi(2),
            })
            .collect();
        list.sort_by(|a, b| b.size.total_cmp(&a.size));
        list
    }
}
