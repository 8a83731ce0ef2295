//! Reads the text of PMKS: one joint per line.

use super::ImportError;
use super::address::has_scheme;
use super::drawing::{Drawing, DrawnLaw, number};
use super::joints::{JointKind, Joints, ReadJoint};
use crate::wording::words;

/// The keys of settings, which are lines `key=value`.
const SETTINGS: [&str; 7] = ["mech", "name", "set", "s", "d", "e", "f"];

/// Number of flags of a joint.
const FLAGS: usize = 4;
/// Maximum number of numbers of a joint: x, y and an angle.
const MAX_NUMBERS: usize = 3;

/// A line of the file.
enum PmksLine {
    Joint(Box<LineJoint>),
    /// A joint whose numbers can be read in several ways.
    Ambiguous(String),
    Setting,
    Empty,
    Unknown,
}

/// A joint, and what was decided on the way.
struct LineJoint {
    joint: ReadJoint,
    remarks: Vec<String>,
}

/// Returns `true` if a text has more joints than lines of other kinds.
pub(super) fn is_pmks(text: &str) -> bool {
    let (mut joints, mut others) = (0_usize, 0_usize);
    for line in lines(text) {
        match read(line, "") {
            PmksLine::Joint(_) | PmksLine::Ambiguous(_) => joints += 1,
            PmksLine::Setting | PmksLine::Empty => {}
            PmksLine::Unknown => others += 1,
        }
    }
    joints > others
}

/// Returns the lines of a file, or those of an address, which separates them by `|`.
fn lines(text: &str) -> impl Iterator<Item = &str> {
    text.split(['\n', '|']).map(str::trim)
}

/// Reads a file, or the value of `mech` in an address with these parameters.
pub(super) fn read_pmks(
    text: &str,
    parameters: Option<&[(String, String)]>,
) -> Result<Drawing, ImportError> {
    let mut joints = Joints::default();
    for (key, value) in parameters.into_iter().flatten() {
        let place = format!("`{key}`");
        match SETTINGS.iter().any(|known| key.eq_ignore_ascii_case(known)) {
            true => setting(&mut joints, key, value, &place),
            false => {
                let text = words().import_unknown_parameter();
                joints.drawing.remark(&place, text);
            }
        }
    }
    let place_of = |number: usize| match parameters {
        Some(_) => words().import_joint_row(number, "mech"),
        None => words().import_line(number),
    };
    let mut count = 0;
    let mut first_fault = None;
    for (number, line) in lines(text).enumerate() {
        let place = place_of(number + 1);
        let remarks = &mut joints.drawing.remarks;
        match read(line, &place) {
            PmksLine::Joint(read) => {
                count += 1;
                for remark in &read.remarks {
                    remarks.add(&place, remark);
                }
                joints.add(&read.joint);
            }
            PmksLine::Ambiguous(numbers) => {
                let fault = words().import_ambiguous_numbers(&numbers);
                remarks.add(&place, &fault);
                first_fault.get_or_insert(format!("{place}: {fault}"));
            }
            PmksLine::Setting => {
                if let Some((key, value)) = line.split_once('=') {
                    setting(&mut joints, key.trim(), value.trim(), &place);
                }
            }
            PmksLine::Empty => {}
            PmksLine::Unknown => remarks.add(&place, words().import_not_a_joint()),
        }
    }
    if count == 0 {
        let fault = first_fault.as_deref();
        return Err(ImportError::new(
            fault.unwrap_or(words().import_no_joints()),
        ));
    }
    let drawing = joints.finish(&DrawnLaw::Unknown, true);
    drawing.ok_or_else(ImportError::too_large)
}

/// Reads a setting. Settings of the program's own simulation need no remark.
fn setting(joints: &mut Joints, key: &str, value: &str, place: &str) {
    if key.eq_ignore_ascii_case("name") {
        joints.drawing.title = Some(value.to_owned());
    } else if ["s", "d"].iter().any(|own| key.eq_ignore_ascii_case(own)) && !value.is_empty() {
        let text = words().import_setting_left_out(key, value);
        joints.drawing.remark(place, &text);
    }
}

/// Reads a line.
fn read(line: &str, place_of_line: &str) -> PmksLine {
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
    if has_scheme(line) {
        return PmksLine::Setting;
    }
    joint(line, place_of_line)
}

/// A word of a line.
struct LineWord<'l> {
    text: &'l str,
    /// The offset in the line.
    start: usize,
    /// `true` if a blank or a semicolon separates the word from the one before.
    is_after_blank: bool,
}

/// Splits a line at commas, semicolons and blanks.
fn words_of(line: &str) -> Vec<LineWord<'_>> {
    let is_gap = |c: char| c == ',' || c == ';' || c.is_whitespace();
    let mut found = Vec::new();
    let (mut start, mut is_after_blank) = (0, false);
    for part in line.split_inclusive(is_gap) {
        let text = part.trim_end_matches(is_gap);
        if !text.is_empty() {
            found.push(LineWord {
                text,
                start,
                is_after_blank,
            });
            is_after_blank = false;
        }
        is_after_blank |= part.ends_with(|c: char| c != ',' && is_gap(c));
        start += part.len();
    }
    found
}

/// Reads a joint: links, type, x, y, and possibly an angle and flags.
fn joint(line: &str, place_of_line: &str) -> PmksLine {
    let split = words_of(line);
    let words_of_line: Vec<&str> = split.iter().map(|word| word.text).collect();
    // Links may be called R or P: the type is followed by a number.
    let found = words_of_line
        .iter()
        .enumerate()
        .skip(1)
        .find_map(|(i, word)| {
            number(words_of_line.get(i + 1)?)?;
            Some((i, JointKind::parse(word)?))
        });
    let Some((place, kind)) = found else {
        return PmksLine::Unknown;
    };
    let (links, rest) = words_of_line.split_at(place);
    let numbers: Vec<f64> = rest[1..].iter().map_while(|word| number(word)).collect();
    // Decimals with a comma give too many numbers, or numbers with unlike separators.
    let gaps = split[place + 2..].iter().take(numbers.len() - 1);
    let mut has_blanks = gaps.map(|word| word.is_after_blank);
    let first = has_blanks.next();
    if numbers.len() > MAX_NUMBERS || has_blanks.any(|has| Some(has) != first) {
        let typed = line.get(split[place + 1].start..).unwrap_or_default();
        let is_of_number = |c: char| {
            c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | ',' | ';') || c.is_whitespace()
        };
        let end = typed.find(|c| !is_of_number(c)).unwrap_or(typed.len());
        let typed = typed[..end].trim_end_matches([',', ';', ' ', '\t']);
        return PmksLine::Ambiguous(typed.to_owned());
    }
    let &[x, y, ref angle @ ..] = numbers.as_slice() else {
        return PmksLine::Unknown;
    };
    let angle = angle.first().copied().unwrap_or(0.0);
    let mut remarks = Vec::new();
    if kind == JointKind::Pin && angle != 0.0 {
        remarks.push(words().import_angle_of_pin(x, y, angle));
    }
    let flags = &rest[1 + numbers.len()..];
    let has_flags = are_flags(flags);
    if !has_flags {
        remarks.push(words().import_unknown_flags(&flags.join(" ")));
    }
    PmksLine::Joint(Box::new(LineJoint {
        joint: ReadJoint {
            name: None,
            links: links.iter().map(|&name| name.to_owned()).collect(),
            kind,
            at: [x, y],
            angle,
            is_input: has_flags && is_input(flags),
            place: place_of_line.to_owned(),
        },
        remarks,
    }))
}

/// Returns `true` for flags: one word of four characters, or up to four words.
fn are_flags(flags: &[&str]) -> bool {
    let is_flag = |c: char| matches!(c, 't' | 'f' | 'T' | 'F' | '+' | '-');
    match flags {
        [word] if word.len() == FLAGS => word.chars().all(is_flag),
        words => {
            let is_word = |word: &&str| {
                let mut chars = word.chars();
                let is_one = chars.next().is_some_and(is_flag) && chars.next().is_none();
                is_one
                    || ["true", "false"]
                        .iter()
                        .any(|it| word.eq_ignore_ascii_case(it))
            };
            words.len() <= FLAGS && words.iter().all(is_word)
        }
    }
}

/// Returns `true` if the fourth flag is set: flags are one word of four characters, or four words.
fn is_input(flags: &[&str]) -> bool {
    let flag = match flags {
        [word] => word.chars().nth(3),
        words => words.get(3).and_then(|word| word.chars().next()),
    };
    matches!(flag, Some('t' | 'T' | '+'))
}
