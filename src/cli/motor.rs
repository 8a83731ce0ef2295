//! `krank motor`: what a scene asks of its motor over one cycle.

use super::args::{Format, MotorArgs};
use super::commands::tell_of_near_misses;
use super::failure::{Failure, note};
use super::output::{write_text, write_to};
use super::screen::Screen;
use super::source::Opened;
use crate::nearest::nearest;
use crate::quantity::Catalogue;
use crate::report::{MotorReport, MotorWishes, limits_text};
use crate::scene::{Motor, Scene};
use crate::solver::{Range, Solver};
use crate::study::motor::{Duty, NoDuty, is_within};
use crate::{Body, SlideId};

pub(super) fn motor(args: &MotorArgs, screen: Screen) -> Result<(), Failure> {
    let Opened { scene, solver } = args.scene.open_for(&args.output)?;
    let wishes = MotorWishes {
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
    tell_of_near_misses(&scene, &solver, screen);
    let report = MotorReport::new(&scene, &solver, wishes);
    tell_of_no_ram(args, &report, screen);
    let output = args.output.output.as_deref();
    match &report.duty {
        Ok(_) | Err(NoDuty::Withheld(_)) => {}
        Err(NoDuty::NothingActs) if args.format == Format::Csv || report.ram.is_err() => {
            return Err(Failure::Cannot(NOTHING_ACTS.into()));
        }
        Err(NoDuty::NothingActs) => note(NOTHING_ACTS, screen),
    }
    match args.format {
        Format::Text => write_text(output, &report.to_text(screen.ascii))?,
        Format::Json => write_text(output, &format!("{:#}\n", report.to_json()))?,
        Format::Csv => write_to(output, |out| report.write_csv(out))?,
    }
    match &report.duty {
        Ok(duty) => judge(duty),
        Err(NoDuty::NothingActs) => Ok(()),
        Err(NoDuty::Withheld(hidden)) => {
            let catalogue = Catalogue::new(&scene);
            Err(Failure::Cannot(hidden.text(&catalogue.driver().unit)))
        }
    }
}

/// What the scene says of its motor, where no option says otherwise.
fn given(args: &MotorArgs, scene: &Scene) -> Result<Motor, Failure> {
    let known = scene.motor.unwrap_or_default();
    let speed = match &args.speed {
        None => known.speed,
        Some(text) => match scene.speed(text) {
            Ok(speed) if speed > 0.0 => Some(speed),
            Ok(_) => return Err(Failure::Usage("--speed: it must be greater than 0".into())),
            Err(why) => return Err(Failure::Usage(format!("--speed: {why}"))),
        },
    };
    let motor = Motor {
        rated: args.rated.or(known.rated),
        peak: args.peak.or(known.peak),
        speed,
        flywheel: args.flywheel.or(known.flywheel),
        fluctuation: args.fluctuation.or(known.fluctuation),
        tolerance: args.tolerance.or(known.tolerance),
    };
    refused(&motor).map_or(Ok(motor), |why| Err(Failure::Usage(why)))
}

/// What the numbers must be to each other, as in the scene's [motor].
fn refused(motor: &Motor) -> Option<String> {
    if let (Some(rated), Some(peak)) = (motor.rated, motor.peak)
        && peak < rated
    {
        return Some(format!(
            "--peak: {peak} is less than the rated {rated}; the peak is what the motor gives for a short while, at least as much as without end"
        ));
    }
    motor.fluctuation.filter(|share| *share > 1.0).map(|share| {
        format!("--fluctuation: {share} is above 1; it is (greatest - least) / mean of the speed: 0.02 is 2 %")
    })
}

/// The slide that is meant.
fn ram(scene: &Scene, name: &str) -> Result<SlideId, Failure> {
    let mechanism = &scene.mechanism;
    let mut all = mechanism.slide_ids();
    let on_ground = |id: &SlideId| mechanism.slide(*id).on == Body::Ground;
    match all.find(|&id| scene.slide_name(id) == name) {
        Some(slide) if on_ground(&slide) => Ok(slide),
        Some(_) => Err(Failure::Usage(format!(
            "--ram: the guide of `{name}` is not on the ground; a ram's is"
        ))),
        None => {
            let names = mechanism.slide_ids().filter(on_ground);
            let names: Vec<&str> = names.map(|id| scene.slide_name(id)).collect();
            let mend = match nearest(name, names.iter().copied()) {
                Some(near) => format!("did you mean `{near}`?"),
                None if names.is_empty() => "no slide has its guide on the ground".into(),
                None => format!("there are {}", names.join(", ")),
            };
            Err(Failure::Usage(format!(
                "--ram: no slide is named `{name}`; {mend}"
            )))
        }
    }
}

/// The part of the motion that is gone through there and back.
fn between(
    args: &MotorArgs,
    scene: &Scene,
    solver: &Solver,
) -> Result<Option<(f64, f64)>, Failure> {
    let (Some(from), Some(to)) = (args.from, args.to) else {
        return Ok(None);
    };
    // Of a driver that turns, from 300 to 60 deg is the way over the full turn.
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
        return Err(Failure::Usage(
            "--from and --to must be finite and differ: the driver goes from one to the other and back"
                .into(),
        ));
    }
    match range {
        Range::Limited { .. } if !is_within(range, low, high) => {
            let catalogue = Catalogue::new(scene);
            let covers = limits_text(range, catalogue.driver());
            Err(Failure::Cannot(format!(
                "--from {from} --to {to} leads out of the motion: the driver covers {covers}"
            )))
        }
        Range::Limited { .. } | Range::Full { .. } => Ok(Some((low, high))),
    }
}

/// Who asked about a ram should know why nothing is said of one.
fn tell_of_no_ram(args: &MotorArgs, report: &MotorReport, screen: Screen) {
    let asked = args.ram.is_some() || args.height.is_some() || args.torque.is_some();
    if let (true, Err(why)) = (asked || args.tolerance.is_some(), &report.ram) {
        note(&format!("no ram: {why}; --ram names one"), screen);
    }
}

/// Alone it is a failure: there is nothing to tell. A ram is something.
const NOTHING_ACTS: &str = "nothing acts on the mechanism: it has no load, spring or mass; [[loads]] in the scene, or `mass` of a link, would";

/// A study whose integrals cannot be believed has failed, though its figures are there to be looked at.
fn judge(duty: &Duty) -> Result<(), Failure> {
    if duty.cycle.has_converged() {
        return Ok(());
    }
    Err(Failure::Cannot(
        "what the driver must do has no integrals that can be believed over this cycle".into(),
    ))
}
