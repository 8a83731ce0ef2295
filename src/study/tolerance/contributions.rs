//! The first order: who contributes how much.

use super::tolerance_box::ToleranceBox;
use crate::quantity::Derivatives;
use crate::{Length, LinkId, PointId};

pub(super) type Slopes = Derivatives;

/// What is off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ToleranceOf {
    /// A length.
    Length(Length),
    /// A pin of a link in its hole.
    Pin(LinkId, PointId),
}

/// What one tolerance does to a figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contribution {
    /// Whose.
    pub of: ToleranceOf,
    /// How far that may be off, in the scene's unit of length.
    pub tolerance: f64,
    /// How the figure follows it, in its unit per unit of length; of a pin in the worst direction, not negative.
    pub slope: f64,
    /// What that does to the figure at the most.
    pub size: f64,
    /// Its part of the sum of squares.
    pub share: f64,
}

impl ToleranceBox {
    /// How far everything may be off, in its order.
    fn allowed(&self) -> impl Iterator<Item = f64> + '_ {
        let (lengths, pins) = self.limits.split_at(self.lengths);
        let pins = pins.chunks_exact(2).map(|pair| pair[0]);
        lengths.iter().copied().chain(pins)
    }

    /// What everything that is off does to a figure, in its order.
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

    /// Who contributes, the greatest first.
    pub(super) fn contributions(&self, slopes: &[f64]) -> Vec<Contribution> {
        let whole = self.root_sum_square(slopes);
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
                share: (size / whole).powi(2),
            })
            .collect();
        list.sort_by(|a, b| b.size.total_cmp(&a.size));
        list
    }
}
