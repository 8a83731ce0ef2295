//! Rates next to the ends of the motion, where they grow without limit: every value is within its
//! bound. Also, a lever next to its end is in the assembly in which it was drawn.
//!
//! `edge_rates.txt` was computed with 90 digits (mpmath). It has four-bars `crank coupler rocker
//! ground start Cx Cy`. For each of them it has coordinates, from the last doubles before an end of
//! the motion to points further inside, with the position, velocity and acceleration of the joint C
//! at 2 rad/s.

use crate::rig::{U, exact, note, point};
use krank::quantity::{self, Aspect, Subject};
use krank::scene::Scene;
use krank::solver::{Condition, Order, Solver, Workspace};
use krank::{Ball, PointId, Vec2};

const CASES: &str = include_str!("edge_rates.txt");
const ASPECTS: [Aspect; 6] = [
    Aspect::X,
    Aspect::Y,
    Aspect::Vx,
    Aspect::Vy,
    Aspect::Ax,
    Aspect::Ay,
];
/// Distance to an end, in rounding errors of the angle, below which a coordinate is one of the last
/// doubles.
const NEXT: f64 = 16.0;
/// Maximum relative error of values there, relative to the larger of the two components.
const RIGHT: f64 = 16.0 * U;

struct Opened {
    solver: Solver,
    joint: PointId,
    state: Workspace,
    balls: Workspace<Ball>,
}

fn open(words: &[&str]) -> Opened {
    let [crank, coupler, rocker, ground, start, x, y] = words else {
        panic!("{words:?}");
    };
    let text = format!(
        "unit = \"mm\"\n[ground]\nA = [0, 0]\nD = [{ground}, 0]\n\
         [driver]\nlink = \"r2\"\nangle = {start}\nspeed = \"2 rad/s\"\n\
         [links]\nr2 = {{ from = \"A\", to = \"B\", length = {crank} }}\n\
         r3 = {{ from = \"B\", to = \"C\", length = {coupler} }}\n\
         r4 = {{ from = \"D\", to = \"C\", length = {rocker} }}\n\
         [start]\nC = [{x}, {y}]\n"
    );
    let scene = Scene::parse(&text, "four-bar").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    Opened {
        joint: point(&scene, "C"),
        state: solver.state(),
        balls: solver.enclosure(),
        solver,
    }
}

#[test]
fn rates_next_to_end_are_within_their_bounds() {
    let mut opened = None;
    let (mut figures, mut worst) = (0, [0.0_f64; 3]);
    for line in CASES.lines() {
        let words: Vec<&str> = line.split(' ').collect();
        if let ["four-bar", sizes @ ..] = &words[..] {
            opened = Some(open(sizes));
            continue;
        }
        let (
            Some(Opened {
                solver,
                joint,
                state,
                balls,
            }),
            ["at", at, truths @ ..],
        ) = (&mut opened, &words[..])
        else {
            panic!("{line}");
        };
        let at: f64 = at.parse().unwrap();
        let found = solver.solve(at, Order::Acceleration, state);
        assert_eq!(found, Condition::Ok, "{line}");
        solver.enclose(state, Order::Acceleration, balls);
        let (low, high) = solver.motion().range.ends();
        let is_edge = (at - low).abs().min((at - high).abs()) < NEXT * U * at.abs();
        let truths: Vec<_> = truths.iter().map(|t| exact(t)).collect();
        for (k, (aspect, truth)) in ASPECTS.into_iter().zip(&truths).enumerate() {
            let subject = Subject::Point(*joint);
            let value = quantity::value(subject, aspect, &*state).unwrap();
            let off = truth.minus(value).abs();
            let size = truths[k / 2 * 2]
                .minus(0.0)
                .abs()
                .max(truths[k / 2 * 2 + 1].minus(0.0).abs());
            if is_edge {
                worst[k / 2] = worst[k / 2].max(off / size);
            }
            let bound = quantity::bound(subject, aspect, state, balls);
            let bound = bound.unwrap_or_else(|| panic!("{aspect:?} has no bound: {line}"));
            assert!(
                off <= bound,
                "{aspect:?} is {value}, off by {off:e}, bound {bound:e}: {line}"
            );
            figures += 1;
        }
    }
    let [places, velocities, accelerations] = worst.map(|w| w / U);
    note(&format!(
        "rates at edges: {figures} figures; off by at most {places:.1} u, {velocities:.0} u, {accelerations:.0} u"
    ));
    assert_eq!(figures, 6 * 112);
    assert!(worst.iter().all(|worst| *worst <= RIGHT), "{worst:?}");
}

/// A lever whose reach is 4e-8 of its scale at the start; rounding its numbers changes this to
/// 3.687e-8 (40 digits). Its two assemblies are 1.2e-7 rad apart, and only the approximate position
/// of a point other than the dyad's own joint distinguishes them. The lever used to open in the
/// other assembly.
#[test]
fn lever_next_to_its_end_opens_in_drawn_assembly() {
    let (pivot, tip) = (
        Vec2::new(1.478_119_643_997_737_3, -0.055_180_402_097_909_975),
        Vec2::new(0.548_068_179_792_910_3, 0.312_248_875_356_211_15),
    );
    // Between the assemblies the lever turns by twice the reach divided by the offset.
    for (turned, reach) in [(0.0, -3.687e-8), (1.302e-7, 3.687e-8)] {
        let tip = tip + (tip - pivot).perp() * turned;
        let text = format!(
            "unit = \"m\"\n[ground]\nO = [0, 0]\nP = [{}, {}]\n\
             [driver]\nlink = \"r2\"\nangle = 333.5533719098959\nspeed = \"1 rad/s\"\n\
             [links]\nr2 = {{ from = \"O\", to = \"A\", length = 1.400097255827915 }}\n\
             r3 = {{ from = \"P\", to = \"T\", length = 1 }}\n\
             [slides]\ns = {{ point = \"A\", on = \"r3\", through = [0, 0.6111193653788163], angle = 0 }}\n\
             [start]\nT = [{}, {}]\n",
            pivot.x, pivot.y, tip.x, tip.y
        );
        let scene = Scene::parse(&text, "lever").unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let mut state = solver.state();
        let found = solver.solve(333.5533719098959, Order::Position, &mut state);
        assert_eq!(found, Condition::Ok);
        let slide = scene.mechanism.slide_ids().next().unwrap();
        let travel = state.travel(slide).unwrap().position;
        assert!((travel - reach).abs() < 1e-11, "{travel:e} for {reach:e}");
    }
}
