//! Random machines, generated group by group: each group is attached to joints, plain points,
//! slides and guides of earlier parts. The pose is drawn first and the lengths are measured in it,
//! so that every machine can be assembled.

use crate::random::TestRng;
use krank::{
    Body, Builder, Driver, Input, LinkId, Load, Mechanism, PointId, Profile, SlideId, Vec2, angle,
};

/// A mechanism and its groups, for failure messages.
pub(crate) struct Machine {
    pub(crate) mechanism: Mechanism,
    pub(crate) groups: Vec<String>,
}

/// A link or the ground, in the pose.
struct Part {
    link: Option<LinkId>,
    origin: Vec2,
    /// The direction of its x axis in degrees.
    angle: f64,
    points: Vec<PointId>,
}

impl Part {
    fn body(&self) -> Body {
        self.link.map_or(Body::Ground, Body::Link)
    }

    fn local(&self, position: Vec2) -> Vec2 {
        let x = angle::unit(self.angle);
        let away = position - self.origin;
        Vec2::new(x.dot(away), x.cross(away))
    }
}

/// The ground is the first part.
const GROUND: usize = 0;

struct MachineBuilder<'a> {
    rng: &'a mut TestRng,
    digits: Digits,
    builder: Builder,
    parts: Vec<Part>,
    /// Places by point.
    places: Vec<Vec2>,
    moving: Vec<PointId>,
    groups: Vec<String>,
}

/// Rounds a number to the digits that it has in the scene.
pub(crate) type Digits = fn(f64) -> f64;

/// Generates a machine of at most `most` groups.
pub(crate) fn machine(rng: &mut TestRng, maximum: usize, digits: Digits) -> Option<Machine> {
    let mut grower = MachineBuilder::new(rng, digits);
    let cylinder = grower.add_driver();
    for _ in 0..1 + grower.rng.below(maximum) {
        grower.group();
    }
    if cylinder {
        grower.cylinder();
    }
    grower.load();
    let MachineBuilder {
        builder, groups, ..
    } = grower;
    let mechanism = builder.build().ok()?;
    Some(Machine { mechanism, groups })
}

impl<'a> MachineBuilder<'a> {
    fn new(rng: &'a mut TestRng, digits: Digits) -> Self {
        let ground = Part {
            link: None,
            origin: Vec2::ZERO,
            angle: 0.0,
            points: Vec::new(),
        };
        MachineBuilder {
            rng,
            digits,
            builder: Mechanism::builder(),
            parts: vec![ground],
            places: Vec::new(),
            moving: Vec::new(),
            groups: Vec::new(),
        }
    }

    // ---- basic parts

    fn vector(&mut self, size: f64) -> Vec2 {
        Vec2::new(self.rng.within(-size, size), self.rng.within(-size, size))
    }

    fn direction(&mut self) -> f64 {
        self.rng.within(0.0, 360.0)
    }

    fn point(&mut self, position: Vec2) -> PointId {
        let point = self.builder.moving_point();
        self.builder.start(point, position);
        self.places.push(position);
        self.moving.push(point);
        point
    }

    fn at(&self, point: PointId) -> Vec2 {
        self.places[point.index()]
    }

    /// Adds a link near a place.
    fn part(&mut self, near: Vec2) -> usize {
        let origin = near + self.vector(0.5);
        self.part_at(origin)
    }

    fn part_at(&mut self, origin: Vec2) -> usize {
        let angle = self.direction();
        self.part_along(origin, angle)
    }

    fn part_along(&mut self, origin: Vec2, angle: f64) -> usize {
        let link = Some(self.builder.free_link());
        self.parts.push(Part {
            link,
            origin,
            angle,
            points: Vec::new(),
        });
        self.parts.len() - 1
    }

    fn carry(&mut self, part: usize, point: PointId) {
        let position = self.at(point);
        let Part { link, points, .. } = &mut self.parts[part];
        points.push(point);
        let link = *link;
        let local = self.parts[part].local(position).map(self.digits);
        if let Some(link) = link {
            self.builder.carry(link, point, local);
        }
    }

    /// Returns a point of an existing part: a joint, or a new plain point.
    fn anchor(&mut self) -> PointId {
        let part = if self.rng.is(0.35) {
            GROUND
        } else {
            self.rng.below(self.parts.len())
        };
        self.anchor_on(part)
    }

    fn anchor_on(&mut self, part: usize) -> PointId {
        if !self.parts[part].points.is_empty() && self.rng.is(0.4) {
            let points = self.parts[part].points.clone();
            return self.rng.one_of(&points);
        }
        let spread = if part == GROUND { 3.0 } else { 1.2 };
        let position = self.parts[part].origin + self.vector(spread);
        if part == GROUND {
            self.ground_point(position)
        } else {
            let point = self.point(position);
            self.carry(part, point);
            point
        }
    }

    fn ground_point(&mut self, position: Vec2) -> PointId {
        let position = position.map(self.digits);
        let point = self.builder.ground_point(position.x, position.y);
        self.places.push(position);
        self.parts[GROUND].points.push(point);
        point
    }

    /// Returns two points at some distance from each other.
    fn anchors(&mut self) -> [PointId; 2] {
        let first = self.anchor();
        loop {
            let second = self.anchor();
            let distance = (self.at(second) - self.at(first)).norm();
            if (0.3..4.0).contains(&distance) {
                return [first, second];
            }
        }
    }

    /// Adds a link between two points, defined by its ends or in a frame of its own.
    fn bar(&mut self, from: PointId, to: PointId) {
        let [a, b] = [from, to].map(|p| self.at(p));
        if self.rng.is(0.7) {
            let length = (self.digits)((b - a).norm());
            let link = Some(self.builder.link(from, to, length));
            self.parts.push(Part {
                link,
                origin: a,
                angle: angle::degrees(b - a),
                points: vec![from, to],
            });
            if self.rng.is(0.04) {
                // A redundant copy of the first bar.
                self.builder.link(from, to, length);
                self.groups.push("a bar beside a bar".into());
            }
        } else {
            let part = self.part((a + b) * 0.5);
            self.carry(part, from);
            self.carry(part, to);
        }
    }

    /// Returns a guide on a part through a place: its point and direction in the part's frame.
    fn guide(&mut self, part: usize, position: Vec2, angle: f64) -> (Body, Vec2, f64) {
        let through = position + angle::unit(angle) * self.rng.within(-1.0, 1.0);
        let part = &self.parts[part];
        let local = part.local(through).map(self.digits);
        (part.body(), local, (self.digits)(angle - part.angle))
    }

    fn slot(&mut self, pin: PointId, part: usize, angle: f64) -> SlideId {
        let position = self.at(pin);
        let (on, through, angle) = self.guide(part, position, angle);
        self.builder.pin_in_slot(pin, on, through, angle)
    }

    /// Adds a link that slides on a part without turning, near a place.
    fn block(&mut self, near: Vec2, part: usize, angle: f64) -> usize {
        let position = near + self.vector(0.4);
        let block = self.part_at(position);
        let origin = self.point(position);
        self.carry(block, origin);
        self.lock(block, part, angle);
        block
    }

    /// Makes a link slide on a part, with its origin on the guide.
    fn lock(&mut self, block: usize, part: usize, angle: f64) -> Option<SlideId> {
        let (position, turn) = (self.parts[block].origin, self.parts[block].angle - angle);
        let turn = (self.digits)(turn);
        let link = self.parts[block].link?;
        let (on, through, angle) = self.guide(part, position, angle);
        Some(self.builder.sliding_link(link, turn, on, through, angle))
    }

    fn any_part(&mut self) -> usize {
        if self.rng.is(0.4) {
            GROUND
        } else {
            self.rng.below(self.parts.len())
        }
    }

    /// Returns a direction far from parallel to another one.
    fn across(&mut self, along: f64) -> f64 {
        along + self.rng.sign() * self.rng.within(40.0, 140.0)
    }

    // ---- the driver

    /// Adds the driver. Returns `true` if it will be a cylinder, which is added last.
    fn add_driver(&mut self) -> bool {
        let (speed, acceleration) = (self.rng.within(0.5, 3.0), self.rng.within(-4.0, 4.0));
        let kind = self.rng.below(8);
        let pivot = self.vector(1.0);
        if kind == 0 {
            let along = self.direction();
            let (slide, start) = if self.rng.is(0.5) {
                let pin = self.point(pivot);
                let part = self.part(pivot);
                self.carry(part, pin);
                let slide = self.slot(pin, GROUND, along);
                // The link can turn, so that a bar to the ground holds it.
                let other = self.anchor_on(part);
                let out = self.direction();
                let ground = self.ground_point(pivot + angle::unit(out) * 1.5);
                self.bar(ground, other);
                (slide, pin)
            } else {
                let block = self.part_at(pivot);
                let origin = self.point(pivot);
                self.carry(block, origin);
                let Some(slide) = self.lock(block, GROUND, along) else {
                    return false;
                };
                (slide, origin)
            };
            self.push(slide, start, speed, acceleration);
            self.groups.push("a pushed slide".into());
            return false;
        }
        let ground = self.ground_point(pivot);
        let part = self.part(pivot);
        self.carry(part, ground);
        let Some(link) = self.parts[part].link.filter(|_| kind != 1) else {
            self.groups.push("a boom".into());
            return true;
        };
        self.builder.driver(Driver {
            input: Input::Turn(link),
            start: self.parts[part].angle,
            speed,
            acceleration,
        });
        self.groups.push("a crank".into());
        false
    }

    /// Drives a slide from its position in the pose. This needs the built guide, so that a copy is
    /// built first.
    fn push(&mut self, slide: SlideId, point: PointId, speed: f64, acceleration: f64) {
        let driver = |start| Driver {
            input: Input::Push(slide),
            start,
            speed,
            acceleration,
        };
        let mut copy = self.builder.clone();
        copy.driver(driver(0.0));
        let Ok(mechanism) = copy.build() else { return };
        let given = mechanism.slide(slide);
        let part = self.parts.iter().find(|part| part.body() == given.on);
        let local = part.map_or(self.at(point), |part| part.local(self.at(point)));
        let start = given.direction().dot(local - given.through);
        self.builder.driver(driver(start));
    }

    /// Adds a driven cylinder between two points of different bodies.
    fn cylinder(&mut self) {
        let [foot, pin] = self.anchors();
        let barrel = self.part(self.at(foot));
        self.carry(barrel, foot);
        let along = angle::degrees(self.at(pin) - self.at(foot)) + self.rng.within(-20.0, 20.0);
        let slide = self.slot(pin, barrel, along);
        let (speed, acceleration) = (self.rng.within(0.1, 0.5), self.rng.within(-0.5, 0.5));
        self.push(slide, pin, speed, acceleration);
        self.groups.push("a cylinder".into());
    }

    // ---- groups

    fn group(&mut self) {
        let name = match self.rng.below(13) {
            0 | 1 => self.two_bars(),
            2 => self.bar_and_slot(),
            3 => self.bar_and_block(),
            4 => self.arm_through_a_pin(),
            5 => self.arm_through_a_block(),
            6 => self.pin_in_two_slots(),
            7 => self.two_blocks(),
            8 => self.yoke(),
            9 => self.block_on_block(),
            _ => self.plates(),
        };
        self.groups.push(name);
    }

    /// RRR.
    fn two_bars(&mut self) -> String {
        let [p, q] = self.anchors();
        let line = self.at(q) - self.at(p);
        let high = self.rng.sign() * self.rng.within(0.5, 1.5);
        let position = self.at(p) + line * self.rng.within(-0.3, 1.3) + line.perp() * high;
        let x = self.point(position);
        self.bar(p, x);
        self.bar(x, q);
        "RRR".into()
    }

    /// Returns a place near a point, and the direction of a guide that can lead a bar from the
    /// point there.
    fn place_near(&mut self, point: PointId) -> (Vec2, f64) {
        let out = self.direction();
        let position = self.at(point) + angle::unit(out) * self.rng.within(0.6, 1.8);
        (position, out + self.rng.within(-55.0, 55.0))
    }

    /// RRP, with a pin in a slot.
    fn bar_and_slot(&mut self) -> String {
        let p = self.anchor();
        let part = self.any_part();
        let (position, along) = self.place_near(p);
        let x = self.point(position);
        self.bar(p, x);
        self.slot(x, part, along);
        "RRP".into()
    }

    /// RRP, with a sliding link.
    fn bar_and_block(&mut self) -> String {
        let p = self.anchor();
        let part = self.any_part();
        let (position, along) = self.place_near(p);
        let block = self.block(position, part, along);
        let x = self.point(position);
        self.carry(block, x);
        self.bar(p, x);
        "RRP block".into()
    }

    /// RPR, with a pin in the arm's slot.
    fn arm_through_a_pin(&mut self) -> String {
        let [pivot, pin] = self.anchors();
        let arm = self.part(self.at(pivot));
        self.carry(arm, pivot);
        let line = angle::degrees(self.at(pin) - self.at(pivot));
        let along = line + self.rng.within(-55.0, 55.0);
        self.slot(pin, arm, along);
        "RPR".into()
    }

    /// RPR, with a link sliding on the arm.
    fn arm_through_a_block(&mut self) -> String {
        let [pivot, pin] = self.anchors();
        let arm = self.part(self.at(pivot));
        self.carry(arm, pivot);
        let line = angle::degrees(self.at(pin) - self.at(pivot));
        let along = line + self.rng.within(-40.0, 40.0);
        let block = self.block(self.at(pin), arm, along);
        self.carry(block, pin);
        "RPR block".into()
    }

    /// PRP, with one pin.
    fn pin_in_two_slots(&mut self) -> String {
        let parts = [self.any_part(), self.any_part()];
        let position = self.parts[parts[0]].origin + self.vector(1.5);
        let x = self.point(position);
        let along = self.direction();
        let across = self.across(along);
        self.slot(x, parts[0], along);
        self.slot(x, parts[1], across);
        "PRP".into()
    }

    /// PRP, with two sliding links.
    fn two_blocks(&mut self) -> String {
        let parts = [self.any_part(), self.any_part()];
        let position = self.parts[parts[0]].origin + self.vector(1.5);
        let x = self.point(position);
        let along = self.direction();
        for (part, along) in parts.into_iter().zip([along, self.across(along)]) {
            let block = self.block(position, part, along);
            self.carry(block, x);
        }
        "PRP blocks".into()
    }

    /// RPP: a pin in the slot of a sliding link.
    fn yoke(&mut self) -> String {
        let pin = self.anchor();
        let part = self.any_part();
        let along = self.direction();
        let yoke = self.block(self.at(pin), part, along);
        let across = self.across(along);
        self.slot(pin, yoke, across);
        "RPP".into()
    }

    /// RPP: a pin on a link that slides on another sliding link.
    fn block_on_block(&mut self) -> String {
        let pin = self.anchor();
        let part = self.any_part();
        let along = self.direction();
        let lower = self.block(self.at(pin), part, along);
        let across = self.across(along);
        let upper = self.block(self.at(pin), lower, across);
        self.carry(upper, pin);
        "RPP blocks".into()
    }

    /// Adds plates pinned together in a row: 2 unknowns of the first pin and one direction per
    /// plate.
    fn plates(&mut self) -> String {
        let count = 1 + self.rng.below(5);
        let mut joint = None;
        let near = self.anchor();
        let mut position = self.at(near) + self.vector(1.5);
        for i in 0..count {
            let plate = self.part_at(position);
            if let Some(joint) = joint {
                self.carry(plate, joint);
            }
            let is_end = i == 0 || i + 1 == count;
            let holds = match (count, is_end) {
                (1, _) => 3,
                (_, true) => 2,
                (_, false) => 1,
            };
            for k in 0..holds {
                let out = 120.0 * f64::from(k) + self.rng.within(-40.0, 40.0);
                let end = position + angle::unit(out) * self.rng.within(0.3, 1.0);
                self.hold(plate, end);
            }
            if i + 1 < count {
                position += angle::unit(self.direction()) * self.rng.within(0.8, 1.6);
                let next = self.point(position);
                self.carry(plate, next);
                joint = Some(next);
            }
        }
        format!("{count} plates")
    }

    /// Removes one degree of freedom from a link: by a bar, a pin in another part's slot, or a pin
    /// in its own slot.
    fn hold(&mut self, plate: usize, position: Vec2) {
        match self.rng.below(5) {
            0 => {
                let pin = self.point(position);
                self.carry(plate, pin);
                let part = loop {
                    let part = self.any_part();
                    if part != plate {
                        break part;
                    }
                };
                let along = self.direction();
                self.slot(pin, part, along);
            }
            1 => {
                let pin = loop {
                    let pin = self.anchor();
                    if !self.parts[plate].points.contains(&pin) {
                        break pin;
                    }
                };
                let along = self.direction();
                self.slot(pin, plate, along);
            }
            _ => {
                let end = self.point(position);
                if self.rng.is(0.2) {
                    self.strut(plate, end);
                } else {
                    self.carry(plate, end);
                }
                let foot = loop {
                    let foot = self.anchor();
                    let distance = (self.at(foot) - position).norm();
                    if !self.parts[plate].points.contains(&foot) && distance > 0.3 {
                        break foot;
                    }
                };
                self.bar(foot, end);
            }
        }
    }

    /// Ties a point to a link by two bars, which adds two unknowns.
    fn strut(&mut self, plate: usize, end: PointId) {
        let out = self.direction();
        for turn in [0.0, self.across(0.0)] {
            let foot = self.at(end) + angle::unit(out + turn) * self.rng.within(0.4, 1.0);
            let foot = self.point(foot);
            self.carry(plate, foot);
            self.bar(foot, end);
        }
    }

    // ---- loads

    fn load(&mut self) {
        let gravity = self.vector(10.0).map(self.digits);
        self.builder.gravity(gravity);
        let metres = self.rng.one_of(&[1.0, 0.01, 0.001]);
        self.builder.metres(metres);
        for part in 1..self.parts.len() {
            let Some(link) = self.parts[part].link else {
                continue;
            };
            if self.rng.is(0.7) {
                let local = self.vector(1.0).map(self.digits);
                self.builder.centre_of_mass(link, local);
                let inertia = (self.digits)(self.rng.within(0.0, 0.3) * metres * metres);
                let mass = (self.digits)(self.rng.within(0.1, 3.0));
                self.builder.mass(link, mass, inertia);
            }
        }
        let links: Vec<LinkId> = self.parts.iter().filter_map(|part| part.link).collect();
        let all: Vec<PointId> = self.parts.iter().flat_map(|p| p.points.clone()).collect();
        for _ in 0..1 + self.rng.below(3) {
            if self.moving.is_empty() {
                break;
            }
            let point = self.rng.one_of(&self.moving.clone());
            let mut load = Load::force(point, self.vector(50.0).map(self.digits));
            if let (Load::Force { frame, .. }, true) = (&mut load, self.rng.is(0.3)) {
                *frame = Body::Link(self.rng.one_of(&links));
            }
            self.builder.load(load);
        }
        let torque = (self.digits)(self.rng.within(-30.0, 30.0) * metres);
        let link = self.rng.one_of(&links);
        self.builder.load(Load::torque(link, torque));
        for _ in 0..self.rng.below(3) {
            let [from, to] = [self.rng.one_of(&all), self.rng.one_of(&all)];
            if (self.at(to) - self.at(from)).norm() > 0.2 {
                let stiffness = (self.digits)(self.rng.within(0.0, 30.0) / metres);
                self.builder.load(Load::Spring {
                    from,
                    to,
                    stiffness,
                    length: (self.digits)(self.rng.within(0.0, 2.0)),
                    preload: (self.digits)(self.rng.within(-10.0, 10.0)),
                    damping: (self.digits)(0.1 * stiffness),
                });
            }
        }
        self.gas_spring(&all);
        self.torsion_spring(&links);
    }

    /// Sometimes adds a gas spring, with distances on both sides of its length in the pose.
    fn gas_spring(&mut self, all: &[PointId]) {
        let [from, to] = [self.rng.one_of(all), self.rng.one_of(all)];
        let distance = (self.at(to) - self.at(from)).norm();
        if distance > 0.2 && self.rng.is(0.4) {
            let mut knot = |part: f64| {
                let push = self.rng.within(2.0, 20.0);
                [(self.digits)(part * distance), (self.digits)(push)]
            };
            let knots = vec![knot(0.3), knot(0.9), knot(1.7)];
            let damping = (self.digits)(self.rng.within(0.0, 2.0));
            self.builder.load(Load::GasSpring {
                from,
                to,
                force: Profile::new(knots).unwrap(),
                damping,
            });
        }
    }

    /// Sometimes adds a torsion spring, to another link or the ground.
    fn torsion_spring(&mut self, links: &[LinkId]) {
        let [link, other] = [self.rng.one_of(links), self.rng.one_of(links)];
        if self.rng.is(0.4) {
            let to = if link == other {
                Body::Ground
            } else {
                Body::Link(other)
            };
            let mut number = |low, high| (self.digits)(self.rng.within(low, high));
            self.builder.load(Load::TorsionSpring {
                link,
                to,
                stiffness: number(0.0, 20.0),
                angle: number(-180.0, 180.0),
                preload: number(-5.0, 5.0),
                damping: number(0.0, 2.0),
            });
        }
    }
}
