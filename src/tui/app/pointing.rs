//! What the mouse does: each of it can be done by key as well.

use super::{App, Effect, Mode, View};
use crate::scene::Value;
use crate::tui::commands::key::Key;
use crate::tui::commands::mouse::{Mouse, MouseDeed};
use crate::tui::document::history::Deed;
use crate::tui::figures::cursor::Cursor;
use crate::tui::views::{PaneSpot, Under};
use crate::wording::words;
use crate::{Input, PointId, Vec2, angle};
use std::time::Duration;

/// A turn of the wheel goes so many lines.
const WHEEL: usize = 3;
/// A pin is taken from so many columns away.
const REACH: f64 = 1.5;

/// What the button holds while it is pressed.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) enum Gripped {
    #[default]
    Nothing,
    /// The driver: where the mouse was last, in the scene's frame.
    Driver(Vec2),
    /// A pin of the ground.
    Pin(PointId),
    /// The line of a plot where the driver is.
    Course,
}

impl App {
    /// Whether the mouse is ours and not the terminal's.
    pub(crate) fn has_mouse(&self) -> bool {
        self.shell.has_mouse
    }

    /// Takes the mouse, or gives it back to the terminal.
    pub(super) fn toggle_mouse(&mut self) {
        self.shell.has_mouse = !self.shell.has_mouse;
        self.shell.grip = Gripped::Nothing;
        self.shell.say(match self.shell.has_mouse {
            true => words().mouse_on(),
            false => words().mouse_off(),
        });
    }

    /// Something was done with the mouse, over what stands there.
    pub(crate) fn point(&mut self, mouse: Mouse, under: Under, now: Duration) {
        if self.shell.has_mouse {
            self.act(mouse, under, now);
            self.focus();
            // Another view may have fewer lines than what was scrolled before.
            self.scroll_by(0);
        }
    }

    fn act(&mut self, mouse: Mouse, under: Under, now: Duration) {
        let wheel = match mouse.deed {
            MouseDeed::WheelUp => Some(Key::Up),
            MouseDeed::WheelDown => Some(Key::Down),
            MouseDeed::Press | MouseDeed::Drag | MouseDeed::Release => None,
        };
        if self.shell.mode != Mode::Normal {
            // Lists of every kind go by their keys; what is asked wants a key of its own.
            wheel.into_iter().for_each(|key| self.roll(key, now));
            return;
        }
        match (mouse.deed, wheel, under) {
            (_, Some(key), Under::Drawing { place, .. }) => self.zoom_at(place, key == Key::Up),
            (_, Some(key), Under::Pane(view, _)) => {
                self.look(view);
                self.roll(key, now);
            }
            (MouseDeed::Press, _, under) => self.press(under, now),
            (MouseDeed::Drag, _, under) => self.drag(&under, now),
            (MouseDeed::Release, ..) => self.shell.grip = Gripped::Nothing,
            _ => {}
        }
    }

    fn roll(&mut self, key: Key, now: Duration) {
        for _ in 0..WHEEL {
            // Nothing that the arrows do leaves the program or sends anything.
            let _: Effect = self.key(key, now);
        }
    }

    fn press(&mut self, under: Under, now: Duration) {
        self.shell.message = None;
        self.shell.verdict_before = None;
        self.shell.grip = Gripped::Nothing;
        match under {
            Under::Nothing => {}
            Under::Tab(view) => self.look_at(view),
            Under::Drawing {
                view,
                place,
                column,
            } => {
                self.look(view);
                let pin = (view == View::Scene).then(|| self.pin_near(place, REACH * column));
                self.shell.grip = match pin.flatten() {
                    Some(pin) => self.take_pin(pin),
                    None => Gripped::Driver(place),
                };
                if self.player.playback.is_playing() {
                    self.player.toggle(now);
                }
            }
            Under::Pane(view, spot) => {
                self.look(view);
                match spot {
                    None => {}
                    Some(PaneSpot::Figure(part, row)) => {
                        self.place_cursor(|_, _| Cursor::at(part, row));
                    }
                    Some(PaneSpot::Value(row)) => self.document.editor.go_to(row),
                    Some(PaneSpot::Along(at)) => {
                        self.shell.grip = Gripped::Course;
                        self.lead_to(at, now);
                    }
                }
            }
        }
    }

    fn drag(&mut self, under: &Under, now: Duration) {
        match (self.shell.grip.clone(), under) {
            (Gripped::Driver(from), &Under::Drawing { place, .. }) => {
                self.drag_driver(from, place, now);
                self.shell.grip = Gripped::Driver(place);
            }
            (Gripped::Pin(pin), &Under::Drawing { place, .. }) => self.drag_pin(pin, place, now),
            (Gripped::Course, &Under::Pane(View::Plots, Some(PaneSpot::Along(at)))) => {
                self.lead_to(at, now);
            }
            _ => {}
        }
    }

    /// The driver goes to a coordinate, as near as the motion lets it.
    fn lead_to(&mut self, at: f64, now: Duration) {
        let here = self.player.open_scene.at();
        let at = self.player.open_scene.driver_range().on_grid(at);
        self.player.step(at - here, now);
    }

    /// The driven link turns as the mouse does about its pivot; a driven slide goes along with it.
    fn drag_driver(&mut self, from: Vec2, to: Vec2, now: Duration) {
        let open_scene = &self.player.open_scene;
        let mechanism = &open_scene.scene().mechanism;
        let by = match mechanism.driver().input {
            Input::Turn(link) => {
                let members = mechanism.link(link).members.iter();
                let mut grounded =
                    members.filter_map(|member| mechanism.point(member.point).ground);
                let Some(pivot) = grounded.next() else {
                    return;
                };
                let (from, to) = (from - pivot, to - pivot);
                let turned = angle::degrees(Vec2::new(from.dot(to), from.cross(to)));
                // The shorter way round.
                if turned > angle::TURN / 2.0 {
                    turned - angle::TURN
                } else {
                    turned
                }
            }
            Input::Push(slide) => {
                let guide = open_scene.state().travel(slide).map(|travel| travel.guide);
                guide.map_or(0.0, |guide| guide.dot(to - from))
            }
        };
        if by.is_finite() {
            let at = open_scene.driver_range().on_grid(open_scene.at() + by);
            self.player.step(at - self.player.open_scene.at(), now);
        }
    }

    // ---- pins of the ground, in the scene view

    /// The named pin of the ground that is next to a place, if one is so near.
    fn pin_near(&self, place: Vec2, reach: f64) -> Option<PointId> {
        let scene = self.player.open_scene.scene();
        let ids = scene.mechanism.point_ids();
        let grounded = ids.filter_map(|id| {
            let away = scene.mechanism.point(id).ground? - place;
            scene.point_name(id).map(|_| (id, away.norm()))
        });
        let near = grounded.filter(|(_, away)| *away <= reach);
        near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(id, _)| id)
    }

    /// The cursor goes to the first coordinate of a pin: an edit of its own begins.
    fn take_pin(&mut self, pin: PointId) -> Gripped {
        let name = self.player.open_scene.scene().point_name(pin);
        let row = name.and_then(|name| self.document.editor.row(&format!("{name} x")));
        if let Some(row) = row {
            self.document.editor.go_to(row);
        }
        Gripped::Pin(pin)
    }

    /// Both coordinates follow the mouse, by multiples of the step that fits the first of them.
    fn drag_pin(&mut self, pin: PointId, place: Vec2, now: Duration) {
        let Some(name) = self.player.open_scene.scene().point_name(pin) else {
            return;
        };
        let deed = Deed::Nudge(name.to_owned());
        let step = self.document.editor.notch().size();
        let axes =
            [("x", place.x), ("y", place.y)].map(|(axis, to)| (format!("{name} {axis}"), to));
        for (name, to) in axes {
            let value = self.document.editor.named(&name).cloned();
            let moved = value.and_then(|value| Some((moved_to(&value, to, step)?, value)));
            if let Some((text, value)) = moved.filter(|(text, value)| *text != value.text()) {
                self.put(&value, text, deed.clone(), now);
            }
        }
    }
}

/// The text of a value at the multiple of `step` that is next to `to`.
fn moved_to(value: &Value, to: f64, step: f64) -> Option<String> {
    let present: f64 = value.text().parse().ok()?;
    let steps = ((to - present) / step).round();
    steps.is_finite().then(|| value.moved(steps * step))
}
