//! The path in its own frame, with its middle at the origin and its size 1.

use super::preferences::SearchPreferences;
use crate::{PathTask, Preferences};
use kinematics::Vec2;

/// A point's position along the path, from 0 to 1, and two terms of additional rotation for an
/// unevenly turning crank.
#[derive(Clone, Copy, Debug)]
pub(super) struct PathPart {
    pub(super) part: f64,
    pub(super) uneven: [f64; 2],
}

/// The given pivots and the links to which they belong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum GivenPivots {
    /// The case without given pivots.
    Free,
    /// The crank's pivot.
    Crank(Vec2),
    /// The rocker's pivot.
    Rocker(Vec2),
    /// The crank's and the rocker's pivot.
    Both(Vec2, Vec2),
}

/// A path in its own frame.
#[derive(Clone, Debug)]
pub(super) struct TargetPath {
    pub(super) points: Vec<Vec2>,
    /// The weight of each point; the sum is 1.
    pub(super) weights: Vec<f64>,
    /// The crank's rotation from the first point, in degrees; `None` if it is free.
    pub(super) turns: Option<Vec<f64>>,
    pub(super) along: Vec<PathPart>,
    pub(super) closed: bool,
    pub(super) preferences: SearchPreferences,
    /// The origin and the size of this frame in the task's frame.
    pub(super) middle: Vec2,
    pub(super) size: f64,
}

impl TargetPath {
    /// Converts a task. Returns `None` if fewer than two different points have a weight, or if a
    /// number is not finite.
    pub(super) fn of(task: &PathTask, preferences: &Preferences) -> Option<TargetPath> {
        let given = |j: usize| task.weights.get(j).copied().unwrap_or(1.0).max(0.0);
        let total: f64 = (0..task.points.len()).map(given).sum();
        let weights: Vec<f64> = (0..task.points.len()).map(|j| given(j) / total).collect();
        let all = || task.points.iter().chain(&task.pivots);
        let turns = task.turns.as_ref();
        let is_sound = total > 0.0
            && total.is_finite()
            && all().all(|p| p.is_finite())
            && turns.is_none_or(|turns| {
                turns.len() == task.points.len() && turns.iter().all(|turn| turn.is_finite())
            });
        if !is_sound {
            return None;
        }
        let (middle, size) = frame(&task.points, &weights)?;
        let points: Vec<Vec2> = task
            .points
            .iter()
            .map(|&p| (p - middle) * (1.0 / size))
            .collect();
        Some(TargetPath {
            along: along(&points, task.closed),
            points,
            weights,
            turns: task.turns.clone(),
            closed: task.closed,
            preferences: SearchPreferences::of(preferences, task.closed, |p| {
                (p - middle) * (1.0 / size)
            }),
            middle,
            size,
        })
    }

    /// Converts a point of the task to this frame.
    pub(super) fn inside(&self, point: Vec2) -> Vec2 {
        (point - self.middle) * (1.0 / self.size)
    }

    /// Converts a point of this frame to the task's frame.
    pub(super) fn outside(&self, point: Vec2) -> Vec2 {
        self.middle + point * self.size
    }

    /// Returns a copy with about `most` points or fewer.
    pub(super) fn thinned(&self, maximum: usize) -> TargetPath {
        let step = self.points.len().div_ceil(maximum).max(1);
        let count = self.points.len();
        // The last point stays, since an open path ends there.
        let kept = || (0..count).filter(|j| j % step == 0 || j + 1 == count);
        let total: f64 = kept().map(|j| self.weights[j]).sum();
        let even = 1.0 / kept().count() as f64;
        let weight = |j: usize| {
            if total > 0.0 {
                self.weights[j] / total
            } else {
                even
            }
        };
        TargetPath {
            points: kept().map(|j| self.points[j]).collect(),
            weights: kept().map(weight).collect(),
            turns: self
                .turns
                .as_ref()
                .map(|turns| kept().map(|j| turns[j]).collect()),
            along: kept().map(|j| self.along[j]).collect(),
            ..*self
        }
    }
}

/// Returns the weighted middle of the points and the larger side of their box.
fn frame(points: &[Vec2], weights: &[f64]) -> Option<(Vec2, f64)> {
    let first = *points.first()?;
    let sum = |of: &dyn Fn(Vec2) -> f64| -> f64 {
        points
            .iter()
            .zip(weights)
            .map(|(&p, w)| w * of(p - first))
            .sum()
    };
    let middle = first + Vec2::new(sum(&|p| p.x), sum(&|p| p.y));
    let ends = |of: fn(&Vec2) -> f64| {
        let ends = points.iter().map(of);
        ends.clone().fold(f64::NEG_INFINITY, f64::max) - ends.fold(f64::INFINITY, f64::min)
    };
    let size = ends(|p| p.x).max(ends(|p| p.y));
    (size > 0.0 && size.is_finite() && middle.is_finite()).then_some((middle, size))
}

fn along(points: &[Vec2], closed: bool) -> Vec<PathPart> {
    let mut length = 0.0;
    let mut lengths = Vec::with_capacity(points.len());
    for (j, &point) in points.iter().enumerate() {
        length += (point - points[j.saturating_sub(1)]).norm();
        lengths.push(length);
    }
    if let (true, Some(&first), Some(&last)) = (closed, points.first(), points.last()) {
        length += (first - last).norm();
    }
    let turn = std::f64::consts::TAU;
    let along = |length_here: f64| {
        let part = length_here / length;
        let (sin, cos) = (turn * part).sin_cos();
        let second = if closed {
            (1.0 - cos) / turn
        } else {
            part * (1.0 - part)
        };
        PathPart {
            part,
            uneven: [sin / turn, second],
        }
    };
    lengths.into_iter().map(along).collect()
}
