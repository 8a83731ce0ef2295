//! The names of the views; their contents are defined in `tui::views`.

/// A view of the workbench.
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
    /// The values of the scene.
    Scene,
    /// The sensitivities of the results to the given lengths.
    Lengths,
    /// The derivation of the results.
    Working,
    /// The motor's duty over a cycle.
    Motor,
}

impl View {
    /// All views, in the order of their keys.
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
