//! The workbench without its terminal: it receives keys, times and sizes, and paints frames.

mod pixel_image;

use super::app::{App, Effect, View};
use super::config::Config;
use super::terminal::Painter;
use super::views::{self, Sketch};
use super::{Frames, OpenedScene, TaskOrder, Theme};
use crate::capability::{Capability, Colours};
use crate::drawing::Glyphs;
use crate::tui::commands::key::Key;
use crate::tui::commands::mouse::Mouse;
use pixel_image::Still;
use ratatui::buffer::Buffer;
use ratatui::layout::Size;
use std::path::Path;
use std::time::Duration;

/// A workbench that shows a scene and paints frames for a terminal owned by the caller.
///
/// Time is an input: [`Workbench::press`] happens at the current time, which [`Workbench::pass`]
/// advances.
#[derive(Debug)]
pub struct Workbench {
    app: App,
    sketch: Sketch,
    painter: Painter,
    now: Duration,
    /// Bytes that keys have sent to the terminal in addition to frames.
    sent: Vec<u8>,
    still: Still,
    /// The bytes that remove the last image, not sent yet.
    removal: &'static [u8],
    /// `true` if the playback alone changed the screen after the last composed frame.
    only_moves: bool,
}

impl Workbench {
    /// Opens a scene on a screen of `cols` x `rows` characters, for a terminal that supports
    /// synchronized frames.
    #[must_use]
    pub fn new(
        opened: OpenedScene,
        glyphs: Glyphs,
        colours: Colours,
        cols: u16,
        rows: u16,
    ) -> Self {
        let capability = Capability {
            glyphs,
            colours,
            modern: true,
        };
        Workbench::on(opened, None, capability, Size::new(cols, rows))
    }

    /// Replaces the clock for comparing methods; it must be monotonic.
    #[must_use]
    pub fn timed_by(mut self, clock: fn() -> Duration) -> Self {
        self.app.set_clock(clock);
        self
    }

    /// Applies the keys, the mouse setting, the CSV format and the layout of the user's
    /// configuration. Glyphs, colours and theme are set elsewhere.
    #[must_use]
    pub fn configured(mut self, config: &Config) -> Self {
        self.app.configure(config);
        self
    }

    /// Shows another view.
    #[must_use]
    pub fn with_view(mut self, view: View) -> Self {
        self.app.select_view(view);
        self
    }

    /// Runs all pending work between frames, such as an accuracy study, to its end.
    pub fn finish(&mut self) {
        while self.app.is_working() {
            self.pass(Duration::ZERO);
        }
    }

    /// Searches for the linkages that do a task, and lists them.
    #[must_use]
    pub fn synthesizing(mut self, task: TaskOrder) -> Self {
        self.app.synthesize(task);
        self
    }

    /// Sets the theme, which maps the names of colours.
    #[must_use]
    pub fn themed(mut self, theme: Theme) -> Self {
        self.app.set_theme(theme);
        self
    }

    /// Keeps unsaved edits in a folder, and offers those that an earlier session has left there.
    #[must_use]
    pub fn recovering_in(mut self, folder: &Path) -> Self {
        self.app.recover_in(folder);
        self
    }

    /// Opens a scene at the driver coordinate `at`, or at its start position if `None`.
    pub(super) fn on(
        opened: OpenedScene,
        at: Option<f64>,
        capability: Capability,
        size: Size,
    ) -> Self {
        Workbench {
            app: App::new(opened, at, capability, size),
            sketch: Sketch::default(),
            painter: Painter::new(capability),
            now: Duration::ZERO,
            sent: Vec::new(),
            still: Still::default(),
            removal: &[],
            only_moves: false,
        }
    }

    /// Presses keys, separated by blanks and written as in the help: `space`, `g`, `Enter`,
    /// `Ctrl-L`. A single character is a key of its own, and an unknown word is ignored. Returns
    /// `false` once the workbench was quit.
    pub fn press(&mut self, keys: &str) -> bool {
        let single = |word: &str| {
            let mut chars = word.chars();
            let c = chars.next().filter(|c| !c.is_control())?;
            chars.as_str().is_empty().then_some(Key::Char(c))
        };
        let key = |word: &str| word.parse().ok().or_else(|| single(word));
        let keys = keys.split_whitespace().filter_map(key);
        for key in keys {
            match self.key(key) {
                Effect::Show | Effect::Suspend | Effect::Picture => {}
                Effect::Send(bytes) => self.sent.extend(bytes),
                Effect::Still => self.show_still(None, None),
                Effect::Redraw => self.forget(),
                Effect::Quit => return false,
            }
        }
        true
    }

    /// Advances the time; a running playback moves on.
    pub fn pass(&mut self, time: Duration) {
        self.move_to(self.now + time);
    }

    /// Changes the size of the screen. Its contents are then unknown, so the next frame paints
    /// everything.
    pub fn resize(&mut self, cols: u16, rows: u16) {
        self.app.resize(Size::new(cols, rows), None);
        self.forget();
    }

    /// Returns the bytes that update the terminal from the last frame to this one; empty if they
    /// are equal.
    pub fn paint(&mut self) -> &[u8] {
        self.app.note_frame_shown(self.now);
        self.paint_within(usize::MAX)
    }

    /// Paints a frame for a line with capacity for about `room` bytes: urgent areas first, and the
    /// rest by [`Workbench::paint_rest`].
    pub(super) fn paint_within(&mut self, space: usize) -> &[u8] {
        self.compose();
        self.painter.frame(&views::urgent(&self.app), space)
    }

    /// Paints a frame of the playback for a slow line: only the drawing, simplified and without
    /// styles, and the lines with the driver's position. The rest of the screen stays as it is until
    /// the next [`Workbench::paint_within`].
    pub(super) fn paint_motion(&mut self, space: usize) -> &[u8] {
        let only_moves = self.only_moves && self.app.only_moves();
        self.sketch.is_simple = only_moves;
        self.compose();
        self.sketch.is_simple = false;
        if only_moves {
            let moving = views::moving(&self.app, &self.sketch);
            if let Some(drawing) = moving.first() {
                self.painter.drop_styles(*drawing);
                self.painter.keep_outside(&moving);
            }
        }
        self.painter.frame(&views::urgent(&self.app), space)
    }

    /// Renders the wanted screen.
    fn compose(&mut self) {
        self.app.update_before_frame();
        let app = &self.app;
        self.only_moves = app.only_moves();
        views::prepare(app, &mut self.sketch);
        self.painter.paint_with(app.palette());
        let canvas = self.painter.canvas(views::area(app));
        views::render(app, &self.sketch, canvas);
        self.uncover();
    }

    /// Continues a cut frame, with the screen as it was then.
    pub(super) fn paint_rest(&mut self, space: usize) -> &[u8] {
        self.painter.frame(&views::urgent(&self.app), space)
    }

    /// Returns `true` if the last frame was cut.
    pub(super) fn is_cut(&self) -> bool {
        self.painter.is_cut()
    }

    /// Returns the screen as text, with trailing blanks trimmed.
    pub fn text(&mut self) -> String {
        self.app.update_before_frame();
        self.app.note_frame_shown(self.now);
        views::prepare(&self.app, &mut self.sketch);
        let mut buffer = Buffer::empty(views::area(&self.app));
        views::render(&self.app, &self.sketch, &mut buffer);
        views::text(&buffer)
    }

    /// Takes the bytes that keys have sent to the terminal in addition to frames, such as text for
    /// its clipboard.
    pub fn take_sent(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.sent)
    }

    /// Returns the number of frames painted so far, and their bytes.
    #[must_use]
    pub fn frames(&self) -> Frames {
        self.painter.frames()
    }

    /// Sets the time to `now`; a running playback moves on.
    pub(super) fn move_to(&mut self, now: Duration) {
        self.now = now;
        self.app.tick(now);
    }

    /// Sets the time to `now` without moving a running playback, which continues from its position.
    pub(super) fn skip_to(&mut self, now: Duration) {
        self.now = now;
        self.app.wake(now);
    }

    pub(super) fn key(&mut self, key: Key) -> Effect {
        self.remove_image();
        let effect = self.app.key(key, self.now);
        self.still.confirm(effect == Effect::Still);
        if effect == Effect::Picture {
            let text = self.text();
            self.app.prompt_for_picture(text);
            return Effect::Show;
        }
        effect
    }

    pub(super) fn paste(&mut self, text: &str) {
        self.remove_image();
        self.still.confirm(false);
        self.app.paste(text);
    }

    pub(super) fn point(&mut self, mouse: Mouse) -> Effect {
        self.remove_image();
        self.still.confirm(false);
        let under = views::under(&self.app, &self.sketch, mouse.at);
        self.app.point(mouse, under, self.now)
    }

    /// Returns the place of the scene at a cell of the drawing.
    #[cfg(test)]
    pub(super) fn place(&self, at: ratatui::layout::Position) -> Option<views::DrawnPlace> {
        self.sketch.place(at)
    }

    /// Returns the cells of the drawing.
    #[cfg(test)]
    pub(super) fn drawing(&self) -> &crate::drawing::Raster {
        self.sketch.raster()
    }

    pub(super) fn app(&mut self) -> &mut App {
        &mut self.app
    }

    /// Discards the known contents of the terminal, so that the next frame paints everything.
    pub fn forget(&mut self) {
        self.remove_image();
        self.painter.forget();
    }
}
