//! Tests machines of known mobility: redundant constraints and free motions, in any order and
//! orientation, must be found by number and by name.
//!
//! A crank that rocks between two stops carries dyads. To these are added redundant elements (third
//! cranks, a brace in a rigid part, a second guide) and free ones (chains of three bars, hanging
//! bars). `KRANK_MACHINES` is the number of machines.

use crate::plant::unit;
use krank::solver::{Fault, Solver};
use krank::{Body, Builder, Driver, ElementId, Input, LinkId, Mechanism, PointId, Vec2};
use std::collections::BTreeSet;

const MACHINES: u64 = 150;

/// Random numbers in 0..1 (splitmix64); the seed determines the machine.
struct SplitMix(u64);

impl SplitMix {
    fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.roll()
    }

    fn below(&mut self, count: usize) -> usize {
        (self.roll() * count as f64) as usize
    }
}

/// A link of the plan, with its points by number.
#[derive(Clone)]
struct Bar {
    points: Vec<usize>,
    /// The angle of a ground guide, for a ram whose origin is the first point.
    ram: Option<f64>,
}

/// The known structure of a machine.
#[derive(Default)]
struct Plan {
    /// Places of points, and whether they are on the ground.
    points: Vec<(Vec2, bool)>,
    bars: Vec<Bar>,
    /// Pins in slots of the ground, with the slots' angles.
    slots: Vec<(usize, f64)>,
    /// For each redundant constraint, the elements that repeat each other: bars, and slots after
    /// the bars.
    repeating: Vec<BTreeSet<usize>>,
    /// The bars that can move freely.
    floating: BTreeSet<usize>,
    free: usize,
    /// The elements that lock the driver, if any.
    held: BTreeSet<usize>,
}

const SLOT: usize = 1000;

impl Plan {
    fn point(&mut self, at: Vec2, ground: bool) -> usize {
        self.points.push((at, ground));
        self.points.len() - 1
    }

    fn bar(&mut self, points: &[usize]) -> usize {
        self.bars.push(Bar {
            points: points.to_vec(),
            ram: None,
        });
        self.bars.len() - 1
    }

    /// Creates a rocking crank: a nearly extended dyad stops it some degrees to either side.
    fn rocking_crank(rng: &mut SplitMix) -> (Plan, usize) {
        let mut plan = Plan::default();
        let a = plan.point(Vec2::ZERO, true);
        let pin = Vec2::new(0.2, 1.0);
        let b = plan.point(pin, false);
        plan.bar(&[a, b]);
        // The two bars of a stop reach only a little further than needed.
        let g = plan.point(Vec2::new(-3.0, 1.0), true);
        let bend = rng.between(0.2, 0.35);
        let c = plan.point(Vec2::new(-1.4, 1.0 + 2.0 * bend), false);
        plan.bar(&[b, c]);
        plan.bar(&[c, g]);
        let h = plan.point(Vec2::new(3.4, 1.0), true);
        let d = plan.point(Vec2::new(1.8, 1.0 - 2.0 * bend), false);
        plan.bar(&[b, d]);
        plan.bar(&[d, h]);
        (plan, b)
    }

    /// Adds a dyad from a moving point to the ground, and returns its inner joint.
    fn dyad(&mut self, rng: &mut SplitMix, from: usize) -> usize {
        let at = self.points[from].0;
        let along = unit(rng.between(0.0, 360.0));
        let joint = at + along * rng.between(0.8, 2.0);
        let turn = rng.between(50.0, 130.0) * if rng.roll() < 0.5 { 1.0 } else { -1.0 };
        let pivot = joint + along.turned(unit(turn)) * rng.between(0.8, 2.0);
        let joint = self.point(joint, false);
        let pivot = self.point(pivot, true);
        self.bar(&[from, joint]);
        self.bar(&[joint, pivot]);
        joint
    }

    /// Adds a parallelogram next to the crank AB, and further cranks, each of which is redundant.
    fn cranks(&mut self, rng: &mut SplitMix, count: usize, stretch: f64) {
        let arm = self.points[1].0 - self.points[0].0;
        let mut platform = vec![1];
        let mut cranks = Vec::new();
        for k in 0..=count {
            let away = Vec2::new(2.0 + 1.3 * k as f64, rng.between(-0.6, 0.4));
            let pivot = self.point(away, true);
            // A last crank that does not fit locks the machine: its arm is turned and stretched.
            let off = if k == count { stretch } else { 0.0 };
            let end = away + arm + arm.perp() * off + arm * off;
            let end = self.point(end, false);
            cranks.push(self.bar(&[pivot, end]));
            platform.push(end);
        }
        let platform = self.bar(&platform);
        // Any two of the cranks guide the platform.
        let mut set = BTreeSet::from([0, platform]);
        set.extend(cranks);
        if stretch == 0.0 {
            self.repeating.extend(vec![set; count]);
        } else {
            self.held = set;
        }
    }

    /// Adds a rigid part of four joints and six bars on a moving point, guided by a bar to the
    /// ground.
    fn braced(&mut self, rng: &mut SplitMix, from: usize) {
        let at = self.points[from].0;
        let along = unit(rng.between(0.0, 360.0)) * rng.between(1.0, 2.0);
        let corners = [(0.9, 0.1), (0.5, 0.8), (0.4, 0.3)];
        let corners = corners.map(|(x, y)| {
            let (x, y) = (x + 0.1 * rng.roll(), y + 0.1 * rng.roll());
            at + along * x + along.perp() * y
        });
        let mut all = vec![from];
        all.extend(corners.map(|corner| self.point(corner, false)));
        let mut part = BTreeSet::new();
        for i in 0..4 {
            for j in i + 1..4 {
                part.insert(self.bar(&[all[i], all[j]]));
            }
        }
        let tip = corners[0];
        let pivot = tip + along.perp() * rng.between(0.8, 1.4);
        let pivot = self.point(pivot, true);
        self.bar(&[all[1], pivot]);
        self.repeating.push(part);
    }

    /// Adds a ram along a guide, pushed by a bar, with a second pin in a parallel slot.
    fn guided(&mut self, rng: &mut SplitMix, from: usize) {
        let angle = rng.between(0.0, 180.0);
        let along = unit(angle);
        let origin = self.points[from].0 + along.turned(unit(rng.between(20.0, 60.0))) * 1.5;
        let second = origin + along * rng.between(0.5, 1.5) + along.perp() * rng.between(0.2, 0.8);
        let origin = self.point(origin, false);
        let second = self.point(second, false);
        self.bar(&[from, origin]);
        self.bars.push(Bar {
            points: vec![origin, second],
            ram: Some(angle),
        });
        let ram = self.bars.len() - 1;
        self.slots.push((second, angle));
        let slot = SLOT + self.slots.len() - 1;
        // The ram's own guide has the number of the ram plus an offset beyond the slots.
        self.repeating
            .push(BTreeSet::from([slot, ram, 2 * SLOT + ram]));
    }

    /// Adds three bars from a moving point to the ground, with one free motion.
    fn loose_chain(&mut self, rng: &mut SplitMix, from: usize) {
        let mut at = self.points[from].0;
        let mut last = from;
        let heading = rng.between(0.0, 360.0);
        for (k, turn) in [0.0, 70.0, -40.0].into_iter().enumerate() {
            at += unit(heading + turn) * rng.between(0.7, 1.3);
            let next = self.point(at, k == 2);
            let bar = self.bar(&[last, next]);
            self.floating.insert(bar);
            last = next;
        }
        self.free += 1;
    }

    /// Adds a bar that hangs on a moving point.
    fn hanging(&mut self, rng: &mut SplitMix, from: usize) {
        let end = self.points[from].0 + unit(rng.between(0.0, 360.0));
        let end = self.point(end, false);
        let bar = self.bar(&[from, end]);
        self.floating.insert(bar);
        self.free += 1;
    }

    fn grown(rng: &mut SplitMix, held: bool) -> Plan {
        let (mut plan, pin) = Plan::rocking_crank(rng);
        let mut joints = vec![pin];
        for _ in 0..rng.below(3) {
            let from = joints[rng.below(joints.len())];
            let joint = plan.dyad(rng, from);
            joints.push(joint);
        }
        let from = |rng: &mut SplitMix| joints[rng.below(joints.len())];
        if held {
            let stretch = rng.between(0.05, 0.3);
            plan.cranks(rng, 1, stretch);
            return plan;
        }
        if rng.roll() < 0.5 {
            let count = 1 + rng.below(2);
            plan.cranks(rng, count, 0.0);
        }
        for _ in 0..rng.below(3) {
            let at = from(rng);
            plan.braced(rng, at);
        }
        if rng.roll() < 0.4 {
            let at = from(rng);
            plan.guided(rng, at);
        }
        for _ in 0..rng.below(3) {
            let at = from(rng);
            if rng.roll() < 0.5 {
                plan.loose_chain(rng, at);
            } else {
                plan.hanging(rng, at);
            }
        }
        plan
    }
}

/// A plan as a mechanism, shuffled and rotated, with the elements of the plan's numbers.
struct Built {
    mechanism: Mechanism,
    links: Vec<Option<LinkId>>,
    slots: Vec<ElementId>,
    guides: Vec<(usize, ElementId)>,
}

impl Built {
    fn of(plan: &Plan, rng: &mut SplitMix) -> Built {
        let turn = rng.between(0.0, 360.0);
        let shift = Vec2::new(rng.between(-5.0, 5.0), rng.between(-5.0, 5.0));
        let place = |at: Vec2| at.turned(unit(turn)) + shift;
        let mut b = Builder::default();
        let points: Vec<PointId> = plan
            .points
            .iter()
            .map(|&(at, ground)| {
                let at = place(at);
                if ground {
                    b.ground_point(at.x, at.y)
                } else {
                    let point = b.moving_point();
                    b.start(point, at);
                    point
                }
            })
            .collect();
        let mut order: Vec<usize> = (0..plan.bars.len()).collect();
        for i in (1..order.len()).rev() {
            order.swap(i, rng.below(i + 1));
        }
        let mut links = vec![None; plan.bars.len()];
        let mut guides = Vec::new();
        for i in order {
            let bar = &plan.bars[i];
            let mut ends = bar.points.clone();
            if bar.ram.is_none() && ends.len() == 2 && rng.roll() < 0.5 {
                ends.reverse();
            }
            let at = |p: usize| place(plan.points[p].0);
            let along = at(ends[1]) - at(ends[0]);
            let link = match bar.ram {
                None => b.link(points[ends[0]], points[ends[1]], along.norm()),
                Some(_) => b.free_link(),
            };
            // Coordinates in the frame of the link, along its first two points or along its guide.
            let own = match bar.ram {
                None => along / along.norm(),
                Some(angle) => unit(angle + turn),
            };
            let first = if bar.ram.is_none() { 2 } else { 0 };
            for &p in &ends[first..] {
                let local = (at(p) - at(ends[0])).turned(own.conj());
                b.carry(link, points[p], local);
            }
            if let Some(angle) = bar.ram {
                let through = at(ends[0]) - own * 0.4;
                let slide = b.sliding_link(link, 0.0, Body::Ground, through, angle + turn);
                guides.push((i, ElementId::Slide(slide)));
            }
            links[i] = Some(link);
        }
        let slots = plan.slots.iter().map(|&(p, angle)| {
            let at = place(plan.points[p].0);
            let through = at - unit(angle + turn) * 0.3;
            ElementId::Slide(b.pin_in_slot(points[p], Body::Ground, through, angle + turn))
        });
        let slots = slots.collect();
        let crank = links[0].unwrap();
        let arm = plan.points[1].0 - plan.points[0].0;
        let from_pivot = b.clone().build_from(crank, points[0]);
        let heading = arm.angle().to_degrees() + turn;
        b.driver(Driver {
            input: Input::Turn(crank),
            start: if from_pivot { heading } else { heading + 180.0 },
            speed: 1.0,
            acceleration: 0.0,
        });
        Built {
            mechanism: b.build().unwrap(),
            links,
            slots,
            guides,
        }
    }

    fn elements(&self, numbers: &BTreeSet<usize>) -> Vec<ElementId> {
        let element = |&n: &usize| {
            if n < SLOT {
                self.links[n].map(ElementId::Link)
            } else if n < 2 * SLOT {
                self.slots.get(n - SLOT).copied()
            } else {
                let mut guides = self.guides.iter();
                guides.find(|(ram, _)| *ram == n - 2 * SLOT).map(|g| g.1)
            }
        };
        numbers.iter().filter_map(element).collect()
    }
}

/// Checks whether a link starts at a point.
trait FirstEnd {
    fn build_from(self, link: LinkId, point: PointId) -> bool;
}

impl FirstEnd for Builder {
    fn build_from(mut self, link: LinkId, point: PointId) -> bool {
        self.driver(Driver {
            input: Input::Turn(link),
            start: 0.0,
            speed: 1.0,
            acceleration: 0.0,
        });
        let mechanism = self.build().unwrap();
        mechanism.link(link).ends.unwrap().0 == point
    }
}

fn is_in(set: &[ElementId], elements: &[ElementId]) -> bool {
    elements.iter().all(|e| set.contains(e))
}

/// Returns the deviation of the solver's findings from the plan, if any.
fn complaint(plan: &Plan, built: &Built) -> Option<String> {
    let planted: Vec<Vec<ElementId>> = plan.repeating.iter().map(|s| built.elements(s)).collect();
    let output = Solver::new(&built.mechanism);
    match output {
        _ if !plan.held.is_empty() => {
            let held = built.elements(&plan.held);
            match output {
                Err(Fault::OverConstrained {
                    element, others, ..
                }) if held.contains(&element) && is_in(&held, &others) && others.len() >= 2 => None,
                other => Some(format!("held {held:?}: {:?}", other.err())),
            }
        }
        Ok(solver) if plan.free == 0 => {
            let found = &solver.rank().redundancies;
            let count: usize = found.iter().map(|r| r.constraints).sum();
            let fits = found.iter().all(|r| {
                let names: Vec<ElementId> = [&r.repeats[..], &[r.element]].concat();
                r.misfit <= 1e-11 && planted.iter().any(|set| is_in(set, &names))
            });
            (count != planted.len() || !fits).then(|| format!("{found:?} for {planted:?}"))
        }
        Err(Fault::Mobility {
            mobility,
            redundant,
            repeating,
            floating,
            is_unclear,
        }) if plan.free > 0 => {
            let numbers = (mobility, redundant, is_unclear);
            let wanted = (1 + plan.free, planted.len(), false);
            let free = built.elements(&plan.floating);
            let floating: Vec<ElementId> = floating.into_iter().map(ElementId::Link).collect();
            let floats = is_in(&free, &floating) && is_in(&floating, &free);
            let all = planted.concat();
            // The driven link is not redundant if its dependents do without it.
            let crank = ElementId::Link(built.links[0].unwrap());
            let missing = all
                .iter()
                .filter(|&e| *e != crank && !repeating.contains(e));
            let repeats = missing.count() == 0 && is_in(&all, &repeating);
            (numbers != wanted || !floats || !repeats).then(|| {
                format!("{numbers:?} for {wanted:?}; {floating:?} for {free:?}; {repeating:?} for {all:?}")
            })
        }
        other => Some(format!(
            "free {}, planted {planted:?}: {:?}",
            plan.free,
            other.err()
        )),
    }
}

fn machines() -> u64 {
    let wanted = std::env::var("KRANK_MACHINES").ok();
    wanted.and_then(|n| n.parse().ok()).unwrap_or(MACHINES)
}

#[test]
fn planted_redundancy_and_freedom_are_found_by_count_and_name() {
    let mut wrong = Vec::new();
    for seed in 0..machines() {
        let mut rng = SplitMix(seed);
        let plan = Plan::grown(&mut rng, seed % 5 == 4);
        let built = Built::of(&plan, &mut rng);
        wrong.extend(complaint(&plan, &built).map(|text| format!("seed {seed}: {text}")));
    }
    let shown = wrong.iter().take(5).cloned().collect::<Vec<_>>();
    assert!(
        wrong.is_empty(),
        "{} wrong\n{}",
        wrong.len(),
        shown.join("\n")
    );
}
