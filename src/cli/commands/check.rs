//! `krank list`, `krank check` and `krank start`: lists presets, interprets a scene, and writes its
//! start positions.

use crate::cli::failure::Failure;
use crate::cli::formats::TextOrJson;
use crate::cli::lead::LeadArgs;
use crate::cli::output::{OutputArgs, write_scene, write_text};
use crate::cli::screen::TextScreen;
use crate::cli::source::{SceneArgs, SolvableScene};
use crate::report::Check;
use crate::scene::{Scene, presets, sanitized};
use crate::wording::words;
use clap::Args;

#[derive(Debug, Args)]
pub(in crate::cli) struct CheckArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    lead: LeadArgs,
    #[arg(help = words().format_of_output())]
    #[arg(long, value_enum, default_value_t = TextOrJson::Text)]
    format: TextOrJson,
    #[command(flatten)]
    output: OutputArgs,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct StartArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    output: OutputArgs,
}

/// Runs `krank list`: prints a line per preset.
pub(in crate::cli) fn list(screen: TextScreen) -> Result<(), Failure> {
    let presets = presets::all();
    let width = presets.iter().map(|p| p.name.len()).max().unwrap_or(0);
    let mut text = String::new();
    for preset in presets {
        let scene = Scene::parse(preset.text, preset.name).map_err(Failure::Scene)?;
        let title = sanitized(&scene.title(), screen.ascii);
        text.push_str(&format!("{:width$}  {title}\n", preset.name));
    }
    write_text(None, &text)
}

/// Runs `krank check`: prints the interpretation of a scene.
pub(in crate::cli) fn check(args: &CheckArgs, screen: TextScreen) -> Result<(), Failure> {
    let opened = args.scene.open_for(&args.output)?;
    let SolvableScene { scene, solver } = args.lead.applied_to(opened)?;
    let check = Check::new(&scene, &solver);
    let text = match args.format {
        TextOrJson::Text => check.to_text(screen.ascii),
        TextOrJson::Json => format!("{:#}\n", check.to_json()),
    };
    write_text(args.output.output.as_deref(), &text)
}

/// Runs `krank start`: prints the scene with the start positions of an assembly.
pub(in crate::cli) fn start(args: &StartArgs) -> Result<(), Failure> {
    let SolvableScene { scene, solver } = args.scene.open()?;
    let start = scene.mechanism.driver().start;
    match scene.with_start_of(&solver, start) {
        Some(text) => write_scene(args.output.output.as_deref(), &text),
        None => Err(Failure::Cannot(words().no_start_tells_assembly().into())),
    }
}
