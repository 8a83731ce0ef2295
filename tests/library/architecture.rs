//! Checks the architecture from the sources: imports between modules, and the place of user-visible
//! sentences.
//!
//! The layers are scene -> mechanism -> solver -> quantity -> study -> drawing -> report -> tui.
//! `solver` knows no file, no unit name and no terminal; only the command line imports `tui`, and
//! only `main` imports the command line.

mod english;
mod module_maps;
mod wording;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Every module of the crate and its layer: a module may import those of lower layers. Modules of
/// the same layer do not import each other.
const MODULES: [(&str, u8); 29] = [
    ("wording", 0),
    ("guide", 0),
    ("numeric", 0),
    ("parallel", 0),
    ("arithmetic", 0),
    ("nearest", 1),
    ("pixels", 1),
    ("files", 1),
    ("expression", 2),
    ("document", 3),
    ("page", 4),
    ("mechanism", 3),
    ("scene", 4),
    ("solver", 4),
    ("assembly", 5),
    ("explain", 5),
    ("quantity", 5),
    ("study", 6),
    ("synthesis", 6),
    ("task_file", 7),
    ("drawing", 7),
    ("report", 8),
    ("script_export", 8),
    ("import", 8),
    ("capability", 9),
    ("manual", 9),
    ("tui", 10),
    ("cli", 11),
    ("main", 12),
];

/// The modules of the workbench and their layers. Those of the layer [`TOP_LAYER`] may import each
/// other: an action changes what views read, and asks a view what it needs.
const TUI_MODULES: [(&str, u8); 11] = [
    ("appearance", 0),
    ("commands", 0),
    ("figures", 1),
    ("terminal", 1),
    ("player", 2),
    ("document", 3),
    ("app", TOP_LAYER),
    ("config", TOP_LAYER),
    ("views", TOP_LAYER),
    ("workbench", 5),
    ("picture", 6),
];
const TOP_LAYER: u8 = 4;

/// Crates, and parts of the standard library, that only some modules may use.
const FOREIGN: [(&str, &[&str]); 28] = [
    // All other modules name the kernel through krank's own root.
    ("kinematics", &["manual"]),
    ("model", &["scene"]),
    ("synthesis", &["synthesis"]),
    ("ratatui", &["tui"]),
    ("crossterm", &["tui"]),
    ("rustix", &["cli", "tui", "files"]),
    ("signal_hook", &["cli", "tui"]),
    ("clap", &["cli"]),
    ("clap_complete", &["cli"]),
    ("clap_mangen", &["cli"]),
    ("toml", &["document", "scene"]),
    ("annotate_snippets", &["document"]),
    ("csv", &["report"]),
    ("serde_json", &["report", "import"]),
    ("roxmltree", &["import"]),
    ("serde", &["report"]),
    ("num_bigint", &["expression"]),
    ("petgraph", &["solver"]),
    ("zmij", &["report"]),
    ("fearless_simd", &["arithmetic"]),
    ("resvg", &["pixels"]),
    ("gif", &["pixels"]),
    ("icy_sixel", &["pixels"]),
    ("dejavu", &["pixels"]),
    ("std::fs", &["cli", "tui", "files"]),
    ("std::io", &["report", "cli", "tui", "files"]),
    ("std::env", &["cli", "tui", "main", "files"]),
    ("std::process", &["cli", "tui", "main", "files"]),
];

fn place(module: &str) -> Option<u8> {
    MODULES.iter().find(|(m, _)| *m == module).map(|(_, p)| *p)
}

/// A source file: its module path, and its tokens without tests.
struct Source {
    path: Vec<String>,
    tokens: Vec<String>,
}

/// Splits source text into identifiers, `::`, single punctuation characters, and string literals
/// with their opening quote. Omits comments, character literals and lifetime quotes.
fn tokens(text: &str) -> Vec<String> {
    let chars: Vec<char> = text.chars().collect();
    let mut found = Vec::new();
    let mut i = 0;
    while i < chars.len() {
        let next = chars.get(i + 1).copied();
        i = match chars[i] {
            '/' if next == Some('/') => until(&chars, i, |c| c == '\n'),
            '/' if next == Some('*') => after_comment(&chars, i),
            '"' => {
                let end = after_text(&chars, i);
                found.push(chars[i..end - 1].iter().collect());
                end
            }
            'r' if matches!(next, Some('"' | '#')) && raw_text(&chars, i).is_some() => {
                let end = raw_text(&chars, i).unwrap();
                let open = until(&chars, i, |c| c == '"');
                found.push(chars[open..end].iter().collect());
                end
            }
            '\'' => after_quote(&chars, i),
            c if c.is_alphanumeric() || c == '_' => {
                let end = until(&chars, i, |c| !(c.is_alphanumeric() || c == '_'));
                found.push(chars[i..end].iter().collect());
                end
            }
            ':' if next == Some(':') => {
                found.push("::".into());
                i + 2
            }
            c => {
                if !c.is_whitespace() {
                    found.push(c.into());
                }
                i + 1
            }
        };
    }
    found
}

fn until(chars: &[char], from: usize, end: impl Fn(char) -> bool) -> usize {
    let length = chars[from..].iter().position(|&c| end(c));
    length.map_or(chars.len(), |length| from + length)
}

fn after_comment(chars: &[char], from: usize) -> usize {
    let rest = chars[from + 2..].windows(2);
    let length = rest.into_iter().position(|pair| pair == ['*', '/']);
    length.map_or(chars.len(), |length| from + length + 4)
}

fn after_text(chars: &[char], from: usize) -> usize {
    let mut i = from + 1;
    while i < chars.len() && chars[i] != '"' {
        i += if chars[i] == '\\' { 2 } else { 1 };
    }
    i + 1
}

/// Returns the index after `r"..."` or `r#"..."#`; `None` for an `r` that opens no raw string.
fn raw_text(chars: &[char], from: usize) -> Option<usize> {
    let open = until(chars, from + 1, |c| c != '#');
    if chars.get(open) != Some(&'"') {
        return None;
    }
    let mut close = vec!['"'];
    close.resize(open - from, '#');
    let mut ends = open + 1..chars.len();
    let end = ends.find(|&i| chars[i..].starts_with(&close))?;
    Some(end + close.len())
}

/// Returns the index after a character literal, or after the quote of a lifetime.
fn after_quote(chars: &[char], from: usize) -> usize {
    if chars.get(from + 1) == Some(&'\\') {
        until(chars, from + 3, |c| c == '\'') + 1
    } else if chars.get(from + 2) == Some(&'\'') {
        from + 3
    } else {
        from + 1
    }
}

/// Removes modules under `#[cfg(test)]`: tests may import everything.
fn without_tests(tokens: &[String]) -> Vec<String> {
    let mark = ["#", "[", "cfg", "(", "test", ")", "]", "mod"];
    let mut kept = Vec::new();
    let mut i = 0;
    while i < tokens.len() {
        if tokens[i..].iter().take(mark.len()).eq(mark.iter()) {
            i = behind_block(tokens, i + mark.len());
        } else {
            kept.push(tokens[i].clone());
            i += 1;
        }
    }
    kept
}

/// Returns the index after `name { ... }` or `name;`.
fn behind_block(tokens: &[String], from: usize) -> usize {
    let mut depth = 0;
    for (i, token) in tokens.iter().enumerate().skip(from) {
        match token.as_str() {
            "{" => depth += 1,
            "}" => depth -= 1,
            ";" if depth == 0 => return i + 1,
            _ => {}
        }
        if depth == 0 && token == "}" {
            return i + 1;
        }
    }
    tokens.len()
}

/// Returns what follows a path's `::` at `i`: one name, or the first names of a group in braces.
fn heads(tokens: &[String], i: usize) -> Vec<String> {
    if tokens.get(i).map(String::as_str) != Some("{") {
        return tokens.get(i).cloned().into_iter().collect();
    }
    let mut headers = Vec::new();
    let mut depth = 0;
    for (j, token) in tokens.iter().enumerate().skip(i) {
        match token.as_str() {
            "{" => depth += 1,
            "}" => depth -= 1,
            _ if depth == 1 && matches!(tokens[j - 1].as_str(), "{" | ",") => {
                headers.push(token.clone());
            }
            _ => {}
        }
        if depth == 0 {
            break;
        }
    }
    headers
}

impl Source {
    fn new(path: Vec<String>, text: &str) -> Self {
        let tokens = without_tests(&tokens(text));
        Source { path, tokens }
    }

    fn module(&self) -> &str {
        &self.path[0]
    }

    /// Returns the names in the crate's root that the file refers to, by `crate::`, `krank::` or
    /// `super::`.
    fn root_names(&self) -> BTreeSet<String> {
        self.names_in(&[])
    }

    /// Returns the names in a module that the file refers to.
    fn names_in(&self, module: &[&str]) -> BTreeSet<String> {
        let mut names = BTreeSet::new();
        let at = |i: usize| self.tokens.get(i).map_or("", String::as_str);
        for i in 0..self.tokens.len() {
            if at(i + 1) != "::" || (i > 0 && at(i - 1) == "::") {
                continue;
            }
            let mut after = i + 2;
            let mut depth = match at(i) {
                "crate" | "krank" => 0,
                "super" => self.path.len() - 1,
                _ => continue,
            };
            while at(after) == "super" && depth > 0 {
                depth -= 1;
                after += 2;
            }
            let mut at_module = self.path[..depth]
                .iter()
                .map(String::as_str)
                .eq(module.iter().copied());
            if depth == 0 && !module.is_empty() {
                at_module = module
                    .iter()
                    .enumerate()
                    .all(|(k, part)| at(after + 2 * k) == *part && at(after + 2 * k + 1) == "::");
                after += 2 * module.len();
            }
            if at_module {
                names.extend(heads(&self.tokens, after));
            }
        }
        names
    }

    /// Returns the disallowed imports of a workbench file: those from layers that are not lower.
    fn disallowed_tui_imports(&self) -> Vec<String> {
        let place = |space: &str| {
            TUI_MODULES
                .iter()
                .find(|(r, _)| *r == space)
                .map(|(_, p)| *p)
        };
        let Some(space) = self.path.get(1).filter(|_| self.path[0] == "tui") else {
            return Vec::new();
        };
        let own =
            place(space).unwrap_or_else(|| panic!("`tui::{space}` has no layer in TUI_MODULES"));
        let named = self.names_in(&["tui"]).into_iter();
        let wrong = named.filter(|name| {
            let place = place(name).filter(|_| *name != self.path[1]);
            place.is_some_and(|place| place >= own && (place, own) != (TOP_LAYER, TOP_LAYER))
        });
        wrong
            .map(|name| format!("{} imports `{name}`", self.path.join("::")))
            .collect()
    }

    /// Returns `true` if the file names an external crate, or a part of the standard library.
    fn names_foreign(&self, foreign: &str) -> bool {
        let (first, second) = foreign.split_once("::").unwrap_or((foreign, ""));
        let at = |i: usize| self.tokens.get(i).map_or("", String::as_str);
        (0..self.tokens.len()).any(|i| {
            let path = at(i) == first && at(i + 1) == "::" && (i == 0 || at(i - 1) != "::");
            path && (second.is_empty() || heads(&self.tokens, i + 2).iter().any(|h| h == second))
        })
    }

    /// Returns all disallowed imports of the file.
    fn faults(&self, exports: &BTreeMap<String, String>) -> Vec<String> {
        let module = self.module();
        let own = place(module).unwrap_or_else(|| panic!("`{module}` has no layer in MODULES"));
        let mut faults = Vec::new();
        for name in self.root_names() {
            let target = exports.get(&name).unwrap_or(&name);
            let allowed = match place(target) {
                _ if target == module => true,
                Some(place) => place < own,
                None => false,
            };
            if !allowed {
                faults.push(format!(
                    "{} imports `{target}` ({name})",
                    self.path.join("::")
                ));
            }
        }
        for (foreign, users) in FOREIGN {
            if self.names_foreign(foreign) && !users.contains(&module) {
                faults.push(format!("{} uses `{foreign}`", self.path.join("::")));
            }
        }
        faults
    }
}

/// Returns the re-exports of `lib.rs`, `pub use module::{A, B}`, as modules by name.
fn exports(lib: &str) -> BTreeMap<String, String> {
    let tokens = tokens(lib);
    let mut exports = BTreeMap::new();
    for i in 2..tokens.len().saturating_sub(2) {
        if tokens[i - 2] == "pub" && tokens[i - 1] == "use" && tokens[i + 1] == "::" {
            for name in heads(&tokens, i + 2) {
                exports.insert(name, tokens[i].clone());
            }
        }
    }
    exports
}

/// Returns the source folders of krank, the kernel, the model and the synthesis, in this order.
fn source_folders() -> [PathBuf; 4] {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    [
        "src",
        "crates/kinematics/src",
        "crates/model/src",
        "crates/synthesis/src",
    ]
    .map(|folder| root.join(folder))
}

/// Returns every source file, with its path relative to its source folder.
fn sources() -> Vec<(PathBuf, PathBuf)> {
    let mut all = Vec::new();
    for folder in source_folders() {
        let mut found = Vec::new();
        files(&folder, &mut found);
        let inner = |file: &PathBuf| file.strip_prefix(&folder).unwrap().to_owned();
        all.extend(found.iter().map(|file| (file.clone(), inner(file))));
    }
    all
}

/// Returns the names that krank's root re-exports, with the modules that define them.
fn root_exports() -> BTreeMap<String, String> {
    let [own, kernel, ..] = source_folders().map(|folder| {
        let lib = fs::read_to_string(folder.join("lib.rs")).unwrap();
        exports(&lib)
    });
    // A module that is re-exported as a whole keeps its own name.
    let named = own
        .into_iter()
        .filter(|(_, from)| from != "kinematics" && from != "model");
    named.chain(kernel).collect()
}

/// Returns the module path of a file: `solver/plan.rs` is `solver::plan`; `solver/mod.rs` and
/// `solver.rs` are `solver`.
fn module_path(inner: &Path) -> Vec<String> {
    let inner = inner.with_extension("");
    let parts = inner.iter().map(|part| part.to_str().unwrap().to_owned());
    parts.filter(|part| part != "mod").collect()
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

fn is_test(path: &[String]) -> bool {
    path.iter().any(|part| part == "tests")
}

#[test]
fn modules_import_only_from_lower_layers() {
    let exports = root_exports();
    assert_eq!(exports["LinkId"], "mechanism", "lib.rs was not understood");
    let mut faults = Vec::new();
    let mut seen = BTreeSet::new();
    // The synthesis depends only on the kernel, so that the compiler checks its imports.
    let synthesis = &source_folders()[3];
    for (file, inner) in sources() {
        let path = module_path(&inner);
        if path == ["lib"] || is_test(&path) || file.starts_with(synthesis) {
            continue;
        }
        seen.insert(path[0].clone());
        let source = Source::new(path, &fs::read_to_string(&file).unwrap());
        faults.extend(source.faults(&exports));
        faults.extend(source.disallowed_tui_imports());
    }
    assert!(seen.contains("solver") && seen.contains("cli"), "{seen:?}");
    assert!(faults.is_empty(), "\n{}\n", faults.join("\n"));
}

/// Tests the checker on samples of wrong and allowed imports.
mod checker {
    use super::*;

    fn faults(path: &[&str], text: &str) -> Vec<String> {
        let exports = [
            ("Vec2", "arithmetic"),
            ("LinkId", "mechanism"),
            ("Scene", "scene"),
        ];
        let exports = exports.map(|(name, module)| (name.to_owned(), module.to_owned()));
        let path = path.iter().map(|&part| part.to_owned()).collect();
        Source::new(path, text).faults(&exports.into())
    }

    #[test]
    fn finds_imports_of_higher_tui_modules() {
        let faults = |path: &[&str], text: &str| {
            let path = path.iter().map(|&part| part.to_owned()).collect();
            Source::new(path, text).disallowed_tui_imports()
        };
        let player = ["tui", "player", "steps"];
        for bad in [
            "use crate::tui::views::help;",
            "use super::super::document::disk;",
            "use crate::tui::{Opened, app::App};",
        ] {
            assert_eq!(faults(&player, bad).len(), 1, "{bad}");
        }
        for good in [
            "use crate::tui::figures::format;",
            "use super::playback;",
            "use crate::tui::Opened;",
            "#[cfg(test)]\nmod tests { use crate::tui::views; }",
        ] {
            assert_eq!(faults(&player, good), [""; 0], "{good}");
        }
        assert_eq!(faults(&["tui", "app"], "use super::views;"), [""; 0]);
        assert_eq!(faults(&["solver"], "use crate::tui::views;"), [""; 0]);
    }

    #[test]
    fn finds_imports_by_every_kind_of_path() {
        let bad = [
            "use crate::scene::Scene;",
            "use crate::{LinkId, scene::{Scene, Unit}};",
            "use crate::{Vec2, Scene};",
            "fn f(s: &crate::quantity::Quantity) {}",
            "use super::super::tui::App;",
            "fn f() -> krank::report::Tables { todo!() }",
            "use crate::nowhere;",
            "pub(crate) use crate :: drawing :: Glyphs;",
        ];
        for text in bad {
            assert_eq!(faults(&["solver", "plan"], text).len(), 1, "{text}");
        }
    }

    #[test]
    fn finds_disallowed_crates_and_io() {
        let bad = [
            "use ratatui::buffer::Buffer;",
            "use std::{collections::BTreeMap, fs};",
            "fn f() { let _ = std::io::stdout(); }",
        ];
        for text in bad {
            assert_eq!(faults(&["solver"], text).len(), 1, "{text}");
        }
        assert_eq!(
            faults(&["report"], "use std::io::Write; use clap::Parser;").len(),
            1
        );
    }

    #[test]
    fn accepts_allowed_imports() {
        let good = [
            "use crate::{LinkId, Vec2, mechanism::Link};",
            "use super::plan::Plan; use crate::solver::State;",
            "// use crate::tui::App;\n/* crate::cli */ fn f() {}",
            "fn f() -> &'static str { \"crate::tui::App\" }",
            "fn f() -> char { '\"' } // \"\nfn g<'a>(x: &'a str) {}",
            "const T: &str = r#\"use crate::tui; \"# ;",
            "#[cfg(test)] mod tests { use crate::scene::Scene; fn f() { {} } } fn g() {}",
            "fn f() -> std::fmt::Result { Ok(()) }",
        ];
        for text in good {
            assert_eq!(faults(&["solver", "plan"], text), [""; 0], "{text}");
        }
        assert_eq!(
            faults(&["cli"], "use crate::{tui, report, scene};"),
            [""; 0]
        );
    }

    #[test]
    fn code_after_a_test_module_is_checked() {
        let text = "#[cfg(test)] mod tests { fn f() { } } use crate::tui::App;";
        assert_eq!(faults(&["solver"], text).len(), 1);
        let text = "#[cfg(test)] mod tests; use crate::tui::App;";
        assert_eq!(faults(&["solver"], text).len(), 1);
    }
}
