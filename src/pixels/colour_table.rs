//! The colours of a GIF, at most 256.

use std::cmp::Reverse;
use std::collections::HashMap;

/// Maximum number of colours; one index is reserved for unchanged pixels.
const MAX_COUNT: usize = 255;

/// The most frequent colours of some pictures; any other colour is replaced by the nearest one. A
/// line drawing has about a dozen hues, and mixtures with the background along the edges.
pub(super) struct ColourTable {
    colours: Vec<[u8; 3]>,
    nearest: HashMap<[u8; 3], u8>,
}

/// A count of the pixels of each colour.
#[derive(Default)]
pub(super) struct ColourCensus {
    counts: HashMap<[u8; 3], usize>,
}

impl ColourCensus {
    pub(super) fn count(&mut self, colours: impl Iterator<Item = [u8; 3]>) {
        for colour in colours {
            *self.counts.entry(colour).or_default() += 1;
        }
    }

    pub(super) fn table(self) -> ColourTable {
        let mut counts: Vec<_> = self.counts.into_iter().collect();
        // Equal counts are ordered by colour, so that equal pictures give equal bytes.
        counts.sort_by_key(|&(colour, count)| (Reverse(count), colour));
        counts.truncate(MAX_COUNT);
        ColourTable {
            colours: counts.into_iter().map(|(colour, _)| colour).collect(),
            nearest: HashMap::new(),
        }
    }
}

impl ColourTable {
    /// Returns the table in the GIF format, always of full size, because the reserved index must
    /// lie within it.
    pub(super) fn bytes(&self) -> Vec<u8> {
        let mut bytes = self.colours.concat();
        bytes.resize(3 * (MAX_COUNT + 1), 0);
        bytes
    }

    pub(super) fn index(&mut self, colour: [u8; 3]) -> u8 {
        let colours = &self.colours;
        *self.nearest.entry(colour).or_insert_with(|| {
            let away = |known: &[u8; 3]| -> u32 {
                let each = known.iter().zip(colour);
                each.map(|(a, b)| u32::from(a.abs_diff(b)).pow(2)).sum()
            };
            let nearest = (0u8..).zip(colours).min_by_key(|(_, known)| away(known));
            nearest.map_or(0, |(index, _)| index)
        })
    }
}
