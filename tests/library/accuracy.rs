//! Speed against error: that errors have the order that theory gives them, and that every method is
//! either usable for a preset or says why not. No test here measures time: the clock is a made-up one.

use krank::scene::{Scene, presets};
use krank::solver::Solver;
use krank::study::{
    Findings, Method, MethodErrors, MethodFigures, MethodVerdict, Start, Study, USUAL_CYCLES,
    Unfit, all_methods,
};
use std::time::Duration;

/// A clock on which everything takes a millisecond.
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

/// What was measured of one method.
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
fn errors_on_the_lectures_four_bar_have_the_order_that_was_found_elsewhere() {
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
fn a_smaller_tolerance_of_newton_gains_digits_until_there_are_no_more() {
    for start in [Start::Warm, Start::Cold] {
        let position = |tolerance| errors("four-bar", newton(tolerance, start)).position;
        let found = [1e-3, 1e-6, 1e-9, 1e-12, 1e-14].map(position);
        // The last step was below the tolerance, so that its square is about what is left.
        assert!((1e-9..1e-5).contains(&found[0]), "{found:?}");
        assert!((1e-15..1e-11).contains(&found[1]), "{found:?}");
        assert!(found[2..].iter().all(|&e| e < 2e-15), "{found:?}");
    }
}

#[test]
fn an_integration_gains_a_factor_of_16_where_its_steps_double_and_loses_with_time() {
    let position = |steps, turns| errors("four-bar", rk4(steps, turns)).position;
    let ratio = position(72, 1) / position(144, 1);
    assert!((13.0..19.0).contains(&ratio), "{ratio}");
    assert!(position(36, 1000) > 100.0 * position(36, 1));
}

#[test]
fn methods_that_a_mechanism_does_not_allow_say_why() {
    let unfit = |preset: &str, method| match findings(preset, &[method], 360).methods[0].verdict {
        MethodVerdict::Unfit(unfit) => Some(unfit),
        MethodVerdict::Measured(_) | MethodVerdict::Pending => None,
    };
    assert_eq!(unfit("four-bar", Method::Anchored), Some(Unfit::AllClosed));
    let six_bar = "stephenson-six-bar";
    for method in [Method::ClosedForm, Method::Polished] {
        assert!(matches!(
            unfit(six_bar, method),
            Some(Unfit::Coupled(Some(_)))
        ));
    }
    let bisection = unfit(six_bar, Method::Bisection);
    assert!(matches!(
        bisection,
        Some(Unfit::Conditions { unknowns: 3, .. })
    ));
    assert_eq!(unfit("double-rocker", rk4(36, 1)), Some(Unfit::Limits));
    assert_eq!(unfit("double-rocker", Method::Bisection), None);
}

/// The rows of every group of every preset can be listed, and lead to where the closed form leads.
#[test]
fn every_preset_is_solved_by_rows_too() {
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
                        MethodVerdict::Unfit(Unfit::Coupled(_) | Unfit::AllClosed)
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

/// Newton's method does not know which assembly is meant; that it lands on another one is a failure,
/// however near that is. Close to a limit both are close together.
#[test]
fn another_assembly_is_a_failure_and_no_error() {
    let cold = figures("double-rocker", newton(1e-9, Start::Cold));
    assert!(cold.failures > 0, "{cold:?}");
    assert!(cold.errors.unwrap().position < 1e-9, "{cold:?}");
}

/// Past a change point a dyad lies on its other side: bisection is told, and Newton goes with it.
#[test]
fn change_points_are_passed() {
    for method in [Method::Bisection, newton(1e-6, Start::Warm)] {
        let figures = figures("kite", method);
        assert_eq!(figures.failures, 0, "{method:?}");
        assert!(figures.errors.unwrap().position < 1e-9, "{method:?}");
    }
}

#[test]
fn a_study_can_be_read_before_its_end() {
    let mut study = study("four-bar", &all_methods(USUAL_CYCLES), 360);
    assert_eq!(study.progress(), 0.0);
    let mut clock = made_up();
    let (mut last, mut slices) = (0.0, 0);
    // Until the integrations begin.
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
        // The short integrations may be done within the last slice.
        assert!(!is_pending || is_integration(finding.method), "{finding:?}");
    }
    let last = findings.methods.last().unwrap();
    assert_eq!(last.verdict, MethodVerdict::Pending);
}

#[test]
fn letters_follow_each_other_and_the_best_never_fail() {
    let list: Vec<Method> = all_methods(USUAL_CYCLES);
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
