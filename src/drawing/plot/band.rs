//! Error bands next to curves, and their text in a legend at the cursor.

use super::ticks::TickStyle;

/// The error band of a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct PlotBand {
    /// Places along x with the offsets below and above the curve, in order. Empty if x is not
    /// monotonic, because a place may then occur twice.
    places: Vec<(f64, [f64; 2])>,
    /// The largest offsets below and above.
    ends: [f64; 2],
}

impl PlotBand {
    /// Creates a band from places along x and the offsets there; a pair needs both.
    pub(super) fn new(along: &[Option<f64>], offsets: &[Option<[f64; 2]>]) -> PlotBand {
        let pairs = along.iter().zip(offsets);
        let places = pairs.filter_map(|(x, off)| Some(((*x)?, (*off)?)));
        let mut places: Vec<(f64, [f64; 2])> = places.collect();
        let ends = places.iter().fold([0.0_f64; 2], |ends, (_, off)| {
            [ends[0].min(off[0]), ends[1].max(off[1])]
        });
        let ahead = |pair: &[(f64, [f64; 2])]| pair[0].0 <= pair[1].0;
        let continues =
            places.windows(2).all(ahead) || places.windows(2).all(|pair| pair[1].0 <= pair[0].0);
        if !continues {
            places.clear();
        }
        PlotBand { places, ends }
    }

    /// Returns the offsets at a place, interpolated linearly between its neighbours; `None` outside
    /// the band.
    fn at(&self, x: f64) -> Option<[f64; 2]> {
        let mut pairs = self.places.windows(2);
        pairs.find_map(|pair| {
            let [(from, a), (to, b)] = [pair[0], pair[1]];
            let part = if to == from {
                0.0
            } else {
                (x - from) / (to - from)
            };
            let between = |side: usize| a[side] + (b[side] - a[side]) * part;
            (0.0..=1.0)
                .contains(&part)
                .then(|| [between(0), between(1)])
        })
    }

    /// Formats the offsets at a place for a legend, with a constant width: `-0.12 +0.13`, or
    /// `+-0.12` for symmetric bands. Returns `None` outside the band.
    pub(super) fn text(&self, x: f64) -> Option<String> {
        let off = self.at(x)?;
        let [low, high] = self.ends;
        let is_even = self.places.iter().all(|(_, off)| off[0] == -off[1]);
        let style = TickStyle::of_range(0.0, high.max(-low));
        let width = style.text(high.max(-low)).len();
        let size = |off: f64| format!("{:>width$}", style.text(off.abs()));
        Some(match is_even {
            true => format!("+-{}", size(off[1])),
            false => format!("-{} +{}", size(off[0]), size(off[1])),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn band_text_gives_offsets_at_cursor() {
        let along = [Some(0.0), Some(10.0), None, Some(20.0)];
        let even = [
            Some([-0.1, 0.1]),
            Some([-0.3, 0.3]),
            None,
            Some([-0.2, 0.2]),
        ];
        let band = PlotBand::new(&along, &even);
        assert_eq!(
            band.at(5.0).map(|[_, above]| (above * 1e9).round()),
            Some(2e8)
        );
        assert!(band.text(5.0).is_some_and(|text| text.starts_with("+-0.2")));
        assert_eq!(band.at(21.0), None);
        let uneven = [Some([-0.1, 0.2]), Some([0.0, 0.4]), None, Some([-0.1, 0.1])];
        let text = PlotBand::new(&along, &uneven).text(10.0).unwrap();
        assert!(text.starts_with("-0") && text.contains(" +0.4"), "{text}");
        // The largest offsets below and above are equal, but at different positions.
        let mirrored = [Some([-0.1, 0.2]), Some([-0.2, 0.1]), None, None];
        let text = PlotBand::new(&along, &mirrored).text(0.0).unwrap();
        assert!(text.starts_with("-0.1") && text.contains(" +0.2"), "{text}");
        // An abscissa that reverses has two offsets at one position.
        let back = [Some(0.0), Some(10.0), None, Some(5.0)];
        assert_eq!(PlotBand::new(&back, &even).text(7.0), None);
    }
}
