#![doc = include_str!("../../guide/rank.md")]

mod assemble;
mod exchange;
mod redundancy;
mod rows;
mod spectrum;
mod verdict;

use super::Solver;
use super::fault::Fault;
use super::network::{Network, ScalarEquation};
use super::order::{self, Ordering};
use crate::{ElementId, PointId, Vec2};
use std::collections::VecDeque;
use verdict::{RankVerdict, Whole};

/// Unknowns of which a dense decomposition is made, at the most: it costs their cube, and this many
/// take about a second. Above it the structure's answer stands.
const MOST_UNKNOWNS: usize = 420;

/// Choices of what to set aside that are tried, by what the rank says and in turn.
const MOST_TRIED: usize = 6;
const MOST_RIVALS: usize = 64;

/// A constraint that repeats others.
#[derive(Clone, Debug, PartialEq)]
pub struct Redundancy {
    /// What was set aside for it.
    pub element: ElementId,
    /// How many constraints of this element were.
    pub constraints: usize,
    /// What else takes part: any of these could have been set aside in its stead. Empty where the
    /// mechanism is too large to tell.
    pub repeats: Vec<ElementId>,
    /// By how much they disagree at the most over the motion, in the scene's length unit; of slides that
    /// hold one link at one angle, at the end of the longest length.
    pub misfit: f64,
}

/// What the rank of the constraints says of a mechanism that moves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rank {
    /// The constraints that repeat others.
    pub redundancies: Vec<Redundancy>,
    /// Whether a singular value at the start lies so near zero that rounding, or the misfit that is
    /// accepted, could hide a motion that the driver does not determine.
    pub is_unclear: bool,
    /// Whether more can move where the scene opens than elsewhere: a change point, or a dead point.
    pub is_lower_at_start: bool,
}

impl Fault {
    /// Whether it may come from constraints that repeat others where the structure sees none, or others
    /// than it set aside.
    fn asks_for_the_rank(&self, ordering: Option<&Ordering>) -> bool {
        match self {
            Fault::Singular { .. }
            | Fault::NotAssembled { .. }
            | Fault::OverConstrained { .. }
            | Fault::Mobility { .. } => true,
            Fault::Open { .. } => ordering.is_some_and(|o| !o.set_aside.is_empty()),
            Fault::Vague { .. }
            | Fault::ChangePoint { .. }
            | Fault::BeyondStop { .. }
            | Fault::HeldByStops { .. }
            | Fault::NoChoice { .. } => false,
        }
    }
}

/// Opens a mechanism that did not open with what the structure set aside: with what the rank does, or
/// says what the rank says.
pub(super) fn reopened(
    network: &Network<'_>,
    fault: Fault,
    at: f64,
    near: &[(PointId, Vec2)],
    open_at: impl Fn(&Ordering, f64, &[(PointId, Vec2)]) -> Result<Solver, Fault>,
) -> Result<Solver, Fault> {
    let structure = order::ordering(network, &[]).ok();
    if !fault.asks_for_the_rank(structure.as_ref()) {
        return Err(fault);
    }
    let open = |ordering: &Ordering, near: &[(PointId, Vec2)]| open_at(ordering, at, near);
    if let (Fault::Singular { elements, .. }, Some(ordering)) = (&fault, &structure)
        && ordering.set_aside.is_empty()
        && verdict::beside(network, at).any(|at| open_at(ordering, at, near).is_ok())
    {
        return Err(Fault::Singular {
            elements: elements.clone(),
            is_here_only: true,
        });
    }
    if verdict::is_too_large(network) {
        return by_trial(network, structure, |ordering| open(ordering, near)).ok_or(fault);
    }
    let Some(whole) = Whole::new(network, at, near) else {
        return Err(fault);
    };
    let Some(verdict) = whole.verdict() else {
        return Err(fault);
    };
    if verdict.free > 0 {
        return Err(verdict.free_motions(network));
    }
    let mut tried: Vec<Vec<ScalarEquation>> = Vec::new();
    let mut ways: VecDeque<Vec<ScalarEquation>> = verdict.set_aside.iter().cloned().collect();
    let mut fault = fault;
    while let Some(set_aside) = ways.pop_front() {
        if tried.contains(&set_aside) {
            continue;
        }
        let ordering = order::ordering(network, &set_aside);
        tried.push(set_aside);
        let Ok(ordering) = ordering else { continue };
        match opened(&ordering, at, near, &verdict, open) {
            Ok(solver) => return Ok(solver),
            Err(again) => fault = better(fault, again),
        }
        if tried.len() == MOST_TRIED {
            break;
        }
        // Those that are kept may be singular where all together are not: then others lead on.
        if let Fault::OverConstrained { at, .. } = fault
            && ways.is_empty()
            && !verdict.is_held
        {
            ways.extend(whole.set_aside_at(at).unwrap_or_default());
        }
    }
    Err(verdict.named(fault))
}

/// Above the size of a decomposition: sets others aside in the place of the first one, one after another.
fn by_trial(
    network: &Network<'_>,
    structure: Option<Ordering>,
    open: impl Fn(&Ordering) -> Result<Solver, Fault>,
) -> Option<Solver> {
    let structure = structure?;
    let could = structure.over.iter().rev();
    let rivals =
        could.filter(|&&row| network.readiness(row) > 0 && !structure.set_aside.contains(&row));
    let mut rivals = rivals.take(MOST_RIVALS);
    rivals.find_map(|&row| open(&order::ordering(network, &[row]).ok()?).ok())
}

/// Rough places choose where they can; where the assembly that they choose does not fit what was set
/// aside, the one does in which everything fits.
fn opened(
    ordering: &Ordering,
    start: f64,
    near: &[(PointId, Vec2)],
    verdict: &RankVerdict,
    open: impl Fn(&Ordering, &[(PointId, Vec2)]) -> Result<Solver, Fault>,
) -> Result<Solver, Fault> {
    match open(ordering, near) {
        Err(Fault::OverConstrained { at, .. }) if at == start => open(ordering, &verdict.places),
        Err(Fault::NotAssembled { .. } | Fault::Open { .. }) => open(ordering, &verdict.places),
        other => other,
    }
}

/// Of two faults of one mechanism the one that says more.
fn better(first: Fault, again: Fault) -> Fault {
    match again {
        Fault::OverConstrained { .. } | Fault::Vague { .. } | Fault::ChangePoint { .. } => again,
        _ => first,
    }
}

/// What the rank says of a mechanism that opened; a fault where it only seemed to be determined.
///
/// The dyads of a plan are regular where they are placed, and need no second look.
pub(super) fn judged(network: &Network<'_>, mut solver: Solver) -> Result<Solver, Fault> {
    let groups = verdict::groups(network, &solver);
    // What is kept may hold the driver where it opens: with others set aside it may move.
    let set_aside = &solver.ordering.set_aside;
    let (low, high) = solver.motion.range.ends();
    let is_stuck = low == high && !set_aside.is_empty();
    let stuck = is_stuck.then(|| order::elements(set_aside));
    if let Some(elements) = groups.singular.or(stuck) {
        return Err(Fault::Singular {
            elements,
            is_here_only: false,
        });
    }
    solver.rank = Rank {
        redundancies: redundancy::redundancies(network, &solver),
        is_unclear: groups.is_unclear,
        is_lower_at_start: groups.is_lower_at_start,
    };
    Ok(solver)
}

impl RankVerdict {
    /// That the driver does not determine every link.
    fn free_motions(self, network: &Network<'_>) -> Fault {
        Fault::Mobility {
            mobility: self.mobility(),
            redundant: self.redundant + network.repeated_locks.len(),
            repeating: self.repeating,
            floating: self.floating,
            is_unclear: self.is_unclear,
        }
    }

    /// A fault with the names that the rank knows.
    fn named(&self, fault: Fault) -> Fault {
        match fault {
            Fault::OverConstrained {
                element,
                misfit,
                at,
                ..
            } => {
                let others = self.repeating.iter().copied();
                Fault::OverConstrained {
                    element,
                    others: others.filter(|&other| other != element).collect(),
                    misfit,
                    at,
                }
            }
            Fault::Singular { .. } if self.is_held => Fault::Mobility {
                mobility: self.mobility(),
                redundant: self.redundant,
                repeating: self.repeating.clone(),
                floating: Vec::new(),
                is_unclear: self.is_unclear,
            },
            Fault::Singular { elements, .. } => Fault::Singular {
                elements,
                is_here_only: self.is_change_point,
            },
            other => other,
        }
    }
}
