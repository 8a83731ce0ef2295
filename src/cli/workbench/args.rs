//! Arguments of the workbench.

#[cfg(feature = "tui")]
use crate::cli::choice::{OptionValue, OrAuto, one_of};
#[cfg(feature = "tui")]
use crate::cli::picture::{GLYPHS, Size};
use crate::cli::source::AssemblyArgs;
#[cfg(feature = "tui")]
use crate::drawing::Glyphs;
#[cfg(feature = "tui")]
use crate::report::WrittenDecimal;
#[cfg(feature = "tui")]
use crate::tui::{Colours, PictureChoice, PictureProtocol, Theme, View};
#[cfg(feature = "tui")]
use crate::wording::Words;
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
    #[arg(long, value_parser = one_of(&GLYPHS), default_value = "auto")]
    pub(in crate::cli) glyphs: OrAuto<Glyphs>,
    #[cfg(feature = "tui")]
    #[arg(help = words().colours_to_draw_with())]
    #[arg(long, visible_alias = "color", value_parser = one_of(&COLOURS), default_value = "auto")]
    pub(in crate::cli) colour: OrAuto<Colours>,
    #[cfg(feature = "tui")]
    #[arg(help = words().theme_to_draw_with())]
    #[arg(long, value_parser = one_of(&THEMES))]
    pub(in crate::cli) theme: Option<Theme>,
    #[cfg(feature = "tui")]
    #[arg(help = words().way_of_pictures())]
    #[arg(long, value_parser = one_of(&PICTURES))]
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
const COLOURS: [OptionValue<OrAuto<Colours>>; 5] = [
    ("auto", <dyn Words>::colours_as_allowed, None),
    ("none", <dyn Words>::colours_none, Some(Colours::None)),
    (
        "16",
        <dyn Words>::colours_of_palette,
        Some(Colours::Sixteen),
    ),
    ("256", <dyn Words>::colours_fixed, Some(Colours::Indexed)),
    ("true", <dyn Words>::colours_any, Some(Colours::True)),
];

#[cfg(feature = "tui")]
const THEMES: [OptionValue<Theme>; 4] = [
    ("auto", <dyn Words>::theme_auto, Theme::Auto),
    ("light", <dyn Words>::theme_light, Theme::Light),
    ("dark", <dyn Words>::theme_dark, Theme::Dark),
    ("plain", <dyn Words>::theme_plain, Theme::Plain),
];

#[cfg(feature = "tui")]
const PICTURES: [OptionValue<PictureChoice>; 5] = [
    ("auto", <dyn Words>::pictures_as_told, PictureChoice::Auto),
    (
        "kitty",
        <dyn Words>::pictures_of_kitty,
        PictureChoice::By(PictureProtocol::Kitty),
    ),
    (
        "iterm",
        <dyn Words>::pictures_of_iterm,
        PictureChoice::By(PictureProtocol::Iterm),
    ),
    (
        "sixel",
        <dyn Words>::pictures_of_sixels,
        PictureChoice::By(PictureProtocol::Sixel),
    ),
    ("none", <dyn Words>::pictures_never, PictureChoice::Never),
];

#[cfg(test)]
mod tests {
    #[cfg(feature = "tui")]
    #[test]
    fn options_have_names_of_the_configuration() {
        use super::{COLOURS, Colours, PICTURES, PictureChoice, THEMES};

        assert_eq!(PICTURES.map(|(.., picture)| picture), PictureChoice::ALL);
        for (name, _, picture) in PICTURES {
            assert_eq!(name, picture.name());
        }
        for (name, _, theme) in THEMES {
            assert_eq!(name, theme.name());
        }
        for (name, _, colours) in COLOURS {
            assert_eq!(name, colours.map_or("auto", Colours::name));
        }
    }
}
