//! Draws a linkage for CAD: one layer per link, always in millimetres.

use super::dxf::{DxfDocument, DxfLayer};
use crate::drawing::motion::extents::Extents;
use crate::drawing::motion::overlay::Overlay;
use crate::drawing::outline::hull;
use crate::scene::{Scene, Unit};
use crate::solver::{Known, State};
use crate::{Body, Link, LinkId, Mechanism, PointId, SlideId, Vec2};

/// The radius of a pin, and the height of letters, as fractions of the diagonal of all the
/// linkage's positions.
const PIN: f64 = 0.008;
const LETTERS: f64 = 0.02;

/// Returns the linkage in a state as DXF, with the overlay's traces.
///
/// Each link has a layer of its name. Further layers are `ground` (pivots and guides), `joints` (a
/// circle for every pin, a point for any other point), `paths` and `names`.
#[must_use]
pub fn machine_drawing(
    scene: &Scene,
    extents: &Extents,
    state: &State,
    overlay: &Overlay,
) -> String {
    let mut drawing = MachineDrawing {
        mechanism: &scene.mechanism,
        reach: extents,
        state: state.known(),
        millimetres: scene.unit.in_units_of(Unit::Millimetre),
        diagonal: extents.bounds().size().norm(),
        document: DxfDocument::default(),
    };
    let links: Vec<(LinkId, DxfLayer)> = scene
        .mechanism
        .link_ids()
        .map(|link| (link, drawing.document.layer(scene.link_name(link))))
        .collect();
    let [ground, joints, paths, names] =
        ["ground", "joints", "paths", "names"].map(|name| drawing.document.layer(name));
    drawing.guides(ground, &links);
    for &(link, layer) in &links {
        drawing.link(layer, link);
    }
    for point in scene.mechanism.point_ids() {
        drawing.joint(ground, joints, point);
        if let Some(name) = scene.point_name(point) {
            drawing.name(names, point, name);
        }
    }
    for trace in overlay.traces() {
        let course: Vec<Vec2> = trace.iter().map(|&p| drawing.on_paper(p)).collect();
        drawing.document.chain(paths, &course);
    }
    drawing.text()
}

struct MachineDrawing<'a> {
    mechanism: &'a Mechanism,
    reach: &'a Extents,
    state: Known<'a>,
    /// Millimetres per unit of length of the scene.
    millimetres: f64,
    /// The diagonal of all the linkage's positions, in the scene's unit.
    diagonal: f64,
    document: DxfDocument,
}

impl MachineDrawing<'_> {
    fn on_paper(&self, position: Vec2) -> Vec2 {
        position * self.millimetres
    }

    fn place(&self, point: PointId) -> Vec2 {
        self.on_paper(self.state.position(point))
    }

    /// Draws a line through the joints of a link, or its outline; joints inside it have only their
    /// circles.
    fn link(&mut self, layer: DxfLayer, link: LinkId) {
        let link = self.mechanism.link(link);
        let members = link.members.iter().filter(|m| Some(m.point) != link.com);
        let corners = hull(members.map(|m| self.place(m.point)).collect());
        match corners[..] {
            [from, to] => self.document.line(layer, from, to),
            _ => self.document.outline(layer, &corners),
        }
    }

    /// Draws a pin as a circle, on the ground's layer if it is fixed, and a centre of mass or
    /// another free point as a point.
    fn joint(&mut self, ground: DxfLayer, joints: DxfLayer, point: PointId) {
        let at = self.place(point);
        let radius = PIN * self.diagonal * self.millimetres;
        match self.mechanism.point(point).ground {
            Some(_) => self.document.circle(ground, at, radius),
            None if self.mechanism.is_free(point) => self.document.point(joints, at),
            None => self.document.circle(joints, at, radius),
        }
    }

    fn name(&mut self, layer: DxfLayer, point: PointId, name: &str) {
        let nearby = Vec2::new(LETTERS, LETTERS) * self.diagonal;
        let at = self.on_paper(self.state.position(point) + nearby);
        let height = LETTERS * self.diagonal * self.millimetres;
        self.document.text(layer, at, height, name);
    }

    /// Draws every guide over the travel of its slide, on the layer of the body that carries it.
    fn guides(&mut self, ground: DxfLayer, links: &[(LinkId, DxfLayer)]) {
        for id in self.mechanism.slide_ids() {
            let Some(ends) = self.guide(id) else { continue };
            let [from, to] = ends.map(|end| self.on_paper(end));
            let layer = match self.mechanism.slide(id).on {
                Body::Ground => ground,
                Body::Link(link) => links[link.index()].1,
            };
            self.document.line(layer, from, to);
        }
    }

    fn guide(&self, id: SlideId) -> Option<[Vec2; 2]> {
        let slide = self.mechanism.slide(id);
        let (low, high) = self.reach.travel(id)?;
        let ends = [low, high].map(|s| slide.through + slide.direction() * s);
        match slide.on {
            Body::Ground => Some(ends),
            Body::Link(link) => {
                let origin = self.origin(link, self.mechanism.link(link))?;
                let along = self.state.direction(link);
                Some(ends.map(|end| origin + end.turned(along)))
            }
        }
    }

    /// Returns the origin of a link's frame.
    fn origin(&self, id: LinkId, link: &Link) -> Option<Vec2> {
        let member = link.members.first()?;
        let along = self.state.direction(id);
        Some(self.state.position(member.point) - member.local.turned(along))
    }

    fn text(&self) -> String {
        let bounds = self.reach.bounds();
        let [low, high] = [bounds.low, bounds.high].map(|corner| self.on_paper(corner));
        self.document.text_of(low, high)
    }
}
