//! Unsaved edits of earlier sessions: offered, restored, deleted.

use super::English;
use std::fmt::Display;

catalogue! {
    /// The offer of unsaved edits.
    trait OfferingWords for English {
        edits_kept_nowhere =
            "edits are not kept for recovery: set HOME or XDG_STATE_HOME to an absolute path";
        edits_not_kept(folder: &dyn Display, why: &dyn Display) =
            "edits are not kept for recovery: {folder}: {why}";
        others_have_edits = "other sessions edited this scene: reopen it to see";
        edits_by_others = "edits of this scene by other sessions";
        older_edits_are_back(key: &str) = "restored; the file has changed since; {key} undoes";
        edits_are_back(key: &str) = "unsaved edits restored; {key} undoes";
        edits_cannot_be_shown(why: &str) = "cannot show the edits: {why}";
        edits_deleted = "edits deleted";

        // The dialog.
        open_elsewhere = "Open elsewhere";
        unsaved_edits_here = "Unsaved edits of this scene";
        the_edited_text = "The edited text";
        edit_that_waits(name: &str, text: &str) = "staged: {name} = {text}";
        what_the_edits_change = "Changes by the edits";
        of_time(time: &str) = "of {time}";
        older_than_file = "older than the file";
        made_on_another_text = "file has changed";
        open_elsewhere_too(process: &dyn Display, host: &str, since: &str) =
            "Also open in krank process {process} on {host}, since {since}. Its edits are kept; the second to save \
             is asked to confirm.";

        // Keys of the dialog.
        look = "look";
        later = "later";
        drop_them = "drop";
        drops_for_ever = "again deletes for good,";
        any_other_key_does_not = "any other key does not";
    }
}
