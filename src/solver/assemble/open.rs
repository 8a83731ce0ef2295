//! Which groups a start leaves open, all at once: who is asked about one after the other answers as often.

use super::{Assembler, Halt};
use crate::solver::engine::Engine;
use crate::solver::fault::{Fault, OpenChoice};
use crate::solver::state::Condition;
use crate::solver::workspace::Workspace;

impl Assembler<'_> {
    /// The fault of a group that the start leaves open, with those behind it that are open, too. Where these can be
    /// follows from how it stands: as its first choice, or its second where with the first nothing goes on.
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
        let mut best = (first.choices.clone(), Vec::new());
        for turned in 0..first.choices.len().min(2) {
            let mut choices = first.choices.clone();
            choices.rotate_left(turned);
            let mut behind = Vec::new();
            let taken = OpenChoice {
                point,
                choices: choices.clone(),
            };
            let ends = self.open_behind(number, taken, &mut engine.clone(), state, &mut behind);
            if turned == 0 || ends && best.1.len() < behind.len() {
                best = (choices, behind);
            }
            if ends {
                break;
            }
        }
        let (choices, behind) = best;
        Halt::Fault(Fault::Vague {
            point,
            choices,
            behind,
        })
    }

    /// Goes on with the first choice of each group; whether it comes to the last one.
    fn open_behind(
        &self,
        number: usize,
        mut open: OpenChoice,
        engine: &mut Engine,
        state: &mut Workspace,
        found: &mut Vec<OpenChoice>,
    ) -> bool {
        if !self.take_first(number, &open, engine, state) {
            return false;
        }
        for number in number + 1..self.plan.groups.len() {
            match self.settle(number, engine, state) {
                Ok(()) => {}
                Err(Halt::Fault(Fault::Vague { point, choices, .. })) => {
                    open = OpenChoice { point, choices };
                    let goes_on = self.take_first(number, &open, engine, state);
                    found.push(open);
                    if !goes_on {
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
