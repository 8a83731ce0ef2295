//! The motor over a cycle: the effort of the driver, the effect of a flywheel, and the motion of a
//! ram.

pub(in crate::report) mod csv;
pub(in crate::report) mod over_time;
pub(in crate::report) mod page;

use crate::quantity::{Aspect, Catalogue};
use crate::report::forces::{PARTS, effort_unit};
use crate::report::motor::csv::{step_cells, step_heads};
use crate::report::text::csv_dialect::{CsvDialect, CsvSheet, cell};
use crate::scene::{Motor, Scene};
use crate::solver::{DeadCentre, Solver};
use crate::study::motor::{
    CyclePath, CycleShaking, DriveEffort, Duty, DutyError, Dwell, MAX_FLUCTUATION, MotorDemand,
    MotorFit, NoRam, Peak, Ram, RamEnd, Rule, SMALL_FLUCTUATION, SlidePassing, fluctuation_with,
    flywheel_for, rams,
};
use crate::wording::words;
use crate::{Load, SlideId, StrokeEnd};
use serde_json::{Value, json};
use std::io;

/// The parameters of a study of the motor that are not in the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MotorRequest {
    /// The motor, the flywheel and the required fluctuation; the scene's values by default.
    pub motor: Motor,
    /// The ram; by default the slide with a press, or the only possible ram.
    pub ram: Option<SlideId>,
    /// A height above the bottom in the scene's unit of length.
    pub height: Option<f64>,
    /// The driver's torque (N m) or force (N) for the force of the ram; the rated one by default.
    pub torque: Option<f64>,
    /// A part of the motion, traversed back and forth.
    pub between: Option<(f64, f64)>,
}

/// The result of a study of the motor.
#[derive(Clone, Debug)]
pub struct MotorReport {
    /// The driver's effort over the cycle, or the reason why there is none.
    pub duty: Result<Duty, DutyError>,
    /// The ram, or the reason why there is none.
    pub ram: Result<RamReport, String>,
    pub(in crate::report) wishes: MotorRequest,
    pub(in crate::report) fit: MotorFit,
    pub(in crate::report) scene: String,
    /// The unit of length, and that of the driver's coordinate.
    pub(in crate::report) unit: &'static str,
    pub(in crate::report) driver_unit: String,
    /// The driven link or slide.
    pub(in crate::report) driver: String,
    pub(in crate::report) is_rotary: bool,
    pub(in crate::report) effort: Aspect,
    /// The given speed: rad/s, or the unit of length per s.
    pub(in crate::report) speed: f64,
    columns: [String; 2],
}

/// A ram with the requested results.
#[derive(Clone, Debug)]
pub struct RamReport {
    /// The slide.
    pub name: String,
    /// The dead centres, the stroke and the times.
    pub ram: Ram,
    /// A height above the bottom, and the ram there, closing and opening; `None` if it never
    /// reaches the height.
    pub height: Option<(f64, Option<[SlidePassing; 2]>)>,
    /// A tolerance, and the dwell within it at the bottom.
    pub dwell: Option<(f64, Option<Dwell>)>,
    /// The driver's effort assumed for the force of the ram, in N m or N.
    pub torque: Option<f64>,
}

/// Number of steps written per turn, or per cycle back and forth.
const STEPS: u32 = 360;
/// Maximum number of steps of a cycle with many turns.
const MAX_STEPS: u32 = 36_000;

/// Values below this fraction of their terms are rounding errors.
pub(in crate::report) const NOTHING: f64 = 1e-11;

impl MotorReport {
    /// Studies the motor of a scene.
    #[must_use]
    pub fn new(scene: &Scene, solver: &Solver, preferences: MotorRequest) -> MotorReport {
        let mechanism = &scene.mechanism;
        let duty = Duty::new(mechanism, solver, preferences.between);
        let catalogue = Catalogue::new(scene);
        let coordinate = catalogue.driver();
        let driver = mechanism.driver();
        let effort = Aspect::effort_of(driver.input);
        MotorReport {
            fit: duty
                .as_ref()
                .map(|d| d.fit(&preferences.motor))
                .unwrap_or_default(),
            ram: ram(scene, solver, &preferences),
            duty,
            wishes: preferences,
            scene: scene.name.clone(),
            unit: scene.unit.symbol(),
            driver_unit: coordinate.unit.clone(),
            driver: scene.input_name(driver.input).to_owned(),
            is_rotary: driver.turns(),
            speed: driver.speed,
            columns: [coordinate.header(), format!("driver.{}", effort.name())],
            effort,
        }
    }

    /// Returns the unit of the driver's effort.
    pub(in crate::report) fn effort_unit(&self) -> &'static str {
        effort_unit(self.effort)
    }

    /// Returns the column name and the unit of the driver's effort.
    #[must_use]
    pub fn effort_name(&self) -> [&str; 2] {
        [&self.columns[1], self.effort_unit()]
    }

    /// Returns the fluctuation left by the flywheel, and the flywheel needed for the required
    /// fluctuation; `None` without a cycle or its fluctuation.
    pub(in crate::report) fn evenness(&self) -> Option<SpeedFluctuation> {
        let cycle = &self.duty.as_ref().ok()?.cycle;
        let energy = cycle.fluctuation?.energy;
        let Motor {
            flywheel,
            fluctuation,
            ..
        } = self.wishes.motor;
        Some(SpeedFluctuation {
            with: flywheel.and_then(|i| Some((i, fluctuation_with(energy, cycle.speed, i)?))),
            requested: fluctuation.and_then(|c| Some((c, flywheel_for(energy, cycle.speed, c)?))),
        })
    }

    /// Returns whether the flywheel meets the required fluctuation, or by default any that does not
    /// stop the driver; `None` without a flywheel.
    pub(in crate::report) fn is_even_enough(&self) -> Option<bool> {
        let (_, left) = self.evenness()?.with?;
        let maximum = self.wishes.motor.fluctuation;
        Some(left <= maximum.unwrap_or(MAX_FLUCTUATION))
    }

    /// Returns the mean effort of the cycle in N m or N, if the flywheel leaves little fluctuation
    /// and so supplies the rest.
    fn mean_with_flywheel(&self) -> Option<f64> {
        let (_, fluctuation) = self.evenness()?.with?;
        let all = &self.duty.as_ref().ok()?.cycle.all;
        let mean = all.mean?.abs();
        // If the mean is zero, its rounding error is not a torque.
        let requested = if mean <= NOTHING * all.rms? {
            0.0
        } else {
            mean
        };
        (fluctuation <= SMALL_FLUCTUATION).then_some(requested)
    }

    /// Compares the rated torque with that mean; returns `None` if one of them is unknown.
    pub(in crate::report) fn with_flywheel(&self) -> Option<MotorDemand> {
        let (requested, has) = (self.mean_with_flywheel()?, self.wishes.motor.rated?);
        Some(MotorDemand {
            required: requested,
            capacity: has,
        })
    }

    /// Returns whether the motor is sufficient, with the flywheel if there is one; `None` if
    /// unknown.
    pub(in crate::report) fn is_enough(&self) -> Option<bool> {
        self.fit
            .is_enough()
            .map(|alone| alone || self.suffices_with_flywheel())
    }

    /// Returns `true` if the motor is sufficient because the flywheel compensates the deviations
    /// from the mean. Then the root mean square need not be covered. Nor need the maximum torque,
    /// if the fluctuation meets the requirement: the motor's torque then stays near the mean. If
    /// the fluctuation is larger, the flywheel's part of the peak depends on the motor's slip, so
    /// the peak must still be covered.
    fn suffices_with_flywheel(&self) -> bool {
        let Some(mean) = self.mean_with_flywheel() else {
            return false;
        };
        let motor = &self.wishes.motor;
        let has_peak = match self.is_even_enough() {
            Some(true) => motor.peak.is_none_or(|peak| mean <= peak),
            Some(false) | None => self.fit.peak.is_none_or(|peak| peak.is_enough()),
        };
        let has_rated = motor.rated.is_none_or(|rated| mean <= rated);
        let is_fast = self.fit.speed.is_none_or(|speed| speed.is_enough());
        has_rated && has_peak && is_fast
    }

    /// Returns the whole result as JSON; a missing value is null.
    #[must_use]
    pub fn to_json(&self) -> Value {
        let (duty, ram) = (self.duty.as_ref().ok(), self.ram.as_ref().ok());
        json!({
            "scene": self.scene,
            "unit": self.unit,
            "driver": {
                "name": self.driver,
                "kind": if self.is_rotary { "link" } else { "slide" },
                "speed": self.speed,
            },
            "cycle": duty.map(cycle_json),
            (self.effort.name()): duty.map(|duty| self.effects_json(duty)),
            "evenness": self.evenness_json(),
            "frame": duty.map(|duty| shaking_json(&duty.cycle.shaking)),
            "motor": duty.map(|_| self.fit_json()),
            "ram": ram.map(|ram| self.ram_json(ram)),
        })
    }

    fn effects_json(&self, duty: &Duty) -> Value {
        let seconds = duty.seconds();
        let mut all = effect_json(&duty.cycle.all, seconds);
        for (name, part) in PARTS.iter().zip(&duty.cycle.parts) {
            all[*name] = effect_json(part, seconds);
        }
        all["unit"] = json!(self.effort_unit());
        all
    }

    fn evenness_json(&self) -> Value {
        let fluctuation = self
            .duty
            .as_ref()
            .ok()
            .and_then(|duty| duty.cycle.fluctuation);
        let Some(fluctuation) = fluctuation else {
            return Value::Null;
        };
        let evenness = self.evenness();
        json!({
            "energy": fluctuation.energy,
            "slowest": fluctuation.slowest,
            "fastest": fluctuation.fastest,
            "flywheel": evenness.and_then(|e| e.with).map(|(i, c)| json!({"inertia": i, "fluctuation": c})),
            "wished": evenness.and_then(|e| e.requested).map(|(c, i)| json!({"fluctuation": c, "inertia": i})),
        })
    }

    fn fit_json(&self) -> Value {
        let requested = |requested: Option<MotorDemand>| {
            requested
                .map(|a| json!({"asked": a.required, "has": a.capacity, "enough": a.is_enough()}))
        };
        json!({
            "rated": requested(self.fit.rated),
            "peak": requested(self.fit.peak),
            "speed": requested(self.fit.speed),
            "with_flywheel": requested(self.with_flywheel()),
            "enough": self.is_enough(),
            "even_enough": self.is_even_enough(),
            "gear": self.fit.geared.map(|g| json!({"ratio": g.ratio, "enough": g.is_enough})),
        })
    }

    fn ram_json(&self, report: &RamReport) -> Value {
        let ram = &report.ram;
        let centre = |c: &DeadCentre| json!({"at": c.at, "position": c.position});
        let passing = |p: &SlidePassing| {
            json!({
                "at": p.at,
                "position": p.position,
                "velocity": p.velocity,
                "acceleration": p.acceleration,
                "force": report.torque.map(|t| t * p.leverage).filter(|f| f.is_finite()),
                "leverage": Some(p.leverage).filter(|l| l.is_finite()),
            })
        };
        let height = report.height.as_ref().map(|(height, passings)| {
            let both = passings.as_ref();
            json!({
                "height": height,
                (self.effort.name()): report.torque,
                "closing": both.map(|p| passing(&p[0])),
                "opening": both.map(|p| passing(&p[1])),
            })
        });
        let dwell = report.dwell.as_ref().map(|(tolerance, dwell)| {
            json!({
                "tolerance": tolerance,
                "from": dwell.map(|d| d.from),
                "to": dwell.map(|d| d.to),
                "way": dwell.map(|d| d.travel),
                "seconds": dwell.and_then(|d| d.seconds),
            })
        });
        json!({
            "name": report.name,
            "end": end_word(ram.end.end),
            "stroke": ram.stroke,
            "bottom": centre(&ram.bottom),
            "top": centre(&ram.top),
            "others": ram.others.iter().map(centre).collect::<Vec<_>>(),
            "closing": ram.travels[0],
            "opening": ram.travels[1],
            "time_ratio": ram.time_ratio(),
            "seconds": ram.seconds,
            "strokes_per_minute": ram.strokes_per_minute(),
            "at_height": height,
            "dwell": dwell,
        })
    }

    /// Writes the cycle step by step as comma separated values: the driver's effort, its parts, its
    /// power, the work done since the beginning, and the load on the ground, as solved in each
    /// state. A missing value is empty.
    ///
    /// # Errors
    /// Returns the errors of the writer.
    pub fn write_csv(&self, dialect: CsvDialect, out: &mut dyn io::Write) -> io::Result<()> {
        let Ok(duty) = &self.duty else {
            return Ok(());
        };
        let mut csv = CsvSheet::new(dialect, out);
        let [coordinate, effort] = &self.columns;
        let unit = self.effort_unit();
        let mut header = vec![coordinate.clone()];
        header.extend(step_heads(effort, unit));
        csv.record(&header)?;
        for (path, step) in duty.steps(steps(duty.turns())) {
            let mut row = vec![cell(Some(step.at))];
            row.extend(step_cells(&step, duty.work(path)));
            csv.record(&row)?;
        }
        csv.finish()
    }
}

/// The fluctuation left by a flywheel, and the flywheel needed for a fluctuation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::report) struct SpeedFluctuation {
    pub(in crate::report) with: Option<(f64, f64)>,
    pub(in crate::report) requested: Option<(f64, f64)>,
}

/// Returns the number of steps of a cycle of so many turns.
fn steps(turns: f64) -> u32 {
    let all = f64::from(STEPS) * turns;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a number between one and the most"
    )]
    let steps = all.clamp(1.0, f64::from(MAX_STEPS)) as u32;
    steps
}

/// Returns the end of a guide at which a ram works, as named in scenes.
pub(in crate::report) fn end_word(end: StrokeEnd) -> &'static str {
    match end {
        StrokeEnd::Minimum => "least",
        StrokeEnd::Maximum => "greatest",
    }
}

/// Selects the ram and computes its motion.
fn ram(scene: &Scene, solver: &Solver, preferences: &MotorRequest) -> Result<RamReport, String> {
    let mechanism = &scene.mechanism;
    let pressed = mechanism.loads().iter().find_map(|load| match load {
        Load::Press { slide, .. } => Some(*slide),
        Load::Force { .. }
        | Load::Torque { .. }
        | Load::Spring { .. }
        | Load::GasSpring { .. }
        | Load::TorsionSpring { .. } => None,
    });
    let slide = match preferences.ram.or(pressed) {
        Some(slide) => slide,
        None => {
            let all: Vec<SlideId> = rams(mechanism).collect();
            let names: Vec<&str> = all.iter().map(|&id| scene.slide_name(id)).collect();
            match all[..] {
                [one] => one,
                [] => return Err(NoRam::None.to_string()),
                _ => {
                    return Err(words().several_rams(&names.join(", ")));
                }
            }
        }
    };
    let name = scene.slide_name(slide);
    let end = RamEnd::of(mechanism, slide);
    let mut ram =
        Ram::new(mechanism, solver, slide, end).map_err(|why| format!("{name}: {why}"))?;
    Ok(RamReport {
        name: name.to_owned(),
        height: preferences
            .height
            .map(|height| (height, ram.at_height(height))),
        dwell: preferences
            .motor
            .rest
            .map(|maximum| (maximum, ram.dwell(maximum))),
        torque: preferences.torque.or(preferences.motor.rated),
        ram,
    })
}

fn cycle_json(duty: &Duty) -> Value {
    let cycle = &duty.cycle;
    let CyclePath {
        low,
        high,
        is_periodic,
        ..
    } = cycle.course;
    let (rule, count) = match cycle.rule {
        Rule::Periodic(places) => ("periodic-trapezoid", places),
        Rule::Pieces(pieces) => ("chebyshev-pieces", pieces),
    };
    json!({
        "from": low,
        "to": high,
        "goes_round": is_periodic,
        "turns": duty.turns(),
        "seconds": duty.seconds(),
        "dead_points": duty.dead_points,
        "change_points": duty.change_points,
        "rule": rule,
        "count": count,
        "error": cycle.error,
        "converged": cycle.has_converged(),
        "states": cycle.states,
    })
}

fn peak_json(peak: Option<Peak>) -> Value {
    json!(peak.map(|p| json!({"value": p.value, "at": p.at, "back": p.back})))
}

fn effect_json(effect: &DriveEffort, seconds: Option<f64>) -> Value {
    json!({
        "largest": peak_json(effect.largest),
        "least": peak_json(effect.least),
        "largest_power": peak_json(effect.largest_power),
        "least_power": peak_json(effect.least_power),
        "mean": effect.mean,
        "mean_power": effect.work().zip(seconds).map(|(work, time)| work / time),
        "rms": effect.rms,
        "put_in": effect.supplied,
        "given_back": effect.returned,
        "work": effect.work(),
    })
}

fn shaking_json(shaking: &CycleShaking) -> Value {
    json!({
        "force": peak_json(shaking.force),
        "vector": shaking.vector.map(|v| [v.x, v.y]),
        "force_rms": shaking.force_rms,
        "moment": peak_json(shaking.moment),
        "moment_rms": shaking.moment_rms,
    })
}
