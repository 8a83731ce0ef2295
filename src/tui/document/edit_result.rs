//! Solves the linkage again after an edit of its scene's text.
//!
//! The shown assembly is kept. If the edited text would open in another assembly, or does not
//! determine one, its `[start]` is updated as a part of the edit. The text then always opens in the
//! shown assembly, also after saving, undo or recovery.

use crate::scene::{Scene, figure};
use crate::solver::{Condition, Fault, Order, Solver};
use crate::tui::OpenedScene;
use crate::tui::player::open_scene::OpenScene;
use crate::wording::words;

/// The scene after an edit.
#[derive(Debug)]
pub(crate) struct EditedScene {
    pub(crate) opened: OpenedScene,
    /// `true` if `[start]` was updated.
    pub(crate) started: bool,
}

/// Opens the edited text in the shown assembly. The error is a message.
pub(crate) fn keeping(open_scene: &OpenScene, text: &str) -> Result<EditedScene, String> {
    let scene = parsed(open_scene, text)?;
    let plain = Solver::new(&scene.mechanism);
    // The shown assembly says nothing about other elements, such as more copies.
    if !scene.has_elements_of(open_scene.scene()) {
        return match plain {
            Ok(solver) => Ok(edited(open_scene, scene, solver, false)),
            Err(fault) => Err(fault_line(&scene, &fault)),
        };
    }
    let shown = open_scene.solver();
    let at = comparison_coordinate(open_scene, &scene);
    if let Ok(solver) = &plain
        && shown.has_sides_of(at, solver)
    {
        let solver = solver.clone();
        return Ok(edited(open_scene, scene, solver, false));
    }
    let kept = shown.with_dimensions_in_assembly(at, &scene.mechanism);
    let kept = kept.map_err(|fault| match &plain {
        Ok(_) => words().this_assembly(&fault_line(&scene, &fault)),
        Err(fault) => fault_line(&scene, fault),
    })?;
    if let Ok(solver) = plain
        && agree(&scene, &kept, &solver)
    {
        return Ok(edited(open_scene, scene, solver, false));
    }
    let text = scene.with_start_of(&kept, scene.mechanism.driver().start);
    let text = text.ok_or(words().no_start_tells_it())?;
    let edited = reopened(open_scene, &text)?;
    Ok(EditedScene {
        started: true,
        ..edited
    })
}

/// Opens a text in the assembly that the text determines.
pub(crate) fn reopened(open_scene: &OpenScene, text: &str) -> Result<EditedScene, String> {
    let scene = parsed(open_scene, text)?;
    match Solver::new(&scene.mechanism) {
        Ok(solver) => Ok(edited(open_scene, scene, solver, false)),
        Err(fault) => Err(fault_line(&scene, &fault)),
    }
}

/// Returns `true` if the text opens in the shown assembly. The command line may have chosen another
/// one.
pub(crate) fn opens_in_shown_assembly(open_scene: &OpenScene) -> bool {
    let scene = open_scene.scene();
    let plain = Solver::new(&scene.mechanism);
    plain.is_ok_and(|plain| agree(scene, open_scene.solver(), &plain))
}

fn edited(open_scene: &OpenScene, scene: Scene, solver: Solver, started: bool) -> EditedScene {
    let origin = open_scene.origin().clone();
    let opened = OpenedScene {
        scene,
        solver,
        origin,
    };
    EditedScene { opened, started }
}

fn parsed(open_scene: &OpenScene, text: &str) -> Result<Scene, String> {
    Scene::parse(text, open_scene.scene().origin())
        .map_err(|faults| faults.first_words().to_owned())
}

/// Returns the coordinate at which to compare assemblies: the edited scene's initial coordinate if
/// it is reachable, or else the previous one.
fn comparison_coordinate(open_scene: &OpenScene, changed: &Scene) -> f64 {
    let mut state = open_scene.solver().state();
    let mut reaches =
        |at| open_scene.solver().solve(at, Order::Position, &mut state) != Condition::NoAssembly;
    let openings = [changed, open_scene.scene()].map(|s| s.mechanism.driver().start);
    openings
        .into_iter()
        .find(|&at| reaches(at))
        .unwrap_or(open_scene.at())
}

/// Returns `true` if two solvers of a scene have the same assembly at its initial coordinate.
fn agree(scene: &Scene, one: &Solver, other: &Solver) -> bool {
    let at = scene.mechanism.driver().start;
    let (mut here, mut there) = (one.state(), other.state());
    let closes = [
        one.solve(at, Order::Position, &mut here),
        other.solve(at, Order::Position, &mut there),
    ];
    !closes.contains(&Condition::NoAssembly) && scene.agree(&here, &there)
}

/// Formats a fault as a short line.
fn fault_line(scene: &Scene, fault: &Fault) -> String {
    match fault {
        Fault::Open { point, gap, .. } => {
            let name = scene.point_name(*point).unwrap_or(words().a_joint());
            let (gap, unit) = (figure(*gap), scene.unit.symbol());
            words().joint_out_of_reach(name, &gap, unit)
        }
        Fault::Mobility { .. }
        | Fault::OverConstrained { .. }
        | Fault::Vague { .. }
        | Fault::ChangePoint { .. }
        | Fault::BeyondStop { .. }
        | Fault::FastInput { .. }
        | Fault::HeldByStops { .. }
        | Fault::NoChoice { .. }
        | Fault::NotAssembled { .. }
        | Fault::Singular { .. } => scene.explain(fault).first_words().to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Vec2;
    use crate::scene::{Measure, presets};
    use crate::tui::document::opening;

    fn places(scene: &Scene, solver: &Solver) -> Vec<Vec2> {
        let mut state = solver.state();
        let at = scene.mechanism.driver().start;
        assert_ne!(
            solver.solve(at, Order::Position, &mut state),
            Condition::NoAssembly
        );
        let points = scene.mechanism.point_ids();
        points.map(|point| state.position(point).unwrap()).collect()
    }

    /// Lengthening a link by 1e-4 of its length moves no point far; in another assembly some points
    /// would be elsewhere. The edited text reopens in the same assembly.
    #[test]
    fn small_edits_keep_assembly_of_every_preset() {
        let mut kept = 0;
        for preset in presets::all() {
            let open_scene = OpenScene::new(opening::preset(preset).unwrap());
            let before = places(open_scene.scene(), open_scene.solver());
            let size = before.iter().map(|p| p.norm()).fold(0.0, f64::max);
            let values = open_scene.scene().values();
            for value in values.iter().filter(|v| v.measure == Measure::Length) {
                let text = value.moved(1.0, value.number * 1e-4);
                let text = open_scene.scene().with_value(value, &text);
                // Overconstrained linkages close only with their own lengths.
                let Ok(edited) = keeping(&open_scene, &text) else {
                    continue;
                };
                kept += 1;
                let OpenedScene { scene, solver, .. } = &edited.opened;
                let name = format!("{}: {}", preset.name, value.name);
                let far = |after: &[Vec2]| {
                    let pairs = before.iter().zip(after);
                    pairs.map(|(a, b)| (*a - *b).norm()).fold(0.0, f64::max)
                };
                let moved = far(&places(scene, solver));
                assert!(moved < 0.05 * size, "{name} moves {moved} of {size}");
                let again = reopened(&open_scene, scene.text()).unwrap().opened;
                let moved = far(&places(&again.scene, &again.solver));
                assert!(
                    moved < 0.05 * size,
                    "{name} reopened moves {moved} of {size}"
                );
            }
        }
        assert!(kept > 50, "{kept}");
    }
}

#[cfg(test)]
mod nudges {
    use super::*;
    use crate::scene::{Measure, Value, presets};
    use crate::tui::Origin;

    fn open_scene(text: &str) -> OpenScene {
        let scene = Scene::parse(text, "test").unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        OpenScene::new(OpenedScene {
            scene,
            solver,
            origin: Origin::Preset("test".into()),
        })
    }

    /// Returns a small step for a value.
    fn nudge(value: &Value, size: f64) -> f64 {
        let own = if value.number == 0.0 {
            size
        } else {
            value.number
        };
        match value.measure {
            Measure::Angle => 1.0,
            // A decimal of one digit always parses as a number. Ten copies of a stage add up.
            _ => format!("{:.0e}", own * 5e-4).parse().unwrap(),
        }
    }

    /// Returns the maximum displacement of any point over the motion, relative to the size of the
    /// linkage.
    fn max_displacement(one: &OpenScene, other: &Solver) -> f64 {
        let (low, high) = one.solver().motion().range.ends();
        let size = one.extents().bounds().size().norm();
        let (mut here, mut there) = (one.solver().state(), other.state());
        let mut maximum = 0.0_f64;
        for k in 0..8 {
            let at = low + (high - low) * (f64::from(k) + 0.37) / 8.0;
            let closes = [
                one.solver().solve(at, Order::Position, &mut here),
                other.solve(at, Order::Position, &mut there),
            ];
            if closes.contains(&Condition::NoAssembly) {
                continue;
            }
            for point in one.scene().mechanism.point_ids() {
                let moved = (here.position(point).unwrap() - there.position(point).unwrap()).norm();
                maximum = maximum.max(moved / size);
            }
        }
        maximum
    }

    /// Every length, coordinate and angle of every preset is nudged both ways. Without change
    /// points, all points move little over the whole motion, and the text reopens as shown.
    #[test]
    fn small_nudges_move_points_slightly() {
        for preset in presets::all() {
            let first = open_scene(preset.text);
            if !first.solver().motion().change_points.is_empty() {
                continue;
            }
            let size = first.extents().bounds().size().norm();
            for value in first.scene().values() {
                if !matches!(
                    value.measure,
                    Measure::Length | Measure::Coordinate | Measure::Angle
                ) {
                    continue;
                }
                for sense in [1.0, -1.0] {
                    let text = value.moved(sense, nudge(&value, size));
                    let text = first.scene().with_value(&value, &text);
                    let Ok(edited) = keeping(&first, &text) else {
                        continue;
                    };
                    let named = format!("{} {} {sense}", preset.name, value.name);
                    let moved = max_displacement(&first, &edited.opened.solver);
                    assert!(moved < MAX_MOVE, "{named}: {moved}");
                    let again = Scene::parse(edited.opened.scene.text(), "test").unwrap();
                    let solver = Solver::new(&again.mechanism).unwrap();
                    let same = agree(&again, &edited.opened.solver, &solver);
                    assert!(same, "{named}");
                }
            }
        }
    }

    /// Maximum displacement relative to the size of the linkage; another assembly would be farther
    /// off.
    const MAX_MOVE: f64 = 0.1;
}
