//! The last line: what is going on, what is asked, and what keys do now.

use super::English;

catalogue! {
    /// Modes and prompts in a word or two, and what keys do in them.
    trait HintsWords for English {
        // What is going on.
        choosing = "choose";
        writing = "write";
        recovering = "recover";

        // What a key does now.
        again = "again";
        all = "all";
        all_keys = "all keys";
        along_x = "along x";
        cancel = "cancel";
        do_it = "do it";
        done = "done";
        drop_and_open = "drop, open";
        drop_and_quit = "drop, quit";
        end = "end";
        go = "go";
        go_on = "go on";
        keep = "keep";
        less = "less";
        look_inside = "look inside";
        manual = "manual";
        more = "more";
        next_topic = "next topic";
        none = "none";
        pause = "pause";
        plot = "plot";
        plot_it_or_not = "plot it or not";
        read = "read";
        row = "row";
        stay = "stay";
        stop = "stop";
        table = "table";
        take = "take";
        value = "value";

        // What is asked for.
        character_not_taken(c: char) = {
            format!("{c} (U+{:04X}) is not taken here", u32::from(c))
        };
        no_more_characters(most: usize) = "no more than {most} characters are taken here";
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
        in_no_file_yet = "this linkage is in no file yet";
        read_over_edits = "read it over unsaved edits?";
    }
}
