//! Figures that are made of others.

use super::{Aspect, Subject};
use crate::expression::{Code, DirectionCut, Kind, Op, Part};
use crate::{Ball, Dual, Number};

/// How a figure is made of figures that the solver finds.
///
/// There is one way to evaluate it: over doubles, lanes, balls and duals it gives the figure, its bound, and
/// what a length does to it.
#[derive(Clone, Debug, PartialEq)]
pub struct Derived {
    leaves: Vec<Leaf>,
    code: Code,
    kind: Kind,
}

// What it is made of holds no NaN: a formula is written in digits.
impl Eq for Derived {}

/// A figure that the solver finds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Leaf {
    pub(super) subject: Subject,
    pub(super) aspect: Aspect,
    pub(super) name: String,
}

impl Leaf {
    /// Itself, its rate, or the rate of that, if a state has it.
    fn degree(&self, degree: u8) -> Option<Aspect> {
        (0..degree).try_fold(self.aspect, |aspect, _| aspect.rate())
    }
}

impl Derived {
    /// Of checked steps.
    ///
    /// # Errors
    /// The figure of which no rate is known, though the steps ask for one.
    pub(super) fn new(leaves: Vec<Leaf>, code: Code, kind: Kind) -> Result<Derived, String> {
        let missing = code.leaves().find_map(|(leaf, rates)| {
            let leaf = &leaves[usize::from(leaf)];
            leaf.degree(rates).is_none().then(|| leaf.name.clone())
        });
        match missing {
            Some(name) => Err(name),
            None => Ok(Derived { leaves, code, kind }),
        }
    }

    /// What it measures.
    pub(super) fn kind(&self) -> Kind {
        self.kind
    }

    /// The figures that it is made of, and those of their rates that it takes.
    pub(super) fn parts(&self) -> impl Iterator<Item = (Subject, Aspect)> {
        self.code.leaves().flat_map(|(leaf, rates)| {
            let leaf = &self.leaves[usize::from(leaf)];
            (0..=rates).filter_map(|degree| Some((leaf.subject, leaf.degree(degree)?)))
        })
    }

    /// What all of it is about, if that is one thing.
    pub(super) fn subject(&self) -> Option<Subject> {
        let first = self.leaves.first()?.subject;
        let is_same = self.leaves.iter().all(|leaf| leaf.subject == first);
        is_same.then_some(first)
    }

    /// Its steps as a part of another formula that is made of these figures.
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

    /// Its slope over time; the figure that has none, where it does not exist.
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

    /// The figure, where those exist that it is made of: `find` has them.
    pub(super) fn run<T: Number>(&self, find: impl Fn(Subject, Aspect) -> Option<T>) -> Option<T> {
        self.code.run(|leaf, degree| {
            let leaf = &self.leaves[usize::from(leaf)];
            find(leaf.subject, leaf.degree(degree)?)
        })
    }
}

impl Derived {
    /// How it jumps where a direction in it passes a full turn.
    pub(super) fn cut(&self) -> DirectionCut {
        self.code.cut(|leaf| {
            let Leaf {
                subject, aspect, ..
            } = &self.leaves[usize::from(leaf)];
            aspect.kind(*subject).revolution.is_some()
        })
    }

    /// Whether any of its steps can turn over.
    pub(super) fn has_sides(&self) -> bool {
        self.code.has_sides()
    }

    /// The steps that may turn over within the bounds of what they take.
    pub(super) fn kinks(&self, find: impl Fn(Subject, Aspect) -> Option<Ball>) -> Vec<usize> {
        self.code.kinks(|leaf, degree| {
            let leaf = &self.leaves[usize::from(leaf)];
            find(leaf.subject, leaf.degree(degree)?)
        })
    }

    /// The figure with these steps on their other side.
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

/// The number of a figure among those of a formula, which it joins.
pub(super) fn number(leaves: &mut Vec<Leaf>, leaf: &Leaf) -> u16 {
    let known = leaves.iter().position(|other| other == leaf);
    let number = known.unwrap_or_else(|| {
        leaves.push(leaf.clone());
        leaves.len() - 1
    });
    // A formula has fewer steps than this has numbers.
    u16::try_from(number).unwrap_or(u16::MAX)
}
