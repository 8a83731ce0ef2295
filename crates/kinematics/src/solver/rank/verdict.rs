//! Determines the rank at assembled poses, for a whole mechanism and for the coupled groups of one
//! that opened.

use super::MAX_UNKNOWNS;
use super::assemble::{Assembled, assemble, rough};
use super::exchange;
use super::redundancy::{pose_of, reached};
use super::rows::Rows;
use super::spectrum::{self, IndependentRows, Spectrum};
use crate::solver::Solver;
use crate::solver::frame::Frame;
use crate::solver::plan::network::{Network, ScalarEquation, ScalarUnknown};
use crate::solver::plan::order::{self, CoupledBlock};
use crate::solver::plan::{Group, GroupKind};
use crate::{ElementId, LinkId, PointId, Vec2};
use nalgebra::DMatrix;

/// Maximum number of initial poses, and the maximum work on them, in cubes of unknowns.
const MAX_TRIALS: usize = 12;
const TRIAL_WORK: usize = 100_000_000;
/// Offsets from the start to other positions of the driver, in radians or scaled lengths. They are
/// large enough for a singular value to leave zero and small enough for the pose to be tracked.
const PLACES: [f64; 4] = [0.03, -0.03, 0.11, -0.11];
/// Number of these positions to examine.
const EXAMINED_POSITIONS: usize = 2;
/// Maximum number of unknowns of a coupled group for an examination whenever a mechanism opens.
const MAX_GROUP_SIZE: usize = 150;
/// Maximum rotation of a row by rounding, in radians.
const MAX_ROW_ROTATION: f64 = 1e-8;
/// Step from pose to pose towards a distant position, and the maximum number of steps: some turns.
const STRIDE: f64 = 0.05;
const MAX_STRIDES: f64 = 1000.0;

/// The result of the rank analysis of all constraints of an assembled mechanism.
#[derive(Clone, Debug)]
pub(in crate::solver) struct RankVerdict {
    /// The number of inputs.
    inputs: usize,
    /// The number of motions that the inputs leave free.
    pub(super) free: usize,
    /// Whether the driver itself is locked.
    pub(super) is_held: bool,
    /// The number of redundant constraints.
    pub(super) redundant: usize,
    /// The elements of the redundant constraints and of those that they repeat.
    pub(super) repeating: Vec<ElementId>,
    /// The links that can move while the driver is fixed.
    pub(super) floating: Vec<LinkId>,
    /// The choices of constraints to set aside; the one that leaves the least work comes first.
    pub(super) set_aside: Vec<Vec<ScalarEquation>>,
    /// Whether more is free at the start than elsewhere.
    pub(super) is_change_point: bool,
    /// Whether a singular value is close to zero.
    pub(super) is_unclear: bool,
    /// The positions of the moving points when all constraints hold, in the scene's unit and frame.
    pub(super) places: Vec<(PointId, Vec2)>,
}

impl RankVerdict {
    /// Returns the degrees of freedom, including those of the inputs.
    pub(super) fn mobility(&self) -> usize {
        (self.inputs + self.free).saturating_sub(usize::from(self.is_held))
    }
}

/// All constraints of a mechanism, assembled at the start.
pub(super) struct AllConstraints<'n> {
    rows: Rows<'n>,
    at: f64,
    /// The accepted disagreement, in the solver's unit.
    misfit: f64,
    start: Assembled,
}

impl<'n> AllConstraints<'n> {
    /// Assembles all constraints from approximate positions; returns `None` if that fails.
    pub(super) fn new(
        network: &'n Network<'n>,
        at: f64,
        near: &[(PointId, Vec2)],
    ) -> Option<AllConstraints<'n>> {
        let frame = Frame::of(network.mechanism);
        let rows = Rows::new(network, frame, network.rows.clone(), all_unknowns(network));
        if rows.width == 0 || rows.rows.is_empty() {
            return None;
        }
        let misfit = frame.length(network.mechanism.misfit());
        let trials = (TRIAL_WORK / rows.width.pow(3)).clamp(1, MAX_TRIALS);
        let mut rough = (0..trials).map(|trial| rough(&rows, at, near, trial));
        let start = rough.find_map(|pose| assemble(&rows, at, misfit, pose))?;
        Some(AllConstraints {
            at,
            misfit,
            start,
            rows,
        })
    }

    /// Returns the verdict with the maximum rank of the start and of positions near it.
    pub(super) fn verdict(&self) -> Option<RankVerdict> {
        let found = self.rank_at(self.at, &self.start)?;
        let nearby = PLACES.iter().filter_map(|&by| {
            let at = moved(&self.rows, self.at, by);
            let there = assemble(&self.rows, at, self.misfit, self.start.pose.clone())?;
            self.rank_at(at, &there)
        });
        let minimum = found.rank;
        // Independent columns already have the maximum rank.
        let places = if minimum < self.rows.width {
            EXAMINED_POSITIONS
        } else {
            0
        };
        // The first maximum wins, so that the start is preferred.
        let best =
            nearby.take(places).fold(
                found,
                |best, other| {
                    if other.rank > best.rank { other } else { best }
                },
            );
        Some(RankVerdict {
            is_change_point: best.rank > minimum,
            places: self.places(),
            ..best.verdict(&self.rows)
        })
    }

    /// Returns the choices of constraints to set aside at another coordinate of the driver, or
    /// `None` if the mechanism cannot be assembled there.
    pub(super) fn set_aside_at(&self, at: f64) -> Option<Vec<Vec<ScalarEquation>>> {
        let way = (at - self.at) / moved(&self.rows, 0.0, STRIDE);
        if !(way.abs() < MAX_STRIDES) {
            return None;
        }
        let strides = way.abs().ceil().max(1.0);
        let mut here = self.start.pose.clone();
        let mut there = None;
        let mut k = 0.0;
        while k < strides {
            k += 1.0;
            let on_the_way = if k < strides {
                self.at + (at - self.at) * k / strides
            } else {
                at
            };
            let found = assemble(&self.rows, on_the_way, self.misfit, here)?;
            here = found.pose.clone();
            there = Some(found);
        }
        let judged = self.rank_at(at, &there?)?;
        Some(judged.verdict(&self.rows).set_aside)
    }

    /// Returns the positions of the moving points at the start, in the scene's unit and frame.
    fn places(&self) -> Vec<(PointId, Vec2)> {
        let (network, pose) = (self.rows.network, &self.start.pose);
        let mut places = Vec::new();
        for point in network.mechanism.point_ids() {
            let links = &network.mechanism.point(point).links;
            let position = match links.first() {
                _ if network.is_ground(point) => continue,
                Some(&link) if !network.is_joint(point) => self.rows.rider(link, point, pose),
                _ => pose.points[point.index()],
            };
            places.push((point, self.rows.frame.place(position)));
        }
        places
    }

    fn rank_at(&self, at: f64, found: &Assembled) -> Option<PoseRank> {
        PoseRank::of(&self.rows, at, found, self.misfit)
    }
}

/// Returns coordinates of the driver near the given one.
pub(super) fn nearby_coordinates(network: &Network<'_>, at: f64) -> impl Iterator<Item = f64> {
    let rows = Rows::new(network, network.frame, Vec::new(), []);
    PLACES.into_iter().map(move |by| moved(&rows, at, by))
}

/// Moves a coordinate of the driver by radians or scaled lengths.
fn moved(rows: &Rows<'_>, at: f64, by: f64) -> f64 {
    match rows.network.mechanism.driver().input {
        crate::Input::Turn(_) => at + by.to_degrees(),
        crate::Input::Push(_) => at + by * rows.frame.scale,
    }
}

/// Returns `true` if a mechanism has too many unknowns for a decomposition.
pub(super) fn is_too_large(network: &Network<'_>) -> bool {
    let scalars = all_unknowns(network)
        .into_iter()
        .map(|unknown| match unknown {
            ScalarUnknown::Point(_) => 2,
            ScalarUnknown::Class(_) => 1,
        });
    // Links of one class are counted more than once; the error is acceptable here.
    scalars.sum::<usize>() > MAX_UNKNOWNS
}

/// Returns every unknown of a mechanism.
fn all_unknowns(network: &Network<'_>) -> Vec<ScalarUnknown> {
    let mechanism = network.mechanism;
    let classes = mechanism.link_ids().map(|link| network.class(link));
    let classes = classes.filter(|&class| !network.is_given(class));
    let points = mechanism.point_ids();
    let points = points.filter(|&p| network.is_joint(p) && !network.is_ground(p));
    classes
        .map(ScalarUnknown::Class)
        .chain(points.map(ScalarUnknown::Point))
        .collect()
}

/// The rank at one pose.
struct PoseRank {
    matrix: DMatrix<f64>,
    rank: usize,
    is_held: bool,
    is_unclear: bool,
    /// A share below this is rounding error.
    noise: f64,
}

impl PoseRank {
    fn of(rows: &Rows<'_>, at: f64, found: &Assembled, misfit: f64) -> Option<PoseRank> {
        let [slack, confirm_reason] = turned(rows, found.slack, misfit);
        let complete = rows.matrix(at, &found.pose);
        let matrix = complete.columns(0, rows.width).into_owned();
        let spectrum = Spectrum::of(&matrix, slack, confirm_reason)?;
        let is_held = if spectrum.rank == rows.width {
            spectrum::residual(&complete) > spectrum.noise
        } else {
            Spectrum::of(&complete, slack, confirm_reason)?.rank > spectrum.rank
        };
        Some(PoseRank {
            matrix,
            rank: spectrum.rank,
            is_held,
            is_unclear: spectrum.is_unclear,
            noise: spectrum.noise,
        })
    }

    fn verdict(&self, rows: &Rows<'_>) -> RankVerdict {
        let readiness = |&row: &ScalarEquation| rows.network.readiness(row);
        let readiness: Vec<u8> = rows.rows.iter().map(readiness).collect();
        let choice = spectrum::choose(&self.matrix, self.rank, &readiness);
        let choices = if self.rank == rows.width {
            exchange::smaller(rows, &self.matrix, &choice)
        } else {
            vec![choice]
        };
        let named =
            |choice: &IndependentRows| choice.set_aside.iter().map(|&i| rows.rows[i]).collect();
        let set_aside = choices.iter().map(named).collect();
        let choice = &choices[choices.len() - 1];
        let shares = spectrum::free_shares(&self.matrix, &choice.kept, self.noise);
        let floats = |link: &LinkId| rows.share(*link, |column| shares[column]) > 0.0;
        let links = rows.network.mechanism.link_ids();
        let repeating = choice.repeating(self.noise);
        let repeating: Vec<ScalarEquation> = repeating.into_iter().map(|i| rows.rows[i]).collect();
        RankVerdict {
            inputs: rows.network.mechanism.inputs().count(),
            free: rows.width - self.rank,
            is_held: self.is_held,
            redundant: rows.rows.len() - self.rank,
            repeating: order::elements(&repeating),
            floating: links.filter(floats).collect(),
            set_aside,
            is_change_point: false,
            is_unclear: self.is_unclear,
            places: Vec::new(),
        }
    }
}

/// Ratio of the smallest singular value of a group to the largest one below which the group is almost
/// singular. Newton's method leaves about half of the digits where the driver does not determine it.
const ALMOST_SINGULAR: f64 = 1e-6;

/// The result of the rank analysis of a mechanism's coupled groups.
#[derive(Clone, Debug, Default)]
pub(super) struct Groups {
    /// The elements of a group that is singular at every examined position.
    pub(super) singular: Option<Vec<ElementId>>,
    /// The elements of a group that is almost singular at the start.
    pub(super) almost_singular: Option<Vec<ElementId>>,
    pub(super) is_unclear: bool,
    pub(super) is_lower_at_start: bool,
}

/// Examines every coupled group at the start and, if it is singular there, elsewhere.
pub(super) fn groups(network: &Network<'_>, solver: &Solver) -> Groups {
    let mut found = Groups::default();
    let is_coupled = |g: &&Group| matches!(g.kind, GroupKind::Coupled { .. });
    for group in solver.plan.groups.iter().filter(is_coupled) {
        let Some(block) = block_of(network, solver, group) else {
            continue;
        };
        let rows = block.rows.clone();
        let unknowns = block.unknowns.iter().copied();
        let rows = Rows::new(network, solver.engine.frame, rows, unknowns);
        if rows.width > MAX_GROUP_SIZE {
            continue;
        }
        let mut spectra = reached(solver).filter_map(|state| {
            let pose = pose_of(network, &state);
            let reach = pose.points.iter().map(|p| p.norm()).fold(1.0, f64::max);
            let misfit = solver.engine.frame.length(network.mechanism.misfit());
            let [slack, confirm_reason] = turned(&rows, 4.0 * f64::EPSILON * reach, misfit);
            let matrix = rows.matrix(state.at, &pose);
            Spectrum::of(
                &matrix.columns(0, rows.width).into_owned(),
                slack,
                confirm_reason,
            )
        });
        let Some(start) = spectra.next() else {
            // Not even the start can be solved.
            found.almost_singular = Some(order::elements(&block.rows));
            continue;
        };
        found.is_unclear |= start.is_unclear;
        if start.ratio < ALMOST_SINGULAR {
            found.almost_singular = Some(order::elements(&block.rows));
        }
        if start.rank < rows.width {
            let is_lower = spectra.any(|there| there.rank > start.rank);
            found.is_lower_at_start |= is_lower;
            if !is_lower {
                found.singular = Some(order::elements(&block.rows));
            }
        }
    }
    found
}

/// Returns the block of equations from which a group was made.
fn block_of<'s>(
    network: &Network<'_>,
    solver: &'s Solver,
    group: &Group,
) -> Option<&'s CoupledBlock> {
    let mut blocks = solver.ordering.blocks.iter();
    blocks.find(|block| {
        block.unknowns.iter().any(|unknown| match *unknown {
            ScalarUnknown::Point(point) => group.point == Some(point),
            ScalarUnknown::Class(class) => {
                let first = group.links.first();
                group.point.is_none() && first.is_some_and(|&l| network.class(l) == class)
            }
        })
    })
}

/// Returns the rotation of rows due to the slack of joints and due to the accepted disagreement, in
/// radians.
///
/// Rounding is assumed to rotate no row by more than [`MAX_ROW_ROTATION`]. For shorter links, the assembled
/// pose counts as exact, for a mechanism that equals the drawn one up to rounding.
fn turned(rows: &Rows<'_>, slack: f64, misfit: f64) -> [f64; 2] {
    let arm = shortest(rows);
    let confirm_reason = misfit / arm;
    [
        (slack / arm).min(MAX_ROW_ROTATION.max(confirm_reason)),
        confirm_reason,
    ]
}

/// Returns the minimum distance of two joints of a link, in the solver's unit. It determines how
/// much a joint's slack rotates the link.
fn shortest(rows: &Rows<'_>) -> f64 {
    let mut shortest = f64::INFINITY;
    for &row in &rows.rows {
        if let ScalarEquation::Along { link, end } = row
            && let Some(centre) = rows.network.centre(link)
        {
            let arm = (rows.local(link, end) - rows.local(link, centre)).norm();
            shortest = if arm > 0.0 {
                shortest.min(arm)
            } else {
                shortest
            };
        }
    }
    if shortest.is_finite() { shortest } else { 1.0 }
}
