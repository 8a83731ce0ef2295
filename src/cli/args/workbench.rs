//! Arguments of the workbench.

use super::AssemblyArgs;
#[cfg(feature = "tui")]
use super::{GlyphChoice, Size};
#[cfg(feature = "tui")]
use crate::report::WrittenDecimal;
#[cfg(feature = "tui")]
use crate::tui::{PictureChoice, PictureProtocol, View};
use crate::wording::words;
use clap::Args;
#[cfg(feature = "tui")]
use clap::{ValueEnum, builder::PossibleValue};
use std::path::PathBuf;

/// The scene that opens if the command line names none.
pub(in crate::cli) const USUAL_SCENE: &str = "four-bar";

/// The workbench, which opens where no command is given.
#[derive(Debug, Args)]
pub(in crate::cli) struct WorkbenchArgs {
    #[arg(help = words().name_of_scene_or(USUAL_SCENE))]
    pub(in crate::cli) scene: Option<PathBuf>,
    #[command(flatten)]
    pub(in crate::cli) assembly: AssemblyArgs,
    #[cfg(feature = "tui")]
    #[arg(help = words().where_to_open())]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(in crate::cli) at: Option<WrittenDecimal>,
    #[cfg(feature = "tui")]
    #[arg(help = words().characters_to_draw_with())]
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) glyphs: GlyphChoice,
    #[cfg(feature = "tui")]
    #[arg(help = words().colours_to_draw_with())]
    #[arg(long, visible_alias = "color", value_enum, default_value_t)]
    pub(in crate::cli) colour: Colour,
    #[cfg(feature = "tui")]
    #[arg(help = words().theme_to_draw_with())]
    #[arg(long, value_enum)]
    pub(in crate::cli) theme: Option<ThemeChoice>,
    #[cfg(feature = "tui")]
    #[arg(help = words().way_of_pictures())]
    #[arg(long, value_enum)]
    pub(in crate::cli) picture: Option<PictureChoice>,
    #[cfg(feature = "tui")]
    #[arg(help = words().view_to_open_with())]
    #[arg(long, value_enum)]
    pub(in crate::cli) view: Option<View>,
    #[cfg(feature = "tui")]
    #[arg(help = words().print_and_leave())]
    #[arg(long)]
    pub(in crate::cli) print: bool,
    #[cfg(feature = "tui")]
    #[arg(help = words().size_of_print())]
    #[arg(long, value_name = "COLSxROWS", requires = "print")]
    pub(in crate::cli) size: Option<Size>,
    #[cfg(feature = "tui")]
    #[arg(help = words().tell_of_terminal())]
    #[arg(long)]
    pub(in crate::cli) diagnose: bool,
    #[cfg(feature = "tui")]
    #[arg(help = words().configuration_file())]
    #[arg(long, value_name = "FILE")]
    pub(in crate::cli) config: Option<PathBuf>,
}

#[cfg(feature = "tui")]
impl ValueEnum for View {
    fn value_variants<'a>() -> &'a [View] {
        &View::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.name()).help(self.about()))
    }
}

#[cfg(feature = "tui")]
impl ValueEnum for PictureChoice {
    fn value_variants<'a>() -> &'a [PictureChoice] {
        &PictureChoice::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let about = match self {
            PictureChoice::Auto => words().pictures_as_told(),
            PictureChoice::By(PictureProtocol::Kitty) => words().pictures_of_kitty(),
            PictureChoice::By(PictureProtocol::Iterm) => words().pictures_of_iterm(),
            PictureChoice::By(PictureProtocol::Sixel) => words().pictures_of_sixels(),
            PictureChoice::Never => words().pictures_never(),
        };
        Some(PossibleValue::new(self.name()).help(about))
    }
}

/// The colours that the workbench draws with.
#[cfg(feature = "tui")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum Colour {
    #[value(help = words().colours_as_allowed())]
    #[default]
    Auto,
    #[value(help = words().colours_none())]
    None,
    #[value(help = words().colours_of_palette())]
    #[value(name = "16")]
    Palette,
    #[value(help = words().colours_fixed())]
    #[value(name = "256")]
    Indexed,
    #[value(help = words().colours_any())]
    True,
}

/// Colours that are chosen for a ground.
#[cfg(feature = "tui")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum ThemeChoice {
    #[value(help = words().theme_auto())]
    Auto,
    #[value(help = words().theme_light())]
    Light,
    #[value(help = words().theme_dark())]
    Dark,
    #[value(help = words().theme_plain())]
    Plain,
}
