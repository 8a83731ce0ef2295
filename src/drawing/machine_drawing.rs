//! A linkage as a drawing for CAD: a layer for every link, in millimetres whatever the scene's unit.

use super::dxf::{DxfDocument, DxfLayer};
use super::outline::hull;
use super::overlay::Overlay;
use super::reach::Reach;
use crate::scene::{Scene, Unit};
use crate::solver::{Known, State};
use crate::{Body, Link, LinkId, Mechanism, PointId, SlideId, Vec2};

/// The radius of a pin, and the height of letters, for the diagonal of all places that the linkage comes to.
const PIN: f64 = 0.008;
const LETTERS: f64 = 0.02;

/// The linkage in a state as DXF, with the traces that were asked for.
///
/// Layers are called like the links; beside them there are `ground` (pivots and guides), `joints` (a circle for every
/// pin, a point for what is none), `paths` and `names`.
#[must_use]
pub fn machine_drawing(scene: &Scene, reach: &Reach, state: &State, overlay: &Overlay) -> String {
    let mut drawing = MachineDrawing {
        mechanism: &scene.mechanism,
        reach,
        state: state.known(),
        millimetres: scene.unit.in_units_of(Unit::Millimetre),
        diagonal: reach.bounds().size().norm(),
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
    reach: &'a Reach,
    state: Known<'a>,
    /// Of the scene's unit of length.
    millimetres: f64,
    /// Of all places that the linkage comes to, in the scene's unit.
    diagonal: f64,
    document: DxfDocument,
}

impl MachineDrawing<'_> {
    fn on_paper(&self, place: Vec2) -> Vec2 {
        place * self.millimetres
    }

    fn place(&self, point: PointId) -> Vec2 {
        self.on_paper(self.state.position(point))
    }

    /// A line through the joints of a link, or its outline with the joints inside left to their circles.
    fn link(&mut self, layer: DxfLayer, link: LinkId) {
        let link = self.mechanism.link(link);
        let members = link.members.iter().filter(|m| Some(m.point) != link.com);
        let corners = hull(members.map(|m| self.place(m.point)).collect());
        match corners[..] {
            [from, to] => self.document.line(layer, from, to),
            _ => self.document.outline(layer, &corners),
        }
    }

    /// A pin is a circle, on the ground if it stands there; a centre of mass or another free point is a point.
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
        let beside = Vec2::new(LETTERS, LETTERS) * self.diagonal;
        let at = self.on_paper(self.state.position(point) + beside);
        let height = LETTERS * self.diagonal * self.millimetres;
        self.document.text(layer, at, height, name);
    }

    /// Every guide as far as its slide comes, on the layer of what carries it.
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

    /// Where the origin of a link's frame lies.
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
