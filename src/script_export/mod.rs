//! Exports a scene as a script that computes its positions without krank.
//!
//! The script has the scene's lengths by name, a line for every group of the plan, and the formulas
//! of these groups. The formulas are intersections of two circles, of a circle and a line, and of
//! two lines, and the direction of an arm that slides through a pin. Coupled groups are closed by
//! Newton's method from the scene's start. Places are complex numbers, so that Python and MATLAB
//! differ in punctuation only. The solver contributes only the side of each group.

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

/// Returns the script of a scene in the assembly of its solver. `name` is that of its file, which
/// MATLAB also uses for the function.
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
