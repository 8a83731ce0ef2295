//! Tests optimization against closed formulas, which are written out here.

use super::tests::{axes, figures, goals, space};
use super::{BestDesign, OptimiseOrder};

/// A known optimum: the maximum stroke with a bounded transmission angle. An in-line slider-crank
/// has the stroke 2 r, and its transmission angle is least at 90 deg, with cos = r / l.
#[test]
fn best_design_lies_on_its_constraint() {
    let space = space("slider-crank", &["r2 length"]);
    let figures = figures(&space, &["r4.length.stroke", "transmission"]);
    let l = space
        .scene()
        .values()
        .into_iter()
        .find(|v| v.name == "r3 length")
        .unwrap()
        .number;
    let constraints = goals(&space, &["transmission >= 60"]);
    let order = |threads| OptimiseOrder {
        greatest: true,
        generations: 20,
        seed: 4,
        threads,
    };
    let axes = axes(&["r2=2..19"]);
    let best = BestDesign::find(&figures, &constraints, &axes, order(2), &mut |_| true).unwrap();
    assert!((best.numbers[0] - l / 2.0).abs() < 1e-8 * l, "{best:?}");
    assert!((best.value - l).abs() < 2e-8 * l, "{best:?}");
    assert!(best.stationary && best.missed == 0.0, "{best:?}");
    let alone = BestDesign::find(&figures, &constraints, &axes, order(1), &mut |_| true).unwrap();
    assert_eq!(best, alone);
}

/// A stopped search returns the best design so far, between generations and within one.
#[test]
fn stopped_search_returns_best_so_far() {
    let space = space("slider-crank", &["r2 length"]);
    let figures = figures(&space, &["r4.length.stroke"]);
    let axes = axes(&["r2=2..19"]);
    for maximum in [true, false] {
        let order = OptimiseOrder {
            greatest: maximum,
            generations: 20,
            seed: 4,
            threads: 1,
        };
        for calls in [1, 10, 30, 60, 100] {
            let (mut text, mut seen) = (0, None);
            let best = BestDesign::find(&figures, &[], &axes, order, &mut |state| {
                text += 1;
                seen = state.best;
                text < calls
            });
            let best = best.unwrap();
            assert_eq!(text, calls, "it ends at once");
            // The stroke of an in-line slider-crank is twice its crank.
            assert!(
                (best.value - 2.0 * best.numbers[0]).abs() < 1e-9,
                "{best:?}"
            );
            assert!(!best.stationary && best.generations < 5, "{best:?}");
            let is_better = |other: f64| match maximum {
                true => best.value >= other,
                false => best.value <= other,
            };
            assert_eq!(seen.is_some(), calls > 24, "a whole generation is known");
            assert!(seen.is_none_or(is_better), "{best:?} {seen:?}");
        }
    }
}

/// The first generation contains the given design, so that a search resumes from its result: here
/// from an optimum that no random design is as good as.
#[test]
fn search_begins_with_given_design() {
    let preset = crate::scene::presets::find("slider-crank").unwrap().text;
    let scene = crate::scene::Scene::parse(preset, "test").unwrap();
    let crank = scene.value_named("r2.length").unwrap();
    let rod = scene.value_named("r3.length").unwrap().number;
    let text = scene.with_value(&crank, &crank.with_number(rod / 2.0));
    let space = super::tests::space_of(&text, &["r2 length"]);
    let figures = figures(&space, &["r4.length.stroke", "transmission"]);
    let constraints = goals(&space, &["transmission >= 60"]);
    let order = OptimiseOrder {
        greatest: true,
        generations: 0,
        seed: 4,
        threads: 1,
    };
    let mut calls = 0;
    let axes = axes(&["r2=2..19"]);
    // The first generation has 24 designs; stopped then, the best one is not polished.
    let best = BestDesign::find(&figures, &constraints, &axes, order, &mut |_| {
        calls += 1;
        calls <= 24
    });
    assert_eq!(best.unwrap().numbers, [rod / 2.0]);
}

/// A resumed search begins with the known design; one outside the bounds is ignored.
#[test]
fn search_begins_with_known_designs_within_bounds() {
    let space = space("slider-crank", &["r2 length"]);
    let figures = figures(&space, &["r4.length.stroke"]);
    let order = OptimiseOrder {
        greatest: true,
        generations: 0,
        seed: 4,
        threads: 1,
    };
    let axes = axes(&["r2=2..19"]);
    // The first generation has 24 designs; stopped then, the best one is not polished.
    let found = |known: f64| {
        let mut calls = 0;
        let known = [vec![known]];
        let best = BestDesign::find_from(&known, &figures, &[], &axes, order, &mut |_| {
            calls += 1;
            calls <= 24
        });
        best.unwrap().numbers[0]
    };
    // The slider-crank turns fully with any crank up to its rod, 20.
    assert_eq!(found(19.0), 19.0);
    assert!(found(19.5) < 19.0);
}

/// Returns the swing of a crank-rocker, and its transmission angle furthest from 90 deg, by the law
/// of cosines. At the dead centres crank and coupler are in line; the angle is furthest when crank
/// and frame are in line.
fn swing_and_transmission([r2, r3, r4, r1]: [f64; 4]) -> (f64, f64) {
    let at = |opposite: f64, a: f64, b: f64| {
        let cos = (a * a + b * b - opposite * opposite) / (2.0 * a * b);
        cos.acos().to_degrees()
    };
    let swing = at(r3 + r2, r1, r4) - at(r3 - r2, r1, r4);
    let angles = [r1 - r2, r1 + r2].map(|far| at(far, r3, r4));
    let off = angles.iter().map(|angle| (angle - 90.0).abs());
    // If the links are too short for that, there is no such angle.
    let closes = angles.iter().all(|angle| angle.is_finite());
    (
        swing,
        if closes {
            90.0 - off.fold(0.0, f64::max)
        } else {
            0.0
        },
    )
}

/// The maximum transmission angle with an exact swing. For every coupler, bisection of the closed
/// formula gives the cranks with that swing, and a scan finds the best. There the angle is equally
/// far from 90 deg on both sides.
#[test]
fn best_design_satisfies_equality_constraint() {
    let of = |r2: f64, r3: f64| swing_and_transmission([r2, r3, 250.0, 400.0]);
    let best_with = |r3: f64| {
        let over = |r2: f64| of(r2, r3).0 - 50.0;
        let cells = (0..160).map(|k| 60.0 + 0.5 * f64::from(k));
        let cells = cells.map(|low| [low, low + 0.5]);
        let cranks = cells.filter(|cell| over(cell[0]) * over(cell[1]) < 0.0);
        let cranks = cranks.map(|[mut low, mut high]| {
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                *(if over(low) * over(middle) <= 0.0 {
                    &mut high
                } else {
                    &mut low
                }) = middle;
            }
            low
        });
        cranks.map(|r2| of(r2, r3).1).fold(0.0, f64::max)
    };
    let best_from = |from: f64, step: f64, count: i32| {
        let places = (0..count).map(|k| from + f64::from(k) * step);
        let best = places.map(|r3| (r3, best_with(r3)));
        best.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap()
    };
    let (near, _) = best_from(260.0, 0.02, 4000);
    let (known_at, known) = best_from(near - 0.02, 2e-5, 2000);
    let space = space("four-bar", &["r2 length", "r3 length"]);
    let figures = figures(&space, &["transmission", "r4.angle.swing"]);
    let constraints = goals(&space, &["r4.angle.swing = 50"]);
    for seed in [1, 2] {
        let order = OptimiseOrder {
            greatest: true,
            generations: 8,
            seed,
            threads: 2,
        };
        let axes = axes(&["r2=90..120", "r3=290..340"]);
        let best = BestDesign::find(&figures, &constraints, &axes, order, &mut |_| true).unwrap();
        assert_eq!(best.missed, 0.0, "{best:?}");
        // The resolution of the scan.
        assert!(
            (best.value - known).abs() < 1e-4,
            "{best:?}: {known} at {known_at}"
        );
        assert!(best.stationary, "{best:?}");
    }
}

/// The maximum swing with a bounded transmission angle, which is furthest from 90 deg on both sides
/// at once: there the bound has no slope. Both laws of cosines give the lengths: their sum is `r3^2 =
/// r1^2 + r2^2 - r4^2`, and their difference `r2 = r3 r4 cos 45 deg / r1`.
#[test]
fn best_design_lies_on_kink_of_constraint() {
    let (r1, r4) = (400.0_f64, 250.0_f64);
    let ratio = r4 * std::f64::consts::FRAC_1_SQRT_2 / r1;
    let r3 = ((r1 * r1 - r4 * r4) / (1.0 - ratio * ratio)).sqrt();
    let r2 = ratio * r3;
    let (known, transmission) = swing_and_transmission([r2, r3, r4, r1]);
    assert!((transmission - 45.0).abs() < 1e-9);
    let space = space("four-bar", &["r2 length", "r3 length"]);
    let figures = figures(&space, &["r4.angle.swing", "transmission"]);
    let constraints = goals(&space, &["transmission >= 45"]);
    for seed in [1, 2, 3] {
        let order = |threads| OptimiseOrder {
            greatest: true,
            generations: 2,
            seed,
            threads,
        };
        let axes = axes(&["r2=60..200", "r3=250..400"]);
        let find = |threads| {
            let best =
                BestDesign::find(&figures, &constraints, &axes, order(threads), &mut |_| true);
            best.unwrap()
        };
        let best = find(1);
        assert!(best.stationary && best.missed == 0.0, "{best:?}");
        assert!((best.numbers[0] - r2).abs() < 1e-6, "{best:?}: {r2}");
        assert!((best.numbers[1] - r3).abs() < 1e-6, "{best:?}: {r3}");
        assert!((best.value - known).abs() < 1e-7, "{best:?}: {known}");
        assert_eq!(best, find(2));
    }
}
