//! The option that lets another input than the driver move, and scenes whose inputs follow a point.

use crate::cli::failure::Failure;
use crate::cli::formats::FigureArgs;
use crate::cli::place::out_of_reach;
use crate::cli::source::SolvableScene;
use crate::scene::{LeadingPoint, Scene};
use crate::solver::{PointLeader, Solver};
use crate::wording::words;
use clap::Args;

/// The input that moves.
#[derive(Debug, Args)]
pub(super) struct LeadArgs {
    #[arg(help = words().input_that_moves())]
    #[arg(long = "by", value_name = "INPUT")]
    by: Option<String>,
}

impl LeadArgs {
    /// Returns the scene with the requested input as its driver, where the scene opens.
    /// Such an input does not follow a leading point.
    pub(super) fn applied_to(&self, mut opened: SolvableScene) -> Result<SolvableScene, Failure> {
        let Some(name) = &self.by else {
            return Ok(opened);
        };
        let SolvableScene { scene, solver } = &opened;
        let misread = |e| Failure::Usage(words().of_option("--by", &e));
        let input = scene.input_named(name).map_err(misread)?;
        let driver = scene.mechanism.driver();
        if input == driver.input {
            opened.scene.lead = None;
            return Ok(opened);
        }
        let led = scene.led_by(solver, input, driver.start);
        let scene = led.ok_or_else(|| out_of_reach(scene, solver, driver.start))?;
        let solver =
            Solver::new(&scene.mechanism).map_err(|fault| Failure::Scene(scene.explain(&fault)))?;
        Ok(SolvableScene { scene, solver })
    }
}

/// Returns the inputs of a scene that follow its leading point, where the scene opens.
pub(super) fn leader(
    scene: &Scene,
    solver: &Solver,
    lead: &LeadingPoint,
) -> Result<PointLeader, Failure> {
    let leader = PointLeader::new(solver, lead.lead());
    leader.ok_or_else(|| out_of_reach(scene, solver, scene.mechanism.driver().start))
}

/// Returns an error if error bounds are requested where inputs follow a point: their values have
/// none.
pub(super) fn check_bounds_not_asked(figures: &FigureArgs) -> Result<(), Failure> {
    if figures.bounds || figures.sensitivity {
        return Err(Failure::Usage(words().lead_has_no_bounds().to_owned()));
    }
    Ok(())
}
