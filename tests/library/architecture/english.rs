//! Doc comments are in plain English: few of them have the words that this project once wrote in place of standard terms,
//! and functions begin with a verb.

use super::sources;
use std::fs;

/// Words with a plain replacement: show, set, request, again, or else, next to, zero.
const ODD: [&str; 14] = [
    "tell",
    "tells",
    "told",
    "telling",
    "stand",
    "stands",
    "stood",
    "standing",
    "wish",
    "wished",
    "anew",
    "otherwise",
    "beside",
    "nought",
];

/// Beginnings of comments that do not stand alone.
const DEPENDENT_STARTS: [&str; 6] = [
    "What ",
    "Whatever ",
    "Whoever ",
    "The same",
    "Of a ",
    "Of the ",
];

/// Returns the doc comments of a source, and for each whether a function follows.
fn doc_comments(source: &str) -> Vec<(String, bool)> {
    let mut found = Vec::new();
    let mut text = String::new();
    for line in source.lines().map(str::trim) {
        let doc = line.strip_prefix("///").or(line.strip_prefix("//!"));
        match doc.filter(|doc| !doc.starts_with('/')) {
            Some(doc) => text = text + doc + "\n",
            None if line.starts_with("#[") || text.is_empty() => {}
            None => {
                let names: Vec<&str> = line.split(' ').take(4).collect();
                found.push((
                    std::mem::take(&mut text).trim().to_owned(),
                    names.contains(&"fn"),
                ));
            }
        }
    }
    found
}

fn is_odd(text: &str) -> bool {
    let mut words = text.split(|c: char| !c.is_alphanumeric());
    words.any(|word| ODD.contains(&word.to_lowercase().as_str()))
        || DEPENDENT_STARTS.iter().any(|start| text.starts_with(start))
}

/// Returns `true` if a text begins with a verb in the third person, as in "Returns the angle".
fn has_verb_first(text: &str) -> bool {
    let first = text.split(' ').next().unwrap_or_default();
    first.ends_with('s') && first.starts_with(char::is_uppercase)
}

#[test]
fn doc_comments_are_in_plain_english() {
    let [mut all, mut odd, mut functions, mut verbs] = [0; 4];
    let mut shown = Vec::new();
    for (file, inner) in sources() {
        if inner.to_string_lossy().contains("test") {
            continue;
        }
        for (text, is_function) in doc_comments(&fs::read_to_string(&file).unwrap()) {
            all += 1;
            functions += usize::from(is_function);
            verbs += usize::from(is_function && has_verb_first(&text));
            if is_odd(&text) {
                odd += 1;
                shown.push(format!(
                    "{}: {}",
                    inner.display(),
                    text.lines().next().unwrap_or("")
                ));
            }
        }
    }
    assert!(
        all > 10_000 && functions > 3_000,
        "{all} comments, {functions} of functions"
    );
    // In percent.
    assert!(100 * odd <= all, "{odd} of {all}:\n{}", shown.join("\n"));
    assert!(
        100 * verbs >= 90 * functions,
        "{verbs} of {functions} begin with a verb"
    );
}

#[test]
fn odd_comments_are_recognized() {
    let source = "/// What is told.\n#[must_use]\npub(crate) const fn a() {}\n//! Returns 1.\nmod b;\n// no doc\n";
    let found = doc_comments(source);
    assert_eq!(
        found,
        [
            ("What is told.".to_owned(), true),
            ("Returns 1.".to_owned(), false)
        ]
    );
    assert!(
        is_odd("What is told.") && is_odd("An angle. It stands still.") && !is_odd("Returns 1.")
    );
    assert!(
        has_verb_first("Returns 1.") && !has_verb_first("An angle.") && !has_verb_first("is 1")
    );
}
