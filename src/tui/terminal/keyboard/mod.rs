//! Parses the terminal's bytes into keys.
//!
//! A single reader receives everything from the terminal: keys, pasted text, answers to krank's own
//! queries on slow lines, answers to other programs' queries, and noise. It is a state machine
//! after Paul Williams, "A parser for DEC's ANSI-compatible video terminals", vt100.net. It
//! examines each byte once and stores no more than the length of a key. It always recovers: ESC
//! ends any unfinished sequence and starts a new one, Ctrl-C works in every state, and a timeout
//! abandons incomplete input, which the bytes alone cannot reveal.

mod sequence;

use super::rate_limit::ANSWER;
use crate::tui::commands::key::Key;
use crate::tui::commands::mouse::Mouse;
use sequence::{colour, control, csi, mouse, ss3};
use std::time::{Duration, Instant};

/// Timeout after a lone ESC. The rest of an arrow key arrives within a millisecond, even at 9,600
/// baud.
const ESCAPE_TIMEOUT: Duration = Duration::from_millis(25);
/// Timeout for any other incomplete key: long enough for a network, too short to be noticed.
const SEQUENCE_TIMEOUT: Duration = Duration::from_millis(100);
/// Timeout within an unrequested string. Its rest must not be taken for keys, so a network may
/// stall longer.
const STRING_TIMEOUT: Duration = Duration::from_millis(250);
/// Timeout within a paste, which may arrive in pieces.
const PASTE_TIMEOUT: Duration = Duration::from_secs(1);
/// Minimum pause before a Ctrl-C pressed during a paste: pasted bytes follow each other faster.
const MIN_CTRL_C_PAUSE: Duration = Duration::from_millis(50);
/// Maximum pause between pasted bytes; a held key repeats only thirty times a second.
const MAX_PASTE_PAUSE: Duration = Duration::from_millis(25);
/// Maximum length of a key in bytes.
const MAX_KEY_LEN: usize = 8;
/// Maximum duration of a paste. A longer one lacks its end sequence.
const MAX_PASTE_TIME: Duration = Duration::from_secs(2);
/// Maximum length of parameters. Longer sequences are skipped up to their end.
const MAX_SEQUENCE_LEN: usize = 32;
/// Maximum length of a paste into an input line; the rest is dropped.
const MAX_PASTE_LEN: usize = 64 * 1024;

const ESC: u8 = 0x1b;
const CTRL_C: u8 = 0x03;
/// CAN and SUB, which end any sequence.
const CANCELS: [u8; 2] = [0x18, 0x1a];
const BELL: u8 = 0x07;
/// Parameters of the sequence before a paste.
const PASTE_BEGINS: &[u8] = b"200";
const PASTE_ENDS: &[u8] = b"\x1b[201~";
/// Number of bytes in an old-style mouse report, which another program may have left enabled.
const MOUSE: u8 = 3;

/// Input from the terminal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum TerminalInput {
    /// A pressed key.
    Key(Key),
    /// Pasted text, which must never be interpreted as keys.
    Paste(String),
    /// A mouse event.
    Mouse(Mouse),
    /// The answer to krank's own query: everything sent before it has been drawn.
    Answer,
    /// A colour of the terminal.
    Colour(TerminalColour),
}

/// A colour that the terminal reports, in red, green and blue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TerminalColour {
    /// The colour of plain text.
    Text([u8; 3]),
    /// The colour of the background.
    Ground([u8; 3]),
}

/// The state of the parser: the incomplete input.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum PendingInput {
    /// No incomplete input.
    #[default]
    Ground,
    /// An ESC: a key, or the start of a sequence.
    Escape,
    /// A control sequence: parameters, then one letter. Overlong ones are skipped.
    Csi,
    /// A key of the application keypad (SS3).
    Ss3,
    /// A function key of the Linux console.
    Console,
    /// A number of bytes to skip: of a mouse report, or of a character with Alt.
    Skipped(u8),
    /// A UTF-8 character with this number of bytes missing.
    Character(u8),
    /// OSC: a string that may be the answer about a colour.
    Report,
    /// DCS, APC, PM or SOS: a string that krank did not request.
    Text,
    /// Pasted text.
    Paste,
}

/// The parser with its clock.
#[derive(Debug, Default)]
pub(crate) struct Keyboard {
    state: PendingInput,
    /// Bytes of the incomplete character, parameters or paste.
    held: Vec<u8>,
    /// The last eight bytes of a paste, the latest in the lowest byte.
    recent: u64,
    /// The time when the paste began.
    since: Option<Instant>,
    /// `true` if an incomplete paste timed out. Its rest may still arrive.
    overdue: bool,
    /// Bytes that arrived separately within a paste: a key, unless more of the paste follows at
    /// once.
    alone: Vec<u8>,
    last_byte: Option<Instant>,
    /// The answer about a colour, up to the backslash that ends it.
    reported: Option<TerminalColour>,
}

impl Keyboard {
    /// Parses bytes that arrived at `now` and appends the resulting input.
    pub(crate) fn feed(&mut self, bytes: &[u8], now: Instant, inputs: &mut Vec<TerminalInput>) {
        if self.state == PendingInput::Paste && bytes == ANSWER {
            // An answer may arrive between keys or pieces of a paste; it belongs to neither.
            inputs.push(TerminalInput::Answer);
            return;
        }
        if self.overdue && self.is_typed(bytes, now) {
            self.start_sequence(PendingInput::Ground);
        }
        self.interpret_separate(now, inputs);
        if self.state == PendingInput::Paste && !self.overdue && self.is_separate_key(bytes, now) {
            self.alone.extend_from_slice(bytes);
            self.last_byte = Some(now);
            return;
        }
        for &byte in bytes {
            self.take(byte, now, inputs);
            self.last_byte = Some(now);
        }
    }

    /// Interprets bytes that arrived separately within a paste: as keys if no bytes followed at
    /// once, or else as part of the paste.
    fn interpret_separate(&mut self, now: Instant, inputs: &mut Vec<TerminalInput>) {
        if self.alone.is_empty() {
            return;
        }
        let bytes = std::mem::take(&mut self.alone);
        let then = self.last_byte.unwrap_or(now);
        if now.saturating_duration_since(then) >= MAX_PASTE_PAUSE {
            self.pasted(inputs);
            self.start_sequence(PendingInput::Ground);
        }
        for byte in bytes {
            self.take(byte, then, inputs);
        }
    }

    /// Returns `true` if bytes within a paste may be a key: few bytes, after a pause, that do not
    /// end the paste.
    fn is_separate_key(&self, bytes: &[u8], now: Instant) -> bool {
        let pause = self
            .last_byte
            .map(|then| now.saturating_duration_since(then));
        let is_key = bytes.len() <= MAX_KEY_LEN && !bytes.contains(&CTRL_C);
        let has_begun = |end: usize| self.held.ends_with(&PASTE_ENDS[..end]);
        let ends = (1..PASTE_ENDS.len()).any(has_begun) || has_end(bytes);
        is_key && pause >= Some(MAX_PASTE_PAUSE) && !ends
    }

    /// Returns the time to call [`Keyboard::give_up`], if input is incomplete.
    #[must_use]
    pub(crate) fn deadline(&self) -> Option<Instant> {
        let patience = match self.state {
            _ if !self.alone.is_empty() => MAX_PASTE_PAUSE,
            PendingInput::Ground => return None,
            PendingInput::Escape => ESCAPE_TIMEOUT,
            PendingInput::Csi
            | PendingInput::Ss3
            | PendingInput::Console
            | PendingInput::Skipped(_)
            | PendingInput::Character(_) => SEQUENCE_TIMEOUT,
            PendingInput::Report | PendingInput::Text => STRING_TIMEOUT,
            PendingInput::Paste if self.overdue => return None,
            PendingInput::Paste => PASTE_TIMEOUT,
        };
        Some(self.last_byte? + patience)
    }

    /// Ends incomplete input after its timeout: a lone ESC becomes a key, an incomplete paste is
    /// delivered as it is, and anything else is dropped.
    pub(crate) fn give_up(&mut self, inputs: &mut Vec<TerminalInput>) {
        if let Some(then) = self.last_byte.filter(|_| !self.alone.is_empty()) {
            self.interpret_separate(then + MAX_PASTE_PAUSE, inputs);
            return;
        }
        match self.state {
            PendingInput::Escape => inputs.push(TerminalInput::Key(Key::Escape)),
            PendingInput::Paste => {
                self.pasted(inputs);
                self.overdue = true;
                return;
            }
            _ => {}
        }
        self.start_sequence(PendingInput::Ground);
    }

    fn start_sequence(&mut self, state: PendingInput) {
        self.state = state;
        self.held.clear();
        self.alone.clear();
        self.overdue = false;
    }

    /// Returns `true` if bytes after a stalled paste are keys. Keys arrive separately; the rest of
    /// a paste arrives in bulk and with its end sequence.
    fn is_typed(&self, bytes: &[u8], now: Instant) -> bool {
        let is_alone = self
            .last_byte
            .is_none_or(|then| now - then.min(now) >= MIN_CTRL_C_PAUSE);
        is_alone && bytes.len() <= MAX_KEY_LEN && !has_end(bytes)
    }

    /// Delivers the stored part of a paste.
    fn pasted(&mut self, inputs: &mut Vec<TerminalInput>) {
        self.held.truncate(MAX_PASTE_LEN);
        if !self.held.is_empty() {
            let text = String::from_utf8_lossy(&self.held).into_owned();
            inputs.push(TerminalInput::Paste(text));
        }
        self.held.clear();
    }

    fn take(&mut self, byte: u8, now: Instant, inputs: &mut Vec<TerminalInput>) {
        if self.state == PendingInput::Paste {
            self.paste(byte, now, inputs);
            return;
        }
        match byte {
            // ESC ends incomplete input. A preceding ESC was a key; this one often starts the
            // answer to a frame, which may follow the key immediately.
            ESC => {
                let reported = self.report();
                self.give_up(inputs);
                self.start_sequence(PendingInput::Escape);
                self.reported = reported;
            }
            CTRL_C => {
                self.start_sequence(PendingInput::Ground);
                inputs.push(TerminalInput::Key(Key::Ctrl('c')));
            }
            _ if CANCELS.contains(&byte) && self.state != PendingInput::Ground => {
                self.start_sequence(PendingInput::Ground);
            }
            _ => self.dispatch_byte(byte, now, inputs),
        }
    }

    fn dispatch_byte(&mut self, byte: u8, now: Instant, inputs: &mut Vec<TerminalInput>) {
        match self.state {
            PendingInput::Ground | PendingInput::Paste => self.ground(byte, inputs),
            PendingInput::Escape => self.escape(byte, inputs),
            PendingInput::Csi => self.csi(byte, now, inputs),
            PendingInput::Ss3 => self.ss3(byte, inputs),
            PendingInput::Character(rest) => self.character(byte, rest, inputs),
            PendingInput::Console => {
                self.start_sequence(PendingInput::Ground);
                if let b'A'..=b'E' = byte {
                    inputs.push(TerminalInput::Key(Key::Function(byte - b'A' + 1)));
                }
            }
            PendingInput::Skipped(rest) => self.start_sequence(match rest {
                0 | 1 => PendingInput::Ground,
                _ => PendingInput::Skipped(rest - 1),
            }),
            PendingInput::Report | PendingInput::Text if byte == BELL => {
                inputs.extend(self.report().map(TerminalInput::Colour));
                self.start_sequence(PendingInput::Ground);
            }
            PendingInput::Report => self.hold(byte),
            PendingInput::Text => {}
        }
    }

    fn ground(&mut self, byte: u8, inputs: &mut Vec<TerminalInput>) {
        match byte {
            0x00..0x20 | 0x7f => inputs.extend(control(byte).map(TerminalInput::Key)),
            0x20..0x7f => inputs.push(TerminalInput::Key(Key::Char(char::from(byte)))),
            // 8-bit control characters, which start no character in UTF-8.
            0x8f => self.start_sequence(PendingInput::Ss3),
            0x9b => self.start_sequence(PendingInput::Csi),
            0x9d => self.start_sequence(PendingInput::Report),
            0x90 | 0x98 | 0x9e | 0x9f => self.start_sequence(PendingInput::Text),
            0xc2..=0xdf => self.start_character(byte, 1),
            0xe0..=0xef => self.start_character(byte, 2),
            0xf0..=0xf4 => self.start_character(byte, 3),
            _ => {}
        }
    }

    fn start_character(&mut self, byte: u8, rest: u8) {
        self.start_sequence(PendingInput::Character(rest));
        self.held.push(byte);
    }

    fn character(&mut self, byte: u8, rest: u8, inputs: &mut Vec<TerminalInput>) {
        // An invalid continuation byte, probably of another encoding: the incomplete character is
        // dropped.
        if byte & 0xc0 != 0x80 {
            self.start_sequence(PendingInput::Ground);
            self.ground(byte, inputs);
            return;
        }
        self.held.push(byte);
        if rest > 1 {
            self.state = PendingInput::Character(rest - 1);
            return;
        }
        let text = std::str::from_utf8(&self.held).ok();
        let character = text.and_then(|text| text.chars().next());
        inputs.extend(
            character
                .filter(|c| !c.is_control())
                .map(|c| TerminalInput::Key(Key::Char(c))),
        );
        self.start_sequence(PendingInput::Ground);
    }

    fn escape(&mut self, byte: u8, inputs: &mut Vec<TerminalInput>) {
        // ESC and a backslash end a string.
        let reported = self.reported.take().filter(|_| byte == b'\\');
        inputs.extend(reported.map(TerminalInput::Colour));
        match byte {
            b'[' => self.start_sequence(PendingInput::Csi),
            b'O' => self.start_sequence(PendingInput::Ss3),
            b']' => self.start_sequence(PendingInput::Report),
            b'P' | b'_' | b'^' | b'X' => self.start_sequence(PendingInput::Text),
            // The end of a string, or a key with Alt, which is ignored: a slow line joins Esc with
            // the next key.
            0xc2..=0xdf => self.start_sequence(PendingInput::Skipped(1)),
            0xe0..=0xef => self.start_sequence(PendingInput::Skipped(2)),
            0xf0..=0xf4 => self.start_sequence(PendingInput::Skipped(3)),
            _ => self.start_sequence(PendingInput::Ground),
        }
    }

    fn csi(&mut self, byte: u8, now: Instant, inputs: &mut Vec<TerminalInput>) {
        match byte {
            0x20..0x40 => self.hold(byte),
            b'[' if self.held.is_empty() => self.start_sequence(PendingInput::Console),
            b'M' if self.held.is_empty() => self.start_sequence(PendingInput::Skipped(MOUSE)),
            b'~' if self.held == PASTE_BEGINS => {
                self.start_sequence(PendingInput::Paste);
                (self.recent, self.since) = (0, Some(now));
            }
            b'n' if self.held == b"0" => {
                self.start_sequence(PendingInput::Ground);
                inputs.push(TerminalInput::Answer);
            }
            b'M' | b'm' if let Some(report) = self.held.strip_prefix(b"<") => {
                inputs.extend(mouse(report, byte).map(TerminalInput::Mouse));
                self.start_sequence(PendingInput::Ground);
            }
            0x40..0x7f => {
                if self.held.len() < MAX_SEQUENCE_LEN {
                    inputs.extend(csi(&self.held, byte).map(TerminalInput::Key));
                }
                self.start_sequence(PendingInput::Ground);
            }
            // A byte invalid in any sequence: the sequence was noise, and this is a key.
            _ => {
                self.start_sequence(PendingInput::Ground);
                self.ground(byte, inputs);
            }
        }
    }

    /// Returns the colour if the string is the answer about one.
    fn report(&self) -> Option<TerminalColour> {
        (self.state == PendingInput::Report).then(|| colour(&self.held))?
    }

    /// Stores a parameter byte, up to a maximum number.
    fn hold(&mut self, byte: u8) {
        if self.held.len() < MAX_SEQUENCE_LEN {
            self.held.push(byte);
        }
    }

    fn ss3(&mut self, byte: u8, inputs: &mut Vec<TerminalInput>) {
        match byte {
            b'0'..=b';' => {}
            0x20..0x7f => {
                inputs.extend(ss3(byte).map(TerminalInput::Key));
                self.start_sequence(PendingInput::Ground);
            }
            _ => {
                self.start_sequence(PendingInput::Ground);
                self.ground(byte, inputs);
            }
        }
    }

    fn paste(&mut self, byte: u8, now: Instant, inputs: &mut Vec<TerminalInput>) {
        if byte == CTRL_C && self.is_pressed(now) {
            self.start_sequence(PendingInput::Ground);
            inputs.push(TerminalInput::Key(Key::Ctrl('c')));
            return;
        }
        self.recent = self.recent << 8 | u64::from(byte);
        if self.held.len() < MAX_PASTE_LEN + PASTE_ENDS.len() {
            self.held.push(byte);
        }
        if self.ends_paste(PASTE_ENDS) {
            self.drop_end(PASTE_ENDS);
            self.pasted(inputs);
            self.start_sequence(PendingInput::Ground);
        } else if self.ends_paste(ANSWER) {
            // The terminal answers as soon as it has drawn, even during a paste.
            self.drop_end(ANSWER);
            inputs.push(TerminalInput::Answer);
        }
    }

    /// Returns `true` if a Ctrl-C within a paste is a key: after a pause, or in a paste without
    /// end.
    fn is_pressed(&self, now: Instant) -> bool {
        let since = |then: Option<Instant>| then.map_or(Duration::ZERO, |t| now - t.min(now));
        since(self.last_byte) >= MIN_CTRL_C_PAUSE
            || since(self.since) >= MAX_PASTE_TIME
            || self.held.len() > MAX_PASTE_LEN
    }

    /// Returns `true` if the paste ends with these bytes.
    fn ends_paste(&self, end: &[u8]) -> bool {
        let bytes = self.recent.to_be_bytes();
        bytes.ends_with(end)
    }

    fn drop_end(&mut self, end: &[u8]) {
        if self.held.ends_with(end) {
            self.held.truncate(self.held.len() - end.len());
        }
    }
}

/// Returns `true` if these bytes contain the end of a paste.
fn has_end(bytes: &[u8]) -> bool {
    let mut parts = bytes.windows(PASTE_ENDS.len());
    parts.any(|part| part == PASTE_ENDS)
}

#[cfg(test)]
mod tests;
