//! Tests the report: it contains the lectures' values, and all of its formats are well-formed.

use krank::page::{Content, Row, Table};
use krank::report::{Report, ReportFormat};
use krank::scene::{Scene, presets};
use krank::solver::{Order, Solver};

/// Returns the report on a scene at a coordinate, by default where it opens.
fn report(text: &str, at: Option<f64>, digits: usize) -> Report {
    let scene = Scene::parse(text, "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let mut state = solver.state();
    let at = at.unwrap_or(scene.mechanism.driver().start);
    let _ = solver.solve(at, Order::Force, &mut state);
    solver.enclose(&mut state, Order::Force, &mut solver.enclosure());
    Report::new(&scene, &solver, &state, digits)
}

fn of_preset(name: &str, digits: usize) -> Report {
    report(presets::find(name).unwrap().text, None, digits)
}

/// A value printed by the lecture, its error, and the text in the report.
type LectureValue = (f64, f64, &'static str);

/// Weeks 3 and 7.
const FOUR_BAR: [LectureValue; 20] = [
    (360.555_12, 8.1e-6, "m = sqrt(mx^2 + my^2) = 360.555128 mm"),
    (13.897_841, 4.6e-5, "α = atan2(-my, mx) = 13.8978862 deg"),
    (43.277_343, 9.1e-6, "= 43.2773340 deg"),
    (55.349_599, 6.6e-6, "= 55.3495925 deg"),
    (29.379_5, 5.3e-5, "θ3 = 29.3794478"),
    (29.38, 5.6e-4, "θ3 = 29.3794478"),
    (290.752_0, 5.3e-4, "θ4 = 290.752521"),
    (290.75, 2.6e-3, "θ4 = 290.752521"),
    (-3.916, 4.2e-4, "ω3 = -3.91641273"),
    (3.091, 7.4e-5, "ω4 = 3.09107322"),
    (42.27, 3e-3, "α3 = 42.2670183"),
    (95.5, 3.7e-3, "α4 = 95.5036084"),
    (23_875.0, 0.91, "aCt = α4 r = 95.5036084·250 = 23875.9021"),
    (
        2_388.57,
        0.12,
        "aCn = ω4^2 r = 3.09107322^2·250 = 2388.68341",
    ),
    (
        23_994.18,
        0.92,
        "aC = sqrt(23875.9021^2 + 2388.68341^2) = 23995.0934",
    ),
    (206.47, 4.3e-3, "206.465712"),
    (84.28, 6.9e-3, "84.2868095"),
    (22_260.0, 0.23, "22260.2239"),
    (222.68, 2.3e-3, "222.677773"),
    (11_997.09, 0.46, "11997.5467"),
];

/// Week 4. Omits the second root, whose error exceeds any rounding: the roots' sum is 17.32.
const SLIDER_CRANK: [LectureValue; 7] = [
    (28.0, 0.026, "r4 = 28.0251708"),
    (-14.47, 7.6e-3, "-14.4775122"),
    (345.5, 0.023, "θ3 = 345.522488"),
    (-89.45, 7.3e-3, "ω3 = -89.4427191"),
    (-1_447.93, 0.72, "dr4/dt = -1447.21360"),
    (8_259.0, 3.4, "α3 = 8262.36447"),
    (-459_977.6, 41.0, "d2r4/dt2 = -460017.673"),
];

/// Returns the last number of a text.
fn number(text: &str) -> f64 {
    let words = text.split(' ').rev();
    words.map(str::parse).find_map(Result::ok).unwrap()
}

#[test]
fn report_contains_every_value_of_the_lectures() {
    for (name, printed) in [
        ("four-bar", &FOUR_BAR[..]),
        ("slider-crank", &SLIDER_CRANK[..]),
    ] {
        let text = of_preset(name, 9).written(ReportFormat::Text, false);
        // Long formulas continue on the next line.
        let text: Vec<&str> = text.split_whitespace().collect();
        let text = text.join(" ");
        for &(printed, off, exact) in printed {
            assert!(text.contains(exact), "{name}: {exact}");
            let by = (printed - number(exact)).abs();
            assert!(
                by <= off && by > 0.85 * off,
                "{name}: {exact} is off by {by:e}"
            );
        }
    }
    let text = of_preset("four-bar", 9).written(ReportFormat::Text, false);
    assert!(text.contains("B       1500.00000  150.000000  22500.0000  240.000000"));
    for piece in [
        "μ(θ) = cos(θ) i + sin(θ) j",
        "Multiplied by ν(θ3)",
        "Multiplied by μ(θ4)",
        "A sin(θ4) + B cos(θ4) + C sin(θ3) cos(θ4) - C cos(θ3) sin(θ4) = 0",
        "A = -r1 cos(θ1) - r2 cos(θ2) = 400 - 50.0000000 = 350.000000 mm",
        "ω3 = -r2 ω2 sin(θ4 - θ2)/(r3 sin(θ4 - θ3))",
        "θ_aC = θ4 - β = 290.752521 - 84.2868095 = 206.465712 deg",
        "x = xB + t cos(β)",
    ] {
        assert!(text.contains(piece), "{piece}");
    }
}

/// Returns the cells of a table of a loop; `None` for other tables.
fn cells(table: &Table) -> Option<Vec<&str>> {
    let rows = table.rows.iter().map(|row| match row {
        Row::Figures { cells, .. } => Some(cells.iter().flatten().map(|cell| cell.text.as_str())),
        Row::Part(_) | Row::Told { .. } => None,
    });
    let rows: Option<Vec<_>> = rows.collect();
    let cells: Vec<&str> = rows?.into_iter().flatten().collect();
    cells
        .iter()
        .any(|cell| cell.contains(" = "))
        .then_some(cells)
}

#[test]
fn question_marks_stand_exactly_for_values_found_later() {
    for preset in presets::all() {
        let report = of_preset(preset.name, 6);
        let tables = report
            .page
            .blocks
            .iter()
            .filter_map(|block| match &block.content {
                Content::Table(table) => {
                    cells(table).map(|cells| (&table.title, &table.heads, cells))
                }
                _ => None,
            });
        let is_asked = |cells: &[&str]| cells.iter().any(|cell| cell.ends_with(" = ?"));
        let (requested, output): (Vec<_>, Vec<_>) =
            tables.partition(|(_, _, cells)| is_asked(cells));
        assert_eq!(requested.len(), output.len(), "{}", preset.name);
        // The open chain of the robot arm has no loop, and so no unknown.
        let minimum = if preset.name == "robot-arm" { 0 } else { 3 };
        assert!(
            requested.len() >= minimum,
            "{}: {}",
            preset.name,
            requested.len()
        );
        for (requested, output) in requested.iter().zip(&output) {
            assert_eq!(
                (requested.0, requested.1),
                (output.0, output.1),
                "{}",
                preset.name
            );
            for (before, after) in requested.2.iter().zip(&output.2) {
                match before.strip_suffix(" = ?") {
                    Some(symbol) => {
                        let value = after
                            .strip_prefix(symbol)
                            .and_then(|v| v.strip_prefix(" = "));
                        assert!(value.unwrap().parse::<f64>().is_ok(), "{after}");
                    }
                    // A value found by another loop.
                    None if before.starts_with("from loop ") => {
                        let value = after.split_once(" = ").map(|(_, value)| value);
                        assert!(value.unwrap().parse::<f64>().is_ok(), "{after}");
                    }
                    None => assert_eq!(before, after, "{}", preset.name),
                }
            }
        }
    }
}

/// Checks that elements are closed in order and that no text is read as markup.
fn is_well_formed(document: &str) -> Result<(), String> {
    let mut open = Vec::new();
    let mut rest = document.strip_prefix("<!DOCTYPE html>").ok_or("no type")?;
    while let Some(at) = rest.find('<') {
        let end = rest[at..].find('>').ok_or("an open tag")?;
        let tag = &rest[at + 1..at + end];
        let name = tag
            .trim_start_matches('/')
            .split([' ', '/'])
            .next()
            .unwrap();
        if tag.starts_with('/') {
            if open.pop() != Some(name) {
                return Err(format!("</{name}> closes {open:?}"));
            }
        } else if !tag.ends_with('/') {
            open.push(name);
        }
        if tag.matches('"').count() % 2 == 1 || tag.contains('<') {
            return Err(tag.to_owned());
        }
        let inside = &rest[..at];
        // A lone bracket, or an ampersand without an entity.
        if inside.contains('>') || inside.split('&').skip(1).any(|s| !s.contains(';')) {
            return Err(inside.to_owned());
        }
        rest = &rest[at + end + 1..];
    }
    if !open.is_empty() || document.chars().any(|c| c.is_control() && c != '\n') {
        return Err(format!("{open:?}"));
    }
    Ok(())
}

#[test]
fn html_is_well_formed_and_self_contained() {
    for preset in presets::all() {
        let html = of_preset(preset.name, 6).written(ReportFormat::Html, false);
        assert_eq!(is_well_formed(&html), Ok(()), "{}", preset.name);
        for outside in [
            "<script", "src=", "href=", "url(", "@import", "NaN", "inf\"",
        ] {
            assert!(!html.contains(outside), "{}: {outside}", preset.name);
        }
        assert!(html.matches("<svg ").count() >= 4, "{}", preset.name);
        assert!(html.contains("<i>θ</i><sub>"), "{}", preset.name);
    }
}

#[test]
fn checkers_reject_malformed_html_and_latex() {
    let page = |inside: &str| format!("<!DOCTYPE html>{inside}");
    assert_eq!(is_well_formed(&page("<p>a &lt; b<br/></p>")), Ok(()));
    for bad in [
        "<p>",
        "<i><b></i></b>",
        "<p a=\"></p>",
        "<p>\u{1b}</p>",
        "<p>a & b</p>",
        "a > <p></p>",
    ] {
        assert!(is_well_formed(&page(bad)).is_err(), "{bad}");
    }
    assert!(check_latex("\\begin{a}{x\\}}\\end{a}").is_ok());
    for bad in ["{", "}", "\\begin{a}\\end{b}", "\\begin{a}", "$x"] {
        assert!(check_latex(bad).is_err(), "{bad}");
    }
}

/// Checks that braces and environments are closed in order, and that no special character is
/// unescaped.
fn check_latex(text: &str) -> Result<(), String> {
    let mut open: Vec<String> = Vec::new();
    let mut depth = 0_usize;
    let mut chars = text.char_indices();
    let named = |after: &str| after.split('}').next().unwrap().to_owned();
    while let Some((at, c)) = chars.next() {
        match c {
            '\\' => {
                let after = &text[at + 1..];
                if let Some(name) = after.strip_prefix("begin{") {
                    open.push(named(name));
                } else if let Some(name) = after.strip_prefix("end{")
                    && open.pop() != Some(named(name))
                {
                    return Err(format!("{} closes {open:?}", named(name)));
                }
                chars.next();
            }
            '{' => depth += 1,
            '}' => depth = depth.checked_sub(1).ok_or(format!("a brace at {at}"))?,
            '$' | '%' | '#' if !text[at + 1..].starts_with('1') => {
                return Err(format!("{c} at {at}"));
            }
            _ => {}
        }
    }
    match depth == 0 && open.is_empty() {
        true => Ok(()),
        false => Err(format!("{depth} braces and {open:?} are open")),
    }
}

#[test]
fn latex_is_balanced_and_uses_known_packages() {
    for preset in presets::all() {
        let tex = of_preset(preset.name, 6).written(ReportFormat::Latex, false);
        assert_eq!(check_latex(&tex), Ok(()), "{}", preset.name);
        for package in tex.lines().filter(|line| line.starts_with("\\usepackage")) {
            let known = ["inputenc", "amsmath", "tikz"];
            assert!(known.iter().any(|name| package.contains(name)), "{package}");
        }
        assert!(
            tex.matches("\\begin{tikzpicture}").count() >= 4,
            "{}",
            preset.name
        );
        assert!(!tex.contains("NaN"), "{}", preset.name);
    }
}

#[test]
fn scene_texts_are_escaped_in_html_and_latex() {
    let four_bar = presets::find("four-bar").unwrap().text;
    let name = "<script>alert(1)</script> & \\input{secret} $x^2$ 50% #1 ~ 字";
    let renamed = format!("name = '{name}'\n");
    let start = four_bar.find("name").unwrap();
    let end = start + four_bar[start..].find('\n').unwrap() + 1;
    let text = format!("{}{renamed}{}", &four_bar[..start], &four_bar[end..]);
    let report = report(&text, None, 6);
    let html = report.written(ReportFormat::Html, false);
    assert_eq!(is_well_formed(&html), Ok(()));
    assert!(!html.contains("<script"), "{html}");
    assert!(html.contains("&lt;script&gt;alert(1)&lt;/script&gt; &amp; \\input"));
    let tex = report.written(ReportFormat::Latex, false);
    assert_eq!(check_latex(&tex), Ok(()));
    assert!(!tex.contains("\\input{secret"), "{tex}");
    assert!(tex.contains("\\textbackslash{}input\\{secret\\}"), "{tex}");
}

/// A report contains what exists without an assembly and at a dead point.
#[test]
fn report_is_valid_without_assembly_and_at_dead_point() {
    let rocker = presets::find("double-rocker").unwrap().text;
    let scene = Scene::parse(rocker, "test").unwrap();
    let dead = Solver::new(&scene.mechanism).unwrap().motion().dead_points[0];
    for at in [200.0, dead] {
        let report = report(rocker, Some(at), 6);
        let text = report.written(ReportFormat::Text, false);
        assert!(text.contains(" = ?"), "{text}");
        assert_eq!(
            is_well_formed(&report.written(ReportFormat::Html, false)),
            Ok(())
        );
        assert_eq!(
            check_latex(&report.written(ReportFormat::Latex, false)),
            Ok(())
        );
    }
}

/// The forces on a free body, including inertia, are in equilibrium about any point, and each link
/// of a scene with forces has a picture in its own section.
#[test]
fn free_bodies_are_in_equilibrium_and_drawn() {
    let mut drawn = 0;
    for preset in presets::all() {
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        if !solver.has_forces() {
            continue;
        }
        let working = krank::report::Working::new(&scene, &solver);
        let mut state = solver.state();
        let (low, high) = solver.motion().range.ends();
        for k in 1..8 {
            let at = low + (high - low) * (f64::from(k) - 0.37) / 8.0;
            let _ = solver.solve(at, Order::Force, &mut state);
            for link in scene.mechanism.link_ids() {
                let all = working.on_link(&scene, &solver, &state, link);
                let about = krank::Vec2::new(17.0, -45.0);
                let metres = scene.unit.metres();
                let (mut force, mut moment) = (krank::Vec2::ZERO, 0.0);
                let (mut size, mut lever) = (0.0_f64, 0.0_f64);
                for one in &all {
                    let arm = one.at.map_or(krank::Vec2::ZERO, |at| (at - about) * metres);
                    force += one.force;
                    moment += arm.cross(one.force) + one.couple;
                    size = size.max(one.force.norm());
                    lever = lever.max(arm.norm() * one.force.norm() + one.couple.abs());
                }
                let context = format!("{} at {at}, {}", preset.name, scene.link_name(link));
                assert!(all.len() > 1, "{context}: {all:?}");
                assert!(
                    force.norm() <= 1e-12 * size,
                    "{context}: {force:?} of {size}"
                );
                assert!(
                    moment.abs() <= 1e-12 * lever,
                    "{context}: {moment} of {lever}"
                );
            }
        }
        // With several inputs, the report refers to the table of forces.
        if scene.mechanism.inputs().count() > 1 {
            continue;
        }
        let blocks = of_preset(preset.name, 6).page.blocks;
        for link in scene.mechanism.link_ids() {
            let end = format!(" Link {}", scene.link_name(link));
            let starts = |content: &Content| matches!(content, Content::Heading(2, text) if text.ends_with(&end));
            let at = blocks
                .iter()
                .position(|block| starts(&block.content))
                .unwrap();
            let Content::Picture(picture) = &blocks[at + 1].content else {
                panic!("{}: {:?}", preset.name, blocks[at + 1].content);
            };
            let text = picture.characters.join("\n");
            assert!(text.contains(" N"), "{text}");
            drawn += 1;
        }
    }
    assert!(drawn > 15, "{drawn}");
}

/// Only a mark distinguishes the unit of seconds from a length named `s`, so that every unit of a
/// formula must have one.
#[test]
fn units_are_upright_and_names_are_italic() {
    // Units follow decimals; a name after an integer is a factor.
    let is_decimal = |text: &str| {
        let rest = text.trim_end_matches(|c: char| c.is_ascii_digit());
        rest.len() < text.len() && rest.ends_with('.')
    };
    for preset in presets::all() {
        let html = of_preset(preset.name, 6).page.to_html();
        assert!(!html.contains('\u{e000}'), "{}", preset.name);
        for unit in [
            " <i>s</i>",
            " <i>W</i>",
            " <i>N</i>",
            " <i>mm</i>",
            " <i>rad</i>",
        ] {
            // A name has a subscript.
            let is_name = |at: usize| html[at + unit.len()..].starts_with("<sub>");
            let all = html.match_indices(unit).map(|(at, _)| at);
            let behind_numbers = all.filter(|&at| is_decimal(&html[..at]) && !is_name(at));
            assert_eq!(behind_numbers.count(), 0, "{unit} in {}", preset.name);
        }
    }
    let lever = include_str!("slide-named-s.toml");
    let page = report(lever, Some(60.0), 6).page;
    let latex = page.to_latex();
    assert!(
        latex.contains(
            "\\omega _{\\text{4}} = -r_{\\text{2}}\\,\\penalty900 \\omega _{\\text{2}}\\,\\penalty900 \
             \\cos (\\theta _{\\text{2}} - \\theta _{\\text{s}})/\\penalty900 s ="
        ),
        "{latex}"
    );
    assert!(latex.contains("2.81990\\ \\penalty900 \\text{rad}/\\penalty900 \\text{s}"));
    assert!(latex.contains("\\(r_{\\text{2}}\\) + \\(s\\) - \\(r_{\\text{1}}\\) = 0, to scale"));
    assert!(latex.contains(" & \\(r_{\\text{2}}\\) & \\(s\\) & \\(r_{\\text{1}}\\) \\\\"));
    // Plain text has no marks.
    let text = page.to_text(krank::page::TextStyle {
        ascii: false,
        width: 200,
    });
    assert!(
        text.contains("/s = -50·10·cos(60 - 261.296)/165.204 = 2.81990 rad/s"),
        "{text}"
    );
    assert!(!text.contains('\u{e000}'));
}
