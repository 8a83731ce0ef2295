//! Computes the couples transmitted by locks, which keep links from turning.
//!
//! Links locked to each other form a tree of locks. A lock carries the couple of everything beyond
//! it.

use super::ForceState;
use crate::solver::elements::Step;
use crate::solver::plan::Program;
use crate::solver::plan::network::{GROUND, Network};
use crate::{LinkId, Number, SlideId, Slider};

/// The locks of a mechanism.
#[derive(Clone, Debug)]
pub(super) struct Locked {
    /// The links locked to the ground, whose couples no step has propagated.
    grounded: Vec<LinkId>,
    locks: Vec<LockSite>,
}

/// A lock, and the links beyond it, counted from the link that gives the direction.
#[derive(Clone, Debug)]
struct LockSite {
    slide: SlideId,
    linked: Vec<LinkId>,
    /// Whether the sliding link is among them, rather than the guide.
    includes_slider: bool,
}

impl Locked {
    pub(super) fn new(network: &Network<'_>, program: &Program) -> Locked {
        let mechanism = network.mechanism;
        let edges: Vec<(SlideId, LinkId, LinkId)> = mechanism
            .slide_ids()
            .filter(|slide| !network.repeated_locks.contains(slide))
            .filter_map(|id| match mechanism.slide(id).slider {
                Slider::Pin(_) => None,
                Slider::Link { link, .. } => Some((id, link, network.body(mechanism.slide(id).on))),
            })
            .collect();
        let root = |link: LinkId| {
            let is_rep = |step: &Step| match step {
                Step::Lock(lock) if lock.link == link => Some(lock.to),
                _ => None,
            };
            let ground = network.class(link) == GROUND;
            let guided = || program.steps.iter().find_map(is_rep);
            if ground {
                network.ground()
            } else {
                guided().unwrap_or(link)
            }
        };
        let locks = edges.iter().map(|&(slide, slider, guide)| {
            let root = root(slider);
            let beyond = reached(slider, slide, &edges);
            let holds_slider = !beyond.contains(&root);
            LockSite {
                slide,
                linked: if holds_slider {
                    beyond
                } else {
                    reached(guide, slide, &edges)
                },
                includes_slider: holds_slider,
            }
        });
        Locked {
            locks: locks.collect(),
            grounded: network.members[GROUND.0]
                .iter()
                .copied()
                .filter(|&l| l != network.ground())
                .collect(),
        }
    }

    /// Computes the couples, after all steps have run backwards.
    pub(super) fn finish<T: Number>(&self, forces: &mut ForceState<T>) {
        for link in &self.grounded {
            forces.couples[link.index()] += forces.links[link.index()];
        }
        for lock in &self.locks {
            let couples = lock.linked.iter().map(|l| forces.couples[l.index()]);
            let sum = couples.fold(T::default(), |sum, couple| sum + couple);
            forces.moments[lock.slide.index()] = if lock.includes_slider { -sum } else { sum };
        }
    }
}

/// Returns the links connected to `from` by locks other than `without`.
fn reached(from: LinkId, without: SlideId, edges: &[(SlideId, LinkId, LinkId)]) -> Vec<LinkId> {
    let mut found = vec![from];
    let mut next = 0;
    while let Some(&link) = found.get(next) {
        next += 1;
        for &(_, a, b) in edges.iter().filter(|edge| edge.0 != without) {
            let other = if a == link { b } else { a };
            if (a == link || b == link) && !found.contains(&other) {
                found.push(other);
            }
        }
    }
    found
}
