//! Treats the unknowns of all groups as a system of differential equations, whose integration
//! drifts.

use super::{Deviation, Methods, run};
use crate::solver::Workspace;
use crate::solver::elements::{ACCELERATION, VELOCITY};

/// The unknowns integrated by their rates alone; nothing keeps the loops closed.
pub struct DriftMethod {
    state: Workspace,
    /// The unknowns z of all groups at the beginning of a step.
    base: Vec<f64>,
    /// The index where each group begins in the base and among the unknowns.
    starts: Vec<[usize; 2]>,
    unknowns: usize,
}

impl Methods {
    /// Creates a system at the state looked up last.
    pub fn drift(&self) -> Option<DriftMethod> {
        let engine = &self.rows.as_ref()?.engine;
        let mut state = engine.state::<f64>(self.slides);
        let (mut starts, mut base, mut unknowns) = (Vec::new(), Vec::new(), 0);
        for group in &engine.program.coupled {
            starts.push([base.len(), unknowns]);
            group.read(&self.guide, group.open(&mut state.scratch).z);
            base.extend_from_slice(group.open(&mut state.scratch).z);
            unknowns += group.unknowns();
        }
        Some(DriftMethod {
            state,
            base,
            starts,
            unknowns,
        })
    }

    /// Returns the deviation of the drifted state from the one looked up last.
    pub fn drifted(&self, drift: &DriftMethod) -> Deviation {
        self.subjects.deviation(&drift.state, &self.reference)
    }

    /// Returns the step between two driver coordinates, in the unit of derivatives.
    pub fn difference(&self, from: f64, to: f64) -> f64 {
        self.solver.engine.difference(from, to)
    }
}

impl DriftMethod {
    /// Returns the number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.unknowns
    }

    /// Computes the rates of the unknowns by the driver's coordinate at `at`, with the unknowns
    /// changed from the base by `change`. Returns `None` if they do not exist.
    pub fn rates(
        &mut self,
        methods: &Methods,
        at: f64,
        change: &[f64],
        rates: &mut [f64],
    ) -> Option<()> {
        let engine = &methods.rows.as_ref()?.engine;
        let mut starts = self.starts.iter();
        let (base, state) = (&self.base, &mut self.state);
        let done = run::<_, VELOCITY>(engine, at, state, |group, _, _, scratch| {
            starts.next().is_some_and(|&[from, first]| {
                let base = &base[from..from + group.width()];
                group.set_unknowns(base, &change[first..first + group.unknowns()], scratch);
                true
            })
        });
        if !done {
            return None;
        }
        for (group, &[_, first]) in engine.program.coupled.iter().zip(&self.starts) {
            let buffers = group.open(&mut self.state.scratch);
            rates[first..first + group.unknowns()].copy_from_slice(buffers.first);
        }
        Some(())
    }

    /// Adds `change` to the base.
    pub fn advance(&mut self, methods: &Methods, change: &[f64]) {
        let Some(rows) = &methods.rows else { return };
        for (group, &[from, first]) in rows.engine.program.coupled.iter().zip(&self.starts) {
            let base = &mut self.base[from..from + group.width()];
            let change = &change[first..first + group.unknowns()];
            group.set_unknowns(base, change, &mut self.state.scratch);
            base.copy_from_slice(group.open(&mut self.state.scratch).z);
        }
    }

    /// Computes the state at the base, with all rates. Returns `false` if it does not exist.
    pub fn settle(&mut self, methods: &Methods, at: f64) -> bool {
        let Some(rows) = &methods.rows else {
            return false;
        };
        let (base, mut starts) = (&self.base, self.starts.iter());
        run::<_, ACCELERATION>(&rows.engine, at, &mut self.state, |group, _, _, scratch| {
            starts.next().is_some_and(|&[from, _]| {
                let z = group.open(scratch).z;
                z.copy_from_slice(&base[from..from + group.width()]);
                true
            })
        })
    }
}
