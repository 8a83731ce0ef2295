//! Defines the common interface of the dyads with two assemblies.

use super::singular_series::{FEW_TERMS, Height, InSeries, SingularShift, between, squared};
use super::{
    CircleLine, CircleRail, Circles, Cylinder, Element, RelativeMotion, StepOutcome, Stretching,
    Swing, sum,
};
use crate::arithmetic::{Series, TERMS};
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::{LinkState, State};
use crate::{Double, LinkId, Number, PointId, Vec2};

/// A dyad with two assemblies; the sign of its group selects one.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) enum Dyad<'a> {
    /// RRR.
    Circles(&'a Circles),
    /// RRP.
    CircleLine(&'a CircleLine),
    /// RRP on the ground.
    CircleRail(&'a CircleRail),
    /// RPR.
    Swing(&'a Swing),
    /// RRR with a driven arm.
    Cylinder(&'a Cylinder),
}

/// Applies the same expression to every dyad.
macro_rules! each {
    ($dyad:expr, $d:ident => $do:expr) => {
        match $dyad {
            Dyad::Circles($d) => $do,
            Dyad::CircleLine($d) => $do,
            Dyad::CircleRail($d) => $do,
            Dyad::Swing($d) => $do,
            Dyad::Cylinder($d) => $do,
        }
    };
}

/// The interface of a dyad with two assemblies, given the state of its pivots and guides.
pub(super) trait TwoAssemblies {
    /// The dyad's representation in series.
    type InSeries: InSeries;

    /// Returns the group whose sign selects the assembly.
    fn group(&self) -> usize;

    /// Returns `true` if it can be assembled within rounding, in a defined direction.
    fn is_in_reach<T: Number>(&self, q: T, state: &State<T>) -> bool;

    /// Places the dyad in line, as at its limit: positions only.
    fn align<T: Number>(&self, q: T, state: &mut State<T>);

    /// Returns the rate of the distance that stretches it (between the pivots, or between pivot and
    /// guide), up to a positive factor. It is zero where the stretch is extreme. Returns `None` if
    /// its own reach changes.
    fn stretch_rate<T: Number>(&self, state: &State<T>) -> Option<T> {
        let [a, b] = self.pivots()?.map(|point| state.points[point.index()]);
        Some((b.p - a.p).dot(b.v - a.v))
    }

    /// Returns how it is being stretched, by the rates of its pivots.
    fn stretching(&self, _q: f64, seen_from: LinkState, state: &State) -> Option<Stretching> {
        let [a, b] = self.pivots()?.map(|point| state.points[point.index()]);
        let (d, LinkState { w, a: alpha, .. }) = (b.p - a.p, seen_from);
        let from_ground = RelativeMotion {
            v: b.v - a.v,
            a: b.a - a.a,
        };
        let from_link = RelativeMotion {
            v: sum([b.v, -a.v, -d.perp() * w]),
            a: sum([b.a, -a.a, -d.perp() * alpha, d * (w * w)]),
        };
        Some(Stretching {
            toward: d,
            growth: d.dot(from_ground.v),
            seen: [from_ground, from_link],
        })
    }

    /// Returns the distance from the extremes of its reach, as a length: negative if it is open.
    fn reserve<T: Number>(&self, q: T, state: &State<T>) -> T;

    // ---- in series, about a position where it may be singular

    /// Returns the pivots, if there are two, which can coincide.
    fn pivots(&self) -> Option<[PointId; 2]> {
        None
    }

    /// Returns the difference of its arms. If they are equal, the pivots can coincide.
    fn arm_difference(&self, _q: Series) -> f64 {
        f64::INFINITY
    }

    /// Returns the quantity that stretches it, and its size: the squared distance of its pivots, or
    /// the distance of pivot and guide. Where the quantity is extreme, the arms can be in line.
    fn reach(&self, state: &State<Series>) -> [Series; 2] {
        let u = self.pivots().map(|[a, b]| between(a, b, state));
        squared(u.unwrap_or_default().map(|v| v.cut(FEW_TERMS)))
    }

    /// Returns the series representation to at most this number of terms.
    fn in_series(
        &self,
        q: Series,
        snap: SingularShift,
        terms: usize,
        state: &State<Series>,
    ) -> Self::InSeries;

    /// Returns the square of its height when its transmission angle is 90 degrees.
    fn right_angle(&self, q: Series, state: &State<Series>) -> f64;

    /// Places the dyad with this signed height.
    fn run_through(
        &self,
        q: Series,
        snap: SingularShift,
        height: Series,
        state: &mut State<Series>,
    );
}

/// Returns how far a triangle of the sides d, b, c is from being flat.
pub(super) fn triangle_reserve<T: Number>(d: T, b: T, c: T) -> T {
    ((b + c) - d).min(d - (b - c).abs())
}

impl Dyad<'_> {
    /// Places the dyad at its limit, if it can be assembled within rounding.
    #[cold]
    pub(in crate::solver) fn stretch<T: Number>(self, q: T, state: &mut State<T>) -> StepOutcome {
        if !each!(self, d => d.is_in_reach(q, state)) {
            return StepOutcome::Open;
        }
        self.align(q, state);
        StepOutcome::Stretched
    }

    /// Places the dyad in line, as at its limit: positions only.
    pub(in crate::solver) fn align<T: Number>(self, q: T, state: &mut State<T>) {
        each!(self, d => d.align(q, state));
    }

    /// Returns the group whose sign selects the assembly.
    pub(in crate::solver) fn group(self) -> usize {
        each!(self, d => d.group())
    }

    /// Returns the rate of the stretch: see [`TwoAssemblies::stretch_rate`].
    pub(in crate::solver) fn stretch_rate<T: Number>(self, state: &State<T>) -> Option<T> {
        each!(self, d => d.stretch_rate(state))
    }

    /// Returns how it is being stretched. `carriers` holds, for every point, the link that carries
    /// it, if any.
    pub(in crate::solver) fn stretching(
        self,
        q: f64,
        carriers: &[Option<LinkId>],
        state: &State,
    ) -> Option<Stretching> {
        let pivots = each!(self, d => d.pivots());
        let mut carriers = pivots.into_iter().flatten().map(|p| carriers[p.index()]);
        let carrier = carriers.find_map(|carrier| carrier);
        let ground = LinkState::fixed(Vec2::X);
        let seen_from = carrier.map_or(ground, |link| state.links[link.index()]);
        each!(self, d => d.stretching(q, seen_from, state))
    }

    /// Returns the gap that prevents assembly; 0 if it can be assembled.
    pub(in crate::solver) fn gap(self, q: f64, state: &State) -> f64 {
        (-self.reserve(q, state)).max(0.0)
    }

    /// Returns the distance from the extremes of its reach: see [`TwoAssemblies::reserve`].
    pub(in crate::solver) fn reserve<T: Number>(self, q: T, state: &State<T>) -> T {
        each!(self, d => d.reserve(q, state))
    }

    // ---- in series

    /// Returns the quantity that stretches it: see [`TwoAssemblies::reach`].
    pub(in crate::solver) fn reach(self, state: &State<Series>) -> [Series; 2] {
        each!(self, d => d.reach(state))
    }

    /// Returns the vector from pivot to pivot, if it has two pivots.
    pub(in crate::solver) fn pivots(self, state: &State<Series>) -> Option<Vec2<Series>> {
        let [a, b] = each!(self, d => d.pivots())?;
        Some(between(a, b, state))
    }

    /// Returns `true` if both its pivots move.
    pub(in crate::solver) fn has_moving_pivots(self, state: &State<Series>) -> bool {
        let moves = |p: PointId| {
            let Vec2 { x, y } = state.points[p.index()].p;
            [x, y].iter().any(|v| v.c[1..].iter().any(|c| c.hi != 0.0))
        };
        each!(self, d => d.pivots()).is_some_and(|pivots| pivots.into_iter().all(moves))
    }

    /// Returns the square of its height.
    pub(in crate::solver) fn square(
        self,
        q: Series,
        snap: SingularShift,
        state: &State<Series>,
    ) -> Series {
        each!(self, d => d.in_series(q, snap, TERMS, state).square())
    }

    /// Returns the first terms of the square of its height, with their sizes and slopes.
    pub(in crate::solver) fn height(
        self,
        q: Series,
        snap: SingularShift,
        state: &State<Series>,
    ) -> Height {
        each!(self, d => d.in_series(q, snap, FEW_TERMS, state).height())
    }

    /// Returns the vector from pivot to pivot if the pivots may coincide, that is, if the arms are
    /// equal within `slack`.
    pub(in crate::solver) fn meeting(
        self,
        q: Series,
        slack: f64,
        state: &State<Series>,
    ) -> Option<Vec2<Double>> {
        let distance = each!(self, d => d.arm_difference(q));
        let u = self.pivots(state).filter(|_| distance.abs() <= slack)?;
        Some(u.map(|v| v.c[0]))
    }

    /// Returns the square of its height at a right transmission angle: see
    /// [`TwoAssemblies::right_angle`].
    pub(in crate::solver) fn right_angle(self, q: Series, state: &State<Series>) -> f64 {
        each!(self, d => d.right_angle(q, state))
    }

    /// Places the dyad with this signed height.
    pub(in crate::solver) fn run_through(
        self,
        q: Series,
        snap: SingularShift,
        height: Series,
        state: &mut State<Series>,
    ) {
        each!(self, d => d.run_through(q, snap, height, state));
    }

    /// Restores links that do not rotate: see [`Circles::translate`]. Other dyads have a guide or a
    /// driven arm.
    pub(in crate::solver) fn translate(self, state: &mut State<Series>) {
        match self {
            Dyad::Circles(circles) => circles.translate(state),
            Dyad::CircleLine(_) | Dyad::CircleRail(_) | Dyad::Swing(_) | Dyad::Cylinder(_) => {}
        }
    }

    /// Returns the positions and directions that it places, in series.
    pub(in crate::solver) fn placed(
        self,
        state: &State<Series>,
    ) -> impl Iterator<Item = Vec2<Series>> {
        let mut placed = Vec::new();
        each!(self, d => d.outputs(&mut |part| placed.extend(match part {
            PlacedPart::Point(point) => Some(state.points[point.index()].p),
            PlacedPart::Link(link) => Some(state.links[link.index()].d),
            PlacedPart::Slide(_) => None,
        })));
        placed.into_iter()
    }
}
