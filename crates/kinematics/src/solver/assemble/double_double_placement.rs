//! Places groups that doubles cannot place, in double-double with typed decimals: a triangle as
//! thin as a needle, or one open by less than a rounding error.

use super::{Assembler, TIE, miss, side_of, steps_of};
use crate::Double;
use crate::solver::elements::StepOutcome;
use crate::solver::engine::Engine;
use crate::solver::exact::Exact;
use crate::solver::plan::AssemblyChoice;
use crate::solver::state::{Condition, State};
use crate::solver::workspace::Workspace;

impl Assembler<'_> {
    /// Places the first steps and rounds the results; `None` if double-double does not improve on
    /// doubles.
    pub(super) fn place_closely(
        &self,
        steps: usize,
        workspace: &mut Workspace,
    ) -> Option<Condition> {
        let exact = self.exact.filter(|exact| exact.decides_more(steps))?;
        let mut close: State<Double> = exact.state(workspace.travels.len());
        let condition = self.run_closely(exact, steps, workspace, &mut close);
        exact.write(steps, &close, &mut workspace.state);
        Some(condition)
    }

    /// Returns the outcome of the dyad of a step, given its outcome in doubles.
    pub(super) fn closing_closely(
        &self,
        key: usize,
        in_doubles: StepOutcome,
        workspace: &mut Workspace,
    ) -> StepOutcome {
        if in_doubles == StepOutcome::Done {
            return in_doubles;
        }
        match self.place_closely(key + 1, workspace) {
            None => in_doubles,
            Some(Condition::Ok) => StepOutcome::Done,
            Some(Condition::DeadPoint | Condition::ChangePoint) => StepOutcome::Stretched,
            Some(Condition::NoAssembly) => StepOutcome::Open,
        }
    }

    /// Returns the side of a dyad nearer to the approximate positions, if double-double can
    /// distinguish the two.
    pub(super) fn hinted(
        &self,
        number: usize,
        key: usize,
        engine: &Engine,
        workspace: &Workspace,
    ) -> Option<AssemblyChoice> {
        // Up to its last step: an approximate position may be that of a point on the dyad's link.
        let end = steps_of(engine, number).end;
        let exact = self.exact.filter(|exact| end <= exact.closed)?;
        let wanted = self.wanted(number, engine);
        let mut workspace = workspace.clone();
        let mut miss_of = |sign: f64| {
            workspace.state.signs[number] = sign;
            let mut close: State<Double> = exact.state(workspace.travels.len());
            let found = self.run_closely(exact, end, &workspace, &mut close);
            exact.write(end, &close, &mut workspace.state);
            (found == Condition::Ok).then(|| miss(&wanted, &workspace))
        };
        let plus = side_of(self.network.mechanism, engine, key, AssemblyChoice::Plus)?;
        let (plus, minus) = (miss_of(plus)?, miss_of(-plus)?);
        let differ = (plus - minus).abs() > TIE * (plus + minus);
        let nearer = if plus < minus {
            AssemblyChoice::Plus
        } else {
            AssemblyChoice::Minus
        };
        differ.then_some(nearer)
    }

    /// Returns the gap by which the dyad of a step fails to close.
    pub(super) fn gap_closely(&self, key: usize, state: &State) -> Option<f64> {
        let exact = self.exact.filter(|exact| exact.decides_more(key))?;
        let mut close: State<Double> = exact.state(state.travels.len());
        let _ = self.run_closely(exact, key, state, &mut close);
        let (q, _) = exact.engine.coordinate(Double::exactly(self.request.at));
        let dyad = exact.engine.program.steps[key].dyad()?;
        Some((-dyad.reserve(q, &close)).hi.max(0.0))
    }

    fn run_closely(
        &self,
        exact: &Exact,
        steps: usize,
        state: &State,
        close: &mut State<Double>,
    ) -> Condition {
        let how = (&state.signs[..], None);
        exact.run(
            steps,
            Double::exactly(self.request.at),
            self.order,
            how,
            close,
        )
    }
}
