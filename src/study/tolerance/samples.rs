//! Machines made by chance: how figures are spread among many of them.

use super::machines::Machines;
use super::tolerance_box::ToleranceBox;
use crate::numeric::SeededChance;
use crate::solver::LoopKind;

/// How lengths are spread within their tolerances.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Distribution {
    /// Normally, the tolerance being three times the standard deviation; some three of a thousand lie beyond it.
    #[default]
    Normal,
    /// All within the tolerance as likely as each other.
    Even,
}

/// How many machines are made, and how.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SampleOrder {
    /// How many.
    pub count: u32,
    /// From which they follow: the same seed gives the same machines.
    pub seed: u64,
    /// How their lengths are spread.
    pub distribution: Distribution,
}

/// Of many machines, the figures below which so many parts of a thousand are: 1.35, 500 and 998.65, which in a normal
/// distribution are the mean and three standard deviations to both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Percentiles {
    /// 0.135 of a hundred are below.
    pub low: f64,
    /// As many below as above.
    pub median: f64,
    /// 99.865 of a hundred are below.
    pub high: f64,
    /// The least and the greatest of all.
    pub ends: [f64; 2],
    /// The mean of all.
    pub mean: f64,
    /// Their standard deviation.
    pub deviation: f64,
}

/// What became of the machines at one coordinate of the driver.
#[derive(Clone, Debug, PartialEq)]
pub struct Samples {
    /// Figure by figure; `None` where no machine has it.
    pub figures: Vec<Option<Percentiles>>,
    /// The part of the machines that do not close there.
    pub open: f64,
    /// The part of them whose first loop has another class than it was meant to; `None` where it has none.
    pub changed: Option<f64>,
}

/// Of all, the part below the lower and above the upper mark.
const TAIL: f64 = 0.00135;

impl Samples {
    /// Makes machines by chance, and reads every figure of each; `kind` is the class of the loop that is meant.
    pub(super) fn of(
        machines: &mut impl Machines,
        off: &ToleranceBox,
        figures: usize,
        kind: Option<LoopKind>,
        order: SampleOrder,
    ) -> Samples {
        let mut chance = SeededChance::new(order.seed);
        let mut by = off.nothing();
        let mut values = vec![None; figures];
        let mut read: Vec<Vec<f64>> = vec![Vec::new(); figures];
        let (mut open, mut changed) = (0_u32, 0_u32);
        for _ in 0..order.count {
            off.draw(order.distribution, &mut chance, &mut by);
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

/// What is to be said of many values, which are put into another order.
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
        low: below(TAIL)?,
        median: below(0.5)?,
        high: below(1.0 - TAIL)?,
        ends: [below(0.0)?, below(1.0)?],
        mean,
        deviation: (square / (count - 1.0).max(1.0)).sqrt(),
    })
}
