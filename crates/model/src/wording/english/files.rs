//! Files: reading, writing and external changes.

use super::English;
use std::fmt::Display;

catalogue! {
    /// Files and presets.
    trait FilesWords for English {
        // Paths that are not files.
        is_a_folder = "it is a folder";
        pipe_without_writer = "it is a pipe that nobody writes to";
        is_a_pipe = "it is a pipe, not a file";
        is_a_socket = "it is a socket, not a file";
        is_a_device = "it is a device, not a file";
        is_no_file_of_its_own = "it is an open file descriptor, not a file";
        is_no_name_of_a_file = "not a file name";
        was_cut_while_read = "it became shorter while it was read";
        is_no_record = "not a record of krank";

        // Reasons why a file is not written.
        exists_already = "the file already exists";
        changed_on_disk = "it has changed on disk";
        changed_while_it_grew =
            "it was deleted, replaced or changed while rows were written; no more rows were written";
        is_read_only = "it is read-only";
        another_is_writing = "another program is writing to it";
        no_journal = "it cannot be replaced, and there is no state folder for a backup";
        disk_full = "the disk is full";
        file_too_large = "the file is too large";
        no_permission = "no permission";
        disk_read_only = "the disk is read-only";
        no_such_folder = "no such folder";
        add_a_name = "that is a folder: add a name";
        not_written(why: &str) = "not written: {why}";
        not_written_to(name: &str, why: &str) = "not written, {why}: {name}";
        not_written_without_start = "not written: no start positions identify this assembly";

        // Questions before writing.
        write_over(name: &str) = "overwrite {name}?";
        write_over_changed(name: &str) = "{name} has changed on disk: overwrite it?";
        write_over_newer(name: &str) = "{name} is newer than these edits: overwrite it?";
        write_read_only(name: &str) = "{name} is read-only: overwrite?";

        // Writing.
        unchanged_since_saved = "no changes to save";
        still_writing = "another file is still being written";
        writing_to(name: &dyn Display) = "writing {name}";
        written_to(name: &dyn Display) = "written to {name}";
        all_written_to(what: &str, name: &dyn Display) = "{what} written to {name}";
        or_save_elsewhere(why: &str, key: &str) = "{why}; {key} saves elsewhere";
        broken_there = "internal error";

        // Reading.
        reading(name: &str) = "reading {name}";
        cannot_be_read(why: &dyn Display) = "cannot be read: {why}";
        name_cannot_be_read(name: &str, why: &dyn Display) = "{name} cannot be read: {why}";
        is_folder(name: &dyn Display) = "{name} is a folder";
        no_presets = "no presets";
        no_preset(name: &str) = "no preset is named {name}";
        preset_cannot_be_opened(name: &str, why: &dyn Display) =
            "the preset {name} cannot be opened: {why}";

        // External changes.
        file_changed(name: &str, reload: &str, elsewhere: &str) =
            "{name} has changed on disk: {reload} reloads, {elsewhere} saves elsewhere";
        no_file_to_read = "this scene has no file to reload";
        file_is_gone(name: &str, key: &str) = "{name} deleted: {key} saves it again";
        was_read_again(name: &str) = "{name} reloaded";
        is_broken_not_shown(name: &str, fault: &str) = "{name} invalid, not shown: {fault}";
    }
}
