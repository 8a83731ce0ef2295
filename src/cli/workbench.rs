//! Opening the workbench.

use super::args::{Colour, Glyphs, Theme, WorkbenchArgs};
use super::failure::Failure;
use super::source::{Opened, Source, find, load};
use crate::drawing;
use crate::tui::{self, Colours, Options, Origin};

/// Opens the scene on the terminal and returns when the workbench is left.
pub(super) fn open(args: &WorkbenchArgs) -> Result<(), Failure> {
    let source = find(&args.scene)?;
    let Opened { scene, solver } = load(&source, &args.assembly.wishes)?;
    let origin = match source {
        Source::Stdin => Origin::Stdin,
        Source::Preset(preset) => Origin::Preset(preset.name.to_owned()),
        Source::File(path) => Origin::File(path),
    };
    let options = options(args);
    let opened = tui::Opened {
        scene,
        solver,
        origin,
    };
    tui::run(opened, &options).map_err(|error| {
        if error.is_usage() {
            Failure::Usage(error.to_string())
        } else {
            Failure::Cannot(error.to_string())
        }
    })
}

/// What is asked for on the command line.
pub(super) fn options(args: &WorkbenchArgs) -> Options {
    Options {
        at: args.at.map(|at| at.value()),
        glyphs: glyphs(args.glyphs),
        colours: colours(args.colour),
        theme: args.theme.map_or(tui::Theme::Auto, theme),
    }
}

fn theme(wish: Theme) -> tui::Theme {
    match wish {
        Theme::Auto => tui::Theme::Auto,
        Theme::Light => tui::Theme::Light,
        Theme::Dark => tui::Theme::Dark,
        Theme::Plain => tui::Theme::Plain,
    }
}

fn glyphs(wish: Glyphs) -> Option<drawing::Glyphs> {
    match wish {
        Glyphs::Auto => None,
        Glyphs::Ascii => Some(drawing::Glyphs::Ascii),
        Glyphs::Line => Some(drawing::Glyphs::Line),
        Glyphs::Braille => Some(drawing::Glyphs::Braille),
    }
}

fn colours(wish: Colour) -> Option<Colours> {
    match wish {
        Colour::Auto => None,
        Colour::None => Some(Colours::None),
        Colour::Palette => Some(Colours::Sixteen),
        Colour::Indexed => Some(Colours::Indexed),
        Colour::True => Some(Colours::True),
    }
}
