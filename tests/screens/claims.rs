//! Assertions about screens: the words and numbers they contain, and differences between two
//! screens.
//! Snapshots cover the layout of a whole screen; these helpers check what a test is about.

use std::collections::BTreeSet;

/// Collapses runs of white space to single blanks.
pub(crate) fn collapse_blanks(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Asserts that the screen contains these groups of words, each within one line with any spacing,
/// and none above its predecessor.
#[track_caller]
pub(crate) fn assert_shown(screen: &str, texts: &[&str]) {
    let lines: Vec<String> = screen.lines().map(collapse_blanks).collect();
    let mut from = 0;
    for wanted in texts {
        let below = lines[from..]
            .iter()
            .position(|line| format!(" {line} ").contains(&format!(" {wanted} ")));
        let Some(below) = below else {
            panic!("no {wanted:?} from line {from} on:\n{screen}");
        };
        from += below;
    }
}

/// Replaces line-drawing characters by their ASCII counterparts.
pub(crate) fn spelled(screen: &str) -> String {
    let plain = [
        ("─", "-"),
        ("│", "|"),
        ("·", "."),
        ("▒", "#"),
        ("┌", "+"),
        ("┐", "+"),
        ("└", "+"),
        ("┘", "+"),
        ("┬", "+"),
        ("┤", "+"),
        ("├", "+"),
        ("┼", "+"),
        ("═", "="),
        ("◄", "<"),
        ("►", ">"),
        ("▲", "^"),
        ("▼", "v"),
    ];
    let replace = |text: String, (fine, plain): &(&str, &str)| text.replace(fine, plain);
    plain.iter().fold(screen.to_owned(), replace)
}

/// Returns the numbers of a screen, as written.
pub(crate) fn figures(screen: &str) -> BTreeSet<String> {
    // The zero line of a chart may touch a number.
    let plain = |word: &str| word.trim_matches(['*', '.']).to_owned();
    // A cursor's bracket and the lines of a chart may touch the next number.
    let distance = |c: char| c.is_whitespace() || "[]·┆".contains(c);
    let words = screen.split(distance).map(plain);
    words.filter(|word| word.parse::<f64>().is_ok()).collect()
}

/// Splits a screen into cells, padding short rows with blanks.
pub(crate) fn cells(screen: &str) -> Vec<Vec<char>> {
    let width = screen.lines().map(|line| line.chars().count()).max();
    let width = width.unwrap_or(0);
    let row = |line: &str| {
        line.chars()
            .chain(std::iter::repeat(' '))
            .take(width)
            .collect()
    };
    screen.lines().map(row).collect()
}

/// Returns the rows and columns of these characters.
pub(crate) fn places(cells: &[Vec<char>], of: &[char]) -> Vec<(usize, usize)> {
    let rows = cells.iter().enumerate();
    let all =
        rows.flat_map(|(row, cells)| cells.iter().enumerate().map(move |(col, c)| (row, col, c)));
    let found = all.filter(|(_, _, c)| of.contains(c));
    found.map(|(row, col, _)| (row, col)).collect()
}

/// Returns the differences of two screens of one size: row, column, and the characters before and
/// after.
pub(crate) fn differences(before: &str, after: &str) -> Vec<(usize, usize, char, char)> {
    let (before, after) = (cells(before), cells(after));
    assert_eq!(before.len(), after.len());
    let at = |row: &[char], col: usize| row.get(col).copied().unwrap_or(' ');
    let mut found = Vec::new();
    for row in 0..before.len() {
        for col in 0..before[row].len().max(after[row].len()) {
            let (was, is) = (at(&before[row], col), at(&after[row], col));
            if was != is {
                found.push((row, col, was, is));
            }
        }
    }
    found
}

/// Returns the drawing of a motion view: the part left of the bar before the tables, or above the
/// tables, without the line of the cycle below it. The title row is blank.
pub(crate) fn drawing(body: &str) -> String {
    let all = cells(body);
    let width = all.first().map_or(0, Vec::len);
    let bar = (20..width).find(|col| all.iter().all(|row| BARS.contains(&row[*col])));
    let left = |row: &[char]| row[..bar.unwrap_or(width)].iter().collect::<String>() + "\n";
    // Matches a table, or a list of assemblies with their coordinates.
    let below = |line: &String| {
        let starts = [
            " vector ",
            " difference: ",
            "---",
            "───",
            " |--",
            " |o-",
            " │─",
            " │o",
            "- plots",
            "─ plots",
        ];
        starts.iter().any(|start| line.starts_with(start)) || line.contains('(')
    };
    let untitled = |(row, line): (usize, String)| match row {
        0 if [" step ", " compared"]
            .iter()
            .any(|text| line.contains(text)) =>
        {
            " ".repeat(line.len() - 1) + "\n"
        }
        _ => line,
    };
    let lines = all.iter().map(|row| left(row)).enumerate();
    lines
        .map(untitled)
        .take_while(|line| !below(line))
        .collect()
}

/// Characters of the bar between two panes, and of its junctions with titles.
const BARS: [char; 7] = ['|', '│', '┬', '┤', '├', '┼', '+'];

/// Asserts that a ghost only adds dots to blank cells, or Braille dots to dotted cells. Names may
/// give way to dots, and the window may have moved. Returns the number of changed cells.
#[track_caller]
pub(crate) fn assert_only_a_ghost_is_added(alone: &str, with: &str) -> usize {
    let (before, after) = (cells(alone), cells(with));
    let [joints, moved] = [&before, &after].map(|cells| places(cells, &['o', '@']));
    let (from, to) = (joints[0], moved[0]);
    let mut changed = 0;
    for (row, cells) in before.iter().enumerate() {
        for (col, &was) in cells.iter().enumerate() {
            let there = (row + to.0)
                .checked_sub(from.0)
                .zip((col + to.1).checked_sub(from.1));
            let is = there
                .and_then(|(row, col)| after.get(row)?.get(col))
                .copied()
                .unwrap_or(' ');
            let is_name = was.is_ascii_uppercase() || is.is_ascii_uppercase();
            let more = match (dots(was).unwrap_or(0), dots(is)) {
                (old, Some(new)) => (was == ' ' || old > 0) && new & old == old,
                (_, None) => was == ' ' && ['.', '·'].contains(&is),
            };
            assert!(
                was == is || is_name || more,
                "{row}, {col}: {was:?}, {is:?}\n{alone}{with}"
            );
            changed += usize::from(was != is);
        }
    }
    changed
}

/// Asserts that Braille dots lie in or next to each of these cells, where characters draw the same
/// curve. Dots of a ghost lie farther apart than cells.
#[track_caller]
pub(crate) fn assert_dotted(through: &[(usize, usize)], dotted: &str) {
    let drawn = cells(dotted);
    let nearby = |a: usize, b: usize| a.abs_diff(b) <= 1;
    for &(row, col) in through {
        let rows = drawn
            .iter()
            .enumerate()
            .filter(|(near, _)| nearby(*near, row));
        let mut near = rows.flat_map(|(_, cells)| {
            let cells = cells.iter().enumerate();
            cells.filter(|(near, _)| nearby(*near, col))
        });
        assert!(
            near.any(|(_, c)| dots(*c).is_some()),
            "{row}, {col}:\n{dotted}"
        );
    }
}

/// Returns the left or the right part of a screen with a bar between two panes.
pub(crate) fn pane(screen: &str, right: bool) -> String {
    let part = |line: &str| {
        const ENDS: [char; 2] = ['|', '│'];
        // The line of the cycle has bars of its own, at both ends.
        let is_cycle = line
            .strip_prefix(' ')
            .is_some_and(|line| line.starts_with(ENDS));
        let parts = match is_cycle {
            true => line.rsplit_once(ENDS),
            false => line.split_once(ENDS),
        };
        let (left, other) = parts.unwrap_or((line, ""));
        if right { other } else { left }.trim_end().to_owned() + "\n"
    };
    screen.lines().map(part).collect()
}

/// Returns the Braille dots of a character as bits.
fn dots(c: char) -> Option<u32> {
    u32::from(c).checked_sub(0x2800).filter(|dots| *dots < 256)
}
