//! Evaluates the equations of a coupled group, their rates and their matrix, from the motion of its
//! spots.

use super::{Base, Bearing, Coupled, GroupEquation, GroupScratch, Spot, SpotMotion, Turning};
use crate::solver::further_inputs::{Following, InputMotion};
use crate::solver::state::{LinkState, PointState, State};
use crate::{Constant, Number, Vec2};

impl Coupled {
    // ---- motion of spots

    pub(super) fn turning_state<T: Number>(
        &self,
        turning: Turning,
        state: &State<T>,
        buffers: &GroupScratch<'_, T>,
    ) -> LinkState<T> {
        match turning {
            Turning::Known(link) => state.links[link.index()],
            Turning::Unknown(i) => {
                let angle = 2 * self.free + i;
                LinkState {
                    d: self.direction(turning, state, buffers),
                    w: buffers.first[angle],
                    a: buffers.second[angle],
                }
            }
        }
    }

    /// Returns the direction of a known or unknown link.
    fn direction<T: Number>(
        &self,
        turning: Turning,
        state: &State<T>,
        buffers: &GroupScratch<'_, T>,
    ) -> Vec2<T> {
        match turning {
            Turning::Known(link) => state.links[link.index()].d,
            Turning::Unknown(i) => {
                let at = 2 * (self.free + i);
                Vec2::new(buffers.z[at], buffers.z[at + 1])
            }
        }
    }

    pub(super) fn moving<T: Number>(
        &self,
        spot: &Spot,
        q: T,
        state: &State<T>,
        buffers: &GroupScratch<'_, T>,
    ) -> SpotMotion<T> {
        let pair = |v: &[T], i: usize| Vec2::new(v[2 * i], v[2 * i + 1]);
        let mut moving = match spot.base {
            Base::Known(point) => {
                let PointState { p, v, a } = state.points[point.index()];
                SpotMotion { p, v, a }
            }
            Base::Free(i) => SpotMotion {
                p: pair(buffers.z, i),
                v: pair(buffers.first, i),
                a: pair(buffers.second, i),
            },
        };
        if let Some((turning, arm)) = spot.arm {
            let link = self.turning_state(turning, state, buffers);
            let r = spot.reach(arm, q).turned(link.d);
            let mut tau = Vec2::of(spot.along).turned(link.d);
            if let Some(following) = &spot.following {
                let InputMotion { w, a, .. } = following.at(q);
                moving.a += tau * a;
                tau = tau * w;
            }
            moving.p += r;
            moving.v += r.perp() * link.w + tau;
            moving.a += r.perp() * link.a - r * (link.w * link.w) + tau.perp() * link.w.scaled(2.0);
        }
        moving
    }

    /// Returns the position of a spot.
    fn place<T: Number>(
        &self,
        spot: &Spot,
        q: T,
        state: &State<T>,
        buffers: &GroupScratch<'_, T>,
    ) -> Vec2<T> {
        let base = match spot.base {
            Base::Known(point) => state.points[point.index()].p,
            Base::Free(i) => Vec2::new(buffers.z[2 * i], buffers.z[2 * i + 1]),
        };
        match spot.arm {
            Some((turning, arm)) => base + self.turned_arm(spot, (turning, arm), q, state, buffers),
            None => base,
        }
    }

    /// Returns the vector from the base of a spot to its end.
    fn turned_arm<T: Number>(
        &self,
        spot: &Spot,
        (turning, arm): (Turning, Vec2<Constant>),
        q: T,
        state: &State<T>,
        buffers: &GroupScratch<'_, T>,
    ) -> Vec2<T> {
        let direction = self.direction(turning, state, buffers);
        spot.reach(arm, q).turned(direction)
    }

    // ---- equations

    pub(super) fn residuals<T: Number>(
        &self,
        q: T,
        state: &State<T>,
        buffers: &mut GroupScratch<'_, T>,
    ) {
        let mut row = 0;
        for equation in &self.equations {
            match equation {
                GroupEquation::Distance { a, b, length, .. } => {
                    let e = self.place(a, q, state, buffers) - self.place(b, q, state, buffers);
                    let size = e.norm2().sqrt();
                    // (|e| - r)(|e| + r) / 2 keeps the digits that |e|^2 - r^2 would lose.
                    let length = T::of(*length);
                    buffers.right[row] = (size - length) * (size + length).scaled(0.5);
                    row += 1;
                }
                GroupEquation::Meeting { a, b, .. } => {
                    let gap = self.place(a, q, state, buffers) - self.place(b, q, state, buffers);
                    (buffers.right[row], buffers.right[row + 1]) = (gap.x, gap.y);
                    row += 2;
                }
                GroupEquation::Slot {
                    x,
                    q: on,
                    along,
                    turning,
                    ..
                } => {
                    let gap = self.place(x, q, state, buffers) - self.place(on, q, state, buffers);
                    let t = Vec2::of(*along).turned(self.direction(*turning, state, buffers));
                    buffers.right[row] = t.cross(gap);
                    row += 1;
                }
                GroupEquation::Elbow {
                    link,
                    from,
                    following,
                } => {
                    let ways = [link, from];
                    let (off, along) =
                        self.input_lead_sin_cos(ways, following.as_ref(), q, state, buffers);
                    buffers.right[row] = off.scaled(2.0) / (T::exactly(1.0) + along);
                    row += 1;
                }
            }
        }
    }

    /// Computes the first (`order` 1) or second (2) rates of the equations, with the z' and z'' in
    /// `room`.
    pub(super) fn rates<T: Number>(
        &self,
        q: T,
        state: &State<T>,
        buffers: &mut GroupScratch<'_, T>,
        order: u8,
    ) {
        let second = order == 2;
        let mut row = 0;
        for equation in &self.equations {
            match equation {
                GroupEquation::Distance { a, b, .. } => {
                    let (a, b) = (
                        self.moving(a, q, state, buffers),
                        self.moving(b, q, state, buffers),
                    );
                    let (e, v) = (a.p - b.p, a.v - b.v);
                    buffers.right[row] = if second {
                        v.norm2() + e.dot(a.a - b.a)
                    } else {
                        e.dot(v)
                    };
                    row += 1;
                }
                GroupEquation::Meeting { a, b, .. } => {
                    let (a, b) = (
                        self.moving(a, q, state, buffers),
                        self.moving(b, q, state, buffers),
                    );
                    let gap = if second { a.a - b.a } else { a.v - b.v };
                    (buffers.right[row], buffers.right[row + 1]) = (gap.x, gap.y);
                    row += 2;
                }
                GroupEquation::Slot {
                    x,
                    q: on,
                    along,
                    turning,
                    ..
                } => {
                    let link = self.turning_state(*turning, state, buffers);
                    let (x, on) = (
                        self.moving(x, q, state, buffers),
                        self.moving(on, q, state, buffers),
                    );
                    let t = Vec2::of(*along).turned(link.d);
                    let n = t.perp();
                    let (d, v, a) = (x.p - on.p, x.v - on.v, x.a - on.a);
                    buffers.right[row] = if second {
                        n.dot(a)
                            - (link.w * t.dot(v)).scaled(2.0)
                            - link.a * t.dot(d)
                            - link.w * link.w * n.dot(d)
                    } else {
                        n.dot(v) - link.w * t.dot(d)
                    };
                    row += 1;
                }
                GroupEquation::Elbow {
                    link,
                    from,
                    following,
                } => {
                    let [link_rate, from_rate] = [link, from].map(|bearing| {
                        let turning = self.turning_state(bearing.turning, state, buffers);
                        if second { turning.a } else { turning.w }
                    });
                    let motion = InputMotion::of(following.as_ref(), q);
                    let input = if second { motion.a } else { motion.w };
                    let ways = [link, from];
                    let (_, along) =
                        self.input_lead_sin_cos(ways, following.as_ref(), q, state, buffers);
                    buffers.right[row] = (link_rate - from_rate - input) * steepness(along);
                    row += 1;
                }
            }
        }
    }

    /// Returns `true` if a link points opposite to the direction that its input gives it. Its residual is
    /// infinite there, but Newton's step, the residual over its slope, is zero.
    pub(super) fn is_elbow_reversed(
        &self,
        q: f64,
        state: &State,
        buffers: &GroupScratch<'_>,
    ) -> bool {
        // Elbows are the last equations.
        let elbows = self
            .equations
            .iter()
            .rev()
            .map_while(|equation| match equation {
                GroupEquation::Elbow {
                    link,
                    from,
                    following,
                } => Some(([link, from], following)),
                _ => None,
            });
        elbows.into_iter().any(|(ways, following)| {
            let (_, along) = self.input_lead_sin_cos(ways, following.as_ref(), q, state, buffers);
            along < 0.0
        })
    }

    pub(super) fn jacobian<T: Number>(
        &self,
        q: T,
        state: &State<T>,
        buffers: &mut GroupScratch<'_, T>,
    ) {
        let n = self.unknowns();
        buffers.matrix.fill(T::default());
        let mut row = 0;
        for equation in &self.equations {
            match equation {
                GroupEquation::Distance { a, b, .. } => {
                    let e = self.place(a, q, state, buffers) - self.place(b, q, state, buffers);
                    let levers = [a, b].map(|spot| self.lever(spot, q, state, buffers));
                    self.add_columns(a, levers[0], e, row * n, buffers);
                    self.add_columns(b, levers[1], -e, row * n, buffers);
                    row += 1;
                }
                GroupEquation::Meeting { a, b, .. } => {
                    let levers = [a, b].map(|spot| self.lever(spot, q, state, buffers));
                    for axis in [Vec2::X, Vec2::X.perp()] {
                        let axis = axis.exactly();
                        self.add_columns(a, levers[0], axis, row * n, buffers);
                        self.add_columns(b, levers[1], -axis, row * n, buffers);
                        row += 1;
                    }
                }
                GroupEquation::Slot {
                    x,
                    q: on,
                    along,
                    turning,
                    ..
                } => {
                    let t = Vec2::of(*along).turned(self.direction(*turning, state, buffers));
                    let gap = self.place(x, q, state, buffers) - self.place(on, q, state, buffers);
                    let levers = [x, on].map(|spot| self.lever(spot, q, state, buffers));
                    self.add_columns(x, levers[0], t.perp(), row * n, buffers);
                    self.add_columns(on, levers[1], -t.perp(), row * n, buffers);
                    if let Turning::Unknown(i) = turning {
                        buffers.matrix[row * n + 2 * self.free + i] += -t.dot(gap);
                    }
                    row += 1;
                }
                GroupEquation::Elbow {
                    link,
                    from,
                    following,
                } => {
                    let ways = [link, from];
                    let (_, along) =
                        self.input_lead_sin_cos(ways, following.as_ref(), q, state, buffers);
                    let slope = steepness(along);
                    for (bearing, slope) in [(link, slope), (from, -slope)] {
                        if let Turning::Unknown(i) = bearing.turning {
                            buffers.matrix[row * n + 2 * self.free + i] += slope;
                        }
                    }
                    row += 1;
                }
            }
        }
    }

    /// Passes to `size` the length that each row of the matrix would have if every spot moved in the
    /// direction that its equation measures. The row itself may be zero at a singularity.
    pub(super) fn size_rows(
        &self,
        q: f64,
        state: &State,
        buffers: &GroupScratch<'_>,
        mut size: impl FnMut(f64),
    ) {
        let place = |spot: &Spot| self.place(spot, q, state, buffers);
        let arm = |spot: &Spot| arm_of(spot, q);
        let free =
            |a: &Spot, b: &Spot| [a, b].into_iter().filter(|s| s.has_free_base()).count() as f64;
        for equation in &self.equations {
            match equation {
                GroupEquation::Distance { a, b, .. } => {
                    let moves = free(a, b) + squares([arm(a), arm(b)]);
                    size((place(a) - place(b)).norm() * moves.sqrt());
                }
                GroupEquation::Meeting { a, b, .. } => {
                    let moves = free(a, b) + squares([arm(a), arm(b)]);
                    [moves.sqrt(); 2].into_iter().for_each(&mut size);
                }
                GroupEquation::Slot {
                    x, q: on, turning, ..
                } => {
                    let gap = (place(x) - place(on)).norm();
                    let slot = turning.unknown().map(|index| (index, gap));
                    size((free(x, on) + squares([arm(x), arm(on), slot])).sqrt());
                }
                GroupEquation::Elbow {
                    link,
                    from,
                    following,
                } => {
                    let ways = [link, from];
                    let turns = ways.map(|way| way.turning.unknown().map(|index| (index, 1.0)));
                    let (_, along) =
                        self.input_lead_sin_cos(ways, following.as_ref(), q, state, buffers);
                    size(steepness(along) * squares(turns).sqrt());
                }
            }
        }
    }

    /// Returns the sine and the cosine of the angle by which a link is ahead of its input's
    /// coordinate.
    fn input_lead_sin_cos<T: Number>(
        &self,
        ways: [&Bearing; 2],
        following: Option<&Following>,
        q: T,
        state: &State<T>,
        buffers: &GroupScratch<'_, T>,
    ) -> (T, T) {
        let [link, from] = ways.map(|bearing| {
            let d = self.direction(bearing.turning, state, buffers);
            Vec2::of(bearing.turn).turned(d)
        });
        let wanted = from.turned(T::unit(InputMotion::of(following, q).p));
        (wanted.cross(link), wanted.dot(link))
    }

    /// Returns the unknown direction that turns a spot, and the derivative of the spot by its angle.
    fn lever<T: Number>(
        &self,
        spot: &Spot,
        q: T,
        state: &State<T>,
        buffers: &GroupScratch<'_, T>,
    ) -> Option<(usize, Vec2<T>)> {
        let (turning, arm) = spot.arm?;
        let index = turning.unknown()?;
        let arm = self.turned_arm(spot, (turning, arm), q, state, buffers);
        Some((index, arm.perp()))
    }

    /// Adds `weight . (derivative of the spot)` to the row of the matrix that starts at index
    /// `row`.
    fn add_columns<T: Number>(
        &self,
        spot: &Spot,
        lever: Option<(usize, Vec2<T>)>,
        weight: Vec2<T>,
        row: usize,
        buffers: &mut GroupScratch<'_, T>,
    ) {
        if let Base::Free(i) = spot.base {
            buffers.matrix[row + 2 * i] += weight.x;
            buffers.matrix[row + 2 * i + 1] += weight.y;
        }
        if let Some((index, lever)) = lever {
            buffers.matrix[row + 2 * self.free + index] += weight.dot(lever);
        }
    }
}

/// Returns the length of a spot's arm, with the number of the class that turns it.
fn arm_of(spot: &Spot, q: f64) -> Option<(usize, f64)> {
    let (turning, arm) = spot.arm?;
    Some((turning.unknown()?, spot.reach(arm, q).norm()))
}

/// Returns the sum of the squares of lengths; those of one class are added first.
fn squares<const N: usize>(lengths: [Option<(usize, f64)>; N]) -> f64 {
    let of_class = |class: usize| {
        let same = lengths
            .iter()
            .flatten()
            .filter(|(other, _)| *other == class);
        same.map(|(_, length)| length).sum::<f64>()
    };
    let classes = lengths.iter().enumerate().filter_map(|(i, one)| {
        let (class, _) = (*one)?;
        let is_first = lengths[..i].iter().flatten().all(|(c, _)| *c != class);
        is_first.then_some(class)
    });
    classes.map(|class| of_class(class).powi(2)).sum()
}

/// Returns the derivative of 2 tan(delta / 2) by delta, from cos(delta). Unlike a sine, this
/// residual of an elbow has no second zero on the opposite side.
fn steepness<T: Number>(along: T) -> T {
    T::exactly(2.0) / (T::exactly(1.0) + along)
}

impl GroupEquation {
    pub(super) fn count(&self) -> usize {
        match self {
            GroupEquation::Distance { .. }
            | GroupEquation::Slot { .. }
            | GroupEquation::Elbow { .. } => 1,
            GroupEquation::Meeting { .. } => 2,
        }
    }
}
