//! Forces: what the driver must do, and what joints, guides and the frame bear.

use super::English;

catalogue! {
    /// Tables of forces, and what is said of those that are missing.
    trait ForcesWords for English {
        // Titles and columns.
        driver = "driver";
        driver_named(name: &str) = "driver {name}";
        in_all = "in all";
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

        // What is missing.
        driver_alone_has_value(effort: &str) =
            "Of the forces only the driver's {effort} has a value here: at a change point the links \
             lie so that any force can run round among them.";
        nothing_to_balance = "The mechanism cannot be here: there is nothing to balance.";
        no_effort_exists(effort: &str) =
            "No {effort} of the driver exists here: at a dead point it cannot move the linkage, and \
             what would hold that, in the joints too, grows beyond all bounds.";
        indeterminate(reactions: &str) =
            "Indeterminate: {reactions}. The linkage has more constraints than it needs, and those \
             can press against each other with any force; all other figures stand.";
        indeterminate_with_least(reactions: &str) =
            "Indeterminate: {reactions}. The linkage has more constraints than it needs, and those \
             can press against each other with any force; all other figures stand. Of least norm: \
             what they would be if all pins and guides gave way alike.";
    }
}
