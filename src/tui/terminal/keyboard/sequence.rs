//! Maps control sequences to keys and mouse events.

use super::TerminalColour;
use crate::tui::commands::key::Key;
use crate::tui::commands::mouse::{Mouse, MouseEventKind};
use ratatui::layout::Position;

/// Bits of the modifiers, after subtracting one: Shift, Ctrl, and all others, which terminals do
/// not send for a plain key.
const SHIFT: u32 = 1;
const CONTROL: u32 = 4;
const OTHERS: u32 = 2 | 8 | 16 | 32;
/// The event type of a key release.
const RELEASE: u32 = 3;

/// Button codes of a mouse report, and the bit that marks motion. Codes with Shift are left to the
/// terminal, which uses them for selection.
const FIRST_BUTTON: u32 = 0;
const MOVED: u32 = 32;
const WHEEL_UP: u32 = 64;
const WHEEL_DOWN: u32 = 65;

/// Parses a mouse report (mode 1006): `button;column;row`, counted from 1, with the final byte `M`,
/// or `m` for a release.
pub(super) fn mouse(parameters: &[u8], last: u8) -> Option<Mouse> {
    let parameters = std::str::from_utf8(parameters).ok()?;
    let mut numbers = parameters.split(';').map(|part| part.parse::<u32>().ok());
    let mut number = || numbers.next().flatten();
    let (button, column, row) = (number()?, number()?, number()?);
    let action = match (button, last) {
        (FIRST_BUTTON, b'm') => MouseEventKind::Release,
        (FIRST_BUTTON, _) => MouseEventKind::Press,
        (MOVED, b'M') => MouseEventKind::Drag,
        (WHEEL_UP, b'M') => MouseEventKind::WheelUp,
        (WHEEL_DOWN, b'M') => MouseEventKind::WheelDown,
        _ => return None,
    };
    let cell = |number: u32| u16::try_from(number.checked_sub(1)?).ok();
    let at = Position::new(cell(column)?, cell(row)?);
    Some(Mouse { kind: action, at })
}

/// Returns the key of a control character.
pub(super) fn control(byte: u8) -> Option<Key> {
    Some(match byte {
        0x00 => Key::Ctrl(' '),
        // Some terminals send 0x08 for Backspace.
        0x08 | 0x7f => Key::Backspace,
        b'\t' => Key::Tab,
        b'\r' => Key::Enter,
        0x01..=0x1a => Key::Ctrl(char::from(byte - 1 + b'a')),
        0x1c..=0x1f => Key::Ctrl(char::from(byte - 0x1c + b'4')),
        _ => return None,
    })
}

/// Returns the key of an SS3 sequence: `ESC O` and this byte.
pub(super) fn ss3(last: u8) -> Option<Key> {
    match last {
        b'M' => Some(Key::Enter),
        _ => moving(last).or_else(|| function(last)),
    }
}

/// Returns the key of a control sequence, from its parameters and final letter.
pub(super) fn csi(parameters: &[u8], last: u8) -> Option<Key> {
    let parameters = std::str::from_utf8(parameters).ok()?;
    let mut parts = parameters.split(';');
    let mut number = || parts.next().map_or(Some((0, 0)), numbers);
    let ((first, _), (modifiers, event), (third, _)) = (number()?, number()?, number()?);
    let modifiers = modifiers.saturating_sub(1);
    if event == RELEASE || modifiers & OTHERS != 0 {
        return None;
    }
    let key = match last {
        b'u' => of_code(first, modifiers)?,
        b'~' if first == 27 => of_code(third, modifiers)?,
        b'~' => numbered(first)?,
        b'Z' => Key::BackTab,
        // With other parameters it is a cursor position report.
        b'R' if first != 1 => return None,
        _ => moving(last).or_else(|| function(last))?,
    };
    let has_control = modifiers & CONTROL != 0;
    let is_plain = matches!(key, Key::Char(_) | Key::Ctrl(_) | Key::Backspace) || !has_control;
    is_plain.then_some(key)
}

/// Parses a parameter and its subparameter after the colon; `None` if either is not a number.
fn numbers(part: &str) -> Option<(u32, u32)> {
    let mut parts = part.split(':');
    let mut number = || match parts.next() {
        None | Some("") => Some(0),
        Some(digits) => digits.parse().ok(),
    };
    Some((number()?, number()?))
}

fn moving(last: u8) -> Option<Key> {
    Some(match last {
        b'A' => Key::Up,
        b'B' => Key::Down,
        b'C' => Key::Right,
        b'D' => Key::Left,
        b'H' => Key::Home,
        b'F' => Key::End,
        _ => return None,
    })
}

fn function(last: u8) -> Option<Key> {
    matches!(last, b'P'..=b'S').then(|| Key::Function(last - b'P' + 1))
}

/// Returns the key for a VT220 key number; the numbers have gaps between groups.
fn numbered(number: u32) -> Option<Key> {
    let function = match number {
        1 | 7 => return Some(Key::Home),
        4 | 8 => return Some(Key::End),
        5 => return Some(Key::PageUp),
        6 => return Some(Key::PageDown),
        11..=15 => number - 10,
        17..=21 => number - 11,
        23..=26 => number - 12,
        28 | 29 => number - 13,
        31..=34 => number - 14,
        _ => return None,
    };
    u8::try_from(function).ok().map(Key::Function)
}

/// Returns the key for a character code, as sent by newer terminals.
fn of_code(code: u32, modifiers: u32) -> Option<Key> {
    let key = match char::from_u32(code)? {
        '\u{1b}' => Key::Escape,
        '\r' => Key::Enter,
        '\t' if modifiers & SHIFT != 0 => Key::BackTab,
        '\t' => Key::Tab,
        '\u{8}' | '\u{7f}' => Key::Backspace,
        // Codes of keys without a character.
        '\u{e000}'..='\u{f8ff}' => return None,
        c if c.is_control() => return None,
        'h' if modifiers & CONTROL != 0 => Key::Backspace,
        c if modifiers & CONTROL != 0 => Key::Ctrl(c.to_ascii_lowercase()),
        c => Key::Char(c),
    };
    Some(key)
}
/// Parses the answer about the text or the background, `10;` or `11;rgb:2b2b/3636/0000`: one to four
/// hexadecimal digits of red, green and blue. Returns `None` for another string.
pub(super) fn colour(report: &[u8]) -> Option<TerminalColour> {
    let (number, report) = std::str::from_utf8(report).ok()?.split_once(';')?;
    let kind = match number {
        "10" => TerminalColour::Text,
        "11" => TerminalColour::Ground,
        _ => return None,
    };
    let colour = report.strip_prefix("rgb")?;
    let colour = colour.strip_prefix("a:").or(colour.strip_prefix(":"))?;
    let mut parts = colour.split('/').map(|digits| {
        let maximum = (1..=4)
            .contains(&digits.len())
            .then(|| (1_u32 << (4 * digits.len())) - 1)?;
        let value = u32::from_str_radix(digits, 16).ok()?;
        u8::try_from(value * 255 / maximum).ok()
    });
    let mut part = || parts.next().flatten();
    Some(kind([part()?, part()?, part()?]))
}
