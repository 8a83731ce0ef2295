//! Tests which files are rejected as a whole, and the layout of messages. `tests/broken` has the
//! single faults.

use super::*;

fn message(bytes: &[u8]) -> String {
    Scene::read(bytes, "file.toml").unwrap_err().to_string()
}

#[test]
fn invalid_utf8_is_rejected_with_position() {
    let shown = message(b"name = \"ok\"\nunit = \"m\xff\"\n");
    assert!(
        shown.contains("the file is not UTF-8: byte 0xff at offset 21"),
        "{shown}"
    );
    assert!(shown.contains("file.toml:2:10"), "{shown}");
    let shown = message(b"\xfe\xfe");
    assert!(shown.contains("byte 0xfe at offset 0"), "{shown}");
}

#[test]
fn file_above_1_mib_is_rejected() {
    let text = presets::find("four-bar").unwrap().text;
    let filler = |size: usize| format!("{text}#{}", "x".repeat(size - text.len() - 1));
    assert!(Scene::read(filler(MAX_FILE_SIZE).as_bytes(), "x").is_ok());
    let shown = message(filler(MAX_FILE_SIZE + 1).as_bytes());
    assert!(shown.contains("the file is too large"), "{shown}");
    assert!(shown.contains("at most 1048576 bytes (1 MiB)"), "{shown}");
}

fn with_links(count: usize) -> String {
    let mut text = presets::find("four-bar").unwrap().text.to_owned();
    text += "[links.x0]\npoints.B = [0, 0]\n";
    for i in 4..count {
        text += &format!("[links.x{i}]\npoints.B = [0, {i}]\n");
    }
    text
}

#[test]
fn more_than_10000_links_are_rejected() {
    assert!(Scene::parse(&with_links(10_000), "x").is_ok());
    let shown = message(with_links(10_001).as_bytes());
    assert!(
        shown.contains("the scene has 10001 links; at most 10000 are allowed"),
        "{shown}"
    );
}

#[test]
fn only_first_20_faults_are_shown() {
    let text: String = (0..500).map(|i| format!("k{i} = {i}\n")).collect();
    let faults = Scene::parse(&text, "x").unwrap_err();
    assert_eq!(faults.items.len(), 21);
    // The missing links are one more fault.
    assert_eq!(faults.items[20].message, "481 more faults are not shown");
}

const INVALID_SCENE: &str =
    "unit = \"mm\"\r\n\r\n[ground]\r\nA\t= [0, \"\u{202e}1\"] # \u{4e16}\u{200b}\r\n";

#[test]
fn message_replaces_harmful_characters_in_quoted_line() {
    let faults = Scene::parse(INVALID_SCENE, "caf\u{e9}\u{1b}.toml").unwrap_err();
    let ascii = r"
error: the scene has no links: nothing moves
--> caf\u{e9}\u{1b}.toml
 = help: add, for example:
         [links]
         r2 = { from = `A`, to = `B`, length = 100 }

error: y of ground point `A`: `\u{202e}` is not allowed in a formula
 --> caf\u{e9}\u{1b}.toml:4:10
  |
4 | A    = [0, `?1`] # ??
  |             ^
";
    assert_eq!(faults.render(true, false).replace('"', "`"), ascii[1..]);
    let unicode = faults.render(false, false);
    assert!(
        unicode.contains("--> caf\u{e9}\\u{1b}.toml:4:10\n"),
        "{unicode}"
    );
    assert!(
        unicode.contains("A    = [0, \"\u{fffd}1\"] # \u{4e16}\u{fffd}\n"),
        "{unicode}"
    );
}

#[test]
fn coloured_message_without_codes_equals_plain_message() {
    let faults = Scene::parse(INVALID_SCENE, "wrong.toml").unwrap_err();
    let coloured = faults.render(true, true);
    assert!(coloured.contains("\u{1b}["));
    let mut plain = String::new();
    for part in coloured.split('\u{1b}') {
        let code = part.starts_with('[');
        let text = if code {
            part.split_once('m').unwrap().1
        } else {
            part
        };
        plain += text;
    }
    assert_eq!(plain, faults.render(true, false));
}

#[test]
fn positions_count_characters_from_one() {
    let faults = Scene::parse("# \u{4e16}\u{e9}\n\u{e9} = 1", "x").unwrap_err();
    assert_eq!(faults.position(&faults.items[0]), Some((2, 1)));
    let faults = Scene::parse("unit = \"mm\"\nname = \"\u{e9}\u{e9}\" x", "x").unwrap_err();
    assert_eq!(faults.position(&faults.items[0]), Some((2, 13)));
}
