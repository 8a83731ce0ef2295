//! What is wanted, in numbers.

use kinematics::Vec2;

/// A motion that is wanted, and what would be liked beside it.
#[derive(Clone, Debug, PartialEq)]
pub struct Task {
    /// The motion.
    pub kind: TaskKind,
    /// Which linkages are looked for.
    pub four_bars: bool,
    /// Whether slider-cranks are looked for.
    pub slider_cranks: bool,
    /// What would be liked.
    pub wishes: Wishes,
}

impl Task {
    /// How many points, poses or pairs are wanted.
    #[must_use]
    pub fn points(&self) -> usize {
        match &self.kind {
            TaskKind::Poses(task) => task.poses.len(),
            TaskKind::Path(task) => task.points.len(),
            TaskKind::Function(task) => task.pairs.len(),
        }
    }

    /// A length by which misses are measured: how far the points are apart, or the size that is given.
    #[must_use]
    pub fn size(&self) -> f64 {
        let spread = |points: &[Vec2]| {
            let first = points.first().copied().unwrap_or_default();
            let far = points.iter().map(|p| (*p - first).norm());
            far.fold(0.0, f64::max)
        };
        match &self.kind {
            TaskKind::Poses(task) => {
                let places: Vec<Vec2> = task.poses.iter().map(|pose| pose.at).collect();
                spread(&places)
            }
            TaskKind::Path(task) => spread(&task.points),
            TaskKind::Function(task) => task.size,
        }
    }
}

/// A motion that is wanted.
#[derive(Clone, Debug, PartialEq)]
pub enum TaskKind {
    /// A body is to come through poses.
    Poses(PoseTask),
    /// A link's angle, or a slide, is to follow the crank's angle.
    Function(FunctionTask),
    /// A point of the coupler is to come through points.
    Path(PathTask),
}

/// Where a body is to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Its origin.
    pub at: Vec2,
    /// Its x axis, in degrees.
    pub angle: f64,
}

/// Three to five poses.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PoseTask {
    /// In their order.
    pub poses: Vec<Pose>,
    /// Pivots on the ground that are given: at most two.
    pub pivots: Vec<Vec2>,
    /// Pins on the body that are given, in its own frame: at most two.
    pub pins: Vec<Vec2>,
}

/// What follows the crank's angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// The angle of the link on the other pivot, in degrees.
    Angle,
    /// The travel of a slide on the ground, a length.
    Slide,
}

/// A number that is given, or to be found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Given {
    /// It is this.
    Value(f64),
    /// It may be anything.
    Free,
}

/// The crank at `crank_datum + crank_scale x`, the output at `output_datum + output_scale y`, for every pair.
#[derive(Clone, Debug, PartialEq)]
pub struct FunctionTask {
    /// The pairs `[x, y]`, in their order.
    pub pairs: Vec<[f64; 2]>,
    /// What is wanted between them, where that is known: more pairs, densely, at which the error is told.
    pub between: Vec<[f64; 2]>,
    /// What follows.
    pub output: Output,
    /// The crank's angle where x is 0, in degrees.
    pub crank_datum: Given,
    /// Degrees of the crank for each x.
    pub crank_scale: Given,
    /// The output where y is 0.
    pub output_datum: Given,
    /// Degrees, or lengths, of the output for each y.
    pub output_scale: Given,
    /// How far apart the pivots are, or, of a slide, how long the crank is: a function has no size of its own.
    pub size: f64,
}

/// Points in any number.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PathTask {
    /// In their order.
    pub points: Vec<Vec2>,
    /// Whether the path comes back to the first point: the crank turns once on the way.
    pub closed: bool,
    /// How far the crank has turned from the first point to each, in degrees; none where that is free.
    pub turns: Option<Vec<f64>>,
    /// Pivots on the ground that are given: at most two.
    pub pivots: Vec<Vec2>,
    /// How much the miss of each point counts; as many as points.
    pub weights: Vec<f64>,
}

/// The way in which the crank is to turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// Counter-clockwise.
    CounterClockwise,
    /// Clockwise.
    Clockwise,
}

/// What would be liked beside the motion: a candidate that does not keep a wish says so, and stands behind those that do.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wishes {
    /// Whether the crank is to turn fully.
    pub full_turn: bool,
    /// The least transmission angle over the task, in degrees.
    pub transmission: Option<f64>,
    /// Two opposite corners of a box in which the pivots are to lie.
    pub inside: Option<[Vec2; 2]>,
    /// The largest ratio of the longest to the shortest length.
    pub ratio: Option<f64>,
    /// Whether the points are to be met in their order, with the crank turning one way.
    pub ordered: bool,
    /// Which way.
    pub sense: Option<Sense>,
}
