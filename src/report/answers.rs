//! How figures answer to the given lengths, for tables: by how much each is off at the worst, and which
//! length matters most.

use super::number::significant;
use super::tables_data::number;
use crate::page::{Content, Setting, Table};
use crate::quantity::{Derivatives, Sensitivity};
use crate::wording::{for_programs, words};
use serde_json::{Map, Value, json};

/// What the given lengths do to one figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The figure's name: `C.x`.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// By how much it is off at the worst where every length is off by one unit: in its unit, per unit
    /// of length.
    pub worst: f64,
    /// The length that matters most, and the derivative by it; `None` where no length matters.
    pub most: Option<(String, f64)>,
    /// The derivatives by all lengths that matter, in their order.
    pub by: Vec<(String, f64)>,
}

/// What the given lengths do to all figures at one coordinate of the driver.
#[derive(Clone, Debug, PartialEq)]
pub struct Answers {
    /// The symbol of the length unit.
    pub unit: &'static str,
    /// The figures that have a value; `None` where no derivatives exist or can be had.
    pub list: Option<Vec<Answer>>,
    /// How many figures have a value and are not in the list, where there is one: a formula that turns over just
    /// here has no derivatives.
    pub lacking: usize,
}

/// Digits of a derivative that is read by eye.
const DIGITS: usize = 3;

impl Answers {
    /// At a coordinate of the driver.
    #[must_use]
    pub fn at(sensitivity: &mut Sensitivity, unit: &'static str, at: f64) -> Self {
        let found = sensitivity.at(at);
        let count = sensitivity.figures().len();
        let lacking = |found: &Derivatives| (0..count).filter(|&i| found.lacks(i)).count();
        let lacking = found.as_ref().map_or(0, lacking);
        let list = found.map(|found| {
            let lengths = sensitivity.lengths();
            let figures = sensitivity.figures().iter().enumerate();
            let answer = figures.filter_map(|(i, figure)| {
                let by = lengths.iter().cloned().zip(found.of(i)?.iter().copied());
                Some(Answer {
                    name: figure.name.clone(),
                    unit: figure.unit.clone(),
                    worst: found.worst(i)?,
                    most: found
                        .most(i)
                        .map(|(length, d)| (lengths[length].clone(), d)),
                    by: by.filter(|(_, derivative)| *derivative != 0.0).collect(),
                })
            });
            answer.collect()
        });
        Answers {
            unit,
            list,
            lacking,
        }
    }

    /// Leaves out what no length changes, and what is a length itself: it says nothing to a reader.
    #[must_use]
    pub fn worth_reading(mut self) -> Self {
        let says = |answer: &Answer| answer.by.iter().any(|(length, _)| *length != answer.name);
        if let Some(list) = &mut self.list {
            list.retain(says);
        }
        self
    }

    /// How many figures with a value were asked about, where there are derivatives.
    #[must_use]
    pub fn asked(&self) -> usize {
        self.lacking + self.list.as_ref().map_or(0, Vec::len)
    }

    /// What stands for one figure.
    pub(super) fn of(&self, name: &str) -> Option<&Answer> {
        self.list
            .as_ref()?
            .iter()
            .find(|answer| answer.name == name)
    }

    /// A row per figure; or why there are none.
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
        let heads = [
            words().in_every_length(),
            words().in_one(),
            words().in_which(),
        ];
        let mut table = Table::new(step, heads).set(Setting {
            names,
            least: vec![DIGITS + 2],
            ..Setting::default()
        });
        for answer in list {
            let (most, length) = answer.most();
            table.row(answer.name(units), [answer.worst(), most, length]);
        }
        Content::Table(table)
    }

    /// The same where there is little room: how much each figure changes, and with which length most.
    #[must_use]
    pub fn short_table(&self) -> Option<Table> {
        let heads = [words().in_all(), words().most_in()];
        let mut table = Table::new(format!("1 {}", self.unit), heads);
        for answer in self.list.as_ref()? {
            table.row(answer.name(false), [answer.worst(), answer.most().1]);
        }
        Some(table)
    }

    /// An object per figure, keyed by its name; `null` where there are none.
    pub(super) fn to_json(&self, units: bool) -> Value {
        let Some(list) = &self.list else {
            return Value::Null;
        };
        let mut object = Map::new();
        for answer in list {
            let by = answer.by.iter();
            let by: Map<_, _> = by.map(|(l, d)| (l.clone(), number(Some(*d)))).collect();
            let most = answer.most.as_ref().map(|(length, _)| length.as_str());
            let mut figure = Map::new();
            if units {
                figure.insert("unit".into(), per(&answer.unit, self.unit).into());
            }
            figure.insert("sum".into(), number(Some(answer.worst)));
            figure.insert("most".into(), json!(most));
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

    /// The largest derivative, and the length that it is by.
    fn most(&self) -> (String, String) {
        match &self.most {
            Some((length, most)) => (significant(*most, DIGITS), length.clone()),
            None => ("0".into(), "-".into()),
        }
    }
}

/// The unit of a derivative by a length, for other programs: `rad/s per mm`.
pub(super) fn per(figure: &str, length: &str) -> String {
    for_programs().per(figure, length)
}
