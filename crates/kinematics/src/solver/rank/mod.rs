#![doc = include_str!("../../guide/rank.md")]

mod assemble;
mod exchange;
mod redundancy;
mod rows;
mod spectrum;
mod verdict;

use super::Solver;
use super::fault::Fault;
use super::plan::network::{Network, ScalarEquation};
use super::plan::order::{self, Ordering};
use crate::{ElementId, PointId, Vec2};
use std::collections::VecDeque;
use verdict::{AllConstraints, RankVerdict};

/// Maximum number of unknowns for a dense decomposition: the cost grows with their cube, and this
/// many take about a second. Larger mechanisms keep the result of the structural analysis.
const MAX_UNKNOWNS: usize = 420;

/// Maximum number of tried choices of set-aside constraints: by the rank, and one after another.
const MAX_TRIED: usize = 6;
const MAX_RIVALS: usize = 64;

/// An element with constraints that repeat others.
#[derive(Clone, Debug, PartialEq)]
pub struct Redundancy {
    /// The element whose constraints were set aside.
    pub element: ElementId,
    /// The number of constraints of this element that were set aside.
    pub constraints: usize,
    /// The other elements that take part: any of them could have been set aside instead. Empty if
    /// the mechanism is too large for a decomposition.
    pub repeats: Vec<ElementId>,
    /// The maximum disagreement of the constraints over the motion, in the scene's length unit. For
    /// slides that fix one link's angle, it is measured at the end of the longest length.
    pub misfit: f64,
}

/// The result of the rank analysis of a mechanism that moves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rank {
    /// The redundant constraints.
    pub redundancies: Vec<Redundancy>,
    /// Whether a singular value at the start is so close to zero that rounding, or the accepted
    /// disagreement, could hide a motion that the driver does not determine.
    pub is_unclear: bool,
    /// Whether more can move at the start position than elsewhere: a change point or a dead point.
    pub is_lower_at_start: bool,
}

impl Fault {
    /// Returns `true` if the fault may come from redundant constraints that the structural analysis
    /// missed, or set aside wrongly.
    fn needs_rank_analysis(&self, ordering: Option<&Ordering>) -> bool {
        match self {
            Fault::Singular { .. }
            | Fault::NotAssembled { .. }
            | Fault::OverConstrained { .. }
            | Fault::Mobility { .. } => true,
            // A group with constraints set aside wrongly is singular everywhere.
            Fault::Open { .. } | Fault::ChangePoint { .. } => {
                ordering.is_some_and(|o| !o.set_aside.is_empty())
            }
            Fault::Vague { .. }
            | Fault::BeyondStop { .. }
            | Fault::FastInput { .. }
            | Fault::HeldByStops { .. }
            | Fault::NoChoice { .. } => false,
        }
    }
}

/// Opens a mechanism that failed to open with the constraints set aside by the structural analysis:
/// sets aside those chosen by the rank instead.
///
/// # Errors
/// The fault, or a more specific one found by the rank.
pub(super) fn reopened(
    network: &Network<'_>,
    fault: Fault,
    at: f64,
    near: &[(PointId, Vec2)],
    open_at: impl Fn(&Ordering, f64, &[(PointId, Vec2)]) -> Result<Solver, Fault>,
) -> Result<Solver, Fault> {
    let structure = order::ordering(network, &[]).ok();
    if !fault.needs_rank_analysis(structure.as_ref()) {
        return Err(fault);
    }
    let open = |ordering: &Ordering, near: &[(PointId, Vec2)]| open_at(ordering, at, near);
    if let (Fault::Singular { elements, .. }, Some(ordering)) = (&fault, &structure)
        && ordering.set_aside.is_empty()
        && verdict::nearby_coordinates(network, at).any(|at| open_at(ordering, at, near).is_ok())
    {
        return Err(Fault::Singular {
            elements: elements.clone(),
            is_here_only: true,
        });
    }
    if verdict::is_too_large(network) {
        return try_set_aside(network, structure, |ordering| open(ordering, near)).ok_or(fault);
    }
    let Some(complete) = AllConstraints::new(network, at, near) else {
        return Err(fault);
    };
    let Some(verdict) = complete.verdict() else {
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
        if tried.len() == MAX_TRIED {
            break;
        }
        // The kept constraints may be singular where all together are not. Then the rank at that
        // position chooses others.
        if let Fault::OverConstrained { at, .. } = fault
            && ways.is_empty()
            && !verdict.is_held
        {
            ways.extend(complete.set_aside_at(at).unwrap_or_default());
        }
    }
    Err(verdict.named(fault))
}

/// Tries sets of set-aside constraints one after another, for mechanisms too large for a
/// decomposition. Each set replaces the structure's first choice.
fn try_set_aside(
    network: &Network<'_>,
    structure: Option<Ordering>,
    open: impl Fn(&Ordering) -> Result<Solver, Fault>,
) -> Option<Solver> {
    let structure = structure?;
    let could = structure.over.iter().rev();
    let rivals =
        could.filter(|&&row| network.readiness(row) > 0 && !structure.set_aside.contains(&row));
    let mut rivals = rivals.take(MAX_RIVALS);
    rivals.find_map(|&row| open(&order::ordering(network, &[row]).ok()?).ok())
}

/// Opens a mechanism from approximate positions. If the assembly that they select does not fit the
/// set-aside constraints, uses the pose in which all constraints hold.
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

/// Returns the more informative of two faults of one mechanism.
fn better(first: Fault, again: Fault) -> Fault {
    match again {
        Fault::OverConstrained { .. } | Fault::Vague { .. } | Fault::ChangePoint { .. } => again,
        _ => first,
    }
}

/// Adds the rank analysis to a mechanism that opened. Returns a fault if it only seemed to be
/// determined.
///
/// The dyads of a plan are regular where they are placed, and are not checked again.
pub(super) fn with_rank(network: &Network<'_>, mut solver: Solver) -> Result<Solver, Fault> {
    let groups = verdict::groups(network, &solver);
    let (low, high) = solver.motion.range.ends();
    let is_stuck = low == high;
    // The kept constraints may lock the driver at the start position; with others set aside, it may move.
    // Otherwise the driver may not determine a coupled group, whose matrix is singular in all of its
    // positions, except for rounding.
    let held = match solver.ordering.set_aside.as_slice() {
        [] => groups.almost_singular,
        set_aside => Some(order::elements(set_aside)),
    };
    if let Some(elements) = groups.singular.or(held.filter(|_| is_stuck)) {
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
    /// Returns the fault that the driver does not determine every link.
    fn free_motions(self, network: &Network<'_>) -> Fault {
        Fault::Mobility {
            mobility: self.mobility(),
            redundant: self.redundant + network.repeated_locks.len(),
            repeating: self.repeating,
            floating: self.floating,
            is_unclear: self.is_unclear,
        }
    }

    /// Adds the elements known from the rank to a fault.
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
