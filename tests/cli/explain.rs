//! Tests of `explain`: the working of one state, as text and as Markdown.

use super::{command, folder, krank, refused, run, run_ok};

#[test]
fn default_position_is_the_scenes_initial_position() {
    let text = run_ok(&["explain", "four-bar"]);
    assert_eq!(text, run_ok(&["explain", "four-bar", "--at", "60"]));
    assert!(text.starts_with("Four-bar crank-rocker\n---"), "{text}");
    assert!(text.contains("\n  r1 + r2 + r3 + r4 = 0\n"), "{text}");
    assert!(
        text.is_ascii() && text.lines().all(|line| line.len() <= 80),
        "{text}"
    );
}

/// Does not derive a length or an angle given by the scene, but derives those between other points of the link.
#[test]
fn given_lengths_and_angles_are_not_derived() {
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
    let computed = |place| {
        let output = run(command(&["explain", "-"]).write_stdin(scene(place)));
        assert_eq!(output.code, 0, "{}", output.err);
        output.out
    };
    let printed = "rd = sqrt(55.6231^2 + 171.19^2) = 180.000 mm";
    // The ground vector is derived in both cases.
    let ground = "from the coordinates of the points";
    let given = computed("{ from = \"D\", length = 180, angle = 72 }");
    assert!(
        !given.contains("rd = sqrt(") && given.contains(ground),
        "{given}"
    );
    let listed = computed("[55.6231, 171.19]");
    assert!(listed.contains(printed), "{listed}");
}

#[test]
fn digits_option_sets_significant_digits() {
    let text = run_ok(&["explain", "four-bar", "--digits", "10"]);
    assert!(
        text.contains("  m = sqrt(mx^2 + my^2) = 360.5551275 mm\n"),
        "{text}"
    );
    assert!(refused(2, &["explain", "four-bar", "--digits", "0"]).contains("1..=17"));
}

#[test]
fn utf8_locale_uses_greek_letters() {
    let mut utf8 = command(&["explain", "four-bar"]);
    let utf8 = utf8
        .env("LC_ALL", "en_US.UTF-8")
        .env("TERM", "xterm-256color");
    let output = run(utf8);
    assert_eq!((output.code, output.err.as_str()), (0, ""));
    assert!(
        output
            .out
            .contains("  θ3 = -α + β = -13.8979 + 43.2773 = 29.3794 deg\n"),
        "{}",
        output.out
    );
}

#[test]
fn markdown_has_headings_tables_and_formulas() {
    let text = run_ok(&["explain", "four-bar", "--format", "markdown"]);
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
fn output_file_equals_standard_output() {
    let file = folder("explain").join("four-bar.md");
    let path = file.to_str().unwrap();
    assert_eq!(
        run_ok(&["explain", "four-bar", "--format", "markdown", "-o", path]),
        ""
    );
    let written = std::fs::read_to_string(&file).unwrap();
    assert_eq!(
        written,
        run_ok(&["explain", "four-bar", "--format", "markdown"])
    );
}

/// Prints as much of the working as exists, followed by the cause of the end.
#[test]
fn position_outside_range_exits_with_1_and_partial_working() {
    let output = krank(&["explain", "double-rocker", "--at", "200"]);
    assert_eq!(output.code, 1);
    assert!(output.out.contains("State: no-assembly."), "{}", output.out);
    assert!(
        output.err.contains("cannot be assembled at 200 deg"),
        "{}",
        output.err
    );
}

#[test]
fn other_assembly_has_its_own_working() {
    let text = run_ok(&["explain", "four-bar", "--assembly", "C=-"]);
    assert!(text.contains("C lies to the right of B -> D"), "{text}");
    assert!(text.contains("  theta3 = -alpha - beta = "), "{text}");
}
