//! A general solver and a closed form of the same mechanism: what both yield, the ways to run them,
//! and that they agree.

use crate::handwritten::{FourBar, Jansen, Joint, Press, SliderCrank, Turning};
use krank::scene::{Scene, presets};
use krank::solver::{Condition, Demand, Order, Solver, State, Workspace};
use krank::{Ball, LANES, Lanes, LinkId, PointId, Vec2, vectorized};
use std::hint::black_box;

/// How far solver and closed form may be apart, relative to the largest figure of the kind.
const MAX_DIFFERENCE: f64 = 1e-9;
/// Positions in one sweep: as many for every lane.
pub(crate) const SWEEP: usize = 360;
const _: () = assert!(SWEEP.is_multiple_of(LANES));
/// What both sides yield: points and links.
pub(crate) type Figures<const P: usize, const L: usize> = ([Joint; P], [Turning; L]);

/// The same of several states: position, velocity and acceleration; omega and alpha.
pub(crate) type LaneFigures<const P: usize, const L: usize> =
    ([[Vec2<Lanes>; 3]; P], [[Lanes; 2]; L]);

fn no_figures<const P: usize, const L: usize>() -> LaneFigures<P, L> {
    ([Default::default(); P], [Default::default(); L])
}

/// A preset made ready to yield what a closed form yields.
pub(crate) struct General<const P: usize, const L: usize> {
    pub(crate) solver: Solver,
    points: [PointId; P],
    links: [LinkId; L],
}

impl<const P: usize, const L: usize> General<P, L> {
    fn new(preset: &str, points: [&str; P], links: [&str; L]) -> Self {
        let scene = scene(preset);
        let mechanism = &scene.mechanism;
        let point = |name| {
            let mut ids = mechanism.point_ids();
            ids.find(|&id| scene.point_name(id) == Some(name))
                .expect("a point of the preset")
        };
        let link = |name| {
            let mut ids = mechanism.link_ids();
            ids.find(|&id| scene.link_name(id) == name)
                .expect("a link of the preset")
        };
        let (points, links) = (points.map(point), links.map(link));
        let demand = Demand {
            points: points.to_vec(),
            links: links.to_vec(),
            ..Demand::default()
        };
        General {
            solver: Solver::new(mechanism)
                .expect("a preset opens")
                .only(&demand),
            points,
            links,
        }
    }

    #[inline]
    fn read(&self, state: &State) -> Figures<P, L> {
        let joint = |id| Joint {
            p: state.position(id).expect("solved"),
            v: state.velocity(id).expect("solved"),
            a: state.acceleration(id).expect("solved"),
        };
        let turning = |id| Turning {
            omega: state.omega(id).expect("solved"),
            alpha: state.alpha(id).expect("solved"),
        };
        (self.points.map(joint), self.links.map(turning))
    }

    #[inline(always)]
    fn read_lanes(&self, state: &State<Lanes>, (joints, links): &mut LaneFigures<P, L>) {
        for (joint, &id) in joints.iter_mut().zip(&self.points) {
            let (p, v, a) = (
                state.position(id).expect("solved"),
                state.velocity(id).expect("solved"),
                state.acceleration(id).expect("solved"),
            );
            *joint = [p, v, a];
        }
        for (turning, &id) in links.iter_mut().zip(&self.links) {
            *turning = [
                state.omega(id).expect("solved"),
                state.alpha(id).expect("solved"),
            ];
        }
    }

    /// Solves at all angles, several at once, without reading anything.
    pub(crate) fn sweep_in_lanes(&self, angles: &[f64], state: &mut Workspace<Lanes>) {
        for &at in angles.as_chunks().0 {
            let solved = self
                .solver
                .solve_lanes(black_box(at), Order::Acceleration, state);
            assert!(solved);
            black_box(&*state);
        }
    }

    /// Solves at all angles, several at once, and reads everything.
    pub(crate) fn sweep_in_lanes_and_read(&self, angles: &[f64], state: &mut Workspace<Lanes>) {
        let mut figures = no_figures();
        for &at in angles.as_chunks().0 {
            let solved = self
                .solver
                .solve_lanes(black_box(at), Order::Acceleration, state);
            assert!(solved);
            vectorized(
                #[inline(always)]
                || self.read_lanes(state, &mut figures),
            );
            black_box(&figures);
        }
    }

    /// Solves at all angles, each with its bounds.
    pub(crate) fn sweep_with_bounds(
        &self,
        angles: &[f64],
        state: &mut Workspace,
        enclosure: &mut Workspace<Ball>,
    ) {
        for &at in angles {
            let _ = self.solver.solve(black_box(at), Order::Acceleration, state);
            self.solver.enclose(state, Order::Acceleration, enclosure);
            black_box((&*state, &*enclosure));
        }
    }

    /// Solves at all angles, without reading anything.
    pub(crate) fn sweep(&self, angles: &[f64], state: &mut Workspace) {
        for &at in angles {
            let _ = self.solver.solve(black_box(at), Order::Acceleration, state);
            black_box(&*state);
        }
    }

    /// Solves at all angles and reads everything.
    pub(crate) fn sweep_and_read(&self, angles: &[f64], state: &mut Workspace) {
        for &at in angles {
            let _ = self.solver.solve(black_box(at), Order::Acceleration, state);
            black_box(&self.read(state));
        }
    }
}

fn scene(preset: &str) -> Scene {
    let preset = presets::find(preset).expect("a preset");
    Scene::parse(preset.text, preset.name).expect("a preset is a sound scene")
}

/// Angles over a turn, in whole steps but off the multiples of 90 degrees.
pub(crate) fn angles() -> Vec<f64> {
    let step = 360.0 / SWEEP as f64;
    (0..SWEEP).map(|k| (k as f64 + 0.37) * step).collect()
}

pub(crate) fn closed_form<const P: usize, const L: usize>(
    form: impl Fn(f64) -> Figures<P, L>,
    angles: &[f64],
) {
    for &at in angles {
        black_box(&form(black_box(at)));
    }
}

/// Holds both sides against each other at every angle.
fn compare_both<const P: usize, const L: usize>(
    name: &str,
    general: &General<P, L>,
    form: impl Fn(f64) -> Figures<P, L>,
) {
    let mut state = general.solver.state();
    let rows: Vec<_> = angles()
        .into_iter()
        .map(|at| {
            let condition = general.solver.solve(at, Order::Acceleration, &mut state);
            assert_eq!(condition, Condition::Ok, "{name} at {at}");
            (kinds(general.read(&state)), kinds(form(at)))
        })
        .collect();
    agree_in_lanes(name, general);
    for kind in 0..5 {
        let largest = rows
            .iter()
            .flat_map(|(_, hand)| &hand[kind])
            .fold(0.0_f64, |m, v| m.max(v.abs()));
        for (solved, hand) in &rows {
            for (a, b) in solved[kind].iter().zip(&hand[kind]) {
                assert!(
                    (a - b).abs() <= MAX_DIFFERENCE * largest,
                    "{name}: {a} by the solver, {b} by hand"
                );
            }
        }
    }
}

/// Solved at once or one by one: the same bits, in this very build.
fn agree_in_lanes<const P: usize, const L: usize>(name: &str, general: &General<P, L>) {
    let (mut state, mut lanes) = (general.solver.state(), general.solver.lanes());
    let mut figures = no_figures();
    for &at in angles().as_chunks().0 {
        let solved = general
            .solver
            .solve_lanes(at, Order::Acceleration, &mut lanes);
        assert!(solved, "{name} at {at:?}");
        general.read_lanes(&lanes, &mut figures);
        let (joints, links) = figures;
        for (lane, at) in at.into_iter().enumerate() {
            let _ = general.solver.solve(at, Order::Acceleration, &mut state);
            let here = |v: Vec2<Lanes>| v.map(|v| v.0[lane]);
            let joints = joints.map(|[p, v, a]| Joint {
                p: here(p),
                v: here(v),
                a: here(a),
            });
            let links = links.map(|[omega, alpha]| Turning {
                omega: omega.0[lane],
                alpha: alpha.0[lane],
            });
            let bits = |of| kinds(of).concat().into_iter().map(f64::to_bits);
            let same = bits((joints, links)).eq(bits(general.read(&state)));
            assert!(same, "{name} at {at}: lane {lane} is not what it is alone");
        }
    }
}

/// The figures by kind: positions, velocities, accelerations, omegas, alphas.
fn kinds<const P: usize, const L: usize>((joints, links): Figures<P, L>) -> [Vec<f64>; 5] {
    let flat = |of: fn(&Joint) -> Vec2| -> Vec<f64> {
        joints.iter().map(of).flat_map(|v| [v.x, v.y]).collect()
    };
    [
        flat(|j| j.p),
        flat(|j| j.v),
        flat(|j| j.a),
        links.iter().map(|t| t.omega).collect(),
        links.iter().map(|t| t.alpha).collect(),
    ]
}

/// What is done with each mechanism: the closed form inlined in each case, as it is and as lean as can be.
pub(crate) trait Visitor {
    fn visit<const P: usize, const L: usize>(
        &mut self,
        name: &str,
        general: &General<P, L>,
        form: impl Fn(f64) -> Figures<P, L>,
        lean: impl Fn(f64) -> Figures<P, L>,
    );
}

pub(crate) fn visit_all(visitor: &mut impl Visitor) {
    let four_bar = FourBar::new();
    let general = General::new("four-bar", ["B", "C"], ["r3", "r4"]);
    visitor.visit(
        "four-bar",
        &general,
        |at| four_bar.solve::<false>(at),
        |at| four_bar.solve::<true>(at),
    );

    let slider_crank = SliderCrank;
    let general = General::new("slider-crank", ["B", "C"], ["r3"]);
    visitor.visit(
        "slider-crank",
        &general,
        |at| slider_crank.solve::<false>(at),
        |at| slider_crank.solve::<true>(at),
    );

    let press = Press::new();
    let general = General::new("press", ["B", "C", "E", "F"], ["r3", "r4", "r5", "r6"]);
    visitor.visit(
        "press",
        &general,
        |at| press.solve::<false>(at),
        |at| press.solve::<true>(at),
    );

    let legs = scene("jansen-leg").mechanism;
    let corner = |link: usize| legs.links()[link].members[2].local;
    let jansen = Jansen::new(corner(2), corner(6));
    let general = General::new(
        "jansen-leg",
        ["M", "X", "W", "Y", "V", "T"],
        ["j", "bde", "k", "c", "f", "ghi"],
    );
    visitor.visit(
        "jansen-leg",
        &general,
        |at| jansen.solve::<false>(at),
        |at| jansen.solve::<true>(at),
    );
}

pub(crate) struct Agreement;

impl Visitor for Agreement {
    fn visit<const P: usize, const L: usize>(
        &mut self,
        name: &str,
        general: &General<P, L>,
        form: impl Fn(f64) -> Figures<P, L>,
        lean: impl Fn(f64) -> Figures<P, L>,
    ) {
        compare_both(name, general, form);
        compare_both(name, general, lean);
    }
}
