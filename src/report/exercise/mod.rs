//! Exercises on paper and in a spreadsheet: what is asked, files to answer in, and what became of them.

mod asked;
mod blank;
mod class;
mod graded;
mod row_names;
mod sheet;

pub use asked::answer_key;
pub use blank::{AnswerFile, AnsweredRow, NoAnswers, StrangeCell, blank_answers, is_blank};
pub use class::{class_csv, class_page, named_again};
pub use graded::{FileRemarks, GradedAnswers, GradedFigure};

#[cfg(test)]
mod tests;
