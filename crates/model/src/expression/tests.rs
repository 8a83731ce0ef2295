use super::*;
use crate::{Ball, Dual};
use proptest::prelude::*;

const MM: LengthScale = LengthScale {
    symbol: "mm",
    tenths_of_mm: 10.0,
};

/// Returns leaves by name: a length, an angle, a direction, an angular velocity, a force and others.
fn leaf(name: &str) -> Result<Part, Option<String>> {
    let (number, kind) = match name {
        "C.x" => (0, Kind::plain(Dimension::LENGTH)),
        "turn" => (1, Kind::plain(Dimension::DEGREES)),
        "a.angle" => (2, Kind::direction(Revolution::Wrapped)),
        "omega" => (3, Kind::plain(Dimension::RADIANS.rate())),
        "f" => (4, Kind::plain(Dimension::FORCE)),
        "b-c" => (5, Kind::plain(Dimension::LENGTH)),
        "b.angle" => (6, Kind::direction(Revolution::Wrapped)),
        _ => return Err(None),
    };
    let ops = vec![Op::Leaf(number)];
    Ok(Part { ops, kind })
}

fn compiled(text: &str) -> Result<(Code, Kind), FormulaError> {
    let tree = parse(text)?;
    compile(text, &tree, MM, &mut leaf)
}

/// Returns the value of a formula and its unit, for these values of the leaves.
fn read(text: &str, leaves: [f64; 7]) -> (f64, String) {
    let (code, kind) = compiled(text).unwrap_or_else(|e| panic!("{text}: {}", e.words()));
    let value = code.run(|leaf, _| Some(leaves[usize::from(leaf)]));
    (value.unwrap(), kind.dimension.symbol("mm"))
}

const LEAVES: [f64; 7] = [30.0, 90.0, 350.0, 2.0, 5.0, 4.0, 20.0];

#[test]
fn formulas_have_correct_value_and_unit() {
    for (text, value, unit) in [
        ("1 + 2 * 3 - 8 / 4", 5.0, "1"),
        ("2 * -3", -6.0, "1"),
        ("-2 ^ 2 + 2 ^ -1", -3.5, "1"),
        ("4 ^ 1.5 + 4 ^ -0.5 + 0 ^ 0.5", 8.5, "1"),
        ("(C.x * C.x) ^ 1.5", 27000.0, "mm^3"),
        ("(1 + 2) * (3 + 4)", 21.0, "1"),
        ("1e-3 + 1e+3 + .5", 1000.501, "1"),
        ("C.x - b-c", 26.0, "mm"),
        ("C.x * C.x", 900.0, "mm^2"),
        ("sqrt(C.x * C.x)", 30.0, "mm"),
        ("hypot(C.x, 40 mm)", 50.0, "mm"),
        ("max(C.x, b-c, 7 mm) - min(C.x, b-c)", 26.0, "mm"),
        ("C.x + 1 cm", 40.0, "mm"),
        ("C.x + 1 in", 55.4, "mm"),
        ("omega * C.x", 60.0, "mm/s"),
        ("omega * C.x + 1 mm/s", 61.0, "mm/s"),
        ("f * C.x", 150.0, "N mm"),
        ("2 N m + f * C.x", 2150.0, "N mm"),
        ("f * C.x * omega", 300.0, "N mm/s"),
        ("f / C.x", 5.0 / 30.0, "N/mm"),
        ("1 / omega", 0.5, "s/rad"),
        ("turn + 1 deg", 91.0, "deg"),
        ("turn / 2", 45.0, "deg"),
        ("sin(turn / 3)", 0.5, "1"),
        ("cos(0 rad) + tan(45 deg)", 2.0, "1"),
        ("asin(0.5) + acos(0.5)", 90.0, "deg"),
        ("asin(-0.5)", -30.0, "deg"),
        ("atan2(-1, 0)", 270.0, "deg"),
        ("abs(a.angle - b.angle)", 30.0, "deg"),
        ("a.angle - b.angle", -30.0, "deg"),
        ("b.angle - a.angle", 30.0, "deg"),
        ("a.angle + turn", 80.0, "deg"),
        ("b.angle - turn", 290.0, "deg"),
        ("a.angle + b.angle", 370.0, "deg"),
        ("pi * 1 rad - 180 deg", 0.0, "deg"),
        ("turn - 1.5707963267948966 rad", 0.0, "deg"),
        ("90 deg/s - 1.5707963267948966 rad/s", 0.0, "rad/s"),
        ("5 kg * 2 m/s^2 - f", 5000.0, "kg mm/s^2"),
    ] {
        let (found, found_unit) = read(text, LEAVES);
        assert!(
            (found - value).abs() < 1e-12,
            "{text}: {found}, not {value}"
        );
        assert_eq!(found_unit, unit, "{text}");
    }
}

#[test]
fn direction_difference_of_half_turn_is_positive() {
    let short = |a: f64, b: f64| {
        let mut leaves = LEAVES;
        (leaves[2], leaves[6]) = (a, b);
        read("a.angle - b.angle", leaves).0
    };
    assert_eq!(short(270.0, 90.0), 180.0);
    assert_eq!(short(90.0, 270.0), 180.0);
    assert_eq!(short(0.0, 359.5), 0.5);
    assert_eq!(short(1e-9, 0.0), 1e-9);
}

#[test]
fn malformed_formulas_report_reason_and_span() {
    for (text, span, phrase) in [
        ("", 0..0, "the formula ends, but a number"),
        ("C.x +", 5..5, "the formula ends"),
        ("(C.x", 4..4, "`)`"),
        ("C.x)", 3..4, "expected"),
        ("C.x ? 2", 4..5, "`?` is not allowed"),
        ("C.x -b-c", 4..8, "or a subtraction"),
        ("C.x-b-c", 0..7, "no quantity"),
        ("2 * nix", 4..7, "no quantity is named `nix`"),
        ("sine(turn)", 0..4, "unknown function `sine`"),
        ("sin(turn, turn)", 0..15, "takes 1 argument, not 2"),
        (
            "1 + C.x + turn",
            0..7,
            "`1` is a plain number and `C.x` is in mm",
        ),
        ("2 * (C.x + omega)", 5..16, "the units do not match"),
        ("turn + 90", 0..9, "write a unit"),
        ("sin(30)", 0..7, "takes an angle"),
        ("sin(C.x)", 0..8, "in mm"),
        ("asin(C.x)", 0..9, "plain number"),
        ("sqrt(C.x)", 0..9, "root of mm"),
        ("C.x ^ 2.5", 0..3, "root of mm"),
        ("C.x ^ 99", 6..8, "must be a number"),
        ("C.x ^ 0", 6..7, "must be a number"),
        ("((C.x ^ 8) ^ 8)", 0..15, "too large an exponent"),
        ("min(C.x, f)", 4..10, "the units do not match"),
        ("1e999 mm", 0..5, "too large"),
        (
            "1 mm deg^4 deg^4 deg^4 deg^4 deg^4 deg^4 deg^4",
            2..46,
            "too large an exponent",
        ),
    ] {
        let fault = compiled(text).map(|_| ()).unwrap_err();
        assert_eq!(fault.span, span, "{text}: {}", fault.words());
        let words = fault.words();
        assert!(words.contains(phrase), "{text}: {words}");
    }
    let deep = format!("{}1{}", "(".repeat(200), ")".repeat(200));
    assert!(parse(&deep).unwrap_err().message.contains("deep"));
    assert!(
        parse(&"1+".repeat(900))
            .unwrap_err()
            .message
            .contains("long")
    );
}

/// Returns the value of a formula with its first and second rate, for leaves with their rates.
fn rates(text: &str, leaves: [[f64; 3]; 7]) -> [f64; 3] {
    let (code, _) = compiled(text).unwrap();
    std::array::from_fn(|degree| {
        let mut ops = code.ops().to_vec();
        ops.extend(std::iter::repeat_n(Op::Rate, degree));
        let code = Code::new(ops).unwrap();
        let leaf = |leaf, degree| Some(leaves[usize::from(leaf)][usize::from(degree)]);
        code.run::<f64>(leaf).unwrap()
    })
}

/// Checks every differentiation rule against differences of the formula, on a path on which every
/// leaf changes.
#[test]
fn rates_match_finite_differences() {
    let leaves = |t: f64| -> [[f64; 3]; 7] {
        let way = |a: f64, b: f64, c: f64| [a + t * (b + t * c), b + 2.0 * c * t, 2.0 * c];
        let mut all = std::array::from_fn(|i| way(3.0 + i as f64, 0.5 + i as f64, -0.75));
        // Angles are in degrees and their rates in radians.
        for i in [1, 2, 6] {
            let [angle, ..] = &mut all[i];
            *angle = angle.to_degrees() / 20.0;
            all[i][1] /= 20.0;
            all[i][2] /= 20.0;
        }
        all
    };
    for text in [
        "C.x * b-c - C.x / b-c * 1 mm^2",
        "C.x ^ 3 + C.x ^ -2 * 1 mm^4 * 1 mm",
        "sqrt(C.x * b-c)",
        "hypot(C.x, b-c)",
        "atan2(C.x, b-c)",
        "sin(turn) * cos(turn)",
        "tan(turn)",
        "asin(C.x / (9 mm)) - acos(C.x / (8 mm))",
        "a.angle - b.angle",
        "a.angle + turn",
        "2 * a.angle",
        "turn * omega",
        "abs(b-c - C.x)",
        "max(C.x, b-c) + min(C.x, b-c)",
        "turn * turn / pi",
        "f * C.x + 2 N m",
    ] {
        let h = 1e-4;
        let (_, kind) = compiled(text).unwrap();
        let turned = |v: f64| match kind.dimension.degrees {
            true => v.to_radians(),
            false => v,
        };
        let [under, here, over] = [-h, 0.0, h].map(|t| rates(text, leaves(t)));
        let first = (turned(over[0]) - turned(under[0])) / (2.0 * h);
        let second = (over[1] - under[1]) / (2.0 * h);
        for (found, wanted) in [(here[1], first), (here[2], second)] {
            let off = (found - wanted).abs() / (1.0 + wanted.abs());
            assert!(off < 1e-6, "{text}: {found} is not {wanted}");
        }
    }
}

/// A magnitude has no rate where it is 0. Where it may be 0, its rate has no bound, but the
/// magnitude itself has one.
#[test]
fn zero_magnitude_has_error_bound_but_no_rate() {
    let zero = [[0.0, 1.0, 2.0]; 7];
    for text in ["hypot(C.x, b-c)", "abs(C.x)", "max(C.x, b-c)"] {
        let [value, first, _] = rates(text, zero);
        assert_eq!(value, 0.0, "{text}");
        assert!(!first.is_finite(), "{text}: {first}");
        let (code, _) = compiled(text).unwrap();
        let ball = code.run(|_, _| Some(Ball::new(1e-9, 3e-9))).unwrap();
        let bound = ball.bound(0.0).unwrap();
        assert!((1.4e-9..1e-8).contains(&bound), "{text}: {bound:e}");
    }
    let (code, _) = compiled("atan2(C.x, b-c)").unwrap();
    assert!(!code.run::<f64>(|_, _| Some(0.0)).unwrap().is_finite());
}

#[test]
fn direction_has_no_bound_across_its_cut() {
    let run = |text: &str, at: Ball| {
        let (code, _) = compiled(text).unwrap();
        let ball = code.run(|_, _| Some(at)).unwrap();
        ball.bound(ball.mid)
    };
    let across = Ball::new(1e-9, 1e-8);
    assert_eq!(run("a.angle / 2", across), None);
    assert!(run("a.angle - b.angle", across).unwrap() < 1e-7);
    assert!(run("sin(a.angle)", across).unwrap() < 1e-7);
    assert!(run("a.angle / 2", Ball::new(90.0, 1e-8)).unwrap() < 1e-7);
}

#[test]
fn dual_numbers_propagate_slope_through_formula() {
    let (code, _) = compiled("hypot(C.x, 40 mm) * sin(turn)").unwrap();
    let found = code.run(|leaf, _| {
        Some(match leaf {
            0 => Dual::<f64>::new(30.0, 1.0),
            _ => Dual::new(90.0, 0.0),
        })
    });
    assert!((found.unwrap().slope - 0.6).abs() < 1e-15);
}

proptest! {
    /// Any text is a formula, or a fault with a span inside the text.
    #[test]
    fn any_text_compiles_or_reports_a_valid_span(text in "[ -~äß\u{200b}]{0,60}") {
        if let Err(fault) = compiled(&text) {
            prop_assert!(text.get(fault.span).is_some());
        }
    }

    #[test]
    fn any_words_give_enclosed_value_or_valid_span(words in prop::collection::vec(prop::sample::select(vec![
        "C.x", "turn", "a.angle", "b.angle", "omega", "f", "b-c", "pi", "2", "0", "1e300", "90 deg", "3 mm/s^2",
        "+", "-", "*", "/", "^", "(", ")", ",", "sqrt(", "abs(", "min(", "hypot(", "sin(", "atan2(", "acos(",
    ]), 0..24)) {
        let text = words.join(" ");
        match compiled(&text) {
            Err(fault) => prop_assert!(text.get(fault.span).is_some()),
            Ok((code, _)) => {
                let value = code.run(|leaf, _| Some(LEAVES[usize::from(leaf)]));
                let ball = code.run(|leaf, _| Some(Ball::new(LEAVES[usize::from(leaf)], 1e-9)));
                // The ball contains the value.
                if let (Some(value), Some(ball)) = (value, ball)
                    && value.is_finite() && let Some(bound) = ball.bound(value)
                {
                    prop_assert!((value - ball.mid).abs() <= bound);
                }
            }
        }
    }
}
