//! What figures do over the whole motion, and how well the mechanism passes it on.

use super::check::{ConditionFacts, ElementNames};
use super::csv_dialect::{CsvDialect, CsvSheet};
use super::entry::{NOISE, seen};
use super::range_text::range_text;
use crate::Body;
use crate::quantity::{Catalogue, Quantity, demand, rate_unit};
use crate::scene::Scene;
use crate::solver::{Condition, Range, Solver};
use crate::study::{Excursion, ExcursionWish, FigurePlace, NoFigure};
use crate::wording::{Language, Words, for_programs, words};
use serde_json::{Value, json};
use std::io;

/// Where a dyad passes motion on worst.
#[derive(Clone, Debug, PartialEq)]
pub struct WorstPlace {
    /// What names the dyad.
    pub group: String,
    /// The angle between its lines in degrees, 90 at the best.
    pub least: f64,
    /// The driver's coordinate.
    pub at: f64,
}

/// A column over the motion.
#[derive(Clone, Debug)]
pub struct FollowedFigure {
    /// The column.
    pub quantity: Quantity,
    /// What it does.
    pub excursion: Result<Excursion, NoFigure>,
    /// The driver's coordinates at which it is told what it is, and by how much it may be off there: at a limit that is a
    /// dead point by the root of what rounding makes of the coordinate. `None` where no bound can be proved.
    pub bounds: Vec<(f64, Option<f64>)>,
}

impl FollowedFigure {
    /// By how much its value at a place that is told may be off.
    pub(super) fn bound_at(&self, at: f64) -> Option<f64> {
        let told = self.bounds.iter().find(|(place, _)| *place == at);
        told.and_then(|(_, bound)| *bound)
    }

    /// Whether all that it does is no more than its bound: rounding of what is 0.
    pub(super) fn is_rounding(&self, excursion: &Excursion) -> bool {
        let ends = [excursion.least, excursion.greatest];
        let is_nought = |place: &FigurePlace| seen(place.value, self.bound_at(place.at)) == 0.0;
        ends.iter().all(is_nought)
    }

    /// By how much its stroke may be off.
    pub(super) fn stroke_bound(&self, excursion: &Excursion) -> Option<f64> {
        let [least, greatest] = [excursion.least, excursion.greatest];
        excursion.stroke().ok()?;
        Some((self.bound_at(least.at)? + self.bound_at(greatest.at)?).next_up())
    }
}

/// What some figures of a scene do over the whole motion.
#[derive(Clone, Debug)]
pub struct CycleReport {
    /// The figures.
    pub figures: Vec<FollowedFigure>,
    /// Every dyad where its transmission angle is furthest from 90 degrees.
    pub transmission: Vec<WorstPlace>,
    /// Every coupled group where its equations tell least.
    pub condition: Vec<ConditionFacts>,
    pub(super) scene: String,
    pub(super) range: Range,
    pub(super) range_text: String,
    /// The driver's coordinate and its unit.
    pub(super) driver: Quantity,
    pub(super) speed: f64,
    /// Whether the scene has a motion over time, which is not followed here.
    pub(super) is_timed: bool,
    /// Whether bounds are told.
    pub(super) with_bounds: bool,
}

/// Of which properties a bound is known.
const BOUNDED: [&str; 3] = ["stroke", "least", "greatest"];

/// A property of a figure: its name, its value and unit, and the driver's coordinate where it has a place.
struct Property {
    name: String,
    value: Result<f64, NoFigure>,
    unit: String,
    at: Option<f64>,
    bound: Option<f64>,
}

impl CycleReport {
    /// Follows these columns, or those of [`usual_columns`]; `tolerance` is that of dwells.
    #[must_use]
    pub fn new(
        scene: &Scene,
        solver: &Solver,
        columns: &[Quantity],
        tolerance: Option<f64>,
    ) -> CycleReport {
        CycleReport {
            transmission: transmission(scene, solver),
            condition: ElementNames { scene }.condition(solver),
            ..CycleReport::of_columns(scene, solver, columns, tolerance)
        }
    }

    /// The same without what is said of the mechanism as a whole.
    pub(super) fn of_columns(
        scene: &Scene,
        solver: &Solver,
        columns: &[Quantity],
        tolerance: Option<f64>,
    ) -> CycleReport {
        let wish = ExcursionWish {
            rates: true,
            dwells: true,
            tolerance,
        };
        CycleReport::followed(scene, solver, columns, wish)
    }

    /// Strokes and swings of the usual columns alone, where they turn, and the ratios of times.
    pub(super) fn strokes(scene: &Scene, solver: &Solver) -> CycleReport {
        let columns = usual_columns(scene);
        CycleReport::followed(scene, solver, &columns, ExcursionWish::default())
    }

    fn followed(
        scene: &Scene,
        solver: &Solver,
        columns: &[Quantity],
        wish: ExcursionWish,
    ) -> CycleReport {
        let catalogue = Catalogue::new(scene);
        let found = Excursion::of_all(solver, columns, wish);
        let bounds = bounds(solver, columns, &found, false);
        let figures = columns.iter().zip(found).zip(bounds);
        let figures = figures.map(|((quantity, excursion), bounds)| FollowedFigure {
            quantity: quantity.clone(),
            excursion,
            bounds,
        });
        CycleReport {
            figures: figures.collect(),
            transmission: Vec::new(),
            condition: Vec::new(),
            scene: scene.name.clone(),
            range: solver.motion().range,
            range_text: range_text(solver.motion().range, catalogue.driver()),
            driver: catalogue.driver().clone(),
            speed: scene.mechanism.driver().speed,
            is_timed: scene.motion.is_some(),
            with_bounds: false,
        }
    }

    /// The same with what the error of strokes and of values at turns does not exceed.
    #[must_use]
    pub fn with_bounds(mut self, solver: &Solver) -> CycleReport {
        for figure in &mut self.figures {
            let columns = std::slice::from_ref(&figure.quantity);
            let found = std::slice::from_ref(&figure.excursion);
            let found = bounds(solver, columns, found, true).pop();
            figure.bounds = found.unwrap_or_default();
        }
        self.with_bounds = true;
        self
    }

    /// As JSON; what does not exist is null, with the reason beside it.
    #[must_use]
    pub fn to_json(&self) -> Value {
        let worst = |w: &WorstPlace| json!({"group": w.group, "least": w.least, "at": w.at + 0.0});
        let (low, high) = self.range.ends();
        json!({
            "scene": self.scene,
            "range": [low, high],
            "turns_fully": matches!(self.range, Range::Full { .. }),
            "figures": self.figures.iter().map(|f| self.figure_json(f)).collect::<Vec<_>>(),
            "transmission": self.transmission.iter().map(worst).collect::<Vec<_>>(),
            "condition": self.condition,
        })
    }

    fn figure_json(&self, figure: &FollowedFigure) -> Value {
        let mut all = self.properties_json(figure, &|_| true);
        let Ok(excursion) = &figure.excursion else {
            return all;
        };
        if let Some((tolerance, dwells)) = &excursion.dwells {
            all["tolerance"] = json!(tolerance);
            let dwells = dwells.iter().map(|d| {
                json!({
                    "from": d.from, "to": d.to, "way": d.way, "seconds": d.seconds,
                    "there_and_back": d.there_and_back,
                    "value": d.about.place.value,
                })
            });
            all["dwells"] = dwells.collect();
        }
        all
    }

    /// Of every figure what [`CycleReport::strokes`] has found.
    pub(super) fn strokes_json(&self) -> Vec<Value> {
        let is_stroke = |name: &str| ["stroke", "least", "greatest", "ratio"].contains(&name);
        let figures = self.figures.iter();
        figures
            .map(|figure| self.properties_json(figure, &is_stroke))
            .collect()
    }

    /// The wanted properties of a figure, and where it turns.
    fn properties_json(&self, figure: &FollowedFigure, wanted: &dyn Fn(&str) -> bool) -> Value {
        let mut all = json!({"name": figure.quantity.name, "unit": figure.quantity.unit});
        let properties = self.properties(figure).into_iter();
        for property in properties.filter(|property| wanted(&property.name)) {
            all[&property.name] = match (property.value, property.at) {
                (Ok(value), Some(at)) => json!({"value": value, "at": at + 0.0}),
                (Ok(value), None) => json!(value),
                (Err(why), _) => json!({"none": self.reason(why, Language::English)}),
            };
            if self.with_bounds && BOUNDED.contains(&property.name.as_str()) {
                all[format!("{}.bound", property.name)] = json!(property.bound);
            }
        }
        let Ok(excursion) = &figure.excursion else {
            return all;
        };
        let turn = |turn: &crate::study::TurningPlace| {
            let mut told = json!({
                "at": turn.place.at + 0.0,
                "until": turn.until.map(|at| at + 0.0),
                "value": turn.place.value,
                "greatest": turn.is_peak,
                "limit": turn.is_limit,
            });
            if self.with_bounds {
                told["bound"] = json!(figure.bound_at(turn.place.at));
            }
            told
        };
        all["turns"] = excursion.turnings.iter().map(turn).collect();
        all
    }

    /// A line for each figure and property.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn write_csv(&self, dialect: CsvDialect, out: &mut dyn io::Write) -> io::Result<()> {
        let mut csv = CsvSheet::new(dialect, out);
        let header = ["figure", "property", "value", "unit", "at", "reason"];
        let bounds = self.with_bounds;
        let header = header.into_iter().chain(bounds.then_some("bound"));
        csv.record(header.map(str::to_owned).collect::<Vec<_>>())?;
        let number = |value: Option<f64>| {
            let mut text = String::new();
            if let Some(value) = value.filter(|v| v.is_finite()) {
                dialect.push(value, &mut text);
            }
            text
        };
        for figure in &self.figures {
            let mut all = self.properties(figure);
            all.extend(turning_rows(figure));
            for property in all {
                let reason = property.value.err();
                let reason = reason.map(|why| self.reason(why, Language::English));
                let cells = [
                    figure.quantity.name.clone(),
                    property.name,
                    number(property.value.ok()),
                    property.unit,
                    number(property.at),
                    reason.unwrap_or_default(),
                ];
                let cells = cells
                    .into_iter()
                    .chain(bounds.then(|| number(property.bound)));
                csv.record(cells.collect::<Vec<_>>())?;
            }
        }
        let angles = self.transmission.iter();
        let angles =
            angles.map(|worst| ("transmission", "deg", &worst.group, worst.least, worst.at));
        let groups = self.condition.iter();
        let groups = groups.map(|worst| ("condition", "", &worst.group, worst.least, worst.at));
        for (name, unit, group, least, at) in angles.chain(groups) {
            let [least, at] = [least, at].map(|value| number(Some(value)));
            let cells = [name.to_owned(), group.clone(), least, unit.to_owned(), at];
            let cells = cells.into_iter().chain([String::new()]);
            let cells = cells.chain(bounds.then(String::new));
            csv.record(cells.collect::<Vec<_>>())?;
        }
        csv.finish()
    }

    /// The properties that every figure has, or why it has not.
    fn properties(&self, figure: &FollowedFigure) -> Vec<Property> {
        let FollowedFigure {
            quantity,
            excursion,
            ..
        } = figure;
        let unit = &quantity.unit;
        let rate = rate_unit(unit);
        let placed = |name: &str, unit: &str, place: Result<FigurePlace, NoFigure>| Property {
            name: name.to_owned(),
            unit: unit.to_owned(),
            value: place.map(|place| place.value),
            at: place.ok().map(|place| place.at),
            bound: None,
        };
        let bounded = |name: &str, place: Result<FigurePlace, NoFigure>| Property {
            bound: place.ok().and_then(|place| figure.bound_at(place.at)),
            ..placed(name, unit, place)
        };
        let plain = |name: &str, unit: &str, value: Result<f64, NoFigure>| Property {
            name: name.to_owned(),
            unit: unit.to_owned(),
            value,
            at: None,
            bound: None,
        };
        let of = |find: &dyn Fn(&Excursion) -> Result<FigurePlace, NoFigure>| {
            excursion.as_ref().map_err(|&why| why).and_then(find)
        };
        let number = |find: &dyn Fn(&Excursion) -> Result<f64, NoFigure>| {
            excursion.as_ref().map_err(|&why| why).and_then(find)
        };
        vec![
            Property {
                bound: excursion.as_ref().ok().and_then(|e| figure.stroke_bound(e)),
                ..plain("stroke", unit, number(&Excursion::stroke))
            },
            bounded("least", of(&|e| e.stroke().map(|_| e.least))),
            bounded("greatest", of(&|e| e.stroke().map(|_| e.greatest))),
            plain("ratio", "", number(&|e| e.ratio.map(|r| r.value))),
            plain("dwell", &self.driver.unit, number(&longest_dwell)),
            placed("fastest", &rate, of(&|e| e.fastest)),
            placed("hardest", &rate_unit(&rate), of(&|e| e.hardest)),
        ]
    }

    /// Why there is no figure, for who reads the page or for programs.
    pub(super) fn reason(&self, why: NoFigure, language: Language) -> String {
        let told = match language {
            Language::English => for_programs(),
            _ => words(),
        };
        figure_reason(why, &self.driver.unit, told)
    }
}

/// Why there is no figure, of a driver whose coordinate has this unit.
pub(super) fn figure_reason(why: NoFigure, driver: &str, told: &dyn Words) -> String {
    let place = |at: f64| super::check_page::place_text(at, driver);
    match why {
        NoFigure::Gap(at) => told.no_value_at(&place(at)),
        NoFigure::TurnsRound => told.turns_round().into(),
        NoFigure::NeverTurns => told.never_turns().into(),
        NoFigure::Stands => told.figure_stands().into(),
        NoFigure::Rests => told.figure_rests().into(),
        NoFigure::Leaps => told.figure_leaps().into(),
        NoFigure::ThereAndBack => told.there_and_back_alike().into(),
        NoFigure::DriverStands => told.driver_has_no_speed().into(),
        NoFigure::DriverTurnsBack => told.driver_does_not_come_round().into(),
        NoFigure::NoRate => told.no_rate_known().into(),
        NoFigure::Unbounded(at) => told.rate_unbounded(&place(at)),
        NoFigure::Jumps(at) => told.figure_jumps(&place(at)),
        NoFigure::NoLimit => told.no_limit().into(),
        NoFigure::NoDyad => told.no_dyad().into(),
        NoFigure::NoCoupledGroup => told.no_coupled_group().into(),
        NoFigure::OutOfReach(at) => told.motion_never_at(&place(at)),
    }
}

/// What is told where nobody names columns: figures of the scene's own, slides that are not driven, and links that
/// turn about the ground.
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

/// By how much columns may be off where they turn, and at their extremes: in all of these places, or in those where it
/// decides what is told, which are the limits of the motion and all in which a value may be 0.
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
    let of_one = |column: &Quantity, excursion: &Excursion| {
        let ends = [excursion.least, excursion.greatest];
        // Of what is rounding at both ends nothing else is told.
        let is_small = !in_all && ends.iter().all(|end| end.value.abs() <= NOISE);
        let turnings = excursion.turnings.iter().map(|turning| turning.place);
        let turnings = turnings.filter(|_| !is_small);
        let places = ends.into_iter().chain(turnings).filter(is_wanted);
        let mut places: Vec<f64> = places.map(|place| place.at).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        bounds_at(solver, column, &places)
    };
    let figures = columns.iter().zip(found);
    let figures = figures.map(|(column, excursion)| match excursion {
        Ok(excursion) => of_one(column, excursion),
        Err(_) => Vec::new(),
    });
    figures.collect()
}

/// By how much a column may be off at some places.
fn bounds_at(solver: &Solver, column: &Quantity, places: &[f64]) -> Vec<(f64, Option<f64>)> {
    if places.is_empty() {
        return Vec::new();
    }
    let (wanted, order) = demand([column]);
    let solver = solver.only(&wanted);
    let (mut state, mut enclosure) = (solver.state(), solver.enclosure());
    let bound = |&at: &f64| {
        let is_there = solver.solve(at, order, &mut state) != Condition::NoAssembly;
        let bound = is_there.then(|| {
            solver.enclose(&mut state, order, &mut enclosure);
            column.bound(&state, &enclosure)
        });
        (at, bound.flatten())
    };
    places.iter().map(bound).collect()
}

/// Every dyad where its transmission angle is furthest from 90 degrees.
fn transmission(scene: &Scene, solver: &Solver) -> Vec<WorstPlace> {
    let names = ElementNames { scene };
    let worst = |found: &crate::solver::Transmission| {
        let [least, most] = [found.smallest, found.largest];
        let at = match 90.0 - least.angle < most.angle - 90.0 {
            true => most.at,
            false => least.at,
        };
        Some(WorstPlace {
            group: names.group_name(solver.plan().group(found.group)?),
            least: 90.0 - found.deviation(),
            at,
        })
    };
    solver.transmission().iter().filter_map(worst).collect()
}

fn longest_dwell(excursion: &Excursion) -> Result<f64, NoFigure> {
    excursion.stroke()?;
    let dwells = excursion.dwells.iter().flat_map(|(_, dwells)| dwells);
    let ways = dwells.map(|dwell| dwell.way);
    ways.max_by(f64::total_cmp).ok_or(NoFigure::NeverTurns)
}

/// Every place where a figure turns, and until where it stays there.
fn turning_rows(figure: &FollowedFigure) -> impl Iterator<Item = Property> {
    let turnings = figure.excursion.iter().flat_map(|found| &found.turnings);
    turnings.zip(1..).flat_map(|(turning, number)| {
        let row = |name: String, at: f64| Property {
            name,
            value: Ok(turning.place.value),
            unit: figure.quantity.unit.clone(),
            at: Some(at),
            bound: figure.bound_at(turning.place.at),
        };
        let until = turning.until;
        let until = until.map(|at| row(format!("turn.{number}.until"), at));
        [Some(row(format!("turn.{number}"), turning.place.at)), until]
            .into_iter()
            .flatten()
    })
}
