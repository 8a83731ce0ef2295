//! All assemblies of a coupled group: a link on three legs has up to six. The tests count them
//! independently by turning the link through all directions.

use krank::solver::{Condition, GroupId, Order, Solver};
use krank::{Driver, Input, Mechanism, PointId, Vec2};

/// A link on three legs; the first foot is the crank's pin.
#[derive(Clone, Copy, Debug)]
struct Triad {
    feet: [Vec2; 3],
    legs: [f64; 3],
    /// The attachment points of the legs in the link's own frame.
    tops: [Vec2; 3],
}

impl Triad {
    /// Builds the mechanism with the crank at 0 deg and its pin at the first foot.
    fn build(&self, start: Option<[Vec2; 3]>) -> (Mechanism, [PointId; 3]) {
        let mut m = Mechanism::builder();
        let pivot = m.ground_point(self.feet[0].x - 0.01, self.feet[0].y);
        let pin = m.moving_point();
        let crank = m.link(pivot, pin, 0.01);
        let tops = [(); 3].map(|()| m.moving_point());
        let link = m.free_link();
        for i in 0..3 {
            m.carry(link, tops[i], self.tops[i]);
            let foot = if i == 0 {
                pin
            } else {
                m.ground_point(self.feet[i].x, self.feet[i].y)
            };
            m.link(foot, tops[i], self.legs[i]);
            if let Some(start) = start {
                m.start(tops[i], start[i]);
            }
        }
        m.driver(Driver {
            input: Input::Turn(crank),
            start: 0.0,
            speed: 1.0,
            acceleration: 0.0,
        });
        (m.build().unwrap(), tops)
    }

    /// Returns the residual of the third leg for a direction of the link with the first two legs in
    /// place, on either side; `None` if these do not meet.
    fn misfits(&self, angle: f64) -> Option<[f64; 2]> {
        let turned = |p: Vec2| p.turned(krank::angle::unit(angle));
        // The first top is on two circles, the second of which is shifted by the vector between the
        // tops.
        let p = self.feet[0];
        let q = self.feet[1] - turned(self.tops[1] - self.tops[0]);
        let u = q - p;
        let d2 = u.norm2();
        let along = (d2 + self.legs[0].powi(2) - self.legs[1].powi(2)) / (2.0 * d2);
        let across = (self.legs[0].powi(2) / d2 - along * along).sqrt();
        let misfit = |side: f64| {
            let first = p + u * along + u.perp() * (side * across);
            let third = first + turned(self.tops[2] - self.tops[0]);
            (third - self.feet[2]).norm() - self.legs[2]
        };
        (across >= 0.0).then(|| [misfit(1.0), misfit(-1.0)])
    }

    /// Counts the solutions of the third leg over one turn of the link. Returns `None` if it nearly
    /// touches without fitting, or fits twice within a step: the count then depends on the last
    /// digits.
    fn count(&self, steps: usize) -> Option<usize> {
        let at = |k: usize| self.misfits(360.0 * (k % steps) as f64 / steps as f64);
        let mut count = 0;
        for k in 0..steps {
            match (at(k), at(k + 1)) {
                (Some(now), Some(next)) => {
                    for side in 0..2 {
                        count += usize::from(now[side] * next[side] < 0.0);
                        let after = at(k + 2).map_or(next[side], |a| a[side]);
                        let is_rotary = (next[side] - now[side]) * (after - next[side]) < 0.0;
                        if is_rotary && now[side] * after > 0.0 && next[side].abs() < 1e-4 {
                            return None;
                        }
                    }
                }
                // Where the two legs become collinear, the sides join.
                (Some([a, b]), None) | (None, Some([a, b])) => {
                    count += usize::from(a * b < 0.0);
                    if a.abs().min(b.abs()) < 0.02 {
                        return None;
                    }
                }
                (None, None) => {}
            }
        }
        Some(count)
    }
}

/// Pseudo-random numbers, equal in every run: Knuth's multiplier.
struct Numbers(u64);

impl Numbers {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn place(&mut self, size: f64) -> Vec2 {
        Vec2::new(self.between(-size, size), self.between(-size, size))
    }

    fn triad(&mut self) -> Triad {
        let feet = [(); 3].map(|()| self.place(1.5));
        let tops = [(); 3].map(|()| self.place(1.0));
        // A nearby pose guarantees at least one assembly.
        let (middle, turn) = (
            self.place(0.7),
            krank::angle::unit(self.between(0.0, 360.0)),
        );
        let leg = |i: usize| (middle + tops[i].turned(turn) - feet[i]).norm();
        Triad {
            feet,
            legs: [leg(0), leg(1), leg(2)],
            tops,
        }
    }
}

fn coupled(solver: &Solver) -> GroupId {
    let groups = solver.plan().numbered();
    groups.filter(|(_, g)| g.has_choices()).last().unwrap().0
}

#[test]
fn search_finds_as_many_assemblies_as_fine_scan() {
    let mut numbers = Numbers(3);
    let mut seen = [0; 4];
    for _ in 0..200 {
        let triad = numbers.triad();
        let Some(count) = triad.count(20_000) else {
            continue;
        };
        let (mechanism, tops) = triad.build(None);
        // Without a start it is rejected if there are several; any pick serves to list them all.
        let somewhere = match Solver::new(&mechanism) {
            Ok(solver) => solver,
            Err(krank::solver::Fault::Vague { .. }) => {
                let first = krank::ElementId::Point(tops[0]);
                Solver::with_assembly(
                    &mechanism,
                    &[(first, krank::solver::AssemblyChoice::Number(1))],
                )
                .unwrap()
            }
            Err(fault) => panic!("{fault:?}: {triad:?}"),
        };
        let choices = somewhere.choices(0.0, coupled(&somewhere));
        assert_eq!(choices.len(), count, "{triad:?}");
        assert_eq!(choices.iter().filter(|c| c.is_current).count(), 1);
        for choice in &choices {
            let place = tops.map(|p| choice.state.position(p).unwrap());
            for i in 0..3 {
                let leg = (place[i] - triad.feet[i]).norm();
                assert!(
                    (leg - triad.legs[i]).abs() < 1e-12,
                    "{leg} {}",
                    triad.legs[i]
                );
                let j = (i + 1) % 3;
                let side = (place[i] - place[j]).norm();
                assert!((side - (triad.tops[i] - triad.tops[j]).norm()).abs() < 1e-12);
            }
            // Each assembly can be opened by its position and is then the current one.
            let (mechanism, _) = triad.build(Some(place));
            let opened = Solver::new(&mechanism).unwrap();
            let mut state = opened.state();
            assert_eq!(
                opened.solve(0.0, Order::Position, &mut state),
                Condition::Ok
            );
            assert!((state.position(tops[1]).unwrap() - place[1]).norm() < 1e-9);
        }
        seen[count / 2] += 1;
    }
    assert!(seen[1] > 20 && seen[2] > 5 && seen[3] > 0, "{seen:?}");
}

/// Rough starts, rougher than a user's, and some close to a limit, where two assemblies nearly
/// meet. Newton's method alone used to fail for some.
#[test]
fn rough_start_opens_nearest_assembly() {
    let mut numbers = Numbers(11);
    for _ in 0..300 {
        let triad = numbers.triad();
        let rough = [(); 3].map(|()| numbers.place(3.0));
        let (mechanism, tops) = triad.build(Some(rough));
        let solver = match Solver::new(&mechanism) {
            Ok(solver) => solver,
            Err(fault) => panic!("{fault:?}: {triad:?} from {rough:?}"),
        };
        // The opened assembly is the nearest of all.
        let choices = solver.choices(0.0, coupled(&solver));
        let miss = |c: &krank::solver::Choice| -> f64 {
            let place = tops.map(|p| c.state.position(p).unwrap());
            (0..3).map(|i| (place[i] - rough[i]).norm2()).sum()
        };
        let current = choices.iter().find(|c| c.is_current).map(miss);
        let minimum = choices.iter().map(miss).fold(f64::INFINITY, f64::min);
        assert!(
            current.is_some_and(|c| c <= minimum * (1.0 + 1e-9)),
            "{triad:?} {rough:?}"
        );
    }
}

/// Hard case H18 (upper limit 322.497 deg, lower 47.938), opened at decreasing distances to its
/// limit.
#[test]
fn h18_coupled_group_opens_close_to_limit() {
    let text = include_str!("../../presets/stephenson-six-bar.toml");
    let text = text
        .replace("length = 30 }", "length = 90 }")
        .replace("length = 190 }", "length = 230 }");
    let low = 47.937_702_396_774_27;
    for digits in 1..=9 {
        let angle = low + 0.1_f64.powi(digits);
        let text = text
            .replace("angle = 60", &format!("angle = {angle:?}"))
            .replace("E = [119, 255]", "E = [140, 250]");
        let scene = krank::scene::Scene::parse(&text, "h18").unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let krank::solver::Range::Limited { low: found, .. } = solver.motion().range else {
            panic!("the crank cannot turn fully");
        };
        assert!((found - low).abs() < 1e-9, "{digits}: {found}");
        // The two assemblies that meet at the limit are separate up to there.
        let group = coupled(&solver);
        let choices = solver.choices(angle, group);
        assert!(
            choices.len() >= 2 && choices.len().is_multiple_of(2),
            "{digits}: {}",
            choices.len()
        );
    }
}

/// Returns the choices of the first coupled group at a coordinate, with their positions.
fn choices(solver: &Solver, at: f64, point: PointId) -> Vec<(bool, Vec2)> {
    let mut groups = solver.plan().numbered();
    let coupled = groups.find(|(_, group)| group.kind.unknowns().is_some());
    let choices = solver.choices(at, coupled.unwrap().0);
    let listed = choices.iter().map(|choice| {
        let position = choice.state.position(point).unwrap();
        (choice.is_current, position)
    });
    listed.collect()
}

fn opened(text: &str) -> (krank::scene::Scene, Solver) {
    let scene = krank::scene::Scene::parse(text, "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    (scene, solver)
}

fn point(scene: &krank::scene::Scene, name: &str) -> PointId {
    let mut points = scene.mechanism.point_ids();
    points.find(|&p| scene.point_name(p) == Some(name)).unwrap()
}

/// A chain of twelve ternary links: a search without a start misses the scene's own assembly.
#[test]
fn current_assembly_is_listed() {
    let (scene, solver) = opened(include_str!("coupled12.toml"));
    let listed = choices(&solver, 60.0, point(&scene, "P0"));
    let current: Vec<Vec2> = listed.iter().filter(|c| c.0).map(|c| c.1).collect();
    assert_eq!(current.len(), 1, "{listed:?}");
    assert!(
        (current[0] - Vec2::new(0.0, 200.0)).norm() < 1e-9,
        "{current:?}"
    );
}

/// Two assemblies of a triad meet where its motion ends: close to the end, the current one is
/// listed once.
#[test]
fn current_assembly_is_listed_once_near_another() {
    let (scene, solver) = opened(
        r#"
unit = "m"
[ground]
A = [0, 0]
G7 = [2.338, 0.618]
G8 = [3.562, -2.623]
[driver]
link = "r2"
angle = 32.97
[links]
r2 = { from = "A", to = "B", length = 0.861 }
r3 = { from = "B", to = "C", length = 0.604404 }
t = { from = "C", to = "P", length = 1.138, points = { Q = [1.117, 1.5] } }
r4 = { from = "P", to = "G7", length = 1.294682 }
r5 = { from = "Q", to = "G8", length = 2.671592 }
[start]
C = [1.318, 0.571]
P = [1.691769, -0.503868]
Q = [3.101657, 0.008632]
"#,
    );
    let (_, high) = solver.motion().range.ends();
    for by in [1e-3, 3e-12] {
        let listed = choices(&solver, high - by, point(&scene, "C"));
        let current = listed.iter().filter(|c| c.0).count();
        assert_eq!(current, 1, "{by:e} {listed:?}");
    }
}
