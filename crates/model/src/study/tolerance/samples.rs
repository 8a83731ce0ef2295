//! Random machines: the distribution of values among them.

use super::machines::Machines;
use super::tolerance_box::ToleranceBox;
use crate::numeric::SeededRng;
use crate::solver::LoopKind;

/// The distribution of lengths within their tolerances.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Distribution {
    /// Normal, with the tolerance at three standard deviations; about three of a thousand lie
    /// beyond it.
    #[default]
    Normal,
    /// Uniform within the tolerance.
    Even,
}

/// The parameters of a sampling.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SampleOrder {
    /// The number of machines.
    pub count: u32,
    /// The seed of the random numbers; equal seeds give equal machines.
    pub seed: u64,
    /// The distribution of the lengths.
    pub distribution: Distribution,
}

/// Percentiles of many machines: 0.135 %, 50 % and 99.865 %. In a normal distribution these are the
/// mean and three standard deviations to both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Percentiles {
    /// The 0.135 % quantile.
    pub low: f64,
    /// The median.
    pub median: f64,
    /// The 99.865 % quantile.
    pub high: f64,
    /// The minimum and maximum.
    pub ends: [f64; 2],
    /// The mean.
    pub mean: f64,
    /// The standard deviation.
    pub deviation: f64,
}

/// The results of machines at one coordinate of the driver.
#[derive(Clone, Debug, PartialEq)]
pub struct Samples {
    /// The percentiles of each value; `None` if every machine lacks it.
    pub figures: Vec<Option<Percentiles>>,
    /// The fraction of machines that do not close.
    pub open: f64,
    /// The fraction of machines with another class of the first loop than the nominal one; `None`
    /// if that has no class.
    pub changed: Option<f64>,
}

/// The probability below the lower and above the upper percentile.
const TAIL_PROBABILITY: f64 = 0.00135;

impl Samples {
    /// Builds random machines, and evaluates every value of each; `kind` is the nominal class of
    /// the first loop.
    pub(super) fn of(
        machines: &mut impl Machines,
        off: &ToleranceBox,
        figures: usize,
        kind: Option<LoopKind>,
        order: SampleOrder,
    ) -> Samples {
        let mut rng = SeededRng::new(order.seed);
        let mut by = off.nothing();
        let mut values = vec![None; figures];
        let mut read: Vec<Vec<f64>> = vec![Vec::new(); figures];
        let (mut open, mut changed) = (0_u32, 0_u32);
        for _ in 0..order.count {
            off.draw(order.distribution, &mut rng, &mut by);
            let closes = machines.make(&by, &mut values);
            changed += u32::from(machines.kind() != kind);
            open += u32::from(!closes);
            for (all, value) in read.iter_mut().zip(&values) {
                all.extend(*value);
            }
        }
        let part = |count: u32| f64::from(count) / f64::from(order.count.max(1));
        Samples {
            figures: read.iter_mut().map(|all| percentiles(all)).collect(),
            open: part(open),
            changed: kind.map(|_| part(changed)),
        }
    }
}

/// Computes the statistics of some values, which are reordered.
fn percentiles(all: &mut [f64]) -> Option<Percentiles> {
    let count = all.len() as f64;
    let mean = all.iter().sum::<f64>() / count;
    let square = all.iter().map(|v| (v - mean).powi(2)).sum::<f64>();
    let mut below = |part: f64| {
        let place = (part * (count - 1.0)).round();
        let place = (0..all.len()).nth(place as usize)?;
        Some(*all.select_nth_unstable_by(place, f64::total_cmp).1)
    };
    Some(Percentiles {
        low: below(TAIL_PROBABILITY)?,
        median: below(0.5)?,
        high: below(1.0 - TAIL_PROBABILITY)?,
        ends: [below(0.0)?, below(1.0)?],
        mean,
        deviation: (square / (count - 1.0).max(1.0)).sqrt(),
    })
}
