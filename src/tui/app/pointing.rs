//! What the mouse does: each of it can be done by key as well.

use super::dragging::TypedPlace;
use super::{App, Effect, Mode, View};
use crate::tui::commands::key::Key;
use crate::tui::commands::mouse::{Mouse, MouseDeed};
use crate::tui::figures::cursor::Cursor;
use crate::tui::views::{PaneSpot, Under};
use crate::wording::words;
use crate::{Body, Input, Vec2, angle};
use std::time::Duration;

/// A turn of the wheel goes so many lines.
const WHEEL: isize = 3;
/// A point is taken from so many columns away.
const REACH: f64 = 1.5;

/// What the button holds while it is pressed.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) enum Gripped {
    #[default]
    Nothing,
    /// The driver: how far its coordinate is ahead of that of the mouse. A window may go along with the linkage,
    /// and so a place that was seen in an earlier one tells nothing.
    Driver(f64),
    /// A point whose place is typed in the scene.
    Point(TypedPlace),
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
        self.let_go();
        self.shell.say(match self.shell.has_mouse {
            true => words().mouse_on(),
            false => words().mouse_off(),
        });
    }

    /// Something was done with the mouse, over what stands there.
    pub(crate) fn point(&mut self, mouse: Mouse, under: Under, now: Duration) -> Effect {
        if !self.shell.has_mouse {
            return Effect::Show;
        }
        let effect = self.act(mouse, under, now);
        self.focus();
        // Another view may have fewer lines than what was scrolled before.
        self.scroll_by(0);
        effect
    }

    fn act(&mut self, mouse: Mouse, under: Under, now: Duration) -> Effect {
        match (mouse.deed, under) {
            (MouseDeed::WheelUp, under) => return self.roll(-WHEEL, &under, now),
            (MouseDeed::WheelDown, under) => return self.roll(WHEEL, &under, now),
            // Whatever has come up meanwhile.
            (MouseDeed::Release, _) => self.let_go(),
            // What is chosen or asked is answered by its keys.
            _ if self.shell.mode != Mode::Normal => {}
            (MouseDeed::Press, under) => self.press(under, now),
            (MouseDeed::Drag, under) => self.drag(&under, now),
        }
        Effect::Show
    }

    /// The wheel makes the drawing larger or smaller, and goes through what is on top.
    fn roll(&mut self, lines: isize, under: &Under, now: Duration) -> Effect {
        let up = lines < 0;
        match (&self.shell.mode, under) {
            (Mode::Normal, Under::Drawing(_, seen)) => self.zoom_at(seen.from_middle, up),
            (Mode::Normal, &Under::Pane(view, _)) => {
                self.look(view);
                self.scroll_by(lines);
            }
            (Mode::Normal, Under::Nothing | Under::Tab(_)) => {}
            (Mode::Help(_) | Mode::Assemblies(_), _) => self.scroll_by(lines),
            // Other lists take the arrows themselves, whatever a person has made of these.
            _ => {
                let key = if up { Key::Up } else { Key::Down };
                let effects: Vec<Effect> = (0..WHEEL).map(|_| self.key(key, now)).collect();
                let other = |effect: &Effect| *effect != Effect::Show;
                return effects.into_iter().find(other).unwrap_or(Effect::Show);
            }
        }
        Effect::Show
    }

    fn press(&mut self, under: Under, now: Duration) {
        self.shell.message = None;
        self.shell.before = None;
        self.let_go();
        match under {
            Under::Nothing => {}
            Under::Tab(view) => self.look_at(view),
            Under::Drawing(view, seen) => {
                self.pause(now);
                self.viewport
                    .lens
                    .hold(&self.player.open_scene, seen.window);
                let edits = self.shell.view == View::Scene;
                let point = edits.then(|| self.typed_near(seen.place, REACH * seen.column));
                match point.flatten() {
                    Some(point) => self.take_point(point),
                    None => {
                        self.look(view);
                        self.take_driver(seen.place);
                    }
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
                        self.pause(now);
                        self.shell.grip = Gripped::Course;
                        self.lead_to(at, now);
                    }
                    Some(PaneSpot::Time(time)) => {
                        self.pause(now);
                        self.shell.grip = Gripped::Course;
                        self.player.lead_to_time(time, now);
                    }
                }
            }
        }
    }

    fn drag(&mut self, under: &Under, now: Duration) {
        match (self.shell.grip.clone(), under) {
            (Gripped::Driver(ahead), Under::Drawing(_, seen)) => {
                self.drag_driver(ahead, seen.place, now);
            }
            (Gripped::Point(typed), Under::Drawing(_, seen)) => {
                self.drag_point(&typed, seen.place, now);
            }
            (Gripped::Course, &Under::Pane(View::Plots, Some(PaneSpot::Along(at)))) => {
                self.lead_to(at, now);
            }
            (Gripped::Course, &Under::Pane(View::Plots, Some(PaneSpot::Time(time)))) => {
                self.player.lead_to_time(time, now);
            }
            _ => {}
        }
    }

    /// The button holds nothing any more.
    pub(super) fn let_go(&mut self) {
        self.shell.grip = Gripped::Nothing;
        self.viewport.lens.let_go();
    }

    /// What is led by hand does not run on by itself.
    fn pause(&mut self, now: Duration) {
        if self.player.playback.is_playing() {
            self.player.toggle(now);
        }
    }

    /// The driver goes to a coordinate, as near as the motion lets it.
    fn lead_to(&mut self, at: f64, now: Duration) {
        let here = self.player.open_scene.at();
        let at = self.player.open_scene.driver_range().on_grid(at);
        self.player.step(at - here, now);
    }

    fn take_driver(&mut self, place: Vec2) {
        let at = self.player.open_scene.at();
        if let Some(pointed) = self.pointed_at(place) {
            self.shell.grip = Gripped::Driver(at - pointed);
        }
    }

    /// The driven link turns as the mouse does about its pivot, the shorter way round; a driven slide goes along
    /// with it.
    fn drag_driver(&mut self, ahead: f64, place: Vec2, now: Duration) {
        let Some(pointed) = self.pointed_at(place) else {
            return;
        };
        let open_scene = &self.player.open_scene;
        let by = pointed + ahead - open_scene.at();
        let by = match open_scene.scene().mechanism.driver().input {
            Input::Turn(_) => by - (by / angle::TURN).round() * angle::TURN,
            Input::Push(_) => by,
        };
        if by.is_finite() {
            self.lead_to(self.player.open_scene.at() + by, now);
        }
    }

    /// The driver's coordinate that a place tells, but for a part that stays the same: the direction from its pivot,
    /// or how far it lies along its guide.
    fn pointed_at(&self, place: Vec2) -> Option<f64> {
        let open_scene = &self.player.open_scene;
        let mechanism = &open_scene.scene().mechanism;
        match mechanism.driver().input {
            Input::Turn(link) => {
                let state = open_scene.state();
                let seen = angle::degrees(place - state.position(mechanism.hub(link)?)?);
                match mechanism.turned_from(link) {
                    Body::Ground => Some(seen),
                    Body::Link(from) => Some(seen - state.angle(from)?),
                }
            }
            Input::Push(slide) => {
                let travel = open_scene.state().travel(slide)?;
                Some(travel.guide.dot(place))
            }
        }
    }
}
