//! Tests of `krank help --format html`: the web site contains the whole manual, and all its links work.

use super::language::spoken;
use super::manual::chapters;
use super::{folder, refused};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;

/// Writes the site in a language and returns its files by name. Tests run in parallel, so each has its own folder.
fn site(test: &str, language: &str) -> BTreeMap<String, String> {
    let here = folder(&format!("web-{test}-{language}"));
    fs::remove_dir_all(&here).unwrap();
    fs::create_dir_all(&here).unwrap();
    let output = spoken(
        language,
        &here,
        &["help", "--format", "html", "-o", "new/site"],
    );
    assert_eq!((output.code, output.out + &output.err), (0, String::new()));
    let files = fs::read_dir(here.join("new/site")).unwrap();
    let files = files.map(|file| {
        let file = file.unwrap();
        let name = file.file_name().into_string().unwrap();
        (name, fs::read_to_string(file.path()).unwrap())
    });
    files.collect()
}

fn pages(site: &BTreeMap<String, String>) -> impl Iterator<Item = (&str, &str)> {
    let pages = site.iter().filter(|(name, _)| name.ends_with(".html"));
    pages.map(|(name, page)| (name.as_str(), page.as_str()))
}

/// Returns the topics listed by `krank help`.
fn topics() -> Vec<String> {
    let contents = super::run_ok(&["help"]);
    let rows = contents.lines().skip(2).take_while(|line| !line.is_empty());
    let rows = rows.filter(|line| !line.starts_with(' '));
    let names = rows.map(|line| line.split_whitespace().next().unwrap().to_owned());
    names.collect()
}

/// Returns the values of an attribute in a page.
fn values<'p>(page: &'p str, attribute: &str) -> Vec<&'p str> {
    let opening = format!(" {attribute}=\"");
    let rest = page.split(opening.as_str()).skip(1);
    rest.map(|rest| rest.split('"').next().unwrap()).collect()
}

/// Returns the text of a page in one line. Panics if its tags do not match.
fn text_of(name: &str, page: &str) -> String {
    let mut open = Vec::new();
    let mut text = String::new();
    let mut pieces = page.strip_prefix("<!DOCTYPE html>").unwrap().split('<');
    assert_eq!(pieces.next().unwrap().trim(), "");
    for piece in pieces {
        let (tag, rest) = piece
            .split_once('>')
            .unwrap_or_else(|| panic!("{name}: <{piece}"));
        assert!(!rest.contains('>'), "{name}: {rest}");
        match tag.strip_prefix('/') {
            Some(end) => assert_eq!(open.pop(), Some(end), "{name}: <{piece}"),
            None if tag.ends_with('/') => {}
            None => open.push(tag.split(' ').next().unwrap()),
        }
        text += rest;
    }
    assert_eq!(open, [""; 0], "{name}");
    for (escaped, c) in [
        ("&lt;", "<"),
        ("&gt;", ">"),
        ("&quot;", "\""),
        ("&amp;", "&"),
    ] {
        text = text.replace(escaped, c);
    }
    in_one_line(&text)
}

fn in_one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Splits a chapter into pieces that every format keeps together: table cells, and lines without Markdown marks.
fn pieces(chapter: &str) -> Vec<String> {
    let mut pieces = Vec::new();
    let mut is_code = false;
    for line in chapter.lines() {
        let inner = line.trim();
        is_code ^= inner.starts_with("```");
        if is_code || line.starts_with("    ") {
            let is_fence = inner.starts_with("```");
            pieces.extend((!is_fence).then(|| inner.to_owned()));
            continue;
        }
        let plain = inner.replace("**", "").replace('`', "");
        if inner.starts_with('|') {
            let cells = plain.replace(r"\|", "\u{1}");
            let cells = cells.split('|').filter(|cell| !cell.contains("---"));
            pieces.extend(cells.map(|cell| cell.replace('\u{1}', "|")));
        } else if !inner.starts_with('{') {
            let plain = plain.trim_start_matches('#');
            pieces.push(plain.strip_prefix("- ").unwrap_or(plain).to_owned());
        }
    }
    pieces.iter().map(|piece| in_one_line(piece)).collect()
}

#[test]
fn every_topic_has_a_page_with_all_its_text() {
    for (language, folder) in [("en", "english"), ("tr", "turkish")] {
        let site = site("text", language);
        let mut names: BTreeSet<String> =
            topics().iter().map(|name| format!("{name}.html")).collect();
        names
            .extend(["index.html", "style.css", "search.js", "search-index.js"].map(str::to_owned));
        assert_eq!(site.keys().cloned().collect::<BTreeSet<_>>(), names);
        let mut text = String::new();
        for (name, page) in pages(&site) {
            assert!(
                page.contains(&format!("<html lang=\"{language}\">")),
                "{name}"
            );
            assert!(page.contains("<meta charset=\"utf-8\"/>"), "{name}");
            assert_eq!(page.matches("<h1").count(), 1, "{name}");
            text += &text_of(name, page);
        }
        let mut chapters = chapters(folder);
        if language == "en" {
            // These chapters are in other folders.
            for other in [
                include_str!("../../crates/model/src/scene/rules.md"),
                include_str!("../../crates/kinematics/src/notation.md"),
            ] {
                chapters.push(("other".into(), other.into()));
            }
        }
        let mut found = 0;
        for (name, chapter) in chapters {
            let is_left_out = ["views.md", "keys.md", "terminals.md"].contains(&name.as_str());
            if cfg!(not(feature = "tui")) && is_left_out {
                continue;
            }
            for piece in pieces(&chapter) {
                assert!(text.contains(&piece), "{name} in {language}: {piece}");
                found += 1;
            }
        }
        assert!(found > 1500, "{found}");
    }
}

#[cfg(feature = "tui")]
#[test]
fn site_contains_generated_tables() {
    let site = site("tables", "en");
    assert!(site["keys.html"].contains("<td><code>space</code></td>"));
    assert!(site["scene.html"].contains("<code>[driver]</code>"));
    // Code spans and the table of questions link to topics.
    let scene = "<a href=\"scene.html\"><code>scene</code></a>";
    assert!(site["how.html"].contains(scene));
    assert!(
        site["forces.html"].contains("<a href=\"scene.html\"><code>krank help scene</code></a>")
    );
}

#[test]
fn every_link_target_exists() {
    for language in ["en", "tr"] {
        let site = site("links", language);
        let mut links = 0;
        for (name, page) in pages(&site) {
            let ids = values(page, "id");
            let unique: BTreeSet<_> = ids.iter().collect();
            assert_eq!(unique.len(), ids.len(), "{name}: {ids:?}");
            for link in [values(page, "href"), values(page, "src")].concat() {
                let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
                let file = if file.is_empty() { name } else { file };
                let target = site.get(file).unwrap_or_else(|| panic!("{name}: {link}"));
                let is_there = anchor.is_empty() || values(target, "id").contains(&anchor);
                assert!(is_there, "{name}: {link}");
                links += 1;
            }
        }
        assert!(links > 300, "{links}");
    }
}

/// Each entry of the index is valid JSON on one line.
#[test]
fn search_index_covers_every_heading() {
    for language in ["en", "tr"] {
        let site = site("search", language);
        let index = &site["search-index.js"];
        let entries = index.strip_prefix("const INDEX = [\n").unwrap();
        let entries = entries.strip_suffix("];\n").unwrap();
        let mut sections = 0;
        for line in entries.lines() {
            let entry: Vec<String> = serde_json::from_str(line.trim_end_matches(',')).unwrap();
            let [file, topic, heading, anchor, text] = &entry[..] else {
                panic!("{line}");
            };
            assert!(
                values(&site[file], "id").contains(&anchor.as_str()),
                "{line}"
            );
            assert!(!topic.is_empty() && !heading.is_empty(), "{line}");
            assert!(!text.contains('`') && !text.contains("**"), "{text}");
            sections += 1;
        }
        let headings = |(_, page): (&str, &str)| values(page, "id").len() - 1;
        // The navigation also has an id.
        assert_eq!(sections, pages(&site).map(headings).sum::<usize>());
    }
}

#[test]
fn site_loads_no_external_resources() {
    let site = site("loaded", "en");
    for (name, page) in pages(&site) {
        for link in [values(page, "href"), values(page, "src")].concat() {
            assert!(
                !link.contains(':') && !link.starts_with('/'),
                "{name}: {link}"
            );
        }
    }
    for name in ["style.css", "search.js"] {
        for foreign in ["://", "url(", "@import", "import ", "fetch", "innerHTML"] {
            assert!(!site[name].contains(foreign), "{name}: {foreign}");
        }
    }
    assert!(site["style.css"].contains("prefers-color-scheme: dark"));
}

#[test]
fn site_replaces_its_own_files_and_keeps_others() {
    let here = folder("web-replaced");
    for name in ["index.html", "mine.txt"] {
        fs::write(here.join(name), "mine").unwrap();
    }
    let output = spoken("en", &here, &["help", "--format", "html", "-o", "."]);
    assert_eq!((output.code, output.err.as_str()), (0, ""));
    let read = |name: &str| fs::read_to_string(here.join(name)).unwrap();
    assert!(read("index.html").starts_with("<!DOCTYPE html>"));
    assert_eq!(read("mine.txt"), "mine");
}

#[test]
fn html_format_requires_folder_and_all_topics() {
    for (args, english, turkish) in [
        (
            &["help", "--format", "html"][..],
            "error: `--format html` writes a web site: add `-o DIR`\n",
            "hata: `--format html` bir web sitesi yazar: `-o DIR` ekleyin\n",
        ),
        (
            &["help", "scene", "--format", "html", "-o", "x"],
            "error: `--format html` writes all topics: remove `scene`\n",
            "hata: `--format html` bütün konuları yazar: `scene` sözcüğünü silin\n",
        ),
        (
            &["help", "scene", "-o", "x"],
            "error: `-o DIR` needs `--format html`\n",
            "hata: `-o DIR` için `--format html` gerekir\n",
        ),
    ] {
        assert_eq!(refused(2, args), english);
        let output = spoken("tr", &folder("web-refused"), args);
        assert_eq!((output.code, output.err.as_str()), (2, turkish));
    }
    let here = folder("web-unwritable");
    fs::write(here.join("file"), "").unwrap();
    for path in ["file", "file/site"] {
        let output = spoken("en", &here, &["help", "--format", "html", "-o", path]);
        assert_eq!(output.code, 1, "{}", output.err);
        assert!(output.err.contains(&format!("`{path}`")), "{}", output.err);
    }
}
