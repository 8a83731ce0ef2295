//! Extreme ratios of lengths: mobility and singularities do not depend on them.

use krank::scene::Scene;
use krank::solver::{Fault, Solver};

fn opened(text: &str) -> Result<Solver, Fault> {
    let scene = Scene::parse(text, "test").unwrap();
    Solver::new(&scene.mechanism)
}

const RATIOS: [f64; 7] = [1.0, 1e-3, 1e-6, 1e-9, 1e-12, 4.4e-16, 1e-20];

/// A kite whose crank lies along its frame: C may be anywhere on the circle around B and D. At all
/// other angles the mobility is 1, and both assemblies are listed.
#[test]
fn kite_is_singular_only_where_its_pivots_meet() {
    for tiny in RATIOS {
        let kite = |angle: f64| {
            opened(&format!(
                "unit = \"mm\"\n[ground]\nA = [0, 0]\nD = [{tiny}, 0]\n[driver]\nlink = \"r2\"\nangle = {angle}\n[links]\n\
                 r2 = {{ from = \"A\", to = \"B\", length = {tiny} }}\nr3 = {{ from = \"B\", to = \"C\", length = 2 }}\n\
                 r4 = {{ from = \"C\", to = \"D\", length = 2 }}\n[start]\nC = [1.2, 1.6]\n"
            ))
        };
        let fault = kite(0.0).unwrap_err();
        assert!(
            matches!(
                fault,
                Fault::Singular {
                    is_here_only: true,
                    ..
                }
            ),
            "{tiny:e} {fault:?}"
        );
        for angle in [60.0, 90.0, 180.0] {
            let solver = kite(angle).unwrap();
            assert_eq!(solver.plan().mobility, 1, "{tiny:e} {angle}");
            let all = solver.assemblies(angle);
            assert_eq!(all.list.len(), 2, "{tiny:e} {angle}");
            assert!(all.current.is_some(), "{tiny:e} {angle}");
        }
    }
}

/// A lever whose slot passes through its pivot, with the crank's pin there.
#[test]
fn lever_is_singular_only_with_pin_in_its_pivot() {
    for tiny in RATIOS {
        let lever = |angle: f64| {
            opened(&format!(
                "unit = \"mm\"\n[ground]\nA = [0, 0]\nD = [{tiny}, 0]\n[driver]\nlink = \"r2\"\nangle = {angle}\n[links]\n\
                 r2 = {{ from = \"A\", to = \"B\", length = {tiny} }}\nr3 = {{ points = {{ D = [0, 0], P = [1, 0] }} }}\n\
                 [slides]\ns = {{ point = \"B\", on = \"r3\", through = \"D\", angle = 0 }}\n[start]\nP = [0, 1]\n"
            ))
        };
        let fault = lever(0.0).unwrap_err();
        assert!(
            matches!(
                fault,
                Fault::Singular {
                    is_here_only: true,
                    ..
                }
            ),
            "{tiny:e} {fault:?}"
        );
        assert_eq!(lever(120.0).unwrap().plan().mobility, 1, "{tiny:e}");
    }
}

/// A triad on three legs with one tiny length: a leg, the link carried by the legs, or the crank.
#[test]
fn triad_with_tiny_link_has_mobility_one() {
    let distance = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    for tiny in [1e-3, 1e-6, 1e-9, 1e-11] {
        for (crank, link, leg) in [(0.5, 1.0, tiny), (0.5, tiny, 1.0), (tiny, 1.0, 1.0)] {
            let pin = [0.5 * crank, 0.75_f64.sqrt() * crank];
            let [p, q] = [[2.0 + link, 2.0], [2.0 + 0.4 * link, 2.0 + 0.7 * link]];
            let text = format!(
                "unit = \"mm\"\n[ground]\nA = [0, 0]\nD = [{}, 2]\nE = [3, -2]\n[driver]\nlink = \"r2\"\nangle = 60\n[links]\n\
                 r2 = {{ from = \"A\", to = \"B\", length = {crank} }}\n\
                 r3 = {{ from = \"B\", to = \"C\", length = {} }}\n\
                 t = {{ from = \"C\", to = \"P\", length = {link}, points = {{ Q = [{}, {}] }} }}\n\
                 r4 = {{ from = \"P\", to = \"D\", length = {} }}\nr5 = {{ from = \"Q\", to = \"E\", length = {} }}\n\
                 [start]\nC = [2, 2]\nP = [{}, 2]\nQ = [{}, {}]\n",
                p[0] + leg,
                distance(pin, [2.0, 2.0]),
                0.4 * link,
                0.7 * link,
                leg,
                distance(q, [3.0, -2.0]),
                p[0],
                q[0],
                q[1]
            );
            let solver = opened(&text).unwrap_or_else(|fault| panic!("{text}{fault:?}"));
            assert_eq!(solver.plan().mobility, 1, "{text}");
        }
    }
}
