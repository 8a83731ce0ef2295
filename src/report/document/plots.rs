//! Plots positions and rates of every vector over the whole motion.

use super::picture;
use crate::Vec2;
use crate::drawing::plot::{Plot, PlotStyle};
use crate::drawing::{Glyphs, lines_drawn};
use crate::page::Page;
use crate::quantity::{Abscissa, Aspect, Catalogue, Curves, Quantity, Subject};
use crate::scene::{Scene, VectorKind};
use crate::solver::Solver;
use crate::wording::words;
use std::collections::HashSet;

/// Maximum number of curves that different dashes can distinguish.
const MAX_CURVES: usize = 5;
const SIZE: Vec2 = Vec2 { x: 760.0, y: 420.0 };
const COLUMNS: u16 = 76;
const ROWS: u16 = 22;
const ASPECT: f64 = 2.0;

/// Returns plots for positions, velocities and accelerations; several for many vectors.
pub(super) fn plots(scene: &Scene, solver: &Solver) -> Page {
    let mut page = Page::default();
    let all = moving_figures(scene);
    let captions = [
        words().positions_plotted(),
        words().velocities_plotted(),
        words().accelerations_plotted(),
    ];
    for (order, caption) in captions.into_iter().enumerate() {
        for of in [Aspect::TURNING[order], Aspect::STRETCHING[order]] {
            let of_aspect = all.iter().filter(|q| q.aspect() == Some(of));
            let quantities: Vec<Quantity> = of_aspect.cloned().collect();
            let over = Abscissa::Driver;
            // Curves over the driver's coordinate never fail.
            let curves = Curves::new(scene, solver, &quantities, over, None);
            for some in curves.into_iter().flat_map(|all| all.in_groups(MAX_CURVES)) {
                plot(&some, caption, &mut page);
            }
        }
    }
    page
}

/// Returns the values of all vectors that move.
fn moving_figures(scene: &Scene) -> Vec<Quantity> {
    let mechanism = &scene.mechanism;
    let moves = |kind: &VectorKind| match *kind {
        VectorKind::Link(_) | VectorKind::Slide(_) => true,
        VectorKind::Between(tail, head) => {
            let is_ground = |point| mechanism.point(point).ground.is_some();
            !(is_ground(tail) && is_ground(head))
        }
    };
    let vectors = scene.vectors.iter().map(|vector| vector.kind);
    let subjects: HashSet<Subject> = vectors.filter(moves).map(Subject::from).collect();
    let is_wanted = |q: &Quantity| q.subject().is_some_and(|s| subjects.contains(&s));
    let all = Catalogue::new(scene).figures().into_iter();
    all.filter(is_wanted).collect()
}

/// Adds a plot of some curves.
fn plot(curves: &Curves, caption: &str, page: &mut Page) {
    let plot = Plot::of(curves);
    if !plot.has_values() {
        return;
    }
    let style = PlotStyle {
        cols: COLUMNS,
        rows: ROWS.max(plot.min_rows()),
        glyphs: Glyphs::Ascii,
        aspect: ASPECT,
        extrema: true,
        first: 0,
    };
    let characters = match plot.fits(&style) {
        true => plot.render(&style, None).text(),
        false => String::new(),
    };
    let names: Vec<&str> = curves
        .curves
        .iter()
        .map(|curve| curve.quantity.name.as_str())
        .collect();
    let caption = words().plotted_are(caption, &names.join(", "));
    let artwork = plot.artwork(&caption, SIZE, true, None);
    picture(page, artwork, caption, lines_drawn(&characters));
}
