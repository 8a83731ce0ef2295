//! Ends of the range behind coupled groups, for any position of the scene: compared with values of
//! 50 digits, and with the bound of each end.

use crate::exact::DoubleDouble;
use crate::rig::exact;
use krank::scene::Scene;
use krank::solver::{Motion, Range, Solver};

/// A triad on the crank: both ends are its folds.
const TRIAD: &str = r#"
[ground]
A = [{0}, {1}]
G7 = [{2.338}, {1 0.618}]
G8 = [{3.562}, {1 -2.623}]
[driver]
link = "r2"
angle = 32.97
[links]
r2 = { from = "A", to = "B", length = 0.861 }
r3 = { from = "B", to = "C", length = 0.604404 }
t = { from = "C", to = "P", length = 1.138, points = { Q = [1.117, 1.5] } }
r4 = { from = "P", to = "G7", length = 1.294682 }
r5 = { from = "Q", to = "G8", length = 2.671592 }
[start]
C = [{1.318}, {1 0.571}]
P = [{1.691769}, {1 -0.503868}]
Q = [{3.101657}, {1 0.008632}]
"#;

/// A triad followed by a slider that reaches the end of its motion in both directions.
const SLIDER: &str = r#"
[ground]
A = [{0}, {1}]
G7 = [{2.444}, {1 -0.351}]
G8 = [{3.099}, {1 -2.751}]
[driver]
link = "r2"
angle = 260.56
[links]
r2 = { from = "A", to = "B", length = 0.987 }
r3 = { from = "B", to = "C", length = 3.226238 }
t = { from = "C", to = "P", length = 1.457, points = { Q = [1.394, 0.671] } }
r4 = { from = "P", to = "G7", length = 0.481244 }
r5 = { from = "Q", to = "G8", length = 2.311532, points = { W = [0.007, 0.921] } }
r7 = { from = "W", to = "E", length = 2.018596 }
[slides]
s = { point = "E", on = "ground", through = [{2.936}, {1 1.623}], angle = 9.21 }
[start]
C = [{2.362}, {1 1.036}]
P = [{1.962969}, {1 -0.365293}]
Q = [{2.625568}, {1 -0.48847}]
E = [{2.936}, {1 1.623}]
"#;

/// Offsets in millionths, so that every sum is a decimal.
const OFFSETS: [[i64; 2]; 4] = [
    [0, 0],
    [1_000_000_000_000, 1_000_000_000_000],
    [1_234_567_000, -98_765_432_100],
    [-7_000_000, 1_000_000_000_000],
];

/// Returns a coordinate plus an offset, as a decimal.
fn shifted(number: &str, offset: i64) -> String {
    let (sign, digits) = match number.strip_prefix('-') {
        Some(digits) => (-1, digits),
        None => (1, number),
    };
    let (text, part) = digits.split_once('.').unwrap_or((digits, ""));
    let micro = format!("{text}{part:0<6}").parse::<i64>().unwrap() * sign + offset;
    let size = micro.abs();
    let sign = if micro < 0 { "-" } else { "" };
    format!("{sign}{}.{:06}", size / 1_000_000, size % 1_000_000)
}

/// Returns a scene with an offset: `{x}` marks x along the first axis, `{1 y}` and `{1}` along the
/// second.
fn moved(text: &str, [along, across]: [i64; 2], unit: &str) -> String {
    let mut moved = format!("unit = \"{unit}\"\n");
    for (k, part) in text.split('{').enumerate() {
        let place = part.split_once('}').filter(|(number, _)| {
            k > 0
                && number
                    .chars()
                    .all(|c| c.is_ascii_digit() || "-. ".contains(c))
        });
        let Some((number, rest)) = place else {
            moved += if k > 0 { "{" } else { "" };
            moved += part;
            continue;
        };
        moved += &match number.strip_prefix('1') {
            Some("") => shifted("0", across),
            Some(number) if number.starts_with(' ') => shifted(&number[1..], across),
            _ => shifted(number, along),
        };
        moved += rest;
    }
    moved
}

fn motion(text: &str) -> Motion {
    let scene = Scene::parse(text, "test").unwrap();
    Solver::new(&scene.mechanism).unwrap().motion().clone()
}

/// Checks both ends against exact decimals, and their bounds against the errors and half an ulp.
fn hold(motion: &Motion, right: [&str; 2], what: &str) {
    let Range::Limited { low, high } = motion.range else {
        panic!("{what}: {:?}", motion.range);
    };
    for ((found, bound), right) in [low, high].into_iter().zip(motion.range_bounds).zip(right) {
        let right: DoubleDouble = exact(right);
        let (off, bound) = (right.minus(found).abs(), bound.unwrap());
        assert!(
            off <= bound,
            "{what}: {found} is off by {off:e}, bound {bound:e}"
        );
        // The nearest double, unless the last bits are too close to decide.
        let half_ulp = 0.5 * (found.abs().next_up() - found.abs());
        assert!(bound <= 1.01 * half_ulp, "{what}: {found}, bound {bound:e}");
    }
}

#[test]
fn fold_of_coupled_group_is_nearest_double_at_any_offset() {
    let right = [
        "13.600672774729307573725929974511",
        "37.447752320573482039090238620131",
    ];
    for offset in OFFSETS {
        for unit in ["m", "in"] {
            let text = moved(TRIAD, offset, unit);
            hold(&motion(&text), right, &format!("{offset:?} {unit}"));
        }
    }
}

#[test]
fn reach_of_dyad_behind_coupled_group_is_nearest_double() {
    let right = [
        "58.353538733759879431657070435757",
        "321.2833611142204967253147659619",
    ];
    for offset in OFFSETS {
        let text = moved(SLIDER, offset, "in");
        hold(&motion(&text), right, &format!("{offset:?}"));
    }
}

/// Stops of a slide and of a link behind the coupled group end the motion at equal coordinates for
/// all offsets.
#[test]
fn stops_behind_a_coupled_group_are_met_at_the_same_double_wherever_the_scene_lies() {
    for limits in ["s = [-1, 0.15]", "r7 = [104, 109]", "r5 = [281, 283]"] {
        let stopped = |offset| {
            let text = moved(SLIDER, offset, "mm");
            motion(&format!("{text}\n[limits]\n{limits}\n"))
        };
        let at_origin = stopped(OFFSETS[0]);
        let (low, high) = at_origin.range.ends();
        for offset in OFFSETS {
            let far = stopped(offset);
            assert!(!far.stops.is_empty(), "{limits} {offset:?}");
            let (far_low, far_high) = far.range.ends();
            for (found, near, k) in [(far_low, low, 0), (far_high, high, 1)] {
                let bounds = [&far, &at_origin].map(|motion| motion.range_bounds[k].unwrap());
                let ulp = near.abs().next_up() - near.abs();
                assert!(
                    (found - near).abs() <= bounds[0] + bounds[1],
                    "{limits} {offset:?} {found} {near}"
                );
                assert!(
                    bounds.iter().all(|bound| *bound <= 1.01 * ulp),
                    "{limits} {bounds:?}"
                );
            }
        }
    }
}

/// 2,000 m away, with a table, coupled groups and dyads behind it: the doubles next to the typed
/// decimals fold at 5.195487469137.
#[test]
fn fold_is_computed_from_typed_decimals() {
    let motion = motion(include_str!("far_end.toml"));
    let Range::Limited { low, .. } = motion.range else {
        panic!("{:?}", motion.range);
    };
    let off = exact("5.195487469459617048").minus(low).abs();
    assert!(
        off <= motion.range_bounds[0].unwrap(),
        "{low} is off by {off:e}"
    );
    assert!(motion.range_bounds[0].unwrap() < 4.5e-16);
}

/// A dyad that ends the motion before any coupled group, and a motion without an end.
#[test]
fn ends_of_dyads_have_bounds_and_full_turns_have_zero() {
    let four_bar = |crank: &str| {
        motion(&format!(
            "unit = \"mm\"\n[ground]\nA = [0, 0]\nD = [400, 0]\n[driver]\nlink = \"r2\"\nangle = 0\n[links]\nr2 = {{ from = \
             \"A\", to = \"B\", length = {crank} }}\nr3 = {{ from = \"B\", to = \"C\", length = 300 }}\nr4 = {{ from = \
             \"C\", to = \"D\", length = 250 }}\n[start]\nC = [310, 230]\n"
        ))
    };
    // The distance from B to D equals the sum of both links: cos = (400^2 + 200^2 - 550^2) / (2 400
    // 200).
    let limit = "129.83843997699908701088806727019";
    hold(&four_bar("200"), [&format!("-{limit}"), limit], "four-bar");
    assert_eq!(four_bar("100").range_bounds, [Some(0.0), Some(0.0)]);
}
