//! Tests that every link and pin is in equilibrium: all presets with random loads, at random
//! positions of the motion.

use super::TestRng;
use crate::PointId;
use crate::quantity::{Catalogue, Quantity};
use crate::scene::{Scene, presets};
use crate::solver::testing::check_equilibrium;
use crate::solver::{Condition, Indeterminate, Order, Solver};

/// Returns a preset with a mass for every link, gravity, a force, a torque, springs and dampers.
fn loaded(text: &str, rng: &mut TestRng) -> String {
    let mut out = String::from("gravity = [1.5, -9.81]\n");
    let mut section = "";
    let (mut point, mut link) = (None, None);
    for line in text.lines().filter(|l| !l.starts_with("gravity")) {
        if line.starts_with('[') {
            section = line;
        }
        let is_link = section == "[links]" && line.trim_end().ends_with('}');
        if !is_link || line.contains("mass") {
            out += &format!("{line}\n");
            continue;
        }
        let name = line.split('=').next().unwrap_or_default().trim();
        link = Some(name.to_owned());
        point = Some(format!("{name}.com"));
        let open = line.trim_end().trim_end_matches('}');
        let com = if line.contains("com =") {
            String::new()
        } else {
            format!(
                "com = [{}, {}], ",
                rng.within(-1.0, 1.0),
                rng.within(-1.0, 1.0)
            )
        };
        let (mass, inertia) = (rng.within(0.1, 5.0), rng.within(0.01, 0.5));
        out += &format!("{open}, {com}mass = {mass}, inertia = {inertia} }}\n");
    }
    let mut number = || rng.within(-50.0, 50.0);
    if let (Some(point), Some(link)) = (point, link) {
        out += &format!(
            "[[loads]]\npoint = \"{point}\"\nforce = [{}, {}]\n",
            number(),
            number()
        );
        out += &format!("[[loads]]\nlink = \"{link}\"\ntorque = {}\n", number());
        out += &sprung(text, (&point, &link), &mut number);
    }
    out
}

/// Returns springs of every kind from a point to the ground, and from a link to the ground and to
/// another link.
fn sprung(text: &str, (point, link): (&str, &str), number: &mut impl FnMut() -> f64) -> String {
    let scene = Scene::parse(text, "preset").unwrap();
    let mechanism = &scene.mechanism;
    let own = mechanism.link_ids().find(|&id| scene.link_name(id) == link);
    let own: Vec<PointId> = own.map_or(Vec::new(), |id| {
        mechanism.link(id).members.iter().map(|m| m.point).collect()
    });
    let mut points = mechanism.point_ids();
    let fixed = points.find(|id| mechanism.point(*id).ground.is_some() && !own.contains(id));
    let Some(fixed) = fixed.and_then(|id| scene.point_name(id)) else {
        return String::new();
    };
    let mut out = String::new();
    let mut spring = |ends: String, rest: String| {
        out += &format!("[[springs]]\n{ends}\n{rest}\n");
    };
    let line = || format!("from = \"{fixed}\"\nto = \"{point}\"");
    let (a, b, c, d) = (number(), number(), number(), number());
    let size = f64::abs;
    let (stiff, length, damp) = (size(a), size(b), size(c));
    spring(
        line(),
        format!("stiffness = {stiff}\nlength = {length}\npreload = {d}\ndamping = {damp}"),
    );
    spring(
        line(),
        format!(
            "force = [[{length}, {a}], [{}, {d}]]\ndamping = {stiff}",
            length + 100.0
        ),
    );
    let turned = format!(
        "stiffness = {stiff}\nangle = {}\npreload = {d}\ndamping = {damp}",
        3.0 * b
    );
    spring(format!("link = \"{link}\""), turned.clone());
    if let Some(other) = mechanism.link_ids().next().map(|id| scene.link_name(id))
        && other != link
    {
        spring(format!("link = \"{link}\"\nto = \"{other}\""), turned);
    }
    out
}

/// Returns the ends of the motion.
fn ends(solver: &Solver) -> (f64, f64) {
    solver.motion().range.ends()
}

/// Checks random positions of a motion.
fn check(name: &str, solver: &Solver, rng: &mut TestRng) {
    let (low, high) = ends(solver);
    let coordinates: Vec<f64> = (0..20).map(|_| rng.within(low, high)).collect();
    let checked = check_equilibrium(solver, coordinates.into_iter());
    assert!(checked > 5, "{name}: only {checked} states were ordinary");
}

#[test]
fn presets_are_in_equilibrium_under_random_loads() {
    let mut rng = TestRng::new(7);
    for preset in presets::all() {
        let text = loaded(preset.text, &mut rng);
        let scene = Scene::parse(&text, preset.name).unwrap_or_else(|e| panic!("{e}\n{text}"));
        let solver = Solver::new(&scene.mechanism).unwrap();
        check(preset.name, &solver, &mut rng);
    }
}

/// Every length is changed by up to a twentieth of the longest; mechanisms that no longer assemble
/// are skipped.
#[test]
fn linkages_with_random_lengths_are_in_equilibrium() {
    let mut rng = TestRng::new(8);
    let mut opened = 0;
    for preset in presets::all().iter().cycle().take(200) {
        let text = loaded(preset.text, &mut rng);
        let mut scene = Scene::parse(&text, preset.name).unwrap();
        let off = 0.05 * Solver::new(&scene.mechanism).unwrap().scale();
        for length in scene.mechanism.lengths() {
            let by = rng.within(-off, off);
            scene.mechanism = scene.mechanism.changed(length, by);
        }
        if let Ok(solver) = Solver::new(&scene.mechanism) {
            opened += 1;
            check(preset.name, &solver, &mut rng);
        }
    }
    assert!(opened > 60, "only {opened} of 200 could be assembled");
}

/// Combinations of guides, locks and coupled groups that occur in no preset.
const RARE: [(&str, &str); 10] = [
    (
        "arms that go over locked links, to a rocker",
        r#"
[ground]
A = [0, 0]
D = [400, 0]
[driver]
link = "r2"
angle = 60
speed = "10 rad/s"
[links]
r2 = { from = "A", to = "B", length = 100 }
r3 = { points = { B = [0, 0], X = [100, 0] } }
u = { points = { W = [80, 30] } }
v = { points = { X = [-40, -60], C = [160, -40] } }
r4 = { from = "D", to = "C", length = 250 }
[slides]
s1 = { link = "u", on = "r3", through = [10, 30], angle = 20, turn = -20 }
s2 = { link = "v", on = "u", through = [30, 15], angle = 70, turn = -70 }
[start]
C = [310, 230]
"#,
    ),
    (
        "and to a guide",
        r#"
[ground]
A = [0, 0]
[driver]
link = "r2"
angle = 60
speed = "10 rad/s"
acceleration = "5 rad/s^2"
[links]
r2 = { from = "A", to = "B", length = 100 }
r3 = { points = { B = [0, 0], X = [100, 0] } }
u = { points = { W = [80, 30] } }
v = { points = { X = [-40, -60], C = [160, -40] } }
[slides]
s1 = { link = "u", on = "r3", through = [10, 30], angle = 20, turn = -20 }
s2 = { link = "v", on = "u", through = [30, 15], angle = 70, turn = -70 }
s3 = { point = "C", on = "ground", through = [0, 20], angle = 5 }
[start]
C = [310, 40]
"#,
    ),
    (
        "and to an arm that they slide on",
        r#"
[ground]
A = [0, 0]
O = [0, -150]
[driver]
link = "crank"
angle = 40
speed = "10 rad/s"
acceleration = "3 rad/s^2"
[links]
crank = { from = "A", to = "B", length = 60 }
arm = { points = { O = [0, 0], E = [260, 30] } }
block = { points = { X = [12, 8] } }
plate = { points = { X = [0, 0], B = [30, 10] } }
w = { points = { W = [7, 9] } }
[slides]
s = { link = "block", on = "arm", through = [50, 17], angle = 7, turn = 33 }
s2 = { link = "w", on = "block", through = [50, 17], angle = 17, turn = 13 }
s3 = { link = "w", on = "plate", through = [5, 60], angle = 80, turn = -20 }
[start]
E = [94, 94]
"#,
    ),
    (
        "a coupled group with a slot",
        r#"
[ground]
A = [0, 0]
D = [300, 0]
[driver]
link = "r2"
angle = 50
speed = "3 rad/s"
[links]
r2 = { from = "A", to = "B", length = 40 }
r3 = { from = "B", to = "P", length = 180 }
plate = { points = { P = [0, 0], Q = [120, 10], R = [20, 80] } }
r4 = { from = "D", to = "Q", length = 220 }
[slides]
s = { point = "R", on = "ground", through = [0, 260], angle = 10 }
[start]
P = [100, 198]
Q = [220, 208]
R = [120, 281]
"#,
    ),
    (
        "a coupled group that is pushed",
        r#"
[ground]
A = [0, 0]
D = [300, 0]
O = [150, -100]
[driver]
slide = "cyl"
position = 290
speed = "20 mm/s"
[links]
r3 = { from = "A", to = "P", length = 150 }
plate = { points = { P = [0, 0], Q = [160, 0], R = [80, 60] } }
r4 = { from = "D", to = "Q", length = 150 }
barrel = { points = { O = [0, 0], N = [40, 9] } }
[slides]
cyl = { point = "R", on = "barrel", through = "O", angle = 3 }
[start]
P = [51, 141]
Q = [209, 120]
R = [138, 190]
"#,
    ),
    (
        "locks on locks on the crank",
        r#"
[ground]
A = [0, 0]
[driver]
link = "r2"
angle = 40
speed = "2 rad/s"
[links]
r2 = { from = "A", to = "B", length = 50 }
k = { points = { K = [0, 0], P = [10, 25] } }
m = { points = { M = [0, 0], Q = [-12, 8] } }
[slides]
s1 = { link = "k", on = "r2", through = [5, 12], angle = 10, turn = 30 }
s2 = { point = "P", on = "ground", through = [0, 120], angle = 5 }
s3 = { link = "m", on = "k", through = [3, 4], angle = 70, turn = 45 }
s4 = { point = "Q", on = "ground", through = [0, 200], angle = -8 }
"#,
    ),
    (
        "a block that slides on an arm and is pinned beside its guide",
        r#"
[ground]
A = [0, 0]
O = [0, -120]
[driver]
link = "r2"
angle = 40
speed = "2 rad/s"
[links]
r2 = { from = "A", to = "B", length = 50 }
k = { points = { K = [0, 0], B = [10, 25] } }
arm = { points = { O = [0, 0], T = [250, 0] } }
[slides]
s = { link = "k", on = "arm", through = [0, 15], angle = 5, turn = 20 }
[start]
T = [60, 120]
"#,
    ),
    (
        "guides on a rocker, beside its joints",
        r#"
[ground]
A = [0, 0]
D = [400, 0]
[driver]
link = "r2"
angle = 60
speed = "2 rad/s"
[links]
r2 = { from = "A", to = "B", length = 100 }
r3 = { from = "B", to = "C", length = 300, points = { E = [120, 60] } }
r4 = { from = "D", to = "C", length = 250 }
r5 = { from = "E", to = "F", length = 270 }
sl = { points = { S = [0, 0], G = [15, -20] } }
r6 = { from = "B", to = "G", length = 260 }
[slides]
s5 = { point = "F", on = "r4", through = [10, 20], angle = 80 }
s6 = { link = "sl", on = "r4", through = [40, -30], angle = 20, turn = 60 }
[start]
C = [310, 230]
F = [250, 40]
G = [300, 20]
"#,
    ),
    (
        "a slide on a slide on the ground",
        r#"
[ground]
A = [0, 0]
[driver]
link = "r2"
angle = 60
speed = "2 rad/s"
[links]
r2 = { from = "A", to = "B", length = 60 }
r3 = { from = "B", to = "C", length = 200 }
ram = { points = { R = [0, 0], C = [20, 30] } }
tool = { points = { T = [0, 0], W = [5, -14] } }
r4 = { from = "B", to = "W", length = 235 }
[slides]
s1 = { link = "ram", on = "ground", through = [0, 10], angle = 4, turn = 15 }
s2 = { link = "tool", on = "ram", through = [30, 6], angle = 85, turn = -20 }
[start]
C = [225, 10]
W = [225, -60]
"#,
    ),
    (
        "a pushed slide on the ground, with a link that it does not turn",
        r#"
[ground]
D = [300, 40]
[driver]
slide = "s1"
position = 30
speed = "20 mm/s"
[links]
ram = { points = { R = [0, 0], P = [12, 18] } }
r3 = { from = "P", to = "C", length = 150 }
r4 = { from = "D", to = "C", length = 160 }
[slides]
s1 = { link = "ram", on = "ground", through = [5, -20], angle = 12, turn = 40 }
[start]
C = [180, 140]
"#,
    ),
];

/// Overconstrained linkages and their statically indeterminate reactions.
const REDUNDANT: [(&str, &str, &[&str]); 3] = [
    (
        "a trammel with a crank, which opens where one guide is not pressed",
        r#"
[ground]
O = [0, 0]
[driver]
link = "crank"
angle = 0
speed = "10 rad/s"
[links]
crank = { from = "O", to = "M", length = 100 }
rod = { points = { M = [0, 0], P = [100, 0], Q = [-100, 0], E = [150, 0] } }
[slides]
sx = { point = "P", on = "ground", through = "O", angle = 0 }
sy = { point = "Q", on = "ground", through = "O", angle = 90 }
[start]
P = [200, 0]
"#,
        &[
            "crank.O",
            "crank.M",
            "rod.M",
            "rod.P",
            "rod.Q",
            "sx.normal",
            "sy.normal",
        ],
    ),
    (
        "a ram with a pin in its own guide",
        r#"
[ground]
A = [0, 0]
[driver]
link = "r2"
angle = 60
speed = "10 rad/s"
[links]
r2 = { from = "A", to = "B", length = 60 }
r3 = { from = "B", to = "C", length = 250 }
ram = { points = { C = [0, 0], F = [100, 0], G = [100, 30] } }
[slides]
s1 = { link = "ram", on = "ground", through = [0, 0], angle = 0, turn = 0 }
s2 = { point = "F", on = "ground", through = [0, 0], angle = 0 }
[start]
C = [260, 0]
F = [360, 0]
"#,
        &["ram.F", "s1.normal", "s1.moment", "s2.normal"],
    ),
    (
        "three links locked to each other in a ring",
        r#"
[ground]
A = [0, 0]
D = [400, 0]
[driver]
link = "r2"
angle = 60
speed = "10 rad/s"
[links]
r2 = { from = "A", to = "B", length = 100 }
r3 = { from = "B", to = "C", length = 300 }
r4 = { from = "D", to = "C", length = 250 }
u = { points = { U = [0, 0], W = [80, 30] } }
v = { points = { V = [0, 0], Z = [16, -40] } }
r5 = { from = "D", to = "Z", length = 270 }
[slides]
s1 = { link = "u", on = "r3", through = [10, 30], angle = 20, turn = -20 }
s2 = { link = "v", on = "u", through = [30, 15], angle = 70, turn = -70 }
s3 = { link = "v", on = "r3", through = [0, 115], angle = -12, turn = 12 }
[start]
C = [310, 230]
Z = [200, 200]
"#,
        &["s1.moment", "s2.moment", "s3.moment"],
    ),
];

/// The expected reactions follow from the self-stresses, computed by hand.
#[test]
fn only_reactions_of_redundant_constraints_are_indeterminate() {
    let mut rng = TestRng::new(11);
    for (name, text, open) in REDUNDANT {
        let text = loaded(text, &mut rng);
        let scene = Scene::parse(&text, name).unwrap_or_else(|e| panic!("{e}\n{text}"));
        let solver = Solver::new(&scene.mechanism).unwrap();
        let named = solver.indeterminate().iter().map(|open| match *open {
            Indeterminate::Joint(link, point) => {
                let point = scene.point_name(point).unwrap_or("?");
                format!("{}.{point}", scene.link_name(link))
            }
            Indeterminate::Normal(slide) => format!("{}.normal", scene.slide_name(slide)),
            Indeterminate::Moment(slide) => format!("{}.moment", scene.slide_name(slide)),
        });
        let named: Vec<String> = named.collect();
        assert_eq!(named, open, "{name}");
        check(name, &solver, &mut rng);
    }
}

#[test]
fn rare_guides_and_locks_are_in_equilibrium() {
    let mut rng = TestRng::new(10);
    for (name, text) in RARE {
        let text = loaded(text, &mut rng);
        let scene = Scene::parse(&text, name).unwrap_or_else(|e| panic!("{e}\n{text}"));
        let solver = Solver::new(&scene.mechanism);
        let solver = solver.unwrap_or_else(|e| panic!("{name}: {}", scene.explain(&e)));
        check(name, &solver, &mut rng);
    }
}

/// Compares with a solution in twice the precision.
#[test]
fn force_error_never_exceeds_its_bound() {
    let mut rng = TestRng::new(9);
    let presets = presets::all().iter().map(|p| (p.name, p.text));
    for (name, text) in presets.chain(RARE) {
        let text = loaded(text, &mut rng);
        let scene = Scene::parse(&text, name).unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let figures = Catalogue::new(&scene);
        let is_force = |q: &&Quantity| q.order() == Order::Force;
        let figures: Vec<&Quantity> = figures.all().iter().filter(is_force).collect();
        let (mut state, mut balls) = (solver.state(), solver.enclosure());
        let mut truth = solver.twice();
        let (low, high) = ends(&solver);
        let (mut proved, mut unproved, mut over) = (0, 0, Vec::new());
        for _ in 0..40 {
            let at = rng.within(low, high);
            if solver.solve(at, Order::Force, &mut state) != Condition::Ok
                || !solver.solve_twice(&state, Order::Force, &mut truth)
            {
                continue;
            }
            solver.enclose(&mut state, Order::Force, &mut balls);
            for figure in &figures {
                let Some(value) = figure.value(&state) else {
                    continue;
                };
                let exact = figure.value(&truth).unwrap();
                let miss = (exact - crate::Double::exactly(value)).abs().hi;
                let Some(bound) = figure.bound(&state, &balls) else {
                    unproved += 1;
                    continue;
                };
                proved += 1;
                let of = &figure.name;
                assert!(miss <= bound, "{name} at {at}: {of} {miss:e} > {bound:e}");
                if miss > 0.0 {
                    over.push(bound / miss);
                }
            }
        }
        over.sort_by(f64::total_cmp);
        let median = over[over.len() / 2];
        // A bound is also not much larger than the error, except after a long chain, which widens
        // the input of each group.
        let is_long = solver.plan().groups.len() > 8;
        assert!(is_long || median < 1e3, "{name}: {median} times the error");
        assert!(unproved * 10 < proved, "{}: {unproved} of {proved}", name);
    }
}
