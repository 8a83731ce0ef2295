//! Coupled groups: what falls apart into no dyads, solved at once by Newton's method.
//!
//! Unknowns z: the coordinates of free joints, then one angle for every class of turning links.
//! Links with two joints are distances, not unknowns. Every joint is `base + R(angle) r`, so that its
//! derivatives are exact; the equations are
//!
//! ```text
//! distance   (|a - b|^2 - r^2) / 2 = 0        rate  e.(Va - Vb)
//! meeting    a - b = 0                               Va - Vb
//! slot       n.(x - q) = 0                           n.(Vx - Vq) - w t.(x - q)
//! ```
//!
//! With J the matrix of the rates: J z' = -(rates with z' = 0), J z'' = -(second rates with z'' = 0).

use super::frame::Frame;
use super::lu;
use super::network::{ClassId, Network};
use super::state::{LinkState, PointState, State};
use crate::{Body, Input, LinkId, PointId, SlideId, Vec2};

/// More corrections than quadratic convergence needs from anywhere near.
const CORRECTIONS: usize = 24;
/// The last correction must be below this for the group to count as solved: the square root of the
/// rounding, since one more correction would have been below the rounding itself.
const SETTLED: f64 = 1.5e-8;
/// A correction below this, 4 u in scaled lengths and radians, changes nothing any more.
const FINEST: f64 = 4.0 * 0.5 * f64::EPSILON;
/// No correction moves a joint or an angle by more at once: half a link length, or half a radian.
const REACH: f64 = 0.5;

/// Where a joint's base is.
#[derive(Clone, Copy, Debug)]
enum Base {
    /// A point that earlier groups have placed.
    Known(PointId),
    /// The free joint with this number.
    Free(usize),
}

/// Which link turns the joint's arm.
#[derive(Clone, Copy, Debug)]
enum Turning {
    /// A link that earlier groups have placed.
    Known(LinkId),
    /// The class with this number; the arm is in its frame.
    Unknown(usize),
}

/// A joint: `base + R (arm + along q)`, q the driver's coordinate where the joint is pushed.
#[derive(Clone, Copy, Debug)]
struct Spot {
    base: Base,
    arm: Option<(Turning, Vec2)>,
    along: Vec2,
}

#[derive(Clone, Copy, Debug)]
enum Equation {
    Distance {
        a: Spot,
        b: Spot,
        length: f64,
    },
    Meeting {
        a: Spot,
        b: Spot,
    },
    Slot {
        x: Spot,
        q: Spot,
        along: Vec2,
        turning: Turning,
    },
}

/// What a coupled group is made from.
pub(super) struct Part<'a> {
    pub network: &'a Network<'a>,
    pub frame: Frame,
    pub point_known: &'a [bool],
    pub class_known: &'a [bool],
    pub points: &'a [PointId],
    pub classes: &'a [ClassId],
    pub links: &'a [LinkId],
    pub slides: &'a [SlideId],
    /// The point of every guide on the ground, and of some others.
    pub guide_points: &'a [Option<PointId>],
}

/// A coupled group.
#[derive(Clone, Debug)]
pub(super) struct Coupled {
    /// The joints that it places, by their spots.
    spots: Vec<(PointId, Spot)>,
    /// A link of every class of unknown direction, and its direction as seen from the class.
    turning: Vec<LinkId>,
    turns: Vec<Vec2>,
    free: usize,
    equations: Vec<Equation>,
    /// Where its room in the state's scratch begins.
    pub offset: usize,
    /// The sign of the determinant of its matrix, which a motion without a singularity keeps: of two
    /// solutions that meet at a limit it tells which one is meant. 0 before the group is assembled.
    pub side: f64,
}

/// The outcome of the corrections.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Corrected {
    /// The largest component of the first correction.
    pub first: f64,
    /// The sign of the determinant where the last correction began.
    pub side: f64,
    pub settled: bool,
}

/// A motion with its rates: of a spot, at given z' and z''.
#[derive(Clone, Copy, Default)]
struct Moving {
    p: Vec2,
    v: Vec2,
    a: Vec2,
}

/// Room for all coupled groups, allocated once.
#[derive(Clone, Debug, Default)]
pub(super) struct Scratch {
    pub numbers: Vec<f64>,
    pub pivots: Vec<usize>,
    /// The first correction of every group when it was last solved.
    pub first: Vec<f64>,
}

/// z, z' and z'' of a group: free joints as they are, angles as unit vectors with rates.
pub(super) struct Room<'a> {
    pub z: &'a mut [f64],
    pub first: &'a mut [f64],
    pub second: &'a mut [f64],
    matrix: &'a mut [f64],
    right: &'a mut [f64],
    pivots: &'a mut [usize],
}

impl Coupled {
    /// Chooses the unknowns and lists the equations; `None` where they are not equally many.
    pub(super) fn new(part: &Part<'_>) -> Option<Coupled> {
        let mut maker = Maker::new(part);
        maker.place_joints();
        maker.list_equations();
        let Maker {
            spots,
            turning,
            turns,
            free,
            equations,
            ..
        } = maker;
        let group = Coupled {
            spots,
            turning,
            turns,
            free,
            equations,
            offset: 0,
            side: 0.0,
        };
        let count: usize = group.equations.iter().map(Equation::count).sum();
        (count == group.unknowns()).then_some(group)
    }

    pub(super) fn unknowns(&self) -> usize {
        2 * self.free + self.turning.len()
    }

    pub(super) fn turning(&self) -> &[LinkId] {
        &self.turning
    }

    pub(super) fn joints(&self) -> impl Iterator<Item = PointId> + '_ {
        self.spots.iter().map(|&(point, _)| point)
    }

    /// The length of z: two numbers for a joint, two for a direction.
    pub(super) fn width(&self) -> usize {
        2 * (self.free + self.turning.len())
    }

    /// The room that the group needs in the scratch.
    pub(super) fn room(&self) -> usize {
        let n = self.unknowns();
        self.width() + 2 * n + n * n + n
    }

    pub(super) fn open<'a>(&self, scratch: &'a mut Scratch) -> Room<'a> {
        let n = self.unknowns();
        let pivots = &mut scratch.pivots[..n];
        let own = &mut scratch.numbers[self.offset..self.offset + self.room()];
        let (z, rest) = own.split_at_mut(self.width());
        let (first, rest) = rest.split_at_mut(n);
        let (second, rest) = rest.split_at_mut(n);
        let (matrix, right) = rest.split_at_mut(n * n);
        Room {
            z,
            first,
            second,
            matrix,
            right,
            pivots,
        }
    }

    /// Moves z by dq along its first and second derivatives.
    pub(super) fn predict(&self, room: &mut Room<'_>, dq: f64) {
        for i in 0..self.unknowns() {
            room.right[i] = dq * (room.first[i] + 0.5 * dq * room.second[i]);
        }
        self.shift(room.z, room.right);
    }

    /// The largest components of z' dq and of z'' dq^2 / 2.
    pub(super) fn move_sizes(&self, room: &Room<'_>, dq: f64) -> [f64; 2] {
        let largest = |v: &[f64], by: f64| v.iter().fold(0.0, |m: f64, v| m.max((v * by).abs()));
        [largest(room.first, dq), largest(room.second, 0.5 * dq * dq)]
    }

    /// Adds a change of the unknowns to z.
    fn shift(&self, z: &mut [f64], change: &[f64]) {
        let joints = 2 * self.free;
        for i in 0..joints {
            z[i] += change[i];
        }
        for (i, &angle) in change[joints..].iter().enumerate() {
            let at = joints + 2 * i;
            let turned = Vec2::new(z[at], z[at + 1]).turned(Vec2::new(angle.cos(), angle.sin()));
            // One step of Newton for the length: |d| stays 1 to the last bit or two.
            let unit = turned * (1.5 - 0.5 * turned.norm2());
            (z[at], z[at + 1]) = (unit.x, unit.y);
        }
    }

    /// Newton's corrections from the z in the scratch, until a step no longer shrinks.
    pub(super) fn correct(&self, q: f64, state: &mut State, scratch: &mut Scratch) -> Corrected {
        let mut room = self.open(scratch);
        let n = self.unknowns();
        let mut outcome = Corrected {
            first: f64::INFINITY,
            side: 0.0,
            settled: false,
        };
        let mut last = f64::INFINITY;
        for i in 0..CORRECTIONS {
            self.residuals(q, state, &mut room);
            self.jacobian(q, state, &mut room);
            let Some(side) = lu::factor(room.matrix, room.pivots, n) else {
                return outcome;
            };
            outcome.side = side;
            lu::solve(room.matrix, room.pivots, room.right, n);
            let size = room.right.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            if i == 0 {
                outcome.first = size;
            }
            // Written so that NaN ends it, too.
            if !(size < last || size > SETTLED) {
                break;
            }
            let reach = if size > REACH { REACH / size } else { 1.0 };
            for v in room.right.iter_mut() {
                *v *= -reach;
            }
            self.shift(room.z, room.right);
            last = size;
            if size <= FINEST {
                break;
            }
        }
        outcome.settled = last <= SETTLED;
        outcome
    }

    /// The derivatives of z by q, from the matrix at z, and everything that the group places.
    pub(super) fn finish(
        &self,
        q: f64,
        order: u8,
        state: &mut State,
        scratch: &mut Scratch,
    ) -> bool {
        let mut room = self.open(scratch);
        let n = self.unknowns();
        room.first.fill(0.0);
        room.second.fill(0.0);
        if order >= super::step::VELOCITY {
            self.rates(q, state, &mut room, 1);
            self.jacobian(q, state, &mut room);
            if lu::factor(room.matrix, room.pivots, n).is_none() {
                return false;
            }
            lu::solve(room.matrix, room.pivots, room.right, n);
            negate_into(room.right, room.first);
        }
        if order >= super::step::ACCELERATION {
            self.rates(q, state, &mut room, 2);
            lu::solve(room.matrix, room.pivots, room.right, n);
            negate_into(room.right, room.second);
        }
        self.write(q, state, &room);
        true
    }

    /// The determinant of the rates, scaled to be of the size of the group's own equations.
    pub(super) fn write(&self, q: f64, state: &mut State, room: &Room<'_>) {
        for (i, (&link, &turn)) in self.turning.iter().zip(&self.turns).enumerate() {
            let at = 2 * (self.free + i);
            let d = Vec2::new(room.z[at], room.z[at + 1]);
            let (w, a) = (
                room.first[2 * self.free + i],
                room.second[2 * self.free + i],
            );
            state.links[link.index()] = LinkState {
                d: d.turned(turn),
                w,
                a,
            };
        }
        for (point, spot) in &self.spots {
            let Moving { p, v, a } = self.moving(spot, q, state, room);
            state.points[point.index()] = PointState { p, v, a };
        }
    }

    /// A rough z: joints at `guess`, and directions.
    pub(super) fn set_guess(
        &self,
        z: &mut [f64],
        joints: impl Fn(PointId) -> Vec2,
        directions: &[Vec2],
    ) {
        for (point, spot) in &self.spots {
            if let Spot {
                base: Base::Free(i),
                arm: None,
                ..
            } = *spot
            {
                let at = joints(*point);
                (z[2 * i], z[2 * i + 1]) = (at.x, at.y);
            }
        }
        for (i, d) in directions.iter().enumerate() {
            let at = 2 * (self.free + i);
            (z[at], z[at + 1]) = (d.x, d.y);
        }
    }

    /// How far the equations are from holding at the z in the scratch, as a length.
    pub(super) fn gap(&self, q: f64, state: &mut State) -> f64 {
        let mut scratch = std::mem::take(&mut state.scratch);
        let mut room = self.open(&mut scratch);
        self.residuals(q, state, &mut room);
        let gap = room.right.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        state.scratch = scratch;
        gap
    }

    /// The points and links of earlier groups that this one is built on.
    pub(super) fn inputs(&self) -> (Vec<PointId>, Vec<LinkId>) {
        let (mut points, mut links) = (Vec::new(), Vec::new());
        let mut note = |spot: &Spot| {
            if let Base::Known(point) = spot.base {
                points.push(point);
            }
            if let Some((Turning::Known(link), _)) = spot.arm {
                links.push(link);
            }
        };
        self.spots.iter().for_each(|(_, spot)| note(spot));
        for equation in &self.equations {
            match equation {
                Equation::Distance { a, b, .. } | Equation::Meeting { a, b } => {
                    [a, b].map(&mut note)
                }
                Equation::Slot { x, q, .. } => [x, q].map(&mut note),
            };
        }
        for equation in &self.equations {
            if let Equation::Slot {
                turning: Turning::Known(link),
                ..
            } = equation
            {
                links.push(*link);
            }
        }
        (points, links)
    }

    // ---- motion of spots

    fn turning_state(&self, turning: Turning, state: &State, room: &Room<'_>) -> LinkState {
        match turning {
            Turning::Known(link) => state.links[link.index()],
            Turning::Unknown(i) => {
                let at = 2 * (self.free + i);
                let angle = 2 * self.free + i;
                LinkState {
                    d: Vec2::new(room.z[at], room.z[at + 1]),
                    w: room.first[angle],
                    a: room.second[angle],
                }
            }
        }
    }

    fn moving(&self, spot: &Spot, q: f64, state: &State, room: &Room<'_>) -> Moving {
        let pair = |v: &[f64], i: usize| Vec2::new(v[2 * i], v[2 * i + 1]);
        let mut moving = match spot.base {
            Base::Known(point) => {
                let PointState { p, v, a } = state.points[point.index()];
                Moving { p, v, a }
            }
            Base::Free(i) => Moving {
                p: pair(room.z, i),
                v: pair(room.first, i),
                a: pair(room.second, i),
            },
        };
        if let Some((turning, arm)) = spot.arm {
            let link = self.turning_state(turning, state, room);
            let r = (arm + spot.along * q).turned(link.d);
            let tau = spot.along.turned(link.d);
            moving.p += r;
            moving.v += r.perp() * link.w + tau;
            moving.a += r.perp() * link.a - r * (link.w * link.w) + tau.perp() * (2.0 * link.w);
        }
        moving
    }

    // ---- equations

    fn residuals(&self, q: f64, state: &State, room: &mut Room<'_>) {
        let mut row = 0;
        for equation in &self.equations {
            match equation {
                Equation::Distance { a, b, length } => {
                    let e = self.moving(a, q, state, room).p - self.moving(b, q, state, room).p;
                    let size = e.norm2().sqrt();
                    // (|e| - r)(|e| + r) / 2 keeps the digits that |e|^2 - r^2 would lose.
                    room.right[row] = 0.5 * (size - length) * (size + length);
                    row += 1;
                }
                Equation::Meeting { a, b } => {
                    let gap = self.moving(a, q, state, room).p - self.moving(b, q, state, room).p;
                    (room.right[row], room.right[row + 1]) = (gap.x, gap.y);
                    row += 2;
                }
                Equation::Slot {
                    x,
                    q: on,
                    along,
                    turning,
                } => {
                    let gap = self.moving(x, q, state, room).p - self.moving(on, q, state, room).p;
                    let t = along.turned(self.turning_state(*turning, state, room).d);
                    room.right[row] = t.cross(gap);
                    row += 1;
                }
            }
        }
    }

    /// The first (1) or second (2) rates of the equations, with z' (z'') as it stands in the room.
    fn rates(&self, q: f64, state: &State, room: &mut Room<'_>, order: u8) {
        let second = order == 2;
        let mut row = 0;
        for equation in &self.equations {
            match equation {
                Equation::Distance { a, b, .. } => {
                    let (a, b) = (
                        self.moving(a, q, state, room),
                        self.moving(b, q, state, room),
                    );
                    let (e, v) = (a.p - b.p, a.v - b.v);
                    room.right[row] = if second {
                        v.norm2() + e.dot(a.a - b.a)
                    } else {
                        e.dot(v)
                    };
                    row += 1;
                }
                Equation::Meeting { a, b } => {
                    let (a, b) = (
                        self.moving(a, q, state, room),
                        self.moving(b, q, state, room),
                    );
                    let gap = if second { a.a - b.a } else { a.v - b.v };
                    (room.right[row], room.right[row + 1]) = (gap.x, gap.y);
                    row += 2;
                }
                Equation::Slot {
                    x,
                    q: on,
                    along,
                    turning,
                } => {
                    let link = self.turning_state(*turning, state, room);
                    let (x, on) = (
                        self.moving(x, q, state, room),
                        self.moving(on, q, state, room),
                    );
                    let t = along.turned(link.d);
                    let n = t.perp();
                    let (d, v, a) = (x.p - on.p, x.v - on.v, x.a - on.a);
                    room.right[row] = if second {
                        n.dot(a)
                            - 2.0 * link.w * t.dot(v)
                            - link.a * t.dot(d)
                            - link.w * link.w * n.dot(d)
                    } else {
                        n.dot(v) - link.w * t.dot(d)
                    };
                    row += 1;
                }
            }
        }
    }

    fn jacobian(&self, q: f64, state: &State, room: &mut Room<'_>) {
        let n = self.unknowns();
        room.matrix.fill(0.0);
        let mut row = 0;
        for equation in &self.equations {
            match equation {
                Equation::Distance { a, b, .. } => {
                    let e = self.moving(a, q, state, room).p - self.moving(b, q, state, room).p;
                    self.add_columns(a, e, row * n, q, state, room);
                    self.add_columns(b, -e, row * n, q, state, room);
                    row += 1;
                }
                Equation::Meeting { a, b } => {
                    for axis in [Vec2::X, Vec2::X.perp()] {
                        self.add_columns(a, axis, row * n, q, state, room);
                        self.add_columns(b, -axis, row * n, q, state, room);
                        row += 1;
                    }
                }
                Equation::Slot {
                    x,
                    q: on,
                    along,
                    turning,
                } => {
                    let t = along.turned(self.turning_state(*turning, state, room).d);
                    let gap = self.moving(x, q, state, room).p - self.moving(on, q, state, room).p;
                    self.add_columns(x, t.perp(), row * n, q, state, room);
                    self.add_columns(on, -t.perp(), row * n, q, state, room);
                    if let Turning::Unknown(i) = turning {
                        room.matrix[row * n + 2 * self.free + i] -= t.dot(gap);
                    }
                    row += 1;
                }
            }
        }
    }

    /// Adds `weight . (derivative of the spot)` to a row of the matrix.
    fn add_columns(
        &self,
        spot: &Spot,
        weight: Vec2,
        row: usize,
        q: f64,
        state: &State,
        room: &mut Room<'_>,
    ) {
        if let Base::Free(i) = spot.base {
            room.matrix[row + 2 * i] += weight.x;
            room.matrix[row + 2 * i + 1] += weight.y;
        }
        if let Some((turning @ Turning::Unknown(i), arm)) = spot.arm {
            let r = (arm + spot.along * q).turned(self.turning_state(turning, state, room).d);
            room.matrix[row + 2 * self.free + i] += weight.dot(r.perp());
        }
    }
}

fn negate_into(from: &[f64], to: &mut [f64]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = -from;
    }
}

impl Equation {
    fn count(&self) -> usize {
        match self {
            Equation::Distance { .. } | Equation::Slot { .. } => 1,
            Equation::Meeting { .. } => 2,
        }
    }
}

/// Builds a group.
struct Maker<'a> {
    part: &'a Part<'a>,
    spots: Vec<(PointId, Spot)>,
    turning: Vec<LinkId>,
    turns: Vec<Vec2>,
    classes: Vec<ClassId>,
    free: usize,
    equations: Vec<Equation>,
}

impl<'a> Maker<'a> {
    fn new(part: &'a Part<'a>) -> Self {
        let mut maker = Maker {
            part,
            spots: Vec::new(),
            turning: Vec::new(),
            turns: Vec::new(),
            classes: Vec::new(),
            free: 0,
            equations: Vec::new(),
        };
        for &class in part.classes {
            let link = part.network.members[class.0]
                .iter()
                .copied()
                .find(|&l| maker.is_frame(l));
            if let Some(link) = link {
                maker.turning.push(link);
                maker.turns.push(part.network.turn[link.index()]);
                maker.classes.push(class);
            }
        }
        maker
    }

    /// Whether a link of the group is more than a distance between two of its points.
    fn is_frame(&self, link: LinkId) -> bool {
        !self.part.network.is_bar(link)
    }

    fn local(&self, link: LinkId, point: PointId) -> Vec2 {
        let body = self.part.network.link(link);
        self.part
            .frame
            .local(body.and_then(|l| l.local(point)).unwrap_or(Vec2::ZERO))
    }

    fn spot(&self, point: PointId) -> Option<Spot> {
        if self.part.point_known[point.index()] {
            return Some(Spot {
                base: Base::Known(point),
                arm: None,
                along: Vec2::ZERO,
            });
        }
        self.spots
            .iter()
            .find(|(p, _)| *p == point)
            .map(|&(_, spot)| spot)
    }

    fn free_spot(&mut self) -> Spot {
        self.free += 1;
        Spot {
            base: Base::Free(self.free - 1),
            arm: None,
            along: Vec2::ZERO,
        }
    }

    /// How a link turns, and the factor that brings its local vectors into the frame of that.
    fn turning(&self, link: LinkId) -> Option<(Turning, Vec2)> {
        let network = self.part.network;
        let class = network.class(link);
        if self.part.class_known[class.0] {
            return Some((Turning::Known(link), Vec2::X));
        }
        let i = self.classes.iter().position(|&c| c == class)?;
        Some((Turning::Unknown(i), network.turn[link.index()]))
    }

    /// A place `local` in a link, seen from one of its points that has a base of its own.
    fn on_link(&self, link: LinkId, foot: PointId, local: Vec2) -> Option<Spot> {
        let (turning, turn) = self.turning(link)?;
        let Spot {
            base, arm: None, ..
        } = self.spot(foot)?
        else {
            return None;
        };
        let arm = (local - self.local(link, foot)).turned(turn);
        Some(Spot {
            base,
            arm: Some((turning, arm)),
            along: Vec2::ZERO,
        })
    }

    fn frames(&self) -> Vec<LinkId> {
        let links = self.part.links.iter().copied();
        links
            .filter(|&l| self.is_frame(l) && self.turning(l).is_some() && self.is_reached(l))
            .collect()
    }

    /// Whether a link has a joint in the group, or a known one. A link that is merely locked to one
    /// of the group's has its place found later, and would bring unknowns without equations.
    fn is_reached(&self, link: LinkId) -> bool {
        let is_here =
            |p: PointId| self.part.point_known[p.index()] || self.part.points.contains(&p);
        self.part.network.joints(link).any(|m| is_here(m.point))
    }

    /// Gives every joint of the group a spot: on a frame where it can be, free otherwise.
    fn place_joints(&mut self) {
        for link in self.frames() {
            let joints: Vec<PointId> = self.part.network.joints(link).map(|m| m.point).collect();
            let foot = self.foot(link, &joints);
            for &point in &joints {
                let Some(here) = self.on_link(link, foot, self.local(link, point)) else {
                    continue;
                };
                match self.spot(point) {
                    _ if point == foot => {}
                    None => self.spots.push((point, here)),
                    Some(there) => self.equations.push(Equation::Meeting { a: here, b: there }),
                }
            }
        }
        for &point in self.part.points {
            if self.spot(point).is_none() {
                let spot = self.free_spot();
                self.spots.push((point, spot));
            }
        }
    }

    /// The joint of a frame from which its others are seen: a known one, or else a free one.
    fn foot(&mut self, link: LinkId, joints: &[PointId]) -> PointId {
        let bare = |spot: Spot| spot.arm.is_none();
        let known = joints
            .iter()
            .copied()
            .find(|p| self.part.point_known[p.index()]);
        let placed = || {
            joints
                .iter()
                .copied()
                .find(|&p| self.spot(p).is_some_and(bare))
        };
        if let Some(foot) = known.or_else(placed) {
            return foot;
        }
        let unplaced = joints.iter().copied().find(|&p| self.spot(p).is_none());
        let foot = unplaced
            .or(joints.first().copied())
            .unwrap_or(PointId::new(0));
        debug_assert!(
            self.part
                .network
                .link(link)
                .is_some_and(|l| l.local(foot).is_some())
        );
        let spot = self.free_spot();
        // A joint that sits on another frame's arm becomes free, and is tied to that arm.
        if let Some((_, there)) = self.spots.iter_mut().find(|(p, _)| *p == foot) {
            let arm = std::mem::replace(there, spot);
            self.equations.push(Equation::Meeting { a: spot, b: arm });
        } else {
            self.spots.push((foot, spot));
        }
        foot
    }

    fn list_equations(&mut self) {
        for &link in self.part.links {
            if !self.is_frame(link) && !self.part.class_known[self.part.network.class(link).0] {
                self.add_distance(link);
            }
        }
        for &slide in self.part.slides {
            self.add_slide(slide);
        }
    }

    fn add_distance(&mut self, link: LinkId) {
        let ends: Vec<PointId> = self.part.network.joints(link).map(|m| m.point).collect();
        if let [a, b] = ends[..] {
            let length = (self.local(link, a) - self.local(link, b)).norm();
            if let (Some(a), Some(b)) = (self.spot(a), self.spot(b)) {
                self.equations.push(Equation::Distance { a, b, length });
            }
        }
    }

    fn add_slide(&mut self, slide: SlideId) {
        let network = self.part.network;
        let given = network.mechanism.slide(slide);
        let through = self.part.frame.local(given.through);
        let guide = match given.on {
            Body::Ground => self.on_ground(slide),
            Body::Link(on) => {
                let mut joints = network.joints(on).map(|m| m.point);
                joints.find_map(|foot| self.on_link(on, foot, through))
            }
        };
        let (Some(x), Some(q)) = (self.spot(given.slider.point()), guide) else {
            return;
        };
        let Some((turning, turn)) = self.turning(network.body(given.on)) else {
            return;
        };
        let along = given.direction.turned(turn);
        if network.mechanism.driver().input == Input::Push(slide) {
            self.equations.push(Equation::Meeting {
                a: x,
                b: Spot { along, ..q },
            });
        } else {
            self.equations.push(Equation::Slot {
                x,
                q,
                along,
                turning,
            });
        }
    }

    /// The point of a guide on the ground.
    fn on_ground(&self, slide: SlideId) -> Option<Spot> {
        let base = Base::Known(self.part.guide_points[slide.index()]?);
        let ground = Turning::Known(self.part.network.ground());
        Some(Spot {
            base,
            arm: Some((ground, Vec2::ZERO)),
            along: Vec2::ZERO,
        })
    }
}
