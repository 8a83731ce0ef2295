//! Points of links given by length and angle, compared with values to 50 digits.

use crate::exact::DoubleDouble;
use krank::quantity::{Aspect, Subject, bound, value};
use krank::scene::Scene;
use krank::solver::{Condition, Order, Solver};
use krank::{LinkId, PointId, Vec2};

/// F is relative to E, which is defined after it, and so is the centre of mass. No number here is
/// exactly representable as a double.
pub(crate) const SIGHTED: &str = r#"
unit = "mm"
[ground]
A = [0, 0]
D = [400, 0]
[driver]
link = "r2"
angle = 60
speed = "15 rad/s"
[links]
r2 = { from = "A", to = "B", length = 100 }
r4 = { from = "C", to = "D", length = 250 }
[links.r3]
from = "B"
to = "C"
length = 300
points = { F = { from = "E", length = 30.7, angle = -40.1 }, E = { from = "C", length = 180.1, angle = 72.3 } }
com = { from = "E", length = 12.3, angle = 33 }
mass = 1
[start]
C = [310, 230]
"#;

/// Computed by the law of cosines with mpmath at 50 digits, every number as its typed decimal.
const PLACES: [(f64, &str, [&str; 2]); 6] = [
    (
        60.0,
        "E",
        [
            "274.9582239959715001787602451",
            "410.151022093606287386617433",
        ],
    ),
    (
        60.0,
        "F",
        [
            "305.122390309804224717348158",
            "404.4402366317421224984246731",
        ],
    ),
    (
        60.0,
        "r3.com",
        [
            "280.660674842187832555934443",
            "421.0492813282954051489362956",
        ],
    ),
    (
        217.3,
        "E",
        [
            "124.5992971389571587221695115",
            "276.4678741521094872180592094",
        ],
    ),
    (
        217.3,
        "F",
        [
            "155.0631101413287126282232084",
            "272.6670719530286338962720191",
        ],
    ),
    (
        217.3,
        "r3.com",
        [
            "129.6044581880288671416013697",
            "287.7034588219366607123297842",
        ],
    ),
];

fn named(scene: &Scene, name: &str) -> PointId {
    let mut ids = scene.mechanism.point_ids();
    ids.find(|&id| scene.point_name(id) == Some(name)).unwrap()
}

fn coupler(scene: &Scene) -> LinkId {
    let mut ids = scene.mechanism.link_ids();
    ids.find(|&id| scene.link_name(id) == "r3").unwrap()
}

/// The typed values count: the bounds hold for the decimals, and are as small as those of
/// coordinates.
#[test]
fn polar_points_are_within_bounds_of_typed_values() {
    let scene = Scene::parse(SIGHTED, "sighted").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let (mut workspace, mut enclosure) = (solver.state(), solver.enclosure());
    for (at, name, places) in PLACES {
        let solved = solver.solve(at, Order::Acceleration, &mut workspace);
        assert_eq!(solved, Condition::Ok);
        solver.enclose(&mut workspace, Order::Acceleration, &mut enclosure);
        let point = Subject::Point(named(&scene, name));
        for (aspect, place) in [Aspect::X, Aspect::Y].into_iter().zip(places) {
            let found = value(point, aspect, &workspace).unwrap();
            let maximum = bound(point, aspect, &workspace, &enclosure).unwrap();
            let off = DoubleDouble::parse(place).unwrap().minus(found).abs();
            assert!(
                off <= maximum,
                "{name} {aspect:?} at {at}: {off:e} of {maximum:e}"
            );
            assert!(maximum < 5e-13, "{name} {aspect:?} at {at}: {maximum:e}");
        }
    }
}

/// Compares the derivative of all positions by one number with the mechanism with another number.
#[test]
fn points_relative_to_a_point_move_with_it() {
    let scene = Scene::parse(SIGHTED, "sighted").unwrap();
    let mechanism = &scene.mechanism;
    let link = coupler(&scene);
    let local = |mechanism: &krank::Mechanism, name: &str| {
        let of = mechanism.link(link);
        of.local(named(&scene, name)).unwrap()
    };
    for length in mechanism.lengths() {
        let at = |by: f64| mechanism.changed(length, by);
        let (more, less) = (at(1e-3), at(-1e-3));
        for name in ["E", "F", "r3.com"] {
            let moved = local(&more, name) - local(&less, name);
            let way = moved / 2e-3;
            let unit = |angle: f64| {
                let (y, x) = angle.to_radians().sin_cos();
                Vec2::new(x, y)
            };
            let expected = match length {
                krank::Length::Link(of) if of == link => Vec2::X,
                krank::Length::Arm(_, of) if of == named(&scene, "E") => unit(72.3),
                krank::Length::Across(_, of) if of == named(&scene, "E") => unit(162.3),
                krank::Length::Arm(_, of) if scene.point_name(of) == Some(name) => match name {
                    "F" => unit(-40.1),
                    _ => unit(33.0),
                },
                krank::Length::Across(_, of) if scene.point_name(of) == Some(name) => match name {
                    "F" => unit(49.9),
                    _ => unit(123.0),
                },
                _ => Vec2::ZERO,
            };
            assert!((way - expected).norm() < 1e-6, "{length:?} {name}: {way:?}");
        }
    }
}

/// A point relative to one that the link does not carry yet has no coordinates.
#[test]
fn point_relative_to_point_not_yet_carried_is_rejected() {
    let mut builder = krank::Builder::default();
    let (a, b) = (builder.ground_point(0.0, 0.0), builder.moving_point());
    let link = builder.link(a, b, 1.0);
    let (p, q) = (builder.moving_point(), builder.moving_point());
    builder.carry_at(link, p, Some(q), (0.5, 30.0));
    builder.carry_at(link, q, Some(b), (0.5, 30.0));
    builder.driver(krank::Driver {
        input: krank::Input::Turn(link),
        start: 0.0,
        speed: 1.0,
        acceleration: 0.0,
    });
    let defects = builder.build().unwrap_err();
    let of = krank::ElementId::Link(link);
    assert_eq!(defects.list(), [krank::Defect::Coordinates { of }]);
}
