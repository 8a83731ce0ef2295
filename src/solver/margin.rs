//! How far a state is from a singularity, group by group.

use super::{Condition, Order, Solver, Workspace};

impl Solver {
    /// For every group of the plan how far it is from a singularity at a coordinate of the driver: of a dyad
    /// the square of the sine of its transmission angle, or what plays that part, 0 at a dead point or a change
    /// point; of a coupled group the size of its determinant, which tells along one motion alone. 1 for a group
    /// that has no singularity. `None` where the state is not an ordinary one.
    #[must_use]
    pub fn margins(&self, at: f64, work: &mut Workspace) -> Option<Vec<f64>> {
        if self.solve(at, Order::Position, work) != Condition::Ok {
            return None;
        }
        self.engine.measure_coupled(at, work);
        Some(work.measures.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Scene, presets};

    #[test]
    fn a_dyad_tells_the_square_of_its_sine() {
        let preset = presets::find("four-bar").unwrap();
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let mut work = solver.state();
        let margins = solver.margins(60.0, &mut work).unwrap();
        // The lectures' transmission angle at 60 deg, from the reference values.
        let sine: f64 = 0.988_685_996_664_259_4;
        assert!((margins[1] - sine * sine).abs() < 1e-12, "{margins:?}");
        assert_eq!(margins[0], 1.0);
    }

    #[test]
    fn a_coupled_group_is_measured_where_it_stands() {
        let preset = presets::find("stephenson-six-bar").unwrap();
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let mut work = solver.state();
        let mut at = |degrees| solver.margins(degrees, &mut work).unwrap()[1];
        assert!(at(60.0) > 0.0 && at(60.0) != at(120.0));
        assert_eq!(at(60.0).to_bits(), at(60.0).to_bits());
    }
}
