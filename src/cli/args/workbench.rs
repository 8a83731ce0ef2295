//! How the workbench opens.

use super::{AssemblyArgs, SCENE_HELP};
#[cfg(feature = "tui")]
use super::{Glyphs, Size};
#[cfg(feature = "tui")]
use crate::report::Decimal;
#[cfg(feature = "tui")]
use crate::tui::View;
use clap::Args;
#[cfg(feature = "tui")]
use clap::{ValueEnum, builder::PossibleValue};
use std::path::PathBuf;

/// The scene that opens where none is named.
pub(in crate::cli) const USUAL_SCENE: &str = "four-bar";

/// The workbench, which opens where no command is given.
#[derive(Debug, Args)]
pub(in crate::cli) struct WorkbenchArgs {
    #[arg(help = format!("{SCENE_HELP} [default: {USUAL_SCENE}]"))]
    pub(in crate::cli) scene: Option<PathBuf>,
    #[command(flatten)]
    pub(in crate::cli) assembly: AssemblyArgs,
    /// Where to open: deg of the driven link, or the position of the driven slide
    #[cfg(feature = "tui")]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(in crate::cli) at: Option<Decimal>,
    /// The characters to draw with
    #[cfg(feature = "tui")]
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) glyphs: Glyphs,
    /// The colours to draw with
    #[cfg(feature = "tui")]
    #[arg(long, visible_alias = "color", value_enum, default_value_t)]
    pub(in crate::cli) colour: Colour,
    /// Which colours stand for the names of the palette [default: auto]
    #[cfg(feature = "tui")]
    #[arg(long, value_enum)]
    pub(in crate::cli) theme: Option<Theme>,
    /// The view to open with
    #[cfg(feature = "tui")]
    #[arg(long, value_enum)]
    pub(in crate::cli) view: Option<View>,
    /// Print the screen that opens as text, and leave: no terminal is needed
    #[cfg(feature = "tui")]
    #[arg(long)]
    pub(in crate::cli) print: bool,
    /// The size of the screen that is printed [default: 80x24]
    #[cfg(feature = "tui")]
    #[arg(long, value_name = "COLSxROWS", requires = "print")]
    pub(in crate::cli) size: Option<Size>,
    /// Tell what was found of the terminal, and why
    #[cfg(feature = "tui")]
    #[arg(long)]
    pub(in crate::cli) diagnose: bool,
    /// The configuration [default: ~/.config/krank/config.toml]
    #[cfg(feature = "tui")]
    #[arg(long, value_name = "FILE")]
    pub(in crate::cli) config: Option<PathBuf>,
}

#[cfg(feature = "tui")]
impl ValueEnum for View {
    fn value_variants<'a>() -> &'a [View] {
        &View::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let pane = self.pane();
        Some(PossibleValue::new(pane.name()).help(pane.about()))
    }
}

/// The colours that the workbench draws with.
#[cfg(feature = "tui")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum Colour {
    /// As the terminal and NO_COLOR allow
    #[default]
    Auto,
    /// No colour, but bold and reversed
    None,
    /// The 16 of the terminal's palette
    #[value(name = "16")]
    Palette,
    /// The fixed palette of 256
    #[value(name = "256")]
    Indexed,
    /// Any colour, in 24 bits
    True,
}

/// Colours that are chosen for a ground.
#[cfg(feature = "tui")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum Theme {
    /// The palette's own, or such as read on any ground
    Auto,
    /// For a light ground
    Light,
    /// For a dark ground
    Dark,
    /// No colours
    Plain,
}
