//! What tolerances do to all figures at once, in a line each: how much, and who has the largest share of it.

use super::number::{concise, significant};
use super::tolerance_page::contributor;
use crate::page::Table;
use crate::scene::Scene;
use crate::study::ToleranceStudy;
use crate::wording::words;

/// What tolerances do to all figures at one coordinate of the driver, at the first order.
#[derive(Clone, Debug, PartialEq)]
pub struct ToleranceAnswers {
    /// The figures that are off.
    pub list: Vec<ToleranceAnswer>,
}

/// What tolerances do to one figure.
#[derive(Clone, Debug, PartialEq)]
pub struct ToleranceAnswer {
    /// The figure's name with its unit.
    pub header: String,
    /// The root of the sum of squares.
    pub root_sum_square: f64,
    /// Who has the largest share of it.
    pub most: String,
    /// That share.
    pub share: f64,
}

/// Digits of what is read by eye.
const DIGITS: usize = 3;

impl ToleranceAnswers {
    /// Of a study of this scene at a coordinate.
    #[must_use]
    pub fn at(scene: &Scene, study: &mut ToleranceStudy, at: f64) -> Self {
        let found = study.first_order(at);
        let figures = study.figures().iter().zip(found);
        let answer = figures.filter_map(|(figure, found)| {
            let (root_sum_square, contributions) = found?;
            let most = contributions.first()?;
            Some(ToleranceAnswer {
                header: figure.header(),
                root_sum_square,
                most: contributor(scene, most.of),
                share: most.share,
            })
        });
        ToleranceAnswers {
            list: answer.collect(),
        }
    }

    /// A row per figure.
    #[must_use]
    pub fn table(&self) -> Table {
        let heads = [
            words().label_root_sum_square(),
            words().head_share(),
            words().in_which(),
        ];
        let mut table = Table::new(words().within_tolerances(), heads);
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
