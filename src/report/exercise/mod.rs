//! Exercises on paper and in spreadsheets: requested values, answer files, and grading.

mod asked;
mod blank;
mod class;
mod graded;
mod row_names;
mod sheet;

pub use asked::answer_key;
pub use blank::{AnswerFile, AnsweredRow, InvalidCell, NoAnswers, blank_answers, is_blank};
pub use class::{class_csv, class_page, named_again};
pub use graded::{FileRemarks, GradedAnswers, GradedFigure};

#[cfg(test)]
mod tests;
