//! Checks that reading any file gives a scene or messages: never a panic, and never a raw control
//! character on the terminal.

use krank::scene::{Scene, is_harmful, presets};
use proptest::prelude::*;
use proptest::sample::{Index, select};

/// Words of the format, values that are difficult to read, and pieces of TOML.
const PIECES: &[&str] = &[
    "[ground]\n",
    "[driver]\n",
    "[links]\n",
    "[slides]\n",
    "[start]\n",
    "[vectors]\n",
    "[[loads]]\n",
    "[links.r2]\n",
    "A",
    "B",
    "C",
    "D",
    "r2",
    "r3",
    "\"B'\"",
    "\"r3.com\"",
    "\"A\"",
    "\"ground\"",
    "driver",
    "com",
    "state",
    " = ",
    "= ",
    "{ ",
    " }",
    "[",
    "]",
    "[0, 0]",
    "[1e400, nan]",
    "[-0.0, 1]",
    "link = \"r2\"\n",
    "slide = \"r4\"\n",
    "angle = 60\n",
    "position = -1e300\n",
    "speed = \"15 rad/s\"\n",
    "speed = 15\n",
    "from = \"A\"",
    "to = \"B\"",
    "length = 100",
    "length = 5e-324",
    "length = -1",
    "points = { P = [1, 2] }",
    "mass = 1",
    "inertia = inf",
    "point = \"C\"",
    "on = \"ground\"",
    "on = \"r3\"",
    "through = \"A\"",
    "through = [0, 0]",
    "turn = 0",
    "unit = \"mm\"\n",
    "[[springs]]\n",
    "[motor]\n",
    "frame = \"r3\"\n",
    "over = [[0, 1], [90, -2]]\n",
    "press = [[12, 0], [0, 350e3]]\n",
    "end = \"least\"\n",
    "stiffness = -1\n",
    "peak = 60\n",
    "force = [0, -500]\n",
    "torque = nan\n",
    ", ",
    "\n",
    "\r\n",
    "\t",
    "# ",
    "\"\"\"",
    "'",
    "\"",
    "\\u202e",
    "\u{202e}",
    "\u{1b}",
    "\u{e9}",
    "\u{feff}",
    ".",
    "2024-01-01",
    "true",
    "0x7f",
    "9999999999999999999999",
];

/// Reads a scene and renders its errors in every style.
fn survive(bytes: &[u8], origin: &str) {
    let Err(faults) = Scene::read(bytes, origin) else {
        return;
    };
    assert!(!faults.items.is_empty(), "refused without a reason");
    for (ascii, colour) in [(true, false), (false, false), (true, true), (false, true)] {
        let shown = faults.render(ascii, colour);
        let escape = |c: char| c == '\n' || (colour && c == '\u{1b}');
        assert!(
            !shown.contains(|c| is_harmful(c) && !escape(c)),
            "{shown:?}"
        );
        assert!(!ascii || shown.is_ascii(), "{shown:?}");
    }
    for item in &faults.items {
        if let Some(label) = &item.primary {
            assert!(faults.text.get(label.span.clone()).is_some(), "{label:?}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..200), origin in ".*") {
        survive(&bytes, &origin);
    }

    #[test]
    fn random_text_never_panics(text in "\\PC*|[\\x00-\\x7f]*") {
        survive(text.as_bytes(), "x");
    }

    #[test]
    fn random_words_of_the_format_never_panic(words in prop::collection::vec(select(PIECES), 0..60)) {
        survive(words.concat().as_bytes(), "x.toml");
    }

    /// A valid scene with some parts removed, duplicated or replaced: the most common mistakes.
    #[test]
    fn damaged_presets_never_panic(
        preset in any::<Index>(),
        wounds in prop::collection::vec((any::<Index>(), 0_usize..12, select(PIECES)), 1..4),
    ) {
        let mut text = preset.get(presets::all()).text.to_owned();
        for (at, length, piece) in wounds {
            let boundary = |mut at: usize| {
                while !text.is_char_boundary(at) {
                    at -= 1;
                }
                at
            };
            let start = boundary(at.index(text.len() + 1));
            let end = boundary((start + length).min(text.len()));
            text.replace_range(start..end, piece);
        }
        survive(text.as_bytes(), "wounded.toml");
    }
}
