//! Checks that all user-visible sentences are in the catalogue: in the modules of [`CATALOGUE_MODULES`], no text
//! outside `wording` has two words.

use super::{files, is_test, module_path, source_folders, sources, tokens, without_tests};
use std::fs;

/// Modules whose sentences are in the catalogue.
const CATALOGUE_MODULES: [&[&str]; 16] = [
    &["capability"],
    &["cli"],
    &["document"],
    &["drawing", "legend"],
    &["explain"],
    &["expression"],
    &["files"],
    &["import"],
    &["manual"],
    &["nearest"],
    &["page"],
    &["quantity"],
    &["report"],
    &["scene"],
    &["study"],
    &["tui"],
];

/// Files in those modules with texts outside the catalogue.
const OTHERS: [&[&str]; 12] = [
    // Commands for a shell.
    &["cli", "help", "completions"],
    &["cli", "help", "pager"],
    // Markup and style sheets.
    &["manual", "website"],
    &["page", "html"],
    &["page", "latex"],
    &["page", "style"],
    &["page", "svg"],
    &["page", "tikz"],
    // Library errors have their own text.
    &["quantity", "catalogue"],
    // Units of two words.
    &["scene", "numbers", "measure"],
    // Numbers are named by the keys of the file.
    &["scene", "values"],
    // Tests of rendered messages.
    &["scene", "refusals"],
];

/// Functions and macros whose texts no user reads: they address readers of the code, or are
/// compared with other texts.
const DEVELOPER_FUNCTIONS: [&str; 10] = [
    "assert",
    "assert_eq",
    "assert_ne",
    "debug_assert",
    "debug_assert_eq",
    "debug_assert_ne",
    "expect",
    "panic",
    "starts_with",
    "unreachable",
];

/// Returns the user-visible texts of a file that read as sentences.
fn sentences(tokens: &[String]) -> Vec<&str> {
    let at = |i: usize| tokens.get(i).map_or("", String::as_str);
    let mut found = Vec::new();
    let mut i = 0;
    while i < tokens.len() {
        i = match at(i) {
            "#" if at(i + 1) == "[" => behind(tokens, i + 1),
            "#" if at(i + 1) == "!" && at(i + 2) == "[" => behind(tokens, i + 2),
            name if DEVELOPER_FUNCTIONS.contains(&name) && at(i + 1) == "(" => {
                behind(tokens, i + 1)
            }
            name if DEVELOPER_FUNCTIONS.contains(&name) && at(i + 1) == "!" => {
                behind(tokens, i + 2)
            }
            // The text of an error type belongs to the library.
            "Display" if at(i + 1) == "for" => behind(tokens, i + 3),
            text => {
                found.extend(text.strip_prefix('"').filter(|text| is_sentence(text)));
                i + 1
            }
        };
    }
    found
}

/// Returns the index after the next bracketed group.
fn behind(tokens: &[String], from: usize) -> usize {
    let mut depth = 0;
    for (i, token) in tokens.iter().enumerate().skip(from) {
        match token.as_str() {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => depth -= 1,
            _ => {}
        }
        if depth == 0 && matches!(token.as_str(), ")" | "]" | "}") {
            return i + 1;
        }
    }
    tokens.len()
}

/// Returns `true` if two words of at least two letters are separated by a blank (formulas have
/// shorter names), or if a word is between two placeholders.
fn is_sentence(text: &str) -> bool {
    let mut depth = 0;
    let marked: String = text
        .chars()
        .filter_map(|c| {
            depth += i32::from(c == '{');
            let kept = (depth == 0).then_some(c).or((c == '{').then_some(FILLED));
            depth -= i32::from(c == '}');
            kept
        })
        .collect();
    let is_word = |text: String| text.chars().count() >= 2 && text.chars().all(char::is_alphabetic);
    let starts = |part: &str| is_word(part.chars().take(2).collect());
    let ends = |part: &str| is_word(part.chars().rev().take(2).collect());
    let parts: Vec<&str> = marked.split(' ').collect();
    let is_between = |parts: &[&str]| {
        parts[0].ends_with(FILLED) && is_word(parts[1].into()) && parts[2].starts_with(FILLED)
    };
    parts.windows(2).any(|two| ends(two[0]) && starts(two[1])) || parts.windows(3).any(is_between)
}

/// Represents a placeholder.
const FILLED: char = '\u{1}';

/// Returns the index of the first entry that contains a module.
fn layer_of(path: &[String], rooms: &[&[&str]]) -> Option<usize> {
    let holds =
        |space: &&[&str]| path.len() >= space.len() && path.iter().zip(*space).all(|(a, b)| a == b);
    rooms.iter().position(holds)
}

#[test]
fn user_visible_sentences_are_in_the_catalogue() {
    let mut faults = Vec::new();
    let mut seen = [false; CATALOGUE_MODULES.len()];
    for (file, inner) in sources() {
        let path = module_path(&inner);
        let Some(space) =
            layer_of(&path, &CATALOGUE_MODULES).filter(|_| layer_of(&path, &OTHERS).is_none())
        else {
            continue;
        };
        seen[space] = true;
        if is_test(&path) {
            continue;
        }
        let tokens = without_tests(&tokens(&fs::read_to_string(&file).unwrap()));
        let sentences = sentences(&tokens);
        faults.extend(
            sentences
                .iter()
                .map(|s| format!("{}: {s}", path.join("::"))),
        );
    }
    assert_eq!(seen, [true; CATALOGUE_MODULES.len()], "a room has gone");
    assert!(faults.is_empty(), "\n{}\n", faults.join("\n"));
}

/// Returns `true` if a doc comment would become help text: of an option, a command or a value.
fn is_help_text(lines: &[&str]) -> bool {
    let mut after = lines[1..]
        .iter()
        .skip_while(|line| line.starts_with("#[cfg"));
    let texts = ["#[arg", "#[command(about", "#[command(after", "#[value"];
    let next = after.next().copied().unwrap_or_default();
    let is_value = next.ends_with(',') && next.starts_with(|c: char| c.is_ascii_uppercase());
    lines[0].starts_with("///") && (is_value || texts.iter().any(|of| next.starts_with(of)))
}

#[test]
fn command_line_help_is_not_in_doc_comments() {
    let mut found = Vec::new();
    files(&source_folders()[0].join("cli"), &mut found);
    let texts = found
        .into_iter()
        .map(|file| (fs::read_to_string(&file).unwrap(), file));
    let found: Vec<_> = texts.filter(|(text, _)| text.contains("#[arg(")).collect();
    assert!(found.len() > 15, "{}", found.len());
    for (text, file) in found {
        let lines: Vec<&str> = text.lines().map(str::trim).collect();
        let output = (0..lines.len()).find(|&at| is_help_text(&lines[at..]));
        assert_eq!(output.map(|at| lines[at]), None, "{}", file.display());
    }
    for bad in [
        "/// Whose\n#[cfg(unix)]\n#[arg(long)]\nwhose: u8,",
        "/// None\nNone,",
    ] {
        assert!(is_help_text(&bad.lines().collect::<Vec<_>>()), "{bad}");
    }
}

#[test]
fn checker_finds_only_user_visible_sentences() {
    let found = |text: &str| sentences(&without_tests(&tokens(text))).len();
    for bad in [
        "fn f() { say(\"not written\"); }",
        "fn f() { say(format!(\"{name} is gone\")); }",
        "fn f() { say(format!(\"{this} and {other}\")); }",
        "const TOLD: &str = r#\"two words\"#;",
        "#[doc = \"no matter\"] fn f() -> &'static str { \"is said\" }",
    ] {
        assert_eq!(found(bad), 1, "{bad}");
    }
    for good in [
        "fn f() { say(words().not_written()); } // two words",
        "fn f() { let line = format!(\"{key} {value}\"); put(\"--unit\", \"|  |\"); }",
        "fn f() { let formula = format!(\"m a{axis} = F v, {x} m\"); }",
        "#[error(\"two words\")] struct Fault;",
        "fn f() { debug_assert!(x > 0, \"is positive\"); x.expect(\"is there\"); }",
        "fn f() { is_known = message.starts_with(\"string values must be quoted\"); }",
        "impl fmt::Display for Fault { fn f() { w.write_str(\"two words\") } }",
        "#[cfg(test)] mod tests { fn f() { say(\"two words\"); } }",
    ] {
        assert_eq!(found(good), 0, "{good}");
    }
}
