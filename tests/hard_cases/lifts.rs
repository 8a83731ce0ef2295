//! Scissor lifts with redundant guides, driven at the floor and by cylinders. A lift with a
//! cylinder and a guided platform used to be rejected with a free motion, although it has too many
//! constraints, not too few.

use krank::Vec2;
use krank::scene::Scene;
use krank::solver::{Condition, GroupKind, Order, Solver};
use std::fmt::Write as _;

/// The length of the bars.
const BAR: f64 = 1000.0;
/// The cylinder's ground pivot, and the distance of its pin along the first bar.
const FOOT: Vec2 = Vec2::new(150.0, 0.0);
const PUSHED: f64 = 700.0;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Drive {
    /// The right foot moves along the floor.
    Floor,
    /// A cylinder acts from the ground on the first bar.
    Ground,
    /// A cylinder acts from the second bar of the first stage on its first bar.
    Arms,
}

/// The platform's guides in addition to its bars.
#[derive(Clone, Copy, Debug)]
struct Guides {
    /// A block along a mast, locked in rotation: it repeats two constraints.
    mast: bool,
    /// A pin at the platform's far end in a vertical slot: one more.
    slot: bool,
}

impl Guides {
    fn redundant(self) -> usize {
        2 * usize::from(self.mast) + usize::from(self.slot)
    }
}

fn bar(degrees: f64) -> Vec2 {
    krank::angle::unit(degrees) * BAR
}

/// Returns the driver's coordinate at an angle of the bars, in degrees.
fn coordinate(drive: Drive, degrees: f64) -> f64 {
    let along = bar(degrees);
    let pushed = along * (PUSHED / BAR);
    match drive {
        Drive::Floor => along.x,
        Drive::Ground => (pushed - FOOT).norm(),
        // From the middle of the lower half of the second bar, which falls from left to right.
        Drive::Arms => (pushed - Vec2::new(0.75 * along.x, 0.25 * along.y)).norm(),
    }
}

fn lift(stages: usize, drive: Drive, guides: Guides, degrees: f64) -> String {
    let along = bar(degrees);
    let at = coordinate(drive, degrees);
    let mut links = String::new();
    let mut start = String::new();
    for k in 1..=stages {
        let below = k - 1;
        let pushed = if k == 1 { ", P = [700, 0]" } else { "" };
        let held = if k == 1 { ", Q = [250, 0]" } else { "" };
        let _ = writeln!(
            links,
            "a{k} = {{ from = \"L{below}\", to = \"R{k}\", length = 1000, points = {{ M{k} = [500, 0]{pushed} }} }}\n\
             b{k} = {{ from = \"R{below}\", to = \"L{k}\", length = 1000, points = {{ M{k} = [500, 0]{held} }} }}",
        );
        let height = along.y * (k as f64 - 0.5);
        let _ = writeln!(start, "M{k} = [{}, {height}]", 0.5 * along.x);
        let _ = writeln!(start, "L{k} = [0, {}]", along.y * k as f64);
        let _ = writeln!(start, "R{k} = [{}, {}]", along.x, along.y * k as f64);
    }
    let top = along.y * stages as f64;
    let _ = writeln!(start, "R0 = [{}, 0]\nE = [900, {top}]", along.x);
    let pushed = along * (PUSHED / BAR);
    let _ = writeln!(start, "P = [{}, {}]", pushed.x, pushed.y);
    let mut slides = "floor = { point = \"R0\", on = \"ground\", through = \"L0\" }\n".to_owned();
    let _ = writeln!(
        slides,
        "upper = {{ point = \"R{stages}\", on = \"top\", through = \"L{stages}\" }}"
    );
    let (mut ground, mut driven) = ("L0 = [0, 0]\n".to_owned(), "floor");
    let foot = match drive {
        Drive::Floor => None,
        Drive::Ground => {
            let _ = writeln!(ground, "G = [{}, {}]", FOOT.x, FOOT.y);
            Some("G")
        }
        Drive::Arms => Some("Q"),
    };
    if let Some(foot) = foot {
        driven = "cylinder";
        let _ = writeln!(links, "barrel = {{ points = {{ {foot} = [0, 0] }} }}");
        let _ = writeln!(
            slides,
            "cylinder = {{ point = \"P\", on = \"barrel\", through = \"{foot}\" }}"
        );
    }
    if guides.mast {
        slides += "mast = { link = \"top\", on = \"ground\", through = \"L0\", angle = 90, turn = -90 }\n";
    }
    if guides.slot {
        slides += "side = { point = \"E\", on = \"ground\", through = [900, 0], angle = 90 }\n";
    }
    format!(
        "[ground]\n{ground}[driver]\nslide = \"{driven}\"\nposition = {at}\n\
         [links]\n{links}top = {{ from = \"L{stages}\", to = \"E\", length = 900 }}\n\
         [slides]\n{slides}[start]\n{start}"
    )
}

/// Returns the error of one lift, if any.
fn complaint(stages: usize, drive: Drive, guides: Guides) -> Option<String> {
    let scene = Scene::parse(&lift(stages, drive, guides, 40.0), "lift").expect("a scene");
    let solver = match Solver::new(&scene.mechanism) {
        Ok(solver) => solver,
        Err(fault) => return Some(scene.explain(&fault).to_string()),
    };
    let redundancies = &solver.rank().redundancies;
    let count: usize = redundancies.iter().map(|r| r.constraints).sum();
    if count != guides.redundant() || redundancies.iter().any(|r| r.misfit > 1e-8) {
        return Some(format!("{redundancies:?}"));
    }
    off(&scene, &solver, stages, drive)
}

/// Returns the error of the platform's position, if any.
fn off(scene: &Scene, solver: &Solver, stages: usize, drive: Drive) -> Option<String> {
    let mut points = scene.mechanism.point_ids();
    let end = points
        .find(|&p| scene.point_name(p) == Some("E"))
        .expect("E");
    let mut state = solver.state();
    for degrees in [25.0, 40.0, 55.0, 70.0] {
        let condition = solver.solve(coordinate(drive, degrees), Order::Position, &mut state);
        let height = bar(degrees).y * stages as f64;
        let miss = (state.position(end).unwrap() - Vec2::new(900.0, height)).norm();
        if condition != Condition::Ok || miss.is_nan() || miss > 1e-8 * height {
            return Some(format!("{condition:?} at {degrees} deg, off by {miss:e}"));
        }
    }
    None
}

#[test]
fn lift_with_redundant_guides_opens_and_moves() {
    let all = [false, true].map(|mast| [false, true].map(|slot| Guides { mast, slot }));
    let mut wrong = Vec::new();
    for stages in [1, 2, 3] {
        for drive in [Drive::Floor, Drive::Ground, Drive::Arms] {
            for guides in all.concat() {
                let text = complaint(stages, drive, guides);
                wrong.extend(text.map(|s| format!("{stages} {drive:?} {guides:?}: {s}")));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// In a tall lift, a bar of the last stage must be set aside. Any other choice leaves a coupled
/// group of up to 199 unknowns, and opening used to take 20 s.
#[test]
fn tall_lift_with_guides_is_solved_by_dyads() {
    let guides = Guides {
        mast: true,
        slot: true,
    };
    let cases = [
        (20, Drive::Floor, 0),
        (20, Drive::Ground, 0),
        (20, Drive::Arms, 7),
        (50, Drive::Ground, 0),
    ];
    for (stages, drive, maximum) in cases {
        let scene = Scene::parse(&lift(stages, drive, guides, 40.0), "lift").expect("a scene");
        let solver = Solver::new(&scene.mechanism).expect("it opens");
        for group in &solver.plan().groups {
            if let GroupKind::Coupled { unknowns } = group.kind {
                assert!(
                    unknowns <= maximum,
                    "{stages} {drive:?}: {unknowns} unknowns"
                );
            }
        }
        assert_eq!(off(&scene, &solver, stages, drive), None);
    }
}
