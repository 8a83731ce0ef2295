//! From the terminal's bytes to keys.
//!
//! Bytes are read by us and parsed by `termina`, because one reader must see everything that the
//! terminal sends: keys, and answers to our own questions on slow lines. What the parser
//! cannot know is time: a lone ESC is a key when nothing follows, and half a sequence (noise on the
//! line, Alt and a bracket) must not make the program deaf. So this wrapper knows what is held back
//! and for how long.

use super::pace::ANSWER;
use crate::tui::key::Key;
use std::time::{Duration, Instant};
use termina::event::{KeyCode, KeyEvent, KeyEventKind, Modifiers};
use termina::{Event, Parser};

/// After a lone ESC. The tail of an arrow key comes within a millisecond, also at 9,600 baud.
const ESCAPE_PATIENCE: Duration = Duration::from_millis(25);
/// After any other unfinished sequence: long enough for a network, too short to be felt as deaf.
const SEQUENCE_PATIENCE: Duration = Duration::from_millis(100);
/// Within a paste, which may come in pieces.
const PASTE_PATIENCE: Duration = Duration::from_secs(1);
/// No key and no answer is longer.
const LONGEST_SEQUENCE: usize = 256;
/// What a paste may bring into an input line; the front of a longer one is thrown away.
const LONGEST_PASTE: usize = 64 * 1024;

const ESC: u8 = 0x1b;
const PASTE_BEGINS: &[u8] = b"\x1b[200~";

/// What the terminal sent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Input {
    /// A key was pressed.
    Key(Key),
    /// Text was pasted; it must never be taken for keys.
    Paste(String),
    /// The terminal answered our question: all that was sent before has been drawn.
    Answer,
}

/// The parser with its clock.
#[derive(Debug, Default)]
pub(crate) struct Keyboard {
    parser: Parser,
    /// Bytes since the last event: what the parser may be holding, at most its start and end.
    held: Vec<u8>,
    pasting: bool,
    last_byte: Option<Instant>,
}

impl Keyboard {
    /// Takes bytes that came `now`, and appends what they mean.
    pub(crate) fn feed(&mut self, bytes: &[u8], now: Instant, inputs: &mut Vec<Input>) {
        for &byte in bytes {
            // An ESC upon a lone ESC begins something new. Often that is the answer to a frame; the
            // parser would take both for one key, and the rest of the answer for typed characters.
            if byte == ESC && self.held == [ESC] {
                self.give_up(inputs);
            }
            self.parser.parse(&[byte], true);
            self.held.push(byte);
            self.take(inputs);
            self.bound();
        }
        self.last_byte = Some(now);
    }

    /// When to call [`Keyboard::give_up`], if anything is held back.
    #[must_use]
    pub(crate) fn deadline(&self) -> Option<Instant> {
        let patience = if self.pasting {
            PASTE_PATIENCE
        } else if self.held.ends_with(b"\x1b") {
            ESCAPE_PATIENCE
        } else {
            SEQUENCE_PATIENCE
        };
        let last = self.last_byte.filter(|_| !self.held.is_empty())?;
        Some(last + patience)
    }

    /// The rest did not come: a lone ESC was the key, anything else is dropped.
    pub(crate) fn give_up(&mut self, inputs: &mut Vec<Input>) {
        if !self.pasting && self.held.ends_with(b"\x1b") {
            self.parser.parse(&[], false);
            self.take(inputs);
        }
        *self = Keyboard::default();
    }

    fn take(&mut self, inputs: &mut Vec<Input>) {
        if self.held.ends_with(PASTE_BEGINS) {
            self.pasting = true;
        }
        // The parser knows no such answer and drops it.
        if !self.pasting && self.held.ends_with(ANSWER) {
            self.held.clear();
            inputs.push(Input::Answer);
        }
        while let Some(event) = self.parser.pop() {
            self.held.clear();
            self.pasting = false;
            match event {
                Event::Key(event) => inputs.extend(key(event).map(Input::Key)),
                Event::Paste(text) => inputs.push(Input::Paste(text)),
                // Neither mouse nor focus is asked for, and no question is open.
                Event::Mouse(_) | Event::FocusIn | Event::FocusOut | Event::WindowResized(_) => {}
                Event::Csi(_) | Event::Osc(_) | Event::Dcs(_) => {}
            }
        }
    }

    /// Keeps memory bounded, whatever is sent.
    fn bound(&mut self) {
        let longest = if self.pasting {
            LONGEST_PASTE
        } else {
            LONGEST_SEQUENCE
        };
        if self.held.len() <= longest {
            return;
        }
        self.parser = Parser::default();
        self.held.clear();
        if self.pasting {
            // Still inside the paste: begin another one, so that its rest is not taken for keys.
            self.parser.parse(PASTE_BEGINS, true);
            self.held.extend_from_slice(PASTE_BEGINS);
        }
    }
}

/// The key of an event, unless it is one that krank does not know.
fn key(event: KeyEvent) -> Option<Key> {
    let with = |modifier| event.modifiers.contains(modifier);
    if event.kind == KeyEventKind::Release || with(Modifiers::ALT) {
        return None;
    }
    let control = with(Modifiers::CONTROL);
    let key = match event.code {
        // Some terminals send this for the key that erases.
        KeyCode::Char('h') if control => Key::Backspace,
        KeyCode::Char(c) if control => Key::Ctrl(c.to_ascii_lowercase()),
        KeyCode::Char(c) if c.is_control() => return None,
        KeyCode::Char(c) => Key::Char(c),
        KeyCode::Function(n) => Key::Function(n),
        KeyCode::Enter => Key::Enter,
        KeyCode::Escape => Key::Escape,
        KeyCode::Tab => Key::Tab,
        KeyCode::BackTab => Key::BackTab,
        KeyCode::Backspace => Key::Backspace,
        KeyCode::Left => Key::Left,
        KeyCode::Right => Key::Right,
        KeyCode::Up => Key::Up,
        KeyCode::Down => Key::Down,
        KeyCode::Home => Key::Home,
        KeyCode::End => Key::End,
        KeyCode::PageUp => Key::PageUp,
        KeyCode::PageDown => Key::PageDown,
        _ => return None,
    };
    let plain = matches!(key, Key::Char(_) | Key::Ctrl(_) | Key::Backspace) || !control;
    plain.then_some(key)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn keys_of(pieces: &[&[u8]]) -> Vec<Input> {
        let mut keyboard = Keyboard::default();
        let mut inputs = Vec::new();
        for piece in pieces {
            keyboard.feed(piece, Instant::now(), &mut inputs);
        }
        if keyboard.deadline().is_some() {
            keyboard.give_up(&mut inputs);
        }
        inputs
    }

    fn key_of(bytes: &[u8]) -> Vec<Input> {
        keys_of(&[bytes])
    }

    #[test]
    fn keys_are_told_apart() {
        let key = |k| vec![Input::Key(k)];
        assert_eq!(key_of(b" "), key(Key::Char(' ')));
        assert_eq!(key_of(b"\x1b[A"), key(Key::Up));
        assert_eq!(key_of(b"\x1bOA"), key(Key::Up));
        assert_eq!(key_of(b"\x1b[1;2C"), key(Key::Right));
        assert_eq!(key_of(b"\x1b[1;5C"), vec![]);
        assert_eq!(key_of(b"\x1bOP"), key(Key::Function(1)));
        assert_eq!(key_of(b"\x1b[5~"), key(Key::PageUp));
        assert_eq!(key_of(b"\x03"), key(Key::Ctrl('c')));
        assert_eq!(key_of(b"\x1a"), key(Key::Ctrl('z')));
        assert_eq!(key_of(b"\r"), key(Key::Enter));
        assert_eq!(key_of(b"\x08"), key(Key::Backspace));
        assert_eq!(key_of(b"\x7f"), key(Key::Backspace));
        assert_eq!(key_of("\u{e4}".as_bytes()), key(Key::Char('\u{e4}')));
    }

    #[test]
    fn an_arrow_cut_in_two_is_still_an_arrow() {
        let up = vec![Input::Key(Key::Up)];
        assert_eq!(keys_of(&[b"\x1b", b"[A"]), up);
        assert_eq!(keys_of(&[b"\x1b[", b"A"]), up);
    }

    #[test]
    fn answers_are_told_from_keys_and_from_pastes() {
        assert_eq!(
            key_of(b"a\x1b[0nb"),
            vec![
                Input::Key(Key::Char('a')),
                Input::Answer,
                Input::Key(Key::Char('b'))
            ]
        );
        let pasted = b"\x1b[200~\x1b[0n\x1b[201~";
        assert_eq!(key_of(pasted), vec![Input::Paste("\x1b[0n".into())]);
    }

    #[test]
    fn a_lone_escape_is_a_key_once_nothing_follows() {
        let mut keyboard = Keyboard::default();
        let mut inputs = Vec::new();
        let now = Instant::now();
        keyboard.feed(b"\x1b", now, &mut inputs);
        assert_eq!(inputs, vec![]);
        assert_eq!(keyboard.deadline(), Some(now + ESCAPE_PATIENCE));
        keyboard.give_up(&mut inputs);
        assert_eq!(inputs, vec![Input::Key(Key::Escape)]);
        assert_eq!(keyboard.deadline(), None);
    }

    /// While frames follow each other the answer to one comes upon the heels of a key: the key used to
    /// be lost, and the answer with it.
    #[test]
    fn an_escape_before_an_answer_is_a_key() {
        let both = vec![Input::Key(Key::Escape), Input::Answer];
        assert_eq!(key_of(b"\x1b\x1b[0n"), both);
        assert_eq!(keys_of(&[b"\x1b", b"\x1b[0n"]), both);
        assert_eq!(keys_of(&[b"\x1b", b"\x1b[0", b"n"]), both);
    }

    /// The parser alone waits for ever after these: Alt-], Alt-P, Alt-[ and noise.
    #[test]
    fn an_unfinished_sequence_does_not_make_deaf() {
        let unfinished: [&[u8]; 6] = [
            b"\x1b]",
            b"\x1bP",
            b"\x1b[",
            b"\x1bO",
            b"\xc3",
            b"\x1b[200~half a paste",
        ];
        for bytes in unfinished {
            let mut keyboard = Keyboard::default();
            let mut inputs = Vec::new();
            keyboard.feed(bytes, Instant::now(), &mut inputs);
            assert!(keyboard.deadline().is_some(), "{bytes:?}");
            keyboard.give_up(&mut inputs);
            keyboard.feed(b"\x03", Instant::now(), &mut inputs);
            assert_eq!(inputs, vec![Input::Key(Key::Ctrl('c'))], "{bytes:?}");
        }
    }

    #[test]
    fn a_paste_is_never_keys_however_long() {
        assert_eq!(
            key_of(b"\x1b[200~q\x03\r\x1b[201~"),
            vec![Input::Paste("q\x03\r".into())]
        );
        let mut long = b"\x1b[200~".to_vec();
        long.resize(3 * LONGEST_PASTE, b'q');
        long.extend_from_slice(b"\x1b[201~ ");
        let inputs = key_of(&long);
        assert!(matches!(&inputs[..], [Input::Paste(_), Input::Key(_)]));
    }

    proptest! {
        /// Whatever comes, in whatever pieces, Ctrl-C is heard afterwards and memory stays bounded.
        #[test]
        fn noise_neither_panics_nor_deafens(
            pieces in prop::collection::vec(noise(), 0..12),
        ) {
            let mut keyboard = Keyboard::default();
            let mut inputs = Vec::new();
            for piece in &pieces {
                keyboard.feed(piece, Instant::now(), &mut inputs);
                prop_assert!(keyboard.held.len() <= LONGEST_PASTE);
            }
            keyboard.give_up(&mut inputs);
            inputs.clear();
            keyboard.feed(b"\x03", Instant::now(), &mut inputs);
            prop_assert_eq!(inputs, vec![Input::Key(Key::Ctrl('c'))]);
        }
    }

    /// Random bytes, and pieces of sequences, which random bytes seldom make.
    fn noise() -> impl Strategy<Value = Vec<u8>> {
        let alphabet =
            prop::sample::select(b"\x1b\x1b[[]OP<>?;:0123456789ABMRcmnuyq~ \x07\\".to_vec());
        prop_oneof![
            prop::collection::vec(any::<u8>(), 0..60),
            prop::collection::vec(alphabet, 0..30),
            Just(b"\x1b[200~".to_vec()),
            Just(b"\x1b[99999999999999999999;1R".to_vec()),
        ]
    }
}
