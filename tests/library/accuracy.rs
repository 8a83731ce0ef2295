//! Tests the accuracy study: errors have the order that theory predicts, and every method is either
//! usable for a preset or states why not. No test measures time: the clock is simulated.

use krank::scene::{Scene, presets};
use krank::solver::Solver;
use krank::study::{
    DEFAULT_CYCLES, Findings, Method, MethodErrors, MethodFigures, MethodVerdict, Start, Study,
    Unsuitable, all_methods,
};
use std::time::Duration;

/// Creates a clock that advances by one millisecond per call.
fn made_up() -> impl FnMut() -> Duration {
    let mut now = Duration::ZERO;
    move || {
        now += Duration::from_millis(1);
        now
    }
}

fn study(preset: &str, methods: &[Method], positions: u32) -> Study {
    let preset = presets::find(preset).unwrap();
    let scene = Scene::parse(preset.text, preset.name).unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    Study::of(methods, &solver, positions)
}

fn findings(preset: &str, methods: &[Method], positions: u32) -> Findings {
    let mut study = study(preset, methods, positions);
    let mut clock = made_up();
    while study.advance(&mut clock, Duration::from_secs(1)) {}
    study.findings()
}

/// Returns the measurements of one method.
fn figures(preset: &str, method: Method) -> MethodFigures {
    let findings = findings(preset, &[method], 3600);
    *findings.methods[0].figures().unwrap()
}

fn errors(preset: &str, method: Method) -> MethodErrors {
    let figures = figures(preset, method);
    assert_eq!(figures.failures, 0, "{method:?}");
    figures.errors.unwrap()
}

fn newton(tolerance: f64, start: Start) -> Method {
    Method::Newton { tolerance, start }
}

fn rk4(steps: u16, turns: u16) -> Method {
    Method::Integration { steps, turns }
}

fn is_integration(method: Method) -> bool {
    matches!(method, Method::Integration { .. })
}

#[test]
fn lecture_four_bar_errors_have_expected_order() {
    let position = |method| errors("four-bar", method).position;
    let closed = errors("four-bar", Method::ClosedForm);
    let all = [closed.position, closed.velocity, closed.acceleration];
    assert!(all.iter().all(|e| (1e-17..2e-15).contains(e)), "{closed:?}");
    assert!(position(Method::Polished) < closed.position);
    assert_eq!(errors("four-bar", Method::Bounded), closed);
    assert!((1e-8..1e-6).contains(&position(Method::Single)));
    assert!((1e-17..2e-15).contains(&position(Method::Bisection)));
}

#[test]
fn newton_error_falls_with_tolerance_down_to_rounding() {
    for start in [Start::Warm, Start::Cold] {
        let position = |tolerance| errors("four-bar", newton(tolerance, start)).position;
        let found = [1e-3, 1e-6, 1e-9, 1e-12, 1e-14].map(position);
        // The last step was below the tolerance, so that the remaining error is about its square.
        assert!((1e-9..1e-5).contains(&found[0]), "{found:?}");
        assert!((1e-15..1e-11).contains(&found[1]), "{found:?}");
        assert!(found[2..].iter().all(|&e| e < 2e-15), "{found:?}");
    }
}

#[test]
fn rk4_error_falls_16_fold_per_halved_step_and_grows_with_turns() {
    let position = |steps, turns| errors("four-bar", rk4(steps, turns)).position;
    let ratio = position(72, 1) / position(144, 1);
    assert!((13.0..19.0).contains(&ratio), "{ratio}");
    assert!(position(36, 1000) > 100.0 * position(36, 1));
}

#[test]
fn inapplicable_methods_state_their_reason() {
    let unfit = |preset: &str, method| match findings(preset, &[method], 360).methods[0].verdict {
        MethodVerdict::Unsuitable(unfit) => Some(unfit),
        MethodVerdict::Measured(_) | MethodVerdict::Pending => None,
    };
    assert_eq!(
        unfit("four-bar", Method::Anchored),
        Some(Unsuitable::AllClosed)
    );
    let six_bar = "stephenson-six-bar";
    for method in [Method::ClosedForm, Method::Polished] {
        assert!(matches!(
            unfit(six_bar, method),
            Some(Unsuitable::Coupled(Some(_)))
        ));
    }
    let bisection = unfit(six_bar, Method::Bisection);
    assert!(matches!(
        bisection,
        Some(Unsuitable::Conditions { unknowns: 3, .. })
    ));
    assert_eq!(unfit("double-rocker", rk4(36, 1)), Some(Unsuitable::Limits));
    assert_eq!(unfit("double-rocker", Method::Bisection), None);
}

/// Newton's method can list the rows of every group of every preset, and its solution agrees with
/// the closed form.
#[test]
fn applicable_methods_solve_every_preset_without_failures() {
    let own = [Method::ClosedForm, Method::Anchored, Method::Bounded];
    let by_rows = [newton(1e-9, Start::Warm), Method::Polished];
    for preset in presets::all() {
        let list = [&own[..], &by_rows].concat();
        let findings = findings(preset.name, &list, 360);
        for finding in &findings.methods {
            let MethodVerdict::Measured(figures) = finding.verdict else {
                assert!(
                    matches!(
                        finding.verdict,
                        MethodVerdict::Unsuitable(Unsuitable::Coupled(_) | Unsuitable::AllClosed)
                    ),
                    "{}: {finding:?}",
                    preset.name
                );
                continue;
            };
            assert!(figures.tried >= 357, "{}: {finding:?}", preset.name);
            assert_eq!(figures.failures, 0, "{}: {finding:?}", preset.name);
            let error = figures.errors.unwrap().position;
            assert!(error < 1e-12, "{}: {finding:?}", preset.name);
        }
    }
}

/// Newton's method cannot distinguish assemblies: convergence to another one is a failure, however
/// near it is. Close to a limit both are close together.
#[test]
fn convergence_to_another_assembly_counts_as_failure() {
    let cold = figures("double-rocker", newton(1e-9, Start::Cold));
    assert!(cold.failures > 0, "{cold:?}");
    assert!(cold.errors.unwrap().position < 1e-9, "{cold:?}");
}

/// After a change point, a dyad lies on its other side: bisection is given the side, and Newton's
/// method follows.
#[test]
fn change_points_are_passed_without_failures() {
    for method in [Method::Bisection, newton(1e-6, Start::Warm)] {
        let figures = figures("kite", method);
        assert_eq!(figures.failures, 0, "{method:?}");
        assert!(figures.errors.unwrap().position < 1e-9, "{method:?}");
    }
}

#[test]
fn findings_are_readable_before_study_ends() {
    let mut study = study("four-bar", &all_methods(DEFAULT_CYCLES), 360);
    assert_eq!(study.progress(), 0.0);
    let mut clock = made_up();
    let (mut last, mut slices) = (0.0, 0);
    // Stops when the integrations begin.
    while study.current().is_none() {
        assert!(study.advance(&mut clock, Duration::from_millis(50)));
        assert!(study.progress() >= last && study.progress() < 1.0);
        (last, slices) = (study.progress(), slices + 1);
    }
    assert!(slices > 10, "{slices}");
    let findings = study.findings();
    assert!(!findings.finished);
    for finding in &findings.methods {
        let is_pending = finding.verdict == MethodVerdict::Pending;
        // Short integrations may be complete within the last slice.
        assert!(!is_pending || is_integration(finding.method), "{finding:?}");
    }
    let last = findings.methods.last().unwrap();
    assert_eq!(last.verdict, MethodVerdict::Pending);
}

#[test]
fn keys_are_consecutive_and_best_methods_never_fail() {
    let list: Vec<Method> = all_methods(DEFAULT_CYCLES);
    let list: Vec<Method> = list.into_iter().filter(|m| !is_integration(*m)).collect();
    let findings = findings("kite", &list, 360);
    assert!(findings.finished);
    for (letter, finding) in ('a'..).zip(&findings.methods) {
        assert_eq!(finding.key, letter);
        let fails = finding.figures().is_none_or(|f| f.failures > 0);
        assert!(!(finding.best && fails), "{finding:?}");
    }
    assert!(findings.methods.iter().any(|finding| finding.best));
}
