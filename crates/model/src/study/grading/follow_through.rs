//! Explains an answer as a consequence of earlier answers as they were written.

use super::comparison::{FigureVerdict, MAX_COUNT, MIN_COUNT, Truth};
use super::{
    AnswerKey, ChainSlot, GradedVariable, MAX_WRONG_ANSWERS, RequiredValue, SolutionChain,
    WrittenFigure, blamed,
};

/// Maximum number of sets of earlier answers to try; each requires solving the loop equations.
const MAX_SETS: usize = 40;

impl AnswerKey {
    /// Explains a value by earlier answers: by several of them together, or by a single one.
    pub(super) fn explained(
        &self,
        figure: &RequiredValue,
        written: WrittenFigure,
        faced: &[GradedVariable],
    ) -> Option<FigureVerdict> {
        let chain = self.chain.as_ref()?;
        let slots = chain.slots();
        let place = |slot: ChainSlot| slots.iter().position(|own| *own == slot);
        let own = chain
            .slot_of(&figure.quantity)
            .and_then(|(slot, _)| place(slot));
        let order = figure.quantity.order() as usize;
        let is_earlier = |face: &&GradedVariable| match own {
            Some(own) => place(face.slot).is_some_and(|place| place < own),
            None => face.slot.order <= order,
        };
        // Answers that the value does not depend on explain nothing.
        let hangs_on = chain.variables_of(&figure.quantity);
        let is_earlier =
            |face: &&GradedVariable| is_earlier(face) && hangs_on.contains(&face.slot.variable);
        let mut earlier: Vec<&GradedVariable> = faced.iter().filter(is_earlier).collect();
        earlier.sort_by_key(|face| place(face.slot));
        // Most students continue with the values they write, but some keep more digits of the last
        // ones.
        let counts = (1..=earlier.len()).rev().take(MAX_SETS / 2);
        // Single answers: the wrong ones and the last ones first.
        let mut single: Vec<&GradedVariable> = earlier.iter().rev().copied().collect();
        single.sort_by_key(|face| face.is_sound);
        single.truncate(MAX_SETS / 2);
        if single.len() == earlier.len() {
            single.clone_from(&earlier);
        }
        let mut sets = counts
            .map(|count| &earlier[..count])
            .chain(single.chunks(1));
        // With many wrong answers a close value may be a coincidence. Unwritten digits are
        // therefore allowed only if few answers are wrong, or if all are used together.
        let wrong = earlier.iter().filter(|face| !face.is_sound).count();
        sets.find_map(|set| {
            let is_carried = wrong <= MAX_WRONG_ANSWERS || set.len() == earlier.len();
            let is_carried = is_carried && set.iter().any(|face| !face.is_sound);
            self.explanation((chain, &hangs_on), figure, written, (set, is_carried))
        })
    }

    /// Explains a value by a set of answers at face value; `None` if the written value is
    /// different.
    fn explanation(
        &self,
        (chain, hangs_on): (&SolutionChain, &[usize]),
        figure: &RequiredValue,
        written: WrittenFigure,
        (set, is_carried): (&[&GradedVariable], bool),
    ) -> Option<FigureVerdict> {
        let truth = Truth::of(figure);
        let by = |face: &dyn Fn(&GradedVariable) -> Option<f64>| {
            let given = |slot| {
                let mut faces = set.iter();
                face(faces.find(|face| face.slot == slot)?)
            };
            chain.figure(&figure.quantity, &chain.follow_for(hangs_on, &given)?)
        };
        let followed = by(&|face| Some(face.value))?;
        let distance = truth.with(followed).difference_from(written.value).abs();
        let unit = written.unit_of(MIN_COUNT, MAX_COUNT);
        // A value closer to the exact one is not explained.
        if !(distance <= 0.5 * truth.difference_from(written.value).abs()) {
            return None;
        }
        let there = truth.with(followed);
        if distance > unit && !(is_carried && distance <= unit + there.carried()) {
            return None;
        }
        // The effect of half of the last digit of each answer, for a student who kept more digits
        // than written.
        let carried = |one: &GradedVariable| {
            let more = by(&|face| match face.slot == one.slot {
                true => Some(face.value + face.half),
                false => Some(face.value),
            });
            more.map_or(0.0, |more| there.difference_from(more).abs())
        };
        if distance > unit {
            let all: f64 = set.iter().map(|face| carried(face)).sum();
            if !(distance <= unit + all.min(there.carried())) {
                return None;
            }
        }
        // The effect of one answer while the others are exact.
        let effect = |one: &GradedVariable| {
            let alone = by(&|face| match face.slot == one.slot {
                true => Some(face.value),
                false => chain.exact_at(face.slot),
            });
            alone.map_or(0.0, |alone| truth.difference_from(alone).abs())
        };
        let effects = set.iter().map(|face| (effect(face), *face));
        let effects: Vec<(f64, &GradedVariable)> = effects.collect();
        // A number that is written everywhere is not a consequence of earlier answers.
        blamed(&effects, unit, |face| face.number == written.value)
    }
}
