//! The input mode, the current view and the screen.

use super::keys::pointing::DragTarget;
use super::{Mode, View};
use crate::capability::{Capability, Colours, Detected, PictureProtocol};
use crate::drawing::{Blocks, Glyphs};
use crate::tui::appearance::palette::{Ground, Theme};
use crate::tui::commands::keymap::Keymap;
use crate::tui::player::open_scene::OpenScene;
use crate::tui::views::layout::Composition;
use crate::wording::words;
use ratatui::layout::Size;
use std::time::Duration;

/// Height of a cell divided by its width in most fonts.
const DEFAULT_ASPECT: f64 = 2.0;
/// Shortest time between showing a prompt and accepting its answer. Earlier keys were typed before
/// the user read it.
const REACTION: Duration = Duration::from_millis(300);
/// Time after which a message disappears.
const MESSAGE_TIME: Duration = Duration::from_secs(3);

/// The scene as it was before an edit.
#[derive(Debug)]
pub(super) struct SceneBefore {
    pub open_scene: OpenScene,
    /// `true` if a key has been pressed since. That key may continue the edit.
    pub is_past: bool,
}

/// The state of the workbench outside the scene.
#[derive(Debug)]
pub(super) struct Shell {
    pub mode: Mode,
    pub keymap: Keymap,
    pub view: View,
    /// The visible panes and their arrangement.
    pub composition: Composition,
    /// The message in the last line, until the next key or until it expires.
    pub message: Option<String>,
    /// The message on the screen and the time when it appeared.
    shown_message: Option<(Duration, String)>,
    /// The scene as it was before the last edit, until the next key.
    pub before: Option<SceneBefore>,
    /// The time when the current prompt appeared on the screen.
    seen: Option<Duration>,

    /// `true` if the workbench handles the mouse.
    pub has_mouse: bool,
    pub drag_target: DragTarget,

    // The terminal.
    pub capability: Capability,
    /// The image protocol, or the reason why there is none.
    pub pictures: Detected<Option<PictureProtocol>>,
    pub theme: Theme,
    /// The terminal's background, if it is known.
    pub ground: Option<Ground>,
    /// The reported colours of plain text and of the background.
    pub text_colour: Option<[u8; 3]>,
    pub ground_colour: Option<[u8; 3]>,
    pub size: Size,
    /// Height of a cell divided by its width.
    pub aspect: f64,
}

impl Shell {
    pub(super) fn new(capability: Capability, size: Size) -> Self {
        Shell {
            mode: Mode::Normal,
            keymap: Keymap::default(),
            view: View::default(),
            composition: Composition::default(),
            message: None,
            shown_message: None,
            before: None,
            seen: None,
            has_mouse: false,
            drag_target: DragTarget::default(),
            capability,
            pictures: Detected {
                value: None,
                why: words().pictures_unwanted().into(),
            },
            theme: Theme::default(),
            ground: None,
            text_colour: None,
            ground_colour: None,
            size,
            aspect: DEFAULT_ASPECT,
        }
    }

    pub(super) fn set_message(&mut self, message: impl Into<String>) {
        self.message = Some(message.into());
        self.shown_message = None;
    }

    /// Records the time at which the current message appeared on the screen.
    pub(super) fn show_message(&mut self, now: Duration) {
        let is_shown = self.shown_message.as_ref().map(|(_, text)| text) == self.message.as_ref();
        if !is_shown {
            self.shown_message = self.message.clone().map(|message| (now, message));
        }
    }

    /// Returns `true` if the message is not known to be on the screen yet.
    pub(super) fn message_awaits_frame(&self) -> bool {
        self.message.is_some() && self.shown_message.is_none()
    }

    /// Returns the time when the message expires; `None` while the user types, chooses or answers.
    pub(super) fn message_ends(&self) -> Option<Duration> {
        let (since, _) = self.shown_message.as_ref()?;
        self.mode.is_normal().then_some(*since + MESSAGE_TIME)
    }

    /// Removes the message if it has expired.
    pub(super) fn forget_message(&mut self, now: Duration) {
        if self.message_ends().is_some_and(|end| now >= end) {
            self.message = None;
            self.shown_message = None;
        }
    }

    pub(super) fn resize(&mut self, size: Size, aspect: Option<f64>) {
        self.size = size;
        self.aspect = aspect.unwrap_or(DEFAULT_ASPECT);
    }

    pub(super) fn next_glyphs(&mut self) {
        let (glyphs, name) = match self.capability.glyphs {
            Glyphs::Ascii => (Glyphs::Line, words().glyphs_lines()),
            Glyphs::Line => (Glyphs::Braille, words().glyphs_braille()),
            Glyphs::Braille => (
                Glyphs::Blocks(Blocks::Quadrants),
                words().glyphs_quadrants(),
            ),
            Glyphs::Blocks(Blocks::Quadrants) => {
                (Glyphs::Blocks(Blocks::Sextants), words().glyphs_sextants())
            }
            Glyphs::Blocks(Blocks::Sextants) => {
                (Glyphs::Blocks(Blocks::Octants), words().glyphs_octants())
            }
            Glyphs::Blocks(Blocks::Octants) => (Glyphs::Ascii, words().glyphs_ascii()),
        };
        self.capability.glyphs = glyphs;
        self.set_message(words().drawn_with(name));
    }

    pub(super) fn next_colours(&mut self) {
        let colours = self.capability.colours.next();
        self.capability.colours = colours;
        self.set_message(match colours {
            Colours::None => words().no_colours(),
            Colours::Sixteen => words().sixteen_colours(),
            Colours::Indexed => words().colours_of_256(),
            Colours::True => words().true_colours(),
        });
    }

    // ---- prompts whose answer can lose data: they ignore keys typed before they were readable

    /// Opens a prompt. A frame has yet to show it.
    pub(super) fn open_prompt(&mut self, question: Mode) {
        self.seen = None;
        self.mode = question;
    }

    /// Records the time at which the current prompt appeared on the screen.
    pub(super) fn show_question(&mut self, now: Duration) {
        if let Mode::Recovery(_) | Mode::Confirm(_) | Mode::Unsaved(_) = self.mode {
            self.seen.get_or_insert(now);
        }
    }

    /// Returns `true` if a key at `now` may answer the prompt. A prompt about unsaved edits needs no
    /// reading time, because the user's own command caused it.
    pub(super) fn can_be_answered(&self, now: Duration) -> bool {
        let reading = match self.mode {
            Mode::Unsaved(_) => Duration::ZERO,
            _ => REACTION,
        };
        self.seen.is_some_and(|seen| now >= seen + reading)
    }
}
