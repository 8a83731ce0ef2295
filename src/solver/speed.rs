//! The same motion at another speed of the driver.

use super::Solver;

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
}

#[cfg(test)]
mod tests {
    use crate::scene::{Scene, presets};
    use crate::solver::{Order, Solver};

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
