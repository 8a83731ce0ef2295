use super::catalogue::{Message, messages, translations};
use std::collections::BTreeMap;

/// Returns the messages of a language, and for a message that needs grammar the body of its function.
fn sentences(texts: &str, grammar: &str) -> BTreeMap<String, (Vec<String>, String)> {
    let sentence = |Message {
                        name,
                        arguments,
                        text,
                    }: Message| {
        let text = text.unwrap_or_else(|| {
            let (_, function) = grammar.split_once(&format!(") fn {name}(")).unwrap();
            let (function, _) = function.split_once("\n}\n").unwrap();
            function.split_once(" {\n").unwrap().1.to_owned()
        });
        let given = arguments.into_iter().flatten().map(|(name, _)| name);
        (name, (given.collect(), text))
    };
    messages(texts).unwrap().into_iter().map(sentence).collect()
}

fn english() -> BTreeMap<String, (Vec<String>, String)> {
    sentences(include_str!("english.txt"), include_str!("english.rs"))
}

fn turkish() -> BTreeMap<String, (Vec<String>, String)> {
    sentences(
        include_str!("turkish.txt"),
        include_str!("turkish/grammar.rs"),
    )
}

/// Returns the first message of a text.
fn first(text: &str) -> Result<Message, String> {
    messages(text).map(|all| all.into_iter().next().unwrap())
}

#[test]
fn message_has_name_arguments_and_text() {
    let message = |name: &str, arguments: Option<&[(&str, &str)]>, text: Option<&str>| Message {
        name: name.to_owned(),
        arguments: arguments.map(|all| {
            let argument = |&(name, kind): &(&str, &str)| (name.to_owned(), kind.to_owned());
            all.iter().map(argument).collect()
        }),
        text: text.map(str::to_owned),
    };
    let cases = [
        (
            "# a comment\n\npaused = paused",
            message("paused", None, Some("paused")),
        ),
        (
            "ends_at(at, unit) = ends at {at} {unit}",
            message(
                "ends_at",
                Some(&[("at", "&str"), ("unit", "&str")]),
                Some("ends at {at} {unit}"),
            ),
        ),
        (
            "of(ends: [&str; 2], all: &[(u64, &str)])",
            message(
                "of",
                Some(&[("ends", "[&str; 2]"), ("all", "&[(u64, &str)]")]),
                None,
            ),
        ),
        (
            "long = one\n    two\\n\n      three",
            message("long", None, Some("one two\n  three")),
        ),
        ("blank = \"name: \"", message("blank", None, Some("name: "))),
        (
            "formula = a = b \\\\n",
            message("formula", None, Some("a = b \\n")),
        ),
    ];
    for (text, expected) in cases {
        assert_eq!(first(text), Ok(expected), "{text}");
    }
}

#[test]
fn wrong_catalogue_is_rejected_with_its_line() {
    for (text, fault) in [
        ("a = b\nNo name = c", "line 2: not a name: No name = c"),
        (
            "a = b\na = c",
            "line 2: a second message of this name: a = c",
        ),
        ("a(b = c", "line 1: no `)`: a(b = c"),
        ("a\n    more", "line 1: no `=` before the text: a"),
    ] {
        assert_eq!(first(text), Err(fault.to_owned()));
    }
}

#[test]
fn translations_are_pairs_in_named_tables() {
    let pair = |a: &str, b: &str| (a.to_owned(), b.to_owned());
    let tables = translations("# note\n\n## A\n\none\n    bir\n\"two: \"\n    \"iki: \"\n## B\n");
    let expected = vec![pair("one", "bir"), pair("two: ", "iki: ")];
    assert_eq!(tables, Ok(vec![("A", expected), ("B", Vec::new())]));
    for wrong in ["## A\none\ntwo", "one\n    bir", "## A\none"] {
        assert_eq!(
            translations(wrong),
            Err("no translation in a table: one".to_owned())
        );
    }
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
    let (english, turkish) = (english(), turkish());
    assert!(english.len() > 1000, "{} are not all", english.len());
    assert!(english.keys().eq(turkish.keys()));
    let mut missing = Vec::new();
    for (name, (given, text)) in &english {
        let (_, other) = &turkish[name];
        let given = given.iter().filter(|it| !GRAMMAR.contains(&it.as_str()));
        missing.extend(
            given
                .filter(|it| names(text, it) && !names(other, it))
                .map(|it| format!("{name}: {it}")),
        );
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

/// Typed text is equal in every language: options, variables, sections and keys.
#[test]
fn options_variables_sections_and_keys_are_not_translated() {
    let (english, turkish) = (english(), turkish());
    let mut missing = Vec::new();
    for (name, (_, message)) in &english {
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
        let there = typed(&turkish[name].1);
        let gone = typed(message).into_iter().filter(|it| !there.contains(it));
        missing.extend(gone.map(|it| format!("{name}: {it}")));
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

/// Messages may use letters of ASCII and Turkish, and symbols of formulas, which pages spell out
/// where needed.
#[test]
fn turkish_messages_use_only_supported_characters() {
    for (name, (_, text)) in turkish() {
        let strange = text
            .chars()
            .find(|&c| !c.is_ascii() && !"âçğıîöşüûÂÇĞİÎÖŞÜÛ→θμνωβγ".contains(c));
        assert_eq!(strange, None, "{name}");
    }
}
