//! `krank plot`: plots values over the driver coordinate, time or another value.

use crate::Vec2;
use crate::cli::choice::{OptionValue, OrAuto, one_of, option_values};
use crate::cli::columns::{figures, named};
use crate::cli::external_values::measured;
use crate::cli::failure::{Failure, note};
use crate::cli::lead::LeadArgs;
use crate::cli::output::{OutputArgs, write_text};
use crate::cli::picture::{self, ASPECT, Size, glyph_choices};
use crate::cli::place::note_near_misses;
use crate::cli::rows::{first, last};
use crate::cli::screen::TextScreen;
use crate::cli::source::{SceneArgs, SolvableScene};
use crate::drawing::Glyphs;
use crate::drawing::plot::{Plot, PlotStyle};
use crate::quantity::{Abscissa, Catalogue, Curves, Quantity};
use crate::report::{WrittenDecimal, limits_text};
use crate::scene::Scene;
use crate::solver::{Condition, Range, Solver};
use crate::study::{BandKind, ToleranceStudy};
use crate::wording::words;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// Returns the limits that may be drawn beside a curve.
fn bands() -> Vec<OptionValue<BandKind>> {
    let kinds = [BandKind::Worst, BandKind::RootSumSquare];
    let about = [words().band_worst(), words().band_root_sum_square()];
    option_values(kinds, BandKind::word, about)
}

/// How a plot is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum PictureFormat {
    #[value(help = words().format_characters())]
    #[default]
    Text,
    #[value(help = words().format_svg())]
    Svg,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct PlotArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    lead: LeadArgs,
    #[arg(help = words().columns_to_plot())]
    #[arg(long, value_name = "PATTERNS", required = true)]
    columns: Vec<String>,
    #[arg(help = words().plot_against())]
    #[arg(long, value_name = "NAME", default_value = "driver")]
    against: String,
    #[arg(help = words().measured_figures())]
    #[arg(long, value_name = "FILE")]
    measured: Option<PathBuf>,
    #[arg(help = words().driver_begins())]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    from: Option<WrittenDecimal>,
    #[arg(help = words().driver_ends())]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    to: Option<WrittenDecimal>,
    #[arg(help = words().leave_extrema_out())]
    #[arg(long)]
    no_extrema: bool,
    #[arg(help = words().band_of_tolerances())]
    #[arg(long, value_parser = one_of(bands()))]
    band: Option<BandKind>,
    #[arg(help = words().characters_to_draw_with())]
    #[arg(long, value_parser = one_of(glyph_choices()), default_value = "auto")]
    glyphs: OrAuto<Glyphs>,
    #[arg(help = words().size_of_plot())]
    #[arg(long, value_name = "COLSxROWS")]
    size: Option<Size>,
    #[arg(help = words().format_of_output())]
    #[arg(long, value_enum, default_value_t)]
    format: PictureFormat,
    #[command(flatten)]
    output: OutputArgs,
}

/// Default size of an SVG in characters, and the size of a character in its units.
const SVG: Size = Size {
    cols: 100,
    rows: 40,
};
const CHARACTER: Vec2 = Vec2 { x: 8.0, y: 16.0 };

/// Returns the size of an SVG in its units.
pub(in crate::cli) fn svg_size(requested: Option<Size>) -> Vec2 {
    let Size { cols, rows } = requested.unwrap_or(SVG);
    Vec2::new(f64::from(cols) * CHARACTER.x, f64::from(rows) * CHARACTER.y)
}

/// Draws a plot in characters, in the requested size or that of the terminal. Returns the text and
/// its style.
pub(in crate::cli) fn plotted(
    plot: &Plot,
    (requested, output): (Option<Size>, &OutputArgs),
    glyphs: OrAuto<Glyphs>,
    extrema: bool,
) -> Result<(String, PlotStyle), Failure> {
    let Size { cols, rows } = picture::size(requested, output.output.as_deref());
    let look = PlotStyle {
        cols,
        // Every panel gets its minimum height, because the length of paper is unlimited.
        rows: match requested {
            Some(_) => rows,
            None => rows.max(plot.min_rows()),
        },
        glyphs: picture::glyphs(glyphs),
        aspect: ASPECT,
        extrema,
        first: 0,
    };
    if !plot.fits(&look) {
        return Err(Failure::Usage(words().too_small_for_plot(cols, rows)));
    }
    let text = plot.render(&look, None).text();
    Ok((picture::lettered(text, look.glyphs), look))
}

pub(in crate::cli) fn plot(args: &PlotArgs, screen: TextScreen) -> Result<(), Failure> {
    let opened = args.scene.open_for(&args.output)?;
    let SolvableScene { scene, solver } = args.lead.applied_to(opened)?;
    let mut catalogue = Catalogue::new(&scene);
    let quantities = figures(&mut catalogue, &args.columns)?;
    let quantities: Vec<Quantity> = quantities
        .into_iter()
        .filter(|q| q != catalogue.driver())
        .collect();
    if quantities.is_empty() {
        return Err(Failure::Usage(words().no_figures_to_plot().into()));
    }
    let abscissa = abscissa(&mut catalogue, &args.against)?;
    let range = solver.motion().range;
    let window = window(args, range)?;
    let curves = Curves::new(&scene, &solver, &quantities, abscissa, window).map_err(|e| {
        let option = format!("--against {}", args.against.trim());
        Failure::Cannot(words().of_option(&option, &e))
    })?;
    report_missing_values(&curves, &limits_text(range, catalogue.driver()), screen)?;
    note_near_misses(&scene, &solver, screen);
    let mut drawn = Plot::of(&curves);
    if let Some(file) = &args.measured {
        if curves.abscissa != Abscissa::Driver {
            return Err(Failure::Usage(words().measured_over_driver().into()));
        }
        let output = args.output.output.as_deref();
        let found = measured(file, output, &catalogue, Some(&quantities), screen)?;
        if let Some(left_out) = found.left_out() {
            note(&left_out, screen);
        }
        for (k, quantity) in found.figures().iter().enumerate() {
            let name = words().measured_of(&quantity.name);
            drawn.mark(&quantity.unit, &name, &found.points(k));
        }
    }
    if let Some(band) = args.band {
        add_band(&mut drawn, &curves, (&scene, &solver), &quantities, band)?;
    }
    let text = match args.format {
        PictureFormat::Text => text(args, &drawn, screen)?,
        PictureFormat::Svg => drawn.svg(&scene.name, svg_size(args.size), !args.no_extrema, None),
    };
    write_text(args.output.output.as_deref(), &text)?;
    match &curves.hidden {
        None => Ok(()),
        Some(hidden) => Err(Failure::Cannot(hidden.text(&catalogue.driver().unit))),
    }
}

/// Draws the deviation of the values permitted by the scene's tolerances as a band.
fn add_band(
    plot: &mut Plot,
    curves: &Curves,
    (scene, solver): (&Scene, &Solver),
    quantities: &[Quantity],
    band: BandKind,
) -> Result<(), Failure> {
    let study = ToleranceStudy::new(scene, solver, scene.tolerances(), quantities);
    let mut study = study.map_err(|why| Failure::Cannot(why.to_string()))?;
    let offsets = study.band(&curves.at, band);
    for (index, offsets) in offsets.iter().enumerate() {
        let name = format!("{} {}", quantities[index].name, band.word());
        plot.add_band(curves, index, offsets, name);
    }
    Ok(())
}

fn text(args: &PlotArgs, plot: &Plot, screen: TextScreen) -> Result<String, Failure> {
    let size = (args.size, &args.output);
    let (text, look) = plotted(plot, size, args.glyphs, !args.no_extrema)?;
    let hidden = plot.panels.len() - plot.panels_in(look.rows);
    if hidden > 0 {
        let all = plot.min_rows();
        note(&words().panels_without_room(hidden, look.cols, all), screen);
    }
    Ok(text)
}

/// Parses the quantity on the x axis.
fn abscissa(catalogue: &mut Catalogue, name: &str) -> Result<Abscissa, Failure> {
    let name = name.trim();
    if name == "driver" || name == catalogue.driver().name {
        return Ok(Abscissa::Driver);
    }
    if name == "time" {
        return Ok(Abscissa::Time);
    }
    let mut named = named(catalogue, "--against", name)?;
    match (named.pop(), named.len()) {
        (Some(quantity), 0) => Ok(Abscissa::Figure(quantity)),
        (_, more) => Err(Failure::Usage(words().one_along_x(name, more + 1))),
    }
}

/// Returns the requested part of the motion; `None` for all of it.
fn window(args: &PlotArgs, range: Range) -> Result<Option<(f64, f64)>, Failure> {
    if args.from.is_none() && args.to.is_none() {
        return Ok(None);
    }
    let from = args.from.map_or(first(range, false), |from| from.value());
    let to = args.to.map_or(last(range, false, from), |to| to.value());
    if from == to {
        return Err(Failure::Usage(words().no_way_between(from)));
    }
    Ok(Some((from, to)))
}

/// Reports values that do not exist. A plot without any values is an error.
fn report_missing_values(curves: &Curves, range: &str, screen: TextScreen) -> Result<(), Failure> {
    let all = curves.conditions.len();
    let outside = |c: &&Condition| **c == Condition::NoAssembly;
    let outside = curves.conditions.iter().filter(outside).count();
    if outside == all {
        return Err(Failure::Cannot(words().plot_outside(range)));
    }
    if outside > 0 {
        note(&words().plot_partly_outside(range), screen);
    }
    for curve in &curves.curves {
        if curve.values.iter().all(Option::is_none) {
            let name = &curve.quantity.name;
            note(&words().has_no_value_anywhere(name), screen);
        }
    }
    Ok(())
}
