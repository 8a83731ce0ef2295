//! Breaks words into lines.

/// Wraps the words of a text into lines of at most `width` characters; a longer word gets its own
/// line.
pub(crate) fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if length(line) + 1 + length(word) <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Wraps the words of a text into lines of at most `width` columns, each indented like the text.
pub(super) fn broken(text: &str, width: usize) -> Vec<String> {
    let own = text.len() - text.trim_start_matches(' ').len();
    let words: Vec<String> = text.split_whitespace().map(str::to_owned).collect();
    fill(&words, width, [own, own])
}

/// Fills lines of at most `width` columns with parts. `indents` are the numbers of blanks before
/// the first line and before the others. A part longer than a line is broken at its blanks, or
/// anywhere.
pub(super) fn fill(parts: &[String], width: usize, indents: [usize; 2]) -> Vec<String> {
    let width = width.max(MIN_WIDTH);
    let [first, other] = indents.map(|indent| indent.min(width / 2));
    let mut lines = vec![" ".repeat(first)];
    let mut is_begun = false;
    for part in parts {
        let line = lines.last().map_or(0, |line| length(line));
        if is_begun && line + 1 + length(part) > width {
            lines.push(" ".repeat(other));
            is_begun = false;
        }
        let space = width - if is_begun { 0 } else { other };
        let pieces = if length(part) > space {
            short_words(part, space)
        } else {
            vec![part.clone()]
        };
        for piece in pieces {
            let line = lines.last().map_or(0, |line| length(line));
            if is_begun && line + 1 + length(&piece) > width {
                lines.push(" ".repeat(other));
                is_begun = false;
            }
            if let Some(line) = lines.last_mut() {
                if is_begun {
                    line.push(' ');
                }
                line.push_str(&piece);
                is_begun = true;
            }
        }
    }
    lines
}

/// Minimum width; on a narrower screen, lines are cut off.
pub(super) const MIN_WIDTH: usize = 8;

/// Splits a part into words of at most `maximum` characters.
fn short_words(part: &str, maximum: usize) -> Vec<String> {
    let maximum = maximum.max(1);
    let words = part
        .split_whitespace()
        .map(|word| word.chars().collect::<Vec<char>>());
    let cut = words.flat_map(|word| {
        word.chunks(maximum)
            .map(String::from_iter)
            .collect::<Vec<_>>()
    });
    cut.collect()
}

/// Shortens a text to at most `most` characters, with two points at its end if it was longer.
#[cfg(feature = "tui")]
pub(crate) fn cut(text: &str, maximum: usize) -> String {
    if length(text) <= maximum {
        return text.to_owned();
    }
    let beginning: String = text.chars().take(maximum.saturating_sub(2)).collect();
    format!("{}..", beginning.trim_end())
}

/// Keeps at most `maximum` lines; the last one then ends with dots.
#[cfg(feature = "tui")]
pub(crate) fn truncate_lines(lines: &mut Vec<String>, maximum: usize, width: usize) {
    if lines.len() > maximum {
        lines.truncate(maximum);
        if let Some(last) = lines.last_mut() {
            *last = cut(&format!("{last} ..."), width);
        }
    }
}

/// Shortens a name to at most `most` characters, with its beginning and end: `rocker_of..ss.angle`.
/// The end distinguishes values of one element.
pub(super) fn cut_within(name: &str, maximum: usize) -> String {
    let all: Vec<char> = name.chars().collect();
    if all.len() <= maximum {
        return name.to_owned();
    }
    let kept = maximum.saturating_sub(2);
    let (first, last) = (kept.div_ceil(2), kept / 2);
    let [start, end] = [&all[..first], &all[all.len() - last..]].map(String::from_iter);
    format!("{start}..{end}")
}

/// Returns the width of a text, one column per character.
pub(super) fn length(text: &str) -> usize {
    text.chars().count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrapping_keeps_every_word() {
        let lines = wrapped("one two  three-and-more four", 8);
        assert_eq!(lines, ["one two", "three-and-more", "four"]);
        assert!(wrapped(" ", 8).is_empty());
    }

    #[test]
    fn shortened_name_keeps_its_end() {
        assert_eq!(
            cut_within("rocker_of_the_press.angle", 19),
            "rocker_of..ss.angle"
        );
        assert_eq!(cut_within("r3", 2), "r3");
        assert_eq!(cut_within("r3x", 2), "..");
    }

    #[test]
    fn long_words_are_broken_and_indentation_kept() {
        let lines = broken("  one twothreefourfive", 10);
        assert_eq!(lines, ["  one", "  twothree", "  fourfive"]);
    }
}
