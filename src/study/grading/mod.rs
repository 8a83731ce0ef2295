//! Figures of a student, graded: what is right, and of what is not, what may have happened.
//!
//! A figure that is not the exact one may follow from earlier figures as they were written: then it was rounded early,
//! or it is right by what was wrong before. Which of them explains it is told.

mod chain;
mod explained;
mod misread;
mod points;
mod verdict;
mod written;

pub use chain::{ChainGroup, ChainSlot, ChainValues, SolutionChain};
pub use misread::{MisreadValue, SheetScene};
pub use points::LinkPoints;
pub use verdict::{FigureVerdict, RoundedEarly};
pub use written::WrittenFigure;

use crate::quantity::{Quantity, known_unit, unit_factor};
use points::{FacedVector, VectorSlot};
use verdict::{FEWEST, Truth};

/// A figure that is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct AskedFigure {
    /// Which.
    pub quantity: Quantity,
    /// Its value.
    pub exact: f64,
    /// What the error of that does not exceed, where it was proved.
    pub bound: Option<f64>,
    /// The largest of its kind: beside it this one may be 0.
    pub scale: f64,
}

/// All that grading one state takes.
#[derive(Clone, Debug)]
pub struct AnswerKey {
    /// What is asked for, positions first, then velocities, then accelerations; then what else is judged.
    pub figures: Vec<AskedFigure>,
    /// So many of them are asked for.
    pub asked: usize,
    /// How the figures follow from each other, where that is known.
    pub chain: Option<SolutionChain>,
    /// The variables of the chain in other assemblies.
    pub others: Vec<ChainValues>,
    /// The points of each link: their motions are in proportion.
    pub bodies: Vec<LinkPoints>,
}

/// What stands in the place of an answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GivenAnswer {
    /// Nothing.
    Empty,
    /// Something that is no figure.
    Unreadable,
    /// A figure.
    Figure(WrittenFigure),
    /// A figure in another unit than it was asked for, which it says.
    Converted {
        /// In the unit that was asked for.
        figure: WrittenFigure,
        /// As it stands there.
        face: WrittenFigure,
    },
}

impl GivenAnswer {
    /// Returns the figure in the unit that was asked for.
    fn figure(self) -> Option<WrittenFigure> {
        match self {
            GivenAnswer::Empty | GivenAnswer::Unreadable => None,
            GivenAnswer::Figure(figure) | GivenAnswer::Converted { figure, .. } => Some(figure),
        }
    }
}

/// One way to read an answer, and what is to be said of it then.
#[derive(Clone, Copy)]
struct JudgedReading {
    written: WrittenFigure,
    verdict: FigureVerdict,
}

/// What was graded so far: what it tells of the variables, and of the points.
#[derive(Default)]
struct Faced {
    slots: Vec<FacedSlot>,
    vectors: Vec<FacedVector>,
}

/// What a figure that was graded tells of the variables.
struct FacedSlot {
    /// Its number among the figures.
    figure: usize,
    slot: ChainSlot,
    value: f64,
    /// Half of its last digit.
    half: f64,
    /// The number that was written.
    number: f64,
    is_sound: bool,
}

impl AnswerKey {
    /// Returns whether the figure of a column is asked for.
    #[must_use]
    pub fn asks(&self, column: &str) -> bool {
        let mut asked = self.figures.iter().take(self.asked);
        asked.any(|figure| figure.quantity.name == column)
    }

    /// A verdict for every answer; answers that are missing are empty.
    #[must_use]
    pub fn graded(&self, answers: &[GivenAnswer]) -> Vec<FigureVerdict> {
        let mut verdicts: Vec<FigureVerdict> = Vec::with_capacity(self.figures.len());
        let mut faced = Faced::default();
        for (number, figure) in self.figures.iter().enumerate() {
            let answer = answers.get(number).copied().unwrap_or(GivenAnswer::Empty);
            let judged = match answer {
                GivenAnswer::Empty => Err(FigureVerdict::Empty),
                GivenAnswer::Unreadable => Err(FigureVerdict::Unreadable),
                GivenAnswer::Figure(written) => Ok(self.judged(figure, written, &faced)),
                GivenAnswer::Converted { figure: own, face } => {
                    Ok(self.of_two_units(figure, (own, face), &faced))
                }
            };
            if let Ok(reading) = judged {
                faced.slots.extend(self.faced(number, figure, reading));
                faced.vectors.extend(faced_vector(number, figure, reading));
            }
            verdicts.push(judged.map_or_else(|verdict| verdict, |reading| reading.verdict));
        }
        verdicts
    }

    /// An answer as it is meant: of all that it may mean what is right, or nearest to that.
    fn judged(&self, figure: &AskedFigure, written: WrittenFigure, faced: &Faced) -> JudgedReading {
        let judge = |written| JudgedReading {
            written,
            verdict: self.verdict(figure, written, faced),
        };
        let apart = |one: &JudgedReading| Truth::of(figure).apart(one.written.value).abs();
        let mut best = judge(written);
        for other in written.readings().skip(1) {
            if best.verdict == FigureVerdict::Right {
                break;
            }
            let other = judge(other);
            let (rank, own) = (other.verdict.rank(), best.verdict.rank());
            if rank < own || rank == own && apart(&other) < apart(&best) {
                best = other;
            }
        }
        best
    }

    /// An answer that says its unit; what is right but for that stands in the unit that was asked for.
    fn of_two_units(
        &self,
        figure: &AskedFigure,
        (own, face): (WrittenFigure, WrittenFigure),
        faced: &Faced,
    ) -> JudgedReading {
        let reading = self.judged(figure, own, faced);
        let unit = known_unit(&figure.quantity.unit);
        let meant = face.readings().find(|face| {
            let truth = Truth::of(figure);
            truth.is_right(*face) || truth.is_near(face.value)
        });
        match (unit, meant) {
            (Some(unit), Some(written)) if !reading.verdict.is_worth_a_point() => JudgedReading {
                written,
                verdict: FigureVerdict::OtherUnit(unit),
            },
            _ => reading,
        }
    }

    /// What an answer tells of the variables; one in another unit is meant as what it is in its own.
    fn faced(
        &self,
        number: usize,
        figure: &AskedFigure,
        JudgedReading { written, verdict }: JudgedReading,
    ) -> Option<FacedSlot> {
        let (slot, more) = self.chain.as_ref()?.slot_of(&figure.quantity)?;
        let meant = meant(figure, written, verdict)?;
        let mut value = meant.value;
        let mut half = 0.5 * meant.unit_of(FEWEST, i32::MAX);
        if figure.quantity.is_direction() {
            (value, half) = (value.to_radians() - more, half.to_radians());
        }
        Some(FacedSlot {
            figure: number,
            slot,
            value,
            half,
            number: written.value,
            is_sound: is_sound(verdict),
        })
    }

    fn verdict(
        &self,
        figure: &AskedFigure,
        written: WrittenFigure,
        faced: &Faced,
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
        // A length of another assembly is no figure that was carried on; its velocity may be.
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

    fn is_of_other_assembly(&self, figure: &AskedFigure, written: WrittenFigure) -> bool {
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

/// What an answer tells of a point.
fn faced_vector(
    number: usize,
    figure: &AskedFigure,
    JudgedReading { written, verdict }: JudgedReading,
) -> Option<FacedVector> {
    let slot = VectorSlot::of(&figure.quantity)?;
    let meant = meant(figure, written, verdict)?;
    Some(FacedVector {
        figure: number,
        slot,
        value: meant.value,
        half: 0.5 * meant.unit_of(FEWEST, i32::MAX),
        number: written.value,
        is_sound: is_sound(verdict),
    })
}

/// An answer in the unit that was asked for, where it stands in another.
fn meant(
    figure: &AskedFigure,
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

fn is_sound(verdict: FigureVerdict) -> bool {
    matches!(verdict, FigureVerdict::Right | FigureVerdict::Rounded(_))
}
