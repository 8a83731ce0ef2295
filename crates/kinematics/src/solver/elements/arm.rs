//! Arms: what a link reaches from a known joint to one that is sought.

use crate::{Constant, LinkId, Number, PointId, Vec2};

/// The end of an arm in the frame of its link, as a complex factor: direction = arm * factor.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Arm {
    /// The known end.
    pub pivot: PointId,
    /// Its length.
    pub length: Constant,
    /// Where it ends in the frame of the link.
    pub local: Vec2<Constant>,
    /// The link whose direction it tells.
    pub link: LinkId,
    /// The conjugate of the arm in the link's frame over the square of its length.
    pub factor: Vec2<Constant>,
    /// Whether it lies along the x axis of its link, as most arms do.
    pub is_straight: bool,
}

impl Arm {
    pub(in crate::solver) fn new(pivot: PointId, link: LinkId, local: Vec2<Constant>) -> Arm {
        let factor = local.conj() / local.norm2();
        let none = Constant::default();
        Arm {
            pivot,
            length: local.norm(),
            local,
            link,
            factor,
            is_straight: local.y == none && factor.y == none,
        }
    }

    /// The same, its end changed.
    pub(in crate::solver) fn varied(&self, place: &mut impl FnMut(&mut Vec2<Constant>)) -> Arm {
        let mut local = self.local;
        place(&mut local);
        Arm::new(self.pivot, self.link, local)
    }

    /// The direction of the link whose arm stands so.
    #[inline(always)]
    pub(in crate::solver) fn direction<T: Number>(&self, arm: Vec2<T>) -> Vec2<T> {
        if !T::IS_CHEAP && self.is_straight {
            arm * T::of(self.factor.x)
        } else {
            arm.turned(Vec2::of(self.factor))
        }
    }
}
