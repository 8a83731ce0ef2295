//! The dead centres of a slide: where it turns back.
//!
//! Its position s over the driver's coordinate q is smooth but at dead points, and s' comes with every
//! state: a dead centre is a root of s', as good as the coordinate itself.

use super::{Condition, Demand, Order, Range, Solver};
use crate::SlideId;
use crate::numeric::roots;

/// Places over the motion between which s' changes its sign once at the most.
const LOOKS: u32 = 720;
/// A dead point has no rates; it is looked at from this far inside, as a part of the range.
const INSIDE: f64 = 1e-9;

/// A place at which a slide turns back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeadCentre {
    /// The driver's coordinate, in degrees or in the scene's length unit.
    pub at: f64,
    /// The position along the guide, in the scene's length unit.
    pub position: f64,
}

impl Solver {
    /// The dead centres of a slide over the motion, by coordinate: over one period, which may begin a
    /// little behind 0, or over the range with both of its ends, where the driver turns. None for a slide
    /// that stands still, or goes one way, round and round.
    #[must_use]
    pub fn dead_centres(&self, slide: SlideId) -> Vec<DeadCentre> {
        let solver = self.only(&Demand {
            slides: vec![slide],
            ..Demand::default()
        });
        let mut state = solver.state();
        let (low, high) = self.motion.range.ends();
        // Beside round coordinates, where symmetry puts dead centres.
        let place = |k: u32| low + (high - low) * (f64::from(k) + 0.5) / f64::from(LOOKS);
        let finest = self.engine.finest();
        let slope = |at| match solver.solve(at, Order::Velocity, &mut state) {
            Condition::Ok | Condition::ChangePoint => Some(state.travels[slide.index()].v),
            Condition::DeadPoint | Condition::NoAssembly => None,
        };
        let turns = match self.motion.range {
            // Round the end of the period to the first place again.
            Range::Full { .. } => roots((0..=LOOKS).map(place), finest, slope),
            Range::Limited { .. } => {
                let inside = INSIDE * (high - low);
                let first = [low + inside].into_iter();
                let places = first.chain((0..LOOKS).map(place)).chain([high - inside]);
                let mut turns = roots(places, finest, slope);
                turns.insert(0, low);
                turns.push(high);
                turns
            }
        };
        let centre = |at| {
            let exists = solver.solve(at, Order::Position, &mut state) != Condition::NoAssembly;
            let position = state.sliding(slide).position;
            exists.then_some(DeadCentre { at, position })
        };
        turns.into_iter().filter_map(centre).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

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

    /// Crank 10 and rod 20 along a guide: stretched and folded where the crank lies on it. One of the
    /// guides lies where the crank is looked at first.
    #[test]
    fn a_slider_crank_turns_where_crank_and_rod_are_in_line() {
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
    fn the_ends_of_a_range_are_dead_centres_too() {
        close(
            &centres(PUSHED),
            &[(-100.0, 0.0), (0.0, 100.0), (100.0, 0.0)],
        );
    }

    #[test]
    fn a_slide_that_stands_still_has_none() {
        let text = "unit = \"mm\"\n[ground]\nA = [0, 0]\nD = [50, 0]\n[driver]\nlink = \"crank\"\nangle = 0\n[links]\n\
            crank = { from = \"A\", to = \"B\", length = 10 }\n\
            stay = { from = \"D\", to = \"E\", length = 20 }\n[slides]\n\
            s = { point = \"E\", on = \"ground\", through = \"A\", angle = 0 }\n[start]\nE = [70, 0]\n";
        close(&centres(text), &[]);
    }
}
