//! Names points, links and slides in a script.

use super::dialect::ScriptLanguage;
use crate::scene::Scene;
use crate::{LinkId, PointId, SlideId};
use std::collections::{HashMap, HashSet};

/// The keywords of both languages, and constants of MATLAB and Octave.
const KEYWORDS: &str = include_str!("keywords.txt");

/// The variables of a scene's steps.
const VARIABLES: [&str; 4] = ["q", "z", "seeds", "points"];

/// Returns every name that the steps of a scene must not hide: keywords, and names that the frame
/// of either language defines, imports or calls.
fn reserved() -> HashSet<String> {
    let frames = ScriptLanguage::ALL.into_iter();
    let used = frames.flat_map(|language| names_used(language.frame()));
    let words = KEYWORDS.split_whitespace().chain(VARIABLES).chain(used);
    words.map(str::to_owned).collect()
}

/// Returns the names that a frame calls, imports, or assigns outside its functions.
fn names_used(frame: &str) -> impl Iterator<Item = &str> {
    frame.lines().flat_map(|line| {
        let is_import = line.starts_with("from ") || line.starts_with("import ");
        identifiers(line).filter_map(move |(name, rest)| {
            let is_global = line.starts_with(name) && rest.starts_with(" = ");
            (is_import || is_global || rest.starts_with('(')).then_some(name)
        })
    })
}

/// Returns the ASCII identifiers of a line, each with the text after it.
fn identifiers(line: &str) -> impl Iterator<Item = (&str, &str)> {
    let is_of_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut next = 0;
    let words = line.split(move |c| !is_of_name(c)).map(move |word| {
        let end = next + word.len();
        next = end + 1;
        (word, line.get(end..).unwrap_or(""))
    });
    words.filter(|(word, _)| !word.is_empty())
}

/// Maximum length of a name. MATLAB distinguishes names by their first 63 characters; some are
/// reserved for suffixes.
const MAX_LENGTH: usize = 56;

/// The parts of a slide.
pub(super) const THROUGH: &str = "through";
pub(super) const ALONG: &str = "along";
/// The lists of an input that follows a table.
pub(super) const TABLE: [&str; 3] = ["places", "values", "bends"];

/// The identifiers of a scene.
pub(super) struct Identifiers {
    taken: HashSet<String>,
    points: Vec<String>,
    links: Vec<String>,
    slides: Vec<String>,
    /// The names of parts, by owner and part.
    parts: HashMap<(String, String), String>,
}

impl Identifiers {
    pub(super) fn of(scene: &Scene) -> Self {
        let mut all = Identifiers {
            taken: reserved(),
            points: Vec::new(),
            links: Vec::new(),
            slides: Vec::new(),
            parts: HashMap::new(),
        };
        let mechanism = &scene.mechanism;
        for point in mechanism.point_ids() {
            let name = all.fresh(scene.point_name(point).unwrap_or("com"));
            all.points.push(name);
        }
        for link in mechanism.link_ids() {
            let name = all.fresh(scene.link_name(link));
            all.links.push(name);
        }
        for slide in mechanism.slide_ids() {
            let name = all.fresh(scene.slide_name(slide));
            all.slides.push(name);
        }
        // Parts come after the user's names, so that those are kept.
        for link in mechanism.link_ids() {
            for member in &mechanism.link(link).members {
                let (link, point) = (
                    all.link(link).to_owned(),
                    all.point(member.point).to_owned(),
                );
                all.name_part(link, &point);
            }
        }
        for slide in mechanism.slide_ids() {
            for part in [THROUGH, ALONG] {
                all.name_part(all.slide(slide).to_owned(), part);
            }
        }
        for owner in [all.links.clone(), all.slides.clone()].concat() {
            for part in TABLE {
                all.name_part(owner.clone(), part);
            }
        }
        all
    }

    /// Names a part of a link or slide after both, or similarly if the name is in use.
    fn name_part(&mut self, owner: String, part: &str) {
        let name = self.fresh(&format!("{owner}_{part}"));
        self.parts.insert((owner, part.to_owned()), name);
    }

    /// Returns the name of a part of a link or slide.
    pub(super) fn part(&self, owner: &str, part: &str) -> String {
        let name = self.parts.get(&(owner.to_owned(), part.to_owned()));
        name.cloned().unwrap_or_default()
    }

    /// Returns an unused name of letters, digits and `_`, as close as possible to the requested
    /// one.
    pub(super) fn fresh(&mut self, requested: &str) -> String {
        let allowed = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
        let mut name: String = requested.chars().map(allowed).take(MAX_LENGTH).collect();
        if !name.starts_with(|c: char| c.is_ascii_alphabetic()) {
            name.insert(0, 'n');
        }
        while !self.taken.insert(name.clone()) {
            name.push('_');
        }
        name
    }

    pub(super) fn point(&self, id: PointId) -> &str {
        &self.points[id.index()]
    }

    pub(super) fn link(&self, id: LinkId) -> &str {
        &self.links[id.index()]
    }

    pub(super) fn slide(&self, id: SlideId) -> &str {
        &self.slides[id.index()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reserved_names_include_template_names_but_not_locals() {
        let reserved = reserved();
        let used = "cos sin sqrt radians range print float int divmod repr isinstance complex sum zip list abs max sys \
            math main root place positions stand turn circles cosd sind conj reshape numel fprintf lambda seeds";
        for name in used.split(' ') {
            assert!(reserved.contains(name), "{name}");
        }
        for name in [
            "A", "B", "C", "P", "Q", "J", "x", "h", "row", "text", "about", "opening",
        ] {
            assert!(!reserved.contains(name), "{name}");
        }
    }
}
