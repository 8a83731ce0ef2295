//! Edits that sessions have left: offered, taken up, dropped.

use super::English;
use std::fmt::Display;

catalogue! {
    /// The offer of unsaved edits.
    trait OfferingWords for English {
        edits_kept_nowhere =
            "edits are not kept for recovery: set HOME or XDG_STATE_HOME to an absolute path";
        edits_not_kept(folder: &dyn Display, why: &dyn Display) =
            "edits are not kept for recovery: {folder}: {why}";
        others_have_edits = "others have edits of this scene: open it again to see";
        edits_by_others = "edits of this scene by other sessions";
        older_edits_are_back(key: &str) =
            "back, made on another text than the file has; {key} undoes";
        edits_are_back(key: &str) = "the unsaved edits are back; {key} takes them away";
        edits_cannot_be_shown(why: &str) = "they cannot be shown: {why}";
        edits_deleted = "these edits are deleted";

        // The box in the middle of the screen.
        open_elsewhere = "Open elsewhere";
        unsaved_edits_here = "Unsaved edits of this scene";
        the_edited_text = "The edited text";
        edit_that_waits(name: &str, text: &str) = "waits: {name} = {text}";
        what_the_edits_change = "What the edits change";
        of_time(time: &str) = "of {time}";
        older_than_file = "older than the file";
        made_on_another_text = "made on another text";
        open_elsewhere_too(process: &dyn Display, host: &str, since: &str) =
            "krank has it open too: process {process} on {host}, since {since}. Its edits are left \
             alone; who saves second is asked.";

        // Its keys.
        look = "look";
        later = "later";
        drop_them = "drop";
        drops_for_ever = "again drops them for ever,";
        any_other_key_does_not = "any other key does not";
    }
}
