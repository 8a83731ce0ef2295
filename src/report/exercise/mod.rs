//! Exercises on paper and in spreadsheets: requested values, answer files, and grading.

mod answer_file;
mod class;
mod graded;
mod made;
mod question_state;
mod requested_values;
mod row_names;
mod sheet;

pub use answer_file::{AnswerFile, AnsweredRow, InvalidCell, NoAnswers, blank_answers, is_blank};
pub use class::{class_csv, class_page, named_again};
pub use graded::{FileRemarks, GradedAnswers, GradedFigure};
pub use made::MadeExercise;
pub use question_state::QuestionState;
pub use requested_values::answer_key;

#[cfg(test)]
mod tests;
