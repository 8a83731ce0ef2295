//! Assigns storage slots to the forces at joints.

use crate::{LinkId, Mechanism, PointId};

/// The slots of the forces on links at their points: one for every member of every link, and one
/// more for forces that are not read.
#[derive(Clone, Debug)]
pub(in crate::solver) struct Slots {
    starts: Vec<usize>,
    pub(super) members: Vec<PointId>,
}

/// An index in the list of forces at joints.
pub(in crate::solver) type Slot = usize;

impl Slots {
    pub(super) fn new(mechanism: &Mechanism) -> Slots {
        let mut slots = Slots {
            starts: Vec::new(),
            members: Vec::new(),
        };
        for link in mechanism.links() {
            slots.starts.push(slots.members.len());
            slots.members.extend(link.members.iter().map(|m| m.point));
        }
        slots.starts.push(slots.members.len());
        slots
    }

    /// Returns the slot that is never read.
    pub(super) fn nowhere(&self) -> Slot {
        self.members.len()
    }

    pub(super) fn find(&self, link: LinkId, point: PointId) -> Option<Slot> {
        let range = *self.starts.get(link.index())?..*self.starts.get(link.index() + 1)?;
        let members = &self.members[range.clone()];
        let index = members.iter().position(|&p| p == point)?;
        Some(range.start + index)
    }

    pub(in crate::solver) fn of(&self, link: LinkId, point: PointId) -> Slot {
        self.find(link, point).unwrap_or(self.nowhere())
    }
}
