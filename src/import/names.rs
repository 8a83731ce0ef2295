//! Gives every element of a drawing a name that is valid and unique in a scene.

use super::drawing::{Drawing, DrawnPart, Remarks};
use crate::scene::is_figure_name;
use crate::wording::words;
use std::collections::HashSet;

/// Maximum length of a name taken from a file, in bytes; a suffix can follow.
const MAX_LEN: usize = 56;

/// The names of a scene under construction.
#[derive(Debug, Default)]
pub(super) struct NamePool {
    taken: HashSet<String>,
}

impl NamePool {
    /// Returns a free valid name that is as near to `wanted` as possible, and reserves it.
    fn take(&mut self, wanted: &str, fallback: &str) -> String {
        let base = valid(wanted).unwrap_or_else(|| fallback.to_owned());
        if is_figure_name(&base) && self.taken.insert(base.clone()) {
            return base;
        }
        let mut numbered = (2_usize..).map(|number| format!("{base}-{number}"));
        // The numbers are endless, so a free one exists.
        let free = numbered.find(|name| self.taken.insert(name.clone()));
        free.unwrap_or(base)
    }

    /// Returns the first free name of an endless series.
    fn first(&mut self, series: &mut impl Iterator<Item = String>) -> String {
        let free = series.find(|name| is_figure_name(name) && self.taken.insert(name.clone()));
        free.unwrap_or_default()
    }
}

/// Replaces runs of characters that a name cannot have; returns `None` if nothing is left.
fn valid(text: &str) -> Option<String> {
    let is_valid = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '\'');
    let words = text.split(|c| !is_valid(c)).filter(|word| !word.is_empty());
    let mut name = words.collect::<Vec<_>>().join("_");
    // All characters are ASCII.
    name.truncate(MAX_LEN);
    name.chars()
        .any(|c| c.is_ascii_alphanumeric())
        .then_some(name)
}

/// Returns the letters of a number as in a spreadsheet: A to Z, then AA.
pub(super) fn letters(number: usize) -> String {
    let mut left = number + 1;
    let mut letters = Vec::new();
    while left > 0 {
        left -= 1;
        // The remainder is below 26.
        letters.push(char::from(b'A' + u8::try_from(left % 26).unwrap_or(0)));
        left /= 26;
    }
    letters.into_iter().rev().collect()
}

/// The names of the elements of a drawing.
#[derive(Debug, Default)]
pub(super) struct ElementNames {
    pub(super) points: Vec<String>,
    pub(super) links: Vec<String>,
    pub(super) slides: Vec<String>,
    /// The names of limited angles. Those in the frame have the names of their links.
    pub(super) angle_limits: Vec<String>,
}

/// Assigns names to all elements. Names of the file take precedence; a changed name is reported.
pub(super) fn assign(drawing: &Drawing, remarks: &mut Remarks) -> ElementNames {
    let mut pool = NamePool::default();
    let mut rename = |wanted: &Option<String>, fallback: &str| {
        let wanted = wanted.as_deref()?;
        let name = pool.take(wanted, fallback);
        if name != wanted {
            remarks.add("", &words().import_renamed(wanted, &name));
        }
        Some(name)
    };
    let points: Vec<_> = drawing
        .points
        .iter()
        .map(|p| rename(&p.name, "P"))
        .collect();
    let links: Vec<_> = drawing
        .links
        .iter()
        .map(|l| rename(&l.name, "link"))
        .collect();
    let slides: Vec<_> = drawing
        .slides
        .iter()
        .map(|s| rename(&s.name, "slide"))
        .collect();
    let rest = |named: Vec<Option<String>>,
                pool: &mut NamePool,
                series: fn(usize) -> String|
     -> Vec<String> {
        let mut series = (0..).map(series);
        let names = named.into_iter();
        names
            .map(|name| name.unwrap_or_else(|| pool.first(&mut series)))
            .collect()
    };
    let points = rest(points, &mut pool, letters);
    let links = rest(links, &mut pool, |number| format!("r{}", number + 2));
    let slides = rest(slides, &mut pool, |number| format!("s{}", number + 1));
    let limits = drawing.angle_limits.iter();
    let angle_limits = limits
        .map(|limit| match limit.from {
            DrawnPart::Frame => links[limit.link].clone(),
            DrawnPart::Link(_) => pool.take(&format!("{}-limit", links[limit.link]), "limit"),
        })
        .collect();
    ElementNames {
        points,
        links,
        slides,
        angle_limits,
    }
}
