//! Writes completion scripts for shells, with the names of presets, tasks, topics and columns, and of
//! values of the whole motion.

use crate::cli::failure::Failure;
use crate::cli::output::write_text;
use crate::cli::screen::TextScreen;
use crate::manual::TOPICS;
use crate::scene::presets;
use crate::study::CycleFigure;
use crate::task_file::ExampleTask;
use clap::builder::PossibleValuesParser;
use clap::{Arg, Command, ValueEnum};
use clap_complete::{Generator, Shell};
use clap_complete_nushell::Nushell;

/// A shell with completions.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(in crate::cli) enum CompletionShell {
    Bash,
    Elvish,
    Fish,
    Nushell,
    #[value(name = "powershell")]
    PowerShell,
    Zsh,
}

/// Names that only the script can look up, because they depend on the scene: a placeholder for their
/// list, and their part in the names of the shell functions.
const SCENE_NAMES: [(&str, &str); 2] = [(COLUMNS, "columns"), (FIGURES, "figures")];
const COLUMNS: &str = "KRANK-COLUMNS";
const FIGURES: &str = "KRANK-FIGURES";

/// The parts of a script that look up names of the scene. `NAMES` is their placeholder in `listed`, and
/// their part in `call`.
struct NameLookup {
    /// The shell functions for the lookup.
    functions: &'static str,
    /// The generated text after which the functions are inserted; empty for the start of the script.
    behind: &'static str,
    /// The generated list of an option's values.
    listed: &'static str,
    /// The call of the functions that replaces the list.
    call: &'static str,
}

/// Runs `krank completions`: writes the script for a shell to standard output.
pub(in crate::cli) fn completions(
    shell: CompletionShell,
    krank: &Command,
    screen: TextScreen,
) -> Result<(), Failure> {
    let script = match shell {
        CompletionShell::Bash => with_lookup(Shell::Bash, krank, &BASH),
        CompletionShell::Elvish => generated(Shell::Elvish, with_names(krank.clone())),
        CompletionShell::Fish => with_lookup(Shell::Fish, krank, &FISH) + &fish_arguments(krank),
        CompletionShell::Nushell => with_lookup(Nushell, krank, &NUSHELL),
        CompletionShell::PowerShell => generated(Shell::PowerShell, with_names(krank.clone())),
        CompletionShell::Zsh => with_zsh_arguments(with_lookup(Shell::Zsh, krank, &ZSH)),
    };
    write_text(None, &screen.shown(&script))
}

const BASH: NameLookup = NameLookup {
    functions: include_str!("scripts/names.bash"),
    behind: "",
    listed: "COMPREPLY=($(compgen -W \"NAMES\" -- \"${cur}\"))",
    call: "_krank_NAMES",
};
const ZSH: NameLookup = NameLookup {
    functions: include_str!("scripts/names.zsh"),
    behind: "autoload -U is-at-least\n\n",
    listed: "(NAMES)",
    call: "_krank_NAMES",
};
const FISH: NameLookup = NameLookup {
    functions: include_str!("scripts/names.fish"),
    behind: "",
    listed: "-a \"NAMES\\t''\"",
    call: "-a \"(__fish_complete_list , __krank_NAMES)\"",
};
const NUSHELL: NameLookup = NameLookup {
    functions: include_str!("scripts/names.nu"),
    behind: "module completions {\n",
    listed: "[] {\n    [ \"NAMES\" ]",
    call: "[context: string] {\n    NAMES-of $context",
};

/// Generates a script with the built-in names and the lookup of names of the scene.
fn with_lookup(generator: impl Generator, krank: &Command, lookup: &NameLookup) -> String {
    let placeholder = |arg: &Arg| scene_names(arg).map(|placeholder| vec![placeholder]);
    let krank = with_values(with_names(krank.clone()), placeholder);
    let mut script = generated(generator, krank);
    for (placeholder, names) in SCENE_NAMES {
        let listed = lookup.listed.replace("NAMES", placeholder);
        script = script.replace(&listed, &lookup.call.replace("NAMES", names));
    }
    let functions = (lookup.functions)
        .replace("KRANK-WHOLE", &CycleFigure::MOTION_FIGURES.join(" "))
        .replace("KRANK-PROPERTIES", &CycleFigure::properties().join(" "));
    match script.split_once(lookup.behind) {
        Some((before, after)) => [before, lookup.behind, &functions, after].concat(),
        None => script,
    }
}

/// Returns the placeholder of an option whose values are columns, or values of the whole motion, of the
/// scene.
fn scene_names(arg: &Arg) -> Option<&'static str> {
    match arg.get_value_names() {
        Some([name]) => match name.as_str() {
            "PATTERNS" => Some(COLUMNS),
            "NAME" if arg.get_id() == "against" => Some(COLUMNS),
            "FIGURE" | "FIGURES" | "GOAL" => Some(FIGURES),
            _ => None,
        },
        _ => None,
    }
}

/// Generates the script of a command line.
fn generated(generator: impl Generator, mut krank: Command) -> String {
    // The generator panics if it cannot write, so it writes to memory.
    let mut script = Vec::new();
    clap_complete::generate(generator, &mut krank, "krank", &mut script);
    String::from_utf8_lossy(&script).into_owned()
}

/// Returns the command line with the built-in names as values of scenes, tasks and topics.
fn with_names(krank: Command) -> Command {
    with_values(krank, |arg| match arg.get_id().as_str() {
        "scene" | "sheet" => Some(preset_names()),
        "task" => Some(task_names()),
        "topic" => Some(TOPICS.iter().map(|topic| topic.name).collect()),
        _ => None,
    })
}

/// Returns the command line with these values for every argument that has some.
fn with_values(krank: Command, values: impl Fn(&Arg) -> Option<Vec<&'static str>>) -> Command {
    let with = |arg: Arg| match values(&arg) {
        Some(values) => arg.value_parser(PossibleValuesParser::new(values)),
        None => arg,
    };
    let krank = krank.mut_args(with);
    krank.mut_subcommands(|command| command.mut_args(with))
}

fn preset_names() -> Vec<&'static str> {
    presets::all().iter().map(|preset| preset.name).collect()
}

fn task_names() -> Vec<&'static str> {
    ExampleTask::all().iter().map(|task| task.name).collect()
}

/// Corrects the arguments in the script of the generator for zsh.
fn with_zsh_arguments(mut script: String) -> String {
    // The generator completes only names; scenes and tasks may also be files.
    for names in [preset_names(), task_names()] {
        let names = names.join(" ");
        let or_files = format!("{{compadd {names}; _files}}");
        script = script.replace(&format!("({names})"), &or_files);
    }
    // The generator expects a command after the scene, but either of them is the first word.
    let (scene, command) = (
        "\n'::scene -- ",
        "_describe -t commands 'krank commands' commands \"$@\"",
    );
    if let Some((before, after)) = script.split_once(scene) {
        let after = after.split_once('\n').map_or("", |(_, after)| after);
        script = format!("{before}\n{after}").replace("$line[2]", "$line[1]");
    }
    let or_scene = format!(
        "{command}\n    compadd {}\n    _files",
        preset_names().join(" ")
    );
    script.replace(command, &or_scene)
}

/// Returns completions of the positional arguments, which the generator for fish omits.
fn fish_arguments(krank: &Command) -> String {
    let krank = with_names(krank.clone());
    let of = |command: &Command, condition: &str| {
        let values = command.get_positionals().flat_map(Arg::get_possible_values);
        let values = values.map(|value| value.get_name().to_owned());
        match values.collect::<Vec<_>>().join(" ") {
            none if none.is_empty() => none,
            values => format!("complete -c krank -n \"{condition}\" -a \"{values}\"\n"),
        }
    };
    let commands = krank.get_subcommands().map(|command| {
        let condition = format!("__fish_krank_using_subcommand {}", command.get_name());
        of(command, &condition)
    });
    of(&krank, "__fish_krank_needs_command") + &commands.collect::<String>()
}
