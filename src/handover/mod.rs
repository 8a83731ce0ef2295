//! A scene handed over to others: a script that works its positions out again, by itself.
//!
//! The script has the lengths of the scene by name, a line for every group of the plan, and the formulas of these
//! groups: where two circles meet, where a circle meets a line, where lines do, which way an arm points that slides
//! through a pin. What is coupled is closed by Newton's method from where the scene opens. Places are complex
//! numbers, so that Python and MATLAB differ in their punctuation only. Nothing of the solver is in it but which side
//! each group lies on.

mod closure;
mod dialect;
mod identifiers;
mod placement;
mod sides;
mod terms;

use crate::scene::Scene;
use crate::solver::Solver;
use crate::wording::words;
pub use dialect::ScriptLanguage;
use dialect::Writing;
use placement::ScriptPlacement;

/// The script of a scene in the assembly that its solver has. `name` is that of its file, which MATLAB calls it by.
#[must_use]
pub fn script(scene: &Scene, solver: &Solver, language: ScriptLanguage, name: &str) -> String {
    let placement = ScriptPlacement::of(scene, solver, language);
    let (low, high) = solver.motion().range.ends();
    Writing {
        scene,
        placement: &placement,
        language,
        name,
        range: [low, high],
    }
    .text(words())
}
