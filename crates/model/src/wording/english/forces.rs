//! Forces: the driver, joints, guides and the frame.

use super::English;

catalogue! {
    /// Tables of forces, and reasons for missing ones.
    trait ForcesWords for English {
        // Titles and columns.
        driver = "driver";
        driver_named(name: &str) = "driver {name}";
        in_all = "total";
        loads = "loads";
        inertia = "inertia";
        power = "power";
        force_at_joints = "force at joints";
        force_of_guides = "force of guides";
        of_least_norm = "of least norm";
        on_the_frame = "on the frame";
        shaking = "shaking";
        checks_miss_by = "checks miss by";
        normal = "normal";
        at = "at";
        link_at_point(link: &str, point: &str) = "{link} at {point}";
        link_at_point_by(link: &str, point: &str, by: &str) = "{link} at {point}, by {by}";
        guide_on(guide: &str, slider: &str) = "{guide} on {slider}";

        // Missing forces.
        driver_alone_has_value(effort: &str) =
            "Of the forces only the driver's {effort} has a value here: at a change point, the links can carry \
             internal forces of any size.";
        nothing_to_balance = "The mechanism cannot be assembled here, so there are no forces.";
        no_effort_exists(effort: &str) =
            "No {effort} of the driver exists here: at a dead point the driver cannot move the mechanism, and \
             the forces grow without bound.";
        indeterminate(reactions: &str) =
            "Indeterminate: {reactions}. The mechanism has redundant constraints, which can act against each \
             other with any force; all other values are valid.";
        indeterminate_with_least(reactions: &str) =
            "Indeterminate: {reactions}. The mechanism has redundant constraints, which can act against each \
             other with any force; all other values are valid. Of least norm: the reactions if all pins and \
             guides were equally elastic.";
    }
}
