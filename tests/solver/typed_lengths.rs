//! Bounds of machines with typed lengths, compared with their true errors.
//!
//! The true values are computed independently of the solver. The typed decimals are parsed here in
//! double-double, and the constraints are solved by Newton's method in point coordinates.
//! `KRANK_TYPED=100000 cargo test --release --test solver typed_lengths -- --nocapture` prints, for
//! as many values of each kind, the median ratio of bound to error.
#![allow(clippy::print_stdout, reason = "the overestimates are to be read")]

use crate::bounds::SplitMix;
use crate::exact::{DoubleDouble, PI};
use krank::quantity::{self, Aspect, Subject};
use krank::scene::Scene;
use krank::solver::{Condition, Order, Range, Solver, Workspace};
use krank::{Ball, Double, LinkId, PointId, SlideId, Vec2};
use std::fmt::Write as _;

type Place = Vec2<Double>;

/// A number as typed.
#[derive(Clone, Debug)]
struct Typed {
    text: String,
    value: Double,
}

impl Typed {
    fn of(text: String) -> Typed {
        let DoubleDouble { hi, lo } = DoubleDouble::parse(&text).expect("a decimal");
        let value = Double { hi, lo };
        Typed { text, value }
    }

    /// Draws a number between two limits with `digits` digits, and appends a tail beyond the digits
    /// of a double.
    fn within(rng: &mut SplitMix, low: f64, high: f64, digits: i32, tail: &str) -> Typed {
        let value = rng.within(low, high);
        let places = digits - 1 - value.abs().log10().floor() as i32;
        let places = usize::try_from(places).unwrap_or(0);
        Typed::of(format!("{value:.places$}{tail}"))
    }

    fn nearest(&self) -> f64 {
        self.value.hi
    }
}

/// A constraint, by the numbers of the points.
enum Row {
    Distance(usize, usize, Double),
    /// A line of the ground: a point on it and its normal.
    Line(usize, Place, Place),
    /// A point on a link from the second to the third point, with its local coordinates and the
    /// link's length.
    Carried([usize; 3], Place, Double),
}

/// A machine as text, and as constraints.
#[derive(Default)]
struct Machine {
    text: String,
    names: Vec<&'static str>,
    /// The positions of the fixed points; `None` for a moving point.
    ground: Vec<Option<Place>>,
    /// The links in the order of the scene: from point and to point.
    links: Vec<[usize; 2]>,
    rows: Vec<Row>,
    /// The crank's pivot, pin and length, and the driver's speed and acceleration.
    crank: [usize; 2],
    radius: Double,
    speed: Double,
    acceleration: Double,
    slides: Vec<(usize, Place, Place)>,
}

/// The format of a machine's numbers.
#[derive(Clone, Copy)]
struct Style {
    digits: i32,
    tail: &'static str,
    /// The distance of the ground from the origin.
    far: f64,
    rpm: bool,
}

impl Machine {
    fn new(rng: &mut SplitMix, style: Style) -> Machine {
        let mut machine = Machine::default();
        let speed = Typed::within(rng, 1.0, 90.0, 3, "");
        let (unit, factor) = if style.rpm {
            let DoubleDouble { hi, lo } = PI;
            ("rpm", Double { hi, lo } / Double::exactly(30.0))
        } else {
            ("rad/s", Double::ONE)
        };
        machine.speed = speed.value * factor;
        let acceleration = Typed::within(rng, 1.0, 9.0, 2, "");
        machine.acceleration = acceleration.value;
        let _ = write!(
            machine.text,
            "unit = \"mm\"\n[driver]\nlink = \"r2\"\nangle = 60\nspeed = \"{} {unit}\"\nacceleration = \"{} rad/s^2\"\n",
            speed.text, acceleration.text
        );
        machine
    }

    fn point(&mut self, name: &'static str, ground: Option<Place>) -> usize {
        self.names.push(name);
        self.ground.push(ground);
        self.names.len() - 1
    }

    fn grounds(&mut self, rng: &mut SplitMix, style: Style, places: &[(&'static str, f64, f64)]) {
        self.text.push_str("[ground]\n");
        for (i, &(name, x, y)) in places.iter().enumerate() {
            let mut number = |v: f64, size: f64| {
                if style.far == 0.0 && (i == 0 || v == 0.0) {
                    Typed::of("0".to_owned())
                } else {
                    let (low, high) = (v + style.far, v + style.far + 0.3 * size);
                    Typed::within(rng, low, high, style.digits, style.tail)
                }
            };
            let (x, y) = (number(x, 200.0), number(y, 200.0));
            let _ = writeln!(self.text, "{name} = [{}, {}]", x.text, y.text);
            self.point(name, Some(Vec2::new(x.value, y.value)));
        }
        self.text.push_str("[links]\n");
    }

    /// Adds a link, and a point on it by its position in the link's frame.
    fn link(
        &mut self,
        name: &str,
        [from, to]: [usize; 2],
        length: &Typed,
        carried: Option<(usize, [Typed; 2])>,
    ) {
        let _ = write!(
            self.text,
            "{name} = {{ from = \"{}\", to = \"{}\", length = {}",
            self.names[from], self.names[to], length.text
        );
        self.links.push([from, to]);
        if self.links.len() == 1 {
            (self.crank, self.radius) = ([from, to], length.value);
        } else {
            self.rows.push(Row::Distance(from, to, length.value));
        }
        if let Some((point, [x, y])) = carried {
            let _ = write!(
                self.text,
                ", points = {{ {} = [{}, {}] }}",
                self.names[point], x.text, y.text
            );
            let local = Vec2::new(x.value, y.value);
            self.rows
                .push(Row::Carried([point, from, to], local, length.value));
        }
        self.text.push_str(" }\n");
    }

    fn starts(&mut self, places: &[(usize, f64, f64)]) {
        self.text.push_str("[start]\n");
        for &(point, x, y) in places {
            let _ = writeln!(self.text, "{} = [{x:.1}, {y:.1}]", self.names[point]);
        }
    }

    fn base(&self) -> Vec2 {
        self.ground[0].map_or(Vec2::ZERO, |v| v.map(|v| v.hi))
    }
}

fn four_bar(rng: &mut SplitMix, style: Style) -> Machine {
    let mut m = Machine::new(rng, style);
    let level = if rng.unit() < 0.5 { 0.0 } else { 30.0 };
    m.grounds(rng, style, &[("A", 0.0, 0.0), ("D", 200.0, level)]);
    let [b, c, e] = ["B", "C", "E"].map(|name| m.point(name, None));
    let mut length = |low, high| Typed::within(rng, low, high, style.digits, style.tail);
    let (r2, r3, r4) = (
        length(40.0, 150.0),
        length(120.0, 300.0),
        length(100.0, 280.0),
    );
    let on = [length(20.0, 200.0), length(10.0, 120.0)];
    m.link("r2", [0, b], &r2, None);
    m.link("r3", [b, c], &r3, Some((e, on)));
    m.link("r4", [1, c], &r4, None);
    let at = m.base();
    m.starts(&[(c, at.x + 150.0, at.y + 150.0)]);
    m
}

fn slider_crank(rng: &mut SplitMix, style: Style) -> Machine {
    let mut m = Machine::new(rng, style);
    m.grounds(rng, style, &[("A", 0.0, 0.0)]);
    let [b, c, e] = ["B", "C", "E"].map(|name| m.point(name, None));
    let at = m.base();
    let mut length = |low, high| Typed::within(rng, low, high, style.digits, style.tail);
    let (r2, r3) = (length(40.0, 100.0), length(160.0, 400.0));
    let on = [length(20.0, 200.0), length(10.0, 120.0)];
    let (x, y) = (
        length(at.x + 10.0, at.x + 300.0),
        length(at.y + 5.0, at.y + 50.0),
    );
    let angle = if rng.unit() < 0.5 {
        Typed::of("0".to_owned())
    } else {
        Typed::within(rng, 3.0, 40.0, 4, "")
    };
    m.link("r2", [0, b], &r2, None);
    m.link("r3", [b, c], &r3, Some((e, on)));
    let _ = writeln!(
        m.text,
        "[slides]\nr4 = {{ point = \"C\", on = \"ground\", through = [{}, {}], angle = {} }}",
        x.text, y.text, angle.text
    );
    let direction = direction(angle.value);
    let through = Vec2::new(x.value, y.value);
    m.rows.push(Row::Line(c, through, direction.perp()));
    m.slides.push((c, through, direction));
    m.starts(&[(c, at.x + 300.0, at.y + 20.0)]);
    m
}

/// Draws Watt's six-bar: the rocker of one four-bar drives another one.
fn six_bar(rng: &mut SplitMix, style: Style) -> Machine {
    let mut m = Machine::new(rng, style);
    let places = [("A", 0.0, 0.0), ("D", 200.0, 0.0), ("G", 300.0, -130.0)];
    m.grounds(rng, style, &places);
    let [b, c, e, f] = ["B", "C", "E", "F"].map(|name| m.point(name, None));
    let mut length = |low, high| Typed::within(rng, low, high, style.digits, style.tail);
    let (r2, r3, r4) = (
        length(50.0, 70.0),
        length(170.0, 200.0),
        length(140.0, 170.0),
    );
    let on = [length(-50.0, -30.0), length(-130.0, -110.0)];
    let (r5, r6) = (length(160.0, 190.0), length(140.0, 170.0));
    m.link("r2", [0, b], &r2, None);
    m.link("r3", [b, c], &r3, None);
    m.link("r4", [1, c], &r4, Some((e, on)));
    m.link("r5", [e, f], &r5, None);
    m.link("r6", [2, f], &r6, None);
    let at = m.base();
    m.starts(&[
        (c, at.x + 177.0, at.y + 156.0),
        (f, at.x + 450.0, at.y - 140.0),
    ]);
    m
}

/// Draws Stephenson's six-bar, driven such that its loops are coupled.
fn coupled(rng: &mut SplitMix, style: Style) -> Machine {
    let mut m = Machine::new(rng, style);
    let places = [("G", 0.0, 0.0), ("A", -100.0, -200.0), ("D", 100.0, -200.0)];
    m.grounds(rng, style, &places);
    let [f, e, b, c] = ["F", "E", "B", "C"].map(|name| m.point(name, None));
    let mut length = |low, high| Typed::within(rng, low, high, style.digits, style.tail);
    let (crank, rod) = (length(15.0, 30.0), length(80.0, 100.0));
    let (left, right, coupler) = (
        length(90.0, 110.0),
        length(120.0, 140.0),
        length(160.0, 190.0),
    );
    let on = [length(70.0, 90.0), length(20.0, 40.0)];
    m.link("r2", [0, f], &crank, None);
    m.link("r3", [f, e], &rod, None);
    m.link("r4", [1, b], &left, None);
    m.link("r5", [b, c], &coupler, Some((e, on)));
    m.link("r6", [2, c], &right, None);
    let at = m.base();
    m.starts(&[
        (b, at.x - 70.0, at.y - 105.0),
        (c, at.x + 110.0, at.y - 75.0),
        (e, at.x + 10.0, at.y - 70.0),
    ]);
    m
}

/// Returns the unit vector at an angle in degrees.
fn direction(degrees: Double) -> Place {
    let near = Double::unit(degrees.hi);
    near.turned(Vec2::new(Double::ONE, Double::exactly(degrees.lo) * RADIAN))
}

const RADIAN: Double = Double {
    hi: 0.017_453_292_519_943_295,
    lo: 2.948_652_270_870_168_7e-19,
};

/// A linear system in double-double, row by row.
struct System {
    n: usize,
    rows: Vec<Vec<Double>>,
}

impl System {
    /// Adds a vector to the coefficients of a moving point.
    fn add(row: &mut [Double], unknown: Option<usize>, v: Place) {
        if let Some(at) = unknown {
            row[2 * at] += v.x;
            row[2 * at + 1] += v.y;
        }
    }

    /// Solves for right-hand sides, by elimination with the largest pivot.
    fn solve(&self, right: &[Double]) -> Option<Vec<Double>> {
        let n = self.n;
        let mut rows: Vec<Vec<Double>> = self.rows.clone();
        for (row, &r) in rows.iter_mut().zip(right) {
            row.push(r);
        }
        for k in 0..n {
            let pivot =
                (k..n).max_by(|&i, &j| rows[i][k].hi.abs().total_cmp(&rows[j][k].hi.abs()))?;
            rows.swap(k, pivot);
            if rows[k][k].hi == 0.0 {
                return None;
            }
            for i in k + 1..n {
                let (above, below) = rows.split_at_mut(i);
                let (from, row) = (&above[k], &mut below[0]);
                let factor = row[k] / from[k];
                for (value, &other) in row.iter_mut().zip(from).skip(k) {
                    *value = *value - factor * other;
                }
            }
        }
        let mut x = vec![Double::ZERO; n];
        for k in (0..n).rev() {
            let known = rows[k][k + 1..n].iter().zip(&x[k + 1..]);
            let sum = known.fold(rows[k][n], |sum, (&a, &x)| sum - a * x);
            x[k] = sum / rows[k][k];
        }
        Some(x)
    }
}

/// The positions of all points, and their derivatives with respect to the crank's angle in radians.
struct Truth {
    p: Vec<Place>,
    v: Vec<Place>,
    a: Vec<Place>,
}

impl Machine {
    fn unknown(&self, point: usize) -> Option<usize> {
        let moves = |p: &usize| self.ground[*p].is_none() && *p != self.crank[1];
        moves(&point).then(|| (0..point).filter(moves).count())
    }

    /// Improves the points' positions in doubles to the true positions.
    fn truth(&self, at: Double, near: &[Vec2]) -> Option<Truth> {
        let count = self.names.len();
        let arm = direction(at).map(|v| v * self.radius);
        let zero = Vec2::new(Double::ZERO, Double::ZERO);
        let [pivot, pin] = self.crank;
        let mut p: Vec<Place> = (0..count)
            .map(|i| self.ground[i].unwrap_or(near[i].map(Double::exactly)))
            .collect();
        p[pin] = p[pivot] + arm;
        let (mut v, mut a) = (vec![zero; count], vec![zero; count]);
        (v[pin], a[pin]) = (arm.perp(), -arm);
        let mut last = f64::INFINITY;
        for _ in 0..8 {
            let (system, misses) = self.system(&p);
            let step = system.solve(&misses)?;
            let size = step.iter().fold(0.0, |m: f64, v| m.max(v.hi.abs()));
            for (i, p) in p.iter_mut().enumerate() {
                if let Some(k) = self.unknown(i) {
                    *p = *p - Vec2::new(step[2 * k], step[2 * k + 1]);
                }
            }
            if size >= last && size < 1e-22 {
                break;
            }
            last = size;
        }
        if last > 1e-18 {
            return None;
        }
        let (system, _) = self.system(&p);
        let write = |to: &mut Vec<Place>, found: Vec<Double>| {
            for (i, to) in to.iter_mut().enumerate() {
                if let Some(k) = self.unknown(i) {
                    *to = Vec2::new(found[2 * k], found[2 * k + 1]);
                }
            }
        };
        let first = system.solve(&self.rights(&p, &v, None))?;
        write(&mut v, first);
        let second = system.solve(&self.rights(&p, &a, Some(&v)))?;
        write(&mut a, second);
        Some(Truth { p, v, a })
    }

    /// Returns the gradients and the residuals of the rows.
    fn system(&self, p: &[Place]) -> (System, Vec<Double>) {
        let n = 2
            * (0..self.names.len())
                .filter(|&i| self.unknown(i).is_some())
                .count();
        let (mut rows, mut misses) = (Vec::new(), Vec::new());
        for row in &self.rows {
            let mut gradient = vec![Double::ZERO; n];
            match *row {
                Row::Distance(i, j, length) => {
                    let e = p[i] - p[j];
                    System::add(&mut gradient, self.unknown(i), e);
                    System::add(&mut gradient, self.unknown(j), -e);
                    misses.push((e.norm2() - length * length).scaled(0.5));
                }
                Row::Line(i, through, normal) => {
                    System::add(&mut gradient, self.unknown(i), normal);
                    misses.push(normal.dot(p[i] - through));
                }
                Row::Carried([i, from, to], local, length) => {
                    let m = local.map(|v| v / length);
                    let miss = (p[i] - p[from]) - (p[to] - p[from]).turned(m);
                    let mut second = gradient.clone();
                    let (x, y) = (
                        Vec2::new(Double::ONE, Double::ZERO),
                        Vec2::new(Double::ZERO, Double::ONE),
                    );
                    // M e has the rows (m.x, -m.y) and (m.y, m.x).
                    let rows_of = [Vec2::new(m.x, -m.y), Vec2::new(m.y, m.x)];
                    for (row, (unit, by)) in [&mut gradient, &mut second]
                        .into_iter()
                        .zip([x, y].into_iter().zip(rows_of))
                    {
                        System::add(row, self.unknown(i), unit);
                        System::add(row, self.unknown(from), by - unit);
                        System::add(row, self.unknown(to), -by);
                    }
                    misses.extend([miss.x, miss.y]);
                    rows.push(gradient);
                    gradient = second;
                }
            }
            rows.push(gradient);
        }
        (System { n, rows }, misses)
    }

    /// Returns the right-hand sides of the rates, with the rates of the driven points in `guided`;
    /// with the first rates, returns those of the second.
    fn rights(&self, p: &[Place], guided: &[Place], first: Option<&[Place]>) -> Vec<Double> {
        let mut rights = Vec::new();
        let known = |i: usize| {
            let zero = Vec2::new(Double::ZERO, Double::ZERO);
            if self.unknown(i).is_some() {
                zero
            } else {
                guided[i]
            }
        };
        for row in &self.rows {
            match *row {
                Row::Distance(i, j, _) => {
                    let e = p[i] - p[j];
                    let square = first.map_or(Double::ZERO, |v| (v[i] - v[j]).norm2());
                    rights.push(-(e.dot(known(i) - known(j)) + square));
                }
                Row::Line(i, _, normal) => rights.push(-normal.dot(known(i))),
                Row::Carried([i, from, to], local, length) => {
                    let m = local.map(|v| v / length);
                    let moved = (known(i) - known(from)) - (known(to) - known(from)).turned(m);
                    rights.extend([-moved.x, -moved.y]);
                }
            }
        }
        rights
    }
}

const KINDS: [&str; 6] = [
    "position",
    "angle",
    "velocity",
    "acceleration",
    "omega",
    "alpha",
];

fn kind(aspect: Aspect) -> usize {
    match aspect {
        Aspect::Angle => 1,
        Aspect::Vx | Aspect::Vy | Aspect::Rate => 2,
        Aspect::Ax | Aspect::Ay | Aspect::Accel => 3,
        Aspect::Omega => 4,
        Aspect::Alpha => 5,
        _ => 0,
    }
}

#[derive(Default)]
struct Tally {
    states: usize,
    values: usize,
    unproved: usize,
    over: [Vec<f64>; 6],
}

impl Tally {
    fn medians(&mut self, name: &str) -> [f64; 6] {
        let medians = self.over.each_mut().map(|over| {
            over.sort_by(f64::total_cmp);
            over.get(over.len() / 2).copied().unwrap_or(f64::NAN)
        });
        print!(
            "{name:34} {:6} states {:7} values, unproved {:5}; bound/error:",
            self.states, self.values, self.unproved
        );
        for (kind, median) in KINDS.iter().zip(medians) {
            print!(" {kind} {median:.2}");
        }
        println!();
        medians
    }

    fn note(
        &mut self,
        what: &str,
        kind: usize,
        value: Option<f64>,
        bound: Option<f64>,
        truth: Double,
    ) {
        let Some(value) = value else {
            return;
        };
        self.values += 1;
        let Some(bound) = bound else {
            self.unproved += 1;
            return;
        };
        let off = (truth - Double::exactly(value)).abs();
        let turn = if kind == 1 && off.hi > 180.0 {
            360.0
        } else {
            0.0
        };
        let error = (off - Double::exactly(turn)).hi.abs();
        // The reference's own error is below this.
        let proved = 1e-26 * (1.0 + truth.hi.abs());
        assert!(
            error <= bound + proved,
            "{what}: {value:?} is off by {error:e}, bound {bound:e}"
        );
        if error > 0.0 {
            self.over[kind].push(bound / error);
        }
    }
}

struct Run<'a> {
    machine: &'a Machine,
    scene: &'a Scene,
    state: &'a Workspace,
    enclosure: &'a Workspace<Ball>,
    tally: &'a mut Tally,
}

impl Run<'_> {
    fn note(&mut self, subject: Subject, aspect: Aspect, truth: Double) {
        let value = quantity::value(subject, aspect, self.state);
        let bound = quantity::bound(subject, aspect, self.state, self.enclosure);
        let what = format!(
            "{subject:?} {aspect:?} at {:?} of\n{}",
            self.state.at(),
            self.machine.text
        );
        self.tally.note(&what, kind(aspect), value, bound, truth);
    }

    fn check(&mut self, truth: &Truth) {
        let Machine {
            speed,
            acceleration,
            ..
        } = *self.machine;
        let velocity = |v: Double| v * speed;
        let second = |v: Double, a: Double| a * speed * speed + v * acceleration;
        for (id, i) in self.points() {
            if self.machine.ground[i].is_some() {
                continue;
            }
            let (p, v, a) = (truth.p[i], truth.v[i], truth.a[i]);
            let subject = Subject::Point(id);
            for (aspect, value) in [
                (Aspect::X, p.x),
                (Aspect::Y, p.y),
                (Aspect::Vx, velocity(v.x)),
                (Aspect::Vy, velocity(v.y)),
                (Aspect::Ax, second(v.x, a.x)),
                (Aspect::Ay, second(v.y, a.y)),
            ] {
                self.note(subject, aspect, value);
            }
        }
        for (k, &[from, to]) in self.machine.links.iter().enumerate() {
            if k == 0 {
                continue;
            }
            let e = truth.p[to] - truth.p[from];
            let square = e.norm2();
            let turn = |rates: &[Place]| e.cross(rates[to] - rates[from]) / square;
            let (w, a) = (turn(&truth.v), turn(&truth.a));
            let degrees = Double::degrees(e);
            let degrees = if degrees.hi < 0.0 {
                degrees + Double::exactly(360.0)
            } else {
                degrees
            };
            let subject = Subject::Link(self.link(k));
            for (aspect, value) in [
                (Aspect::Angle, degrees),
                (Aspect::Omega, velocity(w)),
                (Aspect::Alpha, second(w, a)),
            ] {
                self.note(subject, aspect, value);
            }
        }
        for (k, &(point, through, along)) in self.machine.slides.iter().enumerate() {
            let subject = Subject::Slide(self.slide(k));
            let [v, a] = [&truth.v, &truth.a].map(|rates| along.dot(rates[point]));
            for (aspect, value) in [
                (Aspect::Length, along.dot(truth.p[point] - through)),
                (Aspect::Rate, velocity(v)),
                (Aspect::Accel, second(v, a)),
            ] {
                self.note(subject, aspect, value);
            }
        }
    }

    fn points(&self) -> Vec<(PointId, usize)> {
        let index = |name: &str| self.machine.names.iter().position(|n| *n == name);
        let ids = self.scene.mechanism.point_ids();
        ids.filter_map(|id| Some((id, index(self.scene.point_name(id)?)?)))
            .collect()
    }

    fn link(&self, k: usize) -> LinkId {
        let name = format!("r{}", k + 2);
        let mut ids = self.scene.mechanism.link_ids();
        ids.find(|id| self.scene.link_name(*id) == name).unwrap()
    }

    fn slide(&self, k: usize) -> SlideId {
        self.scene.mechanism.slide_ids().nth(k).unwrap()
    }
}

/// Measures machines of a kind at several coordinates each, some of them close to an end of the
/// range.
fn measure(
    name: &str,
    make: fn(&mut SplitMix, Style) -> Machine,
    style: Style,
    (values, near_ends): (usize, bool),
) -> [f64; 6] {
    let (mut rng, mut tally) = (
        SplitMix::new(name.len() as u64 + u64::from(style.digits.unsigned_abs())),
        Tally::default(),
    );
    let mut tries = 0;
    while tally.values < values {
        tries += 1;
        assert!(tries < 100_000, "{name}: no machine closes");
        let machine = make(&mut rng, style);
        let scene = Scene::parse(&machine.text, "typed")
            .unwrap_or_else(|faults| panic!("{faults:?}\n{}", machine.text));
        let Ok(solver) = Solver::new(&scene.mechanism) else {
            continue;
        };
        let (low, high) = match solver.motion().range {
            Range::Full { period } => (0.0, period),
            Range::Limited { low, high } => (low, high),
        };
        let (mut state, mut enclosure) = (solver.state(), solver.enclosure());
        for k in 0..20 {
            let inwards = (high - low) * 10_f64.powf(rng.within(-13.0, -1.0));
            let at = match k % 3 {
                0 if near_ends => Typed::of(format!("{:.12}", low + inwards)),
                1 if near_ends => Typed::of(format!("{:.12}", high - inwards)),
                _ => Typed::of(format!("{:.3}", rng.within(low, high))),
            };
            let order = Order::Acceleration;
            if solver.solve(at.nearest(), order, &mut state) != Condition::Ok {
                continue;
            }
            solver.enclose(&mut state, order, &mut enclosure);
            let near: Vec<Vec2> = {
                let ids: Vec<PointId> = scene.mechanism.point_ids().collect();
                let place = |name: &str| {
                    let id = ids.iter().find(|id| scene.point_name(**id) == Some(name));
                    state.position(*id.unwrap()).unwrap()
                };
                machine.names.iter().map(|name| place(name)).collect()
            };
            let Some(truth) = machine.truth(at.value, &near) else {
                continue;
            };
            tally.states += 1;
            let mut run = Run {
                machine: &machine,
                scene: &scene,
                state: &state,
                enclosure: &enclosure,
                tally: &mut tally,
            };
            run.check(&truth);
        }
    }
    tally.medians(name)
}

/// Draws a machine of one kind.
type DrawMachine = fn(&mut SplitMix, Style) -> Machine;

const MACHINES: [(&str, DrawMachine); 4] = [
    ("four-bars", four_bar),
    ("slider-cranks", slider_crank),
    ("six-bars", six_bar),
    ("coupled six-bars", coupled),
];

/// Returns the number of values for each kind of machine.
fn count() -> usize {
    let count = std::env::var("KRANK_TYPED").ok();
    count.and_then(|count| count.parse().ok()).unwrap_or(10_000)
}

const PLAIN: Style = Style {
    digits: 9,
    tail: "",
    far: 0.0,
    rpm: false,
};

/// Maximum median ratio of bound to error, by [`KINDS`].
const MEDIANS: [f64; 6] = [1.5, 4.0, 3.0, 3.0, 3.0, 3.0];

fn assert_near(name: &str, medians: [f64; 6]) {
    let is_near = medians
        .iter()
        .zip(MEDIANS)
        .all(|(m, maximum)| *m <= maximum);
    assert!(is_near, "{name}: {medians:?}");
}

#[test]
fn bounds_of_typed_lengths_are_close_to_errors() {
    for digits in [5, 9, 12] {
        for (name, make) in MACHINES {
            let style = Style { digits, ..PLAIN };
            let name = format!("{name}, {digits} digits");
            assert_near(&name, measure(&name, make, style, (count(), false)));
        }
    }
}

#[test]
fn bounds_of_typed_lengths_are_close_at_ends_and_far_away() {
    for (name, make) in MACHINES {
        let style = Style { rpm: true, ..PLAIN };
        let near = format!("{name}, near ends, rpm");
        assert_near(&near, measure(&near, make, style, (count(), true)));
        let style = Style {
            digits: 12,
            far: 54_321.0,
            ..PLAIN
        };
        let far = format!("{name}, far away");
        assert_near(&far, measure(&far, make, style, (count(), false)));
    }
}

/// For numbers longer than a double, half an ulp is unknown.
#[test]
fn bounds_of_long_lengths_contain_true_values() {
    for (name, make) in MACHINES {
        let style = Style {
            digits: 15,
            tail: "49371",
            ..PLAIN
        };
        let name = format!("{name}, 20 digits");
        measure(&name, make, style, (count(), false));
    }
}
