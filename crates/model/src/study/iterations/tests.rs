use super::*;

/// The lecture's four-bar at 60 deg: r1 + r2 + r3 + r4 = 0, r3 and r4 known by length.
fn four_bar() -> LoopSystem {
    let sought = |length, index| UnknownVector {
        sign: 1.0,
        length: VectorPart::Known(length),
        angle: VectorPart::Sought(index, 0.0),
    };
    let known = Vec2::new(-350.0, 100.0 * 60_f64.to_radians().sin());
    LoopSystem {
        loops: vec![LoopSum {
            known,
            sought: vec![sought(300.0, 0), sought(250.0, 1)],
        }],
        kinds: vec![UnknownKind::Angle; 2],
        longest: 400.0,
    }
}

/// The angles of the lecture, by the law of cosines.
fn assembly() -> [f64; 2] {
    let m = 350_f64.hypot(100.0 * 60_f64.to_radians().sin());
    let alpha = (100.0 * 60_f64.to_radians().sin()).atan2(350.0);
    let corner =
        |near: f64, far: f64| ((m * m + near * near - far * far) / (2.0 * m * near)).acos();
    [-alpha + corner(300.0, 250.0), -alpha - corner(250.0, 300.0)]
}

fn run(degrees: [f64; 2]) -> NewtonTrace {
    let guess = degrees.map(f64::to_radians);
    four_bar().newton(&guess, Some(&assembly()))
}

/// Checks every iteration against Cramer's rule for the two equations, written out. The solver
/// decomposes a matrix instead.
#[test]
fn newton_steps_match_cramers_rule() {
    let trace = run([20.0, 280.0]);
    assert_eq!(trace.outcome, NewtonOutcome::Found);
    let (mut a, mut b) = (20_f64.to_radians(), 280_f64.to_radians());
    for iteration in &trace.iterations {
        assert!((iteration.values[0] - a).abs() < 1e-13 && (iteration.values[1] - b).abs() < 1e-13);
        let fx = -350.0 + 300.0 * a.cos() + 250.0 * b.cos();
        let fy = 50.0 * 3_f64.sqrt() + 300.0 * a.sin() + 250.0 * b.sin();
        assert!((iteration.residuals[0] - fx).abs() < 1e-10);
        assert!((iteration.residuals[1] - fy).abs() < 1e-10);
        // det [-300 sin a, -250 sin b; 300 cos a, 250 cos b]
        let det = 75_000.0 * (b - a).sin();
        assert!((iteration.determinant - det).abs() < 1e-9 * det.abs());
        let da = (-fx * 250.0 * b.cos() - fy * 250.0 * b.sin()) / det;
        let db = (fy * 300.0 * a.sin() + fx * 300.0 * a.cos()) / det;
        (a, b) = (a + da, b + db);
    }
    let last = trace.iterations.last().unwrap();
    assert!(last.error.unwrap() < 1e-14 && last.step.is_none());
}

/// Near the root, the number of correct digits doubles: each error is at most a constant times the
/// square of the previous one. The second derivatives are at most r3 and r4, and the inverse is at
/// most 1/250/sin(crossing): the constant is below 2.
#[test]
fn newton_errors_converge_quadratically() {
    let errors: Vec<f64> = run([20.0, 280.0])
        .iterations
        .iter()
        .filter_map(|i| i.error)
        .collect();
    assert!(errors.len() >= 4, "{errors:?}");
    for pair in errors.windows(2).filter(|pair| pair[1] > 1e-14) {
        assert!(pair[1] <= 2.0 * pair[0] * pair[0], "{errors:?}");
    }
}

#[test]
fn guess_below_pivot_line_finds_other_assembly() {
    let trace = run([-60.0, 40.0]);
    assert_eq!(trace.outcome, NewtonOutcome::OtherAssembly);
    // The mirrored triangle: beta and gamma on the other side.
    let m = (50.0 * 3_f64.sqrt()).atan2(350.0);
    let mirrored = assembly().map(|theta| -2.0 * m - theta);
    let last = &trace.iterations.last().unwrap().values;
    assert!(four_bar().error(last, &mirrored) < 1e-12, "{last:?}");
}

#[test]
fn parallel_arms_are_singular() {
    for r4 in [20.0, 200.0] {
        let trace = run([20.0, r4]);
        assert_eq!(trace.outcome, NewtonOutcome::Singular(0));
        assert_eq!(trace.iterations.len(), 1);
    }
}

#[test]
fn nearly_parallel_arms_diverge() {
    let trace = run([20.0, 199.99]);
    assert_eq!(trace.outcome, NewtonOutcome::Diverged);
    assert_eq!(trace.iterations.len(), 2);
}

/// If the arms cannot reach each other, there is no root, whatever the guess.
#[test]
fn newton_does_not_converge_without_root() {
    let mut system = four_bar();
    system.loops[0].known = Vec2::new(-600.0, 0.0);
    for r3 in [20.0_f64, 70.0, 130.0] {
        let trace = system.newton(&[r3.to_radians(), 5.0], None);
        assert!(
            matches!(
                trace.outcome,
                NewtonOutcome::MinimumError | NewtonOutcome::Diverged
            ),
            "{:?}",
            trace.outcome
        );
    }
}

#[test]
fn jacobian_matches_differences_of_residuals() {
    let system = LoopSystem {
        loops: vec![LoopSum {
            known: Vec2::new(3.0, -1.0),
            sought: vec![
                UnknownVector {
                    sign: -1.0,
                    length: VectorPart::Sought(0, 0.0),
                    angle: VectorPart::Sought(1, 0.4),
                },
                UnknownVector {
                    sign: 1.0,
                    length: VectorPart::Known(2.0),
                    angle: VectorPart::Sought(1, -1.0),
                },
            ],
        }],
        kinds: vec![UnknownKind::Length, UnknownKind::Angle],
        longest: 3.0,
    };
    let at = [1.7, 0.9];
    let jacobian = system.jacobian(&at);
    for index in 0..2 {
        let (mut up, mut down) = (at, at);
        (up[index], down[index]) = (up[index] + 1e-5, down[index] - 1e-5);
        let (up, down) = (system.residuals(&up), system.residuals(&down));
        for row in 0..2 {
            let slope = (up[row] - down[row]) / 2e-5;
            assert!((slope - jacobian[row * 2 + index]).abs() < 1e-9);
        }
    }
}

/// Each step halves the bracket. The values for x^2 - 2 were computed by hand.
#[test]
fn bisection_keeps_root_between_its_ends() {
    for (a, b) in [(1.0, 2.0), (2.0, 1.0)] {
        let bisection = Bisection::of(a, b, 1e-6, |x| x * x - 2.0);
        assert_eq!(bisection.halvings[0].middle, 1.5);
        assert_eq!(bisection.halvings[0].value, 0.25);
        assert_eq!(bisection.halvings.len(), 21);
        let root = 2_f64.sqrt();
        for (k, h) in (0_i32..).zip(&bisection.halvings) {
            assert!(h.a.min(h.b) <= root && root <= h.a.max(h.b));
            assert_eq!((h.a - h.b).abs(), 0.5_f64.powi(k));
        }
        assert!((bisection.root().unwrap() - root).abs() < 1e-6);
    }
}

#[test]
fn bisection_needs_a_sign_change() {
    assert_eq!(Bisection::of(2.0, 3.0, 1e-6, |x| x * x - 2.0).root(), None);
    assert_eq!(Bisection::of(-3.0, 3.0, 1e-6, |x| x * x - 2.0).root(), None);
    assert_eq!(Bisection::of(0.0, 3.0, 1e-6, |x| x).halvings.len(), 23);
}
