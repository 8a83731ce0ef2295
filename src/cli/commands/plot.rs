//! `krank plot`: plots values over the driver coordinate, time or another value.

use super::args::{BandChoice, PictureFormat, PlotArgs, Size};
use super::commands::note_near_misses;
use super::failure::{Failure, note};
use super::measured::measured;
use super::output::write_text;
use super::picture::{self, ASPECT};
use super::screen::TextScreen;
use super::source::SolvableScene;
use super::sweep::{figures, first, last, named};
use crate::Vec2;
use crate::drawing::plot::{Plot, PlotStyle};
use crate::quantity::{Abscissa, Catalogue, Curves, Quantity};
use crate::report::limits_text;
use crate::scene::Scene;
use crate::solver::{Condition, Range, Solver};
use crate::study::ToleranceStudy;
use crate::wording::words;

/// Default size of an SVG in characters, and the size of a character in its units.
pub(super) const SVG: Size = Size {
    cols: 100,
    rows: 40,
};
pub(super) const CHARACTER: Vec2 = Vec2 { x: 8.0, y: 16.0 };

pub(super) fn plot(args: &PlotArgs, screen: TextScreen) -> Result<(), Failure> {
    let SolvableScene { scene, solver } = args.scene.open_for(&args.output)?;
    let mut catalogue = Catalogue::new(&scene);
    let figures = figures(&mut catalogue, &args.columns)?;
    let figures: Vec<Quantity> = figures
        .into_iter()
        .filter(|q| q != catalogue.driver())
        .collect();
    if figures.is_empty() {
        return Err(Failure::Usage(words().no_figures_to_plot().into()));
    }
    let abscissa = abscissa(&mut catalogue, &args.against)?;
    let range = solver.motion().range;
    let window = window(args, range)?;
    let curves = Curves::new(&scene, &solver, &figures, abscissa, window).map_err(|e| {
        let option = format!("--against {}", args.against.trim());
        Failure::Cannot(words().of_option(&option, &e))
    })?;
    judge(&curves, &limits_text(range, catalogue.driver()), screen)?;
    note_near_misses(&scene, &solver, screen);
    let mut drawn = Plot::of(&curves);
    if let Some(file) = &args.measured {
        if curves.abscissa != Abscissa::Driver {
            return Err(Failure::Usage(words().measured_over_driver().into()));
        }
        let output = args.output.output.as_deref();
        let found = measured(file, output, &catalogue, Some(&figures), screen)?;
        if let Some(left_out) = found.left_out() {
            note(&left_out, screen);
        }
        for (k, figure) in found.figures().iter().enumerate() {
            let name = words().measured_of(&figure.name);
            drawn.mark(&figure.unit, &name, &found.points(k));
        }
    }
    if let Some(band) = args.band {
        add_band(&mut drawn, &curves, (&scene, &solver), &figures, band)?;
    }
    let text = match args.format {
        PictureFormat::Text => text(args, &drawn, screen)?,
        PictureFormat::Svg => {
            let Size { cols, rows } = args.size.unwrap_or(SVG);
            let size = Vec2::new(f64::from(cols) * CHARACTER.x, f64::from(rows) * CHARACTER.y);
            drawn.svg(&scene.name, size, !args.no_extrema, None)
        }
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
    figures: &[Quantity],
    band: BandChoice,
) -> Result<(), Failure> {
    let study = ToleranceStudy::new(scene, solver, scene.tolerances(), figures);
    let mut study = study.map_err(|why| Failure::Cannot(why.to_string()))?;
    let offsets = study.band(&curves.at, band.kind());
    for (figure, offsets) in offsets.iter().enumerate() {
        let name = format!("{} {}", figures[figure].name, band.kind().word());
        plot.add_band(curves, figure, offsets, name);
    }
    Ok(())
}

fn text(args: &PlotArgs, plot: &Plot, screen: TextScreen) -> Result<String, Failure> {
    let Size { cols, rows } = picture::size(args.size, args.output.output.as_deref());
    let look = PlotStyle {
        cols,
        // Every panel gets its minimum height, because the length of paper is unlimited.
        rows: rows
            .max(plot.least_rows())
            .min(if args.size.is_some() { rows } else { u16::MAX }),
        glyphs: picture::glyphs(args.glyphs),
        aspect: ASPECT,
        extrema: !args.no_extrema,
        first: 0,
    };
    if !plot.fits(&look) {
        return Err(Failure::Usage(words().too_small_for_plot(cols, rows)));
    }
    let hidden = plot.panels.len() - plot.panels_in(look.rows);
    if hidden > 0 {
        let all = plot.least_rows();
        note(&words().panels_without_room(hidden, cols, all), screen);
    }
    Ok(picture::lettered(
        plot.render(&look, None).text(),
        look.glyphs,
    ))
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
        (Some(figure), 0) => Ok(Abscissa::Figure(figure)),
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
fn judge(curves: &Curves, range: &str, screen: TextScreen) -> Result<(), Failure> {
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
