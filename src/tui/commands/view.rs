//! The views by name. What each of them shows is in the room of the views.

/// What is looked at.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum View {
    /// The drawing, with live tables.
    #[default]
    Motion,
    /// All tables.
    Tables,
    /// Quantities over the motion.
    Plots,
    /// Speed against error.
    Accuracy,
    /// Forces.
    Forces,
    /// What the scene gives.
    Scene,
    /// What the given lengths do to the figures.
    Lengths,
    /// How the figures come about.
    Working,
    /// The motor over a cycle.
    Motor,
}

impl View {
    /// In the order of their keys.
    pub(crate) const ALL: [View; 9] = [
        View::Motion,
        View::Tables,
        View::Plots,
        View::Accuracy,
        View::Forces,
        View::Scene,
        View::Working,
        View::Motor,
        View::Lengths,
    ];
}
