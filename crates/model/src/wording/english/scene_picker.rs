//! The list of scenes, with a preview.

use super::{English, counted};
use std::fmt::Display;

catalogue! {
    /// The list of scenes to open.
    trait PickingWords for English {
        open_a_scene = "Open a scene";
        compare_with = "Compare with";
        search_for = "search: ";
        some_of(some: usize, all: usize) = "{some} of {all}";
        nothing_matches = "no match; Ctrl-U clears the search";
        presets = "presets";
        as_opened = "as opened";
        folder_being_read = "reading the folder";
        more_than_can_be_listed = "too many to list";
        no_scene_file_here = "no scene file here";
        no_scene_in_it = "no scene in it";
        a_folder = "a folder";

        // The preview.
        being_read = "reading";
        too_large_for_preview(kib: u64) = "{kib} KiB: too large for a preview";
        cannot_be_opened = "cannot be opened";
        line_and_column(line: usize, column: usize) = "line {line}, column {column}";
        more_below(count: usize) = "{count} more below it";
        no_scene_file_in_it = "no scene file in it";
        and_more(count: usize) = "and {count} more";
        count_of_links(count: usize) = { counted(count, "link", "links") };
        count_of_slides(count: usize) = { counted(count, "slide", "slides") };
        unit(symbol: &str) = "unit {symbol}";
        turns_fully(link: &str) = "{link} turns fully";
        turns_fully_and_repeats(link: &str, period: &dyn Display) =
            "{link} turns fully; the motion repeats after {period} deg";
        moves_between(name: &str, low: &str, high: &str, unit: &str) =
            "{name} from {low} to {high} {unit}";
    }
}
