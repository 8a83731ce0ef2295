//! Everything that has a name, a unit and a value.
//!
//! Tables, plots, CSV columns, JSON keys and the demand given to the solver all come from here.

mod clock;
mod curves;
mod extrema;
mod sensitivity;

pub use clock::Clock;
pub use curves::{Abscissa, Curve, Curves, Here, NoTime};
pub use extrema::Extremum;
pub use sensitivity::{Derivatives, MOST_DERIVATIVES, Sensitivity};

use crate::nearest::nearest;
use crate::scene::{Scene, VectorKind};
use crate::solver::{Condition, Demand, Order, State};
use crate::{Ball, Input, LinkId, Number, PointId, SlideId, Vec2, angle};
use thiserror::Error;

/// What a quantity is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// The driver.
    Driver,
    /// A point.
    Point(PointId),
    /// A link: its direction and turning.
    Link(LinkId),
    /// A slide, read as a vector from the sliding point back to `through`.
    Slide(SlideId),
    /// The vector from one point to another.
    Between(PointId, PointId),
}

impl From<VectorKind> for Subject {
    fn from(kind: VectorKind) -> Self {
        match kind {
            VectorKind::Link(link) => Subject::Link(link),
            VectorKind::Slide(slide) => Subject::Slide(slide),
            VectorKind::Between(tail, head) => Subject::Between(tail, head),
        }
    }
}

/// Which of its figures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aspect {
    /// Position along x.
    X,
    /// Position along y.
    Y,
    /// Velocity along x.
    Vx,
    /// Velocity along y.
    Vy,
    /// Acceleration along x.
    Ax,
    /// Acceleration along y.
    Ay,
    /// Direction in degrees, from 0 to below 360; the driver's is not wrapped.
    Angle,
    /// Angular velocity in rad/s.
    Omega,
    /// Angular acceleration in rad/s^2.
    Alpha,
    /// Length; for a slide the signed position along the guide.
    Length,
    /// The rate of the length.
    Rate,
    /// The rate of the rate.
    Accel,
}

impl Aspect {
    const POINT: [Aspect; 6] = [
        Aspect::X,
        Aspect::Y,
        Aspect::Vx,
        Aspect::Vy,
        Aspect::Ax,
        Aspect::Ay,
    ];
    /// Of what turns, by [`Order`].
    pub(crate) const TURNING: [Aspect; 3] = [Aspect::Angle, Aspect::Omega, Aspect::Alpha];
    /// Of what changes its length, by [`Order`].
    pub(crate) const STRETCHING: [Aspect; 3] = [Aspect::Length, Aspect::Rate, Aspect::Accel];

    /// As in a column's name, behind the dot.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Aspect::X => "x",
            Aspect::Y => "y",
            Aspect::Vx => "vx",
            Aspect::Vy => "vy",
            Aspect::Ax => "ax",
            Aspect::Ay => "ay",
            Aspect::Angle => "angle",
            Aspect::Omega => "omega",
            Aspect::Alpha => "alpha",
            Aspect::Length => "length",
            Aspect::Rate => "rate",
            Aspect::Accel => "accel",
        }
    }

    /// How far a state must be solved for it.
    #[must_use]
    pub fn order(self) -> Order {
        match self {
            Aspect::X | Aspect::Y | Aspect::Angle | Aspect::Length => Order::Position,
            Aspect::Vx | Aspect::Vy | Aspect::Omega | Aspect::Rate => Order::Velocity,
            Aspect::Ax | Aspect::Ay | Aspect::Alpha | Aspect::Accel => Order::Acceleration,
        }
    }

    /// Its unit, in a scene whose lengths are in `length`.
    #[must_use]
    pub fn unit(self, length: &str) -> String {
        let is_angle = matches!(self, Aspect::Angle | Aspect::Omega | Aspect::Alpha);
        match (is_angle, self.order()) {
            (true, Order::Position) => "deg".into(),
            (true, Order::Velocity) => "rad/s".into(),
            (true, Order::Acceleration) => "rad/s^2".into(),
            (false, Order::Position) => length.into(),
            (false, Order::Velocity) => format!("{length}/s"),
            (false, Order::Acceleration) => format!("{length}/s^2"),
        }
    }
}

/// A figure that can be shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// The column's name: `C.vx`, `r3.omega`, `r4.length`, `r3.com.x`.
    pub name: String,
    /// The unit: `mm/s`.
    pub unit: String,
    /// What it is about.
    pub subject: Subject,
    /// Which figure.
    pub aspect: Aspect,
}

impl Quantity {
    /// The value in this state, or `None` where none exists.
    #[must_use]
    pub fn value<T: Number>(&self, state: &State<T>) -> Option<T> {
        value(self.subject, self.aspect, state)
    }

    /// How far the value in this state can be from the true one, in the same unit; `None` where
    /// there is no value, or no bound can be proved.
    #[must_use]
    pub fn bound(&self, state: &State, enclosure: &State<Ball>) -> Option<f64> {
        bound(self.subject, self.aspect, state, enclosure)
    }

    /// The name with the unit in brackets, as a column's header.
    #[must_use]
    pub fn header(&self) -> String {
        format!("{} [{}]", self.name, self.unit)
    }
}

/// The value of one figure in this state, or `None` where none exists: at a dead point there are no
/// rates, without an assembly there is nothing but the driver, and a subject has no figures that are
/// not its own (a point does not turn, a link keeps its length).
#[must_use]
pub fn value<T: Number>(subject: Subject, aspect: Aspect, state: &State<T>) -> Option<T> {
    let exists = match state.condition() {
        Condition::Ok | Condition::ChangePoint => true,
        Condition::DeadPoint => aspect.order() == Order::Position,
        Condition::NoAssembly => false,
    };
    let value = match subject {
        Subject::Driver => Some(driver_value(aspect, state)),
        _ if !exists => None,
        Subject::Point(point) => point_value(point, aspect, state),
        Subject::Link(link) => link_value(link, aspect, state),
        Subject::Slide(slide) => slide_value(slide, aspect, state),
        Subject::Between(tail, head) => between_value(tail, head, aspect, state),
    };
    value.filter(|v| v.is_finite())
}

/// How far a figure of this state can be from the true one, if that can be proved; `enclosure` is
/// what [`Solver::enclose`](crate::solver::Solver::enclose) made of the state.
#[must_use]
pub fn bound(
    subject: Subject,
    aspect: Aspect,
    state: &State,
    enclosure: &State<Ball>,
) -> Option<f64> {
    let value = value(subject, aspect, state)?;
    let ball = self::value(subject, aspect, enclosure)?;
    // Directions just before and just after a full turn are close.
    let turn = if aspect == Aspect::Angle && (value - ball.mid).abs() > angle::TURN / 2.0 {
        angle::TURN.copysign(ball.mid - value)
    } else {
        0.0
    };
    ball.bound(value + turn)
}

/// What a state is, in the word that the `state` column uses.
#[must_use]
pub fn state_word(condition: Condition) -> &'static str {
    match condition {
        Condition::Ok => "ok",
        Condition::DeadPoint => "dead-point",
        Condition::ChangePoint => "change-point",
        Condition::NoAssembly => "no-assembly",
    }
}

fn driver_value<T: Number>(aspect: Aspect, state: &State<T>) -> T {
    match aspect.order() {
        Order::Position => state.at(),
        Order::Velocity => state.driver_speed(),
        Order::Acceleration => state.driver_acceleration(),
    }
}

fn point_value<T: Number>(point: PointId, aspect: Aspect, state: &State<T>) -> Option<T> {
    match aspect {
        Aspect::X => Some(state.position(point).x),
        Aspect::Y => Some(state.position(point).y),
        Aspect::Vx => Some(state.velocity(point).x),
        Aspect::Vy => Some(state.velocity(point).y),
        Aspect::Ax => Some(state.acceleration(point).x),
        Aspect::Ay => Some(state.acceleration(point).y),
        Aspect::Angle
        | Aspect::Omega
        | Aspect::Alpha
        | Aspect::Length
        | Aspect::Rate
        | Aspect::Accel => None,
    }
}

fn link_value<T: Number>(link: LinkId, aspect: Aspect, state: &State<T>) -> Option<T> {
    match aspect {
        Aspect::Angle => Some(state.angle(link)),
        Aspect::Omega => Some(state.omega(link)),
        Aspect::Alpha => Some(state.alpha(link)),
        Aspect::X
        | Aspect::Y
        | Aspect::Vx
        | Aspect::Vy
        | Aspect::Ax
        | Aspect::Ay
        | Aspect::Length
        | Aspect::Rate
        | Aspect::Accel => None,
    }
}

fn slide_value<T: Number>(slide: SlideId, aspect: Aspect, state: &State<T>) -> Option<T> {
    let travel = state.travel(slide);
    match aspect {
        Aspect::Length => Some(travel.position),
        Aspect::Rate => Some(travel.rate),
        Aspect::Accel => Some(travel.accel),
        // The vector runs from the sliding point back to `through`, against the guide.
        Aspect::Angle => Some(T::degrees(-travel.guide)),
        Aspect::Omega => Some(travel.omega),
        Aspect::Alpha => Some(travel.alpha),
        Aspect::X | Aspect::Y | Aspect::Vx | Aspect::Vy | Aspect::Ax | Aspect::Ay => None,
    }
}

/// Of r = head - tail: r' = r.v / |r|, omega = (r x v) / r.r, and once more for the second rates.
fn between_value<T: Number>(
    tail: PointId,
    head: PointId,
    aspect: Aspect,
    state: &State<T>,
) -> Option<T> {
    let r = state.position(head) - state.position(tail);
    let length = r.norm();
    // Velocity and acceleration of the head as seen from the tail, along r and across it.
    let split = |vector: Vec2<T>| ((r / length).dot(vector), (r / length).cross(vector));
    let first = || split(state.velocity(head) - state.velocity(tail));
    let second = || split(state.acceleration(head) - state.acceleration(tail));
    match aspect {
        Aspect::Length => Some(length),
        Aspect::Rate => Some(first().0),
        Aspect::Accel => {
            let omega = first().1 / length;
            Some(second().0 + length * omega * omega)
        }
        Aspect::Angle => Some(T::degrees(r)),
        Aspect::Omega => Some(first().1 / length),
        Aspect::Alpha => {
            let (rate, across) = first();
            let omega = across / length;
            Some((second().1 - (rate * omega).scaled(2.0)) / length)
        }
        Aspect::X | Aspect::Y | Aspect::Vx | Aspect::Vy | Aspect::Ax | Aspect::Ay => None,
    }
}

/// All quantities of a scene, in the order of the file.
#[derive(Clone, Debug)]
pub struct Catalogue {
    quantities: Vec<Quantity>,
}

/// A column pattern that names nothing in the scene.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("no quantity is named `{pattern}`{}", self.mend())]
pub struct UnknownColumn {
    /// The pattern.
    pub pattern: String,
    /// The name nearest to it.
    pub nearest: Option<String>,
}

impl UnknownColumn {
    fn mend(&self) -> String {
        let beside = ["bound", "sensitivity"];
        let beside = beside.map(|kind| (kind, self.pattern.strip_suffix(kind)));
        for (kind, name) in beside {
            if let Some(name) = name.and_then(|name| name.strip_suffix('.')) {
                let option = if kind == "bound" {
                    "--bounds"
                } else {
                    "--sensitivity"
                };
                return format!("; name `{name}`, and {option} puts `{name}.{kind}` behind it");
            }
        }
        let nearest = self.nearest.as_ref();
        nearest.map_or_else(String::new, |n| format!("; did you mean `{n}`?"))
    }
}

impl Catalogue {
    /// Lists what a scene can show: the driver, every vector, every named point, every centre of mass.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let mut catalogue = Catalogue {
            quantities: Vec::new(),
        };
        let driver_aspects = match scene.mechanism.driver().input {
            Input::Turn(_) => &[Aspect::Angle][..],
            Input::Push(_) => &[Aspect::Length][..],
        };
        catalogue.push(scene, "driver", Subject::Driver, driver_aspects);
        if let (Input::Push(_), Some(driver)) = (
            scene.mechanism.driver().input,
            catalogue.quantities.first_mut(),
        ) {
            driver.name = "driver.position".into();
        }
        for vector in &scene.vectors {
            let subject = Subject::from(vector.kind);
            if !matches!(subject, Subject::Link(_)) {
                catalogue.push(scene, &vector.name, subject, &Aspect::STRETCHING);
            }
            catalogue.push(scene, &vector.name, subject, &Aspect::TURNING);
        }
        for link in scene.mechanism.link_ids() {
            if scene.mechanism.link(link).ends.is_none() {
                catalogue.push(
                    scene,
                    scene.link_name(link),
                    Subject::Link(link),
                    &Aspect::TURNING,
                );
            }
        }
        for point in scene.mechanism.point_ids() {
            if let Some(name) = scene.point_name(point) {
                catalogue.push(scene, name, Subject::Point(point), &Aspect::POINT);
            }
        }
        catalogue
    }

    fn push(&mut self, scene: &Scene, name: &str, subject: Subject, aspects: &[Aspect]) {
        for &aspect in aspects {
            self.quantities.push(Quantity {
                name: format!("{name}.{}", aspect.name()),
                unit: aspect.unit(scene.unit.symbol()),
                subject,
                aspect,
            });
        }
    }

    /// All of them, the driver's coordinate first.
    #[must_use]
    pub fn all(&self) -> &[Quantity] {
        &self.quantities
    }

    /// The driver's coordinate.
    #[must_use]
    pub fn driver(&self) -> &Quantity {
        &self.quantities[0]
    }

    /// All but those of the driver.
    #[must_use]
    pub fn figures(&self) -> Vec<Quantity> {
        let figures = self.quantities.iter();
        figures
            .filter(|q| q.subject != Subject::Driver)
            .cloned()
            .collect()
    }

    /// The quantities that match the patterns, in the order of the patterns, each once; `*` stands
    /// for any run of characters. The driver's coordinate is left out: it always comes first.
    ///
    /// # Errors
    /// The first pattern that matches nothing, with the nearest name.
    pub fn select(&self, patterns: &[impl AsRef<str>]) -> Result<Vec<Quantity>, UnknownColumn> {
        let mut selected: Vec<Quantity> = Vec::new();
        for pattern in patterns {
            let pattern = pattern.as_ref();
            let mut any = false;
            for quantity in self.quantities.iter().filter(|q| matches(pattern, &q.name)) {
                any = true;
                if quantity.subject != Subject::Driver && !selected.contains(quantity) {
                    selected.push(quantity.clone());
                }
            }
            if !any {
                return Err(self.unknown(pattern));
            }
        }
        Ok(selected)
    }

    fn unknown(&self, pattern: &str) -> UnknownColumn {
        let names = self.quantities.iter().map(|q| q.name.as_str());
        UnknownColumn {
            pattern: pattern.into(),
            nearest: nearest(pattern, names).map(str::to_owned),
        }
    }
}

/// Whether `name` fits `pattern`, where `*` stands for any run of characters.
///
/// Each piece between two stars takes the first place where it fits: if any choice fits, this one
/// does, and many stars cost no more than a few.
fn matches(pattern: &str, name: &str) -> bool {
    let Some((head, rest)) = pattern.split_once('*') else {
        return pattern == name;
    };
    let Some(mut left) = name.strip_prefix(head) else {
        return false;
    };
    let (pieces, tail) = rest.rsplit_once('*').unwrap_or(("", rest));
    for piece in pieces.split('*') {
        let Some((_, behind)) = left.split_once(piece) else {
            return false;
        };
        left = behind;
    }
    left.ends_with(tail)
}

/// What the solver must do so that these can be read: the demand, and how far to solve.
#[must_use]
pub fn demand<'a>(quantities: impl IntoIterator<Item = &'a Quantity>) -> (Demand, Order) {
    let mut demand = Demand::default();
    let mut order = Order::Position;
    for quantity in quantities {
        if quantity.subject != Subject::Driver {
            order = order.max(quantity.aspect.order());
        }
        match quantity.subject {
            Subject::Driver => {}
            Subject::Point(point) => demand.points.push(point),
            Subject::Link(link) => demand.links.push(link),
            Subject::Slide(slide) => demand.slides.push(slide),
            Subject::Between(tail, head) => demand.points.extend([tail, head]),
        }
    }
    (demand, order)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;
    use crate::solver::Solver;
    use proptest::prelude::*;

    fn slider_crank() -> Scene {
        let preset = presets::find("slider-crank").unwrap();
        Scene::parse(preset.text, preset.name).unwrap()
    }

    #[test]
    fn every_figure_of_the_catalogue_has_a_value_and_no_other_has() {
        let scene = slider_crank();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let mut state = solver.state();
        solver.solve(30.0, Order::Acceleration, &mut state);
        let catalogue = Catalogue::new(&scene);
        assert!(catalogue.all().iter().all(|q| q.value(&state).is_some()));
        let point = |name| {
            let mut ids = scene.mechanism.point_ids();
            Subject::Point(ids.find(|&id| scene.point_name(id) == Some(name)).unwrap())
        };
        let link = Subject::Link(scene.mechanism.link_ids().next().unwrap());
        assert_eq!(value(point("C"), Aspect::Y, &state), Some(0.0));
        for (subject, aspect) in [
            (point("B"), Aspect::Angle),
            (point("B"), Aspect::Rate),
            (link, Aspect::Vx),
            (link, Aspect::Length),
        ] {
            assert_eq!(
                value(subject, aspect, &state),
                None,
                "{subject:?} {aspect:?}"
            );
        }
    }

    #[test]
    fn patterns_select_in_their_own_order_and_each_figure_once() {
        let scene = slider_crank();
        let catalogue = Catalogue::new(&scene);
        let names = |patterns: &[&str]| -> Vec<String> {
            let selected = catalogue.select(patterns).unwrap();
            selected.into_iter().map(|q| q.name).collect()
        };
        assert_eq!(
            names(&["C.v*", "C.*y", "driver.*"]),
            ["C.vx", "C.vy", "C.y", "C.ay"]
        );
        assert_eq!(
            names(&["r3.com.*x"]),
            ["r3.com.x", "r3.com.vx", "r3.com.ax"]
        );
        let unknown = catalogue.select(&["c.x"]).unwrap_err();
        assert_eq!(unknown.nearest.as_deref(), Some("C.x"));
    }

    /// What a pattern means, tried out in full.
    fn tried_out(pattern: &[u8], name: &[u8]) -> bool {
        match pattern.split_first() {
            None => name.is_empty(),
            Some((b'*', rest)) => (0..=name.len()).any(|i| tried_out(rest, &name[i..])),
            Some((c, rest)) => name.first() == Some(c) && tried_out(rest, &name[1..]),
        }
    }

    proptest! {
        #[test]
        fn stars_stand_for_any_run(pattern in "[ab*]{0,7}", name in "[ab]{0,9}") {
            prop_assert_eq!(matches(&pattern, &name), tried_out(pattern.as_bytes(), name.as_bytes()));
        }
    }

    #[test]
    fn many_stars_cost_no_more_than_a_few() {
        assert!(!matches(&"a*".repeat(40), &format!("{}b", "b".repeat(64))));
        assert!(!matches(&format!("{}c", "*a".repeat(30)), &"a".repeat(64)));
    }
}
