//! Files: read, written, changed by others; edits that a session has left.

use super::English;
use std::fmt::Display;

catalogue! {
    /// Files and presets.
    trait FilesWords for English {
        // What stands where a file should.
        is_a_folder = "it is a folder";
        pipe_without_writer = "it is a pipe to which nobody writes";
        is_a_pipe = "it is a pipe, not a file";
        is_a_socket = "it is a socket, not a file";
        is_a_device = "it is a device, not a file";
        is_no_file_of_its_own = "it is open already, as no file of its own";
        is_no_name_of_a_file = "not the name of a file";
        was_cut_while_read = "it was cut while it was read";
        is_no_record = "no record of krank";

        // Why a file is not written.
        exists_already = "there is such a file already";
        changed_on_disk = "it has changed on disk";
        changed_while_it_grew =
            "it was deleted, replaced or changed while rows were added to it; no more rows were written";
        is_read_only = "it is read-only";
        another_is_writing = "another program is writing there";
        no_journal = "it cannot be replaced, and no state folder keeps its old text while it is written";
        disk_full = "the disk is full";
        file_too_large = "a file may not be so large";
        no_permission = "no permission";
        disk_read_only = "the disk is read-only";
        no_such_folder = "no such folder";
        add_a_name = "that is a folder: add a name";
        not_written(why: &str) = "not written: {why}";
        not_written_to(name: &str, why: &str) = "not written, {why}: {name}";
        not_written_without_start =
            "not written: no start positions tell this assembly from the others";

        // What is asked before one is written.
        write_over(name: &str) = "write over {name}?";
        write_over_changed(name: &str) = "{name} has changed on disk: write over it?";
        write_over_newer(name: &str) = "{name} is newer than these edits: write over it?";
        write_read_only(name: &str) = "{name} is read-only: write it?";

        // Writing.
        unchanged_since_saved = "nothing has changed since it was saved";
        still_writing = "another file is still being written";
        writing_to(name: &dyn Display) = "writing {name}";
        written_to(name: &dyn Display) = "written to {name}";
        all_written_to(what: &str, name: &dyn Display) = "{what} written to {name}";
        or_save_elsewhere(why: &str, key: &str) = "{why}; {key} saves elsewhere";
        broken_there = "krank is broken there";

        // Reading.
        reading(name: &str) = "reading {name}";
        cannot_be_read(why: &dyn Display) = "cannot be read: {why}";
        name_cannot_be_read(name: &str, why: &dyn Display) = "{name} cannot be read: {why}";
        is_folder(name: &dyn Display) = "{name} is a folder";
        no_presets = "there are no presets";
        no_preset(name: &str) = "there is no preset {name}";
        preset_cannot_be_opened(name: &str, why: &dyn Display) =
            "the preset {name} cannot be opened: {why}";

        // What others have done to the file.
        file_changed(name: &str, reload: &str, elsewhere: &str) =
            "{name} has changed on disk: {reload} reads it, {elsewhere} saves elsewhere";
        no_file_to_read = "this scene has no file to read again";
        file_is_gone(name: &str, key: &str) = "{name} is gone: {key} writes it again";
        was_read_again(name: &str) = "{name} was read again";
        is_broken_not_shown(name: &str, fault: &str) = "{name} is broken, not shown: {fault}";
    }
}
