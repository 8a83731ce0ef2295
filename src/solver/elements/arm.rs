//! Arms: what a link reaches from a known joint to one that is sought.

use crate::{Constant, LinkId, Number, PointId, Vec2};

/// The end of an arm in the frame of its link, as a complex factor: direction = arm * factor.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Arm {
    /// The known end.
    pub pivot: PointId,
    /// Its length, and the square of it.
    pub length: Constant,
    pub square: Constant,
    /// The link whose direction it tells.
    pub link: LinkId,
    /// The conjugate of the arm in the link's frame over the square of its length.
    pub factor: Vec2<Constant>,
}

impl Arm {
    pub(in crate::solver) fn new(pivot: PointId, link: LinkId, local: Vec2<Constant>) -> Arm {
        Arm {
            pivot,
            length: local.norm(),
            square: local.norm2(),
            link,
            factor: local.conj() / local.norm2(),
        }
    }

    /// The direction of the link whose arm stands so.
    #[inline(always)]
    pub(in crate::solver) fn direction<T: Number>(&self, arm: Vec2<T>) -> Vec2<T> {
        // Most arms lie along the x axis of their link.
        if !T::IS_CHEAP && self.factor.y == Constant::default() {
            arm * T::of(self.factor.x)
        } else {
            arm.turned(Vec2::of(self.factor))
        }
    }
}
