//! Inputs that must be rejected by name: links of zero length, and values that are not finite.

use crate::rig::{FourBar, LECTURE};
use krank::report::{DecimalError, Steps, StepsError, WrittenDecimal};
use krank::scene::Scene;
use krank::solver::Fault;
use krank::{Defect, Driver, ElementId, Input, Mechanism, Vec2};

/// Returns the lecture's four-bar with other values, as a scene.
fn scene(lengths: [&str; 3], angle: &str, speed: &str) -> String {
    let [crank, coupler, rocker] = lengths;
    format!(
        "unit = \"mm\"\n\
         [ground]\nA = [0, 0]\nD = [400, 0]\n\
         [driver]\nlink = \"r2\"\nangle = {angle}\nspeed = {speed}\n\
         [links]\n\
         r2 = {{ from = \"A\", to = \"B\", length = {crank} }}\n\
         r3 = {{ from = \"B\", to = \"C\", length = {coupler} }}\n\
         r4 = {{ from = \"C\", to = \"D\", length = {rocker} }}\n\
         [start]\nC = [310, 230]\n"
    )
}

/// Returns the error message for a scene that must be rejected.
fn refusal(text: &str) -> String {
    match Scene::parse(text, "hard.toml") {
        Err(faults) => faults.render(true, false),
        Ok(_) => panic!("accepted:\n{text}"),
    }
}

const SPEED: &str = "\"15 rad/s\"";
const LENGTHS: [&str; 3] = ["100", "300", "250"];
const NAMES: [&str; 3] = ["r2", "r3", "r4"];

/// Returns the lengths with one of them replaced.
fn with<T: Copy>(mut lengths: [T; 3], index: usize, length: T) -> [T; 3] {
    lengths[index] = length;
    lengths
}

/// Returns the defects of the lecture's four-bar with these lengths, speed and start.
fn defects(lengths: [f64; 3], speed: f64, start: f64) -> Vec<Defect> {
    let mut builder = Mechanism::builder();
    let (a, d) = (
        builder.ground_point(0.0, 0.0),
        builder.ground_point(400.0, 0.0),
    );
    let (b, c) = (builder.moving_point(), builder.moving_point());
    let crank = builder.link(a, b, lengths[0]);
    builder.link(b, c, lengths[1]);
    builder.link(c, d, lengths[2]);
    builder.driver(Driver {
        input: Input::Turn(crank),
        start,
        speed,
        acceleration: 0.0,
    });
    builder.start(c, Vec2::new(310.0, 230.0));
    let found = builder.build().err();
    found.map_or_else(Vec::new, |defects| defects.list().to_vec())
}

#[test]
fn lecture_four_bar_is_accepted() {
    assert!(Scene::parse(&scene(LENGTHS, "60", SPEED), "hard.toml").is_ok());
    assert_eq!(defects([100.0, 300.0, 250.0], 15.0, 60.0), []);
}

#[test]
fn h14_error_names_link_of_zero_length() {
    for (index, name) in NAMES.iter().enumerate() {
        let text = refusal(&scene(with(LENGTHS, index, "0"), "60", SPEED));
        let names = text.contains(&format!("`length` of link `{name}`"));
        assert!(names && text.contains("not `0`"), "{text}");
        let found = defects(with([100.0, 300.0, 250.0], index, 0.0), 15.0, 60.0);
        let [Defect::Length { link, length: 0.0 }] = found[..] else {
            panic!("{found:?}");
        };
        assert_eq!(link.index(), index);
    }
}

#[test]
fn h14_coincident_ground_points_are_legal() {
    // Crank and rocker turn together about one point.
    let triangle = FourBar {
        ground: 0.0,
        coupler: 100.0,
        rocker: 100.0,
        ..LECTURE
    };
    let opened = triangle.open();
    let state = opened.at(75.0);
    assert!((state.omega(opened.rocker).unwrap() - 15.0).abs() <= 1e-14 * 15.0);
    // B and C are opposite: the coupler is always stretched, and no start distinguishes its
    // assemblies.
    let opposite = FourBar {
        ground: 0.0,
        coupler: 200.0,
        rocker: 100.0,
        ..LECTURE
    };
    let Err(Fault::Vague { choices, .. }) = opposite.try_open() else {
        panic!("neither assembly is the one that was meant");
    };
    let c = krank::angle::unit(60.0) * -100.0;
    assert!(
        choices.iter().all(|p| (*p - c).norm() <= 1e-13 * 100.0),
        "{choices:?}"
    );
}

#[test]
fn h19_file_with_non_positive_length_is_rejected() {
    for (index, name) in NAMES.iter().enumerate() {
        for length in [
            "nan", "inf", "-inf", "-1", "-0.0", "1e400", "5e-324", "\"-100\"",
        ] {
            let text = refusal(&scene(with(LENGTHS, index, length), "60", SPEED));
            assert!(
                text.contains(&format!("`length` of link `{name}`")),
                "{text}"
            );
        }
    }
}

#[test]
fn h19_builder_rejects_non_positive_length() {
    for index in 0..3 {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, -0.0] {
            let found = defects(with([100.0, 300.0, 250.0], index, bad), 15.0, 60.0);
            let [Defect::Length { link, length }] = found[..] else {
                panic!("{bad}: {found:?}");
            };
            assert_eq!((link.index(), length.to_bits()), (index, bad.to_bits()));
        }
    }
}

#[test]
fn h19_non_finite_rates_and_angles_are_rejected() {
    for bad in ["nan", "inf", "-inf", "1e400"] {
        let text = refusal(&scene(LENGTHS, bad, SPEED));
        assert!(text.contains("`angle`"), "{text}");
        let text = refusal(&scene(LENGTHS, "60", bad));
        assert!(text.contains("`speed`"), "{text}");
    }
    let lengths = [100.0, 300.0, 250.0];
    for bad in [f64::NAN, f64::INFINITY] {
        assert_eq!(defects(lengths, bad, 60.0), [Defect::Driver]);
        assert_eq!(defects(lengths, 15.0, bad), [Defect::Driver]);
    }
    let mut builder = Mechanism::builder();
    let point = builder.ground_point(f64::NAN, 0.0);
    let found = builder.build().expect_err("a coordinate is no number");
    let of = ElementId::Point(point);
    assert!(
        found.list().contains(&Defect::Coordinates { of }),
        "{found:?}"
    );
}

#[test]
fn h19_non_finite_coordinates_have_no_assembly() {
    let opened = LECTURE.open();
    for at in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let condition = crate::rig::condition(&opened.solver, at);
        assert_eq!(condition, krank::solver::Condition::NoAssembly, "at {at}");
    }
}

#[test]
fn h19_sweep_rejects_zero_step_and_too_many_steps() {
    let decimal = |text: &str| text.parse::<WrittenDecimal>();
    for text in ["nan", "inf", "1e400"] {
        assert_eq!(decimal(text), Err(DecimalError::NotFinite), "{text}");
    }
    let steps = |to: &str, step: &str| {
        let [from, to, step] = ["0", to, step].map(|t| decimal(t).expect("a number"));
        Steps::new(from, to, step).map(|steps| steps.count())
    };
    assert_eq!(steps("360", "0"), Err(StepsError::Zero));
    assert_eq!(steps("360", "-0.0"), Err(StepsError::Zero));
    assert_eq!(steps("0", "1"), Ok(1));
    assert_eq!(steps("999999999", "1"), Ok(1_000_000_000));
    assert!(matches!(steps("1e9", "1"), Err(StepsError::TooMany { .. })));
}
