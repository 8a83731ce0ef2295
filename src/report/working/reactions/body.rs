//! A link of a group with its forces, known and unknown.

use super::super::context::{Context, Draft};
use super::super::expression::Expression;
use super::super::free_bodies::free_body::BodyForce;
use crate::page::{Formula, Symbol};
use crate::wording::words;
use crate::{LinkId, Vec2};

/// A link, and all forces on it.
pub(super) struct GroupBody {
    pub(super) link: LinkId,
    /// The known forces: loads, weight, inertia, and reactions from later groups.
    pub(super) given: Vec<BodyForce>,
    /// The unknown reactions of joints in this group, and of joints to earlier groups.
    pub(super) sought: Vec<BodyForce>,
}

/// A sum of known terms, and the sum of their magnitudes.
#[derive(Clone, Copy, Debug)]
pub(super) struct KnownSum {
    pub(super) value: f64,
    pub(super) size: f64,
}

/// The kind of sum over the forces on a link.
#[derive(Clone, Copy, Debug)]
pub(crate) enum BalanceKind {
    /// Moments about a point, in N m.
    About(Vec2),
    /// Forces along a unit vector, in N.
    Along(Vec2),
}

impl BalanceKind {
    /// Returns the contribution of a force.
    pub(crate) fn of(self, context: &Context<'_>, row: &BodyForce) -> f64 {
        match self {
            BalanceKind::About(position) => {
                let metres = context.scene.mechanism.metres();
                let arm = row.at.map_or(Vec2::ZERO, |at| (at - position) * metres);
                arm.cross(row.force) + row.couple
            }
            BalanceKind::Along(unit) => unit.dot(row.force),
        }
    }

    /// Returns the maximum possible contribution of a force there.
    pub(super) fn max_contribution(self, context: &Context<'_>, row: &BodyForce) -> f64 {
        match self {
            BalanceKind::About(position) => {
                let metres = context.scene.mechanism.metres();
                let arm = row.at.map_or(0.0, |at| (at - position).norm() * metres);
                arm * row.force.norm() + row.couple.abs()
            }
            BalanceKind::Along(_) => row.force.norm(),
        }
    }

    pub(super) fn unit(self) -> &'static str {
        match self {
            BalanceKind::About(_) => "N m",
            BalanceKind::Along(_) => "N",
        }
    }
}

/// Returns the sum of the known forces.
pub(super) fn known<'a>(
    context: &Context<'_>,
    given: impl IntoIterator<Item = &'a BodyForce>,
    reckoning: BalanceKind,
) -> KnownSum {
    let nothing = KnownSum {
        value: 0.0,
        size: 0.0,
    };
    given.into_iter().fold(nothing, |sum, row| KnownSum {
        value: sum.value + reckoning.of(context, row),
        size: sum.size + reckoning.max_contribution(context, row),
    })
}

/// Writes the sum of the known forces: a table of them, and `symbol = 12.5 - 3.2 = 9.3 N m`.
/// Returns it.
pub(super) fn write_known(
    context: &Context<'_>,
    draft: &mut Draft,
    (link, given): (LinkId, &[&BodyForce]),
    (symbol, reckoning): (&Symbol, BalanceKind),
    about: &str,
) -> KnownSum {
    let f = context.figures;
    let sum = known(context, given.iter().copied(), reckoning);
    if !given.is_empty() {
        let title = words().known_on(context.scene.link_name(link));
        let contributions = (reckoning, sum.size, about);
        table(context, draft, title, given.iter().copied(), contributions);
    }
    let terms = given.iter().map(|row| reckoning.of(context, row));
    let terms = f.sum(terms, sum.size);
    let value = f.format_or_zero(sum.value, sum.size);
    let mut sides = vec![symbol.clone().into()];
    // A single term equals its value.
    if let Expression::Sum(_) = terms {
        sides.push(terms.numbers());
    }
    sides.push(Formula::measured(value, reckoning.unit()));
    draft.equation(sides);
    sum
}

/// Writes a table of forces, with their contributions to a sum, whose terms have this magnitude.
pub(crate) fn table<'a>(
    context: &Context<'_>,
    draft: &mut Draft,
    title: String,
    forces: impl Iterator<Item = &'a BodyForce> + Clone,
    (reckoning, size, about): (BalanceKind, f64, &str),
) {
    let f = context.figures;
    let largest = forces.clone().map(|row| row.force.norm());
    let largest = largest.fold(0.0, f64::max);
    let place = match reckoning {
        BalanceKind::About(place) => Some(place),
        BalanceKind::Along(_) => None,
    };
    let row = |row: &BodyForce| {
        let mut cells = vec![
            row.name.clone(),
            f.format_or_zero(row.force.x, largest),
            f.format_or_zero(row.force.y, largest),
        ];
        if let Some(place) = place {
            let arm = row.at.map(|at| at - place);
            let along = |pick: fn(Vec2) -> f64| {
                arm.map_or("-".into(), |arm| f.format_or_zero(pick(arm), arm.norm()))
            };
            cells.extend([along(|arm| arm.x), along(|arm| arm.y)]);
        }
        cells.push(f.format_or_zero(reckoning.of(context, row), size));
        cells
    };
    let mut head = vec![title, "fx [N]".into(), "fy [N]".into()];
    if place.is_some() {
        head.extend(["x", "y"].map(|axis| format!("{axis} [{}]", f.unit)));
    }
    head.push(about.to_owned());
    draft.wide_table(head, forces.map(row).collect());
}
