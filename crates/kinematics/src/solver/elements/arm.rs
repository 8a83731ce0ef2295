//! Describes arms: the vector of a link from a known joint to an unknown one.

use crate::{Constant, LinkId, Number, PointId, Vec2};

/// An arm of a link, with the complex factor that gives the link's direction: direction = arm *
/// factor.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Arm {
    /// The known end.
    pub pivot: PointId,
    /// The arm's length.
    pub length: Constant,
    /// The vector from the pivot to the other end, in the frame of the link.
    pub local: Vec2<Constant>,
    /// The link whose direction follows from the arm.
    pub link: LinkId,
    /// The conjugate of the arm in the link's frame, divided by the square of its length.
    pub factor: Vec2<Constant>,
    /// Whether the arm lies along the x axis of its link, as most arms do.
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

    /// Returns the arm with its end changed by `place`.
    pub(in crate::solver) fn varied(&self, place: &mut impl FnMut(&mut Vec2<Constant>)) -> Arm {
        let mut local = self.local;
        place(&mut local);
        Arm::new(self.pivot, self.link, local)
    }

    /// Returns the direction of the link, given the vector of the arm.
    #[inline(always)]
    pub(in crate::solver) fn direction<T: Number>(&self, arm: Vec2<T>) -> Vec2<T> {
        if T::DERIVES_CONSTANTS {
            let local: Vec2<T> = Vec2::of(self.local);
            arm.turned(local.conj() / local.norm2())
        } else if !T::IS_CHEAP && self.is_straight {
            arm * T::of(self.factor.x)
        } else {
            arm.turned(Vec2::of(self.factor))
        }
    }

    /// Returns the arm's length.
    #[inline(always)]
    pub(in crate::solver) fn length<T: Number>(&self) -> T {
        if T::DERIVES_CONSTANTS {
            Vec2::<T>::of(self.local).norm()
        } else {
            T::of(self.length)
        }
    }
}
