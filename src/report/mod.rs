//! Reports of results: tables, sweeps and the facts of a scene, as text, CSV and JSON.
//!
//! Text is for people: a chosen number of digits, aligned, with units. CSV and JSON are for other
//! programs: every number reads back to the same double, and a missing value is an empty cell or
//! `null`, never 0 or NaN. All output is plain ASCII, except for titles and notes of a scene if the
//! terminal can show them.

mod accuracy;
mod answers;
mod beside;
#[cfg(feature = "tui")]
mod candidate_row;
mod cells;
mod check;
mod columns;
mod csv_dialect;
mod curves;
mod cycle_page;
mod cycle_report;
mod design_rows;
mod design_summary;
mod difference;
mod entry;
mod errors;
mod exercise;
mod figure_list;
mod forces;
mod forces_page;
mod goals;
mod least;
mod motor;
mod motor_csv;
mod motor_page;
mod number;
mod paper;
mod places;
mod rows;
mod steps;
mod structural_error;
mod sweep;
mod synthesis;
mod synthesis_csv;
mod tables;
mod tables_data;
mod tables_page;
mod text_encoding;
mod timed_motor;
mod tolerance_answers;
mod tolerance_page;
mod tolerance_rows;
mod verdict;
mod working;

pub use self::synthesis::SynthesisReport;
pub use accuracy::{
    Accuracy, StudyMeasure, TIME_DIGITS, accuracy_notes, error_text, method_name, time_text,
    unfit_text,
};
pub use answers::{Answer, Answers};
pub use beside::{ForeignFigures, Measured, NoFigures};
pub use check::{Check, near_misses, stop_before, stop_name};
pub use columns::{Columns, ExtraColumns};
pub use csv_dialect::{CellSeparator, CsvDialect, DecimalMark};
pub use curves::curves_csv;
pub use cycle_report::{CycleReport, FollowedFigure, WorstPlace, usual_columns};
pub use design_rows::DesignTable;
pub use design_summary::DesignSummary;
pub use difference::Pairing;
pub use entry::{Entry, PlaneVector};
pub use errors::Missing;
pub use exercise::{
    AnswerFile, AnsweredRow, FileRemarks, GradedAnswers, GradedFigure, InvalidCell, NoAnswers,
    answer_key, blank_answers, class_csv, class_page, is_blank, named_again,
};
pub use figure_list::{FigureList, ListedFigure};
pub use forces::{Checks, Drive, Existence, Forces, GuideRow, JointRow, Shaking};
pub use goals::{BestReport, GoalReport, no_best};
pub use least::Least;
pub use motor::{MotorReport, MotorRequest, RamReport};
pub use paper::{Report, ReportFormat};
pub use places::{limits_text, range_text};
pub use rows::{RowColumn, RowFormat};
pub use steps::{DecimalError, MAX_ROWS, Steps, StepsError, WrittenDecimal};
pub use sweep::{Sweep, SweepOutcome};
pub use tables::{DriverLine, ORDERS, PointRow, Tables, VectorColumn};
pub use tables_page::TableStyle;
pub use text_encoding::TextEncoding;
pub use timed_motor::TimedMotorReport;
pub use tolerance_answers::{ToleranceAnswer, ToleranceAnswers};
pub use tolerance_page::{ToleranceReport, ToleranceRow};
pub use tolerance_rows::{ToleranceOutcome, ToleranceRows};
pub use verdict::{Verdict, VerdictPart, motion_text};
pub use working::{
    Agreement, Guess, GuessError, InstantCentre, LoopVector, LoopVectors, PointMotion, PointParts,
    PositionMethod, VectorFigure, Worked, WorkedMethod, Working, WorkingNotation, WorkingPart,
};
#[cfg(feature = "tui")]
pub(crate) use {
    self::synthesis::wanted, candidate_row::CandidateRow, cycle_page::brief_cycle,
    forces::effort_word, forces_page::missed, number::shortest, number::upwards,
};
