//! Handles the mouse. Every mouse action is also available by key.

use super::dragging::TypedPlace;
use crate::tui::app::{App, Effect, Mode, View};
use crate::tui::commands::action::SceneAction;
use crate::tui::commands::key::Key;
use crate::tui::commands::mouse::{Mouse, MouseEventKind};
use crate::tui::figures::cursor::Cursor;
use crate::tui::views::{CellTarget, PaneSpot};
use crate::wording::words;
use crate::{Body, Input, Vec2, angle};
use std::time::Duration;

/// Lines per step of the mouse wheel.
const WHEEL: isize = 3;
/// Distance within which a press takes a point, in columns.
const PICK_DISTANCE: f64 = 1.5;

/// The object that the pressed button drags.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::tui::app) enum DragTarget {
    #[default]
    Nothing,
    /// The driver, with the lead of its coordinate over the mouse's. The viewport may follow the
    /// linkage, so positions seen in an earlier viewport are not comparable.
    Driver(f64),
    /// A point with coordinates in the scene's text.
    Point(TypedPlace),
    /// The cursor of a plot, which marks the driver's coordinate.
    CyclePath,
}

impl App {
    /// Returns `true` if the workbench handles the mouse, `false` if the terminal does.
    pub(crate) fn has_mouse(&self) -> bool {
        self.shell.has_mouse
    }

    /// Takes over the mouse, or returns it to the terminal.
    pub(in crate::tui::app) fn toggle_mouse(&mut self) {
        self.shell.has_mouse = !self.shell.has_mouse;
        self.end_drag();
        self.set_message(match self.shell.has_mouse {
            true => words().mouse_on(),
            false => words().mouse_off(),
        });
    }

    /// Handles a mouse event over the object at the pointer.
    pub(crate) fn point(&mut self, mouse: Mouse, under: CellTarget, now: Duration) -> Effect {
        if !self.shell.has_mouse {
            return Effect::Show;
        }
        let effect = self.act(mouse, under, now);
        self.refresh();
        // Another view may have fewer lines than the previous scroll position.
        self.scroll_by(0);
        effect
    }

    fn act(&mut self, mouse: Mouse, under: CellTarget, now: Duration) -> Effect {
        match (mouse.kind, under) {
            (MouseEventKind::WheelUp, under) => return self.roll(-WHEEL, &under, now),
            (MouseEventKind::WheelDown, under) => return self.roll(WHEEL, &under, now),
            // A release ends the drag, even if another mode has opened meanwhile.
            (MouseEventKind::Release, _) => self.end_drag(),
            // Hints of lists and prompts too.
            (MouseEventKind::Press, CellTarget::Hint(key)) => return self.key(key, now),
            // Lists and prompts take keys only.
            _ if !self.shell.mode.is_normal() => {}
            (MouseEventKind::Press, under) => self.press(under, now),
            (MouseEventKind::Drag, under) => self.drag(&under, now),
        }
        Effect::Show
    }

    /// Zooms the drawing, or scrolls the topmost list or text.
    fn roll(&mut self, lines: isize, under: &CellTarget, now: Duration) -> Effect {
        let up = lines < 0;
        match (&self.shell.mode, under) {
            (Mode::Normal, CellTarget::Drawing(_, seen)) => self.zoom_at(seen.from_middle, up),
            (Mode::Normal, &CellTarget::Pane(view, _)) => {
                self.select_view(view);
                self.scroll_by(lines);
            }
            (Mode::Normal, CellTarget::Nothing | CellTarget::Tab(_) | CellTarget::Hint(_)) => {}
            (Mode::Help(_) | Mode::Assemblies(_), _) => self.scroll_by(lines),
            // Other lists handle arrow keys themselves, independently of the key bindings.
            _ => {
                let key = if up { Key::Up } else { Key::Down };
                let effects: Vec<Effect> = (0..WHEEL).map(|_| self.key(key, now)).collect();
                let other = |effect: &Effect| *effect != Effect::Show;
                return effects.into_iter().find(other).unwrap_or(Effect::Show);
            }
        }
        Effect::Show
    }

    fn press(&mut self, under: CellTarget, now: Duration) {
        self.shell.message = None;
        self.shell.before = None;
        self.end_drag();
        match under {
            CellTarget::Nothing | CellTarget::Hint(_) => {}
            CellTarget::Tab(view) => self.select_view_by_key(view),
            CellTarget::Drawing(view, seen) => {
                self.pause(now);
                self.views
                    .viewport
                    .lens
                    .hold(&self.player.open_scene, seen.window);
                let edits = self.shell.view == View::Scene;
                let point =
                    edits.then(|| self.typed_near(seen.position, PICK_DISTANCE * seen.column));
                match point.flatten() {
                    Some(point) => self.take_point(point),
                    None => {
                        self.select_view(view);
                        self.take_driver(seen.position);
                    }
                }
            }
            CellTarget::Pane(view, spot) => {
                let was_looked_at = self.shell.view == view;
                self.select_view(view);
                match spot {
                    None => {}
                    Some(PaneSpot::Figure(part, row)) => {
                        self.place_cursor(|_, _| Cursor::at(part, row));
                    }
                    Some(PaneSpot::Value(row))
                        if was_looked_at && self.document.editor.cursor() == row =>
                    {
                        self.edit(SceneAction::Edit, now);
                    }
                    Some(PaneSpot::Value(row)) => self.document.editor.go_to(row),
                    Some(PaneSpot::PlotAxis(at)) => {
                        self.pause(now);
                        self.shell.drag_target = DragTarget::CyclePath;
                        self.move_nearest_to(at, now);
                    }
                    Some(PaneSpot::Time(time)) => {
                        self.pause(now);
                        self.shell.drag_target = DragTarget::CyclePath;
                        self.player.move_to_pointed_time(time, now);
                    }
                }
            }
        }
    }

    fn drag(&mut self, under: &CellTarget, now: Duration) {
        match (self.shell.drag_target.clone(), under) {
            (DragTarget::Driver(ahead), CellTarget::Drawing(_, seen)) => {
                self.drag_driver(ahead, seen.position, now);
            }
            (DragTarget::Point(typed), CellTarget::Drawing(_, seen)) => {
                self.drag_point(&typed, seen.position, now);
            }
            (
                DragTarget::CyclePath,
                &CellTarget::Pane(View::Plots, Some(PaneSpot::PlotAxis(at))),
            ) => {
                self.move_nearest_to(at, now);
            }
            (DragTarget::CyclePath, &CellTarget::Pane(View::Plots, Some(PaneSpot::Time(time)))) => {
                self.player.move_to_pointed_time(time, now);
            }
            _ => {}
        }
    }

    /// Ends a mouse drag.
    pub(in crate::tui::app) fn end_drag(&mut self) {
        self.shell.drag_target = DragTarget::Nothing;
        self.views.viewport.lens.end_drag();
    }

    /// Pauses playback before a drag.
    fn pause(&mut self, now: Duration) {
        if self.player.playback.is_playing() {
            self.player.toggle(now);
        }
    }

    /// Moves the driver to the coordinate nearest to `at` that the motion permits.
    fn move_nearest_to(&mut self, at: f64, now: Duration) {
        let here = self.player.open_scene.at();
        let at = self.player.open_scene.driver_range().on_grid(at);
        self.player.step(at - here, now);
    }

    fn take_driver(&mut self, position: Vec2) {
        let at = self.player.open_scene.at();
        if let Some(pointed) = self.pointed_at(position) {
            self.shell.drag_target = DragTarget::Driver(at - pointed);
        }
    }

    /// Turns the driven link with the mouse about its pivot, along the shorter arc; a driven slide
    /// moves along its guide.
    fn drag_driver(&mut self, ahead: f64, position: Vec2, now: Duration) {
        let Some(pointed) = self.pointed_at(position) else {
            return;
        };
        let open_scene = &self.player.open_scene;
        let by = pointed + ahead - open_scene.at();
        let by = match open_scene.scene().mechanism.driver().input {
            Input::Turn(_) => by - (by / angle::TURN).round() * angle::TURN,
            Input::Push(_) => by,
        };
        if by.is_finite() {
            self.move_nearest_to(self.player.open_scene.at() + by, now);
        }
    }

    /// Returns the driver coordinate for a position of the mouse, up to a constant: the direction
    /// from the link's pivot in degrees, or the distance along the guide.
    fn pointed_at(&self, position: Vec2) -> Option<f64> {
        let open_scene = &self.player.open_scene;
        let mechanism = &open_scene.scene().mechanism;
        match mechanism.driver().input {
            Input::Turn(link) => {
                let state = open_scene.state();
                let seen = angle::degrees(position - state.position(mechanism.hub(link)?)?);
                match mechanism.turned_from(link) {
                    Body::Ground => Some(seen),
                    Body::Link(from) => Some(seen - state.angle(from)?),
                }
            }
            Input::Push(slide) => {
                let travel = open_scene.state().travel(slide)?;
                Some(travel.guide.dot(position))
            }
        }
    }
}
