//! What points, links and slides are called in a script.

use crate::scene::Scene;
use crate::{LinkId, PointId, SlideId};
use std::collections::HashSet;

/// Words that scripts have for themselves, in either language.
const RESERVED: [&str; 76] = [
    "and",
    "as",
    "assert",
    "async",
    "await",
    "break",
    "class",
    "continue",
    "def",
    "del",
    "elif",
    "else",
    "except",
    "finally",
    "for",
    "from",
    "global",
    "if",
    "import",
    "in",
    "is",
    "lambda",
    "nonlocal",
    "not",
    "or",
    "pass",
    "raise",
    "return",
    "try",
    "while",
    "with",
    "yield",
    "None",
    "True",
    "False",
    "end",
    "function",
    "case",
    "catch",
    "otherwise",
    "parfor",
    "persistent",
    "spmd",
    "switch",
    "classdef",
    "unwind_protect",
    "until",
    "do",
    "endfunction",
    "abs",
    "complex",
    "real",
    "imag",
    "sqrt",
    "max",
    "min",
    "pi",
    "i",
    "j",
    "e",
    "q",
    "z",
    "turn",
    "circles",
    "circle_line",
    "lines",
    "swing",
    "side",
    "newton",
    "follow",
    "both",
    "across",
    "seeds",
    "points",
    "math",
    "nan",
];

/// The identifiers of a scene.
pub(super) struct Identifiers {
    taken: HashSet<String>,
    points: Vec<String>,
    links: Vec<String>,
    slides: Vec<String>,
}

impl Identifiers {
    pub(super) fn of(scene: &Scene) -> Self {
        let mut all = Identifiers {
            taken: RESERVED.iter().map(|&word| word.to_owned()).collect(),
            points: Vec::new(),
            links: Vec::new(),
            slides: Vec::new(),
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
        all
    }

    /// A name that nothing else has: letters, digits and `_`, as near to the wish as that allows.
    pub(super) fn fresh(&mut self, wish: &str) -> String {
        let allowed = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
        let mut name: String = wish.chars().map(allowed).collect();
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
