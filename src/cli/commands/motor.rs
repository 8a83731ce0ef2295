//! `krank motor`: computes the motor's duty over one cycle of a scene.

use crate::cli::failure::{Failure, note};
use crate::cli::formats::{CsvArgs, OutputFormat, not_negative, number, positive};
use crate::cli::output::{OutputArgs, write_text, write_to};
use crate::cli::place::note_near_misses;
use crate::cli::rows::clock;
use crate::cli::screen::TextScreen;
use crate::cli::source::{SceneArgs, SolvableScene};
use crate::nearest::nearest;
use crate::quantity::Catalogue;
use crate::report::{CsvDialect, MotorReport, MotorRequest, TimedMotorReport, limits_text};
use crate::scene::{Motor, Scene};
use crate::solver::{Range, Solver};
use crate::study::motor::{Duty, DutyError, MAX_FLUCTUATION, TimedDuty, is_within};
use crate::wording::words;
use crate::{Body, SlideId};
use clap::Args;
use std::fmt::Display;

#[derive(Debug, Args)]
pub(in crate::cli) struct MotorArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[arg(help = words().rated_effort())]
    #[arg(long, value_name = "SIZE", value_parser = positive, allow_negative_numbers = true)]
    rated: Option<f64>,
    #[arg(help = words().peak_effort())]
    #[arg(long, value_name = "SIZE", value_parser = positive, allow_negative_numbers = true)]
    peak: Option<f64>,
    #[arg(help = words().motor_speed())]
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    speed: Option<String>,
    #[arg(help = words().flywheel_on_shaft())]
    #[arg(long, value_name = "INERTIA", value_parser = positive, allow_negative_numbers = true)]
    flywheel: Option<f64>,
    #[arg(help = words().wished_fluctuation())]
    #[arg(long, value_name = "SHARE", value_parser = positive, allow_negative_numbers = true)]
    fluctuation: Option<f64>,
    #[arg(help = words().slide_of_ram())]
    #[arg(long, value_name = "NAME")]
    ram: Option<String>,
    #[arg(help = words().height_of_ram())]
    #[arg(long, value_name = "LENGTH", value_parser = not_negative, allow_negative_numbers = true)]
    height: Option<f64>,
    #[arg(help = words().effort_for_ram())]
    #[arg(long, value_name = "SIZE", value_parser = positive, allow_negative_numbers = true)]
    torque: Option<f64>,
    #[arg(help = words().tolerance_of_rest())]
    #[arg(long, alias = "tolerance", value_name = "LENGTH", value_parser = positive, allow_negative_numbers = true)]
    rest: Option<f64>,
    #[arg(help = words().there_and_back_from())]
    #[arg(
        long,
        value_name = "COORDINATE",
        requires = "to",
        value_parser = number,
        allow_negative_numbers = true
    )]
    from: Option<f64>,
    #[arg(help = words().there_and_back_to())]
    #[arg(
        long,
        value_name = "COORDINATE",
        requires = "from",
        value_parser = number,
        allow_negative_numbers = true
    )]
    to: Option<f64>,
    #[arg(help = words().how_to_write_motor())]
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    format: OutputFormat,
    #[command(flatten)]
    csv: CsvArgs,
    #[command(flatten)]
    output: OutputArgs,
}

pub(in crate::cli) fn motor(args: &MotorArgs, screen: TextScreen) -> Result<(), Failure> {
    let dialect = args.csv.dialect(args.format)?;
    let SolvableScene { scene, solver } = args.scene.open_for(&args.output)?;
    if scene.motion.is_some() {
        return timed(args, (&scene, &solver), dialect, screen);
    }
    let requests = MotorRequest {
        motor: given(args, &scene)?,
        ram: args
            .ram
            .as_deref()
            .map(|name| ram(&scene, name))
            .transpose()?,
        height: args.height,
        torque: args.torque,
        between: between(args, &scene, &solver)?,
    };
    note_near_misses(&scene, &solver, screen);
    let report = MotorReport::new(&scene, &solver, requests);
    note_missing_ram(args, &report, screen);
    let output = args.output.output.as_deref();
    match &report.duty {
        Ok(_) | Err(DutyError::WithheldReason(_)) => {}
        Err(DutyError::NothingActs) if args.format == OutputFormat::Csv || report.ram.is_err() => {
            return Err(Failure::Cannot(words().nothing_acts_on_it().into()));
        }
        Err(DutyError::NothingActs) => note(words().nothing_acts_on_it(), screen),
    }
    match args.format {
        OutputFormat::Text => write_text(output, &report.to_text(screen.ascii))?,
        OutputFormat::Json => write_text(output, &format!("{:#}\n", report.to_json()))?,
        OutputFormat::Csv => write_to(output, |out| report.write_csv(dialect, out))?,
    }
    match &report.duty {
        Ok(duty) => check_convergence(duty),
        Err(DutyError::NothingActs) => Ok(()),
        Err(DutyError::WithheldReason(hidden)) => {
            let catalogue = Catalogue::new(&scene);
            Err(Failure::Cannot(hidden.text(&catalogue.driver().unit)))
        }
    }
}

/// Computes the duty over the period of a motion over time.
fn timed(
    args: &MotorArgs,
    (scene, solver): (&Scene, &Solver),
    dialect: CsvDialect,
    screen: TextScreen,
) -> Result<(), Failure> {
    no_steady_cycle(args)?;
    let motor = given(args, scene)?;
    let clock = clock(scene)?;
    let duty = TimedDuty::new(&clock, solver)
        .map_err(|why| Failure::Cannot(TimedMotorReport::nothing(scene, &why)))?;
    note_near_misses(scene, solver, screen);
    let is_believed = duty.has_converged();
    let report = TimedMotorReport::new(scene, duty, &motor);
    let output = args.output.output.as_deref();
    match args.format {
        OutputFormat::Json => write_text(output, &format!("{:#}\n", report.to_json()))?,
        OutputFormat::Text => write_text(output, &report.to_text(screen.ascii))?,
        OutputFormat::Csv => write_to(output, |out| {
            report.write_csv((&clock, solver), dialect, out)
        })?,
    }
    match is_believed {
        true => Ok(()),
        false => Err(Failure::Cannot(words().no_believable_integrals().into())),
    }
}

/// Returns an error for options that apply only to a cycle at constant speed.
fn no_steady_cycle(args: &MotorArgs) -> Result<(), Failure> {
    let requested = [
        ("--flywheel", args.flywheel.is_some()),
        ("--fluctuation", args.fluctuation.is_some()),
        ("--ram", args.ram.is_some()),
        ("--height", args.height.is_some()),
        ("--torque", args.torque.is_some()),
        ("--rest", args.rest.is_some()),
        ("--from", args.from.is_some()),
    ];
    match requested.into_iter().find(|(_, is_given)| *is_given) {
        None => Ok(()),
        Some((option, _)) => Err(Failure::Usage(words().only_at_one_speed(option))),
    }
}

/// Returns the scene's motor data, overridden by the options.
fn given(args: &MotorArgs, scene: &Scene) -> Result<Motor, Failure> {
    let known = scene.motor.unwrap_or_default();
    let wrong = |why: &dyn Display| Failure::Usage(words().of_option("--speed", why));
    let speed = match &args.speed {
        None => known.speed,
        Some(text) => match scene.speed(text) {
            Ok(speed) if speed > 0.0 => Some(speed),
            Ok(_) => return Err(wrong(&words().must_be_positive())),
            Err(why) => return Err(wrong(&why)),
        },
    };
    let motor = Motor {
        rated: args.rated.or(known.rated),
        peak: args.peak.or(known.peak),
        speed,
        flywheel: args.flywheel.or(known.flywheel),
        fluctuation: args.fluctuation.or(known.fluctuation),
        rest: args.rest.or(known.rest),
    };
    refused(&motor).map_or(Ok(motor), |why| Err(Failure::Usage(why)))
}

/// Returns an error message if the values contradict each other, with the rules of the scene's
/// [motor].
fn refused(motor: &Motor) -> Option<String> {
    if let (Some(rated), Some(peak)) = (motor.rated, motor.peak)
        && peak < rated
    {
        return Some(words().peak_less_than_rated(peak, rated));
    }
    let uneven = motor.fluctuation.filter(|share| *share > 1.0);
    uneven.map(|share| match share > MAX_FLUCTUATION {
        true => words().fluctuation_above_two(share),
        false => words().fluctuation_above_one(share),
    })
}

/// Returns the slide with this name.
fn ram(scene: &Scene, name: &str) -> Result<SlideId, Failure> {
    let mechanism = &scene.mechanism;
    let mut all = mechanism.slide_ids();
    let on_ground = |id: &SlideId| mechanism.slide(*id).on == Body::Ground;
    match all.find(|&id| scene.slide_name(id) == name) {
        Some(slide) if on_ground(&slide) => Ok(slide),
        Some(_) => Err(Failure::Usage(words().guide_of_ram_moves(name))),
        None => {
            let names = mechanism.slide_ids().filter(on_ground);
            let names: Vec<&str> = names.map(|id| scene.slide_name(id)).collect();
            let fix = match nearest(name, names.iter().copied()) {
                Some(near) => words().did_you_mean(near),
                None if names.is_empty() => words().no_slide_on_ground().into(),
                None => words().there_are(&names.join(", ")),
            };
            Err(Failure::Usage(words().no_slide_named(name, &fix)))
        }
    }
}

/// Returns the part of the motion through which the driver oscillates.
fn between(
    args: &MotorArgs,
    scene: &Scene,
    solver: &Solver,
) -> Result<Option<(f64, f64)>, Failure> {
    let (Some(from), Some(to)) = (args.from, args.to) else {
        return Ok(None);
    };
    // For a turning driver, from 300 to 60 deg means the arc over the full turn.
    let range = solver.motion().range;
    let to = match range {
        Range::Full { .. } if to < from => {
            let turned = from + (to - from).rem_euclid(crate::angle::TURN);
            if turned > from {
                turned
            } else {
                from + crate::angle::TURN
            }
        }
        Range::Full { .. } | Range::Limited { .. } => to,
    };
    let (low, high) = (from.min(to), from.max(to));
    if low == high || !(high - low).is_finite() {
        return Err(Failure::Usage(words().must_go_from_one_to_another().into()));
    }
    match range {
        Range::Limited { .. } if !is_within(range, low, high) => {
            let catalogue = Catalogue::new(scene);
            let covers = limits_text(range, catalogue.driver());
            Err(Failure::Cannot(
                words().leads_out_of_motion(from, to, &covers),
            ))
        }
        Range::Limited { .. } | Range::Full { .. } => Ok(Some((low, high))),
    }
}

/// Notes why there are no results on a ram, if the options request them.
fn note_missing_ram(args: &MotorArgs, report: &MotorReport, screen: TextScreen) {
    let is_requested = args.ram.is_some() || args.height.is_some() || args.torque.is_some();
    if let (true, Err(why)) = (is_requested || args.rest.is_some(), &report.ram) {
        note(&words().no_ram(why), screen);
    }
}

/// Returns an error if the integrals have not converged. The results are still written.
fn check_convergence(duty: &Duty) -> Result<(), Failure> {
    if duty.cycle.has_converged() {
        return Ok(());
    }
    Err(Failure::Cannot(words().no_believable_integrals().into()))
}
