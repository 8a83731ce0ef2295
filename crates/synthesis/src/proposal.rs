//! Proposed linkages and dyads.

use kinematics::Vec2;

/// The element that holds the second moving pin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PinConstraint {
    /// A link on a ground pivot at this position.
    Rocker(Vec2),
    /// A slide on the ground through the pin, at this angle in degrees.
    Slide(f64),
}

impl PinConstraint {
    /// Returns the ground pivot; `None` for a slide.
    #[must_use]
    pub fn pivot(self) -> Option<Vec2> {
        match self {
            PinConstraint::Rocker(pivot) => Some(pivot),
            PinConstraint::Slide(_) => None,
        }
    }
}

/// A four-bar or a slider-crank with crank A-B, coupler B-C, and a rocker C-D or a slide at C. It
/// is defined by the positions of its moving pins at every point of the task. All lengths follow
/// from the first.
#[derive(Clone, Debug, PartialEq)]
pub struct Proposal {
    /// The position of A, the crank's pivot.
    pub pivot: Vec2,
    /// The element that holds C.
    pub partner: PinConstraint,
    /// B and C at every point of the task, in the task's order.
    pub places: Vec<[Vec2; 2]>,
    /// The guided point of the coupler at the first point of the task: the origin of a pose, or the
    /// tracer of a path. `None` for a function.
    pub tracer: Option<Vec2>,
}

/// A dyad: a link between a ground pivot and a pin of the guided body, or a slide of such a pin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PosedDyad {
    /// The element that holds the pin.
    pub held: PinConstraint,
    /// The pin's position at the first point of the task.
    pub pin: Vec2,
}

/// The proposals of a method.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Proposals {
    /// The linkages, in any order.
    pub found: Vec<Proposal>,
    /// `true` if there are no other linkages; a search from many starts does not prove this.
    pub is_complete: bool,
    /// The reason why there are no linkages, or why there may be others; `None` if the search makes
    /// no statement about this.
    pub reason: Option<OpenReason>,
    /// For four poses, the pieces of the curves on which every pivot and its pin lie, in the order
    /// of the curve.
    pub curves: Vec<Vec<PosedDyad>>,
}

/// The reason why a method proposes no linkages, or cannot decide whether there are others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OpenReason {
    /// Coordinates are too large or too small to compute with.
    Range,
    /// All poses are rotations about this ground point: only a pivot there guides the body.
    Turn(Vec2),
    /// The body does not turn, and its positions are not on a circle.
    Shift,
    /// No link or slide holds a given pivot or pin in all poses.
    GivenNumber,
    /// No two links or slides through the poses form a linkage of a wanted kind.
    NoPair,
    /// The linkages through the poses are far away, or have disproportionate lengths.
    Far,
    /// The poses nearly repeat: their rounding leaves open whether there are others.
    Rounding,
}

impl Proposal {
    /// Returns the lengths of crank, coupler and rocker; a slider-crank has no rocker. Returns
    /// `None` without places.
    #[must_use]
    pub fn lengths(&self) -> Option<(f64, f64, Option<f64>)> {
        let [b, c] = *self.places.first()?;
        let rocker = self.partner.pivot().map(|d| (c - d).norm());
        Some(((b - self.pivot).norm(), (c - b).norm(), rocker))
    }

    /// Returns the lengths of crank, coupler, rocker and ground, as far as they exist.
    #[must_use]
    pub fn all_lengths(&self) -> [Option<f64>; 4] {
        let Some((crank, coupler, rocker)) = self.lengths() else {
            return [None; 4];
        };
        let ground = self.partner.pivot().map(|d| (d - self.pivot).norm());
        [Some(crank), Some(coupler), rocker, ground]
    }

    /// Returns the longest length; 0 if there is none.
    #[must_use]
    pub fn longest(&self) -> f64 {
        let all = self.all_lengths().into_iter().flatten();
        all.fold(0.0, f64::max)
    }

    /// Returns the shortest length; infinity if there is none.
    #[must_use]
    pub fn shortest(&self) -> f64 {
        let all = self.all_lengths().into_iter().flatten();
        all.fold(f64::INFINITY, f64::min)
    }

    /// Returns the ratio of the longest length to the shortest.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        self.longest() / self.shortest()
    }

    /// Returns this linkage driven at its other pivot; `None` for a slider-crank.
    #[must_use]
    pub fn swapped(&self) -> Option<Proposal> {
        Some(Proposal {
            pivot: self.partner.pivot()?,
            partner: PinConstraint::Rocker(self.pivot),
            places: self.places.iter().map(|[b, c]| [*c, *b]).collect(),
            tracer: self.tracer,
        })
    }
}
