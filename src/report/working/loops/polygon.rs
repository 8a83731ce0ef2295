//! Vector polygons: the sides and the independent closed loops of a scene.

use super::sides::{Locks, Side};
use crate::scene::Scene;

/// A side of a loop, and whether it is traversed backwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Term {
    pub side: usize,
    pub reversed: bool,
}

/// A closed loop.
#[derive(Clone, Debug)]
pub(crate) struct Loop {
    pub terms: Vec<Term>,
    /// The group of the plan that closes it; `None` if the loop only yields a further vector.
    pub group: Option<usize>,
}

/// All sides and loops of a scene.
#[derive(Clone, Debug)]
pub(crate) struct Polygon {
    pub sides: Vec<Side>,
    pub loops: Vec<Loop>,
    pub locks: Locks,
    /// The letter of the vector between the pivots of two arms.
    pub diagonal: &'static str,
}

/// Letters for the vector between the pivots of two arms. The formula writers of pages recognize
/// the symbols of its components.
const DIAGONALS: [&str; 3] = ["m", "s", "f"];

/// Returns the first letter for a diagonal that names no link and no side.
pub(super) fn diagonal(scene: &Scene, sides: &[Side]) -> &'static str {
    let is_free = |letter: &&str| {
        let mut names = scene
            .link_names
            .iter()
            .chain(sides.iter().map(|side| &side.name));
        names.all(|name| name != letter)
    };
    DIAGONALS.into_iter().find(is_free).unwrap_or(DIAGONALS[0])
}

impl Polygon {
    /// Returns the sides of a loop with their directions.
    pub(crate) fn terms<'a>(
        &'a self,
        of: &'a Loop,
    ) -> impl Iterator<Item = (&'a Side, bool)> + Clone {
        of.terms
            .iter()
            .map(|term| (&self.sides[term.side], term.reversed))
    }

    /// Returns the names of a term's start and end, as traversed by the loop.
    pub(crate) fn ends(&self, term: Term) -> (&str, &str) {
        let side = &self.sides[term.side];
        if term.reversed {
            (&side.head, &side.tail)
        } else {
            (&side.tail, &side.head)
        }
    }

    /// Returns the points of a loop in order, the first one repeated at the end.
    pub(crate) fn walk(&self, of: &Loop) -> String {
        let mut walk: Vec<&str> = of.terms.iter().map(|&term| self.ends(term).0).collect();
        walk.extend(of.terms.last().map(|&term| self.ends(term).1));
        walk.join(" → ")
    }

    /// Returns the sides that are not in any loop.
    pub(crate) fn riders(&self) -> impl Iterator<Item = &Side> {
        let mut is_in_loop = vec![false; self.sides.len()];
        for term in self.loops.iter().flat_map(|l| &l.terms) {
            is_in_loop[term.side] = true;
        }
        let sides = self.sides.iter().zip(is_in_loop);
        sides
            .filter(|(_, is_in_loop)| !is_in_loop)
            .map(|(side, _)| side)
    }
}
