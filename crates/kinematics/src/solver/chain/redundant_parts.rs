//! Adds the parts outside the groups: watched constraints of redundant mechanisms, and the travel
//! of every slide.

use super::Chain;
use crate::solver::elements::SlideReadout;
use crate::solver::plan::network::ScalarEquation;
use crate::solver::plan::{Gauge, WatchedConstraint};
use crate::{Constant, Input, LinkId, PointId, Vec2};

impl Chain<'_> {
    /// Watches all constraints if some were set aside, those first. The steps themselves determine
    /// which constraints they leave out. For example, all joints of a link may ride on it although
    /// one of its equations was set aside. Another constraint is left out instead.
    pub(super) fn watch(&mut self, set_aside: &[ScalarEquation]) {
        if set_aside.is_empty() {
            return;
        }
        let network = self.network;
        let others = network.rows.iter().filter(|r| !set_aside.contains(r));
        for &row in set_aside.iter().chain(others) {
            if let Some(gauge) = self.gauge(row) {
                self.program.watches.push(WatchedConstraint {
                    element: row.element(),
                    gauge,
                });
            }
        }
    }

    fn gauge(&mut self, row: ScalarEquation) -> Option<Gauge> {
        match row {
            ScalarEquation::Along { link, end } => {
                let (from, arm) = self.relative_joint(link, end)?;
                let length = arm.norm();
                Some(Gauge::Distance {
                    from,
                    to: end,
                    length,
                })
            }
            ScalarEquation::Across { link, end } => {
                let (from, arm) = self.relative_joint(link, end)?;
                let along = arm / arm.norm();
                Some(Gauge::Direction {
                    from,
                    to: end,
                    link,
                    along,
                })
            }
            ScalarEquation::Slot(slide) => {
                let point = self.network.mechanism.slide(slide).slider.point();
                let line = self.line(slide)?;
                Some(Gauge::OnLine { point, line })
            }
            ScalarEquation::Push(slide) => {
                let point = self.network.mechanism.slide(slide).slider.point();
                let line = self.line(slide)?;
                let following = self.network.following(Input::Push(slide)).cloned();
                Some(Gauge::Pushed {
                    point,
                    line,
                    following,
                })
            }
            ScalarEquation::Elbow(link) => {
                let [link, from] = self.network.elbow(link);
                let following = self.network.following(Input::Turn(link)).cloned();
                Some(Gauge::Turned {
                    link,
                    from,
                    following,
                })
            }
        }
    }

    /// Returns another joint of a link, and `end` relative to it in the link's frame.
    fn relative_joint(&self, link: LinkId, end: PointId) -> Option<(PointId, Vec2<Constant>)> {
        let mut joints = self.network.joints(link).map(|m| m.point);
        let other = joints.find(|&p| p != end)?;
        Some((other, self.network.between(link, other, end)?))
    }

    pub(super) fn travels(&mut self) {
        for slide in self.network.mechanism.slide_ids() {
            let point = self.network.mechanism.slide(slide).slider.point();
            if let Some(line) = self.line(slide) {
                self.push(SlideReadout { slide, point, line });
            }
        }
    }
}
