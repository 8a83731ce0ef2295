//! Hand-written closed forms of four mechanisms, as fast as they can be written without giving up
//! generality in the lengths: plain circle intersection with one square root and one division,
//! `sin_cos`, rates from the 2 x 2 system of each dyad with one division, no `atan2`.
//!
//! They know their mechanism in advance and check nothing: they are what a general solver is measured
//! against, not something to use.
//!
//! `LEAN` they are the leanest that could be written: one division for a dyad, which is less exact, and the
//! sine and cosine of a crank by the shortest polynomials that are right to the last digits.

use krank::{Vec2, angle};

/// A joint's position, velocity and acceleration.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Joint {
    pub(crate) p: Vec2,
    pub(crate) v: Vec2,
    pub(crate) a: Vec2,
}

/// A link's angular velocity and acceleration.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Turning {
    pub(crate) omega: f64,
    pub(crate) alpha: f64,
}

/// A point of the ground.
const fn ground(x: f64, y: f64) -> Joint {
    Joint {
        p: Vec2::new(x, y),
        v: Vec2::ZERO,
        a: Vec2::ZERO,
    }
}

/// The pin of a crank of length r about `pivot` that turns evenly.
#[inline(always)]
fn crank<const LEAN: bool>(pivot: Vec2, r: f64, omega: f64, degrees: f64) -> Joint {
    let arm = if LEAN {
        angle::unit(degrees) * r
    } else {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Vec2::new(r * cos, r * sin)
    };
    Joint {
        p: pivot + arm,
        v: arm.perp() * omega,
        a: arm * -(omega * omega),
    }
}

/// Two bars between two joints: the squares of their lengths and the inverses of these.
#[derive(Clone, Copy, Debug)]
struct Dyad {
    b2: f64,
    /// b^2 - c^2.
    difference: f64,
    per_b2: f64,
    per_c2: f64,
    sign: f64,
}

/// What a dyad gives: its inner joint and the turning of its bars.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Solved {
    pub(crate) joint: Joint,
    pub(crate) first: Turning,
    pub(crate) second: Turning,
}

impl Dyad {
    /// Bars b from the first and c from the second joint; `sign` is +1 where the inner joint lies to
    /// the left of the line from the first to the second.
    fn new(b: f64, c: f64, sign: f64) -> Self {
        Dyad {
            b2: b * b,
            difference: b * b - c * c,
            per_b2: 1.0 / (b * b),
            per_c2: 1.0 / (c * c),
            sign,
        }
    }

    #[inline(always)]
    fn solve<const LEAN: bool>(&self, from: Joint, to: Joint) -> Solved {
        // With d the distance, d^2 times the parts of e along and across it; the second is e x f.
        let line = to.p - from.p;
        let d2 = line.norm2();
        let along = 0.5 * (d2 + self.difference);
        let across = self.sign * (self.b2 * d2 - along * along).sqrt();
        let (per_d2, per_det) = if LEAN {
            let per_both = 1.0 / (d2 * across);
            (across * per_both, d2 * per_both)
        } else {
            (1.0 / d2, 1.0 / across)
        };
        let e = (line * along + line.perp() * across) * per_d2;
        let f = e - line;
        // e . V = e . V_from, f . V = f . V_to, and the same once more with the squares.
        let solve = |r: f64, s: f64| Vec2::new(r * f.y - s * e.y, s * e.x - r * f.x) * per_det;
        let v = solve(e.dot(from.v), f.dot(to.v));
        let (ve, vf) = (v - from.v, v - to.v);
        let a = solve(e.dot(from.a) - ve.norm2(), f.dot(to.a) - vf.norm2());
        let (ae, af) = (a - from.a, a - to.a);
        Solved {
            joint: Joint {
                p: from.p + e,
                v,
                a,
            },
            first: Turning {
                omega: e.cross(ve) * self.per_b2,
                alpha: e.cross(ae) * self.per_b2,
            },
            second: Turning {
                omega: f.cross(vf) * self.per_c2,
                alpha: f.cross(af) * self.per_c2,
            },
        }
    }
}

/// A point that rides on a bar, as parts along and across the bar.
#[derive(Clone, Copy, Debug)]
struct Rider {
    along: f64,
    across: f64,
}

impl Rider {
    /// From local coordinates on a bar of a length.
    fn new(x: f64, y: f64, length: f64) -> Self {
        Rider {
            along: x / length,
            across: y / length,
        }
    }

    #[inline(always)]
    fn ride(self, base: Joint, tip: Joint) -> Joint {
        let on = |base: Vec2, tip: Vec2| {
            let bar = tip - base;
            base + bar * self.along + bar.perp() * self.across
        };
        Joint {
            p: on(base.p, tip.p),
            v: on(base.v, tip.v),
            a: on(base.a, tip.a),
        }
    }
}

/// The four-bar of the lectures: r2 = 100, r3 = 300, r4 = 250, frame 400.
pub(crate) struct FourBar(Dyad);

impl FourBar {
    pub(crate) fn new() -> Self {
        FourBar(Dyad::new(300.0, 250.0, 1.0))
    }

    /// B, C and the turning of r3 and r4.
    #[inline(always)]
    pub(crate) fn solve<const LEAN: bool>(&self, degrees: f64) -> ([Joint; 2], [Turning; 2]) {
        let b = crank::<LEAN>(Vec2::ZERO, 100.0, 15.0, degrees);
        let Solved {
            joint,
            first,
            second,
        } = self.0.solve::<LEAN>(b, ground(400.0, 0.0));
        ([b, joint], [first, second])
    }
}

/// The slider-crank of the lectures: r2 = 10, r3 = 20, the slider in line along x.
pub(crate) struct SliderCrank;

impl SliderCrank {
    /// B, C and the turning of r3.
    #[inline(always)]
    pub(crate) fn solve<const LEAN: bool>(&self, degrees: f64) -> ([Joint; 2], [Turning; 1]) {
        const ROD2: f64 = 400.0;
        let b = crank::<LEAN>(Vec2::ZERO, 10.0, 200.0, degrees);
        let ex = (ROD2 - b.p.y * b.p.y).sqrt();
        let e = Vec2::new(ex, -b.p.y);
        // e . V = e . V_B with V along x.
        let per_ex = 1.0 / ex;
        let v = Vec2::new(e.dot(b.v) * per_ex, 0.0);
        let ve = v - b.v;
        let a = Vec2::new((e.dot(b.a) - ve.norm2()) * per_ex, 0.0);
        let c = Joint {
            p: Vec2::new(b.p.x + ex, 0.0),
            v,
            a,
        };
        let turning = Turning {
            omega: e.cross(ve) * (1.0 / ROD2),
            alpha: e.cross(a - b.a) * (1.0 / ROD2),
        };
        ([b, c], [turning])
    }
}

/// The press of two four-bars.
pub(crate) struct Press {
    first: Dyad,
    arm: Rider,
    second: Dyad,
}

impl Press {
    pub(crate) fn new() -> Self {
        Press {
            first: Dyad::new(300.0, 250.0, 1.0),
            arm: Rider::new(40.0, -180.0, 250.0),
            second: Dyad::new(320.0, 300.0, 1.0),
        }
    }

    /// B, C, E, F and the turning of r3, r4, r5 and r6.
    #[inline(always)]
    pub(crate) fn solve<const LEAN: bool>(&self, degrees: f64) -> ([Joint; 4], [Turning; 4]) {
        let (d, g) = (ground(400.0, 0.0), ground(900.0, 60.0));
        let b = crank::<LEAN>(Vec2::ZERO, 100.0, 10.0, degrees);
        let one = self.first.solve::<LEAN>(b, d);
        let e = self.arm.ride(d, one.joint);
        let two = self.second.solve::<LEAN>(e, g);
        (
            [b, one.joint, e, two.joint],
            [one.first, one.second, two.first, two.second],
        )
    }
}

/// Jansen's leg.
pub(crate) struct Jansen {
    upper: Dyad,
    lower: Dyad,
    last: Dyad,
    knee: Rider,
    foot: Rider,
}

impl Jansen {
    /// The corners of the two triangles are those of the preset.
    pub(crate) fn new(knee: Vec2, foot: Vec2) -> Self {
        Jansen {
            upper: Dyad::new(50.0, 41.5, -1.0),
            lower: Dyad::new(61.9, 39.3, 1.0),
            last: Dyad::new(39.4, 36.7, -1.0),
            knee: Rider::new(knee.x, knee.y, 41.5),
            foot: Rider::new(foot.x, foot.y, 36.7),
        }
    }

    /// M, X, W, Y, V, T and the turning of j, bde, k, c, f and ghi.
    #[inline(always)]
    pub(crate) fn solve<const LEAN: bool>(&self, degrees: f64) -> ([Joint; 6], [Turning; 6]) {
        let p = ground(-38.0, -7.8);
        let m = crank::<LEAN>(Vec2::ZERO, 15.0, 1.0, degrees);
        let upper = self.upper.solve::<LEAN>(m, p);
        let lower = self.lower.solve::<LEAN>(m, p);
        let (x, y) = (upper.joint, lower.joint);
        let w = self.knee.ride(p, x);
        let last = self.last.solve::<LEAN>(w, y);
        let t = self.foot.ride(y, last.joint);
        (
            [m, x, w, y, last.joint, t],
            [
                upper.first,
                upper.second,
                lower.first,
                lower.second,
                last.first,
                last.second,
            ],
        )
    }
}
