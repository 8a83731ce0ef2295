//! A linkage that a method proposes.

use kinematics::Vec2;

/// What holds the second moving pin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Partner {
    /// A link on a pivot of the ground.
    Rocker(Vec2),
    /// A slide on the ground through the pin, at this angle in degrees.
    Slide(f64),
}

/// A four-bar or a slider-crank with crank A-B, coupler B-C, and a rocker C-D or a slide at C, by where its moving pins
/// are to be at every point of the task. All lengths follow from the first.
#[derive(Clone, Debug, PartialEq)]
pub struct Proposal {
    /// A: the crank's pivot.
    pub pivot: Vec2,
    /// What holds C.
    pub partner: Partner,
    /// B and C at every point of the task, in the task's order.
    pub places: Vec<[Vec2; 2]>,
    /// The point of the coupler that is led, at the first point: of a pose its origin. A function leads none.
    pub tracer: Option<Vec2>,
}

/// A link between a pivot of the ground and a pin of the body that is led, or a slide of such a pin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PosedDyad {
    /// What holds the pin.
    pub held: Partner,
    /// The pin, where it is at the first point of the task.
    pub pin: Vec2,
}

/// What a method proposes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Proposals {
    /// The linkages, in any order.
    pub found: Vec<Proposal>,
    /// Whether there are no others: a search with many starts proves nothing.
    pub is_complete: bool,
    /// Why there are none, or why there may be others; none where a search says no more than what it found.
    pub reason: Option<OpenReason>,
    /// Of four poses the pieces of the curves on which every pivot and its pin lie, in the order of the curve.
    pub curves: Vec<Vec<PosedDyad>>,
}

/// Why a method proposes nothing, or cannot tell whether there are others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OpenReason {
    /// Coordinates are too large or too small to be computed with.
    Range,
    /// All poses are turns about this point of the ground: a pivot there leads the body, and nothing else.
    Turn(Vec2),
    /// The body does not turn, and its places are on no circle.
    Shift,
    /// No link and no slide holds what is given in all poses.
    Given,
    /// No two of the links and slides that lead through the poses are a linkage of a kind that is looked for.
    NoPair,
    /// What leads through the poses lies far away, or has lengths out of all proportion.
    Far,
    /// The poses nearly repeat: their rounding leaves open whether there are others.
    Rounding,
}

impl Proposal {
    /// The lengths: crank, coupler, and rocker where there is one.
    #[must_use]
    pub fn lengths(&self) -> Option<(f64, f64, Option<f64>)> {
        let [b, c] = *self.places.first()?;
        let rocker = match self.partner {
            Partner::Rocker(d) => Some((c - d).norm()),
            Partner::Slide(_) => None,
        };
        Some(((b - self.pivot).norm(), (c - b).norm(), rocker))
    }

    /// All of them, as far as they exist: crank, coupler, rocker, and the distance of the pivots.
    #[must_use]
    pub fn all_lengths(&self) -> [Option<f64>; 4] {
        let Some((crank, coupler, rocker)) = self.lengths() else {
            return [None; 4];
        };
        let ground = match self.partner {
            Partner::Rocker(d) => Some((d - self.pivot).norm()),
            Partner::Slide(_) => None,
        };
        [Some(crank), Some(coupler), rocker, ground]
    }

    /// The longest of all lengths; 0 where there is none.
    #[must_use]
    pub fn longest(&self) -> f64 {
        let all = self.all_lengths().into_iter().flatten();
        all.fold(0.0, f64::max)
    }

    /// The shortest of all lengths; infinite where there is none.
    #[must_use]
    pub fn shortest(&self) -> f64 {
        let all = self.all_lengths().into_iter().flatten();
        all.fold(f64::INFINITY, f64::min)
    }

    /// The longest of all lengths by the shortest.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        self.longest() / self.shortest()
    }

    /// The same linkage, driven at its other pivot; a slide drives nothing.
    #[must_use]
    pub fn swapped(&self) -> Option<Proposal> {
        let Partner::Rocker(d) = self.partner else {
            return None;
        };
        Some(Proposal {
            pivot: d,
            partner: Partner::Rocker(self.pivot),
            places: self.places.iter().map(|[b, c]| [*c, *b]).collect(),
            tracer: self.tracer,
        })
    }
}
