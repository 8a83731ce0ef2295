//! Plans of designs: a grid, or a Latin hypercube. Each design has a number, so that any part of a
//! plan can be computed separately and repeated.

use crate::numeric::SeededRng;
use crate::scene::{entries_with_numbers, with_point};
use crate::wording::words;
use std::str::FromStr;
use thiserror::Error;

/// A value that varies: `a=90..110/21`, from 90 to 110 in 21 places; `a=100` or `a` is constant.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanAxis {
    /// The name of the value.
    pub name: String,
    /// The bounds; `None` for a constant value.
    pub ends: Option<[f64; 2]>,
    /// The number of places, if given.
    pub count: Option<u32>,
}

/// An error in the text of an axis.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum MistypedAxis {
    /// The text is not a range.
    #[error("{}", words().no_axis(.0))]
    Form(String),
    /// The decimal mark of a number is ambiguous.
    #[error("{}", words().typed_two_marks(.0))]
    TwoMarks(String),
}

impl PlanAxis {
    /// Parses a list, separated by commas. Numbers may have a decimal comma: `a=1,5..2,5/3, b`.
    ///
    /// # Errors
    /// Returns an error if one of them is not a range.
    pub fn listed(list: &str) -> Result<Vec<PlanAxis>, MistypedAxis> {
        let entries = entries_with_numbers(list);
        entries.iter().map(|entry| entry.parse()).collect()
    }
}

impl FromStr for PlanAxis {
    type Err = MistypedAxis;

    fn from_str(text: &str) -> Result<PlanAxis, MistypedAxis> {
        let wrong = || MistypedAxis::Form(text.to_owned());
        let number = |typed: &str| {
            let unclear = || MistypedAxis::TwoMarks(typed.trim().to_owned());
            let number = with_point(typed).ok_or_else(unclear)?.parse::<f64>();
            number.ok().filter(|v| v.is_finite()).ok_or_else(wrong)
        };
        let named = |axis: PlanAxis| match axis.name.is_empty() {
            true => Err(wrong()),
            false => Ok(axis),
        };
        let Some((name, rest)) = text.split_once('=') else {
            let name = text.trim().to_owned();
            return named(PlanAxis {
                name,
                ends: None,
                count: None,
            });
        };
        let (ends, count) = match rest.split_once('/') {
            Some((ends, count)) => {
                let count = count.trim().parse::<u32>().ok().filter(|&count| count > 0);
                (ends, Some(count.ok_or_else(wrong)?))
            }
            None => (rest, None),
        };
        let (low, high) = ends.split_once("..").ok_or_else(wrong)?;
        named(PlanAxis {
            name: name.trim().to_owned(),
            ends: Some([number(low)?, number(high)?]),
            count,
        })
    }
}

/// Places along a value.
#[derive(Clone, Debug, PartialEq)]
struct PlanPlaces {
    ends: [f64; 2],
    count: u32,
}

impl PlanPlaces {
    /// Returns a place between the ends as a decimal of 15 digits: 0.3 and not 0.30000000000000004.
    fn at(&self, part: f64) -> f64 {
        let [low, high] = self.ends;
        let place = low + (high - low) * part;
        let size = low.abs().max(high.abs());
        let digits = if size > 0.0 {
            14 - size.log10().floor() as i32
        } else {
            0
        };
        let decimal = format!("{place:.*}", digits.clamp(0, 300) as usize);
        decimal.parse().unwrap_or(place)
    }
}

/// A plan of designs, by number.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignPlan {
    axes: Vec<PlanPlaces>,
    /// The part of each axis in which a design lies, for a Latin hypercube; `None` for a grid.
    parts: Option<Vec<Vec<u32>>>,
    count: u64,
}

/// Default number of places.
const DEFAULT_PLACES: u32 = 11;

impl DesignPlan {
    /// Creates a plan of all combinations, with the last axis varying fastest. An axis without ends
    /// keeps its given value.
    #[must_use]
    pub fn grid(axes: &[PlanAxis], given: &[f64]) -> DesignPlan {
        let axes = places(axes, given);
        let counts = axes.iter().map(|axis| u64::from(axis.count));
        DesignPlan {
            count: counts.fold(1, u64::saturating_mul),
            axes,
            parts: None,
        }
    }

    /// Creates a plan of `count` random designs, such that each of `count` parts of every axis
    /// contains one design.
    #[must_use]
    pub fn latin(axes: &[PlanAxis], given: &[f64], count: u32, seed: u64) -> DesignPlan {
        let mut rng = SeededRng::new(seed);
        let axes = places(axes, given);
        let parts = axes.iter().map(|_| shuffled(count, &mut rng)).collect();
        DesignPlan {
            axes,
            parts: Some(parts),
            count: u64::from(count),
        }
    }

    /// Returns the number of designs.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Returns the number of places of each axis.
    pub fn places(&self) -> impl Iterator<Item = u32> {
        self.axes.iter().map(|axis| axis.count)
    }

    /// Returns the numbers of a design.
    #[must_use]
    pub fn numbers(&self, design: u64) -> Vec<f64> {
        match &self.parts {
            Some(parts) => {
                let axes = self.axes.iter().zip(parts);
                let place = |(axis, parts): (&PlanPlaces, &Vec<u32>)| {
                    let part = usize::try_from(design).ok().and_then(|k| parts.get(k));
                    let part = f64::from(part.copied().unwrap_or(0)) + 0.5;
                    axis.at(part / self.count as f64)
                };
                axes.map(place).collect()
            }
            None => self.on_grid(design),
        }
    }

    fn on_grid(&self, design: u64) -> Vec<f64> {
        let mut rest = design;
        let mut numbers: Vec<f64> = self
            .axes
            .iter()
            .rev()
            .map(|axis| {
                let count = u64::from(axis.count);
                let place = rest % count;
                rest /= count;
                let last = (count - 1).max(1);
                axis.at(place as f64 / last as f64)
            })
            .collect();
        numbers.reverse();
        numbers
    }
}

/// Returns the places along each axis; an axis without ends keeps its given number.
fn places(axes: &[PlanAxis], given: &[f64]) -> Vec<PlanPlaces> {
    let places = axes.iter().zip(given).map(|(axis, &given)| {
        let ends = axis.ends.unwrap_or([given, given]);
        let is_single = ends[0] == ends[1];
        let usual = if is_single { 1 } else { DEFAULT_PLACES };
        PlanPlaces {
            ends,
            count: axis.count.unwrap_or(usual),
        }
    });
    places.collect()
}

/// Returns the numbers below a count in random order (Fisher and Yates).
fn shuffled(count: u32, rng: &mut SeededRng) -> Vec<u32> {
    let mut all: Vec<u32> = (0..count).collect();
    for last in (1..count).rev() {
        let other = rng.between(0, last);
        all.swap(last as usize, other as usize);
    }
    all
}
