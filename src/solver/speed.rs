//! The same motion at another speed of the driver.

use super::engine::rates;
use super::state::{Rates, State};
use super::{Solver, Workspace};
use crate::{Constant, DriverMoment, Input, Number};

/// A degree in radians, rounded up.
const RADIAN: f64 = 0.017_453_292_519_943_3;

impl Solver {
    /// The same solver with another speed and acceleration of its driver, in rad/s and rad/s^2 or in the
    /// scene's length unit per s and s^2. The geometry is not solved anew: with a speed of 1 and no
    /// acceleration the rates are derivatives by the driver's coordinate, and with the opposite speed
    /// they are those of the way back.
    #[must_use]
    pub fn at_speed(&self, speed: f64, acceleration: f64) -> Solver {
        let mechanism = self.mechanism.at_speed(speed, acceleration);
        Solver {
            engine: self.engine.at_speed_of(&mechanism),
            mechanism,
            ..self.clone()
        }
    }

    /// From the next solution on, the driver of these states passes with the speed and the acceleration of a moment
    /// of its motion over time; so does that of an enclosure, which has to be told too. Allocates nothing.
    pub fn drive<T: Number>(&self, work: &mut Workspace<T>, moment: &DriverMoment) {
        let given = [moment.speed, moment.acceleration];
        let [at, off @ ..] = moment.off;
        let (rates, off) = match self.mechanism.driver().input {
            Input::Turn(_) => (
                rates(given.map(f64::to_radians), 1.0, true),
                off.map(|off| off * RADIAN),
            ),
            Input::Push(_) => {
                let scale = self.engine.frame.scale;
                (rates(given, scale, true), off.map(|off| off / scale))
            }
        };
        let rates = [rates[0].widened(off[0]), rates[1].widened(off[1])];
        work.errors.driven = at;
        work.state.pass(rates);
        // What bounds are found by goes with it.
        if let Some(sharp) = &mut work.errors.sharp {
            sharp.state.pass(rates);
        }
        if let Some(edge) = &mut work.errors.edge {
            edge.pass(rates);
        }
        if let Some(close) = &mut work.close {
            close.pass(rates);
        }
    }
}

impl<T: Number> State<T> {
    /// The driver has this speed and acceleration, in the solver's units.
    fn pass(&mut self, [speed, acceleration]: [Constant; 2]) {
        self.rates = Rates::new(speed, acceleration);
        self.length_rates = self.rates.times(self.frame.scale);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantity::Catalogue;
    use crate::scene::{Scene, presets};
    use crate::solver::Order;

    /// Everything that a solver of that speed finds, forces and bounds included.
    #[test]
    fn a_driven_state_is_that_of_a_solver_at_this_speed() {
        for name in ["four-bar", "excavator-boom", "press-ram", "press"] {
            let scene = Scene::parse(presets::find(name).unwrap().text, name).unwrap();
            let solver = Solver::new(&scene.mechanism).unwrap();
            let (speed, acceleration) = (0.75, -3.0);
            let turns = matches!(scene.mechanism.driver().input, Input::Turn(_));
            let scale = if turns { 1.0_f64.to_degrees() } else { 1.0 };
            let at = scene.mechanism.driver().start + 0.125;
            let moment = DriverMoment {
                at,
                speed: speed * scale,
                acceleration: acceleration * scale,
                off: [0.0; 3],
            };
            let other = solver.at_speed(moment.speed / scale, moment.acceleration / scale);
            let (mut one, mut two) = (solver.state(), other.state());
            let (mut ball, mut bare) = (solver.enclosure(), other.enclosure());
            solver.drive(&mut one, &moment);
            solver.drive(&mut ball, &moment);
            let _ = solver.solve(at, Order::Force, &mut one);
            let _ = other.solve(at, Order::Force, &mut two);
            solver.enclose(&mut one, Order::Force, &mut ball);
            other.enclose(&mut two, Order::Force, &mut bare);
            for point in scene.mechanism.point_ids() {
                let [driven, meant] = [&ball, &bare].map(|ball| ball.acceleration(point));
                assert_eq!(driven.is_some(), meant.is_some(), "{name}");
                for (driven, meant) in driven.into_iter().zip(meant) {
                    let apart = (driven.nearest() - meant.nearest()).norm();
                    assert!(apart <= 1e-11 * meant.nearest().norm(), "{name} {apart}");
                }
            }
            for figure in Catalogue::new(&scene).all() {
                let [one, two] = [&one, &two].map(|state| figure.value(state));
                let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * (a.abs() + b.abs());
                let agree = one.zip(two).map_or(one == two, |(a, b)| near(a, b));
                assert!(agree, "{name} {}: {one:?} {two:?}", figure.name);
            }
        }
    }

    #[test]
    fn another_speed_gives_what_a_scene_of_that_speed_gives() {
        for (name, given, other) in [
            ("four-bar", "15 rad/s", "-2.5 rad/s"),
            ("excavator-boom", "0.15 m/s", "-0.4 m/s"),
            ("press-ram", "10 rad/s", "1 rad/s"),
        ] {
            let preset = presets::find(name).unwrap();
            let opened = |text: &str| {
                let scene = Scene::parse(text, name).unwrap();
                Solver::new(&scene.mechanism).unwrap()
            };
            let text = preset.text.replace(given, other);
            assert_ne!(text, preset.text, "{name} has another speed now");
            let speed: f64 = other.split(' ').next().unwrap().parse().unwrap();
            let paced = opened(preset.text).at_speed(speed, 0.0);
            let whole = opened(&text);
            let scene = Scene::parse(&text, name).unwrap();
            let at = scene.mechanism.driver().start + 0.125;
            let (mut one, mut two) = (paced.state(), whole.state());
            let _ = paced.solve(at, Order::Acceleration, &mut one);
            let _ = whole.solve(at, Order::Acceleration, &mut two);
            for point in scene.mechanism.point_ids() {
                assert_eq!(
                    one.velocity(point).unwrap(),
                    two.velocity(point).unwrap(),
                    "{name}"
                );
                assert_eq!(
                    one.acceleration(point).unwrap(),
                    two.acceleration(point).unwrap(),
                    "{name}"
                );
            }
        }
    }
}
