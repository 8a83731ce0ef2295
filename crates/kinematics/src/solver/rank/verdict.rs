//! The rank at assembled poses: of a whole mechanism, and of the coupled groups of one that opened.

use super::MOST_UNKNOWNS;
use super::assemble::{Assembled, assemble, rough};
use super::exchange;
use super::redundancy::{pose_of, reached};
use super::rows::Rows;
use super::spectrum::{self, KeptRows, Spectrum};
use crate::solver::Solver;
use crate::solver::frame::Frame;
use crate::solver::network::{Network, ScalarEquation, ScalarUnknown};
use crate::solver::order::{self, CoupledBlock};
use crate::solver::plan::{Group, GroupKind};
use crate::{ElementId, LinkId, PointId, Vec2};
use nalgebra::DMatrix;

/// Rough poses to begin with, at the most, and the same as work: cubes of unknowns.
const MOST_TRIALS: usize = 12;
const TRIAL_WORK: usize = 100_000_000;
/// From the start to other places that the driver may reach, in radians or scaled lengths: far enough
/// for a singular value to leave zero, near enough for the pose to follow.
const PLACES: [f64; 4] = [0.03, -0.03, 0.11, -0.11];
/// So many of them are looked at.
const LOOKED_AT: usize = 2;
/// Unknowns of a coupled group that is looked at whenever a mechanism opens, at the most.
const MOST_IN_A_GROUP: usize = 150;
/// What rounding turns a row by at the most, in radians.
const ROUNDED: f64 = 1e-8;
/// From pose to pose on the way to a place further off, and how many of these there may be: some turns.
const STRIDE: f64 = 0.05;
const MOST_STRIDES: f64 = 1000.0;

/// What the constraints of a mechanism do together, where they could be put together.
#[derive(Clone, Debug)]
pub(in crate::solver) struct RankVerdict {
    /// How many inputs there are.
    inputs: usize,
    /// Motions that these leave free.
    pub(super) free: usize,
    /// Whether the driver itself cannot move.
    pub(super) is_held: bool,
    /// How many constraints repeat others.
    pub(super) redundant: usize,
    /// What these belong to, and what they repeat.
    pub(super) repeating: Vec<ElementId>,
    /// The links that move where the driver stands.
    pub(super) floating: Vec<LinkId>,
    /// The constraints to set aside: ways to choose them, the one that leaves the least work first.
    pub(super) set_aside: Vec<Vec<ScalarEquation>>,
    /// Whether more is free at the start than elsewhere.
    pub(super) is_change_point: bool,
    /// Whether a singular value is all but zero.
    pub(super) is_unclear: bool,
    /// Where the moving points are when all constraints hold, in the scene's unit and frame.
    pub(super) places: Vec<(PointId, Vec2)>,
}

impl RankVerdict {
    /// Degrees of freedom, those of the inputs included.
    pub(super) fn mobility(&self) -> usize {
        (self.inputs + self.free).saturating_sub(usize::from(self.is_held))
    }
}

/// All constraints of a mechanism, put together at the start.
pub(super) struct Whole<'n> {
    rows: Rows<'n>,
    at: f64,
    /// By how much they may miss, in the solver's unit.
    misfit: f64,
    start: Assembled,
}

impl<'n> Whole<'n> {
    /// Puts all constraints together near rough places; `None` where they do not come together.
    pub(super) fn new(
        network: &'n Network<'n>,
        at: f64,
        near: &[(PointId, Vec2)],
    ) -> Option<Whole<'n>> {
        let frame = Frame::of(network.mechanism);
        let rows = Rows::new(network, frame, network.rows.clone(), all_unknowns(network));
        if rows.width == 0 || rows.rows.is_empty() {
            return None;
        }
        let misfit = frame.length(network.mechanism.misfit());
        let trials = (TRIAL_WORK / rows.width.pow(3)).clamp(1, MOST_TRIALS);
        let mut rough = (0..trials).map(|trial| rough(&rows, at, near, trial));
        let start = rough.find_map(|pose| assemble(&rows, at, misfit, pose))?;
        Some(Whole {
            at,
            misfit,
            start,
            rows,
        })
    }

    /// What the rank says, the greatest of the start and of places beside it.
    pub(super) fn verdict(&self) -> Option<RankVerdict> {
        let found = self.judged(self.at, &self.start)?;
        let beside = PLACES.iter().filter_map(|&by| {
            let at = moved(&self.rows, self.at, by);
            let there = assemble(&self.rows, at, self.misfit, self.start.pose.clone())?;
            self.judged(at, &there)
        });
        let least = found.rank;
        // No rank is greater than that of independent columns.
        let places = if least < self.rows.width {
            LOOKED_AT
        } else {
            0
        };
        // The first of the greatest, so that the start itself is preferred.
        let best =
            beside.take(places).fold(
                found,
                |best, other| {
                    if other.rank > best.rank { other } else { best }
                },
            );
        Some(RankVerdict {
            is_change_point: best.rank > least,
            places: self.places(),
            ..best.verdict(&self.rows)
        })
    }

    /// What to set aside at another coordinate of the driver; `None` where the constraints do not come
    /// there together.
    pub(super) fn set_aside_at(&self, at: f64) -> Option<Vec<Vec<ScalarEquation>>> {
        let way = (at - self.at) / moved(&self.rows, 0.0, STRIDE);
        if !(way.abs() < MOST_STRIDES) {
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
        let judged = self.judged(at, &there?)?;
        Some(judged.verdict(&self.rows).set_aside)
    }

    /// Where the moving points are at the start, in the scene's unit and frame.
    fn places(&self) -> Vec<(PointId, Vec2)> {
        let (network, pose) = (self.rows.network, &self.start.pose);
        let mut places = Vec::new();
        for point in network.mechanism.point_ids() {
            let links = &network.mechanism.point(point).links;
            let place = match links.first() {
                _ if network.is_ground(point) => continue,
                Some(&link) if !network.is_joint(point) => self.rows.rider(link, point, pose),
                _ => pose.points[point.index()],
            };
            places.push((point, self.rows.frame.place(place)));
        }
        places
    }

    fn judged(&self, at: f64, found: &Assembled) -> Option<Judged> {
        Judged::of(&self.rows, at, found, self.misfit)
    }
}

/// Coordinates of the driver beside another one.
pub(super) fn beside(network: &Network<'_>, at: f64) -> impl Iterator<Item = f64> {
    let rows = Rows::new(network, network.frame, Vec::new(), []);
    PLACES.into_iter().map(move |by| moved(&rows, at, by))
}

/// A coordinate of the driver beside another one, by radians or scaled lengths.
fn moved(rows: &Rows<'_>, at: f64, by: f64) -> f64 {
    match rows.network.mechanism.driver().input {
        crate::Input::Turn(_) => at + by.to_degrees(),
        crate::Input::Push(_) => at + by * rows.frame.scale,
    }
}

/// Whether a mechanism has more unknowns than are decomposed.
pub(super) fn is_too_large(network: &Network<'_>) -> bool {
    let scalars = all_unknowns(network)
        .into_iter()
        .map(|unknown| match unknown {
            ScalarUnknown::Point(_) => 2,
            ScalarUnknown::Class(_) => 1,
        });
    // Links of one class count more than once, which is near enough.
    scalars.sum::<usize>() > MOST_UNKNOWNS
}

/// Every unknown of a mechanism.
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
struct Judged {
    matrix: DMatrix<f64>,
    rank: usize,
    is_held: bool,
    is_unclear: bool,
    /// A share below this is rounding.
    noise: f64,
}

impl Judged {
    fn of(rows: &Rows<'_>, at: f64, found: &Assembled, misfit: f64) -> Option<Judged> {
        let [slack, doubt] = turned(rows, found.slack, misfit);
        let whole = rows.matrix(at, &found.pose);
        let matrix = whole.columns(0, rows.width).into_owned();
        let spectrum = Spectrum::of(&matrix, slack, doubt)?;
        let is_held = if spectrum.rank == rows.width {
            spectrum::apart(&whole) > spectrum.noise
        } else {
            Spectrum::of(&whole, slack, doubt)?.rank > spectrum.rank
        };
        Some(Judged {
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
        let named = |choice: &KeptRows| choice.set_aside.iter().map(|&i| rows.rows[i]).collect();
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

/// What the rank says of the coupled groups of a mechanism that opened.
#[derive(Clone, Debug, Default)]
pub(super) struct Groups {
    /// The elements of one that is singular wherever it was looked at.
    pub(super) singular: Option<Vec<ElementId>>,
    pub(super) is_unclear: bool,
    pub(super) is_lower_at_start: bool,
}

/// Looks at every coupled group at the start, and where it is singular there, elsewhere.
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
        if rows.width > MOST_IN_A_GROUP {
            continue;
        }
        let mut spectra = reached(solver).filter_map(|state| {
            let pose = pose_of(network, &state);
            let reach = pose.points.iter().map(|p| p.norm()).fold(1.0, f64::max);
            let misfit = solver.engine.frame.length(network.mechanism.misfit());
            let [slack, doubt] = turned(&rows, 4.0 * f64::EPSILON * reach, misfit);
            let matrix = rows.matrix(state.at, &pose);
            Spectrum::of(&matrix.columns(0, rows.width).into_owned(), slack, doubt)
        });
        let Some(start) = spectra.next() else {
            continue;
        };
        found.is_unclear |= start.is_unclear;
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

/// The block of equations that a group was made from.
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

/// By how much rows are turned by the slack of joints, and by the misfit that is accepted, in radians. Rounding turns
/// none by more than [`ROUNDED`]: where a link is shorter than that the pose that was found is taken for exact,
/// of a mechanism that is the drawn one but for rounding.
fn turned(rows: &Rows<'_>, slack: f64, misfit: f64) -> [f64; 2] {
    let arm = shortest(rows);
    let doubt = misfit / arm;
    [(slack / arm).min(ROUNDED.max(doubt)), doubt]
}

/// The shortest distance of two joints of a link, in the solver's unit: what a slack of theirs makes of
/// its direction.
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
