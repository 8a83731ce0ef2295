//! How a figure follows from earlier ones, as they were written.

use super::verdict::{FEWEST, FigureVerdict, MOST, RoundedEarly, Truth};
use super::{AnswerKey, AskedFigure, ChainSlot, FacedSlot, SolutionChain, WrittenFigure};

/// Earlier answers are tried together in so many ways at the most: each takes solving the loop equations again.
const MOST_SETS: usize = 40;
/// So few wrong answers may each have been carried on with all digits.
const FEW_WRONG: usize = 2;

impl AnswerKey {
    /// The figure as it follows from earlier ones, all that were written so far or one of them alone.
    pub(super) fn explained(
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
        // What it does not hang on explains nothing.
        let hangs_on = chain.variables_of(&figure.quantity);
        let is_earlier =
            |face: &&FacedSlot| is_earlier(face) && hangs_on.contains(&face.slot.variable);
        let mut earlier: Vec<&FacedSlot> = faced.iter().filter(is_earlier).collect();
        earlier.sort_by_key(|face| place(face.slot));
        // Who writes figures down goes on with them; but some carry the last ones on with all digits.
        let counts = (1..=earlier.len()).rev().take(MOST_SETS / 2);
        // Of one alone: first those that are wrong, and the last ones.
        let mut single: Vec<&FacedSlot> = earlier.iter().rev().copied().collect();
        single.sort_by_key(|face| face.is_sound);
        single.truncate(MOST_SETS / 2);
        if single.len() == earlier.len() {
            single.clone_from(&earlier);
        }
        let mut sets = counts
            .map(|count| &earlier[..count])
            .chain(single.chunks(1));
        // Among many wrong answers one that comes near is chance: digits that were carried on are allowed for where few
        // are wrong, or all are taken together.
        let wrong = earlier.iter().filter(|face| !face.is_sound).count();
        sets.find_map(|set| {
            let is_carried = wrong <= FEW_WRONG || set.len() == earlier.len();
            let is_carried = is_carried && set.iter().any(|face| !face.is_sound);
            self.explanation((chain, &hangs_on), figure, written, (set, is_carried))
        })
    }

    /// The figure as it follows from some at their face value, where that is what was written.
    fn explanation(
        &self,
        (chain, hangs_on): (&SolutionChain, &[usize]),
        figure: &AskedFigure,
        written: WrittenFigure,
        (set, is_carried): (&[&FacedSlot], bool),
    ) -> Option<FigureVerdict> {
        let truth = Truth::of(figure);
        let by = |face: &dyn Fn(&FacedSlot) -> Option<f64>| {
            let given = |slot| {
                let mut faces = set.iter();
                face(faces.find(|face| face.slot == slot)?)
            };
            chain.figure(&figure.quantity, &chain.follow_for(hangs_on, &given)?)
        };
        let followed = by(&|face| Some(face.value))?;
        let apart = truth.with(followed).apart(written.value).abs();
        let unit = written.unit_of(FEWEST, MOST);
        // What is no nearer to it than to the exact figure explains nothing.
        if !(apart <= 0.5 * truth.apart(written.value).abs()) {
            return None;
        }
        let there = truth.with(followed);
        if apart > unit && !(is_carried && apart <= unit + there.carried()) {
            return None;
        }
        // Who carried all digits on wrote fewer: what half of the last digit of each does.
        let carried = |one: &FacedSlot| {
            let more = by(&|face| match face.slot == one.slot {
                true => Some(face.value + face.half),
                false => Some(face.value),
            });
            more.map_or(0.0, |more| there.apart(more).abs())
        };
        if apart > unit {
            let all: f64 = set.iter().map(|face| carried(face)).sum();
            if !(apart <= unit + all.min(there.carried())) {
                return None;
            }
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
            // Who writes the same number everywhere follows from nothing.
            Some((effect, face)) if effect > unit && face.number == written.value => return None,
            Some((effect, face)) if effect > unit => FigureVerdict::Followed(face.figure),
            _ => {
                let (_, face) = largest(&|face| face.is_sound)?;
                FigureVerdict::Rounded(RoundedEarly::By(face.figure))
            }
        })
    }
}
