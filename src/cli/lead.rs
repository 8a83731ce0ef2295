//! The option that lets another input than the driver move.

use crate::cli::failure::Failure;
use crate::cli::place::out_of_reach;
use crate::cli::source::SolvableScene;
use crate::solver::Solver;
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
    pub(super) fn applied_to(&self, opened: SolvableScene) -> Result<SolvableScene, Failure> {
        let Some(name) = &self.by else {
            return Ok(opened);
        };
        let SolvableScene { scene, solver } = &opened;
        let misread = |e| Failure::Usage(words().of_option("--by", &e));
        let input = scene.input_named(name).map_err(misread)?;
        let driver = scene.mechanism.driver();
        if input == driver.input {
            return Ok(opened);
        }
        let led = scene.led_by(solver, input, driver.start);
        let scene = led.ok_or_else(|| out_of_reach(scene, solver, driver.start))?;
        let solver =
            Solver::new(&scene.mechanism).map_err(|fault| Failure::Scene(scene.explain(&fault)))?;
        Ok(SolvableScene { scene, solver })
    }
}
