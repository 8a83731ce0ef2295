//! Selects the set-aside constraints that leave the smallest groups.
//!
//! A set-aside constraint may be exchanged for any constraint in the sum that it repeats. Only the
//! structure shows which choice suits the steps of a plan: dyads are solved in closed form, and the
//! work of a coupled group grows with its cube.

use super::rows::Rows;
use super::spectrum::IndependentRows;
use crate::solver::plan::order;
use nalgebra::DMatrix;
use std::cmp::Reverse;

/// Minimum coefficient in the sum, relative to the largest, for an exchange: the kept constraints
/// must stay about as well conditioned as before.
const STEADY: f64 = 0.05;
/// A smaller limit, tried too. In a lift of 50 stages, a bar at the top carries a hundredth of the
/// load of one at the bottom, and with it set aside all groups are dyads.
const SMALLER_LIMIT: f64 = 0.005;
/// Maximum number of successive exchanges.
const MAX_ROUNDS: usize = 6;
/// Maximum work per round: the number of exchanges tried times the number of constraints.
const MAX_WORK: usize = 600_000;

/// Exchanges set-aside constraints as long as the remaining groups become smaller. If the smaller
/// limit leaves less work, its result comes first; the result of the larger limit always comes
/// last.
pub(super) fn smaller(
    rows: &Rows<'_>,
    matrix: &DMatrix<f64>,
    choice: &IndependentRows,
) -> Vec<IndependentRows> {
    let (steady, left) = exchanged_by(rows, matrix, choice, STEADY);
    let (other, less) = exchanged_by(rows, matrix, choice, SMALLER_LIMIT);
    let is_less = less.is_some_and(|less| left.is_none_or(|left| less < left));
    if is_less {
        vec![other, steady]
    } else {
        vec![steady]
    }
}

/// Exchanges with this minimum coefficient; returns the choice and the remaining work.
fn exchanged_by(
    rows: &Rows<'_>,
    matrix: &DMatrix<f64>,
    choice: &IndependentRows,
    steady: f64,
) -> (IndependentRows, Option<usize>) {
    let mut choice = choice.clone();
    let mut minimum = work(rows, &choice.set_aside);
    for _ in 0..MAX_ROUNDS {
        let Some((found, exchange)) = best(rows, &choice, steady) else {
            break;
        };
        if minimum.is_some_and(|minimum| found >= minimum) {
            break;
        }
        minimum = Some(found);
        let (kept, set_aside) = exchanged(&choice, exchange);
        choice = IndependentRows::new(matrix, kept, set_aside);
    }
    (choice, minimum)
}

/// Returns the exchange that leaves the least work; of equal ones, the exchange for the constraint
/// more readily set aside.
fn best(rows: &Rows<'_>, choice: &IndependentRows, steady: f64) -> Option<(usize, (usize, usize))> {
    let readiness = |row: usize| rows.network.readiness(rows.rows[row]);
    let mut exchanges = Vec::new();
    for index in 0..choice.set_aside.len() {
        let repeated = choice.repeated_by(index, steady * choice.largest_of(index));
        let ready = repeated.into_iter().filter(|&row| readiness(row) > 0);
        exchanges.extend(ready.map(|row| (index, row)));
    }
    let maximum = (MAX_WORK / rows.rows.len().max(1)).max(1);
    let step = exchanges.len().div_ceil(maximum).max(1);
    let tried = exchanges.into_iter().step_by(step).filter_map(|exchange| {
        let (_, set_aside) = exchanged(choice, exchange);
        Some((work(rows, &set_aside)?, exchange))
    });
    tried.min_by_key(|&(work, (_, row))| (work, Reverse((readiness(row), row))))
}

/// Returns the kept and the set-aside constraints after one of the latter is exchanged for one of
/// the former.
fn exchanged(choice: &IndependentRows, (index, row): (usize, usize)) -> (Vec<usize>, Vec<usize>) {
    let mut set_aside = choice.set_aside.clone();
    let back = std::mem::replace(&mut set_aside[index], row);
    let mut kept = choice.kept.clone();
    for kept in kept.iter_mut().filter(|kept| **kept == row) {
        *kept = back;
    }
    set_aside.sort_unstable();
    kept.sort_unstable();
    (kept, set_aside)
}

/// Returns the sum of the cubes of all group sizes; `None` if the kept constraints do not determine
/// everything.
fn work(rows: &Rows<'_>, set_aside: &[usize]) -> Option<usize> {
    let set_aside: Vec<_> = set_aside.iter().map(|&i| rows.rows[i]).collect();
    let ordering = order::ordering(rows.network, &set_aside).ok()?;
    Some(ordering.blocks.iter().map(|b| b.rows.len().pow(3)).sum())
}
