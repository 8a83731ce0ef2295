//! What is wrong with a mechanism that cannot be built.

use super::{ElementId, LimitId, LinkId, PointId, SlideId};
use std::fmt;
use thiserror::Error;

/// What is wrong with one element of a mechanism, found by [`Builder::build`](super::Builder::build).
#[derive(Clone, Debug, Error, PartialEq)]
pub enum Defect {
    /// A link of no length, or with a length that is no positive number.
    #[error("the length must be a positive number, not {length}")]
    Length {
        /// The link.
        link: LinkId,
        /// The length given.
        length: f64,
    },
    /// A link far too short beside the longest length of the mechanism: the square of its square is less than
    /// any double in units of that.
    #[error("the length {length} is out of all proportion to the longest one, {longest}")]
    Proportion {
        /// The link.
        link: LinkId,
        /// Its length, or the least distance of its points.
        length: f64,
        /// The longest length, or the largest distance on the ground or on a link.
        longest: f64,
    },
    /// A coordinate of a ground point, a member, a guide or a start that is not finite.
    #[error("the coordinates must be finite numbers")]
    Coordinates {
        /// Whose.
        of: ElementId,
    },
    /// The same point twice in one link.
    #[error("the point stands twice in the link")]
    Twice {
        /// The link.
        link: LinkId,
        /// The point.
        point: PointId,
    },
    /// A link without a point.
    #[error("the link has no point")]
    Empty {
        /// The link.
        link: LinkId,
    },
    /// A point on neither the ground, nor a link, nor a slide.
    #[error("the point belongs to no link, no slide and not to the ground")]
    Stray {
        /// The point.
        point: PointId,
    },
    /// A slide of a link on itself, or of a point that the guide's body carries.
    #[error("nothing can slide on itself")]
    OnItself {
        /// The slide.
        slide: SlideId,
    },
    /// A driven link without a ground point to turn about.
    #[error("the driven link has no ground point to turn about")]
    NoPivot {
        /// The link.
        link: LinkId,
    },
    /// A link that is turned against itself.
    #[error("no link turns against itself")]
    TurnedFromItself {
        /// The link.
        link: LinkId,
    },
    /// A driver coordinate or rate that is not finite.
    #[error("the driver's coordinate, speed and acceleration must be finite numbers")]
    Driver,
    /// No driver was set.
    #[error("there is no driver")]
    NoDriver,
    /// A link or a slide that is driven by two inputs.
    #[error("two inputs drive the same element")]
    DrivenTwice {
        /// What is driven.
        of: ElementId,
    },
    /// A closed table of an input that does not come back to its first value, or whose driver does not turn.
    #[error("the table closes over whole turns of the driver only where its values come back")]
    OpenTable {
        /// What is driven.
        of: ElementId,
    },
    /// A mass or an inertia that is negative or not finite.
    #[error("mass and inertia must be finite and not negative")]
    Mass {
        /// The link.
        link: LinkId,
    },
    /// A mass without a centre.
    #[error("a mass needs a centre of mass")]
    NoCentre {
        /// The link.
        link: LinkId,
    },
    /// A limit whose ends are not finite or not in order, or that of an angle with its ends a turn apart.
    #[error("a limit needs two finite ends, the lower one first, those of an angle within a turn")]
    Limit {
        /// The limit.
        limit: LimitId,
    },
    /// An accepted misfit that is negative or not finite.
    #[error("the accepted misfit must be finite and not negative")]
    Misfit,
    /// A load, the gravity or the unit that is not finite, or negative where it must not be; a spring
    /// from a point to itself; a press whose guide moves.
    #[error(
        "loads and gravity must be finite, springs join two points, presses work on the ground"
    )]
    Load,
}

/// All that is wrong with the elements of a mechanism: never nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Defects {
    pub(super) list: Vec<Defect>,
}

impl Defects {
    /// One by one, in the order of the elements.
    #[must_use]
    pub fn list(&self) -> &[Defect] {
        &self.list
    }
}

impl fmt::Display for Defects {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, defect) in self.list.iter().enumerate() {
            let joint = if i > 0 { "; " } else { "" };
            write!(f, "{joint}{defect}")?;
        }
        Ok(())
    }
}

impl std::error::Error for Defects {}
