//! Points that the hand takes elsewhere in the scene view: those whose places are typed there and that nothing else
//! stands on. A pin of the ground goes by its coordinates, the free end of a link by those on its link or by the
//! link's length.

use super::App;
use super::pointing::Gripped;
use crate::mechanism::CoordinateAxis;
use crate::scene::{Measure, Scene, Value};
use crate::solver::State;
use crate::tui::document::history::Deed;
use crate::wording::words;
use crate::{LinkId, PointId, Vec2};
use std::time::Duration;

/// Where a point is typed. All by their names: an edit may number them anew.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct TypedPlace {
    point: String,
    /// The link in whose frame it is typed; none is the ground.
    link: Option<String>,
    /// The values that tell it, and what of its place in that frame each is.
    values: Vec<(String, TypedCoordinate)>,
}

/// What of a place a value tells.
#[derive(Clone, Copy, Debug, PartialEq)]
enum TypedCoordinate {
    /// A coordinate.
    Along(CoordinateAxis),
    /// How far it is from the point that it is seen from, which lies here.
    Length(Vec2),
    /// In which direction it is seen from there, in degrees.
    Angle(Vec2),
}

impl TypedCoordinate {
    /// Of a place, in the frame in which it is typed; what is next to `present` of many angles.
    fn of(self, place: Vec2, present: f64) -> f64 {
        match self {
            TypedCoordinate::Along(CoordinateAxis::X) => place.x,
            TypedCoordinate::Along(CoordinateAxis::Y) => place.y,
            TypedCoordinate::Length(from) => (place - from).norm(),
            TypedCoordinate::Angle(from) => {
                let angle = (place - from).angle().to_degrees();
                angle + ((present - angle) / FULL_TURN).round() * FULL_TURN
            }
        }
    }
}

/// In degrees.
const FULL_TURN: f64 = 360.0;
/// By how much an angle goes at once under the hand, in degrees.
const ANGLE_STEP: f64 = 0.5;

impl TypedPlace {
    /// Where a point is typed, if it is at all.
    fn of(scene: &Scene, point: PointId) -> Option<TypedPlace> {
        let name = scene.point_name(point)?.to_owned();
        let link = match scene.mechanism.point(point).ground {
            Some(_) => None,
            None => Some(*scene.mechanism.point(point).links.first()?),
        };
        let called = link.map(|link| scene.link_name(link).to_owned());
        let ends = link.and_then(|link| scene.mechanism.link(link).ends);
        let values = match (&called, ends) {
            // Where a link begins is where its frame is.
            (Some(_), Some((from, _))) if from == point => Vec::new(),
            (Some(link), Some((_, to))) if to == point => {
                let along = TypedCoordinate::Along(CoordinateAxis::X);
                vec![(format!("{link} length"), along)]
            }
            (Some(called), _) if seen(scene, link, point).is_some() => {
                let from = seen(scene, link, point).unwrap_or_default();
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
                let value = |(axis, along)| (format!("{of} {axis}"), TypedCoordinate::Along(along));
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
    /// The point next to a place, if one is so near, that is of the ground, or of one link alone.
    pub(super) fn typed_near(&self, place: Vec2, reach: f64) -> Option<PointId> {
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
            Some((id, (at - place).norm()))
        });
        let near = away.filter(|(_, away)| *away <= reach);
        near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(id, _)| id)
    }

    /// The cursor goes to the first value of a point: an edit of its own begins.
    pub(super) fn take_point(&mut self, point: PointId) {
        let Some(typed) = TypedPlace::of(self.player.open_scene.scene(), point) else {
            return;
        };
        let editor = &mut self.document.editor;
        let first = typed.values.first().and_then(|(name, _)| editor.row(name));
        let Some(row) = first else {
            if let Some(link) = &typed.link {
                self.shell.say(words().begins_a_frame(&typed.point, link));
            }
            return;
        };
        editor.go_to(row);
        let named = |(name, _): &(String, _)| editor.named(name);
        let mut values = typed.values.iter().filter_map(named);
        if let Some(value) = values.find(|value| value.formula.is_some()).cloned() {
            self.say_what_it_follows_from(&value);
            return;
        }
        // The cursor may have been there.
        editor.history.part();
        self.shell.grip = Gripped::Point(typed);
    }

    /// What tells the point follows the mouse, by multiples of the step that fits the first value.
    pub(super) fn drag_point(&mut self, typed: &TypedPlace, place: Vec2, now: Duration) {
        let open_scene = &self.player.open_scene;
        let link = typed.link.as_deref();
        let Some(place) = in_frame(open_scene.scene(), open_scene.state(), link, place) else {
            return;
        };
        let step = self.document.editor.notch().size();
        let texts = typed.values.iter().filter_map(|(name, coordinate)| {
            let value = self.document.editor.named(name)?;
            let to = coordinate.of(place, value.number);
            let step = match value.measure {
                Measure::Angle => ANGLE_STEP,
                _ => step,
            };
            Some((value.clone(), moved_to(value, to, step)?))
        });
        let texts = texts.collect();
        self.put_all(texts, Deed::Nudge(typed.point.clone()), now);
    }
}

/// From where on its link a point is seen that is typed by length and angle.
fn seen(scene: &Scene, link: Option<LinkId>, point: PointId) -> Option<Vec2> {
    let link = scene.mechanism.link(link?);
    let polar = link.member(point)?.polar?;
    match polar.from {
        None => Some(Vec2::ZERO),
        Some(from) => link.local(from),
    }
}

/// Whether a point is the centre of mass of a link, and nothing that is gripped.
fn is_centre(scene: &Scene, point: PointId) -> bool {
    let mut links = scene.mechanism.links().iter();
    links.any(|link| link.com == Some(point))
}

/// A place of the drawing in the frame of a link as it stands now, or in that of the ground.
fn in_frame(scene: &Scene, state: &State, link: Option<&str>, place: Vec2) -> Option<Vec2> {
    let Some(link) = link else {
        return Some(place);
    };
    let named = |id: &LinkId| scene.link_name(*id) == link;
    let id = scene.mechanism.link_ids().find(named)?;
    let x = state.direction(id)?;
    // From a point that the link has there: it need have none where its frame begins.
    let member = scene.mechanism.link(id).members.first()?;
    let away = place - state.position(member.point)?;
    Some(member.local + Vec2::new(away.dot(x), x.cross(away)))
}

/// The text of a value at the multiple of `step` that is next to `to`.
fn moved_to(value: &Value, to: f64, step: f64) -> Option<String> {
    let present: f64 = value.text().parse().ok()?;
    let steps = ((to - present) / step).round();
    steps.is_finite().then(|| value.moved(steps * step))
}
