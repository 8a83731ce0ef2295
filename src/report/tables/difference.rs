//! Computes tables of differences between the values of two scenes.

use crate::Vec2;
use crate::angle::TURN;
use crate::report::tables::entry::{
    Entry, PlaneVector, ROUND_UP_FACTOR, display_bound, display_value,
};
use crate::report::tables::{PointRow, Tables, VectorColumn};
use std::collections::{HashMap, HashSet};

/// The correspondence between rows of two scenes' tables: rows of the same name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pairing {
    vectors: Vec<Option<usize>>,
    points: Vec<Option<usize>>,
    only_there: Vec<String>,
}

impl Pairing {
    /// Pairs the rows of `this` with those of `other`.
    #[must_use]
    pub fn of(this: &Tables, other: &Tables) -> Pairing {
        let (own, others) = (vector_names(this), vector_names(other));
        let (own_points, other_points) = (point_names(this), point_names(other));
        let known: HashSet<&str> = own.iter().chain(&own_points).copied().collect();
        let there = others.iter().chain(&other_points);
        Pairing {
            vectors: partners(&own, &others),
            points: partners(&own_points, &other_points),
            only_there: there
                .filter(|name| !known.contains(*name))
                .map(|name| (*name).to_owned())
                .collect(),
        }
    }

    /// Returns `true` if the other scene has a vector with the name of this row.
    #[must_use]
    pub fn has_vector(&self, row: usize) -> bool {
        self.vectors.get(row).is_some_and(Option::is_some)
    }

    /// Returns `true` if the other scene has a point with the name of this row.
    #[must_use]
    pub fn has_point(&self, row: usize) -> bool {
        self.points.get(row).is_some_and(Option::is_some)
    }

    /// Returns the names of rows that only the other scene has.
    #[must_use]
    pub fn only_there(&self) -> &[String] {
        &self.only_there
    }

    /// Subtracts the values of `other` from those of the same name in `this`, in the unit of
    /// `this`; `scale` is the size of the other's unit in it. Differences of directions are at most
    /// half a turn. A value missing in either has no difference, and a difference within the bounds
    /// of both is 0.
    #[must_use]
    pub fn difference(&self, this: &Tables, other: &Tables, scale: f64) -> Tables {
        let vectors = this.vectors.iter().zip(&self.vectors);
        let points = this.points.iter().zip(&self.points);
        Tables {
            scene: this.scene.clone(),
            unit: this.unit,
            driver: this.driver.clone(),
            condition: this.condition,
            vectors: vectors
                .map(|(own, partner)| {
                    vector(own, partner.and_then(|row| other.vectors.get(row)), scale)
                })
                .collect(),
            points: points
                .map(|(own, partner)| {
                    point(own, partner.and_then(|row| other.points.get(row)), scale)
                })
                .collect(),
            answers: None,
            forces: None,
        }
    }
}

fn vector_names(tables: &Tables) -> Vec<&str> {
    tables.vectors.iter().map(|v| v.name.as_str()).collect()
}

fn point_names(tables: &Tables) -> Vec<&str> {
    tables.points.iter().map(|p| p.name.as_str()).collect()
}

fn partners(own: &[&str], others: &[&str]) -> Vec<Option<usize>> {
    let rows = others.iter().enumerate().map(|(row, name)| (*name, row));
    let rows: HashMap<&str, usize> = rows.collect();
    own.iter().map(|name| rows.get(name).copied()).collect()
}

fn vector(own: &VectorColumn, other: Option<&VectorColumn>, scale: f64) -> VectorColumn {
    let lengths = |other: &VectorColumn| {
        let pair = own.length.zip(other.length)?;
        Some(each(pair, |a, b| less(a, b, scale)))
    };
    let directions = |other: &VectorColumn| {
        let mut entries = each((own.direction, other.direction), |a, b| less(a, b, 1.0));
        entries[0] = turned(own.direction[0], other.direction[0]);
        entries
    };
    VectorColumn {
        name: own.name.clone(),
        length: own
            .length
            .map(|_| other.and_then(lengths).unwrap_or([Entry::NONE; 3])),
        direction: other.map_or([Entry::NONE; 3], directions),
    }
}

fn point(own: &PointRow, other: Option<&PointRow>, scale: f64) -> PointRow {
    let motion = |order: usize| {
        let (a, b) = own.motion[order].zip(other?.motion[order])?;
        Some(plane(a, b, scale))
    };
    PointRow {
        name: own.name.clone(),
        fixed: own.fixed && other.is_none_or(|other| other.fixed),
        motion: std::array::from_fn(motion),
    }
}

/// Subtracts values rather than vectors: the result is a difference of speeds, not the norm of a
/// difference of velocities.
fn plane(own: PlaneVector, other: PlaneVector, scale: f64) -> PlaneVector {
    let [a, b] = [own, other].map(|plane| plane.entries(false));
    let [x, y, magnitude] = std::array::from_fn(|i| less(a[i], b[i], scale));
    let direction = turned(a[3], b[3]);
    PlaneVector {
        components: Vec2::new(x.value.unwrap_or(0.0), y.value.unwrap_or(0.0)),
        magnitude: magnitude.value.unwrap_or(0.0),
        direction: direction.value,
        bounds: [x.bound, y.bound, magnitude.bound, direction.bound],
    }
}

fn each(pair: ([Entry; 3], [Entry; 3]), less: impl Fn(Entry, Entry) -> Entry) -> [Entry; 3] {
    std::array::from_fn(|i| less(pair.0[i], pair.1[i]))
}

/// Returns a - scale b. The conversion and the difference round three times.
fn less(a: Entry, b: Entry, scale: f64) -> Entry {
    let Some((of_a, of_b)) = a.value.zip(b.value) else {
        return Entry::NONE;
    };
    let of_b = of_b * scale;
    let rounding = 2.0 * f64::EPSILON * (of_a.abs() + of_b.abs());
    let bound = a.bound.zip(b.bound);
    let bound = bound.map(|(a, b)| (a + b * scale + rounding) * ROUND_UP_FACTOR);
    entry(of_a - of_b, bound, a.given && b.given)
}

/// Returns a - b in degrees, in (-180, 180].
fn turned(a: Entry, b: Entry) -> Entry {
    let Some((of_a, of_b)) = a.value.zip(b.value) else {
        return Entry::NONE;
    };
    let half = TURN / 2.0;
    let distance = (of_a - of_b).rem_euclid(TURN);
    let distance = if distance > half {
        distance - TURN
    } else {
        distance
    };
    let bound = a.bound.zip(b.bound);
    let bound = bound.map(|(a, b)| (a + b + 2.0 * f64::EPSILON * TURN) * ROUND_UP_FACTOR);
    entry(distance, bound, a.given && b.given)
}

fn entry(value: f64, bound: Option<f64>, given: bool) -> Entry {
    Entry {
        value: Some(display_value(value, bound)),
        given,
        bound: display_bound(value, bound),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Scene, presets};
    use crate::solver::{Order, Solver};

    /// Returns the tables of a scene at a coordinate, with bounds.
    fn tables(text: &str, at: f64) -> Tables {
        let scene = Scene::parse(text, "test").unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let mut state = solver.state();
        let _ = solver.solve(at, Order::Acceleration, &mut state);
        let mut enclosure = solver.enclosure();
        solver.enclose(&mut state, Order::Acceleration, &mut enclosure);
        Tables::bounded(&scene, &state, &enclosure)
    }

    fn four_bar() -> &'static str {
        presets::find("four-bar").unwrap().text
    }

    fn difference(this: &Tables, other: &Tables, scale: f64) -> Tables {
        Pairing::of(this, other).difference(this, other, scale)
    }

    fn all(tables: &Tables) -> Vec<Entry> {
        let vectors = tables.vectors.iter().flat_map(|v| {
            let lengths = v.length.into_iter().flatten();
            lengths.chain(v.direction)
        });
        let points = tables.points.iter().flat_map(|p| {
            let planes = p.motion.iter().flatten();
            planes.flat_map(|plane| plane.entries(p.fixed))
        });
        vectors.chain(points).collect()
    }

    #[test]
    fn scene_has_no_difference_from_itself() {
        for preset in presets::all() {
            let tables = tables(preset.text, 77.0);
            let differences = all(&difference(&tables, &tables, 1.0));
            assert!(!differences.is_empty());
            for entry in differences {
                assert!(
                    entry.value.is_none_or(|v| v == 0.0),
                    "{}: {entry:?}",
                    preset.name
                );
            }
        }
    }

    #[test]
    fn longer_crank_differs_by_added_length() {
        let longer = four_bar().replace("length = 100", "length = 101");
        let (this, other) = (tables(&longer, 60.0), tables(four_bar(), 60.0));
        let found = difference(&this, &other, 1.0);
        let crank = &found.vectors[0];
        assert_eq!(crank.name, "r2");
        assert_eq!(crank.length.unwrap()[0].value, Some(1.0));
        assert_eq!(crank.direction[0].value, Some(0.0));
        // B moves at 15 rad/s on a circle with a radius 1 mm larger, so 15 mm/s faster.
        let b = found.points.iter().find(|p| p.name == "B").unwrap();
        let [_, _, speed, bearing] = b.motion[1].unwrap().entries(false);
        assert!((speed.value.unwrap() - 15.0).abs() < 1e-12, "{speed:?}");
        assert_eq!(bearing.value, Some(0.0));
        // The coupler's difference follows from its values in both tables.
        let theta = |t: &Tables| t.vectors[1].direction[0].value.unwrap();
        let distance = found.vectors[1].direction[0];
        assert!((distance.value.unwrap() - (theta(&this) - theta(&other))).abs() < 1e-12);
        assert!(
            distance.value.unwrap() != 0.0 && distance.bound.unwrap() < 1e-11,
            "{distance:?}"
        );
    }

    /// For any true values within both bounds, their difference is within its own bound.
    #[test]
    fn bound_of_difference_shown_as_zero_holds() {
        let entry = |value: f64, bound: f64| Entry {
            value: Some(value),
            given: false,
            bound: Some(bound),
        };
        for ends in [[1.0, -1.0], [-1.0, 1.0]] {
            let [a, b] = [entry(1e-10, 3e-10), entry(-2e-10, 4e-10)];
            let [true_a, true_b] = [(a, ends[0]), (b, ends[1])]
                .map(|(e, end)| e.value.unwrap() + end * e.bound.unwrap());
            for found in [less(a, b, 1.0), turned(a, b)] {
                assert_eq!(found.value, Some(0.0));
                assert!((true_a - true_b).abs() <= found.bound.unwrap(), "{found:?}");
            }
        }
    }

    #[test]
    fn units_are_converted() {
        let metres = four_bar()
            .replace("\"mm\"", "\"m\"")
            .replace("[400, 0]", "[0.4, 0]")
            .replace("length = 100", "length = 0.1")
            .replace("length = 300", "length = 0.3")
            .replace("length = 250", "length = 0.25")
            .replace("com = [150, 0]", "com = [0.15, 0]")
            .replace("com = [125, 0]", "com = [0.125, 0]")
            .replace("[310, 230]", "[0.31, 0.23]");
        let (millimetres, metres) = (tables(four_bar(), 60.0), tables(&metres, 60.0));
        for (this, other, scale) in [(&millimetres, &metres, 1e3), (&metres, &millimetres, 1e-3)] {
            for entry in all(&difference(this, other, scale)) {
                // A remainder within the bounds is shown, not hidden.
                let value = entry.value.unwrap_or(0.0);
                assert!(value.abs() <= entry.bound.unwrap_or(0.0), "{entry:?}");
            }
        }
    }

    #[test]
    fn rows_without_partner_have_no_difference_and_are_named() {
        let (this, other) = (
            tables(four_bar(), 60.0),
            tables(presets::find("press").unwrap().text, 60.0),
        );
        let pairing = Pairing::of(&this, &other);
        let found = pairing.difference(&this, &other, 1.0);
        assert_eq!(found.points.len(), this.points.len());
        for (row, point) in found.points.iter().enumerate() {
            assert_eq!(
                pairing.has_point(row),
                point.motion[0].is_some(),
                "{}",
                point.name
            );
        }
        assert!(pairing.only_there().iter().any(|name| name == "G"));
        assert!(!pairing.only_there().iter().any(|name| name == "B"));
    }

    #[test]
    fn direction_differences_take_shorter_turn() {
        let angle = |value| Entry {
            value: Some(value),
            given: false,
            bound: Some(1e-12),
        };
        let distance = |a, b| turned(angle(a), angle(b)).value.unwrap();
        assert_eq!(distance(359.0, 1.0), -2.0);
        assert_eq!(distance(1.0, 359.0), 2.0);
        assert_eq!(distance(180.0, 0.0), 180.0);
        assert_eq!(distance(0.0, 180.0), 180.0);
        assert_eq!(turned(angle(1.0), Entry::NONE), Entry::NONE);
    }
}
