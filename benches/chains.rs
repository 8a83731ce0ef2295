//! Long chains of dyads: what a solver meets that was made for four-bars.

use krank::{Builder, Driver, Input, Mechanism, PointId, Vec2};

/// The first link of a chain turns once a second, from 90 degrees.
fn driven(builder: &mut Builder, pivot: PointId, pin: PointId, length: f64) {
    let crank = builder.link(pivot, pin, length);
    builder.driver(Driver {
        input: Input::Turn(crank),
        start: 90.0,
        speed: 1.0,
        acceleration: 0.0,
    });
}

/// A chain of four-bars, each driven by the rocker of the one before: rockers of length 1 on pivots a unit
/// apart, coupled by bars of length 1, the first one moved by a short crank.
pub(crate) fn grounded(dyads: usize) -> Mechanism {
    let mut builder = Mechanism::builder();
    let pivot = builder.ground_point(-1.0, 1.0);
    let mut pin = builder.moving_point();
    driven(&mut builder, pivot, pin, 0.2);
    for k in 0..dyads {
        let x = k as f64;
        let foot = builder.ground_point(x, 0.0);
        let joint = builder.moving_point();
        builder.link(pin, joint, 1.0);
        builder.link(foot, joint, 1.0);
        builder.start(joint, Vec2::new(x, 1.0));
        pin = joint;
    }
    builder.build().expect("a sound chain")
}

/// How far back the link is on whose plain point a dyad stands.
const BACK: usize = 7;
/// The plain point of a link, as parts of its length along and across.
const PLAIN: Vec2 = Vec2::new(0.5, 0.25);

/// A chain in which each dyad stands on the joint before and on a plain point of an earlier link.
#[allow(dead_code, reason = "not every benchmark opens them")]
pub(crate) fn on_plain_points(dyads: usize) -> Mechanism {
    let mut builder = Mechanism::builder();
    let pivot = builder.ground_point(0.0, 0.0);
    let pin = builder.moving_point();
    driven(&mut builder, pivot, pin, 0.2);
    let mut joint = (pin, Vec2::new(0.0, 0.2));
    let mut plain = vec![(builder.ground_point(3.0, 0.0), Vec2::new(3.0, 0.0))];
    for k in 0..dyads {
        let (from, p) = joint;
        let (other, q) = plain[k.saturating_sub(BACK).min(plain.len() - 1)];
        // To and fro, so that the chain stays where it began.
        let position = (p + q) * 0.5 + Vec2::new(0.0, if k % 2 == 0 { 2.0 } else { -2.0 });
        let next = builder.moving_point();
        let length = (position - p).norm();
        let link = builder.link(from, next, length);
        builder.link(other, next, (position - q).norm());
        builder.start(next, position);
        let point = builder.moving_point();
        builder.carry(link, point, PLAIN * length);
        plain.push((point, p + PLAIN.turned(position - p)));
        joint = (next, position);
    }
    builder.build().expect("a sound chain")
}
