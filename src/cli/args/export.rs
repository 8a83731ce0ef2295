//! Arguments of `krank export`, which writes scripts.

use super::{OutputArgs, SceneArgs};
use crate::handover::ScriptLanguage;
use crate::wording::words;
use clap::{Args, ValueEnum};

/// The language of a script.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum ScriptFormat {
    #[value(help = words().format_python())]
    Python,
    #[value(help = words().format_matlab(), alias = "octave")]
    Matlab,
}

impl ScriptFormat {
    pub(in crate::cli) fn language(self) -> ScriptLanguage {
        match self {
            ScriptFormat::Python => ScriptLanguage::Python,
            ScriptFormat::Matlab => ScriptLanguage::Matlab,
        }
    }
}

#[derive(Debug, Args)]
pub(in crate::cli) struct ExportArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    #[arg(help = words().how_to_write())]
    #[arg(long, value_enum)]
    pub(in crate::cli) format: ScriptFormat,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}
