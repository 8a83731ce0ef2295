//! Edits of the scene, and another scene beside it.

use super::English;

catalogue! {
    /// Values that are changed, and scenes that are compared.
    trait EditingWords for English {
        // Values.
        no_numbers = "the scene has no numbers";
        nudge_by(step: &str, unit: &str) = "nudge by {step} {unit}";
        value_in_file(value: &str) = "file: {value}";
        in_the_file = "in the file";
        values_changed(count: usize) = "{count} changed";
        gathering(count: usize) = {
            match count {
                0 => "edits wait from now on".to_owned(),
                1 => "1 edit waits".to_owned(),
                count => format!("{count} edits wait"),
            }
        };
        edits_wait(key: &str) = "edits wait: {key} makes them together, Esc drops them";
        make_gathered = "make";
        drop_gathered = "drop";
        gathered_made(count: usize) = {
            match count {
                0 => "edits are made at once again".to_owned(),
                1 => "1 edit made".to_owned(),
                count => format!("{count} edits made together"),
            }
        };
        gathered_dropped(key: &str) = "the edits that waited are dropped; {key} brings them back";
        start_follows = "[start] follows, so that this assembly stays";

        // Why an edit cannot be shown.
        this_assembly(why: &str) = "this assembly {why}";
        no_start_tells_it = "no [start] could tell this assembly from the others";
        a_joint = "a joint";
        joint_out_of_reach(joint: &str, gap: &str, unit: &str) = "{joint} out of reach by {gap} {unit}";

        // Edits, and the way back.
        assembly = "assembly";
        reading_the_file = "reading the file";
        recovered_edits = "recovered edits";
        nothing_to_undo = "no edit to take back";
        nothing_to_redo = "no edit to make again";
        undone(edit: &str) = "{edit} taken back";
        redone(edit: &str) = "{edit} made again";

        // Beside another scene.
        esc_ends_comparison = "Esc ends the comparison";
        no_longer_compared = "no longer compared";
        has_no_assembly_here(scene: &str) = "{scene} has no assembly here";
        this_less(scene: &str) = "this - {scene}";
        difference_from(scene: &str) = "difference: this - {scene}";
        driven_at(speed: &str) = "driven at {speed}";
        this_and_other(this: &str, other: &str) = "{this} and {other}";
        only_there(names: &str) = "only there: {names}";
        a_link_that_turns = "a link that turns";
        a_slide = "a slide";
        no_common_coordinate(scene: &str, by: &str, this_by: &str) =
            "{scene} is driven by {by}, this scene by {this_by}: no coordinate is common";
        against(scene: &str) = "against {scene}";
        against_without_assembly(scene: &str) = "against {scene}: no assembly here";
    }
}
