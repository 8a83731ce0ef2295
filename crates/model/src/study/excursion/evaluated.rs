//! Computes cycle figures of a mechanism, and of others of its kind.

use super::cycle_figure::{CycleFigureSource, FigureProperty, RangeEnd};
use super::{CycleFigure, Excursion, ExcursionOptions, FigurePlace, NoFigure};
use crate::expression::DirectionCut;
use crate::quantity::{Quantity, Subject, demand};
use crate::solver::{Condition, GroupId, Range, Solver, Transmission};

/// The best transmission angle, in degrees.
const BEST: f64 = 90.0;
/// The distance from the extreme value up to which other extrema are pieces of a figure, relative to
/// the stroke; and that of transmission angles, in degrees.
const NEAR_EXTREME: f64 = 0.1;
const NEAR_ANGLE: f64 = 10.0;
/// Maximum number of extrema of one kind that are pieces.
const MAX_EXTREMA: usize = 4;

/// Cycle figures computed together, for one mechanism or for many with the same parts. Their
/// requirements are determined once.
#[derive(Clone, Debug)]
pub struct CycleFigures {
    figures: Vec<CycleFigure>,
    /// The columns to follow, each once.
    columns: Vec<Quantity>,
    options: ExcursionOptions,
    transmission: bool,
    condition: bool,
}

/// Figures of a mechanism.
#[derive(Clone, Debug)]
pub(crate) struct EvaluatedFigures {
    /// Each figure, or the reason for its absence.
    pub(crate) values: Vec<Result<f64, NoFigure>>,
    /// The places of all figures; `None` if one has none.
    pub(crate) places: Option<Vec<PlacedFigure>>,
}

/// A figure that is a value at one place, or the difference of two.
#[derive(Clone, Debug)]
pub(crate) struct PlacedFigure {
    /// The value.
    pub(crate) value: PlacedValue,
    /// The driver's coordinates at which the value is taken, with signs.
    pub(crate) places: Vec<(f64, f64)>,
    /// What a value at any other place tells about the figure.
    pub(crate) bound: PlacedBound,
}

/// A figure as the maximum or the minimum of smooth functions of the lengths.
#[derive(Clone, Debug)]
pub(crate) struct FigurePieces {
    /// Whether the figure is the maximum or the minimum of its pieces.
    pub(crate) kind: PieceKind,
    /// The pieces near the figure; the first one equals the figure.
    pub(crate) pieces: Vec<FigurePiece>,
}

/// The relation between a figure and its pieces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PieceKind {
    /// The figure is the maximum of its pieces. A single piece is its own maximum.
    Maximum,
    /// The figure is the minimum of its pieces.
    Minimum,
}

/// A smooth function of the lengths.
#[derive(Clone, Debug)]
pub(crate) struct FigurePiece {
    /// The extrema on which it depends.
    pub(crate) placed: PlacedFigure,
    pub(crate) value: f64,
}

/// The relation between a figure and the value at any place of the motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PlacedBound {
    /// The figure is at most the value, as a minimum is.
    AtMost,
    /// The figure is at least the value, as a maximum or a stroke is.
    AtLeast,
    /// The figure is the value at its own place.
    Exact,
    /// Nothing: a direction may differ from its figure by a turn.
    Unknown,
}

/// A value of a state from which a figure is computed.
#[derive(Clone, Debug)]
pub(crate) enum PlacedValue {
    /// A column.
    Column(Quantity),
    /// The transmission angle of a dyad.
    Transmission(GroupId),
}

impl CycleFigures {
    /// Creates a set of figures in order. `tolerance` is that of dwells, in the figure's own unit;
    /// the default is a hundredth of the stroke.
    #[must_use]
    pub fn new(figures: Vec<CycleFigure>, tolerance: Option<f64>) -> CycleFigures {
        let mut all = CycleFigures {
            columns: Vec::new(),
            options: ExcursionOptions {
                tolerance,
                ..ExcursionOptions::default()
            },
            transmission: false,
            condition: false,
            figures: Vec::new(),
        };
        for figure in &figures {
            all.add_figure(figure);
        }
        all.figures = figures;
        all
    }

    fn add_figure(&mut self, figure: &CycleFigure) {
        match &figure.source {
            CycleFigureSource::Of(_, FigureProperty::At(_)) | CycleFigureSource::Range(_) => {}
            CycleFigureSource::Of(column, property) => {
                if !self.columns.contains(column) {
                    self.columns.push(column.clone());
                }
                self.options.rates |= matches!(
                    property,
                    FigureProperty::Fastest
                        | FigureProperty::FastestAt
                        | FigureProperty::Hardest
                        | FigureProperty::HardestAt
                );
                self.options.dwells |= matches!(property, FigureProperty::Dwell);
            }
            CycleFigureSource::Transmission(_) => self.transmission = true,
            CycleFigureSource::Condition(_) => self.condition = true,
        }
    }

    /// Returns a set of other figures with the tolerance of this one.
    pub(crate) fn with_figures(&self, figures: Vec<CycleFigure>) -> CycleFigures {
        CycleFigures::new(figures, self.options.tolerance)
    }

    /// Returns the figures, in their order.
    #[must_use]
    pub fn figures(&self) -> &[CycleFigure] {
        &self.figures
    }

    /// Computes the figures for a mechanism; each is a value, or the reason for its absence.
    #[must_use]
    pub fn of(&self, solver: &Solver) -> Vec<Result<f64, NoFigure>> {
        self.evaluate(solver).values
    }

    /// Computes the figures for a mechanism, and the places of the motion that they depend on.
    pub(crate) fn evaluate(&self, solver: &Solver) -> EvaluatedFigures {
        let excursions = Excursion::of_all(solver, &self.columns, self.options);
        let transmission = self.transmission(solver);
        let places = self.places(solver, &excursions, &transmission);
        let transmission: Vec<(GroupId, f64)> = transmission
            .iter()
            .map(|found| (found.group, transmission_figure(found)))
            .collect();
        let condition = match self.condition {
            true => solver.conditioning(),
            false => Vec::new(),
        };
        let condition: Vec<(GroupId, f64)> = condition
            .iter()
            .map(|found| (found.group, found.least))
            .collect();
        let value = |figure: &CycleFigure| match &figure.source {
            CycleFigureSource::Of(column, FigureProperty::At(at)) => at_place(solver, column, *at),
            CycleFigureSource::Of(column, property) => {
                let found = self.excursion(column, &excursions);
                found.map_or(Err(NoFigure::Stands), |excursion| {
                    property.of(excursion.as_ref().map_err(|&why| why)?)
                })
            }
            CycleFigureSource::Range(end) => end.of(solver.motion().range),
            CycleFigureSource::Transmission(group) => {
                worst(solver, &transmission, *group).ok_or(NoFigure::NoDyad)
            }
            CycleFigureSource::Condition(group) => {
                worst(solver, &condition, *group).ok_or(NoFigure::NoCoupledGroup)
            }
        };
        EvaluatedFigures {
            values: self.figures.iter().map(value).collect(),
            places,
        }
    }

    /// Returns the transmission angles if a figure needs them.
    fn transmission(&self, solver: &Solver) -> Vec<Transmission> {
        match self.transmission {
            true => solver.transmission(),
            false => Vec::new(),
        }
    }

    /// Returns the excursion of a column.
    fn excursion<'e>(
        &self,
        column: &Quantity,
        excursions: &'e [Result<Excursion, NoFigure>],
    ) -> Option<&'e Result<Excursion, NoFigure>> {
        let index = self.columns.iter().position(|other| other == column)?;
        excursions.get(index)
    }

    /// Returns for each figure its value and the signed places that it is computed from: a stroke is
    /// the maximum minus the minimum. To first order these places stay fixed while lengths change.
    /// Returns `None` if a figure has another form, or if the driver turns back, because an end of
    /// its range moves.
    fn places(
        &self,
        solver: &Solver,
        excursions: &[Result<Excursion, NoFigure>],
        transmission: &[Transmission],
    ) -> Option<Vec<PlacedFigure>> {
        let Range::Full { .. } = solver.motion().range else {
            return None;
        };
        let places = |figure: &CycleFigure| {
            let (column, property) = match &figure.source {
                CycleFigureSource::Of(column, property) => (column, property),
                CycleFigureSource::Transmission(group) => {
                    return placed_transmission(solver, transmission, *group);
                }
                CycleFigureSource::Range(_) | CycleFigureSource::Condition(_) => return None,
            };
            let excursion = || {
                let found = self.excursion(column, excursions)?.as_ref().ok()?;
                (found.revolutions == 0.0 && !found.is_level()).then_some(found)
            };
            let places = match property {
                FigureProperty::At(at) => vec![(*at, 1.0)],
                FigureProperty::Minimum => vec![(excursion()?.least.at, 1.0)],
                FigureProperty::Maximum => vec![(excursion()?.greatest.at, 1.0)],
                FigureProperty::Stroke => {
                    let found = excursion()?;
                    vec![(found.greatest.at, 1.0), (found.least.at, -1.0)]
                }
                FigureProperty::MinimumAt
                | FigureProperty::MaximumAt
                | FigureProperty::Turns
                | FigureProperty::Ratio
                | FigureProperty::Dwell
                | FigureProperty::Fastest
                | FigureProperty::FastestAt
                | FigureProperty::Hardest
                | FigureProperty::HardestAt => return None,
            };
            let bound = match property {
                FigureProperty::At(_) => PlacedBound::Exact,
                _ if column.cut() != DirectionCut::Nowhere => PlacedBound::Unknown,
                FigureProperty::Minimum => PlacedBound::AtMost,
                _ => PlacedBound::AtLeast,
            };
            Some(PlacedFigure {
                value: PlacedValue::Column(column.clone()),
                places,
                bound,
            })
        };
        self.figures.iter().map(places).collect()
    }
}

impl CycleFigures {
    /// Returns the pieces of all figures of a mechanism. Returns `None` where [`EvaluatedFigures`]
    /// has no places.
    pub(crate) fn pieces(&self, solver: &Solver) -> Option<Vec<FigurePieces>> {
        let excursions = Excursion::of_all(solver, &self.columns, self.options);
        let transmission = self.transmission(solver);
        let placed = self.places(solver, &excursions, &transmission)?;
        let mut all = Vec::with_capacity(placed.len());
        for (figure, placed) in self.figures.iter().zip(placed) {
            let (column, property) = match &figure.source {
                CycleFigureSource::Of(column, property) => (column, property),
                CycleFigureSource::Transmission(group) => {
                    all.push(transmission_pieces(solver, &transmission, *group));
                    continue;
                }
                CycleFigureSource::Range(_) | CycleFigureSource::Condition(_) => return None,
            };
            if let FigureProperty::At(at) = property {
                let value = at_place(solver, column, *at).ok()?;
                all.push(FigurePieces {
                    kind: PieceKind::Maximum,
                    pieces: vec![FigurePiece { placed, value }],
                });
                continue;
            }
            let found = self.excursion(column, &excursions)?.as_ref().ok()?;
            all.push(column_pieces(found, property, &placed));
        }
        Some(all)
    }
}

impl Excursion {
    /// Returns the extreme maximum or minimum, and then other maxima or minima that are almost equal
    /// to it, the nearest before the others.
    fn near_extrema(&self, is_peak: bool) -> Vec<FigurePlace> {
        let extreme = if is_peak { self.greatest } else { self.least };
        let off = |place: &FigurePlace| (place.value - extreme.value).abs();
        let limit = NEAR_EXTREME * (self.greatest.value - self.least.value);
        let others = self
            .turnings
            .iter()
            .filter(|turning| turning.is_peak == is_peak);
        let others = others.map(|turning| turning.place);
        let others = others.filter(|place| place.at != extreme.at && off(place) <= limit);
        let mut all: Vec<FigurePlace> = std::iter::once(extreme).chain(others).collect();
        all.sort_by(|a, b| off(a).total_cmp(&off(b)));
        all.truncate(MAX_EXTREMA);
        all
    }
}

impl FigureProperty {
    fn of(self, excursion: &Excursion) -> Result<f64, NoFigure> {
        let comes_back = |value: f64| excursion.stroke().map(|_| value);
        match self {
            FigureProperty::Stroke => excursion.stroke(),
            FigureProperty::Minimum => comes_back(excursion.least.value),
            FigureProperty::Maximum => comes_back(excursion.greatest.value),
            FigureProperty::MinimumAt => comes_back(excursion.least.at),
            FigureProperty::MaximumAt => comes_back(excursion.greatest.at),
            FigureProperty::Turns => Ok(excursion.turnings.len() as f64),
            FigureProperty::Ratio => excursion.ratio.map(|ratio| ratio.value),
            FigureProperty::Dwell => excursion.longest_dwell(),
            FigureProperty::Fastest => excursion.fastest.map(|place| place.value),
            FigureProperty::FastestAt => excursion.fastest.map(|place| place.at),
            FigureProperty::Hardest => excursion.hardest.map(|place| place.value),
            FigureProperty::HardestAt => excursion.hardest.map(|place| place.at),
            FigureProperty::At(at) => Err(NoFigure::OutOfReach(at)),
        }
    }
}

impl RangeEnd {
    fn of(self, range: Range) -> Result<f64, NoFigure> {
        match (self, range) {
            (RangeEnd::Width, _) => Ok(range.ends().1 - range.ends().0),
            (RangeEnd::Low, Range::Limited { low, .. }) => Ok(low),
            (RangeEnd::High, Range::Limited { high, .. }) => Ok(high),
            (RangeEnd::Low | RangeEnd::High, Range::Full { .. }) => Err(NoFigure::NoLimit),
        }
    }
}

/// Computes a column at a coordinate.
fn at_place(solver: &Solver, column: &Quantity, at: f64) -> Result<f64, NoFigure> {
    let (wanted, order) = demand([column]);
    let solver = solver.only(&wanted);
    let mut state = solver.state();
    // A single place may be written a full turn away.
    let intended = solver
        .motion()
        .range
        .equivalent_in_range(at, solver.mechanism().driver().turns());
    match solver.solve(intended.unwrap_or(at), order, &mut state) {
        Condition::NoAssembly => Err(NoFigure::OutOfReach(at)),
        Condition::Ok | Condition::ChangePoint | Condition::DeadPoint => {
            column.value(&state).ok_or(NoFigure::Gap(at))
        }
    }
}

/// Returns the transmission angle of a dyad that is furthest from the best one, below or above it,
/// counted from below.
fn transmission_figure(found: &Transmission) -> f64 {
    BEST - found.deviation()
}

/// Returns the place of the worst transmission angle, of all dyads or of those that place the named
/// part.
fn placed_transmission(
    solver: &Solver,
    found: &[Transmission],
    named: Option<Subject>,
) -> Option<PlacedFigure> {
    let is_meant = |found: &&Transmission| places_subject(solver, found.group, named);
    let by_figure = |a: &&Transmission, b: &&Transmission| {
        transmission_figure(a).total_cmp(&transmission_figure(b))
    };
    let worst = found.iter().filter(is_meant).min_by(by_figure)?;
    let [small, large] = transmission_ends(worst);
    Some(if small.value <= large.value {
        small.placed
    } else {
        large.placed
    })
}

/// Returns the pieces of a figure of a column: its maxima, its minima, or their differences.
fn column_pieces(
    found: &Excursion,
    property: &FigureProperty,
    placed: &PlacedFigure,
) -> FigurePieces {
    let (peaks, bottoms) = (found.near_extrema(true), found.near_extrema(false));
    let of = |places: &[(FigurePlace, f64)]| FigurePiece {
        value: places.iter().map(|(place, sign)| sign * place.value).sum(),
        placed: PlacedFigure {
            places: places
                .iter()
                .map(|(place, sign)| (place.at, *sign))
                .collect(),
            ..placed.clone()
        },
    };
    let single = |places: &[FigurePlace]| places.iter().map(|&place| of(&[(place, 1.0)])).collect();
    let (kind, pieces) = match property {
        FigureProperty::Minimum => (PieceKind::Minimum, single(&bottoms)),
        FigureProperty::Maximum => (PieceKind::Maximum, single(&peaks)),
        _ => {
            let pairs = peaks
                .iter()
                .flat_map(|&high| bottoms.iter().map(move |&low| (high, low)));
            let differences = pairs.map(|(high, low)| of(&[(high, 1.0), (low, -1.0)]));
            (PieceKind::Maximum, differences.collect())
        }
    };
    FigurePieces { kind, pieces }
}

/// Returns the smallest and the largest angle of a dyad as pieces of a transmission angle. An angle
/// above the best one counts from the other side, so it has a negative sign.
fn transmission_ends(found: &Transmission) -> [FigurePiece; 2] {
    let of = |at: f64, sign: f64, value: f64| FigurePiece {
        placed: PlacedFigure {
            value: PlacedValue::Transmission(found.group),
            places: vec![(at, sign)],
            bound: PlacedBound::AtMost,
        },
        value,
    };
    let (small, large) = (found.smallest, found.largest);
    [
        of(small.at, 1.0, small.angle),
        of(large.at, -1.0, 2.0 * BEST - large.angle),
    ]
}

/// Returns the pieces of the worst transmission angle, of all dyads or of those that place the named
/// part.
fn transmission_pieces(
    solver: &Solver,
    found: &[Transmission],
    named: Option<Subject>,
) -> FigurePieces {
    let meant = found.iter();
    let meant = meant.filter(|found| places_subject(solver, found.group, named));
    let mut pieces: Vec<FigurePiece> = meant.flat_map(transmission_ends).collect();
    pieces.sort_by(|a, b| a.value.total_cmp(&b.value));
    let worst = pieces.first().map_or(BEST, |piece| piece.value);
    pieces.retain(|piece| piece.value <= worst + NEAR_ANGLE);
    FigurePieces {
        kind: PieceKind::Minimum,
        pieces,
    }
}

/// Returns the minimum over all groups, or over those that place the named part.
fn worst(solver: &Solver, found: &[(GroupId, f64)], named: Option<Subject>) -> Option<f64> {
    let values = found.iter();
    let values = values.filter(|(group, _)| places_subject(solver, *group, named));
    values.map(|(_, value)| *value).min_by(f64::total_cmp)
}

/// Returns `true` if a group places the named part, or if no part is named.
fn places_subject(solver: &Solver, id: GroupId, named: Option<Subject>) -> bool {
    let Some(group) = solver.plan().group(id) else {
        return false;
    };
    match named {
        None => true,
        Some(Subject::Point(point)) => group.point == Some(point),
        Some(Subject::Link(link)) => group.links.contains(&link),
        Some(_) => false,
    }
}
