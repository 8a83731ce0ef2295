//! Edits of the scene, and the comparison with another scene.

use super::English;

catalogue! {
    /// Edits and comparisons.
    trait EditingWords for English {
        // Values.
        no_numbers = "the scene has no values";
        nudge_by(step: &str, unit: &str) = "nudge by {step} {unit}";
        value_in_file(value: &str) = "file: {value}";
        in_the_file = "in the file";
        values_changed(count: usize) = "{count} changed";
        gathering(count: usize) = {
            match count {
                0 => "edits are staged".to_owned(),
                1 => "1 edit staged".to_owned(),
                count => format!("{count} staged"),
            }
        };
        edits_wait(key: &str) = "staged edits: {key} applies them, Esc discards them";
        make_gathered = "apply";
        drop_staged = "drop";
        gathered_made(count: usize) = {
            match count {
                0 => "edits apply immediately".to_owned(),
                1 => "1 edit applied".to_owned(),
                count => format!("{count} edits applied"),
            }
        };
        gathered_dropped(key: &str) = "discarded the staged edits; {key} restores them";
        start_follows = "[start] changed to keep this assembly";

        // Reasons why an edit cannot be shown.
        this_assembly(why: &str) = "this assembly {why}";
        no_start_tells_it = "no [start] identifies this assembly and keeps all links";
        a_joint = "a joint";
        joint_out_of_reach(joint: &str, gap: &str, unit: &str) = "{joint} out of reach by {gap} {unit}";

        // Undo and redo.
        assembly = "assembly";
        reading_the_file = "reload";
        recovered_edits = "recovered edits";
        nothing_to_undo = "nothing to undo";
        nothing_to_redo = "nothing to redo";
        undone(edit: &str) = "{edit} undone";
        redone(edit: &str) = "{edit} redone";

        // Comparison.
        esc_ends_comparison = "Esc ends the comparison";
        no_longer_compared = "comparison ended";
        has_no_assembly_here(scene: &str) = "{scene} has no assembly here";
        this_less(scene: &str) = "this - {scene}";
        difference_from(scene: &str) = "difference: this - {scene}";
        driven_at(speed: &str) = "driven at {speed}";
        this_and_other(this: &str, other: &str) = "{this} and {other}";
        only_there(names: &str) = "only there: {names}";
        a_link_that_turns = "a link that turns";
        a_slide = "a slide";
        no_common_coordinate(scene: &str, by: &str, this_by: &str) =
            "{scene} is driven by {by}, this scene by {this_by}: they share no coordinate";
        against(scene: &str) = "compared with {scene}";
        against_without_assembly(scene: &str) = "compared with {scene}: no assembly here";
    }
}
