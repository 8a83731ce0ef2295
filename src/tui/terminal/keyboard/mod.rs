//! From the terminal's bytes to keys.
//!
//! One reader sees everything that the terminal sends: keys, text that is pasted, answers to our questions on
//! slow lines, answers to the questions of others, and noise. It is a state machine (after Paul Williams,
//! "A parser for DEC's ANSI-compatible video terminals", vt100.net) that looks at each byte once and holds no more than a
//! key is long. It always comes back: an ESC ends whatever was unfinished and begins anew, Ctrl-C is heard
//! everywhere, and after a silence, which the bytes alone cannot tell, what has come so far is given up.

mod sequence;

use super::rate_limit::ANSWER;
use crate::tui::commands::key::Key;
use crate::tui::commands::mouse::Mouse;
use sequence::{control, csi, mouse, ss3};
use std::time::{Duration, Instant};

/// After a lone ESC. The tail of an arrow key comes within a millisecond, also at 9,600 baud.
const ESCAPE_PATIENCE: Duration = Duration::from_millis(25);
/// After any other unfinished key: long enough for a network, too short to be felt as deaf.
const SEQUENCE_PATIENCE: Duration = Duration::from_millis(100);
/// Within a string that was not asked for. Its rest must not be typed, so that a network may stall longer.
const STRING_PATIENCE: Duration = Duration::from_millis(250);
/// Within a paste, which may come in pieces.
const PASTE_PATIENCE: Duration = Duration::from_secs(1);
/// Before a Ctrl-C within a paste that a person has pressed: pasted bytes follow on each other's heels.
const PRESSED: Duration = Duration::from_millis(50);
/// Pasted bytes follow each other faster than this; a key that is held down comes thirty times a second.
const HEELS: Duration = Duration::from_millis(25);
/// No key that a person presses has more bytes.
const LONGEST_KEY: usize = 8;
/// A paste that takes longer has no end.
const LONGEST_PASTING: Duration = Duration::from_secs(2);
/// No key has more parameters; of a longer sequence only the end is waited for.
const LONGEST_SEQUENCE: usize = 32;
/// What a paste may bring into an input line; the rest of a longer one is thrown away.
const LONGEST_PASTE: usize = 64 * 1024;

const ESC: u8 = 0x1b;
const CTRL_C: u8 = 0x03;
/// CAN and SUB, which end any sequence.
const CANCELS: [u8; 2] = [0x18, 0x1a];
const BELL: u8 = 0x07;
/// Parameters of the sequence before a paste.
const PASTE_BEGINS: &[u8] = b"200";
const PASTE_ENDS: &[u8] = b"\x1b[201~";
/// Coordinates behind the report of a mouse that another program has left on.
const MOUSE: u8 = 3;

/// What the terminal sent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum TerminalInput {
    /// A key was pressed.
    Key(Key),
    /// Text was pasted; it must never be taken for keys.
    Paste(String),
    /// Something was done with the mouse.
    Mouse(Mouse),
    /// The terminal answered our question: all that was sent before has been drawn.
    Answer,
}

/// What has begun and not ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Unfinished {
    /// Nothing.
    #[default]
    Ground,
    /// An ESC: a key, or the beginning of something.
    Escape,
    /// A control sequence: parameters, then one letter. A long one is only waited out.
    Csi,
    /// A key of the other keypad.
    Ss3,
    /// A function key of the Linux console.
    Console,
    /// So many bytes that are no key: of a mouse report, of a character with Alt.
    Skipped(u8),
    /// A character of so many more bytes.
    Character(u8),
    /// OSC, DCS, APC, PM or SOS: a string that somebody else has asked for.
    Text,
    /// Text that is pasted.
    Paste,
}

/// The state machine with its clock.
#[derive(Debug, Default)]
pub(crate) struct Keyboard {
    state: Unfinished,
    /// Bytes of the character, the parameters or the paste that has begun.
    held: Vec<u8>,
    /// The last bytes of a paste, the latest lowest.
    recent: u64,
    /// When the paste began.
    since: Option<Instant>,
    /// Whether what had come of a paste was given up: its rest may still come.
    overdue: bool,
    /// Bytes that came alone within a paste: a key, unless the paste goes on at once.
    alone: Vec<u8>,
    last_byte: Option<Instant>,
}

impl Keyboard {
    /// Takes bytes that came `now`, and appends what they mean.
    pub(crate) fn feed(&mut self, bytes: &[u8], now: Instant, inputs: &mut Vec<TerminalInput>) {
        if self.state == Unfinished::Paste && bytes == ANSWER {
            // It comes between keys and between pieces of a paste, and belongs to neither.
            inputs.push(TerminalInput::Answer);
            return;
        }
        if self.overdue && self.is_typed(bytes, now) {
            self.begin(Unfinished::Ground);
        }
        self.settle_alone(now, inputs);
        if self.state == Unfinished::Paste && !self.overdue && self.comes_alone(bytes, now) {
            self.alone.extend_from_slice(bytes);
            self.last_byte = Some(now);
            return;
        }
        for &byte in bytes {
            self.take(byte, now, inputs);
            self.last_byte = Some(now);
        }
    }

    /// Decides what bytes were that came alone within a paste: keys, if nothing followed them at once, and else a part
    /// of the paste.
    fn settle_alone(&mut self, now: Instant, inputs: &mut Vec<TerminalInput>) {
        if self.alone.is_empty() {
            return;
        }
        let bytes = std::mem::take(&mut self.alone);
        let then = self.last_byte.unwrap_or(now);
        if now.saturating_duration_since(then) >= HEELS {
            self.pasted(inputs);
            self.begin(Unfinished::Ground);
        }
        for byte in bytes {
            self.take(byte, then, inputs);
        }
    }

    /// Returns `true` if bytes within a paste may be a key: they are few, come after a pause, and do not end it.
    fn comes_alone(&self, bytes: &[u8], now: Instant) -> bool {
        let pause = self
            .last_byte
            .map(|then| now.saturating_duration_since(then));
        let is_key = bytes.len() <= LONGEST_KEY && !bytes.contains(&CTRL_C);
        let has_begun = |end: usize| self.held.ends_with(&PASTE_ENDS[..end]);
        let ends = (1..PASTE_ENDS.len()).any(has_begun) || has_end(bytes);
        is_key && pause >= Some(HEELS) && !ends
    }

    /// When to call [`Keyboard::give_up`], if anything is held back.
    #[must_use]
    pub(crate) fn deadline(&self) -> Option<Instant> {
        let patience = match self.state {
            _ if !self.alone.is_empty() => HEELS,
            Unfinished::Ground => return None,
            Unfinished::Escape => ESCAPE_PATIENCE,
            Unfinished::Csi
            | Unfinished::Ss3
            | Unfinished::Console
            | Unfinished::Skipped(_)
            | Unfinished::Character(_) => SEQUENCE_PATIENCE,
            Unfinished::Text => STRING_PATIENCE,
            Unfinished::Paste if self.overdue => return None,
            Unfinished::Paste => PASTE_PATIENCE,
        };
        Some(self.last_byte? + patience)
    }

    /// The rest did not come: a lone ESC was the key, of a paste is taken what there is, anything else is
    /// dropped.
    pub(crate) fn give_up(&mut self, inputs: &mut Vec<TerminalInput>) {
        if let Some(then) = self.last_byte.filter(|_| !self.alone.is_empty()) {
            self.settle_alone(then + HEELS, inputs);
            return;
        }
        match self.state {
            Unfinished::Escape => inputs.push(TerminalInput::Key(Key::Escape)),
            Unfinished::Paste => {
                self.pasted(inputs);
                self.overdue = true;
                return;
            }
            _ => {}
        }
        self.begin(Unfinished::Ground);
    }

    fn begin(&mut self, state: Unfinished) {
        self.state = state;
        self.held.clear();
        self.alone.clear();
        self.overdue = false;
    }

    /// Whether bytes behind a paste that has stalled are keys: a person's come alone, the rest of a paste comes
    /// on the heels of each other, and with its end.
    fn is_typed(&self, bytes: &[u8], now: Instant) -> bool {
        let is_alone = self
            .last_byte
            .is_none_or(|then| now - then.min(now) >= PRESSED);
        is_alone && bytes.len() <= LONGEST_KEY && !has_end(bytes)
    }

    /// What has come of a paste is text.
    fn pasted(&mut self, inputs: &mut Vec<TerminalInput>) {
        self.held.truncate(LONGEST_PASTE);
        if !self.held.is_empty() {
            let text = String::from_utf8_lossy(&self.held).into_owned();
            inputs.push(TerminalInput::Paste(text));
        }
        self.held.clear();
    }

    fn take(&mut self, byte: u8, now: Instant, inputs: &mut Vec<TerminalInput>) {
        if self.state == Unfinished::Paste {
            self.paste(byte, now, inputs);
            return;
        }
        match byte {
            // What was unfinished is over. After another ESC, that one was a key: often this one begins the
            // answer to a frame, which comes upon the heels of the key.
            ESC => {
                self.give_up(inputs);
                self.begin(Unfinished::Escape);
            }
            CTRL_C => {
                self.begin(Unfinished::Ground);
                inputs.push(TerminalInput::Key(Key::Ctrl('c')));
            }
            _ if CANCELS.contains(&byte) && self.state != Unfinished::Ground => {
                self.begin(Unfinished::Ground);
            }
            _ => self.go_on(byte, now, inputs),
        }
    }

    fn go_on(&mut self, byte: u8, now: Instant, inputs: &mut Vec<TerminalInput>) {
        match self.state {
            Unfinished::Ground | Unfinished::Paste => self.ground(byte, inputs),
            Unfinished::Escape => self.escape(byte),
            Unfinished::Csi => self.csi(byte, now, inputs),
            Unfinished::Ss3 => self.ss3(byte, inputs),
            Unfinished::Character(rest) => self.character(byte, rest, inputs),
            Unfinished::Console => {
                self.begin(Unfinished::Ground);
                if let b'A'..=b'E' = byte {
                    inputs.push(TerminalInput::Key(Key::Function(byte - b'A' + 1)));
                }
            }
            Unfinished::Skipped(rest) => self.begin(match rest {
                0 | 1 => Unfinished::Ground,
                _ => Unfinished::Skipped(rest - 1),
            }),
            Unfinished::Text if byte == BELL => self.begin(Unfinished::Ground),
            Unfinished::Text => {}
        }
    }

    fn ground(&mut self, byte: u8, inputs: &mut Vec<TerminalInput>) {
        match byte {
            0x00..0x20 | 0x7f => inputs.extend(control(byte).map(TerminalInput::Key)),
            0x20..0x7f => inputs.push(TerminalInput::Key(Key::Char(char::from(byte)))),
            // A terminal of eight bits begins its sequences so; no character begins so in UTF-8.
            0x8f => self.begin(Unfinished::Ss3),
            0x9b => self.begin(Unfinished::Csi),
            0x90 | 0x98 | 0x9d..=0x9f => self.begin(Unfinished::Text),
            0xc2..=0xdf => self.begin_character(byte, 1),
            0xe0..=0xef => self.begin_character(byte, 2),
            0xf0..=0xf4 => self.begin_character(byte, 3),
            _ => {}
        }
    }

    fn begin_character(&mut self, byte: u8, rest: u8) {
        self.begin(Unfinished::Character(rest));
        self.held.push(byte);
    }

    fn character(&mut self, byte: u8, rest: u8, inputs: &mut Vec<TerminalInput>) {
        // A letter of another encoding: it is dropped, and what follows is none of it.
        if byte & 0xc0 != 0x80 {
            self.begin(Unfinished::Ground);
            self.ground(byte, inputs);
            return;
        }
        self.held.push(byte);
        if rest > 1 {
            self.state = Unfinished::Character(rest - 1);
            return;
        }
        let text = std::str::from_utf8(&self.held).ok();
        let character = text.and_then(|text| text.chars().next());
        inputs.extend(
            character
                .filter(|c| !c.is_control())
                .map(|c| TerminalInput::Key(Key::Char(c))),
        );
        self.begin(Unfinished::Ground);
    }

    fn escape(&mut self, byte: u8) {
        match byte {
            b'[' => self.begin(Unfinished::Csi),
            b'O' => self.begin(Unfinished::Ss3),
            b']' | b'P' | b'_' | b'^' | b'X' => self.begin(Unfinished::Text),
            // The end of a string, or a key with Alt, which is none: a slow line joins Esc and the next key.
            0xc2..=0xdf => self.begin(Unfinished::Skipped(1)),
            0xe0..=0xef => self.begin(Unfinished::Skipped(2)),
            0xf0..=0xf4 => self.begin(Unfinished::Skipped(3)),
            _ => self.begin(Unfinished::Ground),
        }
    }

    fn csi(&mut self, byte: u8, now: Instant, inputs: &mut Vec<TerminalInput>) {
        match byte {
            0x20..0x40 => self.hold(byte),
            b'[' if self.held.is_empty() => self.begin(Unfinished::Console),
            b'M' if self.held.is_empty() => self.begin(Unfinished::Skipped(MOUSE)),
            b'~' if self.held == PASTE_BEGINS => {
                self.begin(Unfinished::Paste);
                (self.recent, self.since) = (0, Some(now));
            }
            b'n' if self.held == b"0" => {
                self.begin(Unfinished::Ground);
                inputs.push(TerminalInput::Answer);
            }
            b'M' | b'm' if let Some(report) = self.held.strip_prefix(b"<") => {
                inputs.extend(mouse(report, byte).map(TerminalInput::Mouse));
                self.begin(Unfinished::Ground);
            }
            0x40..0x7f => {
                if self.held.len() < LONGEST_SEQUENCE {
                    inputs.extend(csi(&self.held, byte).map(TerminalInput::Key));
                }
                self.begin(Unfinished::Ground);
            }
            // No sequence has these: it was noise, and this is a key.
            _ => {
                self.begin(Unfinished::Ground);
                self.ground(byte, inputs);
            }
        }
    }

    /// Holds a parameter; of too many, that there were too many.
    fn hold(&mut self, byte: u8) {
        if self.held.len() < LONGEST_SEQUENCE {
            self.held.push(byte);
        }
    }

    fn ss3(&mut self, byte: u8, inputs: &mut Vec<TerminalInput>) {
        match byte {
            b'0'..=b';' => {}
            0x20..0x7f => {
                inputs.extend(ss3(byte).map(TerminalInput::Key));
                self.begin(Unfinished::Ground);
            }
            _ => {
                self.begin(Unfinished::Ground);
                self.ground(byte, inputs);
            }
        }
    }

    fn paste(&mut self, byte: u8, now: Instant, inputs: &mut Vec<TerminalInput>) {
        if byte == CTRL_C && self.is_pressed(now) {
            self.begin(Unfinished::Ground);
            inputs.push(TerminalInput::Key(Key::Ctrl('c')));
            return;
        }
        self.recent = self.recent << 8 | u64::from(byte);
        if self.held.len() < LONGEST_PASTE + PASTE_ENDS.len() {
            self.held.push(byte);
        }
        if self.has_come(PASTE_ENDS) {
            self.drop_end(PASTE_ENDS);
            self.pasted(inputs);
            self.begin(Unfinished::Ground);
        } else if self.has_come(ANSWER) {
            // The terminal answers whenever it has drawn, in the middle of a paste too.
            self.drop_end(ANSWER);
            inputs.push(TerminalInput::Answer);
        }
    }

    /// Whether a Ctrl-C within a paste is a key: nothing came just before it, or the paste has no end.
    fn is_pressed(&self, now: Instant) -> bool {
        let since = |then: Option<Instant>| then.map_or(Duration::ZERO, |t| now - t.min(now));
        since(self.last_byte) >= PRESSED
            || since(self.since) >= LONGEST_PASTING
            || self.held.len() > LONGEST_PASTE
    }

    /// Whether the last bytes of the paste are these.
    fn has_come(&self, end: &[u8]) -> bool {
        let bytes = self.recent.to_be_bytes();
        bytes.ends_with(end)
    }

    fn drop_end(&mut self, end: &[u8]) {
        if self.held.ends_with(end) {
            self.held.truncate(self.held.len() - end.len());
        }
    }
}

/// Returns `true` if a paste ends within these bytes.
fn has_end(bytes: &[u8]) -> bool {
    let mut parts = bytes.windows(PASTE_ENDS.len());
    parts.any(|part| part == PASTE_ENDS)
}

#[cfg(test)]
mod tests;
