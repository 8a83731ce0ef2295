//! Lists all quantities of a scene by name.

use super::{Aspect, Quantity, QuantitySource, Share, Subject, magnitude};
use crate::expression::{LengthScale, Part};
use crate::nearest::nearest;
use crate::scene::Scene;
use crate::solver::Order;
use crate::wording::words;
use crate::{Input, Slider};
use std::collections::HashSet;
use thiserror::Error;

/// All quantities of a scene, in the order of the file.
///
/// Besides the listed quantities, some are available by name only: those defined by formulas, and
/// the magnitudes and directions of vectors.
#[derive(Clone, Debug)]
pub struct Catalogue {
    quantities: Vec<Quantity>,
    /// The names of marks' quantities, which are shown only if named.
    of_marks: Vec<String>,
    /// The quantities defined by formulas.
    pub(super) defined: Vec<Quantity>,
    pub(super) length: LengthScale,
    /// The numbers that formulas can refer to.
    pub(super) parameters: Vec<(String, Part)>,
}

/// A column pattern that matches nothing in the scene.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{}", words().no_quantity(pattern, &self.fix()))]
pub struct UnknownColumn {
    /// The pattern.
    pub pattern: String,
    /// The nearest name.
    pub nearest: Option<String>,
    /// `true` if the pattern names a force in a scene without loads.
    pub nothing_acts: bool,
    /// The reason, if known.
    pub why: Option<String>,
}

impl UnknownColumn {
    fn fix(&self) -> String {
        if self.nothing_acts {
            return words().nothing_acts_on_scene().into();
        }
        let nearby = ["bound", "sensitivity"];
        let nearby = nearby.map(|kind| (kind, self.pattern.strip_suffix(kind)));
        for (kind, name) in nearby {
            if let Some(name) = name.and_then(|name| name.strip_suffix('.')) {
                let option = if kind == "bound" {
                    "--bounds"
                } else {
                    "--sensitivity"
                };
                return words().option_puts_behind(name, option, kind);
            }
        }
        if let Some(why) = &self.why {
            return format!("; {why}");
        }
        let nearest = self.nearest.as_ref();
        let intended = |near: &String| words().or_meant(&words().did_you_mean(near));
        nearest.map_or_else(String::new, intended)
    }
}

impl Catalogue {
    /// Lists the quantities of a scene: the driver, every vector, every named point, every centre
    /// of mass.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let mut catalogue = Catalogue::without_formulas(scene);
        // Errors are reported when the scene is opened.
        let _ = catalogue.define_all(&scene.figures);
        catalogue
    }

    /// Returns the scene's length unit.
    pub(crate) fn length_scale(&self) -> LengthScale {
        self.length
    }

    /// Lists the quantities of a scene without those defined by formulas.
    pub(super) fn without_formulas(scene: &Scene) -> Self {
        let mut catalogue = Catalogue {
            quantities: Vec::new(),
            of_marks: Vec::new(),
            defined: Vec::new(),
            length: LengthScale {
                symbol: scene.unit.symbol(),
                tenths_of_mm: scene.unit.tenths_of_mm(),
            },
            parameters: (scene.parameters.iter())
                .map(|parameter| {
                    let part = Part::named(parameter.number, parameter.dimension);
                    (parameter.name.clone(), part)
                })
                .collect(),
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
                let before = catalogue.quantities.len();
                catalogue.push(scene, name, Subject::Point(point), &Aspect::POINT);
                if scene.is_mark(point) {
                    let own = catalogue.quantities[before..].iter();
                    catalogue.of_marks.extend(own.map(|q| q.name.clone()));
                }
            }
        }
        if scene.mechanism.has_forces() {
            catalogue.forces(scene);
        }
        catalogue
    }

    /// Adds the driver's effort, the forces of joints and guides, and the forces on the frame.
    fn forces(&mut self, scene: &Scene) {
        let mechanism = &scene.mechanism;
        let drive = Aspect::effort_of(mechanism.driver().input);
        let total = Subject::Drive(Share::Total);
        self.push(scene, "driver", total, &[drive, Aspect::Power]);
        for share in Share::PARTS {
            let part = share.name().unwrap_or_default();
            let name = format!("driver.{}.{part}", drive.name());
            self.name(scene, name, Subject::Drive(share), drive);
        }
        self.efforts(scene);
        for link in mechanism.link_ids() {
            for point in mechanism.pins(link) {
                if let Some(name) = scene.point_name(point) {
                    let name = format!("{}.{name}", scene.link_name(link));
                    self.push(scene, &name, Subject::Joint(link, point), &Aspect::JOINT);
                }
            }
        }
        for slide in mechanism.slide_ids() {
            let is_locked = matches!(mechanism.slide(slide).slider, Slider::Link { .. });
            let aspects = [Aspect::Normal, Aspect::Moment];
            let aspects = &aspects[..if is_locked { 2 } else { 1 }];
            self.push(
                scene,
                scene.slide_name(slide),
                Subject::Slide(slide),
                aspects,
            );
        }
        self.push(scene, "ground", Subject::Frame, &Aspect::FRAME);
        for aspect in Aspect::FRAME {
            let name = format!("ground.{}.residual", aspect.name());
            self.name(scene, name, Subject::FrameResidual, aspect);
        }
    }

    /// Adds the effort of each input, if there are several.
    fn efforts(&mut self, scene: &Scene) {
        let mechanism = &scene.mechanism;
        if mechanism.timed().is_empty() {
            return;
        }
        for input in mechanism.inputs() {
            match input {
                Input::Turn(link) => {
                    let name = scene.link_name(link);
                    self.push(scene, name, Subject::Link(link), &[Aspect::Torque]);
                }
                Input::Push(slide) => {
                    let name = scene.slide_name(slide);
                    self.push(scene, name, Subject::Slide(slide), &[Aspect::Force]);
                }
            }
        }
    }

    fn push(&mut self, scene: &Scene, name: &str, subject: Subject, aspects: &[Aspect]) {
        for &aspect in aspects {
            let name = format!("{name}.{}", aspect.name());
            self.name(scene, name, subject, aspect);
        }
    }

    fn name(&mut self, scene: &Scene, name: String, subject: Subject, aspect: Aspect) {
        self.quantities.push(Quantity {
            name,
            unit: aspect.unit(scene.unit.symbol()),
            source: QuantitySource::Solved(subject, aspect),
        });
    }

    /// Returns all listed quantities, the driver's coordinate first.
    #[must_use]
    pub fn all(&self) -> &[Quantity] {
        &self.quantities
    }

    /// Returns the default columns: all listed quantities but those of marks, which do not move.
    #[must_use]
    pub fn usual(&self) -> Vec<Quantity> {
        let all = self.quantities.iter();
        all.filter(|q| !self.of_marks.contains(&q.name))
            .cloned()
            .collect()
    }

    /// Returns the driver's coordinate.
    #[must_use]
    pub fn driver(&self) -> &Quantity {
        &self.quantities[0]
    }

    /// Returns all listed quantities but those of the driver.
    #[must_use]
    pub fn figures(&self) -> Vec<Quantity> {
        let quantities = self.quantities.iter();
        quantities.filter(|q| !q.is_driver()).cloned().collect()
    }

    /// Returns the quantities available by name only, except derivatives of formulas. Those defined
    /// by formulas come first, then magnitudes and directions in the order of their components.
    #[must_use]
    pub fn unlisted(&self) -> Vec<Quantity> {
        let defined = self.defined.iter().cloned();
        defined.chain(magnitude::all(&self.quantities)).collect()
    }

    /// Returns the quantity with this name, listed or not.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<Quantity> {
        let listed = self.quantities.iter().find(|q| q.name == name);
        listed.cloned().or_else(|| self.build_quantity(name).ok())
    }

    /// Returns the quantities that match the patterns, in the order of the patterns, without
    /// duplicates.
    ///
    /// `*` matches any run of characters in listed names; other quantities match by their full
    /// name. The driver's coordinate is left out because it always comes first.
    ///
    /// # Errors
    /// The first pattern that matches nothing, with the nearest name.
    pub fn select(&self, patterns: &[impl AsRef<str>]) -> Result<Vec<Quantity>, UnknownColumn> {
        let mut selected: Vec<Quantity> = Vec::new();
        // Few quantities share a name, so few are compared with all others.
        let mut names: HashSet<String> = HashSet::new();
        let mut add = |quantity: &Quantity| {
            if names.insert(quantity.name.clone()) || !selected.contains(quantity) {
                selected.push(quantity.clone());
            }
        };
        for pattern in patterns {
            let pattern = pattern.as_ref();
            let mut any = false;
            for quantity in self.quantities.iter().filter(|q| matches(pattern, &q.name)) {
                any = true;
                if !quantity.is_driver() {
                    add(quantity);
                }
            }
            if any {
                continue;
            }
            let made = self
                .build_quantity(pattern)
                .map_err(|why| self.unknown(pattern, why))?;
            add(&made);
        }
        Ok(selected)
    }

    /// Returns `true` if a pattern names a force and the scene has no forces.
    fn has_no(&self, pattern: &str) -> bool {
        let is_force = |aspect: &Aspect| aspect.order() == Order::Force;
        let mut own = self.quantities.iter().filter_map(Quantity::aspect);
        let requested = [Aspect::Torque, Aspect::Force, Aspect::Power, Aspect::Normal];
        let requested = requested.into_iter().chain(Aspect::FRAME);
        let mut requested = requested.map(|aspect| format!(".{}", aspect.name()));
        let is_size = [".f", ".f.angle"].iter().any(|end| pattern.ends_with(end));
        let is_asked = is_size || requested.any(|name| pattern.contains(&name));
        is_asked && !own.any(|aspect| is_force(&aspect))
    }

    fn unknown(&self, pattern: &str, why: Option<String>) -> UnknownColumn {
        let unlisted = self.unlisted();
        let names = self.quantities.iter().chain(&unlisted);
        let names = names.map(|q| q.name.as_str());
        UnknownColumn {
            why: why.or_else(|| self.difference(pattern)),
            pattern: pattern.into(),
            nearest: nearest(pattern, names).map(str::to_owned),
            nothing_acts: self.has_no(pattern),
        }
    }
}

/// Returns `true` if `name` matches `pattern`, where `*` matches any run of characters.
///
/// Each piece between two stars takes the first position where it matches. If any choice matches,
/// this one does, and the cost does not grow with the number of stars.
fn matches(pattern: &str, name: &str) -> bool {
    let Some((head, rest)) = pattern.split_once('*') else {
        return pattern == name;
    };
    let Some(mut left) = name.strip_prefix(head) else {
        return false;
    };
    let (pieces, tail) = rest.rsplit_once('*').unwrap_or(("", rest));
    for piece in pieces.split('*') {
        let Some((_, after)) = left.split_once(piece) else {
            return false;
        };
        left = after;
    }
    left.ends_with(tail)
}

#[cfg(test)]
mod tests {
    use super::super::value;
    use super::*;
    use crate::scene::presets;
    use crate::solver::Solver;
    use proptest::prelude::*;

    fn slider_crank() -> Scene {
        let preset = presets::find("slider-crank").unwrap();
        Scene::parse(preset.text, preset.name).unwrap()
    }

    #[test]
    fn only_listed_quantities_have_values() {
        let scene = slider_crank();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let mut state = solver.state();
        let _ = solver.solve(30.0, Order::Acceleration, &mut state);
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
    fn select_follows_pattern_order_without_duplicates() {
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
        let nothing = catalogue.select(&["driver.torque"]).unwrap_err();
        assert!(
            nothing.to_string().contains("no loads, springs or masses"),
            "{nothing}"
        );
    }

    /// Unlisted quantities are found and suggested by name, but never matched by a star.
    #[test]
    fn unlisted_quantities_are_selected_only_by_name() {
        let mut catalogue = Catalogue::new(&slider_crank());
        let listed = catalogue.all().len();
        catalogue.define("way = hypot(C.x, C.y)").unwrap();
        assert_eq!(catalogue.all().len(), listed);
        for name in ["C.v", "r3.com.a.n", "A.v.angle", "way", "way.rate"] {
            let selected = catalogue.select(&[name, "C.x", name]).unwrap();
            let names: Vec<_> = selected.iter().map(|q| q.name.as_str()).collect();
            assert_eq!(names, [name, "C.x"]);
        }
        let starred = catalogue.select(&["*"]).unwrap();
        assert_eq!(starred, catalogue.figures());
        assert!(catalogue.select(&["way*"]).is_err());
        let unlisted = catalogue.unlisted();
        assert_eq!(unlisted[0].name, "way");
        for quantity in &unlisted {
            assert_eq!(catalogue.find(&quantity.name).as_ref(), Some(quantity));
        }
        let near = catalogue.select(&["C.a.angel"]).unwrap_err().nearest;
        assert_eq!(near.as_deref(), Some("C.a.angle"));
    }

    /// Matches a pattern by trying all possibilities.
    fn tried_out(pattern: &[u8], name: &[u8]) -> bool {
        match pattern.split_first() {
            None => name.is_empty(),
            Some((b'*', rest)) => (0..=name.len()).any(|i| tried_out(rest, &name[i..])),
            Some((c, rest)) => name.first() == Some(c) && tried_out(rest, &name[1..]),
        }
    }

    proptest! {
        #[test]
        fn star_matching_agrees_with_brute_force(pattern in "[ab*]{0,7}", name in "[ab]{0,9}") {
            prop_assert_eq!(matches(&pattern, &name), tried_out(pattern.as_bytes(), name.as_bytes()));
        }
    }

    #[test]
    fn many_stars_do_not_take_exponential_time() {
        assert!(!matches(&"a*".repeat(40), &format!("{}b", "b".repeat(64))));
        assert!(!matches(&format!("{}c", "*a".repeat(30)), &"a".repeat(64)));
    }
}
