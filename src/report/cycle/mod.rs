//! Collects the behaviour of values over the whole motion, and the quality of transmission.

pub(in crate::report) mod page;

use crate::Body;
use crate::quantity::{Catalogue, Quantity, demand, rate_unit};
use crate::report::check::group_name;
use crate::report::tables::entry::{NOISE, display_value};
use crate::report::text::csv_dialect::{CsvDialect, CsvSheet, cell};
use crate::report::text::number::concise;
use crate::report::text::places::{place_text, range_text};
use crate::scene::Scene;
use crate::solver::{Condition, Conditioning, Order, Range, Solver, Transmission};
use crate::study::{Excursion, ExcursionOptions, FigurePlace, NoFigure};
use crate::wording::{Language, Words, english_words, words};
use serde_json::{Value, json};
use std::io;

/// The worst transmission angle of a dyad, or the worst condition of a coupled group.
#[derive(Clone, Debug, PartialEq)]
pub struct WorstPlace {
    /// The name of the group.
    pub group: String,
    /// The angle in degrees, folded to at most 90, which is the optimum; or the ratio of the minimum
    /// to the maximum singular value: 1 at best, 0 at a dead point or a change point.
    pub least: f64,
    /// The driver's coordinate.
    pub at: f64,
}

/// Significant digits of a condition.
const DIGITS: usize = 3;

impl WorstPlace {
    pub(in crate::report) fn to_json(&self) -> Value {
        json!({"group": self.group, "least": self.least, "at": self.at + 0.0})
    }

    /// Describes the worst condition of a coupled group.
    pub(in crate::report) fn condition_text(&self, unit: &str) -> String {
        let magnified = match self.least > 0.0 {
            true => concise(1.0 / self.least, DIGITS),
            false => "inf".into(),
        };
        words().condition_at(&self.group, &magnified, &place_text(self.at, unit))
    }
}

/// A column over the motion.
#[derive(Clone, Debug)]
pub struct FollowedColumn {
    /// The column.
    pub quantity: Quantity,
    /// The extrema, stroke and dwells of the column, or the reason why they do not exist.
    pub excursion: Result<Excursion, NoFigure>,
    /// Driver coordinates with the error bound of the value there. At a limit that is a dead point,
    /// the bound grows with the square root of the coordinate's rounding error. `None` if nothing
    /// was proved.
    pub bounds: Vec<(f64, Option<f64>)>,
}

impl FollowedColumn {
    /// Returns the error bound of its value at a listed place; `None` if nothing was proved.
    pub(in crate::report) fn bound_at(&self, at: f64) -> Option<f64> {
        let text = self.bounds.iter().find(|(place, _)| *place == at);
        text.and_then(|(_, bound)| *bound)
    }

    /// Returns `true` if its extrema are within their bounds, so that its motion is a rounding
    /// error of 0.
    pub(in crate::report) fn is_rounding(&self, excursion: &Excursion) -> bool {
        let ends = [excursion.least, excursion.greatest];
        let is_nought =
            |place: &FigurePlace| display_value(place.value, self.bound_at(place.at)) == 0.0;
        ends.iter().all(is_nought)
    }

    /// Returns the error bound of its stroke; `None` without a stroke, or if nothing was proved.
    pub(in crate::report) fn stroke_bound(&self, excursion: &Excursion) -> Option<f64> {
        let [minimum, maximum] = [excursion.least, excursion.greatest];
        excursion.stroke().ok()?;
        Some((self.bound_at(minimum.at)? + self.bound_at(maximum.at)?).next_up())
    }
}

/// The behaviour of some values of a scene over the whole motion.
#[derive(Clone, Debug)]
pub struct CycleReport {
    /// The values.
    pub figures: Vec<FollowedColumn>,
    /// Every dyad at the place where its transmission angle deviates most from 90 degrees.
    pub transmission: Vec<WorstPlace>,
    /// Every coupled group with its worst condition.
    pub condition: Vec<WorstPlace>,
    pub(in crate::report) scene: String,
    pub(in crate::report) range: Range,
    pub(in crate::report) range_text: String,
    /// The driver's coordinate and its unit.
    pub(in crate::report) driver: Quantity,
    pub(in crate::report) speed: f64,
    /// Whether the scene has a motion over time, which is ignored here.
    pub(in crate::report) is_timed: bool,
    /// Whether bounds are shown.
    pub(in crate::report) shows_bounds: bool,
}

/// The properties with known bounds.
const BOUNDED: [&str; 3] = ["stroke", "least", "greatest"];

/// A property of a value: name, value, unit, and the driver's coordinate if it has a place.
struct Property {
    name: String,
    value: Result<f64, NoFigure>,
    unit: String,
    at: Option<f64>,
    bound: Option<f64>,
}

/// Returns the value of a property, its place and its bound.
type FindProperty<'f> = &'f dyn Fn(&Excursion) -> Result<(f64, Option<f64>, Option<f64>), NoFigure>;

impl CycleReport {
    /// Analyses these columns, or those of [`usual_columns`]; `tolerance` is that of dwells.
    #[must_use]
    pub fn new(
        scene: &Scene,
        solver: &Solver,
        columns: &[Quantity],
        tolerance: Option<f64>,
    ) -> CycleReport {
        CycleReport {
            transmission: transmission(scene, solver),
            condition: conditions(scene, solver),
            ..CycleReport::of_columns(scene, solver, columns, tolerance)
        }
    }

    /// Analyses these columns, without the mechanism as a whole.
    pub(in crate::report) fn of_columns(
        scene: &Scene,
        solver: &Solver,
        columns: &[Quantity],
        tolerance: Option<f64>,
    ) -> CycleReport {
        let options = ExcursionOptions {
            rates: true,
            dwells: true,
            tolerance,
        };
        CycleReport::followed(scene, solver, columns, options)
    }

    /// Computes strokes, swings, turning places and time ratios of the usual columns only.
    pub(in crate::report) fn strokes(scene: &Scene, solver: &Solver) -> CycleReport {
        let columns = usual_columns(scene);
        CycleReport::followed(scene, solver, &columns, ExcursionOptions::default())
    }

    fn followed(
        scene: &Scene,
        solver: &Solver,
        columns: &[Quantity],
        options: ExcursionOptions,
    ) -> CycleReport {
        let catalogue = Catalogue::new(scene);
        let found = Excursion::of_all(solver, columns, options);
        let bounds = bounds(solver, columns, &found, false);
        let quantities = columns.iter().zip(found).zip(bounds);
        let quantities = quantities.map(|((quantity, excursion), bounds)| FollowedColumn {
            quantity: quantity.clone(),
            excursion,
            bounds,
        });
        CycleReport {
            figures: quantities.collect(),
            transmission: Vec::new(),
            condition: Vec::new(),
            scene: scene.name.clone(),
            range: solver.motion().range,
            range_text: range_text(solver.motion().range, catalogue.driver()),
            driver: catalogue.driver().clone(),
            speed: scene.mechanism.driver().speed,
            is_timed: scene.motion.is_some(),
            shows_bounds: false,
        }
    }

    /// Adds the error bounds of strokes and of values at turning places.
    #[must_use]
    pub fn with_bounds(mut self, solver: &Solver) -> CycleReport {
        let figures = self.figures.iter();
        let (columns, found): (Vec<_>, Vec<_>) = figures
            .map(|column| (column.quantity.clone(), column.excursion.clone()))
            .unzip();
        let bounds = bounds(solver, &columns, &found, true);
        for (column, bounds) in self.figures.iter_mut().zip(bounds) {
            column.bounds = bounds;
        }
        self.shows_bounds = true;
        self
    }

    /// Returns the report as JSON; a missing value is an object with the reason.
    #[must_use]
    pub fn to_json(&self) -> Value {
        let (low, high) = self.range.ends();
        json!({
            "scene": self.scene,
            "range": [low, high],
            "turns_fully": matches!(self.range, Range::Full { .. }),
            "figures": self.figures.iter().map(|f| self.figure_json(f)).collect::<Vec<_>>(),
            "transmission": self.transmission.iter().map(WorstPlace::to_json).collect::<Vec<_>>(),
            "condition": self.condition.iter().map(WorstPlace::to_json).collect::<Vec<_>>(),
        })
    }

    fn figure_json(&self, column: &FollowedColumn) -> Value {
        let mut all = self.properties_json(column, &|_| true);
        let Ok(excursion) = &column.excursion else {
            return all;
        };
        if let Some((tolerance, dwells)) = &excursion.dwells {
            all["tolerance"] = json!(tolerance);
            let dwells = dwells.iter().map(|d| {
                json!({
                    "from": d.from, "to": d.to, "way": d.travel, "seconds": d.seconds,
                    "there_and_back": d.counts_twice,
                    "value": d.about.place.value,
                })
            });
            all["dwells"] = dwells.collect();
        }
        all
    }

    /// Returns the results of [`CycleReport::strokes`] for every value.
    pub(in crate::report) fn strokes_json(&self) -> Vec<Value> {
        let is_stroke = |name: &str| ["stroke", "least", "greatest", "ratio"].contains(&name);
        let figures = self.figures.iter();
        figures
            .map(|column| self.properties_json(column, &is_stroke))
            .collect()
    }

    /// Returns the wanted properties of a value, and its turning places.
    fn properties_json(&self, column: &FollowedColumn, wanted: &dyn Fn(&str) -> bool) -> Value {
        let mut all = json!({"name": column.quantity.name, "unit": column.quantity.unit});
        let properties = self.properties(column).into_iter();
        for property in properties.filter(|property| wanted(&property.name)) {
            all[&property.name] = match (property.value, property.at) {
                (Ok(value), Some(at)) => json!({"value": value, "at": at + 0.0}),
                (Ok(value), None) => json!(value),
                (Err(why), _) => json!({"none": self.reason(why, Language::English)}),
            };
            if self.shows_bounds && BOUNDED.contains(&property.name.as_str()) {
                all[format!("{}.bound", property.name)] = json!(property.bound);
            }
        }
        let Ok(excursion) = &column.excursion else {
            return all;
        };
        let turn = |turn: &crate::study::ExtremumPlace| {
            let mut told = json!({
                "at": turn.place.at + 0.0,
                "until": turn.until.map(|at| at + 0.0),
                "value": turn.place.value,
                "greatest": turn.is_peak,
                "limit": turn.is_limit,
            });
            if self.shows_bounds {
                told["bound"] = json!(column.bound_at(turn.place.at));
            }
            told
        };
        all["turns"] = excursion.turnings.iter().map(turn).collect();
        all
    }

    /// Writes a line for each value and property.
    ///
    /// # Errors
    /// Returns the errors of the writer.
    pub fn write_csv(&self, dialect: CsvDialect, out: &mut dyn io::Write) -> io::Result<()> {
        let mut csv = CsvSheet::new(dialect, out);
        let header = ["figure", "property", "value", "unit", "at", "reason"];
        let bounds = self.shows_bounds;
        csv.record(header.into_iter().chain(bounds.then_some("bound")))?;
        for column in &self.figures {
            let mut all = self.properties(column);
            all.extend(turning_rows(column));
            for property in all {
                let reason = property.value.err();
                let reason = reason.map(|why| self.reason(why, Language::English));
                let cells = [
                    column.quantity.name.clone(),
                    property.name,
                    cell(property.value.ok()),
                    property.unit,
                    cell(property.at),
                    reason.unwrap_or_default(),
                ];
                let bound = bounds.then(|| cell(property.bound));
                csv.record(cells.into_iter().chain(bound))?;
            }
        }
        let angles = self.transmission.iter();
        let angles =
            angles.map(|worst| ("transmission", "deg", &worst.group, worst.least, worst.at));
        let groups = self.condition.iter();
        let groups = groups.map(|worst| ("condition", "", &worst.group, worst.least, worst.at));
        for (name, unit, group, minimum, at) in angles.chain(groups) {
            let [minimum, at] = [minimum, at].map(|value| cell(Some(value)));
            let cells = [name.to_owned(), group.clone(), minimum, unit.to_owned(), at];
            let cells = cells.into_iter().chain([String::new()]);
            csv.record(cells.chain(bounds.then(String::new)))?;
        }
        csv.finish()
    }

    /// Returns the properties of a value, or the reasons why they are missing.
    fn properties(&self, column: &FollowedColumn) -> Vec<Property> {
        let unit = &column.quantity.unit;
        let rate = rate_unit(unit);
        let alone = |value| (value, None, None);
        let placed = |place: FigurePlace| (place.value, Some(place.at), None);
        let bounded = |place: FigurePlace| (place.value, Some(place.at), column.bound_at(place.at));
        let row = |name: &str, unit: &str, find: FindProperty<'_>| {
            let found = column.excursion.as_ref().map_err(|&why| why).and_then(find);
            let (at, bound) = found.map_or((None, None), |(_, at, bound)| (at, bound));
            Property {
                name: name.to_owned(),
                unit: unit.to_owned(),
                value: found.map(|(value, ..)| value),
                at,
                bound,
            }
        };
        vec![
            row("stroke", unit, &|e| {
                Ok((e.stroke()?, None, column.stroke_bound(e)))
            }),
            row("least", unit, &|e| e.stroke().map(|_| bounded(e.least))),
            row("greatest", unit, &|e| {
                e.stroke().map(|_| bounded(e.greatest))
            }),
            row("ratio", "", &|e| Ok(alone(e.ratio?.value))),
            row("dwell", &self.driver.unit, &|e| {
                e.longest_dwell().map(alone)
            }),
            row("fastest", &rate, &|e| e.fastest.map(placed)),
            row("hardest", &rate_unit(&rate), &|e| e.hardest.map(placed)),
        ]
    }

    /// Returns the reason why a value is missing; in English for programs.
    pub(in crate::report) fn reason(&self, why: NoFigure, language: Language) -> String {
        let wording = match language {
            Language::English => english_words(),
            _ => words(),
        };
        figure_reason(why, &self.driver.unit, wording)
    }
}

/// Returns the reason why a value is missing; `driver` is the unit of the driver's coordinate.
pub(in crate::report) fn figure_reason(why: NoFigure, driver: &str, wording: &dyn Words) -> String {
    let place = |at: f64| place_text(at, driver);
    match why {
        NoFigure::Gap(at) => wording.no_value_at(&place(at)),
        NoFigure::TurnsRound => wording.turns_round().into(),
        NoFigure::NeverTurns => wording.never_turns().into(),
        NoFigure::Stands => wording.figure_stands().into(),
        NoFigure::Rests => wording.figure_rests().into(),
        NoFigure::Leaps => wording.figure_leaps().into(),
        NoFigure::ThereAndBack => wording.there_and_back_alike().into(),
        NoFigure::DriverStands => wording.driver_has_no_speed().into(),
        NoFigure::DriverTurnsBack => wording.driver_does_not_come_round().into(),
        NoFigure::NoRate => wording.no_rate_known().into(),
        NoFigure::Unbounded(at) => wording.rate_unbounded(&place(at)),
        NoFigure::Jumps(at) => wording.figure_jumps(&place(at)),
        NoFigure::NoLimit => wording.no_limit().into(),
        NoFigure::NoDyad => wording.no_dyad().into(),
        NoFigure::NoCoupledGroup => wording.no_coupled_group().into(),
        NoFigure::OutOfReach(at) => wording.motion_never_at(&place(at)),
    }
}

/// Returns the default columns: the scene's own values, undriven slides on the ground, and undriven
/// links pinned to the ground.
#[must_use]
pub fn usual_columns(scene: &Scene) -> Vec<Quantity> {
    let catalogue = Catalogue::new(scene);
    let mechanism = &scene.mechanism;
    let own = scene.figures.iter().map(|figure| figure.name.clone());
    let slides = mechanism.slide_ids();
    let slides =
        slides.filter(|&id| mechanism.slide(id).on == Body::Ground && !mechanism.is_pushed(id));
    let slides = slides.map(|id| format!("{}.length", scene.slide_name(id)));
    let grounded = |id: &crate::LinkId| {
        let mut pins = mechanism.pins(*id);
        !mechanism.is_directed(*id) && pins.any(|pin| mechanism.point(pin).ground.is_some())
    };
    let links = mechanism.link_ids().filter(grounded);
    let links = links.map(|id| format!("{}.angle", scene.link_name(id)));
    let names = own.chain(slides).chain(links);
    names.filter_map(|name| catalogue.find(&name)).collect()
}

/// Computes error bounds at extrema and turning places. Without `in_all`, only where the bound
/// affects the text: at the limits of the motion, and where the value may be 0.
fn bounds(
    solver: &Solver,
    columns: &[Quantity],
    found: &[Result<Excursion, NoFigure>],
    in_all: bool,
) -> Vec<Vec<(f64, Option<f64>)>> {
    let limits = match solver.motion().range {
        Range::Full { .. } => None,
        Range::Limited { low, high } => Some([low, high]),
    };
    let is_wanted = |place: &FigurePlace| {
        let is_limit = limits.is_some_and(|limits| limits.contains(&place.at));
        in_all || is_limit || place.value.abs() <= NOISE
    };
    let places_of = |excursion: &Excursion| {
        let ends = [excursion.least, excursion.greatest];
        // For a value that is rounding noise at both extrema, turning places are not shown.
        let is_small = !in_all && ends.iter().all(|end| end.value.abs() <= NOISE);
        let turnings = excursion.turnings.iter().map(|turning| turning.place);
        let turnings = turnings.filter(|_| !is_small);
        let places = ends.into_iter().chain(turnings).filter(is_wanted);
        let mut places: Vec<f64> = places.map(|place| place.at).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        places
    };
    // Many columns turn at the same places, where the mechanism is solved once for all of them.
    let mut places: Vec<(f64, Order, usize)> = Vec::new();
    for (i, excursion) in found.iter().enumerate() {
        let own = excursion.iter().flat_map(places_of);
        places.extend(own.map(|at| (at, columns[i].order(), i)));
    }
    let compared =
        |a: &(f64, Order, usize), b: &(f64, Order, usize)| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
    places.sort_by(compared);
    let mut bounds = vec![Vec::new(); columns.len()];
    for shared in places.chunk_by(|a, b| compared(a, b).is_eq()) {
        let own: Vec<&Quantity> = shared.iter().map(|&(.., i)| &columns[i]).collect();
        let at = shared[0].0;
        for (&(.., i), bound) in shared.iter().zip(bounds_at(solver, &own, at)) {
            bounds[i].push((at, bound));
        }
    }
    bounds
}

/// Computes the error bounds of columns at a place.
fn bounds_at(solver: &Solver, columns: &[&Quantity], at: f64) -> Vec<Option<f64>> {
    let (wanted, order) = demand(columns.iter().copied());
    let solver = solver.only(&wanted);
    let (mut state, mut enclosure) = (solver.state(), solver.enclosure());
    if solver.solve(at, order, &mut state) == Condition::NoAssembly {
        return vec![None; columns.len()];
    }
    solver.enclose(&mut state, order, &mut enclosure);
    let bounds = columns
        .iter()
        .map(|column| column.bound(&state, &enclosure));
    bounds.collect()
}

/// Returns every dyad at the place where its transmission angle deviates most from 90 degrees.
fn transmission(scene: &Scene, solver: &Solver) -> Vec<WorstPlace> {
    let worst = |found: &Transmission| {
        let [minimum, maximum] = [found.smallest, found.largest];
        let at = match 90.0 - minimum.angle < maximum.angle - 90.0 {
            true => maximum.at,
            false => minimum.at,
        };
        Some(WorstPlace {
            group: group_name(scene, solver.plan().group(found.group)?).to_owned(),
            least: 90.0 - found.deviation(),
            at,
        })
    };
    solver.transmission().iter().filter_map(worst).collect()
}

/// Returns the worst condition of every coupled group.
pub(in crate::report) fn conditions(scene: &Scene, solver: &Solver) -> Vec<WorstPlace> {
    let worst = |found: &Conditioning| {
        Some(WorstPlace {
            group: group_name(scene, solver.plan().group(found.group)?).to_owned(),
            least: found.least,
            at: found.at,
        })
    };
    solver.conditioning().iter().filter_map(worst).collect()
}

/// Returns every turning place of a value, and the end of a plateau there.
fn turning_rows(column: &FollowedColumn) -> impl Iterator<Item = Property> {
    let turnings = column.excursion.iter().flat_map(|found| &found.turnings);
    turnings.zip(1..).flat_map(|(turning, number)| {
        let row = |name: String, at: f64| Property {
            name,
            value: Ok(turning.place.value),
            unit: column.quantity.unit.clone(),
            at: Some(at),
            bound: column.bound_at(turning.place.at),
        };
        let until = turning.until;
        let until = until.map(|at| row(format!("turn.{number}.until"), at));
        [Some(row(format!("turn.{number}"), turning.place.at)), until]
            .into_iter()
            .flatten()
    })
}
