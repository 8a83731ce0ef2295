//! Reactions of least norm, for those that a redundant linkage leaves indeterminate.

use crate::report::forces::{GuideRow, JointRow, plane_figures};
use crate::report::tables::entry::{Entry, PlaneVector};
use crate::scene::Scene;
use crate::solver::{Indeterminate, LeastNorm, Solver, State};

/// The reactions of equally compliant pins and guides: one of all solutions in equilibrium. The
/// values have no bounds.
#[derive(Clone, Debug)]
pub struct LeastNormReactions {
    /// The indeterminate joints.
    pub joints: Vec<JointRow>,
    /// The indeterminate guides, together with their determinate values.
    pub guides: Vec<GuideRow>,
}

impl LeastNormReactions {
    /// Computes the reactions at the state's coordinate, from the rows of all joints and guides.
    /// Returns `None` if none is indeterminate, or if there are no reactions.
    pub(in crate::report) fn new(
        scene: &Scene,
        solver: &Solver,
        state: &State,
        (joints, guides): (&[JointRow], &[GuideRow]),
    ) -> Option<LeastNormReactions> {
        let found = solver.least_norm(state.at())?;
        let mut minimum = LeastNormReactions {
            joints: Vec::new(),
            guides: Vec::new(),
        };
        for open in solver.indeterminate() {
            match *open {
                Indeterminate::Joint(link, point) => {
                    let names = (scene.link_name(link), scene.point_name(point));
                    let row = joints
                        .iter()
                        .find(|row| (row.link.as_str(), Some(row.point.as_str())) == names);
                    let force = found.joint_force(link, point);
                    let force = force.map(|force| PlaneVector::new(force, [None; 2]));
                    minimum.joints.extend(row.map(|row| JointRow {
                        force,
                        ..row.clone()
                    }));
                }
                Indeterminate::Normal(slide) | Indeterminate::Moment(slide) => {
                    let name = scene.slide_name(slide);
                    if minimum.guides.iter().all(|row| row.name != name) {
                        let row = guides.iter().find(|row| row.name == name);
                        let completed = |row: &GuideRow| completed(row, slide, &found);
                        minimum.guides.extend(row.map(completed));
                    }
                }
            }
        }
        Some(minimum)
    }

    /// Returns every value with its column name.
    pub(in crate::report) fn figures(&self) -> Vec<(String, Option<f64>)> {
        let mut all = Vec::new();
        for joint in &self.joints {
            let name = format!("{}.{}", joint.link, joint.point);
            let figures = plane_figures(&name, joint.force).into_iter();
            all.extend(figures.map(|(name, _, entry)| (name, entry.value)));
        }
        for guide in &self.guides {
            all.push((format!("{}.normal", guide.name), guide.normal.value));
            let moment = guide
                .moment
                .map(|m| (format!("{}.moment", guide.name), m.value));
            all.extend(moment);
        }
        all
    }
}

/// Returns a guide with its indeterminate values filled in.
fn completed(row: &GuideRow, slide: crate::SlideId, found: &LeastNorm) -> GuideRow {
    let with = |entry: Entry, open: Option<f64>| open.map_or(entry, of);
    let normal = with(row.normal, found.normal(slide));
    let moment = row.moment.map(|moment| with(moment, found.moment(slide)));
    GuideRow {
        normal,
        moment,
        at: None,
        ..row.clone()
    }
}

/// Creates a value without a bound.
fn of(value: f64) -> Entry {
    Entry {
        value: Some(value),
        given: false,
        bound: None,
    }
}
