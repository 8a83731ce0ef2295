use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A message in one language: the names of its arguments, and its text.
struct Sentence {
    given: Vec<String>,
    text: String,
}

/// Parses the messages from the sources of a language, keyed by part and name.
fn sentences(language: &str) -> BTreeMap<String, Sentence> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/wording");
    let files = std::fs::read_dir(folder.join(language)).unwrap();
    let mut all = BTreeMap::new();
    for file in files.map(|file| file.unwrap().path()) {
        let part = PathBuf::from(file.file_name().unwrap());
        let source = std::fs::read_to_string(&file).unwrap();
        let Some((_, catalogue)) = source.split_once("catalogue! {") else {
            continue;
        };
        let catalogue = catalogue.split("\n}\n").next().unwrap();
        let mut lines = catalogue.lines().peekable();
        while let Some(line) = lines.next() {
            let starts = |line: &str| {
                let inner = line.strip_prefix("        ")?;
                (inner.starts_with(|c: char| c.is_ascii_lowercase()) && line.contains(" ="))
                    .then(|| inner.to_owned())
            };
            let Some(head) = starts(line) else { continue };
            let mut text = head;
            let end = match text.ends_with('{') {
                true => "\n        };",
                false => "\";",
            };
            let is_block_in_line = |text: &str| text.contains("= { ") && text.ends_with(" };");
            while !text.ends_with(end)
                && !is_block_in_line(&text)
                && let Some(more) = lines.next()
            {
                text = text + "\n" + more;
            }
            let (head, text) = text.split_once(" =").unwrap();
            let (name, given) = head.split_once('(').unwrap_or((head, ")"));
            let given = given.trim_end_matches(')').split(", ");
            let given = given.filter_map(|one| one.split_once(": "));
            let sentence = Sentence {
                given: given.map(|(name, _)| name.to_owned()).collect(),
                text: text.to_owned(),
            };
            all.insert(format!("{}: {name}", part.display()), sentence);
        }
    }
    all
}

/// Returns `true` if a text contains a word as a whole.
fn names(text: &str, word: &str) -> bool {
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
        .any(|part| part == word)
}

/// An argument that only one language shows would be missing for readers of the other.
#[test]
fn turkish_messages_match_english_keys_and_arguments() {
    // Arguments that only English grammar needs.
    const GRAMMAR: [&str; 1] = ["is_one"];
    let (english, turkish) = (sentences("english"), sentences("turkish"));
    assert!(english.len() > 1000, "{} are not all", english.len());
    let keys = |all: &BTreeMap<String, Sentence>| all.keys().cloned().collect::<Vec<_>>();
    assert_eq!(keys(&english), keys(&turkish));
    let mut missing = Vec::new();
    for (name, text) in &english {
        let other = &turkish[name];
        assert_eq!(text.given, other.given, "{name}");
        let given = text
            .given
            .iter()
            .filter(|it| !GRAMMAR.contains(&it.as_str()));
        missing.extend(
            given
                .filter(|it| names(&text.text, it) && !names(&other.text, it))
                .map(|it| format!("{name}: {it}")),
        );
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

/// Typed text is equal in every language: options, variables, sections and keys.
#[test]
fn options_variables_sections_and_keys_are_not_translated() {
    let (english, turkish) = (sentences("english"), sentences("turkish"));
    let mut missing = Vec::new();
    for (name, message) in &english {
        let typed = |text: &str| -> Vec<String> {
            let parts = text.split([' ', '\n', '`', '"', ';', ',', ')', '(', ':', '\\']);
            let is_typed = |part: &&str| {
                let part = part.trim_end_matches('.');
                part.starts_with("--") && part.len() > 2
                    || part.starts_with('$')
                    || part.starts_with('[') && part.ends_with(']') && part.len() > 2
                    || part.starts_with("Ctrl-")
            };
            parts.filter(is_typed).map(str::to_owned).collect()
        };
        let there = typed(&turkish[name].text);
        let gone = typed(&message.text)
            .into_iter()
            .filter(|it| !there.contains(it));
        missing.extend(gone.map(|it| format!("{name}: {it}")));
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

/// Messages may use letters of ASCII and Turkish, and symbols of formulas, which pages spell out
/// where needed.
#[test]
fn turkish_messages_use_only_supported_characters() {
    for (name, sentence) in sentences("turkish") {
        let strange = sentence
            .text
            .chars()
            .find(|&c| !c.is_ascii() && !"âçğıîöşüûÂÇĞİÎÖŞÜÛ→θμνωβγ".contains(c));
        assert_eq!(strange, None, "{name}");
    }
}
