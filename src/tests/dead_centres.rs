//! Tests the dead centres of slides.

use crate::scene::Scene;
use crate::solver::{DeadCentre, Solver};

fn centres(text: &str) -> Vec<DeadCentre> {
    let scene = Scene::parse(text, "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let slide = scene.mechanism.slide_ids().last().unwrap();
    solver.dead_centres(slide)
}

fn close(found: &[DeadCentre], wanted: &[(f64, f64)]) {
    assert_eq!(found.len(), wanted.len(), "{found:?}");
    for (found, wanted) in found.iter().zip(wanted) {
        let is_close = |a: f64, b: f64| (a - b).abs() < 1e-12;
        assert!(
            is_close(found.at, wanted.0) && is_close(found.position, wanted.1),
            "{found:?} {wanted:?}"
        );
    }
}

/// A crank of 10 and a rod of 20 are in line with the guide at the dead centres. For one guide this
/// is where the search starts.
#[test]
fn slider_crank_dead_centres_have_crank_and_rod_in_line() {
    for direction in [0.0, 0.25, 30.0, 200.0] {
        let text = format!(
            "unit = \"mm\"\n[ground]\nA = [0, 0]\n[driver]\nlink = \"crank\"\nangle = {}\n[links]\n\
             crank = {{ from = \"A\", to = \"B\", length = 10 }}\n\
             rod = {{ from = \"B\", to = \"C\", length = 20 }}\n[slides]\n\
             s = {{ point = \"C\", on = \"ground\", through = \"A\", angle = {direction} }}\n\
             [start]\nC = [{}, {}]\n",
            direction,
            30.0 * f64::to_radians(direction).cos(),
            30.0 * f64::to_radians(direction).sin(),
        );
        let mut wanted = [(direction, 30.0), ((direction + 180.0) % 360.0, 10.0)];
        wanted.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut found = centres(&text);
        let first = |c: &mut DeadCentre| c.at -= if c.at > 359.9 { 360.0 } else { 0.0 };
        found.iter_mut().for_each(first);
        found.sort_by(|a, b| a.at.total_cmp(&b.at));
        close(&found, &wanted);
    }
}

const PUSHED: &str = "unit = \"mm\"\n[driver]\nslide = \"push\"\nposition = 60\n[links]\n\
    rod = { from = \"P\", to = \"Q\", length = 100 }\n[slides]\n\
    push = { point = \"P\", on = \"ground\", through = [0, 0], angle = 0 }\n\
    s = { point = \"Q\", on = \"ground\", through = [0, 0], angle = 90 }\n[start]\nQ = [0, 80]\n";

#[test]
fn ends_of_range_are_dead_centres() {
    close(
        &centres(PUSHED),
        &[(-100.0, 0.0), (0.0, 100.0), (100.0, 0.0)],
    );
}

#[test]
fn slide_at_rest_has_no_dead_centres() {
    let text = "unit = \"mm\"\n[ground]\nA = [0, 0]\nD = [50, 0]\n[driver]\nlink = \"crank\"\nangle = 0\n[links]\n\
        crank = { from = \"A\", to = \"B\", length = 10 }\n\
        stay = { from = \"D\", to = \"E\", length = 20 }\n[slides]\n\
        s = { point = \"E\", on = \"ground\", through = \"A\", angle = 0 }\n[start]\nE = [70, 0]\n";
    close(&centres(text), &[]);
}
