//! Translates the messages of the TOML parser.

use super::translations::{FAULTS, WANTED};

/// Separators: between the error and the expected items, and between two expected items.
const EXPECTED: &str = ", expected ";
const OR: &str = ", ";

/// Translates a message. An unknown message is quoted unchanged, because a partial translation would mislead.
pub(super) fn translate_message(message: &str) -> String {
    let (fault, mut expected) = match message.split_once(EXPECTED) {
        Some((fault, expected)) => (fault, Some(expected)),
        None => (message, None),
    };
    // The parser reports an unclosed text as an error at the end of its line.
    match (fault, expected) {
        ("invalid basic string", Some("`\"`")) => return "kapanmamış metin: `\"` eksik".to_owned(),
        ("invalid literal string", Some("`'`")) => return "kapanmamış metin: `'` eksik".to_owned(),
        // Both kinds of quotes are allowed.
        ("string values must be quoted", _) => expected = None,
        (fault, _) if OF_DATES.iter().any(|of| fault.starts_with(of)) => {
            return "geçersiz tarih ya da saat".to_owned();
        }
        _ => {}
    }
    let Some(fault) = wrong(fault) else {
        return format!("TOML okuyucusunun iletisi: \"{message}\"");
    };
    match expected.map(wanted) {
        None => fault,
        Some(wanted) => format!("{fault}; beklenen: {wanted}"),
    }
}

fn wrong(fault: &str) -> Option<String> {
    if fault.starts_with("cannot extend value of type") {
        return Some("değeri olan bir anahtarın noktayla uzantısı olamaz".to_owned());
    }
    let (_, text) = FAULTS.iter().find(|(english, _)| *english == fault)?;
    Some((*text).to_owned())
}

/// Translates the expected items: symbols stay, names of text kinds are translated.
fn wanted(expected: &str) -> String {
    let items = expected.split(OR);
    let items = items.map(|item| {
        let known = WANTED.iter().find(|(english, _)| *english == item);
        known.map_or(item, |(_, text)| *text)
    });
    items.collect::<Vec<_>>().join(OR)
}

/// The starts of messages about dates, which share one translation: a scene has no dates.
const OF_DATES: [&str; 4] = [
    "invalid date",
    "invalid time",
    "invalid offset",
    "invalid local",
];

#[cfg(test)]
mod tests {
    use super::*;
    use toml::de::DeTable;

    /// Returns the parser's message for a text, and its translation.
    fn parser_message(text: &str) -> (String, String) {
        let (_, errors) = DeTable::parse_recoverable(text);
        let message = errors[0].message().to_owned();
        let turkish = translate_message(&message);
        (message, turkish)
    }

    /// There is no list of all messages of the parser. These are common mistakes of users and
    /// editors.
    #[test]
    fn common_syntax_errors_are_translated() {
        for text in [
            "a = \"open",
            "a = 'open",
            "a = [1, 2",
            "a = { b = 1",
            "[a",
            "[[a",
            "a",
            "a =",
            "a = b",
            "a 1",
            "a = 1\na = 2",
            "a = 1 2",
            "a = [1 2]",
            "a = [1,,2]",
            "a = { b = 1 c = 2 }",
            "a = 01",
            "a = 1__0",
            "a = 0xg",
            "a = 1e",
            "a = 1.",
            "a = --1",
            "a = +-1",
            "= 1",
            "a = = 1",
            "a == 1",
            "'a = 1",
            "a = 0X1",
            "a = \"\\q\"",
            "a = \"\\u12\"",
            "a = \"\\uD800\"",
            "a = 2026-99-99",
            "a = tru",
            "a = 1\rb = 2",
            "# \u{1}",
            "a = \"\u{1}\"",
            "a = '\u{1}'",
            "a = \"\"\"x",
            "a = '''x",
            "a = [1 = 2]",
            "a.b = 1\na.b.c = 2",
            "a = { b = 1 }\na.c = 2",
            "a = [1]\na.c = 2",
            "// no",
            "\u{e9} = 1",
            "a = 1 b = 2",
            "a = [b]",
            "a = -0x1",
            "\"\"\"a\"\"\" = 1",
            "a = ,",
            "]",
            "}",
            "a = }",
            "a = ]",
            "[a]]",
            "[a] b",
            "[]",
            "[a.]",
            "a. = 1",
            "a = .5",
            "a = \u{b5}",
            "a = 1,5",
            "a = 10 mm",
            "a = \"x\" y",
        ] {
            let (message, turkish) = parser_message(text);
            assert!(!turkish.contains(&message), "{text:?}: {message}");
            assert!(!turkish.contains(" expected "), "{text:?}: {turkish}");
            let wanted = message.split_once(EXPECTED).map(|(_, wanted)| wanted);
            let wanted = wanted.filter(|_| turkish.contains("beklenen"));
            for item in wanted.into_iter().flat_map(|items| items.split(OR)) {
                let known = WANTED.iter().any(|(english, _)| *english == item);
                assert!(known || item.starts_with('`'), "{text:?}: {item}");
            }
        }
        assert_eq!(
            parser_message("a = [1,,2]").1,
            "listede fazladan virgül; beklenen: değer"
        );
        assert_eq!(
            parser_message("a = [1, 2").1,
            "kapanmamış liste; beklenen: `]`"
        );
    }

    #[test]
    fn unknown_parser_message_is_quoted() {
        assert_eq!(
            translate_message("a new rule"),
            "TOML okuyucusunun iletisi: \"a new rule\""
        );
    }
}
