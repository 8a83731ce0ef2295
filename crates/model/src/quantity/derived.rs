//! Computes quantities from other quantities.

use super::{Aspect, Subject};
use crate::expression::{Code, DirectionCut, Kind, Op, Part};
use crate::{Ball, Dual, Number};

/// A formula over values of the solver.
///
/// One evaluation routine serves all arithmetics: doubles and lanes give the value, balls its
/// bound, duals its derivative by a length.
#[derive(Clone, Debug, PartialEq)]
pub struct Derived {
    leaves: Vec<Leaf>,
    code: Code,
    kind: Kind,
}

// Formulas contain no NaN, because they are written in digits.
impl Eq for Derived {}

/// A value computed by the solver.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Leaf {
    pub(super) subject: Subject,
    pub(super) aspect: Aspect,
    pub(super) name: String,
}

impl Leaf {
    /// Returns the aspect differentiated `degree` times by time, if a state has it.
    fn degree(&self, degree: u8) -> Option<Aspect> {
        (0..degree).try_fold(self.aspect, |aspect, _| aspect.rate())
    }
}

impl Derived {
    /// Creates a formula from checked steps.
    ///
    /// # Errors
    /// The name of a quantity without a rate that the steps need.
    pub(super) fn new(leaves: Vec<Leaf>, code: Code, kind: Kind) -> Result<Derived, String> {
        let missing = code.inputs_with_rates().find_map(|(leaf, rates)| {
            let leaf = &leaves[usize::from(leaf)];
            leaf.degree(rates).is_none().then(|| leaf.name.clone())
        });
        match missing {
            Some(name) => Err(name),
            None => Ok(Derived { leaves, code, kind }),
        }
    }

    /// Returns the dimension and kind.
    pub(super) fn kind(&self) -> Kind {
        self.kind
    }

    /// Returns the solver's values, and those of their rates, that the formula reads.
    pub(super) fn parts(&self) -> impl Iterator<Item = (Subject, Aspect)> {
        self.code.inputs_with_rates().flat_map(|(leaf, rates)| {
            let leaf = &self.leaves[usize::from(leaf)];
            (0..=rates).filter_map(|degree| Some((leaf.subject, leaf.degree(degree)?)))
        })
    }

    /// Returns the subject of all its values, if it is one.
    pub(super) fn subject(&self) -> Option<Subject> {
        let first = self.leaves.first()?.subject;
        let is_same = self.leaves.iter().all(|leaf| leaf.subject == first);
        is_same.then_some(first)
    }

    /// Returns the steps as a part of another formula with the values `leaves`, which grows as
    /// needed.
    pub(super) fn part(&self, leaves: &mut Vec<Leaf>) -> Part {
        let numbers: Vec<u16> = self
            .leaves
            .iter()
            .map(|leaf| number(leaves, leaf))
            .collect();
        let ops = self.code.ops().iter().map(|op| match op {
            Op::Leaf(leaf) => Op::Leaf(numbers[usize::from(*leaf)]),
            op => *op,
        });
        Part {
            ops: ops.collect(),
            kind: self.kind,
        }
    }

    /// Returns the time derivative.
    ///
    /// # Errors
    /// The name of the quantity without a derivative.
    pub(super) fn rate(&self) -> Result<Derived, String> {
        let mut ops = self.code.ops().to_vec();
        ops.push(Op::Rate);
        let first = || self.leaves.first().map_or("1", |leaf| &leaf.name);
        let code = Code::new(ops).map_err(|_| first().to_owned())?;
        let kind = Kind {
            dimension: self.kind.dimension.rate(),
            revolution: None,
            ..self.kind
        };
        Derived::new(self.leaves.clone(), code, kind)
    }

    /// Evaluates the formula with the values given by `find`; `None` if one of them is missing.
    pub(super) fn run<T: Number>(&self, find: impl Fn(Subject, Aspect) -> Option<T>) -> Option<T> {
        self.code.run(|leaf, degree| {
            let leaf = &self.leaves[usize::from(leaf)];
            find(leaf.subject, leaf.degree(degree)?)
        })
    }
}

impl Derived {
    /// Returns how it jumps where a direction in it passes a full turn.
    pub(super) fn cut(&self) -> DirectionCut {
        self.code.cut(|leaf| {
            let Leaf {
                subject, aspect, ..
            } = &self.leaves[usize::from(leaf)];
            aspect.kind(*subject).revolution.is_some()
        })
    }

    /// Returns `true` if any of its steps has a kink.
    pub(super) fn has_sides(&self) -> bool {
        self.code.has_sides()
    }

    /// Returns the steps that may be at a kink within the bounds of their arguments.
    pub(super) fn kinks(&self, find: impl Fn(Subject, Aspect) -> Option<Ball>) -> Vec<usize> {
        self.code.kinks(|leaf, degree| {
            let leaf = &self.leaves[usize::from(leaf)];
            find(leaf.subject, leaf.degree(degree)?)
        })
    }

    /// Evaluates the formula with these steps on the other side of their kinks.
    pub(super) fn beyond(
        &self,
        kinks: &[usize],
        find: impl Fn(Subject, Aspect) -> Option<Dual>,
    ) -> Option<Dual> {
        self.code.beyond(kinks, |leaf, degree| {
            let leaf = &self.leaves[usize::from(leaf)];
            find(leaf.subject, leaf.degree(degree)?)
        })
    }
}

/// Returns the index of a value in a formula's list, to which it is added if missing.
pub(super) fn number(leaves: &mut Vec<Leaf>, leaf: &Leaf) -> u16 {
    let known = leaves.iter().position(|other| other == leaf);
    let number = known.unwrap_or_else(|| {
        leaves.push(leaf.clone());
        leaves.len() - 1
    });
    // A formula has fewer steps than u16 has values.
    u16::try_from(number).unwrap_or(u16::MAX)
}
