//! Computes the difference of two texts, line by line.

/// Maximum number of line pairs to compare. A longer difference lists all old lines, then all new
/// ones.
const MAX_PAIRS: usize = 1 << 22;

/// Returns the differing lines with their numbers: old lines after `-`, new lines after `+`.
pub(crate) fn difference(old: &str, new: &str) -> Vec<String> {
    let (old, new): (Vec<&str>, Vec<&str>) = (old.lines().collect(), new.lines().collect());
    let same = |pair: &(&&str, &&str)| pair.0 == pair.1;
    let front = old.iter().zip(&new).take_while(same).count();
    let (old_rest, new_rest) = (&old[front..], &new[front..]);
    let back = old_rest.iter().rev().zip(new_rest.iter().rev());
    let back = back.take_while(same).count();
    let old = &old_rest[..old_rest.len() - back];
    let new = &new_rest[..new_rest.len() - back];
    let mut texts = Vec::new();
    let (mut i, mut j) = (0, 0);
    let kept = common(old, new);
    for (at_old, at_new) in kept.into_iter().chain([(old.len(), new.len())]) {
        let gone = (i..at_old).map(|n| (n, '-', old[n]));
        let come = (j..at_new).map(|n| (n, '+', new[n]));
        let lines = gone.chain(come);
        texts.extend(lines.map(|(n, sign, line)| format!("{:>4} {sign} {line}", front + n + 1)));
        (i, j) = (at_old + 1, at_new + 1);
    }
    texts
}

/// Returns the longest common subsequence of lines, as pairs of indices; empty if the texts are too
/// long.
fn common(old: &[&str], new: &[&str]) -> Vec<(usize, usize)> {
    let width = new.len() + 1;
    if old.len().saturating_mul(width) > MAX_PAIRS {
        return Vec::new();
    }
    // `count[i * width + j]` is the number of common lines of the rests from `(i, j)`.
    let mut count = vec![0_u32; (old.len() + 1) * width];
    for i in (0..old.len()).rev() {
        for j in (0..new.len()).rev() {
            count[i * width + j] = match old[i] == new[j] {
                true => count[(i + 1) * width + j + 1] + 1,
                false => count[(i + 1) * width + j].max(count[i * width + j + 1]),
            };
        }
    }
    let (mut i, mut j, mut pairs) = (0, 0, Vec::new());
    while i < old.len() && j < new.len() {
        if old[i] == new[j] {
            pairs.push((i, j));
            (i, j) = (i + 1, j + 1);
        } else if count[(i + 1) * width + j] >= count[i * width + j + 1] {
            i += 1;
        } else {
            j += 1;
        }
    }
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn difference_lists_changed_lines_with_numbers() {
        let lines = difference("a\nb\nc\nd\n", "a\nB\nc\nx\nd\n");
        assert_eq!(lines, ["   2 - b", "   2 + B", "   4 + x"]);
        assert!(difference("a\nb", "a\nb").is_empty());
        assert_eq!(difference("", "a"), ["   1 + a"]);
        assert_eq!(difference("a\nb", ""), ["   1 - a", "   2 - b"]);
        let long = |c: &str| c.repeat(3000);
        assert_eq!(difference(&long("a\n"), &long("b\n")).len(), 6000);
    }
}
