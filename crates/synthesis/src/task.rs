//! The task of a synthesis, in numbers.

use kinematics::Vec2;

/// A wanted motion and the preferences for its linkage.
#[derive(Clone, Debug, PartialEq)]
pub struct Task {
    /// The motion.
    pub kind: TaskKind,
    /// Whether to search for four-bars.
    pub four_bars: bool,
    /// Whether to search for slider-cranks.
    pub slider_cranks: bool,
    /// The preferences.
    pub preferences: Preferences,
}

impl Task {
    /// Returns the number of points, poses or pairs.
    #[must_use]
    pub fn points(&self) -> usize {
        match &self.kind {
            TaskKind::Poses(task) => task.poses.len(),
            TaskKind::Path(task) => task.points.len(),
            TaskKind::Function(task) => task.pairs.len(),
        }
    }

    /// Returns the length to which misses are relative: the maximum distance of a point from the
    /// first, or the given size.
    #[must_use]
    pub fn size(&self) -> f64 {
        let spread = |points: &[Vec2]| {
            let first = points.first().copied().unwrap_or_default();
            let far = points.iter().map(|p| (*p - first).norm());
            far.fold(0.0, f64::max)
        };
        match &self.kind {
            TaskKind::Poses(task) => {
                let positions: Vec<Vec2> = task.poses.iter().map(|pose| pose.at).collect();
                spread(&positions)
            }
            TaskKind::Path(task) => spread(&task.points),
            TaskKind::Function(task) => task.size,
        }
    }
}

/// A wanted motion.
#[derive(Clone, Debug, PartialEq)]
pub enum TaskKind {
    /// A body passes through poses.
    Poses(PoseTask),
    /// A link's angle, or a slide, follows the crank's angle.
    Function(FunctionTask),
    /// A point of the coupler passes through points.
    Path(PathTask),
}

/// The position and orientation of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// The position of its origin.
    pub at: Vec2,
    /// The direction of its x axis, in degrees.
    pub angle: f64,
}

/// Rigid-body guidance through three to five poses.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PoseTask {
    /// The poses in their order.
    pub poses: Vec<Pose>,
    /// Given ground pivots, at most two.
    pub pivots: Vec<Vec2>,
    /// Given pins on the body, in its own frame, at most two.
    pub pins: Vec<Vec2>,
}

/// The output of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// The angle of the link on the other pivot, in degrees.
    Angle,
    /// The travel of a slide on the ground, a length.
    Slide,
}

/// A number that is either given or free.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GivenNumber {
    /// A given value.
    Value(f64),
    /// A number for the search to find.
    Free,
}

/// A function: for every pair, the crank is at `crank_datum + crank_scale x` and the output at
/// `output_datum + output_scale y`.
#[derive(Clone, Debug, PartialEq)]
pub struct FunctionTask {
    /// The pairs `[x, y]`, in their order.
    pub pairs: Vec<[f64; 2]>,
    /// The wanted function between the pairs if it is known: more pairs, densely spaced, at which
    /// the error is measured.
    pub between: Vec<[f64; 2]>,
    /// The kind of output.
    pub output: Output,
    /// The crank's angle at x = 0, in degrees.
    pub crank_datum: GivenNumber,
    /// The crank's rotation per unit of x, in degrees.
    pub crank_scale: GivenNumber,
    /// The output at y = 0, in degrees or as a length.
    pub output_datum: GivenNumber,
    /// The output per unit of y, in degrees or as a length.
    pub output_scale: GivenNumber,
    /// The distance between the pivots, or the crank's length for a slide: a function has no size
    /// of its own.
    pub size: f64,
}

/// A path of any number of points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PathTask {
    /// The points in their order.
    pub points: Vec<Vec2>,
    /// Whether the path returns to the first point, in one turn of the crank.
    pub closed: bool,
    /// The crank's rotation from the first point to each, in degrees; `None` if it is free.
    pub turns: Option<Vec<f64>>,
    /// Given ground pivots, at most two.
    pub pivots: Vec<Vec2>,
    /// The weights of the points' misses, one per point; missing weights are 1.
    pub weights: Vec<f64>,
}

/// The sense in which the crank turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// Counter-clockwise.
    CounterClockwise,
    /// Clockwise.
    Clockwise,
}

/// Preferences for the linkage, apart from its motion. A candidate that does not meet one reports
/// it and comes after those that do.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Preferences {
    /// Whether the crank should turn fully.
    pub full_turn: bool,
    /// The minimum transmission angle over the task, in degrees.
    pub transmission: Option<f64>,
    /// Two opposite corners of a box for the pivots.
    pub inside: Option<[Vec2; 2]>,
    /// The maximum ratio of the longest length to the shortest.
    pub ratio: Option<f64>,
    /// Whether the crank should reach the points in their order, turning one way.
    pub ordered: bool,
    /// The sense in which the crank should turn.
    pub sense: Option<Sense>,
}
