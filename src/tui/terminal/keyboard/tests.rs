//! Tests the decoder with keys, pastes, answers and random bytes, in chunks of any length.

use super::*;
use proptest::prelude::*;

fn keys_of(pieces: &[&[u8]]) -> Vec<TerminalInput> {
    let mut keyboard = Keyboard::default();
    let mut inputs = Vec::new();
    let now = Instant::now();
    for piece in pieces {
        keyboard.feed(piece, now, &mut inputs);
    }
    if keyboard.deadline().is_some() {
        keyboard.give_up(&mut inputs);
    }
    inputs
}

fn key_of(bytes: &[u8]) -> Vec<TerminalInput> {
    keys_of(&[bytes])
}

fn key(key: Key) -> Vec<TerminalInput> {
    vec![TerminalInput::Key(key)]
}

#[test]
fn answers_about_the_background_are_decoded() {
    let ground = |bytes: &[u8]| match keys_of(&[bytes])[..] {
        [TerminalInput::Colour(TerminalColour::Ground(colour))] => Some(colour),
        [] => None,
        ref other => panic!("{other:?}"),
    };
    assert_eq!(
        ground(b"\x1b]11;rgb:0000/2b2b/3636\x1b\\"),
        Some([0, 0x2b, 0x36])
    );
    assert_eq!(ground(b"\x1b]11;rgb:f/f/f\x07"), Some([255; 3]));
    assert_eq!(
        ground(b"\x1b]11;rgba:ffff/0000/8080/ffff\x07"),
        Some([255, 0, 128])
    );
    for other in [
        &b"\x1b]12;rgb:ffff/ffff/ffff\x07"[..],
        b"\x1b]rgb:ffff/ffff/ffff\x07",
        b"\x1b]11;rgb:ffff/ffff\x07",
        b"\x1b]11;rgb:fffff/0/0\x07",
        b"\x1b]11;?\x07",
        b"\x1bP11;rgb:0/0/0\x1b\\",
        b"\x1b]11;rgb:ffff/ffff/ff",
    ] {
        assert_eq!(ground(other), None, "{other:?}");
    }
    let text = keys_of(&[b"\x1b]10;rgb:8383/9494/9696\x1b\\"]);
    let colour = TerminalColour::Text([0x83, 0x94, 0x96]);
    assert_eq!(text, [TerminalInput::Colour(colour)]);
    // Keys around the answer arrive.
    let inputs = keys_of(&[b"a\x1b]11;rgb:0/0", b"/0\x1b\\b"]);
    let expected = [
        TerminalInput::Key(Key::Char('a')),
        TerminalInput::Colour(TerminalColour::Ground([0; 3])),
        TerminalInput::Key(Key::Char('b')),
    ];
    assert_eq!(inputs, expected);
}

#[test]
fn mouse_reports_decode_to_first_button_and_wheel() {
    let text = |bytes: &[u8]| match keys_of(&[bytes])[..] {
        [TerminalInput::Mouse(mouse)] => Some((mouse.kind, mouse.at.x, mouse.at.y)),
        [] => None,
        ref other => panic!("{other:?}"),
    };
    use crate::tui::commands::mouse::MouseEventKind as D;
    assert_eq!(text(b"\x1b[<0;1;1M"), Some((D::Press, 0, 0)));
    assert_eq!(text(b"\x1b[<32;80;24M"), Some((D::Drag, 79, 23)));
    assert_eq!(text(b"\x1b[<0;300;200m"), Some((D::Release, 299, 199)));
    assert_eq!(text(b"\x1b[<64;5;6M"), Some((D::WheelUp, 4, 5)));
    assert_eq!(text(b"\x1b[<65;5;6M"), Some((D::WheelDown, 4, 5)));
    // Other buttons, motion without a button and malformed reports produce no keys, and no mouse
    // events except after a superfluous separator.
    for bytes in [
        "<2;5;6M",
        "<35;5;6M",
        "<0;0;1M",
        "<0;5M",
        "<0;99999;1M",
        "<;;M",
        "<0;1;1;M",
    ] {
        let text = text(format!("\x1b[{bytes}").as_bytes());
        assert!(text.is_none() || bytes == "<0;1;1;M", "{bytes}: {text:?}");
    }
    // In two chunks.
    let pieces = keys_of(&[b"\x1b[<0;1", b"2;3Mq"]);
    assert_eq!(pieces.len(), 2, "{pieces:?}");
    assert_eq!(pieces[1], TerminalInput::Key(Key::Char('q')));
}

#[test]
fn key_sequences_decode_to_keys() {
    for (bytes, expected) in [
        (&b" "[..], Key::Char(' ')),
        (b"\x1b[A", Key::Up),
        (b"\x1bOA", Key::Up),
        (b"\x1b[1;2C", Key::Right),
        (b"\x1b[H", Key::Home),
        (b"\x1b[1~", Key::Home),
        (b"\x1bOF", Key::End),
        (b"\x1b[Z", Key::BackTab),
        (b"\x1bOP", Key::Function(1)),
        (b"\x1b[1;2R", Key::Function(3)),
        (b"\x1b[[A", Key::Function(1)),
        (b"\x1b[[E", Key::Function(5)),
        (b"\x1b[15~", Key::Function(5)),
        (b"\x1b[17~", Key::Function(6)),
        (b"\x1b[24~", Key::Function(12)),
        (b"\x1b[34~", Key::Function(20)),
        (b"\x1b[5~", Key::PageUp),
        (b"\x1b[99;5u", Key::Ctrl('c')),
        (b"\x1b[27;5;99~", Key::Ctrl('c')),
        (b"\x1b[97;1:1u", Key::Char('a')),
        (b"\x03", Key::Ctrl('c')),
        (b"\x1a", Key::Ctrl('z')),
        (b"\r", Key::Enter),
        (b"\t", Key::Tab),
        (b"\x08", Key::Backspace),
        (b"\x7f", Key::Backspace),
        ("\u{e4}".as_bytes(), Key::Char('\u{e4}')),
        ("\u{4e2d}".as_bytes(), Key::Char('\u{4e2d}')),
        ("\u{1f600}".as_bytes(), Key::Char('\u{1f600}')),
    ] {
        assert_eq!(key_of(bytes), key(expected), "{bytes:?}");
        // In any two chunks.
        for cut in 1..bytes.len() {
            let (front, back) = bytes.split_at(cut);
            assert_eq!(keys_of(&[front, back]), key(expected), "{bytes:?} at {cut}");
        }
    }
    for nothing in [
        &b"\x1b[1;5C"[..],
        b"\x1b[97;1:3u",
        b"\x1b[12;40R",
        b"\x1b[3~",
        b"\x1b[?62;1c",
        b"\x1b[<2;1;1M",
        b"\x1b[I",
        b"\x1bq",
        "\x1b\u{e4}".as_bytes(),
        b"\x1b[201~",
    ] {
        assert_eq!(key_of(nothing), vec![], "{nothing:?}");
    }
    assert_eq!(key_of(b"\x1b[M !q "), key(Key::Char(' ')));
}

#[test]
fn answers_are_recognized_between_keys_and_in_pastes() {
    assert_eq!(
        key_of(b"a\x1b[0nb"),
        vec![
            TerminalInput::Key(Key::Char('a')),
            TerminalInput::Answer,
            TerminalInput::Key(Key::Char('b'))
        ]
    );
    assert_eq!(
        key_of(b"\x1b[200~a\x1b[0nb\x1b[201~"),
        vec![TerminalInput::Answer, TerminalInput::Paste("ab".into())]
    );
    // The 8-bit form of the answer.
    assert_eq!(key_of(b"\x9b0n"), vec![TerminalInput::Answer]);
}

/// Regression: these sequences swallowed the ESC of the following answer, which stopped the screen
/// for 4 s.
#[test]
fn answer_is_recognized_after_unfinished_sequence() {
    let unfinished: [&[u8]; 12] = [
        b"\xe9",
        b"\xf0\x9f",
        b"\x1b[",
        b"\x1b[1;",
        b"\x1b[[",
        b"\x1b[M",
        b"\x1bO",
        b"\x1b]",
        b"\x1b]11;rgb:ffff/ffff/ffff",
        b"\x1bP1$r",
        b"\x1b_G",
        b"\x9b",
    ];
    for bytes in unfinished {
        let inputs = key_of(&[bytes, b"\x1b[0n"].concat());
        assert_eq!(inputs, vec![TerminalInput::Answer], "{bytes:?}");
    }
    let both = vec![TerminalInput::Key(Key::Escape), TerminalInput::Answer];
    assert_eq!(key_of(b"\x1b\x1b[0n"), both);
    assert_eq!(keys_of(&[b"\x1b", b"\x1b[0", b"n"]), both);
}

#[test]
fn invalid_utf8_does_not_swallow_next_key() {
    assert_eq!(key_of(b"\xe9q"), key(Key::Char('q')));
    assert_eq!(key_of(b"\xe9\xe9\r"), key(Key::Enter));
    assert_eq!(key_of(b"\x80\xff\xc0q"), key(Key::Char('q')));
    assert_eq!(key_of(b"\xed\xa0\x80q"), key(Key::Char('q')), "a surrogate");
}

/// Regression: replies of more than 256 bytes were read as keys, and their `q` quit the program.
#[test]
fn control_strings_of_any_length_produce_no_keys() {
    for length in [0, 1, 255, 256, 257, 1 << 20] {
        let text = "q".repeat(length);
        for (starts, ends) in [
            ("\x1b]52;c;", "\x07"),
            ("\x1b]52;c;", "\x1b\\"),
            ("\x1bP1+r", "\x1b\\"),
            ("\x1b_G", "\x1b\\"),
            ("\x1b^", "\x1b\\"),
            ("\x1bX", "\x18"),
        ] {
            let bytes = format!("{starts}{text}{ends}g");
            assert_eq!(key_of(bytes.as_bytes()), key(Key::Char('g')), "{starts:?}");
        }
        let digits = "1;".repeat(length);
        let bytes = format!("\x1b[{digits}mg");
        assert_eq!(key_of(bytes.as_bytes()), key(Key::Char('g')));
    }
}

#[test]
fn lone_escape_becomes_key_after_timeout() {
    let mut keyboard = Keyboard::default();
    let mut inputs = Vec::new();
    let now = Instant::now();
    keyboard.feed(b"\x1b", now, &mut inputs);
    assert_eq!(inputs, vec![]);
    assert_eq!(keyboard.deadline(), Some(now + ESCAPE_TIMEOUT));
    keyboard.give_up(&mut inputs);
    assert_eq!(inputs, key(Key::Escape));
    assert_eq!(keyboard.deadline(), None);
}

#[test]
fn pastes_of_any_length_produce_no_keys() {
    let pasted = b"\x1b[200~q\x03\r\x1b[A\x1b]\x1b[201~";
    let text = "q\x03\r\x1b[A\x1b]".to_owned();
    assert_eq!(key_of(pasted), vec![TerminalInput::Paste(text.clone())]);
    let pieces: Vec<&[u8]> = pasted.chunks(1).collect();
    assert_eq!(keys_of(&pieces), vec![TerminalInput::Paste(text)]);
    let mut long = b"\x1b[200~".to_vec();
    long.resize(3 * MAX_PASTE_LEN, b'q');
    long.extend_from_slice(b"\x1b[201~ ");
    let inputs = key_of(&long);
    assert!(
        matches!(&inputs[..], [TerminalInput::Paste(text), TerminalInput::Key(_)] if text.len() == MAX_PASTE_LEN)
    );
}

/// Covers a Ctrl-C pressed by the user, and any Ctrl-C within a paste that does not end.
#[test]
fn ctrl_c_ends_unterminated_paste() {
    let leave = key(Key::Ctrl('c'));
    let started = Instant::now();
    let mut inputs = Vec::new();
    let mut keyboard = Keyboard::default();
    keyboard.feed(b"\x1b[200~text", started, &mut inputs);
    keyboard.feed(b"\x03", started + MIN_CTRL_C_PAUSE, &mut inputs);
    assert_eq!(inputs, leave);
    // A paste that continues endlessly.
    inputs.clear();
    keyboard.feed(b"\x1b[200~", started, &mut inputs);
    let mut now = started;
    while now < started + MAX_PASTE_TIME {
        now += MIN_CTRL_C_PAUSE / 5;
        keyboard.feed(b"text", now, &mut inputs);
    }
    keyboard.feed(b"text\x03text", now, &mut inputs);
    assert_eq!(inputs[..1], leave[..]);
    let mut endless = b"\x1b[200~".to_vec();
    endless.resize(2 * MAX_PASTE_LEN, b'q');
    endless.push(3);
    assert_eq!(key_of(&endless), leave);
}

/// After a network stall within a paste, the rest of it produces no keys. Keys work again once the
/// user types.
#[test]
fn rest_of_stalled_paste_produces_no_keys() {
    let mut keyboard = Keyboard::default();
    let mut inputs = Vec::new();
    let now = Instant::now();
    keyboard.feed(b"\x1b[200~one q", now, &mut inputs);
    keyboard.give_up(&mut inputs);
    assert_eq!(inputs, [TerminalInput::Paste("one q".into())]);
    assert_eq!(keyboard.deadline(), None);
    inputs.clear();
    let later = now + 2 * PASTE_TIMEOUT;
    keyboard.feed(b" w q w q w q", later, &mut inputs);
    keyboard.feed(b" R\x1b[201~x", later + MIN_CTRL_C_PAUSE, &mut inputs);
    let rest = TerminalInput::Paste(" w q w q w q R".into());
    assert_eq!(inputs, [rest, TerminalInput::Key(Key::Char('x'))]);
    // An unterminated paste does not block later keys.
    inputs.clear();
    keyboard.feed(b"\x1b[200~two", later, &mut inputs);
    keyboard.give_up(&mut inputs);
    keyboard.feed(b"\x1b[A", later + 2 * PASTE_TIMEOUT, &mut inputs);
    keyboard.feed(
        b"q",
        later + 2 * PASTE_TIMEOUT + MIN_CTRL_C_PAUSE,
        &mut inputs,
    );
    let keys = [Key::Up, Key::Char('q')].map(TerminalInput::Key);
    assert_eq!(inputs[1..], keys);
}

/// Regression: keys vanished in an unterminated paste for as long as one arrived every second.
#[test]
fn keys_work_in_unterminated_paste() {
    for pause in [MAX_PASTE_PAUSE, PASTE_TIMEOUT / 3] {
        let mut keyboard = Keyboard::default();
        let mut inputs = Vec::new();
        let mut now = Instant::now();
        keyboard.feed(b"\x1b[200~text", now, &mut inputs);
        for (bytes, expected) in [(&b"g"[..], Key::Char('g')), (b"\x1b[A", Key::Up)] {
            inputs.clear();
            now += pause;
            keyboard.feed(bytes, now, &mut inputs);
            if keyboard.deadline().is_some() {
                assert_eq!(keyboard.deadline(), Some(now + MAX_PASTE_PAUSE));
                keyboard.give_up(&mut inputs);
            }
            assert_eq!(inputs.last(), Some(&TerminalInput::Key(expected)));
        }
        assert_eq!(keyboard.deadline(), None);
    }
}

/// A repeating key is not delayed by the pause before the next one.
#[test]
fn next_key_confirms_pending_key() {
    let mut keyboard = Keyboard::default();
    let mut inputs = Vec::new();
    let mut now = Instant::now();
    keyboard.feed(b"\x1b[200~", now, &mut inputs);
    for _ in 0..3 {
        now += MAX_PASTE_PAUSE;
        keyboard.feed(b".", now, &mut inputs);
    }
    let dot = TerminalInput::Key(Key::Char('.'));
    assert_eq!(inputs, [dot.clone(), dot.clone(), dot]);
}

/// A paste over a slow line may arrive byte by byte, and stall anywhere.
#[test]
fn paste_stalled_at_any_byte_stays_one_paste() {
    let pasted = b"\x1b[200~qw\r\x1b[Aq\x1b[201~";
    for stall in 6..pasted.len() {
        let mut keyboard = Keyboard::default();
        let mut inputs = Vec::new();
        let mut now = Instant::now();
        for (k, byte) in pasted.iter().enumerate() {
            now += if k == stall {
                PASTE_TIMEOUT / 2
            } else {
                MAX_PASTE_PAUSE / 25
            };
            keyboard.feed(&[*byte], now, &mut inputs);
        }
        let text = "qw\r\x1b[Aq".to_owned();
        assert_eq!(inputs, [TerminalInput::Paste(text)], "{stall}");
    }
}

/// Answers of the terminal arrive at any time, including just before and after a key.
#[test]
fn answers_do_not_hide_keys_in_unterminated_paste() {
    let mut keyboard = Keyboard::default();
    let mut inputs = Vec::new();
    let now = Instant::now();
    keyboard.feed(b"\x1b[200~", now, &mut inputs);
    keyboard.feed(ANSWER, now + MAX_PASTE_PAUSE, &mut inputs);
    keyboard.feed(b"q", now + MAX_PASTE_PAUSE, &mut inputs);
    keyboard.feed(ANSWER, now + MAX_PASTE_PAUSE, &mut inputs);
    assert_eq!(inputs, [TerminalInput::Answer, TerminalInput::Answer]);
    keyboard.give_up(&mut inputs);
    assert_eq!(inputs[2..], key(Key::Char('q')));
}

proptest! {
    /// For any input in any chunks, a following Ctrl-C is recognized and memory stays bounded.
    #[test]
    fn random_bytes_never_block_ctrl_c(
        pieces in prop::collection::vec(noise(), 0..12),
    ) {
        let mut keyboard = Keyboard::default();
        let mut inputs = Vec::new();
        let now = Instant::now();
        for piece in &pieces {
            keyboard.feed(piece, now, &mut inputs);
            prop_assert!(keyboard.held.len() <= MAX_PASTE_LEN + PASTE_ENDS.len());
        }
        let is_pasting = keyboard.state == PendingInput::Paste;
        inputs.clear();
        // Within a paste after a moment, in any other state at once.
        let later = if is_pasting { now + MIN_CTRL_C_PAUSE } else { now };
        keyboard.feed(b"\x03", later, &mut inputs);
        prop_assert_eq!(inputs, key(Key::Ctrl('c')));
        prop_assert_eq!(keyboard.deadline(), None);
    }

    /// The decoded input does not depend on the chunks.
    #[test]
    fn decoding_does_not_depend_on_chunks(bytes in noise(), cut in 0_usize..60) {
        let (front, back) = bytes.split_at(cut.min(bytes.len()));
        prop_assert_eq!(keys_of(&[front, back]), key_of(&bytes));
    }
}

/// Generates random bytes mixed with parts of sequences, which random bytes rarely form.
fn noise() -> impl Strategy<Value = Vec<u8>> {
    let alphabet = prop::sample::select(b"\x1b\x1b[[]OP<>?;:0123456789ABMRcmnuyq~ \x07\\".to_vec());
    prop_oneof![
        prop::collection::vec(any::<u8>(), 0..60),
        prop::collection::vec(alphabet, 0..30),
        Just(b"\x1b[200~".to_vec()),
        Just(b"\x1b[99999999999999999999;1R".to_vec()),
    ]
}
