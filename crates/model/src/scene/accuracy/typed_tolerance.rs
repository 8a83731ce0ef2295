//! Parses a common tolerance of all lengths, typed separately from the scene: `0.1`, `0.004 in`,
//! `ISO 2768-m`.

use crate::scene::accuracy::deviations::{AllowedDeviation, designated, is_beyond, unsized_by};
use crate::scene::{Measure, Scene, Unit, Value};
use crate::wording::words;
use crate::{Length, PointId, Tolerances};

impl Scene {
    /// Returns tolerances in which every length and coordinate has the typed tolerance instead of
    /// the scene's own; clearances stay as in the scene. `name` returns the name of a length in
    /// messages.
    ///
    /// # Errors
    /// Returns a message if the text is not a tolerance, or if a length cannot have it.
    pub fn typed_tolerances(
        &self,
        typed: &str,
        name: impl Fn(Length) -> String,
    ) -> Result<Tolerances, String> {
        let allowed = match designated(typed) {
            Some(class) => AllowedDeviation::Class(class?),
            None => AllowedDeviation::Size(self.typed_size(typed)?),
        };
        let mm = self.unit.in_units_of(Unit::Millimetre);
        let tolerance = |length: Length| {
            let nominal = self.mechanism.given(length).abs();
            let by = allowed
                .of(nominal, mm)
                .map_err(|class| unsized_by(class, &name(length), nominal * mm))?;
            match is_beyond(length, nominal, by) {
                true => Err(words().tolerance_beyond_length(&name(length), nominal, typed)),
                false => Ok((length, by)),
            }
        };
        let lengths = self.mechanism.lengths().into_iter().map(tolerance);
        Ok(self.in_order_of_names(Tolerances {
            lengths: lengths.collect::<Result<_, _>>()?,
            clearances: self.tolerances().clearances.clone(),
        }))
    }

    /// Sorts tolerances by names. Random samples draw their numbers in this order, so they do not
    /// depend on the order of the file.
    pub(crate) fn in_order_of_names(&self, mut tolerances: Tolerances) -> Tolerances {
        let lengths = &mut tolerances.lengths;
        lengths.sort_by(|(a, _), (b, _)| self.order_of(*a).cmp(&self.order_of(*b)));
        let clearances = &mut tolerances.clearances;
        let name = |&(link, point, _): &_| (self.point_name(point), self.link_name(link));
        clearances.sort_by(|a, b| name(a).cmp(&name(b)));
        tolerances
    }

    /// Returns the sort key of a length: its kind and axis, and the names of its elements.
    fn order_of(&self, length: Length) -> (usize, &str, &str) {
        let point = |point: PointId| self.point_name(point).unwrap_or_default();
        match length {
            Length::Ground(of, axis) => (axis as usize, point(of), ""),
            Length::Link(link) => (2, self.link_name(link), ""),
            Length::Local(link, of, axis) => (3 + axis as usize, self.link_name(link), point(of)),
            Length::Arm(link, of) => (5, self.link_name(link), point(of)),
            Length::Across(link, of) => (6, self.link_name(link), point(of)),
            Length::Through(slide, axis) => (7 + axis as usize, self.slide_name(slide), ""),
        }
    }

    /// Parses a positive size in the scene's unit.
    fn typed_size(&self, typed: &str) -> Result<f64, String> {
        let size = Value::outside_text(self, Measure::Deviation).typed_number(typed.trim());
        let size = size.map_err(|why| why.to_string())?;
        let size = size.parse().ok().filter(|size| *size > 0.0);
        size.ok_or_else(|| words().must_be_positive().to_owned())
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::{Scene, presets};

    /// The four-bar has lengths of 400, 100, 300 and 250 mm, and coordinates of 0.
    #[test]
    fn typed_tolerances_accepts_units_and_classes() {
        let scene = Scene::parse(presets::find("four-bar").unwrap().text, "t.toml").unwrap();
        let text = |typed: &str| {
            let found = scene.typed_tolerances(typed, |_| "L".into());
            found.map(|found| {
                let of = |(length, by)| (scene.mechanism.given(length).abs(), by);
                found.lengths.into_iter().map(of).collect::<Vec<_>>()
            })
        };
        for (typed, by) in [
            ("0.1", 0.1),
            ("0,1", 0.1),
            ("0.05 in", 1.27),
            ("0.1 cm", 1.0),
        ] {
            let all = text(typed).unwrap();
            assert!(
                all.iter().all(|(_, found)| *found == by),
                "{typed}: {all:?}"
            );
        }
        for (size, by) in text("ISO 2768-m").unwrap() {
            let known = match size {
                0.0 => 0.0,
                6.0..=30.0 => 0.2,
                30.0..=120.0 => 0.3,
                120.0..=400.0 => 0.5,
                _ => continue,
            };
            assert_eq!(by, known, "{size}");
        }
        let refused = |typed: &str, why: &str| {
            let text = text(typed).unwrap_err();
            assert!(text.contains(why), "{typed}: {text}");
        };
        refused("ISO 2768-x", "ISO 2768-m");
        refused("0", "greater than 0");
        refused("-1", "greater than 0");
        refused("1 kg", "kg");
        refused("wide", "wide");
        refused("1000", "must be less than the length");
    }
}
