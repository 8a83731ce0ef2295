//! Defines the defects that prevent a mechanism from being built.

use super::{ElementId, LimitId, LinkId, PointId, SlideId};
use std::fmt;
use thiserror::Error;

/// A defect of one element of a mechanism, found by [`Builder::build`](super::Builder::build).
#[derive(Clone, Debug, Error, PartialEq)]
pub enum Defect {
    /// A link whose length is not a positive finite number.
    #[error("the length must be a positive number, not {length}")]
    Length {
        /// The link.
        link: LinkId,
        /// The length given.
        length: f64,
    },
    /// A link far too short compared with the mechanism's longest length: the fourth power of their
    /// ratio underflows.
    #[error("the length {length} is out of all proportion to the longest one, {longest}")]
    Proportion {
        /// The link.
        link: LinkId,
        /// The length of the link, or the minimum distance between its points.
        length: f64,
        /// The longest length, or the maximum distance on the ground or on a link.
        longest: f64,
    },
    /// A non-finite coordinate of a ground point, a member, a guide or a start position.
    #[error("the coordinates must be finite numbers")]
    Coordinates {
        /// The element with the coordinate.
        of: ElementId,
    },
    /// A point that occurs twice in one link.
    #[error("the point stands twice in the link")]
    Twice {
        /// The link.
        link: LinkId,
        /// The point.
        point: PointId,
    },
    /// A link without points.
    #[error("the link has no point")]
    Empty {
        /// The link.
        link: LinkId,
    },
    /// A point that belongs neither to the ground, nor to a link, nor to a slide.
    #[error("the point belongs to no link, no slide and not to the ground")]
    Stray {
        /// The point.
        point: PointId,
    },
    /// A link that slides on itself, or a point that slides on a body carrying it.
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
    /// A link turned against itself.
    #[error("no link turns against itself")]
    TurnedFromItself {
        /// The link.
        link: LinkId,
    },
    /// A non-finite coordinate or rate of the driver.
    #[error("the driver's coordinate, speed and acceleration must be finite numbers")]
    Driver,
    /// A missing driver.
    #[error("there is no driver")]
    NoDriver,
    /// A link or slide driven by two inputs.
    #[error("two inputs drive the same element")]
    DrivenTwice {
        /// The driven element.
        of: ElementId,
    },
    /// A closed table of an input that does not return to its first value, or whose driver does not
    /// turn.
    #[error("the table closes over whole turns of the driver only where its values come back")]
    OpenTable {
        /// The driven element.
        of: ElementId,
    },
    /// A negative or non-finite mass or inertia.
    #[error("mass and inertia must be finite and not negative")]
    Mass {
        /// The link.
        link: LinkId,
    },
    /// A mass without a centre of mass.
    #[error("a mass needs a centre of mass")]
    NoCentre {
        /// The link.
        link: LinkId,
    },
    /// A limit whose ends are not finite or not in order, or an angle limit whose ends are a turn
    /// or more apart.
    #[error("a limit needs two finite ends, the lower one first, those of an angle within a turn")]
    Limit {
        /// The limit.
        limit: LimitId,
    },
    /// A negative or non-finite accepted disagreement.
    #[error("the accepted misfit must be finite and not negative")]
    RateError,
    /// A load, gravity or length unit that is not finite, or negative where it must not be. Also a
    /// spring from a point to itself, and a press whose guide moves.
    #[error(
        "loads and gravity must be finite, springs join two points, presses work on the ground"
    )]
    Load,
}

/// All defects of a mechanism's elements; never empty.
#[derive(Clone, Debug, PartialEq)]
pub struct Defects {
    pub(super) list: Vec<Defect>,
}

impl Defects {
    /// Returns the defects, in the order of the elements.
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
