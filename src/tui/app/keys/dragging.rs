//! Drags points of the scene view with the mouse.
//!
//! Only points with coordinates in the scene's text can be dragged, and only if nothing else
//! depends on them. A ground pin moves by its coordinates; the free end of a link moves by its
//! coordinates on the link or by the link's length.

use super::pointing::DragTarget;
use crate::CoordinateAxis;
use crate::scene::{Measure, Scene, Value};
use crate::solver::State;
use crate::tui::app::App;
use crate::tui::document::history::Deed;
use crate::wording::words;
use crate::{LinkId, PointId, Vec2};
use std::time::Duration;

/// The values in the scene's text that determine a point's position. All are kept by name, because
/// an edit may renumber them.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::tui::app) struct TypedPlace {
    point: String,
    /// The link in whose frame the values are; `None` for the ground frame.
    link: Option<String>,
    /// The values, each with the coordinate that it defines in that frame.
    values: Vec<(String, TypedCoordinate)>,
}

/// The coordinate that a value defines.
#[derive(Clone, Copy, Debug, PartialEq)]
enum TypedCoordinate {
    /// A Cartesian coordinate.
    PlotAxis(CoordinateAxis),
    /// The distance from a reference point at this position.
    Length(Vec2),
    /// The direction seen from a reference point at this position, in degrees.
    Angle(Vec2),
}

impl TypedCoordinate {
    /// Returns this coordinate of `position`, given in the frame of the values. An angle is shifted by
    /// full turns to be nearest to `present`.
    fn of(self, position: Vec2, present: f64) -> f64 {
        match self {
            TypedCoordinate::PlotAxis(CoordinateAxis::X) => position.x,
            TypedCoordinate::PlotAxis(CoordinateAxis::Y) => position.y,
            TypedCoordinate::Length(from) => (position - from).norm(),
            TypedCoordinate::Angle(from) => {
                let angle = (position - from).angle().to_degrees();
                angle + ((present - angle) / FULL_TURN).round() * FULL_TURN
            }
        }
    }
}

/// A full turn, in degrees.
const FULL_TURN: f64 = 360.0;
/// The step of an angle during a drag, in degrees.
const ANGLE_STEP: f64 = 0.5;

impl TypedPlace {
    /// Returns the values that determine a point's position; `None` for a point without a name, or
    /// with neither ground nor link.
    fn of(scene: &Scene, point: PointId) -> Option<TypedPlace> {
        let name = scene.point_name(point)?.to_owned();
        let link = match scene.mechanism.point(point).ground {
            Some(_) => None,
            None => Some(*scene.mechanism.point(point).links.first()?),
        };
        let called = link.map(|link| scene.link_name(link).to_owned());
        let ends = link.and_then(|link| scene.mechanism.link(link).ends);
        let values = match (&called, ends) {
            // A link's start point is the origin of its frame.
            (Some(_), Some((from, _))) if from == point => Vec::new(),
            (Some(link), Some((_, to))) if to == point => {
                let along = TypedCoordinate::PlotAxis(CoordinateAxis::X);
                vec![(format!("{link} length"), along)]
            }
            (Some(called), _) if reference_point(scene, link, point).is_some() => {
                let from = reference_point(scene, link, point).unwrap_or_default();
                vec![
                    (
                        format!("{called} {name} length"),
                        TypedCoordinate::Length(from),
                    ),
                    (
                        format!("{called} {name} angle"),
                        TypedCoordinate::Angle(from),
                    ),
                ]
            }
            (link, _) => {
                let of = link
                    .as_ref()
                    .map_or(name.clone(), |l| format!("{l} {name}"));
                let axes = [("x", CoordinateAxis::X), ("y", CoordinateAxis::Y)];
                let value =
                    |(axis, along)| (format!("{of} {axis}"), TypedCoordinate::PlotAxis(along));
                axes.map(value).to_vec()
            }
        };
        Some(TypedPlace {
            point: name,
            link: called,
            values,
        })
    }
}

impl App {
    /// Returns the named point nearest to `place` within `reach`, among ground points and points of
    /// a single link.
    pub(in crate::tui::app) fn typed_near(&self, position: Vec2, reach: f64) -> Option<PointId> {
        let (scene, state) = (
            self.player.open_scene.scene(),
            self.player.open_scene.state(),
        );
        let mechanism = &scene.mechanism;
        let ids = mechanism.point_ids();
        let named = ids.filter(|&id| scene.point_name(id).is_some() && !is_centre(scene, id));
        let away = named.filter_map(|id| {
            let at = match mechanism.point(id).ground {
                Some(at) => at,
                None => state.position(id).filter(|_| mechanism.is_free(id))?,
            };
            Some((id, (at - position).norm()))
        });
        let near = away.filter(|(_, away)| *away <= reach);
        near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(id, _)| id)
    }

    /// Moves the cursor to the first value of a point and starts a new edit.
    pub(in crate::tui::app) fn take_point(&mut self, point: PointId) {
        let Some(typed) = TypedPlace::of(self.player.open_scene.scene(), point) else {
            return;
        };
        let editor = &mut self.document.editor;
        let first = typed.values.first().and_then(|(name, _)| editor.row(name));
        let Some(row) = first else {
            let scene = self.player.open_scene.scene();
            let parts = std::iter::once(&typed.point).chain(&typed.link);
            let mut copies = parts.filter_map(|part| Some((part, scene.original_of(part)?)));
            if let Some((copy, original)) = copies.next() {
                let message = words().edit_the_original(copy, original);
                self.set_message(message);
            } else if let Some(link) = &typed.link {
                self.set_message(words().begins_a_frame(&typed.point, link));
            }
            return;
        };
        editor.go_to(row);
        let named = |(name, _): &(String, _)| editor.named(name);
        let mut values = typed.values.iter().filter_map(named);
        if let Some(value) = values.find(|value| value.formula.is_some()).cloned() {
            self.report_dependencies(&value);
            return;
        }
        // The cursor may already have been on this value.
        editor.history.part();
        self.shell.drag_target = DragTarget::Point(typed);
    }

    /// Moves a point's values to the mouse position, in multiples of the editor's step.
    pub(in crate::tui::app) fn drag_point(
        &mut self,
        typed: &TypedPlace,
        position: Vec2,
        now: Duration,
    ) {
        let open_scene = &self.player.open_scene;
        let link = typed.link.as_deref();
        let Some(position) = in_frame(open_scene.scene(), open_scene.state(), link, position)
        else {
            return;
        };
        let step = self.document.editor.notch().size();
        let texts = typed.values.iter().filter_map(|(name, coordinate)| {
            let value = self.document.editor.named(name)?;
            let to = coordinate.of(position, value.number);
            let step = match value.measure {
                Measure::Angle => ANGLE_STEP,
                _ => step,
            };
            Some((value.clone(), moved_to(value, to, step)?))
        });
        let texts = texts.collect();
        self.replace_values(texts, Deed::Nudge(typed.point.clone()), now);
    }
}

/// Returns the reference point, in the link's frame, of a point given by length and angle.
fn reference_point(scene: &Scene, link: Option<LinkId>, point: PointId) -> Option<Vec2> {
    let link = scene.mechanism.link(link?);
    let polar = link.member(point)?.polar?;
    match polar.from {
        None => Some(Vec2::ZERO),
        Some(from) => link.local(from),
    }
}

/// Returns `true` if a point is the centre of mass of a link, which cannot be dragged.
fn is_centre(scene: &Scene, point: PointId) -> bool {
    let mut links = scene.mechanism.links().iter();
    links.any(|link| link.com == Some(point))
}

/// Transforms a position of the drawing to the current frame of a link, or to the ground frame.
fn in_frame(scene: &Scene, state: &State, link: Option<&str>, position: Vec2) -> Option<Vec2> {
    let Some(link) = link else {
        return Some(position);
    };
    let named = |id: &LinkId| scene.link_name(*id) == link;
    let id = scene.mechanism.link_ids().find(named)?;
    let x = state.direction(id)?;
    // Uses a point that the link has in this state: the frame's origin may carry no point.
    let member = scene.mechanism.link(id).members.first()?;
    let away = position - state.position(member.point)?;
    Some(member.local + Vec2::new(away.dot(x), x.cross(away)))
}

/// Returns a value's text after a move by a multiple of `step` to the nearest position to `to`.
fn moved_to(value: &Value, to: f64, step: f64) -> Option<String> {
    let present: f64 = value.text().parse().ok()?;
    let steps = ((to - present) / step).round();
    steps.is_finite().then(|| value.moved(steps, step))
}
