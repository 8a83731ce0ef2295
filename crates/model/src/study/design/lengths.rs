//! Computes the mechanism of a design from its numbers alone, without parsing the scene again.

use super::DesignSpace;
use crate::scene::{DependentValues, Measure, Scene, Value};
use crate::{Length, Mechanism};

/// The relative change of a value that shows which quantities depend on it; absolute for values
/// below 1.
const PROBE: f64 = 1.0 / 64.0;
/// Tolerance for the change found, relative to the change made: rounding error.
const EQUALITY_TOLERANCE: f64 = 1e-9;

/// The lengths that follow from the numbers of a design, by themselves or by formulas.
#[derive(Clone, Debug)]
pub(super) struct DesignLengths {
    values: DependentValues,
    /// The values that set lengths, and those that they are computed from; and the index of the
    /// number of each set length among them.
    needed: DependentValues,
    needed_numbers: Vec<usize>,
    lengths: Vec<SetLength>,
}

/// A length that is set by one number.
#[derive(Clone, Copy, Debug)]
struct SetLength {
    /// The index of the number: first those of the design, then the computed ones.
    number: usize,
    length: Length,
    /// The index of the length among all lengths of the mechanism.
    index: usize,
    /// The given number.
    given: f64,
    measure: Measure,
}

impl SetLength {
    /// Returns the change of the length; `number` is the index of its number. Returns `None` if the
    /// parser would reject it.
    fn change(&self, numbers: &[f64], computed: &[f64], number: usize) -> Option<f64> {
        let number = match number.checked_sub(numbers.len()) {
            None => numbers[number],
            Some(i) => *computed.get(i)?,
        };
        let is_read = number.is_finite() && (number > 0.0 || self.measure == Measure::Coordinate);
        is_read.then_some(number - self.given)
    }
}

impl DesignLengths {
    /// Finds the lengths that follow from the numbers of a space. Returns `None` if something else
    /// that affects the motion follows from them too. All this is determined by changing the text.
    pub(super) fn of(space: &DesignSpace, all: &[Length]) -> Option<DesignLengths> {
        let scene = space.scene();
        let values = DependentValues::of(scene, space.values())?;
        let each = space.values().iter().chain(values.computed()).enumerate();
        let set = each.filter_map(|(number, value)| {
            let index = length_of(value, scene, all)?;
            Some(SetLength {
                number,
                length: all[index],
                index,
                given: value.number,
                measure: value.measure,
            })
        });
        let lengths: Vec<SetLength> = set.collect();
        // A ground point that moves can change whether a copy shares it.
        let is_on_ground = |set: &SetLength| matches!(set.length, Length::Ground(..));
        if scene.has_copies() && lengths.iter().any(is_on_ground) {
            return None;
        }
        let count = space.values().len();
        let sets_length = |i: usize| lengths.iter().any(|set| set.number == count + i);
        let is_needed: Vec<bool> = (0..values.computed().count()).map(sets_length).collect();
        let mut needed = values.clone();
        let kept = needed.keep(&is_needed);
        let place = |set: &SetLength| match set.number.checked_sub(count) {
            None => Some(set.number),
            Some(i) => Some(count + kept.iter().position(|&kept| kept == i)?),
        };
        let needed_numbers = lengths.iter().map(place).collect::<Option<_>>()?;
        let mut found = DesignLengths {
            values,
            needed,
            needed_numbers,
            lengths,
        };
        found.is_complete(space, all).then_some(found)
    }

    /// Returns the mechanism of a design. Returns `None` if the parser would reject a length, or if
    /// a formula has no value.
    pub(super) fn mechanism(&mut self, space: &DesignSpace, numbers: &[f64]) -> Option<Mechanism> {
        let computed = self.values.numbers(numbers)?;
        let changes = self.lengths.iter().map(|set| {
            let change = set.change(numbers, &computed, set.number)?;
            Some((set.length, change))
        });
        let changes: Option<Vec<(Length, f64)>> = changes.collect();
        Some(space.solver().mechanism().all_changed(changes?))
    }

    /// Writes by how much each length of the mechanism is longer in a design. Returns `None` if the
    /// parser would reject a length, or if a formula of one has no value.
    pub(super) fn write_changes(&mut self, numbers: &[f64], to: &mut [f64]) -> Option<()> {
        let computed = self.needed.numbers(numbers)?;
        to.fill(0.0);
        for (set, &number) in self.lengths.iter().zip(&self.needed_numbers) {
            to[set.index] = set.change(numbers, &computed, number)?;
        }
        Some(())
    }

    /// Returns the length that each number sets; `None` if a number sets none or several.
    pub(super) fn by_number(&self) -> Option<Vec<Length>> {
        let mut sets = self.lengths.iter().enumerate();
        let is_own =
            self.values.computed().next().is_none() && sets.all(|(i, set)| set.number == i);
        is_own.then(|| self.lengths.iter().map(|set| set.length).collect())
    }

    /// Returns `true` if the scene with other numbers has the mechanism computed from them.
    fn is_complete(&mut self, space: &DesignSpace, all: &[Length]) -> bool {
        let values = space.values().iter();
        let numbers: Vec<f64> = values.map(|value| value.number + probe(value)).collect();
        let parsed = space.parse(&numbers).ok();
        let made = self.mechanism(space, &numbers);
        parsed.zip(made).is_some_and(|(parsed, made)| {
            let other = &parsed.mechanism;
            let finest = EQUALITY_TOLERANCE * other.reach();
            let [a, b] = [&made, other].map(Mechanism::driver);
            let rates = |driver: &crate::Driver| [driver.start, driver.speed, driver.acceleration];
            let is_same = |by: Vec<f64>| by.iter().all(|by| by.abs() <= finest);
            made.longer(other, all).is_some_and(is_same)
                && rates(a) == rates(b)
                && made.limits() == other.limits()
        })
    }
}

/// Returns the change of a value that shows what depends on it.
fn probe(value: &Value) -> f64 {
    PROBE * value.number.abs().max(1.0)
}

/// Returns the index of the length that a value sets; `None` if it sets none or more than that.
fn length_of(value: &Value, scene: &Scene, lengths: &[Length]) -> Option<usize> {
    if !matches!(value.measure, Measure::Length | Measure::Coordinate) {
        return None;
    }
    let by = probe(value);
    let text = scene.with_value(value, &value.with_number(value.number + by));
    let other = scene.reparse(&text)?;
    if !other.has_elements_of(scene) {
        return None;
    }
    let changes = scene.mechanism.longer(&other.mechanism, lengths)?;
    let mut changed = changes.into_iter().enumerate().filter(|(_, by)| *by != 0.0);
    let (index, found) = changed.next()?;
    let is_all = changed.next().is_none() && (found - by).abs() <= EQUALITY_TOLERANCE * by;
    is_all.then_some(index)
}
