//! Tests worst cases where the tolerances reach an edge of assembly: no machine within the
//! tolerances exceeds them.

use krank::quantity::{Catalogue, Quantity};
use krank::scene::{Scene, presets};
use krank::solver::{Condition, Demand, Order, Range, Solver, Varied};
use krank::study::{ToleranceFigure, ToleranceStudy, WorstKind};
use krank::{Length, Tolerances};

/// Random numbers (SplitMix64).
struct Random(u64);

impl Random {
    fn even(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn from(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.even()
    }
}

/// A scene near an edge of assembly, with the columns, the coordinate, and the tolerance of each
/// length.
struct NearEdge {
    scene: Scene,
    columns: Vec<Quantity>,
    at: f64,
    tolerance: f64,
}

impl NearEdge {
    fn new(text: &str, columns: &[&str], at: f64, tolerance: f64) -> Option<NearEdge> {
        let scene = Scene::parse(text, "edge.toml").ok()?;
        let catalogue = Catalogue::new(&scene);
        let columns = columns.iter().map(|name| catalogue.find(name));
        let columns: Option<Vec<_>> = columns.collect();
        Some(NearEdge {
            columns: columns?,
            scene,
            at,
            tolerance,
        })
    }
}

const FOUR_BAR: [&str; 8] = [
    "C.x", "C.y", "r3.angle", "r4.angle", "C.vx", "r4.omega", "C.ay", "r4.alpha",
];

/// Returns the lengths of a dyad that is nearly extended or nearly folded: their sum or difference
/// is close to the distance.
fn arms(random: &mut Random, distance: f64, gap: f64) -> Option<[f64; 2]> {
    let rocker = distance * random.from(0.3, 1.6);
    let coupler = match random.even() < 0.5 {
        true => distance + gap - rocker,
        false => distance - gap + rocker,
    };
    (coupler > 0.3 * distance).then_some([coupler, rocker])
}

fn four_bar(random: &mut Random) -> Option<NearEdge> {
    let (frame, at) = (random.from(1.5, 4.0), random.from(0.0, 360.0));
    let tolerance = random.from(0.002, 0.12);
    let gap = tolerance * random.from(0.05, 5.0);
    let (sin, cos) = at.to_radians().sin_cos();
    let distance = (cos - frame).hypot(sin);
    let [coupler, rocker] = arms(random, distance, gap)?;
    // The circles about B and D intersect at x along the line from B to D, and at h from that line.
    let x = (distance * distance + coupler * coupler - rocker * rocker) / (2.0 * distance);
    let h = (coupler * coupler - x * x).max(0.0).sqrt();
    let [ux, uy] = [(frame - cos) / distance, -sin / distance];
    let c = [cos + x * ux - h * uy, sin + x * uy + h * ux];
    let text = format!(
        "unit = \"mm\"\n[ground]\nA = [0, 0]\nD = [{frame}, 0]\n[driver]\nlink = \"r2\"\nangle = {at}\n\
         speed = \"1 rad/s\"\n[links]\nr2 = {{ from = \"A\", to = \"B\", length = 1 }}\n\
         r3 = {{ from = \"B\", to = \"C\", length = {coupler} }}\n\
         r4 = {{ from = \"D\", to = \"C\", length = {rocker} }}\n[start]\nC = [{}, {}]\n",
        c[0], c[1]
    );
    NearEdge::new(&text, &FOUR_BAR, at, tolerance)
}

fn slider_crank(random: &mut Random) -> Option<NearEdge> {
    let (offset, at) = (random.from(0.0, 2.0), random.from(0.0, 360.0));
    let tolerance = random.from(0.002, 0.1);
    let gap = tolerance * random.from(0.05, 3.0);
    let (sin, cos) = at.to_radians().sin_cos();
    let rod = (sin - offset).abs() + gap;
    let side = (rod * rod - (sin - offset) * (sin - offset)).sqrt();
    let text = format!(
        "unit = \"mm\"\n[ground]\nA = [0, 0]\n[driver]\nlink = \"r2\"\nangle = {at}\nspeed = \"1 rad/s\"\n\
         [links]\nr2 = {{ from = \"A\", to = \"B\", length = 1 }}\n\
         r3 = {{ from = \"B\", to = \"C\", length = {rod} }}\n[slides]\n\
         s = {{ point = \"C\", on = \"ground\", through = [0, {offset}], angle = 0 }}\n\
         [start]\nC = [{}, {offset}]\n",
        cos + side
    );
    let columns = [
        "s.length", "r3.angle", "C.vx", "r3.omega", "C.ax", "r3.alpha",
    ];
    (rod > 0.3).then(|| NearEdge::new(&text, &columns, at, tolerance))?
}

/// Returns a four-bar with a toggle attached: bars C-E and E-G, nearly in line.
fn toggle(random: &mut Random) -> Option<NearEdge> {
    let at = random.from(0.0, 360.0);
    let tolerance = random.from(0.01, 0.3);
    let gap = tolerance * random.from(0.05, 6.0);
    let preset = presets::find("four-bar")?.text;
    let scene = Scene::parse(preset, "four-bar.toml").ok()?;
    let solver = Solver::new(&scene.mechanism).ok()?;
    let mut state = solver.state();
    if solver.solve(at, Order::Position, &mut state) != Condition::Ok {
        return None;
    }
    let mut points = scene.mechanism.point_ids();
    let c = state.position(points.find(|&p| scene.point_name(p) == Some("C"))?)?;
    let g = [random.from(300.0, 700.0), random.from(300.0, 600.0)];
    let way = [g[0] - c.x, g[1] - c.y];
    let distance = way[0].hypot(way[1]);
    let [near, far] = arms(random, distance, gap)?;
    let text = preset
        .replace("angle = 60", &format!("angle = {at}"))
        .replace(
            "D = [400, 0]",
            &format!("D = [400, 0]\nG = [{}, {}]", g[0], g[1]),
        )
        .replace(
            "[links]",
            &format!(
                "[links]\nr5 = {{ from = \"C\", to = \"E\", length = {near} }}\n\
                 r6 = {{ from = \"G\", to = \"E\", length = {far} }}"
            ),
        );
    // The scene must open on the preset's assembly at this angle.
    let start = text.find("[start]")?;
    let x = (distance * distance + near * near - far * far) / (2.0 * distance);
    let h = (near * near - x * x).max(0.0).sqrt();
    let [ux, uy] = way.map(|v| v / distance);
    let e = [c.x + x * ux - h * uy, c.y + x * uy + h * ux];
    let end = text[start..]
        .find("\n[")
        .map_or(text.len(), |end| start + end);
    let text = format!(
        "{}[start]\nC = [{}, {}]\nE = [{}, {}]\n{}",
        &text[..start],
        c.x,
        c.y,
        e[0],
        e[1],
        &text[end..]
    );
    let columns = ["E.x", "r5.angle", "r6.omega", "C.x", "r4.omega", "E.ay"];
    NearEdge::new(&text, &columns, at, tolerance)
}

/// Returns a machine near an end of its range.
fn machine_near_end(
    text: &str,
    random: &mut Random,
    columns: &[&str],
    tolerances: [f64; 2],
) -> Option<NearEdge> {
    let scene = Scene::parse(text, "edge.toml").ok()?;
    let solver = Solver::new(&scene.mechanism).ok()?;
    let Range::Limited { low, high } = solver.motion().range else {
        return None;
    };
    let nearby = (high - low) * 10_f64.powf(random.from(-4.0, -1.5));
    let at = match random.even() < 0.5 {
        true => low + nearby,
        false => high - nearby,
    };
    let [minimum, maximum] = tolerances;
    NearEdge::new(text, columns, at, random.from(minimum, maximum))
}

/// Returns a preset with a limited range, made of dyads or with a cylinder, near an end of its
/// range.
fn limited_preset(random: &mut Random) -> Option<NearEdge> {
    let all: [(&str, &[&str], f64); 3] = [
        (
            "double-rocker",
            &["C.x", "r4.angle", "r4.omega", "C.ay"],
            1.0,
        ),
        (
            "excavator-boom",
            &["boom.angle", "boom.omega", "boom.alpha"],
            1e-3,
        ),
        ("backhoe", &["bucket.angle", "bucket.omega"], 1e-3),
    ];
    let (name, columns, size) = all[(random.even() * 3.0) as usize];
    let text = presets::find(name)?.text;
    machine_near_end(text, random, columns, [0.05 * size, size])
}

/// Returns Stephenson's coupled group with a longer crank, which has dead points.
fn coupled(random: &mut Random) -> Option<NearEdge> {
    let crank = random.from(60.0, 120.0);
    let text = presets::find("stephenson-six-bar")?
        .text
        .replace("length = 30 }", &format!("length = {crank} }}"))
        .replace("\nE = [119, 255]", "");
    let columns = ["E.x", "r4.angle", "r6.omega", "C.ay"];
    machine_near_end(&text, random, &columns, [0.05, 0.6])
}

/// Evaluates the columns of varied machines of a scene.
struct Maker {
    varied: Varied,
    columns: Vec<Quantity>,
    nominal: Vec<f64>,
    at: f64,
}

impl Maker {
    fn values(&mut self, by: &[f64]) -> Option<Vec<f64>> {
        self.varied.change(by);
        if self.varied.solve(self.at, Order::Acceleration) != Condition::Ok {
            return None;
        }
        let state = self.varied.state().state();
        let values = self.columns.iter().zip(&self.nominal);
        let values = values.map(|(column, nominal)| {
            let value: f64 = column.value(state)?;
            Some(match column.is_direction() {
                true => value - 360.0 * ((value - nominal) / 360.0).round(),
                false => value,
            })
        });
        values.collect()
    }

    /// Returns the last machine that closes on the line from the nominal machine to `to`.
    fn towards(&mut self, to: &[f64]) -> Vec<f64> {
        if self.values(to).is_some() {
            return to.to_vec();
        }
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..50 {
            let middle = f64::midpoint(low, high);
            let machine: Vec<f64> = to.iter().map(|by| by * middle).collect();
            match self.values(&machine).is_some() {
                true => low = middle,
                false => high = middle,
            }
        }
        to.iter().map(|by| by * low).collect()
    }

    /// Returns the extreme of a column that random steps reach, starting from the best of random
    /// machines at corners and at the edge.
    fn furthest(&mut self, random: &mut Random, column: usize, sign: f64, tolerance: f64) -> f64 {
        let count = self.varied.lengths();
        let mut best = vec![0.0; count];
        let mut value = self.nominal[column];
        for _ in 0..40 {
            let corner: Vec<f64> = (0..count)
                .map(|_| tolerance * random.from(-2.0, 2.0).clamp(-1.0, 1.0))
                .collect();
            let machine = self.towards(&corner);
            let found = self.values(&machine).map_or(f64::NAN, |all| all[column]);
            if sign * (found - value) > 0.0 {
                (best, value) = (machine, found);
            }
        }
        let mut step = 0.5;
        for _ in 0..200 {
            let moved = best.iter().map(|by| {
                let way = random.from(-1.0, 1.0).powi(3);
                (by + step * tolerance * way).clamp(-tolerance, tolerance)
            });
            let moved: Vec<f64> = moved.collect();
            let found = self.values(&moved).map_or(f64::NAN, |all| all[column]);
            match sign * (found - value) > 0.0 {
                true => {
                    (best, value) = (moved, found);
                    step = f64::min(1.0, step * 1.5);
                }
                false => step = f64::max(1e-7, step * 0.93),
            }
        }
        value
    }
}

/// Counts over many scenes.
#[derive(Debug, Default)]
struct Counts {
    values: usize,
    unbounded: usize,
    exceeded: Vec<String>,
}

impl Counts {
    fn check_machines(&mut self, near: &NearEdge, random: &mut Random) {
        let NearEdge {
            scene,
            columns,
            at,
            tolerance,
        } = near;
        let Ok(solver) = Solver::new(&scene.mechanism) else {
            return;
        };
        let lengths: Vec<Length> = scene.mechanism.lengths();
        let tolerances = Tolerances {
            lengths: lengths.iter().map(|&length| (length, *tolerance)).collect(),
            clearances: Vec::new(),
        };
        let Ok(mut study) = ToleranceStudy::new(scene, &solver, &tolerances, columns) else {
            return;
        };
        let found: Option<Vec<ToleranceFigure>> = study.at(*at).into_iter().collect();
        let Some(found) = found else { return };
        let mut maker = Maker {
            varied: solver
                .varied(&lengths, &Demand::of_motion(&scene.mechanism))
                .unwrap(),
            nominal: found.iter().map(|figure| figure.nominal).collect(),
            columns: columns.clone(),
            at: *at,
        };
        for (i, figure) in found.iter().enumerate() {
            let worst = figure.worst;
            for (sign, end, reached) in [
                (-1.0, worst.low, worst.reached[0]),
                (1.0, worst.high, worst.reached[1]),
            ] {
                self.values += 1;
                if end.is_infinite() {
                    self.unbounded += 1;
                    assert_eq!(worst.kind, WorstKind::Unbounded);
                    // A machine with a very large value was found.
                    let size = figure.nominal.abs().max(1e-3);
                    assert!(
                        sign * reached > 100.0 * size,
                        "{} {worst:?}",
                        columns[i].name
                    );
                    continue;
                }
                let extreme = maker.furthest(random, i, sign, *tolerance);
                let allowed = 1e-6 * (worst.reached[1] - worst.reached[0]) + 1e-9 * end.abs();
                if sign * (extreme - end) > allowed {
                    self.exceeded.push(format!(
                        "{} at {at} +-{tolerance} sign {sign}: {extreme} {worst:?} of {}",
                        columns[i].name, scene.name
                    ));
                }
            }
        }
    }
}

/// Draws a random machine near an edge; `None` if it does not assemble.
type Draw = fn(&mut Random) -> Option<NearEdge>;

/// No random machine near an edge of assembly exceeds the worst case.
#[test]
fn random_machines_near_an_edge_stay_within_worst_case() {
    let kinds: [(Draw, usize); 5] = [
        (four_bar, 16),
        (slider_crank, 12),
        (toggle, 6),
        (limited_preset, 4),
        (coupled, 4),
    ];
    let mut counts = Counts::default();
    let seeds: u64 = std::env::var("KRANK_SEEDS").map_or(1, |seeds| seeds.parse().unwrap());
    for seed in 1..=seeds {
        let mut random = Random(seed);
        for (make, scenes) in kinds {
            let mut left = scenes;
            for _ in 0..20 * scenes {
                if let Some(near) = make(&mut random).filter(|_| left > 0) {
                    counts.check_machines(&near, &mut random);
                    left -= 1;
                }
            }
        }
    }
    eprintln!("{} values, {} unbounded", counts.values, counts.unbounded);
    let exceeded = &counts.exceeded;
    assert!(exceeded.is_empty(), "{} {exceeded:#?}", exceeded.len());
    assert!(
        counts.values >= 300 && counts.unbounded >= 100,
        "{counts:?}"
    );
}

/// The lengths of a four-bar at 0.14 from a dead point, so that a machine within these tolerances
/// reaches it.
const TRIPLE_ROCKER: [f64; 4] = [2.8037, 1.0, 2.6665, 1.0686];

/// The acceleration of C is unbounded: a machine within the tolerances has 129781.
#[test]
fn rates_are_unbounded_if_tolerances_reach_a_dead_point() {
    let [frame, crank, coupler, rocker] = TRIPLE_ROCKER;
    let text = format!(
        "unit = \"mm\"\n[ground]\nA = [0, 0]\nD = [{frame}, 0]\n[driver]\nlink = \"r2\"\nangle = 0\n\
         speed = \"1 rad/s\"\n[links]\nr2 = {{ from = \"A\", to = \"B\", length = {crank} }}\n\
         r3 = {{ from = \"B\", to = \"C\", length = {coupler} }}\n\
         r4 = {{ from = \"D\", to = \"C\", length = {rocker} }}\n\
         [start]\nC = [3.5563147918168214, 0.7586019609376977]\n"
    );
    let near = NearEdge::new(&text, &["C.ax", "r4.omega", "r4.angle", "B.ax"], 0.0, 0.14).unwrap();
    let solver = Solver::new(&near.scene.mechanism).unwrap();
    let lengths = near.scene.mechanism.lengths().into_iter();
    let all = |by: f64| Tolerances {
        lengths: lengths.clone().map(|length| (length, by)).collect(),
        clearances: Vec::new(),
    };
    let study =
        |by: f64| ToleranceStudy::new(&near.scene, &solver, &all(by), &near.columns).unwrap();
    let found: Vec<_> = study(0.14)
        .at(0.0)
        .into_iter()
        .map(|f| f.unwrap().worst)
        .collect();
    for worst in &found[..2] {
        assert_eq!((worst.low, worst.high), (f64::NEG_INFINITY, f64::INFINITY));
        assert!(worst.reached[1] > 1e4 && worst.fails, "{worst:?}");
        assert_eq!(worst.kind, WorstKind::Unbounded);
    }
    assert!(found[2].low.is_finite() && found[2].high.is_finite());
    assert!((found[3].high + 0.86).abs() < 1e-12 && (found[3].low + 1.14).abs() < 1e-12);
    // With a tenth of the tolerance no machine comes to a dead point.
    let found = study(0.014).at(0.0).into_iter().map(|f| f.unwrap().worst);
    assert!(
        found
            .into_iter()
            .all(|worst| worst.low.is_finite() && !worst.fails)
    );
}
