//! Finds all groups for which a start does not choose the assembly, so that one message can list
//! them all.

use super::{Assembler, AssemblyFailure};
use crate::solver::engine::Engine;
use crate::solver::fault::{Fault, OpenChoice};
use crate::solver::state::Condition;
use crate::solver::workspace::Workspace;

/// Maximum number of combinations tried: all of four undecided groups.
const MAX_TRIED: u32 = 16;

impl Assembler<'_> {
    /// Returns the fault of an undecided group, with the later undecided groups. The possible
    /// positions of these depend on the choice for the first. Each group takes its first choice, or
    /// some take their second if the first leads no further.
    pub(super) fn all_open(
        &self,
        number: usize,
        halt: AssemblyFailure,
        engine: &Engine,
        state: &mut Workspace,
    ) -> AssemblyFailure {
        let AssemblyFailure::Fault(Fault::Vague { point, choices, .. }) = halt else {
            return halt;
        };
        let first = OpenChoice { point, choices };
        let mut best = None;
        for tried in 0..MAX_TRIED {
            let mut found = Vec::new();
            let open = first.clone();
            let ends =
                self.open_behind(number, open, tried, &mut engine.clone(), state, &mut found);
            let groups = u32::try_from(found.len()).unwrap_or(u32::MAX);
            if best.is_none() || ends {
                best = Some(found);
            }
            // All combinations have been tried once there are no more binary digits than groups.
            if ends || (tried + 1).checked_shr(groups).unwrap_or(0) != 0 {
                break;
            }
        }
        let mut found = best.unwrap_or_default().into_iter();
        let OpenChoice { point, choices } = found.next().unwrap_or(first);
        AssemblyFailure::Fault(Fault::Vague {
            point,
            choices,
            behind: found.collect(),
        })
    }

    /// Continues with the first choice of each group, or with the second if its binary digit in
    /// `turned` is 1; the lowest digit belongs to the first group. Returns `true` if it reaches the
    /// last group. In `found` the undecided groups have the taken choice first.
    fn open_behind(
        &self,
        first: usize,
        open: OpenChoice,
        mut turned: u32,
        engine: &mut Engine,
        state: &mut Workspace,
        found: &mut Vec<OpenChoice>,
    ) -> bool {
        let mut continues = |number: usize, mut open: OpenChoice, engine: &mut _, state: &mut _| {
            if turned % 2 == 1 && open.choices.len() > 1 {
                open.choices.rotate_left(1);
            }
            turned /= 2;
            let continues = self.take_first(number, &open, engine, state);
            found.push(open);
            continues
        };
        if !continues(first, open, engine, state) {
            return false;
        }
        for number in first + 1..self.plan.groups.len() {
            match self.place_group(number, engine, state) {
                Ok(()) => {}
                Err(AssemblyFailure::Fault(Fault::Vague { point, choices, .. })) => {
                    let open = OpenChoice { point, choices };
                    if !continues(number, open, engine, state) {
                        return false;
                    }
                }
                // Other faults are reported once this choice has been made.
                Err(_) => return false,
            }
        }
        true
    }

    /// Places a group according to its first choice. Returns `true` if it can be placed.
    fn take_first(
        &self,
        number: usize,
        open: &OpenChoice,
        engine: &mut Engine,
        state: &mut Workspace,
    ) -> bool {
        let Some(&wanted) = open.choices.first() else {
            return false;
        };
        let ways = self.ways(number, engine, state);
        let mut away = |way| {
            let _ = self.take(number, way, engine, state);
            (state.place(open.point) - wanted).norm()
        };
        let distances: Vec<f64> = ways.iter().map(&mut away).collect();
        let near = distances.iter().zip(&ways);
        let near = near.min_by(|a, b| a.0.total_cmp(b.0));
        let Some((_, way)) = near else { return false };
        self.take(number, way, engine, state) != Condition::NoAssembly
    }
}
