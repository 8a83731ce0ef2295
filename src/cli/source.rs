//! Finds and opens the scene on the command line.

use crate::assembly::AssemblyRequest;
use crate::cli::failure::{Failure, note};
use crate::cli::output::{self, OutputArgs};
use crate::cli::screen::TextScreen;
use crate::document::foreign;
use crate::files::{is_same_file, limited, read_any_file};
use crate::import::{self, Imported, is_address_argument};
use crate::quantity::check_figures;
use crate::scene::presets::{self, Preset};
use crate::scene::{MAX_FILE_SIZE, Scene};
use crate::solver::{Fault, Plan, Solver};
use crate::wording::words;
use clap::Args;
use std::io::{self, stdin};
use std::path::{Path, PathBuf, is_separator};

/// A scene, in the assembly that is meant.
#[derive(Debug, Args)]
pub(super) struct SceneArgs {
    #[arg(help = words().name_of_scene())]
    pub(super) scene: PathBuf,
    #[command(flatten)]
    pub(super) assembly: AssemblyArgs,
}

/// The assembly that is meant.
#[derive(Debug, Args)]
pub(super) struct AssemblyArgs {
    #[arg(help = words().assembly_of_group())]
    #[arg(long = "assembly", value_name = "GROUP=CHOICE", value_delimiter = ',')]
    pub(super) wishes: Vec<AssemblyRequest>,
}

/// A scene and its solver.
pub(super) struct SolvableScene {
    pub(super) scene: Scene,
    pub(super) solver: Solver,
}

impl SceneArgs {
    /// Opens the scene on the command line in the requested assembly.
    pub(super) fn open(&self) -> Result<SolvableScene, Failure> {
        load(&find(&self.scene)?, &self.assembly.wishes)
    }

    /// Opens the scene for a command whose output is not a scene.
    pub(super) fn open_for(&self, output: &OutputArgs) -> Result<SolvableScene, Failure> {
        open_for(&self.scene, &self.assembly.wishes, output)
    }
}

/// Reads, checks and assembles a scene for a command whose output is not a scene. Returns an error
/// if the output would overwrite the scene.
pub(super) fn open_for(
    name: &Path,
    requests: &[AssemblyRequest],
    output: &OutputArgs,
) -> Result<SolvableScene, Failure> {
    let source = find(name)?;
    check_output_differs(&source, output.output.as_deref())?;
    load(&source, requests)
}

/// Reads, checks and assembles the scene of a source.
pub(super) fn load(
    source: &SceneSource,
    requests: &[AssemblyRequest],
) -> Result<SolvableScene, Failure> {
    let scene = read(source)?;
    check_figures(&scene).map_err(Failure::Scene)?;
    let solver = assembled(&scene, requests)?;
    Ok(SolvableScene { scene, solver })
}

fn assembled(scene: &Scene, requests: &[AssemblyRequest]) -> Result<Solver, Failure> {
    let broken = |fault: &Fault| Failure::Scene(scene.explain(fault));
    if requests.is_empty() {
        return Solver::new(&scene.mechanism).map_err(|fault| broken(&fault));
    }
    let plan = Plan::of(&scene.mechanism).map_err(|fault| broken(&fault))?;
    let misread = |e| Failure::Usage(words().of_option("--assembly", &e));
    let choices = scene.picks(&plan, requests).map_err(misread)?;
    Solver::with_assembly(&scene.mechanism, &choices).map_err(|fault| {
        // A scene that opens in its default assembly is valid, so only the request cannot be met.
        if Solver::new(&scene.mechanism).is_err() {
            return broken(&fault);
        }
        let requests: Vec<String> = requests.iter().map(ToString::to_string).collect();
        let fault = scene.explain(&fault);
        let why = fault.first_words();
        let option = format!("--assembly {}", requests.join(","));
        Failure::Cannot(words().of_option(&option, &why))
    })
}

/// The source of a scene. An address contains a mechanism of another program.
#[derive(Debug)]
pub(super) enum SceneSource {
    Stdin,
    Preset(&'static Preset),
    File(PathBuf),
    Address(String),
}

impl SceneSource {
    /// Returns the name in messages.
    fn shown(&self) -> String {
        match self {
            SceneSource::Stdin => "stdin".to_owned(),
            SceneSource::Preset(preset) => preset.name.to_owned(),
            SceneSource::File(path) => path.display().to_string(),
            SceneSource::Address(address) => address.clone(),
        }
    }
}

/// Returns the source of the scene that the command line names.
pub(super) fn find(name: &Path) -> Result<SceneSource, Failure> {
    source(name, Path::exists)
}

/// Reads a scene, or the file of another program, whose remarks are printed.
pub(super) fn read(source: &SceneSource) -> Result<Scene, Failure> {
    if let SceneSource::Preset(preset) = source {
        return Scene::parse(preset.text, preset.name).map_err(Failure::Scene);
    }
    let bytes = bytes(source)?;
    let origin = source.shown();
    if import::recognize(&bytes).is_none() {
        return Scene::read(&bytes, &origin).map_err(Failure::Scene);
    }
    let imported = converted(source, &bytes)?;
    let screen = TextScreen::detect();
    for remark in &imported.remarks {
        note(remark, screen);
    }
    // Lines in messages are those of the scene, not of the file.
    let origin = words().import_scene_made_from(&origin);
    Scene::parse(&imported.text, &origin).map_err(Failure::Scene)
}

/// Returns the bytes of a source.
fn bytes(source: &SceneSource) -> Result<Vec<u8>, Failure> {
    match source {
        SceneSource::Stdin => standard_input(),
        SceneSource::Preset(preset) => Ok(preset.text.into()),
        SceneSource::File(path) => contents(path),
        SceneSource::Address(address) => Ok(address.clone().into_bytes()),
    }
}

/// Reads a file of another program: a path, `-` for standard input, or an address.
pub(super) fn foreign_contents(name: &Path) -> Result<(SceneSource, Vec<u8>), Failure> {
    let source = match name.to_str() {
        Some("-") => SceneSource::Stdin,
        Some(text) if is_address_argument(text) && !name.exists() => {
            SceneSource::Address(text.to_owned())
        }
        _ => SceneSource::File(name.to_owned()),
    };
    let bytes = bytes(&source)?;
    Ok((source, bytes))
}

/// Converts the file of another program to a scene.
pub(super) fn converted(source: &SceneSource, bytes: &[u8]) -> Result<Imported, Failure> {
    let shown = source.shown();
    let name = match source {
        SceneSource::File(path) => path.file_name().unwrap_or(path.as_os_str()),
        _ => shown.as_ref(),
    };
    import::import(bytes, &name.to_string_lossy())
        .map_err(|why| Failure::Usage(words().import_failed(&shown, &why.to_string())))
}

/// Returns `true` if another program wrote the file.
#[cfg(feature = "tui")]
pub(super) fn is_foreign(path: &Path) -> bool {
    let bytes = contents(path).ok();
    bytes.is_some_and(|bytes| import::recognize(&bytes).is_some())
}

/// Reads a scene or a task from standard input.
pub(super) fn standard_input() -> Result<Vec<u8>, Failure> {
    limited(stdin(), MAX_FILE_SIZE).map_err(|e| unreadable(words().standard_input(), &e))
}

/// Reads a scene or a task from a file.
pub(super) fn contents(path: &Path) -> Result<Vec<u8>, Failure> {
    let bytes = read_any_file(path, MAX_FILE_SIZE);
    bytes.map_err(|e| unreadable(&format!("`{}`", path.display()), &e))
}

/// Returns an error if the output is the file that is read, under any name: the scene would be
/// lost.
pub(super) fn check_output_differs(
    source: &SceneSource,
    output: Option<&Path>,
) -> Result<(), Failure> {
    let read = match source {
        SceneSource::Preset(_) | SceneSource::Address(_) => return Ok(()),
        SceneSource::Stdin => None,
        SceneSource::File(path) => Some(path.as_path()),
    };
    match is_same_file(read, output::file(output)) {
        false => Ok(()),
        true => Err(Failure::Usage(words().output_is_the_scene().into())),
    }
}

/// Returns an error if the output is the file of values that is read.
pub(super) fn check_output_differs_from_input(
    read: &Path,
    output: Option<&Path>,
) -> Result<(), Failure> {
    match is_same_file(Some(read), output::file(output)) {
        false => Ok(()),
        true => Err(Failure::Usage(
            words().output_is_read(&read.display().to_string()),
        )),
    }
}

fn unreadable(what: &str, error: &io::Error) -> Failure {
    Failure::Usage(words().cannot_read(what, error))
}

/// Resolves a scene's name. A bare name means a preset if there is one; a file of the same name
/// needs a path.
fn source(name: &Path, exists: impl Fn(&Path) -> bool) -> Result<SceneSource, Failure> {
    let file = || Ok(SceneSource::File(name.to_owned()));
    let Some(text) = name.to_str() else {
        return file();
    };
    if text == "-" {
        return Ok(SceneSource::Stdin);
    }
    let is_address = is_address_argument(text) && !exists(name);
    if is_address && import::recognize(text.as_bytes()).is_some() {
        return Ok(SceneSource::Address(text.to_owned()));
    }
    if let Some(message) = foreign(text) {
        let help = words().krank_reads_toml();
        return Err(Failure::Usage(format!("{message}; {help}")));
    }
    if is_address {
        return Err(Failure::Usage(words().is_a_pmks_address().to_owned()));
    }
    if text.contains(is_separator) || text.ends_with(".toml") {
        return file();
    }
    match presets::find(text) {
        Some(preset) => Ok(SceneSource::Preset(preset)),
        None if exists(name) => file(),
        None => Err(Failure::NoScene(text.to_owned())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(name: &str, exists: bool) -> String {
        match source(Path::new(name), |_| exists) {
            Ok(SceneSource::Stdin) => "stdin".into(),
            Ok(SceneSource::Preset(preset)) => format!("preset {}", preset.name),
            Ok(SceneSource::File(path)) => format!("file {}", path.display()),
            Ok(SceneSource::Address(address)) => format!("address {address}"),
            Err(Failure::NoScene(name)) => format!("no scene {name}"),
            Err(other) => panic!("{other:?}"),
        }
    }

    #[test]
    fn a_bare_name_is_a_preset_before_it_is_a_file() {
        assert_eq!(found("four-bar", true), "preset four-bar");
        assert_eq!(found("./four-bar", true), "file ./four-bar");
        assert_eq!(found("four-bar.toml", true), "file four-bar.toml");
        assert_eq!(found("scenes/four-bar", false), "file scenes/four-bar");
        assert_eq!(found("mine", true), "file mine");
        assert_eq!(found("-", true), "stdin");
        assert_eq!(found("mine", false), "no scene mine");
    }
}
