//! The linkage as it stands, and with the forces that act.

use super::{ReportedState, picture};
use crate::drawing::{
    self, Glyphs, Labels, Layers, Overlay, Wanted, WorldView, legend_lines, render,
};
use crate::page::{Illustration, Page};
use crate::quantity::Catalogue;
use crate::wording::words;
use std::sync::Arc;

/// Columns of a picture on paper and in characters, rows at most, and the height of a cell for its width.
const PAPER: (u16, u16) = (84, 44);
const CHARACTERS: (u16, u16) = (76, 26);
const ASPECT: f64 = 2.0;

impl ReportedState<'_> {
    /// The linkage in its state.
    pub(super) fn drawing(&self, page: &mut Page) {
        let catalogue = Catalogue::new(self.scene);
        let unit = &catalogue.driver().unit;
        let caption = words().drawing_of(&self.scene.title(), &self.state.at(), unit);
        self.show(&Wanted::default(), caption, page);
    }

    /// The same with loads, and with what joints and guides bear.
    pub(super) fn forces(&self, page: &mut Page) {
        if self.state.known().drive().is_none() {
            return;
        }
        let wanted = Wanted {
            forces: true,
            ..Wanted::default()
        };
        self.show(&wanted, words().forces_drawn().to_owned(), page);
    }

    fn show(&self, wanted: &Wanted, caption: String, page: &mut Page) {
        let overlay = Overlay::of(self.scene, self.solver, &self.reach, wanted);
        let reach = overlay.reach(&self.reach);
        let reach = reach.as_ref().unwrap_or(&self.reach);
        let layers = Layers {
            links: true,
            centres: true,
            ..Layers::default()
        };
        let mut figure = drawing::linkage(self.scene, &self.reach, self.state, layers);
        overlay.add_to(&mut figure, self.scene, self.solver, self.state, 1.0);
        let view = |(cols, most): (u16, u16)| {
            let of_rows = |rows| WorldView::pose(reach, self.state.at(), cols, rows, ASPECT);
            WorldView::snug(most, of_rows)
        };
        let on_paper = view(PAPER);
        let legend = overlay.legend(&on_paper, 1.0);
        let labels = &mut Labels::default();
        let artwork = drawing::artwork(&figure, &on_paper, &caption, &legend, labels);
        let in_cells = view(CHARACTERS);
        let drawn = render(&figure, &in_cells, Glyphs::Ascii).text();
        let mut characters = drawing::lines_drawn(&drawn);
        let legend = overlay.legend(&in_cells, 1.0);
        let width = usize::from(in_cells.cols());
        for line in legend_lines(&legend, Glyphs::Ascii, width, 2) {
            characters.push(line.into_iter().map(|piece| piece.text).collect());
        }
        let artwork = Arc::new(artwork);
        picture(
            page,
            Illustration {
                artwork,
                caption,
                characters,
            },
        );
    }
}
