//! Summarizes the effect of tolerances on all values, one line each: the deviation, and its main
//! contributor.

use crate::page::Table;
use crate::report::text::number::{concise, significant};
use crate::report::tolerance::report::contributor;
use crate::scene::Scene;
use crate::study::ToleranceStudy;
use crate::wording::words;

/// The first-order effect of tolerances on all values at one coordinate of the driver.
#[derive(Clone, Debug, PartialEq)]
pub struct ToleranceAnswers {
    /// The values that deviate.
    pub list: Vec<ToleranceAnswer>,
}

/// The effect of tolerances on one value.
#[derive(Clone, Debug, PartialEq)]
pub struct ToleranceAnswer {
    /// The name of the value with its unit.
    pub header: String,
    /// The root of the sum of squares.
    pub root_sum_square: f64,
    /// The main contributor.
    pub most: String,
    /// The share of the main contributor.
    pub share: f64,
}

/// Significant digits in text.
const DIGITS: usize = 3;

impl ToleranceAnswers {
    /// Computes the effect in a study of this scene at a coordinate.
    #[must_use]
    pub fn at(scene: &Scene, study: &mut ToleranceStudy, at: f64) -> Self {
        let found = study.first_order(at);
        let quantities = study.figures().iter().zip(found);
        let answer = quantities.filter_map(|(quantity, found)| {
            let (root_sum_square, contributions) = found?;
            let maximum = contributions.first()?;
            Some(ToleranceAnswer {
                header: quantity.header(),
                root_sum_square,
                most: contributor(scene, maximum.of),
                share: maximum.share,
            })
        });
        ToleranceAnswers {
            list: answer.collect(),
        }
    }

    /// Returns a table with a row per value.
    #[must_use]
    pub fn table(&self) -> Table {
        let headers = [
            words().label_root_sum_square(),
            words().head_share(),
            words().in_which(),
        ];
        let mut table = Table::new(words().within_tolerances(), headers);
        for answer in &self.list {
            let cells = [
                format!("+-{}", significant(answer.root_sum_square, DIGITS)),
                format!("{} %", concise(answer.share * 100.0, DIGITS)),
                answer.most.clone(),
            ];
            table.row(answer.header.clone(), cells);
        }
        table
    }
}
