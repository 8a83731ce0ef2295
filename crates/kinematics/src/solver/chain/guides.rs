//! Represents guides as known lines: the point and the link with which a placed guide moves.

use super::Chain;
use crate::solver::elements::{GuideLine, Ride};
use crate::{Body, Constant, LinkId, PointId, SlideId, Vec2};

impl Chain<'_> {
    /// Returns the guide of a slide, if its body is placed.
    pub(super) fn line(&mut self, slide: SlideId) -> Option<GuideLine> {
        let given = self.network.mechanism.slide(slide);
        let link = self.network.body(given.on);
        let along = self.network.frame.unit(given.angle);
        if let Some(through) = self.guide_points[slide.index()] {
            return Some(GuideLine {
                through,
                link,
                along,
            });
        }
        let through = match given.on {
            Body::Ground => {
                let constant = self.new_point(self.network.through(slide));
                self.constants.push(constant);
                constant
            }
            Body::Link(on) => {
                let (base, at) = self.knows(on).then(|| self.footing(on)).flatten()?;
                let local = self.network.through(slide) - at;
                if local == Vec2::default() && !self.network.is_varied {
                    base
                } else {
                    self.ride(base, on, local)
                }
            }
        };
        self.guide_points[slide.index()] = Some(through);
        Some(GuideLine {
            through,
            link,
            along,
        })
    }

    /// Returns the position and the direction of a line that never moves: on the ground itself,
    /// through a point that no step places.
    pub(super) fn rail(&self, line: &GuideLine) -> Option<[Vec2<Constant>; 2]> {
        let is_constant = self.constants.contains(&line.through);
        (line.link == self.network.ground() && is_constant)
            .then(|| [self.program.points[line.through.index()], line.along])
    }

    /// Creates an auxiliary point that rides on a link at `local` from `base`.
    pub(super) fn ride(&mut self, base: PointId, link: LinkId, local: Vec2<Constant>) -> PointId {
        let point = self.new_point(Vec2::default());
        self.push(Ride {
            point,
            base,
            link,
            local,
        });
        point
    }
}
