//! Ends of the motion to the last digit: which doubles are inside, and the mechanism's state there.
//!
//! The values in `edges.txt` were computed with 90 digits (mpmath). For each chain of dyads and
//! each toggle, the file has its ends, and its joints at the eight doubles before the one nearest
//! to an end. A chain is turned about (0, 0) from `start`. A dyad is `rrr X Y b c`, with b from the
//! last joint and c from a pivot, or `rrp o b`, with b onto the line y = o. Its approximate joint
//! at the start follows.

use crate::exact::DoubleDouble;
use crate::rig::{U, exact, note, point};
use krank::LANES;
use krank::quantity::{self, Aspect, Subject};
use krank::scene::Scene;
use krank::solver::{Condition, Order, Range, Solver};
use std::fmt::Write as _;

const CASES: &str = include_str!("edges.txt");
/// Number of doubles tested beyond an end.
const DOUBLES_PAST_END: usize = 8;
/// Maximum relative error, 16 u.
const RIGHT: f64 = 16.0 * U;

/// One mechanism of the file with its reference values.
struct Case {
    name: &'static str,
    scene: String,
    ends: Vec<End>,
}

struct End {
    limit: DoubleDouble,
    /// The joints by the driver's coordinate.
    states: Vec<(f64, Vec<Joint>)>,
}

/// A joint and its position.
type Joint = (String, [DoubleDouble; 2]);

fn cases() -> Vec<Case> {
    let mut cases: Vec<Case> = Vec::new();
    let (mut pivots, mut joints) = (String::new(), 0);
    for line in CASES.lines() {
        let words: Vec<&str> = line.split(' ').collect();
        let case = cases.last_mut();
        match (&words[..], case) {
            (["chain", name, start, crank], _) => {
                (pivots, joints) = (String::new(), 0);
                let scene = format!(
                    "unit = \"mm\"\n[driver]\nlink = \"r2\"\nangle = {start}\nspeed = \"1 rad/s\"\n\
                     [links]\nr2 = {{ from = \"A\", to = \"P0\", length = {crank} }}\n"
                );
                cases.push(Case {
                    name,
                    scene,
                    ends: Vec::new(),
                });
            }
            (["toggle", a, b, start], _) => {
                let scene = format!(
                    "unit = \"mm\"\n[ground]\nA = [0, 0]\n[driver]\nslide = \"s\"\nposition = {start}\n\
                     speed = \"1 mm/s\"\n[links]\nr2 = {{ from = \"A\", to = \"P1\", length = {a} }}\n\
                     r3 = {{ from = \"P1\", to = \"F\", length = {b} }}\n[slides]\n\
                     s = {{ point = \"F\", on = \"ground\", through = [0, 0], angle = 0 }}\n\
                     [start]\nP1 = [0, {a}]\n"
                );
                cases.push(Case {
                    name: "toggle",
                    scene,
                    ends: Vec::new(),
                });
            }
            (["dyad", kind, rest @ ..], Some(case)) => {
                joints += 1;
                let (from, to) = (joints - 1, joints);
                let text = match (kind, rest) {
                    (&"rrr", [x, y, b, c, _, _]) => {
                        writeln!(pivots, "D{to} = [{x}, {y}]").unwrap();
                        format!(
                            "b{to} = {{ from = \"P{from}\", to = \"P{to}\", length = {b} }}\n\
                             c{to} = {{ from = \"D{to}\", to = \"P{to}\", length = {c} }}\n"
                        )
                    }
                    (_, [offset, b, _, _]) => format!(
                        "b{to} = {{ from = \"P{from}\", to = \"P{to}\", length = {b} }}\n[slides]\n\
                         s = {{ point = \"P{to}\", on = \"ground\", through = [0, {offset}], angle = 0 }}\n"
                    ),
                    _ => panic!("{line}"),
                };
                let [.., x, y] = rest else { panic!("{line}") };
                case.scene.push_str(&text);
                case.scene.push_str(&format!("#P{to} = [{x}, {y}]\n"));
            }
            (["end", limit, _], Some(case)) => {
                if case.ends.is_empty() && case.name != "toggle" {
                    let starts: String = (case.scene.lines())
                        .filter_map(|l| l.strip_prefix('#'))
                        .map(|l| format!("{l}\n"))
                        .collect();
                    write!(
                        case.scene,
                        "[ground]\nA = [0, 0]\n{pivots}[start]\n{starts}"
                    )
                    .unwrap();
                }
                let limit = exact(limit);
                case.ends.push(End {
                    limit,
                    states: Vec::new(),
                });
            }
            (["at", at, joints @ ..], Some(case)) => {
                let joint = |of: &[&str]| (format!("P{}", of[0]), [exact(of[1]), exact(of[2])]);
                let joints = joints.chunks(3).map(joint).collect();
                let end = case.ends.last_mut().expect("after an end");
                end.states.push((at.parse().expect("a double"), joints));
            }
            _ => panic!("{line}"),
        }
    }
    cases
}

#[test]
fn every_double_next_to_end_has_correct_state() {
    let (mut sides, mut count, mut right, mut unproved, mut widest) = (0, 0, 0, 0, 0.0_f64);
    for case in cases() {
        let name = case.name;
        let scene = Scene::parse(&case.scene, name)
            .unwrap_or_else(|e| panic!("{name}: {e:?}\n{}", case.scene));
        let solver = Solver::new(&scene.mechanism).unwrap_or_else(|e| panic!("{name}: {e}"));
        let Range::Limited { low, high } = solver.motion().range else {
            panic!("{name} has ends");
        };
        let (mut state, mut balls, mut lanes) =
            (solver.state(), solver.enclosure(), solver.lanes());
        for (end, (named, sense)) in case.ends.iter().zip([(high, 1.0), (low, -1.0)]) {
            let miss = |at: f64| end.limit.minus(at).abs();
            let (up, down) = (named.next_up(), named.next_down());
            assert!(
                miss(named) <= miss(up).min(miss(down)),
                "{name}: {named} is not the nearest double to the end, off by {:e}",
                miss(named)
            );
            let mut condition = |at: f64| solver.solve(at, Order::Position, &mut state);
            assert_eq!(condition(named), Condition::DeadPoint, "{name} at {named}");
            let mut outside = named;
            for _ in 0..DOUBLES_PAST_END {
                outside = if sense > 0.0 {
                    outside.next_up()
                } else {
                    outside.next_down()
                };
                assert_eq!(
                    condition(outside),
                    Condition::NoAssembly,
                    "{name} at {outside}"
                );
                sides += 1;
            }
            for (at, joints) in &end.states {
                let order = Order::Acceleration;
                let found = solver.solve(*at, order, &mut state);
                assert_eq!(found, Condition::Ok, "{name} at {at}, the end is {named}");
                sides += 1;
                assert!(!solver.solve_lanes([*at; LANES], order, &mut lanes));
                solver.enclose(&mut state, order, &mut balls);
                for (joint, place) in joints {
                    let point = point(&scene, joint);
                    for (aspect, truth) in [Aspect::X, Aspect::Y].into_iter().zip(place) {
                        let subject = Subject::Point(point);
                        let value = quantity::value(subject, aspect, &*state).unwrap();
                        let bound = quantity::bound(subject, aspect, &state, &balls);
                        let off = truth.minus(value).abs();
                        count += 1;
                        right += usize::from(off <= RIGHT * value.abs());
                        let Some(bound) = bound else {
                            unproved += 1;
                            continue;
                        };
                        assert!(
                            off <= bound,
                            "{name} {joint} at {at}: {value} is off by {off:e}, bound {bound:e}"
                        );
                        // A coordinate of up to 15 digits is meant as the decimal, which may differ
                        // from the double.
                        if at.to_string().len() > 17 {
                            widest = widest.max(bound / (U * value.abs()));
                        }
                    }
                }
            }
        }
    }
    note(&format!(
        "edges: {sides} sides; of {count} figures {right} are right to 16 u, {unproved} have no bound; \
         bounds of at most {widest:.0} u"
    ));
    assert_eq!((right, unproved), (count, 0));
    assert!(sides >= 900, "{sides}");
}
