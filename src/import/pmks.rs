//! Reads the text of PMKS: one joint per line.

use super::ImportError;
use super::drawing::{Drawing, DrawnLaw, number};
use super::joints::{JointKind, Joints, ReadJoint};
use crate::wording::words;

/// The keys of settings, which are lines `key=value`.
const SETTINGS: [&str; 7] = ["mech", "name", "set", "s", "d", "e", "f"];

/// A line of the file.
enum PmksLine {
    Joint(Box<ReadJoint>),
    Setting,
    Empty,
    Unknown,
}

/// Returns `true` if a text consists of joints and settings.
pub(super) fn is_pmks(text: &str) -> bool {
    let mut joints = 0;
    for line in lines(text) {
        match read(line, 0) {
            PmksLine::Joint(_) => joints += 1,
            PmksLine::Setting | PmksLine::Empty => {}
            // Text of other kinds before any joint is another format.
            PmksLine::Unknown if joints < 2 => return false,
            PmksLine::Unknown => {}
        }
        if joints == 2 {
            return true;
        }
    }
    joints > 0
}

/// Returns the lines of a file, or those of an address, which separates them by `|`.
fn lines(text: &str) -> impl Iterator<Item = &str> {
    text.split(['\n', '|']).map(str::trim)
}

/// Reads a file, or the value of `mech` in an address.
pub(super) fn read_pmks(text: &str) -> Result<Drawing, ImportError> {
    let mut joints = Joints::default();
    let mut count = 0;
    for (number, line) in lines(text).enumerate() {
        match read(line, number + 1) {
            PmksLine::Joint(joint) => {
                count += 1;
                joints.add(&joint);
            }
            PmksLine::Setting => {
                if let Some((key, value)) = line.split_once('=')
                    && key.trim().eq_ignore_ascii_case("name")
                {
                    joints.drawing.title = Some(value.trim().to_owned());
                }
            }
            PmksLine::Empty => {}
            PmksLine::Unknown => {
                let place = words().import_line(number + 1);
                joints
                    .drawing
                    .remarks
                    .add(&place, words().import_not_a_joint());
            }
        }
    }
    if count == 0 {
        return Err(ImportError::new(words().import_no_joints()));
    }
    let drawing = joints.finish(&DrawnLaw::Unknown, true);
    drawing.ok_or_else(ImportError::too_large)
}

/// Reads a line.
fn read(line: &str, number_of_line: usize) -> PmksLine {
    let mut line = line;
    if line.is_empty() || line.starts_with('#') || line.starts_with("//") {
        return PmksLine::Empty;
    }
    let is_key = |key: &str| SETTINGS.iter().any(|known| key.eq_ignore_ascii_case(known));
    if let Some((key, value)) = line.split_once('=')
        && is_key(key.trim())
    {
        match key.trim().eq_ignore_ascii_case("mech") && !value.trim().is_empty() {
            true => line = value.trim(),
            false => return PmksLine::Setting,
        }
    }
    if line.starts_with("http") && line.contains(':') {
        return PmksLine::Setting;
    }
    match joint(line, number_of_line) {
        Some(joint) => PmksLine::Joint(Box::new(joint)),
        None => PmksLine::Unknown,
    }
}

/// Reads a joint: links, type, x, y, and possibly an angle and flags.
fn joint(line: &str, number_of_line: usize) -> Option<ReadJoint> {
    let is_gap = |c: char| c == ',' || c.is_whitespace();
    let words_of_line: Vec<&str> = line.split(is_gap).filter(|word| !word.is_empty()).collect();
    // Links may be called R or P: the type is followed by a number.
    let (place, kind) = words_of_line
        .iter()
        .enumerate()
        .skip(1)
        .find_map(|(i, word)| {
            number(words_of_line.get(i + 1)?)?;
            Some((i, JointKind::parse(word)?))
        })?;
    let (links, rest) = words_of_line.split_at(place);
    let at = [number(rest.get(1)?)?, number(rest.get(2)?)?];
    let (angle, flags) = match rest.get(3).and_then(|word| number(word)) {
        Some(angle) => (angle, rest.get(4..)),
        None => (0.0, rest.get(3..)),
    };
    Some(ReadJoint {
        name: None,
        links: links.iter().map(|&name| name.to_owned()).collect(),
        kind,
        at,
        angle,
        is_input: flags.is_some_and(is_input),
        place: words().import_line(number_of_line),
    })
}

/// Returns `true` if the fourth flag is set: flags are one word of four characters, or four words.
fn is_input(flags: &[&str]) -> bool {
    let flag = match flags {
        [word] => word.chars().nth(3),
        words => words.get(3).and_then(|word| word.chars().next()),
    };
    matches!(flag, Some('t' | 'T' | '+'))
}
