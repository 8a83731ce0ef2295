//! Tables of sensitivities: how each value responds to the given lengths, at worst and for which
//! length most.

use crate::page::{Content, Setting, Table};
use crate::quantity::{Derivatives, Sensitivity};
use crate::report::tables::data::number;
use crate::report::text::number::significant;
use crate::wording::{english_words, words};
use serde_json::{Map, Value, json};

/// The sensitivity of one value to the given lengths.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The name of the value: `C.x`.
    pub name: String,
    /// The unit of the value.
    pub unit: String,
    /// The maximum change of the value if every length changes by at most one unit; in the value's
    /// unit per unit of length.
    pub worst: f64,
    /// The length with the largest derivative, and that derivative; `None` if all derivatives are
    /// zero.
    pub most: Option<(String, f64)>,
    /// The nonzero derivatives by lengths, in the order of the lengths.
    pub by: Vec<(String, f64)>,
}

/// The sensitivities of all values at one coordinate of the driver.
#[derive(Clone, Debug, PartialEq)]
pub struct Answers {
    /// The symbol of the unit of length.
    pub unit: &'static str,
    /// The values that exist; `None` if derivatives do not exist or cannot be computed.
    pub list: Option<Vec<Answer>>,
    /// The number of values that exist but are not in the list: a formula has no derivatives at a
    /// kink.
    pub missing_derivatives: usize,
}

/// Significant digits of a derivative in text.
const DIGITS: usize = 3;

impl Answers {
    /// Computes the sensitivities at a coordinate of the driver.
    #[must_use]
    pub fn at(sensitivity: &mut Sensitivity, unit: &'static str, at: f64) -> Self {
        let found = sensitivity.at(at);
        let count = sensitivity.figures().len();
        let missing = |found: &Derivatives| (0..count).filter(|&i| found.has_kink(i)).count();
        let missing = found.as_ref().map_or(0, missing);
        let list = found.map(|found| {
            let lengths = sensitivity.lengths();
            let quantities = sensitivity.figures().iter().enumerate();
            let answer = quantities.filter_map(|(i, quantity)| {
                let by = lengths.iter().cloned().zip(found.of(i)?.iter().copied());
                Some(Answer {
                    name: quantity.name.clone(),
                    unit: quantity.unit.clone(),
                    worst: found.worst(i)?,
                    most: found
                        .largest_effect(i)
                        .map(|(length, d)| (lengths[length].clone(), d)),
                    by: by.filter(|(_, derivative)| *derivative != 0.0).collect(),
                })
            });
            answer.collect()
        });
        Answers {
            unit,
            list,
            missing_derivatives: missing,
        }
    }

    /// Removes values that do not depend on any length, and values that are lengths themselves.
    #[must_use]
    pub fn without_trivial(mut self) -> Self {
        let text = |answer: &Answer| answer.by.iter().any(|(length, _)| *length != answer.name);
        if let Some(list) = &mut self.list {
            list.retain(text);
        }
        self
    }

    /// Returns the number of values for which derivatives were requested; 0 if there are no
    /// derivatives at all.
    #[must_use]
    pub fn requested_count(&self) -> usize {
        self.missing_derivatives + self.list.as_ref().map_or(0, Vec::len)
    }

    /// Returns the sensitivity of the value with this name.
    pub(in crate::report) fn of(&self, name: &str) -> Option<&Answer> {
        self.list
            .as_ref()?
            .iter()
            .find(|answer| answer.name == name)
    }

    /// Returns a table with a row per value, or the reason why there is none.
    #[must_use]
    pub fn content(&self, units: bool) -> Content {
        let step = if units {
            words().change_for_one(self.unit)
        } else {
            words().change_for_length().to_owned()
        };
        let Some(list) = &self.list else {
            let why = words().no_derivatives_by_lengths();
            return Content::Text(words().without_change(&step, why));
        };
        let names = step.chars().count() + 2;
        let headers = [
            words().in_every_length(),
            words().in_one(),
            words().in_which(),
        ];
        let mut table = Table::new(step, headers).set(Setting {
            names,
            least: vec![DIGITS + 2],
            ..Setting::default()
        });
        for answer in list {
            let (maximum, length) = answer.largest_derivative();
            table.row(answer.name(units), [answer.worst(), maximum, length]);
        }
        Content::Table(table)
    }

    /// Returns a short table: the maximum change of each value, and the length with the largest
    /// derivative. Returns `None` if there are no derivatives.
    #[must_use]
    pub fn short_table(&self) -> Option<Table> {
        let headers = [words().in_all(), words().most_in()];
        let mut table = Table::new(format!("1 {}", self.unit), headers);
        for answer in self.list.as_ref()? {
            table.row(
                answer.name(false),
                [answer.worst(), answer.largest_derivative().1],
            );
        }
        Some(table)
    }

    /// Returns an object per value, keyed by its name; `null` if there are no derivatives.
    pub(in crate::report) fn to_json(&self, units: bool) -> Value {
        let Some(list) = &self.list else {
            return Value::Null;
        };
        let mut object = Map::new();
        for answer in list {
            let by = answer.by.iter();
            let by: Map<_, _> = by.map(|(l, d)| (l.clone(), number(Some(*d)))).collect();
            let maximum = answer.most.as_ref().map(|(length, _)| length.as_str());
            let mut figure = Map::new();
            if units {
                figure.insert("unit".into(), per(&answer.unit, self.unit).into());
            }
            figure.insert("sum".into(), number(Some(answer.worst)));
            figure.insert("most".into(), json!(maximum));
            figure.insert("by".into(), by.into());
            object.insert(answer.name.clone(), figure.into());
        }
        Value::Object(object)
    }
}

impl Answer {
    fn name(&self, units: bool) -> String {
        if units {
            format!("{} [{}]", self.name, self.unit)
        } else {
            self.name.clone()
        }
    }

    fn worst(&self) -> String {
        significant(self.worst, DIGITS)
    }

    /// Returns the largest derivative, and the length to which it belongs.
    fn largest_derivative(&self) -> (String, String) {
        match &self.most {
            Some((length, maximum)) => (significant(*maximum, DIGITS), length.clone()),
            None => ("0".into(), "-".into()),
        }
    }
}

/// Returns the unit of a derivative by a length, for other programs: `rad/s per mm`.
pub(in crate::report) fn per(figure: &str, length: &str) -> String {
    english_words().per(figure, length)
}
