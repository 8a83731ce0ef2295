//! What the motion view shows, and how large.

use super::App;
use crate::tui::commands::action::MotionAction;
use crate::tui::views::motion::viewport::Layer;

impl App {
    pub(super) fn move_lens(&mut self, action: MotionAction) {
        use MotionAction as M;
        match action {
            M::Names => self.shell.say(self.viewport.next_names().text()),
            M::Velocities => self.switch(Layer::Velocities, "arrows of velocity"),
            M::Accelerations => self.switch(Layer::Accelerations, "arrows of acceleration"),
            M::Traces => self.switch(Layer::Traces, "traces"),
            M::Ghosts => self.switch(Layer::Ghosts, "other positions"),
            M::Centres => self.switch(Layer::Centres, "centres of mass"),
            M::Guides => self.switch(Layer::Guides, "guides and supports"),
            M::ZoomIn => self.zoom(1),
            M::ZoomOut => self.zoom(-1),
            M::Fit => self.viewport.fit(),
            M::PanLeft => self.pan(-1.0, 0.0),
            M::PanDown => self.pan(0.0, -1.0),
            M::PanUp => self.pan(0.0, 1.0),
            M::PanRight => self.pan(1.0, 0.0),
        }
    }

    fn switch(&mut self, layer: Layer, name: &str) {
        let on = if self.viewport.toggle(layer) {
            "on"
        } else {
            "off"
        };
        self.shell.say(format!("{name} {on}"));
    }

    fn zoom(&mut self, steps: i8) {
        if !self.viewport.enlarge(steps) {
            self.shell.say("there is no more to zoom");
        }
    }

    fn pan(&mut self, right: f64, up: f64) {
        if !self.viewport.pan(&self.player.open_scene, right, up) {
            self.shell.say("the motion ends here");
        }
    }

    /// Brings what the motion view shows of the whole motion up to date: after every key, and before a frame.
    pub(crate) fn focus(&mut self) {
        self.viewport.focus(&self.player.open_scene, &self.followed);
    }
}
