#![doc = include_str!("../../guide/coupled.md")]

mod build;
mod by_length;
mod comparison;
mod curve_series;
mod curve_tracing;
mod enclose;
mod equations;
mod exact_fold;
mod exchange;

mod double_double_refinement;
mod exact_meeting;
mod levenberg_marquardt;
mod newton_system;
mod opening;
mod reactions;
mod series;
mod singular;

pub(super) use comparison::ClosingCondition;
pub(super) use curve_series::{BRANCHES, CurvePlace};
pub(super) use curve_tracing::{EQUALITY_TOLERANCE, distance};
pub(super) use enclose::Views;
pub use newton_system::{Newton, NewtonRow, NewtonUnknown};
pub(super) use opening::{Opening, OpeningSeries};

use super::further_inputs::Following;
use super::lu;
use super::plan::network::{ClassId, Network};
use super::plan::pruning::PlacedPart;
use super::state::State;
use crate::{Constant, LinkId, Number, PointId, SlideId, Vec2};
use build::GroupMaker;
pub(super) use exact_fold::{ExactFold, FoldResiduals};
pub(super) use series::Branch;
pub(super) use singular::{Correction, Crossing, Fold};

/// Maximum number of Newton corrections. Quadratic convergence from a nearby start needs fewer.
const CORRECTIONS: usize = 24;
/// Maximum size of the last correction of a solved group: the square root of the rounding error.
/// One more correction would be below the rounding error itself.
const MAX_LAST_CORRECTION: f64 = 1.5e-8;
/// Size of a correction below which the iteration ends: 4 u, in scaled lengths and radians. Further
/// corrections change nothing.
const CORRECTION_TOLERANCE: f64 = 4.0 * 0.5 * f64::EPSILON;
/// Maximum change of a joint or an angle in one correction: half a link length, or half a radian.
const MAX_CORRECTION: f64 = 0.5;

/// The base of a joint's position.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Base {
    /// A point placed by an earlier group.
    Known(PointId),
    /// The free joint with this number.
    Free(usize),
}

/// The link or class that turns a joint's arm.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Turning {
    /// A link placed by an earlier group.
    Known(LinkId),
    /// The class with this number; the arm is given in its frame.
    Unknown(usize),
}

impl Turning {
    fn known(self) -> Option<LinkId> {
        match self {
            Turning::Known(link) => Some(link),
            Turning::Unknown(_) => None,
        }
    }

    fn unknown(self) -> Option<usize> {
        match self {
            Turning::Known(_) => None,
            Turning::Unknown(class) => Some(class),
        }
    }
}

/// The position of a joint: `base + R (arm + along p)`, with p the coordinate of the input that
/// pushes the joint, if any.
#[derive(Clone, Debug)]
struct Spot {
    base: Base,
    arm: Option<(Turning, Vec2<Constant>)>,
    along: Vec2<Constant>,
    /// How that input follows the driver; if `None`, p is the driver's coordinate.
    following: Option<Following>,
    /// The link that carries the joint, if the joint has an arm on one.
    seat: Option<ArmSeat>,
}

impl Spot {
    fn has_free_base(&self) -> bool {
        matches!(self.base, Base::Free(_))
    }

    /// Returns the vector from the base to the joint, in the frame that turns the arm, with the
    /// driver's coordinate at `q`.
    #[inline(always)]
    fn reach<T: Number>(&self, arm: Vec2<Constant>, q: T) -> Vec2<T> {
        let p = match &self.following {
            None => q,
            Some(following) => following.at(q).p,
        };
        Vec2::of(arm) + Vec2::of(self.along) * p
    }

    fn vary(&mut self, place: &mut impl FnMut(&mut Vec2<Constant>)) {
        if let Some((_, arm)) = &mut self.arm {
            place(arm);
        }
    }
}

/// The joints between which a spot's arm lies on its link. A force at the spot acts on the link at
/// these joints.
#[derive(Clone, Copy, Debug)]
struct ArmSeat {
    link: LinkId,
    /// The joint at the start of the arm.
    foot: PointId,
    /// The joint at the end of the arm; `None` at the point of a guide.
    end: Option<PointId>,
}

#[derive(Clone, Debug)]
enum GroupEquation {
    Distance {
        a: Spot,
        b: Spot,
        /// The vector from b to a, in the bar's frame.
        span: Vec2<Constant>,
        /// The length of `span`.
        length: Constant,
        /// The bar, with its joints at a and b.
        bar: (LinkId, [PointId; 2]),
    },
    Meeting {
        a: Spot,
        b: Spot,
        /// The driven slide that the equation describes, if any.
        pushed: Option<SlideId>,
    },
    Slot {
        x: Spot,
        q: Spot,
        along: Vec2<Constant>,
        turning: Turning,
        slide: SlideId,
    },
    /// The angle between two links equals the coordinate of an input.
    Elbow {
        link: Bearing,
        from: Bearing,
        /// How that input follows the driver; if `None`, the input is the driver.
        following: Option<Following>,
    },
}

/// The direction of a link: that of a known link or of its class, rotated by `turn`.
#[derive(Clone, Copy, Debug)]
struct Bearing {
    link: LinkId,
    turning: Turning,
    turn: Vec2<Constant>,
}

/// The part of a network from which a coupled group is built.
pub(super) struct Remainder<'a> {
    pub network: &'a Network<'a>,
    pub point_known: &'a [bool],
    pub class_known: &'a [bool],
    pub points: &'a [PointId],
    pub classes: &'a [ClassId],
    pub links: &'a [LinkId],
    pub slides: &'a [SlideId],
    /// Links turned by an input relative to another link.
    pub elbows: &'a [LinkId],
    /// Points of guides, by slide: those of all guides on the ground, and some others.
    pub guide_points: &'a [Option<PointId>],
}

/// A coupled group.
#[derive(Clone, Debug)]
pub(super) struct Coupled {
    /// The joints placed by the group, with their spots.
    spots: Vec<(PointId, Spot)>,
    /// One link of every class of unknown direction.
    turning: Vec<LinkId>,
    /// The direction of each of these links relative to its class, as a unit vector.
    turns: Vec<Vec2<Constant>>,
    free: usize,
    equations: Vec<GroupEquation>,
    /// The start of the group's numbers in the scratch.
    pub offset: usize,
    /// The group's index in the plan. Its sign is stored there, and changes where the motion passes
    /// through a change point.
    pub group: usize,
    /// The sign of the determinant of the group's matrix, constant along a motion without
    /// singularities. It distinguishes two solutions that meet at a limit. 0 before the group is
    /// assembled.
    pub side: f64,
}

/// The outcome of Newton's corrections.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Corrected {
    /// The largest component of the first correction.
    pub first: f64,
    /// The sign of the determinant before the last correction.
    pub side: f64,
    pub settled: bool,
}

/// Position, velocity and acceleration of a spot, at given z' and z''.
#[derive(Clone, Copy, Default)]
struct SpotMotion<T = f64> {
    p: Vec2<T>,
    v: Vec2<T>,
    a: Vec2<T>,
}

/// Buffers for all coupled groups, allocated once.
#[derive(Debug, Default)]
pub(super) struct Scratch<T = f64> {
    pub numbers: Vec<T>,
    pub pivots: Vec<usize>,
    /// The size of every group's first correction when it was last solved.
    pub first: Vec<f64>,
    /// The maximum size of every group's first correction. A larger one is not solved further.
    pub max_first: Vec<f64>,
    /// Buffer for bounds, and for the matrix in doubles during refinement.
    pub work: Vec<f64>,
}

impl<T: Copy> Clone for Scratch<T> {
    fn clone(&self) -> Scratch<T> {
        Scratch {
            numbers: self.numbers.clone(),
            pivots: self.pivots.clone(),
            first: self.first.clone(),
            max_first: self.max_first.clone(),
            work: self.work.clone(),
        }
    }

    fn clone_from(&mut self, other: &Scratch<T>) {
        let Scratch {
            numbers,
            pivots,
            first,
            max_first,
            work,
        } = self;
        numbers.clone_from(&other.numbers);
        pivots.clone_from(&other.pivots);
        first.clone_from(&other.first);
        max_first.clone_from(&other.max_first);
        work.clone_from(&other.work);
    }
}

/// One group's part of the scratch: z with its derivatives z' and z'', the matrix and the right
/// side. In z, free joints are coordinates and angles are unit vectors; z' and z'' hold the rates
/// of the angles.
pub(super) struct GroupScratch<'a, T = f64> {
    pub z: &'a mut [T],
    pub first: &'a mut [T],
    pub second: &'a mut [T],
    matrix: &'a mut [T],
    right: &'a mut [T],
    pivots: &'a mut [usize],
}

impl Coupled {
    /// Chooses the unknowns and lists the equations. Returns `None` if their numbers differ.
    pub(super) fn new(part: &Remainder<'_>) -> Option<Coupled> {
        let mut builder = GroupMaker::new(part);
        builder.place_joints();
        builder.list_equations();
        let GroupMaker {
            spots,
            turning,
            turns,
            free,
            equations,
            ..
        } = builder;
        let group = Coupled {
            spots,
            turning,
            turns,
            free,
            equations,
            offset: 0,
            group: 0,
            side: 0.0,
        };
        let count: usize = group.equations.iter().map(GroupEquation::count).sum();
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

    /// Reports every point and link placed by the group.
    pub(super) fn outputs(&self, places: &mut impl FnMut(PlacedPart)) {
        self.joints()
            .for_each(|point| places(PlacedPart::Point(point)));
        let turning = self.turning.iter();
        turning.for_each(|&link| places(PlacedPart::Link(link)));
    }

    /// Reports every point and link of earlier groups that the group reads.
    pub(super) fn reads(&self, reads: &mut impl FnMut(PlacedPart)) {
        let (points, links) = self.inputs();
        points.into_iter().for_each(|p| reads(PlacedPart::Point(p)));
        links.into_iter().for_each(|l| reads(PlacedPart::Link(l)));
    }

    /// Passes every arm and span of the group to `place`; see
    /// [`Element::vary`](super::elements::Element::vary).
    pub(super) fn vary(&mut self, place: &mut impl FnMut(&mut Vec2<Constant>)) {
        self.spots.iter_mut().for_each(|(_, spot)| spot.vary(place));
        for equation in &mut self.equations {
            match equation {
                GroupEquation::Distance {
                    a, b, span, length, ..
                } => {
                    a.vary(place);
                    b.vary(place);
                    place(span);
                    *length = span.norm();
                }
                GroupEquation::Meeting { a, b, .. } => {
                    a.vary(place);
                    b.vary(place);
                }
                GroupEquation::Slot { x, q, .. } => {
                    x.vary(place);
                    q.vary(place);
                }
                GroupEquation::Elbow { .. } => {}
            }
        }
    }

    /// Passes the law of every input in the group to `change`; see
    /// [`Element::change_laws`](super::elements::Element::change_laws).
    pub(super) fn change_laws(&mut self, change: &mut impl FnMut(&mut Following)) {
        let mut changed = |laws: &mut Option<Following>| laws.iter_mut().for_each(&mut *change);
        for (_, spot) in &mut self.spots {
            changed(&mut spot.following);
        }
        for equation in &mut self.equations {
            match equation {
                GroupEquation::Distance { a, b, .. } | GroupEquation::Meeting { a, b, .. } => {
                    changed(&mut a.following);
                    changed(&mut b.following);
                }
                GroupEquation::Slot { x, q, .. } => {
                    changed(&mut x.following);
                    changed(&mut q.following);
                }
                GroupEquation::Elbow { following, .. } => changed(following),
            }
        }
    }

    /// Returns the length of z: two numbers per free joint and two per direction.
    pub(super) fn width(&self) -> usize {
        2 * (self.free + self.turning.len())
    }

    /// Returns how many numbers the group needs in the scratch.
    pub(super) fn scratch_len(&self) -> usize {
        let n = self.unknowns();
        self.width() + 2 * n + n * n + n
    }

    pub(super) fn open<'a, T>(&self, scratch: &'a mut Scratch<T>) -> GroupScratch<'a, T> {
        let n = self.unknowns();
        let pivots = &mut scratch.pivots[..n];
        let own = &mut scratch.numbers[self.offset..self.offset + self.scratch_len()];
        let (z, rest) = own.split_at_mut(self.width());
        let (first, rest) = rest.split_at_mut(n);
        let (second, rest) = rest.split_at_mut(n);
        let (matrix, right) = rest.split_at_mut(n * n);
        GroupScratch {
            z,
            first,
            second,
            matrix,
            right,
            pivots,
        }
    }

    /// Moves z by dq along its first and second derivatives.
    pub(super) fn predict(&self, buffers: &mut GroupScratch<'_>, dq: f64) {
        for i in 0..self.unknowns() {
            buffers.right[i] = dq * (buffers.first[i] + 0.5 * dq * buffers.second[i]);
        }
        self.shift(buffers.z, buffers.right);
    }

    /// Returns the largest components of z' dq and of z'' dq^2 / 2.
    pub(super) fn move_sizes(&self, buffers: &GroupScratch<'_>, dq: f64) -> [f64; 2] {
        let (first, second) = (lu::largest(buffers.first), lu::largest(buffers.second));
        [first * dq.abs(), second * (0.5 * dq * dq)]
    }

    /// Adds a change of the unknowns to z.
    fn shift<T: Number>(&self, z: &mut [T], change: &[T]) {
        let joints = 2 * self.free;
        for i in 0..joints {
            z[i] += change[i];
        }
        for (i, angle) in change[joints..].iter().enumerate() {
            let at = joints + 2 * i;
            // Every arithmetic rotates by the nearest double; the next correction removes the
            // difference.
            let angle = angle.nearest();
            let by = Vec2::new(angle.cos(), angle.sin()).exactly();
            let turned = Vec2::new(z[at], z[at + 1]).turned(by);
            // One Newton step for the length keeps |d| at 1 within one or two units in the last
            // place.
            let unit = turned * (T::exactly(1.5) - turned.norm2().scaled(0.5));
            (z[at], z[at + 1]) = (unit.x, unit.y);
        }
    }

    /// Applies Newton's corrections to the z in the scratch, until a step no longer shrinks.
    pub(super) fn correct(&self, q: f64, state: &mut State, scratch: &mut Scratch) -> Corrected {
        self.correct_within(f64::INFINITY, q, state, scratch)
    }

    /// Applies Newton's corrections as [`Coupled::correct`] does, unless the first one is larger than
    /// `max_first`.
    pub(super) fn correct_within(
        &self,
        max_first: f64,
        q: f64,
        state: &mut State,
        scratch: &mut Scratch,
    ) -> Corrected {
        let mut buffers = self.open(scratch);
        let n = self.unknowns();
        let mut outcome = Corrected {
            first: f64::INFINITY,
            side: 0.0,
            settled: false,
        };
        let mut last = f64::INFINITY;
        for i in 0..CORRECTIONS {
            self.residuals(q, state, &mut buffers);
            self.jacobian(q, state, &mut buffers);
            let Some(side) = lu::factor(buffers.matrix, buffers.pivots, n) else {
                return outcome;
            };
            outcome.side = side;
            lu::solve(buffers.matrix, buffers.pivots, buffers.right, n);
            let size = lu::largest(buffers.right);
            if i == 0 {
                outcome.first = size;
                if size > max_first {
                    return outcome;
                }
            }
            // Negated so that NaN also ends the loop.
            if !(size < last || size > MAX_LAST_CORRECTION) {
                break;
            }
            let reach = if size > MAX_CORRECTION {
                MAX_CORRECTION / size
            } else {
                1.0
            };
            for v in buffers.right.iter_mut() {
                *v *= -reach;
            }
            self.shift(buffers.z, buffers.right);
            last = size;
            if size <= CORRECTION_TOLERANCE {
                break;
            }
        }
        outcome.settled =
            last <= MAX_LAST_CORRECTION && !self.is_elbow_reversed(q, state, &buffers);
        outcome
    }

    /// Computes the derivatives of z by q up to `order`, from the matrix at z, and writes all
    /// points and links of the group into the state. Returns `false` if the matrix is singular.
    pub(super) fn finish<T: Number>(
        &self,
        q: T,
        order: u8,
        state: &mut State<T>,
        scratch: &mut Scratch<T>,
    ) -> bool {
        let mut buffers = self.open(scratch);
        let n = self.unknowns();
        buffers.first.fill(T::default());
        buffers.second.fill(T::default());
        if order >= super::elements::VELOCITY {
            self.rates(q, state, &mut buffers, 1);
            self.jacobian(q, state, &mut buffers);
            if lu::factor(buffers.matrix, buffers.pivots, n).is_none() {
                return false;
            }
            lu::solve(buffers.matrix, buffers.pivots, buffers.right, n);
            negate_into(buffers.right, buffers.first);
        }
        if order >= super::elements::ACCELERATION {
            self.rates(q, state, &mut buffers, 2);
            lu::solve(buffers.matrix, buffers.pivots, buffers.right, n);
            negate_into(buffers.right, buffers.second);
        }
        self.write(q, state, &buffers);
        true
    }

    /// Returns the largest residual of the equations at the z in the scratch, as a length.
    pub(super) fn gap(&self, q: f64, state: &State, scratch: &mut Scratch) -> f64 {
        let mut buffers = self.open(scratch);
        self.residuals(q, state, &mut buffers);
        lu::largest(buffers.right)
    }

    /// Returns the points and links of earlier groups from which the group is built.
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
                GroupEquation::Distance { a, b, .. } | GroupEquation::Meeting { a, b, .. } => {
                    [a, b].map(&mut note)
                }
                GroupEquation::Slot { x, q, .. } => [x, q].map(&mut note),
                GroupEquation::Elbow { .. } => continue,
            };
        }
        for equation in &self.equations {
            let turnings = match equation {
                GroupEquation::Slot { turning, .. } => [Some(*turning), None],
                GroupEquation::Elbow { link, from, .. } => [link, from].map(|b| Some(b.turning)),
                GroupEquation::Distance { .. } | GroupEquation::Meeting { .. } => [None; 2],
            };
            links.extend(turnings.into_iter().flatten().filter_map(Turning::known));
        }
        (points, links)
    }
}

fn negate_into<T: Number>(from: &[T], to: &mut [T]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = -*from;
    }
}
