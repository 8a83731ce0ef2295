//! Tests pages at various widths.

use super::*;

fn text(page: &Page, width: usize) -> String {
    page.to_text(TextStyle { ascii: true, width })
}

fn figures() -> Table {
    let mut table = Table::new("point", ["x", "y", "z"]);
    table.row("A", ["1.000", "20.00", "3"].map(str::to_owned));
    table.row("long", ["4", "5"].map(str::to_owned));
    table
}

#[test]
fn columns_that_do_not_fit_follow_below() {
    let mut page = Page::default();
    page.table(figures());
    let below = "point  x      y\nA      1.000  20.00\nlong       4      5\n\npoint  z\nA      3\n";
    let aligned = below.replace("  x      y", "      x      y");
    assert_eq!(text(&page, 19), aligned);
    let mut first = figures();
    first.setting.rest = Rest::LeftOut;
    let mut page = Page::default();
    page.table(first);
    // Paper has room for all columns.
    assert_eq!(text(&page, 19), aligned);
    let style = TextStyle {
        ascii: true,
        width: 19,
    };
    let screen: Vec<String> = page.lines(style).iter().map(Line::text).collect();
    assert_eq!(screen, aligned.lines().take(3).collect::<Vec<_>>());
}

#[test]
fn only_screens_cut_names_that_do_not_fit() {
    let mut page = Page::default();
    let mut table = Table::new("", ["x"]);
    table.row("a_name_of_many_letters", ["1".to_owned()]);
    page.table(table);
    assert!(text(&page, 12).contains("a_name_of_many_letters  1\n"));
    let style = TextStyle {
        ascii: true,
        width: 12,
    };
    let cut: Vec<String> = page.lines(style).iter().map(Line::text).collect();
    assert_eq!(cut, ["           x", "a_na..ers  1"]);
    // A truncated number would be a different number.
    let mut page = Page::default();
    let mut table = Table::new("", ["x"]);
    table.row("name", ["-128.715".to_owned()]);
    page.table(table);
    let lines = page.lines(TextStyle {
        ascii: true,
        width: 9,
    });
    assert!(
        lines.iter().all(|line| !line.text().contains('1')),
        "{lines:?}"
    );
}

#[test]
fn names_use_long_form_if_it_fits_and_align() {
    let mut page = Page::aligned();
    let mut table = Table::new("force", ["f"]);
    table.rows.push(Row::Figures {
        mark: String::new(),
        name: "r2 at A".into(),
        more: Some("r2 at A by ground".into()),
        cells: vec![Some(Cell::proved("7"))],
    });
    page.table(table);
    let mut facts = Facts::default();
    facts.add("at rest", ["no".to_owned()]);
    page.add(Content::Facts(facts));
    assert_eq!(
        text(&page, 30),
        "force              f\nr2 at A by ground  7\n\nat rest           no\n"
    );
    assert_eq!(text(&page, 15), "force    f\nr2 at A  7\n\nat rest no\n");
}

#[test]
fn words_follow_name_or_wrap_below_it() {
    let mut page = Page::default();
    let mut table = Table::new("method", ["time"]);
    table.rows.push(Row::Told {
        mark: "a*".into(),
        name: "Newton".into(),
        words: "not needed here".into(),
    });
    page.table(table);
    assert_eq!(
        text(&page, 40).lines().last(),
        Some("a* Newton  - not needed here")
    );
    let narrow = text(&page, 20);
    assert!(
        narrow.ends_with("a* Newton\n   not needed here\n"),
        "{narrow}"
    );
}

#[test]
fn parts_are_separated_unless_introduced() {
    let mut page = Page::default();
    page.title("T");
    page.text_below("state ok");
    page.heading("of it");
    page.text("it is so:");
    page.equation(["a".into(), "b".into()]);
    assert_eq!(
        text(&page, 40),
        "T\nstate ok\n\nof it\nit is so:\n  a = b\n"
    );
}

#[test]
fn ascii_text_spells_out_other_characters() {
    let mut page = Page::default();
    page.title("Kurbel \u{2192} \u{1b}[2J \u{fc}");
    page.equation(["θ3".into(), Formula::number("2").with_sign('·').then("α")]);
    let shown = page.to_text(TextStyle::plain(true));
    assert!(shown.is_ascii() && !shown.contains('\u{1b}'), "{shown:?}");
    assert!(shown.ends_with("  theta3 = 2*alpha\n"), "{shown}");
}

#[test]
fn markdown_has_every_cell_and_fact() {
    let mut page = Page::default();
    page.table(figures());
    let mut facts = Facts::default();
    facts.add("links", ["r_2".to_owned(), "r3".to_owned()]);
    page.add(Content::Facts(facts));
    let expected = "| point | x | y | z |\n| --- | ---: | ---: | ---: |\n| A | 1.000 | 20.00 | 3 |\n\
                    | long | 4 | 5 |  |\n\n- **links**: r\\_2; r3\n";
    assert_eq!(page.to_markdown(true), expected);
    let mut page = Page::default();
    page.title("A &amp; *B*");
    assert_eq!(page.to_markdown(true), "# A \\&amp; \\*B\\*\n");
}
