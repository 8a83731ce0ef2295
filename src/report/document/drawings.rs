//! Draws the linkage in its state, and with its forces.

use super::{ReportedState, picture};
use crate::drawing::{
    self, Glyphs, Labels, Layers, Overlay, OverlayRequest, Role, Shape, WorldView, legend_lines,
    render,
};
use crate::page::{Block, Content, Page};
use crate::quantity::Catalogue;
use crate::wording::words;
use crate::{LinkId, Vec2};

/// Columns and maximum rows of a picture on paper and as text, and the ratio of a cell's height to
/// its width.
const PAPER: (u16, u16) = (84, 44);
const CHARACTERS: (u16, u16) = (76, 26);
const FREE: (u16, u16) = (64, 26);
const FREE_CHARACTERS: (u16, u16) = (76, 20);
const ASPECT: f64 = 2.0;
/// Maximum number of links for which free-body diagrams are drawn.
const MAX_FREE_BODIES: usize = 12;
/// Maximum distance of an instant centre from the middle, relative to the size of the linkage; a
/// farther one would make the linkage too small.
const NEAR: f64 = 1.5;

impl ReportedState<'_> {
    /// Adds a drawing of the linkage in its state.
    pub(in crate::report) fn drawing(&self, page: &mut Page) {
        let catalogue = Catalogue::new(self.scene);
        let unit = &catalogue.driver().unit;
        let caption = words().drawing_of(&self.scene.title(), &self.state.at(), unit);
        self.show(&OverlayRequest::default(), &[], caption, page);
    }

    /// Adds the calculation of forces, a drawing of the linkage with its loads, and a free-body
    /// diagram of each link before its equations.
    pub(super) fn forces(&self, blocks: impl Iterator<Item = Block>, page: &mut Page) {
        let exist = self.state.known().drive().is_some();
        let mechanism = &self.scene.mechanism;
        let links = || mechanism.link_ids().filter(|_| exist);
        // With more links there would be too many pictures.
        let is_small = links().count() <= MAX_FREE_BODIES;
        let mut is_apart = false;
        for block in blocks {
            // The block after a picture keeps the spacing that it would have had.
            let is_apart_now = std::mem::take(&mut is_apart) || block.is_apart;
            let block = Block {
                is_apart: is_apart_now,
                ..block
            };
            let heading = match &block.content {
                Content::Heading(2, text) => Some(text.clone()),
                _ => None,
            };
            page.blocks.push(block);
            let starts = |link: &LinkId| {
                let part = words().link_part(self.scene.link_name(*link));
                let part = format!(" {part}");
                heading.as_ref().is_some_and(|text| text.ends_with(&part))
            };
            if let Some(link) = links().find(starts).filter(|_| is_small) {
                is_apart = self.cut_free(link, page);
            }
        }
        if exist {
            let wanted = OverlayRequest {
                forces: true,
                ..OverlayRequest::default()
            };
            self.show(&wanted, &[], words().forces_drawn().to_owned(), page);
        }
    }

    /// Adds the free-body diagram of a link; returns `false` if nothing is drawn.
    fn cut_free(&self, link: LinkId, page: &mut Page) -> bool {
        let (scene, state) = (self.scene, self.state);
        let forces = self.working.on_link(scene, self.solver, state, link);
        let Some((figure, extents)) = drawing::free_body(scene, state, link, &forces) else {
            return false;
        };
        let caption = words().link_cut_free(scene.link_name(link));
        let view = |(cols, maximum): (u16, u16)| {
            WorldView::lowest_window(maximum, |rows| WorldView::fit(&extents, cols, rows, ASPECT))
        };
        let labels = &mut Labels::default();
        let artwork = drawing::artwork(&figure, &view(FREE), &caption, &[], labels);
        let drawn = render(&figure, &view(FREE_CHARACTERS), Glyphs::Ascii).text();
        picture(page, artwork, caption, drawing::lines_drawn(&drawn));
        true
    }

    /// Adds a drawing with the instant centres of links without a pivot, and their construction
    /// lines.
    pub(super) fn centres(&self, page: &mut Page) {
        let all = self
            .working
            .instant_centres(self.scene, self.solver, self.state);
        let space = self.reach.bounds();
        let (middle, size) = (
            (space.low + space.high) * 0.5,
            (space.high - space.low).norm(),
        );
        let is_near = |at: Vec2| (at - middle).norm() <= NEAR * size;
        let mut drawn = Vec::new();
        for centre in &all {
            let near = centre.at.filter(|&at| is_near(at));
            if let (Some(at), false) = (near, centre.lines.is_empty()) {
                drawn.extend(centre.lines.iter().map(|&from| Shape::Line {
                    from,
                    to: at,
                    role: Role::Echo,
                }));
                drawn.push(Shape::Mark {
                    at,
                    role: Role::Rider,
                });
                drawn.push(Shape::Label {
                    at,
                    text: centre.symbol.clone(),
                    role: Role::Label,
                });
            }
        }
        if !drawn.is_empty() {
            let caption = words().centres_drawn().to_owned();
            self.show(&OverlayRequest::default(), &drawn, caption, page);
        }
    }

    /// Adds a drawing of the linkage with the wanted overlay and further shapes.
    fn show(&self, wanted: &OverlayRequest, more: &[Shape], caption: String, page: &mut Page) {
        let overlay = Overlay::of(self.scene, self.solver, &self.reach, wanted);
        let extents = overlay.extents(&self.reach);
        let extents = extents.as_ref().unwrap_or(&self.reach);
        let places = more.iter().filter_map(|shape| match shape {
            Shape::Mark { at, .. } => Some(*at),
            _ => None,
        });
        let extents = &extents.with_places(self.state.at(), places);
        let layers = Layers {
            links: true,
            centres: true,
            ..Layers::default()
        };
        let mut figure = drawing::linkage(self.scene, &self.reach, self.state, layers);
        overlay.add_to(&mut figure, self.scene, self.solver, self.state, 1.0);
        more.iter().for_each(|shape| figure.add(shape.clone()));
        let view = |(cols, maximum): (u16, u16)| {
            let of_rows = |rows| WorldView::pose(extents, self.state.at(), cols, rows, ASPECT);
            WorldView::lowest_window(maximum, of_rows)
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
        picture(page, artwork, caption, characters);
    }
}
