//! Reports of results: tables, sweeps and the facts of a scene, as text, CSV and JSON.
//!
//! Text is for people: a chosen number of digits, aligned, with units. CSV and JSON are for other
//! programs: every number reads back to the same double, and a missing value is an empty cell or
//! `null`, never 0 or NaN. All output is plain ASCII, except for titles and notes of a scene if the
//! terminal can show them.

mod accuracy;
mod check;
mod cycle;
mod designs;
mod document;
mod exercise;
mod external_comparison;
mod forces;
mod loop_polygons;
mod motor;
mod sweep;
mod synthesis;
mod tables;
mod text;
mod tolerance;
mod verdict;
mod working;

pub use self::synthesis::SynthesisReport;
pub use accuracy::{
    Accuracy, StudyMeasure, TIME_DIGITS, accuracy_notes, error_text, method_name, time_text,
    unfit_text,
};
pub use check::{Check, followed_until, near_misses, stop_before, stop_name, unreached};
pub use cycle::{CycleReport, FollowedColumn, WorstPlace, usual_columns};
pub use designs::{
    goals::{BestReport, GoalReport, no_best},
    summary::DesignSummary,
    table::DesignTable,
};
pub use document::{Report, ReportFormat};
pub use exercise::{
    AnswerFile, AnsweredRow, FileRemarks, GradedAnswers, GradedFigure, InvalidCell, MadeExercise,
    NoAnswers, QuestionState, answer_key, blank_answers, class_csv, class_page, is_blank,
    named_again,
};
pub use external_comparison::{ForeignFigures, Measured, NoFigures};
pub use forces::{
    Checks, Drive, Existence, Forces, GuideRow, JointRow, Shaking, least_norm::LeastNormReactions,
};
pub use motor::{MotorReport, MotorRequest, RamReport, over_time::TimedMotorReport};
pub use sweep::{
    Sweep, SweepOutcome,
    columns::{Columns, ExtraColumns},
    curves::curves_csv,
    errors::Missing,
    lead::{LeadSweep, singularity_text},
    path::InputPath,
    steps::{DecimalError, MAX_ROWS, Steps, StepsError, WrittenDecimal},
};
pub use tables::{
    DriverLine, ORDERS, PointRow, Tables, VectorColumn,
    answers::{Answer, Answers},
    difference::Pairing,
    entry::{Entry, PlaneVector},
    figure_list::{FigureList, ListedFigure},
    page::TableStyle,
};
pub use text::{
    csv_dialect::{CellSeparator, CsvDialect, DecimalMark},
    encoding::TextEncoding,
    places::{limits_text, range_text},
    rows::{RowColumn, RowFormat},
};
pub use tolerance::{
    answers::{ToleranceAnswer, ToleranceAnswers},
    report::{ToleranceReport, ToleranceRow},
    rows::{ToleranceOutcome, ToleranceRows},
};
pub use verdict::{Verdict, VerdictPart, motion_text};
pub use working::{
    Agreement, Guess, GuessError, InstantCentre, LoopVector, LoopVectors, PointMotion, PointParts,
    PositionMethod, RelativeMotion, VectorFigure, WorkedMethod, WorkedState, Working,
    WorkingNotation, WorkingPart,
};
#[cfg(feature = "tui")]
pub(crate) use {
    self::cycle::page::brief_cycle,
    self::forces::{effort_word, page::missed},
    self::synthesis::{candidate_row::CandidateRow, wanted},
    self::text::number::{fixed, perpendicular_up, shortest},
};
