//! The status line: modes, prompts and key hints.

use super::English;

catalogue! {
    /// Short names of modes, prompts and keys.
    trait HintsWords for English {
        // Modes.
        choosing = "choose";
        writing = "write";
        recovering = "recover";

        // Key hints.
        again = "again";
        all = "all";
        all_keys = "all keys";
        along_x = "along x";
        cancel = "cancel";
        do_it = "run";
        done = "done";
        drop_and_open = "drop, open";
        drop_and_quit = "drop, quit";
        end = "end";
        go = "go";
        go_on = "resume";
        keep = "keep";
        less = "less";
        look_inside = "browse";
        manual = "manual";
        more = "more";
        next_topic = "next topic";
        none = "none";
        pause = "pause";
        plot = "plot";
        plot_it_or_not = "toggle plot";
        read = "load";
        row = "row";
        stay = "stay";
        stop = "stop";
        table = "table";
        take = "take";
        value = "value";

        // Prompts.
        character_not_taken(c: char) = {
            format!("{c} (U+{:04X}) is not valid here", u32::from(c))
        };
        no_more_characters(most: usize) = "at most {most} characters are allowed here";
        angle_in(unit: &str) = "angle [{unit}]: ";
        position_in(unit: &str) = "position [{unit}]: ";
        write_to = "write to: ";
        name = "name: ";
        value_in(name: &str, units: &str) = {
            match units {
                "" => name.to_owned(),
                units => format!("{name} [{units}]"),
            }
        };
        unsaved_edits = "unsaved edits";
        in_no_file_yet = "this linkage is not saved yet";
        read_over_edits = "reload over unsaved edits?";
    }
}
