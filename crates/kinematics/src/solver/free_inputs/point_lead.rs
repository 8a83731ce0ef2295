//! Inputs that follow a point: the inverse of its position.
//!
//! Newton's method on the coordinates of the inputs. The assembly is that of the last position, and
//! the derivatives are the velocities while one input moves alone. A long way is divided, so that no
//! input jumps to another solution.
//!
//! With J the derivatives of the leading coordinates x by the inputs q, the rates follow from
//! J q' = x' and J q'' = x'' - a, with a the accelerations of the coordinates at q' alone.

use crate::mechanism::{PointLead, PointPath};
use crate::numeric::{MinimumError, lowest};
use crate::solver::free_inputs::{FreeInputs, InputMoment};
use crate::solver::plan::GroupId;
use crate::solver::state::{Condition, State};
use crate::solver::{Order, Solver};
use crate::{CoordinateAxis, Input, PointId, Vec2};
use nalgebra::{DMatrix, DVector};

/// Maximum number of Newton steps. At the edge of a workspace each step only halves the error.
const MAX_STEPS: usize = 60;
/// Maximum number of pieces of a way.
const MAX_PIECES: usize = 4000;
/// Maximum distance of two successive positions, relative to the size of the linkage.
const STRIDE: f64 = 0.05;
/// Maximum distance in the worst direction, relative to the size of the linkage and to the square of
/// the mobility. The edge of a workspace is about five times as far.
const TOWARDS_EDGE: f64 = 0.5;
/// Distance in the worst direction that is always allowed, relative to the size of the linkage: else
/// no step reaches the edge itself.
const ONTO_EDGE: f64 = 1e-4;
/// Shortest piece of a way, as a fraction of it.
const SHORTEST: f64 = 1e-4;
/// Number of pieces of a path over time, at least.
const PATH_PIECES: f64 = 64.0;
/// Maximum change of an input between two successive positions: an angle in degrees, or a length
/// relative to the size of the linkage.
const MAX_TURN: f64 = 30.0;
const MAX_PUSH: f64 = 0.5;
/// Maximum distance from the requested position, relative to the size of the linkage.
const MISS: f64 = 1e-12;
/// Largest motion of the point in its worst direction at a singular position: for a turn of one
/// radian, or a push by the size of the linkage, relative to that size. It falls with the square root
/// of the distance from the edge of the workspace.
const SINGULAR: f64 = 1e-3;
/// Mobility within which a position is on the edge of the workspace, where two solutions meet. It is
/// the square root of the accuracy of a position.
const ON_EDGE: f64 = 1e-5;
/// Maximum change of the derivatives on one solution, relative to those at one of its ends. Those of
/// another solution differ by about 2, and a turn of all links by 90 deg changes them by 1.4.
const MAX_CHANGE: f64 = 1.5;
/// Smallest share of an input in the motion that leaves a point at rest, relative to the largest.
const SHARE: f64 = 0.1;

/// A singular position of inputs that follow a point.
#[derive(Clone, Debug, PartialEq)]
pub enum LeadSingularity {
    /// The point cannot move in every direction: it is at the edge of its workspace. These inputs, by
    /// their index, move without it. The rates of the inputs do not exist.
    Serial(Vec<usize>),
    /// The group is at the limit of its assembly: it can move while all inputs are at rest.
    Parallel(GroupId),
}

/// A position of a mechanism whose inputs follow a point. Its state is [`PointLeader::state`].
#[derive(Clone, Debug, PartialEq)]
pub struct LedPose {
    /// The moments of all inputs, the driver's first. Without rates they are at rest.
    pub inputs: Vec<InputMoment>,
    /// The kind of state. Like a dead point, a serial singularity has positions but no rates.
    pub condition: Condition,
    /// The singularity, if the position is one.
    pub singularity: Option<LeadSingularity>,
    /// Largest motion of the point in its worst direction, for a turn of one radian or a push by the
    /// size of the linkage, relative to that size. It is 0 at the edge of the workspace.
    pub mobility: f64,
}

/// How far a point can follow a path.
#[derive(Clone, Debug, PartialEq)]
pub struct LedReach {
    /// The time up to which the inputs can follow, in s; that of the end if they can follow to it.
    pub until: f64,
    /// Whether the inputs can follow to the end.
    pub is_complete: bool,
    /// The minimum and maximum of each following input, in degrees or the scene's length unit.
    pub ranges: Vec<[f64; 2]>,
    /// The singular positions, with their times in s.
    pub singular: Vec<(f64, LeadSingularity)>,
}

/// A position on a path, with the inputs there.
#[derive(Clone, Debug)]
pub struct LedPosition {
    /// The time in s.
    pub time: f64,
    /// The inputs.
    pub leader: PointLeader,
    /// Their position, without rates.
    pub pose: LedPose,
}

/// A position on a path.
#[derive(Clone, Debug)]
struct PathSample {
    time: f64,
    /// The inputs before it.
    from: PointLeader,
    pose: LedPose,
    /// The mobility of the point, and the measure of the group nearest to its limit. Each is 0 at a
    /// singularity of its kind.
    margins: [f64; 2],
}

/// A piece of the way of the leading coordinates.
struct PieceOfWay {
    /// Points whose convex hull, with both ends, contains the piece.
    controls: Vec<Vec<f64>>,
    /// The leading coordinates at its end.
    targets: Vec<f64>,
    /// The coordinates of the inputs at its end; those of the inputs that follow do not count.
    held: Vec<f64>,
}

/// Moves the inputs of a mechanism so that a point is where it is led.
#[derive(Clone, Debug)]
pub struct PointLeader {
    free: FreeInputs,
    lead: PointLead,
    /// The largest distance of two points of links along an axis, where the scene opens.
    size: f64,
    /// The leading coordinates at the last kept position.
    reached: Vec<f64>,
    /// The worst direction there, in which the point moves least, and the maximum distance in it.
    worst: Option<(DVector<f64>, f64)>,
    /// Whether the inputs move the coordinates independently where the scene opens.
    is_independent: bool,
    /// The time of the last kept position on a path.
    time: Option<f64>,
    /// The time from which a path cannot be followed.
    stopped: Option<f64>,
}

impl PointLeader {
    /// Creates the inputs of a solver's mechanism, where the scene opens. `None` if it has no
    /// assembly there, or if there are not as many inputs as coordinates.
    #[must_use]
    pub fn new(solver: &Solver, lead: PointLead) -> Option<PointLeader> {
        let mut free = solver.free_inputs()?;
        let count = free.kept().len();
        let fits = lead.inputs.iter().all(|&index| index < count);
        if !fits || lead.inputs.len() != lead.coordinates.len() {
            return None;
        }
        let start = free.kept().to_vec();
        if free.moved(&start, Order::Position) == Condition::NoAssembly {
            return None;
        }
        free.keep(&start);
        let size = size_of(&free);
        let reached = lead.values(free.state())?.as_slice().to_vec();
        let mut leader = PointLeader {
            free,
            lead,
            size,
            reached,
            worst: None,
            is_independent: true,
            time: None,
            stopped: None,
        };
        let opening: Vec<InputMoment> = start.into_iter().map(InputMoment::at_rest).collect();
        if let Some(slopes) = leader.slopes(&opening) {
            leader.worst = Some(leader.worst_direction(&slopes));
            let ways = leader.comparable(slopes).singular_values();
            leader.is_independent = ways.min() > ON_EDGE * size;
        }
        Some(leader)
    }

    /// Returns `true` if the inputs move the coordinates independently where the scene opens, so that
    /// these can move in every direction.
    #[must_use]
    pub fn is_independent(&self) -> bool {
        self.is_independent
    }

    /// Returns the state of the last position.
    #[must_use]
    pub fn state(&self) -> &State {
        self.free.state()
    }

    /// Moves the coordinates on a straight line to `targets`, and the inputs that do not follow to
    /// the values of `inputs`, and solves positions there. Keeps the position, unless it is at the
    /// edge of the workspace. Returns `None` if it cannot be reached.
    pub fn move_to(&mut self, inputs: &[f64], targets: &[f64]) -> Option<LedPose> {
        let (from, held) = (self.reached.clone(), self.free.kept().to_vec());
        let between = |from: &[f64], to: &[f64], part: f64| -> Vec<f64> {
            let pairs = from.iter().zip(to);
            pairs.map(|(from, to)| from + (to - from) * part).collect()
        };
        let along = |_, part| PieceOfWay {
            controls: Vec::new(),
            targets: between(&from, targets, part),
            held: between(&held, inputs, part),
        };
        self.travel(along).1
    }

    /// Moves the leading point along its path to a time in s, and solves there with the rates of all
    /// inputs. The first call begins where the scene opens. Returns `None` if the path cannot be
    /// followed up to this time.
    ///
    /// The coordinates must be x and y of one point, in this order.
    pub fn follow(&mut self, path: &PointPath, time: f64, order: Order) -> Option<LedPose> {
        if self.stopped.is_some_and(|stopped| time >= stopped) {
            return None;
        }
        let held = self.free.kept().to_vec();
        let [first, last] = path.span();
        let mut from = match self.time {
            Some(from) => from,
            None => {
                let [at, ..] = path.at(first);
                self.time = Some(first);
                if self.move_to(&held, &[at.x, at.y]).is_none() {
                    self.stopped = Some(first);
                    return None;
                }
                first
            }
        };
        let longest = (last - first) / PATH_PIECES;
        let pose = loop {
            let to = path.smooth_end(from, time);
            let to = from + (to - from).clamp(-longest, longest);
            let is_there = to == time || from == to;
            let along = |done: f64, part: f64| {
                let [begin, end] = [done, part].map(|part| from + (to - from) * part);
                let [inner @ .., at] = path.controls(begin, end);
                PieceOfWay {
                    controls: inner.map(|at| vec![at.x, at.y]).to_vec(),
                    targets: vec![at.x, at.y],
                    held: held.clone(),
                }
            };
            let (kept, found) = self.travel(along);
            if kept > 0.0 {
                self.time = Some(if kept < 1.0 {
                    from + (to - from) * kept
                } else {
                    to
                });
            }
            let Some(found) = found else {
                if time > from {
                    self.stopped = Some(self.stopped.map_or(to, |stopped| stopped.min(to)));
                }
                return None;
            };
            if is_there {
                break found;
            }
            from = to;
        };
        match order {
            Order::Position => Some(pose),
            Order::Velocity | Order::Acceleration | Order::Force => {
                Some(self.with_rates(pose, path.at(time), order))
            }
        }
    }

    /// Solves the position at a time on a path with the rates of all inputs.
    pub fn solve_rates(
        &mut self,
        pose: LedPose,
        path: &PointPath,
        time: f64,
        order: Order,
    ) -> LedPose {
        self.with_rates(pose, path.at(time), order)
    }

    /// Solves a position with the rates of the inputs, if they exist.
    fn with_rates(&mut self, pose: LedPose, led: [Vec2; 3], order: Order) -> LedPose {
        let [_, speed, acceleration] = led.map(|v| DVector::from_column_slice(&[v.x, v.y]));
        let found = match pose.singularity {
            Some(LeadSingularity::Serial(_)) => None,
            Some(LeadSingularity::Parallel(_)) | None => {
                self.rates(&pose.inputs, &speed, &acceleration)
            }
        };
        match found {
            Some(inputs) => LedPose {
                condition: self.free.solve(&inputs, order),
                inputs,
                ..pose
            },
            None => LedPose {
                condition: self.free.without_rates(&pose.inputs),
                ..pose
            },
        }
    }

    /// Returns the moments of the inputs with their rates; `None` where these do not exist.
    fn rates(
        &mut self,
        inputs: &[InputMoment],
        speed: &DVector<f64>,
        acceleration: &DVector<f64>,
    ) -> Option<Vec<InputMoment>> {
        let parts = self.slopes(inputs)?.lu();
        let mut inputs = inputs.to_vec();
        let rates = parts.solve(speed)?;
        for (&index, &rate) in self.lead.inputs.iter().zip(&rates) {
            inputs.get_mut(index)?.speed = rate;
        }
        if self.free.solve(&inputs, Order::Acceleration) == Condition::NoAssembly {
            return None;
        }
        let own = self.lead.accelerations(self.free.state())?;
        let rates = parts.solve(&(acceleration - own))?;
        for (&index, &rate) in self.lead.inputs.iter().zip(&rates) {
            inputs.get_mut(index)?.acceleration = rate;
        }
        let are_finite =
            |moment: &InputMoment| moment.speed.is_finite() && moment.acceleration.is_finite();
        inputs.iter().all(are_finite).then_some(inputs)
    }

    /// Follows a whole path from where the scene opens, in so many equal pieces, and returns how far
    /// the inputs can follow. The end of the reach and the singular positions are found between the
    /// pieces.
    pub fn reach(self, path: &PointPath, pieces: u16) -> LedReach {
        let [_, last] = path.span();
        self.positions(path, last, pieces).0
    }

    /// Follows a path up to a time as [`PointLeader::reach`], and returns the positions at the ends of
    /// the pieces as well, solved without rates.
    pub fn positions(
        mut self,
        path: &PointPath,
        end: f64,
        pieces: u16,
    ) -> (LedReach, Vec<LedPosition>) {
        let [first, _] = path.span();
        let at = |piece: u16| match piece == pieces {
            true => end,
            false => first + (end - first) * f64::from(piece) / f64::from(pieces),
        };
        let mut reach = LedReach {
            until: first,
            is_complete: true,
            ranges: vec![[f64::INFINITY, f64::NEG_INFINITY]; self.lead.inputs.len()],
            singular: Vec::new(),
        };
        let mut samples: Vec<PathSample> = Vec::with_capacity(usize::from(pieces) + 1);
        for piece in 0..=pieces {
            let from = self.clone();
            let mut time = at(piece);
            let mut found = self.sample(path, time);
            if found.is_none() {
                reach.is_complete = false;
                if let Some(last) = samples.last() {
                    time = from.last_reached(path, last.time, time);
                    self.clone_from(&from);
                    found = self.sample(path, time);
                }
            }
            let Some((pose, margins)) = found else {
                self = from;
                break;
            };
            reach.until = time;
            let inputs = self.lead.inputs.iter().zip(&mut reach.ranges);
            for (&index, range) in inputs {
                let here = pose.inputs.get(index).map_or(f64::NAN, |input| input.at);
                *range = [range[0].min(here), range[1].max(here)];
            }
            samples.push(PathSample {
                time,
                from,
                pose,
                margins,
            });
            if !reach.is_complete {
                break;
            }
        }
        reach.singular = singular_positions(path, &samples);
        let parts = samples.into_iter().map(|s| ((s.time, s.pose), s.from));
        let (poses, leaders): (Vec<_>, Vec<_>) = parts.unzip();
        let leaders = leaders.into_iter().skip(1).chain([self]);
        let positions = poses.into_iter().zip(leaders);
        let positions = positions.map(|((time, pose), leader)| LedPosition { time, leader, pose });
        (reach, positions.collect())
    }

    /// Returns the position at a time and its margins.
    fn sample(&mut self, path: &PointPath, time: f64) -> Option<(LedPose, [f64; 2])> {
        let pose = self.follow(path, time, Order::Position)?;
        let limit = self
            .free
            .nearest_limit()
            .map_or(1.0, |(_, measure)| measure);
        let margins = [pose.mobility, limit];
        Some((pose, margins))
    }

    /// Returns the last time that can be reached, between one that can and one that cannot.
    fn last_reached(&self, path: &PointPath, mut reached: f64, mut beyond: f64) -> f64 {
        loop {
            let between = reached + 0.5 * (beyond - reached);
            if between <= reached || between >= beyond {
                return reached;
            }
            let pose = self.clone().follow(path, between, Order::Position);
            *(if pose.is_some() {
                &mut reached
            } else {
                &mut beyond
            }) = between;
        }
    }

    /// Moves in pieces: `along` returns the piece between two fractions of the way. Keeps the last
    /// regular position, and returns the fraction at which it is: 0 if there was none.
    fn travel(&mut self, along: impl Fn(f64, f64) -> PieceOfWay) -> (f64, Option<LedPose>) {
        let (mut done, mut piece, mut kept): (f64, f64, f64) = (0.0, 1.0, 0.0);
        for _ in 0..MAX_PIECES {
            let next = f64::min(done + piece, 1.0);
            let way = along(done, next);
            let found = match self.is_short(&way) {
                true => self.solved(&way.held, &way.targets),
                false => None,
            };
            match found {
                Some(pose) => {
                    if pose.is_regular() {
                        let inputs: Vec<f64> = pose.inputs.iter().map(|input| input.at).collect();
                        self.free.keep(&inputs);
                        if let Some(slopes) = self.slopes(&pose.inputs) {
                            self.worst = Some(self.worst_direction(&slopes));
                        }
                        self.reached = way.targets;
                        kept = next;
                    }
                    if next >= 1.0 {
                        return (kept, Some(pose));
                    }
                    (done, piece) = (next, 2.0 * piece);
                }
                None if piece < SHORTEST => break,
                None => piece /= 4.0,
            }
        }
        (kept, None)
    }

    /// Returns `true` if no part of a piece is far from the last kept position, or may lie beyond the
    /// edge of the workspace.
    fn is_short(&self, way: &PieceOfWay) -> bool {
        let reached = DVector::from_column_slice(&self.reached);
        way.controls.iter().chain([&way.targets]).all(|at| {
            let off = DVector::from_column_slice(at) - &reached;
            let is_inside = |(worst, limit): &(DVector<f64>, f64)| worst.dot(&off).abs() <= *limit;
            off.amax() <= STRIDE * self.size && self.worst.as_ref().is_none_or(is_inside)
        })
    }

    /// Solves a position near the last kept one; `held` has the coordinates of the inputs that do
    /// not follow.
    fn solved(&mut self, held: &[f64], targets: &[f64]) -> Option<LedPose> {
        let mut inputs: Vec<InputMoment> =
            held.iter().map(|&at| InputMoment::at_rest(at)).collect();
        for &index in &self.lead.inputs {
            inputs.get_mut(index)?.at = *self.free.kept().get(index)?;
        }
        let kept = self.free.kept().to_vec();
        let kept: Vec<InputMoment> = kept.into_iter().map(InputMoment::at_rest).collect();
        let before = self.slopes(&kept)?;
        let targets = DVector::from_column_slice(targets);
        let mut best = f64::INFINITY;
        for _ in 0..MAX_STEPS {
            let slopes = self.slopes(&inputs)?;
            let condition = self.free.solve(&inputs, Order::Position);
            if condition == Condition::NoAssembly {
                return None;
            }
            let missed = &targets - self.lead.values(self.free.state())?;
            let miss = missed.amax();
            // The rounding errors of the positions end the improvement.
            if miss <= MISS * self.size && (miss == 0.0 || miss >= 0.5 * best) {
                let is_same = is_same_branch(&before, &slopes);
                let (mobility, singularity) = self.singularity(slopes);
                return (is_same || mobility <= ON_EDGE).then_some(LedPose {
                    inputs,
                    condition,
                    singularity,
                    mobility,
                });
            }
            best = best.min(miss);
            let parts = slopes.svd(true, true);
            let largest = parts.singular_values.max();
            let change = parts.solve(&missed, f64::EPSILON * largest).ok()?;
            for (&index, change) in self.lead.inputs.iter().zip(change.iter()) {
                inputs.get_mut(index)?.at += change;
            }
            let kept = self.free.kept();
            let is_far = self.lead.inputs.iter().any(|&index| {
                let most = match self.free.mechanism().inputs().nth(index) {
                    Some(Input::Push(_)) => MAX_PUSH * self.size,
                    Some(Input::Turn(_)) | None => MAX_TURN,
                };
                let pair = inputs.get(index).zip(kept.get(index));
                // Negated so that NaN is rejected too.
                !pair.is_some_and(|(to, from)| (to.at - from).abs() <= most)
            });
            if is_far {
                return None;
            }
        }
        None
    }

    /// Returns derivatives for a turn of one radian or a push by the size of the linkage.
    fn comparable(&self, mut slopes: DMatrix<f64>) -> DMatrix<f64> {
        for (mut column, &index) in slopes.column_iter_mut().zip(&self.lead.inputs) {
            column *= match self.free.mechanism().inputs().nth(index) {
                Some(Input::Push(_)) => self.size,
                Some(Input::Turn(_)) | None => 1.0_f64.to_degrees(),
            };
        }
        slopes
    }

    /// Returns the direction in which the point moves least, and the maximum distance of the next
    /// position in it.
    fn worst_direction(&self, slopes: &DMatrix<f64>) -> (DVector<f64>, f64) {
        let parts = self.comparable(slopes.clone()).svd(true, false);
        let worst = parts.singular_values.imin();
        let mobility = parts.singular_values.min() / self.size;
        let ways = parts.u.unwrap_or_else(|| slopes.clone());
        let limit = f64::max(TOWARDS_EDGE * mobility * mobility, ONTO_EDGE);
        (ways.column(worst).into_owned(), limit * self.size)
    }

    /// Returns the mobility of the point, and the singularity of the present position if it is one.
    fn singularity(&mut self, slopes: DMatrix<f64>) -> (f64, Option<LeadSingularity>) {
        let parts = self.comparable(slopes).svd(false, true);
        let worst = parts.singular_values.imin();
        let mobility = parts.singular_values.min() / self.size;
        if mobility <= SINGULAR {
            let ways = parts.v_t.map(|ways| ways.row(worst).into_owned());
            let inputs = ways.map_or_else(Vec::new, |way| {
                let shares = self.lead.inputs.iter().zip(way.iter());
                let largest = way.amax();
                let moving = shares.filter(|(_, share)| share.abs() >= SHARE * largest);
                moving.map(|(&index, _)| index).collect()
            });
            return (mobility, Some(LeadSingularity::Serial(inputs)));
        }
        let nearest = self.free.nearest_limit();
        let parallel = nearest.filter(|(_, measure)| *measure <= SINGULAR * SINGULAR);
        let parallel = parallel.map(|(group, _)| LeadSingularity::Parallel(group));
        (mobility, parallel)
    }

    /// Returns the derivatives of the leading coordinates by the inputs that follow, each in its own
    /// unit.
    fn slopes(&mut self, inputs: &[InputMoment]) -> Option<DMatrix<f64>> {
        let count = self.lead.inputs.len();
        let mut slopes = DMatrix::zeros(count, count);
        for (column, &moved) in self.lead.inputs.iter().enumerate() {
            let moments = inputs.iter().enumerate().map(|(index, input)| InputMoment {
                speed: if index == moved { 1.0 } else { 0.0 },
                ..InputMoment::at_rest(input.at)
            });
            let moments: Vec<InputMoment> = moments.collect();
            match self.free.solve(&moments, Order::Velocity) {
                Condition::Ok => {}
                Condition::DeadPoint | Condition::ChangePoint | Condition::NoAssembly => {
                    return None;
                }
            }
            let state = self.free.state();
            for (row, &(point, axis)) in self.lead.coordinates.iter().enumerate() {
                slopes[(row, column)] = along(state.velocity(point)?, axis);
            }
        }
        Some(slopes)
    }
}

/// Returns `true` if two positions are on one solution of the inputs, from the derivatives of the
/// leading coordinates there. Where solutions meet, the determinant of the derivatives is 0, and its
/// sign tells them apart.
fn is_same_branch(before: &DMatrix<f64>, after: &DMatrix<f64>) -> bool {
    let is_same_side = before.determinant() * after.determinant() > 0.0;
    let change = after - before;
    let relative = |to: &DMatrix<f64>| {
        let inverse = to.clone().try_inverse();
        inverse.is_some_and(|inverse| (&change * inverse).singular_values().max() <= MAX_CHANGE)
    };
    is_same_side && (relative(before) || relative(after))
}

/// Returns the singular positions on a path: the minima of both margins, as far as they are
/// singular, and singular samples that are not next to one of these.
fn singular_positions(path: &PointPath, samples: &[PathSample]) -> Vec<(f64, LeadSingularity)> {
    let mut found: Vec<(f64, LeadSingularity)> = Vec::new();
    for three in samples.windows(3) {
        let [low, middle, high] = three else { continue };
        for kind in 0..middle.margins.len() {
            let [a, b, c] = [low, middle, high].map(|sample| sample.margins[kind]);
            if !(b <= a && b < c) {
                continue;
            }
            let margin = |time: f64| {
                let (_, margins) = low.from.clone().sample(path, time)?;
                Some(margins[kind])
            };
            let minimum = lowest(margin, [low.time, high.time], (middle.time, b));
            let (time, _) = minimum.unwrap_or_else(MinimumError::best);
            let sample = low.from.clone().sample(path, time);
            if let Some(singularity) = sample.and_then(|(pose, _)| pose.singularity) {
                found.push((time, singularity));
            }
        }
    }
    let [first, last] = path.span();
    let near = 2.0 * (last - first) / samples.len() as f64;
    for sample in samples {
        if let Some(singularity) = &sample.pose.singularity {
            let is_known = |(time, known): &(f64, LeadSingularity)| {
                known == singularity && (sample.time - time).abs() <= near
            };
            if !found.iter().any(is_known) {
                found.push((sample.time, singularity.clone()));
            }
        }
    }
    found.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    found
}

impl LedPose {
    /// Returns `true` if one assembly continues from here. At the edge of the workspace there are
    /// two; a group at the limit of its assembly keeps its own.
    fn is_regular(&self) -> bool {
        !matches!(self.singularity, Some(LeadSingularity::Serial(_)))
    }
}

impl PointLead {
    fn values(&self, state: &State) -> Option<DVector<f64>> {
        self.read(|point| state.position(point))
    }

    fn accelerations(&self, state: &State) -> Option<DVector<f64>> {
        self.read(|point| state.acceleration(point))
    }

    fn read(&self, of: impl Fn(PointId) -> Option<Vec2>) -> Option<DVector<f64>> {
        let coordinates = self.coordinates.iter();
        let values = coordinates.map(|&(point, axis)| Some(along(of(point)?, axis)));
        let values: Option<Vec<f64>> = values.collect();
        values.map(DVector::from_vec)
    }
}

fn along(vector: Vec2, axis: CoordinateAxis) -> f64 {
    match axis {
        CoordinateAxis::X => vector.x,
        CoordinateAxis::Y => vector.y,
    }
}

/// Returns the largest distance of two points of links along an axis.
fn size_of(free: &FreeInputs) -> f64 {
    let links = free.mechanism().links().iter();
    let members = links.flat_map(|link| &link.members);
    let positions = members.filter_map(|member| free.state().position(member.point));
    let mut ends: Option<(Vec2, Vec2)> = None;
    for at in positions {
        let (low, high) = ends.unwrap_or((at, at));
        let low = Vec2::new(low.x.min(at.x), low.y.min(at.y));
        ends = Some((low, Vec2::new(high.x.max(at.x), high.y.max(at.y))));
    }
    ends.map_or(0.0, |(low, high)| (high.x - low.x).max(high.y - low.y))
}
