//! Exercises on paper and in a spreadsheet: what is asked, files to answer in, and what became of them.

mod asked;
mod blank;
mod class;
mod graded;
mod sheet;

pub use asked::answer_key;
pub use blank::{AnswerFile, AnsweredRow, NoAnswers, blank_answers, is_blank};
pub use class::{class_csv, class_page, named_again};
pub use graded::{GradedAnswers, GradedFigure};

#[cfg(test)]
mod tests;
