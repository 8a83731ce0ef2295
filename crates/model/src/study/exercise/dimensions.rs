//! Finds the dimensions of a scene and their relations.

use super::round_numbers::{agreeable, exactly};
use crate::numeric::SeededRng;
use crate::scene::{Measure, Scene, Value, ValueOwner};
use std::collections::{HashMap, HashSet};

/// The dimensions of a scene.
#[derive(Clone, Debug)]
pub(super) struct Dimensions {
    /// The distinct sizes: dimensions that are equal in the scene stay equal.
    sizes: Vec<f64>,
    list: Vec<VariedNumber>,
}

/// A dimension.
#[derive(Clone, Debug)]
struct VariedNumber {
    value: Value,
    rule: DimensionRule,
}

/// The relation of a dimension to the sizes.
#[derive(Clone, Copy, Debug, PartialEq)]
enum DimensionRule {
    /// A size, with the dimension's sign.
    Size(usize),
    /// A number of halves of a size: a centre of mass at mid-length stays there.
    Halves(usize, f64),
    /// Proportional to a size.
    With(usize),
    /// Proportional to the whole: the start of a driven slide.
    Whole,
}

/// The variation of the dimensions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum DimensionSpread {
    /// Each independently, by up to this percentage.
    Each(u32),
    /// All by the same factor.
    Together,
}

/// The factors that scale a whole scene; round numbers stay round.
const FACTORS: [f64; 8] = [0.4, 0.5, 0.8, 1.2, 1.25, 1.5, 2.0, 2.5];
/// The range of the whole's size, in percent.
const SIZE_RANGE: [u32; 2] = [60, 160];

impl Dimensions {
    /// Finds the dimensions of a scene: lengths of links, points on links and on the ground,
    /// guides, and centres of mass.
    pub(super) fn of(scene: &Scene) -> Dimensions {
        let values = scene.values();
        let lengths = LengthParameters::of(&values);
        let is_drawn = |value: &Value| is_dimension(value) || lengths.has(value);
        let values: Vec<Value> = values.iter().filter(|v| is_drawn(v)).cloned().collect();
        let lengths: Vec<(String, f64)> = scene
            .mechanism
            .link_ids()
            .filter_map(|link| {
                let name = scene.link_name(link);
                let own = format!("{name} length");
                let length = values.iter().find(|v| v.name == own)?;
                Some((format!("{name} "), length.number))
            })
            .collect();
        let mut dimensions = Dimensions {
            sizes: Vec::new(),
            list: Vec::new(),
        };
        let link_of = |value: &Value| {
            let of = lengths
                .iter()
                .filter(|(name, _)| value.name.starts_with(name));
            of.max_by_key(|(name, _)| name.len())
                .map(|(_, length)| *length)
        };
        // Lengths and ground points first: dimensions on links may depend on them.
        let is_local = |value: &Value| is_on(value, scene);
        for value in values.iter().filter(|v| !is_local(v)) {
            let rule = match value.owner {
                ValueOwner::Driver => DimensionRule::Whole,
                _ => DimensionRule::Size(dimensions.size(value.number)),
            };
            dimensions.push(value, rule);
        }
        for value in values.iter().filter(|v| is_local(v)) {
            let rule = dimensions.local(value, link_of(value));
            dimensions.push(value, rule);
        }
        dimensions
    }

    fn push(&mut self, value: &Value, rule: DimensionRule) {
        let value = value.clone();
        self.list.push(VariedNumber { value, rule });
    }

    fn find(&self, number: f64) -> Option<usize> {
        let size = number.abs();
        self.sizes.iter().position(|&own| own == size)
    }

    fn size(&mut self, number: f64) -> usize {
        self.find(number).unwrap_or_else(|| {
            self.sizes.push(number.abs());
            self.sizes.len() - 1
        })
    }

    /// Returns the rule of a coordinate or distance on a link, whose length is given if it has one.
    fn local(&mut self, value: &Value, length: Option<f64>) -> DimensionRule {
        let of_length = length.and_then(|length| Some((length, self.find(length)?)));
        let Some((length, size)) = of_length else {
            return DimensionRule::Size(self.size(value.number));
        };
        let halves = 2.0 * value.number / length;
        if halves == halves.round() {
            return DimensionRule::Halves(size, halves);
        }
        let is_centre = value.name.contains(" com ");
        match self.find(value.number).filter(|_| !is_centre) {
            Some(same) => DimensionRule::Size(same),
            None => DimensionRule::With(size),
        }
    }

    /// Returns `true` if there are no dimensions to change.
    pub(super) fn is_empty(&self) -> bool {
        self.sizes.is_empty()
    }

    /// Draws random dimensions; returns the new text of each value.
    pub(super) fn changed(
        &self,
        rng: &mut SeededRng,
        spread: DimensionSpread,
    ) -> Option<Vec<(Value, String)>> {
        let texts = match spread {
            DimensionSpread::Each(percent) => self.draw_dimensions(rng, percent)?,
            DimensionSpread::Together => self.together(rng)?,
        };
        let values = self.list.iter().map(|dimension| dimension.value.clone());
        let put = |(value, text): (Value, String)| {
            // A parameter with a unit keeps it.
            let text = value.written(&text);
            (value, text)
        };
        Some(values.zip(texts).map(put).collect())
    }

    fn together(&self, rng: &mut SeededRng) -> Option<Vec<String>> {
        let factor = *rng.one_of(&FACTORS)?;
        let list = self.list.iter();
        Some(list.map(|d| exactly(d.value.number * factor)).collect())
    }

    fn draw_dimensions(&self, rng: &mut SeededRng, percent: u32) -> Option<Vec<String>> {
        let [low, high] = SIZE_RANGE;
        let complete = f64::from(rng.between(low, high)) / 100.0;
        let mut sizes = Vec::with_capacity(self.sizes.len());
        for size in &self.sizes {
            let own = rng.between(100_u32.saturating_sub(percent), 100 + percent);
            let size: f64 = agreeable(size * complete * f64::from(own) / 100.0)?
                .parse()
                .ok()?;
            sizes.push(size);
        }
        let text = |d: &VariedNumber| {
            let number = d.value.number;
            match d.rule {
                DimensionRule::Size(size) => Some(exactly(sizes.get(size)?.copysign(number))),
                DimensionRule::Halves(size, halves) => {
                    Some(exactly(sizes.get(size)? * halves / 2.0))
                }
                DimensionRule::Whole => agreeable(number * complete),
                DimensionRule::With(size) => {
                    agreeable(number * sizes.get(size)? / self.sizes.get(size)?)
                }
            }
        };
        self.list.iter().map(text).collect()
    }
}

/// Parameters that lengths of parts depend on, but not angles, times or plain numbers.
struct LengthParameters {
    names: HashSet<String>,
}

impl LengthParameters {
    fn of(values: &[Value]) -> LengthParameters {
        let parameters: HashMap<&str, &Value> = values
            .iter()
            .filter(|value| value.measure == Measure::Parameter)
            .map(|value| (value.name.as_str(), value))
            .collect();
        // All names that a value depends on, directly or indirectly.
        let after = |of: &mut dyn Iterator<Item = &Value>| {
            let mut met: HashSet<String> = HashSet::new();
            let mut names: Vec<String> = of.flat_map(Value::follows_from).collect();
            while let Some(name) = names.pop() {
                let parameter = parameters.get(name.as_str());
                if met.insert(name) {
                    names.extend(parameter.into_iter().flat_map(|value| value.follows_from()));
                }
            }
            met
        };
        let is_else = |value: &&Value| {
            let measure = value.measure;
            matches!(measure, Measure::Angle | Measure::Time | Measure::Factor) || measure.is_rate()
        };
        let of_parts = after(&mut values.iter().filter(|value| is_of_a_part(value)));
        let of_others = after(&mut values.iter().filter(is_else));
        LengthParameters {
            names: of_parts.difference(&of_others).cloned().collect(),
        }
    }

    /// Returns `true` if a value is such a parameter and a nonzero number.
    fn has(&self, value: &Value) -> bool {
        let is_own = value.is_number() && value.number != 0.0;
        value.measure == Measure::Parameter && is_own && self.names.contains(&value.name)
    }
}

/// Returns `true` if a value is a length of a part.
fn is_of_a_part(value: &Value) -> bool {
    let is_length = matches!(value.measure, Measure::Length | Measure::Coordinate);
    let is_of_part = matches!(value.owner, ValueOwner::Element(_) | ValueOwner::Driver);
    is_length && is_of_part && !value.name.contains(" knot ")
}

/// Returns `true` for a dimension that is not 0; zeros place points on axes. Loads, start values
/// and motor data are not dimensions, and values with a formula keep it.
fn is_dimension(value: &Value) -> bool {
    value.formula.is_none() && value.number != 0.0 && is_of_a_part(value)
}

/// Returns `true` if a value gives a place on a link: a coordinate, or the distance from another
/// place. A link's own length does not.
fn is_on(value: &Value, scene: &Scene) -> bool {
    let mut links = scene.mechanism.link_ids();
    links.any(|link| {
        let after = value.name.strip_prefix(scene.link_name(link));
        after.is_some_and(|after| after.starts_with(' ') && after != " length")
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    fn changed(name: &str, spread: DimensionSpread) -> Vec<(String, String)> {
        let preset = presets::find(name).unwrap();
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let dimensions = Dimensions::of(&scene);
        let mut rng = SeededRng::new(5);
        let changed = dimensions.changed(&mut rng, spread).unwrap();
        changed.into_iter().map(|(v, t)| (v.name, t)).collect()
    }

    fn number(list: &[(String, String)], name: &str) -> f64 {
        let found = list.iter().find(|(own, _)| own == name);
        found
            .unwrap_or_else(|| panic!("{name}: {list:?}"))
            .1
            .parse()
            .unwrap()
    }

    #[test]
    fn every_nonzero_length_is_a_dimension() {
        let list = changed("four-bar", DimensionSpread::Each(30));
        let names: Vec<&str> = list.iter().map(|(name, _)| name.as_str()).collect();
        let all = [
            "D x",
            "r2 length",
            "r3 length",
            "r4 length",
            "r3 com x",
            "r4 com x",
        ];
        assert_eq!(names, all);
        assert_eq!(number(&list, "r3 com x"), number(&list, "r3 length") / 2.0);
    }

    #[test]
    fn equal_lengths_stay_equal() {
        let list = changed("triple-parallelogram", DimensionSpread::Each(30));
        assert_eq!(number(&list, "r2 length"), number(&list, "r5 length"));
        assert_eq!(number(&list, "D x"), number(&list, "r3 length"));
        assert_eq!(number(&list, "H x"), number(&list, "r3 K x"));
    }

    /// Lengths of points on a link change with the link, in polar form, too.
    #[test]
    fn polar_points_stay_at_half_the_link_length() {
        let text = "[ground]\nA = [0, 0]\nD = [400, 0]\n[driver]\nlink = \"r2\"\nangle = 60\n[links]\n\
            r2 = { from = \"A\", to = \"B\", length = 100 }\n\
            r3 = { from = \"B\", to = \"C\", length = 300, com = { length = 150, angle = 0 } }\n\
            r4 = { from = \"C\", to = \"D\", length = 250, points = { E = { from = \"D\", length = 125, angle = 72 } } }\n\
            [start]\nC = [310, 230]\n";
        let scene = Scene::parse(text, "test").unwrap();
        let dimensions = Dimensions::of(&scene);
        for seed in 0..20 {
            let mut rng = SeededRng::new(seed);
            let list = dimensions.changed(&mut rng, DimensionSpread::Each(25));
            let list: Vec<(String, String)> = list
                .unwrap()
                .into_iter()
                .map(|(v, t)| (v.name, t))
                .collect();
            let half = |name: &str| number(&list, name) / 2.0;
            assert_eq!(number(&list, "r3 com length"), half("r3 length"));
            assert_eq!(number(&list, "r4 E length"), half("r4 length"));
        }
    }

    /// Values that depend on a parameter used to be kept, so that a scene of parameters had nothing
    /// to draw.
    #[test]
    fn length_parameters_are_drawn_and_formulas_kept() {
        let text = "unit = \"mm\"\n[parameters]\nframe = 400\ncrank = \"10 cm\"\nrod = \"3 * crank\"\nlean = 60\n\
            twice = 2\nunused = 7\n[ground]\nA = [0, 0]\nD = [\"frame\", 0]\n[driver]\nlink = \"r2\"\nangle = \"lean\"\n\
            speed = \"twice rad/s\"\n[links]\nr2 = { from = \"A\", to = \"B\", length = \"crank\" }\n\
            r3 = { from = \"B\", to = \"C\", length = \"rod\", com = [\"rod / 2\", 0] }\n\
            r4 = { from = \"C\", to = \"D\", length = 250 }\n[start]\nC = [310, 230]\n";
        let scene = Scene::parse(text, "test").unwrap();
        let dimensions = Dimensions::of(&scene);
        for seed in 0..10 {
            let changed = dimensions
                .changed(&mut SeededRng::new(seed), DimensionSpread::Each(25))
                .unwrap();
            let names: Vec<&str> = changed
                .iter()
                .map(|(value, _)| value.name.as_str())
                .collect();
            assert_eq!(names, ["frame", "crank", "r4 length"]);
            let drawn = scene.reparse(&scene.with_values(&changed)).unwrap();
            let score = |name: &str| drawn.value_named(name).unwrap().number;
            assert!(score("crank") != 100.0 || score("frame") != 400.0);
            assert_eq!(score("r3 length"), 3.0 * score("crank"));
            assert!(
                drawn.text().contains("crank = \"")
                    && drawn.text().contains(" mm\"\nrod = \"3 * crank\"")
            );
        }
    }

    #[test]
    fn load_knots_are_no_dimensions() {
        let list = changed("press-ram", DimensionSpread::Together);
        assert!(
            list.iter().all(|(name, _)| !name.contains("knot")),
            "{list:?}"
        );
        assert!(
            list.iter().any(|(name, _)| name == "r6 through x"),
            "{list:?}"
        );
        assert!(list.iter().any(|(name, _)| name == "r4 E y"), "{list:?}");
    }
}
