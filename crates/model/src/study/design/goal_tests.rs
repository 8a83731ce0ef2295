//! Tests searches for goals against closed formulas, which are written out here.

use super::tests::{axes, figures, goals, space, stroke};
use super::{GoalSearch, PlanAxis, SearchOutcome};

/// One length and one goal: the stroke of the in-line slider-crank is twice the crank's length.
#[test]
fn search_finds_crank_length_for_stroke() {
    let space = space("slider-crank", &["r2 length"]);
    let search = figures(&space, &["r4.length.stroke"]);
    let goals = goals(&space, &["r4.length.stroke = 13"]);
    let search = GoalSearch::new(search, goals, &axes(&["r2"]));
    let outcome = search.run(4, 1, 2, &mut |_| true);
    assert_eq!(outcome.solutions.len(), 1, "{outcome:?}");
    assert!(
        (outcome.solutions[0].numbers[0] - 6.5).abs() < 1e-9,
        "{outcome:?}"
    );
}

/// Two goals and a constraint: stroke and time ratio of an offset slider-crank, by crank and
/// offset. At the dead centres, crank and rod are in line, at an angle to the guide with
/// sin = e / (l +- r).
#[test]
fn search_meets_stroke_and_time_ratio_together() {
    let space = space("offset-slider-crank", &["r2 length", "r4 through y"]);
    let names = [
        "r4.length.stroke = 120",
        "r4.length.ratio = 1.1",
        "transmission >= 30",
    ];
    let goals = goals(&space, &names);
    let search = figures(
        &space,
        &["r4.length.stroke", "r4.length.ratio", "transmission"],
    );
    let l = space
        .scene()
        .values()
        .into_iter()
        .find(|v| v.name == "r3 length")
        .unwrap()
        .number;
    let search = GoalSearch::new(search, goals, &axes(&["r2", "e"]));
    let outcome = search.run(16, 1, 2, &mut |_| true);
    // One solution with the offset to either side.
    assert_eq!(outcome.solutions.len(), 2, "{outcome:?}");
    for found in &outcome.solutions {
        let [r, e] = found.numbers[..] else { panic!() };
        assert!((stroke(r, l, e) - 120.0).abs() < 1e-6, "{r} {e}");
        let between = ((e / (l + r)).asin() - (e / (l - r)).asin())
            .abs()
            .to_degrees();
        let ratio = (180.0 + between) / (180.0 - between);
        assert!((ratio - 1.1).abs() < 1e-8, "{r} {e} {ratio}");
    }
    let offsets: Vec<f64> = outcome
        .solutions
        .iter()
        .map(|found| found.numbers[1])
        .collect();
    assert!((offsets[0] + offsets[1]).abs() < 1e-6, "{offsets:?}");
}

/// An unreachable goal has no solutions, but a nearest design.
#[test]
fn unreachable_goal_returns_nearest_design() {
    let space = space("slider-crank", &["r2 length"]);
    let goals = goals(&space, &["r4.length.stroke = 30"]);
    let search = figures(&space, &["r4.length.stroke"]);
    let search = GoalSearch::new(search, goals, &axes(&["r2=5..12"]));
    let outcome = search.run(3, 1, 2, &mut |_| true);
    assert!(outcome.solutions.is_empty());
    let nearest = outcome.nearest.unwrap();
    assert!((nearest.numbers[0] - 12.0).abs() < 1e-6, "{nearest:?}");
}

/// Goals of 0, 360 and -360 deg are the same direction. With r3 level, C is at (350, 50 sqrt 3),
/// and D on the ground at a distance of 250.
#[test]
fn direction_goal_is_met_modulo_360() {
    let space = space("four-bar", &["D x"]);
    let known = 350.0 + (250.0_f64.powi(2) - 7_500.0).sqrt();
    for options in ["r3.angle@60 = 0", "r3.angle@60 = 360", "r3.angle@60 = -360"] {
        let goals = goals(&space, &[options]);
        let search = figures(&space, &["r3.angle@60"]);
        let outcome = GoalSearch::new(search, goals, &axes(&["D.x"])).run(0, 1, 2, &mut |_| true);
        let found = outcome.solutions.first();
        let off = found.map(|found| (found.numbers[0] - known).abs());
        assert!(
            off.is_some_and(|off| off < 1e-5),
            "{options}: {outcome:?} {known}"
        );
    }
}

/// The given design is no solution if it lies outside the ends.
#[test]
fn search_stays_within_axis_ends() {
    let space = space("slider-crank", &["r2 length"]);
    let goals = goals(&space, &["r4.length.stroke <= 24"]);
    let search = figures(&space, &["r4.length.stroke"]);
    let search = GoalSearch::new(search, goals, &axes(&["r2=11..12"]));
    let outcome = search.run(3, 1, 2, &mut |_| true);
    assert!(!outcome.solutions.is_empty());
    for found in &outcome.solutions {
        assert!((11.0..=12.0).contains(&found.numbers[0]), "{outcome:?}");
    }
}

/// A longer crank that no longer turns fully also reaches the swing. It is a solution, marked as
/// such, and comes after those whose crank turns. The crank turns fully as long as
/// r2 + 400 < 300 + 250.
#[test]
fn solutions_report_whether_they_move_as_given() {
    let space = space("four-bar", &["r2 length"]);
    let goals = goals(&space, &["r4.angle.swing = 100"]);
    let found = |threads| {
        let search = figures(&space, &["r4.angle.swing"]);
        GoalSearch::new(search, goals.clone(), &axes(&["r2"])).run(24, 1, threads, &mut |_| true)
    };
    let outcome = found(1);
    assert!(!outcome.solutions.is_empty());
    for found in &outcome.solutions {
        let is_rotary = found.numbers[0] < 150.0;
        assert_eq!(found.is_same_motion_kind, is_rotary, "{:?}", found.numbers);
    }
    let kinds = outcome
        .solutions
        .iter()
        .map(|found| !found.is_same_motion_kind);
    assert!(kinds.is_sorted(), "those that move as given come first");
    // The result does not depend on the number of threads.
    let numbers = |outcome: &SearchOutcome| -> Vec<Vec<f64>> {
        let solutions = outcome.solutions.iter();
        solutions.map(|found| found.numbers.clone()).collect()
    };
    assert_eq!(numbers(&outcome), numbers(&found(3)));
}

/// One goal for two values leaves a family with one freedom. One for one and two for two leave
/// none; a bound leaves all.
#[test]
fn freedoms_count_parameters_of_solution_family() {
    let both = ["r4.length.stroke = 120", "r4.length.ratio = 1.1"];
    for (values, requests, freedoms) in [
        (vec!["r2 length"], &both[..1], 0),
        (vec!["r2 length", "r4 through y"], &both[..1], 1),
        (vec!["r2 length", "r4 through y"], &both[..], 0),
        (
            vec!["r2 length", "r3 length"],
            &["r4.length.stroke >= 20"],
            2,
        ),
    ] {
        let space = space("offset-slider-crank", &values);
        let requested = goals(&space, requests);
        let names: Vec<&str> = requested.iter().map(|goal| goal.figure.name()).collect();
        let axes: Vec<PlanAxis> = axes(&values.iter().map(|_| "v").collect::<Vec<_>>());
        let search = GoalSearch::new(figures(&space, &names), requested.clone(), &axes);
        let outcome = search.run(6, 1, 2, &mut |_| true);
        assert!(!outcome.solutions.is_empty(), "{values:?} {requests:?}");
        assert_eq!(outcome.freedoms(), freedoms, "{values:?} {requests:?}");
    }
}

/// Compares the derivatives of a stroke by crank, rod and offset with those of the closed formula.
/// The solver's own are accurate to all digits, those by differences to eight.
#[test]
fn derivatives_match_closed_formula() {
    let values = ["r2 length", "r3 length", "r4 through y"];
    let space = space("offset-slider-crank", &values);
    let requested = goals(&space, &["r4.length.stroke = 100"]);
    let axes = axes(&["r2=40..140", "r3=240..340", "e=-40..60"]);
    let mut search = GoalSearch::new(figures(&space, &["r4.length.stroke"]), requested, &axes);
    for numbers in [
        [80.0, 280.0, 20.0],
        [61.7, 301.3, -33.1],
        [99.9, 250.5, 1.25],
    ] {
        let [r, l, e] = numbers;
        let place = search.place(numbers.to_vec()).unwrap();
        let exact = search.slopes(&place).unwrap();
        let near = search.differences(&place).unwrap();
        let [far, close] = [l + r, l - r].map(|v| (v * v - e * e).sqrt());
        let known = [
            (l + r) / far + (l - r) / close,
            (l + r) / far - (l - r) / close,
            -e / far + e / close,
        ];
        // Misses are relative to the goal's size, numbers to the distance between their ends. Both are 100 here,
        // since the given stroke misses the goal by no more than that.
        for (i, known) in known.iter().enumerate() {
            let [exact, near] = [&exact, &near].map(|slopes| (slopes[(0, i)] - known).abs());
            assert!(
                exact < 1e-11,
                "{numbers:?} {i}: {known} is missed by {exact}"
            );
            assert!(near < 1e-8, "{numbers:?} {i}: {known} is missed by {near}");
        }
    }
    // Compares derivatives of a swing, of extrema and at a coordinate with differences.
    let values = ["r2 length", "r3 length", "D x"];
    let space = super::tests::space("four-bar", &values);
    let requests = [
        "r4.angle.swing = 40",
        "C.x.least = 10",
        "C.y.greatest <= 100",
        "C.x@60 = 300",
    ];
    let requested = goals(&space, &requests);
    let names: Vec<&str> = requested.iter().map(|goal| goal.figure.name()).collect();
    let axes = super::tests::axes(&["r2=90..110", "r3=290..320", "x=390..410"]);
    let mut search = GoalSearch::new(figures(&space, &names), requested.clone(), &axes);
    let place = search.place(vec![101.0, 303.0, 398.0]).unwrap();
    let places = search.figures.evaluate(&place.numbers).unwrap().places;
    let exact = search
        .figures
        .exact_slopes(&places.unwrap(), &place.numbers);
    assert!(exact.is_some());
    let distance = search.slopes(&place).unwrap() - search.differences(&place).unwrap();
    assert!(distance.amax() < 1e-7, "{distance}");
}

/// Numbers in formulas and transmission angles have derivatives at fixed places of the motion. They
/// are compared with differences of whole designs, where the worst angle is below and above 90 deg.
#[test]
fn derivatives_at_fixed_places_match_differences_of_designs() {
    let text = r#"
unit = "mm"
[parameters]
r = 100
c = 300
[ground]
A = [0, 0]
D = ["4 * r", 0]
[driver]
link = "r2"
angle = 60
speed = "15 rad/s"
[links]
r2 = { from = "A", to = "B", length = "r" }
r3 = { from = "B", to = "C", length = "c + r / 10" }
r4 = { from = "C", to = "D", length = 250 }
[start]
C = [310, 230]
"#;
    let space = super::tests::space_of(text, &["r", "c"]);
    let requests = [
        "transmission >= 80",
        "r4.angle.swing = 40",
        "C.y.greatest = 90",
    ];
    let requested = goals(&space, &requests);
    let names: Vec<&str> = requested.iter().map(|goal| goal.figure.name()).collect();
    let axes = axes(&["r=60..120", "c=250..400"]);
    let mut search = GoalSearch::new(figures(&space, &names), requested.clone(), &axes);
    let mut worst_at = Vec::new();
    for numbers in [[80.0, 280.0], [101.0, 303.0], [95.0, 390.0]] {
        let place = search.place(numbers.to_vec()).unwrap();
        let places = search.figures.evaluate(&numbers).unwrap().places.unwrap();
        assert!(search.figures.exact_slopes(&places, &numbers).is_none());
        worst_at.push(places[0].places[0].1);
        let ends = numbers.map(|number| [number - 1e-3, number + 1e-3]);
        assert!(
            search
                .figures
                .placed_slopes(&places, &numbers, &ends)
                .is_some()
        );
        let distance = search.slopes(&place).unwrap() - search.differences(&place).unwrap();
        assert!(distance.amax() < 1e-7, "{numbers:?}: {distance}");
    }
    assert!(
        worst_at.contains(&1.0) && worst_at.contains(&-1.0),
        "{worst_at:?}"
    );
}
