//! The numeric equations of a group, with the symbols of its unknowns.

use super::super::context::Context;
use super::super::loops::group_unknowns::{LoopUnknown, Stage};
use super::super::loops::sides::{Side, SideShape, Turns};
use crate::angle;
use crate::page::Symbol;
use crate::solver::Order;
use crate::study::{LoopSum, LoopSystem, UnknownKind, UnknownVector, VectorPart};

/// The equations of a group's loops.
pub(super) struct LoopProblem {
    pub(super) system: LoopSystem,
    /// The symbols of the unknowns.
    pub(super) names: Vec<Symbol>,
    /// The solver's values, if there is an assembly.
    pub(super) right: Option<Vec<f64>>,
}

impl LoopProblem {
    /// Creates the equations of a group; returns `None` if they depend on values that are not
    /// known.
    pub(super) fn of(context: &Context<'_>, stage: &Stage) -> Option<LoopProblem> {
        let kinds = stage.unknowns.iter().map(|unknown| kind(*unknown));
        let system = LoopSystem {
            loops: stage
                .loops
                .iter()
                .map(|&number| sum(context, stage, number))
                .collect::<Option<_>>()?,
            kinds: kinds.collect(),
            longest: context.longest,
        };
        let names = stage
            .unknowns
            .iter()
            .map(|&u| context.symbol(u, Order::Position));
        let right = stage.unknowns.iter().map(|&u| right(context, u));
        Some(LoopProblem {
            system,
            names: names.collect(),
            right: right
                .collect::<Option<_>>()
                .filter(|_| context.has_positions()),
        })
    }
}

pub(crate) fn kind(unknown: LoopUnknown) -> UnknownKind {
    match unknown {
        LoopUnknown::Angle(_) | LoopUnknown::Direction(_) => UnknownKind::Angle,
        LoopUnknown::Travel(_) | LoopUnknown::Length(_) => UnknownKind::Length,
    }
}

/// Returns the solver's value: in rad, or in the scene's unit. Returns `None` for a vector between
/// two bodies.
fn right(context: &Context<'_>, unknown: LoopUnknown) -> Option<f64> {
    match unknown {
        LoopUnknown::Angle(link) => Some(angle::radians(context.state.angle(link))),
        LoopUnknown::Travel(slide) => {
            let is_it = |side: &Side| side.shape == SideShape::Slide(slide);
            let index = context.polygon.sides.iter().position(is_it)?;
            context.readings.get(index).map(|reading| reading.r)
        }
        LoopUnknown::Length(_) | LoopUnknown::Direction(_) => None,
    }
}

fn sum(context: &Context<'_>, stage: &Stage, number: usize) -> Option<LoopSum> {
    let place = |unknown| stage.unknowns.iter().position(|&u| u == unknown);
    let mut sum = LoopSum::default();
    for member in context.members(&context.polygon.loops[number], stage) {
        let sign = if member.reversed { -1.0 } else { 1.0 };
        let length = match (member.sought[0], member.side.shape) {
            (false, _) => VectorPart::Known(member.reading.r),
            (true, SideShape::Slide(slide)) => {
                VectorPart::Sought(place(LoopUnknown::Travel(slide))?, 0.0)
            }
            (true, _) => return None,
        };
        let angle = match (member.sought[1], member.side.turns) {
            (false, _) => VectorPart::Known(angle::radians(member.reading.theta)),
            (true, Turns::With(link, offset)) => {
                VectorPart::Sought(place(LoopUnknown::Angle(link))?, angle::radians(offset))
            }
            (true, _) => return None,
        };
        if member.sought == [false, false] {
            sum.known += member.vector();
        } else {
            sum.sought.push(UnknownVector {
                sign,
                length,
                angle,
            });
        }
    }
    Some(sum)
}
