//! Writes the manual as a static web site: a page for each topic, an index, a style sheet and a search script.

use super::layout::{MAX_UNBROKEN_CODE, plain};
use super::markdown::{MarkdownBlock, MarkdownContent, MarkdownTable, blocks};
use super::{TOPICS, Topic, find, spelled};
use crate::page::{html_document, marked_up};
use crate::wording::{Language, words};
use std::fmt::Write as _;

const STYLE: &str = include_str!("website/style.css");
const SCRIPT: &str = include_str!("website/search.js");
/// Links of each page to the other files. Classic scripts also work from `file://`.
const LINKS: &str = "\
<link rel=\"stylesheet\" href=\"style.css\"/>
<script defer src=\"search-index.js\"></script>
<script defer src=\"search.js\"></script>
";
/// The anchor of the list of topics. Anchors of headings have no underscore.
const NAVIGATION: &str = "_topics";

/// Returns the name and the content of each file, in the current language. `keys` writes the table rows of the
/// workbench's keys.
pub(crate) fn site(keys: fn() -> String) -> Vec<(String, String)> {
    let mut index = String::from("const INDEX = [\n");
    let mut files = vec![("index.html".to_owned(), index_page())];
    for topic in TOPICS {
        let mut sections = Vec::new();
        let content = content(&blocks(&topic.text(keys)), &mut sections);
        for section in &sections {
            // The debug format of a Rust string is also a valid JavaScript string.
            let entry = [
                &file(topic),
                &title(topic),
                &section.heading,
                &section.anchor,
                &section.text,
            ];
            let _ = writeln!(index, "{entry:?},");
        }
        files.push((file(topic), page(Some(topic), &sections, &content)));
    }
    files.push(("style.css".to_owned(), STYLE.to_owned()));
    files.push(("search.js".to_owned(), SCRIPT.to_owned()));
    files.push(("search-index.js".to_owned(), index + "];\n"));
    files
}

/// A heading with the text below it.
#[derive(Debug)]
struct WebSection {
    level: usize,
    anchor: String,
    heading: String,
    /// The text as it is searched: a line for each paragraph, table row and line of code.
    text: String,
}

fn file(topic: &Topic) -> String {
    format!("{}.html", topic.name)
}

fn title(topic: &Topic) -> String {
    Language::current_language().capitalised(topic.called())
}

fn link(topic: &Topic, attributes: &str, html: &str) -> String {
    format!("<a href=\"{}\"{attributes}>{html}</a>", file(topic))
}

fn index_page() -> String {
    let mut html = format!(
        "<h1>{}</h1>\n<p>krank {}: {}</p>\n<dl>\n",
        marked_up(words().manual_title()),
        env!("CARGO_PKG_VERSION"),
        marked_up(words().what_krank_is()),
    );
    for topic in TOPICS {
        let link = link(topic, "", &marked_up(&title(topic)));
        let about = marked_up((topic.about)(words()));
        let _ = writeln!(html, "<dt>{link}</dt><dd>{about}</dd>");
    }
    page(None, &[], &(html + "</dl>\n"))
}

/// Returns a page with its header, the search and the list of topics; `None` is the index.
fn page(topic: Option<&Topic>, sections: &[WebSection], content: &str) -> String {
    let manual = words().manual_title();
    let topics = marked_up(words().topics_of_manual());
    let mut navigation = String::new();
    for other in TOPICS {
        let is_current = topic.is_some_and(|topic| topic.name == other.name);
        let (attributes, below) = match is_current {
            true => (" aria-current=\"page\"", contents(sections)),
            false => ("", String::new()),
        };
        let link = link(other, attributes, &marked_up(&title(other)));
        let _ = writeln!(navigation, "<li>{link}{below}</li>");
    }
    let body = format!(
        "<header>\n<a href=\"index.html\">{}</a>\n<a class=\"menu\" href=\"#{NAVIGATION}\">{topics}</a>\n\
         <form role=\"search\" hidden><input type=\"search\" placeholder=\"{search}\" \
         aria-label=\"{search}\"/></form>\n</header>\n\
         <ul class=\"hits\" aria-live=\"polite\" data-none=\"{}\" hidden></ul>\n\
         <main>\n{content}</main>\n\
         <nav id=\"{NAVIGATION}\" aria-label=\"{topics}\">\n<ul>\n{navigation}</ul>\n</nav>\n",
        marked_up(manual),
        marked_up(words().nowhere()),
        search = marked_up(words().search_manual()),
    );
    let title = topic.map_or(manual.to_owned(), |topic| {
        format!("{} - {manual}", title(topic))
    });
    html_document(&title, LINKS, &body)
}

/// Returns the list of a page's headings; nothing if there is only one.
fn contents(sections: &[WebSection]) -> String {
    let mut list = String::new();
    for section in sections {
        let (level, anchor) = (section.level, &section.anchor);
        let heading = marked_up(&section.heading);
        let _ = writeln!(
            list,
            "<li class=\"level{level}\"><a href=\"#{anchor}\">{heading}</a></li>"
        );
    }
    match sections {
        [] | [_] => String::new(),
        _ => format!("\n<ul>\n{list}</ul>\n"),
    }
}

/// Returns the blocks as HTML, and adds a section for each heading.
fn content(blocks: &[MarkdownBlock<'_>], sections: &mut Vec<WebSection>) -> String {
    let is_item = |block: &MarkdownBlock<'_>| matches!(block.content, MarkdownContent::Item(_));
    let is_in_list = |block: &MarkdownBlock<'_>| block.indent > 0 || is_item(block);
    let mut html = String::new();
    for run in blocks.chunk_by(|one, next| is_in_list(one) && is_in_list(next)) {
        if !run.iter().all(is_in_list) {
            html.extend(run.iter().map(|it| block(it, sections)));
            continue;
        }
        html += "<ul>\n";
        for item in run.chunk_by(|_, next| !is_item(next)) {
            let blocks: String = item.iter().map(|it| block(it, sections)).collect();
            html += &format!("<li>{blocks}</li>\n");
        }
        html += "</ul>\n";
    }
    html
}

fn block(block: &MarkdownBlock<'_>, sections: &mut Vec<WebSection>) -> String {
    let (html, text) = match &block.content {
        MarkdownContent::Heading(level, text) => {
            let section = section(*level, text, sections);
            // The first heading is the title of the page.
            let level = if sections.is_empty() { 1 } else { level + 1 };
            let (anchor, inner) = (&section.anchor, inline(text));
            let html =
                format!("<h{level} id=\"{anchor}\"><a href=\"#{anchor}\">{inner}</a></h{level}>\n");
            sections.push(section);
            return html;
        }
        MarkdownContent::Paragraph(text) => (format!("<p>{}</p>\n", inline(text)), text.clone()),
        MarkdownContent::Item(text) => (inline(text), text.clone()),
        MarkdownContent::Code(lines) => {
            let marked: Vec<String> = lines.iter().map(|line| marked_up(line)).collect();
            let html = format!("<pre><code>{}</code></pre>\n", marked.join("\n"));
            (html, lines.join("\n"))
        }
        MarkdownContent::Table(content) => {
            let rows: Vec<String> = content.rows.iter().map(|cells| cells.join(" ")).collect();
            (table(content), rows.join("\n"))
        }
    };
    if let Some(section) = sections.last_mut() {
        section.text += &(bare(&text) + "\n");
    }
    html
}

/// Returns the section of a heading, with an anchor that no earlier one has.
fn section(level: usize, heading: &str, before: &[WebSection]) -> WebSection {
    let heading = bare(heading);
    let name = spelled(&heading);
    let parts = name.split(|c: char| !c.is_ascii_alphanumeric());
    let parts: Vec<&str> = parts.filter(|part| !part.is_empty()).collect();
    let mut anchor = parts.join("-");
    while before.iter().any(|section| section.anchor == anchor) {
        anchor += "-more";
    }
    WebSection {
        level,
        anchor,
        heading,
        text: String::new(),
    }
}

/// Returns a text without Markdown.
fn bare(text: &str) -> String {
    plain(text).replace('`', "")
}

/// Returns the text of a paragraph or cell with its code, bold words and links as HTML.
fn inline(text: &str) -> String {
    let mut html = String::new();
    let mut is_bold = false;
    for (number, piece) in text.replace(r"\|", "|").split('`').enumerate() {
        if number % 2 == 1 {
            html += &code(piece);
            continue;
        }
        for (number, words) in piece.split("**").enumerate() {
            if number > 0 {
                html += if is_bold { "</strong>" } else { "<strong>" };
                is_bold = !is_bold;
            }
            html += &marked_up(words);
        }
    }
    html + if is_bold { "</strong>" } else { "" }
}

/// Returns code as HTML; only long code wraps. `krank help TOPIC` links to the topic.
fn code(text: &str) -> String {
    let class = if text.len() > MAX_UNBROKEN_CODE {
        " class=\"long\""
    } else {
        ""
    };
    let code = format!("<code{class}>{}</code>", marked_up(text));
    match text.strip_prefix("krank help ").and_then(find) {
        Some(topic) => link(topic, "", &code),
        None => code,
    }
}

/// Returns a table as HTML. Its first row is the head; a row that begins in bold begins a group of rows.
fn table(table: &MarkdownTable<'_>) -> String {
    let mut html = String::from("<div class=\"table\"><table>\n");
    for (number, cells) in table.rows.iter().enumerate() {
        let group = cells.first().filter(|cell| cell.starts_with("**"));
        html += &match (group, cells.iter().filter(|cell| !cell.is_empty()).count()) {
            (_, 0) => continue,
            (Some(title), 1) => {
                let (count, title) = (cells.len(), inline(title));
                format!("<tr class=\"group\"><th colspan=\"{count}\">{title}</th></tr>\n")
            }
            _ => {
                let class = group.map_or("", |_| " class=\"group\"");
                let tag = if number == 0 { "th" } else { "td" };
                format!("<tr{class}>{}</tr>\n", row(tag, cells, &table.right))
            }
        };
    }
    html + "</table></div>\n"
}

fn row(tag: &str, cells: &[&str], right: &[bool]) -> String {
    let mut html = String::new();
    for (column, cell) in cells.iter().enumerate() {
        let class = match right.get(column) {
            Some(true) => " class=\"right\"",
            _ => "",
        };
        // The table of questions names topics in its last column.
        let code = cell
            .strip_prefix('`')
            .and_then(|cell| cell.strip_suffix('`'));
        let topic = code.filter(|_| column + 1 == cells.len()).and_then(find);
        let inner = match topic {
            Some(topic) => link(topic, "", &inline(cell)),
            None => inline(cell),
        };
        html += &format!("<{tag}{class}>{inner}</{tag}>");
    }
    html
}
