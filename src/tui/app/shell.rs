//! What keys go to, what is looked at, and on what screen.

use super::pointing::Gripped;
use super::{Mode, View};
use crate::capability::{Capability, Colours, Detected, PictureProtocol};
use crate::drawing::{Blocks, Glyphs};
use crate::tui::appearance::palette::Theme;
use crate::tui::commands::keymap::Keymap;
use crate::tui::player::open_scene::OpenScene;
use crate::tui::views::layout::Composition;
use crate::wording::words;
use ratatui::layout::Size;
use std::time::Duration;

/// The height of a cell for its width in most fonts.
const USUAL_ASPECT: f64 = 2.0;
/// Who has not seen a question for so long has typed for something else.
const REACTION: Duration = Duration::from_millis(300);
/// What has been said for so long has been read, or nobody is there.
const LEGIBLE: Duration = Duration::from_secs(8);

/// The scene as it was before an edit.
#[derive(Debug)]
pub(super) struct SceneBefore {
    pub open_scene: OpenScene,
    /// Whether a key has come since, which may go on with the edit.
    pub is_past: bool,
}

/// The workbench around the scene.
#[derive(Debug)]
pub(super) struct Shell {
    pub mode: Mode,
    pub keymap: Keymap,
    pub view: View,
    /// Which panes stand beside it, and where.
    pub composition: Composition,
    /// Lines that each view is scrolled by.
    pub scroll: [usize; View::ALL.len()],
    /// Said in the last line until the next key, or until it has been there for long enough.
    pub message: Option<String>,
    /// Since when it is on the screen, and what it is.
    told: Option<(Duration, String)>,
    /// The scene as it was before the last edit; until the next key.
    pub before: Option<SceneBefore>,
    /// Since when a question is on the screen.
    seen: Option<Duration>,

    /// Whether the mouse is ours, and what its button holds.
    pub has_mouse: bool,
    pub grip: Gripped,

    // The terminal.
    pub capability: Capability,
    /// How it is sent pictures, or why it is not.
    pub pictures: Detected<Option<PictureProtocol>>,
    pub theme: Theme,
    pub size: Size,
    /// The height of a cell for its width.
    pub aspect: f64,
}

impl Shell {
    pub(super) fn new(capability: Capability, size: Size) -> Self {
        Shell {
            mode: Mode::Normal,
            keymap: Keymap::default(),
            view: View::default(),
            composition: Composition::default(),
            scroll: [0; View::ALL.len()],
            message: None,
            told: None,
            before: None,
            seen: None,
            has_mouse: false,
            grip: Gripped::default(),
            capability,
            pictures: Detected {
                value: None,
                why: words().pictures_unwanted().into(),
            },
            theme: Theme::default(),
            size,
            aspect: USUAL_ASPECT,
        }
    }

    pub(super) fn say(&mut self, message: impl Into<String>) {
        self.message = Some(message.into());
        self.told = None;
    }

    /// What is said is on the screen, if anything is.
    pub(super) fn show_message(&mut self, now: Duration) {
        let is_told = self.told.as_ref().map(|(_, told)| told) == self.message.as_ref();
        if !is_told {
            self.told = self.message.clone().map(|message| (now, message));
        }
    }

    /// When what is said has been there for long enough: not while something is typed, chosen or asked.
    pub(super) fn message_ends(&self) -> Option<Duration> {
        let (since, _) = self.told.as_ref()?;
        (self.mode == Mode::Normal).then_some(*since + LEGIBLE)
    }

    /// Time has passed.
    pub(super) fn forget_message(&mut self, now: Duration) {
        if self.message_ends().is_some_and(|end| now >= end) {
            self.message = None;
            self.told = None;
        }
    }

    pub(super) fn resize(&mut self, size: Size, aspect: Option<f64>) {
        self.size = size;
        self.aspect = aspect.unwrap_or(USUAL_ASPECT);
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
        self.say(words().drawn_with(name));
    }

    pub(super) fn next_colours(&mut self) {
        let colours = self.capability.colours.next();
        self.capability.colours = colours;
        self.say(match colours {
            Colours::None => words().no_colours(),
            Colours::Sixteen => words().sixteen_colours(),
            Colours::Indexed => words().colours_of_256(),
            Colours::True => words().true_colours(),
        });
    }

    // ---- questions whose answer can lose something: no key answers one that was typed before it could be read

    /// Asks; nobody has seen it yet.
    pub(super) fn ask(&mut self, question: Mode) {
        self.seen = None;
        self.mode = question;
    }

    /// What is asked is on the screen, if anything is.
    pub(super) fn show_question(&mut self, now: Duration) {
        if let Mode::Recovery(_) | Mode::Confirm(_) | Mode::Unsaved(_) = self.mode {
            self.seen.get_or_insert(now);
        }
    }

    /// Whether a key that comes now can be meant for what is asked. Who leaves knows what is asked then, and
    /// need not read it.
    pub(super) fn can_be_answered(&self, now: Duration) -> bool {
        let reading = match self.mode {
            Mode::Unsaved(_) => Duration::ZERO,
            _ => REACTION,
        };
        self.seen.is_some_and(|seen| now >= seen + reading)
    }
}
