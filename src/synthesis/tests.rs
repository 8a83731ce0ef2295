//! Tests that the scene of a proposal is the evaluated mechanism.

use super::*;
use crate::Vec2;
use crate::scene::Scene;
use crate::solver::{Condition, Order, Solver};

/// Evaluates a proposal, and returns the candidate and its task's scene, parsed.
fn evaluate_and_open(kind: TaskKind, proposal: &Proposal) -> (Candidate, Scene) {
    let task = Task {
        kind,
        four_bars: true,
        slider_cranks: true,
        preferences: Preferences::default(),
    };
    let candidate = Candidate::evaluate(&task, proposal);
    let text = scene_text(&candidate.proposal, &task, &SceneTitles::default()).unwrap();
    let scene = Scene::parse(&text, "").unwrap();
    (candidate, scene)
}

/// Returns the positions of B, C and P in the scene at a crank angle.
fn places(scene: &Scene, at: f64) -> [Option<Vec2>; 3] {
    let solver = Solver::new(&scene.mechanism).unwrap();
    let mut state = solver.state();
    assert_eq!(solver.solve(at, Order::Position, &mut state), Condition::Ok);
    ["B", "C", "P"].map(|name| {
        let mut points = scene.mechanism.point_ids();
        let point = points.find(|id| scene.point_name(*id) == Some(name))?;
        state.position(point)
    })
}

/// A linkage passes through its own points when evaluated, and so does its scene. Covers a four-bar
/// and a slider-crank.
#[test]
fn scene_of_proposal_moves_like_evaluated_linkage() {
    let b = |at: f64| Vec2::new(20.0, -10.0) + crate::angle::unit(at) * 100.0;
    let tracer_in_coupler = Vec2::new(0.4, 0.25);
    let angles = [10.0, 70.0, 150.0];
    for constraint in [
        PinConstraint::Rocker(Vec2::new(420.0, 30.0)),
        PinConstraint::Slide(10.0),
    ] {
        let pins = angles.map(|at| {
            let b = b(at);
            let (foot, half) = match constraint {
                PinConstraint::Rocker(d) => {
                    let base = d - b;
                    let along = (base.norm2() + 300.0_f64.powi(2) - 250.0_f64.powi(2))
                        / (2.0 * base.norm2());
                    let foot = b + base * along;
                    (foot, base.perp() * (1.0 / base.norm()))
                }
                PinConstraint::Slide(angle) => {
                    let normal = crate::angle::unit(angle).perp();
                    let through = Vec2::new(20.0, 20.0);
                    let foot = b + normal * normal.dot(through - b);
                    (foot, crate::angle::unit(angle))
                }
            };
            let height = (300.0_f64.powi(2) - (foot - b).norm2()).sqrt();
            [b, foot + half * height]
        });
        let guided = |[b, c]: [Vec2; 2]| b + (c - b).turned(tracer_in_coupler);
        let proposal = Proposal {
            pivot: Vec2::new(20.0, -10.0),
            partner: constraint,
            places: pins.to_vec(),
            tracer: Some(guided(pins[0])),
        };
        let path = PathTask {
            points: pins.map(guided).to_vec(),
            weights: vec![1.0; 3],
            ..PathTask::default()
        };
        let (candidate, scene) = evaluate_and_open(TaskKind::Path(path), &proposal);
        assert_eq!(candidate.defects, []);
        assert_eq!(
            candidate.proposal, proposal,
            "the crank that was proposed is driven"
        );
        assert!(candidate.figures.miss < 1e-10, "{:?}", candidate.figures);
        for (at, [b, c]) in candidate.at.iter().zip(pins) {
            for (found, expected) in places(&scene, *at).into_iter().zip([b, c, guided([b, c])]) {
                assert!(
                    (found.unwrap() - expected).norm() < 1e-9,
                    "{constraint:?} {at}"
                );
            }
        }
    }
}
