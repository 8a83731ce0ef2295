//! `explain`: the working of one state, as text and as Markdown.

use super::{command, done, folder, krank, refused, run};

#[test]
fn the_working_begins_where_the_scene_opens() {
    let text = done(&["explain", "four-bar"]);
    assert_eq!(text, done(&["explain", "four-bar", "--at", "60"]));
    assert!(text.starts_with("Four-bar crank-rocker\n---"), "{text}");
    assert!(text.contains("\n  r1 + r2 + r3 + r4 = 0\n"), "{text}");
    assert!(
        text.is_ascii() && text.lines().all(|line| line.len() <= 80),
        "{text}"
    );
}

/// A length and an angle that the scene gives are not worked out again; between other points of the link they are.
#[test]
fn what_a_scene_gives_is_not_worked_out() {
    let scene = |place: &str| {
        format!(
            "unit = \"mm\"\n[ground]\nA = [0, 0]\nD = [400, 0]\nG = [700, 200]\n[driver]\nlink = \"r2\"\nangle = 60\n\
             [links]\nr2 = {{ from = \"A\", to = \"B\", length = 100 }}\n\
             r3 = {{ from = \"B\", to = \"C\", length = 300 }}\n\
             r4 = {{ from = \"D\", to = \"C\", length = 250, points = {{ E = {place} }} }}\n\
             r5 = {{ from = \"E\", to = \"F\", length = 400 }}\nr6 = {{ from = \"F\", to = \"G\", length = 450 }}\n\
             [start]\nC = [310, 230]\nF = [500, 500]\n[vectors]\nrd = [\"D\", \"E\"]\n"
        )
    };
    let worked = |place| {
        let heard = run(command(&["explain", "-"]).write_stdin(scene(place)));
        assert_eq!(heard.code, 0, "{}", heard.err);
        heard.out
    };
    let told = "rd = sqrt(55.6231^2 + 171.19^2) = 180.000 mm";
    // That of the ground is worked out either way.
    let ground = "from the coordinates of the points";
    let given = worked("{ from = \"D\", length = 180, angle = 72 }");
    assert!(
        !given.contains("rd = sqrt(") && given.contains(ground),
        "{given}"
    );
    let listed = worked("[55.6231, 171.19]");
    assert!(listed.contains(told), "{listed}");
}

#[test]
fn digits_are_as_asked() {
    let text = done(&["explain", "four-bar", "--digits", "10"]);
    assert!(
        text.contains("  m = sqrt(mx^2 + my^2) = 360.5551275 mm\n"),
        "{text}"
    );
    assert!(refused(2, &["explain", "four-bar", "--digits", "0"]).contains("1..=17"));
}

#[test]
fn greek_letters_stand_where_the_locale_has_them() {
    let mut utf8 = command(&["explain", "four-bar"]);
    let utf8 = utf8
        .env("LC_ALL", "en_US.UTF-8")
        .env("TERM", "xterm-256color");
    let heard = run(utf8);
    assert_eq!((heard.code, heard.err.as_str()), (0, ""));
    assert!(
        heard
            .out
            .contains("  θ3 = -α + β = -13.8979 + 43.2773 = 29.3794 deg\n"),
        "{}",
        heard.out
    );
}

#[test]
fn markdown_has_headings_tables_and_formulas() {
    let text = done(&["explain", "four-bar", "--format", "markdown"]);
    assert!(text.starts_with("# Four-bar crank-rocker\n\n"), "{text}");
    for piece in [
        "\n## 1 Vector polygons\n",
        "\n```text\nr1 + r2 + r3 + r4 = 0\n```\n",
        "\n| vector | from, to | r \\[mm\\] | r is | theta \\[deg\\] | theta is |\n| --- | ---: |",
        "\n### 4.2 Group 2, dyad RRR at C: links r3, r4\n",
    ] {
        assert!(text.contains(piece), "{piece}:\n{text}");
    }
    assert_eq!(text.matches("```").count() % 2, 0);
}

#[test]
fn a_file_is_written() {
    let file = folder("explain").join("four-bar.md");
    let path = file.to_str().unwrap();
    assert_eq!(
        done(&["explain", "four-bar", "--format", "markdown", "-o", path]),
        ""
    );
    let written = std::fs::read_to_string(&file).unwrap();
    assert_eq!(
        written,
        done(&["explain", "four-bar", "--format", "markdown"])
    );
}

/// What can still be said is said, and then why there is no more.
#[test]
fn outside_the_range_the_code_is_1() {
    let heard = krank(&["explain", "double-rocker", "--at", "200"]);
    assert_eq!(heard.code, 1);
    assert!(heard.out.contains("State: no-assembly."), "{}", heard.out);
    assert!(
        heard.err.contains("cannot be assembled at 200 deg"),
        "{}",
        heard.err
    );
}

#[test]
fn the_other_assembly_has_its_own_working() {
    let text = done(&["explain", "four-bar", "--assembly", "C=-"]);
    assert!(text.contains("C lies to the right of B -> D"), "{text}");
    assert!(text.contains("  theta3 = -alpha - beta = "), "{text}");
}
