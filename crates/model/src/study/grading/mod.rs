//! Grades a student's answers: finds the right ones, and the probable causes of the others.
//!
//! A value that differs from the exact one may follow from earlier answers as they were written. It
//! was then rounded early, or it is consequential. The verdict names the earlier answer.

mod chain;
mod comparison;
mod follow_through;
mod misread_values;
mod points;
mod written_numbers;

pub use chain::{ChainGroup, ChainSlot, ChainValues, SolutionChain};
pub use comparison::{FigureVerdict, RoundedEarly};
pub use misread_values::{MisreadValue, SheetScene};
pub use points::LinkPoints;
pub use written_numbers::WrittenFigure;

use crate::quantity::{Quantity, known_unit, unit_factor};
use comparison::{MIN_COUNT, Truth};
use points::VectorSlot;

/// A required value.
#[derive(Clone, Debug, PartialEq)]
pub struct RequiredValue {
    /// The quantity.
    pub quantity: Quantity,
    /// The exact value.
    pub exact: f64,
    /// The proved bound of its error, if there is one.
    pub bound: Option<f64>,
    /// The largest value of its kind; a value much smaller counts as 0.
    pub scale: f64,
}

/// The data for grading one state.
#[derive(Clone, Debug)]
pub struct AnswerKey {
    /// The required values, positions first, then velocities, then accelerations; then further
    /// values to judge.
    pub figures: Vec<RequiredValue>,
    /// The number of required values.
    pub required: usize,
    /// The dependencies between the values, if known.
    pub chain: Option<SolutionChain>,
    /// The chain's variables in other assemblies.
    pub others: Vec<ChainValues>,
    /// The points of each link; their motions are proportional.
    pub bodies: Vec<LinkPoints>,
}

/// The contents of an answer field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GivenAnswer {
    /// An empty field.
    Empty,
    /// Text that is not a number.
    Unreadable,
    /// A number.
    Figure(WrittenFigure),
    /// A number with a unit other than the required one.
    Converted {
        /// The number in the required unit.
        figure: WrittenFigure,
        /// The number as written.
        face: WrittenFigure,
    },
}

impl GivenAnswer {
    /// Returns the number in the required unit; `None` without one.
    fn figure(self) -> Option<WrittenFigure> {
        match self {
            GivenAnswer::Empty | GivenAnswer::Unreadable => None,
            GivenAnswer::Figure(figure) | GivenAnswer::Converted { figure, .. } => Some(figure),
        }
    }
}

/// One interpretation of an answer, and its verdict.
#[derive(Clone, Copy)]
struct GradedReading {
    written: WrittenFigure,
    verdict: FigureVerdict,
}

/// The answers graded so far, as values of variables and of points' vectors.
#[derive(Default)]
struct GradedSoFar {
    slots: Vec<GradedVariable>,
    vectors: Vec<AnsweredVector>,
}

/// A graded answer as the value of a slot: of a variable, or of a point's vector.
#[derive(Clone, Copy, Debug)]
struct AnsweredSlot<S> {
    /// The index of the answer.
    figure: usize,
    slot: S,
    value: f64,
    /// Half a unit of the last digit.
    half: f64,
    /// The written number.
    number: f64,
    /// Whether the answer is right, apart from rounding.
    is_sound: bool,
}

type GradedVariable = AnsweredSlot<ChainSlot>;
type AnsweredVector = AnsweredSlot<VectorSlot>;

/// Maximum number of wrong answers for which unwritten digits are considered.
const MAX_WRONG_ANSWERS: usize = 2;

impl<S> AnsweredSlot<S> {
    /// Creates the value that an answer means; `None` if its unit cannot be converted.
    fn new(number: usize, slot: S, figure: &RequiredValue, reading: GradedReading) -> Option<Self> {
        let GradedReading { written, verdict } = reading;
        let intended = in_required_unit(figure, written, verdict)?;
        Some(AnsweredSlot {
            figure: number,
            slot,
            value: intended.value,
            half: 0.5 * intended.unit_of(MIN_COUNT, i32::MAX),
            number: written.value,
            is_sound: is_valid(verdict),
        })
    }
}

/// Returns the verdict that names the answer with the largest effect: a wrong one with an effect of
/// more than a unit, or else the rounded one. Returns `None` if the answer repeats a wrong one.
fn blamed<S>(
    effects: &[(f64, &AnsweredSlot<S>)],
    unit: f64,
    is_copied: impl FnOnce(&AnsweredSlot<S>) -> bool,
) -> Option<FigureVerdict> {
    let largest = |is_sound: bool| {
        let faces = effects.iter().filter(|(_, face)| face.is_sound == is_sound);
        faces.max_by(|a, b| a.0.total_cmp(&b.0))
    };
    match largest(false) {
        Some((effect, face)) if *effect > unit => {
            (!is_copied(face)).then_some(FigureVerdict::Followed(face.figure))
        }
        _ => {
            let (_, face) = largest(true)?;
            Some(FigureVerdict::Rounded(RoundedEarly::By(face.figure)))
        }
    }
}

impl AnswerKey {
    /// Returns `true` if the value of a column is required.
    #[must_use]
    pub fn requires(&self, column: &str) -> bool {
        let mut requested = self.figures.iter().take(self.required);
        requested.any(|figure| figure.quantity.name == column)
    }

    /// Grades every answer; missing answers count as empty.
    #[must_use]
    pub fn graded(&self, answers: &[GivenAnswer]) -> Vec<FigureVerdict> {
        let mut verdicts: Vec<FigureVerdict> = Vec::with_capacity(self.figures.len());
        let mut faced = GradedSoFar::default();
        for (number, figure) in self.figures.iter().enumerate() {
            let answer = answers.get(number).copied().unwrap_or(GivenAnswer::Empty);
            let judged = match answer {
                GivenAnswer::Empty => Err(FigureVerdict::Empty),
                GivenAnswer::Unreadable => Err(FigureVerdict::Unreadable),
                GivenAnswer::Figure(written) => Ok(self.grade_answer(figure, written, &faced)),
                GivenAnswer::Converted { figure: own, face } => {
                    Ok(self.of_two_units(figure, (own, face), &faced))
                }
            };
            if let Ok(reading) = judged {
                faced.slots.extend(self.faced(number, figure, reading));
                let vector = VectorSlot::of(&figure.quantity);
                let vector =
                    vector.and_then(|slot| AnsweredSlot::new(number, slot, figure, reading));
                faced.vectors.extend(vector);
            }
            verdicts.push(judged.map_or_else(|verdict| verdict, |reading| reading.verdict));
        }
        verdicts
    }

    /// Grades an answer in its most favourable interpretation: the right one, or the one closest to
    /// that.
    fn grade_answer(
        &self,
        figure: &RequiredValue,
        written: WrittenFigure,
        faced: &GradedSoFar,
    ) -> GradedReading {
        let judge = |written| GradedReading {
            written,
            verdict: self.verdict(figure, written, faced),
        };
        let distance =
            |one: &GradedReading| Truth::of(figure).difference_from(one.written.value).abs();
        let mut best = judge(written);
        for other in written.readings().skip(1) {
            if best.verdict == FigureVerdict::Right {
                break;
            }
            let other = judge(other);
            let (rank, own) = (other.verdict.rank(), best.verdict.rank());
            if rank < own || rank == own && distance(&other) < distance(&best) {
                best = other;
            }
        }
        best
    }

    /// Grades an answer with a unit. A number that is right except for its unit gets
    /// [`FigureVerdict::OtherUnit`].
    fn of_two_units(
        &self,
        figure: &RequiredValue,
        (own, face): (WrittenFigure, WrittenFigure),
        faced: &GradedSoFar,
    ) -> GradedReading {
        let reading = self.grade_answer(figure, own, faced);
        let unit = known_unit(&figure.quantity.unit);
        let intended = face.readings().find(|face| {
            let truth = Truth::of(figure);
            truth.is_right(*face) || truth.is_near(face.value)
        });
        match (unit, intended) {
            (Some(unit), Some(written)) if !reading.verdict.earns_point() => GradedReading {
                written,
                verdict: FigureVerdict::OtherUnit(unit),
            },
            _ => reading,
        }
    }

    /// Returns the value of the variable that an answer determines; a wrong unit is corrected.
    fn faced(
        &self,
        number: usize,
        figure: &RequiredValue,
        reading: GradedReading,
    ) -> Option<GradedVariable> {
        let (slot, more) = self.chain.as_ref()?.slot_of(&figure.quantity)?;
        let mut graded = AnsweredSlot::new(number, slot, figure, reading)?;
        if figure.quantity.is_direction() {
            graded.value = graded.value.to_radians() - more;
            graded.half = graded.half.to_radians();
        }
        Some(graded)
    }

    fn verdict(
        &self,
        figure: &RequiredValue,
        written: WrittenFigure,
        faced: &GradedSoFar,
    ) -> FigureVerdict {
        let truth = Truth::of(figure);
        if truth.is_out_of_reach(written) {
            return FigureVerdict::Wrong;
        }
        if truth.is_right(written) {
            return FigureVerdict::Right;
        }
        if let Some(by) = truth.rounded(written) {
            return FigureVerdict::Rounded(by);
        }
        let is_position = figure.quantity.order() == crate::solver::Order::Position;
        let other = || self.is_of_other_assembly(figure, written);
        // A length of another assembly is not consequential; its velocity may be.
        if is_position && other() {
            return FigureVerdict::OtherAssembly;
        }
        let by_points = self.follows_from_points(figure, written, &faced.vectors);
        let is_followed = matches!(by_points, Some(FigureVerdict::Followed(_)));
        let by_slots = match is_followed {
            true => None,
            false => self.explained(figure, written, &faced.slots),
        };
        if let Some(explained) = by_slots.or(by_points) {
            return explained;
        }
        if let Some(verdict) = truth.mistaken(written, &figure.quantity.unit) {
            return verdict;
        }
        if other() {
            return FigureVerdict::OtherAssembly;
        }
        FigureVerdict::Wrong
    }

    fn is_of_other_assembly(&self, figure: &RequiredValue, written: WrittenFigure) -> bool {
        let Some(chain) = &self.chain else {
            return false;
        };
        self.others.iter().any(|values| {
            let there = chain.figure(&figure.quantity, values);
            there.is_some_and(|exact| {
                let there = Truth::of(figure).with(exact);
                there.is_right(written) || there.is_near(written.value)
            })
        })
    }
}

/// Returns an answer in the required unit, if its verdict is another unit.
fn in_required_unit(
    figure: &RequiredValue,
    written: WrittenFigure,
    verdict: FigureVerdict,
) -> Option<WrittenFigure> {
    match verdict {
        FigureVerdict::OtherUnit(unit) => {
            Some(written.times(unit_factor(unit, &figure.quantity.unit)?))
        }
        _ => Some(written),
    }
}

fn is_valid(verdict: FigureVerdict) -> bool {
    matches!(verdict, FigureVerdict::Right | FigureVerdict::Rounded(_))
}
