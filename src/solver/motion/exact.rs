//! The mechanism as lengths are compared by: where two assemblies meet depends on whether lengths are
//! equal, and that is decided from the numbers that were typed, not from the doubles next to them.

use crate::solver::engine::Engine;
use std::rc::Rc;

/// What twice the precision leaves open of an equality, in units of about the longest link.
const FLOOR: f64 = 1e-25;

/// The mechanism in the numbers that lengths are compared by, made when it is first asked for.
pub(super) struct Exact<'e> {
    make: &'e dyn Fn() -> Option<Engine>,
    made: Option<Rc<Engine>>,
}

impl<'e> Exact<'e> {
    pub(super) fn new(make: &'e dyn Fn() -> Option<Engine>) -> Exact<'e> {
        Exact { make, made: None }
    }

    pub(super) fn engine(&mut self) -> Option<Rc<Engine>> {
        if self.made.is_none() {
            self.made = (self.make)().map(Rc::new);
        }
        self.made.clone()
    }

    /// By how much equal lengths can differ, because two ground points have coordinates that were
    /// rounded, in the solver's unit; `None` where nothing was compared.
    pub(super) fn tolerance(&self) -> Option<f64> {
        Some(rounding(self.made.as_ref()?))
    }

    /// The same with what twice the precision leaves open.
    pub(super) fn slack(&mut self) -> f64 {
        let _ = self.engine();
        self.tolerance().unwrap_or(0.0) + FLOOR
    }
}

/// What parts two ground points, at the most, that were rounded: numbers of 15 digits or more have been.
fn rounding(engine: &Engine) -> f64 {
    let points = engine.program.points.iter();
    let sizes = points.map(|p| p.x.radius.hypot(p.y.radius));
    sizes.fold(0.0, f64::max)
}
