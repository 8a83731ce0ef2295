//! The values of the open scene as edited: cursor, step size, and differences from the file.

use crate::scene::{Measure, Scene, Value};
use crate::tui::commands::list::moved;
use crate::tui::document::history::History;
use crate::tui::document::staged_edits::{DroppedEdits, StagedEdits};
use std::collections::HashMap;

/// A step for nudging a value: 1, 2 or 5 times a power of ten, in the value's own unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct NudgeStep {
    digit: u8,
    exponent: i32,
}

/// Exponents of the finest and coarsest step. Steps beyond have no practical effect.
const MIN_STEP_EXPONENT: i32 = -12;
const COARSEST: i32 = 12;
/// Size of a step relative to the value.
const PART: f64 = 0.01;
/// The step of an angle: one degree, independent of the value.
const DEGREE: NudgeStep = NudgeStep {
    digit: 1,
    exponent: 0,
};

impl NudgeStep {
    /// Returns the largest step that is at most `size`.
    fn below(size: f64) -> NudgeStep {
        let exponent = size.log10().floor();
        #[expect(
            clippy::cast_possible_truncation,
            reason = "between two small integers"
        )]
        let exponent = exponent.clamp(f64::from(MIN_STEP_EXPONENT), f64::from(COARSEST)) as i32;
        // The factor keeps rounding from missing a size that equals a step.
        let lead = size / 10.0_f64.powi(exponent) * (1.0 + 1e-9);
        let digit = [5, 2].into_iter().find(|&d| lead >= f64::from(d));
        NudgeStep {
            digit: digit.unwrap_or(1),
            exponent,
        }
    }

    /// Returns the step, rounded as its decimal notation.
    pub(crate) fn size(self) -> f64 {
        // A digit with a small exponent always parses.
        self.to_string().parse().unwrap_or(1.0)
    }

    fn finer(self) -> NudgeStep {
        let (digit, exponent) = match self.digit {
            5 => (2, self.exponent),
            2 => (1, self.exponent),
            _ => (5, self.exponent - 1),
        };
        if exponent < MIN_STEP_EXPONENT {
            return self;
        }
        NudgeStep { digit, exponent }
    }

    fn coarser(self) -> NudgeStep {
        let (digit, exponent) = match self.digit {
            1 => (2, self.exponent),
            2 => (5, self.exponent),
            _ => (1, self.exponent + 1),
        };
        if exponent > COARSEST {
            return self;
        }
        NudgeStep { digit, exponent }
    }
}

impl std::fmt::Display for NudgeStep {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let exponent = usize::try_from(self.exponent.unsigned_abs()).unwrap_or(0);
        let digit = self.digit;
        match self.exponent {
            0..=3 => write!(f, "{digit}{}", "0".repeat(exponent)),
            -4..0 => write!(f, "0.{}{digit}", "0".repeat(exponent - 1)),
            _ => write!(f, "{digit}e{}", self.exponent),
        }
    }
}

/// Returns the name of the part that a value belongs to: `r2` of `r2 com x`.
pub(crate) fn part_of(value: &Value) -> &str {
    value.name.split(' ').next().unwrap_or_default()
}

/// The saved scene, the changes since, and the cursor in the list of values.
#[derive(Debug)]
pub(crate) struct Editor {
    /// The text as last opened or saved.
    saved: String,
    /// `true` if the file was last seen with other contents, or not at all.
    pub(crate) is_file_other: bool,
    /// The values of the saved text, by name.
    file_values: HashMap<String, Value>,
    /// The values of the shown scene.
    values: Vec<Value>,
    /// The row under the cursor.
    cursor: usize,
    /// The default step for the value under the cursor, computed when the cursor reached it.
    fitting: NudgeStep,
    /// The steps chosen by the user, each for all values with the same measure.
    chosen: Vec<(Measure, NudgeStep)>,
    pub(crate) history: History,
    /// The staged edits; `None` while each edit is applied at once.
    pub(crate) staged: Option<StagedEdits>,
    /// The last dropped edits, which can be restored.
    dropped: Option<DroppedEdits>,
}

impl Editor {
    /// Creates an editor for an opened scene without changes.
    pub(crate) fn new(scene: &Scene) -> Editor {
        Editor {
            saved: scene.text().to_owned(),
            is_file_other: false,
            file_values: HashMap::new(),
            values: Vec::new(),
            cursor: 0,
            fitting: DEGREE,
            chosen: Vec::new(),
            history: History::default(),
            staged: None,
            dropped: None,
        }
    }

    /// Ends staging and returns the number of dropped edits; `None` if no staging was active. The
    /// edits can be restored while the scene has the text `text`.
    pub(crate) fn drop_staged(&mut self, text: &str) -> Option<usize> {
        let edits = self.staged.take()?;
        let count = edits.len();
        if count > 0 {
            let text = text.to_owned();
            self.dropped = Some(DroppedEdits { edits, text });
        }
        Some(count)
    }

    /// Restores the dropped edits if the scene has the same text as then. Returns `true` if it did.
    pub(crate) fn restore_dropped_edits(&mut self, text: &str) -> bool {
        let dropped = self.dropped.take_if(|dropped| dropped.text == text);
        let is_any = dropped.is_some();
        if let Some(DroppedEdits { edits, .. }) = dropped {
            self.staged = Some(edits);
        }
        is_any
    }

    /// Notes that the file holds `text` now.
    pub(crate) fn filed(&mut self, text: &str) {
        text.clone_into(&mut self.saved);
        self.is_file_other = false;
        self.file_values.clear();
    }

    /// Returns the text that the file holds.
    pub(crate) fn saved(&self) -> &str {
        &self.saved
    }

    /// Returns `true` if a scene differs from the file.
    pub(crate) fn is_changed(&self, scene: &Scene) -> bool {
        scene.text() != self.saved
    }

    /// Lists the values of the shown scene.
    pub(crate) fn list(&mut self, scene: &Scene) {
        let before = self.value().map(|v| v.name.clone());
        self.values = scene.values();
        if self.file_values.is_empty() {
            let filed = match self.is_changed(scene) {
                true => Scene::parse(&self.saved, scene.origin()).map(|scene| scene.values()),
                false => Ok(self.values.clone()),
            };
            let filed = filed.unwrap_or_default().into_iter();
            self.file_values = filed.map(|value| (value.name.clone(), value)).collect();
        }
        // Rows above the cursor may have been added or removed: the cursor stays on its value.
        let same = before.and_then(|name| self.values.iter().position(|v| v.name == name));
        match same {
            Some(row) => self.cursor = row,
            None => self.go(moved(self.cursor, 0, self.values.len())),
        }
    }

    pub(crate) fn values(&self) -> &[Value] {
        &self.values
    }

    /// Returns the row of a value by its name.
    pub(crate) fn row(&self, name: &str) -> Option<usize> {
        self.values.iter().position(|value| value.name == name)
    }

    /// Returns a value by its name.
    pub(crate) fn named(&self, name: &str) -> Option<&Value> {
        self.values.get(self.row(name)?)
    }

    pub(crate) fn cursor(&self) -> usize {
        self.cursor
    }

    /// Returns the value under the cursor.
    pub(crate) fn value(&self) -> Option<&Value> {
        self.values.get(self.cursor)
    }

    /// Returns the file's version of a value, if it differs.
    pub(crate) fn in_file(&self, value: &Value) -> Option<&Value> {
        let filed = self.file_values.get(&value.name)?;
        (filed.literal != value.literal || filed.unit != value.unit).then_some(filed)
    }

    /// Returns `true` if the file has no such value.
    pub(crate) fn is_new(&self, value: &Value) -> bool {
        !self.file_values.contains_key(&value.name)
    }

    /// Returns the number of values that differ from the file.
    pub(crate) fn changes(&self) -> usize {
        let changed = |v: &&Value| self.in_file(v).is_some() || self.is_new(v);
        self.values.iter().filter(changed).count()
    }

    /// Returns the text to write for a value: the file's notation if the number and unit are equal.
    pub(crate) fn in_file_notation(&self, value: &Value, text: String) -> String {
        let number = |text: &str| {
            let number = text.split(' ').next().unwrap_or(text);
            let unit = text.strip_prefix(number).map(str::trim);
            (
                number.replace('_', "").parse::<f64>().ok(),
                unit.map(str::to_owned),
            )
        };
        let filed = self.file_values.get(&value.name).map(Value::text);
        let same =
            filed.filter(|filed| number(filed).0.is_some() && number(filed) == number(&text));
        same.unwrap_or(text)
    }

    /// Moves the cursor by rows, within the list.
    pub(crate) fn move_by(&mut self, rows: isize) {
        self.go_to(moved(self.cursor, rows, self.values.len()));
    }

    /// Moves the cursor to a row.
    pub(crate) fn go_to(&mut self, row: usize) {
        let row = moved(row, 0, self.values.len());
        if row != self.cursor {
            self.go(row);
        }
    }

    /// Moves the cursor to the first value of the next part, or back to the first value of this or
    /// the previous part. Does not move if there is none.
    pub(crate) fn go_to_part(&mut self, next: bool) {
        let starts = |row: &usize| {
            *row == 0 || part_of(&self.values[*row]) != part_of(&self.values[*row - 1])
        };
        let found = match next {
            true => (self.cursor + 1..self.values.len()).find(starts),
            false => (0..self.cursor.min(self.values.len())).rfind(starts),
        };
        if let Some(row) = found {
            self.go_to(row);
        }
    }

    fn go(&mut self, row: usize) {
        self.cursor = row;
        self.history.part();
        self.fit();
    }

    /// Moves the cursor to the next value whose name contains `text`, ignoring case. Starts at the
    /// current value, behind it if `step` is positive, or before it and backwards if `step` is
    /// negative. Returns `false` if there is none.
    pub(crate) fn seek(&mut self, text: &str, step: isize) -> bool {
        let query = text.to_ascii_lowercase();
        let count = self.values.len();
        let rows = (0..count).map(|i| match step < 0 {
            true => (self.cursor + count - 1 - i) % count,
            false => (self.cursor + i + usize::from(step > 0)) % count,
        });
        let mut found = rows.filter(|&row| {
            let name = self.values[row].name.to_ascii_lowercase();
            name.contains(&query)
        });
        let Some(row) = found.next() else {
            return false;
        };
        self.go_to(row);
        true
    }

    /// Computes the default step for the value under the cursor.
    pub(crate) fn fit(&mut self) {
        let Some(value) = self.value() else { return };
        let own = value.number.abs();
        let size = if own > 0.0 {
            own
        } else {
            // For a zero coordinate, the largest value of a similar measure sets the scale.
            let others = self
                .values
                .iter()
                .filter(|v| is_alike(v.measure, value.measure));
            others.map(|v| v.number.abs()).fold(0.0, f64::max)
        };
        self.fitting = match value.measure {
            Measure::Angle => DEGREE,
            _ if size > 0.0 => NudgeStep::below(PART * size),
            _ => NudgeStep::below(1.0),
        };
    }

    /// Returns the step for the value under the cursor.
    pub(crate) fn notch(&self) -> NudgeStep {
        let chosen = |value: &Value| {
            let mut chosen = self.chosen.iter();
            chosen.find(|(measure, _)| *measure == value.measure)
        };
        let chosen = self.value().and_then(chosen);
        chosen.map_or(self.fitting, |(_, notch)| *notch)
    }

    /// Decreases the step.
    pub(crate) fn finer(&mut self) {
        self.choose(self.notch().finer());
    }

    /// Increases the step.
    pub(crate) fn coarser(&mut self) {
        self.choose(self.notch().coarser());
    }

    fn choose(&mut self, notch: NudgeStep) {
        let Some(measure) = self.value().map(|v| v.measure) else {
            return;
        };
        self.chosen.retain(|(of, _)| *of != measure);
        self.chosen.push((measure, notch));
    }
}

/// Returns `true` if two measures are comparable: all measures in the scene's length unit are.
fn is_alike(one: Measure, other: Measure) -> bool {
    let in_length = |m| matches!(m, Measure::Length | Measure::Coordinate | Measure::Start);
    one == other || (in_length(one) && in_length(other))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    fn editor(name: &str) -> (Scene, Editor) {
        let preset = presets::find(name).unwrap();
        let scene = Scene::parse(preset.text, name).unwrap();
        let mut editor = Editor::new(&scene);
        editor.list(&scene);
        editor.fit();
        (scene, editor)
    }

    #[test]
    fn steps_are_round_and_proportional_to_value() {
        for (size, text) in [
            (100.0, "1"),
            (250.0, "2"),
            (7.0, "0.05"),
            (0.03, "0.0002"),
            (1e-9, "1e-11"),
            (5e6, "5e4"),
            (1e300, "5e12"),
        ] {
            let notch = NudgeStep::below(PART * size);
            assert_eq!(notch.to_string(), text);
            assert_eq!(notch.size(), text.parse::<f64>().unwrap());
        }
        let mut notch = NudgeStep::below(1.0);
        let coarser: Vec<String> = (0..5)
            .map(|_| {
                notch = notch.coarser();
                notch.to_string()
            })
            .collect();
        assert_eq!(coarser, ["2", "5", "10", "20", "50"]);
        for _ in 0..5 {
            notch = notch.finer();
        }
        assert_eq!(notch, NudgeStep::below(1.0));
        for _ in 0..100 {
            notch = notch.finer();
        }
        assert!(notch.size() > 0.0);
    }

    #[test]
    fn zero_values_use_step_of_largest_value() {
        let (_, editor) = editor("four-bar");
        assert_eq!(editor.value().unwrap().name, "A x");
        assert_eq!(editor.notch().to_string(), "2");
    }

    #[test]
    fn chosen_step_applies_to_values_of_one_kind() {
        let (_, mut editor) = editor("four-bar");
        assert!(editor.seek("r2 length", 0));
        assert_eq!(editor.notch().to_string(), "1");
        editor.finer();
        assert!(editor.seek("r3 LEN", 0));
        assert_eq!(editor.notch().to_string(), "0.5");
        assert!(editor.seek("driver angle", 0));
        assert_eq!(editor.notch(), DEGREE);
        assert!(!editor.seek("nowhere", 0));
        assert_eq!(editor.value().unwrap().name, "driver angle");
    }

    #[test]
    fn restored_number_keeps_its_literal() {
        let (scene, mut editor) = editor("excavator-boom");
        assert!(editor.seek("driver position", 0));
        let value = editor.value().unwrap().clone();
        assert_eq!(value.literal, "2.0");
        let mut moved = value.clone();
        moved.number = 2.02;
        assert_eq!(moved.moved(-1.0, 0.02), "2");
        let text = editor.in_file_notation(&value, moved.moved(-1.0, 0.02));
        assert_eq!(scene.with_value(&value, &text), scene.text());
    }
}
