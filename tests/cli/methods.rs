//! Tests of `explain --method`: iterations, halvings, drawings and invalid guesses.

use super::{command, folder, krank, refused, run, run_ok};

/// Returns the cells of the table below a heading.
fn table(text: &str, head: &str) -> Vec<Vec<String>> {
    let lines = text
        .lines()
        .skip_while(|line| !line.trim_start().starts_with(head));
    let rows = lines.skip(1).take_while(|line| !line.trim().is_empty());
    // Skips the row of units below the names.
    let rows = rows.filter(|row| !row.trim_start().starts_with("deg"));
    rows.map(|row| row.split_whitespace().map(str::to_owned).collect())
        .collect()
}

/// Reference values were computed independently in Python: Cramer's rule on the two equations.
#[test]
fn newton_table_matches_independent_iteration() {
    let text = run_ok(&[
        "explain",
        "four-bar",
        "--method",
        "newton",
        "--guess",
        "r3=20,r4=280",
    ]);
    let expected = [
        "0 20.0000 280.000 -24.6802 -56.9934 10.0538 9.9335 1.9e-1",
        "1 30.0538 289.934 -5.1010 1.8242 -0.6701 0.8152 1.4e-2",
        "2 29.3837 290.749 -2.7e-2 1.4e-2 -4.3e-3 3.8e-3 7.4e-5",
        "3 29.3794 290.753 -9.2e-7 1.1e-7 -8.3e-8 1.7e-7 3.0e-9",
    ];
    let rows = table(&text, "k   theta3");
    assert_eq!(rows.len(), 5, "{text}");
    for (row, expected) in rows.iter().zip(expected) {
        assert_eq!(row.join(" "), expected);
    }
    assert_eq!(rows[4][..5].join(" "), "4 29.3794 290.753 0 0");
    let determinants = table(&text, "k  dfx/dtheta3");
    assert_eq!(determinants[0][5], "-73860.6");
    assert!(
        text.contains("It converges in 4 steps, to the assembly of this motion."),
        "{text}"
    );
    assert!(text.contains("\nerror over iteration\n"), "{text}");
}

#[test]
fn outcome_of_a_bad_guess_is_explained() {
    for (guess, end) in [
        ("r3=-60,r4=40", "to another assembly"),
        ("r3=20,r4=200", "It ends after 0 steps: J is singular there"),
        ("r3=20,r4=20", "It ends after 0 steps: J is singular there"),
        ("r3=20,r4=199.99", "It diverges: after 1 step "),
    ] {
        let text = run_ok(&[
            "explain", "four-bar", "--method", "newton", "--guess", guess,
        ]);
        assert!(text.contains(end), "{guess}: {text}");
    }
    // At a dead point each step only halves the error.
    let check = run_ok(&["check", "double-rocker", "--format", "json"]);
    let place = super::json(&check)["dead_points"][0].as_f64().unwrap();
    let at = place.to_string();
    let text = run_ok(&[
        "explain",
        "double-rocker",
        "--method",
        "newton",
        "--at",
        &at,
    ]);
    assert!(text.contains("at a dead point J is singular at"), "{text}");
}

/// Reference values of f(theta3) = (350 - 300 cos)^2 + (-86.6025 - 300 sin)^2 - 250^2 at the
/// midpoints were computed in Python.
#[test]
fn bisection_keeps_the_half_with_the_sign_change() {
    let guess = ["explain", "four-bar", "--method", "bisection", "--guess"];
    let text = run_ok(&[&guess[..], &["r3=0..90"]].concat());
    let rows = table(&text, "k  a");
    let expected = [
        "0 0 90.0000 45.0000 45749.9 2.7e-1",
        "1 0 45.0000 22.5000 -16629.9 1.2e-1",
        "2 22.5000 45.0000 33.7500 11759.7 7.6e-2",
        "3 22.5000 33.7500 28.1250 -3208.97 2.2e-2",
    ];
    for (row, expected) in rows.iter().zip(expected) {
        assert_eq!(row.join(" "), expected);
    }
    assert!(
        text.contains(
            "theta3 = 29.3794 deg\n  theta4 = atan2(my - r3 sin(theta3), mx - r3 cos(theta3)) = 290.753 deg\n"
        ),
        "{text}"
    );
    assert!(
        text.contains("This root is the assembly of this motion."),
        "{text}"
    );
    let other = run_ok(&[&guess[..], &["r3=-90..0"]].concat());
    assert!(
        other.contains("This root is the other assembly."),
        "{other}"
    );
    let none = run_ok(&[&guess[..], &["r3=40..90"]].concat());
    assert!(none.contains("f has the same sign at both ends"), "{none}");
}

#[test]
fn graphical_method_prints_scale_and_reading_accuracy() {
    let text = run_ok(&["explain", "four-bar", "--method", "graphical"]);
    for piece in [
        "an A4 sheet at 1:2.",
        "Draw a circle about B with r3 = 300.000 mm (150.0 mm on paper).",
        "Draw a circle about D with r4 = 250.000 mm (125.0 mm on paper).",
    ] {
        assert!(text.contains(piece), "{piece}: {text}");
    }
    // By the law of cosines with m^2 = 130000, the circles cross at 180 - beta - gamma = 81.37 deg.
    assert!(
        text.contains("They cross at 81.4 deg, so C is known to 0.4 mm."),
        "{text}"
    );
    let read = table(&text, "unknown");
    assert_eq!(read[0][..2], ["theta3", "deg"]);
    assert_eq!(read[0].last().unwrap(), "29.3794");
}

#[test]
fn coupled_groups_explain_unavailable_methods() {
    for (method, why) in [
        ("bisection", "Not by bisection: it has 4 coupled unknowns"),
        (
            "graphical",
            "Not by compass and ruler: it has 4 coupled unknowns",
        ),
        ("newton", "It converges in"),
    ] {
        let text = run_ok(&["explain", "stephenson-six-bar", "--method", method]);
        assert!(text.contains(why), "{text}");
    }
}

#[test]
fn invalid_guesses_are_rejected_with_a_fix() {
    let of = |scene: &str, method: &str, guess: &str| {
        refused(2, &["explain", scene, "--method", method, "--guess", guess])
    };
    for (scene, method, guess, output) in [
        ("four-bar", "newton", "q3=20", "no vector is named `q3`"),
        (
            "four-bar",
            "newton",
            "r2=20",
            "`r2` is given, or follows from the driver; the unknowns are r3, r4",
        ),
        (
            "four-bar",
            "newton",
            "r3=20mm",
            "write the guess of `r3` in deg",
        ),
        (
            "four-bar",
            "newton",
            "r3=0..90",
            "r3=FROM..TO is for bisection",
        ),
        ("four-bar", "newton", "r3=1,r3=2", "given twice"),
        ("four-bar", "newton", "r3", "write NAME=VALUE"),
        (
            "four-bar",
            "closed",
            "r3=20",
            "--guess: `r3`: this method uses no guess; use Newton-Raphson or bisection",
        ),
        (
            "slotted-lever",
            "newton",
            "r3=20",
            "both length and angle of `r3` are unknown",
        ),
    ] {
        let err = of(scene, method, guess);
        assert!(err.contains(output), "{guess}: {err}");
    }
    let args = [
        "explain",
        "slotted-lever",
        "--method",
        "newton",
        "--guess",
        "r3=20cm,r4=80",
    ];
    let text = run_ok(&args);
    assert!(
        text.contains("From the guess theta4 = 80 deg, r3 = 200 mm:")
            || text.contains("From the guess r3 = 200 mm, theta4 = 80 deg:"),
        "{text}"
    );
}

/// Lines have at most 80 columns and no trailing spaces, and `closed` equals the default.
#[test]
fn every_method_explains_every_preset() {
    for name in super::presets() {
        for method in ["newton", "bisection", "graphical"] {
            let text = run_ok(&["explain", &name, "--method", method]);
            assert!(text.is_ascii(), "{name} {method}");
            assert!(
                text.lines().all(|l| l.len() <= 80 && l.trim_end() == l),
                "{name} {method}: {text}"
            );
        }
        assert_eq!(
            run_ok(&["explain", &name, "--method", "closed"]),
            run_ok(&["explain", &name])
        );
    }
}

#[test]
fn position_outside_motion_exits_with_1() {
    for method in ["newton", "bisection", "graphical"] {
        let output = krank(&[
            "explain",
            "double-rocker",
            "--method",
            method,
            "--at",
            "200",
        ]);
        assert_eq!(output.code, 1, "{method}");
        assert!(output.out.contains("State: no-assembly."), "{}", output.out);
        assert!(
            !output.out.contains("assembly of this motion"),
            "{}",
            output.out
        );
    }
}

#[test]
fn markdown_has_tables_and_a_fenced_chart() {
    let file = folder("methods").join("newton.md");
    let path = file.to_str().unwrap();
    let mut args = command(&[
        "explain", "four-bar", "--method", "newton", "--format", "markdown",
    ]);
    let output = run(args.args(["--at", "200", "-o", path]));
    assert_eq!((output.code, output.out.as_str()), (0, ""));
    let written = std::fs::read_to_string(&file).unwrap();
    assert!(written.contains("\n| k | theta3 \\[deg\\] |"), "{written}");
    assert!(
        written.contains("```text\nerror over iteration\n"),
        "{written}"
    );
    assert_eq!(written.matches("```").count() % 2, 0);
}
