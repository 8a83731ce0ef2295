//! Solves the equations of motion of every link and the equilibrium of every pin, all at once.
//!
//! Only the positions and the motion of points come from the solver. The unknowns are the force of
//! the pin on each link at each of its points, the normal force of each guide, its moment on a link
//! that does not turn, and the driver's effort. Couples are in N times the machine's unit of
//! length, which is similar to its dimensions, so that couples and forces have similar magnitudes.

use krank::solver::State;
use krank::{Body, Input, LinkId, Load, Mechanism, PointId, Profile, SlideId, Slider, Vec2};
use nalgebra::{DMatrix, DVector};

/// The loads in one state: forces at points in N, and couples on links.
pub(crate) struct Acting {
    points: Vec<Vec2>,
    links: Vec<f64>,
    /// The couple on the frame.
    frame: f64,
}

impl Acting {
    /// Evaluates loads, springs and dampers.
    pub(crate) fn of(mechanism: &Mechanism, state: &State) -> Acting {
        let mut loads = Acting {
            points: vec![Vec2::ZERO; mechanism.points().len()],
            links: vec![0.0; mechanism.links().len()],
            frame: 0.0,
        };
        for load in mechanism.loads() {
            match *load {
                Load::Force {
                    point,
                    force,
                    frame,
                    ..
                } => {
                    let force = match frame {
                        Body::Ground => force,
                        Body::Link(link) => turned(force, state.direction(link).unwrap()),
                    };
                    loads.points[point.index()] += force;
                }
                Load::Torque { link, torque, .. } => {
                    loads.links[link.index()] += torque / mechanism.metres();
                }
                Load::Spring {
                    from,
                    to,
                    stiffness,
                    length,
                    preload,
                    damping,
                } => {
                    let (distance, rate, _) = between(from, to, state);
                    let tension = stiffness * (distance - length) + damping * rate;
                    loads.pull(from, to, tension * mechanism.metres() + preload, state);
                }
                Load::GasSpring {
                    from,
                    to,
                    ref force,
                    damping,
                } => {
                    let (distance, rate, _) = between(from, to, state);
                    let tension = damping * rate * mechanism.metres() - level(force, distance);
                    loads.pull(from, to, tension, state);
                }
                Load::TorsionSpring {
                    link,
                    to,
                    stiffness,
                    angle,
                    preload,
                    damping,
                } => {
                    let [own, other] = [Some(link), of(to)].map(|link| turning(link, state));
                    let off = own[0] - other[0] - angle;
                    let off = (off - 360.0 * (off / 360.0).round()).to_radians();
                    let torque = preload - stiffness * off - damping * (own[1] - other[1]);
                    loads.links[link.index()] += torque / mechanism.metres();
                    match of(to) {
                        Some(other) => {
                            loads.links[other.index()] -= torque / mechanism.metres();
                        }
                        None => loads.frame -= torque / mechanism.metres(),
                    }
                }
                _ => panic!("no machine of these tests has another load"),
            }
        }
        loads
    }
}

impl Acting {
    /// Adds a tension between two points.
    fn pull(&mut self, from: PointId, to: PointId, tension: f64, state: &State) {
        let (.., along) = between(from, to, state);
        self.points[from.index()] += along * tension;
        self.points[to.index()] += -(along * tension);
    }
}

/// Returns the distance of two points, its rate, and the direction from the first to the second.
fn between(from: PointId, to: PointId, state: &State) -> (f64, f64, Vec2) {
    let e = state.position(to).unwrap() - state.position(from).unwrap();
    let along = e / e.norm();
    let rate = along.dot(state.velocity(to).unwrap() - state.velocity(from).unwrap());
    (e.norm(), rate, along)
}

/// Returns the value of a profile: linear between knots, and constant beyond them.
fn level(profile: &Profile, at: f64) -> f64 {
    let knots = profile.knots();
    let after = knots.iter().position(|knot| at < knot[0]);
    match after {
        Some(0) => knots[0][1],
        None => knots[knots.len() - 1][1],
        Some(next) => {
            let ([x0, y0], [x1, y1]) = (knots[next - 1], knots[next]);
            y0 + (y1 - y0) * (at - x0) / (x1 - x0)
        }
    }
}

fn of(body: Body) -> Option<LinkId> {
    match body {
        Body::Ground => None,
        Body::Link(link) => Some(link),
    }
}

/// Returns the direction of a link in degrees and its angular velocity; zeros for the ground.
fn turning(link: Option<LinkId>, state: &State) -> [f64; 2] {
    link.map_or([0.0; 2], |link| {
        [state.angle(link).unwrap(), state.omega(link).unwrap()]
    })
}

/// Returns the force and couple that a link's mass needs: m (a - g) at its centre of mass, and I
/// alpha.
fn needed(mechanism: &Mechanism, link: LinkId, state: &State) -> Option<(PointId, Vec2, f64)> {
    let given = mechanism.link(link);
    let (com, metres) = (given.com?, mechanism.metres());
    let a = state.acceleration(com).unwrap() * metres - mechanism.gravity();
    Some((
        com,
        a * given.mass,
        given.inertia * state.alpha(link).unwrap() / metres,
    ))
}

/// Returns the driver's power in W, from the power of all loads, and the largest single power.
pub(crate) fn power(mechanism: &Mechanism, state: &State) -> (f64, f64) {
    let loads = Acting::of(mechanism, state);
    let mut powers = Vec::new();
    for point in mechanism.point_ids() {
        powers.push(-loads.points[point.index()].dot(state.velocity(point).unwrap()));
    }
    for link in mechanism.link_ids() {
        let omega = state.omega(link).unwrap();
        powers.push(-loads.links[link.index()] * omega);
        if let Some((com, force, couple)) = needed(mechanism, link, state) {
            powers.push(force.dot(state.velocity(com).unwrap()));
            powers.push(couple * omega);
        }
    }
    let metres = mechanism.metres();
    let largest = powers
        .iter()
        .fold(0.0, |maximum: f64, p| maximum.max(p.abs()));
    (powers.iter().sum::<f64>() * metres, largest * metres)
}

fn turned(vector: Vec2, direction: Vec2) -> Vec2 {
    direction * vector.x + direction.perp() * vector.y
}

/// The indices of the unknowns, and their equations.
struct System<'a> {
    mechanism: &'a Mechanism,
    state: &'a State,
    /// The first unknown of every link (two for each of its points), and of every slide.
    joints: Vec<usize>,
    slides: Vec<usize>,
    driver: usize,
    matrix: DMatrix<f64>,
    right: DVector<f64>,
}

impl<'a> System<'a> {
    fn new(mechanism: &'a Mechanism, state: &'a State) -> Self {
        let mut unknowns = 0;
        let mut take = |count: usize| {
            unknowns += count;
            unknowns - count
        };
        let joints = mechanism.links().iter();
        let joints = joints.map(|link| take(2 * link.members.len())).collect();
        let slides = mechanism.slides().iter().map(|slide| match slide.slider {
            Slider::Pin(_) => take(1),
            Slider::Link { .. } => take(2),
        });
        let slides = slides.collect();
        let driver = take(1);
        let pins = mechanism.points().iter().filter(|p| p.ground.is_none());
        let equations = 3 * mechanism.links().len() + 2 * pins.count();
        let mut system = System {
            mechanism,
            state,
            joints,
            slides,
            driver,
            matrix: DMatrix::zeros(equations, unknowns),
            right: DVector::zeros(equations),
        };
        system.links();
        system.pins();
        system.guides();
        system
    }

    /// Returns the first of a link's two unknowns at one of its points.
    fn joint(&self, link: LinkId, point: PointId) -> usize {
        let members = &self.mechanism.link(link).members;
        let index = members.iter().position(|m| m.point == point).unwrap();
        self.joints[link.index()] + 2 * index
    }

    /// Returns the first equation of a link: forces along x and y, and moments about its first
    /// point.
    fn rows(&self, link: LinkId) -> usize {
        3 * link.index()
    }

    fn pin_rows(&self, point: PointId) -> Option<usize> {
        let points = &self.mechanism.points()[..point.index()];
        let before = points.iter().filter(|p| p.ground.is_none()).count();
        let moves = self.mechanism.point(point).ground.is_none();
        moves.then_some(3 * self.mechanism.links().len() + 2 * before)
    }

    fn arm(&self, link: LinkId, position: Vec2) -> Vec2 {
        position
            - self
                .state
                .position(self.mechanism.link(link).members[0].point)
                .unwrap()
    }

    /// Adds an unknown that acts on a link, by a unit force at a place.
    fn on_link(&mut self, link: LinkId, unknown: usize, position: Vec2, force: Vec2) {
        let (row, arm) = (self.rows(link), self.arm(link, position));
        self.matrix[(row, unknown)] += force.x;
        self.matrix[(row + 1, unknown)] += force.y;
        self.matrix[(row + 2, unknown)] += arm.cross(force);
    }

    fn links(&mut self) {
        let loads = Acting::of(self.mechanism, self.state);
        for link in self.mechanism.link_ids() {
            for member in &self.mechanism.link(link).members {
                let unknown = self.joint(link, member.point);
                let position = self.state.position(member.point).unwrap();
                self.on_link(link, unknown, position, Vec2::new(1.0, 0.0));
                self.on_link(link, unknown + 1, position, Vec2::new(0.0, 1.0));
            }
            let row = self.rows(link);
            self.right[row + 2] -= loads.links[link.index()];
            if let Some((com, force, couple)) = needed(self.mechanism, link, self.state) {
                let arm = self.arm(link, self.state.position(com).unwrap());
                self.right[row] += force.x;
                self.right[row + 1] += force.y;
                self.right[row + 2] += couple + arm.cross(force);
            }
        }
        if let Input::Turn(link) = self.mechanism.driver().input {
            let row = self.rows(link);
            self.matrix[(row + 2, self.driver)] += 1.0;
        }
    }

    /// Adds the equilibrium of pins: the joined links bear the loads at a pin and the forces of
    /// guides on it.
    fn pins(&mut self) {
        let loads = Acting::of(self.mechanism, self.state);
        for point in self.mechanism.point_ids() {
            let Some(row) = self.pin_rows(point) else {
                continue;
            };
            for &link in &self.mechanism.point(point).links {
                let unknown = self.joint(link, point);
                self.matrix[(row, unknown)] -= 1.0;
                self.matrix[(row + 1, unknown + 1)] -= 1.0;
            }
            self.right[row] -= loads.points[point.index()].x;
            self.right[row + 1] -= loads.points[point.index()].y;
        }
    }

    fn guides(&mut self) {
        for slide in self.mechanism.slide_ids() {
            let given = self.mechanism.slide(slide);
            let t = along(self.mechanism, slide, self.state);
            let unknown = self.slides[slide.index()];
            self.press(slide, unknown, t.perp());
            if self.mechanism.driver().input == Input::Push(slide) {
                self.press(slide, self.driver, t);
            }
            if let Slider::Link { link, .. } = given.slider {
                let row = self.rows(link);
                self.matrix[(row + 2, unknown + 1)] += 1.0;
                if let Body::Link(on) = given.on {
                    let row = self.rows(on);
                    self.matrix[(row + 2, unknown + 1)] -= 1.0;
                }
            }
        }
    }

    /// Adds the force of a guide on its slider, and the reaction on the guide.
    fn press(&mut self, slide: SlideId, unknown: usize, force: Vec2) {
        let given = self.mechanism.slide(slide);
        let position = self.state.position(given.slider.point()).unwrap();
        match given.slider {
            Slider::Link { link, .. } => self.on_link(link, unknown, position, force),
            Slider::Pin(pin) => {
                if let Some(row) = self.pin_rows(pin) {
                    self.matrix[(row, unknown)] += force.x;
                    self.matrix[(row + 1, unknown)] += force.y;
                }
            }
        }
        if let Body::Link(on) = given.on {
            self.on_link(on, unknown, position, -force);
        }
    }
}

/// Returns the direction of a guide.
fn along(mechanism: &Mechanism, slide: SlideId, state: &State) -> Vec2 {
    let given = mechanism.slide(slide);
    match given.on {
        Body::Ground => given.direction(),
        Body::Link(link) => turned(given.direction(), state.direction(link).unwrap()),
    }
}

/// A value of the solver with its counterpart from the equations.
pub(crate) struct Pair {
    pub(crate) name: String,
    /// `None` if the solver has no value.
    pub(crate) found: Option<f64>,
    /// `None` if the equations do not determine it.
    pub(crate) wanted: Option<f64>,
}

/// All values of a state.
pub(crate) struct Compared {
    pub(crate) pairs: Vec<Pair>,
    /// The largest of all forces and couples, including loads.
    pub(crate) largest: f64,
    /// The condition number of the equations.
    pub(crate) condition: f64,
    /// The indeterminate reactions of the minimum-norm solution: forces and, for guides that hold a
    /// link, couples, which the norm weights by the machine's unit of length.
    pub(crate) open: Vec<(Open, f64)>,
}

/// An indeterminate reaction.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Open {
    JointX(LinkId, PointId),
    JointY(LinkId, PointId),
    Normal(SlideId),
    Moment(SlideId),
}

/// A singular value below this part of the largest counts as zero: a reaction is indeterminate.
const NOTHING: f64 = 1e-11;
/// A reaction with a smaller component in the null space is determinate.
const MAX_NULL_COMPONENT: f64 = 1e-8;
/// Number of iterative refinements, each of which gains as many digits as the decomposition has.
const REFINEMENTS: usize = 2;
/// Equations with a larger residual, relative to the largest term, have no solution.
const SOLVED: f64 = 1e-12;

/// Compares the solver's forces with the equations; `None` if these have no solution.
pub(crate) fn compared(mechanism: &Mechanism, state: &State) -> Option<Compared> {
    let system = System::new(mechanism, state);
    let (x, is_shown, condition) = solved(&system)?;
    let largest = x.amax().max(system.right.amax());
    let mut pairs = Vec::new();
    let mut pair = |name: String, unknown: usize, found: Option<f64>| {
        pairs.push(Pair {
            name,
            found,
            wanted: is_shown[unknown].then(|| x[unknown]),
        });
    };
    let metres = mechanism.metres();
    let drive = match mechanism.driver().input {
        Input::Turn(_) => state.drive().map(|torque| torque / metres),
        Input::Push(_) => state.drive(),
    };
    pair("driver".into(), system.driver, drive);
    for link in mechanism.link_ids() {
        for point in mechanism.pins(link) {
            let unknown = system.joint(link, point);
            let force = state.joint_force(link, point);
            let name = format!("link {} at {}", link.index(), point.index());
            pair(format!("{name} x"), unknown, force.map(|f| f.x));
            pair(format!("{name} y"), unknown + 1, force.map(|f| f.y));
        }
    }
    for slide in mechanism.slide_ids() {
        let unknown = system.slides[slide.index()];
        let name = format!("slide {}", slide.index());
        pair(format!("{name} normal"), unknown, state.normal(slide));
        if matches!(mechanism.slide(slide).slider, Slider::Link { .. }) {
            let moment = state.moment(slide).map(|m| m / metres);
            pair(format!("{name} moment"), unknown + 1, moment);
        }
    }
    if is_shown.iter().all(|&is_reported| is_reported) {
        pairs.extend(frame(&system, &x));
    }
    Some(Compared {
        open: open(&system, &x, &is_shown),
        pairs,
        largest,
        condition,
    })
}

/// Returns the indeterminate reactions and their values in the solution.
fn open(system: &System<'_>, x: &DVector<f64>, is_shown: &[bool]) -> Vec<(Open, f64)> {
    let mechanism = system.mechanism;
    let mut all = Vec::new();
    for link in mechanism.link_ids() {
        for point in mechanism.pins(link) {
            let unknown = system.joint(link, point);
            all.push((Open::JointX(link, point), unknown));
            all.push((Open::JointY(link, point), unknown + 1));
        }
    }
    for slide in mechanism.slide_ids() {
        let unknown = system.slides[slide.index()];
        all.push((Open::Normal(slide), unknown));
        if matches!(mechanism.slide(slide).slider, Slider::Link { .. }) {
            all.push((Open::Moment(slide), unknown + 1));
        }
    }
    let open = all.into_iter().filter(|&(_, unknown)| !is_shown[unknown]);
    open.map(|(open, unknown)| (open, x[unknown])).collect()
}

/// Returns the solution, which of its components are determinate, and the condition number.
fn solved(system: &System<'_>) -> Option<(DVector<f64>, Vec<bool>, f64)> {
    let unknowns = system.matrix.ncols();
    if system.matrix.is_square()
        && let Some(inverse) = system.matrix.clone().try_inverse()
    {
        let norm = |m: &DMatrix<f64>| m.row_iter().map(|row| row.lp_norm(1)).fold(0.0, f64::max);
        let condition = norm(&system.matrix) * norm(&inverse);
        if condition < 1.0 / NOTHING {
            let x = system.matrix.clone().full_piv_lu().solve(&system.right)?;
            return Some((x, vec![true; unknowns], condition));
        }
    }
    // The matrix is made square, so that the vectors span the whole null space.
    let rows = system.matrix.nrows().max(unknowns);
    let matrix = system.matrix.clone().resize_vertically(rows, 0.0);
    let right = system.right.clone().resize_vertically(rows, 0.0);
    let svd = matrix.clone().svd(true, true);
    let maximum = svd.singular_values.max();
    let mut x = svd.solve(&right, NOTHING * maximum).ok()?;
    // The decomposition itself is sometimes only accurate to 1e-9, so that the residual is solved
    // for again.
    for _ in 0..REFINEMENTS {
        x += svd
            .solve(&(&right - &matrix * &x), NOTHING * maximum)
            .ok()?;
    }
    let vectors = svd.v_t.as_ref()?;
    let mut is_shown = vec![true; unknowns];
    let mut minimum = maximum;
    for (k, &value) in svd.singular_values.iter().enumerate() {
        if value > NOTHING * maximum {
            minimum = minimum.min(value);
            continue;
        }
        for (output, part) in is_shown.iter_mut().zip(vectors.row(k).iter()) {
            *output &= part.abs() < MAX_NULL_COMPONENT;
        }
    }
    let misses = (&matrix * &x - &right).amax();
    let holds = misses <= SOLVED * x.amax().max(right.amax());
    holds.then_some((x, is_shown, maximum / minimum))
}

/// Compares the force and moment on the frame with the sum over all its joints and guides.
fn frame(system: &System<'_>, x: &DVector<f64>) -> [Pair; 3] {
    let System {
        mechanism, state, ..
    } = *system;
    let loads = Acting::of(mechanism, state);
    let (mut force, mut moment) = (Vec2::ZERO, 0.0);
    let mut feel = |position: Vec2, by: Vec2| {
        force += by;
        moment += position.cross(by);
    };
    for point in mechanism.point_ids() {
        let given = mechanism.point(point);
        let Some(position) = given.ground else {
            continue;
        };
        feel(position, loads.points[point.index()]);
        for &link in &given.links {
            let unknown = system.joint(link, point);
            feel(position, -Vec2::new(x[unknown], x[unknown + 1]));
        }
    }
    let mut couple = loads.frame;
    for slide in mechanism.slide_ids() {
        let given = mechanism.slide(slide);
        let t = along(mechanism, slide, state);
        let unknown = system.slides[slide.index()];
        let position = state.position(given.slider.point()).unwrap();
        let mut force = t.perp() * x[unknown];
        if mechanism.driver().input == Input::Push(slide) {
            force += t * x[system.driver];
        }
        // The guide acts on a pin of the frame as on any other, and the reaction on a guide of the
        // frame.
        let pin = match given.slider {
            Slider::Pin(pin) => mechanism.point(pin).ground.is_some(),
            Slider::Link { .. } => false,
        };
        if pin {
            feel(position, force);
        }
        if given.on == Body::Ground {
            feel(position, -force);
            if let Slider::Link { .. } = given.slider {
                couple -= x[unknown + 1];
            }
        }
    }
    if let Input::Turn(_) = mechanism.driver().input {
        couple -= x[system.driver];
    }
    let found = state.frame_force();
    let found = [
        found.map(|f| f.x),
        found.map(|f| f.y),
        state.frame_moment().map(|m| m / mechanism.metres()),
    ];
    let wanted = [force.x, force.y, moment + couple];
    let names = ["frame x", "frame y", "frame moment"];
    std::array::from_fn(|i| Pair {
        name: names[i].into(),
        found: found[i],
        wanted: Some(wanted[i]),
    })
}
