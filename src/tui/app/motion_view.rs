//! Switches the motion view's layers, zooms and pans.

use super::App;
use crate::Vec2;
use crate::tui::commands::action::MotionAction;
use crate::tui::views::motion::viewport::Layer;
use crate::wording::words;

impl App {
    pub(super) fn move_viewport(&mut self, action: MotionAction) {
        use MotionAction as M;
        match action {
            M::Names => {
                let names = self.views.viewport.next_names();
                self.set_message(names.text());
            }
            M::Velocities => self.switch(Layer::Velocities, words().arrows_of_velocity()),
            M::Accelerations => self.switch(Layer::Accelerations, words().arrows_of_acceleration()),
            M::Forces => self.switch_forces(),
            M::Traces => self.switch(Layer::Traces, words().traces()),
            M::Ghosts => self.switch(Layer::Ghosts, words().other_positions()),
            M::Centres => self.switch(Layer::Centres, words().centres_of_mass()),
            M::Guides => self.switch(Layer::Guides, words().guides_and_supports()),
            M::ZoomIn => self.zoom(1),
            M::ZoomOut => self.zoom(-1),
            M::Fit => self.shell.set_message(self.views.viewport.fit()),
            M::FitPose => self.shell.set_message(self.views.viewport.fit_pose()),
            M::Follow => {
                let (viewport, followed) = (&mut self.views.viewport, &self.views.followed);
                let text = viewport.follow(&self.player.open_scene, followed);
                self.set_message(text);
            }
            M::PanLeft => self.pan(-1.0, 0.0),
            M::PanDown => self.pan(0.0, -1.0),
            M::PanUp => self.pan(0.0, 1.0),
            M::PanRight => self.pan(1.0, 0.0),
        }
    }

    fn switch(&mut self, layer: Layer, name: &str) {
        let scene = self.player.open_scene.scene();
        let text = match self.views.viewport.toggle(scene, layer) {
            true => words().switched_on(name),
            false => words().switched_off(name),
        };
        self.set_message(text);
    }

    /// Shows or hides the force arrows. Forces are computed only while shown; reports if no loads
    /// act.
    fn switch_forces(&mut self) {
        let acts = self.player.open_scene.solver().has_forces();
        self.switch(Layer::Forces, words().loads_and_forces());
        if self.views.viewport.shows_forces() && !acts {
            self.set_message(words().nothing_acts_in_short());
        }
        self.update_needs();
    }

    fn zoom(&mut self, steps: i8) {
        let lens = &mut self.views.viewport.lens;
        if !lens.enlarge(&self.player.open_scene, steps) {
            self.set_message(words().no_more_to_zoom());
        }
    }

    /// Zooms the drawing about a point at `from_middle` from its centre.
    pub(super) fn zoom_at(&mut self, from_middle: Vec2, larger: bool) {
        let steps = if larger { 1 } else { -1 };
        let lens = &mut self.views.viewport.lens;
        if !lens.enlarge_at(&self.player.open_scene, from_middle, steps) {
            self.set_message(words().no_more_to_zoom());
        }
    }

    fn pan(&mut self, right: f64, up: f64) {
        let lens = &mut self.views.viewport.lens;
        if !lens.pan(&self.player.open_scene, right, up) {
            self.set_message(words().motion_ends());
        }
    }
}
