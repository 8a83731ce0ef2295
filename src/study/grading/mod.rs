//! Figures of a student, graded: what is right, and of what is not, what may have happened.
//!
//! A figure that is not the exact one may follow from earlier figures as they were written: then it was rounded early,
//! or it is right by what was wrong before. Which of them explains it is told.

mod chain;
mod verdict;
mod written;

pub use chain::{ChainGroup, ChainSlot, ChainValues, SolutionChain};
pub use verdict::{FigureVerdict, RoundedEarly};
pub use written::WrittenFigure;

use crate::quantity::Quantity;
use verdict::{FEWEST, MOST, Truth, unit_factors};

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
    /// What is asked for, positions first, then velocities, then accelerations.
    pub figures: Vec<AskedFigure>,
    /// How the figures follow from each other, where that is known.
    pub chain: Option<SolutionChain>,
    /// The variables of the chain in other assemblies.
    pub others: Vec<ChainValues>,
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
}

/// What a figure that was graded tells of the variables.
struct FacedSlot {
    /// Its number among the figures.
    figure: usize,
    slot: ChainSlot,
    value: f64,
    is_sound: bool,
}

impl AnswerKey {
    /// A verdict for every answer; answers that are missing are empty.
    #[must_use]
    pub fn graded(&self, answers: &[GivenAnswer]) -> Vec<FigureVerdict> {
        let mut verdicts: Vec<FigureVerdict> = Vec::with_capacity(self.figures.len());
        let mut faced = Vec::new();
        for (number, figure) in self.figures.iter().enumerate() {
            let answer = answers.get(number).copied().unwrap_or(GivenAnswer::Empty);
            let verdict = match answer {
                GivenAnswer::Empty => FigureVerdict::Empty,
                GivenAnswer::Unreadable => FigureVerdict::Unreadable,
                GivenAnswer::Figure(written) => {
                    let verdict = self.verdict(figure, written, &faced);
                    faced.extend(self.faced(number, figure, written, verdict));
                    verdict
                }
            };
            verdicts.push(verdict);
        }
        verdicts
    }

    /// What an answer tells of the variables; one in another unit is meant as what it is in its own.
    fn faced(
        &self,
        number: usize,
        figure: &AskedFigure,
        written: WrittenFigure,
        verdict: FigureVerdict,
    ) -> Option<FacedSlot> {
        let (slot, more) = self.chain.as_ref()?.slot_of(&figure.quantity)?;
        let mut value = written.value;
        if let FigureVerdict::OtherUnit(unit) = verdict {
            let mut factors = unit_factors(&figure.quantity.unit).into_iter();
            value *= factors.find(|(own, _)| *own == unit)?.1;
        }
        if figure.quantity.is_direction() {
            value = value.to_radians() - more;
        }
        Some(FacedSlot {
            figure: number,
            slot,
            value,
            is_sound: matches!(verdict, FigureVerdict::Right | FigureVerdict::Rounded(_)),
        })
    }

    fn verdict(
        &self,
        figure: &AskedFigure,
        written: WrittenFigure,
        faced: &[FacedSlot],
    ) -> FigureVerdict {
        let truth = Truth::of(figure);
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
        if let Some(explained) = self.explained(figure, written, faced) {
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

    /// The figure as it follows from earlier ones, all that were written so far or one of them alone.
    fn explained(
        &self,
        figure: &AskedFigure,
        written: WrittenFigure,
        faced: &[FacedSlot],
    ) -> Option<FigureVerdict> {
        let chain = self.chain.as_ref()?;
        let slots = chain.slots();
        let place = |slot: ChainSlot| slots.iter().position(|own| *own == slot);
        let own = chain
            .slot_of(&figure.quantity)
            .and_then(|(slot, _)| place(slot));
        let order = figure.quantity.order() as usize;
        let is_earlier = |face: &&FacedSlot| match own {
            Some(own) => place(face.slot).is_some_and(|place| place < own),
            None => face.slot.order <= order,
        };
        let mut earlier: Vec<&FacedSlot> = faced.iter().filter(is_earlier).collect();
        earlier.sort_by_key(|face| place(face.slot));
        // Who writes figures down goes on with them; but some carry the last ones on with all digits.
        let sets = (1..=earlier.len()).rev().map(|count| &earlier[..count]);
        let mut sets = sets.chain(earlier.chunks(1));
        sets.find_map(|set| self.explanation(chain, figure, written, set))
    }

    /// The figure as it follows from some at their face value, where that is what was written.
    fn explanation(
        &self,
        chain: &SolutionChain,
        figure: &AskedFigure,
        written: WrittenFigure,
        set: &[&FacedSlot],
    ) -> Option<FigureVerdict> {
        let truth = Truth::of(figure);
        let by = |face: &dyn Fn(&FacedSlot) -> Option<f64>| {
            let given = |slot| {
                let mut faces = set.iter();
                face(faces.find(|face| face.slot == slot)?)
            };
            chain.figure(&figure.quantity, &chain.follow(&given)?)
        };
        let followed = by(&|face| Some(face.value))?;
        let apart = truth.with(followed).apart(written.value).abs();
        let unit = written.unit_of(FEWEST, MOST);
        // What is no nearer to it than to the exact figure explains nothing.
        if !(apart <= unit && apart <= 0.5 * truth.apart(written.value).abs()) {
            return None;
        }
        // What one of them does while the others are exact.
        let effect = |one: &FacedSlot| {
            let alone = by(&|face| match face.slot == one.slot {
                true => Some(face.value),
                false => chain.exact_at(face.slot),
            });
            alone.map_or(0.0, |alone| truth.apart(alone).abs())
        };
        let effects = set.iter().map(|face| (effect(face), *face));
        let effects: Vec<(f64, &FacedSlot)> = effects.collect();
        let largest = |wanted: &dyn Fn(&FacedSlot) -> bool| {
            let wanted = effects.iter().filter(|(_, face)| wanted(face));
            wanted.max_by(|a, b| a.0.total_cmp(&b.0)).copied()
        };
        Some(match largest(&|face| !face.is_sound) {
            Some((effect, face)) if effect > unit => FigureVerdict::Followed(face.figure),
            _ => {
                let (_, face) = largest(&|face| face.is_sound)?;
                FigureVerdict::Rounded(RoundedEarly::By(face.figure))
            }
        })
    }
}
