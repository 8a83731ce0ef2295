//! Arguments of the workbench.

#[cfg(feature = "tui")]
use crate::cli::choice::{OptionValue, OrAuto, one_of, option_values, or_auto};
#[cfg(feature = "tui")]
use crate::cli::picture::{Size, glyph_choices};
use crate::cli::source::AssemblyArgs;
#[cfg(feature = "tui")]
use crate::drawing::Glyphs;
#[cfg(feature = "tui")]
use crate::report::WrittenDecimal;
#[cfg(feature = "tui")]
use crate::tui::{Colours, PictureChoice, Theme, View};
use crate::wording::words;
use clap::Args;
#[cfg(feature = "tui")]
use clap::{ValueEnum, builder::PossibleValue};
use std::path::PathBuf;

/// The scene that opens if the command line names none.
pub(in crate::cli) const DEFAULT_SCENE: &str = "four-bar";

/// The workbench, which opens where no command is given.
#[derive(Debug, Args)]
pub(in crate::cli) struct WorkbenchArgs {
    #[arg(help = words().name_of_scene_or(DEFAULT_SCENE))]
    pub(in crate::cli) scene: Option<PathBuf>,
    #[command(flatten)]
    pub(in crate::cli) assembly: AssemblyArgs,
    #[cfg(feature = "tui")]
    #[arg(help = words().where_to_open())]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(in crate::cli) at: Option<WrittenDecimal>,
    #[cfg(feature = "tui")]
    #[arg(help = words().characters_to_draw_with())]
    #[arg(long, value_parser = one_of(glyph_choices()), default_value = "auto")]
    pub(in crate::cli) glyphs: OrAuto<Glyphs>,
    #[cfg(feature = "tui")]
    #[arg(help = words().colours_to_draw_with())]
    #[arg(long, visible_alias = "color", value_parser = one_of(colours()), default_value = "auto")]
    pub(in crate::cli) colour: OrAuto<Colours>,
    #[cfg(feature = "tui")]
    #[arg(help = words().theme_to_draw_with())]
    #[arg(long, value_parser = one_of(themes()))]
    pub(in crate::cli) theme: Option<Theme>,
    #[cfg(feature = "tui")]
    #[arg(help = words().way_of_pictures())]
    #[arg(long, value_parser = one_of(pictures()))]
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
fn colours() -> Vec<OptionValue<OrAuto<Colours>>> {
    let about = [
        words().colours_none(),
        words().colours_of_palette(),
        words().colours_fixed(),
        words().colours_any(),
    ];
    let colours = option_values(Colours::ALL, Colours::name, about);
    or_auto(words().colours_as_allowed(), colours)
}

#[cfg(feature = "tui")]
fn themes() -> Vec<OptionValue<Theme>> {
    let about = [
        words().theme_auto(),
        words().theme_light(),
        words().theme_dark(),
        words().theme_plain(),
    ];
    option_values(Theme::ALL, Theme::name, about)
}

#[cfg(feature = "tui")]
fn pictures() -> Vec<OptionValue<PictureChoice>> {
    let about = [
        words().pictures_as_told(),
        words().pictures_of_kitty(),
        words().pictures_of_iterm(),
        words().pictures_of_sixels(),
        words().pictures_never(),
    ];
    option_values(PictureChoice::ALL, PictureChoice::name, about)
}
