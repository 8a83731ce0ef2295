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
            let begins = |line: &str| {
                let inner = line.strip_prefix("        ")?;
                (inner.starts_with(|c: char| c.is_ascii_lowercase()) && line.contains(" ="))
                    .then(|| inner.to_owned())
            };
            let Some(head) = begins(line) else { continue };
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

/// A figure that one language says and the other drops would be missed by whoever reads the other.
#[test]
fn both_languages_say_all_that_they_are_given() {
    // What grammar asks for in English alone.
    const GRAMMAR: [&str; 1] = ["is_one"];
    let (english, turkish) = (sentences("english"), sentences("turkish"));
    assert!(english.len() > 1000, "{} are not all", english.len());
    let keys = |all: &BTreeMap<String, Sentence>| all.keys().cloned().collect::<Vec<_>>();
    assert_eq!(keys(&english), keys(&turkish));
    let mut missing = Vec::new();
    for (name, said) in &english {
        let other = &turkish[name];
        assert_eq!(said.given, other.given, "{name}");
        let given = said
            .given
            .iter()
            .filter(|it| !GRAMMAR.contains(&it.as_str()));
        missing.extend(
            given
                .filter(|it| names(&said.text, it) && !names(&other.text, it))
                .map(|it| format!("{name}: {it}")),
        );
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

/// What is typed is the same in every language: options, files, keys and values.
#[test]
fn what_is_typed_stays_as_it_is() {
    let (english, turkish) = (sentences("english"), sentences("turkish"));
    let mut missing = Vec::new();
    for (name, said) in &english {
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
        let gone = typed(&said.text)
            .into_iter()
            .filter(|it| !there.contains(it));
        missing.extend(gone.map(|it| format!("{name}: {it}")));
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

/// Sentences are read on terminals whose letters are known: those of ASCII, of Turkish, and of formulas, which pages
/// spell where they must.
#[test]
fn every_letter_can_be_spelled() {
    for (name, sentence) in sentences("turkish") {
        let strange = sentence
            .text
            .chars()
            .find(|&c| !c.is_ascii() && !"âçğıîöşüûÂÇĞİÎÖŞÜÛ→θμνωβγ".contains(c));
        assert_eq!(strange, None, "{name}");
    }
}
