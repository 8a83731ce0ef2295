//! Which groups a start leaves open, all at once: who is asked about one after the other answers as often.

use super::{Assembler, Halt};
use crate::solver::engine::Engine;
use crate::solver::fault::{Fault, OpenChoice};
use crate::solver::state::Condition;
use crate::solver::workspace::Workspace;

/// So many ways to stand are tried: all of four open groups.
const MOST_TRIED: u32 = 16;

impl Assembler<'_> {
    /// The fault of a group that the start leaves open, with those behind it that are open, too. Where these can be
    /// follows from how it stands: each as its first choice, or some as their second where with the first nothing
    /// goes on.
    pub(super) fn all_open(
        &self,
        number: usize,
        halt: Halt,
        engine: &Engine,
        state: &mut Workspace,
    ) -> Halt {
        let Halt::Fault(Fault::Vague { point, choices, .. }) = halt else {
            return halt;
        };
        let first = OpenChoice { point, choices };
        let mut best = None;
        for tried in 0..MOST_TRIED {
            let mut found = Vec::new();
            let open = first.clone();
            let ends =
                self.open_behind(number, open, tried, &mut engine.clone(), state, &mut found);
            let groups = u32::try_from(found.len()).unwrap_or(u32::MAX);
            if best.is_none() || ends {
                best = Some(found);
            }
            // Every way was tried as soon as there are no more digits than groups.
            if ends || (tried + 1).checked_shr(groups).unwrap_or(0) != 0 {
                break;
            }
        }
        let mut found = best.unwrap_or_default().into_iter();
        let OpenChoice { point, choices } = found.next().unwrap_or(first);
        Halt::Fault(Fault::Vague {
            point,
            choices,
            behind: found.collect(),
        })
    }

    /// Goes on with the first choice of each group, or the second one of those whose binary digit in `turned` is 1, the
    /// first group's the lowest; whether it comes to the last group. Those that are open are found with the choice
    /// that was taken in front.
    fn open_behind(
        &self,
        first: usize,
        open: OpenChoice,
        mut turned: u32,
        engine: &mut Engine,
        state: &mut Workspace,
        found: &mut Vec<OpenChoice>,
    ) -> bool {
        let mut goes_on = |number: usize, mut open: OpenChoice, engine: &mut _, state: &mut _| {
            if turned % 2 == 1 && open.choices.len() > 1 {
                open.choices.rotate_left(1);
            }
            turned /= 2;
            let goes_on = self.take_first(number, &open, engine, state);
            found.push(open);
            goes_on
        };
        if !goes_on(first, open, engine, state) {
            return false;
        }
        for number in first + 1..self.plan.groups.len() {
            match self.settle(number, engine, state) {
                Ok(()) => {}
                Err(Halt::Fault(Fault::Vague { point, choices, .. })) => {
                    let open = OpenChoice { point, choices };
                    if !goes_on(number, open, engine, state) {
                        return false;
                    }
                }
                // What else is wrong is said when it is known where this stands.
                Err(_) => return false,
            }
        }
        true
    }

    /// Places a group as its first choice says; whether it can be.
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
