//! Ranks links and points by name, for choices that the structure leaves open, so that they do not
//! depend on the order of a file.

use super::{LinkId, Mechanism, PointId};
use std::sync::Arc;

/// The rank of every link and point. Empty lists mean the order in which the elements were given.
#[derive(Clone, Debug, Default)]
pub(super) struct NameRanks {
    links: Vec<usize>,
    points: Vec<usize>,
}

impl Mechanism {
    /// Ranks links by their names, and points by the lowest-ranked of their links and then by their
    /// names.
    #[must_use]
    pub fn ranked(self, links: &[impl Ord], points: &[impl Ord]) -> Mechanism {
        let links = ranks(links.len(), |link| &links[link]);
        let all = self.points().iter();
        let firsts = all.map(|point| point.links.iter().map(|link| links[link.index()]).min());
        let firsts: Vec<Option<usize>> = firsts.collect();
        let points = ranks(points.len(), |point| (firsts[point], &points[point]));
        let mut parts = self.parts;
        Arc::make_mut(&mut parts).ranks = NameRanks { links, points };
        Mechanism { parts }
    }

    /// Returns the rank of a link, which does not depend on the order of the file.
    pub fn link_rank(&self, link: LinkId) -> usize {
        let ranks = &self.parts.ranks.links;
        ranks.get(link.index()).copied().unwrap_or(link.index())
    }

    /// Returns the rank of a point, which does not depend on the order of the file.
    pub(crate) fn point_rank(&self, point: PointId) -> usize {
        let ranks = &self.parts.ranks.points;
        ranks.get(point.index()).copied().unwrap_or(point.index())
    }
}

/// Returns the rank of each of `count` items in the order of their keys.
fn ranks<K: Ord>(count: usize, key: impl Fn(usize) -> K) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by_key(|&i| key(i));
    let mut ranks = vec![0; count];
    for (rank, &i) in order.iter().enumerate() {
        ranks[i] = rank;
    }
    ranks
}
