//! Opening scenes from inside the workbench: what is wrong with one is said in a line.

use super::{Opened, Origin};
use crate::scene::presets::Preset;
use crate::scene::{Diagnostics, LARGEST_FILE, Scene};
use crate::solver::Solver;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// Opens a preset; in words what is wrong with it, which a test keeps from happening.
pub(crate) fn preset(preset: &Preset) -> Result<Opened, String> {
    let origin = Origin::Preset(preset.name.to_owned());
    let fault = |d| {
        format!(
            "the preset {} cannot be opened: {}",
            preset.name,
            first_words(&d)
        )
    };
    text(preset.text, origin).map_err(fault)
}

/// Opens a file; in words what is wrong with it.
pub(crate) fn file(path: &Path) -> Result<Opened, String> {
    let shown = path.display().to_string();
    let bytes = contents(path).map_err(|e| format!("cannot read {shown}: {e}"))?;
    let scene = Scene::read(&bytes, &shown).and_then(assembled);
    let (scene, solver) = scene.map_err(|d| format!("{shown}: {}", first_words(&d)))?;
    let origin = Origin::File(path.to_owned());
    Ok(Opened {
        scene,
        solver,
        origin,
    })
}

/// Opens a text that comes from somewhere.
pub(crate) fn text(text: &str, origin: Origin) -> Result<Opened, Diagnostics> {
    let name = match &origin {
        Origin::Preset(name) => name.clone(),
        Origin::File(path) => path.display().to_string(),
        Origin::Stdin => "stdin".into(),
    };
    let (scene, solver) = Scene::parse(text, &name).and_then(assembled)?;
    Ok(Opened {
        scene,
        solver,
        origin,
    })
}

fn assembled(scene: Scene) -> Result<(Scene, Solver), Diagnostics> {
    match Solver::new(&scene.mechanism) {
        Ok(solver) => Ok((scene, solver)),
        Err(fault) => Err(scene.explain(&fault)),
    }
}

/// What a file holds, up to one byte more than a scene may have.
fn contents(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let most = u64::try_from(LARGEST_FILE).unwrap_or(u64::MAX);
    let file = File::open(path)?;
    file.take(most.saturating_add(1)).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// What a message begins with.
pub(crate) fn first_words(diagnostics: &Diagnostics) -> String {
    let first = diagnostics.items.first();
    first.map_or_else(String::new, |item| item.message.clone())
}
